// SPDX-License-Identifier: MIT
// The shell of a glTF file: a .glb's header and chunks, or a .gltf's text. Opens, joins, writes them.
#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

#define CHUNK_JSON 0x4e4f534au
#define CHUNK_BIN 0x004e4942u
// json-c needs some hundred bytes for the shortest value
#define JSON_LIMIT ( (size_t)256 << 20 )

bool toolIsGlb( const uint8_t* bytes, size_t byteCount )
{
	return byteCount >= 4 && memcmp( bytes, "glTF", 4 ) == 0;
}

char* toolGetFolder( const char* path )
{
	char* folder = toolCopyString( path );
	char* slash = strrchr( folder, '/' );
	*( slash != NULL ? slash + 1 : folder ) = 0;
	return folder;
}

/// Copies bytes and sets a zero behind them.
static void* toolCopyBytes( const void* bytes, size_t byteCount )
{
	char* copy = toolAlloc( byteCount + 1, 1 );
	if ( byteCount > 0 )
	{
		memcpy( copy, bytes, byteCount );
	}
	return copy;
}

/// Padding at the end of a JSON text is no part of it: it is made anew.
static size_t toolTrimJson( const char* text, size_t count )
{
	while ( count > 0 && ( text[count - 1] == 0 || strchr( " \t\r\n", text[count - 1] ) != NULL ) )
	{
		--count;
	}
	return count;
}

static bool toolTakeJson( toolGltf* gltf, const uint8_t* bytes, size_t byteCount, toolError* error )
{
	if ( byteCount > JSON_LIMIT )
	{
		return toolFailFile( error, gltf->path, "has more than 256 MiB of JSON: save it as a .glb" );
	}
	gltf->jsonCount = toolTrimJson( (const char*)bytes, byteCount );
	gltf->json = toolCopyBytes( bytes, gltf->jsonCount );
	return true;
}

/// The chunk at *at; moves on behind it.
static bool toolTakeChunk(
    const toolGltf* gltf, size_t* at, uint32_t* type, size_t* begin, size_t* length, toolError* error )
{
	size_t end = gltf->originalCount;
	if ( end - *at < 8 )
	{
		return toolFailFile( error, gltf->path, "ends within a chunk's header: copy or export it again" );
	}
	*length = toolReadU32( gltf->original + *at );
	*type = toolReadU32( gltf->original + *at + 4 );
	*begin = *at + 8;
	if ( *length > end - *begin )
	{
		return toolFailFile( error, gltf->path,
		    "has a chunk of %zu bytes but ends after %zu of them: copy or export it again", *length, end - *begin );
	}
	*at = *begin + *length;
	return true;
}

/// Up to three zeros or spaces behind the last chunk are padding that its length forgot.
static bool toolIsPadding( const uint8_t* bytes, size_t byteCount )
{
	if ( byteCount >= 4 )
	{
		return false;
	}
	for ( size_t i = 0; i < byteCount; ++i )
	{
		if ( bytes[i] != 0 && bytes[i] != ' ' )
		{
			return false;
		}
	}
	return true;
}

