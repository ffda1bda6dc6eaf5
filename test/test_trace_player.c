// SPDX-License-Identifier: MIT
// Bytes that are no whole trace are refused with a sentence, whatever they say, and take no more memory than there are
// bytes to bear it out.
#include "trace_run.h"

/// "trace: what is wrong: what to do", or what soleCreateRig() says.
static void testIsSentence( const char* what, const soleMessage* message )
{
	const char* first = strstr( message->text, ": " );
	if ( first == NULL || strstr( first + 2, ": " ) == NULL || strlen( message->text ) < 20 )
	{
		fail_msg( "%s: says '%s'", what, message->text );
	}
}

static soleResult testPlay( const uint8_t* bytes, size_t byteCount, soleTraceReport* report, soleMessage* message )
{
	// In memory of its own, so that a sanitizer sees what is read beyond it.
	uint8_t* copy = malloc( byteCount > 0 ? byteCount : 1 );
	memcpy( copy, bytes, byteCount );
	testMemory memory = { 0 };
	soleAllocator allocator = testCount( &memory );
	memset( message, 0, sizeof *message );
	soleResult result = soleReplayTrace( copy, byteCount, &allocator, report, message );
	free( copy );
	assert_int_equal( memory.held, 0 );
	// Arrays for the most probes that one frame can have, beside what is in proportion.
	assert_in_range( memory.most, 0, 400000 + 4 * byteCount );
	return result;
}

static void cutTracesAreRefused( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	size_t total = traced.buffer.byteCount;
	for ( size_t count = 0; count < total; count += count < 2500 || count + 300 > total ? 1 : 97 )
	{
		soleTraceReport report;
		soleMessage message;
		assert_int_equal( testPlay( traced.buffer.bytes, count, &report, &message ), sole_invalidDefinition );
		testIsSentence( "cut", &message );
		assert_int_equal( report.differentFrames, 0 );
	}
	testEndTraced( &traced );
}

static void longTracesAreRefused( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	traced.buffer.bytes[traced.buffer.byteCount] = 0;
	soleTraceReport report;
	soleMessage message;
	assert_int_equal(
	    testPlay( traced.buffer.bytes, traced.buffer.byteCount + 1, &report, &message ), sole_invalidDefinition );
	assert_int_equal( report.frameCount, TRACE_FRAMES );
	testEndTraced( &traced );
}

static void everyFlippedBitIsFound( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	for ( size_t i = 0; i < traced.buffer.byteCount; i += i < 4000 ? 1 : 61 )
	{
		uint8_t flip = (uint8_t)( 1u << ( i % 8 ) );
		traced.buffer.bytes[i] ^= flip;
		soleTraceReport report;
		soleMessage message;
		soleResult result = testPlay( traced.buffer.bytes, traced.buffer.byteCount, &report, &message );
		traced.buffer.bytes[i] ^= flip;
		assert_int_equal( result, sole_invalidDefinition );
		testIsSentence( "flipped", &message );
	}
	testReplaysAlike( &traced, TRACE_FRAMES );
	testEndTraced( &traced );
}

