// SPDX-License-Identifier: MIT
// Activity: what the character is doing as a whole, and how strongly its feet are placed for that.
//
// Strength is graded, not switched: it falls with the root's speed v, and with the height h of the sole that is nearest
// to the ground under it, as animated,
//   strength = ( 1 + S( v; slow, fast ) ( running - 1 ) ) ( 1 + S( h; low, high ) ( airborne - 1 ) )
// where S goes smoothly from 0 to 1 between its bounds. What the measured speed of a root that is known in steps, or of
// a ground that ends, adds to that in jumps dies away with a half-life; each leg's own blend (weight.c) comes on top.
// Where both shares are 1, which they are unless a host sets them, strength is 1 to the bit.
//
// What is told to the host is a state with hysteresis: running from `fast` on until it is slower than `slow`, in the
// air from `high` on until a sole is lower than `low`. Weights are blended before the ground is known, so they go by
// the strength that the last frame found.
#include "place/place.h"

#define STRENGTH_TIME 0.06f // s, half-life
#define NOTHING 1e-6f       // of strength: less is over, and does not go on among the smallest floats
#define NOWHERE 1e3f        // L: ground that nobody has found is as far down

/// Height of the lowest point of a leg's animated sole over the ground under it. A foot on its way to a foothold that
/// is foreseen has not asked for what is under it now: it is over what it left.
static float soleFindLift( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	soleVec3 lowest = leg->heelRise < leg->ballRise ? leg->heel : leg->ball;
	if ( leg->foreseen && ( state->flags & (uint32_t)sole_stateGround ) != 0 )
	{
		return soleDot( soleSub( lowest, soleSub( state->planePoint_w, work->root_w ) ), work->up );
	}
	return leg->hasGround ? soleDot( lowest, work->up ) - solePlaneHeight( work, leg->raw, lowest )
	                      : NOWHERE * leg->length;
}

/// From 0 at the first bound to 1 at the second.
static float soleGrade( float value, float from, float full )
{
	return soleSmoothly( soleSaturate( ( value - from ) / soleMaxF( full - from, 1e-6f ) ) );
}

static bool soleStays( bool was, float value, float on, float off )
{
	return was ? value > off : value >= on;
}

void soleFindActivity( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	soleState* state = work->state;
	float lift = NOWHERE * soleLongestLeg( work );
	uint32_t was = 0;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		lift = leg->usable ? soleMinF( lift, soleFindLift( work, leg ) ) : lift;
		was |= leg->state->flags;
	}
	float perLength = 1.0f / soleMaxF( soleLongestLeg( work ), 1e-6f );
	float speed = work->rootSpeed * perLength;
	float high = lift * perLength;
	float wanted = 1.0f + soleGrade( speed, s->activity.slow, s->activity.fast ) * ( s->activity.running - 1.0f );
	wanted *= 1.0f + soleGrade( high, s->activity.low, s->activity.high ) * ( s->activity.airborne - 1.0f );
	if ( work->first )
	{
		state->strength = wanted;
	}
	float left = ( state->strength - wanted ) * soleLeftAfter( work->timeStep, STRENGTH_TIME );
	state->strength = left > NOTHING || left < -NOTHING ? wanted + left : wanted;
	bool flies = soleStays( ( was & (uint32_t)sole_stateAirborne ) != 0, high, s->activity.high, s->activity.low );
	bool runs = soleStays( ( was & (uint32_t)sole_stateRunning ) != 0, speed, s->activity.fast, s->activity.slow );
	for ( int32_t i = 0; i < work->legCount && ( work->first || work->timeStep > 0.0f ); ++i )
	{
		uint32_t* flags = &work->legs[i].state->flags;
		*flags &= ~(uint32_t)( sole_stateAirborne | sole_stateRunning );
		*flags |= ( flies ? (uint32_t)sole_stateAirborne : 0u ) | ( runs ? (uint32_t)sole_stateRunning : 0u );
	}
	soleActivity walks = soleIsMoving( work ) ? sole_moving : sole_standing;
	work->out->activity = flies ? sole_airborne : ( runs ? sole_running : walks );
	work->out->strength = state->strength;
}
