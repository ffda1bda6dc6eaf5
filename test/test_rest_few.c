// SPDX-License-Identifier: MIT
// How a sole rests where little is known of the ground, and how its toes follow what is ahead of the ball.
#include "resting.h"

// ------------------------------------------------------------------------------------------------------ few samples

static void withoutGroundThePlaneIsAtTheReference( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, true );
	soleRest r = testRest( &s );
	assert_true( r.found == false && r.surface == SOLE_NONE );
	assert_float_equal( soleDot( r.plane.point, s.work.up ), -0.3f, 1e-6f );
	testAddLine( &s, 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < 9; ++i )
	{
		s.samples[i].found = false;
	}
	r = testRest( &s );
	assert_true( r.found == false );
	testNear3( r.plane.normal, s.work.up, 0.0f );
	testEndSole( &s );
}

static void oneSampleGivesALevelPlane( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	testAddLine( &s, 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < 9; ++i )
	{
		s.samples[i].found = i == 3;
		s.samples[i].gradient = soleVec( 0.2f, 0.0f, 0.3f );
	}
	s.samples[3].height = 1.07f;
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.07f, 0.0f, 0.0f );
	assert_float_equal( r.confidence, 1.0f / 9.0f, 1e-6f );
	assert_float_equal( r.share, 1.0f / 9.0f, 1e-6f );
	testEndSole( &s );
}

static void aFootThatAsksOnceTakesTheSlopeOfTheFace( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, true );
	soleGroundSample* sample = testAddSample( &s, 0.0f, 0.0f, 0.05f );
	sample->gradient = soleMulAdd( soleScale( 0.3f, s.forward ), -0.2f, s.side );
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.05f + 0.3f * REST_LOAD, 0.3f, -0.2f );
	sample->steep = true;
	r = testRest( &s );
	testNearPlane( &s, &r, 0.05f, 0.0f, 0.0f );
	testEndSole( &s );
}

static void twoSamplesGiveTheSlopeAlongTheFootWhereTheyBracketTheLoad( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	testAddSample( &s, -0.15f, 0.03f, 0.01f );
	testAddSample( &s, 0.05f, -0.02f, 0.03f );
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.01f + 0.1f * ( REST_LOAD + 0.15f ), 0.1f, 0.0f );
	// Both ahead of where the sole bears: it lies flat on the higher one.
	s.leg.sampleCount = 0;
	testAddSample( &s, 0.0f, 0.03f, 0.01f );
	testAddSample( &s, 0.05f, -0.02f, 0.03f );
	r = testRest( &s );
	testNearPlane( &s, &r, 0.03f, 0.0f, 0.0f );
	testEndSole( &s );
}

static void samplesThatAreMissingSayNothing( void** state )
{
	(void)state;
	static testSole s, full;
	uint32_t seed = 9;
	testStartSole( &full, false );
	testAddRows( &full, &seed, 0.01f );
	for ( int32_t round = 0; round < 200; ++round )
	{
		// The same ground with misses in between, and without those places at all.
		testStartSole( &s, false );
		static testSole holes;
		testStartSole( &holes, false );
		for ( int32_t i = 0; i < full.leg.sampleCount; ++i )
		{
			bool found = testRandom( &seed ) % 3u != 0;
			float height = full.samples[i].height - 1.0f;
			testAddSample( &holes, full.ahead[i], full.aside[i], found ? height : 0.5f )->found = found;
			if ( found )
			{
				testAddSample( &s, full.ahead[i], full.aside[i], height );
			}
		}
		soleRest with = testRest( &holes );
		soleRest without = testRest( &s );
		assert_true( with.found == without.found );
		testNear3( with.plane.point, without.plane.point, 0.0f );
		testNear3( with.plane.normal, without.plane.normal, 0.0f );
		float share = (float)s.leg.sampleCount / 18.0f;
		assert_float_equal( with.share, without.share * share, 1e-5f );
		assert_float_equal( with.confidence, without.confidence * share, 1e-5f );
		testEndSole( &s );
		testEndSole( &holes );
	}
	testEndSole( &full );
}

static void placesBesideTheSoleSayNothing( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	testAddLine( &s, 0.0f, 0.0f, 0.0f );
	// A margin of 1 cm around the sole still counts.
	testAddSample( &s, REST_HEEL - 0.02f, 0.0f, 0.3f );
	testAddSample( &s, REST_TOE + 0.02f, 0.0f, 0.3f );
	testAddSample( &s, 0.0f, 0.065f, 0.3f );
	testAddSample( &s, 0.0f, -0.065f, 0.3f );
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.0f, 0.0f, 0.0f );
	testAddSample( &s, REST_TOE + 0.005f, 0.0f, 0.3f );
	// A step just before the toes is not stood on, but in the way.
	r = testRest( &s );
	assert_float_equal( testRestHeight( &s, &r, REST_LOAD, 0.0f ), 0.0f, 1e-5f );
	assert_float_equal( r.sunk, 0.3f, 1e-5f );
	testEndSole( &s );
}

static void aLineCountsTheMiddleOnly( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	testAddLine( &s, 0.0f, 0.0f, 0.0f );
	testAddSample( &s, 0.0f, 0.036f, 0.02f );
	s.work.angles = soleTakeAngles( &s.settings );
	soleRest line = soleRestSole( &s.work, &s.leg, soleMakeFootprint( &s.work, s.center, s.forward, s.work.up ), true );
	testNearPlane( &s, &line, 0.0f, 0.0f, 0.0f );
	soleRest r = testRest( &s );
	assert_true( testRestHeight( &s, &r, 0.0f, 0.036f ) > 0.0199f );
	testEndSole( &s );
}

