// SPDX-License-Identifier: MIT
// Points in the frame of a sole, sets of them, and the planes that lie on them: what resting is made of.
#ifndef SOLE_PLACE_REST_PLANE_H
#define SOLE_PLACE_REST_PLANE_H

#include "place/place.h"

#define SOLE_WIDTH 4
#include "base/simd.h"

#define SOLE_MAX_REST_POINTS SOLE_MAX_PROBES_PER_LEG // a multiple of the width

/// Samples in the foot's own frame, around the load point. Subsets are bits, one a point. Points are also looked at
/// four at once: copies of the first fill up the last four.
typedef struct soleRestPoints
{
	float u[SOLE_MAX_REST_POINTS];    // ahead
	float v[SOLE_MAX_REST_POINTS];    // to the side
	float h[SOLE_MAX_REST_POINTS];    // up
	float fore[SOLE_MAX_REST_POINTS]; // 1 ahead of the ball line, else 0
	const soleGroundSample* samples[SOLE_MAX_REST_POINTS];
	int32_t count;
	uint32_t ahead; // of the ball line
	uint32_t under; // within the sole, without the margin
	uint32_t steep;
	int32_t asked;      // places under the sole, with those where nothing was met
	int32_t askedAhead; // those ahead of the ball line
	bool atHeel, atToe; // places near both ends of the sole were asked for
	float gap;          // largest distance between those asked for in between, where they are on a line
} soleRestPoints;

/// c + gu u + gv v
typedef struct soleFit
{
	float c, gu, gv;
} soleFit;

static inline bool soleHas( uint32_t set, int32_t i )
{
	return ( set >> i & 1u ) != 0;
}

static inline uint32_t soleBit( int32_t i )
{
	return 1u << i;
}

/// The first so many.
static inline uint32_t soleFirst( int32_t count )
{
	return count < 32 ? soleBit( count ) - 1u : ~0u;
}

static inline int32_t soleCount( uint32_t set )
{
	// Bits side by side are added up: pairs, fours, bytes, then all bytes into the highest.
	set -= set >> 1 & 0x55555555u;
	set = ( set & 0x33333333u ) + ( set >> 2 & 0x33333333u );
	return (int32_t)( ( ( set + ( set >> 4 ) ) & 0x0f0f0f0fu ) * 0x01010101u >> 24 );
}

/// Heights of a plane at four points from the i-th on.
static inline soleWide soleGetFitHeights( const soleRestPoints* p, int32_t i, const soleFit* fit )
{
	soleWide c =
	    soleWide_Add( soleWide_Set( fit->c ), soleWide_Mul( soleWide_Set( fit->gu ), soleWide_Load( p->u + i ) ) );
	return soleWide_Add( c, soleWide_Mul( soleWide_Set( fit->gv ), soleWide_Load( p->v + i ) ) );
}

/// The level that has the highest point under the sole.
/// @param gap heights that differ by as much more than they are apart are not on one level
uint32_t soleFindHighestLevel( const soleRestPoints* p, float gap );

/// The highest plane at the load point through points of a set that hold it between them: three, or two along the foot
/// where no three do. Flat where no two do.
/// @param line they lie on one: there are no triangles
soleFit soleFitResting( const soleRestPoints* p, uint32_t set, bool line, float footLength );

/// Sets the height so that the plane touches points of the set and none is above it.
void soleTouch( const soleRestPoints* p, uint32_t set, soleFit* fit );

#endif
