// SPDX-License-Identifier: MIT
// A crowd's frame: gathering and solving over a range of characters, each by the same stages as one alone.
//
// A character that waits is not solved. Its joints get, after the animation of the frame, the turns that they got after
// the animation of the last frame that was solved, and its pelvis the same movement:
//   d = conj( animated ) placed, then; placed = animated d, now
// When it is solved again its frame is as long as it has waited.
#include "base/core.h"
#include "place/crowd_internal.h"
#include "sole/batch.h"

#include <string.h>

#define MOST_INTERVAL 16
#define BLOCK 16           // characters: the legs of as many bipeds go through a kernel at once
#define GOLDEN 2654435769u // 2^32 times the golden ratio's fraction: its multiples are spread evenly at any time

/// A character's settings of this frame.
static const soleSettings* soleSettingsOf( const soleCrowd* crowd, const soleCrowdRow* row, soleSettings* scratch )
{
	soleDetail detail = row->member.detail;
	detail = detail == sole_detailFew || detail == sole_detailHeight ? detail : sole_detailFull;
	if ( row->member.settings == NULL )
	{
		return crowd->settings + detail;
	}
	soleSettings changed;
	*scratch = soleLowerDetail( soleCleanSettings( crowd->rig, row->member.settings, &changed ), detail );
	return scratch;
}

// ----------------------------------------------------------------------------------------------------------- gather

int32_t soleCrowd_GetMostProbes( const soleCrowd* crowd )
{
	SOLE_ASSERT( crowd != NULL );
	return crowd != NULL ? crowd->rig->legCount * SOLE_MAX_PROBES_PER_LEG : 0;
}

/// Every interval-th frame; the first one, and one after a jump, always.
static bool soleIsItsTurn( const soleCrowdRow* row, const soleFrame* frame )
{
	int32_t interval = row->member.interval;
	interval = interval < 1 ? 1 : ( interval > MOST_INTERVAL ? MOST_INTERVAL : interval );
	return row->frames == 0 || frame->teleport || ( row->frames + row->slot ) % (uint32_t)interval == 0;
}

/// The frame of a character that may have waited: as long as it has, and all that happened.
static soleFrame soleFrameOf( const soleCrowdRow* row, const soleFrame* frame )
{
	soleFrame longer = *frame;
	longer.timeStep =
	    row->owed > 0.0f ? row->owed + soleMaxF( soleFiniteOr( frame->timeStep, 0.0f ), 0.0f ) : frame->timeStep;
	longer.teleport = frame->teleport || row->jumped;
	return longer;
}

/// Begins the frame of a character on a copy of its memory.
static void soleBeginOne( const soleCrowd* crowd, int32_t index, const soleSettings* settings, const soleFrame* frame,
    solePlaceWork* work, soleState* copy )
{
	memcpy( copy, soleStateOf( crowd, index ), soleState_GetByteCount( crowd->rig ) );
	soleBeginFrame( work, crowd->rig, settings, copy, frame, soleOutputOf( crowd, index ) );
}

/// @return how many probes were written, SOLE_NONE: there is no room for them
static int32_t soleAskForOne( const solePlaceWork* work, soleProbe* probes, int32_t capacity )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		count += soleAskGround( work, work->legs + i, probes + count, capacity - count );
		if ( count > capacity )
		{
			return SOLE_NONE;
		}
	}
	return count;
}

/// A character's part of a work area, made ready for beginning its frame there.
static soleCrowdBegun* soleOpenBegun( const soleCrowd* crowd, void* work, int32_t k )
{
	soleCrowdBegun* begun = soleBegunOf( crowd, work, k );
	begun->work.slots = (soleTransform*)( (unsigned char*)begun + soleBegunSlotsAt( crowd ) );
	begun->work.legs = (soleLegWork*)( (unsigned char*)begun + soleBegunLegsAt( crowd ) );
	return begun;
}

