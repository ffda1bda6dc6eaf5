// SPDX-License-Identifier: MIT
// Contact: which part of a foot is on the ground, and where a planted foot is held.
//
// Heel and toe are told apart, by the host's labels where there are any, else by speed and height over the clip's floor
// with hysteresis in both. A foot in contact is held by one point of its sole, the anchor: the heel from heel strike
// on, the ball from the moment the toe is down. The point is held where the foot was, not where the animation is.
//   free:    anchor's place = animated place + slide        slide decays to 0: the way back to the animation
//   locked:  anchor's place = lockPoint + slide             slide decays to 0: what was left of the foot's motion
// At each change lockPoint and slide are set so that place and velocity go on unbroken; nothing is low-passed, so a
// locked foot has no lag and stands still to the bit once slide has died away. Headings are treated alike.
// Contact begins and ends between frames: when, is interpolated, so that a slow frame rate holds the foot at the same
// place as a fast one.
#include "place/place.h"

#define SETTLED 1e3f // s: longer than any setting

/// What decides whether a part of the foot is down.
typedef struct soleContactLimits
{
	float speedOn, speedOff, heightOn, heightOff;
} soleContactLimits;

static bool soleHold( bool on, float speed, float rise, const soleContactLimits* l )
{
	return on ? speed <= l->speedOff && rise <= l->heightOff : speed < l->speedOn && rise < l->heightOn;
}

/// How long ago a value that is past its limit now crossed it, as a share of the frame. 1: it was past it already.
static float soleCrossed( float before, float now, float limit )
{
	float way = now - before;
	float left = now - limit;
	return left * way > 0.0f && left * left < way * way ? left / way : 1.0f;
}

/// How long before the end of the frame a part of the foot came down or left, s. Speeds are differences over a frame:
/// they belong to its middle.
static float soleSince(
    const solePlaceWork* work, bool on, float speed0, float speed, float rise0, float rise, const soleContactLimits* l )
{
	float bySpeed = soleCrossed( speed0, speed, on ? l->speedOn : l->speedOff ) + 0.5f;
	float byRise = soleCrossed( rise0, rise, on ? l->heightOn : l->heightOff );
	bool fast = speed > l->speedOff;
	bool high = rise > l->heightOff;
	if ( on )
	{
		// Both had to be met: the later one decided.
		return soleMinF( bySpeed, byRise ) * work->timeStep;
	}
	// One was enough: the earlier one decided.
	return ( fast && high ? soleMaxF( bySpeed, byRise ) : ( fast ? bySpeed : byRise ) ) * work->timeStep;
}

static void soleSenseContact( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool heelWas = ( state->flags & sole_stateHeelOn ) != 0;
	bool toeWas = ( state->flags & sole_stateToeOn ) != 0;
	bool heelOn = heelWas;
	bool toeOn = toeWas;
	const soleSettings* s = work->settings;
	soleContactLimits limits = { soleMaxF( s->contact.speedOn * leg->length, 0.1f * work->rootSpeed ),
		soleMaxF( s->contact.speedOff * leg->length, 0.2f * work->rootSpeed ), s->contact.heightOn * leg->length,
		s->contact.heightOff * leg->length };
	if ( work->timeStep > 0.0f || work->first )
	{
		heelOn = soleHold( heelOn, leg->heelSpeed, leg->heelRise, &limits );
		toeOn = soleHold( toeOn, leg->ballSpeed, leg->ballRise, &limits );
	}
	heelOn = leg->contactInput.heel >= 0.0f ? leg->contactInput.heel >= 0.5f : heelOn;
	toeOn = leg->contactInput.toe >= 0.0f ? leg->contactInput.toe >= 0.5f : toeOn;
	// What the host says counts at once; what only looks like contact has to last.
	bool told = leg->contactInput.heel >= 0.0f || leg->contactInput.toe >= 0.0f;
	float heelSince =
	    soleSince( work, heelOn, state->heelSpeed, leg->heelSpeed, state->heelRise, leg->heelRise, &limits );
	float toeSince =
	    soleSince( work, toeOn, state->ballSpeed, leg->ballSpeed, state->ballRise, leg->ballRise, &limits );
	bool was = heelWas || toeWas;
	bool on = heelOn || toeOn;
	// The foot comes down with its first part, and leaves with its last.
	float since = on ? soleMaxF( heelOn ? heelSince : 0.0f, toeOn ? toeSince : 0.0f )
	                 : soleMinF( heelWas ? heelSince : SETTLED, toeWas ? toeSince : SETTLED );
	leg->since = told || work->first || on == was ? 0.0f : since;
	leg->letGoSpeed = told ? 0.0f : limits.speedOff;
	leg->touches = on;
	leg->touched = was;
	// On the first frame speeds are not known: what stands still then is held a little later.
	float lasted = was ? state->contactTime + work->timeStep : leg->since;
	state->contactTime = on ? ( told ? SETTLED : lasted ) : 0.0f;
	state->flags &= ~(uint32_t)( sole_stateHeelOn | sole_stateToeOn );
	state->flags |= heelOn ? (uint32_t)sole_stateHeelOn : 0u;
	state->flags |= toeOn ? (uint32_t)sole_stateToeOn : 0u;
}

