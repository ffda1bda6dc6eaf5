// SPDX-License-Identifier: MIT
// Sifting the four triangles of a block in float, all at once, in the space of the query: which of them a sphere may
// meet. Whether it does is decided elsewhere, one by one and in double. So nothing here may leave out what would be
// met, and how much is let pass shows in no answer.
//
// Seen along the way, the triangle and a disc about the way's start. Points at the shear's distance w from the
// way are off it by at least w |d_z| / |d|, so the disc has the radius R = r |d| / |d_z|. Outside an edge of length e
// by more than that, if its edge function s, twice an area, is beyond R e:
//   s < -( R e + error ),  error = 1e-5 Q,  Q the sum of the squares of all corners' coordinates seen from the start
// (a float edge function is off by less than 1e-6 ( 3 Q ); the sign of a triangle that is seen edge on may be wrong by
// as much, and is then as good as the other). And in the plane's own terms, n = u x v unnormalised, height H = -c . n
// of the start, at travel T still away from it:
//   H > r |n| + error  and  H + T ( d . n ) > r |n| + error,  error = 1e-6 ( |c| + T |d| + r ) ( u u + v v )
// What stays and starts off the plane is not met before t = ( H - r |n| - error ) / -( d . n ).
// Sums and squares of numbers that overflow are infinite or no numbers, and let pass: all tests are of the form "less".
#include "ground/block.h"

static inline soleWide soleSquare( soleWide a )
{
	return soleWide_Mul( a, a );
}

static inline soleWide soleDotWide( const soleWide a[3], const soleWide b[3] )
{
	return soleWide_Add(
	    soleWide_Add( soleWide_Mul( a[0], b[0] ), soleWide_Mul( a[1], b[1] ) ), soleWide_Mul( a[2], b[2] ) );
}

/// Those whose view along the way is certainly outside the disc.
static soleWideMask soleFindAside( const soleGroundQuery* query, const soleGroundBlock* block, float pathSize )
{
	soleSeenBlock seen;
	soleSeeBlock( query, block, &seen );
	soleWide zero = soleWide_Set( 0.0f );
	soleWide squares = zero;
	for ( int i = 0; i < 3; ++i )
	{
		// What x and y were before the shear took parts of z from them is less than both together.
		soleWide plane = soleWide_Add( soleSquare( seen.x[i] ), soleSquare( seen.y[i] ) );
		squares = soleWide_Add( squares, soleWide_Add( plane, soleSquare( seen.z[i] ) ) );
	}
	soleWide error = soleWide_Add( soleWide_Mul( soleWide_Set( 4e-5f ), squares ), soleWide_Set( 1e-30f ) );
	soleWide radius = soleWide_Set( query->radius * pathSize / fabsf( query->direction[query->axes[2]] ) * 1.00001f );
	soleWide sides[3];
	soleWide least[3];
	for ( int i = 0; i < 3; ++i )
	{
		int from = i == 2 ? 0 : i + 1;
		int to = from == 2 ? 0 : from + 1;
		soleWide ex = soleWide_Sub( seen.x[to], seen.x[from] );
		soleWide ey = soleWide_Sub( seen.y[to], seen.y[from] );
		soleWide length = soleWide_Sqrt( soleWide_Add( soleSquare( ex ), soleSquare( ey ) ) );
		sides[i] = soleEdgeFunction( &seen, from, to );
		least[i] = soleWide_Sub( zero, soleWide_Add( soleWide_Mul( radius, length ), error ) );
	}
	soleWide area = soleWide_Add( soleWide_Add( sides[0], sides[1] ), sides[2] );
	soleWideMask turned = soleWide_Less( area, zero );
	soleWideMask aside = soleWide_Less( soleWide_Select( turned, soleWide_Sub( zero, sides[0] ), sides[0] ), least[0] );
	for ( int i = 1; i < 3; ++i )
	{
		soleWide side = soleWide_Select( turned, soleWide_Sub( zero, sides[i] ), sides[i] );
		aside = soleWide_Or( aside, soleWide_Less( side, least[i] ) );
	}
	return aside;
}

