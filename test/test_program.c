// SPDX-License-Identifier: MIT
// The program from outside: what its commands promise, and that bad input ends it with one line and nothing written.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_program"
#include "program_run.h"

#include "mannequin.h"

#include <math.h>

// ---------------------------------------------------------------------------------------------------------- files

// Writes m.glb with some of its bytes replaced, at the first place where they are.
static void testPatch( const char* name, const void* from, const void* to, size_t count )
{
	size_t byteCount = 0;
	uint8_t* bytes = testReadBytes( testInFolder( "m.glb" ), &byteCount );
	size_t at = 0;
	while ( at + count <= byteCount && memcmp( bytes + at, from, count ) != 0 )
	{
		++at;
	}
	assert_true( at + count <= byteCount );
	memcpy( bytes + at, to, count );
	testWriteBytes( testInFolder( name ), bytes, byteCount );
	free( bytes );
}

// The mannequin with keys that are none.
static void testWriteBadKeys( void )
{
	toolGltf* gltf = testOpenFile( testInFolder( "m.glb" ) );
	const toolModel* model = toolGltf_GetModel( gltf );
	int32_t walk = toolFindClip( model, "walk" );
	assert_true( walk >= 0 );
	const toolChannel* channel = NULL;
	for ( int32_t i = 0; i < model->clips[walk].channelCount && channel == NULL; ++i )
	{
		const toolChannel* c = model->clips[walk].channels + i;
		bool leg = strcmp( model->nodes[c->node].name, "thigh_l" ) == 0 && c->path == tool_pathRotation;
		channel = leg ? c : NULL;
	}
	assert_non_null( channel );
	assert_true( channel->keyCount > 3 );
	float values[4];
	memcpy( values, channel->values + 4, sizeof values );
	values[1] = NAN;
	testPatch( "nan_key.glb", channel->values + 4, values, sizeof values );
	float times[4];
	memcpy( times, channel->times, sizeof times );
	times[1] = channel->times[2];
	times[2] = channel->times[1];
	testPatch( "times.glb", channel->times, times, sizeof times );
	toolFreeGltf( gltf );
}

// Clips that say of themselves that they were baked.
static const char* const testExtras[] = {
	"{\"sole\":{\"clip\":\"a\\nb\",\"method\":\"sole\",\"fps\":60,\"frames\":10,\"travel\":0}}",
	"{\"sole\":{\"clip\":\"walk\",\"method\":\"sole\",\"fps\":60,\"frames\":10,\"travel\":1000}}",
	"{\"sole\":{\"clip\":\"walk\",\"clips\":\"gone.glb\",\"fps\":60,\"frames\":10,\"travel\":0}}",
	"{\"sole\":{\"clip\":\"walk\",\"clips\":\"/dev/zero\",\"fps\":60,\"frames\":10,\"travel\":0}}",
	"{\"sole\":{\"clip\":\"walk\",\"fps\":60,\"frames\":500000,\"travel\":0}}",
};

static void testWriteMannequins( void )
{
	toolModel model;
	toolMakeMannequin( &model );
	int32_t clipCount = model.clipCount;
	model.clipCount = 0;
	testWriteModel( &model, "no_clips.glb" );
	model.clipCount = clipCount;
	for ( int32_t i = 0; i < (int32_t)( sizeof testExtras / sizeof testExtras[0] ); ++i )
	{
		toolClip* clip = model.clips + toolFindClip( &model, "idle" );
		free( clip->extras );
		clip->extras = toolCopyString( testExtras[i] );
		char name[32];
		snprintf( name, sizeof name, "extras%d.glb", i );
		testWriteModel( &model, name );
	}
	// Without skins, which know where the joints were.
	int32_t skinCount = model.skinCount;
	model.skinCount = 0;
	for ( int32_t i = 0; i < model.nodeCount; ++i )
	{
		const char* name = model.nodes[i].name;
		bool leg = strncmp( name, "shin_", 5 ) == 0 || strncmp( name, "foot_", 5 ) == 0;
		soleVec3* place = &model.nodes[i].local.translation;
		*place = leg ? soleVec( 0.0f, 0.0f, 0.0f ) : *place;
		model.nodes[i].skin = SOLE_NONE;
	}
	testWriteModel( &model, "zero_legs.glb" );
	model.skinCount = skinCount;
	toolFreeModel( &model );
}

