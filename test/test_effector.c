// SPDX-License-Identifier: MIT
// Baseline effector, each test named after what it does and its number in the description. The plain biped, stepped at
// 60 frames a second; oracles in double, centimetres.
#include "placing.h"

#include "baselines/effector.h"

typedef struct testEffector
{
	testRun run;
	soleEffectorSettings settings;
	soleEffectorState state;
	soleEffectorOutput effectors;
	soleProbe probes[2];
	soleHit hits[2];
} testEffector;

static void testStartEffector( testEffector* test )
{
	memset( test, 0, sizeof *test );
	testStartRun( &test->run, 0.9f );
	test->settings = soleDefaultEffectorSettings();
	soleFitEffectorSettings( test->run.biped.rig, &test->settings );
	test->state = soleDefaultEffectorState( test->run.biped.rig );
	// The root is over the higher half, the left foot may be over the lower one.
	test->run.frame.root.translation.x = -0.02f;
}

static void testEndEffector( testEffector* test )
{
	testEndRun( &test->run );
}

static void testGatherEffector( testEffector* test )
{
	testRun* run = &test->run;
	int32_t count =
	    soleGatherEffector( run->biped.rig, &test->settings, &test->state, &run->frame, test->probes, SOLE_MAX_PROBES );
	assert_int_equal( count, 2 );
	for ( int32_t i = 0; i < 2; ++i )
	{
		testCastAt( &run->ground, test->probes + i, test->hits + i );
		test->hits[i].hit = test->hits[i].hit && test->probes[i].length > 0.0f;
	}
}

static void testStepEffector( testEffector* test )
{
	testRun* run = &test->run;
	testGatherEffector( test );
	soleSolveEffector(
	    run->biped.rig, &test->settings, &test->state, &run->frame, test->hits, 2, &test->effectors, &run->out );
	testPlace( run );
}

static void testStepEffectors( testEffector* test, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		testStepEffector( test );
	}
}

/// Never there: what the interpolations come to in the end is seen.
static void testSettleEffector( testEffector* test )
{
	test->settings.nearlyEqual = -1.0f;
	testStepEffectors( test, 600 );
}

static float testCapsuleMiddle( const testEffector* test )
{
	float half = test->settings.capsuleHalfHeight - test->state.capsuleShorter;
	return test->run.frame.root.translation.y + 0.01f * half;
}

// ------------------------------------------------------------------------------------------------ 2, 4: set-up, traces

static void test2TheDefaults( void** state )
{
	(void)state;
	soleEffectorSettings settings = soleDefaultEffectorSettings();
	assert_true( settings.enableAnimationIk );
	assert_float_equal( settings.traceDistance, 55.0f, 0.0f );
	assert_float_equal( settings.footAdjustment, 0.0f, 0.0f );
	assert_float_equal( settings.feetInterpSpeed, 15.0f, 0.0f );
	assert_float_equal( settings.hipInterpSpeed, 10.0f, 0.0f );
	assert_float_equal( settings.meshScale * settings.transformScale, 1.0f, 0.0f );
	assert_float_equal( settings.nearlyEqual, 1.0f, 0.0f );
	testEffector test;
	testStartEffector( &test );
	assert_true( test.state.usingFootIk );
	assert_float_equal( test.settings.capsuleHalfHeight, 98.0f, 1.0f ); // hips over the sole
	assert_float_equal( test.settings.traceDistance, 55.0f / 88.0f * test.settings.capsuleHalfHeight, 1e-3f );
	testEndEffector( &test );
}

static void test4TracesGoDownFromTheCapsulesMiddleAtTheSockets( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.frame.root.translation = soleVec( 1.0f, 2.0f, 3.0f );
	test.state.capsuleShorter = 7.0f;
	test.settings.sockets[1] = biped_toeR;
	testGatherEffector( &test );
	const int32_t joints[] = { biped_ankleL, biped_toeR };
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleVec3 socket = testAnimatedJoint( &test.run, joints[i] ).translation;
		testNear3( test.probes[i].start_w, soleVec( socket.x, testCapsuleMiddle( &test ), socket.z ), 1e-5f );
		testNear3( test.probes[i].direction_w, soleVec( 0.0f, -1.0f, 0.0f ), 0.0f );
		float length = 0.01f * ( test.settings.capsuleHalfHeight + test.settings.traceDistance );
		assert_float_equal( test.probes[i].length, length, 1e-6f );
		assert_float_equal( test.probes[i].radius, 0.0f, 0.0f );
	}
	testEndEffector( &test );
}

