// SPDX-License-Identifier: MIT
// Frames of several characters at once, in every width that this machine has: to the bit what each gets alone, however
// many they are, whatever their legs are like and whatever their poses hold.
#include "biped_walk.h"

#include "place/kernels.h"

#define MOST 19
#define FRAMES 90

typedef struct Character
{
	soleTransform pose[biped_count];
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	soleSettings settings;
	soleFrame frame;
	soleState state[2]; // alone, and among others
	soleOutput out[2];
	solePlaceRoom room[2];
	solePlaceWork work[2];
	soleProbe probes[SOLE_MAX_PROBES];
	soleHit hits[SOLE_MAX_PROBES];
	soleLegHits byLeg;
} Character;

typedef enum Build
{
	build_plain,
	build_withoutToes,
	build_virtualAnkle,
	build_count
} Build;

static Character s_characters[MOST];
static testBiped s_biped;

static void makeRig( Build build )
{
	soleRigDef def = testBipedDef( &s_biped );
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleLegDef* leg = def.legs + i;
		leg->toeCount = build == build_plain ? 1 : 0;
		leg->hasVirtualAnkle = build == build_virtualAnkle;
		leg->virtualAnkle = soleVec( leg->sole.ball.x, 0.08f, 0.0f );
		leg->jointCount = build == build_virtualAnkle ? 2 : 3;
		leg->ankleLimits.dorsiflexion = 0.02f; // met in some steps
	}
	assert_int_equal( soleCreateRig( &def, NULL, &s_biped.rig, NULL ), sole_success );
}

static void start( Character* c, int32_t number )
{
	c->settings = soleDefaultSettings();
	c->settings.leg.twist = number == 3 ? 0.5f : 0.0f;
	c->settings.target.align = number == 4 ? 0.6f : 1.0f;
	c->settings.target.toeOutLeft = number == 5 ? 0.3f : 0.0f;
	c->settings.pelvis.speed = number == 8 ? 0.0f : c->settings.pelvis.speed; // legs have to reach by their heels
	c->settings.target.height = number == 6 ? 0.02f : 0.0f;
	c->settings.support.filter = number == 9 ? sole_filterTick : c->settings.support.filter;
	c->settings.layer.hips = number == 10 ? 0.3f : 0.0f;
	for ( int32_t i = 0; i < 2; ++i )
	{
		c->state[i] = soleDefaultState( s_biped.rig );
		memset( c->out + i, 0, sizeof c->out[i] );
	}
}

static void pose( Character* c, int32_t number, int32_t frame, uint32_t* seed )
{
	testWalk walk = { 0.5f + 0.1f * (float)number, 1.1f, 0.08f };
	float time = (float)frame / 60.0f;
	float phase = time + 0.37f * (float)number;
	memcpy( c->pose, s_biped.bindPose, sizeof c->pose );
	testPoseWalk( c->pose, &walk, phase );
	testTellWalk( &walk, phase, c->contacts, c->inputs );
	for ( int32_t i = 0; i < biped_count; ++i )
	{
		soleVec3 axis = soleVec( testRandomFloat( seed, -1.0f, 1.0f ), testRandomFloat( seed, -1.0f, 1.0f ), 0.3f );
		soleQuat shake = testTurn( soleNormalizeOr( axis, axis ), testRandomFloat( seed, -0.1f, 0.1f ) );
		c->pose[i].rotation = soleMulQuat( c->pose[i].rotation, shake );
	}
	if ( number == 1 && frame % 7 == 0 )
	{
		c->pose[frame % 2 == 0 ? biped_kneeL : biped_toeR].translation.x = NAN;
	}
	if ( number == 2 && frame % 5 == 0 )
	{
		// Its toes point straight down.
		memcpy( c->pose, s_biped.bindPose, sizeof c->pose );
		c->pose[biped_hipL].rotation = c->pose[biped_kneeL].rotation = soleQuat_Identity();
		c->pose[biped_ankleL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 1.5707963f );
	}
	c->frame = testFrame( c->pose );
	c->frame.contact = number % 3 == 0 ? c->contacts : NULL;
	c->frame.steps = c->inputs;
	c->frame.root.translation = soleVec( 0.3f * (float)number - 2.0f, 0.0f, walk.speed * time );
	c->frame.root.rotation = testTurn( soleVec( 0.1f, 0.99498744f, 0.0f ), 0.05f * (float)( number % 17 - 2 ) );
	c->frame.root.scale = number == 7 ? soleVec( 1.3f, 1.3f, 1.3f ) : c->frame.root.scale;
}

