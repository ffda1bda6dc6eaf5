// SPDX-License-Identifier: MIT
// The steps of a clip, and what they say during a walk: what a game would have made of its clips beforehand.
#ifndef TOOL_STEPS_H
#define TOOL_STEPS_H

#include "walker.h"

typedef struct toolSteps
{
	soleStep* steps;
	int32_t count;
} toolSteps;

/// From labels of the clip over flat ground. None where there is no memory for them: feet then go by what they do.
void toolFindSteps(
    const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, toolSteps* steps );
void toolFreeSteps( toolSteps* steps );

/// What the steps say about a leg at a time of the clip that may be longer than it.
/// @param rate at which the clip is played, seconds of it a second. 0: it stands still
/// @param input its times are those of the world, its place is as seen from where the root will be
/// @return whether it is known when the foot will come down or leave
bool toolReadStep( const toolBoundClip* bound, const toolTravel* travel, const toolSteps* steps, double clipTime,
    double rate, int32_t leg, soleContactInput* contact, soleStepInput* input );

/// How a root moves, as seen from itself: along the floor, character units/s, and about up, rad/s.
typedef struct toolPace
{
	soleVec3 velocity;
	float turnRate;
} toolPace;

/// How it has moved from one place to another. @param time that this took, s
toolPace toolFindPace( const toolCharacter* character, soleTransform before, soleTransform now, double time );

/// Contacts and steps of all legs in a frame of a walk, foreseen no better than a game can: by the clip, and by how the
/// root moves now.
void toolReadSteps( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const toolSteps* steps, const toolWalk* walk, int32_t frame, soleContactInput* contacts, soleStepInput* inputs );

#endif
