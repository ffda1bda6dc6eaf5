// SPDX-License-Identifier: MIT
// Joints and sole points of a sampled motion: the product of all transforms from the root down, in double precision.
#include "measure/pose.h"

#include "base/core.h"

/// Parents before children. Ancestors that are not placed yet wait at the far end of order itself; an x scale above
/// zero marks a joint as placed until the first pose is evaluated.
static void soleOrderJoints( soleMeasurePose* pose )
{
	int32_t count = 0;
	for ( int32_t j = 0; j < pose->jointCount; ++j )
	{
		int32_t top = pose->jointCount;
		for ( int32_t p = j; p != SOLE_NONE && pose->joints[p].scale.x == 0.0; p = soleRig_GetParent( pose->rig, p ) )
		{
			pose->order[--top] = p;
		}
		for ( ; top < pose->jointCount; ++top )
		{
			pose->joints[pose->order[top]].scale.x = 1.0;
			pose->order[count++] = pose->order[top];
		}
	}
}

bool soleMakeMeasurePose( const soleRig* rig, const soleAllocator* allocator, soleMeasurePose* pose )
{
	pose->rig = rig;
	pose->jointCount = soleRig_GetJointCount( rig );
	pose->order = soleAlloc( allocator, (size_t)pose->jointCount * sizeof *pose->order );
	pose->joints = soleAlloc( allocator, (size_t)pose->jointCount * sizeof *pose->joints );
	if ( pose->order == NULL || pose->joints == NULL )
	{
		soleFreeMeasurePose( allocator, pose );
		return false;
	}
	soleOrderJoints( pose );
	return true;
}

void soleFreeMeasurePose( const soleAllocator* allocator, soleMeasurePose* pose )
{
	soleFree( allocator, pose->order, (size_t)pose->jointCount * sizeof *pose->order );
	soleFree( allocator, pose->joints, (size_t)pose->jointCount * sizeof *pose->joints );
	pose->order = NULL;
	pose->joints = NULL;
}

static void soleEvaluateBelow( soleMeasurePose* pose, const soleMotion* motion, int32_t frame, soleTransformd root )
{
	const soleTransform* local = motion->poses + (size_t)frame * (size_t)pose->jointCount;
	for ( int32_t i = 0; i < pose->jointCount; ++i )
	{
		int32_t joint = pose->order[i];
		int32_t parent = soleRig_GetParent( pose->rig, joint );
		soleTransformd above = parent == SOLE_NONE ? root : pose->joints[parent];
		pose->joints[joint] = soleMulTransformD( above, soleWidenTransform( local[joint] ) );
	}
}

void soleEvaluateCharacter( soleMeasurePose* pose, const soleMotion* motion, int32_t frame )
{
	soleEvaluateBelow( pose, motion, frame, soleWidenTransform( soleTransform_Identity() ) );
}

void soleEvaluateWorld( soleMeasurePose* pose, const soleMotion* motion, int32_t frame )
{
	soleEvaluateBelow( pose, motion, frame, soleWidenTransform( motion->roots[frame] ) );
}

soleCarriedPoint soleGetHeelPoint( const soleRig* rig, int32_t leg )
{
	soleVec3 heel = soleRig_GetLeg( rig, leg ).sole.heel;
	return (
	    soleCarriedPoint ){ soleRig_GetFootJoint( rig, leg, false ), soleRig_ToFootSpace( rig, leg, heel, false ) };
}

soleCarriedPoint soleGetBallPoint( const soleRig* rig, int32_t leg )
{
	soleVec3 ball = soleRig_GetLeg( rig, leg ).sole.ball;
	return ( soleCarriedPoint ){ soleRig_GetFootJoint( rig, leg, true ), soleRig_ToFootSpace( rig, leg, ball, true ) };
}

soleCarriedPoint soleGetTipPoint( const soleRig* rig, int32_t leg )
{
	soleVec3 tip = soleRig_GetLeg( rig, leg ).sole.toe;
	return ( soleCarriedPoint ){ soleRig_GetFootJoint( rig, leg, true ), soleRig_ToFootSpace( rig, leg, tip, true ) };
}

soleVec3d soleGetCarried( const soleMeasurePose* pose, soleCarriedPoint point )
{
	return soleTransformPointD( pose->joints[point.joint], soleWiden( point.position ) );
}

int32_t soleGetLegChain( const soleMeasurePose* pose, int32_t leg, soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1] )
{
	soleLegDef def = soleRig_GetLeg( pose->rig, leg );
	int32_t count = 0;
	for ( int32_t k = 0; k < def.jointCount; ++k )
	{
		chain[count++] = pose->joints[def.joints[k]].translation;
	}
	if ( def.hasVirtualAnkle )
	{
		soleCarriedPoint ankle = { soleRig_GetFootJoint( pose->rig, leg, false ),
			soleRig_ToFootSpace( pose->rig, leg, def.virtualAnkle, false ) };
		chain[count++] = soleGetCarried( pose, ankle );
	}
	return count;
}

soleResult soleCheckMotion( const soleMotion* motion, const char* name, soleMessage* message )
{
	if ( motion == NULL || motion->rig == NULL )
	{
		soleSetMessage( message, "%s.rig is missing: give the rig that the motion was sampled on", name );
		return sole_invalidDefinition;
	}
	if ( motion->frameCount < 1 || motion->poses == NULL || motion->roots == NULL )
	{
		soleSetMessage( message, "%s has %d frames, %s poses and %s roots: give at least one frame of both", name,
		    motion->frameCount, motion->poses == NULL ? "no" : "some", motion->roots == NULL ? "no" : "some" );
		return sole_invalidDefinition;
	}
	if ( !( motion->frameRate > 0.0f ) || soleIsFinite( motion->frameRate ) == false )
	{
		soleSetMessage(
		    message, "%s.frameRate is %g: give frames per second above zero", name, (double)motion->frameRate );
		return sole_invalidDefinition;
	}
	float length = soleLength( motion->up );
	if ( !( length > 0.99f && length < 1.01f ) )
	{
		soleSetMessage( message, "%s.up has length %g: give the unit vector out of the ground", name, (double)length );
		return sole_invalidDefinition;
	}
	if ( soleIsFinite( motion->clipFloor ) == false )
	{
		soleSetMessage( message, "%s.clipFloor is not finite: give what soleFindClipFloor() finds, or 0", name );
		return sole_invalidDefinition;
	}
	return sole_success;
}
