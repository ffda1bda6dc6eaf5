// SPDX-License-Identifier: MIT
// Opens characters and grounds by file or by the name of an embedded sample. World of the ground, metres, Y up.
#include "source.h"

#include <stdlib.h>
#include <string.h>

bool toolOpenCharacter( const char* name, toolGltf** gltf, toolError* error )
{
	*gltf = NULL;
	return toolReadGltf( name, gltf, error );
}

static bool toolBuildGround( toolGroundSource* source, bool twoSided, toolError* error )
{
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = source->mesh.positions;
	mesh.vertexCount = source->mesh.vertexCount;
	mesh.indices = source->mesh.indices;
	mesh.triangleCount = source->mesh.triangleCount;
	mesh.twoSided = twoSided;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	soleMessage message = { { 0 } };
	if ( soleCreateGround( &def, NULL, &source->ground, &message ) != sole_success )
	{
		return toolFail( error, "%s: %s", source->name, message.text );
	}
	if ( soleGround_GetTriangleCount( source->ground ) == 0 )
	{
		return toolFail( error, "%s: no triangle has an area: give a mesh to walk on", source->name );
	}
	return true;
}

bool toolOpenGround( const char* name, toolGroundSource* source, toolError* error )
{
	*source = ( toolGroundSource ){ .name = toolCopyString( name ) };
	bool good = toolReadGround( name, 1.0f, &source->mesh, error );
	// Files are wound as their makers cared.
	good = good && toolBuildGround( source, true, error );
	if ( good == false )
	{
		toolCloseGround( source );
	}
	return good;
}

void toolCloseGround( toolGroundSource* source )
{
	soleDestroyGround( source->ground );
	toolFreeGroundMesh( &source->mesh );
	free( source->path );
	free( source->name );
	*source = ( toolGroundSource ){ 0 };
}

void toolMakeGroundModel( const toolGroundSource* source, toolModel* model )
{
	*model = ( toolModel ){ .nodeCount = 1, .meshCount = 1, .materialCount = 1 };
	model->nodes = toolAlloc( 1, sizeof *model->nodes );
	model->nodes[0] = ( toolNode ){
		.name = toolCopyString( "ground" ), .parent = SOLE_NONE, .local = soleTransform_Identity(), .skin = SOLE_NONE
	};
	model->materials = toolAlloc( 1, sizeof *model->materials );
	model->materials[0] = ( toolMaterial ){ .name = toolCopyString( "ground" ),
		.color = { 0.45f, 0.47f, 0.45f, 1.0f },
		.roughness = 0.9f,
		.doubleSided = true };
	model->meshes = toolAlloc( 1, sizeof *model->meshes );
	model->meshes[0] = ( toolMesh ){ .name = toolCopyString( "ground" ), .primitiveCount = 1 };
	toolPrimitive* primitive = toolAlloc( 1, sizeof *primitive );
	model->meshes[0].primitives = primitive;
	size_t positions = 3 * (size_t)source->mesh.vertexCount;
	size_t indices = 3 * (size_t)source->mesh.triangleCount;
	primitive->vertexCount = source->mesh.vertexCount;
	primitive->positions = toolAlloc( positions, sizeof *primitive->positions );
	memcpy( primitive->positions, source->mesh.positions, positions * sizeof *primitive->positions );
	primitive->indexCount = 3 * source->mesh.triangleCount;
	primitive->indices = toolAlloc( indices, sizeof *primitive->indices );
	memcpy( primitive->indices, source->mesh.indices, indices * sizeof *primitive->indices );
}
