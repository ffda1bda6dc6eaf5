// SPDX-License-Identifier: MIT
// What the program refuses, from outside: wrong usage and bad input end with one line, and nothing is written.
#define _POSIX_C_SOURCE 200809L
#define TEST_NAME "test_refusals"
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
	testMakeFolders();
	mkdir( FOLDER "/folder.glb", 0777 );
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
	testWriteText( "broken.json", "{ \"probe\": \n" );
	testWriteText( "list.json", "[]" );
	testWriteText( "name.json", "{ \"contact\": { \"speedOnn\": 0.25 } }" );
	testWriteText( "group.json", "{ \"contacts\": { \"speedOn\": 0.25 } }" );
	testWriteText( "range.json", "{ \"contact\": { \"speedOn\": 1e9 } }" );
	testWriteText( "type.json", "{ \"contact\": { \"speedOn\": \"fast\" } }" );
	return 0;
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
		cmocka_unit_test( badInputEndsWithOneLine ),
		cmocka_unit_test( numbersThatAreNoneAreWrongUsage ),
		cmocka_unit_test( cutFilesAreRefused ),
		cmocka_unit_test( changedBytesDoNoHarm ),
	};
	return cmocka_run_group_tests( tests, testSetUp, NULL );
}
