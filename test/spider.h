// SPDX-License-Identifier: MIT
// A spider: a body 0.20 high on eight legs of 0.50, feet at a radius of 0.45, that walks with four of them at a time.
// Character space, in place: y up, ahead along +z; metres.
#ifndef TEST_SPIDER_H
#define TEST_SPIDER_H

#include "test.h"

#include "sole/sole.h"

#include <math.h>

#define SPIDER_LEGS 8
#define SPIDER_JOINTS ( 2 + 3 * SPIDER_LEGS )
#define SPIDER_BODY 1
#define SPIDER_BONE 0.25f
#define SPIDER_HEIGHT 0.20f // of the hips over the soles
#define SPIDER_HIP 0.10f    // of the hips from the middle
#define SPIDER_FOOT 0.45f
#define SPIDER_SOLE 0.02f // of the ankle over it
#define SPIDER_STANCE 0.625f
#define SPIDER_LIFT 0.06f

typedef struct testSpider
{
	int32_t parents[SPIDER_JOINTS];
	soleTransform bindPose[SPIDER_JOINTS];
	soleRig* rig;
} testSpider;

/// The first of a leg's joints.
static inline int32_t testSpiderHip( int32_t leg )
{
	return 2 + 3 * leg;
}

/// The way out along a leg, horizontal: four to the left, then four to the right, from the front.
static inline soleVec3 testSpiderOut( int32_t leg )
{
	const float degrees[] = { 28.0f, 66.0f, 114.0f, 152.0f };
	float angle = 0.01745329f * degrees[leg % 4];
	return soleVec( leg < 4 ? sinf( angle ) : -sinf( angle ), 0.0f, cosf( angle ) );
}

/// Where a leg's ankle is at rest.
static inline soleVec3 testSpiderFoot( int32_t leg )
{
	return soleMulAdd( soleVec( 0.0f, SPIDER_SOLE, 0.0f ), SPIDER_FOOT, testSpiderOut( leg ) );
}

/// Knee of a leg whose ankle is there, over the line from hip to ankle.
static inline soleVec3 testSpiderKnee( soleVec3 hip, soleVec3 ankle )
{
	soleVec3 line = soleSub( ankle, hip );
	float half = 0.5f * soleLength( line );
	soleVec3 over = soleNormalizeOr( soleReject( soleVec( 0.0f, 1.0f, 0.0f ), soleNormalizeOr( line, line ) ), line );
	float rise = sqrtf( fmaxf( SPIDER_BONE * SPIDER_BONE - half * half, 0.0f ) );
	return soleMulAdd( soleMulAdd( hip, 0.5f, line ), rise, over );
}

static inline soleVec3 testSpiderHipPlace( int32_t leg )
{
	return soleMulAdd( soleVec( 0.0f, SPIDER_HEIGHT, 0.0f ), SPIDER_HIP, testSpiderOut( leg ) );
}

/// Bends a leg so that its ankle is there, its foot level.
static inline void testPutSpiderFoot( const testSpider* spider, int32_t leg, soleVec3 ankle, soleTransform* pose )
{
	int32_t hip = testSpiderHip( leg );
	soleVec3 place = testSpiderHipPlace( leg );
	soleVec3 knee = testSpiderKnee( place, ankle );
	soleVec3 side = soleVec( 0.0f, 1.0f, 0.0f );
	soleVec3 thigh = soleScale( 1.0f / SPIDER_BONE, spider->bindPose[hip + 1].translation );
	soleVec3 shin = soleScale( 1.0f / SPIDER_BONE, spider->bindPose[hip + 2].translation );
	soleQuat upper = soleFromTo( thigh, soleNormalizeOr( soleSub( knee, place ), thigh ), side );
	soleQuat lower = soleFromTo( shin, soleNormalizeOr( soleSub( ankle, knee ), shin ), side );
	pose[hip].rotation = upper;
	pose[hip + 1].rotation = soleMulQuat( soleConjugate( upper ), lower );
	pose[hip + 2].rotation = soleConjugate( lower );
}

