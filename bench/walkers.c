// SPDX-License-Identifier: MIT
// The mannequin's walk, sampled once, and the calls of each method behind one shape.
#include "walkers.h"

#include "mannequin.h"
#include "terrain.h"

#include <stdio.h>
#include <stdlib.h>

#define CROWD_SPACING 1.3f
#define WALK_LENGTH 600 // frames, then the walker is back at its start

static void benchFail( const char* what )
{
	fprintf( stderr, "sole_bench: %s\n", what );
	exit( 1 );
}

const benchWalk* benchGetWalk( void )
{
	static benchWalk walk;
	if ( walk.poses != NULL )
	{
		return &walk;
	}
	toolError error;
	toolMakeMannequin( &walk.model );
	if ( !toolMakeCharacter( &walk.model, "mannequin", 1.0f, &walk.character, &error ) ||
	    !toolBindClip( &walk.character, &walk.model, toolFindClip( &walk.model, "walk" ), &walk.clip, &error ) )
	{
		benchFail( "the mannequin cannot be made to walk" );
	}
	walk.travel = toolFindTravel( &walk.character, &walk.clip );
	size_t jointCount = (size_t)walk.character.jointCount;
	walk.poses = benchAlloc( BENCH_POSE_COUNT * jointCount, sizeof *walk.poses );
	for ( int32_t i = 0; i < BENCH_POSE_COUNT; ++i )
	{
		soleTransform root;
		double time = (double)walk.clip.duration * i / BENCH_POSE_COUNT;
		toolSampleLooped( &walk.character, &walk.clip, &walk.travel, time, walk.poses + (size_t)i * jointCount, &root );
	}
	return &walk;
}

soleVec3 benchGetStart( int32_t character )
{
	float across = (float)( character % 40 );
	float along = (float)( character / 40 % 20 );
	return soleVec( 2.0f + CROWD_SPACING * across, 0.0f, 2.0f + CROWD_SPACING * along );
}

soleGround* benchMakeWalkGround( int64_t triangleCount )
{
	soleGroundPlane plane = soleDefaultGroundPlane();
	soleGroundDef def = soleDefaultGroundDef();
	benchMesh mesh = { 0 };
	soleGroundMesh groundMesh;
	if ( triangleCount > 0 )
	{
		mesh = benchMakeTerrain( triangleCount );
		groundMesh = benchDescribeMesh( &mesh );
		def.meshes = &groundMesh;
		def.meshCount = 1;
	}
	else
	{
		def.planes = &plane;
		def.planeCount = 1;
	}
	soleGround* ground = NULL;
	soleCreateGround( &def, NULL, &ground, NULL );
	benchFreeMesh( &mesh );
	if ( ground == NULL )
	{
		benchFail( "the ground cannot be made" );
	}
	return ground;
}

void benchPlaceWalker(
    const benchWalk* walk, const soleGround* ground, soleVec3 start, int32_t frameNumber, benchWalker* walker )
{
	// A pose of every frame: the speed is the clip's own at this step.
	float step = walk->clip.duration / (float)BENCH_POSE_COUNT;
	soleVec3 place = soleMulAdd( start, step * (float)( frameNumber % WALK_LENGTH ), walk->travel.strideVelocity );
	soleProbe probe = { .start_w = { place.x, 10.0f, place.z },
		.direction_w = { 0.0f, -1.0f, 0.0f },
		.length = 20.0f,
		.mask = 0xffffffffu };
	soleHit hit = soleCastProbe( ground, &probe );
	place.y = hit.hit ? hit.point_w.y : 0.0f;
	size_t pose = (size_t)( frameNumber % BENCH_POSE_COUNT ) * (size_t)walk->character.jointCount;
	walker->frame.pose = walk->poses + pose;
	walker->frame.root.translation = place;
	walker->frame.timeStep = step;
	walker->frame.teleport = frameNumber % WALK_LENGTH == 0;
}

void benchStartWalker(
    const benchWalk* walk, const benchMethod* method, soleVec3 start, int32_t frameNumber, benchWalker* walker )
{
	memset( walker, 0, sizeof *walker );
	walker->rig = walk->character.rig;
	walker->frame.root = soleTransform_Identity();
	walker->frame.up = soleVec( 0.0f, 1.0f, 0.0f );
	walker->frame.weight = 1.0f;
	walker->frame.clipFloor = walk->travel.clipFloor;
	walker->start = start;
	walker->frameNumber = frameNumber;
	method->start( walk, walker );
}

void benchStepWalker( const benchWalk* walk, const soleGround* ground, benchWalker* walker )
{
	walker->frameNumber += 1;
	benchPlaceWalker( walk, ground, walker->start, walker->frameNumber, walker );
}

// --------------------------------------------------------------------------------------------------------- methods

