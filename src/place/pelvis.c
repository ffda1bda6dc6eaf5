// SPDX-License-Identifier: MIT
// Pelvis: one height that all legs can live with.
//
// Over the ground that the body is over the pelvis stays as high as the animation has it, unless a leg could not reach.
// With d = target - animated hip, dv its part along up and dh the horizontal rest, a leg of length l has its hip at
//   s = dv + sqrt( l^2 - dh^2 )
// which gives each leg a ceiling (l as long as it may be) and a floor (l as short as it may be). The lowest ceiling is
// where the pelvis has to go, a little less steeply near zero. It keeps the lowest that a step needed until steps need
// it no more, so that it does not bob with each of them; a spring takes it there. Limits bind by how far a leg is
// planted, or how near to coming down: widened by D ( 1 - w ) / w they come and go continuously.
//
// The legs' limits come after the spring too: its lag over-extends no planted leg, and lifts no heel that stands; so
// that they seldom bind the goal allows for what a foot that stands will need when the spring is there. Both move the
// pelvis at a limited speed: where a foot comes down too low too suddenly, it hangs short of the ground for some
// frames, for a body that jumps shows more than a foot that lands late.
#include "place/place.h"

#define SLACK 0.055f       // D, in leg lengths
#define LEAST_WEIGHT 0.01f // a leg that is planted less than this does not bind
#define HEEL_DOWN 0.03f    // L: a heel that is animated this low stays as it is
#define HEEL_FREE 0.06f    // L: one that is as much higher is free to be lifted further
#define AGAIN 0.011f       // L: a step that needs so little less needs the same again
#define SAME 1e-5f         // L
#define SEEN 0.3f          // s: kept no longer where the step under way needs much less
#define MUCH_LESS 0.15f    // L
#define FREE 1e3f          // L
#define CARRIED 0.8f // share of the most that the ground may use up: on steep stairs some is left to catch up with
#define STANDING_TIME 0.3f // s
#define STANDING_IN 0.5f   // s
#define STANDING_OUT 0.2f  // s
#define LEAST_TIME 1e-3f   // s
#define PEAK 1.3f          // the body's ground is so much faster half-way than on the mean
#define MARGIN 0.011f      // L: it goes a quarter of this lower than it has to, to be there in time

/// Offset at which the hip is this far from a target.
static float soleOffsetFor( const solePlaceWork* work, const soleLegWork* leg, soleVec3 target, float length )
{
	soleVec3 d = soleSub( target, soleAdd( leg->joints[0], work->balance ) );
	float dv = soleDot( d, work->up );
	float dh2 = soleMaxF( soleDot( d, d ) - dv * dv, 0.0f );
	return dv + soleSqrtF( length * length - dh2 );
}

/// How far the animation has raised the heel of a planted foot, 0 to 1.
static float soleHeelBegun( const soleLegWork* leg )
{
	return soleSaturate( ( leg->heelRise - HEEL_DOWN * leg->length ) / ( HEEL_FREE * leg->length ) );
}

static float soleSlack( const soleLegWork* leg, float weight )
{
	return SLACK * leg->length * ( 1.0f - weight ) / weight;
}

/// The highest offset at which the leg still reaches with its heel raised by a share of what is allowed.
static float soleFindCeiling( const solePlaceWork* work, const soleLegWork* leg, float longest, float share )
{
	float flat = soleOffsetFor( work, leg, leg->ankleTarget, longest );
	float angle = work->settings->leg.heelLift * share;
	soleVec3 arm = soleSub( leg->ankleTarget, leg->pivotTarget );
	if ( angle > 0.0f )
	{
		soleVec3 side = soleRotate( leg->footTarget, leg->rig->footSide );
		arm = soleRotate( soleHalfRotation( side, soleHalfFromAngle( -angle ) ), arm );
	}
	return soleMaxF( flat, soleOffsetFor( work, leg, soleAdd( leg->pivotTarget, arm ), longest ) );
}

