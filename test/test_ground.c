// SPDX-License-Identifier: MIT
// Triangles asked with rays: the nearest is met, and no ray finds a crack.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

/// Möller and Trumbore's test in double. border: how near to leaving the triangle, as a share of it; below zero
/// outside.
static double slowRay( const testMesh* mesh, int32_t triangle, soleVec3 start, soleVec3 direction, double* border )
{
	testPoint a = testWide( testCorner( mesh, triangle, 0 ) );
	testPoint u = testMinus( testWide( testCorner( mesh, triangle, 1 ) ), a );
	testPoint v = testMinus( testWide( testCorner( mesh, triangle, 2 ) ), a );
	testPoint d = testWide( direction );
	testPoint s = testMinus( testWide( start ), a );
	testPoint p = testCross( d, v );
	double determinant = testDot( u, p );
	*border = -1.0;
	if ( fabs( determinant ) < 1e-12 )
	{
		return HUGE_VAL;
	}
	double b = testDot( s, p ) / determinant;
	testPoint q = testCross( s, u );
	double c = testDot( d, q ) / determinant;
	*border = fmin( fmin( b, c ), 1.0 - b - c );
	return testDot( v, q ) / determinant;
}

/// Nearest of all, slowly. sure: no triangle on the way is met so near to its border that rounding may decide.
static double slowCast( const testMesh* mesh, soleVec3 start, soleVec3 direction, double length, bool twoSided,
    int32_t* nearest, bool* sure )
{
	double best = HUGE_VAL;
	*nearest = SOLE_NONE;
	*sure = true;
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		double border;
		double t = slowRay( mesh, i, start, direction, &border );
		double facing = testDot( testFaceNormal( mesh, i ), testWide( direction ) );
		bool unclear = fabs( border ) < 1e-4 || fabs( t ) < 1e-5 || fabs( t - length ) < 1e-5 || fabs( facing ) < 1e-3;
		if ( unclear && border > -1e-3 )
		{
			*sure = false;
		}
		if ( border >= 0.0 && t >= 0.0 && t <= length && t < best && ( twoSided || facing < 0.0 ) )
		{
			best = t;
			*nearest = i;
		}
	}
	return best;
}

static void compareWithSlowCast( uint32_t seed, const testMesh* mesh, bool twoSided, int32_t queryCount, float size )
{
	soleGround* ground = testMakeMeshGround( mesh, twoSided );
	int32_t compared = 0;
	for ( int32_t i = 0; i < queryCount; ++i )
	{
		soleVec3 start = testRandomPoint( &seed, size );
		soleVec3 direction = i % 3 == 0 ? down : testRandomDirection( &seed );
		float length = testRandomFloat( &seed, 0.5f, 3.0f * size );
		int32_t nearest;
		bool sure;
		double t = slowCast( mesh, start, direction, (double)length, twoSided, &nearest, &sure );
		soleHit hit = testCast( ground, start, direction, length, 0.0f );
		if ( sure == false )
		{
			continue;
		}
		compared += 1;
		assert_int_equal( hit.hit, nearest != SOLE_NONE );
		if ( hit.hit )
		{
			testNear3( hit.point_w, soleMulAdd( start, (float)t, direction ), 1e-5f * size );
			testPoint n = testFaceNormal( mesh, nearest );
			float sign = soleDot( hit.normal_w, direction ) > 0.0f ? 0.0f : 1.0f;
			assert_float_equal( sign, 1.0f, 0.0f );
			double same = fabs( testDot( n, testWide( hit.normal_w ) ) );
			assert_true( same > 1.0 - 1e-6 );
			assert_float_equal( soleLength( hit.normal_w ), 1.0f, 1e-6f );
		}
	}
	assert_true( compared > queryCount / 2 );
	soleDestroyGround( ground );
}

static void raysAgreeWithEveryTriangleInDouble( void** state )
{
	(void)state;
	for ( uint32_t seed = 1; seed <= 4; ++seed )
	{
		testMesh soup = testMakeSoup( seed, 300, 5.0f, 1.5f );
		compareWithSlowCast( seed * 77, &soup, seed % 2 == 0, 4000, 6.0f );
		testFreeMesh( &soup );
		testMesh terrain = testMakeTerrain( seed, 12, 0.5f, 1.0f );
		compareWithSlowCast( seed * 99, &terrain, false, 2000, 6.0f );
		testFreeMesh( &terrain );
	}
}

