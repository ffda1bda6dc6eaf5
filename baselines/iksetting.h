// SPDX-License-Identifier: MIT
// The foot IK of the script "IKSetting", as a walk-through of it describes it: one ray under each foot at a fixed rate,
// the ground's height over the root added to the animated height, the body to the lower foot, weights from curves that
// are authored into the clips. Same shape as soleSolve(): gather, cast, solve, apply.
//
// Lengths are the world's, angles degrees, as in the original. One state per character: start anew from the default
// where the character was moved by a jump that is no motion, for the system itself knows none.
#ifndef SOLE_BASELINES_IKSETTING_H
#define SOLE_BASELINES_IKSETTING_H

#include "baselines/baseline.h"

/// Seconds between two castings.
#define SOLE_IKSETTING_FIXED_STEP 0.02f

/// The original's parameters.
typedef struct soleIkSettingSettings
{
	bool enableFeetIk;                     // default true
	float heightFromGroundRaycast;         // start of the rays over the root. [0, 2] default 1.2
	float raycastDownDistance;             // how far they go below the root. [0, 2] default 1.5
	uint32_t environmentLayer;             // default all
	float pelvisOffset;                    // added to the ground's height. default 0
	float pelvisUpAndDownSpeed;            // share of the way that the body goes in a frame. [0, 1] default 0.28
	float feetToIkPositionSpeed;           // likewise the feet. [0, 1] default 0.5
	const char* leftFootAnimVariableName;  // curve of left feet and those in the middle. default "LeftFoot"
	const char* rightFootAnimVariableName; // curve of right feet. default "RightFoot"
	float leftFootAngleOffset;             // turns the foot about up. degrees [0, 100] default 0
	float rightFootAngleOffset;            // likewise. degrees [0, 100] default 0
	bool useIkFeature;                     // feet turn as well. default false
} soleIkSettingSettings;

/// The value of one of the clip's curves in this frame. [0, 1]
typedef struct soleIkSettingCurve
{
	const char* name;
	float value;
} soleIkSettingCurve;

/// All of them. A curve that is not among them counts as 0.
typedef struct soleIkSettingCurves
{
	const soleIkSettingCurve* curves;
	int32_t count;
} soleIkSettingCurves;

/// Memory of one foot.
typedef struct soleIkSettingFoot
{
	soleQuat bind;         // of the foot's joint at the start, character space
	soleVec3 goalPosition; // world; the zero vector says that there is no ground
	soleQuat goalRotation; // from the character as it stands at the start, world
	float lastHeight;      // over the root, in its units
} soleIkSettingFoot;

/// Memory of one character: plain data.
typedef struct soleIkSettingState
{
	float sinceFixedStep;   // s
	float lastPelvisHeight; // world, along up; 0 says that there is none
	soleShownFeet shown;
	soleIkSettingFoot feet[SOLE_MAX_LEGS];
} soleIkSettingState;

soleIkSettingSettings soleDefaultIkSettingSettings( void );
/// Brings the lengths into proportion to the character's legs, for a root of scale 1, whatever the original's ranges.
void soleFitIkSettingSettings( const soleRig* rig, soleIkSettingSettings* settings );

soleIkSettingState soleDefaultIkSettingState( const soleRig* rig );

/// One ray a leg in frames in which a fixed step falls due, else none.
int32_t soleGatherIkSetting( const soleRig* rig, const soleIkSettingSettings* settings, const soleIkSettingState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity );

/// @param hits the answers to soleGatherIkSetting's questions for this frame, in the same order.
void soleSolveIkSetting( const soleRig* rig, const soleIkSettingSettings* settings, soleIkSettingState* state,
    const soleFrame* frame, const soleIkSettingCurves* curves, const soleHit* hits, int32_t hitCount,
    soleOutput* output );

#endif
