// SPDX-License-Identifier: MIT
// Quality figures of motions made so that each figure is known beforehand.
#include "measure_rig.h"

// --------------------------------------------------------------------------------------------------------- points

static void pointsAreDenseAndCoverTheSole( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	soleMeasurePoint points[RIG_MAX_POINTS];
	int32_t count = soleMakeMeasurePoints( rig, NULL, 0 );
	assert_int_equal( soleMakeMeasurePoints( rig, points, RIG_MAX_POINTS ), count );
	soleTransform pose[RIG_JOINTS];
	rigStand( pose );
	float low = 1.0f;
	float high = -1.0f;
	float lastRow = -0.06f;
	for ( int32_t i = 0; i < count / 2; ++i )
	{
		assert_int_equal( points[i].leg, 0 );
		assert_int_equal( points[i].joint, points[i].fore ? 4 : 3 );
		soleVec3 p = points[i].position;
		for ( int32_t joint = points[i].joint; joint != SOLE_NONE; joint = rigParents[joint] )
		{
			p = soleTransformPoint( pose[joint], p );
		}
		assert_float_equal( p.y, 0.0f, 1e-6f );
		assert_true( p.x > 0.059f && p.x < 0.141f );
		assert_true( points[i].fore == ( p.z > RIG_TOE_Z - 1e-5f ) );
		if ( i % 3 == 0 )
		{
			assert_true( p.z - lastRow < 0.0051f );
			lastRow = p.z;
		}
		low = soleMinF( low, p.z );
		high = soleMaxF( high, p.z );
	}
	assert_float_equal( low, -0.06f, 1e-6f );
	assert_float_equal( high, 0.2f, 1e-6f );
	// No more are written than there is room for.
	points[7].leg = 77;
	assert_int_equal( soleMakeMeasurePoints( rig, points, 7 ), count );
	assert_int_equal( points[7].leg, 77 );
	soleDestroyRig( rig );
}

// ----------------------------------------------------------------------------------------------------------- sole

