// SPDX-License-Identifier: MIT
// The same for many characters of one rig: memory of their own in one block, gathering and solving over ranges for the
// host's own jobs, only the probes that are needed, and levels of detail for those far away. What comes out is, to the
// bit, what the calls of sole.h give for each of them alone.
//
// Characters stand in a row without gaps: index 0 to count - 1. Removing one moves the last to its place; an id stays.
// Calls over ranges that do not overlap may run at the same time. Nothing allocates but soleCreateCrowd().
#ifndef SOLE_CROWD_H
#define SOLE_CROWD_H

#include "sole/sole.h"

/// Names a character for as long as it is in its crowd, and no other after it for a long time.
typedef uint32_t soleCrowdId;

/// No character.
#define SOLE_NO_CHARACTER 0u

/// How much is done for a character.
typedef enum soleDetail
{
	sole_detailFull = 0,   // what its settings say
	sole_detailFew = 1,    // one probe a foot; one that stands asks less often
	sole_detailHeight = 2, // the same, and feet take up the height of the ground but not its slope
	sole_detailForce32 = 0x7fffffff
} soleDetail;

/// What a host may change of a character between frames.
typedef struct soleCrowdMember
{
	/// In place of the crowd's. Kept as a pointer. NULL: the crowd's.
	const soleSettings* settings;
	soleDetail detail;
	/// It is solved in every n-th frame; in between its feet are as far from the animation as they were. Which of n
	/// frames goes by its id, so that a crowd's work is spread. What is older than 0.3 s is forgotten. [1, 16] default
	/// 1
	int32_t interval;
} soleCrowdMember;

/// Start from soleDefaultCrowdDef().
typedef struct soleCrowdDef
{
	const soleRig* rig; // has to live as long as the crowd
	int32_t capacity;   // most characters at a time [1, 1048576] default 64
	soleSettings settings;

	/// Tells a filled definition from a forgotten one. Do not set.
	int32_t internalValue;
} soleCrowdDef;

typedef struct soleCrowd soleCrowd;

/// What a character asks in a frame.
typedef struct soleCrowdAsk
{
	int32_t first; // of its probes
	int32_t count;
	/// It is not solved in this frame: it is not its turn, or no room was left for its probes.
	bool waits;
} soleCrowdAsk;

SOLE_API soleCrowdDef soleDefaultCrowdDef( void );

/// @param allocator NULL: malloc and free.
/// @param crowd set to NULL on failure.
/// @param message what is wrong and how to mend it. May be NULL.
SOLE_API soleResult soleCreateCrowd(
    const soleCrowdDef* def, const soleAllocator* allocator, soleCrowd** crowd, soleMessage* message );
/// NULL is allowed.
SOLE_API void soleDestroyCrowd( soleCrowd* crowd );

// ------------------------------------------------------------------------------------------------------- characters

/// A new character at the end of the row, nothing remembered. O(1).
/// @return SOLE_NO_CHARACTER where the crowd is full
SOLE_API soleCrowdId soleAddToCrowd( soleCrowd* crowd );
/// O(1). @return false: there is none of that id
SOLE_API bool soleRemoveFromCrowd( soleCrowd* crowd, soleCrowdId id );
SOLE_API int32_t soleCrowd_GetCount( const soleCrowd* crowd );
SOLE_API int32_t soleCrowd_GetCapacity( const soleCrowd* crowd );
/// @return SOLE_NONE: there is none of that id
SOLE_API int32_t soleCrowd_GetIndex( const soleCrowd* crowd, soleCrowdId id );
/// @return SOLE_NO_CHARACTER where the index is out of range
SOLE_API soleCrowdId soleCrowd_GetId( const soleCrowd* crowd, int32_t index );
/// For reading and changing. NULL where the index is out of range. Moves when a character is removed.
SOLE_API soleCrowdMember* soleCrowd_GetMember( soleCrowd* crowd, int32_t index );
/// Settings of all characters that have none of their own.
SOLE_API void soleCrowd_SetSettings( soleCrowd* crowd, const soleSettings* settings );

// ------------------------------------------------------------------------------------------------------ every frame

/// Most probes that a character of this crowd may ask in a frame.
SOLE_API int32_t soleCrowd_GetMostProbes( const soleCrowd* crowd );

/// Bytes of a work area for ranges of at most so many characters. A few KB each: with small ranges it stays in a cache.
SOLE_API size_t soleCrowd_GetWorkSize( const soleCrowd* crowd, int32_t count );

/// What the characters [first, first + count) ask of the ground, without those probes that need not be cast. A
/// character for whose probes there is no room waits; who is asked first goes round from frame to frame, so none waits
/// for long: capacity is the budget of a frame.
/// @param frames of the range's characters: frames[0] is that of the character first.
/// @param asks filled, as many as frames.
/// @param work of soleCrowd_GetWorkSize() bytes, aligned as by malloc(): what gathering has found out is left there for
/// solving the same frames, which need not begin them again. A thread has its own. NULL: solving begins anew.
/// @return how many probes were written, at most capacity.
SOLE_API int32_t soleGatherCrowd( const soleCrowd* crowd, int32_t first, int32_t count, const soleFrame* frames,
    soleProbe* probes, int32_t capacity, soleCrowdAsk* asks, void* work );

/// Places the feet of the range's characters. Those that wait keep what their feet are off the animation by.
/// @param probes as gathered; hits their answers in the same order.
/// @param work of the same range's gathering, where since then neither the crowd nor frames and poses were changed.
/// NULL: frames are begun anew, as for answers that come in a later one.
SOLE_API void soleSolveCrowd( soleCrowd* crowd, int32_t first, int32_t count, const soleFrame* frames,
    const soleProbe* probes, const soleHit* hits, const soleCrowdAsk* asks, void* work );

/// Of the last frame. Legs beyond the rig's are not there: read no more than legCount of them. NULL where the index is
/// out of range.
SOLE_API const soleOutput* soleCrowd_GetOutput( const soleCrowd* crowd, int32_t index );
/// What is remembered of a character: as much of a state as soleState_GetByteCount() says. NULL where the index is out
/// of range.
SOLE_API soleState* soleCrowd_GetState( soleCrowd* crowd, int32_t index );

// --------------------------------------------------------------------------------------------------- save, restore

/// All that changes in a crowd, as one block of bytes, for the same process: it holds the pointers of members.
SOLE_API size_t soleCrowd_GetByteCount( const soleCrowd* crowd );
SOLE_API void soleSaveCrowd( const soleCrowd* crowd, void* block );
/// @return false: the block is not one of this crowd, nothing was changed
SOLE_API bool soleRestoreCrowd( soleCrowd* crowd, const void* block, size_t byteCount );

#endif
