// SPDX-License-Identifier: MIT
// What a host tells Sole of its clips' steps: foreseen from the past alone, the same at every frame rate, and true.
#include "test.h"

#include "scene_actor.h"
#include "scene_steps.h"

#include <math.h>

static soleTransform place( double x, double z, double heading )
{
	soleTransform t = soleTransform_Identity();
	t.translation = soleVec( (float)x, 0.3f, (float)z );
	t.rotation = ( soleQuat ){ 0.0f, (float)sin( 0.5 * heading ), 0.0f, (float)cos( 0.5 * heading ) };
	return t;
}

static void aRootOnAnArcGoesOnAlongIt( void** state )
{
	(void)state;
	// 2 m/s on a circle of 1.6 m, to the left.
	const double radius = 1.6;
	const double turn = 2.0 / radius;
	soleTransform roots[3];
	const double times[3] = { 0.0, 0.1, 0.7 };
	for ( int i = 0; i < 3; ++i )
	{
		double heading = turn * times[i];
		roots[i] = place( radius * ( 1.0 - cos( heading ) ), radius * sin( heading ), heading );
	}
	toolPace pace = toolFindPace( &s_actor.character, roots[0], roots[1], 0.1 );
	assert_float_equal( pace.turnRate, turn, 2e-3 );
	testNear3( pace.velocity, soleVec( 0.0f, 0.0f, 2.0f ), 5e-3f );
	soleTransform travel = soleExtrapolate( pace.velocity, pace.turnRate, soleVec( 0.0f, 1.0f, 0.0f ), 0.6f );
	testNear3( soleTransformPoint( roots[1], travel.translation ), roots[2].translation, 5e-3f );
	// Nothing is known of a root that was never anywhere else.
	pace = toolFindPace( &s_actor.character, roots[0], roots[0], 0.0 );
	assert_true( soleLength( pace.velocity ) == 0.0f && pace.turnRate == 0.0f );
}

static bool read( soleGait gait, double time, double rate, int32_t leg, soleContactInput* contact, soleStepInput* step )
{
	return toolReadStep(
	    s_actor.clips + gait, s_actor.travels + gait, s_actor.steps + gait, time, rate, leg, contact, step );
}

static void stepsAreReadInTheTimeOfTheWorld( void** state )
{
	(void)state;
	double round = (double)s_actor.clips[sole_gaitWalk].duration;
	soleContactInput contact;
	soleStepInput once;
	soleStepInput twice;
	// The left foot is in flight in the last third of the walk, in any round.
	assert_true( read( sole_gaitWalk, 0.8 * round, 1.0, 0, &contact, &once ) );
	assert_true( contact.heel == 0.0f && contact.toe == 0.0f );
	assert_true( once.until > 0.1f && once.since > 0.1f && once.since + once.until < 0.6f );
	assert_true( read( sole_gaitWalk, 5.8 * round, 2.0, 0, &contact, &twice ) );
	assert_float_equal( twice.until, 0.5f * once.until, 1e-4f );
	assert_float_equal( twice.since, 0.5f * once.since, 1e-4f );
	// A clip that stands still foretells nothing; neither does one that stands for ever.
	assert_false( read( sole_gaitWalk, 0.8 * round, 0.0, 0, &contact, &once ) );
	assert_true( once.until < 0.0f );
	assert_false( read( sole_gaitIdle, 1.0, 1.0, 1, &contact, &once ) );
	assert_true( contact.heel == 1.0f && contact.toe == 1.0f );
}

static const struct
{
	const char* scene;
	const char* act;
} s_acts[] = { { "T01", "walk" }, { "T01", "run" }, { "T02", "0.52 stepped" }, { "T02", "1.40 stepped" },
	{ "T01", "T40 strafe 0.30" }, { "T01", "T39 round in 2.0" } };

#define ACT_COUNT ( sizeof s_acts / sizeof s_acts[0] )

