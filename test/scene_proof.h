// SPDX-License-Identifier: MIT
// Proofs for one complaint each: rows of acts with the gates that they have to meet, checks, single figures. What is
// not met is printed, and kept in mind.
#ifndef TEST_SCENE_PROOF_H
#define TEST_SCENE_PROOF_H

#include "scene_gates.h"

/// What was found so far for one complaint.
typedef struct testProof
{
	const testActor* actor;
	int number;
	bool good;
	testWorld world;
} testProof;

testProof testBeginProof( const testActor* actor, int number );
void testEndProof( testProof* proof );

/// A scene, kept open until another one is asked for.
const testWorld* testGetWorld( testProof* proof, const char* scene );
const soleAct* testGetAct( const char* scene, const char* name );

/// A figure that must not be larger than asked for.
void testProveFigure( testProof* proof, const char* what, double figure, double most, const char* unit );
/// One of testGetChecks().
void testProveCheck( testProof* proof, const char* name );
testGates testProveAct( testProof* proof, const soleAct* act, uint32_t gates );
testGates testProve( testProof* proof, const char* scene, const char* name, uint32_t gates );
/// Also by a host that knows nothing of contacts.
void testProveTwice( testProof* proof, const char* scene, const char* name, uint32_t gates );
/// All acts of a test, by how their scene's id and their name begin.
void testProveAll( testProof* proof, const char* scene, const char* name, uint32_t gates );

typedef double testMeasureFcn( const testRun* run, int32_t frame, int32_t leg );
/// The largest of a measure over all legs, frames and takes of an act.
double testFindLargest( testProof* proof, const char* scene, const char* name, testMeasureFcn* measure );

/// Toes up, of the foot or of its toes, beyond the input. Degrees
testMeasureFcn testGetToesUp;
/// Height of the highest point of a sole, m
testMeasureFcn testGetSoleHeight;
/// What is reported of a planted foot, mm
testMeasureFcn testGetPlantedError;

/// Moves the ankles' joints up or down within the body; nothing of the mesh moves.
void testMoveAnkles( toolModel* model, float by );
/// How far the lowest vertex of each foot's mesh is from a floor at height 0, m: under it, or over it while it is
/// planted.
void testMeasureMesh( const testRun* run, double* depth, double* gap );
/// Where feet and pelvis are at the end of an act, as the root sees them.
void testFindLast( testProof* proof, const soleAct* act, int32_t take, soleVec3 parts[3] );

#endif
