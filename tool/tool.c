// SPDX-License-Identifier: MIT
// Errors, memory, whole files and progress for the program.
#define _POSIX_C_SOURCE 200809L
#include "tool.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define FILE_LIMIT ( (size_t)1 << 30 )

bool toolFail( toolError* error, const char* format, ... )
{
	if ( error != NULL )
	{
		va_list arguments;
		va_start( arguments, format );
		vsnprintf( error->text, sizeof error->text, format, arguments );
		va_end( arguments );
	}
	return false;
}

bool toolFailIn( toolError* error, const char* path )
{
	toolError inner = *error;
	return toolFail( error, "%s: %s", path, inner.text );
}

static void toolDieOfMemory( void )
{
	fputs( "sole: out of memory: close other programs or use a smaller file\n", stderr );
	exit( 1 );
}

void* toolAlloc( size_t count, size_t size )
{
	void* memory = calloc( count > 0 ? count : 1, size );
	if ( memory == NULL )
	{
		toolDieOfMemory();
	}
	return memory;
}

void* toolGrow( void* memory, size_t count, size_t size )
{
	if ( size != 0 && count > SIZE_MAX / size )
	{
		toolDieOfMemory();
	}
	void* grown = realloc( memory, count * size > 0 ? count * size : 1 );
	if ( grown == NULL )
	{
		toolDieOfMemory();
	}
	return grown;
}

char* toolCopyString( const char* text )
{
	size_t length = strlen( text );
	char* copy = toolAlloc( length + 1, 1 );
	memcpy( copy, text, length );
	return copy;
}

char* toolFormat( const char* format, ... )
{
	va_list arguments;
	va_start( arguments, format );
	va_list again;
	va_copy( again, arguments );
	int length = vsnprintf( NULL, 0, format, arguments );
	va_end( arguments );
	char* text = toolAlloc( length > 0 ? (size_t)length + 1 : 1, 1 );
	if ( length > 0 )
	{
		vsnprintf( text, (size_t)length + 1, format, again );
	}
	va_end( again );
	return text;
}

bool toolReadFile( const char* path, uint8_t** bytes, size_t* byteCount, toolError* error )
{
	*bytes = NULL;
	*byteCount = 0;
	struct stat info;
	if ( stat( path, &info ) != 0 )
	{
		return toolFail( error, "%s: cannot be read (%s): check the path", path, strerror( errno ) );
	}
	if ( S_ISREG( info.st_mode ) == 0 )
	{
		return toolFail( error, "%s: is not a file: give the path of a file", path );
	}
	if ( (size_t)info.st_size > FILE_LIMIT )
	{
		return toolFail( error, "%s: is larger than 1 GiB: split it", path );
	}
	FILE* file = fopen( path, "rb" );
	if ( file == NULL )
	{
		return toolFail( error, "%s: cannot be read (%s): check its permissions", path, strerror( errno ) );
	}
	size_t size = (size_t)info.st_size;
	uint8_t* memory = toolAlloc( size + 1, 1 );
	size_t got = fread( memory, 1, size, file );
	fclose( file );
	if ( got != size )
	{
		free( memory );
		return toolFail( error, "%s: ended early while being read: try again", path );
	}
	*bytes = memory;
	*byteCount = size;
	return true;
}

bool toolWriteFile( const char* path, const void* bytes, size_t byteCount, toolError* error )
{
	char* beside = toolFormat( "%s.%ld.tmp", path, (long)getpid() );
	FILE* file = fopen( beside, "wb" );
	if ( file == NULL )
	{
		toolFail( error, "%s: cannot be written (%s): check the folder and its permissions", path, strerror( errno ) );
		free( beside );
		return false;
	}
	bool good = fwrite( bytes, 1, byteCount, file ) == byteCount;
	good = fclose( file ) == 0 && good;
	good = good && rename( beside, path ) == 0;
	if ( good == false )
	{
		toolFail( error, "%s: cannot be written (%s): check the folder and its space", path, strerror( errno ) );
		remove( beside );
	}
	free( beside );
	return good;
}

void toolProgress( const char* what, double done )
{
	static int last = -1;
	if ( isatty( fileno( stderr ) ) == 0 )
	{
		return;
	}
	int percent = (int)( done * 100.0 );
	if ( percent == last && done < 1.0 )
	{
		return;
	}
	last = done < 1.0 ? percent : -1;
	fprintf( stderr, "\r%s %3d %%%s", what, percent, done < 1.0 ? "" : "\n" );
}
