// SPDX-License-Identifier: MIT
// Numbers of accessors: every component type, normalised, interleaved, sparse. Offsets and counts come from a file and
// are checked against the bytes that are there before anything is allocated.
#include "gltf_internal.h"

#include <json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A sparse accessor needs no bytes for its zeros: the one count that a file's length does not bear out.
#define SPARSE_LIMIT ( (size_t)16 << 20 )

enum
{
	tool_byte = 5120,
	tool_unsignedByte = 5121,
	tool_short = 5122,
	tool_unsignedShort = 5123,
	tool_unsignedInt = 5125,
	tool_float = 5126
};

/// Where the elements of an accessor are, or of one half of its sparse part.
typedef struct toolElements
{
	const uint8_t* bytes; // NULL: all zero
	size_t stride;
	size_t count;
	int32_t components;
	int componentType;
	size_t componentSize;
	bool fractions; // integers stand for -1 to 1 or 0 to 1
} toolElements;

static size_t toolGetComponentSize( size_t componentType )
{
	switch ( componentType )
	{
	case tool_byte:
	case tool_unsignedByte:
		return 1;
	case tool_short:
	case tool_unsignedShort:
		return 2;
	case tool_unsignedInt:
	case tool_float:
		return 4;
	default:
		return 0;
	}
}

uint32_t toolReadU32( const uint8_t* bytes )
{
	return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static uint32_t toolReadU16( const uint8_t* bytes )
{
	return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8;
}

static int32_t toolReadSigned( const uint8_t* bytes, int bits )
{
	int32_t value = bits == 8 ? (int32_t)bytes[0] : (int32_t)toolReadU16( bytes );
	return value >= 1 << ( bits - 1 ) ? value - ( 1 << bits ) : value;
}

static float toolReadComponent( const toolElements* elements, size_t element, int32_t component )
{
	if ( elements->bytes == NULL )
	{
		return 0.0f;
	}
	const uint8_t* bytes = elements->bytes + element * elements->stride + (size_t)component * elements->componentSize;
	bool fractions = elements->fractions;
	switch ( elements->componentType )
	{
	case tool_byte:
	{
		float value = (float)toolReadSigned( bytes, 8 );
		return fractions ? soleMaxF( value / 127.0f, -1.0f ) : value;
	}
	case tool_unsignedByte:
		return fractions ? (float)bytes[0] / 255.0f : (float)bytes[0];
	case tool_short:
	{
		float value = (float)toolReadSigned( bytes, 16 );
		return fractions ? soleMaxF( value / 32767.0f, -1.0f ) : value;
	}
	case tool_unsignedShort:
		return fractions ? (float)toolReadU16( bytes ) / 65535.0f : (float)toolReadU16( bytes );
	case tool_unsignedInt:
		return (float)toolReadU32( bytes );
	default:
	{
		uint32_t bits = toolReadU32( bytes );
		float value = 0.0f;
		memcpy( &value, &bits, sizeof value );
		return value;
	}
	}
}

static uint32_t toolReadUint( const toolElements* elements, size_t element, int32_t component )
{
	if ( elements->bytes == NULL )
	{
		return 0;
	}
	const uint8_t* bytes = elements->bytes + element * elements->stride + (size_t)component * elements->componentSize;
	return elements->componentSize == 1 ? bytes[0]
	    : elements->componentSize == 2  ? toolReadU16( bytes )
	                                    : toolReadU32( bytes );
}

bool toolSpend( toolGltfReader* reader, const char* owner, size_t count, size_t size )
{
	if ( size != 0 && count > reader->budget / size )
	{
		return toolFailFile( reader->error, reader->path,
		    "%s: the file uses the same data so often that it needs far more memory than it has bytes: split it",
		    owner );
	}
	reader->budget -= count * size;
	return true;
}

/// Points elements at a buffer view, with room checked for all of them. May be the accessor's or its sparse part's.
static bool toolFindBytes(
    toolGltfReader* reader, json_object* object, const char* owner, bool mayStride, toolElements* elements )
{
	json_object* views = NULL;
	int32_t viewCount = 0;
	int32_t viewIndex = SOLE_NONE;
	size_t offset = 0;
	if ( toolGetList( reader, reader->root, "", "bufferViews", &views, &viewCount ) == false ||
	    toolGetIndex( reader, object, owner, "bufferView", viewCount, &viewIndex ) == false ||
	    toolGetSize( reader, object, owner, "byteOffset", SIZE_MAX >> 12, &offset ) == false )
	{
		return false;
	}
	if ( viewIndex == SOLE_NONE )
	{
		return true;
	}
	json_object* view = json_object_array_get_idx( views, (size_t)viewIndex );
	toolOwner viewOwner = toolNameOwner( "bufferViews", (size_t)viewIndex, NULL );
	size_t viewOffset = 0;
	size_t viewLength = 0;
	size_t stride = 0;
	size_t buffer = SIZE_MAX;
	if ( toolGetSize( reader, view, viewOwner.text, "buffer", SIZE_MAX >> 12, &buffer ) == false ||
	    toolGetSize( reader, view, viewOwner.text, "byteOffset", SIZE_MAX >> 12, &viewOffset ) == false ||
	    toolGetSize( reader, view, viewOwner.text, "byteLength", SIZE_MAX >> 12, &viewLength ) == false ||
	    toolGetSize( reader, view, viewOwner.text, "byteStride", 65536, &stride ) == false )
	{
		return false;
	}
	json_object* extensions = toolGetMember( view, "extensions" );
	bool packed = toolGetMember( extensions, "EXT_meshopt_compression" ) != NULL ||
	    toolGetMember( extensions, "KHR_meshopt_compression" ) != NULL;
	if ( packed && ( buffer != 0 || viewOffset + viewLength > reader->bufferLength ) )
	{
		return toolFailFile(
		    reader->error, reader->path, "uses EXT_meshopt_compression: decode it first, e.g. with gltf-transform" );
	}
	size_t size = (size_t)elements->components * elements->componentSize;
	stride = stride == 0 || mayStride == false ? size : stride;
	if ( stride < size )
	{
		return toolFailFile( reader->error, reader->path,
		    "%s has a byteStride of %zu, less than the %zu bytes of %s: export it again", viewOwner.text, stride, size,
		    owner );
	}
	if ( buffer != 0 || viewOffset > reader->bufferLength || viewLength > reader->bufferLength - viewOffset )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s lies outside of the file's data: export it again", viewOwner.text );
	}
	// no overflow: offset and viewLength are below 2^53, stride is small, count is below 2^31
	if ( elements->count > 0 && offset + stride * ( elements->count - 1 ) + size > viewLength )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s lies outside of %s: export it again", owner, viewOwner.text );
	}
	elements->bytes = reader->gltf->bin + viewOffset + offset;
	elements->stride = stride;
	return true;
}

