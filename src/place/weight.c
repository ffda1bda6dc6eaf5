// SPDX-License-Identifier: MIT
// Weights: how much of the placement each leg gets.
//
// What the host says, times what settings leave to a foot in flight, to a character that moves, runs or is in the air
// (activity.c) and to a foot whose ground is out of reach. The product may jump; what counts rises in target.blendIn
// and falls in target.blendOut.
#include "place/place.h"

static float soleReadWeight( const float* weights, int32_t leg )
{
	return weights != NULL ? soleSaturate( soleFiniteOr( weights[leg], 0.0f ) ) : 1.0f;
}

/// By the host, where it says so; else as it was a frame ago. A character that appears stands.
static bool soleIsDown( const solePlaceWork* work, const soleLegWork* leg )
{
	bool told = leg->contactInput.heel >= 0.0f && leg->contactInput.toe >= 0.0f;
	bool was = ( leg->state->flags & ( sole_stateHeelOn | sole_stateToeOn ) ) != 0;
	return told ? leg->contactInput.heel >= 0.5f || leg->contactInput.toe >= 0.5f : was || work->first;
}

/// What the settings leave.
static float soleFindShare( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	const uint32_t beyond = (uint32_t)( sole_stateTooLow | sole_stateTooHigh | sole_stateTooSteep );
	float share = soleIsDown( work, leg ) ? 1.0f : s->target.flight;
	share *= soleIsMoving( work ) ? s->target.moving : 1.0f;
	share *= work->state->strength;
	return share * ( ( leg->state->flags & beyond ) != 0 ? s->target.unreachable : 1.0f );
}

/// One step of a weight towards what is wanted.
static float soleBlend( const solePlaceWork* work, float now, float wanted )
{
	float time = wanted > now ? work->settings->target.blendIn : work->settings->target.blendOut;
	float most = time > 0.0f ? work->timeStep / time : 1.0f;
	return work->first ? wanted : soleClampF( wanted, now - most, now + most );
}

void soleBlendWeights( solePlaceWork* work, soleLegWork* leg )
{
	const soleFrame* frame = work->frame;
	float whole = soleSaturate( frame->weight ) * soleReadWeight( frame->legWeight, leg->index );
	whole *= soleFindShare( work, leg );
	float position = whole * soleReadWeight( frame->positionWeight, leg->index );
	float rotation = whole * soleReadWeight( frame->rotationWeight, leg->index );
	leg->weightBefore = leg->state->positionWeight;
	leg->state->positionWeight = soleBlend( work, leg->state->positionWeight, position );
	leg->state->rotationWeight = soleBlend( work, leg->state->rotationWeight, rotation );
	leg->weight = leg->state->positionWeight;
	leg->weightBefore = work->first ? leg->weight : leg->weightBefore;
	leg->turnWeight = leg->state->rotationWeight;
	work->weight = soleMaxF( work->weight, leg->weight );
}
