// SPDX-License-Identifier: MIT
// What the character is doing, as it is told, and how strongly its feet are placed for that: graded by speed and by
// height over the ground, continuous, and nothing at all where the shares are one.
#include "biped_walk.h"

#define LEG 0.9f

/// Goes straight on at a speed for some time, over ground that leans sideways.
static void go( testRun* run, float speed, float seconds )
{
	int32_t count = (int32_t)( seconds / run->frame.timeStep + 0.5f );
	for ( int32_t i = 0; i < count; ++i )
	{
		run->frame.root.translation.z += speed * run->frame.timeStep;
		testStepRun( run );
	}
}

static void start( testRun* run )
{
	testStartRun( run, 0.5f );
	run->ground.slopeX = 0.25f;
	run->settings.activity.running = 0.25f;
	run->settings.activity.airborne = 0.0f;
}

static float share( float speed )
{
	static testRun run;
	start( &run );
	go( &run, speed, 1.0f );
	testEndRun( &run );
	return run.out.strength;
}

static void strengthFallsWithSpeedToTheRunningShare( void** state )
{
	(void)state;
	soleSettings s = soleDefaultSettings();
	float slow = s.activity.slow * LEG;
	float fast = s.activity.fast * LEG;
	assert_float_equal( share( 0.0f ), 1.0f, 0.0f );
	assert_float_equal( share( 0.98f * slow ), 1.0f, 1e-6f );
	assert_float_equal( share( 0.5f * ( slow + fast ) ), 0.625f, 2e-3f );
	assert_float_equal( share( 1.02f * fast ), 0.25f, 1e-3f );
	float last = 1.0f;
	for ( int32_t i = 0; i <= 20; ++i )
	{
		float now = share( slow + 0.05f * (float)i * ( fast - slow ) );
		assert_true( now <= last + 1e-6f && now > last - 0.08f );
		last = now;
	}
}

static void theRunningShareIsWhatFeetKeep( void** state )
{
	(void)state;
	static testRun run;
	float raised[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		start( &run );
		run.settings.contact.lockDistance = 0.0f;
		run.settings.pelvis.mode = sole_pelvisReport;
		go( &run, k == 0 ? 0.0f : 6.0f, 2.0f );
		float y = testPlacedJoint( &run, biped_ankleL ).translation.y;
		raised[k] = y - testAnimatedJoint( &run, biped_ankleL ).translation.y;
		testEndRun( &run );
	}
	assert_true( raised[0] > 0.015f );
	assert_float_equal( raised[1], 0.25f * raised[0], 0.1f * raised[0] );
}

static void statesAreToldWithHysteresis( void** state )
{
	(void)state;
	static testRun run;
	start( &run );
	soleSettings s = run.settings;
	float between = 0.5f * LEG * ( s.activity.slow + s.activity.fast );
	go( &run, 0.0f, 0.5f );
	assert_int_equal( run.out.activity, sole_standing );
	go( &run, between, 0.5f );
	assert_int_equal( run.out.activity, sole_moving );
	go( &run, 1.05f * LEG * s.activity.fast, 0.5f );
	assert_int_equal( run.out.activity, sole_running );
	go( &run, between, 0.5f );
	assert_int_equal( run.out.activity, sole_running );
	go( &run, 0.95f * LEG * s.activity.slow, 0.5f );
	assert_int_equal( run.out.activity, sole_moving );
	go( &run, 0.0f, 0.5f );
	assert_int_equal( run.out.activity, sole_standing );
	float heights[] = { 0.3f, 0.45f, 0.3f, 0.15f };
	const soleActivity told[] = { sole_standing, sole_airborne, sole_airborne, sole_standing };
	for ( int32_t i = 0; i < 4; ++i )
	{
		run.frame.root.translation.y = heights[i] * LEG + 0.09f * run.ground.slopeX;
		go( &run, 0.0f, 0.5f );
		assert_int_equal( run.out.activity, told[i] );
	}
	testEndRun( &run );
}

