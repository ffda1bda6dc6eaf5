// SPDX-License-Identifier: MIT
// sole bake: a character's clips played over a ground with their feet placed, appended to the character's file.
#define _XOPEN_SOURCE 700 // realpath
#include "bake_options.h"
#include "command.h"
#include "evaluate.h"
#include "figures_text.h"
#include "plots.h"
#include "trace_file.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// Everything that is open during a bake.
typedef struct toolBakeJob
{
	toolBakeOptions options;
	toolGltf* gltf;
	toolGltf* clipsGltf;
	toolCharacter character;
	toolGroundSource ground;
	soleTerrain* terrain;
	soleSettings settings;
	toolTraceFile trace;
	toolClip* made;
	int32_t madeCount;
	struct json_object* report;
} toolBakeJob;

static const toolModel* toolClipModel( const toolBakeJob* job )
{
	return toolGltf_GetModel( job->clipsGltf != NULL ? job->clipsGltf : job->gltf );
}

static bool toolOpenJobCharacter( toolBakeJob* job, toolError* error )
{
	const toolBakeOptions* options = &job->options;
	if ( toolOpenCharacter( options->character, &job->gltf, error ) == false ||
	    ( options->clipsFile != NULL && toolReadGltf( options->clipsFile, &job->clipsGltf, error ) == false ) )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( job->gltf );
	if ( toolMakeCharacter( model, options->character, options->scale, &job->character, error ) == false )
	{
		return false;
	}
	float suggested = job->character.report.suggestedScale;
	if ( options->autoScale && suggested > 0.0f && suggested != 1.0f )
	{
		toolFreeCharacter( &job->character );
		return toolMakeCharacter( model, options->character, suggested, &job->character, error );
	}
	return true;
}

static bool toolOpenJob( toolBakeJob* job, toolError* error )
{
	job->settings = soleDefaultSettings();
	const char* settingsFile = job->options.settingsFile;
	if ( settingsFile != NULL && toolReadSettings( settingsFile, &job->settings, error ) == false )
	{
		return false;
	}
	return toolOpenJobCharacter( job, error ) && toolOpenGround( job->options.ground, &job->ground, error ) &&
	    toolMakeTerrain( &job->ground, &job->terrain, error ) &&
	    ( job->options.trace == NULL || toolStartTrace( &job->character.rigDef, &job->trace, error ) );
}

static void toolCloseJob( toolBakeJob* job )
{
	for ( int32_t i = 0; i < job->madeCount; ++i )
	{
		toolFreeClip( job->made + i );
	}
	free( job->made );
	json_object_put( job->report );
	toolFreeTrace( &job->trace );
	toolFreeCharacter( &job->character );
	toolFreeGltf( job->gltf );
	toolFreeGltf( job->clipsGltf );
	toolCloseGround( &job->ground );
	soleDestroyTerrain( job->terrain );
	toolFreeBakeOptions( &job->options );
}

// ------------------------------------------------------------------------------------------------------- one clip

// One method's take of a clip.
typedef struct toolBakedTake
{
	const char* method;
	soleFigures figures;
	soleFigures reference; // of the clip on flat ground, feet untouched
	toolBakeResult result;
} toolBakedTake;

static void toolReportTake(
    toolBakeJob* job, const char* clip, const toolBakeResult* result, const toolBakedTake* taken )
{
	const toolWalk* walk = &result->walk;
	double duration = (double)( walk->frameCount - 1 ) / walk->fps;
	soleVec3 a = walk->roots[0].translation;
	soleVec3 b = walk->roots[walk->frameCount - 1].translation;
	if ( job->options.json == false )
	{
		printf( "%s: %d frames at %g Hz, %.2f s, from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) at %.2f m/s\n", clip,
		    walk->frameCount, walk->fps, duration, (double)a.x, (double)a.y, (double)a.z, (double)b.x, (double)b.y,
		    (double)b.z, walk->speed );
		return;
	}
	struct json_object* entry = toolFiguresToJson( job->character.rig, &taken->figures );
	json_object_object_add( entry, "clip", json_object_new_string( clip ) );
	json_object_object_add( entry, "method", json_object_new_string( taken->method ) );
	json_object_object_add( entry, "frames", json_object_new_int( walk->frameCount ) );
	json_object_object_add( entry, "fps", json_object_new_double( walk->fps ) );
	json_object_object_add( entry, "duration", json_object_new_double( duration ) );
	json_object_object_add( entry, "speed", json_object_new_double( walk->speed ) );
	json_object_object_add( entry, "rate", json_object_new_double( walk->rate ) );
	json_object_object_add( entry, "ratios", toolRatiosToJson( &taken->figures, &taken->reference ) );
	json_object_array_add( json_object_object_get( job->report, "clips" ), entry );
}

