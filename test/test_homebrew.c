// SPDX-License-Identifier: MIT
// The ancestor "Homebrew", behaviour by behaviour: parameters, casts, the height that is wanted, lifting. The numbers
// are those of its description. Heights against double precision, with the trigonometry that the description uses.
#include "homebrew_run.h"

// ------------------------------------------------------------------------------------------------------ parameters

static void goalsAreThoseOfTheFrameAndDoNotAddUp_2( void** state )
{
	(void)state;
	start( level( 0.0f ) );
	run.settings.enableWorldHeightOffset = true;
	run.settings.worldHeightOffset = 0.05f;
	steps( 300 );
	assert_float_equal( placedHeight( 0 ), (float)ANKLE + 0.05f, 1e-5f );
	ancestorEnd( &run.base );
}

static void onlyTheAnkleCounts_3( void** state )
{
	(void)state;
	soleGround* slope = ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( 0.1f, 1.0f, -0.2f ) );
	start( slope );
	ancestorPitchFeet( &run.base, 0.3f );
	steps( 20 );
	soleOutput plain = run.base.out;
	run.base.pose[biped_toeL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 0.7f );
	run.base.pose[biped_toeL].translation.z = 0.3f;
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleSolePoints* sole = &run.base.biped.def.legs[i].sole;
		sole->heel.y = sole->toe.y = sole->ball.y = sole->inner.y = sole->outer.y = -0.1f;
		sole->toe.z = 0.5f;
	}
	soleDestroyRig( run.base.biped.rig );
	assert_int_equal( soleCreateRig( &run.base.biped.def, NULL, &run.base.biped.rig, NULL ), sole_success );
	restart();
	steps( 20 );
	for ( int32_t i = 0; i < 2; ++i )
	{
		assert_memory_equal(
		    run.base.out.legs[i].rotations_l, plain.legs[i].rotations_l, sizeof plain.legs[i].rotations_l );
	}
	ancestorEnd( &run.base );
}

/// A foot that stands on its toes in the bind pose, as in a high heel, is level in that pose.
static void howTheFootStandsAtTheStartDropsOut_3_5( void** state )
{
	(void)state;
	start( level( 0.0f ) );
	ancestorPitchFeet( &run.base, 0.6f );
	for ( int32_t i = 0; i < 2; ++i )
	{
		int32_t ankle = ancestorAnkle( i );
		run.base.biped.bindPose[ankle].rotation =
		    soleMulQuat( testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 0.6f ), run.base.biped.bindPose[ankle].rotation );
	}
	step();
	assert_true( placedHeight( 0 ) > (float)ANKLE + 0.1f );
	soleDestroyRig( run.base.biped.rig );
	assert_int_equal( soleCreateRig( &run.base.biped.def, NULL, &run.base.biped.rig, NULL ), sole_success );
	restart();
	step();
	assert_float_equal( placedHeight( 0 ), (float)ANKLE, 1e-5f );
	ancestorEnd( &run.base );
}

static void defaultsAreThoseThatWereShown_4( void** state )
{
	(void)state;
	soleHomebrewSettings s = soleDefaultHomebrewSettings();
	assert_true( s.floorRange == 0.1f && s.crouchRange == 0.25f && s.stretchRange == 0.0f );
	assert_true( s.worldHeightOffset == 0.0f && s.groundLayers == 0 );
	start( level( 0.0f ) );
	step();
	assert_int_equal( run.base.probes[0].mask, 1 ); // none chosen: the lowest layer
	run.settings.groundLayers = 6;
	step();
	assert_int_equal( run.base.probes[0].mask, 6 );
	ancestorEnd( &run.base );
}

