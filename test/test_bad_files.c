// SPDX-License-Identifier: MIT
// Files that are broken or hostile: refused with one line that says what is wrong and what to do, never a crash.
#define _POSIX_C_SOURCE 200809L
#include "glb_maker.h"

#include "ground_file.h"

#include <dirent.h>

#define TEMP( name ) testTempPath( "test_bad_files", name )

/// "PATH: what is wrong: what to do", one line of clean text.
static void testIsMessage( const char* what, const char* path, const toolError* error )
{
	const char* text = error->text;
	size_t length = strlen( text );
	const char* first = strstr( text, ": " );
	bool good = length > 0 && length < sizeof error->text && strncmp( text, path, strlen( path ) ) == 0 &&
	    strncmp( text + strlen( path ), ": ", 2 ) == 0 && first != NULL && strstr( first + 2, ": " ) != NULL;
	for ( size_t i = 0; i < length; ++i )
	{
		good = good && (unsigned char)text[i] >= 0x20 && text[i] != 0x7f;
	}
	if ( good == false )
	{
		fail_msg( "%s: bad message: %s", what, text );
	}
}

static void testIsRefused( const char* what, const testParts* parts, const char* says )
{
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	if ( testReadParts( parts, &gltf, &error ) )
	{
		fail_msg( "%s: was read", what );
	}
	assert_null( gltf );
	testIsMessage( what, "leg.glb", &error );
	if ( strstr( error.text, says ) == NULL )
	{
		fail_msg( "%s: says %s", what, error.text );
	}
}

// ------------------------------------------------------------------------------------------------ one change each

typedef struct testBadText
{
	const char* from;
	const char* to;
	const char* says; // what the message must have in it
} testBadText;

