// SPDX-License-Identifier: MIT
// What is asked of two runs together, or of a whole run: one figure each, with the most that it may be.
#ifndef TEST_SCENE_CHECKS_H
#define TEST_SCENE_CHECKS_H

#include "scene_run.h"

typedef struct testCheck testCheck;

struct testCheck
{
	const char* name;
	double limit;
	const char* unit;
	double ( *measure )( const testActor* actor, const testCheck* check );
	const char* scene;
	const char* act;
	double value; // what checks of one kind differ in
};

/// T48, scene_around.c: what the gates ask of others, measured from a planet's middle.
double testLieOnPlanet( const testActor* actor, const testCheck* check );
double testStayOnPlanet( const testActor* actor, const testCheck* check );
double testHoldOnPlanet( const testActor* actor, const testCheck* check );
double testGoEvenly( const testActor* actor, const testCheck* check );
double testInTurnedWorlds( const testActor* actor, const testCheck* check );

const testCheck* testGetChecks( int32_t* count );

/// Largest distance of a foot or the pelvis between two frames, mm.
double testCompareFrames( const testRun* a, int32_t frameA, const testRun* b, int32_t frameB );
/// Over all frames and legs.
double testCountFlags( const testRun* run, uint32_t flag );

#endif
