// SPDX-License-Identifier: MIT
// Appends clips and scenes to an open file, and makes files from nothing: an almost empty file with all appended.
#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

/// A block that others may still point into is freed with the file.
static void toolRetire( toolGltf* gltf, void* block )
{
	gltf->retired = toolGrow( gltf->retired, (size_t)gltf->retiredCount + 1, sizeof( void* ) );
	gltf->retired[gltf->retiredCount] = block;
	++gltf->retiredCount;
}

/// The list with room for more items at its end. The old one is kept for those who hold its items.
static void* toolExtend( toolGltf* gltf, void* list, int32_t count, int32_t more, size_t size )
{
	uint8_t* longer = toolAlloc( (size_t)count + (size_t)more, size );
	if ( count > 0 )
	{
		memcpy( longer, list, (size_t)count * size );
	}
	toolRetire( gltf, list );
	return longer;
}

static void* toolCopyFloats( const float* values, size_t count )
{
	float* copy = toolAlloc( count, sizeof( float ) );
	memcpy( copy, values, count * sizeof( float ) );
	return copy;
}

/// Floats of one key's values.
static size_t toolGetKeySize( const toolChannel* channel )
{
	size_t size = channel->path == tool_pathRotation ? 4 : 3;
	return channel->interpolation == tool_cubic ? 3 * size : size;
}

static toolClip toolCopyClip( const toolClip* clip )
{
	toolClip copy = *clip;
	copy.name = toolCopyString( clip->name );
	copy.extras = clip->extras != NULL ? toolCopyString( clip->extras ) : NULL;
	copy.channels = toolAlloc( (size_t)clip->channelCount, sizeof( toolChannel ) );
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		const toolChannel* channel = clip->channels + i;
		size_t count = (size_t)channel->keyCount;
		size_t size = toolGetKeySize( channel );
		copy.channels[i] = *channel;
		copy.channels[i].times = toolCopyFloats( channel->times, count );
		copy.channels[i].values = toolCopyFloats( channel->values, count * size );
		copy.start = i == 0 || channel->times[0] < copy.start ? channel->times[0] : copy.start;
		copy.end = i == 0 || channel->times[count - 1] > copy.end ? channel->times[count - 1] : copy.end;
	}
	return copy;
}

static bool toolCheckChannel( const toolGltf* gltf, const char* clip, const toolChannel* channel, toolError* error )
{
	if ( channel->node < 0 || channel->node >= gltf->model.nodeCount || channel->keyCount < 1 )
	{
		return toolFailFile(
		    error, gltf->path, "clip '%.60s' moves no node or has no keys: leave that channel out", clip );
	}
	const char* node = gltf->model.nodes[channel->node].name;
	size_t size = toolGetKeySize( channel );
	if ( toolFindNotFinite( channel->times, (size_t)channel->keyCount ) >= 0 ||
	    toolFindNotFinite( channel->values, (size_t)channel->keyCount * size ) >= 0 )
	{
		return toolFailFile(
		    error, gltf->path, "clip '%.60s', node '%.60s': a key is not finite: mend the clip", clip, node );
	}
	for ( int32_t i = 1; i < channel->keyCount; ++i )
	{
		if ( channel->times[i] <= channel->times[i - 1] )
		{
			return toolFailFile(
			    error, gltf->path, "clip '%.60s', node '%.60s': times do not ascend: mend the clip", clip, node );
		}
	}
	return true;
}

static bool toolIsObjectText( const char* text )
{
	toolJsonSummary summary;
	return toolCheckJson( text, strlen( text ), &summary ) && text[summary.root.begin] == '{';
}

bool toolGltf_AppendClip( toolGltf* gltf, const toolClip* clip, toolError* error )
{
	if ( clip->channelCount < 1 )
	{
		return toolFailFile(
		    error, gltf->path, "clip '%.60s' has no channels: there is nothing to append", clip->name );
	}
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		if ( toolCheckChannel( gltf, clip->name, clip->channels + i, error ) == false )
		{
			return false;
		}
	}
	if ( clip->extras != NULL && toolIsObjectText( clip->extras ) == false )
	{
		return toolFailFile(
		    error, gltf->path, "clip '%.60s' has extras that are no JSON object: mend them", clip->name );
	}
	toolBuilder builder;
	toolStartBuilder( gltf, &builder );
	toolBuildClip( &builder, clip );
	if ( toolCommitBuilder( gltf, &builder, error ) == false )
	{
		return false;
	}
	toolModel* model = &gltf->model;
	model->clips = toolExtend( gltf, model->clips, model->clipCount, 1, sizeof( toolClip ) );
	model->clips[model->clipCount] = toolCopyClip( clip );
	++model->clipCount;
	return true;
}

