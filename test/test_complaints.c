// SPDX-License-Identifier: MIT
// What users of other foot placement complain about: each proved on the scenes and by the figures that are given for
// it. docs/complaints.md has the list. What is not proved yet is listed here, and has to be taken off when it is.
// Figures are in millimetres and degrees.
#include "test.h"

#include "scene_actor.h"
#include "scene_checks.h"
#include "scene_proof.h"
#include "scene_wild.h"

static const struct
{
	int number;
	const char* figures; // when it was listed
} s_notYet[] = {
	{ 1, "T03 1.40 ramped: G4 148.8, deg 32.9, and 11 more" },
	{ 8, "T11-45 up and down: er 98.93, and 1 more" },
	{ 9, "T13 both ways end in one pose: 16.13 mm, and 2 more" },
	{ 12, "T30 stand: G1 2.864, and 1 more" },
	{ 17, "T02 T47 root at 10 Hz: G4 60.83, deg 13.32, and 1 more" },
	{ 18, "T11-20 T33 jump unlabelled: G4 27.92, deg 2.231, and 1 more" },
	{ 22, "T02 0.52 stepped: G4 32.71, deg 0.5641, and 6 more" },
	{ 28, "T04 walk 30: G2 7.194, sw 46.63, G4 49.81, deg 12.38, and 3 more" },
	{ 29, "T02 0.52 ramped: G2 0.6881, sw 15.91, G4 30.61, deg 0.5641, and 2 more" },
	{ 31, "T44 stairs at 30 Hz: 20.63 mm, and 13 more" },
	{ 32, "T11-20 T42 sprint: G4 43.43, deg 14.15" },
	{ 33, "T01 T41 run, stop unlabelled: G2 0.02853, sw 12.74" },
};

/// Compares with the list.
static void testJudge( testProof* proof )
{
	testEndProof( proof );
	bool listed = false;
	for ( size_t i = 0; i < sizeof s_notYet / sizeof s_notYet[0]; ++i )
	{
		if ( s_notYet[i].number == proof->number )
		{
			listed = true;
			printf( "complaint %d: not yet, when it was listed: %s\n", proof->number, s_notYet[i].figures );
		}
	}
	if ( proof->good == listed )
	{
		fail_msg( "complaint %d: %s", proof->number, listed ? "is proved: take it off the list" : "is not proved" );
	}
}

static void complaint01TheBodyDoesNotShakeOnStairs( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 1 );
	testProveAll( &proof, "T02", "", test_g4 );
	testProveAll( &proof, "T03", "", test_g4 );
	testJudge( &proof );
}

static void complaint02DownhillTheWholeSoleTouches( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 2 );
	static const char* const scenes[] = { "T11-10", "T11-20", "T11-30", "T11-45" };
	for ( int i = 0; i < 4; ++i )
	{
		// The slope down is from z = 12 to 20; a sole across one of its edges can't touch with both.
		soleAct down = *testGetAct( scenes[i], "up and down" );
		down.course.z = 12.8;
		down.duration = ( 19.2 - down.course.z ) / down.course.speed;
		testProveAct( &proof, &down, test_gFlat );
	}
	testJudge( &proof );
}

static void complaint03StandingFeetDoNotToggle( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 3 );
	static const char* const scenes[] = { "T16-1", "T16-2", "T16-3", "T16-4", "T16-5", "T18" };
	for ( int i = 0; i < 6; ++i )
	{
		testProveTwice( &proof, scenes[i], "stand", test_g5 );
	}
	testProveTwice( &proof, "T18", "nudged", test_g5 );
	testJudge( &proof );
}

static void complaint04ToesDoNotFlipUpOnRocks( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 4 );
	static const struct
	{
		const char* scene;
		const char* act;
		uint32_t gates;
	} rows[] = { { "T15-60", "stand", test_g6 | test_gLevel }, { "T15-60", "walk", test_g6 | test_gLevel },
		{ "T15-75", "stand", test_g6 | test_gLevel }, { "T15-75", "walk", test_g6 | test_gLevel },
		{ "T17", "walk", test_g6 }, { "T17", "stand", test_g6 } };
	for ( int i = 0; i < 6; ++i )
	{
		testProve( &proof, rows[i].scene, rows[i].act, rows[i].gates );
		// Boxes that are tilted by up to 35 degrees are stood on flat.
		double up = testFindLargest( &proof, rows[i].scene, rows[i].act, testGetToesUp );
		testProveFigure( &proof, "toes up", up, 36.0, "degrees" );
	}
	testJudge( &proof );
}

#ifdef NDEBUG
#define WILD_POSES 1000000
#else
#define WILD_POSES 100000 // builds that check more are slower by as much
#endif

