// SPDX-License-Identifier: MIT
// sole bake: a character's clips played over a ground with their feet placed, appended to the character's file.
#include "bake_job.h"
#include "command.h"
#include "figures_text.h"
#include "plots.h"
#include "trace_file.h"

#include <getopt.h>
#include <json-c/json.h>
#include <stdlib.h>

// -------------------------------------------------------------------------------------------------------- options

// Options of this command alone.
enum
{
	tool_optionPlots = 1024,
	tool_optionTrace,
	tool_optionPrintSettings,
	tool_optionWithGround,
	tool_optionJson
};

static const struct option toolOptions[] = {
	TOOL_BAKE_OPTIONS,
	{ "trace", required_argument, NULL, tool_optionTrace },
	{ "plots", required_argument, NULL, tool_optionPlots },
	{ "print-settings", no_argument, NULL, tool_optionPrintSettings },
	{ "with-ground", no_argument, NULL, tool_optionWithGround },
	{ "json", no_argument, NULL, tool_optionJson },
	{ NULL, 0, NULL, 0 },
};

static const char toolHelp[] =
    "usage: sole bake CHARACTER --ground GROUND -o OUT.glb [options]\n"
    "\n"
    "Plays a character's clip over a ground with its feet placed, and writes the character's file with the result\n"
    "as a new clip NAME|METHOD behind the others.\n"
    "\n" TOOL_BAKE_HELP "  -o, --output FILE   where to write, .glb or .gltf\n"
    "  --method NAME       may be given several times (default sole), see below\n"
    "  --print-settings    print the settings that would be used, and stop\n"
    "  --plots FOLDER      write SVG pictures there: sole heights of each foot, and the character on its way\n"
    "  --trace FILE        record all that goes into method sole and comes out, for 'sole replay'\n"
    "  --with-ground       add the ground to the scene\n"
    "  --json              print what was done as JSON\n"
    "\n"
    "Methods:\n";

typedef struct toolBakeCommand
{
	toolBakeOptions bake;
	const char* plots; // folder
	const char* trace;
	bool withGround;
	bool json;
	bool printSettings;
	bool help;
} toolBakeCommand;

