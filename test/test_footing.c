// SPDX-License-Identifier: MIT
// The ground under feet that are not on their way, from outside: those that have come down stay down.
#include "test.h"

#include "scene_actor.h"
#include "scene_meter.h"

#include <math.h>

/// Ground that a foot's toes would be over soon raises a foot that passes over it. This one comes down before the first
/// riser, which raised it by 38 mm for four frames, and the pelvis by 16.
static void aFootThatComesDownBeforeARiserDoesNotHop( void** state )
{
	(void)state;
	testWorld world;
	static testRun run;
	testOpenWorld( "T02", &world );
	testPlay( &s_actor, &world, soleFindAct( "T02", "1.40 stepped" ), 0, 60.0, &run );
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

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aFootThatComesDownBeforeARiserDoesNotHop ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
