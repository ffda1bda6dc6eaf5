// SPDX-License-Identifier: MIT
// Crowds, from outside: the same bits as one character alone, whoever comes and goes, in whatever ranges; saved and
// restored; no memory asked for in a frame.
#include "crowd_run.h"

// ------------------------------------------------------------------------------------------------------ equal bits

static void aCrowdGivesTheBitsOfEachAlone( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, MOST );
	for ( int32_t k = 0; k < 16; ++k )
	{
		testAddWalker( &s_f, k );
	}
	for ( int32_t i = 0; i < 240; ++i )
	{
		// They come and go meanwhile.
		if ( i == 60 )
		{
			assert_true( soleRemoveFromCrowd( s_f.crowd, s_f.walkers[3].id ) );
			assert_true( soleRemoveFromCrowd( s_f.crowd, s_f.walkers[15].id ) );
		}
		if ( i == 90 )
		{
			testAddWalker( &s_f, 20 );
		}
		int32_t count = testFillFrames( &s_f, (float)i / 60.0f );
		// In two ranges, with what gathering found out or without.
		s_f.anew = i % 3 == 2;
		testStepRange( &s_f, 0, count / 3, PROBES );
		testStepRange( &s_f, count / 3, count - count / 3, PROBES );
		for ( int32_t k = 0; k < count; ++k )
		{
			testWalker* w = testWalkerAt( &s_f, k );
			testStepAlone( &s_f, w );
			testSameBits( &s_f, k, w );
		}
	}
	assert_int_equal( soleCrowd_GetCount( s_f.crowd ), 15 );
	testEndCrowd( &s_f );
}

static void settingsOfOnesOwnCount( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 4 );
	testAddWalker( &s_f, 0 );
	testAddWalker( &s_f, 1 );
	soleSettings own = soleDefaultSettings();
	own.target.height = 0.05f;
	own.probe.layout = sole_probeQuality;
	own.pelvis.speed = -5.0f; // out of its range
	soleCrowd_GetMember( s_f.crowd, 1 )->settings = &own;
	for ( int32_t i = 0; i < 60; ++i )
	{
		testFillFrames( &s_f, (float)i / 60.0f );
		testStepRange( &s_f, 0, 2, PROBES );
		for ( int32_t k = 0; k < 2; ++k )
		{
			s_f.settings = k == 1 ? own : soleDefaultSettings();
			testStepAlone( &s_f, testWalkerAt( &s_f, k ) );
			testSameBits( &s_f, k, testWalkerAt( &s_f, k ) );
		}
	}
	testEndCrowd( &s_f );
}

// ----------------------------------------------------------------------------------------------------------- names

static void idsNameOneCharacterAndNoOther( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 3 );
	soleCrowdId a = soleAddToCrowd( s_f.crowd );
	soleCrowdId b = soleAddToCrowd( s_f.crowd );
	soleCrowdId c = soleAddToCrowd( s_f.crowd );
	assert_true( a != b && b != c && a != c && a != SOLE_NO_CHARACTER );
	assert_int_equal( soleAddToCrowd( s_f.crowd ), SOLE_NO_CHARACTER );
	assert_true( soleRemoveFromCrowd( s_f.crowd, a ) );
	assert_false( soleRemoveFromCrowd( s_f.crowd, a ) );
	assert_int_equal( soleCrowd_GetIndex( s_f.crowd, a ), SOLE_NONE );
	assert_int_equal( soleCrowd_GetIndex( s_f.crowd, c ), 0 ); // the last has moved there
	assert_int_equal( soleCrowd_GetIndex( s_f.crowd, b ), 1 );
	soleCrowdId d = soleAddToCrowd( s_f.crowd );
	assert_true( d != a );
	assert_int_equal( soleCrowd_GetIndex( s_f.crowd, d ), 2 );
	for ( int32_t i = 0; i < 10000; ++i )
	{
		assert_true( soleRemoveFromCrowd( s_f.crowd, d ) );
		soleCrowdId next = soleAddToCrowd( s_f.crowd );
		assert_true( next != d && next != SOLE_NO_CHARACTER && next != b && next != c );
		d = next;
	}
	assert_int_equal( soleCrowd_GetId( s_f.crowd, 3 ), SOLE_NO_CHARACTER );
	assert_null( soleCrowd_GetMember( s_f.crowd, -1 ) );
	assert_null( soleCrowd_GetOutput( s_f.crowd, 3 ) );
	testEndCrowd( &s_f );
}

