// SPDX-License-Identifier: MIT
// T54: whatever a leg and its ground may be like.
#ifndef TEST_SCENE_WILD_H
#define TEST_SCENE_WILD_H

#include "scene_run.h"

/// The worst of many poses.
typedef struct testWild
{
	int32_t broken;  // poses of which something came out that is not finite
	double reach;    // hip to ankle beyond 0.995 of the bones, or beyond the input where that is more
	double straight; // degrees by which a knee is straighter than 2 degrees, or than the input where that is less
} testWild;

/// Solves random poses over random answers of the ground, one after the other with the same memory.
testWild testTryAnything( const testActor* actor, int32_t poseCount );

#endif
