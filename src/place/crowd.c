// SPDX-License-Identifier: MIT
// Crowd: many characters of one rig, who comes and goes, what is saved. crowd_frame.c has what is done every frame.
#include "sole/crowd.h"

#include "base/core.h"
#include "place/crowd_internal.h"

#include <string.h>

#define MOST_CHARACTERS 1048576
#define SLOT_BITS 20 // of an id; the rest counts how often its slot was used
#define SLEEP 0.3f   // s

// ---------------------------------------------------------------------------------------------------------- create

soleSettings soleLowerDetail( const soleSettings* settings, soleDetail detail )
{
	soleSettings lower = *settings;
	if ( detail != sole_detailFull )
	{
		lower.probe.layout = sole_probeSingle;
		lower.probe.sleep = settings->probe.sleep > 0.0f ? soleMinF( settings->probe.sleep, SLEEP ) : SLEEP;
		lower.foothold.shift = 0.0f;
	}
	lower.target.align = detail == sole_detailHeight ? 0.0f : settings->target.align;
	return lower;
}

soleCrowdDef soleDefaultCrowdDef( void )
{
	return ( soleCrowdDef ){ .capacity = 64, .settings = soleDefaultSettings(), .internalValue = SOLE_COOKIE };
}

static soleResult soleCheckCrowdDef( const soleCrowdDef* def, soleMessage* message )
{
	if ( def == NULL || def->internalValue != SOLE_COOKIE )
	{
		soleSetMessage( message, "the definition was not made by soleDefaultCrowdDef(): start from that" );
		return sole_invalidDefinition;
	}
	if ( def->rig == NULL )
	{
		soleSetMessage( message, "rig is NULL: create one with soleCreateRig()" );
		return sole_invalidDefinition;
	}
	if ( def->capacity < 1 || def->capacity > MOST_CHARACTERS )
	{
		soleSetMessage( message, "capacity is %d: from 1 to %d", def->capacity, MOST_CHARACTERS );
		return sole_invalidDefinition;
	}
	return sole_success;
}

static void soleFreeAllSlots( soleCrowd* crowd )
{
	soleCrowdHead* head = soleHead( crowd );
	*head = ( soleCrowdHead ){ .size = (uint64_t)crowd->blockSize };
	for ( int32_t i = 0; i < crowd->capacity; ++i )
	{
		*soleSlotOf( crowd, (uint32_t)i ) = ( soleCrowdSlot ){ .index = i + 1 < crowd->capacity ? i + 1 : SOLE_NONE };
	}
}

soleResult soleCreateCrowd(
    const soleCrowdDef* def, const soleAllocator* allocator, soleCrowd** crowd, soleMessage* message )
{
	SOLE_ASSERT( crowd != NULL );
	if ( crowd == NULL )
	{
		return sole_invalidDefinition;
	}
	*crowd = NULL;
	soleResult result = soleCheckCrowdDef( def, message );
	soleCrowd* made = result == sole_success ? soleAlloc( allocator, sizeof *made ) : NULL;
	if ( made == NULL )
	{
		return result == sole_success ? sole_outOfMemory : result;
	}
	made->rig = def->rig;
	made->capacity = def->capacity;
	made->stateStride = soleRoundUp( soleState_GetByteCount( def->rig ) );
	size_t legs = (size_t)def->rig->legCount;
	made->outputStride = soleRoundUp( offsetof( soleOutput, legs ) + legs * sizeof( soleLegOutput ) );
	made->turnStride = soleRoundUp( legs * sizeof( soleCrowdTurns ) );
	made->workStride = soleRoundUp( soleBegunLegsAt( made ) + legs * sizeof( soleLegWork ) );
	made->blockSize = soleTurnsAt( made ) + (size_t)made->capacity * made->turnStride;
	made->allocated = made->blockSize + SOLE_LINE;
	made->memory = soleAlloc( allocator, made->allocated );
	if ( made->memory == NULL )
	{
		soleFree( allocator, made, sizeof *made );
		soleSetMessage( message, "there is no memory for %d characters", def->capacity );
		return sole_outOfMemory;
	}
	made->hasAllocator = allocator != NULL;
	made->allocator = allocator != NULL ? *allocator : made->allocator;
	made->block = (unsigned char*)made->memory + ( SOLE_LINE - (size_t)( (uintptr_t)made->memory % SOLE_LINE ) );
	soleFreeAllSlots( made );
	soleCrowd_SetSettings( made, &def->settings );
	*crowd = made;
	return sole_success;
}

