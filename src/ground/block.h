// SPDX-License-Identifier: MIT
// Sifting the four triangles of a block in float, all at once, in the space of the query: which of them a probe may
// meet. Whether it does is decided elsewhere, one by one and in double. So nothing here may leave out what would be
// met, and how much is let pass shows in no answer.
#ifndef SOLE_GROUND_BLOCK_H
#define SOLE_GROUND_BLOCK_H

#define SOLE_WIDTH 4

#include "base/simd.h"
#include "ground/ground_internal.h"

/// Corners seen from the start, along the query's axes: x and y sheared, z along the way.
typedef struct soleSeenBlock
{
	soleWide x[3];
	soleWide y[3];
	soleWide z[3];
} soleSeenBlock;

/// For aligned probes: nothing is sheared.
static inline void soleSeeAlignedBlock(
    const soleGroundQuery* query, const soleGroundBlock* block, soleSeenBlock* seen )
{
	soleWide startX = soleWide_Set( query->start[query->axes[0]] );
	soleWide startY = soleWide_Set( query->start[query->axes[1]] );
	soleWide startZ = soleWide_Set( query->start[query->axes[2]] );
	for ( int i = 0; i < 3; ++i )
	{
		const float( *corner )[SOLE_GROUND_BLOCK_SIZE] = block->corners[i];
		seen->x[i] = soleWide_Sub( soleWide_Load( corner[query->axes[0]] ), startX );
		seen->y[i] = soleWide_Sub( soleWide_Load( corner[query->axes[1]] ), startY );
		seen->z[i] = soleWide_Sub( soleWide_Load( corner[query->axes[2]] ), startZ );
	}
}

static inline void soleSeeBlock( const soleGroundQuery* query, const soleGroundBlock* block, soleSeenBlock* seen )
{
	soleSeeAlignedBlock( query, block, seen );
	soleWide shearX = soleWide_Set( query->shear[0] );
	soleWide shearY = soleWide_Set( query->shear[1] );
	for ( int i = 0; i < 3 && query->aligned == false; ++i )
	{
		seen->x[i] = soleWide_Sub( seen->x[i], soleWide_Mul( shearX, seen->z[i] ) );
		seen->y[i] = soleWide_Sub( seen->y[i], soleWide_Mul( shearY, seen->z[i] ) );
	}
}

static inline soleWide soleEdgeFunction( const soleSeenBlock* seen, int from, int to )
{
	return soleWide_Sub( soleWide_Mul( seen->x[to], seen->y[from] ), soleWide_Mul( seen->y[to], seen->x[from] ) );
}

/// Rays: the edge functions of ray.c, in the same order, to the same bit. A triangle with both signs is not met.
static inline uint32_t soleSiftSeen( const soleSeenBlock* seen, bool twoSided )
{
	soleWide u = soleEdgeFunction( seen, 1, 2 );
	soleWide v = soleEdgeFunction( seen, 2, 0 );
	soleWide w = soleEdgeFunction( seen, 0, 1 );
	soleWide zero = soleWide_Set( 0.0f );
	soleWideMask refused =
	    soleWide_Or( soleWide_Or( soleWide_Less( u, zero ), soleWide_Less( v, zero ) ), soleWide_Less( w, zero ) );
	if ( twoSided )
	{
		refused = soleWide_And( refused,
		    soleWide_Or(
		        soleWide_Or( soleWide_Less( zero, u ), soleWide_Less( zero, v ) ), soleWide_Less( zero, w ) ) );
	}
	return ~soleWide_GetBits( refused ) & 15u;
}

static inline uint32_t soleSiftForRay( const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided )
{
	soleSeenBlock seen;
	soleSeeBlock( query, block, &seen );
	return soleSiftSeen( &seen, twoSided );
}

static inline uint32_t soleSiftForAlignedRay(
    const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided )
{
	soleSeenBlock seen;
	soleSeeAlignedBlock( query, block, &seen );
	return soleSiftSeen( &seen, twoSided );
}

/// See block.c. @param travel within which something is to be met
/// @param bounds before which those that stay are certainly not met
uint32_t soleSiftForSphere( const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided, float travel,
    float bounds[SOLE_GROUND_BLOCK_SIZE] );

/// Which triangles of a block a probe may meet before a travel, as bits. bounds is for spheres alone.
static inline uint32_t soleSiftBlock( const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided,
    float travel, float bounds[SOLE_GROUND_BLOCK_SIZE] )
{
	return query->radius > 0.0f ? soleSiftForSphere( query, block, twoSided, travel, bounds )
	                            : soleSiftForRay( query, block, twoSided );
}

#endif
