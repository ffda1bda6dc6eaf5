// SPDX-License-Identifier: MIT
// All operations of base/simd.h over two arrays, in the width that is set. Included once for each width.
#ifndef TEST_SIMD_KERNEL_H
#define TEST_SIMD_KERNEL_H

enum
{
	testSimdOutputs = 8,
	testSimdMost = 4096
};

typedef struct testSimdResult
{
	float floats[testSimdOutputs][testSimdMost];
	uint32_t bits[testSimdMost]; // a < b, a word for each step
} testSimdResult;

#endif

static inline void SOLE_WIDE_NAME( testSimdKernel )(
    const float* a, const float* b, int32_t count, testSimdResult* result )
{
	for ( int32_t i = 0; i < count; i += SOLE_WIDTH )
	{
		soleWide x = soleWide_Load( a + i );
		soleWide y = soleWide_Load( b + i );
		soleWideMask less = soleWide_Less( x, y );
		soleWideMask either = soleWide_Or( less, soleWide_Less( y, x ) );
		soleWide_Store( result->floats[0] + i, soleWide_Add( x, y ) );
		soleWide_Store( result->floats[1] + i, soleWide_Sub( x, y ) );
		soleWide_Store( result->floats[2] + i, soleWide_Mul( x, y ) );
		soleWide_Store( result->floats[3] + i, soleWide_Div( x, y ) );
		soleWide_Store( result->floats[4] + i, soleWide_Sqrt( x ) );
		soleWide_Store( result->floats[5] + i, soleWide_Min( x, y ) );
		soleWide_Store( result->floats[6] + i, soleWide_Max( x, y ) );
		soleWide_Store( result->floats[7] + i, soleWide_Select( soleWide_And( less, either ), x, y ) );
		result->bits[i / SOLE_WIDTH] = soleWide_GetBits( less );
	}
}
