// SPDX-License-Identifier: MIT
// Pictures of a bake: per foot the height of its sole over the ground along time, and the character on its way.
#ifndef TOOL_PLOTS_H
#define TOOL_PLOTS_H

#include "bake.h"
#include "source.h"

/// One method's take. All takes of a plot are of the same walk.
typedef struct toolPlotTake
{
	const char* method;
	const toolBakeResult* result;
} toolPlotTake;

/// Writes FOLDER/sole_LEG.svg for each leg with a line for each take, and FOLDER/picture.svg with a row for each take.
bool toolWritePlots( const char* folder, const toolCharacter* character, const toolGroundSource* ground,
    const soleTerrain* terrain, const toolPlotTake* takes, int32_t takeCount, toolError* error );

#endif
