// SPDX-License-Identifier: MIT
// Nothing that a host calls in every frame asks for memory or gives any back: every call of the C library's memory
// functions is counted. The linker puts these counters in their place.
#include "trace_run.h"

#include "ground_support.h"
#include "leg_batch.h"

#include "sole/crowd.h"
#include "sole/limb.h"

void* __real_malloc( size_t byteCount );
void* __real_calloc( size_t count, size_t size );
void* __real_realloc( void* memory, size_t byteCount );
void __real_free( void* memory );
void* __wrap_malloc( size_t byteCount );
void* __wrap_calloc( size_t count, size_t size );
void* __wrap_realloc( void* memory, size_t byteCount );
void __wrap_free( void* memory );

static int32_t s_calls;

void* __wrap_malloc( size_t byteCount )
{
	s_calls += 1;
	return __real_malloc( byteCount );
}

void* __wrap_calloc( size_t count, size_t size )
{
	s_calls += 1;
	return __real_calloc( count, size );
}

void* __wrap_realloc( void* memory, size_t byteCount )
{
	s_calls += 1;
	return __real_realloc( memory, byteCount );
}

void __wrap_free( void* memory )
{
	s_calls += 1;
	__real_free( memory );
}

static void theCountersCount( void** state )
{
	(void)state;
	int32_t before = s_calls;
	testBiped biped;
	testMakeBiped( &biped );
	soleDestroyRig( biped.rig );
	assert_true( s_calls >= before + 2 );
}

static void oneCharacterAsksForNone( void** state )
{
	(void)state;
	static testTraced traced;
	testStartTraced( &traced, NULL, TRACE_BYTES );
	int32_t before = s_calls;
	for ( int32_t i = 0; i < TRACE_FRAMES; ++i )
	{
		testChangeFrame( &traced, i );
		testRecordFrame( &traced ); // gathers and solves, and records a trace of it
		testPlace( &traced.run );
	}
	assert_true( soleTracer_Finish( traced.tracer ) );
	soleState_Reset( &traced.run.state );
	assert_int_equal( s_calls, before );
	testEndTraced( &traced );
}

#define CROWD 8

static void aCrowdAsksForNone( void** state )
{
	(void)state;
	static testRun run;
	static soleFrame frames[CROWD];
	static soleCrowdAsk asks[CROWD];
	static soleProbe probes[CROWD * SOLE_MAX_PROBES];
	static soleHit hits[CROWD * SOLE_MAX_PROBES];
	testStartRun( &run, 0.3f );
	soleCrowdDef def = soleDefaultCrowdDef();
	def.rig = run.biped.rig;
	def.capacity = CROWD;
	soleCrowd* crowd = NULL;
	assert_int_equal( soleCreateCrowd( &def, NULL, &crowd, NULL ), sole_success );
	void* saved = malloc( soleCrowd_GetByteCount( crowd ) );
	void* work = malloc( soleCrowd_GetWorkSize( crowd, CROWD ) );
	soleCrowdId last = SOLE_NO_CHARACTER;
	int32_t before = s_calls;
	for ( int32_t k = 0; k < CROWD; ++k )
	{
		last = soleAddToCrowd( crowd );
		frames[k] = run.frame;
		soleCrowd_GetMember( crowd, k )->interval = 1 + k % 3;
		soleCrowd_GetMember( crowd, k )->detail = (soleDetail)( k % 3 );
	}
	for ( int32_t i = 0; i < 30; ++i )
	{
		int32_t count = soleCrowd_GetCount( crowd );
		int32_t asked = soleGatherCrowd( crowd, 0, count, frames, probes, CROWD * SOLE_MAX_PROBES, asks, work );
		for ( int32_t k = 0; k < asked; ++k )
		{
			testCastAt( &run.ground, probes + k, hits + k );
		}
		soleSolveCrowd( crowd, 0, count, frames, probes, hits, asks, work );
		soleRemoveFromCrowd( crowd, last );
		last = soleAddToCrowd( crowd );
	}
	soleSaveCrowd( crowd, saved );
	assert_true( soleRestoreCrowd( crowd, saved, soleCrowd_GetByteCount( crowd ) ) );
	assert_int_equal( s_calls, before );
	free( work );
	free( saved );
	soleDestroyCrowd( crowd );
	testEndRun( &run );
}

static void castsAndRefitsAskForNone( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 3, 40, 0.25f, 0.4f );
	soleGroundMesh groundMesh = testGroundMesh( &mesh );
	soleGround* ground = testMakeGround( &groundMesh, 1 );
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &groundMesh;
	def.meshCount = 1;
	soleGroundPiece piece = { .ground = ground, .transform = soleTransform_Identity(), .surface = SOLE_NONE };
	int32_t before = s_calls;
	uint32_t seed = 5;
	int32_t met = 0;
	for ( int32_t i = 0; i < 200; ++i )
	{
		soleProbe probes[9];
		soleHit hits[9];
		for ( int32_t k = 0; k < 9; ++k )
		{
			soleVec3 start = testRandomPoint( &seed, 5.0f );
			soleVec3 direction = k < 5 ? soleVec( 0.0f, -1.0f, 0.0f ) : testRandomDirection( &seed );
			start = soleVec( start.x + 5.0f, 2.0f, start.z + 5.0f );
			probes[k] = testProbe( start, direction, 4.0f, k % 2 == 0 ? 0.0f : 0.2f );
		}
		soleCastProbes( ground, probes, 9, hits );
		met += hits[0].hit ? 1 : 0;
		met += soleCastProbe( ground, probes ).hit ? 1 : 0;
		met += soleCastPieces( &piece, 1, probes ).hit ? 1 : 0;
	}
	mesh.vertices[1] += 0.1f;
	assert_int_equal( soleRefitGround( ground, &def, NULL ), sole_success );
	assert_int_equal( s_calls, before );
	assert_true( met > 400 );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void legsAndLimbsAskForNone( void** state )
{
	(void)state;
	static testBatch batch;
	static testBiped biped;
	testMakeBiped( &biped );
	soleLimbDef limb = soleDefaultLimbDef();
	limb.parents = biped.parents;
	limb.jointCount = biped_count;
	limb.upper = biped_hipL;
	limb.lower = biped_kneeL;
	limb.end = biped_ankleL;
	soleLookDef look = soleDefaultLookDef();
	look.parents = biped.parents;
	look.jointCount = biped_count;
	look.joints[0] = biped_pelvis;
	look.joints[1] = biped_spine;
	look.lookCount = 2;
	int32_t before = s_calls;
	testBeginBatch( &batch );
	testFillLegs( &batch, 3 );
	soleSolveLegBatch( &batch.batch, 0, BATCH_COUNT );
	soleLimbGoal goal = { soleVec( 0.1f, 0.3f, 0.2f ), soleQuat_Identity(), 1.0f, 1.0f };
	soleLimbResult reached = soleSolveLimb( &limb, biped.bindPose, &goal, NULL );
	soleApplyLimb( &limb, &reached, biped.bindPose );
	soleLookResult seen = soleSolveLookAt( &look, biped.bindPose, soleVec( 1.0f, 1.0f, 3.0f ), 1.0f );
	soleApplyLook( &look, &seen, biped.bindPose );
	assert_int_equal( s_calls, before );
	soleDestroyRig( biped.rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theCountersCount ),
		cmocka_unit_test( oneCharacterAsksForNone ),
		cmocka_unit_test( aCrowdAsksForNone ),
		cmocka_unit_test( castsAndRefitsAskForNone ),
		cmocka_unit_test( legsAndLimbsAskForNone ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
