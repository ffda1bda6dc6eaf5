// SPDX-License-Identifier: MIT
// All kernels of one width: included once for each, with SOLE_WIDTH defined.
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/row_kernel.h"

#include "place/leg_kernel.h"

#include "place/foot_kernel.h" // goes through the passes of that
#include "place/sense_kernel.h"
#include "place/target_kernel.h"

static soleLegLanesFcn* const FN( soleLegLanesOf ) = FN( soleSolveLegLanes );
static soleFootLanesFcn* const FN( soleFootLanesOf ) = FN( soleFinishFootLanes );
static soleSenseLanesFcn* const FN( soleSenseLanesOf ) = FN( soleSenseInLanes );
static soleTargetLanesFcn* const FN( soleTargetLanesOf ) = FN( soleSetTargetLanes );
