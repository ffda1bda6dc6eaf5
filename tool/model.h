// SPDX-License-Identifier: MIT
// A character or a ground in memory, as the readers make it and the writers take it: nodes, skins, meshes, clips.
// Plain data; whoever makes a model frees it with toolFreeModel().
#ifndef TOOL_MODEL_H
#define TOOL_MODEL_H

#include "sole/math.h"
#include "tool.h"

typedef struct toolNode
{
	char* name;          // never NULL; empty where the file gives none
	int32_t parent;      // or SOLE_NONE
	soleTransform local; // the rest pose; a matrix in the file is taken apart
	bool hasMatrix;      // the file gave a matrix: such a node may not be animated without being rewritten
	int32_t mesh;        // or SOLE_NONE
	int32_t skin;        // or SOLE_NONE
} toolNode;

typedef struct toolSkin
{
	char* name;
	int32_t jointCount;
	int32_t* joints;    // node indices
	float* inverseBind; // 16 a joint, column by column as in glTF; identity where the file gives none
} toolSkin;

/// Triangles of one material. Strips and fans are turned to triangles, points and lines left out.
typedef struct toolPrimitive
{
	int32_t vertexCount;
	float* positions; // 3 a vertex
	float* normals;   // 3 a vertex, or NULL
	int32_t indexCount;
	uint32_t* indices;  // 3 a triangle, always there
	int32_t influences; // per vertex: 0, 4 or 8
	uint16_t* joints;   // influences a vertex: indices into the skin's joints
	float* weights;     // influences a vertex
	int32_t material;   // or SOLE_NONE
} toolPrimitive;

typedef struct toolMesh
{
	char* name;
	int32_t primitiveCount;
	toolPrimitive* primitives;
} toolMesh;

typedef struct toolMaterial
{
	char* name;
	float color[4]; // base colour, linear
	float roughness;
	bool doubleSided;
} toolMaterial;

typedef enum toolPath
{
	tool_pathTranslation,
	tool_pathRotation,
	tool_pathScale
} toolPath;

typedef enum toolInterpolation
{
	tool_linear,
	tool_step,
	tool_cubic // three values a key: in-tangent, value, out-tangent
} toolInterpolation;

typedef struct toolChannel
{
	int32_t node;
	toolPath path;
	toolInterpolation interpolation;
	int32_t keyCount;
	float* times;  // ascending, finite
	float* values; // 3 or 4 floats a value
} toolChannel;

typedef struct toolClip
{
	char* name;
	int32_t channelCount;
	toolChannel* channels; // weights (morph) channels are left out
	float start;           // first key of any channel, s
	float end;             // last key
	/// JSON object text of the animation's extras, or NULL.
	char* extras;
} toolClip;

/// A bone that the file itself names: VRM's humanoid map ("leftUpperLeg").
typedef struct toolBone
{
	char* name;
	int32_t node;
} toolBone;

typedef struct toolModel
{
	int32_t nodeCount;
	toolNode* nodes;
	int32_t skinCount;
	toolSkin* skins;
	int32_t meshCount;
	toolMesh* meshes;
	int32_t materialCount;
	toolMaterial* materials;
	int32_t clipCount;
	toolClip* clips;
	int32_t boneCount;
	toolBone* bones;
	/// A VRM file of version 0, whose characters face -Z.
	bool vrm0;
} toolModel;

void toolFreeModel( toolModel* model );
void toolFreeClip( toolClip* clip );

/// Index of the clip with this name, or SOLE_NONE.
int32_t toolFindClip( const toolModel* model, const char* name );
int32_t toolFindNode( const toolModel* model, const char* name );

/// Scene-space transform of a node in the rest pose, parents first. Parents must not form a cycle (readers refuse
/// that).
soleTransform toolNodeWorld( const toolModel* model, int32_t node );

#endif
