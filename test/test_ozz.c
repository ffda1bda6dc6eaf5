// SPDX-License-Identifier: MIT
// Baseline ozz, each test named after what the foot IK sample does and its number in the description of it. The plain
// biped on exact grounds.
#include "placing.h"

#include "ozz_oracle.h"

typedef struct testOzz
{
	testRun run;
	soleOzzSettings settings;
	soleOzzState state;
	soleProbe probes[3];
	soleHit hits[3];
} testOzz;

static void testStartOzz( testOzz* ozz )
{
	memset( ozz, 0, sizeof *ozz );
	testStartRun( &ozz->run, 0.6f );
	ozz->settings = soleDefaultOzzSettings();
	soleFitOzzSettings( ozz->run.biped.rig, ozz->run.biped.bindPose, &ozz->settings );
	ozz->state = soleDefaultOzzState( ozz->run.biped.rig );
}

static void testGatherOzz( testOzz* ozz )
{
	testRun* run = &ozz->run;
	int32_t count =
	    soleGatherOzz( run->biped.rig, &ozz->settings, &ozz->state, &run->frame, ozz->probes, SOLE_MAX_PROBES );
	assert_int_equal( count, 3 );
	for ( int32_t i = 0; i < 3; ++i )
	{
		testCastAt( &run->ground, ozz->probes + i, ozz->hits + i );
		ozz->hits[i].hit = ozz->hits[i].hit && ozz->probes[i].length > 0.0f;
	}
}

static void testSolveOzz( testOzz* ozz )
{
	testRun* run = &ozz->run;
	soleSolveOzz( run->biped.rig, &ozz->settings, &ozz->state, &run->frame, ozz->hits, 3, &run->out );
	testPlace( run );
}

static void testStepOzz( testOzz* ozz )
{
	testGatherOzz( ozz );
	testSolveOzz( ozz );
}

static void testEndOzz( testOzz* ozz )
{
	testEndRun( &ozz->run );
}

static testSampleD testWideSample( const testOzz* ozz )
{
	const testRun* run = &ozz->run;
	testSampleD sample = { .parents = run->biped.parents,
		.def = &run->biped.def,
		.pose = run->pose,
		.root = run->frame.root,
		.settings = &ozz->settings,
		.hits = ozz->hits };
	testSampleInDouble( &sample );
	return sample;
}

static void testNearPoint( soleVec3 a, testPoint b, float tolerance )
{
	testNear3( a, soleVec( (float)b.x, (float)b.y, (float)b.z ), tolerance );
}

static soleVec3 testPlacedAnkle( const testOzz* ozz, int32_t leg )
{
	return testPlacedJoint( &ozz->run, testAnkle( leg ) ).translation;
}

static soleVec3 testAnimatedAnkle( const testOzz* ozz, int32_t leg )
{
	return testAnimatedJoint( &ozz->run, testAnkle( leg ) ).translation;
}

/// Ankles and feet are where the whole sample has them, written in double.
static void testIsTheSample( const testOzz* ozz, float tolerance )
{
	testSampleD sample = testWideSample( ozz );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		testNearPoint( testPlacedAnkle( ozz, leg ), sample.ankles[leg], tolerance );
		soleTransform foot = testPlacedJoint( &ozz->run, testAnkle( leg ) );
		for ( int32_t axis = 0; axis < 3; ++axis )
		{
			soleVec3 v = soleVec( axis == 0 ? 1.0f : 0.0f, axis == 1 ? 1.0f : 0.0f, axis == 2 ? 1.0f : 0.0f );
			testNearPoint( soleRotate( foot.rotation, v ), testTurned( sample.feet[leg], testWide( v ) ), 1e-4f );
		}
	}
}

// ------------------------------------------------------------------------------------------------------- settings

static void testTheDefaultsAreTheSamples( void** state )
{
	(void)state;
	soleOzzSettings settings = soleDefaultOzzSettings();
	assert_true( settings.autoCharacterHeight && settings.pelvisCorrection && settings.twoBoneIk && settings.aimIk );
	assert_float_equal( settings.footHeight, 0.12f, 0.0f );
	assert_float_equal( settings.weight, 1.0f, 0.0f );
	assert_float_equal( settings.soften, 1.0f, 0.0f );
	assert_float_equal( settings.rootRayHeight, 10.0f, 0.0f );
	assert_float_equal( settings.ankleRayHeight, 0.5f, 0.0f );
	assert_float_equal( settings.aimHeight, 1.0f, 0.0f );
	testNear3( settings.axes[1].kneeMidAxis, soleVec( 0.0f, 0.0f, 1.0f ), 0.0f );
	testNear3( settings.axes[1].kneePole, soleVec( 0.0f, 1.0f, 0.0f ), 0.0f );
	testNear3( settings.axes[1].ankleUp, soleVec( -1.0f, 0.0f, 0.0f ), 0.0f );
	testNear3( settings.axes[1].ankleForward, soleVec( 0.0f, 1.0f, 0.0f ), 0.0f );
}

