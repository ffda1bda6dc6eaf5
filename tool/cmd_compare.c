// SPDX-License-Identifier: MIT
// sole compare: a clip baked in memory with every method over one ground or many, and their figures side by side.
#define _POSIX_C_SOURCE 200809L // open_memstream
#include "bake_options.h"
#include "command.h"
#include "compare.h"
#include "scenario.h"
#include "table_input.h"

#include <getopt.h>
#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>

static const char toolCompareHelp[] =
    "usage: sole compare CHARACTER --ground GROUND [options]\n"
    "       sole compare CHARACTER --all [options]\n"
    "\n"
    "Bakes a character's clip in memory over each ground with each method and prints their figures side by side. The\n"
    "best of each figure is marked, among the methods that plant their feet there.\n"
    "\n"
    "CHARACTER is a .glb, .gltf or .vrm file, or 'mannequin'. GROUND is a .glb, .gltf or .obj file, or the name of an\n"
    "embedded scene ('sole sample --list').\n"
    "\n"
    "  --ground GROUND     what to walk on; may be given several times\n"
    "  --all               all embedded scenes; those that cannot be walked are left out\n"
    "  --clip NAME         which clip (default: the best walk)\n"
    "  --clips FILE        take the clip from this file\n"
    "  --method NAME       may be given several times (default: all), see below\n"
    "  --fps N             whole rate (default 60)\n"
    "  --settings FILE     JSON, as 'sole bake --print-settings' writes it\n"
    "  --scale X           make the character X times as large\n"
    "  --markdown          tables for a page\n"
    "  --json              SI units: m, s, rad\n"
    "  -o, --output FILE   write there instead of printing\n"
    "\n"
    "Scenes are walked along their own way. For files:\n"
    "  --path \"X,Z X,Z ..\", or --start \"X,Z\", --heading DEGREES and --distance M, as in 'sole bake'\n"
    "\n"
    "Methods:\n";

typedef struct toolCompareOptions
{
	toolTableInput input;
	const char* output;
	int32_t rate;
	bool all;
	bool markdown;
	bool json;
	bool help;
} toolCompareOptions;

// --------------------------------------------------------------------------------------------------------- options

static const char* toolReadRate( const char* text, int32_t* rate )
{
	double number = 0.0;
	if ( toolParseRange( text, 1.0, 1000.0, &number ) == false || floor( number ) != number )
	{
		return "--fps needs a whole rate from 1 to 1000";
	}
	*rate = (int32_t)number;
	return NULL;
}

// @return what is wrong, or NULL.
static const char* toolReadCompareOption( int option, const char* text, toolCompareOptions* options )
{
	switch ( option )
	{
	case 'g':
		toolAddGround( text, &options->input );
		return NULL;
	case 'm':
		return toolAddMethod( text, &options->input );
	case 'f':
		return toolReadRate( text, &options->rate );
	case 'o':
		options->output = text;
		return NULL;
	case 'a':
		options->all = true;
		return NULL;
	case 'd':
		options->markdown = true;
		return NULL;
	case 'j':
		options->json = true;
		return NULL;
	case 'h':
		options->help = true;
		return NULL;
	default:
		return toolReadTableInput( option, text, &options->input );
	}
}

/// What was not said: all scenes and all methods.
static void toolCompleteCompareOptions( toolCompareOptions* options )
{
	int32_t count;
	const char* const* ids = soleGetSceneIds( &count );
	for ( int32_t i = 0; i < count && options->all; ++i )
	{
		toolAddGround( ids[i], &options->input );
	}
	const toolMethod* methods = options->input.methodCount == 0 ? toolGetMethods() : NULL;
	for ( ; methods != NULL && methods->name != NULL; ++methods )
	{
		toolAddMethod( methods->name, &options->input );
	}
}

static const char* toolCheckCompareOptions( int rest, const toolCompareOptions* options )
{
	if ( rest != 1 )
	{
		return rest == 0 ? "the character is missing" : "one character at a time";
	}
	if ( options->json && options->markdown )
	{
		return "--json and --markdown exclude each other";
	}
	if ( options->all == ( options->input.groundCount > 0 ) )
	{
		return options->all ? "--ground and --all exclude each other" : "--ground is missing, or --all";
	}
	return toolCheckWayOptions( &options->input.way );
}

