// SPDX-License-Identifier: MIT
// Plays acts frame by frame as a host would. World space, metres.
#include "test.h"

#include "mannequin.h"
#include "scene_pose.h"
#include "scene_run.h"
#include "scene_steps.h"

// ---------------------------------------------------------------------------------------------------------- the world

static void testBuildPiece( testWorld* world, int32_t index )
{
	const soleScene* scene = &world->scene;
	const soleScenePiece* piece = scene->pieces + index;
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = scene->positions;
	mesh.vertexCount = scene->vertexCount;
	mesh.indices = scene->indices + 3 * piece->firstTriangle;
	mesh.triangleCount = piece->triangleCount;
	mesh.layer = piece->layer;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	assert_int_equal( soleCreateGround( &def, NULL, world->grounds + index, NULL ), sole_success );
	assert_int_equal( soleCreateTerrain( scene->positions, scene->vertexCount, mesh.indices, mesh.triangleCount,
	                      soleVec( 0.0f, 1.0f, 0.0f ), NULL, world->terrains + index, NULL ),
	    sole_success );
}

void testOpenWorld( const char* id, testWorld* world )
{
	memset( world, 0, sizeof *world );
	assert_true( soleMakeScene( id, &world->scene ) );
	world->turn = soleQuat_Identity();
	for ( int32_t i = 0; i < world->scene.pieceCount; ++i )
	{
		testBuildPiece( world, i );
	}
}

void testCloseWorld( testWorld* world )
{
	for ( int32_t i = 0; i < world->scene.pieceCount; ++i )
	{
		soleDestroyGround( world->grounds[i] );
		soleDestroyTerrain( world->terrains[i] );
	}
	soleFreeScene( &world->scene );
}

int32_t testGetPieces(
    const testWorld* world, uint32_t layers, double time, const double origin[3], soleGroundPiece* pieces )
{
	int32_t count = 0;
	soleVec3 shift = soleVec( (float)origin[0], (float)origin[1], (float)origin[2] );
	for ( int32_t i = 0; i < world->scene.pieceCount; ++i )
	{
		soleGroundPiece* piece = pieces + count;
		*piece = ( soleGroundPiece ){ .ground = world->grounds[i], .surface = world->scene.pieces[i].surface };
		bool there = soleGetScenePiece( &world->scene, i, time, &piece->transform );
		if ( there && ( world->scene.pieces[i].layer & layers ) != 0 )
		{
			soleGetScenePieceSpeed( &world->scene, i, time, &piece->velocity_w, &piece->spin_w );
			piece->transform.translation = soleSub( piece->transform.translation, shift );
			count += 1;
		}
	}
	return count;
}

static bool testFindFloor( void* user, double x, double z, double ceiling, double time, double* height )
{
	const double noOrigin[3] = { 0.0, 0.0, 0.0 };
	soleGroundPiece pieces[SOLE_SCENE_MAX_PIECES];
	int32_t count = testGetPieces( user, TEST_ROOT_LAYERS, time, noOrigin, pieces );
	double top = ceiling < 100.0 ? ceiling : 100.0;
	soleProbe probe = {
		.start_w = soleVec( (float)x, (float)top, (float)z ),
		.direction_w = soleVec( 0.0f, -1.0f, 0.0f ),
		.length = 200.0f,
		.mask = UINT32_MAX,
	};
	soleHit hit = soleCastPieces( pieces, count, &probe );
	*height = hit.hit ? (double)hit.point_w.y : *height;
	return hit.hit;
}

// ---------------------------------------------------------------------------------------------------------- the actor

void testOpenActor( testActor* actor, void ( *change )( toolModel* model ) )
{
	static const char* const names[sole_gaitCount] = { "idle", "walk", "run", "strafe", "crouch", "crouch_walk" };
	toolError error = { { 0 } };
	memset( actor, 0, sizeof *actor );
	actor->settings = soleDefaultSettings();
	toolModel made;
	toolMakeMannequin( &made );
	if ( change != NULL )
	{
		change( &made );
	}
	actor->gltf = toolMakeGltf( &made );
	toolFreeModel( &made );
	assert_non_null( actor->gltf );
	const toolModel* model = toolGltf_GetModel( actor->gltf );
	assert_true( toolMakeCharacter( model, "mannequin", 1.0f, &actor->character, &error ) );
	for ( int32_t i = 0; i < sole_gaitCount; ++i )
	{
		int32_t clip = toolFindClip( model, names[i] );
		assert_true( clip != SOLE_NONE );
		assert_true( toolBindClip( &actor->character, model, clip, actor->clips + i, &error ) );
		actor->travels[i] = toolFindTravel( &actor->character, actor->clips + i );
		toolFindSteps( &actor->character, actor->clips + i, actor->travels + i, actor->steps + i );
		assert_true( actor->steps[i].count >= actor->character.rigDef.legCount );
	}
}

