// SPDX-License-Identifier: MIT
// Lock: where a planted foot is held.
//
// A foot in contact is held by one point of its sole, the anchor: the heel from heel strike on, the ball from the
// moment the toe is down. The point is held where the foot was, not where the animation is. At the end of a stance the
// foot rolls over its toe tip, t ahead of the ball, and takes its ball along: by  t ( 1 - cos ),  cos of the angle at
// which its toes stand up; where they are bent against the foot by the slope s also by  -s t sin,  since the foot turns
// with its own plane. The anchor is the ball less that: held is the tip. That of a foot in flight is its ball, too, and
// goes over to where the ball will be, heelBehind ahead of the heel, as the heel comes to be lowest.
//   free:    anchor's place = animated place + slide        slide decays to 0: the way back to the animation
//   planned: the same, and a lead near the way's end       slide comes to rest where the step is to land, when it does
//   locked:  anchor's place = lockPoint + slide             slide decays to 0: what was left of the foot's motion
// At each change lockPoint and slide are set so that place and velocity go on unbroken; nothing is low-passed, so a
// locked foot has no lag and stands still to the bit once slide has died away. Headings are treated alike.
#include "place/stance.h"
#include "place/way.h"

#define AHEAD 3.0f    // L/s: fastest that a foot goes ahead of the animation
#define AT_REST 0.06f // L/s: a foot that comes down slower than this has come to rest
#define SHORT 0.1f    // L: a leg whose foot can't come nearer than this to where it is held gives up

/// The turn about up that takes one heading to another.
static soleHalf soleHeading( const solePlaceWork* work, soleVec3 from, soleVec3 to )
{
	return soleMakeHalf( soleDot( from, to ), soleDot( work->up, soleCross( from, to ) ) );
}

static soleVec3 soleOnFloor( const solePlaceWork* work, soleVec3 point, float rise )
{
	return soleMulAdd( point, -rise, work->rootUp );
}

/// How far ahead the ball has gone with a foot that went on to stand on its toe tip alone.
static float soleFindRoll( const solePlaceWork* work, const soleLegWork* leg )
{
	float toe = leg->rig->toeAhead * work->rootScale;
	float sine = soleFindTiptoe( work, leg );
	return toe * ( 1.0f - soleSqrtF( 1.0f - sine * sine ) - sine * leg->toeSlope );
}

/// Where the ball is, or was before it went along with the toes' roll.
static soleVec3 soleBallOnFloor( const solePlaceWork* work, const soleLegWork* leg )
{
	soleVec3 ball = soleOnFloor( work, leg->ball, leg->ballRise );
	return soleMulAdd( ball, -leg->rolled, leg->forward );
}

/// The anchor of a foot that is held by its heel, or by its ball.
static soleVec3 soleHeldPoint( const solePlaceWork* work, const soleLegWork* leg, bool byHeel )
{
	if ( work->settings->contact.pivot == sole_pivotAnkle )
	{
		return soleOnFloor( work, leg->ankle, soleDot( soleSub( leg->ankle, work->floor ), work->rootUp ) );
	}
	return byHeel ? soleOnFloor( work, leg->heel, leg->heelRise ) : soleBallOnFloor( work, leg );
}

/// The anchor of one that is free: its ball, or where that will be when the foot has come down on its heel.
static soleVec3 soleFreePoint( const solePlaceWork* work, const soleLegWork* leg )
{
	soleVec3 ball = soleHeldPoint( work, leg, false );
	if ( work->settings->contact.pivot == sole_pivotAnkle )
	{
		return ball;
	}
	soleVec3 byHeel = soleHeldPoint( work, leg, true );
	byHeel = soleMulAdd( byHeel, leg->rig->heelBehind * work->rootScale, leg->forward );
	return soleLerp( ball, byHeel, soleIsOnHeel( leg, SOLE_ON_HEEL ) );
}

/// How fast the animation moves a place by which a foot is held.
static soleVec3 soleAnchorVelocity( const solePlaceWork* work, const soleLegWork* leg, bool byHeel )
{
	if ( byHeel || work->first || !( work->timeStep > 0.0f ) )
	{
		return byHeel ? leg->heelVelocity : leg->ballVelocity;
	}
	float rolled = leg->rolled - leg->state->rolled;
	return soleMulAdd( leg->ballVelocity, -rolled / work->timeStep, leg->forward );
}

