// SPDX-License-Identifier: MIT
// Characters of the real data: the joints that their makers meant, facing, soles where the mesh ends, knees that bend
// about the lateral axis; the same legs when every name is taken away.
#include "test.h"

#include "gltf.h"
#include "inspect.h"
#include "motion.h"

typedef struct testCase
{
	const char* file;
	const char* left[4]; // hip, knee, ankle, toe or NULL
	const char* right[4];
	const char* pelvis;
	float facing; // of z
	float length; // of a leg, m
	float hinge;  // furthest of the hinge from lateral, degrees
	bool standing;
} testCase;

#define MIXAMO_LEGS                                                                                                    \
	{ "Avatar_LeftUpLeg", "Avatar_LeftLeg", "Avatar_LeftFoot", "Avatar_LeftToeBase" },                                 \
	{                                                                                                                  \
		"Avatar_RightUpLeg", "Avatar_RightLeg", "Avatar_RightFoot", "Avatar_RightToeBase"                              \
	}
#define BVH_LEGS                                                                                                       \
	{ "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToeBase" },                                                             \
	{                                                                                                                  \
		"RightUpLeg", "RightLeg", "RightFoot", "RightToeBase"                                                          \
	}
#define KAYKIT_LEGS                                                                                                    \
	{ "upperleg.l", "lowerleg.l", "foot.l", "toes.l" },                                                                \
	{                                                                                                                  \
		"upperleg.r", "lowerleg.r", "foot.r", "toes.r"                                                                 \
	}

// The thighs of cgspeed's skeletons hang 20 degrees outwards in the bind pose, and their hinges with them.
static const testCase testCases[] = {
	{ "human-quaternius-ual/human-base-animations.glb", { "DEF-thigh.L", "DEF-shin.L", "DEF-foot.L", "DEF-toe.L" },
	    { "DEF-thigh.R", "DEF-shin.R", "DEF-foot.R", "DEF-toe.R" }, "DEF-hips", 1.0f, 0.83f, 20.0f, true },
	{ "human-mesh2motion-ue-names/human-addon-animations.glb", { "thigh_l", "calf_l", "foot_l", "ball_l" },
	    { "thigh_r", "calf_r", "foot_r", "ball_r" }, "pelvis", 1.0f, 0.84f, 20.0f, true },
	{ "human-pab-rootmotion/pab_arnaud.glb", { "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftFootThumb1" },
	    { "RightUpLeg", "RightLeg", "RightFoot", "RightFootThumb1" }, "Spine", 1.0f, 0.93f, 20.0f, true },
	{ "human-kaykit-mannequin/manny_med_mod.gltf", KAYKIT_LEGS, "hips", 1.0f, 0.377f, 20.0f, true },
	{ "human-kaykit-mannequin/Med_General.glb", KAYKIT_LEGS, "hips", 1.0f, 0.377f, 20.0f, true },
	{ "human-dcl-emotes/walk.glb", MIXAMO_LEGS, "Avatar_Hips", 1.0f, 0.856f, 20.0f, false },
	{ "human-dcl-emotes/run.glb", MIXAMO_LEGS, "Avatar_Hips", 1.0f, 0.856f, 20.0f, false },
	{ "human-dcl-emotes/idle.glb", MIXAMO_LEGS, "Avatar_Hips", 1.0f, 0.856f, 20.0f, true },
	{ "human-dcl-emotes/jump.glb", MIXAMO_LEGS, "Avatar_Hips", 1.0f, 0.856f, 20.0f, true },
	{ "vrm-godette/Godette_vrm_v4.vrm", { "thigh.l_Armature", "shin.l_Armature", "foot.l_Armature", "toes.l_Armature" },
	    { "thigh.r_Armature", "shin.r_Armature", "foot.r_Armature", "toes.r_Armature" }, "pelvis_Armature", -1.0f,
	    0.436f, 20.0f, true },
	{ "mocap-bvh/cmu_02_01_walk.glb", BVH_LEGS, "Hips", 1.0f, 0.835f, 25.0f, true },
	{ "mocap-bvh/cmu_01_01_hops_and_turns.glb", BVH_LEGS, "Hips", 1.0f, 0.835f, 25.0f, true },
	{ "mocap-bvh/fair_zombie_walk.glb", BVH_LEGS, "Hips", 1.0f, 0.824f, 20.0f, true },
	{ "mocap-bvh/cmu_03_01_uneven_terrain.glb", { "lthigh", "lshin", "lfoot", NULL },
	    { "rthigh", "rshin", "rfoot", NULL }, "hip", 1.0f, 0.822f, 20.0f, true },
	{ "by-name-debian-assimp/bcn_human.glb", { "B_Hip_Left", "B_Knee_Left", "B_Ankle_Left", "B_Toe_Left" },
	    { "B_Hip_Right", "B_Knee_Right", "B_Ankle_Right", "B_Toe_Right" }, "B_Root_Pelvis_L", 1.0f, 0.826f, 20.0f,
	    true },
};

