// SPDX-License-Identifier: MIT
// sole measure --table: a clip baked in memory over several grounds, at several rates, with several methods, and how
// well each of them holds the targets.
#include "command.h"
#include "table_input.h"

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
	toolTableInput input;
	int32_t* rates;
	int32_t rateCount;
	bool json;
} toolTableOptions;

// -------------------------------------------------------------------------------------------------------- options

static const char* toolAddGroundWord( const char* word, toolTableOptions* options )
{
	toolAddGround( word, &options->input );
	return NULL;
}

static const char* toolAddMethodWord( const char* word, toolTableOptions* options )
{
	return toolAddMethod( word, &options->input );
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
	case 'g':
		return toolReadList( text, toolAddGroundWord, options );
	case 'f':
		return toolReadList( text, toolAddRate, options );
	case 'm':
		return toolReadList( text, toolAddMethodWord, options );
	case 'j':
		options->json = true;
		return NULL;
	default:
		return toolReadTableInput( option, text, &options->input );
	}
}

static const char* toolCompleteTableOptions( int argc, char** argv, toolTableOptions* options )
{
	if ( optind + 1 != argc )
	{
		return "give one character";
	}
	options->input.character = argv[optind];
	const char* wrong = toolCheckWayOptions( &options->input.way );
	if ( options->input.groundCount == 0 )
	{
		toolReadList( "T02 T03 T11-10 T11-20 T11-30 rubble", toolAddGroundWord, options );
	}
	if ( options->rateCount == 0 )
	{
		toolReadList( "30 60 144", toolAddRate, options );
	}
	if ( options->input.methodCount == 0 )
	{
		toolReadList( "sole", toolAddMethodWord, options );
	}
	return wrong;
}

/// @return what is wrong, or NULL; *help where the help was asked for.
static const char* toolReadTableOptions( int argc, char** argv, toolTableOptions* options, bool* help )
{
	static const struct option names[] = { { "table", no_argument, NULL, 't' },
		{ "ground", required_argument, NULL, 'g' }, { "fps", required_argument, NULL, 'f' },
		{ "method", required_argument, NULL, 'm' }, { "json", no_argument, NULL, 'j' },
		{ "help", no_argument, NULL, 'h' }, TOOL_TABLE_INPUT_OPTIONS, { NULL, 0, NULL, 0 } };
	*options = ( toolTableOptions ){ .input = toolDefaultTableInput() };
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

// ------------------------------------------------------------------------------------------------------------ run

static void toolShowProgress( void* user, double done )
{
	(void)user;
	toolProgress( "measuring", done );
}

static void toolTellTable( const toolTableOptions* options, const toolTableFiles* files, const toolTable* table )
{
	if ( options->json )
	{
		struct json_object* list = toolTableToJson( files->character.rig, table );
		puts( json_object_to_json_string_ext( list, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED ) );
		json_object_put( list );
		return;
	}
	printf( "%s: %s, half a second at the start left out\n\n", options->input.character, table->clip );
	toolPrintTable( stdout, table );
}

static bool toolRunTable( const toolTableOptions* options, toolError* error )
{
	toolTableFiles files = { 0 };
	toolTable table = { 0 };
	bool good = toolOpenTableFiles( &options->input, &files, error );
	if ( good )
	{
		toolTableDef def = toolMakeTableDef( &options->input, &files );
		def.rates = options->rates;
		def.rateCount = options->rateCount;
		def.progress = toolShowProgress;
		good = toolMakeTable( &def, &table, error );
	}
	if ( good )
	{
		toolTellTable( options, &files, &table );
	}
	toolFreeTable( &table );
	toolCloseTableFiles( &files );
	return good;
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
		toolError error = { { 0 } };
		status = toolRunTable( &options, &error ) ? tool_done : toolReportFailure( &error );
	}
	toolFreeTableInput( &options.input );
	free( options.rates );
	return status;
}
