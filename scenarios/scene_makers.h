// SPDX-License-Identifier: MIT
// What makes each scene: by formula, world space, metres, +Y up, along +Z. What the value means is the maker's own; a
// table in scenario.c says which scene is made of what.
#ifndef SCENARIOS_SCENE_MAKERS_H
#define SCENARIOS_SCENE_MAKERS_H

#include "scene_builder.h"

/// @param ends z of the solid's ends, for the path
typedef void soleSceneMaker( soleSceneBuilder* builder, double value, uint32_t seed, double ends[2] );

// scene_ground.c

soleSceneMaker soleMakeSlab; // size
soleSceneMaker soleMakeRamp; // slope
soleSceneMaker soleMakeLongRamp;
soleSceneMaker soleMakeStairs; // 0: 8 of 0.17 x 0.29, 1: 12 of them, 2: 12 of 0.20 x 0.25, 3: 12 wide ones
soleSceneMaker soleMakeRubble; // length
soleSceneMaker soleMakeCourse;
soleSceneMaker soleMakeCurb;         // rise
soleSceneMaker soleMakeBars;         // size
soleSceneMaker soleMakeTrenches;     // depth
soleSceneMaker soleMakeCrest;        // slope
soleSceneMaker soleMakeSideSlope;    // slope
soleSceneMaker soleMakeRidge;        // slope of either side
soleSceneMaker soleMakeNoiseTerrain; // size
soleSceneMaker soleMakeBoxes;        // size

// scene_obstacles.c

soleSceneMaker soleMakeOpenStairs; // width of the slots
soleSceneMaker soleMakeBoxRamp;    // slope
soleSceneMaker soleMakeWedge;      // slope of its sides
soleSceneMaker soleMakeTwoGrounds; // how much lower the ground for feet is than that for the root
soleSceneMaker soleMakeLog;        // length
soleSceneMaker soleMakeBench;
soleSceneMaker soleMakePlatform; // drop; 0: nothing below
soleSceneMaker soleMakeBeam;     // width

// scene_round.c

soleSceneMaker soleMakePlanet;   // radius
soleSceneMaker soleMakeOverhang; // height of the slab over the floor

// scene_moving.c

soleSceneMaker soleMakeLooseBoxes;  // speed of the pushed one
soleSceneMaker soleMakeRisingFloor; // height
soleSceneMaker soleMakePlate;       // 0: lift, 1: slide, 2: both
soleSceneMaker soleMakeTurntable;   // rad/s
soleSceneMaker soleMakeTwoPlates;   // height of the wave
soleSceneMaker soleMakeSeeSaw;      // largest tilt

#endif
