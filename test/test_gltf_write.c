// SPDX-License-Identifier: MIT
// Writing glTF files: what was not touched stays byte for byte, what was added reads back.
#define _POSIX_C_SOURCE 200809L
#include "glb_maker.h"

#include "json_splice.h"

#include <dirent.h>

#define TEMP( name ) testTempPath( "test_gltf_write", name )

/// Calls back for every .glb and .vrm of the real data. @return how many there were
static int testForEachCharacter( void ( *check )( const char* path ) )
{
	int count = 0;
	DIR* top = opendir( SOLE_DATA_DIR );
	if ( top == NULL )
	{
		return 0;
	}
	for ( struct dirent* folder = readdir( top ); folder != NULL; folder = readdir( top ) )
	{
		char path[1024];
		snprintf( path, sizeof path, "%s/%s", SOLE_DATA_DIR, folder->d_name );
		DIR* inner = folder->d_name[0] != '.' ? opendir( path ) : NULL;
		for ( struct dirent* file = inner != NULL ? readdir( inner ) : NULL; file != NULL; file = readdir( inner ) )
		{
			const char* dot = strrchr( file->d_name, '.' );
			if ( dot != NULL && ( strcmp( dot, ".glb" ) == 0 || strcmp( dot, ".vrm" ) == 0 ) )
			{
				char whole[2048];
				snprintf( whole, sizeof whole, "%s/%s", path, file->d_name );
				check( whole );
				++count;
			}
		}
		if ( inner != NULL )
		{
			closedir( inner );
		}
	}
	closedir( top );
	return count;
}

static bool testIsPacked( const char* path )
{
	return strstr( path, "testMap.glb" ) != NULL; // Draco
}

// ------------------------------------------------------------------------------------------------ identity

static void checkIdentity( const char* path )
{
	if ( testIsPacked( path ) )
	{
		toolGltf* gltf = NULL;
		toolError error;
		assert_false( toolReadGltf( path, &gltf, &error ) );
		assert_non_null( strstr( error.text, "KHR_draco_mesh_compression" ) );
		return;
	}
	toolGltf* gltf = testOpenFile( path );
	toolError error;
	assert_true( toolWriteGltf( gltf, TEMP( "same.glb" ), &error ) );
	testSameFile( path, TEMP( "same.glb" ) );
	toolFreeGltf( gltf );
}

static void untouchedFilesComeOutByteForByte( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "README.md" );
	assert_true( testForEachCharacter( checkIdentity ) >= 20 );
}

static void unknownChunksAndOddPaddingStay( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	size_t count = 0;
	uint8_t* bytes = testPackGlb( leg.json, leg.bin, leg.binCount, &count );
	uint8_t more[4096 + 64] = { 0 };
	assert_true( count + 8 + 5 + 8 + 4 + 2 <= sizeof more );
	memcpy( more, bytes, count );
	size_t at = count;
	testPutU32( more + at, 5 ); // a length that is no multiple of 4
	memcpy( more + at + 4, "ODD!hello", 9 );
	at += 13;
	testPutU32( more + at, 4 );
	memcpy( more + at + 4, "MORErest", 8 );
	at += 12 + 2; // two zeros behind the last chunk
	testPutU32( more + 8, at );
	toolGltf* gltf = NULL;
	toolError error;
	testWriteBytes( TEMP( "odd.glb" ), more, at );
	assert_true( toolReadGltf( TEMP( "odd.glb" ), &gltf, &error ) );
	assert_true( toolWriteGltf( gltf, TEMP( "odd_same.glb" ), &error ) );
	testSameFile( TEMP( "odd.glb" ), TEMP( "odd_same.glb" ) );
	// and behind an appended clip
	assert_true( toolGltf_AppendClip( gltf, toolGltf_GetModel( gltf )->clips, &error ) );
	assert_true( toolWriteGltf( gltf, TEMP( "odd_more.glb" ), &error ) );
	size_t newCount = 0;
	uint8_t* written = testReadBytes( TEMP( "odd_more.glb" ), &newCount );
	assert_memory_equal( written + newCount - 25, more + count, 25 );
	free( written );
	free( bytes );
	toolFreeGltf( gltf );
}

