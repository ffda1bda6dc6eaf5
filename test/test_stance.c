// SPDX-License-Identifier: MIT
// Feet from strike to toe-off, from outside: they stay where they have come down, by whatever part of the sole they
// stand, and leave without running into what is before them.
#include "test.h"

#include "scene_actor.h"
#include "scene_gates.h"
#include "scene_meter.h"

#include <math.h>
#include <string.h>

static testGates measure( const char* scene, const char* name, bool told )
{
	testWorld world;
	testOpenWorld( scene, &world );
	soleAct act = *soleFindAct( scene, name );
	act.host.unlabelled = told == false;
	testGates gates = testMeasureAct( &s_actor, &world, &act );
	testCloseWorld( &world );
	assert_true( gates.plants > 1.0 );
	return gates;
}

/// A foot that comes down while it is foreseen to be in flight has not asked what is under it. It had no ground for
/// that frame, and forgot what was foreseen: heels went 24 to 40 mm into their treads.
static void aFootThatComesDownUnaskedStandsOnWhatWasForeseen( void** state )
{
	(void)state;
	assert_true( measure( "T02", "1.04 stepped", false ).depth.value < 1e-3 );
	assert_true( measure( "T02", "T33 jump", true ).depth.value < 1e-3 );
}

/// Until such a foot was held it went back from its foothold to where the animation has it: by 11 mm.
static void aFootThatNobodyToldOfStaysOnItsFoothold( void** state )
{
	(void)state;
	assert_true( measure( "T02", "0.52 stepped", false ).slide.value < 0.7e-3 );
	assert_true( measure( "T02", "1.04 stepped", false ).slide.value < 1e-3 );
}

/// At the end of a stance the foot stands on its toe tip, and its ball goes round that. Held by its ball the tip slid
/// by 5 to 7 mm, and on the flat the foot was not where its clip has it.
static void feetRollOverTheirToeTips( void** state )
{
	(void)state;
	assert_true( measure( "T11-20", "diagonal", false ).slide.value < 1e-3 );
	assert_true( measure( "T11-10", "up and down", false ).slide.value < 1e-3 );
	assert_true( measure( "T01", "run", true ).away.value < 1e-3 );
	assert_true( measure( "T01", "run", false ).away.value < 1e-3 );
}

/// What a leg does not quite reach its foot hangs over; it was drawn towards the hip.
static void aFootOutOfReachDoesNotSlide( void** state )
{
	(void)state;
	testGates gates = measure( "T07", "up", true );
	assert_true( gates.gap.value > 5e-3 ); // there is one
	assert_true( gates.slide.value < 0.5e-3 );
}

/// Ankles at their limit turn a foot about what it stands on: about its toe joint, by which its tip slid by 2.8 mm.
static void ankleLimitsTurnAFootOnItsToesAboutTheirTip( void** state )
{
	(void)state;
	assert_true( measure( "T02", "1.40 stepped", false ).slide.value < 1.8e-3 );
}

/// Where feet turn about their ankles, each was put with its ankle where its heel was when that came down: 135 mm
/// ahead.
static void feetThatTurnAboutTheirAnklesDoNotJumpWhenTheyComeDown( void** state )
{
	(void)state;
	s_actor.settings.contact.pivot = sole_pivotAnkle;
	testGates gates = measure( "T01", "walk", true );
	s_actor.settings = soleDefaultSettings();
	assert_true( gates.move.value < 10e-3 );
}

/// Toes of a foot that stands right before a riser went into it when they left: by 37 to 41 mm.
static void aFootThatSetsOutBeforeARiserWaitsForItsLift( void** state )
{
	(void)state;
	assert_true( measure( "T02", "1.40 stepped", true ).swingDepth.value < 27e-3 );
	assert_true( measure( "T09", "walk", true ).swingDepth.value < 32e-3 );
	assert_true( measure( "T07", "up slowly", true ).swingDepth.value < 2e-3 );
}

/// The heel of a foot that leaves is lowered smoothly. Where its ankle was at its limit it was solved again, and lifted
/// again by all that was left: it turned by 36 degrees in a frame.
static void aFootThatItsAnkleTurnsIsLiftedOnce( void** state )
{
	(void)state;
	assert_true( measure( "T11-45", "diagonal", true ).turn.value < 15.0 );
	assert_true( measure( "T14-30", "walk left", true ).turn.value < 4.0 );
}

/// A foot that came down on its heel out of its leg's reach had that heel lifted at once, about a ball that was in the
/// air: it slid by 1.6 to 2.1 mm when the ball came down.
static void aHeelThatAFootComesDownOnIsNotLifted( void** state )
{
	(void)state;
	assert_true( measure( "T16-1", "walk", true ).slide.value < 1e-3 );
	assert_true( measure( "T16-5", "walk", true ).slide.value < 1e-3 );
	assert_true( measure( "T02", "1.40 stepped", true ).slide.value < 1e-3 );
}

/// The first step of the second foot is foreseen by what the first one did: its heel lands on the ground, not 7 mm
/// over.
static void theFirstStepOfAFootIsForeseenByTheOther( void** state )
{
	(void)state;
	assert_true( measure( "T11-10", "across", false ).gap.value < 1e-3 );
}

/// On the way up the body's ground rises faster than the springs of the pelvis let go: heels of feet that stand flat
/// were lifted by 15 to 23 mm until it was low enough.
static void heelsThatStandStayDown( void** state )
{
	(void)state;
	assert_true( measure( "T02", "0.52 stepped", true ).flatGap.value < 5e-3 );
	assert_true( measure( "T02", "0.52 stepped", false ).flatGap.value < 5e-3 );
	assert_true( measure( "T08", "up and down 0", true ).flatGap.value < 5e-3 );
	assert_true( measure( "T11-10", "up and down", true ).flatGap.value < 5e-3 );
	assert_true( measure( "T29", "stand", true ).flatGap.value < 5e-3 );
}

