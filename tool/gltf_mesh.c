// SPDX-License-Identifier: MIT
// Meshes of a glTF file: triangles with their vertices, normals and influences.
#include "gltf_internal.h"

#include <json.h>
#include <stdlib.h>
#include <string.h>

enum
{
	tool_modeTriangles = 4,
	tool_modeStrip = 5,
	tool_modeFan = 6
};

static bool toolGetAttribute(
    toolGltfReader* reader, json_object* primitive, const char* owner, const char* name, int32_t* accessor )
{
	json_object* accessors = NULL;
	int32_t count = 0;
	return toolGetList( reader, reader->root, "", "accessors", &accessors, &count ) &&
	    toolGetIndex( reader, toolGetMember( primitive, "attributes" ), owner, name, count, accessor );
}

static bool toolReadVertices( toolGltfReader* reader, json_object* object, const char* owner, toolPrimitive* primitive )
{
	int32_t positions = SOLE_NONE;
	int32_t normals = SOLE_NONE;
	int32_t normalCount = 0;
	if ( toolGetAttribute( reader, object, owner, "POSITION", &positions ) == false ||
	    toolGetAttribute( reader, object, owner, "NORMAL", &normals ) == false ||
	    toolReadFloats(
	        reader, positions, owner, tool_useVec3, false, &primitive->positions, &primitive->vertexCount ) == false )
	{
		return false;
	}
	int64_t bad = toolFindNotFinite( primitive->positions, (size_t)primitive->vertexCount * 3 );
	if ( bad >= 0 )
	{
		return toolFailFile( reader->error, reader->path, "%s: vertex %lld is not finite: export it again", owner,
		    (long long)( bad / 3 ) );
	}
	if ( normals == SOLE_NONE )
	{
		return true;
	}
	if ( toolReadFloats( reader, normals, owner, tool_useVec3, false, &primitive->normals, &normalCount ) == false )
	{
		return false;
	}
	if ( normalCount != primitive->vertexCount )
	{
		return toolFailFile( reader->error, reader->path, "%s has %d normals for %d vertices: export it again", owner,
		    normalCount, primitive->vertexCount );
	}
	if ( toolFindNotFinite( primitive->normals, (size_t)normalCount * 3 ) >= 0 )
	{
		// nothing depends on normals: rather none than a file refused
		free( primitive->normals );
		primitive->normals = NULL;
	}
	return true;
}

/// One triangle of a strip or fan; none where two corners are one.
static void toolAddTriangle( toolPrimitive* primitive, uint32_t a, uint32_t b, uint32_t c )
{
	if ( a != b && b != c && c != a )
	{
		primitive->indices[primitive->indexCount++] = a;
		primitive->indices[primitive->indexCount++] = b;
		primitive->indices[primitive->indexCount++] = c;
	}
}

/// Takes corners over. Corners that do not fill a triangle are left out.
static bool toolMakeTriangles(
    toolGltfReader* reader, const char* owner, size_t mode, uint32_t* corners, int32_t count, toolPrimitive* primitive )
{
	if ( mode == tool_modeTriangles )
	{
		primitive->indices = corners;
		primitive->indexCount = count - count % 3;
		return true;
	}
	size_t triangles = count > 2 ? (size_t)count - 2 : 0;
	bool fits = triangles <= INT32_MAX / 3
	    ? toolSpend( reader, owner, triangles * 3, sizeof( uint32_t ) )
	    : toolFailFile( reader->error, reader->path, "%s has too many triangles: split it", owner );
	if ( fits == false )
	{
		free( corners );
		return false;
	}
	primitive->indices = toolAlloc( triangles * 3, sizeof( uint32_t ) );
	for ( size_t i = 0; i < triangles; ++i )
	{
		bool odd = mode == tool_modeStrip && i % 2 == 1;
		uint32_t first = mode == tool_modeFan ? corners[0] : corners[i];
		toolAddTriangle( primitive, first, corners[odd ? i + 2 : i + 1], corners[odd ? i + 1 : i + 2] );
	}
	free( corners );
	return true;
}

