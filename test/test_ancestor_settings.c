// SPDX-License-Identifier: MIT
// What the four systems that Sole descends from do, done by Sole's own pipeline with settings alone: one test a
// behaviour, as docs/ancestors.md lists them; and the presets below settings/.
#include "biped_walk.h"

#include "settings_file.h"

static void begin( testRun* run, const char* preset, float flexion )
{
	testStartRun( run, flexion );
	char path[512];
	snprintf( path, sizeof path, SOLE_SOURCE_DIR "/settings/%s.json", preset );
	toolError error = { { 0 } };
	if ( !toolReadSettings( path, &run->settings, &error ) )
	{
		fail_msg( "%s", error.text );
	}
}

static float groundUnder( const testRun* run, int32_t leg )
{
	soleVec3 ankle = testPlacedJoint( run, testAnkle( leg ) ).translation;
	return testGroundHeight( &run->ground, ankle.x, ankle.z );
}

static float overGround( const testRun* run, int32_t leg )
{
	return testPlacedJoint( run, testAnkle( leg ) ).translation.y - groundUnder( run, leg );
}

/// Lifts a foot of the animation straight up.
static void liftFoot( testRun* run, int32_t leg, float height )
{
	testPutAnkle(
	    run->pose, leg == 0 ? biped_hipL : biped_hipR, run->pose[biped_pelvis].translation.y - 0.08f - height, 0.0f );
}

// ---------------------------------------------------------------------------------------------------------- presets

static const char* const presets[] = { "homebrew", "iksetting", "effector", "ozz" };

static void everyPresetIsReadAndPutsStandingFeetOnAStep( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t k = 0; k < 4; ++k )
	{
		begin( &run, presets[k], 0.5f );
		run.ground.stepX = -0.12f;
		testStepSeconds( &run, 2.0f );
		assert_float_equal( overGround( &run, 0 ), 0.08f, 3e-3f );
		assert_float_equal( overGround( &run, 1 ), 0.08f, 3e-3f );
		// The pelvis goes with the lower foot: that leg is as animated, the other one is bent.
		assert_float_equal( run.out.pelvisOffset_w.y, -0.12f, 3e-3f );
		soleQuat lower = testPlacedJoint( &run, biped_kneeL ).rotation;
		assert_true( testAngle( lower, testAnimatedJoint( &run, biped_kneeL ).rotation ) < 0.02f );
		testEndRun( &run );
	}
}

static void noPresetMovesAFootSideways( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t k = 0; k < 4; ++k )
	{
		begin( &run, presets[k], 0.6f );
		run.ground.slopeZ = 0.2f;
		for ( int32_t i = 0; i < 120; ++i )
		{
			run.frame.root.translation = soleVec( 0.0f, 0.002f * (float)i, 0.01f * (float)i );
			testStepRun( &run );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				soleVec3 was = testAnimatedJoint( &run, testAnkle( leg ) ).translation;
				soleVec3 is = testPlacedJoint( &run, testAnkle( leg ) ).translation;
				testNear3( soleVec( is.x, 0.0f, is.z ), soleVec( was.x, 0.0f, was.z ), 3e-3f );
			}
		}
		testEndRun( &run );
	}
}

static void aFootOverNothingStaysAsItIsAndDoesNotCount( void** state )
{
	(void)state;
	static testRun run;
	begin( &run, "ozz", 0.4f );
	run.settings.probe.stepDown = 0.5f;
	run.ground.stepX = -3.0f; // out of reach of any probe
	run.ground.slopeX = 0.1f;
	testStepSeconds( &run, 1.0f );
	assert_true( ( run.out.legs[0].flags & (uint32_t)sole_legNoGround ) != 0 );
	float lower = run.out.pelvisOffset_w.y;
	assert_float_equal( lower, testGroundHeight( &run.ground, -0.09f, 0.0f ), 3e-3f );
	soleVec3 hip = testPlacedJoint( &run, biped_hipL ).translation;
	soleVec3 ankle = testPlacedJoint( &run, biped_ankleL ).translation;
	soleVec3 was = soleSub(
	    testAnimatedJoint( &run, biped_ankleL ).translation, testAnimatedJoint( &run, biped_hipL ).translation );
	assert_float_equal( soleDistance( soleSub( ankle, hip ), was ), fabsf( lower ), 2e-3f );
	testEndRun( &run );
}

