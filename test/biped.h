// SPDX-License-Identifier: MIT
// A biped of plain numbers for tests: thigh 0.45, shin 0.45, ankle 0.08 over the sole, heel 0.07 behind and ball 0.12
// ahead of the ankle, toe tip at 0.19, hips 0.09 to either side. Y up, faces +Z, left at +X.
#ifndef TEST_BIPED_H
#define TEST_BIPED_H

#include "sole/sole.h"

enum
{
	biped_root,
	biped_pelvis,
	biped_spine,
	biped_hipL,
	biped_kneeL,
	biped_ankleL,
	biped_toeL,
	biped_hipR,
	biped_kneeR,
	biped_ankleR,
	biped_toeR,
	biped_count
};

typedef struct testBiped
{
	int32_t parents[biped_count];
	soleTransform bindPose[biped_count];
	soleRigDef def;
	soleRig* rig;
} testBiped;

static inline soleTransform testAt( float x, float y, float z )
{
	soleTransform t = soleTransform_Identity();
	t.translation = soleVec( x, y, z );
	return t;
}

static inline soleQuat testTurn( soleVec3 axis, float angle )
{
	float s = sinf( 0.5f * angle );
	return ( soleQuat ){ s * axis.x, s * axis.y, s * axis.z, cosf( 0.5f * angle ) };
}

/// Bends both knees by moving hips down: flexion about +X carries the shin back.
static inline void testBendKnees( soleTransform* pose, float flexion )
{
	soleVec3 x = soleVec( 1.0f, 0.0f, 0.0f );
	const int32_t hips[] = { biped_hipL, biped_hipR };
	for ( int32_t i = 0; i < 2; ++i )
	{
		pose[hips[i]].rotation = testTurn( x, -0.5f * flexion );
		pose[hips[i] + 1].rotation = testTurn( x, flexion );
		pose[hips[i] + 2].rotation = testTurn( x, -0.5f * flexion );
	}
	pose[biped_pelvis].translation.y = 0.08f + 0.9f * cosf( 0.5f * flexion );
}

static inline soleRigDef testBipedDef( testBiped* biped )
{
	static const int32_t parents[] = { SOLE_NONE, 0, 1, 1, 3, 4, 5, 1, 7, 8, 9 };
	memcpy( biped->parents, parents, sizeof parents );
	soleTransform* p = biped->bindPose;
	p[biped_root] = testAt( 0.0f, 0.0f, 0.0f );
	p[biped_pelvis] = testAt( 0.0f, 0.98f, 0.0f );
	p[biped_spine] = testAt( 0.0f, 0.2f, 0.0f );
	for ( int32_t side = 0; side < 2; ++side )
	{
		int32_t hip = side == 0 ? biped_hipL : biped_hipR;
		p[hip] = testAt( side == 0 ? 0.09f : -0.09f, 0.0f, 0.0f );
		p[hip + 1] = testAt( 0.0f, -0.45f, 0.0f );
		p[hip + 2] = testAt( 0.0f, -0.45f, 0.0f );
		p[hip + 3] = testAt( 0.0f, -0.06f, 0.12f );
	}
	testBendKnees( p, 0.2f );
	soleRigDef def = soleDefaultRigDef();
	def.jointCount = biped_count;
	def.parents = biped->parents;
	def.bindPose = biped->bindPose;
	def.pelvis = biped_pelvis;
	def.legCount = 2;
	for ( int32_t side = 0; side < 2; ++side )
	{
		soleLegDef* leg = def.legs + side;
		int32_t hip = side == 0 ? biped_hipL : biped_hipR;
		float x = side == 0 ? 0.09f : -0.09f;
		float out = side == 0 ? 0.045f : -0.045f;
		leg->name = side == 0 ? "left" : "right";
		leg->side = side == 0 ? sole_left : sole_right;
		leg->joints[0] = hip;
		leg->joints[1] = hip + 1;
		leg->joints[2] = hip + 2;
		leg->jointCount = 3;
		leg->toes[0] = hip + 3;
		leg->toeCount = 1;
		leg->hinge = soleVec( 1.0f, 0.0f, 0.0f );
		leg->sole.heel = soleVec( x, 0.0f, -0.07f );
		leg->sole.ball = soleVec( x, 0.0f, 0.12f );
		leg->sole.toe = soleVec( x, 0.0f, 0.19f );
		leg->sole.inner = soleVec( x - out, 0.0f, 0.12f );
		leg->sole.outer = soleVec( x + out, 0.0f, 0.12f );
	}
	return def;
}

static inline void testMakeBiped( testBiped* biped )
{
	biped->def = testBipedDef( biped );
	soleMessage message;
	soleResult result = soleCreateRig( &biped->def, NULL, &biped->rig, &message );
	if ( result != sole_success )
	{
		print_error( "%s\n", message.text );
	}
	assert_int_equal( result, sole_success );
}

/// Where a joint of a pose is, root included.
static inline soleTransform testJoint(
    const testBiped* biped, const soleTransform* pose, soleTransform root, int32_t joint )
{
	soleTransform t = pose[joint];
	for ( int32_t j = biped->parents[joint]; j != SOLE_NONE; j = biped->parents[j] )
	{
		t = soleMulTransform( pose[j], t );
	}
	return soleMulTransform( root, t );
}

#endif
