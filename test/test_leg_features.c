// SPDX-License-Identifier: MIT
// What settings make of a leg beyond placing its foot: toe-out, stretch, twist of the thigh, the least extension. From
// outside, by forward kinematics. The pelvis is kept where it is, so that the leg alone has to reach.
#include "placing.h"

#define LEG 0.9f // length of the biped's leg

// --------------------------------------------------------------------------------------------------------- toe-out

/// The biped with all of its character space turned: another up, another forward.
static void startTurned( testRun* run, soleQuat q )
{
	testStartRun( run, 0.5f );
	soleDestroyRig( run->biped.rig );
	soleRigDef def = testBipedDef( &run->biped );
	run->biped.bindPose[biped_root].rotation = q;
	run->pose[biped_root].rotation = q;
	def.up = soleRotate( q, def.up );
	def.forward = soleRotate( q, def.forward );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleLegDef* leg = def.legs + i;
		leg->hinge = soleRotate( q, leg->hinge );
		soleVec3* points[] = { &leg->sole.heel, &leg->sole.ball, &leg->sole.toe, &leg->sole.inner, &leg->sole.outer };
		for ( int32_t k = 0; k < 5; ++k )
		{
			*points[k] = soleRotate( q, *points[k] );
		}
	}
	run->biped.def = def;
	assert_int_equal( soleCreateRig( &def, NULL, &run->biped.rig, NULL ), sole_success );
	run->frame.up = def.up;
	run->ground.turn = q;
}

static soleQuat someTurn( int32_t i )
{
	const soleQuat turns[] = { { 0.0f, 0.0f, 0.0f, 1.0f }, { 0.7071068f, 0.0f, 0.0f, 0.7071068f },
		{ 0.0f, 0.0f, -0.7071068f, 0.7071068f }, { 0.5f, -0.5f, 0.5f, 0.5f }, { 0.4f, 0.3f, -0.7f, 0.2f } };
	return soleNormalizeQuat( turns[i] );
}

/// Angle by which a foot is headed outwards of where it is animated, on its plane of the given normal.
static float findToeOut( const testRun* run, int32_t leg, soleVec3 normal )
{
	soleQuat animated = testAnimatedJoint( run, testAnkle( leg ) ).rotation;
	soleQuat placed = testPlacedJoint( run, testAnkle( leg ) ).rotation;
	soleVec3 pelvis = testAnimatedJoint( run, biped_pelvis ).translation;
	soleVec3 hip = testAnimatedJoint( run, leg == 0 ? biped_hipL : biped_hipR ).translation;
	soleVec3 ahead = soleNormalizeOr( soleReject( run->biped.def.forward, normal ), normal );
	soleVec3 outwards = soleReject( soleReject( soleSub( hip, pelvis ), normal ), ahead );
	outwards = soleNormalizeOr( outwards, normal );
	soleVec3 heading = soleRotate( placed, soleInvRotate( animated, run->biped.def.forward ) );
	return atan2f( soleDot( heading, outwards ), soleDot( heading, ahead ) );
}

static void toesPointOutwardsOnBothSidesWhateverIsUp( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t i = 0; i < 5; ++i )
	{
		startTurned( &run, someTurn( i ) );
		run.settings.target.toeOutLeft = 0.3f;
		run.settings.target.toeOutRight = 0.15f;
		testStepSeconds( &run, 1.0f );
		assert_float_equal( findToeOut( &run, 0, run.frame.up ), 0.3f, 1e-4f );
		assert_float_equal( findToeOut( &run, 1, run.frame.up ), 0.15f, 1e-4f );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 animated = testAnimatedJoint( &run, testAnkle( leg ) ).translation;
			testNear3( testPlacedJoint( &run, testAnkle( leg ) ).translation, animated, 1e-5f );
		}
		run.settings.target.toeOutLeft = -0.2f;
		run.settings.target.toeOutRight = 0.0f;
		testStepSeconds( &run, 1.0f );
		assert_float_equal( findToeOut( &run, 0, run.frame.up ), -0.2f, 1e-4f );
		assert_float_equal( findToeOut( &run, 1, run.frame.up ), 0.0f, 1e-4f );
		testEndRun( &run );
	}
}

