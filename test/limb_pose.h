// SPDX-License-Identifier: MIT
// A chain of joints in a random pose, and its forward kinematics in double precision: what goals of limbs are checked
// against. Character space.
#ifndef TEST_LIMB_POSE_H
#define TEST_LIMB_POSE_H

#include "test.h"

#include "sole/limb.h"

#include <math.h>

#define TEST_JOINTS 7

// A root, what the limb hangs from, the limb with a twist joint in its upper bone, and what hangs from its end.
enum
{
	test_root,
	test_base,
	test_upper,
	test_twist,
	test_lower,
	test_end,
	test_tip
};

static const int32_t testParents[TEST_JOINTS] = { SOLE_NONE, test_root, test_base, test_upper, test_twist, test_lower,
	test_end };

typedef struct testPlace
{
	double position[3];
	double rotation[4];
	double scale;
} testPlace;

static inline void testTurn( const double* q, const double* v, double* out )
{
	double t[3] = { 2.0 * ( q[1] * v[2] - q[2] * v[1] ), 2.0 * ( q[2] * v[0] - q[0] * v[2] ),
		2.0 * ( q[0] * v[1] - q[1] * v[0] ) };
	out[0] = v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1];
	out[1] = v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2];
	out[2] = v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0];
}

static inline testPlace testFindPlace( const soleTransform* pose, int32_t joint )
{
	soleTransform l = pose[joint];
	double p[3] = { (double)l.translation.x, (double)l.translation.y, (double)l.translation.z };
	double q[4] = { (double)l.rotation.x, (double)l.rotation.y, (double)l.rotation.z, (double)l.rotation.w };
	double length = sqrt( q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] );
	for ( int i = 0; i < 4; ++i )
	{
		q[i] /= length;
	}
	testPlace out = { { p[0], p[1], p[2] }, { q[0], q[1], q[2], q[3] }, (double)l.scale.x };
	if ( testParents[joint] != SOLE_NONE )
	{
		testPlace up = testFindPlace( pose, testParents[joint] );
		double scaled[3] = { up.scale * p[0], up.scale * p[1], up.scale * p[2] };
		const double* a = up.rotation;
		testTurn( a, scaled, out.position );
		for ( int i = 0; i < 3; ++i )
		{
			out.position[i] += up.position[i];
		}
		out.rotation[0] = a[3] * q[0] + a[0] * q[3] + a[1] * q[2] - a[2] * q[1];
		out.rotation[1] = a[3] * q[1] + a[1] * q[3] + a[2] * q[0] - a[0] * q[2];
		out.rotation[2] = a[3] * q[2] + a[2] * q[3] + a[0] * q[1] - a[1] * q[0];
		out.rotation[3] = a[3] * q[3] - a[0] * q[0] - a[1] * q[1] - a[2] * q[2];
		out.scale *= up.scale;
	}
	return out;
}

static inline double testFar( const double* a, const double* b )
{
	return sqrt(
	    ( a[0] - b[0] ) * ( a[0] - b[0] ) + ( a[1] - b[1] ) * ( a[1] - b[1] ) + ( a[2] - b[2] ) * ( a[2] - b[2] ) );
}

static inline soleVec3 testAt( const testPlace* place )
{
	return soleVec( (float)place->position[0], (float)place->position[1], (float)place->position[2] );
}

static inline double testFarFrom( const testPlace* place, soleVec3 p )
{
	double other[3] = { (double)p.x, (double)p.y, (double)p.z };
	return testFar( place->position, other );
}

/// The angle between two rotations, rad.
static inline double testAngle( soleQuat a, soleQuat b )
{
	soleQuat d = soleMulQuat( soleConjugate( a ), b );
	double sine = sqrt( (double)d.x * (double)d.x + (double)d.y * (double)d.y + (double)d.z * (double)d.z );
	return 2.0 * atan2( sine, fabs( (double)d.w ) );
}

static inline soleQuat testRotationOf( const testPlace* place )
{
	const double* q = place->rotation;
	return ( soleQuat ){ (float)q[0], (float)q[1], (float)q[2], (float)q[3] };
}

static inline soleQuat testAbout( soleVec3 axis, float angle )
{
	float s = sinf( 0.5f * angle );
	return ( soleQuat ){ s * axis.x, s * axis.y, s * axis.z, cosf( 0.5f * angle ) };
}

/// A limb of bones of 0.2 to 0.4 along its joints' +y, bent about the upper joint's x axis, anywhere.
static inline void testMakePose( uint32_t* seed, float flexion, soleTransform* pose )
{
	for ( int32_t i = 0; i < TEST_JOINTS; ++i )
	{
		pose[i] = soleTransform_Identity();
		pose[i].translation = soleVec( 0.0f, testRandomFloat( seed, 0.2f, 0.4f ), 0.0f );
	}
	pose[test_root].translation = testRandomPoint( seed, 1.0f );
	pose[test_root].rotation = testRandomTurn( seed );
	pose[test_base].rotation = testRandomTurn( seed );
	pose[test_upper].rotation = testRandomTurn( seed );
	pose[test_twist].translation.y *= 0.5f;
	pose[test_lower].translation.y *= 0.5f;
	float twist = testRandomFloat( seed, -1.0f, 1.0f );
	soleVec3 along = soleVec( 0.0f, 1.0f, 0.0f );
	pose[test_twist].rotation = testAbout( along, twist );
	pose[test_lower].rotation =
	    soleMulQuat( testAbout( along, -twist ), testAbout( soleVec( 1.0f, 0.0f, 0.0f ), flexion ) );
	pose[test_end].rotation = testRandomTurn( seed );
}

/// In the plane x = 0.
static inline soleVec3 testMirrorVec( soleVec3 v )
{
	return soleVec( -v.x, v.y, v.z );
}

static inline soleQuat testMirrorQuat( soleQuat q )
{
	return ( soleQuat ){ q.x, -q.y, -q.z, q.w };
}

static inline void testMirrorPose( const soleTransform* pose, soleTransform* mirrored )
{
	for ( int32_t i = 0; i < TEST_JOINTS; ++i )
	{
		mirrored[i] = ( soleTransform ){ testMirrorVec( pose[i].translation ), testMirrorQuat( pose[i].rotation ),
			pose[i].scale };
	}
}

#endif
