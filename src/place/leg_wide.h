// SPDX-License-Identifier: MIT
// Each way of solving a batch by itself, for comparing them.
#ifndef SOLE_PLACE_LEG_WIDE_H
#define SOLE_PLACE_LEG_WIDE_H

#include "sole/batch.h"

typedef void soleLegLanesFcn( const soleLegBatch* batch, int32_t first, int32_t end );

/// @param width 1: one by one, the specification; 4, 8, 16: end - first is a multiple of it, and the machine has it
soleLegLanesFcn* soleGetLegLanes( int32_t width );

#endif