/// Whether all bytes of a text come in another in the same order. Zero bytes may be left out.
static bool testIsWithin( const char* text, size_t count, const char* within, size_t withinCount )
{
	size_t at = 0;
	for ( size_t i = 0; i < count; ++i )
	{
		while ( at < withinCount && within[at] != text[i] )
		{
			++at;
		}
		if ( at == withinCount )
		{
			return false;
		}
		++at;
	}
	return true;
}

/// The digits of buffers[0].byteLength may change and are taken out; so is padding.
static size_t testTakeOutLength( char* json, size_t count )
{
	toolJsonSummary summary;
	assert_true( toolCheckJson( json, count, &summary ) );
	toolJsonRange range;
	assert_true( toolFindJsonMember( json, summary.root, "buffers", &range ) );
	assert_true( toolFindJsonItem( json, range, 0, &range ) );
	assert_true( toolFindJsonMember( json, range, "byteLength", &range ) );
	memmove( json + range.begin, json + range.end, summary.root.end - range.end );
	return summary.root.end - ( range.end - range.begin );
}

static void testOldBytesStay( const char* before, const char* after )
{
	size_t oldCount = 0;
	size_t newCount = 0;
	uint8_t* old = testReadBytes( before, &oldCount );
	uint8_t* now = testReadBytes( after, &newCount );
	assert_int_equal( testU32( now + 8 ), newCount );
	size_t oldJson = testU32( old + 12 );
	size_t newJson = testU32( now + 12 );
	assert_int_equal( newJson % 4, 0 );
	size_t oldBin = testU32( old + 20 + oldJson );
	assert_true( testU32( now + 20 + newJson ) >= oldBin );
	assert_memory_equal( old + 28 + oldJson, now + 28 + newJson, oldBin );
	size_t count = testTakeOutLength( (char*)old + 20, oldJson );
	assert_true( testIsWithin( (const char*)old + 20, count, (const char*)now + 20, newJson ) );
	free( old );
	free( now );
}

static void checkAppend( const char* path )
{
	if ( testIsPacked( path ) )
	{
		return;
	}
	toolGltf* gltf = testOpenFile( path );
	const toolModel* model = toolGltf_GetModel( gltf );
	toolGltf* untouched = testOpenFile( path );
	const toolModel* before = toolGltf_GetModel( untouched );
	if ( before->clipCount > 0 )
	{
		toolClip clip = before->clips[before->clipCount - 1];
		clip.name = "new \"clip\"|sole";
		clip.extras = "{\"sole\":{\"method\":\"sole\",\"list\":[1,2.5]}}";
		toolError error;
		assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
		assert_int_equal( model->clipCount, before->clipCount + 1 );
		testSameClip( model->clips + before->clipCount, &clip );
		assert_true( toolWriteGltf( gltf, TEMP( "more.glb" ), &error ) );
		testOldBytesStay( path, TEMP( "more.glb" ) );
		toolGltf* again = testOpenFile( TEMP( "more.glb" ) );
		const toolModel* after = toolGltf_GetModel( again );
		assert_int_equal( after->clipCount, before->clipCount + 1 );
		for ( int32_t i = 0; i < before->clipCount; ++i )
		{
			testSameClip( after->clips + i, before->clips + i );
		}
		testSameClip( after->clips + before->clipCount, &clip );
		assert_int_equal( after->nodeCount, before->nodeCount );
		testSameNodes( after, before, before->nodeCount );
		toolFreeGltf( again );
	}
	toolFreeGltf( untouched );
	toolFreeGltf( gltf );
}

static void appendedClipReadsBackAndAllElseStays( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "README.md" );
	assert_true( testForEachCharacter( checkAppend ) >= 20 );
}

