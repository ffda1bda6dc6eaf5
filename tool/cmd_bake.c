// SPDX-License-Identifier: MIT
// sole bake: a character's clips played over a ground with their feet placed, appended to the character's file.
#include "bake_options.h"
#include "command.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_DISTANCE 4.0 // m

// Everything that is open during a bake.
typedef struct toolBakeJob
{
	toolBakeOptions options;
	toolGltf* gltf;
	toolGltf* clipsGltf;
	toolCharacter character;
	toolGroundSource ground;
	soleSettings settings;
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
	return toolOpenJobCharacter( job, error ) && toolOpenGround( job->options.ground, &job->ground, error );
}

static void toolCloseJob( toolBakeJob* job )
{
	for ( int32_t i = 0; i < job->madeCount; ++i )
	{
		toolFreeClip( job->made + i );
	}
	free( job->made );
	json_object_put( job->report );
	toolFreeCharacter( &job->character );
	toolFreeGltf( job->gltf );
	toolFreeGltf( job->clipsGltf );
	toolCloseGround( &job->ground );
	toolFreeBakeOptions( &job->options );
}

// ------------------------------------------------------------------------------------------------------- one clip

// How far a clip goes where the user does not say.
static double toolGetDistance( const toolBakeOptions* options, const toolTravel* travel )
{
	double own = (double)soleLength( travel->strideVelocity );
	if ( options->hasDistance )
	{
		return options->distance;
	}
	if ( own < 0.1 && options->speed <= 0.0 )
	{
		return 0.0;
	}
	if ( options->duration > 0.0 )
	{
		return options->duration * ( options->speed > 0.0 ? options->speed : own );
	}
	bool once = travel->rootMotion && travel->loops == false;
	return once ? (double)soleLength( travel->loop.translation ) : DEFAULT_DISTANCE;
}

// The way: as given, else as the scene has it, else one that is looked for.
static bool toolLayWay(
    const toolBakeJob* job, const toolTravel* travel, toolPlace* start, toolBakeDef* def, toolError* error )
{
	const toolBakeOptions* options = &job->options;
	def->heading = options->heading;
	def->distance = toolGetDistance( options, travel );
	def->path = start;
	def->pathCount = 1;
	if ( options->pathCount > 0 )
	{
		def->path = options->path;
		def->pathCount = options->pathCount;
		return true;
	}
	if ( options->hasStart )
	{
		*start = options->start;
		return true;
	}
	if ( job->ground.path != NULL && options->hasHeading == false && options->hasDistance == false )
	{
		def->path = job->ground.path;
		def->pathCount = job->ground.pathCount;
		return true;
	}
	double step = (double)TOOL_STEP_HEIGHT * toolLegLength( &job->character );
	return toolChooseStart( job->ground.ground, options->ground, def->heading, def->distance, step, start, error );
}

static void toolReportTake( toolBakeJob* job, const toolClip* clip, const char* method, const toolBakeResult* result )
{
	const toolWalk* walk = &result->walk;
	double duration = (double)( walk->frameCount - 1 ) / walk->fps;
	soleVec3 a = walk->roots[0].translation;
	soleVec3 b = walk->roots[walk->frameCount - 1].translation;
	int32_t planted = 0;
	int32_t lost = 0;
	for ( size_t i = 0; i < (size_t)walk->frameCount * (size_t)result->legCount; ++i )
	{
		planted += ( result->flags[i] & (uint32_t)sole_legPlanted ) != 0 ? 1 : 0;
		lost += ( result->flags[i] & (uint32_t)sole_legOutOfReach ) != 0 ? 1 : 0;
	}
	if ( job->options.json == false )
	{
		printf( "%s: %d frames at %g Hz, %.2f s, from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) at %.2f m/s\n",
		    clip->name, walk->frameCount, walk->fps, duration, (double)a.x, (double)a.y, (double)a.z, (double)b.x,
		    (double)b.y, (double)b.z, walk->speed );
		return;
	}
	struct json_object* entry = json_object_new_object();
	json_object_object_add( entry, "clip", json_object_new_string( clip->name ) );
	json_object_object_add( entry, "method", json_object_new_string( method ) );
	json_object_object_add( entry, "frames", json_object_new_int( walk->frameCount ) );
	json_object_object_add( entry, "fps", json_object_new_double( walk->fps ) );
	json_object_object_add( entry, "duration", json_object_new_double( duration ) );
	json_object_object_add( entry, "speed", json_object_new_double( walk->speed ) );
	json_object_object_add( entry, "rate", json_object_new_double( walk->rate ) );
	json_object_object_add( entry, "plantedLegFrames", json_object_new_int( planted ) );
	json_object_object_add( entry, "outOfReachLegFrames", json_object_new_int( lost ) );
	json_object_array_add( json_object_object_get( job->report, "clips" ), entry );
}

static bool toolBakeMethods( toolBakeJob* job, const toolBoundClip* bound, toolError* error )
{
	const toolBakeOptions* options = &job->options;
	toolTravel travel = toolFindTravel( &job->character, bound );
	toolBakeDef def = toolDefaultBakeDef();
	toolPlace start;
	if ( toolLayWay( job, &travel, &start, &def, error ) == false )
	{
		return false;
	}
	def.settings = &job->settings;
	def.groundName = options->ground;
	def.speed = options->speed;
	def.duration = options->duration;
	def.fps = options->fps;
	for ( int32_t i = 0; i < options->methodCount; ++i )
	{
		def.method = options->methods[i];
		toolBakeResult result;
		if ( toolBake( &job->character, bound, &travel, job->ground.ground, &def, &result, error ) == false )
		{
			return false;
		}
		job->made = toolGrow( job->made, (size_t)job->madeCount + 1, sizeof *job->made );
		toolClip* clip = job->made + job->madeCount++;
		toolMakeBakedClip( &job->character, bound, &travel, def.method->name, &result, clip );
		toolReportTake( job, clip, def.method->name, &result );
		toolFreeBakeResult( &result );
		if ( toolFindClip( toolGltf_GetModel( job->gltf ), clip->name ) != SOLE_NONE )
		{
			return toolFail(
			    error, "%s: already has a clip '%s': bake from the file without it", options->character, clip->name );
		}
	}
	return true;
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
		bool named = options->clipCount > 0;
		int32_t index = named ? toolFindClip( model, options->clips[i] ) : toolChooseClip( model );
		if ( index == SOLE_NONE && named )
		{
			return toolFail( error, "%s: has no clip '%s': 'sole inspect' lists its clips", file, options->clips[i] );
		}
		if ( index == SOLE_NONE )
		{
			return toolFail( error, "%s: has no clips: give a file that has them with --clips", file );
		}
		toolProgress( "baking", (double)i / (double)count );
		toolBoundClip bound;
		toolError inner = { { 0 } };
		if ( toolBindClip( &job->character, model, index, &bound, &inner ) == false )
		{
			return toolFail( error, "%s: %s", file, inner.text );
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
	return toolWriteGltf( job->gltf, job->options.output, error );
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
		puts( json_object_to_json_string_ext( job.report, JSON_C_TO_STRING_PRETTY ) );
	}
	status = good ? tool_done : toolReportFailure( &error );
	toolCloseJob( &job );
	return status;
}
