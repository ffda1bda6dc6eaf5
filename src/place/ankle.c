// SPDX-License-Identifier: MIT
// Ankle: what the foot may do against the shin, the toes, and the output.
//
// Range of motion. q is the foot's turn against the shin beyond neutral, in the foot's axes. It is taken apart, without
// trigonometry, into pitch about the side axis, roll about the forward axis, a small rest, and twist about the up axis;
// the halves of pitch, roll and twist are clamped, and the parts put together again. Each limit is widened to what the
// animation does itself. What the ankle cannot do becomes a new target: the foot stands on whatever part of its sole is
// lowest then, at the height that was wanted of the lowest part, and keeps the place of its heel while it stands on
// that, of its ball else. Shins sway over feet that stand, and a foot at its limit would rock along: so while all
// stand, what the limits turn a foot by stays as it is while it is right within PLAY, as in a worn joint.
//
// Toes. They go where the animated toes go on the plane (so they stay flat while the heel is raised), plus the slope of
// the ground in front of the ball, as far as their limits let them; up at once, for the ground pushes them, and down
// with the foot's contact. Toes that the clip has under its floor are bent up to it.
#include "place/parts.h"
#include "place/stance.h"

#define ON_TIP 0.2f // sine of the angle from which on toes stand on their tip
#define PLAY 0.024f // 2.8 degrees, sine of half the angle, about each of the foot's axes and to either side

typedef struct soleAnkleTurn
{
	soleHalf pitch, roll, twist;
	soleQuat rest;
} soleAnkleTurn;

static soleAnkleTurn soleTakeApart( const soleRigLeg* rig, soleQuat shin, soleQuat foot )
{
	soleQuat neutral = soleMulQuat( shin, rig->neutral );
	soleQuat q = soleMulQuat( soleConjugate( neutral ), foot );
	// In the foot's own frame at neutral, whose axes are those of the bind pose.
	soleQuat twist = soleTwist( q, rig->footUp );
	soleQuat q1 = soleMulQuat( q, soleConjugate( twist ) );
	soleQuat pitch = soleTwist( q1, rig->footSide );
	soleQuat r = soleMulQuat( soleConjugate( pitch ), q1 );
	soleQuat roll = soleTwist( r, rig->footForward );
	return ( soleAnkleTurn ){
		soleTwistHalf( pitch, rig->footSide ),
		soleTwistHalf( roll, rig->footForward ),
		soleTwistHalf( twist, rig->footUp ),
		soleMulQuat( soleConjugate( roll ), r ),
	};
}

static soleQuat solePutTogether( const soleRigLeg* rig, soleQuat shin, soleAnkleTurn turn )
{
	soleQuat q =
	    soleMulQuat( soleHalfRotation( rig->footSide, turn.pitch ), soleHalfRotation( rig->footForward, turn.roll ) );
	q = soleMulQuat( q, turn.rest );
	q = soleMulQuat( q, soleHalfRotation( rig->footUp, turn.twist ) );
	return soleNormalizeQuat( soleMulQuat( soleMulQuat( shin, rig->neutral ), q ) );
}

/// Clamps a half angle into a range that is widened to the animated one. @return whether it was outside
static bool soleClampHalf( soleHalf* half, soleRange range, soleHalf animated )
{
	soleHalf low = animated.s < range.low.s ? animated : range.low;
	soleHalf high = animated.s > range.high.s ? animated : range.high;
	if ( half->s < low.s - 1e-6f )
	{
		*half = low;
		return true;
	}
	if ( half->s > high.s + 1e-6f )
	{
		*half = high;
		return true;
	}
	return false;
}

/// Is a turn within the rig's own limits? Then it is within those that the animation widens.
static bool soleIsWithin( const soleRigLeg* rig, const soleAnkleTurn* turn )
{
	const soleRange ranges[] = { rig->pitch, rig->roll, rig->twist };
	const float sines[] = { turn->pitch.s, turn->roll.s, turn->twist.s };
	bool within = true;
	for ( int32_t i = 0; i < 3; ++i )
	{
		within = within && sines[i] >= ranges[i].low.s && sines[i] <= ranges[i].high.s;
	}
	return within;
}

