// SPDX-License-Identifier: MIT
// Legs and ankles of several characters at once: what their stages take is laid out in lanes, a leg a lane, the kernel
// of foot_kernel.h goes over them, and what it finds goes back. Legs of another build than hip, knee, ankle and toes go
// one by one, as do those of which a setting wants more, and after the legs those ankles that come near their limits,
// or are still turned by them.
#include "place/foot_wide.h"

static bool soleFitsLanes( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	bool plain = rig->def.jointCount == 3 && rig->kneeIndex == 1 && rig->def.hasVirtualAnkle == false &&
	    rig->def.detachedFoot == SOLE_NONE && rig->toeSlot != SOLE_NONE;
	return plain && leg->usable && !( work->settings->leg.twist > 0.0f );
}

static void solePut3( soleFootRow* rows, int32_t lane, soleVec3 v )
{
	rows[0][lane] = v.x;
	rows[1][lane] = v.y;
	rows[2][lane] = v.z;
}

static void solePut4( soleFootRow* rows, int32_t lane, soleQuat q )
{
	rows[0][lane] = q.x;
	rows[1][lane] = q.y;
	rows[2][lane] = q.z;
	rows[3][lane] = q.w;
}

static soleQuat soleGet4( soleFootRow* rows, int32_t lane )
{
	return ( soleQuat ){ rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane] };
}

// -------------------------------------------------------------------------------------------------------------- in

static void solePutBones( soleFootLanes* f, int32_t lane, const soleTwoBoneDef* def )
{
	solePut3( f->hip, lane, def->hip );
	solePut3( f->knee, lane, def->knee );
	solePut3( f->ankle, lane, def->ankle );
	solePut3( f->target, lane, def->target );
	solePut3( f->hinge, lane, def->hinge );
	f->reach[lane] = def->reach;
	f->fold[lane] = def->fold;
	f->softZone[lane] = def->softZone;
}

static void solePutTurns( soleFootLanes* f, int32_t lane, const solePlaceWork* work, const soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	solePut4( f->thigh, lane, leg->rotations[0] );
	solePut4( f->shin, lane, leg->rotations[1] );
	solePut4( f->foot, lane, leg->foot.rotation );
	solePut4( f->toe, lane, leg->toeRotation );
	solePut4( f->thighParent, lane, soleParentRotation( work, rig->slots[0] ) );
	solePut4( f->shinParent, lane, soleParentRotation( work, rig->slots[1] ) );
	solePut4( f->footParent, lane, soleParentRotation( work, rig->slots[2] ) );
	solePut4( f->toeParent, lane, soleParentRotation( work, rig->toeSlot ) );
	solePut4( f->reachedFoot, lane, leg->footReached );
	solePut4( f->image, lane, leg->image );
}

static void solePutRig( soleFootLanes* f, int32_t lane, const soleRigLeg* rig )
{
	solePut3( f->up, lane, rig->footUp );
	solePut3( f->ahead, lane, rig->footForward );
	solePut3( f->side, lane, rig->footSide );
	solePut4( f->neutral, lane, rig->neutral );
	solePut3( f->low, lane, soleVec( rig->pitch.low.s, rig->roll.low.s, rig->twist.low.s ) );
	solePut3( f->high, lane, soleVec( rig->pitch.high.s, rig->roll.high.s, rig->twist.high.s ) );
}

static void solePutToes( soleFootLanes* f, int32_t lane, const solePlaceWork* work, const soleLegWork* leg )
{
	f->toeSlope[lane] = leg->toeSlope + leg->toeSunk;
	f->riseShare[lane] = leg->turnWeight;
	f->fallShare[lane] = leg->turnWeight * leg->state->plantWeight;
	f->toesUp[0][lane] = work->angles.toesUp.c;
	f->toesUp[1][lane] = work->angles.toesUp.s;
	f->toesDown[0][lane] = work->angles.toesDown.c;
	f->toesDown[1][lane] = work->angles.toesDown.s;
}

static void soleAddLane( soleFootLanes* f, solePlaceWork* work, soleLegWork* leg )
{
	int32_t lane = f->count++;
	f->works[lane] = work;
	f->legs[lane] = leg;
	soleTwoBoneDef def;
	soleReadyLeg( work, leg, &def );
	solePutBones( f, lane, &def );
	solePutTurns( f, lane, work, leg );
	solePutRig( f, lane, leg->rig );
	solePutToes( f, lane, work, leg );
}

// -------------------------------------------------------------------------------------------------------------- out

static void soleTakeLane( soleFootLanes* f, int32_t lane )
{
	const solePlaceWork* work = f->works[lane];
	soleLegWork* leg = f->legs[lane];
	leg->hipTurn = soleGet4( f->hipTurn, lane );
	leg->kneeTurn = soleGet4( f->kneeTurn, lane );
	soleTakeLeg( work, leg, soleVec( f->reached[0][lane], f->reached[1][lane], f->reached[2][lane] ), f->flags[lane] );
	soleVec3 turned = leg->state->limitTurn;
	bool kept = turned.x != 0.0f || turned.y != 0.0f || turned.z != 0.0f;
	if ( ( f->within[lane] == 0 || kept ) && leg->weight > 0.0f )
	{
		soleFinishAnkle( work, leg );
		return;
	}
	leg->out->rotations_l[0] = soleGet4( f->thigh_l, lane );
	leg->out->rotations_l[1] = soleGet4( f->shin_l, lane );
	leg->out->rotations_l[2] = soleGet4( f->foot_l, lane );
	leg->out->toeRotation_l = soleGet4( f->toe_l, lane );
}

/// Lanes that are not used go along with the first.
static void soleFillUp( soleFootLanes* f, int32_t end )
{
	soleFootRow* row = f->hip;
	size_t rows = ( offsetof( soleFootLanes, hipTurn ) - offsetof( soleFootLanes, hip ) ) / sizeof *row;
	for ( size_t i = 0; i < rows; ++i )
	{
		for ( int32_t lane = f->count; lane < end; ++lane )
		{
			row[i][lane] = row[i][0];
		}
	}
}

static void soleRunLanes( soleFootLanes* f, int32_t width )
{
	if ( f->count == 0 )
	{
		return;
	}
	int32_t end = ( f->count + width - 1 ) / width * width;
	soleFillUp( f, end );
	soleGetFootLanes( width )( f, end );
	for ( int32_t lane = 0; lane < f->count; ++lane )
	{
		soleTakeLane( f, lane );
	}
	f->count = 0;
}

void soleFinishLegs( solePlaceWork* const* works, int32_t count, int32_t width )
{
	soleFootLanes lanes;
	lanes.count = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t k = 0; k < works[i]->legCount; ++k )
		{
			soleLegWork* leg = works[i]->legs + k;
			if ( soleFitsLanes( works[i], leg ) == false )
			{
				soleFinishLeg( works[i], leg );
				continue;
			}
			soleAddLane( &lanes, works[i], leg );
			if ( lanes.count == SOLE_FOOT_LANES )
			{
				soleRunLanes( &lanes, width );
			}
		}
	}
	soleRunLanes( &lanes, width );
}