static int testSetUp( void** state )
{
	(void)state;
	mkdir( FOLDER, 0777 );
	mkdir( FOLDER "/written", 0777 );
	mkdir( FOLDER "/folder.glb", 0777 );
	testEmptyFolder( FOLDER );
	testEmptyFolder( FOLDER "/written" );
	testDo( "sample mannequin -o m.glb" );
	testDo( "sample flat -o flat.glb" );
	testDo( "bake m.glb --ground flat --method none --method sole --distance 4 -o o.glb" );
	testWriteMannequins();
	testWriteBadKeys();
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"children\":[1]", "\"children\":[0]" );
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	testWriteBytes( testInFolder( "cycle.glb" ), bytes, count );
	free( bytes );
	testWriteText( "empty.glb", "" );
	testWriteText( "text.glb", "This is no model.\nIt is a text of two lines.\n" );
	testWriteText( "points.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\n" );
	testWriteText( "nan.obj", "v 0 nan 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n" );
	testWriteText( "index.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 9\n" );
	testWriteText( "thin.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n" );
	testWriteText( "slope.obj", "v -9 0 -9\nv -9 0 9\nv 9 0.3 9\nv 9 0.3 -9\nf 1 2 3 4\n" );
	testWriteText( "broken.json", "{ \"probe\": \n" );
	testWriteText( "list.json", "[]" );
	testWriteText( "name.json", "{ \"contact\": { \"speedOnn\": 0.25 } }" );
	testWriteText( "group.json", "{ \"contacts\": { \"speedOn\": 0.25 } }" );
	testWriteText( "range.json", "{ \"contact\": { \"speedOn\": 1e9 } }" );
	testWriteText( "type.json", "{ \"contact\": { \"speedOn\": \"fast\" } }" );
	return 0;
}

// ------------------------------------------------------------------------------------------------------- contract

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

// Checks that a path such as "legs[].sole.heel" is there, in every item of a list, which must not be empty.
static void testHas( const char* what, struct json_object* object, const char* path )
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

static void testHasAll( const char* what, struct json_object* object, const char* const* paths )
{
	for ( ; *paths != NULL; ++paths )
	{
		testHas( what, object, *paths );
	}
}

