// SPDX-License-Identifier: MIT
// sole report from outside: the page has what was baked and measured and nothing that runs, hostile names do no harm,
// and bad input leaves nothing.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_report"
#include "program_run.h"

#include "mannequin.h"
#include "motion.h"

#include <math.h>

#define MARK "<!--sole-report-data-->"
#define HEAD "<html>\xc3\xa9<p>before</p>"
#define TAIL "<p>behind \\u003c &lt;</p></html>\n"
#define REPORT " --template t.html -o "
static const char hostileClip[] = "</script><script>alert(1)</script><!--&lt;\"'\\";

static int testSetUp( void** state )
{
	(void)state;
	mkdir( FOLDER, 0777 );
	testEmptyFolder( FOLDER );
	testWriteText( "t.html", HEAD MARK TAIL );
	testWriteText( "none.html", HEAD TAIL );
	testWriteText( "two.html", HEAD MARK MARK TAIL );
	testWriteText( "text.glb", "This is no model." );
	testWriteText( "s.json", "{ \"contact\": { \"lockDistance\": 0.125 } }" );
	testDo( "sample mannequin -o m.glb" );
	return 0;
}

// ------------------------------------------------------------------------------------------------------------ pages

// A page that was made, in its parts.
typedef struct testPage
{
	char* text;
	struct json_object* data;
	uint8_t* character;
	size_t characterCount;
	uint8_t* ground;
	size_t groundCount;
} testPage;

static char* testCutScript( const char* page, const char* type, const char* id )
{
	char* open = toolFormat( "<script type=\"%s\" id=\"%s\">", type, id );
	const char* begin = strstr( page, open );
	assert_non_null( begin );
	begin += strlen( open );
	const char* end = strstr( begin, "</script>" );
	assert_non_null( end );
	free( open );
	return toolFormat( "%.*s", (int)( end - begin ), begin );
}

static uint8_t* testDecode( const char* text, size_t* count )
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	size_t length = strlen( text );
	assert_int_equal( length % 4, 0 );
	uint8_t* bytes = toolAlloc( length, 1 );
	uint32_t bits = 0;
	*count = 0;
	for ( size_t i = 0; i < length && text[i] != '='; ++i )
	{
		const char* digit = strchr( digits, text[i] );
		assert_non_null( digit );
		bits = bits << 6 | (uint32_t)( digit - digits );
		if ( i % 4 != 0 )
		{
			bytes[( *count )++] = (uint8_t)( bits >> ( 6 - 2 * ( i % 4 ) ) );
		}
	}
	return bytes;
}

static testPage testReadPage( const char* name )
{
	testPage page = { .text = testReadText( name ) };
	char* json = testCutScript( page.text, "application/json", "report" );
	char* character = testCutScript( page.text, "text/plain", "character" );
	char* ground = testCutScript( page.text, "text/plain", "ground" );
	page.data = testParse( name, json );
	page.character = testDecode( character, &page.characterCount );
	page.ground = testDecode( ground, &page.groundCount );
	free( json );
	free( character );
	free( ground );
	return page;
}

static void testFreePage( testPage* page )
{
	free( page->text );
	free( page->character );
	free( page->ground );
	json_object_put( page->data );
}

// By keys and places with dots between: "walks.0.takes.1.method".
static struct json_object* testAt( struct json_object* object, const char* path )
{
	char* copy = toolCopyString( path );
	for ( char* key = strtok( copy, "." ); key != NULL; key = strtok( NULL, "." ) )
	{
		bool list = json_object_is_type( object, json_type_array );
		object =
		    list ? json_object_array_get_idx( object, (size_t)atoi( key ) ) : json_object_object_get( object, key );
	}
	free( copy );
	return object;
}

static const char* testTextAt( struct json_object* object, const char* path )
{
	const char* text = json_object_get_string( testAt( object, path ) );
	return text != NULL ? text : "nothing";
}

static double testNumberAt( struct json_object* list, size_t index )
{
	struct json_object* number = json_object_array_get_idx( list, index );
	return number != NULL ? json_object_get_double( number ) : (double)NAN;
}