// ------------------------------------------------------------------------------------------------------ bad numbers

static void whateverIsNoNumberStaysInItsOwnRow( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 2 );
	testAddWalker( &s_f, 0 );
	testAddWalker( &s_f, 1 );
	for ( int32_t i = 0; i < 30; ++i )
	{
		testFillFrames( &s_f, (float)i / 60.0f );
		if ( i == 10 )
		{
			s_f.walkers[0].pose[biped_kneeL].rotation.x = NAN;
			s_f.frames[0].root.translation.y = NAN;
		}
		if ( i == 11 )
		{
			s_f.frames[0].pose = NULL;
		}
		testStepRange( &s_f, 0, 2, PROBES );
		testStepAlone( &s_f, testWalkerAt( &s_f, 1 ) );
		testSameBits( &s_f, 1, testWalkerAt( &s_f, 1 ) );
		const soleOutput* out = soleCrowd_GetOutput( s_f.crowd, 0 );
		assert_true(
		    soleQuat_IsFinite( out->legs[0].rotations_l[1] ) && soleVec3_IsFinite( out->pelvisTranslation_l ) );
	}
	testEndCrowd( &s_f );
}

// -------------------------------------------------------------------------------------------------- save, threads

static void aRestoredCrowdGoesOnToTheBit( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 8 );
	for ( int32_t k = 0; k < 6; ++k )
	{
		testAddWalker( &s_f, k );
		soleCrowd_GetMember( s_f.crowd, k )->interval = 1 + k % 3;
	}
	size_t size = soleCrowd_GetByteCount( s_f.crowd );
	unsigned char* saved = malloc( size );
	unsigned char* once = malloc( size );
	unsigned char* again = malloc( size );
	for ( int32_t round = 0; round < 2; ++round )
	{
		for ( int32_t i = round == 0 ? 0 : 50; i < 100; ++i )
		{
			if ( i == 50 && round == 0 )
			{
				soleSaveCrowd( s_f.crowd, saved );
				assert_true( soleRemoveFromCrowd( s_f.crowd, s_f.walkers[2].id ) );
				testAddWalker( &s_f, 7 );
				assert_true( soleRestoreCrowd( s_f.crowd, saved, size ) );
			}
			int32_t count = testFillFrames( &s_f, (float)i / 60.0f );
			testStepRange( &s_f, 0, count, PROBES );
		}
		soleSaveCrowd( s_f.crowd, round == 0 ? once : again );
		assert_true( soleRestoreCrowd( s_f.crowd, saved, size ) );
	}
	assert_memory_equal( once, again, size );
	assert_false( soleRestoreCrowd( s_f.crowd, saved, size - 1 ) );
	memset( saved, 0x5a, 64 );
	assert_false( soleRestoreCrowd( s_f.crowd, saved, size ) );
	assert_int_equal( soleCrowd_GetCount( s_f.crowd ), 6 );
	free( saved );
	free( once );
	free( again );
	testEndCrowd( &s_f );
}

static void aFrameAsksForNoMemory( void** state )
{
	(void)state;
	testBeginCrowd( &s_f, 8 );
	int32_t before = s_allocations;
	for ( int32_t k = 0; k < 8; ++k )
	{
		testAddWalker( &s_f, k );
	}
	for ( int32_t i = 0; i < 60; ++i )
	{
		int32_t count = testFillFrames( &s_f, (float)i / 60.0f );
		testStepRange( &s_f, 0, count, PROBES );
		assert_true( soleRemoveFromCrowd( s_f.crowd, s_f.walkers[i % 8].id ) );
		testAddWalker( &s_f, i % 8 );
	}
	assert_int_equal( s_allocations, before );
	testEndCrowd( &s_f );
}