/// Longest way from where it is foretold to where the clip has the ball of its flat foot, m.
static double testFindMistake( const testRun* run, int32_t leg )
{
	soleLegDef def = soleRig_GetLeg( run->rigs[0], leg );
	int32_t toes = soleRig_GetFootJoint( run->rigs[0], leg, true );
	soleVec3 local = soleRig_ToFootSpace( run->rigs[0], leg, def.sole.ball, true );
	soleVec3 foretold = { 0.0f, 0.0f, 0.0f };
	bool flies = false;
	double worst = 0.0;
	for ( int32_t i = 12; i < run->frameCount; ++i )
	{
		soleContactInput contacts[2];
		soleStepInput steps[2];
		soleTransform joints[128];
		assert_true( testReadSteps( run, i, contacts, steps ) );
		bool down = contacts[leg].heel > 0.0f || contacts[leg].toe > 0.0f;
		foretold = down == false ? soleTransformPoint( run->roots[i], steps[leg].place ) : foretold;
		if ( flies && contacts[leg].heel > 0.0f && contacts[leg].toe > 0.0f )
		{
			testFindJoints( run, i, run->input + (size_t)i * (size_t)run->jointCount, joints );
			soleVec3 ball = soleTransformPoint( joints[toes], local );
			worst = fmax( worst, hypot( (double)( ball.x - foretold.x ), (double)( ball.z - foretold.z ) ) );
			flies = false;
		}
		flies = flies || down == false;
	}
	return worst;
}

static void feetComeDownWhereItIsForetold( void** state )
{
	(void)state;
	for ( size_t i = 0; i < ACT_COUNT; ++i )
	{
		testWorld world;
		testRun run;
		testOpenWorld( s_acts[i].scene, &world );
		testPlay( &s_actor, &world, soleFindAct( s_acts[i].scene, s_acts[i].act ), 0, 0.0, &run );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			double mistake = testFindMistake( &run, leg );
			if ( mistake > 8e-3 )
			{
				fail_msg( "%s %s: %.1f mm off", s_acts[i].scene, s_acts[i].act, 1e3 * mistake );
			}
		}
		testFreeRun( &run );
		testCloseWorld( &world );
	}
}

/// Both say the same at the same times, but for the first tenth of a second.
static void testSame( const testRun* a, const testRun* b )
{
	int32_t common = 0;
	int32_t k = 0;
	for ( int32_t i = 0; i < a->frameCount; ++i )
	{
		while ( k + 1 < b->frameCount && b->times[k] < a->times[i] - 1e-6 )
		{
			++k;
		}
		if ( a->times[i] < 0.11 || fabs( a->times[i] - b->times[k] ) > 1e-6 )
		{
			continue;
		}
		soleContactInput contactsA[2];
		soleContactInput contactsB[2];
		soleStepInput stepsA[2];
		soleStepInput stepsB[2];
		assert_true( testReadSteps( a, i, contactsA, stepsA ) && testReadSteps( b, k, contactsB, stepsB ) );
		assert_memory_equal( contactsA, contactsB, sizeof contactsA );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			assert_float_equal( stepsA[leg].since, stepsB[leg].since, 1e-4f );
			assert_float_equal( stepsA[leg].until, stepsB[leg].until, 1e-4f );
			testNear3( stepsA[leg].place, stepsB[leg].place, 1e-4f );
			testNear3( stepsA[leg].travel, stepsB[leg].travel, 1e-4f );
		}
		++common;
	}
	assert_true( common > 20 );
}

static void everyFrameRateForetellsTheSame( void** state )
{
	(void)state;
	const double rates[] = { 30.0, 144.0, 165.0, 240.0 };
	for ( size_t i = 0; i < ACT_COUNT; ++i )
	{
		testWorld world;
		testRun a;
		testRun b;
		testOpenWorld( s_acts[i].scene, &world );
		const soleAct* act = soleFindAct( s_acts[i].scene, s_acts[i].act );
		testPlay( &s_actor, &world, act, 0, 60.0, &a );
		for ( int k = 0; k < 4; ++k )
		{
			testPlay( &s_actor, &world, act, 0, rates[k], &b );
			testSame( &a, &b );
			testFreeRun( &b );
		}
		testFreeRun( &a );
		testCloseWorld( &world );
	}
}

static void whoBlendsClipsTellsNothing( void** state )
{
	(void)state;
	testWorld world;
	testRun run;
	testOpenWorld( "T01", &world );
	testPlay( &s_actor, &world, soleFindAct( "T01", "T41 walk, idle" ), 0, 0.0, &run );
	soleContactInput contacts[2];
	soleStepInput steps[2];
	assert_false( testReadSteps( &run, 60, contacts, steps ) );
	testFreeRun( &run );
	testCloseWorld( &world );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aRootOnAnArcGoesOnAlongIt ),
		cmocka_unit_test( stepsAreReadInTheTimeOfTheWorld ),
		cmocka_unit_test( feetComeDownWhereItIsForetold ),
		cmocka_unit_test( everyFrameRateForetellsTheSame ),
		cmocka_unit_test( whoBlendsClipsTellsNothing ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
