// SPDX-License-Identifier: MIT
// Feet of a character that stands while its root is turned or pushed: when they stay, when they step over, one at a
// time, and what a held foot turns about. From outside; a foot that steps over is told by its flags.
#include "biped_walk.h"

/// What the feet did during a time.
typedef struct Record
{
	int32_t steps[2];
	int32_t first[2];   // frame of the first step
	int32_t longest[2]; // of a step, in frames
	int32_t together;   // frames in which both were on their way
	int32_t lost;       // in which neither was on its way, but one was not held
	float up[2];        // how high they were raised
} Record;

static void start( testRun* run )
{
	testStartRun( run, 0.8f );
	testStepSeconds( run, 1.0f );
}

static bool isStepping( const testRun* run, int32_t leg )
{
	return ( run->out.legs[leg].flags & sole_legPlanned ) != 0;
}

/// Pushed and turned evenly for some time; then it stands.
static Record push( testRun* run, soleVec3 by, float angle, float time, float until )
{
	Record r = { .first = { -1, -1 } };
	soleTransform from = run->frame.root;
	int32_t during[2] = { 0, 0 };
	int32_t count = (int32_t)( until / run->frame.timeStep );
	for ( int32_t i = 0; i < count; ++i )
	{
		float share = fminf( (float)( i + 1 ) * run->frame.timeStep / time, 1.0f );
		run->frame.root.translation = soleMulAdd( from.translation, share, by );
		run->frame.root.rotation = soleMulQuat( testTurn( soleVec( 0.0f, 1.0f, 0.0f ), share * angle ), from.rotation );
		testStepRun( run );
		r.together += isStepping( run, 0 ) && isStepping( run, 1 );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			bool steps = isStepping( run, leg );
			bool begins = steps && during[leg] == 0;
			r.steps[leg] += begins;
			r.first[leg] = begins && r.first[leg] < 0 ? i : r.first[leg];
			during[leg] = steps ? during[leg] + 1 : 0;
			r.longest[leg] = during[leg] > r.longest[leg] ? during[leg] : r.longest[leg];
			r.up[leg] = fmaxf( r.up[leg], testSoleClearance( run, leg ) );
			bool held = ( run->out.legs[leg].flags & sole_legPlanted ) != 0;
			r.lost += steps == false && held == false;
		}
	}
	return r;
}

/// How far a foot is from where it is animated, and how much it is turned, at the end.
static void findOff( const testRun* run, int32_t leg, float* distance, float* angle )
{
	soleTransform placed = testPlacedJoint( run, testAnkle( leg ) );
	soleTransform animated = testAnimatedJoint( run, testAnkle( leg ) );
	*distance = soleDistance( placed.translation, animated.translation );
	*angle = testAngle( placed.rotation, animated.rotation );
}

// ------------------------------------------------------------------------------------------------------- standing

static void aSmallPushIsStoodUpTo( void** state )
{
	(void)state;
	static testRun run;
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	for ( int32_t told = 0; told < 2; ++told )
	{
		for ( int32_t k = 0; k < 4; ++k )
		{
			start( &run );
			run.frame.contact = told == 1 ? contact : NULL;
			soleVec3 by =
			    k < 2 ? soleVec( k == 0 ? 0.05f : 0.0f, 0.0f, k == 1 ? -0.05f : 0.0f ) : soleVec( 0.0f, 0.0f, 0.0f );
			Record r = push( &run, by, k == 2 ? 0.3f : 0.0f, k == 3 ? 1.0f : 0.3f, 5.0f );
			assert_int_equal( r.steps[0] + r.steps[1] + r.lost, 0 );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				float distance, angle;
				findOff( &run, leg, &distance, &angle );
				assert_true( k != 0 || fabsf( distance - 0.05f ) < 1e-3f );
				assert_true( k != 2 || fabsf( angle - 0.3f ) < 1e-3f );
				assert_true( r.up[leg] < 1e-3f );
			}
			testEndRun( &run );
		}
	}
}

