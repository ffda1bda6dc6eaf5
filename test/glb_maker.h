// SPDX-License-Identifier: MIT
// Small glTF files made by tests: a leg of two joints with a mesh, a skin and a clip, and any change of its text or
// bytes.
#ifndef TEST_GLB_MAKER_H
#define TEST_GLB_MAKER_H

#include "test.h"

#include "gltf.h"

#include <sys/stat.h>

/// What a file is made of before it is packed.
typedef struct testParts
{
	char json[8192];
	uint8_t bin[1024];
	size_t binCount;
} testParts;

static const char testLegJson[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,2]}],"
    "\"nodes\":[{\"name\":\"hip\",\"children\":[1]},{\"name\":\"knee\",\"translation\":[0,1,0]},"
    "{\"name\":\"body\",\"mesh\":0,\"skin\":0}],"
    "\"meshes\":[{\"name\":\"leg\",\"primitives\":[{\"attributes\":{\"POSITION\":0,\"JOINTS_0\":1,\"WEIGHTS_0\":2,"
    "\"NORMAL\":7},\"indices\":3,\"mode\":4,\"material\":0}]}],"
    "\"materials\":[{\"name\":\"skin\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0.5,0,1]}}],"
    "\"skins\":[{\"joints\":[0,1],\"inverseBindMatrices\":6}],"
    "\"animations\":[{\"name\":\"wave\",\"samplers\":[{\"input\":4,\"output\":5},{\"input\":4,\"output\":8}],"
    "\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
    "{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"rotation\"}}],\"extras\":{\"source\":\"test\"}}],"
    "\"accessors\":["
    "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
    "{\"bufferView\":1,\"componentType\":5121,\"count\":4,\"type\":\"VEC4\"},"
    "{\"bufferView\":2,\"componentType\":5126,\"count\":4,\"type\":\"VEC4\"},"
    "{\"bufferView\":3,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"},"
    "{\"bufferView\":4,\"componentType\":5126,\"count\":3,\"type\":\"SCALAR\"},"
    "{\"bufferView\":5,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
    "{\"bufferView\":6,\"componentType\":5126,\"count\":2,\"type\":\"MAT4\"},"
    "{\"componentType\":5126,\"count\":4,\"type\":\"VEC3\",\"sparse\":{\"count\":2,"
    "\"indices\":{\"bufferView\":7,\"componentType\":5123},\"values\":{\"bufferView\":7,\"byteOffset\":4}}},"
    "{\"bufferView\":8,\"componentType\":5122,\"normalized\":true,\"count\":3,\"type\":\"VEC4\"}],"
    "\"bufferViews\":["
    "{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":16},"
    "{\"buffer\":0,\"byteOffset\":64,\"byteLength\":64},{\"buffer\":0,\"byteOffset\":128,\"byteLength\":12},"
    "{\"buffer\":0,\"byteOffset\":140,\"byteLength\":12},{\"buffer\":0,\"byteOffset\":152,\"byteLength\":36},"
    "{\"buffer\":0,\"byteOffset\":188,\"byteLength\":128},{\"buffer\":0,\"byteOffset\":316,\"byteLength\":28},"
    "{\"buffer\":0,\"byteOffset\":344,\"byteLength\":24}],"
    "\"buffers\":[{\"byteLength\":368}]}";

/// Where things are in the leg's BIN.
enum
{
	test_atPositions = 0,
	test_atJoints = 48,
	test_atWeights = 64,
	test_atIndices = 128,
	test_atTimes = 140,
	test_atTranslations = 152,
	test_atInverseBind = 188,
	test_atSparse = 316,
	test_atRotations = 344,
	test_legBinCount = 368
};

static inline testParts testMakeLeg( void )
{
	testParts parts = { .binCount = test_legBinCount };
	memcpy( parts.json, testLegJson, sizeof testLegJson );
	const float positions[12] = { 0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0 };
	const uint8_t joints[16] = { 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0 };
	const float weights[16] = { 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.25f, 0.75f, 0, 0 };
	const uint16_t indices[6] = { 0, 1, 2, 0, 2, 3 };
	const float times[3] = { 0.5f, 1.0f, 2.0f };
	const float translations[9] = { 0, 0, 0, 0, 0, 1, 0, 0, 2 };
	const float identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
	const uint16_t sparse[2] = { 1, 3 };
	const float normals[6] = { 0, 0, 1, 0, 1, 0 };
	const int16_t rotations[12] = { 0, 0, 0, 32767, 0, 32767, 0, 0, 0, 0, -32768, 0 };
	memcpy( parts.bin + test_atPositions, positions, sizeof positions );
	memcpy( parts.bin + test_atJoints, joints, sizeof joints );
	memcpy( parts.bin + test_atWeights, weights, sizeof weights );
	memcpy( parts.bin + test_atIndices, indices, sizeof indices );
	memcpy( parts.bin + test_atTimes, times, sizeof times );
	memcpy( parts.bin + test_atTranslations, translations, sizeof translations );
	memcpy( parts.bin + test_atInverseBind, identity, sizeof identity );
	memcpy( parts.bin + test_atInverseBind + 64, identity, sizeof identity );
	memcpy( parts.bin + test_atSparse, sparse, sizeof sparse );
	memcpy( parts.bin + test_atSparse + 4, normals, sizeof normals );
	memcpy( parts.bin + test_atRotations, rotations, sizeof rotations );
	return parts;
}

