// SPDX-License-Identifier: MIT
// Runs the program as a user would, in a folder of the test's own: TEST_NAME, defined before this is included together
// with _POSIX_C_SOURCE. Commands are written as in a shell, '@NAME' is a file of the real data.
#ifndef TEST_PROGRAM_RUN_H
#define TEST_PROGRAM_RUN_H

#include "glb_maker.h"

#include "bake.h"

#include <dirent.h>
#include <json-c/json.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#define FOLDER SOLE_BINARY_DIR "/" TEST_NAME "_files"
#define TIME_LIMIT 120 // s: a program that hangs ends; slow builds on a busy machine take a while
#define MOST_WORDS 64

// What a run of the program left.
typedef struct testRun
{
	char command[512];
	int status;
	char* out;
	char* err;
} testRun;

static inline const char* testInFolder( const char* name )
{
	return testTempPath( TEST_NAME, name );
}

static inline char* testReadText( const char* name )
{
	size_t count = 0;
	return (char*)testReadBytes( testInFolder( name ), &count );
}

static inline void testWriteText( const char* name, const char* text )
{
	testWriteBytes( testInFolder( name ), text, strlen( text ) );
}

static inline void testWriteModel( const toolModel* model, const char* name )
{
	toolGltf* gltf = toolMakeGltf( model );
	assert_non_null( gltf );
	toolError error = { { 0 } };
	if ( toolWriteGltf( gltf, testInFolder( name ), &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	toolFreeGltf( gltf );
}

static inline bool testIsThere( const char* name )
{
	struct stat info;
	return stat( testInFolder( name ), &info ) == 0;
}

// -------------------------------------------------------------------------------------------------------- running

// The child: never comes back.
static inline void testBecome( char** words )
{
	bool good = chdir( FOLDER ) == 0 && freopen( "out.txt", "wb", stdout ) != NULL &&
	    freopen( "err.txt", "wb", stderr ) != NULL && freopen( "/dev/null", "rb", stdin ) != NULL;
	if ( good )
	{
		alarm( TIME_LIMIT ); // stays over exec
		execv( SOLE_PROGRAM, words );
	}
	_exit( 127 );
}

static inline testRun testSole( const char* command )
{
	testRun run = { .status = -1 };
	snprintf( run.command, sizeof run.command, "sole %s", command );
	char* copy = toolCopyString( run.command );
	char* words[MOST_WORDS] = { NULL };
	char* made[MOST_WORDS] = { NULL };
	int count = 0;
	for ( char* word = strtok( copy, " " ); word != NULL && count < MOST_WORDS - 1; word = strtok( NULL, " " ) )
	{
		made[count] = *word == '@' ? toolFormat( "%s/%s", SOLE_DATA_DIR, word + 1 ) : NULL;
		words[count] = made[count] != NULL ? made[count] : word;
		words[count] = strcmp( word, "''" ) == 0 ? word + 2 : words[count];
		++count;
	}
	fflush( NULL );
	pid_t child = fork();
	assert_true( child >= 0 );
	if ( child == 0 )
	{
		testBecome( words );
	}
	int status = 0;
	assert_int_equal( waitpid( child, &status, 0 ), child );
	for ( int i = 0; i < count; ++i )
	{
		free( made[i] );
	}
	free( copy );
	run.out = testReadText( "out.txt" );
	run.err = testReadText( "err.txt" );
	if ( WIFEXITED( status ) == 0 )
	{
		fail_msg( "%s: ended by signal %d%s\n%s", run.command, WTERMSIG( status ),
		    WTERMSIG( status ) == SIGALRM ? ", it took too long" : "", run.err );
	}
	run.status = WEXITSTATUS( status );
	return run;
}

static inline void testEnd( testRun* run )
{
	free( run->out );
	free( run->err );
	run->out = run->err = NULL;
}

// Runs what must succeed without a word on stderr.
static inline testRun testGood( const char* command )
{
	testRun run = testSole( command );
	if ( run.status != 0 || run.err[0] != 0 )
	{
		fail_msg( "%s: status %d: %s", run.command, run.status, run.err );
	}
	return run;
}

static inline void testDo( const char* command )
{
	testRun run = testGood( command );
	testEnd( &run );
}

static inline struct json_object* testParse( const char* what, const char* text )
{
	enum json_tokener_error error;
	struct json_object* object = json_tokener_parse_verbose( text, &error );
	if ( object == NULL )
	{
		fail_msg( "%s: no JSON: %s", what, json_tokener_error_desc( error ) );
	}
	return object;
}

// Runs what must succeed and print JSON.
static inline struct json_object* testGoodJson( const char* command )
{
	testRun run = testGood( command );
	struct json_object* object = testParse( run.command, run.out );
	testEnd( &run );
	return object;
}

// ------------------------------------------------------------------------------------------------------------ JSON

// Checks that a path such as "legs[].sole.heel" is there, in every item of a list, which must not be empty.
static inline void testHas( const char* what, struct json_object* object, const char* path )
{
	char key[64];
	size_t length = strcspn( path, ".[" );
	snprintf( key, sizeof key, "%.*s", (int)length, path );
	struct json_object* value = NULL;
	if ( json_object_object_get_ex( object, key, &value ) == 0 )
	{
		fail_msg( "%s: has no '%s'", what, path );
	}
	const char* rest = path + length;
	bool list = strncmp( rest, "[]", 2 ) == 0;
	rest += list ? 2 : 0;
	rest += *rest == '.' ? 1 : 0;
	if ( list && ( json_object_is_type( value, json_type_array ) == false || json_object_array_length( value ) == 0 ) )
	{
		fail_msg( "%s: '%s' is no list with something in it", what, path );
	}
	for ( size_t i = 0; list && *rest != 0 && i < json_object_array_length( value ); ++i )
	{
		testHas( what, json_object_array_get_idx( value, i ), rest );
	}
	if ( list == false && *rest != 0 )
	{
		testHas( what, value, rest );
	}
}

static inline void testHasAll( const char* what, struct json_object* object, const char* const* paths )
{
	for ( ; *paths != NULL; ++paths )
	{
		testHas( what, object, *paths );
	}
}

static inline struct json_object* testGet( struct json_object* object, const char* key )
{
	struct json_object* value = NULL;
	if ( json_object_object_get_ex( object, key, &value ) == 0 )
	{
		fail_msg( "there is no '%s'", key );
	}
	return value;
}

// The figures that every measurement has.
static inline void testHasFigures( const char* what, struct json_object* object )
{
	static const char* const paths[] = { "legs[].name", "legs[].penetration.mean", "legs[].penetration.p95",
		"legs[].penetration.max", "legs[].hover.mean", "legs[].hover.p95", "legs[].hover.max", "legs[].contactShare",
		"legs[].slide", "legs[].drift", "legs[].overExtended", "whole.kneeAccelerationRms", "whole.pelvisJerk",
		"whole.largestJump", "ratios", "clip", "fps", NULL };
	testHasAll( what, object, paths );
}

// ------------------------------------------------------------------------------------------------------- messages

// Nothing may be left of a run that failed.
static inline void testNothingLeft( const testRun* run )
{
	DIR* folder = opendir( FOLDER );
	assert_non_null( folder );
	bool left = false;
	for ( const struct dirent* entry = readdir( folder ); entry != NULL; entry = readdir( folder ) )
	{
		left = left || strncmp( entry->d_name, "bad.", 4 ) == 0 || strstr( entry->d_name, ".tmp" ) != NULL;
	}
	closedir( folder );
	if ( left )
	{
		fail_msg( "%s: left a file", run->command );
	}
}

// One line: "sole: FILE: what is wrong: what to do", or "sole COMMAND: what is wrong: see ...".
static inline void testIsOneLine( const testRun* run, const char* file )
{
	const char* text = run->err;
	const char* first = strstr( text, ": " );
	const char* end = strchr( text, '\n' );
	bool good = first != NULL && strstr( first + 2, ": " ) != NULL && end != NULL && end[1] == 0;
	good = good && ( strncmp( text, "sole: ", 6 ) == 0 || ( run->status == 2 && strncmp( text, "sole ", 5 ) == 0 ) );
	good = good && ( file == NULL || strstr( text, file ) != NULL );
	for ( const char* c = text; good && c < end; ++c )
	{
		good = (unsigned char)*c >= 0x20 && *c != 0x7f;
	}
	if ( good == false )
	{
		fail_msg( "%s: status %d, says: %s", run->command, run->status, text );
	}
}

static inline void testIsRefused( const char* command, int status, const char* file, const char* says )
{
	testRun run = testSole( command );
	if ( run.status != status )
	{
		fail_msg( "%s: status %d where it should be %d: %s", run.command, run.status, status, run.err );
	}
	testIsOneLine( &run, file );
	if ( says != NULL && strstr( run.err, says ) == NULL )
	{
		fail_msg( "%s: does not say '%s': %s", run.command, says, run.err );
	}
	testNothingLeft( &run );
	testEnd( &run );
}

// Takes all files out of a folder, where there is one.
static inline void testEmptyFolder( const char* path )
{
	DIR* folder = opendir( path );
	if ( folder == NULL )
	{
		return;
	}
	for ( const struct dirent* entry = readdir( folder ); entry != NULL; entry = readdir( folder ) )
	{
		char* file = toolFormat( "%s/%s", path, entry->d_name );
		struct stat info;
		if ( stat( file, &info ) == 0 && S_ISREG( info.st_mode ) )
		{
			remove( file );
		}
		free( file );
	}
	closedir( folder );
}

// Makes the test's own folder, with a folder for what is written in it, and empties both.
static inline void testMakeFolders( void )
{
	mkdir( FOLDER, 0777 );
	mkdir( FOLDER "/written", 0777 );
	testEmptyFolder( FOLDER );
	testEmptyFolder( FOLDER "/written" );
}

#endif
