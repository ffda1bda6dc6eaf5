// SPDX-License-Identifier: MIT
// Materials and meshes of a model as items of glTF, with influences as the format wants them.
#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

enum
{
	tool_targetVertices = 34962,
	tool_targetIndices = 34963
};

void toolBuildMaterial( toolBuilder* builder, const toolMaterial* material )
{
	toolJsonText* out = &builder->materials;
	toolOpenItem( out );
	toolAddName( out, material->name );
	float color[4];
	for ( int i = 0; i < 4; ++i )
	{
		color[i] = soleClampF( material->color[i], 0.0f, 1.0f );
	}
	toolAddKey( out, "pbrMetallicRoughness" );
	toolAddJson( out, "{\"baseColorFactor\":" );
	toolAddJsonFloats( out, color, 4 );
	toolAddKey( out, "metallicFactor" );
	toolAddJson( out, "0" );
	toolAddKey( out, "roughnessFactor" );
	toolAddJsonFloat( out, soleClampF( material->roughness, 0.0f, 1.0f ) );
	toolAddJson( out, "}" );
	if ( color[3] < 1.0f )
	{
		toolAddKey( out, "alphaMode" );
		toolAddJson( out, "\"BLEND\"" );
	}
	if ( material->doubleSided )
	{
		toolAddKey( out, "doubleSided" );
		toolAddJson( out, "true" );
	}
	toolAddJson( out, "}" );
	++builder->materialCount;
}

/// Weights of one vertex that sum to 1, none of a joint twice, and joint 0 where there is no weight.
static void toolCleanInfluences( int32_t count, uint16_t* joints, float* weights )
{
	double sum = 0.0;
	int32_t used = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		weights[i] = weights[i] > 0.0f ? weights[i] : 0.0f;
		for ( int32_t j = 0; j < i && weights[i] > 0.0f; ++j )
		{
			if ( weights[j] > 0.0f && joints[j] == joints[i] )
			{
				weights[j] += weights[i];
				weights[i] = 0.0f;
			}
		}
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		sum += (double)weights[i];
		used += weights[i] > 0.0f ? 1 : 0;
		joints[i] = weights[i] > 0.0f ? joints[i] : 0;
	}
	if ( used == 0 )
	{
		weights[0] = 1.0f;
		return;
	}
	double off = sum > 1.0 ? sum - 1.0 : 1.0 - sum;
	if ( off <= 1e-7 * (double)used )
	{
		return; // what is normalised but for rounding stays bit by bit
	}
	int32_t largest = 0;
	double rest = 1.0;
	for ( int32_t i = 0; i < count; ++i )
	{
		weights[i] = (float)( (double)weights[i] / sum );
		rest -= (double)weights[i];
		joints[i] = weights[i] > 0.0f ? joints[i] : 0;
		largest = weights[i] > weights[largest] ? i : largest;
	}
	weights[largest] = (float)( (double)weights[largest] + rest );
}

/// JOINTS_n and WEIGHTS_n of four influences each.
static void toolAddInfluences( toolBuilder* builder, toolJsonText* attributes, const toolPrimitive* primitive )
{
	size_t vertexCount = (size_t)primitive->vertexCount;
	size_t influences = (size_t)primitive->influences;
	uint16_t* joints = toolAlloc( vertexCount * influences, sizeof( uint16_t ) );
	float* weights = toolAlloc( vertexCount * influences, sizeof( float ) );
	memcpy( joints, primitive->joints, vertexCount * influences * sizeof( uint16_t ) );
	memcpy( weights, primitive->weights, vertexCount * influences * sizeof( float ) );
	bool narrow = true;
	for ( size_t i = 0; i < vertexCount; ++i )
	{
		toolCleanInfluences( (int32_t)influences, joints + i * influences, weights + i * influences );
		for ( size_t j = 0; j < influences; ++j )
		{
			narrow = narrow && joints[i * influences + j] < 256;
		}
	}
	uint8_t* jointSet = toolAlloc( vertexCount * 8, 1 );
	float* weightSet = toolAlloc( vertexCount * 4, sizeof( float ) );
	for ( size_t set = 0; set < influences / 4; ++set )
	{
		for ( size_t i = 0; i < vertexCount * 4; ++i )
		{
			size_t from = i / 4 * influences + set * 4 + i % 4;
			weightSet[i] = weights[from];
			jointSet[narrow ? i : 2 * i] = (uint8_t)( joints[from] & 255 );
			if ( narrow == false )
			{
				jointSet[2 * i + 1] = (uint8_t)( joints[from] >> 8 );
			}
		}
		char key[32];
		snprintf( key, sizeof key, "JOINTS_%zu", set );
		size_t view = toolAddView( builder, jointSet, vertexCount * ( narrow ? 4 : 8 ), tool_targetVertices );
		toolAddKey( attributes, key );
		toolAddJsonInteger(
		    attributes, toolAddAccessor( builder, view, 0, narrow ? 5121 : 5123, "VEC4", vertexCount, NULL, 0 ) );
		snprintf( key, sizeof key, "WEIGHTS_%zu", set );
		view = toolAddView( builder, weightSet, vertexCount * 16, tool_targetVertices );
		toolAddKey( attributes, key );
		toolAddJsonInteger( attributes, toolAddAccessor( builder, view, 0, 5126, "VEC4", vertexCount, NULL, 0 ) );
	}
	free( jointSet );
	free( weightSet );
	free( joints );
	free( weights );
}

