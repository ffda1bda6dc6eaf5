// SPDX-License-Identifier: MIT
// Footholds, through the public calls: where a foot lands whose steps are told, how it gets there, and what it does
// where there is no ground. A walk whose steps are known exactly; soles are measured from heel to toe tip.
#include "biped_walk.h"

#define TREAD 0.3f
#define RISE 0.15f
#define SHIFT ( 0.2f * 0.9f ) // the setting's default, of the leg's length

typedef struct Walker
{
	testRun run;
	testWalk walk;
	float time;
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	float nudge; // so much further on is the left foot meant to land, m
	bool silent; // nothing is told
} Walker;

static void start( Walker* w, float speed )
{
	memset( w, 0, sizeof *w );
	testStartRun( &w->run, 0.5f );
	w->walk = ( testWalk ){ speed, 1.0f, 0.06f };
}

/// A frame; the root goes straight on, at the height of the line through the stairs' middles.
static void stepOn( Walker* w )
{
	testRun* run = &w->run;
	const testGround* ground = &run->ground;
	float z = w->walk.speed * w->time;
	float slope = ground->tread > 0.0f ? ground->rise / ground->tread : 0.0f;
	float climb = slope * ( z - ground->stairs + 0.5f * ground->tread );
	run->frame.root.translation = soleVec( 0.0f, fmaxf( climb, 0.0f ), z );
	testPoseWalk( run->pose, &w->walk, w->time );
	testTellWalk( &w->walk, w->time, w->contacts, w->inputs );
	w->inputs[0].place.z += w->nudge;
	run->frame.contact = w->silent ? NULL : w->contacts;
	run->frame.steps = w->silent ? NULL : w->inputs;
	testStepRun( run );
	w->time += run->frame.timeStep;
}

/// Stairs on which each step of the walk goes up one tread.
static void startStairs( Walker* w, float firstRiser )
{
	start( w, 2.0f * TREAD );
	w->run.ground.stairs = firstRiser;
	w->run.ground.tread = TREAD;
	w->run.ground.rise = RISE;
}

static float phaseOf( const Walker* w, int32_t leg )
{
	return testWalkPhase( &w->walk, w->time - w->run.frame.timeStep, leg );
}

static bool isStanding( const Walker* w, int32_t leg )
{
	float phase = phaseOf( w, leg );
	return phase > 0.15f && phase < 0.55f;
}

/// How far a foot is from where it is animated, along the way.
static float shiftOf( const Walker* w, int32_t leg )
{
	float animated = testAnimatedJoint( &w->run, testAnkle( leg ) ).translation.z;
	return testPlacedJoint( &w->run, testAnkle( leg ) ).translation.z - animated;
}

// ----------------------------------------------------------------------------------------------------------- where

static void onFlatGroundAFootLandsWhereItIsMeantTo( void** state )
{
	(void)state;
	static Walker w;
	const float speeds[] = { 0.0f, 0.3f, 0.6f, 1.0f };
	for ( int32_t k = 0; k < 4; ++k )
	{
		start( &w, speeds[k] );
		int32_t planned = 0;
		for ( int32_t i = 0; i < 180; ++i )
		{
			stepOn( &w );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				assert_float_equal( shiftOf( &w, leg ), 0.0f, 2e-4f );
				bool flying = w.contacts[leg].toe < 0.5f;
				bool flagged = ( w.run.out.legs[leg].flags & sole_legPlanned ) != 0;
				assert_true( i == 0 || flagged == flying );
				planned += flagged;
			}
		}
		assert_true( planned > 120 );
		testEndRun( &w.run );
	}
}

/// How much of a standing sole hangs over the edge behind it, or is past the riser ahead.
static float findOverhang( const Walker* w, int32_t leg )
{
	soleVec3 points[TEST_SOLE_POINTS];
	testPlacedSole( &w->run, leg, points );
	const testGround* ground = &w->run.ground;
	float tread = floorf( ( points[TEST_SOLE_POINTS / 2].z - ground->stairs ) / ground->tread );
	float begin = ground->stairs + tread * ground->tread;
	return fmaxf( begin - points[0].z, points[TEST_SOLE_POINTS - 1].z - begin - ground->tread );
}

