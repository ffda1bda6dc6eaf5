// SPDX-License-Identifier: MIT
// A baked rig: everything about the legs that does not change from frame to frame.
#ifndef SOLE_RIG_RIG_H
#define SOLE_RIG_RIG_H

#include "base/math_internal.h"
#include "rig/settings.h"
#include "sole/sole.h"

/// Joints that have to be evaluated each frame: the legs', the pelvis and all above them.
#define SOLE_MAX_SLOTS 256

/// Limits of the ankle as half angles about one axis, low <= high.
typedef struct soleRange
{
	soleHalf low;
	soleHalf high;
} soleRange;

/// Slots are indices into the rig's list of evaluated joints.
typedef struct soleRigLeg
{
	soleLegDef def; // as given; hinge filled in and unit, name pointing into this struct
	char name[32];

	int16_t slots[SOLE_MAX_LEG_JOINTS]; // of def.joints
	int16_t kneeIndex;                  // which of def.joints bends
	int16_t footSlot;                   // the joint that carries the sole
	int16_t toeSlot;                    // the first toe joint, or SOLE_NONE
	bool footBelowPelvis;               // a detached foot that moves with the pelvis all the same

	float length; // along the bones in the bind pose, character space

	// Joint to character space in the bind pose.
	soleTransform footBind;
	soleTransform toeBind; // of the first toe joint

	// In the local space of the joint that carries them, bind pose.
	soleVec3 hinge;                                   // unit, in the hip joint's rotation
	soleVec3 virtualAnkle;                            // in the last chain joint
	soleVec3 heel, toe, inner, outer, pivot;          // in the foot joint
	soleVec3 foreBall, foreInner, foreOuter, foreToe; // in the first toe joint, else in the foot joint
	soleVec3 footUp, footForward, footSide;           // unit, in the foot joint's rotation; side = forward x up
	soleQuat neutral;                                 // rotation of the foot against the shin

	// The sole as it lies flat on the floor, bind pose, character space: lengths from the ball.
	float heelBehind; // > 0
	float toeAhead;   // > 0
	float innerSide;  // signed along footSide
	float outerSide;
	float ankleHeight; // over the sole
	float ankleBehind; // the ball

	soleRange pitch; // about footSide, positive toes up
	soleRange roll;  // about footForward
	soleRange twist; // about footUp
} soleRigLeg;

struct soleRig
{
	const soleAllocator* allocatorOrNull;
	soleAllocator allocator;
	size_t byteCount;

	int32_t jointCount;
	int32_t* parents; // jointCount

	int32_t slotCount;
	int32_t slotJoints[SOLE_MAX_SLOTS];  // parents come first
	int16_t slotParents[SOLE_MAX_SLOTS]; // slot of the parent, or SOLE_NONE
	int16_t pelvisSlot;

	int32_t pelvis;
	int32_t spine; // the joint that carries the trunk, or SOLE_NONE
	soleVec3 up;
	soleVec3 forward;
	soleSettingRanges settingRanges;
	int32_t legCount;
	soleRigLeg legs[SOLE_MAX_LEGS];
};

#endif
