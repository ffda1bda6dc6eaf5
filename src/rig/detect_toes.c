// SPDX-License-Identifier: MIT
// Toe joints below the ankle: by name, else the branch of the foot that reaches furthest along the floor.
#include "detect_internal.h"

/// Marks each joint below the foot with its depth below it, all others with -1.
static void soleMarkBelow( soleDetect* detect, int32_t foot )
{
	for ( int32_t k = 0; k < detect->jointCount; ++k )
	{
		int32_t joint = detect->order[k];
		int32_t parent = detect->parents[joint];
		int32_t above = parent == SOLE_NONE ? -1 : detect->ints[parent];
		detect->ints[joint] = joint == foot ? 0 : ( above < 0 ? -1 : above + 1 );
	}
}

/// Of several toes side by side the one nearest to their middle.
static int32_t soleFindNamedToe( const soleDetect* detect, const soleFoundLeg* leg )
{
	int32_t depth = INT32_MAX;
	int32_t count = 0;
	soleVec3 middle = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		const soleJointName* name = detect->names + i;
		bool isToe = detect->ints[i] > 0 && name->part == sole_partToe && name->end == false;
		if ( isToe == false || ( leg->sideFromName && name->side != leg->side ) || detect->ints[i] > depth )
		{
			continue;
		}
		if ( detect->ints[i] < depth )
		{
			depth = detect->ints[i];
			count = 0;
			middle = soleVec( 0.0f, 0.0f, 0.0f );
		}
		middle = soleAdd( middle, detect->position[i] );
		count += 1;
	}
	if ( count == 0 )
	{
		return SOLE_NONE;
	}
	middle = soleScale( 1.0f / (float)count, middle );
	int32_t best = SOLE_NONE;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		const soleJointName* name = detect->names + i;
		if ( detect->ints[i] == depth && name->part == sole_partToe && name->end == false &&
		    ( leg->sideFromName == false || name->side == leg->side ) &&
		    ( best == SOLE_NONE ||
		        soleDistance( detect->position[i], middle ) < soleDistance( detect->position[best], middle ) ) )
		{
			best = i;
		}
	}
	return best;
}

/// The child that lies furthest along the floor from the ankle, heels left out.
static int32_t soleFindFarChild( const soleDetect* detect, int32_t joint, soleVec3 from, float least )
{
	int32_t best = SOLE_NONE;
	float bestReach = least;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		if ( detect->parents[i] != joint || detect->names[i].control || detect->names[i].part == sole_partOther )
		{
			continue;
		}
		float reach = soleLength( soleReject( soleSub( detect->position[i], from ), detect->up ) );
		if ( reach > bestReach )
		{
			best = i;
			bestReach = reach;
		}
	}
	return best;
}

/// A joint that only tells where the toes end: so named, or without a say in the skin and without children.
static bool soleIsEnd( const soleDetect* detect, int32_t joint )
{
	if ( detect->names[joint].end )
	{
		return true;
	}
	if ( detect->names[joint].part == sole_partToe || detect->childCount[joint] > 0 )
	{
		return false;
	}
	return detect->dominant != NULL && detect->skinnedCount[joint] == 0;
}

void soleFindToes( soleDetect* detect, int32_t index )
{
	soleFoundLeg* leg = detect->legs + index;
	if ( leg->hasVirtualAnkle && leg->detachedFoot == SOLE_NONE )
	{
		return;
	}
	int32_t foot = soleFoundLeg_GetFoot( leg );
	soleVec3 ankle = detect->position[foot];
	float least = 0.01f * leg->length;
	int32_t toe = leg->toeCount > 0 ? leg->toes[0] : SOLE_NONE;
	if ( toe == SOLE_NONE )
	{
		soleMarkBelow( detect, foot );
		toe = soleFindNamedToe( detect, leg );
	}
	toe = toe != SOLE_NONE ? toe : soleFindFarChild( detect, foot, ankle, least );
	leg->toeCount = 0;
	while ( toe != SOLE_NONE )
	{
		if ( soleIsEnd( detect, toe ) || leg->toeCount == SOLE_MAX_TOE_JOINTS )
		{
			leg->tip = toe;
			break;
		}
		leg->toes[leg->toeCount++] = toe;
		float reach = soleLength( soleReject( soleSub( detect->position[toe], ankle ), detect->up ) );
		toe = soleFindFarChild( detect, toe, ankle, reach + least );
	}
}
