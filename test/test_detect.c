// SPDX-License-Identifier: MIT
// Detection on skeletons made up here: every naming convention, no names, turned, mirrored and scaled ones.
#include "detect_body.h"

static void testNameLegs( testBody* body, const char* const names[9] )
{
	body->names[joint_pelvis] = names[0];
	body->names[joint_hipL] = names[1];
	body->names[joint_kneeL] = names[2];
	body->names[joint_ankleL] = names[3];
	body->names[joint_toeL] = names[4];
	body->names[joint_hipR] = names[5];
	body->names[joint_kneeR] = names[6];
	body->names[joint_ankleR] = names[7];
	body->names[joint_toeR] = names[8];
}

static const soleLegDef* testFindLeg( const soleRigDef* def, soleSide side )
{
	for ( int32_t i = 0; i < def->legCount; ++i )
	{
		if ( def->legs[i].side == side )
		{
			return def->legs + i;
		}
	}
	return NULL;
}

/// The made-up body's legs, whatever it is called.
static void testExpectLegs( const soleRigDef* def, soleQuat turn, float scale, float side )
{
	assert_int_equal( def->legCount, 2 );
	const soleLegDef* left = testFindLeg( def, sole_left );
	const soleLegDef* right = testFindLeg( def, sole_right );
	assert_non_null( left );
	assert_non_null( right );
	for ( int32_t i = 0; i < 3; ++i )
	{
		assert_int_equal( left->joints[i], joint_hipL + i );
		assert_int_equal( right->joints[i], joint_hipR + i );
	}
	assert_int_equal( left->jointCount, 3 );
	assert_int_equal( left->toeCount, 1 );
	assert_int_equal( left->toes[0], joint_toeL );
	assert_int_equal( right->toes[0], joint_toeR );
	assert_int_equal( def->pelvis, joint_pelvis );
	testNear3( def->up, soleRotate( turn, soleVec( 0.0f, 1.0f, 0.0f ) ), 1e-4f );
	testNear3( def->forward, soleRotate( turn, soleVec( 0.0f, 0.0f, 1.0f ) ), 1e-4f );
	soleVec3 x = soleRotate( turn, soleVec( 1.0f, 0.0f, 0.0f ) );
	for ( int32_t i = 0; i < 2; ++i )
	{
		const soleLegDef* leg = def->legs + i;
		assert_true( soleDot( soleNormalizeOr( leg->hinge, x ), x ) > 0.97f );
		float outer = leg->side == sole_left ? side : -side;
		assert_true( outer * soleDot( soleSub( leg->sole.outer, leg->sole.inner ), x ) > 0.0f );
		float height = soleDot( leg->sole.ball, def->up ) / scale;
		assert_float_equal( height, 0.0f, 0.02f );
		assert_true( soleDot( soleSub( leg->sole.toe, leg->sole.heel ), def->forward ) > 0.15f * scale );
	}
	assert_float_equal( testReport.legLength / scale, 0.844f, 0.02f );
}

// ----------------------------------------------------------------------------------------------------------- names

