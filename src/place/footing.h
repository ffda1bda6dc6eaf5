// SPDX-License-Identifier: MIT
// The plane under a foot that is not on its way to a foothold. A kernel of the stage that chooses footholds.
#ifndef SOLE_PLACE_FOOTING_H
#define SOLE_PLACE_FOOTING_H

#include "place/place.h"

#define SOLE_NEXT_STEP 0.022f // L: ground this much higher than was foreseen is another step

/// What is met under a foot is the step over the one chosen for it, and bears little of it.
/// @param share of the places under the sole that bear there
bool soleMeetsNextStep( const solePlaceWork* work, const soleLegWork* leg, solePlane met, float share );
/// Answers that fail for a moment, while a foot stands, mean nothing: the ground is taken to be where it was.
void soleBridgeMiss( const solePlaceWork* work, soleLegWork* leg, solePlane old );
/// The plane of a foot that comes down, stands, or flies without a foothold.
void soleFollowGround( solePlaceWork* work, soleLegWork* leg );
/// What counts as the place of a foot: where it is held or flies; where it was foreseen while it comes down.
soleVec3 soleStandPlace( const solePlaceWork* work, const soleLegWork* leg );

#endif
