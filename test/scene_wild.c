// SPDX-License-Identifier: MIT
// T54: random poses, hits, weights and steps of time; bones of no length, hits above the hips, normals that are zero or
// not finite. World space, metres.
#include "test.h"

#include "scene_meter.h"
#include "scene_wild.h"

#define MOST_BEND 2.4f // rad, of a knee that goes in

typedef struct testWildHost
{
	soleState state;
	soleSettings settings;
	soleTransform pose[MOST_JOINTS];
	soleProbe probes[SOLE_MAX_PROBES];
	soleHit hits[SOLE_MAX_PROBES];
	uint32_t seed;
} testWildHost;

static float testPick( testWildHost* host, float low, float high )
{
	return testRandomFloat( &host->seed, low, high );
}

static bool testHappens( testWildHost* host, uint32_t oneOf )
{
	return testRandom( &host->seed ) % oneOf == 0;
}

static soleVec3 testPickVector( testWildHost* host, float size )
{
	float x = testPick( host, -size, size );
	float y = testPick( host, -size, size );
	return soleVec( x, y, testPick( host, -size, size ) );
}

static soleQuat testPickTurn( testWildHost* host, soleVec3 axis, float low, float high )
{
	float half = 0.5f * testPick( host, low, high );
	soleVec3 sine = soleScale( (float)sin( (double)half ), soleNormalizeOr( axis, soleVec( 0.0f, 1.0f, 0.0f ) ) );
	return ( soleQuat ){ sine.x, sine.y, sine.z, (float)cos( (double)half ) };
}

/// Hips, ankles and pelvis any way, knees bent the right way.
static void testPickPose( testWildHost* host, const toolCharacter* character )
{
	memcpy( host->pose, character->bindPose, (size_t)character->jointCount * sizeof *host->pose );
	soleTransform* pelvis = host->pose + character->rigDef.pelvis;
	pelvis->translation = soleAdd( pelvis->translation, testPickVector( host, 0.5f ) );
	pelvis->rotation = testPickTurn( host, testPickVector( host, 1.0f ), -3.0f, 3.0f );
	for ( int32_t side = 0; side < 2; ++side )
	{
		const soleLegDef* leg = character->rigDef.legs + side;
		soleLegDef known = soleRig_GetLeg( character->rig, side );
		soleTransform* hip = host->pose + leg->joints[0];
		soleTransform* knee = host->pose + leg->joints[1];
		soleTransform* ankle = host->pose + leg->joints[2];
		hip->rotation = testPickTurn( host, testPickVector( host, 1.0f ), -2.0f, 2.0f );
		soleQuat shin = toolPoseWorld( character, character->bindPose, leg->joints[1] ).rotation;
		soleVec3 hinge = soleInvRotate( shin, known.hinge );
		knee->rotation = soleMulQuat( knee->rotation, testPickTurn( host, hinge, 0.05f, MOST_BEND ) );
		ankle->rotation = testPickTurn( host, testPickVector( host, 1.0f ), -1.0f, 1.0f );
		if ( testHappens( host, 50 ) )
		{
			soleTransform* bones[2] = { knee, ankle };
			bones[testRandom( &host->seed ) % 2]->translation = soleVec( 0.0f, 0.0f, 0.0f );
		}
	}
}

static void testPickHit( testWildHost* host, const soleProbe* probe, soleHit* hit )
{
	static const float s_wild[] = { NAN, INFINITY, -INFINITY, 0.0f, 1e30f, -1e30f };
	*hit = ( soleHit ){ .hit = !testHappens( host, 8 ), .surface = SOLE_NONE, .asked_w = probe->start_w };
	hit->startedInside = testHappens( host, 20 );
	hit->point_w = soleMulAdd( probe->start_w, testPick( host, -0.5f, 1.5f ) * probe->length, probe->direction_w );
	hit->normal_w = soleNormalizeOr( testPickVector( host, 1.0f ), soleVec( 0.0f, 1.0f, 0.0f ) );
	hit->velocity_w = testPickVector( host, 2.0f );
	if ( testHappens( host, 30 ) )
	{
		float* numbers[] = { &hit->point_w.y, &hit->normal_w.x, &hit->normal_w.y, &hit->velocity_w.z };
		*numbers[testRandom( &host->seed ) % 4] = s_wild[testRandom( &host->seed ) % 6];
	}
	hit->normal_w = testHappens( host, 30 ) ? soleVec( 0.0f, 0.0f, 0.0f ) : hit->normal_w;
}