static void madeFilesReadBack( const char* path )
{
	if ( testIsPacked( path ) )
	{
		return;
	}
	toolGltf* gltf = testOpenFile( path );
	const toolModel* model = toolGltf_GetModel( gltf );
	toolGltf* made = toolMakeGltf( model );
	assert_non_null( made );
	toolError error;
	assert_true( toolWriteGltf( made, TEMP( "made.glb" ), &error ) );
	toolGltf* again = testOpenFile( TEMP( "made.glb" ) );
	const toolModel* after = toolGltf_GetModel( again );
	assert_int_equal( after->nodeCount, model->nodeCount );
	assert_int_equal( after->clipCount, model->clipCount );
	assert_int_equal( after->skinCount, model->skinCount );
	assert_int_equal( after->meshCount, model->meshCount );
	assert_int_equal( after->materialCount, model->materialCount );
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		testSameClip( after->clips + i, model->clips + i );
	}
	for ( int32_t i = 0; i < model->skinCount; ++i )
	{
		size_t count = (size_t)model->skins[i].jointCount;
		assert_int_equal( after->skins[i].jointCount, count );
		assert_memory_equal( after->skins[i].joints, model->skins[i].joints, count * sizeof( int32_t ) );
		assert_memory_equal( after->skins[i].inverseBind, model->skins[i].inverseBind, count * 64 );
	}
	for ( int32_t i = 0; i < model->meshCount; ++i )
	{
		assert_int_equal( after->meshes[i].primitiveCount, model->meshes[i].primitiveCount );
		for ( int32_t j = 0; j < model->meshes[i].primitiveCount; ++j )
		{
			const toolPrimitive* x = model->meshes[i].primitives + j;
			const toolPrimitive* y = after->meshes[i].primitives + j;
			assert_int_equal( x->vertexCount, y->vertexCount );
			assert_int_equal( x->indexCount, y->indexCount );
			assert_memory_equal( x->positions, y->positions, (size_t)x->vertexCount * 12 );
			assert_memory_equal( x->indices, y->indices, (size_t)x->indexCount * 4 );
		}
	}
	toolFreeGltf( again );
	toolFreeGltf( made );
	toolFreeGltf( gltf );
}

static void madeFileHasWhatTheModelHas( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "README.md" );
	assert_true( testForEachCharacter( madeFilesReadBack ) >= 20 );
}

// ------------------------------------------------------------------------------------------------ appending

static void channelsWithEqualTimesShareThem( void** state )
{
	(void)state;
	toolModel model = { .nodeCount = 1 };
	toolNode node = {
		.name = "n", .parent = SOLE_NONE, .local = soleTransform_Identity(), .mesh = SOLE_NONE, .skin = SOLE_NONE
	};
	model.nodes = &node;
	toolGltf* gltf = toolMakeGltf( &model );
	assert_non_null( gltf );
	float times[2] = { 0, 1 };
	float same[2] = { 0, 1 };
	float other[2] = { 0, 2 };
	float values[8] = { 0, 0, 0, 1, 0, 0, 0, 1 };
	toolChannel channels[3] = { { 0, tool_pathTranslation, tool_linear, 2, times, values },
		{ 0, tool_pathRotation, tool_linear, 2, same, values }, { 0, tool_pathScale, tool_step, 2, other, values } };
	toolClip clip = { .name = "c", .channelCount = 3, .channels = channels, .end = 2 };
	toolError error;
	assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
	assert_true( toolWriteGltf( gltf, TEMP( "shared.gltf" ), &error ) );
	size_t count = 0;
	uint8_t* text = testReadBytes( TEMP( "shared.gltf" ), &count );
	int scalars = 0;
	for ( size_t i = 0; i + 6 <= count; ++i )
	{
		scalars += memcmp( text + i, "SCALAR", 6 ) == 0 ? 1 : 0;
	}
	assert_int_equal( scalars, 2 );
	free( text );
	toolGltf* again = testOpenFile( TEMP( "shared.gltf" ) );
	testSameClip( toolGltf_GetModel( again )->clips, &clip );
	toolFreeGltf( again );
	toolFreeGltf( gltf );
}

