// SPDX-License-Identifier: MIT
// Steps of a clip: found in a gait whose contacts are known, read at any time of it, and brought to where the root is
// by what it does until then. The gait's contacts lie between frames, so that times can be off by half a frame.
#include "measure_rig.h"

#define MAX_STEPS 32

/// The labels that the gait really has.
static void labelTruly( rigMotion* m )
{
	for ( int32_t t = 0; t < m->motion.frameCount; ++t )
	{
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			double phase = gaitPhase( leg, t / (double)m->motion.frameRate );
			int32_t heel = phase < GAIT_HEEL_OFF ? sole_labelHeel : 0;
			int32_t toe = phase < GAIT_TOE_OFF ? sole_labelToe : 0;
			m->labels[2 * t + leg] = (uint8_t)( heel | toe );
		}
	}
}

/// Some rounds of the gait at a speed, and a frame.
static rigMotion makeWalk( const soleRig* rig, int32_t rounds, float rate, double speed )
{
	rigMotion m = rigMakeMotion( rig, rounds * (int32_t)( (float)GAIT_PERIOD * rate ) + 1, rate );
	gaitFill( &m, speed, 0.0f, false );
	labelTruly( &m );
	return m;
}

static double strikeOf( int32_t leg )
{
	return GAIT_FIRST + leg * GAIT_PHASE;
}

/// Where the ball stands in a stance, seen from the root at its true strike.
static soleVec3 placeOf( int32_t leg, double speed )
{
	return soleVec( leg == 0 ? 0.1f : -0.1f, 0.0f, RIG_TOE_Z + (float)( 0.3 * speed ) );
}

// --------------------------------------------------------------------------------------------------------- finding