static void testSameNumbers( const char* where, struct json_object* a, struct json_object* b, double tolerance )
{
	if ( json_object_is_type( a, json_type_object ) )
	{
		json_object_object_foreach( a, key, value )
		{
			testSameNumbers( key, value, json_object_object_get( b, key ), tolerance );
		}
		return;
	}
	bool number = json_object_is_type( a, json_type_double ) || json_object_is_type( a, json_type_int );
	double x = json_object_get_double( a );
	double y = json_object_get_double( b );
	bool same = number ? fabs( x - y ) <= tolerance * fmax( fabs( x ), 1e-2 ) : json_object_equal( a, b ) != 0;
	if ( same == false )
	{
		fail_msg( "%s: %s and %s", where, json_object_to_json_string( a ), json_object_to_json_string( b ) );
	}
}

static void testSameFigures( struct json_object* a, struct json_object* b, double tolerance )
{
	testSameNumbers( "whole", testAt( a, "whole" ), testAt( b, "whole" ), tolerance );
	testSameNumbers( "left", testAt( a, "legs.0" ), testAt( b, "legs.0" ), tolerance );
	testSameNumbers( "right", testAt( a, "legs.1" ), testAt( b, "legs.1" ), tolerance );
}

// ------------------------------------------------------------------------------------------------------------ tests

static void thePageIsTheTemplateWithData( void** state )
{
	(void)state;
	testDo( "report m.glb --ground T02" REPORT "r.html" );
	testPage page = testReadPage( "r.html" );
	assert_int_equal( strncmp( page.text, HEAD "<script", strlen( HEAD "<script" ) ), 0 );
	size_t length = strlen( page.text );
	assert_string_equal( page.text + length - strlen( TAIL ), TAIL );
	assert_null( strstr( page.text, MARK ) );
	assert_string_equal( testTextAt( page.data, "character" ), "m.glb" );
	assert_string_equal( testTextAt( page.data, "ground" ), "T02" );
	assert_string_equal( testTextAt( page.data, "legs.0.joints.2" ), "foot_l" );
	assert_int_equal( json_object_array_length( testAt( page.data, "settings" ) ), 0 );
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	assert_true( toolReadGlbBytes( page.character, page.characterCount, "character", &gltf, &error ) );
	assert_true( toolFindClip( toolGltf_GetModel( gltf ), testTextAt( page.data, "walks.0.takes.0.clip" ) ) >= 0 );
	assert_true( toolFindClip( toolGltf_GetModel( gltf ), "walk|sole" ) >= 0 );
	toolFreeGltf( gltf );
	assert_true( toolReadGlbBytes( page.ground, page.groundCount, "ground", &gltf, &error ) );
	assert_true( toolGltf_GetModel( gltf )->meshCount > 0 );
	toolFreeGltf( gltf );
	testFreePage( &page );
}

// As the bake computes them to the bit; a file keeps floats, of which differences feel the last digits.
static void figuresAreThoseOfBakeAndMeasure( void** state )
{
	(void)state;
	testDo( "report m.glb --ground T11-20" REPORT "f.html" );
	testPage page = testReadPage( "f.html" );
	struct json_object* bake = testGoodJson( "bake m.glb --ground T11-20 --method none --method sole --json -o f.glb" );
	for ( int i = 0; i < 2; ++i )
	{
		const char* paths[2][3] = { { "walks.0.takes.0.figures", "clips.0",
			                            "measure f.glb --ground T11-20 --clip walk|none --json" },
			{ "walks.0.takes.1.figures", "clips.1", "measure f.glb --ground T11-20 --clip walk|sole --json" } };
		struct json_object* ours = testAt( page.data, paths[i][0] );
		struct json_object* measured = testGoodJson( paths[i][2] );
		testSameFigures( ours, testAt( bake, paths[i][1] ), 0.0 );
		testSameFigures( ours, measured, 0.05 );
		json_object_put( measured );
	}
	json_object_put( bake );
	testFreePage( &page );
}

