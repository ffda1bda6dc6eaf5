// SPDX-License-Identifier: MIT
// Published figures of motions made so that each is known beforehand.
#include "measure_rig.h"

/// A foot that slides along z at a speed and at a height; the other one stands.
static rigMotion makeSlide( const soleRig* rig, float rate, double seconds, double speed, double height )
{
	rigMotion m = rigMakeMotion( rig, (int32_t)( seconds * (double)rate + 0.5 ) + 1, rate );
	for ( int32_t t = 0; t < m.motion.frameCount; ++t )
	{
		double way = speed * t / (double)rate;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, (float)height, (float)way ), 0.0 );
	}
	return m;
}

static solePublishedFigures measureOn( const rigMotion* m, float height, const bool* seams )
{
	soleTerrain* terrain = rigMakePlane( height, 0.0f );
	soleMeasureDef def = rigMeasureDef( m, terrain );
	def.seams = seams;
	solePublishedFigures figures;
	soleMessage message = { { 0 } };
	soleResult result = soleMeasurePublished( &def, NULL, &figures, &message );
	assert_string_equal( message.text, "" );
	assert_int_equal( result, sole_success );
	soleDestroyTerrain( terrain );
	return figures;
}

static solePublishedFigures measure( const rigMotion* m )
{
	return measureOn( m, 0.0f, NULL );
}

static solePublishedFigures measureSlide( const soleRig* rig, float rate, double seconds, double speed, double height )
{
	rigMotion m = makeSlide( rig, rate, seconds, speed, height );
	solePublishedFigures f = measure( &m );
	rigFreeMotion( &m );
	return f;
}

static void standingHasNoneOfThem( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	solePublishedFigures f = measureSlide( rig, 60.0f, 2.0, 0.0, 0.0 );
	const double all[] = { f.mannStep, f.mvaeStep, f.skatingRatio, f.kimodoRatio, f.kimodoHeightSpeed,
		f.kimodoContactSpeed, f.kimodoContactMax, f.physPenetration, f.physFloat, f.physSkate, f.physError,
		f.footContactScore };
	for ( int32_t i = 0; i < 12; ++i )
	{
		testNearD( all[i], 0.0, 1e-6 );
	}
	soleDestroyRig( rig );
}

static void stepsAreWeightedByHeight( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	static const double heights[] = { 0.0, 0.0125, 0.025, 0.03, 0.05 };
	for ( int32_t i = 0; i < 5; ++i )
	{
		double h = heights[i];
		solePublishedFigures f = measureSlide( rig, 60.0f, 1.0, 0.3, h );
		double mann = h < 0.025 ? 2.0 - pow( 2.0, h / 0.025 ) : 0.0;
		double mvae = h < 0.033 ? 2.0 - pow( 2.0, h / 0.033 ) : 0.0;
		// One foot of two.
		testNearD( f.mannStep, 0.5 * mann * 0.3 / 60.0, 1e-7 );
		testNearD( f.mannSpeed, 0.5 * mann * 0.3, 1e-5 );
		testNearD( f.mvaeStep, 0.5 * mvae * 0.3 / 60.0, 1e-7 );
		testNearD( f.mvaeSpeed, 0.5 * mvae * 0.3, 1e-5 );
	}
	// Half as many frames a second: twice the step, the same speed.
	testNearD( measureSlide( rig, 30.0f, 1.0, 0.3, 0.0 ).mannStep, 0.005, 1e-7 );
	testNearD( measureSlide( rig, 30.0f, 1.0, 0.3, 0.0 ).mannSpeed, 0.15, 1e-5 );
	soleDestroyRig( rig );
}

