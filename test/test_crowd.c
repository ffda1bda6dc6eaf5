// SPDX-License-Identifier: MIT
// Crowds, from outside: the same bits as one character alone, whoever comes and goes, in whatever ranges; levels of
// detail, waiting, budgets; saved and restored; no memory asked for in a frame.
#include "biped_walk.h"

#include "sole/crowd.h"

#include <stdlib.h>
#include <threads.h>

#define MOST 24
#define PROBES 4096

static int32_t s_allocations;

static void* countAlloc( size_t byteCount, void* user )
{
	(void)user;
	s_allocations += 1;
	return malloc( byteCount );
}

static void countFree( void* memory, size_t byteCount, void* user )
{
	(void)byteCount;
	(void)user;
	s_allocations -= 1;
	free( memory );
}

static const soleAllocator s_allocator = { countAlloc, countFree, NULL };

/// One character of a test: how it walks, and its frame.
typedef struct Walker
{
	testWalk walk;
	float phase;
	soleVec3 start;
	soleTransform pose[biped_count];
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	soleFrame frame;
	soleState state; // of its own, solved alone
	soleOutput out;
	soleCrowdId id;
} Walker;

typedef struct Fixture
{
	testBiped biped;
	testGround ground;
	soleSettings settings;
	soleCrowd* crowd;
	Walker walkers[MOST];
	soleFrame frames[MOST];
	soleCrowdAsk asks[MOST];
	soleProbe probes[PROBES];
	soleHit hits[PROBES];
	void* work;
	bool anew; // solving begins its frames anew
} Fixture;

static Fixture s_f;

static void begin( Fixture* f, int32_t capacity )
{
	memset( f, 0, sizeof *f );
	testMakeBiped( &f->biped );
	f->ground = testFlatGround;
	f->ground.slopeZ = 0.1f;
	f->ground.slopeX = 0.05f;
	f->ground.stairs = 3.0f;
	f->ground.tread = 0.4f;
	f->ground.rise = 0.12f;
	f->settings = soleDefaultSettings();
	soleCrowdDef def = soleDefaultCrowdDef();
	def.rig = f->biped.rig;
	def.capacity = capacity;
	assert_int_equal( soleCreateCrowd( &def, &s_allocator, &f->crowd, NULL ), sole_success );
	f->work = malloc( soleCrowd_GetWorkSize( f->crowd, MOST ) );
	assert_non_null( f->work );
	memset( f->work, 0xa5, soleCrowd_GetWorkSize( f->crowd, MOST ) );
	for ( int32_t i = 0; i < MOST; ++i )
	{
		Walker* w = f->walkers + i;
		w->walk = ( testWalk ){ 0.7f + 0.05f * (float)i, 1.1f - 0.02f * (float)i, 0.08f };
		w->phase = 0.37f * (float)i;
		w->start = soleVec( 0.2f * (float)i - 2.0f, 0.0f, 0.11f * (float)i );
	}
}

static void end( Fixture* f )
{
	free( f->work );
	soleDestroyCrowd( f->crowd );
	soleDestroyRig( f->biped.rig );
	assert_int_equal( s_allocations, 0 );
}

static soleCrowdId add( Fixture* f, int32_t k )
{
	Walker* w = f->walkers + k;
	w->state = soleDefaultState( f->biped.rig );
	w->id = soleAddToCrowd( f->crowd );
	return w->id;
}

static void pose( Fixture* f, Walker* w, float time )
{
	memcpy( w->pose, f->biped.bindPose, sizeof w->pose );
	testPoseWalk( w->pose, &w->walk, time + w->phase );
	testTellWalk( &w->walk, time + w->phase, w->contacts, w->inputs );
	w->frame = testFrame( w->pose );
	w->frame.contact = w->contacts;
	w->frame.steps = w->inputs;
	w->frame.root.translation = soleVec( w->start.x, 0.0f, w->start.z + w->walk.speed * time );
	soleVec3* root = &w->frame.root.translation;
	root->y = testGroundHeight( &f->ground, root->x, root->z );
}

