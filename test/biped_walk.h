// SPDX-License-Identifier: MIT
// A walk of the plain biped whose steps are known exactly: feet stay level, stand still in the world while they are
// down and set out and arrive at rest in between. Character space, in place: the root is to go on at the walk's speed.
#ifndef TEST_BIPED_WALK_H
#define TEST_BIPED_WALK_H

#include "placing.h"

#define WALK_STANCE 0.6f // of the period
#define WALK_HIP 0.8f    // of the hips over the ankles
#define WALK_ANKLE 0.08f // over the sole
#define WALK_BALL 0.12f  // ahead of the ankle

typedef struct testWalk
{
	float speed;  // m/s along z
	float period; // s from strike to strike of a foot
	float lift;   // m of the feet in mid flight
} testWalk;

/// Time since the leg's foot came down, s.
static inline float testWalkPhase( const testWalk* walk, float time, int32_t leg )
{
	float phase = time / walk->period + ( leg == 0 ? 0.0f : 0.5f );
	return ( phase - floorf( phase ) ) * walk->period;
}

/// Bends a leg about its hinge so that the ankle of its level foot is there, as seen from the hip.
static inline void testPutAnkle( soleTransform* pose, int32_t hip, float down, float ahead )
{
	soleVec3 x = soleVec( 1.0f, 0.0f, 0.0f );
	float flexion = 2.0f * acosf( fminf( sqrtf( down * down + ahead * ahead ) / 0.9f, 1.0f ) );
	float thigh = -atan2f( ahead, down ) - 0.5f * flexion;
	pose[hip].rotation = testTurn( x, thigh );
	pose[hip + 1].rotation = testTurn( x, flexion );
	pose[hip + 2].rotation = testTurn( x, -thigh - flexion );
}

static inline void testPoseWalk( soleTransform* pose, const testWalk* walk, float time )
{
	float stance = WALK_STANCE * walk->period;
	pose[biped_pelvis].translation.y = WALK_HIP + WALK_ANKLE;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		float phase = testWalkPhase( walk, time, leg );
		float z = walk->speed * ( 0.5f * stance - phase );
		float y = 0.0f;
		if ( phase > stance )
		{
			float s = ( phase - stance ) / ( walk->period - stance );
			z += walk->speed * walk->period * s * s * s * ( 10.0f - s * ( 15.0f - 6.0f * s ) );
			y = walk->lift * 16.0f * s * s * ( 1.0f - s ) * ( 1.0f - s );
		}
		testPutAnkle( pose, leg == 0 ? biped_hipL : biped_hipR, WALK_HIP - y, z );
	}
}

/// What a host that knows the clip tells, from a root that goes on as the walk does.
static inline void testTellWalk( const testWalk* walk, float time, soleContactInput* contacts, soleStepInput* inputs )
{
	soleStep steps[2];
	float stance = WALK_STANCE * walk->period;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		float strike = leg == 0 ? 0.0f : 0.5f * walk->period;
		soleVec3 place = soleVec( leg == 0 ? 0.09f : -0.09f, 0.0f, 0.5f * walk->speed * stance + WALK_BALL );
		steps[leg] = ( soleStep ){ leg, strike, strike + stance, strike, strike + stance, strike, strike + stance,
			place, { 0.0f, 0.0f, 1.0f } };
	}
	float round = fmodf( time, walk->period );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleGetStepInput( steps, 2, walk->period, true, round, leg, contacts + leg, inputs + leg );
		soleTransform travel =
		    soleExtrapolate( soleVec( 0.0f, 0.0f, walk->speed ), 0.0f, soleVec( 0.0f, 1.0f, 0.0f ), inputs[leg].until );
		soleStepInput_Travel( inputs + leg, travel );
	}
}

/// One frame of the walk. The root's place along z and its height are the caller's.
static inline void testWalkOn(
    testRun* run, const testWalk* walk, float time, soleContactInput* contacts, soleStepInput* inputs )
{
	testPoseWalk( run->pose, walk, time );
	testTellWalk( walk, time, contacts, inputs );
	run->frame.contact = contacts;
	run->frame.steps = inputs;
	testStepRun( run );
}

#endif
