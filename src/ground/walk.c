// SPDX-License-Identifier: MIT
// Probes through the tree of boxes, world space.
//
// A probe along an axis, as most that ask for ground are, sweeps a box itself: a child is entered where the two boxes
// overlap. Any other is cut into the travels between the three pairs of sides, which must overlap. Boxes are widened by
// the sphere's radius and by what rounding may shift a triangle in ray.c, so that no triangle is missed because its box
// was; a direction without a part along an axis gets a large finite inverse, which leaves no NaN: inside the sides all
// travel is within, outside none is. Children are visited nearest first.
#include "ground/walk.h"

#include "base/core.h"

#define MOST_SEEN 16
#define CACHE_LINE 64

typedef struct soleStackEntry
{
	uint32_t child;
	float enter;
} soleStackEntry;

static inline float soleGetLimit( const soleGroundQuery* query, const soleGroundTouch* best )
{
	return soleMinF( query->length, (float)best->t );
}

/// The swept box along the way of an aligned probe, until a limit.
static inline void soleSweepBox( const soleGroundQuery* query, float limit, soleBoxQuery* box )
{
	int k = query->axes[2];
	float end = query->start[k] + query->direction[k] * limit;
	box->low[k] = soleMinF( query->start[k], end ) - box->reach;
	box->high[k] = soleMaxF( query->start[k], end ) + box->reach;
}

/// What an aligned probe sweeps, and how far any probe reaches to its sides.
static inline void soleFillSweptBox(
    const soleGround* ground, const soleGroundQuery* query, float limit, soleBoxQuery* box )
{
	float away =
	    ( fabsf( query->start[0] ) + fabsf( query->start[1] ) ) + ( fabsf( query->start[2] ) + ground->extent );
	box->reach = query->radius + ( 2e-6f * away + 1e-20f );
	for ( int i = 0; i < 2; ++i )
	{
		int k = query->axes[i];
		box->low[k] = query->start[k] - box->reach;
		box->high[k] = query->start[k] + box->reach;
	}
	soleSweepBox( query, limit, box );
}

/// What the way through the tree needs besides.
static inline void soleFillBoxQuery( const soleGroundQuery* query, soleBoxQuery* box )
{
	for ( int k = 0; k < 3; ++k )
	{
		float d = query->direction[k];
		box->inverse[k] = fabsf( d ) > 1e-30f ? 1.0f / d : 1e30f;
		box->startLow[k] = query->start[k] + box->reach;
		box->startHigh[k] = query->start[k] - box->reach;
	}
}

/// Which children's boxes overlap the swept one, as bits.
static inline uint32_t soleFindOverlaps( const soleGroundNode* node, const soleBoxQuery* box )
{
	uint32_t apartBits = 0;
	for ( int half = 0; half < SOLE_GROUND_NODE_SIZE; half += SOLE_WIDTH )
	{
		soleWideMask apart = soleWide_Less( soleWide_Set( box->high[0] ), soleWide_Load( node->lower[0] + half ) );
		apart =
		    soleWide_Or( apart, soleWide_Less( soleWide_Load( node->upper[0] + half ), soleWide_Set( box->low[0] ) ) );
		for ( int k = 1; k < 3; ++k )
		{
			soleWideMask below = soleWide_Less( soleWide_Set( box->high[k] ), soleWide_Load( node->lower[k] + half ) );
			soleWideMask above = soleWide_Less( soleWide_Load( node->upper[k] + half ), soleWide_Set( box->low[k] ) );
			apart = soleWide_Or( apart, soleWide_Or( below, above ) );
		}
		apartBits |= soleWide_GetBits( apart ) << half;
	}
	return ~apartBits & ( ( 1u << SOLE_GROUND_NODE_SIZE ) - 1u );
}

/// Where an aligned probe enters the boxes that it overlaps.
static inline void soleEnterOverlaps( const soleGroundNode* node, const soleGroundQuery* query, const soleBoxQuery* box,
    uint32_t bits, float enters[SOLE_GROUND_NODE_SIZE] )
{
	int k = query->axes[2];
	bool forwards = box->inverse[k] > 0.0f;
	const float* sides = forwards ? node->lower[k] : node->upper[k];
	float start = forwards ? box->startLow[k] : box->startHigh[k];
	for ( ; bits != 0; bits &= bits - 1 )
	{
		uint32_t child = soleGetLowestBit( bits );
		enters[child] = soleMaxF( ( sides[child] - start ) * box->inverse[k], 0.0f );
	}
}

