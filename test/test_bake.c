// SPDX-License-Identifier: MIT
// Bakes: what is written is what was computed, at every frame, for every node, and Sole's feet stand on the ground.
#include "test.h"

#include "bake.h"
#include "gltf.h"
#include "settings_file.h"

#include <math.h>

typedef struct testTake
{
	toolGltf* gltf;
	toolGltf* clips; // NULL: the same file
	toolCharacter character;
	toolBoundClip bound;
	toolTravel travel;
	soleGround* ground;
	toolBakeDef def;
	toolPlace path[1];
	toolBakeResult result;
} testTake;

static void testMakeGround( testTake* take, float slope )
{
	float v[12] = { -50, -50 * slope, -50, -50, 50 * slope, 50, 50, 50 * slope, 50, 50, -50 * slope, -50 };
	uint32_t indices[6] = { 0, 1, 2, 0, 2, 3 };
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = v;
	mesh.vertexCount = 4;
	mesh.indices = indices;
	mesh.triangleCount = 2;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	soleMessage message;
	assert_int_equal( soleCreateGround( &def, NULL, &take->ground, &message ), sole_success );
}

static void testOpen( testTake* take, const char* file, const char* clipFile, const char* clip, float scale )
{
	toolError error = { { 0 } };
	memset( take, 0, sizeof *take );
	bool good = toolReadGltf( testData( file ), &take->gltf, &error ) &&
	    ( clipFile == NULL || toolReadGltf( testData( clipFile ), &take->clips, &error ) );
	if ( good == false )
	{
		fail_msg( "%s", error.text );
	}
	const toolModel* model = toolGltf_GetModel( take->gltf );
	const toolModel* clipModel = clipFile != NULL ? toolGltf_GetModel( take->clips ) : model;
	int32_t index = toolFindClip( clipModel, clip );
	good = toolMakeCharacter( model, file, scale, &take->character, &error ) &&
	    toolBindClip( &take->character, clipModel, index, &take->bound, &error );
	if ( good == false )
	{
		fail_msg( "%s", error.text );
	}
	take->travel = toolFindTravel( &take->character, &take->bound );
	take->def = toolDefaultBakeDef();
	take->path[0] = ( toolPlace ){ 1.0, (double)NAN, -2.0 };
	take->def.path = take->path;
	take->def.pathCount = 1;
	take->def.heading = 30.0;
	take->def.distance = 3.0;
	testMakeGround( take, 0.1f );
}

static void testRun( testTake* take, const char* method )
{
	toolError error = { { 0 } };
	take->def.method = toolFindMethod( method );
	assert_non_null( take->def.method );
	if ( toolBake( &take->character, &take->bound, &take->travel, take->ground, &take->def, &take->result, &error ) ==
	    false )
	{
		fail_msg( "%s", error.text );
	}
}

static void testClose( testTake* take )
{
	toolFreeBakeResult( &take->result );
	toolFreeBoundClip( &take->bound );
	toolFreeCharacter( &take->character );
	toolFreeGltf( take->gltf );
	toolFreeGltf( take->clips );
	soleDestroyGround( take->ground );
}

