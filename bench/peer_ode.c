// SPDX-License-Identifier: MIT
// ODE's triangle meshes asked with rays.
#include "peers.h"

#include <ode/ode.h>

#include <stdlib.h>

typedef struct benchOdeMesh
{
	dTriMeshDataID data;
	dGeomID mesh;
	dGeomID ray;
} benchOdeMesh;

static void* benchMakeOde( const benchMesh* mesh )
{
	dInitODE2( 0 );
	benchOdeMesh* made = benchAlloc( 1, sizeof *made );
	made->data = dGeomTriMeshDataCreate();
	dGeomTriMeshDataBuildSingle( made->data, mesh->vertices, 3 * sizeof( float ), mesh->vertexCount, mesh->indices,
	    3 * mesh->triangleCount, 3 * sizeof( uint32_t ) );
	made->mesh = dCreateTriMesh( NULL, made->data, NULL, NULL, NULL );
	made->ray = dCreateRay( NULL, 1.0 );
	dGeomRaySetClosestHit( made->ray, 1 );
	return made;
}

static void benchDestroyOde( void* made )
{
	benchOdeMesh* mesh = made;
	dGeomDestroy( mesh->ray );
	dGeomDestroy( mesh->mesh );
	dGeomTriMeshDataDestroy( mesh->data );
	free( mesh );
	dCloseODE();
}

static void benchCastOde( void* made, const benchQuery* queries, int32_t count, float* heights )
{
	const benchOdeMesh* mesh = made;
	for ( int32_t i = 0; i < count; ++i )
	{
		const benchQuery* q = queries + i;
		dGeomRaySetLength( mesh->ray, (dReal)q->length );
		dGeomRaySet( mesh->ray, (dReal)q->start[0], (dReal)q->start[1], (dReal)q->start[2], 0.0, -1.0, 0.0 );
		dContactGeom contact;
		int met = dCollide( mesh->ray, mesh->mesh, 1, &contact, sizeof contact );
		heights[i] = met > 0 ? (float)contact.pos[1] : -1e31f;
	}
}

const benchPeer benchOde = { "ode", { true, false, false }, benchMakeOde, benchDestroyOde, benchCastOde, NULL, NULL };
