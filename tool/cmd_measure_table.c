// SPDX-License-Identifier: MIT
// sole measure --table: a clip baked in memory over several grounds, at several rates, with several methods, and how
// well each of them holds the targets.
#include "command.h"
#include "settings_file.h"
#include "table.h"
#include "way_options.h"

#include <getopt.h>
#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SEPARATORS " ,\t\n"

static const char toolTableHelp[] =
    "usage: sole measure CHARACTER --table [options]\n"
    "\n"
    "Bakes a character's clip in memory over each ground, at each rate, with each method, and prints a row of figures\n"
    "for each. Figures that miss their target have a '!' behind them. Grounds and rates are lists, apart by blanks or\n"
    "commas.\n"
    "\n"
    "  --clip NAME         which clip (default: the best walk)\n"
    "  --clips FILE        take the clip from this file\n"
    "  --ground \"G G ..\"   scenes or files (default: T02 T03 T11-10 T11-20 T11-30 rubble)\n"
    "  --fps \"N N ..\"      whole rates; each is compared with 60 (default: 30 60 144)\n"
    "  --method \"M M ..\"   methods, as 'sole bake --help' lists them (default: sole)\n"
    "  --settings FILE     JSON, as 'sole bake --print-settings' writes it\n"
    "  --scale X           make the character X times as large\n"
    "  --json              SI units: m, s, rad\n"
    "\n"
    "Scenes are walked along their own way. For files:\n"
    "  --path \"X,Z X,Z ..\", or --start \"X,Z\", --heading DEGREES and --distance M, as in 'sole bake'\n";

typedef struct toolTableOptions
{
	const char* character;
	const char* clip;
	const char* clips;
	const char* settings;
	double scale;
	char** grounds;
	int32_t groundCount;
	int32_t* rates;
	int32_t rateCount;
	const toolMethod** methods;
	int32_t methodCount;
	toolWayOptions way;
	bool json;
} toolTableOptions;

// -------------------------------------------------------------------------------------------------------- options

static const char* toolAddGround( const char* word, toolTableOptions* options )
{
	options->grounds = toolGrow( options->grounds, (size_t)options->groundCount + 1, sizeof *options->grounds );
	options->grounds[options->groundCount++] = toolCopyString( word );
	return NULL;
}

static const char* toolAddRate( const char* word, toolTableOptions* options )
{
	double rate = 0.0;
	if ( toolParseRange( word, 1.0, 1000.0, &rate ) == false || floor( rate ) != rate )
	{
		return "--fps needs whole rates from 1 to 1000";
	}
	options->rates = toolGrow( options->rates, (size_t)options->rateCount + 1, sizeof *options->rates );
	options->rates[options->rateCount++] = (int32_t)rate;
	return NULL;
}

static const char* toolAddMethod( const char* word, toolTableOptions* options )
{
	const toolMethod* method = toolFindMethod( word );
	if ( method == NULL )
	{
		return "--method names no method";
	}
	options->methods = toolGrow( options->methods, (size_t)options->methodCount + 1, sizeof *options->methods );
	options->methods[options->methodCount++] = method;
	return NULL;
}

/// Hands over the words of a list one by one. @return what is wrong, or NULL.
static const char* toolReadList(
    const char* text, const char* ( *add )( const char* word, toolTableOptions* options ), toolTableOptions* options )
{
	char* copy = toolCopyString( text );
	char* word = strtok( copy, SEPARATORS );
	const char* wrong = word == NULL ? "a list is empty" : NULL;
	for ( ; word != NULL && wrong == NULL; word = strtok( NULL, SEPARATORS ) )
	{
		wrong = add( word, options );
	}
	free( copy );
	return wrong;
}

static const char* toolReadTableOption( int option, const char* text, toolTableOptions* options )
{
	switch ( option )
	{
	case 't':
		return NULL;
	case 'c':
		options->clip = text;
		return NULL;
	case 'C':
		options->clips = text;
		return NULL;
	case 'S':
		options->settings = text;
		return NULL;
	case 'g':
		return toolReadList( text, toolAddGround, options );
	case 'f':
		return toolReadList( text, toolAddRate, options );
	case 'm':
		return toolReadList( text, toolAddMethod, options );
	case 's':
		return toolParseRange( text, 1e-6, 1e6, &options->scale ) ? NULL : "--scale needs a number above zero";
	case 'j':
		options->json = true;
		return NULL;
	case '?':
		return "an option is unknown or lacks its value";
	default:
		return toolReadWayOption( option, text, &options->way );
	}
}

static const char* toolCompleteTableOptions( int argc, char** argv, toolTableOptions* options )
{
	if ( optind + 1 != argc )
	{
		return "give one character";
	}
	options->character = argv[optind];
	const char* wrong = toolCheckWayOptions( &options->way );
	if ( options->groundCount == 0 )
	{
		toolReadList( "T02 T03 T11-10 T11-20 T11-30 rubble", toolAddGround, options );
	}
	if ( options->rateCount == 0 )
	{
		toolReadList( "30 60 144", toolAddRate, options );
	}
	if ( options->methodCount == 0 )
	{
		toolReadList( "sole", toolAddMethod, options );
	}
	return wrong;
}