static void testTheFitMeasuresFootHeightAndAxes( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	// The biped's soles are given at its floor: its ankles are 0.08 over it but for the bend of its knees at rest.
	soleVec3 ankle =
	    testJoint( &ozz.run.biped, ozz.run.biped.bindPose, soleTransform_Identity(), biped_ankleL ).translation;
	assert_float_equal( ozz.settings.footHeight, ankle.y, 1e-5f );
	const soleOzzLegAxes* axes = ozz.settings.axes;
	testNear3( axes->kneeMidAxis, soleVec( -1.0f, 0.0f, 0.0f ), 1e-5f );
	testNear3( axes->kneePole, soleVec( 0.0f, 0.0f, 1.0f ), 1e-5f );
	testNear3( axes->ankleUp, soleVec( 0.0f, 1.0f, 0.0f ), 1e-5f );
	testNear3( axes->ankleForward, soleVec( 0.0f, 0.0f, 1.0f ), 1e-5f );
	assert_float_equal( ozz.settings.ankleRayHeight, 0.5f * 0.9f / 0.93f, 1e-4f );
	testEndOzz( &ozz );
}

// ----------------------------------------------------------------------------------------- 4, 5: heights and rays

static void test4TheRootGoesToTheGroundUnderIt( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.frame.root.translation = soleVec( 3.0f, 0.3f, -2.0f );
	testStepOzz( &ozz );
	testNear3( ozz.probes[0].start_w, soleVec( 3.0f, 0.3f + ozz.settings.rootRayHeight, -2.0f ), 1e-5f );
	assert_float_equal( ozz.state.rootShift, -0.3f, 1e-6f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		assert_float_equal( testPlacedAnkle( &ozz, leg ).y, ozz.settings.footHeight, 1e-5f );
	}
	ozz.settings.autoCharacterHeight = false;
	testStepOzz( &ozz );
	assert_float_equal( ozz.probes[0].length, 0.0f, 0.0f );
	assert_float_equal( ozz.state.rootShift, 0.0f, 0.0f );
	testEndOzz( &ozz );
}

static void test4TheRootIsTheClipsOwnFloor( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.frame.clipFloor = 0.25f;
	ozz.run.frame.root.translation.y = -0.35f;
	testStepOzz( &ozz );
	assert_float_equal( ozz.probes[0].start_w.y, ozz.settings.rootRayHeight - 0.1f, 1e-5f );
	assert_float_equal( ozz.state.rootShift, 0.1f, 1e-6f );
	testEndOzz( &ozz );
}

static void test5TheRaysStartOverTheAnklesAsTheRootIsMovedBeforeThePelvisIs( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.stepX = -0.2f; // under the left foot
	ozz.run.frame.root.translation = soleVec( -0.02f, -1.0f, 0.0f );
	testStepOzz( &ozz );
	testStepOzz( &ozz );
	testGatherOzz( &ozz );
	assert_true( ozz.run.out.pelvisOffset_w.y < 0.9f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleVec3 start =
		    soleAdd( testAnimatedAnkle( &ozz, leg ), soleVec( 0.0f, 1.0f + ozz.settings.ankleRayHeight, 0.0f ) );
		testNear3( ozz.probes[1 + leg].start_w, start, 1e-5f );
		testNear3( ozz.probes[1 + leg].direction_w, soleVec( 0.0f, -1.0f, 0.0f ), 0.0f );
		assert_true( ozz.probes[1 + leg].length > 1e4f );
	}
	testEndOzz( &ozz );
}

// ----------------------------------------------------------------------------------------------- 6: ankle targets

