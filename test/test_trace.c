// SPDX-License-Identifier: MIT
// Traces hold all that went in and came out, and play it back to the bit; where something differs they say what.
#include "trace_run.h"

#include "take.h"

static void aRecordedRunIsTheSameToTheBit( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	testReplaysAlike( &traced, TRACE_FRAMES );
	testEndTraced( &traced );
}

static void everythingThatAFramePointsToComesBack( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	testTraced again;
	testStartTraced( &again, NULL, TRACE_BYTES );
	soleTracePlayer* player;
	const soleTraceStep* step;
	assert_int_equal(
	    soleOpenTrace( traced.buffer.bytes, traced.buffer.byteCount, NULL, &player, NULL ), sole_success );
	assert_int_equal( soleRig_GetJointCount( soleTracePlayer_GetRig( player ) ), biped_count );
	assert_string_equal( soleRig_GetLeg( soleTracePlayer_GetRig( player ), 1 ).name, "right" );
	for ( int32_t i = 0; i < TRACE_FRAMES; ++i )
	{
		assert_int_equal( soleTracePlayer_Next( player, &step, NULL ), sole_success );
		assert_non_null( step );
		testChangeFrame( &again, i );
		testRecordFrame( &again );
		const soleFrame* was = &again.run.frame;
		const soleFrame* is = step->frame;
		assert_int_equal( step->index, i );
		assert_true( ( step->state != NULL ) == ( i == 0 ) );
		assert_memory_equal( step->settings, &again.run.settings, sizeof( soleSettings ) );
		assert_memory_equal( is->pose, was->pose, biped_count * sizeof *was->pose );
		assert_memory_equal( is->secondPose, was->secondPose, biped_count * sizeof *was->secondPose );
		assert_memory_equal( is->legWeight, was->legWeight, 2 * sizeof( float ) );
		assert_memory_equal( is->positionWeight, was->positionWeight, 2 * sizeof( float ) );
		assert_memory_equal( is->rotationWeight, was->rotationWeight, 2 * sizeof( float ) );
		assert_memory_equal( is->contact, was->contact, 2 * sizeof *was->contact );
		assert_memory_equal( is->steps, was->steps, 2 * sizeof *was->steps );
		assert_memory_equal( &is->root, &was->root, sizeof was->root );
		assert_memory_equal( is->worldOrigin, was->worldOrigin, sizeof was->worldOrigin );
		assert_true( is->teleport == was->teleport && is->weight == was->weight && is->timeStep == was->timeStep );
		assert_true( is->clipFloor == was->clipFloor && is->up.y == was->up.y );
		assert_int_equal( step->hitCount, again.hitCount );
		assert_int_equal( step->probeCount, again.hitCount );
		assert_int_equal( step->probeChecksum, soleGetProbeChecksum( again.probes, again.hitCount ) );
		assert_memory_equal( step->hits, again.hits, (size_t)again.hitCount * sizeof *step->hits );
		assert_memory_equal( step->output, &again.run.out, offsetof( soleOutput, legs ) + 2 * sizeof( soleLegOutput ) );
		// Of the bodies only the one that something was met on.
		assert_int_equal( is->supportCount, 1 );
		assert_memory_equal( is->supports, again.supports + 1, sizeof( soleSupport ) );
	}
	assert_int_equal( soleTracePlayer_Next( player, &step, NULL ), sole_success );
	assert_null( step );
	soleCloseTrace( player );
	testEndTraced( &again );
	testEndTraced( &traced );
}

static void framesWithoutTheirPartsAreKept( void** state )
{
	(void)state;
	testTraced traced;
	testStartTraced( &traced, NULL, TRACE_BYTES );
	testRecordFrame( &traced );
	traced.run.frame = testFrame( traced.run.pose );
	testRecordFrame( &traced );
	traced.run.frame.pose = NULL;
	testRecordFrame( &traced );
	assert_int_equal( traced.run.out.legs[0].flags, sole_legBadInput );
	traced.run.frame.pose = traced.run.pose;
	traced.run.frame.timeStep = NAN;
	testRecordFrame( &traced );
	assert_true( soleTracer_Finish( traced.tracer ) );
	testReplaysAlike( &traced, 4 );
	testEndTraced( &traced );
}

static void rolledBackStatesAreRecorded( void** state )
{
	(void)state;
	testTraced traced;
	testStartTraced( &traced, NULL, TRACE_BYTES );
	soleState saved = traced.run.state;
	for ( int32_t i = 0; i < 30; ++i )
	{
		testChangeFrame( &traced, i );
		if ( i == 8 )
		{
			saved = traced.run.state;
		}
		if ( i == 20 )
		{
			traced.run.state = saved;
		}
		if ( i == 25 )
		{
			// A frame that was begun and given up.
			soleTracer_BeginFrame( traced.tracer, &traced.run.settings, &saved, &traced.run.frame, NULL, 0 );
		}
		testRecordFrame( &traced );
	}
	assert_true( soleTracer_Finish( traced.tracer ) );
	testReplaysAlike( &traced, 30 );
	testEndTraced( &traced );
}

