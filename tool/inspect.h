// SPDX-License-Identifier: MIT
// What 'sole inspect' finds out about a character's clips.
#ifndef TOOL_INSPECT_H
#define TOOL_INSPECT_H

#include "motion.h"

/// A time for which a foot is on the floor, s from the clip's start.
typedef struct toolInterval
{
	float start;
	float end;
} toolInterval;

typedef struct toolLegContacts
{
	int32_t count;
	toolInterval* intervals;
} toolLegContacts;

typedef struct toolClipFacts
{
	const toolClip* clip;
	/// The clip can't be used for this character; error says why. The rest is then empty.
	bool refused;
	toolError error;
	float duration;
	toolTravel travel;
	float strideSpeed; // m/s
	toolLegContacts legs[SOLE_MAX_LEGS];
} toolClipFacts;

/// Facts of each clip of the character's own model; the caller frees them with toolFreeClipFacts.
toolClipFacts* toolInspectClips( const toolCharacter* character );
void toolFreeClipFacts( toolClipFacts* facts, int32_t count );

/// Prints for people.
void toolPrintInspection( const char* path, const toolCharacter* character, const toolClipFacts* facts );
/// Prints one JSON object.
void toolPrintInspectionJson( const char* path, const toolCharacter* character, const toolClipFacts* facts );

#endif
