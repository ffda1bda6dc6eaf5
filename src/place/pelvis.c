// SPDX-License-Identifier: MIT
// Pelvis: one offset s along up that all legs can live with.
//
// With d = target - animated hip, dv its part along up and dh the horizontal rest, a leg of length l has its hip at
//   s = dv + sqrt( l^2 - dh^2 )
// That gives each leg a ceiling (l = as long as it may be), a floor (l = as short as it may be) and a wish (l = as long
// as it is animated). The wishes of all legs, planted or not, are joined by m M / ( m + M ) between the lowest wish and
// the lowest ceiling, m the distance of their mean from the lowest wish and M that of the ceiling: on gentle ground the
// pelvis sits between the feet, at big steps it goes as high as the lower leg allows. A foot in flight counts as much
// as a planted one, for it is about to land: were it left out, the pelvis would ride up on the rear leg when walking
// down a slope, and fall when the other lands. A foot that is leaving counts less and less as its heel rises, and not
// at all just after it has left: it need not reach any more. (The idea of a soft choice is that of R. S. Johansen,
// "Automated Semi-Procedural Animation for Character Locomotion", 2009; the formula is derived anew.) The limits bind
// by how far a leg is planted: widened by D ( 1 - w ) / w, they come and go continuously.
//
// The offset is a spring relative to the root. A root that jumps (steps) or changes its speed does not take the pelvis
// along: the jump is taken off the offset and the change of speed off its velocity, so that the pelvis goes on in the
// world as it went. The legs' limits come after the spring: its lag over-extends no planted leg. Both move the pelvis
// at a limited speed: where a foot comes down too low too suddenly, it hangs short of the ground for some frames, for a
// body that jumps shows more than a foot that lands late. (Feeding the spring its goal's velocity follows closer but
// doubles the jerk at each change of the goal's pace: tried on ramps and stairs, and left out.)
#include "place/place.h"

#define SLACK 0.055f       // D, in leg lengths
#define LEAST_WEIGHT 0.01f // a leg that is planted less than this does not bind
#define HEEL_DOWN 0.03f    // L: a heel that is animated this low stays as it is
#define HEEL_FREE 0.06f    // L: one that is as much higher is free to be lifted further
#define LEAST_SPREAD 0.03f // L: of what the body stands on, for it to have a slope
#define LEAST_SAY 0.5f     // of a leg that is leaving
#define LEAVING_TIME 0.3f  // s: so long after it has left it need not reach
#define SAY_TIME 0.3f      // s in which a leg gains or loses its say

typedef struct soleWishes
{
	float lowestWish;
	float meanWish;
	float lowestCeiling;
	float ceiling; // of the legs as far as they are planted
	float floor;
	bool any;
} soleWishes;

/// Offset at which the hip is this far from a target.
static float soleOffsetFor( const solePlaceWork* work, const soleLegWork* leg, soleVec3 target, float length )
{
	soleVec3 d = soleSub( target, leg->joints[0] );
	float dv = soleDot( d, work->up );
	float dh2 = soleMaxF( soleDot( d, d ) - dv * dv, 0.0f );
	return dv + soleSqrtF( length * length - dh2 );
}

/// How far the animation has raised the heel of a planted foot, 0 to 1.
static float soleHeelBegun( const soleLegWork* leg )
{
	return soleSaturate( ( leg->heelRise - HEEL_DOWN * leg->length ) / ( HEEL_FREE * leg->length ) );
}

/// Moves each leg's say towards what its contact gives it.
static void soleUpdateSay( const solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	float left = state->time < LEAVING_TIME ? LEAST_SAY : 1.0f;
	float goal = leg->touches ? 1.0f - ( 1.0f - LEAST_SAY ) * soleHeelBegun( leg ) : left;
	// The way to a new goal begins when it became one, within the frame.
	float elapsed = leg->touches != leg->touched ? leg->since : work->timeStep;
	float back = state->time - LEAVING_TIME;
	elapsed = leg->touches == false && back >= 0.0f && back < elapsed ? back : elapsed;
	float step = elapsed / SAY_TIME;
	if ( work->first )
	{
		state->say = leg->touches ? goal : 1.0f;
		return;
	}
	state->say = state->say < goal ? soleMinF( state->say + step, goal ) : soleMaxF( state->say - step, goal );
}