#define CASE_COUNT ( (int32_t)( sizeof testCases / sizeof testCases[0] ) )

typedef struct testOpened
{
	toolGltf* gltf;
	toolCharacter character;
} testOpened;

static void testOpen( const char* file, float scale, testOpened* opened )
{
	toolError error = { { 0 } };
	if ( toolReadGltf( testData( file ), &opened->gltf, &error ) == false ||
	    toolMakeCharacter( toolGltf_GetModel( opened->gltf ), file, scale, &opened->character, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
}

static void testClose( testOpened* opened )
{
	toolFreeCharacter( &opened->character );
	toolFreeGltf( opened->gltf );
}

static void testExpectNames( const toolCharacter* character, const soleLegDef* leg, const char* const names[4] )
{
	assert_int_equal( leg->jointCount, 3 );
	for ( int32_t i = 0; i < 3; ++i )
	{
		assert_string_equal( character->names[leg->joints[i]], names[i] );
	}
	if ( names[3] == NULL )
	{
		assert_int_equal( leg->toeCount, 0 );
		return;
	}
	assert_true( leg->toeCount > 0 );
	assert_string_equal( character->names[leg->toes[0]], names[3] );
}

/// The lowest vertex that the foot or what hangs from it moves; NaN where there is no skin.
static float testLowestVertex( const toolCharacter* character, const soleLegDef* leg )
{
	float low = NAN;
	for ( int32_t i = 0; i < character->skinCount; ++i )
	{
		int32_t joint = character->skin[i].joints[0];
		while ( joint != SOLE_NONE && joint != leg->joints[2] )
		{
			joint = character->parents[joint];
		}
		float y = character->skin[i].position.y;
		low = joint != SOLE_NONE && !( y >= low ) ? y : low;
	}
	return low;
}

static void testExpectSole( const toolCharacter* character, const soleLegDef* leg, const testCase* expected )
{
	const soleSolePoints* sole = &leg->sole;
	float low = testLowestVertex( character, leg );
	if ( low == low )
	{
		assert_float_equal( sole->heel.y, low, 0.015f );
		assert_float_equal( sole->ball.y, low, 0.015f );
		assert_float_equal( sole->toe.y, low, 0.015f );
	}
	soleVec3 along = soleSub( sole->toe, sole->heel );
	assert_true( soleDot( along, character->rigDef.forward ) > 0.2f * expected->length );
	soleVec3 toBall = soleSub( sole->ball, sole->heel );
	assert_true( soleDot( toBall, along ) > 0.0f );
	assert_true( soleLength( toBall ) < soleLength( along ) );
	// The inner edge is nearer to the other leg.
	float sign = leg->side == sole_left ? 1.0f : -1.0f;
	assert_true( sign * expected->facing * ( sole->outer.x - sole->inner.x ) > 0.05f * expected->length );
}

static void testExpectCase( const testCase* expected )
{
	testOpened opened;
	testOpen( expected->file, 1.0f, &opened );
	const toolCharacter* character = &opened.character;
	const soleRigDef* def = &character->rigDef;
	testNear3( def->up, soleVec( 0.0f, 1.0f, 0.0f ), 1e-4f );
	testNear3( def->forward, soleVec( 0.0f, 0.0f, expected->facing ), 1e-3f );
	assert_int_equal( def->legCount, 2 );
	assert_int_equal( def->legs[0].side, sole_left );
	assert_int_equal( def->legs[1].side, sole_right );
	testExpectNames( character, def->legs + 0, expected->left );
	testExpectNames( character, def->legs + 1, expected->right );
	assert_string_equal( character->names[def->pelvis], expected->pelvis );
	soleVec3 lateral = soleCross( def->up, def->forward );
	for ( int32_t i = 0; i < 2; ++i )
	{
		assert_float_equal( soleRig_GetLegLength( character->rig, i ), expected->length, 0.02f );
		soleVec3 hinge = soleNormalizeOr( def->legs[i].hinge, def->up );
		assert_true( soleDot( hinge, lateral ) > cosf( expected->hinge * 0.0174533f ) );
		if ( expected->standing )
		{
			testExpectSole( character, def->legs + i, expected );
		}
	}
	bool warned = false;
	for ( int32_t i = 0; i < character->report.findingCount; ++i )
	{
		warned = warned || strstr( character->report.findings[i].what, "no standing pose" ) != NULL;
	}
	assert_true( warned != expected->standing );
	assert_true( character->pointCount >= 8 );
	testClose( &opened );
}

static void humansAreFound( void** state )
{
	(void)state;
	int32_t seen = 0;
	for ( int32_t i = 0; i < CASE_COUNT; ++i )
	{
		if ( testData( testCases[i].file ) == NULL )
		{
			print_message( "left out: %s is not there\n", testCases[i].file );
			continue;
		}
		print_message( "%s\n", testCases[i].file );
		testExpectCase( testCases + i );
		seen += 1;
	}
	if ( seen == 0 )
	{
		skip();
	}
}

/// The same legs without any name, from structure alone.
static void humansAreFoundWithoutNames( void** state )
{
	(void)state;
	int32_t seen = 0;
	for ( int32_t i = 0; i < CASE_COUNT; ++i )
	{
		if ( testData( testCases[i].file ) == NULL || testCases[i].standing == false )
		{
			continue;
		}
		print_message( "%s\n", testCases[i].file );
		testOpened opened;
		testOpen( testCases[i].file, 1.0f, &opened );
		const toolCharacter* character = &opened.character;
		soleSkeleton skeleton = { .jointCount = character->jointCount, .parents = character->parents };
		skeleton.bindPose = character->bindPose;
		skeleton.skin = character->skin;
		skeleton.skinCount = character->skinCount;
		soleRigDef def = soleDefaultRigDef();
		static soleDetectReport report;
		assert_int_equal( soleDetectRig( &skeleton, &def, &report ), sole_success );
		testNear3( def.up, soleVec( 0.0f, 1.0f, 0.0f ), 1e-4f );
		testNear3( def.forward, character->rigDef.forward, 1e-3f );
		assert_int_equal( def.legCount, 2 );
		assert_int_equal( def.pelvis, character->rigDef.pelvis );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			assert_int_equal( def.legs[leg].side, character->rigDef.legs[leg].side );
			assert_int_equal( def.legs[leg].jointCount, 3 );
			assert_memory_equal( def.legs[leg].joints, character->rigDef.legs[leg].joints, 3 * sizeof( int32_t ) );
		}
		testClose( &opened );
		seen += 1;
	}
	if ( seen == 0 )
	{
		skip();
	}
}

typedef struct testOther
{
	const char* file;
	int32_t legCount;
	bool detached;
	bool virtualAnkle;
} testOther;

static void othersAreFoundWithDoubts( void** state )
{
	(void)state;
	static const testOther others[] = {
		{ "quad-fox/fox-animations.glb", 4, false, false },
		{ "quad-wolf-detached-feet/Wolf.glb", 4, true, false },
		{ "spider-8-legs/spider-animations.glb", 8, false, false },
		{ "kaiju-biped-tail/kaiju-animations.glb", 2, false, false },
		{ "by-name-debian-assimp/wuson.glb", 4, false, false },
		{ "robot-expressive/robot.glb", 2, true, true },
		{ "boxman-no-feet/boxman.glb", 2, false, true },
	};
	for ( size_t i = 0; i < sizeof others / sizeof others[0]; ++i )
	{
		if ( testData( others[i].file ) == NULL )
		{
			print_message( "left out: %s is not there\n", others[i].file );
			continue;
		}
		print_message( "%s\n", others[i].file );
		testOpened opened;
		testOpen( others[i].file, 1.0f, &opened );
		const soleRigDef* def = &opened.character.rigDef;
		assert_int_equal( def->legCount, others[i].legCount );
		testNear3( def->forward, soleVec( 0.0f, 0.0f, 1.0f ), 1e-3f );
		for ( int32_t leg = 0; leg < def->legCount; ++leg )
		{
			assert_true( ( def->legs[leg].detachedFoot != SOLE_NONE ) == others[i].detached );
			assert_true( def->legs[leg].hasVirtualAnkle == others[i].virtualAnkle );
			assert_float_equal( def->legs[leg].sole.ball.y, 0.0f, 0.05f );
		}
		testClose( &opened );
	}
}

static void scaleReachesEverything( void** state )
{
	(void)state;
	const char* file = "human-pab-rootmotion/pab_arnaud.glb";
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	testOpened one;
	testOpened two;
	testOpen( file, 1.0f, &one );
	testOpen( file, 20.0f, &two );
	assert_int_equal( one.character.rigDef.legCount, two.character.rigDef.legCount );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleLegDef a = one.character.rigDef.legs[i];
		soleLegDef b = two.character.rigDef.legs[i];
		testNear3( soleScale( 20.0f, a.sole.heel ), b.sole.heel, 0.01f );
		testNear3( soleScale( 20.0f, a.sole.outer ), b.sole.outer, 0.01f );
		assert_float_equal(
		    20.0f * soleRig_GetLegLength( one.character.rig, i ), soleRig_GetLegLength( two.character.rig, i ), 0.01f );
	}
	assert_float_equal( one.character.report.suggestedScale, 1.0f, 0.0f );
	assert_float_equal( two.character.report.suggestedScale, 0.9f / two.character.report.legLength, 1e-5f );
	testClose( &one );
	testClose( &two );
}

