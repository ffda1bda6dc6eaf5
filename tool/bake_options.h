// SPDX-License-Identifier: MIT
// What to bake, as the command line says it: shared by the commands that bake a character's clips.
#ifndef TOOL_BAKE_OPTIONS_H
#define TOOL_BAKE_OPTIONS_H

#include "settings_file.h"
#include "way_options.h"

typedef struct toolBakeOptions
{
	const char* character;
	const char* ground;
	const char* output;
	const char* clipsFile;
	const char* settingsFile;
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
} toolBakeOptions;

/// Numbers of the options that have no short form.
enum
{
	tool_optionGround = 256,
	tool_optionClip,
	tool_optionClips,
	tool_optionSpeed,
	tool_optionDuration,
	tool_optionFps,
	tool_optionMethod,
	tool_optionSettings,
	tool_optionScale
};

/// For a table of getopt_long, with "o:h" for the short ones.
#define TOOL_BAKE_OPTIONS                                                                                              \
	{ "ground", required_argument, NULL, tool_optionGround }, { "output", required_argument, NULL, 'o' },              \
	    { "clip", required_argument, NULL, tool_optionClip }, { "clips", required_argument, NULL, tool_optionClips },  \
	    TOOL_WAY_OPTIONS, { "speed", required_argument, NULL, tool_optionSpeed },                                      \
	    { "duration", required_argument, NULL, tool_optionDuration },                                                  \
	    { "fps", required_argument, NULL, tool_optionFps }, { "method", required_argument, NULL, tool_optionMethod },  \
	    { "settings", required_argument, NULL, tool_optionSettings },                                                  \
	    { "scale", required_argument, NULL, tool_optionScale },                                                        \
	{                                                                                                                  \
		"help", no_argument, NULL, 'h'                                                                                 \
	}

/// What a help says of them.
#define TOOL_BAKE_HELP                                                                                                 \
	"CHARACTER is a .glb, .gltf or .vrm file, or 'mannequin'. GROUND is a .glb, .gltf or .obj file, or the name of "   \
	"an\n"                                                                                                             \
	"embedded scene ('sole sample --list').\n"                                                                         \
	"\n"                                                                                                               \
	"  --ground GROUND     what to walk on\n"                                                                          \
	"  --clip NAME         which clip; may be given several times (default: the best walk; without clips: stand at "   \
	"rest)\n"                                                                                                          \
	"  --clips FILE        take the clips from this file, by the names of its joints\n"                                \
	"  --path \"X,Z X,Z ..\" go along these places, in metres of the ground's world\n"                                 \
	"  --start \"X,Z\"       or straight on from here: the highest surface there; \"X,Y,Z\" the nearest below Y\n"     \
	"  --heading DEGREES   about up, 0 along +Z, 90 along +X (default 0)\n"                                            \
	"  --distance M        so far (default 4)\n"                                                                       \
	"  --speed M/S         play the clip as much faster or slower (default: the clip's own speed)\n"                   \
	"  --duration S        stop after this time; how long a clip that stands is played\n"                              \
	"  --fps N             keys a second (default 60)\n"                                                               \
	"  --settings FILE     JSON, as 'sole bake --print-settings' writes it; what it does not name stays\n"             \
	"  --scale X           make the character X times as large; 'auto': human sized by its legs (default 1)\n"

toolBakeOptions toolDefaultBakeOptions( void );
/// @return what is wrong, or NULL.
const char* toolReadBakeOption( int option, const char* text, toolBakeOptions* options );
/// @param rest how many arguments are no options: the character
const char* toolCheckBakeOptions( int rest, const toolBakeOptions* options );
void toolFreeBakeOptions( toolBakeOptions* options );

/// The list that ends a help, on stdout.
void toolPrintMethods( void );
/// Adds a method by its name to a list that free() ends. @return what is wrong, or NULL.
const char* toolReadMethod( const char* name, const toolMethod*** methods, int32_t* count );

#endif
