// SPDX-License-Identifier: MIT
// Figures of knees, pelvis and reach of motions made so that each is known beforehand; and what no figure depends on:
// seams, skipped frames, and which way is up.
#include "measure_rig.h"

#define PI 3.14159265358979323846

static void kneeAccelerationIsThatOfASine( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	float rates[3] = { 30.0f, 60.0f, 144.0f };
	double amplitude = 0.3;
	double w = 2.0 * PI * 1.5;
	for ( int32_t i = 0; i < 3; ++i )
	{
		int32_t count = (int32_t)( 4.0f * rates[i] ) + 2; // six periods
		rigMotion m = rigMakeMotion( rig, count, rates[i] );
		for ( int32_t t = 0; t < count; ++t )
		{
			double time = t / (double)rates[i];
			rigPose( &m, t )[2].rotation = rigTurnX( 0.6 + amplitude * sin( w * time ) );
		}
		soleFigures f = rigMeasure( &m );
		// The second difference of a sine is the sine times this, which goes to w^2 as the rate grows.
		double factor = 2.0 * ( 1.0 - cos( w / (double)rates[i] ) ) * (double)rates[i] * (double)rates[i];
		testNearD( f.legs[0].kneeAccelerationRms, amplitude * factor / sqrt( 2.0 ), 1e-3 * factor );
		testNearD( f.legs[0].kneeAccelerationMax, amplitude * factor, 1e-2 * factor );
		testNearD( f.legs[1].kneeAccelerationRms, 0.0, 1e-4 );
		testNearD( f.all.kneeAccelerationRms, f.legs[0].kneeAccelerationRms / sqrt( 2.0 ), 1e-3 );
		// Its largest step between two frames, and the same joint's largest jump.
		double jump = 2.0 * amplitude * sin( 0.5 * w / (double)rates[i] );
		testNearD( f.legs[0].largestJump, jump, 0.02 * jump );
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void pelvisJerkIsThatOfASine( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	double w = 2.0 * PI * 2.0;
	int32_t count = 243; // eight periods and the three frames of a difference
	rigMotion m = rigMakeMotion( rig, count, 60.0f );
	for ( int32_t t = 0; t < count; ++t )
	{
		m.roots[t].translation.y = (float)( 0.02 * sin( w * t / 60.0 ) );
	}
	soleFigures f = rigMeasure( &m );
	double factor = pow( 2.0 * sin( 0.5 * w / 60.0 ) * 60.0, 3.0 );
	testNearD( f.pelvisJerk, 0.02 * factor / sqrt( 2.0 ), 1e-3 * 0.02 * factor );
	testNearD( f.pelvisLargestStep, 2.0 * 0.02 * sin( 0.5 * w / 60.0 ), 5e-5 );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void overExtensionCountsOnlyWhereTheReferenceIsBent( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 30, 60.0f );
	rigMotion reference = rigMakeMotion( rig, 30, 60.0f );
	for ( int32_t t = 0; t < 30; ++t )
	{
		// The rig stands with straight legs; bend what is not meant to be straight.
		rigPose( &m, t )[2].rotation = rigTurnX( t < 10 ? 0.0 : 0.3 );
		rigPose( &m, t )[6].rotation = rigTurnX( 0.3 );
		rigPose( &reference, t )[2].rotation = rigTurnX( t < 4 ? 0.0 : 0.3 );
	}
	soleFigures f = rigMeasureOn( &m, NULL, 0.0f, 0.0f );
	assert_int_equal( f.legs[0].overExtended, 10 );
	assert_int_equal( f.legs[1].overExtended, 0 );
	f = rigMeasureOn( &m, &reference, 0.0f, 0.0f );
	assert_int_equal( f.legs[0].overExtended, 6 );
	assert_int_equal( f.all.overExtended, 6 );
	rigFreeMotion( &m );
	rigFreeMotion( &reference );
	soleDestroyRig( rig );
}

static void deviationIsTheAngleToTheReference( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 30, 60.0f );
	rigMotion reference = rigMakeMotion( rig, 30, 60.0f );
	for ( int32_t t = 0; t < 30; ++t )
	{
		for ( int32_t joint = 1; joint < RIG_JOINTS; ++joint )
		{
			rigPose( &m, t )[joint].rotation = rigTurnX( joint % 2 == 0 ? 0.2 : -0.2 );
		}
	}
	testNearD( rigMeasureOn( &m, &reference, 0.0f, 0.0f ).deviation, 0.2, 1e-6 );
	testNearD( rigMeasureOn( &m, NULL, 0.0f, 0.0f ).deviation, 0.0, 0.0 );
	rigFreeMotion( &m );
	rigFreeMotion( &reference );
	soleDestroyRig( rig );
}

static void pelvisOffsetIsAgainstTheReferencesOwnRoot( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 40, 60.0f );
	rigMotion reference = rigMakeMotion( rig, 40, 60.0f );
	for ( int32_t t = 0; t < 40; ++t )
	{
		// The motion is turned, up a hill and elsewhere; its pelvis is 3 cm lower, for ten frames 5 cm back besides.
		m.roots[t].translation = soleVec( 3.0f, 0.1f * (float)t, -2.0f );
		m.roots[t].rotation = ( soleQuat ){ 0.0f, 0.6f, 0.0f, 0.8f };
		rigPose( &m, t )[0].translation.y -= t < 10 ? 0.0f : 0.03f;
		rigPose( &m, t )[0].translation.z -= t >= 30 ? 0.04f : 0.0f;
	}
	soleFigures f = rigMeasureOn( &m, &reference, 0.0f, 0.0f );
	testNearD( f.pelvisOffsetMax, 0.05, 1e-6 );
	testNearD( f.pelvisOffsetRms, sqrt( 0.5 * 0.03 * 0.03 + 0.25 * 0.05 * 0.05 ), 1e-6 );
	testNearD( rigMeasureOn( &m, NULL, 0.0f, 0.0f ).pelvisOffsetMax, 0.0, 0.0 );
	rigFreeMotion( &m );
	rigFreeMotion( &reference );
	soleDestroyRig( rig );
}

