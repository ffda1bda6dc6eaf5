// SPDX-License-Identifier: MIT
// Soles over the exact surfaces of a scene, each piece in its own frame: how deep, how high, how much of them over
// nothing, how far they slide. World space, metres.
#include "test.h"

#include "scene_meter.h"

#define CLIP_DOWN 0.003f // a sole point lower than this over the clip's floor is down
#define ROOF 0.65f       // what is higher over a sole point than this can't be what it has sunk into
#define SUPPORT 0.02     // what is lower under a sole point than this doesn't carry it
#define SURPRISE 0.3     // s after which a foot has to be out of what came into it

/// Height of a point over the ground, and how deep it is in it.
typedef struct testGround
{
	double gap; // NaN: nothing below
	double depth;
	int32_t piece; // with that gap
} testGround;

static testGround testAskPiece( const testWorld* world, int32_t piece, soleTransform place, soleVec3 p )
{
	soleVec3 local = soleInvTransformPoint( place, p );
	// What is above the next face that looks down is another storey.
	soleProbe up = { .start_w = local, .direction_w = soleVec( 0.0f, 1.0f, 0.0f ), .length = ROOF, .mask = UINT32_MAX };
	soleHit roof = soleCastProbe( world->grounds[piece], &up );
	double reach = (double)( roof.hit ? roof.point_w.y - local.y : ROOF );
	testGround ground = { .piece = piece };
	ground.gap = soleTerrain_GetGap( world->terrains[piece], local, reach );
	ground.depth = ground.gap < 0.0 ? soleTerrain_GetDepth( world->terrains[piece], local, reach ) : 0.0;
	return ground;
}

static testGround testAskGround( const testWorld* world, double time, soleVec3 p )
{
	testGround best = { .gap = (double)NAN, .piece = SOLE_NONE };
	for ( int32_t i = 0; i < world->scene.pieceCount; ++i )
	{
		soleTransform place;
		bool there = soleGetScenePiece( &world->scene, i, time, &place );
		if ( there == false || ( world->scene.pieces[i].layer & TEST_FEET_LAYERS ) == 0 )
		{
			continue;
		}
		testGround ground = testAskPiece( world, i, place, p );
		best.depth = fmax( best.depth, ground.depth );
		if ( ground.gap == ground.gap && !( ground.gap >= best.gap ) )
		{
			best.gap = ground.gap;
			best.piece = i;
		}
	}
	return best;
}

/// Something has come into being a moment ago, maybe where a foot was.
static bool testIsSurprised( const testWorld* world, double time )
{
	bool surprised = false;
	for ( int32_t i = 0; i < world->scene.pieceCount; ++i )
	{
		double from = world->scene.pieces[i].motion.from;
		surprised = surprised || ( from > 0.0 && time >= from && time < from + SURPRISE );
	}
	return surprised;
}

/// Heel and ball are both on the floor of the clip.
static bool testIsClipFlat( const testMeter* meter, int32_t frame, int32_t leg )
{
	const testRun* run = meter->run;
	const soleSceneMoment* moment = run->moments + frame;
	const soleVec3* sole = meter->in[1].legs[leg].sole;
	float scale = run->roots[frame].scale.y;
	float clipFloor = run->actor->travels[moment->gait].clipFloor;
	float floor = run->roots[frame].translation.y + scale * ( clipFloor - moment->base.y );
	return sole[test_heel].y - floor < scale * CLIP_DOWN && sole[test_ball].y - floor < scale * CLIP_DOWN;
}

/// What all points of a sole say together.
typedef struct testFooting
{
	double gap; // least
	double depth;
	double overhang;
} testFooting;

static testFooting testFindFooting( const testMeter* meter, int32_t frame, int32_t leg )
{
	testFooting footing = { .gap = HUGE_VAL };
	int32_t count = 0;
	int32_t over = 0;
	for ( int32_t i = 0; i < meter->pointCount; ++i )
	{
		const soleMeasurePoint* point = meter->points + i;
		if ( point->leg != leg )
		{
			continue;
		}
		soleVec3 p = soleTransformPoint( meter->out[1].joints[point->joint], point->position );
		testGround ground = testAskGround( meter->run->world, meter->run->times[frame], p );
		footing.depth = fmax( footing.depth, ground.depth );
		footing.gap = ground.gap < footing.gap ? ground.gap : footing.gap;
		over += ground.gap <= SUPPORT ? 0 : 1;
		count += 1;
	}
	footing.overhang = (double)over / (double)count;
	return footing;
}

