// SPDX-License-Identifier: MIT
// What the tests of the ground share: grounds from triangle lists, probes, soups, and slow answers in double.
#ifndef TEST_GROUND_SUPPORT_H
#define TEST_GROUND_SUPPORT_H

#include "test.h"

#include "sole/ground.h"

#include <math.h>

typedef struct testMesh
{
	float* vertices;
	int32_t vertexCount;
	uint32_t* indices;
	int32_t triangleCount;
} testMesh;

static inline testMesh testAllocMesh( int32_t vertexCount, int32_t triangleCount )
{
	testMesh mesh = { calloc( (size_t)vertexCount, 3 * sizeof( float ) ), vertexCount,
		calloc( (size_t)triangleCount, 3 * sizeof( uint32_t ) ), triangleCount };
	assert_true( mesh.vertices != NULL && mesh.indices != NULL );
	return mesh;
}

static inline void testFreeMesh( testMesh* mesh )
{
	free( mesh->vertices );
	free( mesh->indices );
}

static inline soleVec3 testCorner( const testMesh* mesh, int32_t triangle, int corner )
{
	const float* p = mesh->vertices + 3 * (size_t)mesh->indices[3 * triangle + corner];
	return soleVec( p[0], p[1], p[2] );
}

static inline soleGroundMesh testGroundMesh( const testMesh* mesh )
{
	soleGroundMesh groundMesh = soleDefaultGroundMesh();
	groundMesh.vertices = mesh->vertices;
	groundMesh.vertexCount = mesh->vertexCount;
	groundMesh.indices = mesh->indices;
	groundMesh.triangleCount = mesh->triangleCount;
	return groundMesh;
}

static inline soleGround* testMakeGround( const soleGroundMesh* meshes, int32_t count )
{
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = meshes;
	def.meshCount = count;
	soleGround* ground = NULL;
	soleMessage message = { "" };
	if ( soleCreateGround( &def, NULL, &ground, &message ) != sole_success )
	{
		fail_msg( "%s", message.text );
	}
	return ground;
}

static inline soleGround* testMakeMeshGround( const testMesh* mesh, bool twoSided )
{
	soleGroundMesh groundMesh = testGroundMesh( mesh );
	groundMesh.twoSided = twoSided;
	return testMakeGround( &groundMesh, 1 );
}

/// Triangles of the given size, anywhere in a cube.
static inline testMesh testMakeSoup( uint32_t seed, int32_t count, float cube, float size )
{
	testMesh mesh = testAllocMesh( 3 * count, count );
	for ( int32_t i = 0; i < 3 * count; ++i )
	{
		mesh.indices[i] = (uint32_t)i;
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		soleVec3 middle = testRandomPoint( &seed, cube );
		for ( int k = 0; k < 3; ++k )
		{
			soleVec3 p = soleAdd( middle, testRandomPoint( &seed, size ) );
			memcpy( mesh.vertices + 9 * i + 3 * k, &p, sizeof p );
		}
	}
	return mesh;
}

/// A square terrain of cells by cells, corners at multiples of step, heights at random; faces up.
static inline testMesh testMakeTerrain( uint32_t seed, int32_t cells, float step, float height )
{
	testMesh mesh = testAllocMesh( ( cells + 1 ) * ( cells + 1 ), 2 * cells * cells );
	for ( int32_t j = 0; j <= cells; ++j )
	{
		for ( int32_t i = 0; i <= cells; ++i )
		{
			float* p = mesh.vertices + 3 * ( j * ( cells + 1 ) + i );
			p[0] = step * (float)i;
			p[1] = testRandomFloat( &seed, 0.0f, height );
			p[2] = step * (float)j;
		}
	}
	uint32_t* t = mesh.indices;
	for ( int32_t j = 0; j < cells; ++j )
	{
		for ( int32_t i = 0; i < cells; ++i )
		{
			uint32_t a = (uint32_t)( j * ( cells + 1 ) + i );
			uint32_t b = a + (uint32_t)cells + 1;
			uint32_t quad[6] = { a, b + 1, a + 1, a, b, b + 1 };
			memcpy( t, quad, sizeof quad );
			t += 6;
		}
	}
	return mesh;
}

static inline soleProbe testProbe( soleVec3 start, soleVec3 direction, float length, float radius )
{
	return ( soleProbe ){
		.start_w = start, .direction_w = direction, .length = length, .radius = radius, .mask = 0xffffffffu
	};
}

static inline soleHit testCast(
    const soleGround* ground, soleVec3 start, soleVec3 direction, float length, float radius )
{
	soleProbe probe = testProbe( start, direction, length, radius );
	return soleCastProbe( ground, &probe );
}

// ------------------------------------------------------------------------------------------------- slow and exact

typedef struct testPoint
{
	double x, y, z;
} testPoint;

static inline testPoint testWide( soleVec3 v )
{
	return ( testPoint ){ (double)v.x, (double)v.y, (double)v.z };
}

static inline testPoint testMinus( testPoint a, testPoint b )
{
	return ( testPoint ){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static inline testPoint testAlong( testPoint a, double s, testPoint b )
{
	return ( testPoint ){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}

static inline double testDot( testPoint a, testPoint b )
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline testPoint testCross( testPoint a, testPoint b )
{
	return ( testPoint ){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

static inline testPoint testFaceNormal( const testMesh* mesh, int32_t triangle )
{
	testPoint a = testWide( testCorner( mesh, triangle, 0 ) );
	testPoint n = testCross( testMinus( testWide( testCorner( mesh, triangle, 1 ) ), a ),
	    testMinus( testWide( testCorner( mesh, triangle, 2 ) ), a ) );
	double size = sqrt( testDot( n, n ) );
	return ( testPoint ){ n.x / size, n.y / size, n.z / size };
}

#endif
