// SPDX-License-Identifier: MIT
// sole report: a character's clips before and after their feet were placed, as one page that needs nothing else.
#include "bake_job.h"
#include "command.h"
#include "report.h"
#include "report_page.h"

#include <getopt.h>
#include <json-c/json.h>
#include <stdlib.h>

// -------------------------------------------------------------------------------------------------------- options

static const char toolReportHelp[] =
    "usage: sole report CHARACTER --ground GROUND -o OUT.html [options]\n"
    "\n"
    "Plays a character's clip over a ground with its feet untouched and placed, and writes one file that any browser\n"
    "opens: both in 3D along one time, heights of the soles, contacts, knees and pelvis, figures and settings.\n"
    "\n" TOOL_BAKE_HELP "  -o, --output FILE   where to write, .html\n"
    "  --method NAME       what to show beside 'none'; may be given several times (default sole), see below\n"
    "  --template FILE     the page to fill, by scripts/build_report.sh (default: the one installed with the program)\n"
    "\n"
    "Methods:\n";

typedef struct toolReportCommand
{
	toolBakeOptions bake;
	const char* template;
	bool help;
} toolReportCommand;

/// 'none' first: all others are seen beside it.
static void toolPutNoneFirst( toolBakeOptions* options )
{
	const toolMethod** methods = NULL;
	int32_t count = 0;
	toolReadMethod( "none", &methods, &count );
	for ( int32_t i = 0; i < options->methodCount; ++i )
	{
		// A second time it is refused.
		toolReadMethod( options->methods[i]->name, &methods, &count );
	}
	if ( count == 1 )
	{
		toolReadMethod( "sole", &methods, &count );
	}
	free( options->methods );
	options->methods = methods;
	options->methodCount = count;
}

// @return what is wrong, or NULL.
static const char* toolReadReportCommand( int argc, char** argv, toolReportCommand* command )
{
	static const struct option names[] = { TOOL_BAKE_OPTIONS, { "template", required_argument, NULL, 't' },
		{ NULL, 0, NULL, 0 } };
	*command = ( toolReportCommand ){ .bake = toolDefaultBakeOptions() };
	optind = 1;
	opterr = 0;
	int option;
	while ( ( option = getopt_long( argc, argv, "o:h", names, NULL ) ) != -1 )
	{
		command->help = option == 'h';
		command->template = option == 't' ? optarg : command->template;
		const char* wrong =
		    option != 'h' && option != 't' ? toolReadBakeOption( option, optarg, &command->bake ) : NULL;
		if ( wrong != NULL || command->help )
		{
			return wrong;
		}
	}
	command->bake.character = argv[optind];
	toolPutNoneFirst( &command->bake );
	return toolCheckBakeOptions( argc - optind, &command->bake );
}

// ----------------------------------------------------------------------------------------------------------- make

static bool toolBakeWalks( toolBakeJob* job, struct json_object* report, toolError* error )
{
	bool good = true;
	for ( int32_t i = 0; i < toolCountJobClips( job ) && good; ++i )
	{
		toolBakedClip baked;
		good = toolBakeJobClip( job, i, &baked, error ) && toolAddWalk( job, &baked, report, error );
		toolFreeBakedClip( &baked );
	}
	return good && toolAppendBakes( job, error );
}

/// The ground as a .glb in memory, which free() ends.
static bool toolPackGround( const toolBakeJob* job, uint8_t** bytes, size_t* byteCount, toolError* error )
{
	toolModel scene;
	toolMakeGroundModel( &job->ground, &scene );
	toolGltf* gltf = toolMakeGltf( &scene );
	bool good = gltf != NULL ? toolPackGlb( gltf, job->options->ground, bytes, byteCount, error )
	                         : toolFail( error, "%s: cannot be shown: mend its mesh", job->options->ground );
	toolFreeGltf( gltf );
	toolFreeModel( &scene );
	return good;
}

static bool toolWriteReport( const toolBakeJob* job, struct json_object* report, const char* page, toolError* error )
{
	uint8_t* character = NULL;
	uint8_t* ground = NULL;
	toolReportData data = { .json = json_object_to_json_string_ext( report, JSON_C_TO_STRING_PLAIN ) };
	bool good = toolPackGlb( job->gltf, job->options->character, &character, &data.characterCount, error ) &&
	    toolPackGround( job, &ground, &data.groundCount, error );
	if ( good )
	{
		data.character = character;
		data.ground = ground;
		size_t byteCount;
		char* text = toolFillReport( page, &data, &byteCount );
		good = toolWriteFile( job->options->output, text, byteCount, error );
		free( text );
	}
	free( character );
	free( ground );
	return good;
}

static void toolTellReport( const toolBakeJob* job )
{
	printf( "%s: open it in a browser. In it:\n", job->options->output );
	for ( int32_t i = 0; i < job->madeCount; ++i )
	{
		printf( "  %s\n", job->made[i].name );
	}
}

static int toolMakeReport( const toolReportCommand* command )
{
	toolError error = { { 0 } };
	toolBakeJob job = { 0 };
	char* page = NULL;
	struct json_object* report = NULL;
	bool good =
	    toolReadReportTemplate( command->template, &page, &error ) && toolOpenBakeJob( &command->bake, &job, &error );
	if ( good )
	{
		report = toolBeginReport( &job );
		good = toolBakeWalks( &job, report, &error ) && toolWriteReport( &job, report, page, &error );
	}
	if ( good )
	{
		toolTellReport( &job );
	}
	json_object_put( report );
	toolCloseBakeJob( &job );
	free( page );
	return good ? tool_done : toolReportFailure( &error );
}

int toolRunReport( int argc, char** argv )
{
	toolReportCommand command;
	const char* wrong = toolReadReportCommand( argc, argv, &command );
	int status = wrong != NULL ? toolReportUsage( "report", wrong ) : tool_done;
	if ( command.help )
	{
		fputs( toolReportHelp, stdout );
		toolPrintMethods();
	}
	else if ( wrong == NULL )
	{
		status = toolMakeReport( &command );
	}
	toolFreeBakeOptions( &command.bake );
	return status;
}