void soleDestroyCrowd( soleCrowd* crowd )
{
	if ( crowd != NULL )
	{
		soleAllocator allocator = crowd->allocator;
		const soleAllocator* its = crowd->hasAllocator ? &allocator : NULL;
		soleFree( its, crowd->memory, crowd->allocated );
		soleFree( its, crowd, sizeof *crowd );
	}
}

// ------------------------------------------------------------------------------------------------------- characters

static soleCrowdId soleMakeId( const soleCrowd* crowd, uint32_t slot )
{
	return soleSlotOf( crowd, slot )->uses << SLOT_BITS | slot;
}

/// Nothing has been turned yet.
static void soleForgetTurns( const soleCrowd* crowd, int32_t index )
{
	soleQuat none = soleQuat_Identity();
	for ( int32_t i = 0; i < crowd->rig->legCount; ++i )
	{
		soleCrowdTurns* turns = soleTurnsOf( crowd, index ) + i;
		*turns = ( soleCrowdTurns ){ .toe = none, .foot = none };
		for ( int32_t j = 0; j < SOLE_MAX_LEG_JOINTS; ++j )
		{
			turns->joints[j] = none;
		}
	}
}

soleCrowdId soleAddToCrowd( soleCrowd* crowd )
{
	SOLE_ASSERT( crowd != NULL );
	if ( crowd == NULL || soleHead( crowd )->freeSlot == SOLE_NONE )
	{
		return SOLE_NO_CHARACTER;
	}
	soleCrowdHead* head = soleHead( crowd );
	uint32_t name = (uint32_t)head->freeSlot;
	soleCrowdSlot* slot = soleSlotOf( crowd, name );
	int32_t index = head->count++;
	head->freeSlot = slot->index;
	// Counted in what is left of an id, and never zero: no id is zero.
	uint32_t uses = ( slot->uses + 1u ) & ( UINT32_MAX >> SLOT_BITS );
	*slot = ( soleCrowdSlot ){ .uses = uses > 0u ? uses : 1u, .index = index, .used = true };
	*soleRowOf( crowd, index ) = ( soleCrowdRow ){ .member = { .interval = 1 }, .slot = name };
	memset( soleOutputOf( crowd, index ), 0, crowd->outputStride );
	soleForgetTurns( crowd, index );
	soleState state = soleDefaultState( crowd->rig );
	memcpy( soleStateOf( crowd, index ), &state, soleState_GetByteCount( crowd->rig ) );
	return soleMakeId( crowd, name );
}

int32_t soleCrowd_GetIndex( const soleCrowd* crowd, soleCrowdId id )
{
	SOLE_ASSERT( crowd != NULL );
	uint32_t slot = id & ( ( 1u << SLOT_BITS ) - 1u );
	if ( crowd == NULL || slot >= (uint32_t)crowd->capacity || soleSlotOf( crowd, slot )->used == false )
	{
		return SOLE_NONE;
	}
	return soleMakeId( crowd, slot ) == id ? soleSlotOf( crowd, slot )->index : SOLE_NONE;
}