/// Which children's boxes the probe enters before the limit, as bits, and where.
static inline uint32_t soleFindCrossed(
    const soleGroundNode* node, const soleBoxQuery* box, float limit, float enters[SOLE_GROUND_NODE_SIZE] )
{
	uint32_t missedBits = 0;
	for ( int half = 0; half < SOLE_GROUND_NODE_SIZE; half += SOLE_WIDTH )
	{
		soleWide enter = soleWide_Set( 0.0f );
		soleWide leave = soleWide_Set( limit );
		for ( int k = 0; k < 3; ++k )
		{
			soleWide inverse = soleWide_Set( box->inverse[k] );
			soleWide lower = soleWide_Sub( soleWide_Load( node->lower[k] + half ), soleWide_Set( box->startLow[k] ) );
			soleWide upper = soleWide_Sub( soleWide_Load( node->upper[k] + half ), soleWide_Set( box->startHigh[k] ) );
			soleWide a = soleWide_Mul( lower, inverse );
			soleWide b = soleWide_Mul( upper, inverse );
			bool forwards = box->inverse[k] > 0.0f;
			enter = soleWide_Max( enter, forwards ? a : b );
			leave = soleWide_Min( leave, forwards ? b : a );
		}
		// Each travel is off by at most two roundings.
		soleWideMask missed = soleWide_Less( soleWide_Mul( leave, soleWide_Set( 1.000001f ) ), enter );
		missedBits |= soleWide_GetBits( missed ) << half;
		soleWide_Store( enters + half, enter );
	}
	return ~missedBits & ( ( 1u << SOLE_GROUND_NODE_SIZE ) - 1u );
}

/// Puts children onto the stack, the nearest on top. @return the new height of the stack.
static inline int solePushChildren(
    const soleGroundNode* node, uint32_t bits, const float* enters, soleStackEntry* stack, int stackCount )
{
	int bottom = stackCount;
	for ( ; bits != 0; bits &= bits - 1 )
	{
		uint32_t child = soleGetLowestBit( bits );
		if ( node->children[child] == SOLE_GROUND_NONE )
		{
			continue; // a free place: numbers that overflow compare with nothing
		}
		int place = stackCount;
		while ( place > bottom && stack[place - 1].enter < enters[child] )
		{
			stack[place] = stack[place - 1];
			place -= 1;
		}
		stack[place] = ( soleStackEntry ){ node->children[child], enters[child] };
		stackCount += 1;
	}
	return stackCount;
}

/// Goes down from a node for as long as a single child is met. @return the child that is left, a block, or
/// SOLE_GROUND_NONE where nothing is or where several were put onto the stack.
static inline uint32_t soleDescend( const soleWalk* walk, uint32_t child, soleStackEntry* stack, int* stackCount )
{
	bool aligned = walk->query->aligned;
	while ( ( child & 1u ) == 0 )
	{
		const soleGroundNode* node = walk->ground->nodes + ( child >> 1 );
		float enters[SOLE_GROUND_NODE_SIZE];
		uint32_t bits =
		    aligned ? soleFindOverlaps( node, &walk->box ) : soleFindCrossed( node, &walk->box, walk->limit, enters );
		if ( ( bits & ( bits - 1 ) ) != 0 )
		{
			if ( aligned )
			{
				soleEnterOverlaps( node, walk->query, &walk->box, bits, enters );
			}
			SOLE_ASSERT( *stackCount + SOLE_GROUND_NODE_SIZE <= SOLE_GROUND_STACK_SIZE );
			*stackCount = solePushChildren( node, bits, enters, stack, *stackCount );
			return SOLE_GROUND_NONE;
		}
		if ( bits == 0 )
		{
			return SOLE_GROUND_NONE;
		}
		child = node->children[soleGetLowestBit( bits )];
	}
	return child;
}

// ------------------------------------------------------------------------------------------------------- triangles

/// @return whether it is the best so far
static inline bool soleCastTriangle(
    const soleGround* ground, const soleGroundQuery* query, uint32_t place, soleGroundTouch* best )
{
	const soleGroundBlock* block = ground->blocks + place / SOLE_GROUND_BLOCK_SIZE;
	uint32_t lane = place % SOLE_GROUND_BLOCK_SIZE;
	uint32_t index = block->indices[lane];
	if ( index == SOLE_GROUND_NONE )
	{
		return false;
	}
	const soleGroundPart* part =
	    ground->partCount == 1 ? ground->parts : ground->parts + soleGround_FindPart( ground, index );
	uint32_t layer = ground->layers != NULL ? ground->layers[place] : part->layer;
	soleGroundTouch touch;
	if ( ( layer & query->mask ) == 0 || !soleMeetTriangle( query, block, lane, part->twoSided, &touch ) )
	{
		return false;
	}
	touch.index = index;
	touch.layer = layer;
	touch.surface = part->surface;
	if ( !soleGroundTouch_IsBefore( &touch, best ) )
	{
		return false;
	}
	*best = touch;
	return true;
}

