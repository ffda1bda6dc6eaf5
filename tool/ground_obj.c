// SPDX-License-Identifier: MIT
// Triangles of a Wavefront OBJ file: v and f lines; what else such files have says nothing about the ground.
#include "gltf_internal.h"
#include "ground_file.h"

#include <stdlib.h>
#include <string.h>

typedef struct toolObj
{
	const char* path;
	const uint8_t* bytes;
	size_t byteCount;
	size_t at;
	int32_t line; // where the current one began, for messages
	int32_t nextLine;
	char* text; // the current line with its continuations, terminated
	size_t textCount;
	size_t textCapacity;
	toolGroundMesh* ground;
	size_t vertexCapacity;
	size_t triangleCapacity;
	toolError* error;
} toolObj;

static void toolAddObjChar( toolObj* obj, char c )
{
	if ( obj->textCount + 1 >= obj->textCapacity )
	{
		obj->textCapacity = 2 * obj->textCapacity + 256;
		obj->text = toolGrow( obj->text, obj->textCapacity, 1 );
	}
	obj->text[obj->textCount] = c;
	++obj->textCount;
}

/// The next line; those that end with a backslash go on. False behind the last one.
static bool toolNextObjLine( toolObj* obj )
{
	obj->textCount = 0;
	obj->line = obj->nextLine;
	bool any = obj->at < obj->byteCount;
	while ( obj->at < obj->byteCount )
	{
		char c = (char)obj->bytes[obj->at];
		++obj->at;
		if ( c != '\n' )
		{
			toolAddObjChar( obj, c );
			continue;
		}
		++obj->nextLine;
		while ( obj->textCount > 0 && obj->text[obj->textCount - 1] == '\r' )
		{
			--obj->textCount;
		}
		if ( obj->textCount == 0 || obj->text[obj->textCount - 1] != '\\' )
		{
			break;
		}
		obj->text[obj->textCount - 1] = ' ';
	}
	toolAddObjChar( obj, 0 );
	return any;
}

static bool toolIsBlank( char c )
{
	return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

static const char* toolSkipBlanks( const char* text )
{
	while ( toolIsBlank( *text ) )
	{
		++text;
	}
	return text;
}

/// A plain decimal number. strtof alone also takes words, hexadecimals and what is too large.
static bool toolReadObjNumber( const char** text, float* number )
{
	const char* begin = toolSkipBlanks( *text );
	size_t length = strspn( begin, "+-.0123456789eE" );
	char* end = NULL;
	*number = strtof( begin, &end );
	bool good = length > 0 && end == begin + length && ( *end == 0 || toolIsBlank( *end ) ) && soleIsFinite( *number );
	*text = end;
	return good;
}

static bool toolReadObjVertex( toolObj* obj, const char* text )
{
	toolGroundMesh* ground = obj->ground;
	if ( (size_t)ground->vertexCount == obj->vertexCapacity )
	{
		obj->vertexCapacity = 2 * obj->vertexCapacity + 64;
		ground->positions = toolGrow( ground->positions, 3 * obj->vertexCapacity, sizeof( float ) );
	}
	// a fourth number or a colour may follow
	for ( size_t i = 0; i < 3; ++i )
	{
		if ( toolReadObjNumber( &text, ground->positions + 3 * (size_t)ground->vertexCount + i ) == false )
		{
			return toolFailFile(
			    obj->error, obj->path, "line %d: a vertex needs three finite numbers: export it again", obj->line );
		}
	}
	++ground->vertexCount;
	return true;
}

/// The vertex of a corner like 7, 7/1, 7//3, 7/1/3, -1. Moves on behind it.
static bool toolReadObjCorner( toolObj* obj, const char** text, uint32_t* vertex )
{
	char* end = NULL;
	long index = strtol( *text, &end, 10 );
	bool good = end != *text;
	*text = end;
	*text += strspn( *text, "/-+0123456789" );
	good = good && ( *end == '/' || *text == end ) && ( **text == 0 || toolIsBlank( **text ) );
	if ( good == false )
	{
		return toolFailFile(
		    obj->error, obj->path, "line %d: a corner of a face is no number: export it again", obj->line );
	}
	long count = obj->ground->vertexCount;
	long at = index > 0 ? index - 1 : count + index;
	if ( index == 0 || index > count || index < -count )
	{
		return toolFailFile( obj->error, obj->path, "line %d: a face names vertex %ld of %ld: export it again",
		    obj->line, index, count );
	}
	*vertex = (uint32_t)at;
	return true;
}

static void toolAddObjTriangle( toolObj* obj, uint32_t a, uint32_t b, uint32_t c )
{
	toolGroundMesh* ground = obj->ground;
	if ( (size_t)ground->triangleCount == obj->triangleCapacity )
	{
		obj->triangleCapacity = 2 * obj->triangleCapacity + 64;
		ground->indices = toolGrow( ground->indices, 3 * obj->triangleCapacity, sizeof( uint32_t ) );
	}
	uint32_t* out = ground->indices + 3 * (size_t)ground->triangleCount;
	out[0] = a;
	out[1] = b;
	out[2] = c;
	++ground->triangleCount;
}

static bool toolReadObjFace( toolObj* obj, const char* text )
{
	uint32_t first = 0;
	uint32_t before = 0;
	size_t corners = 0;
	text = toolSkipBlanks( text );
	while ( *text != 0 && *text != '#' )
	{
		uint32_t vertex = 0;
		if ( toolReadObjCorner( obj, &text, &vertex ) == false )
		{
			return false;
		}
		if ( corners >= 2 )
		{
			toolAddObjTriangle( obj, first, before, vertex );
		}
		first = corners == 0 ? vertex : first;
		before = vertex;
		++corners;
		text = toolSkipBlanks( text );
	}
	return corners >= 3 ||
	    toolFailFile(
	        obj->error, obj->path, "line %d: a face has fewer than three corners: export it again", obj->line );
}

static bool toolReadObjLine( toolObj* obj )
{
	if ( memchr( obj->text, 0, obj->textCount - 1 ) != NULL )
	{
		return toolFailFile( obj->error, obj->path, "line %d is no text: give an .obj file", obj->line );
	}
	const char* text = toolSkipBlanks( obj->text );
	if ( ( text[0] != 'v' && text[0] != 'f' ) || toolIsBlank( text[1] ) == false )
	{
		return true;
	}
	return text[0] == 'v' ? toolReadObjVertex( obj, text + 1 ) : toolReadObjFace( obj, text + 1 );
}

bool toolReadObjBytes(
    const uint8_t* bytes, size_t byteCount, const char* path, toolGroundMesh* ground, toolError* error )
{
	*ground = ( toolGroundMesh ){ 0 };
	toolObj obj = {
		.path = path, .bytes = bytes, .byteCount = byteCount, .nextLine = 1, .ground = ground, .error = error
	};
	bool good = true;
	while ( good && toolNextObjLine( &obj ) )
	{
		good = toolReadObjLine( &obj );
	}
	free( obj.text );
	if ( good && ground->triangleCount == 0 )
	{
		good = toolFailFile( error, path, "has no triangles: export the ground as a mesh" );
	}
	if ( good == false )
	{
		toolFreeGroundMesh( ground );
	}
	return good;
}
