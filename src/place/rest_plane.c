// SPDX-License-Identifier: MIT
// Levels and resting planes: rules 2 and 3 of rest.c. Lengths in the world's, around the load point.
#include "place/rest_plane.h"

#define MOST_EXCHANGES 32 // of corners: a few are needed

// ---------------------------------------------------------------------------------------------------------- levels

/// Points are neighbours when no other point is nearer to both: the relative neighbourhood graph. That is rows and
/// columns in the layouts here, and stays right when probes are missing or late.
static bool soleAreNeighbours( const soleRestPoints* p, int32_t i, int32_t j, float d2 )
{
	for ( int32_t k = 0; k < p->count; ++k )
	{
		float iu = p->u[i] - p->u[k], iv = p->v[i] - p->v[k];
		float ju = p->u[j] - p->u[k], jv = p->v[j] - p->v[k];
		if ( iu * iu + iv * iv < d2 && ju * ju + jv * jv < d2 && k != i && k != j )
		{
			return false;
		}
	}
	return true;
}

static float soleDistance2( const soleRestPoints* p, int32_t i, int32_t j )
{
	float du = p->u[i] - p->u[j], dv = p->v[i] - p->v[j];
	return du * du + dv * dv;
}

/// Which of four points from the j-th on cannot be on one level with the i-th: higher or lower by more than they are
/// apart and a gap.
static inline soleWideMask soleAreApart( const soleRestPoints* p, int32_t i, int32_t j, float gap )
{
	soleWide du = soleWide_Sub( soleWide_Set( p->u[i] ), soleWide_Load( p->u + j ) );
	soleWide dv = soleWide_Sub( soleWide_Set( p->v[i] ), soleWide_Load( p->v + j ) );
	soleWide d2 = soleWide_Add( soleWide_Mul( du, du ), soleWide_Mul( dv, dv ) );
	soleWide h = soleWide_Set( p->h[i] ), other = soleWide_Load( p->h + j );
	soleWide over = soleWide_Max( soleWide_Sub( h, other ), soleWide_Sub( other, h ) );
	soleWide more = soleWide_Sub( over, soleWide_Set( gap ) );
	soleWideMask higher = soleWide_Less( soleWide_Set( 0.0f ), more );
	return soleWide_And( higher, soleWide_Less( d2, soleWide_Mul( more, more ) ) );
}

/// If all may be on one level, all are: neighbours join the whole.
static bool soleAreAllLevel( const soleRestPoints* p, float gap )
{
	float lowest = p->h[0], highest = p->h[0];
	for ( int32_t i = 1; i < p->count; ++i )
	{
		lowest = soleMinF( p->h[i], lowest );
		highest = soleMaxF( p->h[i], highest );
	}
	if ( highest - lowest <= gap )
	{
		return true; // as any two of them may
	}
	// All pairs, four at once and without branches; some of them twice.
	soleWideMask apart = soleAreApart( p, 0, 0, gap );
	for ( int32_t j = 0; j < p->count; j += SOLE_WIDTH )
	{
		for ( int32_t i = 0; i < p->count && i < j + SOLE_WIDTH; ++i )
		{
			apart = soleWide_Or( apart, soleAreApart( p, i, j, gap ) );
		}
	}
	return soleWide_GetBits( apart ) == 0;
}

/// The points that cannot be on one level with the i-th.
static uint32_t soleListApart( const soleRestPoints* p, int32_t i, float gap )
{
	uint32_t apart = 0;
	for ( int32_t j = 0; j < p->count; j += SOLE_WIDTH )
	{
		apart |= soleWide_GetBits( soleAreApart( p, i, j, gap ) ) << j;
	}
	return apart;
}

/// @param levels per point the set that it belongs to
static void soleJoinLevels( const soleRestPoints* p, float gap, uint32_t levels[SOLE_MAX_REST_POINTS] )
{
	for ( int32_t i = 0; i < p->count; ++i )
	{
		levels[i] = soleBit( i );
	}
	for ( int32_t i = 0; i < p->count; ++i )
	{
		uint32_t apart = soleListApart( p, i, gap );
		for ( int32_t j = i + 1; j < p->count; ++j )
		{
			if ( soleHas( levels[i] | apart, j ) == false && soleAreNeighbours( p, i, j, soleDistance2( p, i, j ) ) )
			{
				uint32_t both = levels[i] | levels[j];
				for ( int32_t k = 0; k < p->count; ++k )
				{
					levels[k] = soleHas( both, k ) ? both : levels[k];
				}
			}
		}
	}
}

