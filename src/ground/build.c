// SPDX-License-Identifier: MIT
// Making a ground: definitions are checked and copied, triangles without area dropped. World space.
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

// ------------------------------------------------------------------------------------------------------ validation

static const float* soleGetMeshVertex( const soleGroundMesh* mesh, int32_t vertex, float p[3] )
{
	// The stride may be any: copied byte by byte, not read as floats in place.
	memcpy( p, (const char*)mesh->vertices + (size_t)vertex * (size_t)mesh->vertexStride, 3 * sizeof( float ) );
	return p;
}

static bool soleCheckMeshShape( const soleGroundMesh* mesh, int32_t i, soleMessage* message )
{
	if ( mesh->vertexCount < 0 || ( mesh->vertexCount > 0 && mesh->vertices == NULL ) )
	{
		soleSetMessage( message, "meshes[%d].vertices: %s: give vertexCount points of three floats", i,
		    mesh->vertexCount < 0 ? "vertexCount is below zero" : "NULL" );
		return false;
	}
	if ( mesh->triangleCount < 0 || ( mesh->triangleCount > 0 && mesh->indices == NULL ) )
	{
		soleSetMessage( message, "meshes[%d].indices: %s: give three indices for each of triangleCount triangles", i,
		    mesh->triangleCount < 0 ? "triangleCount is below zero" : "NULL" );
		return false;
	}
	if ( mesh->vertexStride < 12 )
	{
		soleSetMessage( message,
		    "meshes[%d].vertexStride: %d bytes hold no point: give 12 for packed points, or start from "
		    "soleDefaultGroundMesh()",
		    i, mesh->vertexStride );
		return false;
	}
	return true;
}

static bool soleCheckMesh( const soleGroundMesh* mesh, int32_t i, soleMessage* message )
{
	if ( !soleCheckMeshShape( mesh, i, message ) )
	{
		return false;
	}
	for ( int32_t v = 0; v < mesh->vertexCount; ++v )
	{
		float p[3];
		soleGetMeshVertex( mesh, v, p );
		if ( !soleIsFinite( p[0] ) || !soleIsFinite( p[1] ) || !soleIsFinite( p[2] ) )
		{
			soleSetMessage( message, "meshes[%d].vertices: vertex %d is not finite: leave out or mend it", i, v );
			return false;
		}
	}
	for ( int64_t k = 0; k < 3 * (int64_t)mesh->triangleCount; ++k )
	{
		if ( mesh->indices[k] >= (uint32_t)mesh->vertexCount )
		{
			soleSetMessage( message,
			    "meshes[%d].indices: triangle %d names vertex %u of %d: count vertices from zero, and all of them", i,
			    (int)( k / 3 ), (unsigned)mesh->indices[k], mesh->vertexCount );
			return false;
		}
	}
	return true;
}

/// Axes are unit and orthogonal to within what floats and careless rotations make of them.
static bool soleAreOrthonormal( soleVec3 a, soleVec3 b, soleVec3 c )
{
	float dots[6] = { soleDot( a, a ) - 1.0f, soleDot( b, b ) - 1.0f, soleDot( c, c ) - 1.0f, soleDot( a, b ),
		soleDot( b, c ), soleDot( c, a ) };
	bool good = true;
	for ( int i = 0; i < 6; ++i )
	{
		good = good && fabsf( dots[i] ) <= 1e-3f;
	}
	return good;
}

static bool soleCheckField( const soleHeightField* field, int32_t i, soleMessage* message )
{
	if ( !soleVec3_IsFinite( field->origin ) )
	{
		soleSetMessage( message, "heightFields[%d].origin: not finite: give a point of the world", i );
		return false;
	}
	if ( !soleAreOrthonormal( field->axisX, field->axisZ, field->up ) )
	{
		soleSetMessage(
		    message, "heightFields[%d].axisX, axisZ, up: not three unit vectors at right angles: normalize them", i );
		return false;
	}
	if ( !( field->cellX > 0.0f ) || !( field->cellZ > 0.0f ) || !soleIsFinite( field->cellX ) ||
	    !soleIsFinite( field->cellZ ) )
	{
		soleSetMessage( message, "heightFields[%d].cellX, cellZ: %g, %g: give sizes above zero", i,
		    (double)field->cellX, (double)field->cellZ );
		return false;
	}
	if ( field->countX < 2 || field->countZ < 2 || (int64_t)field->countX * field->countZ > SOLE_GROUND_MAX_TRIANGLES )
	{
		soleSetMessage( message, "heightFields[%d].countX, countZ: %d, %d: give 2 or more, and at most %d in all", i,
		    field->countX, field->countZ, SOLE_GROUND_MAX_TRIANGLES );
		return false;
	}
	if ( field->heights == NULL )
	{
		soleSetMessage( message, "heightFields[%d].heights: NULL: give countX times countZ heights", i );
		return false;
	}
	for ( int64_t k = 0; k < (int64_t)field->countX * field->countZ; ++k )
	{
		float height = field->heights[k];
		if ( height == INFINITY || height == -INFINITY )
		{
			soleSetMessage(
			    message, "heightFields[%d].heights: height %d is infinite: give NaN for a hole", i, (int)k );
			return false;
		}
	}
	return true;
}

