// SPDX-License-Identifier: MIT
// Proofs, and what single complaints measure. World space; units as the functions say.
#include "test.h"

#include "scene_checks.h"
#include "scene_figures.h"
#include "scene_meter.h"
#include "scene_proof.h"

#define DEGREES 57.29577951308232

testProof testBeginProof( const testActor* actor, int number )
{
	return ( testProof ){ .actor = actor, .number = number, .good = true, .world = { .scene = { .id = "" } } };
}

static void testMiss( testProof* proof, const char* what, const char* figures )
{
	printf( "complaint %d: %s: %s\n", proof->number, what, figures );
	proof->good = false;
}

void testProveFigure( testProof* proof, const char* what, double figure, double most, const char* unit )
{
	if ( !( figure <= most ) )
	{
		char text[96];
		snprintf( text, sizeof text, "%.4g %s, at most %.4g", figure, unit, most );
		testMiss( proof, what, text );
	}
}

const testWorld* testGetWorld( testProof* proof, const char* scene )
{
	if ( strcmp( proof->world.scene.id, scene ) != 0 )
	{
		testCloseWorld( &proof->world );
		testOpenWorld( scene, &proof->world );
	}
	return &proof->world;
}

const soleAct* testGetAct( const char* scene, const char* name )
{
	const soleAct* act = soleFindAct( scene, name );
	if ( act == NULL )
	{
		fail_msg( "there is no act %s of %s", name, scene );
	}
	return act;
}

testGates testProveAct( testProof* proof, const soleAct* act, uint32_t gates )
{
	testGates found = testMeasureAct( proof->actor, testGetWorld( proof, act->scene ), act );
	uint32_t failed = testFindFailed( &found ) & gates;
	if ( failed != 0 )
	{
		char name[96];
		char text[256];
		snprintf( name, sizeof name, "%s %s%s", act->scene, act->name, act->host.unlabelled ? " unlabelled" : "" );
		testWriteFigures( &found, failed, text, sizeof text );
		testMiss( proof, name, text );
	}
	return found;
}

testGates testProve( testProof* proof, const char* scene, const char* name, uint32_t gates )
{
	return testProveAct( proof, testGetAct( scene, name ), gates );
}

void testProveTwice( testProof* proof, const char* scene, const char* name, uint32_t gates )
{
	soleAct blind = *testGetAct( scene, name );
	if ( blind.host.unlabelled == false )
	{
		testProveAct( proof, &blind, gates );
	}
	blind.host.unlabelled = true;
	testProveAct( proof, &blind, gates );
}

void testProveAll( testProof* proof, const char* scene, const char* name, uint32_t gates )
{
	int32_t count;
	const soleAct* acts = soleGetActs( &count );
	int32_t found = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		bool own = acts[i].name[0] != 'T' || name[0] == 'T';
		if ( own && strncmp( acts[i].scene, scene, strlen( scene ) ) == 0 &&
		    strncmp( acts[i].name, name, strlen( name ) ) == 0 )
		{
			testProveAct( proof, acts + i, gates );
			++found;
		}
	}
	assert_true( found > 0 );
}

void testProveCheck( testProof* proof, const char* name )
{
	int32_t count;
	const testCheck* checks = testGetChecks( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( strcmp( checks[i].name, name ) == 0 )
		{
			testProveFigure(
			    proof, name, checks[i].measure( proof->actor, checks + i ), checks[i].limit, checks[i].unit );
			return;
		}
	}
	fail_msg( "there is no check %s", name );
}

double testFindLargest( testProof* proof, const char* scene, const char* name, testMeasureFcn* measure )
{
	const soleAct* act = testGetAct( scene, name );
	double largest = 0.0;
	for ( int32_t take = 0; take == 0 || take < act->special.takeCount; ++take )
	{
		testRun run;
		testPlay( proof->actor, testGetWorld( proof, scene ), act, take, 0.0, &run );
		for ( int32_t i = 0; i < run.frameCount * run.legCount; ++i )
		{
			largest = fmax( largest, measure( &run, i / run.legCount, i % run.legCount ) );
		}
		testFreeRun( &run );
	}
	return largest;
}