static bool toolReadTriangles(
    toolGltfReader* reader, json_object* object, const char* owner, size_t mode, toolPrimitive* primitive )
{
	json_object* accessors = NULL;
	int32_t accessorCount = 0;
	int32_t accessor = SOLE_NONE;
	uint32_t* corners = NULL;
	int32_t count = primitive->vertexCount;
	if ( toolGetList( reader, reader->root, "", "accessors", &accessors, &accessorCount ) == false ||
	    toolGetIndex( reader, object, owner, "indices", accessorCount, &accessor ) == false )
	{
		return false;
	}
	if ( accessor == SOLE_NONE )
	{
		if ( toolSpend( reader, owner, (size_t)count, sizeof( uint32_t ) ) == false )
		{
			return false;
		}
		corners = toolAlloc( (size_t)count, sizeof( uint32_t ) );
		for ( int32_t i = 0; i < count; ++i )
		{
			corners[i] = (uint32_t)i;
		}
	}
	else if ( toolReadUints( reader, accessor, owner, tool_useScalar, &corners, &count ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( corners[i] >= (uint32_t)primitive->vertexCount )
		{
			toolFailFile( reader->error, reader->path, "%s: index %d is %u but there are %d vertices: export it again",
			    owner, i, corners[i], primitive->vertexCount );
			free( corners );
			return false;
		}
	}
	return toolMakeTriangles( reader, owner, mode, corners, count, primitive );
}

/// One set of four influences a vertex, JOINTS_0 or JOINTS_1, into its place. *found: the file has it.
static bool toolReadInfluenceSet( toolGltfReader* reader, json_object* object, const char* owner, int32_t set,
    uint32_t** joints, float** weights, int32_t vertexCount )
{
	const char* jointNames[] = { "JOINTS_0", "JOINTS_1" };
	const char* weightNames[] = { "WEIGHTS_0", "WEIGHTS_1" };
	int32_t jointAccessor = SOLE_NONE;
	int32_t weightAccessor = SOLE_NONE;
	if ( toolGetAttribute( reader, object, owner, jointNames[set], &jointAccessor ) == false ||
	    toolGetAttribute( reader, object, owner, weightNames[set], &weightAccessor ) == false )
	{
		return false;
	}
	if ( jointAccessor == SOLE_NONE || weightAccessor == SOLE_NONE )
	{
		return true;
	}
	int32_t jointCount = 0;
	int32_t weightCount = 0;
	if ( toolReadUints( reader, jointAccessor, owner, tool_useVec4, joints, &jointCount ) == false ||
	    toolReadFloats( reader, weightAccessor, owner, tool_useVec4, true, weights, &weightCount ) == false )
	{
		return false;
	}
	if ( jointCount != vertexCount || weightCount != vertexCount )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has fewer or more influences than vertices: export it again", owner );
	}
	if ( toolFindNotFinite( *weights, (size_t)weightCount * 4 ) >= 0 )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has a weight that is not finite: export it again", owner );
	}
	return true;
}

static bool toolMixInfluences( toolGltfReader* reader, const char* owner, toolPrimitive* primitive, int32_t sets,
    uint32_t* const joints[2], float* const weights[2] )
{
	size_t total = (size_t)primitive->vertexCount * (size_t)sets * 4;
	if ( toolSpend( reader, owner, total, sizeof( float ) + sizeof( uint16_t ) ) == false )
	{
		return false;
	}
	primitive->influences = 4 * sets;
	primitive->joints = toolAlloc( total, sizeof( uint16_t ) );
	primitive->weights = toolAlloc( total, sizeof( float ) );
	for ( size_t i = 0; i < total; ++i )
	{
		size_t vertex = i / (size_t)( 4 * sets );
		size_t place = i % (size_t)( 4 * sets );
		uint32_t joint = joints[place / 4][vertex * 4 + place % 4];
		float weight = weights[place / 4][vertex * 4 + place % 4];
		// what has no weight may name anything
		if ( weight != 0.0f && joint > UINT16_MAX )
		{
			return toolFailFile( reader->error, reader->path,
			    "%s follows joint %u: skins have at most 65536, export it again", owner, joint );
		}
		primitive->joints[i] = weight != 0.0f ? (uint16_t)joint : 0;
		primitive->weights[i] = weight;
	}
	return true;
}

