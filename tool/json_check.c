// SPDX-License-Identifier: MIT
// Checks that a text is JSON, strictly and without recursion: the grammar of RFC 8259.
#include "json_splice.h"

#include <string.h>

typedef struct toolJsonScan
{
	const char* text;
	size_t count;
	size_t at;
	const char* problem;
} toolJsonScan;

static bool toolScanFail( toolJsonScan* scan, const char* problem )
{
	scan->problem = problem;
	return false;
}

/// The byte at the reading place, 0 behind the end: no value or mark starts with it.
static char toolPeek( const toolJsonScan* scan )
{
	return scan->at < scan->count ? scan->text[scan->at] : 0;
}

static void toolSkipSpace( toolJsonScan* scan )
{
	while ( scan->at < scan->count && strchr( " \t\r\n", scan->text[scan->at] ) != NULL && scan->text[scan->at] != 0 )
	{
		++scan->at;
	}
}

static bool toolIsDigit( char c )
{
	return c >= '0' && c <= '9';
}

static bool toolIsHexDigit( char c )
{
	return toolIsDigit( c ) || ( c >= 'a' && c <= 'f' ) || ( c >= 'A' && c <= 'F' );
}

static bool toolScanEscape( toolJsonScan* scan )
{
	++scan->at; // the backslash
	char c = toolPeek( scan );
	++scan->at;
	if ( c == 'u' )
	{
		bool zero = true;
		for ( int i = 0; i < 4; ++i )
		{
			char digit = toolPeek( scan );
			if ( toolIsHexDigit( digit ) == false )
			{
				return toolScanFail( scan, "an escape is not complete" );
			}
			zero = zero && digit == '0';
			++scan->at;
		}
		return zero ? toolScanFail( scan, "a text has a zero character" ) : true;
	}
	if ( c == 0 || strchr( "\"\\/bfnrt", c ) == NULL )
	{
		return toolScanFail( scan, "an escape is unknown" );
	}
	return true;
}

static bool toolScanString( toolJsonScan* scan )
{
	if ( toolPeek( scan ) != '"' )
	{
		return toolScanFail( scan, "a text in quotes is missing" );
	}
	++scan->at;
	while ( scan->at < scan->count )
	{
		unsigned char c = (unsigned char)scan->text[scan->at];
		if ( c == '"' )
		{
			++scan->at;
			return true;
		}
		if ( c < 0x20 )
		{
			return toolScanFail( scan, "a text has a control character" );
		}
		if ( c != '\\' )
		{
			++scan->at;
		}
		else if ( toolScanEscape( scan ) == false )
		{
			return false;
		}
	}
	return toolScanFail( scan, "a text has no end" );
}

static bool toolScanDigits( toolJsonScan* scan )
{
	size_t begin = scan->at;
	while ( toolIsDigit( toolPeek( scan ) ) )
	{
		++scan->at;
	}
	return scan->at > begin ? true : toolScanFail( scan, "a number has no digits" );
}

static bool toolScanNumber( toolJsonScan* scan )
{
	if ( toolPeek( scan ) == '-' )
	{
		++scan->at;
	}
	if ( toolPeek( scan ) == '0' )
	{
		++scan->at; // no further digit may follow; what reads on will say so
	}
	else if ( toolScanDigits( scan ) == false )
	{
		return false;
	}
	if ( toolPeek( scan ) == '.' )
	{
		++scan->at;
		if ( toolScanDigits( scan ) == false )
		{
			return false;
		}
	}
	if ( toolPeek( scan ) == 'e' || toolPeek( scan ) == 'E' )
	{
		++scan->at;
		if ( toolPeek( scan ) == '+' || toolPeek( scan ) == '-' )
		{
			++scan->at;
		}
		return toolScanDigits( scan );
	}
	return true;
}

/// A value that is neither list nor object.
static bool toolScanScalar( toolJsonScan* scan )
{
	char c = toolPeek( scan );
	if ( c == '"' )
	{
		return toolScanString( scan );
	}
	if ( c == '-' || toolIsDigit( c ) )
	{
		return toolScanNumber( scan );
	}
	const char* words[] = { "true", "false", "null" };
	for ( int i = 0; i < 3; ++i )
	{
		size_t length = strlen( words[i] );
		if ( scan->count - scan->at >= length && memcmp( scan->text + scan->at, words[i], length ) == 0 )
		{
			scan->at += length;
			return true;
		}
	}
	return toolScanFail( scan, scan->at < scan->count ? "a value is missing" : "it ends early" );
}

static bool toolScanKey( toolJsonScan* scan, size_t* memberCount )
{
	toolSkipSpace( scan );
	if ( toolScanString( scan ) == false )
	{
		return false;
	}
	toolSkipSpace( scan );
	if ( toolPeek( scan ) != ':' )
	{
		return toolScanFail( scan, "a colon is missing" );
	}
	++scan->at;
	++*memberCount;
	return true;
}

/// Behind a value: closes what ends here. Afterwards either depth is 0 or a next value is due.
static bool toolScanBehindValue( toolJsonScan* scan, const char* open, int* depth, size_t* memberCount )
{
	while ( *depth > 0 )
	{
		toolSkipSpace( scan );
		char top = open[*depth - 1];
		char c = toolPeek( scan );
		if ( c == ',' )
		{
			++scan->at;
			return top == '{' ? toolScanKey( scan, memberCount ) : true;
		}
		if ( c != ( top == '{' ? '}' : ']' ) )
		{
			return toolScanFail( scan, scan->at < scan->count ? "a comma or bracket is missing" : "it ends early" );
		}
		++scan->at;
		--*depth;
	}
	return true;
}

static bool toolScanRoot( toolJsonScan* scan, size_t* memberCount )
{
	char open[TOOL_JSON_DEPTH];
	int depth = 0;
	do
	{
		toolSkipSpace( scan );
		char c = toolPeek( scan );
		if ( c != '{' && c != '[' )
		{
			if ( toolScanScalar( scan ) == false )
			{
				return false;
			}
		}
		else
		{
			if ( depth == TOOL_JSON_DEPTH )
			{
				return toolScanFail( scan, "it nests too deep" );
			}
			++scan->at;
			open[depth] = c;
			++depth;
			toolSkipSpace( scan );
			if ( toolPeek( scan ) != ( c == '{' ? '}' : ']' ) )
			{
				if ( c == '{' && toolScanKey( scan, memberCount ) == false )
				{
					return false;
				}
				continue;
			}
			++scan->at;
			--depth;
		}
		if ( toolScanBehindValue( scan, open, &depth, memberCount ) == false )
		{
			return false;
		}
	} while ( depth > 0 );
	return true;
}

bool toolCheckJson( const char* text, size_t byteCount, toolJsonSummary* summary )
{
	*summary = ( toolJsonSummary ){ 0 };
	toolJsonScan scan = { .text = text, .count = byteCount };
	toolSkipSpace( &scan );
	summary->root.begin = scan.at;
	bool good = toolScanRoot( &scan, &summary->memberCount );
	summary->root.end = scan.at;
	while ( good && scan.at < byteCount )
	{
		if ( text[scan.at] != 0 && strchr( " \t\r\n", text[scan.at] ) == NULL )
		{
			good = toolScanFail( &scan, "something follows behind its end" );
			break;
		}
		++scan.at;
	}
	summary->badAt = scan.at;
	summary->problem = scan.problem;
	return good;
}
