// SPDX-License-Identifier: MIT
// Plays an act with the mannequin: samples its clips, moves the ground, asks and answers probes, places the feet, keeps
// what went in and what came out. World space, metres.
#ifndef TEST_SCENE_RUN_H
#define TEST_SCENE_RUN_H

#include "act.h"
#include "motion.h"
#include "sole/ground.h"
#include "source.h"
#include "steps.h"

/// A scene that can be asked: by probes, and exactly.
typedef struct testWorld
{
	soleScene scene;
	soleGround* grounds[SOLE_SCENE_MAX_PIECES];
	soleTerrain* terrains[SOLE_SCENE_MAX_PIECES];
	soleQuat turn; // of the whole world that the host has, against the scene's; still pieces only
} testWorld;

void testOpenWorld( const char* id, testWorld* world );
void testCloseWorld( testWorld* world );

/// The pieces that are there at a time and carry feet, or a root.
/// @param origin of the coordinates in which they are wanted
int32_t testGetPieces(
    const testWorld* world, uint32_t layers, double time, const double origin[3], soleGroundPiece* pieces );

#define TEST_FEET_LAYERS ( (uint32_t)( sole_sceneGround | sole_sceneFeetOnly ) )
#define TEST_ROOT_LAYERS ( (uint32_t)( sole_sceneGround | sole_sceneRootOnly ) )

/// The mannequin with a clip for each gait.
typedef struct testActor
{
	toolGltf* gltf;
	toolCharacter character;
	toolBoundClip clips[sole_gaitCount];
	toolTravel travels[sole_gaitCount];
	toolSteps steps[sole_gaitCount];
	soleSettings settings; // the defaults; a test may change them between runs
} testActor;

/// @param change what is different in the mannequin. May be NULL
void testOpenActor( testActor* actor, void ( *change )( toolModel* model ) );
void testCloseActor( testActor* actor );

/// One run of an act.
typedef struct testRun
{
	const testActor* actor;
	const testWorld* world;
	const soleAct* act;
	int32_t take;
	int32_t frameCount;
	int32_t jointCount;
	int32_t legCount;
	double* times;
	double* steps;
	soleSceneMoment* moments;
	soleTransform* roots;  // as Sole was given them, but for the origin
	soleRig** rigs;        // of each frame: with its shoes on
	soleTransform* input;  // frameCount * jointCount, parent-local
	soleTransform* output; // likewise
	uint32_t* flags;       // frameCount * legCount, soleLegFlags
	float* errors;         // likewise: how far each ankle is from where it was wanted, as Sole says
	bool finite;           // all that Sole gave out
} testRun;

/// @param rate frames a second. 0: the act's own
void testPlay(
    const testActor* actor, const testWorld* world, const soleAct* act, int32_t take, double rate, testRun* run );
void testFreeRun( testRun* run );

/// Plays a run's input again, half of it twice from a saved state. @return whether the same bits come out
bool testPlaysTheSame( const testRun* run );

/// Length of two steps of the clip that a moment plays, m; 0: it stands.
double testGetStride( const testActor* actor, const soleSceneMoment* moment );

/// Character space to world of all joints of a frame's pose.
void testFindJoints( const testRun* run, int32_t frame, const soleTransform* pose, soleTransform* joints );

#endif