static void theHigherOfTwoFramesCountsAndHeightIsOverTheGroundBelow( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = makeSlide( rig, 60.0f, 1.0, 0.3, 0.0 );
	for ( int32_t t = 0; t < m.motion.frameCount; ++t )
	{
		float height = t % 2 == 0 ? 0.0f : 0.01f;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, height, (float)( 0.3 * t / 60.0 ) ), 0.0 );
		m.roots[t].translation.y = 1.5f;
	}
	double weight = 2.0 - pow( 2.0, 0.01 / 0.025 );
	testNearD( measureOn( &m, 1.5f, NULL ).mannStep, 0.5 * weight * 0.005, 1e-6 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void theSkatingRatioIsThatOfTwentyHertz( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	static const float rates[] = { 20.0f, 30.0f, 60.0f, 144.0f };
	for ( int32_t i = 0; i < 4; ++i )
	{
		// 40 steps of 0.05 s. Around the first and last two the mean over five is too low: nothing moves beyond the
		// ends.
		testNearD( measureSlide( rig, rates[i], 2.0, 0.6, 0.04 ).skatingRatio, 36.0 / 40.0, 1e-9 );
		testNearD( measureSlide( rig, rates[i], 2.0, 0.6, 0.06 ).skatingRatio, 0.0, 0.0 );
		testNearD( measureSlide( rig, rates[i], 2.0, 0.48, 0.0 ).skatingRatio, 0.0, 0.0 );
	}
	// 2 m/s in one step: fast enough there, not on average around it. 1.2 m/s in two neighbours neither, 1.4 m/s is.
	static const float ways[3][2] = { { 0.1f, 0.1f }, { 0.06f, 0.12f }, { 0.07f, 0.14f } };
	for ( int32_t i = 0; i < 3; ++i )
	{
		rigMotion m = rigMakeMotion( rig, 41, 20.0f );
		for ( int32_t t = 20; t < 41; ++t )
		{
			rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, ways[i][t > 20] ), 0.0 );
		}
		testNearD( measure( &m ).skatingRatio, i == 2 ? 2.0 / 40.0 : 0.0, 1e-9 );
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void toesNearTheGroundAndLabelledOnesHaveSpeeds( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = makeSlide( rig, 60.0f, 1.0, 0.3, 0.04 );
	solePublishedFigures f = measure( &m );
	testNearD( f.kimodoRatio, 0.5, 1e-9 );
	testNearD( f.kimodoHeightSpeed, 0.15, 1e-5 );
	// All four points are labelled, those of one foot move.
	testNearD( f.kimodoContactSpeed, 0.15, 1e-5 );
	testNearD( f.kimodoContactMax, 0.3, 1e-4 );
	for ( int32_t t = 0; t < m.motion.frameCount; ++t )
	{
		m.labels[2 * t] = sole_labelToe;
		m.labels[2 * t + 1] = sole_labelFlat;
	}
	testNearD( measure( &m ).kimodoContactSpeed, 0.1, 1e-5 );
	rigFreeMotion( &m );
	f = measureSlide( rig, 60.0f, 1.0, 0.3, 0.06 );
	testNearD( f.kimodoRatio, 0.0, 0.0 );
	testNearD( f.kimodoHeightSpeed, 0.0, 1e-6 );
	f = measureSlide( rig, 60.0f, 1.0, 0.19, 0.04 );
	testNearD( f.kimodoRatio, 0.0, 0.0 );
	testNearD( f.kimodoHeightSpeed, 0.095, 1e-5 );
	soleDestroyRig( rig );
}

static void speedUpwardsIsSpeed( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 61, 60.0f );
	for ( int32_t t = 0; t < 61; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, t % 2 == 0 ? 0.0f : 0.005f, 0 ), 0.0 );
	}
	solePublishedFigures f = measure( &m );
	testNearD( f.kimodoRatio, 0.5, 1e-9 );
	testNearD( f.kimodoContactMax, 0.3, 1e-4 );
	testNearD( f.mannStep, 0.0, 1e-7 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

/// The whole character at a height, moving at 0.3 m/s; one foot is 10 cm higher.
static solePublishedFigures measureWhole( const soleRig* rig, float height )
{
	rigMotion m = rigMakeMotion( rig, 61, 60.0f );
	for ( int32_t t = 0; t < 61; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, 0.1f, 0 ), 0.0 );
		m.roots[t].translation = soleVec( 0, height, (float)( 0.3 * t / 60.0 ) );
	}
	solePublishedFigures f = measure( &m );
	rigFreeMotion( &m );
	return f;
}

static void theLowestPointPenetratesFloatsOrSkates( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	solePublishedFigures f = measureWhole( rig, -0.012f );
	testNearD( f.physPenetration, 0.007, 1e-6 );
	testNearD( f.physFloat, 0.0, 0.0 );
	testNearD( f.physSkate, 0.005, 1e-6 );
	testNearD( f.physError, 0.012, 1e-6 );
	f = measureWhole( rig, 0.004f );
	testNearD( f.physPenetration, 0.0, 0.0 );
	testNearD( f.physFloat, 0.0, 0.0 );
	testNearD( f.physSkate, 0.005, 1e-6 );
	f = measureWhole( rig, 0.012f );
	testNearD( f.physPenetration, 0.0, 0.0 );
	testNearD( f.physFloat, 0.007, 1e-6 );
	testNearD( f.physSkate, 0.0, 0.0 );
	testNearD( f.physError, 0.007, 1e-6 );
	soleDestroyRig( rig );
}

