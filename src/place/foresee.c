// SPDX-License-Identifier: MIT
// Foresee: when a foot in flight will come down, and where the animation means it to.
//
// The host tells, from the clip. A foot that steps over by itself (restep.c) comes down where the animation has it now,
// when its time is over. For any other foot it is as it was the last time: a gait repeats itself, so the flight lasts
// as long, and the foot comes down where it did, as seen from the root, which goes on as it goes; if it goes about as
// fast.
#include "place/place.h"

#define ALIKE 0.35f   // a gait whose speed differs by a smaller share is the same
#define OVERDUE 0.04f // s: a flight that lasts longer than this beyond the last one is another kind of step
#define NEARLY 0.01f  // s
#define LONGEST 1.5f  // s: a longer flight is no step
#define STRIDE 0.4f   // L/s: a root that is slower takes no steps that can be learnt

/// The flat foot's ball, if what is down first stays where it is.
static soleVec3 soleFlatBall( const solePlaceWork* work, const soleLegWork* leg )
{
	soleVec3 byHeel = soleMulAdd( leg->heel, leg->rig->heelBehind * work->rootScale, leg->forward );
	return leg->heelRise < leg->ballRise ? byHeel : leg->ball;
}

static bool soleForeseeTold( solePlaceWork* work, soleLegWork* leg )
{
	const soleStepInput* step = &leg->stepInput;
	bool down = leg->contactInput.heel >= 0.5f || leg->contactInput.toe >= 0.5f;
	bool told = leg->contactInput.heel >= 0.0f || leg->contactInput.toe >= 0.0f;
	if ( told == false || down || step->until < 0.0f || step->since < 0.0f )
	{
		return false;
	}
	soleQuat rotation = soleNormalizeQuat( work->frame->root.rotation );
	soleVec3 scale = work->frame->root.scale;
	soleVec3 forward = soleHorizontal( work, soleRotate( rotation, step->forward ) );
	leg->travel = soleHorizontal( work, soleRotate( rotation, soleMul( scale, step->travel ) ) );
	leg->landing = soleRotate( rotation, soleMul( scale, step->place ) );
	leg->landingForward = soleNormalizeOr( forward, leg->forward );
	return true;
}

/// A foot that steps over is in the air, whatever the animation says.
static bool soleForeseeRestep( solePlaceWork* work, soleLegWork* leg )
{
	float left = leg->state->restep - work->timeStep;
	if ( !( left > 0.0f ) )
	{
		return false;
	}
	leg->contactInput = ( soleContactInput ){ 0.0f, 0.0f };
	leg->stepInput.since = soleMaxF( leg->state->restepTime - left, 0.0f );
	leg->stepInput.until = left;
	leg->travel = soleVec( 0.0f, 0.0f, 0.0f );
	leg->landing = soleFlatBall( work, leg );
	leg->landingForward = leg->forward;
	return true;
}

/// Who knows how long this leg's steps take: itself; on its first one, if it was seen to leave, the other of a biped.
static const soleLegState* soleFindLearnt( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* own = leg->state;
	bool asks = !( own->learntFlight > 0.0f ) && ( own->flags & sole_stateLeft ) != 0 && work->legCount == 2;
	return asks ? work->legs[1 - leg->index].state : own;
}

/// Where this leg came down the last time, seen from the root, world axes; where the other one did, as far ahead, but
/// on its own side.
static soleVec3 soleFindLearntPlace( const solePlaceWork* work, const soleLegWork* leg, const soleLegState* learnt )
{
	soleQuat rotation = soleNormalizeQuat( work->frame->root.rotation );
	soleVec3 place = soleRotate( rotation, soleMul( work->frame->root.scale, learnt->learntPlace ) );
	if ( learnt == leg->state )
	{
		return place;
	}
	soleVec3 along = soleNormalizeOr( work->rootVelocity, work->level );
	soleVec3 own = soleHorizontal( work, soleFlatBall( work, leg ) );
	return soleMulAdd( own, soleDot( soleSub( place, own ), along ), along );
}

static bool soleForeseeAgain( solePlaceWork* work, soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	const soleLegState* learnt = soleFindLearnt( work, leg );
	bool told = leg->contactInput.heel >= 0.0f || leg->contactInput.toe >= 0.0f;
	bool down = ( state->flags & ( sole_stateLocked | sole_stateHeelOn | sole_stateToeOn ) ) != 0;
	float most = ALIKE * learnt->learntSpeed;
	float apart = work->rootSpeed - learnt->learntSpeed;
	bool alike = apart < most && apart > -most && work->rootSpeed > STRIDE * leg->length;
	if ( told || down || alike == false || !( learnt->learntFlight > 0.0f ) || !( work->timeStep > 0.0f ) )
	{
		return false;
	}
	float since = state->time + work->timeStep;
	float until = learnt->learntFlight - since;
	if ( until < -OVERDUE )
	{
		return false;
	}
	leg->stepInput.since = since;
	leg->stepInput.until = soleMaxF( until, NEARLY );
	leg->travel = soleScale( leg->stepInput.until, work->rootVelocity );
	leg->landing = soleAdd( soleFindLearntPlace( work, leg, learnt ), leg->travel );
	leg->landingForward = leg->forward;
	return true;
}

void soleForesee( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable && work->first == false )
		{
			leg->foreseen =
			    soleForeseeRestep( work, leg ) || soleForeseeTold( work, leg ) || soleForeseeAgain( work, leg );
		}
	}
}

void soleLearnSteps( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		soleLegState* state = leg->state;
		bool left = leg->usable && leg->touched && leg->touches == false;
		state->flags |= left ? (uint32_t)sole_stateLeft : 0u;
		bool came = leg->usable && leg->told == false && leg->touches && leg->touched == false;
		if ( came == false || work->first )
		{
			continue;
		}
		// How long it was in the air is known from before its time was set back.
		bool seen = ( state->flags & sole_stateLeft ) != 0;
		bool step = seen && leg->flight > 0.0f && leg->flight < LONGEST && work->rootSpeed > STRIDE * leg->length;
		state->flags &= ~(uint32_t)sole_stateLeft;
		state->learntFlight = step ? leg->flight : 0.0f;
		state->learntSpeed = work->rootSpeed;
		soleQuat rotation = soleNormalizeQuat( work->frame->root.rotation );
		soleVec3 scale = work->frame->root.scale;
		soleVec3 place = soleInvRotate( rotation, soleHorizontal( work, soleFlatBall( work, leg ) ) );
		state->learntPlace = soleVec( place.x / scale.x, place.y / scale.y, place.z / scale.z );
	}
}
