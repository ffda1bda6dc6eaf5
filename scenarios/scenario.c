// SPDX-License-Identifier: MIT
// The scenes: a table of ids and what makes each of them. World space, metres, +Y up, walked along +Z.
#include "scenario.h"

#include "scene_builder.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HALF_WIDTH 2.0
#define PATH_MARGIN 0.8
#define TAN_12 0.2125565616700221
#define TAN_15 0.2679491924311227

typedef struct soleSceneRecipe
{
	const char* id;
	const char* name;
	/// Makes the solid. @return z of its ends, for the path.
	void ( *make )( soleSceneBuilder* builder, double value, uint32_t seed, double ends[2] );
	double value; // what the scenes of one kind differ in
	bool seeded;
} soleSceneRecipe;

static void soleMakeSlab( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, size / 2.0, -size / 2.0 );
	soleAddSceneSlope( &cursor, size, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[0] = -size / 2.0;
	ends[1] = size / 2.0;
}

/// Flat 2, up, flat 2, down, flat 2.
static void soleMakeRampOf( soleSceneBuilder* builder, double halfWidth, double length, double slope, double ends[2] )
{
	soleSceneCursor cursor = soleBeginSceneProfile( builder, halfWidth, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneSlope( &cursor, length, slope );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneSlope( &cursor, length, -slope );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

static void soleMakeRamp( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleMakeRampOf( builder, HALF_WIDTH, 4.0, slope, ends );
}

static void soleMakeLongRamp( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleMakeRampOf( builder, 4.0, 8.0, slope, ends );
}

typedef struct soleStairs
{
	int32_t count;
	double rise;
	double tread;
	double halfWidth;
} soleStairs;

/// Flat 2, up, a landing of 1.2, down, flat 2.
static void soleMakeStairs( soleSceneBuilder* builder, double number, uint32_t seed, double ends[2] )
{
	(void)seed;
	static const soleStairs kinds[3] = { { 8, 0.17, 0.29, HALF_WIDTH }, { 12, 0.17, 0.29, 1.0 },
		{ 12, 0.20, 0.25, 1.0 } };
	const soleStairs* stairs = kinds + (int)number;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, stairs->halfWidth, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneStairs( &cursor, stairs->count, stairs->rise, stairs->tread );
	soleAddSceneSlope( &cursor, 1.2, 0.0 );
	soleAddSceneStairs( &cursor, stairs->count, -stairs->rise, stairs->tread );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// Flat 2, rubble, flat 2.
static void soleMakeRubble( soleSceneBuilder* builder, double length, uint32_t seed, double ends[2] )
{
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneRubble( &cursor, length, seed );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// A bit of everything.
static void soleMakeCourse( soleSceneBuilder* builder, double value, uint32_t seed, double ends[2] )
{
	(void)value;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	soleAddSceneSlope( &cursor, 3.0, 0.0 );
	soleAddSceneSlope( &cursor, 2.5, TAN_15 );
	soleAddSceneSlope( &cursor, 1.5, 0.0 );
	soleAddSceneStairs( &cursor, 5, 0.17, 0.29 );
	soleAddSceneSlope( &cursor, 1.5, 0.0 );
	soleAddSceneStairs( &cursor, 5, -0.17, 0.29 );
	soleAddSceneSlope( &cursor, 1.5, 0.0 );
	soleAddSceneRiser( &cursor, 0.12 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneRiser( &cursor, -0.12 );
	soleAddSceneSlope( &cursor, 1.0, 0.0 );
	soleAddSceneRubble( &cursor, 4.0, seed );
	soleAddSceneSideSlope( &cursor, 3.0, TAN_12, 0.5 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// Up at z = 0, down 2 further on.
static void soleMakeCurb( soleSceneBuilder* builder, double rise, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, 3.0, -3.0 );
	soleAddSceneSlope( &cursor, 3.0, 0.0 );
	soleAddSceneRiser( &cursor, rise );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneRiser( &cursor, -rise );
	soleAddSceneSlope( &cursor, 3.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[0] = -3.0;
	ends[1] = cursor.z;
}

/// Flat, up, flat, down, flat: two crests and two valleys, 4 each.
static void soleMakeCrest( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	for ( int i = 0; i < 5; ++i )
	{
		soleAddSceneSlope( &cursor, 4.0, i == 1 ? slope : ( i == 3 ? -slope : 0.0 ) );
	}
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// 12 long, leaning sideways all along.
static void soleMakeSideSlope( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	double x[3] = { -3.0, 0.0, 3.0 };
	double y[3] = { -3.0 * slope, 0.0, 3.0 * slope };
	soleAddSceneRow( builder, 0.0, x, y, 3 );
	soleAddSceneRow( builder, 12.0, x, y, 3 );
	soleCloseSceneLoft( builder, y[0] - 1.0 );
	ends[1] = 12.0;
}

// A gradient of a lattice point, hashed.
static double soleGetLatticeSlope( int32_t x, int32_t z, uint32_t seed, double dx, double dz )
{
	uint32_t hash = (uint32_t)x * 374761393u + (uint32_t)z * 668265263u + seed * 2246822519u;
	hash = ( hash ^ ( hash >> 13 ) ) * 1274126177u;
	double slopeX = soleSceneRandom( &hash, -1.0, 1.0 );
	double slopeZ = soleSceneRandom( &hash, -1.0, 1.0 );
	return slopeX * dx + slopeZ * dz;
}

/// Gradient noise, about -1 to 1.
static double soleGetNoise( double x, double z, uint32_t seed )
{
	int32_t i = (int32_t)floor( x );
	int32_t k = (int32_t)floor( z );
	double dx = x - (double)i;
	double dz = z - (double)k;
	double fadeX = soleSceneFade( dx );
	double near0 = soleGetLatticeSlope( i, k, seed, dx, dz );
	double near1 = soleGetLatticeSlope( i + 1, k, seed, dx - 1.0, dz );
	double far0 = soleGetLatticeSlope( i, k + 1, seed, dx, dz - 1.0 );
	double far1 = soleGetLatticeSlope( i + 1, k + 1, seed, dx - 1.0, dz - 1.0 );
	double nearZ = near0 + fadeX * ( near1 - near0 );
	double farZ = far0 + fadeX * ( far1 - far0 );
	return 1.4 * ( nearZ + soleSceneFade( dz ) * ( farZ - nearZ ) );
}

/// Four octaves of noise on a grid of 0.25.
static void soleMakeNoiseTerrain( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
{
	int32_t cells = (int32_t)( size / 0.25 + 0.5 );
	for ( int32_t row = 0; row <= cells; ++row )
	{
		double z = -size / 2.0 + 0.25 * row;
		double x[SOLE_SCENE_MAX_ROW];
		double y[SOLE_SCENE_MAX_ROW];
		for ( int32_t i = 0; i <= cells; ++i )
		{
			x[i] = -size / 2.0 + 0.25 * i;
			y[i] = 0.0;
			double amplitude = 0.12;
			double scale = 0.5;
			for ( uint32_t octave = 0; octave < 4; ++octave )
			{
				y[i] += amplitude * soleGetNoise( scale * x[i], scale * z, 16 * seed + octave );
				amplitude *= 0.5;
				scale *= 2.0;
			}
		}
		soleAddSceneRow( builder, z, x, y, cells + 1 );
	}
	soleCloseSceneLoft( builder, -2.0 );
	ends[0] = -size / 2.0;
	ends[1] = size / 2.0;
}

/// A turn of up to 35 degrees about a horizontal axis, after any turn about up. No trigonometry: half angles are drawn
/// by their tangents.
static soleQuat soleGetBoxTurn( uint32_t* series )
{
	double tilt = soleSceneRandom( series, 0.0, 0.31529878887898 ); // tangent of 17.5 degrees
	soleVec3 axis = { (float)soleSceneRandom( series, -1.0, 1.0 ), 0.0f, (float)soleSceneRandom( series, -1.0, 1.0 ) };
	axis = soleScale( (float)tilt, soleNormalizeOr( axis, soleVec( 1.0f, 0.0f, 0.0f ) ) );
	soleQuat lean = soleNormalizeQuat( ( soleQuat ){ axis.x, 0.0f, axis.z, 1.0f } );
	soleQuat heading = { 0.0f, (float)soleSceneRandom( series, -1.0, 1.0 ), 0.0f,
		(float)soleSceneRandom( series, 0.1, 1.0 ) };
	return soleMulQuat( lean, soleNormalizeQuat( heading ) );
}

/// 400 boxes with edges of 0.1 to 0.4, half sunk into a slab.
static void soleMakeBoxes( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
{
	soleMakeSlab( builder, size, seed, ends );
	uint32_t series = seed * 104729u;
	float reach = (float)( size / 2.0 - 0.4 );
	for ( int i = 0; i < 400; ++i )
	{
		soleVec3 middle = { (float)soleSceneRandom( &series, -1.0, 1.0 ) * reach, 0.0f,
			(float)soleSceneRandom( &series, -1.0, 1.0 ) * reach };
		soleVec3 half = { (float)soleSceneRandom( &series, 0.05, 0.2 ), (float)soleSceneRandom( &series, 0.05, 0.2 ),
			(float)soleSceneRandom( &series, 0.05, 0.2 ) };
		soleAddSceneBox( builder, middle, half, soleGetBoxTurn( &series ) );
	}
}

// Values: size, slope, kind, length or rise, as the maker has it.
static const soleSceneRecipe recipes[] = {
	{ "flat", "Flat, 20 x 20", soleMakeSlab, 20.0, false },
	{ "ramp", "Ramp of 15 degrees, up and down", soleMakeRamp, TAN_15, false },
	{ "stairs", "8 steps of 0.17 x 0.29, up and down", soleMakeStairs, 0.0, false },
	{ "rubble", "Rubble of five sines", soleMakeRubble, 6.0, true },
	{ "course", "Ramp, stairs, curb, rubble, side slope", soleMakeCourse, 0.0, true },
	{ "T01", "Flat plane", soleMakeSlab, 20.0, false },
	{ "T02", "12 steps of 0.17 x 0.29, up and down", soleMakeStairs, 1.0, false },
	{ "T03", "12 steps of 0.20 x 0.25, up and down", soleMakeStairs, 2.0, false },
	{ "T08", "Curb of 0.15", soleMakeCurb, 0.15, false },
	{ "T11-10", "Ramp of 10 degrees, 8 long", soleMakeLongRamp, 0.17632698070846498, false },
	{ "T11-20", "Ramp of 20 degrees, 8 long", soleMakeLongRamp, 0.36397023426620234, false },
	{ "T11-30", "Ramp of 30 degrees, 8 long", soleMakeLongRamp, 0.5773502691896257, false },
	{ "T11-45", "Ramp of 45 degrees, 8 long", soleMakeLongRamp, 1.0, false },
	{ "T12", "Crest and valley of 30 degrees", soleMakeCrest, 0.5773502691896257, false },
	{ "T14-20", "Side slope of 20 degrees", soleMakeSideSlope, 0.36397023426620234, false },
	{ "T14-30", "Side slope of 30 degrees", soleMakeSideSlope, 0.5773502691896257, false },
	{ "T16", "Noise terrain", soleMakeNoiseTerrain, 20.0, true },
	{ "T17", "400 tilted boxes", soleMakeBoxes, 10.0, true },
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