/// Replaces the first place of a text in the JSON, which must be there.
static inline void testReplace( testParts* parts, const char* from, const char* to )
{
	char* at = strstr( parts->json, from );
	assert_non_null( at );
	char rest[sizeof parts->json];
	snprintf( rest, sizeof rest, "%s", at + strlen( from ) );
	size_t room = sizeof parts->json - (size_t)( at - parts->json );
	int count = snprintf( at, room, "%s%s", to, rest );
	assert_true( count >= 0 && (size_t)count < room );
}

static inline void testPutU32( uint8_t* bytes, size_t value )
{
	for ( int i = 0; i < 4; ++i )
	{
		bytes[i] = (uint8_t)( value >> ( 8 * i ) & 255 );
	}
}

/// A .glb of a text and bytes. The caller frees it.
static inline uint8_t* testPackGlb( const char* json, const uint8_t* bin, size_t binCount, size_t* byteCount )
{
	size_t jsonCount = ( strlen( json ) + 3 ) & ~(size_t)3;
	size_t binPadded = ( binCount + 3 ) & ~(size_t)3;
	size_t count = 12 + 8 + jsonCount + ( binCount > 0 ? 8 + binPadded : 0 );
	uint8_t* bytes = calloc( count, 1 );
	assert_non_null( bytes );
	memcpy( bytes, "glTF", 4 );
	testPutU32( bytes + 4, 2 );
	testPutU32( bytes + 8, count );
	testPutU32( bytes + 12, jsonCount );
	memcpy( bytes + 16, "JSON", 4 );
	memset( bytes + 20, ' ', jsonCount );
	memcpy( bytes + 20, json, strlen( json ) );
	if ( binCount > 0 )
	{
		testPutU32( bytes + 20 + jsonCount, binPadded );
		memcpy( bytes + 24 + jsonCount, "BIN", 4 );
		memcpy( bytes + 28 + jsonCount, bin, binCount );
	}
	*byteCount = count;
	return bytes;
}

/// Reads parts as a file "leg.glb".
static inline bool testReadParts( const testParts* parts, toolGltf** gltf, toolError* error )
{
	size_t count = 0;
	uint8_t* bytes = testPackGlb( parts->json, parts->bin, parts->binCount, &count );
	bool good = toolReadGlbBytes( bytes, count, "leg.glb", gltf, error );
	free( bytes );
	return good;
}

/// The same where it must be read.
static inline toolGltf* testOpenParts( const testParts* parts )
{
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	if ( testReadParts( parts, &gltf, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return gltf;
}

/// A path for a file that the test writes, in a folder of this program's own.
static inline const char* testTempPath( const char* program, const char* name )
{
	static char paths[8][1024];
	static int next = 0;
	char* path = paths[next];
	next = ( next + 1 ) % 8;
	snprintf( path, sizeof paths[0], "%s/%s_files", SOLE_BINARY_DIR, program );
	mkdir( path, 0777 );
	size_t used = strlen( path );
	snprintf( path + used, sizeof paths[0] - used, "/%s", name );
	return path;
}

static inline void testWriteBytes( const char* path, const void* bytes, size_t byteCount )
{
	FILE* file = fopen( path, "wb" );
	assert_non_null( file );
	assert_int_equal( fwrite( bytes, 1, byteCount, file ), byteCount );
	assert_int_equal( fclose( file ), 0 );
}

static inline uint8_t* testReadBytes( const char* path, size_t* byteCount )
{
	uint8_t* bytes = NULL;
	toolError error = { { 0 } };
	if ( toolReadFile( path, &bytes, byteCount, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return bytes;
}

static inline toolGltf* testOpenFile( const char* path )
{
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	if ( toolReadGltf( path, &gltf, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	return gltf;
}

static inline uint32_t testU32( const uint8_t* bytes )
{
	return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static inline void testSameFile( const char* a, const char* b )
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

static inline void testSameClip( const toolClip* a, const toolClip* b )
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

static inline void testSameNodes( const toolModel* a, const toolModel* b, int32_t count )
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

#endif
