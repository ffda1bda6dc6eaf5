// SPDX-License-Identifier: MIT
// Grounds from files: where their triangles end up.
#define _POSIX_C_SOURCE 200809L
#include "glb_maker.h"

#include "ground_file.h"

#define TEMP( name ) testTempPath( "test_ground_file", name )

static toolGroundMesh testReadObj( const char* text )
{
	toolGroundMesh ground;
	toolError error = { { 0 } };
	if ( toolReadObjBytes( (const uint8_t*)text, strlen( text ), "g.obj", &ground, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return ground;
}

static void testSameTriangles( const toolGroundMesh* ground, int32_t count, const uint32_t* indices )
{
	assert_int_equal( ground->triangleCount, count );
	assert_memory_equal( ground->indices, indices, (size_t)count * 12 );
}

static void objFacesMayNameTheirCornersInAnyWay( void** state )
{
	(void)state;
	const char* faces[] = { "f 1 2 3", "f 1/4 2/5 3/6", "f 1//7 2//8 3//9", "f 1/1/1 2/2/2 3/3/3", "f -3 -2 -1",
		"f -3/1/1 2 -1//4", "f\t1  2\t3  # three" };
	const uint32_t wanted[3] = { 0, 1, 2 };
	for ( size_t i = 0; i < sizeof faces / sizeof faces[0]; ++i )
	{
		char text[256];
		snprintf( text, sizeof text, "# a ground\nvt 0 0\nvn 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\n%s\n", faces[i] );
		toolGroundMesh ground = testReadObj( text );
		testSameTriangles( &ground, 1, wanted );
		toolFreeGroundMesh( &ground );
	}
}

static void objPolygonsBecomeFans( void** state )
{
	(void)state;
	toolGroundMesh ground = testReadObj( "v 0 0 0\nv 1 0 0\nv 1 0 1\nv .5 0 2\nv 0 0 1\nf 1 2 3 4 5" );
	const uint32_t wanted[9] = { 0, 1, 2, 0, 2, 3, 0, 3, 4 };
	testSameTriangles( &ground, 3, wanted );
	assert_float_equal( ground.positions[9], 0.5f, 0 );
	toolFreeGroundMesh( &ground );
}

static void objLinesMayGoOnAndEndInAnyWay( void** state )
{
	(void)state;
	toolGroundMesh ground =
	    testReadObj( "v 0 0 0 1.0\r\nv 1 0 0 0.5 0.5 0.5\r\n  v -1e0 +0 \\\r\n1\r\nf 1 \\\n 2 \\\r\n 3\r\n" );
	const uint32_t wanted[3] = { 0, 1, 2 };
	testSameTriangles( &ground, 1, wanted );
	assert_float_equal( ground.positions[6], -1.0f, 0 );
	assert_float_equal( ground.positions[8], 1.0f, 0 );
	toolFreeGroundMesh( &ground );
}

static void realObjFilesHaveTheirTriangles( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "ground-recast/nav_test.obj" );
	toolGroundMesh ground;
	toolError error;
	assert_true( toolReadGround( testData( "ground-recast/nav_test.obj" ), 2.0f, &ground, &error ) );
	assert_int_equal( ground.vertexCount, 884 );
	assert_int_equal( ground.triangleCount, 1612 );
	toolFreeGroundMesh( &ground );
}

/// Reads the leg's mesh as a ground, with its nodes replaced.
static toolGroundMesh testReadNodes( const char* nodes, const char* scene, float scale )
{
	testParts leg = testMakeLeg();
	char* begin = strstr( leg.json, "\"nodes\":[{" );
	char* end = strstr( leg.json, "\"meshes\"" );
	char rest[sizeof leg.json];
	snprintf( rest, sizeof rest, "%s", end );
	snprintf( begin, sizeof leg.json - (size_t)( begin - leg.json ), "\"nodes\":[%s],%s", nodes, rest );
	char* clips = strstr( leg.json, "\"animations\"" );
	snprintf( rest, sizeof rest, "%s", strstr( leg.json, "\"accessors\"" ) );
	snprintf( clips, sizeof leg.json - (size_t)( clips - leg.json ), "%s", rest );
	testReplace( &leg, "\"nodes\":[0,2]", scene );
	testReplace( &leg, "\"skins\":[{\"joints\":[0,1],", "\"skins\":[{\"joints\":[0]," );
	const uint8_t joints[16] = { 0 };
	memcpy( leg.bin + test_atJoints, joints, sizeof joints );
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	testWriteBytes( TEMP( "ground.glb" ), bytes, count );
	free( bytes );
	toolGroundMesh ground;
	toolError error = { { 0 } };
	if ( toolReadGround( TEMP( "ground.glb" ), scale, &ground, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return ground;
}

static soleVec3 testVertex( const toolGroundMesh* ground, int32_t vertex )
{
	const float* p = ground->positions + 3 * vertex;
	return soleVec( p[0], p[1], p[2] );
}

static void nodesPutTrianglesInTheWorld( void** state )
{
	(void)state;
	// the child stands before its parent, which turns it a quarter about y and stretches it along the new x
	toolGroundMesh ground = testReadNodes( "{\"mesh\":0,\"rotation\":[0,0.70710678,0,0.70710678]},"
	                                       "{\"children\":[0],\"scale\":[3,1,2],\"translation\":[10,20,30]}",
	    "\"nodes\":[1]", 0.5f );
	assert_int_equal( ground.triangleCount, 2 );
	// (1, 2, 0) turns to (0, 2, -1), stretched (0, 2, -2), moved (10, 22, 28), halved
	testNear3( testVertex( &ground, 2 ), soleVec( 5, 11, 14 ), 1e-5f );
	toolFreeGroundMesh( &ground );
}

static void stretchOfATurnedChildIsAShear( void** state )
{
	(void)state;
	// an eighth of a turn about z below a stretch along x: no translation, rotation and scale says that
	toolGroundMesh ground = testReadNodes( "{\"children\":[1],\"scale\":[2,1,1]},"
	                                       "{\"mesh\":0,\"rotation\":[0,0,0.382683432,0.923879533]}",
	    "\"nodes\":[0]", 1.0f );
	float s = 0.70710678f;
	testNear3( testVertex( &ground, 1 ), soleVec( 2 * s, s, 0 ), 1e-6f );
	testNear3( testVertex( &ground, 2 ), soleVec( -2 * s, 3 * s, 0 ), 1e-6f );
	toolFreeGroundMesh( &ground );
}

static void matrixNodesKeepTheirShear( void** state )
{
	(void)state;
	toolGroundMesh ground =
	    testReadNodes( "{\"mesh\":0,\"matrix\":[1,0,0,0,0.5,1,0,0,0,0,1,0,0,0,0,1]}", "\"nodes\":[0]", 1.0f );
	testNear3( testVertex( &ground, 2 ), soleVec( 2, 2, 0 ), 0 );
	toolFreeGroundMesh( &ground );
}

static void mirroredNodesKeepTheirFronts( void** state )
{
	(void)state;
	toolGroundMesh ground = testReadNodes( "{\"mesh\":0,\"scale\":[-1,1,1]}", "\"nodes\":[0]", 1.0f );
	const uint32_t wanted[6] = { 0, 2, 1, 0, 3, 2 };
	testSameTriangles( &ground, 2, wanted );
	toolFreeGroundMesh( &ground );
}

static void skinnedMeshesStayInTheirBindPose( void** state )
{
	(void)state;
	toolGroundMesh ground = testReadNodes( "{\"mesh\":0,\"skin\":0,\"translation\":[5,5,5]}", "\"nodes\":[0]", 1.0f );
	testNear3( testVertex( &ground, 2 ), soleVec( 1, 2, 0 ), 0 );
	toolFreeGroundMesh( &ground );
}

static void onlyTheShownSceneCounts( void** state )
{
	(void)state;
	toolGroundMesh ground =
	    testReadNodes( "{\"mesh\":0},{\"mesh\":0},{\"mesh\":0,\"translation\":[0,0,9]}", "\"nodes\":[0,2]", 1.0f );
	assert_int_equal( ground.triangleCount, 4 );
	assert_int_equal( ground.vertexCount, 8 );
	testNear3( testVertex( &ground, 4 ), soleVec( 0, 0, 9 ), 0 );
	assert_int_equal( ground.indices[6], 4 );
	toolFreeGroundMesh( &ground );
}

static void realGroundsHaveTheirTriangles( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "ground-kaykit-prototype/Primitive_Stairs.gltf" );
	toolGroundMesh ground;
	toolError error;
	assert_true( toolReadGround( testData( "ground-kaykit-prototype/Primitive_Stairs.gltf" ), 1.0f, &ground, &error ) );
	assert_int_equal( ground.triangleCount, 68 );
	toolFreeGroundMesh( &ground );
	assert_false( toolReadGround( testData( "ground-ecctrl-testmap/testMap.glb" ), 1.0f, &ground, &error ) );
	assert_non_null( strstr( error.text, "KHR_draco_mesh_compression" ) );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( objFacesMayNameTheirCornersInAnyWay ),
		cmocka_unit_test( objPolygonsBecomeFans ),
		cmocka_unit_test( objLinesMayGoOnAndEndInAnyWay ),
		cmocka_unit_test( realObjFilesHaveTheirTriangles ),
		cmocka_unit_test( nodesPutTrianglesInTheWorld ),
		cmocka_unit_test( stretchOfATurnedChildIsAShear ),
		cmocka_unit_test( matrixNodesKeepTheirShear ),
		cmocka_unit_test( mirroredNodesKeepTheirFronts ),
		cmocka_unit_test( skinnedMeshesStayInTheirBindPose ),
		cmocka_unit_test( onlyTheShownSceneCounts ),
		cmocka_unit_test( realGroundsHaveTheirTriangles ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