/// The same for when a foot will come down: its flat sole on the chosen foothold, the hip moved on as the root will. A
/// foot comes down as the animation has it, heel first perhaps, and not flat: by how much that matters shows where the
/// animation means it to land.
static float soleFindLandingCeiling( const solePlaceWork* work, const soleLegWork* leg, float longest )
{
	const soleRigLeg* rig = leg->rig;
	soleVec3 behind = soleMulAdd( leg->travel, rig->ankleBehind * work->rootScale, leg->landingForward );
	float height = rig->ankleHeight * work->rootScale;
	soleVec3 ankle = soleMulAdd( soleSub( leg->stepPlace, behind ), height, leg->stepNormal );
	soleVec3 meant = soleAtHeight( work, soleSub( leg->landing, behind ), work->reference + height );
	float own = soleOffsetFor( work, leg, meant, longest );
	return soleOffsetFor( work, leg, ankle, longest ) - soleMinF( own, 0.0f );
}

/// The same of a foot that stands flat when the springs that are set out for now have come to their goals: the hip has
/// moved on against the foot as it is animated, and the body is over other ground. As far as the animation itself would
/// be out of reach by then it will have raised the heel.
static float soleFindLaterCeiling( const solePlaceWork* work, const soleLegWork* leg, float longest )
{
	float time = work->settings->pelvis.halfLife;
	soleVec3 travel = soleScale( time, soleSub( work->rootVelocity, leg->ballVelocity ) );
	float own = soleOffsetFor( work, leg, soleSub( leg->ankle, travel ), longest );
	float later = soleOffsetFor( work, leg, soleSub( leg->ankleTarget, travel ), longest ) - soleMinF( own, 0.0f );
	return later - ( soleForeseeBodyGround( work, travel, time ) - work->bodyGround );
}

/// Where the pelvis has to be when a foot comes down, over the ground that the body will be over then. It goes there as
/// the foot does, and begins early enough to be there in time: at the speed that the ground's own way leaves to it
/// (none where that goes faster down; then it has to be lower beforehand), its springs' lag included.
static void soleFindLandingBounds(
    const solePlaceWork* work, const soleLegWork* leg, float longest, float over, soleBounds* bounds )
{
	const soleSettings* s = work->settings;
	float ahead = soleForeseeBodyGround( work, leg->travel, leg->stepInput.until ) - work->reference;
	float landing = soleFindLandingCeiling( work, leg, longest ) - ahead;
	float near = soleSmoothly( soleSaturate( leg->stand.time ) );
	float until = soleMaxF( leg->stepInput.until, LEAST_TIME );
	float pace = s->pelvis.speed * soleLongestLeg( work ) + PEAK * ( ahead - over ) / until;
	float still = landing + pace * soleMaxF( until - s->pelvis.halfLife, 0.0f );
	bounds->landing = soleMinF( bounds->landing, soleMinF( near * landing, still ) );
	bounds->step = soleMinF( bounds->step, landing );
	bounds->stepping = true;
}

static soleBounds soleFindBounds( const solePlaceWork* work, float over )
{
	soleBounds bounds = { .any = false };
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->hasGround == false || !( leg->weight > 0.0f ) )
		{
			continue;
		}
		soleReach reach = soleGetReach( work, leg );
		float animated = soleDistance( leg->joints[0], leg->ankle );
		float shortest = soleMinF( work->settings->leg.fold * leg->length, animated );
		float planted = soleMaxF( leg->state->plantWeight, LEAST_WEIGHT );
		float slack = soleSlack( leg, planted );
		// Heels that the animation has begun to raise may be raised further; a foot that stands flat stays flat.
		float begun = soleHeelBegun( leg );
		float raised = planted * begun;
		float ceiling = soleFindCeiling( work, leg, reach.soft, raised * work->settings->pelvis.heelFirst ) + slack;
		float longest = reach.soft + begun * ( reach.hard - reach.soft );
		float most = soleFindCeiling( work, leg, longest, raised ) + slack;
		if ( leg->planted )
		{
			float later = soleFindLaterCeiling( work, leg, reach.soft ) + slack;
			ceiling += ( 1.0f - begun ) * soleMinF( later - ceiling, 0.0f );
		}
		float floor = soleOffsetFor( work, leg, leg->ankleTarget, shortest ) - slack;
		if ( leg->planned )
		{
			soleFindLandingBounds( work, leg, reach.soft, over, &bounds );
		}
		bounds.ceiling = bounds.any ? soleMinF( bounds.ceiling, ceiling ) : ceiling;
		bounds.most = bounds.any ? soleMinF( bounds.most, most ) : most;
		bounds.floor = bounds.any ? soleMaxF( bounds.floor, floor ) : floor;
		bounds.any = true;
	}
	// While all stand there is time: no heel is lifted for a pelvis that lags.
	bounds.most += ( bounds.ceiling - bounds.most ) * soleSmoothly( work->state->standing );
	bounds.ceiling -= over;
	bounds.most -= over;
	bounds.floor -= over;
	return bounds;
}

