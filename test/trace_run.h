// SPDX-License-Identifier: MIT
// A recorded walk of the plain biped in whose frames everything is used that a frame may point to, and memory that is
// counted, for tests of traces.
#ifndef TEST_TRACE_RUN_H
#define TEST_TRACE_RUN_H

#include "placing.h"

#include "sole/trace.h"

#define TRACE_FRAMES 40
#define TRACE_BYTES 400000

// ---------------------------------------------------------------------------------------------------------- memory

/// What an allocator was asked for. Fails at call number failAt, counted from 1; 0: never.
typedef struct testMemory
{
	int32_t calls;
	int32_t failAt;
	size_t held;
	size_t most;
} testMemory;

static inline void* testTakeMemory( size_t byteCount, void* user )
{
	testMemory* memory = user;
	memory->calls += 1;
	if ( memory->calls == memory->failAt )
	{
		return NULL;
	}
	memory->held += byteCount;
	memory->most = memory->held > memory->most ? memory->held : memory->most;
	return malloc( byteCount );
}

static inline void testGiveMemory( void* memory, size_t byteCount, void* user )
{
	( (testMemory*)user )->held -= byteCount;
	free( memory );
}

static inline soleAllocator testCount( testMemory* memory )
{
	return ( soleAllocator ){ testTakeMemory, testGiveMemory, memory };
}

// ----------------------------------------------------------------------------------------------------------- a run

typedef struct testTraced
{
	testRun run;
	soleTransform second[biped_count];
	float weights[3][2];
	soleContactInput contact[2];
	soleStepInput steps[2];
	soleSupport supports[4];
	soleProbe probes[SOLE_MAX_PROBES];
	soleHit hits[SOLE_MAX_PROBES];
	int32_t hitCount;
	soleTracer* tracer;
	soleTraceBuffer buffer;
	uint32_t seed;
} testTraced;

static inline void testStartTraced( testTraced* traced, const soleAllocator* allocator, size_t capacity )
{
	memset( traced, 0, sizeof *traced );
	testStartRun( &traced->run, 0.3f );
	traced->seed = 20261;
	traced->buffer.bytes = malloc( capacity );
	traced->buffer.capacity = capacity;
	soleTraceSink sink = soleMakeBufferSink( &traced->buffer );
	soleMessage message;
	assert_int_equal( soleCreateTracer( &traced->run.biped.def, &sink, allocator, &traced->tracer, &message ), 0 );
	memcpy( traced->second, traced->run.biped.bindPose, sizeof traced->second );
	testBendKnees( traced->second, 1.2f );
	soleFrame* frame = &traced->run.frame;
	frame->secondPose = traced->second;
	frame->legWeight = traced->weights[0];
	frame->positionWeight = traced->weights[1];
	frame->rotationWeight = traced->weights[2];
	frame->contact = traced->contact;
	frame->steps = traced->steps;
	frame->supports = traced->supports;
	frame->supportCount = 4;
}

/// Changes everything that may change between frames, in a way that is not the same for the two legs.
static inline void testChangeFrame( testTraced* traced, int32_t index )
{
	testRun* run = &traced->run;
	float t = (float)index / 60.0f;
	testBendKnees( run->pose, 0.3f + 0.2f * sinf( 4.0f * t ) );
	run->frame.root.translation = soleVec( 0.3f * t, 0.0f, 1.2f * t );
	run->frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.2f * t );
	run->frame.worldOrigin[0] = index < 20 ? 0.0 : 1000.1;
	run->frame.worldOrigin[2] = 1.0 / 3.0;
	run->frame.clipFloor = 0.01f;
	run->frame.teleport = index == 30;
	run->ground.slopeX = 0.1f;
	run->ground.barFrom = 0.2f;
	run->ground.barTo = 0.5f;
	run->ground.barHeight = 0.1f;
	run->settings.pelvis.halfLife = index < 10 ? 0.08f : 0.03f;
	run->settings.probe.layout = index < 15 ? sole_probeEconomy : sole_probeQuality;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		traced->weights[0][leg] = testRandomFloat( &traced->seed, 0.5f, 1.0f );
		traced->weights[1][leg] = testRandomFloat( &traced->seed, 0.5f, 1.0f );
		traced->weights[2][leg] = testRandomFloat( &traced->seed, 0.5f, 1.0f );
		bool down = ( index / 10 + leg ) % 2 == 0;
		traced->contact[leg] = ( soleContactInput ){ down ? 1.0f : 0.0f, down ? 1.0f : 0.2f };
		traced->steps[leg].since = 0.02f * (float)( index % 10 );
		traced->steps[leg].until = 0.2f - traced->steps[leg].since;
		traced->steps[leg].place = soleVec( leg == 0 ? 0.1f : -0.1f, 0.0f, 0.4f );
		traced->steps[leg].forward = soleVec( 0.0f, 0.0f, 1.0f );
		traced->steps[leg].travel = soleVec( 0.0f, 0.0f, 0.1f );
	}
	for ( int32_t i = 0; i < 4; ++i )
	{
		traced->supports[i].surface = 5 + i;
		traced->supports[i].transform = testAt( 0.01f * t, 0.1f * sinf( t ), (float)i );
	}
}

static inline void testAskGround( testTraced* traced )
{
	testRun* run = &traced->run;
	traced->hitCount =
	    soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, traced->probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < traced->hitCount; ++i )
	{
		testCastAt( &run->ground, traced->probes + i, traced->hits + i );
		traced->hits[i].surface = traced->probes[i].leg == 0 ? 6 : SOLE_NONE;
		traced->hits[i].layer = 3;
		traced->hits[i].size = 4.0f;
		traced->hits[i].velocity_w = soleVec( 0.0f, 0.01f, 0.0f );
	}
}

static inline void testRecordFrame( testTraced* traced )
{
	testRun* run = &traced->run;
	testAskGround( traced );
	soleTracer_BeginFrame( traced->tracer, &run->settings, &run->state, &run->frame, traced->hits, traced->hitCount );
	soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, traced->hits, traced->hitCount, &run->out );
	soleTracer_EndFrame( traced->tracer, &run->state, &run->out );
}

static inline void testRecordAll( testTraced* traced )
{
	testStartTraced( traced, NULL, TRACE_BYTES );
	for ( int32_t i = 0; i < TRACE_FRAMES; ++i )
	{
		testChangeFrame( traced, i );
		testRecordFrame( traced );
	}
	assert_true( soleTracer_Finish( traced->tracer ) );
}

static inline void testEndTraced( testTraced* traced )
{
	soleDestroyTracer( traced->tracer );
	soleDestroyRig( traced->run.biped.rig );
	free( traced->buffer.bytes );
}

static inline soleResult testReplay( const testTraced* traced, soleTraceReport* report, soleMessage* message )
{
	return soleReplayTrace( traced->buffer.bytes, traced->buffer.byteCount, NULL, report, message );
}

/// Plays it back, and nothing may differ.
static inline void testReplaysAlike( const testTraced* traced, int32_t frameCount )
{
	soleTraceReport report;
	soleMessage message = { { 0 } };
	soleResult result = testReplay( traced, &report, &message );
	if ( result != sole_success || report.differentFrames != 0 )
	{
		fail_msg( "%s; frame %d, leg %d, %s[%d]", message.text, report.first.frame, report.first.leg,
		    report.first.field, report.first.component );
	}
	assert_int_equal( report.frameCount, frameCount );
}

#endif
