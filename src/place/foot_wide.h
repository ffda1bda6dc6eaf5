// SPDX-License-Identifier: MIT
// The stages leg and ankle for legs of several characters side by side: what goes in and what comes out, a lane a leg.
// Near space, as place.h has it.
#ifndef SOLE_PLACE_FOOT_WIDE_H
#define SOLE_PLACE_FOOT_WIDE_H

#include "place/rows.h"

typedef struct soleFootLanes
{
	int32_t count;
	solePlaceWork* works[SOLE_LANES]; // whose legs they are
	soleLegWork* legs[SOLE_LANES];

	// In. soleTwoBoneDef.
	soleRow hip[3], knee[3], ankle[3], target[3], hinge[3];
	soleRow reach, fold, softZone;
	// Animated turns, and those of the parents of the joints that are turned.
	soleRow thigh[4], shin[4], foot[4], toe[4];
	soleRow thighParent[4], shinParent[4], footParent[4], toeParent[4];
	soleRow reachedFoot[4]; // soleLegWork.footReached
	soleRow image[4];
	// Of the rig.
	soleRow up[3], ahead[3], side[3]; // axes of the foot
	soleRow neutral[4];
	soleRow low[3], high[3]; // sines of pitch, roll and twist
	// Toes.
	soleRow toeSlope, fallShare, riseShare; // share of a bend down and up that is taken
	soleRow toesUp[2], toesDown[2];         // limits, cosine and sine

	// Out.
	soleRow hipTurn[4], kneeTurn[4], reached[3];
	uint32_t flags[SOLE_LANES];
	uint32_t within[SOLE_LANES]; // 1: the ankle is within its own limits, and surely so
	soleRow thigh_l[4], shin_l[4], foot_l[4], toe_l[4];
} soleFootLanes;

/// Lanes [0, end) of which the first count are of use. All hold numbers.
typedef void soleFootLanesFcn( soleFootLanes* lanes, int32_t end );

/// Legs and ankles of several characters, whose stages before are done: what soleFinishLeg() gives for each leg.
void soleFinishLegs( solePlaceWork* const* works, int32_t count, int32_t width );

#endif
