// SPDX-License-Identifier: MIT
// Legs read and written for the baselines: what is written comes out of soleApply(), by forward kinematics.
#include "ancestor_run.h"
#include "baselines/baseline.h"

static uint32_t seed = 1;

static soleQuat randomTurn( float size )
{
	return soleNormalizeQuat( ( soleQuat ){ testRandomFloat( &seed, -size, size ),
	    testRandomFloat( &seed, -size, size ), testRandomFloat( &seed, -size, size ), 1.0f } );
}

static soleVec3 randomVec( float size )
{
	float x = testRandomFloat( &seed, -size, size );
	float y = testRandomFloat( &seed, -size, size );
	return soleVec( x, y, testRandomFloat( &seed, -size, size ) );
}

/// All joints turned somewhat, the character somewhere, of another size.
static void randomPose( ancestorRun* run )
{
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		run->pose[j].rotation = soleMulQuat( run->pose[j].rotation, randomTurn( 0.15f ) );
	}
	run->frame.root = ( soleTransform ){ randomVec( 5.0f ), randomTurn( 1.0f ), { 1.7f, 1.7f, 1.7f } };
}

/// @param feet as the calls say they will be
static void place( ancestorRun* run, const soleBaselineGoal goals[2], soleBaselineGoal feet[2] )
{
	soleStartBaselineOutput( run->biped.rig, &run->frame, &run->out );
	for ( int32_t i = 0; i < run->out.legCount; ++i )
	{
		soleBaselineLeg leg = soleReadBaselineLeg( run->biped.rig, &run->frame, i );
		feet[i] = solePlaceBaselineLeg( run->biped.rig, &run->frame, &leg, goals + i, run->out.legs + i );
	}
	soleWriteBaselinePelvis( run->biped.rig, &run->frame, goals[0].pelvisOffset_w, &run->out );
	ancestorApply( run );
}

/// Somewhere near the animated foot.
static soleBaselineGoal nearGoal( const ancestorRun* run, int32_t leg, soleVec3 pelvisOffset )
{
	soleBaselineLeg read = soleReadBaselineLeg( run->biped.rig, &run->frame, leg );
	soleVec3 hip = soleAdd( read.hip_w, pelvisOffset );
	soleVec3 way = soleNormalizeOr( soleSub( read.ankle_w, hip ), soleVec( 0.0f, -1.0f, 0.0f ) );
	soleVec3 ankle = soleMulAdd( hip, 0.8f * read.length, soleNormalizeOr( soleAdd( way, randomVec( 0.2f ) ), way ) );
	return ( soleBaselineGoal ){ pelvisOffset, ankle, soleMulQuat( randomTurn( 0.3f ), read.foot_w.rotation ) };
}

static void anOutputThatWasOnlyStartedKeepsThePoseToTheBit( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	randomPose( &run );
	soleStartBaselineOutput( run.biped.rig, &run.frame, &run.out );
	soleWriteBaselinePelvis( run.biped.rig, &run.frame, soleVec( 0.0f, 0.0f, 0.0f ), &run.out );
	ancestorApply( &run );
	assert_memory_equal( run.placed, run.pose, sizeof run.pose );
	ancestorEnd( &run );
}

