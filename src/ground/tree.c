// SPDX-License-Identifier: MIT
// The tree over a ground's triangles: four boxes a node, up to four triangles a leaf. World space.
//
// A range of triangles is cut in two where the surface area heuristic is least: triangles are counted into bins along
// each axis by the middle of their box, and of all cuts between bins the one with the least
//   area( left ) count( left ) + area( right ) count( right )
// is taken (Wald, On fast Construction of SAH-based Bounding Volume Hierarchies, 2007). A node takes a range and cuts
// the child with the largest area until there are four. Below half of SOLE_GROUND_MAX_DEPTH ranges are halved by count
// instead: a node then has four quarters, and the other half of the depth is enough for any number of triangles.
#include "ground/ground_internal.h"

#include "base/core.h"

#include <string.h>

#define BIN_COUNT 12
#define SAH_DEPTH ( SOLE_GROUND_MAX_DEPTH / 2 )

typedef struct soleBox
{
	float lower[3];
	float upper[3];
} soleBox;

typedef struct soleBin
{
	soleBox box;
	int32_t count;
} soleBin;

/// A range of triangles and the box around it.
typedef struct soleRange
{
	soleBox box;
	int32_t first;
	int32_t count;
} soleRange;

/// A range that waits to become the node that has been set aside for it.
typedef struct soleTask
{
	soleRange range;
	int32_t node;
	int32_t depth;
} soleTask;

typedef struct soleTreeBuilder
{
	const soleAllocator* allocator;
	soleGroundTriangle* triangles;
	soleBox* boxes; // goes with triangles
	soleGroundNode* nodes;
	int32_t nodeCount;
	int32_t nodeCapacity;
} soleTreeBuilder;

static soleBox soleBox_Empty( void )
{
	soleBox box;
	for ( int k = 0; k < 3; ++k )
	{
		box.lower[k] = INFINITY;
		box.upper[k] = -INFINITY;
	}
	return box;
}

static void soleBox_Add( soleBox* box, const soleBox* other )
{
	for ( int k = 0; k < 3; ++k )
	{
		box->lower[k] = soleMinF( box->lower[k], other->lower[k] );
		box->upper[k] = soleMaxF( box->upper[k], other->upper[k] );
	}
}

/// Half the surface. In double: the square of a far coordinate has no room in a float.
static double soleBox_GetArea( const soleBox* box )
{
	double x = (double)box->upper[0] - (double)box->lower[0];
	double y = (double)box->upper[1] - (double)box->lower[1];
	double z = (double)box->upper[2] - (double)box->lower[2];
	return x * y + y * z + z * x;
}

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

/// A way to cut a range: triangles in bins up to and including `bin` go left.
typedef struct soleCut
{
	int axis; // -1: none
	int32_t bin;
	float low;
	float scale;
	double cost;
} soleCut;

/// Best cut across one axis, if it beats the one so far.
static void soleTryAxis( const soleTreeBuilder* builder, const soleRange* range, int axis, soleCut* best )
{
	float low = INFINITY;
	float high = -INFINITY;
	for ( int32_t i = range->first; i < range->first + range->count; ++i )
	{
		float middle = soleBox_GetMiddle( builder->boxes + i, axis );
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
		soleBin* bin = bins + soleGetBin( soleBox_GetMiddle( builder->boxes + i, axis ), low, scale );
		soleBox_Add( &bin->box, builder->boxes + i );
		bin->count += 1;
	}

	double rightCost[BIN_COUNT];
	soleBox box = soleBox_Empty();
	int32_t count = 0;
	for ( int32_t i = BIN_COUNT - 1; i > 0; --i )
	{
		soleBox_Add( &box, &bins[i].box );
		count += bins[i].count;
		rightCost[i] = count > 0 ? soleBox_GetArea( &box ) * (double)count : 0.0;
	}
	box = soleBox_Empty();
	count = 0;
	for ( int32_t i = 0; i + 1 < BIN_COUNT; ++i )
	{
		soleBox_Add( &box, &bins[i].box );
		count += bins[i].count;
		if ( count == 0 || count == range->count )
		{
			continue;
		}
		double cost = soleBox_GetArea( &box ) * (double)count + rightCost[i + 1];
		if ( best->axis < 0 || cost < best->cost )
		{
			*best = ( soleCut ){ axis, i, low, scale, cost };
		}
	}
}