static void stepsOfALoopAreFoundOnceEach( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	const float rates[] = { 30.0f, 60.0f, 240.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		rigMotion m = makeWalk( rig, 3, rates[k], 1.3 );
		soleStep steps[MAX_STEPS];
		assert_int_equal( soleFindSteps( &m.motion, m.labels, true, NULL, steps, MAX_STEPS ), 2 );
		double half = 0.5 / (double)rates[k] + 1e-5;
		for ( int32_t i = 0; i < 2; ++i )
		{
			assert_int_equal( steps[i].leg, i );
			// The second one goes on beyond the end of the round.
			testNearD( (double)steps[i].strike, strikeOf( i ), half );
			testNearD( (double)steps[i].lift, strikeOf( i ) + GAIT_TOE_OFF, half );
			testNearD( (double)steps[i].heelDown, strikeOf( i ), half );
			testNearD( (double)steps[i].heelUp, strikeOf( i ) + GAIT_HEEL_OFF, half );
			testNearD( (double)steps[i].toeDown, strikeOf( i ), half );
			testNearD( (double)steps[i].toeUp, strikeOf( i ) + GAIT_TOE_OFF, half );
			testNear3( steps[i].forward, soleVec( 0.0f, 0.0f, 1.0f ), 1e-5f );
		}
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void placesAreSeenFromTheRootAtTheStrike( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	const float rates[] = { 30.0f, 60.0f, 240.0f };
	const double speeds[] = { 0.0, 1.3, 2.6 };
	for ( int32_t k = 0; k < 9; ++k )
	{
		float rate = rates[k % 3];
		double speed = speeds[k / 3];
		rigMotion m = makeWalk( rig, 3, rate, speed );
		soleStep steps[MAX_STEPS];
		assert_int_equal( soleFindSteps( &m.motion, m.labels, true, NULL, steps, MAX_STEPS ), 2 );
		for ( int32_t i = 0; i < 2; ++i )
		{
			// The foot stands still in the world; a strike that is told too late is seen from a root that is further
			// on.
			double late = (double)steps[i].strike - strikeOf( i );
			soleVec3 place = placeOf( i, speed );
			place.z -= (float)( speed * late );
			testNear3( steps[i].place, place, 1e-4f );
		}
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void aClipThatDoesNotLoopHasItsEndsCut( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = makeWalk( rig, 2, 60.0f, 1.3 );
	soleStep steps[MAX_STEPS];
	// Left: .13 to .73, 1.13 to 1.73; right: until .23, .63 to 1.23, from 1.63 on.
	assert_int_equal( soleFindSteps( &m.motion, m.labels, false, NULL, steps, MAX_STEPS ), 5 );
	const double strikes[] = { 0.13, 1.13, -1e9, 0.63, 1.63 };
	const double lifts[] = { 0.73, 1.73, 0.23, 1.23, 1e9 };
	for ( int32_t i = 0; i < 5; ++i )
	{
		assert_int_equal( steps[i].leg, i < 2 ? 0 : 1 );
		testNearD( (double)steps[i].strike, strikes[i], 0.5 / 60.0 + 1e-5 );
		testNearD( (double)steps[i].lift, lifts[i], 0.5 / 60.0 + 1e-5 );
	}
	// Fewer are written where there is room for fewer, and all are counted.
	soleStep few[2] = { { .leg = 77 }, { .leg = 77 } };
	assert_int_equal( soleFindSteps( &m.motion, m.labels, false, NULL, few, 1 ), 5 );
	assert_int_equal( few[0].leg, 0 );
	assert_int_equal( few[1].leg, 77 );
	assert_int_equal( soleFindSteps( &m.motion, m.labels, false, NULL, NULL, 0 ), 5 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void aClipThatStandsHasOneEndlessStepALeg( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	for ( int32_t loops = 0; loops < 2; ++loops )
	{
		rigMotion m = rigMakeMotion( rig, 91, 30.0f );
		soleStep steps[MAX_STEPS];
		int32_t count = soleFindSteps( &m.motion, m.labels, loops == 1, NULL, steps, MAX_STEPS );
		assert_int_equal( count, 2 );
		for ( int32_t i = 0; i < 2; ++i )
		{
			assert_int_equal( steps[i].leg, i );
			assert_true( steps[i].strike <= -SOLE_STEP_ENDLESS && steps[i].lift >= SOLE_STEP_ENDLESS );
			testNear3( steps[i].place, placeOf( i, 0.0 ), 1e-5f );
			for ( int32_t k = 0; k <= 10; ++k )
			{
				soleContactInput contact;
				soleStepInput step;
				soleGetStepInput( steps, count, 1.0f, loops == 1, 0.1f * (float)k, i, &contact, &step );
				assert_true( contact.heel >= 1.0f && contact.toe >= 1.0f );
				assert_true( step.until >= 0.5f * SOLE_STEP_ENDLESS );
			}
		}
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void aTurnedAndScaledRootSeesTheSamePlace( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	soleStep plain[MAX_STEPS], turned[MAX_STEPS];
	rigMotion m = makeWalk( rig, 3, 60.0f, 0.0 );
	m.motion.clipFloor = 0.0f;
	assert_int_equal( soleFindSteps( &m.motion, m.labels, true, NULL, plain, MAX_STEPS ), 2 );
	soleQuat q = soleNormalizeQuat( ( soleQuat ){ 0.4f, 0.3f, -0.7f, 0.2f } );
	for ( int32_t t = 0; t < m.motion.frameCount; ++t )
	{
		m.roots[t] = ( soleTransform ){ { 3.0f, -2.0f, 5.0f }, q, { 2.0f, 2.0f, 2.0f } };
	}
	m.motion.up = soleRotate( q, m.motion.up );
	m.motion.clipFloor = 0.02f;
	assert_int_equal( soleFindSteps( &m.motion, m.labels, true, NULL, turned, MAX_STEPS ), 2 );
	for ( int32_t i = 0; i < 2; ++i )
	{
		// On the clip's floor, whatever the height of the ball.
		testNear3( turned[i].place, soleAdd( plain[i].place, soleVec( 0.0f, 0.02f, 0.0f ) ), 1e-5f );
		testNear3( turned[i].forward, plain[i].forward, 1e-5f );
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void heelAndToeHaveTimesOfTheirOwn( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	for ( int32_t t = 0; t < 60; ++t )
	{
		// Left: heel 10 to 29, toe 15 to 39. Right: the toe alone, 20 to 24.
		m.labels[2 * t] =
		    (uint8_t)( ( t >= 10 && t < 30 ? sole_labelHeel : 0 ) | ( t >= 15 && t < 40 ? sole_labelToe : 0 ) );
		m.labels[2 * t + 1] = t >= 20 && t < 25 ? sole_labelToe : sole_labelNone;
	}
	soleStep steps[MAX_STEPS];
	assert_int_equal( soleFindSteps( &m.motion, m.labels, false, NULL, steps, MAX_STEPS ), 2 );
	const float frames[2][6] = { { 9.5f, 39.5f, 9.5f, 29.5f, 14.5f, 39.5f },
		{ 19.5f, 24.5f, 0.0f, 0.0f, 19.5f, 24.5f } };
	for ( int32_t i = 0; i < 2; ++i )
	{
		const float times[6] = { steps[i].strike, steps[i].lift, steps[i].heelDown, steps[i].heelUp, steps[i].toeDown,
			steps[i].toeUp };
		for ( int32_t k = 0; k < 6; ++k )
		{
			assert_float_equal( times[k], frames[i][k] / 60.0f, 1e-6f );
		}
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

// --------------------------------------------------------------------------------------------------------- reading

/// Left: one step within the clip of 1 s; right: one over its seam; a third leg: two.
static const soleStep walkSteps[4] = {
	{ 0, 0.2f, 0.7f, 0.2f, 0.5f, 0.3f, 0.7f, { 0.1f, 0.0f, 0.4f }, { 0.0f, 0.0f, 1.0f } },
	{ 1, 0.8f, 1.3f, 0.8f, 1.1f, 0.9f, 1.3f, { -0.1f, 0.0f, 0.3f }, { 0.6f, 0.0f, 0.8f } },
	{ 2, 0.1f, 0.3f, 0.1f, 0.3f, 0.1f, 0.3f, { 0.0f, 0.0f, 0.1f }, { 0.0f, 0.0f, 1.0f } },
	{ 2, 0.6f, 0.8f, 0.6f, 0.8f, 0.6f, 0.8f, { 0.0f, 0.0f, 0.2f }, { 0.0f, 0.0f, 1.0f } },
};

typedef struct Reading
{
	float time;
	int32_t leg;
	float heel, toe, since, until;
} Reading;

static void checkReadings( bool loops, const Reading* readings, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		soleContactInput contact;
		soleStepInput step;
		const Reading* r = readings + i;
		soleGetStepInput( walkSteps, 4, 1.0f, loops, r->time, r->leg, &contact, &step );
		assert_float_equal( contact.heel, r->heel, 0.0f );
		assert_float_equal( contact.toe, r->toe, 0.0f );
		assert_float_equal( step.since, r->since, 1e-6f );
		assert_float_equal( step.until, r->until, 1e-6f );
		if ( r->until >= 0.0f )
		{
			testNear3( step.place, walkSteps[r->leg].place, 0.0f );
			testNear3( step.forward, walkSteps[r->leg].forward, 0.0f );
		}
	}
}

static void stepsOfALoopAreReadBeforeInAndAfterContact( void** state )
{
	(void)state;
	const Reading readings[] = {
		{ 0.0f, 0, 0.0f, 0.0f, 0.3f, 0.2f }, // left: in flight since .7 of the round before
		{ 0.1f, 0, 0.0f, 0.0f, 0.4f, 0.1f },
		{ 0.25f, 0, 1.0f, 0.0f, 0.05f, 0.45f }, // on its heel
		{ 0.4f, 0, 1.0f, 1.0f, 0.2f, 0.3f },
		{ 0.6f, 0, 0.0f, 1.0f, 0.4f, 0.1f }, // on its toes
		{ 0.75f, 0, 0.0f, 0.0f, 0.05f, 0.45f },
		{ 0.95f, 0, 0.0f, 0.0f, 0.25f, 0.25f },
		{ 0.5f, 1, 0.0f, 0.0f, 0.2f, 0.3f }, // right
		{ 0.85f, 1, 1.0f, 0.0f, 0.05f, 0.45f },
		{ 0.95f, 1, 1.0f, 1.0f, 0.15f, 0.35f },
		{ 0.05f, 1, 1.0f, 1.0f, 0.25f, 0.25f }, // over the seam
		{ 0.2f, 1, 0.0f, 1.0f, 0.4f, 0.1f },
		{ 0.35f, 1, 0.0f, 0.0f, 0.05f, 0.45f },
	};
	checkReadings( true, readings, sizeof readings / sizeof readings[0] );
}

static void theNextOfSeveralStepsIsTold( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < 100; ++i )
	{
		float time = ( (float)i + 0.5f ) * 0.01f;
		soleContactInput contact;
		soleStepInput step;
		soleGetStepInput( walkSteps, 4, 1.0f, true, time, 2, &contact, &step );
		float phase = fmodf( time + 0.4f, 0.5f ); // since a strike
		bool down = phase < 0.2f;
		assert_true( down == ( contact.heel > 0.0f && contact.toe > 0.0f ) );
		assert_float_equal( step.since, ( down ? phase : phase - 0.2f ), 1e-5f );
		assert_float_equal( step.until, ( down ? 0.2f - phase : 0.5f - phase ), 1e-5f );
		bool second = time > 0.3f && time < 0.8f;
		assert_float_equal( step.place.z, ( second ? 0.2f : 0.1f ), 0.0f );
	}
}

static void whatAClipThatDoesNotLoopCannotKnowIsNotTold( void** state )
{
	(void)state;
	const Reading readings[] = {
		{ 0.1f, 0, 0.0f, 0.0f, -1.0f, 0.1f }, // never left
		{ 0.4f, 0, 1.0f, 1.0f, 0.2f, 0.3f },
		{ 0.9f, 0, 0.0f, 0.0f, 0.2f, -1.0f }, // does not come down any more
		{ 0.1f, 1, 0.0f, 0.0f, -1.0f, 0.7f },
		{ 0.95f, 1, 1.0f, 1.0f, 0.15f, 0.35f },
	};
	checkReadings( false, readings, sizeof readings / sizeof readings[0] );
	soleContactInput contact;
	soleStepInput step;
	soleGetStepInput( NULL, 0, 1.0f, true, 0.5f, 0, &contact, &step );
	assert_true( contact.heel <= 0.0f && contact.toe <= 0.0f && step.since < 0.0f && step.until < 0.0f );
}

static void thePartsOfAContactAddUp( void** state )
{
	(void)state;
	// Through all the loop: what is told is continuous, and contact is as long as the step.
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		int32_t down = 0;
		for ( int32_t i = 0; i < 1000; ++i )
		{
			soleContactInput contact;
			soleStepInput step;
			soleGetStepInput( walkSteps, 4, 1.0f, true, ( (float)i + 0.5f ) * 1e-3f, leg, &contact, &step );
			down += contact.heel > 0.0f || contact.toe > 0.0f;
			assert_float_equal( step.since + step.until, 0.5f, 1e-5f );
		}
		assert_int_equal( down, 500 );
	}
}

// ---------------------------------------------------------------------------------------------------- extrapolation

/// What the root does by small steps, in double.
static void integrate( soleVec3 velocity, double turnRate, soleVec3 up, double time, double place[3] )
{
	const double u[3] = { (double)up.x, (double)up.y, (double)up.z };
	const double v[3] = { (double)velocity.x, (double)velocity.y, (double)velocity.z };
	const double w[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
	const int32_t count = 20000;
	place[0] = place[1] = place[2] = 0.0;
	for ( int32_t i = 0; i < count; ++i )
	{
		double angle = turnRate * time * ( i + 0.5 ) / count;
		for ( int32_t k = 0; k < 3; ++k )
		{
			place[k] += ( cos( angle ) * v[k] + sin( angle ) * w[k] ) * time / count;
		}
	}
}

static void rootsGoOnAsTheyGo( void** state )
{
	(void)state;
	uint32_t seed = 7;
	for ( int32_t i = 0; i < 300; ++i )
	{
		soleVec3 up =
		    soleNormalizeOr( soleVec( testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ),
		                         testRandomFloat( &seed, 0.1f, 1.0f ) ),
		        soleVec( 0.0f, 1.0f, 0.0f ) );
		soleVec3 velocity =
		    soleReject( soleVec( testRandomFloat( &seed, -3.0f, 3.0f ), testRandomFloat( &seed, -3.0f, 3.0f ),
		                    testRandomFloat( &seed, -3.0f, 3.0f ) ),
		        up );
		float time = testRandomFloat( &seed, 0.0f, 1.0f );
		// Straight on, nearly straight, and on arcs of up to a quarter of a circle.
		float turnRate = i % 3 == 0 ? 0.0f : testRandomFloat( &seed, -1.0f, 1.0f ) * ( i % 3 == 1 ? 1e-4f : 1.57f );
		soleTransform travel = soleExtrapolate( velocity, turnRate, up, time );
		double place[3];
		integrate( velocity, (double)turnRate, up, (double)time, place );
		testNear3( travel.translation, soleVec( (float)place[0], (float)place[1], (float)place[2] ), 3e-4f );
		// The heading goes round with the way.
		double angle = (double)turnRate * (double)time;
		soleVec3 ahead = soleAnyOrthogonal( up );
		soleVec3 expected =
		    soleMulAdd( soleScale( (float)cos( angle ), ahead ), (float)sin( angle ), soleCross( up, ahead ) );
		testNear3( soleRotate( travel.rotation, ahead ), expected, 1e-5f );
	}
}

static void aStandingRootStaysAndAFastTurnStaysFinite( void** state )
{
	(void)state;
	soleVec3 up = soleVec( 0.0f, 1.0f, 0.0f );
	soleTransform still = soleExtrapolate( soleVec( 0.0f, 0.0f, 0.0f ), 0.0f, up, 1.0f );
	testNear3( still.translation, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	assert_float_equal( soleDotQuat( still.rotation, soleQuat_Identity() ), 1.0f, 0.0f );
	const float rates[] = { 10.0f, -10.0f, 1e6f, -1e6f };
	for ( int32_t i = 0; i < 4; ++i )
	{
		soleTransform t = soleExtrapolate( soleVec( 0.0f, 0.0f, 2.0f ), rates[i], up, 1.0f );
		// It goes no further than along the straight.
		assert_true( soleLength( t.translation ) <= 2.0f );
		assert_true( soleQuat_IsFinite( t.rotation ) );
	}
}

static void travelBringsAPlaceToWhereTheRootIs( void** state )
{
	(void)state;
	uint32_t seed = 3;
	soleVec3 up = soleVec( 0.0f, 1.0f, 0.0f );
	for ( int32_t i = 0; i < 100; ++i )
	{
		soleTransform now = soleTransform_Identity();
		now.translation = soleVec( testRandomFloat( &seed, -2.0f, 2.0f ), 0.0f, testRandomFloat( &seed, -2.0f, 2.0f ) );
		now.rotation = rigTurnX( 0.0 );
		soleTransform travel = soleExtrapolate( soleVec( testRandomFloat( &seed, -2.0f, 2.0f ), 0.0f, 1.0f ),
		    testRandomFloat( &seed, -1.0f, 1.0f ), up, 0.7f );
		soleTransform then = soleMulTransform( now, travel );
		soleStepInput step = {
			.since = 0.1f, .until = 0.7f, .place = walkSteps[1].place, .forward = walkSteps[1].forward
		};
		soleStepInput_Travel( &step, travel );
		testNear3( soleTransformPoint( now, step.place ), soleTransformPoint( then, walkSteps[1].place ), 1e-5f );
		testNear3( soleRotate( now.rotation, step.forward ), soleRotate( then.rotation, walkSteps[1].forward ), 1e-5f );
		testNear3( step.travel, travel.translation, 0.0f );
		assert_float_equal( step.since, 0.1f, 0.0f );
		assert_float_equal( step.until, 0.7f, 0.0f );
	}
}

static void aFootIsForetoldAtOnePlaceAllItsWay( void** state )
{
	(void)state;
	// Found, read and brought to the root in every frame: in the world it is one place.
	soleRig* rig = rigMake();
	double speed = 1.3;
	rigMotion m = makeWalk( rig, 3, 240.0f, speed );
	soleStep steps[MAX_STEPS];
	int32_t count = soleFindSteps( &m.motion, m.labels, true, NULL, steps, MAX_STEPS );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		for ( int32_t i = 0; i < 600; ++i )
		{
			float time = (float)i / 200.0f;
			soleContactInput contact;
			soleStepInput step;
			soleGetStepInput( steps, count, 1.0f, true, fmodf( time, 1.0f ), leg, &contact, &step );
			bool flying = contact.heel <= 0.0f && contact.toe <= 0.0f;
			if ( flying == false )
			{
				continue;
			}
			assert_true( step.until >= 0.0f && step.since >= 0.0f );
			soleVec3 velocity = soleVec( 0.0f, 0.0f, (float)speed );
			soleStepInput_Travel( &step, soleExtrapolate( velocity, 0.0f, soleVec( 0.0f, 1.0f, 0.0f ), step.until ) );
			double world = speed * (double)time + (double)step.place.z;
			double rounds = round( (double)time + (double)step.until - strikeOf( leg ) );
			double stands = speed * ( strikeOf( leg ) + rounds ) + (double)placeOf( leg, speed ).z;
			testNearD( world, stands, 1e-3 );
		}
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void misuseIsRefusedSafely( void** state )
{
	(void)state;
	soleSetAssertHandler( testQuietHandler );
	soleRig* rig = rigMake();
	rigMotion m = makeWalk( rig, 1, 60.0f, 1.0 );
	soleStep steps[MAX_STEPS];
	assert_int_equal( soleFindSteps( NULL, m.labels, true, NULL, steps, MAX_STEPS ), 0 );
	assert_int_equal( soleFindSteps( &m.motion, NULL, true, NULL, steps, MAX_STEPS ), 0 );
	assert_int_equal( soleFindSteps( &m.motion, m.labels, true, NULL, NULL, 3 ), 0 );
	soleGetStepInput( walkSteps, 4, 1.0f, true, 0.5f, 0, NULL, NULL );
	soleStepInput_Travel( NULL, soleTransform_Identity() );
	rigMemory memory = { .left = 0 };
	soleAllocator allocator = { rigAlloc, rigFree, &memory };
	assert_int_equal( soleFindSteps( &m.motion, m.labels, false, &allocator, steps, MAX_STEPS ), 0 );
	assert_int_equal( memory.held, 0 );
	soleSetAssertHandler( NULL );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( stepsOfALoopAreFoundOnceEach ),
		cmocka_unit_test( placesAreSeenFromTheRootAtTheStrike ),
		cmocka_unit_test( aClipThatDoesNotLoopHasItsEndsCut ),
		cmocka_unit_test( aClipThatStandsHasOneEndlessStepALeg ),
		cmocka_unit_test( aTurnedAndScaledRootSeesTheSamePlace ),
		cmocka_unit_test( heelAndToeHaveTimesOfTheirOwn ),
		cmocka_unit_test( stepsOfALoopAreReadBeforeInAndAfterContact ),
		cmocka_unit_test( theNextOfSeveralStepsIsTold ),
		cmocka_unit_test( whatAClipThatDoesNotLoopCannotKnowIsNotTold ),
		cmocka_unit_test( thePartsOfAContactAddUp ),
		cmocka_unit_test( rootsGoOnAsTheyGo ),
		cmocka_unit_test( aStandingRootStaysAndAFastTurnStaysFinite ),
		cmocka_unit_test( travelBringsAPlaceToWhereTheRootIs ),
		cmocka_unit_test( aFootIsForetoldAtOnePlaceAllItsWay ),
		cmocka_unit_test( misuseIsRefusedSafely ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
