// SPDX-License-Identifier: MIT
// The mannequin's mesh while it is made: vertices with up to two joints, triangles with a material. Root space.
#ifndef TOOL_MANNEQUIN_MESH_H
#define TOOL_MANNEQUIN_MESH_H

#include "mannequin_parts.h"

enum
{
	tool_materialBody,
	tool_materialJoints,
	tool_materialSoles,
	tool_materialCount
};

typedef struct toolVertex
{
	soleVec3 position;
	soleVec3 normal;
	int32_t joint;
	int32_t other; // takes `share` of the weight; the same as joint where there is none
	float share;
} toolVertex;

typedef struct toolTriangle
{
	int32_t corners[3]; // counter-clockwise seen from outside
	int32_t material;
} toolTriangle;

typedef struct toolShape
{
	int32_t vertexCount;
	int32_t vertexRoom;
	toolVertex* vertices;
	int32_t triangleCount;
	int32_t triangleRoom;
	toolTriangle* triangles;
} toolShape;

int32_t toolAddShapeVertex( toolShape* shape, soleVec3 position, int32_t joint, int32_t other, float share );
void toolAddShapeTriangle( toolShape* shape, int32_t a, int32_t b, int32_t c, int32_t material );
/// Corners counter-clockwise seen from outside.
void toolAddShapeQuad( toolShape* shape, const int32_t corners[4], int32_t material );

/// The left foot: upper, and a sole that is flat from heel to tip.
void toolAddFoot( toolShape* shape );

#endif
