// SPDX-License-Identifier: MIT
// The commands of the program: one file cmd_NAME.c each, listed in main.c. Arguments are read with getopt_long.
#ifndef TOOL_COMMAND_H
#define TOOL_COMMAND_H

#include "tool.h"

/// Exit statuses of the program.
enum
{
	tool_done = 0,
	tool_failed = 1,
	tool_wrongUsage = 2
};

/// Prints "sole: TEXT" on stderr. @return tool_failed
int toolReportFailure( const toolError* error );
/// Prints "sole COMMAND: WHAT: see 'sole COMMAND --help'" on stderr. @return tool_wrongUsage
int toolReportUsage( const char* command, const char* what );

/// A finite number from the command line; false where the text is none.
bool toolParseNumber( const char* text, double* number );
/// The same within limits.
bool toolParseRange( const char* text, double low, double high, double* number );
/// "x,z" or "x,y,z", none beyond 10,000 km. @return how many numbers there were, or 0.
int toolParsePoint( const char* text, double point[3] );

int toolRunSample( int argc, char** argv );
int toolRunInspect( int argc, char** argv );
int toolRunBake( int argc, char** argv );
int toolRunMeasure( int argc, char** argv );
/// measure --table
int toolRunMeasureTable( int argc, char** argv );
int toolRunCompare( int argc, char** argv );
int toolRunReport( int argc, char** argv );
int toolRunLabel( int argc, char** argv );
int toolRunReplay( int argc, char** argv );
int toolRunSettings( int argc, char** argv );

#endif
