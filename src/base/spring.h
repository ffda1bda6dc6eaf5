// SPDX-License-Identifier: MIT
// Offsets that decay like critically damped springs: what is left of a jump while the target is followed without lag.
#ifndef SOLE_BASE_SPRING_H
#define SOLE_BASE_SPRING_H

#include "sole/types.h"

/// Both decay towards zero over timeStep. Half-life 0 forgets at once; timeStep 0 changes nothing.
soleOffset1 soleDecayOffset1( soleOffset1 offset, float halfLife, float timeStep );
soleOffset3 soleDecayOffset3( soleOffset3 offset, float halfLife, float timeStep );

#endif
