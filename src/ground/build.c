// SPDX-License-Identifier: MIT
// Making a ground of its definition, and taking it over anew where things have moved. World space.
#include "ground/ground_internal.h"

#include "base/core.h"

#include <string.h>

soleGroundDef soleDefaultGroundDef( void )
{
	return ( soleGroundDef ){ .internalValue = SOLE_COOKIE };
}

soleGroundMesh soleDefaultGroundMesh( void )
{
	return ( soleGroundMesh ){ .vertexStride = 12, .layer = 1, .surface = SOLE_NONE };
}

soleHeightField soleDefaultHeightField( void )
{
	return ( soleHeightField ){
		.axisX = { 1.0f, 0.0f, 0.0f },
		.axisZ = { 0.0f, 0.0f, 1.0f },
		.up = { 0.0f, 1.0f, 0.0f },
		.cellX = 1.0f,
		.cellZ = 1.0f,
		.layer = 1,
		.surface = SOLE_NONE,
	};
}

soleGroundPlane soleDefaultGroundPlane( void )
{
	return ( soleGroundPlane ){ .normal = { 0.0f, 1.0f, 0.0f }, .layer = 1, .surface = SOLE_NONE };
}

// --------------------------------------------------------------------------------------------------------- copying

/// Memory for count things; an empty array is no memory and no failure.
static bool soleAllocArray( const soleAllocator* allocator, int64_t count, size_t size, void* array )
{
	void* memory = count > 0 ? soleAlloc( allocator, (size_t)count * size ) : NULL;
	memcpy( array, &memory, sizeof memory );
	return count == 0 || memory != NULL;
}

void soleReadTriangle( const soleGround* ground, const soleGroundDef* def, uint32_t index, float corners[3][3] )
{
	int32_t part = soleGround_FindPart( ground, index );
	const soleGroundMesh* mesh = def->meshes + part;
	const uint32_t* vertices = mesh->indices + 3 * (size_t)( index - ground->parts[part].firstIndex );
	for ( int i = 0; i < 3; ++i )
	{
		soleReadMeshVertex( mesh, vertices[i], corners[i] );
	}
}

int32_t soleGround_FindPart( const soleGround* ground, uint32_t index )
{
	// The last that begins at or before it: meshes without triangles begin where the next one does.
	int32_t low = 0;
	int32_t high = ground->partCount;
	while ( high - low > 1 )
	{
		int32_t middle = ( low + high ) / 2;
		if ( ground->parts[middle].firstIndex <= index )
		{
			low = middle;
		}
		else
		{
			high = middle;
		}
	}
	return low;
}

/// Layers follow the triangles, once these have found their places in the tree.
static bool soleFillLayers( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	bool any = false;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		any = any || ( def->meshes[i].triangleLayers != NULL && def->meshes[i].triangleCount > 0 );
	}
	if ( any == false )
	{
		return true;
	}
	int64_t count = (int64_t)ground->blockCount * SOLE_GROUND_BLOCK_SIZE;
	if ( !soleAllocArray( allocator, count, sizeof *ground->layers, &ground->layers ) )
	{
		return false;
	}
	for ( int64_t i = 0; i < count; ++i )
	{
		uint32_t index = ground->blocks[i / SOLE_GROUND_BLOCK_SIZE].indices[i % SOLE_GROUND_BLOCK_SIZE];
		if ( index != SOLE_GROUND_NONE )
		{
			int32_t part = soleGround_FindPart( ground, index );
			const soleGroundMesh* mesh = def->meshes + part;
			uint32_t local = index - ground->parts[part].firstIndex;
			ground->layers[i] = mesh->triangleLayers != NULL ? mesh->triangleLayers[local] : mesh->layer;
		}
	}
	return true;
}

static bool soleCopyMeshes( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	if ( !soleAllocArray( allocator, def->meshCount, sizeof *ground->parts, &ground->parts ) )
	{
		return false;
	}
	ground->partCount = def->meshCount;
	uint32_t firstIndex = 0;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		const soleGroundMesh* mesh = def->meshes + i;
		ground->parts[i] =
		    ( soleGroundPart ){ firstIndex, mesh->triangleCount, mesh->layer, mesh->surface, mesh->twoSided };
		ground->anyTwoSided = ground->anyTwoSided || mesh->twoSided;
		firstIndex += (uint32_t)mesh->triangleCount;
	}
	return soleBuildGroundTree( ground, def ) && soleFillLayers( ground, def, allocator );
}