// Writes the take, reads it again and compares every node below the one that travels, at every frame.
static void testWritten( testTake* take, const char* method, double tolerance )
{
	toolClip clip;
	toolError error = { { 0 } };
	char path[1024];
	snprintf( path, sizeof path, "%s/test_bake_out.glb", SOLE_BINARY_DIR );
	toolMakeBakedClip( &take->character, &take->bound, &take->travel, method, NULL, &take->result, &clip );
	char name[256];
	snprintf( name, sizeof name, "%s", clip.name );
	for ( int32_t i = 0; i < clip.channelCount; ++i )
	{
		for ( int32_t k = 1; k < clip.channels[i].keyCount; ++k )
		{
			assert_true( clip.channels[i].times[k] > clip.channels[i].times[k - 1] );
		}
		assert_true( clip.channels[i].times[clip.channels[i].keyCount - 1] <= clip.end + 1e-4f );
	}
	// The file's model is renewed by appending: the character's own is kept by reading anew.
	toolGltf* file = NULL;
	if ( toolWriteGltf( take->gltf, path, &error ) == false || toolReadGltf( path, &file, &error ) == false ||
	    toolGltf_AppendClip( file, &clip, &error ) == false || toolWriteGltf( file, path, &error ) == false )
	{
		fail_msg( "%s", error.text );
	}
	toolFreeGltf( file );
	toolFreeClip( &clip );
	assert_true( toolReadGltf( path, &file, &error ) );
	const toolModel* model = toolGltf_GetModel( file );
	toolCharacter plain = { .model = model, .jointCount = model->nodeCount, .parents = take->character.parents };
	toolBoundClip bound;
	assert_true( toolBindClip( &plain, model, toolFindClip( model, name ), &bound, &error ) );
	assert_float_equal( bound.clip->start, 0.0f, 0.0f );

	size_t joints = (size_t)take->result.jointCount;
	soleTransform* pose = calloc( joints, sizeof *pose );
	double worst = 0.0;
	for ( int32_t i = 0; i < take->result.walk.frameCount; ++i )
	{
		const soleTransform* wanted = take->result.output + (size_t)i * joints;
		toolSampleClip( &plain, &bound, (float)( (double)i / take->result.walk.fps ), pose );
		for ( int32_t j = 0; j < plain.jointCount; ++j )
		{
			int32_t above = j;
			while ( above != SOLE_NONE && above != take->travel.node )
			{
				above = plain.parents[above];
			}
			if ( above != SOLE_NONE )
			{
				soleTransform world = toolPoseWorld( &take->character, wanted, j );
				soleVec3 a = soleTransformPoint( take->result.walk.roots[i], world.translation );
				soleVec3 b = toolPoseWorld( &plain, pose, j ).translation;
				worst = fmax( worst, (double)soleDistance( a, b ) );
			}
		}
	}
	free( pose );
	toolFreeBoundClip( &bound );
	toolFreeGltf( file );
	remove( path );
	if ( worst > tolerance )
	{
		fail_msg( "a node is %g m from where it was baked", worst );
	}
}

static void testCheckFile( const char* file, const char* clipFile, const char* clip, float scale, double tolerance )
{
	testTake take;
	testOpen( &take, file, clipFile, clip, scale );
	testRun( &take, "none" );
	testWritten( &take, "none", tolerance );
	toolFreeBakeResult( &take.result );
	testRun( &take, "sole" );
	testWritten( &take, "sole", tolerance );
	testClose( &take );
}

static void testAnInPlaceWalkIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testCheckFile( "human-quaternius-ual/human-base-animations.glb", NULL, "Walk_Loop", 1.0f, 1e-4 );
}

static void testRootMotionIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	testCheckFile( "human-pab-rootmotion/pab_arnaud.glb", NULL, "walk", 1.0f, 1e-4 );
	TEST_NEEDS_DATA( "kaiju-biped-tail/kaiju-animations.glb" );
	testCheckFile( "kaiju-biped-tail/kaiju-animations.glb", NULL, "Walk RM", 1.0f, 2e-4 );
}

static void testMotionCaptureIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "mocap-bvh/cmu_02_01_walk.glb" );
	testCheckFile( "mocap-bvh/cmu_02_01_walk.glb", NULL, "02_01", 1.0f, 1e-4 );
}

static void testATrunkThatLeansIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testTake take;
	soleSettings settings = soleDefaultSettings();
	settings.layer.lean = 1.0f;
	settings.target.secondFrom = 0.0f;
	settings.target.secondFull = 0.05f;
	testOpen( &take, "human-quaternius-ual/human-base-animations.glb", NULL, "Walk_Loop", 1.0f );
	take.def.settings = &settings;
	testRun( &take, "sole" );
	size_t last = (size_t)( take.result.walk.frameCount - 1 ) * (size_t)take.result.jointCount;
	size_t spine = last + (size_t)soleRig_GetSpine( take.character.rig );
	soleQuat turn =
	    soleMulQuat( soleConjugate( take.result.input[spine].rotation ), take.result.output[spine].rotation );
	assert_true( fabsf( turn.w ) < 0.9999f );
	testWritten( &take, "sole", 1e-4 );
	testClose( &take );
}