bool soleRemoveFromCrowd( soleCrowd* crowd, soleCrowdId id )
{
	int32_t index = soleCrowd_GetIndex( crowd, id );
	if ( index == SOLE_NONE )
	{
		return false;
	}
	soleCrowdHead* head = soleHead( crowd );
	uint32_t freed = soleRowOf( crowd, index )->slot;
	int32_t last = --head->count;
	if ( index != last )
	{
		*soleRowOf( crowd, index ) = *soleRowOf( crowd, last );
		memcpy( soleStateOf( crowd, index ), soleStateOf( crowd, last ), crowd->stateStride );
		memcpy( soleOutputOf( crowd, index ), soleOutputOf( crowd, last ), crowd->outputStride );
		memcpy( soleTurnsOf( crowd, index ), soleTurnsOf( crowd, last ), crowd->turnStride );
		soleSlotOf( crowd, soleRowOf( crowd, index )->slot )->index = index;
	}
	soleCrowdSlot* slot = soleSlotOf( crowd, freed );
	slot->used = false;
	slot->index = head->freeSlot;
	head->freeSlot = (int32_t)freed;
	return true;
}

int32_t soleCrowd_GetCount( const soleCrowd* crowd )
{
	SOLE_ASSERT( crowd != NULL );
	return crowd != NULL ? soleHead( crowd )->count : 0;
}

size_t soleCrowd_GetWorkSize( const soleCrowd* crowd, int32_t count )
{
	SOLE_ASSERT( crowd != NULL );
	return crowd != NULL && count > 0 ? (size_t)count * crowd->workStride : 0;
}

int32_t soleCrowd_GetCapacity( const soleCrowd* crowd )
{
	SOLE_ASSERT( crowd != NULL );
	return crowd != NULL ? crowd->capacity : 0;
}

soleCrowdId soleCrowd_GetId( const soleCrowd* crowd, int32_t index )
{
	return soleIsIndex( crowd, index ) ? soleMakeId( crowd, soleRowOf( crowd, index )->slot ) : SOLE_NO_CHARACTER;
}

soleCrowdMember* soleCrowd_GetMember( soleCrowd* crowd, int32_t index )
{
	return soleIsIndex( crowd, index ) ? &soleRowOf( crowd, index )->member : NULL;
}

const soleOutput* soleCrowd_GetOutput( const soleCrowd* crowd, int32_t index )
{
	return soleIsIndex( crowd, index ) ? soleOutputOf( crowd, index ) : NULL;
}

soleState* soleCrowd_GetState( soleCrowd* crowd, int32_t index )
{
	return soleIsIndex( crowd, index ) ? soleStateOf( crowd, index ) : NULL;
}

void soleCrowd_SetSettings( soleCrowd* crowd, const soleSettings* settings )
{
	SOLE_ASSERT( crowd != NULL );
	if ( crowd != NULL )
	{
		soleSettings scratch;
		const soleSettings* clean = soleCleanSettings( crowd->rig, settings, &scratch );
		for ( int32_t i = 0; i < SOLE_DETAILS; ++i )
		{
			crowd->settings[i] = soleLowerDetail( clean, (soleDetail)i );
		}
	}
}

// --------------------------------------------------------------------------------------------------- save, restore

size_t soleCrowd_GetByteCount( const soleCrowd* crowd )
{
	SOLE_ASSERT( crowd != NULL );
	return crowd != NULL ? crowd->blockSize : 0;
}

void soleSaveCrowd( const soleCrowd* crowd, void* block )
{
	SOLE_ASSERT( crowd != NULL && block != NULL );
	if ( crowd != NULL && block != NULL )
	{
		memcpy( block, crowd->block, crowd->blockSize );
	}
}

bool soleRestoreCrowd( soleCrowd* crowd, const void* block, size_t byteCount )
{
	SOLE_ASSERT( crowd != NULL && block != NULL );
	if ( crowd == NULL || block == NULL || byteCount != crowd->blockSize )
	{
		return false;
	}
	soleCrowdHead head;
	memcpy( &head, block, sizeof head );
	if ( head.size != (uint64_t)crowd->blockSize || head.count < 0 || head.count > crowd->capacity )
	{
		return false;
	}
	memcpy( crowd->block, block, crowd->blockSize );
	return true;
}
