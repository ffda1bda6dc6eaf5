// SPDX-License-Identifier: MIT
// Statistics over samples of a figure.
#ifndef SOLE_MEASURE_STAT_H
#define SOLE_MEASURE_STAT_H

#include "sole/measure.h"

/// Nearest rank: the least sample that at least this share of the samples does not exceed. 0 where there are none.
double solePercentile( const double* sorted, int32_t count, double share );

/// Sorts the samples. All zero where there are none.
soleStat soleFindStat( double* samples, int32_t count );

#endif