static void test6TheAnkleStaysOverItsPlaceAsHighAsTheFootOffThePlane( void** state )
{
	(void)state;
	const float slopes[][2] = { { 0.0f, 0.0f }, { 0.3f, 0.0f }, { -0.2f, 0.4f }, { 0.0f, -0.5f }, { 0.6f, 0.6f } };
	for ( int32_t i = 0; i < 5; ++i )
	{
		testOzz ozz;
		testStartOzz( &ozz );
		ozz.run.ground.slopeX = slopes[i][0];
		ozz.run.ground.slopeZ = slopes[i][1];
		testStepOzz( &ozz );
		double x = (double)slopes[i][0], z = (double)slopes[i][1];
		double upright = (double)ozz.settings.footHeight * sqrt( 1.0 + x * x + z * z );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 ankle = testAnimatedAnkle( &ozz, leg );
			soleVec3 target = ozz.run.out.legs[leg].ankleTarget_w;
			assert_float_equal( target.x, ankle.x, 1e-5f );
			assert_float_equal( target.z, ankle.z, 1e-5f );
			float ground = testGroundHeight( &ozz.run.ground, ankle.x, ankle.z );
			assert_float_equal( target.y, ground + (float)upright, 1e-5f );
		}
		testEndOzz( &ozz );
	}
}

static void test6AnAnkleInThePlaneKeepsItsOldTarget( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.slopeZ = 0.2f;
	testStepOzz( &ozz );
	soleVec3 old = ozz.run.out.legs[0].ankleTarget_w;
	ozz.hits[1].point_w = testAnimatedAnkle( &ozz, 0 );
	testSolveOzz( &ozz );
	assert_memory_equal( &ozz.run.out.legs[0].ankleTarget_w, &old, sizeof old );
	testEndOzz( &ozz );
}

// ---------------------------------------------------------------------------------------------------- 7: the pelvis

static void test7TheCharacterGoesDownUntilTheLowestFootIsThere( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.stepX = -0.25f;
	ozz.run.frame.root.translation.x = -0.02f; // the root stays on the upper half
	testStepOzz( &ozz );
	float up = testAnimatedAnkle( &ozz, 0 ).y - ozz.settings.footHeight;
	testNear3( ozz.run.out.pelvisOffset_w, soleVec( 0.0f, -0.25f - up, 0.0f ), 1e-5f );
	// The lower leg is as the animation has it, the other one bends.
	assert_true( testAngle( ozz.run.placed[biped_kneeL].rotation, ozz.run.pose[biped_kneeL].rotation ) < 1e-3f );
	assert_true( testAngle( ozz.run.placed[biped_kneeR].rotation, ozz.run.pose[biped_kneeR].rotation ) > 0.2f );
	testEndOzz( &ozz );
}

static void test7TheCharacterIsRaisedWhereAllGroundIsHigher( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.settings.autoCharacterHeight = false;
	ozz.run.frame.root.translation.y = -0.3f;
	testStepOzz( &ozz );
	assert_true( ozz.run.out.pelvisOffset_w.y > 0.25f );
	assert_float_equal( testPlacedAnkle( &ozz, 0 ).y, ozz.settings.footHeight, 1e-5f );
	testEndOzz( &ozz );
}

// -------------------------------------------------------------------------------------------------- 8, 9: the jobs

static void test8And9AnklesAndFeetAreTheFormulasInDouble( void** state )
{
	(void)state;
	uint32_t seed = 31;
	for ( int32_t i = 0; i < 200; ++i )
	{
		testOzz ozz;
		testStartOzz( &ozz );
		testBendKnees( ozz.run.pose, testRandomFloat( &seed, 0.4f, 1.4f ) );
		ozz.run.pose[biped_hipL].rotation =
		    testTurn( testRandomDirection( &seed ), testRandomFloat( &seed, 0.0f, 0.4f ) );
		ozz.run.pose[biped_ankleR].rotation =
		    testTurn( testRandomDirection( &seed ), testRandomFloat( &seed, 0.0f, 0.4f ) );
		ozz.run.frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), testRandomFloat( &seed, -3.0f, 3.0f ) );
		ozz.run.frame.root.scale = soleVec( 1.5f, 1.5f, 1.5f );
		ozz.run.ground.slopeX = testRandomFloat( &seed, -0.5f, 0.5f );
		ozz.run.ground.slopeZ = testRandomFloat( &seed, -0.5f, 0.5f );
		ozz.settings.soften = i % 2 == 0 ? 1.0f : 0.9f;
		ozz.settings.weight = i % 3 == 0 ? 0.6f : 1.0f;
		testStepOzz( &ozz );
		testIsTheSample( &ozz, 1e-4f );
		testEndOzz( &ozz );
	}
}

static void test8ThePoleIsTheKneesOwnSoThatItPointsWhereTheAnimationPoints( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	soleQuat turn = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.5f );
	ozz.run.pose[biped_hipL].rotation = soleMulQuat( turn, ozz.run.pose[biped_hipL].rotation );
	ozz.run.ground.stepX = 0.2f;
	ozz.run.frame.root.translation.x = -0.02f;
	testStepOzz( &ozz );
	soleVec3 hip = testPlacedJoint( &ozz.run, biped_hipL ).translation;
	soleVec3 knee = soleSub( testPlacedJoint( &ozz.run, biped_kneeL ).translation, hip );
	assert_true( knee.z > 0.1f );
	assert_float_equal( knee.x / knee.z, tanf( 0.5f ), 0.02f );
	testEndOzz( &ozz );
}