/// T54: many poses, tried once for all that is asked of them.
static testWild testGetWild( void )
{
	static testWild s_wild;
	static bool s_tried;
	s_wild = s_tried ? s_wild : testTryAnything( &s_actor, WILD_POSES );
	s_tried = true;
	return s_wild;
}

static void complaint05KneesStayOnTheirSide( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 5 );
	testProveAll( &proof, "T22", "", test_g6 );
	testWild wild = testGetWild();
	testProveFigure( &proof, "T54: a knee the wrong way", wild.straight, 1e-3, "degrees" );
	testJudge( &proof );
}

static void complaint06LegsDoNotWindUp( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 6 );
	static const char* const turns[] = { "T39 round in 0.5", "T39 round in 1.0", "T39 round in 2.0", "T39 to and fro" };
	for ( int i = 0; i < 4; ++i )
	{
		testProveTwice( &proof, "T01", turns[i], test_gYaw );
	}
	testProveTwice( &proof, "T11-20", "T35 by ramps", test_gYaw );
	testProveTwice( &proof, "T11-20", "T35 at once", test_gYaw );
	testJudge( &proof );
}

static void complaint07KneesDoNotPopStraight( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 7 );
	testProveAll( &proof, "T01", "T41", test_gKnee );
	testProveAll( &proof, "T", "T42", test_gKnee );
	testJudge( &proof );
}

static void complaint08WhatFloatsIsReported( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 8 );
	testProveTwice( &proof, "T01", "T43 lifted", test_gTrue );
	testProveTwice( &proof, "T01", "T43 hips aside", test_gTrue );
	testProveAll( &proof, "T11", "", test_gTrue );
	testJudge( &proof );
}

static void complaint09NoLegDanglesWhateverTheWay( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 9 );
	testProveCheck( &proof, "T13 both ways end in one pose" );
	testProveAll( &proof, "T24", "", test_g4 | test_gOver );
	testJudge( &proof );
}

static void complaint10FeetStayOffTheRoof( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 10 );
	// Nearer to the floor than to what is above it.
	double height = testFindLargest( &proof, "T21", "through", testGetSoleHeight );
	testProveFigure( &proof, "T21 through", height, 0.40, "m" );
	height = testFindLargest( &proof, "T22", "under a bench", testGetSoleHeight );
	testProveFigure( &proof, "T22 under a bench", height, 0.20, "m" );
	height = testFindLargest( &proof, "T22", "crawlway", testGetSoleHeight );
	testProveFigure( &proof, "T22 crawlway", height, 0.45, "m" );
	testJudge( &proof );
}

static void complaint12FeetRideEachOnItsOwn( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 12 );
	static const char* const scenes[] = { "T27", "T28", "T29", "T30" };
	for ( int i = 0; i < 4; ++i )
	{
		testProveAll( &proof, scenes[i], "", test_g1 );
	}
	testJudge( &proof );
}

static void testRaiseAnkles( toolModel* model )
{
	testMoveAnkles( model, 0.03f );
}

static void testLowerAnkles( toolModel* model )
{
	testMoveAnkles( model, -0.03f );
}

static void complaint13WrongAnklesDoNotSinkTheMesh( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 13 );
	static void ( *const changes[] )( toolModel* ) = { NULL, testRaiseAnkles, testLowerAnkles };
	static const char* const names[] = { "as made", "3 cm up", "3 cm down" };
	static const char* const acts[] = { "idle", "walk" };
	for ( int i = 0; i < 6; ++i )
	{
		static testActor s_changed;
		testRun run;
		testOpenActor( &s_changed, changes[i / 2] );
		testPlay( &s_changed, testGetWorld( &proof, "T01" ), testGetAct( "T01", acts[i % 2] ), 0, 0.0, &run );
		double depth = 0.0;
		double gap = 0.0;
		testMeasureMesh( &run, &depth, &gap );
		testProveFigure( &proof, names[i / 2], 1e3 * depth, 5.0, "mm under the floor" );
		testProveFigure( &proof, names[i / 2], 1e3 * gap, 5.0, "mm over it while planted" );
		testFreeRun( &run );
		testCloseActor( &s_changed );
	}
	testJudge( &proof );
}

static void complaint14ShoesChangeAndChangeBack( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 14 );
	static const char* const scenes[] = { "T01", "T11-20" };
	for ( int i = 0; i < 2; ++i )
	{
		testProve( &proof, scenes[i], "T38 heels", test_g3 | test_gFlat );
		testRun run;
		testPlay( &s_actor, testGetWorld( &proof, scenes[i] ), testGetAct( scenes[i], "T38 heels" ), 0, 0.0, &run );
		double apart = 0.0;
		for ( int32_t frame = 60; frame < 120; ++frame )
		{
			// The idle clip's next round, when the heels are off again.
			apart = fmax( apart, testCompareFrames( &run, frame, &run, frame + 240 ) );
		}
		testProveFigure( &proof, "after the change back", apart, 0.01, "mm" );
		testFreeRun( &run );
	}
	testJudge( &proof );
}

