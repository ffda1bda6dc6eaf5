// SPDX-License-Identifier: MIT
// Targets, from outside: feet that their clip leaves tilted while they stand are laid flat, and no others are touched.
#include "biped_walk.h"

/// Raises the left heel about the ball's joint by an angle, the ankle with it.
static void raiseHeel( testRun* run, float angle )
{
	soleVec3 x = soleVec( 1.0f, 0.0f, 0.0f );
	// The ankle is 0.06 over and 0.12 behind the toe joint.
	float down = 0.06f * cosf( angle ) + 0.12f * sinf( angle );
	float ahead = 0.12f - ( 0.12f * cosf( angle ) - 0.06f * sinf( angle ) );
	float hip = run->pose[biped_pelvis].translation.y;
	testPutAnkle( run->pose, biped_hipL, hip - 0.02f - down, ahead );
	soleQuat foot = run->pose[biped_ankleL].rotation;
	run->pose[biped_ankleL].rotation = soleMulQuat( foot, testTurn( x, angle ) );
	run->pose[biped_toeL].rotation = testTurn( x, -angle );
}

/// How far the heel is over the ball line, m.
static float findTilt( const testRun* run, int32_t leg )
{
	soleSolePoints sole = soleRig_GetLeg( run->biped.rig, leg ).sole;
	float heel = testPlacedPoint( run, leg, sole.heel, false ).y;
	return heel - testPlacedPoint( run, leg, sole.ball, true ).y;
}

static void aHeelThatItsClipLeavesOffTheFloorIsPutDown( void** state )
{
	(void)state;
	static testRun run;
	const float limits[] = { 0.1f, 0.0f, 0.03f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		testStartRun( &run, 0.4f );
		run.settings.target.flatten = limits[k];
		raiseHeel( &run, 0.07f );
		soleContactInput contacts[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
		run.frame.contact = contacts;
		testStepSeconds( &run, 1.0f );
		float left = fmaxf( 0.07f - limits[k], 0.0f );
		assert_float_equal( findTilt( &run, 0 ), 0.19f * sinf( left ), 1.5e-3f );
		assert_float_equal( findTilt( &run, 1 ), 0.0f, 1e-4f );
		testEndRun( &run );
	}
}

static void aHeelThatIsMeantToBeUpStaysUp( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.4f );
	raiseHeel( &run, 0.4f );
	soleContactInput contacts[2] = { { 0.0f, 1.0f }, { 1.0f, 1.0f } };
	run.frame.contact = contacts;
	testStepSeconds( &run, 1.0f );
	assert_float_equal( findTilt( &run, 0 ), 0.19f * sinf( 0.4f ), 3e-3f );
	testEndRun( &run );
}

static void itComesAndGoesSmoothly( void** state )
{
	(void)state;
	static testRun run;
	testStartRun( &run, 0.4f );
	raiseHeel( &run, 0.07f );
	soleContactInput contacts[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	run.frame.contact = contacts;
	testStepSeconds( &run, 0.5f );
	float last = findTilt( &run, 0 ), largest = 0.0f, highest = 0.0f;
	for ( int32_t i = 0; i < 60; ++i )
	{
		contacts[0].heel = i < 20 ? 0.0f : 1.0f;
		testStepRun( &run );
		float tilt = findTilt( &run, 0 );
		largest = fmaxf( largest, fabsf( tilt - last ) );
		highest = fmaxf( highest, tilt );
		last = tilt;
	}
	assert_true( highest > 0.012f && last < 1e-3f );
	// A third of the way in a frame; at once it would be all of it, 13 mm.
	assert_true( largest < 5e-3f );
	testEndRun( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aHeelThatItsClipLeavesOffTheFloorIsPutDown ),
		cmocka_unit_test( aHeelThatIsMeantToBeUpStaysUp ),
		cmocka_unit_test( itComesAndGoesSmoothly ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