static void aFootThatIsTurnedOutwardsLiesOnItsSlope( void** state )
{
	(void)state;
	static testRun run;
	for ( int32_t i = 0; i < 5; ++i )
	{
		soleVec3 ankles[2][2];
		for ( int32_t out = 0; out < 2; ++out )
		{
			startTurned( &run, someTurn( i ) );
			run.ground.slopeX = 0.1f;
			run.ground.slopeZ = -0.2f;
			run.settings.target.toeOutLeft = out == 1 ? 0.25f : 0.0f;
			run.settings.target.toeOutRight = out == 1 ? 0.25f : 0.0f;
			testStepSeconds( &run, 2.0f );
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				ankles[leg][out] = testPlacedJoint( &run, testAnkle( leg ) ).translation;
				soleSolePoints sole = soleRig_GetLeg( run.biped.rig, leg ).sole;
				const soleVec3 points[] = { sole.heel, sole.ball, sole.toe, sole.inner, sole.outer };
				for ( int32_t k = 0; k < 5; ++k )
				{
					soleVec3 p = soleInvRotate( run.ground.turn, testPlacedPoint( &run, leg, points[k], false ) );
					assert_float_equal( p.y, testGroundHeight( &run.ground, p.x, p.z ), 1e-3f );
				}
			}
			testEndRun( &run );
		}
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			testNear3( ankles[leg][1], ankles[leg][0], 1e-4f );
		}
	}
}

// ---------------------------------------------------------------------------------------------------------- stretch

/// A pelvis that stays where it is, over legs that are as long as this share of their bones.
static void startReaching( testRun* run, float extension )
{
	testStartRun( run, 2.0f * acosf( extension ) );
	run->settings.pelvis.speed = 0.0f;
	run->settings.leg.heelLift = 0.0f;
	testStepSeconds( run, 0.5f );
}

/// The left foot's ground goes up or down until its leg has to be as long as this share of its bones.
static void demand( testRun* run, float extension )
{
	float animated = testAnimatedJoint( run, biped_hipL ).translation.y - 0.08f;
	run->ground.stepX = animated - extension * LEG;
	testStepSeconds( run, 1.0f );
	assert_float_equal( run->out.pelvisOffset_w.y, 0.0f, 1e-6f );
}

static float boneLength( const testRun* run, const soleTransform* pose, int32_t joint )
{
	soleTransform a = testJoint( &run->biped, pose, run->frame.root, joint );
	soleTransform b = testJoint( &run->biped, pose, run->frame.root, run->biped.parents[joint] );
	return soleDistance( a.translation, b.translation );
}

static float softReach( const testRun* run )
{
	return run->settings.leg.reach - run->settings.leg.softZone;
}

static void aLegStretchesToReachATargetThatIsALittleTooFar( void** state )
{
	(void)state;
	static testRun run;
	startReaching( &run, 0.96f );
	run.settings.leg.stretch = 0.01f;
	demand( &run, 1.008f * softReach( &run ) );
	assert_float_equal( run.out.legs[0].stretch, 1.008f, 1e-4f );
	assert_float_equal( run.out.legs[0].error, 0.0f, 1e-5f );
	// The ankle stands on the ground, under its animated place, and the pose says so too.
	soleVec3 wanted = testAnimatedJoint( &run, biped_ankleL ).translation;
	wanted.y += run.ground.stepX;
	testNear3( testPlacedJoint( &run, biped_ankleL ).translation, wanted, 1e-4f );
	for ( int32_t joint = biped_kneeL; joint <= biped_ankleL; ++joint )
	{
		float ratio = boneLength( &run, run.placed, joint ) / boneLength( &run, run.pose, joint );
		assert_float_equal( ratio, run.out.legs[0].stretch, 1e-5f );
	}
	// The foot is none of the leg's bones, and the other leg needs nothing.
	assert_float_equal( boneLength( &run, run.placed, biped_toeL ), boneLength( &run, run.pose, biped_toeL ), 1e-6f );
	assert_float_equal( run.out.legs[1].stretch, 1.0f, 0.0f );
	// Without it the same foot hangs short of its ground.
	run.settings.leg.stretch = 0.0f;
	testStepSeconds( &run, 0.5f );
	assert_true( run.out.legs[0].error > 5e-4f );
	testEndRun( &run );
}