void testCloseActor( testActor* actor )
{
	for ( int32_t i = 0; i < sole_gaitCount; ++i )
	{
		toolFreeSteps( actor->steps + i );
		toolFreeBoundClip( actor->clips + i );
	}
	toolFreeCharacter( &actor->character );
	toolFreeGltf( actor->gltf );
}

void testFindJoints( const testRun* run, int32_t frame, const soleTransform* pose, soleTransform* joints )
{
	const toolCharacter* character = &run->actor->character;
	for ( int32_t i = 0; i < run->jointCount; ++i )
	{
		int32_t parent = character->parents[i];
		joints[i] = soleMulTransform( parent == SOLE_NONE ? run->roots[frame] : joints[parent], pose[i] );
	}
}

// ------------------------------------------------------------------------------------------------------------ playing

#define MOST_LATE 3

/// What a host keeps from frame to frame.
typedef struct testHost
{
	soleState state;
	soleSettings settings;
	soleHit answers[MOST_LATE + 1][SOLE_MAX_PROBES]; // by frame, the newest at frame % ( MOST_LATE + 1 )
	int32_t answerCounts[MOST_LATE + 1];
} testHost;

static testHost* testStartHost( const testRun* run )
{
	testHost* host = calloc( 1, sizeof *host );
	assert_non_null( host );
	host->state = soleDefaultState( run->actor->character.rig );
	host->settings = run->actor->settings;
	host->settings.probe.mask = TEST_FEET_LAYERS;
	return host;
}

static bool testIsLost( const soleAct* act, int32_t frame, int32_t probe, double time )
{
	uint32_t seed = (uint32_t)( frame * 977 + probe + 1 ) * 2654435761u;
	bool lost = (double)testRandomFloat( &seed, 0.0f, 1.0f ) < act->host.dropped;
	return lost || ( time > act->host.blindFrom && time < act->host.blindUntil );
}

static bool testIsTurned( const testWorld* world )
{
	return world->turn.w != 1.0f;
}

/// A probe of the host's world, cast at the scene's.
static soleHit testCastTurned(
    const testWorld* world, const soleGroundPiece* pieces, int32_t pieceCount, const soleProbe* probe )
{
	soleProbe upright = *probe;
	upright.start_w = soleInvRotate( world->turn, probe->start_w );
	upright.direction_w = soleInvRotate( world->turn, probe->direction_w );
	soleHit hit = soleCastPieces( pieces, pieceCount, &upright );
	hit.point_w = soleRotate( world->turn, hit.point_w );
	hit.normal_w = soleRotate( world->turn, hit.normal_w );
	hit.asked_w = probe->start_w;
	return hit;
}

/// Asks the ground now. What comes of it now may have been asked earlier.
static const soleHit* testAsk(
    const testRun* run, testHost* host, const soleFrame* frame, int32_t index, int32_t* count )
{
	soleProbe probes[SOLE_MAX_PROBES];
	soleGroundPiece pieces[SOLE_SCENE_MAX_PIECES];
	const soleRig* rig = run->rigs[index];
	int32_t pieceCount =
	    testGetPieces( run->world, TEST_FEET_LAYERS, run->times[index], run->moments[index].origin, pieces );
	int32_t slot = index % ( MOST_LATE + 1 );
	soleHit* answers = host->answers[slot];
	host->answerCounts[slot] = soleGatherProbes( rig, &host->settings, &host->state, frame, probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < host->answerCounts[slot]; ++i )
	{
		answers[i] = testIsTurned( run->world ) ? testCastTurned( run->world, pieces, pieceCount, probes + i )
		                                        : soleCastPieces( pieces, pieceCount, probes + i );
		if ( testIsLost( run->act, index, i, run->times[index] ) )
		{
			answers[i] = ( soleHit ){ .surface = SOLE_NONE, .asked_w = probes[i].start_w };
		}
	}
	// A host waits for its first answers.
	int32_t asked = index > run->act->host.late ? index - run->act->host.late : 0;
	slot = asked % ( MOST_LATE + 1 );
	*count = host->answerCounts[slot];
	return host->answers[slot];
}

