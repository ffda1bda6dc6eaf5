// SPDX-License-Identifier: MIT
// Weights of the whole, of a leg, of place and turn alone: a host may let them jump, the pose does not. From outside,
// by forward kinematics, on a slope with a step on which the placed pose is far from the animated one.
#include "placing.h"

typedef enum Part
{
	partWhole,
	partLeft,
	partPosition,
	partRotation,
	partCount
} Part;

typedef struct Weighted
{
	testRun run;
	float leg[2];
	float position[2];
	float rotation[2];
	soleTransform full[biped_count]; // as placed with all weights 1
} Weighted;

static void setWeight( Weighted* w, Part part, float value )
{
	float* pairs[] = { NULL, NULL, w->position, w->rotation };
	if ( part == partWhole )
	{
		w->run.frame.weight = value;
	}
	else if ( part == partLeft )
	{
		w->leg[0] = value;
	}
	else
	{
		pairs[part][0] = value;
		pairs[part][1] = value;
	}
}

/// Stands for two seconds with all weights 1.
static void start( Weighted* w )
{
	memset( w, 0, sizeof *w );
	testRun* run = &w->run;
	testStartRun( run, 0.5f );
	run->ground.slopeX = 0.1f;
	run->ground.slopeZ = 0.25f;
	run->ground.stepX = 0.1f;
	run->frame.legWeight = w->leg;
	run->frame.positionWeight = w->position;
	run->frame.rotationWeight = w->rotation;
	for ( int32_t i = 0; i < 2; ++i )
	{
		w->leg[i] = 1.0f;
		w->position[i] = 1.0f;
		w->rotation[i] = 1.0f;
	}
	testStepSeconds( run, 2.0f );
	memcpy( w->full, run->placed, sizeof w->full );
	assert_true( testLargestTurn( w->full, run->pose ) > 0.3f );
}

static void nearPose( const Weighted* w, const soleTransform* expected, float angle, float distance )
{
	assert_true( testLargestTurn( w->run.placed, expected ) <= angle );
	assert_true( testLargestMove( &w->run.biped, w->run.placed, expected ) <= distance );
}

/// Largest turn and move of a joint in a frame while a weight jumps to and fro.
static void jumpAbout( Part part, float* turned, float* moved )
{
	static Weighted w;
	soleTransform last[biped_count];
	start( &w );
	*turned = 0.0f;
	*moved = 0.0f;
	for ( int32_t jump = 0; jump < 4; ++jump )
	{
		setWeight( &w, part, jump % 2 == 0 ? 0.0f : 1.0f );
		// The third and fourth come before the blending is over.
		for ( int32_t i = 0; i < ( jump < 2 ? 60 : 5 ); ++i )
		{
			memcpy( last, w.run.placed, sizeof last );
			testStepRun( &w.run );
			*turned = fmaxf( *turned, testLargestTurn( w.run.placed, last ) );
			*moved = fmaxf( *moved, testLargestMove( &w.run.biped, w.run.placed, last ) );
		}
	}
	testEndRun( &w.run );
}

static void noWeightThatJumpsMakesAJointJump( void** state )
{
	(void)state;
	for ( int32_t part = 0; part < partCount; ++part )
	{
		float turned, moved;
		jumpAbout( (Part)part, &turned, &moved );
		// The whole way in one frame is 0.5 rad and 0.2 m; spread evenly over blendOut it is a ninth.
		assert_true( turned < 0.12f && moved < 0.025f );
		assert_true( turned > 0.01f );
	}
}

static void weightZeroIsTheAnimatedPoseAndOneThePlacedPose( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	for ( int32_t round = 0; round < 3; ++round )
	{
		setWeight( &w, partWhole, 0.0f );
		testStepSeconds( &w.run, 0.5f );
		nearPose( &w, w.run.pose, 1e-6f, 1e-6f );
		setWeight( &w, partWhole, 1.0f );
		testStepSeconds( &w.run, 2.0f );
		nearPose( &w, w.full, 1e-5f, 1e-5f );
	}
	testEndRun( &w.run );
}

static void aCharacterThatStartsWithoutWeightIsAnimated( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	w.run.state = soleDefaultState( w.run.biped.rig );
	setWeight( &w, partWhole, 0.0f );
	testStepRun( &w.run );
	nearPose( &w, w.run.pose, 1e-6f, 1e-6f );
	w.run.frame.teleport = true;
	setWeight( &w, partWhole, 1.0f );
	testStepRun( &w.run );
	w.run.frame.teleport = false;
	// A new start blends nothing: there is nothing to blend from.
	assert_true( testLargestTurn( w.run.placed, w.run.pose ) > 0.3f );
	testEndRun( &w.run );
}

static void turnAloneTurnsTheFootAndLeavesTheAnkle( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	setWeight( &w, partPosition, 0.0f );
	testStepSeconds( &w.run, 1.0f );
	soleVec3 up = soleNormalizeOr( soleVec( -0.1f, 1.0f, -0.25f ), w.run.frame.up );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleTransform animated = testAnimatedJoint( &w.run, testAnkle( leg ) );
		soleTransform placed = testPlacedJoint( &w.run, testAnkle( leg ) );
		testNear3( placed.translation, animated.translation, 1e-5f );
		// The foot is level as animated: its own up is now that of the slope.
		soleVec3 footUp = soleRotate( placed.rotation, soleInvRotate( animated.rotation, w.run.frame.up ) );
		testNear3( footUp, up, 1e-3f );
	}
	testEndRun( &w.run );
}