static bool toolFindType( const char* type, toolAccessorUse use )
{
	const char* wanted = use == tool_useScalar ? "SCALAR"
	    : use == tool_useVec3                  ? "VEC3"
	    : use == tool_useVec4                  ? "VEC4"
	                                           : "MAT4";
	return strcmp( type, wanted ) == 0;
}

/// The two halves of the sparse part, or count 0.
static bool toolOpenSparse( toolGltfReader* reader, json_object* accessor, const char* owner,
    const toolElements* elements, toolElements* indices, toolElements* values )
{
	json_object* sparse = toolGetMember( accessor, "sparse" );
	*indices = ( toolElements ){ .components = 1 };
	*values = *elements;
	values->bytes = NULL;
	values->count = 0;
	if ( sparse == NULL )
	{
		return true;
	}
	size_t count = 0;
	size_t componentType = 0;
	json_object* indexObject = toolGetMember( sparse, "indices" );
	if ( toolGetSize( reader, sparse, owner, "count", elements->count, &count ) == false ||
	    toolGetSize( reader, indexObject, owner, "componentType", 65535, &componentType ) == false )
	{
		return false;
	}
	bool known =
	    componentType == tool_unsignedByte || componentType == tool_unsignedShort || componentType == tool_unsignedInt;
	indices->componentType = (int)componentType;
	indices->componentSize = known ? toolGetComponentSize( componentType ) : 1;
	indices->count = count;
	values->count = count;
	if ( toolFindBytes( reader, indexObject, owner, false, indices ) == false ||
	    toolFindBytes( reader, toolGetMember( sparse, "values" ), owner, false, values ) == false )
	{
		return false;
	}
	bool complete = known && indices->bytes != NULL && values->bytes != NULL;
	if ( count > 0 && complete == false )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has a sparse part that is not complete: export it again", owner );
	}
	for ( size_t i = 0; i < count; ++i )
	{
		if ( toolReadUint( indices, i, 0 ) >= elements->count )
		{
			return toolFailFile(
			    reader->error, reader->path, "%s has a sparse index past its end: export it again", owner );
		}
	}
	return true;
}