static bool soleCheckPlane( const soleGroundPlane* plane, int32_t i, soleMessage* message )
{
	if ( !( fabsf( soleDot( plane->normal, plane->normal ) - 1.0f ) <= 1e-3f ) )
	{
		soleSetMessage( message, "planes[%d].normal: not a unit vector: normalize it", i );
		return false;
	}
	if ( !soleIsFinite( plane->offset ) )
	{
		soleSetMessage( message, "planes[%d].offset: not finite: give the plane's height along its normal", i );
		return false;
	}
	return true;
}

static bool soleCheckArray( const void* array, int32_t count, const char* name, soleMessage* message )
{
	if ( count < 0 || ( count > 0 && array == NULL ) )
	{
		soleSetMessage( message, "%s: %s: give an array and its count, or NULL and 0", name,
		    count < 0 ? "count is below zero" : "NULL with a count above zero" );
		return false;
	}
	return true;
}

static bool soleCheckGroundDef( const soleGroundDef* def, soleMessage* message )
{
	if ( def == NULL || def->internalValue != SOLE_COOKIE )
	{
		soleSetMessage( message, "def: not filled in: start from soleDefaultGroundDef()" );
		return false;
	}
	if ( !soleCheckArray( def->meshes, def->meshCount, "meshes", message ) ||
	    !soleCheckArray( def->heightFields, def->heightFieldCount, "heightFields", message ) ||
	    !soleCheckArray( def->planes, def->planeCount, "planes", message ) )
	{
		return false;
	}
	int64_t triangleCount = 0;
	int64_t vertexCount = 0;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		if ( !soleCheckMesh( def->meshes + i, i, message ) )
		{
			return false;
		}
		triangleCount += def->meshes[i].triangleCount;
		vertexCount += def->meshes[i].vertexCount;
		if ( triangleCount > SOLE_GROUND_MAX_TRIANGLES || vertexCount > INT32_MAX )
		{
			soleSetMessage( message, "meshes[%d]: more than %d triangles in all: make several grounds", i,
			    SOLE_GROUND_MAX_TRIANGLES );
			return false;
		}
	}
	for ( int32_t i = 0; i < def->heightFieldCount; ++i )
	{
		if ( !soleCheckField( def->heightFields + i, i, message ) )
		{
			return false;
		}
	}
	for ( int32_t i = 0; i < def->planeCount; ++i )
	{
		if ( !soleCheckPlane( def->planes + i, i, message ) )
		{
			return false;
		}
	}
	return true;
}

// --------------------------------------------------------------------------------------------------------- copying

/// Memory for count things; an empty array is no memory and no failure.
static bool soleAllocArray( const soleAllocator* allocator, int64_t count, size_t size, void* array )
{
	void* memory = count > 0 ? soleAlloc( allocator, (size_t)count * size ) : NULL;
	memcpy( array, &memory, sizeof memory );
	return count == 0 || memory != NULL;
}

/// Whether the three corners are in a line, but for what rounding leaves of that.
static bool soleHasNoArea( const float* vertices, const uint32_t corners[3] )
{
	double edges[3][3];
	double longest = 0.0;
	for ( int i = 0; i < 3; ++i )
	{
		const float* from = vertices + 3 * (size_t)corners[i];
		const float* to = vertices + 3 * (size_t)corners[i == 2 ? 0 : i + 1];
		for ( int k = 0; k < 3; ++k )
		{
			edges[i][k] = (double)to[k] - (double)from[k];
		}
		double square = ( edges[i][0] * edges[i][0] + edges[i][1] * edges[i][1] ) + edges[i][2] * edges[i][2];
		longest = square > longest ? square : longest;
	}
	const double* a = edges[0];
	const double* b = edges[1];
	double x = a[1] * b[2] - a[2] * b[1];
	double y = a[2] * b[0] - a[0] * b[2];
	double z = a[0] * b[1] - a[1] * b[0];
	// Thinner than 1e-10 of its length: less than the corners' own rounding, so nothing can fall through.
	return !( ( x * x + y * y ) + z * z > 1e-20 * longest * longest );
}