/// @param footJoint that carries the sole @param footTurns whether it can be turned by itself
static void checkPlacing( ancestorRun* run, const int32_t footJoints[2], bool footTurns )
{
	for ( int32_t round = 0; round < 50; ++round )
	{
		randomPose( run );
		soleVec3 offset = randomVec( 0.15f );
		soleBaselineGoal goals[2] = { nearGoal( run, 0, offset ), nearGoal( run, 1, offset ) };
		soleBaselineLeg before[2] = { soleReadBaselineLeg( run->biped.rig, &run->frame, 0 ),
			soleReadBaselineLeg( run->biped.rig, &run->frame, 1 ) };
		soleBaselineGoal feet[2];
		place( run, goals, feet );
		soleVec3 animated = ancestorAnimated( run, biped_pelvis ).translation;
		testNear3( ancestorPlaced( run, biped_pelvis ).translation, soleAdd( animated, offset ), 1e-5f );
		soleFrame placed = run->frame;
		placed.pose = run->placed;
		for ( int32_t i = 0; i < 2; ++i )
		{
			soleBaselineLeg after = soleReadBaselineLeg( run->biped.rig, &placed, i );
			testNear3( after.ankle_w, goals[i].ankle_w, 1e-5f );
			testNear3( feet[i].ankle_w, after.ankle_w, 1e-5f );
			assert_true( soleLength( ancestorTurn( after.foot_w.rotation, feet[i].foot_w ) ) < 1e-4f );
			assert_float_equal( after.length, before[i].length, 1e-5f );
			soleQuat turned = ancestorPlaced( run, footJoints[i] ).rotation;
			bool there = soleLength( ancestorTurn( goals[i].foot_w, turned ) ) < 1e-4f;
			assert_true( there == footTurns );
			assert_true( run->out.legs[i].error < 1e-5f );
		}
		memcpy( run->pose, run->biped.bindPose, sizeof run->pose );
		testBendKnees( run->pose, 0.9f );
	}
}

static void legsComeToTheirGoals( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	const int32_t feet[] = { biped_ankleL, biped_ankleR };
	checkPlacing( &run, feet, true );
	ancestorEnd( &run );
}

static void remakeRig( ancestorRun* run )
{
	soleDestroyRig( run->biped.rig );
	soleMessage message = { "" };
	if ( soleCreateRig( &run->biped.def, NULL, &run->biped.rig, &message ) != sole_success )
	{
		fail_msg( "%s", message.text );
	}
}

static void jointsBetweenKneeAndEndAreCarriedAlong( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleLegDef* leg = run.biped.def.legs + i;
		leg->joints[3] = leg->toes[0];
		leg->jointCount = 4;
		leg->toeCount = 0;
	}
	remakeRig( &run );
	assert_int_equal( soleReadBaselineLeg( run.biped.rig, &run.frame, 0 ).kneeIndex, 1 );
	const int32_t feet[] = { biped_toeL, biped_toeR };
	checkPlacing( &run, feet, true );
	soleBaselineGoal goals[2] = { nearGoal( &run, 0, randomVec( 0.1f ) ), nearGoal( &run, 1, randomVec( 0.1f ) ) };
	soleBaselineGoal placed[2];
	place( &run, goals, placed );
	assert_memory_equal( run.placed + biped_ankleL, run.pose + biped_ankleL, sizeof run.pose[0] );
	ancestorEnd( &run );
}

static void aFootThatIsPartOfTheShinGoesWithIt( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleLegDef* leg = run.biped.def.legs + i;
		leg->virtualAnkle =
		    testJoint( &run.biped, run.biped.bindPose, soleTransform_Identity(), leg->joints[2] ).translation;
		leg->hasVirtualAnkle = true;
		leg->jointCount = 2;
		leg->toeCount = 0;
	}
	remakeRig( &run );
	const int32_t feet[] = { biped_kneeL, biped_kneeR };
	checkPlacing( &run, feet, false );
	ancestorEnd( &run );
}

/// Both a foot that hangs from the root, which the pelvis does not move, and one that hangs from the pelvis.
static void aDetachedFootGoesToTheAnkle( void** state )
{
	(void)state;
	const int32_t parents[] = { biped_root, biped_pelvis };
	for ( int32_t k = 0; k < 2; ++k )
	{
		static ancestorRun run;
		ancestorStart( &run, NULL );
		soleTransform parent = testJoint( &run.biped, run.biped.bindPose, soleTransform_Identity(), parents[k] );
		for ( int32_t i = 0; i < 2; ++i )
		{
			soleLegDef* leg = run.biped.def.legs + i;
			int32_t foot = leg->joints[2];
			soleVec3 ankle = testJoint( &run.biped, run.biped.bindPose, soleTransform_Identity(), foot ).translation;
			leg->virtualAnkle = ankle;
			leg->hasVirtualAnkle = true;
			leg->jointCount = 2;
			leg->detachedFoot = foot;
			run.biped.parents[foot] = parents[k];
			run.biped.bindPose[foot].translation = soleInvTransformPoint( parent, ankle );
		}
		memcpy( run.pose, run.biped.bindPose, sizeof run.pose );
		remakeRig( &run );
		const int32_t feet[] = { biped_ankleL, biped_ankleR };
		checkPlacing( &run, feet, true );
		ancestorEnd( &run );
	}
}

