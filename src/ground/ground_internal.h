// SPDX-License-Identifier: MIT
// What the files of the ground share: how it is stored, a prepared question, the best answer so far. World space, but
// for height fields, which are asked in their own axes.
#ifndef SOLE_GROUND_INTERNAL_H
#define SOLE_GROUND_INTERNAL_H

#include "sole/ground.h"

#define SOLE_GROUND_LEAF_SIZE 4
// The tree is never deeper than this: beyond half of it ranges are halved by count. See tree.c.
#define SOLE_GROUND_MAX_DEPTH 40
// Each level leaves at most three brothers behind.
#define SOLE_GROUND_STACK_SIZE ( 3 * SOLE_GROUND_MAX_DEPTH + 4 )
#define SOLE_GROUND_NO_CHILD 0xffffffffu
// A child of a node has its low three bits for the number of triangles.
#define SOLE_GROUND_MAX_TRIANGLES ( 1 << 28 )

/// A triangle as it is asked: corners are numbers of vertices.
typedef struct soleGroundTriangle
{
	uint32_t corners[3];
	uint32_t index; // counted through all meshes as they were given: decides ties
	uint32_t mesh;
} soleGroundTriangle;

/// Four boxes, one per child, axis by axis. Children fill the lower places; a free one is SOLE_GROUND_NO_CHILD.
typedef struct soleGroundNode
{
	float lower[3][4];
	float upper[3][4];
	/// Number of triangles (0: a node) in the low three bits, above them the first triangle or the node.
	uint32_t children[4];
} soleGroundNode;

/// What all triangles of one mesh have in common.
typedef struct soleGroundPart
{
	uint32_t firstIndex; // of its first triangle
	uint32_t layer;      // where the ground has no layers per triangle
	int32_t surface;
	bool twoSided;
} soleGroundPart;

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
	float* vertices;         // 3 a vertex, all meshes one after another
	int32_t vertexCount;
	int32_t vertexCapacity;        // what was asked of the allocator
	soleGroundTriangle* triangles; // in the order of the tree's leaves
	int32_t triangleCount;
	int32_t triangleCapacity; // more than the count where triangles without area were dropped
	uint32_t* layers;         // per triangle, or NULL: those of the parts
	soleGroundNode* nodes;    // the first is the root; none where there are no triangles
	int32_t nodeCount;
	soleGroundPart* parts;
	int32_t partCount;
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

// ray.c

/// @return false where the probe asks nothing: not finite, without a length or a direction.
bool soleMakeGroundQuery(
    soleVec3 start, soleVec3 direction, float length, float radius, uint32_t mask, soleGroundQuery* query );
/// Ray against one triangle. Fills all of touch but index, layer and surface.
bool soleRayMeetsTriangle(
    const soleGroundQuery* query, const float* const corners[3], bool twoSided, soleGroundTouch* touch );

// sphere.c

/// Moving sphere against one triangle. Fills all of touch but index, layer and surface.
bool soleSphereMeetsTriangle(
    const soleGroundQuery* query, const float* const corners[3], bool twoSided, soleGroundTouch* touch );

static inline bool soleMeetTriangle(
    const soleGroundQuery* query, const float* const corners[3], bool twoSided, soleGroundTouch* touch )
{
	return query->radius > 0.0f ? soleSphereMeetsTriangle( query, corners, twoSided, touch )
	                            : soleRayMeetsTriangle( query, corners, twoSided, touch );
}

// height_field.c

/// Counts the triangles of all cells, holes included.
int64_t soleGroundField_GetTriangleCount( const soleGroundField* field );
void soleGroundField_GetBounds( const soleGroundField* field, soleVec3* lower, soleVec3* upper );
/// Improves best, which may come from elsewhere. firstIndex is what the field's first triangle counts as in ties.
void soleCastHeightField(
    const soleGroundField* field, const soleGroundQuery* query, int64_t firstIndex, soleGroundTouch* best );

// cast.c

/// The nearest of all that a ground holds. @return false where nothing was met.
bool soleCastQuery( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best );

// tree.c

/// Sorts the ground's triangles and makes its nodes. @return false when out of memory: the ground may still be
/// destroyed.
bool soleBuildGroundTree( soleGround* ground );

#endif
