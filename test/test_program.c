// SPDX-License-Identifier: MIT
// The program from outside: what it says of itself, and the commands that look at a file or at settings.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_program"
#include "program_run.h"

static int testSetUp( void** state )
{
	(void)state;
	testMakeFolders();
	testDo( "sample mannequin -o m.glb" );
	testDo( "bake m.glb --ground flat --method none --method sole --distance 4 -o o.glb" );
	return 0;
}

static void theProgramExplainsItself( void** state )
{
	(void)state;
	testRun run = testGood( "--version" );
	assert_true( strncmp( run.out, "sole ", 5 ) == 0 );
	testEnd( &run );
	testRun help = testGood( "--help" );
	int count = 0;
	for ( const char* line = help.out; *line != 0; line = strchr( line, '\n' ) + 1 )
	{
		// Commands are two spaces in.
		char name[32];
		char text[64];
		if ( strncmp( line, "  ", 2 ) != 0 || sscanf( line, "%31s", name ) != 1 )
		{
			continue;
		}
		snprintf( text, sizeof text, "%s --help", name );
		run = testGood( text );
		snprintf( text, sizeof text, "usage: sole %s", name );
		assert_true( strncmp( run.out, text, strlen( text ) ) == 0 );
		testEnd( &run );
		++count;
	}
	assert_true( count >= 6 );
	testEnd( &help );
}

static void inspectSaysWhatItPromises( void** state )
{
	(void)state;
	static const char* const paths[] = { "file", "scale", "up", "facing", "legs[].name", "legs[].side",
		"legs[].joints[]", "legs[].foot", "legs[].toe", "legs[].detached", "legs[].length", "legs[].hinge[]",
		"legs[].sole.heel[]", "legs[].sole.ball[]", "legs[].sole.toe[]", "legs[].sole.inner[]", "legs[].sole.outer[]",
		"legs[].why[]", "pelvis", "clips[].name", "clips[].duration", "clips[].fps", "clips[].motion",
		"clips[].strideSpeed", "clips[].contacts[].leg", "clips[].contacts[].intervals", "problems", NULL };
	struct json_object* object = testGoodJson( "inspect m.glb --json" );
	testHasAll( "inspect", object, paths );
	assert_string_equal( json_object_get_string( testGet( object, "file" ) ), "m.glb" );
	assert_int_equal( json_object_array_length( testGet( object, "legs" ) ), 2 );
	assert_int_equal( json_object_array_length( testGet( object, "clips" ) ), 8 );
	assert_int_equal( json_object_array_length( testGet( object, "problems" ) ), 0 );
	json_object_put( object );
	testRun run = testGood( "inspect mannequin" );
	assert_non_null( strstr( run.out, "leg left" ) );
	assert_non_null( strstr( run.out, "no problems" ) );
	testEnd( &run );
}

static void labelsAreListed( void** state )
{
	(void)state;
	static const char* const paths[] = { "name", "duration", "contacts[].leg", "contacts[].heel", "contacts[].toe",
		NULL };
	struct json_object* list = testGoodJson( "label m.glb --json" );
	assert_int_equal( json_object_array_length( list ), 8 );
	for ( size_t i = 0; i < json_object_array_length( list ); ++i )
	{
		testHasAll( "label", json_object_array_get_idx( list, i ), paths );
	}
	json_object_put( list );
	testDo( "label m.glb" );
	testDo( "label o.glb --clip walk|sole --json" );
}

static void settingsGoRound( void** state )
{
	(void)state;
	testDo( "settings" );
	testDo( "settings --markdown" );
	testRun run = testGood( "settings --json" );
	testWriteText( "settings.json", run.out );
	json_object_put( testParse( run.command, run.out ) );
	testRun again = testGood( "bake --settings settings.json --print-settings" );
	assert_string_equal( run.out, again.out );
	testEnd( &run );
	testEnd( &again );
	testDo( "bake m.glb --ground flat --settings settings.json -o settings.glb" );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theProgramExplainsItself ),
		cmocka_unit_test( inspectSaysWhatItPromises ),
		cmocka_unit_test( labelsAreListed ),
		cmocka_unit_test( settingsGoRound ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