static const testBadText testBadTexts[] = {
	// JSON
	{ "{\"asset\"", "{\"asset\" \"x\"", "broken at byte" },
	{ "\"scene\":0", "\"scene\":0,\"scene\":0", "key twice" },
	{ "\"name\":\"hip\"", "\"name\":\"hip\",\"n\\u0061me\":\"toe\"", "key twice" },
	{ "\"name\":\"hip\"", "\"name\":\"hip\\u0000\"", "zero character" },
	{ "\"name\":\"hip\"", "\"name\":\"h\\x\"", "escape" },
	{ "\"name\":\"hip\"", "\"name\":\"h\n\"", "control character" },
	{ "\"scene\":0", "\"scene\":00", "broken" },
	{ "\"scene\":0", "\"scene\":NaN", "broken" },
	{ "\"scene\":0", "\"scene\":0,", "broken" },
	{ "\"scene\":0", "'scene':0", "broken" },
	{ "\"scene\":0", "\"scene\":0/* */", "broken" },
	{ "\"buffers\":[{\"byteLength\":368}]}", "\"buffers\":[{\"byteLength\":368}]", "ends early" },
	{ "\"buffers\":[{\"byteLength\":368}]}", "\"buffers\":[{\"byteLength\":368}]}}", "behind its end" },
	// the whole
	{ "\"asset\":{\"version\":\"2.0\"},", "", "asset.version" },
	{ "\"version\":\"2.0\"", "\"version\":\"1.0\"", "version 1.0" },
	{ "\"scene\":0", "\"scene\":1", "scene 1 of 1" },
	{ "\"scene\":0", "\"scene\":-1", "cannot be" },
	{ "\"scene\":0", "\"scene\":\"0\"", "cannot be" },
	{ "\"nodes\":[0,2]", "\"nodes\":[0,3]", "scenes[0]" },
	{ "\"nodes\":[0,2]", "\"nodes\":[-1]", "scenes[0]" },
	{ "\"nodes\":[0,2]", "\"nodes\":{}", "no list" },
	{ "\"scene\":0", "\"extensionsRequired\":[\"EXT_meshopt_compression\"],\"scene\":0",
	    "EXT_meshopt_compression: decode" },
	{ "\"scene\":0", "\"extensionsRequired\":[\"KHR_draco_mesh_compression\"],\"scene\":0",
	    "KHR_draco_mesh_compression: decode" },
	{ "\"mode\":4", "\"extensions\":{\"KHR_draco_mesh_compression\":{}},\"attributes2\":{}", "" },
	// nodes
	{ "\"children\":[1]", "\"children\":[0]", "must form a tree" },
	{ "\"children\":[1]", "\"children\":[1,1]", "must form a tree" },
	{ "\"children\":[1]", "\"children\":[3]", "nodes[0] 'hip' has a child" },
	{ "\"children\":[1]", "\"children\":[1e99]", "has a child" },
	{ "\"children\":[1]", "\"children\":7", "no list" },
	{ "{\"name\":\"knee\",", "{\"name\":\"knee\",\"children\":[0],", "its own parents" },
	{ "\"translation\":[0,1,0]", "\"translation\":[0,1]", "3 finite numbers" },
	{ "\"translation\":[0,1,0]", "\"translation\":[0,1e999,0]", "nodes[1] 'knee' has a translation" },
	{ "\"translation\":[0,1,0]", "\"rotation\":[0,1,0,1e39]", "rotation" },
	{ "\"translation\":[0,1,0]", "\"scale\":[0,1,\"x\"]", "scale" },
	{ "\"translation\":[0,1,0]", "\"matrix\":[1,0,0,0]", "matrix" },
	{ "\"mesh\":0,\"skin\":0", "\"mesh\":1,\"skin\":0", "mesh 1 of 1" },
	{ "\"mesh\":0,\"skin\":0", "\"mesh\":0,\"skin\":4294967296", "skin 4294967296" },
	{ "\"mesh\":0,\"skin\":0", "\"mesh\":0,\"skin\":0.5", "cannot be" },
	// skins
	{ "\"joints\":[0,1]", "\"joints\":[]", "no joints" },
	{ "\"joints\":[0,1]", "\"joints\":[0,9]", "a joint that is no node" },
	{ "\"joints\":[0,1]", "\"joints\":[0]", "follows joint 1 of 1" },
	{ "\"joints\":[0,1]", "\"joints\":[0,1,2]", "fewer inverse bind" },
	{ "\"inverseBindMatrices\":6", "\"inverseBindMatrices\":9", "9 of 9" },
	{ "\"inverseBindMatrices\":6", "\"inverseBindMatrices\":2", "type" },
	// meshes
	{ "\"POSITION\":0", "\"POSITION\":9", "POSITION 9 of 9" },
	{ "\"POSITION\":0", "\"POSITION\":3", "type" },
	{ "\"NORMAL\":7", "\"NORMAL\":5", "3 normals for 4 vertices" },
	{ "\"JOINTS_0\":1", "\"JOINTS_0\":2", "unsigned integers" },
	{ "\"JOINTS_0\":1", "\"JOINTS_0\":8", "unsigned integers" },
	{ "\"WEIGHTS_0\":2", "\"WEIGHTS_0\":8", "influences" },
	{ "\"indices\":3", "\"indices\":2", "type" },
	{ "\"indices\":3", "\"indices\":4", "unsigned integers" },
	{ "\"mode\":4", "\"mode\":7", "mode" },
	{ "\"material\":0", "\"material\":1", "material 1 of 1" },
	{ "\"primitives\":[{", "\"primitives\":{\"a\":[{}],\"b\":[]},\"x\":[{", "no list" },
	// clips
	{ "{\"input\":4,\"output\":5}", "{\"output\":5}", "names accessor -1" },
	{ "{\"input\":4,\"output\":5}", "{\"input\":4,\"output\":9}", "output 9 of 9" },
	{ "{\"input\":4,\"output\":5}", "{\"input\":4,\"output\":7}", "3 times but 4 values" },
	{ "{\"input\":4,\"output\":5}", "{\"input\":4,\"output\":5,\"interpolation\":\"CUBICSPLINE\"}",
	    "3 times but 3 values" },
	{ "{\"input\":4,\"output\":5}", "{\"input\":4,\"output\":5,\"interpolation\":\"BEZIER\"}", "'BEZIER'" },
	{ "{\"sampler\":0,", "{\"sampler\":2,", "sampler 2 of 2" },
	{ "\"target\":{\"node\":0,", "\"target\":{\"node\":3,", "node 3 of 3" },
	{ "\"count\":3,\"type\":\"SCALAR\"", "\"count\":0,\"type\":\"SCALAR\"", "no keys" },
	// accessors
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":5,\"type\":\"VEC3\"}", "outside of bufferViews[0]" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":2000000000,\"type\":\"VEC3\"}", "count" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":130000000,\"type\":\"VEC3\"}", "outside of" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":18446744073709551617,\"type\":\"VEC3\"}", "count" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":-4,\"type\":\"VEC3\"}", "count" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":4,\"byteOffset\":4,\"type\":\"VEC3\"}", "outside of" },
	{ "\"count\":4,\"type\":\"VEC3\"}", "\"count\":4,\"byteOffset\":9007199254740991,\"type\":\"VEC3\"}",
	    "byteOffset" },
	{ "{\"bufferView\":0,\"componentType\":5126", "{\"bufferView\":9,\"componentType\":5126", "bufferView 9 of 9" },
	{ "{\"bufferView\":0,\"componentType\":5126", "{\"componentType\":5126", "no data" },
	{ "{\"bufferView\":0,\"componentType\":5126", "{\"bufferView\":0,\"componentType\":5124", "type" },
	{ "\"sparse\":{\"count\":2", "\"sparse\":{\"count\":5", "count" },
	{ "\"indices\":{\"bufferView\":7,", "\"indices\":{", "not complete" },
	{ "\"indices\":{\"bufferView\":7,\"componentType\":5123}", "\"indices\":{\"bufferView\":7,\"componentType\":5126}",
	    "not complete" },
	{ "\"values\":{\"bufferView\":7,\"byteOffset\":4}", "\"values\":{\"bufferView\":7,\"byteOffset\":8}",
	    "outside of" },
	{ "{\"componentType\":5126,\"count\":4", "{\"componentType\":5126,\"count\":20000000", "without data" },
	{ "{\"componentType\":5126,\"count\":4", "{\"componentType\":5126,\"count\":130000000", "without data" },
	// views and buffers
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":0,\"byteLength\":48,\"byteStride\":4", "byteStride of 4" },
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":0,\"byteLength\":48,\"byteStride\":1000000000",
	    "byteStride" },
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":0,\"byteLength\":48,\"byteStride\":16", "outside of" },
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":321,\"byteLength\":48", "outside of the file's data" },
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":4503599627370495,\"byteLength\":48", "outside of" },
	{ "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":0,\"byteLength\":369", "outside of" },
	{ "{\"buffer\":0,", "{\"buffer\":1,", "outside of" },
	{ "{\"buffer\":0,", "{", "outside of" },
	{ "\"byteLength\":368", "\"byteLength\":372", "byteLength says 372" },
	{ "\"byteLength\":368", "\"byteLength\":9007199254740993", "byteLength" },
	{ "\"byteLength\":368", "\"byteLength\":16", "outside of" },
	{ "{\"byteLength\":368}", "{\"byteLength\":368,\"uri\":\"gone.bin\"}", "'gone.bin'" },
	{ "{\"byteLength\":368}", "{\"byteLength\":368,\"uri\":\"/etc/passwd\"}", "no file beside" },
	{ "{\"byteLength\":368}", "{\"byteLength\":368,\"uri\":\"http://127.0.0.1/x.bin\"}", "no file beside" },
	{ "{\"byteLength\":368}", "{\"byteLength\":368,\"uri\":\"x%00.bin\"}", "no file beside" },
	{ "{\"byteLength\":368}", "{\"byteLength\":3,\"uri\":\"data:;base64,AA*A\"}", "no base64" },
	{ "{\"byteLength\":368}", "{\"byteLength\":3,\"uri\":\"data:;base64,AAAAA\"}", "no base64" },
	{ "{\"byteLength\":368}", "{\"byteLength\":3,\"uri\":\"data:,AAAA\"}", "no base64" },
	{ "{\"byteLength\":368}", "{\"byteLength\":4,\"uri\":\"data:;base64,AAAA\"}",
	    "3 bytes where its byteLength says 4" },
	{ "{\"byteLength\":368}", "{\"byteLength\":368},{\"byteLength\":1}", "buffers[1] has no data" },
	// what a file puts into messages stays on their one line
	{ "\"name\":\"hip\",\"children\":[1]", "\"name\":\"a\\nb\\u001b[31m\xff\xc2\x9b\",\"children\":[5]", "'a?b?[31m?" },
};

