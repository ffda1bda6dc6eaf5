// SPDX-License-Identifier: MIT
// The tree over a ground's triangles: eight boxes a node, blocks of up to four triangles as leaves. World space.
//
// A node takes a range and cuts the child with the largest area until there are eight, but none that one level less
// could hold: so nodes are full too. Below half of SOLE_GROUND_MAX_DEPTH ranges are halved by count instead; a node
// then has eight equal parts, and the other half of the depth is enough for any number of triangles.
#include "base/core.h"
#include "ground/split.h"

#include <string.h>

#define SAH_DEPTH ( SOLE_GROUND_MAX_DEPTH / 2 )

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
	soleReference* references;
	int32_t referenceCount;
	soleGroundNode* nodes;
	int32_t nodeCount;
	int32_t nodeCapacity;
} soleTreeBuilder;

/// How many triangles a child of a full node has.
static int32_t soleGetChildCapacity( int32_t count )
{
	int64_t capacity = SOLE_GROUND_BLOCK_SIZE;
	while ( capacity * SOLE_GROUND_NODE_SIZE < count )
	{
		capacity *= SOLE_GROUND_NODE_SIZE;
	}
	return (int32_t)capacity;
}

/// Cuts a range until it fits a node, none of the parts empty. @return how many.
static int soleMakeChildren( soleTreeBuilder* builder, const soleTask* task, soleRange* children )
{
	int32_t capacity = soleGetChildCapacity( task->range.count );
	bool byCount = task->depth >= SAH_DEPTH;
	children[0] = task->range;
	int count = 1;
	while ( count < SOLE_GROUND_NODE_SIZE )
	{
		int largest = -1;
		double most = -1.0;
		for ( int i = 0; i < count; ++i )
		{
			double size = byCount ? (double)children[i].count : soleBox_GetArea( &children[i].box );
			if ( children[i].count > capacity && !( size <= most ) )
			{
				largest = i;
				most = size;
			}
		}
		if ( largest < 0 )
		{
			break;
		}
		soleRange halves[2];
		soleSplitRange( builder->references, byCount, &children[largest], halves );
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
	for ( int i = 0; i < SOLE_GROUND_NODE_SIZE; ++i )
	{
		node->children[i] = SOLE_GROUND_NONE;
		for ( int k = 0; k < 3; ++k )
		{
			node->lower[k][i] = INFINITY;
			node->upper[k][i] = -INFINITY;
		}
	}
	builder->nodeCount += 1;
	return builder->nodeCount - 1;
}

static void soleSetBox( soleGroundNode* node, int child, const soleBox* box )
{
	for ( int k = 0; k < 3; ++k )
	{
		node->lower[k][child] = box->lower[k];
		node->upper[k][child] = box->upper[k];
	}
}

/// Makes the node of a task and puts the children that are no leaves onto the stack. A leaf is named by its first
/// triangle, until its block is packed. @return false when out of memory.
static bool soleMakeNode( soleTreeBuilder* builder, const soleTask* task, soleTask* stack, int* stackCount )
{
	soleRange children[SOLE_GROUND_NODE_SIZE];
	int count = soleMakeChildren( builder, task, children );
	for ( int i = 0; i < count; ++i )
	{
		uint32_t child = (uint32_t)children[i].first << 1 | 1u;
		if ( children[i].count <= SOLE_GROUND_BLOCK_SIZE )
		{
			builder->references[children[i].first].leaf = 1;
		}
		else
		{
			int32_t number = soleAddNode( builder );
			if ( number == SOLE_NONE )
			{
				return false;
			}
			stack[*stackCount] = ( soleTask ){ children[i], number, task->depth + 1 };
			*stackCount += 1;
			child = (uint32_t)number << 1;
		}
		soleGroundNode* node = builder->nodes + task->node;
		node->children[i] = child;
		soleSetBox( node, i, &children[i].box );
	}
	return true;
}

static bool soleMakeNodes( soleTreeBuilder* builder )
{
	soleTask stack[SOLE_GROUND_STACK_SIZE];
	int stackCount = 1;
	stack[0] =
	    ( soleTask ){ soleMakeRange( builder->references, 0, builder->referenceCount ), soleAddNode( builder ), 0 };
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

// ---------------------------------------------------------------------------------------------------------- blocks

/// Gives leaves the numbers of their blocks, in the order of the triangles: neighbours stay neighbours. @return how
/// many
static int32_t soleNumberBlocks( soleTreeBuilder* builder )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < builder->referenceCount; ++i )
	{
		count += builder->references[i].leaf != 0 ? 1 : 0;
		builder->references[i].leaf = (uint32_t)count - 1;
	}
	for ( int32_t i = 0; i < builder->nodeCount; ++i )
	{
		for ( int k = 0; k < SOLE_GROUND_NODE_SIZE; ++k )
		{
			uint32_t* child = builder->nodes[i].children + k;
			if ( *child != SOLE_GROUND_NONE && ( *child & 1u ) != 0 )
			{
				*child = builder->references[*child >> 1].leaf << 1 | 1u;
			}
		}
	}
	return count;
}