static void complaint15EverySizeIsTheSame( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 15 );
	static const char* const acts[] = { "T37 scale at once", "T37 scale in 1 s" };
	double legLength = (double)soleRig_GetLegLength( s_actor.character.rig, 0 );
	for ( int i = 0; i < 4; ++i )
	{
		const soleAct* act = testGetAct( "T11-20", acts[i / 2] );
		soleVec3 same[3];
		soleVec3 scaled[3];
		testFindLast( &proof, act, 1, same );
		testFindLast( &proof, act, i % 2 == 0 ? 0 : 2, scaled );
		for ( int k = 0; k < 3; ++k )
		{
			double apart = (double)soleDistance( same[k], scaled[k] ) / legLength;
			testProveFigure( &proof, acts[i / 2], 100.0 * apart, 0.1, "% of a leg" );
		}
	}
	testJudge( &proof );
}

static void complaint17RemotePlayersWalkAsWell( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 17 );
	testProveAll( &proof, "T", "T47", test_g1 | test_g4 );
	testJudge( &proof );
}

static void complaint18SwitchedOffAndOnWithoutAPop( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 18 );
	testProveAll( &proof, "T", "T33", test_g4 );
	testProveAll( &proof, "T", "T35", test_g4 );
	testJudge( &proof );
}

static void complaint19PropsDoNotPullFeet( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 19 );
	testProveTwice( &proof, "T19", "stand", test_gInput );
	testJudge( &proof );
}

static void complaint20StrafingLegsDoNotCross( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 20 );
	testProveAll( &proof, "T01", "T40", test_g4 | test_gApart );
	testJudge( &proof );
}

static void complaint21BlendsDoNotSkate( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 21 );
	testProveAll( &proof, "T01", "T41", test_g1 );
	testJudge( &proof );
}

static void complaint22SwingFeetDoNotJumpAtSteps( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 22 );
	testProveAll( &proof, "T02", "", test_g4 );
	testProveAll( &proof, "T09", "", test_g4 );
	testProveAll( &proof, "T", "T42", test_g4 );
	testJudge( &proof );
}

static void complaint23NoStepsInPlace( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 23 );
	soleAct act = *testGetAct( "T01", "T43 hips aside" );
	for ( int i = 0; i < 2; ++i )
	{
		testRun run;
		act.host.unlabelled = i == 1;
		testPlay( &s_actor, testGetWorld( &proof, "T01" ), &act, 0, 0.0, &run );
		double steps = testCountFlags( &run, (uint32_t)sole_legReleased ) +
		    testCountFlags( &run, (uint32_t)sole_legCaptured ) - 2.0;
		testProveFigure( &proof, "steps in 60 s", steps, 0.0, "" );
		testFreeRun( &run );
	}
	testJudge( &proof );
}

static void complaint26OutOfReachIsStillAPose( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 26 );
	testWild wild = testGetWild();
	testProveFigure( &proof, "T54: not finite", wild.broken, 0.0, "" );
	testProveFigure( &proof, "T54: beyond its reach", wild.reach, 1e-4, "of a leg" );
	testJudge( &proof );
}

static void complaint28StairsAreCrossedDiagonally( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 28 );
	testProveAll( &proof, "T04", "", test_g2 | test_g4 );
	testJudge( &proof );
}

static void complaint29FeetStandOnWhatIsSeen( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 29 );
	// T06: the root goes over an invisible ramp.
	static const char* const ramped[] = { "0.52 ramped", "1.04 ramped", "1.40 ramped" };
	for ( int i = 0; i < 3; ++i )
	{
		testProve( &proof, "T02", ramped[i], test_g2 | test_g3 | test_g4 );
	}
	testProveAll( &proof, "T20", "", test_g2 | test_g3 );
	testJudge( &proof );
}

