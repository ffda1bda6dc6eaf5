// SPDX-License-Identifier: MIT
// About which axis a knee bends: told by the bend of the bind pose, else by the clips, else square to the facing.
// Character space, bind pose. A positive turn by the right-hand rule carries the shin from straight to bent.
#include "detect_internal.h"

#include <math.h>

#define DEGREE 0.017453293f
#define POSE_LIMIT 64 // poses of clips that are looked at

/// Sine of the bend times the axis that carries the thigh's direction to the shin's.
static soleVec3 soleBendAxis( soleVec3 hip, soleVec3 knee, soleVec3 ankle )
{
	soleVec3 zero = soleVec( 0.0f, 0.0f, 0.0f );
	soleVec3 thigh =
	    soleNormalizeOr( soleScale( 1.0f / ( 1e-12f + soleDistance( hip, knee ) ), soleSub( knee, hip ) ), zero );
	soleVec3 shin =
	    soleNormalizeOr( soleScale( 1.0f / ( 1e-12f + soleDistance( knee, ankle ) ), soleSub( ankle, knee ) ), zero );
	return soleCross( thigh, shin );
}

/// A joint's place in a sample pose. False where the pose is not finite.
static bool soleSampleJoint( const soleDetect* detect, const soleTransform* pose, int32_t joint, soleTransform* world )
{
	*world = pose[joint];
	world->rotation = soleNormalizeQuat( world->rotation );
	for ( int32_t above = detect->parents[joint]; above != SOLE_NONE; above = detect->parents[above] )
	{
		soleTransform local = pose[above];
		local.rotation = soleNormalizeQuat( local.rotation );
		*world = soleMulTransform( local, *world );
	}
	return soleVec3_IsFinite( world->translation ) && soleLength( world->translation ) < 1e15f &&
	    soleQuat_IsFinite( world->rotation );
}

/// The axis about which the knee bends in the clips, carried to the bind pose; its length grows with the evidence.
static soleVec3 soleSampleHinge( const soleDetect* detect, const soleFoundLeg* leg )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	int32_t count = detect->skeleton->samplePoses != NULL ? detect->skeleton->poseCount : 0;
	if ( leg->hasVirtualAnkle || leg->jointCount < 3 )
	{
		return sum;
	}
	int32_t hip = leg->joints[leg->jointCount - 3];
	int32_t step = count > POSE_LIMIT ? count / POSE_LIMIT : 1;
	for ( int32_t i = 0; i < count; i += step )
	{
		const soleTransform* pose = detect->skeleton->samplePoses + (size_t)i * (size_t)detect->jointCount;
		soleTransform world[3];
		bool good = true;
		for ( int32_t k = 0; k < 3; ++k )
		{
			good = soleSampleJoint( detect, pose, leg->joints[leg->jointCount - 3 + k], world + k ) && good;
		}
		if ( good )
		{
			soleVec3 axis = soleBendAxis( world[0].translation, world[1].translation, world[2].translation );
			sum = soleAdd( sum, soleInvRotate( soleNormalizeQuat( world[0].rotation ), axis ) );
		}
	}
	return soleRotate( detect->rotation[hip], sum );
}

soleVec3 soleFindHinge( soleDetect* detect, int32_t index )
{
	const soleFoundLeg* leg = detect->legs + index;
	int32_t knee = leg->jointCount - ( leg->hasVirtualAnkle ? 1 : 2 );
	soleVec3 zero = soleVec( 0.0f, 0.0f, 0.0f );
	soleVec3 bend = zero;
	if ( knee >= 1 )
	{
		bend = soleBendAxis( detect->position[leg->joints[knee - 1]], detect->position[leg->joints[knee]], leg->ankle );
	}
	soleVec3 bindAxis = soleNormalizeOr( bend, zero );
	float sine = soleMinF( soleLength( bend ), 1.0f );
	float degrees = (float)atan2( (double)sine, (double)soleSqrtF( 1.0f - sine * sine ) ) / DEGREE;
	// Only two-legged walkers have knees that are known to bend about the lateral axis.
	bool biped = detect->legCount == 2 && leg->jointCount <= 3;
	float side = soleDot( bindAxis, detect->lateral );
	// A slight bend tells its axis badly: it must agree with the facing to be believed.
	float least = degrees < 10.0f ? 0.94f : 0.82f;
	if ( degrees >= 2.0f && ( biped == false || side > least || ( side < -0.82f && degrees > 12.0f ) ) )
	{
		soleAddFinding( detect, side < -0.82f && biped ? sole_warning : sole_info, index, SOLE_NONE,
		    side < -0.82f && biped ? "fine for a bird's leg; else bend the knee forward in the bind pose" : "",
		    "hinge from the bind pose: the knee is bent %.0f degrees%s", (double)degrees,
		    side < -0.82f && biped ? " backwards" : "" );
		return bindAxis;
	}
	soleVec3 sampled = soleSampleHinge( detect, leg );
	soleVec3 sampledAxis = soleNormalizeOr( sampled, zero );
	if ( soleLength( sampled ) > 0.2f && ( biped == false || soleDot( sampledAxis, detect->lateral ) > 0.82f ) )
	{
		soleAddFinding( detect, sole_info, index, SOLE_NONE, "",
		    "hinge from the clips: the bind pose has the knee straight or bent sideways (%.1f degrees)",
		    (double)degrees );
		return sampledAxis;
	}
	if ( biped && degrees >= 2.0f )
	{
		soleAddFinding( detect, sole_warning, index, SOLE_NONE, "bend the knee a little forward in the bind pose",
		    "the knee is bent %.0f degrees sideways or backwards in the bind pose: hinge taken square to the facing",
		    (double)degrees );
	}
	else
	{
		soleAddFinding( detect, sole_info, index, SOLE_NONE, "",
		    "hinge square to the facing: the knee is straight in the bind pose (%.1f degrees)", (double)degrees );
	}
	return detect->lateral;
}