// ----------------------------------------------------------------------------------------------------------- heights

static void solesAreKeptAsFarOverTheGroundAsIsSet( void** state )
{
	(void)state;
	static testRun run;
	const float heights[] = { 0.05f, -0.03f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( &run, 0.5f );
		run.settings.target.height = heights[k];
		testStepSeconds( &run, 1.0f );
		assert_float_equal( overGround( &run, 0 ), 0.08f + heights[k] * 0.9f, 1e-3f );
		assert_float_equal( overGround( &run, 1 ), 0.08f + heights[k] * 0.9f, 1e-3f );
		testEndRun( &run );
	}
}

static void groundTiltsAFootNoFurtherThanIsSet( void** state )
{
	(void)state;
	static testRun run;
	const float slopes[] = { 0.1f, 0.6f, -0.6f };
	const float limit = 0.2617994f; // 15 degrees
	for ( int32_t k = 0; k < 3; ++k )
	{
		testStartRun( &run, 0.6f );
		run.settings.target.maxTilt = limit;
		run.ground.slopeX = slopes[k];
		testStepSeconds( &run, 1.0f );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleQuat was = testAnimatedJoint( &run, testAnkle( leg ) ).rotation;
			float tilt = testAngle( testPlacedJoint( &run, testAnkle( leg ) ).rotation, was );
			assert_float_equal( tilt, fminf( fabsf( atanf( slopes[k] ) ), limit ), 2e-3f );
			assert_true( testSoleClearance( &run, leg ) > -0.06f );
		}
		testEndRun( &run );
	}
}

static void withoutAlignmentAFootKeepsItsTurnButNotItsHeight( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.6f );
	run.settings.target.align = 0.0f;
	run.ground.slopeZ = 0.25f;
	run.frame.root.translation.y = 0.05f;
	testStepSeconds( &run, 1.0f );
	soleQuat was = testAnimatedJoint( &run, biped_ankleL ).rotation;
	assert_true( testAngle( testPlacedJoint( &run, biped_ankleL ).rotation, was ) < 2e-3f );
	assert_float_equal( testSoleClearance( &run, 0 ), 0.0f, 2e-3f );
	testEndRun( &run );
}

// ----------------------------------------------------------------------------------------------------------- weights

static void aFootInFlightIsAsAnimatedWhereSettingsSaySo( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.6f );
	run.settings.target.flight = 0.0f;
	run.ground.stepX = 0.08f;
	testStepSeconds( &run, 1.0f );
	assert_float_equal( overGround( &run, 0 ), 0.08f, 2e-3f );
	float last = testPlacedJoint( &run, biped_ankleL ).translation.y;
	float largest = 0.0f;
	for ( int32_t i = 0; i <= 90; ++i )
	{
		// 0.2 m up in half a second, to stay there.
		liftFoot( &run, 0, 0.2f * fminf( (float)i / 30.0f, 1.0f ) );
		testStepRun( &run );
		float now = testPlacedJoint( &run, biped_ankleL ).translation.y;
		largest = fmaxf( largest, fabsf( now - last ) );
		last = now;
	}
	// Not 0.2 over its ground, but over the root's; and it went there smoothly.
	float shift = run.out.pelvisOffset_w.y;
	soleVec3 was = testAnimatedJoint( &run, biped_ankleL ).translation;
	testNear3( testPlacedJoint( &run, biped_ankleL ).translation, was, 3e-3f );
	assert_true( shift > -0.01f && largest < 0.025f );
	run.settings.target.flight = 1.0f;
	testStepSeconds( &run, 1.0f );
	assert_float_equal( overGround( &run, 0 ), 0.28f, 3e-3f );
	testEndRun( &run );
}

static void aCharacterThatMovesIsAsAnimatedWhereSettingsSaySo( void** state )
{
	(void)state;
	static testRun run;
	begin( &run, "effector", 0.5f );
	run.ground.stepX = -0.1f;
	testStepSeconds( &run, 1.5f );
	assert_float_equal( overGround( &run, 0 ), 0.08f, 3e-3f );
	float largest = 0.0f;
	for ( int32_t i = 0; i < 60; ++i )
	{
		soleVec3 last = testPlacedJoint( &run, biped_ankleL ).translation;
		run.frame.root.translation.z += 0.01f;
		testStepRun( &run );
		soleVec3 now = testPlacedJoint( &run, biped_ankleL ).translation;
		largest = fmaxf( largest, fabsf( now.y - last.y ) );
	}
	assert_true( testLargestMove( &run.biped, run.placed, run.pose ) < 1e-5f );
	assert_true( largest < 0.03f );
	testStepSeconds( &run, 1.5f );
	assert_float_equal( overGround( &run, 0 ), 0.08f, 3e-3f );
	testEndRun( &run );
}

