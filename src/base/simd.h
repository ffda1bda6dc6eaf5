// SPDX-License-Identifier: MIT
// Many floats at once: 4, 8 or 16 lanes, each computed as one float would be, to the bit. Only + - * / and sqrt; no
// fused operation, no estimate. Kernels are written once against `soleWide`, which is as wide as SOLE_WIDTH says when
// this file is included; a file that needs several widths includes its kernel several times:
//   #define SOLE_WIDTH 4
//   #include "base/simd.h"
//   #include "place/some_kernel.h" // soleWide is soleWide4; its functions are named with SOLE_WIDE_NAME( f ): f4
//   #undef SOLE_WIDTH
//   #define SOLE_WIDTH 8
//   SOLE_BEGIN_AVX2
//   #include "base/simd.h"
//   #include "place/some_kernel.h"
//   SOLE_END_TARGET
// and picks one at run time by soleGetSimdWidth(): a build for plain SSE2 so reaches AVX2 and AVX-512 machines without
// flags for single files. Width 4 needs no target: SSE2, NEON and simd128 have it.
//
// Where the compiler knows vectors (gcc, clang) the operators are its own; elsewhere, or with SOLE_SIMD_SCALAR 1, lanes
// are taken one by one. That plain form is the specification: a test compares all lanes of all widths with it.
#if !defined( SOLE_WIDTH ) || ( SOLE_WIDTH != 4 && SOLE_WIDTH != 8 && SOLE_WIDTH != 16 )
#error "define SOLE_WIDTH as 4, 8 or 16 before base/simd.h is included"
#endif

#ifndef SOLE_BASE_SIMD_H
#define SOLE_BASE_SIMD_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SOLE_SIMD_SCALAR
#define SOLE_SIMD_SCALAR 0
#endif

// Widths 8 and 16 with instructions for them: gcc and clang on x86-64.
#if defined( __GNUC__ ) && defined( __x86_64__ )
#define SOLE_X86 1
#include <immintrin.h>
#else
#define SOLE_X86 0
#endif

// Lanes are handed on in registers only where there is no call: compilers give up on that in long files.
#if defined( __GNUC__ )
#define SOLE_INLINE static inline __attribute__( ( always_inline ) )
#else
#define SOLE_INLINE static inline
#endif

#define SOLE_PRAGMA( text ) _Pragma( #text )
#if SOLE_X86 && defined( __clang__ )
#pragma STDC FP_CONTRACT OFF
#define SOLE_BEGIN_AVX2                                                                                                \
	SOLE_PRAGMA( clang attribute push( __attribute__( ( target( "avx2" ) ) ), apply_to = function ) )
#define SOLE_BEGIN_AVX512                                                                                              \
	SOLE_PRAGMA( clang attribute push( __attribute__( ( target( "avx512f" ) ) ), apply_to = function ) )
#define SOLE_END_TARGET SOLE_PRAGMA( clang attribute pop )
#elif SOLE_X86
#define SOLE_BEGIN_AVX2 SOLE_PRAGMA( GCC push_options ) SOLE_PRAGMA( GCC target( "avx2" ) )
#define SOLE_BEGIN_AVX512 SOLE_PRAGMA( GCC push_options ) SOLE_PRAGMA( GCC target( "avx512f" ) )
#define SOLE_END_TARGET SOLE_PRAGMA( GCC pop_options )
#else
#define SOLE_BEGIN_AVX2
#define SOLE_BEGIN_AVX512
#define SOLE_END_TARGET
#endif

#define SOLE_JOIN_NOW( a, b ) a##b
#define SOLE_JOIN( a, b ) SOLE_JOIN_NOW( a, b )

/// How many lanes this machine has instructions for.
static inline int soleGetSimdWidth( void )
{
#if SOLE_X86
	__builtin_cpu_init();
	return __builtin_cpu_supports( "avx512f" ) ? 16 : ( __builtin_cpu_supports( "avx2" ) ? 8 : 4 );
#else
	return 4;
#endif
}

/// The number of the lowest bit that is set. bits is not zero.
static inline uint32_t soleGetLowestBit( uint32_t bits )
{
#if defined( __GNUC__ )
	return (uint32_t)__builtin_ctz( bits );
#else
	uint32_t number = 0;
	while ( ( bits >> number & 1u ) == 0 )
	{
		number += 1;
	}
	return number;
#endif
}

#endif // once; what follows is made for each width

#undef SOLE_WIDE_NAME
#if SOLE_SIMD_SCALAR
#define SOLE_WIDE_NAME( name ) SOLE_JOIN( SOLE_JOIN( name, SOLE_WIDTH ), Plain )
#else
#define SOLE_WIDE_NAME( name ) SOLE_JOIN( name, SOLE_WIDTH )
#endif

