// SPDX-License-Identifier: MIT
// By which part of its sole a foot stands as it is animated: from the heights of heel, ball and toe tip over the clip's
// floor.
#ifndef SOLE_PLACE_STANCE_H
#define SOLE_PLACE_STANCE_H

#include "place/place.h"

#define SOLE_ON_HEEL 0.03f // L: a ball that is animated this much higher than the heel bears nothing

/// How far a foot is on its heel alone, 0 to 1.
/// @param high L: a ball that is so much higher bears nothing
static inline float soleIsOnHeel( const soleLegWork* leg, float high )
{
	return soleSmoothly( soleSaturate( ( leg->ballRise - leg->heelRise ) / ( high * leg->length ) ) );
}

/// How far it is on its toe tip alone: sine of the angle by which its toes stand up.
static inline float soleFindTiptoe( const solePlaceWork* work, const soleLegWork* leg )
{
	float toe = leg->rig->toeAhead * work->rootScale;
	float over = leg->ballRise - soleMaxF( leg->tipRise, -leg->sunk );
	return toe > 0.0f ? soleSaturate( over / toe ) : 0.0f;
}

#endif
