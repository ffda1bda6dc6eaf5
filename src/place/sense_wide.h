// SPDX-License-Identifier: MIT
// The stage sense for several characters of one rig side by side, a lane a character: what goes in and what comes out.
// Near space, as place.h has it.
#ifndef SOLE_PLACE_SENSE_WIDE_H
#define SOLE_PLACE_SENSE_WIDE_H

#include "place/rows.h"

/// Rigs of more slots or legs are sensed one by one.
#define SOLE_SENSE_SLOTS 24
#define SOLE_SENSE_LEGS 4

/// A transform, number by number.
typedef struct soleSenseSpace
{
	soleRow place[3], turn[4], scale[3];
} soleSenseSpace;

/// What is sensed of a leg beside its slots.
typedef struct soleSenseFoot
{
	soleRow ankle[3], heel[3], ball[3], forward[3];
	soleRow length, heelRise, ballRise, tipRise, sunk, toeSunk;
	uint32_t usable[SOLE_LANES];
} soleSenseFoot;

typedef struct soleSenseLanes
{
	const soleRig* rig;

	// In.
	soleSenseSpace root; // at the origin
	soleRow up[3], level[3], rootUp[3], floor[3], rootScale;
	// As animated, in the space of their parents; out: in that of the root.
	soleSenseSpace slots[SOLE_SENSE_SLOTS];

	// Out.
	soleSenseFoot feet[SOLE_SENSE_LEGS];
} soleSenseLanes;

/// Lanes [0, end). All hold numbers.
typedef void soleSenseLanesFcn( soleSenseLanes* lanes, int32_t end );

/// Several characters of one rig, whose frames are set up: what soleSense() gives for each.
void soleSenseAll( solePlaceWork* const* works, int32_t count, int32_t width );

#endif
