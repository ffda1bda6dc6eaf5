// SPDX-License-Identifier: MIT
// The program sole_bench_stages: how long each stage of a solve takes, as further lines of sole_bench's CSV.
//   usage: sole_bench_stages [--runs N]
// The solves are those of the case biped-solve. Where the processor counts its time it is asked, for a clock's call
// takes as long as a small stage; what asking takes by itself is taken off. One run is the mean of all frames of the
// walk.
#define _POSIX_C_SOURCE 199309L

#include "bench.h"
#include "stage_hook.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MOST_STAGES 16
#define MOST_RUNS 1000
#define ASKED 100000 // times, to know what asking takes

#if defined( __x86_64__ )
#include <x86intrin.h>

static inline uint64_t benchTick( void )
{
	return __rdtsc();
}
#else
static inline uint64_t benchTick( void )
{
	struct timespec t;
	clock_gettime( CLOCK_MONOTONIC, &t );
	return 1000000000u * (uint64_t)t.tv_sec + (uint64_t)t.tv_nsec;
}
#endif

typedef struct benchStage
{
	const char* name;
	uint64_t ticks; // in this run
	double runs[MOST_RUNS];
} benchStage;

static benchStage s_stages[MOST_STAGES];
static int32_t s_stageCount;
static uint64_t s_last;

void benchBeginStages( void )
{
	s_last = benchTick();
}

void benchEndStage( const char* name )
{
	uint64_t now = benchTick();
	int32_t k = 0;
	while ( k < s_stageCount && s_stages[k].name != name )
	{
		++k;
	}
	if ( k < MOST_STAGES )
	{
		s_stages[k].name = name;
		s_stages[k].ticks += now - s_last;
		s_stageCount = k == s_stageCount ? k + 1 : s_stageCount;
	}
	s_last = benchTick();
}

/// @param nothing ticks from one look at the clock to the next
/// @return nanoseconds a tick
static double benchCalibrate( double* nothing )
{
	double begin = benchNow();
	uint64_t first = benchTick();
	uint64_t least = UINT64_MAX;
	while ( benchNow() - begin < 2e8 )
	{
		for ( int32_t i = 0; i < ASKED; ++i )
		{
			uint64_t a = benchTick();
			uint64_t b = benchTick();
			least = b - a < least ? b - a : least;
		}
	}
	*nothing = (double)least;
	return ( benchNow() - begin ) / (double)( benchTick() - first );
}

static const benchCase* benchFindSolve( const benchList* list )
{
	for ( int32_t i = 0; i < list->count; ++i )
	{
		if ( strcmp( list->cases[i].name, "biped-solve" ) == 0 && strcmp( list->cases[i].variant, "sole" ) == 0 )
		{
			return list->cases + i;
		}
	}
	return NULL;
}

static void benchMeasure( const benchCase* solve, int32_t runs )
{
	double nothing = 0.0;
	double perTick = benchCalibrate( &nothing );
	void* context = solve->open( solve->argument );
	solve->run( context ); // what is measured is warm
	for ( int32_t run = 0; run < runs; ++run )
	{
		for ( int32_t k = 0; k < s_stageCount; ++k )
		{
			s_stages[k].ticks = 0;
		}
		solve->run( context );
		for ( int32_t k = 0; k < s_stageCount; ++k )
		{
			double each = (double)s_stages[k].ticks / (double)solve->itemCount;
			s_stages[k].runs[run] = perTick * ( each - nothing );
		}
	}
	solve->close( context );
	for ( int32_t k = 0; k < s_stageCount; ++k )
	{
		double* all = s_stages[k].runs;
		qsort( all, (size_t)runs, sizeof *all, benchCompare );
		printf( "stage %s,sole,character,%d,%.4g,%.4g,%.4g\n", s_stages[k].name, runs, all[runs / 2], all[0],
		    all[runs - 1] );
	}
}

int main( int argc, char** argv )
{
	int32_t runs = 201;
	bool usable = argc == 1 || ( argc == 3 && strcmp( argv[1], "--runs" ) == 0 );
	runs = argc == 3 ? atoi( argv[2] ) : runs;
	if ( usable == false || runs < 1 || runs > MOST_RUNS )
	{
		fprintf( stderr, "usage: sole_bench_stages [--runs N]    N: 1 to %d\n", MOST_RUNS );
		return 2;
	}
	benchList list = { 0 };
	benchAddPlace( &list, 1 );
	const benchCase* solve = benchFindSolve( &list );
	if ( solve == NULL )
	{
		fprintf( stderr, "sole_bench_stages: there is no case biped-solve any more\n" );
		return 1;
	}
	benchMeasure( solve, runs );
	free( list.cases );
	return 0;
}
