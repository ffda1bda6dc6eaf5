// SPDX-License-Identifier: MIT
// Records a character's frames. A frame becomes words in a fixed order, so that what stays the same from frame to frame
// stays at its place, and only words that have changed are written: a walking character takes about a kilobyte a frame.
#include "base/core.h"
#include "debug/trace_internal.h"

#include <string.h>

struct soleTracer
{
	const soleAllocator* allocatorOrNull;
	soleAllocator allocator;
	size_t byteCount;
	soleTraceSink sink;
	bool good;    // the sink has taken everything
	bool inFrame; // begun, not ended
	uint32_t checksum;
	uint32_t frameCount;
	soleRig* rig;
	int32_t jointCount;
	int32_t legCount;
	soleTraceSizes sizes;
	soleState left; // by the last frame, or else sent

	soleTraceWords now;
	soleTraceWords before; // as long as it is
	uint8_t* chunk;        // with its head
	soleProbe probes[SOLE_MAX_PROBES];
};

// ---------------------------------------------------------------------------------------------------------- sinks

static bool soleWriteToBuffer( const void* bytes, size_t byteCount, void* user )
{
	soleTraceBuffer* buffer = user;
	if ( buffer->bytes == NULL || byteCount > buffer->capacity - buffer->byteCount )
	{
		return false;
	}
	memcpy( buffer->bytes + buffer->byteCount, bytes, byteCount );
	buffer->byteCount += byteCount;
	return true;
}

soleTraceSink soleMakeBufferSink( soleTraceBuffer* buffer )
{
	return ( soleTraceSink ){ soleWriteToBuffer, buffer };
}

static void soleSendBytes( soleTracer* tracer, const uint8_t* bytes, size_t byteCount )
{
	tracer->good = tracer->good && tracer->sink.write( bytes, byteCount, tracer->sink.user );
}

/// @param chunk its bytes stand behind room for its head
static void soleSendChunk( soleTracer* tracer, uint32_t kind, uint8_t* chunk, size_t byteCount )
{
	solePutU32( chunk, kind );
	solePutU32( chunk + 4, (uint32_t)byteCount );
	tracer->checksum = soleChecksum( tracer->checksum, chunk, 8 );
	tracer->checksum = soleChecksum( tracer->checksum, chunk + SOLE_TRACE_CHUNK_BYTES, byteCount );
	solePutU32( chunk + 8, tracer->checksum );
	soleSendBytes( tracer, chunk, SOLE_TRACE_CHUNK_BYTES + byteCount );
}

// ----------------------------------------------------------------------------------------------------------- head

static void soleSendHead( soleTracer* tracer )
{
	uint8_t head[SOLE_TRACE_HEAD_BYTES];
	memcpy( head, SOLE_TRACE_MAGIC, 8 );
	solePutU32( head + 8, SOLE_TRACE_FORM );
	solePutU32( head + 12, SOLE_VERSION_MAJOR << 20 | SOLE_VERSION_MINOR << 10 | SOLE_VERSION_PATCH );
	solePutU32( head + 16, soleGetFieldsChecksum() );
	tracer->checksum = soleChecksum( SOLE_CHECKSUM_START, head, sizeof head );
	soleSendBytes( tracer, head, sizeof head );
}

static int32_t soleCountRigWords( const soleRigDef* def )
{
	return 3 + 8 + 11 * def->jointCount + def->legCount * soleCountFieldWords( &soleTraceLegDefTable );
}

static void solePutRig( soleTraceWords* list, const soleRigDef* def, int32_t settingCount )
{
	solePutWord( list, (uint32_t)def->jointCount );
	solePutWord( list, (uint32_t)def->legCount );
	solePutWord( list, (uint32_t)settingCount );
	solePutWords( list, def->parents, def->jointCount );
	solePutWords( list, def->bindPose, 10 * def->jointCount );
	solePutWords( list, &def->pelvis, 1 );
	solePutWords( list, &def->up, 3 );
	solePutWords( list, &def->forward, 3 );
	for ( int32_t i = 0; i < def->legCount; ++i )
	{
		solePutFields( list, &soleTraceLegDefTable, def->legs + i );
	}
}

/// @return bytes used
static size_t solePutText( uint8_t* bytes, const char* text )
{
	size_t length = text != NULL ? strlen( text ) : 0;
	length = length < 255 ? length : 255;
	bytes[0] = (uint8_t)length;
	if ( length > 0 )
	{
		memcpy( bytes + 1, text, length );
	}
	return length + 1;
}

