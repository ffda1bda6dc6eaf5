// SPDX-License-Identifier: MIT
// Any of the four systems, fed alike: set as a careful user would set it for the character, woken, and given the curves
// that an animator would draw, all from the frame that Sole gets. Sole's own settings do not reach them. Same shape as
// soleSolve(): gather, cast, solve, apply.
#ifndef SOLE_BASELINES_ANCESTOR_H
#define SOLE_BASELINES_ANCESTOR_H

#include "baselines/effector.h"
#include "baselines/homebrew.h"
#include "baselines/iksetting.h"
#include "baselines/ozz.h"

#define SOLE_ANCESTOR_MAX_PROBES ( 1 + SOLE_MAX_LEGS ) // one at the root

typedef enum soleAncestorKind
{
	sole_ancestorHomebrew = 0,
	sole_ancestorIkSetting = 1,
	sole_ancestorEffector = 2,
	sole_ancestorOzz = 3,
	sole_ancestorForce32 = 0x7fffffff
} soleAncestorKind;

/// One system for one character: plain data.
typedef struct soleAncestor
{
	soleAncestorKind kind;
	union
	{
		soleHomebrewSettings homebrew;
		soleIkSettingSettings ikSetting;
		soleEffectorSettings effector;
		soleOzzSettings ozz;
	} settings;
	union
	{
		soleHomebrewState homebrew;
		soleIkSettingState ikSetting;
		soleEffectorState effector;
		soleOzzState ozz;
	} state;
} soleAncestor;

size_t soleAncestor_GetByteCount( void );

/// @param bindPose parent-local, jointCount of the rig: the pose in which the rig was defined
void soleStartAncestor(
    soleAncestor* ancestor, soleAncestorKind kind, const soleRig* rig, const soleTransform* bindPose );

/// What to ask of the ground. A frame that says that the character was moved by a jump begins anew, as a host would.
/// @return how many were written, at most SOLE_ANCESTOR_MAX_PROBES
int32_t soleGatherAncestor( soleAncestor* ancestor, const soleRig* rig, const soleFrame* frame, soleProbe* probes );

/// @param hits the answers to soleGatherAncestor's questions for this frame, in the same order.
void soleSolveAncestor( soleAncestor* ancestor, const soleRig* rig, const soleFrame* frame, const soleHit* hits,
    int32_t hitCount, soleOutput* output );

#endif
