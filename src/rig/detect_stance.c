// SPDX-License-Identifier: MIT
// Whether the bind pose stands on both feet, and at which height the joints say that its floor is.
// Character space, bind pose.
#include "detect_internal.h"

#include <math.h>

/// Angle of ankle to toe below the horizontal.
static float solePitch( const soleDetect* detect, const soleFoundLeg* leg )
{
	int32_t toe = soleFoundLeg_GetEnd( leg );
	if ( toe == SOLE_NONE )
	{
		return 0.0f;
	}
	soleVec3 d = soleSub( detect->position[toe], leg->ankle );
	float down = -soleDot( d, detect->up );
	return (float)atan2( (double)down, (double)soleLength( soleReject( d, detect->up ) ) );
}

/// Lowest that a leg's joints say the floor can be.
static float soleLowest( const soleDetect* detect, const soleFoundLeg* leg )
{
	float unit = soleFoundLeg_GetUnit( leg );
	float low = soleDot( leg->ankle, detect->up );
	if ( leg->tip == SOLE_NONE && leg->toeCount == 0 )
	{
		return leg->hasVirtualAnkle || detect->legCount > 2 || leg->jointCount > 3 ? low
		                                                                           : low - SOLE_HUMAN_ANKLE * unit;
	}
	if ( leg->toeCount > 0 )
	{
		low = soleMinF( low, soleDot( detect->position[leg->toes[0]], detect->up ) - SOLE_HUMAN_TOE_JOINT * unit );
	}
	if ( leg->tip != SOLE_NONE )
	{
		float below = leg->toeCount == 0 ? SOLE_HUMAN_TOE_JOINT * unit : 0.0f;
		low = soleMinF( low, soleDot( detect->position[leg->tip], detect->up ) - below );
	}
	return low;
}

void soleFindStanding( soleDetect* detect )
{
	detect->standing = true;
	detect->floor = 1e30f;
	float unit = soleFoundLeg_GetUnit( detect->legs + 0 );
	float ankleLow = 1e30f;
	float ankleHigh = -1e30f;
	float pitchLow = 1e30f;
	float pitchHigh = -1e30f;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		float height = soleDot( leg->ankle, detect->up );
		float pitch = solePitch( detect, leg );
		ankleLow = soleMinF( ankleLow, height );
		ankleHigh = soleMaxF( ankleHigh, height );
		pitchLow = soleMinF( pitchLow, pitch );
		pitchHigh = soleMaxF( pitchHigh, pitch );
		detect->floor = soleMinF( detect->floor, soleLowest( detect, leg ) );
	}
	if ( fabsf( detect->floor ) < SOLE_HUMAN_ORIGIN * unit )
	{
		detect->floor = 0.0f;
	}
	if ( detect->legCount == 2 &&
	    ( ankleHigh - ankleLow > 0.05f * detect->legs[0].length || pitchHigh - pitchLow > 0.2f || pitchLow < -0.1f ) )
	{
		detect->standing = false;
		soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE,
		    "export with a bind pose that stands flat, or give the sole points by hand",
		    "bind pose is no standing pose: ankle heights differ by %.3g, foot pitch by %.0f degrees; soles are estimated",
		    (double)( ankleHigh - ankleLow ), (double)( ( pitchHigh - pitchLow ) * 57.29578f ) );
	}
}
