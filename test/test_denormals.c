// SPDX-License-Identifier: MIT
// Numbers below the least normal float, which many processors take a hundred times as long for and which hosts often
// have switched off: none is left in what is remembered, none is met by one who stands, and a processor that flushes
// them to zero gives the same bits.
#include "biped_walk.h"

#include <fenv.h>
#include <math.h>

#if defined( __SSE2__ )
#include <immintrin.h>
#define FLUSH 0x8040u // results and operands
#endif

#define WALK_FRAMES 180
#define STAND_FRAMES 1200 // 20 s: as long as it takes from a metre to nothing, and more

/// Up stairs for 3 s, then standing across two of them.
static void stepWanderer( testRun* run, int32_t index )
{
	static soleContactInput contacts[2];
	static soleStepInput inputs[2];
	const testWalk walk = { .speed = 1.1f, .period = 1.1f, .lift = 0.1f };
	if ( index >= WALK_FRAMES )
	{
		run->frame.contact = NULL;
		run->frame.steps = NULL;
		memcpy( run->pose, run->biped.bindPose, sizeof run->pose );
		testBendKnees( run->pose, 0.3f );
		testStepRun( run );
		return;
	}
	float time = (float)index / 60.0f;
	float z = walk.speed * time;
	run->frame.root.translation = soleVec( 0.0f, testGroundHeight( &run->ground, 0.0f, z ), z );
	testWalkOn( run, &walk, time, contacts, inputs );
}

static void startWanderer( testRun* run )
{
	testStartRun( run, 0.3f );
	run->ground.slopeX = 0.05f;
	run->ground.stairs = 1.5f;
	run->ground.tread = 0.4f;
	run->ground.rise = 0.12f;
}

static bool isDenormal( uint32_t word )
{
	return ( word & 0x7f800000u ) == 0 && ( word & 0x007fffffu ) != 0;
}

/// @param change what is different in the settings. May be NULL
static void checkMemory( void ( *change )( soleSettings* settings ) )
{
	static testRun run;
	startWanderer( &run );
	change != NULL ? change( &run.settings ) : (void)0;
	size_t first = offsetof( soleState, root_w ) / 4;
	size_t legs = offsetof( soleState, legs ) / 4;
	for ( int32_t i = 0; i < WALK_FRAMES + STAND_FRAMES; ++i )
	{
		// What ticks follow comes to nothing with the ground.
		bool flat = run.settings.support.filter == sole_filterTick && i >= WALK_FRAMES;
		run.ground.slopeX = flat ? 0.0f : run.ground.slopeX;
		run.ground.rise = flat ? 0.0f : run.ground.rise;
		run.frame.root.translation.y = flat ? 0.0f : run.frame.root.translation.y;
		stepWanderer( &run, i );
		static uint32_t words[sizeof( soleState ) / 4];
		memcpy( words, &run.state, sizeof run.state );
		for ( size_t k = first; k < soleState_GetByteCount( run.biped.rig ) / 4; ++k )
		{
			// All are floats but the origin of the world, flags and surfaces.
			bool isFloat = k * 4 < offsetof( soleState, worldOrigin ) ||
			    ( k >= legs && ( k - legs ) % ( sizeof( soleLegState ) / 4 ) > 1 );
			if ( isFloat && isDenormal( words[k] ) )
			{
				fail_msg( "frame %d: word %d of the state is 0x%08x", i, (int)k, words[k] );
			}
		}
	}
	testEndRun( &run );
}

static void takeLayers( soleSettings* settings )
{
	settings->layer.knee = 0.3f;
	settings->layer.hips = 0.1f;
	settings->layer.lean = 0.3f;
	settings->target.secondFrom = 0.0f;
	settings->activity.running = 0.0f;
	settings->activity.slow = 0.0f;
	settings->activity.fast = 0.5f;
	settings->activity.airborne = 0.0f;
}

static void takeTicks( soleSettings* settings )
{
	settings->support.filter = sole_filterTick;
}

static void nothingThatIsRememberedIsDenormal( void** state )
{
	(void)state;
	checkMemory( NULL );
	checkMemory( takeLayers );
	checkMemory( takeTicks );
}

static void oneWhoStandsMeetsNone( void** state )
{
	(void)state;
	static testRun run;
	startWanderer( &run );
	for ( int32_t i = 0; i < WALK_FRAMES + STAND_FRAMES; ++i )
	{
		stepWanderer( &run, i );
	}
	feclearexcept( FE_ALL_EXCEPT );
	testStep( &run.biped, &run.settings, &run.state, &run.frame, &run.ground, &run.out );
	assert_int_equal( fetestexcept( FE_UNDERFLOW ), 0 );
	testEndRun( &run );
}

static void flushingThemToZeroChangesNoBit( void** state )
{
	(void)state;
#if defined( FLUSH )
	static testRun plain, flushed;
	startWanderer( &plain );
	startWanderer( &flushed );
	for ( int32_t i = 0; i < WALK_FRAMES + STAND_FRAMES; ++i )
	{
		stepWanderer( &plain, i );
		uint32_t kept = _mm_getcsr();
		_mm_setcsr( kept | FLUSH );
		stepWanderer( &flushed, i );
		_mm_setcsr( kept );
		if ( memcmp( plain.placed, flushed.placed, sizeof plain.placed ) != 0 )
		{
			fail_msg( "frame %d: another pose", i );
		}
	}
	testEndRun( &plain );
	testEndRun( &flushed );
#else
	print_message( "left out: how to flush numbers to zero is only known of SSE2 here\n" );
	skip();
#endif
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( nothingThatIsRememberedIsDenormal ),
		cmocka_unit_test( oneWhoStandsMeetsNone ),
		cmocka_unit_test( flushingThemToZeroChangesNoBit ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
