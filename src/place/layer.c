// SPDX-License-Identifier: MIT
// Layer: what a host without a second pose gets for ground that is much higher under one foot than under another. The
// same demand w that blends a second pose in (second.c) drives three small changes, each off unless it is set.
//
// Lean. With g the gradient of the ground that the body is over, horizontal and uphill, which is known anew with each
// foothold and so taken up with a half-life, the trunk is tilted so that its axis goes from up to
//   up + t,  t = lean w g                                                             (tan of the angle: |t|)
// towards the higher foot, as a climber's is; down steps that is backwards. The turn is handed out for the joint that
// carries the trunk, in the pelvis's space: q = P^-1 FromTo( up, up + t ) P, P the pelvis's rotation.
//
// Hips. They go the other way, by hips w g. Of two legs that stand d apart and h above one another, the lower is the
// longer one: with x its foot's horizontal distance from the hip it lets the hip be sqrt( l^2 - x^2 ) high. Moving away
// from the higher foot makes x smaller and the higher leg's own distance larger: the pelvis stays higher, and the upper
// knee folds less by both. Head, arms and trunk are 0.68 of a body's mass, 0.37 leg lengths over the hips: hips of 0.25
// lean keep its centre where it was.
//
// Knee. A foot on its way up to a foothold is lifted further in the middle of its way, by a share of its rise r,
//   knee w r 16 u^2 ( 1 - u )^2,  u the share of its time
// which sets out and arrives without speed: footholds stay where they are.
#include "place/place.h"

#define MOST_TILT 0.45f // tan of the furthest lean, 24 degrees
#define NOTHING 1e-6f   // of a slope: less is over, and does not go on among the smallest floats

static void soleLean( solePlaceWork* work, soleVec3 slope )
{
	float share = work->weight * work->settings->layer.lean;
	float length = share * soleLength( slope );
	share *= length > MOST_TILT ? MOST_TILT / length : 1.0f;
	soleVec3 axis = soleNormalizeOr( soleMulAdd( work->up, share, slope ), work->up );
	soleQuat pelvis = work->slots[work->rig->pelvisSlot].rotation;
	soleQuat lean = soleMulQuat( soleFromTo( work->up, axis, work->level ), pelvis );
	work->out->lean_l = soleNormalizeQuat( soleMulQuat( soleConjugate( pelvis ), lean ) );
}

static void soleLiftKnee( solePlaceWork* work, soleLegWork* leg, float demand )
{
	float rise = soleDot( soleSub( leg->stand.to, leg->stand.from ), work->up );
	float way = leg->stand.time * ( 1.0f - leg->stand.time );
	float lift = leg->planned ? work->settings->layer.knee * demand * soleMaxF( rise, 0.0f ) * 16.0f * way * way : 0.0f;
	soleVec3 raise = soleScale( lift * leg->weight, work->up );
	leg->ankleTarget = soleAdd( leg->ankleTarget, raise );
	leg->pivotTarget = soleAdd( leg->pivotTarget, raise );
}

void soleAddLayer( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	if ( !soleHasLayer( s ) )
	{
		return;
	}
	soleState* state = work->state;
	float demand = state->second.value;
	float halfLife = soleMaxF( s->target.secondTime, 1e-6f );
	float left = work->first ? 0.0f : soleLeftAfter( work->timeStep, halfLife );
	soleVec3 off = soleScale( left, soleSub( soleHorizontal( work, state->leanSlope ), state->bodyGradient ) );
	off = soleDot( off, off ) > NOTHING * NOTHING ? off : soleVec( 0.0f, 0.0f, 0.0f );
	state->leanSlope = soleAdd( state->bodyGradient, off );
	soleVec3 slope = soleScale( demand, state->leanSlope );
	if ( s->layer.lean > 0.0f )
	{
		soleLean( work, slope );
	}
	if ( s->layer.hips > 0.0f )
	{
		work->hipShift = soleScale( -s->layer.hips * soleLongestLeg( work ), slope );
	}
	for ( int32_t i = 0; i < work->legCount && s->layer.knee > 0.0f; ++i )
	{
		if ( work->legs[i].usable )
		{
			soleLiftKnee( work, work->legs + i, demand );
		}
	}
}
