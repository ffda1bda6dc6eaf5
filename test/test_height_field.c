// SPDX-License-Identifier: MIT
// Height fields answer as the same triangles in a mesh do.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

#define COUNT_X 13
#define COUNT_Z 9

static soleVec3 fieldPoint( const soleHeightField* f, float x, float y, float z )
{
	return soleMulAdd( soleMulAdd( soleMulAdd( f->origin, x, f->axisX ), y, f->up ), z, f->axisZ );
}

static soleVec3 fieldDirection( const soleHeightField* f, soleVec3 d )
{
	return soleAdd( soleAdd( soleScale( d.x, f->axisX ), soleScale( d.y, f->up ) ), soleScale( d.z, f->axisZ ) );
}

static soleGround* makeField( const soleHeightField* f )
{
	soleGroundDef def = soleDefaultGroundDef();
	def.heightFields = f;
	def.heightFieldCount = 1;
	soleGround* ground = NULL;
	soleMessage message = { "" };
	if ( soleCreateGround( &def, NULL, &ground, &message ) != sole_success )
	{
		fail_msg( "%s", message.text );
	}
	return ground;
}

/// The same surface as triangles, holes left out.
static soleGround* makeSameMesh( const soleHeightField* f )
{
	testMesh mesh = testAllocMesh( f->countX * f->countZ, 2 * ( f->countX - 1 ) * ( f->countZ - 1 ) );
	mesh.triangleCount = 0;
	for ( int32_t i = 0; i < f->countX * f->countZ; ++i )
	{
		float height = f->heights[i] == f->heights[i] ? f->heights[i] : 0.0f;
		soleVec3 p = fieldPoint( f, f->cellX * (float)( i % f->countX ), height, f->cellZ * (float)( i / f->countX ) );
		memcpy( mesh.vertices + 3 * i, &p, sizeof p );
	}
	bool mirrored = soleDot( soleCross( f->axisX, f->up ), f->axisZ ) < 0.0f;
	for ( int32_t i = 0; i < ( f->countX - 1 ) * ( f->countZ - 1 ); ++i )
	{
		uint32_t a = (uint32_t)( i / ( f->countX - 1 ) * f->countX + i % ( f->countX - 1 ) );
		uint32_t b = a + (uint32_t)f->countX;
		uint32_t pair[2][3] = { { a, b + 1, a + 1 }, { a, b, b + 1 } };
		for ( int k = 0; k < 2; ++k )
		{
			const uint32_t* t = pair[k];
			float sum = f->heights[t[0]] + f->heights[t[1]] + f->heights[t[2]];
			if ( sum == sum )
			{
				uint32_t turned[3] = { t[0], t[mirrored ? 2 : 1], t[mirrored ? 1 : 2] };
				memcpy( mesh.indices + 3 * mesh.triangleCount, turned, sizeof turned );
				mesh.triangleCount += 1;
			}
		}
	}
	soleGround* ground = testMakeMeshGround( &mesh, false );
	testFreeMesh( &mesh );
	return ground;
}

static soleHeightField makeDef( uint32_t seed, float* heights, bool holes )
{
	soleHeightField f = soleDefaultHeightField();
	f.origin = testRandomPoint( &seed, 3.0f );
	f.cellX = 0.5f;
	f.cellZ = 0.375f;
	f.countX = COUNT_X;
	f.countZ = COUNT_Z;
	f.heights = heights;
	for ( int32_t i = 0; i < COUNT_X * COUNT_Z; ++i )
	{
		heights[i] = testRandomFloat( &seed, 0.0f, 0.8f );
		heights[i] = holes && i % 7 == 3 ? NAN : heights[i];
	}
	return f;
}

static void turnDef( soleHeightField* f, uint32_t* seed )
{
	soleVec3 axis = testRandomDirection( seed );
	soleQuat q = soleNormalizeQuat( ( soleQuat ){ axis.x, axis.y, axis.z, testRandomFloat( seed, -1.0f, 1.0f ) } );
	f->axisX = soleRotate( q, f->axisX );
	f->axisZ = soleRotate( q, f->axisZ );
	f->up = soleRotate( q, f->up );
	if ( testRandom( seed ) % 2 == 0 )
	{
		f->axisX = soleNeg( f->axisX );
	}
}