static void aFootWhoseGroundIsOutOfReachIsGivenBack( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.3f );
	run.settings.target.unreachable = 0.0f;
	run.settings.pelvis.down = 0.1f;
	run.settings.probe.stepDown = 1.0f;
	testStepSeconds( &run, 0.5f );
	uint32_t low = (uint32_t)sole_legTooLow;
	assert_int_equal( run.out.legs[0].flags & low, 0 );
	// Down bit by bit, until the leg has it no more; and back.
	float lost = 0.0f, found = 0.0f, largest = 0.0f;
	for ( int32_t i = 0; i < 1200; ++i )
	{
		run.ground.stepX = -0.6f * (float)( i < 600 ? i : 1200 - i ) / 600.0f;
		float last = testPlacedJoint( &run, biped_ankleL ).translation.y;
		testStepRun( &run );
		largest = fmaxf( largest, fabsf( testPlacedJoint( &run, biped_ankleL ).translation.y - last ) );
		bool is = ( run.out.legs[0].flags & low ) != 0;
		lost = is && lost == 0.0f ? run.ground.stepX : lost;
		found = lost != 0.0f && i > 600 && is == false && found == 0.0f ? run.ground.stepX : found;
		if ( i == 600 )
		{
			float y = testPlacedJoint( &run, biped_ankleL ).translation.y;
			assert_float_equal( y, testAnimatedJoint( &run, biped_ankleL ).translation.y, 3e-3f );
			assert_int_equal( run.out.legs[1].flags & low, 0 );
		}
	}
	// The bent leg has 1 cm left, the pelvis 9 more.
	assert_true( lost < -0.09f && lost > -0.2f );
	assert_true( found > lost + 0.02f );
	assert_true( largest < 0.04f );
	assert_float_equal( overGround( &run, 0 ), 0.08f, 3e-3f );
	testEndRun( &run );
}

static void groundThatIsTooSteepIsGivenBackAndTakenAgain( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.6f );
	run.settings.target.unreachable = 0.0f;
	for ( int32_t i = 0; i < 3; ++i )
	{
		bool far = i == 1;
		run.ground.slopeZ = far ? 1.5f : 0.3f;
		testStepSeconds( &run, 2.0f );
		assert_int_equal( ( run.out.legs[0].flags & (uint32_t)sole_legTooSteep ) != 0, far );
		float turned = testLargestTurn( run.placed, run.pose );
		assert_true( far ? turned < 1e-3f : turned > 0.2f );
	}
	testEndRun( &run );
}

static void groundThatIsTooHighIsToldAsSuch( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.3f );
	run.settings.probe.stepUp = 1.0f;
	run.ground.stepX = 0.8f;
	testStepSeconds( &run, 0.5f );
	assert_true( ( run.out.legs[0].flags & (uint32_t)sole_legTooHigh ) != 0 );
	assert_int_equal( run.out.legs[0].flags & (uint32_t)sole_legTooLow, 0 );
	assert_int_equal( run.out.legs[1].flags & (uint32_t)( sole_legTooHigh | sole_legTooLow ), 0 );
	testEndRun( &run );
}

// ------------------------------------------------------------------------------------------------------------ pelvis

