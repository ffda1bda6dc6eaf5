// SPDX-License-Identifier: MIT
// Ground queries of Sole and its peers, over terrains of growing size and over the scenarios' own grounds: rays and
// spheres, five rays under a foot, building, memory. All straight down, a metre above the ground to a metre below.
#include "terrain.h"

#include "sole/ground.h"

#include <stdlib.h>

#define QUERY_COUNT 40000
#define COUNTED_SIZE 10000 // triangles where instructions are counted

static const benchPeer* const benchPeers[] = {
	&benchSole,
	&benchSoleBatch,
#if BENCH_EMBREE
	&benchEmbree,
#endif
#if BENCH_ODE
	&benchOde,
#endif
#if BENCH_BULLET
	&benchBullet,
#endif
};
enum
{
	benchPeerCount = sizeof benchPeers / sizeof *benchPeers
};

/// How peers are asked.
typedef enum benchAsked
{
	bench_rays,
	bench_spheres,
	bench_footRays
} benchAsked;

typedef struct benchAsking
{
	const benchPeer* peer;
	const char* scene; // NULL: terrain
	int64_t size;
	benchOrder order;
	benchAsked asked;
	bool field; // Sole's height field in the mesh's place
} benchAsking;

typedef struct benchGroundRun
{
	benchAsking asking;
	benchMesh mesh;
	void* made;
	benchQuery* queries;
	float* heights;
} benchGroundRun;

static benchMesh benchMakeMesh( const benchAsking* asking )
{
	return asking->scene != NULL ? benchMakeSceneMesh( asking->scene ) : benchMakeTerrain( asking->size );
}

static void* benchMakeField( int64_t size )
{
	soleHeightField field = soleDefaultHeightField();
	float* heights = benchMakeHeights( size, &field.countX );
	field.countZ = field.countX;
	field.cellX = BENCH_CELL;
	field.cellZ = BENCH_CELL;
	field.origin = soleVec( BENCH_CELL, 0.0f, BENCH_CELL );
	field.heights = heights;
	soleGroundDef def = soleDefaultGroundDef();
	def.heightFields = &field;
	def.heightFieldCount = 1;
	soleGround* ground = NULL;
	soleCreateGround( &def, NULL, &ground, NULL );
	free( heights );
	return ground;
}

static void* benchOpenGround( const void* argument )
{
	benchGroundRun* run = benchAlloc( 1, sizeof *run );
	run->asking = *(const benchAsking*)argument;
	run->mesh = benchMakeMesh( &run->asking );
	run->queries = benchMakeQueries(
	    &run->mesh, run->asking.order, run->asking.asked == bench_spheres ? 0.1f : 0.0f, QUERY_COUNT );
	run->heights = benchAlloc( QUERY_COUNT, sizeof *run->heights );
	run->made = run->asking.field ? benchMakeField( run->asking.size ) : run->asking.peer->make( &run->mesh );
	return run;
}

static void benchRunGround( void* context )
{
	benchGroundRun* run = context;
	const benchPeer* peer = run->asking.peer;
	void ( *cast )( void*, const benchQuery*, int32_t, float* ) = run->asking.asked == bench_rays
	    ? peer->castRays
	    : ( run->asking.asked == bench_spheres ? peer->castSpheres : peer->castFives );
	cast( run->made, run->queries, QUERY_COUNT, run->heights );
}

static void benchCloseGround( void* context )
{
	benchGroundRun* run = context;
	run->asking.peer->destroy( run->made );
	benchFreeMesh( &run->mesh );
	free( run->queries );
	free( run->heights );
	free( run );
}

// -------------------------------------------------------------------------------------------------------- building

static void benchRunBuild( void* context )
{
	benchGroundRun* run = context;
	run->asking.peer->destroy( run->made );
	run->made = run->asking.peer->make( &run->mesh );
}

/// To where everything is already: as much work as to anywhere else.
static void benchRunRefit( void* context )
{
	benchGroundRun* run = context;
	soleGroundMesh groundMesh = benchDescribeMesh( &run->mesh );
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &groundMesh;
	def.meshCount = 1;
	soleRefitGround( run->made, &def, NULL );
}

// ---------------------------------------------------------------------------------------------------------- memory

/// What an allocator gave out and did not get back.
static void* benchCountingAlloc( size_t byteCount, void* user )
{
	*(double*)user += (double)byteCount;
	return malloc( byteCount );
}

static void benchCountingFree( void* memory, size_t byteCount, void* user )
{
	*(double*)user -= (double)byteCount;
	free( memory );
}