// The others are left out: what hangs, and what stands beside it.
uint32_t soleFindHighestLevel( const soleRestPoints* p, float gap )
{
	uint32_t levels[SOLE_MAX_REST_POINTS];
	if ( p->count < 2 || soleAreAllLevel( p, gap ) )
	{
		return soleFirst( p->count );
	}
	soleJoinLevels( p, gap, levels );
	int32_t highest = 0;
	for ( int32_t i = 1; i < p->count; ++i )
	{
		bool under = soleHas( p->under, i );
		bool higher = under == soleHas( p->under, highest ) ? p->h[i] > p->h[highest] : under;
		highest = higher ? i : highest;
	}
	return levels[highest];
}

// ----------------------------------------------------------------------------------------------------- resting plane

/// The points of a set, in order. @return how many
static int32_t soleList( uint32_t set, int32_t list[SOLE_MAX_REST_POINTS] )
{
	int32_t count = 0;
	for ( ; set != 0; set &= set - 1u )
	{
		list[count++] = (int32_t)soleGetLowestBit( set );
	}
	return count;
}

/// The plane through three points if their triangle holds the load point (the origin).
SOLE_INLINE bool soleFitTriangle( const soleRestPoints* p, int32_t i, int32_t j, int32_t k, float area, soleFit* fit )
{
	float u = p->u[i], v = p->v[i], h = p->h[i];
	float bu = p->u[j] - u, bv = p->v[j] - v, cu = p->u[k] - u, cv = p->v[k] - v;
	float d = bu * cv - cu * bv;
	if ( d < area && d > -area )
	{
		return false;
	}
	float s = 1.0f / d;
	float wb = s * ( -u * cv + v * cu );
	float wc = s * ( -bu * v + bv * u );
	float wa = 1.0f - wb - wc;
	if ( wa < -1e-5f || wb < -1e-5f || wc < -1e-5f )
	{
		return false;
	}
	float bh = p->h[j] - h, ch = p->h[k] - h;
	fit->gu = s * ( bh * cv - ch * bv );
	fit->gv = s * ( bu * ch - cu * bh );
	fit->c = h - fit->gu * u - fit->gv * v;
	return true;
}

/// The slope along the foot through the best pair that brackets the load point.
static bool soleFitPair( const soleRestPoints* p, int32_t i, int32_t j, float shortest, soleFit* fit )
{
	float du = p->u[j] - p->u[i];
	if ( ( du < shortest && du > -shortest ) || p->u[i] * p->u[j] > 0.0f )
	{
		return false;
	}
	fit->gu = ( p->h[j] - p->h[i] ) / du;
	fit->gv = 0.0f;
	fit->c = p->h[i] - fit->gu * p->u[i];
	return true;
}

/// The points of a set, those first that are furthest to a side: triangles need them. Of equals the lower comes first.
static int32_t soleListBySide( const soleRestPoints* p, uint32_t set, int32_t ordered[SOLE_MAX_REST_POINTS] )
{
	int32_t list[SOLE_MAX_REST_POINTS];
	float aside[SOLE_MAX_REST_POINTS];
	int32_t count = soleList( set, list );
	for ( int32_t i = 0; i < count; ++i )
	{
		aside[i] = p->v[list[i]] * p->v[list[i]];
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		// Each counts those before it: nothing to foretell wrongly.
		int32_t before = 0;
		for ( int32_t k = 0; k < count; ++k )
		{
			before += ( aside[k] > aside[i] ) | ( ( aside[k] == aside[i] ) & ( k < i ) ) ? 1 : 0;
		}
		ordered[before] = list[i];
	}
	return count;
}

/// Any three points whose triangle holds the load point.
static bool soleFindTriangle(
    const soleRestPoints* p, const int32_t* list, int32_t count, float area, int32_t corners[3], soleFit* fit )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t j = i + 1; j < count; ++j )
		{
			for ( int32_t k = j + 1; k < count; ++k )
			{
				if ( soleFitTriangle( p, list[i], list[j], list[k], area, fit ) )
				{
					corners[0] = list[i];
					corners[1] = list[j];
					corners[2] = list[k];
					return true;
				}
			}
		}
	}
	return false;
}