/// Corners of a block's triangles from the meshes; free places repeat the first.
static void soleFillBlock( const soleGround* ground, const soleGroundDef* def, soleGroundBlock* block )
{
	for ( int lane = 0; lane < SOLE_GROUND_BLOCK_SIZE; ++lane )
	{
		uint32_t index = block->indices[lane] != SOLE_GROUND_NONE ? block->indices[lane] : block->indices[0];
		float corners[3][3];
		soleReadTriangle( ground, def, index, corners );
		for ( int i = 0; i < 3; ++i )
		{
			for ( int k = 0; k < 3; ++k )
			{
				block->corners[i][k][lane] = corners[i][k];
			}
		}
	}
}

static bool soleMakeBlocks( soleGround* ground, const soleGroundDef* def, soleTreeBuilder* builder )
{
	ground->blockCount = soleNumberBlocks( builder );
	ground->blocks = soleAlloc( builder->allocator, (size_t)ground->blockCount * sizeof *ground->blocks );
	if ( ground->blocks == NULL )
	{
		return false;
	}
	for ( int32_t i = 0; i < ground->blockCount; ++i )
	{
		for ( int lane = 0; lane < SOLE_GROUND_BLOCK_SIZE; ++lane )
		{
			ground->blocks[i].indices[lane] = SOLE_GROUND_NONE;
		}
	}
	int lane = 0;
	for ( int32_t i = 0; i < builder->referenceCount; ++i )
	{
		const soleReference* reference = builder->references + i;
		lane = i > 0 && reference->leaf == reference[-1].leaf ? lane + 1 : 0;
		ground->blocks[reference->leaf].indices[lane] = reference->index;
	}
	for ( int32_t i = 0; i < ground->blockCount; ++i )
	{
		soleFillBlock( ground, def, ground->blocks + i );
	}
	return true;
}

/// Nodes in an array of their own size.
static bool soleKeepNodes( soleGround* ground, const soleTreeBuilder* builder )
{
	size_t bytes = (size_t)builder->nodeCount * sizeof *builder->nodes;
	ground->nodes = soleAlloc( builder->allocator, bytes );
	if ( ground->nodes == NULL )
	{
		return false;
	}
	memcpy( ground->nodes, builder->nodes, bytes );
	ground->nodeCount = builder->nodeCount;
	return true;
}

// -------------------------------------------------------------------------------------------------------- building

/// Whether the three corners are in a line, but for what rounding leaves of that.
static bool soleHasNoArea( const float corners[3][3] )
{
	double edges[3][3];
	double longest = 0.0;
	for ( int i = 0; i < 3; ++i )
	{
		const float* from = corners[i];
		const float* to = corners[i == 2 ? 0 : i + 1];
		for ( int k = 0; k < 3; ++k )
		{
			edges[i][k] = (double)to[k] - (double)from[k];
		}
		double square = ( edges[i][0] * edges[i][0] + edges[i][1] * edges[i][1] ) + edges[i][2] * edges[i][2];
		longest = square > longest ? square : longest;
	}
	const double* a = edges[0];
	const double* b = edges[1];
	double x = a[1] * b[2] - a[2] * b[1];
	double y = a[2] * b[0] - a[0] * b[2];
	double z = a[0] * b[1] - a[1] * b[0];
	// Thinner than 1e-10 of its length: less than the corners' own rounding, so nothing can fall through.
	return !( ( x * x + y * y ) + z * z > 1e-20 * longest * longest );
}

static soleBox soleMakeTriangleBox( const float corners[3][3] )
{
	soleBox box = soleBox_Empty();
	for ( int i = 0; i < 3; ++i )
	{
		soleBox point;
		memcpy( point.lower, corners[i], sizeof point.lower );
		memcpy( point.upper, corners[i], sizeof point.upper );
		soleBox_Add( &box, &point );
	}
	return box;
}

