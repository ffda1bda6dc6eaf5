// SPDX-License-Identifier: MIT
// glTF files that are in order: what was read is what is there, and what was not touched stays byte for byte.
#define _POSIX_C_SOURCE 200809L
#include "glb_maker.h"

#include "json_splice.h"

#include <dirent.h>

#define TEMP( name ) testTempPath( "test_gltf", name )

static uint32_t testU32( const uint8_t* bytes )
{
	return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

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

static void testSameFile( const char* a, const char* b )
{
	size_t countA = 0;
	size_t countB = 0;
	uint8_t* bytesA = testReadBytes( a, &countA );
	uint8_t* bytesB = testReadBytes( b, &countB );
	assert_int_equal( countA, countB );
	assert_memory_equal( bytesA, bytesB, countA );
	free( bytesA );
	free( bytesB );
}

static void testSameClip( const toolClip* a, const toolClip* b )
{
	assert_string_equal( a->name, b->name );
	assert_int_equal( a->channelCount, b->channelCount );
	assert_true( a->start == b->start && a->end == b->end );
	assert_true( ( a->extras == NULL ) == ( b->extras == NULL ) );
	if ( a->extras != NULL )
	{
		assert_string_equal( a->extras, b->extras );
	}
	for ( int32_t i = 0; i < a->channelCount; ++i )
	{
		const toolChannel* x = a->channels + i;
		const toolChannel* y = b->channels + i;
		assert_int_equal( x->node, y->node );
		assert_int_equal( x->path, y->path );
		assert_int_equal( x->interpolation, y->interpolation );
		assert_int_equal( x->keyCount, y->keyCount );
		size_t size = ( x->path == tool_pathRotation ? 4u : 3u ) * ( x->interpolation == tool_cubic ? 3u : 1u );
		assert_memory_equal( x->times, y->times, (size_t)x->keyCount * sizeof( float ) );
		assert_memory_equal( x->values, y->values, (size_t)x->keyCount * size * sizeof( float ) );
	}
}

static void testSameNodes( const toolModel* a, const toolModel* b, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		assert_string_equal( a->nodes[i].name, b->nodes[i].name );
		assert_int_equal( a->nodes[i].parent, b->nodes[i].parent );
		assert_int_equal( a->nodes[i].mesh, b->nodes[i].mesh );
		assert_int_equal( a->nodes[i].skin, b->nodes[i].skin );
		assert_memory_equal( &a->nodes[i].local, &b->nodes[i].local, sizeof( soleTransform ) );
	}
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

// ------------------------------------------------------------------------------------------------ reading

static void smallFileReadsAsMeant( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	const toolModel* model = toolGltf_GetModel( gltf );
	assert_int_equal( model->nodeCount, 3 );
	assert_int_equal( model->nodes[1].parent, 0 );
	assert_int_equal( model->nodes[0].parent, SOLE_NONE );
	assert_int_equal( toolFindNode( model, "knee" ), 1 );
	testNear3( model->nodes[1].local.translation, soleVec( 0, 1, 0 ), 0 );
	assert_int_equal( model->skins[0].jointCount, 2 );
	const toolPrimitive* primitive = model->meshes[0].primitives;
	assert_int_equal( primitive->vertexCount, 4 );
	assert_int_equal( primitive->indexCount, 6 );
	assert_int_equal( primitive->indices[5], 3 );
	assert_int_equal( primitive->influences, 4 );
	assert_int_equal( primitive->joints[13], 1 );
	assert_float_equal( primitive->weights[13], 0.75f, 0 );
	assert_float_equal( model->materials[0].color[1], 0.5f, 0 );
	assert_float_equal( model->clips[0].start, 0.5f, 0 );
	assert_float_equal( model->clips[0].end, 2.0f, 0 );
	assert_string_equal( model->clips[0].extras, "{\"source\":\"test\"}" );
	toolFreeGltf( gltf );
}

static void sparseAccessorWithoutViewIsZeroButForItsValues( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	const float wanted[12] = { 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
	assert_memory_equal( toolGltf_GetModel( gltf )->meshes[0].primitives[0].normals, wanted, sizeof wanted );
	toolFreeGltf( gltf );
}

static void sparseAccessorChangesSomeOfItsView( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "{\"componentType\":5126,\"count\":4", "{\"bufferView\":0,\"componentType\":5126,\"count\":4" );
	toolGltf* gltf = testOpenParts( &leg );
	const float wanted[12] = { 0, 0, 0, 0, 0, 1, 1, 2, 0, 0, 1, 0 };
	assert_memory_equal( toolGltf_GetModel( gltf )->meshes[0].primitives[0].normals, wanted, sizeof wanted );
	toolFreeGltf( gltf );
}

static void normalizedIntegersBecomeFractions( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* gltf = testOpenParts( &leg );
	const float* values = toolGltf_GetModel( gltf )->clips[0].channels[1].values;
	const float wanted[12] = { 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, -1, 0 }; // -32768 is -1 as well
	assert_memory_equal( values, wanted, sizeof wanted );
	toolFreeGltf( gltf );
}

static void weightsMayBeBytesAndPositionsShorts( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	const uint8_t weights[16] = { 255, 0, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 51, 204, 0, 0 };
	memcpy( leg.bin + test_atWeights, weights, sizeof weights );
	testReplace( &leg, "{\"bufferView\":2,\"componentType\":5126,",
	    "{\"bufferView\":2,\"componentType\":5121,\"normalized\":true," );
	const int8_t positions[16] = { 1, 2, 3, 0, -4, 5, 6, 0, 7, 8, -128, 0, 1, 1, 1, 0 };
	memcpy( leg.bin + test_atPositions, positions, sizeof positions );
	testReplace( &leg, "{\"bufferView\":0,\"componentType\":5126,", "{\"bufferView\":0,\"componentType\":5120," );
	testReplace( &leg, "\"byteOffset\":0,\"byteLength\":48", "\"byteOffset\":0,\"byteLength\":48,\"byteStride\":4" );
	toolGltf* gltf = testOpenParts( &leg );
	const toolPrimitive* primitive = toolGltf_GetModel( gltf )->meshes[0].primitives;
	assert_float_equal( primitive->weights[12], 0.2f, 1e-6f );
	assert_float_equal( primitive->weights[13], 0.8f, 1e-6f );
	assert_float_equal( primitive->positions[3], -4.0f, 0 );
	assert_float_equal( primitive->positions[8], -128.0f, 0 );
	toolFreeGltf( gltf );
}

static void interleavedViewsAreReadByTheirStride( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	// times are the z of the translations
	testReplace( &leg, "{\"bufferView\":4,\"componentType\":5126,",
	    "{\"bufferView\":5,\"byteOffset\":8,\"componentType\":5126," );
	testReplace(
	    &leg, "\"byteOffset\":152,\"byteLength\":36", "\"byteOffset\":152,\"byteLength\":36,\"byteStride\":12" );
	toolGltf* gltf = testOpenParts( &leg );
	const float wanted[3] = { 0, 1, 2 };
	assert_memory_equal( toolGltf_GetModel( gltf )->clips[0].channels[0].times, wanted, sizeof wanted );
	toolFreeGltf( gltf );
}

static void stepAndCubicKeepTheirKind( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "{\"input\":4,\"output\":8}", "{\"input\":4,\"output\":8,\"interpolation\":\"STEP\"}" );
	testReplace( &leg, "{\"input\":4,\"output\":5}", "{\"input\":9,\"output\":5,\"interpolation\":\"CUBICSPLINE\"}" );
	testReplace( &leg, "\"normalized\":true,\"count\":3,\"type\":\"VEC4\"}",
	    "\"normalized\":true,\"count\":3,\"type\":\"VEC4\"},"
	    "{\"bufferView\":4,\"componentType\":5126,\"count\":1,\"type\":\"SCALAR\"}" );
	toolGltf* gltf = testOpenParts( &leg );
	const toolModel* model = toolGltf_GetModel( gltf );
	assert_int_equal( model->clips[0].channels[0].interpolation, tool_cubic );
	assert_int_equal( model->clips[0].channels[0].keyCount, 1 );
	assert_float_equal( model->clips[0].channels[0].values[8], 2.0f, 0 );
	assert_int_equal( model->clips[0].channels[1].interpolation, tool_step );
	toolError error;
	toolClip clip = model->clips[0];
	assert_true( toolGltf_AppendClip( gltf, &clip, &error ) );
	assert_true( toolWriteGltf( gltf, TEMP( "kinds.glb" ), &error ) );
	toolGltf* again = testOpenFile( TEMP( "kinds.glb" ) );
	testSameClip( toolGltf_GetModel( again )->clips + 1, &clip );
	toolFreeGltf( again );
	toolFreeGltf( gltf );
}

