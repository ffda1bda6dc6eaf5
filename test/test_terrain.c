// SPDX-License-Identifier: MIT
// The terrain that feet are measured against, on shapes whose gaps and depths are known.
#include "measure_rig.h"

#include "sole/measure.h"

static soleTerrain* makeTerrain( const float* positions, int32_t vertexCount, const uint32_t* indices, int32_t count )
{
	soleTerrain* terrain = NULL;
	soleMessage message = { { 0 } };
	assert_int_equal( soleCreateTerrain( positions, vertexCount, indices, count, soleVec( 0.0f, 1.0f, 0.0f ), NULL,
	                      &terrain, &message ),
	    sole_success );
	return terrain;
}

/// Treads of 0.29 m rising 0.17 m along z, 2 m wide, with risers and nothing below: tread k is at z 0.29 k.
static soleTerrain* makeStairs( void )
{
	enum
	{
		STEPS = 8
	};
	float positions[STEPS * 4 * 3];
	uint32_t indices[STEPS * 4 * 3];
	for ( int32_t k = 0; k < STEPS; ++k )
	{
		float y = 0.17f * (float)k;
		float z = 0.29f * (float)k;
		float corners[12] = { -1.0f, y, z, 1.0f, y, z, -1.0f, y, z + 0.29f, 1.0f, y, z + 0.29f };
		memcpy( positions + 12 * k, corners, sizeof corners );
		uint32_t v = (uint32_t)( 4 * k );
		uint32_t n = k + 1 < STEPS ? v + 4 : v;
		uint32_t faces[12] = { v, v + 2, v + 3, v, v + 3, v + 1, v + 2, n, n + 1, v + 2, n + 1, v + 3 };
		memcpy( indices + 12 * k, faces, sizeof faces );
	}
	return makeTerrain( positions, STEPS * 4, indices, STEPS * 4 );
}

static void gapOverAPlaneIsHeight( void** state )
{
	(void)state;
	soleTerrain* terrain = rigMakePlane( 0.25f, 0.0f );
	testNearD( soleTerrain_GetGap( terrain, soleVec( 3.0f, 0.75f, -4.0f ), 1.0 ), 0.5, 1e-12 );
	testNearD( soleTerrain_GetGap( terrain, soleVec( 3.0f, 0.0f, -4.0f ), 1.0 ), -0.25, 1e-12 );
	testNearD( soleTerrain_GetDepth( terrain, soleVec( 3.0f, 0.75f, -4.0f ), 1.0 ), 0.0, 0.0 );
	testNearD( soleTerrain_GetDepth( terrain, soleVec( 3.0f, 0.0f, -4.0f ), 1.0 ), 0.25, 1e-12 );
	// The diagonal belongs to both triangles or to either, never to none.
	for ( int32_t i = -100; i <= 100; ++i )
	{
		float x = 0.1777f * (float)i;
		testNearD( soleTerrain_GetGap( terrain, soleVec( x, 0.25f, x ), 1.0 ), 0.0, 1e-12 );
	}
	soleDestroyTerrain( terrain );
}

static void noGroundGivesNoGapAndNoDepth( void** state )
{
	(void)state;
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	assert_true( isnan( soleTerrain_GetGap( terrain, soleVec( 21.0f, 0.0f, 0.0f ), 1.0 ) ) );
	testNearD( soleTerrain_GetDepth( terrain, soleVec( 21.0f, -1.0f, 0.0f ), 1.0 ), 0.0, 0.0 );
	// Too far below to be inside.
	assert_true( isnan( soleTerrain_GetGap( terrain, soleVec( 0.0f, -1.01f, 0.0f ), 1.0 ) ) );
	float bad = nanf( "" );
	assert_true( isnan( soleTerrain_GetGap( terrain, soleVec( bad, 0.0f, 0.0f ), 1.0 ) ) );
	testNearD( soleTerrain_GetDepth( terrain, soleVec( 0.0f, bad, 0.0f ), 1.0 ), 0.0, 0.0 );
	soleDestroyTerrain( terrain );
}