static void standingOnTheGroundIsPerfect( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	soleFigures f = rigMeasure( &m );
	assert_int_equal( f.legCount, 2 );
	assert_int_equal( f.legs[0].labelledFrames, 60 );
	assert_int_equal( f.all.labelledFrames, 120 );
	testNearD( f.all.penetration.max, 0.0, 1e-6 );
	testNearD( f.all.hover.max, 0.0, 1e-6 );
	testNearD( f.all.contactShare, 1.0, 0.0 );
	testNearD( f.all.slide, 0.0, 1e-9 );
	testNearD( f.all.drift.max, 0.0, 1e-9 );
	testNearD( f.all.kneeAccelerationMax, 0.0, 1e-6 );
	testNearD( f.pelvisJerk, 0.0, 1e-6 );
	assert_int_equal( f.all.stances, 2 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void feetThreeMillimetresDeepMeasureThreeMillimetres( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	soleFigures f = rigMeasureOn( &m, NULL, 0.003f, 0.0f );
	testNearD( f.all.penetration.mean, 0.003, 1e-6 );
	testNearD( f.all.penetration.p95, 0.003, 1e-6 );
	testNearD( f.all.penetration.max, 0.003, 1e-6 );
	testNearD( f.all.verticalPenetration.max, 0.003, 1e-6 );
	testNearD( f.all.hover.max, 0.0, 0.0 );
	testNearD( f.all.contactShare, 1.0, 0.0 );
	f = rigMeasureOn( &m, NULL, 0.006f, 0.0f );
	testNearD( f.all.contactShare, 0.0, 0.0 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void feetSevenMillimetresUpHoverSevenMillimetres( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	soleFigures f = rigMeasureOn( &m, NULL, -0.007f, 0.0f );
	testNearD( f.all.hover.mean, 0.007, 1e-6 );
	testNearD( f.all.hover.max, 0.007, 1e-6 );
	testNearD( f.all.penetration.max, 0.0, 0.0 );
	testNearD( f.all.contactShare, 1.0, 0.0 );
	f = rigMeasureOn( &m, NULL, -0.011f, 0.0f );
	testNearD( f.all.contactShare, 0.0, 0.0 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void onlyTheLabelledPartOfASoleHovers( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	for ( int32_t t = 0; t < 60; ++t )
	{
		// Left: heel raised, toes on the ground. Right: the whole foot 20 mm up, heel raised as well.
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, 0 ), 0.5 );
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, 0.02f, 0 ), 0.5 );
		m.labels[2 * t] = sole_labelToe;
		m.labels[2 * t + 1] = sole_labelHeel;
	}
	soleFigures f = rigMeasure( &m );
	testNearD( f.legs[0].hover.max, 0.0, 1e-6 );
	testNearD( f.legs[0].contactShare, 1.0, 0.0 );
	// The hindmost points that are carried by the foot are one row behind the ball line: nearly as low as that.
	assert_true( f.legs[1].hover.mean > 0.02 );
	testNearD( f.legs[1].contactShare, 0.0, 0.0 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void depthOnARampIsAcrossTheRamp( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 10, 60.0f );
	soleFigures f = rigMeasureOn( &m, NULL, 0.0f, 0.5f );
	// The toe tip at z = 0.2 is 0.1 m under the ramp.
	testNearD( f.all.verticalPenetration.max, 0.1, 1e-6 );
	testNearD( f.all.penetration.max, 0.1 / sqrt( 1.25 ), 1e-6 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void percentilesAreByNearestRank( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 20, 60.0f );
	for ( int32_t t = 0; t < 20; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, -0.001f * (float)( ( t * 7 ) % 20 + 1 ), 0 ), 0.0 );
		m.labels[2 * t + 1] = sole_labelNone;
	}
	// Depths 1 to 20 mm: the nineteenth of twenty is the first that 95 % do not exceed.
	soleFigures f = rigMeasure( &m );
	testNearD( f.legs[0].penetration.p95, 0.019, 1e-6 );
	testNearD( f.legs[0].penetration.mean, 0.0105, 1e-6 );
	testNearD( f.all.penetration.max, 0.020, 1e-6 );
	assert_int_equal( f.legs[1].labelledFrames, 0 );
	testNearD( f.legs[1].penetration.max, 0.0, 0.0 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

// ---------------------------------------------------------------------------------------------------------- steps

static void aFootThatSlidesAtATenthOfAMetreASecondMeasuresThat( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	float rates[3] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t i = 0; i < 3; ++i )
	{
		int32_t count = (int32_t)rates[i] + 1;
		rigMotion m = rigMakeMotion( rig, count, rates[i] );
		for ( int32_t t = 0; t < count; ++t )
		{
			rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, 0.1f * (float)t / rates[i] ), 0.0 );
		}
		soleFigures f = rigMeasure( &m );
		testNearD( f.legs[0].slide, 0.1, 1e-4 );
		testNearD( f.legs[1].slide, 0.0, 1e-9 );
		testNearD( f.all.slide, 0.05, 1e-4 );
		// A second of it is 50 mm to either side of mid-stance.
		testNearD( f.legs[0].drift.max, 0.05, 1e-3 );
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void rollingOverAPlantedToeIsNoSlide( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 30, 60.0f );
	for ( int32_t t = 0; t < 30; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, 0 ), 0.02 * t );
		m.labels[2 * t] = sole_labelToe;
	}
	soleFigures f = rigMeasure( &m );
	testNearD( f.legs[0].slide, 0.0, 1e-6 );
	testNearD( f.legs[0].drift.max, 0.0, 1e-6 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void sinkingAlongARampsNormalIsNoSlide( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 30, 60.0f );
	for ( int32_t t = 0; t < 30; ++t )
	{
		float s = 0.001f * (float)t;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, s * 1.0f, s * -0.5f ), 0.0 );
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, s * 0.5f, s * 1.0f ), 0.0 );
	}
	soleFigures f = rigMeasureOn( &m, NULL, 0.0f, 0.5f );
	testNearD( f.legs[0].slide, 0.0, 1e-4 );
	testNearD( f.legs[1].slide, 0.06 * sqrt( 1.25 ), 1e-4 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void driftAndClearanceAreOfEachStanceAndSwing( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 180, 60.0f );
	for ( int32_t t = 0; t < 180; ++t )
	{
		// Three stances of 0.5 s that creep by 10, 20 and 30 mm, swings of 0.5 s 40 and 60 mm high between.
		int32_t step = t / 60;
		bool stance = t % 60 < 30;
		float creep = 0.01f * (float)( step + 1 ) * ( (float)( t % 60 ) / 28.0f );
		float height = 0.04f + 0.02f * (float)step;
		rigPutFoot( rigPose( &m, t ), 0, stance ? soleVec( 0, 0, creep ) : soleVec( 0, height, 0 ), 0.0 );
		m.labels[2 * t] = stance ? sole_labelFlat : sole_labelNone;
		m.labels[2 * t + 1] = t >= 10 && t < 14 ? sole_labelFlat : sole_labelNone;
	}
	soleFigures f = rigMeasure( &m );
	assert_int_equal( f.legs[0].stances, 3 );
	// From frame 14, half of the way, to frame 29.
	testNearD( f.legs[0].drift.max, 0.03 * 15.0 / 28.0, 1e-5 );
	testNearD( f.legs[0].drift.mean, 0.02 * 15.0 / 28.0, 1e-5 );
	testNearD( f.legs[0].clearance, 0.04, 1e-5 );
	// Too short to be a stance.
	assert_int_equal( f.legs[1].stances, 0 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

/// A foot that lifts at the first unlabelled frame, strikes at frame 40, and dips under the ground in one frame.
static soleFigures measureDip( const soleRig* rig, float rate, int32_t lift, int32_t dip )
{
	rigMotion m = rigMakeMotion( rig, 60, rate );
	for ( int32_t t = lift; t < 40; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, t == dip ? -0.01f : 0.05f, 0 ), 0.0 );
		m.labels[2 * t] = sole_labelNone;
	}
	soleFigures f = rigMeasure( &m );
	rigFreeMotion( &m );
	return f;
}

