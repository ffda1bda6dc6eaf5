// SPDX-License-Identifier: MIT
// The ancestor "IKSetting", behaviour by behaviour; the numbers are those of its description. Filters against double
// precision.
#include "ancestor_run.h"
#include "baselines/iksetting.h"

typedef struct ikRun
{
	ancestorRun base;
	soleIkSettingSettings settings;
	soleIkSettingState state;
	soleIkSettingCurve drawn[2];
	soleIkSettingCurves curves;
} ikRun;

static ikRun run;

static void start( soleGround* ground )
{
	ancestorStart( &run.base, ground );
	run.settings = soleDefaultIkSettingSettings();
	run.state = soleDefaultIkSettingState( run.base.biped.rig );
	run.drawn[0] = ( soleIkSettingCurve ){ "LeftFoot", 1.0f };
	run.drawn[1] = ( soleIkSettingCurve ){ "RightFoot", 1.0f };
	run.curves = ( soleIkSettingCurves ){ run.drawn, 2 };
	run.base.frame.timeStep = SOLE_IKSETTING_FIXED_STEP; // one fixed step a frame
}

static void step( void )
{
	ancestorRun* b = &run.base;
	b->probeCount = soleGatherIkSetting( b->biped.rig, &run.settings, &run.state, &b->frame, b->probes, SOLE_MAX_LEGS );
	soleCastProbes( b->ground, b->probes, b->probeCount, b->hits );
	soleSolveIkSetting(
	    b->biped.rig, &run.settings, &run.state, &b->frame, &run.curves, b->hits, b->probeCount, &b->out );
	ancestorApply( b );
}

static void steps( int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		step();
	}
}

static soleGround* level( float height )
{
	return ancestorPlane( soleVec( 0.0f, height, 0.0f ), soleVec( 0.0f, 1.0f, 0.0f ) );
}

/// How far a foot was raised over its animation.
static float raise( int32_t leg )
{
	int32_t ankle = ancestorAnkle( leg );
	return ancestorPlaced( &run.base, ankle ).translation.y - ancestorAnimated( &run.base, ankle ).translation.y;
}

static soleVec3 footTurn( int32_t leg )
{
	int32_t ankle = ancestorAnkle( leg );
	return ancestorTurn( ancestorAnimated( &run.base, ankle ).rotation, ancestorPlaced( &run.base, ankle ).rotation );
}

// ------------------------------------------------------------------------------------------------------ parameters

static void defaultsAreThoseOfTheScript_2( void** state )
{
	(void)state;
	soleIkSettingSettings s = soleDefaultIkSettingSettings();
	assert_true( s.enableFeetIk && s.heightFromGroundRaycast == 1.2f && s.raycastDownDistance == 1.5f );
	assert_true( s.pelvisOffset == 0.0f && s.pelvisUpAndDownSpeed == 0.28f && s.feetToIkPositionSpeed == 0.5f );
	assert_true( s.leftFootAngleOffset == 0.0f && s.rightFootAngleOffset == 0.0f && s.useIkFeature == false );
	assert_string_equal( s.leftFootAnimVariableName, "LeftFoot" );
	assert_string_equal( s.rightFootAnimVariableName, "RightFoot" );
}

static void fittingBringsTheRaysIntoProportion_2( void** state )
{
	(void)state;
	start( NULL );
	soleTransform* bind = run.base.biped.bindPose;
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		bind[j].translation = soleScale( 0.5f, bind[j].translation );
	}
	soleDestroyRig( run.base.biped.rig );
	assert_int_equal( soleCreateRig( &run.base.biped.def, NULL, &run.base.biped.rig, NULL ), sole_success );
	soleFitIkSettingSettings( run.base.biped.rig, &run.settings );
	assert_float_equal( run.settings.heightFromGroundRaycast, 0.6f, 1e-4f );
	assert_float_equal( run.settings.raycastDownDistance, 0.75f, 1e-4f );
	ancestorEnd( &run.base );
}

static void disabledItDoesNothing_4( void** state )
{
	(void)state;
	start( level( 0.1f ) );
	run.settings.enableFeetIk = false;
	steps( 5 );
	assert_int_equal( run.base.probeCount, 0 );
	assert_memory_equal( run.base.placed, run.base.pose, sizeof run.base.pose );
	ancestorEnd( &run.base );
}

// ---------------------------------------------------------------------------------------------------------- casting

