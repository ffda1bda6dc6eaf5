// SPDX-License-Identifier: MIT
// Scenes with pieces that move, come or go. World space.
#include "scene_makers.h"

/// Square, its upper side at a height.
static void soleAddSquare( soleSceneBuilder* builder, float half, float height )
{
	soleAddSceneBlock( builder, soleVec( -half, height - 1.0f, -half ), soleVec( half, height, half ) );
}

/// Boxes 0.03 to 0.08 high about the origin, one of them pushed past the left foot, and a column that stands for
/// another character, its middle 0.30 to the side.
void soleMakeLooseBoxes( soleSceneBuilder* builder, double speed, uint32_t seed, double ends[2] )
{
	soleAddSquare( builder, 3.0f, 0.0f );
	soleBeginScenePiece( builder, sole_sceneLoose, NULL );
	uint32_t series = seed * 15485863u;
	for ( int i = 0; i < 19; ++i )
	{
		soleVec3 half = { (float)soleSceneRandom( &series, 0.03, 0.08 ), (float)soleSceneRandom( &series, 0.015, 0.04 ),
			(float)soleSceneRandom( &series, 0.03, 0.08 ) };
		float x = (float)soleSceneRandom( &series, -0.8, 0.8 );
		float z = (float)soleSceneRandom( &series, -0.8, 0.8 );
		soleQuat turn = { 0.0f, (float)soleSceneRandom( &series, -1.0, 1.0 ), 0.0f, 1.0f };
		soleAddSceneBox( builder, soleVec( x, half.y, z ), half, soleNormalizeQuat( turn ) );
	}
	soleSceneMotion pushed = { .velocity = { 0.0f, 0.0f, (float)speed }, .stopTime = 12.0 };
	soleBeginScenePiece( builder, sole_sceneLoose, &pushed );
	soleAddSceneBlock( builder, soleVec( 0.12f, 0.0f, -0.64f ), soleVec( 0.20f, 0.06f, -0.56f ) );
	soleBeginScenePiece( builder, sole_sceneLoose, NULL );
	soleAddSceneColumn( builder, soleVec( 0.30f, 0.0f, 0.0f ), 0.20, 1.8 );
	ends[0] = -3.0;
	ends[1] = 3.0;
}

/// After 2 s there is a floor on the floor.
void soleMakeRisingFloor( soleSceneBuilder* builder, double height, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleAddSquare( builder, 3.0f, 0.0f );
	soleSceneMotion comes = { .from = 2.0 };
	soleBeginScenePiece( builder, sole_sceneGround, &comes );
	soleAddSquare( builder, 2.5f, (float)height );
	ends[0] = -3.0;
	ends[1] = 3.0;
}

/// 2 x 2, its upper side at height 0, over a floor. Up and down by 0.5 in 4 s; along at 2 m/s for 2 s.
void soleMakePlate( soleSceneBuilder* builder, double kind, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleSceneMotion motion = { .waveRate = 0.0 };
	if ( kind != 1.0 )
	{
		motion.wave = soleVec( 0.0f, 0.5f, 0.0f );
		motion.waveRate = 0.25;
	}
	if ( kind != 0.0 )
	{
		motion.velocity = soleVec( 0.0f, 0.0f, 2.0f );
		motion.stopTime = 2.0;
	}
	soleAddSquare( builder, 8.0f, -1.5f );
	soleBeginScenePiece( builder, sole_sceneGround, &motion );
	soleAddSceneBlock( builder, soleVec( -1.0f, -0.2f, -1.0f ), soleVec( 1.0f, 0.0f, 1.0f ) );
	ends[0] = -8.0;
	ends[1] = 8.0;
}

/// A disc that turns under the left foot of who stands at the origin; still ground of the same height under the right
/// one.
void soleMakeTurntable( soleSceneBuilder* builder, double spin, uint32_t seed, double ends[2] )
{
	(void)seed;
	const soleVec3 middle = { 0.13f, 0.0f, 0.06f };
	soleAddSquare( builder, 3.0f, -1.0f );
	soleAddSceneBlock( builder, soleVec( -2.0f, -1.1f, -2.0f ), soleVec( -0.06f, 0.0f, 2.0f ) );
	soleSceneMotion motion = { .pivot = middle, .axis = { 0.0f, 1.0f, 0.0f }, .spin = spin };
	soleBeginScenePiece( builder, sole_sceneGround, &motion );
	soleAddSceneColumn( builder, soleVec( middle.x, -0.2f, middle.z ), 0.185, 0.2 );
	ends[0] = -3.0;
	ends[1] = 3.0;
}

/// One under each foot of who stands at the origin, up and down against each other once in 2 s.
void soleMakeTwoPlates( soleSceneBuilder* builder, double height, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleAddSquare( builder, 3.0f, -1.0f );
	for ( int side = 0; side < 2; ++side )
	{
		soleSceneMotion motion = { .wave = { 0.0f, (float)( side == 0 ? height : -height ), 0.0f }, .waveRate = 0.5 };
		soleBeginScenePiece( builder, sole_sceneGround, &motion );
		float inner = side == 0 ? -0.002f : -0.006f; // the first one is in the very middle, for roots
		float outer = side == 0 ? 1.0f : -1.0f;
		soleAddSceneBlock( builder, soleVec( soleMinF( inner, outer ), -0.2f, -1.0f ),
		    soleVec( soleMaxF( inner, outer ), 0.0f, 1.0f ) );
	}
	ends[0] = -3.0;
	ends[1] = 3.0;
}

/// A board that tilts about x, once in 2 s, and is gone after 3 s; a floor 0.8 below.
void soleMakeSeeSaw( soleSceneBuilder* builder, double tilt, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleAddSquare( builder, 3.0f, -0.8f );
	soleSceneMotion motion = { .axis = { 1.0f, 0.0f, 0.0f }, .tilt = tilt, .tiltRate = 0.5, .until = 3.0 };
	soleBeginScenePiece( builder, sole_sceneGround, &motion );
	soleAddSceneBlock( builder, soleVec( -0.6f, -0.05f, -1.5f ), soleVec( 0.6f, 0.0f, 1.5f ) );
	ends[0] = -3.0;
	ends[1] = 3.0;
}
