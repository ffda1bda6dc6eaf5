// SPDX-License-Identifier: MIT
// Rolling ground by value noise: random heights at the corners of a grid, blended in between by 3 t^2 - 2 t^3, four
// octaves. World: metres, y up.
#include "terrain.h"

#include "scenario.h"
#include "sole/ground.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// The same number for the same place in every run: an integer hash.
static uint32_t benchHash( uint32_t x )
{
	x = ( x ^ ( x >> 16 ) ) * 0x7feb352du;
	x = ( x ^ ( x >> 15 ) ) * 0x846ca68bu;
	return x ^ ( x >> 16 );
}

/// [-1, 1]
static float benchNoiseAt( int32_t i, int32_t j, uint32_t seed )
{
	uint32_t h = benchHash( benchHash( (uint32_t)i * 73856093u + seed ) ^ ( (uint32_t)j * 19349663u ) );
	return (float)( h >> 8 ) / 8388608.0f - 1.0f;
}

static float benchNoise( float x, float z, uint32_t seed )
{
	int32_t i = (int32_t)x;
	int32_t j = (int32_t)z;
	float s = x - (float)i;
	float t = z - (float)j;
	s = s * s * ( 3.0f - 2.0f * s );
	t = t * t * ( 3.0f - 2.0f * t );
	float low = benchNoiseAt( i, j, seed ) * ( 1.0f - s ) + benchNoiseAt( i + 1, j, seed ) * s;
	float high = benchNoiseAt( i, j + 1, seed ) * ( 1.0f - s ) + benchNoiseAt( i + 1, j + 1, seed ) * s;
	return low * ( 1.0f - t ) + high * t;
}

static float benchHeight( float x, float z )
{
	return 2.0f * benchNoise( 0.03f * x, 0.03f * z, 1 ) + 0.4f * benchNoise( 0.2f * x, 0.2f * z, 2 ) +
	    0.1f * benchNoise( x, z, 3 ) + 0.05f * benchNoise( 4.0f * x, 4.0f * z, 4 );
}

static int32_t benchGetCells( int64_t triangleCount )
{
	int32_t cells = 1;
	while ( 2 * (int64_t)( cells + 1 ) * ( cells + 1 ) <= triangleCount )
	{
		cells += 1;
	}
	return cells;
}

benchMesh benchMakeTerrain( int64_t triangleCount )
{
	int32_t cells = benchGetCells( triangleCount );
	int32_t side = cells + 1;
	benchMesh mesh = { .vertexCount = side * side, .triangleCount = 2 * cells * cells };
	mesh.vertices = benchAlloc( (size_t)mesh.vertexCount * 3, sizeof( float ) );
	mesh.indices = benchAlloc( (size_t)mesh.triangleCount * 3, sizeof( uint32_t ) );
	for ( int32_t k = 0; k < mesh.vertexCount; ++k )
	{
		float* p = mesh.vertices + 3 * (size_t)k;
		p[0] = BENCH_CELL * ( (float)( k % side ) + 0.2f * benchNoiseAt( k, 0, 5 ) + 1.0f );
		p[2] = BENCH_CELL * ( (float)( k / side ) + 0.2f * benchNoiseAt( k, 0, 6 ) + 1.0f );
		p[1] = benchHeight( p[0], p[2] );
	}
	uint32_t* t = mesh.indices;
	for ( int32_t k = 0; k < cells * cells; ++k )
	{
		uint32_t a = (uint32_t)( ( k / cells ) * side + k % cells );
		uint32_t b = a + (uint32_t)side;
		uint32_t quad[6] = { a, b + 1, a + 1, a, b, b + 1 };
		memcpy( t, quad, sizeof quad );
		t += 6;
	}
	return mesh;
}

float* benchMakeHeights( int64_t triangleCount, int32_t* countX )
{
	int32_t side = benchGetCells( triangleCount ) + 1;
	float* heights = benchAlloc( (size_t)side * (size_t)side, sizeof( float ) );
	for ( int32_t k = 0; k < side * side; ++k )
	{
		heights[k] = benchHeight( BENCH_CELL * (float)( k % side + 1 ), BENCH_CELL * (float)( k / side + 1 ) );
	}
	*countX = side;
	return heights;
}

