// SPDX-License-Identifier: MIT
// Probes against a height field, in the field's own axes: x along axisX, y up, z along axisZ, from its origin, metres.
//
// The part of the probe's way that is near the field is cut into rows of cells, each row into cells; the two triangles
// of a cell are asked as any others. Rows are taken in the order in which they are reached, so that the first row that
// begins beyond the nearest touch ends the search. Cells are taken with a margin (the sphere's radius and what rounding
// may shift), hence a vertical ray asks one cell, or the two or four that meet under it: borders have no gaps.
#include "ground/block.h"

/// The probe's way in double, for clipping, and the reach around it.
typedef struct soleFieldWalk
{
	const soleGroundField* field;
	const soleGroundQuery* query; // in the field's axes
	double start[3];
	double way[3];
	double reach;
	int64_t firstIndex;
	soleGroundTouch best;
} soleFieldWalk;

int64_t soleGroundField_GetTriangleCount( const soleGroundField* field )
{
	return 2 * (int64_t)( field->field.countX - 1 ) * (int64_t)( field->field.countZ - 1 );
}

void soleGroundField_GetBounds( const soleGroundField* field, soleVec3* lower, soleVec3* upper )
{
	*lower = soleVec( INFINITY, INFINITY, INFINITY );
	*upper = soleVec( -INFINITY, -INFINITY, -INFINITY );
	if ( !( field->lowest <= field->highest ) )
	{
		return;
	}
	const soleHeightField* f = &field->field;
	for ( int i = 0; i < 8; ++i )
	{
		float x = ( i & 1 ) != 0 ? f->cellX * (float)( f->countX - 1 ) : 0.0f;
		float z = ( i & 2 ) != 0 ? f->cellZ * (float)( f->countZ - 1 ) : 0.0f;
		float y = ( i & 4 ) != 0 ? field->highest : field->lowest;
		soleVec3 p = soleMulAdd( soleMulAdd( soleMulAdd( f->origin, x, f->axisX ), z, f->axisZ ), y, f->up );
		*lower = soleVec( soleMinF( lower->x, p.x ), soleMinF( lower->y, p.y ), soleMinF( lower->z, p.z ) );
		*upper = soleVec( soleMaxF( upper->x, p.x ), soleMaxF( upper->y, p.y ), soleMaxF( upper->z, p.z ) );
	}
}

/// Keeps of [range[0], range[1]] the travel during which start + t way is between low and high. @return false: nothing.
static bool soleClipTravel( double start, double way, double low, double high, double range[2] )
{
	if ( fabs( way ) < 1e-30 )
	{
		return start >= low && start <= high;
	}
	double a = ( low - start ) / way;
	double b = ( high - start ) / way;
	double enter = a < b ? a : b;
	double leave = a < b ? b : a;
	range[0] = enter > range[0] ? enter : range[0];
	range[1] = leave < range[1] ? leave : range[1];
	return range[0] <= range[1];
}

/// The cells along one axis that lie between two coordinates, within the grid.
static void soleGetCells(
    double a, double b, double reach, float cell, int32_t cellCount, int32_t* first, int32_t* last )
{
	double low = floor( ( ( a < b ? a : b ) - reach ) / (double)cell );
	double high = floor( ( ( a < b ? b : a ) + reach ) / (double)cell );
	double limit = (double)( cellCount - 1 );
	*first = low > 0.0 ? (int32_t)( low < limit ? low : limit ) : 0;
	*last = high > 0.0 ? (int32_t)( high < limit ? high : limit ) : 0;
}

/// The two triangles of a cell as the first two of a block, and over again up to so many.
static void soleFillCellBlock( const soleHeightField* f, int32_t i, int32_t j, int count, soleGroundBlock* block )
{
	const float* row = f->heights + (size_t)j * (size_t)f->countX + (size_t)i;
	const float xs[2] = { (float)i * f->cellX, (float)( i + 1 ) * f->cellX };
	const float zs[2] = { (float)j * f->cellZ, (float)( j + 1 ) * f->cellZ };
	static const int corners[2][3][2] = { { { 0, 0 }, { 1, 1 }, { 1, 0 } }, { { 0, 0 }, { 0, 1 }, { 1, 1 } } };
	for ( int lane = 0; lane < count; ++lane )
	{
		for ( int k = 0; k < 3; ++k )
		{
			const int* corner = corners[lane & 1][k];
			block->corners[k][0][lane] = xs[corner[0]];
			block->corners[k][1][lane] = row[(size_t)corner[1] * (size_t)f->countX + (size_t)corner[0]];
			block->corners[k][2][lane] = zs[corner[1]];
		}
	}
}

