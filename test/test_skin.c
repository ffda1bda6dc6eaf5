// SPDX-License-Identifier: MIT
// Skinning: the rest pose gives the mesh back, a moved root moves all of it, meshes without a skin follow their node.
#include "test.h"

#include "mannequin.h"
#include "skin.h"

static void takeRestPose( const toolModel* model, soleTransform* pose )
{
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		pose[i] = model->nodes[i].local;
	}
}

static void testRestPose( void** state )
{
	(void)state;
	toolModel model;
	toolMakeMannequin( &model );
	soleTransform pose[64];
	takeRestPose( &model, pose );
	soleTransform root = soleTransform_Identity();
	root.translation = soleVec( 3.0f, 1.0f, -2.0f );
	root.rotation = ( soleQuat ){ 0.0f, 0.6f, 0.0f, 0.8f };
	toolTriangles still = { 0 };
	toolTriangles moved = { 0 };
	toolSkinModel( &model, pose, soleTransform_Identity(), &still );
	toolSkinModel( &model, pose, root, &moved );

	int32_t at = 0;
	for ( int32_t i = 0; i < model.meshes[0].primitiveCount; ++i )
	{
		const toolPrimitive* primitive = model.meshes[0].primitives + i;
		for ( int32_t v = 0; v < primitive->vertexCount; ++v, ++at )
		{
			const float* p = primitive->positions + 3 * v;
			const float* q = still.positions + 3 * at;
			const float* r = moved.positions + 3 * at;
			testNear3( soleVec( q[0], q[1], q[2] ), soleVec( p[0], p[1], p[2] ), 1e-5f );
			soleVec3 there = soleTransformPoint( root, soleVec( p[0], p[1], p[2] ) );
			testNear3( soleVec( r[0], r[1], r[2] ), there, 1e-5f );
		}
	}
	assert_int_equal( at, still.vertexCount );
	assert_int_equal( moved.triangleCount, still.triangleCount );
	toolFreeTriangles( &still );
	toolFreeTriangles( &moved );
	assert_null( still.positions );
	toolFreeModel( &model );
}

/// The hand's own vertices go with the hand as a rigid body, whatever the arm does.
static void testPosedHandIsRigid( void** state )
{
	(void)state;
	toolModel model;
	toolMakeMannequin( &model );
	soleTransform pose[64];
	takeRestPose( &model, pose );
	pose[toolFindNode( &model, "upperarm_l" )].rotation = ( soleQuat ){ 0.0f, 0.6f, 0.0f, 0.8f };
	pose[toolFindNode( &model, "forearm_l" )].rotation = ( soleQuat ){ 0.48f, 0.0f, 0.36f, 0.8f };
	toolTriangles posed = { 0 };
	toolSkinModel( &model, pose, soleTransform_Identity(), &posed );

	int32_t hand = toolFindNode( &model, "hand_l" );
	soleTransform world = pose[hand];
	for ( int32_t parent = model.nodes[hand].parent; parent != SOLE_NONE; parent = model.nodes[parent].parent )
	{
		world = soleMulTransform( pose[parent], world );
	}
	const toolPrimitive* primitive = model.meshes[0].primitives;
	int32_t found = 0;
	for ( int32_t v = 0; v < primitive->vertexCount; ++v )
	{
		if ( model.skins[0].joints[primitive->joints[4 * v]] == hand && primitive->weights[4 * v] == 1.0f )
		{
			const float* p = primitive->positions + 3 * v;
			const float* q = posed.positions + 3 * v;
			soleVec3 local = soleInvTransformPoint( toolNodeWorld( &model, hand ), soleVec( p[0], p[1], p[2] ) );
			testNear3( soleVec( q[0], q[1], q[2] ), soleTransformPoint( world, local ), 1e-5f );
			++found;
		}
	}
	assert_true( found > 20 );
	toolFreeTriangles( &posed );
	toolFreeModel( &model );
}

static void testMeshWithoutSkin( void** state )
{
	(void)state;
	float positions[] = { 0, 0, 0, 1, 0, 0, 0, 0, 1 };
	uint32_t indices[] = { 0, 2, 1 };
	toolPrimitive primitive = {
		.vertexCount = 3, .positions = positions, .indexCount = 3, .indices = indices, .material = SOLE_NONE
	};
	toolMesh mesh = { .primitiveCount = 1, .primitives = &primitive };
	toolNode nodes[2] = { { .parent = SOLE_NONE, .mesh = SOLE_NONE, .skin = SOLE_NONE },
		{ .parent = 0, .mesh = 0, .skin = SOLE_NONE } };
	toolModel model = { .nodeCount = 2, .nodes = nodes, .meshCount = 1, .meshes = &mesh };
	soleTransform pose[2] = { soleTransform_Identity(), soleTransform_Identity() };
	pose[0].translation = soleVec( 0.0f, 5.0f, 0.0f );
	pose[1].scale = soleVec( 2.0f, 2.0f, 2.0f );
	toolTriangles triangles = { 0 };
	toolSkinModel( &model, pose, soleTransform_Identity(), &triangles );
	toolSkinModel( &model, pose, soleTransform_Identity(), &triangles );
	assert_int_equal( triangles.vertexCount, 6 );
	assert_int_equal( triangles.triangleCount, 2 );
	assert_int_equal( triangles.indices[3], 3 );
	testNear3( soleVec( triangles.positions[12], triangles.positions[13], triangles.positions[14] ),
	    soleVec( 2.0f, 5.0f, 0.0f ), 1e-6f );
	toolFreeTriangles( &triangles );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testRestPose ),
		cmocka_unit_test( testPosedHandIsRigid ),
		cmocka_unit_test( testMeshWithoutSkin ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
