// SPDX-License-Identifier: MIT
// Bullet's triangle meshes asked with rays and swept spheres, without its broad phase: one body is all there is.
#include "peers.h"

#include <btBulletCollisionCommon.h>

namespace
{

struct BulletMesh
{
	btTriangleIndexVertexArray* triangles;
	btBvhTriangleMeshShape* shape;
	btCollisionObject* body;
};

void* makeBullet( const benchMesh* mesh )
{
	BulletMesh* made = new BulletMesh();
	made->triangles = new btTriangleIndexVertexArray();
	btIndexedMesh part;
	part.m_numTriangles = mesh->triangleCount;
	part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>( mesh->indices );
	part.m_triangleIndexStride = 3 * sizeof( uint32_t );
	part.m_numVertices = mesh->vertexCount;
	part.m_vertexBase = reinterpret_cast<const unsigned char*>( mesh->vertices );
	part.m_vertexStride = 3 * sizeof( float );
	part.m_vertexType = PHY_FLOAT;
	made->triangles->addIndexedMesh( part, PHY_INTEGER );
	made->shape = new btBvhTriangleMeshShape( made->triangles, true );
	made->body = new btCollisionObject();
	made->body->setCollisionShape( made->shape );
	return made;
}

void destroyBullet( void* made )
{
	BulletMesh* mesh = static_cast<BulletMesh*>( made );
	delete mesh->body;
	delete mesh->shape;
	delete mesh->triangles;
	delete mesh;
}

btTransform placeAt( const float* p, float drop )
{
	btTransform place;
	place.setIdentity();
	place.setOrigin( btVector3( p[0], p[1] - drop, p[2] ) );
	return place;
}

void castRays( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	BulletMesh* mesh = static_cast<BulletMesh*>( made );
	btTransform identity = btTransform::getIdentity();
	for ( int32_t i = 0; i < count; ++i )
	{
		btTransform from = placeAt( queries[i].start, 0.0f );
		btTransform to = placeAt( queries[i].start, queries[i].length );
		btCollisionWorld::ClosestRayResultCallback result( from.getOrigin(), to.getOrigin() );
		btCollisionWorld::rayTestSingle( from, to, mesh->body, mesh->shape, identity, result );
		heights[i] = result.hasHit() ? result.m_hitPointWorld.y() : -1e31f;
	}
}

void castSpheres( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	BulletMesh* mesh = static_cast<BulletMesh*>( made );
	btTransform identity = btTransform::getIdentity();
	for ( int32_t i = 0; i < count; ++i )
	{
		btSphereShape sphere( queries[i].radius );
		btTransform from = placeAt( queries[i].start, 0.0f );
		btTransform to = placeAt( queries[i].start, queries[i].length );
		btCollisionWorld::ClosestConvexResultCallback result( from.getOrigin(), to.getOrigin() );
		btCollisionWorld::objectQuerySingle( &sphere, from, to, mesh->body, mesh->shape, identity, result, 0.0f );
		heights[i] = result.hasHit() ? result.m_hitPointWorld.y() : -1e31f;
	}
}

} // namespace

extern "C" const benchPeer benchBullet = { "bullet", { true, true, false }, makeBullet, destroyBullet, castRays,
	castSpheres, nullptr };
