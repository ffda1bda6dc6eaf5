// SPDX-License-Identifier: MIT
// What the four systems share that Sole is compared with: reading a frame's legs, and writing placed legs into an
// output that soleApply() takes. Nothing of how any of them places feet is in here, and nothing of Sole's own stages:
// only what include/sole offers to everyone.
//
// They are references, made to be compared with, not to be shipped: they believe their input, and a frame that
// soleSolve() would refuse is not refused here.
#ifndef SOLE_BASELINES_BASELINE_H
#define SOLE_BASELINES_BASELINE_H

#include "sole/sole.h"

#define SOLE_BASELINE_DEGREE 0.0174532925f // in radians

/// A leg of the animated pose.
typedef struct soleBaselineLeg
{
	soleLegDef def;
	int32_t kneeIndex; // which of def.joints bends, as Sole chooses it; 0: none, the leg is one bone
	soleVec3 hip_w;
	soleVec3 knee_w;
	soleVec3 ankle_w;     // end of the chain
	soleTransform foot_w; // the joint that carries the sole: the ankle's own or a detached foot
	soleVec3 hinge_w;     // unit
	float length;         // hip to knee to ankle, world
} soleBaselineLeg;

/// Where the placed leg is wanted.
typedef struct soleBaselineGoal
{
	soleVec3 pelvisOffset_w; // of the whole output: the hip has moved along
	soleVec3 ankle_w;
	soleQuat foot_w; // rotation of the joint that carries the sole
} soleBaselineGoal;

/// The feet as they were shown in the last frame, seen from the root. A host that runs before its animation is
/// evaluated finds the bones like this: corrected, and carried along by the character since. Zeroed memory knows none.
typedef struct soleShownFeet
{
	bool known;
	soleVec3 ankles[SOLE_MAX_LEGS]; // character space, as are the turns
	soleQuat feet[SOLE_MAX_LEGS];
} soleShownFeet;

/// The frame's root, put on the clip's own floor: the four systems know no clip whose floor is not at the origin.
/// Rotation of unit length.
soleTransform soleGetBaselineRoot( const soleRig* rig, const soleFrame* frame );
/// A joint of the animated pose in the world.
soleTransform soleGetBaselineJoint( const soleRig* rig, const soleFrame* frame, int32_t joint );
soleBaselineLeg soleReadBaselineLeg( const soleRig* rig, const soleFrame* frame, int32_t leg );
/// Unit; the frame's, or the rig's carried by the root.
soleVec3 soleGetBaselineUp( const soleRig* rig, const soleFrame* frame );
/// What the host gives a leg, and gives the whole where leg is SOLE_NONE. [0, 1]
float soleGetBaselineWeight( const soleFrame* frame, int32_t leg );
/// Seconds since the last frame, zero where that is no time.
float soleGetBaselineTimeStep( const soleFrame* frame );

/// A direction of the bind pose, character space, in the space of the joint that carries the sole. Unit.
soleVec3 soleGetBaselineFootAxis( const soleRig* rig, int32_t leg, soleVec3 direction );
/// Right legs have settings of their own where a system knows two feet; all others are left ones to it.
bool soleIsRightBaselineLeg( const soleRig* rig, int32_t leg );
/// How large the character is against the human for whom such systems' default lengths are meant.
float soleGetBaselineSize( const soleRig* rig );
/// Height of the joint that carries the sole over the sole, and length of the sole from heel to toe tip: bind pose,
/// character space.
float soleGetBaselineAnkleHeight( const soleRig* rig, int32_t leg );
float soleGetBaselineSoleLength( const soleRig* rig, int32_t leg );

/// The foot of the last frame, as seen now; the animated one where none is known. Only ankle_w and foot_w are set.
soleBaselineGoal soleGetShownFoot(
    const soleRig* rig, const soleFrame* frame, const soleShownFeet* shown, int32_t leg );
/// Keeps a foot that is shown in this frame.
void soleKeepShownFoot( const soleFrame* frame, const soleBaselineGoal* foot, int32_t leg, soleShownFeet* shown );

/// The output that changes nothing.
void soleStartBaselineOutput( const soleRig* rig, const soleFrame* frame, soleOutput* output );
/// The leg's bones, its hip moved with the pelvis, and the target: as far as the bones reach, with no soft zone. A
/// system that softens or has its own hinge changes that before soleSolveTwoBone().
soleTwoBoneDef soleMakeBaselineTwoBone( const soleBaselineLeg* leg, const soleBaselineGoal* goal );
/// Writes one leg: joints, foot, where it came to be. @return the foot as it will be shown
soleBaselineGoal soleWriteBaselineLeg( const soleRig* rig, const soleFrame* frame, const soleBaselineLeg* leg,
    const soleBaselineGoal* goal, const soleTwoBoneResult* bent, soleLegOutput* output );
/// All three in one for systems that bend plainly.
soleBaselineGoal solePlaceBaselineLeg( const soleRig* rig, const soleFrame* frame, const soleBaselineLeg* leg,
    const soleBaselineGoal* goal, soleLegOutput* output );
/// Tells in the output what was met under a leg.
void soleWriteBaselineGround(
    const soleRig* rig, const soleFrame* frame, const soleHit* hitOrNull, soleLegOutput* output );
void soleWriteBaselinePelvis( const soleRig* rig, const soleFrame* frame, soleVec3 pelvisOffset_w, soleOutput* output );

#endif