#undef soleWide
#undef soleWideMask
#undef soleWide_Load
#undef soleWide_Store
#undef soleWide_Set
#undef soleWide_Add
#undef soleWide_Sub
#undef soleWide_Mul
#undef soleWide_Div
#undef soleWide_Sqrt
#undef soleWide_Min
#undef soleWide_Max
#undef soleWide_Less
#undef soleWide_And
#undef soleWide_Or
#undef soleWide_Select
#undef soleWide_GetBits
#define soleWide SOLE_WIDE_NAME( soleWide )
#define soleWideMask SOLE_WIDE_NAME( soleWideMask )
#define soleWide_Load SOLE_WIDE_NAME( soleWide_Load )
#define soleWide_Store SOLE_WIDE_NAME( soleWide_Store )
#define soleWide_Set SOLE_WIDE_NAME( soleWide_Set )
#define soleWide_Add SOLE_WIDE_NAME( soleWide_Add )
#define soleWide_Sub SOLE_WIDE_NAME( soleWide_Sub )
#define soleWide_Mul SOLE_WIDE_NAME( soleWide_Mul )
#define soleWide_Div SOLE_WIDE_NAME( soleWide_Div )
#define soleWide_Sqrt SOLE_WIDE_NAME( soleWide_Sqrt )
#define soleWide_Min SOLE_WIDE_NAME( soleWide_Min )
#define soleWide_Max SOLE_WIDE_NAME( soleWide_Max )
#define soleWide_Less SOLE_WIDE_NAME( soleWide_Less )
#define soleWide_And SOLE_WIDE_NAME( soleWide_And )
#define soleWide_Or SOLE_WIDE_NAME( soleWide_Or )
#define soleWide_Select SOLE_WIDE_NAME( soleWide_Select )
#define soleWide_GetBits SOLE_WIDE_NAME( soleWide_GetBits )

#if defined( __GNUC__ ) && SOLE_SIMD_SCALAR == 0

typedef float soleWide __attribute__( ( vector_size( 4 * SOLE_WIDTH ) ) );
#if SOLE_X86 && SOLE_WIDTH == 16
#define SOLE_WIDE_LESS( a, b ) _mm512_cmp_ps_mask( a, b, _CMP_LT_OS )
#define SOLE_WIDE_SELECT( mask, a, b ) _mm512_mask_blend_ps( mask, b, a )
/// A bit for each lane: these machines keep masks apart from vectors.
typedef uint16_t soleWideMask;
#else
#define SOLE_WIDE_LESS( a, b ) ( ( a ) < ( b ) )
#define SOLE_WIDE_SELECT( mask, a, b )                                                                                 \
	( soleWide )( ( ( mask ) & (soleWideMask)( a ) ) | ( ~( mask ) & (soleWideMask)( b ) ) )
/// All bits of a lane are set, or none.
typedef int32_t soleWideMask __attribute__( ( vector_size( 4 * SOLE_WIDTH ) ) );
#endif

static inline soleWide soleWide_Add( soleWide a, soleWide b )
{
	return a + b;
}

static inline soleWide soleWide_Sub( soleWide a, soleWide b )
{
	return a - b;
}

static inline soleWide soleWide_Mul( soleWide a, soleWide b )
{
	return a * b;
}

static inline soleWide soleWide_Div( soleWide a, soleWide b )
{
	return a / b;
}

static inline soleWideMask soleWide_Less( soleWide a, soleWide b )
{
	return SOLE_WIDE_LESS( a, b );
}

static inline soleWideMask soleWide_And( soleWideMask a, soleWideMask b )
{
	return (soleWideMask)( a & b );
}

static inline soleWideMask soleWide_Or( soleWideMask a, soleWideMask b )
{
	return (soleWideMask)( a | b );
}

/// a where the mask is set, else b.
static inline soleWide soleWide_Select( soleWideMask mask, soleWide a, soleWide b )
{
	return SOLE_WIDE_SELECT( mask, a, b );
}

#undef SOLE_WIDE_LESS
#undef SOLE_WIDE_SELECT
#else

typedef struct soleWide
{
	float lanes[SOLE_WIDTH];
} soleWide;

/// 1 in a lane, or 0.
typedef struct soleWideMask
{
	int32_t lanes[SOLE_WIDTH];
} soleWideMask;

#define SOLE_FOR_LANES( type, expression )                                                                             \
	type result;                                                                                                       \
	for ( int i = 0; i < SOLE_WIDTH; ++i )                                                                             \
	{                                                                                                                  \
		result.lanes[i] = expression;                                                                                  \
	}                                                                                                                  \
	return result

static inline soleWide soleWide_Add( soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWide, a.lanes[i] + b.lanes[i] );
}

static inline soleWide soleWide_Sub( soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWide, a.lanes[i] - b.lanes[i] );
}

static inline soleWide soleWide_Mul( soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWide, a.lanes[i] * b.lanes[i] );
}