static int32_t testGetSupports( const soleGroundPiece* pieces, int32_t count, soleSupport* supports )
{
	int32_t supportCount = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( pieces[i].surface != SOLE_NONE )
		{
			supports[supportCount] = ( soleSupport ){ pieces[i].surface, pieces[i].transform };
			supportCount += 1;
		}
	}
	return supportCount;
}

/// One frame from the run's input to a pose.
static void testStep( const testRun* run, testHost* host, int32_t index, soleTransform* pose, soleOutput* out )
{
	const soleSceneMoment* moment = run->moments + index;
	const soleRig* rig = run->rigs[index];
	soleGroundPiece pieces[SOLE_SCENE_MAX_PIECES];
	soleSupport supports[SOLE_SCENE_MAX_PIECES];
	soleContactInput contacts[SOLE_MAX_LEGS];
	soleStepInput steps[SOLE_MAX_LEGS];
	bool labelled = testReadSteps( run, index, contacts, steps );
	int32_t pieceCount = testGetPieces( run->world, TEST_FEET_LAYERS, run->times[index], moment->origin, pieces );
	soleFrame frame = {
		.pose = run->input + (size_t)index * (size_t)run->jointCount,
		.root = run->roots[index],
		.up = moment->up,
		.timeStep = (float)run->steps[index],
		.weight = (float)moment->weight,
		.contact = labelled ? contacts : NULL,
		.steps = labelled ? steps : NULL,
		.clipFloor = run->actor->travels[moment->gait].clipFloor,
		.supports = supports,
		.supportCount = testGetSupports( pieces, pieceCount, supports ),
		.teleport = index > 0 && moment->jumps != moment[-1].jumps,
	};
	soleVec3 shift = soleVec( (float)moment->origin[0], (float)moment->origin[1], (float)moment->origin[2] );
	frame.root.translation = soleSub( frame.root.translation, shift );
	memcpy( frame.worldOrigin, moment->origin, sizeof frame.worldOrigin );
	if ( testIsTurned( run->world ) )
	{
		frame.root.translation = soleRotate( run->world->turn, frame.root.translation );
		frame.root.rotation = soleMulQuat( run->world->turn, frame.root.rotation );
		frame.up = soleRotate( run->world->turn, frame.up );
	}
	int32_t count;
	const soleHit* hits = testAsk( run, host, &frame, index, &count );
	soleSolve( rig, &host->settings, &host->state, &frame, hits, count, out );
	memcpy( pose, frame.pose, (size_t)run->jointCount * sizeof *pose );
	soleApply( rig, out, pose );
}

static bool testIsPoseFinite( const soleTransform* pose, int32_t count )
{
	bool finite = true;
	for ( int32_t i = 0; i < count; ++i )
	{
		finite = finite && soleVec3_IsFinite( pose[i].translation ) && soleQuat_IsFinite( pose[i].rotation );
	}
	return finite;
}

static int32_t testCountFrames( const soleAct* act, double rate )
{
	int32_t count = 0;
	double time = 0.0;
	while ( time < act->duration + 1e-9 )
	{
		count += 1;
		time += rate > 0.0 ? 1.0 / rate : soleGetActStep( act, count );
	}
	return count;
}

/// The rig with a higher heel under its shoes.
static soleRig* testMakeRig( const toolCharacter* character, double heel )
{
	soleRigDef def = character->rigDef;
	for ( int32_t leg = 0; leg < def.legCount; ++leg )
	{
		def.legs[leg].sole.heel = soleMulAdd( def.legs[leg].sole.heel, (float)-heel, def.up );
	}
	soleRig* rig;
	assert_int_equal( soleCreateRig( &def, NULL, &rig, NULL ), sole_success );
	return rig;
}

static void testPutOnShoes( testRun* run )
{
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		double heel = run->moments[i].heel;
		bool kept = i > 0 && heel == run->moments[i - 1].heel;
		soleRig* fresh = heel == 0.0 ? run->actor->character.rig : NULL;
		run->rigs[i] =
		    kept ? run->rigs[i - 1] : ( fresh != NULL ? fresh : testMakeRig( &run->actor->character, heel ) );
	}
}

