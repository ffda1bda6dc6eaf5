// SPDX-License-Identifier: MIT
// The page of comparisons: what its script makes of two grounds, and that it leaves nothing where it fails.
#include "test.h"

#include "bake.h"

#include <sys/stat.h>
#include <sys/wait.h>

#define SCRIPT SOLE_SOURCE_DIR "/scripts/make_comparison.sh"
#define PAGE SOLE_BINARY_DIR "/test_comparison.md"

/// @return exit status. Without real characters: the page is then the same everywhere.
static int runScript( const char* arguments )
{
	char* command = toolFormat( "SOLE_DATA=" SOLE_BINARY_DIR "/gone " SCRIPT " %s 2> /dev/null", arguments );
	int status = system( command );
	free( command );
	assert_true( WIFEXITED( status ) );
	return WEXITSTATUS( status );
}

static char* readPage( void )
{
	uint8_t* bytes = NULL;
	size_t count = 0;
	toolError error = { { 0 } };
	if ( toolReadFile( PAGE, &bytes, &count, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return (char*)bytes;
}

static int32_t countOf( const char* text, const char* part )
{
	int32_t count = 0;
	for ( const char* at = strstr( text, part ); at != NULL; at = strstr( at + 1, part ) )
	{
		++count;
	}
	return count;
}

static bool isThere( const char* path )
{
	struct stat info;
	return stat( path, &info ) == 0;
}

static void thePageHasWhatItPromises( void** state )
{
	(void)state;
	remove( PAGE );
	assert_int_equal( runScript( SOLE_PROGRAM " " PAGE " T11-20 flat" ), 0 );
	char* page = readPage();
	assert_true( strncmp( page, "<!-- Made by scripts/make_comparison.sh ", 40 ) == 0 );
	static const char* const parts[] = { "\n# Methods side by side\n", "\n## In short\n",
		"\n- **mannequin**: Grounds: 2. sole plants on ", "\n## Where Sole is not the best\n", "\n## The grounds\n",
		"\n| T11-20 | Ramp of 20 degrees, 8 long |\n", "\n## Mannequin\n", "\n### walk over T11-20\n",
		"\n### walk over flat\n", "\nGrounds: 2. sole plants on " };
	const char* last = page;
	for ( size_t i = 0; i < sizeof parts / sizeof parts[0]; ++i )
	{
		const char* at = strstr( page, parts[i] );
		if ( at == NULL || at < last )
		{
			fail_msg( "'%s' is missing, or not where it should be", parts[i] );
		}
		last = at;
	}
	// Every method is explained once and has a row on each ground.
	for ( const toolMethod* method = toolGetMethods(); method->name != NULL; ++method )
	{
		char* row = toolFormat( "\n| %s | ", method->name );
		assert_int_equal( countOf( page, row ), 3 );
		free( row );
	}
	// The sum stands at the top and under the tables, and is no ground that is lost.
	assert_int_equal( countOf( page, "Grounds: 2. " ), 2 );
	assert_int_equal( countOf( page, SOLE_SOURCE_DIR ), 0 );
	free( page );
}

static void aTableIsNowhereTorn( void** state )
{
	(void)state;
	assert_int_equal( runScript( SOLE_PROGRAM " " PAGE " flat" ), 0 );
	char* page = readPage();
	int32_t above = 0;
	int32_t rows = 0;
	for ( const char* line = page; *line != 0; line = strchr( line, '\n' ) + 1 )
	{
		int32_t bars = 0;
		for ( const char* c = line; *c != '\n'; ++c )
		{
			assert_int_not_equal( *c, 0 );
			bars += *c == '|';
		}
		assert_true( bars == 0 || above == 0 || bars == above );
		above = bars;
		rows += bars > 3;
	}
	int32_t methods = 0;
	while ( toolGetMethods()[methods].name != NULL )
	{
		++methods;
	}
	assert_int_equal( rows, 2 + methods );
	free( page );
}

static void whatFailsLeavesThePageAsItWas( void** state )
{
	(void)state;
	assert_int_equal( runScript( SOLE_PROGRAM " " PAGE " flat" ), 0 );
	char* before = readPage();
	assert_int_not_equal( runScript( SOLE_PROGRAM " " PAGE " flat nowhere" ), 0 );
	assert_int_not_equal( runScript( "/bin/false " PAGE " flat" ), 0 );
	char* after = readPage();
	assert_string_equal( before, after );
	assert_false( isThere( PAGE ".tmp" ) );
	free( before );
	free( after );
	assert_int_equal( runScript( SOLE_PROGRAM ), 2 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( thePageHasWhatItPromises ),
		cmocka_unit_test( aTableIsNowhereTorn ),
		cmocka_unit_test( whatFailsLeavesThePageAsItWas ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