static void thePelvisIsMovedByWhomTheSettingSays( void** state )
{
	(void)state;
	static testRun run;
	soleVec3 offsets[3];
	for ( int32_t mode = 0; mode < 3; ++mode )
	{
		testStartRun( &run, 0.4f );
		run.settings.pelvis.mode = (solePelvisMode)mode;
		run.ground.stepX = -0.2f;
		testStepSeconds( &run, 2.0f );
		offsets[mode] = run.out.pelvisOffset_w;
		if ( mode == (int32_t)sole_pelvisRoot )
		{
			testNear3( run.out.pelvisTranslation_l, run.pose[biped_pelvis].translation, 0.0f );
			run.frame.root.translation = soleAdd( run.frame.root.translation, run.out.pelvisOffset_w );
		}
		else if ( mode == (int32_t)sole_pelvisReport )
		{
			testNear3( run.out.pelvisTranslation_l, run.pose[biped_pelvis].translation, 0.0f );
			// The left leg does what it can.
			assert_true( run.out.legs[0].error > 0.05f );
			assert_float_equal( overGround( &run, 1 ), 0.08f, 2e-3f );
			testEndRun( &run );
			continue;
		}
		assert_float_equal( overGround( &run, 0 ), 0.08f, 3e-3f );
		assert_float_equal( overGround( &run, 1 ), 0.08f, 3e-3f );
		testEndRun( &run );
	}
	assert_true( offsets[0].y < -0.1f );
	testNear3( offsets[1], offsets[0], 0.0f );
	testNear3( offsets[2], offsets[0], 0.02f );
}

static void thePelvisGoesWithTheFeetThatTheSettingSays( void** state )
{
	(void)state;
	static testRun run;
	const float expected[] = { -0.06f, -0.06f, -0.12f };
	for ( int32_t follow = 0; follow < 3; ++follow )
	{
		testStartRun( &run, 1.0f );
		run.settings.pelvis.follow = (solePelvisFollow)follow;
		run.ground.stepX = -0.12f;
		testStepSeconds( &run, 2.0f );
		assert_float_equal( run.out.pelvisOffset_w.y, expected[follow], 3e-3f );
		// The lower foot leaves: planted feet alone, or the line still through both.
		liftFoot( &run, 0, 0.3f );
		testStepSeconds( &run, 2.0f );
		assert_float_equal( run.out.pelvisOffset_w.y, follow == 1 ? 0.0f : expected[follow], 3e-3f );
		testEndRun( &run );
	}
}

static void aHostIsToldHowFarItsRootIsOffTheGround( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.4f );
	run.ground.slopeZ = 0.2f;
	const float z[] = { 0.0f, 1.0f, -1.2f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		run.frame.root.translation.z = z[k];
		run.frame.teleport = true;
		for ( int32_t i = 0; i < 30; ++i )
		{
			testStepRun( &run );
			run.frame.root.translation.y += run.out.groundOffset;
			run.frame.teleport = false;
		}
		// Its feet stand a little ahead of it.
		float under = testGroundHeight( &run.ground, 0.0f, z[k] );
		assert_float_equal( run.frame.root.translation.y, under, 0.03f );
		assert_float_equal( run.out.groundOffset, 0.0f, 1e-4f );
	}
	testEndRun( &run );
}

static void effectorsAreFoundInTheCharactersOwnScaledSpace( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.5f );
	run.frame.root.scale = soleVec( 1.6f, 1.6f, 1.6f );
	run.frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.8f );
	run.frame.root.translation = soleVec( 3.0f, 0.0f, -2.0f );
	run.ground.slopeX = 0.1f;
	run.frame.root.translation.y = testGroundHeight( &run.ground, 3.0f, -2.0f );
	testStepSeconds( &run, 1.0f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleVec3 effector = soleInvTransformPoint( run.frame.root, run.out.legs[leg].ankle_w );
		soleTransform ankle = testJoint( &run.biped, run.placed, soleTransform_Identity(), testAnkle( leg ) );
		testNear3( effector, ankle.translation, 1e-4f );
	}
	testEndRun( &run );
}

// ------------------------------------------------------------------------------------------------------------- sleep

/// Probes with a length in the next frame, of one leg.
static int32_t countAsked( testRun* run, int32_t leg )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	int32_t n = soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
	int32_t asked = 0;
	for ( int32_t i = 0; i < n; ++i )
	{
		asked += probes[i].leg == leg && probes[i].length > 0.0f ? 1 : 0;
	}
	return asked;
}

