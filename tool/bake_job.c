// SPDX-License-Identifier: MIT
// Opens what a command line names, bakes its clips, and appends them to the character's file.
#define _XOPEN_SOURCE 700 // realpath
#include "bake_job.h"

#include <stdlib.h>
#include <string.h>

// ----------------------------------------------------------------------------------------------------------- open

static bool toolOpenJobCharacter( toolBakeJob* job, toolError* error )
{
	const toolBakeOptions* options = job->options;
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

bool toolOpenBakeJob( const toolBakeOptions* options, toolBakeJob* job, toolError* error )
{
	*job = ( toolBakeJob ){ .options = options, .settings = soleDefaultSettings() };
	if ( options->settingsFile != NULL && toolReadSettings( options->settingsFile, &job->settings, error ) == false )
	{
		return false;
	}
	return toolOpenJobCharacter( job, error ) && toolOpenGround( options->ground, &job->ground, error ) &&
	    toolMakeTerrain( &job->ground, &job->terrain, error );
}

void toolCloseBakeJob( toolBakeJob* job )
{
	for ( int32_t i = 0; i < job->madeCount; ++i )
	{
		toolFreeClip( job->made + i );
	}
	free( job->made );
	toolFreeCharacter( &job->character );
	toolFreeGltf( job->gltf );
	toolFreeGltf( job->clipsGltf );
	toolCloseGround( &job->ground );
	soleDestroyTerrain( job->terrain );
	*job = ( toolBakeJob ){ 0 };
}

// ------------------------------------------------------------------------------------------------------- one clip

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
		toolFail( error, "%s: already has a clip '%s': bake from the file without it", job->options->character, name );
	}
	free( name );
	return taken == false;
}

static bool toolBakeMethod( toolBakeJob* job, const toolBoundClip* bound, const toolTravel* travel,
    const toolBakeDef* def, toolBakedTake* taken, toolError* error )
{
	toolBakeResult* result = &taken->result;
	taken->method = def->method;
	if ( toolBake( &job->character, bound, travel, job->ground.ground, def, result, error ) == false )
	{
		return false;
	}
	job->made = toolGrow( job->made, (size_t)job->madeCount + 1, sizeof *job->made );
	toolClip* clip = job->made + job->madeCount++;
	char* clipsFile = toolNameClipsFile( job->options );
	toolMakeBakedClip( &job->character, bound, travel, def->method->name, clipsFile, result, clip );
	free( clipsFile );
	taken->name = toolCopyString( clip->name );
	return toolMeasureBake( &job->character, result, job->terrain, &taken->figures, &taken->reference, error ) ||
	    toolFailIn( error, job->options->character );
}

static bool toolBakeMethods( toolBakeJob* job, const toolBoundClip* bound, toolBakedClip* baked, toolError* error )
{
	const toolBakeOptions* options = job->options;
	toolTravel travel = toolFindTravel( &job->character, bound );
	toolBakeDef def = toolDefaultBakeDef();
	toolPlace start;
	def.settings = &job->settings;
	def.groundName = options->ground;
	def.speed = options->speed;
	def.duration = options->duration;
	def.fps = options->fps;
	bool good = toolLayWay( &options->way, &job->character, &travel, &job->ground, &start, &def, error );
	for ( int32_t i = 0; i < options->methodCount && good; ++i )
	{
		def.method = options->methods[i];
		def.tracer = def.method == toolFindMethod( "sole" ) ? job->tracer : NULL;
		good = toolCheckNameFree( job, bound->clip->name, def.method->name, error ) &&
		    toolBakeMethod( job, bound, &travel, &def, baked->takes + i, error );
	}
	return good;
}

int32_t toolCountJobClips( const toolBakeJob* job )
{
	return job->options->clipCount > 0 ? job->options->clipCount : 1;
}

bool toolBakeJobClip( toolBakeJob* job, int32_t index, toolBakedClip* baked, toolError* error )
{
	const toolBakeOptions* options = job->options;
	const toolModel* model = toolGltf_GetModel( job->clipsGltf != NULL ? job->clipsGltf : job->gltf );
	const char* file = options->clipsFile != NULL ? options->clipsFile : options->character;
	const char* name = options->clipCount > 0 ? options->clips[index] : NULL;
	*baked = ( toolBakedClip ){ 0 };
	toolProgress( "baking", (double)index / (double)toolCountJobClips( job ) );
	toolBoundClip bound;
	if ( toolBindNamedClip( &job->character, model, file, name, &bound, error ) == false )
	{
		return false;
	}
	baked->name = toolCopyString( bound.clip->name );
	baked->takes = toolAlloc( (size_t)options->methodCount, sizeof *baked->takes );
	baked->takeCount = options->methodCount;
	bool good = toolBakeMethods( job, &bound, baked, error );
	toolFreeBoundClip( &bound );
	if ( good && index + 1 == toolCountJobClips( job ) )
	{
		toolProgress( "baking", 1.0 );
	}
	return good;
}

void toolFreeBakedClip( toolBakedClip* baked )
{
	for ( int32_t i = 0; i < baked->takeCount; ++i )
	{
		free( baked->takes[i].name );
		toolFreeBakeResult( &baked->takes[i].result );
	}
	free( baked->takes );
	free( baked->name );
	*baked = ( toolBakedClip ){ 0 };
}

bool toolAppendBakes( toolBakeJob* job, toolError* error )
{
	bool good = true;
	for ( int32_t i = 0; i < job->madeCount && good; ++i )
	{
		good = toolGltf_AppendClip( job->gltf, job->made + i, error );
	}
	return good;
}
