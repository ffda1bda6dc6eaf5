// SPDX-License-Identifier: MIT
// The mannequin that all tests of a program play acts with, opened once for all of them.
#ifndef TEST_SCENE_ACTOR_H
#define TEST_SCENE_ACTOR_H

#include "scene_run.h"

static testActor s_actor;

static int setup( void** state )
{
	(void)state;
	testOpenActor( &s_actor, NULL );
	return 0;
}

static int teardown( void** state )
{
	(void)state;
	testCloseActor( &s_actor );
	return 0;
}

#endif
