// SPDX-License-Identifier: MIT
// Ranges of triangles that are to become a tree, and how one is cut in two. World space.
#ifndef SOLE_GROUND_SPLIT_H
#define SOLE_GROUND_SPLIT_H

#include "ground/ground_internal.h"

typedef struct soleBox
{
	float lower[3];
	float upper[3];
} soleBox;

/// A triangle while it looks for its place.
typedef struct soleReference
{
	soleBox box;
	uint32_t index; // counted through all meshes
	uint32_t leaf;  // 1 where it is the first of a block; then the block's number
} soleReference;

/// A range of triangles and the box around it.
typedef struct soleRange
{
	soleBox box;
	int32_t first;
	int32_t count;
} soleRange;

static inline soleBox soleBox_Empty( void )
{
	soleBox box;
	for ( int k = 0; k < 3; ++k )
	{
		box.lower[k] = INFINITY;
		box.upper[k] = -INFINITY;
	}
	return box;
}

static inline void soleBox_Add( soleBox* box, const soleBox* other )
{
	for ( int k = 0; k < 3; ++k )
	{
		box->lower[k] = soleMinF( box->lower[k], other->lower[k] );
		box->upper[k] = soleMaxF( box->upper[k], other->upper[k] );
	}
}

/// Half the surface. In double: the square of a far coordinate has no room in a float.
static inline double soleBox_GetArea( const soleBox* box )
{
	double x = (double)box->upper[0] - (double)box->lower[0];
	double y = (double)box->upper[1] - (double)box->lower[1];
	double z = (double)box->upper[2] - (double)box->lower[2];
	return x * y + y * z + z * x;
}

soleRange soleMakeRange( const soleReference* references, int32_t first, int32_t count );
/// Cuts a range in two, none empty; its references change places. byCount: into equal halves.
void soleSplitRange( soleReference* references, bool byCount, const soleRange* range, soleRange halves[2] );

#endif