/// All of a height field but its array.
static void soleFillField( soleGroundField* field, const soleHeightField* from )
{
	memcpy( field->heights, from->heights, (size_t)field->heightCount * sizeof *field->heights );
	field->field = *from;
	field->field.heights = field->heights;
	field->lowest = INFINITY;
	field->highest = -INFINITY;
	for ( int32_t k = 0; k < field->heightCount; ++k )
	{
		// Compares with NaN are false: holes leave both as they are.
		field->lowest = field->heights[k] < field->lowest ? field->heights[k] : field->lowest;
		field->highest = field->heights[k] > field->highest ? field->heights[k] : field->highest;
	}
}

static bool soleCopyFields( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	if ( !soleAllocArray( allocator, def->heightFieldCount, sizeof *ground->fields, &ground->fields ) )
	{
		return false;
	}
	ground->fieldCount = def->heightFieldCount;
	for ( int32_t i = 0; i < def->heightFieldCount; ++i )
	{
		soleGroundField* field = ground->fields + i;
		int32_t count = def->heightFields[i].countX * def->heightFields[i].countZ;
		if ( !soleAllocArray( allocator, count, sizeof *field->heights, &field->heights ) )
		{
			return false;
		}
		field->heightCount = count;
		soleFillField( field, def->heightFields + i );
	}
	return true;
}

static void soleFillPlanes( soleGround* ground, const soleGroundDef* def )
{
	for ( int32_t i = 0; i < def->planeCount; ++i )
	{
		ground->planes[i] = def->planes[i];
	}
}

static bool soleCopyPlanes( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	if ( !soleAllocArray( allocator, def->planeCount, sizeof *ground->planes, &ground->planes ) )
	{
		return false;
	}
	ground->planeCount = def->planeCount;
	soleFillPlanes( ground, def );
	return true;
}

static void soleGrowBounds( soleGround* ground, soleVec3 lower, soleVec3 upper )
{
	soleVec3 a = ground->lower;
	soleVec3 b = ground->upper;
	ground->lower = soleVec( soleMinF( a.x, lower.x ), soleMinF( a.y, lower.y ), soleMinF( a.z, lower.z ) );
	ground->upper = soleVec( soleMaxF( b.x, upper.x ), soleMaxF( b.y, upper.y ), soleMaxF( b.z, upper.z ) );
}

static void soleFillBounds( soleGround* ground )
{
	ground->lower = soleVec( INFINITY, INFINITY, INFINITY );
	ground->upper = soleVec( -INFINITY, -INFINITY, -INFINITY );
	ground->extent = 0.0f;
	for ( int k = 0; k < SOLE_GROUND_NODE_SIZE && ground->nodeCount > 0; ++k )
	{
		const soleGroundNode* root = ground->nodes;
		soleVec3 lower = { root->lower[0][k], root->lower[1][k], root->lower[2][k] };
		soleVec3 upper = { root->upper[0][k], root->upper[1][k], root->upper[2][k] };
		soleGrowBounds( ground, lower, upper );
	}
	const float sides[6] = { ground->lower.x, ground->lower.y, ground->lower.z, ground->upper.x, ground->upper.y,
		ground->upper.z };
	for ( int k = 0; k < 6 && ground->nodeCount > 0; ++k )
	{
		ground->extent = soleMaxF( ground->extent, fabsf( sides[k] ) );
	}
	for ( int32_t i = 0; i < ground->fieldCount; ++i )
	{
		soleVec3 lower;
		soleVec3 upper;
		soleGroundField_GetBounds( ground->fields + i, &lower, &upper );
		soleGrowBounds( ground, lower, upper );
	}
}

