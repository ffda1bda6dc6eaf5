// SPDX-License-Identifier: MIT
// Reads the command line of `sole bake` and says what is wrong with it.
#include "bake_options.h"

#include "command.h"

#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// Options without a short form.
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
	tool_optionPlots,
	tool_optionTrace,
	tool_optionPrintSettings,
	tool_optionScale,
	tool_optionWithGround,
	tool_optionJson
};

static const struct option toolOptions[] = {
	{ "ground", required_argument, NULL, tool_optionGround },
	{ "output", required_argument, NULL, 'o' },
	{ "clip", required_argument, NULL, tool_optionClip },
	{ "clips", required_argument, NULL, tool_optionClips },
	TOOL_WAY_OPTIONS,
	{ "speed", required_argument, NULL, tool_optionSpeed },
	{ "duration", required_argument, NULL, tool_optionDuration },
	{ "fps", required_argument, NULL, tool_optionFps },
	{ "method", required_argument, NULL, tool_optionMethod },
	{ "settings", required_argument, NULL, tool_optionSettings },
	{ "trace", required_argument, NULL, tool_optionTrace },
	{ "plots", required_argument, NULL, tool_optionPlots },
	{ "print-settings", no_argument, NULL, tool_optionPrintSettings },
	{ "scale", required_argument, NULL, tool_optionScale },
	{ "with-ground", no_argument, NULL, tool_optionWithGround },
	{ "json", no_argument, NULL, tool_optionJson },
	{ "help", no_argument, NULL, 'h' },
	{ NULL, 0, NULL, 0 },
};

static const char toolHelp[] =
    "usage: sole bake CHARACTER --ground GROUND -o OUT.glb [options]\n"
    "\n"
    "Plays a character's clip over a ground with its feet placed, and writes the character's file with the result\n"
    "as a new clip NAME|METHOD behind the others.\n"
    "\n"
    "CHARACTER is a .glb, .gltf or .vrm file, or 'mannequin'. GROUND is a .glb, .gltf or .obj file, or the name of an\n"
    "embedded scene ('sole sample --list').\n"
    "\n"
    "  --ground GROUND     what to walk on\n"
    "  -o, --output FILE   where to write, .glb or .gltf\n"
    "  --clip NAME         which clip; may be given several times (default: the best walk; without clips: stand at rest)\n"
    "  --clips FILE        take the clips from this file, by the names of its joints\n"
    "  --path \"X,Z X,Z ..\" go along these places, in metres of the ground's world\n"
    "  --start \"X,Z\"       or straight on from here: the highest surface there; \"X,Y,Z\" the nearest below Y\n"
    "  --heading DEGREES   about up, 0 along +Z, 90 along +X (default 0)\n"
    "  --distance M        so far (default 4)\n"
    "  --speed M/S         play the clip as much faster or slower (default: the clip's own speed)\n"
    "  --duration S        stop after this time; how long a clip that stands is played\n"
    "  --fps N             keys a second (default 60)\n"
    "  --method NAME       may be given several times (default sole), see below\n"
    "  --settings FILE     JSON, as --print-settings writes it; what it does not name stays\n"
    "  --print-settings    print the settings that would be used, and stop\n"
    "  --scale X           make the character X times as large; 'auto': human sized by its legs (default 1)\n"
    "  --plots FOLDER      write SVG pictures there: sole heights of each foot, and the character on its way\n"
    "  --trace FILE        record all that goes into method sole and comes out, for 'sole replay'\n"
    "  --with-ground       add the ground to the scene\n"
    "  --json              print what was done as JSON\n"
    "\n"
    "Methods:\n";

void toolPrintMethods( void )
{
	for ( const toolMethod* method = toolGetMethods(); method->name != NULL; ++method )
	{
		printf( "  %-18s  %s\n", method->name, method->summary );
	}
}

const char* toolReadMethod( const char* name, const toolMethod*** methods, int32_t* count )
{
	const toolMethod* method = toolFindMethod( name );
	if ( method == NULL )
	{
		return "--method names no method";
	}
	for ( int32_t i = 0; i < *count; ++i )
	{
		if ( ( *methods )[i] == method )
		{
			return "--method names one method twice";
		}
	}
	*methods = toolGrow( *methods, (size_t)*count + 1, sizeof **methods );
	( *methods )[( *count )++] = method;
	return NULL;
}

static const char* toolReadClipName( const char* name, toolBakeOptions* options )
{
	for ( int32_t i = 0; i < options->clipCount; ++i )
	{
		if ( strcmp( options->clips[i], name ) == 0 )
		{
			return "--clip names one clip twice";
		}
	}
	options->clips = toolGrow( options->clips, (size_t)options->clipCount + 1, sizeof *options->clips );
	options->clips[options->clipCount++] = name;
	return NULL;
}