static void aFootThatStandsFallsAsleepAndWakesUp( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.5f );
	run.settings.probe.sleep = 1.0f;
	testStepSeconds( &run, 0.9f );
	assert_int_equal( countAsked( &run, 0 ), 5 );
	testStepSeconds( &run, 0.5f );
	assert_int_equal( countAsked( &run, 0 ), 1 );
	assert_true( ( run.out.legs[0].flags & (uint32_t)sole_legAsleep ) != 0 );
	soleTransform asleep[biped_count];
	memcpy( asleep, run.placed, sizeof asleep );
	testStepSeconds( &run, 1.0f );
	assert_memory_equal( asleep, run.placed, sizeof asleep );
	// Its ground moves: it is there at once, and sleeps again.
	run.ground.stepX = 0.05f;
	testStepSeconds( &run, 0.5f );
	assert_float_equal( overGround( &run, 0 ), 0.08f, 1e-3f );
	assert_int_equal( countAsked( &run, 0 ), 1 );
	// The animation moves it.
	liftFoot( &run, 0, 0.1f );
	testStepSeconds( &run, 0.2f );
	assert_true( countAsked( &run, 0 ) >= 5 );
	assert_int_equal( run.out.legs[0].flags & (uint32_t)sole_legAsleep, 0 );
	assert_int_equal( countAsked( &run, 1 ), 1 );
	testEndRun( &run );
}

// ------------------------------------------------------------------------------------------------------------ set-up

static void aGroundThatIsNeverMetIsTold( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.3f );
	testStepSeconds( &run, 1.0f );
	assert_float_equal( run.out.unmetTime, 0.0f, 0.0f );
	run.ground.hole = -5.0f; // nothing anywhere: a wrong mask
	testStepSeconds( &run, 1.5f );
	assert_float_equal( run.out.unmetTime, 1.5f, 0.01f );
	run.ground.hole = 1e9f;
	testStepRun( &run );
	assert_float_equal( run.out.unmetTime, 0.0f, 0.0f );
	testEndRun( &run );
}

static void oneProbeAFootFollowsARamp( void** state )
{
	(void)state;
	// It asked three places of eighteen when it read its foothold closely, and stood level.
	static testRun run;
	const testWalk walk = { .speed = 1.0f, .period = 1.0f, .lift = 0.1f };
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	testStartRun( &run, 0.0f );
	run.settings.probe.layout = sole_probeSingle;
	run.settings.contact.lockDistance = 0.0f;
	run.ground.slopeZ = 0.3f;
	float worst = 0.0f;
	for ( int32_t i = 0; i < 240; ++i )
	{
		float time = (float)i / 60.0f;
		run.frame.root.translation = soleVec( 0.0f, 0.3f * time, time );
		testWalkOn( &run, &walk, time, contacts, inputs );
		for ( int32_t leg = 0; leg < 2 && i > 60; ++leg )
		{
			bool down = contacts[leg].heel > 0.5f && testWalkPhase( &walk, time, leg ) > 0.15f;
			worst = down ? fmaxf( worst, fabsf( testSoleClearance( &run, leg ) ) ) : worst;
		}
	}
	assert_true( worst < 0.01f );
	testEndRun( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyPresetIsReadAndPutsStandingFeetOnAStep ),
		cmocka_unit_test( noPresetMovesAFootSideways ),
		cmocka_unit_test( aFootOverNothingStaysAsItIsAndDoesNotCount ),
		cmocka_unit_test( solesAreKeptAsFarOverTheGroundAsIsSet ),
		cmocka_unit_test( groundTiltsAFootNoFurtherThanIsSet ),
		cmocka_unit_test( withoutAlignmentAFootKeepsItsTurnButNotItsHeight ),
		cmocka_unit_test( aFootInFlightIsAsAnimatedWhereSettingsSaySo ),
		cmocka_unit_test( aCharacterThatMovesIsAsAnimatedWhereSettingsSaySo ),
		cmocka_unit_test( aFootWhoseGroundIsOutOfReachIsGivenBack ),
		cmocka_unit_test( groundThatIsTooSteepIsGivenBackAndTakenAgain ),
		cmocka_unit_test( groundThatIsTooHighIsToldAsSuch ),
		cmocka_unit_test( thePelvisIsMovedByWhomTheSettingSays ),
		cmocka_unit_test( thePelvisGoesWithTheFeetThatTheSettingSays ),
		cmocka_unit_test( aHostIsToldHowFarItsRootIsOffTheGround ),
		cmocka_unit_test( effectorsAreFoundInTheCharactersOwnScaledSpace ),
		cmocka_unit_test( aFootThatStandsFallsAsleepAndWakesUp ),
		cmocka_unit_test( aGroundThatIsNeverMetIsTold ),
		cmocka_unit_test( oneProbeAFootFollowsARamp ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