soleResult soleCreateGround(
    const soleGroundDef* def, const soleAllocator* allocator, soleGround** ground, soleMessage* message )
{
	SOLE_ASSERT( ground != NULL );
	if ( ground == NULL )
	{
		return sole_invalidDefinition;
	}
	*ground = NULL;
	if ( !soleCheckGroundDef( def, message ) )
	{
		return sole_invalidDefinition;
	}
	soleGround* made = soleAlloc( allocator, sizeof *made );
	if ( made == NULL )
	{
		soleSetMessage( message, "allocator: out of memory: give it more or the ground fewer triangles" );
		return sole_outOfMemory;
	}
	if ( allocator != NULL )
	{
		made->allocator = *allocator;
	}
	if ( !soleCopyMeshes( made, def, allocator ) || !soleCopyFields( made, def, allocator ) ||
	    !soleCopyPlanes( made, def, allocator ) )
	{
		soleDestroyGround( made );
		soleSetMessage( message, "allocator: out of memory: give it more or the ground fewer triangles" );
		return sole_outOfMemory;
	}
	soleFillBounds( made );
	*ground = made;
	return sole_success;
}

/// Whether a ground could have been made of the definition, but for where things are.
static bool soleHasShapeOf( const soleGround* ground, const soleGroundDef* def )
{
	bool same = ground->partCount == def->meshCount && ground->fieldCount == def->heightFieldCount &&
	    ground->planeCount == def->planeCount;
	for ( int32_t i = 0; i < def->meshCount && same; ++i )
	{
		same = ground->parts[i].triangleCount == def->meshes[i].triangleCount;
	}
	for ( int32_t i = 0; i < def->heightFieldCount && same; ++i )
	{
		same = ground->fields[i].field.countX == def->heightFields[i].countX &&
		    ground->fields[i].field.countZ == def->heightFields[i].countZ;
	}
	return same;
}

soleResult soleRefitGround( soleGround* ground, const soleGroundDef* def, soleMessage* message )
{
	SOLE_ASSERT( ground != NULL );
	if ( ground == NULL || !soleCheckGroundDef( def, message ) )
	{
		return sole_invalidDefinition;
	}
	if ( !soleHasShapeOf( ground, def ) )
	{
		soleSetMessage( message, "def: other counts than the ground was made of: create a new ground" );
		return sole_invalidDefinition;
	}
	soleRefitGroundTree( ground, def );
	for ( int32_t i = 0; i < ground->fieldCount; ++i )
	{
		soleFillField( ground->fields + i, def->heightFields + i );
	}
	soleFillPlanes( ground, def );
	soleFillBounds( ground );
	return sole_success;
}

void soleDestroyGround( soleGround* ground )
{
	if ( ground == NULL )
	{
		return;
	}
	soleAllocator copy = ground->allocator;
	const soleAllocator* allocator = copy.alloc != NULL ? &copy : NULL;
	for ( int32_t i = 0; i < ground->fieldCount; ++i )
	{
		soleGroundField* field = ground->fields + i;
		soleFree( allocator, field->heights, (size_t)field->heightCount * sizeof *field->heights );
	}
	soleFree( allocator, ground->planes, (size_t)ground->planeCount * sizeof *ground->planes );
	soleFree( allocator, ground->fields, (size_t)ground->fieldCount * sizeof *ground->fields );
	soleFreeColumns( ground );
	soleFree( allocator, ground->nodes, (size_t)ground->nodeCount * sizeof *ground->nodes );
	size_t places = (size_t)ground->blockCount * SOLE_GROUND_BLOCK_SIZE;
	soleFree( allocator, ground->layers, places * sizeof *ground->layers );
	soleFree( allocator, ground->blocks, (size_t)ground->blockCount * sizeof *ground->blocks );
	soleFree( allocator, ground->parts, (size_t)ground->partCount * sizeof *ground->parts );
	soleFree( allocator, ground, sizeof *ground );
}

void soleGround_GetBounds( const soleGround* ground, soleVec3* lower, soleVec3* upper )
{
	*lower = ground != NULL ? ground->lower : soleVec( INFINITY, INFINITY, INFINITY );
	*upper = ground != NULL ? ground->upper : soleVec( -INFINITY, -INFINITY, -INFINITY );
}

int32_t soleGround_GetTriangleCount( const soleGround* ground )
{
	if ( ground == NULL )
	{
		return 0;
	}
	int64_t count = ground->triangleCount;
	for ( int32_t i = 0; i < ground->fieldCount; ++i )
	{
		count += soleGroundField_GetTriangleCount( ground->fields + i );
	}
	return count < INT32_MAX ? (int32_t)count : INT32_MAX;
}
