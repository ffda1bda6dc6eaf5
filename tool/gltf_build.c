// SPDX-License-Identifier: MIT
// New items for a file's lists: views, accessors, clips, nodes, skins, materials. Collected first, then put into the
// file's JSON at its lists' ends and behind its BIN, so that all that was there stays as it was.
#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

/// The bytes of a list at the root; false where there is none or something else stands there.
static bool toolFindRootList( const toolGltf* gltf, const char* key, toolJsonRange* list )
{
	toolJsonSummary summary;
	toolCheckJson( gltf->json, gltf->jsonCount, &summary );
	return toolFindJsonMember( gltf->json, summary.root, key, list ) && gltf->json[list->begin] == '[';
}

static size_t toolCountRootItems( const toolGltf* gltf, const char* key )
{
	toolJsonRange list;
	return toolFindRootList( gltf, key, &list ) ? toolCountJsonItems( gltf->json, list ) : 0;
}

void toolStartBuilder( const toolGltf* gltf, toolBuilder* builder )
{
	*builder = ( toolBuilder ){
		.binBase = ( gltf->binCount + 3 ) & ~(size_t)3,
		.viewCount = toolCountRootItems( gltf, "bufferViews" ),
		.accessorCount = toolCountRootItems( gltf, "accessors" ),
		.meshCount = toolCountRootItems( gltf, "meshes" ),
		.nodeCount = toolCountRootItems( gltf, "nodes" ),
		.materialCount = toolCountRootItems( gltf, "materials" ),
		.skinCount = toolCountRootItems( gltf, "skins" ),
	};
}

void toolOpenItem( toolJsonText* list )
{
	toolAddJson( list, list->count > 0 && list->text[list->count - 1] != '[' ? ",{" : "{" );
}

void toolAddKey( toolJsonText* out, const char* key )
{
	toolAddJson( out, out->text[out->count - 1] == '{' ? "\"" : ",\"" );
	toolAddJson( out, key );
	toolAddJson( out, "\":" );
}

void toolAddName( toolJsonText* out, const char* name )
{
	if ( *name != 0 )
	{
		toolAddKey( out, "name" );
		toolAddJsonString( out, name );
	}
}

/// Items at the end of a list at the root, or the list where there is none.
static void toolAppendToRoot( const toolGltf* gltf, toolJsonEdits* edits, const char* key, const toolJsonText* items )
{
	if ( items->count == 0 )
	{
		return;
	}
	toolJsonSummary summary;
	toolCheckJson( gltf->json, gltf->jsonCount, &summary );
	toolJsonRange list;
	if ( toolFindJsonMember( gltf->json, summary.root, key, &list ) == false )
	{
		char* member = toolFormat( "\"%s\":[%s]", key, items->text );
		toolAppendJson( edits, gltf->json, summary.root, member );
		free( member );
	}
	else if ( gltf->json[list.begin] == '[' )
	{
		toolAppendJson( edits, gltf->json, list, items->text );
	}
	else
	{
		// null, which readers take for nothing
		char* text = toolFormat( "[%s]", items->text );
		toolReplaceJson( edits, list, text );
		free( text );
	}
}

/// buffers[0].byteLength becomes the new length of BIN.
static void toolSetBinLength( const toolGltf* gltf, toolJsonEdits* edits, size_t length )
{
	char digits[32];
	snprintf( digits, sizeof digits, "%zu", length );
	toolJsonRange buffers;
	toolJsonRange buffer;
	toolJsonRange old;
	bool found = toolFindRootList( gltf, "buffers", &buffers ) && toolFindJsonItem( gltf->json, buffers, 0, &buffer ) &&
	    gltf->json[buffer.begin] == '{';
	if ( found && toolFindJsonMember( gltf->json, buffer, "byteLength", &old ) )
	{
		toolReplaceJson( edits, old, digits );
		return;
	}
	char* text = toolFormat( found ? "\"byteLength\":%s" : "{\"byteLength\":%s}", digits );
	toolJsonText items = { .text = text, .count = strlen( text ) };
	if ( found )
	{
		toolAppendJson( edits, gltf->json, buffer, text );
	}
	else
	{
		toolAppendToRoot( gltf, edits, "buffers", &items );
	}
	free( text );
}

/// New nodes are shown by the default scene. Where there was none, everything was shown: then so does the new one.
static void toolExtendScene( const toolGltf* gltf, toolJsonEdits* edits, const toolJsonText* nodes )
{
	if ( nodes->count == 0 )
	{
		return;
	}
	toolJsonRange scenes;
	toolJsonRange scene;
	toolJsonRange list;
	bool found = gltf->scene != SOLE_NONE && toolFindRootList( gltf, "scenes", &scenes ) &&
	    toolFindJsonItem( gltf->json, scenes, (size_t)gltf->scene, &scene ) && gltf->json[scene.begin] == '{';
	if ( found && toolFindJsonMember( gltf->json, scene, "nodes", &list ) && gltf->json[list.begin] == '[' )
	{
		toolAppendJson( edits, gltf->json, list, nodes->text );
		return;
	}
	if ( found )
	{
		char* member = toolFormat( "\"nodes\":[%s]", nodes->text );
		toolAppendJson( edits, gltf->json, scene, member );
		free( member );
		return;
	}
	toolJsonText items = { 0 };
	toolAddJson( &items, "{\"nodes\":[" );
	for ( int32_t i = 0; i < gltf->model.nodeCount; ++i )
	{
		if ( gltf->model.nodes[i].parent == SOLE_NONE )
		{
			toolAddJsonInteger( &items, (size_t)i );
			toolAddJson( &items, "," );
		}
	}
	toolAddJson( &items, nodes->text );
	toolAddJson( &items, "]}" );
	toolAppendToRoot( gltf, edits, "scenes", &items );
	free( items.text );
	toolJsonSummary summary;
	toolCheckJson( gltf->json, gltf->jsonCount, &summary );
	toolAppendJson( edits, gltf->json, summary.root, "\"scene\":0" );
}

