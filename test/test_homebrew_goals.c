// SPDX-License-Identifier: MIT
// The ancestor "Homebrew", behaviour by behaviour: filter, goals, weights, body. The numbers are those of its
// description. The filter against double precision.
#include "homebrew_run.h"

// ----------------------------------------------------------------------------------------------------------- filter

typedef struct oracleSpring
{
	double value, velocity;
} oracleSpring;

static void oracleStep( oracleSpring* s, double target, double time, double dt )
{
	double w = 2.0 / time, x = w * dt;
	double decay = 1.0 / ( 1.0 + x + 0.48 * x * x + 0.235 * x * x * x );
	double c = s->value - target, t = ( s->velocity + w * c ) * dt;
	s->velocity = ( s->velocity - w * t ) * decay;
	s->value = target + ( c + t ) * decay;
}

static void heightAndNormalGoThroughTheSpring_13( void** state )
{
	(void)state;
	const float timeSteps[] = { 1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 240.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		start( level( 0.0f ) );
		run.base.frame.timeStep = timeSteps[k];
		run.settings.smoothTime = 0.12f;
		run.settings.enableBodyPositioning = false;
		step();
		const double slope = 0.2;
		soleVec3 foot = ancestorAnimated( &run.base, biped_ankleL ).translation;
		ancestorSetGround(
		    &run.base, ancestorPlane( soleVec( foot.x, 0.06f, foot.z ), soleVec( 0.0f, 1.0f, -(float)slope ) ) );
		double size = sqrt( 1.0 + slope * slope );
		double target = 0.06 + ANKLE + 0.05 * size - 0.05 / size;
		oracleSpring height = { ANKLE, 0.0 }, y = { 1.0, 0.0 }, z = { 0.0, 0.0 };
		for ( int32_t i = 0; i < 40; ++i )
		{
			step();
			oracleStep( &height, target, 0.12, (double)timeSteps[k] );
			oracleStep( &y, 1.0 / size, 0.12, (double)timeSteps[k] );
			oracleStep( &z, -slope / size, 0.12, (double)timeSteps[k] );
			assert_float_equal( placedHeight( 0 ), (float)height.value, 1e-5f );
			assert_float_equal( footTurn( 0 ).x, (float)atan2( z.value, y.value ), 1e-4f );
		}
		ancestorEnd( &run.base );
	}
}

/// The fault that a rational form of the exponential brings, and that a step of an exact spring would not have.
static void theSpringDependsOnTheFrameRateALittle_13_19( void** state )
{
	(void)state;
	float reached[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		start( level( 0.0f ) );
		step();
		ancestorSetGround( &run.base, level( 0.08f ) );
		run.base.frame.timeStep = k == 0 ? 0.05f : 0.005f;
		steps( k == 0 ? 2 : 20 );
		reached[k] = placedHeight( 0 );
		ancestorEnd( &run.base );
	}
	float difference = fabsf( reached[0] - reached[1] );
	assert_true( difference > 1e-4f && difference < 8e-3f );
}

static void aFrameThatTakesNoTimeMovesNothing_13( void** state )
{
	(void)state;
	start( level( 0.0f ) );
	step();
	ancestorSetGround( &run.base, level( 0.1f ) );
	run.base.frame.timeStep = 0.0f;
	run.settings.enableBodyPositioning = false;
	steps( 3 );
	assert_float_equal( placedHeight( 0 ), (float)ANKLE, 1e-6f );
	ancestorEnd( &run.base );
}

// ------------------------------------------------------------------------------------------------ goals and weights

static void horizontallyTheFootGoesWithItsAnimation_14( void** state )
{
	(void)state;
	start( level( 0.05f ) );
	for ( int32_t i = 0; i < 30; ++i )
	{
		run.base.frame.root.translation = soleVec( 0.02f * (float)i, 0.0f, -0.03f * (float)i );
		run.base.pose[biped_hipL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -0.45f + 0.01f * (float)i );
		step();
		soleVec3 animated = ancestorAnimated( &run.base, biped_ankleL ).translation;
		soleVec3 placed = ancestorPlaced( &run.base, biped_ankleL ).translation;
		testNear3( placed, soleVec( animated.x, placed.y, animated.z ), 1e-5f );
	}
	ancestorEnd( &run.base );
}

static void weightsMultiplyAndAreNotSmoothed_13_15_16( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.05f, 0.0f ), soleVec( 0.2f, 1.0f, 0.0f ) ) );
	run.settings.enableBodyPositioning = false;
	steps( 2 );
	float height[2] = { placedHeight( 0 ), placedHeight( 1 ) };
	float turn[2] = { footTurn( 0 ).z, footTurn( 1 ).z };
	run.settings.globalWeight = 0.5f;
	run.settings.leftFootWeight = 0.5f;
	float own[] = { 1.0f, 0.8f };
	run.base.frame.legWeight = own;
	step();
	const float weight[] = { 0.25f, 0.4f };
	for ( int32_t i = 0; i < 2; ++i )
	{
		float wanted = animatedHeight( i ) + weight[i] * ( height[i] - animatedHeight( i ) );
		assert_float_equal( placedHeight( i ), wanted, 1e-4f );
		assert_float_equal( footTurn( i ).z, weight[i] * turn[i], 1e-3f );
	}
	run.base.frame.weight = 0.0f;
	step();
	soleVec3 animated = ancestorAnimated( &run.base, biped_ankleR ).translation;
	testNear3( ancestorPlaced( &run.base, biped_ankleR ).translation, animated, 1e-5f );
	ancestorEnd( &run.base );
}

