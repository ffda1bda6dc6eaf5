// SPDX-License-Identifier: MIT
// Pelvis: one offset s along up that all legs can live with.
//
// With d = target - animated hip, dv its part along up and dh the horizontal rest, a leg of length l has its hip at
//   s = dv + sqrt( l^2 - dh^2 )
// That gives each leg a ceiling (l = as long as it may be), a floor (l = as short as it may be) and a wish (l = as long
// as it is animated). The wishes are joined by m M / ( m + M ) between the lowest wish and the lowest ceiling, m the
// distance of their mean from the lowest wish and M that of the ceiling: on gentle ground the pelvis sits between the
// feet, at big steps it goes as high as the lower leg allows. (The idea of a soft choice is that of R. S. Johansen,
// "Automated Semi-Procedural Animation for Character Locomotion", 2009; the formula is derived anew.)
// A leg that is not fully planted has its limits widened by D ( 1 - w ) / w, so that it enters and leaves continuously.
//
// The offset is a spring relative to the root. A root that jumps (steps) or changes its speed does not take the pelvis
// along: the jump is taken off the offset and the change of speed off its velocity, so that the pelvis goes on in the
// world as it went. The legs' limits come after the spring: lag never over-extends a planted leg.
#include "place/place.h"

#define SLACK 0.055f       // D, in leg lengths
#define LEAST_WEIGHT 0.02f // of a free leg: keeps the pelvis with the feet in flight
#define JUMP_SPEED 3.0f    // L/s: a root that moves faster than this beyond its speed has jumped

typedef struct soleWishes
{
	float lowestWish;
	float meanWish;
	float ceiling;
	float floor;
	bool any;
} soleWishes;

static soleWishes soleGatherWishes( const solePlaceWork* work )
{
	soleWishes wishes = { 0.0f, 0.0f, 0.0f, 0.0f, false };
	float weights = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->hasGround == false || !( leg->weight > 0.0f ) )
		{
			continue;
		}
		soleVec3 d = soleSub( leg->ankleTarget, leg->joints[0] );
		float dv = soleDot( d, work->up );
		float dh2 = soleMaxF( soleDot( d, d ) - dv * dv, 0.0f );
		float animated = soleDistance( leg->joints[0], leg->ankle );
		float longest = soleGetReach( work, leg ).soft;
		float shortest = soleMinF( work->settings->leg.fold * leg->length, animated );
		float weight = soleMaxF( leg->state->plantWeight, LEAST_WEIGHT ) * leg->weight;
		float slack = SLACK * leg->length * ( 1.0f - weight ) / weight;

		float wish = dv + soleSqrtF( animated * animated - dh2 );
		float ceiling = dv + soleSqrtF( longest * longest - dh2 ) + slack;
		float floor = dv + soleSqrtF( shortest * shortest - dh2 ) - slack;
		wishes.lowestWish = wishes.any ? soleMinF( wishes.lowestWish, wish + slack ) : wish + slack;
		wishes.ceiling = wishes.any ? soleMinF( wishes.ceiling, ceiling ) : ceiling;
		wishes.floor = wishes.any ? soleMaxF( wishes.floor, floor ) : floor;
		wishes.meanWish += weight * wish;
		weights += weight;
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
	float lowest = soleMinF( wishes.lowestWish, wishes.ceiling );
	float m = soleMaxF( wishes.meanWish - lowest, 0.0f );
	float most = wishes.ceiling - lowest;
	return m + most > 1e-9f ? lowest + m * most / ( m + most ) : lowest;
}

/// Takes the root's jumps and changes of speed out of the pelvis.
static void soleCompensateRoot( solePlaceWork* work, float legLength )
{
	soleState* state = work->state;
	if ( work->first || !( work->timeStep > 0.0f ) )
	{
		return;
	}
	float dt = work->timeStep;
	float step = soleDot( soleSub( work->root_w, state->root_w ), work->up );
	float extra = step - state->rootSpeed * dt;
	float size = extra < 0.0f ? -extra : extra;
	float jump = soleMaxF( work->settings->pelvis.rootJump * legLength, JUMP_SPEED * legLength * dt );
	state->pelvis.value -= extra;
	if ( size <= jump )
	{
		float speed = step / dt;
		state->pelvis.velocity -= speed - state->rootSpeed;
		state->rootSpeed = speed;
	}
}

void soleMovePelvis( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	soleState* state = work->state;
	float legLength = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		legLength = soleMaxF( legLength, work->legs[i].usable ? work->legs[i].length : 0.0f );
	}
	soleCompensateRoot( work, legLength );
	soleWishes wishes = soleGatherWishes( work );
	float goal = soleChooseOffset( wishes );
	if ( work->first )
	{
		state->pelvis = ( soleOffset1 ){ goal, 0.0f };
		state->rootSpeed = 0.0f;
	}
	state->pelvis = soleStepSpring( state->pelvis, goal, 0.0f, s->pelvis.halfLife, work->timeStep );

	float low = -s->pelvis.down * legLength;
	float high = s->pelvis.up * legLength;
	if ( wishes.any )
	{
		low = soleMaxF( low, wishes.floor );
		high = soleMinF( high, wishes.ceiling );
		low = soleMinF( low, high ); // where they cross, reach wins and a leg folds
	}
	if ( state->pelvis.value > high )
	{
		state->pelvis.value = high;
		state->pelvis.velocity = soleMinF( state->pelvis.velocity, 0.0f );
	}
	else if ( state->pelvis.value < low )
	{
		state->pelvis.value = low;
		state->pelvis.velocity = soleMaxF( state->pelvis.velocity, 0.0f );
	}
	float weight = soleClampF( work->frame->weight, 0.0f, 1.0f );
	work->pelvisShift = soleFiniteOr( weight * state->pelvis.value, 0.0f );
}
