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

/// Contacts and steps of all legs in a frame of a walk, foreseen no better than a game can: by the clip, and by how the
/// root moves now.
void toolReadSteps( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const toolSteps* steps, const toolWalk* walk, int32_t frame, soleContactInput* contacts, soleStepInput* inputs );

#endif
