// SPDX-License-Identifier: MIT
// What the files of the ground share: how it is stored, a prepared question, the best answer so far. World space, but
// for height fields, which are asked in their own axes.
//
// Meshes are kept as a tree of eight boxes a node whose leaves are blocks of four triangles with their corners in
// place: what a short probe waits for is memory, and so it waits for one leaf, not for corners named by numbers
// elsewhere. Why not a grid: docs/design-reasons.md.
#ifndef SOLE_GROUND_INTERNAL_H
#define SOLE_GROUND_INTERNAL_H

#include "sole/ground.h"

#include <string.h>

#define SOLE_GROUND_BLOCK_SIZE 4
#define SOLE_GROUND_NODE_SIZE 8
// The tree is never deeper than this: beyond half of it ranges are halved by count. See tree.c.
#define SOLE_GROUND_MAX_DEPTH 40
// Each level leaves all but one of its brothers behind.
#define SOLE_GROUND_STACK_SIZE ( ( SOLE_GROUND_NODE_SIZE - 1 ) * SOLE_GROUND_MAX_DEPTH + SOLE_GROUND_NODE_SIZE )
#define SOLE_GROUND_NONE 0xffffffffu
#define SOLE_GROUND_LIST 0x80000000u
#define SOLE_GROUND_MAX_TRIANGLES ( 1 << 28 )

/// Four triangles that lie close together, number by number: a leaf of the tree, and all that is kept of the meshes.
typedef struct soleGroundBlock
{
	float corners[3][3][SOLE_GROUND_BLOCK_SIZE]; // corner, axis, triangle; a free place repeats the first triangle
	/// Counted through all meshes as they were given: decides ties. A free place has SOLE_GROUND_NONE.
	uint32_t indices[SOLE_GROUND_BLOCK_SIZE];
} soleGroundBlock;

/// Eight boxes, one per child, axis by axis. A free place has a box that nothing meets, lower above upper.
typedef struct soleGroundNode
{
	float lower[3][SOLE_GROUND_NODE_SIZE];
	float upper[3][SOLE_GROUND_NODE_SIZE];
	/// Twice the number of a node, or twice the number of a block plus one.
	uint32_t children[SOLE_GROUND_NODE_SIZE];
} soleGroundNode;

/// What all triangles of one mesh have in common.
typedef struct soleGroundPart
{
	uint32_t firstIndex; // of its first triangle
	int32_t triangleCount;
	uint32_t layer; // where the ground has no layers per triangle
	int32_t surface;
	bool twoSided;
} soleGroundPart;

/// Nodes whose blocks are over a cell: up to two, or SOLE_GROUND_LIST and the place of a list, and how many are in it.
typedef struct soleGroundCell
{
	uint32_t nodes[2];
} soleGroundCell;

/// Cells over the plane across one axis, for probes along it.
typedef struct soleGroundColumns
{
	bool usable;
	int axis;
	int axes[2]; // across
	float low[2];
	float cellsPerUnit[2];
	int32_t counts[2];
	float lastCell[2];     // counts - 1
	soleGroundCell* cells; // row by row along axes[0]
	int32_t cellCount;
	uint32_t* lists;
	int32_t listCapacity;
} soleGroundColumns;

/// A height field with its own copy of the heights and the range they span.
typedef struct soleGroundField
{
	soleHeightField field;
	float* heights;
	int32_t heightCount;
	float lowest; // lowest above highest: nothing but holes
	float highest;
} soleGroundField;

struct soleGround
{
	soleAllocator allocator; // alloc NULL: malloc and free
	soleGroundBlock* blocks;
	int32_t blockCount;
	int32_t triangleCount; // without those that have no area
	uint32_t* layers;      // per place of a block, or NULL: those of the parts
	soleGroundNode* nodes; // the first is the root, children come after their parents; none without triangles
	int32_t nodeCount;
	soleGroundColumns columns;
	soleGroundPart* parts;
	int32_t partCount;
	bool anyTwoSided;
	soleGroundField* fields;
	int32_t fieldCount;
	soleGroundPlane* planes;
	int32_t planeCount;
	soleVec3 lower;
	soleVec3 upper;
	float extent; // furthest coordinate of any triangle, from the origin
};

/// A probe made ready. Arrays instead of vectors: axes are picked by number.
typedef struct soleGroundQuery
{
	float start[3];
	float direction[3];
	float length;
	float radius;
	uint32_t mask;
	/// Shear that turns the direction into the axis of its largest part: axes[2] is that axis, the other two keep the
	/// winding of triangles.
	int axes[3];
	float shear[2];
	/// The direction is along one axis.
	bool aligned;
} soleGroundQuery;

/// The nearest that was met so far, in the space of the query.
typedef struct soleGroundTouch
{
	bool hit;
	bool inside; // the start already touches
	/// Travel along the direction. What is further than this is of no interest.
	double t;
	/// Inside: distance from the start to the point. Else 0.
	double gap;
	/// Which of two faces that share the point is meant: the one that the way meets more squarely; inside: the one
	/// whose plane the start is further from.
	double facing;
	int64_t index;
	uint32_t layer;
	int32_t surface;
	soleVec3 point;
	soleVec3 normal;
} soleGroundTouch;

