// SPDX-License-Identifier: MIT
// Scenes that are walked all around, and the way around them: up is where its walker is. World space, metres; all of a
// way lies in the plane x = 0.
//
// A way is made of stretches. With p the turn of its course about +x since the start, so that it goes along
// ( 0, -sin p, cos p ), an arc of radius r = length / bend goes from p to q by
//   z += r ( sin q - sin p ),  y += r ( cos q - cos p )
// and its walker's up, turned by a, is ( 0, cos a, sin a ). Over a planet both turn together. Before a corner up begins
// to turn, evenly, and has turned half way in it, as that of a normal provider does which takes the mean of the faces
// around a walker: in the corner itself, where their normals jump, nothing does.
#include "scene_makers.h"

#define TURN 6.283185307179586
#define DEGREE 0.017453292519943295
#define COLUMNS 240  // of a planet around its walk: faces are 0.5 mm under a radius of 6 in their middles
#define ROUNDING 1.2 // before and after a corner up turns within so much

// --------------------------------------------------------------------------------------------------------------- ways

static void soleAddStretch( soleSceneBuilder* builder, soleSceneStretch stretch )
{
	soleSceneWay* way = &builder->way;
	builder->failed = builder->failed || way->count >= SOLE_SCENE_MAX_STRETCHES;
	if ( builder->failed == false )
	{
		way->stretches[way->count++] = stretch;
	}
}

/// Straight on along a face from one corner to the next. @param before how far the first was turned by, @param after
/// and the next will be
static void soleAddFace( soleSceneBuilder* builder, double length, double before, double after )
{
	double straight = length - ( before != 0.0 ? ROUNDING : 0.0 ) - ( after != 0.0 ? ROUNDING : 0.0 );
	if ( before != 0.0 )
	{
		soleAddStretch( builder, ( soleSceneStretch ){ .length = ROUNDING, .turn = 0.5 * before } );
	}
	soleAddStretch( builder, ( soleSceneStretch ){ .length = straight } );
	if ( after != 0.0 )
	{
		soleAddStretch( builder, ( soleSceneStretch ){ .length = ROUNDING, .corner = after, .turn = 0.5 * after } );
	}
}

void soleGetSceneWay( const soleScene* scene, double gone, soleTransform* place )
{
	const soleSceneWay* way = &scene->way;
	double y = way->y;
	double z = way->z;
	double p = 0.0;
	double a = 0.0;
	for ( int32_t i = 0; i < way->count; ++i )
	{
		// The last one goes on.
		const soleSceneStretch* s = way->stretches + i;
		bool within = gone < s->length || i + 1 == way->count;
		double length = within ? gone : s->length;
		double q = p + s->bend * length / s->length;
		double radius = s->bend != 0.0 ? s->length / s->bend : 0.0;
		z += s->bend != 0.0 ? radius * ( sin( q ) - sin( p ) ) : length * cos( p );
		y += s->bend != 0.0 ? radius * ( cos( q ) - cos( p ) ) : -length * sin( p );
		p = q + ( within ? 0.0 : s->corner );
		a += s->turn * length / s->length;
		gone -= length;
	}
	*place = soleTransform_Identity();
	place->translation = soleVec( 0.0f, (float)y, (float)z );
	place->rotation = ( soleQuat ){ (float)sin( 0.5 * a ), 0.0f, 0.0f, (float)cos( 0.5 * a ) };
}

// ------------------------------------------------------------------------------------------------------------- planet