void testEndProof( testProof* proof )
{
	testCloseWorld( &proof->world );
}

// ----------------------------------------------------------------------------------------------------------- measures

double testGetToesUp( const testRun* run, int32_t frame, int32_t leg )
{
	static testBodyPose s_in;
	static testBodyPose s_out;
	testFindBody( run, frame, run->input, &s_in );
	testFindBody( run, frame, run->output, &s_out );
	double most = -180.0;
	for ( int i = test_heel; i <= test_ball; ++i )
	{
		double pitch[2];
		for ( int k = 0; k < 2; ++k )
		{
			const soleVec3* sole = ( k == 0 ? &s_in : &s_out )->legs[leg].sole;
			soleVec3 ahead = soleSub( sole[i + 1], sole[i] );
			pitch[k] = DEGREES * asin( (double)( ahead.y / soleLength( ahead ) ) );
		}
		most = fmax( most, pitch[1] - pitch[0] );
	}
	return most;
}

double testGetSoleHeight( const testRun* run, int32_t frame, int32_t leg )
{
	static testBodyPose s_out;
	testFindBody( run, frame, run->output, &s_out );
	const soleVec3* sole = s_out.legs[leg].sole;
	return (double)soleMaxF( sole[test_heel].y, soleMaxF( sole[test_ball].y, sole[test_toe].y ) );
}

double testGetPlantedError( const testRun* run, int32_t frame, int32_t leg )
{
	int32_t i = frame * run->legCount + leg;
	return ( run->flags[i] & (uint32_t)sole_legPlanted ) != 0 ? 1e3 * (double)run->errors[i] : 0.0;
}

void testMoveAnkles( toolModel* model, float by )
{
	static const char* const names[] = { "foot_l", "toe_l", "foot_r", "toe_r" };
	for ( int i = 0; i < 4; ++i )
	{
		int32_t node = toolFindNode( model, names[i] );
		assert_true( node != SOLE_NONE );
		bool ankle = i % 2 == 0;
		model->nodes[node].local.translation.y += ankle ? by : -by;
		toolSkin* skin = model->skins;
		for ( int32_t k = 0; k < skin->jointCount && ankle; ++k )
		{
			// The bind pose is not turned.
			skin->inverseBind[16 * k + 13] -= skin->joints[k] == node ? by : 0.0f;
		}
	}
}

void testMeasureMesh( const testRun* run, double* depth, double* gap )
{
	const toolCharacter* character = &run->actor->character;
	static soleTransform s_joints[MOST_JOINTS];
	assert_true( character->pointCount > 40 );
	for ( int32_t i = 0; i < run->frameCount * run->legCount; ++i )
	{
		int32_t frame = i / run->legCount;
		testFindJoints( run, frame, run->output + (size_t)frame * (size_t)run->jointCount, s_joints );
		double lowest = 1.0;
		for ( int32_t k = 0; k < character->pointCount; ++k )
		{
			const soleMeasurePoint* point = character->points + k;
			bool own = point->leg == i % run->legCount;
			double height = (double)soleTransformPoint( s_joints[point->joint], point->position ).y;
			lowest = own ? fmin( lowest, height ) : lowest;
		}
		bool planted = ( run->flags[i] & (uint32_t)sole_legPlanted ) != 0;
		*depth = fmax( *depth, -lowest );
		*gap = fmax( *gap, planted ? lowest : 0.0 );
	}
}

void testFindLast( testProof* proof, const soleAct* act, int32_t take, soleVec3 parts[3] )
{
	static testBodyPose s_out;
	testRun run;
	testPlay( proof->actor, testGetWorld( proof, act->scene ), act, take, 0.0, &run );
	int32_t last = run.frameCount - 1;
	testFindBody( &run, last, run.output, &s_out );
	const soleVec3 world[3] = { s_out.pelvis.translation, s_out.legs[0].foot.translation,
		s_out.legs[1].foot.translation };
	for ( int i = 0; i < 3; ++i )
	{
		parts[i] = soleInvTransformPoint( run.roots[last], world[i] );
	}
	testFreeRun( &run );
}