static int32_t countCastingFrames( float timeStep, int32_t frames )
{
	start( level( 0.0f ) );
	run.base.frame.timeStep = timeStep;
	int32_t count = 0;
	for ( int32_t i = 0; i < frames; ++i )
	{
		step();
		assert_true( run.base.probeCount == 0 || run.base.probeCount == 2 );
		count += run.base.probeCount > 0 ? 1 : 0;
	}
	ancestorEnd( &run.base );
	return count;
}

static void castsAreMadeFiftyTimesASecond_4( void** state )
{
	(void)state;
	assert_in_range( countCastingFrames( 1.0f / 60.0f, 600 ), 499, 502 );
	assert_in_range( countCastingFrames( 1.0f / 240.0f, 2400 ), 499, 502 );
	assert_int_equal( countCastingFrames( 1.0f / 30.0f, 300 ), 300 ); // several at once ask the same
	assert_int_equal( countCastingFrames( 0.0f, 10 ), 1 );            // no time goes by
}

static void betweenCastsTheOldGroundCounts_4_11( void** state )
{
	(void)state;
	start( level( 0.05f ) );
	run.base.frame.timeStep = 0.004f;
	steps( 100 );
	assert_float_equal( raise( 0 ), 0.05f, 1e-4f );
	ancestorSetGround( &run.base, level( 0.0f ) );
	for ( int32_t i = 0; i < 5 && run.base.probeCount == 0; ++i )
	{
		step();
	}
	assert_int_equal( run.base.probeCount, 2 );
	for ( int32_t i = 0; i < 3; ++i )
	{
		ancestorSetGround( &run.base, level( 0.1f + 0.01f * (float)i ) );
		float goal = run.state.feet[0].goalPosition.y;
		step();
		assert_int_equal( run.base.probeCount, 0 );
		assert_true( run.state.feet[0].goalPosition.y == goal );
		assert_false( ( run.base.out.legs[0].flags & (uint32_t)sole_legNoGround ) != 0 );
	}
	ancestorEnd( &run.base );
}

static void raysStartOverTheRootAboveTheShownFoot_5_6( void** state )
{
	(void)state;
	start( level( 0.1f ) );
	run.base.pose[biped_hipL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -0.9f );
	run.drawn[0].value = 1.0f;
	run.base.frame.root.translation = soleVec( 0.4f, 0.05f, 0.2f );
	run.base.frame.clipFloor = 0.02f;
	run.settings.environmentLayer = 9;
	step();
	soleVec3 shown = ancestorPlaced( &run.base, biped_ankleL ).translation;
	run.base.frame.root.translation = soleVec( 0.4f, 0.15f, 0.5f );
	run.base.pose[biped_hipL].rotation = soleQuat_Identity(); // the next animation is not known yet
	run.settings.environmentLayer = UINT32_MAX;
	step();
	const soleProbe* p = run.base.probes;
	testNear3( p->start_w, soleVec( shown.x, 0.15f + 0.02f + 1.2f, shown.z + 0.3f ), 1e-5f );
	testNear3( p->direction_w, soleVec( 0.0f, -1.0f, 0.0f ), 0.0f );
	assert_float_equal( p->length, 2.7f, 1e-6f );
	assert_true( p->radius == 0.0f && p->mask == UINT32_MAX );
	ancestorEnd( &run.base );
}

// -------------------------------------------------------------------------------------------------------------- feet

static void theFootsRaiseIsBlendedFrameByFrame_6_8( void** state )
{
	(void)state;
	start( level( 0.06f ) );
	run.settings.pelvisOffset = 0.02f;
	run.settings.feetToIkPositionSpeed = 0.3f;
	double last = 0.0;
	for ( int32_t i = 0; i < 30; ++i )
	{
		step();
		last += 0.3 * ( 0.08 - last );
		assert_float_equal( raise( 0 ), (float)last, 1e-5f );
		assert_float_equal( raise( 1 ), (float)last, 1e-5f );
	}
	ancestorEnd( &run.base );
}

/// Added, not replaced: a raised foot stays as high over the ground as it is animated over its floor.
static void theAnimatedHeightStays_8( void** state )
{
	(void)state;
	start( level( 0.06f ) );
	run.base.pose[biped_kneeL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 1.4f );
	steps( 40 );
	assert_true( ancestorAnimated( &run.base, biped_ankleL ).translation.y > 0.15f );
	assert_float_equal( raise( 0 ), 0.06f, 1e-4f );
	ancestorEnd( &run.base );
}

