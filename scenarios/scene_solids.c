// SPDX-License-Identifier: MIT
// Boxes, prisms, columns and pipes, as closed meshes with shared corners. World space.
#include "scene_builder.h"

#define TURN 6.283185307179586
#define SIDES 48 // of what is round: 0.9 mm off at a radius of 0.4

void soleAddSceneBox( soleSceneBuilder* builder, soleVec3 middle, soleVec3 half, soleQuat turn )
{
	static const uint8_t faces[12][3] = { { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 }, { 0, 1, 5 }, { 0, 5, 4 },
		{ 2, 6, 7 }, { 2, 7, 3 }, { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 } };
	uint32_t first = (uint32_t)builder->vertexCount;
	for ( int i = 0; i < 8; ++i )
	{
		// Bit 0: x, bit 1: y, bit 2: z.
		soleVec3 corner = { ( i & 1 ) != 0 ? half.x : -half.x, ( i & 2 ) != 0 ? half.y : -half.y,
			( i & 4 ) != 0 ? half.z : -half.z };
		soleVec3 p = soleAdd( middle, soleRotate( turn, corner ) );
		soleAddScenePoint( builder, (double)p.x, (double)p.y, (double)p.z );
	}
	for ( int i = 0; i < 12; ++i )
	{
		soleAddSceneTriangle( builder, first + faces[i][0], first + faces[i][1], first + faces[i][2] );
	}
}

void soleAddSceneBlock( soleSceneBuilder* builder, soleVec3 low, soleVec3 high )
{
	soleVec3 half = soleScale( 0.5f, soleSub( high, low ) );
	soleAddSceneBox( builder, soleAdd( low, half ), half, soleQuat_Identity() );
}

/// The wall between two rings of points, the second where an outward looking wall has it on its right.
static void soleAddWall( soleSceneBuilder* builder, uint32_t first, uint32_t second, uint32_t count )
{
	for ( uint32_t i = 0; i < count; ++i )
	{
		uint32_t k = ( i + 1 ) % count;
		soleAddSceneTriangle( builder, first + i, first + k, second + k );
		soleAddSceneTriangle( builder, first + i, second + k, second + i );
	}
}

static void soleAddCap( soleSceneBuilder* builder, uint32_t first, uint32_t count, bool reversed )
{
	for ( uint32_t i = 1; i + 1 < count; ++i )
	{
		soleAddSceneTriangle( builder, first, first + ( reversed ? i + 1 : i ), first + ( reversed ? i : i + 1 ) );
	}
}

void soleAddScenePrism( soleSceneBuilder* builder, const double ( *outline )[2], int32_t count, double from, double to )
{
	uint32_t first = (uint32_t)builder->vertexCount;
	for ( int32_t i = 0; i < 2 * count; ++i )
	{
		soleAddScenePoint( builder, outline[i % count][0], outline[i % count][1], i < count ? from : to );
	}
	soleAddWall( builder, first, first + (uint32_t)count, (uint32_t)count );
	soleAddCap( builder, first, (uint32_t)count, true );
	soleAddCap( builder, first + (uint32_t)count, (uint32_t)count, false );
}

void soleAddSceneColumn( soleSceneBuilder* builder, soleVec3 foot, double radius, double height )
{
	uint32_t first = (uint32_t)builder->vertexCount;
	for ( int i = 0; i < 2 * SIDES; ++i )
	{
		// Counter clockwise seen from above: from z to x.
		double angle = TURN * ( i % SIDES ) / SIDES;
		soleAddScenePoint( builder, (double)foot.x + radius * sin( angle ),
		    (double)foot.y + ( i < SIDES ? 0.0 : height ), (double)foot.z + radius * cos( angle ) );
	}
	soleAddWall( builder, first, first + SIDES, SIDES );
	soleAddCap( builder, first, SIDES, true );
	soleAddCap( builder, first + SIDES, SIDES, false );
}

void soleAddScenePipe( soleSceneBuilder* builder, double height, double inner, double outer, double from, double to )
{
	// Rings: outer from, outer to, inner to, inner from.
	uint32_t first = (uint32_t)builder->vertexCount;
	for ( int i = 0; i < 4 * SIDES; ++i )
	{
		int ring = i / SIDES;
		double angle = TURN * ( i % SIDES ) / SIDES;
		double radius = ring < 2 ? outer : inner;
		soleAddScenePoint(
		    builder, radius * sin( angle ), height - radius * cos( angle ), ring == 0 || ring == 3 ? from : to );
	}
	for ( uint32_t ring = 0; ring < 4; ++ring )
	{
		soleAddWall( builder, first + ring * SIDES, first + ( ring + 1 ) % 4 * SIDES, SIDES );
	}
}
