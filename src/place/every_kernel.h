// SPDX-License-Identifier: MIT
// All kernels of one width: included once for each, with SOLE_WIDTH defined.
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/row_kernel.h"

#include "place/leg_kernel.h"

#include "place/foot_kernel.h" // goes through the passes of that
#include "place/sense_kernel.h"
#include "place/target_kernel.h"

static soleLegLanesFcn* const SOLE_JOIN( soleLegLanesOf, SOLE_WIDTH ) = FN( soleSolveLegLanes );
static soleFootLanesFcn* const SOLE_JOIN( soleFootLanesOf, SOLE_WIDTH ) = FN( soleFinishFootLanes );
static soleSenseLanesFcn* const SOLE_JOIN( soleSenseLanesOf, SOLE_WIDTH ) = FN( soleSenseInLanes );
static soleTargetLanesFcn* const SOLE_JOIN( soleTargetLanesOf, SOLE_WIDTH ) = FN( soleSetTargetLanes );