static void depthInARampIsAcrossIt( void** state )
{
	(void)state;
	float slope = 0.5f;
	soleTerrain* terrain = rigMakePlane( 0.0f, slope );
	soleVec3 p = soleVec( 1.0f, 0.5f * 2.0f - 0.1f, 2.0f );
	testNearD( soleTerrain_GetGap( terrain, p, 1.0 ), -0.1, 1e-6 );
	testNearD( soleTerrain_GetDepth( terrain, p, 1.0 ), 0.1 / sqrt( 1.25 ), 1e-6 );
	soleDestroyTerrain( terrain );
}

static void toeJustInsideARiserIsNotDeep( void** state )
{
	(void)state;
	soleTerrain* terrain = makeStairs();
	// 3 mm into the riser at z = 0.58, 20 mm over the tread in front of it.
	soleVec3 p = soleVec( 0.1f, 0.17f + 0.02f, 0.58f + 0.003f );
	testNearD( soleTerrain_GetGap( terrain, p, 0.5 ), -0.15, 1e-6 );
	testNearD( soleTerrain_GetDepth( terrain, p, 0.5 ), 0.003, 1e-6 );
	// As far from the riser as from the tread above.
	p = soleVec( 0.1f, 0.34f - 0.01f, 0.58f + 0.01f );
	testNearD( soleTerrain_GetDepth( terrain, p, 0.5 ), 0.01, 1e-6 );
	soleDestroyTerrain( terrain );
}

static void reachChoosesTheStorey( void** state )
{
	(void)state;
	float positions[] = { -1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1, -1, 2, -1, -1, 2, 1, 1, 2, 1, 1, 2, -1 };
	uint32_t indices[] = { 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7 };
	soleTerrain* terrain = makeTerrain( positions, 8, indices, 4 );
	soleVec3 p = soleVec( 0.2f, 0.5f, 0.1f );
	testNearD( soleTerrain_GetGap( terrain, p, 1.0 ), 0.5, 1e-12 );
	testNearD( soleTerrain_GetGap( terrain, p, 1.6 ), -1.5, 1e-12 );
	soleDestroyTerrain( terrain );
}

static void facesThatLookDownCarryNothingButBoundDepth( void** state )
{
	(void)state;
	// A slab from 0 to 0.1: its underside looks down.
	float positions[] = { -1, 0.1f, -1, -1, 0.1f, 1, 1, 0.1f, 1, 1, 0.1f, -1, -1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1 };
	uint32_t indices[] = { 0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6 };
	soleTerrain* terrain = makeTerrain( positions, 8, indices, 4 );
	soleVec3 p = soleVec( 0.2f, 0.03f, 0.1f );
	testNearD( soleTerrain_GetGap( terrain, p, 0.5 ), -0.07, 1e-6 );
	testNearD( soleTerrain_GetDepth( terrain, p, 0.5 ), 0.03, 1e-6 );
	soleDestroyTerrain( terrain );
}

/// A bumpy grid of n by n cells, 4 m wide.
static void makeBumps( int32_t n, float* positions, uint32_t* indices )
{
	for ( int32_t i = 0; i <= n; ++i )
	{
		for ( int32_t k = 0; k <= n; ++k )
		{
			float* p = positions + 3 * ( i * ( n + 1 ) + k );
			p[0] = 4.0f * (float)i / (float)n - 2.0f;
			p[2] = 4.0f * (float)k / (float)n - 2.0f;
			p[1] = 0.1f * sinf( 3.0f * p[0] ) * cosf( 4.0f * p[2] );
		}
	}
	for ( int32_t i = 0; i < n * n; ++i )
	{
		uint32_t v = (uint32_t)( i / n * ( n + 1 ) + i % n );
		uint32_t w = v + (uint32_t)n + 1;
		uint32_t faces[6] = { v, v + 1, w + 1, v, w + 1, w };
		memcpy( indices + 6 * i, faces, sizeof faces );
	}
}

static double segmentDistance( soleVec3 p, soleVec3 a, soleVec3 b )
{
	// By ternary search: slow, and nothing like the code under test.
	float low = 0.0f;
	float high = 1.0f;
	for ( int32_t i = 0; i < 60; ++i )
	{
		float s = low + ( high - low ) / 3.0f;
		float t = high - ( high - low ) / 3.0f;
		bool left = soleDistance( p, soleLerp( a, b, s ) ) < soleDistance( p, soleLerp( a, b, t ) );
		low = left ? low : s;
		high = left ? t : high;
	}
	return (double)soleDistance( p, soleLerp( a, b, low ) );
}