static void compareProbes( const soleHeightField* f, uint32_t seed, bool spheres, int32_t count )
{
	soleGround* field = makeField( f );
	soleGround* mesh = makeSameMesh( f );
	int32_t different = 0;
	int32_t met = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		soleVec3 local = { testRandomFloat( &seed, -1.0f, 7.0f ), testRandomFloat( &seed, 0.9f, 3.0f ),
			testRandomFloat( &seed, -1.0f, 4.0f ) };
		soleVec3 d = i % 4 == 0 ? down : testRandomDirection( &seed );
		d = i % 4 == 1 ? soleNormalizeOr( soleMulAdd( soleScale( 3.0f, down ), 1.0f, d ), down ) : d;
		soleVec3 start = fieldPoint( f, local.x, local.y, local.z );
		soleVec3 direction = fieldDirection( f, d );
		float radius = spheres ? testRandomFloat( &seed, 0.01f, 0.9f ) : 0.0f;
		float length = testRandomFloat( &seed, 0.2f, 12.0f );
		soleHit a = testCast( field, start, direction, length, radius );
		soleHit b = testCast( mesh, start, direction, length, radius );
		met += a.hit ? 1 : 0;
		bool same = a.hit == b.hit && a.startedInside == b.startedInside;
		same = same && soleDistance( a.point_w, b.point_w ) < 1e-4f;
		different += same ? 0 : 1;
	}
	// Rounding decides at rims and where a slanted probe just passes.
	assert_true( met > count / 10 && different <= count / 500 );
	soleDestroyGround( field );
	soleDestroyGround( mesh );
}

static void compareFields( uint32_t turnSeed, uint32_t probeSeed, bool spheres, int32_t probesEach )
{
	for ( uint32_t seed = 1; seed <= 12; ++seed )
	{
		float heights[COUNT_X * COUNT_Z];
		uint32_t turn = seed * turnSeed;
		soleHeightField f = makeDef( seed, heights, seed % 3 == 0 );
		if ( seed > 2 )
		{
			turnDef( &f, &turn );
		}
		compareProbes( &f, seed * probeSeed, spheres, probesEach );
	}
}

static void raysAnswerAsOnTheSameMesh( void** state )
{
	(void)state;
	compareFields( 7, 13, false, 3000 );
}

static void spheresAnswerAsOnTheSameMesh( void** state )
{
	(void)state;
	compareFields( 5, 17, true, 1500 );
}

static void verticalRaysHitBordersOfCells( void** state )
{
	(void)state;
	float heights[COUNT_X * COUNT_Z];
	soleHeightField f = makeDef( 3, heights, false );
	f.origin = soleVec( 0.0f, 0.0f, 0.0f );
	soleGround* ground = makeField( &f );
	for ( int32_t j = 0; j <= 4 * ( COUNT_Z - 1 ); ++j )
	{
		for ( int32_t i = 0; i <= 4 * ( COUNT_X - 1 ); ++i )
		{
			soleVec3 start = { 0.125f * (float)i, 2.0f, 0.09375f * (float)j };
			soleHit hit = testCast( ground, start, down, 3.0f, 0.0f );
			assert_true( hit.hit );
			if ( i % 4 == 0 && j % 4 == 0 )
			{
				assert_float_equal( hit.point_w.y, heights[j / 4 * COUNT_X + i / 4], 1e-6f );
			}
		}
	}
	assert_false( testCast( ground, soleVec( -0.01f, 2.0f, 1.0f ), down, 3.0f, 0.0f ).hit );
	assert_false( testCast( ground, soleVec( 6.01f, 2.0f, 1.0f ), down, 3.0f, 0.0f ).hit );
	assert_false( testCast( ground, soleVec( 1.0f, 2.0f, 3.01f ), down, 3.0f, 0.0f ).hit );
	assert_false( testCast( ground, soleVec( 1.0f, -1.0f, 1.0f ), soleNeg( down ), 3.0f, 0.0f ).hit );
	soleDestroyGround( ground );
}

static void noSlantedRayPassesThroughTheGround( void** state )
{
	(void)state;
	float heights[COUNT_X * COUNT_Z];
	uint32_t seed = 9;
	soleHeightField f = makeDef( 4, heights, false );
	turnDef( &f, &seed );
	soleGround* ground = makeField( &f );
	for ( int32_t i = 0; i < 20000; ++i )
	{
		// From above to below, through points of the grid and others.
		float x = i % 2 == 0 ? f.cellX * (float)( 1 + i % 11 ) : testRandomFloat( &seed, 0.5f, 5.5f );
		float z = i % 3 == 0 ? f.cellZ * (float)( 1 + i % 7 ) : testRandomFloat( &seed, 0.5f, 2.5f );
		soleVec3 middle = fieldPoint( &f, x, 0.4f, z );
		soleVec3 slanted = { testRandomFloat( &seed, -0.4f, 0.4f ), -1.0f, testRandomFloat( &seed, -0.4f, 0.4f ) };
		soleVec3 direction = fieldDirection( &f, soleNormalizeOr( slanted, down ) );
		soleHit hit = testCast( ground, soleMulAdd( middle, -0.6f, direction ), direction, 1.2f, 0.0f );
		assert_true( hit.hit );
	}
	soleDestroyGround( ground );
}

