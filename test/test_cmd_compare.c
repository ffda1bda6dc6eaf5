// SPDX-License-Identifier: MIT
// `sole compare` from outside.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_cmd_compare"
#include "program_run.h"

static int testSetUp( void** state )
{
	(void)state;
	testMakeFolders();
	testWriteText( "slope.obj", "v -9 0 -9\nv -9 0 9\nv 9 0.3 9\nv 9 0.3 -9\nf 1 2 3 4\n" );
	return 0;
}

static void aComparisonHasWhatMeasureHas( void** state )
{
	(void)state;
	static const char* const paths[] = { "method", "scene", "ground", "reachShortfall", "referenceFigures.whole",
		"plants", "best", "behind", NULL };
	struct json_object* list = testGoodJson( "compare mannequin --ground T02 --ground flat --json" );
	size_t count = json_object_array_length( list );
	size_t methods = 0;
	while ( toolGetMethods()[methods].name != NULL )
	{
		++methods;
	}
	assert_int_equal( count, 2 * methods );
	for ( size_t i = 0; i < count; ++i )
	{
		struct json_object* item = json_object_array_get_idx( list, i );
		testHasFigures( "compare", item );
		testHasAll( "compare", item, paths );
		assert_string_equal( json_object_get_string( testGet( item, "scene" ) ), i < methods ? "T02" : "flat" );
		assert_string_equal( json_object_get_string( testGet( item, "method" ) ), toolGetMethods()[i % methods].name );
	}
	struct json_object* rows = testGoodJson( "measure mannequin --table --ground T02 --fps 60 --json" );
	assert_string_equal( json_object_to_json_string( testGet( json_object_array_get_idx( rows, 0 ), "whole" ) ),
	    json_object_to_json_string( testGet( json_object_array_get_idx( list, 0 ), "whole" ) ) );
	json_object_put( rows );
	json_object_put( list );
}

static void comparisonsAreWrittenAsTheyArePrinted( void** state )
{
	(void)state;
	static const char* const forms[] = { "", " --markdown", " --json" };
	for ( size_t i = 0; i < 3; ++i )
	{
		static const char compare[] = "compare mannequin --ground slope.obj --start 0,0 --fps 30";
		char command[160];
		snprintf( command, sizeof command, "%s%s", compare, forms[i] );
		testRun printed = testGood( command );
		snprintf( command, sizeof command, "%s%s -o written/compared.txt", compare, forms[i] );
		testRun written = testGood( command );
		char* text = testReadText( "written/compared.txt" );
		assert_string_equal( text, printed.out );
		assert_string_equal( written.out, "" );
		free( text );
		testEnd( &printed );
		testEnd( &written );
	}
	testRun all = testGood( "compare mannequin --all --method none --fps 30" );
	assert_non_null( strstr( all.out, "\nT11-20 " ) );
	assert_non_null( strstr( all.out, "\nLeft out: " ) );
	testEnd( &all );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aComparisonHasWhatMeasureHas ),
		cmocka_unit_test( comparisonsAreWrittenAsTheyArePrinted ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