static void soleSwapTriangles( soleTreeBuilder* builder, int32_t a, int32_t b )
{
	soleGroundTriangle triangle = builder->triangles[a];
	builder->triangles[a] = builder->triangles[b];
	builder->triangles[b] = triangle;
	soleBox box = builder->boxes[a];
	builder->boxes[a] = builder->boxes[b];
	builder->boxes[b] = box;
}

/// Moves the triangles left of the cut to the front. @return how many these are.
static int32_t solePartition( soleTreeBuilder* builder, const soleRange* range, const soleCut* cut )
{
	int32_t left = range->first;
	for ( int32_t i = range->first; i < range->first + range->count; ++i )
	{
		float middle = soleBox_GetMiddle( builder->boxes + i, cut->axis );
		if ( soleGetBin( middle, cut->low, cut->scale ) <= cut->bin )
		{
			soleSwapTriangles( builder, left, i );
			left += 1;
		}
	}
	return left - range->first;
}

static soleRange soleMakeRange( const soleTreeBuilder* builder, int32_t first, int32_t count )
{
	soleRange range = { soleBox_Empty(), first, count };
	for ( int32_t i = first; i < first + count; ++i )
	{
		soleBox_Add( &range.box, builder->boxes + i );
	}
	return range;
}

static void soleSplitRange( soleTreeBuilder* builder, int32_t depth, const soleRange* range, soleRange halves[2] )
{
	int32_t left = range->count / 2;
	if ( depth < SAH_DEPTH )
	{
		soleCut cut = { -1, 0, 0.0f, 0.0f, 0.0 };
		for ( int axis = 0; axis < 3; ++axis )
		{
			soleTryAxis( builder, range, axis, &cut );
		}
		// Without a cut all triangles have the same middle: any half is as good as another.
		left = cut.axis >= 0 ? solePartition( builder, range, &cut ) : left;
	}
	halves[0] = soleMakeRange( builder, range->first, left );
	halves[1] = soleMakeRange( builder, range->first + left, range->count - left );
}

/// Cuts a range into two to four, none empty. A range that fits a leaf stays whole. @return how many.
static int soleMakeChildren( soleTreeBuilder* builder, const soleTask* task, soleRange children[4] )
{
	children[0] = task->range;
	int count = 1;
	while ( count < 4 )
	{
		int largest = -1;
		for ( int i = 0; i < count; ++i )
		{
			bool splits = children[i].count > SOLE_GROUND_LEAF_SIZE;
			bool byCount = task->depth >= SAH_DEPTH;
			if ( splits &&
			    ( largest < 0 ||
			        ( byCount ? children[i].count > children[largest].count
			                  : soleBox_GetArea( &children[i].box ) > soleBox_GetArea( &children[largest].box ) ) ) )
			{
				largest = i;
			}
		}
		if ( largest < 0 )
		{
			break;
		}
		soleRange halves[2];
		soleSplitRange( builder, task->depth, &children[largest], halves );
		children[largest] = halves[0];
		children[count] = halves[1];
		count += 1;
	}
	return count;
}

/// Another node, moving all to a larger array where it is full. @return its number, or SOLE_NONE.
static int32_t soleAddNode( soleTreeBuilder* builder )
{
	if ( builder->nodeCount == builder->nodeCapacity )
	{
		int32_t capacity = builder->nodeCapacity < 8 ? 8 : builder->nodeCapacity * 2;
		soleGroundNode* nodes = soleAlloc( builder->allocator, (size_t)capacity * sizeof *nodes );
		if ( nodes == NULL )
		{
			return SOLE_NONE;
		}
		if ( builder->nodeCount > 0 )
		{
			memcpy( nodes, builder->nodes, (size_t)builder->nodeCount * sizeof *nodes );
		}
		soleFree( builder->allocator, builder->nodes, (size_t)builder->nodeCapacity * sizeof *nodes );
		builder->nodes = nodes;
		builder->nodeCapacity = capacity;
	}
	soleGroundNode* node = builder->nodes + builder->nodeCount;
	for ( int i = 0; i < 4; ++i )
	{
		node->children[i] = SOLE_GROUND_NO_CHILD;
	}
	builder->nodeCount += 1;
	return builder->nodeCount - 1;
}

