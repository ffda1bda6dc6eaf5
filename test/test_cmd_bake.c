// SPDX-License-Identifier: MIT
// `sole bake` from outside: what was in the file stays, every kind of file and of way.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_cmd_bake"
#include "program_run.h"

#include "mannequin.h"

// The mannequin without its clips.
static void testWriteWithoutClips( void )
{
	toolModel model;
	toolMakeMannequin( &model );
	int32_t clipCount = model.clipCount;
	model.clipCount = 0;
	testWriteModel( &model, "no_clips.glb" );
	model.clipCount = clipCount;
	toolFreeModel( &model );
}

static int testSetUp( void** state )
{
	(void)state;
	testMakeFolders();
	testDo( "sample mannequin -o m.glb" );
	testDo( "sample flat -o flat.glb" );
	testWriteWithoutClips();
	return 0;
}

// Every item of a list of the input is the same item of the output's list.
static void testStartsWith( const char* key, struct json_object* whole, struct json_object* start )
{
	assert_true( json_object_array_length( whole ) >= json_object_array_length( start ) );
	for ( size_t i = 0; i < json_object_array_length( start ); ++i )
	{
		struct json_object* a = json_object_array_get_idx( start, i );
		struct json_object* b = json_object_array_get_idx( whole, i );
		bool counted = strcmp( key, "buffers" ) == 0;
		if ( strcmp( key, "scenes" ) == 0 )
		{
			testStartsWith( "nodes", testGet( b, "nodes" ), testGet( a, "nodes" ) );
		}
		else if ( counted == false && json_object_equal( a, b ) == 0 )
		{
			fail_msg( "%s[%d] was changed", key, (int)i );
		}
	}
}

static struct json_object* testGlbJson( const uint8_t* bytes )
{
	char* text = toolFormat( "%.*s", (int)testU32( bytes + 12 ), (const char*)bytes + 20 );
	struct json_object* object = testParse( "a .glb", text );
	free( text );
	return object;
}

static void bakeKeepsTheFile( void** state )
{
	(void)state;
	testDo( "bake m.glb --ground stairs --method none --method sole --with-ground -o written/s.glb" );
	size_t inCount = 0;
	size_t outCount = 0;
	uint8_t* in = testReadBytes( testInFolder( "m.glb" ), &inCount );
	uint8_t* out = testReadBytes( testInFolder( "written/s.glb" ), &outCount );
	struct json_object* before = testGlbJson( in );
	struct json_object* after = testGlbJson( out );
	json_object_object_foreach( before, key, value )
	{
		struct json_object* now = testGet( after, key );
		if ( json_object_is_type( value, json_type_array ) )
		{
			testStartsWith( key, now, value );
		}
		else
		{
			assert_true( json_object_equal( now, value ) );
		}
	}
	json_object_put( before );
	json_object_put( after );
	// The data is a beginning of the new data.
	size_t inBin = 20 + testU32( in + 12 );
	size_t outBin = 20 + testU32( out + 12 );
	assert_true( testU32( out + outBin ) > testU32( in + inBin ) );
	assert_memory_equal( in + inBin + 8, out + outBin + 8, testU32( in + inBin ) );
	free( in );
	free( out );
	toolGltf* gltf = testOpenFile( testInFolder( "written/s.glb" ) );
	const toolModel* model = toolGltf_GetModel( gltf );
	assert_int_equal( model->clipCount, 10 );
	assert_string_equal( model->clips[8].name, "walk|none" );
	assert_string_equal( model->clips[9].name, "walk|sole" );
	assert_true( toolFindNode( model, "ground" ) != SOLE_NONE );
	toolFreeGltf( gltf );
}

static void bakeWritesGltf( void** state )
{
	(void)state;
	testDo( "bake m.glb --ground ramp --clip run --clip idle --fps 30 --scale auto -o written/g.gltf" );
	assert_true( testIsThere( "written/g.gltf" ) && testIsThere( "written/g.bin" ) );
	testDo( "measure written/g.gltf --ground ramp --clip run|sole" );
	testDo( "label written/g.gltf --clip idle|sole" );
	struct json_object* object = testGoodJson( "inspect written/g.gltf --json" );
	assert_int_equal( json_object_array_length( testGet( object, "clips" ) ), 10 );
	json_object_put( object );
	testDo( "bake m.glb --ground flat.glb --path 0,-3;0,0;3,0 --speed 1 --plots written -o written/p.glb" );
	assert_true( testIsThere( "written/sole_left.svg" ) );
	testDo( "bake m.glb --ground flat --start 1,5,-2 --heading 90 --distance 2 -o written/q.glb" );
}

static void clipsOfASecondFileAreBaked( void** state )
{
	(void)state;
	testDo( "bake no_clips.glb --clips m.glb --clip walk --ground flat -o with_clips.glb" );
	// Without any clip a character stands at rest.
	testDo( "bake no_clips.glb --ground ramp -o standing.glb" );
	testDo( "measure standing.glb --ground ramp --clip rest|sole" );
	// It finds the file with the clip that it was made from beside itself.
	testDo( "measure with_clips.glb --ground flat --clip walk|sole" );
	testDo( "measure with_clips.glb --ground flat --clip walk|sole --clips m.glb" );
	TEST_NEEDS_DATA( "human-kaykit-mannequin/manny_med_mod.gltf" );
	testDo( "bake @human-kaykit-mannequin/manny_med_mod.gltf --clips "
	        "@human-kaykit-mannequin/Med_MovementBasic.glb --ground course --distance 4 -o kaykit.glb" );
	toolGltf* gltf = testOpenFile( testInFolder( "kaykit.glb" ) );
	assert_int_equal( toolGltf_GetModel( gltf )->clipCount, 1 );
	assert_non_null( strstr( toolGltf_GetModel( gltf )->clips[0].name, "|sole" ) );
	char command[256];
	snprintf( command, sizeof command, "measure kaykit.glb --ground course --clip %s",
	    toolGltf_GetModel( gltf )->clips[0].name );
	toolFreeGltf( gltf );
	testDo( command );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( bakeKeepsTheFile ),
		cmocka_unit_test( bakeWritesGltf ),
		cmocka_unit_test( clipsOfASecondFileAreBaked ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
