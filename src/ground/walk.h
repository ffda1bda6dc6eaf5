// SPDX-License-Identifier: MIT
// A probe on its way through the tree of boxes. Those who cast many start some walks at once and take each a step
// further in turn, so that the memory that one waits for comes while the others are at work.
#ifndef SOLE_GROUND_WALK_H
#define SOLE_GROUND_WALK_H

#include "ground/block.h"

#define SOLE_WALK_MOST_BLOCKS 12
#define SOLE_WALK_MOST_WAITING 16

/// The probe as boxes want it. Aligned probes need what is swept, those through the tree the rest.
typedef struct soleBoxQuery
{
	float reach;
	float low[3]; // the box that is swept until the best so far
	float high[3];
	float inverse[3];
	float startLow[3];  // start moved up by the reach: compared with lower sides
	float startHigh[3]; // start moved down: compared with upper sides
} soleBoxQuery;

/// A triangle that a sphere may meet, but not before the bound.
typedef struct soleWaiting
{
	uint32_t place; // four times the block's number, and which of its triangles
	float bound;
} soleWaiting;

typedef struct soleWalk
{
	const soleGround* ground;
	const soleGroundQuery* query;
	soleGroundTouch* best;
	float limit;                            // travel beyond which nothing is of interest
	bool byColumns;                         // through these cells, else down the tree
	const soleGroundCell* cell;             // the first
	int32_t cellCounts[2];                  // 1 or 2 to each side
	uint32_t blocks[SOLE_WALK_MOST_BLOCKS]; // that the probe may meet, not yet asked
	int blockCount;
	soleWaiting waiting[SOLE_WALK_MOST_WAITING]; // nearest first
	int waitingCount;
	soleBoxQuery box;
} soleWalk;

/// Steps of a walk, to be taken in this order. The ground has triangles; query and best outlive the walk.
void soleStartWalk( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best, soleWalk* walk );
/// Only makes the next step faster.
void soleFetchNodes( const soleWalk* walk );
void soleGatherBlocks( soleWalk* walk );
/// Improves best by what the tree's triangles answer.
void soleFinishWalk( soleWalk* walk );

#endif
