// SPDX-License-Identifier: MIT
// The layer for ground that is much higher under one foot than under another: what each of its parts does, and what it
// leaves as it is. A step between the feet.
#include "placing.h"

/// Stands with its left foot higher.
static void start( testRun* run, float step )
{
	testStartRun( run, 0.6f );
	run->ground.stepX = step;
	run->settings.target.secondFrom = 0.05f;
	run->settings.target.secondFull = 0.2f;
}

static float findTilt( const testRun* run )
{
	soleQuat turn = soleMulQuat(
	    testPlacedJoint( run, biped_spine ).rotation, soleConjugate( testAnimatedJoint( run, biped_spine ).rotation ) );
	soleVec3 up = soleRotate( turn, soleVec( 0.0f, 1.0f, 0.0f ) );
	assert_float_equal( up.z, 0.0f, 0.02f );
	return up.x / up.y;
}

static void theTrunkLeansToTheHigherFootAndLegsAreAsEver( void** state )
{
	(void)state;
	static testRun runs[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		start( runs + k, 0.18f );
		runs[k].settings.layer.lean = k == 0 ? 0.0f : 0.2f;
		testStepSeconds( runs + k, 3.0f );
	}
	assert_float_equal( findTilt( runs + 0 ), 0.0f, 0.0f );
	// The demand is full at 0.18 m; feet 0.18 m apart stand on a slope of about 45 degrees.
	float slope = runs[1].out.bodyGradient_w.x;
	assert_float_equal( slope, 1.0f, 0.1f );
	assert_float_equal( findTilt( runs + 1 ), 0.2f * slope, 2e-3f );
	memcpy( runs[1].placed + biped_spine, runs[0].placed + biped_spine, sizeof runs[0].placed[0] );
	assert_memory_equal( runs[0].placed, runs[1].placed, sizeof runs[0].placed );
	testEndRun( runs + 0 );
	testEndRun( runs + 1 );
}

static void theLeanHasALimit( void** state )
{
	(void)state;
	static testRun run;
	start( &run, 0.3f );
	run.settings.layer.lean = 1.0f;
	testStepSeconds( &run, 3.0f );
	assert_float_equal( findTilt( &run ), 0.45f, 1e-3f );
	testEndRun( &run );
}

static void theHipsGoAwayFromTheHigherFootAsFarAsTheyMay( void** state )
{
	(void)state;
	static testRun run;
	start( &run, 0.18f );
	run.settings.layer.hips = 0.06f;
	testStepSeconds( &run, 3.0f );
	assert_float_equal( run.out.pelvisOffset_w.x, -0.06f * 0.9f * run.out.bodyGradient_w.x, 1e-3f );
	run.settings.pelvis.sideways = 0.02f;
	testStepSeconds( &run, 3.0f );
	assert_float_equal( run.out.pelvisOffset_w.x, -0.02f * 0.9f, 1e-3f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		assert_true( fabsf( testSoleClearance( &run, leg ) ) < 1e-3f );
	}
	testEndRun( &run );
}

static void allOfItComesAndGoesSmoothly( void** state )
{
	(void)state;
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		static testRun run;
		start( &run, 0.0f );
		run.settings.layer.lean = 0.3f;
		run.settings.layer.hips = 0.1f;
		run.frame.timeStep = 1.0f / rates[k];
		testStepSeconds( &run, 1.0f );
		float lean = findTilt( &run );
		float hips = run.out.pelvisOffset_w.x;
		float last = 0.0f;
		for ( int32_t i = 0; i < (int32_t)( 4.0f * rates[k] ); ++i )
		{
			run.ground.stepX = i < (int32_t)( 2.0f * rates[k] ) ? 0.2f : 0.0f;
			testStepRun( &run );
			// By the slope that is taken up, ln 2 / 0.12 s, and by the demand.
			assert_true( fabsf( findTilt( &run ) - lean ) < 3.2f / rates[k] );
			assert_true( fabsf( run.out.pelvisOffset_w.x - hips ) < 0.9f / rates[k] );
			lean = findTilt( &run );
			hips = run.out.pelvisOffset_w.x;
			last = i < (int32_t)( 2.0f * rates[k] ) ? lean : last;
		}
		assert_true( last > 0.2f && fabsf( lean ) < 0.01f );
		testEndRun( &run );
	}
}

static void withWeightZeroNothingLeans( void** state )
{
	(void)state;
	static testRun run;
	start( &run, 0.18f );
	run.settings.layer.lean = 0.3f;
	run.settings.layer.hips = 0.1f;
	testStepSeconds( &run, 2.0f );
	run.frame.weight = 0.0f;
	testStepSeconds( &run, 1.0f );
	assert_float_equal( findTilt( &run ), 0.0f, 1e-6f );
	assert_float_equal( run.out.pelvisOffset_w.x, 0.0f, 1e-6f );
	testEndRun( &run );
}

static void theTrunkIsThePelvissChildThatCarriesMost( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	assert_int_equal( soleRig_GetSpine( biped.rig ), biped_spine );
	soleDestroyRig( biped.rig );
	// Legs alone.
	int32_t parents[biped_count];
	memcpy( parents, biped.def.parents, sizeof parents );
	for ( int32_t i = 0; i < biped_count; ++i )
	{
		bool trunk = i == biped_spine || parents[i] == biped_spine;
		parents[i] = trunk ? SOLE_NONE : parents[i];
	}
	biped.def.parents = parents;
	assert_int_equal( soleCreateRig( &biped.def, NULL, &biped.rig, NULL ), sole_success );
	assert_int_equal( soleRig_GetSpine( biped.rig ), SOLE_NONE );
	soleDestroyRig( biped.rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theTrunkLeansToTheHigherFootAndLegsAreAsEver ),
		cmocka_unit_test( theLeanHasALimit ),
		cmocka_unit_test( theHipsGoAwayFromTheHigherFootAsFarAsTheyMay ),
		cmocka_unit_test( allOfItComesAndGoesSmoothly ),
		cmocka_unit_test( withWeightZeroNothingLeans ),
		cmocka_unit_test( theTrunkIsThePelvissChildThatCarriesMost ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
