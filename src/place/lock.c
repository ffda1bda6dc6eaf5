// SPDX-License-Identifier: MIT
// Lock: where a planted foot is held.
//
// A foot in contact is held by one point of its sole, the anchor: the heel from heel strike on, the ball from the
// moment the toe is down. The point is held where the foot was, not where the animation is.
//   free:    anchor's place = animated place + slide        slide decays to 0: the way back to the animation
//   planned: the same                                       slide comes to rest where the step is to land, when it does
//   locked:  anchor's place = lockPoint + slide             slide decays to 0: what was left of the foot's motion
// At each change lockPoint and slide are set so that place and velocity go on unbroken; nothing is low-passed, so a
// locked foot has no lag and stands still to the bit once slide has died away. Headings are treated alike.
#include "place/place.h"

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
	leg->anchorShift = soleTiltShift( work, leg, leg->plane.normal );
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

/// One step on the cubic that takes an offset from its value and velocity to rest at a goal when the time is over. Any
/// part of such a cubic leads to the same: frames may be as long as they like.
static soleOffset3 soleArrive( soleOffset3 offset, soleVec3 goal, float time, float timeStep )
{
	if ( !( timeStep < time ) )
	{
		return ( soleOffset3 ){ goal, soleVec( 0.0f, 0.0f, 0.0f ) };
	}
	// With e the offset from the goal and u the share of the time:  e(u) = e0 (1 + 2u)(1 - u)^2 + v0 T u (1 - u)^2
	float u = timeStep / time;
	float left = 1.0f - u;
	soleVec3 e = soleSub( offset.value, goal );
	soleVec3 value =
	    soleMulAdd( soleScale( left * left * ( 1.0f + 2.0f * u ), e ), left * left * timeStep, offset.velocity );
	soleVec3 velocity = soleScale( -6.0f * u * left / time, e );
	velocity = soleMulAdd( velocity, left * ( 1.0f - 3.0f * u ), offset.velocity );
	return ( soleOffset3 ){ soleAdd( goal, value ), velocity };
}

/// The offset of a free foot some time later: on its way to where it is to land, or back to the animation.
static void soleLetSlide( const solePlaceWork* work, soleLegWork* leg, float time )
{
	soleLegState* state = leg->state;
	if ( leg->planned )
	{
		soleVec3 goal = soleHorizontal( work, soleSub( soleLevelPlace( work, leg ), leg->landing ) );
		state->slide = soleArrive( state->slide, goal, leg->stepInput.until + time, time );
	}
	else
	{
		state->slide = soleDecayOffset3( state->slide, work->settings->contact.releaseHalfLife, time );
	}
}

static void soleGoFree( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleSetAnchor( work, leg, false );
	soleLetSlide( work, leg, work->timeStep );
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
	bool due = leg->told == false;
	leg->since = due ? soleMinF( state->contactTime - work->settings->contact.settle, work->timeStep ) : leg->since;
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
	soleVec3 then = speed > leg->letGoSpeed ? soleScale( leg->letGoSpeed / speed, velocity ) : velocity;
	// What a host calls a lift is slow: the foot may take up the animation's motion at once. Its true speed then is not
	// known, and a frame's mean would send the foot another way at every frame rate.
	then = leg->told ? velocity : then;
	soleVec3 place = soleAnimatedPlace( work, leg );
	soleVec3 moved = soleScale( 0.5f * leg->since, soleAdd( velocity, then ) );
	state->slide.value = soleSub( leg->anchorGoal, soleSub( place, moved ) );
	state->slide.velocity = leg->told ? soleVec( 0.0f, 0.0f, 0.0f ) : soleSub( state->slide.velocity, then );
	soleLetSlide( work, leg, leg->since );
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
		state->flags &= ~(uint32_t)( sole_stateByHeel | sole_stateCompared );
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

void soleUpdateLocks( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable )
		{
			soleUpdateLock( work, leg );
			leg->out->flags |= leg->planted ? (uint32_t)sole_legPlanted : 0u;
		}
	}
}