/// The anchor's animated place, shifted so that the ankle of a foot at rest stays over its animated place although the
/// foot is tilted: the ankle stands ankleHeight over the sole along the plane's normal.
static void soleSetAnchor( const solePlaceWork* work, soleLegWork* leg, soleVec3 point )
{
	leg->anchor = point;
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

/// Takes another point as the anchor: the foot stays where it is.
static void soleChangeAnchor( const solePlaceWork* work, soleLegWork* leg, soleVec3 point )
{
	leg->anchorGoal = solePlaceOf( work, leg, point );
	soleSetAnchor( work, leg, point );
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

/// A host says that a foot is down a little before it has come to rest: so long it may go on with its animation.
static bool soleIsComingDown( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	return ( state->flags & sole_stateBarred ) == 0 && state->time < 2.0f * work->settings->contact.settle;
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
	else if ( leg->touches && soleIsComingDown( work, leg ) )
	{
		// It is down, and comes to rest with the animation; what was left of its way when it came down is over.
		bool came = leg->touched == false && ( state->flags & sole_stateForeseen ) != 0;
		soleVec3 meant = soleSub( state->stepLanding_w, work->root_w );
		soleVec3 goal = soleHorizontal( work, soleSub( soleLevelPlace( work, leg ), meant ) );
		state->slide.value = came ? goal : state->slide.value;
		state->slide.velocity = soleVec( 0.0f, 0.0f, 0.0f );
	}
	else
	{
		state->slide = soleDecayOffset3( state->slide, work->settings->contact.releaseHalfLife, time );
	}
}

/// By how much a foot on its way is ahead of the animation. No jump of what is told of its way is taken over, and one
/// that has lost its way is no nearer to the animation.
static void soleGoAhead( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	if ( leg->planned == false )
	{
		state->slide.value = soleAdd( state->slide.value, state->lead );
		state->lead = soleVec( 0.0f, 0.0f, 0.0f );
		return;
	}
	soleVec3 step = soleSub( soleLeadWay( work, leg ), state->lead );
	float most = AHEAD * leg->length * work->timeStep;
	float length = soleLength( step );
	state->lead = soleMulAdd( state->lead, length > most ? most / length : 1.0f, step );
}

static void soleGoFree( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleSetAnchor( work, leg, soleFreePoint( work, leg ) );
	soleLetSlide( work, leg, work->timeStep );
	state->turn = soleDecayOffset1( state->turn, work->settings->contact.releaseHalfLife, work->timeStep );
	leg->turn = soleHalfRotation( work->up, soleHalfFromQuarterTan( state->turn.value ) );
	soleGoAhead( work, leg );
	leg->anchorGoal = soleAdd( soleAnimatedPlace( work, leg ), soleAdd( state->slide.value, state->lead ) );
}

/// Begins to hold the foot where it is.
static void soleCapture( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool byHeel = ( state->flags & sole_stateToeOn ) == 0;
	soleChangeAnchor( work, leg, soleHeldPoint( work, leg, byHeel ) );
	state->flags |= byHeel ? (uint32_t)sole_stateByHeel : 0u;
	// It was due a little before the end of the frame: held from there on.
	bool due = leg->told == false;
	leg->since = due ? soleMinF( state->contactTime - work->settings->contact.settle, work->timeStep ) : leg->since;
	soleVec3 velocity = soleAdd( soleAnchorVelocity( work, leg, byHeel ), state->slide.velocity );
	velocity = work->first ? soleVec( 0.0f, 0.0f, 0.0f ) : velocity;
	leg->anchorGoal = soleMulAdd( leg->anchorGoal, -leg->since, velocity );
	state->lockPoint_w = soleAdd( leg->anchorGoal, work->root_w );
	state->lockForward_w = soleRotate( leg->turn, leg->forward );
	state->slide.value = soleVec( 0.0f, 0.0f, 0.0f );
	state->slide.velocity = velocity;
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.captureHalfLife, leg->since );
	leg->anchorGoal = soleAdd( leg->anchorGoal, state->slide.value );
	state->heldShift = soleSub( leg->anchorGoal, soleAnimatedPlace( work, leg ) );
	state->turn = work->settings->contact.pivot == sole_pivotNone ? ( soleOffset1 ){ 0.0f, 0.0f } : state->turn;
	state->flags |= (uint32_t)sole_stateLocked;
	leg->out->flags |= (uint32_t)sole_legCaptured;
}

/// Lets the foot go back to the animation from where it is.
static void soleRelease( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool byHeel = ( state->flags & sole_stateByHeel ) != 0;
	soleChangeAnchor( work, leg, soleFreePoint( work, leg ) );
	// It was due a little before the end of the frame, at the speed of the limit that was crossed: on its way since
	// then.
	soleVec3 velocity = soleAnchorVelocity( work, leg, byHeel );
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
	soleSetAnchor( work, leg, soleHeldPoint( work, leg, byHeel ) );
	state->slide = soleDecayOffset3( state->slide, work->settings->contact.captureHalfLife, work->timeStep );
	soleVec3 held = soleHorizontal( work, soleSub( state->lockPoint_w, work->root_w ) );
	leg->anchorGoal = soleAdd( held, state->slide.value );
	if ( work->settings->contact.pivot == sole_pivotNone )
	{
		soleVec3 heading = soleNormalizeOr( soleHorizontal( work, state->lockForward_w ), leg->forward );
		leg->turn = soleHalfRotation( work->up, soleHeading( work, leg->forward, heading ) );
	}
	else
	{
		state->turn = soleDecayOffset1( state->turn, work->settings->contact.releaseHalfLife, work->timeStep );
		leg->turn = soleHalfRotation( work->up, soleHalfFromQuarterTan( state->turn.value ) );
		state->lockForward_w = soleRotate( leg->turn, leg->forward );
	}
	if ( byHeel && ( state->flags & sole_stateToeOn ) != 0 )
	{
		// The toe is down: the same foot is from here on held by its ball.
		soleChangeAnchor( work, leg, soleHeldPoint( work, leg, false ) );
		state->lockPoint_w = soleAdd( soleSub( leg->anchorGoal, state->slide.value ), work->root_w );
		state->flags &= ~(uint32_t)( sole_stateByHeel | sole_stateCompared );
	}
}

/// How a held foot is off: how far and how much it is turned, each as a share of what a lock stands. How far counts
/// from where the lock began: a step that was shifted is not strained by that.
static float soleFindStrain( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	soleVec3 apart = soleSub( leg->anchorGoal, soleAnimatedPlace( work, leg ) );
	float held = ( leg->state->flags & sole_stateLocked ) != 0 ? 1.0f : 0.0f;
	apart = soleMulAdd( apart, -held, leg->state->heldShift );
	float far = soleLength( soleHorizontal( work, apart ) ) / soleMaxF( s->contact.lockDistance * leg->length, 1e-6f );
	soleHalf turned = soleHeading( work, leg->forward, soleRotate( leg->turn, leg->forward ) );
	float most = work->angles.lockTurn;
	float turn = soleQuarterTan( turned );
	return soleMaxF( far, ( turn < 0.0f ? -turn : turn ) / soleMaxF( most, 1e-6f ) );
}

/// Has the foot been down for long enough to be held?
static bool soleIsSettled( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	float settle = work->settings->contact.settle;
	float speed = ( state->flags & sole_stateToeOn ) != 0 ? leg->ballSpeed : leg->heelSpeed;
	bool moving = leg->told && work->first == false && speed > AT_REST * leg->length && soleIsComingDown( work, leg );
	return state->contactTime > settle && moving == false;
}

/// A lock that is strained is given up, and may begin anew when the foot has been free, or is near the animation again.
static void soleUpdateLock( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	leg->rolled = soleFindRoll( work, leg );
	bool possible = soleHoldsFeet( work ) && leg->touches && leg->hasGround && leg->weight > 0.0f &&
	    leg->weight == leg->weightBefore;
	if ( ( state->flags & sole_stateLocked ) != 0 )
	{
		soleKeepLock( work, leg );
		float strain = soleFindStrain( work, leg );
		bool strained = ( strain > 1.0f && leg->waits == false ) || state->shortfall > SHORT;
		if ( possible == false || strained )
		{
			state->flags |= strained ? (uint32_t)sole_stateBarred : 0u;
			// A lock that a long frame has strained was so before its end.
			leg->since = possible && strain > 1.0f ? work->timeStep * ( 1.0f - 1.0f / strain ) : leg->since;
			soleRelease( work, leg );
		}
	}
	else
	{
		soleGoFree( work, leg );
		bool near = soleFindStrain( work, leg ) < work->settings->contact.relock && state->shortfall < 0.5f * SHORT;
		state->flags &= leg->touches && near == false ? ~0u : ~(uint32_t)sole_stateBarred;
		if ( possible && soleIsSettled( work, leg ) && ( state->flags & sole_stateBarred ) == 0 )
		{
			soleCapture( work, leg );
		}
	}
	leg->planted = ( state->flags & sole_stateLocked ) != 0;
	state->rolled = leg->rolled;
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