static void soleShortenWalk( soleWalk* walk )
{
	walk->limit = soleGetLimit( walk->query, walk->best );
	soleSweepBox( walk->query, walk->limit, &walk->box );
}

/// Asks those that wait, nearest first, for as long as they may be nearer than the best.
static void soleAskWaiting( soleWalk* walk )
{
	for ( int i = 0; i < walk->waitingCount && walk->waiting[i].bound <= walk->limit * 1.000001f; ++i )
	{
		if ( soleCastTriangle( walk->ground, walk->query, walk->waiting[i].place, walk->best ) )
		{
			soleShortenWalk( walk );
		}
	}
	walk->waitingCount = 0;
}

/// To decide about a sphere is dear: the triangles of some blocks are put in order before.
static void soleLetWait( soleWalk* walk, uint32_t place, float bound )
{
	int at = walk->waitingCount;
	for ( ; at > 0 && walk->waiting[at - 1].bound > bound; --at )
	{
		walk->waiting[at] = walk->waiting[at - 1];
	}
	walk->waiting[at] = ( soleWaiting ){ place, bound };
	walk->waitingCount += 1;
	if ( walk->waitingCount == SOLE_WALK_MOST_WAITING )
	{
		soleAskWaiting( walk );
	}
}

static inline void soleCastBlock( soleWalk* walk, uint32_t number )
{
	const soleGround* ground = walk->ground;
	float bounds[SOLE_GROUND_BLOCK_SIZE];
	uint32_t bits = soleSiftBlock( walk->query, ground->blocks + number, ground->anyTwoSided, walk->limit, bounds );
	for ( ; bits != 0; bits &= bits - 1 )
	{
		uint32_t lane = soleGetLowestBit( bits );
		uint32_t place = SOLE_GROUND_BLOCK_SIZE * number + lane;
		if ( walk->query->radius > 0.0f )
		{
			soleLetWait( walk, place, bounds[lane] );
		}
		else if ( soleCastTriangle( ground, walk->query, place, walk->best ) )
		{
			soleShortenWalk( walk );
		}
	}
}

/// For rays along an axis. The limit stays: what they may meet has been gathered before.
static inline void soleCastBlockAlongAxis( soleWalk* walk, uint32_t number )
{
	const soleGround* ground = walk->ground;
	uint32_t bits = soleSiftForAlignedRay( walk->query, ground->blocks + number, ground->anyTwoSided );
	for ( ; bits != 0; bits &= bits - 1 )
	{
		uint32_t place = SOLE_GROUND_BLOCK_SIZE * number + soleGetLowestBit( bits );
		soleCastTriangle( ground, walk->query, place, walk->best );
	}
}

/// Asks the blocks that an aligned probe has gathered.
static void soleAskBlocks( soleWalk* walk )
{
	for ( int i = 0; i < walk->blockCount; ++i )
	{
		if ( walk->query->radius > 0.0f )
		{
			soleCastBlock( walk, walk->blocks[i] );
		}
		else
		{
			soleCastBlockAlongAxis( walk, walk->blocks[i] );
		}
	}
	walk->blockCount = 0;
}

// -------------------------------------------------------------------------------------------------------- two ways

static inline void soleFetch( const void* memory, size_t byteCount )
{
#if defined( __GNUC__ )
	for ( size_t i = 0; i < byteCount; i += CACHE_LINE )
	{
		__builtin_prefetch( (const char*)memory + i );
	}
#else
	(void)memory;
	(void)byteCount;
#endif
}

/// Those of a node's children that are blocks.
static inline void soleGatherNode( soleWalk* walk, uint32_t number )
{
	const soleGroundNode* node = walk->ground->nodes + number;
	for ( uint32_t bits = soleFindOverlaps( node, &walk->box ); bits != 0; bits &= bits - 1 )
	{
		uint32_t child = node->children[soleGetLowestBit( bits )];
		if ( ( child & 1u ) == 0 || child == SOLE_GROUND_NONE )
		{
			continue;
		}
		if ( walk->blockCount == SOLE_WALK_MOST_BLOCKS )
		{
			soleAskBlocks( walk );
		}
		soleFetch( walk->ground->blocks + ( child >> 1 ), sizeof *walk->ground->blocks );
		walk->blocks[walk->blockCount] = child >> 1;
		walk->blockCount += 1;
	}
}

