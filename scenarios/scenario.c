// SPDX-License-Identifier: MIT
// The scenes: a table of ids and what makes each of them. World space, metres, +Y up, walked along +Z.
#include "scenario.h"

#include "scene_makers.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PATH_MARGIN 0.8
#define TAN_12 0.2125565616700221
#define TAN_15 0.2679491924311227
#define TAN_20 0.36397023426620234
#define TAN_30 0.5773502691896257
#define TAN_60 1.7320508075688772
#define TAN_75 3.732050807568877

typedef struct soleSceneRecipe
{
	const char* id;
	const char* name;
	soleSceneMaker* make;
	double value; // what the scenes of one kind differ in
	bool seeded;
} soleSceneRecipe;

// Values: size, slope, kind, length, height or width, as the maker has it.
static const soleSceneRecipe recipes[] = {
	{ "flat", "Flat, 20 x 20", soleMakeSlab, 20.0, false },
	{ "ramp", "Ramp of 15 degrees, up and down", soleMakeRamp, TAN_15, false },
	{ "stairs", "8 steps of 0.17 x 0.29, up and down", soleMakeStairs, 0.0, false },
	{ "rubble", "Rubble of five sines", soleMakeRubble, 6.0, true },
	{ "course", "Ramp, stairs, curb, rubble, side slope", soleMakeCourse, 0.0, true },
	{ "T01", "Flat plane", soleMakeSlab, 20.0, false },
	{ "T02", "12 steps of 0.17 x 0.29, up and down", soleMakeStairs, 1.0, false },
	{ "T03", "12 steps of 0.20 x 0.25, up and down", soleMakeStairs, 2.0, false },
	{ "T04", "12 wide steps of 0.17 x 0.29, up and down", soleMakeStairs, 3.0, false },
	{ "T07", "Open stairs of plates", soleMakeOpenStairs, 0.05, false },
	{ "T08", "Curb of 0.15", soleMakeCurb, 0.15, false },
	{ "T09", "Bars of 0.10 x 0.10 across the way", soleMakeBars, 0.10, false },
	{ "T10", "Trenches 0.10, 0.20 and 0.35 wide", soleMakeTrenches, 2.0, false },
	{ "T11-10", "Ramp of 10 degrees, 8 long", soleMakeLongRamp, 0.17632698070846498, false },
	{ "T11-20", "Ramp of 20 degrees, 8 long", soleMakeLongRamp, TAN_20, false },
	{ "T11-30", "Ramp of 30 degrees, 8 long", soleMakeLongRamp, TAN_30, false },
	{ "T11-45", "Ramp of 45 degrees, 8 long", soleMakeLongRamp, 1.0, false },
	{ "T12", "Crest and valley of 30 degrees", soleMakeCrest, TAN_30, false },
	{ "T13", "Narrow ramp of 20 degrees over a drop", soleMakeBoxRamp, TAN_20, false },
	{ "T14-20", "Side slope of 20 degrees", soleMakeSideSlope, TAN_20, false },
	{ "T14-30", "Side slope of 30 degrees", soleMakeSideSlope, TAN_30, false },
	{ "T15-60", "Wedge of 60 degrees between the feet", soleMakeWedge, TAN_60, false },
	{ "T15-75", "Wedge of 75 degrees between the feet", soleMakeWedge, TAN_75, false },
	{ "T16", "Noise terrain", soleMakeNoiseTerrain, 20.0, true },
	{ "T17", "400 tilted boxes", soleMakeBoxes, 10.0, true },
	{ "T18", "Ridge of two faces 8 degrees apart", soleMakeRidge, 0.06992681194351041, false },
	{ "T19", "Loose boxes, one pushed, and a bystander", soleMakeLooseBoxes, 0.1, false },
	{ "T20-low", "Ground 0.06 below what carries the root", soleMakeTwoGrounds, 0.06, false },
	{ "T20-high", "Ground 0.06 above what carries the root", soleMakeTwoGrounds, -0.06, false },
	{ "T21", "Hollow log", soleMakeLog, 4.0, false },
	{ "T22", "Bench over a foot, and a crawlway", soleMakeBench, 0.0, false },
	{ "T23-15", "Floor that comes up by 0.15", soleMakeRisingFloor, 0.15, false },
	{ "T23-50", "Floor that comes up by 0.50", soleMakeRisingFloor, 0.50, false },
	{ "T24", "Platform over a drop of 3", soleMakePlatform, 3.0, false },
	{ "T24-0", "Platform over nothing", soleMakePlatform, 0.0, false },
	{ "T25-12", "Beam 0.12 wide", soleMakeBeam, 0.12, false },
	{ "T25-20", "Beam 0.20 wide", soleMakeBeam, 0.20, false },
	{ "T26-17", "Riser of 0.17", soleMakeCurb, 0.17, false },
	{ "T26-50", "Wall of 0.50", soleMakeCurb, 0.50, false },
	{ "T27-lift", "Plate that goes up and down", soleMakePlate, 0.0, false },
	{ "T27-slide", "Plate that slides and stops dead", soleMakePlate, 1.0, false },
	{ "T27-both", "Plate that slides, goes up and down and stops", soleMakePlate, 2.0, false },
	{ "T28", "Plate that turns under one foot", soleMakeTurntable, 0.7853981633974483, false },
	{ "T29", "Two plates in opposite phase", soleMakeTwoPlates, 0.15, false },
	{ "T30", "See-saw that is taken away", soleMakeSeeSaw, 0.2617993877991494, false },
	{ "T34", "Ramp of 12 degrees, 8 long", soleMakeLongRamp, TAN_12, false },
	{ "T48", "Planet of a radius of 6", soleMakePlanet, 6.0, false },
	{ "T49", "Floor, wall, ceiling and its edge", soleMakeOverhang, 3.0, false },
};

