// SPDX-License-Identifier: MIT
// How a sole rests on sampled ground: the plane against brute force in double, slopes, steep faces, levels.
#include "resting.h"

// ------------------------------------------------------------------------------------------------------- the plane

/// Height over the load point of the highest point of all triangles that hold it: in double, by their weights.
static double liftOfTriangles( const testSole* s )
{
	double highest = -1e9;
	int32_t n = s->leg.sampleCount;
	for ( int32_t i = 0; i < n; ++i )
	{
		for ( int32_t j = 0; j < n; ++j )
		{
			for ( int32_t k = 0; k < n; ++k )
			{
				const int32_t at[3] = { i, j, k };
				double u[3], v[3], h[3];
				for ( int32_t m = 0; m < 3; ++m )
				{
					u[m] = (double)s->ahead[at[m]] - (double)REST_LOAD;
					v[m] = (double)s->aside[at[m]];
					h[m] = (double)s->samples[at[m]].height / (double)s->work.rootScale - 1.0;
				}
				// Areas of the triangles that the load point, the origin, makes with each edge.
				double a = u[1] * v[2] - u[2] * v[1];
				double b = u[2] * v[0] - u[0] * v[2];
				double c = u[0] * v[1] - u[1] * v[0];
				double all = a + b + c;
				if ( a >= 0.0 && b >= 0.0 && c >= 0.0 && all > 1e-7 )
				{
					highest = fmax( highest, ( a * h[0] + b * h[1] + c * h[2] ) / all );
				}
			}
		}
	}
	return highest;
}

static void thePlaneIsTheLowestThatLiesOnAllSamples( void** state )
{
	(void)state;
	static testSole s;
	uint32_t seed = 17;
	for ( int32_t round = 0; round < 1000; ++round )
	{
		testStartSole( &s, false );
		soleQuat q = soleNormalizeQuat( ( soleQuat ){ testRandomFloat( &seed, -1.0f, 1.0f ),
		    testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ), 0.3f } );
		testTurnSole( &s, q, round % 3 == 0 ? 1.0f : testRandomFloat( &seed, 0.05f, 20.0f ) );
		testAddRows( &s, &seed, 0.01f );
		soleRest r = testRest( &s );
		for ( int32_t i = 0; i < s.leg.sampleCount; ++i )
		{
			float under =
			    testRestHeight( &s, &r, s.ahead[i], s.aside[i] ) - ( s.samples[i].height / s.work.rootScale - 1.0f );
			assert_true( under > -2e-5f );
		}
		assert_float_equal( testRestHeight( &s, &r, REST_LOAD, 0.0f ), (float)liftOfTriangles( &s ), 3e-5f );
		testEndSole( &s );
	}
}

static void anyHeightsAtAnyPlacesAreAllUnderThePlane( void** state )
{
	(void)state;
	static testSole s;
	uint32_t seed = 5;
	for ( int32_t round = 0; round < 4000; ++round )
	{
		bool toes = round % 2 == 0;
		testStartSole( &s, toes );
		int32_t count = 1 + (int32_t)( testRandom( &seed ) % 18u );
		float wild = round % 4 < 2 ? 0.02f : 0.2f;
		for ( int32_t i = 0; i < count; ++i )
		{
			float ahead = testRandomFloat( &seed, REST_HEEL, toes ? 0.0f : REST_TOE );
			soleGroundSample* sample = testAddSample(
			    &s, ahead, testRandomFloat( &seed, -0.045f, 0.045f ), testRandomFloat( &seed, -wild, wild ) );
			sample->steep = testRandom( &seed ) % 8u == 0;
		}
		soleRest r = testRest( &s );
		float deepest = 0.0f;
		for ( int32_t i = 0; i < count; ++i )
		{
			float under = testRestHeight( &s, &r, s.ahead[i], s.aside[i] ) - ( s.samples[i].height - 1.0f );
			deepest = fminf( deepest, under );
		}
		// Those of lower levels count for nothing, and are told: the plane may dip under them.
		assert_true( deepest > -1e-5f || r.onEdge );
		assert_float_equal( r.sunk, -deepest, 2e-5f );
		float slope = soleLength( r.plane.gradient );
		assert_true( slope < 1.7f ); // 50 degrees along the foot and across
		testEndSole( &s );
	}
}

static void anEvenSlopeIsThePlane( void** state )
{
	(void)state;
	static testSole s;
	for ( int32_t toes = 0; toes < 2; ++toes )
	{
		testStartSole( &s, toes == 1 );
		for ( int32_t i = 0; i < 18; ++i )
		{
			float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)( i / 2 ) / 8.0f;
			float v = i % 2 == 0 ? 0.04f : -0.04f;
			testAddSample( &s, u, v, 0.4f * u - 0.3f * v );
		}
		soleRest r = testRest( &s );
		testNearPlane( &s, &r, 0.4f * REST_LOAD, 0.4f, -0.3f );
		assert_float_equal( r.toeSlope, 0.0f, 1e-5f );
		assert_float_equal( r.share, 1.0f, 0.0f );
		assert_float_equal( r.confidence, 1.0f, 0.0f );
		assert_true( r.known && r.onEdge == false && r.steep == false );
		testEndSole( &s );
	}
}

