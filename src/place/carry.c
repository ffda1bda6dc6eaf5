// SPDX-License-Identifier: MIT
// Carry: moves what a leg remembers along with the body that it stands on, or is about to stand on.
//
// A lock, a plane or a foothold on a lift or a turntable is a place on that body. The body's transform when the place
// was remembered and its transform now give the motion  x -> t1 + R1 R0^-1 ( x - t0 ),  applied once, and not at all
// where the body has not moved: a foot on a body at rest stands still to the bit. Each leg has a body of its own. The
// animated sole points are moved too: how fast a foot is counts relative to what it stands on.
// A body that the host does not list, but whose hits have a velocity, moves the leg by that.
#include "place/place.h"

static const soleSupport* soleFindBody( const soleFrame* frame, int32_t surface )
{
	for ( int32_t i = 0; i < frame->supportCount && frame->supports != NULL; ++i )
	{
		const soleTransform* t = &frame->supports[i].transform;
		if ( frame->supports[i].surface == surface && surface != SOLE_NONE )
		{
			return soleVec3_IsFinite( t->translation ) && soleQuat_IsFinite( t->rotation ) ? frame->supports + i : NULL;
		}
	}
	return NULL;
}

typedef struct soleMotionStep
{
	soleQuat turn;
	soleVec3 from;
	soleVec3 to;
} soleMotionStep;

static soleVec3 soleMovePlace( soleMotionStep step, soleVec3 place )
{
	return soleAdd( step.to, soleRotate( step.turn, soleSub( place, step.from ) ) );
}

static void soleMoveMemory( soleLegState* state, soleMotionStep step )
{
	soleVec3* places[] = { &state->animHeel_w, &state->animBall_w, &state->lockPoint_w, &state->planePoint_w,
		&state->stepPlace_w, &state->stepLanding_w };
	soleVec3* directions[] = { &state->lockForward_w, &state->planeNormal_w, &state->stepNormal_w };
	for ( int32_t i = 0; i < 6; ++i )
	{
		*places[i] = soleMovePlace( step, *places[i] );
	}
	for ( int32_t i = 0; i < 3; ++i )
	{
		*directions[i] = soleRotate( step.turn, *directions[i] );
	}
}

/// What the leg's body has done since the last frame. @return false: nothing
static bool soleFindStep( const solePlaceWork* work, const soleLegState* state, soleMotionStep* step )
{
	*step = ( soleMotionStep ){ soleQuat_Identity(), state->body.place, state->body.place };
	if ( ( state->flags & sole_stateRides ) == 0 )
	{
		step->from = soleVec( 0.0f, 0.0f, 0.0f );
		step->to = soleScale( work->timeStep, state->body.place );
		return soleDot( step->to, step->to ) > 0.0f;
	}
	const soleSupport* body = soleFindBody( work->frame, state->body.surface );
	if ( body == NULL )
	{
		return false;
	}
	soleQuat now = soleNormalizeQuat( body->transform.rotation );
	soleQuat then = state->body.rotation;
	step->to = body->transform.translation;
	step->turn = soleNormalizeQuat( soleMulQuat( now, soleConjugate( then ) ) );
	bool turned = now.x != then.x || now.y != then.y || now.z != then.z || now.w != then.w;
	step->turn = turned ? step->turn : soleQuat_Identity();
	return turned || step->to.x != step->from.x || step->to.y != step->from.y || step->to.z != step->from.z;
}

void soleCarryLegs( solePlaceWork* work )
{
	float lift = 0.0f;
	int32_t carried = 0;
	for ( int32_t i = 0; i < work->legCount && work->first == false; ++i )
	{
		soleLegState* state = work->legs[i].state;
		soleMotionStep step;
		if ( soleFindStep( work, state, &step ) )
		{
			soleVec3 before = state->planePoint_w;
			soleMoveMemory( state, step );
			lift += soleDot( soleSub( state->planePoint_w, before ), work->up );
			++carried;
		}
	}
	work->carriedUp = carried > 0 ? lift / (float)carried : 0.0f;
}

void soleRememberBodies( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		soleLegState* state = leg->state;
		const soleSupport* body = soleFindBody( work->frame, leg->surface );
		state->flags &= ~(uint32_t)sole_stateRides;
		state->body = ( soleBodyState ){ leg->surface, soleQuat_Identity(), leg->surfaceVelocity };
		if ( body != NULL )
		{
			state->flags |= (uint32_t)sole_stateRides;
			state->body.rotation = soleNormalizeQuat( body->transform.rotation );
			state->body.place = body->transform.translation;
		}
	}
}
