// SPDX-License-Identifier: MIT
// The exact surface that feet are measured against: triangles in double precision, in a frame of the world turned so
// that its third axis is up (u, v across, h along up), behind a uniform grid over u and v. Shares nothing with
// ground.h. Nearest point of a triangle: by the plane where the foot of the perpendicular lies inside, else by its
// three edges.
#include "measure/terrain.h"

#include "base/core.h"

#include <math.h>

// A face steeper than this carries nothing: of a wall turned by rounding a sliver would otherwise count as ground.
#define LEAST_RISE 1e-4 // cosine between normal and up

#define EDGE_SLACK 1e-9 // share of a triangle by which neighbours overlap, so that no point falls between them
#define MAX_CELLS_A_SIDE 2048

typedef struct soleTerrainFace
{
	soleVec3d corners[3]; // u, v, h
	soleVec3d normal;     // u, v, h, unit; zero where the face has no area
} soleTerrainFace;

struct soleTerrain
{
	soleAllocator allocator;
	bool ownAllocator; // false: malloc and free
	soleVec3d axes[3]; // u, v, up in the world
	int32_t faceCount;
	soleTerrainFace* faces;
	double low[2]; // least u and v
	double cellSize;
	int32_t cells[2];
	int32_t* firsts; // per cell, and one more: where its faces begin in items
	int32_t* items;
	int32_t itemCount;
};

typedef struct soleCellRange
{
	int32_t low[2];
	int32_t high[2];
} soleCellRange;

static soleVec3d soleToTerrain( const soleTerrain* terrain, soleVec3d p )
{
	return ( soleVec3d ){ soleDotD( p, terrain->axes[0] ), soleDotD( p, terrain->axes[1] ),
		soleDotD( p, terrain->axes[2] ) };
}

static int32_t soleClampCell( double cell, int32_t count )
{
	return cell > 0.0 ? ( cell < (double)count ? (int32_t)cell : count - 1 ) : 0;
}

static soleCellRange soleFaceCells( const soleTerrain* terrain, const soleTerrainFace* face )
{
	const soleVec3d* c = face->corners;
	double low[2] = { fmin( c[0].x, fmin( c[1].x, c[2].x ) ), fmin( c[0].y, fmin( c[1].y, c[2].y ) ) };
	double high[2] = { fmax( c[0].x, fmax( c[1].x, c[2].x ) ), fmax( c[0].y, fmax( c[1].y, c[2].y ) ) };
	// A little wider than the face, as its inside is.
	double slack = 2.0 * EDGE_SLACK * ( high[0] - low[0] + high[1] - low[1] );
	soleCellRange range;
	for ( int32_t k = 0; k < 2; ++k )
	{
		range.low[k] = soleClampCell( ( low[k] - slack - terrain->low[k] ) / terrain->cellSize, terrain->cells[k] );
		range.high[k] = soleClampCell( ( high[k] + slack - terrain->low[k] ) / terrain->cellSize, terrain->cells[k] );
	}
	return range;
}

// ---------------------------------------------------------------------------------------------------------- build

static soleResult soleCheckTerrain( const float* positions, int32_t vertexCount, const uint32_t* indices,
    int32_t triangleCount, soleVec3 up, soleMessage* message )
{
	if ( positions == NULL || vertexCount < 3 || indices == NULL || triangleCount < 1 )
	{
		soleSetMessage(
		    message, "triangleCount is %d and vertexCount %d: give at least one triangle", triangleCount, vertexCount );
		return sole_invalidDefinition;
	}
	float length = soleLength( up );
	if ( !( length > 1e-6f ) || soleIsFinite( length ) == false )
	{
		soleSetMessage( message, "up has no direction: give the unit vector out of the ground" );
		return sole_invalidDefinition;
	}
	for ( size_t i = 0; i < 3 * (size_t)vertexCount; ++i )
	{
		if ( soleIsFinite( positions[i] ) == false )
		{
			soleSetMessage( message, "positions: vertex %d is not finite: mend the mesh", (int)( i / 3 ) );
			return sole_invalidDefinition;
		}
	}
	for ( size_t i = 0; i < 3 * (size_t)triangleCount; ++i )
	{
		if ( indices[i] >= (uint32_t)vertexCount )
		{
			soleSetMessage( message, "indices: triangle %d uses vertex %u of %d: indices must be below vertexCount",
			    (int)( i / 3 ), (unsigned)indices[i], vertexCount );
			return sole_invalidDefinition;
		}
	}
	return sole_success;
}

