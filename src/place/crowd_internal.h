// SPDX-License-Identifier: MIT
// How a crowd lies in memory. One block holds all that changes: a head, then a row for each kind of data, so that
// saving and restoring is a copy. A character's row, memory and output begin on cache lines of their own: two threads
// never write to one.
#ifndef SOLE_PLACE_CROWD_INTERNAL_H
#define SOLE_PLACE_CROWD_INTERNAL_H

#include "place/place.h"
#include "rig/rig.h"
#include "sole/crowd.h"

#define SOLE_DETAILS 3
#define SOLE_LINE ( (size_t)64 )

/// What a character has in its row beside memory and output.
typedef struct soleCrowdRow
{
	soleCrowdMember member;
	uint32_t slot;        // names it
	uint32_t frames;      // that went by since it was added
	float owed;           // time that went by since it was solved, s
	bool jumped;          // was moved by a jump in the meantime
	bool fresh;           // has not waited since it was solved
	soleVec3 pelvisMoved; // when it was, parent-local
} soleCrowdRow;

/// A name, in use or not.
typedef struct soleCrowdSlot
{
	uint32_t uses; // how often it was given
	int32_t index; // of the character, or of the next free slot
	bool used;
} soleCrowdSlot;

/// What waiting characters' joints are turned by; until one waits, how they were animated when it was solved.
typedef struct soleCrowdTurns
{
	soleQuat joints[SOLE_MAX_LEG_JOINTS];
	soleQuat toe;
	soleQuat foot;
	soleVec3 footMoved; // or animated place
} soleCrowdTurns;

/// A character's part of a work area: the frame that gathering began for solving. The rest of the memory that its frame
/// works on comes next, then slots, then legs.
typedef struct soleCrowdBegun
{
	solePlaceWork work;
	soleFrame frame;       // as long as it has waited
	soleSettings settings; // where it has its own
	soleState state;       // as much of it as is in use
} soleCrowdBegun;

struct soleCrowd
{
	soleAllocator allocator;
	bool hasAllocator;
	const soleRig* rig;
	int32_t capacity;
	soleSettings settings[SOLE_DETAILS]; // cleaned

	size_t stateStride;
	size_t outputStride;
	size_t turnStride;
	size_t workStride;
	size_t blockSize;
	size_t allocated;
	unsigned char* block; // what is saved
	void* memory;         // what was allocated for it
};

/// The block's beginning.
typedef struct soleCrowdHead
{
	uint64_t size; // of the block: tells one of this crowd
	int32_t count;
	int32_t freeSlot; // SOLE_NONE: all are used
} soleCrowdHead;

static inline size_t soleRoundUp( size_t size )
{
	return ( size + SOLE_LINE - 1 ) / SOLE_LINE * SOLE_LINE;
}

static inline soleCrowdHead* soleHead( const soleCrowd* crowd )
{
	return (soleCrowdHead*)crowd->block;
}

static inline size_t soleSlotsAt( void )
{
	return soleRoundUp( sizeof( soleCrowdHead ) );
}

static inline size_t soleRowsAt( const soleCrowd* crowd )
{
	return soleSlotsAt() + soleRoundUp( (size_t)crowd->capacity * sizeof( soleCrowdSlot ) );
}

static inline size_t soleStatesAt( const soleCrowd* crowd )
{
	return soleRowsAt( crowd ) + soleRoundUp( (size_t)crowd->capacity * soleRoundUp( sizeof( soleCrowdRow ) ) );
}

static inline size_t soleOutputsAt( const soleCrowd* crowd )
{
	return soleStatesAt( crowd ) + (size_t)crowd->capacity * crowd->stateStride;
}

static inline size_t soleTurnsAt( const soleCrowd* crowd )
{
	return soleOutputsAt( crowd ) + (size_t)crowd->capacity * crowd->outputStride;
}

static inline soleCrowdSlot* soleSlotOf( const soleCrowd* crowd, uint32_t slot )
{
	return (soleCrowdSlot*)( crowd->block + soleSlotsAt() ) + slot;
}

static inline soleCrowdRow* soleRowOf( const soleCrowd* crowd, int32_t index )
{
	return (
	    soleCrowdRow*)( crowd->block + soleRowsAt( crowd ) + (size_t)index * soleRoundUp( sizeof( soleCrowdRow ) ) );
}

static inline soleState* soleStateOf( const soleCrowd* crowd, int32_t index )
{
	return (soleState*)( crowd->block + soleStatesAt( crowd ) + (size_t)index * crowd->stateStride );
}

static inline soleOutput* soleOutputOf( const soleCrowd* crowd, int32_t index )
{
	return (soleOutput*)( crowd->block + soleOutputsAt( crowd ) + (size_t)index * crowd->outputStride );
}

static inline soleCrowdTurns* soleTurnsOf( const soleCrowd* crowd, int32_t index )
{
	return (soleCrowdTurns*)( crowd->block + soleTurnsAt( crowd ) + (size_t)index * crowd->turnStride );
}

static inline size_t soleBegunSlotsAt( const soleCrowd* crowd )
{
	return soleRoundUp( offsetof( soleCrowdBegun, state ) + soleState_GetByteCount( crowd->rig ) );
}

static inline size_t soleBegunLegsAt( const soleCrowd* crowd )
{
	return soleRoundUp( soleBegunSlotsAt( crowd ) + (size_t)crowd->rig->slotCount * sizeof( soleTransform ) );
}

/// Character k of a range in its work area.
static inline soleCrowdBegun* soleBegunOf( const soleCrowd* crowd, void* work, int32_t k )
{
	return (soleCrowdBegun*)( (unsigned char*)work + (size_t)k * crowd->workStride );
}

static inline bool soleIsIndex( const soleCrowd* crowd, int32_t index )
{
	return crowd != NULL && index >= 0 && index < soleHead( crowd )->count;
}

/// A level of detail of some settings.
soleSettings soleLowerDetail( const soleSettings* settings, soleDetail detail );

#endif
