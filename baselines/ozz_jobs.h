// SPDX-License-Identifier: MIT
// The two jobs that the foot sample of ozz-animation is made of: two-bone IK and aim IK, whole, as their public
// documentation tells them. Everything is given and answered in one space of the caller's; the original takes model
// space and answers in the joints' own, which is the same rotation seen from there.
#ifndef SOLE_BASELINES_OZZ_JOBS_H
#define SOLE_BASELINES_OZZ_JOBS_H

#include "sole/math.h"

/// A chain of two bones and where its end should be.
typedef struct soleOzzTwoBoneJob
{
	soleVec3 start;
	soleVec3 mid;
	soleVec3 end;
	soleVec3 target;
	/// Carried by the mid joint, unit: a positive turn about it opens the angle between the bones.
	soleVec3 midAxis;
	/// Which way the mid joint should point, any length. The chain flips where it crosses the line to the target.
	soleVec3 poleVector;
	float twistAngle; // of the chain about the line from start to target. rad default 0
	float soften;     // share of the chain's length from which on the end falls behind the target. [0, 1] default 1
	float weight;     // of both corrections. [0, 1] default 1
} soleOzzTwoBoneJob;

/// Rotations to put before the joints' own: start turns the whole chain, mid the second bone, which gets start * mid.
typedef struct soleOzzTwoBoneResult
{
	soleQuat start;
	soleQuat mid;
	/// The target lies between the shortest chain and where softening begins, and the weight is 1.
	bool reached;
} soleOzzTwoBoneResult;

/// A joint that is to look at something.
typedef struct soleOzzAimJob
{
	soleVec3 joint;
	soleVec3 target;
	/// Carried by the joint, unit: what is pointed at the target, and what is held on the side of the pole vector.
	soleVec3 forward;
	soleVec3 up;
	/// From the joint, carried by it: where the line along forward begins.
	soleVec3 offset;
	soleVec3 poleVector; // any length
	float twistAngle;    // about the line from joint to target. rad default 0
	float weight;        // [0, 1] default 1
} soleOzzAimJob;

typedef struct soleOzzAimResult
{
	soleQuat turn; // to put before the joint's own rotation
	/// False where the target is nearer to the joint than the line that should meet it: nothing is turned then.
	bool reached;
} soleOzzAimResult;

soleOzzTwoBoneJob soleDefaultOzzTwoBoneJob( void );
soleOzzTwoBoneResult soleRunOzzTwoBone( const soleOzzTwoBoneJob* job );

soleOzzAimJob soleDefaultOzzAimJob( void );
soleOzzAimResult soleRunOzzAim( const soleOzzAimJob* job );

#endif
