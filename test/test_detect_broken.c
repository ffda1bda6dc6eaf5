// SPDX-License-Identifier: MIT
// Detection on skeletons that are none: refused by name, or answered, whatever they are made of.
#include "detect_body.h"

static soleResult testRefused( const soleSkeleton* skeleton )
{
	soleRigDef def = soleDefaultRigDef();
	soleResult result = soleDetectRig( skeleton, &def, &testReport );
	if ( result != sole_success )
	{
		assert_true( testCount( sole_error ) > 0 );
		const soleFinding* last = testReport.findings + testReport.findingCount - 1;
		assert_true( last->what[0] != 0 && last->mend[0] != 0 );
	}
	return result;
}

static void withoutLegsItSaysWhatItLookedFor( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	body.skeleton.jointCount = joint_hipL;
	assert_int_equal( testRefused( &body.skeleton ), sole_notFound );
	assert_non_null( strstr( testReport.findings[testReport.findingCount - 1].what, "looked for" ) );
}

static void brokenSkeletonsAreRefused( void** state )
{
	(void)state;
	testBody body;
	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	body.parents[joint_root] = joint_toeL;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );
	body.parents[joint_root] = joint_root;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );
	body.parents[joint_root] = 1000;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );
	body.parents[joint_root] = -7;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );

	testMakeBody( &body, soleQuat_Identity(), 1.0f, false );
	body.bind[joint_kneeL].translation.y = NAN;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );
	body.bind[joint_kneeL].translation.y = 3e38f;
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );

	testMakeBody( &body, soleQuat_Identity(), 0.0f, false );
	assert_int_equal( testRefused( &body.skeleton ), sole_invalidDefinition );

	soleSkeleton empty = { 0 };
	assert_int_equal( testRefused( &empty ), sole_invalidDefinition );
	empty.jointCount = INT32_MAX;
	assert_int_equal( testRefused( &empty ), sole_invalidDefinition );
	empty.jointCount = -5;
	assert_int_equal( testRefused( &empty ), sole_invalidDefinition );
}

/// A chain as long as a file can make it must neither hang nor overflow.
static void endlessChainsAreRefused( void** state )
{
	(void)state;
	const int32_t count = 65535;
	int32_t* parents = calloc( (size_t)count, sizeof *parents );
	soleTransform* bind = calloc( (size_t)count, sizeof *bind );
	const char** names = calloc( (size_t)count, sizeof *names );
	for ( int32_t i = 0; i < count; ++i )
	{
		static const char* const words[] = { "thigh_l", "calf_l", "foot_l", "ik_hand" };
		parents[i] = i - 1;
		bind[i] = soleTransform_Identity();
		bind[i].translation.y = 0.001f;
		names[i] = words[i % 4];
	}
	soleSkeleton skeleton = { .jointCount = count, .parents = parents, .bindPose = bind, .names = names };
	assert_int_equal( testRefused( &skeleton ), sole_invalidDefinition );
	for ( int32_t i = 0; i < count; ++i )
	{
		parents[i] = i % 900 == 0 ? ( i == 0 ? SOLE_NONE : 0 ) : i - 1;
	}
	soleRigDef def = soleDefaultRigDef();
	soleDetectRig( &skeleton, &def, &testReport );
	free( parents );
	free( bind );
	free( names );
}

/// Skeletons of random shape and numbers, some of them absurd: an answer, whatever it is.
static void noiseIsAnswered( void** state )
{
	(void)state;
	uint32_t seed = 12345;
	static const char* const words[] = { "foot_l", "thigh_l", "calf_l", "foot_r", "LeftLeg", "RightUpLeg", "toe.L",
		"" };
	for ( int32_t round = 0; round < 400; ++round )
	{
		testBody body = { 0 };
		int32_t count = 1 + (int32_t)( testRandom( &seed ) % JOINT_LIMIT );
		soleSkinVertex skin[16];
		for ( int32_t i = 0; i < count; ++i )
		{
			body.parents[i] = i == 0 ? SOLE_NONE : (int32_t)( testRandom( &seed ) % (uint32_t)i );
			float size = testRandom( &seed ) % 8 == 0 ? 0.0f : ( testRandom( &seed ) % 64 == 0 ? 1e14f : 1.0f );
			body.bind[i] = soleTransform_Identity();
			body.bind[i].translation = soleVec( size * testRandomFloat( &seed, -1.0f, 1.0f ),
			    size * testRandomFloat( &seed, -1.0f, 1.0f ), size * testRandomFloat( &seed, -1.0f, 1.0f ) );
			body.names[i] = words[testRandom( &seed ) % 8];
		}
		for ( int32_t i = 0; i < 16; ++i )
		{
			skin[i].position = soleVec( testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ),
			    testRandom( &seed ) % 9 == 0 ? NAN : 0.0f );
			for ( int32_t k = 0; k < 4; ++k )
			{
				skin[i].joints[k] = (int32_t)( testRandom( &seed ) % 40 ) - 2;
				skin[i].weights[k] = testRandomFloat( &seed, -0.5f, 1.0f );
			}
		}
		body.skeleton.jointCount = count;
		body.skeleton.parents = body.parents;
		body.skeleton.bindPose = body.bind;
		body.skeleton.names = body.names;
		body.skeleton.skin = round % 2 == 0 ? skin : NULL;
		body.skeleton.skinCount = round % 2 == 0 ? 16 : 0;
		body.skeleton.samplePoses = body.bind;
		body.skeleton.poseCount = 1;
		soleRigDef def = soleDefaultRigDef();
		soleMessage message;
		if ( soleDetectRig( &body.skeleton, &def, &testReport ) == sole_success && testCount( sole_error ) == 0 )
		{
			soleResult valid = soleRigDef_Validate( &def, &message );
			if ( valid != sole_success )
			{
				print_message( "%s\n", message.text );
			}
			assert_int_equal( valid, sole_success );
		}
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( withoutLegsItSaysWhatItLookedFor ),
		cmocka_unit_test( brokenSkeletonsAreRefused ),
		cmocka_unit_test( endlessChainsAreRefused ),
		cmocka_unit_test( noiseIsAnswered ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