static float soleSlack( const soleLegWork* leg, float weight )
{
	return SLACK * leg->length * ( 1.0f - weight ) / weight;
}

/// The highest offset at which the leg still reaches, with part of its heel lift where the animation has begun to raise
/// the heel by itself. A foot that stands flat stays flat as long as the pelvis can help.
static float soleFindCeiling( const solePlaceWork* work, const soleLegWork* leg )
{
	float longest = soleGetReach( work, leg ).soft;
	float flat = soleOffsetFor( work, leg, leg->ankleTarget, longest );
	float free = leg->state->plantWeight * soleHeelBegun( leg );
	float angle = work->settings->leg.heelLift * work->settings->pelvis.heelFirst * free;
	soleVec3 side = soleRotate( leg->footTarget, leg->rig->footSide );
	soleQuat roll = soleHalfRotation( side, soleHalfFromAngle( -angle ) );
	soleVec3 arm = soleRotate( roll, soleSub( leg->ankleTarget, leg->pivotTarget ) );
	return soleMaxF( flat, soleOffsetFor( work, leg, soleAdd( leg->pivotTarget, arm ), longest ) );
}

static soleWishes soleGatherWishes( const solePlaceWork* work )
{
	soleWishes wishes = { 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, false };
	float weights = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->hasGround == false || !( leg->weight > 0.0f ) )
		{
			continue;
		}
		float animated = soleDistance( leg->joints[0], leg->ankle );
		float shortest = soleMinF( work->settings->leg.fold * leg->length, animated );
		float planted = soleMaxF( leg->state->plantWeight, LEAST_WEIGHT );
		float say = soleMaxF( leg->state->say, LEAST_WEIGHT );

		float wish = soleOffsetFor( work, leg, leg->ankleTarget, animated );
		float ceiling = soleFindCeiling( work, leg );
		float bound = ceiling + soleSlack( leg, planted );
		float wished = wish + soleSlack( leg, say );
		float said = ceiling + soleSlack( leg, say );
		float floor = soleOffsetFor( work, leg, leg->ankleTarget, shortest ) - soleSlack( leg, planted );
		wishes.lowestWish = wishes.any ? soleMinF( wishes.lowestWish, wished ) : wished;
		wishes.lowestCeiling = wishes.any ? soleMinF( wishes.lowestCeiling, said ) : said;
		wishes.ceiling = wishes.any ? soleMinF( wishes.ceiling, bound ) : bound;
		wishes.floor = wishes.any ? soleMaxF( wishes.floor, floor ) : floor;
		wishes.meanWish += say * leg->weight * wish;
		weights += say * leg->weight;
		wishes.any = true;
	}
	wishes.meanWish = weights > 0.0f ? wishes.meanWish / weights : 0.0f;
	return wishes;
}

static float soleChooseOffset( soleWishes wishes )
{
	if ( wishes.any == false )
	{
		return 0.0f;
	}
	// Legs that have little to say have their wishes widened upwards: the mean is never below the lowest.
	float lowest = soleMinF( soleMinF( wishes.lowestWish, wishes.meanWish ), wishes.lowestCeiling );
	float m = soleMaxF( wishes.meanWish - lowest, 0.0f );
	float most = wishes.lowestCeiling - lowest;
	return m + most > 1e-9f ? lowest + m * most / ( m + most ) : lowest;
}

// ----------------------------------------------------------------------------------------------------- body height

