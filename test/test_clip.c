// SPDX-License-Identifier: MIT
// Clips: binding by name, sampling against values worked out by hand, root motion taken out and put back.
#include "test.h"

#include "gltf.h"
#include "motion.h"

#include <math.h>

// ------------------------------------------------------------------------------------------ a clip made by hand

// Nodes: 0 root, 1 a child of it. The clip's first key is at 0.5 s.
static toolNode testNodes[2] = {
	{ "root", SOLE_NONE, { { 0, 0, 0 }, { 0, 0, 0, 1 }, { 1, 1, 1 } }, false, SOLE_NONE, SOLE_NONE },
	{ "bone", 0, { { 0, 5, 0 }, { 0, 0, 0, 1 }, { 1, 1, 1 } }, false, SOLE_NONE, SOLE_NONE },
};

typedef struct testClip
{
	toolModel model;
	toolClip clip;
	toolChannel channel;
	float times[4];
	float values[48];
	int32_t parents[2];
	toolCharacter character;
	toolBoundClip bound;
} testClip;

static void testBind( testClip* t, int32_t node, toolPath path, toolInterpolation interpolation, int32_t keyCount )
{
	t->channel = ( toolChannel ){ node, path, interpolation, keyCount, t->times, t->values };
	t->clip = ( toolClip ){ "clip", 1, &t->channel, t->times[0], t->times[keyCount - 1], NULL };
	t->model = ( toolModel ){ .nodeCount = 2, .nodes = testNodes, .clipCount = 1, .clips = &t->clip };
	t->parents[0] = SOLE_NONE;
	t->parents[1] = 0;
	t->character = ( toolCharacter ){ .model = &t->model, .jointCount = 2, .parents = t->parents };
	toolError error;
	assert_true( toolBindClip( &t->character, &t->model, 0, &t->bound, &error ) );
}

static soleVec3 testTranslationAt( testClip* t, float time )
{
	soleTransform pose[2];
	toolSampleClip( &t->character, &t->bound, time, pose );
	return pose[1].translation;
}

static soleQuat testRotationAt( testClip* t, float time )
{
	soleTransform pose[2];
	toolSampleClip( &t->character, &t->bound, time, pose );
	return pose[1].rotation;
}

static void testLinearIsOnTheLineBetweenKeys( void** state )
{
	(void)state;
	testClip t = { .times = { 0.5f, 1.5f, 2.0f }, .values = { 0, 0, 0, 2, 4, 6, 2, 4, 8 } };
	testBind( &t, 1, tool_pathTranslation, tool_linear, 3 );
	assert_float_equal( t.bound.duration, 1.5f, 1e-6f );
	testNear3( testTranslationAt( &t, 0.25f ), soleVec( 0.5f, 1.0f, 1.5f ), 1e-6f );
	testNear3( testTranslationAt( &t, 1.0f ), soleVec( 2.0f, 4.0f, 6.0f ), 1e-6f );
	testNear3( testTranslationAt( &t, 1.25f ), soleVec( 2.0f, 4.0f, 7.0f ), 1e-6f );
	toolFreeBoundClip( &t.bound );
}

static void testTimeZeroIsTheFirstKeyAndEndsHold( void** state )
{
	(void)state;
	testClip t = { .times = { 0.5f, 1.5f }, .values = { 1, 2, 3, 2, 4, 6 } };
	testBind( &t, 1, tool_pathTranslation, tool_linear, 2 );
	testNear3( testTranslationAt( &t, 0.0f ), soleVec( 1.0f, 2.0f, 3.0f ), 0.0f );
	testNear3( testTranslationAt( &t, -3.0f ), soleVec( 1.0f, 2.0f, 3.0f ), 0.0f );
	testNear3( testTranslationAt( &t, 1.0f ), soleVec( 2.0f, 4.0f, 6.0f ), 0.0f );
	testNear3( testTranslationAt( &t, 9.0f ), soleVec( 2.0f, 4.0f, 6.0f ), 0.0f );
	toolFreeBoundClip( &t.bound );
}

