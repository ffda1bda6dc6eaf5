// SPDX-License-Identifier: MIT
// The way that a character goes over a ground, as the command line says it: shared by the commands that bake.
#ifndef TOOL_WAY_OPTIONS_H
#define TOOL_WAY_OPTIONS_H

#include "bake.h"
#include "source.h"

typedef struct toolWayOptions
{
	toolPlace* path;
	int32_t pathCount;
	toolPlace start;
	double heading;
	double distance;
	bool hasStart;
	bool hasHeading;
	bool hasDistance;
} toolWayOptions;

/// Numbers of the options, none of which has a short form.
enum
{
	tool_optionPath = 512,
	tool_optionStart,
	tool_optionHeading,
	tool_optionDistance
};

/// For a table of getopt_long.
#define TOOL_WAY_OPTIONS                                                                                               \
	{ "path", required_argument, NULL, tool_optionPath }, { "start", required_argument, NULL, tool_optionStart },      \
	    { "heading", required_argument, NULL, tool_optionHeading },                                                    \
	{                                                                                                                  \
		"distance", required_argument, NULL, tool_optionDistance                                                       \
	}

/// @return what is wrong, or NULL.
const char* toolReadWayOption( int option, const char* text, toolWayOptions* way );
/// What is wrong with all of them together, or NULL.
const char* toolCheckWayOptions( const toolWayOptions* way );
void toolFreeWayOptions( toolWayOptions* way );

/// Fills in path, heading and distance of a bake whose speed and duration are known: as given, else as the scene has
/// it, else one that is looked for.
/// @param start where the path is kept if it is one place; as long as def is used
bool toolLayWay( const toolWayOptions* way, const toolCharacter* character, const toolTravel* travel,
    const toolGroundSource* ground, toolPlace* start, toolBakeDef* def, toolError* error );

#endif
