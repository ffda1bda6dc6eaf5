// SPDX-License-Identifier: MIT
// Legs by themselves, many in a row: one by one, in each width that this machine has, and by the two jobs of ozz that
// do the nearest to it: two bones, then the foot turned. Legs as in a walk, bent by half a radian and more, with
// targets within a hand's breadth of their ankles, of which every eighth is out of reach. Metres, y up.
#include "bench.h"

#include "baselines/ozz_jobs.h"
#include "place/leg_wide.h"

#include <math.h>
#include <stdlib.h>

#define BENCH_BONE 0.45f
#define BENCH_LEG_NUMBERS 49 // of a leg, read and written
#define BENCH_ROW_GAP 16     // floats between rows: at multiples of 4096 bytes all rows would share a set of the cache

typedef struct benchLegsAsked
{
	int32_t width; // 0: the jobs of ozz
	int32_t count;
} benchLegsAsked;

typedef struct benchLegs
{
	benchLegsAsked asked;
	float* numbers;
	uint32_t* flags;
	soleLegBatch batch;
	// Of ozz.
	soleOzzTwoBoneJob* bones;
	soleOzzAimJob* aims;
	soleQuat* turns; // 3 a leg
} benchLegs;

/// [-1, 1], the same for the same place in every run.
static float benchUneven( int32_t leg, int32_t number )
{
	uint32_t h = (uint32_t)leg * 2654435769u + (uint32_t)number * 0x85ebca6bu;
	h = ( h ^ ( h >> 15 ) ) * 0x2c1b3c6du;
	h ^= h >> 13;
	return (float)( h >> 8 ) / 8388608.0f - 1.0f;
}

static soleVec3 benchUneven3( int32_t leg, int32_t number, float size )
{
	return soleScale(
	    size, soleVec( benchUneven( leg, number ), benchUneven( leg, number + 1 ), benchUneven( leg, number + 2 ) ) );
}

static soleQuat benchUnevenTurn( int32_t leg, int32_t number )
{
	soleVec3 v = benchUneven3( leg, number, 1.0f );
	return soleNormalizeQuat( ( soleQuat ){ v.x, v.y, v.z, 1.5f } );
}

static void benchPut3( soleArray3 a, int32_t i, soleVec3 v )
{
	a.x[i] = v.x;
	a.y[i] = v.y;
	a.z[i] = v.z;
}

static void benchPut4( soleArray4 a, int32_t i, soleQuat q )
{
	a.x[i] = q.x;
	a.y[i] = q.y;
	a.z[i] = q.z;
	a.w[i] = q.w;
}

/// The next row of numbers.
static float* benchTake( float** next, int32_t stride )
{
	float* row = *next;
	*next += stride;
	return row;
}

static soleLegBatch benchLayOut( float* numbers, uint32_t* flags, int32_t count, int32_t stride )
{
	soleLegBatch b = { .count = count, .flags = flags };
	soleArray3* places[] = { &b.hip, &b.knee, &b.ankle, &b.target, &b.hinge, &b.reached };
	for ( int32_t i = 0; i < 6; ++i )
	{
		places[i]->x = benchTake( &numbers, stride );
		places[i]->y = benchTake( &numbers, stride );
		places[i]->z = benchTake( &numbers, stride );
	}
	soleArray4* turns[] = { &b.parent, &b.thigh, &b.shin, &b.foot, &b.thigh_l, &b.shin_l, &b.foot_l };
	for ( int32_t i = 0; i < 7; ++i )
	{
		turns[i]->x = benchTake( &numbers, stride );
		turns[i]->y = benchTake( &numbers, stride );
		turns[i]->z = benchTake( &numbers, stride );
		turns[i]->w = benchTake( &numbers, stride );
	}
	b.reach = benchTake( &numbers, stride );
	b.fold = benchTake( &numbers, stride );
	b.softZone = benchTake( &numbers, stride );
	return b;
}