/// The point of a set that is highest over a plane. @return SOLE_NONE: none is over it
static int32_t soleFindOver( const soleRestPoints* p, uint32_t set, const soleFit* fit )
{
	float overs[SOLE_MAX_REST_POINTS];
	uint32_t above = 0;
	for ( int32_t i = 0; i < p->count; i += SOLE_WIDTH )
	{
		soleWide over = soleWide_Sub( soleWide_Load( p->h + i ), soleGetFitHeights( p, i, fit ) );
		soleWide_Store( overs + i, over );
		above |= soleWide_GetBits( soleWide_Less( soleWide_Set( 0.0f ), over ) ) << i;
	}
	int32_t highest = SOLE_NONE;
	float most = 0.0f;
	for ( above &= set; above != 0; above &= above - 1u )
	{
		int32_t i = (int32_t)soleGetLowestBit( above );
		highest = overs[i] > most ? i : highest;
		most = soleMaxF( overs[i], most );
	}
	return highest;
}

/// Exchanges one corner for a point over the plane, such that the triangle still holds the load point: the plane rises
/// there, or turns about it.
static bool soleExchange( const soleRestPoints* p, int32_t point, float area, int32_t corners[3], soleFit* fit )
{
	const int32_t around[5] = { corners[0], corners[1], corners[2], corners[0], corners[1] };
	soleFit best = *fit;
	int32_t leaving = SOLE_NONE;
	for ( int32_t i = 0; i < 3; ++i )
	{
		soleFit other;
		bool holds = soleFitTriangle( p, point, around[i + 1], around[i + 2], area, &other );
		if ( holds && ( leaving == SOLE_NONE ? other.c >= best.c : other.c > best.c ) )
		{
			best = other;
			leaving = i;
		}
	}
	if ( leaving == SOLE_NONE )
	{
		return false;
	}
	corners[leaving] = point;
	*fit = best;
	return true;
}

/// @return false: no triangle holds the load point
static bool soleFitHighestTriangle( const soleRestPoints* p, uint32_t set, float area, soleFit* fit )
{
	int32_t list[SOLE_MAX_REST_POINTS], corners[3];
	int32_t count = soleListBySide( p, set, list );
	if ( soleFindTriangle( p, list, count, area, corners, fit ) == false )
	{
		return false;
	}
	// Points that would make the triangle too thin are passed over until it is another one.
	uint32_t tried = set;
	for ( int32_t i = 0; i < MOST_EXCHANGES; ++i )
	{
		int32_t point = soleFindOver( p, tried, fit );
		if ( point == SOLE_NONE )
		{
			break;
		}
		tried = soleExchange( p, point, area, corners, fit ) ? set : tried & ~soleBit( point );
	}
	return true;
}

/// Along the foot, through the best pair that brackets the load point; flat through the highest where none does: that
/// is raised by soleTouch.
static soleFit soleFitBestPair( const soleRestPoints* p, const int32_t* list, int32_t count, float shortest )
{
	soleFit best = { 0.0f, 0.0f, 0.0f };
	bool found = false;
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t j = i + 1; j < count; ++j )
		{
			soleFit fit;
			bool brackets = soleFitPair( p, list[i], list[j], shortest, &fit );
			if ( brackets && ( found == false || fit.c > best.c ) )
			{
				best = fit;
				found = true;
			}
		}
	}
	return best;
}

soleFit soleFitResting( const soleRestPoints* p, uint32_t set, bool line, float footLength )
{
	soleFit fit;
	if ( line == false && soleFitHighestTriangle( p, set, 1e-3f * footLength * footLength, &fit ) )
	{
		return fit;
	}
	int32_t list[SOLE_MAX_REST_POINTS];
	int32_t count = soleList( set, list );
	return soleFitBestPair( p, list, count, 0.05f * footLength );
}

void soleTouch( const soleRestPoints* p, uint32_t set, soleFit* fit )
{
	bool first = true;
	for ( ; set != 0; set &= set - 1u )
	{
		int32_t i = (int32_t)soleGetLowestBit( set );
		float c = p->h[i] - fit->gu * p->u[i] - fit->gv * p->v[i];
		fit->c = first || c > fit->c ? c : fit->c;
		first = false;
	}
}
