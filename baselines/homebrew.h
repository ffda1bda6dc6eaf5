// SPDX-License-Identifier: MIT
// The foot IK "Homebrew" 1.5, as its author describes it: one sphere under each ankle, the foot's height and the
// ground's normal through a critically damped spring each, the body down to the lower foot. Same shape as soleSolve():
// gather, cast, solve, apply.
//
// Lengths are the world's, angles degrees, as in the original. One state per character: start anew from the default
// where the character was moved by a jump that is no motion, for the system itself knows none.
#ifndef SOLE_BASELINES_HOMEBREW_H
#define SOLE_BASELINES_HOMEBREW_H

#include "baselines/baseline.h"

/// The original's parameters. "ours" marks defaults that its description does not tell.
typedef struct soleHomebrewSettings
{
	float globalWeight;    // of all. [0, 1] default 1, ours
	float leftFootWeight;  // of left feet and those in the middle. [0, 1] default 1, ours
	float rightFootWeight; // of right feet. [0, 1] default 1, ours

	uint32_t groundLayers;   // default 0: none chosen, which counts as the lowest layer
	float smoothTime;        // of the springs, s. [0, 1] default 0.08, ours
	float raySphereRadius;   // of the sphere that is cast, and a part of the ankle's height. [0, 1] default 0.05, ours
	float ankleHeightOffset; // the rest of it. [-1, 1] default 0.03, ours
	float lengthFromHeelToToes;        // [0, 1] default 0.19, ours
	float maxRotationAngle;            // of the ground's normal from the root's up. degrees [0, 90] default 45, ours
	float rayCastRange;                // of the cast. [0, 10] default 1.2, ours
	float leftFootRaycastStartHeight;  // over the ankle. [0, 5] default 0.5, ours
	float rightFootRaycastStartHeight; // likewise. [0, 5] default 0.5, ours

	float floorRange;   // a foot that is animated lower than this over its place is on the floor. [0, 1] default 0.1
	float crouchRange;  // most that the legs take up before the body is lifted. [0, 1] default 0.25
	float stretchRange; // most that the body stays over the lower foot. [0, 1] default 0
	float worldHeightOffset; // added to the feet's height. [-1, 1] default 0

	bool enableFootRotation;      // feet turn with the ground. default true, ours
	bool enableFootLifting;       // feet that are animated higher than their place are let go. default true, ours
	bool enableBodyPositioning;   // the body follows the lower foot. default true, ours
	bool enableWorldHeightOffset; // default false, ours
} soleHomebrewSettings;

/// Memory of one foot. World, heights along up.
typedef struct soleHomebrewFoot
{
	soleVec3 startForward; // the root's forward at the start, in the space of the foot's joint
	float carriedHeight;   // of the animated ankle moved with the body, as the last callback saw it
	float height;          // filtered, and its speed
	float heightVelocity;
	soleVec3 normal; // filtered, any length, and its speed
	soleVec3 normalVelocity;
} soleHomebrewFoot;

/// Memory of one character: plain data.
typedef struct soleHomebrewState
{
	bool started;
	soleShownFeet shown;
	soleHomebrewFoot feet[SOLE_MAX_LEGS];
} soleHomebrewState;

soleHomebrewSettings soleDefaultHomebrewSettings( void );
/// Sets what a user would set by eye for this character: the ankle's height, the foot's length, and all other lengths
/// in proportion to its legs. For a root of scale 1.
void soleFitHomebrewSettings( const soleRig* rig, soleHomebrewSettings* settings );

soleHomebrewState soleDefaultHomebrewState( const soleRig* rig );

/// One sphere a leg, straight down over the foot as it was shown in the last frame.
int32_t soleGatherHomebrew( const soleRig* rig, const soleHomebrewSettings* settings, const soleHomebrewState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity );

/// @param hits the answers to soleGatherHomebrew's questions, in the same order.
void soleSolveHomebrew( const soleRig* rig, const soleHomebrewSettings* settings, soleHomebrewState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, soleOutput* output );

#endif
