// SPDX-License-Identifier: MIT
// The stages leg and ankle for legs of several characters side by side: what goes in and what comes out, a lane a leg.
// Near space, as place.h has it.
#ifndef SOLE_PLACE_FOOT_WIDE_H
#define SOLE_PLACE_FOOT_WIDE_H

#include "place/place.h"

/// Legs that go side by side: vectors enough to overlap, few enough for the nearest cache.
#define SOLE_FOOT_LANES 32

/// Rows of numbers, one a lane.
typedef float soleFootRow[SOLE_FOOT_LANES];

typedef struct soleFootLanes
{
	int32_t count;
	solePlaceWork* works[SOLE_FOOT_LANES]; // whose legs they are
	soleLegWork* legs[SOLE_FOOT_LANES];

	// In. soleTwoBoneDef.
	soleFootRow hip[3], knee[3], ankle[3], target[3], hinge[3];
	soleFootRow reach, fold, softZone;
	// Animated turns, and those of the parents of the joints that are turned.
	soleFootRow thigh[4], shin[4], foot[4], toe[4];
	soleFootRow thighParent[4], shinParent[4], footParent[4], toeParent[4];
	soleFootRow reachedFoot[4]; // soleLegWork.footReached
	soleFootRow image[4];
	// Of the rig.
	soleFootRow up[3], ahead[3], side[3]; // axes of the foot
	soleFootRow neutral[4];
	soleFootRow low[3], high[3]; // sines of pitch, roll and twist
	// Toes.
	soleFootRow toeSlope, fallShare, riseShare; // share of a bend down and up that is taken
	soleFootRow toesUp[2], toesDown[2];         // limits, cosine and sine

	// Out.
	soleFootRow hipTurn[4], kneeTurn[4], reached[3];
	uint32_t flags[SOLE_FOOT_LANES];
	uint32_t within[SOLE_FOOT_LANES]; // 1: the ankle is within its own limits, and surely so
	soleFootRow thigh_l[4], shin_l[4], foot_l[4], toe_l[4];
} soleFootLanes;

/// Lanes [0, end) of which the first count are of use. All hold numbers.
typedef void soleFootLanesFcn( soleFootLanes* lanes, int32_t end );

/// @param width 4, 8, 16: end is a multiple of it, and the machine has it
soleFootLanesFcn* soleGetFootLanes( int32_t width );

/// Legs and ankles of several characters, whose stages before are done: what soleSolveLegs(), soleLimitAnkles(),
/// soleSolveLimitedLegs() and soleAlignAnkles() give for each.
void soleFinishLegs( solePlaceWork* const* works, int32_t count, int32_t width );

#endif