// @return what is wrong, or NULL.
static const char* toolReadCompareOptions( int argc, char** argv, toolCompareOptions* options )
{
	static const struct option names[] = { { "ground", required_argument, NULL, 'g' },
		{ "all", no_argument, NULL, 'a' }, { "method", required_argument, NULL, 'm' },
		{ "fps", required_argument, NULL, 'f' }, { "output", required_argument, NULL, 'o' },
		{ "markdown", no_argument, NULL, 'd' }, { "json", no_argument, NULL, 'j' }, { "help", no_argument, NULL, 'h' },
		TOOL_TABLE_INPUT_OPTIONS, { NULL, 0, NULL, 0 } };
	*options = ( toolCompareOptions ){ .input = toolDefaultTableInput(), .rate = TOOL_BASE_RATE };
	opterr = 0;
	optind = 1;
	int option;
	while ( ( option = getopt_long( argc, argv, "o:h", names, NULL ) ) != -1 )
	{
		const char* wrong = toolReadCompareOption( option, optarg, options );
		if ( wrong != NULL || options->help )
		{
			return wrong;
		}
	}
	const char* wrong = toolCheckCompareOptions( argc - optind, options );
	options->input.character = wrong == NULL ? argv[optind] : NULL;
	toolCompleteCompareOptions( options );
	return wrong;
}

// ------------------------------------------------------------------------------------------------------------- run

/// Which part of the whole the ground is that is being compared.
typedef struct toolCompareProgress
{
	double done;
	double share;
} toolCompareProgress;

static void toolShowCompareProgress( void* user, double done )
{
	const toolCompareProgress* progress = user;
	toolProgress( "comparing", progress->done + progress->share * done );
}

/// All grounds. With --all one that cannot be walked is no failure, as long as another can.
static bool toolCompareGrounds(
    const toolCompareOptions* options, const toolTableDef* def, toolComparisons* comparisons, toolError* error )
{
	toolTableDef mine = *def;
	toolCompareProgress progress = { .share = 1.0 / (double)def->groundCount };
	mine.rates = &options->rate;
	mine.rateCount = 1;
	mine.progress = toolShowCompareProgress;
	mine.user = &progress;
	comparisons->items = toolAlloc( (size_t)def->groundCount, sizeof *comparisons->items );
	comparisons->leftOut = toolAlloc( (size_t)def->groundCount, sizeof *comparisons->leftOut );
	for ( int32_t i = 0; i < def->groundCount; ++i )
	{
		progress.done = (double)i * progress.share;
		if ( toolCompareOn( &mine, i, comparisons->items + comparisons->count, error ) )
		{
			++comparisons->count;
			continue;
		}
		if ( options->all == false )
		{
			return false;
		}
		comparisons->leftOut[comparisons->leftOutCount++] = toolCopyString( error->text );
	}
	return comparisons->count > 0;
}

static void toolTellComparisons(
    FILE* stream, const toolCompareOptions* options, const soleRig* rig, const toolComparisons* comparisons )
{
	if ( options->json )
	{
		struct json_object* list = toolComparisonsToJson( rig, comparisons );
		fputs( json_object_to_json_string_ext( list, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED ), stream );
		fputc( '\n', stream );
		json_object_put( list );
	}
	else if ( options->markdown )
	{
		toolPrintComparisonsMarkdown( stream, comparisons );
	}
	else
	{
		toolPrintComparisons( stream, comparisons );
	}
}

/// Into a file, which is then whole, or to the terminal.
static bool toolWriteComparisons(
    const toolCompareOptions* options, const soleRig* rig, const toolComparisons* comparisons, toolError* error )
{
	if ( options->output == NULL )
	{
		toolTellComparisons( stdout, options, rig, comparisons );
		return true;
	}
	char* text = NULL;
	size_t length = 0;
	FILE* stream = open_memstream( &text, &length );
	if ( stream == NULL )
	{
		return toolFail( error, "%s: there is no memory to write it in: close other programs", options->output );
	}
	toolTellComparisons( stream, options, rig, comparisons );
	bool good = fclose( stream ) == 0 && toolWriteFile( options->output, text, length, error );
	free( text );
	return good;
}

static bool toolCompare( const toolCompareOptions* options, toolError* error )
{
	toolTableFiles files = { 0 };
	toolComparisons comparisons = { .character = options->input.character, .own = toolDefaultBakeDef().method };
	bool good = toolOpenTableFiles( &options->input, &files, error );
	if ( good )
	{
		toolTableDef def = toolMakeTableDef( &options->input, &files );
		comparisons.clip = files.bound.clip->name;
		good = toolCompareGrounds( options, &def, &comparisons, error ) &&
		    toolWriteComparisons( options, files.character.rig, &comparisons, error );
	}
	toolFreeComparisons( &comparisons );
	toolCloseTableFiles( &files );
	return good;
}

int toolRunCompare( int argc, char** argv )
{
	toolCompareOptions options;
	const char* wrong = toolReadCompareOptions( argc, argv, &options );
	int status = tool_done;
	if ( options.help )
	{
		fputs( toolCompareHelp, stdout );
		toolPrintMethods();
	}
	else if ( wrong != NULL )
	{
		status = toolReportUsage( "compare", wrong );
	}
	else
	{
		toolError error = { { 0 } };
		status = toolCompare( &options, &error ) ? tool_done : toolReportFailure( &error );
	}
	toolFreeTableInput( &options.input );
	return status;
}