static void idlingTakesNoSteps( void** state )
{
	(void)state;
	static testRun run;
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	for ( int32_t told = 0; told < 2; ++told )
	{
		testStartRun( &run, 0.5f );
		run.frame.contact = told == 1 ? contact : NULL;
		soleVec3 before[2] = { 0 };
		for ( int32_t i = 0; i < 3600; ++i )
		{
			// Breathes and sways over feet that the animation leaves where they are, but for a millimetre.
			float t = (float)i / 60.0f;
			float down = WALK_HIP + 0.01f * sinf( 1.5f * t );
			float ahead = 0.02f * sinf( 0.7f * t );
			run.pose[biped_pelvis].translation = soleVec( 0.01f * sinf( 0.4f * t ), down + WALK_ANKLE, ahead );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				testPutAnkle( run.pose, leg == 0 ? biped_hipL : biped_hipR, down, -ahead + 0.001f * sinf( 3.0f * t ) );
			}
			testStepRun( &run );
			for ( int32_t leg = 0; leg < 2 && i >= 60; ++leg )
			{
				soleVec3 foot = testPlacedJoint( &run, testAnkle( leg ) ).translation;
				before[leg] = i == 60 ? foot : before[leg];
				testNear3( foot, before[leg], 1e-4f );
				assert_true( isStepping( &run, leg ) == false );
			}
		}
		testEndRun( &run );
	}
}

// ------------------------------------------------------------------------------------------------------- stepping

static void aFootThatIsLeftBehindStepsOverOnceAfterAWhile( void** state )
{
	(void)state;
	static testRun run;
	const soleVec3 ways[] = { { 0.15f, 0.0f, 0.0f }, { -0.15f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.15f },
		{ 0.0f, 0.0f, -0.15f } };
	for ( int32_t k = 0; k < 4; ++k )
	{
		start( &run );
		Record r = push( &run, ways[k], 0.0f, 0.3f, 5.0f );
		int32_t earliest = r.first[0] < r.first[1] ? r.first[0] : r.first[1];
		// Since it has been further off than 9 cm, and slow: at most 0.3 s from the start.
		assert_true( earliest >= 48 && earliest <= 18 + 50 );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			assert_int_equal( r.steps[leg], 1 );
			assert_in_range( r.longest[leg], 14, 16 );
			float distance, angle;
			findOff( &run, leg, &distance, &angle );
			assert_true( distance < 2e-3f && angle < 0.01f );
			assert_true( ( run.out.legs[leg].flags & sole_legPlanted ) != 0 );
			assert_true( r.up[leg] > 0.02f );
		}
		assert_int_equal( r.together, 0 );
		testEndRun( &run );
	}
}

static void whenAndHowFastAFootStepsOverIsSet( void** state )
{
	(void)state;
	static testRun run;
	start( &run );
	run.settings.contact.replantAfter = 2.0f;
	run.settings.contact.replantTime = 0.5f;
	Record r = push( &run, soleVec( 0.12f, 0.0f, 0.0f ), 0.0f, 0.3f, 6.0f );
	assert_in_range( r.first[0] < r.first[1] ? r.first[0] : r.first[1], 134, 142 );
	assert_in_range( r.longest[0], 28, 32 );
	testEndRun( &run );
	start( &run );
	run.settings.contact.replantDistance = 0.2f;
	r = push( &run, soleVec( 0.12f, 0.0f, 0.0f ), 0.0f, 0.3f, 6.0f );
	assert_int_equal( r.steps[0] + r.steps[1], 0 );
	testEndRun( &run );
	start( &run );
	run.settings.contact.replantAngle = 0.2f;
	r = push( &run, soleVec( 0.0f, 0.0f, 0.0f ), 0.3f, 0.1f, 6.0f );
	assert_true( r.steps[0] == 1 && r.steps[1] == 1 );
	testEndRun( &run );
}

static void aCharacterThatIsTurnedStepsRoundOneFootAtATime( void** state )
{
	(void)state;
	static testRun run;
	const float times[] = { 1.0f, 1.5f, 3.0f };
	for ( int32_t k = 0; k < 6; ++k )
	{
		start( &run );
		float angle = k < 3 ? 1.5707963f : -1.5707963f;
		Record r = push( &run, soleVec( 0.0f, 0.0f, 0.0f ), angle, times[k % 3], 8.0f );
		assert_in_range( r.steps[0] + r.steps[1], 1, 6 );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			float distance, turned;
			findOff( &run, leg, &distance, &turned );
			assert_true( turned < run.settings.contact.replantAngle + 0.02f );
			assert_true( distance < 0.1f );
		}
		assert_int_equal( r.together, 0 );
		assert_true( r.steps[0] > 0 && r.steps[1] > 0 );
		testEndRun( &run );
	}
}