static void toolPrintTakes( const toolBakeJob* job, const toolBakedTake* takes )
{
	int32_t count = job->options.methodCount;
	toolFigureColumn* columns = toolAlloc( (size_t)count + 1, sizeof *columns );
	for ( int32_t i = 0; i < count; ++i )
	{
		columns[i] = ( toolFigureColumn ){ takes[i].method, &takes[i].figures, &takes[i].reference, NULL };
	}
	columns[count] = ( toolFigureColumn ){ "reference", &takes[0].reference, NULL, NULL };
	puts( "" );
	toolPrintFigures( stdout, job->character.rig, columns, count + 1 );
	puts( "" );
	free( columns );
}

static int toolFolderLength( const char* path )
{
	const char* slash = strrchr( path, '/' );
	return slash != NULL ? (int)( slash - path ) + 1 : 0;
}

// The file of the clips as seen from the output, for its extras: by name where both are in one folder. NULL: the
// character's own file.
static char* toolNameClipsFile( const toolBakeOptions* options )
{
	const char* clips = options->clipsFile;
	if ( clips == NULL )
	{
		return NULL;
	}
	int length = toolFolderLength( clips );
	bool together =
	    length == toolFolderLength( options->output ) && strncmp( clips, options->output, (size_t)length ) == 0;
	char* full = together ? NULL : realpath( clips, NULL );
	char* name = toolCopyString( full != NULL ? full : clips + length );
	free( full );
	return name;
}

// A second clip of a name could not be told from the first.
static bool toolCheckNameFree( const toolBakeJob* job, const char* clip, const char* method, toolError* error )
{
	char* name = toolFormat( "%s|%s", clip, method );
	bool taken = toolFindClip( toolGltf_GetModel( job->gltf ), name ) != SOLE_NONE;
	if ( taken )
	{
		toolFail( error, "%s: already has a clip '%s': bake from the file without it", job->options.character, name );
	}
	free( name );
	return taken == false;
}

static bool toolBakeMethod( toolBakeJob* job, const toolBoundClip* bound, const toolTravel* travel,
    const toolBakeDef* def, toolBakedTake* taken, toolError* error )
{
	toolBakeResult* result = &taken->result;
	if ( toolBake( &job->character, bound, travel, job->ground.ground, def, result, error ) == false )
	{
		return false;
	}
	taken->method = def->method->name;
	job->made = toolGrow( job->made, (size_t)job->madeCount + 1, sizeof *job->made );
	toolClip* clip = job->made + job->madeCount++;
	char* clipsFile = toolNameClipsFile( &job->options );
	toolMakeBakedClip( &job->character, bound, travel, taken->method, clipsFile, result, clip );
	free( clipsFile );
	if ( toolMeasureBake( &job->character, result, job->terrain, &taken->figures, &taken->reference, error ) == false )
	{
		return toolFailIn( error, job->options.character );
	}
	toolReportTake( job, clip->name, result, taken );
	return true;
}

static bool toolPlotTakes( const toolBakeJob* job, const toolBakedTake* takes, toolError* error )
{
	int32_t count = job->options.methodCount;
	toolPlotTake* plots = toolAlloc( (size_t)count, sizeof *plots );
	for ( int32_t i = 0; i < count; ++i )
	{
		plots[i] = ( toolPlotTake ){ takes[i].method, &takes[i].result };
	}
	bool good = toolWritePlots( job->options.plots, &job->character, &job->ground, job->terrain, plots, count, error );
	free( plots );
	return good;
}

