// SPDX-License-Identifier: MIT
// sole inspect: what a character file holds, as Sole sees it, and what is wrong with it.
#include "command.h"
#include "inspect.h"
#include "source.h"

#include <getopt.h>
#include <string.h>

static const char toolInspectHelp[] =
    "usage: sole inspect CHAR.glb [--json] [--scale X|auto]\n"
    "\n"
    "Finds the legs and soles of a character and tells why it thinks so; for each clip its\n"
    "duration, its rate, whether it travels, how fast its feet walk and when they are on the\n"
    "floor; and every problem with its mend.\n"
    "\n"
    "  --json        the same as JSON: metres, seconds, character space\n"
    "  --scale X     multiply all lengths of the file with X (default 1)\n"
    "  --scale auto  such that the legs are as long as a human's, where the size is no\n"
    "                believable one\n";

typedef struct toolInspectOptions
{
	const char* path;
	float scale;
	bool automatic;
	bool json;
} toolInspectOptions;

/// @return a negative number to go on, else the exit status.
static int toolReadInspectOptions( int argc, char** argv, toolInspectOptions* options )
{
	static const struct option longOptions[] = {
		{ "json", no_argument, NULL, 'j' },
		{ "scale", required_argument, NULL, 's' },
		{ "help", no_argument, NULL, 'h' },
		{ NULL, 0, NULL, 0 },
	};
	*options = ( toolInspectOptions ){ .scale = 1.0f };
	optind = 1;
	opterr = 0;
	for ( int c = getopt_long( argc, argv, "h", longOptions, NULL ); c != -1;
	      c = getopt_long( argc, argv, "h", longOptions, NULL ) )
	{
		double number = 0.0;
		switch ( c )
		{
		case 'j':
			options->json = true;
			break;
		case 's':
			options->automatic = strcmp( optarg, "auto" ) == 0;
			if ( options->automatic )
			{
				break;
			}
			if ( toolParseNumber( optarg, &number ) == false || number < 1e-9 || number > 1e9 )
			{
				return toolReportUsage( "inspect", "--scale needs a number above zero or 'auto'" );
			}
			options->scale = (float)number;
			break;
		case 'h':
			fputs( toolInspectHelp, stdout );
			return tool_done;
		default:
			return toolReportUsage( "inspect", "unknown option" );
		}
	}
	if ( argc - optind != 1 )
	{
		return toolReportUsage( "inspect", argc == optind ? "which character?" : "one character at a time" );
	}
	options->path = argv[optind];
	return -1;
}

int toolRunInspect( int argc, char** argv )
{
	toolInspectOptions options;
	int status = toolReadInspectOptions( argc, argv, &options );
	if ( status >= 0 )
	{
		return status;
	}
	toolError error = { { 0 } };
	toolGltf* gltf = NULL;
	if ( toolOpenCharacter( options.path, &gltf, &error ) == false )
	{
		return toolReportFailure( &error );
	}
	const toolModel* model = toolGltf_GetModel( gltf );
	toolCharacter character;
	bool good = toolMakeCharacter( model, options.path, options.scale, &character, &error );
	float suggested = good ? character.report.suggestedScale : 1.0f;
	if ( good && options.automatic && suggested != 1.0f )
	{
		toolFreeCharacter( &character );
		good = toolMakeCharacter( model, options.path, suggested, &character, &error );
	}
	if ( good == false )
	{
		toolFreeGltf( gltf );
		return toolReportFailure( &error );
	}
	toolClipFacts* facts = toolInspectClips( &character );
	if ( options.json )
	{
		toolPrintInspectionJson( options.path, &character, facts );
	}
	else
	{
		toolPrintInspection( options.path, &character, facts );
	}
	toolFreeClipFacts( facts, model->clipCount );
	toolFreeCharacter( &character );
	toolFreeGltf( gltf );
	return tool_done;
}