static void testAScaledCharacterIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testCheckFile( "human-quaternius-ual/human-base-animations.glb", NULL, "Walk_Loop", 2.0f, 2e-4 );
	testCheckFile( "human-pab-rootmotion/pab_arnaud.glb", NULL, "walk", 0.5f, 1e-4 );
}

static void testAClipOfAnotherFileIsWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-kaykit-mannequin/Med_MovementBasic.glb" );
	char clips[] = "human-kaykit-mannequin/Med_MovementBasic.glb";
	testCheckFile( "human-kaykit-mannequin/manny_med_mod.gltf", clips, "Rig_Medium|Walking_A", 1.0f, 1e-4 );
}

static void testDetachedFeetAreWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "robot-expressive/robot.glb" );
	testCheckFile( "robot-expressive/robot.glb", NULL, "Robot_Walking", 0.5f, 2e-4 );
}

static void testAncestorsAreWrittenAsBaked( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	TEST_NEEDS_DATA( "robot-expressive/robot.glb" );
	const char* methods[] = { "homebrew", "iksetting" };
	for ( int32_t i = 0; i < 2; ++i )
	{
		testTake take;
		testOpen( &take, "human-pab-rootmotion/pab_arnaud.glb", NULL, "walk", 1.0f );
		testRun( &take, methods[i] );
		testWritten( &take, methods[i], 1e-4 );
		testClose( &take );
		testOpen( &take, "robot-expressive/robot.glb", NULL, "Robot_Walking", 0.5f ); // detached feet
		testRun( &take, methods[i] );
		testWritten( &take, methods[i], 2e-4 );
		testClose( &take );
	}
}

static void testNoneLeavesThePoseAndBothGoTheSameWay( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testTake take;
	testOpen( &take, "human-quaternius-ual/human-base-animations.glb", NULL, "Walk_Loop", 1.0f );
	testRun( &take, "none" );
	size_t bytes = (size_t)take.result.walk.frameCount * (size_t)take.result.jointCount * sizeof *take.result.input;
	assert_memory_equal( take.result.input, take.result.output, bytes );
	toolBakeResult none = take.result;
	testRun( &take, "sole" );
	assert_memory_equal( none.input, take.result.input, bytes );
	assert_memory_equal(
	    none.walk.roots, take.result.walk.roots, (size_t)none.walk.frameCount * sizeof *none.walk.roots );
	toolFreeBakeResult( &none );
	testClose( &take );
}

static void testTheSameFramesAtTwiceTheRateAreTheSameInput( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-pab-rootmotion/pab_arnaud.glb" );
	testTake take;
	testOpen( &take, "human-pab-rootmotion/pab_arnaud.glb", NULL, "walk", 1.0f );
	take.def.fps = 30.0;
	testRun( &take, "none" );
	toolBakeResult slow = take.result;
	take.def.fps = 60.0;
	testRun( &take, "none" );
	size_t joints = (size_t)slow.jointCount;
	for ( int32_t i = 0; i < slow.walk.frameCount; ++i )
	{
		const soleTransform* a = slow.input + (size_t)i * joints;
		const soleTransform* b = take.result.input + 2 * (size_t)i * joints;
		for ( size_t j = 0; j < joints; ++j )
		{
			testNear3( a[j].translation, b[j].translation, 2e-4f );
		}
	}
	toolFreeBakeResult( &slow );
	testClose( &take );
}

