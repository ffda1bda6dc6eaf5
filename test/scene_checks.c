// SPDX-License-Identifier: MIT
// Runs against other runs of the same act: at other rates, elsewhere in the world, along another way; and what happens
// how often in a run. Places in world space, metres; figures as the checks' units say.
#include "test.h"

#include "scene_checks.h"

/// A run with the world that it is on.
typedef struct testPlayed
{
	testWorld world;
	soleAct act;
	testRun run;
} testPlayed;

/// @param change what is different from the act. May be NULL
static void testPlayOne( const testActor* actor, const char* scene, const char* name, int32_t take, double rate,
    void ( *change )( soleAct* act ), testPlayed* played )
{
	const soleAct* act = soleFindAct( scene, name );
	if ( act == NULL )
	{
		fail_msg( "there is no act %s of %s", name, scene );
		return;
	}
	played->act = *act;
	if ( change != NULL )
	{
		change( &played->act );
	}
	testOpenWorld( scene, &played->world );
	testPlay( actor, &played->world, &played->act, take, rate, &played->run );
}

static void testFreePlayed( testPlayed* played )
{
	testFreeRun( &played->run );
	testCloseWorld( &played->world );
}

/// Where feet and pelvis are that came out, world.
static void testFindParts( const testRun* run, int32_t frame, soleVec3 parts[3] )
{
	soleTransform joints[128];
	assert_true( run->jointCount <= 128 );
	testFindJoints( run, frame, run->output + (size_t)frame * (size_t)run->jointCount, joints );
	const soleRigDef* def = &run->actor->character.rigDef;
	parts[0] = joints[def->pelvis].translation;
	parts[1] = joints[def->legs[0].joints[2]].translation;
	parts[2] = joints[def->legs[1].joints[2]].translation;
}

double testCompareFrames( const testRun* a, int32_t frameA, const testRun* b, int32_t frameB )
{
	soleVec3 partsA[3];
	soleVec3 partsB[3];
	testFindParts( a, frameA, partsA );
	testFindParts( b, frameB, partsB );
	double worst = 0.0;
	for ( int i = 0; i < 3; ++i )
	{
		worst = fmax( worst, 1e3 * (double)soleDistance( partsA[i], partsB[i] ) );
	}
	return worst;
}

/// Over all frames with the same time stamp.
static double testCompareRuns( const testRun* a, const testRun* b )
{
	double worst = 0.0;
	int32_t k = 0;
	for ( int32_t i = 0; i < a->frameCount; ++i )
	{
		while ( k + 1 < b->frameCount && b->times[k] < a->times[i] - 1e-6 )
		{
			++k;
		}
		if ( fabs( a->times[i] - b->times[k] ) < 1e-6 )
		{
			worst = fmax( worst, testCompareFrames( a, i, b, k ) );
		}
	}
	return worst;
}

// ------------------------------------------------------------------------------------------------------------- checks

/// T13: both ways end in the same pose.
static double testBothWays( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayed b;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	testPlayOne( actor, check->scene, "step out", 0, 0.0, NULL, &b );
	double apart = testCompareFrames( &a.run, a.run.frameCount - 1, &b.run, b.run.frameCount - 1 );
	testFreePlayed( &a );
	testFreePlayed( &b );
	return apart;
}

/// T31: the first frame is as the one after a round of the idle clip, 4 s.
static double testFirstIsFinal( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	double apart = testCompareFrames( &a.run, 0, &a.run, 240 );
	testFreePlayed( &a );
	return apart;
}

static void testMakePlain( soleAct* act )
{
	act->special.play = NULL;
	act->host.step = NULL;
}

/// T32: the same as without what is special.
static double testAsPlain( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayed b;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	testPlayOne( actor, check->scene, check->act, 0, 0.0, testMakePlain, &b );
	double apart = testCompareRuns( &a.run, &b.run );
	testFreePlayed( &a );
	testFreePlayed( &b );
	return apart;
}

/// T44: the same at another rate. mm
static double testAtRate( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayed b;
	testPlayOne( actor, check->scene, check->act, 0, 60.0, NULL, &a );
	testPlayOne( actor, check->scene, check->act, 0, check->value, NULL, &b );
	double apart = testCompareRuns( &a.run, &b.run );
	testFreePlayed( &a );
	testFreePlayed( &b );
	return apart;
}

/// T45: frames without length change nothing, then or later. mm
static double testAcrossPause( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayed b;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	testPlayOne( actor, check->scene, check->act, 0, 0.0, testMakePlain, &b );
	double apart = 0.0;
	for ( int32_t i = 0; i < b.run.frameCount; ++i )
	{
		// 120 frames are as the one before them.
		apart = fmax( apart, testCompareFrames( &a.run, i < 120 ? i : i + 120, &b.run, i ) );
		apart = i < 120 ? fmax( apart, testCompareFrames( &a.run, 120 + i, &b.run, 119 ) ) : apart;
	}
	testFreePlayed( &a );
	testFreePlayed( &b );
	return apart;
}

double testCountFlags( const testRun* run, uint32_t flag )
{
	double count = 0.0;
	for ( int32_t i = 0; i < run->frameCount * run->legCount; ++i )
	{
		count += ( run->flags[i] & flag ) != 0 ? 1.0 : 0.0;
	}
	return count;
}

/// How often a foot is let go.
static double testCountReleases( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	double count = testCountFlags( &a.run, (uint32_t)sole_legReleased );
	testFreePlayed( &a );
	return count;
}

