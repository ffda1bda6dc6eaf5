// SPDX-License-Identifier: MIT
// `sole bake --trace` and `sole replay` from outside.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_program_trace"
#include "program_run.h"

#include "mannequin.h"
#include "sole/trace.h"

static int testSetUp( void** state )
{
	(void)state;
	mkdir( FOLDER, 0777 );
	testEmptyFolder( FOLDER );
	testDo( "bake mannequin --ground stairs --distance 2 --method none --method sole -o m.glb --trace m.trace" );
	return 0;
}

static void aBakeIsReplayedToTheBit( void** state )
{
	(void)state;
	testRun run = testGood( "replay m.trace" );
	assert_non_null( strstr( run.out, "m.trace: " ) );
	assert_non_null( strstr( run.out, " of 2 legs" ) );
	assert_non_null( strstr( run.out, "the same to the bit" ) );
	testEnd( &run );
	struct json_object* verdict = testGoodJson( "replay m.trace --json" );
	struct json_object* bake = testGoodJson( "bake mannequin --ground stairs --distance 2 -o m2.glb --json" );
	struct json_object* clip = json_object_array_get_idx( json_object_object_get( bake, "clips" ), 0 );
	assert_string_equal( json_object_get_string( json_object_object_get( verdict, "file" ) ), "m.trace" );
	assert_int_equal( json_object_get_int( json_object_object_get( verdict, "legs" ) ), 2 );
	assert_int_equal( json_object_get_int( json_object_object_get( verdict, "frames" ) ),
	    json_object_get_int( json_object_object_get( clip, "frames" ) ) );
	assert_int_equal( json_object_get_int( json_object_object_get( verdict, "differentFrames" ) ), 0 );
	assert_null( json_object_object_get( verdict, "first" ) );
	json_object_put( bake );
	json_object_put( verdict );
}

// A trace of the mannequin's rig in which the third frame says something that never came out.
static void testWriteLyingTrace( const char* name )
{
	size_t byteCount = 0;
	uint8_t* bytes = testReadBytes( testInFolder( "m.trace" ), &byteCount );
	soleTracePlayer* player;
	assert_int_equal( soleOpenTrace( bytes, byteCount, NULL, &player, NULL ), sole_success );
	toolModel model;
	toolCharacter character;
	toolError error;
	toolMakeMannequin( &model );
	assert_true( toolMakeCharacter( &model, "mannequin", 1.0f, &character, &error ) );
	soleTraceBuffer buffer = { malloc( byteCount + 10000 ), byteCount + 10000, 0 };
	soleTraceSink sink = soleMakeBufferSink( &buffer );
	soleTracer* tracer;
	assert_int_equal( soleCreateTracer( &character.rigDef, &sink, NULL, &tracer, NULL ), sole_success );
	soleState state = soleDefaultState( character.rig );
	const soleTraceStep* step;
	for ( soleTracePlayer_Next( player, &step, NULL ); step != NULL; soleTracePlayer_Next( player, &step, NULL ) )
	{
		soleOutput out = *step->output;
		out.legs[1].error += step->index == 2 ? 0.5f : 0.0f;
		soleTracer_BeginFrame( tracer, step->settings, &state, step->frame, step->hits, step->hitCount );
		soleOutput own;
		soleSolve( character.rig, step->settings, &state, step->frame, step->hits, step->hitCount, &own );
		soleTracer_EndFrame( tracer, &state, &out );
	}
	assert_true( soleTracer_Finish( tracer ) );
	testWriteBytes( testInFolder( name ), buffer.bytes, buffer.byteCount );
	soleDestroyTracer( tracer );
	soleCloseTrace( player );
	toolFreeCharacter( &character );
	toolFreeModel( &model );
	free( buffer.bytes );
	free( bytes );
}

static void aDifferenceIsToldAndEndsWithOne( void** state )
{
	(void)state;
	testWriteLyingTrace( "lie.trace" );
	testIsRefused( "replay lie.trace", 1, "lie.trace", "frame 2, leg right, error[0]: was 0.5" );
	testRun run = testSole( "replay lie.trace --json" );
	assert_int_equal( run.status, 1 );
	struct json_object* verdict = testParse( run.command, run.out );
	struct json_object* first = json_object_object_get( verdict, "first" );
	assert_int_equal( json_object_get_int( json_object_object_get( verdict, "differentFrames" ) ), 1 );
	assert_int_equal( json_object_get_int( json_object_object_get( first, "frame" ) ), 2 );
	assert_string_equal( json_object_get_string( json_object_object_get( first, "leg" ) ), "right" );
	assert_string_equal( json_object_get_string( json_object_object_get( first, "field" ) ), "error" );
	assert_float_equal( json_object_get_double( json_object_object_get( first, "recorded" ) ), 0.5, 0.1 );
	json_object_put( verdict );
	testEnd( &run );
}

static void whatIsNoTraceIsRefused( void** state )
{
	(void)state;
	testIsRefused( "replay m.glb", 1, "m.glb", "is none" );
	testIsRefused( "replay gone.trace", 1, "gone.trace", "cannot be read" );
	size_t byteCount = 0;
	uint8_t* bytes = testReadBytes( testInFolder( "m.trace" ), &byteCount );
	testWriteBytes( testInFolder( "cut.trace" ), bytes, byteCount / 2 );
	testIsRefused( "replay cut.trace", 1, "cut.trace", "cut off after frame" );
	bytes[byteCount / 2] ^= 4;
	testWriteBytes( testInFolder( "changed.trace" ), bytes, byteCount );
	testIsRefused( "replay changed.trace", 1, "changed.trace", "was changed after frame" );
	free( bytes );
}

static void wrongUsageIsTold( void** state )
{
	(void)state;
	testIsRefused( "replay", 2, NULL, "give one trace" );
	testIsRefused( "replay a b", 2, NULL, "give one trace" );
	testIsRefused( "replay --fast m.trace", 2, NULL, "no such option" );
	testIsRefused( "bake mannequin --ground flat -o bad.glb --method none --trace bad.trace", 2, NULL, "method sole" );
	testIsRefused(
	    "bake mannequin --ground flat -o bad.glb --clip walk --clip run --trace bad.trace", 2, NULL, "one clip" );
	testIsRefused( "bake mannequin --ground flat -o bad.glb --trace gone/bad.trace", 1, "gone/bad.trace", "written" );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aBakeIsReplayedToTheBit ),
		cmocka_unit_test( aDifferenceIsToldAndEndsWithOne ),
		cmocka_unit_test( whatIsNoTraceIsRefused ),
		cmocka_unit_test( wrongUsageIsTold ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