/// Distance to a triangle: least over segments from its corner to the opposite side, found by ternary search.
static double faceDistance( soleVec3 p, soleVec3 a, soleVec3 b, soleVec3 c )
{
	float low = 0.0f;
	float high = 1.0f;
	for ( int32_t i = 0; i < 60; ++i )
	{
		float s = low + ( high - low ) / 3.0f;
		float t = high - ( high - low ) / 3.0f;
		bool left = segmentDistance( p, a, soleLerp( b, c, s ) ) < segmentDistance( p, a, soleLerp( b, c, t ) );
		low = left ? low : s;
		high = left ? t : high;
	}
	return segmentDistance( p, a, soleLerp( b, c, low ) );
}

static void depthIsThatOfSearchingAllTriangles( void** state )
{
	(void)state;
	enum
	{
		N = 6
	};
	float positions[3 * ( N + 1 ) * ( N + 1 )];
	uint32_t indices[6 * N * N];
	makeBumps( N, positions, indices );
	soleTerrain* terrain = makeTerrain( positions, ( N + 1 ) * ( N + 1 ), indices, 2 * N * N );
	uint32_t seed = 7;
	for ( int32_t i = 0; i < 12; ++i )
	{
		soleVec3 p = soleVec( testRandomFloat( &seed, -1.9f, 1.9f ), testRandomFloat( &seed, -1.2f, -0.12f ),
		    testRandomFloat( &seed, -1.9f, 1.9f ) );
		double nearest = 1e9;
		for ( int32_t f = 0; f < 2 * N * N; ++f )
		{
			soleVec3 c[3];
			for ( int32_t k = 0; k < 3; ++k )
			{
				const float* v = positions + 3 * indices[3 * f + k];
				c[k] = soleVec( v[0], v[1], v[2] );
			}
			double d = faceDistance( p, c[0], c[1], c[2] );
			nearest = d < nearest ? d : nearest;
		}
		testNearD( soleTerrain_GetDepth( terrain, p, 10.0 ), nearest, 2e-4 );
	}
	soleDestroyTerrain( terrain );
}

static void everyPointOverAMeshHasAGapWhicheverWayIsUp( void** state )
{
	(void)state;
	enum
	{
		N = 40
	};
	static float positions[3 * ( N + 1 ) * ( N + 1 )];
	static float turned[3 * ( N + 1 ) * ( N + 1 )];
	static uint32_t indices[6 * N * N];
	makeBumps( N, positions, indices );
	soleTerrain* upright = makeTerrain( positions, ( N + 1 ) * ( N + 1 ), indices, 2 * N * N );
	soleQuat turn = soleNormalizeQuat( ( soleQuat ){ 0.4f, -0.3f, 0.7f, 0.2f } );
	for ( int32_t i = 0; i < ( N + 1 ) * ( N + 1 ); ++i )
	{
		soleVec3 p = soleRotate( turn, soleVec( positions[3 * i], positions[3 * i + 1], positions[3 * i + 2] ) );
		turned[3 * i] = p.x;
		turned[3 * i + 1] = p.y;
		turned[3 * i + 2] = p.z;
	}
	soleTerrain* aslant = NULL;
	assert_int_equal( soleCreateTerrain( turned, ( N + 1 ) * ( N + 1 ), indices, 2 * N * N,
	                      soleRotate( turn, soleVec( 0.0f, 1.0f, 0.0f ) ), NULL, &aslant, NULL ),
	    sole_success );
	uint32_t seed = 99;
	for ( int32_t i = 0; i < 20000; ++i )
	{
		soleVec3 p = soleVec( testRandomFloat( &seed, -1.999f, 1.999f ), testRandomFloat( &seed, -0.5f, 0.5f ),
		    testRandomFloat( &seed, -1.999f, 1.999f ) );
		double gap = soleTerrain_GetGap( upright, p, 2.0 );
		double height = (double)p.y - gap;
		double truth = 0.1 * sin( 3.0 * (double)p.x ) * cos( 4.0 * (double)p.z );
		testNearD( height, truth, 0.004 ); // the mesh is no finer than that
		soleVec3 q = soleRotate( turn, p );
		testNearD( soleTerrain_GetGap( aslant, q, 2.0 ), gap, 2e-6 );
		testNearD( soleTerrain_GetDepth( aslant, q, 2.0 ), soleTerrain_GetDepth( upright, p, 2.0 ), 2e-6 );
	}
	soleDestroyTerrain( upright );
	soleDestroyTerrain( aslant );
}