static void aDifferenceIsNamed( void** state )
{
	(void)state;
	static const char* const fields[] = { "extension", "rotations_l", "bodyGradient_w" };
	for ( int32_t kind = 0; kind < 3; ++kind )
	{
		testTraced traced;
		testStartTraced( &traced, NULL, TRACE_BYTES );
		testRun* run = &traced.run;
		for ( int32_t i = 0; i < 6; ++i )
		{
			testChangeFrame( &traced, i );
			testAskGround( &traced );
			soleState before = run->state;
			soleSolve(
			    run->biped.rig, &run->settings, &run->state, &run->frame, traced.hits, traced.hitCount, &run->out );
			soleOutput out = run->out;
			out.legs[1].extension += kind == 0 && i >= 3 ? 0.125f : 0.0f;
			out.legs[0].rotations_l[1].z += kind == 1 && i >= 3 ? 0.125f : 0.0f;
			out.bodyGradient_w.y += kind == 2 && i >= 3 ? 0.125f : 0.0f;
			soleTracer_BeginFrame( traced.tracer, &run->settings, &before, &run->frame, traced.hits, traced.hitCount );
			soleTracer_EndFrame( traced.tracer, &run->state, &out );
		}
		assert_true( soleTracer_Finish( traced.tracer ) );
		soleTraceReport report;
		assert_int_equal( testReplay( &traced, &report, NULL ), sole_success );
		assert_int_equal( report.frameCount, 6 );
		assert_int_equal( report.first.frame, 3 );
		assert_int_equal( report.differentFrames, 3 );
		assert_string_equal( report.first.field, fields[kind] );
		assert_int_equal( report.first.leg, kind == 0 ? 1 : ( kind == 1 ? 0 : SOLE_NONE ) );
		assert_int_equal( report.first.component, kind == 0 ? 0 : ( kind == 1 ? 6 : 1 ) );
		assert_true( report.first.isFloat );
		assert_int_not_equal( report.first.recorded, report.first.replayed );
		assert_string_equal( report.legNames[1], "right" );
		testEndTraced( &traced );
	}
}

static void everyPartOfAProbeCounts( void** state )
{
	(void)state;
	testTraced traced;
	testStartTraced( &traced, NULL, TRACE_BYTES );
	testChangeFrame( &traced, 0 );
	testAskGround( &traced );
	uint32_t checksum = soleGetProbeChecksum( traced.probes, traced.hitCount );
	assert_int_not_equal( soleGetProbeChecksum( traced.probes, traced.hitCount - 1 ), checksum );
	soleProbe* last = traced.probes + traced.hitCount - 1;
	float* parts[] = { &last->start_w.x, &last->direction_w.z, &last->length, &last->radius };
	for ( int32_t i = 0; i < 4; ++i )
	{
		*parts[i] += 0.001f;
		uint32_t changed = soleGetProbeChecksum( traced.probes, traced.hitCount );
		assert_int_not_equal( changed, checksum );
		checksum = changed;
	}
	last->mask ^= 1;
	assert_int_not_equal( soleGetProbeChecksum( traced.probes, traced.hitCount ), checksum );
	testEndTraced( &traced );
}

static void recordingAFrameAllocatesNothing( void** state )
{
	(void)state;
	testMemory memory = { 0 };
	soleAllocator allocator = testCount( &memory );
	testTraced traced;
	testStartTraced( &traced, &allocator, TRACE_BYTES );
	int32_t calls = memory.calls;
	assert_true( calls > 0 );
	for ( int32_t i = 0; i < TRACE_FRAMES; ++i )
	{
		testChangeFrame( &traced, i );
		testRecordFrame( &traced );
	}
	assert_true( soleTracer_Finish( traced.tracer ) );
	assert_int_equal( memory.calls, calls );
	testEndTraced( &traced );
	assert_int_equal( memory.held, 0 );
}

static void aTracerThatIsNoneRecordsNothing( void** state )
{
	(void)state;
	testRun run;
	testStartRun( &run, 0.3f );
	soleTracer_BeginFrame( NULL, &run.settings, &run.state, &run.frame, NULL, 0 );
	soleTracer_EndFrame( NULL, &run.state, &run.out );
	soleDestroyTracer( NULL );
	soleDestroyRig( run.biped.rig );
}

static void aFullBufferEndsTheTrace( void** state )
{
	(void)state;
	testTraced traced;
	testStartTraced( &traced, NULL, 12000 );
	for ( int32_t i = 0; i < TRACE_FRAMES; ++i )
	{
		testChangeFrame( &traced, i );
		testRecordFrame( &traced );
	}
	assert_false( soleTracer_Finish( traced.tracer ) );
	// What is there can be played.
	soleTraceReport report;
	soleMessage message;
	assert_int_equal( testReplay( &traced, &report, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "cut off" ) );
	assert_in_range( report.frameCount, 2, TRACE_FRAMES - 1 );
	assert_int_equal( report.differentFrames, 0 );
	testEndTraced( &traced );
}