static void weightAndNodelessChannelsAreLeftOut( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"path\":\"translation\"", "\"path\":\"weights\"" );
	toolGltf* gltf = testOpenParts( &leg );
	assert_int_equal( toolGltf_GetModel( gltf )->clips[0].channelCount, 1 );
	toolFreeGltf( gltf );
	leg = testMakeLeg();
	testReplace( &leg, "{\"node\":0,\"path\":\"translation\"}", "{\"path\":\"translation\"}" );
	gltf = testOpenParts( &leg );
	assert_int_equal( toolGltf_GetModel( gltf )->clips[0].channelCount, 1 );
	toolFreeGltf( gltf );
}

static void nodesWithoutNamesHaveEmptyOnes( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"name\":\"hip\",", "" );
	testReplace( &leg, "\"name\":\"wave\",", "" );
	toolGltf* gltf = testOpenParts( &leg );
	assert_string_equal( toolGltf_GetModel( gltf )->nodes[0].name, "" );
	assert_string_equal( toolGltf_GetModel( gltf )->clips[0].name, "" );
	toolFreeGltf( gltf );
}

static void matrixOfANodeIsTakenApart( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	// a quarter turn about z, scaled by 2, 3 and -4, moved
	testReplace( &leg, "\"translation\":[0,1,0]", "\"matrix\":[0,2,0,0,-3,0,0,0,0,0,-4,0,5,6,7,1]" );
	toolGltf* gltf = testOpenParts( &leg );
	const toolNode* node = toolGltf_GetModel( gltf )->nodes + 1;
	assert_true( node->hasMatrix );
	assert_false( toolGltf_GetModel( gltf )->nodes[0].hasMatrix );
	testNear3( soleTransformPoint( node->local, soleVec( 1, 0, 0 ) ), soleVec( 5, 8, 7 ), 1e-5f );
	testNear3( soleTransformPoint( node->local, soleVec( 0, 1, 0 ) ), soleVec( 2, 6, 7 ), 1e-5f );
	testNear3( soleTransformPoint( node->local, soleVec( 0, 0, 1 ) ), soleVec( 5, 6, 3 ), 1e-5f );
	assert_float_equal( soleDotQuat( node->local.rotation, node->local.rotation ), 1.0f, 1e-6f );
	toolFreeGltf( gltf );
}

