// SPDX-License-Identifier: MIT
// What a run is judged by: eight gates, and what single scenes ask for beside them. Lengths in metres, angles in
// degrees.
#ifndef TEST_SCENE_GATES_H
#define TEST_SCENE_GATES_H

#include "scene_run.h"

/// The worst of a figure, and where it was met.
typedef struct testWorst
{
	double value;
	double time;
	int32_t take;
	int32_t leg; // SOLE_NONE: pelvis
} testWorst;

/// The worst over all frames, legs and takes.
typedef struct testGates
{
	testWorst slide;      // G1: of the held point of a planted sole, in the frame of what it stands on, a stance
	testWorst depth;      // G2: of a planted sole in the ground
	testWorst swingDepth; // G2: of any other sole
	testWorst gap;        // G3: under a planted sole that reaches
	testWorst flatGap;    // the same at heel and ball, where the clip has both down
	testWorst move;       // G4: of a foot or the pelvis in a frame, beyond the input's
	testWorst turn;
	testWorst rest; // G5: peak to peak of a foot after 1 s at rest
	testWorst restTurn;
	testWorst straight; // G6: by how much a knee is straighter than 2 degrees, or than the input where that is less
	testWorst folded;   // G6: largest bend
	testWorst plane;    // G6: bend plane against the input's
	testWorst reach;    // G7: hip to ankle beyond 0.995 of the bones, or beyond the input where that is more
	bool finite;        // G7
	bool same;          // G8

	testWorst away; // of feet and pelvis from the input
	testWorst awayTurn;
	testWorst overhang; // share of a flat sole, planted or at rest, with no ground within 20 mm
	testWorst silent;   // depth in the ground of a foot of which nothing is reported
	testWorst yaw;      // of a foot against the pelvis beyond 30 inwards and 60 outwards
	testWorst overlap;  // of the outlines of both feet; below zero: apart
	testWorst kneeRate; // fastest knee, of the input's
	testWorst reported; // by how much the reported error of a planted foot differs from the gap under it
	double plants;      // stances that began, of those that the clips have
	double clipPlants;
} testGates;

testGates testStartGates( void );
/// Adds a run.
void testMeasureRun( const testRun* run, testGates* gates );
/// All takes of an act.
testGates testMeasureAct( const testActor* actor, const testWorld* world, const soleAct* act );

enum
{
	test_g1 = 1 << 0,
	test_g2 = 1 << 1,
	test_g3 = 1 << 2,
	test_g4 = 1 << 3,
	test_g5 = 1 << 4,
	test_g6 = 1 << 5,
	test_g7 = 1 << 6,
	test_g8 = 1 << 7,
	test_gFlat = 1 << 8,    // G3 at heel and ball
	test_gInput = 1 << 9,   // output is input to 1 mm, 0.1 degrees
	test_gLevel = 1 << 10,  // a foot is turned by 5 degrees at most
	test_gOver = 1 << 11,   // at most 35 % of a sole hang over
	test_gSilent = 1 << 12, // what is deeper than 5 mm is reported
	test_gYaw = 1 << 13,
	test_gApart = 1 << 14,  // outlines don't overlap
	test_gKnee = 1 << 15,   // knees 1.5 x as fast as the input's at most
	test_gPlants = 1 << 16, // at least half of the clip's stances are held
	test_gTrue = 1 << 17,   // what is reported of a planted foot is the gap under it
	test_gCheck = 1 << 18   // what runs are compared for
};

/// The gates that are not met.
uint32_t testFindFailed( const testGates* gates );

#endif
