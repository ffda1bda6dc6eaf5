// SPDX-License-Identifier: MIT
// Foothold: where the next step lands and the path there. Not built yet: this stage does nothing, so a foot in flight
// follows the ground under it, and a foot that comes down on an edge stays where the animation put it.
#include "place/place.h"

void soleChooseFoothold( solePlaceWork* work )
{
	(void)work;
}