static void onStairsAFootStandsOnItsTread( void** state )
{
	(void)state;
	static Walker w;
	const int32_t cases = 40;
	const float most = 0.05f;
	float largest = 0.0f;
	for ( int32_t k = 0; k < cases; ++k )
	{
		startStairs( &w, 1.0f + TREAD * (float)k / (float)cases );
		for ( int32_t i = 0; i < 300; ++i )
		{
			stepOn( &w );
			for ( int32_t leg = 0; leg < 2 && w.time > 2.5f; ++leg )
			{
				if ( isStanding( &w, leg ) )
				{
					float shift = fabsf( shiftOf( &w, leg ) );
					assert_true( shift <= SHIFT + 1e-3f );
					assert_true( findOverhang( &w, leg ) < most );
					assert_true( testSoleClearance( &w.run, leg ) > -2e-3f );
					assert_true( ( w.run.out.legs[leg].flags & sole_legPlanted ) != 0 );
					largest = fmaxf( largest, shift );
				}
			}
		}
		testEndRun( &w.run );
	}
	// Where it matters it is made use of: unshifted, half of these soles would hang over by more.
	assert_true( largest > 0.1f );
}

static void aShiftedFootThatComesToStandStays( void** state )
{
	(void)state;
	static Walker w;
	startStairs( &w, 1.135f );
	while ( w.time < 4.05f )
	{
		stepOn( &w );
	}
	// Both feet are down, and stay so.
	assert_true( w.contacts[0].toe > 0.5f && w.contacts[1].toe > 0.5f );
	assert_true( shiftOf( &w, 0 ) > w.run.settings.contact.replantDistance * 0.9f );
	w.run.frame.steps = NULL;
	for ( int32_t i = 0; i < 180; ++i )
	{
		testStepRun( &w.run );
		assert_true( ( ( w.run.out.legs[0].flags | w.run.out.legs[1].flags ) & (uint32_t)sole_legPlanned ) == 0 );
	}
	assert_true( shiftOf( &w, 0 ) > w.run.settings.contact.replantDistance * 0.9f );
	testEndRun( &w.run );
}

static void withoutAShiftAFootLandsWhereItIsMeantToOnStairsToo( void** state )
{
	(void)state;
	static Walker w;
	for ( int32_t k = 0; k < 5; ++k )
	{
		startStairs( &w, 1.0f + TREAD * (float)k / 5.0f );
		w.run.settings.foothold.shift = 0.0f;
		for ( int32_t i = 0; i < 300; ++i )
		{
			stepOn( &w );
			for ( int32_t leg = 0; leg < 2 && w.time > 1.0f; ++leg )
			{
				assert_true( isStanding( &w, leg ) == false || fabsf( shiftOf( &w, leg ) ) < 1e-3f );
			}
		}
		testEndRun( &w.run );
	}
}

static void aFootLandsOnItsFootholdAtEveryRate( void** state )
{
	(void)state;
	static Walker w;
	const float rates[] = { 24.0f, 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 4; ++k )
	{
		startStairs( &w, 1.09f );
		w.run.frame.timeStep = 1.0f / rates[k];
		w.time = 0.3f / rates[k];
		float chosen[2] = { 0.0f, 0.0f };
		while ( w.time < 5.0f )
		{
			stepOn( &w );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				bool flying = ( w.run.out.legs[leg].flags & sole_legPlanned ) != 0;
				chosen[leg] = flying ? w.run.state.legs[leg].stepPlace_w.z : chosen[leg];
				if ( isStanding( &w, leg ) && w.time > 2.0f )
				{
					soleVec3 ball = soleRig_GetLeg( w.run.biped.rig, leg ).sole.ball;
					assert_float_equal( testPlacedPoint( &w.run, leg, ball, false ).z, chosen[leg], 3e-4f );
				}
			}
		}
		testEndRun( &w.run );
	}
}

// ----------------------------------------------------------------------------------------------------------- when

/// Walks until the left foot comes down in so many seconds, then it is meant elsewhere.
/// @return how far its foothold moves for that
static float meanElsewhere( Walker* w, float until, float by )
{
	do
	{
		stepOn( w );
	} while ( w->time < 4.5f || w->inputs[0].until > until || w->contacts[0].toe > 0.5f );
	soleVec3 before = w->run.state.legs[0].stepPlace_w;
	w->nudge = by;
	stepOn( w );
	stepOn( w );
	assert_true( ( w->run.out.legs[0].flags & sole_legPlanned ) != 0 );
	return soleDistance( w->run.state.legs[0].stepPlace_w, before );
}

static void aShiftedFootholdIsSettledBeforeTheFootComesDown( void** state )
{
	(void)state;
	static Walker w;
	const float places[] = { -0.12f, -0.06f, 0.06f, 0.12f };
	for ( int32_t i = 0; i < 4; ++i )
	{
		startStairs( &w, 1.09f );
		assert_float_equal( meanElsewhere( &w, 0.069f, places[i] ), 0.0f, 0.0f );
		testEndRun( &w.run );
	}
	// Earlier, or if it is never settled, it is chosen anew.
	startStairs( &w, 1.09f );
	assert_true( meanElsewhere( &w, 0.2f, 0.09f ) > 5e-3f );
	testEndRun( &w.run );
	startStairs( &w, 1.09f );
	w.run.settings.foothold.freeze = 0.0f;
	assert_true( meanElsewhere( &w, 0.069f, -0.06f ) > 5e-3f );
	testEndRun( &w.run );
}

