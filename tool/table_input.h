// SPDX-License-Identifier: MIT
// What the commands that make tables are told alike, and what they open: character, clip, settings, grounds, methods.
#ifndef TOOL_TABLE_INPUT_H
#define TOOL_TABLE_INPUT_H

#include "table.h"

typedef struct toolTableInput
{
	const char* character;
	const char* clip;
	const char* clips;
	const char* settings;
	double scale;
	char** grounds;
	int32_t groundCount;
	const toolMethod** methods;
	int32_t methodCount;
	toolWayOptions way;
} toolTableInput;

/// Numbers of the options, none of which has a short form.
enum
{
	tool_optionTableClip = 768,
	tool_optionTableClips,
	tool_optionTableSettings,
	tool_optionTableScale
};

/// For a table of getopt_long.
#define TOOL_TABLE_INPUT_OPTIONS                                                                                       \
	{ "clip", required_argument, NULL, tool_optionTableClip },                                                         \
	    { "clips", required_argument, NULL, tool_optionTableClips },                                                   \
	    { "settings", required_argument, NULL, tool_optionTableSettings },                                             \
	    { "scale", required_argument, NULL, tool_optionTableScale }, TOOL_WAY_OPTIONS

toolTableInput toolDefaultTableInput( void );
/// @return what is wrong, or NULL.
const char* toolReadTableInput( int option, const char* text, toolTableInput* input );
void toolAddGround( const char* name, toolTableInput* input );
/// @return what is wrong, or NULL.
const char* toolAddMethod( const char* name, toolTableInput* input );
void toolFreeTableInput( toolTableInput* input );

/// Everything that is open.
typedef struct toolTableFiles
{
	toolGltf* gltf;
	toolGltf* clipsGltf; // NULL: clips are in gltf
	toolCharacter character;
	toolBoundClip bound;
	toolTravel travel;
	soleSettings settings;
} toolTableFiles;

/// Start from zeroes. What was opened before it failed is still to be closed.
bool toolOpenTableFiles( const toolTableInput* input, toolTableFiles* files, toolError* error );
void toolCloseTableFiles( toolTableFiles* files );

/// All but the rates and the progress.
toolTableDef toolMakeTableDef( const toolTableInput* input, const toolTableFiles* files );

#endif
