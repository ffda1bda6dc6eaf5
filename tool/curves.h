// SPDX-License-Identifier: MIT
// What feet, knees and pelvis do in the course of a bake, frame by frame: what is drawn along time.
#ifndef TOOL_CURVES_H
#define TOOL_CURVES_H

#include "bake.h"

/// Height of the lowest sole point of a leg over the terrain, m; below zero it is in the ground. NaN where there is no
/// ground below it.
/// @param heights one a frame, as in all that follow
void toolMakeHeightCurve( const toolCharacter* character, const toolBakeResult* result, const soleTerrain* terrain,
    int32_t leg, float* heights );

/// How far a leg is bent: the angles of all joints between its hip and its ankle, added up; 0 where it is straight. rad
void toolMakeBendCurve( const toolCharacter* character, const toolBakeResult* result, int32_t leg, double* angles );
/// Second differences, a second squared. NaN at both ends and across seams.
void toolMakeAccelerationCurve( const toolWalk* walk, const double* values, double* accelerations );

/// Where the pelvis is in the world.
void toolMakePelvisCurve( const toolCharacter* character, const toolBakeResult* result, soleVec3* places );

/// For which frames a method holds a foot in its place.
bool toolIsPlanted( const toolBakeResult* result, int32_t leg, int32_t frame );

#endif
