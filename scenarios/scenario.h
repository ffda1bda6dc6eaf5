// SPDX-License-Identifier: MIT
// Grounds made by formula, used alike by tests, benchmarks, the program and the viewer. World space, metres, +Y up, to
// be walked along +Z. All are closed solids with their faces outwards (counter clockwise seen from outside), so that a
// depth below the surface has a meaning; neighbouring pieces share their corners.
#ifndef SCENARIOS_SCENARIO_H
#define SCENARIOS_SCENARIO_H

#include <stdbool.h>
#include <stdint.h>

#define SOLE_SCENE_MAX_PATH 32

typedef struct soleScene
{
	char id[16];
	char name[64];
	int32_t vertexCount;
	float* positions; // 3 a vertex
	int32_t triangleCount;
	uint32_t* indices; // 3 a triangle
	/// A way for a walking character: x, z of its corners, at least 0.7 inside the ground.
	int32_t pathCount;
	float path[SOLE_SCENE_MAX_PATH][2];
} soleScene;

/// Makes one of soleGetSceneIds(). Those with something random take a seed as well: "rubble-7", "T16-2", "T17-3";
/// without one it is 1.
/// @return false for an unknown id or without memory. The scene is then empty.
bool soleMakeScene( const char* id, soleScene* scene );
void soleFreeScene( soleScene* scene );

/// All ids, in the order in which they should be shown.
const char* const* soleGetSceneIds( int32_t* count );

#endif
