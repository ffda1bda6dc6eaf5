// SPDX-License-Identifier: MIT
// Statistics over samples of a figure. Percentiles are by nearest rank, so that they are always one of the samples.
#include "measure/stat.h"

#include <math.h>
#include <stdlib.h>

static int soleCompareSamples( const void* a, const void* b )
{
	double x = *(const double*)a;
	double y = *(const double*)b;
	return ( x > y ) - ( x < y );
}

double solePercentile( const double* sorted, int32_t count, double share )
{
	int32_t rank = (int32_t)ceil( share * (double)count - 1e-9 );
	return count > 0 ? sorted[rank > 1 ? rank - 1 : 0] : 0.0;
}

soleStat soleFindStat( double* samples, int32_t count )
{
	soleStat stat = { 0.0, 0.0, 0.0 };
	if ( count == 0 )
	{
		return stat;
	}
	qsort( samples, (size_t)count, sizeof *samples, soleCompareSamples );
	for ( int32_t i = 0; i < count; ++i )
	{
		stat.mean += samples[i];
	}
	stat.mean /= (double)count;
	stat.p95 = solePercentile( samples, count, 0.95 );
	stat.max = samples[count - 1];
	return stat;
}