/// A jump of half a second, straight up and back, from a slope.
static void jump( testRun* run, float rate, float* turned, float* leastStrength )
{
	soleTransform last[biped_count];
	start( run );
	run->frame.timeStep = 1.0f / rate;
	go( run, 0.0f, 1.0f );
	*turned = 0.0f;
	*leastStrength = 1.0f;
	for ( int32_t i = 1; i <= (int32_t)rate; ++i )
	{
		float time = fminf( (float)i / rate, 0.7f );
		run->frame.root.translation.y = 0.5f * 9.81f * time * ( 0.7f - time );
		memcpy( last, run->placed, sizeof last );
		testStepRun( run );
		*turned = fmaxf( *turned, testLargestTurn( run->placed, last ) );
		*leastStrength = fminf( *leastStrength, run->out.strength );
	}
}

static void aJumpTakesThePlacementOutAndBringsItBackSmoothly( void** state )
{
	(void)state;
	static testRun run;
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		float turned, least;
		jump( &run, rates[k], &turned, &least );
		assert_true( least < 0.1f );
		// Of half a radian that blends in and out in 0.15 s and more.
		assert_true( turned < 4.0f / rates[k] + 0.01f );
		go( &run, 0.0f, 1.0f );
		assert_float_equal( run.out.strength, 1.0f, 1e-3f );
		assert_true( fabsf( testSoleClearance( &run, 0 ) ) < 2e-3f );
		testEndRun( &run );
	}
}

static void aSpeedThatIsKnownInStepsIsGradedByItsMean( void** state )
{
	(void)state;
	// A root that is known at 50 Hz under frames of 150: it moves in every third.
	static testRun run;
	start( &run );
	run.frame.timeStep = 1.0f / 150.0f;
	float low = 1.0f;
	float high = 0.0f;
	for ( int32_t i = 0; i < 600; ++i )
	{
		run.frame.root.translation.z += i % 3 == 0 ? 1.2f * LEG / 50.0f : 0.0f;
		testStepRun( &run );
		low = i > 300 ? fminf( low, run.out.strength ) : low;
		high = i > 300 ? fmaxf( high, run.out.strength ) : high;
	}
	assert_true( high - low < 0.06f );
	testEndRun( &run );
}

static void noGroundAtAllIsInTheAir( void** state )
{
	(void)state;
	static testRun run;
	start( &run );
	run.ground.hole = -5.0f;
	testStepSeconds( &run, 1.0f );
	assert_int_equal( run.out.activity, sole_airborne );
	assert_true( run.out.strength < 1e-3f );
	testEndRun( &run );
}

static void aWalkIsNeverInTheAir( void** state )
{
	(void)state;
	static testRun run;
	const testWalk walk = { .speed = 1.4f, .period = 1.0f, .lift = 0.2f };
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	testStartRun( &run, 0.0f );
	run.ground = testFlatGround;
	run.ground.stairs = 1.0f;
	run.ground.tread = 0.29f;
	run.ground.rise = -0.17f; // down
	for ( int32_t i = 0; i < 240; ++i )
	{
		float time = (float)i / 60.0f;
		float z = walk.speed * time;
		run.frame.root.translation = soleVec( 0.0f, testGroundHeight( &run.ground, 0.0f, z ), z );
		testWalkOn( &run, &walk, time, contacts, inputs );
		assert_true( run.out.activity == sole_moving || i == 0 );
		assert_float_equal( run.out.strength, 1.0f, 0.0f );
	}
	testEndRun( &run );
}

static void theFlightOfARunIsNoJump( void** state )
{
	(void)state;
	// Both feet in the air at once, on their way to footholds that are foreseen: not much is asked of the ground then.
	static testRun run;
	const soleContactInput down[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	const soleContactInput free[2] = { { 0.0f, 0.0f }, { 0.0f, 0.0f } };
	soleStepInput steps[2];
	start( &run );
	run.frame.contact = down;
	go( &run, 3.0f, 0.3f );
	run.frame.contact = free;
	run.frame.steps = steps;
	for ( int32_t i = 0; i < 12; ++i )
	{
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 ball = soleRig_GetLeg( run.biped.rig, leg ).sole.ball;
			float until = 0.3f - (float)i / 60.0f;
			ball.z += 3.0f * until;
			steps[leg] =
			    ( soleStepInput ){ (float)i / 60.0f, until, ball, { 0.0f, 0.0f, 1.0f }, { 0.0f, 0.0f, 3.0f * until } };
		}
		go( &run, 3.0f, 1.0f / 60.0f );
		assert_int_equal( run.out.activity, sole_moving );
		assert_true( run.out.strength > 0.6f );
	}
	testEndRun( &run );
}

