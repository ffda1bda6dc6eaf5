// SPDX-License-Identifier: MIT
// A short way into the tree for rays along the axis that most of the ground faces, which are nearly all that are ever
// cast: cells over the plane across that axis, each naming the nodes whose blocks stand over or under it. Such a ray
// starts with the node that has its block instead of five levels above it. World space.
//
// A coordinate finds its cell by a function that never falls when the coordinate grows: so cells that a box covers are
// those between the cells of its ends, and a ray whose two sides (see walk.c on what it is widened by) are in one cell
// finds all that it may meet there, whatever was rounded. All other probes go through the tree.
#include "base/core.h"
#include "ground/split.h"

#define CELLS_PER_NODE 6       // a cell is less than half as wide as a node of blocks
#define MOST_NAMES_PER_NODE 40 // beyond, the ground is not of a kind that cells are good for

/// The box around a node's blocks. @return false where it has none
static bool soleGetBlocksBox( const soleGroundNode* node, soleBox* box )
{
	bool any = false;
	*box = soleBox_Empty();
	for ( int child = 0; child < SOLE_GROUND_NODE_SIZE && node->children[child] != SOLE_GROUND_NONE; ++child )
	{
		if ( ( node->children[child] & 1u ) == 0 )
		{
			continue;
		}
		any = true;
		for ( int k = 0; k < 3; ++k )
		{
			box->lower[k] = soleMinF( box->lower[k], node->lower[k][child] );
			box->upper[k] = soleMaxF( box->upper[k], node->upper[k][child] );
		}
	}
	return any;
}

/// The cells that a node's blocks are over. @return false for none
static bool soleGetCellsOf( const soleGround* ground, int32_t node, int32_t first[2], int32_t last[2] )
{
	soleBox box;
	if ( !soleGetBlocksBox( ground->nodes + node, &box ) )
	{
		return false;
	}
	for ( int side = 0; side < 2; ++side )
	{
		int k = ground->columns.axes[side];
		first[side] = soleGroundColumns_FindCell( &ground->columns, side, box.lower[k] );
		last[side] = soleGroundColumns_FindCell( &ground->columns, side, box.upper[k] );
	}
	return true;
}

/// Whether there are so few names to write that cells are of use.
static bool soleAreCellsOfUse( const soleGround* ground )
{
	int64_t most = (int64_t)MOST_NAMES_PER_NODE * ground->nodeCount;
	int64_t count = 0;
	for ( int32_t i = 0; i < ground->nodeCount && count <= most; ++i )
	{
		int32_t first[2];
		int32_t last[2];
		if ( soleGetCellsOf( ground, i, first, last ) )
		{
			count += (int64_t)( last[0] - first[0] + 1 ) * ( last[1] - first[1] + 1 );
		}
	}
	return count <= most;
}

/// What is done with each cell that a node's blocks are over.
typedef void soleCellFcn( soleGroundColumns* columns, soleGroundCell* cell, uint32_t node );

static void soleForCells( soleGround* ground, soleCellFcn* visit )
{
	soleGroundColumns* columns = &ground->columns;
	for ( int32_t i = 0; i < ground->nodeCount; ++i )
	{
		int32_t first[2];
		int32_t last[2];
		if ( !soleGetCellsOf( ground, i, first, last ) )
		{
			continue;
		}
		for ( int32_t y = first[1]; y <= last[1]; ++y )
		{
			for ( int32_t x = first[0]; x <= last[0]; ++x )
			{
				visit( columns, columns->cells + (size_t)y * (size_t)columns->counts[0] + (size_t)x, (uint32_t)i );
			}
		}
	}
}

static void soleCountName( soleGroundColumns* columns, soleGroundCell* cell, uint32_t node )
{
	(void)columns;
	(void)node;
	cell->nodes[0] += 1;
}

static void soleWriteName( soleGroundColumns* columns, soleGroundCell* cell, uint32_t node )
{
	if ( cell->nodes[0] == SOLE_GROUND_NONE )
	{
		cell->nodes[0] = node;
	}
	else if ( ( cell->nodes[0] & SOLE_GROUND_LIST ) != 0 )
	{
		columns->lists[( cell->nodes[0] & ~SOLE_GROUND_LIST ) + cell->nodes[1]] = node;
		cell->nodes[1] += 1;
	}
	else
	{
		cell->nodes[1] = node;
	}
}