/// RMS of the third difference of the pelvis' height, m/s3, a while after the beginning.
static double findPelvisJerk( const testRun* run )
{
	double heights[4] = { 0.0 };
	double sum = 0.0;
	int32_t count = 0;
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		static testBodyPose out;
		testFindBody( run, i, run->output, &out );
		memmove( heights, heights + 1, 3 * sizeof heights[0] );
		heights[3] = (double)out.pelvis.translation.y;
		double jerk = ( heights[3] - 3.0 * heights[2] + 3.0 * heights[1] - heights[0] ) * 60.0 * 60.0 * 60.0;
		bool counts = run->times[i] > 2.0;
		sum += counts ? jerk * jerk : 0.0;
		count += counts ? 1 : 0;
	}
	assert_true( count > 100 );
	return sqrt( sum / (double)count );
}

/// A foot that nobody told of is seen to leave when it has, and its way began where it was by then: the body's ground
/// stood still for a frame, and with it the pelvis: it jerked with 520 m/s3, 117 now.
static void thePelvisGoesOnWhenAFootLeaves( void** state )
{
	(void)state;
	testWorld world;
	static testRun run;
	testOpenWorld( "T02", &world );
	soleAct act = *soleFindAct( "T02", "0.52 stepped" );
	act.host.unlabelled = true;
	testPlay( &s_actor, &world, &act, 0, 60.0, &run );
	double jerk = findPelvisJerk( &run );
	assert_true( jerk < 200.0 );
	testFreeRun( &run );
	testCloseWorld( &world );
}

/// Up two treads a step a foot passes its own hip nearer than the leg folds. That turned thighs by 45 degrees in a
/// frame, and those of a crouching walk by 110; 33 and 39 now.
static void aFootThatPassesItsHipGoesBelow( void** state )
{
	(void)state;
	testGates gates = measure( "T03", "1.40 ramped", true );
	assert_true( gates.turn.value < 36.0 );
	assert_true( gates.move.value < 0.16 );
}

/// A foot in flight went along its way until its leg was stretched, and waited there for the pelvis to come down: knees
/// snapped straight, 4 times as fast as the clip's on plates.
static void aFootOnItsWayDownDoesNotSnapItsKnee( void** state )
{
	(void)state;
	assert_true( measure( "T07", "up", true ).kneeRate.value < 3.7 );
	assert_true( measure( "T11-20", "diagonal", true ).kneeRate.value < 1.4 );
}

/// The heel of a foot that leaves was lowered at once by a third of its lift: 9 degrees in a frame.
static void aLiftedHeelIsLoweredSmoothly( void** state )
{
	(void)state;
	assert_true( measure( "T11-30", "up and down", true ).turn.value < 7.5 );
	assert_true( measure( "T12", "walk", true ).turn.value < 7.5 );
}

/// Of places near the end of what had been asked for the last bit of a sole was not known: toes came to stand in
/// risers, by up to 38 mm.
static void footholdsAreChosenWhereBothEndsOfASoleAreKnown( void** state )
{
	(void)state;
	assert_true( measure( "T03", "1.40 stepped", true ).depth.value < 20e-3 );
	assert_true( measure( "T11-20", "up and down", true ).swingDepth.value < 8e-3 );
}

/// While one foot stepped over the other waited until its lock was torn, and slid back over the ground: 27 mm a frame.
static void aFootThatIsTurnedTooFarToWaitStepsOver( void** state )
{
	(void)state;
	assert_true( measure( "T01", "T39 round in 2.0", true ).move.value < 14e-3 );
	assert_true( measure( "T01", "T39 to and fro", true ).move.value < 20e-3 );
}

/// Where a character appeared the ground was read once more in the second frame, for feet that were tilted by then: on
/// boxes they moved by 38 mm and turned by 17 degrees.
static void feetStandAtOnceWhereACharacterAppears( void** state )
{
	(void)state;
	testGates gates = measure( "T17", "stand", true );
	assert_true( gates.move.value < 5e-3 );
	assert_true( gates.slide.value < 1e-3 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aFootThatComesDownUnaskedStandsOnWhatWasForeseen ),
		cmocka_unit_test( aFootThatNobodyToldOfStaysOnItsFoothold ),
		cmocka_unit_test( feetRollOverTheirToeTips ),
		cmocka_unit_test( aFootOutOfReachDoesNotSlide ),
		cmocka_unit_test( ankleLimitsTurnAFootOnItsToesAboutTheirTip ),
		cmocka_unit_test( feetThatTurnAboutTheirAnklesDoNotJumpWhenTheyComeDown ),
		cmocka_unit_test( aFootThatSetsOutBeforeARiserWaitsForItsLift ),
		cmocka_unit_test( aFootThatItsAnkleTurnsIsLiftedOnce ),
		cmocka_unit_test( aHeelThatAFootComesDownOnIsNotLifted ),
		cmocka_unit_test( theFirstStepOfAFootIsForeseenByTheOther ),
		cmocka_unit_test( heelsThatStandStayDown ),
		cmocka_unit_test( thePelvisGoesOnWhenAFootLeaves ),
		cmocka_unit_test( aFootThatPassesItsHipGoesBelow ),
		cmocka_unit_test( aFootOnItsWayDownDoesNotSnapItsKnee ),
		cmocka_unit_test( aLiftedHeelIsLoweredSmoothly ),
		cmocka_unit_test( footholdsAreChosenWhereBothEndsOfASoleAreKnown ),
		cmocka_unit_test( aFootThatIsTurnedTooFarToWaitStepsOver ),
		cmocka_unit_test( feetStandAtOnceWhereACharacterAppears ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
