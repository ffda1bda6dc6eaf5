// SPDX-License-Identifier: MIT
// The mannequin on the spot: standing, upright and deep, turning to the left by small steps, stepping to the left. Root
// space.
//
// Standing and turning stand in the same way at their ends, so that they can follow each other. Where a foot goes in
// the turn and in the sidestep is laid out on the floor, and taken into the moving root's space then: feet that stand
// do not move.
#include "mannequin_parts.h"

#include <math.h>

#define STAND_ASIDE 0.105f
#define STAND_AHEAD 0.006f
#define STAND_TOE_OUT 0.14f
#define STAND_DROP 0.022f
#define CROUCH_DROP 0.35f
#define STRAFE_SPEED 0.3   // m/s
#define STRAFE_WIDER 0.04f // each foot, so that they don't meet

typedef struct toolStepPlace
{
	double way;
	double height;
} toolStepPlace;

static void toolPoseStand( toolBodyPose* body )
{
	body->hips = soleVec( 0.0f, -STAND_DROP, 0.0f );
	body->pelvis.tilt = 0.03f;
	body->spine.tilt = -0.02f;
	body->neck.tilt = 0.02f;
	body->head.tilt = -0.03f;
	for ( int32_t side = 0; side < 2; ++side )
	{
		float mirror = side == 0 ? 1.0f : -1.0f;
		body->feet[side] = toolFlatFoot( mirror * STAND_ASIDE, STAND_AHEAD, mirror * STAND_TOE_OUT );
		body->arms[side] =
		    ( toolArmPose ){ .flexion = 0.02f, .abduction = 0.14f, .inward = 0.30f, .elbow = 0.28f, .wrist = 0.12f };
	}
}

/// One slow shift of the weight, two breaths, added to a stance.
static void toolAddSway( double phase, toolBodyPose* body )
{
	float shift = (float)sin( 2.0 * TOOL_PI * phase );
	float breath = (float)( 0.5 - 0.5 * cos( 4.0 * TOOL_PI * phase ) );
	body->hips = soleAdd( body->hips, soleVec( 0.016f * shift, -0.003f * shift * shift, 0.003f * breath ) );
	body->pelvis.list = 0.020f * shift;
	body->pelvis.yaw = -0.020f * shift;
	body->spine.list = -0.016f * shift;
	body->spine.yaw = 0.012f * shift;
	body->chest.tilt -= 0.022f * breath;
	body->neck.tilt += 0.010f * breath;
	body->head.tilt += 0.010f * breath;
	body->head.yaw = 0.05f * shift;
	for ( int32_t side = 0; side < 2; ++side )
	{
		body->arms[side].shrug = 0.020f * breath;
		body->arms[side].abduction -= 0.012f * breath;
		body->arms[side].elbow += 0.02f * breath;
	}
}

void toolPoseIdle( double phase, toolBodyPose* body )
{
	toolPoseStand( body );
	toolAddSway( phase, body );
}

void toolPoseCrouch( double phase, toolBodyPose* body )
{
	toolPoseStand( body );
	// Back and leaning ahead, so that the weight stays over the feet.
	body->hips = soleAdd( body->hips, soleVec( 0.0f, -CROUCH_DROP, -0.08f ) );
	body->pelvis.tilt = 0.40f;
	body->spine.tilt = 0.22f;
	body->chest.tilt = 0.14f;
	body->neck.tilt = -0.24f;
	body->head.tilt = -0.30f;
	for ( int32_t side = 0; side < 2; ++side )
	{
		body->arms[side].flexion = 0.55f;
		body->arms[side].elbow = 0.80f;
	}
	toolAddSway( phase, body );
}

/// How far a foot of the sidestep has come along the floor, of its stride, and how high it is, 0 to 1.
static toolStepPlace toolFindSidestep( double phase )
{
	const double lasts = 0.40; // of a stride
	double share = ( phase - 0.5 * ( 0.5 - lasts ) ) / lasts;
	return ( toolStepPlace ){ toolEase( share ), toolEase( 2.0 * share ) * toolEase( 2.0 - 2.0 * share ) };
}

