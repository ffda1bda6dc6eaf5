// SPDX-License-Identifier: MIT
// What the gates ask of walks on level worlds, asked of one round a planet: there up is away from the middle, and the
// ground as far from it as the radius. World space, metres; figures in mm.
#include "test.h"

#include "scene_checks.h"
#include "scene_meter.h"
#include "scene_pose.h"

#define SETTLED 60 // frames
#define TURNS 7
#define TURNED_TIME 6.0 // s

/// Plays the check's act. @param duration 0: all of it. @param turn of the world
static void testPlayRound( const testActor* actor, const testCheck* check, double duration, soleQuat turn,
    testWorld* world, soleAct* act, testRun* run )
{
	*act = *soleFindAct( check->scene, check->act );
	act->duration = duration > 0.0 ? duration : act->duration;
	testOpenWorld( check->scene, world );
	world->turn = turn;
	testPlay( actor, world, act, 0, 0.0, run );
}

/// Adds a frame to a figure.
typedef double testRoundMeasure( const testRun* run, int32_t frame, const testBodyPose out[2], double worst );

static double testMeasureRound( const testActor* actor, const testCheck* check, testRoundMeasure* measure )
{
	static testBodyPose out[2];
	testWorld world;
	soleAct act;
	testRun run;
	testPlayRound( actor, check, 0.0, soleQuat_Identity(), &world, &act, &run );
	double worst = 0.0;
	for ( int32_t i = SETTLED - 1; i < run.frameCount; ++i )
	{
		out[0] = out[1];
		testFindBody( &run, i, run.output, out + 1 );
		worst = i >= SETTLED ? measure( &run, i, out, worst ) : worst;
	}
	testFreeRun( &run );
	testCloseWorld( &world );
	return worst;
}

static bool testIsPlanted( const testRun* run, int32_t frame, int32_t leg )
{
	return ( run->flags[frame * run->legCount + leg] & (uint32_t)sole_legPlanted ) != 0;
}

static double testLiesOff( const testRun* run, int32_t frame, const testBodyPose out[2], double worst )
{
	double radius = run->world->scene.way.y;
	for ( int32_t leg = 0; leg < run->legCount; ++leg )
	{
		const soleVec3* sole = out[1].legs[leg].sole;
		double lowest = HUGE_VAL;
		for ( int32_t k = 0; k < test_solePoints; ++k )
		{
			lowest = fmin( lowest, (double)soleLength( sole[k] ) - radius );
		}
		worst = testIsPlanted( run, frame, leg ) ? fmax( worst, 1e3 * fabs( lowest ) ) : worst;
	}
	return worst;
}

double testLieOnPlanet( const testActor* actor, const testCheck* check )
{
	return testMeasureRound( actor, check, testLiesOff );
}

/// A foot turns about the point that is held: the one that moves least.
static double testSlides( const testRun* run, int32_t frame, const testBodyPose out[2], double worst )
{
	for ( int32_t leg = 0; leg < run->legCount; ++leg )
	{
		bool held = testIsPlanted( run, frame, leg ) && testIsPlanted( run, frame - 1, leg );
		double least = HUGE_VAL;
		for ( int32_t k = 0; k < test_solePoints; ++k )
		{
			least = fmin( least, (double)soleDistance( out[0].legs[leg].sole[k], out[1].legs[leg].sole[k] ) );
		}
		worst = held ? fmax( worst, 1e3 * least ) : worst;
	}
	return worst;
}

double testStayOnPlanet( const testActor* actor, const testCheck* check )
{
	return testMeasureRound( actor, check, testSlides );
}

/// How far the pelvis jumps away from its animation, and back.
static double testJumps( const testRun* run, int32_t frame, const testBodyPose out[2], double worst )
{
	static testBodyPose in[2];
	testFindBody( run, frame - 1, run->input, in + 0 );
	testFindBody( run, frame, run->input, in + 1 );
	soleVec3 before = soleSub( out[0].pelvis.translation, in[0].pelvis.translation );
	soleVec3 now = soleSub( out[1].pelvis.translation, in[1].pelvis.translation );
	double jump = (double)( soleDot( now, run->moments[frame].up ) - soleDot( before, run->moments[frame - 1].up ) );
	return fmax( worst, 1e3 * fabs( jump ) );
}

double testGoEvenly( const testActor* actor, const testCheck* check )
{
	return testMeasureRound( actor, check, testJumps );
}

/// How many of the clip's stances are missing to nine of ten.
double testHoldOnPlanet( const testActor* actor, const testCheck* check )
{
	testWorld world;
	soleAct act;
	testRun run;
	testPlayRound( actor, check, 0.0, soleQuat_Identity(), &world, &act, &run );
	double stances = 2.0 * run.moments[run.frameCount - 1].way / testGetStride( actor, run.moments );
	double held = testCountFlags( &run, (uint32_t)sole_legCaptured );
	testFreeRun( &run );
	testCloseWorld( &world );
	return fmax( 0.0, 0.9 * stances - held );
}

/// Furthest apart of pelvis and feet that stand in both. How far a foot in flight is lifted hangs on which places were
/// asked on its way, and where one of them lies on the limit, rounding decides.
static double testFindApart( const testRun runs[2], int32_t frame )
{
	static testBodyPose bodies[2];
	for ( int32_t k = 0; k < 2; ++k )
	{
		testFindBody( runs + k, frame, runs[k].output, bodies + k );
	}
	double apart = (double)soleDistance( bodies[0].pelvis.translation, bodies[1].pelvis.translation );
	for ( int32_t leg = 0; leg < runs[0].legCount; ++leg )
	{
		soleVec3 a = bodies[0].legs[leg].foot.translation;
		soleVec3 b = bodies[1].legs[leg].foot.translation;
		bool stands = testIsPlanted( runs + 0, frame, leg ) && testIsPlanted( runs + 1, frame, leg );
		apart = stands ? fmax( apart, (double)soleDistance( a, b ) ) : apart;
	}
	return 1e3 * apart;
}

double testInTurnedWorlds( const testActor* actor, const testCheck* check )
{
	testWorld worlds[2];
	soleAct acts[2];
	testRun runs[2];
	double worst = 0.0;
	uint32_t seed = 48;
	testPlayRound( actor, check, TURNED_TIME, soleQuat_Identity(), worlds + 0, acts + 0, runs + 0 );
	for ( int32_t k = 0; k < TURNS; ++k )
	{
		soleQuat turn = { testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ),
			testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ) };
		testPlayRound( actor, check, TURNED_TIME, soleNormalizeQuat( turn ), worlds + 1, acts + 1, runs + 1 );
		for ( int32_t i = 0; i < runs[0].frameCount; ++i )
		{
			worst = fmax( worst, testFindApart( runs, i ) );
		}
		testFreeRun( runs + 1 );
		testCloseWorld( worlds + 1 );
	}
	testFreeRun( runs + 0 );
	testCloseWorld( worlds + 0 );
	return worst;
}
