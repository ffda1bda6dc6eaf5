// SPDX-License-Identifier: MIT
// How far two samplings of what should be one motion are apart: distances in the world between the same ankles and
// balls at the times that both have. Whole rates in Hz have the times of their greatest common divisor in common, 30 Hz
// of 30 and 60, 12 Hz of 60 and 144.
#include "base/core.h"
#include "measure/pose.h"
#include "measure/stat.h"

#include <math.h>

#define HIGHEST_RATE 1e6 // Hz
#define POINTS_A_LEG 2   // ankle, ball

// Which frames are of one time.
typedef struct soleCommonTimes
{
	int32_t stepA;
	int32_t stepB;
	int32_t first; // number of the first common time that counts
	int32_t count;
} soleCommonTimes;

static int32_t soleFindDivisor( int32_t a, int32_t b )
{
	while ( b > 0 )
	{
		int32_t rest = a % b;
		a = b;
		b = rest;
	}
	return a;
}

static bool soleIsWholeRate( float rate )
{
	double whole = floor( (double)rate + 0.5 );
	return whole >= 1.0 && whole <= HIGHEST_RATE && fabs( (double)rate - whole ) < 1e-3;
}

static soleCommonTimes soleFindCommonTimes( const soleMotion* a, const soleMotion* b, float start )
{
	int32_t rateA = (int32_t)( a->frameRate + 0.5f );
	int32_t rateB = (int32_t)( b->frameRate + 0.5f );
	int32_t rate = soleFindDivisor( rateA, rateB );
	soleCommonTimes times = { rateA / rate, rateB / rate, 0, 0 };
	int32_t timesA = ( a->frameCount - 1 ) / times.stepA + 1;
	int32_t timesB = ( b->frameCount - 1 ) / times.stepB + 1;
	int32_t end = timesA < timesB ? timesA : timesB;
	double first = ceil( (double)start * (double)rate - 1e-6 );
	times.first = first > 0.0 ? ( first < (double)end ? (int32_t)first : end ) : 0;
	times.count = end - times.first;
	return times;
}

static soleResult soleCheckComparison(
    const soleMotion* motion, const soleMotion* other, float start, soleMessage* message )
{
	soleResult result = soleCheckMotion( motion, "motion", message );
	result = result == sole_success ? soleCheckMotion( other, "other", message ) : result;
	if ( result != sole_success )
	{
		return result;
	}
	if ( other->rig != motion->rig )
	{
		soleSetMessage( message, "other has another rig than motion: sample both alike" );
		return sole_invalidDefinition;
	}
	if ( soleIsWholeRate( motion->frameRate ) == false || soleIsWholeRate( other->frameRate ) == false )
	{
		soleSetMessage( message, "frame rates are %g and %g: whole rates alone have times in common",
		    (double)motion->frameRate, (double)other->frameRate );
		return sole_invalidDefinition;
	}
	if ( soleIsFinite( start ) == false || soleFindCommonTimes( motion, other, start ).count < 1 )
	{
		soleSetMessage( message, "start is %g: the motions have no time in common from there on", (double)start );
		return sole_invalidDefinition;
	}
	return sole_success;
}

/// Ankle and ball of each leg in the world.
static void soleFindFeet( soleMeasurePose* pose, const soleMotion* motion, int32_t frame, soleVec3d* feet )
{
	soleEvaluateWorld( pose, motion, frame );
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( motion->rig ); ++leg )
	{
		soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1];
		int32_t count = soleGetLegChain( pose, leg, chain );
		feet[POINTS_A_LEG * leg] = chain[count - 1];
		feet[POINTS_A_LEG * leg + 1] = soleGetCarried( pose, soleGetBallPoint( motion->rig, leg ) );
	}
}

soleResult soleCompareMotions( const soleMotion* motion, const soleMotion* other, float start,
    const soleAllocator* allocator, soleStat* distance, soleMessage* message )
{
	SOLE_ASSERT( distance != NULL && "distance: give the address of a struct" );
	if ( distance == NULL )
	{
		return sole_invalidDefinition;
	}
	*distance = ( soleStat ){ 0.0, 0.0, 0.0 };
	soleResult result = soleCheckComparison( motion, other, start, message );
	if ( result != sole_success )
	{
		return result;
	}
	soleCommonTimes times = soleFindCommonTimes( motion, other, start );
	int32_t pointCount = POINTS_A_LEG * soleRig_GetLegCount( motion->rig );
	size_t sampleBytes = (size_t)times.count * (size_t)pointCount * sizeof( double );
	soleMeasurePose pose = { 0 };
	double* samples = soleAlloc( allocator, sampleBytes );
	if ( samples == NULL || soleMakeMeasurePose( motion->rig, allocator, &pose ) == false )
	{
		soleFree( allocator, samples, sampleBytes );
		soleSetMessage( message, "out of memory for %d common times", times.count );
		return sole_outOfMemory;
	}
	int32_t count = 0;
	for ( int32_t i = times.first; i < times.first + times.count; ++i )
	{
		soleVec3d a[POINTS_A_LEG * SOLE_MAX_LEGS];
		soleVec3d b[POINTS_A_LEG * SOLE_MAX_LEGS];
		soleFindFeet( &pose, motion, i * times.stepA, a );
		soleFindFeet( &pose, other, i * times.stepB, b );
		for ( int32_t k = 0; k < pointCount; ++k )
		{
			samples[count++] = soleLengthD( soleSubD( a[k], b[k] ) );
		}
	}
	soleStat stat = soleFindStat( samples, count );
	soleFreeMeasurePose( allocator, &pose );
	soleFree( allocator, samples, sampleBytes );
	if ( stat.mean - stat.mean != 0.0 )
	{
		soleSetMessage( message, "motion or other is not finite: mend poses and roots" );
		return sole_invalidDefinition;
	}
	*distance = stat;
	return sole_success;
}