/// Makes the node of a task and puts the children that are no leaves onto the stack. @return false when out of memory.
static bool soleMakeNode( soleTreeBuilder* builder, const soleTask* task, soleTask* stack, int* stackCount )
{
	soleRange children[4];
	int count = soleMakeChildren( builder, task, children );
	for ( int i = 0; i < count; ++i )
	{
		uint32_t child = ( (uint32_t)children[i].first << 3 ) | (uint32_t)children[i].count;
		if ( children[i].count > SOLE_GROUND_LEAF_SIZE )
		{
			int32_t number = soleAddNode( builder );
			if ( number == SOLE_NONE )
			{
				return false;
			}
			stack[*stackCount] = ( soleTask ){ children[i], number, task->depth + 1 };
			*stackCount += 1;
			child = (uint32_t)number << 3;
		}
		soleGroundNode* node = builder->nodes + task->node;
		node->children[i] = child;
		for ( int k = 0; k < 3; ++k )
		{
			node->lower[k][i] = children[i].box.lower[k];
			node->upper[k][i] = children[i].box.upper[k];
		}
	}
	return true;
}

static bool soleMakeNodes( soleTreeBuilder* builder, int32_t triangleCount )
{
	soleTask stack[SOLE_GROUND_STACK_SIZE];
	int stackCount = 1;
	stack[0] = ( soleTask ){ soleMakeRange( builder, 0, triangleCount ), soleAddNode( builder ), 0 };
	if ( stack[0].node == SOLE_NONE )
	{
		return false;
	}
	while ( stackCount > 0 )
	{
		stackCount -= 1;
		soleTask task = stack[stackCount];
		SOLE_ASSERT( task.depth < SOLE_GROUND_MAX_DEPTH );
		if ( !soleMakeNode( builder, &task, stack, &stackCount ) )
		{
			return false;
		}
	}
	return true;
}

static void soleFillBoxes( const soleGround* ground, soleBox* boxes )
{
	for ( int32_t i = 0; i < ground->triangleCount; ++i )
	{
		boxes[i] = soleBox_Empty();
		for ( int corner = 0; corner < 3; ++corner )
		{
			const float* p = ground->vertices + 3 * (size_t)ground->triangles[i].corners[corner];
			soleBox point = { { p[0], p[1], p[2] }, { p[0], p[1], p[2] } };
			soleBox_Add( boxes + i, &point );
		}
	}
}

bool soleBuildGroundTree( soleGround* ground )
{
	if ( ground->triangleCount == 0 )
	{
		return true;
	}
	const soleAllocator* allocator = ground->allocator.alloc != NULL ? &ground->allocator : NULL;
	size_t boxBytes = (size_t)ground->triangleCount * sizeof( soleBox );
	soleTreeBuilder builder = {
		.allocator = allocator,
		.triangles = ground->triangles,
		.boxes = soleAlloc( allocator, boxBytes ),
	};
	bool done = false;
	if ( builder.boxes != NULL )
	{
		soleFillBoxes( ground, builder.boxes );
		done = soleMakeNodes( &builder, ground->triangleCount );
	}
	soleFree( allocator, builder.boxes, boxBytes );

	// Kept in an array of its own size.
	if ( done )
	{
		size_t bytes = (size_t)builder.nodeCount * sizeof *builder.nodes;
		ground->nodes = soleAlloc( allocator, bytes );
		done = ground->nodes != NULL;
		if ( done )
		{
			memcpy( ground->nodes, builder.nodes, bytes );
			ground->nodeCount = builder.nodeCount;
		}
	}
	soleFree( allocator, builder.nodes, (size_t)builder.nodeCapacity * sizeof *builder.nodes );
	return done;
}
