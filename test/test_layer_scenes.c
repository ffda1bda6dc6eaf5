// SPDX-License-Identifier: MIT
// The layer for ground that is much higher under one foot than under another, on stairs and at a curb: the mannequin
// beside the same without it. World space, metres, degrees.
#include "test.h"

#include "scene_actor.h"
#include "scene_meter.h"
#include "settings_file.h"

// ------------------------------------------------------------------------------------------------------------ scenes

/// What the legs of a run have to do.
typedef struct Effort
{
	double fold;   // largest bend of a planted knee, degrees
	double reach;  // furthest extension of a planted leg, share of its bones
	double raised; // furthest that a foot is over the same without the layer
	double off;    // and a planted foot over or under it
	uint32_t failed;
} Effort;

/// The preset with its parts switched on or off.
static void setLayer( bool knee, bool trunk )
{
	toolError error = { { 0 } };
	if ( !toolReadSettings( SOLE_SOURCE_DIR "/settings/steps.json", &s_actor.settings, &error ) )
	{
		fail_msg( "%s", error.text );
	}
	s_actor.settings.layer.knee *= knee ? 1.0f : 0.0f;
	s_actor.settings.layer.hips *= trunk ? 1.0f : 0.0f;
	s_actor.settings.layer.lean *= trunk ? 1.0f : 0.0f;
}

static void measureRun( const testRun* run, int32_t frame, const testBodyPose* body, Effort* effort )
{
	for ( int32_t leg = 0; leg < run->legCount; ++leg )
	{
		testKnee knee = testFindKnee( body->legs + leg );
		bool planted = ( run->flags[frame * run->legCount + leg] & (uint32_t)sole_legPlanted ) != 0;
		effort->fold = planted ? fmax( effort->fold, knee.bend ) : effort->fold;
		effort->reach = planted ? fmax( effort->reach, knee.reach ) : effort->reach;
	}
}

/// How far feet are over those of the run without the layer.
static void compareFeet( const testRun runs[2], int32_t frame, const testBodyPose bodies[2], Effort* effort )
{
	for ( int32_t leg = 0; leg < runs[1].legCount; ++leg )
	{
		uint32_t flags = runs[0].flags[frame * runs[0].legCount + leg] & runs[1].flags[frame * runs[1].legCount + leg];
		bool planted = ( flags & (uint32_t)sole_legPlanted ) != 0;
		double up = (double)( bodies[1].legs[leg].sole[test_ball].y - bodies[0].legs[leg].sole[test_ball].y );
		effort->off = planted ? fmax( effort->off, fabs( up ) ) : effort->off;
		effort->raised = fmax( effort->raised, up );
	}
}

/// Plays an act without the layer and with it. @param efforts of both
static void playBoth( const char* scene, const char* name, bool knee, bool trunk, Effort efforts[2] )
{
	static testBodyPose bodies[2];
	testWorld world;
	testRun runs[2];
	testOpenWorld( scene, &world );
	const soleAct* act = soleFindAct( scene, name );
	assert_non_null( act );
	for ( int32_t k = 0; k < 2; ++k )
	{
		setLayer( k == 1 && knee, k == 1 && trunk );
		testPlay( &s_actor, &world, act, 0, 0.0, runs + k );
		testGates gates = testStartGates();
		testMeasureRun( runs + k, &gates );
		efforts[k] = ( Effort ){ .failed = testFindFailed( &gates ) };
	}
	for ( int32_t frame = 0; frame < runs[0].frameCount; ++frame )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			testFindBody( runs + k, frame, runs[k].output, bodies + k );
			measureRun( runs + k, frame, bodies + k, efforts + k );
		}
		compareFeet( runs, frame, bodies, efforts + 1 );
	}
	testFreeRun( runs + 0 );
	testFreeRun( runs + 1 );
	testCloseWorld( &world );
}

static void kneesFoldLessOnSteepStairs( void** state )
{
	(void)state;
	static const char* const names[] = { "0.45 stepped", "0.45 ramped", "0.90 stepped", "0.90 ramped" };
	// Slowly most of the fold is of a pelvis that is low for the foot behind; faster, of the height of the steps.
	static const double least[] = { 2.0, 2.0, 5.0, 5.0 };
	for ( int32_t i = 0; i < 4; ++i )
	{
		Effort efforts[2];
		playBoth( "T03", names[i], false, true, efforts );
		printf( "T03 %s: knees at most %.1f degrees, were %.1f\n", names[i], efforts[1].fold, efforts[0].fold );
		assert_true( efforts[1].fold < efforts[0].fold - least[i] );
		assert_true( efforts[1].reach < efforts[0].reach + 1e-3 );
		// What is met without it is met with it.
		assert_int_equal( efforts[1].failed & ~efforts[0].failed, 0 );
	}
}

static void kneesFoldLessAtACurbAndFeetStayOnIt( void** state )
{
	(void)state;
	static const char* const names[] = { "up and down 0", "up and down 30", "one foot up" };
	for ( int32_t i = 0; i < 3; ++i )
	{
		Effort efforts[2];
		playBoth( "T08", names[i], true, true, efforts );
		printf( "T08 %s: knees at most %.1f degrees, were %.1f\n", names[i], efforts[1].fold, efforts[0].fold );
		assert_true( efforts[1].fold < efforts[0].fold - 0.3 );
		assert_true( efforts[1].reach < efforts[0].reach + 1e-3 );
		assert_int_equal( efforts[1].failed & ~efforts[0].failed, 0 );
		assert_int_equal( efforts[1].failed & ( test_g2 | test_g3 | test_g4 | test_g6 | test_g7 ), 0 );
	}
}

static void aFootIsLiftedOnItsWayUpAndComesDownWhereItWould( void** state )
{
	(void)state;
	Effort efforts[2];
	playBoth( "T08", "up and down 0", true, false, efforts );
	// 0.3 of 0.15 m, as far as the demand of a curb goes.
	assert_true( efforts[1].raised > 0.02 && efforts[1].raised < 0.05 );
	assert_true( efforts[1].off < 2e-3 );
	assert_int_equal( efforts[1].failed & ~efforts[0].failed, 0 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( kneesFoldLessOnSteepStairs ),
		cmocka_unit_test( kneesFoldLessAtACurbAndFeetStayOnIt ),
		cmocka_unit_test( aFootIsLiftedOnItsWayUpAndComesDownWhereItWould ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
