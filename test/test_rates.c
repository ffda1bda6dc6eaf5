// SPDX-License-Identifier: MIT
// Distances between two samplings of one motion.
#include "measure_rig.h"

/// Seconds of a foot that swings along z, each frame at its own time. late: as if that much later.
static rigMotion makeSwing( const soleRig* rig, float rate, double seconds, double late )
{
	rigMotion m = rigMakeMotion( rig, (int32_t)( seconds * (double)rate ) + 1, rate );
	for ( int32_t t = 0; t < m.motion.frameCount; ++t )
	{
		double time = t / (double)rate + late;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, (float)( 0.1 * time ) ), 0.0 );
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, (float)( 0.2 * time ), 0 ), 0.0 );
		m.roots[t].translation.z = (float)time;
	}
	return m;
}

static soleStat compare( const rigMotion* a, const rigMotion* b, float start )
{
	soleStat stat;
	soleMessage message = { { 0 } };
	soleResult result = soleCompareMotions( &a->motion, &b->motion, start, NULL, &stat, &message );
	assert_string_equal( message.text, "" );
	assert_int_equal( result, sole_success );
	return stat;
}

static void oneMotionAtTwoRatesIsTheSame( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	static const float rates[] = { 30.0f, 144.0f, 24.0f, 60.0f, 7.0f };
	rigMotion base = makeSwing( rig, 60.0f, 2.0, 0.0 );
	for ( int32_t i = 0; i < 5; ++i )
	{
		rigMotion m = makeSwing( rig, rates[i], 2.0, 0.0 );
		testNearD( compare( &m, &base, 0.0f ).max, 0.0, 1e-5 );
		testNearD( compare( &base, &m, 0.0f ).max, 0.0, 1e-5 );
		rigFreeMotion( &m );
	}
	rigFreeMotion( &base );
	soleDestroyRig( rig );
}

static void distancesAreOfAnkleAndBallInTheWorld( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion base = makeSwing( rig, 60.0f, 2.0, 0.0 );
	rigMotion late = makeSwing( rig, 144.0f, 2.0, 0.02 );
	soleStat stat = compare( &late, &base, 0.0f );
	// One foot goes at 1.1 m/s, the other at 1 m/s along and 0.2 m/s up.
	testNearD( stat.max, 0.022, 1e-5 );
	testNearD( stat.mean, 0.5 * 0.02 * ( 1.1 + sqrt( 1.0 + 0.04 ) ), 1e-5 );
	rigFreeMotion( &base );
	rigFreeMotion( &late );
	soleDestroyRig( rig );
}

static void aRaisedHeelMovesTheAnkleAlone( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion a = rigMakeMotion( rig, 31, 30.0f );
	rigMotion b = rigMakeMotion( rig, 61, 60.0f );
	// In one of 31 common times, of which each has four points.
	rigPutFoot( rigPose( &a, 20 ), 1, soleVec( 0, 0, 0 ), 0.3 );
	double way = 2.0 * sin( 0.15 ) * sqrt( 0.05 * 0.05 + (double)( RIG_TOE_Z * RIG_TOE_Z ) );
	soleStat stat = compare( &a, &b, 0.0f );
	testNearD( stat.max, way, 1e-5 );
	testNearD( stat.mean, way / ( 31.0 * 4.0 ), 1e-6 );
	testNearD( stat.p95, 0.0, 1e-6 );
	// Common times alone count, and those from the start on.
	rigPutFoot( rigPose( &b, 41 ), 0, soleVec( 0, 0.5f, 0 ), 0.0 );
	testNearD( compare( &a, &b, 0.0f ).max, way, 1e-5 );
	testNearD( compare( &a, &b, 0.6666f ).max, way, 1e-5 );
	testNearD( compare( &a, &b, 0.7f ).max, 0.0, 1e-6 );
	rigFreeMotion( &a );
	rigFreeMotion( &b );
	soleDestroyRig( rig );
}

static void expectRefusal( const soleMotion* a, const soleMotion* b, float start, const char* word )
{
	soleStat stat = { 1.0, 1.0, 1.0 };
	soleMessage message = { { 0 } };
	assert_int_equal( soleCompareMotions( a, b, start, NULL, &stat, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, word ) );
	testNearD( stat.max, 0.0, 0.0 );
}

static void whatCannotBeComparedIsRefusedInWords( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	soleRig* another = rigMake();
	rigMotion a = rigMakeMotion( rig, 31, 30.0f );
	rigMotion b = rigMakeMotion( rig, 61, 60.0f );
	soleMotion odd = b.motion;
	odd.frameRate = 59.94f;
	expectRefusal( &a.motion, &odd, 0.0f, "59.94" );
	odd.frameRate = 0.0f;
	expectRefusal( &odd, &a.motion, 0.0f, "motion.frameRate" );
	odd = b.motion;
	odd.rig = another;
	expectRefusal( &a.motion, &odd, 0.0f, "rig" );
	odd.rig = NULL;
	expectRefusal( &a.motion, &odd, 0.0f, "other.rig" );
	expectRefusal( &a.motion, &b.motion, 1.5f, "start" );
	expectRefusal( &a.motion, &b.motion, (float)NAN, "start" );
	rigPose( &b, 60 )[4].translation.x = (float)INFINITY;
	expectRefusal( &a.motion, &b.motion, 0.0f, "finite" );
	rigFreeMotion( &a );
	rigFreeMotion( &b );
	soleDestroyRig( rig );
	soleDestroyRig( another );
}

static void failingMemoryLeavesNothingBehind( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion a = rigMakeMotion( rig, 31, 30.0f );
	soleResult result = sole_outOfMemory;
	for ( int32_t i = 0; i < 20 && result == sole_outOfMemory; ++i )
	{
		rigMemory memory = { .left = i };
		soleAllocator allocator = { .alloc = rigAlloc, .free = rigFree, .user = &memory };
		soleStat stat;
		result = soleCompareMotions( &a.motion, &a.motion, 0.0f, &allocator, &stat, NULL );
		assert_int_equal( memory.held, 0 );
		assert_true( i > 0 || result == sole_outOfMemory );
	}
	assert_int_equal( result, sole_success );
	rigFreeMotion( &a );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( oneMotionAtTwoRatesIsTheSame ),
		cmocka_unit_test( distancesAreOfAnkleAndBallInTheWorld ),
		cmocka_unit_test( aRaisedHeelMovesTheAnkleAlone ),
		cmocka_unit_test( whatCannotBeComparedIsRefusedInWords ),
		cmocka_unit_test( failingMemoryLeavesNothingBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