static void stripsAndFansBecomeTriangles( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"mode\":4", "\"mode\":5" );
	toolGltf* gltf = testOpenParts( &leg );
	// 0 1 2 0 2 3: triangles 012, 210 turned, 202 left out, 023 turned
	const uint32_t strip[9] = { 0, 1, 2, 1, 0, 2, 0, 3, 2 };
	const toolPrimitive* primitive = toolGltf_GetModel( gltf )->meshes[0].primitives;
	assert_int_equal( primitive->indexCount, 9 );
	assert_memory_equal( primitive->indices, strip, sizeof strip );
	toolFreeGltf( gltf );
	leg = testMakeLeg();
	testReplace( &leg, "\"indices\":3,\"mode\":4", "\"mode\":6" );
	gltf = testOpenParts( &leg );
	const uint32_t fan[6] = { 0, 1, 2, 0, 2, 3 };
	primitive = toolGltf_GetModel( gltf )->meshes[0].primitives;
	assert_int_equal( primitive->indexCount, 6 );
	assert_memory_equal( primitive->indices, fan, sizeof fan );
	toolFreeGltf( gltf );
}

static void missingInverseBindMatricesAreIdentity( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	memset( leg.bin + test_atInverseBind, 0x42, 128 );
	testReplace( &leg, ",\"inverseBindMatrices\":6", "" );
	toolGltf* gltf = testOpenParts( &leg );
	const float identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
	assert_memory_equal( toolGltf_GetModel( gltf )->skins[0].inverseBind + 16, identity, sizeof identity );
	toolFreeGltf( gltf );
}

