// SPDX-License-Identifier: MIT
// The two-bone kernel against double-precision geometry.
#include "test.h"

#include "sole/sole.h"

static soleVec3 randomVec( uint32_t* seed, float size )
{
	float x = testRandomFloat( seed, -size, size );
	float y = testRandomFloat( seed, -size, size );
	float z = testRandomFloat( seed, -size, size );
	return soleVec( x, y, z );
}

static soleVec3 randomUnit( uint32_t* seed )
{
	return soleNormalizeOr( randomVec( seed, 1.0f ), soleVec( 0.0f, 1.0f, 0.0f ) );
}

/// A leg in any place and turn, bent by `flexion` about a hinge that is `off` from the rig's.
static soleTwoBoneDef randomLeg( uint32_t* seed, float flexion, float off )
{
	soleVec3 hinge = randomUnit( seed );
	soleVec3 along = soleNormalizeOr( soleReject( randomUnit( seed ), hinge ), soleAnyOrthogonal( hinge ) );
	soleVec3 across = soleCross( hinge, along );
	float a = testRandomFloat( seed, 0.4f, 0.5f );
	float b = testRandomFloat( seed, 0.4f, 0.5f );
	soleTwoBoneDef def = { .reach = 1.0f, .fold = 0.0f, .softZone = 0.0f };
	def.hip = randomVec( seed, 1.0f );
	def.knee = soleMulAdd( def.hip, a, along );
	soleVec3 shin = soleAdd( soleScale( cosf( flexion ), along ), soleScale( sinf( flexion ), across ) );
	def.ankle = soleMulAdd( def.knee, b, shin );
	def.hinge = soleNormalizeOr( soleMulAdd( hinge, off, randomUnit( seed ) ), hinge );
	def.target = def.ankle;
	return def;
}

static double exactReach( soleTwoBoneDef def, soleTwoBoneResult r )
{
	// Forward kinematics of the result.
	soleVec3 shin = soleRotate( r.knee, soleSub( def.ankle, def.knee ) );
	soleVec3 end = soleAdd( def.hip, soleRotate( r.hip, soleAdd( soleSub( def.knee, def.hip ), shin ) ) );
	double x = (double)end.x - (double)def.target.x, y = (double)end.y - (double)def.target.y,
	       z = (double)end.z - (double)def.target.z;
	return sqrt( x * x + y * y + z * z );
}

static void ankleComesToEveryReachableTarget( void** state )
{
	(void)state;
	uint32_t seed = 1;
	double worst = 0.0;
	for ( int i = 0; i < 100000; ++i )
	{
		soleTwoBoneDef def = randomLeg( &seed, testRandomFloat( &seed, 0.1f, 2.2f ), 0.3f );
		float bones = soleDistance( def.hip, def.knee ) + soleDistance( def.knee, def.ankle );
		float length = testRandomFloat( &seed, 0.35f, 0.9999f ) * bones;
		def.target = soleMulAdd( def.hip, length, randomUnit( &seed ) );
		soleTwoBoneResult r = soleSolveTwoBone( &def );
		double error = exactReach( def, r );
		worst = error > worst ? error : worst;
		assert_true( soleDistance( r.ankle, def.target ) < 2e-6f );
	}
	print_message( "worst ankle error %.2f um\n", worst * 1e6 );
	assert_true( worst < 2e-6 );
}

static void straightAnimatedLegIsExactToo( void** state )
{
	(void)state;
	uint32_t seed = 2;
	double worst = 0.0;
	for ( int i = 0; i < 100000; ++i )
	{
		soleTwoBoneDef def = randomLeg( &seed, testRandomFloat( &seed, -0.04f, 0.04f ), 0.4f );
		float bones = soleDistance( def.hip, def.knee ) + soleDistance( def.knee, def.ankle );
		def.target = soleMulAdd( def.hip, testRandomFloat( &seed, 0.5f, 0.999f ) * bones, randomUnit( &seed ) );
		double error = exactReach( def, soleSolveTwoBone( &def ) );
		worst = error > worst ? error : worst;
	}
	print_message( "worst ankle error %.2f um\n", worst * 1e6 );
	// Targets lie all round, also nearly opposite to the animated leg, where a micrometre or two is lost.
	assert_true( worst < 5e-6 );
}

static void targetAtAnimationChangesNothing( void** state )
{
	(void)state;
	uint32_t seed = 3;
	for ( int i = 0; i < 10000; ++i )
	{
		soleTwoBoneDef def = randomLeg( &seed, testRandomFloat( &seed, 0.1f, 2.0f ), 0.2f );
		soleTwoBoneResult r = soleSolveTwoBone( &def );
		assert_true( fabsf( r.hip.w ) > 1.0f - 1e-6f && fabsf( r.knee.w ) > 1.0f - 1e-6f );
		assert_true( soleLength( soleVec( r.hip.x, r.hip.y, r.hip.z ) ) < 2e-5f );
		assert_true( soleLength( soleVec( r.knee.x, r.knee.y, r.knee.z ) ) < 2e-5f );
	}
}

