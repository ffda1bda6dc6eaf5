// SPDX-License-Identifier: MIT
// How a sole rests on ground that is known at some places: the plane that carries it. A kernel of the stages that need
// it for where the foot is and for where it may come to stand.
#ifndef SOLE_PLACE_REST_H
#define SOLE_PLACE_REST_H

#include "place/place.h"

/// How a sole rests somewhere.
typedef struct soleRest
{
	bool found;         // there is ground
	solePlane plane;    // its point under the load point
	float toeSlope;     // rise per length of the ground in front of the ball, over the plane
	float share;        // of the places under the sole that bear
	float foreShare;    // of those ahead of the ball
	float rearShare;    // and behind
	float confidence;   // 0..1
	float sunk;         // how far the sole is inside the ground all the same, toes bent
	bool known;         // all along the sole, where only places along a line count
	bool onEdge, steep; // part of it hangs over a lower level; the ground cannot be walked on
	int32_t surface;    // of the highest place
	soleVec3 velocity;  // of that surface there
} soleRest;

/// @param line only places along the middle of the sole count: cheap, for choosing among many
soleRest soleRestSole( const solePlaceWork* work, const soleLegWork* leg, soleFootprint print, bool line );

#endif
