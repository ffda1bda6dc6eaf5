// SPDX-License-Identifier: MIT
// Foot placement as the side-scroller "And I Must Scream" does it, for a character that stands: traces under the feet,
// the hip lowered to the lower foot's ground, the feet raised against the hip, the capsule made shorter, all brought on
// by interpolation; taken back while moving, and left alone once it is there. It gives numbers for an animation graph;
// what that graph does with them, hip down and two-bone IK to the effectors, is given too.
#ifndef SOLE_BASELINES_EFFECTOR_H
#define SOLE_BASELINES_EFFECTOR_H

#include "sole/sole.h"

/// Lengths are centimetres of the world, as in the original. Start from soleDefaultEffectorSettings().
typedef struct soleEffectorSettings
{
	bool enableAnimationIk;         // default true
	float meshScale;                // of the mesh along up, in the capsule. > 0 default 1
	float transformScale;           // of the character along up. > 0 default 1
	float capsuleHalfHeight;        // of the capsule at rest; its lower end is at the root. cm > 0 default 88
	float traceDistance;            // how far below the capsule is traced. cm >= 0 default 55
	float footAdjustment;           // added to the height of each ground that is met. cm default 0
	float feetInterpSpeed;          // of the effectors. 1/s >= 0, 0 jumps; default 15
	float hipInterpSpeed;           // of hip and capsule. 1/s >= 0, 0 jumps; default 10
	float nearlyEqual;              // effectors so near to where they go are there. cm default 1
	float unitsPerCentimetre;       // the world's. > 0 default 0.01, metres
	int32_t sockets[SOLE_MAX_LEGS]; // joint under which is traced; SOLE_NONE: the ankle. default SOLE_NONE
} soleEffectorSettings;

/// Plain data. Nothing in here sets usingFootIk again once it is off: that is the host's.
typedef struct soleEffectorState
{
	bool usingFootIk;               // default true
	bool hasRoot;                   // there was a frame before
	soleVec3 root_w;                // then
	float hipOffset;                // cm, never above zero
	float effectors[SOLE_MAX_LEGS]; // as in soleEffectorOutput
	float capsuleShorter;           // than at rest, half height. cm
} soleEffectorState;

/// What the animation graph reads.
typedef struct soleEffectorOutput
{
	float hipOffset;                // of the hip along up. cm, never above zero
	float effectors[SOLE_MAX_LEGS]; // of each foot over the lowered hip's, along up. cm of scaled component space
	float capsuleHalfHeight;        // cm
} soleEffectorOutput;

soleEffectorSettings soleDefaultEffectorSettings( void );
/// What a careful user sets for a character: a capsule as high as the hips at half of its height, the trace by size.
/// unitsPerCentimetre is to be set before.
void soleFitEffectorSettings( const soleRig* rig, soleEffectorSettings* settings );

soleEffectorState soleDefaultEffectorState( const soleRig* rig );

/// A probe a leg; of no length, which need not be cast, while nothing is traced.
int32_t soleGatherEffector( const soleRig* rig, const soleEffectorSettings* settings, const soleEffectorState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity );

/// @param effectors what the original computes. May be NULL.
/// @param output what an animation graph makes of it: the mesh goes down with the capsule and the hip, two-bone IK
/// brings each ankle to its effector, the feet keep their rotation.
void soleSolveEffector( const soleRig* rig, const soleEffectorSettings* settings, soleEffectorState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, soleEffectorOutput* effectors, soleOutput* output );

#endif