static const char* toolReadScale( const char* text, toolBakeOptions* options )
{
	double scale = 1.0;
	options->autoScale = strcmp( text, "auto" ) == 0;
	bool good = options->autoScale || toolParseRange( text, 1e-6, 1e6, &scale );
	options->scale = (float)scale;
	return good ? NULL : "--scale is no number above zero, nor 'auto'";
}

// @return what is wrong, or NULL.
static const char* toolReadNumberOption( int option, const char* text, toolBakeOptions* options )
{
	switch ( option )
	{
	case tool_optionSpeed:
		return toolParseRange( text, 1e-3, 100.0, &options->speed ) ? NULL : "--speed is no speed in m/s up to 100";
	case tool_optionDuration:
		return toolParseRange( text, 1e-3, 3600.0, &options->duration ) ? NULL
		                                                                : "--duration is no time in seconds up to 3600";
	case tool_optionFps:
		return toolParseRange( text, 1.0, 1000.0, &options->fps ) ? NULL : "--fps is no rate from 1 to 1000";
	default:
		return toolReadWayOption( option, text, &options->way );
	}
}

// @return what is wrong, or NULL.
static const char* toolReadOption( int option, const char* text, toolBakeOptions* options )
{
	switch ( option )
	{
	case tool_optionGround:
		options->ground = text;
		return NULL;
	case 'o':
		options->output = text;
		return NULL;
	case tool_optionClip:
		return toolReadClipName( text, options );
	case tool_optionClips:
		options->clipsFile = text;
		return NULL;
	case tool_optionMethod:
		return toolReadMethod( text, &options->methods, &options->methodCount );
	case tool_optionSettings:
		options->settingsFile = text;
		return NULL;
	case tool_optionPlots:
		options->plots = text;
		return NULL;
	case tool_optionTrace:
		options->trace = text;
		return NULL;
	case tool_optionPrintSettings:
		options->printSettings = true;
		return NULL;
	case tool_optionScale:
		return toolReadScale( text, options );
	case tool_optionWithGround:
		options->withGround = true;
		return NULL;
	case tool_optionJson:
		options->json = true;
		return NULL;
	default:
		return toolReadNumberOption( option, text, options );
	}
}

// A trace is of one run of method sole.
static const char* toolCheckTrace( const toolBakeOptions* options )
{
	bool found = options->methodCount == 0;
	for ( int32_t i = 0; i < options->methodCount; ++i )
	{
		found = found || options->methods[i] == toolFindMethod( "sole" );
	}
	if ( found == false )
	{
		return "--trace records method sole, which is not among the methods";
	}
	return options->clipCount > 1 ? "--trace records one clip" : NULL;
}

static const char* toolCheckOptions( const toolBakeOptions* options, int rest )
{
	if ( options->printSettings )
	{
		return rest > 1 ? "one character at a time" : NULL;
	}
	if ( rest != 1 )
	{
		return rest == 0 ? "the character is missing" : "one character at a time";
	}
	if ( options->ground == NULL )
	{
		return "--ground is missing";
	}
	if ( options->output == NULL )
	{
		return "-o is missing: where to write";
	}
	const char* wrong = options->trace != NULL ? toolCheckTrace( options ) : NULL;
	return wrong != NULL ? wrong : toolCheckWayOptions( &options->way );
}

static int toolPrintSettings( const toolBakeOptions* options )
{
	toolError error;
	soleSettings settings = soleDefaultSettings();
	if ( options->settingsFile != NULL && toolReadSettings( options->settingsFile, &settings, &error ) == false )
	{
		return toolReportFailure( &error );
	}
	char* text = toolFormatSettings( &settings );
	fputs( text, stdout );
	free( text );
	return tool_done;
}

int toolReadBakeOptions( int argc, char** argv, toolBakeOptions* options )
{
	*options = ( toolBakeOptions ){ .fps = toolDefaultBakeDef().fps, .scale = 1.0f };
	optind = 1;
	opterr = 0;
	int option;
	while ( ( option = getopt_long( argc, argv, "o:h", toolOptions, NULL ) ) != -1 )
	{
		if ( option == 'h' )
		{
			fputs( toolHelp, stdout );
			toolPrintMethods();
			return tool_done;
		}
		const char* wrong =
		    option == '?' ? "an option is unknown or lacks its value" : toolReadOption( option, optarg, options );
		if ( wrong != NULL )
		{
			return toolReportUsage( "bake", wrong );
		}
	}
	const char* wrong = toolCheckOptions( options, argc - optind );
	if ( wrong != NULL )
	{
		return toolReportUsage( "bake", wrong );
	}
	if ( options->printSettings )
	{
		return toolPrintSettings( options );
	}
	options->character = argv[optind];
	if ( options->methodCount == 0 )
	{
		toolReadMethod( "sole", &options->methods, &options->methodCount );
	}
	return tool_goOn;
}

void toolFreeBakeOptions( toolBakeOptions* options )
{
	free( options->clips );
	free( options->methods );
	toolFreeWayOptions( &options->way );
	*options = ( toolBakeOptions ){ 0 };
}
