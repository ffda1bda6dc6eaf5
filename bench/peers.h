// SPDX-License-Identifier: MIT
// The grounds of others, asked the same as Sole's, each in a file of its own and there only where it is installed.
#ifndef BENCH_PEERS_H
#define BENCH_PEERS_H

#include "bench.h"

#ifdef __cplusplus
extern "C"
{
#endif

	/// Triangles as peers take them: packed, counter clockwise from their fronts.
	typedef struct benchMesh
	{
		float* vertices; // 3 each
		int32_t vertexCount;
		uint32_t* indices; // 3 a triangle
		int32_t triangleCount;
	} benchMesh;

	/// A vertical question: from start straight down.
	typedef struct benchQuery
	{
		float start[3];
		float length;
		float radius; // 0: a ray
	} benchQuery;

	/// One who holds a mesh and answers questions about it.
	typedef struct benchPeer
	{
		const char* name;
		bool casts[3]; // rays one by one, spheres, five rays at once
		void* ( *make )( const benchMesh* mesh );
		void ( *destroy )( void* made );
		/// Heights of what is met, or below -1e30. @param count a multiple of five where five are asked at once
		void ( *castRays )( void* made, const benchQuery* queries, int32_t count, float* heights );
		void ( *castSpheres )( void* made, const benchQuery* queries, int32_t count, float* heights );
		void ( *castFives )( void* made, const benchQuery* queries, int32_t count, float* heights );
	} benchPeer;

	extern const benchPeer benchSole;
	extern const benchPeer benchSoleBatch; // the same ground, many asked at once
#if BENCH_EMBREE
	extern const benchPeer benchEmbree;
#endif
#if BENCH_ODE
	extern const benchPeer benchOde;
#endif
#if BENCH_BULLET
	extern const benchPeer benchBullet;
#endif

#ifdef __cplusplus
}
#endif

#endif
