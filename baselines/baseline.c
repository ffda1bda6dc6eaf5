// SPDX-License-Identifier: MIT
// Poses in and outputs out for the baselines, world space unless a name says otherwise.
//
// Turns. A turn q that is put before a joint's world rotation Q is conj( P ) q Q in the joint's parent, P the parent's
// animated rotation. At the knee the hip's turn is in the parent already; at the ankle the parent has both. Joints
// between those of the leg are carried as they are.
//
// Hinge. A rig tells its hinge in the bind pose, and of that pose only the foot's joint. So the hinge is carried by the
// animated foot, whose flexion is about nearly the same axis; it counts only where the leg is nearly straight.
#include "baselines/baseline.h"

#include <string.h>

#define HUMAN_LEG 0.9f // hip to ankle, m

soleTransform soleGetBaselineRoot( const soleRig* rig, const soleFrame* frame )
{
	soleTransform root = frame->root;
	root.translation = soleTransformPoint( root, soleScale( frame->clipFloor, soleRig_GetUp( rig ) ) );
	root.rotation = soleNormalizeQuat( root.rotation );
	return root;
}

static soleTransform soleGetParentSpace( const soleRig* rig, const soleFrame* frame, int32_t joint )
{
	int32_t parent = soleRig_GetParent( rig, joint );
	if ( parent != SOLE_NONE )
	{
		return soleGetBaselineJoint( rig, frame, parent );
	}
	soleTransform root = frame->root;
	root.rotation = soleNormalizeQuat( root.rotation );
	return root;
}

soleTransform soleGetBaselineJoint( const soleRig* rig, const soleFrame* frame, int32_t joint )
{
	soleTransform t = frame->pose[joint];
	for ( int32_t j = soleRig_GetParent( rig, joint ); j != SOLE_NONE; j = soleRig_GetParent( rig, j ) )
	{
		t = soleMulTransform( frame->pose[j], t );
	}
	t = soleMulTransform( frame->root, t );
	t.rotation = soleNormalizeQuat( t.rotation );
	return t;
}

// --------------------------------------------------------------------------------------------------------- reading

/// Of the joints between hip and ankle the one nearest to half of the way along the bones; ties go to the lower one.
static int32_t soleFindBaselineKnee( const soleVec3* points, int32_t count )
{
	float length = 0.0f;
	for ( int32_t i = 1; i < count; ++i )
	{
		length += soleDistance( points[i - 1], points[i] );
	}
	int32_t knee = 0;
	float best = length;
	float along = 0.0f;
	for ( int32_t i = 1; i < count - 1; ++i )
	{
		along += soleDistance( points[i - 1], points[i] );
		float off = fabsf( along - 0.5f * length );
		knee = off < best ? i : knee;
		best = off < best ? off : best;
	}
	return knee;
}

soleBaselineLeg soleReadBaselineLeg( const soleRig* rig, const soleFrame* frame, int32_t leg )
{
	soleBaselineLeg read = { .def = soleRig_GetLeg( rig, leg ) };
	soleVec3 points[SOLE_MAX_LEG_JOINTS + 1];
	int32_t count = read.def.jointCount;
	soleTransform last = soleTransform_Identity();
	for ( int32_t i = 0; i < count; ++i )
	{
		last = soleGetBaselineJoint( rig, frame, read.def.joints[i] );
		points[i] = last.translation;
	}
	read.foot_w = soleGetBaselineJoint( rig, frame, soleRig_GetFootJoint( rig, leg, false ) );
	if ( read.def.hasVirtualAnkle )
	{
		// Fixed to the last joint, which carries the sole; a detached foot stands in the ankle itself.
		bool detached = read.def.detachedFoot != SOLE_NONE;
		soleVec3 fixed = soleRig_ToFootSpace( rig, leg, read.def.virtualAnkle, false );
		points[count++] = detached ? read.foot_w.translation : soleTransformPoint( last, fixed );
	}
	read.kneeIndex = soleFindBaselineKnee( points, count );
	read.hip_w = points[0];
	read.knee_w = points[read.kneeIndex];
	read.ankle_w = points[count - 1];
	read.hinge_w = soleRotate( read.foot_w.rotation, soleGetBaselineFootAxis( rig, leg, read.def.hinge ) );
	read.length = soleDistance( read.hip_w, read.knee_w ) + soleDistance( read.knee_w, read.ankle_w );
	return read;
}