static void bonesOfBothVrmVersionsAreFound( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	testReplace( &leg, "\"scene\":0",
	    "\"extensions\":{\"VRM\":{\"humanoid\":{\"humanBones\":[{\"bone\":\"leftFoot\",\"node\":1},"
	    "{\"bone\":\"jaw\",\"node\":-1}]}}},\"scene\":0" );
	toolGltf* gltf = testOpenParts( &leg );
	const toolModel* model = toolGltf_GetModel( gltf );
	assert_true( model->vrm0 );
	assert_int_equal( model->boneCount, 1 );
	assert_string_equal( model->bones[0].name, "leftFoot" );
	assert_int_equal( model->bones[0].node, 1 );
	toolFreeGltf( gltf );
	leg = testMakeLeg();
	testReplace( &leg, "\"scene\":0",
	    "\"extensions\":{\"VRMC_vrm\":{\"humanoid\":{\"humanBones\":{\"hips\":{\"node\":0},"
	    "\"leftFoot\":{\"node\":1}}}}},\"scene\":0" );
	gltf = testOpenParts( &leg );
	model = toolGltf_GetModel( gltf );
	assert_false( model->vrm0 );
	assert_int_equal( model->boneCount, 2 );
	assert_string_equal( model->bones[1].name, "leftFoot" );
	toolFreeGltf( gltf );
}

// ------------------------------------------------------------------------------------------------ other containers

static char* testBase64( const uint8_t* bytes, size_t count )
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	char* text = calloc( count / 3 * 4 + 8, 1 );
	assert_non_null( text );
	size_t at = 0;
	for ( size_t i = 0; i < count; i += 3 )
	{
		size_t left = count - i;
		uint32_t bits = (uint32_t)bytes[i] << 16 | ( left > 1 ? (uint32_t)bytes[i + 1] << 8 : 0 ) |
		    ( left > 2 ? bytes[i + 2] : 0u );
		text[at++] = digits[bits >> 18 & 63];
		text[at++] = digits[bits >> 12 & 63];
		text[at++] = left > 1 ? digits[bits >> 6 & 63] : '=';
		text[at++] = left > 2 ? digits[bits & 63] : '=';
	}
	return text;
}

/// The leg as a .gltf: the first 188 bytes in base64, the rest in a file with a space in its name.
static void testWriteLegText( testParts* leg )
{
	for ( int i = 6; i < 9; ++i )
	{
		const int offsets[] = { 188, 316, 344 };
		char from[64];
		char to[64];
		snprintf( from, sizeof from, "{\"buffer\":0,\"byteOffset\":%d", offsets[i - 6] );
		snprintf( to, sizeof to, "{\"buffer\":1,\"byteOffset\":%d", offsets[i - 6] - 188 );
		testReplace( leg, from, to );
	}
	char* base64 = testBase64( leg->bin, 188 );
	char buffers[512];
	snprintf( buffers, sizeof buffers,
	    "[{\"uri\":\"data:application/octet-stream;base64,%s\",\"byteLength\":188},{\"uri\":\"the%%20rest.bin\",\"byteLength\":180}]",
	    base64 );
	free( base64 );
	testReplace( leg, "[{\"byteLength\":368}]", buffers );
	testReplace( leg, "\"scene\":0", "\"images\":[{\"uri\":\"dot.png\"},{\"uri\":\"not there.png\"}],\"scene\":0" );
	testWriteBytes( TEMP( "the rest.bin" ), leg->bin + 188, 180 );
	testWriteBytes( TEMP( "dot.png" ), "\x89PNG\r\n\x1a\n0000IHDR", 16 );
	testWriteBytes( TEMP( "leg.gltf" ), leg->json, strlen( leg->json ) );
}

