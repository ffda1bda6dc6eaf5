// SPDX-License-Identifier: MIT
// Bakes in memory: the walker moves the root, the clip gives the pose, a method places the feet. Poses are
// parent-local, roots take character space to the world of the ground.
#include "bake.h"

#include "method_ancestors.h"
#include "steps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_TRANSFORMS 12000000 // of a take, 480 MB before and as much after

// -------------------------------------------------------------------------------------------------------- methods

// What method "sole" keeps for one character.
typedef struct toolSoleMemory
{
	soleState state;
	soleOutput output;
	soleProbe probes[SOLE_MAX_PROBES];
	soleHit hits[SOLE_MAX_PROBES];
} toolSoleMemory;

static void* toolStartSole( const toolCharacter* character )
{
	toolSoleMemory* memory = toolAlloc( 1, sizeof *memory );
	memory->state = soleDefaultState( character->rig );
	return memory;
}

static void toolStepSole( void* user, const toolMethodStep* step )
{
	toolSoleMemory* memory = user;
	const soleRig* rig = step->character->rig;
	int32_t count =
	    soleGatherProbes( rig, step->settings, &memory->state, step->frame, memory->probes, SOLE_MAX_PROBES );
	soleCastProbes( step->ground, memory->probes, count, memory->hits );
	soleTracer_BeginFrame( step->tracer, step->settings, &memory->state, step->frame, memory->hits, count );
	soleSolve( rig, step->settings, &memory->state, step->frame, memory->hits, count, &memory->output );
	soleTracer_EndFrame( step->tracer, &memory->state, &memory->output );
	soleApply( rig, &memory->output, step->pose );
	for ( int32_t i = 0; i < memory->output.legCount; ++i )
	{
		step->flags[i] = memory->output.legs[i].flags;
		step->plantWeights[i] = memory->output.legs[i].plantWeight;
		step->shortfalls[i] = memory->output.legs[i].error;
	}
	*step->pelvisOffset = memory->output.pelvisOffset_w;
}

static const toolMethod toolMethods[] = {
	{ "sole", "Sole", toolStartSole, toolStepSole },
	{ "none", "moved over the ground, feet untouched", NULL, NULL },
	{ "homebrew", "a sphere under each ankle, feet and ground normals filtered, the body down to the lower foot",
	    toolStartHomebrew, toolStepAncestor },
	{ "iksetting", "a ray under each foot 50 times a second, the ground's height added to the clip by its curves",
	    toolStartIkSetting, toolStepAncestor },
	{ "ozz", "a ray under each ankle, the pelvis down to the lowest foot, legs bent and ankles aimed at once",
	    toolStartOzz, toolStepAncestor },
	{ "effector", "a trace under each foot while the character stands, hip and feet brought to their heights",
	    toolStartEffector, toolStepAncestor },
	{ NULL, NULL, NULL, NULL },
};

const toolMethod* toolGetMethods( void )
{
	return toolMethods;
}

const toolMethod* toolFindMethod( const char* name )
{
	for ( const toolMethod* method = toolMethods; method->name != NULL; ++method )
	{
		if ( strcmp( method->name, name ) == 0 )
		{
			return method;
		}
	}
	return NULL;
}

// ----------------------------------------------------------------------------------------------------------- bake

toolBakeDef toolDefaultBakeDef( void )
{
	toolWalkDef walk = toolDefaultWalkDef();
	return ( toolBakeDef ){ .method = toolMethods, .groundName = walk.groundName, .fps = walk.fps };
}

static void toolAllocTake( toolBakeResult* result )
{
	size_t frames = (size_t)result->walk.frameCount;
	result->input = toolAlloc( frames * (size_t)result->jointCount, sizeof *result->input );
	result->output = toolAlloc( frames * (size_t)result->jointCount, sizeof *result->output );
	result->flags = toolAlloc( frames * (size_t)result->legCount, sizeof *result->flags );
	result->plantWeights = toolAlloc( frames * (size_t)result->legCount, sizeof *result->plantWeights );
	result->pelvis = toolAlloc( frames, sizeof *result->pelvis );
	result->shortfalls = toolAlloc( frames * (size_t)result->legCount, sizeof *result->shortfalls );
	for ( size_t i = 0; i < frames * (size_t)result->legCount; ++i )
	{
		result->shortfalls[i] = NAN;
	}
}