static void test8TheWeightFadesBothJobs( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.stepX = 0.2f;
	ozz.run.ground.slopeZ = 0.3f;
	ozz.run.frame.root.translation.x = -0.02f;
	ozz.settings.weight = 0.0f;
	testStepOzz( &ozz );
	assert_true( testLargestTurn( ozz.run.pose, ozz.run.placed ) < 2e-3f );
	ozz.settings.weight = 1.0f;
	testStepOzz( &ozz );
	float whole = testAngle( ozz.run.placed[biped_kneeL].rotation, ozz.run.pose[biped_kneeL].rotation );
	ozz.settings.weight = 0.5f;
	testStepOzz( &ozz );
	float half = testAngle( ozz.run.placed[biped_kneeL].rotation, ozz.run.pose[biped_kneeL].rotation );
	assert_true( whole > 0.2f && half > 0.45f * whole && half < 0.55f * whole );
	testEndOzz( &ozz );
}

static void test8SofteningKeepsALegFromStraightening( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.settings.pelvisCorrection = false;
	ozz.run.ground.stepX = -0.12f;
	ozz.run.frame.root.translation.x = -0.02f;
	testStepOzz( &ozz );
	assert_float_equal( ozz.run.out.legs[0].extension, 1.0f, 1e-5f );
	assert_true( ( ozz.run.out.legs[0].flags & sole_legOutOfReach ) != 0 );
	assert_true( ( ozz.run.out.legs[1].flags & sole_legOutOfReach ) == 0 );
	ozz.settings.soften = 0.9f;
	testStepOzz( &ozz );
	assert_true( ozz.run.out.legs[0].extension < 0.99f );
	testEndOzz( &ozz );
}

static void test9TheAnklesUpIsTheNormalAndItsForwardKeepsItsHeading( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.slopeX = 0.25f;
	ozz.run.ground.slopeZ = -0.3f;
	ozz.run.pose[biped_ankleL].rotation =
	    soleMulQuat( testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.4f ), ozz.run.pose[biped_ankleL].rotation );
	testStepOzz( &ozz );
	soleVec3 normal = soleNormalizeOr( soleVec( -0.25f, 1.0f, 0.3f ), soleVec( 0.0f, 1.0f, 0.0f ) );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleQuat foot = testPlacedJoint( &ozz.run, testAnkle( leg ) ).rotation;
		testNear3( soleRotate( foot, ozz.settings.axes[leg].ankleUp ), normal, 1e-4f );
		soleVec3 forward = soleRotate( foot, ozz.settings.axes[leg].ankleForward );
		assert_float_equal( atan2f( forward.x, forward.z ), leg == 0 ? 0.4f : 0.0f, 0.1f );
	}
	testEndOzz( &ozz );
}

// ---------------------------------------------------------------------------------------- 10 to 12: misses, switches

static void test10AMissLeavesItsLegAndDoesNotCountForThePelvis( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.ground.stepX = -0.3f;
	ozz.run.frame.root.translation.x = -0.02f;
	testGatherOzz( &ozz );
	ozz.hits[1].hit = false; // the left foot's, which is the lower one
	testSolveOzz( &ozz );
	assert_true( ozz.run.out.pelvisOffset_w.y > -0.05f );
	assert_true( ( ozz.run.out.legs[0].flags & sole_legNoGround ) != 0 );
	for ( int32_t j = biped_hipL; j <= biped_toeL; ++j )
	{
		assert_memory_equal( ozz.run.placed + j, ozz.run.pose + j, sizeof *ozz.run.pose );
	}
	assert_float_equal( testPlacedAnkle( &ozz, 1 ).y, ozz.settings.footHeight, 1e-5f );
	memset( ozz.hits, 0, sizeof ozz.hits );
	testSolveOzz( &ozz );
	assert_memory_equal( ozz.run.placed, ozz.run.pose, sizeof ozz.run.pose );
	testEndOzz( &ozz );
}

