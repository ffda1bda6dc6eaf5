// SPDX-License-Identifier: MIT
// Reading glTF files that are in order: what was read is what is there, in whatever form.
#define _POSIX_C_SOURCE 200809L
#include "glb_maker.h"

#define TEMP( name ) testTempPath( "test_gltf", name )

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

int main( void )
{
	const struct CMUnitTest tests[] = {
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
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