/// Normals of unit length; up where there is none.
static size_t toolAddNormals( toolBuilder* builder, const toolPrimitive* primitive )
{
	size_t count = (size_t)primitive->vertexCount;
	float* normals = toolAlloc( count * 3, sizeof( float ) );
	for ( size_t i = 0; i < count; ++i )
	{
		const float* n = primitive->normals + 3 * i;
		soleVec3 v = { n[0], n[1], n[2] };
		float off = soleDot( v, v ) - 1.0f;
		v = off > -1e-4f && off < 1e-4f ? v : soleNormalizeOr( v, soleVec( 0.0f, 1.0f, 0.0f ) );
		normals[3 * i] = v.x;
		normals[3 * i + 1] = v.y;
		normals[3 * i + 2] = v.z;
	}
	size_t view = toolAddView( builder, normals, count * 12, tool_targetVertices );
	free( normals );
	return toolAddAccessor( builder, view, 0, 5126, "VEC3", count, NULL, 0 );
}

static size_t toolAddIndices( toolBuilder* builder, const toolPrimitive* primitive )
{
	size_t count = (size_t)primitive->indexCount;
	// 65535 itself is kept free: it restarts strips
	if ( primitive->vertexCount > UINT16_MAX )
	{
		size_t view = toolAddView( builder, primitive->indices, count * 4, tool_targetIndices );
		return toolAddAccessor( builder, view, 0, 5125, "SCALAR", count, NULL, 0 );
	}
	uint16_t* narrow = toolAlloc( count, sizeof( uint16_t ) );
	for ( size_t i = 0; i < count; ++i )
	{
		narrow[i] = (uint16_t)primitive->indices[i];
	}
	size_t view = toolAddView( builder, narrow, count * 2, tool_targetIndices );
	free( narrow );
	return toolAddAccessor( builder, view, 0, 5123, "SCALAR", count, NULL, 0 );
}

static void toolAddPrimitive(
    toolBuilder* builder, toolJsonText* out, const toolPrimitive* primitive, size_t materialBase, bool withSkin )
{
	size_t count = (size_t)primitive->vertexCount;
	size_t view = toolAddView( builder, primitive->positions, count * 12, tool_targetVertices );
	toolOpenItem( out );
	toolAddKey( out, "attributes" );
	toolAddJson( out, "{\"POSITION\":" );
	toolAddJsonInteger( out, toolAddAccessor( builder, view, 0, 5126, "VEC3", count, primitive->positions, 3 ) );
	if ( primitive->normals != NULL )
	{
		toolAddKey( out, "NORMAL" );
		toolAddJsonInteger( out, toolAddNormals( builder, primitive ) );
	}
	if ( withSkin )
	{
		toolAddInfluences( builder, out, primitive );
	}
	toolAddJson( out, "}" );
	toolAddKey( out, "indices" );
	toolAddJsonInteger( out, toolAddIndices( builder, primitive ) );
	if ( primitive->material != SOLE_NONE )
	{
		toolAddKey( out, "material" );
		toolAddJsonInteger( out, materialBase + (size_t)primitive->material );
	}
	toolAddJson( out, "}" );
}

bool toolIsSkinned( const toolModel* model, int32_t mesh )
{
	bool used = false;
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		used = used || ( model->nodes[i].mesh == mesh && model->nodes[i].skin != SOLE_NONE );
	}
	for ( int32_t i = 0; used && i < model->meshes[mesh].primitiveCount; ++i )
	{
		const toolPrimitive* primitive = model->meshes[mesh].primitives + i;
		used = primitive->influences > 0 || primitive->indexCount == 0;
	}
	return used;
}

void toolBuildMeshes( toolBuilder* builder, const toolModel* model, bool withSkins, int32_t* meshMap )
{
	size_t materialBase = builder->materialCount;
	for ( int32_t i = 0; i < model->materialCount; ++i )
	{
		toolBuildMaterial( builder, model->materials + i );
	}
	for ( int32_t i = 0; i < model->meshCount; ++i )
	{
		const toolMesh* mesh = model->meshes + i;
		bool withSkin = withSkins && toolIsSkinned( model, i );
		toolJsonText primitives = { 0 };
		for ( int32_t j = 0; j < mesh->primitiveCount; ++j )
		{
			if ( mesh->primitives[j].indexCount > 0 )
			{
				toolAddPrimitive( builder, &primitives, mesh->primitives + j, materialBase, withSkin );
			}
		}
		meshMap[i] = SOLE_NONE;
		if ( primitives.count > 0 )
		{
			toolJsonText* out = &builder->meshes;
			toolOpenItem( out );
			toolAddName( out, mesh->name );
			toolAddKey( out, "primitives" );
			toolAddJson( out, "[" );
			toolAddJson( out, primitives.text );
			toolAddJson( out, "]}" );
			meshMap[i] = (int32_t)builder->meshCount;
			++builder->meshCount;
		}
		free( primitives.text );
	}
}
