// SPDX-License-Identifier: MIT
// Still scenes of several solids: stairs of plates, a ramp without shoulders, wedges, logs, benches, beams. World
// space.
#include "scene_makers.h"

#define SUNK 0.1f // how far a solid goes into the floor that it stands on

/// Upper side at height 0, from z 0 to length.
static void soleAddFloor( soleSceneBuilder* builder, float halfWidth, float length, float height )
{
	soleAddSceneBlock( builder, soleVec( -halfWidth, height - 1.0f, 0.0f ), soleVec( halfWidth, height, length ) );
}

/// Plates 0.04 thick, one every 0.29 and 0.17 higher, up to a landing; a floor below.
void soleMakeOpenStairs( soleSceneBuilder* builder, double slot, uint32_t seed, double ends[2] )
{
	(void)seed;
	const int32_t count = 12; // rises, the last onto the landing
	soleAddFloor( builder, 2.0f, 7.4f, 0.0f );
	for ( int32_t i = 0; i < count; ++i )
	{
		float y = (float)( 0.17 * ( i + 1 ) );
		double z = 2.0 + 0.29 * i;
		double depth = i + 1 < count ? 0.29 - slot : 2.0;
		soleAddSceneBlock( builder, soleVec( -1.0f, y - 0.04f, (float)z ), soleVec( 1.0f, y, (float)( z + depth ) ) );
	}
	ends[1] = 7.2;
}

/// Flat 2, up 5, flat 2: one metre wide, with upright sides down to a floor 1.5 below.
void soleMakeBoxRamp( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleAddFloor( builder, 3.0f, 9.0f, -1.5f );
	soleSceneCursor cursor = soleBeginSceneProfile( builder, 0.5, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneSlope( &cursor, 5.0, slope );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleCloseSceneLoft( builder, -1.5 - (double)SUNK );
	ends[1] = cursor.z;
}

/// Along the middle of the way, 0.05 to either side: into the inner side of both feet.
void soleMakeWedge( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	const double half = 0.05;
	const double outline[5][2] = { { -half, (double)-SUNK }, { half, (double)-SUNK }, { half, 0.0 },
		{ 0.0, half * slope }, { -half, 0.0 } };
	soleAddFloor( builder, 2.0f, 10.0f, 0.0f );
	soleAddScenePrism( builder, outline, 5, 2.0, 8.0 );
	ends[1] = 10.0;
}

/// What feet stand on, and beside it in height what carries the root.
void soleMakeTwoGrounds( soleSceneBuilder* builder, double lower, uint32_t seed, double ends[2] )
{
	(void)seed;
	builder->pieces[0].layer = sole_sceneFeetOnly;
	soleAddFloor( builder, 3.0f, 10.0f, 0.0f );
	soleBeginScenePiece( builder, sole_sceneRootOnly, NULL );
	soleAddFloor( builder, 3.0f, 10.0f, (float)lower );
	ends[1] = 10.0;
}

/// A log that lies on a floor and can be walked through: inner radius 0.35, outer 0.40.
void soleMakeLog( soleSceneBuilder* builder, double length, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleAddFloor( builder, 2.0f, (float)length + 4.0f, 0.0f );
	soleAddScenePipe( builder, 0.40, 0.35, 0.40, 2.0, 2.0 + length );
	ends[1] = length + 4.0;
}

/// A slab 0.05 thick at a height of 0.40, further on a roof at 0.90.
void soleMakeBench( soleSceneBuilder* builder, double value, uint32_t seed, double ends[2] )
{
	(void)value;
	(void)seed;
	soleAddFloor( builder, 2.0f, 10.0f, 0.0f );
	soleAddSceneBlock( builder, soleVec( -0.8f, 0.40f, 3.05f ), soleVec( 0.8f, 0.45f, 3.45f ) );
	soleAddSceneBlock( builder, soleVec( -1.0f, 0.90f, 5.5f ), soleVec( 1.0f, 1.0f, 8.0f ) );
	ends[1] = 10.0;
}

/// 4 x 4, edge at z = 2; a floor below or none.
void soleMakePlatform( soleSceneBuilder* builder, double drop, uint32_t seed, double ends[2] )
{
	(void)seed;
	float bottom = drop > 0.0 ? (float)-drop - SUNK : -1.0f;
	soleAddSceneBlock( builder, soleVec( -2.0f, bottom, -2.0f ), soleVec( 2.0f, 0.0f, 2.0f ) );
	if ( drop > 0.0 )
	{
		float floor = (float)-drop;
		soleAddSceneBlock( builder, soleVec( -5.0f, floor - 1.0f, -5.0f ), soleVec( 5.0f, floor, 5.0f ) );
	}
	ends[0] = -2.0;
	ends[1] = 2.0;
}

/// 6 long, 1 high; its upper side is at height 1.
void soleMakeBeam( soleSceneBuilder* builder, double width, uint32_t seed, double ends[2] )
{
	(void)seed;
	float half = (float)( 0.5 * width );
	soleAddFloor( builder, 2.0f, 8.0f, 0.0f );
	soleAddSceneBlock( builder, soleVec( -half, -SUNK, 1.0f ), soleVec( half, 1.0f, 7.0f ) );
	ends[0] = 0.8;
	ends[1] = 7.2;
}
