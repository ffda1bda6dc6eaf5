// SPDX-License-Identifier: MIT
// How a piece of a scene moves, as a function of time. World space, metres, seconds.
#ifndef SCENARIOS_SCENE_MOTION_H
#define SCENARIOS_SCENE_MOTION_H

#include "sole/math.h"

/// All parts add up; zeroed memory stands still for ever. At time 0 a piece is where it was made.
typedef struct soleSceneMotion
{
	soleVec3 wave;     // to and fro by this in a sine
	double waveRate;   // Hz
	soleVec3 velocity; // goes along
	double stopTime;   // until then, and stops dead. 0: never
	soleVec3 pivot;    // turns about this place, which wave and velocity carry along
	soleVec3 axis;     // unit
	double spin;       // rad/s
	double tilt;       // to and fro by this angle in a sine, rad
	double tiltRate;   // Hz
	double from;       // is there from this time on
	double until;      // and not any more from this one. 0: for ever
} soleSceneMotion;

/// From where it was at time 0 to where it is. @return false where it is not there
bool soleGetSceneMotion( const soleSceneMotion* motion, double time, soleTransform* fromStart );
/// Velocity of the place fromStart.translation, and the turn, rad/s.
void soleGetSceneMotionSpeed( const soleSceneMotion* motion, double time, soleVec3* velocity, soleVec3* spin );

#endif