/// T28: how much less or more often a foot is let go, and held again, than a lock of 45 degrees asks for in 6 s at 45
/// degrees a second: with what holding takes, 2 to 6 times.
static double testCountTurns( const testActor* actor, const testCheck* check )
{
	testPlayed a;
	testPlayOne( actor, check->scene, check->act, 0, 0.0, NULL, &a );
	double released = testCountFlags( &a.run, (uint32_t)sole_legReleased );
	double captured = testCountFlags( &a.run, (uint32_t)sole_legCaptured ) - 2.0;
	testFreePlayed( &a );
	double least = fmin( released, captured );
	return fmax( 2.0 - least, fmax( released, captured ) - 6.0 );
}

/// How long a foot is not planted after the first 0.2 s, of all takes. s
static double testCountLoose( const testActor* actor, const testCheck* check )
{
	double loose = 0.0;
	for ( int32_t take = 0; take < (int32_t)check->value; ++take )
	{
		testPlayed a;
		testPlayOne( actor, check->scene, check->act, take, 0.0, NULL, &a );
		for ( int32_t i = 12; i < a.run.frameCount; ++i )
		{
			for ( int32_t leg = 0; leg < a.run.legCount; ++leg )
			{
				bool planted = ( a.run.flags[i * a.run.legCount + leg] & (uint32_t)sole_legPlanted ) != 0;
				loose += planted ? 0.0 : a.run.steps[i];
			}
		}
		testFreePlayed( &a );
	}
	return loose;
}

static const testCheck s_checks[] = {
	{ "T13 both ways end in one pose", 5.0, "mm", testBothWays, "T13", "climb beside", 0.0 },
	{ "T28 a turning plate lets go now and then", 0.0, "times off", testCountTurns, "T28", "stand", 0.0 },
	{ "T31 the first frame is final on a ramp", 1.0, "mm", testFirstIsFinal, "T11-30", "T31 spawn", 0.0 },
	{ "T31 the first frame is final on stairs", 1.0, "mm", testFirstIsFinal, "T02", "T31 spawn", 0.0 },
	{ "T32 a shift of the origin changes nothing", 2.0, "mm", testAsPlain, "T16", "T32 origin", 0.0 },
	{ "T32 a new base changes nothing", 1.0, "mm", testAsPlain, "T16", "T32 rebase", 0.0 },
	{ "T34 0.20 deep feet stay planted", 0.0, "s", testCountLoose, "T01", "T34 crouch 0.20", 8.0 },
	{ "T34 0.40 deep feet stay planted", 0.0, "s", testCountLoose, "T01", "T34 crouch 0.40", 8.0 },
	{ "T34 0.20 deep on a slope feet stay planted", 0.0, "s", testCountLoose, "T34", "crouch 0.20", 3.0 },
	{ "T34 0.40 deep on a slope feet stay planted", 0.0, "s", testCountLoose, "T34", "crouch 0.40", 3.0 },
	{ "T43 hips aside, no step in 60 s", 0.0, "times", testCountReleases, "T01", "T43 hips aside", 0.0 },
	{ "T44 stairs at 30 Hz", 3.0, "mm", testAtRate, "T02", "1.40 stepped", 30.0 },
	{ "T44 stairs at 144 Hz", 3.0, "mm", testAtRate, "T02", "1.40 stepped", 144.0 },
	{ "T44 stairs at 165 Hz", 3.0, "mm", testAtRate, "T02", "1.40 stepped", 165.0 },
	{ "T44 stairs at 240 Hz", 3.0, "mm", testAtRate, "T02", "1.40 stepped", 240.0 },
	{ "T44 noise at 30 Hz", 3.0, "mm", testAtRate, "T16-1", "walk", 30.0 },
	{ "T44 noise at 144 Hz", 3.0, "mm", testAtRate, "T16-1", "walk", 144.0 },
	{ "T44 noise at 165 Hz", 3.0, "mm", testAtRate, "T16-1", "walk", 165.0 },
	{ "T44 noise at 240 Hz", 3.0, "mm", testAtRate, "T16-1", "walk", 240.0 },
	{ "T44 turning at 30 Hz", 3.0, "mm", testAtRate, "T01", "T39 round in 2.0", 30.0 },
	{ "T44 turning at 144 Hz", 3.0, "mm", testAtRate, "T01", "T39 round in 2.0", 144.0 },
	{ "T44 turning at 165 Hz", 3.0, "mm", testAtRate, "T01", "T39 round in 2.0", 165.0 },
	{ "T44 turning at 240 Hz", 3.0, "mm", testAtRate, "T01", "T39 round in 2.0", 240.0 },
	{ "T48 planted soles lie on the planet", 3.0, "mm", testLieOnPlanet, "T48", "round", 6.0 },
	{ "T48 held feet stay where they are", 1.0, "mm", testStayOnPlanet, "T48", "round", 0.0 },
	{ "T48 the clip's stances are held", 0.0, "missing", testHoldOnPlanet, "T48", "round", 0.0 },
	{ "T48 the pelvis goes round evenly", 6.0, "mm", testGoEvenly, "T48", "round", 0.0 },
	{ "T48 seven turned worlds give the same", 1.0, "mm", testInTurnedWorlds, "T48", "round", 0.0 },
	{ "T45 frames of no length change nothing", 0.0, "mm", testAcrossPause, "T02", "T45 pause", 0.0 },
};

const testCheck* testGetChecks( int32_t* count )
{
	*count = (int32_t)( sizeof s_checks / sizeof s_checks[0] );
	return s_checks;
}