static void fittingMeasuresTheCharacter_4( void** state )
{
	(void)state;
	start( level( 0.0f ) );
	soleFitHomebrewSettings( run.base.biped.rig, &run.settings );
	assert_float_equal( run.settings.raySphereRadius + run.settings.ankleHeightOffset, 0.08f, 1e-5f );
	assert_float_equal( run.settings.lengthFromHeelToToes, 0.26f, 1e-5f );
	assert_float_equal( run.settings.rayCastRange, 1.2f, 1e-3f );
	soleTransform* bind = run.base.biped.bindPose;
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		bind[j].translation = soleScale( 3.0f, bind[j].translation );
	}
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleSolePoints* sole = &run.base.biped.def.legs[i].sole;
		soleVec3* points[] = { &sole->heel, &sole->ball, &sole->toe, &sole->inner, &sole->outer };
		for ( int32_t k = 0; k < 5; ++k )
		{
			*points[k] = soleScale( 3.0f, *points[k] );
		}
	}
	soleHomebrewSettings small = run.settings;
	soleDestroyRig( run.base.biped.rig );
	assert_int_equal( soleCreateRig( &run.base.biped.def, NULL, &run.base.biped.rig, NULL ), sole_success );
	soleFitHomebrewSettings( run.base.biped.rig, &run.settings );
	const float* a = &small.raySphereRadius;
	const float* b = &run.settings.raySphereRadius;
	assert_float_equal( *b, 3.0f * *a, 1e-5f );
	assert_float_equal( run.settings.ankleHeightOffset, 3.0f * small.ankleHeightOffset, 1e-5f );
	assert_float_equal( run.settings.lengthFromHeelToToes, 3.0f * small.lengthFromHeelToToes, 1e-5f );
	assert_float_equal( run.settings.rayCastRange, 3.0f * small.rayCastRange, 1e-5f );
	assert_float_equal( run.settings.leftFootRaycastStartHeight, 3.0f * small.leftFootRaycastStartHeight, 1e-5f );
	assert_float_equal( run.settings.rightFootRaycastStartHeight, 3.0f * small.rightFootRaycastStartHeight, 1e-5f );
	assert_float_equal( run.settings.floorRange, 3.0f * small.floorRange, 1e-5f );
	assert_float_equal( run.settings.crouchRange, 3.0f * small.crouchRange, 1e-5f );
	ancestorEnd( &run.base );
}

// ------------------------------------------------------------------------------------------------------------ casts

static void aSphereIsCastDownOverEachAnkle_7( void** state )
{
	(void)state;
	start( level( 0.0f ) );
	run.settings.rightFootRaycastStartHeight = 0.7f;
	step();
	assert_int_equal( run.base.probeCount, 2 );
	for ( int32_t i = 0; i < 2; ++i )
	{
		const soleProbe* p = run.base.probes + i;
		soleVec3 ankle = ancestorAnimated( &run.base, ancestorAnkle( i ) ).translation;
		ankle.y += i == 0 ? 0.5f : 0.7f;
		testNear3( p->start_w, ankle, 1e-5f );
		testNear3( p->direction_w, soleVec( 0.0f, -1.0f, 0.0f ), 0.0f );
		assert_true( p->length == 1.2f && p->radius == 0.05f && p->leg == i );
	}
	ancestorEnd( &run.base );
}

static void whereNothingIsMetTheRootsHeightCounts_7( void** state )
{
	(void)state;
	start( NULL );
	run.base.frame.root.translation = soleVec( 2.0f, 1.0f, 3.0f );
	run.base.frame.clipFloor = 0.04f; // where the clip itself has its floor
	step();
	assert_float_equal( placedHeight( 0 ), 1.04f + (float)ANKLE, 1e-5f );
	assert_true( soleLength( footTurn( 0 ) ) < 1e-5f );
	assert_true( ( run.base.out.legs[0].flags & (uint32_t)sole_legNoGround ) != 0 );
	ancestorEnd( &run.base );
}

/// Over the edge of a step the sphere rests on the edge, and its normal turns with the distance from it.
static void theNormalTurnsSmoothlyOverAnEdge_7( void** state )
{
	(void)state;
	for ( int32_t i = 1; i < 10; ++i )
	{
		float beside = 0.005f * (float)i;
		start( ancestorStep( -0.2f, 0.0f ) );
		run.base.frame.root.translation.x = -0.09f - beside;
		run.settings.maxRotationAngle = 90.0f;
		step();
		double lean = asin( (double)beside / 0.05 );
		soleVec3 turn = footTurn( 0 );
		assert_float_equal( turn.z, (float)lean, 1e-3f );
		ancestorEnd( &run.base );
	}
}

static void castsStartFromTheBoneAsItWasShown_19( void** state )
{
	(void)state;
	start( level( 0.15f ) );
	step();
	float shown = placedHeight( 0 );
	assert_true( shown > animatedHeight( 0 ) + 0.02f );
	run.base.frame.root.translation = soleVec( 0.3f, 0.01f, 0.2f );
	step();
	soleVec3 start_w = run.base.probes[0].start_w;
	testNear3( start_w, soleVec( 0.39f, shown + 0.01f + 0.5f, start_w.z ), 1e-5f );
	ancestorEnd( &run.base );
}

