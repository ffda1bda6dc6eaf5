// SPDX-License-Identifier: MIT
// Brings a file with buffers or images elsewhere (other files, base64 in the JSON) into the form of a .glb: one buffer
// in BIN and everything in it. Only then is the JSON printed anew.
#include "gltf_internal.h"

#include <json.h>
#include <stdlib.h>
#include <string.h>

#define BIN_LIMIT ( (size_t)1 << 30 )
#define BUFFER_LIMIT 4096

typedef struct toolNormalizer
{
	toolGltf* gltf;
	toolGltfReader reader; // for messages
	json_object* root;
	uint8_t* bin;
	size_t count;
	size_t readCount; // bytes read from files, so that a small file cannot make us read forever
	size_t* bases;
	size_t* lengths;
} toolNormalizer;

static bool toolIsScheme( const char* uri )
{
	size_t letters = strspn( uri, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-." );
	return uri[letters] == ':';
}

static int toolHexValue( char c )
{
	return c >= '0' && c <= '9' ? c - '0'
	    : c >= 'a' && c <= 'f'  ? c - 'a' + 10
	    : c >= 'A' && c <= 'F'  ? c - 'A' + 10
	                            : -1;
}

/// The path of a file that an address names, or NULL where the address is none of a file beside.
static char* toolResolveUri( const char* path, const char* uri )
{
	if ( *uri == 0 || *uri == '/' || *uri == '\\' || toolIsScheme( uri ) )
	{
		return NULL;
	}
	char* folder = toolGetFolder( path );
	char* resolved = toolFormat( "%s%s", folder, uri );
	char* out = resolved + strlen( folder );
	free( folder );
	const char* in = out;
	while ( *in != 0 )
	{
		int high = in[0] == '%' ? toolHexValue( in[1] ) : -1;
		int low = high >= 0 ? toolHexValue( in[2] ) : -1;
		int code = low >= 0 ? high * 16 + low : (unsigned char)*in;
		if ( code == 0 )
		{
			free( resolved );
			return NULL;
		}
		*out++ = (char)code;
		in += low >= 0 ? 3 : 1;
	}
	*out = 0;
	return resolved;
}

static int toolBase64Value( char c )
{
	return c >= 'A' && c <= 'Z' ? c - 'A'
	    : c >= 'a' && c <= 'z'  ? c - 'a' + 26
	    : c >= '0' && c <= '9'  ? c - '0' + 52
	    : c == '+'              ? 62
	    : c == '/'              ? 63
	                            : -1;
}

/// False where a character is none of base64 or the end is odd.
static bool toolDecodeBase64( const char* text, uint8_t** bytes, size_t* byteCount )
{
	size_t length = strlen( text );
	while ( length > 0 && text[length - 1] == '=' && strlen( text ) - length < 2 )
	{
		--length;
	}
	uint8_t* out = toolAlloc( length / 4 * 3 + 3, 1 );
	size_t count = 0;
	uint32_t bits = 0;
	bool good = length % 4 != 1;
	for ( size_t i = 0; good && i < length; ++i )
	{
		int value = toolBase64Value( text[i] );
		good = value >= 0;
		bits = bits << 6 | (uint32_t)( value & 63 );
		if ( i % 4 != 0 )
		{
			out[count] = (uint8_t)( bits >> ( 6 - 2 * ( i % 4 ) ) & 255 );
			++count;
		}
	}
	if ( good == false )
	{
		free( out );
		return false;
	}
	*bytes = out;
	*byteCount = count;
	return true;
}

static bool toolReadDataUri(
    const toolNormalizer* normalizer, const char* uri, const char* owner, uint8_t** bytes, size_t* count )
{
	const char* comma = strchr( uri, ',' );
	bool base64 = comma != NULL && comma - uri >= 7 && memcmp( comma - 7, ";base64", 7 ) == 0;
	if ( base64 && toolDecodeBase64( comma + 1, bytes, count ) )
	{
		return true;
	}
	return toolFailFile(
	    normalizer->reader.error, normalizer->gltf->path, "%s has data that is no base64: export it again", owner );
}

/// The bytes of buffers[i]. The caller frees them.
static bool toolReadBuffer(
    toolNormalizer* normalizer, json_object* buffer, int32_t index, uint8_t** bytes, size_t* count )
{
	toolGltf* gltf = normalizer->gltf;
	toolError* error = normalizer->reader.error;
	toolOwner owner = toolNameOwner( "buffers", (size_t)index, NULL );
	const char* uri = toolGetText( buffer, "uri" );
	if ( strncmp( uri, "data:", 5 ) == 0 )
	{
		return toolReadDataUri( normalizer, uri, owner.text, bytes, count );
	}
	if ( *uri == 0 )
	{
		if ( index == 0 && gltf->bin != NULL )
		{
			*bytes = toolAlloc( gltf->binCount, 1 );
			memcpy( *bytes, gltf->bin, gltf->binCount );
			*count = gltf->binCount;
			return true;
		}
		const char* packed = toolFindCompression( normalizer->root, "extensionsUsed" );
		return packed != NULL
		    ? toolFailFile( error, gltf->path, "uses %s: decode it first, e.g. with gltf-transform", packed )
		    : toolFailFile( error, gltf->path, "%s has no data: export it again", owner.text );
	}
	char* file = toolResolveUri( gltf->path, uri );
	if ( file == NULL )
	{
		return toolFailFile(
		    error, gltf->path, "%s is at '%.80s', which is no file beside: put it there", owner.text, uri );
	}
	toolError inner;
	bool good = toolReadFile( file, bytes, count, &inner );
	free( file );
	if ( good == false )
	{
		return toolFailFile( error, gltf->path, "its buffer file '%.80s' cannot be read: put it beside", uri );
	}
	normalizer->readCount += *count;
	return true;
}

/// Room for more bytes, aligned to 4. @return where they begin
static size_t toolAddBin( toolNormalizer* normalizer, const uint8_t* bytes, size_t count )
{
	size_t begin = ( normalizer->count + 3 ) & ~(size_t)3;
	normalizer->bin = toolGrow( normalizer->bin, begin + count, 1 );
	memset( normalizer->bin + normalizer->count, 0, begin - normalizer->count );
	if ( count > 0 )
	{
		memcpy( normalizer->bin + begin, bytes, count );
	}
	normalizer->count = begin + count;
	return begin;
}

static bool toolJoinBuffers( toolNormalizer* normalizer, json_object* buffers, int32_t bufferCount )
{
	toolGltfReader* reader = &normalizer->reader;
	for ( int32_t i = 0; i < bufferCount; ++i )
	{
		json_object* buffer = json_object_array_get_idx( buffers, (size_t)i );
		toolOwner owner = toolNameOwner( "buffers", (size_t)i, NULL );
		size_t length = 0;
		uint8_t* bytes = NULL;
		size_t count = 0;
		if ( toolGetSize( reader, buffer, owner.text, "byteLength", SIZE_MAX >> 12, &length ) == false ||
		    toolReadBuffer( normalizer, buffer, i, &bytes, &count ) == false )
		{
			return false;
		}
		bool good = count >= length;
		bool fits = normalizer->count + length <= BIN_LIMIT && normalizer->readCount <= BIN_LIMIT;
		if ( good && fits )
		{
			normalizer->bases[i] = toolAddBin( normalizer, bytes, length );
			normalizer->lengths[i] = length;
		}
		free( bytes );
		if ( good == false )
		{
			return toolFailFile( reader->error, reader->path,
			    "%s has %zu bytes where its byteLength says %zu: copy or export it again", owner.text, count, length );
		}
		if ( fits == false )
		{
			return toolFailFile( reader->error, reader->path, "has buffers of more than 1 GiB: split it" );
		}
	}
	return true;
}

static bool toolPointViews( toolNormalizer* normalizer, int32_t bufferCount )
{
	toolGltfReader* reader = &normalizer->reader;
	json_object* views = NULL;
	int32_t viewCount = 0;
	if ( toolGetList( reader, normalizer->root, "", "bufferViews", &views, &viewCount ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < viewCount; ++i )
	{
		json_object* view = json_object_array_get_idx( views, (size_t)i );
		toolOwner owner = toolNameOwner( "bufferViews", (size_t)i, NULL );
		int32_t buffer = SOLE_NONE;
		size_t offset = 0;
		size_t length = 0;
		if ( toolGetIndex( reader, view, owner.text, "buffer", bufferCount, &buffer ) == false ||
		    toolGetSize( reader, view, owner.text, "byteOffset", SIZE_MAX >> 12, &offset ) == false ||
		    toolGetSize( reader, view, owner.text, "byteLength", SIZE_MAX >> 12, &length ) == false )
		{
			return false;
		}
		json_object* extensions = toolGetMember( view, "extensions" );
		if ( toolGetMember( extensions, "EXT_meshopt_compression" ) != NULL ||
		    toolGetMember( extensions, "KHR_meshopt_compression" ) != NULL )
		{
			return toolFailFile( reader->error, reader->path,
			    "uses EXT_meshopt_compression: decode it first, e.g. with gltf-transform" );
		}
		if ( buffer == SOLE_NONE || length > normalizer->lengths[buffer] ||
		    offset > normalizer->lengths[buffer] - length )
		{
			return toolFailFile(
			    reader->error, reader->path, "%s lies outside of its buffer: export it again", owner.text );
		}
		json_object_object_add( view, "buffer", json_object_new_int( 0 ) );
		json_object_object_add(
		    view, "byteOffset", json_object_new_int64( (int64_t)( normalizer->bases[buffer] + offset ) ) );
	}
	return true;
}

static const char* toolFindImageType( const uint8_t* bytes, size_t count )
{
	if ( count < 12 )
	{
		return NULL;
	}
	return memcmp( bytes, "\x89PNG", 4 ) == 0                                    ? "image/png"
	    : memcmp( bytes, "\xff\xd8\xff", 3 ) == 0                                ? "image/jpeg"
	    : memcmp( bytes, "RIFF", 4 ) == 0 && memcmp( bytes + 8, "WEBP", 4 ) == 0 ? "image/webp"
	    : memcmp( bytes, "\xabKTX 20\xbb", 8 ) == 0                              ? "image/ktx2"
	                                                                             : NULL;
}

/// Takes an image's file in where it is there and is an image; else its address stays.
static void toolEmbedImage( toolNormalizer* normalizer, json_object* image, json_object* views )
{
	const char* uri = toolGetText( image, "uri" );
	char* file = toolResolveUri( normalizer->gltf->path, uri );
	uint8_t* bytes = NULL;
	size_t count = 0;
	toolError ignored;
	if ( file == NULL || toolReadFile( file, &bytes, &count, &ignored ) == false )
	{
		free( file );
		return;
	}
	free( file );
	normalizer->readCount += count;
	const char* type = toolFindImageType( bytes, count );
	if ( type != NULL && normalizer->count + count <= BIN_LIMIT && normalizer->readCount <= BIN_LIMIT )
	{
		size_t begin = toolAddBin( normalizer, bytes, count );
		json_object* view = json_object_new_object();
		json_object_object_add( view, "buffer", json_object_new_int( 0 ) );
		json_object_object_add( view, "byteOffset", json_object_new_int64( (int64_t)begin ) );
		json_object_object_add( view, "byteLength", json_object_new_int64( (int64_t)count ) );
		json_object_object_del( image, "uri" );
		json_object_object_add(
		    image, "bufferView", json_object_new_int64( (int64_t)json_object_array_length( views ) ) );
		json_object_object_add( image, "mimeType", json_object_new_string( type ) );
		json_object_array_add( views, view );
	}
	free( bytes );
}

static bool toolEmbedImages( toolNormalizer* normalizer )
{
	json_object* images = NULL;
	int32_t imageCount = 0;
	if ( toolGetList( &normalizer->reader, normalizer->root, "", "images", &images, &imageCount ) == false )
	{
		return false;
	}
	if ( imageCount > 0 && toolGetMember( normalizer->root, "bufferViews" ) == NULL )
	{
		json_object_object_add( normalizer->root, "bufferViews", json_object_new_array() );
	}
	json_object* views = toolGetMember( normalizer->root, "bufferViews" );
	for ( int32_t i = 0; i < imageCount && normalizer->readCount <= BIN_LIMIT; ++i )
	{
		toolEmbedImage( normalizer, json_object_array_get_idx( images, (size_t)i ), views );
	}
	if ( views != NULL && json_object_array_length( views ) == 0 )
	{
		json_object_object_del( normalizer->root, "bufferViews" );
	}
	return true;
}

/// Puts the joined data in place of the file's and prints the JSON.
static void toolFinishNormal( toolNormalizer* normalizer )
{
	toolGltf* gltf = normalizer->gltf;
	if ( normalizer->count > 0 )
	{
		json_object* buffer = json_object_new_object();
		json_object_object_add( buffer, "byteLength", json_object_new_int64( (int64_t)normalizer->count ) );
		json_object* buffers = json_object_new_array();
		json_object_array_add( buffers, buffer );
		json_object_object_add( normalizer->root, "buffers", buffers );
	}
	else
	{
		json_object_object_del( normalizer->root, "buffers" );
	}
	const char* text =
	    json_object_to_json_string_ext( normalizer->root, JSON_C_TO_STRING_PLAIN | JSON_C_TO_STRING_NOSLASHESCAPE );
	free( gltf->json );
	gltf->json = toolCopyString( text );
	gltf->jsonCount = strlen( text );
	free( gltf->bin );
	gltf->bin = normalizer->bin;
	gltf->binCount = normalizer->count;
	normalizer->bin = NULL;
}

/// Whether any item of a list names a file. base64 is none.
static bool toolNamesFiles( json_object* list, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		const char* uri = toolGetText( json_object_array_get_idx( list, (size_t)i ), "uri" );
		if ( *uri != 0 && strncmp( uri, "data:", 5 ) != 0 )
		{
			return true;
		}
	}
	return false;
}

bool toolNormalizeGltf( toolGltf* gltf, json_object** root, toolError* error )
{
	toolNormalizer normalizer = {
		.gltf = gltf, .root = *root, .reader = { .gltf = gltf, .path = gltf->path, .root = *root, .error = error }
	};
	json_object* buffers = NULL;
	json_object* images = NULL;
	int32_t bufferCount = 0;
	int32_t imageCount = 0;
	if ( toolGetList( &normalizer.reader, *root, "", "buffers", &buffers, &bufferCount ) == false ||
	    toolGetList( &normalizer.reader, *root, "", "images", &images, &imageCount ) == false )
	{
		return false;
	}
	gltf->originalHasFiles = toolNamesFiles( buffers, bufferCount ) || toolNamesFiles( images, imageCount );
	bool inBin =
	    bufferCount == 0 || ( bufferCount == 1 && *toolGetText( json_object_array_get_idx( buffers, 0 ), "uri" ) == 0 );
	if ( gltf->originalIsText == false && inBin )
	{
		return true;
	}
	if ( bufferCount > BUFFER_LIMIT )
	{
		return toolFailFile( error, gltf->path, "has more than %d buffers: save it as a .glb", BUFFER_LIMIT );
	}
	normalizer.bases = toolAlloc( (size_t)bufferCount, sizeof( size_t ) );
	normalizer.lengths = toolAlloc( (size_t)bufferCount, sizeof( size_t ) );
	bool good = toolJoinBuffers( &normalizer, buffers, bufferCount ) && toolPointViews( &normalizer, bufferCount ) &&
	    toolEmbedImages( &normalizer );
	if ( good )
	{
		toolFinishNormal( &normalizer );
	}
	free( normalizer.bases );
	free( normalizer.lengths );
	free( normalizer.bin );
	return good;
}
