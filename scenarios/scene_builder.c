// SPDX-License-Identifier: MIT
// Lofts, as closed meshes with shared corners, and the pieces that meshes belong to. World space.
//
// Neighbouring chains of points are zipped: from their first points on, the chain whose next point comes first along
// the zip's axis goes one further and closes a triangle. Two rows zip along x, the two ends of a side wall's column
// along y. A column's end holds the corners of a riser that are on it, so that walls meet treads corner to corner.
#include "scene_builder.h"

#include <stdlib.h>
#include <string.h>

void soleFreeSceneBuilder( soleSceneBuilder* builder )
{
	free( builder->positions );
	free( builder->indices );
	free( builder->rows );
	*builder = ( soleSceneBuilder ){ .failed = false };
}

/// Room for one more thing. @return false without memory, from then on.
static bool soleGrow( soleSceneBuilder* builder, void* array, int32_t count, int32_t* capacity, size_t size )
{
	if ( builder->failed || count < *capacity )
	{
		return builder->failed == false;
	}
	int32_t larger = *capacity < 64 ? 64 : *capacity * 2;
	void* memory;
	memcpy( &memory, array, sizeof memory );
	memory = realloc( memory, (size_t)larger * size );
	if ( memory == NULL )
	{
		builder->failed = true;
		return false;
	}
	memcpy( array, &memory, sizeof memory );
	*capacity = larger;
	return true;
}

uint32_t soleAddScenePoint( soleSceneBuilder* builder, double x, double y, double z )
{
	if ( !soleGrow(
	         builder, &builder->positions, builder->vertexCount, &builder->vertexCapacity, 3 * sizeof( float ) ) )
	{
		return 0;
	}
	float* p = builder->positions + 3 * builder->vertexCount;
	p[0] = (float)x;
	p[1] = (float)y;
	p[2] = (float)z;
	builder->vertexCount += 1;
	return (uint32_t)( builder->vertexCount - 1 );
}

void soleAddSceneTriangle( soleSceneBuilder* builder, uint32_t a, uint32_t b, uint32_t c )
{
	if ( !soleGrow(
	         builder, &builder->indices, builder->triangleCount, &builder->triangleCapacity, 3 * sizeof( uint32_t ) ) )
	{
		return;
	}
	uint32_t* t = builder->indices + 3 * builder->triangleCount;
	t[0] = a;
	t[1] = b;
	t[2] = c;
	builder->triangleCount += 1;
}

/// Fills the band between two chains that run the same way along an axis (0 x, 1 y). With the chains along x and `to`
/// further along z the faces look up.
static void soleZip( soleSceneBuilder* builder, const soleSceneChain* from, const soleSceneChain* to, int axis )
{
	if ( builder->failed )
	{
		return;
	}
	int32_t i = 0;
	int32_t k = 0;
	while ( i + 1 < from->count || k + 1 < to->count )
	{
		bool goFrom = k + 1 >= to->count;
		if ( i + 1 < from->count && k + 1 < to->count )
		{
			float nextFrom = builder->positions[3 * from->points[i + 1] + (uint32_t)axis];
			float nextTo = builder->positions[3 * to->points[k + 1] + (uint32_t)axis];
			goFrom = nextFrom <= nextTo;
		}
		uint32_t next = goFrom ? from->points[i + 1] : to->points[k + 1];
		soleAddSceneTriangle( builder, from->points[i], to->points[k], next );
		i += goFrom ? 1 : 0;
		k += goFrom ? 0 : 1;
	}
}

void soleBeginScenePiece( soleSceneBuilder* builder, uint32_t layer, const soleSceneMotion* motion )
{
	if ( builder->pieceCount == SOLE_SCENE_MAX_PIECES )
	{
		builder->failed = true;
		return;
	}
	soleScenePiece* piece = builder->pieces + builder->pieceCount;
	*piece = ( soleScenePiece ){ .firstTriangle = builder->triangleCount, .layer = layer };
	piece->surface = builder->pieceCount == 0 ? SOLE_NONE : builder->pieceCount;
	if ( motion != NULL )
	{
		piece->motion = *motion;
	}
	builder->pieceCount += 1;
}

void soleEndScenePieces( soleSceneBuilder* builder )
{
	int32_t end = builder->triangleCount;
	for ( int32_t i = builder->pieceCount - 1; i >= 0; --i )
	{
		builder->pieces[i].triangleCount = end - builder->pieces[i].firstTriangle;
		end = builder->pieces[i].firstTriangle;
	}
}

static soleSceneChain soleGetRowChain( const soleSceneRow* row )
{
	soleSceneChain chain = { .count = row->count };
	for ( int32_t i = 0; i < row->count; ++i )
	{
		chain.points[i] = row->first + (uint32_t)i;
	}
	return chain;
}

