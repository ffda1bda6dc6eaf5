// SPDX-License-Identifier: MIT
// Aloft: a body that jumps or falls goes with its root, and its feet go with it.
//
// The ground is met long before it is reached, and goes on to be met long after it was left. Placed on it all the same,
// a body would stay down when its root leaps, and hang in the air at the pelvis' own speed when that falls. So while no
// foot is down there is no ground, from when all that was met is far below every sole, until some of it is near.
// Whoever walks or runs flies between steps, over roots that jump from tread to tread: then it has to be further below.
#include "place/place.h"

#include <float.h>

#define LEAVES 0.1f // L over all that was met
#define STEPS 0.4f  // L: the same of one that walks or runs
#define STRIDE 0.4f // L/s: a root that is slower does not
#define LANDS 0.05f // L

/// How far the lowest of an animated sole is over the highest of what was met, or of both ends of its way.
static float soleFindClearance( const solePlaceWork* work, const soleLegWork* leg, bool planned )
{
	const soleLegState* state = leg->state;
	float from = soleDot( soleSub( state->planePoint_w, work->root_w ), work->up );
	float to = soleDot( soleSub( state->stepPlace_w, work->root_w ), work->up );
	float highest = planned ? soleMaxF( from, to ) : -FLT_MAX;
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		highest = leg->samples[i].found ? soleMaxF( highest, leg->samples[i].height ) : highest;
	}
	soleVec3 lowest = leg->heelRise < leg->ballRise ? leg->heel : leg->ball;
	return soleDot( lowest, work->up ) - highest;
}

/// Does a leg let its body go, that was aloft or not?
static bool soleLetsGo( const solePlaceWork* work, const soleLegWork* leg, bool was )
{
	bool planned = ( leg->state->flags & sole_statePlanned ) != 0;
	if ( leg->usable == false || leg->touches || ( leg->sampleCount == 0 && planned == false ) )
	{
		// One that asked for nothing in this frame knows nothing new.
		return leg->usable == false || ( leg->touches == false && was );
	}
	bool steps = leg->foreseen || work->rootSpeed > STRIDE * leg->length;
	float least = was ? LANDS : ( steps ? STEPS : LEAVES );
	return soleFindClearance( work, leg, planned ) > least * leg->length;
}

static void soleLeaveGround( const solePlaceWork* work, soleLegWork* leg )
{
	soleVec3 under = soleAtHeight( work, leg->soleCenter, work->reference );
	leg->raw = soleMakePlane( work, under, soleVec( 0.0f, 0.0f, 0.0f ) );
	leg->toeSlope = 0.0f;
	leg->hasGround = leg->foreseen = false;
}

void soleTakeOff( solePlaceWork* work )
{
	bool was = true, aloft = work->first == false && work->legCount > 0;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		was = was && ( work->legs[i].state->flags & sole_stateAloft ) != 0;
	}
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		aloft = aloft && soleLetsGo( work, work->legs + i, was );
	}
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		leg->state->flags &= ~(uint32_t)sole_stateAloft;
		leg->state->flags |= aloft ? (uint32_t)sole_stateAloft : 0u;
		if ( aloft && leg->usable )
		{
			soleLeaveGround( work, leg );
		}
	}
}