/// The axes given to x, y and z: 24 turns and the 24 mirrored ones. @return false for the mirrored.
static bool getOrientation( int number, int axes[3], float signs[3] )
{
	static const int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };
	memcpy( axes, orders[number / 8], 3 * sizeof( int ) );
	for ( int k = 0; k < 3; ++k )
	{
		signs[k] = ( number >> k & 1 ) != 0 ? -1.0f : 1.0f;
	}
	return ( number / 8 < 3 ) == ( signs[0] * signs[1] * signs[2] > 0.0f );
}

static soleVec3 orient( soleVec3 v, const int axes[3], const float signs[3] )
{
	float in[3] = { v.x, v.y, v.z };
	float out[3];
	for ( int k = 0; k < 3; ++k )
	{
		out[axes[k]] = signs[k] * in[k];
	}
	return soleVec( out[0], out[1], out[2] );
}

static void orientMesh( testMesh* mesh, const int axes[3], const float signs[3] )
{
	for ( int32_t v = 0; v < mesh->vertexCount; ++v )
	{
		float* p = mesh->vertices + 3 * v;
		soleVec3 turned = orient( soleVec( p[0], p[1], p[2] ), axes, signs );
		memcpy( p, &turned, sizeof turned );
	}
}

static void verticalRaysHitCornersAndEdgesInAll24Orientations( void** state )
{
	(void)state;
	int turns = 0;
	for ( int number = 0; number < 48; ++number )
	{
		int axes[3];
		float signs[3];
		if ( !getOrientation( number, axes, signs ) )
		{
			continue;
		}
		turns += 1;
		uint32_t seed = 3;
		testMesh mesh = testMakeTerrain( 5, 8, 0.3f, 0.5f );
		orientMesh( &mesh, axes, signs );
		soleGround* ground = testMakeMeshGround( &mesh, false );
		for ( int32_t i = 0; i < 1000; ++i )
		{
			// In steps of half a cell: corners, edges, diagonals; every other one anywhere.
			float x = 0.15f * (float)( testRandom( &seed ) % 17 );
			float z = 0.15f * (float)( testRandom( &seed ) % 17 );
			x = i % 4 == 0 ? testRandomFloat( &seed, 0.0f, 2.4f ) : x;
			z = i % 4 == 1 ? testRandomFloat( &seed, 0.0f, 2.4f ) : z;
			soleHit hit = testCast( ground, orient( soleVec( x, 2.0f, z ), axes, signs ),
			    orient( soleVec( 0.0f, -1.0f, 0.0f ), axes, signs ), 3.0f, 0.0f );
			assert_true( hit.hit );
			assert_true( soleDot( hit.normal_w, orient( soleVec( 0.0f, 1.0f, 0.0f ), axes, signs ) ) > 0.0f );
		}
		soleDestroyGround( ground );
		testFreeMesh( &mesh );
	}
	assert_int_equal( turns, 24 );
}

/// A ball of triangles that share their corners, closed.
static testMesh makeBall( int32_t rings, int32_t sectors, soleVec3 centre, float radius )
{
	testMesh mesh = testAllocMesh( 2 + ( rings - 1 ) * sectors, 2 * sectors * ( rings - 1 ) );
	for ( int32_t i = 0; i <= rings; ++i )
	{
		double a = 3.14159265358979 * i / rings;
		for ( int32_t j = 0; j < ( i == 0 || i == rings ? 1 : sectors ); ++j )
		{
			double b = 2.0 * 3.14159265358979 * j / sectors;
			int32_t number = i == 0 ? 0 : ( i == rings ? mesh.vertexCount - 1 : 1 + ( i - 1 ) * sectors + j );
			float* p = mesh.vertices + 3 * number;
			p[0] = centre.x + radius * (float)( sin( a ) * cos( b ) );
			p[1] = centre.y + radius * (float)cos( a );
			p[2] = centre.z + radius * (float)( sin( a ) * sin( b ) );
		}
	}
	uint32_t* t = mesh.indices;
	for ( int32_t i = 0; i < rings; ++i )
	{
		for ( int32_t j = 0; j < sectors; ++j )
		{
			int32_t next = ( j + 1 ) % sectors;
			uint32_t a = (uint32_t)( i == 0 ? 0 : 1 + ( i - 1 ) * sectors + j );
			uint32_t b = (uint32_t)( i == 0 ? 0 : 1 + ( i - 1 ) * sectors + next );
			uint32_t c = (uint32_t)( i + 1 == rings ? mesh.vertexCount - 1 : 1 + i * sectors + j );
			uint32_t d = (uint32_t)( i + 1 == rings ? mesh.vertexCount - 1 : 1 + i * sectors + next );
			if ( i > 0 )
			{
				uint32_t one[3] = { a, b, c };
				memcpy( t, one, sizeof one );
				t += 3;
			}
			if ( i + 1 < rings )
			{
				uint32_t two[3] = { b, d, c };
				memcpy( t, two, sizeof two );
				t += 3;
			}
		}
	}
	return mesh;
}

