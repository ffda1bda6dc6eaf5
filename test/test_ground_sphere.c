// SPDX-License-Identifier: MIT
// Moving spheres against triangles: where they touch, what they report, what they pass.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };
static const soleVec3 up = { 0.0f, 1.0f, 0.0f };

static double slowSegmentDistance( testPoint p, testPoint a, testPoint b )
{
	testPoint e = testMinus( b, a );
	double share = testDot( testMinus( p, a ), e ) / testDot( e, e );
	share = fmin( fmax( share, 0.0 ), 1.0 );
	testPoint offset = testMinus( p, testAlong( a, share, e ) );
	return sqrt( testDot( offset, offset ) );
}

static double slowDistance( const testMesh* mesh, int32_t triangle, testPoint p )
{
	testPoint corners[3];
	for ( int k = 0; k < 3; ++k )
	{
		corners[k] = testWide( testCorner( mesh, triangle, k ) );
	}
	testPoint n = testFaceNormal( mesh, triangle );
	double height = testDot( testMinus( p, corners[0] ), n );
	bool over = true;
	double least = HUGE_VAL;
	for ( int k = 0; k < 3; ++k )
	{
		testPoint a = corners[k];
		testPoint b = corners[( k + 1 ) % 3];
		over = over && testDot( testCross( testMinus( b, a ), testMinus( p, a ) ), n ) >= 0.0;
		least = fmin( least, slowSegmentDistance( p, a, b ) );
	}
	return over ? fabs( height ) : least;
}

static double slowMeshDistance( const testMesh* mesh, testPoint p )
{
	double least = HUGE_VAL;
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		least = fmin( least, slowDistance( mesh, i, p ) );
	}
	return least;
}

/// Conservative advancement: the sphere may always move by its distance. sure: it was never as near as that without
/// touching.
static double slowSweep(
    const testMesh* mesh, soleVec3 start, soleVec3 direction, double length, double radius, bool* sure )
{
	double t = 0.0;
	*sure = true;
	for ( int i = 0; i < 400 && t <= length; ++i )
	{
		double gap = slowMeshDistance( mesh, testAlong( testWide( start ), t, testWide( direction ) ) ) - radius;
		if ( gap < 1e-8 )
		{
			*sure = t == 0.0 || fabs( t - length ) > 1e-5;
			return t;
		}
		*sure = *sure && ( gap > 1e-5 || i < 350 );
		t += gap;
	}
	*sure = t > length + 1e-5;
	return HUGE_VAL;
}

static void compareWithSlowSweep( uint32_t seed, const testMesh* mesh, bool fromAbove, float size, int32_t queryCount )
{
	soleGround* ground = testMakeMeshGround( mesh, fromAbove == false );
	int32_t compared = 0;
	int32_t met = 0;
	for ( int32_t i = 0; i < queryCount; ++i )
	{
		soleVec3 start = testRandomPoint( &seed, size );
		soleVec3 direction = testRandomDirection( &seed );
		if ( fromAbove )
		{
			start = soleVec( fabsf( start.x ), size, fabsf( start.z ) );
			direction = i % 2 == 0 ? down : soleNormalizeOr( soleMulAdd( direction, -2.0f, up ), down );
		}
		float length = testRandomFloat( &seed, 0.3f, 3.0f * size );
		float radius = testRandomFloat( &seed, 0.01f, 0.4f );
		bool sure;
		double t = slowSweep( mesh, start, direction, (double)length, (double)radius, &sure );
		soleHit hit = testCast( ground, start, direction, length, radius );
		if ( sure == false )
		{
			continue;
		}
		compared += 1;
		assert_int_equal( hit.hit, t <= (double)length );
		if ( hit.hit == false )
		{
			continue;
		}
		met += 1;
		assert_int_equal( hit.startedInside, t == 0.0 );
		testPoint centre = testAlong( testWide( start ), t, testWide( direction ) );
		testPoint offset = testMinus( testWide( hit.point_w ), centre );
		double distance = sqrt( testDot( offset, offset ) );
		double expected = t == 0.0 ? slowMeshDistance( mesh, centre ) : (double)radius;
		assert_true( fabs( distance - expected ) < 2e-5 );
		assert_true( slowMeshDistance( mesh, testWide( hit.point_w ) ) < 1e-5 );
		assert_float_equal( soleLength( hit.normal_w ), 1.0f, 1e-6f );
		assert_true( hit.startedInside || soleDot( hit.normal_w, direction ) < 1e-5f );
	}
	assert_true( compared > queryCount / 2 && met > queryCount / 10 );
	soleDestroyGround( ground );
}