static void soleFillFaces( soleTerrain* terrain, const float* positions, const uint32_t* indices )
{
	for ( int32_t i = 0; i < terrain->faceCount; ++i )
	{
		soleTerrainFace* face = terrain->faces + i;
		for ( int32_t k = 0; k < 3; ++k )
		{
			const float* p = positions + 3 * (size_t)indices[3 * (size_t)i + (size_t)k];
			face->corners[k] = soleToTerrain( terrain, soleWiden( soleVec( p[0], p[1], p[2] ) ) );
		}
		soleVec3d ab = soleSubD( face->corners[1], face->corners[0] );
		soleVec3d ac = soleSubD( face->corners[2], face->corners[0] );
		soleVec3d none = { 0.0, 0.0, 0.0 };
		face->normal = soleUnitD( soleCrossD( ab, ac ), none );
	}
}

/// About as many cells as faces, fewer where long faces would fill too many of them.
static int64_t soleSizeGrid( soleTerrain* terrain )
{
	double low[2] = { HUGE_VAL, HUGE_VAL };
	double high[2] = { -HUGE_VAL, -HUGE_VAL };
	for ( int32_t i = 0; i < 3 * terrain->faceCount; ++i )
	{
		soleVec3d c = terrain->faces[i / 3].corners[i % 3];
		low[0] = fmin( low[0], c.x );
		low[1] = fmin( low[1], c.y );
		high[0] = fmax( high[0], c.x );
		high[1] = fmax( high[1], c.y );
	}
	double size[2] = { high[0] - low[0], high[1] - low[1] };
	double longest = fmax( fmax( size[0], size[1] ), 1e-6 );
	terrain->low[0] = low[0];
	terrain->low[1] = low[1];
	terrain->cellSize = fmax( sqrt( size[0] * size[1] / (double)terrain->faceCount ), longest / MAX_CELLS_A_SIDE );
	for ( ;; )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			terrain->cells[k] = (int32_t)( size[k] / terrain->cellSize ) + 1;
		}
		int64_t count = 0;
		for ( int32_t i = 0; i < terrain->faceCount; ++i )
		{
			soleCellRange r = soleFaceCells( terrain, terrain->faces + i );
			count += (int64_t)( r.high[0] - r.low[0] + 1 ) * ( r.high[1] - r.low[1] + 1 );
		}
		// With one cell count is faceCount, so this ends.
		if ( count <= 64 + 16 * (int64_t)terrain->faceCount && count < INT32_MAX )
		{
			return count;
		}
		terrain->cellSize *= 2.0;
	}
}

static size_t soleCellCount( const soleTerrain* terrain )
{
	return (size_t)terrain->cells[0] * (size_t)terrain->cells[1];
}

static void soleFillGrid( soleTerrain* terrain )
{
	// Counting sort: how many a cell holds, where its last would end, then filled from the back.
	for ( int32_t pass = 0; pass < 2; ++pass )
	{
		for ( int32_t i = terrain->faceCount - 1; i >= 0; --i )
		{
			soleCellRange r = soleFaceCells( terrain, terrain->faces + i );
			for ( int32_t y = r.low[1]; y <= r.high[1]; ++y )
			{
				for ( int32_t x = r.low[0]; x <= r.high[0]; ++x )
				{
					int32_t* first = terrain->firsts + (size_t)y * (size_t)terrain->cells[0] + (size_t)x;
					if ( pass == 0 )
					{
						*first += 1;
					}
					else
					{
						*first -= 1;
						terrain->items[*first] = i;
					}
				}
			}
		}
		for ( size_t c = 1; pass == 0 && c <= soleCellCount( terrain ); ++c )
		{
			terrain->firsts[c] += terrain->firsts[c - 1];
		}
	}
}

