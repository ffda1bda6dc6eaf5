// SPDX-License-Identifier: MIT
// `sole sample` from outside: every sample is written, and the list as JSON has the ways and the pieces of scenes,
// where their triangles are, and how they move.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_cmd_sample"
#include "program_run.h"

#include "scenario.h"

// The sample of that name in the list, or NULL.
static struct json_object* testFindSample( struct json_object* list, const char* name )
{
	struct json_object* found = NULL;
	for ( size_t i = 0; i < json_object_array_length( list ); ++i )
	{
		struct json_object* sample = json_object_array_get_idx( list, i );
		bool is = strcmp( json_object_get_string( json_object_object_get( sample, "name" ) ), name ) == 0;
		found = is ? sample : found;
	}
	return found;
}

static struct json_object* testFindPiece( struct json_object* list, const char* name, size_t piece )
{
	return json_object_array_get_idx( json_object_object_get( testFindSample( list, name ), "pieces" ), piece );
}

static double testNumber( struct json_object* object, const char* key, size_t index )
{
	return json_object_get_double( json_object_array_get_idx( json_object_object_get( object, key ), index ) );
}

static void piecesOfScenesAreListedAsTheyMove( void** state )
{
	(void)state;
	struct json_object* list = testGoodJson( "sample --list --json" );
	// What stands still has no keys and never begins anew.
	assert_null( json_object_object_get( testFindPiece( list, "stairs", 0 ), "keys" ) );
	assert_null( json_object_object_get( testFindSample( list, "stairs" ), "duration" ) );
	const char* ids[] = { "T27-both", "T28", "T29", "T30" };
	for ( size_t i = 0; i < 4; ++i )
	{
		soleScene scene;
		assert_true( soleMakeScene( ids[i], &scene ) );
		struct json_object* keys = json_object_object_get( testFindPiece( list, ids[i], 1 ), "keys" );
		struct json_object* first = json_object_object_get( testFindPiece( list, ids[i], 1 ), "firstTriangle" );
		assert_int_equal( json_object_get_int( first ), scene.pieces[1].firstTriangle );
		double rate = json_object_get_double( json_object_object_get( keys, "rate" ) );
		double duration =
		    json_object_get_double( json_object_object_get( testFindSample( list, ids[i] ), "duration" ) );
		for ( size_t key = 0; (double)key <= duration * rate; key += 7 )
		{
			soleTransform where;
			soleGetScenePiece( &scene, 1, (double)key / rate, &where );
			assert_float_equal( testNumber( keys, "places", 3 * key ), where.translation.x, 1e-5 );
			assert_float_equal( testNumber( keys, "places", 3 * key + 1 ), where.translation.y, 1e-5 );
			assert_float_equal( testNumber( keys, "places", 3 * key + 2 ), where.translation.z, 1e-5 );
			if ( json_object_object_get( keys, "turns" ) != NULL )
			{
				assert_float_equal( testNumber( keys, "turns", 4 * key ), where.rotation.x, 1e-5 );
				assert_float_equal( testNumber( keys, "turns", 4 * key + 1 ), where.rotation.y, 1e-5 );
			}
		}
		assert_int_equal( json_object_object_get( keys, "turns" ) != NULL, i == 1 || i == 3 );
		soleFreeScene( &scene );
	}
	// What comes later is not in the file, and what is for roots alone neither.
	struct json_object* comes = testFindPiece( list, "T23-15", 1 );
	assert_float_equal( json_object_get_double( json_object_object_get( comes, "from" ) ), 2.0, 1e-9 );
	assert_int_equal( json_object_array_length( json_object_object_get( comes, "indices" ) ), 36 );
	struct json_object* hidden = testFindPiece( list, "T20-low", 1 );
	assert_int_equal( json_object_get_int( json_object_object_get( hidden, "layer" ) ), sole_sceneRootOnly );
	assert_null( json_object_object_get( hidden, "firstTriangle" ) );
	json_object_put( list );
}

static void everySampleIsWritten( void** state )
{
	(void)state;
	testRun run = testGood( "sample --list" );
	int count = 0;
	for ( const char* line = run.out; *line != 0; line = strchr( line, '\n' ) + 1 )
	{
		char name[32];
		assert_int_equal( sscanf( line, "%31s", name ), 1 );
		char command[128];
		snprintf( command, sizeof command, "sample %s -o written/%s.glb", name, name );
		testDo( command );
		snprintf( command, sizeof command, "written/%s.glb", name );
		toolGltf* gltf = testOpenFile( testInFolder( command ) );
		assert_true( toolGltf_GetModel( gltf )->meshCount > 0 );
		toolFreeGltf( gltf );
		++count;
	}
	assert_true( count >= 7 );
	testEnd( &run );
}

static void samplesAreListedAsJsonWithTheirWays( void** state )
{
	(void)state;
	testRun run = testGood( "sample --list --json" );
	struct json_object* list = json_tokener_parse( run.out );
	assert_non_null( list );
	size_t count = json_object_array_length( list );
	testRun plain = testGood( "sample --list" );
	const char* line = plain.out;
	for ( size_t i = 0; i < count; ++i, line = strchr( line, '\n' ) + 1 )
	{
		struct json_object* sample = json_object_array_get_idx( list, i );
		const char* name = json_object_get_string( json_object_object_get( sample, "name" ) );
		const char* text = json_object_get_string( json_object_object_get( sample, "text" ) );
		assert_int_equal( strncmp( line, name, strlen( name ) ), 0 );
		assert_non_null( strstr( line, text ) );
		if ( strcmp( name, "stairs" ) == 0 )
		{
			struct json_object* path = json_object_object_get( sample, "path" );
			assert_int_equal( json_object_array_length( path ), 2 );
			struct json_object* last = json_object_array_get_idx( path, 1 );
			assert_float_equal( (float)json_object_get_double( json_object_array_get_idx( last, 1 ) ), 8.46f, 1e-5f );
		}
	}
	assert_int_equal( *line, '\0' );
	json_object_put( list );
	testEnd( &plain );
	testEnd( &run );
}

static int testSetUp( void** state )
{
	(void)state;
	testMakeFolders();
	return 0;
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everySampleIsWritten ),
		cmocka_unit_test( samplesAreListedAsJsonWithTheirWays ),
		cmocka_unit_test( piecesOfScenesAreListedAsTheyMove ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
