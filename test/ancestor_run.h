// SPDX-License-Identifier: MIT
// The plain biped over small grounds for the tests of the ancestors: an inclined plane or a level one with a raised
// block, and where the joints then are, by forward kinematics. World: metres, y up.
#ifndef TEST_ANCESTOR_RUN_H
#define TEST_ANCESTOR_RUN_H

#include "test.h"

#include "biped.h"
#include "sole/ground.h"

/// Not to be copied: its frame points to its pose.
typedef struct ancestorRun
{
	testBiped biped;
	soleFrame frame;
	soleGround* ground; // NULL: nothing anywhere
	soleTransform pose[biped_count];
	soleTransform placed[biped_count];
	soleProbe probes[SOLE_MAX_LEGS];
	soleHit hits[SOLE_MAX_LEGS];
	int32_t probeCount;
	soleOutput out;
} ancestorRun;

/// A plane through a point.
static inline soleGround* ancestorPlane( soleVec3 point, soleVec3 normal )
{
	soleGroundPlane plane = soleDefaultGroundPlane();
	plane.normal = soleNormalizeOr( normal, soleVec( 0.0f, 1.0f, 0.0f ) );
	plane.offset = soleDot( point, plane.normal );
	soleGroundDef def = soleDefaultGroundDef();
	def.planes = &plane;
	def.planeCount = 1;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	return ground;
}

/// A level plane of one height with one of another on it where x > 0: the left foot's side.
static inline soleGround* ancestorStep( float right, float left )
{
	const float vertices[] = { -9.0f, right, -9.0f, 0.0f, right, -9.0f, 0.0f, right, 9.0f, -9.0f, right, 9.0f, 0.0f,
		left, -9.0f, 9.0f, left, -9.0f, 9.0f, left, 9.0f, 0.0f, left, 9.0f };
	const uint32_t indices[] = { 0, 2, 1, 0, 3, 2, 4, 6, 5, 4, 7, 6 };
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = vertices;
	mesh.vertexCount = 8;
	mesh.indices = indices;
	mesh.triangleCount = 4;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	return ground;
}

/// Standing with bent knees at the origin.
static inline void ancestorStart( ancestorRun* run, soleGround* ground )
{
	memset( run, 0, sizeof *run );
	testMakeBiped( &run->biped );
	memcpy( run->pose, run->biped.bindPose, sizeof run->pose );
	testBendKnees( run->pose, 0.9f );
	run->frame = ( soleFrame ){ .pose = run->pose,
		.root = soleTransform_Identity(),
		.up = { 0.0f, 1.0f, 0.0f },
		.timeStep = 1.0f / 60.0f,
		.weight = 1.0f };
	run->ground = ground;
}

static inline void ancestorSetGround( ancestorRun* run, soleGround* ground )
{
	soleDestroyGround( run->ground );
	run->ground = ground;
}

static inline void ancestorEnd( ancestorRun* run )
{
	soleDestroyGround( run->ground );
	soleDestroyRig( run->biped.rig );
}

static inline void ancestorApply( ancestorRun* run )
{
	memcpy( run->placed, run->pose, sizeof run->placed );
	soleApply( run->biped.rig, &run->out, run->placed );
}

static inline int32_t ancestorAnkle( int32_t leg )
{
	return leg == 0 ? biped_ankleL : biped_ankleR;
}

static inline soleTransform ancestorAnimated( const ancestorRun* run, int32_t joint )
{
	return testJoint( &run->biped, run->pose, run->frame.root, joint );
}

static inline soleTransform ancestorPlaced( const ancestorRun* run, int32_t joint )
{
	return testJoint( &run->biped, run->placed, run->frame.root, joint );
}

/// How far the body went up.
static inline float ancestorBody( const ancestorRun* run )
{
	return ancestorPlaced( run, biped_pelvis ).translation.y - ancestorAnimated( run, biped_pelvis ).translation.y;
}

/// The turn that takes one rotation to another, world, as a vector of as many radians.
static inline soleVec3 ancestorTurn( soleQuat from, soleQuat to )
{
	soleQuat q = soleNormalizeQuat( soleMulQuat( to, soleConjugate( from ) ) );
	q = q.w < 0.0f ? soleNegQuat( q ) : q;
	soleVec3 v = soleVec( q.x, q.y, q.z );
	float s = soleLength( v );
	return s > 1e-7f ? soleScale( 2.0f * atan2f( s, q.w ) / s, v ) : soleScale( 2.0f, v );
}

/// Pitches both animated feet, toes down positive.
static inline void ancestorPitchFeet( ancestorRun* run, float angle )
{
	soleQuat pitch = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), angle );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleTransform* ankle = run->pose + ancestorAnkle( leg );
		ankle->rotation = soleMulQuat( pitch, ankle->rotation );
	}
}

#endif