soleVec3 soleGetBaselineUp( const soleRig* rig, const soleFrame* frame )
{
	soleQuat root = soleNormalizeQuat( frame->root.rotation );
	return soleNormalizeOr( frame->up, soleRotate( root, soleRig_GetUp( rig ) ) );
}

float soleGetBaselineWeight( const soleFrame* frame, int32_t leg )
{
	float weight = soleClampF( frame->weight, 0.0f, 1.0f );
	bool own = leg != SOLE_NONE && frame->legWeight != NULL;
	return own ? weight * soleClampF( frame->legWeight[leg], 0.0f, 1.0f ) : weight;
}

float soleGetBaselineTimeStep( const soleFrame* frame )
{
	return soleIsFinite( frame->timeStep ) && frame->timeStep > 0.0f ? frame->timeStep : 0.0f;
}

// ------------------------------------------------------------------------------------------------------- bind pose

soleVec3 soleGetBaselineFootAxis( const soleRig* rig, int32_t leg, soleVec3 direction )
{
	// From the ball, not from the origin: a character may stand far from there.
	soleVec3 ball = soleRig_GetLeg( rig, leg ).sole.ball;
	soleVec3 from = soleRig_ToFootSpace( rig, leg, ball, false );
	soleVec3 to = soleRig_ToFootSpace( rig, leg, soleAdd( ball, direction ), false );
	return soleNormalizeOr( soleSub( to, from ), direction );
}

bool soleIsRightBaselineLeg( const soleRig* rig, int32_t leg )
{
	return soleRig_GetLeg( rig, leg ).side == sole_right;
}

float soleGetBaselineSize( const soleRig* rig )
{
	return soleRig_GetLegLength( rig, 0 ) / HUMAN_LEG;
}

float soleGetBaselineAnkleHeight( const soleRig* rig, int32_t leg )
{
	// The joint is the origin of its own space; a unit of that space is as long as one of the character's divided by
	// the joint's scale.
	soleVec3 ball = soleRig_GetLeg( rig, leg ).sole.ball;
	soleVec3 ball_l = soleRig_ToFootSpace( rig, leg, ball, false );
	soleVec3 up_l = soleSub( soleRig_ToFootSpace( rig, leg, soleAdd( ball, soleRig_GetUp( rig ) ), false ), ball_l );
	float squared = soleDot( up_l, up_l );
	return squared > 0.0f ? -soleDot( ball_l, up_l ) / squared : 0.0f;
}

float soleGetBaselineSoleLength( const soleRig* rig, int32_t leg )
{
	soleSolePoints sole = soleRig_GetLeg( rig, leg ).sole;
	return soleDistance( sole.heel, sole.toe );
}

// ----------------------------------------------------------------------------------------------------- shown feet

soleBaselineGoal soleGetShownFoot( const soleRig* rig, const soleFrame* frame, const soleShownFeet* shown, int32_t leg )
{
	if ( shown->known == false )
	{
		soleBaselineLeg animated = soleReadBaselineLeg( rig, frame, leg );
		return ( soleBaselineGoal ){ .ankle_w = animated.ankle_w, .foot_w = animated.foot_w.rotation };
	}
	soleQuat root = soleNormalizeQuat( frame->root.rotation );
	return ( soleBaselineGoal ){
		.ankle_w = soleTransformPoint( frame->root, shown->ankles[leg] ),
		.foot_w = soleMulQuat( root, shown->feet[leg] ),
	};
}

