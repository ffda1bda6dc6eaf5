// SPDX-License-Identifier: MIT
// The two jobs of ozz-animation against the same formulas in double, and what their documentation promises.
#include "ozz_oracle.h"

#define RUNS 2000

/// A chain of bones 0.5 and 0.4 in the plane at right angles to midAxis, anywhere, bent any way.
static soleOzzTwoBoneJob testRandomChain( uint32_t* seed )
{
	soleOzzTwoBoneJob job = soleDefaultOzzTwoBoneJob();
	job.start = testRandomPoint( seed, 2.0f );
	job.midAxis = testRandomDirection( seed );
	soleVec3 k = soleScale( 0.5f, soleAnyOrthogonal( job.midAxis ) );
	float bend = testRandomFloat( seed, 0.2f, 3.0f );
	soleVec3 s = soleAdd( soleScale( cosf( bend ), k ), soleScale( -sinf( bend ), soleCross( job.midAxis, k ) ) );
	job.mid = soleAdd( job.start, k );
	job.end = soleAdd( job.mid, soleScale( 0.8f, s ) );
	job.target = soleMulAdd( job.start, testRandomFloat( seed, 0.15f, 0.85f ), testRandomDirection( seed ) );
	do
	{
		job.poleVector = testRandomDirection( seed );
	} while ( soleLength( soleCross( job.poleVector, soleSub( job.target, job.start ) ) ) < 0.05f );
	return job;
}

static soleVec3 testChainEnd( const soleOzzTwoBoneJob* job, const soleOzzTwoBoneResult* result )
{
	soleVec3 shin = soleRotate( result->mid, soleSub( job->end, job->mid ) );
	return soleAdd( job->start, soleRotate( result->start, soleAdd( soleSub( job->mid, job->start ), shin ) ) );
}

static testTwoBoneD testWideJob( const soleOzzTwoBoneJob* job )
{
	return ( testTwoBoneD ){ testWide( job->start ), testWide( job->mid ), testWide( job->end ),
		testWide( job->target ), testWide( job->midAxis ), testWide( job->poleVector ), (double)job->twistAngle,
		(double)job->soften, (double)job->weight };
}

static void testNearPoint( soleVec3 a, testPoint b, float tolerance )
{
	testNear3( a, soleVec( (float)b.x, (float)b.y, (float)b.z ), tolerance );
}

/// Both bones, where they point, not only the chain's end.
static void testSameAsInDouble( const soleOzzTwoBoneJob* job )
{
	soleOzzTwoBoneResult result = soleRunOzzTwoBone( job );
	testTwoBoneD wide = testWideJob( job );
	testBentD bent = testTwoBoneInDouble( &wide );
	testPoint mid = testTurned( bent.start, testMinus( wide.mid, wide.start ) );
	testNearPoint( soleRotate( result.start, soleSub( job->mid, job->start ) ), mid, 2e-5f );
	testNearPoint( testChainEnd( job, &result ), bent.end, 2e-5f );
	// A point off the chain's plane shows turns about the bones too.
	testPoint side = testTurned( testAfter( bent.start, bent.mid ), wide.midAxis );
	testNearPoint( soleRotate( soleMulQuat( result.start, result.mid ), job->midAxis ), side, 1e-4f );
}

static void testTwoBoneIsTheFormulasInDouble( void** state )
{
	(void)state;
	uint32_t seed = 17;
	for ( int32_t i = 0; i < RUNS; ++i )
	{
		soleOzzTwoBoneJob job = testRandomChain( &seed );
		job.twistAngle = i % 2 == 0 ? 0.0f : testRandomFloat( &seed, -3.0f, 3.0f );
		job.soften = i % 3 == 0 ? 1.0f : testRandomFloat( &seed, 0.3f, 1.0f );
		job.weight = i % 5 == 0 ? testRandomFloat( &seed, 0.0f, 1.0f ) : 1.0f;
		testSameAsInDouble( &job );
	}
}

static void testTheEndIsAtTheTargetAndTheMidOnThePolesSide( void** state )
{
	(void)state;
	uint32_t seed = 18;
	for ( int32_t i = 0; i < RUNS; ++i )
	{
		soleOzzTwoBoneJob job = testRandomChain( &seed );
		soleOzzTwoBoneResult result = soleRunOzzTwoBone( &job );
		assert_true( result.reached );
		testNear3( testChainEnd( &job, &result ), job.target, 1e-5f );
		soleVec3 along = soleNormalizeOr( soleSub( job.target, job.start ), job.midAxis );
		soleVec3 mid = soleReject( soleRotate( result.start, soleSub( job.mid, job.start ) ), along );
		soleVec3 pole = soleNormalizeOr( soleReject( job.poleVector, along ), job.midAxis );
		// All of what the chain bends out by is towards the pole.
		assert_float_equal( soleDot( mid, pole ), soleLength( mid ), 2e-4f );
	}
}