static void midSwingLastsFromFiftyMillisecondsAfterLiftToFiftyBeforeStrike( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	static const struct
	{
		float rate;
		int32_t margin; // frames that are nearer than 50 ms to events half a frame before the labels change
	} cases[] = { { 30.0f, 1 }, { 60.0f, 3 }, { 144.0f, 7 }, { 20.0f, 1 } };
	for ( int32_t i = 0; i < 4; ++i )
	{
		int32_t margin = cases[i].margin;
		assert_int_equal( measureDip( rig, cases[i].rate, 10, 10 + margin - 1 ).legs[0].scuffs, 0 );
		assert_int_equal( measureDip( rig, cases[i].rate, 10, 10 + margin ).legs[0].scuffs, 1 );
		assert_int_equal( measureDip( rig, cases[i].rate, 10, 39 - margin ).legs[0].scuffs, 1 );
		assert_int_equal( measureDip( rig, cases[i].rate, 10, 40 - margin ).legs[0].scuffs, 0 );
	}
	soleFigures f = measureDip( rig, 60.0f, 10, 20 );
	assert_int_equal( f.legs[0].swings, 1 );
	assert_int_equal( f.legs[1].swings, 0 );
	assert_int_equal( f.all.swings, 1 );
	assert_int_equal( f.all.scuffs, 1 );
	testNearD( f.all.clearance, -0.01, 1e-6 );
	// A swing of 0.1 s has no middle.
	assert_int_equal( measureDip( rig, 60.0f, 34, 36 ).all.swings, 0 );
	soleDestroyRig( rig );
}

