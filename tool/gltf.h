// SPDX-License-Identifier: MIT
// glTF files: read them, append to them, write them. What is not appended to stays byte for byte.
#ifndef TOOL_GLTF_H
#define TOOL_GLTF_H

#include "model.h"

/// An open file: its bytes and what they mean.
typedef struct toolGltf toolGltf;

/// Reads .glb, .vrm or .gltf (external or base64 buffers). The file is hostile: everything is checked.
bool toolReadGltf( const char* path, toolGltf** gltf, toolError* error );
/// The same from memory, as if it were a .glb at that path.
bool toolReadGlbBytes( const uint8_t* bytes, size_t byteCount, const char* path, toolGltf** gltf, toolError* error );
void toolFreeGltf( toolGltf* gltf );
const toolModel* toolGltf_GetModel( const toolGltf* gltf );

/// A file made from nothing: every node, skin, mesh, material and clip of the model. Skinned nodes without children
/// become roots without a place of their own; meshes without triangles and clips without channels are left out.
/// @return NULL where the model is broken: something not finite, an index past its end.
toolGltf* toolMakeGltf( const toolModel* model );

/// Appends a clip. Its channels are LINEAR or STEP; channels with equal times share one accessor. The model is renewed;
/// what was taken from it before stays good until the file is freed.
bool toolGltf_AppendClip( toolGltf* gltf, const toolClip* clip, toolError* error );
/// Appends meshes as nodes of the first scene: the model's nodes, meshes and materials; no skins, no clips.
bool toolGltf_AppendScene( toolGltf* gltf, const toolModel* scene, toolError* error );

/// .glb, or .gltf with a .bin beside it, by the path's ending. With nothing appended a .glb comes out byte for byte as
/// it was read.
bool toolWriteGltf( const toolGltf* gltf, const char* path, toolError* error );
/// The file as a .glb in memory, which free() ends.
/// @param path for messages
bool toolPackGlb( const toolGltf* gltf, const char* path, uint8_t** bytes, size_t* byteCount, toolError* error );

#endif