bool toolSplitGlb( toolGltf* gltf, toolError* error )
{
	const uint8_t* bytes = gltf->original;
	size_t end = gltf->originalCount;
	if ( toolIsGlb( bytes, end ) == false || end < 20 )
	{
		return toolFailFile( error, gltf->path, "is not a GLB file: give a .glb, .vrm or .gltf" );
	}
	if ( toolReadU32( bytes + 4 ) != 2 )
	{
		return toolFailFile( error, gltf->path, "is GLB version %u: export it as version 2", toolReadU32( bytes + 4 ) );
	}
	if ( toolReadU32( bytes + 8 ) != end )
	{
		return toolFailFile( error, gltf->path, "has %zu bytes but its header says %u: copy or export it again", end,
		    toolReadU32( bytes + 8 ) );
	}
	size_t at = 12;
	size_t begin = 0;
	size_t length = 0;
	uint32_t type = 0;
	if ( toolTakeChunk( gltf, &at, &type, &begin, &length, error ) == false )
	{
		return false;
	}
	if ( type != CHUNK_JSON )
	{
		return toolFailFile( error, gltf->path, "does not start with a JSON chunk: export it again" );
	}
	if ( toolTakeJson( gltf, bytes + begin, length, error ) == false )
	{
		return false;
	}
	size_t restBegin = at;
	while ( toolIsPadding( bytes + at, end - at ) == false )
	{
		size_t chunk = at;
		if ( toolTakeChunk( gltf, &at, &type, &begin, &length, error ) == false )
		{
			return false;
		}
		if ( type == CHUNK_BIN && chunk == restBegin )
		{
			gltf->bin = toolCopyBytes( bytes + begin, length );
			gltf->binCount = length;
			restBegin = at;
		}
	}
	gltf->rest = toolCopyBytes( bytes + restBegin, at - restBegin );
	gltf->restCount = at - restBegin;
	return true;
}

bool toolSplitText( toolGltf* gltf, toolError* error )
{
	gltf->originalIsText = true;
	// some editors put a byte order mark in front
	size_t mark = gltf->originalCount >= 3 && memcmp( gltf->original, "\xef\xbb\xbf", 3 ) == 0 ? 3 : 0;
	return toolTakeJson( gltf, gltf->original + mark, gltf->originalCount - mark, error );
}

static void toolPutU32( uint8_t* bytes, size_t value )
{
	for ( int i = 0; i < 4; ++i )
	{
		bytes[i] = (uint8_t)( value >> ( 8 * i ) & 255 );
	}
}

/// A chunk's header and content at out. @return its whole size
static size_t toolPutChunk( uint8_t* out, uint32_t type, const void* bytes, size_t byteCount, int padding )
{
	size_t padded = ( byteCount + 3 ) & ~(size_t)3;
	toolPutU32( out, padded );
	toolPutU32( out + 4, type );
	memcpy( out + 8, bytes, byteCount );
	memset( out + 8 + byteCount, padding, padded - byteCount );
	return 8 + padded;
}

bool toolPackGlb( const toolGltf* gltf, const char* path, uint8_t** bytes, size_t* byteCount, toolError* error )
{
	size_t most = 12 + 8 + gltf->jsonCount + 3 + 8 + gltf->binCount + 3 + gltf->restCount;
	if ( most > UINT32_MAX )
	{
		return toolFailFile(
		    error, path, "would have more than 4 GiB, which a GLB cannot: write fewer or shorter clips" );
	}
	uint8_t* out = toolAlloc( most, 1 );
	memcpy( out, "glTF", 4 );
	toolPutU32( out + 4, 2 );
	size_t at = 12;
	at += toolPutChunk( out + at, CHUNK_JSON, gltf->json, gltf->jsonCount, ' ' );
	if ( gltf->binCount > 0 )
	{
		at += toolPutChunk( out + at, CHUNK_BIN, gltf->bin, gltf->binCount, 0 );
	}
	if ( gltf->restCount > 0 )
	{
		memcpy( out + at, gltf->rest, gltf->restCount );
		at += gltf->restCount;
	}
	toolPutU32( out + 8, at );
	*bytes = out;
	*byteCount = at;
	return true;
}

static bool toolWriteGlb( const toolGltf* gltf, const char* path, toolError* error )
{
	uint8_t* bytes = NULL;
	size_t byteCount = 0;
	if ( toolPackGlb( gltf, path, &bytes, &byteCount, error ) == false )
	{
		return false;
	}
	bool good = toolWriteFile( path, bytes, byteCount, error );
	free( bytes );
	return good;
}

/// A file name as a relative address.
static char* toolMakeUri( const char* name )
{
	toolJsonText uri = { 0 };
	toolAddJson( &uri, "" );
	for ( ; *name != 0; ++name )
	{
		char c = *name;
		bool plain = ( c >= 'a' && c <= 'z' ) || ( c >= 'A' && c <= 'Z' ) || ( c >= '0' && c <= '9' ) ||
		    strchr( "-._~", c ) != NULL;
		char text[8];
		snprintf( text, sizeof text, plain ? "%c" : "%%%02X", (unsigned char)c );
		toolAddJson( &uri, text );
	}
	return uri.text;
}