static bool testIsOutputFinite( const soleOutput* out )
{
	bool finite = soleVec3_IsFinite( out->pelvisTranslation_l ) && soleVec3_IsFinite( out->pelvisOffset_w );
	for ( int32_t side = 0; side < 2; ++side )
	{
		const soleLegOutput* leg = out->legs + side;
		for ( int32_t i = 0; i < SOLE_MAX_LEG_JOINTS; ++i )
		{
			finite = finite && soleQuat_IsFinite( leg->rotations_l[i] );
		}
		finite = finite && soleQuat_IsFinite( leg->toeRotation_l ) && soleVec3_IsFinite( leg->ankle_w ) &&
		    soleVec3_IsFinite( leg->ankleTarget_w ) && soleIsFinite( leg->error + leg->extension + leg->heightDemand );
	}
	return finite;
}

static testKnee testFindWildKnee( const toolCharacter* character, const soleTransform* pose, int32_t side )
{
	soleLegDef def = soleRig_GetLeg( character->rig, side );
	soleTransform hip = toolPoseWorld( character, pose, def.joints[0] );
	soleQuat bind = toolPoseWorld( character, character->bindPose, def.joints[0] ).rotation;
	testLegPose leg = {
		.hip = hip.translation,
		.knee = toolPoseWorld( character, pose, def.joints[1] ).translation,
		.foot = toolPoseWorld( character, pose, def.joints[2] ),
		.hinge = soleRotate( hip.rotation, soleInvRotate( bind, def.hinge ) ),
	};
	return testFindKnee( &leg );
}

static void testJudgeWild( const toolCharacter* character, testWildHost* host, const soleOutput* out, testWild* wild )
{
	soleTransform placed[MOST_JOINTS];
	memcpy( placed, host->pose, sizeof placed );
	soleApply( character->rig, out, placed );
	wild->broken += testIsOutputFinite( out ) ? 0 : 1;
	for ( int32_t side = 0; side < 2; ++side )
	{
		testKnee before = testFindWildKnee( character, host->pose, side );
		testKnee after = testFindWildKnee( character, placed, side );
		bool whole = ( out->legs[side].flags & (uint32_t)sole_legDegenerate ) == 0;
		wild->straight = fmax( wild->straight, whole ? fmin( before.bend, 2.0 ) - after.bend : 0.0 );
		wild->reach = fmax( wild->reach, whole ? after.reach - fmax( before.reach, 0.995 ) : 0.0 );
	}
}

testWild testTryAnything( const testActor* actor, int32_t poseCount )
{
	const toolCharacter* character = &actor->character;
	testWildHost* host = calloc( 1, sizeof *host );
	assert_non_null( host );
	host->state = soleDefaultState( character->rig );
	host->settings = soleDefaultSettings();
	host->seed = 977;
	testWild wild = { .reach = -1.0, .straight = -180.0 };
	for ( int32_t i = 0; i < poseCount; ++i )
	{
		testPickPose( host, character );
		soleFrame frame = { .pose = host->pose, .root = soleTransform_Identity(), .up = soleVec( 0.0f, 1.0f, 0.0f ) };
		frame.root.translation = testPickVector( host, 0.3f );
		frame.timeStep = testPick( host, 0.0f, 0.05f );
		frame.weight = testPick( host, 0.0f, 1.2f );
		int32_t count =
		    soleGatherProbes( character->rig, &host->settings, &host->state, &frame, host->probes, SOLE_MAX_PROBES );
		for ( int32_t k = 0; k < count; ++k )
		{
			testPickHit( host, host->probes + k, host->hits + k );
		}
		soleOutput out;
		soleSolve( character->rig, &host->settings, &host->state, &frame, host->hits, count, &out );
		testJudgeWild( character, host, &out, &wild );
	}
	free( host );
	return wild;
}