void soleAddSceneRow( soleSceneBuilder* builder, double z, const double* x, const double* y, int32_t count )
{
	if ( count < 2 || count > SOLE_SCENE_MAX_ROW )
	{
		builder->failed = true;
	}
	if ( !soleGrow( builder, &builder->rows, builder->rowCount, &builder->rowCapacity, sizeof *builder->rows ) )
	{
		return;
	}
	soleSceneRow* row = builder->rows + builder->rowCount;
	*row = ( soleSceneRow ){ (float)z, (uint32_t)builder->vertexCount, count };
	for ( int32_t i = 0; i < count; ++i )
	{
		soleAddScenePoint( builder, x[i], y[i], z );
	}
	builder->rowCount += 1;
	if ( builder->rowCount > 1 )
	{
		soleSceneChain from = soleGetRowChain( row - 1 );
		soleSceneChain to = soleGetRowChain( row );
		soleZip( builder, &from, &to, 0 );
	}
}

static uint32_t soleGetRowEnd( const soleSceneRow* row, bool last )
{
	return row->first + ( last ? (uint32_t)row->count - 1 : 0 );
}

static float soleGetHeight( const soleSceneBuilder* builder, uint32_t point )
{
	return builder->positions[3 * point + 1];
}

/// The end of a side wall's column: from the bottom up to the row that the column runs to, over the corner of the row
/// at the same z that lies between. other is the row beyond the riser, or the row itself.
static soleSceneChain soleGetColumn(
    const soleSceneBuilder* builder, uint32_t bottom, const soleSceneRow* row, const soleSceneRow* other, bool last )
{
	soleSceneChain chain = { .points = { bottom }, .count = 1 };
	uint32_t top = soleGetRowEnd( row, last );
	uint32_t between = soleGetRowEnd( other, last );
	if ( between != top && soleGetHeight( builder, between ) < soleGetHeight( builder, top ) )
	{
		chain.points[chain.count] = between;
		chain.count += 1;
	}
	chain.points[chain.count] = top;
	chain.count += 1;
	return chain;
}

/// The rows of a loft at one z: one, or the two of a riser.
static void soleGetStation(
    const soleSceneBuilder* builder, int32_t row, const soleSceneRow** first, const soleSceneRow** last, int32_t* next )
{
	*first = builder->rows + row;
	bool riser = row + 1 < builder->rowCount && builder->rows[row + 1].z == builder->rows[row].z;
	*last = builder->rows + row + ( riser ? 1 : 0 );
	*next = row + ( riser ? 2 : 1 );
}

static soleSceneChain soleAddBottomPoints( soleSceneBuilder* builder, const soleSceneRow* row, double bottom )
{
	soleSceneChain chain = { .count = 2 };
	for ( int end = 0; end < 2 && builder->failed == false; ++end )
	{
		float x = builder->positions[3 * soleGetRowEnd( row, end == 1 )];
		chain.points[end] = soleAddScenePoint( builder, (double)x, bottom, (double)row->z );
	}
	return chain;
}

void soleCloseSceneLoft( soleSceneBuilder* builder, double bottom )
{
	if ( builder->failed || builder->rowCount < 2 )
	{
		builder->failed = true;
		return;
	}
	const soleSceneRow* first;
	const soleSceneRow* last;
	int32_t row;
	soleGetStation( builder, 0, &first, &last, &row );
	soleSceneChain low = soleAddBottomPoints( builder, first, bottom );
	soleSceneChain top = soleGetRowChain( first );
	soleZip( builder, &low, &top, 0 );
	while ( row < builder->rowCount && builder->failed == false )
	{
		const soleSceneRow* nextFirst;
		const soleSceneRow* nextLast;
		soleGetStation( builder, row, &nextFirst, &nextLast, &row );
		soleSceneChain nextLow = soleAddBottomPoints( builder, nextFirst, bottom );
		soleZip( builder, &nextLow, &low, 0 );
		for ( int side = 0; side < 2 && builder->failed == false; ++side )
		{
			soleSceneChain from = soleGetColumn( builder, low.points[side], last, first, side == 1 );
			soleSceneChain to = soleGetColumn( builder, nextLow.points[side], nextFirst, nextLast, side == 1 );
			soleZip( builder, side == 0 ? &from : &to, side == 0 ? &to : &from, 1 );
		}
		first = nextFirst;
		last = nextLast;
		low = nextLow;
	}
	top = soleGetRowChain( last );
	soleZip( builder, &top, &low, 0 );
	builder->rowCount = 0;
}
