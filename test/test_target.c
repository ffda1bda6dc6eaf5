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

/// Turns the left foot up about its heel by an angle, the ankle with it.
static void raiseToes( testRun* run, float angle )
{
	soleVec3 heel = soleRig_GetLeg( run->biped.rig, 0 ).sole.heel;
	soleVec3 ankle = testJoint( &run->biped, run->pose, soleTransform_Identity(), biped_ankleL ).translation;
	float over = ankle.y - heel.y, ahead = ankle.z - heel.z;
	float up = over * cosf( angle ) + ahead * sinf( angle );
	float hip = run->pose[biped_pelvis].translation.y - 0.02f;
	testPutAnkle( run->pose, biped_hipL, hip - up, heel.z + ahead * cosf( angle ) - over * sinf( angle ) );
	soleQuat foot = run->pose[biped_ankleL].rotation;
	run->pose[biped_ankleL].rotation = soleMulQuat( foot, testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -angle ) );
}

/// Stands on its left heel, toes up, on ground that rises steeply ahead.
/// @return where the heel is, seen from the root
static soleVec3 standOnHeel( testRun* run, float dorsiflexion )
{
	testStartRun( run, 0.6f );
	soleDestroyRig( run->biped.rig );
	soleRigDef def = testBipedDef( &run->biped );
	def.legs[0].ankleLimits.dorsiflexion = dorsiflexion;
	assert_int_equal( soleCreateRig( &def, NULL, &run->biped.rig, NULL ), sole_success );
	run->ground.slopeZ = 0.6f;
	raiseToes( run, 0.3f );
	soleContactInput contacts[2] = { { 1.0f, 0.0f }, { 1.0f, 1.0f } };
	run->frame.contact = contacts;
	testStepSeconds( run, 0.5f );
	assert_true( ( run->out.legs[0].flags & (uint32_t)sole_legPlanted ) != 0 );
	return testPlacedPoint( run, 0, soleRig_GetLeg( run->biped.rig, 0 ).sole.heel, false );
}

/// What an ankle cannot do turns the foot: about its heel, if it stands on that. It went 14 mm down the slope.
static void aHeelStaysWhereItIsHeldWhenItsAnkleIsAtItsLimit( void** state )
{
	(void)state;
	static testRun run;
	soleVec3 free = standOnHeel( &run, 1.5f );
	assert_true( ( run.out.legs[0].flags & (uint32_t)sole_legAnkleClamped ) == 0 );
	testEndRun( &run );
	soleVec3 limited = standOnHeel( &run, 0.8f );
	assert_true( ( run.out.legs[0].flags & (uint32_t)sole_legAnkleClamped ) != 0 );
	testNear3( limited, free, 2e-3f );
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
		cmocka_unit_test( aHeelStaysWhereItIsHeldWhenItsAnkleIsAtItsLimit ),
		cmocka_unit_test( itComesAndGoesSmoothly ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
