// SPDX-License-Identifier: MIT
// Many legs at once, for pipelines of one's own: reach, two bones and the foot's turn, without a state, as structure of
// arrays. As wide as the machine is, chosen at run time; each leg gets, to the bit, what soleSolveTwoBone() and the
// quaternions of math.h give for it alone.
#ifndef SOLE_BATCH_H
#define SOLE_BATCH_H

#include "sole/sole.h"

/// Three or four arrays of as many numbers as there are legs.
typedef struct soleArray3
{
	float *x, *y, *z;
} soleArray3;

typedef struct soleArray4
{
	float *x, *y, *z, *w;
} soleArray4;

/// What to solve, and where to put it. Places and turns in one space, whichever it is; bones whose joints follow one
/// another without others between them. Any array may be part of a larger one; none may overlap with one that is
/// written. No array may be NULL.
typedef struct soleLegBatch
{
	int32_t count;

	// Read: see soleTwoBoneDef.
	soleArray3 hip, knee, ankle, target, hinge;
	float *reach, *fold, *softZone;
	/// Turns: of the thigh's parent, of thigh and shin as animated, unit; and of the foot as it is wanted.
	soleArray4 parent, thigh, shin, foot;

	// Written.
	/// New turns in the spaces of their parents: of thigh, shin and foot.
	soleArray4 thigh_l, shin_l, foot_l;
	/// Where the ankle ends up.
	soleArray3 reached;
	uint32_t* flags; // soleLegFlags: softened, out of reach, folded, degenerate
} soleLegBatch;

/// Legs [first, first + count) of a batch. Ranges may be solved at the same time.
SOLE_API void soleSolveLegBatch( const soleLegBatch* batch, int32_t first, int32_t count );

/// How many legs are solved at once on this machine: 4, 8 or 16.
SOLE_API int32_t soleGetBatchWidth( void );

#endif