static soleResult soleSendRig( soleTracer* tracer, const soleRigDef* def )
{
	int32_t settingCount;
	const soleSettingInfo* infos = soleGetSettingInfos( &settingCount );
	int32_t wordCount = soleCountRigWords( def );
	size_t size = SOLE_TRACE_CHUNK_BYTES + 4 + 4 * (size_t)wordCount + 256 * (size_t)( def->legCount + settingCount );
	uint32_t* words = soleAlloc( tracer->allocatorOrNull, 4 * (size_t)wordCount );
	uint8_t* chunk = soleAlloc( tracer->allocatorOrNull, size );
	soleResult result = words != NULL && chunk != NULL ? sole_success : sole_outOfMemory;
	if ( result == sole_success )
	{
		soleTraceWords list = { .words = words };
		solePutRig( &list, def, settingCount );
		uint8_t* at = chunk + SOLE_TRACE_CHUNK_BYTES;
		solePutU32( at, (uint32_t)list.at );
		at += 4;
		for ( int32_t i = 0; i < list.at; ++i, at += 4 )
		{
			solePutU32( at, words[i] );
		}
		for ( int32_t i = 0; i < def->legCount; ++i )
		{
			at += solePutText( at, soleRig_GetLeg( tracer->rig, i ).name );
		}
		for ( int32_t i = 0; i < settingCount; ++i )
		{
			at += solePutText( at, infos[i].name );
		}
		soleSendChunk( tracer, sole_chunkRig, chunk, (size_t)( at - chunk ) - SOLE_TRACE_CHUNK_BYTES );
	}
	soleFree( tracer->allocatorOrNull, words, 4 * (size_t)wordCount );
	soleFree( tracer->allocatorOrNull, chunk, size );
	return result;
}

// --------------------------------------------------------------------------------------------------------- create

static soleTracer* soleAllocTracer( const soleRigDef* def, const soleAllocator* allocator )
{
	int32_t settingCount;
	soleGetSettingInfos( &settingCount );
	soleTraceSizes sizes = soleFindTraceSizes( def->jointCount, def->legCount, settingCount );
	int32_t stateWords = soleCountStateWords( def->legCount );
	int32_t words = sizes.words > stateWords ? sizes.words : stateWords;
	// Words of this frame and of the last, then the bytes of a chunk.
	size_t chunkBytes = SOLE_TRACE_CHUNK_BYTES + 4 + (size_t)( words + 7 ) / 8 + 4 * (size_t)words;
	size_t byteCount = sizeof( soleTracer ) + 8 * (size_t)words + chunkBytes;
	soleTracer* tracer = soleAlloc( allocator, byteCount );
	if ( tracer == NULL )
	{
		return NULL;
	}
	tracer->byteCount = byteCount;
	tracer->sizes = sizes;
	tracer->now.words = (uint32_t*)( tracer + 1 );
	tracer->before.words = tracer->now.words + words;
	tracer->chunk = (uint8_t*)( tracer->before.words + words );
	tracer->jointCount = def->jointCount;
	tracer->legCount = def->legCount;
	if ( allocator != NULL )
	{
		tracer->allocator = *allocator;
		tracer->allocatorOrNull = &tracer->allocator;
	}
	return tracer;
}

soleResult soleCreateTracer( const soleRigDef* def, const soleTraceSink* sink, const soleAllocator* allocator,
    soleTracer** tracerOut, soleMessage* message )
{
	*tracerOut = NULL;
	if ( sink == NULL || sink->write == NULL )
	{
		soleSetMessage( message, "sink: has no write function: say where the trace goes" );
		return sole_invalidDefinition;
	}
	soleRig* rig;
	soleResult result = soleCreateRig( def, allocator, &rig, message );
	if ( result != sole_success )
	{
		return result;
	}
	soleTracer* tracer = soleAllocTracer( def, allocator );
	if ( tracer == NULL )
	{
		soleSetMessage( message, "out of memory: a tracer of %d joints was asked for", def->jointCount );
		soleDestroyRig( rig );
		return sole_outOfMemory;
	}
	tracer->rig = rig;
	tracer->sink = *sink;
	tracer->good = true;
	soleSendHead( tracer );
	result = soleSendRig( tracer, def );
	if ( result != sole_success )
	{
		soleSetMessage( message, "out of memory: a trace of %d joints was asked for", def->jointCount );
		soleDestroyTracer( tracer );
		return result;
	}
	*tracerOut = tracer;
	return sole_success;
}