static void longThinTrianglesDoNotFillTheGrid( void** state )
{
	(void)state;
	// A fan of slivers across 200 m.
	enum
	{
		N = 2000
	};
	static float positions[3 * ( N + 2 )];
	static uint32_t indices[3 * N];
	for ( int32_t i = 0; i <= N; ++i )
	{
		positions[3 * i] = 100.0f;
		positions[3 * i + 2] = 200.0f * (float)i / N - 100.0f;
	}
	positions[3 * N + 3] = -100.0f;
	for ( uint32_t i = 0; i < N; ++i )
	{
		uint32_t face[3] = { N + 1, i + 1, i };
		memcpy( indices + 3 * i, face, sizeof face );
	}
	soleTerrain* terrain = makeTerrain( positions, N + 2, indices, N );
	testNearD( soleTerrain_GetGap( terrain, soleVec( 50.0f, 0.1f, 3.0f ), 1.0 ), 0.1, 1e-6 );
	testNearD( soleTerrain_GetDepth( terrain, soleVec( 50.0f, -0.1f, 3.0f ), 1.0 ), 0.1, 1e-6 );
	soleDestroyTerrain( terrain );
}

static void badTerrainsAreRefusedWithAMend( void** state )
{
	(void)state;
	float positions[] = { 0, 0, 0, 0, 0, 1, 1, 0, 0 };
	uint32_t indices[] = { 0, 1, 2 };
	soleVec3 up = soleVec( 0.0f, 1.0f, 0.0f );
	soleTerrain* terrain = NULL;
	soleMessage message;
	assert_int_equal(
	    soleCreateTerrain( positions, 3, indices, 0, up, NULL, &terrain, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "triangleCount" ) );
	assert_int_equal( soleCreateTerrain( positions, 3, indices, 1, soleVec( 0, 0, 0 ), NULL, &terrain, &message ),
	    sole_invalidDefinition );
	assert_non_null( strstr( message.text, "up" ) );
	indices[1] = 3;
	assert_int_equal(
	    soleCreateTerrain( positions, 3, indices, 1, up, NULL, &terrain, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "vertex 3" ) );
	indices[1] = 1;
	positions[4] = INFINITY;
	assert_int_equal(
	    soleCreateTerrain( positions, 3, indices, 1, up, NULL, &terrain, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "not finite" ) );
	assert_null( terrain );
	soleDestroyTerrain( NULL );
}

static void failingMemoryLeavesNothingBehind( void** state )
{
	(void)state;
	float positions[] = { 0, 0, 0, 0, 0, 1, 1, 0, 0 };
	uint32_t indices[] = { 0, 1, 2 };
	for ( int32_t n = 0;; ++n )
	{
		rigMemory memory = { .left = n };
		soleAllocator allocator = { rigAlloc, rigFree, &memory };
		soleTerrain* terrain = NULL;
		soleResult result =
		    soleCreateTerrain( positions, 3, indices, 1, soleVec( 0.0f, 1.0f, 0.0f ), &allocator, &terrain, NULL );
		soleDestroyTerrain( terrain );
		assert_int_equal( memory.held, 0 );
		if ( result == sole_success )
		{
			assert_true( n > 1 );
			break;
		}
		assert_int_equal( result, sole_outOfMemory );
		assert_null( terrain );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( gapOverAPlaneIsHeight ),
		cmocka_unit_test( noGroundGivesNoGapAndNoDepth ),
		cmocka_unit_test( depthInARampIsAcrossIt ),
		cmocka_unit_test( toeJustInsideARiserIsNotDeep ),
		cmocka_unit_test( reachChoosesTheStorey ),
		cmocka_unit_test( facesThatLookDownCarryNothingButBoundDepth ),
		cmocka_unit_test( depthIsThatOfSearchingAllTriangles ),
		cmocka_unit_test( everyPointOverAMeshHasAGapWhicheverWayIsUp ),
		cmocka_unit_test( longThinTrianglesDoNotFillTheGrid ),
		cmocka_unit_test( badTerrainsAreRefusedWithAMend ),
		cmocka_unit_test( failingMemoryLeavesNothingBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
