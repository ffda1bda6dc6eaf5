// SPDX-License-Identifier: MIT
// The program sole_bench: times all cases, prints a table to stderr and CSV to stdout or a file.
//   usage: sole_bench [--runs N] [--largest N] [--only TEXT] [-o FILE.csv] [--count CASE/VARIANT | --counted]
// --count runs one case once, in benchCounted(), for those who count instructions, and fails where this machine does
// not have it; --counted lists which are meant.
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MIN_RUN_NS 2e6 // shorter runs are repeated until they are as long

#if defined( __GNUC__ )
#define BENCH_NO_INLINE __attribute__( ( noinline ) )
#else
#define BENCH_NO_INLINE
#endif

typedef struct benchOptions
{
	int32_t runs;
	int64_t largest;
	const char* only;
	const char* output;
	const char* counted;
	bool listCounted;
} benchOptions;

typedef struct benchTimes
{
	double* ns; // per item, one per run
	int32_t count;
} benchTimes;

/// One run as it is counted and timed. By itself, so that a counter can be switched on by its name.
BENCH_NO_INLINE void benchCounted( benchRunFcn* run, void* context );
void benchCounted( benchRunFcn* run, void* context )
{
	run( context );
}

static void benchPrint( FILE* file, const benchCase* c, benchTimes* times )
{
	qsort( times->ns, (size_t)times->count, sizeof *times->ns, benchCompare );
	double median = times->ns[times->count / 2];
	double least = times->ns[0];
	fprintf( file, "%s,%s,%s,%d,%.4g,%.4g,%.4g\n", c->name, c->variant, c->unit, times->count, median, least,
	    times->ns[times->count - 1] );
	fprintf( stderr, "%-26s %-16s %12.1f %12.1f  %s %s\n", c->name, c->variant, median, least,
	    c->run != NULL ? "ns /" : "", c->unit );
}

/// Runs all variants of one case in turn. @return how many these are
static int32_t benchRunGroup( const benchList* list, int32_t first, const benchOptions* options, FILE* file )
{
	enum
	{
		mostVariants = 16
	};
	void* contexts[mostVariants];
	int32_t repeats[mostVariants];
	benchTimes times[mostVariants];
	const benchCase* cases = list->cases + first;
	int32_t count = 0;
	while ( first + count < list->count && count < mostVariants && strcmp( cases[count].name, cases[0].name ) == 0 )
	{
		const benchCase* c = cases + count;
		contexts[count] = c->open( c->argument );
		times[count] = ( benchTimes ){ benchAlloc( (size_t)options->runs, sizeof( double ) ), 0 };
		repeats[count] = 1;
		if ( contexts[count] != NULL && c->run != NULL )
		{
			// The first run warms up and says how often to repeat.
			double start = benchNow();
			benchCounted( c->run, contexts[count] );
			double taken = benchNow() - start;
			repeats[count] = taken >= MIN_RUN_NS ? 1 : 1 + (int32_t)( MIN_RUN_NS / ( taken + 1.0 ) );
		}
		count += 1;
	}
	for ( int32_t round = 0; round < options->runs; ++round )
	{
		for ( int32_t i = 0; i < count; ++i )
		{
			if ( contexts[i] == NULL || ( cases[i].run == NULL && round > 0 ) )
			{
				continue;
			}
			double start = benchNow();
			for ( int32_t k = 0; k < repeats[i] && cases[i].run != NULL; ++k )
			{
				benchCounted( cases[i].run, contexts[i] );
			}
			double each = ( benchNow() - start ) / ( (double)repeats[i] * (double)cases[i].itemCount );
			times[i].ns[times[i].count] = cases[i].run != NULL ? each : *(const double*)contexts[i];
			times[i].count += 1;
		}
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( contexts[i] != NULL )
		{
			benchPrint( file, cases + i, times + i );
			if ( cases[i].close != NULL )
			{
				cases[i].close( contexts[i] );
			}
		}
		free( times[i].ns );
	}
	return count;
}

static int benchRunAll( const benchList* list, const benchOptions* options )
{
	FILE* file = options->output != NULL ? fopen( options->output, "w" ) : stdout;
	if ( file == NULL )
	{
		fprintf( stderr, "sole_bench: %s: cannot be written\n", options->output );
		return 1;
	}
	fprintf( file, "case,variant,unit,runs,median_ns,min_ns,max_ns\n" );
	fprintf( stderr, "%-26s %-16s %12s %12s\n", "case", "variant", "median", "min" );
	for ( int32_t i = 0; i < list->count; )
	{
		if ( options->only != NULL && strstr( list->cases[i].name, options->only ) == NULL )
		{
			i += 1;
			continue;
		}
		i += benchRunGroup( list, i, options, file );
		fflush( file );
	}
	return file != stdout && fclose( file ) != 0 ? 1 : 0;
}

/// Lists those whose instructions are counted as "CASE/VARIANT ITEMS", or runs one of them.
static int benchCount( const benchList* list, const benchOptions* options )
{
	int status = options->listCounted ? 0 : 1;
	for ( int32_t i = 0; i < list->count; ++i )
	{
		const benchCase* c = list->cases + i;
		char name[128];
		snprintf( name, sizeof name, "%s/%s", c->name, c->variant );
		if ( options->listCounted && c->counted )
		{
			printf( "%s %lld\n", name, (long long)c->itemCount );
		}
		if ( options->listCounted == false && c->counted && strcmp( name, options->counted ) == 0 )
		{
			void* context = c->open( c->argument );
			if ( context != NULL )
			{
				benchCounted( c->run, context );
				c->close( context );
				status = 0;
			}
		}
	}
	return status;
}

static bool benchReadOptions( int argc, char** argv, benchOptions* options )
{
	for ( int i = 1; i < argc; ++i )
	{
		const char* value = i + 1 < argc ? argv[i + 1] : NULL;
		if ( strcmp( argv[i], "--counted" ) == 0 )
		{
			options->listCounted = true;
			continue;
		}
		if ( value == NULL )
		{
			return false;
		}
		if ( strcmp( argv[i], "--runs" ) == 0 )
		{
			options->runs = (int32_t)strtol( value, NULL, 10 );
		}
		else if ( strcmp( argv[i], "--largest" ) == 0 )
		{
			options->largest = strtoll( value, NULL, 10 );
		}
		else if ( strcmp( argv[i], "--only" ) == 0 )
		{
			options->only = value;
		}
		else if ( strcmp( argv[i], "--count" ) == 0 )
		{
			options->counted = value;
		}
		else if ( strcmp( argv[i], "-o" ) == 0 )
		{
			options->output = value;
		}
		else
		{
			return false;
		}
		i += 1;
	}
	return options->runs > 0 && options->largest > 0;
}

int main( int argc, char** argv )
{
	benchOptions options = { .runs = 21, .largest = 1000000 };
	if ( !benchReadOptions( argc, argv, &options ) )
	{
		fprintf( stderr,
		    "usage: sole_bench [--runs N] [--largest N] [--only TEXT] [-o FILE.csv] "
		    "[--count CASE/VARIANT | --counted]\n" );
		return 2;
	}
	benchList list = { 0 };
	benchAddGround( &list, options.largest );
	benchAddLegs( &list );
	benchAddPlace( &list, options.largest );
	benchAddCrowds( &list, options.largest );
	int status =
	    options.counted != NULL || options.listCounted ? benchCount( &list, &options ) : benchRunAll( &list, &options );
	free( list.cases );
	return status;
}