void soleKeepShownFoot( const soleFrame* frame, const soleBaselineGoal* foot, int32_t leg, soleShownFeet* shown )
{
	soleQuat root = soleNormalizeQuat( frame->root.rotation );
	shown->known = true;
	shown->ankles[leg] = soleInvTransformPoint( frame->root, foot->ankle_w );
	shown->feet[leg] = soleNormalizeQuat( soleMulQuat( soleConjugate( root ), foot->foot_w ) );
}

// --------------------------------------------------------------------------------------------------------- writing

void soleStartBaselineOutput( const soleRig* rig, const soleFrame* frame, soleOutput* output )
{
	memset( output, 0, sizeof *output );
	output->legCount = soleRig_GetLegCount( rig );
	output->pelvisTranslation_l = frame->pose[soleRig_GetPelvis( rig )].translation;
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		soleLegDef leg = soleRig_GetLeg( rig, i );
		soleLegOutput* out = output->legs + i;
		for ( int32_t j = 0; j < SOLE_MAX_LEG_JOINTS; ++j )
		{
			out->rotations_l[j] = j < leg.jointCount ? frame->pose[leg.joints[j]].rotation : soleQuat_Identity();
		}
		out->toeRotation_l = leg.toeCount > 0 ? frame->pose[leg.toes[0]].rotation : soleQuat_Identity();
		bool detached = leg.detachedFoot != SOLE_NONE;
		out->footTranslation_l = detached ? frame->pose[leg.detachedFoot].translation : out->footTranslation_l;
		out->footRotation_l = detached ? frame->pose[leg.detachedFoot].rotation : soleQuat_Identity();
		out->stretch = 1.0f;
	}
}

soleTwoBoneDef soleMakeBaselineTwoBone( const soleBaselineLeg* leg, const soleBaselineGoal* goal )
{
	return ( soleTwoBoneDef ){
		.hip = soleAdd( leg->hip_w, goal->pelvisOffset_w ),
		.knee = soleAdd( leg->knee_w, goal->pelvisOffset_w ),
		.ankle = soleAdd( leg->ankle_w, goal->pelvisOffset_w ),
		.target = goal->ankle_w,
		.hinge = leg->hinge_w,
		.reach = 1.0f,
	};
}

/// A joint's new parent-local rotation: what it has in the world, seen from a parent that has turned.
static soleQuat soleSeeFromParent(
    const soleRig* rig, const soleFrame* frame, int32_t joint, soleQuat parentTurn, soleQuat rotation_w )
{
	soleQuat parent = soleMulQuat( parentTurn, soleGetParentSpace( rig, frame, joint ).rotation );
	return soleNormalizeQuat( soleMulQuat( soleConjugate( parent ), rotation_w ) );
}

static bool soleIsBelowPelvis( const soleRig* rig, int32_t joint )
{
	int32_t j = soleRig_GetParent( rig, joint );
	while ( j != SOLE_NONE && j != soleRig_GetPelvis( rig ) )
	{
		j = soleRig_GetParent( rig, j );
	}
	return j != SOLE_NONE;
}

/// The foot keeps its place against the ankle, in its own frame.
static void soleWriteDetachedFoot( const soleRig* rig, const soleFrame* frame, const soleBaselineLeg* leg,
    const soleBaselineGoal* foot, soleLegOutput* output )
{
	int32_t joint = leg->def.detachedFoot;
	soleVec3 arm = soleInvRotate( leg->foot_w.rotation, soleSub( leg->foot_w.translation, leg->ankle_w ) );
	soleVec3 place = soleAdd( foot->ankle_w, soleRotate( foot->foot_w, arm ) );
	soleTransform parent = soleGetParentSpace( rig, frame, joint );
	soleVec3 moved = soleIsBelowPelvis( rig, joint ) ? foot->pelvisOffset_w : soleVec( 0.0f, 0.0f, 0.0f );
	parent.translation = soleAdd( parent.translation, moved );
	output->footTranslation_l = soleInvTransformPoint( parent, place );
	output->footRotation_l = soleSeeFromParent( rig, frame, joint, soleQuat_Identity(), foot->foot_w );
}

