// SPDX-License-Identifier: MIT
// The stage target for legs of several characters side by side, a lane a leg: what goes in and what comes out. Near
// space, as place.h has it.
#ifndef SOLE_PLACE_TARGET_WIDE_H
#define SOLE_PLACE_TARGET_WIDE_H

#include "place/rows.h"

typedef struct soleTargetLanes
{
	int32_t count;
	const solePlaceWork* works[SOLE_LANES]; // whose legs they are
	soleLegWork* legs[SOLE_LANES];

	// In.
	soleRow up[3], rootUp[3], forward[3], root_w[3];
	soleRow planePoint[3], planeNormal[3], planeGradient[3];
	soleRow anchor[3], anchorGoal[3], raise; // raise: of the sole over the plane
	soleRow turn[4], toeOut[4], flat;        // flat: an angle
	soleRow pivot[3], ankle[3], foot[4], footSide[3];
	soleRow weight, turnWeight;

	// Out.
	soleRow image[4], footTarget[4];
	soleRow ankleWanted[3], ankleTarget[3], pivotTarget[3], planePoint_w[3];
} soleTargetLanes;

/// Lanes [0, end). All hold numbers.
typedef void soleTargetLanesFcn( soleTargetLanes* lanes, int32_t end );

/// Several characters, whose stages before are done: what soleSetTargets() gives for each.
void soleSetAllTargets( solePlaceWork* const* works, int32_t count, int32_t width );

#endif
