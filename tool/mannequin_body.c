// SPDX-License-Identifier: MIT
// From a few numbers to the local transforms of all joints of the mannequin. Root space unless a name says otherwise.
//
// The legs are solved in closed form: hip, knee and ankle make a triangle of known sides (law of cosines), its plane
// holds the direction in which the knee points, halfway between pelvis and foot.
#include "mannequin_parts.h"

#include <math.h>

/// A leg is never straighter than this share of its length; the poses leave more room, this is the last resort.
#define LARGEST_REACH 0.9995f

soleQuat toolAxisTurn( soleVec3 axis, float angle )
{
	float s = sinf( 0.5f * angle );
	soleQuat q = { s * axis.x, s * axis.y, s * axis.z, cosf( 0.5f * angle ) };
	return q;
}

static soleQuat toolTurnX( float angle )
{
	return toolAxisTurn( soleVec( 1.0f, 0.0f, 0.0f ), angle );
}

static soleQuat toolTurnY( float angle )
{
	return toolAxisTurn( soleVec( 0.0f, 1.0f, 0.0f ), angle );
}

static soleQuat toolTurnZ( float angle )
{
	return toolAxisTurn( soleVec( 0.0f, 0.0f, 1.0f ), angle );
}

static soleQuat toolTurnQuat( toolTurn turn )
{
	return soleMulQuat( toolTurnY( turn.yaw ), soleMulQuat( toolTurnZ( turn.list ), toolTurnX( turn.tilt ) ) );
}

toolFootPose toolFlatFoot( float ankleX, float ankleZ, float yaw )
{
	soleVec3 ahead = soleRotate( toolTurnY( yaw ), soleVec( 0.0f, 0.0f, TOOL_BALL_AHEAD ) );
	toolFootPose foot = { .toe = { ankleX + ahead.x, TOOL_TOE_HEIGHT, ankleZ + ahead.z }, .yaw = yaw };
	return foot;
}

/// The rotation that takes one bone direction to another and the side axis to the hinge. All unit vectors, the hinge
/// orthogonal to the bone.
static soleQuat toolAimBone( soleVec3 restBone, soleVec3 bone, soleVec3 hinge )
{
	soleQuat aim = soleFromTo( restBone, bone, soleVec( 1.0f, 0.0f, 0.0f ) );
	soleVec3 side = soleRotate( aim, soleVec( 1.0f, 0.0f, 0.0f ) );
	return soleNormalizeQuat( soleMulQuat( soleFromTo( side, hinge, bone ), aim ) );
}

static soleVec3 toolRestBone( int32_t from, int32_t to )
{
	soleVec3 bone = soleSub( toolRestJoint( to ), toolRestJoint( from ) );
	return soleNormalizeOr( bone, soleVec( 0.0f, -1.0f, 0.0f ) );
}