static void differencesAcrossASeamCountForNothing( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	bool seams[60] = { false };
	for ( int32_t t = 30; t < 60; ++t )
	{
		// Everything is elsewhere at once, and then stands still again.
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, 0.1f ), 0.0 );
		rigPose( &m, t )[2].rotation = rigTurnX( 0.4 );
		rigPose( &m, t )[6].rotation = rigTurnX( 0.4 );
		m.roots[t].translation.y = 0.05f;
	}
	seams[30] = true;
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	for ( int32_t i = 0; i < 2; ++i )
	{
		def.seams = i == 0 ? NULL : seams;
		soleFigures f;
		assert_int_equal( soleMeasureMotion( &def, NULL, &f, NULL ), sole_success );
		const double found[] = { f.all.slide, f.all.largestJump, f.all.kneeAccelerationMax, f.pelvisJerk,
			f.pelvisLargestStep };
		for ( int32_t k = 0; k < 5; ++k )
		{
			assert_int_equal( found[k] > 1e-5, i == 0 );
		}
	}
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void skippedFramesCountForNothing( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	for ( int32_t t = 0; t < 30; ++t )
	{
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, t % 2 == 0 ? -0.1f : 0.1f, 0.01f * (float)( t % 3 ) ), 0.3 );
		m.roots[t].translation.y = t % 2 == 0 ? 0.01f : 0.0f;
		rigPose( &m, t )[6].rotation = rigTurnX( t % 2 == 0 ? 0.4 : 0.0 );
	}
	soleTerrain* terrain = rigMakePlane( 0.0f, 0.0f );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	def.skip = 30;
	soleFigures f;
	assert_int_equal( soleMeasureMotion( &def, NULL, &f, NULL ), sole_success );
	assert_int_equal( f.all.labelledFrames, 60 );
	testNearD( f.all.penetration.max, 0.0, 1e-6 );
	testNearD( f.all.hover.max, 0.0, 1e-6 );
	testNearD( f.all.slide, 0.0, 1e-6 );
	testNearD( f.all.drift.max, 0.0, 1e-6 );
	testNearD( f.all.largestJump, 0.0, 1e-6 );
	testNearD( f.all.kneeAccelerationMax, 0.0, 1e-6 );
	testNearD( f.pelvisJerk, 0.0, 1e-6 );
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void figuresDoNotDependOnWhichWayIsUp( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 120, 60.0f );
	gaitFill( &m, 1.3, 0.004f, false );
	soleLabelDef labelDef = soleDefaultLabelDef();
	assert_int_equal( soleLabelContacts( &m.motion, &labelDef, NULL, m.labels ), sole_success );
	soleFigures a = rigMeasure( &m );
	assert_true( a.all.stances >= 4 );

	soleQuat turn = soleNormalizeQuat( ( soleQuat ){ 0.4f, -0.3f, 0.7f, 0.2f } );
	for ( int32_t t = 0; t < 120; ++t )
	{
		m.roots[t].rotation = turn;
		m.roots[t].translation = soleRotate( turn, m.roots[t].translation );
	}
	m.motion.up = soleRotate( turn, soleVec( 0.0f, 1.0f, 0.0f ) );
	float positions[12] = { 0 };
	for ( int32_t i = 0; i < 4; ++i )
	{
		soleVec3 p = soleRotate( turn, soleVec( i < 2 ? -20.0f : 20.0f, 0.0f, i == 1 || i == 2 ? 20.0f : -20.0f ) );
		memcpy( positions + 3 * i, &p, sizeof p );
	}
	uint32_t indices[] = { 0, 1, 2, 0, 2, 3 };
	soleTerrain* terrain = NULL;
	assert_int_equal( soleCreateTerrain( positions, 4, indices, 2, m.motion.up, NULL, &terrain, NULL ), sole_success );
	soleMeasureDef def = rigMeasureDef( &m, terrain );
	soleFigures b;
	assert_int_equal( soleMeasureMotion( &def, NULL, &b, NULL ), sole_success );
	testNearD( b.all.penetration.p95, a.all.penetration.p95, 1e-5 );
	testNearD( b.all.hover.mean, a.all.hover.mean, 1e-5 );
	testNearD( b.all.slide, a.all.slide, 1e-4 );
	testNearD( b.all.drift.max, a.all.drift.max, 1e-5 );
	testNearD( b.all.contactShare, a.all.contactShare, 1e-2 );
	testNearD( b.all.largestJump, a.all.largestJump, 1e-5 );
	soleDestroyTerrain( terrain );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( kneeAccelerationIsThatOfASine ),
		cmocka_unit_test( pelvisJerkIsThatOfASine ),
		cmocka_unit_test( overExtensionCountsOnlyWhereTheReferenceIsBent ),
		cmocka_unit_test( deviationIsTheAngleToTheReference ),
		cmocka_unit_test( pelvisOffsetIsAgainstTheReferencesOwnRoot ),
		cmocka_unit_test( differencesAcrossASeamCountForNothing ),
		cmocka_unit_test( skippedFramesCountForNothing ),
		cmocka_unit_test( figuresDoNotDependOnWhichWayIsUp ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