static void everyBadTextIsRefused( void** state )
{
	(void)state;
	assert_true( sizeof testBadTexts / sizeof testBadTexts[0] >= 40 );
	for ( size_t i = 0; i < sizeof testBadTexts / sizeof testBadTexts[0]; ++i )
	{
		const testBadText* bad = testBadTexts + i;
		testParts leg = testMakeLeg();
		testReplace( &leg, bad->from, bad->to );
		if ( *bad->says != 0 )
		{
			testIsRefused( bad->to, &leg, bad->says );
			continue;
		}
		// Draco beside positions that are there: those are read
		toolFreeGltf( testOpenParts( &leg ) );
	}
}

static void badNumbersInTheDataAreRefused( void** state )
{
	(void)state;
	const struct
	{
		size_t at;
		float value;
		const char* says;
	} bad[] = {
		{ test_atPositions + 12, NAN, "vertex 1 is not finite" },
		{ test_atPositions + 44, INFINITY, "vertex 3 is not finite" },
		{ test_atWeights, -INFINITY, "weight" },
		{ test_atTimes, NAN, "time of key 0" },
		{ test_atTimes + 8, INFINITY, "animations[0] 'wave', nodes[0] 'hip': the time of key 2" },
		{ test_atTimes + 4, 0.25f, "animations[0] 'wave', nodes[0] 'hip': key 1 is earlier" },
		{ test_atTranslations + 12, NAN, "value of key 1" },
		{ test_atInverseBind + 64, NAN, "inverse bind" },
	};
	for ( size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i )
	{
		testParts leg = testMakeLeg();
		memcpy( leg.bin + bad[i].at, &bad[i].value, 4 );
		testIsRefused( bad[i].says, &leg, bad[i].says );
	}
	testParts leg = testMakeLeg();
	leg.bin[test_atIndices + 4] = 4;
	testIsRefused( "index", &leg, "index 2 is 4 but there are 4 vertices" );
	leg = testMakeLeg();
	leg.bin[test_atSparse] = 4;
	testIsRefused( "sparse", &leg, "sparse index" );
	leg = testMakeLeg();
	leg.bin[test_atJoints] = 2;
	testIsRefused( "joint", &leg, "follows joint 2 of 2" );
}

