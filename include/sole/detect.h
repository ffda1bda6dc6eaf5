// SPDX-License-Identifier: MIT
// Finds the legs and soles of a skeleton that nobody has described yet: by the names of the common conventions first,
// by structure and geometry where names are of no help. Set-up code, not per frame.
#ifndef SOLE_DETECT_H
#define SOLE_DETECT_H

#include "sole/types.h"

/// What a joint is, where a file says so (VRM's bone map, Unity's humanoid avatar).
typedef enum soleJointRole
{
	sole_roleNone = 0,
	sole_rolePelvis,
	sole_roleLeftHip,
	sole_roleLeftKnee,
	sole_roleLeftAnkle,
	sole_roleLeftToe,
	sole_roleRightHip,
	sole_roleRightKnee,
	sole_roleRightAnkle,
	sole_roleRightToe,
	sole_roleHead,
	sole_roleForce32 = 0x7fffffff
} soleJointRole;

/// A vertex of the skin in the bind pose.
typedef struct soleSkinVertex
{
	soleVec3 position; // character space
	int32_t joints[4]; // SOLE_NONE where unused
	float weights[4];
} soleSkinVertex;

/// What is known of a character before its legs are.
typedef struct soleSkeleton
{
	int32_t jointCount;
	const int32_t* parents;
	const soleTransform* bindPose; // parent-local
	const char* const* names;      // may be NULL, as may each
	const soleJointRole* roles;    // per joint, or NULL
	const soleSkinVertex* skin;    // may be NULL
	int32_t skinCount;
	/// Poses of clips, poseCount * jointCount parent-local transforms, or NULL: they tell which way knees bend where
	/// the bind pose is straight, and which joints move as legs do.
	const soleTransform* samplePoses;
	int32_t poseCount;
	/// Out of the floor. Zero: to be found.
	soleVec3 up;
	/// The way the character faces. Zero: to be found.
	soleVec3 forward;
} soleSkeleton;

typedef enum soleSeverity
{
	sole_info = 0,    // a finding and its reason
	sole_warning = 1, // a doubt: look at it
	sole_error = 2,   // it can't work like this
	sole_severityForce32 = 0x7fffffff
} soleSeverity;

/// One finding or doubt.
typedef struct soleFinding
{
	soleSeverity severity;
	int32_t leg;    // or SOLE_NONE
	int32_t joint;  // or SOLE_NONE
	char where[64]; // "leg left", "joint foot_l"
	char what[192]; // what was found, and why
	char mend[128]; // what to do about it; empty for plain findings
} soleFinding;

#define SOLE_MAX_FINDINGS 128

typedef struct soleDetectReport
{
	int32_t findingCount;
	/// More findings came than fitted.
	bool truncated;
	soleFinding findings[SOLE_MAX_FINDINGS];
	/// Hip to ankle along the bones of the longest leg, character space.
	float legLength;
	/// Factor that would make the character human sized (leg 0.9 m for a biped); 1 where the size is believable.
	float suggestedScale;
} soleDetectReport;

/// Fills in the legs, pelvis, up and forward of a definition, and points it at the skeleton's arrays.
/// @param def started from soleDefaultRigDef().
/// @param report may be NULL. Large: not for small stacks.
/// @return sole_notFound where no legs were found: the report says what was looked for.
SOLE_API soleResult soleDetectRig( const soleSkeleton* skeleton, soleRigDef* def, soleDetectReport* report );

#endif