static void spheresAgreeWithConservativeAdvancement( void** state )
{
	(void)state;
	for ( uint32_t seed = 1; seed <= 4; ++seed )
	{
		testMesh soup = testMakeSoup( seed, 40, 3.0f, 1.0f );
		compareWithSlowSweep( seed * 101, &soup, false, 3.0f, 1500 );
		testFreeMesh( &soup );
		testMesh terrain = testMakeTerrain( seed, 6, 0.5f, 0.7f );
		compareWithSlowSweep( seed * 103, &terrain, true, 2.5f, 1000 );
		testFreeMesh( &terrain );
	}
}

static void aFlatGridIsOneFloor( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 1, 20, 0.1f, 0.0f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	uint32_t seed = 5;
	for ( int32_t i = 0; i < 20000; ++i )
	{
		soleVec3 start = { testRandomFloat( &seed, 0.3f, 1.7f ), 0.5f, testRandomFloat( &seed, 0.3f, 1.7f ) };
		if ( i % 2 == 0 )
		{
			start.x = 0.1f * (float)( 3 + testRandom( &seed ) % 15 ); // over edges and corners
			start.z = i % 4 == 0 ? 0.1f * (float)( 3 + testRandom( &seed ) % 15 ) : start.z;
		}
		float radius = testRandomFloat( &seed, 0.02f, 0.2f );
		soleVec3 slanted = { testRandomFloat( &seed, -0.5f, 0.5f ), -1.0f, testRandomFloat( &seed, -0.5f, 0.5f ) };
		soleVec3 direction = i % 3 == 0 ? soleNormalizeOr( slanted, down ) : down;
		soleHit hit = testCast( ground, start, direction, 1.0f, radius );
		float t = ( start.y - radius ) / -direction.y;
		assert_true( hit.hit && hit.startedInside == false );
		testNear3( hit.point_w, soleMulAdd( soleMulAdd( start, t, direction ), radius, down ), 1e-6f );
		testNear3( hit.normal_w, up, 0.0f );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

/// One step of a stair along +z: tread at 0 up to z = 0, riser down to -0.2, tread below.
static testMesh makeStep( bool riserFirst )
{
	static const float vertices[8][3] = { { -1, 0, -1 }, { 1, 0, -1 }, { -1, 0, 0 }, { 1, 0, 0 }, { -1, -0.2f, 0 },
		{ 1, -0.2f, 0 }, { -1, -0.2f, 1 }, { 1, -0.2f, 1 } };
	static const uint32_t treads[12] = { 0, 2, 1, 1, 2, 3, 4, 6, 5, 5, 6, 7 };
	static const uint32_t riser[6] = { 2, 4, 3, 3, 4, 5 };
	testMesh mesh = testAllocMesh( 8, 6 );
	memcpy( mesh.vertices, vertices, sizeof vertices );
	memcpy( mesh.indices + ( riserFirst ? 6 : 0 ), treads, sizeof treads );
	memcpy( mesh.indices + ( riserFirst ? 0 : 12 ), riser, sizeof riser );
	return mesh;
}

static void aNosingIsReportedAsItsTread( void** state )
{
	(void)state;
	uint32_t seed = 7;
	for ( int order = 0; order < 2; ++order )
	{
		testMesh mesh = makeStep( order == 1 );
		soleGround* ground = testMakeMeshGround( &mesh, false );
		for ( int32_t i = 0; i < 500; ++i )
		{
			float beyond = testRandomFloat( &seed, 0.001f, 0.049f );
			soleHit hit = testCast( ground, soleVec( 0.3f, 0.5f, beyond ), down, 2.0f, 0.05f );
			assert_true( hit.hit && hit.startedInside == false );
			testNear3( hit.normal_w, up, 1e-6f );
			testNear3( hit.point_w, soleVec( 0.3f, 0.0f, 0.0f ), 1e-6f );
			hit = testCast( ground, soleVec( 0.3f, 0.5f, 0.051f + beyond ), down, 2.0f, 0.05f );
			testNear3( hit.normal_w, up, 1e-6f );
			assert_float_equal( hit.point_w.y, -0.2f, 1e-6f );
		}
		// Level with the riser the riser is met.
		soleHit hit = testCast( ground, soleVec( 0.3f, -0.1f, 0.5f ), soleVec( 0.0f, 0.0f, -1.0f ), 1.0f, 0.05f );
		testNear3( hit.normal_w, soleVec( 0.0f, 0.0f, 1.0f ), 1e-6f );
		testNear3( hit.point_w, soleVec( 0.3f, -0.1f, 0.0f ), 1e-6f );
		soleDestroyGround( ground );
		testFreeMesh( &mesh );
	}
}

static void whatTouchesAtTheStartIsStartedInside( void** state )
{
	(void)state;
	testMesh mesh = makeStep( false );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	soleHit hit = testCast( ground, soleVec( 0.1f, 0.03f, -0.5f ), down, 1.0f, 0.05f );
	assert_true( hit.hit && hit.startedInside );
	testNear3( hit.point_w, soleVec( 0.1f, 0.0f, -0.5f ), 1e-6f );
	testNear3( hit.normal_w, up, 1e-6f );
	// Also where it moves away, and the nearer of two wins.
	hit = testCast( ground, soleVec( 0.1f, -0.17f, 0.02f ), up, 1.0f, 0.05f );
	assert_true( hit.hit && hit.startedInside );
	testNear3( hit.point_w, soleVec( 0.1f, -0.17f, 0.0f ), 1e-6f );
	testNear3( hit.normal_w, soleVec( 0.0f, 0.0f, 1.0f ), 1e-6f );
	// Behind a face is no touch.
	assert_false( testCast( ground, soleVec( 0.1f, -0.01f, -0.5f ), down, 1.0f, 0.05f ).hit );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void aSmallerSphereNearsTheRay( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 13, 10, 0.3f, 0.2f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	uint32_t seed = 19;
	for ( int32_t i = 0; i < 2000; ++i )
	{
		soleVec3 start = { testRandomFloat( &seed, 0.1f, 2.9f ), 1.0f, testRandomFloat( &seed, 0.1f, 2.9f ) };
		soleHit ray = testCast( ground, start, down, 2.0f, 0.0f );
		soleHit sphere = testCast( ground, start, down, 2.0f, 1e-5f );
		assert_true( ray.hit && sphere.hit );
		testNear3( ray.point_w, sphere.point_w, 5e-5f );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void noSphereFallsThroughATerrain( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 3, 30, 0.2f, 0.5f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	uint32_t seed = 23;
	for ( int32_t i = 0; i < 20000; ++i )
	{
		const float* p = mesh.vertices + 3 * ( testRandom( &seed ) % (uint32_t)mesh.vertexCount );
		const float* q = mesh.vertices + 3 * ( testRandom( &seed ) % (uint32_t)mesh.vertexCount );
		soleVec3 start = { p[0], 2.0f, i % 2 == 0 ? q[2] : testRandomFloat( &seed, 0.0f, 6.0f ) };
		assert_true( testCast( ground, start, down, 4.0f, testRandomFloat( &seed, 0.001f, 0.3f ) ).hit );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( spheresAgreeWithConservativeAdvancement ),
		cmocka_unit_test( aFlatGridIsOneFloor ),
		cmocka_unit_test( aNosingIsReportedAsItsTread ),
		cmocka_unit_test( whatTouchesAtTheStartIsStartedInside ),
		cmocka_unit_test( aSmallerSphereNearsTheRay ),
		cmocka_unit_test( noSphereFallsThroughATerrain ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