void soleDestroyTracer( soleTracer* tracer )
{
	if ( tracer == NULL )
	{
		return;
	}
	soleDestroyRig( tracer->rig );
	soleAllocator allocator = tracer->allocator;
	soleFree( tracer->allocatorOrNull != NULL ? &allocator : NULL, tracer, tracer->byteCount );
}

// --------------------------------------------------------------------------------------------------------- a frame

static void soleSendState( soleTracer* tracer, const soleState* state )
{
	tracer->now.at = 0;
	solePutStateWords( &tracer->now, state, tracer->legCount );
	uint8_t* at = tracer->chunk + SOLE_TRACE_CHUNK_BYTES;
	for ( int32_t i = 0; i < tracer->now.at; ++i )
	{
		solePutU32( at + 4 * i, tracer->now.words[i] );
	}
	soleSendChunk( tracer, sole_chunkState, tracer->chunk, 4 * (size_t)tracer->now.at );
}

static uint32_t soleFindParts( const soleFrame* frame )
{
	const void* parts[] = { frame->pose, frame->secondPose, frame->legWeight, frame->positionWeight,
		frame->rotationWeight, frame->contact, frame->steps, frame->supports };
	uint32_t bits = 0;
	for ( int32_t i = 0; i < 8; ++i )
	{
		bits |= parts[i] != NULL ? 1u << i : 0u;
	}
	return bits;
}

static void solePutSettings( soleTraceWords* list, const soleSettings* settings )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		solePutWords( list, (const char*)settings + infos[i].offset, 1 );
	}
}

static void solePutList(
    soleTraceWords* list, const soleTraceTable* table, const void* items, int32_t count, size_t size )
{
	for ( int32_t i = 0; i < count && items != NULL; ++i )
	{
		solePutFields( list, table, (const char*)items + (size_t)i * size );
	}
}

static void solePutFloats( soleTraceWords* list, const void* floats, int32_t count )
{
	if ( floats != NULL )
	{
		solePutWords( list, floats, count );
	}
}

/// All that a frame points to but supports.
static void solePutPointees( soleTraceWords* list, const soleFrame* frame, int32_t jointCount, int32_t legCount )
{
	solePutFloats( list, frame->pose, 10 * jointCount );
	solePutFloats( list, frame->secondPose, 10 * jointCount );
	solePutFloats( list, frame->legWeight, legCount );
	solePutFloats( list, frame->positionWeight, legCount );
	solePutFloats( list, frame->rotationWeight, legCount );
	solePutList( list, &soleTraceContactTable, frame->contact, legCount, sizeof *frame->contact );
	solePutList( list, &soleTraceStepTable, frame->steps, legCount, sizeof *frame->steps );
}

/// A body is looked for by the surfaces of hits and of what legs remember to stand on, and then the first is taken.
static bool soleIsBodyWanted( const soleTracer* tracer, const soleState* state, const soleFrame* frame, int32_t index,
    const soleHit* hits, int32_t hitCount )
{
	int32_t surface = frame->supports[index].surface;
	bool isFirst = surface != SOLE_NONE;
	for ( int32_t i = 0; i < index; ++i )
	{
		isFirst = isFirst && frame->supports[i].surface != surface;
	}
	if ( isFirst == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < tracer->legCount; ++i )
	{
		if ( state->legs[i].body.surface == surface )
		{
			return true;
		}
	}
	for ( int32_t i = 0; i < hitCount; ++i )
	{
		if ( hits[i].surface == surface )
		{
			return true;
		}
	}
	return false;
}

static void solePutSupports(
    soleTracer* tracer, const soleState* state, const soleFrame* frame, const soleHit* hits, int32_t hitCount )
{
	soleTraceWords* list = &tracer->now;
	int32_t countAt = list->at;
	uint32_t count = 0;
	solePutWord( list, 0 );
	for ( int32_t i = 0; i < frame->supportCount && frame->supports != NULL; ++i )
	{
		if ( soleIsBodyWanted( tracer, state, frame, i, hits, hitCount ) )
		{
			solePutFields( list, &soleTraceSupportTable, frame->supports + i );
			++count;
		}
	}
	list->words[countAt] = count;
}