/// Those whose plane is certainly not reached within the travel, or whose back the sphere certainly starts behind.
/// @param bounds where the planes are reached, not too late
static soleWideMask soleFindBeyond( const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided,
    float travel, float pathSize, float bounds[SOLE_GROUND_BLOCK_SIZE] )
{
	soleWide c[3];
	soleWide u[3];
	soleWide v[3];
	soleWide d[3];
	for ( int k = 0; k < 3; ++k )
	{
		soleWide first = soleWide_Load( block->corners[0][k] );
		c[k] = soleWide_Sub( first, soleWide_Set( query->start[k] ) );
		u[k] = soleWide_Sub( soleWide_Load( block->corners[1][k] ), first );
		v[k] = soleWide_Sub( soleWide_Load( block->corners[2][k] ), first );
		d[k] = soleWide_Set( query->direction[k] );
	}
	soleWide n[3];
	for ( int k = 0; k < 3; ++k )
	{
		int a = k == 2 ? 0 : k + 1;
		int b = a == 2 ? 0 : a + 1;
		n[k] = soleWide_Sub( soleWide_Mul( u[a], v[b] ), soleWide_Mul( u[b], v[a] ) );
	}
	soleWide zero = soleWide_Set( 0.0f );
	soleWide height = soleWide_Sub( zero, soleDotWide( c, n ) );
	soleWide climb = soleDotWide( d, n );
	soleWide reach =
	    soleWide_Add( soleWide_Sqrt( soleDotWide( c, c ) ), soleWide_Set( travel * pathSize + query->radius ) );
	soleWide edges = soleWide_Add( soleDotWide( u, u ), soleDotWide( v, v ) );
	soleWide error =
	    soleWide_Add( soleWide_Mul( soleWide_Set( 1e-6f ), soleWide_Mul( reach, edges ) ), soleWide_Set( 1e-30f ) );
	soleWideMask behind = soleWide_Less( height, soleWide_Sub( zero, error ) );
	soleWideMask turned = soleWide_Less( height, zero );
	height = soleWide_Select( turned, soleWide_Sub( zero, height ), height );
	climb = soleWide_Select( turned, soleWide_Sub( zero, climb ), climb );
	soleWide near =
	    soleWide_Add( soleWide_Mul( soleWide_Set( query->radius ), soleWide_Sqrt( soleDotWide( n, n ) ) ), error );
	soleWide end = soleWide_Add( height, soleWide_Mul( soleWide_Set( travel ), climb ) );
	soleWideMask off = soleWide_Less( near, height );
	soleWideMask beyond = soleWide_And( off, soleWide_Less( near, end ) );
	soleWide bound = soleWide_Div(
	    soleWide_Mul( soleWide_Sub( height, near ), soleWide_Set( 0.999999f ) ), soleWide_Sub( zero, climb ) );
	// Where that is no number, or the sphere starts on the plane, nothing is known.
	soleWideMask known = soleWide_And( off, soleWide_Less( zero, bound ) );
	soleWide_Store( bounds, soleWide_Select( known, bound, zero ) );
	return twoSided ? beyond : soleWide_Or( beyond, behind );
}

uint32_t soleSiftForSphere( const soleGroundQuery* query, const soleGroundBlock* block, bool twoSided, float travel,
    float bounds[SOLE_GROUND_BLOCK_SIZE] )
{
	const float* d = query->direction;
	float pathSize = sqrtf( ( d[0] * d[0] + d[1] * d[1] ) + d[2] * d[2] ) * 1.00001f;
	soleWideMask refused = soleWide_Or( soleFindAside( query, block, pathSize ),
	    soleFindBeyond( query, block, twoSided, travel * 1.000001f, pathSize, bounds ) );
	return ~soleWide_GetBits( refused ) & 15u;
}
