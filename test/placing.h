// SPDX-License-Identifier: MIT
// The plain biped placed frame by frame: grounds that are known exactly, one character's run over them, and where its
// joints and sole points then are, by forward kinematics. World: metres, y up unless the ground is turned.
#ifndef TEST_PLACING_H
#define TEST_PLACING_H

#include "test.h"

#include "biped.h"

/// A ground in a world that may be turned: height over (x, z) of the upright world and the turn to the real one. All of
/// its parts add up.
typedef struct testGround
{
	float slopeX, slopeZ; // rise per metre
	float stepX;          // height of the half x > 0
	float hole;           // nothing there where z > hole
	soleQuat turn;
	float scale;
	float stairs; // where the first riser is; the stairs go up along z
	float tread;  // 0: there are none
	float rise;
	float barFrom, barTo; // along z: higher by barHeight in between, where x > 0
	float barHeight;
} testGround;

static const testGround testFlatGround = { .hole = 1e9f, .turn = { 0.0f, 0.0f, 0.0f, 1.0f }, .scale = 1.0f };

static inline float testGroundHeight( const testGround* ground, float x, float z )
{
	float height = ground->slopeX * x + ground->slopeZ * z + ( x > 0.0f ? ground->stepX : 0.0f );
	if ( ground->tread > 0.0f && z > ground->stairs )
	{
		height += ground->rise * ceilf( ( z - ground->stairs ) / ground->tread );
	}
	return height + ( x > 0.0f && z > ground->barFrom && z < ground->barTo ? ground->barHeight : 0.0f );
}

static inline void testCastAt( const testGround* ground, const soleProbe* probe, soleHit* hit )
{
	memset( hit, 0, sizeof *hit );
	hit->surface = SOLE_NONE;
	hit->asked_w = probe->start_w;
	soleVec3 start = soleScale( 1.0f / ground->scale, soleInvRotate( ground->turn, probe->start_w ) );
	if ( !( probe->length > 0.0f ) || start.z > ground->hole )
	{
		return;
	}
	float height = testGroundHeight( ground, start.x, start.z );
	float way = start.y - height;
	if ( way < 0.0f || way > probe->length / ground->scale )
	{
		return;
	}
	hit->hit = true;
	hit->point_w = soleRotate( ground->turn, soleScale( ground->scale, soleVec( start.x, height, start.z ) ) );
	soleVec3 normal = soleNormalizeOr( soleVec( -ground->slopeX, 1.0f, -ground->slopeZ ), soleVec( 0.0f, 1.0f, 0.0f ) );
	hit->normal_w = soleRotate( ground->turn, normal );
}

static inline void testStep( const testBiped* biped, const soleSettings* settings, soleState* state,
    const soleFrame* frame, const testGround* ground, soleOutput* out )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	int32_t n = soleGatherProbes( biped->rig, settings, state, frame, probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < n; ++i )
	{
		testCastAt( ground, probes + i, hits + i );
	}
	soleSolve( biped->rig, settings, state, frame, hits, n, out );
}

static inline soleFrame testFrame( const soleTransform* pose )
{
	return ( soleFrame ){ .pose = pose,
		.root = soleTransform_Identity(),
		.up = { 0.0f, 1.0f, 0.0f },
		.timeStep = 1.0f / 60.0f,
		.weight = 1.0f };
}

// ------------------------------------------------------------------------------------------------- one character

/// A character that is placed over one ground, and all that a test may change between frames. Not to be copied: its
/// frame points to its pose.
typedef struct testRun
{
	testBiped biped;
	soleSettings settings;
	soleState state;
	soleFrame frame;
	testGround ground;
	soleTransform pose[biped_count];   // animated
	soleTransform placed[biped_count]; // what came of it
	soleOutput out;
} testRun;

/// Flat ground, the knees bent, at the origin.
static inline void testStartRun( testRun* run, float flexion )
{
	memset( run, 0, sizeof *run );
	testMakeBiped( &run->biped );
	memcpy( run->pose, run->biped.bindPose, sizeof run->pose );
	testBendKnees( run->pose, flexion );
	run->settings = soleDefaultSettings();
	run->state = soleDefaultState( run->biped.rig );
	run->frame = testFrame( run->pose );
	run->ground = testFlatGround;
}