void soleTracer_BeginFrame( soleTracer* tracer, const soleSettings* settings, const soleState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount )
{
	if ( tracer == NULL || tracer->good == false )
	{
		return;
	}
	bool given = state != NULL && frame != NULL && ( hits != NULL || hitCount <= 0 );
	SOLE_ASSERT( given );
	tracer->inFrame = given;
	if ( given == false )
	{
		return;
	}
	if ( tracer->frameCount == 0 || memcmp( state, &tracer->left, soleState_GetByteCount( tracer->rig ) ) != 0 )
	{
		soleSendState( tracer, state );
		memcpy( &tracer->left, state, soleState_GetByteCount( tracer->rig ) );
	}
	soleSettings usual = soleDefaultSettings(); // what the solver takes where it was given none
	bool usable = settings != NULL && settings->internalValue == SOLE_COOKIE;
	settings = usable ? settings : &usual;
	int32_t probeCount = soleGatherProbes( tracer->rig, settings, state, frame, tracer->probes, SOLE_MAX_PROBES );
	int32_t hitsKept = hitCount < 0 ? 0 : ( hitCount < tracer->sizes.hits ? hitCount : tracer->sizes.hits );

	soleTraceWords* list = &tracer->now;
	list->at = 0;
	solePutWord( list, soleFindParts( frame ) );
	solePutWord( list, (uint32_t)probeCount );
	solePutWord( list, soleGetProbeChecksum( tracer->probes, probeCount ) );
	solePutSettings( list, settings );
	solePutFields( list, &soleTraceFrameTable, frame );
	solePutPointees( list, frame, tracer->jointCount, tracer->legCount );
	solePutWord( list, (uint32_t)hitsKept );
	solePutList( list, &soleTraceHitTable, hits, hitsKept, sizeof *hits );
	solePutSupports( tracer, state, frame, hits, hitsKept );
}

/// Words that are others than in the frame before, behind a bit for each that says so. @return bytes
static size_t solePackFrame( soleTracer* tracer )
{
	const soleTraceWords* now = &tracer->now;
	soleTraceWords* before = &tracer->before;
	uint8_t* bits = tracer->chunk + SOLE_TRACE_CHUNK_BYTES + 4;
	uint8_t* at = bits + ( now->at + 7 ) / 8;
	solePutU32( bits - 4, (uint32_t)now->at );
	memset( bits, 0, (size_t)( at - bits ) );
	for ( int32_t i = 0; i < now->at; ++i )
	{
		uint32_t known = i < before->at ? before->words[i] : 0;
		if ( now->words[i] != known )
		{
			bits[i / 8] = (uint8_t)( bits[i / 8] | 1u << ( i % 8 ) );
			solePutU32( at, now->words[i] );
			at += 4;
		}
	}
	return (size_t)( at - bits ) + 4;
}

void soleTracer_EndFrame( soleTracer* tracer, const soleState* state, const soleOutput* output )
{
	if ( tracer == NULL || tracer->good == false || tracer->inFrame == false )
	{
		return;
	}
	tracer->inFrame = false;
	bool given = state != NULL && output != NULL && output->legCount == tracer->legCount;
	SOLE_ASSERT( given && "a state and an output of the tracer's rig" );
	if ( given == false )
	{
		return;
	}
	solePutFields( &tracer->now, &soleTraceOutputTable, output );
	solePutList( &tracer->now, &soleTraceLegOutputTable, output->legs, tracer->legCount, sizeof output->legs[0] );
	soleSendChunk( tracer, sole_chunkFrame, tracer->chunk, solePackFrame( tracer ) );
	soleTraceWords words = tracer->before;
	tracer->before = tracer->now;
	tracer->now = words;
	memcpy( &tracer->left, state, soleState_GetByteCount( tracer->rig ) );
	tracer->frameCount += 1;
}

bool soleTracer_Finish( soleTracer* tracer )
{
	SOLE_ASSERT( tracer != NULL );
	if ( tracer == NULL )
	{
		return false;
	}
	uint8_t chunk[SOLE_TRACE_CHUNK_BYTES + 4];
	solePutU32( chunk + SOLE_TRACE_CHUNK_BYTES, tracer->frameCount );
	soleSendChunk( tracer, sole_chunkEnd, chunk, 4 );
	bool whole = tracer->good;
	tracer->good = false;
	return whole;
}
