// SPDX-License-Identifier: MIT
// `sole measure` from outside: one clip, and tables of them, as `sole bake` says.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_cmd_measure"
#include "program_run.h"

static int testSetUp( void** state )
{
	(void)state;
	testMakeFolders();
	testDo( "sample mannequin -o m.glb" );
	return 0;
}

static double testPenetration( struct json_object* figures )
{
	return json_object_get_double( testGet( testGet( testGet( figures, "whole" ), "penetration" ), "p95" ) );
}

static double testPelvisOffset( struct json_object* figures )
{
	return json_object_get_double( testGet( testGet( figures, "whole" ), "pelvisOffsetMax" ) );
}

static void measureAgreesWithBake( void** state )
{
	(void)state;
	struct json_object* bake =
	    testGoodJson( "bake m.glb --ground course --method none --method sole --with-ground -o written/c.glb --json" );
	struct json_object* clips = testGet( bake, "clips" );
	assert_int_equal( json_object_array_length( clips ), 2 );
	for ( size_t i = 0; i < 2; ++i )
	{
		struct json_object* baked = json_object_array_get_idx( clips, i );
		testHasFigures( "bake", baked );
		testHas( "bake", baked, "method" );
		assert_string_equal( json_object_get_string( testGet( baked, "clip" ) ), i == 0 ? "walk|none" : "walk|sole" );
		struct json_object* measured = testGoodJson( i == 0
		        ? "measure written/c.glb --ground course --clip walk|none --json"
		        : "measure written/c.glb --ground course --clip walk|sole --reference walk|none --json" );
		testHasFigures( "measure", measured );
		testHas( "measure", measured, "reference" );
		assert_float_equal( testPenetration( measured ), testPenetration( baked ), 1e-4 );
		assert_float_equal( testPelvisOffset( measured ), testPelvisOffset( baked ), 1e-4 );
		for ( size_t leg = 0; leg < 2; ++leg )
		{
			struct json_object* a = json_object_array_get_idx( testGet( measured, "legs" ), leg );
			struct json_object* b = json_object_array_get_idx( testGet( baked, "legs" ), leg );
			assert_float_equal( json_object_get_double( testGet( testGet( a, "penetration" ), "p95" ) ),
			    json_object_get_double( testGet( testGet( b, "penetration" ), "p95" ) ), 1e-4 );
		}
		json_object_put( measured );
	}
	json_object_put( bake );
	static const char* const published[] = { "published.mann.step", "published.mann.speed", "published.mvae.step",
		"published.skatingRatio", "published.kimodo.ratio", "published.kimodo.fromHeight",
		"published.kimodo.fromContacts", "published.kimodo.maxSpeed", "published.physDiff.penetrate",
		"published.physDiff.float", "published.physDiff.skate", "published.physDiff.error",
		"published.footContactScore", "referencePublished.mann.step", NULL };
	struct json_object* measured =
	    testGoodJson( "measure written/c.glb --ground course --clip walk|sole --published --json" );
	testHasAll( "measure --published", measured, published );
	json_object_put( measured );
	testDo( "measure written/c.glb --ground course --clip walk|sole --published" );
	testDo( "measure written/c.glb --ground course --clip walk|sole --reference walk|none" );
	testDo( "measure m.glb --ground flat --clip walk" ); // never baked: along flat ground
}

static void aTableHasARowForEachGroundMethodAndRate( void** state )
{
	(void)state;
	struct json_object* rows =
	    testGoodJson( "measure mannequin --table --ground flat,T02 --fps 60,30 --method none,sole --json" );
	assert_int_equal( json_object_array_length( rows ), 8 );
	for ( size_t i = 0; i < 8; ++i )
	{
		struct json_object* row = json_object_array_get_idx( rows, i );
		assert_string_equal( json_object_get_string( testGet( row, "ground" ) ), i < 4 ? "flat" : "T02" );
		assert_string_equal( json_object_get_string( testGet( row, "method" ) ), i / 2 % 2 == 0 ? "none" : "sole" );
		assert_int_equal( json_object_get_int( testGet( row, "fps" ) ), i % 2 == 0 ? 60 : 30 );
		testHasFigures( "table", row );
		// The distance to 60 Hz is a figure of other rates alone.
		struct json_object* targets = testGet( row, "targets" );
		assert_int_equal( json_object_object_length( targets ), i % 2 == 0 ? 10 : 11 );
		assert_int_equal( json_object_object_get_ex( targets, "rateMax", NULL ), i % 2 == 1 );
	}
	// An untouched walk on stairs is under them, on the flat it is not.
	struct json_object* stairs = testGet( json_object_array_get_idx( rows, 4 ), "targets" );
	struct json_object* flat = testGet( json_object_array_get_idx( rows, 0 ), "targets" );
	assert_false( json_object_get_boolean( testGet( stairs, "penetrationMax" ) ) );
	assert_true( json_object_get_boolean( testGet( flat, "penetrationMax" ) ) );
	json_object_put( rows );
	testWriteText( "square.obj", "v -5 0 -5\nv -5 0 5\nv 5 0 5\nv 5 0 -5\nf 1 2 3 4\n" );
	testDo( "measure mannequin --table --ground square.obj --start 0,0 --heading 90 --distance 2 --fps 60 --clip run" );
}

/// What is baked by hand measures as in the table.
static void aTableAgreesWithBake( void** state )
{
	(void)state;
	struct json_object* rows = testGoodJson( "measure mannequin --table --ground T11-20 --fps 60 --json" );
	struct json_object* bake = testGoodJson( "bake mannequin --ground T11-20 -o written/t.glb --json" );
	struct json_object* row = json_object_array_get_idx( rows, 0 );
	struct json_object* baked = json_object_array_get_idx( testGet( bake, "clips" ), 0 );
	assert_string_equal( json_object_to_json_string( testGet( row, "whole" ) ),
	    json_object_to_json_string( testGet( baked, "whole" ) ) );
	json_object_put( bake );
	json_object_put( rows );
	testRun run = testGood( "measure mannequin --table --ground T11-20 --fps 60" );
	assert_non_null( strstr( run.out, "T11-20    60  sole" ) );
	assert_non_null( strstr( run.out, "targets hold" ) );
	testEnd( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( measureAgreesWithBake ),
		cmocka_unit_test( aTableHasARowForEachGroundMethodAndRate ),
		cmocka_unit_test( aTableAgreesWithBake ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
