// SPDX-License-Identifier: MIT
// Characters and grounds by file or, where there is no such file, by the name of an embedded sample; and what is taken
// of them where the user does not say.
#ifndef TOOL_SOURCE_H
#define TOOL_SOURCE_H

#include "gltf.h"
#include "ground_file.h"
#include "scenario.h"
#include "walker.h"

bool toolOpenCharacter( const char* name, toolGltf** gltf, toolError* error );
/// The embedded one, whatever files there are. False where there is no character of that name.
bool toolOpenEmbeddedCharacter( const char* name, toolGltf** gltf );

/// A ground ready to be asked. Metres.
typedef struct toolGroundSource
{
	char* name; // as the user gave it
	toolGroundMesh mesh;
	soleGround* ground;
	/// The way that an embedded scene is meant to be walked; NULL where there is none.
	toolPlace* path;
	int32_t pathCount;
} toolGroundSource;

bool toolOpenGround( const char* name, toolGroundSource* source, toolError* error );
/// The embedded one, whatever files there are. False where there is no scene of that name.
bool toolOpenEmbeddedGround( const char* name, toolGroundSource* source );
void toolCloseGround( toolGroundSource* source );

/// What feet on the ground are measured against.
bool toolMakeTerrain( const toolGroundSource* source, soleTerrain** terrain, toolError* error );

/// The ground as nodes of a scene, to be added to a file.
/// Files of scenes have all their vertices, and the triangles of those pieces that are seen at time 0.
bool toolIsPieceInFile( const soleScene* scene, int32_t piece );
void toolMakeGroundModel( const toolGroundSource* source, toolModel* model );

/// The best walk by its name, else the first clip that is named like another gait, else the first clip. SOLE_NONE
/// where there is no clip.
int32_t toolChooseClip( const toolModel* model );

/// Binds a clip of a character's own file or of another.
/// @param name NULL: the best walk; without clips the character stands at rest
/// @param file that the clips are in, for messages
bool toolBindNamedClip( const toolCharacter* character, const toolModel* clipModel, const char* file, const char* name,
    toolBoundClip* bound, toolError* error );

/// A start near the middle of the ground from which the way straight on has ground all along, best without steps that
/// are too high.
bool toolChooseStart( const soleGround* ground, const char* groundName, double heading, double distance, double step,
    toolPlace* start, toolError* error );

#endif
