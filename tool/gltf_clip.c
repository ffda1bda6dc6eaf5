// SPDX-License-Identifier: MIT
// Clips of a glTF file: the channels that move nodes, with their keys checked.
#include "gltf_internal.h"

#include <json.h>
#include <stdlib.h>
#include <string.h>

/// Which of three words it is, else -1.
static int toolFindWord( const char* word, const char* const words[3] )
{
	int found = -1;
	for ( int i = 0; i < 3 && found < 0; ++i )
	{
		found = strcmp( word, words[i] ) == 0 ? i : -1;
	}
	return found;
}

static bool toolFindPath( const char* name, toolPath* path )
{
	static const char* const names[3] = { "translation", "rotation", "scale" };
	int found = toolFindWord( name, names );
	*path = found >= 0 ? (toolPath)found : *path;
	return found >= 0;
}

static bool toolFindInterpolation( const char* name, toolInterpolation* interpolation )
{
	static const char* const names[3] = { "LINEAR", "STEP", "CUBICSPLINE" };
	int found = toolFindWord( name, names );
	*interpolation = found >= 0 ? (toolInterpolation)found : tool_linear;
	return found >= 0 || *name == 0; // the default
}

static bool toolCheckKeys( toolGltfReader* reader, const char* owner, const toolChannel* channel, int32_t valueCount )
{
	int32_t perKey = channel->interpolation == tool_cubic ? 3 : 1;
	if ( channel->keyCount == 0 )
	{
		return toolFailFile( reader->error, reader->path, "%s has no keys: export it again", owner );
	}
	if ( valueCount / perKey != channel->keyCount || valueCount % perKey != 0 )
	{
		return toolFailFile( reader->error, reader->path, "%s has %d times but %d values: export it again", owner,
		    channel->keyCount, valueCount );
	}
	for ( int32_t i = 0; i < channel->keyCount; ++i )
	{
		if ( soleIsFinite( channel->times[i] ) == false )
		{
			return toolFailFile(
			    reader->error, reader->path, "%s: the time of key %d is not finite: export it again", owner, i );
		}
		if ( i > 0 && channel->times[i] < channel->times[i - 1] )
		{
			return toolFailFile( reader->error, reader->path,
			    "%s: key %d is earlier than the one before: sort the keys or export it again", owner, i );
		}
	}
	size_t size = channel->path == tool_pathRotation ? 4 : 3;
	int64_t bad = toolFindNotFinite( channel->values, (size_t)valueCount * size );
	if ( bad >= 0 )
	{
		return toolFailFile( reader->error, reader->path, "%s: the value of key %lld is not finite: export it again",
		    owner, (long long)( (size_t)bad / size / (size_t)perKey ) );
	}
	return true;
}