/// A leg and where its ankle should be; the jobs of ozz about the same.
static void benchPutLeg( benchLegs* legs, int32_t i )
{
	soleVec3 hinge = soleNormalizeOr(
	    soleAdd( soleVec( 1.0f, 0.0f, 0.0f ), benchUneven3( i, 0, 0.2f ) ), soleVec( 1.0f, 0.0f, 0.0f ) );
	soleVec3 down =
	    soleNormalizeOr( soleReject( soleAdd( soleVec( 0.0f, -1.0f, 0.0f ), benchUneven3( i, 3, 0.3f ) ), hinge ),
	        soleVec( 0.0f, -1.0f, 0.0f ) );
	soleVec3 fore = soleCross( down, hinge );
	soleVec3 hip = soleAdd( soleVec( 0.0f, 0.9f, 0.0f ), benchUneven3( i, 6, 0.1f ) );
	float bend = 0.3f + 0.1f * benchUneven( i, 9 );
	soleVec3 half = soleScale( BENCH_BONE * sqrtf( 1.0f - bend * bend ), down );
	soleVec3 knee = soleMulAdd( soleAdd( hip, half ), BENCH_BONE * bend, fore );
	soleVec3 ankle = soleMulAdd( hip, 2.0f, half );
	soleVec3 target = soleAdd( soleMulAdd( ankle, i % 8 == 0 ? 0.1f : -0.05f, down ), benchUneven3( i, 10, 0.04f ) );
	const soleLegBatch* b = &legs->batch;
	benchPut3( b->hip, i, hip );
	benchPut3( b->knee, i, knee );
	benchPut3( b->ankle, i, ankle );
	benchPut3( b->target, i, target );
	benchPut3( b->hinge, i, hinge );
	b->reach[i] = 0.995f;
	b->fold[i] = 0.3f;
	b->softZone[i] = 0.03f;
	benchPut4( b->parent, i, benchUnevenTurn( i, 13 ) );
	benchPut4( b->thigh, i, benchUnevenTurn( i, 16 ) );
	benchPut4( b->shin, i, benchUnevenTurn( i, 19 ) );
	benchPut4( b->foot, i, benchUnevenTurn( i, 22 ) );

	legs->bones[i] = soleDefaultOzzTwoBoneJob();
	legs->bones[i].start = hip;
	legs->bones[i].mid = knee;
	legs->bones[i].end = ankle;
	legs->bones[i].target = target;
	legs->bones[i].midAxis = hinge;
	legs->bones[i].poleVector = fore;
	legs->bones[i].soften = 0.97f;
	legs->aims[i] = soleDefaultOzzAimJob();
	legs->aims[i].joint = ankle;
	legs->aims[i].target = soleAdd( ankle, soleAdd( soleVec( 0.0f, 1.0f, 0.0f ), benchUneven3( i, 25, 0.2f ) ) );
	legs->aims[i].forward = soleVec( 0.0f, 1.0f, 0.0f );
	legs->aims[i].up = soleVec( 0.0f, 0.0f, 1.0f );
	legs->aims[i].poleVector = soleVec( 0.0f, 0.0f, 1.0f );
}

static void* benchOpenLegs( const void* argument )
{
	const benchLegsAsked* asked = argument;
	if ( asked->width > soleGetBatchWidth() )
	{
		return NULL;
	}
	benchLegs* legs = benchAlloc( 1, sizeof *legs );
	size_t count = (size_t)asked->count;
	legs->asked = *asked;
	legs->numbers = benchAlloc( BENCH_LEG_NUMBERS * ( count + BENCH_ROW_GAP ), sizeof *legs->numbers );
	legs->flags = benchAlloc( count, sizeof *legs->flags );
	legs->bones = benchAlloc( count, sizeof *legs->bones );
	legs->aims = benchAlloc( count, sizeof *legs->aims );
	legs->turns = benchAlloc( 3 * count, sizeof *legs->turns );
	legs->batch = benchLayOut( legs->numbers, legs->flags, asked->count, asked->count + BENCH_ROW_GAP );
	for ( int32_t i = 0; i < asked->count; ++i )
	{
		benchPutLeg( legs, i );
	}
	return legs;
}

static void benchRunLegs( void* context )
{
	benchLegs* legs = context;
	soleGetLegLanes( legs->asked.width )( &legs->batch, 0, legs->asked.count );
}

static void benchRunOzzLegs( void* context )
{
	benchLegs* legs = context;
	for ( int32_t i = 0; i < legs->asked.count; ++i )
	{
		soleOzzTwoBoneResult bent = soleRunOzzTwoBone( legs->bones + i );
		legs->turns[3 * i] = bent.start;
		legs->turns[3 * i + 1] = bent.mid;
		legs->turns[3 * i + 2] = soleRunOzzAim( legs->aims + i ).turn;
	}
}

static void benchCloseLegs( void* context )
{
	benchLegs* legs = context;
	free( legs->numbers );
	free( legs->flags );
	free( legs->bones );
	free( legs->aims );
	free( legs->turns );
	free( legs );
}

void benchAddLegs( benchList* list )
{
	static const char* const names[] = { "legs-1024", "legs-20480" };
	static const struct
	{
		const char* variant;
		int32_t width;
	} ways[] = { { "one-by-one", 1 }, { "width-4", 4 }, { "width-8", 8 }, { "width-16", 16 }, { "ozz-jobs", 0 } };
	static benchLegsAsked asked[2][5];
	for ( int32_t i = 0; i < 2; ++i )
	{
		int32_t count = i == 0 ? 1024 : 20480;
		for ( int32_t k = 0; k < 5; ++k )
		{
			asked[i][k] = ( benchLegsAsked ){ ways[k].width, count };
			benchAdd( list,
			    ( benchCase ){
			        .name = names[i],
			        .variant = ways[k].variant,
			        .unit = "leg",
			        .itemCount = count,
			        .counted = i == 0 && ( ways[k].width == 4 || ways[k].width == 8 ), // SSE2 and AVX2
			        .open = benchOpenLegs,
			        .argument = &asked[i][k],
			        .run = ways[k].width > 0 ? benchRunLegs : benchRunOzzLegs,
			        .close = benchCloseLegs,
			    } );
		}
	}
}
