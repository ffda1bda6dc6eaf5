// SPDX-License-Identifier: MIT
// Foothold: where the next step lands, and the plane that a foot follows on its way there.
//
// Where. foresee.c knows when a foot comes down and where the animation means it to: its landing. Of places along the
// foot around the landing, within foothold.shift, the one is taken that costs least,
//   cost = 2 distance + max( 0, share - bearing share ) + 10 max( 0, depth - 2 mm )     lengths in leg lengths / 0.9
// and half of the second term for what is ahead of the ball and for what is behind it, each by itself: a foot comes
// down on its heel and leaves with its toes, so a sole should not hang over an edge when a small shift helps; and a
// little more where an end of the sole has no room to what is higher. The place taken last is one of them, and keeps
// its rank unless another is better by MUCH; near the end it is settled. The foot travels there in flight, on the way
// of way.c: it need not slide once it is down.
//
// A foot that is not on such a way has the plane of footing.c.
//
// Either way what differs between the ground as the last frame had it and as it is now is inertialised: kept as an
// offset that decays. Slopes pass without lag, since the old plane already foretold them; steps are taken up softly by
// a foot in flight, quickly by a planted one.
#include "place/footing.h"
#include "place/rest.h"
#include "place/way.h"

#define RESTEP_LIFT 0.04f // L
#define MUCH 0.02f        // of cost, by which a place has to be better that is
#define FAR_OFF 0.05f     // L away from the last choice, or further
#define UNSHIFTED 0.002f  // L
#define DEPTH 0.0022f     // L
#define ROOM 0.02f        // L
#define NARROW 0.3f       // cost of no room at all
#define SHIFTS 4          // to either side
#define UNFIT 1.0f        // cost of a place that cannot be walked on, or is not known

// ----------------------------------------------------------------------------------------------------------- where

/// How little room there is between the ends of a sole that rests somewhere and what is higher there: 1 none, 0 enough.
static float soleFindNarrow( const solePlaceWork* work, const soleLegWork* leg, soleVec3 place, solePlane plane )
{
	float narrow = 0.0f;
	float room = ROOM * leg->length;
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		float u = soleDot( soleSub( sample->place, place ), leg->landingForward );
		float beyond =
		    soleMaxF( u - leg->rig->toeAhead * work->rootScale, -leg->rig->heelBehind * work->rootScale - u );
		float over = sample->height - solePlaneHeight( work, plane, sample->place );
		if ( sample->found && beyond > -0.3f * room && beyond < room && over > SOLE_NEXT_STEP * leg->length )
		{
			narrow = soleMaxF( narrow, 1.0f - soleMaxF( beyond, 0.0f ) / room );
		}
	}
	return narrow;
}

/// What it costs that the animation means the foot elsewhere.
static float soleFindShiftCost( const solePlaceWork* work, const soleLegWork* leg, soleVec3 place )
{
	float metre = 0.9f / leg->length;
	return 2.0f * metre * soleLength( soleHorizontal( work, soleSub( place, leg->landing ) ) );
}

/// What the ground at a place costs.
static float soleFindGroundCost( const solePlaceWork* work, const soleLegWork* leg, soleVec3 place )
{
	float metre = 0.9f / leg->length;
	soleRest rest = soleRestSole( work, leg, soleMakeFootprint( work, place, leg->landingForward, work->up ), true );
	float wanted = work->settings->foothold.share;
	float cost = soleMaxF( wanted - rest.share, 0.0f );
	cost += 0.5f * ( soleMaxF( wanted - rest.foreShare, 0.0f ) + soleMaxF( wanted - rest.rearShare, 0.0f ) );
	cost += NARROW * soleFindNarrow( work, leg, place, rest.plane );
	cost += 10.0f * metre * soleMaxF( rest.sunk - DEPTH * leg->length, 0.0f );
	return cost + ( rest.known && rest.steep == false ? 0.0f : UNFIT );
}

/// The best of some places to either side of another, the nearest first. One that is to replace the last choice has to
/// be better by more the further it is from that. Where the way there alone costs too much the ground is not looked at.
static void soleTryPlaces( const solePlaceWork* work, const soleLegWork* leg, soleVec3 middle, float apart,
    soleVec3 last, soleVec3* best, float* least )
{
	for ( int32_t i = 0; i < 2 * SHIFTS + 1; ++i )
	{
		// 0, 1, -1, 2, -2 ...
		float steps = (float)( i % 2 == 1 ? ( i + 1 ) / 2 : -i / 2 );
		soleVec3 place = soleMulAdd( middle, steps * apart, leg->landingForward );
		float change = soleLength( soleHorizontal( work, soleSub( place, last ) ) );
		float cost = soleFindShiftCost( work, leg, place ) + MUCH * soleSaturate( change / ( FAR_OFF * leg->length ) );
		cost += cost < *least ? soleFindGroundCost( work, leg, place ) : 0.0f;
		if ( cost < *least )
		{
			*least = cost;
			*best = place;
		}
	}
}