static void testAChainThatBendsTheWrongWayIsOpenedThroughStraight( void** state )
{
	(void)state;
	soleOzzTwoBoneJob job = soleDefaultOzzTwoBoneJob();
	job.mid = soleVec( 0.0f, -0.5f, 0.0f );
	job.midAxis = soleVec( -1.0f, 0.0f, 0.0f );
	job.poleVector = soleVec( 0.0f, 0.0f, 1.0f );
	job.target = soleVec( 0.0f, -0.7f, 0.0f );
	for ( float z = -0.3f; z < 0.35f; z += 0.1f )
	{
		job.end = soleVec( 0.0f, -0.9f, z );
		testSameAsInDouble( &job );
		soleOzzTwoBoneResult result = soleRunOzzTwoBone( &job );
		testNear3( testChainEnd( &job, &result ), job.target, 1e-5f );
		assert_true( soleRotate( result.start, job.mid ).z > 0.1f );
	}
}

static void testTheTwistGoesAboutTheLineToTheTarget( void** state )
{
	(void)state;
	uint32_t seed = 19;
	soleOzzTwoBoneJob job = testRandomChain( &seed );
	soleOzzTwoBoneResult plain = soleRunOzzTwoBone( &job );
	job.twistAngle = 0.7f;
	soleOzzTwoBoneResult twisted = soleRunOzzTwoBone( &job );
	testNear3( testChainEnd( &job, &twisted ), job.target, 1e-5f );
	testPoint line = testMinus( testWide( job.target ), testWide( job.start ) );
	testPoint mid = testWide( soleRotate( plain.start, soleSub( job.mid, job.start ) ) );
	soleVec3 found = soleRotate( twisted.start, soleSub( job.mid, job.start ) );
	testNearPoint( found, testTurned( testAbout( line, 0.7 ), mid ), 1e-5f );
}

static void testSofteningFallsBehindAndNeverStraightens( void** state )
{
	(void)state;
	uint32_t seed = 20;
	soleOzzTwoBoneJob job = testRandomChain( &seed );
	soleVec3 way = soleNormalizeOr( soleSub( job.target, job.start ), job.midAxis );
	job.soften = 0.8f;
	float before = 0.0f;
	for ( float distance = 0.5f; distance < 3.0f; distance += 0.01f )
	{
		job.target = soleMulAdd( job.start, distance, way );
		soleOzzTwoBoneResult result = soleRunOzzTwoBone( &job );
		float length = soleDistance( testChainEnd( &job, &result ), job.start );
		float wanted = (float)testSoftenedD( (double)distance, 0.72, 0.9 );
		assert_float_equal( length, wanted, 1e-5f );
		assert_true( length > before && length < 0.9f );
		assert_true( result.reached == ( distance <= 0.72f ) );
		before = length;
	}
}

static void testReachedNeedsReachAndFullWeight( void** state )
{
	(void)state;
	uint32_t seed = 21;
	soleOzzTwoBoneJob job = testRandomChain( &seed );
	soleVec3 way = soleNormalizeOr( soleSub( job.target, job.start ), job.midAxis );
	const float distances[] = { 0.05f, 0.12f, 0.5f, 0.89f, 0.95f };
	const bool reached[] = { false, true, true, true, false };
	for ( int32_t i = 0; i < 5; ++i )
	{
		job.weight = 1.0f;
		job.target = soleMulAdd( job.start, distances[i], way );
		assert_true( soleRunOzzTwoBone( &job ).reached == reached[i] );
		job.weight = 0.99f;
		assert_false( soleRunOzzTwoBone( &job ).reached );
	}
	// Out of reach the chain is straight, or as short as it gets, towards the target.
	job.weight = 1.0f;
	soleOzzTwoBoneResult result = soleRunOzzTwoBone( &job );
	testNear3( testChainEnd( &job, &result ), soleMulAdd( job.start, 0.9f, way ), 1e-4f );
}

static void testNothingIsWrongWithoutADirection( void** state )
{
	(void)state;
	soleOzzTwoBoneJob job = soleDefaultOzzTwoBoneJob();
	soleOzzTwoBoneResult result = soleRunOzzTwoBone( &job );
	assert_true( soleQuat_IsFinite( result.start ) && soleQuat_IsFinite( result.mid ) );
	job.mid = soleVec( 1.0f, 0.0f, 0.0f );
	job.end = soleVec( 2.0f, 0.0f, 0.0f );
	job.twistAngle = 1.0f;
	result = soleRunOzzTwoBone( &job );
	assert_true( soleQuat_IsFinite( result.start ) && soleQuat_IsFinite( result.mid ) );
	job.target = soleVec( 0.0f, 1.5f, 0.0f ); // along the pole
	result = soleRunOzzTwoBone( &job );
	testNear3( testChainEnd( &job, &result ), job.target, 1e-5f );
	soleOzzAimJob aim = soleDefaultOzzAimJob();
	assert_true( soleQuat_IsFinite( soleRunOzzAim( &aim ).turn ) );
	aim.target = soleVec( 0.0f, 2.0f, 0.0f );
	assert_true( soleQuat_IsFinite( soleRunOzzAim( &aim ).turn ) );
}

// ------------------------------------------------------------------------------------------------------------- aim