/// The raise is along the root's own up, and by the ground's height in the root's space.
static void theRaiseIsInTheRootsSpace_8( void** state )
{
	(void)state;
	start( level( 0.08f ) );
	run.base.frame.root.rotation = testTurn( soleVec( 0.0f, 0.0f, 1.0f ), 0.2f );
	run.base.frame.root.scale = soleVec( 1.5f, 1.5f, 1.5f );
	run.settings.feetToIkPositionSpeed = 1.0f;
	run.settings.pelvisUpAndDownSpeed = 0.0f;
	step();
	soleVec3 g = run.state.feet[0].goalPosition;
	double s = sin( 0.2 ), c = cos( 0.2 );
	double height = -s * (double)g.x + c * (double)g.y; // of g along the root's up, which is ( -s, c )
	soleVec3 animated = ancestorAnimated( &run.base, biped_ankleL ).translation;
	soleVec3 wanted = soleVec( animated.x - (float)( s * height ), animated.y + (float)( c * height ), animated.z );
	testNear3( ancestorPlaced( &run.base, biped_ankleL ).translation, wanted, 1e-5f );
	assert_float_equal( run.state.feet[0].lastHeight, (float)( height / 1.5 ), 1e-5f );
	ancestorEnd( &run.base );
}

static void afterAMissTheAnimationIsPlainAndTheRaiseIsKept_6_8( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.06f, 0.0f ), soleVec( 0.1f, 1.0f, 0.0f ) ) );
	steps( 30 );
	soleIkSettingFoot before = run.state.feet[0];
	float kept = raise( 0 );
	assert_true( kept > 0.03f );
	ancestorSetGround( &run.base, NULL );
	steps( 3 );
	assert_float_equal( raise( 0 ), 0.0f, 1e-5f );
	assert_true( run.state.feet[0].lastHeight == before.lastHeight );
	assert_memory_equal( &run.state.feet[0].goalRotation, &before.goalRotation, sizeof before.goalRotation );
	assert_true( ( run.base.out.legs[0].flags & (uint32_t)sole_legNoGround ) != 0 );
	ancestorSetGround( &run.base, ancestorPlane( soleVec( 0.0f, 0.06f, 0.0f ), soleVec( 0.1f, 1.0f, 0.0f ) ) );
	step();
	assert_float_equal( raise( 0 ), kept, 1e-3f ); // at once where it was
	ancestorEnd( &run.base );
}

// ------------------------------------------------------------------------------------------------------------ pelvis

static void theBodyIsBlendedTowardsTheLowerGround_7( void** state )
{
	(void)state;
	start( ancestorStep( -0.12f, 0.05f ) );
	run.base.frame.root.translation.y = -0.02f;
	step();
	assert_float_equal( ancestorBody( &run.base ), 0.0f, 1e-6f ); // the first frame only stores
	double stored = (double)ancestorAnimated( &run.base, biped_pelvis ).translation.y;
	for ( int32_t i = 0; i < 40; ++i )
	{
		run.base.pose[biped_pelvis].translation.y += i % 2 == 0 ? 0.01f : -0.01f; // the bob is slowed down too
		step();
		double animated = (double)ancestorAnimated( &run.base, biped_pelvis ).translation.y;
		stored += 0.28 * ( animated + ( -0.12 - -0.02 ) - stored );
		assert_float_equal( ancestorBody( &run.base ), (float)( stored - animated ), 1e-5f );
	}
	ancestorEnd( &run.base );
}

static void groundOverTheRootLiftsTheBodyByTheSmaller_7( void** state )
{
	(void)state;
	start( ancestorStep( 0.05f, 0.12f ) );
	steps( 60 );
	assert_float_equal( ancestorBody( &run.base ), 0.05f, 1e-4f );
	ancestorEnd( &run.base );
}

static void withoutGroundUnderBothFeetTheBodyStays_7( void** state )
{
	(void)state;
	start( ancestorStep( -0.1f, -0.1f ) );
	steps( 30 );
	assert_float_equal( ancestorBody( &run.base ), -0.1f, 1e-3f );
	run.base.frame.root.translation.x = 8.95f; // the left foot is over nothing
	steps( 2 );
	assert_false( run.base.hits[0].hit );
	assert_true( run.base.hits[1].hit );
	assert_float_equal( ancestorBody( &run.base ), 0.0f, 1e-6f );
	// What is stored is the animated height: from there it goes on.
	run.base.frame.root.translation.x = 0.0f;
	step();
	assert_float_equal( ancestorBody( &run.base ), -0.028f, 1e-4f );
	ancestorEnd( &run.base );
}