static void benchStartSole( const benchWalk* walk, benchWalker* walker )
{
	walker->sole.settings = soleDefaultSettings();
	walker->sole.state = soleDefaultState( walk->character.rig );
}

static int32_t benchGatherSole( benchWalker* w )
{
	return soleGatherProbes( w->rig, &w->sole.settings, &w->sole.state, &w->frame, w->probes, BENCH_MOST_PROBES );
}

static void benchSolveSole( benchWalker* w )
{
	soleSolve( w->rig, &w->sole.settings, &w->sole.state, &w->frame, w->hits, w->probeCount, &w->output );
}

static void benchStartOzz( const benchWalk* walk, benchWalker* walker )
{
	walker->ozz.settings = soleDefaultOzzSettings();
	soleFitOzzSettings( walk->character.rig, walk->character.bindPose, &walker->ozz.settings );
	walker->ozz.state = soleDefaultOzzState( walk->character.rig );
}

static int32_t benchGatherOzz( benchWalker* w )
{
	return soleGatherOzz( w->rig, &w->ozz.settings, &w->ozz.state, &w->frame, w->probes, BENCH_MOST_PROBES );
}

static void benchSolveOzz( benchWalker* w )
{
	soleSolveOzz( w->rig, &w->ozz.settings, &w->ozz.state, &w->frame, w->hits, w->probeCount, &w->output );
}

static void benchStartHomebrew( const benchWalk* walk, benchWalker* walker )
{
	walker->homebrew.settings = soleDefaultHomebrewSettings();
	soleFitHomebrewSettings( walk->character.rig, &walker->homebrew.settings );
	walker->homebrew.state = soleDefaultHomebrewState( walk->character.rig );
}

static int32_t benchGatherHomebrew( benchWalker* w )
{
	return soleGatherHomebrew(
	    w->rig, &w->homebrew.settings, &w->homebrew.state, &w->frame, w->probes, BENCH_MOST_PROBES );
}

static void benchSolveHomebrew( benchWalker* w )
{
	soleSolveHomebrew(
	    w->rig, &w->homebrew.settings, &w->homebrew.state, &w->frame, w->hits, w->probeCount, &w->output );
}

static void benchStartIkSetting( const benchWalk* walk, benchWalker* walker )
{
	walker->ikSetting.settings = soleDefaultIkSettingSettings();
	soleFitIkSettingSettings( walk->character.rig, &walker->ikSetting.settings );
	walker->ikSetting.state = soleDefaultIkSettingState( walk->character.rig );
}

static int32_t benchGatherIkSetting( benchWalker* w )
{
	return soleGatherIkSetting(
	    w->rig, &w->ikSetting.settings, &w->ikSetting.state, &w->frame, w->probes, BENCH_MOST_PROBES );
}

static void benchSolveIkSetting( benchWalker* w )
{
	soleIkSettingCurves none = { NULL, 0 };
	soleSolveIkSetting(
	    w->rig, &w->ikSetting.settings, &w->ikSetting.state, &w->frame, &none, w->hits, w->probeCount, &w->output );
}

static void benchStartEffector( const benchWalk* walk, benchWalker* walker )
{
	walker->effector.settings = soleDefaultEffectorSettings();
	soleFitEffectorSettings( walk->character.rig, &walker->effector.settings );
	walker->effector.state = soleDefaultEffectorState( walk->character.rig );
}

static int32_t benchGatherEffector( benchWalker* w )
{
	return soleGatherEffector(
	    w->rig, &w->effector.settings, &w->effector.state, &w->frame, w->probes, BENCH_MOST_PROBES );
}

static void benchSolveEffector( benchWalker* w )
{
	soleEffectorOutput effectors;
	soleSolveEffector(
	    w->rig, &w->effector.settings, &w->effector.state, &w->frame, w->hits, w->probeCount, &effectors, &w->output );
}

const benchMethod benchMethods[] = {
	{ "sole", offsetof( benchWalker, sole.state ), 0, benchStartSole, benchGatherSole, benchSolveSole },
	{ "ozz", offsetof( benchWalker, ozz.state ), sizeof( soleOzzState ), benchStartOzz, benchGatherOzz, benchSolveOzz },
	{ "homebrew", offsetof( benchWalker, homebrew.state ), sizeof( soleHomebrewState ), benchStartHomebrew,
	    benchGatherHomebrew, benchSolveHomebrew },
	{ "iksetting", offsetof( benchWalker, ikSetting.state ), sizeof( soleIkSettingState ), benchStartIkSetting,
	    benchGatherIkSetting, benchSolveIkSetting },
	{ "effector", offsetof( benchWalker, effector.state ), sizeof( soleEffectorState ), benchStartEffector,
	    benchGatherEffector, benchSolveEffector },
};
const int32_t benchMethodCount = sizeof benchMethods / sizeof *benchMethods;