static void anUnshiftedFootholdGoesWithTheLandingToTheLast( void** state )
{
	(void)state;
	static Walker w;
	start( &w, 0.6f );
	assert_float_equal( meanElsewhere( &w, 0.069f, 0.06f ), 0.06f, 1e-4f );
	testEndRun( &w.run );
}

// ------------------------------------------------------------------------------------------------------------- how

/// Least clearance of the left sole over a bar in its way, the foot well before it and well past it when it stands.
static float findBarClearance( float width, float height, float at )
{
	static Walker w;
	start( &w, 1.0f );
	// It stands with its heel at 1.23 and its toes at 1.49, and a metre further on.
	w.run.ground.barFrom = 1.6f + at * ( 2.12f - 1.6f - width );
	w.run.ground.barTo = w.run.ground.barFrom + width;
	w.run.ground.barHeight = height;
	float least = 1.0f;
	for ( int32_t i = 0; i < 240; ++i )
	{
		stepOn( &w );
		least = fminf( least, testSoleClearance( &w.run, 0 ) );
	}
	testEndRun( &w.run );
	return least;
}

static void aFootIsLiftedOverWhatLiesInItsWay( void** state )
{
	(void)state;
	for ( int32_t i = 0; i <= 10; ++i )
	{
		float at = 0.1f * (float)i;
		assert_true( findBarClearance( 0.2f, 0.05f, at ) > -1e-3f );
		assert_true( findBarClearance( 0.2f, 0.1f, at ) > -1e-3f );
		assert_true( findBarClearance( 0.2f, 0.2f, at ) > -1e-3f );
		assert_true( findBarClearance( 0.1f, 0.1f, at ) > -1e-3f );
		// Right before where the foot lands it is grazed.
		assert_true( findBarClearance( 0.1f, 0.2f, at ) > -0.012f );
	}
}

static void onFlatGroundNoFootIsLifted( void** state )
{
	(void)state;
	static Walker w;
	start( &w, 1.0f );
	for ( int32_t i = 0; i < 240; ++i )
	{
		stepOn( &w );
		assert_true( testLargestTurn( w.run.placed, w.run.pose ) < 2e-3f );
	}
	testEndRun( &w.run );
}

// -------------------------------------------------------------------------------------------------------- no ground

static void whereThereIsNoGroundAheadTheWalkGoesOnAsAnimated( void** state )
{
	(void)state;
	static Walker w;
	for ( int32_t k = 0; k < 4; ++k )
	{
		start( &w, 0.6f );
		w.run.ground.slopeX = k < 2 ? 0.0f : 0.1f;
		w.run.ground.hole = k % 2 == 0 ? 1.5f : -1.0f;
		for ( int32_t i = 0; i < 420; ++i )
		{
			soleVec3 before = w.run.out.pelvisOffset_w;
			stepOn( &w );
			const soleOutput* out = &w.run.out;
			assert_true( soleVec3_IsFinite( out->pelvisOffset_w ) && soleVec3_IsFinite( out->pelvisTranslation_l ) );
			assert_true( i == 0 || soleDistance( before, out->pelvisOffset_w ) < 0.016f );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				const soleLegOutput* o = out->legs + leg;
				assert_true( soleIsFinite( o->error + o->extension + o->heightDemand + o->stretch ) );
				assert_true( soleVec3_IsFinite( o->ankle_w ) && soleVec3_IsFinite( o->planePoint_w ) );
				assert_true( soleQuat_IsFinite( o->toeRotation_l ) );
				for ( int32_t j = 0; j < 3; ++j )
				{
					assert_true( soleQuat_IsFinite( o->rotations_l[j] ) );
				}
			}
		}
		assert_true( ( w.run.out.legs[0].flags & w.run.out.legs[1].flags & (uint32_t)sole_legNoGround ) != 0 );
		assert_true( testLargestTurn( w.run.placed, w.run.pose ) < 1e-3f );
		assert_true( testLargestMove( &w.run.biped, w.run.placed, w.run.pose ) < 1e-3f );
		testEndRun( &w.run );
	}
}

