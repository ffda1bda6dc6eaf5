// SPDX-License-Identifier: MIT
// A frame of a crowd by the calls of crowd.h: every character's root put on the ground, probes gathered, cast into
// 100,000 triangles and the feet placed, a range of characters after the other as a host's jobs would. Each level of
// detail, every frame and every fourth, by one thread and by two. Both take ranges from one counter until none is left.
// And one crowd over grounds from a plane to a million triangles.
#include "walkers.h"

#include "sole/crowd.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <threads.h>

#define GROUND_SIZE 100000
#define RANGE 64 // characters of a job
#define WARM_FRAMES 4
#define COUNTED_CHARACTERS 100
#define GROUNDS_CHARACTERS 1000 // over each kind of ground
#define SPIN_STEPS 4000000      // takes as long as a few thousand characters

static const char* const benchThreadNames[] = { "1-thread", "2-threads" };

typedef struct benchHerd benchHerd;

typedef struct benchHerdKind
{
	soleDetail detail;
	int32_t interval;
	int32_t count;
	int64_t groundSize; // triangles. 0: a plane
	// One crowd for all that time it: two of 100,000 at a time would be too much.
	benchHerd* herd;
	int32_t userCount;
} benchHerdKind;

typedef struct benchHerdAsked
{
	benchHerdKind* kind;
	int32_t threadCount;
} benchHerdAsked;

/// What one thread needs for one range.
typedef struct benchRoom
{
	benchHerd* herd;
	benchWalker walker;
	soleFrame frames[RANGE];
	soleCrowdAsk asks[RANGE];
	soleProbe* probes;
	soleHit* hits;
	void* work;
} benchRoom;

struct benchHerd
{
	const benchWalk* walk;
	soleGround* ground;
	soleCrowd* crowd;
	int32_t count;
	int32_t probeCapacity; // of a range
	int32_t frame;
	_Atomic int32_t next; // character that nobody has taken yet
	benchRoom* rooms[2];
};

typedef struct benchHerdRun
{
	benchHerdAsked asked;
	benchHerd* herd;
} benchHerdRun;

// ------------------------------------------------------------------------------------------------------------- frame

static void benchWalkRange( benchRoom* room, int32_t first, int32_t count )
{
	benchHerd* herd = room->herd;
	for ( int32_t i = 0; i < count; ++i )
	{
		int32_t number = first + i + herd->frame;
		benchPlaceWalker( herd->walk, herd->ground, benchGetStart( first + i ), number, &room->walker );
		room->frames[i] = room->walker.frame;
	}
	int32_t asked = soleGatherCrowd(
	    herd->crowd, first, count, room->frames, room->probes, herd->probeCapacity, room->asks, room->work );
	soleCastProbes( herd->ground, room->probes, asked, room->hits );
	soleSolveCrowd( herd->crowd, first, count, room->frames, room->probes, room->hits, room->asks, room->work );
}

static int benchWalkRanges( void* context )
{
	benchRoom* room = context;
	for ( ;; )
	{
		int32_t first = atomic_fetch_add( &room->herd->next, RANGE );
		int32_t left = room->herd->count - first;
		if ( left <= 0 )
		{
			return 0;
		}
		benchWalkRange( room, first, left < RANGE ? left : RANGE );
	}
}

/// Does a job with each of two things to work on, one after the other or by two threads at once.
static void benchDoBoth( thrd_start_t job, void* first, void* second, int32_t threadCount )
{
	thrd_t helper;
	bool helped = threadCount == 2 && thrd_create( &helper, job, second ) == thrd_success;
	job( first );
	if ( helped )
	{
		thrd_join( helper, NULL );
	}
	else
	{
		job( second );
	}
}

static void benchWalkHerd( benchHerd* herd, int32_t threadCount )
{
	atomic_store( &herd->next, 0 );
	benchDoBoth( benchWalkRanges, herd->rooms[0], herd->rooms[1], threadCount );
	herd->frame += 1;
}

static void benchRunHerd( void* context )
{
	benchHerdRun* run = context;
	benchWalkHerd( run->herd, run->asked.threadCount );
}

