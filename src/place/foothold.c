// SPDX-License-Identifier: MIT
// Foothold: where the next step lands, and the plane that a foot follows on its way there.
//
// Where. The host tells, from the clip, when the foot comes down and where the animation means it to: its landing. Of
// places along the foot around the landing, within foothold.shift, the one is taken that costs least,
//   cost = 2 distance + max( 0, share - bearing share ) + 10 max( 0, depth - 2 mm )     lengths in leg lengths / 0.9
// so that a sole does not hang over an edge when a small shift helps. The place taken last is one of them, and keeps
// its rank unless another is better by MUCH; near the end it is settled. The foot travels there in flight: it need not
// slide once it is down.
//
// The way. From the plane on which the foot stood to the one on which it will, the height of the ground under it goes
// along the chord between both places, by the share s of the way that it has come (by the share of the time where both
// are close together), raised over what lies between by  rise * 4 s (1 - s);  the slope goes over smoothly with time.
// On an even slope that is the slope itself.
//
// A foot that is not foreseen follows the ground under it. It has to pass over what comes: where the ground that its
// toes will be over soon is higher than its plane, the plane is raised by as much. What rises gently is no obstacle.
//
// Either way what differs between the ground as the last frame had it and as it is now is inertialised: kept as an
// offset that decays. Slopes pass without lag, since the old plane already foretold them; steps are taken up softly by
// a foot in flight, quickly by a planted one.
#include "place/rest.h"

#define GENTLE 0.5f      // rise per length
#define MUCH 0.02f       // of cost
#define DEPTH 0.0022f    // L
#define SHIFTS 4         // to either side
#define BY_TIME 0.25f    // L: a step shorter than this goes by time
#define STEEP_COST 1.0f  // of a place that cannot be walked on
#define MID_FLIGHT 0.36f // 4 s (1 - s) where the way may begin to rise over what lies between: s from 0.1 to 0.9

// ---------------------------------------------------------------------------------------------------------- the way

/// From where to where, and how far along.
typedef struct soleWay
{
	soleVec3 from;
	soleVec3 to;
	soleVec3 fromGradient;
	soleVec3 toGradient;
	float rise;
} soleWay;

static soleVec3 soleGradientOf( const solePlaceWork* work, soleVec3 normal )
{
	float up = soleMaxF( soleDot( normal, work->up ), 0.05f );
	return soleScale( -1.0f / up, soleHorizontal( work, normal ) );
}

static soleWay soleRememberWay( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	return ( soleWay ){
		soleSub( state->planePoint_w, work->root_w ),
		soleSub( state->stepPlace_w, work->root_w ),
		soleGradientOf( work, state->planeNormal_w ),
		soleGradientOf( work, state->stepNormal_w ),
		state->stepRise,
	};
}

static float soleShareOfTime( const soleLegWork* leg )
{
	float whole = leg->stepInput.since + leg->stepInput.until;
	// A foot that has come down has gone the whole way.
	return leg->foreseen == false ? 1.0f : ( whole > 0.0f ? leg->stepInput.since / whole : 1.0f );
}

static float soleShareOfWay( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, soleVec3 place )
{
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length2 = soleDot( d, d );
	float least = BY_TIME * leg->length;
	float byTime = soleShareOfTime( leg );
	float byWay =
	    soleSaturate( soleDot( soleSub( place, way->from ), d ) / soleMaxF( length2, 1e-4f * least * least ) );
	return byTime + soleSaturate( soleSqrtF( length2 ) / least ) * ( byWay - byTime );
}

/// The plane at a place on the way.
static solePlane soleFollowWay( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, soleVec3 place )
{
	float s = soleShareOfWay( work, leg, way, place );
	float t = soleShareOfTime( leg );
	float smooth = t * t * ( 3.0f - 2.0f * t );
	soleVec3 gradient = soleLerp( way->fromGradient, way->toGradient, smooth );
	soleVec3 chord = soleLerp( way->from, way->to, s );
	float height = soleDot( chord, work->up ) + way->rise * ( 4.0f * s * ( 1.0f - s ) );
	height += soleDot( gradient, soleSub( place, chord ) );
	return soleMakePlane( work, soleAtHeight( work, place, height ), gradient );
}

