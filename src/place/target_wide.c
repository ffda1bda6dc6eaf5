// SPDX-License-Identifier: MIT
// Targets of several characters at once: what target.c takes of each leg is laid out in lanes, a leg a lane, the kernel
// of target_kernel.h goes over them in the width that is asked for, and what it finds goes back.
#include "place/target_wide.h"

#include "place/kernels.h"

static void soleAddLane( soleTargetLanes* f, const solePlaceWork* work, soleLegWork* leg )
{
	int32_t lane = f->count++;
	f->works[lane] = work;
	f->legs[lane] = leg;
	solePlane plane = soleFlatten( work, leg );
	leg->out->planeNormal_w = plane.normal;
	solePutRow3( f->up, lane, work->up );
	solePutRow3( f->rootUp, lane, work->rootUp );
	solePutRow3( f->forward, lane, leg->forward );
	solePutRow3( f->root_w, lane, work->root_w );
	solePutRow3( f->planePoint, lane, plane.point );
	solePutRow3( f->planeNormal, lane, plane.normal );
	solePutRow3( f->planeGradient, lane, plane.gradient );
	solePutRow3( f->anchor, lane, leg->anchor );
	solePutRow3( f->anchorGoal, lane, leg->anchorGoal );
	f->raise[lane] = leg->sunk + work->settings->target.height * leg->length;
	solePutRow4( f->turn, lane, leg->turn );
	solePutRow4( f->toeOut, lane, soleGetToeOut( work, leg ) );
	f->flat[lane] = soleStepFlat( work, leg );
	solePutRow3( f->pivot, lane, leg->pivot );
	solePutRow3( f->ankle, lane, leg->ankle );
	solePutRow4( f->foot, lane, leg->foot.rotation );
	solePutRow3( f->footSide, lane, leg->rig->footSide );
	f->weight[lane] = leg->weight;
	f->turnWeight[lane] = leg->turnWeight;
}

static void soleTakeLane( soleTargetLanes* f, int32_t lane )
{
	soleLegWork* leg = f->legs[lane];
	leg->image = soleGetRow4( f->image, lane );
	leg->ankleWanted = soleGetRow3( f->ankleWanted, lane );
	leg->ankleTarget = soleGetRow3( f->ankleTarget, lane );
	leg->pivotTarget = soleGetRow3( f->pivotTarget, lane );
	leg->footTarget = soleGetRow4( f->footTarget, lane );
	leg->out->planePoint_w = soleGetRow3( f->planePoint_w, lane );
}

static void soleRunLanes( soleTargetLanes* f, int32_t width )
{
	int32_t used = f->count;
	if ( used == 0 )
	{
		return;
	}
	int32_t end = soleWholeLanes( used, width );
	soleFillRows( f->up, offsetof( soleTargetLanes, image ) - offsetof( soleTargetLanes, up ), used, end );
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
		int32_t legCount = soleGoesByTicks( works[i] ) ? 0 : works[i]->legCount;
		for ( int32_t k = 0; k < legCount; ++k )
		{
			if ( works[i]->legs[k].usable )
			{
				soleAddLane( &lanes, works[i], works[i]->legs + k );
			}
			if ( lanes.count == SOLE_LANES )
			{
				soleRunLanes( &lanes, width );
			}
		}
	}
	soleRunLanes( &lanes, width );
}