/// Measuring points of a mesh are vertices of the sole, carried by the foot's joints.
static void pointsLieOnTheSole( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testOpened opened;
	testOpen( "human-quaternius-ual/human-base-animations.glb", 1.0f, &opened );
	const toolCharacter* character = &opened.character;
	int32_t fore = 0;
	for ( int32_t i = 0; i < character->pointCount; ++i )
	{
		const soleMeasurePoint* point = character->points + i;
		soleTransform world = toolPoseWorld( character, character->bindPose, point->joint );
		soleVec3 p = soleTransformPoint( world, point->position );
		assert_true( p.y > -0.01f && p.y < 0.02f );
		float side = character->rigDef.legs[point->leg].side == sole_left ? 1.0f : -1.0f;
		assert_true( side * p.x > 0.0f );
		fore += point->fore ? 1 : 0;
	}
	assert_true( fore > 4 && fore < character->pointCount - 4 );
	assert_string_equal( character->names[character->travel], "Rig" );
	testClose( &opened );
}

/// A pose that was changed after binding: the bind pose comes from the inverse bind matrices, not from the rest pose.
static void bindPoseComesFromTheSkin( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testOpened opened;
	testOpen( "human-quaternius-ual/human-base-animations.glb", 1.0f, &opened );
	const toolModel* model = opened.character.model;
	toolModel posed = *model;
	posed.nodes = calloc( (size_t)model->nodeCount, sizeof *posed.nodes );
	assert_non_null( posed.nodes );
	memcpy( posed.nodes, model->nodes, (size_t)model->nodeCount * sizeof *posed.nodes );
	int32_t shin = toolFindNode( model, "DEF-shin.L" );
	assert_true( shin != SOLE_NONE );
	soleQuat bend = { 0.5f, 0.0f, 0.0f, 0.8660254f };
	posed.nodes[shin].local.rotation = soleMulQuat( posed.nodes[shin].local.rotation, bend );
	// The topmost joint of the skin as well: the body lies in the rest pose.
	int32_t top = toolFindNode( model, "DEF-hips" );
	assert_true( top != SOLE_NONE );
	while ( model->nodes[top].parent != SOLE_NONE && model->nodes[model->nodes[top].parent].parent != SOLE_NONE )
	{
		top = model->nodes[top].parent;
	}
	posed.nodes[top].local.rotation = soleMulQuat( posed.nodes[top].local.rotation, bend );
	toolCharacter character;
	toolError error = { { 0 } };
	if ( toolMakeCharacter( &posed, "posed", 1.0f, &character, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	for ( int32_t i = 0; i < 3; ++i )
	{
		int32_t joint = opened.character.rigDef.legs[0].joints[i];
		soleTransform a = toolPoseWorld( &opened.character, opened.character.bindPose, joint );
		soleTransform b = toolPoseWorld( &character, character.bindPose, joint );
		testNear3( a.translation, b.translation, 1e-3f );
	}
	testNear3( opened.character.rigDef.legs[0].sole.toe, character.rigDef.legs[0].sole.toe, 1e-3f );
	toolFreeCharacter( &character );
	free( posed.nodes );
	testClose( &opened );
}

/// The same character bound in the middle of a stride: soles must be found in the feet's own frames.
static void solesOfAStrideAreThoseOfTheFeet( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testOpened opened;
	testOpen( "human-quaternius-ual/human-base-animations.glb", 1.0f, &opened );
	const toolCharacter* character = &opened.character;
	toolBoundClip bound;
	toolError error;
	assert_true(
	    toolBindClip( character, character->model, toolFindClip( character->model, "Jog_Fwd_Loop" ), &bound, &error ) );
	size_t joints = (size_t)character->jointCount;
	soleTransform* pose = calloc( joints, sizeof *pose );
	soleSkinVertex* skin = calloc( (size_t)character->skinCount, sizeof *skin );
	memcpy( skin, character->skin, (size_t)character->skinCount * sizeof *skin );
	toolSampleClip( character, &bound, 0.2f, pose );
	for ( int32_t i = 0; i < character->skinCount; ++i )
	{
		soleTransform from = toolPoseWorld( character, character->bindPose, skin[i].joints[0] );
		soleTransform to = toolPoseWorld( character, pose, skin[i].joints[0] );
		skin[i].position = soleTransformPoint( to, soleInvTransformPoint( from, skin[i].position ) );
	}
	soleSkeleton skeleton = { .jointCount = character->jointCount, .parents = character->parents, .bindPose = pose };
	skeleton.names = character->names;
	skeleton.skin = skin;
	skeleton.skinCount = character->skinCount;
	soleRigDef def = soleDefaultRigDef();
	static soleDetectReport report;
	assert_int_equal( soleDetectRig( &skeleton, &def, &report ), sole_success );
	for ( int32_t i = 0; i < 2; ++i )
	{
		int32_t foot = def.legs[i].joints[2];
		const soleSolePoints* made = &def.legs[i].sole;
		const soleSolePoints* known = &character->rigDef.legs[i].sole;
		soleTransform from = toolPoseWorld( character, character->bindPose, foot );
		soleTransform to = toolPoseWorld( character, pose, foot );
		soleVec3 heel = soleTransformPoint( to, soleInvTransformPoint( from, known->heel ) );
		soleVec3 ball = soleTransformPoint( to, soleInvTransformPoint( from, known->ball ) );
		print_message( "heel off by %.3f m, ball by %.3f m\n", (double)soleDistance( heel, made->heel ),
		    (double)soleDistance( ball, made->ball ) );
		assert_true( soleDistance( heel, made->heel ) < 0.03f );
		assert_true( soleDistance( ball, made->ball ) < 0.03f );
	}
	free( pose );
	free( skin );
	toolFreeBoundClip( &bound );
	testClose( &opened );
}

static void clipsAreLookedAt( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	testOpened opened;
	testOpen( "human-pab-rootmotion/pab_arnaud.glb", 1.0f, &opened );
	toolClipFacts* facts = toolInspectClips( &opened.character );
	int32_t walk = toolFindClip( opened.character.model, "walk" );
	assert_true( walk != SOLE_NONE );
	assert_false( facts[walk].refused );
	assert_true( facts[walk].travel.rootMotion );
	assert_float_equal( facts[walk].strideSpeed, 1.07f, 0.05f );
	// Known from the data: the right foot is planted from frame 12 to 25 of 30 a second, the left one from 30 on.
	float right = 0.0f;
	for ( int32_t i = 0; i < facts[walk].legs[1].count; ++i )
	{
		toolInterval interval = facts[walk].legs[1].intervals[i];
		right += interval.start < 0.45f && interval.end > 0.78f ? 1.0f : 0.0f;
	}
	assert_float_equal( right, 1.0f, 0.0f );
	toolFreeClipFacts( facts, opened.character.model->clipCount );
	testClose( &opened );
}

static void groundsAreNoCharacters( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "ground-kaykit-prototype/Primitive_Stairs.gltf" );
	toolGltf* gltf = NULL;
	toolError error = { { 0 } };
	toolCharacter character;
	assert_true( toolReadGltf( testData( "ground-kaykit-prototype/Primitive_Stairs.gltf" ), &gltf, &error ) );
	assert_false( toolMakeCharacter( toolGltf_GetModel( gltf ), "stairs", 1.0f, &character, &error ) );
	assert_non_null( strstr( error.text, "stairs: " ) );
	assert_null( character.skin );
	assert_false( toolMakeCharacter( toolGltf_GetModel( gltf ), "stairs", NAN, &character, &error ) );
	toolFreeGltf( gltf );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( humansAreFound ),
		cmocka_unit_test( humansAreFoundWithoutNames ),
		cmocka_unit_test( othersAreFoundWithDoubts ),
		cmocka_unit_test( scaleReachesEverything ),
		cmocka_unit_test( pointsLieOnTheSole ),
		cmocka_unit_test( bindPoseComesFromTheSkin ),
		cmocka_unit_test( solesOfAStrideAreThoseOfTheFeet ),
		cmocka_unit_test( clipsAreLookedAt ),
		cmocka_unit_test( groundsAreNoCharacters ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