static soleQuat soleShinRotation( const soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	int32_t shin = rig->def.hasVirtualAnkle ? rig->def.jointCount - 1 : rig->def.jointCount - 2;
	soleQuat turn = shin >= rig->kneeIndex ? soleMulQuat( leg->hipTurn, leg->kneeTurn ) : leg->hipTurn;
	return soleMulQuat( turn, leg->rotations[shin] );
}

/// A foot that is turned by an ankle of its own: not one that is part of the shin.
static bool soleHasAnkle( const soleRigLeg* rig )
{
	return rig->def.hasVirtualAnkle == false || rig->def.detachedFoot != SOLE_NONE;
}

// ------------------------------------------------------------------------------------------------------------- toes

/// The toes of a foot that is turned like this, world.
static soleQuat soleBendToe( const solePlaceWork* work, const soleLegWork* leg, soleQuat footRotation )
{
	const soleRigLeg* rig = leg->rig;
	// The toe as the foot carries it, and as the ground wants it.
	soleQuat local = soleMulQuat( soleConjugate( leg->foot.rotation ), leg->toeRotation );
	soleQuat carried = soleMulQuat( footRotation, local );
	soleVec3 side = soleRotate( footRotation, rig->footSide );
	soleHalf slope = soleMakeHalf( 1.0f, leg->toeSlope + leg->toeSunk );
	soleQuat wanted = soleMulQuat( soleHalfRotation( side, slope ), soleMulQuat( leg->image, leg->toeRotation ) );
	soleHalf bend = soleTwistHalf( soleTwist( soleMulQuat( wanted, soleConjugate( carried ) ), side ), side );
	soleHalf up = work->angles.toesUp;
	soleHalf down = work->angles.toesDown;
	bend = bend.s > up.s ? up : ( bend.s < down.s ? down : bend );
	float share = leg->turnWeight * ( bend.s > 0.0f ? 1.0f : leg->state->plantWeight );
	soleQuat bent = soleMulQuat( soleHalfRotation( side, bend ), carried );
	return soleNlerp( carried, bent, share );
}

// ------------------------------------------------------------------------------------------------- range of motion

/// The heel as seen from the pivot, of a foot that is turned like this.
static soleVec3 soleHeelArm( const soleLegWork* leg, soleQuat foot )
{
	return soleRotate( foot, soleMul( leg->foot.scale, soleSub( leg->rig->heel, leg->rig->pivot ) ) );
}

/// The toe tip as seen from there.
static soleVec3 soleTipArm( const solePlaceWork* work, const soleLegWork* leg, soleQuat foot )
{
	const soleRigLeg* rig = leg->rig;
	bool bends = rig->toeSlot != SOLE_NONE;
	soleVec3 tip = bends ? rig->foreToe : soleSub( rig->toe, rig->pivot );
	return soleRotate( bends ? soleBendToe( work, leg, foot ) : foot, soleMul( leg->foot.scale, tip ) );
}

/// Height, over the pivot and along a normal, of the lowest point of a sole that is turned like this, its toes bent as
/// they will be.
static float soleLowestPoint( const solePlaceWork* work, const soleLegWork* leg, soleQuat foot, soleVec3 normal )
{
	const soleRigLeg* rig = leg->rig;
	float heel = soleDot( soleHeelArm( leg, foot ), normal );
	bool bends = rig->toeSlot != SOLE_NONE;
	soleQuat fore = bends ? soleBendToe( work, leg, foot ) : foot;
	soleVec3 from = bends ? soleVec( 0.0f, 0.0f, 0.0f ) : rig->pivot;
	const soleVec3 points[] = { rig->foreInner, rig->foreOuter, rig->foreBall, rig->toe };
	float lowest = heel;
	for ( int32_t i = 0; i < ( bends ? 3 : 4 ); ++i )
	{
		soleVec3 arm = soleRotate( fore, soleMul( leg->foot.scale, soleSub( points[i], from ) ) );
		lowest = soleMinF( lowest, soleDot( arm, normal ) );
	}
	return lowest;
}

/// Does a foot stand on its heel, 0 to 1? One that is held says so itself.
static float soleStandsOnHeel( const soleLegWork* leg )
{
	if ( ( leg->state->flags & sole_stateLocked ) != 0 )
	{
		return ( leg->state->flags & sole_stateByHeel ) != 0 ? 1.0f : 0.0f;
	}
	return soleIsOnHeel( leg, SOLE_ON_HEEL );
}

