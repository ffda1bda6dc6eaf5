// SPDX-License-Identifier: MIT
// What the commands share: messages and numbers from the command line.
#include "command.h"

#include <math.h>
#include <stdlib.h>

int toolReportFailure( const toolError* error )
{
	fprintf( stderr, "sole: %s\n", error->text );
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

int toolParsePoint( const char* text, double point[3] )
{
	int count = 0;
	while ( count < 3 )
	{
		char* end = NULL;
		point[count] = strtod( text, &end );
		if ( end == text || isfinite( point[count] ) == 0 )
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