static void aTravellingBodyWaitsForItsNextStep( void** state )
{
	(void)state;
	static testRun run;
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	start( &run );
	run.frame.contact = contact;
	// At 0.6 m/s: its feet are held until their locks are strained, and then let go.
	Record r = push( &run, soleVec( 0.0f, 0.0f, 0.6f ), 0.0f, 1.0f, 1.0f );
	assert_int_equal( r.steps[0] + r.steps[1], 0 );
	assert_true( r.lost > 0 );
	testEndRun( &run );
}

// -------------------------------------------------------------------------------------------------------- relock

/// How often a foot is taken hold of again that was let go, when the root has gone on for so long, and stops.
static int32_t countRelocks( float relock )
{
	static testRun run;
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	start( &run );
	run.frame.contact = contact;
	run.settings.contact.relock = relock;
	int32_t released = 0;
	int32_t captured = 0;
	for ( int32_t i = 0; i < 120; ++i )
	{
		run.frame.root.translation.z += released == 0 ? 0.6f / 60.0f : 0.0f;
		float before = soleDistance(
		    testPlacedJoint( &run, biped_ankleL ).translation, testAnimatedJoint( &run, biped_ankleL ).translation );
		testStepRun( &run );
		released += ( run.out.legs[0].flags & sole_legReleased ) != 0;
		bool taken = ( run.out.legs[0].flags & sole_legCaptured ) != 0;
		captured += taken;
		// Not before it has come near the animation again.
		assert_true( taken == false || before < relock * run.settings.contact.lockDistance * 0.9f + 0.02f );
	}
	assert_int_equal( released, 1 );
	testEndRun( &run );
	return captured;
}

static void aLockThatWasGivenUpBeginsAnewNearTheAnimation( void** state )
{
	(void)state;
	assert_int_equal( countRelocks( 0.4f ), 1 );
	assert_int_equal( countRelocks( 0.1f ), 1 );
	assert_int_equal( countRelocks( 0.0f ), 0 );
}

// --------------------------------------------------------------------------------------------------------- pivot

static void aHeldFootTurnsAboutWhatIsSet( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t pivot = 0; pivot < 3; ++pivot )
	{
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			start( &run );
			run.settings.contact.pivot = (soleLockPivot)pivot;
			// Taken hold of with this setting.
			run.state = soleDefaultState( run.biped.rig );
			testStepSeconds( &run, 1.0f );
			soleVec3 bindBall = soleRig_GetLeg( run.biped.rig, leg ).sole.ball;
			soleVec3 ball = testPlacedPoint( &run, leg, bindBall, false );
			soleTransform foot = testPlacedJoint( &run, testAnkle( leg ) );
			// The animation turns its feet under their ankles, and the root turns by as much the other way: 0.3 in all.
			push( &run, soleVec( 0.0f, 0.0f, 0.0f ), 0.3f, 0.5f, 2.0f );
			soleTransform after = testPlacedJoint( &run, testAnkle( leg ) );
			float heading = testAngle( after.rotation, foot.rotation );
			assert_float_equal( heading, pivot == sole_pivotNone ? 0.0f : 0.3f, 2e-3f );
			float ballMoved = soleDistance( testPlacedPoint( &run, leg, bindBall, false ), ball );
			float ankleMoved = soleDistance( after.translation, foot.translation );
			// The ankle is 12 cm behind the ball.
			float arm = 2.0f * WALK_BALL * sinf( 0.15f );
			assert_float_equal( ballMoved, pivot == sole_pivotAnkle ? arm : 0.0f, 1e-3f );
			assert_float_equal( ankleMoved, pivot == sole_pivotBall ? arm : 0.0f, 1e-3f );
			assert_true( ( run.out.legs[leg].flags & sole_legPlanted ) != 0 );
			testEndRun( &run );
		}
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aSmallPushIsStoodUpTo ),
		cmocka_unit_test( idlingTakesNoSteps ),
		cmocka_unit_test( aFootThatIsLeftBehindStepsOverOnceAfterAWhile ),
		cmocka_unit_test( whenAndHowFastAFootStepsOverIsSet ),
		cmocka_unit_test( aCharacterThatIsTurnedStepsRoundOneFootAtATime ),
		cmocka_unit_test( aTravellingBodyWaitsForItsNextStep ),
		cmocka_unit_test( aLockThatWasGivenUpBeginsAnewNearTheAnimation ),
		cmocka_unit_test( aHeldFootTurnsAboutWhatIsSet ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