/// *used stays false for channels that move no node or move its weights.
static bool toolReadChannel( toolGltfReader* reader, json_object* object, json_object* samplers, int32_t samplerCount,
    const char* clip, toolChannel* channel, bool* used )
{
	toolModel* model = &reader->gltf->model;
	json_object* target = toolGetMember( object, "target" );
	json_object* accessors = NULL;
	int32_t accessorCount = 0;
	int32_t sampler = SOLE_NONE;
	if ( toolGetIndex( reader, target, clip, "node", model->nodeCount, &channel->node ) == false ||
	    toolGetIndex( reader, object, clip, "sampler", samplerCount, &sampler ) == false ||
	    toolGetList( reader, reader->root, "", "accessors", &accessors, &accessorCount ) == false )
	{
		return false;
	}
	if ( channel->node == SOLE_NONE || toolFindPath( toolGetText( target, "path" ), &channel->path ) == false )
	{
		return true;
	}
	char owner[200];
	toolOwner node = toolNameOwner( "nodes", (size_t)channel->node, model->nodes[channel->node].name );
	snprintf( owner, sizeof owner, "%s, %s", clip, node.text );
	json_object* how = sampler == SOLE_NONE ? NULL : json_object_array_get_idx( samplers, (size_t)sampler );
	int32_t input = SOLE_NONE;
	int32_t output = SOLE_NONE;
	if ( toolGetIndex( reader, how, owner, "input", accessorCount, &input ) == false ||
	    toolGetIndex( reader, how, owner, "output", accessorCount, &output ) == false )
	{
		return false;
	}
	if ( toolFindInterpolation( toolGetText( how, "interpolation" ), &channel->interpolation ) == false )
	{
		return toolFailFile( reader->error, reader->path, "%s has an unknown interpolation '%.24s': export it again",
		    owner, toolGetText( how, "interpolation" ) );
	}
	*used = true;
	toolAccessorUse use = channel->path == tool_pathRotation ? tool_useVec4 : tool_useVec3;
	int32_t valueCount = 0;
	return toolReadFloats( reader, input, owner, tool_useScalar, false, &channel->times, &channel->keyCount ) &&
	    toolReadFloats(
	        reader, output, owner, use, channel->path == tool_pathRotation, &channel->values, &valueCount ) &&
	    toolCheckKeys( reader, owner, channel, valueCount );
}

static void toolFindSpan( toolClip* clip )
{
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		const toolChannel* channel = clip->channels + i;
		float first = channel->times[0];
		float last = channel->times[channel->keyCount - 1];
		clip->start = i == 0 || first < clip->start ? first : clip->start;
		clip->end = i == 0 || last > clip->end ? last : clip->end;
	}
}

static bool toolReadClip( toolGltfReader* reader, json_object* object, size_t index, toolClip* clip )
{
	json_object* samplers = NULL;
	json_object* channels = NULL;
	int32_t samplerCount = 0;
	int32_t channelCount = 0;
	toolOwner owner = toolNameOwner( "animations", index, clip->name );
	char prefix[128];
	snprintf( prefix, sizeof prefix, "%s.", owner.text );
	if ( toolGetList( reader, object, prefix, "samplers", &samplers, &samplerCount ) == false ||
	    toolGetList( reader, object, prefix, "channels", &channels, &channelCount ) == false )
	{
		return false;
	}
	json_object* extras = toolGetMember( object, "extras" );
	if ( json_object_is_type( extras, json_type_object ) )
	{
		clip->extras = toolCopyString(
		    json_object_to_json_string_ext( extras, JSON_C_TO_STRING_PLAIN | JSON_C_TO_STRING_NOSLASHESCAPE ) );
	}
	clip->channels = toolAlloc( (size_t)channelCount, sizeof( toolChannel ) );
	for ( int32_t i = 0; i < channelCount; ++i )
	{
		toolChannel* channel = clip->channels + clip->channelCount;
		++clip->channelCount; // before reading, so that what fails halfway is freed
		bool used = false;
		json_object* item = json_object_array_get_idx( channels, (size_t)i );
		if ( toolReadChannel( reader, item, samplers, samplerCount, owner.text, channel, &used ) == false )
		{
			return false;
		}
		if ( used == false )
		{
			*channel = ( toolChannel ){ 0 };
			--clip->channelCount;
		}
	}
	toolFindSpan( clip );
	return true;
}

bool toolReadClips( toolGltfReader* reader )
{
	toolModel* model = &reader->gltf->model;
	json_object* list = NULL;
	int32_t count = 0;
	if ( toolGetList( reader, reader->root, "", "animations", &list, &count ) == false )
	{
		return false;
	}
	model->clips = toolAlloc( (size_t)count, sizeof( toolClip ) );
	model->clipCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* object = json_object_array_get_idx( list, (size_t)i );
		model->clips[i].name = toolCopyString( toolGetText( object, "name" ) );
		if ( toolReadClip( reader, object, (size_t)i, model->clips + i ) == false )
		{
			return false;
		}
	}
	return true;
}
