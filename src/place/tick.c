// SPDX-License-Identifier: MIT
// Tick: the filter of an ancestor (settings.support.filter), which asks the ground by a fixed clock and goes a share of
// the way with every call, however long a frame is. It takes the place of footholds, locks and springs: who has tuned
// a game to it gets the same from the same input.
//
// Every 0.02 s each leg asks under its ankle as it was shown in the last frame, seen from the root as it is now; what
// is met there is kept until the next tick. With h_i the heights of what is kept over the root's floor, every call does
//   body   y <- y + s_p ( b + min h_i - y )     b the animated height of the pelvis, y the one that is shown
//   leg    v <- v + s_f ( h_i - v )             ankle = animated ankle + v along the root's up
//   s = 1 - 2^( -0.02 / half-life )
// so a half-life means what it says where a frame is a tick long. The height is added: a foot keeps what it is animated
// with over the floor. The body goes with all legs or not at all: where one of them has met nothing, y is b. A leg that
// has met nothing is as animated, and goes on from its v when it meets something again. Whether ground was met, and
// whether a frame came before, are flags: ground at the world's origin and a pelvis at height 0 are what they are.
//
// What is remembered, in fields whose stages do not run: the ground in planePoint_w and planeNormal_w, met if
// sole_stateGround; v in height; the shown ankle in learntPlace; y, over the root, in pelvis; the clock in
// pelvisHeldTime.
#include "place/way.h"

#define TICK 0.02f    // s
#define NOTHING 1e-9f // L: what is nearer is there, and does not go on among the smallest floats

static float soleFindShare( float halfLife )
{
	return 1.0f - soleLeftAfter( TICK, halfLife );
}

void soleCountTick( solePlaceWork* work )
{
	float elapsed = work->timeStep + ( work->first ? TICK : work->state->pelvisHeldTime );
	work->ticks = elapsed >= TICK;
	work->state->pelvisHeldTime = elapsed - TICK * (float)(int32_t)soleMinF( elapsed / TICK, 1e6f );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		soleVec3 shown = soleTransformPoint( soleGetNearRoot( work ), leg->state->learntPlace );
		leg->foreseen = false;
		leg->soleCenter = work->first ? leg->ankle : shown;
		leg->soleForward = leg->forward;
		leg->print = soleMakeFootprint( work, leg->soleCenter, leg->soleForward, work->up );
	}
}

void soleKeepTick( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		soleLegState* state = leg->state;
		const soleGroundSample* met = leg->samples;
		if ( leg->sampleCount > 0 && met->found )
		{
			float height = met->height + work->settings->target.height * leg->length;
			state->planePoint_w = soleAdd( soleAtHeight( work, met->place, height ), work->root_w );
			state->planeNormal_w = soleMakePlane( work, met->place, met->gradient ).normal;
			state->flags |= (uint32_t)sole_stateGround;
		}
		else if ( leg->sampleCount > 0 )
		{
			state->flags &= ~(uint32_t)sole_stateGround;
		}
		leg->hasGround = leg->usable && ( state->flags & (uint32_t)sole_stateGround ) != 0;
		soleVec3 point = soleSub( state->planePoint_w, work->root_w );
		leg->raw = leg->hasGround ? soleMakePlane( work, point, soleGradientOf( work, state->planeNormal_w ) )
		                          : soleMakePlane( work, work->floor, soleVec( 0.0f, 0.0f, 0.0f ) );
		leg->surface = SOLE_NONE; // what it stands on does not carry it
		leg->surfaceVelocity = soleVec( 0.0f, 0.0f, 0.0f );
	}
}

static void soleLerpBody( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	soleState* state = work->state;
	float body = soleDot( work->slots[work->rig->pelvisSlot].translation, work->up );
	float lowest = 0.0f;
	bool known = work->first == false;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		float over = soleDot( leg->raw.point, work->up ) - work->reference;
		lowest = i == 0 ? over : soleMinF( lowest, over );
		known = known && leg->hasGround;
	}
	float last = state->pelvis.value + soleDot( soleSub( state->root_w, work->root_w ), work->up );
	float shown = known ? last + soleFindShare( s->pelvis.halfLife ) * ( body + lowest - last ) : body;
	state->pelvis = ( soleOffset1 ){ shown, 0.0f };
	float longest = soleLongestLeg( work );
	float offset = soleClampF( shown - body, -s->pelvis.down * longest, s->pelvis.up * longest );
	work->pelvisShift = soleSaturate( work->frame->weight ) * offset;
	work->pelvisWanted = soleScale( work->pelvisShift, work->up );
	work->pelvisShift = s->pelvis.mode == sole_pelvisReport ? 0.0f : work->pelvisShift;
	work->bodyGround = work->reference + ( known ? lowest : 0.0f );
}

static void soleLerpLeg( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	float height = soleDot( soleSub( leg->raw.point, work->floor ), work->rootUp );
	float share = leg->hasGround ? soleFindShare( work->settings->support.heightHalfLife ) : 0.0f;
	float left = ( height - state->height.value ) * ( 1.0f - share );
	float least = NOTHING * leg->length;
	state->height.value = leg->hasGround && left < least && left > -least ? height : height - left;
	float raised = leg->hasGround ? state->height.value : 0.0f;
	soleVec3 moved = soleMulAdd( leg->ankle, work->pelvisShift, work->up );
	leg->ankleWanted = soleMulAdd( leg->ankle, raised, work->rootUp );
	leg->ankleTarget = soleLerp( moved, leg->ankleWanted, leg->weight );
	leg->pivotTarget = soleAdd( leg->pivot, soleSub( leg->ankleTarget, leg->ankle ) );
	soleVec3 gradient = soleScale( soleFindAlign( work, leg->raw.gradient ), leg->raw.gradient );
	leg->plane = soleMakePlane( work, leg->raw.point, gradient );
	soleQuat tilt = soleFromTo( work->up, leg->plane.normal, leg->forward );
	leg->image = soleMulQuat( tilt, soleGetToeOut( work, leg ) );
	leg->footTarget = soleNlerp( leg->foot.rotation, soleMulQuat( leg->image, leg->foot.rotation ), leg->turnWeight );
	leg->out->planePoint_w = soleAdd( leg->plane.point, work->root_w );
	leg->out->planeNormal_w = leg->plane.normal;
	leg->out->heightDemand = soleDot( leg->plane.point, work->up ) - work->reference;
	leg->out->flags |= leg->hasGround ? 0u : (uint32_t)sole_legNoGround;
}

void soleFollowTick( solePlaceWork* work )
{
	soleLerpBody( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		if ( work->legs[i].usable )
		{
			soleLerpLeg( work, work->legs + i );
		}
	}
}

void soleRememberShown( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		leg->state->learntPlace = soleInvTransformPoint( soleGetNearRoot( work ), leg->ankleReached );
	}
}
