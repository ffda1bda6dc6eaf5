// SPDX-License-Identifier: MIT
// Assertions, allocation and messages.
#include "base/core.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static soleAssertFcn* soleAssertHandler = NULL; // the one documented global of the library

soleVersion soleGetVersion( void )
{
	return ( soleVersion ){ SOLE_VERSION_MAJOR, SOLE_VERSION_MINOR, SOLE_VERSION_PATCH };
}

void soleSetAssertHandler( soleAssertFcn* handler )
{
	soleAssertHandler = handler;
}

void soleReportAssert( const char* condition, const char* file, int line )
{
	if ( soleAssertHandler != NULL )
	{
		if ( soleAssertHandler( condition, file, line ) )
		{
			abort();
		}
		return;
	}
#ifndef NDEBUG
	fprintf( stderr, "sole: %s:%d: %s\n", file, line, condition );
	abort();
#endif
}

void* soleAlloc( const soleAllocator* allocator, size_t byteCount )
{
	if ( allocator == NULL )
	{
		return calloc( 1, byteCount );
	}
	void* memory = allocator->alloc( byteCount, allocator->user );
	if ( memory != NULL )
	{
		memset( memory, 0, byteCount );
	}
	return memory;
}

void soleFree( const soleAllocator* allocator, void* memory, size_t byteCount )
{
	if ( memory == NULL )
	{
		return;
	}
	if ( allocator == NULL )
	{
		free( memory );
		return;
	}
	allocator->free( memory, byteCount, allocator->user );
}

void soleSetMessage( soleMessage* message, const char* format, ... )
{
	if ( message == NULL )
	{
		return;
	}
	va_list arguments;
	va_start( arguments, format );
	vsnprintf( message->text, sizeof message->text, format, arguments );
	va_end( arguments );
}