static void kneeBendsOnTheHingesSide( void** state )
{
	(void)state;
	uint32_t seed = 4;
	for ( int i = 0; i < 20000; ++i )
	{
		soleTwoBoneDef def = randomLeg( &seed, testRandomFloat( &seed, 0.0f, 2.0f ), 0.0f );
		float bones = soleDistance( def.hip, def.knee ) + soleDistance( def.knee, def.ankle );
		def.target = soleMulAdd( def.hip, testRandomFloat( &seed, 0.4f, 0.98f ) * bones, randomUnit( &seed ) );
		soleTwoBoneResult r = soleSolveTwoBone( &def );
		soleVec3 k = soleRotate( r.hip, soleSub( def.knee, def.hip ) );
		soleVec3 s = soleSub( r.ankle, soleAdd( def.hip, k ) );
		assert_true( soleDot( soleCross( k, s ), soleRotate( r.hip, def.hinge ) ) > 0.0f );
	}
}

static void softReachNeverOverstretchesAndKeepsOrder( void** state )
{
	(void)state;
	uint32_t seed = 5;
	soleTwoBoneDef def = randomLeg( &seed, 0.6f, 0.0f );
	float bones = soleDistance( def.hip, def.knee ) + soleDistance( def.knee, def.ankle );
	soleVec3 way = randomUnit( &seed );
	def.reach = 0.99f;
	def.softZone = 0.02f;
	float last = 0.0f;
	for ( int i = 0; i <= 1000; ++i )
	{
		float asked = ( 0.9f + 0.3f * (float)i / 1000.0f ) * bones;
		def.target = soleMulAdd( def.hip, asked, way );
		soleTwoBoneResult r = soleSolveTwoBone( &def );
		float length = soleDistance( r.ankle, def.hip );
		assert_true( length <= 0.99f * bones + 1e-6f );
		assert_true( length >= last - 1e-6f );
		assert_true( asked <= 0.99f * bones - 0.02f ? fabsf( length - asked ) < 2e-6f : length <= asked + 1e-6f );
		assert_int_equal( ( r.flags & sole_legOutOfReach ) != 0,
		    asked > 0.99f * bones + 1e-6f || ( asked > 0.99f * bones && ( r.flags & sole_legOutOfReach ) != 0 ) );
		last = length;
	}
}

static void degenerateLegsAreFiniteAndFlagged( void** state )
{
	(void)state;
	uint32_t seed = 6;
	soleTwoBoneDef def = randomLeg( &seed, 0.6f, 0.0f );
	soleTwoBoneDef cases[6] = { def, def, def, def, def, def };
	cases[0].target = def.hip;                // target at the hip
	cases[1].knee = def.hip;                  // no thigh
	cases[2].knee = def.ankle;                // no shin
	cases[3].ankle = def.hip;                 // folded on itself
	cases[4].target.x = NAN;                  // not finite
	cases[5].knee = cases[5].ankle = def.hip; // nothing at all
	for ( int i = 0; i < 6; ++i )
	{
		soleTwoBoneResult r = soleSolveTwoBone( cases + i );
		assert_true( soleQuat_IsFinite( r.hip ) && soleQuat_IsFinite( r.knee ) && soleVec3_IsFinite( r.ankle ) );
		assert_true( ( r.flags & sole_legDegenerate ) != 0 );
	}
	// Target exactly behind the hip, hinge along the leg: still a leg of the right length.
	def.target = soleSub( def.hip, soleSub( def.ankle, def.hip ) );
	assert_true( exactReach( def, soleSolveTwoBone( &def ) ) < 2e-6 );
	def.target = def.ankle;
	def.hinge = soleNormalizeOr( soleSub( def.ankle, def.hip ), def.hinge );
	assert_true( exactReach( def, soleSolveTwoBone( &def ) ) < 2e-6 );
}

static void turningTheWorldTurnsTheResult( void** state )
{
	(void)state;
	uint32_t seed = 7;
	for ( int i = 0; i < 5000; ++i )
	{
		soleTwoBoneDef def = randomLeg( &seed, testRandomFloat( &seed, 0.0f, 2.0f ), 0.2f );
		float bones = soleDistance( def.hip, def.knee ) + soleDistance( def.knee, def.ankle );
		def.target = soleMulAdd( def.hip, testRandomFloat( &seed, 0.4f, 1.1f ) * bones, randomUnit( &seed ) );
		def.reach = 0.995f;
		def.softZone = 0.02f;
		soleQuat q = soleNormalizeQuat( ( soleQuat ){ testRandomFloat( &seed, -1.0f, 1.0f ),
		    testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ), 0.3f } );
		soleTwoBoneDef turned = def;
		turned.hip = soleRotate( q, def.hip );
		turned.knee = soleRotate( q, def.knee );
		turned.ankle = soleRotate( q, def.ankle );
		turned.target = soleRotate( q, def.target );
		turned.hinge = soleRotate( q, def.hinge );
		testNear3( soleSolveTwoBone( &turned ).ankle, soleRotate( q, soleSolveTwoBone( &def ).ankle ), 1e-5f );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( ankleComesToEveryReachableTarget ),
		cmocka_unit_test( straightAnimatedLegIsExactToo ),
		cmocka_unit_test( targetAtAnimationChangesNothing ),
		cmocka_unit_test( kneeBendsOnTheHingesSide ),
		cmocka_unit_test( softReachNeverOverstretchesAndKeepsOrder ),
		cmocka_unit_test( degenerateLegsAreFiniteAndFlagged ),
		cmocka_unit_test( turningTheWorldTurnsTheResult ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
