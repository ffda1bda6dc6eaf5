// SPDX-License-Identifier: MIT
// Grounds made by formula, used alike by tests, benchmarks, the program and the viewer. World space, metres, +Y up, to
// be walked along +Z. All are closed solids with their faces outwards (counter clockwise seen from outside), so that a
// depth below the surface has a meaning; neighbouring pieces share their corners.
#ifndef SCENARIOS_SCENARIO_H
#define SCENARIOS_SCENARIO_H

#include "scene_motion.h"

#define SOLE_SCENE_MAX_PATH 32
#define SOLE_SCENE_MAX_PIECES 8
#define SOLE_SCENE_MAX_STRETCHES 16

/// What a piece is there for. A host asks for the layers that it wants.
enum
{
	sole_sceneGround = 1,   // carries feet and roots
	sole_sceneRootOnly = 2, // not to be seen: carries roots, feet pass through it
	sole_sceneFeetOnly = 4, // carries feet, roots pass through it
	sole_sceneLoose = 8,    // things that lie about, other characters: nothing to stand on
};

/// A part of a scene that moves as a whole.
typedef struct soleScenePiece
{
	int32_t firstTriangle;
	int32_t triangleCount;
	int32_t surface; // SOLE_NONE: the still world
	uint32_t layer;
	soleSceneMotion motion;
} soleScenePiece;

/// Part of a way on which up turns with the ground.
/// Turns are about +x, rad: over a crest they are positive, up a wall negative.
typedef struct soleSceneStretch
{
	double length;
	double bend;   // of its course over that length
	double corner; // of its course at its end
	double turn;   // of its walker's up over that length
} soleSceneStretch;

/// A way over crests, up walls and along ceilings: begins at x = 0 upright, ahead along +z.
typedef struct soleSceneWay
{
	double y;
	double z;
	int32_t count; // 0: the scene has none
	soleSceneStretch stretches[SOLE_SCENE_MAX_STRETCHES];
} soleSceneWay;

typedef struct soleScene
{
	char id[16];
	char name[64];
	int32_t vertexCount;
	float* positions; // 3 a vertex
	int32_t triangleCount;
	uint32_t* indices; // 3 a triangle
	/// The first is the still world. Triangles are given where they are at time 0, or would be if they were there.
	int32_t pieceCount;
	soleScenePiece pieces[SOLE_SCENE_MAX_PIECES];
	/// A way for a walking character: x, z of its corners, at least 0.7 inside the ground.
	int32_t pathCount;
	float path[SOLE_SCENE_MAX_PATH][2];
	soleSceneWay way;
} soleScene;

/// Makes one of soleGetSceneIds(). Those with something random take a seed as well: "rubble-7", "T16-2", "T17-3";
/// without one it is 1.
/// @return false for an unknown id or without memory. The scene is then empty.
bool soleMakeScene( const char* id, soleScene* scene );
void soleFreeScene( soleScene* scene );

/// Where a piece is at a time. @param fromStart takes where it is at time 0 to where it is now
/// @return false where it is not there
bool soleGetScenePiece( const soleScene* scene, int32_t piece, double time, soleTransform* fromStart );
/// How it moves then: velocity of the place fromStart.translation and spin, rad/s.
void soleGetScenePieceSpeed( const soleScene* scene, int32_t piece, double time, soleVec3* velocity, soleVec3* spin );

/// Where a walker is that has gone so far along the scene's way: its place on the ground, its +y out of it, its +z
/// ahead.
void soleGetSceneWay( const soleScene* scene, double gone, soleTransform* place );

/// All ids, in the order in which they should be shown.
const char* const* soleGetSceneIds( int32_t* count );

#endif