static void soleMeetCell( soleFieldWalk* walk, int32_t i, int32_t j )
{
	const soleHeightField* f = &walk->field->field;
	// To sift two triangles for a ray is dearer than to decide.
	bool sphere = walk->query->radius > 0.0f;
	soleGroundBlock block;
	soleFillCellBlock( f, i, j, sphere ? SOLE_GROUND_BLOCK_SIZE : 2, &block );
	float bounds[SOLE_GROUND_BLOCK_SIZE];
	float travel = soleMinF( walk->query->length, (float)walk->best.t );
	uint32_t bits = sphere ? soleSiftForSphere( walk->query, &block, false, travel, bounds ) : 3u;
	for ( uint32_t k = 0; k < 2; ++k )
	{
		bool hole = !soleIsFinite( ( block.corners[0][1][k] + block.corners[1][1][k] ) + block.corners[2][1][k] );
		soleGroundTouch touch;
		if ( ( bits >> k & 1u ) == 0 || hole || !soleMeetTriangle( walk->query, &block, k, false, &touch ) )
		{
			continue;
		}
		touch.index = walk->firstIndex + 2 * ( (int64_t)j * ( f->countX - 1 ) + i ) + (int64_t)k;
		if ( soleGroundTouch_IsBefore( &touch, &walk->best ) )
		{
			walk->best = touch;
		}
	}
}

static void soleWalkCells( soleFieldWalk* walk )
{
	const soleHeightField* f = &walk->field->field;
	double limit = walk->best.t < (double)walk->query->length ? walk->best.t : (double)walk->query->length;
	double all[2] = { 0.0, limit };
	double low = (double)walk->field->lowest - walk->reach;
	double high = (double)walk->field->highest + walk->reach;
	double width = (double)f->cellX * (double)( f->countX - 1 );
	double depth = (double)f->cellZ * (double)( f->countZ - 1 );
	if ( !soleClipTravel( walk->start[1], walk->way[1], low, high, all ) ||
	    !soleClipTravel( walk->start[0], walk->way[0], -walk->reach, width + walk->reach, all ) ||
	    !soleClipTravel( walk->start[2], walk->way[2], -walk->reach, depth + walk->reach, all ) )
	{
		return;
	}
	int32_t first;
	int32_t last;
	soleGetCells( walk->start[2] + all[0] * walk->way[2], walk->start[2] + all[1] * walk->way[2], walk->reach, f->cellZ,
	    f->countZ - 1, &first, &last );
	bool backwards = walk->way[2] < 0.0;
	for ( int32_t n = 0; n <= last - first; ++n )
	{
		int32_t j = backwards ? last - n : first + n;
		double part[2] = { all[0], all[1] };
		double z = (double)f->cellZ * (double)j;
		if ( !soleClipTravel(
		         walk->start[2], walk->way[2], z - walk->reach, z + (double)f->cellZ + walk->reach, part ) )
		{
			continue;
		}
		if ( part[0] > walk->best.t )
		{
			return;
		}
		int32_t from;
		int32_t to;
		soleGetCells( walk->start[0] + part[0] * walk->way[0], walk->start[0] + part[1] * walk->way[0], walk->reach,
		    f->cellX, f->countX - 1, &from, &to );
		for ( int32_t i = from; i <= to; ++i )
		{
			soleMeetCell( walk, i, j );
		}
	}
}

void soleCastHeightField(
    const soleGroundField* field, const soleGroundQuery* query, int64_t firstIndex, soleGroundTouch* best )
{
	const soleHeightField* f = &field->field;
	if ( !( field->lowest <= field->highest ) )
	{
		return;
	}
	soleVec3 start = soleSub( soleVec( query->start[0], query->start[1], query->start[2] ), f->origin );
	soleVec3 way = { query->direction[0], query->direction[1], query->direction[2] };
	soleVec3 localStart = { soleDot( start, f->axisX ), soleDot( start, f->up ), soleDot( start, f->axisZ ) };
	soleVec3 localWay = { soleDot( way, f->axisX ), soleDot( way, f->up ), soleDot( way, f->axisZ ) };
	soleGroundQuery local;
	if ( !soleMakeGroundQuery( localStart, localWay, query->length, query->radius, query->mask, &local ) )
	{
		return;
	}
	float extent = f->cellX * (float)f->countX + f->cellZ * (float)f->countZ;
	float size = ( fabsf( localStart.x ) + fabsf( localStart.y ) ) + ( fabsf( localStart.z ) + extent );
	soleFieldWalk walk = {
		.field = field,
		.query = &local,
		.start = { (double)localStart.x, (double)localStart.y, (double)localStart.z },
		.way = { (double)localWay.x, (double)localWay.y, (double)localWay.z },
		.reach = (double)local.radius + 5e-7 * (double)size, // the ray test rounds corners seen from the start
		.firstIndex = firstIndex,
		.best = *best,
	};
	soleWalkCells( &walk );
	if ( walk.best.hit == false || ( best->hit && walk.best.index < firstIndex ) )
	{
		return;
	}
	// Along the axes, not across them: right for mirrored grids too.
	soleVec3 p = walk.best.point;
	soleVec3 n = walk.best.normal;
	*best = walk.best;
	best->layer = f->layer;
	best->surface = f->surface;
	best->point = soleMulAdd( soleMulAdd( soleMulAdd( f->origin, p.x, f->axisX ), p.y, f->up ), p.z, f->axisZ );
	best->normal = soleNormalizeOr(
	    soleAdd( soleAdd( soleScale( n.x, f->axisX ), soleScale( n.y, f->up ) ), soleScale( n.z, f->axisZ ) ), f->up );
}
