// SPDX-License-Identifier: MIT
// Many floats at once: every lane of every width is what one float gives, to the bit, whatever numbers it is given.
#include "test.h"

#define SOLE_WIDTH 4
#include "base/simd.h"
#include "simd_kernel.h"
#undef SOLE_WIDTH

#define SOLE_WIDTH 8
SOLE_BEGIN_AVX2
#include "base/simd.h"
#include "simd_kernel.h"
SOLE_END_TARGET
#undef SOLE_WIDTH

#define SOLE_WIDTH 16
SOLE_BEGIN_AVX512
#include "base/simd.h"
#include "simd_kernel.h"
SOLE_END_TARGET
#undef SOLE_WIDTH

// The specification: lanes one by one.
#undef SOLE_SIMD_SCALAR
#define SOLE_SIMD_SCALAR 1
#define SOLE_WIDTH 4
#include "base/simd.h"
#include "simd_kernel.h"

#define COUNT 4096 // of each input

typedef void kernel( const float* a, const float* b, int32_t count, testSimdResult* result );

/// Numbers of every kind: ordinary, huge, tiny, zeros of both signs, infinite, none.
static float anyFloat( uint32_t* seed )
{
	static const float odd[] = { 0.0f, -0.0f, INFINITY, -INFINITY, NAN, 1e-40f, -1e-40f, 3e38f, 1.0f };
	if ( testRandom( seed ) % 4 != 0 )
	{
		return testRandomFloat( seed, -100.0f, 100.0f );
	}
	return odd[testRandom( seed ) % ( sizeof odd / sizeof *odd )];
}

/// The same bits, but that one number that is none is as good as another.
static void assertSameFloats( const float* a, const float* b, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		bool none = a[i] != a[i] && b[i] != b[i];
		if ( none == false && memcmp( a + i, b + i, sizeof *a ) != 0 )
		{
			fail_msg( "lane %d: %a and %a", i, (double)a[i], (double)b[i] );
		}
	}
}

static void compareWithPlain( kernel* wide, int width )
{
	static float a[COUNT];
	static float b[COUNT];
	uint32_t seed = 7;
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		a[i] = anyFloat( &seed );
		b[i] = anyFloat( &seed );
	}
	static testSimdResult plain;
	static testSimdResult result;
	testSimdKernel4Plain( a, b, COUNT, &plain );
	wide( a, b, COUNT, &result );
	for ( int k = 0; k < testSimdOutputs; ++k )
	{
		assertSameFloats( plain.floats[k], result.floats[k], COUNT );
	}
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		uint32_t one = plain.bits[i / 4] >> i % 4 & 1u;
		uint32_t other = result.bits[i / width] >> i % width & 1u;
		assert_int_equal( one, other );
	}
}

static void everyLaneOfWidth4IsOneFloat( void** state )
{
	(void)state;
	compareWithPlain( testSimdKernel4, 4 );
}

static void everyLaneOfWidth8IsOneFloat( void** state )
{
	(void)state;
	if ( SOLE_X86 && soleGetSimdWidth() < 8 )
	{
		print_message( "left out: this machine has no AVX2\n" );
		skip();
	}
	compareWithPlain( testSimdKernel8, 8 );
}

static void everyLaneOfWidth16IsOneFloat( void** state )
{
	(void)state;
	if ( SOLE_X86 && soleGetSimdWidth() < 16 )
	{
		print_message( "left out: this machine has no AVX-512\n" );
		skip();
	}
	compareWithPlain( testSimdKernel16, 16 );
}

static void thePlainFormIsWhatIsWrittenDown( void** state )
{
	(void)state;
	static testSimdResult plain;
	const float a[4] = { 1.0f, 9.0f, -3.0f, NAN };
	const float b[4] = { 2.0f, 4.0f, -3.0f, 1.0f };
	testSimdKernel4Plain( a, b, 4, &plain );
	const float expected[testSimdOutputs][3] = { { 3.0f, 13.0f, -6.0f }, { -1.0f, 5.0f, 0.0f }, { 2.0f, 36.0f, 9.0f },
		{ 0.5f, 2.25f, 1.0f }, { 1.0f, 3.0f, 0.0f }, { 1.0f, 4.0f, -3.0f }, { 2.0f, 9.0f, -3.0f },
		{ 1.0f, 4.0f, -3.0f } };
	for ( int k = 0; k < testSimdOutputs; ++k )
	{
		for ( int i = 0; i < 3; ++i )
		{
			if ( k != 4 || i != 2 ) // the root of -3 is no number
			{
				assert_float_equal( plain.floats[k][i], expected[k][i], 0.0f );
			}
		}
	}
	// A comparison with no number is false: the second is taken.
	assert_float_equal( plain.floats[5][3], 1.0f, 0.0f );
	assert_float_equal( plain.floats[6][3], 1.0f, 0.0f );
	assert_int_equal( plain.bits[0], 1 );
	assert_int_equal( soleGetLowestBit( 40u ), 3 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( thePlainFormIsWhatIsWrittenDown ),
		cmocka_unit_test( everyLaneOfWidth4IsOneFloat ),
		cmocka_unit_test( everyLaneOfWidth8IsOneFloat ),
		cmocka_unit_test( everyLaneOfWidth16IsOneFloat ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
