// SPDX-License-Identifier: MIT
// Embree 3, one ray at a time and in packets, closed on edges (robust) as Sole is.
#include "peers.h"

#include <embree3/rtcore.h>

#include <stdlib.h>
#include <string.h>

typedef struct benchEmbreeScene
{
	RTCDevice device;
	RTCScene scene;
} benchEmbreeScene;

static void* benchMakeEmbree( const benchMesh* mesh )
{
	benchEmbreeScene* made = benchAlloc( 1, sizeof *made );
	made->device = rtcNewDevice( "threads=1" );
	made->scene = rtcNewScene( made->device );
	rtcSetSceneFlags( made->scene, RTC_SCENE_FLAG_ROBUST );
	RTCGeometry geometry = rtcNewGeometry( made->device, RTC_GEOMETRY_TYPE_TRIANGLE );
	float* vertices = rtcSetNewGeometryBuffer(
	    geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof( float ), (size_t)mesh->vertexCount );
	memcpy( vertices, mesh->vertices, (size_t)mesh->vertexCount * 3 * sizeof( float ) );
	uint32_t* indices = rtcSetNewGeometryBuffer(
	    geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof( uint32_t ), (size_t)mesh->triangleCount );
	memcpy( indices, mesh->indices, (size_t)mesh->triangleCount * 3 * sizeof( uint32_t ) );
	rtcCommitGeometry( geometry );
	rtcAttachGeometry( made->scene, geometry );
	rtcReleaseGeometry( geometry );
	rtcCommitScene( made->scene );
	return made;
}

static void benchDestroyEmbree( void* made )
{
	benchEmbreeScene* scene = made;
	rtcReleaseScene( scene->scene );
	rtcReleaseDevice( scene->device );
	free( scene );
}

static void benchCastEmbree( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	const benchEmbreeScene* scene = made;
	struct RTCIntersectContext context;
	rtcInitIntersectContext( &context );
	for ( int32_t i = 0; i < count; ++i )
	{
		const benchQuery* q = queries + i;
		struct RTCRayHit ray = { .ray = { .org_x = q->start[0],
			                         .org_y = q->start[1],
			                         .org_z = q->start[2],
			                         .dir_y = -1.0f,
			                         .tfar = q->length,
			                         .mask = 0xffffffffu },
			.hit = { .geomID = RTC_INVALID_GEOMETRY_ID } };
		rtcIntersect1( scene->scene, &context, &ray );
		heights[i] = ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? q->start[1] - ray.ray.tfar : -1e31f;
	}
}

static void benchCastEmbreeFives( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	const benchEmbreeScene* scene = made;
	struct RTCIntersectContext context;
	rtcInitIntersectContext( &context );
	context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
	_Alignas( 32 ) int valid[8] = { -1, -1, -1, -1, -1, 0, 0, 0 };
	// Zeros in the lanes that are not asked too: what happens to lie there may be dear to compute with.
	_Alignas( 32 ) struct RTCRayHit8 rays;
	memset( &rays, 0, sizeof rays );
	for ( int32_t i = 0; i + 5 <= count; i += 5 )
	{
		for ( int32_t k = 0; k < 5; ++k )
		{
			const benchQuery* q = queries + i + k;
			rays.ray.org_x[k] = q->start[0];
			rays.ray.org_y[k] = q->start[1];
			rays.ray.org_z[k] = q->start[2];
			rays.ray.dir_x[k] = 0.0f;
			rays.ray.dir_y[k] = -1.0f;
			rays.ray.dir_z[k] = 0.0f;
			rays.ray.tnear[k] = 0.0f;
			rays.ray.tfar[k] = q->length;
			rays.ray.time[k] = 0.0f;
			rays.ray.mask[k] = 0xffffffffu;
			rays.ray.flags[k] = 0;
			rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
			rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
		}
		rtcIntersect8( valid, scene->scene, &context, &rays );
		for ( int32_t k = 0; k < 5; ++k )
		{
			bool met = rays.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
			heights[i + k] = met ? queries[i + k].start[1] - rays.ray.tfar[k] : -1e31f;
		}
	}
}

const benchPeer benchEmbree = { "embree", { true, false, true }, benchMakeEmbree, benchDestroyEmbree, benchCastEmbree,
	NULL, benchCastEmbreeFives };