static void badClipsAreNotAppended( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	float times[2] = { 0, 0 };
	float values[8] = { 0 };
	toolChannel channel = { 0, tool_pathTranslation, tool_linear, 2, times, values };
	toolClip clip = { .name = "c", .channelCount = 1, .channels = &channel };
	toolError error;
	assert_false( toolGltf_AppendClip( gltf, &clip, &error ) ); // times do not ascend
	times[1] = 1;
	values[3] = NAN;
	assert_false( toolGltf_AppendClip( gltf, &clip, &error ) );
	values[3] = 0;
	channel.node = 3;
	assert_false( toolGltf_AppendClip( gltf, &clip, &error ) );
	channel.node = 0;
	clip.extras = "[1]";
	assert_false( toolGltf_AppendClip( gltf, &clip, &error ) );
	clip.extras = "{} ,\"x\":1";
	assert_false( toolGltf_AppendClip( gltf, &clip, &error ) );
	clip.extras = NULL;
	assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
	assert_int_equal( toolGltf_GetModel( gltf )->clipCount, 2 );
	toolFreeGltf( gltf );
}

static void whatWasTakenFromTheModelStaysGood( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	const toolClip* clip = toolGltf_GetModel( gltf )->clips;
	const char* name = toolGltf_GetModel( gltf )->nodes[0].name;
	testParts other = testMakeLeg();
	toolGltf* scene = testOpenParts( &other );
	toolError error;
	for ( int i = 0; i < 20; ++i )
	{
		assert_true( toolGltf_AppendClip( gltf, clip, &error ) );
	}
	assert_true( toolGltf_AppendScene( gltf, toolGltf_GetModel( scene ), &error ) );
	assert_int_equal( toolGltf_GetModel( gltf )->clipCount, 21 );
	testSameClip( clip, toolGltf_GetModel( gltf )->clips + 20 );
	assert_string_equal( name, "hip" );
	toolFreeGltf( scene );
	toolFreeGltf( gltf );
}

static void appendedSceneIsShownBesideTheOldOne( void** state )
{
	(void)state;
	const char* scenes[] = { "\"scene\":0,\"scenes\":[{\"nodes\":[0,2]}],",
		"\"scene\":1,\"scenes\":[{\"nodes\":[0]},{ }],", "\"scenes\":[{\"nodes\" : [ ] , \"name\":\"x\"}],", "" };
	const int32_t shown[] = { 4, 2, 2, 4 }; // roots after appending two
	for ( int i = 0; i < 4; ++i )
	{
		testParts leg = testMakeLeg();
		testReplace( &leg, scenes[0], scenes[i] );
		toolGltf* gltf = testOpenParts( &leg );
		testParts other = testMakeLeg();
		toolGltf* scene = testOpenParts( &other );
		toolError error;
		assert_true( toolGltf_AppendScene( gltf, toolGltf_GetModel( scene ), &error ) );
		const toolModel* model = toolGltf_GetModel( gltf );
		assert_int_equal( model->nodeCount, 6 );
		assert_int_equal( model->nodes[4].parent, 3 );
		assert_int_equal( model->nodes[5].mesh, 1 );
		assert_int_equal( model->nodes[5].skin, SOLE_NONE );
		assert_int_equal( model->meshes[1].primitives[0].material, 1 );
		assert_int_equal( model->meshes[1].primitives[0].influences, 0 );
		assert_true( toolWriteGltf( gltf, TEMP( "scene.gltf" ), &error ) );
		size_t count = 0;
		uint8_t* text = testReadBytes( TEMP( "scene.gltf" ), &count );
		toolJsonSummary summary;
		assert_true( toolCheckJson( (char*)text, count, &summary ) );
		toolJsonRange range;
		assert_true( toolFindJsonMember( (char*)text, summary.root, "scenes", &range ) );
		assert_true( toolFindJsonItem( (char*)text, range, i == 1 ? 1 : 0, &range ) );
		assert_true( toolFindJsonMember( (char*)text, range, "nodes", &range ) );
		assert_int_equal( toolCountJsonItems( (char*)text, range ), shown[i] );
		free( text );
		toolFreeGltf( scene );
		toolFreeGltf( gltf );
	}
}