/// With speeds of zero all jumps to where it goes: the offsets are read off in one step.
static void test4GroundIsAsHighAsItIsOverTheCapsulesLowerEndAtRest( void** state )
{
	(void)state;
	const float heights[] = { 0.3f, 0.1f, -0.1f, -0.4f };
	for ( int32_t i = 0; i < 4; ++i )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			testEffector test;
			testStartEffector( &test );
			test.settings.feetInterpSpeed = 0.0f;
			test.settings.hipInterpSpeed = 0.0f;
			test.settings.footAdjustment = k == 0 ? 0.0f : 3.0f;
			test.run.frame.root.translation.y = 5.0f;
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				test.hits[leg] = ( soleHit ){ .hit = true, .normal_w = { 0.0f, 1.0f, 0.0f } };
				test.hits[leg].point_w = soleVec( 0.0f, 5.0f + ( leg == 0 ? heights[i] : 0.0f ), 0.0f );
			}
			soleSolveEffector( test.run.biped.rig, &test.settings, &test.state, &test.run.frame, test.hits, 2,
			    &test.effectors, &test.run.out );
			double a = (double)test.settings.footAdjustment;
			double left = 100.0 * (double)heights[i] + a;
			double hip = fmin( 0.0, fmin( left, a ) );
			assert_float_equal( test.effectors.hipOffset, (float)hip, 1e-3f );
			assert_float_equal( test.effectors.effectors[0], (float)( left - hip ), 1e-3f );
			assert_float_equal( test.effectors.effectors[1], (float)( a - hip ), 1e-3f );
			testEndEffector( &test );
		}
	}
}

static void test4TheCapsuleStandsOnTheClipsOwnFloor( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.settings.feetInterpSpeed = 0.0f;
	test.run.frame.clipFloor = 0.25f;
	test.run.frame.root.translation.y = -0.35f;
	testStepEffector( &test );
	float half = 0.01f * test.settings.capsuleHalfHeight;
	assert_float_equal( test.probes[0].start_w.y, half - 0.1f, 1e-5f );
	assert_float_equal( test.effectors.effectors[0], 10.0f, 1e-3f );
	testEndEffector( &test );
}

static void test4AMissCountsAsLevelGround( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.settings.footAdjustment = 4.0f;
	test.run.ground.stepX = -2.0f; // deeper than is traced
	test.settings.feetInterpSpeed = 0.0f;
	testStepEffector( &test );
	assert_false( test.hits[0].hit );
	assert_true( ( test.run.out.legs[0].flags & sole_legNoGround ) != 0 );
	assert_float_equal( test.effectors.effectors[0], 0.0f, 0.0f );
	assert_float_equal( test.effectors.effectors[1], 4.0f, 1e-4f );
	testEndEffector( &test );
}

// ------------------------------------------------------------------------------------- 5, 6, 7: hip, capsule and feet

static void test5TheHipIsNeverRaised( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.frame.root.translation.y = -0.2f; // all ground is higher
	testSettleEffector( &test );
	assert_float_equal( test.effectors.hipOffset, 0.0f, 0.0f );
	assert_float_equal( test.effectors.effectors[0], 20.0f, 1e-3f );
	assert_float_equal( test.effectors.effectors[1], 20.0f, 1e-3f );
	testEndEffector( &test );
}

static void test6TheCapsuleTakesAThirdOfADropAndTheHipTwo( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	assert_float_equal( test.effectors.hipOffset, -16.0f, 1e-3f );
	assert_float_equal( test.effectors.capsuleHalfHeight, test.settings.capsuleHalfHeight - 8.0f, 1e-3f );
	assert_float_equal( test.run.out.capsuleShorter, 0.08f, 1e-5f );
	assert_float_equal( test.run.out.capsuleOffset, -0.08f, 1e-5f );
	// The mesh hangs at the capsule's middle: both together lower the body by the whole drop.
	testNear3( test.run.out.pelvisOffset_w, soleVec( 0.0f, -0.24f, 0.0f ), 1e-5f );
	testEndEffector( &test );
}

static void test7EachFootIsRaisedToItsOwnGround( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.pose[biped_ankleR].rotation = testTurn( soleVec( 0.6f, 0.0f, 0.8f ), 0.5f );
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	assert_float_equal( test.effectors.effectors[0], 0.0f, 1e-3f );
	assert_float_equal( test.effectors.effectors[1], 24.0f, 1e-3f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleTransform animated = testAnimatedJoint( &test.run, testAnkle( leg ) );
		soleTransform placed = testPlacedJoint( &test.run, testAnkle( leg ) );
		float drop = leg == 0 ? -0.24f : 0.0f;
		testNear3( placed.translation, soleAdd( animated.translation, soleVec( 0.0f, drop, 0.0f ) ), 1e-4f );
		// Height only: the foot is not turned.
		assert_true( testAngle( animated.rotation, placed.rotation ) < 1e-3f );
	}
	testEndEffector( &test );
}

