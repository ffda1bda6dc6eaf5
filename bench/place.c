// SPDX-License-Identifier: MIT
// A frame of one biped, and of many, by the calls for one character. The mannequin walks on through a circle of poses;
// the ground answers with hits taken beforehand, or is a terrain of 100,000 triangles. Beside Sole the systems that it
// is compared with. How a solve divides into stages, bench.sh counts by their names.
#include "walkers.h"

#include <stdlib.h>

#define FRAME_COUNT 256 // of a walk whose hits are taken beforehand
#define GROUND_SIZE 100000

/// What is timed of a frame.
typedef enum benchPart
{
	bench_gather,
	bench_solve,
	bench_apply,
	bench_whole
} benchPart;

typedef struct benchPlacing
{
	const benchMethod* method;
	benchPart part;
	int32_t characterCount;
} benchPlacing;

// ------------------------------------------------------------------------------------------------------ one, by part

/// A walk of one character with all that each part of each frame takes in.
typedef struct benchTape
{
	benchPlacing placing;
	const benchWalk* walk;
	benchWalker* walkers; // as they are before each frame's solve
	char* states;         // of them
	size_t stateSize;     // of each
	soleTransform* pose;
} benchTape;

static void* benchOpenTape( const void* argument )
{
	benchTape* tape = benchAlloc( 1, sizeof *tape );
	tape->placing = *(const benchPlacing*)argument;
	tape->walk = benchGetWalk();
	tape->walkers = benchAlloc( FRAME_COUNT, sizeof *tape->walkers );
	tape->pose = benchAlloc( (size_t)tape->walk->character.jointCount, sizeof *tape->pose );
	const benchMethod* method = tape->placing.method;
	soleGround* ground = benchMakeWalkGround( 10000 );
	benchWalker* walker = benchAlloc( 1, sizeof *walker );
	tape->stateSize = method->stateSize > 0 ? method->stateSize : soleState_GetByteCount( tape->walk->character.rig );
	tape->states = benchAlloc( FRAME_COUNT, tape->stateSize );
	benchStartWalker( tape->walk, method, soleVec( 4.0f, 0.0f, 4.0f ), 0, walker );
	for ( int32_t i = 0; i < FRAME_COUNT; ++i )
	{
		benchStepWalker( tape->walk, ground, walker );
		walker->probeCount = method->gather( walker );
		soleCastProbes( ground, walker->probes, walker->probeCount, walker->hits );
		tape->walkers[i] = *walker;
		memcpy( tape->states + (size_t)i * tape->stateSize, (char*)walker + method->stateOffset, tape->stateSize );
		method->solve( walker );
		tape->walkers[i].output = walker->output;
	}
	free( walker );
	soleDestroyGround( ground );
	return tape;
}

static void benchRunTape( void* context )
{
	benchTape* tape = context;
	const benchMethod* method = tape->placing.method;
	for ( int32_t i = 0; i < FRAME_COUNT; ++i )
	{
		benchWalker* walker = tape->walkers + i;
		switch ( tape->placing.part )
		{
		case bench_gather:
			method->gather( walker );
			break;
		case bench_solve:
			// From where each frame began: one that is solved again has no news, and chooses no foothold. The copy
			// takes a few nanoseconds.
			memcpy( (char*)walker + method->stateOffset, tape->states + (size_t)i * tape->stateSize, tape->stateSize );
			method->solve( walker );
			break;
		default:
			soleApply( walker->rig, &walker->output, tape->pose );
			break;
		}
	}
}

static void benchCloseTape( void* context )
{
	benchTape* tape = context;
	free( tape->walkers );
	free( tape->states );
	free( tape->pose );
	free( tape );
}

// ----------------------------------------------------------------------------------------------------------- crowds

/// Characters on one ground, each with its own place in the walk.
typedef struct benchCrowd
{
	benchPlacing placing;
	const benchWalk* walk;
	soleGround* ground;
	benchWalker walker; // those of the one that is at work
	char* states;
	size_t stateSize;
	int32_t frame;
	soleTransform* pose;
} benchCrowd;