static void aSlopeThatIsTooSteepIsClampedAndStillTouches( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	s.settings.support.maxSlope = 0.3f;
	for ( int32_t i = 0; i < 10; ++i )
	{
		float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)( i / 2 ) / 4.0f;
		testAddSample( &s, u, i % 2 == 0 ? 0.04f : -0.04f, 0.5f * u );
	}
	soleRest r = testRest( &s );
	// It turns about its toe tip, where the ground is highest.
	float most = tanf( 0.3f );
	testNearPlane( &s, &r, 0.5f * REST_TOE + most * ( REST_LOAD - REST_TOE ), most, 0.0f );
	testEndSole( &s );
}

// ------------------------------------------------------------------------------------------------------ steep faces

static void steepSamplesHoldUpButDoNotTilt( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	for ( int32_t i = 0; i < 10; ++i )
	{
		float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)( i / 2 ) / 4.0f;
		soleGroundSample* sample = testAddSample( &s, u, i % 2 == 0 ? 0.04f : -0.04f, i < 8 ? 0.0f : 0.02f );
		sample->steep = i >= 8;
	}
	soleRest r = testRest( &s );
	testNearPlane( &s, &r, 0.02f, 0.0f, 0.0f );
	assert_true( r.steep == false );
	// The same heights on faces that can be walked on do tilt it.
	s.samples[8].steep = false;
	s.samples[9].steep = false;
	r = testRest( &s );
	assert_true( soleDot( r.plane.gradient, s.forward ) > 0.05f );
	testEndSole( &s );
}

static void groundThatIsMostlySteepIsToldAndLevel( void** state )
{
	(void)state;
	static testSole s;
	testStartSole( &s, false );
	for ( int32_t i = 0; i < 10; ++i )
	{
		float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)( i / 2 ) / 4.0f;
		soleGroundSample* sample = testAddSample( &s, u, i % 2 == 0 ? 0.04f : -0.04f, 0.3f * u );
		sample->steep = i < 6;
	}
	soleRest r = testRest( &s );
	assert_true( r.steep );
	testNearPlane( &s, &r, 0.3f * REST_TOE, 0.0f, 0.0f );
	testEndSole( &s );
}

// ----------------------------------------------------------------------------------------------------------- levels

static void theHighestLevelCarries( void** state )
{
	(void)state;
	static testSole s;
	const float edges[] = { -0.15f, -0.09f, 0.03f };
	for ( int32_t k = 0; k < 6; ++k )
	{
		bool up = k < 3;
		testStartSole( &s, false );
		testAddLine( &s, up ? 0.0f : 0.12f, up ? 0.12f : 0.0f, edges[k % 3] );
		soleRest r = testRest( &s );
		testNearPlane( &s, &r, 0.12f, 0.0f, 0.0f );
		assert_true( r.onEdge );
		int32_t bearing = 0, fore = 0, rear = 0, foreAll = 0;
		for ( int32_t i = 0; i < 9; ++i )
		{
			bool bears = ( s.ahead[i] >= edges[k % 3] ) == up;
			bool ahead = s.ahead[i] > 0.1f * REST_TOE;
			bearing += bears;
			fore += bears && ahead;
			rear += bears && ahead == false;
			foreAll += ahead;
		}
		assert_float_equal( r.share, (float)bearing / 9.0f, 1e-6f );
		assert_float_equal( r.foreShare, (float)fore / (float)foreAll, 1e-6f );
		assert_float_equal( r.rearShare, (float)rear / (float)( 9 - foreAll ), 1e-6f );
		assert_float_equal( r.confidence, 1.0f - 0.5f * (float)( 9 - bearing ) / 9.0f, 1e-6f );
		testEndSole( &s );
	}
}

static void aStepIsALevelOfItsOwnFrom45DegreesAndAGapOn( void** state )
{
	(void)state;
	static testSole s;
	float apart = ( REST_TOE - REST_HEEL ) / 8.0f;
	float gap = soleDefaultSettings().support.levelGap * 0.9f;
	for ( int32_t over = 0; over < 2; ++over )
	{
		testStartSole( &s, false );
		float step = apart + gap + ( over == 1 ? 1e-3f : -1e-3f );
		testAddLine( &s, 0.0f, step, REST_LOAD + 0.01f );
		soleRest r = testRest( &s );
		assert_true( r.onEdge == ( over == 1 ) );
		assert_true( ( soleDot( r.plane.gradient, s.forward ) > 0.1f ) == ( over == 0 ) );
		testEndSole( &s );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( thePlaneIsTheLowestThatLiesOnAllSamples ),
		cmocka_unit_test( anyHeightsAtAnyPlacesAreAllUnderThePlane ),
		cmocka_unit_test( anEvenSlopeIsThePlane ),
		cmocka_unit_test( aSlopeThatIsTooSteepIsClampedAndStillTouches ),
		cmocka_unit_test( steepSamplesHoldUpButDoNotTilt ),
		cmocka_unit_test( groundThatIsMostlySteepIsToldAndLevel ),
		cmocka_unit_test( theHighestLevelCarries ),
		cmocka_unit_test( aStepIsALevelOfItsOwnFrom45DegreesAndAGapOn ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
