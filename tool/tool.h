// SPDX-License-Identifier: MIT
// What all files of the program share: errors for people, memory, whole files, arguments, progress.
#ifndef TOOL_TOOL_H
#define TOOL_TOOL_H

#include "sole/base.h"

#include <stdio.h>

/// One line for a person: "FILE: what is wrong: what to do".
typedef struct toolError
{
	char text[512];
} toolError;

/// Formats the error and returns false, so that a check can say `return toolFail( error, ... )`.
bool toolFail( toolError* error, const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 2, 3 ) ) )
#endif
    ;
/// Puts the file that it is about before an error that does not name one; false.
bool toolFailIn( toolError* error, const char* path );

/// Zeroed memory for count items; ends the program with one line where there is none. Never called with sizes that a
/// file names but its length does not bear out.
void* toolAlloc( size_t count, size_t size );
/// Like realloc; new bytes are not cleared.
void* toolGrow( void* memory, size_t count, size_t size );
char* toolCopyString( const char* text );
/// printf into new memory.
char* toolFormat( const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 1, 2 ) ) )
#endif
    ;

/// The whole file, with a zero byte behind it. At most 1 GiB.
bool toolReadFile( const char* path, uint8_t** bytes, size_t* byteCount, toolError* error );
/// Writes beside the path first and renames then: whole or not at all.
bool toolWriteFile( const char* path, const void* bytes, size_t byteCount, toolError* error );

/// Percentage on stderr where that is a terminal; silent in a pipe. done from 0 to 1; 1 ends the line.
void toolProgress( const char* what, double done );

#endif