static void deepNestingIsRefused( void** state )
{
	(void)state;
	size_t depth = 1000000;
	const char* opens[] = { "[", "{\"a\":" };
	for ( int i = 0; i < 2; ++i )
	{
		size_t unit = strlen( opens[i] );
		char* json = malloc( depth * unit + 64 );
		assert_non_null( json );
		size_t at = (size_t)sprintf( json, "{\"asset\":{\"version\":\"2.0\"},\"extras\":" );
		for ( size_t j = 0; j < depth; ++j )
		{
			memcpy( json + at, opens[i], unit );
			at += unit;
		}
		json[at] = 0;
		size_t count = 0;
		uint8_t* bytes = testPackGlb( json, NULL, 0, &count );
		toolGltf* gltf = NULL;
		toolError error = { { 0 } };
		assert_false( toolReadGlbBytes( bytes, count, "deep.glb", &gltf, &error ) );
		testIsMessage( "deep", "deep.glb", &error );
		assert_non_null( strstr( error.text, "too deep" ) );
		free( bytes );
		free( json );
	}
}

static void dataUsedTooOftenIsRefused( void** state )
{
	(void)state;
	// 200 primitives with the same 16 million vertices out of nothing
	char* json = calloc( 65536, 1 );
	assert_non_null( json );
	size_t at = (size_t)sprintf( json, "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[" );
	for ( int i = 0; i < 200; ++i )
	{
		at += (size_t)sprintf( json + at, "%s{\"attributes\":{\"POSITION\":0}}", i > 0 ? "," : "" );
	}
	sprintf( json + at,
	    "]}],\"accessors\":[{\"componentType\":5126,\"type\":\"VEC3\",\"count\":16000000,\"sparse\":{\"count\":0}}]}" );
	size_t count = 0;
	uint8_t* bytes = testPackGlb( json, NULL, 0, &count );
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	assert_false( toolReadGlbBytes( bytes, count, "much.glb", &gltf, &error ) );
	testIsMessage( "much", "much.glb", &error );
	assert_non_null( strstr( error.text, "so often" ) );
	free( bytes );
	free( json );
}

