// SPDX-License-Identifier: MIT
// Traces: what went into one character's calls and what came out of them, frame by frame, as a stream of bytes that is
// the same on every machine, and that can be played back bit by bit anywhere. A bug report carries one.
//
// Record: make a tracer from the definition that the rig was made from, call soleTracer_BeginFrame() before and
// soleTracer_EndFrame() after each soleSolve(), and soleTracer_Finish() at the end. Recording a frame allocates
// nothing. Play back: soleReplayTrace() for the verdict, or a player to look at every frame.
#ifndef SOLE_TRACE_H
#define SOLE_TRACE_H

#include "sole/sole.h"

// --------------------------------------------------------------------------------------------------------- record

/// Takes the next bytes of a trace. @return false: it can't; nothing more will come.
typedef bool soleTraceWriteFcn( const void* bytes, size_t byteCount, void* user );

/// Where a trace goes.
typedef struct soleTraceSink
{
	soleTraceWriteFcn* write;
	void* user;
} soleTraceSink;

/// A trace in the caller's memory. Set bytes and capacity; byteCount tells how much of it is used. What does not fit
/// ends the trace.
typedef struct soleTraceBuffer
{
	uint8_t* bytes;
	size_t capacity;
	size_t byteCount;
} soleTraceBuffer;

/// @param buffer kept as long as the sink is used
SOLE_API soleTraceSink soleMakeBufferSink( soleTraceBuffer* buffer );

/// Records one character.
typedef struct soleTracer soleTracer;

/// @param def what the character's rig was made from; not kept
/// @param sink gets the trace's head at once
/// @param tracer set to NULL on failure
SOLE_API soleResult soleCreateTracer( const soleRigDef* def, const soleTraceSink* sink, const soleAllocator* allocator,
    soleTracer** tracer, soleMessage* message );
/// NULL is allowed. A trace without an end, as of a program that broke off, can be played up to there.
SOLE_API void soleDestroyTracer( soleTracer* tracer );

/// Before soleSolve(), with what it gets. A state that is not the one which the last frame left, as after a roll-back,
/// is recorded too. A tracer of NULL records nothing: the calls may stay in place.
SOLE_API void soleTracer_BeginFrame( soleTracer* tracer, const soleSettings* settings, const soleState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount );
/// After soleSolve(), with what it left.
SOLE_API void soleTracer_EndFrame( soleTracer* tracer, const soleState* state, const soleOutput* output );

/// Ends the trace. @return false: it is not whole, the sink has refused something.
SOLE_API bool soleTracer_Finish( soleTracer* tracer );

// ---------------------------------------------------------------------------------------------------------- look

/// A recorded frame. Everything that it points to lasts until the next one is read.
typedef struct soleTraceStep
{
	int32_t index;
	const soleSettings* settings;
	/// NULL: the one that the frame before has left.
	const soleState* state;
	const soleFrame* frame;
	const soleHit* hits;
	int32_t hitCount;
	/// What soleGatherProbes() answered: how many, and a checksum of soleGetProbeChecksum().
	int32_t probeCount;
	uint32_t probeChecksum;
	const soleOutput* output;
} soleTraceStep;

/// Reads a trace frame by frame.
typedef struct soleTracePlayer soleTracePlayer;

/// The bytes may come from anyone: what is not a whole and unchanged trace of this version's fields is refused with a
/// sentence. Memory is in proportion to the bytes that are there.
/// @param bytes kept as long as the player
/// @param player set to NULL on failure
SOLE_API soleResult soleOpenTrace( const void* bytes, size_t byteCount, const soleAllocator* allocator,
    soleTracePlayer** player, soleMessage* message );
/// NULL is allowed.
SOLE_API void soleCloseTrace( soleTracePlayer* player );

/// Lasts as long as the player.
SOLE_API const soleRig* soleTracePlayer_GetRig( const soleTracePlayer* player );
/// Of the library that has recorded it.
SOLE_API soleVersion soleTracePlayer_GetVersion( const soleTracePlayer* player );
/// @param step NULL at the end, and where the result is not success
/// @return sole_invalidDefinition where the rest is cut off or changed
SOLE_API soleResult soleTracePlayer_Next( soleTracePlayer* player, const soleTraceStep** step, soleMessage* message );

/// A number for all that probes ask.
SOLE_API uint32_t soleGetProbeChecksum( const soleProbe* probes, int32_t count );

// -------------------------------------------------------------------------------------------------------- compare

/// Where a replay first differs from what was recorded.
typedef struct soleTraceDifference
{
	int32_t frame;     // SOLE_NONE: nowhere
	int32_t leg;       // SOLE_NONE: of the whole character
	const char* field; // of soleOutput or soleLegOutput; "probes": of what was asked; never freed
	int32_t component; // of the field, in its order
	bool isFloat;      // the bits below are those of a float, else of an integer
	uint32_t recorded;
	uint32_t replayed;
} soleTraceDifference;

typedef struct soleTraceReport
{
	soleVersion version; // of the library that has recorded it
	int32_t legCount;
	char legNames[SOLE_MAX_LEGS][32];
	int32_t frameCount; // that could be played
	int32_t differentFrames;
	soleTraceDifference first;
} soleTraceReport;

/// Plays a trace and compares everything bit by bit.
/// @param report filled in up to where the trace could be played, whatever the result
/// @return sole_invalidDefinition where it is no trace, or not whole: the message says what is wrong
SOLE_API soleResult soleReplayTrace( const void* bytes, size_t byteCount, const soleAllocator* allocator,
    soleTraceReport* report, soleMessage* message );

#endif
