// SPDX-License-Identifier: MIT
// Footing: the plane under a foot that is not on its way to a foothold it has foreseen.
//
// A foot that comes down stands on what was foreseen until it is held; then its ground is read closely, once, and that
// plane is kept until what is met under the foot changes: under the load point the ground is compared with the plane,
// and a difference that grows by more than CHANGE is ground that has moved.
//
// A foot that is not foreseen follows the ground under it. It has to pass over what comes: where the ground that its
// toes will be over soon is higher than its plane, the plane is raised by as much. What rises gently is no obstacle.
#include "place/footing.h"
#include "place/way.h"

#define GENTLE 0.5f    // rise per length
#define MISS_TIME 0.1f // s
#define NEAR_BY 0.06f  // L: a foot this near to its foothold has come down on it
#define CHANGE 0.003f  // L: ground that has moved by more is read anew
#define FEW 0.34f      // share of the places under a sole

/// The plane that was chosen for a foot.
static solePlane soleGetChosen( const solePlaceWork* work, const soleLegState* state )
{
	soleVec3 gradient = soleGradientOf( work, state->stepNormal_w );
	return soleMakePlane( work, soleSub( state->stepPlace_w, work->root_w ), gradient );
}

/// How far a plane is over the one that was met, under the load point of that.
static float soleHeightOver( const solePlaceWork* work, solePlane met, solePlane plane )
{
	return solePlaneHeight( work, plane, met.point ) - soleDot( met.point, work->up );
}

/// What is met under a foot is the step over its own, and bears little of it.
static bool soleIsStepOver( const solePlaceWork* work, const soleLegWork* leg, float over, float share )
{
	return over < -SOLE_NEXT_STEP * leg->length && over > -work->settings->probe.stepUp * leg->length && share < FEW;
}

bool soleMeetsNextStep( const solePlaceWork* work, const soleLegWork* leg, solePlane met, float share )
{
	return soleIsStepOver( work, leg, soleHeightOver( work, met, soleGetChosen( work, leg->state ) ), share );
}

/// How much higher than the plane the ground is that a foot in flight will pass over.
static float soleFindObstacle( const solePlaceWork* work, const soleLegWork* leg )
{
	float obstacle = 0.0f;
	for ( int32_t i = 0; i < leg->sampleCount && leg->flying; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 from = soleSub( sample->place, leg->tip );
		if ( sample->found && soleDot( from, leg->ballVelocity ) > 0.0f )
		{
			float over = sample->height - solePlaneHeight( work, leg->raw, sample->place );
			float gentle = GENTLE * soleLength( soleHorizontal( work, from ) );
			over = soleMinF( over, 3.0f * soleMaxF( over - gentle, 0.0f ) );
			obstacle = soleMaxF( obstacle, soleMinF( over, work->settings->probe.stepUp * leg->length ) );
		}
	}
	return obstacle;
}

/// A foot stands on a plane from now on.
static void soleSettleOn( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleVec3 place = soleAtHeight( work, leg->soleCenter, solePlaneHeight( work, leg->raw, leg->soleCenter ) );
	state->stepPlace_w = soleAdd( place, work->root_w );
	state->stepNormal_w = leg->raw.normal;
	state->toeSlope = leg->toeSlope;
	state->flags |= (uint32_t)sole_stateChosen;
	state->flags &= ~(uint32_t)sole_stateCompared;
}

/// A foot that has just come down: on what was foreseen until it is held. Then its ground is asked for closely, and
/// that is what it stands on, as when the ground has changed under it; but where a toe that just meets a riser, or a
/// heel, would have it stand on the step over it, it stays on what was foreseen, or on what it stood.
static void soleComeDown( solePlaceWork* work, soleLegWork* leg, bool foreseen )
{
	solePlane chosen = soleGetChosen( work, leg->state );
	float over = soleHeightOver( work, leg->raw, chosen );
	float missed = soleLength( soleHorizontal( work, soleSub( leg->soleCenter, chosen.point ) ) );
	bool locked = ( leg->state->flags & sole_stateLocked ) != 0;
	bool there = missed < NEAR_BY * leg->length;
	bool stood = ( leg->state->flags & sole_stateCompared ) != 0;
	if ( foreseen && there && locked == false )
	{
		leg->raw = soleMakePlane( work, soleMulAdd( leg->raw.point, over, work->up ), chosen.gradient );
		leg->toeSlope = leg->state->toeSlope;
	}
	else if ( ( foreseen || stood ) && there && soleIsStepOver( work, leg, over, leg->share ) )
	{
		soleVec3 point = soleMulAdd( leg->raw.point, over, work->up );
		leg->raw = soleMakePlane( work, point, chosen.gradient );
		leg->toeSlope = 0.0f;
	}
	// In the first frame all is read closely: it is final.
	if ( locked || work->first )
	{
		soleSettleOn( work, leg );
	}
	else
	{
		leg->state->flags |= foreseen ? (uint32_t)sole_stateForeseen : 0u;
	}
}