static void zeroCountsAsNone_7_11( void** state )
{
	(void)state;
	// Ground that is met at the world's origin.
	start( level( 0.0f ) );
	soleVec3 foot = ancestorAnimated( &run.base, biped_ankleL ).translation;
	run.base.frame.root.translation = soleVec( -foot.x, -0.1f, -foot.z );
	step();
	testNear3( run.base.hits[0].point_w, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	assert_true( run.base.hits[0].hit );
	assert_float_equal( raise( 0 ), 0.0f, 1e-6f );
	assert_float_equal( raise( 1 ), 0.05f, 1e-5f );
	ancestorEnd( &run.base );
	// A body whose stored height is zero.
	start( ancestorStep( -0.9f, -0.9f ) );
	run.base.frame.root.translation.y = -run.base.pose[biped_pelvis].translation.y;
	steps( 5 );
	assert_true( run.state.lastPelvisHeight == 0.0f );
	assert_true( ancestorBody( &run.base ) == 0.0f );
	ancestorEnd( &run.base );
}

// ---------------------------------------------------------------------------------------------- weights and rotation

static void placesAreWeightedByTheCurvesAsTheyAre_9( void** state )
{
	(void)state;
	start( level( 0.08f ) );
	run.settings.pelvisUpAndDownSpeed = 0.0f;
	steps( 30 );
	const float values[] = { 0.0f, 1.0f, 0.4f };
	for ( int32_t i = 0; i < 3; ++i )
	{
		run.drawn[0].value = values[i];
		step();
		assert_float_equal( raise( 0 ), values[i] * 0.08f, 1e-4f );
		assert_float_equal( raise( 1 ), 0.08f, 1e-4f );
		assert_true( run.base.out.legs[0].plantWeight == values[i] );
	}
	run.drawn[1].name = "Right"; // no curve of that name: no weight
	step();
	assert_float_equal( raise( 1 ), 0.0f, 1e-5f );
	run.settings.rightFootAnimVariableName = "Right";
	step();
	assert_float_equal( raise( 1 ), 0.08f, 1e-4f );
	ancestorEnd( &run.base );
}

static void theHostsWeightsComeOnTop_9( void** state )
{
	(void)state;
	start( level( -0.05f ) );
	const float own[] = { 0.5f, 1.0f };
	run.base.frame.legWeight = own;
	run.base.frame.weight = 0.8f;
	steps( 60 );
	assert_float_equal( ancestorBody( &run.base ), -0.04f, 1e-4f );
	assert_float_equal( run.base.out.legs[0].plantWeight, 0.4f, 1e-6f );
	run.base.frame.weight = 0.0f;
	step();
	assert_float_equal( ancestorBody( &run.base ), 0.0f, 0.0f );
	assert_float_equal( raise( 0 ), 0.0f, 1e-6f );
	ancestorEnd( &run.base );
}

static void feetTurnOnlyWithTheFeature_9( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( -0.2f, 1.0f, 0.0f ) ) );
	steps( 5 );
	assert_true( soleLength( footTurn( 0 ) ) < 1e-5f );
	run.settings.useIkFeature = true;
	step();
	assert_float_equal( footTurn( 0 ).z, -atanf( -0.2f ), 2e-3f );
	run.drawn[0].value = 0.5f;
	step();
	assert_float_equal( footTurn( 0 ).z, -0.5f * atanf( -0.2f ), 2e-3f );
	ancestorEnd( &run.base );
}

/// R( Y, offset ) FromTo( Y, n ) root, put before the foot of the bind pose: the animated heading and pitch are lost.
static void aTurnedFootHasTheRootsHeading_6_11( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( 0.1f, 1.0f, -0.2f ) ) );
	run.settings.useIkFeature = true;
	run.settings.leftFootAngleOffset = 30.0f;
	run.base.frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.7f );
	ancestorPitchFeet( &run.base, 0.4f );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleTransform* ankle = run.base.pose + ancestorAnkle( i );
		ankle->rotation = soleMulQuat( testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.5f ), ankle->rotation );
	}
	step();
	soleVec3 y = soleVec( 0.0f, 1.0f, 0.0f );
	soleVec3 n = soleNormalizeOr( soleVec( 0.1f, 1.0f, -0.2f ), y );
	soleQuat slope = testTurn( soleNormalizeOr( soleCross( y, n ), y ), acosf( n.y ) );
	for ( int32_t i = 0; i < 2; ++i )
	{
		int32_t ankle = ancestorAnkle( i );
		soleQuat bind = testJoint( &run.base.biped, run.base.biped.bindPose, soleTransform_Identity(), ankle ).rotation;
		soleQuat wanted = soleMulQuat( slope, soleMulQuat( run.base.frame.root.rotation, bind ) );
		wanted = i == 0 ? soleMulQuat( testTurn( y, 0.52359878f ), wanted ) : wanted;
		soleQuat placed = ancestorPlaced( &run.base, ankle ).rotation;
		assert_true( soleLength( ancestorTurn( wanted, placed ) ) < 1e-4f );
	}
	ancestorEnd( &run.base );
}