static const char* const testConventions[][9] = {
	{ "mixamorig:Hips", "mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "mixamorig:LeftFoot", "mixamorig:LeftToeBase",
	    "mixamorig:RightUpLeg", "mixamorig:RightLeg", "mixamorig:RightFoot", "mixamorig:RightToeBase" },
	{ "mixamorig1_Hips", "mixamorig1_LeftUpLeg", "mixamorig1_LeftLeg", "mixamorig1_LeftFoot", "mixamorig1_LeftToeBase",
	    "mixamorig1_RightUpLeg", "mixamorig1_RightLeg", "mixamorig1_RightFoot", "mixamorig1_RightToeBase" },
	{ "Avatar_Hips", "Avatar_LeftUpLeg", "Avatar_LeftLeg", "Avatar_LeftFoot", "Avatar_LeftToeBase", "Avatar_RightUpLeg",
	    "Avatar_RightLeg", "Avatar_RightFoot", "Avatar_RightToeBase" },
	{ "pelvis", "thigh_l", "calf_l", "foot_l", "ball_l", "thigh_r", "calf_r", "foot_r", "ball_r" },
	{ "DEF-hips", "DEF-thigh.L", "DEF-shin.L", "DEF-foot.L", "DEF-toe.L", "DEF-thigh.R", "DEF-shin.R", "DEF-foot.R",
	    "DEF-toe.R" },
	{ "hips", "upperleg.l", "lowerleg.l", "foot.l", "toes.l", "upperleg.r", "lowerleg.r", "foot.r", "toes.r" },
	{ "pelvis_Armature", "thigh.l_Armature", "shin.l_Armature", "foot.l_Armature", "toes.l_Armature",
	    "thigh.r_Armature", "shin.r_Armature", "foot.r_Armature", "toes.r_Armature" },
	{ "J_Bip_C_Hips", "J_Bip_L_UpperLeg", "J_Bip_L_LowerLeg", "J_Bip_L_Foot", "J_Bip_L_ToeBase", "J_Bip_R_UpperLeg",
	    "J_Bip_R_LowerLeg", "J_Bip_R_Foot", "J_Bip_R_ToeBase" },
	{ "Bip01 Pelvis", "Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot", "Bip01 L Toe0", "Bip01 R Thigh", "Bip01 R Calf",
	    "Bip01 R Foot", "Bip01 R Toe0" },
	{ "ValveBiped.Bip01_Pelvis", "ValveBiped.Bip01_L_Thigh", "ValveBiped.Bip01_L_Calf", "ValveBiped.Bip01_L_Foot",
	    "ValveBiped.Bip01_L_Toe0", "ValveBiped.Bip01_R_Thigh", "ValveBiped.Bip01_R_Calf", "ValveBiped.Bip01_R_Foot",
	    "ValveBiped.Bip01_R_Toe0" },
	{ "Spine", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftFootThumb1", "RightUpLeg", "RightLeg", "RightFoot",
	    "RightFootThumb1" },
	{ "hip", "lthigh", "lshin", "lfoot", "ltoe", "rthigh", "rshin", "rfoot", "rtoe" },
	{ "hip", "lThigh", "lShin", "lFoot", "lToe", "rThigh", "rShin", "rFoot", "rToe" },
	{ "Hips", "LeftUpperLeg", "LeftLowerLeg", "LeftFoot", "LeftToes", "RightUpperLeg", "RightLowerLeg", "RightFoot",
	    "RightToes" },
	{ "B_LowerPelvis", "B_Hip_Left", "B_Knee_Left", "B_Ankle_Left", "B_Toe_Left", "B_Hip_Right", "B_Knee_Right",
	    "B_Ankle_Right", "B_Toe_Right" },
	{ "HIPS", "LEFTUPLEG", "LEFTLEG", "LEFTFOOT", "LEFTTOEBASE", "RIGHTUPLEG", "RIGHTLEG", "RIGHTFOOT",
	    "RIGHTTOEBASE" },
	{ "Hips", "Thigh-l", "Shin-l", "Foot-l", "Toe-l", "Thigh-r", "Shin-r", "Foot-r", "Toe-r" },
	{ "CC_Base_Hip", "CC_Base_L_Thigh", "CC_Base_L_Calf", "CC_Base_L_Foot", "CC_Base_L_ToeBase", "CC_Base_R_Thigh",
	    "CC_Base_R_Calf", "CC_Base_R_Foot", "CC_Base_R_ToeBase" },
	{ "rig|skeleton:Hips_01", "rig|skeleton:LeftLeg_02", "rig|skeleton:LeftKnee_03", "rig|skeleton:LeftFoot_04",
	    "rig|skeleton:LeftToe_05", "rig|skeleton:RightLeg_06", "rig|skeleton:RightKnee_07", "rig|skeleton:RightFoot_08",
	    "rig|skeleton:RightToe_09" },
	{ "Pelvis", "L_Hip", "L_Knee", "L_Ankle", "L_Foot", "R_Hip", "R_Knee", "R_Ankle", "R_Foot" },
	{ "pelvis", "lThighBend", "lShin", "lFoot", "lToe", "rThighBend", "rShin", "rFoot", "rToe" },
	{ "mPelvis", "mHipLeft", "mKneeLeft", "mAnkleLeft", "mToeLeft", "mHipRight", "mKneeRight", "mAnkleRight",
	    "mToeRight" },
	{ "root.x", "thigh_stretch.l", "leg_stretch.l", "foot.l", "toes_01.l", "thigh_stretch.r", "leg_stretch.r", "foot.r",
	    "toes_01.r" },
	{ "Root_M", "Hip_L", "Knee_L", "Ankle_L", "Toes_L", "Hip_R", "Knee_R", "Ankle_R", "Toes_R" },
	{ "\xe4\xb8\x8b\xe5\x8d\x8a\xe8\xba\xab", "\xe5\xb7\xa6\xe8\xb6\xb3", "\xe5\xb7\xa6\xe3\x81\xb2\xe3\x81\x96",
	    "\xe5\xb7\xa6\xe8\xb6\xb3\xe9\xa6\x96", "\xe5\xb7\xa6\xe3\x81\xa4\xe3\x81\xbe\xe5\x85\x88",
	    "\xe5\x8f\xb3\xe8\xb6\xb3", "\xe5\x8f\xb3\xe3\x81\xb2\xe3\x81\x96", "\xe5\x8f\xb3\xe8\xb6\xb3\xe9\xa6\x96",
	    "\xe5\x8f\xb3\xe3\x81\xa4\xe3\x81\xbe\xe5\x85\x88" },
	{ "Hero_Hips", "Hero_L_Hip", "Hero_L_Knee", "Hero_L_Ankle", "Hero_L_Ball", "Hero_R_Hip", "Hero_R_Knee",
	    "Hero_R_Ankle", "Hero_R_Ball" },
};