/// Checks an accessor and spends its memory.
static bool toolOpenAccessor( toolGltfReader* reader, int32_t index, const char* user, toolAccessorUse use,
    toolElements* elements, toolElements* indices, toolElements* values )
{
	json_object* accessors = NULL;
	int32_t accessorCount = 0;
	if ( toolGetList( reader, reader->root, "", "accessors", &accessors, &accessorCount ) == false )
	{
		return false;
	}
	if ( index < 0 || index >= accessorCount )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s names accessor %d of %d: export it again", user, index, accessorCount );
	}
	json_object* accessor = json_object_array_get_idx( accessors, (size_t)index );
	toolOwner owner = toolNameOwner( "accessors", (size_t)index, NULL );
	size_t componentType = 0;
	size_t count = 0;
	if ( toolGetSize( reader, accessor, owner.text, "componentType", 65535, &componentType ) == false ||
	    toolGetSize( reader, accessor, owner.text, "count", INT32_MAX / 16, &count ) == false )
	{
		return false;
	}
	size_t componentSize = toolGetComponentSize( componentType );
	if ( componentSize == 0 || toolFindType( toolGetText( accessor, "type" ), use ) == false )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s is not of a type that %s may have: export it again", owner.text, user );
	}
	*elements = ( toolElements ){ .count = count,
		.components = (int32_t)use,
		.componentType = (int)componentType,
		.componentSize = componentSize,
		.fractions = toolGetFlag( accessor, "normalized" ) };
	if ( toolFindBytes( reader, accessor, owner.text, true, elements ) == false ||
	    toolOpenSparse( reader, accessor, owner.text, elements, indices, values ) == false )
	{
		return false;
	}
	bool hasSparse = toolGetMember( accessor, "sparse" ) != NULL;
	if ( elements->bytes == NULL && hasSparse == false && count > 0 )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s, which %s needs, has no data: export it again", owner.text, user );
	}
	if ( elements->bytes == NULL && count > SPARSE_LIMIT )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has a count of %zu without data: export it again", owner.text, count );
	}
	return toolSpend( reader, user, count * (size_t)use, sizeof( float ) );
}

bool toolReadFloats( toolGltfReader* reader, int32_t accessor, const char* owner, toolAccessorUse use, bool asFractions,
    float** values, int32_t* count )
{
	toolElements elements = { 0 };
	toolElements indices = { 0 };
	toolElements changed = { 0 };
	if ( toolOpenAccessor( reader, accessor, owner, use, &elements, &indices, &changed ) == false )
	{
		return false;
	}
	elements.fractions = elements.fractions || asFractions;
	changed.fractions = elements.fractions;
	int32_t size = elements.components;
	float* out = toolAlloc( elements.count * (size_t)size, sizeof( float ) );
	for ( size_t i = 0; elements.bytes != NULL && i < elements.count; ++i )
	{
		for ( int32_t j = 0; j < size; ++j )
		{
			out[i * (size_t)size + (size_t)j] = toolReadComponent( &elements, i, j );
		}
	}
	for ( size_t i = 0; i < indices.count; ++i )
	{
		size_t at = toolReadUint( &indices, i, 0 );
		for ( int32_t j = 0; j < size; ++j )
		{
			out[at * (size_t)size + (size_t)j] = toolReadComponent( &changed, i, j );
		}
	}
	*values = out;
	*count = (int32_t)elements.count;
	return true;
}

bool toolReadUints( toolGltfReader* reader, int32_t accessor, const char* owner, toolAccessorUse use, uint32_t** values,
    int32_t* count )
{
	toolElements elements = { 0 };
	toolElements indices = { 0 };
	toolElements changed = { 0 };
	if ( toolOpenAccessor( reader, accessor, owner, use, &elements, &indices, &changed ) == false )
	{
		return false;
	}
	bool whole = elements.componentType == tool_unsignedByte || elements.componentType == tool_unsignedShort ||
	    elements.componentType == tool_unsignedInt;
	if ( whole == false )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s is not made of unsigned integers: export it again", owner );
	}
	int32_t size = elements.components;
	uint32_t* out = toolAlloc( elements.count * (size_t)size, sizeof( uint32_t ) );
	for ( size_t i = 0; i < elements.count * (size_t)size; ++i )
	{
		out[i] = toolReadUint( &elements, i / (size_t)size, (int32_t)( i % (size_t)size ) );
	}
	for ( size_t i = 0; i < indices.count * (size_t)size; ++i )
	{
		size_t at = toolReadUint( &indices, i / (size_t)size, 0 );
		out[at * (size_t)size + i % (size_t)size] =
		    toolReadUint( &changed, i / (size_t)size, (int32_t)( i % (size_t)size ) );
	}
	*values = out;
	*count = (int32_t)elements.count;
	return true;
}

int64_t toolFindNotFinite( const float* values, size_t count )
{
	for ( size_t i = 0; i < count; ++i )
	{
		if ( soleIsFinite( values[i] ) == false )
		{
			return (int64_t)i;
		}
	}
	return -1;
}