static inline void testEndRun( testRun* run )
{
	soleDestroyRig( run->biped.rig );
}

static inline void testPlace( testRun* run )
{
	memcpy( run->placed, run->pose, sizeof run->placed );
	soleApply( run->biped.rig, &run->out, run->placed );
}

static inline void testStepRun( testRun* run )
{
	testStep( &run->biped, &run->settings, &run->state, &run->frame, &run->ground, &run->out );
	testPlace( run );
}

static inline void testStepSeconds( testRun* run, float seconds )
{
	int32_t count = (int32_t)( seconds / run->frame.timeStep + 0.5f );
	for ( int32_t i = 0; i < count; ++i )
	{
		testStepRun( run );
	}
}

static inline int32_t testAnkle( int32_t leg )
{
	return leg == 0 ? biped_ankleL : biped_ankleR;
}

/// A joint as animated and as placed, world.
static inline soleTransform testAnimatedJoint( const testRun* run, int32_t joint )
{
	return testJoint( &run->biped, run->pose, run->frame.root, joint );
}

static inline soleTransform testPlacedJoint( const testRun* run, int32_t joint )
{
	return testJoint( &run->biped, run->placed, run->frame.root, joint );
}

/// A point of the sole as placed, world.
/// @param fore carried by the toes
static inline soleVec3 testPlacedPoint( const testRun* run, int32_t leg, soleVec3 bindPoint, bool fore )
{
	soleVec3 local = soleRig_ToFootSpace( run->biped.rig, leg, bindPoint, fore );
	int32_t joint = soleRig_GetFootJoint( run->biped.rig, leg, fore );
	return soleTransformPoint( testPlacedJoint( run, joint ), local );
}

#define TEST_SOLE_POINTS 27

/// Points along the middle of a sole as placed, 1 cm apart, heel first, world.
static inline void testPlacedSole( const testRun* run, int32_t leg, soleVec3 points[TEST_SOLE_POINTS] )
{
	soleSolePoints sole = soleRig_GetLeg( run->biped.rig, leg ).sole;
	for ( int32_t i = 0; i < TEST_SOLE_POINTS; ++i )
	{
		float share = (float)i / (float)( TEST_SOLE_POINTS - 1 );
		soleVec3 p = soleLerp( sole.heel, sole.toe, share );
		points[i] = testPlacedPoint( run, leg, p, p.z > sole.ball.z );
	}
}

/// How far a sole is over the ground at its lowest, below zero: inside. Upright ground only.
static inline float testSoleClearance( const testRun* run, int32_t leg )
{
	soleVec3 points[TEST_SOLE_POINTS];
	testPlacedSole( run, leg, points );
	float least = 1e9f;
	for ( int32_t i = 0; i < TEST_SOLE_POINTS; ++i )
	{
		float height = testGroundHeight( &run->ground, points[i].x, points[i].z );
		least = fminf( least, points[i].y - height );
	}
	return least;
}

/// Angle between two turns, radians: from the chord of their quaternions, which is exact near zero.
static inline float testAngle( soleQuat a, soleQuat b )
{
	b = soleDotQuat( a, b ) < 0.0f ? soleNegQuat( b ) : b;
	float x = a.x - b.x, y = a.y - b.y, z = a.z - b.z, w = a.w - b.w;
	return 4.0f * asinf( fminf( 0.5f * sqrtf( x * x + y * y + z * z + w * w ), 1.0f ) );
}

/// Largest angle between the local turns of a joint of two poses.
static inline float testLargestTurn( const soleTransform* a, const soleTransform* b )
{
	float largest = 0.0f;
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		largest = fmaxf( largest, testAngle( a[j].rotation, b[j].rotation ) );
	}
	return largest;
}

/// Largest distance between the places of a joint of two poses, character space.
static inline float testLargestMove( const testBiped* biped, const soleTransform* a, const soleTransform* b )
{
	float largest = 0.0f;
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		soleTransform at = testJoint( biped, a, soleTransform_Identity(), j );
		soleTransform bt = testJoint( biped, b, soleTransform_Identity(), j );
		largest = fmaxf( largest, soleDistance( at.translation, bt.translation ) );
	}
	return largest;
}

#endif
