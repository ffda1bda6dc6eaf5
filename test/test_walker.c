// SPDX-License-Identifier: MIT
// The walker: where a root goes over ground, how it steps, climbs and falls, whatever the frame rate.
#include "test.h"

#include "walker.h"

#include <math.h>

// A leg of 1 m: steps of 0.45 m are taken at once.
typedef struct testWalker
{
	toolNode nodes[3];
	int32_t parents[3];
	soleTransform bindPose[3];
	toolModel model;
	toolClip clip;
	toolChannel channel;
	float times[2];
	float values[8];
	toolCharacter character;
	toolBoundClip bound;
	toolTravel travel;
	soleGround* ground;
	toolWalkDef def;
	toolPlace path[4];
} testWalker;

static void testSetUp( testWalker* t, float speed )
{
	memset( t, 0, sizeof *t );
	for ( int i = 0; i < 3; ++i )
	{
		t->parents[i] = i - 1;
		t->bindPose[i] = soleTransform_Identity();
		t->bindPose[i].translation.y = i == 0 ? 1.0f : -0.5f;
		t->nodes[i] = ( toolNode ){ "node", i - 1, t->bindPose[i], false, SOLE_NONE, SOLE_NONE };
	}
	t->clip = ( toolClip ){ "clip", 0, &t->channel, 0.0f, 1.0f, NULL };
	t->model = ( toolModel ){ .nodeCount = 3, .nodes = t->nodes, .clipCount = 1, .clips = &t->clip };
	t->character = ( toolCharacter ){ .model = &t->model, .jointCount = 3, .parents = t->parents };
	t->character.bindPose = t->bindPose;
	t->character.rigDef.up = soleVec( 0.0f, 1.0f, 0.0f );
	t->character.rigDef.forward = soleVec( 0.0f, 0.0f, 1.0f );
	t->character.rigDef.legCount = 1;
	t->character.rigDef.legs[0].jointCount = 3;
	t->character.rigDef.legs[0].detachedFoot = SOLE_NONE;
	for ( int i = 0; i < 3; ++i )
	{
		t->character.rigDef.legs[0].joints[i] = i;
	}
	t->bound = ( toolBoundClip ){ .clip = &t->clip, .duration = 1.0f };
	t->travel = ( toolTravel ){ .loops = true, .source = SOLE_NONE, .loop = soleTransform_Identity() };
	t->travel.strideVelocity = soleVec( 0.0f, 0.0f, speed );
	t->def = toolDefaultWalkDef();
	t->def.character = &t->character;
	t->def.bound = &t->bound;
	t->def.travel = &t->travel;
	t->def.groundName = "G";
	t->def.path = t->path;
	t->def.pathCount = 1;
	t->path[0] = ( toolPlace ){ 0.0, (double)NAN, 0.0 };
}

// Quads between profile points z, y, wide along x; a step is two points with the same z.
static void testMakeProfile( testWalker* t, const float* profile, int32_t pointCount )
{
	float vertices[64 * 3];
	uint32_t indices[64 * 6];
	for ( int32_t i = 0; i < pointCount; ++i )
	{
		for ( int side = 0; side < 2; ++side )
		{
			float* v = vertices + 6 * i + 3 * side;
			v[0] = side == 0 ? -20.0f : 20.0f;
			v[1] = profile[2 * i + 1];
			v[2] = profile[2 * i];
		}
	}
	int32_t triangles = 0;
	for ( int32_t i = 0; i + 1 < pointCount; ++i )
	{
		uint32_t a = (uint32_t)( 2 * i );
		uint32_t quad[6] = { a, a + 2, a + 1, a + 1, a + 2, a + 3 };
		memcpy( indices + 3 * triangles, quad, sizeof quad );
		triangles += 2;
	}
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = vertices;
	mesh.vertexCount = 2 * pointCount;
	mesh.indices = indices;
	mesh.triangleCount = triangles;
	mesh.twoSided = true;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	soleMessage message;
	assert_int_equal( soleCreateGround( &def, NULL, &t->ground, &message ), sole_success );
	t->def.ground = t->ground;
}