static void appendingCopesWithAnyLayoutOfTheJson( void** state )
{
	(void)state;
	const char* heads[] = { "", "\"animations\" : [ ] ,", "\"\\u0061nimations\":[\n],", "\"animations\":null,",
		"\"extras\":{\"animations\":[],\"a\":\"]}\\\"[{\"}," };
	for ( size_t i = 0; i < sizeof heads / sizeof heads[0]; ++i )
	{
		char json[512];
		snprintf(
		    json, sizeof json, " {\t%s\"nodes\":[{\"name\":\"a\"}], \"asset\" :{\"version\":\"2.0\"} \n}\n", heads[i] );
		size_t count = 0;
		uint8_t* bytes = testPackGlb( json, NULL, 0, &count ); // without BIN
		toolGltf* gltf = NULL;
		toolError error;
		assert_true( toolReadGlbBytes( bytes, count, "a.glb", &gltf, &error ) );
		free( bytes );
		float times[1] = { 0 };
		float values[3] = { 1, 2, 3 };
		toolChannel channel = { 0, tool_pathTranslation, tool_linear, 1, times, values };
		toolClip clip = { .name = "c\n\"\\\x01\xc3\xa9", .channelCount = 1, .channels = &channel };
		assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
		assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
		assert_true( toolWriteGltf( gltf, TEMP( "layout.glb" ), &error ) );
		toolGltf* again = testOpenFile( TEMP( "layout.glb" ) );
		assert_int_equal( toolGltf_GetModel( again )->clipCount, 2 );
		testSameClip( toolGltf_GetModel( again )->clips + 1, &clip );
		toolFreeGltf( again );
		toolFreeGltf( gltf );
	}
}

static void madeWeightsSumToOneAndUnusedJointsAreZero( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	toolPrimitive* primitive = toolGltf_GetModel( gltf )->meshes[0].primitives;
	const float weights[16] = { 2, 0, 0, 0, 0, 0, 0, 0, 0.3f, 0.3f, 0.1f, 0, 0.25f, 0.25f, 0.25f, 0.1f };
	const uint16_t joints[16] = { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 0, 1, 0, 1 };
	memcpy( primitive->weights, weights, sizeof weights );
	memcpy( primitive->joints, joints, sizeof joints );
	toolGltf* made = toolMakeGltf( toolGltf_GetModel( gltf ) );
	assert_non_null( made );
	const toolPrimitive* clean = toolGltf_GetModel( made )->meshes[0].primitives;
	for ( int i = 0; i < 4; ++i )
	{
		double sum = 0;
		for ( int j = 0; j < 4; ++j )
		{
			sum += (double)clean->weights[4 * i + j];
			assert_true( clean->weights[4 * i + j] > 0 || clean->joints[4 * i + j] == 0 );
			for ( int k = 0; k < j; ++k )
			{
				assert_true( clean->weights[4 * i + j] == 0 || clean->weights[4 * i + k] == 0 ||
				    clean->joints[4 * i + j] != clean->joints[4 * i + k] );
			}
		}
		assert_true( sum > 1 - 1e-7 && sum < 1 + 1e-7 );
	}
	assert_int_equal( toolGltf_GetModel( made )->nodes[2].parent, SOLE_NONE );
	toolFreeGltf( made );
	toolFreeGltf( gltf );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( untouchedFilesComeOutByteForByte ),
		cmocka_unit_test( unknownChunksAndOddPaddingStay ),
		cmocka_unit_test( appendedClipReadsBackAndAllElseStays ),
		cmocka_unit_test( madeFileHasWhatTheModelHas ),
		cmocka_unit_test( channelsWithEqualTimesShareThem ),
		cmocka_unit_test( badClipsAreNotAppended ),
		cmocka_unit_test( whatWasTakenFromTheModelStaysGood ),
		cmocka_unit_test( appendedSceneIsShownBesideTheOldOne ),
		cmocka_unit_test( appendingCopesWithAnyLayoutOfTheJson ),
		cmocka_unit_test( madeWeightsSumToOneAndUnusedJointsAreZero ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