/// Sets the targets of a foot that was turned from `wanted` to `turned`: its lowest point stays as high as it was
/// wanted; along the ground its pivot stays where it was, or its heel if it stands on that.
static void soleRetarget( const solePlaceWork* work, soleLegWork* leg, soleQuat wanted, soleQuat turned )
{
	soleVec3 arm = soleInvRotate( wanted, soleSub( leg->ankleGoal, leg->pivotTarget ) );
	soleVec3 normal = leg->out->planeNormal_w;
	float raise = soleLowestPoint( work, leg, wanted, normal ) - soleLowestPoint( work, leg, turned, normal );
	soleVec3 back = soleSub( soleHeelArm( leg, wanted ), soleHeelArm( leg, turned ) );
	back = soleScale( soleStandsOnHeel( leg ), back );
	float tiptoe = soleSmoothly( soleSaturate( soleFindTiptoe( work, leg ) / ON_TIP ) ) * leg->state->plantWeight;
	if ( tiptoe > 0.0f )
	{
		soleVec3 tip = soleSub( soleTipArm( work, leg, wanted ), soleTipArm( work, leg, turned ) );
		back = soleMulAdd( back, tiptoe, tip );
	}
	back = soleMulAdd( back, -soleDot( back, normal ), normal );
	leg->pivotTarget = soleMulAdd( soleAdd( leg->pivotTarget, back ), raise, normal );
	leg->ankleTarget = soleAdd( leg->pivotTarget, soleRotate( turned, arm ) );
	leg->footTarget = turned;
}

static float soleStepPlay( float kept, float right, float play )
{
	return soleClampF( kept, right - play, right + play );
}

/// Keeps what the limits turn a foot by, in its own axes, as long as that is right or nearly so.
/// @param right what they turn it by now
/// @return what it is turned by, sines of half angles
static soleVec3 soleKeepLimit( const solePlaceWork* work, soleLegWork* leg, soleVec3 right )
{
	soleVec3* kept = &leg->state->limitTurn;
	float play = PLAY * soleSmoothly( work->state->standing );
	kept->x = soleStepPlay( kept->x, right.x, play );
	kept->y = soleStepPlay( kept->y, right.y, play );
	kept->z = soleStepPlay( kept->z, right.z, play );
	return *kept;
}

/// What turns one rotation into another, in its own axes.
static soleVec3 soleTurnBetween( soleQuat from, soleQuat to )
{
	soleQuat turn = soleMulQuat( soleConjugate( from ), to );
	return soleScale( turn.w < 0.0f ? -1.0f : 1.0f, soleVec( turn.x, turn.y, turn.z ) );
}

static soleQuat soleTurnBy( soleQuat from, soleVec3 turn )
{
	float w = soleSqrtF( soleMaxF( 1.0f - soleDot( turn, turn ), 0.0f ) );
	return soleNormalizeQuat( soleMulQuat( from, ( soleQuat ){ turn.x, turn.y, turn.z, w } ) );
}

/// Clamps a foot's turn against the shin. @return whether it was outside
static bool soleClampTurn( const soleLegWork* leg, soleAnkleTurn* turn )
{
	const soleRigLeg* rig = leg->rig;
	int32_t shin = rig->def.hasVirtualAnkle ? rig->def.jointCount - 1 : rig->def.jointCount - 2;
	soleAnkleTurn animated = soleTakeApart( rig, leg->rotations[shin], leg->foot.rotation );
	bool clamped = soleClampHalf( &turn->pitch, rig->pitch, animated.pitch );
	clamped = soleClampHalf( &turn->roll, rig->roll, animated.roll ) || clamped;
	return soleClampHalf( &turn->twist, rig->twist, animated.twist ) || clamped;
}