static void targetsAreThoseOfTheTable( void** state )
{
	(void)state;
	testDo( "report m.glb --ground course" REPORT "g.html" );
	testPage page = testReadPage( "g.html" );
	struct json_object* table =
	    testGoodJson( "measure m.glb --table --ground course --fps 60 --method none,sole --json" );
	int count = 0;
	struct json_object* rows = testAt( page.data, "walks.0.rows" );
	for ( size_t i = 0; i < json_object_array_length( rows ); ++i )
	{
		struct json_object* row = json_object_array_get_idx( rows, i );
		for ( size_t take = 0; take < 2; ++take )
		{
			struct json_object* targets = testAt( json_object_array_get_idx( table, take ), "targets" );
			struct json_object* cell = json_object_array_get_idx( testAt( row, "cells" ), take );
			struct json_object* wanted = json_object_object_get( targets, testTextAt( row, "name" ) );
			assert_true( json_object_equal( testAt( cell, "holds" ), wanted ) );
			if ( wanted != NULL )
			{
				double value = json_object_get_double( testAt( cell, "value" ) );
				double limit = json_object_get_double( testAt( cell, "limit" ) );
				bool more = json_object_get_boolean( testAt( row, "atLeast" ) );
				assert_int_equal( more ? value >= limit : value <= limit, json_object_get_boolean( wanted ) );
				++count;
			}
		}
	}
	assert_int_equal( count, 20 );
	json_object_put( table );
	testFreePage( &page );
}

// What the curves of a leg say has to be what was measured of them.
static void testLegCurves( struct json_object* walk, int take, int leg )
{
	char path[64];
	snprintf( path, sizeof path, "takes.%d.figures.legs.%d", take, leg );
	struct json_object* figures = testAt( walk, path );
	snprintf( path, sizeof path, "takes.%d.legs.%d", take, leg );
	struct json_object* curves = testAt( walk, path );
	struct json_object* accelerations = testAt( curves, "acceleration" );
	snprintf( path, sizeof path, "labels.%d", leg );
	struct json_object* labels = testAt( walk, path );
	size_t frames = (size_t)json_object_get_int( testAt( walk, "frames" ) );
	size_t skip = (size_t)json_object_get_int( testAt( walk, "skip" ) );
	assert_int_equal( json_object_array_length( accelerations ), frames );
	assert_int_equal( json_object_array_length( testAt( curves, "planted" ) ), frames );
	double squares = 0.0;
	double deepest = 0.0;
	int labelled = 0;
	for ( size_t f = skip; f < frames; ++f )
	{
		double acceleration = testNumberAt( accelerations, f );
		squares += f > skip && f + 1 < frames ? acceleration * acceleration : 0.0;
		bool stands = testNumberAt( labels, f ) > 0.0;
		deepest = stands ? fmax( deepest, -testNumberAt( testAt( curves, "height" ), f ) ) : deepest;
		labelled += stands ? 1 : 0;
	}
	double rms = sqrt( squares / (double)( frames - skip - 2 ) );
	double measured = json_object_get_double( testAt( figures, "kneeAccelerationRms" ) );
	assert_true( measured > 1.0 );
	assert_true( fabs( rms - measured ) <= 1e-3 * measured );
	assert_int_equal( labelled, json_object_get_int( testAt( figures, "labelledFrames" ) ) );
	assert_float_equal( deepest, json_object_get_double( testAt( figures, "verticalPenetration.max" ) ), 1e-4 );
}

static void curvesAreWhatIsMeasured( void** state )
{
	(void)state;
	testDo( "report m.glb --ground course" REPORT "c.html" );
	testPage page = testReadPage( "c.html" );
	struct json_object* walk = testAt( page.data, "walks.0" );
	for ( int i = 0; i < 4; ++i )
	{
		testLegCurves( walk, i / 2, i % 2 );
	}
	int frames = json_object_get_int( testAt( walk, "frames" ) );
	assert_int_equal( json_object_array_length( testAt( walk, "takes.1.pelvis" ) ), 3 * frames );
	testFreePage( &page );
}

static void noneIsAlwaysFirst( void** state )
{
	(void)state;
	testDo(
	    "report m.glb --ground T01 --distance 2 --clip run --clip walk --method ozz --method none --settings s.json" REPORT
	    "n.html" );
	testPage page = testReadPage( "n.html" );
	assert_int_equal( json_object_array_length( testAt( page.data, "walks" ) ), 2 );
	assert_string_equal( testTextAt( page.data, "walks.0.clip" ), "run" );
	assert_int_equal( json_object_array_length( testAt( page.data, "walks.1.takes" ) ), 2 );
	assert_string_equal( testTextAt( page.data, "walks.1.takes.0.clip" ), "walk|none" );
	assert_string_equal( testTextAt( page.data, "walks.1.takes.1.clip" ), "walk|ozz" );
	assert_int_equal( json_object_array_length( testAt( page.data, "settings" ) ), 1 );
	assert_string_equal( testTextAt( page.data, "settings.0.name" ), "contact.lockDistance" );
	assert_true( json_object_get_double( testAt( page.data, "settings.0.value" ) ) == 0.125 );
	testFreePage( &page );
}