static void aLegStretchesByNoMoreThanTheSetting( void** state )
{
	(void)state;
	static testRun run;
	const float most[] = { 0.0f, 0.005f, 0.01f, 0.05f };
	for ( int32_t k = 0; k < 4; ++k )
	{
		startReaching( &run, 0.9f );
		run.settings.leg.stretch = most[k];
		float last = 1.0f;
		for ( int32_t i = 0; i <= 18; ++i )
		{
			float extension = 0.9f + 0.01f * (float)i; // up to 1.08
			demand( &run, extension );
			float stretch = run.out.legs[0].stretch;
			float wanted = extension / softReach( &run );
			assert_float_equal( stretch, fminf( fmaxf( wanted, 1.0f ), 1.0f + most[k] ), 2e-4f );
			assert_true( stretch >= last - 1e-6f );
			float ratio = boneLength( &run, run.placed, biped_ankleL ) / boneLength( &run, run.pose, biped_ankleL );
			assert_float_equal( ratio, stretch, 1e-5f );
			last = stretch;
		}
		testEndRun( &run );
	}
}

static void aLegWithinReachKeepsItsBones( void** state )
{
	(void)state;
	static testRun run;
	startReaching( &run, 0.9f );
	run.settings.leg.stretch = 0.05f;
	const float extensions[] = { 0.7f, 0.9f, 0.95f, 0.974f };
	for ( int32_t k = 0; k < 4; ++k )
	{
		demand( &run, extensions[k] );
		assert_float_equal( run.out.legs[0].stretch, 1.0f, 0.0f );
		for ( int32_t j = biped_kneeL; j <= biped_ankleL; ++j )
		{
			assert_memory_equal( &run.placed[j].translation, &run.pose[j].translation, sizeof( soleVec3 ) );
		}
	}
	testEndRun( &run );
}

/// A joint that is none of the leg's own sits in the left thigh: it has a share of the bone too.
static void aLegWithAJointInItsThighStretchesAlike( void** state )
{
	(void)state;
	static testRun run;
	startReaching( &run, 0.96f );
	soleDestroyRig( run.biped.rig );
	soleRigDef def = testBipedDef( &run.biped );
	int32_t parents[biped_count + 1];
	soleTransform pose[biped_count + 1];
	memcpy( parents, run.biped.parents, sizeof run.biped.parents );
	memcpy( pose, run.pose, sizeof run.pose );
	parents[biped_count] = biped_hipL;
	parents[biped_kneeL] = biped_count;
	pose[biped_count] = testAt( 0.0f, -0.2f, 0.0f );
	pose[biped_kneeL].translation.y = -0.25f;
	def.jointCount = biped_count + 1;
	def.parents = parents;
	def.bindPose = pose;
	assert_int_equal( soleCreateRig( &def, NULL, &run.biped.rig, NULL ), sole_success );
	run.state = soleDefaultState( run.biped.rig );
	run.frame.pose = pose;
	run.settings.leg.stretch = 0.01f;
	for ( int32_t i = 0; i < 60; ++i )
	{
		run.ground.stepX = i < 5 ? 0.0f : ( 0.96f - 1.008f * softReach( &run ) ) * LEG;
		testStep( &run.biped, &run.settings, &run.state, &run.frame, &run.ground, &run.out );
	}
	assert_float_equal( run.out.legs[0].stretch, 1.008f, 1e-3f );
	soleApply( run.biped.rig, &run.out, pose );
	soleTransform ankle = pose[biped_ankleL];
	for ( int32_t j = parents[biped_ankleL]; j != SOLE_NONE; j = parents[j] )
	{
		ankle = soleMulTransform( pose[j], ankle );
	}
	testNear3( ankle.translation, run.out.legs[0].ankle_w, 1e-4f );
	testEndRun( &run );
}

// ------------------------------------------------------------------------------------------------------------ twist

/// Angle by which a leg's knee is turned about the line from hip to ankle, outwards, against another pose's.
static float findKneeTurn( const testRun* run, const soleTransform* pose, const soleTransform* plain, int32_t leg )
{
	int32_t hip = leg == 0 ? biped_hipL : biped_hipR;
	soleVec3 knees[2];
	soleVec3 axis = { 0.0f, 1.0f, 0.0f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		const soleTransform* p = k == 0 ? plain : pose;
		soleVec3 from = testJoint( &run->biped, p, run->frame.root, hip ).translation;
		soleVec3 to = testJoint( &run->biped, p, run->frame.root, hip + 2 ).translation;
		axis = soleNormalizeOr( soleSub( from, to ), axis );
		soleVec3 knee = testJoint( &run->biped, p, run->frame.root, hip + 1 ).translation;
		knees[k] = soleReject( soleSub( knee, to ), axis );
	}
	float sine = soleDot( axis, soleCross( knees[0], knees[1] ) );
	return ( leg == 0 ? 1.0f : -1.0f ) * atan2f( sine, soleDot( knees[0], knees[1] ) );
}

