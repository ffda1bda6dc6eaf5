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

const testCheck* testGetChecks( int32_t* count );

#endif