static void aMomentWithoutAnswersMovesNothing( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( &run, 0.8f );
		run.ground.slopeX = 0.1f;
		run.ground.stepX = 0.1f;
		testStepSeconds( &run, 1.0f );
		soleTransform before[biped_count], last[biped_count];
		memcpy( before, run.placed, sizeof before );
		run.ground.hole = -10.0f;
		for ( int32_t i = 0; i < ( k == 0 ? 5 : 60 ); ++i )
		{
			memcpy( last, run.placed, sizeof last );
			testStepRun( &run );
			bool planted = ( run.out.legs[0].flags & sole_legPlanted ) != 0;
			// For a tenth of a second, that is; then the foot lets go, but does not drop.
			assert_true( planted == ( i < 5 ) );
			assert_true( planted == false || testLargestTurn( run.placed, before ) < 1e-4f );
			assert_true( testLargestMove( &run.biped, run.placed, last ) < 0.025f );
		}
		testEndRun( &run );
	}
}

static void inTheAirAFootIsAsAnimated( void** state )
{
	(void)state;
	static testRun run;
	const float speeds[] = { 3.0f, -3.0f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( &run, 0.8f );
		run.ground.hole = -1e9f;
		for ( int32_t i = 0; i < 60; ++i )
		{
			run.frame.root.translation.y = speeds[k] * (float)i / 60.0f;
			testStepRun( &run );
			assert_true( testLargestMove( &run.biped, run.placed, run.pose ) < 1e-4f );
		}
		testEndRun( &run );
	}
}

static void aLandingThatIsSeenLateDoesNotShakeTheBody( void** state )
{
	(void)state;
	static Walker w;
	startStairs( &w, 1.0f );
	float last = 0.0f;
	for ( int32_t i = 0; i < 300; ++i )
	{
		// A foot sees the upper stairs only in the second half of its flight.
		float left = phaseOf( &w, 0 ), right = phaseOf( &w, 1 );
		bool early = ( left > 0.55f && left < 0.8f ) || ( right > 0.55f && right < 0.8f );
		w.run.ground.hole = w.walk.speed * w.time + ( early ? 0.35f : 10.0f );
		stepOn( &w );
		float height = w.run.out.pelvisOffset_w.y + w.run.frame.root.translation.y;
		assert_true( w.time < 2.0f || fabsf( height - last ) < 0.016f );
		last = height;
	}
	testEndRun( &w.run );
}

// --------------------------------------------------------------------------------------------------------- learning

static void aGaitThatIsNotToldIsLearntFromItsSteps( void** state )
{
	(void)state;
	static Walker w;
	start( &w, 0.8f );
	w.silent = true;
	int32_t planned = 0, flying = 0;
	for ( int32_t i = 0; i < 420; ++i )
	{
		stepOn( &w );
		for ( int32_t leg = 0; leg < 2 && w.time > 3.0f; ++leg )
		{
			float phase = phaseOf( &w, leg );
			bool flies = phase > 0.7f && phase < 0.9f;
			flying += flies;
			planned += flies && ( w.run.out.legs[leg].flags & sole_legPlanned ) != 0;
			// It is foreseen to land where it does.
			if ( phase > 0.8f && phase < 0.9f )
			{
				float meant = w.walk.speed * ( w.time - w.run.frame.timeStep + 1.0f - phase ) + 0.24f + WALK_BALL;
				assert_float_equal( w.run.state.legs[leg].stepPlace_w.z, meant, 0.06f );
			}
		}
	}
	assert_true( flying > 80 && planned > flying * 9 / 10 );
	testEndRun( &w.run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( onFlatGroundAFootLandsWhereItIsMeantTo ),
		cmocka_unit_test( onStairsAFootStandsOnItsTread ),
		cmocka_unit_test( aShiftedFootThatComesToStandStays ),
		cmocka_unit_test( withoutAShiftAFootLandsWhereItIsMeantToOnStairsToo ),
		cmocka_unit_test( aShiftedFootholdIsSettledBeforeTheFootComesDown ),
		cmocka_unit_test( anUnshiftedFootholdGoesWithTheLandingToTheLast ),
		cmocka_unit_test( aFootIsLiftedOverWhatLiesInItsWay ),
		cmocka_unit_test( onFlatGroundNoFootIsLifted ),
		cmocka_unit_test( whereThereIsNoGroundAheadTheWalkGoesOnAsAnimated ),
		cmocka_unit_test( aMomentWithoutAnswersMovesNothing ),
		cmocka_unit_test( aLandingThatIsSeenLateDoesNotShakeTheBody ),
		cmocka_unit_test( aGaitThatIsNotToldIsLearntFromItsSteps ),
		cmocka_unit_test( inTheAirAFootIsAsAnimated ),
		cmocka_unit_test( aFootLandsOnItsFootholdAtEveryRate ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