/// Rings around x, close together where it is walked, and two poles.
void soleMakePlanet( soleSceneBuilder* builder, double radius, uint32_t seed, double ends[2] )
{
	(void)seed;
	static const double rows[] = { -70.0, -50.0, -32.0, -20.0, -12.0, -8.0, -6.0, -4.5, -3.0, -1.5, 0.0, 1.5, 3.0, 4.5,
		6.0, 8.0, 12.0, 20.0, 32.0, 50.0, 70.0 };
	const uint32_t rowCount = sizeof rows / sizeof rows[0];
	uint32_t poles[2] = { soleAddScenePoint( builder, -radius, 0.0, 0.0 ),
		soleAddScenePoint( builder, radius, 0.0, 0.0 ) };
	uint32_t first = poles[1] + 1;
	for ( uint32_t i = 0; i < rowCount * COLUMNS; ++i )
	{
		double b = DEGREE * rows[i / COLUMNS];
		double a = TURN * ( i % COLUMNS ) / COLUMNS;
		soleAddScenePoint( builder, radius * sin( b ), radius * cos( b ) * cos( a ), radius * cos( b ) * sin( a ) );
	}
	for ( uint32_t i = 0; i < rowCount * COLUMNS; ++i )
	{
		uint32_t here = first + i;
		uint32_t next = first + i / COLUMNS * COLUMNS + ( i + 1 ) % COLUMNS;
		bool last = i / COLUMNS + 1 == rowCount;
		if ( i < COLUMNS )
		{
			soleAddSceneTriangle( builder, poles[0], next, here );
		}
		soleAddSceneTriangle( builder, here, next, last ? poles[1] : next + COLUMNS );
		if ( last == false )
		{
			soleAddSceneTriangle( builder, here, next + COLUMNS, here + COLUMNS );
		}
	}
	builder->way = ( soleSceneWay ){ .y = radius };
	soleAddStretch( builder, ( soleSceneStretch ){ .length = TURN * radius, .bend = TURN, .turn = TURN } );
	// Its top can be walked with any up: as far as 30 degrees.
	ends[0] = -0.5 * radius - 0.8;
	ends[1] = 0.5 * radius + 0.8;
}

// ----------------------------------------------------------------------------------------------------------- overhang

/// A floor, a wall at its end, over it a slab that hangs out over the floor: seen from the side an open ring. Its way
/// goes over the floor, up the wall, back under the slab, up its end and on over its top.
void soleMakeOverhang( soleSceneBuilder* builder, double height, uint32_t seed, double ends[2] )
{
	(void)seed;
	const double half = 2.0;
	const double top = height + 3.0;
	// z, y: counter clockwise seen from -x. Points where the parts meet are corners too.
	const double outline[10][2] = { { -2.0, -1.0 }, { 6.0, -1.0 }, { 6.0, 0.0 }, { 6.0, height }, { 6.0, top },
		{ 1.0, top }, { 1.0, height }, { 5.0, height }, { 5.0, 0.0 }, { -2.0, 0.0 } };
	static const uint32_t caps[8][3] = { { 1, 2, 8 }, { 1, 8, 9 }, { 1, 9, 0 }, { 2, 3, 7 }, { 2, 7, 8 }, { 4, 5, 6 },
		{ 4, 6, 7 }, { 4, 7, 3 } };
	uint32_t first = (uint32_t)builder->vertexCount;
	for ( int i = 0; i < 20; ++i )
	{
		soleAddScenePoint( builder, i < 10 ? -half : half, outline[i % 10][1], outline[i % 10][0] );
	}
	for ( int i = 0; i < 8; ++i )
	{
		uint32_t a = first + caps[i][0], b = first + caps[i][1], c = first + caps[i][2];
		soleAddSceneTriangle( builder, a, b, c );
		soleAddSceneTriangle( builder, a + 10, c + 10, b + 10 );
	}
	for ( uint32_t i = 0; i < 10; ++i )
	{
		uint32_t a = first + i;
		uint32_t b = first + ( i + 1 ) % 10;
		soleAddSceneTriangle( builder, a, b + 10, b );
		soleAddSceneTriangle( builder, a, a + 10, b + 10 );
	}
	builder->way = ( soleSceneWay ){ .z = -1.0 };
	const double right = 0.25 * TURN;
	soleAddFace( builder, 6.0, 0.0, -right );
	soleAddFace( builder, height, -right, -right );
	soleAddFace( builder, 4.0, -right, right );
	soleAddFace( builder, top - height, right, right );
	soleAddFace( builder, 5.0, right, 0.0 );
	// What lies under the open sky before the slab.
	ends[0] = -2.0;
	ends[1] = 1.0;
}