/// Times, moments, roots and poses that go in.
static void testMakeInput( testRun* run, double rate )
{
	const soleStage stage = { &run->world->scene, testFindFloor, (void*)(uintptr_t)run->world };
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		soleSceneMoment* moment = run->moments + i;
		run->steps[i] = i > 0 && rate > 0.0 ? 1.0 / rate : soleGetActStep( run->act, i );
		// Steady frames are counted, so that no rounding adds up.
		bool steady = run->act->host.step == NULL;
		double steadyRate = rate > 0.0 ? rate : ( run->act->host.rate > 0.0 ? run->act->host.rate : 60.0 );
		double before = i > 0 ? run->times[i - 1] : 0.0;
		run->times[i] = steady || rate > 0.0 ? i / steadyRate : before + run->steps[i];
		soleGetSceneMoment( run->act, &stage, run->take, run->times[i], moment );
		testMakePose( run->actor, moment, run->times[i], run->input + (size_t)i * (size_t)run->jointCount );
		run->roots[i] = moment->root;
		run->roots[i].translation = soleTransformPoint( moment->root, moment->base );
	}
}

static void* testAlloc( int32_t count, size_t size )
{
	void* memory = calloc( (size_t)count, size );
	assert_non_null( memory );
	return memory;
}

void testPlay(
    const testActor* actor, const testWorld* world, const soleAct* act, int32_t take, double rate, testRun* run )
{
	const toolCharacter* character = &actor->character;
	int32_t frames = testCountFrames( act, rate );
	*run =
	    ( testRun ){ .actor = actor, .world = world, .act = act, .take = take, .frameCount = frames, .finite = true };
	run->jointCount = character->jointCount;
	run->legCount = character->rigDef.legCount;
	run->times = testAlloc( frames, sizeof *run->times );
	run->steps = testAlloc( frames, sizeof *run->steps );
	run->moments = testAlloc( frames, sizeof *run->moments );
	run->roots = testAlloc( frames, sizeof *run->roots );
	run->rigs = testAlloc( frames, sizeof *run->rigs );
	run->input = testAlloc( frames * run->jointCount, sizeof *run->input );
	run->output = testAlloc( frames * run->jointCount, sizeof *run->output );
	run->flags = testAlloc( frames * run->legCount, sizeof *run->flags );
	run->errors = testAlloc( frames * run->legCount, sizeof *run->errors );
	testMakeInput( run, rate );
	testPutOnShoes( run );
	testHost* host = testStartHost( run );
	for ( int32_t i = 0; i < frames; ++i )
	{
		soleOutput out;
		soleTransform* pose = run->output + (size_t)i * (size_t)run->jointCount;
		testStep( run, host, i, pose, &out );
		run->finite = run->finite && testIsPoseFinite( pose, run->jointCount );
		for ( int32_t leg = 0; leg < run->legCount; ++leg )
		{
			run->flags[i * run->legCount + leg] = out.legs[leg].flags;
			run->errors[i * run->legCount + leg] = out.legs[leg].error;
			run->finite =
			    run->finite && soleIsFinite( out.legs[leg].error ) && soleVec3_IsFinite( out.legs[leg].ankle_w );
		}
	}
	free( host );
}

void testFreeRun( testRun* run )
{
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		bool last = i + 1 == run->frameCount || run->rigs[i + 1] != run->rigs[i];
		soleDestroyRig( last && run->rigs[i] != run->actor->character.rig ? run->rigs[i] : NULL );
	}
	free( run->rigs );
	free( run->times );
	free( run->steps );
	free( run->moments );
	free( run->roots );
	free( run->input );
	free( run->output );
	free( run->flags );
	free( run->errors );
	*run = ( testRun ){ 0 };
}

static bool testIsPoseKept( const testRun* run, int32_t index, const soleTransform* pose )
{
	const soleTransform* kept = run->output + (size_t)index * (size_t)run->jointCount;
	return memcmp( kept, pose, (size_t)run->jointCount * sizeof *pose ) == 0;
}

bool testPlaysTheSame( const testRun* run )
{
	testHost* host = testStartHost( run );
	testHost* saved = testStartHost( run );
	soleTransform* pose = testAlloc( run->jointCount, sizeof *pose );
	soleOutput out;
	int32_t half = run->frameCount / 2;
	bool same = true;
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		if ( i == half )
		{
			// Saved, gone astray for a second, and rolled back.
			*saved = *host;
			for ( int32_t k = 0; k < 60 && k < run->frameCount; ++k )
			{
				testStep( run, host, run->frameCount - 1 - k, pose, &out );
			}
			*host = *saved;
		}
		testStep( run, host, i, pose, &out );
		same = same && testIsPoseKept( run, i, pose );
	}
	free( pose );
	free( saved );
	free( host );
	return same;
}