/// Where the pelvis has to go: not at all where the legs allow it to stay, else down to their ceiling and a little
/// more.
static float soleChooseOffset( soleBounds bounds, float margin )
{
	if ( bounds.any == false )
	{
		return 0.0f;
	}
	float down = bounds.ceiling < 0.0f ? bounds.ceiling + 0.25f * soleMaxF( bounds.ceiling, -margin ) : 0.0f;
	down = soleMinF( down, bounds.landing );
	return down < 0.0f ? down : soleMaxF( bounds.floor, 0.0f );
}

/// An offset within what the planted legs allow. Where their limits cross, reach wins and a leg folds.
static float soleBind( soleBounds bounds, float offset )
{
	return bounds.any ? soleMinF( soleMaxF( offset, bounds.floor ), bounds.most ) : offset;
}

/// All legs have been down for a while: there is no next step to be ready for.
static bool soleIsStanding( const solePlaceWork* work )
{
	bool standing = true;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		bool counts = leg->usable && leg->hasGround && leg->weight > 0.0f;
		standing = standing && ( counts == false || ( leg->touches && leg->state->time > STANDING_TIME ) );
	}
	return standing;
}

/// Comes slowly, and goes when a foot is lifted.
static void soleStepStanding( solePlaceWork* work )
{
	soleState* state = work->state;
	float step = soleIsStanding( work ) ? work->timeStep / STANDING_IN : -work->timeStep / STANDING_OUT;
	state->standing = work->first ? 0.0f : soleSaturate( state->standing + step );
}

/// For how long the pelvis is kept low. Who has come to the end of the stairs, and sees that the step under way needs
/// much less, does not stay down.
static float soleFindHold( const solePlaceWork* work, float legLength )
{
	float hold = work->settings->pelvis.hold;
	bool less = work->bounds.step > work->state->pelvisHeld + MUCH_LESS * legLength;
	return work->bounds.stepping && less ? soleMinF( SEEN, hold ) : hold;
}

/// Goes down at once, and up again only when it has not been needed for some time: the lowest that each step needs is
/// kept from step to step.
static float soleHoldGoal( solePlaceWork* work, float goal, float legLength )
{
	soleState* state = work->state;
	const soleSettings* s = work->settings;
	bool standing = soleIsStanding( work );
	bool near = goal < state->pelvisHeld + AGAIN * legLength;
	state->pelvisHeldTime = near ? 0.0f : state->pelvisHeldTime + work->timeStep;
	float hold = soleFindHold( work, legLength );
	if ( work->first || goal <= state->pelvisHeld || goal - state->pelvisHeld < SAME * legLength )
	{
		state->pelvisHeld = goal;
	}
	else if ( near || standing || state->pelvisHeldTime > hold )
	{
		// It may have been kept for a part of this frame.
		bool whole = near || standing;
		float time = whole ? work->timeStep : soleMinF( state->pelvisHeldTime - hold, work->timeStep );
		float left = soleLeftAfter( time, s->pelvis.release * ( standing ? 0.25f : 1.0f ) );
		state->pelvisHeld = goal + ( state->pelvisHeld - goal ) * left;
	}
	return state->pelvisHeld;
}

/// How far the body's ground has moved along up since the last frame, as far as it was foreseen and beyond the bodies
/// that it is part of.
static float soleGroundStep( const solePlaceWork* work )
{
	const soleState* state = work->state;
	return work->bodyBefore - state->bodyGround + soleDot( soleSub( work->root_w, state->root_w ), work->up ) -
	    work->carriedUp;
}

/// One step towards the goal, by as much that pelvis and ground together move by at most `most`. Two springs, one after
/// the other: a body that is drawn down begins to move without a jerk.
static void soleFollow( solePlaceWork* work, soleBounds bounds, float goal, float most )
{
	soleState* state = work->state;
	float start = state->pelvis.value;
	float halfLife = 0.5f * work->settings->pelvis.halfLife;
	soleOffset1 lead = state->pelvisLead;
	state->pelvisLead = soleStepSpring( lead, goal, 0.0f, halfLife, work->timeStep );
	float pace = ( state->pelvisLead.value - lead.value ) / work->timeStep;
	soleOffset1 spring = soleStepSpring( state->pelvis, lead.value, pace, halfLife, work->timeStep );
	const soleSettings* s = work->settings;
	float legLength = soleLongestLeg( work );
	float bound = soleClampF( soleBind( bounds, spring.value ), -s->pelvis.down * legLength, s->pelvis.up * legLength );
	// A body in the air goes with its root.
	most = bounds.any ? most : FREE * legLength;
	float carried = soleClampF( soleGroundStep( work ), -CARRIED * most, CARRIED * most );
	float wanted = bound - start;
	float step = soleClampF( wanted, -most - carried, most - carried );
	bool free = bound == spring.value && step == wanted;
	state->pelvis.value = start + step;
	state->pelvis.velocity = free ? spring.velocity : step / work->timeStep;
}