/// @return what is wrong, or NULL; *help where the help was asked for.
static const char* toolReadTableOptions( int argc, char** argv, toolTableOptions* options, bool* help )
{
	static const struct option names[] = { { "table", no_argument, NULL, 't' },
		{ "clip", required_argument, NULL, 'c' }, { "clips", required_argument, NULL, 'C' },
		{ "ground", required_argument, NULL, 'g' }, { "fps", required_argument, NULL, 'f' },
		{ "method", required_argument, NULL, 'm' }, { "settings", required_argument, NULL, 'S' },
		{ "scale", required_argument, NULL, 's' }, { "json", no_argument, NULL, 'j' },
		{ "help", no_argument, NULL, 'h' }, TOOL_WAY_OPTIONS, { NULL, 0, NULL, 0 } };
	*options = ( toolTableOptions ){ .scale = 1.0 };
	opterr = 0;
	optind = 1;
	int option;
	while ( ( option = getopt_long( argc, argv, "h", names, NULL ) ) != -1 )
	{
		if ( option == 'h' )
		{
			*help = true;
			return NULL;
		}
		const char* wrong = toolReadTableOption( option, optarg, options );
		if ( wrong != NULL )
		{
			return wrong;
		}
	}
	return toolCompleteTableOptions( argc, argv, options );
}

static void toolFreeTableOptions( toolTableOptions* options )
{
	for ( int32_t i = 0; i < options->groundCount; ++i )
	{
		free( options->grounds[i] );
	}
	free( options->grounds );
	free( options->rates );
	free( options->methods );
	toolFreeWayOptions( &options->way );
}

// ------------------------------------------------------------------------------------------------------------ run

/// Everything that is open.
typedef struct toolTableRun
{
	toolGltf* gltf;
	toolGltf* clipsGltf; // NULL: clips are in gltf
	toolCharacter character;
	toolBoundClip bound;
	soleSettings settings;
	toolTable table;
} toolTableRun;

static void toolFreeTableRun( toolTableRun* run )
{
	toolFreeTable( &run->table );
	toolFreeBoundClip( &run->bound );
	toolFreeCharacter( &run->character );
	toolFreeGltf( run->clipsGltf );
	toolFreeGltf( run->gltf );
}

static bool toolOpenTableRun( const toolTableOptions* options, toolTableRun* run, toolError* error )
{
	run->settings = soleDefaultSettings();
	if ( ( options->settings != NULL && toolReadSettings( options->settings, &run->settings, error ) == false ) ||
	    toolOpenCharacter( options->character, &run->gltf, error ) == false ||
	    ( options->clips != NULL && toolOpenCharacter( options->clips, &run->clipsGltf, error ) == false ) )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( run->gltf );
	const toolModel* clipModel = run->clipsGltf != NULL ? toolGltf_GetModel( run->clipsGltf ) : model;
	const char* clipFile = options->clips != NULL ? options->clips : options->character;
	return toolMakeCharacter( model, options->character, (float)options->scale, &run->character, error ) &&
	    toolBindNamedClip( &run->character, clipModel, clipFile, options->clip, &run->bound, error );
}

static void toolShowProgress( double done )
{
	toolProgress( "measuring", done );
}

static bool toolRunTable( const toolTableOptions* options, toolTableRun* run, toolError* error )
{
	if ( toolOpenTableRun( options, run, error ) == false )
	{
		return false;
	}
	toolTravel travel = toolFindTravel( &run->character, &run->bound );
	toolTableDef def = {
		.character = &run->character,
		.bound = &run->bound,
		.travel = &travel,
		.settings = &run->settings,
		.grounds = (const char* const*)options->grounds,
		.groundCount = options->groundCount,
		.rates = options->rates,
		.rateCount = options->rateCount,
		.methods = options->methods,
		.methodCount = options->methodCount,
		.way = &options->way,
		.progress = toolShowProgress,
	};
	return toolMakeTable( &def, &run->table, error );
}

static void toolTellTable( const toolTableOptions* options, const toolTableRun* run )
{
	if ( options->json )
	{
		struct json_object* list = toolTableToJson( run->character.rig, &run->table );
		puts( json_object_to_json_string_ext( list, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED ) );
		json_object_put( list );
		return;
	}
	printf( "%s: %s, half a second at the start left out\n\n", options->character, run->table.clip );
	toolPrintTable( stdout, &run->table );
}

int toolRunMeasureTable( int argc, char** argv )
{
	toolTableOptions options;
	bool help = false;
	const char* wrong = toolReadTableOptions( argc, argv, &options, &help );
	int status = tool_done;
	if ( help )
	{
		fputs( toolTableHelp, stdout );
	}
	else if ( wrong != NULL )
	{
		status = toolReportUsage( "measure --table", wrong );
	}
	else
	{
		toolTableRun run = { 0 };
		toolError error = { { 0 } };
		bool good = toolRunTable( &options, &run, &error );
		if ( good )
		{
			toolTellTable( &options, &run );
		}
		status = good ? tool_done : toolReportFailure( &error );
		toolFreeTableRun( &run );
	}
	toolFreeTableOptions( &options );
	return status;
}