static Walker* walkerAt( Fixture* f, int32_t index )
{
	soleCrowdId id = soleCrowd_GetId( f->crowd, index );
	for ( int32_t i = 0; i < MOST; ++i )
	{
		if ( f->walkers[i].id == id )
		{
			return f->walkers + i;
		}
	}
	fail_msg( "no walker of that id" );
	return f->walkers;
}

/// Frames of all characters of the crowd, in its order.
static int32_t fillFrames( Fixture* f, float time )
{
	int32_t count = soleCrowd_GetCount( f->crowd );
	for ( int32_t i = 0; i < count; ++i )
	{
		Walker* w = walkerAt( f, i );
		pose( f, w, time );
		f->frames[i] = w->frame;
	}
	return count;
}

static int32_t stepRange( Fixture* f, int32_t first, int32_t count, int32_t capacity )
{
	soleFrame* frames = f->frames + first;
	soleCrowdAsk* asks = f->asks + first;
	void* work = f->anew ? NULL : f->work;
	int32_t n = soleGatherCrowd( f->crowd, first, count, frames, f->probes, capacity, asks, work );
	assert_true( n <= capacity );
	for ( int32_t i = 0; i < n; ++i )
	{
		assert_true( f->probes[i].length > 0.0f );
		testCastAt( &f->ground, f->probes + i, f->hits + i );
	}
	soleSolveCrowd( f->crowd, first, count, frames, f->probes, f->hits, asks, work );
	return n;
}

static void stepAlone( Fixture* f, Walker* w )
{
	testStep( &f->biped, &f->settings, &w->state, &w->frame, &f->ground, &w->out );
}

static size_t outputSize( const Fixture* f )
{
	return offsetof( soleOutput, legs ) + (size_t)soleRig_GetLegCount( f->biped.rig ) * sizeof( soleLegOutput );
}

static void sameBits( const Fixture* f, int32_t index, const Walker* w )
{
	const soleOutput* out = soleCrowd_GetOutput( f->crowd, index );
	assert_memory_equal( out, &w->out, outputSize( f ) );
	soleState* state = soleCrowd_GetState( f->crowd, index );
	assert_memory_equal( state, &w->state, soleState_GetByteCount( f->biped.rig ) );
}

// ------------------------------------------------------------------------------------------------------ equal bits

static void aCrowdGivesTheBitsOfEachAlone( void** state )
{
	(void)state;
	begin( &s_f, MOST );
	for ( int32_t k = 0; k < 16; ++k )
	{
		add( &s_f, k );
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
			add( &s_f, 20 );
		}
		int32_t count = fillFrames( &s_f, (float)i / 60.0f );
		// In two ranges, with what gathering found out or without.
		s_f.anew = i % 3 == 2;
		stepRange( &s_f, 0, count / 3, PROBES );
		stepRange( &s_f, count / 3, count - count / 3, PROBES );
		for ( int32_t k = 0; k < count; ++k )
		{
			Walker* w = walkerAt( &s_f, k );
			stepAlone( &s_f, w );
			sameBits( &s_f, k, w );
		}
	}
	assert_int_equal( soleCrowd_GetCount( s_f.crowd ), 15 );
	end( &s_f );
}

static void settingsOfOnesOwnCount( void** state )
{
	(void)state;
	begin( &s_f, 4 );
	add( &s_f, 0 );
	add( &s_f, 1 );
	soleSettings own = soleDefaultSettings();
	own.target.height = 0.05f;
	own.probe.layout = sole_probeQuality;
	own.pelvis.speed = -5.0f; // out of its range
	soleCrowd_GetMember( s_f.crowd, 1 )->settings = &own;
	for ( int32_t i = 0; i < 60; ++i )
	{
		fillFrames( &s_f, (float)i / 60.0f );
		stepRange( &s_f, 0, 2, PROBES );
		for ( int32_t k = 0; k < 2; ++k )
		{
			s_f.settings = k == 1 ? own : soleDefaultSettings();
			stepAlone( &s_f, walkerAt( &s_f, k ) );
			sameBits( &s_f, k, walkerAt( &s_f, k ) );
		}
	}
	end( &s_f );
}