static void* benchOpenCrowd( const void* argument )
{
	benchCrowd* crowd = benchAlloc( 1, sizeof *crowd );
	crowd->placing = *(const benchPlacing*)argument;
	crowd->walk = benchGetWalk();
	crowd->ground = benchMakeWalkGround( GROUND_SIZE );
	crowd->pose = benchAlloc( (size_t)crowd->walk->character.jointCount, sizeof *crowd->pose );
	size_t count = (size_t)crowd->placing.characterCount;
	crowd->stateSize = ( soleState_GetByteCount( crowd->walk->character.rig ) + 15 ) / 16 * 16;
	crowd->states = benchAlloc( count + 8, crowd->stateSize ); // the last may be copied as a whole
	soleState state = soleDefaultState( crowd->walk->character.rig );
	for ( size_t i = 0; i < count; ++i )
	{
		memcpy( crowd->states + i * crowd->stateSize, &state, crowd->stateSize );
	}
	benchStartWalker( crowd->walk, crowd->placing.method, benchGetStart( 0 ), 0, &crowd->walker );
	return crowd;
}

static void benchRunCrowd( void* context )
{
	benchCrowd* crowd = context;
	benchWalker* walker = &crowd->walker;
	for ( int32_t i = 0; i < crowd->placing.characterCount; ++i )
	{
		char* kept = crowd->states + (size_t)i * crowd->stateSize;
		memcpy( &walker->sole.state, kept, crowd->stateSize );
		benchPlaceWalker( crowd->walk, crowd->ground, benchGetStart( i ), i + crowd->frame, walker );
		walker->probeCount = crowd->placing.method->gather( walker );
		soleCastProbes( crowd->ground, walker->probes, walker->probeCount, walker->hits );
		crowd->placing.method->solve( walker );
		soleApply( walker->rig, &walker->output, crowd->pose );
		memcpy( kept, &walker->sole.state, crowd->stateSize );
	}
	crowd->frame += 1;
}

static void benchCloseCrowd( void* context )
{
	benchCrowd* crowd = context;
	soleDestroyGround( crowd->ground );
	free( crowd->pose );
	free( crowd->states );
	free( crowd );
}

// ----------------------------------------------------------------------------------------------------------- adding

static void* benchOpenStateSize( const void* argument )
{
	(void)argument;
	double* bytes = benchAlloc( 1, sizeof *bytes );
	*bytes = (double)soleState_GetByteCount( benchGetWalk()->character.rig );
	return bytes;
}

static const benchPlacing* benchKeepPlacing( const benchMethod* method, benchPart part, int32_t characterCount )
{
	benchPlacing* kept = benchAlloc( 1, sizeof *kept ); // as long as the list
	*kept = ( benchPlacing ){ method, part, characterCount };
	return kept;
}

void benchAddPlace( benchList* list, int64_t largest )
{
	static const char* const parts[3] = { "biped-gather", "biped-solve", "biped-apply" };
	for ( int32_t part = 0; part < 3; ++part )
	{
		for ( int32_t i = 0; i < ( part == bench_apply ? 1 : benchMethodCount ); ++i )
		{
			benchAdd( list,
			    ( benchCase ){
			        .name = parts[part],
			        .variant = benchMethods[i].name,
			        .unit = "character",
			        .itemCount = FRAME_COUNT,
			        .counted = i == 0,
			        .open = benchOpenTape,
			        .argument = benchKeepPlacing( benchMethods + i, (benchPart)part, 1 ),
			        .run = benchRunTape,
			        .close = benchCloseTape,
			    } );
		}
	}
	for ( int32_t count = 1; count <= 100000 && count <= largest; count *= count == 1 ? 100 : 10 )
	{
		benchAdd( list,
		    ( benchCase ){
		        .name = benchName( "crowd", count ),
		        .variant = "sole-calls",
		        .unit = "character",
		        .itemCount = count,
		        .open = benchOpenCrowd,
		        .argument = benchKeepPlacing( benchMethods, bench_whole, count ),
		        .run = benchRunCrowd,
		        .close = benchCloseCrowd,
		    } );
	}
	benchAdd( list,
	    ( benchCase ){
	        .name = "memory-biped",
	        .variant = "sole",
	        .unit = "bytes/character",
	        .itemCount = 1,
	        .open = benchOpenStateSize,
	        .close = free,
	    } );
}
