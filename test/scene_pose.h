// SPDX-License-Identifier: MIT
// The pose that a host hands to Sole at one moment of an act.
#ifndef TEST_SCENE_POSE_H
#define TEST_SCENE_POSE_H

#include "scene_run.h"

/// Clips blended, strides of the wanted length, hips and feet moved as the moment says: parent-local, jointCount.
void testMakePose( const testActor* actor, const soleSceneMoment* moment, double time, soleTransform* pose );

#endif