static void test11EachStageHasItsSwitch( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < 16; ++i )
	{
		testOzz ozz;
		testStartOzz( &ozz );
		ozz.run.ground.slopeZ = 0.3f;
		ozz.run.ground.stepX = 0.1f;
		ozz.run.frame.root.translation = soleVec( -0.02f, 0.2f, 0.0f );
		ozz.settings.autoCharacterHeight = ( i & 1 ) != 0;
		ozz.settings.pelvisCorrection = ( i & 2 ) != 0;
		ozz.settings.twoBoneIk = ( i & 4 ) != 0;
		ozz.settings.aimIk = ( i & 8 ) != 0;
		testStepOzz( &ozz );
		float lowest = -1.0f;
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 ankle = testAnimatedAnkle( &ozz, leg );
			float moved = ( i & 1 ) != 0 ? -0.2f : 0.0f;
			float ground = testGroundHeight( &ozz.run.ground, ankle.x, ankle.z );
			float target = ground + ozz.settings.footHeight * sqrtf( 1.09f );
			lowest = fmaxf( lowest, ankle.y + moved - target );
		}
		float shift = ( ( i & 1 ) != 0 ? -0.2f : 0.0f ) - ( ( i & 2 ) != 0 ? lowest : 0.0f );
		testNear3( ozz.run.out.pelvisOffset_w, soleVec( 0.0f, shift, 0.0f ), 1e-5f );
		float bent = testAngle( ozz.run.placed[biped_kneeR].rotation, ozz.run.pose[biped_kneeR].rotation ) +
		    testAngle( ozz.run.placed[biped_kneeL].rotation, ozz.run.pose[biped_kneeL].rotation );
		assert_true( ( bent > 0.05f ) == ( ( i & 4 ) != 0 ) );
		soleQuat foot = testPlacedJoint( &ozz.run, biped_ankleR ).rotation;
		float tilt = soleRotate( foot, ozz.settings.axes[1].ankleUp ).z;
		assert_true( ( tilt < -0.2f ) == ( ( i & 8 ) != 0 ) || ( i & 4 ) != 0 );
		testEndOzz( &ozz );
	}
}

static void test12NothingIsSmoothed( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.frame.timeStep = 0.0f;
	testStepOzz( &ozz );
	ozz.run.ground.slopeX = 0.4f;
	ozz.run.frame.root.translation = soleVec( 2.0f, 0.0f, 1.0f );
	testStepOzz( &ozz );
	testStepOzz( &ozz );
	testIsTheSample( &ozz, 1e-4f );
	soleOutput before = ozz.run.out;
	testStepOzz( &ozz );
	assert_memory_equal( &before, &ozz.run.out, sizeof before );
	testEndOzz( &ozz );
}

static void testTheHostsWeightsLeaveThePoseAsItIs( void** state )
{
	(void)state;
	testOzz ozz;
	testStartOzz( &ozz );
	ozz.run.frame.root.translation.y = 0.4f;
	ozz.run.ground.slopeX = 0.3f;
	ozz.run.frame.weight = 0.0f;
	testStepOzz( &ozz );
	assert_true( testLargestTurn( ozz.run.pose, ozz.run.placed ) < 2e-3f );
	testNear3( ozz.run.out.pelvisOffset_w, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	testEndOzz( &ozz );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testTheDefaultsAreTheSamples ),
		cmocka_unit_test( testTheFitMeasuresFootHeightAndAxes ),
		cmocka_unit_test( test4TheRootGoesToTheGroundUnderIt ),
		cmocka_unit_test( test4TheRootIsTheClipsOwnFloor ),
		cmocka_unit_test( test5TheRaysStartOverTheAnklesAsTheRootIsMovedBeforeThePelvisIs ),
		cmocka_unit_test( test6TheAnkleStaysOverItsPlaceAsHighAsTheFootOffThePlane ),
		cmocka_unit_test( test6AnAnkleInThePlaneKeepsItsOldTarget ),
		cmocka_unit_test( test7TheCharacterGoesDownUntilTheLowestFootIsThere ),
		cmocka_unit_test( test7TheCharacterIsRaisedWhereAllGroundIsHigher ),
		cmocka_unit_test( test8And9AnklesAndFeetAreTheFormulasInDouble ),
		cmocka_unit_test( test8ThePoleIsTheKneesOwnSoThatItPointsWhereTheAnimationPoints ),
		cmocka_unit_test( test8TheWeightFadesBothJobs ),
		cmocka_unit_test( test8SofteningKeepsALegFromStraightening ),
		cmocka_unit_test( test9TheAnklesUpIsTheNormalAndItsForwardKeepsItsHeading ),
		cmocka_unit_test( test10AMissLeavesItsLegAndDoesNotCountForThePelvis ),
		cmocka_unit_test( test11EachStageHasItsSwitch ),
		cmocka_unit_test( test12NothingIsSmoothed ),
		cmocka_unit_test( testTheHostsWeightsLeaveThePoseAsItIs ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
