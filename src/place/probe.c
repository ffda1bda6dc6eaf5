// SPDX-License-Identifier: MIT
// Probe: what to ask of the ground.
//
// The probes of a foot stand on its sole as it would lie flat: measured from the ball along the foot's heading, so that
// a raised heel or a foot in flight asks for the ground it will come to rest on. A held foot asks where it is held.
// Each probe is a vertical segment around the reference height (the clip's floor as the root carries it), never around
// the foot: a foot that is inside a step still finds the step's top.
#include "place/place.h"

#define FLYING 0.8f // L/s

void soleAimSole( solePlaceWork* work, soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	leg->flying = ( state->flags & ( sole_stateLocked | sole_stateHeelOn | sole_stateToeOn ) ) == 0 &&
	    leg->ballSpeed > FLYING * leg->length;
	if ( ( state->flags & sole_stateLocked ) != 0 )
	{
		leg->soleCenter = soleSub( state->lockPoint_w, work->root_w );
		leg->soleForward =
		    soleNormalizeOr( soleHorizontal( work, state->lockForward_w ), soleAnyOrthogonal( work->up ) );
		if ( ( state->flags & sole_stateByHeel ) != 0 )
		{
			float scaled = leg->rig->heelBehind * work->rootScale;
			leg->soleCenter = soleMulAdd( leg->soleCenter, scaled, leg->soleForward );
		}
		return;
	}
	soleHalf half = soleHalfFromQuarterTan( state->turn.value );
	leg->soleCenter = soleAdd( leg->ball, state->slide.value );
	leg->soleForward = soleRotate( soleHalfRotation( work->up, half ), leg->forward );
	leg->tip = soleMulAdd( leg->soleCenter, leg->rig->toeAhead * work->rootScale, leg->soleForward );
}

typedef struct soleProbePlace
{
	float ahead;    // -1 heel, 0 ball, 1 toe tip
	float sideways; // -1 inner edge, 0 middle, 1 outer edge
} soleProbePlace;

static const soleProbePlace soleEconomyPlaces[] = { { -1.0f, 0.0f }, { -0.5f, 0.0f }, { 0.0f, -0.8f }, { 0.0f, 0.8f },
	{ 1.0f, 0.0f } };
static const soleProbePlace soleSinglePlaces[] = { { 0.0f, 0.0f } };
static const soleProbePlace soleQualityPlaces[] = { { -1.0f, -0.6f }, { -1.0f, 0.6f }, { -0.8f, -0.7f },
	{ -0.8f, 0.7f }, { -0.6f, -0.7f }, { -0.6f, 0.7f }, { -0.4f, -0.75f }, { -0.4f, 0.75f }, { -0.2f, -0.8f },
	{ -0.2f, 0.8f }, { 0.0f, -0.85f }, { 0.0f, 0.85f }, { 0.35f, -0.8f }, { 0.35f, 0.8f }, { 0.7f, -0.7f },
	{ 0.7f, 0.7f }, { 1.0f, -0.5f }, { 1.0f, 0.5f } };

static const soleProbePlace* soleChoosePlaces( soleProbeLayout layout )
{
	if ( layout == sole_probeQuality )
	{
		return soleQualityPlaces;
	}
	return layout == sole_probeSingle ? soleSinglePlaces : soleEconomyPlaces;
}

static soleVec3 soleProbePoint( const solePlaceWork* work, const soleLegWork* leg, soleProbePlace place )
{
	const soleRigLeg* rig = leg->rig;
	float ahead = place.ahead < 0.0f ? place.ahead * rig->heelBehind : place.ahead * rig->toeAhead;
	float sideways = place.sideways < 0.0f ? -place.sideways * rig->innerSide : place.sideways * rig->outerSide;
	soleVec3 side = soleCross( leg->soleForward, work->up );
	soleVec3 p = soleMulAdd( leg->soleCenter, ahead * work->rootScale, leg->soleForward );
	return soleMulAdd( p, sideways * work->rootScale, side );
}

/// Where probe k of a leg asks: under the sole, then where its toe tip will be soon.
static soleVec3 soleChoosePoint( const solePlaceWork* work, const soleLegWork* leg, int32_t k )
{
	int32_t perSole = soleProbesPerSole( work->settings );
	if ( k < perSole )
	{
		return soleProbePoint( work, leg, soleChoosePlaces( work->settings->probe.layout )[k] );
	}
	float time = work->settings->support.lookAhead * (float)( k - perSole + 1 ) / (float)SOLE_AHEAD;
	return soleMulAdd( leg->tip, time, leg->ballVelocity );
}

int32_t soleProbeGround( const solePlaceWork* work, soleProbe* probes, int32_t capacity )
{
	const soleSettings* settings = work->settings;
	int32_t perSole = soleProbesPerSole( settings );
	int32_t perLeg = soleProbesPerLeg( settings );
	int32_t count = 0;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		// Probes that are not needed are asked with no length: how many there are depends on rig and settings alone.
		for ( int32_t k = 0; k < perLeg && count < capacity; ++k )
		{
			bool needed = leg->usable && ( k < perSole || leg->flying );
			soleVec3 point = needed ? soleChoosePoint( work, leg, k ) : soleVec( 0.0f, 0.0f, 0.0f );
			float up = settings->probe.stepUp * leg->length;
			float down = settings->probe.stepDown * leg->length;
			soleProbe* probe = probes + count++;
			probe->start_w = soleAdd( soleAtHeight( work, point, work->reference + up ), work->root_w );
			probe->direction_w = soleNeg( work->up );
			probe->length = needed ? up + down : 0.0f;
			probe->radius = settings->probe.shape == sole_probeSphere ? settings->probe.radius * leg->length : 0.0f;
			probe->mask = settings->probe.mask;
			probe->leg = (int16_t)i;
			probe->index = (int16_t)k;
		}
	}
	return count;
}
