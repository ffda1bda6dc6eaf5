// SPDX-License-Identifier: MIT
// Reads the frames of a trace that may come from anyone. What a chunk says counts only after its checksum has held.
#include "debug/trace_player.h"

#include "base/core.h"

#include <string.h>

soleResult soleReadTraceChunk( soleTracePlayer* player, soleTraceChunk* chunk, soleMessage* message )
{
	const uint8_t* head = player->bytes + player->at;
	size_t rest = player->total - player->at;
	if ( rest < SOLE_TRACE_CHUNK_BYTES || soleTakeU32( head + 4 ) > rest - SOLE_TRACE_CHUNK_BYTES )
	{
		soleSetMessage(
		    message, "trace: is cut off after frame %d: record it to its end, or send all of it", player->step.index );
		return sole_invalidDefinition;
	}
	*chunk = ( soleTraceChunk ){ soleTakeU32( head ), head + SOLE_TRACE_CHUNK_BYTES, soleTakeU32( head + 4 ) };
	player->checksum = soleChecksum( player->checksum, head, 8 );
	player->checksum = soleChecksum( player->checksum, chunk->bytes, chunk->byteCount );
	if ( player->checksum != soleTakeU32( head + 8 ) )
	{
		soleSetMessage(
		    message, "trace: was changed after frame %d: copy it anew, as a binary file", player->step.index );
		return sole_invalidDefinition;
	}
	player->at += SOLE_TRACE_CHUNK_BYTES + chunk->byteCount;
	return sole_success;
}

// --------------------------------------------------------------------------------------------------------- a frame

/// Puts a frame's changes into the words of the frame before. @return false: it is not as long as it says
static bool soleUnpackFrame( soleTracePlayer* player, const soleTraceChunk* chunk )
{
	uint32_t count = chunk->byteCount >= 4 ? soleTakeU32( chunk->bytes ) : 0;
	if ( count == 0 || count > (uint32_t)player->sizes.words || ( count + 7 ) / 8 > chunk->byteCount - 4 )
	{
		return false;
	}
	soleTraceWords* words = &player->words;
	const uint8_t* bits = chunk->bytes + 4;
	const uint8_t* at = bits + ( count + 7 ) / 8;
	const uint8_t* end = chunk->bytes + chunk->byteCount;
	for ( uint32_t i = 0; i < count; ++i )
	{
		if ( ( bits[i / 8] >> ( i % 8 ) & 1 ) != 0 )
		{
			if ( end - at < 4 )
			{
				return false;
			}
			words->words[i] = soleTakeU32( at );
			at += 4;
		}
	}
	for ( int32_t i = (int32_t)count; i < words->count; ++i )
	{
		words->words[i] = 0;
	}
	words->count = (int32_t)count;
	words->at = 0;
	return at == end;
}

static const void* soleTakeFloats( soleTracePlayer* player, bool there, void* to, int32_t count )
{
	if ( there )
	{
		soleTakeWords( &player->words, to, count );
	}
	return there ? to : NULL;
}

static const void* soleTakeList(
    soleTracePlayer* player, const soleTraceTable* table, void* items, int32_t count, size_t size )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		soleTakeFields( &player->words, table, (char*)items + (size_t)i * size );
	}
	return items;
}

static void soleTakePointees( soleTracePlayer* player, uint32_t parts )
{
	soleFrame* frame = &player->frame;
	int32_t floats = 10 * player->jointCount;
	int32_t legs = player->legCount;
	frame->pose = soleTakeFloats( player, ( parts & sole_tracePose ) != 0, player->pose, floats );
	frame->secondPose = soleTakeFloats( player, ( parts & sole_traceSecondPose ) != 0, player->secondPose, floats );
	frame->legWeight = soleTakeFloats( player, ( parts & sole_traceLegWeight ) != 0, player->weights[0], legs );
	frame->positionWeight =
	    soleTakeFloats( player, ( parts & sole_tracePositionWeight ) != 0, player->weights[1], legs );
	frame->rotationWeight =
	    soleTakeFloats( player, ( parts & sole_traceRotationWeight ) != 0, player->weights[2], legs );
	if ( ( parts & sole_traceContact ) != 0 )
	{
		frame->contact =
		    soleTakeList( player, &soleTraceContactTable, player->contact, legs, sizeof player->contact[0] );
	}
	if ( ( parts & sole_traceSteps ) != 0 )
	{
		frame->steps = soleTakeList( player, &soleTraceStepTable, player->steps, legs, sizeof player->steps[0] );
	}
}

