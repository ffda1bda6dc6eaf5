// SPDX-License-Identifier: MIT
// The command line of `sole bake`.
#ifndef TOOL_BAKE_OPTIONS_H
#define TOOL_BAKE_OPTIONS_H

#include "settings_file.h"
#include "way_options.h"

/// What toolReadBakeOptions() answers where there is something to bake; else it is an exit status.
enum
{
	tool_goOn = -1
};

typedef struct toolBakeOptions
{
	const char* character;
	const char* ground;
	const char* output;
	const char* clipsFile;
	const char* settingsFile;
	const char* plots; // folder
	const char* trace;
	const char** clips;
	int32_t clipCount;
	const toolMethod** methods;
	int32_t methodCount;
	toolWayOptions way;
	double speed;
	double fps;
	double duration;
	float scale;
	bool autoScale;
	bool withGround;
	bool json;
	bool printSettings;
} toolBakeOptions;

/// Prints the help, the settings or what is wrong, where that is what is asked for.
int toolReadBakeOptions( int argc, char** argv, toolBakeOptions* options );
/// The list that ends a help, on stdout.
void toolPrintMethods( void );
/// Adds a method by its name to a list that free() ends. @return what is wrong, or NULL.
const char* toolReadMethod( const char* name, const toolMethod*** methods, int32_t* count );
void toolFreeBakeOptions( toolBakeOptions* options );

#endif