static void test2EffectorsAreDividedByTheScales( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.settings.meshScale = 1.6f;
	test.settings.transformScale = 0.5f;
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	assert_float_equal( test.effectors.effectors[1], 30.0f, 1e-3f );
	assert_float_equal( test.effectors.hipOffset, -16.0f, 1e-3f );
	soleVec3 animated = testAnimatedJoint( &test.run, biped_ankleR ).translation;
	testNear3( testPlacedJoint( &test.run, biped_ankleR ).translation, animated, 1e-4f );
	testEndEffector( &test );
}

static void testLengthsAreCentimetresOfTheWorld( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.settings = soleDefaultEffectorSettings();
	test.settings.unitsPerCentimetre = 0.02f;
	soleFitEffectorSettings( test.run.biped.rig, &test.settings );
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	assert_float_equal( test.effectors.hipOffset, -8.0f, 1e-3f );
	testNear3( test.run.out.pelvisOffset_w, soleVec( 0.0f, -0.24f, 0.0f ), 1e-5f );
	testEndEffector( &test );
}

// ---------------------------------------------------------------------------------------------- 10: interpolations

static void test10EachGoesByItsShareOfWhatIsLeftAFrame( void** state )
{
	(void)state;
	const float steps[] = { 1.0f / 60.0f, 1.0f / 20.0f, 0.5f }; // the last one is clamped
	for ( int32_t k = 0; k < 3; ++k )
	{
		testEffector test;
		testStartEffector( &test );
		test.settings.nearlyEqual = -1.0f;
		test.run.frame.timeStep = steps[k];
		test.run.ground.stepX = -0.24f;
		double dt = (double)steps[k];
		double feet = fmin( 15.0 * dt, 1.0 ), hips = fmin( 10.0 * dt, 1.0 );
		double hip = 0.0, shorter = 0.0, left = 0.0, right = 0.0;
		for ( int32_t i = 0; i < 20; ++i )
		{
			double low = -24.0 + shorter, high = shorter;
			double h = fmin( 0.0, fmin( low, high ) );
			hip += ( h - hip ) * hips;
			shorter += ( -0.5 * h - shorter ) * hips;
			left += ( low - h - left ) * feet;
			right += ( high - h - right ) * feet;
			testStepEffector( &test );
			assert_float_equal( test.effectors.hipOffset, (float)hip, 1e-3f );
			assert_float_equal( test.state.capsuleShorter, (float)shorter, 1e-3f );
			assert_float_equal( test.effectors.effectors[0], (float)left, 1e-3f );
			assert_float_equal( test.effectors.effectors[1], (float)right, 1e-3f );
		}
		testEndEffector( &test );
	}
}

static void test10ASpeedOfZeroJumps( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.settings.feetInterpSpeed = 0.0f;
	test.settings.hipInterpSpeed = 0.0f;
	test.run.ground.stepX = -0.24f;
	test.run.frame.timeStep = 0.0f;
	testStepEffector( &test );
	assert_float_equal( test.effectors.hipOffset, -24.0f, 1e-3f );
	assert_float_equal( test.state.capsuleShorter, 12.0f, 1e-3f );
	assert_float_equal( test.effectors.effectors[1], 24.0f, 1e-3f );
	testEndEffector( &test );
}

// ---------------------------------------------------------------------------------- 3, 8, 9: moving, stopping, waking

static void test9WhileMovingAllGoesBack( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	soleEffectorOutput before = test.effectors;
	test.run.frame.root.translation.z += 1e-6f; // the least creep is motion
	testStepEffector( &test );
	assert_float_equal( test.probes[0].length, 0.0f, 0.0f );
	assert_float_equal( test.effectors.hipOffset, before.hipOffset * ( 1.0f - 10.0f / 60.0f ), 1e-3f );
	assert_float_equal( test.effectors.effectors[1], before.effectors[1] * ( 1.0f - 15.0f / 60.0f ), 1e-3f );
	for ( int32_t i = 0; i < 300; ++i )
	{
		test.run.frame.root.translation.z += 0.01f;
		testStepEffector( &test );
	}
	assert_float_equal( test.effectors.hipOffset, 0.0f, 1e-3f );
	assert_float_equal( test.effectors.effectors[1], 0.0f, 1e-3f );
	assert_float_equal( test.effectors.capsuleHalfHeight, test.settings.capsuleHalfHeight, 1e-3f );
	// And when it stands again they come back.
	testStepEffectors( &test, 600 );
	assert_float_equal( test.effectors.hipOffset, -16.0f, 1e-3f );
	testEndEffector( &test );
}