static bool toolCheckScene( const toolGltf* gltf, const toolModel* scene, toolError* error )
{
	for ( int32_t i = 0; i < scene->nodeCount; ++i )
	{
		soleTransform t = scene->nodes[i].local;
		if ( ( soleVec3_IsFinite( t.translation ) && soleQuat_IsFinite( t.rotation ) &&
		         soleVec3_IsFinite( t.scale ) ) == false )
		{
			return toolFailFile(
			    error, gltf->path, "node '%.60s' to append is not finite: mend it", scene->nodes[i].name );
		}
	}
	for ( int32_t i = 0; i < scene->meshCount; ++i )
	{
		for ( int32_t j = 0; j < scene->meshes[i].primitiveCount; ++j )
		{
			const toolPrimitive* primitive = scene->meshes[i].primitives + j;
			bool good = toolFindNotFinite( primitive->positions, (size_t)primitive->vertexCount * 3 ) < 0;
			good = good &&
			    ( primitive->normals == NULL ||
			        toolFindNotFinite( primitive->normals, (size_t)primitive->vertexCount * 3 ) < 0 );
			for ( int32_t k = 0; good && k < primitive->indexCount; ++k )
			{
				good = primitive->indices[k] < (uint32_t)primitive->vertexCount;
			}
			if ( good == false )
			{
				return toolFailFile(
				    error, gltf->path, "mesh '%.60s' to append is broken: mend it", scene->meshes[i].name );
			}
		}
	}
	return true;
}

/// Reads the model again after nodes or meshes were added. The old one is kept for those who hold parts of it.
static bool toolRenewModel( toolGltf* gltf, toolError* error )
{
	toolGltf again = { .path = gltf->path,
		.json = gltf->json,
		.jsonCount = gltf->jsonCount,
		.bin = gltf->bin,
		.binCount = gltf->binCount };
	if ( toolReadModel( &again, error ) == false )
	{
		toolFreeModel( &again.model );
		free( again.matrices );
		free( again.inScene );
		return false;
	}
	gltf->oldModels = toolGrow( gltf->oldModels, (size_t)gltf->oldModelCount + 1, sizeof( toolModel ) );
	gltf->oldModels[gltf->oldModelCount] = gltf->model;
	++gltf->oldModelCount;
	gltf->model = again.model;
	free( gltf->matrices );
	free( gltf->inScene );
	gltf->matrices = again.matrices;
	gltf->inScene = again.inScene;
	gltf->scene = again.scene;
	return true;
}

bool toolGltf_AppendScene( toolGltf* gltf, const toolModel* scene, toolError* error )
{
	if ( scene->nodeCount < 1 )
	{
		return toolFailFile( error, gltf->path, "the scene to append has no nodes: there is nothing to append" );
	}
	if ( toolCheckScene( gltf, scene, error ) == false )
	{
		return false;
	}
	toolBuilder builder;
	toolStartBuilder( gltf, &builder );
	int32_t* meshMap = toolAlloc( (size_t)scene->meshCount, sizeof( int32_t ) );
	toolBuildMeshes( &builder, scene, false, meshMap );
	toolBuildNodes( &builder, scene, false, meshMap );
	free( meshMap );
	return toolCommitBuilder( gltf, &builder, error ) && toolRenewModel( gltf, error );
}

toolGltf* toolMakeGltf( const toolModel* model )
{
	toolGltf* gltf = toolAlloc( 1, sizeof( toolGltf ) );
	gltf->path = toolCopyString( "new file" );
	gltf->json = toolCopyString( "{\"asset\":{\"version\":\"2.0\",\"generator\":\"sole\"}}" );
	gltf->jsonCount = strlen( gltf->json );
	gltf->scene = SOLE_NONE;
	toolError error;
	if ( toolCheckScene( gltf, model, &error ) == false )
	{
		toolFreeGltf( gltf );
		return NULL;
	}
	toolBuilder builder;
	toolStartBuilder( gltf, &builder );
	int32_t* meshMap = toolAlloc( (size_t)model->meshCount, sizeof( int32_t ) );
	toolBuildMeshes( &builder, model, true, meshMap );
	toolBuildSkins( &builder, model );
	toolBuildNodes( &builder, model, true, meshMap );
	free( meshMap );
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		if ( model->clips[i].channelCount > 0 )
		{
			toolBuildClip( &builder, model->clips + i );
		}
	}
	if ( toolCommitBuilder( gltf, &builder, &error ) == false || toolRenewModel( gltf, &error ) == false )
	{
		toolFreeGltf( gltf );
		return NULL;
	}
	return gltf;
}