static soleVec3 soleChoosePlace( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	bool planned = ( state->flags & sole_statePlanned ) != 0;
	float apart = work->settings->foothold.shift * leg->length / (float)SHIFTS;
	soleVec3 last = planned ? soleLevelPlace( work, leg ) : leg->landing;
	soleVec3 best = last;
	float least = soleFindShiftCost( work, leg, last ) + soleFindGroundCost( work, leg, last );
	soleTryPlaces( work, leg, leg->landing, apart, last, &best, &least );
	soleTryPlaces( work, leg, best, apart / (float)( SHIFTS + 1 ), last, &best, &least );
	return best;
}

/// The foothold is settled: near the end, unless the landing has moved far away from it.
static bool soleIsSettled( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	soleVec3 apart = soleHorizontal( work, soleSub( soleLevelPlace( work, leg ), leg->landing ) );
	return ( state->flags & sole_statePlanned ) != 0 && leg->stepInput.until < work->settings->foothold.freeze &&
	    soleLength( apart ) < 2.0f * work->settings->foothold.shift * leg->length;
}

/// The foothold is at a place, on the plane that carries the sole there.
static void soleStandStepOn( const solePlaceWork* work, soleLegWork* leg, soleVec3 place, soleRest rest )
{
	soleLegState* state = leg->state;
	place = soleAdd( place, soleTiltShift( work, leg, rest.plane.normal ) );
	place = soleAtHeight( work, place, solePlaneHeight( work, rest.plane, place ) );
	state->stepPlace_w = soleAdd( place, work->root_w );
	state->stepNormal_w = rest.plane.normal;
	state->toeSlope = rest.toeSlope;
	leg->out->confidence = rest.confidence;
	leg->surface = rest.surface;
	leg->surfaceVelocity = rest.velocity;
}

/// Something was met that says where the foothold may be: not just narrow things on the way.
static bool soleHasNews( const solePlaceWork* work, const soleLegWork* leg )
{
	return leg->sampleCount > soleGetLookCount( work->settings );
}

/// Chooses the foothold, or keeps it where nothing new is known. @return false: there is no ground
static bool soleChooseStep( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	bool planned = ( state->flags & sole_statePlanned ) != 0;
	if ( planned && soleHasNews( work, leg ) == false )
	{
		// A body that is not listed goes on as it went.
		leg->surface = state->body.surface;
		leg->surfaceVelocity = ( state->flags & sole_stateRides ) != 0 ? leg->surfaceVelocity : state->body.place;
		return true;
	}
	soleVec3 place = soleChoosePlace( work, leg );
	soleRest rest = soleRestSole( work, leg, soleMakeFootprint( work, place, leg->landingForward, work->up ), false );
	if ( rest.found == false )
	{
		return false;
	}
	soleStandStepOn( work, leg, place, rest );
	state->stepLanding_w = soleAdd( leg->landing, work->root_w );
	return true;
}

/// The plane of a foothold that is settled, as its ground is when it is read closely; but where a toe that just meets a
/// riser, or a heel, would have it stand on the step over it, it stays what was foreseen.
static void soleReadStep( const solePlaceWork* work, soleLegWork* leg )
{
	soleVec3 place = soleLevelPlace( work, leg );
	soleRest rest = soleRestSole( work, leg, soleChosenFootprint( work, leg ), false );
	if ( rest.found )
	{
		if ( soleMeetsNextStep( work, leg, rest.plane, rest.share ) == false )
		{
			soleStandStepOn( work, leg, place, rest );
		}
	}
}

/// A foothold that is just where the animation means it stays there when that is foreseen to be elsewhere.
static void soleFollowLanding( const solePlaceWork* work, const soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleVec3 meant = soleSub( state->stepLanding_w, work->root_w );
	soleVec3 shift = soleHorizontal( work, soleSub( soleLevelPlace( work, leg ), meant ) );
	soleVec3 moved = soleHorizontal( work, soleSub( leg->landing, meant ) );
	if ( soleLength( shift ) < UNSHIFTED * leg->length )
	{
		float climb = soleDot( soleGradientOf( work, state->stepNormal_w ), moved );
		state->stepPlace_w = soleMulAdd( soleAdd( state->stepPlace_w, moved ), climb, work->up );
		state->stepLanding_w = soleAdd( state->stepLanding_w, moved );
	}
}

