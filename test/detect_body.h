// SPDX-License-Identifier: MIT
// A made-up body for tests of detection: any names, turned, mirrored, scaled; and what is found in it.
#ifndef TEST_DETECT_BODY_H
#define TEST_DETECT_BODY_H

#include "test.h"

#include "sole/detect.h"
#include "sole/sole.h"

#define JOINT_LIMIT 32

/// Joints of the made-up body: where they are, Y up, facing +Z, metres.
enum
{
	joint_root,
	joint_pelvis,
	joint_spine,
	joint_head,
	joint_hipL,
	joint_kneeL,
	joint_ankleL,
	joint_toeL,
	joint_hipR,
	joint_kneeR,
	joint_ankleR,
	joint_toeR,
	joint_armL,
	joint_handL,
	joint_armR,
	joint_handR,
	joint_count
};

static const int32_t testParents[joint_count] = { SOLE_NONE, joint_root, joint_pelvis, joint_spine, joint_pelvis,
	joint_hipL, joint_kneeL, joint_ankleL, joint_pelvis, joint_hipR, joint_kneeR, joint_ankleR, joint_spine, joint_armL,
	joint_spine, joint_armR };
static const soleVec3 testPlaces[joint_count] = {
	{ 0.0f, 0.0f, 0.0f },
	{ 0.0f, 0.98f, 0.0f },
	{ 0.0f, 1.35f, -0.01f },
	{ 0.0f, 1.6f, 0.0f },
	{ 0.09f, 0.93f, 0.0f },
	{ 0.1f, 0.5f, 0.02f },
	{ 0.1f, 0.09f, -0.02f },
	{ 0.1f, 0.02f, 0.11f },
	{ -0.09f, 0.93f, 0.0f },
	{ -0.1f, 0.5f, 0.02f },
	{ -0.1f, 0.09f, -0.02f },
	{ -0.1f, 0.02f, 0.11f },
	{ 0.18f, 1.4f, 0.0f },
	{ 0.7f, 1.4f, 0.0f },
	{ -0.18f, 1.4f, 0.0f },
	{ -0.7f, 1.4f, 0.0f },
};

typedef struct testBody
{
	int32_t parents[JOINT_LIMIT];
	soleTransform bind[JOINT_LIMIT];
	const char* names[JOINT_LIMIT];
	soleJointRole roles[JOINT_LIMIT];
	soleSkeleton skeleton;
} testBody;

static soleDetectReport testReport;

/// Parent-local transforms with some rotation or other in every joint, as exporters make them.
static inline void testPlaceBody(
    testBody* body, const soleVec3* places, int32_t count, soleQuat turn, float scale, bool mirror )
{
	uint32_t seed = 7;
	soleTransform world[JOINT_LIMIT];
	for ( int32_t i = 0; i < count; ++i )
	{
		soleVec3 p = places[i];
		p.x = mirror ? -p.x : p.x;
		soleQuat q = { testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ),
			testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ) };
		world[i].translation = soleRotate( turn, soleScale( scale, p ) );
		world[i].rotation = soleNormalizeQuat( q );
		world[i].scale = soleVec( 1.0f, 1.0f, 1.0f );
		int32_t parent = body->parents[i];
		body->bind[i] = world[i];
		if ( parent != SOLE_NONE )
		{
			body->bind[i].translation = soleInvTransformPoint( world[parent], world[i].translation );
			body->bind[i].rotation = soleMulQuat( soleConjugate( world[parent].rotation ), world[i].rotation );
		}
	}
	body->skeleton.jointCount = count;
	body->skeleton.parents = body->parents;
	body->skeleton.bindPose = body->bind;
	body->skeleton.names = body->names;
}

static inline void testMakeBody( testBody* body, soleQuat turn, float scale, bool mirror )
{
	*body = ( testBody ){ 0 };
	memcpy( body->parents, testParents, sizeof testParents );
	testPlaceBody( body, testPlaces, joint_count, turn, scale, mirror );
}

static inline int32_t testCount( soleSeverity severity )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < testReport.findingCount; ++i )
	{
		count += testReport.findings[i].severity == severity ? 1 : 0;
	}
	return count;
}

static inline void testPrint( void )
{
	for ( int32_t i = 0; i < testReport.findingCount; ++i )
	{
		const soleFinding* f = testReport.findings + i;
		print_message( "  %d %s: %s [%s]\n", (int)f->severity, f->where, f->what, f->mend );
	}
}

static inline soleRigDef testDetect( const testBody* body )
{
	soleRigDef def = soleDefaultRigDef();
	soleResult result = soleDetectRig( &body->skeleton, &def, &testReport );
	if ( result != sole_success || def.legCount != 2 )
	{
		testPrint();
	}
	assert_int_equal( result, sole_success );
	soleMessage message;
	soleResult valid = soleRigDef_Validate( &def, &message );
	if ( valid != sole_success )
	{
		print_message( "%s\n", message.text );
	}
	assert_int_equal( valid, sole_success );
	return def;
}

#endif