static soleOzzAimJob testRandomAim( uint32_t* seed )
{
	soleOzzAimJob job = soleDefaultOzzAimJob();
	job.joint = testRandomPoint( seed, 2.0f );
	job.forward = testRandomDirection( seed );
	job.up = soleAnyOrthogonal( job.forward );
	job.offset = testRandomPoint( seed, 0.2f );
	job.target = soleMulAdd( job.joint, testRandomFloat( seed, 0.5f, 2.0f ), testRandomDirection( seed ) );
	soleVec3 away = soleNormalizeOr( soleSub( job.joint, job.target ), job.up );
	do
	{
		job.poleVector = testRandomDirection( seed );
	} while ( soleLength( soleCross( job.poleVector, away ) ) < 0.1f );
	// Half a turn has no one answer.
	return soleDot( job.forward, away ) > 0.8f ? testRandomAim( seed ) : job;
}

static void testAimIsTheFormulasInDouble( void** state )
{
	(void)state;
	uint32_t seed = 22;
	int32_t compared = 0;
	for ( int32_t i = 0; i < RUNS; ++i )
	{
		soleOzzAimJob job = testRandomAim( &seed );
		job.twistAngle = i % 2 == 0 ? 0.0f : testRandomFloat( &seed, -3.0f, 3.0f );
		soleOzzAimResult result = soleRunOzzAim( &job );
		testAimD wide = { testWide( job.joint ), testWide( job.target ), testWide( job.forward ), testWide( job.up ),
			testWide( job.offset ), testWide( job.poleVector ), (double)job.twistAngle, 1.0 };
		testTurnD turn = testAimInDouble( &wide );
		testPoint up = testTurned( testShortest( wide.forward, testMinus( wide.target, wide.joint ) ), wide.up );
		// Near its line to the target up has no side to be turned to.
		if ( testLengthD( testCross( up, testUnit( testMinus( wide.target, wide.joint ) ) ) ) < 0.1 )
		{
			continue;
		}
		++compared;
		testNearPoint( soleRotate( result.turn, job.forward ), testTurned( turn, wide.forward ), 1e-4f );
		testNearPoint( soleRotate( result.turn, job.up ), testTurned( turn, wide.up ), 1e-4f );
	}
	assert_true( compared > RUNS * 9 / 10 );
}

static void testTheLineFromTheOffsetMeetsTheTarget( void** state )
{
	(void)state;
	uint32_t seed = 23;
	for ( int32_t i = 0; i < RUNS; ++i )
	{
		soleOzzAimJob job = testRandomAim( &seed );
		soleOzzAimResult result = soleRunOzzAim( &job );
		assert_true( result.reached );
		soleVec3 from = soleAdd( job.joint, soleRotate( result.turn, job.offset ) );
		soleVec3 way = soleNormalizeOr( soleSub( job.target, from ), job.up );
		testNear3( soleRotate( result.turn, job.forward ), way, 1e-4f );
	}
}

static void testATargetInsideTheOffsetIsNotReached( void** state )
{
	(void)state;
	soleOzzAimJob job = soleDefaultOzzAimJob();
	job.offset = soleVec( 0.0f, 0.5f, 0.0f );
	job.target = soleVec( 0.0f, 0.0f, 0.4f );
	soleOzzAimResult result = soleRunOzzAim( &job );
	assert_false( result.reached );
	assert_float_equal( result.turn.w, 1.0f, 0.0f );
	job.target.z = 0.6f;
	assert_true( soleRunOzzAim( &job ).reached );
}

static void testAimFollowsItsWeight( void** state )
{
	(void)state;
	soleOzzAimJob job = soleDefaultOzzAimJob();
	job.target = soleVec( 0.0f, 0.0f, 1.0f );
	for ( int32_t i = 0; i <= 10; ++i )
	{
		// A quarter turn about -Y; the mean of it and none in the plane of their quaternions.
		job.weight = 0.1f * (float)i;
		double w = (double)job.weight;
		double angle = 2.0 * atan2( w * sqrt( 0.5 ), 1.0 - w + w * sqrt( 0.5 ) );
		testPoint forward = { cos( angle ), 0.0, sin( angle ) };
		testNearPoint( soleRotate( soleRunOzzAim( &job ).turn, job.forward ), forward, 1e-6f );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testTwoBoneIsTheFormulasInDouble ),
		cmocka_unit_test( testTheEndIsAtTheTargetAndTheMidOnThePolesSide ),
		cmocka_unit_test( testAChainThatBendsTheWrongWayIsOpenedThroughStraight ),
		cmocka_unit_test( testTheTwistGoesAboutTheLineToTheTarget ),
		cmocka_unit_test( testSofteningFallsBehindAndNeverStraightens ),
		cmocka_unit_test( testReachedNeedsReachAndFullWeight ),
		cmocka_unit_test( testNothingIsWrongWithoutADirection ),
		cmocka_unit_test( testAimIsTheFormulasInDouble ),
		cmocka_unit_test( testTheLineFromTheOffsetMeetsTheTarget ),
		cmocka_unit_test( testATargetInsideTheOffsetIsNotReached ),
		cmocka_unit_test( testAimFollowsItsWeight ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
