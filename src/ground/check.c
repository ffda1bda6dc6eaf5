// SPDX-License-Identifier: MIT
// Whether a ground can be made of a definition, and if not, what to mend.
#include "ground/ground_internal.h"

#include "base/core.h"

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
		soleReadMeshVertex( mesh, (uint32_t)v, p );
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

bool soleCheckGroundDef( const soleGroundDef* def, soleMessage* message )
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