/// @param begun its part of a work area, or NULL
static int32_t soleGatherOne( const soleCrowd* crowd, int32_t index, const soleFrame* frame, soleProbe* probes,
    int32_t capacity, soleCrowdBegun* begun )
{
	const soleCrowdRow* row = soleRowOf( crowd, index );
	soleFrame longer = soleFrameOf( row, frame );
	if ( !soleIsFrameUsable( &longer ) )
	{
		return 0;
	}
	if ( begun != NULL )
	{
		begun->frame = longer;
		const soleSettings* settings = soleSettingsOf( crowd, row, &begun->settings );
		soleBeginOne( crowd, index, settings, &begun->frame, &begun->work, &begun->state );
		return soleAskForOne( &begun->work, probes, capacity );
	}
	soleSettings scratch;
	const soleSettings* settings = soleSettingsOf( crowd, row, &scratch );
	soleState copy;
	solePlaceRoom room;
	solePlaceWork work = soleWorkIn( &room );
	soleBeginOne( crowd, index, settings, &longer, &work, &copy );
	return soleAskForOne( &work, probes, capacity );
}

/// Who of the range is asked first in a frame.
static int32_t soleFindTurn( uint32_t frame, int32_t count )
{
	return (int32_t)( ( (uint64_t)( frame * GOLDEN ) * (uint64_t)count ) >> 32 );
}

int32_t soleGatherCrowd( const soleCrowd* crowd, int32_t first, int32_t count, const soleFrame* frames,
    soleProbe* probes, int32_t capacity, soleCrowdAsk* asks, void* work )
{
	bool given = count <= 0 ||
	    ( soleIsIndex( crowd, first ) && soleIsIndex( crowd, first + count - 1 ) && frames != NULL && asks != NULL &&
	        ( probes != NULL || capacity <= 0 ) );
	SOLE_ASSERT( given );
	int32_t written = 0;
	int32_t turn = given && count > 0 ? soleFindTurn( soleRowOf( crowd, first )->frames, count ) : 0;
	for ( int32_t i = 0; given && i < count; ++i )
	{
		int32_t k = turn + i < count ? turn + i : turn + i - count;
		asks[k] = ( soleCrowdAsk ){ .first = written, .waits = true };
		if ( soleIsItsTurn( soleRowOf( crowd, first + k ), frames + k ) )
		{
			soleCrowdBegun* begun = work != NULL ? soleOpenBegun( crowd, work, k ) : NULL;
			int32_t asked = soleGatherOne( crowd, first + k, frames + k, probes + written, capacity - written, begun );
			asks[k].waits = asked == SOLE_NONE;
			asks[k].count = asked == SOLE_NONE ? 0 : asked;
			written += asks[k].count;
		}
	}
	return written;
}

// ------------------------------------------------------------------------------------------------------------ wait

static soleQuat soleTurnSince( soleQuat animated, soleQuat placed )
{
	return soleMulQuat( soleConjugate( soleNormalizeQuat( animated ) ), placed );
}

static soleQuat soleTurnOn( soleQuat animated, soleQuat turn )
{
	return soleNormalizeQuat( soleMulQuat( soleNormalizeQuat( animated ), turn ) );
}

/// Remembers how a solved frame was animated. By how much it was turned is only asked when it waits.
static void soleKeepAnimated( const soleCrowd* crowd, int32_t index, const soleFrame* frame )
{
	const soleRig* rig = crowd->rig;
	soleCrowdRow* row = soleRowOf( crowd, index );
	row->fresh = true;
	row->pelvisMoved =
	    soleSub( soleOutputOf( crowd, index )->pelvisTranslation_l, frame->pose[rig->pelvis].translation );
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		const soleLegDef* leg = &rig->legs[i].def;
		soleCrowdTurns* turns = soleTurnsOf( crowd, index ) + i;
		for ( int32_t j = 0; j < leg->jointCount; ++j )
		{
			turns->joints[j] = frame->pose[leg->joints[j]].rotation;
		}
		if ( leg->toeCount > 0 )
		{
			turns->toe = frame->pose[leg->toes[0]].rotation;
		}
		if ( leg->detachedFoot != SOLE_NONE )
		{
			turns->foot = frame->pose[leg->detachedFoot].rotation;
			turns->footMoved = frame->pose[leg->detachedFoot].translation;
		}
	}
}

