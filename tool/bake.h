// SPDX-License-Identifier: MIT
// A character's clip played over ground with its feet placed: in memory, and as a clip for its file.
#ifndef TOOL_BAKE_H
#define TOOL_BAKE_H

#include "walker.h"

#include "sole/trace.h"

/// What one step of a method gets and gives.
typedef struct toolMethodStep
{
	const toolCharacter* character;
	const soleGround* ground;
	const soleSettings* settings;
	const soleFrame* frame;
	soleTracer* tracer;     // what method "sole" records its frames with, or NULL
	soleTransform* pose;    // a copy of the frame's pose, to be changed
	uint32_t* flags;        // per leg, soleLegFlags; zeroed
	float* plantWeights;    // per leg; zeroed
	float* shortfalls;      // per leg, how far its end is from where the method wants it, m; NaN: not told
	soleVec3* pelvisOffset; // world; zeroed
} toolMethodStep;

/// A way of placing feet.
typedef struct toolMethod
{
	const char* name;
	const char* summary;
	/// Memory of one character at the start of a walk; freed with free(). May be NULL: needs none.
	void* ( *init )( const toolCharacter* character );
	/// May be NULL: leaves the pose as it is.
	void ( *step )( void* memory, const toolMethodStep* step );
} toolMethod;

/// NULL where there is no such method.
const toolMethod* toolFindMethod( const char* name );
/// Ends with one without a name.
const toolMethod* toolGetMethods( void );

/// Start from toolDefaultBakeDef().
typedef struct toolBakeDef
{
	const toolMethod* method;
	const soleSettings* settings;
	soleTracer* tracer;     // made from the character's rig definition; NULL: nothing is recorded
	const char* groundName; // for messages
	/// As in toolWalkDef.
	const toolPlace* path;
	int32_t pathCount;
	double heading;
	double distance;
	double speed;
	double duration;
	double fps;
} toolBakeDef;

toolBakeDef toolDefaultBakeDef( void );

/// A take: every frame of the walk, before and after the feet were placed.
typedef struct toolBakeResult
{
	int32_t jointCount;
	int32_t legCount;
	toolWalk walk;
	float clipFloor;       // height of the clip's own floor over the origin
	soleTransform* input;  // frameCount * jointCount, parent-local, in place
	soleTransform* output; // likewise
	uint32_t* flags;       // frameCount * legCount
	float* plantWeights;   // frameCount * legCount
	float* shortfalls;     // frameCount * legCount, m; NaN where the method does not tell
	soleVec3* pelvis;      // frameCount, world
} toolBakeResult;

/// What is computed does not depend on the frame rate but by the times at which it is looked at.
bool toolBake( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const soleGround* ground, const toolBakeDef* def, toolBakeResult* result, toolError* error );
void toolFreeBakeResult( toolBakeResult* result );

/// The take as a clip "CLIP|METHOD" for the character's file. The node that carries the travel, all between it and the
/// pelvis, legs and feet get a key a frame; all else keeps the clip's own keys, round after round.
/// @param clipsFile where the clip comes from, for the new clip's extras. NULL: the character's file
void toolMakeBakedClip( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const char* methodName, const char* clipsFile, const toolBakeResult* result, toolClip* clip );

#endif
