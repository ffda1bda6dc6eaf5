// SPDX-License-Identifier: MIT
// Scenes of one solid that is walked along: slabs, ramps, stairs, noise, rubble. World space.
#include "scene_makers.h"

#define HALF_WIDTH 2.0
#define TAN_12 0.2125565616700221
#define TAN_15 0.2679491924311227

void soleMakeSlab( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
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

void soleMakeRamp( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleMakeRampOf( builder, HALF_WIDTH, 4.0, slope, ends );
}

void soleMakeLongRamp( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
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
void soleMakeStairs( soleSceneBuilder* builder, double number, uint32_t seed, double ends[2] )
{
	(void)seed;
	static const soleStairs kinds[4] = { { 8, 0.17, 0.29, HALF_WIDTH }, { 12, 0.17, 0.29, 1.0 },
		{ 12, 0.20, 0.25, 1.0 }, { 12, 0.17, 0.29, 6.0 } };
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
void soleMakeRubble( soleSceneBuilder* builder, double length, uint32_t seed, double ends[2] )
{
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleAddSceneRubble( &cursor, length, seed );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// A bit of everything.
void soleMakeCourse( soleSceneBuilder* builder, double value, uint32_t seed, double ends[2] )
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
void soleMakeCurb( soleSceneBuilder* builder, double rise, uint32_t seed, double ends[2] )
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

/// Ten bars of square section, one every 0.70.
void soleMakeBars( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
{
	(void)seed;
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	for ( int i = 0; i < 10; ++i )
	{
		soleAddSceneRiser( &cursor, size );
		soleAddSceneSlope( &cursor, size, 0.0 );
		soleAddSceneRiser( &cursor, -size );
		soleAddSceneSlope( &cursor, 0.70 - size, 0.0 );
	}
	soleAddSceneSlope( &cursor, 2.0, 0.0 );
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// Three trenches with upright walls, 2.5 apart.
void soleMakeTrenches( soleSceneBuilder* builder, double depth, uint32_t seed, double ends[2] )
{
	(void)seed;
	static const double widths[3] = { 0.10, 0.20, 0.35 };
	soleSceneCursor cursor = soleBeginSceneProfile( builder, HALF_WIDTH, 0.0 );
	soleAddSceneSlope( &cursor, 2.5, 0.0 );
	for ( int i = 0; i < 3; ++i )
	{
		soleAddSceneRiser( &cursor, -depth );
		soleAddSceneSlope( &cursor, widths[i], 0.0 );
		soleAddSceneRiser( &cursor, depth );
		soleAddSceneSlope( &cursor, 2.5, 0.0 );
	}
	soleEndSceneProfile( &cursor );
	ends[1] = cursor.z;
}

/// Flat, up, flat, down, flat: two crests and two valleys, 4 each.
void soleMakeCrest( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
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
void soleMakeSideSlope( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	double x[3] = { -3.0, 0.0, 3.0 };
	double y[3] = { -3.0 * slope, 0.0, 3.0 * slope };
	soleAddSceneRow( builder, 0.0, x, y, 3 );
	soleAddSceneRow( builder, 12.0, x, y, 3 );
	soleCloseSceneLoft( builder, y[0] - 1.0 );
	ends[1] = 12.0;
}

/// Two faces that meet in a ridge along z, under the left foot of who stands at the origin.
void soleMakeRidge( soleSceneBuilder* builder, double slope, uint32_t seed, double ends[2] )
{
	(void)seed;
	const double ridge = 0.105;
	double x[3] = { -3.0, ridge, 3.0 };
	double y[3] = { slope * ( x[0] - ridge ), 0.0, slope * ( ridge - x[2] ) };
	soleAddSceneRow( builder, -3.0, x, y, 3 );
	soleAddSceneRow( builder, 3.0, x, y, 3 );
	soleCloseSceneLoft( builder, y[0] - 1.0 );
	ends[0] = -3.0;
	ends[1] = 3.0;
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
void soleMakeNoiseTerrain( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
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
void soleMakeBoxes( soleSceneBuilder* builder, double size, uint32_t seed, double ends[2] )
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