static void placeAloneMovesTheAnkleAndLeavesTheTurn( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	setWeight( &w, partRotation, 0.0f );
	testStepSeconds( &w.run, 1.0f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		int32_t ankle = testAnkle( leg );
		soleTransform placed = testPlacedJoint( &w.run, ankle );
		soleTransform full = testJoint( &w.run.biped, w.full, w.run.frame.root, ankle );
		assert_true( testAngle( placed.rotation, testAnimatedJoint( &w.run, ankle ).rotation ) < 1e-4f );
		testNear3( placed.translation, full.translation, 1e-3f );
	}
	testEndRun( &w.run );
}

static void legsHaveWeightsOfTheirOwn( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	setWeight( &w, partLeft, 0.0f );
	testStepSeconds( &w.run, 2.0f );
	soleTransform left = testPlacedJoint( &w.run, biped_ankleL );
	soleTransform animated = testAnimatedJoint( &w.run, biped_ankleL );
	testNear3( left.translation, animated.translation, 1e-4f );
	assert_true( testAngle( left.rotation, animated.rotation ) < 1e-4f );
	soleTransform right = testPlacedJoint( &w.run, biped_ankleR );
	soleTransform full = testJoint( &w.run.biped, w.full, w.run.frame.root, biped_ankleR );
	testNear3( right.translation, full.translation, 1e-3f );
	assert_true( testAngle( right.rotation, full.rotation ) < 1e-2f );
	testEndRun( &w.run );
}

/// How much of the way from the animated to the placed ankle is gone.
static float findShare( const Weighted* w )
{
	soleVec3 animated = testAnimatedJoint( &w->run, biped_ankleL ).translation;
	soleVec3 full = testJoint( &w->run.biped, w->full, w->run.frame.root, biped_ankleL ).translation;
	soleVec3 placed = testPlacedJoint( &w->run, biped_ankleL ).translation;
	return soleDistance( placed, animated ) / soleDistance( full, animated );
}

static void blendingTakesTheTimesOfTheSettings( void** state )
{
	(void)state;
	const float times[][2] = { { 1.0f, 0.5f }, { 0.2f, 0.15f }, { 0.0f, 0.0f } };
	static Weighted w;
	for ( int32_t k = 0; k < 3; ++k )
	{
		for ( int32_t in = 0; in < 2; ++in )
		{
			start( &w );
			w.run.settings.target.blendIn = times[k][0];
			w.run.settings.target.blendOut = times[k][1];
			setWeight( &w, partWhole, 0.0f );
			if ( in == 1 )
			{
				testStepSeconds( &w.run, 1.0f );
				setWeight( &w, partWhole, 1.0f );
			}
			float time = in == 1 ? times[k][0] : times[k][1];
			for ( int32_t i = 1; i <= 70; ++i )
			{
				testStepRun( &w.run );
				float gone = time > 0.0f ? fminf( (float)i / 60.0f / time, 1.0f ) : 1.0f;
				// While the foot is not held it stands a little off.
				assert_float_equal( findShare( &w ), in == 1 ? gone : 1.0f - gone, 0.08f );
			}
			testEndRun( &w.run );
		}
	}
}

static void noTimeBlendsNothing( void** state )
{
	(void)state;
	static Weighted w;
	start( &w );
	w.run.frame.timeStep = 0.0f;
	setWeight( &w, partWhole, 0.0f );
	for ( int32_t i = 0; i < 10; ++i )
	{
		testStepRun( &w.run );
		nearPose( &w, w.full, 1e-6f, 1e-6f );
	}
	testEndRun( &w.run );
}

/// A foot that is held 7 cm off the animation is without weight for a while and then has it again.
static void loseHold( Part part, bool told )
{
	static Weighted w;
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	start( &w );
	testRun* run = &w.run;
	run->frame.contact = told ? contact : NULL;
	testStepSeconds( run, 0.5f );
	for ( int32_t i = 0; i < 30; ++i )
	{
		run->frame.root.translation.z -= 0.07f / 30.0f;
		testStepRun( run );
	}
	float off =
	    testPlacedJoint( run, biped_ankleL ).translation.z - testAnimatedJoint( run, biped_ankleL ).translation.z;
	assert_float_equal( off, 0.07f, 0.01f );
	setWeight( &w, part, 0.0f );
	testStepSeconds( run, 0.5f );
	assert_true( ( run->out.legs[0].flags & sole_legPlanted ) == 0 );
	setWeight( &w, part, 1.0f );
	testStepSeconds( run, 0.5f );
	assert_true( ( run->out.legs[0].flags & sole_legPlanted ) != 0 );
	off = testPlacedJoint( run, biped_ankleL ).translation.z - testAnimatedJoint( run, biped_ankleL ).translation.z;
	assert_float_equal( off, 0.0f, 5e-3f );
	testEndRun( run );
}

static void noLockSurvivesWeightZero( void** state )
{
	(void)state;
	for ( int32_t part = 0; part < partRotation; ++part )
	{
		loseHold( (Part)part, false );
		loseHold( (Part)part, true );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( noWeightThatJumpsMakesAJointJump ),
		cmocka_unit_test( weightZeroIsTheAnimatedPoseAndOneThePlacedPose ),
		cmocka_unit_test( aCharacterThatStartsWithoutWeightIsAnimated ),
		cmocka_unit_test( turnAloneTurnsTheFootAndLeavesTheAnkle ),
		cmocka_unit_test( placeAloneMovesTheAnkleAndLeavesTheTurn ),
		cmocka_unit_test( legsHaveWeightsOfTheirOwn ),
		cmocka_unit_test( blendingTakesTheTimesOfTheSettings ),
		cmocka_unit_test( noTimeBlendsNothing ),
		cmocka_unit_test( noLockSurvivesWeightZero ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
