// SPDX-License-Identifier: MIT
// Opens characters and grounds by file or by the name of an embedded sample. World of the ground, metres, Y up.
#include "source.h"

#include "mannequin.h"
#include "scenario.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static bool toolIsThere( const char* path )
{
	struct stat info;
	return stat( path, &info ) == 0;
}

bool toolOpenEmbeddedCharacter( const char* name, toolGltf** gltf )
{
	*gltf = NULL;
	if ( strcmp( name, "mannequin" ) != 0 )
	{
		return false;
	}
	toolModel model;
	toolMakeMannequin( &model );
	*gltf = toolMakeGltf( &model );
	toolFreeModel( &model );
	return *gltf != NULL;
}

bool toolOpenCharacter( const char* name, toolGltf** gltf, toolError* error )
{
	bool embedded = toolIsThere( name ) == false && toolOpenEmbeddedCharacter( name, gltf );
	return embedded || toolReadGltf( name, gltf, error );
}

bool toolIsPieceInFile( const soleScene* scene, int32_t piece )
{
	soleTransform fromStart;
	return soleGetScenePiece( scene, piece, 0.0, &fromStart ) && scene->pieces[piece].layer != sole_sceneRootOnly;
}

/// What is to be seen of a scene at time 0.
static void toolTakeTriangles( const soleScene* scene, toolGroundMesh* mesh )
{
	mesh->triangleCount = 0;
	mesh->indices = toolAlloc( 3 * (size_t)scene->triangleCount, sizeof *mesh->indices );
	for ( int32_t i = 0; i < scene->pieceCount; ++i )
	{
		const soleScenePiece* piece = scene->pieces + i;
		if ( toolIsPieceInFile( scene, i ) )
		{
			memcpy( mesh->indices + 3 * (size_t)mesh->triangleCount, scene->indices + 3 * (size_t)piece->firstTriangle,
			    3 * (size_t)piece->triangleCount * sizeof *mesh->indices );
			mesh->triangleCount += piece->triangleCount;
		}
	}
}

static void toolTakeScene( const soleScene* scene, toolGroundSource* source )
{
	size_t positions = 3 * (size_t)scene->vertexCount;
	source->mesh.vertexCount = scene->vertexCount;
	source->mesh.positions = toolAlloc( positions, sizeof *source->mesh.positions );
	memcpy( source->mesh.positions, scene->positions, positions * sizeof *source->mesh.positions );
	toolTakeTriangles( scene, &source->mesh );
	source->pathCount = scene->pathCount;
	source->path = scene->pathCount > 0 ? toolAlloc( (size_t)scene->pathCount, sizeof *source->path ) : NULL;
	for ( int32_t i = 0; i < scene->pathCount; ++i )
	{
		source->path[i] = ( toolPlace ){ (double)scene->path[i][0], (double)NAN, (double)scene->path[i][1] };
	}
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

bool toolOpenEmbeddedGround( const char* name, toolGroundSource* source )
{
	*source = ( toolGroundSource ){ 0 };
	soleScene scene = { 0 };
	if ( soleMakeScene( name, &scene ) == false )
	{
		return false;
	}
	source->name = toolCopyString( name );
	toolTakeScene( &scene, source );
	soleFreeScene( &scene );
	bool good = toolBuildGround( source, false, NULL );
	if ( good == false )
	{
		toolCloseGround( source );
	}
	return good;
}

bool toolOpenGround( const char* name, toolGroundSource* source, toolError* error )
{
	if ( toolIsThere( name ) == false && toolOpenEmbeddedGround( name, source ) )
	{
		return true;
	}
	*source = ( toolGroundSource ){ .name = toolCopyString( name ) };
	// Files are wound as their makers cared: both sides count.
	bool good = toolReadGround( name, 1.0f, &source->mesh, error ) && toolBuildGround( source, true, error );
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

bool toolMakeTerrain( const toolGroundSource* source, soleTerrain** terrain, toolError* error )
{
	const toolGroundMesh* mesh = &source->mesh;
	soleMessage message = { { 0 } };
	soleResult result = soleCreateTerrain( mesh->positions, mesh->vertexCount, mesh->indices, mesh->triangleCount,
	    soleVec( 0.0f, 1.0f, 0.0f ), NULL, terrain, &message );
	return result == sole_success || toolFail( error, "%s: %s", source->name, message.text );
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