void soleLimitAnkle( const solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	if ( !( leg->weight > 0.0f ) || !soleHasAnkle( rig ) )
	{
		return;
	}
	soleQuat shin = soleShinRotation( leg );
	soleAnkleTurn turn = soleTakeApart( rig, shin, leg->footReached );
	soleQuat limited = leg->footReached;
	soleVec3 right = soleVec( 0.0f, 0.0f, 0.0f );
	if ( soleIsWithin( rig, &turn ) == false && soleClampTurn( leg, &turn ) )
	{
		limited = solePutTogether( rig, shin, turn );
		right = soleTurnBetween( leg->footReached, limited );
		leg->limited = true;
	}
	soleVec3 kept = soleKeepLimit( work, leg, right );
	if ( kept.x != right.x || kept.y != right.y || kept.z != right.z )
	{
		limited = soleTurnBy( leg->footReached, kept );
		leg->limited = true;
	}
	if ( leg->limited )
	{
		soleRetarget( work, leg, leg->footReached, limited );
		leg->out->flags |= (uint32_t)sole_legAnkleClamped;
	}
}

// ----------------------------------------------------------------------------------------------------------- output

soleQuat soleParentRotation( const solePlaceWork* work, int32_t slot )
{
	int32_t parent = work->rig->slotParents[slot];
	return parent == SOLE_NONE ? soleNormalizeQuat( work->frame->root.rotation ) : work->slots[parent].rotation;
}

static void soleWriteDetachedFoot( const solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	// The foot goes along with the ankle: same place in the foot's frame as animated.
	soleVec3 arm = soleInvRotate( leg->foot.rotation, soleSub( leg->foot.translation, leg->ankle ) );
	soleVec3 place = soleAdd( leg->ankleReached, soleRotate( leg->footReached, arm ) );
	int32_t parent = work->rig->slotParents[rig->footSlot];
	soleTransform space = parent == SOLE_NONE ? soleGetNearRoot( work ) : work->slots[parent];
	if ( rig->footBelowPelvis )
	{
		space.translation = soleMulAdd( space.translation, work->pelvisShift, work->up );
	}
	leg->out->footTranslation_l = soleInvTransformPoint( space, place );
	leg->out->footRotation_l = soleNormalizeQuat( soleMulQuat( soleConjugate( space.rotation ), leg->footReached ) );
}

void soleAlignAnkle( const solePlaceWork* work, soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	int32_t last = rig->def.jointCount - 1;
	soleLegOutput* out = leg->out;
	// Joints between hip and knee, and knee and ankle, are carried as they are: their local rotations stay. A turn
	// q before a world rotation Q is conj( parent ) q Q in the parent's space; at the knee the hip's turn is in the
	// parent already.
	out->rotations_l[0] = soleNormalizeQuat( soleMulQuat(
	    soleConjugate( soleParentRotation( work, rig->slots[0] ) ), soleMulQuat( leg->hipTurn, leg->rotations[0] ) ) );
	int32_t knee = rig->kneeIndex;
	if ( knee > 0 )
	{
		soleQuat parent = soleParentRotation( work, rig->slots[knee] );
		out->rotations_l[knee] = soleNormalizeQuat(
		    soleMulQuat( soleConjugate( parent ), soleMulQuat( leg->kneeTurn, leg->rotations[knee] ) ) );
	}
	if ( rig->def.hasVirtualAnkle == false )
	{
		soleQuat turn = last > knee && knee > 0 ? soleMulQuat( leg->hipTurn, leg->kneeTurn ) : leg->hipTurn;
		soleQuat parent = soleMulQuat( turn, soleParentRotation( work, rig->slots[last] ) );
		// A detached foot is turned itself; the ankle's joint then keeps its animated turn.
		out->rotations_l[last] = rig->def.detachedFoot != SOLE_NONE
		    ? out->rotations_l[last]
		    : soleNormalizeQuat( soleMulQuat( soleConjugate( parent ), leg->footReached ) );
	}
	if ( rig->def.detachedFoot != SOLE_NONE )
	{
		soleWriteDetachedFoot( work, leg );
	}
	if ( rig->toeSlot != SOLE_NONE && soleHasAnkle( rig ) )
	{
		// Joints between foot and toe keep their turns: the new toe is expressed in its own parent.
		soleQuat foot = soleMulQuat( soleConjugate( leg->foot.rotation ), soleParentRotation( work, rig->toeSlot ) );
		soleQuat toe = soleBendToe( work, leg, leg->footReached );
		toe = soleMulQuat( soleConjugate( leg->footReached ), toe );
		out->toeRotation_l = soleNormalizeQuat( soleMulQuat( soleConjugate( foot ), toe ) );
	}
}