/// A foot whose joint stands in any way: what the goal turns is the foot of the bind pose.
static void howTheFootsJointStandsDropsOut_6( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( 0.1f, 1.0f, -0.2f ) ) );
	soleQuat odd = soleNormalizeQuat( ( soleQuat ){ 0.6f, -0.5f, 0.3f, 0.4f } );
	run.base.biped.bindPose[biped_ankleL].rotation = odd;
	run.base.pose[biped_ankleL].rotation = odd;
	soleDestroyRig( run.base.biped.rig );
	assert_int_equal( soleCreateRig( &run.base.biped.def, NULL, &run.base.biped.rig, NULL ), sole_success );
	run.state = soleDefaultIkSettingState( run.base.biped.rig );
	run.settings.useIkFeature = true;
	step();
	soleQuat bind =
	    testJoint( &run.base.biped, run.base.biped.bindPose, soleTransform_Identity(), biped_ankleL ).rotation;
	soleQuat placed = ancestorPlaced( &run.base, biped_ankleL ).rotation;
	soleVec3 y = soleVec( 0.0f, 1.0f, 0.0f );
	soleQuat slope = soleFromTo( y, soleNormalizeOr( soleVec( 0.1f, 1.0f, -0.2f ), y ), y );
	assert_true( soleLength( ancestorTurn( soleMulQuat( slope, bind ), placed ) ) < 1e-4f );
	ancestorEnd( &run.base );
}

static void lerpsPerFrameDependOnTheFrameRate_11( void** state )
{
	(void)state;
	float reached[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		start( level( 0.08f ) );
		run.base.frame.timeStep = k == 0 ? 0.04f : 0.01f;
		steps( k == 0 ? 2 : 8 );
		reached[k] = raise( 0 );
		ancestorEnd( &run.base );
	}
	assert_float_equal( reached[0], 0.06f, 1e-4f );
	assert_true( reached[1] > 0.079f );
}

static void theSameInputGivesTheSameResult_12( void** state )
{
	(void)state;
	soleOutput outs[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		start( ancestorStep( 0.03f, -0.04f ) );
		run.base.frame.timeStep = 0.013f;
		steps( 40 );
		outs[k] = run.base.out;
		ancestorEnd( &run.base );
	}
	for ( int32_t i = 0; i < 2; ++i )
	{
		assert_memory_equal(
		    outs[0].legs[i].rotations_l, outs[1].legs[i].rotations_l, sizeof outs[0].legs[i].rotations_l );
	}
	assert_memory_equal(
	    &outs[0].pelvisTranslation_l, &outs[1].pelvisTranslation_l, sizeof outs[0].pelvisTranslation_l );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( defaultsAreThoseOfTheScript_2 ),
		cmocka_unit_test( fittingBringsTheRaysIntoProportion_2 ),
		cmocka_unit_test( disabledItDoesNothing_4 ),
		cmocka_unit_test( castsAreMadeFiftyTimesASecond_4 ),
		cmocka_unit_test( betweenCastsTheOldGroundCounts_4_11 ),
		cmocka_unit_test( raysStartOverTheRootAboveTheShownFoot_5_6 ),
		cmocka_unit_test( theFootsRaiseIsBlendedFrameByFrame_6_8 ),
		cmocka_unit_test( theAnimatedHeightStays_8 ),
		cmocka_unit_test( theRaiseIsInTheRootsSpace_8 ),
		cmocka_unit_test( afterAMissTheAnimationIsPlainAndTheRaiseIsKept_6_8 ),
		cmocka_unit_test( theBodyIsBlendedTowardsTheLowerGround_7 ),
		cmocka_unit_test( groundOverTheRootLiftsTheBodyByTheSmaller_7 ),
		cmocka_unit_test( withoutGroundUnderBothFeetTheBodyStays_7 ),
		cmocka_unit_test( zeroCountsAsNone_7_11 ),
		cmocka_unit_test( placesAreWeightedByTheCurvesAsTheyAre_9 ),
		cmocka_unit_test( theHostsWeightsComeOnTop_9 ),
		cmocka_unit_test( feetTurnOnlyWithTheFeature_9 ),
		cmocka_unit_test( aTurnedFootHasTheRootsHeading_6_11 ),
		cmocka_unit_test( howTheFootsJointStandsDropsOut_6 ),
		cmocka_unit_test( lerpsPerFrameDependOnTheFrameRate_11 ),
		cmocka_unit_test( theSameInputGivesTheSameResult_12 ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
