// SPDX-License-Identifier: MIT
// Sensing of several characters at once: their poses are laid out in lanes, a lane a character, the kernel of
// sense_kernel.h goes over them in the width that is asked for, and what it finds goes back to each.
#include "place/sense_wide.h"

#include "place/kernels.h"

// -------------------------------------------------------------------------------------------------------------- in

static void solePutSpace( soleSenseSpace* space, int32_t lane, soleTransform t )
{
	solePutRow3( space->place, lane, t.translation );
	space->turn[0][lane] = t.rotation.x;
	space->turn[1][lane] = t.rotation.y;
	space->turn[2][lane] = t.rotation.z;
	space->turn[3][lane] = t.rotation.w;
	solePutRow3( space->scale, lane, t.scale );
}

static void solePutCharacter( soleSenseLanes* f, int32_t lane, const solePlaceWork* work )
{
	solePutSpace( &f->root, lane, soleGetNearRoot( work ) );
	solePutRow3( f->up, lane, work->up );
	solePutRow3( f->level, lane, work->level );
	solePutRow3( f->rootUp, lane, work->rootUp );
	solePutRow3( f->floor, lane, work->floor );
	f->rootScale[lane] = work->rootScale;
	for ( int32_t k = 0; k < work->rig->slotCount; ++k )
	{
		solePutSpace( f->slots + k, lane, soleReadPose( work->frame, work->second, work->rig->slotJoints[k] ) );
	}
}

// -------------------------------------------------------------------------------------------------------------- out

static void soleTakeCharacter( soleSenseLanes* f, int32_t lane, solePlaceWork* work )
{
	for ( int32_t k = 0; k < work->rig->slotCount; ++k )
	{
		soleSenseSpace* space = f->slots + k;
		soleQuat turn = { space->turn[0][lane], space->turn[1][lane], space->turn[2][lane], space->turn[3][lane] };
		work->slots[k] =
		    ( soleTransform ){ soleGetRow3( space->place, lane ), turn, soleGetRow3( space->scale, lane ) };
	}
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		soleSenseFoot* foot = f->feet + i;
		soleTakeSlots( work, leg );
		leg->usable = foot->usable[lane] != 0;
		leg->ankle = soleGetRow3( foot->ankle, lane );
		leg->joints[leg->ankleIndex] = leg->ankle;
		leg->length = foot->length[lane];
		leg->heel = soleGetRow3( foot->heel, lane );
		leg->ball = soleGetRow3( foot->ball, lane );
		leg->pivot = soleGetPivot( work, leg );
		leg->forward = soleGetRow3( foot->forward, lane );
		leg->heelRise = foot->heelRise[lane];
		leg->ballRise = foot->ballRise[lane];
		leg->tipRise = foot->tipRise[lane];
		leg->sunk = foot->sunk[lane];
		leg->toeSunk = foot->toeSunk[lane];
		soleSenseSpeed( work, leg );
	}
}

void soleSenseAll( solePlaceWork* const* works, int32_t count, int32_t width )
{
	const soleRig* rig = works[0]->rig;
	if ( rig->slotCount > SOLE_SENSE_SLOTS || rig->legCount > SOLE_SENSE_LEGS )
	{
		for ( int32_t i = 0; i < count; ++i )
		{
			soleSense( works[i] );
		}
		return;
	}
	soleSenseLanes lanes;
	lanes.rig = rig;
	for ( int32_t first = 0; first < count; first += SOLE_LANES )
	{
		int32_t used = soleMinI( count - first, SOLE_LANES );
		int32_t end = soleWholeLanes( used, width );
		for ( int32_t lane = 0; lane < end; ++lane )
		{
			// Lanes that are not used go along with the first.
			solePutCharacter( &lanes, lane, works[first + ( lane < used ? lane : 0 )] );
		}
		soleGetSenseLanes( width )( &lanes, end );
		for ( int32_t lane = 0; lane < used; ++lane )
		{
			soleTakeCharacter( &lanes, lane, works[first + lane] );
		}
	}
}
