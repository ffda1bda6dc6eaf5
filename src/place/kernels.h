// SPDX-License-Identifier: MIT
// The wide kernels in each width that there are instructions for. Each by itself: what nobody asks for need not be
// linked.
#ifndef SOLE_PLACE_KERNELS_H
#define SOLE_PLACE_KERNELS_H

#include "place/foot_wide.h"
#include "place/leg_wide.h"
#include "place/sense_wide.h"
#include "place/target_wide.h"

/// How many lanes this machine has instructions for: 4, 8 or 16.
int32_t soleGetKernelWidth( void );

/// @param width 4, 8, 16: the ends of ranges are multiples of it, and the machine has it
soleLegLanesFcn* soleGetWideLegLanes( int32_t width );
soleFootLanesFcn* soleGetFootLanes( int32_t width );
soleSenseLanesFcn* soleGetSenseLanes( int32_t width );
soleTargetLanesFcn* soleGetTargetLanes( int32_t width );

#endif