/// A foot that stands keeps its plane until the ground under it changes.
static void soleStandOn( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	solePlane chosen = soleGetChosen( work, state );
	float over = soleHeightOver( work, leg->raw, chosen );
	// One that falls asleep or wakes up asks for other places: those are compared from then on.
	bool asleep = ( state->flags & sole_stateAsleep ) != 0;
	bool compared = ( state->flags & sole_stateCompared ) != 0 && asleep == leg->asleep;
	state->flags &= ~(uint32_t)sole_stateAsleep;
	state->flags |= leg->asleep ? (uint32_t)sole_stateAsleep : 0u;
	float change = over - state->chosenOver;
	float most = CHANGE * leg->length;
	bool changed = leg->hasGround == false || ( compared && ( change > most || change < -most ) );
	state->flags &= changed ? ~(uint32_t)sole_stateChosen : ~0u;
	// What is read closely in the next frame may be no more than a riser that the toes touch.
	if ( changed && ( leg->hasGround == false || soleIsStepOver( work, leg, over, leg->share ) == false ) )
	{
		return;
	}
	state->chosenOver = compared ? state->chosenOver : over;
	state->flags |= (uint32_t)sole_stateCompared;
	leg->raw = soleMakePlane( work, soleMulAdd( leg->raw.point, over, work->up ), chosen.gradient );
	leg->toeSlope = state->toeSlope;
}

void soleBridgeMiss( const solePlaceWork* work, soleLegWork* leg, solePlane old )
{
	soleLegState* state = leg->state;
	bool stands = leg->hadGround && leg->touches;
	bool missed = leg->hasGround == false && leg->foreseen == false && stands;
	// One that has come down while it was foreseen to be in flight has not asked what is under it.
	bool unasked = leg->foreseen && leg->sampleCount <= soleGetLookCount( work->settings ) && stands;
	state->missTime = missed ? state->missTime + work->timeStep : 0.0f;
	if ( unasked || ( missed && state->missTime < MISS_TIME ) )
	{
		leg->hasGround = true;
		leg->missed = true;
		leg->raw = old;
		leg->toeSlope = state->toeSlope;
		leg->surface = state->body.surface;
		leg->surfaceVelocity = ( state->flags & sole_stateRides ) != 0 ? leg->surfaceVelocity : state->body.place;
	}
}

soleVec3 soleStandPlace( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	bool coming = ( state->flags & ( sole_stateForeseen | sole_stateLocked ) ) == sole_stateForeseen;
	return coming ? soleSub( state->stepPlace_w, work->root_w ) : leg->soleCenter;
}

void soleFollowGround( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	const uint32_t chosen = (uint32_t)sole_stateChosen;
	const uint32_t foreseen = (uint32_t)( sole_statePlanned | sole_stateForeseen );
	uint32_t flags = state->flags;
	if ( leg->missed )
	{
		return; // all is as it was
	}
	state->flags &= ~foreseen;
	if ( leg->touches == false )
	{
		state->flags &= ~chosen;
	}
	else if ( ( flags & chosen ) != 0 )
	{
		soleStandOn( work, leg );
	}
	else if ( leg->hasGround )
	{
		soleComeDown( work, leg, ( flags & foreseen ) != 0 );
	}
	// What is ahead of a foot that has come down is no obstacle any more.
	bool passes = leg->touches == false && ( flags & foreseen ) == 0;
	leg->raw.point = soleMulAdd( leg->raw.point, passes ? soleFindObstacle( work, leg ) : 0.0f, work->up );
	soleVec3 place = soleStandPlace( work, leg );
	place = soleAtHeight( work, place, solePlaneHeight( work, leg->raw, place ) );
	state->planePoint_w = soleAdd( place, work->root_w );
	state->planeNormal_w = leg->raw.normal;
}
