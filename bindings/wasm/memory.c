// SPDX-License-Identifier: MIT
// malloc, calloc and free over the module's memory, for the few large pieces that rigs, grounds and characters are:
// nothing is allocated in a frame, so small beats fast.
//
// Free pieces are kept in a list in the order of their addresses; the first that is large enough is taken, and a piece
// that comes back is joined with its neighbours. Memory grows by whole pages when there is none.
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define PAGE ( (size_t)65536 )
#define ALIGNMENT ( (size_t)16 )

/// Before every piece. As large as the alignment, so that what follows is aligned.
typedef struct solePiece
{
	size_t byteCount; // with this head
	struct solePiece* next;
	uint32_t unused[2];
} solePiece;

_Static_assert( sizeof( solePiece ) == 16, "as large as the alignment" );

extern unsigned char __heap_base;
static solePiece* soleFreePieces;
static uintptr_t soleHeapEnd; // 0: not begun

static bool soleAreNeighbours( const solePiece* a, const solePiece* b )
{
	return (uintptr_t)a + a->byteCount == (uintptr_t)b;
}

static void soleGiveBack( solePiece* piece )
{
	solePiece* before = NULL;
	solePiece* after = soleFreePieces;
	while ( after != NULL && (uintptr_t)after < (uintptr_t)piece )
	{
		before = after;
		after = after->next;
	}
	piece->next = after;
	if ( after != NULL && soleAreNeighbours( piece, after ) )
	{
		piece->byteCount += after->byteCount;
		piece->next = after->next;
	}
	if ( before == NULL )
	{
		soleFreePieces = piece;
	}
	else if ( soleAreNeighbours( before, piece ) )
	{
		before->byteCount += piece->byteCount;
		before->next = piece->next;
	}
	else
	{
		before->next = piece;
	}
}

static bool soleGrowHeap( size_t byteCount )
{
	uintptr_t end = __builtin_wasm_memory_size( 0 ) * PAGE;
	if ( soleHeapEnd == 0 )
	{
		// What the module's first pages have left.
		uintptr_t start = ( (uintptr_t)&__heap_base + ALIGNMENT - 1 ) & ~( ALIGNMENT - 1 );
		soleHeapEnd = end;
		if ( end - start >= ALIGNMENT )
		{
			solePiece* piece = (solePiece*)start;
			piece->byteCount = end - start;
			soleGiveBack( piece );
		}
		return true;
	}
	size_t pages = ( byteCount + PAGE - 1 ) / PAGE;
	if ( __builtin_wasm_memory_grow( 0, pages ) == SIZE_MAX )
	{
		return false;
	}
	solePiece* piece = (solePiece*)end;
	piece->byteCount = pages * PAGE;
	soleGiveBack( piece );
	return true;
}

static solePiece* soleTakePiece( size_t byteCount )
{
	solePiece** link = &soleFreePieces;
	while ( *link != NULL && ( *link )->byteCount < byteCount )
	{
		link = &( *link )->next;
	}
	solePiece* piece = *link;
	if ( piece == NULL )
	{
		return NULL;
	}
	*link = piece->next;
	if ( piece->byteCount - byteCount >= 2 * sizeof( solePiece ) )
	{
		solePiece* rest = (solePiece*)( (uintptr_t)piece + byteCount );
		rest->byteCount = piece->byteCount - byteCount;
		rest->next = *link;
		*link = rest;
		piece->byteCount = byteCount;
	}
	return piece;
}

void* malloc( size_t byteCount )
{
	if ( byteCount > SIZE_MAX / 2 )
	{
		return NULL;
	}
	size_t whole = ( byteCount + sizeof( solePiece ) + ALIGNMENT - 1 ) & ~( ALIGNMENT - 1 );
	solePiece* piece = soleTakePiece( whole );
	while ( piece == NULL && soleGrowHeap( whole ) )
	{
		piece = soleTakePiece( whole );
	}
	return piece != NULL ? piece + 1 : NULL;
}

void free( void* memory )
{
	if ( memory != NULL )
	{
		soleGiveBack( (solePiece*)memory - 1 );
	}
}

void* calloc( size_t count, size_t size )
{
	if ( size != 0 && count > SIZE_MAX / size )
	{
		return NULL;
	}
	void* memory = malloc( count * size );
	if ( memory != NULL )
	{
		memset( memory, 0, count * size );
	}
	return memory;
}
