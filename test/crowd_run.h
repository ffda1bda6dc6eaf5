// SPDX-License-Identifier: MIT
// A crowd of plain bipeds that walk over one ground, each also solved alone, and how its memory is asked for.
#ifndef TEST_CROWD_RUN_H
#define TEST_CROWD_RUN_H

#include "biped_walk.h"

#include "sole/crowd.h"

#include <stdlib.h>
#include <threads.h>

#define MOST 24
#define PROBES 4096

static int32_t s_allocations;

static inline void* testCountAlloc( size_t byteCount, void* user )
{
	(void)user;
	s_allocations += 1;
	return malloc( byteCount );
}

static inline void testCountFree( void* memory, size_t byteCount, void* user )
{
	(void)byteCount;
	(void)user;
	s_allocations -= 1;
	free( memory );
}

static const soleAllocator s_allocator = { testCountAlloc, testCountFree, NULL };

/// One character of a test: how it walks, and its frame.
typedef struct testWalker
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
} testWalker;

typedef struct testCrowd
{
	testBiped biped;
	testGround ground;
	soleSettings settings;
	soleCrowd* crowd;
	testWalker walkers[MOST];
	soleFrame frames[MOST];
	soleCrowdAsk asks[MOST];
	soleProbe probes[PROBES];
	soleHit hits[PROBES];
	void* work;
	bool anew; // solving begins its frames anew
} testCrowd;

static testCrowd s_f;

static inline void testBeginCrowd( testCrowd* f, int32_t capacity )
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
		testWalker* w = f->walkers + i;
		w->walk = ( testWalk ){ 0.7f + 0.05f * (float)i, 1.1f - 0.02f * (float)i, 0.08f };
		w->phase = 0.37f * (float)i;
		w->start = soleVec( 0.2f * (float)i - 2.0f, 0.0f, 0.11f * (float)i );
	}
}

static inline void testEndCrowd( testCrowd* f )
{
	free( f->work );
	soleDestroyCrowd( f->crowd );
	soleDestroyRig( f->biped.rig );
	assert_int_equal( s_allocations, 0 );
}

static inline soleCrowdId testAddWalker( testCrowd* f, int32_t k )
{
	testWalker* w = f->walkers + k;
	w->state = soleDefaultState( f->biped.rig );
	w->id = soleAddToCrowd( f->crowd );
	return w->id;
}

static inline void testPoseWalker( testCrowd* f, testWalker* w, float time )
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

static inline testWalker* testWalkerAt( testCrowd* f, int32_t index )
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
static inline int32_t testFillFrames( testCrowd* f, float time )
{
	int32_t count = soleCrowd_GetCount( f->crowd );
	for ( int32_t i = 0; i < count; ++i )
	{
		testWalker* w = testWalkerAt( f, i );
		testPoseWalker( f, w, time );
		f->frames[i] = w->frame;
	}
	return count;
}

static inline int32_t testStepRange( testCrowd* f, int32_t first, int32_t count, int32_t capacity )
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

static inline void testStepAlone( testCrowd* f, testWalker* w )
{
	testStep( &f->biped, &f->settings, &w->state, &w->frame, &f->ground, &w->out );
}

static inline size_t testOutputSize( const testCrowd* f )
{
	return offsetof( soleOutput, legs ) + (size_t)soleRig_GetLegCount( f->biped.rig ) * sizeof( soleLegOutput );
}

static inline void testSameBits( const testCrowd* f, int32_t index, const testWalker* w )
{
	const soleOutput* out = soleCrowd_GetOutput( f->crowd, index );
	assert_memory_equal( out, &w->out, testOutputSize( f ) );
	soleState* state = soleCrowd_GetState( f->crowd, index );
	assert_memory_equal( state, &w->state, soleState_GetByteCount( f->biped.rig ) );
}

#endif
