// SPDX-License-Identifier: MIT
// Parts of stages that are done leg by leg also where the rest goes through the wide kernels.
#ifndef SOLE_PLACE_PARTS_H
#define SOLE_PLACE_PARTS_H

#include "place/place.h"

/// Of soleSense(): what a leg has of the slots, what its heel is raised about, and how fast its sole is.
void soleTakeSlots( const solePlaceWork* work, soleLegWork* leg );
soleVec3 soleGetPivot( const solePlaceWork* work, const soleLegWork* leg );
void soleSenseSpeed( const solePlaceWork* work, soleLegWork* leg );

/// Of soleSetTargets(): the plane of a foot that follows less of the slope, and stays above the ground for it.
solePlane soleFlatten( const solePlaceWork* work, const soleLegWork* leg );
/// The angle that lays a foot flat whose heel its clip leaves off the floor while heel and toes are down and at rest:
/// about what a heel is raised about, at right angles to the foot. It comes and goes with that.
float soleStepFlat( const solePlaceWork* work, const soleLegWork* leg );

/// Of soleSolveLeg(): before the two bones are solved, and after.
void soleReadyLeg( const solePlaceWork* work, soleLegWork* leg, soleTwoBoneDef* def );
void soleTakeLeg( const solePlaceWork* work, soleLegWork* leg, soleVec3 reached, uint32_t flags );

/// Of soleAlignAnkle(): as animated, world.
soleQuat soleParentRotation( const solePlaceWork* work, int32_t slot );

#endif