/// By how much the way has to be raised so that neither heel nor toes meet what lies between its ends.
static float soleFindRise( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way )
{
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length = soleLength( d );
	float rise = 0.0f;
	if ( length < BY_TIME * leg->length )
	{
		return 0.0f;
	}
	const float spans[3] = { leg->rig->heelBehind * work->rootScale / length, 0.0f,
		-leg->rig->toeAhead * work->rootScale / length };
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 from = soleSub( sample->place, way->from );
		float at = soleDot( from, d ) / ( length * length );
		for ( int32_t k = 0; k < 3 && sample->found; ++k )
		{
			float s = at + spans[k];
			float bump = 4.0f * s * ( 1.0f - s );
			if ( bump >= MID_FLIGHT )
			{
				// A foot that flies in parallel to the slope under it.
				soleVec3 ball = soleLerp( way->from, way->to, s );
				soleVec3 gradient = soleLerp( way->fromGradient, way->toGradient, s );
				float height = soleDot( ball, work->up ) - spans[k] * soleDot( gradient, d );
				rise = soleMaxF( rise, ( sample->height - height ) / bump );
			}
		}
	}
	return soleMinF( rise, work->settings->probe.stepUp * leg->length );
}

// ----------------------------------------------------------------------------------------------------------- where

static float soleCostOf( const solePlaceWork* work, const soleLegWork* leg, soleVec3 place )
{
	float metre = 0.9f / leg->length;
	soleRest rest = soleRestSole( work, leg, place, leg->landingForward, true );
	float distance = soleLength( soleHorizontal( work, soleSub( place, leg->landing ) ) );
	float cost = 2.0f * metre * distance + soleMaxF( work->settings->foothold.share - rest.share, 0.0f );
	cost += 10.0f * metre * soleMaxF( rest.sunk - DEPTH * leg->length, 0.0f );
	return cost + ( rest.found && rest.steep == false ? 0.0f : STEEP_COST );
}

static soleVec3 soleChoosePlace( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	bool planned = ( state->flags & sole_statePlanned ) != 0;
	soleVec3 before = soleSub( state->stepPlace_w, work->root_w );
	float most = work->settings->foothold.shift * leg->length;
	soleVec3 apart = soleHorizontal( work, soleSub( before, leg->landing ) );
	if ( planned && leg->stepInput.until < work->settings->foothold.freeze && soleLength( apart ) < 2.0f * most )
	{
		return before;
	}
	soleVec3 best = planned ? before : leg->landing;
	float least = soleCostOf( work, leg, best ) - ( planned ? MUCH : 0.0f );
	for ( int32_t i = 0; i < 2 * SHIFTS + 1; ++i )
	{
		// 0, 1, -1, 2, -2 ...: of equals the nearest.
		float step = (float)( i % 2 == 1 ? ( i + 1 ) / 2 : -i / 2 ) / (float)SHIFTS;
		soleVec3 place = soleMulAdd( leg->landing, step * most, leg->landingForward );
		float cost = soleCostOf( work, leg, place );
		if ( cost < least )
		{
			least = cost;
			best = place;
		}
	}
	return best;
}

