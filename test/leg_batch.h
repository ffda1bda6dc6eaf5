// SPDX-License-Identifier: MIT
// Legs in rows, as batch.h has them: such as occur, and such as do not. The same numbers from every compiler.
#ifndef TEST_LEG_BATCH_H
#define TEST_LEG_BATCH_H

#include "random.h"

#include "sole/batch.h"

#define BATCH_COUNT 4096
#define BATCH_IN 34
#define BATCH_OUT 15

typedef struct testBatch
{
	float in[BATCH_IN][BATCH_COUNT];
	float out[BATCH_OUT][BATCH_COUNT];
	uint32_t flags[BATCH_COUNT];
	soleLegBatch batch;
} testBatch;

typedef void testFillBatchFcn( testBatch* b, uint32_t seed );

static inline soleArray3 testArray3( float ( *rows )[BATCH_COUNT] )
{
	return ( soleArray3 ){ rows[0], rows[1], rows[2] };
}

static inline soleArray4 testArray4( float ( *rows )[BATCH_COUNT] )
{
	return ( soleArray4 ){ rows[0], rows[1], rows[2], rows[3] };
}

static inline void testBeginBatch( testBatch* b )
{
	memset( b, 0, sizeof *b );
	b->batch = ( soleLegBatch ){
		.count = BATCH_COUNT,
		.hip = testArray3( b->in + 0 ),
		.knee = testArray3( b->in + 3 ),
		.ankle = testArray3( b->in + 6 ),
		.target = testArray3( b->in + 9 ),
		.hinge = testArray3( b->in + 12 ),
		.reach = b->in[15],
		.fold = b->in[16],
		.softZone = b->in[17],
		.parent = testArray4( b->in + 18 ),
		.thigh = testArray4( b->in + 22 ),
		.shin = testArray4( b->in + 26 ),
		.foot = testArray4( b->in + 30 ),
		.thigh_l = testArray4( b->out + 0 ),
		.shin_l = testArray4( b->out + 4 ),
		.foot_l = testArray4( b->out + 8 ),
		.reached = testArray3( b->out + 12 ),
		.flags = b->flags,
	};
}

static inline void testPut3( soleArray3 a, int32_t i, soleVec3 v )
{
	a.x[i] = v.x;
	a.y[i] = v.y;
	a.z[i] = v.z;
}

static inline void testPutTurn( soleArray4 a, int32_t i, uint32_t* seed )
{
	soleQuat q = testRandomTurn( seed );
	a.x[i] = q.x;
	a.y[i] = q.y;
	a.z[i] = q.z;
	a.w[i] = q.w;
}

/// Legs as they are, straight and folded ones, targets in and out of reach, at the hip and behind.
static inline void testFillLegs( testBatch* b, uint32_t seed )
{
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
	{
		soleVec3 hip = testRandomPoint( &seed, 3.0f );
		soleVec3 way = testRandomDirection( &seed );
		float bend = i % 5 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 0.3f );
		soleVec3 side = soleAnyOrthogonal( way );
		soleVec3 knee = soleMulAdd( soleMulAdd( hip, 0.45f, way ), bend, side );
		soleVec3 ankle = soleMulAdd( hip, i % 7 == 0 ? 0.1f : 0.9f, way );
		soleVec3 target = soleAdd( ankle, testRandomPoint( &seed, 0.4f ) );
		target = i % 11 == 0 ? hip : ( i % 13 == 0 ? soleMulAdd( hip, -0.8f, way ) : target );
		target = i % 17 == 0 ? ankle : target;
		knee = i % 19 == 0 ? hip : knee;
		testPut3( b->batch.hip, i, hip );
		testPut3( b->batch.knee, i, knee );
		testPut3( b->batch.ankle, i, ankle );
		testPut3( b->batch.target, i, target );
		testPut3( b->batch.hinge, i, i % 23 == 0 ? soleVec( 0.0f, 0.0f, 0.0f ) : soleCross( side, way ) );
		b->batch.reach[i] = testRandomFloat( &seed, 0.9f, 1.0f );
		b->batch.fold[i] = testRandomFloat( &seed, 0.0f, 0.4f );
		b->batch.softZone[i] = i % 3 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 0.1f );
		testPutTurn( b->batch.parent, i, &seed );
		testPutTurn( b->batch.thigh, i, &seed );
		testPutTurn( b->batch.shin, i, &seed );
		testPutTurn( b->batch.foot, i, &seed );
	}
}

/// Numbers of every kind in any place.
static inline void testFillAnything( testBatch* b, uint32_t seed )
{
	static const float odd[] = { 0.0f, -0.0f, INFINITY, -INFINITY, NAN, 1e-40f, 3e38f, -3e38f, 1e-13f, 1.0f };
	testFillLegs( b, seed );
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
	{
		for ( int32_t k = 0; k < 3; ++k )
		{
			uint32_t row = testRandom( &seed ) % BATCH_IN;
			b->in[row][i] = odd[testRandom( &seed ) % ( sizeof odd / sizeof *odd )];
		}
	}
}

#endif
