// SPDX-License-Identifier: MIT
// Clips of a character's file baked over a ground with one or more methods, and measured: what the commands that bake
// have in common.
#ifndef TOOL_BAKE_JOB_H
#define TOOL_BAKE_JOB_H

#include "bake_options.h"
#include "evaluate.h"

/// Everything that is open meanwhile. Zeroed memory is a job that nothing was opened for.
typedef struct toolBakeJob
{
	const toolBakeOptions* options;
	toolGltf* gltf;
	toolGltf* clipsGltf; // NULL: the clips are in gltf
	toolCharacter character;
	toolGroundSource ground;
	soleTerrain* terrain;
	soleSettings settings;
	soleTracer* tracer; // what method "sole" records its frames with, or NULL
	toolClip* made;     // all clips so far, to be appended
	int32_t madeCount;
} toolBakeJob;

/// One method's take of a clip.
typedef struct toolBakedTake
{
	const toolMethod* method;
	char* name; // of the new clip
	soleFigures figures;
	soleFigures reference; // of the clip on flat ground, feet untouched
	toolBakeResult result;
} toolBakedTake;

/// The takes of one clip, in the order of the options' methods, all along the same way.
typedef struct toolBakedClip
{
	char* name; // of the clip that was baked
	toolBakedTake* takes;
	int32_t takeCount;
} toolBakedClip;

/// @param options stay the caller's, for as long as the job is open
bool toolOpenBakeJob( const toolBakeOptions* options, toolBakeJob* job, toolError* error );
void toolCloseBakeJob( toolBakeJob* job );

/// At least 1: where the options name no clip, that is the best walk.
int32_t toolCountJobClips( const toolBakeJob* job );
/// Bakes and measures one of them.
bool toolBakeJobClip( toolBakeJob* job, int32_t index, toolBakedClip* baked, toolError* error );
void toolFreeBakedClip( toolBakedClip* baked );

/// Appends all that was made to the character's file.
bool toolAppendBakes( toolBakeJob* job, toolError* error );

#endif
