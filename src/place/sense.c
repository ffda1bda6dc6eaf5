// SPDX-License-Identifier: MIT
// Sense: evaluates the animated legs, and says how high their soles are over the clip's own floor and how fast they
// move over the ground.
//
// Heights are measured over the floor that the clip was made on, not over the world's ground: they tell what the
// animator meant. Velocities are differences of positions with the root's motion in them, the vertical part taken from
// the heights, so that a root that climbs a slope does not make a standing foot look fast.
#include "place/parts.h"

static bool soleTransform_IsFinite( soleTransform t )
{
	return soleVec3_IsFinite( t.translation ) && soleQuat_IsFinite( t.rotation ) && soleVec3_IsFinite( t.scale );
}

static void soleEvaluateSlots( solePlaceWork* work )
{
	const soleRig* rig = work->rig;
	soleTransform root = soleGetNearRoot( work );
	for ( int32_t i = 0; i < rig->slotCount; ++i )
	{
		soleTransform local = soleReadPose( work->frame, work->second, rig->slotJoints[i] );
		local.rotation = soleNormalizeQuat( local.rotation );
		int32_t parent = rig->slotParents[i];
		work->slots[i] = soleMulTransform( parent == SOLE_NONE ? root : work->slots[parent], local );
	}
}

void soleTakeSlots( const solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	int32_t count = rig->def.jointCount;
	for ( int32_t i = 0; i < count; ++i )
	{
		const soleTransform* t = work->slots + rig->slots[i];
		leg->joints[i] = t->translation;
		leg->rotations[i] = t->rotation;
	}
	leg->ankleIndex = rig->def.hasVirtualAnkle ? count : count - 1;
	leg->foot = work->slots[rig->footSlot];
	leg->toeRotation = rig->toeSlot == SOLE_NONE ? soleQuat_Identity() : work->slots[rig->toeSlot].rotation;
}

soleVec3 soleGetPivot( const solePlaceWork* work, const soleLegWork* leg )
{
	int32_t toe = leg->rig->toeSlot;
	return toe == SOLE_NONE ? leg->ball : work->slots[toe].translation;
}

static void soleSenseChain( solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	int32_t count = rig->def.jointCount;
	leg->usable = true;
	for ( int32_t i = 0; i < count; ++i )
	{
		leg->usable = leg->usable && soleTransform_IsFinite( work->slots[rig->slots[i]] );
	}
	if ( rig->def.hasVirtualAnkle )
	{
		leg->joints[count] = soleTransformPoint( work->slots[rig->slots[count - 1]], rig->virtualAnkle );
	}
	leg->ankle = leg->joints[leg->ankleIndex];
	leg->length = 0.0f;
	for ( int32_t i = 1; i <= leg->ankleIndex; ++i )
	{
		leg->length += soleDistance( leg->joints[i - 1], leg->joints[i] );
	}
	leg->usable = leg->usable && soleVec3_IsFinite( leg->ankle ) && leg->length > 1e-6f && soleIsFinite( leg->length );
}

static void soleSenseFoot( solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	leg->usable = leg->usable && soleTransform_IsFinite( leg->foot );
	leg->heel = soleTransformPoint( leg->foot, rig->heel );
	// The ball stands still with the toes while the heel rises: where the foot has toes, they carry it.
	soleTransform fore = rig->toeSlot == SOLE_NONE ? leg->foot : work->slots[rig->toeSlot];
	leg->usable = leg->usable && soleTransform_IsFinite( fore );
	leg->ball = soleTransformPoint( fore, rig->foreBall );
	leg->pivot = soleGetPivot( work, leg );
	soleVec3 ahead = soleRotate( leg->foot.rotation, rig->footForward );
	soleVec3 level = soleHorizontal( work, ahead );
	if ( soleDot( level, level ) < 1e-4f )
	{
		// A foot that points straight up or down is headed where its underside or top faces.
		soleVec3 over = soleRotate( leg->foot.rotation, rig->footUp );
		level = soleHorizontal( work, soleScale( soleDot( ahead, work->up ) > 0.0f ? -1.0f : 1.0f, over ) );
	}
	leg->forward = soleNormalizeOr( level, work->level );

	leg->heelRise = soleDot( soleSub( leg->heel, work->floor ), work->rootUp );
	leg->ballRise = soleDot( soleSub( leg->ball, work->floor ), work->rootUp );
	soleVec3 inner = soleTransformPoint( fore, rig->foreInner );
	soleVec3 outer = soleTransformPoint( fore, rig->foreOuter );
	float edges = soleMinF( soleDot( inner, work->rootUp ), soleDot( outer, work->rootUp ) );
	float lowest = soleMinF( edges - soleDot( work->floor, work->rootUp ), soleMinF( leg->heelRise, leg->ballRise ) );
	float tip = soleDot( soleSub( soleTransformPoint( fore, rig->foreToe ), work->floor ), work->rootUp );
	leg->tipRise = tip;
	// Toes that are under the floor are bent; a foot without toes is raised.
	lowest = rig->toeSlot == SOLE_NONE ? soleMinF( lowest, tip ) : lowest;
	leg->sunk = soleMaxF( -lowest, 0.0f );
	float toeLength = rig->toeAhead * work->rootScale;
	leg->toeSunk = rig->toeSlot == SOLE_NONE
	    ? 0.0f
	    : soleMaxF( -tip - leg->sunk, 0.0f ) / soleMaxF( toeLength, 0.01f * leg->length );
}

/// Horizontal velocity of a sole point since the last frame, and its speed with the change of its height. In a frame
/// of no length it is as fast as it was.
static soleVec3 soleSoleVelocity(
    const solePlaceWork* work, soleVec3 now, soleVec3 before_w, float climb, float* speed )
{
	if ( work->first || !( work->timeStep > 0.0f ) )
	{
		*speed = work->first ? 0.0f : *speed;
		return soleVec( 0.0f, 0.0f, 0.0f );
	}
	float perSecond = 1.0f / work->timeStep;
	soleVec3 before = soleSub( before_w, work->root_w );
	soleVec3 step = soleScale( perSecond, soleHorizontal( work, soleSub( now, before ) ) );
	float climbSpeed = perSecond * climb;
	*speed = soleSqrtF( soleDot( step, step ) + climbSpeed * climbSpeed );
	return step;
}

void soleSenseSpeed( const solePlaceWork* work, soleLegWork* leg )
{
	if ( leg->usable )
	{
		const soleLegState* state = leg->state;
		leg->heelSpeed = state->heelSpeed;
		leg->ballSpeed = state->ballSpeed;
		leg->heelVelocity =
		    soleSoleVelocity( work, leg->heel, state->animHeel_w, leg->heelRise - state->heelRise, &leg->heelSpeed );
		leg->ballVelocity =
		    soleSoleVelocity( work, leg->ball, state->animBall_w, leg->ballRise - state->ballRise, &leg->ballSpeed );
	}
}

void soleSense( solePlaceWork* work )
{
	soleEvaluateSlots( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		soleTakeSlots( work, leg );
		soleSenseChain( work, leg );
		soleSenseFoot( work, leg );
		soleSenseSpeed( work, leg );
	}
}
