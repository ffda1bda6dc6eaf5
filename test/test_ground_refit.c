// SPDX-License-Identifier: MIT
// A ground that is fitted to where its vertices are now answers as a new one would.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

static void moveVertices( testMesh* mesh, uint32_t seed, float size )
{
	for ( int32_t i = 0; i < 3 * mesh->vertexCount; ++i )
	{
		mesh->vertices[i] += testRandomFloat( &seed, -size, size );
	}
}

static soleGroundDef makeDef( const soleGroundMesh* mesh )
{
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = mesh;
	def.meshCount = 1;
	return def;
}

static void compareGrounds( const soleGround* a, const soleGround* b, float size, uint32_t seed )
{
	int32_t met = 0;
	for ( int32_t i = 0; i < 4000; ++i )
	{
		soleVec3 start = { testRandomFloat( &seed, 0.0f, size ), testRandomFloat( &seed, 0.0f, 3.0f ),
			testRandomFloat( &seed, 0.0f, size ) };
		soleVec3 direction = i % 4 == 0 ? testRandomDirection( &seed ) : down;
		soleProbe probe = testProbe( start, direction, 4.0f, i % 3 == 0 ? 0.1f : 0.0f );
		soleHit one = soleCastProbe( a, &probe );
		soleHit other = soleCastProbe( b, &probe );
		assert_int_equal( one.hit, other.hit );
		assert_int_equal( one.layer, other.layer );
		assert_memory_equal( &one.point_w, &other.point_w, sizeof one.point_w );
		assert_memory_equal( &one.normal_w, &other.normal_w, sizeof one.normal_w );
		met += one.hit ? 1 : 0;
	}
	assert_true( met > 1000 );
	soleVec3 lowers[2];
	soleVec3 uppers[2];
	soleGround_GetBounds( a, &lowers[0], &uppers[0] );
	soleGround_GetBounds( b, &lowers[1], &uppers[1] );
	testNear3( lowers[0], lowers[1], 0.0f );
	testNear3( uppers[0], uppers[1], 0.0f );
}

static void movedVerticesAnswerAsANewGround( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 3, 30, 0.3f, 0.5f );
	soleGroundMesh groundMesh = testGroundMesh( &mesh );
	soleGroundDef def = makeDef( &groundMesh );
	soleGround* ground = testMakeGround( &groundMesh, 1 );
	// A little, then out of all order, then to another place altogether.
	static const float sizes[] = { 0.05f, 3.0f, 0.0f };
	for ( uint32_t round = 0; round < 3; ++round )
	{
		moveVertices( &mesh, 7 + round, sizes[round] );
		for ( int32_t i = 0; i < mesh.vertexCount && round == 2; ++i )
		{
			mesh.vertices[3 * i + 1] += 1.0f;
			mesh.vertices[3 * i] *= 0.9f;
		}
		assert_int_equal( soleRefitGround( ground, &def, NULL ), sole_success );
		soleGround* made = testMakeGround( &groundMesh, 1 );
		compareGrounds( ground, made, 9.0f, 11 + round );
		soleDestroyGround( made );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void heightsAndPlanesAreTakenOverToo( void** state )
{
	(void)state;
	float heights[9] = { 0 };
	soleHeightField field = soleDefaultHeightField();
	field.countX = 3;
	field.countZ = 3;
	field.heights = heights;
	soleGroundPlane plane = soleDefaultGroundPlane();
	plane.offset = -5.0f;
	soleGroundDef def = soleDefaultGroundDef();
	def.heightFields = &field;
	def.heightFieldCount = 1;
	def.planes = &plane;
	def.planeCount = 1;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	for ( int32_t i = 0; i < 9; ++i )
	{
		heights[i] = 1.5f;
	}
	plane.offset = -4.0f;
	assert_int_equal( soleRefitGround( ground, &def, NULL ), sole_success );
	assert_float_equal( testCast( ground, soleVec( 0.7f, 3.0f, 0.4f ), down, 9.0f, 0.0f ).point_w.y, 1.5f, 0.0f );
	assert_float_equal( testCast( ground, soleVec( 7.0f, 3.0f, 0.4f ), down, 9.0f, 0.0f ).point_w.y, -4.0f, 0.0f );
	soleDestroyGround( ground );
}

static void otherCountsAreRefusedAndChangeNothing( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 3, 4, 0.5f, 0.2f );
	soleGroundMesh groundMesh = testGroundMesh( &mesh );
	soleGroundDef def = makeDef( &groundMesh );
	soleGround* ground = testMakeGround( &groundMesh, 1 );
	soleGround* same = testMakeGround( &groundMesh, 1 );
	moveVertices( &mesh, 5, 0.2f );
	soleMessage message = { "" };
	groundMesh.triangleCount -= 1;
	assert_int_equal( soleRefitGround( ground, &def, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "counts" ) );
	groundMesh.triangleCount += 1;
	mesh.vertices[4] = NAN;
	assert_int_equal( soleRefitGround( ground, &def, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "finite" ) );
	soleSetAssertHandler( testQuietHandler );
	assert_int_equal( soleRefitGround( NULL, &def, NULL ), sole_invalidDefinition );
	soleSetAssertHandler( NULL );
	compareGrounds( ground, same, 2.0f, 3 );
	soleDestroyGround( ground );
	soleDestroyGround( same );
	testFreeMesh( &mesh );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( movedVerticesAnswerAsANewGround ),
		cmocka_unit_test( heightsAndPlanesAreTakenOverToo ),
		cmocka_unit_test( otherCountsAreRefusedAndChangeNothing ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