static void complaint30CrouchingFeetStayDown( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 30 );
	static const char* const rows[][2] = { { "T01", "T34 crouch 0.20" }, { "T01", "T34 crouch 0.40" },
		{ "T34", "crouch 0.20" }, { "T34", "crouch 0.40" }, { "T34", "crouch" } };
	for ( int i = 0; i < 5; ++i )
	{
		testGates gates = testProve( &proof, rows[i][0], rows[i][1], 0 );
		double error = testFindLargest( &proof, rows[i][0], rows[i][1], testGetPlantedError );
		testProveFigure( &proof, rows[i][1], error, 1.5, "mm of error" );
		testProveFigure( &proof, rows[i][1], 1e3 * gates.gap.value, 1.5, "mm over the ground" );
		testProveFigure( &proof, rows[i][1], 1e3 * gates.depth.value, 1.5, "mm in the ground" );
	}
	testProveCheck( &proof, "T34 0.20 deep feet stay planted" );
	testProveCheck( &proof, "T34 0.40 deep feet stay planted" );
	testProveCheck( &proof, "T34 0.20 deep on a slope feet stay planted" );
	testProveCheck( &proof, "T34 0.40 deep on a slope feet stay planted" );
	testJudge( &proof );
}

static void complaint31EveryFrameRateIsTheSame( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 31 );
	static const char* const rates[] = { "30", "144", "165", "240" };
	for ( int i = 0; i < 12; ++i )
	{
		static const char* const scenes[] = { "stairs", "noise", "turning" };
		char name[64];
		snprintf( name, sizeof name, "T44 %s at %s Hz", scenes[i / 4], rates[i % 4] );
		testProveCheck( &proof, name );
	}
	testProveAll( &proof, "T", "T44", test_g4 );
	testProveAll( &proof, "T", "T46", test_g4 | test_gPlants );
	testJudge( &proof );
}

static void complaint32SprintingUphillIsNoFight( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 32 );
	static const char* const rows[][2] = { { "T11-20", "T42 sprint" }, { "T01", "T42 bend" } };
	for ( int i = 0; i < 2; ++i )
	{
		testGates gates = testProve( &proof, rows[i][0], rows[i][1], test_g4 );
		// One more a foot than the clip has: those that it begins with.
		testProveFigure( &proof, "stances beyond the clip's", gates.plants - gates.clipPlants, 2.0, "" );
	}
	testJudge( &proof );
}

static void complaint33LetGoFeetCutThroughNothing( void** state )
{
	(void)state;
	testProof proof = testBeginProof( &s_actor, 33 );
	static const char* const scenes[] = { "T16-1", "T16-2", "T16-3", "T16-4", "T16-5" };
	for ( int i = 0; i < 5; ++i )
	{
		testProveTwice( &proof, scenes[i], "walk", test_g2 );
	}
	testProveAll( &proof, "T01", "T41", test_g2 );
	testJudge( &proof );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( complaint01TheBodyDoesNotShakeOnStairs ),
		cmocka_unit_test( complaint02DownhillTheWholeSoleTouches ),
		cmocka_unit_test( complaint03StandingFeetDoNotToggle ),
		cmocka_unit_test( complaint04ToesDoNotFlipUpOnRocks ),
		cmocka_unit_test( complaint05KneesStayOnTheirSide ),
		cmocka_unit_test( complaint06LegsDoNotWindUp ),
		cmocka_unit_test( complaint07KneesDoNotPopStraight ),
		cmocka_unit_test( complaint08WhatFloatsIsReported ),
		cmocka_unit_test( complaint09NoLegDanglesWhateverTheWay ),
		cmocka_unit_test( complaint10FeetStayOffTheRoof ),
		cmocka_unit_test( complaint12FeetRideEachOnItsOwn ),
		cmocka_unit_test( complaint13WrongAnklesDoNotSinkTheMesh ),
		cmocka_unit_test( complaint14ShoesChangeAndChangeBack ),
		cmocka_unit_test( complaint15EverySizeIsTheSame ),
		cmocka_unit_test( complaint17RemotePlayersWalkAsWell ),
		cmocka_unit_test( complaint18SwitchedOffAndOnWithoutAPop ),
		cmocka_unit_test( complaint19PropsDoNotPullFeet ),
		cmocka_unit_test( complaint20StrafingLegsDoNotCross ),
		cmocka_unit_test( complaint21BlendsDoNotSkate ),
		cmocka_unit_test( complaint22SwingFeetDoNotJumpAtSteps ),
		cmocka_unit_test( complaint23NoStepsInPlace ),
		cmocka_unit_test( complaint26OutOfReachIsStillAPose ),
		cmocka_unit_test( complaint28StairsAreCrossedDiagonally ),
		cmocka_unit_test( complaint29FeetStandOnWhatIsSeen ),
		cmocka_unit_test( complaint30CrouchingFeetStayDown ),
		cmocka_unit_test( complaint31EveryFrameRateIsTheSame ),
		cmocka_unit_test( complaint32SprintingUphillIsNoFight ),
		cmocka_unit_test( complaint33LetGoFeetCutThroughNothing ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