/// The nodes of up to four cells, each once.
static void soleGatherCells( soleWalk* walk )
{
	const soleGroundColumns* columns = &walk->ground->columns;
	uint32_t seen[MOST_SEEN];
	uint32_t seenCount = 0;
	for ( int32_t number = 0; number < walk->cellCounts[0] * walk->cellCounts[1]; ++number )
	{
		int32_t x = number % walk->cellCounts[0];
		int32_t y = number / walk->cellCounts[0];
		uint32_t count;
		const soleGroundCell* cell = walk->cell + (size_t)y * (size_t)columns->counts[0] + (size_t)x;
		const uint32_t* names = soleGroundColumns_GetNodes( columns, cell, &count );
		for ( uint32_t i = 0; i < count; ++i )
		{
			uint32_t k = 0;
			while ( k < seenCount && seen[k] != names[i] )
			{
				k += 1;
			}
			if ( k == seenCount )
			{
				soleGatherNode( walk, names[i] );
				// Where there are more, some are asked twice.
				seenCount = seenCount < MOST_SEEN ? seenCount + 1 : 1;
				seen[seenCount - 1] = names[i];
			}
		}
	}
}

static void soleWalkDown( soleWalk* walk )
{
	soleStackEntry stack[SOLE_GROUND_STACK_SIZE];
	int stackCount = 1;
	stack[0] = ( soleStackEntry ){ 0, 0.0f };
	while ( stackCount > 0 )
	{
		stackCount -= 1;
		if ( stack[stackCount].enter > walk->limit * 1.000001f )
		{
			continue;
		}
		uint32_t child = soleDescend( walk, stack[stackCount].child, stack, &stackCount );
		if ( child != SOLE_GROUND_NONE )
		{
			soleCastBlock( walk, child >> 1 );
		}
	}
}

/// The cells of an aligned probe. @return false where these are too many
static inline bool soleFindCells( const soleGroundColumns* columns, soleWalk* walk )
{
	int32_t first[2];
	for ( int side = 0; side < 2; ++side )
	{
		int k = columns->axes[side];
		first[side] = soleGroundColumns_FindCell( columns, side, walk->box.low[k] );
		int32_t last = soleGroundColumns_FindCell( columns, side, walk->box.high[k] );
		walk->cellCounts[side] = last - first[side] + 1;
	}
	walk->cell = soleGroundColumns_GetCell( columns, first[0], first[1] );
	return walk->cellCounts[0] <= 2 && walk->cellCounts[1] <= 2;
}

void soleStartWalk( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best, soleWalk* walk )
{
	walk->ground = ground;
	walk->query = query;
	walk->best = best;
	walk->limit = soleGetLimit( query, best );
	walk->blockCount = 0;
	walk->waitingCount = 0;
	soleFillSweptBox( ground, query, walk->limit, &walk->box );
	const soleGroundColumns* columns = &ground->columns;
	bool along = columns->usable && query->aligned && query->axes[2] == columns->axis;
	walk->byColumns = along && soleFindCells( columns, walk );
	if ( walk->byColumns )
	{
		soleFetch( walk->cell, 1 );
	}
	else
	{
		soleFillBoxQuery( query, &walk->box );
	}
}

void soleFetchNodes( const soleWalk* walk )
{
	if ( walk->byColumns )
	{
		uint32_t count;
		const uint32_t* names = soleGroundColumns_GetNodes( &walk->ground->columns, walk->cell, &count );
		for ( uint32_t i = 0; i < count && i < 4; ++i )
		{
			soleFetch( walk->ground->nodes + names[i], sizeof *walk->ground->nodes );
		}
	}
}

void soleGatherBlocks( soleWalk* walk )
{
	if ( walk->byColumns == false )
	{
		return;
	}
	if ( walk->cellCounts[0] * walk->cellCounts[1] > 1 )
	{
		soleGatherCells( walk );
		return;
	}
	uint32_t count;
	const uint32_t* names = soleGroundColumns_GetNodes( &walk->ground->columns, walk->cell, &count );
	for ( uint32_t i = 0; i < count; ++i )
	{
		soleGatherNode( walk, names[i] );
	}
}

void soleFinishWalk( soleWalk* walk )
{
	if ( walk->byColumns == false )
	{
		soleWalkDown( walk );
	}
	soleAskBlocks( walk );
	soleAskWaiting( walk );
}