/// The axis that most of the ground faces.
static int soleFindMainAxis( const soleGround* ground )
{
	double facing[3] = { 0.0, 0.0, 0.0 };
	for ( int32_t i = 0; i < ground->blockCount; ++i )
	{
		const soleGroundBlock* block = ground->blocks + i;
		for ( int k = 0; k < 3; ++k )
		{
			int a = k == 2 ? 0 : k + 1;
			int b = a == 2 ? 0 : a + 1;
			for ( int lane = 0; lane < SOLE_GROUND_BLOCK_SIZE && block->indices[lane] != SOLE_GROUND_NONE; ++lane )
			{
				double ua = (double)block->corners[1][a][lane] - (double)block->corners[0][a][lane];
				double ub = (double)block->corners[1][b][lane] - (double)block->corners[0][b][lane];
				double va = (double)block->corners[2][a][lane] - (double)block->corners[0][a][lane];
				double vb = (double)block->corners[2][b][lane] - (double)block->corners[0][b][lane];
				facing[k] += fabs( ua * vb - ub * va );
			}
		}
	}
	int axis = facing[1] >= facing[0] ? 1 : 0;
	return facing[2] > facing[axis] ? 2 : axis;
}

/// All triangles that have an area. @return how many
static int32_t soleFillReferences(
    const soleGround* ground, const soleGroundDef* def, int64_t triangleCount, soleReference* references )
{
	int32_t count = 0;
	for ( int64_t i = 0; i < triangleCount; ++i )
	{
		float corners[3][3];
		soleReadTriangle( ground, def, (uint32_t)i, corners );
		if ( !soleHasNoArea( (const float( * )[3])corners ) )
		{
			references[count] = ( soleReference ){ .index = (uint32_t)i };
			references[count].box = soleMakeTriangleBox( (const float( * )[3])corners );
			count += 1;
		}
	}
	return count;
}

bool soleBuildGroundTree( soleGround* ground, const soleGroundDef* def )
{
	int64_t triangleCount = 0;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		triangleCount += def->meshes[i].triangleCount;
	}
	if ( triangleCount == 0 )
	{
		return true;
	}
	soleTreeBuilder builder = { .allocator = ground->allocator.alloc != NULL ? &ground->allocator : NULL };
	size_t bytes = (size_t)triangleCount * sizeof *builder.references;
	builder.references = soleAlloc( builder.allocator, bytes );
	if ( builder.references == NULL )
	{
		return false;
	}
	builder.referenceCount = soleFillReferences( ground, def, triangleCount, builder.references );
	ground->triangleCount = builder.referenceCount;
	bool done = builder.referenceCount == 0 ||
	    ( soleMakeNodes( &builder ) && soleMakeBlocks( ground, def, &builder ) && soleKeepNodes( ground, &builder ) &&
	        soleMakeColumns( ground, soleFindMainAxis( ground ) ) );
	soleFree( builder.allocator, builder.references, bytes );
	soleFree( builder.allocator, builder.nodes, (size_t)builder.nodeCapacity * sizeof *builder.nodes );
	return done;
}

// ---------------------------------------------------------------------------------------------------------- moving

static soleBox soleGetBlockBox( const soleGroundBlock* block )
{
	soleBox box = soleBox_Empty();
	for ( int lane = 0; lane < SOLE_GROUND_BLOCK_SIZE; ++lane )
	{
		for ( int i = 0; i < 3; ++i )
		{
			for ( int k = 0; k < 3; ++k )
			{
				box.lower[k] = soleMinF( box.lower[k], block->corners[i][k][lane] );
				box.upper[k] = soleMaxF( box.upper[k], block->corners[i][k][lane] );
			}
		}
	}
	return box;
}

static soleBox soleGetNodeBox( const soleGroundNode* node )
{
	soleBox box = soleBox_Empty();
	for ( int child = 0; child < SOLE_GROUND_NODE_SIZE; ++child )
	{
		for ( int k = 0; k < 3; ++k )
		{
			box.lower[k] = soleMinF( box.lower[k], node->lower[k][child] );
			box.upper[k] = soleMaxF( box.upper[k], node->upper[k][child] );
		}
	}
	return box;
}

void soleRefitGroundTree( soleGround* ground, const soleGroundDef* def )
{
	for ( int32_t i = 0; i < ground->blockCount; ++i )
	{
		soleFillBlock( ground, def, ground->blocks + i );
	}
	for ( int32_t i = ground->nodeCount - 1; i >= 0; --i )
	{
		soleGroundNode* node = ground->nodes + i;
		for ( int k = 0; k < SOLE_GROUND_NODE_SIZE && node->children[k] != SOLE_GROUND_NONE; ++k )
		{
			uint32_t number = node->children[k] >> 1;
			soleBox box = ( node->children[k] & 1u ) != 0 ? soleGetBlockBox( ground->blocks + number )
			                                              : soleGetNodeBox( ground->nodes + number );
			soleSetBox( node, k, &box );
		}
	}
	soleRefitColumns( ground );
}