static bool toolReadInfluences(
    toolGltfReader* reader, json_object* object, const char* owner, toolPrimitive* primitive )
{
	uint32_t* joints[2] = { NULL, NULL };
	float* weights[2] = { NULL, NULL };
	bool good = toolReadInfluenceSet( reader, object, owner, 0, joints, weights, primitive->vertexCount );
	if ( good && joints[0] != NULL )
	{
		good = toolReadInfluenceSet( reader, object, owner, 1, joints + 1, weights + 1, primitive->vertexCount );
		good = good && toolMixInfluences( reader, owner, primitive, joints[1] != NULL ? 2 : 1, joints, weights );
	}
	for ( int i = 0; i < 2; ++i )
	{
		free( joints[i] );
		free( weights[i] );
	}
	return good;
}

/// *used stays false for points, lines and what has no positions.
static bool toolReadPrimitive(
    toolGltfReader* reader, json_object* object, const char* owner, toolPrimitive* primitive, bool* used )
{
	toolModel* model = &reader->gltf->model;
	size_t mode = tool_modeTriangles;
	int32_t positions = SOLE_NONE;
	if ( toolGetSize( reader, object, owner, "mode", tool_modeFan, &mode ) == false ||
	    toolGetIndex( reader, object, owner, "material", model->materialCount, &primitive->material ) == false ||
	    toolGetAttribute( reader, object, owner, "POSITION", &positions ) == false )
	{
		return false;
	}
	json_object* draco = toolGetMember( toolGetMember( object, "extensions" ), "KHR_draco_mesh_compression" );
	json_object* accessor = positions == SOLE_NONE
	    ? NULL
	    : json_object_array_get_idx( toolGetMember( reader->root, "accessors" ), (size_t)positions );
	if ( draco != NULL && toolGetMember( accessor, "bufferView" ) == NULL )
	{
		return toolFailFile(
		    reader->error, reader->path, "uses KHR_draco_mesh_compression: decode it first, e.g. with gltf-transform" );
	}
	*used = mode >= tool_modeTriangles && positions != SOLE_NONE;
	return *used == false ||
	    ( toolReadVertices( reader, object, owner, primitive ) &&
	        toolReadTriangles( reader, object, owner, mode, primitive ) &&
	        toolReadInfluences( reader, object, owner, primitive ) );
}

static bool toolReadMesh( toolGltfReader* reader, json_object* object, size_t index, toolMesh* mesh )
{
	json_object* primitives = NULL;
	int32_t count = 0;
	toolOwner owner = toolNameOwner( "meshes", index, mesh->name );
	char prefix[128];
	snprintf( prefix, sizeof prefix, "%s.", owner.text );
	if ( toolGetList( reader, object, prefix, "primitives", &primitives, &count ) == false )
	{
		return false;
	}
	mesh->primitives = toolAlloc( (size_t)count, sizeof( toolPrimitive ) );
	for ( int32_t i = 0; i < count; ++i )
	{
		char name[160];
		snprintf( name, sizeof name, "%s.primitives[%d]", owner.text, i );
		bool used = false;
		toolPrimitive* primitive = mesh->primitives + mesh->primitiveCount;
		++mesh->primitiveCount; // before reading, so that what fails halfway is freed
		if ( toolReadPrimitive( reader, json_object_array_get_idx( primitives, (size_t)i ), name, primitive, &used ) ==
		    false )
		{
			return false;
		}
		if ( used == false )
		{
			*primitive = ( toolPrimitive ){ 0 };
			--mesh->primitiveCount;
		}
	}
	return true;
}

bool toolReadMeshes( toolGltfReader* reader )
{
	toolModel* model = &reader->gltf->model;
	json_object* list = NULL;
	int32_t count = 0;
	if ( toolGetList( reader, reader->root, "", "meshes", &list, &count ) == false )
	{
		return false;
	}
	model->meshes = toolAlloc( (size_t)count, sizeof( toolMesh ) );
	model->meshCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* object = json_object_array_get_idx( list, (size_t)i );
		model->meshes[i].name = toolCopyString( toolGetText( object, "name" ) );
		if ( toolReadMesh( reader, object, (size_t)i, model->meshes + i ) == false )
		{
			return false;
		}
	}
	return true;
}