static inline soleLegDef testSpiderLeg( int32_t leg )
{
	static const char* const names[SPIDER_LEGS] = { "left 1", "left 2", "left 3", "left 4", "right 1", "right 2",
		"right 3", "right 4" };
	soleLegDef def = soleDefaultLegDef();
	soleVec3 under = testSpiderFoot( leg );
	under.y = 0.0f;
	float out = leg < 4 ? 0.015f : -0.015f;
	def.name = names[leg];
	def.side = leg < 4 ? sole_left : sole_right;
	def.jointCount = 3;
	for ( int32_t i = 0; i < 3; ++i )
	{
		def.joints[i] = testSpiderHip( leg ) + i;
	}
	def.hinge = soleCross( testSpiderOut( leg ), soleVec( 0.0f, -1.0f, 0.0f ) );
	def.sole.heel = soleAdd( under, soleVec( 0.0f, 0.0f, -0.02f ) );
	def.sole.ball = soleAdd( under, soleVec( 0.0f, 0.0f, 0.01f ) );
	def.sole.toe = soleAdd( under, soleVec( 0.0f, 0.0f, 0.02f ) );
	def.sole.inner = soleAdd( under, soleVec( -out, 0.0f, 0.01f ) );
	def.sole.outer = soleAdd( under, soleVec( out, 0.0f, 0.01f ) );
	// A claw turns as it likes.
	def.ankleLimits = ( soleAnkleLimits ){ 1.5f, 1.5f, 1.5f, 1.5f, 1.5f };
	return def;
}

static inline void testMakeSpider( testSpider* spider )
{
	soleRigDef def = soleDefaultRigDef();
	for ( int32_t i = 0; i < SPIDER_JOINTS; ++i )
	{
		spider->parents[i] = i < 2 ? i - 1 : ( ( i - 2 ) % 3 == 0 ? SPIDER_BODY : i - 1 );
		spider->bindPose[i] = soleTransform_Identity();
	}
	spider->bindPose[SPIDER_BODY].translation.y = SPIDER_HEIGHT;
	for ( int32_t leg = 0; leg < SPIDER_LEGS; ++leg )
	{
		soleVec3 hip = testSpiderHipPlace( leg );
		soleVec3 knee = testSpiderKnee( hip, testSpiderFoot( leg ) );
		soleTransform* joints = spider->bindPose + testSpiderHip( leg );
		joints[0].translation = soleScale( SPIDER_HIP, testSpiderOut( leg ) );
		joints[1].translation = soleSub( knee, hip );
		joints[2].translation = soleSub( testSpiderFoot( leg ), knee );
		def.legs[leg] = testSpiderLeg( leg );
	}
	def.jointCount = SPIDER_JOINTS;
	def.parents = spider->parents;
	def.bindPose = spider->bindPose;
	def.pelvis = SPIDER_BODY;
	def.legCount = SPIDER_LEGS;
	soleMessage message;
	soleResult result = soleCreateRig( &def, NULL, &spider->rig, &message );
	if ( result != sole_success )
	{
		print_error( "%s\n", message.text );
	}
	assert_int_equal( result, sole_success );
}

/// Neighbours step in turn, and so do legs across.
static inline float testSpiderPhase( float time, float period, int32_t leg )
{
	float phase = time / period + ( ( leg % 4 + leg / 4 ) % 2 == 0 ? 0.0f : 0.5f );
	return phase - floorf( phase );
}

/// The pose at a time of a walk at a speed, and what a host tells of it whose root goes straight on.
static inline void testPoseSpider( const testSpider* spider, float speed, float period, float time, soleTransform* pose,
    soleContactInput* contacts, soleStepInput* inputs )
{
	memcpy( pose, spider->bindPose, sizeof spider->bindPose );
	float reach = 0.5f * speed * SPIDER_STANCE * period;
	for ( int32_t leg = 0; leg < SPIDER_LEGS; ++leg )
	{
		float phase = testSpiderPhase( time, period, leg );
		bool down = phase < SPIDER_STANCE;
		float s = down ? 0.0f : ( phase - SPIDER_STANCE ) / ( 1.0f - SPIDER_STANCE );
		soleVec3 foot = testSpiderFoot( leg );
		soleVec3 place = soleAdd( foot, soleVec( 0.0f, -SPIDER_SOLE, 0.01f + reach ) );
		foot.z += reach - speed * period * phase;
		foot.z += speed * period * s * s * s * ( 10.0f - s * ( 15.0f - 6.0f * s ) );
		foot.y += SPIDER_LIFT * 16.0f * s * s * ( 1.0f - s ) * ( 1.0f - s );
		testPutSpiderFoot( spider, leg, foot, pose );
		float until = ( ( down ? SPIDER_STANCE : 1.0f ) - phase ) * period;
		soleVec3 travel = soleVec( 0.0f, 0.0f, speed * until );
		contacts[leg] = ( soleContactInput ){ down ? 1.0f : 0.0f, down ? 1.0f : 0.0f };
		inputs[leg] = ( soleStepInput ){ ( down ? phase : phase - SPIDER_STANCE ) * period, until,
			soleAdd( place, travel ), { 0.0f, 0.0f, 1.0f }, travel };
	}
}

#endif