/// Appends one mesh to a ground that has the room. firstIndex counts the triangles of the meshes before it.
static void soleAddMesh( soleGround* ground, const soleGroundMesh* mesh, uint32_t part, uint32_t firstIndex )
{
	uint32_t firstVertex = (uint32_t)ground->vertexCount;
	for ( int32_t v = 0; v < mesh->vertexCount; ++v )
	{
		soleGetMeshVertex( mesh, v, ground->vertices + 3 * (size_t)ground->vertexCount );
		ground->vertexCount += 1;
	}
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		const uint32_t* corners = mesh->indices + 3 * (size_t)i;
		soleGroundTriangle triangle = {
			.corners = { firstVertex + corners[0], firstVertex + corners[1], firstVertex + corners[2] },
			.index = firstIndex + (uint32_t)i,
			.mesh = part,
		};
		if ( !soleHasNoArea( ground->vertices, triangle.corners ) )
		{
			ground->triangles[ground->triangleCount] = triangle;
			ground->triangleCount += 1;
		}
	}
	ground->parts[part] = ( soleGroundPart ){ firstIndex, mesh->layer, mesh->surface, mesh->twoSided };
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
	if ( !soleAllocArray( allocator, ground->triangleCount, sizeof *ground->layers, &ground->layers ) )
	{
		return false;
	}
	for ( int32_t i = 0; i < ground->triangleCount; ++i )
	{
		const soleGroundTriangle* triangle = ground->triangles + i;
		const soleGroundMesh* mesh = def->meshes + triangle->mesh;
		uint32_t local = triangle->index - ground->parts[triangle->mesh].firstIndex;
		ground->layers[i] = mesh->triangleLayers != NULL ? mesh->triangleLayers[local] : mesh->layer;
	}
	return true;
}

static bool soleCopyMeshes( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	int64_t vertexCount = 0;
	int64_t triangleCount = 0;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		vertexCount += def->meshes[i].vertexCount;
		triangleCount += def->meshes[i].triangleCount;
	}
	if ( !soleAllocArray( allocator, def->meshCount, sizeof *ground->parts, &ground->parts ) )
	{
		return false;
	}
	ground->partCount = def->meshCount;
	if ( !soleAllocArray( allocator, vertexCount, 3 * sizeof *ground->vertices, &ground->vertices ) )
	{
		return false;
	}
	ground->vertexCapacity = (int32_t)vertexCount;
	if ( !soleAllocArray( allocator, triangleCount, sizeof *ground->triangles, &ground->triangles ) )
	{
		return false;
	}
	ground->triangleCapacity = (int32_t)triangleCount;
	uint32_t firstIndex = 0;
	for ( int32_t i = 0; i < def->meshCount; ++i )
	{
		soleAddMesh( ground, def->meshes + i, (uint32_t)i, firstIndex );
		firstIndex += (uint32_t)def->meshes[i].triangleCount;
	}
	return soleBuildGroundTree( ground ) && soleFillLayers( ground, def, allocator );
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
		memcpy( field->heights, def->heightFields[i].heights, (size_t)count * sizeof *field->heights );
		field->field = def->heightFields[i];
		field->field.heights = field->heights;
		field->lowest = INFINITY;
		field->highest = -INFINITY;
		for ( int32_t k = 0; k < count; ++k )
		{
			// Compares with NaN are false: holes leave both as they are.
			field->lowest = field->heights[k] < field->lowest ? field->heights[k] : field->lowest;
			field->highest = field->heights[k] > field->highest ? field->heights[k] : field->highest;
		}
	}
	return true;
}

static bool soleCopyPlanes( soleGround* ground, const soleGroundDef* def, const soleAllocator* allocator )
{
	if ( !soleAllocArray( allocator, def->planeCount, sizeof *ground->planes, &ground->planes ) )
	{
		return false;
	}
	ground->planeCount = def->planeCount;
	for ( int32_t i = 0; i < def->planeCount; ++i )
	{
		ground->planes[i] = def->planes[i];
	}
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
	for ( int32_t i = 0; i < 3 * ground->triangleCount; ++i )
	{
		const float* p = ground->vertices + 3 * (size_t)ground->triangles[i / 3].corners[i % 3];
		soleVec3 point = { p[0], p[1], p[2] };
		soleGrowBounds( ground, point, point );
		float furthest = soleMaxF( fabsf( p[0] ), soleMaxF( fabsf( p[1] ), fabsf( p[2] ) ) );
		ground->extent = soleMaxF( ground->extent, furthest );
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
	soleFree( allocator, ground->nodes, (size_t)ground->nodeCount * sizeof *ground->nodes );
	soleFree( allocator, ground->layers, (size_t)ground->triangleCount * sizeof *ground->layers );
	soleFree( allocator, ground->triangles, (size_t)ground->triangleCapacity * sizeof *ground->triangles );
	soleFree( allocator, ground->vertices, (size_t)ground->vertexCapacity * 3 * sizeof *ground->vertices );
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