/// The JSON with buffers[0] pointed to a file, or as it is where there is no buffer. *binCount becomes its length.
static char* toolPointToBin( const toolGltf* gltf, const char* name, size_t* textCount, size_t* binCount )
{
	toolJsonSummary summary;
	toolCheckJson( gltf->json, gltf->jsonCount, &summary );
	toolJsonEdits edits = { 0 };
	toolJsonRange buffers;
	toolJsonRange buffer;
	toolJsonRange length;
	if ( toolFindJsonMember( gltf->json, summary.root, "buffers", &buffers ) &&
	    toolFindJsonItem( gltf->json, buffers, 0, &buffer ) &&
	    toolFindJsonMember( gltf->json, buffer, "byteLength", &length ) )
	{
		double said = strtod( gltf->json + length.begin, NULL );
		*binCount = said < (double)*binCount ? (size_t)said : *binCount;
		char* uri = toolMakeUri( name );
		char* member = toolFormat( "\"uri\":\"%s\"", uri );
		toolAppendJson( &edits, gltf->json, buffer, member );
		free( member );
		free( uri );
	}
	else
	{
		*binCount = 0;
	}
	return toolApplyJsonEdits( &edits, gltf->json, gltf->jsonCount, textCount );
}

static bool toolFileIsThere( const char* path )
{
	FILE* file = fopen( path, "rb" );
	if ( file != NULL )
	{
		fclose( file );
	}
	return file != NULL;
}

static bool toolWriteText( const toolGltf* gltf, const char* path, toolError* error )
{
	char* folder = toolGetFolder( path );
	size_t stem = strlen( path ) - strlen( folder ) - 5; // without .gltf
	char* name = toolFormat( "%.*s.bin", (int)stem, path + strlen( folder ) );
	char* binPath = toolFormat( "%s%s", folder, name );
	size_t textCount = 0;
	size_t binCount = gltf->binCount;
	char* text = toolPointToBin( gltf, name, &textCount, &binCount );
	bool isNew = toolFileIsThere( binPath ) == false;
	bool good = binCount == 0 || toolWriteFile( binPath, gltf->bin, binCount, error );
	if ( good )
	{
		good = toolWriteFile( path, text, textCount, error );
		if ( good == false && binCount > 0 && isNew )
		{
			remove( binPath );
		}
	}
	free( text );
	free( binPath );
	free( name );
	free( folder );
	return good;
}

static bool toolEndsWith( const char* text, const char* ending )
{
	size_t length = strlen( text );
	size_t endingLength = strlen( ending );
	if ( length < endingLength )
	{
		return false;
	}
	for ( size_t i = 0; i < endingLength; ++i )
	{
		char c = text[length - endingLength + i];
		c = c >= 'A' && c <= 'Z' ? (char)( c - 'A' + 'a' ) : c;
		if ( c != ending[i] )
		{
			return false;
		}
	}
	return true;
}

bool toolWriteGltf( const toolGltf* gltf, const char* path, toolError* error )
{
	bool asText = toolEndsWith( path, ".gltf" );
	bool unchanged = gltf->changed == false && gltf->original != NULL && gltf->originalIsText == asText;
	if ( unchanged && gltf->originalHasFiles )
	{
		// what it names beside itself is only there in the same folder
		char* from = toolGetFolder( gltf->path );
		char* to = toolGetFolder( path );
		unchanged = strcmp( from, to ) == 0;
		free( from );
		free( to );
	}
	if ( unchanged )
	{
		return toolWriteFile( path, gltf->original, gltf->originalCount, error );
	}
	return asText ? toolWriteText( gltf, path, error ) : toolWriteGlb( gltf, path, error );
}