static void withSharesOfOneNothingIsDifferentToTheBit( void** state )
{
	(void)state;
	static testRun runs[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( runs + k, 0.5f );
		runs[k].ground.slopeX = 0.25f;
		// The bounds alone change nothing.
		runs[k].settings.activity.slow = k == 0 ? 2.5f : 0.0f;
		runs[k].settings.activity.fast = k == 0 ? 4.5f : 0.1f;
		runs[k].settings.activity.high = k == 0 ? 0.4f : 0.0f;
	}
	for ( int32_t i = 0; i < 120; ++i )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			runs[k].frame.root.translation.y = i > 40 && i < 60 ? 0.3f : 0.0f;
			go( runs + k, i < 30 ? 0.0f : 5.0f, 1.0f / 60.0f );
		}
		assert_memory_equal( runs[0].placed, runs[1].placed, sizeof runs[0].placed );
	}
	testEndRun( runs + 0 );
	testEndRun( runs + 1 );
}

/// A jump, 0.8 s from the ground to the ground, 0.78 m high. @return how far ankle and pelvis were off the animation's
/// places, furthest, while the root was higher than that
static float leap( testRun* run, float rate, float speed, bool told, float over )
{
	soleContactInput down[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	soleContactInput up[2] = { { 0.0f, 0.0f }, { 0.0f, 0.0f } };
	soleStepInput steps[2];
	testStartRun( run, 0.5f );
	run->frame.timeStep = 1.0f / rate;
	run->frame.contact = down;
	go( run, 0.0f, 1.0f );
	run->frame.contact = up;
	float furthest = 0.0f;
	for ( int32_t i = 1; (float)i < 0.8f * rate; ++i )
	{
		float time = (float)i / rate;
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			float until = 0.8f - time;
			steps[leg] =
			    ( soleStepInput ){ .since = time, .until = until, .travel = soleVec( 0.0f, 0.0f, speed * until ) };
			steps[leg].place = soleVec( leg == 0 ? 0.1f : -0.1f, 0.0f, speed * until );
			steps[leg].forward = soleVec( 0.0f, 0.0f, 1.0f );
		}
		run->frame.steps = told ? steps : NULL;
		run->frame.root.translation.y = 0.5f * 9.81f * time * ( 0.8f - time );
		go( run, speed, run->frame.timeStep );
		float ankle = testPlacedJoint( run, biped_ankleL ).translation.y;
		float off = fabsf( ankle - testAnimatedJoint( run, biped_ankleL ).translation.y );
		off = fmaxf( off, fabsf( run->out.pelvisOffset_w.y ) );
		furthest = fmaxf( furthest, run->frame.root.translation.y > over ? off : 0.0f );
	}
	run->frame.contact = down;
	run->frame.steps = NULL;
	run->frame.root.translation.y = 0.0f;
	testStepRun( run );
	assert_true( fabsf( run->out.pelvisOffset_w.y ) < 0.04f );
	testEndRun( run );
	return furthest;
}

/// Whoever jumps or falls, and whose clip has no foot down, goes with the root: the body stayed on the ground through
/// the whole jump, and came down from a fall at the pelvis' own speed.
static void aBodyInTheAirGoesWithItsRoot( void** state )
{
	(void)state;
	static testRun run;
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		assert_true( leap( &run, rates[k], 0.0f, false, 0.3f ) < 0.04f );
		assert_true( leap( &run, rates[k], 3.0f, false, 0.7f ) < 0.04f );
		assert_true( leap( &run, rates[k], 3.0f, true, 0.7f ) < 0.04f );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( strengthFallsWithSpeedToTheRunningShare ),
		cmocka_unit_test( theRunningShareIsWhatFeetKeep ),
		cmocka_unit_test( statesAreToldWithHysteresis ),
		cmocka_unit_test( aJumpTakesThePlacementOutAndBringsItBackSmoothly ),
		cmocka_unit_test( aSpeedThatIsKnownInStepsIsGradedByItsMean ),
		cmocka_unit_test( noGroundAtAllIsInTheAir ),
		cmocka_unit_test( aWalkIsNeverInTheAir ),
		cmocka_unit_test( theFlightOfARunIsNoJump ),
		cmocka_unit_test( withSharesOfOneNothingIsDifferentToTheBit ),
		cmocka_unit_test( aBodyInTheAirGoesWithItsRoot ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