static inline soleWide soleWide_Div( soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWide, a.lanes[i] / b.lanes[i] );
}

static inline soleWideMask soleWide_Less( soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWideMask, a.lanes[i] < b.lanes[i] ? 1 : 0 );
}

static inline soleWideMask soleWide_And( soleWideMask a, soleWideMask b )
{
	SOLE_FOR_LANES( soleWideMask, a.lanes[i] & b.lanes[i] );
}

static inline soleWideMask soleWide_Or( soleWideMask a, soleWideMask b )
{
	SOLE_FOR_LANES( soleWideMask, a.lanes[i] | b.lanes[i] );
}

static inline soleWide soleWide_Select( soleWideMask mask, soleWide a, soleWide b )
{
	SOLE_FOR_LANES( soleWide, mask.lanes[i] != 0 ? a.lanes[i] : b.lanes[i] );
}

#undef SOLE_FOR_LANES
#endif

/// From any address that a float may have.
static inline soleWide soleWide_Load( const float* p )
{
	soleWide a;
	memcpy( &a, p, sizeof a );
	return a;
}

static inline void soleWide_Store( float* p, soleWide a )
{
	memcpy( p, &a, sizeof a );
}

static inline soleWide soleWide_Set( float x )
{
	float lanes[SOLE_WIDTH];
	for ( int i = 0; i < SOLE_WIDTH; ++i )
	{
		lanes[i] = x;
	}
	return soleWide_Load( lanes );
}

// Square root, least, most (a < b ? a : b and a > b ? a : b, which is what SSE does) and the lanes of a mask as bits,
// the first lowest, where there are instructions for them.
#if SOLE_X86 && SOLE_SIMD_SCALAR == 0 && SOLE_WIDTH == 4
#define SOLE_WIDE_SQRT( a ) _mm_sqrt_ps( a )
#define SOLE_WIDE_MIN( a, b ) _mm_min_ps( a, b )
#define SOLE_WIDE_MAX( a, b ) _mm_max_ps( a, b )
#define SOLE_WIDE_BITS( mask ) _mm_movemask_ps( (__m128)( mask ) )
#elif SOLE_X86 && SOLE_SIMD_SCALAR == 0 && SOLE_WIDTH == 8
#define SOLE_WIDE_SQRT( a ) _mm256_sqrt_ps( a )
#define SOLE_WIDE_MIN( a, b ) _mm256_min_ps( a, b )
#define SOLE_WIDE_MAX( a, b ) _mm256_max_ps( a, b )
#define SOLE_WIDE_BITS( mask ) _mm256_movemask_ps( (__m256)( mask ) )
#elif SOLE_X86 && SOLE_SIMD_SCALAR == 0 && SOLE_WIDTH == 16
#define SOLE_WIDE_SQRT( a ) _mm512_sqrt_ps( a )
#define SOLE_WIDE_MIN( a, b ) _mm512_min_ps( a, b )
#define SOLE_WIDE_MAX( a, b ) _mm512_max_ps( a, b )
#define SOLE_WIDE_BITS( mask ) ( mask )
#endif

static inline soleWide soleWide_Sqrt( soleWide a )
{
#ifdef SOLE_WIDE_SQRT
	return SOLE_WIDE_SQRT( a );
#else
	float lanes[SOLE_WIDTH];
	soleWide_Store( lanes, a );
	for ( int i = 0; i < SOLE_WIDTH; ++i )
	{
		lanes[i] = sqrtf( lanes[i] );
	}
	return soleWide_Load( lanes );
#endif
}

static inline soleWide soleWide_Min( soleWide a, soleWide b )
{
#ifdef SOLE_WIDE_MIN
	return SOLE_WIDE_MIN( a, b );
#else
	return soleWide_Select( soleWide_Less( a, b ), a, b );
#endif
}

static inline soleWide soleWide_Max( soleWide a, soleWide b )
{
#ifdef SOLE_WIDE_MAX
	return SOLE_WIDE_MAX( a, b );
#else
	return soleWide_Select( soleWide_Less( b, a ), a, b );
#endif
}

static inline uint32_t soleWide_GetBits( soleWideMask mask )
{
#ifdef SOLE_WIDE_BITS
	return (uint32_t)SOLE_WIDE_BITS( mask );
#else
	int32_t lanes[SOLE_WIDTH];
	memcpy( lanes, &mask, sizeof lanes );
	uint32_t bits = 0;
	for ( int i = 0; i < SOLE_WIDTH; ++i )
	{
		bits |= lanes[i] != 0 ? 1u << i : 0u;
	}
	return bits;
#endif
}

#undef SOLE_WIDE_SQRT
#undef SOLE_WIDE_MIN
#undef SOLE_WIDE_MAX
#undef SOLE_WIDE_BITS
