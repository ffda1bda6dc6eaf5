// SPDX-License-Identifier: MIT
// Triangles with colours in the world, and the meshes of a posed model as such.
#ifndef TOOL_SKIN_H
#define TOOL_SKIN_H

#include "model.h"

/// Grows by appending; start from zeroed memory. World space.
typedef struct toolTriangles
{
	int32_t vertexCount;
	float* positions; // 3 a vertex
	int32_t triangleCount;
	uint32_t* indices; // 3 a triangle
	float* colors;     // 3 a triangle, linear
} toolTriangles;

void toolFreeTriangles( toolTriangles* triangles );

/// Copies triangles of one colour.
void toolAddTriangles( toolTriangles* triangles, const float* positions, int32_t vertexCount, const uint32_t* indices,
    int32_t triangleCount, const float color[3] );

/// Appends all meshes of a model in a pose: linear blend skinning, or the node's place where there is no skin.
/// @param localPose parent-local transforms of the model's nodes
/// @param root goes before the poses of all top nodes
void toolSkinModel(
    const toolModel* model, const soleTransform* localPose, soleTransform root, toolTriangles* triangles );

#endif
