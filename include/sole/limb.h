// SPDX-License-Identifier: MIT
// Goals for limbs: hands and feet with place and turn, elbows and knees as hints, and a head that looks at something,
// each with a weight. Stateless, without ground, for any rig: the counterpart of the goals that engines give to
// humanoids. Call it on the animated pose, or on the pose that soleApply() left.
//
// All places and rotations are in character space, that of joints without a parent, but for those that end in _l,
// which are in the space of a joint or of its parent. Any unit, any up. Angles in radians. Weights are clamped to
// [0, 1]; one that is not a number is 0. Weight 0 gives back the same bits, weight 1 what was asked for.
// Only + - * / and sqrt: the same bits everywhere.
#ifndef SOLE_LIMB_H
#define SOLE_LIMB_H

#include "sole/types.h"

/// What became of a goal.
typedef enum soleLimbFlags
{
	sole_limbSoftened = 1 << 0,   // the goal is within the soft zone, or beyond it
	sole_limbOutOfReach = 1 << 1, // the goal is further away than the limb is long
	sole_limbFolded = 1 << 2,     // the goal is nearer than the limb may be folded
	sole_limbClamped = 1 << 3,    // the limit of the head's turn was met
	sole_limbDegenerate = 1 << 4, // bones of no length, or a goal at the first joint, or at the eyes
	sole_limbBadInput = 1 << 5,   // something that is used is not finite: the pose is passed through untouched
	sole_limbFlagsForce32 = 0x7fffffff
} soleLimbFlags;

// ---------------------------------------------------------------------------------------------------------- limbs

/// Two bones: shoulder, elbow and wrist, or hip, knee and ankle. Start from soleDefaultLimbDef().
typedef struct soleLimbDef
{
	/// Of the skeleton, as in soleRigDef. Not copied: they have to live as long as the definition is used.
	const int32_t* parents;
	int32_t jointCount;
	/// Joints, each somewhere below the one before: twist joints between them ride along. default SOLE_NONE
	int32_t upper;
	int32_t lower;
	int32_t end;
	/// The axis about which a positive turn bends the lower bone, in the upper joint's space, unit. Decides where a
	/// limb bends that is animated straight. From soleLimbDef_FindHinge(), or given. default zero: some side, always
	/// the same
	soleVec3 hinge_l;
	/// Furthest and least distance of the end as shares of the bones' length; further and less where the animation goes
	/// further. [0, 1] default 1 and 0
	float reach;
	float fold;
	/// The zone before the furthest distance in which the end lags softly behind its goal, instead of stopping dead;
	/// share of the bones' length. [0, 1] default 0.02. 0: none
	float softZone;
	/// Tells a filled definition from a forgotten one. Do not set.
	int32_t internalValue;
} soleLimbDef;

/// Where the end of a limb should be.
typedef struct soleLimbGoal
{
	soleVec3 position;
	soleQuat rotation; // of the end joint
	/// How far the end goes to its place. [0, 1]
	float positionWeight;
	/// How far it turns, from how it would be carried along by the limb. [0, 1]
	float rotationWeight;
} soleLimbGoal;

/// Where the middle joint should point to: the limb is turned about the line from its first joint to its end.
typedef struct soleLimbHint
{
	soleVec3 position;
	/// [0, 1] Fades to 0 for hints nearer to that line than 5 % of the bones' length.
	float weight;
} soleLimbHint;

typedef struct soleLimbResult
{
	/// New rotations of the three joints.
	soleQuat upper_l;
	soleQuat lower_l;
	soleQuat end_l;
	/// Where the end is now.
	soleVec3 end;
	/// How far that is from the weighted goal.
	float error;
	uint32_t flags; // soleLimbFlags
} soleLimbResult;

SOLE_API soleLimbDef soleDefaultLimbDef( void );

/// For callers who would rather ask than hit the assert. NULL is allowed and not valid.
SOLE_API bool soleLimbDef_IsValid( const soleLimbDef* def );

/// Takes the hinge from a pose in which the limb is bent as it bends, such as the bind pose.
/// @param localPose parent-local, jointCount of them
/// @return false, and nothing changed, where the limb is bent by less than 1 degree or the pose is not usable
SOLE_API bool soleLimbDef_FindHinge( soleLimbDef* def, const soleTransform* localPose );

/// Brings the end of a limb to its goal: bends the limb about its own axis, turns it as a whole by the shortest way,
/// then about the line from first joint to end as the hint asks, and then turns the end.
/// @param localPose parent-local, jointCount of them
/// @param hint NULL: none
/// A goal at the first joint folds the limb along its animated direction. A hint exactly opposite to where the middle
/// joint is turns it by half a turn, to a side that a partial weight shows.
SOLE_API soleLimbResult soleSolveLimb(
    const soleLimbDef* def, const soleTransform* localPose, const soleLimbGoal* goal, const soleLimbHint* hint );

/// Writes the three rotations into a pose.
SOLE_API void soleApplyLimb( const soleLimbDef* def, const soleLimbResult* result, soleTransform* localPose );

// -------------------------------------------------------------------------------------------------------- look at

#define SOLE_MAX_LOOK_JOINTS 8

/// Spine, neck, head. Start from soleDefaultLookDef().
typedef struct soleLookDef
{
	/// As in soleLimbDef.
	const int32_t* parents;
	int32_t jointCount;
	/// From the lowest to the head, each somewhere below the one before.
	int32_t joints[SOLE_MAX_LOOK_JOINTS];
	int32_t lookCount; // [1, SOLE_MAX_LOOK_JOINTS]
	/// What each of them does of the turn, relative to each other. [>= 0], not all of them 0. default 1
	float shares[SOLE_MAX_LOOK_JOINTS];
	/// Where the face looks, and the place between the eyes, in the space of the last joint. default +z, and zero
	soleVec3 forward_l;
	soleVec3 eyes_l;
	/// How far the gaze may turn from where the animation looks. [0, 2] default 1.2
	float limit;
	/// Tells a filled definition from a forgotten one. Do not set.
	int32_t internalValue;
} soleLookDef;

typedef struct soleLookResult
{
	/// New rotations of the joints.
	soleQuat rotations_l[SOLE_MAX_LOOK_JOINTS];
	/// Where the eyes are and look now, unit.
	soleVec3 eyes;
	soleVec3 gaze;
	uint32_t flags; // soleLimbFlags
} soleLookResult;

SOLE_API soleLookDef soleDefaultLookDef( void );

/// For callers who would rather ask than hit the assert. NULL is allowed and not valid.
SOLE_API bool soleLookDef_IsValid( const soleLookDef* def );

/// Turns neck and head so that the line of sight goes through the target, or as near as the limit lets it. Each joint
/// turns by the shortest way and does its share of what is left; the last one with a share makes it exact.
/// @param localPose parent-local, jointCount of them
/// Targets nearer than 2.5 times the way from a joint to the eyes count as that far away, in the same direction. Within
/// 26 degrees of straight behind, the weight fades to 0: the head comes back instead of jumping from side to side.
SOLE_API soleLookResult soleSolveLookAt(
    const soleLookDef* def, const soleTransform* localPose, soleVec3 target, float weight );

/// Writes the rotations into a pose.
SOLE_API void soleApplyLook( const soleLookDef* def, const soleLookResult* result, soleTransform* localPose );

#endif
