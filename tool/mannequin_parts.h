// SPDX-License-Identifier: MIT
// What the mannequin's files share: joints, measures of the foot, poses from which the legs are solved, curves.
//
// Root space everywhere: metres, y up, forward +z, left +x, floor at y = 0. In the rest pose every joint's rotation is
// identity, so a joint's model rotation is what turned it since then.
#ifndef TOOL_MANNEQUIN_PARTS_H
#define TOOL_MANNEQUIN_PARTS_H

#include "model.h"

#define TOOL_PI 3.14159265358979323846

/// Joints are nodes of the same index. The right side's follow the left side's: add tool_jointsOfSide.
enum
{
	tool_jointRoot,
	tool_jointHips,
	tool_jointSpine,
	tool_jointChest,
	tool_jointNeck,
	tool_jointHead,
	tool_jointShoulder,
	tool_jointUpperarm,
	tool_jointForearm,
	tool_jointHand,
	tool_jointThigh,
	tool_jointShin,
	tool_jointFoot,
	tool_jointToe,
	tool_jointToeTip,
	tool_jointsOfSide = tool_jointToeTip - tool_jointShoulder + 1,
	tool_jointCount = tool_jointShoulder + 2 * tool_jointsOfSide
};

/// The foot from the side, ahead of the ankle and above the floor, m.
#define TOOL_HEEL_BACK 0.055f
#define TOOL_BALL_AHEAD 0.13f
#define TOOL_TIP_AHEAD 0.20f
#define TOOL_ANKLE_HEIGHT 0.085f
#define TOOL_TOE_HEIGHT 0.028f

/// How far the arms of the rest pose point below the horizontal, rad.
#define TOOL_ARM_DROP 0.90f

/// Where a joint is in the rest pose. side 1 mirrors.
soleVec3 toolRestJoint( int32_t joint );
/// Parent-local transforms of the rest pose, tool_jointCount.
void toolRestPose( soleTransform* local );

typedef struct toolFootPose
{
	soleVec3 toe; // the toe joint
	float yaw;    // toes to the left
	float pitch;  // of the foot, toes up
	float toePitch;
} toolFootPose;

/// An arm that hangs down at zero. rad.
typedef struct toolArmPose
{
	float flexion;   // forward
	float abduction; // outward
	float inward;    // turned about its own length so that the elbow bends the hand towards the middle
	float elbow;
	float wrist;
	float shrug; // shoulder up
} toolArmPose;

/// A turn about the three axes of root space: tilt leans forward, list raises the left side, yaw goes to the left. rad.
typedef struct toolTurn
{
	float tilt;
	float list;
	float yaw;
} toolTurn;

/// All that a pose is solved from.
typedef struct toolBodyPose
{
	soleVec3 hips;   // offset from the rest pose
	toolTurn pelvis; // in root space
	toolTurn spine;  // relative to the parent, as are the next three
	toolTurn chest;
	toolTurn neck;
	toolTurn head;
	toolArmPose arms[2];
	toolFootPose feet[2];
	soleTransform root;
} toolBodyPose;

/// Local transforms of all joints: the feet exactly where asked, the legs bent to reach them.
void toolSolveBody( const toolBodyPose* body, soleTransform* local );

/// A foot that stands flat with its ankle over a point of the floor.
toolFootPose toolFlatFoot( float ankleX, float ankleZ, float yaw );

soleQuat toolAxisTurn( soleVec3 axis, float angle );

/// Value and its first two derivatives.
typedef struct toolCurvePoint
{
	double x;
	double v;
	double a;
} toolCurvePoint;

#define TOOL_CURVE_KNOTS 16

/// Quintic pieces through knots, twice continuously differentiable.
typedef struct toolCurve
{
	int32_t count;
	double t[TOOL_CURVE_KNOTS];
	toolCurvePoint knots[TOOL_CURVE_KNOTS];
} toolCurve;

/// Through points given as t, x, t, x ...; first and last give the derivatives of the ends (their x is not used).
toolCurve toolFitCurve( const double* points, int32_t count, toolCurvePoint first, toolCurvePoint last );
/// Beyond its ends the outer pieces go on.
toolCurvePoint toolEvalCurve( const toolCurve* curve, double t );
/// From 0 to 1 with no speed and no acceleration at the ends; constant outside.
double toolEase( double t );

/// Poses of the clips. phase from 0 to 1 over the clip.
void toolPoseWalk( double phase, toolBodyPose* body );
void toolPoseWalkRoot( double phase, toolBodyPose* body );
void toolPoseRun( double phase, toolBodyPose* body );
void toolPoseIdle( double phase, toolBodyPose* body );
void toolPoseTurn( double phase, toolBodyPose* body );
void toolPoseStrafe( double phase, toolBodyPose* body );
void toolPoseCrouch( double phase, toolBodyPose* body );
void toolPoseCrouchWalk( double phase, toolBodyPose* body );

enum
{
	tool_walkFrames = 64,
	tool_runFrames = 86,
	tool_idleFrames = 240,
	tool_turnFrames = 132,
	tool_strafeFrames = 60
};

/// The mesh with its materials 0 body, 1 joints, 2 soles, in root space of the rest pose. skinJoints[ joint ] is the
/// index in the skin.
toolMesh toolMakeMannequinMesh( const int32_t* skinJoints );

#endif