/// The foot leaves the plane on which it stood.
static void soleSetOut( soleLegWork* leg )
{
	soleLegState* state = leg->state;
	state->flags |= (uint32_t)sole_statePlanned;
	state->flags &= ~(uint32_t)sole_stateChosen;
	for ( int32_t i = 0; i < 3; ++i )
	{
		state->stepLift[i] = state->stepOver[i] = 0.0f; // what is known is of the last step
	}
	state->stepLead = state->stepWait = 0.0f;
}

/// Over what was met, and over what narrow things were met before.
static void soleLiftStep( const solePlaceWork* work, soleLegWork* leg, const soleWay* way, bool news )
{
	soleLegState* state = leg->state;
	float lift[3];
	news ? soleFindLift( work, leg, way, lift ) : soleFindNarrowLift( work, leg, way, lift );
	// A step of its own the animation does not lift.
	float least = state->restep > 0.0f ? RESTEP_LIFT * leg->length : 0.0f;
	for ( int32_t i = 0; i < 3; ++i )
	{
		state->stepOver[i] = news ? state->stepOver[i] : soleMaxF( state->stepOver[i], lift[i] );
		state->stepLift[i] = news ? soleMaxF( lift[i], least ) : state->stepLift[i];
		state->stepLift[i] = soleMaxF( state->stepLift[i], state->stepOver[i] );
	}
}

/// Nothing is seen where a foot is to land: the ground that it comes from goes on, until it asks under itself; but not
/// where none would be looked for.
static void soleLoseSight( const solePlaceWork* work, soleLegWork* leg, solePlane old )
{
	const soleSettings* s = work->settings;
	float over = solePlaneHeight( work, old, leg->soleCenter ) - work->reference;
	bool near = over < s->probe.stepUp * leg->length && over > -s->probe.stepDown * leg->length;
	soleVec3 under = soleAtHeight( work, leg->soleCenter, work->reference );
	leg->hasGround = leg->hadGround && near;
	leg->missed = near;
	leg->raw = near ? old : soleMakePlane( work, under, soleVec( 0.0f, 0.0f, 0.0f ) );
	leg->toeSlope = near ? leg->state->toeSlope : 0.0f;
	leg->state->flags &= ~(uint32_t)sole_statePlanned;
}

/// Sets out, or goes on, to the next foothold.
static void solePlanStep( solePlaceWork* work, soleLegWork* leg, solePlane old )
{
	soleLegState* state = leg->state;
	bool settled = soleIsSettled( work, leg );
	if ( settled == false && soleChooseStep( work, leg ) == false )
	{
		soleLoseSight( work, leg, old );
		return;
	}
	if ( ( state->flags & sole_statePlanned ) == 0 )
	{
		soleSetOut( leg );
	}
	bool news = soleHasNews( work, leg );
	if ( settled || news == false )
	{
		soleFollowLanding( work, leg );
	}
	if ( settled && news )
	{
		soleReadStep( work, leg );
	}
	leg->planned = true;
	leg->hasGround = true;
	state->stepTime = soleShareOfTime( leg );
	soleWay way = soleRememberWay( work, leg );
	leg->stepPlace = way.to;
	leg->stepNormal = state->stepNormal_w;
	leg->toeSlope = state->toeSlope;
	if ( settled == false && leg->sampleCount > 0 )
	{
		soleLiftStep( work, leg, &way, news );
		bool before = news && state->stepTime < SOLE_LEAD_FROM;
		float wait = state->stepTime < SOLE_WAIT_UNTIL ? soleFindWait( work, leg, &way ) : 0.0f;
		state->stepWait = soleMaxF( state->stepWait, wait );
		state->stepLead = before ? soleFindLead( work, leg, &way ) : state->stepLead;
	}
	leg->raw = soleFollowWay( work, leg, &way, leg->soleCenter );
	leg->out->flags |= (uint32_t)sole_legPlanned;
}

// --------------------------------------------------------------------------------------------------------- the stage