// ----------------------------------------------------------------------------------------------------------- height

/// What the description says, in its own terms.
static double oracleRise( double pitch, double slopeX, double slopeZ, double length )
{
	double f[3] = { 0.0, -sin( pitch ), cos( pitch ) };
	double n[3] = { -slopeX, 1.0, -slopeZ };
	double size = sqrt( n[0] * n[0] + n[1] * n[1] + n[2] * n[2] );
	double theta = -asin( f[1] );
	// f lies in the plane x = 0, so the axis across is x.
	bool hasAxis = fabs( f[1] * f[2] ) > 0.0;
	double m[3] = { hasAxis ? 0.0 : n[0] / size, n[1] / size, n[2] / size };
	double phi = acos( m[1] / sqrt( m[0] * m[0] + m[1] * m[1] + m[2] * m[2] ) );
	double alpha = theta - phi;
	return alpha > 0.0 ? length * sin( alpha ) : 0.0;
}

static void theAnkleRisesByThePitchOfTheAnimationAlone_8_9_10_11( void** state )
{
	(void)state;
	uint32_t seed = 1;
	int32_t risen = 0;
	for ( int32_t i = 0; i < 300; ++i )
	{
		float slopeX = testRandomFloat( &seed, -0.3f, 0.3f );
		float slopeZ = testRandomFloat( &seed, -0.4f, 0.4f );
		float pitch = testRandomFloat( &seed, -0.6f, 0.8f );
		start( NULL );
		soleVec3 foot = ancestorAnimated( &run.base, biped_ankleL ).translation;
		ancestorSetGround(
		    &run.base, ancestorPlane( soleVec( foot.x, 0.0f, foot.z ), soleVec( -slopeX, 1.0f, -slopeZ ) ) );
		ancestorPitchFeet( &run.base, pitch );
		run.settings.enableFootLifting = false;
		step();
		// The sphere touches beside the place under its middle.
		double r = (double)run.settings.raySphereRadius;
		double size = sqrt( 1.0 + (double)slopeX * (double)slopeX + (double)slopeZ * (double)slopeZ );
		double touch = r * size - r / size;
		double rise = oracleRise( (double)pitch, (double)slopeX, (double)slopeZ, 0.19 );
		assert_float_equal( run.base.out.legs[0].ankleTarget_w.y, (float)( touch + ANKLE + rise ), 2e-5f );
		risen += rise > 0.0 ? 1 : 0;
		ancestorEnd( &run.base );
	}
	assert_true( risen > 50 && risen < 250 );
}

static void aLevelFootIsNotRaisedByItsSlope_9_10( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( 0.3f, 1.0f, 0.0f ) ) );
	run.settings.enableFootLifting = false;
	step();
	double height = -0.3 * (double)run.base.hits[0].point_w.x + ANKLE;
	assert_float_equal( run.base.out.legs[0].ankleTarget_w.y, (float)height, 1e-5f );
	ancestorEnd( &run.base );
}

static void radiusAndOffsetTogetherAreTheAnklesHeight_11( void** state )
{
	(void)state;
	start( level( 0.02f ) );
	run.settings.raySphereRadius = 0.07f;
	run.settings.ankleHeightOffset = -0.01f;
	run.settings.worldHeightOffset = 0.5f; // its switch is off
	step();
	assert_float_equal( placedHeight( 0 ), 0.02f + 0.06f, 1e-5f );
	ancestorEnd( &run.base );
}

// ---------------------------------------------------------------------------------------------------------- lifting

/// The animated ankle over its resting place.
static float targetWhenLifted( float over )
{
	start( level( 0.0f ) );
	testBendKnees( run.base.pose, 1.6f ); // so that the foot reaches down
	run.base.frame.root.translation.y = over - ( animatedHeight( 0 ) - (float)ANKLE );
	run.settings.enableBodyPositioning = false;
	step();
	float height = placedHeight( 0 );
	ancestorEnd( &run.base );
	return height;
}

static void aFootThatIsRaisedByTheFloorRangeIsLetGo_12( void** state )
{
	(void)state;
	assert_float_equal( targetWhenLifted( 0.02f ), (float)ANKLE, 1e-5f );
	assert_float_equal( targetWhenLifted( 0.099f ), (float)ANKLE, 1e-5f );
	assert_float_equal( targetWhenLifted( 0.101f ), (float)ANKLE + 0.101f, 1e-5f );
	assert_float_equal( targetWhenLifted( 0.3f ), (float)ANKLE + 0.3f, 1e-5f );
}