static void everyConventionIsUnderstood( void** state )
{
	(void)state;
	for ( size_t i = 0; i < sizeof testConventions / sizeof testConventions[0]; ++i )
	{
		testBody body;
		testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
		testNameLegs( &body, testConventions[i] );
		body.names[joint_armL] = "Hero_LeftForeArm";
		soleRigDef def = testDetect( &body );
		testExpectLegs( &def, soleQuat_Identity(), 1.0f, 1.0f );
		assert_int_equal( testReport.findings[0].severity, sole_info );
		assert_non_null( strstr( testReport.findings[0].what, "by names" ) );
	}
}

static void rolesComeFirst( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	for ( int32_t i = 0; i < 4; ++i )
	{
		body.roles[joint_hipL + i] = (soleJointRole)( sole_roleLeftHip + i );
		body.roles[joint_hipR + i] = (soleJointRole)( sole_roleRightHip + i );
	}
	body.roles[joint_pelvis] = sole_rolePelvis;
	body.skeleton.roles = body.roles;
	soleRigDef def = testDetect( &body );
	testExpectLegs( &def, soleQuat_Identity(), 1.0f, 1.0f );
	assert_non_null( strstr( testReport.findings[0].what, "bone map" ) );
}

static void helpersAreNoLegs( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	testNameLegs( &body, testConventions[3] );
	// A target that hangs from the root and is called like a foot, and a twist joint at the knee.
	body.names[joint_count] = "ik_foot_l";
	body.parents[joint_count] = joint_root;
	body.bind[joint_count] = body.bind[joint_ankleL];
	body.names[joint_count + 1] = "calf_twist_01_l";
	body.parents[joint_count + 1] = joint_kneeL;
	body.bind[joint_count + 1] = soleTransform_Identity();
	body.skeleton.jointCount = joint_count + 2;
	soleRigDef def = testDetect( &body );
	testExpectLegs( &def, soleQuat_Identity(), 1.0f, 1.0f );
}