/// Sets out, or goes on, to the next foothold.
static void solePlanStep( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	soleVec3 place = soleChoosePlace( work, leg );
	soleRest rest = soleRestSole( work, leg, place, leg->landingForward, false );
	leg->hasGround = rest.found;
	if ( rest.found == false )
	{
		state->flags &= ~(uint32_t)sole_statePlanned;
		return;
	}
	if ( ( state->flags & sole_statePlanned ) == 0 )
	{
		soleVec3 gradient = soleGradientOf( work, state->planeNormal_w );
		solePlane plane = soleMakePlane( work, soleSub( state->planePoint_w, work->root_w ), gradient );
		soleVec3 from = soleAtHeight( work, leg->soleCenter, solePlaneHeight( work, plane, leg->soleCenter ) );
		state->planePoint_w = soleAdd( from, work->root_w );
		state->flags |= (uint32_t)sole_statePlanned;
	}
	leg->planned = true;
	leg->stepPlace = soleAtHeight( work, place, solePlaneHeight( work, rest.plane, place ) );
	state->stepPlace_w = soleAdd( leg->stepPlace, work->root_w );
	leg->stepNormal = rest.plane.normal;
	state->stepNormal_w = leg->stepNormal;
	soleWay way = soleRememberWay( work, leg );
	state->stepRise = soleFindRise( work, leg, &way );
	way.rise = state->stepRise;
	leg->raw = soleFollowWay( work, leg, &way, leg->soleCenter );
	leg->toeSlope = rest.toeSlope;
	leg->out->confidence = rest.confidence;
	leg->out->flags |= (uint32_t)sole_legPlanned;
}

// ----------------------------------------------------------------------------------------------------- not foreseen

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

static soleStand soleStandOnWay( const soleLegWork* leg, const soleWay* way )
{
	float time = soleShareOfTime( leg );
	return ( soleStand ){ way->from, way->to, time, soleSmoothly( time ) };
}

static soleStand soleStandOnPlane( const solePlaceWork* work, soleVec3 place, solePlane plane )
{
	soleVec3 point = soleAtHeight( work, place, solePlaneHeight( work, plane, place ) );
	return ( soleStand ){ point, point, 1.0f, 1.0f };
}

/// Keeps what differs between the last frame's plane and this one's, and lets it decay.
static void soleInertialise( solePlaceWork* work, soleLegWork* leg, solePlane old )
{
	soleLegState* state = leg->state;
	if ( work->first == false )
	{
		const soleSettings* s = work->settings;
		state->height.value += solePlaneHeight( work, old, leg->raw.point ) - soleDot( leg->raw.point, work->up );
		state->gradient.value = soleAdd( state->gradient.value, soleSub( old.gradient, leg->raw.gradient ) );
		bool locked = ( state->flags & sole_stateLocked ) != 0;
		float heightHalfLife = locked ? s->support.plantedHalfLife : s->support.heightHalfLife;
		float gradientHalfLife = locked ? s->support.plantedHalfLife : s->support.gradientHalfLife;
		state->height = soleDecayOffset1( state->height, heightHalfLife, work->timeStep );
		state->gradient = soleDecayOffset3( state->gradient, gradientHalfLife, work->timeStep );
	}
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
		leg->hadGround = ( state->flags & sole_stateGround ) != 0;
		soleWay wayBefore = soleRememberWay( work, leg );
		leg->standBefore = ( state->flags & sole_statePlanned ) != 0 ? soleStandOnWay( leg, &wayBefore )
		                                                             : soleStandOnPlane( work, leg->soleCenter, old );
		leg->planned = false;
		if ( leg->foreseen && leg->touches == false )
		{
			solePlanStep( work, leg );
		}
		else
		{
			state->flags &= ~(uint32_t)sole_statePlanned;
		}
		if ( leg->planned == false )
		{
			leg->raw.point = soleMulAdd( leg->raw.point, soleFindObstacle( work, leg ), work->up );
			state->planePoint_w = soleAdd( leg->raw.point, work->root_w );
			state->planeNormal_w = leg->raw.normal;
		}
		soleWay way = soleRememberWay( work, leg );
		leg->stand = leg->planned ? soleStandOnWay( leg, &way ) : soleStandOnPlane( work, leg->soleCenter, leg->raw );
		state->flags &= ~(uint32_t)sole_stateGround;
		state->flags |= leg->hasGround ? (uint32_t)sole_stateGround : 0u;
		soleInertialise( work, leg, old );
		leg->out->heightDemand = soleDot( leg->plane.point, work->up ) - work->reference;
	}
}