static void testAChannelThatStartsLateHoldsItsFirstKey( void** state )
{
	(void)state;
	testClip t = { .times = { 0.5f, 1.5f }, .values = { 1, 2, 3, 2, 4, 6 } };
	testBind( &t, 1, tool_pathTranslation, tool_linear, 2 );
	t.clip.start = 0.0f; // as if another channel began there
	testNear3( testTranslationAt( &t, 0.25f ), soleVec( 1.0f, 2.0f, 3.0f ), 0.0f );
	testNear3( testTranslationAt( &t, 1.0f ), soleVec( 1.5f, 3.0f, 4.5f ), 1e-6f );
	toolFreeBoundClip( &t.bound );
}

static void testStepHoldsUntilTheNextKey( void** state )
{
	(void)state;
	testClip t = { .times = { 0.0f, 1.0f }, .values = { 1, 2, 3, 2, 4, 6 } };
	testBind( &t, 1, tool_pathTranslation, tool_step, 2 );
	testNear3( testTranslationAt( &t, 0.999f ), soleVec( 1.0f, 2.0f, 3.0f ), 0.0f );
	testNear3( testTranslationAt( &t, 1.0f ), soleVec( 2.0f, 4.0f, 6.0f ), 0.0f );
	toolFreeBoundClip( &t.bound );
}