static void bytesAreTheSameOnEveryMachine( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	const uint8_t* bytes = traced.buffer.bytes;
	static const uint8_t head[] = { 'S', 'o', 'l', 'e', 'T', 'r', 'c', '\n', 1, 0, 0, 0 };
	assert_memory_equal( bytes, head, sizeof head );
	// The rig's chunk, then its count of words, then that of joints: low bytes first.
	assert_int_equal( bytes[20] | bytes[21], 1 );
	assert_int_equal( bytes[36], biped_count );
	assert_int_equal( bytes[37] | bytes[38] | bytes[39], 0 );
	// The end: how many frames there were.
	assert_int_equal( bytes[traced.buffer.byteCount - 4], TRACE_FRAMES );
	testEndTraced( &traced );
}

static void aBadDefinitionMakesNoTracer( void** state )
{
	(void)state;
	soleTraceBuffer buffer = { 0 };
	soleTraceSink sink = soleMakeBufferSink( &buffer );
	soleRigDef def = soleDefaultRigDef();
	soleTracer* tracer = NULL;
	soleMessage message = { { 0 } };
	assert_int_equal( soleCreateTracer( &def, &sink, NULL, &tracer, &message ), sole_invalidDefinition );
	assert_null( tracer );
	assert_true( strlen( message.text ) > 10 );
	assert_int_equal( soleCreateTracer( &def, NULL, NULL, &tracer, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "sink" ) );
}

static void testScene( const char* character, const char* clip, const char* ground )
{
	toolError error = { { 0 } };
	testTake take;
	testOpenTake( &( testBake ){ .character = character, .clip = clip, .ground = ground }, &take );
	soleTraceBuffer buffer = { malloc( 8000000 ), 8000000, 0 };
	soleTraceSink sink = soleMakeBufferSink( &buffer );
	soleTracer* tracer;
	assert_int_equal( soleCreateTracer( &take.character.rigDef, &sink, NULL, &tracer, NULL ), sole_success );
	toolBakeDef def = toolDefaultBakeDef();
	toolPlace start = { 0.0, (double)NAN, 0.0 };
	def.groundName = ground;
	def.path = take.ground.path != NULL ? take.ground.path : &start;
	def.pathCount = take.ground.path != NULL ? take.ground.pathCount : 1;
	def.distance = 4.0;
	def.duration = 4.0;
	def.tracer = tracer;
	TEST_GOOD(
	    toolBake( &take.character, &take.bound, &take.travel, take.ground.ground, &def, &take.result, &error ), error );
	assert_true( soleTracer_Finish( tracer ) );
	soleDestroyTracer( tracer );
	soleTraceReport report;
	soleMessage message = { { 0 } };
	soleResult result = soleReplayTrace( buffer.bytes, buffer.byteCount, NULL, &report, &message );
	if ( result != sole_success || report.differentFrames > 0 )
	{
		fail_msg( "%s on %s: %s, frame %d, leg %d, %s", character, ground, message.text, report.first.frame,
		    report.first.leg, report.first.field );
	}
	assert_int_equal( report.frameCount, take.result.walk.frameCount );
	assert_in_range( buffer.byteCount, 1000, 4000 * (size_t)report.frameCount );
	free( buffer.bytes );
	testCloseTake( &take );
}

static void bakesAreTheSameToTheBit( void** state )
{
	(void)state;
	static const char* const grounds[] = { "flat", "stairs", "ramp", "rubble", "course" };
	for ( size_t i = 0; i < sizeof grounds / sizeof grounds[0]; ++i )
	{
		testScene( "mannequin", i % 2 == 0 ? "walk" : "run", grounds[i] );
	}
}

static void bakesOfRealCharactersAreTheSameToTheBit( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-quaternius-ual/human-base-animations.glb" );
	testScene( "human-quaternius-ual/human-base-animations.glb", "Walk_Loop", "stairs" );
	testScene( "human-pab-rootmotion/pab_arnaud.glb", "walk", "rubble" );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aRecordedRunIsTheSameToTheBit ),
		cmocka_unit_test( everythingThatAFramePointsToComesBack ),
		cmocka_unit_test( framesWithoutTheirPartsAreKept ),
		cmocka_unit_test( rolledBackStatesAreRecorded ),
		cmocka_unit_test( aDifferenceIsNamed ),
		cmocka_unit_test( everyPartOfAProbeCounts ),
		cmocka_unit_test( recordingAFrameAllocatesNothing ),
		cmocka_unit_test( aTracerThatIsNoneRecordsNothing ),
		cmocka_unit_test( aFullBufferEndsTheTrace ),
		cmocka_unit_test( bytesAreTheSameOnEveryMachine ),
		cmocka_unit_test( aBadDefinitionMakesNoTracer ),
		cmocka_unit_test( bakesAreTheSameToTheBit ),
		cmocka_unit_test( bakesOfRealCharactersAreTheSameToTheBit ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
