// SPDX-License-Identifier: MIT
// Sole's own ground among the peers.
#include "terrain.h"

#define MOST_AT_ONCE 40 // probes, as of a few characters; the questions are a multiple of it

soleGroundMesh benchDescribeMesh( const benchMesh* mesh )
{
	soleGroundMesh groundMesh = soleDefaultGroundMesh();
	groundMesh.vertices = mesh->vertices;
	groundMesh.vertexCount = mesh->vertexCount;
	groundMesh.indices = mesh->indices;
	groundMesh.triangleCount = mesh->triangleCount;
	return groundMesh;
}

static void* soleMakePeer( const benchMesh* mesh )
{
	soleGroundMesh groundMesh = benchDescribeMesh( mesh );
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &groundMesh;
	def.meshCount = 1;
	soleGround* ground = NULL;
	soleCreateGround( &def, NULL, &ground, NULL );
	return ground;
}

static void soleDestroyPeer( void* made )
{
	soleDestroyGround( made );
}

static soleProbe soleMakePeerProbe( const benchQuery* query )
{
	return ( soleProbe ){
		.start_w = { query->start[0], query->start[1], query->start[2] },
		.direction_w = { 0.0f, -1.0f, 0.0f },
		.length = query->length,
		.radius = query->radius,
		.mask = 0xffffffffu,
	};
}

static float soleReadPeerHit( const soleHit* hit )
{
	return hit->hit ? hit->point_w.y : -1e31f;
}

static void soleCastPeer( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		soleProbe probe = soleMakePeerProbe( queries + i );
		soleHit hit = soleCastProbe( made, &probe );
		heights[i] = soleReadPeerHit( &hit );
	}
}

/// By the call for many, so many at a time.
static void soleCastPeerMany( void* made, const benchQuery* queries, int32_t count, int32_t atOnce, float* heights )
{
	soleProbe probes[MOST_AT_ONCE];
	soleHit hits[MOST_AT_ONCE];
	for ( int32_t i = 0; i + atOnce <= count; i += atOnce )
	{
		for ( int32_t k = 0; k < atOnce; ++k )
		{
			probes[k] = soleMakePeerProbe( queries + i + k );
		}
		soleCastProbes( made, probes, atOnce, hits );
		for ( int32_t k = 0; k < atOnce; ++k )
		{
			heights[i + k] = soleReadPeerHit( hits + k );
		}
	}
}

static void soleCastPeerFives( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	soleCastPeerMany( made, queries, count, 5, heights );
}

static void soleCastPeerBatches( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	soleCastPeerMany( made, queries, count, MOST_AT_ONCE, heights );
}

const benchPeer benchSole = { "sole", { true, true, true }, soleMakePeer, soleDestroyPeer, soleCastPeer, soleCastPeer,
	soleCastPeerFives };
const benchPeer benchSoleBatch = { "sole-batch", { true, true, false }, soleMakePeer, soleDestroyPeer,
	soleCastPeerBatches, soleCastPeerBatches, NULL };