static struct json_object* testGet( struct json_object* object, const char* key )
{
	struct json_object* value = NULL;
	if ( json_object_object_get_ex( object, key, &value ) == 0 )
	{
		fail_msg( "there is no '%s'", key );
	}
	return value;
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

static const char* const testFigurePaths[] = { "legs[].name", "legs[].penetration.mean", "legs[].penetration.p95",
	"legs[].penetration.max", "legs[].hover.mean", "legs[].hover.p95", "legs[].hover.max", "legs[].contactShare",
	"legs[].slide", "legs[].drift", "legs[].overExtended", "whole.kneeAccelerationRms", "whole.pelvisJerk",
	"whole.largestJump", "ratios", "clip", "fps", NULL };

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
		testHasAll( "bake", baked, testFigurePaths );
		testHas( "bake", baked, "method" );
		assert_string_equal( json_object_get_string( testGet( baked, "clip" ) ), i == 0 ? "walk|none" : "walk|sole" );
		struct json_object* measured = testGoodJson( i == 0
		        ? "measure written/c.glb --ground course --clip walk|none --json"
		        : "measure written/c.glb --ground course --clip walk|sole --reference walk|none --json" );
		testHasAll( "measure", measured, testFigurePaths );
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
		testHasAll( "table", row, testFigurePaths );
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
		testHasAll( "compare", item, testFigurePaths );
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

// ------------------------------------------------------------------------------------------------------ bad input

typedef struct testBad
{
	const char* command;
	int status;
	const char* file; // that the message names, or NULL
	const char* says; // or NULL
} testBad;

#define ON_FLAT " --ground flat -o bad.glb"

static const testBad testBads[] = {
	// usage
	{ "walk", 2, "walk", "command" },
	{ "sample", 2, NULL, NULL },
	{ "sample mannequin", 2, NULL, "-o" },
	{ "sample -o bad.glb", 2, NULL, NULL },
	{ "sample mannequin --what -o bad.glb", 2, NULL, "option" },
	{ "inspect", 2, NULL, NULL },
	{ "inspect m.glb o.glb", 2, NULL, NULL },
	{ "inspect m.glb --what", 2, NULL, "option" },
	{ "inspect m.glb --scale", 2, NULL, NULL },
	{ "bake", 2, NULL, "character" },
	{ "bake m.glb -o bad.glb", 2, NULL, "--ground" },
	{ "bake m.glb --ground flat", 2, NULL, "-o" },
	{ "bake m.glb --what" ON_FLAT, 2, NULL, "option" },
	{ "bake m.glb --method magic" ON_FLAT, 2, NULL, "--method" },
	{ "bake m.glb --method sole --method sole" ON_FLAT, 2, NULL, "--method" },
	{ "bake m.glb --clip walk --clip walk" ON_FLAT, 2, NULL, "--clip" },
	{ "bake m.glb --path 0,0" ON_FLAT, 2, NULL, "--path" },
	{ "bake m.glb --path 1,1;1,1" ON_FLAT, 2, NULL, "--path" },
	{ "bake m.glb --path 0,0;1" ON_FLAT, 2, NULL, "--path" },
	{ "bake m.glb --path 0,0;1,1e300" ON_FLAT, 2, NULL, "--path" },
	{ "bake m.glb --path 0,0;1,1 --start 0,0" ON_FLAT, 2, NULL, "--path" },
	{ "bake m.glb --start 0,inf" ON_FLAT, 2, NULL, "--start" },
	{ "bake m.glb --start 0,0,0,0" ON_FLAT, 2, NULL, "--start" },
	{ "bake m.glb --fps 1e9" ON_FLAT, 2, NULL, "--fps" },
	{ "bake m.glb --distance 1e9" ON_FLAT, 2, NULL, "--distance" },
	{ "measure o.glb --ground flat", 2, NULL, "--clip" },
	{ "measure o.glb --clip walk|sole", 2, NULL, "--ground" },
	{ "measure --ground flat --clip walk", 2, NULL, NULL },
	{ "measure o.glb --ground flat --clip walk --scale nan", 2, NULL, "--scale" },
	{ "measure --table", 2, NULL, "character" },
	{ "measure o.glb --table --fps 59.94", 2, NULL, "--fps" },
	{ "measure o.glb --table --fps 0", 2, NULL, "--fps" },
	{ "measure o.glb --table --fps ,", 2, NULL, "empty" },
	{ "measure o.glb --table --method magic", 2, NULL, "--method" },
	{ "measure o.glb --table --scale 0", 2, NULL, "--scale" },
	{ "measure o.glb --table --reference walk", 2, NULL, "option" },
	{ "measure o.glb --table --path 0,0,0", 2, NULL, "--path" },
	{ "measure o.glb --table --path 0,0;1,1 --heading 3", 2, NULL, "exclude" },
	{ "compare", 2, NULL, "character" },
	{ "compare m.glb", 2, NULL, "--ground" },
	{ "compare m.glb o.glb --all", 2, NULL, "one character" },
	{ "compare m.glb --all --ground flat", 2, NULL, "exclude" },
	{ "compare m.glb --all --json --markdown", 2, NULL, "exclude" },
	{ "compare m.glb --ground flat --what", 2, NULL, "option" },
	{ "compare m.glb --ground", 2, NULL, "option" },
	{ "compare m.glb --ground flat --method magic", 2, NULL, "--method" },
	{ "compare m.glb --ground flat --method sole --method sole", 2, NULL, "twice" },
	{ "compare m.glb --ground flat --fps 59.94", 2, NULL, "--fps" },
	{ "compare m.glb --ground flat --scale -1", 2, NULL, "--scale" },
	{ "compare m.glb --ground flat --path 0,0", 2, NULL, "--path" },
	{ "label", 2, NULL, NULL },
	{ "label m.glb --scale 0", 2, NULL, "--scale" },
	{ "settings more", 2, NULL, NULL },
	{ "settings --what", 2, NULL, "option" },
	// names
	{ "sample nothing -o bad.glb", 1, "nothing", "--list" },
	{ "inspect gone.glb", 1, "gone.glb", NULL },
	{ "bake gone.glb" ON_FLAT, 1, "gone.glb", NULL },
	{ "bake ''" ON_FLAT, 1, NULL, NULL },
	{ "bake m.glb --ground gone -o bad.glb", 1, "gone", NULL },
	{ "bake m.glb --clips gone.glb" ON_FLAT, 1, "gone.glb", NULL },
	{ "bake m.glb --clip moonwalk" ON_FLAT, 1, "m.glb", "moonwalk" },
	{ "bake o.glb --clip walk" ON_FLAT, 1, "o.glb", "walk|sole" },
	{ "label m.glb --clip moonwalk", 1, "m.glb", "moonwalk" },
	{ "measure o.glb --ground flat --clip moonwalk", 1, "o.glb", "moonwalk" },
	{ "measure o.glb --table --clip moonwalk", 1, "o.glb", "moonwalk" },
	{ "measure o.glb --table --ground flat,gone", 1, "gone", NULL },
	{ "measure o.glb --table --clips gone.glb", 1, "gone.glb", NULL },
	{ "measure o.glb --table --settings gone.json", 1, "gone.json", NULL },
	{ "compare gone.glb --all", 1, "gone.glb", NULL },
	{ "compare m.glb --ground flat --ground gone", 1, "gone", NULL },
	{ "compare m.glb --ground points.obj -o bad.txt", 1, "points.obj", NULL },
	{ "compare m.glb --ground flat --clip moonwalk -o bad.txt", 1, "m.glb", "moonwalk" },
	{ "compare m.glb --ground flat --clips no_clips.glb", 1, "no_clips.glb", NULL },
	{ "compare m.glb --ground flat --settings broken.json", 1, "broken.json", "JSON" },
	{ "compare m.glb --ground flat --method none -o gone/bad.txt", 1, "gone/bad.txt", NULL },
	{ "compare m.glb --ground flat --method none -o folder.glb", 1, "folder.glb", NULL },
	{ "compare m.glb --all --method none --scale 1e-6", 1, NULL, NULL },
	{ "measure o.glb --ground flat --clip walk|sole --reference moonwalk", 1, "o.glb", "moonwalk" },
	{ "measure o.glb --ground flat --clip walk|sole --reference idle", 1, "o.glb", "idle" },
	{ "measure o.glb --ground gone --clip walk|sole", 1, "gone", NULL },
	{ "measure o.glb --ground flat --clip walk|sole --clips gone.glb", 1, "gone.glb", NULL },
	{ "measure o.glb --ground flat --clip walk|sole --clips no_clips.glb", 1, "o.glb", "walk" },
	// characters
	{ "inspect empty.glb", 1, "empty.glb", NULL },
	{ "inspect folder.glb", 1, "folder.glb", "not a file" },
	{ "inspect text.glb", 1, "text.glb", NULL },
	{ "inspect /dev/zero", 1, "/dev/zero", NULL },
	{ "inspect cycle.glb", 1, "cycle.glb", "tree" },
	{ "bake cycle.glb" ON_FLAT, 1, "cycle.glb", "tree" },
	{ "inspect flat.glb", 1, "flat.glb", NULL },
	{ "bake flat.glb" ON_FLAT, 1, "flat.glb", NULL },
	{ "bake zero_legs.glb" ON_FLAT, 1, "zero_legs.glb", NULL },
	{ "bake m.glb --clips no_clips.glb" ON_FLAT, 1, "no_clips.glb", NULL },
	{ "bake nan_key.glb" ON_FLAT, 1, "nan_key.glb", "not finite" },
	{ "bake times.glb" ON_FLAT, 1, "times.glb", "earlier" },
	{ "label no_clips.glb", 1, "no_clips.glb", "clips" },
	{ "inspect m.glb --scale 1e-9", 1, "m.glb", NULL },
	{ "bake m.glb --scale 1e-6" ON_FLAT, 1, "m.glb", NULL },
	{ "measure extras0.glb --ground flat --clip idle", 1, "extras0.glb", "a?b" },
	{ "measure extras1.glb --ground flat --clip idle", 1, "extras1.glb", "travel" },
	{ "measure extras2.glb --ground flat --clip idle", 1, "gone.glb", NULL },
	{ "measure extras3.glb --ground flat --clip idle", 1, "/dev/zero", NULL },
	{ "measure extras4.glb --ground flat --clip idle", 1, "extras4.glb", "frames" },
	{ "label extras0.glb --clip idle", 1, "extras0.glb", "a?b" },
	// grounds and ways
	{ "bake m.glb --ground points.obj -o bad.glb", 1, "points.obj", NULL },
	{ "bake m.glb --ground nan.obj -o bad.glb", 1, "nan.obj", NULL },
	{ "bake m.glb --ground index.obj -o bad.glb", 1, "index.obj", NULL },
	{ "bake m.glb --ground thin.obj -o bad.glb", 1, "thin.obj", NULL },
	{ "bake m.glb --ground empty.glb -o bad.glb", 1, "empty.glb", NULL },
	{ "bake m.glb --ground folder.glb -o bad.glb", 1, "folder.glb", NULL },
	{ "measure o.glb --ground points.obj --clip walk|sole", 1, "points.obj", NULL },
	{ "bake m.glb --start 500,500" ON_FLAT, 1, "flat", "no ground" },
	{ "bake m.glb --path 0,0;0,500" ON_FLAT, 1, "flat", "leaves the ground" },
	{ "bake m.glb --start 0,0 --distance 1e5" ON_FLAT, 1, "flat", NULL },
	{ "bake m.glb --clip idle --duration 3600 --fps 1000" ON_FLAT, 1, "flat", "hour" },
	{ "bake m.glb --speed 0.001" ON_FLAT, 1, "flat", "hour" },
	// outputs
	{ "bake m.glb --ground flat --distance 1 -o /proc/bad.glb", 1, "/proc/bad.glb", NULL },
	{ "bake m.glb --ground flat --distance 1 -o folder.glb", 1, "folder.glb", NULL },
	{ "bake m.glb --ground flat --distance 1 -o m.glb/bad.glb", 1, "m.glb/bad.glb", NULL },
	{ "bake m.glb --ground flat --distance 1 -o gone/bad.glb", 1, "gone/bad.glb", NULL },
	{ "bake m.glb --ground flat --distance 1 -o gone/bad.gltf", 1, "gone/bad", NULL },
	{ "bake m.glb --distance 1 --plots m.glb" ON_FLAT, 1, "m.glb", NULL },
	{ "sample flat -o /proc/bad.glb", 1, "/proc/bad.glb", NULL },
	// settings
	{ "bake m.glb --settings gone.json" ON_FLAT, 1, "gone.json", NULL },
	{ "bake m.glb --settings broken.json" ON_FLAT, 1, "broken.json", "JSON" },
	{ "bake m.glb --settings list.json" ON_FLAT, 1, "list.json", "object" },
	{ "bake m.glb --settings name.json" ON_FLAT, 1, "name.json", "contact.speedOnn" },
	{ "bake m.glb --settings group.json" ON_FLAT, 1, "group.json", "contacts" },
	{ "bake m.glb --settings range.json" ON_FLAT, 1, "range.json", "contact.speedOn" },
	{ "bake m.glb --settings type.json" ON_FLAT, 1, "type.json", "contact.speedOn" },
	{ "bake --settings range.json --print-settings", 1, "range.json", "contact.speedOn" },
};

static void badInputEndsWithOneLine( void** state )
{
	(void)state;
	assert_true( sizeof testBads / sizeof testBads[0] >= 40 );
	for ( size_t i = 0; i < sizeof testBads / sizeof testBads[0]; ++i )
	{
		const testBad* bad = testBads + i;
		testIsRefused( bad->command, bad->status, bad->file, bad->says );
	}
	testRun run = testSole( "" );
	assert_int_equal( run.status, 2 );
	testEnd( &run );
}

static void numbersThatAreNoneAreWrongUsage( void** state )
{
	(void)state;
	static const char* const options[] = { "--fps", "--speed", "--distance", "--scale", "--heading", "--duration",
		"--start" };
	static const char* const values[] = { "nan", "inf", "-inf", "12x", "''", "1e999", "0x" };
	for ( size_t i = 0; i < sizeof options / sizeof options[0]; ++i )
	{
		for ( size_t k = 0; k < sizeof values / sizeof values[0]; ++k )
		{
			char command[128];
			snprintf( command, sizeof command, "bake m.glb %s %s" ON_FLAT, options[i], values[k] );
			testIsRefused( command, 2, NULL, options[i] );
		}
	}
	static const char* const low[] = { "--fps", "--speed", "--distance", "--scale", "--duration" };
	for ( size_t i = 0; i < 2 * sizeof low / sizeof low[0]; ++i )
	{
		char command[128];
		snprintf( command, sizeof command, "bake m.glb %s %s" ON_FLAT, low[i / 2], i % 2 == 0 ? "0" : "-1" );
		testIsRefused( command, 2, NULL, low[i / 2] );
	}
}

static void cutFilesAreRefused( void** state )
{
	(void)state;
	size_t count = 0;
	uint8_t* bytes = testReadBytes( testInFolder( "m.glb" ), &count );
	size_t json = testU32( bytes + 12 );
	const size_t places[] = { 1, 4, 11, 12, 19, 20, 20 + json / 2, 20 + json, 28 + json, count / 2, count - 1 };
	for ( size_t i = 0; i < sizeof places / sizeof places[0]; ++i )
	{
		testWriteBytes( testInFolder( "cut.glb" ), bytes, places[i] );
		testIsRefused( "bake cut.glb" ON_FLAT, 1, "cut.glb", NULL );
		testIsRefused( "bake m.glb --ground cut.glb -o bad.glb", 1, "cut.glb", NULL );
	}
	free( bytes );
}

static void changedBytesDoNoHarm( void** state )
{
	(void)state;
	size_t count = 0;
	uint8_t* bytes = testReadBytes( testInFolder( "m.glb" ), &count );
	uint32_t seed = 4711;
	int refused = 0;
	for ( int i = 0; i < 16; ++i )
	{
		size_t at = i < 4 ? testRandom( &seed ) % 20 : 20 + testRandom( &seed ) % testU32( bytes + 12 );
		uint8_t change = (uint8_t)( 1 + testRandom( &seed ) % 255 );
		bytes[at] ^= change;
		testWriteBytes( testInFolder( "changed.glb" ), bytes, count );
		bytes[at] ^= change;
		testRun run = testSole( "bake changed.glb --distance 1" ON_FLAT );
		if ( run.status == 0 )
		{
			assert_string_equal( run.err, "" );
			assert_int_equal( remove( testInFolder( "bad.glb" ) ), 0 );
		}
		else
		{
			assert_int_equal( run.status, 1 );
			testIsOneLine( &run, "changed.glb" );
			++refused;
		}
		testNothingLeft( &run );
		testEnd( &run );
	}
	assert_true( refused >= 4 );
	free( bytes );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theProgramExplainsItself ),
		cmocka_unit_test( everySampleIsWritten ),
		cmocka_unit_test( samplesAreListedAsJsonWithTheirWays ),
		cmocka_unit_test( inspectSaysWhatItPromises ),
		cmocka_unit_test( measureAgreesWithBake ),
		cmocka_unit_test( aTableHasARowForEachGroundMethodAndRate ),
		cmocka_unit_test( aTableAgreesWithBake ),
		cmocka_unit_test( aComparisonHasWhatMeasureHas ),
		cmocka_unit_test( comparisonsAreWrittenAsTheyArePrinted ),
		cmocka_unit_test( bakeKeepsTheFile ),
		cmocka_unit_test( bakeWritesGltf ),
		cmocka_unit_test( clipsOfASecondFileAreBaked ),
		cmocka_unit_test( labelsAreListed ),
		cmocka_unit_test( settingsGoRound ),
		cmocka_unit_test( badInputEndsWithOneLine ),
		cmocka_unit_test( numbersThatAreNoneAreWrongUsage ),
		cmocka_unit_test( cutFilesAreRefused ),
		cmocka_unit_test( changedBytesDoNoHarm ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