// --------------------------------------------------------------------------------------------------------- sideways

/// The pelvis goes along with what the feet are shifted by on the mean, as far as that is wanted, and away from a foot
/// that stands much higher (layer.c).
static void soleKeepBalance( solePlaceWork* work, float legLength )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	float weights = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		float weight = leg->usable && leg->hasGround ? leg->weight * leg->state->plantWeight : 0.0f;
		if ( weight > 0.0f )
		{
			soleVec3 shift = soleHorizontal( work, soleSub( leg->ankleTarget, leg->ankle ) );
			sum = soleMulAdd( sum, weight, shift );
			weights += weight;
		}
	}
	const soleSettings* s = work->settings;
	soleVec3 goal = soleScale( weights > 0.0f ? s->pelvis.balance / weights : 0.0f, sum );
	goal = s->layer.hips > 0.0f ? soleAdd( goal, work->hipShift ) : goal;
	float length = soleLength( goal );
	float most = s->pelvis.sideways * legLength;
	goal = length > most ? soleScale( most / length, goal ) : goal;
	soleOffset3* b = &work->state->balance;
	float* values[] = { &b->value.x, &b->value.y, &b->value.z };
	float* velocities[] = { &b->velocity.x, &b->velocity.y, &b->velocity.z };
	const float goals[] = { goal.x, goal.y, goal.z };
	for ( int32_t i = 0; i < 3; ++i )
	{
		soleOffset1 spring = { work->first ? goals[i] : *values[i], work->first ? 0.0f : *velocities[i] };
		spring = soleStepSpring( spring, goals[i], 0.0f, s->pelvis.halfLife, work->timeStep );
		*values[i] = spring.value;
		*velocities[i] = spring.velocity;
	}
	work->balance = soleScale( work->weight, soleHorizontal( work, b->value ) );
}

// --------------------------------------------------------------------------------------------------------- the stage

void soleMovePelvis( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	soleState* state = work->state;
	float legLength = soleLongestLeg( work );
	soleKeepBalance( work, legLength );
	soleStepStanding( work );
	float over = work->bodyGround - work->reference;
	soleBounds bounds = soleFindBounds( work, over );
	work->bounds = bounds;
	float goal = soleChooseOffset( bounds, MARGIN * legLength );
	goal = soleClampF( goal, -s->pelvis.down * legLength, s->pelvis.up * legLength );
	goal = soleHoldGoal( work, goal, legLength );
	if ( work->first )
	{
		state->pelvis = ( soleOffset1 ){ soleBind( bounds, goal ), 0.0f };
		state->pelvisLead = state->pelvis;
	}
	else if ( work->timeStep > 0.0f )
	{
		float unforeseen = work->bodyBefore - work->bodyGround;
		state->pelvis.value += unforeseen;
		state->pelvisLead.value += unforeseen;
		soleFollow( work, bounds, goal, s->pelvis.speed * legLength * work->timeStep );
	}
	// Wherever feet are taken to stand: a body is no further from its root than probes and its own limits reach.
	float lowest = -( s->probe.stepDown + s->pelvis.down ) * legLength;
	float highest = ( s->probe.stepUp + s->pelvis.up ) * legLength;
	state->pelvis.value = soleClampF( state->pelvis.value, lowest - over, highest - over );
	state->bodyGround = work->bodyGround;
	work->pelvisShift = soleFiniteOr( work->weight * ( over + state->pelvis.value ), 0.0f );
	work->pelvisWanted = soleMulAdd( work->balance, work->pelvisShift, work->up );
	if ( s->pelvis.mode == sole_pelvisReport )
	{
		work->pelvisShift = 0.0f;
		work->balance = soleVec( 0.0f, 0.0f, 0.0f );
	}
}
