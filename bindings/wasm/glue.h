// SPDX-License-Identifier: MIT
// What the JavaScript side finds in the module's memory beside the library's own structs.
#ifndef SOLE_WASM_GLUE_H
#define SOLE_WASM_GLUE_H

#include "sole/draw.h"
#include "sole/ground.h"
#include "sole/sole.h"

/// One character with everything that its frames need, in one piece of memory: JavaScript writes the pose and reads the
/// output where they lie.
typedef struct soleWasmCharacter
{
	const soleRig* rig;
	const soleSettings* settings; // set before the first frame
	int32_t probeCount;           // of the last gather
	int32_t probeCapacity;
	int32_t supportCapacity;
	// All of the rig's joints or legs. The frame points to those of them that are used.
	soleTransform* pose;
	soleTransform* secondPose;
	soleTransform* placed; // what came of the pose
	float* legWeight;
	float* positionWeight;
	float* rotationWeight;
	soleContactInput* contact;
	soleStepInput* steps;
	soleSupport* supports;
	soleProbe* probes;
	soleHit* hits;
	soleFrame frame;
	soleOutput output;
	soleState state;
	soleState before; // the last frame, for drawing it
} soleWasmCharacter;

/// What soleWasmMark.kind says.
typedef enum soleWasmMarkKind
{
	sole_markLine = 0,   // from a to b
	sole_markArrow = 1,  // from a to b
	sole_markCircle = 2, // about a, normal b
	sole_markSphere = 3, // about a
	sole_markText = 4,   // at a
	sole_markForce32 = 0x7fffffff
} soleWasmMarkKind;

/// One thing that is drawn, in a list: a module without imports has nobody to call.
typedef struct soleWasmMark
{
	soleWasmMarkKind kind;
	uint32_t color;
	uint32_t category;
	soleVec3 a_w;
	soleVec3 b_w;
	float radius;
	char text[64];
} soleWasmMark;

/// Where marks go.
typedef struct soleWasmMarks
{
	soleWasmMark* marks;
	int32_t count; // that there would be with room
	int32_t capacity;
} soleWasmMarks;

/// @return NULL without memory. Ends with free().
soleWasmCharacter* soleWasm_CreateCharacter( const soleRig* rig, int32_t supportCapacity );
int32_t soleWasm_Gather( soleWasmCharacter* character );
void soleWasm_CastPieces( soleWasmCharacter* character, const soleGroundPiece* pieces, int32_t count );
void soleWasm_CastGround( soleWasmCharacter* character, const soleGround* ground );
/// Solves, and puts the placed pose beside the animated one.
void soleWasm_Solve( soleWasmCharacter* character );
/// What draws into a list, for what has callbacks.
soleDebugDraw soleWasm_MakePen( soleWasmMarks* list, uint32_t mask );
/// @return how many marks there are; at most capacity are written
int32_t soleWasm_Draw( const soleWasmCharacter* character, uint32_t mask, soleWasmMark* marks, int32_t capacity );

#endif
