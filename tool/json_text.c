// SPDX-License-Identifier: MIT
// Writes JSON: a text that grows, numbers that read back as they were, texts with what must be escaped.
#include "json_splice.h"

#include <stdlib.h>
#include <string.h>

void toolAddJsonBytes( toolJsonText* out, const char* text, size_t byteCount )
{
	if ( out->count + byteCount + 1 > out->capacity )
	{
		out->capacity = 2 * ( out->count + byteCount ) + 64;
		out->text = toolGrow( out->text, out->capacity, 1 );
	}
	memcpy( out->text + out->count, text, byteCount );
	out->count += byteCount;
	out->text[out->count] = 0;
}

void toolAddJson( toolJsonText* out, const char* text )
{
	toolAddJsonBytes( out, text, strlen( text ) );
}

void toolAddJsonInteger( toolJsonText* out, size_t number )
{
	char digits[32];
	snprintf( digits, sizeof digits, "%zu", number );
	toolAddJson( out, digits );
}

void toolAddJsonFloat( toolJsonText* out, float number )
{
	char digits[48];
	for ( int precision = 6; precision <= 9; ++precision )
	{
		snprintf( digits, sizeof digits, "%.*g", precision, (double)number );
		if ( strtof( digits, NULL ) == number )
		{
			break;
		}
	}
	// a host program may have set a locale with a decimal comma
	char* comma = strchr( digits, ',' );
	if ( comma != NULL )
	{
		*comma = '.';
	}
	toolAddJson( out, digits );
}

void toolAddJsonFloats( toolJsonText* out, const float* numbers, int32_t count )
{
	toolAddJson( out, "[" );
	for ( int32_t i = 0; i < count; ++i )
	{
		toolAddJson( out, i > 0 ? "," : "" );
		toolAddJsonFloat( out, numbers[i] );
	}
	toolAddJson( out, "]" );
}

size_t toolUtf8Length( const char* text )
{
	const unsigned char* s = (const unsigned char*)text;
	if ( s[0] < 0x80 )
	{
		return s[0] != 0 ? 1 : 0;
	}
	size_t length = s[0] >= 0xf0 ? 4 : ( s[0] >= 0xe0 ? 3 : 2 );
	if ( s[0] < 0xc2 || s[0] > 0xf4 )
	{
		return 0;
	}
	for ( size_t i = 1; i < length; ++i )
	{
		if ( ( s[i] & 0xc0 ) != 0x80 )
		{
			return 0;
		}
	}
	bool overlong = ( s[0] == 0xe0 && s[1] < 0xa0 ) || ( s[0] == 0xf0 && s[1] < 0x90 );
	bool surrogate = s[0] == 0xed && s[1] > 0x9f;
	bool beyond = s[0] == 0xf4 && s[1] > 0x8f;
	return overlong || surrogate || beyond ? 0 : length;
}

void toolAddJsonString( toolJsonText* out, const char* text )
{
	toolAddJson( out, "\"" );
	while ( *text != 0 )
	{
		size_t length = toolUtf8Length( text );
		unsigned char c = (unsigned char)*text;
		if ( length == 0 )
		{
			toolAddJson( out, "\xef\xbf\xbd" );
			length = 1;
		}
		else if ( c == '"' || c == '\\' )
		{
			char escape[3] = { '\\', *text, 0 };
			toolAddJson( out, escape );
		}
		else if ( c < 0x20 )
		{
			char escape[8];
			snprintf( escape, sizeof escape, "\\u%04x", c );
			toolAddJson( out, escape );
		}
		else
		{
			toolAddJsonBytes( out, text, length );
		}
		text += length;
	}
	toolAddJson( out, "\"" );
}
