// SPDX-License-Identifier: MIT
// What a model has, as items of glTF: clips, skins, nodes.
#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

// ------------------------------------------------------------------------------------------------ clips

/// Bytes of a clip, which share one view.
typedef struct toolClipBytes
{
	uint8_t* bytes;
	size_t count;
	size_t view;
} toolClipBytes;

static size_t toolAddClipFloats( toolClipBytes* data, const float* values, size_t count )
{
	size_t at = data->count;
	data->bytes = toolGrow( data->bytes, at + count * sizeof( float ), 1 );
	memcpy( data->bytes + at, values, count * sizeof( float ) );
	data->count += count * sizeof( float );
	return at;
}

/// The accessor of a channel's times: that of an earlier channel where they are equal.
static size_t toolAddTimes(
    toolBuilder* builder, toolClipBytes* data, const toolClip* clip, int32_t index, const size_t* accessors )
{
	const toolChannel* channel = clip->channels + index;
	size_t count = (size_t)channel->keyCount;
	for ( int32_t i = 0; i < index; ++i )
	{
		const toolChannel* other = clip->channels + i;
		if ( other->keyCount == channel->keyCount &&
		    memcmp( other->times, channel->times, count * sizeof( float ) ) == 0 )
		{
			return accessors[i];
		}
	}
	size_t at = toolAddClipFloats( data, channel->times, count );
	return toolAddAccessor( builder, data->view, at, 5126, "SCALAR", count, channel->times, 1 );
}

static void toolAddSampler( toolJsonText* out, size_t input, size_t output, toolInterpolation interpolation )
{
	static const char* const names[] = { "\"LINEAR\"", "\"STEP\"", "\"CUBICSPLINE\"" };
	toolOpenItem( out );
	toolAddKey( out, "input" );
	toolAddJsonInteger( out, input );
	toolAddKey( out, "output" );
	toolAddJsonInteger( out, output );
	toolAddKey( out, "interpolation" );
	toolAddJson( out, names[interpolation] );
	toolAddJson( out, "}" );
}

static void toolAddTarget( toolJsonText* out, int32_t sampler, const toolChannel* channel )
{
	static const char* const names[] = { "\"translation\"", "\"rotation\"", "\"scale\"" };
	toolOpenItem( out );
	toolAddKey( out, "sampler" );
	toolAddJsonInteger( out, (size_t)sampler );
	toolAddKey( out, "target" );
	toolAddJson( out, "{\"node\":" );
	toolAddJsonInteger( out, (size_t)channel->node );
	toolAddKey( out, "path" );
	toolAddJson( out, names[channel->path] );
	toolAddJson( out, "}}" );
}

void toolBuildClip( toolBuilder* builder, const toolClip* clip )
{
	size_t* inputs = toolAlloc( (size_t)clip->channelCount, sizeof( size_t ) );
	toolClipBytes data = { .view = builder->viewCount };
	toolJsonText samplers = { 0 };
	toolJsonText targets = { 0 };
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		const toolChannel* channel = clip->channels + i;
		inputs[i] = toolAddTimes( builder, &data, clip, i, inputs );
		bool turns = channel->path == tool_pathRotation;
		size_t count = (size_t)channel->keyCount * ( channel->interpolation == tool_cubic ? 3 : 1 );
		size_t at = toolAddClipFloats( &data, channel->values, count * ( turns ? 4 : 3 ) );
		size_t output = toolAddAccessor( builder, data.view, at, 5126, turns ? "VEC4" : "VEC3", count, NULL, 0 );
		toolAddSampler( &samplers, inputs[i], output, channel->interpolation );
		toolAddTarget( &targets, i, channel );
	}
	toolAddView( builder, data.bytes, data.count, 0 );
	toolJsonText* out = &builder->clips;
	toolOpenItem( out );
	toolAddKey( out, "name" );
	toolAddJsonString( out, clip->name );
	toolAddKey( out, "samplers" );
	toolAddJson( out, "[" );
	toolAddJson( out, samplers.text );
	toolAddJson( out, "]" );
	toolAddKey( out, "channels" );
	toolAddJson( out, "[" );
	toolAddJson( out, targets.text );
	toolAddJson( out, "]" );
	if ( clip->extras != NULL )
	{
		toolAddKey( out, "extras" );
		toolAddJson( out, clip->extras );
	}
	toolAddJson( out, "}" );
	free( samplers.text );
	free( targets.text );
	free( data.bytes );
	free( inputs );
}

// ------------------------------------------------------------------------------------------------ nodes

void toolBuildSkins( toolBuilder* builder, const toolModel* model )
{
	for ( int32_t i = 0; i < model->skinCount; ++i )
	{
		const toolSkin* skin = model->skins + i;
		size_t count = (size_t)skin->jointCount;
		size_t view = toolAddView( builder, skin->inverseBind, count * 64, 0 );
		toolJsonText* out = &builder->skins;
		toolOpenItem( out );
		toolAddName( out, skin->name );
		toolAddKey( out, "inverseBindMatrices" );
		toolAddJsonInteger( out, toolAddAccessor( builder, view, 0, 5126, "MAT4", count, NULL, 0 ) );
		toolAddKey( out, "joints" );
		toolAddJson( out, "[" );
		for ( size_t j = 0; j < count; ++j )
		{
			toolAddJson( out, j > 0 ? "," : "" );
			toolAddJsonInteger( out, (size_t)skin->joints[j] );
		}
		toolAddJson( out, "]}" );
		++builder->skinCount;
	}
}

