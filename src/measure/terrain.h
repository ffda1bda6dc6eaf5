// SPDX-License-Identifier: MIT
// What the figures ask of a terrain beyond the public header.
#ifndef SOLE_MEASURE_TERRAIN_H
#define SOLE_MEASURE_TERRAIN_H

#include "measure/double.h"
#include "sole/measure.h"

/// A point over its ground.
typedef struct soleGroundSample
{
	double gap;         // height over the ground that carries the point, NaN where there is none
	soleVec3d normal_w; // of that ground; up where there is none
} soleGroundSample;

soleGroundSample soleSampleTerrain( const soleTerrain* terrain, soleVec3d p, double reach );
/// Distance of p to the nearest surface of any facing, looked for no further than limit.
double soleFindTerrainDistance( const soleTerrain* terrain, soleVec3d p, double limit );

#endif
