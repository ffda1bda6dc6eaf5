// SPDX-License-Identifier: MIT
// What the commands share: messages and numbers from the command line.
#include "command.h"

#include <math.h>
#include <stdlib.h>

#define FURTHEST_PLACE 1e7 // m

int toolReportFailure( const toolError* error )
{
	// What a file puts into a message stays on its one line.
	toolError clean = *error;
	for ( char* c = clean.text; *c != 0; ++c )
	{
		*c = (unsigned char)*c < 0x20 || *c == 0x7f ? '?' : *c;
	}
	fprintf( stderr, "sole: %s\n", clean.text );
	return tool_failed;
}

int toolReportUsage( const char* command, const char* what )
{
	fprintf( stderr, "sole %s: %s: see 'sole %s --help'\n", command, what, command );
	return tool_wrongUsage;
}

bool toolParseNumber( const char* text, double* number )
{
	char* end = NULL;
	double value = strtod( text, &end );
	if ( end == text || *end != 0 || isfinite( value ) == 0 )
	{
		return false;
	}
	*number = value;
	return true;
}

bool toolParseRange( const char* text, double low, double high, double* number )
{
	return toolParseNumber( text, number ) && *number >= low && *number <= high;
}

int toolParsePoint( const char* text, double point[3] )
{
	int count = 0;
	while ( count < 3 )
	{
		char* end = NULL;
		point[count] = strtod( text, &end );
		if ( end == text || !( fabs( point[count] ) <= FURTHEST_PLACE ) )
		{
			return 0;
		}
		++count;
		if ( *end == 0 )
		{
			return count >= 2 ? count : 0;
		}
		if ( *end != ',' )
		{
			return 0;
		}
		text = end + 1;
	}
	return 0;
}
