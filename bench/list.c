// SPDX-License-Identifier: MIT
// What the programs share: the list of cases, memory that is there or ends the program, the clock, an order of times.
#define _POSIX_C_SOURCE 199309L

#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void* benchAlloc( size_t count, size_t size )
{
	void* memory = calloc( count > 0 ? count : 1, size );
	if ( memory == NULL )
	{
		fprintf( stderr, "sole_bench: out of memory: use a smaller --largest\n" );
		exit( 1 );
	}
	return memory;
}

void benchAdd( benchList* list, benchCase added )
{
	if ( list->count == list->capacity )
	{
		int32_t capacity = list->capacity == 0 ? 64 : 2 * list->capacity;
		benchCase* cases = benchAlloc( (size_t)capacity, sizeof *cases );
		if ( list->count > 0 )
		{
			memcpy( cases, list->cases, (size_t)list->count * sizeof *cases );
		}
		free( list->cases );
		list->cases = cases;
		list->capacity = capacity;
	}
	list->cases[list->count] = added;
	list->count += 1;
}

const char* benchName( const char* stem, int64_t size )
{
	// Never freed: cases name them until the end.
	char* name = benchAlloc( 64, 1 );
	if ( size % 1000000 == 0 )
	{
		snprintf( name, 64, "%s-%dM", stem, (int)( size / 1000000 ) );
	}
	else if ( size % 1000 == 0 )
	{
		snprintf( name, 64, "%s-%dk", stem, (int)( size / 1000 ) );
	}
	else
	{
		snprintf( name, 64, "%s-%d", stem, (int)size );
	}
	return name;
}

double benchNow( void )
{
	struct timespec t;
	clock_gettime( CLOCK_MONOTONIC, &t );
	return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

int benchCompare( const void* a, const void* b )
{
	double x = *(const double*)a;
	double y = *(const double*)b;
	return x < y ? -1 : ( x > y ? 1 : 0 );
}