/// The turn about up that takes one heading to another.
static soleHalf soleHeading( const solePlaceWork* work, soleVec3 from, soleVec3 to )
{
	return soleMakeHalf( soleDot( from, to ), soleDot( work->up, soleCross( from, to ) ) );
}

static soleVec3 soleOnFloor( const solePlaceWork* work, soleVec3 point, float rise )
{
	return soleMulAdd( point, -rise, work->rootUp );
}

/// The anchor's animated place, shifted so that the ankle of a foot at rest stays over its animated place although the
/// foot is tilted: the ankle stands ankleHeight over the sole along the plane's normal.
static void soleSetAnchor( const solePlaceWork* work, soleLegWork* leg, bool byHeel )
{
	leg->anchor =
	    byHeel ? soleOnFloor( work, leg->heel, leg->heelRise ) : soleOnFloor( work, leg->ball, leg->ballRise );
	float height = leg->rig->ankleHeight * work->rootScale;
	leg->anchorShift = soleScale( -height, soleHorizontal( work, leg->plane.normal ) );
}

static soleVec3 soleAnimatedPlace( const solePlaceWork* work, const soleLegWork* leg )
{
	return soleHorizontal( work, soleAdd( leg->anchor, leg->anchorShift ) );
}

/// Where another point of the floor goes when the anchor goes to its goal.
static soleVec3 solePlaceOf( const solePlaceWork* work, const soleLegWork* leg, soleVec3 floorPoint )
{
	soleQuat tilt = soleFromTo( work->up, leg->plane.normal, leg->forward );
	soleVec3 arm = soleRotate( tilt, soleRotate( leg->turn, soleSub( floorPoint, leg->anchor ) ) );
	return soleHorizontal( work, soleAdd( leg->anchorGoal, arm ) );
}

static void soleGoFree( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleSetAnchor( work, leg, false );
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.releaseHalfLife, work->timeStep );
	state->turn = soleDecayOffset1( state->turn, work->settings->contact.releaseHalfLife, work->timeStep );
	leg->turn = soleHalfRotation( work->up, soleHalfFromQuarterTan( state->turn.value ) );
	leg->anchorGoal = soleAdd( soleAnimatedPlace( work, leg ), state->slide.value );
}

/// Begins to hold the foot where it is.
static void soleCapture( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool byHeel = ( state->flags & sole_stateToeOn ) == 0;
	if ( byHeel )
	{
		soleVec3 heel = soleOnFloor( work, leg->heel, leg->heelRise );
		leg->anchorGoal = solePlaceOf( work, leg, heel );
		soleSetAnchor( work, leg, true );
		state->flags |= (uint32_t)sole_stateByHeel;
	}
	// It was due a little before the end of the frame: held from there on.
	bool due = state->contactTime < SETTLED;
	leg->since = due ? soleMinF( state->contactTime - work->settings->contact.settle, work->timeStep ) : 0.0f;
	soleVec3 velocity = byHeel ? leg->heelVelocity : leg->ballVelocity;
	velocity = soleAdd( velocity, state->slide.velocity );
	velocity = work->first ? soleVec( 0.0f, 0.0f, 0.0f ) : velocity;
	leg->anchorGoal = soleMulAdd( leg->anchorGoal, -leg->since, velocity );
	state->lockPoint_w = soleAdd( leg->anchorGoal, work->root_w );
	state->lockForward_w = soleRotate( leg->turn, leg->forward );
	state->slide.value = soleVec( 0.0f, 0.0f, 0.0f );
	state->slide.velocity = velocity;
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.captureHalfLife, leg->since );
	leg->anchorGoal = soleAdd( leg->anchorGoal, state->slide.value );
	state->turn = ( soleOffset1 ){ 0.0f, 0.0f };
	state->flags |= (uint32_t)sole_stateLocked;
	leg->out->flags |= (uint32_t)sole_legCaptured;
}

