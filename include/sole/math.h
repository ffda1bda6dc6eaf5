// SPDX-License-Identifier: MIT
// Vectors, rotations, transforms: plain floats, by value, no handedness. Only + - * / and sqrt, in a fixed order.
#ifndef SOLE_MATH_H
#define SOLE_MATH_H

#include "sole/base.h"

#include <math.h>

/// A point, a direction or a scale. No alignment beyond that of float.
typedef struct soleVec3
{
	float x, y, z;
} soleVec3;

/// A rotation. Unit length. Hamilton product; x, y, z, w as in glTF, ozz and Unity.
typedef struct soleQuat
{
	float x, y, z, w;
} soleQuat;

/// First scale, then rotation, then translation, as in glTF. The scale of a joint reaches its children component by
/// component along their parents' axes: exact for uniform scales.
typedef struct soleTransform
{
	soleVec3 translation;
	soleQuat rotation;
	soleVec3 scale;
} soleTransform;

static inline soleVec3 soleVec( float x, float y, float z )
{
	soleVec3 v = { x, y, z };
	return v;
}

static inline soleQuat soleQuat_Identity( void )
{
	soleQuat q = { 0.0f, 0.0f, 0.0f, 1.0f };
	return q;
}

static inline soleTransform soleTransform_Identity( void )
{
	soleTransform t = { { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f, 1.0f }, { 1.0f, 1.0f, 1.0f } };
	return t;
}

static inline float soleMinF( float a, float b )
{
	return a < b ? a : b;
}

static inline float soleMaxF( float a, float b )
{
	return a > b ? a : b;
}

static inline float soleClampF( float x, float low, float high )
{
	return x < low ? low : ( x > high ? high : x );
}

/// Square root of the non-negative part.
static inline float soleSqrtF( float x )
{
	return sqrtf( x > 0.0f ? x : 0.0f );
}

static inline soleVec3 soleAdd( soleVec3 a, soleVec3 b )
{
	return soleVec( a.x + b.x, a.y + b.y, a.z + b.z );
}

static inline soleVec3 soleSub( soleVec3 a, soleVec3 b )
{
	return soleVec( a.x - b.x, a.y - b.y, a.z - b.z );
}

static inline soleVec3 soleMul( soleVec3 a, soleVec3 b )
{
	return soleVec( a.x * b.x, a.y * b.y, a.z * b.z );
}

static inline soleVec3 soleScale( float s, soleVec3 v )
{
	return soleVec( s * v.x, s * v.y, s * v.z );
}

static inline soleVec3 soleNeg( soleVec3 v )
{
	return soleVec( -v.x, -v.y, -v.z );
}

/// a + s b
static inline soleVec3 soleMulAdd( soleVec3 a, float s, soleVec3 b )
{
	return soleVec( a.x + s * b.x, a.y + s * b.y, a.z + s * b.z );
}

/// a at 0, b at 1
static inline soleVec3 soleLerp( soleVec3 a, soleVec3 b, float t )
{
	return soleMulAdd( a, t, soleSub( b, a ) );
}

static inline float soleDot( soleVec3 a, soleVec3 b )
{
	return ( a.x * b.x + a.y * b.y ) + a.z * b.z;
}

static inline soleVec3 soleCross( soleVec3 a, soleVec3 b )
{
	return soleVec( a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x );
}

static inline float soleLength( soleVec3 v )
{
	return sqrtf( soleDot( v, v ) );
}

static inline float soleDistance( soleVec3 a, soleVec3 b )
{
	return soleLength( soleSub( a, b ) );
}

/// The unit vector along v, or the fallback where v is shorter than 1e-6 or not finite.
static inline soleVec3 soleNormalizeOr( soleVec3 v, soleVec3 fallback )
{
	float squared = soleDot( v, v );
	if ( !( squared >= 1e-12f ) || !( squared <= 3e38f ) )
	{
		return fallback;
	}
	return soleScale( 1.0f / sqrtf( squared ), v );
}

/// v without its part along the unit vector n.
static inline soleVec3 soleReject( soleVec3 v, soleVec3 n )
{
	return soleMulAdd( v, -soleDot( v, n ), n );
}

/// A unit vector orthogonal to the unit vector n, the same one every time.
static inline soleVec3 soleAnyOrthogonal( soleVec3 n )
{
	soleVec3 axis = n.x * n.x < 0.5f ? soleVec( 1.0f, 0.0f, 0.0f ) : soleVec( 0.0f, 1.0f, 0.0f );
	return soleNormalizeOr( soleReject( axis, n ), soleVec( 0.0f, 0.0f, 1.0f ) );
}

static inline soleQuat soleConjugate( soleQuat q )
{
	soleQuat r = { -q.x, -q.y, -q.z, q.w };
	return r;
}

static inline soleQuat soleNegQuat( soleQuat q )
{
	soleQuat r = { -q.x, -q.y, -q.z, -q.w };
	return r;
}