// ----------------------------------------------------------------------------------------------------- open and close

static soleCrowd* benchMakeCrowd( const benchWalk* walk, int32_t count )
{
	soleCrowdDef def = soleDefaultCrowdDef();
	def.rig = walk->character.rig;
	def.capacity = count;
	soleCrowd* crowd = NULL;
	if ( soleCreateCrowd( &def, NULL, &crowd, NULL ) != sole_success )
	{
		fprintf( stderr, "sole_bench: a crowd of %d cannot be made: use a smaller --largest\n", (int)count );
		exit( 1 );
	}
	return crowd;
}

static benchRoom* benchMakeRoom( benchHerd* herd )
{
	benchRoom* room = benchAlloc( 1, sizeof *room );
	room->herd = herd;
	room->probes = benchAlloc( (size_t)herd->probeCapacity, sizeof *room->probes );
	room->hits = benchAlloc( (size_t)herd->probeCapacity, sizeof *room->hits );
	room->work = benchAlloc( 1, soleCrowd_GetWorkSize( herd->crowd, RANGE ) );
	benchStartWalker( herd->walk, benchMethods, benchGetStart( 0 ), 0, &room->walker );
	return room;
}

static benchHerd* benchMakeHerd( const benchHerdKind* kind )
{
	benchHerd* herd = benchAlloc( 1, sizeof *herd );
	herd->walk = benchGetWalk();
	herd->ground = benchMakeWalkGround( kind->groundSize );
	herd->crowd = benchMakeCrowd( herd->walk, kind->count );
	herd->count = kind->count;
	for ( int32_t i = 0; i < kind->count; ++i )
	{
		soleAddToCrowd( herd->crowd );
		soleCrowdMember* member = soleCrowd_GetMember( herd->crowd, i );
		member->detail = kind->detail;
		member->interval = kind->interval;
	}
	herd->probeCapacity = RANGE * soleCrowd_GetMostProbes( herd->crowd );
	for ( int32_t i = 0; i < 2; ++i )
	{
		herd->rooms[i] = benchMakeRoom( herd );
	}
	for ( int32_t i = 0; i < WARM_FRAMES; ++i )
	{
		benchWalkHerd( herd, 1 );
	}
	return herd;
}

static void benchFreeHerd( benchHerd* herd )
{
	for ( int32_t i = 0; i < 2; ++i )
	{
		free( herd->rooms[i]->probes );
		free( herd->rooms[i]->hits );
		free( herd->rooms[i]->work );
		free( herd->rooms[i] );
	}
	soleDestroyCrowd( herd->crowd );
	soleDestroyGround( herd->ground );
	free( herd );
}

static void* benchOpenHerd( const void* argument )
{
	benchHerdRun* run = benchAlloc( 1, sizeof *run );
	run->asked = *(const benchHerdAsked*)argument;
	benchHerdKind* kind = run->asked.kind;
	if ( kind->userCount == 0 )
	{
		kind->herd = benchMakeHerd( kind );
	}
	kind->userCount += 1;
	run->herd = kind->herd;
	return run;
}

static void benchCloseHerd( void* context )
{
	benchHerdRun* run = context;
	benchHerdKind* kind = run->asked.kind;
	kind->userCount -= 1;
	if ( kind->userCount == 0 )
	{
		benchFreeHerd( kind->herd );
	}
	free( run );
}

/// Bytes of a character of a crowd, all in all but its rig and settings.
static void* benchOpenCrowdSize( const void* argument )
{
	(void)argument;
	double* bytes = benchAlloc( 1, sizeof *bytes );
	soleCrowd* crowd = benchMakeCrowd( benchGetWalk(), COUNTED_CHARACTERS );
	*bytes = (double)soleCrowd_GetByteCount( crowd ) / COUNTED_CHARACTERS;
	soleDestroyCrowd( crowd );
	return bytes;
}

// --------------------------------------------------------------------------------------- what two threads can be

typedef struct benchSpin
{
	int32_t threadCount;
	uint32_t seeds[2];
} benchSpin;

