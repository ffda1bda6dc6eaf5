// SPDX-License-Identifier: MIT
// Which of the legs that may be some are: those that mirror another one across a plane through the middle of all hips.
// That plane stands upright, along one of the two axes across up. Character space, bind pose.
#include "detect_internal.h"

#include <math.h>

/// How badly two legs mirror each other across a plane square to lateral through middle, in leg lengths.
static float soleMirrorError(
    const soleDetect* detect, const soleFoundLeg* a, const soleFoundLeg* b, soleVec3 lateral, float middle )
{
	soleVec3 hipA = detect->position[a->joints[0]];
	soleVec3 hipB = detect->position[b->joints[0]];
	float across = 2.0f * ( soleDot( hipA, lateral ) - middle );
	soleVec3 mirrored = soleMulAdd( hipA, -across, lateral );
	float longer = soleMaxF( a->length, b->length );
	float acrossB = soleDot( hipB, lateral ) - middle;
	if ( fabsf( across ) < 0.02f * longer || across * acrossB > 0.0f )
	{
		return 1e30f;
	}
	// The feet may be in mid-stride: they decide only between legs whose hips mirror equally well.
	float acrossFoot = 2.0f * ( soleDot( a->ankle, lateral ) - middle );
	float feet = soleDistance( soleMulAdd( a->ankle, -acrossFoot, lateral ), b->ankle );
	return ( soleDistance( mirrored, hipB ) + 2.0f * fabsf( a->length - b->length ) + 0.05f * feet ) / longer;
}

static float soleFindMiddle( const soleDetect* detect, const soleFoundLeg* legs, int32_t legCount, soleVec3 lateral )
{
	float low = 1e30f;
	float high = -1e30f;
	for ( int32_t i = 0; i < legCount; ++i )
	{
		float at = soleDot( detect->position[legs[i].joints[0]], lateral );
		low = soleMinF( low, at );
		high = soleMaxF( high, at );
	}
	return 0.5f * ( low + high );
}

/// Pairs legs across the plane. @return how many legs have a partner; error is the sum.
static int32_t solePairLegs( const soleDetect* detect, const soleFoundLeg* legs, int32_t legCount, soleVec3 lateral,
    int32_t partners[SOLE_MAX_LEGS], float* error )
{
	float middle = soleFindMiddle( detect, legs, legCount, lateral );
	int32_t paired = 0;
	*error = 0.0f;
	for ( int32_t i = 0; i < legCount; ++i )
	{
		partners[i] = SOLE_NONE;
	}
	for ( int32_t i = 0; i < legCount; ++i )
	{
		float best = 0.25f;
		for ( int32_t j = i + 1; j < legCount && partners[i] == SOLE_NONE; ++j )
		{
			float e = partners[j] != SOLE_NONE ? 1e30f : soleMirrorError( detect, legs + i, legs + j, lateral, middle );
			best = e < best ? e : best;
		}
		for ( int32_t j = i + 1; j < legCount && best < 0.25f && partners[i] == SOLE_NONE; ++j )
		{
			if ( partners[j] == SOLE_NONE && soleMirrorError( detect, legs + i, legs + j, lateral, middle ) <= best )
			{
				partners[i] = j;
				partners[j] = i;
				paired += 2;
				*error += best;
			}
		}
	}
	return paired;
}

int32_t soleKeepMirroredLegs( const soleDetect* detect, soleVec3 up, soleFoundLeg* legs, int32_t legCount )
{
	soleVec3 axis[2];
	axis[0] = soleAnyOrthogonal( up );
	axis[1] = soleCross( up, axis[0] );
	int32_t partners[2][SOLE_MAX_LEGS];
	float error[2];
	int32_t paired[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		paired[k] = solePairLegs( detect, legs, legCount, axis[k], partners[k], error + k );
	}
	int32_t best = paired[1] > paired[0] || ( paired[1] == paired[0] && error[1] < error[0] ) ? 1 : 0;
	int32_t kept = 0;
	for ( int32_t i = 0; i < legCount; ++i )
	{
		if ( partners[best][i] != SOLE_NONE )
		{
			legs[kept++] = legs[i];
		}
	}
	return kept;
}
