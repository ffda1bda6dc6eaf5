// SPDX-License-Identifier: MIT
// Rolling ground of any number of triangles, and questions all over it. World: metres, y up.
#ifndef BENCH_TERRAIN_H
#define BENCH_TERRAIN_H

#include "peers.h"

#include "sole/ground.h"

#define BENCH_CELL 0.25f

/// Hills of 2 m, stones of 5 cm, corners off their grid by up to a fifth of a cell. As near to the count as a square of
/// cells of two triangles comes.
benchMesh benchMakeTerrain( int64_t triangleCount );
/// The same heights on the grid itself, row by row. @param countX of heights along each side
float* benchMakeHeights( int64_t triangleCount, int32_t* countX );
/// The triangles of a scene of scenarios/.
benchMesh benchMakeSceneMesh( const char* id );
void benchFreeMesh( benchMesh* mesh );
/// As Sole takes it; points into it.
soleGroundMesh benchDescribeMesh( const benchMesh* mesh );

/// How questions follow one another.
typedef enum benchOrder
{
	bench_scattered,
	bench_inOrder, // the same, sorted along a Z curve
	bench_fives    // five at a time under a foot of 26 cm, scattered
} benchOrder;

/// Questions from a metre over the ground to a metre below.
benchQuery* benchMakeQueries( const benchMesh* mesh, benchOrder order, float radius, int32_t count );

#endif