/// CMU's LHipJoint lies between hips and thigh and is no thigh.
static void aJointBesideTheSpineIsNoHip( void** state )
{
	(void)state;
	for ( int32_t named = 0; named < 2; ++named )
	{
		testBody body = { 0 };
		soleVec3 places[joint_count + 2];
		memcpy( places, testPlaces, sizeof testPlaces );
		memcpy( body.parents, testParents, sizeof testParents );
		// Parents after children: the order of joints must not matter to detection. testPlaceBody wants parents first.
		places[joint_armR] = soleVec( 0.02f, 0.96f, 0.0f );
		body.parents[joint_armR] = joint_pelvis;
		places[joint_handR] = soleVec( -0.02f, 0.96f, 0.0f );
		body.parents[joint_handR] = joint_pelvis;
		int32_t parents[JOINT_LIMIT];
		memcpy( parents, body.parents, sizeof parents );
		testPlaceBody( &body, places, joint_count, soleQuat_Identity(), 1.0f, false );
		for ( int32_t i = 0; i < joint_count; ++i )
		{
			body.bind[i].rotation = soleQuat_Identity();
			soleVec3 from = parents[i] == SOLE_NONE ? soleVec( 0.0f, 0.0f, 0.0f ) : places[parents[i]];
			body.bind[i].translation = soleSub( places[i], from );
		}
		body.parents[joint_hipL] = joint_armR;
		body.parents[joint_hipR] = joint_handR;
		body.bind[joint_hipL].translation = soleSub( places[joint_hipL], places[joint_armR] );
		body.bind[joint_hipR].translation = soleSub( places[joint_hipR], places[joint_handR] );
		if ( named == 0 )
		{
			testNameLegs( &body, testConventions[10] );
			body.names[joint_armR] = "LHipJoint";
			body.names[joint_handR] = "RHipJoint";
		}
		soleRigDef def = testDetect( &body );
		testExpectLegs( &def, soleQuat_Identity(), 1.0f, 1.0f );
	}
}

// -------------------------------------------------------------------------------------------------------- structure

static void noNamesAreNeeded( void** state )
{
	(void)state;
	static const char* const scrambled[] = { "qx", "a1", "zz", "Bone.004", "", "k", "mm", "obj", "u7", "x", "y", "z2" };
	for ( int32_t i = 0; i < 3; ++i )
	{
		testBody body;
		testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
		for ( int32_t k = 0; k < 12 && i == 1; ++k )
		{
			body.names[k] = scrambled[k];
		}
		if ( i == 2 )
		{
			body.skeleton.names = NULL;
		}
		soleRigDef def = testDetect( &body );
		testExpectLegs( &def, soleQuat_Identity(), 1.0f, 1.0f );
		assert_true( testCount( sole_warning ) > 0 );
	}
}

/// The 24 turns that carry axes to axes.
static soleQuat testTurn( int32_t index )
{
	const float h = 0.70710678f;
	static const int32_t tops = 6;
	const soleQuat top[6] = { { 0, 0, 0, 1 }, { h, 0, 0, h }, { -h, 0, 0, h }, { 1, 0, 0, 0 }, { 0, 0, h, h },
		{ 0, 0, -h, h } };
	const soleQuat about[4] = { { 0, 0, 0, 1 }, { 0, h, 0, h }, { 0, 1, 0, 0 }, { 0, -h, 0, h } };
	return soleMulQuat( top[index % tops], about[index / tops] );
}

static void everyOrientationGivesTheSameLegs( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < 24; ++i )
	{
		for ( int32_t named = 0; named < 2; ++named )
		{
			testBody body;
			testMakeBody( &body, testTurn( i ), 1.0f, false );
			if ( named == 1 )
			{
				testNameLegs( &body, testConventions[0] );
			}
			soleRigDef def = testDetect( &body );
			testExpectLegs( &def, testTurn( i ), 1.0f, 1.0f );
		}
	}
}

static void everySizeGivesTheSameLegs( void** state )
{
	(void)state;
	const float scales[] = { 0.01f, 0.3f, 100.0f };
	for ( int32_t i = 0; i < 3; ++i )
	{
		testBody body;
		testMakeBody( &body, soleQuat_Identity(), scales[i], false );
		testNameLegs( &body, testConventions[0] );
		soleRigDef def = testDetect( &body );
		testExpectLegs( &def, soleQuat_Identity(), scales[i], 1.0f );
		bool odd = i != 1;
		assert_true( odd == ( testReport.suggestedScale != 1.0f ) );
		if ( odd )
		{
			assert_float_equal( testReport.suggestedScale * testReport.legLength, 0.9f, 1e-3f );
		}
	}
}