/// One touch goes before another: nearer, then closer, then met more squarely, then the lower index. A total order over
/// faces, so that no order of visits shows in the answer.
static inline bool soleGroundTouch_IsBefore( const soleGroundTouch* a, const soleGroundTouch* b )
{
	if ( a->t != b->t )
	{
		return a->t < b->t;
	}
	if ( b->hit == false )
	{
		return true;
	}
	if ( a->gap != b->gap )
	{
		return a->gap < b->gap;
	}
	if ( a->facing != b->facing )
	{
		return a->facing > b->facing;
	}
	return a->index < b->index;
}

/// The stride may be any: copied byte by byte, not read as floats in place.
static inline void soleReadMeshVertex( const soleGroundMesh* mesh, uint32_t vertex, float p[3] )
{
	memcpy( p, (const char*)mesh->vertices + (size_t)vertex * (size_t)mesh->vertexStride, 3 * sizeof( float ) );
}

// ray.c

/// @return false where the probe asks nothing: not finite, without a length or a direction.
bool soleMakeGroundQuery(
    soleVec3 start, soleVec3 direction, float length, float radius, uint32_t mask, soleGroundQuery* query );
/// Ray against one triangle of a block. Fills all of touch but index, layer and surface.
bool soleRayMeetsTriangle(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleGroundTouch* touch );

// sphere.c

/// Moving sphere against one triangle of a block. Fills all of touch but index, layer and surface.
bool soleSphereMeetsTriangle(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleGroundTouch* touch );

static inline bool soleMeetTriangle(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleGroundTouch* touch )
{
	return query->radius > 0.0f ? soleSphereMeetsTriangle( query, block, lane, twoSided, touch )
	                            : soleRayMeetsTriangle( query, block, lane, twoSided, touch );
}

// height_field.c

/// Counts the triangles of all cells, holes included.
int64_t soleGroundField_GetTriangleCount( const soleGroundField* field );
void soleGroundField_GetBounds( const soleGroundField* field, soleVec3* lower, soleVec3* upper );
/// Improves best, which may come from elsewhere. firstIndex is what the field's first triangle counts as in ties.
void soleCastHeightField(
    const soleGroundField* field, const soleGroundQuery* query, int64_t firstIndex, soleGroundTouch* best );

// columns.c

/// Makes the columns along an axis where they are of use. @return false when out of memory: the ground may still be
/// destroyed.
bool soleMakeColumns( soleGround* ground, int axis );
void soleFreeColumns( soleGround* ground );
/// Fits them to nodes that were refitted.
void soleRefitColumns( soleGround* ground );
/// The cell of a coordinate along axes[side]; those outside count to the outermost.
static inline int32_t soleGroundColumns_FindCell( const soleGroundColumns* columns, int side, float x )
{
	float cell = ( x - columns->low[side] ) * columns->cellsPerUnit[side];
	cell = cell > 0.0f ? cell : 0.0f; // no number counts as zero
	return (int32_t)( cell < columns->lastCell[side] ? cell : columns->lastCell[side] );
}

static inline const soleGroundCell* soleGroundColumns_GetCell( const soleGroundColumns* columns, int32_t x, int32_t y )
{
	return columns->cells + (size_t)y * (size_t)columns->counts[0] + (size_t)x;
}

/// The nodes of a cell.
static inline const uint32_t* soleGroundColumns_GetNodes(
    const soleGroundColumns* columns, const soleGroundCell* cell, uint32_t* count )
{
	if ( cell->nodes[0] != SOLE_GROUND_NONE && ( cell->nodes[0] & SOLE_GROUND_LIST ) != 0 )
	{
		*count = cell->nodes[1];
		return columns->lists + ( cell->nodes[0] & ~SOLE_GROUND_LIST );
	}
	*count = cell->nodes[0] == SOLE_GROUND_NONE ? 0 : ( cell->nodes[1] == SOLE_GROUND_NONE ? 1 : 2 );
	return cell->nodes;
}

// cast.c

/// The nearest of all that a ground holds. @return false where nothing was met.
bool soleCastQuery( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best );

// check.c

/// @param message what is wrong and how to mend it. May be NULL.
bool soleCheckGroundDef( const soleGroundDef* def, soleMessage* message );

// build.c

/// The mesh that a triangle is of.
int32_t soleGround_FindPart( const soleGround* ground, uint32_t index );
/// Reads the corners of a triangle from the meshes that the ground was made of.
void soleReadTriangle( const soleGround* ground, const soleGroundDef* def, uint32_t index, float corners[3][3] );

// tree.c

/// Makes blocks and nodes of the parts' triangles, but for those without area. @return false when out of memory: the
/// ground may still be destroyed.
bool soleBuildGroundTree( soleGround* ground, const soleGroundDef* def );
/// Takes the corners anew and fits all boxes to them.
void soleRefitGroundTree( soleGround* ground, const soleGroundDef* def );

#endif
