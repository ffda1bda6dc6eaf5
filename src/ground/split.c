// SPDX-License-Identifier: MIT
// Cutting a range of triangles in two. World space.
//
// Where the surface area heuristic is least: triangles are counted into bins along each axis by the middle of their
// box, and of all cuts between bins the one with the least
//   area( left ) blocks( left ) + area( right ) blocks( right ),  blocks( n ) = n / 4 rounded up
// is taken (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007). Short ranges are sorted along
// the axis of that cut and cut at the nearest multiple of four: so all blocks but one are full, and memory is not spent
// on free places.
#include "ground/split.h"

#include "base/core.h"

#define BIN_COUNT 12
#define SORTED_COUNT 64 // ranges up to this are sorted

typedef struct soleBin
{
	soleBox box;
	int32_t count;
} soleBin;

/// Middle of a box times two.
static float soleBox_GetMiddle( const soleBox* box, int axis )
{
	return box->lower[axis] + box->upper[axis];
}

static int32_t soleGetBin( float middle, float low, float scale )
{
	int32_t bin = (int32_t)( ( middle - low ) * scale );
	return bin < 0 ? 0 : ( bin < BIN_COUNT ? bin : BIN_COUNT - 1 );
}

static int32_t soleCountBlocks( int32_t triangleCount )
{
	return ( triangleCount + SOLE_GROUND_BLOCK_SIZE - 1 ) / SOLE_GROUND_BLOCK_SIZE;
}

/// A way to cut a range: triangles in bins up to and including `bin` go left.
typedef struct soleCut
{
	int axis; // -1: none
	int32_t bin;
	int32_t leftCount;
	float low;
	float scale;
	double cost;
} soleCut;

/// Sums up the bins from the left, and takes a cut between two if it beats the one so far.
static void soleCompareCuts( const soleBin bins[BIN_COUNT], const soleCut* axis, int32_t count, soleCut* best )
{
	double rightCost[BIN_COUNT];
	soleBox box = soleBox_Empty();
	int32_t right = 0;
	for ( int32_t i = BIN_COUNT - 1; i > 0; --i )
	{
		soleBox_Add( &box, &bins[i].box );
		right += bins[i].count;
		rightCost[i] = right > 0 ? soleBox_GetArea( &box ) * (double)soleCountBlocks( right ) : 0.0;
	}
	box = soleBox_Empty();
	int32_t left = 0;
	for ( int32_t i = 0; i + 1 < BIN_COUNT; ++i )
	{
		soleBox_Add( &box, &bins[i].box );
		left += bins[i].count;
		if ( left == 0 || left == count )
		{
			continue;
		}
		double cost = soleBox_GetArea( &box ) * (double)soleCountBlocks( left ) + rightCost[i + 1];
		if ( best->axis < 0 || cost < best->cost )
		{
			*best = *axis;
			best->bin = i;
			best->leftCount = left;
			best->cost = cost;
		}
	}
}

/// Best cut across one axis, if it beats the one so far.
static void soleTryAxis( const soleReference* references, const soleRange* range, int axis, soleCut* best )
{
	float low = INFINITY;
	float high = -INFINITY;
	for ( int32_t i = range->first; i < range->first + range->count; ++i )
	{
		float middle = soleBox_GetMiddle( &references[i].box, axis );
		low = soleMinF( low, middle );
		high = soleMaxF( high, middle );
	}
	float scale = (float)BIN_COUNT / ( high - low );
	if ( !( high > low ) || !soleIsFinite( scale ) || !( scale > 0.0f ) )
	{
		return;
	}
	soleBin bins[BIN_COUNT];
	for ( int32_t i = 0; i < BIN_COUNT; ++i )
	{
		bins[i] = ( soleBin ){ .box = soleBox_Empty(), .count = 0 };
	}
	for ( int32_t i = range->first; i < range->first + range->count; ++i )
	{
		const soleBox* box = &references[i].box;
		soleBin* bin = bins + soleGetBin( soleBox_GetMiddle( box, axis ), low, scale );
		soleBox_Add( &bin->box, box );
		bin->count += 1;
	}
	soleCut cut = { .axis = axis, .low = low, .scale = scale };
	soleCompareCuts( bins, &cut, range->count, best );
}

static void soleSwapReferences( soleReference* references, int32_t a, int32_t b )
{
	soleReference reference = references[a];
	references[a] = references[b];
	references[b] = reference;
}

/// Moves the triangles left of the cut to the front.
static void solePartition( soleReference* references, const soleRange* range, const soleCut* cut )
{
	int32_t left = range->first;
	for ( int32_t i = range->first; i < range->first + range->count; ++i )
	{
		float middle = soleBox_GetMiddle( &references[i].box, cut->axis );
		if ( soleGetBin( middle, cut->low, cut->scale ) <= cut->bin )
		{
			soleSwapReferences( references, left, i );
			left += 1;
		}
	}
	SOLE_ASSERT( left - range->first == cut->leftCount );
}

/// Orders a short range along an axis, equals by their index.
static void soleSortRange( soleReference* references, const soleRange* range, int axis )
{
	for ( int32_t i = range->first + 1; i < range->first + range->count; ++i )
	{
		soleReference moved = references[i];
		float middle = soleBox_GetMiddle( &moved.box, axis );
		int32_t place = i;
		while ( place > range->first )
		{
			const soleReference* before = references + place - 1;
			float other = soleBox_GetMiddle( &before->box, axis );
			if ( other < middle || ( other == middle && before->index < moved.index ) )
			{
				break;
			}
			references[place] = *before;
			place -= 1;
		}
		references[place] = moved;
	}
}

soleRange soleMakeRange( const soleReference* references, int32_t first, int32_t count )
{
	soleRange range = { soleBox_Empty(), first, count };
	for ( int32_t i = first; i < first + count; ++i )
	{
		soleBox_Add( &range.box, &references[i].box );
	}
	return range;
}

/// The nearest multiple of a block that leaves something on both sides.
static int32_t soleRoundToBlocks( int32_t left, int32_t count )
{
	int32_t blocks = ( left + SOLE_GROUND_BLOCK_SIZE / 2 ) / SOLE_GROUND_BLOCK_SIZE;
	int32_t most = ( count - 1 ) / SOLE_GROUND_BLOCK_SIZE;
	blocks = blocks < 1 ? 1 : ( blocks < most ? blocks : most );
	return blocks * SOLE_GROUND_BLOCK_SIZE;
}

void soleSplitRange( soleReference* references, bool byCount, const soleRange* range, soleRange halves[2] )
{
	soleCut cut = { .axis = -1, .leftCount = range->count / 2 };
	for ( int axis = 0; axis < 3 && byCount == false; ++axis )
	{
		soleTryAxis( references, range, axis, &cut );
	}
	// Without a cut all triangles have the same middle: any half is as good as another.
	int32_t left = cut.leftCount;
	if ( range->count <= SORTED_COUNT )
	{
		left = soleRoundToBlocks( left, range->count );
		soleSortRange( references, range, cut.axis >= 0 ? cut.axis : 0 );
	}
	else if ( cut.axis >= 0 )
	{
		solePartition( references, range, &cut );
	}
	halves[0] = soleMakeRange( references, range->first, left );
	halves[1] = soleMakeRange( references, range->first + left, range->count - left );
}