static void noRayGetsIntoAClosedSurface( void** state )
{
	(void)state;
	uint32_t seed = 11;
	for ( int32_t size = 0; size < 4; ++size )
	{
		float scale = size == 0 ? 0.01f : ( size == 1 ? 1.0f : ( size == 2 ? 10.0f : 300.0f ) );
		soleVec3 centre = soleScale( scale, soleVec( 0.3f, -1.7f, 2.1f ) );
		testMesh mesh = makeBall( 16, 24, centre, scale );
		soleGround* ground = testMakeMeshGround( &mesh, false );
		for ( int32_t i = 0; i < 12000; ++i )
		{
			// At a corner, a point of an edge, or anywhere in a triangle.
			int32_t triangle = (int32_t)( testRandom( &seed ) % (uint32_t)mesh.triangleCount );
			float a = i % 3 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 1.0f );
			float b = i % 3 == 2 ? testRandomFloat( &seed, 0.0f, 1.0f ) : 0.0f;
			soleVec3 target =
			    soleLerp( soleLerp( testCorner( &mesh, triangle, 0 ), testCorner( &mesh, triangle, 1 ), a ),
			        testCorner( &mesh, triangle, 2 ), b );
			soleVec3 inwards = soleSub( centre, target );
			soleVec3 direction =
			    soleNormalizeOr( soleMulAdd( inwards, 0.3f * scale, testRandomDirection( &seed ) ), down );
			soleVec3 start = soleMulAdd( target, -2.0f * scale, direction );
			assert_true( testCast( ground, start, direction, 5.0f * scale, 0.0f ).hit );
			// And from inside nothing is met: all faces look out.
			assert_false( testCast( ground, centre, direction, 5.0f * scale, 0.0f ).hit );
		}
		soleDestroyGround( ground );
		testFreeMesh( &mesh );
	}
}

static void noVerticalRayFallsThroughATerrain( void** state )
{
	(void)state;
	uint32_t seed = 17;
	for ( int32_t k = 0; k < 3; ++k )
	{
		float step = k == 0 ? 0.1f : ( k == 1 ? 0.333333f : 7.0f );
		testMesh mesh = testMakeTerrain( 23, 40, step, 2.0f * step );
		soleGround* ground = testMakeMeshGround( &mesh, false );
		for ( int32_t i = 0; i < 15000; ++i )
		{
			const float* p = mesh.vertices + 3 * ( testRandom( &seed ) % (uint32_t)mesh.vertexCount );
			const float* q = mesh.vertices + 3 * ( testRandom( &seed ) % (uint32_t)mesh.vertexCount );
			soleVec3 start = { i % 3 == 2 ? testRandomFloat( &seed, 0.0f, 40.0f * step ) : p[0], 10.0f * step,
				i % 3 == 1 ? testRandomFloat( &seed, 0.0f, 40.0f * step ) : q[2] };
			soleHit hit = testCast( ground, start, down, 20.0f * step, 0.0f );
			assert_true( hit.hit );
			assert_float_equal( hit.point_w.x, start.x, 0.0f );
			assert_float_equal( hit.point_w.z, start.z, 0.0f );
		}
		soleDestroyGround( ground );
		testFreeMesh( &mesh );
	}
}

static void heightsOnNeedlesAreExact( void** state )
{
	(void)state;
	uint32_t seed = 47;
	for ( int32_t i = 0; i < 5000; ++i )
	{
		float far = testRandomFloat( &seed, 5.0f, 40.0f );
		float width = testRandomFloat( &seed, 0.0005f, 0.01f );
		float vertices[9] = { 0.0f, 0.0f, 0.0f, far, 0.1f, far, far + width, 1.0f, far };
		uint32_t indices[3] = { 0, 1, 2 };
		testMesh mesh = { vertices, 3, indices, 1 };
		soleGround* ground = testMakeMeshGround( &mesh, false );
		float part = testRandomFloat( &seed, 0.1f, 0.9f );
		soleVec3 target = soleLerp( testCorner( &mesh, 0, 1 ), testCorner( &mesh, 0, 2 ), part );
		target = soleScale( testRandomFloat( &seed, 0.2f, 0.9f ), target );
		soleVec3 start = { target.x, 2.0f, target.z };
		double border;
		double t = slowRay( &mesh, 0, start, down, &border );
		if ( border > 0.02 )
		{
			soleHit hit = testCast( ground, start, down, 3.0f, 0.0f );
			assert_true( hit.hit );
			assert_float_equal( hit.point_w.y, (float)( 2.0 - t ), 1e-6f );
		}
		soleDestroyGround( ground );
	}
}

