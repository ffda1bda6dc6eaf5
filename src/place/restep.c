// SPDX-License-Identifier: MIT
// Restep: a foot that stands but has been left behind takes a step.
//
// A character that turns on the spot, is pushed or comes to a stop is left with feet that stand where the animation no
// longer has them. Where the body hardly moves, such a foot steps over to the animation: at once when its lock is
// strained, else when it has been further off than a smallest step for some time. One foot at a time, and not so soon
// after another, but for one that is strained too far to wait; the flight is that of a foreseen step, with a lift of
// its own. While the body travels, strained locks are given up instead: the next step of the gait is near.
#include "place/place.h"

#define SLOW 0.35f    // L/s: a body that travels slower stands
#define PACE 0.6f     // L/s: a long step takes longer
#define APART 0.15f   // s between two such steps
#define LEAST 0.02f   // s: a step is no shorter
#define PATIENCE 1.3f // times the strain at which a lock is given up: so far a foot waits for another one

/// How far a held foot is from the animation, beyond what it was when it came to be held.
static float soleFindStray( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	soleVec3 held = soleSub( state->lockPoint_w, work->root_w );
	soleVec3 place = soleSub( held, state->heldShift );
	soleVec3 animated = ( state->flags & sole_stateByHeel ) != 0 ? leg->heel : leg->ball;
	animated = work->settings->contact.pivot == sole_pivotAnkle ? leg->ankle : animated;
	animated = soleAdd( animated, soleTiltShift( work, leg, state->planeNormal_w ) );
	return soleLength( soleHorizontal( work, soleSub( place, animated ) ) );
}

/// Are two headings further apart than an angle?
static bool soleIsTurned( const solePlaceWork* work, const soleLegWork* leg, float angle )
{
	soleVec3 heading = soleNormalizeOr( soleHorizontal( work, leg->state->lockForward_w ), leg->forward );
	soleHalf limit = soleHalfFromAngle( angle );
	return soleDot( heading, leg->forward ) < limit.c * limit.c - limit.s * limit.s;
}

/// Is it off by so many times what a lock stands?
static bool soleIsStrained( const solePlaceWork* work, const soleLegWork* leg, float stray, float times )
{
	const soleSettings* s = work->settings;
	return stray > times * s->contact.lockDistance * leg->length ||
	    soleIsTurned( work, leg, times * s->contact.lockAngle );
}

/// Does the foot want to step over now?
static bool soleWantsStep( const solePlaceWork* work, soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	soleLegState* state = leg->state;
	bool held = ( state->flags & sole_stateLocked ) != 0 && leg->touches && leg->hasGround;
	bool slow = work->rootSpeed < SLOW * leg->length;
	if ( held == false || slow == false )
	{
		state->strayTime = 0.0f;
		return false;
	}
	float stray = soleFindStray( work, leg );
	bool off = stray > s->contact.replantDistance * leg->length || soleIsTurned( work, leg, s->contact.replantAngle );
	state->strayTime = off ? state->strayTime + work->timeStep : 0.0f;
	return soleIsStrained( work, leg, stray, 1.0f ) || ( off && state->strayTime > s->contact.replantAfter );
}

/// Is another foot in the air, or has just stepped over?
static bool soleIsBusy( const solePlaceWork* work, const soleLegWork* leg )
{
	bool busy = false;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* other = work->legs + i;
		// A foot in flight is not asked about its ground in every frame: what it stands on is in its memory.
		bool stands = other->hasGround || ( other->state->flags & sole_stateGround ) != 0;
		bool counts = other != leg && other->usable && stands;
		busy = busy || ( counts && ( other->touches == false || other->state->restep > -APART ) );
	}
	return busy;
}

void soleTakeResteps( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		soleLegState* state = leg->state;
		state->restep = soleMaxF( state->restep - work->timeStep, -APART );
		bool wants = soleWantsStep( work, leg );
		float stray = wants ? soleFindStray( work, leg ) : 0.0f;
		leg->waits = wants && soleIsBusy( work, leg ) && soleIsStrained( work, leg, stray, PATIENCE ) == false;
		if ( wants && leg->waits == false )
		{
			float time = soleMaxF( work->settings->contact.replantTime, LEAST );
			float far = stray / ( PACE * leg->length );
			state->restep = soleClampF( far, time, 2.0f * time );
			state->restepTime = state->restep;
			state->strayTime = 0.0f;
		}
	}
}