/// Lets the foot go back to the animation from where it is.
static void soleRelease( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool byHeel = ( state->flags & sole_stateByHeel ) != 0;
	if ( byHeel )
	{
		leg->anchorGoal = solePlaceOf( work, leg, soleOnFloor( work, leg->ball, leg->ballRise ) );
		soleSetAnchor( work, leg, false );
	}
	// It was due a little before the end of the frame, at the speed of the limit that was crossed: on its way since
	// then.
	soleVec3 velocity = byHeel ? leg->heelVelocity : leg->ballVelocity;
	float speed = byHeel ? leg->heelSpeed : leg->ballSpeed;
	soleVec3 then =
	    speed > leg->letGoSpeed && leg->letGoSpeed > 0.0f ? soleScale( leg->letGoSpeed / speed, velocity ) : velocity;
	soleVec3 place = soleAnimatedPlace( work, leg );
	soleVec3 moved = soleScale( 0.5f * leg->since, soleAdd( velocity, then ) );
	state->slide.value = soleSub( leg->anchorGoal, soleSub( place, moved ) );
	state->slide.velocity = soleSub( state->slide.velocity, then );
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.releaseHalfLife, leg->since );
	leg->anchorGoal = soleAdd( place, state->slide.value );
	soleHalf half = soleHeading( work, leg->forward, soleRotate( leg->turn, leg->forward ) );
	state->turn = ( soleOffset1 ){ soleQuarterTan( half ), 0.0f };
	state->flags &= ~(uint32_t)( sole_stateLocked | sole_stateByHeel );
	leg->out->flags |= (uint32_t)sole_legReleased;
}

static void soleKeepLock( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool byHeel = ( state->flags & sole_stateByHeel ) != 0;
	soleSetAnchor( work, leg, byHeel );
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.captureHalfLife, work->timeStep );
	soleVec3 held = soleHorizontal( work, soleSub( state->lockPoint_w, work->root_w ) );
	leg->anchorGoal = soleAdd( held, state->slide.value );
	soleVec3 heading = soleNormalizeOr( soleHorizontal( work, state->lockForward_w ), leg->forward );
	leg->turn = soleHalfRotation( work->up, soleHeading( work, leg->forward, heading ) );
	if ( byHeel && ( state->flags & sole_stateToeOn ) != 0 )
	{
		// The toe is down: the same foot is from here on held by its ball.
		soleVec3 ball = solePlaceOf( work, leg, soleOnFloor( work, leg->ball, leg->ballRise ) );
		soleSetAnchor( work, leg, false );
		leg->anchorGoal = ball;
		state->lockPoint_w = soleAdd( soleSub( ball, state->slide.value ), work->root_w );
		state->flags &= ~(uint32_t)sole_stateByHeel;
	}
}

/// A lock that has become too far from the animation is given up, and not renewed before the foot has been free.
static bool soleIsLockStrained( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	float apart = soleDistance( leg->anchorGoal, soleAnimatedPlace( work, leg ) );
	soleHalf limit = soleHalfFromAngle( s->contact.lockAngle );
	soleVec3 heading = soleRotate( leg->turn, leg->forward );
	return apart > s->contact.lockDistance * leg->length ||
	    soleDot( heading, leg->forward ) < limit.c * limit.c - limit.s * limit.s;
}

static void soleUpdateLock( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool contact = leg->touches;
	bool possible = contact && leg->hasGround && leg->weight > 0.0f;
	bool settled = state->contactTime > work->settings->contact.settle;
	if ( ( state->flags & sole_stateLocked ) != 0 )
	{
		soleKeepLock( work, leg );
		bool strained = soleIsLockStrained( work, leg );
		if ( possible == false || strained )
		{
			state->flags |= strained ? (uint32_t)sole_stateBarred : 0u;
			soleRelease( work, leg );
		}
	}
	else
	{
		soleGoFree( work, leg );
		state->flags &= contact ? ~0u : ~(uint32_t)sole_stateBarred;
		if ( possible && settled && ( state->flags & sole_stateBarred ) == 0 )
		{
			soleCapture( work, leg );
		}
	}
	leg->planted = ( state->flags & sole_stateLocked ) != 0;
}

static void soleFadePlantWeight( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool down = leg->touches && leg->hasGround;
	bool changed = leg->touches != leg->touched;
	float time = changed ? leg->since : work->timeStep;
	float goal = down ? 1.0f : 0.0f;
	float fade = down ? work->settings->contact.fadeIn : work->settings->contact.fadeOut;
	float step = fade > 0.0f ? time / fade : 1.0f;
	state->time = work->first || changed ? leg->since : state->time + work->timeStep;
	if ( work->first )
	{
		state->plantWeight = goal;
	}
	else if ( state->plantWeight < goal )
	{
		state->plantWeight = soleMinF( state->plantWeight + step, goal );
	}
	else
	{
		state->plantWeight = soleMaxF( state->plantWeight - step, goal );
	}
}

void soleUpdateContact( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		soleSenseContact( work, leg );
		soleFadePlantWeight( work, leg );
		soleUpdateLock( work, leg );
		leg->out->flags |= leg->planted ? (uint32_t)sole_legPlanted : 0u;
		leg->out->plantWeight = leg->state->plantWeight;
		soleLegState* state = leg->state;
		state->animHeel_w = soleAdd( leg->heel, work->root_w );
		state->animBall_w = soleAdd( leg->ball, work->root_w );
		state->heelRise = leg->heelRise;
		state->ballRise = leg->ballRise;
		state->heelSpeed = leg->heelSpeed;
		state->ballSpeed = leg->ballSpeed;
	}
}
