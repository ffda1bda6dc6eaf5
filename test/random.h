// SPDX-License-Identifier: MIT
// The same numbers in every run, on every machine.
#ifndef TEST_RANDOM_H
#define TEST_RANDOM_H

#include "sole/math.h"

#include <stdint.h>

/// Xorshift of 32 bits. A seed is not zero.
static inline uint32_t testRandom( uint32_t* seed )
{
	uint32_t x = *seed;
	x ^= x << 13;
	x ^= x >> 17;
	x ^= x << 5;
	*seed = x;
	return x;
}

/// Between low and high.
static inline float testRandomFloat( uint32_t* seed, float low, float high )
{
	return low + ( high - low ) * ( (float)( testRandom( seed ) >> 8 ) / 16777216.0f );
}

/// In a cube about the origin. One number after the other: the order of arguments is the compiler's own.
static inline soleVec3 testRandomPoint( uint32_t* seed, float size )
{
	soleVec3 p;
	p.x = testRandomFloat( seed, -size, size );
	p.y = testRandomFloat( seed, -size, size );
	p.z = testRandomFloat( seed, -size, size );
	return p;
}

/// Unit.
static inline soleVec3 testRandomDirection( uint32_t* seed )
{
	soleVec3 d = testRandomPoint( seed, 1.0f );
	while ( soleDot( d, d ) > 1.0f || soleDot( d, d ) < 0.01f )
	{
		d = testRandomPoint( seed, 1.0f );
	}
	return soleNormalizeOr( d, soleVec( 0.0f, -1.0f, 0.0f ) );
}

/// Unit.
static inline soleQuat testRandomTurn( uint32_t* seed )
{
	soleVec3 v = testRandomPoint( seed, 1.0f );
	soleQuat q = { v.x, v.y, v.z, testRandomFloat( seed, -1.0f, 1.0f ) };
	return soleNormalizeQuat( q );
}

#endif