static void testChannelsOutsideTheLegsKeepTheirKeys( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testTake take;
	testOpen( &take, "human-quaternius-ual/human-base-animations.glb", NULL, "Walk_Loop", 1.0f );
	testRun( &take, "sole" );
	toolClip clip;
	toolMakeBakedClip( &take.character, &take.bound, &take.travel, "sole", NULL, &take.result, &clip );
	int32_t head = toolFindNode( toolGltf_GetModel( take.gltf ), "DEF-upper_arm.L" );
	int found = 0;
	for ( int32_t i = 0; i < clip.channelCount; ++i )
	{
		const toolChannel* channel = clip.channels + i;
		if ( channel->node == head && channel->path == tool_pathRotation )
		{
			// 24 keys a second, not 60; a second round begins where the first ends.
			float step = channel->times[2] - channel->times[1];
			assert_float_equal( step, 1.0f / 24.0f / (float)take.result.walk.rate, 1e-4f );
			assert_true( channel->times[channel->keyCount - 1] > take.bound.duration );
			++found;
		}
	}
	assert_int_equal( found, 1 );
	assert_string_equal( clip.name, "Walk_Loop|sole" );
	assert_non_null( strstr( clip.extras, "\"method\":\"sole\"" ) );
	toolFreeClip( &clip );
	testClose( &take );
}

// ------------------------------------------------------------------------------------------------------- settings

static void testSettingsGoToTextAndBack( void** state )
{
	(void)state;
	toolError error;
	soleSettings settings = soleDefaultSettings();
	settings.probe.radius = 0.123f;
	settings.probe.mask = 4294967294u;
	settings.contact.speedOn = 0.1f;
	char* text = toolFormatSettings( &settings );
	soleSettings read = soleDefaultSettings();
	assert_true( toolParseSettings( text, strlen( text ), "S", &read, &error ) );
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		assert_true( soleSettings_Get( &read, infos + i ) == soleSettings_Get( &settings, infos + i ) );
	}
	free( text );
}

static void testBadSettingsAreNamedAndChangeNothing( void** state )
{
	(void)state;
	const char* bad[][2] = {
		{ "{ \"probe\": { \"radius\": 0.2, \"radios\": 1 } }", "probe.radios is no setting" },
		{ "{ \"prob\": { } }", "prob is no group" },
		{ "{ \"probe\": 3 }", "probe is not an object" },
		{ "{ \"probe\": { \"radius\": \"wide\" } }", "probe.radius is not a number" },
		{ "{ \"probe\": { \"layout\": 1.5 } }", "probe.layout is not a whole number" },
		{ "{ \"probe\": { \"radius\": 99 } }", "from 0.001 to 0.3 L" },
		{ "{ \"probe\": { \"radius\": NaN } }", "S: " },
		{ "{ \"probe\": ", "it ends early" },
		{ "[]", "is not a JSON object" },
		{ "{} {}", "S: is no JSON" },
		{ "", "it ends early" },
	};
	for ( size_t i = 0; i < sizeof bad / sizeof *bad; ++i )
	{
		toolError error = { { 0 } };
		soleSettings settings = soleDefaultSettings();
		assert_false( toolParseSettings( bad[i][0], strlen( bad[i][0] ), "S", &settings, &error ) );
		if ( strstr( error.text, bad[i][1] ) == NULL )
		{
			fail_msg( "%s: %s", bad[i][0], error.text );
		}
		assert_true( settings.probe.radius == soleDefaultSettings().probe.radius );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testAnInPlaceWalkIsWrittenAsBaked ),
		cmocka_unit_test( testRootMotionIsWrittenAsBaked ),
		cmocka_unit_test( testMotionCaptureIsWrittenAsBaked ),
		cmocka_unit_test( testATrunkThatLeansIsWrittenAsBaked ),
		cmocka_unit_test( testAScaledCharacterIsWrittenAsBaked ),
		cmocka_unit_test( testAClipOfAnotherFileIsWrittenAsBaked ),
		cmocka_unit_test( testDetachedFeetAreWrittenAsBaked ),
		cmocka_unit_test( testAncestorsAreWrittenAsBaked ),
		cmocka_unit_test( testNoneLeavesThePoseAndBothGoTheSameWay ),
		cmocka_unit_test( testTheSameFramesAtTwiceTheRateAreTheSameInput ),
		cmocka_unit_test( testChannelsOutsideTheLegsKeepTheirKeys ),
		cmocka_unit_test( testSettingsGoToTextAndBack ),
		cmocka_unit_test( testBadSettingsAreNamedAndChangeNothing ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
