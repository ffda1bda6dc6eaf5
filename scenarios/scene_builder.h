// SPDX-License-Identifier: MIT
// What scenes are made of: lofts (rows of points, one after another along +Z, closed by walls and a bottom), profiles
// (lofts walked by a cursor), boxes, prisms and pipes. Running out of memory is remembered and told at the end.
#ifndef SCENARIOS_SCENE_BUILDER_H
#define SCENARIOS_SCENE_BUILDER_H

#include "scenario.h"

#define SOLE_SCENE_MAX_ROW 160

/// Points that are neighbours, by number.
typedef struct soleSceneChain
{
	uint32_t points[SOLE_SCENE_MAX_ROW];
	int32_t count;
} soleSceneChain;

/// A row of points of a loft.
typedef struct soleSceneRow
{
	float z;
	uint32_t first;
	int32_t count;
} soleSceneRow;

typedef struct soleSceneBuilder
{
	float* positions;
	int32_t vertexCount;
	int32_t vertexCapacity;
	uint32_t* indices;
	int32_t triangleCount;
	int32_t triangleCapacity;
	soleSceneRow* rows; // of the loft in the making
	int32_t rowCount;
	int32_t rowCapacity;
	soleScenePiece pieces[SOLE_SCENE_MAX_PIECES];
	int32_t pieceCount;
	soleSceneWay way;
	bool failed;
} soleSceneBuilder;

void soleFreeSceneBuilder( soleSceneBuilder* builder );

/// What is added from here on is a piece of its own. @param motion NULL: stands still
void soleBeginScenePiece( soleSceneBuilder* builder, uint32_t layer, const soleSceneMotion* motion );
/// Counts the triangles of all pieces.
void soleEndScenePieces( soleSceneBuilder* builder );

uint32_t soleAddScenePoint( soleSceneBuilder* builder, double x, double y, double z );
/// Counter clockwise seen from outside.
void soleAddSceneTriangle( soleSceneBuilder* builder, uint32_t a, uint32_t b, uint32_t c );

/// The next row of a loft: count points with x rising and the same outermost x in all rows. z rises from row to row or
/// stays, which makes a wall. A third row at the same z is not allowed.
void soleAddSceneRow( soleSceneBuilder* builder, double z, const double* x, const double* y, int32_t count );
/// Closes the loft with walls down to the bottom, which is below all rows.
void soleCloseSceneLoft( soleSceneBuilder* builder, double bottom );

/// A box by its middle, half its size and its turn.
void soleAddSceneBox( soleSceneBuilder* builder, soleVec3 middle, soleVec3 half, soleQuat turn );
/// A box along the axes, by its corners.
void soleAddSceneBlock( soleSceneBuilder* builder, soleVec3 low, soleVec3 high );
/// A convex outline pulled along z. x, y of its corners, counter clockwise seen from +z.
void soleAddScenePrism(
    soleSceneBuilder* builder, const double ( *outline )[2], int32_t count, double from, double to );
/// An upright column of many sides.
void soleAddSceneColumn( soleSceneBuilder* builder, soleVec3 foot, double radius, double height );
/// A pipe along z, open at both ends, its middle at x = 0 and a height.
void soleAddScenePipe( soleSceneBuilder* builder, double height, double inner, double outer, double from, double to );

/// Where a profile has got to. Rows have a point in the middle, so that heights along x = 0 are exact.
typedef struct soleSceneCursor
{
	soleSceneBuilder* builder;
	double halfWidth;
	double z;
	double y;
	double lowest;
} soleSceneCursor;

soleSceneCursor soleBeginSceneProfile( soleSceneBuilder* builder, double halfWidth, double z );
/// A stretch that rises by slope metres a metre.
void soleAddSceneSlope( soleSceneCursor* cursor, double length, double slope );
/// A riser up, or down where rise is below zero.
void soleAddSceneRiser( soleSceneCursor* cursor, double rise );
/// count risers with count - 1 treads between them.
void soleAddSceneStairs( soleSceneCursor* cursor, int32_t count, double rise, double tread );
/// Ground that leans sideways: up towards +x by slope metres a metre, blended in and out over blend within the length.
void soleAddSceneSideSlope( soleSceneCursor* cursor, double length, double slope, double blend );
/// Sines in all directions, seeded, faded in and out within the length.
void soleAddSceneRubble( soleSceneCursor* cursor, double length, uint32_t seed );
/// Closes the profile a metre below its lowest point.
void soleEndSceneProfile( soleSceneCursor* cursor );

/// 3 a^2 - 2 a^3, a clamped to 0..1.
double soleSceneFade( double a );
/// The next of a seeded series, low to high.
double soleSceneRandom( uint32_t* seed, double low, double high );

#endif