static bool toolBakeMethods( toolBakeJob* job, const toolBoundClip* bound, toolError* error )
{
	const toolBakeOptions* options = &job->options;
	toolTravel travel = toolFindTravel( &job->character, bound );
	toolBakeDef def = toolDefaultBakeDef();
	toolPlace start;
	def.settings = &job->settings;
	def.groundName = options->ground;
	def.speed = options->speed;
	def.duration = options->duration;
	def.fps = options->fps;
	if ( toolLayWay( &options->way, &job->character, &travel, &job->ground, &start, &def, error ) == false )
	{
		return false;
	}
	toolBakedTake* takes = toolAlloc( (size_t)options->methodCount, sizeof *takes );
	bool good = true;
	for ( int32_t i = 0; i < options->methodCount && good; ++i )
	{
		def.method = options->methods[i];
		def.tracer = def.method == toolFindMethod( "sole" ) ? job->trace.tracer : NULL;
		good = toolCheckNameFree( job, bound->clip->name, def.method->name, error ) &&
		    toolBakeMethod( job, bound, &travel, &def, takes + i, error );
	}
	if ( good && options->json == false )
	{
		toolPrintTakes( job, takes );
	}
	good = good && ( options->plots == NULL || toolPlotTakes( job, takes, error ) );
	for ( int32_t i = 0; i < options->methodCount; ++i )
	{
		toolFreeBakeResult( &takes[i].result );
	}
	free( takes );
	return good;
}

// --------------------------------------------------------------------------------------------------------- bake

static bool toolBakeClips( toolBakeJob* job, toolError* error )
{
	const toolBakeOptions* options = &job->options;
	const toolModel* model = toolClipModel( job );
	const char* file = options->clipsFile != NULL ? options->clipsFile : options->character;
	int32_t count = options->clipCount > 0 ? options->clipCount : 1;
	for ( int32_t i = 0; i < count; ++i )
	{
		toolProgress( "baking", (double)i / (double)count );
		const char* name = options->clipCount > 0 ? options->clips[i] : NULL;
		toolBoundClip bound;
		if ( toolBindNamedClip( &job->character, model, file, name, &bound, error ) == false )
		{
			return false;
		}
		bool good = toolBakeMethods( job, &bound, error );
		toolFreeBoundClip( &bound );
		if ( good == false )
		{
			return false;
		}
	}
	toolProgress( "baking", 1.0 );
	return true;
}

static bool toolWriteBake( toolBakeJob* job, toolError* error )
{
	for ( int32_t i = 0; i < job->madeCount; ++i )
	{
		if ( toolGltf_AppendClip( job->gltf, job->made + i, error ) == false )
		{
			return false;
		}
	}
	if ( job->options.withGround )
	{
		toolModel scene;
		toolMakeGroundModel( &job->ground, &scene );
		bool good = toolGltf_AppendScene( job->gltf, &scene, error );
		toolFreeModel( &scene );
		if ( good == false )
		{
			return false;
		}
	}
	return ( job->options.trace == NULL || toolWriteTrace( &job->trace, job->options.trace, error ) ) &&
	    toolWriteGltf( job->gltf, job->options.output, error );
}

int toolRunBake( int argc, char** argv )
{
	toolBakeJob job = { 0 };
	int status = toolReadBakeOptions( argc, argv, &job.options );
	if ( status != tool_goOn )
	{
		toolFreeBakeOptions( &job.options );
		return status;
	}
	toolError error = { { 0 } };
	job.report = json_object_new_object();
	json_object_object_add( job.report, "file", json_object_new_string( job.options.output ) );
	json_object_object_add( job.report, "clips", json_object_new_array() );
	bool good = toolOpenJob( &job, &error ) && toolBakeClips( &job, &error ) && toolWriteBake( &job, &error );
	if ( good && job.options.json )
	{
		puts( json_object_to_json_string_ext( job.report, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_NOSLASHESCAPE ) );
	}
	status = good ? tool_done : toolReportFailure( &error );
	toolCloseJob( &job );
	return status;
}
