// SPDX-License-Identifier: MIT
// Freeing and finding in models.
#include "model.h"

#include <stdlib.h>
#include <string.h>

void toolFreeClip( toolClip* clip )
{
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		free( clip->channels[i].times );
		free( clip->channels[i].values );
	}
	free( clip->channels );
	free( clip->name );
	free( clip->extras );
	*clip = ( toolClip ){ 0 };
}

static void toolFreeMesh( toolMesh* mesh )
{
	for ( int32_t i = 0; i < mesh->primitiveCount; ++i )
	{
		toolPrimitive* primitive = mesh->primitives + i;
		free( primitive->positions );
		free( primitive->normals );
		free( primitive->indices );
		free( primitive->joints );
		free( primitive->weights );
	}
	free( mesh->primitives );
	free( mesh->name );
}

void toolFreeModel( toolModel* model )
{
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		free( model->nodes[i].name );
	}
	for ( int32_t i = 0; i < model->skinCount; ++i )
	{
		free( model->skins[i].name );
		free( model->skins[i].joints );
		free( model->skins[i].inverseBind );
	}
	for ( int32_t i = 0; i < model->meshCount; ++i )
	{
		toolFreeMesh( model->meshes + i );
	}
	for ( int32_t i = 0; i < model->materialCount; ++i )
	{
		free( model->materials[i].name );
	}
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		toolFreeClip( model->clips + i );
	}
	for ( int32_t i = 0; i < model->boneCount; ++i )
	{
		free( model->bones[i].name );
	}
	free( model->nodes );
	free( model->skins );
	free( model->meshes );
	free( model->materials );
	free( model->clips );
	free( model->bones );
	*model = ( toolModel ){ 0 };
}

int32_t toolFindClip( const toolModel* model, const char* name )
{
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		if ( strcmp( model->clips[i].name, name ) == 0 )
		{
			return i;
		}
	}
	return SOLE_NONE;
}

int32_t toolFindNode( const toolModel* model, const char* name )
{
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		if ( strcmp( model->nodes[i].name, name ) == 0 )
		{
			return i;
		}
	}
	return SOLE_NONE;
}

soleTransform toolNodeWorld( const toolModel* model, int32_t node )
{
	soleTransform world = model->nodes[node].local;
	for ( int32_t parent = model->nodes[node].parent; parent != SOLE_NONE; parent = model->nodes[parent].parent )
	{
		world = soleMulTransform( model->nodes[parent].local, world );
	}
	return world;
}