// -------------------------------------------------------------------------------------------------------- refusal

static void expectRefusal( const soleMeasureDef* def, const char* word )
{
	soleFigures figures;
	soleMessage message = { { 0 } };
	assert_int_equal( soleMeasureMotion( def, NULL, &figures, &message ), sole_invalidDefinition );
	if ( strstr( message.text, word ) == NULL )
	{
		print_error( "no '%s' in: %s\n", word, message.text );
		fail();
	}
}

static void badDefinitionsAreRefusedByName( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 10, 60.0f );
	rigMotion shorter = rigMakeMotion( rig, 9, 60.0f );
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	const soleMeasureDef good = rigMeasureDef( &m, terrain );
	soleMeasureDef bad = good;
	bad.internalValue = 0;
	expectRefusal( &bad, "soleDefaultMeasureDef" );
	bad = good;
	bad.labels = NULL;
	expectRefusal( &bad, "labels" );
	bad = good;
	bad.terrain = NULL;
	expectRefusal( &bad, "terrain" );
	bad = good;
	bad.pointCount = 0;
	expectRefusal( &bad, "points" );
	bad = good;
	bad.skip = 10;
	expectRefusal( &bad, "skip" );
	bad = good;
	bad.reference = &shorter.motion;
	expectRefusal( &bad, "reference" );
	bad = good;
	bad.motion = NULL;
	expectRefusal( &bad, "motion.rig" );
	soleMotion motion = m.motion;
	bad.motion = &motion;
	motion.up = soleVec( 0, 0, 0 );
	expectRefusal( &bad, "motion.up" );
	soleMeasurePoint points[RIG_MAX_POINTS];
	memcpy( points, good.points, (size_t)good.pointCount * sizeof *points );
	points[5].joint = RIG_JOINTS;
	bad = good;
	bad.points = points;
	expectRefusal( &bad, "points[5]" );
	rigPose( &m, 6 )[7].rotation.x = nanf( "" );
	expectRefusal( &good, "frame 6" );
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	rigFreeMotion( &shorter );
	soleDestroyRig( rig );
}

static void failingMemoryLeavesNothingBehind( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 10, 60.0f );
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	for ( int32_t n = 0;; ++n )
	{
		rigMemory memory = { .left = n };
		soleAllocator allocator = { rigAlloc, rigFree, &memory };
		soleFigures figures;
		soleResult result = soleMeasureMotion( &def, &allocator, &figures, NULL );
		assert_int_equal( memory.held, 0 );
		if ( result == sole_success )
		{
			assert_true( n > 3 );
			break;
		}
		assert_int_equal( result, sole_outOfMemory );
	}
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( pointsAreDenseAndCoverTheSole ),
		cmocka_unit_test( standingOnTheGroundIsPerfect ),
		cmocka_unit_test( feetThreeMillimetresDeepMeasureThreeMillimetres ),
		cmocka_unit_test( feetSevenMillimetresUpHoverSevenMillimetres ),
		cmocka_unit_test( onlyTheLabelledPartOfASoleHovers ),
		cmocka_unit_test( depthOnARampIsAcrossTheRamp ),
		cmocka_unit_test( percentilesAreByNearestRank ),
		cmocka_unit_test( aFootThatSlidesAtATenthOfAMetreASecondMeasuresThat ),
		cmocka_unit_test( rollingOverAPlantedToeIsNoSlide ),
		cmocka_unit_test( sinkingAlongARampsNormalIsNoSlide ),
		cmocka_unit_test( driftAndClearanceAreOfEachStanceAndSwing ),
		cmocka_unit_test( midSwingLastsFromFiftyMillisecondsAfterLiftToFiftyBeforeStrike ),
		cmocka_unit_test( badDefinitionsAreRefusedByName ),
		cmocka_unit_test( failingMemoryLeavesNothingBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
