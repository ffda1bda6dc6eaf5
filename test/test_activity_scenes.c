// SPDX-License-Identifier: MIT
// T33 and T42 with strength by activity: a host that never takes Sole out lets it do so by itself in a jump and in a
// sprint. World space, metres.
#include "test.h"

#include "act_play.h"
#include "scene_actor.h"
#include "scene_meter.h"

/// The jump of T33, and a host that leaves all to Sole.
static void jumpUnattended( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* m )
{
	solePlayJump( act, stage, take, time, m );
	m->weight = 1.0;
}

/// How far a run's feet are from their animation, by what is said of its frames.
typedef struct Away
{
	double air;    // furthest while the root comes down from the height of its jump
	double all;    // mean
	double change; // furthest of a foot or the pelvis in a frame, beyond the input's
	double sunk;   // of soles that are not planted
	uint32_t failed;
} Away;

static Away measure( const soleAct* act, const soleSettings* settings )
{
	static testBodyPose in, out;
	testWorld world;
	testRun run;
	Away away = { 0 };
	testOpenWorld( act->scene, &world );
	s_actor.settings = *settings;
	testPlay( &s_actor, &world, act, 0, 0.0, &run );
	testGates gates = testStartGates();
	testMeasureRun( &run, &gates );
	away.failed = testFindFailed( &gates );
	away.change = gates.move.value;
	away.sunk = gates.swingDepth.value;
	for ( int32_t i = 0; i < run.frameCount; ++i )
	{
		testFindBody( &run, i, run.input, &in );
		testFindBody( &run, i, run.output, &out );
		double moved = (double)soleDistance( in.pelvis.translation, out.pelvis.translation );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			double foot = (double)soleDistance( in.legs[leg].foot.translation, out.legs[leg].foot.translation );
			away.all += foot / ( 2.0 * run.frameCount );
			moved = fmax( moved, foot );
		}
		bool high = i > 0 && run.moments[i].lift > 0.2 && run.moments[i].lift < run.moments[i - 1].lift;
		away.air = high ? fmax( away.air, moved ) : away.air;
	}
	testFreeRun( &run );
	testCloseWorld( &world );
	return away;
}

static void aJumpIsAnimatedAndLandsAsIfTheHostHadTakenCare( void** state )
{
	(void)state;
	// On stairs the next step is near before the root is down again: feet are made ready for it.
	static const char* const scenes[] = { "T11-20", "T02" };
	const double shares[] = { 0.25, 0.55 };
	const double depths[] = { 0.03, 0.06 };
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleAct act = *soleFindAct( scenes[i], "T33 jump" );
		act.special.play = jumpUnattended;
		soleSettings settings = soleDefaultSettings();
		Away without = measure( &act, &settings );
		settings.activity.airborne = 0.0f;
		settings.activity.low = 0.1f;
		settings.activity.high = 0.25f;
		settings.target.blendOut = 0.08f;
		Away with = measure( &act, &settings );
		printf( "T33 on %s: in the air at most %.0f mm from the animation, else %.0f\n", scenes[i], 1e3 * with.air,
		    1e3 * without.air );
		assert_true( with.air < shares[i] * without.air );
		assert_int_equal( with.failed & ~without.failed & ( test_g4 | test_g6 | test_g7 | test_g8 ), 0 );
		// Feet that are in the air as they are animated come down on a ground that the animation does not know.
		assert_true( with.sunk < depths[i] );
	}
}

static void aSprintKeepsMoreOfItsAnimation( void** state )
{
	(void)state;
	const soleAct* act = soleFindAct( "T11-20", "T42 sprint" );
	soleSettings settings = soleDefaultSettings();
	Away whole = measure( act, &settings );
	settings.activity.running = 0.4f;
	Away half = measure( act, &settings );
	printf( "T42: feet %.0f mm from the animation on the mean, else %.0f\n", 1e3 * half.all, 1e3 * whole.all );
	assert_true( half.all < 0.6 * whole.all && half.all > 0.2 * whole.all );
	// What is fought at full strength is not at less.
	assert_true( half.change < 0.015 && half.change < 0.5 * whole.change );
	assert_int_equal( half.failed & ( test_g6 | test_g7 | test_g8 | test_gKnee ), 0 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aJumpIsAnimatedAndLandsAsIfTheHostHadTakenCare ),
		cmocka_unit_test( aSprintKeepsMoreOfItsAnimation ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