static void testCubicFollowsTheHermiteSpline( void** state )
{
	(void)state;
	// Over 2 s from 0 to 1, leaving at 1 a second and arriving at -0.5 a second. At half way
	// 0.5 * 0 + 0.125 * 2 * 1 + 0.5 * 1 - 0.125 * 2 * -0.5 = 0.875.
	testClip t = { .times = { 0.0f, 2.0f },
		.values = { 9, 9, 9, 0, 0, 0, 1, 1, 1, -0.5f, -0.5f, -0.5f, 1, 1, 1, 9, 9, 9 } };
	testBind( &t, 1, tool_pathTranslation, tool_cubic, 2 );
	testNear3( testTranslationAt( &t, 1.0f ), soleVec( 0.875f, 0.875f, 0.875f ), 1e-6f );
	testNear3( testTranslationAt( &t, 0.0f ), soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	testNear3( testTranslationAt( &t, 2.0f ), soleVec( 1.0f, 1.0f, 1.0f ), 0.0f );
	toolFreeBoundClip( &t.bound );
}

static void testRotationsTakeTheNearSideAtConstantSpeed( void** state )
{
	(void)state;
	// From 0 to 120 degrees about y, the second key with its sign turned round: 30 degrees after a quarter.
	testClip t = { .times = { 0.0f, 1.0f }, .values = { 0, 0, 0, 1, 0, -0.8660254f, 0, -0.5f } };
	testBind( &t, 1, tool_pathRotation, tool_linear, 2 );
	soleQuat q = testRotationAt( &t, 0.25f );
	assert_float_equal( fabsf( q.y ), 0.2588190f, 1e-5f );
	assert_float_equal( fabsf( q.w ), 0.9659258f, 1e-5f );
	assert_true( q.y * q.w > 0.0f );
	toolFreeBoundClip( &t.bound );
}

static void testCubicRotationsAreNormalised( void** state )
{
	(void)state;
	testClip t = { .times = { 0.0f, 1.0f },
		.values = { 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0 } };
	testBind( &t, 1, tool_pathRotation, tool_cubic, 2 );
	soleQuat q = testRotationAt( &t, 0.5f );
	assert_float_equal( soleDotQuat( q, q ), 1.0f, 1e-6f );
	assert_float_equal( q.y, 0.7071068f, 1e-6f );
	toolFreeBoundClip( &t.bound );
}

static void testNodesOutsideTheClipRestAndScaleReachesRoots( void** state )
{
	(void)state;
	testClip t = { .times = { 0.0f, 1.0f }, .values = { 1, 0, 0, 3, 0, 0 } };
	testBind( &t, 0, tool_pathTranslation, tool_linear, 2 );
	t.character.scale = 2.0f;
	soleTransform pose[2];
	toolSampleClip( &t.character, &t.bound, 0.5f, pose );
	testNear3( pose[0].translation, soleVec( 4.0f, 0.0f, 0.0f ), 1e-6f );
	testNear3( pose[0].scale, soleVec( 2.0f, 2.0f, 2.0f ), 0.0f );
	testNear3( pose[1].translation, soleVec( 0.0f, 5.0f, 0.0f ), 0.0f );
	testNear3( toolPoseWorld( &t.character, pose, 1 ).translation, soleVec( 4.0f, 10.0f, 0.0f ), 1e-5f );
	soleTransform node = toolSampleNode( &t.character, &t.bound, 0.5f, 1 );
	testNear3( node.translation, soleVec( 4.0f, 10.0f, 0.0f ), 1e-5f );
	toolFreeBoundClip( &t.bound );
}

static void testAMovedNodeMovesInCharacterSpace( void** state )
{
	(void)state;
	testClip t = { .times = { 0.0f, 1.0f }, .values = { 1, 0, 0, 3, 0, 0 } };
	testBind( &t, 0, tool_pathTranslation, tool_linear, 2 );
	soleTransform pose[2];
	toolSampleClip( &t.character, &t.bound, 0.0f, pose );
	pose[0].rotation = ( soleQuat ){ 0.5f, 0.5f, 0.5f, 0.5f };
	pose[0].scale = soleVec( 0.01f, 0.01f, 0.01f );
	soleTransform before = toolPoseWorld( &t.character, pose, 1 );
	soleTransform motion = { { 1, 2, 3 }, { 0, 0.6f, 0, 0.8f }, { 1, 1, 1 } };
	toolMovePose( &t.character, pose, 1, motion );
	soleTransform after = toolPoseWorld( &t.character, pose, 1 );
	testNear3( after.translation, soleTransformPoint( motion, before.translation ), 1e-5f );
	soleQuat wanted = soleMulQuat( motion.rotation, before.rotation );
	assert_float_equal( fabsf( soleDotQuat( wanted, after.rotation ) ), 1.0f, 1e-5f );
	toolFreeBoundClip( &t.bound );
}

// -------------------------------------------------------------------------------------------------------- binding

// Binds a clip of one node to a character of one node, a leg joint.
static bool testBindNames( const char* bone, const char* clipBone, toolError* error )
{
	toolNode nodes[3] = { testNodes[0], testNodes[1], testNodes[1] };
	toolNode clipNodes[3] = { testNodes[0], testNodes[1], testNodes[1] };
	char names[6][64];
	const char* stems[3] = { "Hips", "LeftLeg", NULL };
	for ( int i = 0; i < 3; ++i )
	{
		snprintf( names[i], 64, bone, i < 2 ? stems[i] : "Thigh" );
		snprintf( names[3 + i], 64, clipBone, i < 2 ? stems[i] : "Thigh" );
		nodes[i].name = names[i];
		clipNodes[i].name = names[3 + i];
	}
	float times[1] = { 0.0f };
	float values[3] = { 1, 2, 3 };
	toolChannel channel = { 1, tool_pathTranslation, tool_linear, 1, times, values };
	toolClip clip = { "clip", 1, &channel, 0.0f, 0.0f, NULL };
	toolModel model = { .nodeCount = 3, .nodes = nodes };
	toolModel clipModel = { .nodeCount = 3, .nodes = clipNodes, .clipCount = 1, .clips = &clip };
	int32_t parents[3] = { SOLE_NONE, 0, 1 };
	toolCharacter character = { .model = &model, .jointCount = 3, .parents = parents };
	character.rigDef.legCount = 1;
	character.rigDef.legs[0].jointCount = 1;
	character.rigDef.legs[0].joints[0] = 1;
	toolBoundClip bound;
	bool good = toolBindClip( &character, &clipModel, 0, &bound, error );
	good = good && bound.boundCount == 1 && bound.nodes[0] == 1;
	toolFreeBoundClip( &bound );
	return good;
}

static void testNamesBindExactlyElseByCaseElseWithoutPrefix( void** state )
{
	(void)state;
	toolError error;
	assert_true( testBindNames( "%s", "%s", &error ) );
	assert_true( testBindNames( "%s.x", "%s.X", &error ) );
	assert_true( testBindNames( "%s", "mixamorig:%s", &error ) );
	assert_true( testBindNames( "Avatar_%s", "mixamorig:%s", &error ) );
	assert_true( testBindNames( "Avatar_%s", "%s", &error ) );
	assert_false( testBindNames( "%s", "%s_other", &error ) );
	assert_non_null( strstr( error.text, "0 of its 1 channels" ) );
}

static void testAClipOfMoreThanAnHourIsRefused( void** state )
{
	(void)state;
	testClip t = { .times = { 0.0f, 4000.0f } };
	t.channel = ( toolChannel ){ 1, tool_pathTranslation, tool_linear, 2, t.times, t.values };
	t.clip = ( toolClip ){ "clip", 1, &t.channel, 0.0f, 4000.0f, NULL };
	t.model = ( toolModel ){ .nodeCount = 2, .nodes = testNodes, .clipCount = 1, .clips = &t.clip };
	t.character = ( toolCharacter ){ .model = &t.model, .jointCount = 2, .parents = t.parents };
	toolError error;
	assert_false( toolBindClip( &t.character, &t.model, 0, &t.bound, &error ) );
	assert_non_null( strstr( error.text, "hour" ) );
	assert_false( toolBindClip( &t.character, &t.model, 7, &t.bound, &error ) );
}

// ---------------------------------------------------------------------------------------------------- root motion

typedef struct testTake
{
	toolGltf* gltf;
	toolCharacter character;
	toolBoundClip bound;
	toolTravel travel;
} testTake;

static void testOpen( const char* file, const char* clip, testTake* take )
{
	toolError error = { { 0 } };
	if ( toolReadGltf( testData( file ), &take->gltf, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	const toolModel* model = toolGltf_GetModel( take->gltf );
	if ( toolMakeCharacter( model, file, 1.0f, &take->character, &error ) == false ||
	    toolBindClip( &take->character, model, clip != NULL ? toolFindClip( model, clip ) : 0, &take->bound, &error ) ==
	        false )
	{
		fail_msg( "%s", error.text );
	}
	take->travel = toolFindTravel( &take->character, &take->bound );
}

static void testClose( testTake* take )
{
	toolFreeBoundClip( &take->bound );
	toolFreeCharacter( &take->character );
	toolFreeGltf( take->gltf );
}

// root * in-place pose is the clip's own pose for every joint of the legs, and the root begins at identity.
static void testCheckRootTimesPose( const testTake* take, float tolerance )
{
	size_t joints = (size_t)take->character.jointCount;
	soleTransform* own = calloc( 2 * joints, sizeof *own );
	soleTransform* pose = own + joints;
	for ( int i = 0; i <= 50; ++i )
	{
		float time = take->bound.duration * (float)i / 50.0f * 0.9999f;
		soleTransform root;
		toolSampleClip( &take->character, &take->bound, time, own );
		toolSampleLooped( &take->character, &take->bound, &take->travel, (double)time, pose, &root );
		if ( i == 0 )
		{
			testNear3( root.translation, soleVec( 0.0f, 0.0f, 0.0f ), 1e-5f );
		}
		for ( int32_t leg = 0; leg < take->character.rigDef.legCount; ++leg )
		{
			const soleLegDef* def = take->character.rigDef.legs + leg;
			int32_t ankle = def->joints[def->jointCount - 1];
			soleTransform wanted = toolPoseWorld( &take->character, own, ankle );
			soleTransform made = soleMulTransform( root, toolPoseWorld( &take->character, pose, ankle ) );
			testNear3( made.translation, wanted.translation, tolerance );
			assert_float_equal( fabsf( soleDotQuat( made.rotation, wanted.rotation ) ), 1.0f, 1e-4f );
		}
	}
	free( own );
}

static void testRootMotionOfAPelvisIsSteadyAndPutsBackTogether( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	testTake take;
	testOpen( "human-pab-rootmotion/pab_arnaud.glb", "walk", &take );
	assert_true( take.travel.rootMotion );
	assert_true( take.travel.loops );
	assert_int_equal( take.travel.kind, tool_travelSteady );
	assert_float_equal( take.travel.loop.translation.z, 1.43f, 0.02f );
	assert_float_equal( take.travel.frameRate, 30.0f, 1e-3f );
	testCheckRootTimesPose( &take, 1e-4f );
	// The next round goes on where this one ends.
	soleTransform a = toolSampleRoot( &take.character, &take.bound, &take.travel, (double)take.bound.duration - 1e-4 );
	soleTransform b = toolSampleRoot( &take.character, &take.bound, &take.travel, (double)take.bound.duration + 1e-4 );
	assert_float_equal( soleDistance( a.translation, b.translation ), 0.0f, 1e-3f );
	soleTransform c = toolSampleRoot( &take.character, &take.bound, &take.travel, 10.0 * (double)take.bound.duration );
	assert_float_equal( c.translation.z, 10.0f * take.travel.loop.translation.z, 1e-3f );
	testClose( &take );
}

static void testARootBoneMovesAsTheClipHasIt( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "kaiju-biped-tail/kaiju-animations.glb" );
	testTake take;
	testOpen( "kaiju-biped-tail/kaiju-animations.glb", "Walk RM", &take );
	assert_true( take.travel.rootMotion );
	assert_int_equal( take.travel.kind, tool_travelOwn );
	testCheckRootTimesPose( &take, 1e-3f );
	testClose( &take );
	testOpen( "kaiju-biped-tail/kaiju-animations.glb", "Walk", &take );
	assert_false( take.travel.rootMotion );
	assert_true( soleLength( take.travel.strideVelocity ) > 0.1f );
	testCheckRootTimesPose( &take, 1e-3f );
	testClose( &take );
}

static void testAnInPlaceWalkStaysWhereItIs( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testTake take;
	testOpen( "human-quaternius-ual/human-base-animations.glb", "Walk_Loop", &take );
	assert_false( take.travel.rootMotion );
	assert_true( take.travel.loops );
	assert_true( take.travel.closed );
	testCheckRootTimesPose( &take, 1e-5f );
	testClose( &take );
	testOpen( "human-quaternius-ual/human-base-animations.glb", "Jog_Fwd_Loop", &take );
	assert_true( take.travel.loops );
	assert_false( take.travel.closed );
	testClose( &take );
	testOpen( "human-quaternius-ual/human-base-animations.glb", "Death01", &take );
	assert_false( take.travel.rootMotion );
	testClose( &take );
}

static void testMotionCaptureFollowsItsPelvis( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "mocap-bvh/cmu_02_01_walk.glb" );
	testTake take;
	testOpen( "mocap-bvh/cmu_02_01_walk.glb", NULL, &take );
	assert_true( take.travel.rootMotion );
	testCheckRootTimesPose( &take, 1e-3f );
	testClose( &take );
	TEST_NEEDS_DATA( "mocap-bvh/cmu_01_01_hops_and_turns.glb" );
	testOpen( "mocap-bvh/cmu_01_01_hops_and_turns.glb", NULL, &take );
	assert_true( take.travel.rootMotion );
	assert_int_equal( take.travel.kind, tool_travelSmooth );
	testCheckRootTimesPose( &take, 1e-3f );
	testClose( &take );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testLinearIsOnTheLineBetweenKeys ),
		cmocka_unit_test( testTimeZeroIsTheFirstKeyAndEndsHold ),
		cmocka_unit_test( testAChannelThatStartsLateHoldsItsFirstKey ),
		cmocka_unit_test( testStepHoldsUntilTheNextKey ),
		cmocka_unit_test( testCubicFollowsTheHermiteSpline ),
		cmocka_unit_test( testRotationsTakeTheNearSideAtConstantSpeed ),
		cmocka_unit_test( testCubicRotationsAreNormalised ),
		cmocka_unit_test( testNodesOutsideTheClipRestAndScaleReachesRoots ),
		cmocka_unit_test( testAMovedNodeMovesInCharacterSpace ),
		cmocka_unit_test( testNamesBindExactlyElseByCaseElseWithoutPrefix ),
		cmocka_unit_test( testAClipOfMoreThanAnHourIsRefused ),
		cmocka_unit_test( testRootMotionOfAPelvisIsSteadyAndPutsBackTogether ),
		cmocka_unit_test( testARootBoneMovesAsTheClipHasIt ),
		cmocka_unit_test( testAnInPlaceWalkStaysWhereItIs ),
		cmocka_unit_test( testMotionCaptureFollowsItsPelvis ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