/// Counts into cells[].nodes[0]. @return how many names are in lists: more than two in a cell
static int64_t soleCountLists( soleGround* ground )
{
	soleGroundColumns* columns = &ground->columns;
	for ( int32_t i = 0; i < columns->cellCount; ++i )
	{
		columns->cells[i] = ( soleGroundCell ){ { 0, 0 } };
	}
	soleForCells( ground, soleCountName );
	int64_t count = 0;
	for ( int32_t i = 0; i < columns->cellCount; ++i )
	{
		count += columns->cells[i].nodes[0] > 2 ? columns->cells[i].nodes[0] : 0;
	}
	return count;
}

/// From counts to names.
static void soleWriteNames( soleGround* ground )
{
	soleGroundColumns* columns = &ground->columns;
	uint32_t place = 0;
	for ( int32_t i = 0; i < columns->cellCount; ++i )
	{
		soleGroundCell* cell = columns->cells + i;
		uint32_t count = cell->nodes[0];
		bool listed = count > 2;
		*cell = ( soleGroundCell ){ { listed ? SOLE_GROUND_LIST | place : SOLE_GROUND_NONE,
			listed ? 0 : SOLE_GROUND_NONE } };
		place += listed ? count : 0;
	}
	soleForCells( ground, soleWriteName );
}

/// Cells about as wide as they are deep over all nodes, as many as CELLS_PER_NODE says.
static void soleLayOutCells( soleGround* ground )
{
	soleGroundColumns* columns = &ground->columns;
	float size[2];
	for ( int side = 0; side < 2; ++side )
	{
		int k = columns->axes[side];
		float low = INFINITY;
		float high = -INFINITY;
		for ( int child = 0; child < SOLE_GROUND_NODE_SIZE; ++child )
		{
			low = soleMinF( low, ground->nodes[0].lower[k][child] );
			high = soleMaxF( high, ground->nodes[0].upper[k][child] );
		}
		columns->low[side] = low;
		size[side] = high - low;
	}
	double wanted = (double)CELLS_PER_NODE * (double)ground->nodeCount;
	double area = (double)size[0] * (double)size[1];
	double perUnit = area > 0.0 ? sqrt( wanted / area ) : 0.0;
	for ( int side = 0; side < 2; ++side )
	{
		double count = perUnit * (double)size[side];
		columns->counts[side] = count > 1.0 ? (int32_t)( count < wanted ? count : wanted ) : 1;
		columns->lastCell[side] = (float)( columns->counts[side] - 1 );
		columns->cellsPerUnit[side] = size[side] > 0.0f ? (float)columns->counts[side] / size[side] : 0.0f;
	}
}

bool soleMakeColumns( soleGround* ground, int axis )
{
	if ( ground->nodeCount == 0 )
	{
		return true;
	}
	const soleAllocator* allocator = ground->allocator.alloc != NULL ? &ground->allocator : NULL;
	soleGroundColumns* columns = &ground->columns;
	columns->axis = axis;
	columns->axes[0] = axis == 2 ? 0 : axis + 1;
	columns->axes[1] = columns->axes[0] == 2 ? 0 : columns->axes[0] + 1;
	soleLayOutCells( ground );
	if ( !soleAreCellsOfUse( ground ) )
	{
		return true;
	}
	columns->cellCount = columns->counts[0] * columns->counts[1];
	columns->cells = soleAlloc( allocator, (size_t)columns->cellCount * sizeof *columns->cells );
	if ( columns->cells == NULL )
	{
		columns->cellCount = 0;
		return false;
	}
	int64_t count = soleCountLists( ground );
	// What moves may need some more.
	columns->listCapacity = (int32_t)( count + count / 8 + 1 );
	columns->lists = soleAlloc( allocator, (size_t)columns->listCapacity * sizeof *columns->lists );
	if ( columns->lists == NULL )
	{
		columns->listCapacity = 0;
		return false;
	}
	soleWriteNames( ground );
	columns->usable = true;
	return true;
}

void soleFreeColumns( soleGround* ground )
{
	const soleAllocator* allocator = ground->allocator.alloc != NULL ? &ground->allocator : NULL;
	soleGroundColumns* columns = &ground->columns;
	soleFree( allocator, columns->lists, (size_t)columns->listCapacity * sizeof *columns->lists );
	soleFree( allocator, columns->cells, (size_t)columns->cellCount * sizeof *columns->cells );
	*columns = ( soleGroundColumns ){ 0 };
}

void soleRefitColumns( soleGround* ground )
{
	soleGroundColumns* columns = &ground->columns;
	columns->usable =
	    columns->cellCount > 0 && soleAreCellsOfUse( ground ) && soleCountLists( ground ) <= columns->listCapacity;
	if ( columns->usable )
	{
		soleWriteNames( ground );
	}
}