/// A list with its length before it. @return how many, or SOLE_NONE where that is too many
static int32_t soleTakeCounted(
    soleTracePlayer* player, const soleTraceTable* table, void* items, int32_t most, size_t size )
{
	uint32_t count = soleTakeWord( &player->words );
	if ( count > (uint32_t)most )
	{
		return SOLE_NONE;
	}
	soleTakeList( player, table, items, (int32_t)count, size );
	return (int32_t)count;
}

/// The words as a frame. @return false: there are too many or not enough of them
static bool soleTakeFrame( soleTracePlayer* player )
{
	soleTraceWords* words = &player->words;
	uint32_t parts = soleTakeWord( words );
	soleTakeWords( words, &player->step.probeCount, 1 );
	player->step.probeChecksum = soleTakeWord( words );
	player->settings = soleDefaultSettings();
	for ( int32_t i = 0; i < player->settingCount; ++i )
	{
		soleTakeWords( words, (char*)&player->settings + player->offsets[i], 1 );
	}
	player->frame = ( soleFrame ){ 0 };
	soleTakeFields( words, &soleTraceFrameTable, &player->frame );
	soleTakePointees( player, parts );
	player->step.hitCount =
	    soleTakeCounted( player, &soleTraceHitTable, player->hits, player->sizes.hits, sizeof *player->hits );
	player->frame.supportCount = soleTakeCounted(
	    player, &soleTraceSupportTable, player->supports, player->sizes.supports, sizeof *player->supports );
	player->frame.supports = ( parts & sole_traceSupports ) != 0 ? player->supports : NULL;
	memset( &player->output, 0, sizeof player->output );
	soleTakeFields( words, &soleTraceOutputTable, &player->output );
	soleTakeList(
	    player, &soleTraceLegOutputTable, player->output.legs, player->legCount, sizeof player->output.legs[0] );
	bool counted = player->step.hitCount >= 0 && player->frame.supportCount >= 0;
	return counted && player->output.legCount == player->legCount && words->tooShort == false &&
	    words->at == words->count;
}

static bool soleReadState( soleTracePlayer* player, const soleTraceChunk* chunk )
{
	int32_t count = soleCountStateWords( player->legCount );
	if ( chunk->byteCount != 4 * (size_t)count )
	{
		return false;
	}
	uint32_t words[sizeof( soleState ) / 4 + 8];
	soleTraceWords list = { .words = words, .count = count };
	for ( int32_t i = 0; i < count; ++i )
	{
		words[i] = soleTakeU32( chunk->bytes + 4 * i );
	}
	soleTakeStateWords( &list, &player->state, player->legCount );
	player->step.state = &player->state;
	return true;
}

/// @return false: it says something else than the frames
static bool soleReadEnd( soleTracePlayer* player, const soleTraceChunk* chunk )
{
	player->ended = true;
	return chunk->byteCount == 4 && soleTakeU32( chunk->bytes ) == (uint32_t)( player->step.index + 1 ) &&
	    player->at == player->total;
}

static bool soleReadFrame( soleTracePlayer* player, const soleTraceChunk* chunk )
{
	bool known = player->step.index >= 0 || player->step.state != NULL;
	if ( known == false || soleUnpackFrame( player, chunk ) == false || soleTakeFrame( player ) == false )
	{
		return false;
	}
	player->step.index += 1;
	player->step.settings = &player->settings;
	player->step.frame = &player->frame;
	player->step.hits = player->hits;
	player->step.output = &player->output;
	return true;
}

soleResult soleTracePlayer_Next( soleTracePlayer* player, const soleTraceStep** step, soleMessage* message )
{
	*step = NULL;
	SOLE_ASSERT( player != NULL );
	if ( player == NULL || player->ended )
	{
		return sole_success;
	}
	player->step.state = NULL;
	for ( ;; )
	{
		soleTraceChunk chunk;
		soleResult result = soleReadTraceChunk( player, &chunk, message );
		if ( result != sole_success )
		{
			player->ended = true;
			return result;
		}
		bool good = chunk.kind == sole_chunkState ? soleReadState( player, &chunk )
		    : chunk.kind == sole_chunkFrame       ? soleReadFrame( player, &chunk )
		    : chunk.kind == sole_chunkEnd         ? soleReadEnd( player, &chunk )
		                                          : false;
		if ( good == false )
		{
			player->ended = true;
			soleSetMessage(
			    message, "trace: what follows frame %d is no frame of this rig: record it anew", player->step.index );
			return sole_invalidDefinition;
		}
		if ( chunk.kind == sole_chunkFrame )
		{
			*step = &player->step;
		}
		if ( chunk.kind != sole_chunkState )
		{
			return sole_success;
		}
	}
}