static void knownIsASoleThatWasAskedForFromEndToEnd( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	for ( int32_t i = 0; i < 9; ++i )
	{
		assert_true( testRestOnLine( &s ).known == false );
		float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)i / 8.0f;
		testAddSample( &s, u, 0.0f, 0.0f )->found = i < 8;
	}
	// Whether anything was met does not matter.
	assert_true( testRestOnLine( &s ).known );
	// Without its middle it is not known.
	for ( int32_t i = 3; i < 6; ++i )
	{
		s.samples[i].place = soleMulAdd( s.center, 1.0f, s.forward );
	}
	assert_true( testRestOnLine( &s ).known == false );
	testEndSole( &s );
}

// ------------------------------------------------------------------------------------------------------------- toes

/// A slope behind the ball and another one ahead of it.
static void addBend( testSole* s, float behind, float ahead )
{
	for ( int32_t i = 0; i < 14; ++i )
	{
		float u = i < 8 ? REST_HEEL * ( 1.0f - (float)( i / 2 ) / 3.5f ) : REST_TOE * (float)( i / 2 - 3 ) / 3.0f;
		testAddSample( s, u, i % 2 == 0 ? 0.03f : -0.03f, u * ( u < 0.0f ? behind : ahead ) );
	}
}

static void toesFollowTheGroundAheadOfTheBall( void** state )
{
	(void)state;
	static testSole s;
	const float slopes[] = { 0.5f, 0.1f, 0.0f, -0.1f, -0.2f };
	for ( int32_t k = 0; k < 10; ++k )
	{
		float behind = k < 5 ? 0.0f : 0.2f;
		float ahead = slopes[k % 5];
		testStartSole( &s, true );
		addBend( &s, behind, ahead );
		soleRest r = testRest( &s );
		testNearPlane( &s, &r, behind * REST_LOAD, behind, 0.0f );
		// As far as toes bend: 15 degrees down.
		assert_float_equal( r.toeSlope, soleMaxF( ahead - behind, -0.26795f ), 1e-3f );
		testEndSole( &s );
		// A foot without toes is rigid: it stands on what is highest.
		testStartSole( &s, false );
		addBend( &s, behind, ahead );
		r = testRest( &s );
		assert_float_equal( r.toeSlope, 0.0f, 0.0f );
		assert_true( testRestHeight( &s, &r, REST_TOE, 0.0f ) > ahead * REST_TOE - 1e-5f );
		testEndSole( &s );
	}
	// Not as steep as a stone's side.
	testStartSole( &s, true );
	addBend( &s, 0.0f, 0.9f );
	assert_float_equal( testRest( &s ).toeSlope, 0.65f, 1e-5f );
	testEndSole( &s );
}

static void toesTiltASoleThatHasLittleElseToStandOn( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, true );
	testAddSample( &s, REST_HEEL, 0.0f, 0.0f );
	testAddSample( &s, 0.05f, 0.03f, 0.03f );
	testAddSample( &s, 0.05f, -0.03f, 0.03f );
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.125f * ( REST_LOAD - REST_HEEL ), 0.125f, 0.0f );
	testEndSole( &s );
}

static void toesClearTheHighestOfWhatIsAhead( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, true );
	addBend( &s, 0.0f, 0.0f );
	testAddSample( &s, 0.04f, 0.0f, 0.02f );
	soleRest r = testRest( &s );
	assert_float_equal( r.toeSlope, 0.5f, 1e-4f );
	testNearPlane( &s, &r, 0.0f, 0.0f, 0.0f );
	assert_float_equal( r.sunk, 0.0f, 1e-6f );
	// Toes that may not bend so far stay inside, and that is told.
	s.settings.ankle.toeUp = 0.2f;
	r = testRest( &s );
	assert_float_equal( r.sunk, 0.02f - 0.04f * tanf( 0.2f ), 1e-5f );
	testEndSole( &s );
}

// --------------------------------------------------------------------------------------------------------- surfaces

static void theSurfaceIsThatOfTheHighestPlace( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, true );
	testAddLine( &s, 0.0f, 0.1f, REST_LOAD );
	for ( int32_t i = 0; i < 9; ++i )
	{
		s.samples[i].surface = i;
		s.samples[i].velocity = soleVec( (float)i, 0.0f, 1.0f );
	}
	s.samples[6].height += 0.005f;
	soleRest r = testRest( &s );
	assert_int_equal( r.surface, 6 );
	testNear3( r.velocity, soleVec( 6.0f, 0.0f, 1.0f ), 0.0f );
	testEndSole( &s );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( withoutGroundThePlaneIsAtTheReference ),
		cmocka_unit_test( oneSampleGivesALevelPlane ),
		cmocka_unit_test( aFootThatAsksOnceTakesTheSlopeOfTheFace ),
		cmocka_unit_test( twoSamplesGiveTheSlopeAlongTheFootWhereTheyBracketTheLoad ),
		cmocka_unit_test( samplesThatAreMissingSayNothing ),
		cmocka_unit_test( placesBesideTheSoleSayNothing ),
		cmocka_unit_test( aLineCountsTheMiddleOnly ),
		cmocka_unit_test( knownIsASoleThatWasAskedForFromEndToEnd ),
		cmocka_unit_test( toesFollowTheGroundAheadOfTheBall ),
		cmocka_unit_test( toesTiltASoleThatHasLittleElseToStandOn ),
		cmocka_unit_test( toesClearTheHighestOfWhatIsAhead ),
		cmocka_unit_test( theSurfaceIsThatOfTheHighestPlace ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