/// G2, and G3 of a foot that reaches.
static void testMeasureFooting( testMeter* meter, int32_t frame, int32_t leg, bool planted, bool reaches )
{
	const testRun* run = meter->run;
	testGates* gates = meter->gates;
	testFooting footing = testFindFooting( meter, frame, leg );
	bool flat = testIsClipFlat( meter, frame, leg );
	if ( testIsSurprised( run->world, run->times[frame] ) == false )
	{
		testRaise( meter, frame, leg, footing.depth, planted ? &gates->depth : &gates->swingDepth );
		testRaise( meter, frame, leg, reaches ? footing.depth : 0.0, &gates->silent );
	}
	if ( planted && reaches && footing.gap < HUGE_VAL )
	{
		testRaise( meter, frame, leg, footing.gap, &gates->gap );
	}
	if ( planted && footing.gap < HUGE_VAL )
	{
		double error = (double)run->errors[frame * run->legCount + leg];
		testRaise( meter, frame, leg, fabs( error - fmax( footing.gap, 0.0 ) ), &gates->reported );
	}
	if ( flat && ( planted || run->moments[frame].resting ) )
	{
		testRaise( meter, frame, leg, footing.overhang, &gates->overhang );
	}
	for ( int i = test_heel; i <= test_ball && flat && planted && reaches; ++i )
	{
		testGround ground = testAskGround( run->world, run->times[frame], meter->out[1].legs[leg].sole[i] );
		testRaise( meter, frame, leg, ground.gap, &gates->flatGap );
	}
}

/// Where a point of the world is in the frame of a piece at a frame's time.
static soleVec3 testGetSeenFrom( const testRun* run, int32_t piece, int32_t frame, soleVec3 p )
{
	soleTransform place = soleTransform_Identity();
	if ( piece != SOLE_NONE )
	{
		soleGetScenePiece( &run->world->scene, piece, run->times[frame], &place );
	}
	return soleInvTransformPoint( place, p );
}

/// G1: the held point is the one of the sole that moves least, so that a foot may roll.
static void testMeasureSlide( testMeter* meter, int32_t frame, int32_t leg, bool planted )
{
	testStance* stance = meter->stances + leg;
	const soleVec3* now = meter->out[1].legs[leg].sole;
	const soleVec3* before = meter->out[0].legs[leg].sole;
	uint32_t changes = (uint32_t)( sole_legCaptured | sole_legReleased );
	if ( planted == false || stance->running == false || ( testGetFlags( meter, frame, leg ) & changes ) != 0 )
	{
		meter->gates->plants += planted ? 1.0 : 0.0;
		*stance = ( testStance ){ .running = planted };
		stance->piece = testAskGround( meter->run->world, meter->run->times[frame], now[test_ball] ).piece;
		return;
	}
	soleVec3 least = { 0.0f, 0.0f, 0.0f };
	for ( int i = 0; i < test_solePoints; ++i )
	{
		soleVec3 step = soleSub( testGetSeenFrom( meter->run, stance->piece, frame, now[i] ),
		    testGetSeenFrom( meter->run, stance->piece, frame - 1, before[i] ) );
		step.y = 0.0f;
		least = i == 0 || soleLength( step ) < soleLength( least ) ? step : least;
	}
	stance->drift = soleAdd( stance->drift, least );
	testRaise( meter, frame, leg, (double)soleLength( stance->drift ), &meter->gates->slide );
}

void testMeasureSole( testMeter* meter, int32_t frame, int32_t leg )
{
	uint32_t flags = testGetFlags( meter, frame, leg );
	bool whole = meter->run->moments[frame].weight >= 1.0;
	bool planted = whole && ( flags & (uint32_t)sole_legPlanted ) != 0;
	bool reaches = ( flags & (uint32_t)( sole_legOutOfReach | sole_legNoGround ) ) == 0;
	testMeasureSlide( meter, frame, leg, planted );
	if ( whole )
	{
		testMeasureFooting( meter, frame, leg, planted, reaches );
	}
}
