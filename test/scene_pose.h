// SPDX-License-Identifier: MIT
// The pose that a host hands to Sole at one moment of an act.
#ifndef TEST_SCENE_POSE_H
#define TEST_SCENE_POSE_H

#include "scene_run.h"

/// Clips blended, strides of the wanted length, hips and feet moved as the moment says: parent-local, jointCount.
void testMakePose( const testActor* actor, const soleSceneMoment* moment, double time, soleTransform* pose );

/// Time of a gait's clip: by the way that it has gone, or by the clock where it stands.
double testGetClipTime( const testActor* actor, soleGait gait, const soleSceneMoment* moment, double time );

/// How far a foot is moved ahead at a time of the clip to make strides of the moment's length.
double testGetStrideShift( const testActor* actor, const soleSceneMoment* moment, double clipTime, int32_t side );

#endif
