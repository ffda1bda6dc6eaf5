// SPDX-License-Identifier: MIT
// The ground under feet that are not on their way, from outside: those that have come down stay down.
#include "test.h"

#include "scene_actor.h"
#include "scene_meter.h"

#include <math.h>

#define RISE 0.17f // of T02

static void play( const char* scene, const char* act, testWorld* world, testRun* run )
{
	testOpenWorld( scene, world );
	testPlay( &s_actor, world, soleFindAct( scene, act ), 0, 60.0, run );
}

/// Ground that a foot's toes would be over soon raises a foot that passes over it. This one comes down before the first
/// riser, which raised it by 38 mm for four frames, and the pelvis by 16.
static void aFootThatComesDownBeforeARiserDoesNotHop( void** state )
{
	(void)state;
	testWorld world;
	static testRun run;
	play( "T02", "1.40 stepped", &world, &run );
	float highest = 0.0f, pelvis = 0.0f;
	int32_t down = 0;
	for ( int32_t i = 0; i < run.frameCount && run.times[i] < 0.6; ++i )
	{
		static testBodyPose in;
		static testBodyPose out;
		testFindBody( &run, i, run.input, &in );
		testFindBody( &run, i, run.output, &out );
		bool strike = run.times[i] > 0.45;
		highest = strike ? fmaxf( highest, out.legs[1].sole[0].y ) : highest;
		pelvis = strike ? fmaxf( pelvis, out.pelvis.translation.y - in.pelvis.translation.y ) : pelvis;
		down += ( run.flags[2 * i + 1] & (uint32_t)sole_legPlanted ) != 0 ? 1 : 0;
	}
	assert_true( down > 3 );
	assert_true( highest < 0.012f );
	assert_true( pelvis < 0.012f );
	testFreeRun( &run );
	testCloseWorld( &world );
}

/// The ball of a foot whose heel strikes goes on a little: by as much of the way its heel was still over the tread
/// below.
static void heelsThatStrikeOnTheWayDownStandOnTheirTreads( void** state )
{
	(void)state;
	testWorld world;
	static testRun run;
	play( "T02", "0.52 stepped", &world, &run );
	float worst = 0.0f;
	int32_t planted = 0;
	for ( int32_t i = 0; i < run.frameCount; ++i )
	{
		static testBodyPose out;
		testFindBody( &run, i, run.output, &out );
		for ( int32_t leg = 0; leg < 2 && run.roots[i].translation.z > 6.3f; ++leg )
		{
			const soleVec3* sole = out.legs[leg].sole;
			float lowest = fminf( fminf( sole[0].y, sole[1].y ), sole[2].y );
			bool down = ( run.flags[2 * i + leg] & (uint32_t)sole_legPlanted ) != 0;
			planted += down ? 1 : 0;
			worst = down ? fmaxf( worst, fabsf( lowest - RISE * roundf( lowest / RISE ) ) ) : worst;
		}
	}
	assert_true( planted > 500 );
	assert_true( worst < 2e-3f );
	testFreeRun( &run );
	testCloseWorld( &world );
}

/// A root that steps up has the probes of a foot that stands reach the step over its own, which its toes just touch: it
/// stood there for a frame, 80 mm up, until its ground was read closely.
static void aFootThatStandsStaysWhenTheNextStepComesIntoReach( void** state )
{
	(void)state;
	testWorld world;
	static testRun run;
	play( "T03", "0.45 stepped", &world, &run );
	float most = 0.0f;
	int32_t held = 0;
	for ( int32_t i = 1; i < run.frameCount; ++i )
	{
		static testBodyPose poses[2];
		testFindBody( &run, i - 1, run.output, poses );
		testFindBody( &run, i, run.output, poses + 1 );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			bool stands = ( run.flags[2 * i + leg] & run.flags[2 * i - 2 + leg] & (uint32_t)sole_legPlanted ) != 0;
			float up = poses[1].legs[leg].sole[test_ball].y - poses[0].legs[leg].sole[test_ball].y;
			most = stands ? fmaxf( most, up ) : most;
			held += stands ? 1 : 0;
		}
	}
	assert_true( held > 500 );
	assert_true( most < 6e-3f );
	testFreeRun( &run );
	testCloseWorld( &world );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aFootThatComesDownBeforeARiserDoesNotHop ),
		cmocka_unit_test( heelsThatStrikeOnTheWayDownStandOnTheirTreads ),
		cmocka_unit_test( aFootThatStandsStaysWhenTheNextStepComesIntoReach ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