typedef struct Half
{
	int32_t first;
	int32_t count;
	soleProbe probes[PROBES];
	soleHit hits[PROBES];
	void* work;
} Half;

static int solveHalf( void* user )
{
	Half* half = user;
	soleFrame* frames = s_f.frames + half->first;
	soleCrowdAsk* asks = s_f.asks + half->first;
	int32_t n = soleGatherCrowd( s_f.crowd, half->first, half->count, frames, half->probes, PROBES, asks, half->work );
	for ( int32_t i = 0; i < n; ++i )
	{
		testCastAt( &s_f.ground, half->probes + i, half->hits + i );
	}
	soleSolveCrowd( s_f.crowd, half->first, half->count, frames, half->probes, half->hits, asks, half->work );
	return 0;
}

static void twoThreadsGiveTheSameBits( void** state )
{
	(void)state;
	static Half halves[2];
	testBeginCrowd( &s_f, MOST );
	for ( int32_t k = 0; k < MOST; ++k )
	{
		testAddWalker( &s_f, k );
	}
	halves[0] = ( Half ){ .first = 0, .count = MOST / 2 };
	halves[1] = ( Half ){ .first = MOST / 2, .count = MOST - MOST / 2 };
	for ( int32_t k = 0; k < 2; ++k )
	{
		halves[k].work = malloc( soleCrowd_GetWorkSize( s_f.crowd, halves[k].count ) );
		assert_non_null( halves[k].work );
	}
	for ( int32_t i = 0; i < 60; ++i )
	{
		testFillFrames( &s_f, (float)i / 60.0f );
		thrd_t threads[2];
		for ( int32_t k = 0; k < 2; ++k )
		{
			assert_int_equal( thrd_create( threads + k, solveHalf, halves + k ), thrd_success );
		}
		for ( int32_t k = 0; k < 2; ++k )
		{
			assert_int_equal( thrd_join( threads[k], NULL ), thrd_success );
		}
		for ( int32_t k = 0; k < MOST; ++k )
		{
			testStepAlone( &s_f, testWalkerAt( &s_f, k ) );
			testSameBits( &s_f, k, testWalkerAt( &s_f, k ) );
		}
	}
	free( halves[0].work );
	free( halves[1].work );
	testEndCrowd( &s_f );
}

// ---------------------------------------------------------------------------------------------------------- misuse

static void badDefinitionsAreRefusedByName( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleCrowd* crowd = (soleCrowd*)&biped;
	soleMessage message;
	soleCrowdDef def = soleDefaultCrowdDef();
	assert_int_equal( soleCreateCrowd( &def, NULL, &crowd, &message ), sole_invalidDefinition );
	assert_null( crowd );
	assert_non_null( strstr( message.text, "rig" ) );
	def.rig = biped.rig;
	const int32_t bad[] = { 0, -1, 1048577 };
	for ( int32_t i = 0; i < 3; ++i )
	{
		def.capacity = bad[i];
		assert_int_equal( soleCreateCrowd( &def, NULL, &crowd, &message ), sole_invalidDefinition );
		assert_non_null( strstr( message.text, "capacity" ) );
	}
	soleCrowdDef forgotten = { .rig = biped.rig, .capacity = 4 };
	assert_int_equal( soleCreateCrowd( &forgotten, NULL, &crowd, &message ), sole_invalidDefinition );
	assert_non_null( strstr( message.text, "soleDefaultCrowdDef" ) );
	soleDestroyRig( biped.rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aCrowdGivesTheBitsOfEachAlone ),
		cmocka_unit_test( settingsOfOnesOwnCount ),
		cmocka_unit_test( idsNameOneCharacterAndNoOther ),
		cmocka_unit_test( whateverIsNoNumberStaysInItsOwnRow ),
		cmocka_unit_test( aRestoredCrowdGoesOnToTheBit ),
		cmocka_unit_test( aFrameAsksForNoMemory ),
		cmocka_unit_test( twoThreadsGiveTheSameBits ),
		cmocka_unit_test( badDefinitionsAreRefusedByName ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