static void toolStepFrame( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const toolSteps* steps, const soleGround* ground, const toolBakeDef* def, void* memory, int32_t frameIndex,
    toolBakeResult* result )
{
	soleContactInput contacts[SOLE_MAX_LEGS];
	soleStepInput inputs[SOLE_MAX_LEGS];
	toolReadSteps( character, bound, travel, steps, &result->walk, frameIndex, contacts, inputs );
	size_t joints = (size_t)result->jointCount;
	size_t legs = (size_t)result->legCount;
	size_t i = (size_t)frameIndex;
	soleFrame frame = {
		.pose = result->input + i * joints,
		.root = result->walk.roots[i],
		.up = soleVec( 0.0f, 1.0f, 0.0f ),
		.timeStep = i > 0 ? (float)( 1.0 / result->walk.fps ) : 0.0f,
		.weight = 1.0f,
		.contact = contacts,
		.steps = inputs,
		.clipFloor = result->clipFloor,
		.teleport = result->walk.jumps[i],
	};
	toolMethodStep step = {
		.character = character,
		.ground = ground,
		.settings = def->settings,
		.frame = &frame,
		.tracer = def->tracer,
		.pose = result->output + i * joints,
		.flags = result->flags + i * legs,
		.plantWeights = result->plantWeights + i * legs,
		.shortfalls = result->shortfalls + i * legs,
		.pelvisOffset = result->pelvis + i,
	};
	memcpy( step.pose, frame.pose, joints * sizeof *step.pose );
	if ( def->method->step != NULL )
	{
		def->method->step( memory, &step );
	}
}

static bool toolMakeTakeWalk( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const soleGround* ground, const toolBakeDef* def, toolWalk* walk, toolError* error )
{
	toolWalkDef walkDef = toolDefaultWalkDef();
	walkDef.character = character;
	walkDef.bound = bound;
	walkDef.travel = travel;
	walkDef.ground = ground;
	walkDef.groundName = def->groundName;
	walkDef.path = def->path;
	walkDef.pathCount = def->pathCount;
	walkDef.heading = def->heading;
	walkDef.distance = def->distance;
	walkDef.speed = def->speed;
	walkDef.duration = def->duration;
	walkDef.fps = def->fps;
	return toolMakeWalk( &walkDef, walk, error );
}

bool toolBake( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const soleGround* ground, const toolBakeDef* def, toolBakeResult* result, toolError* error )
{
	*result = ( toolBakeResult ){
		.jointCount = character->jointCount,
		.legCount = character->rigDef.legCount,
		.clipFloor = travel->clipFloor,
	};
	soleSettings settings = soleDefaultSettings();
	toolBakeDef complete = *def;
	complete.settings = def->settings != NULL ? def->settings : &settings;
	if ( toolMakeTakeWalk( character, bound, travel, ground, def, &result->walk, error ) == false )
	{
		return false;
	}
	if ( result->walk.frameCount > MOST_TRANSFORMS / result->jointCount )
	{
		toolFail( error,
		    "%s: %d frames of %d nodes over it are too many to hold: bake a shorter way or at a lower rate",
		    def->groundName, result->walk.frameCount, result->jointCount );
		toolFreeBakeResult( result );
		return false;
	}
	toolAllocTake( result );
	toolSteps steps;
	toolFindSteps( character, bound, travel, &steps );
	void* memory = def->method->init != NULL ? def->method->init( character ) : NULL;
	for ( int32_t i = 0; i < result->walk.frameCount; ++i )
	{
		soleTransform own; // is in the walk's roots
		soleTransform* pose = result->input + (size_t)i * (size_t)result->jointCount;
		toolSampleLooped( character, bound, travel, result->walk.clipTimes[i], pose, &own );
		toolStepFrame( character, bound, travel, &steps, ground, &complete, memory, i, result );
	}
	free( memory );
	toolFreeSteps( &steps );
	return true;
}

void toolFreeBakeResult( toolBakeResult* result )
{
	toolFreeWalk( &result->walk );
	free( result->input );
	free( result->output );
	free( result->flags );
	free( result->plantWeights );
	free( result->shortfalls );
	free( result->pelvis );
	*result = ( toolBakeResult ){ 0 };
}
