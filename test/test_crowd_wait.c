// SPDX-License-Identifier: MIT
// What crowds do less, from outside: levels of detail, waiting, budgets, jumps and bad frames in the meantime.
#include "crowd_run.h"

// --------------------------------------------------------------------------------------------------- less and later

static float soleOver( testCrowd* f, int32_t index, int32_t leg )
{
	testWalker* w = testWalkerAt( f, index );
	soleTransform placed[biped_count];
	memcpy( placed, w->pose, sizeof placed );
	soleApply( f->biped.rig, soleCrowd_GetOutput( f->crowd, index ), placed );
	soleVec3 ankle = testJoint( &f->biped, placed, w->frame.root, testAnkle( leg ) ).translation;
	return ankle.y - testGroundHeight( &f->ground, ankle.x, ankle.z );
}

static void lessDetailAsksLessAndStillStands( void** state )
{
	(void)state;
	const int32_t most[] = { 100, 8, 8 };
	for ( int32_t detail = 0; detail < 3; ++detail )
	{
		testBeginCrowd( &s_f, 2 );
		s_f.ground.slopeX = 0.0f;
		s_f.ground.slopeZ = detail == 2 ? 0.0f : 0.1f;
		testAddWalker( &s_f, 2 );
		soleCrowd_GetMember( s_f.crowd, 0 )->detail = (soleDetail)detail;
		float worst = 0.0f;
		int32_t largest = 0;
		for ( int32_t i = 0; i < 200; ++i )
		{
			float time = (float)i / 60.0f;
			testFillFrames( &s_f, time );
			int32_t n = testStepRange( &s_f, 0, 1, PROBES );
			largest = i > 0 && n > largest ? n : largest;
			for ( int32_t leg = 0; leg < 2 && i > 60; ++leg )
			{
				testWalker* w = testWalkerAt( &s_f, 0 );
				float phase = testWalkPhase( &w->walk, time + w->phase, leg );
				bool stands = phase > 0.2f && phase < 0.5f;
				worst = stands ? fmaxf( worst, fabsf( soleOver( &s_f, 0, leg ) - 0.08f ) ) : worst;
			}
		}
		assert_true( largest <= most[detail] );
		assert_true( worst < 0.02f );
		testEndCrowd( &s_f );
	}
}

static void oneThatWaitsKeepsWhatItsFeetAreOff( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 2 );
	testAddWalker( &s_f, 0 );
	testAddWalker( &s_f, 0 );
	s_f.walkers[1] = s_f.walkers[0];
	s_f.walkers[1].id = soleCrowd_GetId( s_f.crowd, 1 );
	s_f.walkers[0].id = soleCrowd_GetId( s_f.crowd, 0 );
	soleCrowd_GetMember( s_f.crowd, 1 )->interval = 4;
	int32_t solved = 0;
	float apart = 0.0f, largest = 0.0f;
	soleQuat last = soleQuat_Identity();
	for ( int32_t i = 0; i < 240; ++i )
	{
		testFillFrames( &s_f, (float)i / 60.0f );
		testStepRange( &s_f, 0, 2, PROBES );
		solved += s_f.asks[1].waits ? 0 : 1;
		soleQuat every = soleCrowd_GetOutput( s_f.crowd, 0 )->legs[0].rotations_l[1];
		soleQuat fourth = soleCrowd_GetOutput( s_f.crowd, 1 )->legs[0].rotations_l[1];
		apart = i > 4 ? fmaxf( apart, testAngle( every, fourth ) ) : apart;
		largest = i > 4 ? fmaxf( largest, testAngle( fourth, last ) ) : largest;
		last = fourth;
	}
	assert_in_range( solved, 59, 62 );
	assert_true( apart > 1e-4f && apart < 0.2f );
	assert_true( largest < 0.25f );
	testEndCrowd( &s_f );
}

static void aBudgetIsKeptAndGoesRound( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 20 );
	for ( int32_t k = 0; k < 20; ++k )
	{
		testAddWalker( &s_f, k );
	}
	int32_t waited[20] = { 0 }, longest = 0, probes = 0;
	for ( int32_t i = 0; i < 300; ++i )
	{
		int32_t count = testFillFrames( &s_f, (float)i / 60.0f );
		// The first frame asks much of everyone.
		int32_t n = testStepRange( &s_f, 0, count, i == 0 ? PROBES : 150 );
		probes += i > 0 ? n : 0;
		for ( int32_t k = 0; k < count; ++k )
		{
			waited[k] = s_f.asks[k].waits ? waited[k] + 1 : 0;
			longest = waited[k] > longest ? waited[k] : longest;
		}
	}
	print_message( "waited for at most %d frames\n", longest );
	assert_true( longest > 0 && longest < 12 );
	assert_true( probes > 290 * 75 );
	testEndCrowd( &s_f );
}

static void aJumpIsNotMissedByOneThatWaits( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 1 );
	testAddWalker( &s_f, 0 );
	soleCrowd_GetMember( s_f.crowd, 0 )->interval = 8;
	for ( int32_t i = 0; i < 40; ++i )
	{
		testFillFrames( &s_f, (float)i / 60.0f );
		bool jump = i == 21;
		s_f.frames[0].teleport = jump;
		// No room for its probes just then.
		testStepRange( &s_f, 0, 1, jump ? 1 : PROBES );
		assert_true( jump == false || s_f.asks[0].waits );
		uint32_t seen = soleCrowd_GetState( s_f.crowd, 0 )->frameCount;
		assert_true( i != 20 || seen > 2 );
		assert_true( i != 29 || seen <= 2 );
	}
	testEndCrowd( &s_f );
}

// What joints were turned by is that of the last solved frame, whatever came in between.
static void aFrameThatIsRefusedDoesNotTurnOneThatWaits( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 1 );
	testAddWalker( &s_f, 0 );
	soleCrowd_GetMember( s_f.crowd, 0 )->interval = 8;
	void* saved = malloc( soleCrowd_GetByteCount( s_f.crowd ) );
	soleQuat turns[2];
	int32_t number = 0;
	for ( bool solved = false; number < 60 || solved == false; ++number )
	{
		testFillFrames( &s_f, (float)number / 60.0f );
		testStepRange( &s_f, 0, 1, PROBES );
		solved = s_f.asks[0].waits == false;
	}
	soleSaveCrowd( s_f.crowd, saved );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleRestoreCrowd( s_f.crowd, saved, soleCrowd_GetByteCount( s_f.crowd ) );
		testFillFrames( &s_f, (float)number / 60.0f );
		s_f.frames[0].up.x = i == 0 ? 0.0f : NAN;
		testStepRange( &s_f, 0, 1, PROBES );
		testFillFrames( &s_f, (float)( number + 1 ) / 60.0f );
		testStepRange( &s_f, 0, 1, PROBES );
		assert_true( s_f.asks[0].waits );
		turns[i] = soleCrowd_GetOutput( s_f.crowd, 0 )->legs[0].rotations_l[1];
	}
	assert_memory_equal( turns, turns + 1, sizeof turns[0] );
	soleQuat animated = s_f.walkers[0].pose[biped_kneeL].rotation;
	assert_true( testAngle( turns[0], animated ) > 1e-3f );
	free( saved );
	testEndCrowd( &s_f );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( lessDetailAsksLessAndStillStands ),
		cmocka_unit_test( oneThatWaitsKeepsWhatItsFeetAreOff ),
		cmocka_unit_test( aBudgetIsKeptAndGoesRound ),
		cmocka_unit_test( aJumpIsNotMissedByOneThatWaits ),
		cmocka_unit_test( aFrameThatIsRefusedDoesNotTurnOneThatWaits ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
