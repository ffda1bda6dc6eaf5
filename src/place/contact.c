// SPDX-License-Identifier: MIT
// Contact: which part of a foot is on the ground, and since when.
//
// Heel and toe are told apart, by the host's labels where there are any, else by speed and height over the clip's floor
// with hysteresis in both. Contact begins and ends between frames: when, is interpolated, so that a slow frame rate
// holds the foot at the same place as a fast one.
#include "place/place.h"

#define SETTLED 1e3f // s: longer than any setting
#define LOWERS 24.0f // 1/s: half of the lift of a heel that has left the ground is over after 0.07 s

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
	since = told ? soleMinF( soleMaxF( leg->stepInput.since, 0.0f ), work->timeStep ) : since;
	leg->since = work->first || on == was ? 0.0f : since;
	leg->letGoSpeed = told ? limits.speedOn : limits.speedOff;
	leg->told = told;
	leg->touches = on;
	leg->touched = was;
	// On the first frame speeds are not known: what stands still then is held a little later.
	float lasted = was ? state->contactTime + work->timeStep : leg->since;
	state->contactTime = on ? ( told ? SETTLED : lasted ) : 0.0f;
	state->flags &= ~(uint32_t)( sole_stateHeelOn | sole_stateToeOn );
	state->flags |= heelOn ? (uint32_t)sole_stateHeelOn : 0u;
	state->flags |= toeOn ? (uint32_t)sole_stateToeOn : 0u;
}

/// What is left, some time later, of the lift of a heel that a foot in flight needs no more: as of a critically damped
/// spring that was at rest when the foot left, ( 1 + y t ) exp( -y t ) of what it was then.
static float soleLowerHeel( const soleLegState* state, float time )
{
	float now = LOWERS * state->time;
	float before = soleMaxF( now - LOWERS * time, 0.0f );
	return state->heelLift * ( 1.0f + now ) / ( 1.0f + before ) * soleExpNegative( now - before );
}

/// Fades a foot's weight, and what its heel is still lifted by.
static void soleFadePlanted( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool down = leg->touches && ( leg->hasGround || ( state->flags & sole_stateGround ) != 0 );
	bool changed = leg->touches != leg->touched;
	float time = changed ? leg->since : work->timeStep;
	float goal = down ? 1.0f : 0.0f;
	float fade = down ? work->settings->contact.fadeIn : work->settings->contact.fadeOut;
	float step = fade > 0.0f ? time / fade : 1.0f;
	leg->flight = state->time + work->timeStep - leg->since;
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
	bool lowers = down == false && work->first == false && state->heelLift > 0.0f;
	leg->liftLeft = lowers ? soleLowerHeel( state, time ) : 0.0f;
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
		soleFadePlanted( work, leg );
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