static int testCount( const char* text, const char* what )
{
	int count = 0;
	for ( const char* at = strstr( text, what ); at != NULL; at = strstr( at + 1, what ) )
	{
		++count;
	}
	return count;
}

static void hostileNamesStayText( void** state )
{
	(void)state;
	toolModel model;
	toolMakeMannequin( &model );
	int32_t walk = toolFindClip( &model, "walk" );
	int32_t thigh = toolFindNode( &model, "thigh_l" );
	free( model.clips[walk].name );
	free( model.nodes[thigh].name );
	model.clips[walk].name = toolCopyString( hostileClip );
	model.nodes[thigh].name = toolCopyString( "thigh_l</ScRiPt\n>" );
	testWriteModel( &model, "hostile.glb" );
	toolFreeModel( &model );
	char* command = toolFormat( "report hostile.glb --ground T01 --distance 2 --clip %s" REPORT "h.html", hostileClip );
	assert_null( strchr( hostileClip, ' ' ) );
	testDo( command );
	free( command );
	testPage page = testReadPage( "h.html" );
	assert_int_equal( testCount( page.text, "</" ), 3 + 3 ); // two paragraphs and the end of HTML; three scripts
	assert_int_equal( testCount( page.text, "<script" ), 3 );
	assert_int_equal( testCount( page.text, "<!--" ), 0 );
	assert_string_equal( testTextAt( page.data, "walks.0.clip" ), hostileClip );
	assert_string_equal( testTextAt( page.data, "legs.0.joints.0" ), "thigh_l</ScRiPt\n>" );
	testFreePage( &page );
}

static void badInputIsTold( void** state )
{
	(void)state;
	testIsRefused( "report m.glb --ground T01 -o bad.html", 1, "share/sole/report.html", "scripts/build_report.sh" );
	testIsRefused( "report m.glb --ground T01 --template gone.html -o bad.html", 1, "gone.html", "cannot be read" );
	testIsRefused( "report m.glb --ground T01 --template none.html -o bad.html", 1, "none.html", "no template" );
	testIsRefused( "report m.glb --ground T01 --template two.html -o bad.html", 1, "two.html", "no template" );
	testIsRefused( "report text.glb --ground T01" REPORT "bad.html", 1, "text.glb", NULL );
	testIsRefused( "report m.glb --ground text.glb" REPORT "bad.html", 1, "text.glb", NULL );
	testIsRefused( "report m.glb --ground T01 --clip fly" REPORT "bad.html", 1, "m.glb", "fly" );
	testIsRefused( "report m.glb --ground T01 --settings t.html" REPORT "bad.html", 1, "t.html", NULL );
	testIsRefused( "report m.glb --ground T01" REPORT "gone/bad.html", 1, "gone/bad.html", "cannot be written" );
	testIsRefused( "report", 2, NULL, "the character is missing" );
	testIsRefused( "report m.glb -o bad.html", 2, NULL, "--ground is missing" );
	testIsRefused( "report m.glb --ground T01", 2, NULL, "-o is missing" );
	testIsRefused( "report m.glb --ground T01 -o bad.html --method fly", 2, NULL, "--method" );
	testIsRefused( "report m.glb --ground T01 -o bad.html --template", 2, NULL, "lacks its value" );
	testIsRefused( "report m.glb --ground T01 -o bad.html --plots .", 2, NULL, "unknown" );
	testRun run = testGood( "report --help" );
	assert_non_null( strstr( run.out, "--template" ) );
	assert_non_null( strstr( run.out, "homebrew" ) );
	testEnd( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( thePageIsTheTemplateWithData ),
		cmocka_unit_test( figuresAreThoseOfBakeAndMeasure ),
		cmocka_unit_test( targetsAreThoseOfTheTable ),
		cmocka_unit_test( curvesAreWhatIsMeasured ),
		cmocka_unit_test( noneIsAlwaysFirst ),
		cmocka_unit_test( hostileNamesStayText ),
		cmocka_unit_test( badInputIsTold ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
