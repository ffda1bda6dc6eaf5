// SPDX-License-Identifier: MIT
// Grounds from files: triangles in the world of a .glb, .gltf or .obj file.
#ifndef TOOL_GROUND_FILE_H
#define TOOL_GROUND_FILE_H

#include "sole/ground.h"
#include "sole/measure.h"
#include "tool.h"

/// Triangles of a ground, in metres of the file's world.
typedef struct toolGroundMesh
{
	int32_t vertexCount;
	float* positions; // 3 a vertex
	int32_t triangleCount;
	uint32_t* indices; // 3 a triangle
} toolGroundMesh;

/// Refused: no triangles, anything not finite. scale multiplies all positions.
bool toolReadGround( const char* path, float scale, toolGroundMesh* ground, toolError* error );
void toolFreeGroundMesh( toolGroundMesh* ground );

/// A Wavefront OBJ file in memory: v and f lines, polygons split into fans, negative indices, no materials.
bool toolReadObjBytes(
    const uint8_t* bytes, size_t byteCount, const char* path, toolGroundMesh* ground, toolError* error );

#endif
