// SPDX-License-Identifier: MIT
// Foot placement as the foot IK sample of ozz-animation does it: the character's height from a ray at its root, ankle
// targets from rays at the ankles, one offset by which the lowest reaches its own, two-bone IK of each leg, aim IK of
// each ankle. No memory but of where it was, no smoothing, no locking.
#ifndef SOLE_BASELINES_OZZ_H
#define SOLE_BASELINES_OZZ_H

#include "sole/sole.h"

/// Axes of a leg's joints that the sample knows of its own rig. Unit, in the space of the joint.
typedef struct soleOzzLegAxes
{
	soleVec3 kneeMidAxis;  // of the knee; a positive turn about it straightens the leg. default Z
	soleVec3 kneePole;     // of the knee: where it points. default Y
	soleVec3 ankleUp;      // of the joint that carries the sole: away from the ground. default -X
	soleVec3 ankleForward; // of the same: along the foot. default Y
} soleOzzLegAxes;

/// Lengths are the character's: the root's scale brings them to the world. Start from soleDefaultOzzSettings().
typedef struct soleOzzSettings
{
	bool autoCharacterHeight; // default true
	bool pelvisCorrection;    // default true
	bool twoBoneIk;           // default true
	bool aimIk;               // default true
	float footHeight;         // of the ankle over the ground. m [0, 0.3] default 0.12
	float weight;             // of both IK jobs. [0, 1] default 1
	float soften;             // share of the leg from which on it gives in. [0, 1] default 1, off
	float rootRayHeight;      // start of the ray at the root over it. m default 10
	float ankleRayHeight;     // start of the rays at the ankles over them. m default 0.5
	float aimHeight;          // what the ankle's up points at is so far off the ankle's target. m default 1
	uint32_t floorMask;       // layers that are floor. default all
	soleOzzLegAxes axes[SOLE_MAX_LEGS];
} soleOzzSettings;

/// Plain data.
typedef struct soleOzzState
{
	float rootShift; // by which the root's height was replaced, world
	bool hasTarget[SOLE_MAX_LEGS];
	soleVec3 ankleTargets_w[SOLE_MAX_LEGS];
} soleOzzState;

soleOzzSettings soleDefaultOzzSettings( void );
/// What a careful user sets for a character: foot height and axes as measured, the other lengths by its size.
/// @param bindPose parent-local, jointCount of the rig: the pose in which the rig was defined, which a rig does not
/// keep
void soleFitOzzSettings( const soleRig* rig, const soleTransform* bindPose, soleOzzSettings* settings );

soleOzzState soleDefaultOzzState( const soleRig* rig );

/// One probe at the root, then one a leg. The sample casts the first and moves the character before it casts the
/// others; here they start as high as the character was moved in the last frame. So where the ground under it jumps,
/// solve twice with the same frame.
int32_t soleGatherOzz( const soleRig* rig, const soleOzzSettings* settings, const soleOzzState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity );
void soleSolveOzz( const soleRig* rig, const soleOzzSettings* settings, soleOzzState* state, const soleFrame* frame,
    const soleHit* hits, int32_t hitCount, soleOutput* output );

#endif
