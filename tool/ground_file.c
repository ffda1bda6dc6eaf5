// SPDX-License-Identifier: MIT
// Triangles of the scene of a glTF file, where its nodes put them.
#include "ground_file.h"

#include "gltf_internal.h"

#include <stdlib.h>
#include <string.h>

// Nodes may share meshes: the one way to get more triangles than the file's length bears out.
#define TRIANGLE_LIMIT ( (size_t)16 << 20 )

void toolFreeGroundMesh( toolGroundMesh* ground )
{
	free( ground->positions );
	free( ground->indices );
	*ground = ( toolGroundMesh ){ 0 };
}

/// out = a b, column by column.
static void toolMulMatrix( const double* a, const float* b, double* out )
{
	for ( int column = 0; column < 4; ++column )
	{
		for ( int row = 0; row < 4; ++row )
		{
			double sum = 0.0;
			for ( int k = 0; k < 4; ++k )
			{
				sum += a[4 * k + row] * (double)b[4 * column + k];
			}
			out[4 * column + row] = sum;
		}
	}
}

/// World matrices of all nodes, 16 each, parents before children whatever their order.
static double* toolMakeWorlds( const toolGltf* gltf )
{
	const toolModel* model = &gltf->model;
	size_t count = (size_t)model->nodeCount;
	static const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
	double* worlds = toolAlloc( count * 16, sizeof( double ) );
	bool* done = toolAlloc( count, sizeof( bool ) );
	int32_t* path = toolAlloc( count, sizeof( int32_t ) );
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		int32_t length = 0;
		for ( int32_t node = i; node != SOLE_NONE && done[node] == false; node = model->nodes[node].parent )
		{
			path[length] = node;
			++length;
		}
		while ( length > 0 )
		{
			--length;
			int32_t node = path[length];
			int32_t parent = model->nodes[node].parent;
			const double* above = parent != SOLE_NONE ? worlds + 16 * (size_t)parent : identity;
			toolMulMatrix( above, gltf->matrices + 16 * (size_t)node, worlds + 16 * (size_t)node );
			done[node] = true;
		}
	}
	// a skin moves its mesh past the node's own place: in the bind pose it is where its vertices are
	for ( size_t i = 0; i < count; ++i )
	{
		if ( model->nodes[i].skin != SOLE_NONE )
		{
			memcpy( worlds + 16 * i, identity, sizeof identity );
		}
	}
	free( done );
	free( path );
	return worlds;
}

static bool toolIsMirrored( const double* m )
{
	return m[0] * ( m[5] * m[10] - m[6] * m[9] ) - m[4] * ( m[1] * m[10] - m[2] * m[9] ) +
	    m[8] * ( m[1] * m[6] - m[2] * m[5] ) <
	    0.0;
}

/// False where a vertex ends up beyond what a float holds.
static bool toolAddTriangles( const toolPrimitive* primitive, const double* world, float scale, toolGroundMesh* ground )
{
	uint32_t base = (uint32_t)ground->vertexCount;
	bool finite = true;
	for ( int32_t i = 0; i < primitive->vertexCount; ++i )
	{
		const float* p = primitive->positions + 3 * (size_t)i;
		float* out = ground->positions + 3 * (size_t)ground->vertexCount;
		for ( int row = 0; row < 3; ++row )
		{
			double value = world[row] * (double)p[0] + world[4 + row] * (double)p[1] + world[8 + row] * (double)p[2] +
			    world[12 + row];
			value *= (double)scale;
			bool fits = value >= -3.4e38 && value <= 3.4e38;
			out[row] = fits ? (float)value : 0.0f;
			finite = finite && fits;
		}
		++ground->vertexCount;
	}
	bool mirrored = toolIsMirrored( world );
	for ( int32_t i = 0; i + 2 < primitive->indexCount; i += 3 )
	{
		const uint32_t* corner = primitive->indices + i;
		uint32_t* out = ground->indices + 3 * (size_t)ground->triangleCount;
		out[0] = base + corner[0];
		out[1] = base + corner[mirrored ? 2 : 1];
		out[2] = base + corner[mirrored ? 1 : 2];
		++ground->triangleCount;
	}
	return finite;
}

