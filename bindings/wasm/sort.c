// SPDX-License-Identifier: MIT
// qsort as a heap sort, a fifth of libc's in size: what is sorted are some thousands of heights when a rig or labels
// are made. J. W. J. Williams, "Algorithm 232: Heapsort", 1964.
#include <stddef.h>
#include <stdlib.h>

typedef int soleCompareFcn( const void*, const void* );

static void soleSwap( unsigned char* a, unsigned char* b, size_t size )
{
	for ( size_t i = 0; i < size; ++i )
	{
		unsigned char byte = a[i];
		a[i] = b[i];
		b[i] = byte;
	}
}

/// Lets the item at a place sink until none below it is greater.
static void soleSink( unsigned char* items, size_t at, size_t count, size_t size, soleCompareFcn* compare )
{
	for ( size_t below = 2 * at + 1; below < count; below = 2 * at + 1 )
	{
		size_t next = below + 1;
		below += next < count && compare( items + next * size, items + below * size ) > 0 ? 1 : 0;
		if ( compare( items + at * size, items + below * size ) >= 0 )
		{
			return;
		}
		soleSwap( items + at * size, items + below * size, size );
		at = below;
	}
}

void qsort( void* base, size_t count, size_t size, soleCompareFcn* compare )
{
	unsigned char* items = base;
	for ( size_t i = count / 2; i > 0; --i )
	{
		soleSink( items, i - 1, count, size, compare );
	}
	for ( size_t end = count; end > 1; --end )
	{
		soleSwap( items, items + ( end - 1 ) * size, size );
		soleSink( items, 0, end - 1, size, compare );
	}
}