/// First b, then a.
static inline soleQuat soleMulQuat( soleQuat a, soleQuat b )
{
	soleQuat q = {
		( a.w * b.x + a.x * b.w ) + ( a.y * b.z - a.z * b.y ),
		( a.w * b.y + a.y * b.w ) + ( a.z * b.x - a.x * b.z ),
		( a.w * b.z + a.z * b.w ) + ( a.x * b.y - a.y * b.x ),
		( a.w * b.w - a.x * b.x ) - ( a.y * b.y + a.z * b.z ),
	};
	return q;
}

static inline float soleDotQuat( soleQuat a, soleQuat b )
{
	return ( a.x * b.x + a.y * b.y ) + ( a.z * b.z + a.w * b.w );
}

/// Unit length, or identity where q is shorter than 1e-6 or not finite.
static inline soleQuat soleNormalizeQuat( soleQuat q )
{
	float squared = soleDotQuat( q, q );
	if ( !( squared >= 1e-12f ) || !( squared <= 3e38f ) )
	{
		return soleQuat_Identity();
	}
	float s = 1.0f / sqrtf( squared );
	soleQuat r = { s * q.x, s * q.y, s * q.z, s * q.w };
	return r;
}

/// v + 2 w ( u x v ) + 2 u x ( u x v ), u = q.xyz
static inline soleVec3 soleRotate( soleQuat q, soleVec3 v )
{
	soleVec3 u = { q.x, q.y, q.z };
	soleVec3 t = soleScale( 2.0f, soleCross( u, v ) );
	return soleAdd( soleMulAdd( v, q.w, t ), soleCross( u, t ) );
}

static inline soleVec3 soleInvRotate( soleQuat q, soleVec3 v )
{
	return soleRotate( soleConjugate( q ), v );
}

/// The normalised chord from a to b on the near side: fraction 0 is a, 1 is b.
static inline soleQuat soleNlerp( soleQuat a, soleQuat b, float fraction )
{
	float t = soleDotQuat( a, b ) < 0.0f ? -fraction : fraction;
	float s = 1.0f - fraction;
	soleQuat q = { s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z, s * a.w + t * b.w };
	return soleNormalizeQuat( q );
}

/// The shortest rotation from one unit vector to another. Where they are opposite: half a turn about halfTurnAxis made
/// orthogonal to from, or about a fixed orthogonal axis where that is impossible.
static inline soleQuat soleFromTo( soleVec3 from, soleVec3 to, soleVec3 halfTurnAxis )
{
	// 1 + cos of the angle, without the cancellation of that sum near half a turn.
	soleVec3 sum = soleAdd( from, to );
	float w = 0.5f * soleDot( sum, sum );
	if ( w < 1e-6f )
	{
		soleVec3 n = soleNormalizeOr( soleReject( halfTurnAxis, from ), soleAnyOrthogonal( from ) );
		soleQuat half = { n.x, n.y, n.z, 0.0f };
		return half;
	}
	soleVec3 c = soleCross( from, to );
	soleQuat q = { c.x, c.y, c.z, w };
	return soleNormalizeQuat( q );
}

/// Where a point given in a child's space is in its parent's.
static inline soleVec3 soleTransformPoint( soleTransform t, soleVec3 p )
{
	return soleAdd( soleRotate( t.rotation, soleMul( t.scale, p ) ), t.translation );
}

/// Undoes soleTransformPoint. A scale of zero leaves that component at zero.
static inline soleVec3 soleInvTransformPoint( soleTransform t, soleVec3 p )
{
	soleVec3 v = soleInvRotate( t.rotation, soleSub( p, t.translation ) );
	v.x = t.scale.x != 0.0f ? v.x / t.scale.x : 0.0f;
	v.y = t.scale.y != 0.0f ? v.y / t.scale.y : 0.0f;
	v.z = t.scale.z != 0.0f ? v.z / t.scale.z : 0.0f;
	return v;
}

/// The child's transform in the space of the parent's parent.
static inline soleTransform soleMulTransform( soleTransform parent, soleTransform child )
{
	soleTransform t = {
		soleTransformPoint( parent, child.translation ),
		soleMulQuat( parent.rotation, child.rotation ),
		soleMul( parent.scale, child.scale ),
	};
	return t;
}

static inline bool soleIsFinite( float x )
{
	return x - x == 0.0f;
}

static inline bool soleVec3_IsFinite( soleVec3 v )
{
	// Of what is not finite the difference from itself is no number, and that spreads.
	return ( ( v.x - v.x ) + ( v.y - v.y ) ) + ( v.z - v.z ) == 0.0f;
}

static inline bool soleQuat_IsFinite( soleQuat q )
{
	return ( ( q.x - q.x ) + ( q.y - q.y ) ) + ( ( q.z - q.z ) + ( q.w - q.w ) ) == 0.0f;
}

#endif