static const testGround s_ground = { .slopeX = 0.1f,
	.slopeZ = 0.15f,
	.hole = 1e9f,
	.turn = { 0.0f, 0.0f, 0.0f, 1.0f },
	.scale = 1.0f,
	.stairs = 0.5f,
	.tread = 0.4f,
	.rise = -0.15f };

/// What the character asks, from where it stands alone.
static void answer( Character* c )
{
	int32_t n = soleGatherProbes( s_biped.rig, &c->settings, &c->state[0], &c->frame, c->probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < n; ++i )
	{
		testCastAt( &s_ground, c->probes + i, c->hits + i );
	}
	c->byLeg = soleSplitHits( s_biped.rig, &c->settings, c->hits, n );
}

static void solveAlone( Character* c )
{
	c->work[0] = soleWorkIn( &c->room[0] );
	soleBeginFrame( &c->work[0], s_biped.rig, &c->settings, &c->state[0], &c->frame, &c->out[0] );
	soleEndFrame( &c->work[0], &c->byLeg );
}

static void solveTogether( int32_t count, int32_t width )
{
	solePlaceWork* works[MOST];
	soleLegHits hits[MOST];
	for ( int32_t i = 0; i < count; ++i )
	{
		Character* c = s_characters + i;
		c->work[1] = soleWorkIn( &c->room[1] );
		soleOpenFrame( &c->work[1], s_biped.rig, &c->settings, &c->state[1], &c->frame, &c->out[1] );
		works[i] = &c->work[1];
		hits[i] = c->byLeg;
	}
	soleBeginFrames( works, count, width );
	soleEndFrames( works, hits, count, width );
}

/// @return which flags legs had
static uint32_t walkInWidth( Build build, int32_t count, int32_t width )
{
	uint32_t seed = 7u;
	uint32_t flags = 0;
	makeRig( build );
	for ( int32_t i = 0; i < count; ++i )
	{
		start( s_characters + i, i );
	}
	for ( int32_t frame = 0; frame < FRAMES; ++frame )
	{
		for ( int32_t i = 0; i < count; ++i )
		{
			pose( s_characters + i, i, frame, &seed );
			answer( s_characters + i );
			solveAlone( s_characters + i );
		}
		solveTogether( count, width );
		for ( int32_t i = 0; i < count; ++i )
		{
			Character* c = s_characters + i;
			assert_memory_equal( &c->out[1], &c->out[0], sizeof c->out[0] );
			assert_memory_equal( &c->state[1], &c->state[0], soleState_GetByteCount( s_biped.rig ) );
			flags |= c->out[0].legs[0].flags | c->out[0].legs[1].flags;
		}
	}
	soleDestroyRig( s_biped.rig );
	return flags;
}

static void manyTogetherGetTheBitsOfEachAlone( void** state )
{
	(void)state;
	for ( int32_t width = 4; width <= soleGetKernelWidth(); width *= 2 )
	{
		uint32_t flags = walkInWidth( build_plain, MOST, width );
		// Those that the kernels leave to the plain code were among them.
		const uint32_t rare = (uint32_t)( sole_legAnkleClamped | sole_legHeelLifted | sole_legBadInput );
		assert_int_equal( flags & rare, rare );
	}
}

static void howManyTheyAreDoesNotMatter( void** state )
{
	(void)state;
	for ( int32_t width = 4; width <= soleGetKernelWidth(); width *= 2 )
	{
		for ( int32_t count = 1; count <= 9; count += 2 )
		{
			walkInWidth( build_plain, count, width );
		}
	}
}

static void legsOfOtherBuildsDoToo( void** state )
{
	(void)state;
	for ( int32_t width = 4; width <= soleGetKernelWidth(); width *= 2 )
	{
		for ( int32_t build = 0; build < build_count; ++build )
		{
			walkInWidth( (Build)build, 5, width );
		}
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( manyTogetherGetTheBitsOfEachAlone ),
		cmocka_unit_test( howManyTheyAreDoesNotMatter ),
		cmocka_unit_test( legsOfOtherBuildsDoToo ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