static void toolFreeBuilder( toolBuilder* builder )
{
	free( builder->views.text );
	free( builder->accessors.text );
	free( builder->meshes.text );
	free( builder->nodes.text );
	free( builder->materials.text );
	free( builder->skins.text );
	free( builder->clips.text );
	free( builder->sceneNodes.text );
	free( builder->bin );
	*builder = ( toolBuilder ){ 0 };
}

bool toolCommitBuilder( toolGltf* gltf, toolBuilder* builder, toolError* error )
{
	size_t length = builder->binBase + builder->binCount;
	if ( length > UINT32_MAX / 2 )
	{
		toolFreeBuilder( builder );
		return toolFailFile( error, gltf->path, "would grow beyond 2 GiB: append fewer or shorter clips" );
	}
	toolJsonEdits edits = { 0 };
	toolAppendToRoot( gltf, &edits, "bufferViews", &builder->views );
	toolAppendToRoot( gltf, &edits, "accessors", &builder->accessors );
	toolAppendToRoot( gltf, &edits, "materials", &builder->materials );
	toolAppendToRoot( gltf, &edits, "meshes", &builder->meshes );
	toolAppendToRoot( gltf, &edits, "skins", &builder->skins );
	toolAppendToRoot( gltf, &edits, "nodes", &builder->nodes );
	toolAppendToRoot( gltf, &edits, "animations", &builder->clips );
	toolExtendScene( gltf, &edits, &builder->sceneNodes );
	if ( builder->binCount > 0 )
	{
		toolSetBinLength( gltf, &edits, length );
		gltf->bin = toolGrow( gltf->bin, length, 1 );
		memset( gltf->bin + gltf->binCount, 0, builder->binBase - gltf->binCount );
		memcpy( gltf->bin + builder->binBase, builder->bin, builder->binCount );
		gltf->binCount = length;
	}
	size_t count = 0;
	char* text = toolApplyJsonEdits( &edits, gltf->json, gltf->jsonCount, &count );
	free( gltf->json );
	gltf->json = text;
	gltf->jsonCount = count;
	gltf->changed = true;
	toolFreeBuilder( builder );
	return true;
}

size_t toolAddView( toolBuilder* builder, const void* bytes, size_t byteCount, int target )
{
	size_t padded = ( byteCount + 3 ) & ~(size_t)3;
	if ( builder->binCount + padded > builder->binCapacity )
	{
		builder->binCapacity = 2 * ( builder->binCount + padded );
		builder->bin = toolGrow( builder->bin, builder->binCapacity, 1 );
	}
	memcpy( builder->bin + builder->binCount, bytes, byteCount );
	memset( builder->bin + builder->binCount + byteCount, 0, padded - byteCount );
	toolJsonText* out = &builder->views;
	toolOpenItem( out );
	toolAddKey( out, "buffer" );
	toolAddJson( out, "0" );
	toolAddKey( out, "byteOffset" );
	toolAddJsonInteger( out, builder->binBase + builder->binCount );
	toolAddKey( out, "byteLength" );
	toolAddJsonInteger( out, byteCount );
	if ( target != 0 )
	{
		toolAddKey( out, "target" );
		toolAddJsonInteger( out, (size_t)target );
	}
	toolAddJson( out, "}" );
	builder->binCount += padded;
	return builder->viewCount++;
}

/// The least or greatest of each component.
static void toolAddBound( toolJsonText* out, const float* values, size_t count, int32_t size, bool greatest )
{
	float bound[16];
	for ( int32_t i = 0; i < size; ++i )
	{
		bound[i] = values[i];
		for ( size_t j = 1; j < count; ++j )
		{
			float value = values[j * (size_t)size + (size_t)i];
			bool better = greatest ? value > bound[i] : value < bound[i];
			bound[i] = better ? value : bound[i];
		}
	}
	toolAddJsonFloats( out, bound, size );
}

size_t toolAddAccessor( toolBuilder* builder, size_t view, size_t offset, int componentType, const char* type,
    size_t count, const float* bounds, int32_t boundSize )
{
	toolJsonText* out = &builder->accessors;
	toolOpenItem( out );
	toolAddKey( out, "bufferView" );
	toolAddJsonInteger( out, view );
	if ( offset > 0 )
	{
		toolAddKey( out, "byteOffset" );
		toolAddJsonInteger( out, offset );
	}
	toolAddKey( out, "componentType" );
	toolAddJsonInteger( out, (size_t)componentType );
	toolAddKey( out, "count" );
	toolAddJsonInteger( out, count );
	toolAddKey( out, "type" );
	toolAddJsonString( out, type );
	if ( bounds != NULL )
	{
		toolAddKey( out, "min" );
		toolAddBound( out, bounds, count, boundSize, false );
		toolAddKey( out, "max" );
		toolAddBound( out, bounds, count, boundSize, true );
	}
	toolAddJson( out, "}" );
	return builder->accessorCount++;
}