void toolPoseStrafe( double phase, toolBodyPose* body )
{
	const double stride = STRAFE_SPEED * tool_strafeFrames / 60.0;
	toolPoseStand( body );
	float lean = (float)sin( 2.0 * TOOL_PI * phase );
	body->hips = soleAdd( body->hips, soleVec( 0.012f * lean, -0.028f, 0.0f ) );
	body->pelvis.list = 0.025f * lean;
	body->spine.list = -0.025f * lean;
	for ( int32_t side = 0; side < 2; ++side )
	{
		// The left foot steps in the first half, the right one follows in the second; both are in the middle of their
		// way when the root is.
		double own = phase - 0.5 * side;
		own -= floor( own );
		toolStepPlace step = toolFindSidestep( own );
		toolFootPose* foot = body->feet + side;
		foot->toe.x += ( side == 0 ? STRAFE_WIDER : -STRAFE_WIDER );
		foot->toe.x += (float)( stride * ( step.way - own - 0.25 ) );
		foot->toe.y += 0.045f * (float)step.height;
		foot->pitch = -0.16f * (float)step.height;
		foot->toePitch = -0.06f * (float)step.height;
	}
}

/// One step of the turn: phases of lift-off and landing, heading afterwards as a share of the whole turn.
typedef struct toolTurnStep
{
	int32_t side;
	double lift;
	double land;
	double heading;
} toolTurnStep;

static const toolTurnStep s_steps[] = {
	{ 0, 0.08, 0.28, 0.44 },
	{ 1, 0.31, 0.51, 0.66 },
	{ 0, 0.54, 0.74, 1.00 },
	{ 1, 0.75, 0.93, 1.00 },
};

typedef struct toolTurnFoot
{
	double heading; // share of the turn
	double height;  // 0 on the floor to 1
} toolTurnFoot;

static toolTurnFoot toolFindTurnFoot( int32_t side, double phase )
{
	toolTurnFoot foot = { 0 };
	for ( size_t i = 0; i < sizeof s_steps / sizeof s_steps[0]; ++i )
	{
		const toolTurnStep* step = s_steps + i;
		if ( step->side == side && phase > step->lift )
		{
			double share = ( phase - step->lift ) / ( step->land - step->lift );
			foot.heading += ( step->heading - foot.heading ) * toolEase( share );
			foot.height = toolEase( 2.0 * share ) * toolEase( 2.0 - 2.0 * share );
		}
	}
	return foot;
}

/// Weight on the left, -1 on the right foot: leaning starts before the other foot lifts.
static float toolTurnLean( double phase )
{
	static const double knots[] = { 0.0, 0.0, 0.18, -1.0, 0.41, 1.0, 0.64, -1.0, 0.84, 0.9, 1.0, 0.0 };
	const toolCurvePoint rest = { 0 };
	toolCurve curve = toolFitCurve( knots, 6, rest, rest );
	return (float)toolEvalCurve( &curve, phase ).x;
}

void toolPoseTurn( double phase, toolBodyPose* body )
{
	const float quarter = (float)( 0.5 * TOOL_PI );
	// The eyes go first, then the chest, then the body, the feet step after it.
	float turned = quarter * (float)toolEase( ( phase - 0.06 ) / 0.86 );
	float ahead = quarter * (float)toolEase( phase / 0.80 ) - turned;
	float lean = toolTurnLean( phase );
	toolPoseStand( body );
	body->root.rotation = toolAxisTurn( soleVec( 0.0f, 1.0f, 0.0f ), turned );
	body->hips = soleAdd( body->hips, soleVec( 0.050f * lean, -0.008f * lean * lean, 0.0f ) );
	body->pelvis.list = 0.045f * lean;
	body->spine.list = -0.035f * lean;
	body->chest.list = -0.015f * lean;
	body->chest.yaw = 0.4f * ahead;
	body->neck.yaw = 0.6f * ahead;
	body->head.yaw = 0.6f * ahead;
	for ( int32_t side = 0; side < 2; ++side )
	{
		float mirror = side == 0 ? 1.0f : -1.0f;
		toolTurnFoot foot = toolFindTurnFoot( side, phase );
		float heading = quarter * (float)foot.heading - turned;
		soleQuat back = toolAxisTurn( soleVec( 0.0f, 1.0f, 0.0f ), heading );
		toolFootPose* pose = body->feet + side;
		pose->toe = soleRotate( back, pose->toe );
		pose->yaw += heading;
		pose->pitch = -0.24f * (float)foot.height;
		pose->toePitch = -0.10f * (float)foot.height;
		pose->toe.y += 0.050f * (float)foot.height;
		body->arms[side].flexion += -mirror * 0.06f * lean;
		body->arms[side].abduction += 0.03f * lean * lean;
	}
}
