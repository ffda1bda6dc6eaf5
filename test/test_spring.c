// SPDX-License-Identifier: MIT
// Springs and half angles against double precision.
#include "test.h"

#include "base/math_internal.h"
#include "base/spring.h"
#include "sole/sole.h"

static void expNegativeIsExactToTwoParts( void** state )
{
	(void)state;
	double worst = 0.0;
	for ( int i = 0; i <= 100000; ++i )
	{
		float x = 25.0f * (float)i / 100000.0f;
		double error = fabs( (double)soleExpNegative( x ) - exp( -(double)x ) );
		worst = error > worst ? error : worst;
	}
	assert_true( worst < 3e-7 );
	assert_true( soleExpNegative( NAN ) == 1.0f && soleExpNegative( -1.0f ) == 1.0f );
	assert_true( soleExpNegative( INFINITY ) == 0.0f );
}

static void halfOfARestingErrorIsLeftAfterTheHalfLife( void** state )
{
	(void)state;
	for ( int i = 1; i <= 20; ++i )
	{
		float h = 0.05f * (float)i;
		soleOffset1 s = soleStepSpring( ( soleOffset1 ){ 1.0f, 0.0f }, 0.0f, 0.0f, h, h );
		assert_float_equal( s.value, 0.5f, 1e-5f );
	}
}

static void manySmallStepsMakeOneLarge( void** state )
{
	(void)state;
	for ( int n = 1; n <= 144; n *= 3 )
	{
		soleOffset1 s = { 0.3f, -2.0f };
		for ( int i = 0; i < n; ++i )
		{
			float before = (float)i / (float)n;
			s = soleStepSpring( s, 1.0f + 0.5f * before * 0.2f, 0.5f, 0.08f, 0.2f / (float)n );
		}
		soleOffset1 once = soleStepSpring( ( soleOffset1 ){ 0.3f, -2.0f }, 1.0f, 0.5f, 0.08f, 0.2f );
		assert_float_equal( s.value, once.value, 1e-5f );
		assert_float_equal( s.velocity, once.velocity, 1e-4f );
	}
}

static void movingGoalIsFollowedWithoutLag( void** state )
{
	(void)state;
	soleOffset1 s = { 0.0f, 2.0f };
	for ( int i = 0; i < 100; ++i )
	{
		s = soleStepSpring( s, 2.0f * (float)i / 60.0f, 2.0f, 0.1f, 1.0f / 60.0f );
	}
	assert_float_equal( s.value, 2.0f * 100.0f / 60.0f, 1e-4f );
}

// Not among numbers that machines are slow with: no float of an offset is ever smaller than the smallest normal one.
static void offsetsThatDecayComeToRestAtZero( void** state )
{
	(void)state;
	soleOffset3 offset = { { 0.1f, -3.0f, 0.0f }, { 0.0f, 2.0f, 1e-3f } };
	soleOffset1 one = { -0.02f, 0.3f };
	for ( int i = 0; i < 2000; ++i )
	{
		one = soleDecayOffset1( one, 0.05f, 1.0f / 60.0f );
		offset = soleDecayOffset3( offset, 0.05f, 1.0f / 60.0f );
		assert_true( fpclassify( one.value ) != FP_SUBNORMAL && fpclassify( one.velocity ) != FP_SUBNORMAL );
		assert_true( fpclassify( offset.value.y ) != FP_SUBNORMAL && fpclassify( offset.velocity.z ) != FP_SUBNORMAL );
	}
	assert_true( one.value == 0.0f && one.velocity == 0.0f );
	const soleOffset3 none = { { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f } };
	assert_memory_equal( &offset, &none, sizeof offset );
}

static void badNumbersGiveFiniteSprings( void** state )
{
	(void)state;
	const float bad[] = { NAN, INFINITY, -INFINITY, 1e38f, 0.0f, -1.0f };
	for ( int i = 0; i < 6 * 6 * 6; ++i )
	{
		soleOffset1 s = { bad[i % 6], bad[i / 6 % 6] };
		s = soleStepSpring( s, bad[i / 36], bad[( i + 1 ) % 6], bad[( i + 2 ) % 6], bad[( i + 3 ) % 6] );
		assert_true( soleIsFinite( s.value ) && soleIsFinite( s.velocity ) );
	}
}

static void halvesAgreeWithAngles( void** state )
{
	(void)state;
	for ( int i = -314; i <= 314; ++i )
	{
		double angle = 0.01 * i;
		soleHalf h = soleMakeHalf( (float)( 3.0 * cos( angle ) ), (float)( 3.0 * sin( angle ) ) );
		assert_float_equal( h.c, cos( 0.5 * angle ), 2e-4 );
		assert_float_equal( h.s, sin( 0.5 * angle ), 2e-4 );
		soleHalf g = soleHalfFromAngle( (float)angle );
		assert_float_equal( g.c, cos( 0.5 * angle ), 2e-6 );
		assert_float_equal( g.s, sin( 0.5 * angle ), 2e-6 );
		float r = soleQuarterTan( g );
		assert_float_equal( r, tan( 0.25 * angle ), 2e-6 );
	}
	soleHalf half = soleMakeHalf( -1.0f, -0.0f );
	assert_true( half.c == 0.0f && half.s * half.s == 1.0f );
}

static void twistIsThePartAboutTheAxis( void** state )
{
	(void)state;
	soleVec3 axis = soleNormalizeOr( soleVec( 0.3f, 0.8f, -0.2f ), soleVec( 1.0f, 0.0f, 0.0f ) );
	soleQuat about = soleHalfRotation( axis, soleHalfFromAngle( 0.7f ) );
	soleQuat swing = soleHalfRotation( soleAnyOrthogonal( axis ), soleHalfFromAngle( 0.4f ) );
	soleQuat twist = soleTwist( soleMulQuat( swing, about ), axis );
	assert_true( soleDotQuat( twist, about ) > 1.0f - 1e-6f );
	soleQuat none = soleTwist( ( soleQuat ){ 0.0f, 0.0f, 0.0f, 0.0f }, axis );
	assert_true( none.w == 1.0f );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( expNegativeIsExactToTwoParts ),
		cmocka_unit_test( halfOfARestingErrorIsLeftAfterTheHalfLife ),
		cmocka_unit_test( manySmallStepsMakeOneLarge ),
		cmocka_unit_test( movingGoalIsFollowedWithoutLag ),
		cmocka_unit_test( offsetsThatDecayComeToRestAtZero ),
		cmocka_unit_test( badNumbersGiveFiniteSprings ),
		cmocka_unit_test( halvesAgreeWithAngles ),
		cmocka_unit_test( twistIsThePartAboutTheAxis ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
