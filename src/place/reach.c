// SPDX-License-Identifier: MIT
// Reach: ground that a leg cannot use, whatever the pelvis does. Too low: the leg is too short for it with its hip as
// far down as the pelvis may go. Too high: it cannot fold so far with the hip as far up. Too steep: no sole rests on
// it. All of it by the animated hip, not by where the pelvis is: what a foot does about it does not change the answer.
#include "place/place.h"

#define BACK 0.03f // L: ground has to come this much nearer to be in reach again

static bool soleIsBeyond( const soleLegWork* leg, float beyond, uint32_t flag )
{
	bool was = ( leg->state->flags & flag ) != 0;
	return leg->hasGround && beyond > ( was ? -BACK * leg->length : 0.0f );
}

static void soleClassLeg( const solePlaceWork* work, soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	float longest = soleLongestLeg( work );
	soleVec3 low = soleMulAdd( leg->joints[0], -s->pelvis.down * longest, work->up );
	soleVec3 high = soleMulAdd( leg->joints[0], s->pelvis.up * longest, work->up );
	float animated = soleDistance( leg->joints[0], leg->ankle );
	float shortest = soleMinF( s->leg.fold * leg->length, animated );
	float tooLong = soleDistance( low, leg->ankleWanted ) - soleGetReach( work, leg ).hard;
	// Ground over the hip is no nearer than ground at it.
	float under = soleDot( soleSub( high, leg->ankleWanted ), work->up );
	float tooShort = shortest - soleMinF( soleDistance( high, leg->ankleWanted ), under );
	bool below = under > 0.0f;
	bool tooLow = below && soleIsBeyond( leg, tooLong, (uint32_t)sole_stateTooLow );
	bool tooHigh = soleIsBeyond( leg, tooShort, (uint32_t)sole_stateTooHigh );
	bool tooSteep = ( leg->out->flags & (uint32_t)sole_legTooSteep ) != 0;
	leg->state->flags &= ~(uint32_t)( sole_stateTooLow | sole_stateTooHigh | sole_stateTooSteep );
	leg->state->flags |= ( tooLow ? (uint32_t)sole_stateTooLow : 0u ) | ( tooHigh ? (uint32_t)sole_stateTooHigh : 0u ) |
	    ( tooSteep ? (uint32_t)sole_stateTooSteep : 0u );
	leg->out->flags |= ( tooLow ? (uint32_t)sole_legTooLow : 0u ) | ( tooHigh ? (uint32_t)sole_legTooHigh : 0u );
}

void soleClassReach( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		if ( work->legs[i].usable )
		{
			soleClassLeg( work, work->legs + i );
		}
	}
}