static toolWalk testWalk( const testWalker* t )
{
	toolWalk walk;
	toolError error;
	if ( toolMakeWalk( &t->def, &walk, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return walk;
}

static void testSpeedTimesTimeIsTheWay( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 20, 0 };
	testWalker t;
	testSetUp( &t, 1.5f );
	testMakeProfile( &t, flat, 2 );
	t.def.distance = 3.0;
	toolWalk walk = testWalk( &t );
	assert_int_equal( walk.frameCount, 121 );
	testNear3( walk.roots[0].translation, soleVec( 0, 0, 0 ), 1e-6f );
	testNear3( walk.roots[60].translation, soleVec( 0, 0, 1.5f ), 1e-5f );
	testNear3( walk.roots[120].translation, soleVec( 0, 0, 3.0f ), 1e-5f );
	assert_float_equal( walk.clipTimes[120], 2.0, 1e-6 );
	toolFreeWalk( &walk );
	t.def.heading = 90.0;
	t.def.speed = 3.0;
	walk = testWalk( &t );
	assert_float_equal( walk.rate, 2.0, 1e-6 );
	assert_int_equal( walk.frameCount, 61 );
	testNear3( walk.roots[60].translation, soleVec( 3.0f, 0, 0 ), 1e-5f );
	testNear3( soleRotate( walk.roots[60].rotation, soleVec( 0, 0, 1 ) ), soleVec( 1, 0, 0 ), 1e-5f );
	assert_float_equal( walk.clipTimes[60], 2.0, 1e-6 );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testAStandingClipStandsForItsLength( void** state )
{
	(void)state;
	const float flat[] = { -5, 0.5f, 20, 0.5f };
	testWalker t;
	testSetUp( &t, 0.05f );
	testMakeProfile( &t, flat, 2 );
	t.def.distance = 3.0;
	toolWalk walk = testWalk( &t );
	assert_int_equal( walk.frameCount, 61 );
	testNear3( walk.roots[60].translation, soleVec( 0, 0.5f, 0 ), 1e-6f );
	toolFreeWalk( &walk );
	t.def.duration = 2.5;
	walk = testWalk( &t );
	assert_int_equal( walk.frameCount, 151 );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testStepsAreTakenAtOnceUpAndDown( void** state )
{
	(void)state;
	const float steps[] = { -5, 0, 1, 0, 1, 0.4f, 2, 0.4f, 2, 0, 9, 0 };
	testWalker t;
	testSetUp( &t, 1.0f );
	testMakeProfile( &t, steps, 6 );
	t.def.distance = 4.0;
	toolWalk walk = testWalk( &t );
	for ( int32_t i = 0; i < walk.frameCount; ++i )
	{
		soleVec3 p = walk.roots[i].translation;
		if ( fabsf( p.z - 1.0f ) > 1e-3f && fabsf( p.z - 2.0f ) > 1e-3f )
		{
			assert_float_equal( p.y, p.z > 1.0f && p.z < 2.0f ? 0.4f : 0.0f, 1e-5f );
		}
	}
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testSlopesAreFollowedWithoutLag( void** state )
{
	(void)state;
	const float slope[] = { -5, 0, 1, 0, 3, 1, 5, 0, 9, 0 };
	testWalker t;
	testSetUp( &t, 2.0f );
	testMakeProfile( &t, slope, 5 );
	t.def.distance = 6.0;
	toolWalk walk = testWalk( &t );
	for ( int32_t i = 0; i < walk.frameCount; ++i )
	{
		soleVec3 p = walk.roots[i].translation;
		float wanted = p.z < 1.0f ? 0.0f : ( p.z < 3.0f ? 0.5f * ( p.z - 1.0f ) : 0.5f * ( 5.0f - p.z ) );
		assert_float_equal( p.y, wanted > 0.0f ? wanted : 0.0f, 1e-4f );
	}
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testBelowALedgeGravityActs( void** state )
{
	(void)state;
	const float ledge[] = { -5, 0, 1, 0, 1, -3, 9, -3 };
	testWalker t;
	testSetUp( &t, 1.0f );
	testMakeProfile( &t, ledge, 4 );
	t.def.distance = 3.0;
	toolWalk walk = testWalk( &t );
	// The fall begins within a tick after 1 s; 3 m take 0.782 s.
	float seen = walk.roots[90].translation.y;
	assert_float_equal( seen, -1.226f, 0.02f );
	assert_true( walk.roots[60 + 46].translation.y > -3.0f );
	assert_float_equal( walk.roots[60 + 49].translation.y, -3.0f, 1e-5f );
	assert_float_equal( walk.roots[170].translation.y, -3.0f, 1e-5f );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testAPathOffTheGroundIsRefusedWithThePlace( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 2, 0 };
	testWalker t;
	testSetUp( &t, 1.0f );
	testMakeProfile( &t, flat, 2 );
	t.def.distance = 4.0;
	toolWalk walk;
	toolError error = { { 0 } };
	assert_false( toolMakeWalk( &t.def, &walk, &error ) );
	assert_non_null( strstr( error.text, "G: no ground at x=0.000, z=2.00" ) );
	t.path[0].z = 7.0;
	assert_false( toolMakeWalk( &t.def, &walk, &error ) );
	assert_non_null( strstr( error.text, "G: no ground at x=0.000, z=7.000" ) );
	soleDestroyGround( t.ground );
}

static void testAStartTakesTheHighestOrTheNearestBelow( void** state )
{
	(void)state;
	// Down, under itself and back: two floors at z = 0.
	const float floors[] = { -5, 0, 5, 0, 6, 1.5f, 5, 3, -5, 3 };
	testWalker t;
	testSetUp( &t, 0.0f );
	testMakeProfile( &t, floors, 5 );
	toolWalk walk = testWalk( &t );
	assert_float_equal( walk.roots[0].translation.y, 3.0f, 1e-5f );
	toolFreeWalk( &walk );
	t.path[0].y = 2.0;
	walk = testWalk( &t );
	assert_float_equal( walk.roots[0].translation.y, 0.0f, 1e-5f );
	toolFreeWalk( &walk );
	t.path[0].y = 3.0;
	walk = testWalk( &t );
	assert_float_equal( walk.roots[0].translation.y, 3.0f, 1e-5f );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testTheRootDoesNotDependOnTheFrameRate( void** state )
{
	(void)state;
	const float course[] = { -5, 0, 1, 0, 1, 0.3f, 2, 0.3f, 3, 1, 3, -1, 4, -1, 5, -0.2f, 20, -0.2f };
	const double rates[3] = { 30.0, 60.0, 144.0 };
	testWalker t;
	testSetUp( &t, 1.3f );
	testMakeProfile( &t, course, 9 );
	t.path[1] = ( toolPlace ){ 0.0, (double)NAN, 2.5 };
	t.path[2] = ( toolPlace ){ 1.5, (double)NAN, 4.0 };
	t.path[3] = ( toolPlace ){ 1.5, (double)NAN, 6.0 };
	t.def.pathCount = 4;
	toolWalk walks[3];
	for ( int i = 0; i < 3; ++i )
	{
		t.def.fps = rates[i];
		walks[i] = testWalk( &t );
	}
	for ( int32_t i = 0; i * 5 < walks[0].frameCount; ++i )
	{
		// Every 1/6 s is a frame of all three.
		soleTransform a = walks[0].roots[i * 5];
		soleTransform b = walks[1].roots[i * 10];
		soleTransform c = walks[2].roots[i * 24];
		testNear3( a.translation, b.translation, 1e-5f );
		testNear3( c.translation, b.translation, 1e-5f );
		assert_float_equal( fabsf( soleDotQuat( a.rotation, b.rotation ) ), 1.0f, 1e-6f );
		assert_float_equal( fabsf( soleDotQuat( c.rotation, b.rotation ) ), 1.0f, 1e-6f );
	}
	for ( int i = 0; i < 3; ++i )
	{
		toolFreeWalk( walks + i );
	}
	soleDestroyGround( t.ground );
}

static void testACornerIsTurnedAtALimitedRate( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 20, 0 };
	testWalker t;
	testSetUp( &t, 1.0f );
	testMakeProfile( &t, flat, 2 );
	t.path[1] = ( toolPlace ){ 0.0, (double)NAN, 1.0 };
	t.path[2] = ( toolPlace ){ 2.0, (double)NAN, 1.0 };
	t.def.pathCount = 3;
	toolWalk walk = testWalk( &t );
	for ( int32_t i = 1; i < walk.frameCount; ++i )
	{
		float dot = fabsf( soleDotQuat( walk.roots[i - 1].rotation, walk.roots[i].rotation ) );
		// 3 degrees a frame at 60 Hz.
		assert_true( 2.0 * acos( fmin( (double)dot, 1.0 ) ) < 0.0525 );
	}
	testNear3( walk.roots[walk.frameCount - 1].translation, soleVec( 2, 0, 1 ), 1e-4f );
	soleVec3 ahead = soleRotate( walk.roots[walk.frameCount - 1].rotation, soleVec( 0, 0, 1 ) );
	testNear3( ahead, soleVec( 1, 0, 0 ), 1e-4f );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testAStrideBackwardsFacesBackwards( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 20, 0 };
	testWalker t;
	testSetUp( &t, -1.0f );
	testMakeProfile( &t, flat, 2 );
	t.def.distance = 2.0;
	toolWalk walk = testWalk( &t );
	testNear3( walk.roots[60].translation, soleVec( 0, 0, 1 ), 1e-5f );
	testNear3( soleRotate( walk.roots[60].rotation, soleVec( 0, 0, 1 ) ), soleVec( 0, 0, -1 ), 1e-5f );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testRootMotionMovesByItsOwnRoot( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 20, 0 };
	testWalker t;
	testSetUp( &t, 0.0f );
	testMakeProfile( &t, flat, 2 );
	t.times[1] = 1.0f;
	memcpy( t.values, ( float[6] ){ 0, 1, 0, 0, 1, 2 }, 6 * sizeof( float ) );
	t.channel = ( toolChannel ){ 0, tool_pathTranslation, tool_linear, 2, t.times, t.values };
	t.clip.channelCount = 1;
	int32_t node = 0;
	t.bound.nodes = &node;
	t.travel.rootMotion = true;
	t.travel.kind = tool_travelSteady;
	t.travel.source = 0;
	t.travel.strideVelocity = soleVec( 0, 0, 2 );
	t.travel.loop.translation = soleVec( 0, 0, 2 );
	t.def.distance = 3.0;
	t.def.heading = 90.0;
	toolWalk walk = testWalk( &t );
	assert_int_equal( walk.frameCount, 91 );
	testNear3( walk.roots[30].translation, soleVec( 1, 0, 0 ), 1e-5f );
	testNear3( walk.roots[90].translation, soleVec( 3, 0, 0 ), 1e-5f );
	toolFreeWalk( &walk );
	soleDestroyGround( t.ground );
}

static void testEndlessWalksAreRefused( void** state )
{
	(void)state;
	const float flat[] = { -5, 0, 20, 0 };
	testWalker t;
	testSetUp( &t, 0.2f );
	testMakeProfile( &t, flat, 2 );
	toolWalk walk;
	toolError error;
	t.def.distance = 1e6;
	assert_false( toolMakeWalk( &t.def, &walk, &error ) );
	assert_non_null( strstr( error.text, "hour" ) );
	t.def.fps = 0.0;
	assert_false( toolMakeWalk( &t.def, &walk, &error ) );
	t.def.fps = 60.0;
	t.def.pathCount = 0;
	assert_false( toolMakeWalk( &t.def, &walk, &error ) );
	soleDestroyGround( t.ground );
}

static void testSeamsOfALoopThatIsNotClosedAreKnown( void** state )
{
	(void)state;
	toolBoundClip bound = { .duration = 1.0f };
	toolTravel open = { .loops = true };
	toolTravel closed = { .loops = true, .closed = true };
	toolTravel once = { .loops = false };
	assert_false( toolCrossesSeam( &bound, &open, 0.95, 0.99 ) );
	assert_true( toolCrossesSeam( &bound, &open, 0.99, 1.0 ) );
	assert_false( toolCrossesSeam( &bound, &open, 1.0, 1.01 ) );
	assert_true( toolCrossesSeam( &bound, &open, 2.99, 3.01 ) );
	assert_false( toolCrossesSeam( &bound, &closed, 2.99, 3.01 ) );
	// The end of a clip that does not loop is its own.
	assert_false( toolCrossesSeam( &bound, &once, 0.99, 1.0 ) );
	assert_true( toolCrossesSeam( &bound, &once, 1.0, 1.01 ) );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testSpeedTimesTimeIsTheWay ),
		cmocka_unit_test( testAStandingClipStandsForItsLength ),
		cmocka_unit_test( testStepsAreTakenAtOnceUpAndDown ),
		cmocka_unit_test( testSlopesAreFollowedWithoutLag ),
		cmocka_unit_test( testBelowALedgeGravityActs ),
		cmocka_unit_test( testAPathOffTheGroundIsRefusedWithThePlace ),
		cmocka_unit_test( testAStartTakesTheHighestOrTheNearestBelow ),
		cmocka_unit_test( testTheRootDoesNotDependOnTheFrameRate ),
		cmocka_unit_test( testACornerIsTurnedAtALimitedRate ),
		cmocka_unit_test( testAStrideBackwardsFacesBackwards ),
		cmocka_unit_test( testRootMotionMovesByItsOwnRoot ),
		cmocka_unit_test( testEndlessWalksAreRefused ),
		cmocka_unit_test( testSeamsOfALoopThatIsNotClosedAreKnown ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