static void orderOfTrianglesChangesNothing( void** state )
{
	(void)state;
	uint32_t seed = 29;
	testMesh mesh = testMakeTerrain( 31, 14, 0.4f, 0.6f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	testMesh mixed = testAllocMesh( mesh.vertexCount, mesh.triangleCount );
	memcpy( mixed.vertices, mesh.vertices, (size_t)mesh.vertexCount * 3 * sizeof( float ) );
	memcpy( mixed.indices, mesh.indices, (size_t)mesh.triangleCount * 3 * sizeof( uint32_t ) );
	for ( int32_t i = mixed.triangleCount - 1; i > 0; --i )
	{
		int32_t other = (int32_t)( testRandom( &seed ) % (uint32_t)( i + 1 ) );
		uint32_t kept[3];
		memcpy( kept, mixed.indices + 3 * i, sizeof kept );
		memcpy( mixed.indices + 3 * i, mixed.indices + 3 * other, sizeof kept );
		memcpy( mixed.indices + 3 * other, kept, sizeof kept );
	}
	soleGround* other = testMakeMeshGround( &mixed, false );
	for ( int32_t i = 0; i < 20000; ++i )
	{
		soleVec3 start = { testRandomFloat( &seed, 0.0f, 5.6f ), 2.0f, testRandomFloat( &seed, 0.0f, 5.6f ) };
		soleVec3 direction = i % 2 == 0 ? down : testRandomDirection( &seed );
		float radius = i % 3 == 0 ? 0.1f : 0.0f;
		soleHit a = testCast( ground, start, direction, 4.0f, radius );
		soleHit b = testCast( other, start, direction, 4.0f, radius );
		assert_int_equal( a.hit, b.hit );
		assert_int_equal( a.startedInside, b.startedInside );
		assert_memory_equal( &a.point_w, &b.point_w, sizeof a.point_w );
		assert_memory_equal( &a.normal_w, &b.normal_w, sizeof a.normal_w );
	}
	soleDestroyGround( ground );
	soleDestroyGround( other );
	testFreeMesh( &mesh );
	testFreeMesh( &mixed );
}

static void tiesGoToTheLowerIndex( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 1, 1, 1.0f, 0.0f );
	soleGroundMesh meshes[3] = { testGroundMesh( &mesh ), testGroundMesh( &mesh ), testGroundMesh( &mesh ) };
	for ( int32_t i = 0; i < 3; ++i )
	{
		meshes[i].surface = 10 + i;
	}
	soleGround* ground = testMakeGround( meshes, 3 );
	assert_int_equal( testCast( ground, soleVec( 0.2f, 1.0f, 0.7f ), down, 2.0f, 0.0f ).surface, 10 );
	assert_int_equal( testCast( ground, soleVec( 0.2f, 1.0f, 0.7f ), down, 2.0f, 0.1f ).surface, 10 );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void rigidMotionCarriesAnswersAlong( void** state )
{
	(void)state;
	uint32_t seed = 37;
	testMesh mesh = testMakeTerrain( 41, 10, 0.5f, 0.4f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	for ( int32_t turn = 0; turn < 8; ++turn )
	{
		soleVec3 axis = testRandomDirection( &seed );
		soleQuat rotation =
		    soleNormalizeQuat( ( soleQuat ){ axis.x, axis.y, axis.z, testRandomFloat( &seed, -1.0f, 1.0f ) } );
		soleTransform motion = { testRandomPoint( &seed, 3.0f ), rotation, { 1.0f, 1.0f, 1.0f } };
		testMesh moved = testAllocMesh( mesh.vertexCount, mesh.triangleCount );
		memcpy( moved.indices, mesh.indices, (size_t)mesh.triangleCount * 3 * sizeof( uint32_t ) );
		for ( int32_t v = 0; v < mesh.vertexCount; ++v )
		{
			const float* p = mesh.vertices + 3 * v;
			soleVec3 q = soleTransformPoint( motion, soleVec( p[0], p[1], p[2] ) );
			memcpy( moved.vertices + 3 * v, &q, sizeof q );
		}
		soleGround* other = testMakeMeshGround( &moved, false );
		for ( int32_t i = 0; i < 2000; ++i )
		{
			soleVec3 start = { testRandomFloat( &seed, 0.1f, 4.9f ), 1.5f, testRandomFloat( &seed, 0.1f, 4.9f ) };
			float radius = i % 2 == 0 ? 0.0f : 0.08f;
			soleHit a = testCast( ground, start, down, 4.0f, radius );
			soleHit b =
			    testCast( other, soleTransformPoint( motion, start ), soleRotate( rotation, down ), 4.0f, radius );
			assert_true( a.hit && b.hit );
			testNear3( soleTransformPoint( motion, a.point_w ), b.point_w, 2e-5f );
		}
		soleDestroyGround( other );
		testFreeMesh( &moved );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

/// Points and polygons of an OBJ file, polygons as fans.
static testMesh readObj( const char* path )
{
	testMesh mesh = testAllocMesh( 4096, 8192 );
	mesh.vertexCount = 0;
	mesh.triangleCount = 0;
	FILE* file = fopen( path, "rb" );
	assert_non_null( file );
	char line[512];
	while ( fgets( line, sizeof line, file ) != NULL )
	{
		char* next = line + 1;
		if ( strncmp( line, "v ", 2 ) == 0 )
		{
			assert_true( mesh.vertexCount < 4096 );
			for ( int k = 0; k < 3; ++k )
			{
				mesh.vertices[3 * mesh.vertexCount + k] = strtof( next, &next );
			}
			mesh.vertexCount += 1;
		}
		uint32_t fan[3] = { 0, 0, 0 };
		for ( int count = 0; strncmp( line, "f ", 2 ) == 0; ++count )
		{
			char* end = next;
			long number = strtol( next, &end, 10 );
			if ( end == next )
			{
				break;
			}
			next = end + strcspn( end, " \t\r\n" );
			fan[count < 2 ? count : 2] = (uint32_t)( number - 1 );
			if ( count >= 2 )
			{
				assert_true( mesh.triangleCount < 8192 );
				memcpy( mesh.indices + 3 * mesh.triangleCount, fan, sizeof fan );
				mesh.triangleCount += 1;
				fan[1] = fan[2];
			}
		}
	}
	fclose( file );
	return mesh;
}

static void aRealLevelAnswersAsItsTriangles( void** state )
{
	(void)state;
	const char* name = "ground-recast/nav_test.obj";
	TEST_NEEDS_DATA( name );
	testMesh mesh = readObj( testData( name ) );
	assert_true( mesh.triangleCount > 792 );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	uint32_t seed = 43;
	int32_t met = 0;
	int32_t compared = 0;
	for ( int32_t i = 0; i < 4000; ++i )
	{
		soleVec3 start = { testRandomFloat( &seed, lower.x, upper.x ),
			testRandomFloat( &seed, lower.y, upper.y + 2.0f ), testRandomFloat( &seed, lower.z, upper.z ) };
		soleVec3 direction = i % 2 == 0 ? down : testRandomDirection( &seed );
		int32_t nearest;
		bool sure;
		double t = slowCast( &mesh, start, direction, 60.0, false, &nearest, &sure );
		soleHit hit = testCast( ground, start, direction, 60.0f, 0.0f );
		met += hit.hit ? 1 : 0;
		if ( sure )
		{
			compared += 1;
			assert_int_equal( hit.hit, nearest != SOLE_NONE );
			if ( hit.hit )
			{
				testNear3( hit.point_w, soleMulAdd( start, (float)t, direction ), 1e-4f );
			}
		}
	}
	assert_true( met > 1000 && compared > 1000 );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( raysAgreeWithEveryTriangleInDouble ),
		cmocka_unit_test( verticalRaysHitCornersAndEdgesInAll24Orientations ),
		cmocka_unit_test( noRayGetsIntoAClosedSurface ),
		cmocka_unit_test( noVerticalRayFallsThroughATerrain ),
		cmocka_unit_test( heightsOnNeedlesAreExact ),
		cmocka_unit_test( orderOfTrianglesChangesNothing ),
		cmocka_unit_test( tiesGoToTheLowerIndex ),
		cmocka_unit_test( rigidMotionCarriesAnswersAlong ),
		cmocka_unit_test( aRealLevelAnswersAsItsTriangles ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