benchMesh benchMakeSceneMesh( const char* id )
{
	soleScene scene;
	if ( !soleMakeScene( id, &scene ) )
	{
		fprintf( stderr, "sole_bench: scene %s cannot be made\n", id );
		exit( 1 );
	}
	benchMesh mesh = { .vertexCount = scene.vertexCount, .triangleCount = scene.triangleCount };
	mesh.vertices = benchAlloc( (size_t)mesh.vertexCount * 3, sizeof( float ) );
	mesh.indices = benchAlloc( (size_t)mesh.triangleCount * 3, sizeof( uint32_t ) );
	memcpy( mesh.vertices, scene.positions, (size_t)mesh.vertexCount * 3 * sizeof( float ) );
	memcpy( mesh.indices, scene.indices, (size_t)mesh.triangleCount * 3 * sizeof( uint32_t ) );
	soleFreeScene( &scene );
	return mesh;
}

void benchFreeMesh( benchMesh* mesh )
{
	free( mesh->vertices );
	free( mesh->indices );
	*mesh = ( benchMesh ){ 0 };
}

// ------------------------------------------------------------------------------------------------------- questions

/// Bits of two numbers in turn: neighbours in the plane are mostly neighbours in the result.
static uint32_t benchInterleave( uint32_t x, uint32_t z )
{
	uint32_t code = 0;
	for ( uint32_t bit = 0; bit < 16; ++bit )
	{
		code |= ( x >> bit & 1u ) << ( 2 * bit ) | ( z >> bit & 1u ) << ( 2 * bit + 1 );
	}
	return code;
}

static int benchCompareQueries( const void* a, const void* b )
{
	const float* p = ( (const benchQuery*)a )->start;
	const float* q = ( (const benchQuery*)b )->start;
	uint32_t x = benchInterleave( (uint32_t)( 64.0f * p[0] ), (uint32_t)( 64.0f * p[2] ) );
	uint32_t y = benchInterleave( (uint32_t)( 64.0f * q[0] ), (uint32_t)( 64.0f * q[2] ) );
	return x < y ? -1 : ( x > y ? 1 : 0 );
}

benchQuery* benchMakeQueries( const benchMesh* mesh, benchOrder order, float radius, int32_t count )
{
	static const float foot[5][2] = { { 0.0f, 0.0f }, { 0.0f, 0.19f }, { 0.0f, 0.26f }, { 0.045f, 0.19f },
		{ -0.045f, 0.19f } };
	float low[3];
	float high[3];
	memcpy( low, mesh->vertices, sizeof low );
	memcpy( high, mesh->vertices, sizeof high );
	for ( int32_t i = 0; i < 3 * mesh->vertexCount; ++i )
	{
		float x = mesh->vertices[i];
		low[i % 3] = x < low[i % 3] ? x : low[i % 3];
		high[i % 3] = x > high[i % 3] ? x : high[i % 3];
	}
	benchQuery* queries = benchAlloc( (size_t)count, sizeof *queries );
	float* heights = benchAlloc( (size_t)count, sizeof *heights );
	for ( int32_t i = 0; i < count; ++i )
	{
		bool five = order == bench_fives;
		uint32_t place = (uint32_t)( five ? i / 5 : i );
		float x = 0.03f + 0.94f * ( (float)( benchHash( 2 * place ) >> 8 ) / 16777216.0f );
		float z = 0.03f + 0.94f * ( (float)( benchHash( 2 * place + 1 ) >> 8 ) / 16777216.0f );
		queries[i] =
		    ( benchQuery ){ { low[0] + x * ( high[0] - low[0] ) + ( five ? foot[i % 5][0] : 0.0f ), high[1] + 1.0f,
			                    low[2] + z * ( high[2] - low[2] ) + ( five ? foot[i % 5][1] : 0.0f ) },
			    high[1] - low[1] + 2.0f, 0.0f };
	}
	void* ground = benchSole.make( mesh );
	benchSole.castRays( ground, queries, count, heights );
	for ( int32_t i = 0; i < count; ++i )
	{
		bool met = heights[i] > -1e30f;
		queries[i].start[1] = ( met ? heights[i] : 0.0f ) + 1.0f;
		queries[i].length = 2.0f;
		queries[i].radius = radius;
	}
	benchSole.destroy( ground );
	free( heights );
	if ( order == bench_inOrder )
	{
		qsort( queries, (size_t)count, sizeof *queries, benchCompareQueries );
	}
	return queries;
}