/// What the last frame made of the ground, for where the foot is now.
static solePlane soleRememberPlane( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	if ( ( state->flags & sole_statePlanned ) != 0 )
	{
		soleWay way = soleRememberWay( work, leg );
		return soleFollowWay( work, leg, &way, leg->soleCenter );
	}
	soleVec3 gradient = soleGradientOf( work, state->planeNormal_w );
	return soleMakePlane( work, soleSub( state->planePoint_w, work->root_w ), gradient );
}

static soleStand soleStandOnWay( const solePlaceWork* work, const soleLegWork* leg )
{
	float time = soleShareOfTime( leg );
	soleVec3 from = soleSub( leg->state->planePoint_w, work->root_w );
	soleVec3 to = soleSub( leg->state->stepPlace_w, work->root_w );
	return ( soleStand ){ from, to, time, soleGently( time ) };
}

static soleStand soleStandOnPlane( const solePlaceWork* work, soleVec3 place, solePlane plane )
{
	soleVec3 point = soleAtHeight( work, place, solePlaneHeight( work, plane, place ) );
	return ( soleStand ){ point, point, 1.0f, 1.0f };
}

/// Keeps what differs between the last frame's plane and this one's, and lets it decay.
static void soleInertialise( solePlaceWork* work, soleLegWork* leg, solePlane old, float oldToe )
{
	soleLegState* state = leg->state;
	if ( work->first == false )
	{
		const soleSettings* s = work->settings;
		// Where there is no ground, and was none, the reference plane goes with the root: nothing of it is left behind.
		float step = solePlaneHeight( work, old, leg->raw.point ) - soleDot( leg->raw.point, work->up );
		state->height.value += leg->hasGround || leg->hadGround ? step : 0.0f;
		state->gradient.value = soleAdd( state->gradient.value, soleSub( old.gradient, leg->raw.gradient ) );
		bool locked = ( state->flags & sole_stateLocked ) != 0 && leg->hasGround;
		float heightHalfLife = locked ? s->support.plantedHalfLife : s->support.heightHalfLife;
		float gradientHalfLife = locked ? s->support.plantedHalfLife : s->support.gradientHalfLife;
		state->height = soleDecayOffset1( state->height, heightHalfLife, work->timeStep );
		state->gradient = soleDecayOffset3( state->gradient, gradientHalfLife, work->timeStep );
		state->toe.value += oldToe - leg->toeSlope;
		state->toe = soleDecayOffset1( state->toe, s->support.toeHalfLife, work->timeStep );
	}
	state->toeSlope = leg->toeSlope;
	leg->toeSlope += state->toe.value;
	soleVec3 gradient = soleHorizontal( work, soleAdd( leg->raw.gradient, state->gradient.value ) );
	leg->plane = soleMakePlane( work, soleMulAdd( leg->raw.point, state->height.value, work->up ), gradient );
}

void soleChooseFootholds( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		soleLegState* state = leg->state;
		solePlane old = soleRememberPlane( work, leg );
		float oldToe = state->toeSlope;
		leg->hadGround = ( state->flags & sole_stateGround ) != 0;
		soleBridgeMiss( work, leg, old );
		bool flew = ( state->flags & sole_statePlanned ) != 0;
		soleVec3 was = soleSub( state->planePoint_w, work->root_w );
		soleStand onWay = soleStandOnWay( work, leg );
		// It has gone the whole of its last way, or knows of none.
		state->stepTime = leg->touches || work->first ? 1.0f : state->stepTime;
		leg->planned = false;
		if ( leg->foreseen && leg->touches == false )
		{
			solePlanStep( work, leg, old );
		}
		if ( leg->planned == false )
		{
			soleFollowGround( work, leg );
		}
		// One that sets out does so from where it was.
		soleVec3 stood = leg->touches || leg->planned ? was : leg->soleCenter;
		leg->standBefore = flew ? onWay : soleStandOnPlane( work, stood, old );
		leg->stand = leg->planned ? soleStandOnWay( work, leg )
		                          : soleStandOnPlane( work, soleStandPlace( work, leg ), leg->raw );
		state->flags &= ~(uint32_t)sole_stateGround;
		state->flags |= leg->hasGround ? (uint32_t)sole_stateGround : 0u;
		soleInertialise( work, leg, old, oldToe );
		leg->out->flags |= leg->hasGround ? 0u : (uint32_t)sole_legNoGround;
		leg->out->flags |= leg->asleep ? (uint32_t)sole_legAsleep : 0u;
		leg->out->heightDemand = soleDot( leg->plane.point, work->up ) - work->reference;
	}
}