static void theThighTakesItsShareOfAFootsTurn( void** state )
{
	(void)state;
	static testRun run;
	const float shares[] = { 0.0f, 0.25f, 0.5f, 1.0f };
	soleTransform plain[biped_count];
	for ( int32_t slope = 0; slope < 2; ++slope )
	{
		for ( int32_t k = 0; k < 4; ++k )
		{
			testStartRun( &run, 0.8f );
			run.ground.slopeZ = slope == 1 ? 0.15f : 0.0f;
			run.settings.target.toeOutLeft = 0.4f;
			run.settings.target.toeOutRight = 0.2f;
			run.settings.leg.twist = shares[k];
			testStepSeconds( &run, 1.0f );
			k == 0 ? memcpy( plain, run.placed, sizeof plain ) : NULL;
			for ( int32_t leg = 0; leg < 2; ++leg )
			{
				soleTransform foot = testPlacedJoint( &run, testAnkle( leg ) );
				soleTransform before = testJoint( &run.biped, plain, run.frame.root, testAnkle( leg ) );
				testNear3( foot.translation, before.translation, 1e-5f );
				assert_true( testAngle( foot.rotation, before.rotation ) < 1e-4f );
				float turn = findKneeTurn( &run, run.placed, plain, leg );
				assert_float_equal( turn, shares[k] * ( leg == 0 ? 0.4f : 0.2f ), slope == 1 ? 0.02f : 1e-3f );
			}
			testEndRun( &run );
		}
	}
}

// ------------------------------------------------------------------------------------------------------------- fold

static void aLegFoldsNoFurtherThanTheSetting( void** state )
{
	(void)state;
	static testRun run;
	startReaching( &run, 0.7f );
	run.settings.leg.fold = 0.5f;
	for ( int32_t i = 0; i <= 24; ++i )
	{
		float extension = 0.7f - 0.01f * (float)i; // down to 0.46
		demand( &run, extension );
		soleVec3 hip = testPlacedJoint( &run, biped_hipL ).translation;
		float has = soleDistance( hip, testPlacedJoint( &run, biped_ankleL ).translation ) / LEG;
		assert_float_equal( run.out.legs[0].extension, has, 1e-5f );
		bool folded = ( run.out.legs[0].flags & sole_legFolded ) != 0;
		if ( ( run.out.legs[0].flags & sole_legAnkleClamped ) == 0 )
		{
			assert_true( folded == false );
			assert_float_equal( has, extension, 1e-4f );
		}
		// From there on the heel comes up: the ankle has met its limit.
		assert_true( has > 0.4999f );
		assert_true( extension > 0.5f || ( folded && has < 0.5001f ) );
	}
	testEndRun( &run );
}

static void anAnimationMayFoldItsLegsFurther( void** state )
{
	(void)state;
	static testRun run;
	startReaching( &run, 0.4f );
	run.settings.leg.fold = 0.5f;
	testStepSeconds( &run, 1.0f );
	assert_true( testLargestTurn( run.placed, run.pose ) < 1e-5f );
	testEndRun( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( toesPointOutwardsOnBothSidesWhateverIsUp ),
		cmocka_unit_test( aFootThatIsTurnedOutwardsLiesOnItsSlope ),
		cmocka_unit_test( aLegStretchesToReachATargetThatIsALittleTooFar ),
		cmocka_unit_test( aLegStretchesByNoMoreThanTheSetting ),
		cmocka_unit_test( aLegWithinReachKeepsItsBones ),
		cmocka_unit_test( aLegWithAJointInItsThighStretchesAlike ),
		cmocka_unit_test( theThighTakesItsShareOfAFootsTurn ),
		cmocka_unit_test( aLegFoldsNoFurtherThanTheSetting ),
		cmocka_unit_test( anAnimationMayFoldItsLegsFurther ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
