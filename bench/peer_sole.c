// SPDX-License-Identifier: MIT
// Sole's own ground among the peers.
#include "peers.h"

#include "sole/ground.h"

static void* soleMakePeer( const benchMesh* mesh )
{
	soleGroundMesh groundMesh = soleDefaultGroundMesh();
	groundMesh.vertices = mesh->vertices;
	groundMesh.vertexCount = mesh->vertexCount;
	groundMesh.indices = mesh->indices;
	groundMesh.triangleCount = mesh->triangleCount;
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

static void soleCastPeerFives( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	for ( int32_t i = 0; i + 5 <= count; i += 5 )
	{
		soleProbe probes[5];
		soleHit hits[5];
		for ( int32_t k = 0; k < 5; ++k )
		{
			probes[k] = soleMakePeerProbe( queries + i + k );
		}
		soleCastProbes( made, probes, 5, hits );
		for ( int32_t k = 0; k < 5; ++k )
		{
			heights[i + k] = soleReadPeerHit( hits + k );
		}
	}
}

const benchPeer benchSole = { "sole", { true, true, true }, soleMakePeer, soleDestroyPeer, soleCastPeer, soleCastPeer,
	soleCastPeerFives };