static void theFootTurnsFromTheRootsUpToTheNormal_16( void** state )
{
	(void)state;
	uint32_t seed = 5;
	for ( int32_t i = 0; i < 50; ++i )
	{
		soleVec3 normal = soleVec( testRandomFloat( &seed, -0.3f, 0.3f ), 1.0f, testRandomFloat( &seed, -0.3f, 0.3f ) );
		start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), normal ) );
		soleVec3 axis = soleVec( testRandomFloat( &seed, -0.15f, 0.15f ), testRandomFloat( &seed, -1.0f, 1.0f ),
		    testRandomFloat( &seed, -0.15f, 0.15f ) );
		run.base.frame.root.rotation = soleNormalizeQuat( ( soleQuat ){ axis.x, axis.y, axis.z, 1.0f } );
		step();
		// The shortest turn between two directions: about their cross product, by the angle between them.
		soleVec3 up = soleRotate( run.base.frame.root.rotation, soleVec( 0.0f, 1.0f, 0.0f ) );
		soleVec3 n = soleNormalizeOr( normal, up );
		soleVec3 cross = soleCross( up, n );
		double sine = (double)soleLength( cross );
		double angle = atan2( sine, (double)soleDot( up, n ) );
		testNear3( footTurn( 0 ), soleScale( (float)( angle / sine ), cross ), 1e-3f );
		ancestorEnd( &run.base );
	}
}

static void theNormalIsFollowedUpToTheLargestAngle_16( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < 8; ++i )
	{
		float degrees = 5.0f * (float)i + 2.0f;
		float radians = degrees / 57.29578f;
		start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( -sinf( radians ), cosf( radians ), 0.0f ) ) );
		run.settings.maxRotationAngle = 20.0f;
		step();
		assert_float_equal( footTurn( 0 ).z, fminf( degrees, 20.0f ) / 57.29578f, 1e-3f );
		run.settings.enableFootRotation = false;
		step();
		assert_true( soleLength( footTurn( 0 ) ) < 1e-5f );
		ancestorEnd( &run.base );
	}
}

// ------------------------------------------------------------------------------------------------------------- body

static float bodyOver( float right, float left, float stretch )
{
	start( ancestorStep( right, left ) );
	run.settings.stretchRange = stretch;
	step();
	float body = ancestorBody( &run.base );
	assert_float_equal( run.base.out.pelvisOffset_w.y, body, 1e-5f );
	ancestorEnd( &run.base );
	return body;
}

static void theBodyFollowsTheLowerGround_17( void** state )
{
	(void)state;
	// Ground below the root is followed, but for what the legs may stretch.
	assert_float_equal( bodyOver( 0.0f, -0.2f, 0.0f ), -0.2f, 1e-5f );
	assert_float_equal( bodyOver( -0.1f, -0.2f, 0.0f ), -0.2f, 1e-5f );
	assert_float_equal( bodyOver( 0.0f, -0.2f, 0.05f ), -0.15f, 1e-5f );
	assert_float_equal( bodyOver( 0.0f, -0.03f, 0.05f ), 0.0f, 1e-5f );
	// Ground over it lifts the body by what the legs do not take up; only the lower counts.
	assert_float_equal( bodyOver( 0.2f, 0.2f, 0.0f ), 0.0f, 1e-5f );
	assert_float_equal( bodyOver( 0.3f, 0.35f, 0.0f ), 0.05f, 1e-5f );
	assert_float_equal( bodyOver( 0.0f, 0.35f, 0.0f ), 0.0f, 1e-5f );
}

static void theBodyStaysWithoutItsSwitch_17( void** state )
{
	(void)state;
	start( level( -0.05f ) );
	run.settings.enableBodyPositioning = false;
	step();
	assert_float_equal( ancestorBody( &run.base ), 0.0f, 0.0f );
	ancestorEnd( &run.base );
}

/// Heights are along the frame's up, whichever axis that is.
static void theWorldsUpIsTheFrames_19( void** state )
{
	(void)state;
	soleQuat lie = testTurn( soleVec( 0.0f, 0.0f, 1.0f ), -1.5707963f ); // y becomes x
	start( level( 0.03f ) );
	steps( 3 );
	float upright = placedHeight( 0 );
	ancestorEnd( &run.base );
	start( ancestorPlane( soleVec( 0.03f, 0.0f, 0.0f ), soleVec( 1.0f, 0.0f, 0.0f ) ) );
	run.base.frame.root.rotation = lie;
	run.base.frame.up = soleVec( 1.0f, 0.0f, 0.0f );
	steps( 3 );
	assert_float_equal( ancestorPlaced( &run.base, biped_ankleL ).translation.x, upright, 1e-5f );
	ancestorEnd( &run.base );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( heightAndNormalGoThroughTheSpring_13 ),
		cmocka_unit_test( theSpringDependsOnTheFrameRateALittle_13_19 ),
		cmocka_unit_test( aFrameThatTakesNoTimeMovesNothing_13 ),
		cmocka_unit_test( horizontallyTheFootGoesWithItsAnimation_14 ),
		cmocka_unit_test( weightsMultiplyAndAreNotSmoothed_13_15_16 ),
		cmocka_unit_test( theFootTurnsFromTheRootsUpToTheNormal_16 ),
		cmocka_unit_test( theNormalIsFollowedUpToTheLargestAngle_16 ),
		cmocka_unit_test( theBodyFollowsTheLowerGround_17 ),
		cmocka_unit_test( theBodyStaysWithoutItsSwitch_17 ),
		cmocka_unit_test( theWorldsUpIsTheFrames_19 ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
