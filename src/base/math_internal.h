// SPDX-License-Identifier: MIT
// Rotations without trigonometry: angles are kept as cosine and sine of their halves. Only + - * / and sqrt, in a
// fixed order, so that every compiler gives the same bits. Formulas: half-angle identities and the Hamilton product.
#ifndef SOLE_BASE_MATH_INTERNAL_H
#define SOLE_BASE_MATH_INTERNAL_H

#include "sole/math.h"

#include <string.h>

/// Cosine and sine of half of an angle.
typedef struct soleHalf
{
	float c;
	float s;
} soleHalf;

/// From cosine and sine of the whole angle, in any common positive scale. c >= 0. Half a turn where both vanish in sum:
/// the sine then decides the side, zero counting as positive.
static inline soleHalf soleMakeHalf( float cosine, float sine )
{
	float length = soleSqrtF( cosine * cosine + sine * sine );
	if ( !( length >= 1e-20f ) )
	{
		return ( soleHalf ){ 1.0f, 0.0f };
	}
	float c = 1.0f + cosine / length;
	float s = sine / length;
	if ( c < 1e-6f )
	{
		return ( soleHalf ){ 0.0f, s < 0.0f ? -1.0f : 1.0f };
	}
	float scale = 1.0f / sqrtf( c * c + s * s );
	return ( soleHalf ){ scale * c, scale * s };
}

/// The half of a - b.
static inline soleHalf soleSubHalf( soleHalf a, soleHalf b )
{
	return ( soleHalf ){ a.c * b.c + a.s * b.s, a.s * b.c - a.c * b.s };
}

/// The rotation by that angle about a unit axis.
static inline soleQuat soleHalfRotation( soleVec3 axis, soleHalf half )
{
	return ( soleQuat ){ half.s * axis.x, half.s * axis.y, half.s * axis.z, half.c };
}

/// The part of q about a unit axis. Identity where q turns half way round an orthogonal one.
static inline soleQuat soleTwist( soleQuat q, soleVec3 axis )
{
	float d = ( q.x * axis.x + q.y * axis.y ) + q.z * axis.z;
	return soleNormalizeQuat( ( soleQuat ){ d * axis.x, d * axis.y, d * axis.z, q.w } );
}

/// The half angle of a rotation that is known to be about a unit axis; cosine not below zero.
static inline soleHalf soleTwistHalf( soleQuat twist, soleVec3 axis )
{
	float s = ( twist.x * axis.x + twist.y * axis.y ) + twist.z * axis.z;
	return twist.w < 0.0f ? ( soleHalf ){ -twist.w, -s } : ( soleHalf ){ twist.w, s };
}

/// tan of a quarter of the angle, signed: the form in which rotation offsets decay. [-1, 1]
static inline float soleQuarterTan( soleHalf half )
{
	return half.c < 0.0f ? -half.s / ( 1.0f - half.c ) : half.s / ( 1.0f + half.c );
}

static inline soleHalf soleHalfFromQuarterTan( float r )
{
	float scale = 1.0f / ( 1.0f + r * r );
	return ( soleHalf ){ ( 1.0f - r * r ) * scale, 2.0f * r * scale };
}

/// Sine and cosine of half of an angle in radians, for settings. |angle| is clamped to pi. Taylor series of the quarter
/// angle, doubled: error below 1e-6.
static inline soleHalf soleHalfFromAngle( float angle )
{
	float x = 0.25f * soleClampF( angle, -3.14159265f, 3.14159265f );
	float z = x * x;
	float s = x * ( 1.0f - z * ( 1.0f / 6.0f - z * ( 1.0f / 120.0f - z * ( 1.0f / 5040.0f ) ) ) );
	float c = 1.0f - z * ( 0.5f - z * ( 1.0f / 24.0f - z * ( 1.0f / 720.0f - z * ( 1.0f / 40320.0f ) ) ) );
	return ( soleHalf ){ c * c - s * s, 2.0f * s * c };
}

/// exp( -x ) for x >= 0: halved until small, a rational form of fourth order, squared back. Absolute error 2e-7.
static inline float soleExpNegative( float x )
{
	if ( !( x > 0.0f ) )
	{
		return 1.0f;
	}
	if ( x >= 20.0f )
	{
		return 0.0f;
	}
	int halvings = 0;
	while ( x > 0.5f )
	{
		x *= 0.5f;
		++halvings;
	}
	float z = x * x;
	float even = 1.0f + z * 0.1f;
	float odd = x * ( 0.5f + z * ( 1.0f / 120.0f ) );
	float r = ( even - odd ) / ( even + odd );
	for ( int i = 0; i < halvings; ++i )
	{
		r *= r;
	}
	return r;
}

/// What is left, after a time, of a value that loses half of itself in each half-life. 0: it is gone at once.
static inline float soleLeftAfter( float time, float halfLife )
{
	const float ln2 = 0.6931472f;
	return halfLife > 0.0f ? soleExpNegative( ln2 * time / halfLife ) : 0.0f;
}

/// Floats that lie one after the other: none is infinite or no number.
static inline bool soleAreFinite( const void* floats, size_t byteCount )
{
	// Their exponents are all ones: one more carries into the sign.
	const uint32_t exponent = 0x7f800000u;
	const uint32_t one = 0x00800000u;
	uint32_t carried = 0;
	for ( size_t i = 0; i < byteCount; i += sizeof( float ) )
	{
		uint32_t bits;
		memcpy( &bits, (const char*)floats + i, sizeof bits );
		carried |= ( bits & exponent ) + one;
	}
	return carried >> 31 == 0;
}

static inline float soleSaturate( float x )
{
	return soleClampF( x, 0.0f, 1.0f );
}

/// x where it is finite, else the fallback.
static inline float soleFiniteOr( float x, float fallback )
{
	return soleIsFinite( x ) ? x : fallback;
}

#endif