static void mirroredBodiesKeepNamesAndToes( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, true );
	testNameLegs( &body, testConventions[0] );
	soleRigDef def = testDetect( &body );
	testExpectLegs( &def, soleQuat_Identity(), 1.0f, -1.0f );
	assert_true( testCount( sole_warning ) > 0 );
}

static void aBodyMayFaceBackwards( void** state )
{
	(void)state;
	soleQuat half = { 0.0f, 1.0f, 0.0f, 0.0f };
	testBody body;
	testMakeBody( &body, half, 1.0f, false );
	testNameLegs( &body, testConventions[7] );
	soleRigDef def = testDetect( &body );
	testExpectLegs( &def, half, 1.0f, 1.0f );
}

static void fourLegsAreFourLegs( void** state )
{
	(void)state;
	testBody body = { 0 };
	soleVec3 places[JOINT_LIMIT] = { { 0.0f, 0.7f, 0.0f }, { 0.0f, 0.7f, -0.4f }, { 0.0f, 0.75f, 0.4f },
		{ 0.0f, 0.9f, 0.6f }, { 0.0f, 0.7f, -0.6f }, { 0.0f, 0.4f, -0.8f } };
	const int32_t parents[] = { SOLE_NONE, 0, 0, 2, 1, 4 };
	memcpy( body.parents, parents, sizeof parents );
	int32_t count = 6;
	for ( int32_t leg = 0; leg < 4; ++leg )
	{
		float x = leg % 2 == 0 ? 0.12f : -0.12f;
		float z = leg < 2 ? -0.4f : 0.4f;
		const soleVec3 chain[] = { { x, 0.65f, z }, { x, 0.4f, z + 0.05f }, { x, 0.2f, z - 0.06f }, { x, 0.04f, z },
			{ x, 0.0f, z + 0.08f } };
		for ( int32_t i = 0; i < 5; ++i )
		{
			places[count] = chain[i];
			body.parents[count] = i == 0 ? ( leg < 2 ? 1 : 2 ) : count - 1;
			count += 1;
		}
	}
	testPlaceBody( &body, places, count, soleQuat_Identity(), 1.0f, false );
	soleRigDef def = testDetect( &body );
	assert_int_equal( def.legCount, 4 );
	assert_string_equal( def.legs[0].name, "front left" );
	assert_string_equal( def.legs[3].name, "hind right" );
	assert_int_equal( def.pelvis, 0 );
	testNear3( def.forward, soleVec( 0.0f, 0.0f, 1.0f ), 1e-3f );
	for ( int32_t i = 0; i < 4; ++i )
	{
		assert_int_equal( def.legs[i].jointCount, 4 );
		assert_int_equal( def.legs[i].toeCount, 1 );
	}
}

static void bonesWithoutLengthDoNotStopIt( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	testNameLegs( &body, testConventions[0] );
	body.bind[joint_kneeL].translation = soleVec( 0.0f, 0.0f, 0.0f );
	body.bind[joint_ankleL].translation = soleVec( 0.0f, 0.0f, 0.0f );
	soleRigDef def = soleDefaultRigDef();
	soleResult result = soleDetectRig( &body.skeleton, &def, &testReport );
	assert_true( result == sole_success || result == sole_notFound );
	assert_true( testCount( sole_warning ) + testCount( sole_error ) > 0 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyConventionIsUnderstood ),
		cmocka_unit_test( rolesComeFirst ),
		cmocka_unit_test( helpersAreNoLegs ),
		cmocka_unit_test( aJointBesideTheSpineIsNoHip ),
		cmocka_unit_test( noNamesAreNeeded ),
		cmocka_unit_test( everyOrientationGivesTheSameLegs ),
		cmocka_unit_test( everySizeGivesTheSameLegs ),
		cmocka_unit_test( mirroredBodiesKeepNamesAndToes ),
		cmocka_unit_test( aBodyMayFaceBackwards ),
		cmocka_unit_test( fourLegsAreFourLegs ),
		cmocka_unit_test( bonesWithoutLengthDoNotStopIt ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