// ----------------------------------------------------------------------------------------------------------- names

static void idsNameOneCharacterAndNoOther( void** state )
{
	(void)state;
	begin( &s_f, 3 );
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
	end( &s_f );
}

// --------------------------------------------------------------------------------------------------- less and later

static float soleOver( Fixture* f, int32_t index, int32_t leg )
{
	Walker* w = walkerAt( f, index );
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
		begin( &s_f, 2 );
		s_f.ground.slopeX = 0.0f;
		s_f.ground.slopeZ = detail == 2 ? 0.0f : 0.1f;
		add( &s_f, 2 );
		soleCrowd_GetMember( s_f.crowd, 0 )->detail = (soleDetail)detail;
		float worst = 0.0f;
		int32_t largest = 0;
		for ( int32_t i = 0; i < 200; ++i )
		{
			float time = (float)i / 60.0f;
			fillFrames( &s_f, time );
			int32_t n = stepRange( &s_f, 0, 1, PROBES );
			largest = i > 0 && n > largest ? n : largest;
			for ( int32_t leg = 0; leg < 2 && i > 60; ++leg )
			{
				Walker* w = walkerAt( &s_f, 0 );
				float phase = testWalkPhase( &w->walk, time + w->phase, leg );
				bool stands = phase > 0.2f && phase < 0.5f;
				worst = stands ? fmaxf( worst, fabsf( soleOver( &s_f, 0, leg ) - 0.08f ) ) : worst;
			}
		}
		assert_true( largest <= most[detail] );
		assert_true( worst < 0.02f );
		end( &s_f );
	}
}