static void soleIsMeasuredInTheCharactersUnits( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	assert_float_equal( soleGetBaselineAnkleHeight( run.biped.rig, 0 ), 0.08f, 1e-5f );
	assert_float_equal( soleGetBaselineSoleLength( run.biped.rig, 0 ), 0.26f, 1e-6f );
	// Twice as large by a scale at the root, its foot turned in its joint.
	run.biped.bindPose[biped_root].scale = soleVec( 2.0f, 2.0f, 2.0f );
	run.biped.bindPose[biped_ankleL].rotation = testTurn( soleVec( 0.0f, 0.6f, 0.8f ), 1.0f );
	soleSolePoints* sole = &run.biped.def.legs[0].sole;
	soleVec3* points[] = { &sole->heel, &sole->ball, &sole->toe, &sole->inner, &sole->outer };
	for ( int32_t k = 0; k < 5; ++k )
	{
		*points[k] = soleScale( 2.0f, *points[k] );
	}
	remakeRig( &run );
	assert_float_equal( soleGetBaselineAnkleHeight( run.biped.rig, 0 ), 0.16f, 1e-5f );
	assert_float_equal( soleGetBaselineSoleLength( run.biped.rig, 0 ), 0.52f, 1e-6f );
	soleQuat foot = testJoint( &run.biped, run.biped.bindPose, soleTransform_Identity(), biped_ankleL ).rotation;
	soleVec3 ahead = soleVec( 0.0f, 0.0f, 1.0f );
	testNear3( soleRotate( foot, soleGetBaselineFootAxis( run.biped.rig, 0, ahead ) ), ahead, 1e-5f );
	ancestorEnd( &run );
}

static void shownFeetAreCarriedByTheRoot( void** state )
{
	(void)state;
	static ancestorRun run;
	ancestorStart( &run, NULL );
	randomPose( &run );
	soleShownFeet shown = { .known = false };
	soleBaselineGoal animated = soleGetShownFoot( run.biped.rig, &run.frame, &shown, 1 );
	testNear3( animated.ankle_w, ancestorAnimated( &run, biped_ankleR ).translation, 1e-5f );
	soleBaselineGoal kept = { .ankle_w = randomVec( 1.0f ), .foot_w = randomTurn( 1.0f ) };
	soleKeepShownFoot( &run.frame, &kept, 1, &shown );
	soleTransform before = run.frame.root;
	soleQuat turn = randomTurn( 1.0f );
	run.frame.root.rotation = soleMulQuat( turn, before.rotation );
	run.frame.root.translation = randomVec( 3.0f );
	soleBaselineGoal seen = soleGetShownFoot( run.biped.rig, &run.frame, &shown, 1 );
	soleVec3 arm = soleSub( kept.ankle_w, before.translation );
	testNear3( seen.ankle_w, soleAdd( run.frame.root.translation, soleRotate( turn, arm ) ), 1e-5f );
	assert_true( soleLength( ancestorTurn( soleMulQuat( turn, kept.foot_w ), seen.foot_w ) ) < 1e-5f );
	ancestorEnd( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( anOutputThatWasOnlyStartedKeepsThePoseToTheBit ),
		cmocka_unit_test( legsComeToTheirGoals ),
		cmocka_unit_test( jointsBetweenKneeAndEndAreCarriedAlong ),
		cmocka_unit_test( aFootThatIsPartOfTheShinGoesWithIt ),
		cmocka_unit_test( aDetachedFootGoesToTheAnkle ),
		cmocka_unit_test( soleIsMeasuredInTheCharactersUnits ),
		cmocka_unit_test( shownFeetAreCarriedByTheRoot ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