// ------------------------------------------------------------------------------------------------ bytes

/// Reads bytes in memory of exactly their size. @return whether they were read; a refusal must have its message
static bool testTryBytes( const char* what, const uint8_t* bytes, size_t count )
{
	uint8_t* exact = malloc( count > 0 ? count : 1 );
	assert_non_null( exact );
	memcpy( exact, bytes, count );
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	bool good = toolReadGlbBytes( exact, count, "try.glb", &gltf, &error );
	free( exact );
	if ( good == false )
	{
		assert_null( gltf );
		testIsMessage( what, "try.glb", &error );
	}
	toolFreeGltf( gltf );
	return good;
}

static void cutFilesAreRefused( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	size_t jsonEnd = 20 + ( ( strlen( leg.json ) + 3 ) & ~(size_t)3 );
	const size_t edges[] = { 0, 1, 3, 4, 8, 11, 12, 16, 19, 20, 21, jsonEnd - 1, jsonEnd, jsonEnd + 1, jsonEnd + 4,
		jsonEnd + 8, jsonEnd + 9, count - 1 };
	uint32_t seed = 7;
	for ( size_t i = 0; i < sizeof edges / sizeof edges[0] + 64; ++i )
	{
		size_t cut = i < sizeof edges / sizeof edges[0] ? edges[i] : testRandom( &seed ) % count;
		assert_false( testTryBytes( "cut", bytes, cut ) );
		// and with a header that says so
		uint8_t header[4];
		memcpy( header, bytes + 8, 4 );
		testPutU32( bytes + 8, cut );
		assert_false( testTryBytes( "cut, length mended", bytes, cut ) );
		memcpy( bytes + 8, header, 4 );
	}
	free( bytes );
}

static void badHeadersAreRefused( void** state )
{
	(void)state;
	const struct
	{
		size_t at;
		uint32_t value;
	} bad[] = { { 0, 0x46546c68 }, { 4, 1 }, { 4, 3 }, { 8, 0 }, { 8, 0xffffffffu }, { 12, 0xffffffffu }, { 12, 0 },
		{ 12, 0x7ffffff0 }, { 16, 0x004e4942 }, { 16, 0 } };
	testParts leg = testMakeLeg();
	for ( size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i )
	{
		size_t count = 0;
		uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
		testPutU32( bytes + bad[i].at, bad[i].value );
		assert_false( testTryBytes( "header", bytes, count ) );
		free( bytes );
	}
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	size_t bin = count - test_legBinCount - 8;
	testPutU32( bytes + bin, test_legBinCount + 4 );
	assert_false( testTryBytes( "BIN longer than the file", bytes, count ) );
	testPutU32( bytes + bin, test_legBinCount );
	testPutU32( bytes + bin + 4, 0x12345678 );
	assert_false( testTryBytes( "BIN by another name", bytes, count ) );
	free( bytes );
}

static void noSingleChangedByteDoesHarm( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	const uint8_t values[] = { 0x00, 0xff, '"', '}', '9' };
	for ( size_t i = 0; i < count; ++i )
	{
		uint8_t old = bytes[i];
		bytes[i] = (uint8_t)( old ^ 1u << ( i % 8 ) );
		testTryBytes( "flip", bytes, count );
		bytes[i] = values[i % 5];
		testTryBytes( "change", bytes, count );
		bytes[i] = old;
	}
	assert_true( testTryBytes( "unchanged", bytes, count ) );
	free( bytes );
}

static void whatCanBeReadCanBeWrittenAndAppendedTo( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	uint32_t seed = 99;
	for ( int i = 0; i < 200; ++i )
	{
		uint8_t* changed = malloc( count );
		assert_non_null( changed );
		memcpy( changed, bytes, count );
		for ( int j = 0; j < 3; ++j )
		{
			size_t at = 20 + testRandom( &seed ) % ( count - 20 );
			changed[at] = j == 0 ? (uint8_t)( '0' + testRandom( &seed ) % 10 ) : changed[at];
			changed[at] = (uint8_t)( j > 0 && testRandom( &seed ) % 4 == 0 ? ' ' : changed[at] );
		}
		toolGltf* gltf = NULL;
		toolError error = { { 0 } };
		if ( toolReadGlbBytes( changed, count, "try.glb", &gltf, &error ) )
		{
			const toolModel* model = toolGltf_GetModel( gltf );
			toolGltf* made = toolMakeGltf( model );
			toolFreeGltf( made );
			if ( model->clipCount > 0 && toolGltf_AppendClip( gltf, model->clips, &error ) )
			{
				assert_true( toolWriteGltf( gltf, TEMP( "changed.glb" ), &error ) );
				toolFreeGltf( testOpenFile( TEMP( "changed.glb" ) ) );
			}
		}
		toolFreeGltf( gltf );
		free( changed );
	}
	free( bytes );
}