static void toolAddPlacement( toolJsonText* out, soleTransform t )
{
	const float translation[3] = { t.translation.x, t.translation.y, t.translation.z };
	const float rotation[4] = { t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w };
	const float scale[3] = { t.scale.x, t.scale.y, t.scale.z };
	if ( translation[0] != 0.0f || translation[1] != 0.0f || translation[2] != 0.0f )
	{
		toolAddKey( out, "translation" );
		toolAddJsonFloats( out, translation, 3 );
	}
	if ( rotation[0] != 0.0f || rotation[1] != 0.0f || rotation[2] != 0.0f || rotation[3] != 1.0f )
	{
		toolAddKey( out, "rotation" );
		toolAddJsonFloats( out, rotation, 4 );
	}
	if ( scale[0] != 1.0f || scale[1] != 1.0f || scale[2] != 1.0f )
	{
		toolAddKey( out, "scale" );
		toolAddJsonFloats( out, scale, 3 );
	}
}

/// How nodes hang together in the file.
typedef struct toolNodeLinks
{
	int32_t* parents;
	int32_t* first; // child
	int32_t* next;  // sibling
	bool* skinned;
} toolNodeLinks;

/// A skin moves its mesh past the node's own place, so that a skinned node without children may as well, and for some
/// readers must, stand at the root without one.
static toolNodeLinks toolLinkNodes( const toolModel* model, bool withSkins )
{
	size_t count = (size_t)model->nodeCount;
	toolNodeLinks links = { .parents = toolAlloc( count, sizeof( int32_t ) ),
		.first = toolAlloc( count, sizeof( int32_t ) ),
		.next = toolAlloc( count, sizeof( int32_t ) ),
		.skinned = toolAlloc( count, sizeof( bool ) ) };
	bool* hasChild = toolAlloc( count, sizeof( bool ) );
	for ( size_t i = 0; i < count; ++i )
	{
		const toolNode* node = model->nodes + i;
		links.first[i] = SOLE_NONE;
		links.next[i] = SOLE_NONE;
		links.skinned[i] =
		    withSkins && node->mesh != SOLE_NONE && node->skin != SOLE_NONE && toolIsSkinned( model, node->mesh );
		if ( node->parent != SOLE_NONE )
		{
			hasChild[node->parent] = true;
		}
	}
	for ( size_t i = count; i-- > 0; )
	{
		int32_t parent = links.skinned[i] && hasChild[i] == false ? SOLE_NONE : model->nodes[i].parent;
		links.parents[i] = parent;
		if ( parent != SOLE_NONE )
		{
			links.next[i] = links.first[parent];
			links.first[parent] = (int32_t)i;
		}
	}
	free( hasChild );
	return links;
}

static void toolAddChildren( toolJsonText* out, const toolNodeLinks* links, int32_t node, size_t base )
{
	toolAddKey( out, "children" );
	toolAddJson( out, "[" );
	for ( int32_t child = links->first[node]; child != SOLE_NONE; child = links->next[child] )
	{
		toolAddJson( out, child != links->first[node] ? "," : "" );
		toolAddJsonInteger( out, base + (size_t)child );
	}
	toolAddJson( out, "]" );
}

void toolBuildNodes( toolBuilder* builder, const toolModel* model, bool withSkins, const int32_t* meshMap )
{
	toolNodeLinks links = toolLinkNodes( model, withSkins );
	size_t base = builder->nodeCount;
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		const toolNode* node = model->nodes + i;
		toolJsonText* out = &builder->nodes;
		toolOpenItem( out );
		toolAddName( out, node->name );
		int32_t mesh = node->mesh != SOLE_NONE ? meshMap[node->mesh] : SOLE_NONE;
		bool skinned = mesh != SOLE_NONE && links.skinned[i];
		if ( mesh != SOLE_NONE )
		{
			toolAddKey( out, "mesh" );
			toolAddJsonInteger( out, (size_t)mesh );
		}
		if ( skinned )
		{
			toolAddKey( out, "skin" );
			toolAddJsonInteger( out, (size_t)node->skin );
		}
		if ( skinned == false || links.first[i] != SOLE_NONE )
		{
			toolAddPlacement( out, node->local );
		}
		if ( links.first[i] != SOLE_NONE )
		{
			toolAddChildren( out, &links, i, base );
		}
		toolAddJson( out, "}" );
		if ( links.parents[i] == SOLE_NONE )
		{
			toolAddJson( &builder->sceneNodes, builder->sceneNodes.count > 0 ? "," : "" );
			toolAddJsonInteger( &builder->sceneNodes, base + (size_t)i );
		}
		++builder->nodeCount;
	}
	free( links.parents );
	free( links.first );
	free( links.next );
	free( links.skinned );
}