/// Height of the ground that the body is over: of the line through what its legs stand on, by least squares, at the
/// pelvis. The reference height where it stands on nothing.
static float soleFindBodyGround( const solePlaceWork* work, bool before )
{
	soleVec3 pelvis = work->slots[work->rig->pelvisSlot].translation;
	soleVec3 ahead = soleAnyOrthogonal( work->up );
	soleVec3 aside = soleCross( work->up, ahead );
	float w = 0.0f, u = 0.0f, v = 0.0f, h = 0.0f;
	float uu = 0.0f, uv = 0.0f, vv = 0.0f, uh = 0.0f, vh = 0.0f;
	for ( int32_t i = 0; i < 2 * work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i / 2;
		const soleStand* stand = before ? &leg->standBefore : &leg->stand;
		bool counts = leg->usable && ( before ? leg->hadGround : leg->hasGround );
		float weight = counts ? leg->weight * ( i % 2 == 0 ? 1.0f - stand->share : stand->share ) : 0.0f;
		soleVec3 from = soleSub( i % 2 == 0 ? stand->from : stand->to, pelvis );
		float du = soleDot( from, ahead ), dv = soleDot( from, aside ), dh = soleDot( from, work->up );
		w += weight;
		u += weight * du;
		v += weight * dv;
		h += weight * dh;
		uu += weight * du * du;
		uv += weight * du * dv;
		vv += weight * dv * dv;
		uh += weight * du * dh;
		vh += weight * dv * dh;
	}
	if ( !( w > 0.0f ) )
	{
		return work->reference;
	}
	float perWeight = 1.0f / w;
	u *= perWeight;
	v *= perWeight;
	h *= perWeight;
	uu = uu * perWeight - u * u;
	uv = uv * perWeight - u * v;
	vv = vv * perWeight - v * v;
	uh = uh * perWeight - u * h;
	vh = vh * perWeight - v * h;
	// Along the axis on which they lie furthest apart only: across it they say nothing.
	soleHalf axis = soleMakeHalf( uu - vv, 2.0f * uv );
	float spread = axis.c * axis.c * uu + 2.0f * axis.c * axis.s * uv + axis.s * axis.s * vv;
	float slope = ( axis.c * uh + axis.s * vh ) / ( spread + work->bodyLeast );
	return soleDot( pelvis, work->up ) + h - slope * ( axis.c * u + axis.s * v );
}

/// An offset within what the planted legs allow. Where their limits cross, reach wins and a leg folds.
static float soleBind( soleWishes wishes, float offset )
{
	return wishes.any ? soleMinF( soleMaxF( offset, wishes.floor ), wishes.ceiling ) : offset;
}

/// One step towards the goal, by at most `most`.
static void soleFollow( solePlaceWork* work, soleWishes wishes, float goal, float most )
{
	soleState* state = work->state;
	float start = state->pelvis.value;
	bool up = goal > start;
	float halfLife = up ? work->settings->pelvis.release : work->settings->pelvis.halfLife;
	soleOffset1 spring = soleStepSpring( state->pelvis, goal, 0.0f, halfLife, work->timeStep );
	float step = soleClampF( soleBind( wishes, spring.value ) - start, -most, most );
	state->pelvis.value = start + step;
	state->pelvis.velocity = start + step == spring.value ? spring.velocity : step / work->timeStep;
}

void soleMovePelvis( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	soleState* state = work->state;
	float legLength = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleUpdateSay( work, work->legs + i );
		legLength = soleMaxF( legLength, work->legs[i].usable ? work->legs[i].length : 0.0f );
	}
	work->bodyLeast = LEAST_SPREAD * LEAST_SPREAD * legLength * legLength;
	float before = soleFindBodyGround( work, true );
	float ground = soleFindBodyGround( work, false );
	float over = ground - work->reference;
	soleWishes wishes = soleGatherWishes( work );
	wishes.ceiling -= over;
	wishes.floor -= over;
	float goal = soleClampF( soleChooseOffset( wishes ) - over, -s->pelvis.down * legLength, s->pelvis.up * legLength );
	goal = wishes.any ? goal : 0.0f;
	if ( work->first )
	{
		state->pelvis = ( soleOffset1 ){ soleBind( wishes, goal ), 0.0f };
	}
	else if ( work->timeStep > 0.0f )
	{
		state->pelvis.value += before - ground;
		soleFollow( work, wishes, goal, s->pelvis.speed * legLength * work->timeStep );
	}
	float weight = soleClampF( work->frame->weight, 0.0f, 1.0f );
	work->pelvisShift = soleFiniteOr( weight * ( over + state->pelvis.value ), 0.0f );
}