// ------------------------------------------------------------------------------------------------ files

static void testFileIsRefused( const char* path, const char* says )
{
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	assert_false( toolReadGltf( path, &gltf, &error ) );
	assert_null( gltf );
	testIsMessage( path, path, &error );
	if ( strstr( error.text, says ) == NULL )
	{
		fail_msg( "says %s", error.text );
	}
}

static void pathsThatAreNoGltfFilesAreRefused( void** state )
{
	(void)state;
	testFileIsRefused( TEMP( "" ), "not a file" );
	testFileIsRefused( TEMP( "not there.glb" ), "cannot be read" );
	testWriteBytes( TEMP( "empty.glb" ), "", 0 );
	testFileIsRefused( TEMP( "empty.glb" ), "not a GLB" );
	const char text[] = "hello, this is no model at all";
	testWriteBytes( TEMP( "text.glb" ), text, strlen( text ) );
	testFileIsRefused( TEMP( "text.glb" ), "not a GLB" );
	testWriteBytes( TEMP( "half.gltf" ), "{\"asset\":", 9 );
	testFileIsRefused( TEMP( "half.gltf" ), "ends early" );
	const char loop[] = "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\".\",\"byteLength\":1}]}";
	testWriteBytes( TEMP( "folder.gltf" ), loop, strlen( loop ) );
	testFileIsRefused( TEMP( "folder.gltf" ), "cannot be read" );
	const char cut[] = "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"uri\":\"cut.bin\",\"byteLength\":9}]}";
	testWriteBytes( TEMP( "cut.bin" ), "12345678", 8 );
	testWriteBytes( TEMP( "cut.gltf" ), cut, strlen( cut ) );
	testFileIsRefused( TEMP( "cut.gltf" ), "8 bytes where its byteLength says 9" );
}

static int testCountFiles( const char* folder )
{
	int count = 0;
	DIR* open = opendir( folder );
	assert_non_null( open );
	for ( struct dirent* file = readdir( open ); file != NULL; file = readdir( open ) )
	{
		++count;
	}
	closedir( open );
	return count;
}

static void failedWritesLeaveNothingBehind( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	toolError error = { { 0 } };
	char folder[1024];
	snprintf( folder, sizeof folder, "%s", TEMP( "taken" ) );
	mkdir( folder, 0777 );
	mkdir( TEMP( "taken/a.glb" ), 0777 );
	mkdir( TEMP( "taken/b.gltf" ), 0777 );
	int before = testCountFiles( folder );
	assert_false( toolWriteGltf( gltf, TEMP( "taken/a.glb" ), &error ) );
	testIsMessage( "folder", TEMP( "taken/a.glb" ), &error );
	assert_false( toolWriteGltf( gltf, TEMP( "taken/b.gltf" ), &error ) );
	testIsMessage( "folder", TEMP( "taken/b.gltf" ), &error );
	assert_false( toolWriteGltf( gltf, TEMP( "taken/none/c.glb" ), &error ) );
	testIsMessage( "no folder", TEMP( "taken/none/c.glb" ), &error );
	assert_int_equal( testCountFiles( folder ), before );
	toolFreeGltf( gltf );
}

// ------------------------------------------------------------------------------------------------ grounds