// @return what is wrong, or NULL.
static const char* toolReadOption( int option, const char* text, toolBakeCommand* command )
{
	switch ( option )
	{
	case tool_optionPlots:
		command->plots = text;
		return NULL;
	case tool_optionTrace:
		command->trace = text;
		return NULL;
	case tool_optionPrintSettings:
		command->printSettings = true;
		return NULL;
	case tool_optionWithGround:
		command->withGround = true;
		return NULL;
	case tool_optionJson:
		command->json = true;
		return NULL;
	case 'h':
		command->help = true;
		return NULL;
	default:
		return toolReadBakeOption( option, text, &command->bake );
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

static const char* toolCheckCommand( int rest, const toolBakeCommand* command )
{
	if ( command->printSettings )
	{
		return rest > 1 ? "one character at a time" : NULL;
	}
	const char* wrong = toolCheckBakeOptions( rest, &command->bake );
	return wrong == NULL && command->trace != NULL ? toolCheckTrace( &command->bake ) : wrong;
}

// @return what is wrong, or NULL.
static const char* toolReadCommand( int argc, char** argv, toolBakeCommand* command )
{
	*command = ( toolBakeCommand ){ .bake = toolDefaultBakeOptions() };
	optind = 1;
	opterr = 0;
	int option;
	while ( ( option = getopt_long( argc, argv, "o:h", toolOptions, NULL ) ) != -1 )
	{
		const char* wrong = toolReadOption( option, optarg, command );
		if ( wrong != NULL || command->help )
		{
			return wrong;
		}
	}
	const char* wrong = toolCheckCommand( argc - optind, command );
	command->bake.character = argv[optind];
	if ( command->bake.methodCount == 0 )
	{
		toolReadMethod( "sole", &command->bake.methods, &command->bake.methodCount );
	}
	return wrong;
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

// ----------------------------------------------------------------------------------------------------------- tell

static void toolPrintWay( const toolBakedTake* taken )
{
	const toolWalk* walk = &taken->result.walk;
	soleVec3 a = walk->roots[0].translation;
	soleVec3 b = walk->roots[walk->frameCount - 1].translation;
	printf( "%s: %d frames at %g Hz, %.2f s, from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) at %.2f m/s\n", taken->name,
	    walk->frameCount, walk->fps, (double)( walk->frameCount - 1 ) / walk->fps, (double)a.x, (double)a.y,
	    (double)a.z, (double)b.x, (double)b.y, (double)b.z, walk->speed );
}

static void toolPrintTakes( const toolBakeJob* job, const toolBakedClip* baked )
{
	int32_t count = baked->takeCount;
	toolFigureColumn* columns = toolAlloc( (size_t)count + 1, sizeof *columns );
	for ( int32_t i = 0; i < count; ++i )
	{
		const toolBakedTake* taken = baked->takes + i;
		toolPrintWay( taken );
		columns[i] = ( toolFigureColumn ){ taken->method->name, &taken->figures, &taken->reference, NULL };
	}
	columns[count] = ( toolFigureColumn ){ "reference", &baked->takes[0].reference, NULL, NULL };
	puts( "" );
	toolPrintFigures( stdout, job->character.rig, columns, count + 1 );
	puts( "" );
	free( columns );
}

static struct json_object* toolTakeToJson( const toolBakeJob* job, const toolBakedTake* taken )
{
	const toolWalk* walk = &taken->result.walk;
	struct json_object* entry = toolFiguresToJson( job->character.rig, &taken->figures );
	json_object_object_add( entry, "clip", json_object_new_string( taken->name ) );
	json_object_object_add( entry, "method", json_object_new_string( taken->method->name ) );
	json_object_object_add( entry, "frames", json_object_new_int( walk->frameCount ) );
	json_object_object_add( entry, "fps", json_object_new_double( walk->fps ) );
	json_object_object_add( entry, "duration", json_object_new_double( (double)( walk->frameCount - 1 ) / walk->fps ) );
	json_object_object_add( entry, "speed", json_object_new_double( walk->speed ) );
	json_object_object_add( entry, "rate", json_object_new_double( walk->rate ) );
	json_object_object_add( entry, "ratios", toolRatiosToJson( &taken->figures, &taken->reference ) );
	return entry;
}

static void toolTellTakes(
    const toolBakeCommand* command, const toolBakeJob* job, const toolBakedClip* baked, struct json_object* list )
{
	if ( command->json == false )
	{
		toolPrintTakes( job, baked );
		return;
	}
	for ( int32_t i = 0; i < baked->takeCount; ++i )
	{
		json_object_array_add( list, toolTakeToJson( job, baked->takes + i ) );
	}
}

static bool toolPlotTakes( const char* folder, const toolBakeJob* job, const toolBakedClip* baked, toolError* error )
{
	toolPlotTake* plots = toolAlloc( (size_t)baked->takeCount, sizeof *plots );
	for ( int32_t i = 0; i < baked->takeCount; ++i )
	{
		plots[i] = ( toolPlotTake ){ baked->takes[i].method->name, &baked->takes[i].result };
	}
	bool good = toolWritePlots( folder, &job->character, &job->ground, job->terrain, plots, baked->takeCount, error );
	free( plots );
	return good;
}

// --------------------------------------------------------------------------------------------------------- bake

static bool toolBakeClips(
    const toolBakeCommand* command, toolBakeJob* job, struct json_object* list, toolError* error )
{
	bool good = true;
	for ( int32_t i = 0; i < toolCountJobClips( job ) && good; ++i )
	{
		toolBakedClip baked;
		good = toolBakeJobClip( job, i, &baked, error );
		if ( good )
		{
			toolTellTakes( command, job, &baked, list );
			good = command->plots == NULL || toolPlotTakes( command->plots, job, &baked, error );
		}
		toolFreeBakedClip( &baked );
	}
	return good;
}

static bool toolAddGroundScene( toolBakeJob* job, toolError* error )
{
	toolModel scene;
	toolMakeGroundModel( &job->ground, &scene );
	bool good = toolGltf_AppendScene( job->gltf, &scene, error );
	toolFreeModel( &scene );
	return good;
}

static bool toolBakeAll(
    const toolBakeCommand* command, toolBakeJob* job, toolTraceFile* trace, struct json_object* list, toolError* error )
{
	if ( toolOpenBakeJob( &command->bake, job, error ) == false ||
	    ( command->trace != NULL && toolStartTrace( &job->character.rigDef, trace, error ) == false ) )
	{
		return false;
	}
	job->tracer = trace->tracer;
	return toolBakeClips( command, job, list, error ) && toolAppendBakes( job, error ) &&
	    ( command->withGround == false || toolAddGroundScene( job, error ) ) &&
	    ( command->trace == NULL || toolWriteTrace( trace, command->trace, error ) ) &&
	    toolWriteGltf( job->gltf, command->bake.output, error );
}

static int toolBakeAndTell( const toolBakeCommand* command )
{
	toolError error = { { 0 } };
	toolBakeJob job = { 0 };
	toolTraceFile trace = { 0 };
	struct json_object* report = json_object_new_object();
	struct json_object* list = json_object_new_array();
	json_object_object_add( report, "file", json_object_new_string( command->bake.output ) );
	json_object_object_add( report, "clips", list );
	bool good = toolBakeAll( command, &job, &trace, list, &error );
	if ( good && command->json )
	{
		puts( json_object_to_json_string_ext( report, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_NOSLASHESCAPE ) );
	}
	json_object_put( report );
	toolFreeTrace( &trace );
	toolCloseBakeJob( &job );
	return good ? tool_done : toolReportFailure( &error );
}

int toolRunBake( int argc, char** argv )
{
	toolBakeCommand command;
	const char* wrong = toolReadCommand( argc, argv, &command );
	int status = tool_done;
	if ( wrong != NULL )
	{
		status = toolReportUsage( "bake", wrong );
	}
	else if ( command.help )
	{
		fputs( toolHelp, stdout );
		toolPrintMethods();
	}
	else
	{
		status = command.printSettings ? toolPrintSettings( &command.bake ) : toolBakeAndTell( &command );
	}
	toolFreeBakeOptions( &command.bake );
	return status;
}