/// Bytes a triangle of a ground, beyond the mesh: 12 a vertex and 12 a triangle.
static void* benchOpenMemory( const void* argument )
{
	const benchAsking* asking = argument;
	benchMesh mesh = benchMakeMesh( asking );
	double* bytes = benchAlloc( 1, sizeof *bytes );
	soleAllocator allocator = { benchCountingAlloc, benchCountingFree, bytes };
	soleGroundMesh groundMesh = benchDescribeMesh( &mesh );
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &groundMesh;
	def.meshCount = 1;
	soleGround* ground = NULL;
	soleCreateGround( &def, &allocator, &ground, NULL );
	double whole = *bytes;
	soleDestroyGround( ground );
	*bytes = ( whole - 12.0 * mesh.vertexCount - 12.0 * mesh.triangleCount ) / mesh.triangleCount;
	benchFreeMesh( &mesh );
	return bytes;
}

// ----------------------------------------------------------------------------------------------------------- adding

static const benchAsking* benchKeep( benchAsking asking )
{
	benchAsking* kept = benchAlloc( 1, sizeof *kept ); // as long as the list
	*kept = asking;
	return kept;
}

static void benchAddAsking( benchList* list, const char* stem, benchAsking asking, const char* unit )
{
	for ( int32_t i = 0; i < benchPeerCount; ++i )
	{
		asking.peer = benchPeers[i];
		if ( asking.peer->casts[asking.asked] == false || ( asking.field && asking.peer != &benchSole ) )
		{
			continue;
		}
		benchAdd( list,
		    ( benchCase ){
		        .name = asking.scene != NULL ? stem : benchName( stem, asking.size ),
		        .variant = asking.peer->name,
		        .unit = unit,
		        .itemCount = QUERY_COUNT,
		        .counted = asking.peer == &benchSole && asking.scene == NULL && asking.size == COUNTED_SIZE,
		        .open = benchOpenGround,
		        .argument = benchKeep( asking ),
		        .run = benchRunGround,
		        .close = benchCloseGround,
		    } );
	}
}

static void benchAddBuild( benchList* list, int64_t size )
{
	for ( int32_t i = 0; i < benchPeerCount; ++i )
	{
		if ( benchPeers[i] == &benchSoleBatch )
		{
			continue;
		}
		benchAdd( list,
		    ( benchCase ){
		        .name = benchName( "build", size ),
		        .variant = benchPeers[i]->name,
		        .unit = "triangle",
		        .itemCount = size,
		        .counted = i == 0 && size == COUNTED_SIZE,
		        .open = benchOpenGround,
		        .argument = benchKeep( ( benchAsking ){ .peer = benchPeers[i], .size = size } ),
		        .run = benchRunBuild,
		        .close = benchCloseGround,
		    } );
	}
	benchAdd( list,
	    ( benchCase ){
	        .name = benchName( "refit", size ),
	        .variant = benchSole.name,
	        .unit = "triangle",
	        .itemCount = size,
	        .open = benchOpenGround,
	        .argument = benchKeep( ( benchAsking ){ .peer = &benchSole, .size = size } ),
	        .run = benchRunRefit,
	        .close = benchCloseGround,
	    } );
	benchAdd( list,
	    ( benchCase ){
	        .name = benchName( "memory", size ),
	        .variant = "sole",
	        .unit = "bytes/triangle",
	        .itemCount = 1,
	        .open = benchOpenMemory,
	        .argument = benchKeep( ( benchAsking ){ .size = size } ),
	        .close = free,
	    } );
}

void benchAddGround( benchList* list, int64_t largest )
{
	for ( int64_t size = COUNTED_SIZE; size <= 1000000 && size <= largest; size *= 10 )
	{
		benchAsking asking = { .size = size };
		benchAddAsking( list, "ray-scattered", asking, "ray" );
		asking.order = bench_inOrder;
		benchAddAsking( list, "ray-in-order", asking, "ray" );
		asking.field = true;
		benchAddAsking( list, "ray-field", asking, "ray" );
		asking = ( benchAsking ){ .size = size, .order = bench_fives, .asked = bench_footRays };
		benchAddAsking( list, "five-rays", asking, "ray" );
		asking = ( benchAsking ){ .size = size, .asked = bench_spheres };
		benchAddAsking( list, "sphere-scattered", asking, "sphere" );
		asking.order = bench_inOrder;
		benchAddAsking( list, "sphere-in-order", asking, "sphere" );
		benchAddBuild( list, size );
	}
	static const char* const scenes[][2] = { { "ray-flat", "flat" }, { "ray-stairs", "stairs" },
		{ "ray-rubble", "rubble" }, { "ray-course", "course" } };
	for ( int32_t i = 0; i < 4; ++i )
	{
		benchAddAsking( list, scenes[i][0], ( benchAsking ){ .scene = scenes[i][1] }, "ray" );
	}
}
