// SPDX-License-Identifier: MIT
// Support: the answers of the ground, read; and the plane that carries each sole where it is.
//
// What counts as ground: faces that look up at least a little. Ceilings, walls met from the side, loose things smaller
// than the setting and casts that began inside something are left out; the sole then rests on what the others say.
#include "place/rest.h"

// ------------------------------------------------------------------------------------------------ reading the hits

/// The height of the touched face over the place that was asked for, not over the place that was touched: a sphere
/// touches off its axis. @return false: it is no ground
static bool soleReadHit(
    const solePlaceWork* work, const soleLegWork* leg, const soleHit* hit, float minimumUp, soleGroundSample* sample )
{
	bool finite = soleVec3_IsFinite( hit->point_w ) && soleVec3_IsFinite( hit->normal_w );
	bool loose = hit->size > 0.0f && hit->size < work->settings->probe.looseSize * leg->length;
	if ( hit->hit == false || finite == false || hit->startedInside || loose )
	{
		return false;
	}
	soleVec3 normal = soleNormalizeOr( hit->normal_w, work->up );
	float normalUp = soleDot( normal, work->up );
	if ( !( normalUp > 1e-3f ) )
	{
		return false;
	}
	soleVec3 point = soleSub( hit->point_w, work->root_w );
	soleVec3 across = soleHorizontal( work, soleSub( sample->place, point ) );
	sample->steep = !( normalUp >= minimumUp );
	sample->gradient = soleScale( -1.0f / normalUp, soleHorizontal( work, normal ) );
	sample->height = soleDot( point, work->up );
	sample->height += sample->steep ? 0.0f : soleDot( across, sample->gradient );
	sample->surface = hit->surface;
	sample->velocity = soleVec3_IsFinite( hit->velocity_w ) ? hit->velocity_w : soleVec( 0.0f, 0.0f, 0.0f );
	// What is as far off as no probe reaches was not asked for.
	float reach = 2.0f * ( work->settings->probe.stepUp + work->settings->probe.stepDown ) * leg->length;
	float over = sample->height - work->reference;
	return over < reach && over > -reach;
}

/// Something was met, or asked for.
static bool soleWasCast( const soleHit* hit )
{
	uint32_t asked[3];
	memcpy( asked, &hit->asked_w, sizeof asked );
	// Zero of either sign: no bit is set but the highest.
	return hit->hit || ( asked[0] | asked[1] | asked[2] ) << 1 != 0;
}

static void soleReadSamples(
    const solePlaceWork* work, soleLegWork* leg, const soleHit* hits, int32_t hitCount, float minimumUp )
{
	leg->sampleCount = 0;
	leg->hasGround = false;
	for ( int32_t i = 0; i < hitCount; ++i )
	{
		const soleHit* hit = hits + i;
		if ( soleWasCast( hit ) == false )
		{
			continue;
		}
		soleVec3 asked = soleVec3_IsFinite( hit->asked_w ) ? hit->asked_w : hit->point_w;
		soleGroundSample* sample = leg->samples + leg->sampleCount;
		*sample = ( soleGroundSample ){ .place = soleSub( asked, work->root_w ), .surface = SOLE_NONE };
		sample->found = soleReadHit( work, leg, hit, minimumUp, sample );
		leg->out->flags |= hit->startedInside ? (uint32_t)sole_legInside : 0u;
		leg->hasGround = leg->hasGround || sample->found;
		leg->sampleCount += soleVec3_IsFinite( sample->place ) ? 1 : 0;
	}
}

/// A foot in flight that the host says is one, to a foothold that is foreseen: what is under it now does not matter.
static bool soleIsOnItsWay( const soleLegWork* leg )
{
	const soleContactInput* told = &leg->contactInput;
	bool free = told->heel >= 0.0f && told->heel < 0.5f && told->toe >= 0.0f && told->toe < 0.5f;
	return free && leg->foreseen;
}

static void soleCountUnmet( solePlaceWork* work )
{
	bool met = false;
	bool asked = false;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		met = met || work->legs[i].hasGround;
		asked = asked || work->legs[i].sampleCount > 0;
	}
	soleState* state = work->state;
	state->unmetTime = met ? 0.0f : state->unmetTime + ( asked ? work->timeStep : 0.0f );
	work->out->unmetTime = state->unmetTime;
}

// --------------------------------------------------------------------------------------------------------- the stage

void soleFindSupport( solePlaceWork* work, const soleLegHits* hits )
{
	soleHalf limit = work->angles.walkable;
	float minimumUp = limit.c * limit.c - limit.s * limit.s;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		leg->samples = work->samples[i];
		int32_t first = hits->starts[i];
		soleReadSamples( work, leg, hits->hits + first, hits->starts[i + 1] - first, minimumUp );
		if ( soleIsOnItsWay( leg ) )
		{
			leg->surface = SOLE_NONE;
			continue;
		}
		soleRest rest = soleRestSole( work, leg, leg->print, false );
		leg->raw = rest.plane;
		leg->toeSlope = rest.toeSlope;
		leg->share = rest.share;
		leg->surface = rest.surface;
		leg->surfaceVelocity = rest.velocity;
		leg->out->confidence = rest.confidence;
		leg->out->flags |= rest.onEdge ? (uint32_t)sole_legOnEdge : 0u;
		leg->out->flags |= rest.steep ? (uint32_t)sole_legTooSteep : 0u;
	}
	soleCountUnmet( work );
}
