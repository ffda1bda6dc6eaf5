// SPDX-License-Identifier: MIT
// Profiles: a loft walked from piece to piece along +Z by a cursor that keeps z and the height in the middle.
#include "scene_builder.h"

#define RUBBLE_STEP 0.04
#define RUBBLE_FADE 0.5
#define RUBBLE_SINES 5

double soleSceneFade( double a )
{
	double t = a < 0.0 ? 0.0 : ( a > 1.0 ? 1.0 : a );
	return t * t * ( 3.0 - 2.0 * t );
}

double soleSceneRandom( uint32_t* seed, double low, double high )
{
	// A linear congruence, its high bits mixed: the same numbers on every machine.
	*seed = *seed * 1664525u + 1013904223u;
	uint32_t bits = ( *seed ^ ( *seed >> 15 ) ) * 2246822519u;
	return low + ( high - low ) * ( (double)( bits >> 8 ) / 16777216.0 );
}

/// A row of three points; slope is that from -x to +x.
static void soleAddCursorRow( soleSceneCursor* cursor, double slope )
{
	double x[3] = { -cursor->halfWidth, 0.0, cursor->halfWidth };
	double y[3] = { cursor->y - slope * cursor->halfWidth, cursor->y, cursor->y + slope * cursor->halfWidth };
	soleAddSceneRow( cursor->builder, cursor->z, x, y, 3 );
	double low = y[0] < y[2] ? y[0] : y[2];
	cursor->lowest = low < cursor->lowest ? low : cursor->lowest;
}

soleSceneCursor soleBeginSceneProfile( soleSceneBuilder* builder, double halfWidth, double z )
{
	soleSceneCursor cursor = { .builder = builder, .halfWidth = halfWidth, .z = z };
	soleAddCursorRow( &cursor, 0.0 );
	return cursor;
}

void soleAddSceneSlope( soleSceneCursor* cursor, double length, double slope )
{
	cursor->z += length;
	cursor->y += length * slope;
	soleAddCursorRow( cursor, 0.0 );
}

void soleAddSceneRiser( soleSceneCursor* cursor, double rise )
{
	cursor->y += rise;
	soleAddCursorRow( cursor, 0.0 );
}

void soleAddSceneStairs( soleSceneCursor* cursor, int32_t count, double rise, double tread )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( i > 0 )
		{
			soleAddSceneSlope( cursor, tread, 0.0 );
		}
		soleAddSceneRiser( cursor, rise );
	}
}

void soleAddSceneSideSlope( soleSceneCursor* cursor, double length, double slope, double blend )
{
	const int32_t rowCount = 12; // of each blend
	double start = cursor->z;
	for ( int32_t i = 1; i <= rowCount; ++i )
	{
		cursor->z = start + blend * i / rowCount;
		soleAddCursorRow( cursor, slope * soleSceneFade( (double)i / rowCount ) );
	}
	for ( int32_t i = 0; i <= rowCount; ++i )
	{
		cursor->z = start + length - blend + blend * i / rowCount;
		soleAddCursorRow( cursor, slope * ( 1.0 - soleSceneFade( (double)i / rowCount ) ) );
	}
}

/// One wave: amplitude, wave numbers along x and z, phase.
typedef struct soleSceneSine
{
	double amplitude;
	double alongX;
	double alongZ;
	double phase;
} soleSceneSine;

static void soleMakeSines( uint32_t seed, soleSceneSine sines[RUBBLE_SINES] )
{
	const double turn = 6.283185307179586;
	uint32_t series = seed * 7919u;
	for ( int i = 0; i < RUBBLE_SINES; ++i )
	{
		double waves = soleSceneRandom( &series, 6.0, 25.0 );
		double heading = soleSceneRandom( &series, 0.0, turn );
		sines[i].amplitude = soleSceneRandom( &series, 0.008, 0.02 );
		sines[i].alongX = waves * sin( heading );
		sines[i].alongZ = waves * cos( heading );
		sines[i].phase = soleSceneRandom( &series, 0.0, turn );
	}
}

void soleAddSceneRubble( soleSceneCursor* cursor, double length, uint32_t seed )
{
	soleSceneSine sines[RUBBLE_SINES];
	soleMakeSines( seed, sines );
	double x[SOLE_SCENE_MAX_ROW];
	double y[SOLE_SCENE_MAX_ROW];
	int32_t cells = (int32_t)( 2.0 * cursor->halfWidth / RUBBLE_STEP + 0.5 );
	int32_t rowCount = (int32_t)( length / RUBBLE_STEP + 0.5 );
	double start = cursor->z;
	for ( int32_t row = 1; row <= rowCount; ++row )
	{
		double along = length * row / rowCount;
		double fade = soleSceneFade( along / RUBBLE_FADE ) * soleSceneFade( ( length - along ) / RUBBLE_FADE );
		cursor->z = start + along;
		for ( int32_t i = 0; i <= cells; ++i )
		{
			x[i] = -cursor->halfWidth + 2.0 * cursor->halfWidth * i / cells;
			double height = 0.0;
			for ( int k = 0; k < RUBBLE_SINES; ++k )
			{
				double angle = sines[k].alongX * x[i] + sines[k].alongZ * along + sines[k].phase;
				height += sines[k].amplitude * sin( angle );
			}
			// To 1/65536 m: the last bits of sin differ between C libraries.
			y[i] = cursor->y + floor( fade * height * 65536.0 + 0.5 ) / 65536.0;
			cursor->lowest = y[i] < cursor->lowest ? y[i] : cursor->lowest;
		}
		soleAddSceneRow( cursor->builder, cursor->z, x, y, cells + 1 );
	}
}

void soleEndSceneProfile( soleSceneCursor* cursor )
{
	soleCloseSceneLoft( cursor->builder, cursor->lowest - 1.0 );
}