static void withoutTheSwitchAFootIsAlwaysPutDown_12( void** state )
{
	(void)state;
	start( level( -0.15f ) );
	run.settings.enableFootLifting = false;
	step();
	assert_float_equal( placedHeight( 0 ), -0.15f + (float)ANKLE, 1e-5f );
	ancestorEnd( &run.base );
}

static void weightsChangeNothingWhileAFootIsLifted_12( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < 3; ++i )
	{
		start( level( -0.2f ) );
		run.settings.enableBodyPositioning = false;
		run.settings.globalWeight = 0.5f * (float)i;
		steps( 5 );
		assert_float_equal( placedHeight( 0 ), animatedHeight( 0 ), 1e-5f );
		assert_true( run.base.out.legs[0].plantWeight == 0.0f );
		ancestorEnd( &run.base );
	}
}

/// A foot on a lower step is not taken for lifted as long as the body follows it.
static void aFootOnALowerStepStands_12_19( void** state )
{
	(void)state;
	for ( int32_t follows = 0; follows < 2; ++follows )
	{
		start( ancestorStep( 0.0f, -0.15f ) );
		run.settings.enableBodyPositioning = follows == 1;
		steps( 90 );
		assert_float_equal( placedHeight( 1 ), (float)ANKLE, 1e-4f );
		float left = follows == 1 ? -0.15f + (float)ANKLE : animatedHeight( 0 );
		assert_float_equal( placedHeight( 0 ), left, 1e-4f );
		ancestorEnd( &run.base );
	}
}

static void lettingGoIsSmoothAndTheFootGoesOnTurning_12( void** state )
{
	(void)state;
	start( ancestorPlane( soleVec( 0.0f, 0.0f, 0.0f ), soleVec( 0.0f, 1.0f, -0.2f ) ) );
	run.settings.enableBodyPositioning = false;
	steps( 60 );
	float before = placedHeight( 0 );
	soleVec3 turn = footTurn( 0 );
	run.base.pose[biped_hipL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -1.2f );
	run.base.pose[biped_kneeL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 1.8f );
	run.base.pose[biped_ankleL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -0.6f );
	assert_true( animatedHeight( 0 ) > before + 0.2f );
	float last = before;
	steps( 2 ); // the first still goes by the height of the frame before
	for ( int32_t i = 0; i < 90; ++i )
	{
		float height = placedHeight( 0 );
		assert_true( height - last < 0.25f * ( animatedHeight( 0 ) - before ) );
		last = height;
		step();
	}
	assert_float_equal( placedHeight( 0 ), animatedHeight( 0 ), 1e-4f );
	testNear3( footTurn( 0 ), turn, 1e-3f );
	ancestorEnd( &run.base );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( goalsAreThoseOfTheFrameAndDoNotAddUp_2 ),
		cmocka_unit_test( onlyTheAnkleCounts_3 ),
		cmocka_unit_test( howTheFootStandsAtTheStartDropsOut_3_5 ),
		cmocka_unit_test( defaultsAreThoseThatWereShown_4 ),
		cmocka_unit_test( fittingMeasuresTheCharacter_4 ),
		cmocka_unit_test( aSphereIsCastDownOverEachAnkle_7 ),
		cmocka_unit_test( whereNothingIsMetTheRootsHeightCounts_7 ),
		cmocka_unit_test( theNormalTurnsSmoothlyOverAnEdge_7 ),
		cmocka_unit_test( castsStartFromTheBoneAsItWasShown_19 ),
		cmocka_unit_test( theAnkleRisesByThePitchOfTheAnimationAlone_8_9_10_11 ),
		cmocka_unit_test( aLevelFootIsNotRaisedByItsSlope_9_10 ),
		cmocka_unit_test( radiusAndOffsetTogetherAreTheAnklesHeight_11 ),
		cmocka_unit_test( aFootThatIsRaisedByTheFloorRangeIsLetGo_12 ),
		cmocka_unit_test( withoutTheSwitchAFootIsAlwaysPutDown_12 ),
		cmocka_unit_test( weightsChangeNothingWhileAFootIsLifted_12 ),
		cmocka_unit_test( aFootOnALowerStepStands_12_19 ),
		cmocka_unit_test( lettingGoIsSmoothAndTheFootGoesOnTurning_12 ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