static void toolSolveLeg( const toolBodyPose* body, int32_t side, soleTransform pelvis, soleTransform* local )
{
	int32_t shift = side * tool_jointsOfSide;
	int32_t thigh = tool_jointThigh + shift;
	int32_t shin = tool_jointShin + shift;
	int32_t foot = tool_jointFoot + shift;
	int32_t toe = tool_jointToe + shift;
	const toolFootPose* pose = body->feet + side;

	soleQuat heading = toolTurnY( pose->yaw );
	soleQuat footRotation = soleMulQuat( heading, toolTurnX( -pose->pitch ) );
	soleQuat toeRotation = soleMulQuat( heading, toolTurnX( -pose->toePitch ) );
	soleVec3 toeToAnkle = soleSub( toolRestJoint( foot ), toolRestJoint( toe ) );
	soleVec3 ankle = soleAdd( pose->toe, soleRotate( footRotation, toeToAnkle ) );

	soleVec3 hip = soleTransformPoint( pelvis, local[thigh].translation );
	soleVec3 leg = soleSub( ankle, hip );
	soleVec3 along = soleNormalizeOr( leg, soleVec( 0.0f, -1.0f, 0.0f ) );
	float a = soleDistance( toolRestJoint( thigh ), toolRestJoint( shin ) );
	float b = soleDistance( toolRestJoint( shin ), toolRestJoint( foot ) );
	float reach = soleMinF( soleLength( leg ), LARGEST_REACH * ( a + b ) );
	soleVec3 pole = soleRotate( toolTurnY( 0.5f * ( pose->yaw + body->pelvis.yaw ) ), soleVec( 0.0f, 0.0f, 1.0f ) );
	soleVec3 hinge = soleNormalizeOr( soleCross( pole, along ), soleVec( 1.0f, 0.0f, 0.0f ) );
	soleVec3 ahead = soleCross( along, hinge );
	float c = ( a * a + reach * reach - b * b ) / ( 2.0f * a * reach );
	soleVec3 thighBone = soleMulAdd( soleScale( c, along ), soleSqrtF( 1.0f - c * c ), ahead );
	soleVec3 knee = soleMulAdd( hip, a, thighBone );
	soleVec3 shinBone = soleNormalizeOr( soleSub( soleMulAdd( hip, reach, along ), knee ), along );

	soleQuat thighRotation = toolAimBone( toolRestBone( thigh, shin ), thighBone, hinge );
	soleQuat shinRotation = toolAimBone( toolRestBone( shin, foot ), shinBone, hinge );
	local[thigh].rotation = soleMulQuat( soleConjugate( pelvis.rotation ), thighRotation );
	local[shin].rotation = soleMulQuat( soleConjugate( thighRotation ), shinRotation );
	local[foot].rotation = soleMulQuat( soleConjugate( shinRotation ), footRotation );
	local[toe].rotation = soleMulQuat( soleConjugate( footRotation ), toeRotation );
}

static void toolSetArm( const toolArmPose* arm, int32_t side, soleTransform* local )
{
	int32_t shift = side * tool_jointsOfSide;
	float mirror = side == 0 ? 1.0f : -1.0f;
	float lower = (float)( 0.5 * TOOL_PI ) - TOOL_ARM_DROP;
	soleVec3 bone = toolRestBone( tool_jointUpperarm + shift, tool_jointForearm + shift );
	// The axis that points sideways once the arm hangs.
	soleVec3 axis = soleRotate( toolTurnZ( mirror * lower ), soleVec( 1.0f, 0.0f, 0.0f ) );

	soleQuat hang = toolTurnZ( mirror * ( arm->abduction - lower ) );
	soleQuat twist = toolAxisTurn( bone, mirror * arm->inward );
	local[tool_jointShoulder + shift].rotation = toolTurnZ( mirror * arm->shrug );
	local[tool_jointUpperarm + shift].rotation = soleMulQuat( toolTurnX( -arm->flexion ), soleMulQuat( hang, twist ) );
	local[tool_jointForearm + shift].rotation = toolAxisTurn( axis, -arm->elbow );
	local[tool_jointHand + shift].rotation = toolAxisTurn( axis, -arm->wrist );
}

void toolSolveBody( const toolBodyPose* body, soleTransform* local )
{
	static const int32_t trunk[] = { tool_jointSpine, tool_jointChest, tool_jointNeck, tool_jointHead };
	const toolTurn turns[] = { body->spine, body->chest, body->neck, body->head };
	toolRestPose( local );
	local[tool_jointRoot] = body->root;
	soleTransform* pelvis = local + tool_jointHips;
	pelvis->translation = soleAdd( pelvis->translation, body->hips );
	pelvis->rotation = toolTurnQuat( body->pelvis );
	for ( int32_t i = 0; i < 4; ++i )
	{
		local[trunk[i]].rotation = toolTurnQuat( turns[i] );
	}
	for ( int32_t side = 0; side < 2; ++side )
	{
		toolSetArm( body->arms + side, side, local );
		toolSolveLeg( body, side, *pelvis, local );
	}
}