soleResult soleCreateTerrain( const float* positions, int32_t vertexCount, const uint32_t* indices,
    int32_t triangleCount, soleVec3 up, const soleAllocator* allocator, soleTerrain** terrain, soleMessage* message )
{
	SOLE_ASSERT( terrain != NULL && "terrain: give the address of a pointer" );
	if ( terrain == NULL )
	{
		return sole_invalidDefinition;
	}
	*terrain = NULL;
	soleResult result = soleCheckTerrain( positions, vertexCount, indices, triangleCount, up, message );
	if ( result != sole_success )
	{
		return result;
	}
	soleTerrain* made = soleAlloc( allocator, sizeof *made );
	if ( made == NULL )
	{
		soleSetMessage( message, "out of memory for a terrain" );
		return sole_outOfMemory;
	}
	made->ownAllocator = allocator != NULL;
	if ( allocator != NULL )
	{
		made->allocator = *allocator;
	}
	soleVec3 unit = soleNormalizeOr( soleScale( 1.0f / soleLength( up ), up ), soleVec( 0.0f, 1.0f, 0.0f ) );
	made->axes[2] = soleUnitD( soleWiden( unit ), ( soleVec3d ){ 0.0, 1.0, 0.0 } );
	made->axes[0] = soleWiden( soleAnyOrthogonal( unit ) );
	made->axes[0] = soleUnitD( soleRejectD( made->axes[0], made->axes[2] ), ( soleVec3d ){ 1.0, 0.0, 0.0 } );
	made->axes[1] = soleCrossD( made->axes[2], made->axes[0] );
	made->faceCount = triangleCount;
	made->faces = soleAlloc( allocator, (size_t)triangleCount * sizeof *made->faces );
	if ( made->faces != NULL )
	{
		soleFillFaces( made, positions, indices );
		made->itemCount = (int32_t)soleSizeGrid( made );
		made->firsts = soleAlloc( allocator, ( soleCellCount( made ) + 1 ) * sizeof *made->firsts );
		made->items = soleAlloc( allocator, (size_t)made->itemCount * sizeof *made->items );
	}
	if ( made->faces == NULL || made->firsts == NULL || made->items == NULL )
	{
		soleDestroyTerrain( made );
		soleSetMessage( message, "out of memory for a terrain of %d triangles", triangleCount );
		return sole_outOfMemory;
	}
	soleFillGrid( made );
	*terrain = made;
	return sole_success;
}

void soleDestroyTerrain( soleTerrain* terrain )
{
	if ( terrain == NULL )
	{
		return;
	}
	soleAllocator own = terrain->allocator;
	const soleAllocator* allocator = terrain->ownAllocator ? &own : NULL;
	soleFree( allocator, terrain->items, (size_t)terrain->itemCount * sizeof *terrain->items );
	soleFree( allocator, terrain->firsts, ( soleCellCount( terrain ) + 1 ) * sizeof *terrain->firsts );
	soleFree( allocator, terrain->faces, (size_t)terrain->faceCount * sizeof *terrain->faces );
	soleFree( allocator, terrain, sizeof *terrain );
}

// ---------------------------------------------------------------------------------------------------------- query

/// Height of a face over (u, v), or NaN beside it and where it faces sideways or down.
static double soleFaceHeight( const soleTerrainFace* face, double u, double v )
{
	if ( face->normal.z < LEAST_RISE )
	{
		return (double)NAN;
	}
	const soleVec3d* c = face->corners;
	double abu = c[1].x - c[0].x;
	double abv = c[1].y - c[0].y;
	double acu = c[2].x - c[0].x;
	double acv = c[2].y - c[0].y;
	double area = abu * acv - acu * abv;
	double s = ( ( u - c[0].x ) * acv - acu * ( v - c[0].y ) ) / area;
	double t = ( abu * ( v - c[0].y ) - ( u - c[0].x ) * abv ) / area;
	if ( !( s >= -EDGE_SLACK && t >= -EDGE_SLACK && s + t <= 1.0 + EDGE_SLACK ) )
	{
		return (double)NAN;
	}
	return c[0].z + s * ( c[1].z - c[0].z ) + t * ( c[2].z - c[0].z );
}

soleGroundSample soleSampleTerrain( const soleTerrain* terrain, soleVec3d p, double reach )
{
	soleGroundSample sample = { (double)NAN, terrain->axes[2] };
	soleVec3d q = soleToTerrain( terrain, p );
	double x = ( q.x - terrain->low[0] ) / terrain->cellSize;
	double y = ( q.y - terrain->low[1] ) / terrain->cellSize;
	// Slack as for the faces; also refuses what is not finite.
	if ( !( x >= -1e-6 && y >= -1e-6 && x <= (double)terrain->cells[0] && y <= (double)terrain->cells[1] ) )
	{
		return sample;
	}
	size_t cell = (size_t)soleClampCell( y, terrain->cells[1] ) * (size_t)terrain->cells[0] +
	    (size_t)soleClampCell( x, terrain->cells[0] );
	double highest = -HUGE_VAL;
	for ( int32_t i = terrain->firsts[cell]; i < terrain->firsts[cell + 1]; ++i )
	{
		const soleTerrainFace* face = terrain->faces + terrain->items[i];
		double height = soleFaceHeight( face, q.x, q.y );
		if ( height > highest && height <= q.z + reach )
		{
			highest = height;
			sample.gap = q.z - height;
			sample.normal_w = soleAddD( soleScaleD( face->normal.x, terrain->axes[0] ),
			    soleAddD(
			        soleScaleD( face->normal.y, terrain->axes[1] ), soleScaleD( face->normal.z, terrain->axes[2] ) ) );
		}
	}
	return sample;
}