/// The pelvis accelerates by forward and up, up only in the first half and down in the second; the left foot goes 2 cm
/// in 1/30 s, the right one 1 cm.
static solePublishedFigures measureAcceleration( const soleRig* rig, double forward, double up, bool turnLeft )
{
	rigMotion m = rigMakeMotion( rig, 121, 60.0f );
	for ( int32_t t = 0; t < 121; ++t )
	{
		double time = t / 60.0;
		soleTransform* pose = rigPose( &m, t );
		double after = time > 1.0 ? time - 1.0 : 0.0;
		pose[0].translation.z += (float)( 0.5 * forward * time * time );
		pose[0].translation.y += (float)( 0.5 * up * time * time - up * after * after );
		rigPutFoot( pose, 0, soleVec( 0, 0, turnLeft ? 0.0f : (float)( 0.6 * time ) ), turnLeft ? 0.4 * time : 0.0 );
		rigPutFoot( pose, 1, soleVec( 0, 0, (float)( 0.3 * time ) ), 0.0 );
	}
	solePublishedFigures f = measure( &m );
	rigFreeMotion( &m );
	return f;
}

static void feetThatMoveWhileTheBodyAcceleratesScore( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	testNearD( measureAcceleration( rig, 2.0, 0.0, false ).footContactScore, 1e4 * 0.02 * 0.01, 2e-3 );
	// Falling is no acceleration: half of the time.
	testNearD( measureAcceleration( rig, 0.0, 2.0, false ).footContactScore, 0.5 * 1e4 * 0.02 * 0.01, 4e-2 );
	// A toe that stays is a foot that stays.
	testNearD( measureAcceleration( rig, 2.0, 0.0, true ).footContactScore, 0.0, 1e-4 );
	soleDestroyRig( rig );
	soleRig* oneSided = rigMakeSided( sole_left );
	assert_true( isnan( measureAcceleration( oneSided, 2.0, 0.0, false ).footContactScore ) );
	soleDestroyRig( oneSided );
}

static void stepsAcrossSeamsAndSkippedFramesCountForNothing( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 121, 60.0f );
	bool seams[121] = { false };
	for ( int32_t t = 0; t < 121; ++t )
	{
		bool away = t >= 61;
		float shake = t < 30 && t % 2 == 0 ? 0.03f : 0.0f;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, shake + ( away ? 0.3f : 0.0f ) ), 0.0 );
		rigPose( &m, t )[0].translation.z = away ? 0.3f : 0.0f;
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, 0, shake + ( away ? 0.3f : 0.0f ) ), 0.0 );
	}
	seams[61] = true;
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	for ( int32_t i = 0; i < 2; ++i )
	{
		def.seams = i == 0 ? NULL : seams;
		def.skip = 30;
		solePublishedFigures f;
		assert_int_equal( soleMeasurePublished( &def, NULL, &f, NULL ), sole_success );
		const double found[] = { f.mannStep, f.mvaeStep, f.skatingRatio, f.kimodoRatio, f.kimodoHeightSpeed,
			f.kimodoContactMax, f.physSkate, f.footContactScore };
		for ( int32_t k = 0; k < 8; ++k )
		{
			assert_int_equal( found[k] > 1e-6, i == 0 );
		}
	}
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void badDefinitionsAreRefused( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 10, 60.0f );
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	solePublishedFigures f;
	soleMessage message = { { 0 } };
	def.labels = NULL;
	assert_int_equal( soleMeasurePublished( &def, NULL, &f, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "labels" ) );
	def.labels = m.labels;
	rigPose( &m, 6 )[3].rotation.x = nanf( "" );
	assert_int_equal( soleMeasurePublished( &def, NULL, &f, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "finite" ) );
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void failingMemoryLeavesNothingBehind( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 10, 60.0f );
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	soleResult result = sole_outOfMemory;
	for ( int32_t i = 0; i < 20 && result == sole_outOfMemory; ++i )
	{
		rigMemory memory = { .left = i };
		soleAllocator allocator = { .alloc = rigAlloc, .free = rigFree, .user = &memory };
		solePublishedFigures f;
		result = soleMeasurePublished( &def, &allocator, &f, NULL );
		assert_int_equal( memory.held, 0 );
		assert_true( i > 0 || result == sole_outOfMemory );
	}
	assert_int_equal( result, sole_success );
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( standingHasNoneOfThem ),
		cmocka_unit_test( stepsAreWeightedByHeight ),
		cmocka_unit_test( theHigherOfTwoFramesCountsAndHeightIsOverTheGroundBelow ),
		cmocka_unit_test( theSkatingRatioIsThatOfTwentyHertz ),
		cmocka_unit_test( toesNearTheGroundAndLabelledOnesHaveSpeeds ),
		cmocka_unit_test( speedUpwardsIsSpeed ),
		cmocka_unit_test( theLowestPointPenetratesFloatsOrSkates ),
		cmocka_unit_test( feetThatMoveWhileTheBodyAcceleratesScore ),
		cmocka_unit_test( stepsAcrossSeamsAndSkippedFramesCountForNothing ),
		cmocka_unit_test( badDefinitionsAreRefused ),
		cmocka_unit_test( failingMemoryLeavesNothingBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