#define RECIPE_COUNT ( (int32_t)( sizeof recipes / sizeof recipes[0] ) )

const char* const* soleGetSceneIds( int32_t* count )
{
	// Filled from the table, always with the same.
	static const char* ids[RECIPE_COUNT];
	for ( int32_t i = 0; i < RECIPE_COUNT; ++i )
	{
		ids[i] = recipes[i].id;
	}
	*count = RECIPE_COUNT;
	return ids;
}

/// Finds "id" or, where it is seeded, "id-seed".
static const soleSceneRecipe* soleFindRecipe( const char* id, uint32_t* seed )
{
	*seed = 1;
	for ( int32_t i = 0; i < RECIPE_COUNT; ++i )
	{
		size_t length = strlen( recipes[i].id );
		if ( strncmp( id, recipes[i].id, length ) != 0 )
		{
			continue;
		}
		if ( id[length] == 0 )
		{
			return recipes + i;
		}
		const char* digits = id + length + 1;
		size_t digitCount = strspn( digits, "0123456789" );
		if ( recipes[i].seeded && id[length] == '-' && digitCount >= 1 && digitCount <= 4 && digits[digitCount] == 0 )
		{
			*seed = (uint32_t)strtoul( digits, NULL, 10 );
			return recipes + i;
		}
	}
	return NULL;
}

bool soleMakeScene( const char* id, soleScene* scene )
{
	memset( scene, 0, sizeof *scene );
	uint32_t seed;
	const soleSceneRecipe* recipe = id != NULL ? soleFindRecipe( id, &seed ) : NULL;
	if ( recipe == NULL )
	{
		return false;
	}
	soleSceneBuilder builder = { .failed = false };
	double ends[2] = { 0.0, 0.0 };
	soleBeginScenePiece( &builder, sole_sceneGround, NULL );
	recipe->make( &builder, recipe->value, seed, ends );
	if ( builder.failed )
	{
		soleFreeSceneBuilder( &builder );
		return false;
	}
	snprintf( scene->id, sizeof scene->id, "%s", id );
	snprintf( scene->name, sizeof scene->name, "%s", recipe->name );
	scene->vertexCount = builder.vertexCount;
	scene->positions = builder.positions;
	scene->triangleCount = builder.triangleCount;
	scene->indices = builder.indices;
	soleEndScenePieces( &builder );
	memcpy( scene->pieces, builder.pieces, sizeof scene->pieces );
	scene->pieceCount = builder.pieceCount;
	scene->way = builder.way;
	builder.positions = NULL;
	builder.indices = NULL;
	soleFreeSceneBuilder( &builder );
	scene->pathCount = 2;
	scene->path[0][1] = (float)( ends[0] + PATH_MARGIN );
	scene->path[1][1] = (float)( ends[1] - PATH_MARGIN );
	return true;
}

void soleFreeScene( soleScene* scene )
{
	free( scene->positions );
	free( scene->indices );
	memset( scene, 0, sizeof *scene );
}

bool soleGetScenePiece( const soleScene* scene, int32_t piece, double time, soleTransform* fromStart )
{
	return soleGetSceneMotion( &scene->pieces[piece].motion, time, fromStart );
}

void soleGetScenePieceSpeed( const soleScene* scene, int32_t piece, double time, soleVec3* velocity, soleVec3* spin )
{
	soleGetSceneMotionSpeed( &scene->pieces[piece].motion, time, velocity, spin );
}