/// What the last solved frame has turned, of how it was animated and placed: before its output is written over.
static void soleFindTurns( const soleCrowd* crowd, int32_t index )
{
	const soleRig* rig = crowd->rig;
	soleCrowdRow* row = soleRowOf( crowd, index );
	bool fresh = row->fresh;
	row->fresh = false;
	for ( int32_t i = 0; i < rig->legCount && fresh; ++i )
	{
		const soleLegDef* leg = &rig->legs[i].def;
		const soleLegOutput* o = soleOutputOf( crowd, index )->legs + i;
		soleCrowdTurns* turns = soleTurnsOf( crowd, index ) + i;
		for ( int32_t j = 0; j < leg->jointCount; ++j )
		{
			turns->joints[j] = soleTurnSince( turns->joints[j], o->rotations_l[j] );
		}
		if ( leg->toeCount > 0 )
		{
			turns->toe = soleTurnSince( turns->toe, o->toeRotation_l );
		}
		if ( leg->detachedFoot != SOLE_NONE )
		{
			turns->foot = soleTurnSince( turns->foot, o->footRotation_l );
			turns->footMoved = soleSub( o->footTranslation_l, turns->footMoved );
		}
	}
}

/// The animation of this frame with what the last solved one has turned and moved.
static void soleWait( soleCrowd* crowd, int32_t index, const soleFrame* frame )
{
	const soleRig* rig = crowd->rig;
	soleOutput* out = soleOutputOf( crowd, index );
	soleFindTurns( crowd, index );
	out->legCount = rig->legCount;
	out->pelvisTranslation_l = soleAdd( frame->pose[rig->pelvis].translation, soleRowOf( crowd, index )->pelvisMoved );
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		const soleLegDef* leg = &rig->legs[i].def;
		soleLegOutput* o = out->legs + i;
		const soleCrowdTurns* turns = soleTurnsOf( crowd, index ) + i;
		for ( int32_t j = 0; j < leg->jointCount; ++j )
		{
			o->rotations_l[j] = soleTurnOn( frame->pose[leg->joints[j]].rotation, turns->joints[j] );
		}
		if ( leg->toeCount > 0 )
		{
			o->toeRotation_l = soleTurnOn( frame->pose[leg->toes[0]].rotation, turns->toe );
		}
		if ( leg->detachedFoot != SOLE_NONE )
		{
			soleTransform foot = frame->pose[leg->detachedFoot];
			o->footRotation_l = soleTurnOn( foot.rotation, turns->foot );
			o->footTranslation_l = soleAdd( foot.translation, turns->footMoved );
		}
		o->stretch = o->stretch > 0.0f ? o->stretch : 1.0f;
	}
	soleScrubOutput( rig, out );
}

// ----------------------------------------------------------------------------------------------------------- solve

/// The answers by leg.
static soleLegHits soleSortHits( const soleRig* rig, const soleProbe* probes, const soleHit* hits, int32_t hitCount )
{
	soleLegHits byLeg = { .hits = hits };
	for ( int32_t i = 0, k = 0; i <= rig->legCount; ++i )
	{
		while ( k < hitCount && probes[k].leg < i )
		{
			++k;
		}
		byLeg.starts[i] = k;
	}
	return byLeg;
}

/// Characters whose legs go side by side.
typedef struct soleCrowdBlock
{
	int32_t count;
	int32_t indices[BLOCK];
	solePlaceWork* works[BLOCK];
	soleLegHits hits[BLOCK];
} soleCrowdBlock;