/// Arithmetic that shares nothing and waits for nothing but itself.
static int benchSpinOnce( void* context )
{
	uint32_t x = *(uint32_t*)context;
	for ( int32_t i = 0; i < SPIN_STEPS; ++i )
	{
		x = x * 1664525u + 1013904223u;
	}
	*(uint32_t*)context = x;
	return 0;
}

static void* benchOpenSpin( const void* argument )
{
	benchSpin* spin = benchAlloc( 1, sizeof *spin );
	spin->threadCount = *(const int32_t*)argument;
	return spin;
}

static void benchRunSpin( void* context )
{
	benchSpin* spin = context;
	benchDoBoth( benchSpinOnce, &spin->seeds[0], &spin->seeds[1], spin->threadCount );
}

/// What the machine has for two threads while others are at work on it: no crowd can do better.
static void benchAddSpin( benchList* list )
{
	static const int32_t threadCounts[] = { 1, 2 };
	for ( int32_t i = 0; i < 2; ++i )
	{
		benchAdd( list,
		    ( benchCase ){
		        .name = "spin",
		        .variant = benchThreadNames[i],
		        .unit = "step",
		        .itemCount = (int64_t)2 * SPIN_STEPS,
		        .open = benchOpenSpin,
		        .argument = threadCounts + i,
		        .run = benchRunSpin,
		        .close = free,
		    } );
	}
}

// ------------------------------------------------------------------------------------------------------------ adding

static void benchAddHerd( benchList* list, const char* name, benchHerdKind kind )
{
	benchHerdKind* kept = benchAlloc( 1, sizeof *kept ); // as long as the list
	*kept = kind;
	// One range is nothing to share.
	for ( int32_t i = 0; i < ( kind.count > RANGE ? 2 : 1 ); ++i )
	{
		benchHerdAsked* asked = benchAlloc( 1, sizeof *asked );
		*asked = ( benchHerdAsked ){ kept, i + 1 };
		benchAdd( list,
		    ( benchCase ){
		        .name = name,
		        .variant = benchThreadNames[i],
		        .unit = "character",
		        .itemCount = kind.count,
		        .counted = i == 0 && kind.interval == 1 && kind.count == COUNTED_CHARACTERS,
		        .open = benchOpenHerd,
		        .argument = asked,
		        .run = benchRunHerd,
		        .close = benchCloseHerd,
		    } );
	}
}

void benchAddCrowds( benchList* list, int64_t largest )
{
	static const struct
	{
		const char* stem;
		soleDetail detail;
		int32_t interval;
	} kinds[] = {
		{ "crowd-full", sole_detailFull, 1 },
		{ "crowd-few", sole_detailFew, 1 },
		{ "crowd-height", sole_detailHeight, 1 },
		{ "crowd-full-4th", sole_detailFull, 4 },
		{ "crowd-few-4th", sole_detailFew, 4 },
		{ "crowd-height-4th", sole_detailHeight, 4 },
	};
	for ( int32_t i = 0; i < 6; ++i )
	{
		for ( int32_t count = 1; count <= 100000 && count <= largest; count *= count == 1 ? 100 : 10 )
		{
			benchAddHerd( list, benchName( kinds[i].stem, count ),
			    ( benchHerdKind ){ .detail = kinds[i].detail,
			        .interval = kinds[i].interval,
			        .count = count,
			        .groundSize = GROUND_SIZE } );
		}
	}
	for ( int64_t size = 0; size <= 1000000 && size <= largest; size = size == 0 ? 10000 : 10 * size )
	{
		benchAddHerd( list, size == 0 ? "crowd-on-plane" : benchName( "crowd-on", size ),
		    ( benchHerdKind ){
		        .detail = sole_detailFull, .interval = 1, .count = GROUNDS_CHARACTERS, .groundSize = size } );
	}
	benchAddSpin( list );
	benchAdd( list,
	    ( benchCase ){
	        .name = "memory-crowd",
	        .variant = "sole",
	        .unit = "bytes/character",
	        .itemCount = 1,
	        .open = benchOpenCrowdSize,
	        .close = free,
	    } );
}
