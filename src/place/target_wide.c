// SPDX-License-Identifier: MIT
// Targets of several characters at once: what target.c takes of each leg is laid out in lanes, a leg a lane, the kernel
// of target_kernel.h goes over them in the width that is asked for, and what it finds goes back.
#include "place/target_wide.h"

#include "base/wide_limits.h"

#define SOLE_WIDTH 4
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/target_kernel.h"
static soleTargetLanesFcn* const soleTargetLanesOf4 = FN( soleSetTargetLanes );
#undef SOLE_WIDTH

#if SOLE_X86
#define SOLE_WIDTH 8
SOLE_BEGIN_AVX2
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/target_kernel.h"
SOLE_END_TARGET
static soleTargetLanesFcn* const soleTargetLanesOf8 = FN( soleSetTargetLanes );
#undef SOLE_WIDTH

#define SOLE_WIDTH 16
SOLE_BEGIN_AVX512
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/target_kernel.h"
SOLE_END_TARGET
static soleTargetLanesFcn* const soleTargetLanesOf16 = FN( soleSetTargetLanes );
#undef SOLE_WIDTH
#endif

static soleTargetLanesFcn* soleGetTargetLanes( int32_t width )
{
#if SOLE_X86
	if ( width == 16 || width == 8 )
	{
		return width == 16 ? soleTargetLanesOf16 : soleTargetLanesOf8;
	}
#endif
	(void)width;
	return soleTargetLanesOf4;
}

static void solePut3( soleTargetRow* rows, int32_t lane, soleVec3 v )
{
	rows[0][lane] = v.x;
	rows[1][lane] = v.y;
	rows[2][lane] = v.z;
}

static void solePut4( soleTargetRow* rows, int32_t lane, soleQuat q )
{
	rows[0][lane] = q.x;
	rows[1][lane] = q.y;
	rows[2][lane] = q.z;
	rows[3][lane] = q.w;
}

static soleVec3 soleGet3( soleTargetRow* rows, int32_t lane )
{
	return soleVec( rows[0][lane], rows[1][lane], rows[2][lane] );
}

static soleQuat soleGet4( soleTargetRow* rows, int32_t lane )
{
	return ( soleQuat ){ rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane] };
}

static void soleAddLane( soleTargetLanes* f, const solePlaceWork* work, soleLegWork* leg )
{
	int32_t lane = f->count++;
	f->works[lane] = work;
	f->legs[lane] = leg;
	solePlane plane = soleFlatten( work, leg );
	leg->out->planeNormal_w = plane.normal;
	solePut3( f->up, lane, work->up );
	solePut3( f->rootUp, lane, work->rootUp );
	solePut3( f->forward, lane, leg->forward );
	solePut3( f->root_w, lane, work->root_w );
	solePut3( f->planePoint, lane, plane.point );
	solePut3( f->planeNormal, lane, plane.normal );
	solePut3( f->planeGradient, lane, plane.gradient );
	solePut3( f->anchor, lane, leg->anchor );
	solePut3( f->anchorGoal, lane, leg->anchorGoal );
	f->raise[lane] = leg->sunk + work->settings->target.height * leg->length;
	solePut4( f->turn, lane, leg->turn );
	f->toeOut[lane] = soleGetToeOut( work, leg );
	f->flat[lane] = soleStepFlat( work, leg );
	solePut3( f->pivot, lane, leg->pivot );
	solePut3( f->ankle, lane, leg->ankle );
	solePut4( f->foot, lane, leg->foot.rotation );
	solePut3( f->footSide, lane, leg->rig->footSide );
	f->weight[lane] = leg->weight;
	f->turnWeight[lane] = leg->turnWeight;
}

static void soleTakeLane( soleTargetLanes* f, int32_t lane )
{
	soleLegWork* leg = f->legs[lane];
	leg->image = soleGet4( f->image, lane );
	leg->ankleWanted = soleGet3( f->ankleWanted, lane );
	leg->ankleTarget = soleGet3( f->ankleTarget, lane );
	leg->pivotTarget = soleGet3( f->pivotTarget, lane );
	leg->footTarget = soleGet4( f->footTarget, lane );
	leg->out->planePoint_w = soleGet3( f->planePoint_w, lane );
}

static void soleRunLanes( soleTargetLanes* f, int32_t width )
{
	int32_t used = f->count;
	if ( used == 0 )
	{
		return;
	}
	int32_t end = ( used + width - 1 ) / width * width;
	soleTargetRow* row = f->up;
	size_t rows = ( offsetof( soleTargetLanes, image ) - offsetof( soleTargetLanes, up ) ) / sizeof *row;
	for ( size_t i = 0; i < rows; ++i )
	{
		// Lanes that are not used go along with the first.
		for ( int32_t lane = used; lane < end; ++lane )
		{
			row[i][lane] = row[i][0];
		}
	}
	soleGetTargetLanes( width )( f, end );
	for ( int32_t lane = 0; lane < used; ++lane )
	{
		soleTakeLane( f, lane );
	}
	f->count = 0;
}

void soleSetAllTargets( solePlaceWork* const* works, int32_t count, int32_t width )
{
	soleTargetLanes lanes;
	lanes.count = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t k = 0; k < works[i]->legCount; ++k )
		{
			if ( works[i]->legs[k].usable )
			{
				soleAddLane( &lanes, works[i], works[i]->legs + k );
			}
			if ( lanes.count == SOLE_TARGET_LANES )
			{
				soleRunLanes( &lanes, width );
			}
		}
	}
	soleRunLanes( &lanes, width );
}