static uint32_t testU32At( const uint8_t* bytes )
{
	return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

static uint32_t testFnv( uint32_t sum, const uint8_t* bytes, size_t count )
{
	for ( size_t i = 0; i < count; ++i )
	{
		sum = ( sum ^ bytes[i] ) * 16777619u;
	}
	return sum;
}

/// What someone would do who wants a changed trace to be believed.
static void testRenewChecksums( uint8_t* bytes, size_t total )
{
	uint32_t sum = testFnv( 2166136261u, bytes, 20 );
	for ( size_t at = 20; at + 12 <= total; )
	{
		size_t count = testU32At( bytes + at + 4 );
		if ( count > total - at - 12 )
		{
			return;
		}
		sum = testFnv( testFnv( sum, bytes + at, 8 ), bytes + at + 12, count );
		for ( size_t i = 0; i < 4; ++i )
		{
			bytes[at + 8 + i] = (uint8_t)( sum >> ( 8 * i ) );
		}
		at += 12 + count;
	}
}

/// Reads all frames and everything in them. @return what was said where the trace was refused
static soleResult testRead( const uint8_t* bytes, size_t byteCount, soleMessage* message )
{
	uint8_t* copy = malloc( byteCount );
	memcpy( copy, bytes, byteCount );
	testMemory memory = { 0 };
	soleAllocator allocator = testCount( &memory );
	memset( message, 0, sizeof *message );
	soleTracePlayer* player;
	soleResult result = soleOpenTrace( copy, byteCount, &allocator, &player, message );
	const soleTraceStep* step = NULL;
	uint32_t sum = 0;
	do
	{
		result = result == sole_success ? soleTracePlayer_Next( player, &step, message ) : result;
		if ( result == sole_success && step != NULL )
		{
			const soleFrame* frame = step->frame;
			sum = testFnv( sum, (const uint8_t*)step->hits, (size_t)step->hitCount * sizeof *step->hits );
			sum = testFnv( sum, (const uint8_t*)step->output, sizeof *step->output );
			size_t joints = (size_t)soleRig_GetJointCount( soleTracePlayer_GetRig( player ) );
			sum = frame->pose != NULL ? testFnv( sum, (const uint8_t*)frame->pose, 40 * joints ) : sum;
			sum = frame->supports != NULL
			    ? testFnv( sum, (const uint8_t*)frame->supports, 44 * (size_t)frame->supportCount )
			    : sum;
		}
	} while ( result == sole_success && step != NULL );
	soleCloseTrace( player );
	free( copy );
	assert_int_equal( memory.held, 0 );
	assert_in_range( memory.most, 0, 400000 + 4 * byteCount + ( sum & 1 ) );
	return result;
}

static void hostileTracesDoNoHarm( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	size_t total = traced.buffer.byteCount;
	uint8_t* bytes = malloc( total );
	uint32_t seed = 815;
	int32_t refused = 0;
	for ( int32_t round = 0; round < 3000; ++round )
	{
		memcpy( bytes, traced.buffer.bytes, total );
		size_t from = round % 2 == 0 ? 20 : 20 + testRandom( &seed ) % ( total - 24 );
		size_t reach = round % 2 == 0 ? 3500 : 4;
		for ( uint32_t i = 0; i <= testRandom( &seed ) % 3; ++i )
		{
			size_t at = from + testRandom( &seed ) % ( reach < total - from ? reach : total - from );
			bytes[at] = testRandom( &seed ) % 3 == 0 ? 0xff : (uint8_t)testRandom( &seed );
		}
		testRenewChecksums( bytes, total );
		soleMessage message;
		soleResult result = testRead( bytes, total, &message );
		if ( result != sole_success )
		{
			testIsSentence( "hostile", &message );
		}
		refused += result != sole_success;
		// Solved as well: a share of the way that is no number once read beyond the lifts.
		soleTraceReport report;
		assert_int_equal( testPlay( bytes, total, &report, &message ), result );
	}
	// Most changes of a number are believed; counts and names are not.
	assert_in_range( refused, 200, 2500 );
	free( bytes );
	testEndTraced( &traced );
}

static void wrongHeadsSayWhatIsWrong( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	static const struct
	{
		size_t at;
		uint8_t value;
		const char* says;
	} cases[] = {
		{ 0, 'x', "is none" },
		{ 8, 2, "other fields" },
		{ 16, 0, "other fields" },
		{ 20, 9, "no rig at its start" },
		{ 36, 200, "counts joints" },
		{ 40, 17, "counts joints" },
		{ 40, 0, "counts joints" },
	};
	for ( size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i )
	{
		uint8_t was = traced.buffer.bytes[cases[i].at];
		traced.buffer.bytes[cases[i].at] = cases[i].value;
		testRenewChecksums( traced.buffer.bytes, traced.buffer.byteCount );
		soleTraceReport report;
		soleMessage message;
		assert_int_equal(
		    testPlay( traced.buffer.bytes, traced.buffer.byteCount, &report, &message ), sole_invalidDefinition );
		if ( strstr( message.text, cases[i].says ) == NULL )
		{
			fail_msg( "case %d: %s", (int)i, message.text );
		}
		traced.buffer.bytes[cases[i].at] = was;
	}
	testEndTraced( &traced );
}

static void aSettingOfAnotherVersionIsNamed( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	uint8_t* at = traced.buffer.bytes;
	while ( memcmp( at, "pelvis.hold", 11 ) != 0 )
	{
		++at;
	}
	memcpy( at, "pelvis.bold", 11 );
	testRenewChecksums( traced.buffer.bytes, traced.buffer.byteCount );
	soleTraceReport report;
	soleMessage message;
	assert_int_equal(
	    testPlay( traced.buffer.bytes, traced.buffer.byteCount, &report, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "'pelvis.bold'" ) );
	testEndTraced( &traced );
}

/// Where the first chunk of a kind begins.
static uint8_t* testFindChunk( const testTraced* traced, uint32_t kind )
{
	uint8_t* at = traced->buffer.bytes + 20;
	while ( testU32At( at ) != kind )
	{
		at += 12 + testU32At( at + 4 );
	}
	return at;
}

static void otherProbesAreNamed( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	// The third of a frame's words is the checksum of what was asked; in the first frame all of them are there.
	uint8_t* frame = testFindChunk( &traced, 3 ) + 12;
	uint8_t* words = frame + 4 + ( testU32At( frame ) + 7 ) / 8;
	words[8] ^= 1;
	testRenewChecksums( traced.buffer.bytes, traced.buffer.byteCount );
	soleTraceReport report;
	soleMessage message;
	assert_int_equal( testPlay( traced.buffer.bytes, traced.buffer.byteCount, &report, &message ), sole_success );
	assert_int_equal( report.first.frame, 0 );
	assert_string_equal( report.first.field, "probes" );
	assert_int_equal( report.first.leg, SOLE_NONE );
	assert_int_equal( report.first.recorded ^ report.first.replayed, 1 );
	testEndTraced( &traced );
}

static void withoutMemoryNothingIsLeftBehind( void** state )
{
	(void)state;
	testTraced traced;
	testRecordAll( &traced );
	soleResult result = sole_outOfMemory;
	for ( int32_t failAt = 1; result == sole_outOfMemory; ++failAt )
	{
		assert_in_range( failAt, 1, 50 );
		testMemory memory = { .failAt = failAt };
		soleAllocator allocator = testCount( &memory );
		soleTraceReport report;
		soleMessage message = { { 0 } };
		result = soleReplayTrace( traced.buffer.bytes, traced.buffer.byteCount, &allocator, &report, &message );
		assert_int_equal( memory.held, 0 );
		assert_true( result == sole_success || strstr( message.text, "out of memory" ) != NULL );
		soleTraceBuffer buffer = { traced.buffer.bytes, 0, 0 };
		soleTraceSink sink = soleMakeBufferSink( &buffer );
		soleTracer* tracer = NULL;
		memory.calls = 0;
		soleResult created = soleCreateTracer( &traced.run.biped.def, &sink, &allocator, &tracer, &message );
		assert_true( ( created == sole_success ) == ( tracer != NULL ) );
		soleDestroyTracer( tracer );
		assert_int_equal( memory.held, 0 );
	}
	assert_int_equal( result, sole_success );
	testEndTraced( &traced );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( cutTracesAreRefused ),
		cmocka_unit_test( longTracesAreRefused ),
		cmocka_unit_test( everyFlippedBitIsFound ),
		cmocka_unit_test( hostileTracesDoNoHarm ),
		cmocka_unit_test( wrongHeadsSayWhatIsWrong ),
		cmocka_unit_test( otherProbesAreNamed ),
		cmocka_unit_test( aSettingOfAnotherVersionIsNamed ),
		cmocka_unit_test( withoutMemoryNothingIsLeftBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