static void textWithOtherBuffersReadsLikeTheGlb( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* glb = testOpenParts( &leg );
	testWriteLegText( &leg );
	toolGltf* text = testOpenFile( TEMP( "leg.gltf" ) );
	const toolModel* a = toolGltf_GetModel( glb );
	const toolModel* b = toolGltf_GetModel( text );
	testSameNodes( a, b, 3 );
	testSameClip( a->clips, b->clips );
	assert_memory_equal( a->skins[0].inverseBind, b->skins[0].inverseBind, 128 );
	toolError error;
	// untouched it stays, as text; as .glb all is inside
	assert_true( toolWriteGltf( text, TEMP( "leg_same.gltf" ), &error ) );
	testSameFile( TEMP( "leg.gltf" ), TEMP( "leg_same.gltf" ) );
	assert_true( toolWriteGltf( text, TEMP( "leg_packed.glb" ), &error ) );
	remove( TEMP( "the rest.bin" ) );
	toolGltf* packed = testOpenFile( TEMP( "leg_packed.glb" ) );
	testSameClip( a->clips, toolGltf_GetModel( packed )->clips );
	size_t count = 0;
	uint8_t* bytes = testReadBytes( TEMP( "leg_packed.glb" ), &count );
	assert_true( testU32( bytes + 12 ) + 20 < count );
	bytes[20 + testU32( bytes + 12 )] = 0;
	assert_non_null( strstr( (const char*)bytes + 20, "image/png" ) );
	assert_non_null( strstr( (const char*)bytes + 20, "not there.png" ) );
	free( bytes );
	toolFreeGltf( packed );
	toolFreeGltf( text );
	toolFreeGltf( glb );
}

static void glbWrittenAsTextReadsBack( void** state )
{
	(void)state;
	testParts leg = testMakeLeg();
	toolGltf* glb = testOpenParts( &leg );
	toolError error;
	toolClip clip = toolGltf_GetModel( glb )->clips[0];
	assert_true( toolGltf_AppendClip( glb, &clip, &error ) );
	assert_true( toolWriteGltf( glb, TEMP( "as text #1.gltf" ), &error ) );
	toolGltf* text = testOpenFile( TEMP( "as text #1.gltf" ) );
	assert_int_equal( toolGltf_GetModel( text )->clipCount, 2 );
	testSameClip( toolGltf_GetModel( text )->clips + 1, &clip );
	size_t count = 0;
	uint8_t* bin = testReadBytes( TEMP( "as text #1.bin" ), &count );
	assert_memory_equal( bin, leg.bin, leg.binCount );
	free( bin );
	toolFreeGltf( text );
	toolFreeGltf( glb );
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
	for ( const char* at = strstr( (char*)text, "SCALAR" ); at != NULL; at = strstr( at + 1, "SCALAR" ) )
	{
		++scalars;
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
		cmocka_unit_test( smallFileReadsAsMeant ),
		cmocka_unit_test( sparseAccessorWithoutViewIsZeroButForItsValues ),
		cmocka_unit_test( sparseAccessorChangesSomeOfItsView ),
		cmocka_unit_test( normalizedIntegersBecomeFractions ),
		cmocka_unit_test( weightsMayBeBytesAndPositionsShorts ),
		cmocka_unit_test( interleavedViewsAreReadByTheirStride ),
		cmocka_unit_test( stepAndCubicKeepTheirKind ),
		cmocka_unit_test( weightAndNodelessChannelsAreLeftOut ),
		cmocka_unit_test( nodesWithoutNamesHaveEmptyOnes ),
		cmocka_unit_test( matrixOfANodeIsTakenApart ),
		cmocka_unit_test( stripsAndFansBecomeTriangles ),
		cmocka_unit_test( missingInverseBindMatricesAreIdentity ),
		cmocka_unit_test( bonesOfBothVrmVersionsAreFound ),
		cmocka_unit_test( textWithOtherBuffersReadsLikeTheGlb ),
		cmocka_unit_test( glbWrittenAsTextReadsBack ),
		cmocka_unit_test( channelsWithEqualTimesShareThem ),
		cmocka_unit_test( badClipsAreNotAppended ),
		cmocka_unit_test( whatWasTakenFromTheModelStaysGood ),
		cmocka_unit_test( appendedSceneIsShownBesideTheOldOne ),
		cmocka_unit_test( appendingCopesWithAnyLayoutOfTheJson ),
		cmocka_unit_test( madeWeightsSumToOneAndUnusedJointsAreZero ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