static double soleSegmentDistance( soleVec3d p, soleVec3d a, soleVec3d b )
{
	soleVec3d ab = soleSubD( b, a );
	soleVec3d ap = soleSubD( p, a );
	double squared = soleDotD( ab, ab );
	double t = squared > 0.0 ? soleDotD( ap, ab ) / squared : 0.0;
	t = t < 0.0 ? 0.0 : ( t > 1.0 ? 1.0 : t );
	return soleLengthD( soleSubD( ap, soleScaleD( t, ab ) ) );
}

static double soleFaceDistance( const soleTerrainFace* face, soleVec3d p )
{
	const soleVec3d* c = face->corners;
	bool inside = soleDotD( face->normal, face->normal ) > 0.5;
	double nearest = HUGE_VAL;
	for ( int32_t k = 0; k < 3; ++k )
	{
		soleVec3d a = c[k];
		soleVec3d b = c[( k + 1 ) % 3];
		nearest = fmin( nearest, soleSegmentDistance( p, a, b ) );
		inside = inside && soleDotD( soleCrossD( soleSubD( b, a ), soleSubD( p, a ) ), face->normal ) >= 0.0;
	}
	return inside ? fabs( soleDotD( soleSubD( p, c[0] ), face->normal ) ) : nearest;
}

/// The lesser of limit and the distance to the faces of a cell, which may lie beside the grid.
static double soleCellDistance( const soleTerrain* terrain, int32_t row, int32_t column, soleVec3d p, double limit )
{
	if ( row < 0 || column < 0 || row >= terrain->cells[1] || column >= terrain->cells[0] )
	{
		return limit;
	}
	size_t cell = (size_t)row * (size_t)terrain->cells[0] + (size_t)column;
	for ( int32_t i = terrain->firsts[cell]; i < terrain->firsts[cell + 1]; ++i )
	{
		limit = fmin( limit, soleFaceDistance( terrain->faces + terrain->items[i], p ) );
	}
	return limit;
}

double soleFindTerrainDistance( const soleTerrain* terrain, soleVec3d p, double limit )
{
	soleVec3d q = soleToTerrain( terrain, p );
	if ( soleVec3d_IsFinite( q ) == false )
	{
		return limit;
	}
	int32_t column = soleClampCell( ( q.x - terrain->low[0] ) / terrain->cellSize, terrain->cells[0] );
	int32_t row = soleClampCell( ( q.y - terrain->low[1] ) / terrain->cellSize, terrain->cells[1] );
	limit = soleCellDistance( terrain, row, column, q, limit );
	// Rings of cells around p's own: what lies in ring k is at least k - 1 cells away, so the search ends early.
	int32_t rings = terrain->cells[0] > terrain->cells[1] ? terrain->cells[0] : terrain->cells[1];
	for ( int32_t k = 1; k <= rings && (double)( k - 1 ) * terrain->cellSize <= limit; ++k )
	{
		for ( int32_t i = -k; i < k; ++i )
		{
			limit = soleCellDistance( terrain, row - k, column + i, q, limit );
			limit = soleCellDistance( terrain, row + i, column + k, q, limit );
			limit = soleCellDistance( terrain, row + k, column - i, q, limit );
			limit = soleCellDistance( terrain, row - i, column - k, q, limit );
		}
	}
	return limit;
}

double soleTerrain_GetGap( const soleTerrain* terrain, soleVec3 p, double reach )
{
	SOLE_ASSERT( terrain != NULL && "terrain: make one with soleCreateTerrain()" );
	return terrain != NULL ? soleSampleTerrain( terrain, soleWiden( p ), reach ).gap : (double)NAN;
}

double soleTerrain_GetDepth( const soleTerrain* terrain, soleVec3 p, double reach )
{
	double gap = soleTerrain_GetGap( terrain, p, reach );
	// The surface above p is a surface: nothing further away needs to be looked at.
	return gap < 0.0 ? soleFindTerrainDistance( terrain, soleWiden( p ), -gap ) : 0.0;
}