/// Ends the frames of a block, which is empty then.
static void soleSolveBlock( const soleCrowd* crowd, soleCrowdBlock* block )
{
	// Of one after the other: what the ground was like at each place is not asked for when the legs are solved.
	soleGroundSample samples[SOLE_MAX_LEGS][SOLE_MAX_PROBES_PER_LEG];
	for ( int32_t i = 0; i < block->count; ++i )
	{
		block->works[i]->samples = samples;
	}
	soleEndFrames( block->works, block->hits, block->count, soleGetBatchWidth() );
	for ( int32_t i = 0; i < block->count; ++i )
	{
		int32_t index = block->indices[i];
		memcpy( soleStateOf( crowd, index ), block->works[i]->state, soleState_GetByteCount( crowd->rig ) );
		soleKeepAnimated( crowd, index, block->works[i]->frame );
	}
	block->count = 0;
}

/// Begins anew, and ends, the frame of one.
static void soleSolveAnew( const soleCrowd* crowd, int32_t index, const soleFrame* frame, const soleLegHits* hits )
{
	soleSettings scratch;
	const soleSettings* settings = soleSettingsOf( crowd, soleRowOf( crowd, index ), &scratch );
	solePlaceRoom room;
	solePlaceWork work = soleWorkIn( &room );
	soleBeginFrame( &work, crowd->rig, settings, soleStateOf( crowd, index ), frame, soleOutputOf( crowd, index ) );
	soleEndFrame( &work, hits );
	soleKeepAnimated( crowd, index, frame );
}

/// @param begun its part of a work area, or NULL
static void soleSolveOne( const soleCrowd* crowd, int32_t index, const soleFrame* frame, const soleLegHits* hits,
    soleCrowdBegun* begun, soleCrowdBlock* block )
{
	bool shared = begun != NULL && begun->work.out == soleOutputOf( crowd, index );
	SOLE_ASSERT( begun == NULL || shared );
	if ( shared == false )
	{
		soleSolveAnew( crowd, index, frame, hits );
		return;
	}
	block->indices[block->count] = index;
	block->works[block->count] = &begun->work;
	block->hits[block->count] = *hits;
	block->count += 1;
	if ( block->count == BLOCK )
	{
		soleSolveBlock( crowd, block );
	}
}

/// A character that is not solved in this frame, because it cannot be or has to wait.
static void soleLeaveOut( soleCrowd* crowd, int32_t index, const soleFrame* frame, const soleFrame* longer )
{
	soleCrowdRow* row = soleRowOf( crowd, index );
	if ( !soleIsFrameUsable( longer ) )
	{
		soleFindTurns( crowd, index );
		soleRefuseFrame( crowd->rig, frame, soleOutputOf( crowd, index ) );
		return;
	}
	soleWait( crowd, index, frame );
	row->owed = soleMaxF( soleFiniteOr( longer->timeStep, 0.0f ), 0.0f );
	row->jumped = longer->teleport;
}

void soleSolveCrowd( soleCrowd* crowd, int32_t first, int32_t count, const soleFrame* frames, const soleProbe* probes,
    const soleHit* hits, const soleCrowdAsk* asks, void* work )
{
	bool given = count <= 0 ||
	    ( soleIsIndex( crowd, first ) && soleIsIndex( crowd, first + count - 1 ) && frames != NULL && asks != NULL );
	SOLE_ASSERT( given );
	count = given ? count : 0;
	soleCrowdBlock block = { .count = 0 };
	for ( int32_t i = 0; i < count; ++i )
	{
		soleCrowdRow* row = soleRowOf( crowd, first + i );
		soleFrame longer = soleFrameOf( row, frames + i );
		const soleCrowdAsk* ask = asks + i;
		row->frames += 1;
		if ( ask->waits || !soleIsFrameUsable( &longer ) )
		{
			soleLeaveOut( crowd, first + i, frames + i, &longer );
			continue;
		}
		soleCrowdBegun* begun = work != NULL ? soleBegunOf( crowd, work, i ) : NULL;
		soleLegHits byLeg = soleSortHits( crowd->rig, probes + ask->first, hits + ask->first, ask->count );
		soleSolveOne( crowd, first + i, &longer, &byLeg, begun, &block );
		row->owed = 0.0f;
		row->jumped = false;
	}
	soleSolveBlock( crowd, &block );
}