static void holesMiss( void** state )
{
	(void)state;
	float heights[9] = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, NAN };
	soleHeightField f = soleDefaultHeightField();
	f.countX = f.countZ = 3;
	f.heights = heights;
	f.surface = 4;
	f.layer = 2;
	soleGround* ground = makeField( &f );
	assert_false( testCast( ground, soleVec( 1.3f, 1.0f, 1.6f ), down, 2.0f, 0.0f ).hit );
	soleHit hit = testCast( ground, soleVec( 0.3f, 1.0f, 1.6f ), down, 2.0f, 0.0f );
	assert_true( hit.hit );
	assert_int_equal( hit.surface, 4 );
	assert_int_equal( hit.layer, 2 );
	assert_true(
	    testCast( ground, soleVec( 1.0f, 1.0f, 1.5f ), down, 2.0f, 0.0f ).hit ); // the border is the solid cell's
	soleProbe probe = testProbe( soleVec( 0.3f, 1.0f, 1.6f ), down, 2.0f, 0.0f );
	probe.mask = 1;
	assert_false( soleCastProbe( ground, &probe ).hit );
	soleDestroyGround( ground );
	for ( int32_t i = 0; i < 9; ++i )
	{
		heights[i] = NAN;
	}
	ground = makeField( &f );
	assert_false( testCast( ground, soleVec( 0.3f, 1.0f, 1.6f ), down, 2.0f, 0.1f ).hit );
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	assert_true( lower.x > upper.x );
	soleDestroyGround( ground );
}

static void theNearestOfAllKindsIsMet( void** state )
{
	(void)state;
	float heights[4] = { 0.2f, 0.2f, 0.2f, 0.2f };
	soleHeightField f = soleDefaultHeightField();
	f.countX = f.countZ = 2;
	f.heights = heights;
	f.surface = 1;
	testMesh terrain = testMakeTerrain( 1, 1, 0.5f, 0.0f );
	for ( int32_t v = 0; v < 4; ++v )
	{
		terrain.vertices[3 * v + 1] = 0.4f;
	}
	soleGroundMesh mesh = testGroundMesh( &terrain );
	mesh.surface = 2;
	soleGroundPlane plane = soleDefaultGroundPlane();
	plane.surface = 3;
	soleGroundDef def = soleDefaultGroundDef();
	def.heightFields = &f;
	def.heightFieldCount = 1;
	def.meshes = &mesh;
	def.meshCount = 1;
	def.planes = &plane;
	def.planeCount = 1;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	for ( int radius = 0; radius < 2; ++radius )
	{
		float r = 0.05f * (float)radius;
		assert_int_equal( testCast( ground, soleVec( 0.2f, 1.0f, 0.3f ), down, 3.0f, r ).surface, 2 );
		assert_int_equal( testCast( ground, soleVec( 0.8f, 1.0f, 0.3f ), down, 3.0f, r ).surface, 1 );
		assert_int_equal( testCast( ground, soleVec( 1.8f, 1.0f, 0.3f ), down, 3.0f, r ).surface, 3 );
	}
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	testNear3( lower, soleVec( 0.0f, 0.2f, 0.0f ), 1e-6f );
	testNear3( upper, soleVec( 1.0f, 0.4f, 1.0f ), 1e-6f );
	assert_int_equal( soleGround_GetTriangleCount( ground ), 4 );
	soleDestroyGround( ground );
	testFreeMesh( &terrain );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( raysAnswerAsOnTheSameMesh ),
		cmocka_unit_test( spheresAnswerAsOnTheSameMesh ),
		cmocka_unit_test( verticalRaysHitBordersOfCells ),
		cmocka_unit_test( noSlantedRayPassesThroughTheGround ),
		cmocka_unit_test( holesMiss ),
		cmocka_unit_test( theNearestOfAllKindsIsMet ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