soleBaselineGoal soleWriteBaselineLeg( const soleRig* rig, const soleFrame* frame, const soleBaselineLeg* leg,
    const soleBaselineGoal* goal, const soleTwoBoneResult* bent, soleLegOutput* output )
{
	const soleLegDef* def = &leg->def;
	int32_t hip = def->joints[0];
	int32_t knee = def->joints[leg->kneeIndex];
	int32_t last = def->joints[def->jointCount - 1];
	soleQuat legTurn = soleMulQuat( bent->hip, bent->knee );
	soleQuat thigh = soleMulQuat( bent->hip, soleGetBaselineJoint( rig, frame, hip ).rotation );
	output->rotations_l[0] = soleSeeFromParent( rig, frame, hip, soleQuat_Identity(), thigh );
	if ( leg->kneeIndex > 0 )
	{
		soleQuat shin = soleMulQuat( legTurn, soleGetBaselineJoint( rig, frame, knee ).rotation );
		output->rotations_l[leg->kneeIndex] = soleSeeFromParent( rig, frame, knee, bent->hip, shin );
	}
	soleBaselineGoal foot = *goal;
	foot.ankle_w = bent->ankle;
	if ( def->detachedFoot != SOLE_NONE )
	{
		soleWriteDetachedFoot( rig, frame, leg, &foot, output );
	}
	else if ( def->hasVirtualAnkle == false )
	{
		output->rotations_l[def->jointCount - 1] = soleSeeFromParent( rig, frame, last, legTurn, goal->foot_w );
	}
	else
	{
		foot.foot_w = soleMulQuat( legTurn, leg->foot_w.rotation ); // part of the shin
	}
	soleVec3 hip_w = soleAdd( leg->hip_w, goal->pelvisOffset_w );
	output->flags |= bent->flags;
	output->ankleTarget_w = goal->ankle_w;
	output->ankle_w = bent->ankle;
	output->error = soleDistance( bent->ankle, goal->ankle_w );
	output->extension = leg->length > 0.0f ? soleDistance( hip_w, bent->ankle ) / leg->length : 0.0f;
	return foot;
}

soleBaselineGoal solePlaceBaselineLeg( const soleRig* rig, const soleFrame* frame, const soleBaselineLeg* leg,
    const soleBaselineGoal* goal, soleLegOutput* output )
{
	soleTwoBoneDef def = soleMakeBaselineTwoBone( leg, goal );
	soleTwoBoneResult bent = soleSolveTwoBone( &def );
	return soleWriteBaselineLeg( rig, frame, leg, goal, &bent, output );
}

void soleWriteBaselineGround(
    const soleRig* rig, const soleFrame* frame, const soleHit* hitOrNull, soleLegOutput* output )
{
	if ( hitOrNull == NULL || hitOrNull->hit == false )
	{
		output->flags |= (uint32_t)sole_legNoGround;
		return;
	}
	soleVec3 up = soleGetBaselineUp( rig, frame );
	output->planePoint_w = hitOrNull->point_w;
	output->planeNormal_w = hitOrNull->normal_w;
	soleVec3 floor_w = soleGetBaselineRoot( rig, frame ).translation;
	output->heightDemand = soleDot( soleSub( hitOrNull->point_w, floor_w ), up );
	output->confidence = 1.0f;
}

void soleWriteBaselinePelvis( const soleRig* rig, const soleFrame* frame, soleVec3 pelvisOffset_w, soleOutput* output )
{
	output->pelvisOffset_w = pelvisOffset_w;
	soleTransform parent = soleGetParentSpace( rig, frame, soleRig_GetPelvis( rig ) );
	// Added to what the animation has, so that no offset leaves it as it is, to the bit.
	parent.translation = soleVec( 0.0f, 0.0f, 0.0f );
	soleVec3 offset_l = soleInvTransformPoint( parent, pelvisOffset_w );
	output->pelvisTranslation_l = soleAdd( output->pelvisTranslation_l, offset_l );
}