static void test9AJumpThatIsNoMotionDoesNotReset( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	testSettleEffector( &test );
	test.run.frame.root.translation.z += 5.0f;
	test.run.frame.teleport = true;
	testStepEffector( &test );
	assert_float_equal( test.effectors.hipOffset, -16.0f, 1e-3f );
	testEndEffector( &test );
}

static void test8ItStopsWhenTheFeetAreWithinAUnitWhereverTheHipIs( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	int32_t frames = 0;
	while ( test.state.usingFootIk && frames < 600 )
	{
		testStepEffector( &test );
		++frames;
	}
	assert_true( frames > 5 && frames < 60 );
	assert_float_equal( test.effectors.effectors[1], 24.0f, 1.0f );
	assert_true( fabsf( test.effectors.effectors[1] - 24.0f ) > 0.1f );
	assert_true( fabsf( test.effectors.hipOffset + 16.0f ) > 0.5f );
	soleEffectorOutput stopped = test.effectors;
	testStepEffectors( &test, 60 );
	assert_memory_equal( &stopped, &test.effectors, sizeof stopped );
	testEndEffector( &test );
}

static void test12NothingStartsItAgainButTheHost( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	testStepEffector( &test ); // level ground: there at once
	assert_false( test.state.usingFootIk );
	test.run.ground.stepX = -0.24f;
	testStepEffectors( &test, 60 );
	assert_float_equal( test.probes[0].length, 0.0f, 0.0f );
	assert_float_equal( test.effectors.hipOffset, 0.0f, 0.0f );
	test.run.frame.root.translation.z += 0.5f; // nor does moving
	testStepEffectors( &test, 60 );
	assert_float_equal( test.effectors.hipOffset, 0.0f, 0.0f );
	test.state.usingFootIk = true;
	testStepEffectors( &test, 60 );
	assert_true( test.effectors.hipOffset < -10.0f );
	testEndEffector( &test );
}

static void test3BothSwitchesHaveToBeOn( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	test.settings.enableAnimationIk = false;
	testStepEffectors( &test, 60 );
	assert_float_equal( test.probes[0].length, 0.0f, 0.0f );
	assert_float_equal( test.effectors.hipOffset, 0.0f, 0.0f );
	test.settings.enableAnimationIk = true;
	testStepEffectors( &test, 10 );
	assert_true( test.effectors.hipOffset < -5.0f );
	// Without animation IK the pose is the animation's, whatever has been computed: that is how it was compared.
	test.settings.enableAnimationIk = false;
	testStepEffector( &test );
	assert_memory_equal( test.run.placed, test.run.pose, sizeof test.run.pose );
	testEndEffector( &test );
}

static void testTheHostsWeightsLeaveThePoseAsItIs( void** state )
{
	(void)state;
	testEffector test;
	testStartEffector( &test );
	test.run.ground.stepX = -0.24f;
	test.run.frame.weight = 0.0f;
	testSettleEffector( &test );
	assert_true( testLargestTurn( test.run.pose, test.run.placed ) < 2e-3f );
	testNear3( test.run.out.pelvisOffset_w, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	testEndEffector( &test );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( test2TheDefaults ),
		cmocka_unit_test( test4TracesGoDownFromTheCapsulesMiddleAtTheSockets ),
		cmocka_unit_test( test4GroundIsAsHighAsItIsOverTheCapsulesLowerEndAtRest ),
		cmocka_unit_test( test4TheCapsuleStandsOnTheClipsOwnFloor ),
		cmocka_unit_test( test4AMissCountsAsLevelGround ),
		cmocka_unit_test( test5TheHipIsNeverRaised ),
		cmocka_unit_test( test6TheCapsuleTakesAThirdOfADropAndTheHipTwo ),
		cmocka_unit_test( test7EachFootIsRaisedToItsOwnGround ),
		cmocka_unit_test( test2EffectorsAreDividedByTheScales ),
		cmocka_unit_test( testLengthsAreCentimetresOfTheWorld ),
		cmocka_unit_test( test10EachGoesByItsShareOfWhatIsLeftAFrame ),
		cmocka_unit_test( test10ASpeedOfZeroJumps ),
		cmocka_unit_test( test9WhileMovingAllGoesBack ),
		cmocka_unit_test( test9AJumpThatIsNoMotionDoesNotReset ),
		cmocka_unit_test( test8ItStopsWhenTheFeetAreWithinAUnitWhereverTheHipIs ),
		cmocka_unit_test( test12NothingStartsItAgainButTheHost ),
		cmocka_unit_test( test3BothSwitchesHaveToBeOn ),
		cmocka_unit_test( testTheHostsWeightsLeaveThePoseAsItIs ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