static void toolCountTriangles( const toolGltf* gltf, size_t* vertices, size_t* triangles )
{
	const toolModel* model = &gltf->model;
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		int32_t mesh = gltf->inScene[i] ? model->nodes[i].mesh : SOLE_NONE;
		for ( int32_t j = 0; mesh != SOLE_NONE && j < model->meshes[mesh].primitiveCount; ++j )
		{
			*vertices += (size_t)model->meshes[mesh].primitives[j].vertexCount;
			*triangles += (size_t)model->meshes[mesh].primitives[j].indexCount / 3;
		}
	}
}

static bool toolTakeScene( const toolGltf* gltf, float scale, toolGroundMesh* ground, toolError* error )
{
	const toolModel* model = &gltf->model;
	size_t vertices = 0;
	size_t triangles = 0;
	toolCountTriangles( gltf, &vertices, &triangles );
	if ( triangles == 0 )
	{
		return toolFailFile( error, gltf->path, "has no triangles: export the ground as a mesh" );
	}
	if ( triangles > TRIANGLE_LIMIT || vertices > 3 * TRIANGLE_LIMIT )
	{
		return toolFailFile( error, gltf->path, "has more than 16 million triangles: simplify or split it" );
	}
	ground->positions = toolAlloc( vertices * 3, sizeof( float ) );
	ground->indices = toolAlloc( triangles * 3, sizeof( uint32_t ) );
	double* worlds = toolMakeWorlds( gltf );
	bool good = true;
	for ( int32_t i = 0; good && i < model->nodeCount; ++i )
	{
		int32_t mesh = gltf->inScene[i] ? model->nodes[i].mesh : SOLE_NONE;
		for ( int32_t j = 0; good && mesh != SOLE_NONE && j < model->meshes[mesh].primitiveCount; ++j )
		{
			good = toolAddTriangles( model->meshes[mesh].primitives + j, worlds + 16 * (size_t)i, scale, ground );
		}
		if ( good == false )
		{
			toolOwner owner = toolNameOwner( "nodes", (size_t)i, model->nodes[i].name );
			toolFailFile( error, gltf->path, "%s puts a vertex where no number reaches: mend its scale", owner.text );
		}
	}
	free( worlds );
	return good;
}

static bool toolIsObjPath( const char* path )
{
	const char* dot = strrchr( path, '.' );
	return dot != NULL && ( strcmp( dot, ".obj" ) == 0 || strcmp( dot, ".OBJ" ) == 0 );
}

static bool toolScaleGround( const char* path, float scale, toolGroundMesh* ground, toolError* error )
{
	for ( size_t i = 0; i < 3 * (size_t)ground->vertexCount; ++i )
	{
		ground->positions[i] *= scale;
		if ( soleIsFinite( ground->positions[i] ) == false )
		{
			return toolFailFile(
			    error, path, "vertex %zu is too far away when scaled: use a smaller scale", i / 3 + 1 );
		}
	}
	return true;
}

bool toolReadGround( const char* path, float scale, toolGroundMesh* ground, toolError* error )
{
	*ground = ( toolGroundMesh ){ 0 };
	if ( soleIsFinite( scale ) == false || scale <= 0.0f )
	{
		return toolFailFile( error, path, "cannot be scaled by %g: use a scale above zero", (double)scale );
	}
	bool good = false;
	if ( toolIsObjPath( path ) )
	{
		uint8_t* bytes = NULL;
		size_t byteCount = 0;
		good = toolReadFile( path, &bytes, &byteCount, error ) &&
		    toolReadObjBytes( bytes, byteCount, path, ground, error ) && toolScaleGround( path, scale, ground, error );
		free( bytes );
	}
	else
	{
		toolGltf* gltf = NULL;
		good = toolReadGltf( path, &gltf, error ) && toolTakeScene( gltf, scale, ground, error );
		toolFreeGltf( gltf );
	}
	if ( good == false )
	{
		toolFreeGroundMesh( ground );
	}
	return good;
}