static void oneThatWaitsKeepsWhatItsFeetAreOff( void** state )
{
	(void)state;
	begin( &s_f, 2 );
	add( &s_f, 0 );
	add( &s_f, 0 );
	s_f.walkers[1] = s_f.walkers[0];
	s_f.walkers[1].id = soleCrowd_GetId( s_f.crowd, 1 );
	s_f.walkers[0].id = soleCrowd_GetId( s_f.crowd, 0 );
	soleCrowd_GetMember( s_f.crowd, 1 )->interval = 4;
	int32_t solved = 0;
	float apart = 0.0f, largest = 0.0f;
	soleQuat last = soleQuat_Identity();
	for ( int32_t i = 0; i < 240; ++i )
	{
		fillFrames( &s_f, (float)i / 60.0f );
		stepRange( &s_f, 0, 2, PROBES );
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
	end( &s_f );
}

static void aBudgetIsKeptAndGoesRound( void** state )
{
	(void)state;
	begin( &s_f, 20 );
	for ( int32_t k = 0; k < 20; ++k )
	{
		add( &s_f, k );
	}
	int32_t waited[20] = { 0 }, longest = 0, probes = 0;
	for ( int32_t i = 0; i < 300; ++i )
	{
		int32_t count = fillFrames( &s_f, (float)i / 60.0f );
		// The first frame asks much of everyone.
		int32_t n = stepRange( &s_f, 0, count, i == 0 ? PROBES : 150 );
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
	end( &s_f );
}

static void aJumpIsNotMissedByOneThatWaits( void** state )
{
	(void)state;
	begin( &s_f, 1 );
	add( &s_f, 0 );
	soleCrowd_GetMember( s_f.crowd, 0 )->interval = 8;
	for ( int32_t i = 0; i < 40; ++i )
	{
		fillFrames( &s_f, (float)i / 60.0f );
		bool jump = i == 21;
		s_f.frames[0].teleport = jump;
		// No room for its probes just then.
		stepRange( &s_f, 0, 1, jump ? 1 : PROBES );
		assert_true( jump == false || s_f.asks[0].waits );
		uint32_t seen = soleCrowd_GetState( s_f.crowd, 0 )->frameCount;
		assert_true( i != 20 || seen > 2 );
		assert_true( i != 29 || seen <= 2 );
	}
	end( &s_f );
}

static void whateverIsNoNumberStaysInItsOwnRow( void** state )
{
	(void)state;
	begin( &s_f, 2 );
	add( &s_f, 0 );
	add( &s_f, 1 );
	for ( int32_t i = 0; i < 30; ++i )
	{
		fillFrames( &s_f, (float)i / 60.0f );
		if ( i == 10 )
		{
			s_f.walkers[0].pose[biped_kneeL].rotation.x = NAN;
			s_f.frames[0].root.translation.y = NAN;
		}
		if ( i == 11 )
		{
			s_f.frames[0].pose = NULL;
		}
		stepRange( &s_f, 0, 2, PROBES );
		stepAlone( &s_f, walkerAt( &s_f, 1 ) );
		sameBits( &s_f, 1, walkerAt( &s_f, 1 ) );
		const soleOutput* out = soleCrowd_GetOutput( s_f.crowd, 0 );
		assert_true(
		    soleQuat_IsFinite( out->legs[0].rotations_l[1] ) && soleVec3_IsFinite( out->pelvisTranslation_l ) );
	}
	end( &s_f );
}

// -------------------------------------------------------------------------------------------------- save, threads

static void aRestoredCrowdGoesOnToTheBit( void** state )
{
	(void)state;
	begin( &s_f, 8 );
	for ( int32_t k = 0; k < 6; ++k )
	{
		add( &s_f, k );
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
				add( &s_f, 7 );
				assert_true( soleRestoreCrowd( s_f.crowd, saved, size ) );
			}
			int32_t count = fillFrames( &s_f, (float)i / 60.0f );
			stepRange( &s_f, 0, count, PROBES );
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
	end( &s_f );
}

static void aFrameAsksForNoMemory( void** state )
{
	(void)state;
	begin( &s_f, 8 );
	int32_t before = s_allocations;
	for ( int32_t k = 0; k < 8; ++k )
	{
		add( &s_f, k );
	}
	for ( int32_t i = 0; i < 60; ++i )
	{
		int32_t count = fillFrames( &s_f, (float)i / 60.0f );
		stepRange( &s_f, 0, count, PROBES );
		assert_true( soleRemoveFromCrowd( s_f.crowd, s_f.walkers[i % 8].id ) );
		add( &s_f, i % 8 );
	}
	assert_int_equal( s_allocations, before );
	end( &s_f );
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
	begin( &s_f, MOST );
	for ( int32_t k = 0; k < MOST; ++k )
	{
		add( &s_f, k );
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
		fillFrames( &s_f, (float)i / 60.0f );
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
			stepAlone( &s_f, walkerAt( &s_f, k ) );
			sameBits( &s_f, k, walkerAt( &s_f, k ) );
		}
	}
	free( halves[0].work );
	free( halves[1].work );
	end( &s_f );
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
		cmocka_unit_test( lessDetailAsksLessAndStillStands ),
		cmocka_unit_test( oneThatWaitsKeepsWhatItsFeetAreOff ),
		cmocka_unit_test( aBudgetIsKeptAndGoesRound ),
		cmocka_unit_test( aJumpIsNotMissedByOneThatWaits ),
		cmocka_unit_test( whateverIsNoNumberStaysInItsOwnRow ),
		cmocka_unit_test( aRestoredCrowdGoesOnToTheBit ),
		cmocka_unit_test( aFrameAsksForNoMemory ),
		cmocka_unit_test( twoThreadsGiveTheSameBits ),
		cmocka_unit_test( badDefinitionsAreRefusedByName ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