static void badObjFilesAreRefused( void** state )
{
	(void)state;
	const struct
	{
		const char* text;
		const char* says;
	} bad[] = {
		{ "", "no triangles" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\n", "no triangles" },
		{ "v 0 0\n", "line 1" },
		{ "v 0 0 nan\n", "line 1" },
		{ "v 0 0 inf\n", "line 1" },
		{ "v 0 0 1e999\n", "line 1" },
		{ "v 0 0 0x10\n", "line 1" },
		{ "v 0 0 1,5\n", "line 1" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 4\n", "line 4: a face names vertex 4 of 3" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\n\\\n\nf 1 2 -4\n", "line 6: a face names vertex -4 of 3" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 0 1 2\n", "vertex 0" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 99999999999999999999\n", "line 4" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 -99999999999999999999\n", "line 4" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 x\n", "line 4: a corner" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3x\n", "line 4: a corner" },
		{ "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2\n", "fewer than three" },
		{ "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 0 1\n", "line 1" },
	};
	for ( size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i )
	{
		toolGroundMesh ground;
		toolError error = { { 0 } };
		size_t count = strlen( bad[i].text );
		uint8_t* exact = malloc( count > 0 ? count : 1 ); // nothing behind its end
		assert_non_null( exact );
		memcpy( exact, bad[i].text, count );
		if ( toolReadObjBytes( exact, count, "bad.obj", &ground, &error ) )
		{
			fail_msg( "was read: %s", bad[i].text );
		}
		free( exact );
		testIsMessage( bad[i].text, "bad.obj", &error );
		if ( strstr( error.text, bad[i].says ) == NULL )
		{
			fail_msg( "%s: says %s", bad[i].text, error.text );
		}
		assert_null( ground.positions );
	}
	toolGroundMesh ground;
	toolError error = { { 0 } };
	assert_false( toolReadObjBytes( (const uint8_t*)"v 0 \0 0", 7, "bad.obj", &ground, &error ) );
	testIsMessage( "zero", "bad.obj", &error );
}

static void testGroundIsRefused( testParts* parts, float scale, const char* says )
{
	size_t count = 0;
	uint8_t* bytes = testPackGlb( parts->json, parts->bin, parts->binCount, &count );
	const char* path = TEMP( "ground.glb" );
	testWriteBytes( path, bytes, count );
	free( bytes );
	toolGroundMesh ground;
	toolError error = { { 0 } };
	assert_false( toolReadGround( path, scale, &ground, &error ) );
	testIsMessage( says, path, &error );
	if ( strstr( error.text, says ) == NULL )
	{
		fail_msg( "says %s", error.text );
	}
	assert_null( ground.positions );
}

static void badGroundsAreRefused( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"mesh\":0,", "" );
	testGroundIsRefused( &leg, 1, "no triangles" );
	leg = testMakeLeg();
	testReplace( &leg, "\"mode\":4", "\"mode\":1" );
	testGroundIsRefused( &leg, 1, "no triangles" );
	leg = testMakeLeg();
	testReplace( &leg, "\"mesh\":0,\"skin\":0", "\"mesh\":0,\"scale\":[3e38,1,1],\"translation\":[3e38,0,0]" );
	testGroundIsRefused( &leg, 1, "where no number reaches" );
	leg = testMakeLeg();
	testGroundIsRefused( &leg, NAN, "scale" );
	testGroundIsRefused( &leg, 0, "scale" );
	toolGroundMesh ground;
	toolError error = { { 0 } };
	assert_false( toolReadGround( TEMP( "" ), 1, &ground, &error ) );
	testIsMessage( "folder", TEMP( "" ), &error );
	const char far[] = "v 1e38 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
	testWriteBytes( TEMP( "far.obj" ), far, strlen( far ) );
	assert_false( toolReadGround( TEMP( "far.obj" ), 100, &ground, &error ) );
	testIsMessage( "far", TEMP( "far.obj" ), &error );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyBadTextIsRefused ),
		cmocka_unit_test( badNumbersInTheDataAreRefused ),
		cmocka_unit_test( deepNestingIsRefused ),
		cmocka_unit_test( dataUsedTooOftenIsRefused ),
		cmocka_unit_test( cutFilesAreRefused ),
		cmocka_unit_test( badHeadersAreRefused ),
		cmocka_unit_test( noSingleChangedByteDoesHarm ),
		cmocka_unit_test( whatCanBeReadCanBeWrittenAndAppendedTo ),
		cmocka_unit_test( pathsThatAreNoGltfFilesAreRefused ),
		cmocka_unit_test( failedWritesLeaveNothingBehind ),
		cmocka_unit_test( badObjFilesAreRefused ),
		cmocka_unit_test( badGroundsAreRefused ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
