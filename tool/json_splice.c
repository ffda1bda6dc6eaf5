// SPDX-License-Identifier: MIT
// Finds values in a checked JSON text and edits the text at their bytes.
#include "json_splice.h"

#include <stdlib.h>
#include <string.h>

typedef struct toolJsonEdit
{
	toolJsonRange range;
	char* text;
} toolJsonEdit;

static bool toolIsSpace( char c )
{
	return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

static size_t toolSkipSpaceAt( const char* text, size_t at )
{
	while ( toolIsSpace( text[at] ) )
	{
		++at;
	}
	return at;
}

static size_t toolSkipStringAt( const char* text, size_t at )
{
	for ( ++at; text[at] != '"'; ++at )
	{
		at += text[at] == '\\' ? 1 : 0;
	}
	return at + 1;
}

/// The place behind the value at this place.
static size_t toolSkipValueAt( const char* text, size_t at, size_t end )
{
	size_t depth = 0;
	while ( at < end )
	{
		char c = text[at];
		if ( c == '"' )
		{
			at = toolSkipStringAt( text, at );
		}
		else if ( c == '{' || c == '[' )
		{
			++depth;
			++at;
			continue;
		}
		else if ( depth > 0 && ( c == '}' || c == ']' ) )
		{
			--depth;
			++at;
		}
		else if ( depth > 0 )
		{
			++at;
			continue;
		}
		else
		{
			while ( at < end && strchr( ",]} \t\r\n", text[at] ) == NULL )
			{
				++at;
			}
		}
		if ( depth == 0 )
		{
			break;
		}
	}
	return at;
}

/// Compares a key, quotes included, with plain ASCII.
static bool toolKeyIs( const char* text, size_t begin, size_t end, const char* key )
{
	size_t at = begin + 1;
	while ( at + 1 < end )
	{
		int c = (unsigned char)text[at];
		if ( c == '\\' && text[at + 1] == 'u' )
		{
			char digits[5] = { 0 };
			memcpy( digits, text + at + 2, 4 );
			c = (int)strtol( digits, NULL, 16 );
			at += 6;
		}
		else if ( c == '\\' )
		{
			// control characters are in no key that is looked for
			c = strchr( "\"\\/", text[at + 1] ) != NULL ? (unsigned char)text[at + 1] : 1;
			at += 2;
		}
		else
		{
			++at;
		}
		if ( c != (unsigned char)*key )
		{
			return false;
		}
		++key;
	}
	return *key == 0;
}

bool toolFindJsonMember( const char* text, toolJsonRange object, const char* key, toolJsonRange* value )
{
	size_t at = object.begin + 1;
	while ( text[object.begin] == '{' && at < object.end )
	{
		at = toolSkipSpaceAt( text, at );
		if ( text[at] == '}' )
		{
			return false;
		}
		size_t keyBegin = at;
		size_t keyEnd = toolSkipStringAt( text, at );
		at = toolSkipSpaceAt( text, keyEnd ) + 1; // the colon
		at = toolSkipSpaceAt( text, at );
		value->begin = at;
		value->end = toolSkipValueAt( text, at, object.end );
		if ( toolKeyIs( text, keyBegin, keyEnd, key ) )
		{
			return true;
		}
		at = toolSkipSpaceAt( text, value->end ) + 1; // the comma
	}
	return false;
}

bool toolFindJsonItem( const char* text, toolJsonRange array, size_t index, toolJsonRange* value )
{
	size_t at = array.begin + 1;
	while ( text[array.begin] == '[' && at < array.end )
	{
		at = toolSkipSpaceAt( text, at );
		if ( text[at] == ']' )
		{
			return false;
		}
		value->begin = at;
		value->end = toolSkipValueAt( text, at, array.end );
		if ( index == 0 )
		{
			return true;
		}
		--index;
		at = toolSkipSpaceAt( text, value->end ) + 1; // the comma
	}
	return false;
}

size_t toolCountJsonItems( const char* text, toolJsonRange array )
{
	size_t count = 0;
	size_t at = array.begin + 1;
	while ( text[array.begin] == '[' && at < array.end )
	{
		at = toolSkipSpaceAt( text, at );
		if ( text[at] == ']' )
		{
			break;
		}
		++count;
		at = toolSkipSpaceAt( text, toolSkipValueAt( text, at, array.end ) ) + 1; // the comma
	}
	return count;
}

static void toolAddEdit( toolJsonEdits* edits, toolJsonRange range, char* text )
{
	edits->edits = toolGrow( edits->edits, edits->count + 1, sizeof( toolJsonEdit ) );
	edits->edits[edits->count] = ( toolJsonEdit ){ .range = range, .text = text };
	++edits->count;
}

void toolReplaceJson( toolJsonEdits* edits, toolJsonRange range, const char* text )
{
	toolAddEdit( edits, range, toolCopyString( text ) );
}

void toolAppendJson( toolJsonEdits* edits, const char* text, toolJsonRange container, const char* items )
{
	size_t at = container.end - 1; // the closing bracket
	while ( toolIsSpace( text[at - 1] ) )
	{
		--at;
	}
	bool empty = at == container.begin + 1;
	toolAddEdit( edits, ( toolJsonRange ){ at, at }, toolFormat( "%s%s", empty ? "" : ",", items ) );
}

char* toolApplyJsonEdits( toolJsonEdits* edits, const char* text, size_t byteCount, size_t* newCount )
{
	// a handful of edits: insertion sort, which is stable
	for ( size_t i = 1; i < edits->count; ++i )
	{
		for ( size_t j = i; j > 0 && edits->edits[j].range.begin < edits->edits[j - 1].range.begin; --j )
		{
			toolJsonEdit swap = edits->edits[j];
			edits->edits[j] = edits->edits[j - 1];
			edits->edits[j - 1] = swap;
		}
	}
	toolJsonText out = { 0 };
	size_t at = 0;
	for ( size_t i = 0; i < edits->count; ++i )
	{
		toolJsonEdit* edit = edits->edits + i;
		toolAddJsonBytes( &out, text + at, edit->range.begin - at );
		toolAddJson( &out, edit->text );
		at = edit->range.end;
		free( edit->text );
	}
	toolAddJsonBytes( &out, text + at, byteCount - at );
	free( edits->edits );
	*edits = ( toolJsonEdits ){ 0 };
	*newCount = out.count;
	return out.text;
}
