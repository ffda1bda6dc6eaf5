// SPDX-License-Identifier: MIT
// The baselines ozz and effector as methods of a bake: set for the character, and of use where they are meant to be.
#include "take.h"

#define RAMP "T11-20"

static const testBake standing = { .character = "mannequin", .clip = "idle", .ground = RAMP, .x = 0.3, .z = 5.0 };

static soleVec3 testAnkleOf( const testTake* take, const soleTransform* poses, int32_t frame, int32_t leg )
{
	const soleTransform* pose = poses + (size_t)frame * (size_t)take->result.jointCount;
	int32_t joint = take->character.rigDef.legs[leg].joints[2];
	soleVec3 ankle = toolPoseWorld( &take->character, pose, joint ).translation;
	return soleTransformPoint( take->result.walk.roots[frame], ankle );
}

static soleHit testGroundUnder( const testTake* take, soleVec3 point )
{
	soleProbe probe = { .direction_w = { 0.0f, -1.0f, 0.0f }, .length = 20.0f, .mask = 0xffffffffu };
	probe.start_w = soleAdd( point, soleVec( 0.0f, 10.0f, 0.0f ) );
	soleHit hit = soleCastProbe( take->ground.ground, &probe );
	assert_true( hit.hit );
	return hit;
}

static void testBakeAncestor( testBake* bake, testTake* take, const char* method )
{
	bake->method = method;
	testOpenTake( bake, take );
	testBakeTake( bake, take );
}

static void testOzzPutsAnklesAsHighOffTheGroundAsTheyAreOverTheSole( void** state )
{
	(void)state;
	testBake bake = standing;
	bake.heading = 60.0;
	testTake take;
	testBakeAncestor( &bake, &take, "ozz" );
	float before = 0.0f;
	for ( int32_t i = 0; i < take.result.walk.frameCount; ++i )
	{
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			const toolCharacter* c = &take.character;
			const soleLegDef* def = c->rigDef.legs + leg;
			float height = toolPoseWorld( c, c->bindPose, def->joints[2] ).translation.y - def->sole.ball.y;
			soleVec3 ankle = testAnkleOf( &take, take.result.output, i, leg );
			soleHit under = testGroundUnder( &take, ankle );
			assert_float_equal( soleDot( soleSub( ankle, under.point_w ), under.normal_w ), height, 2e-4f );
			soleVec3 animated = testAnkleOf( &take, take.result.input, i, leg );
			under = testGroundUnder( &take, animated );
			float off = soleDot( soleSub( animated, under.point_w ), under.normal_w );
			before = soleMaxF( before, fabsf( off - height ) );
			assert_float_equal( take.result.plantWeights[2 * i + leg], 1.0f, 0.0f );
		}
	}
	assert_true( before > 0.01f );
	print_message( "ozz: penetration %.1f mm, hover %.1f mm\n", 1e3 * take.figures.all.penetration.p95,
	    1e3 * take.figures.all.hover.p95 );
	assert_true( take.figures.all.penetration.p95 < 0.002 && take.figures.all.hover.p95 < 0.002 );
	testCloseTake( &take );
}

/// How far an ankle is from its animated height over the ground that is under it, at the end of the take.
static float testHeightLeft( const testTake* take, const soleTransform* poses )
{
	int32_t last = take->result.walk.frameCount - 1;
	float worst = 0.0f;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleVec3 animated = testAnkleOf( take, take->result.input, last, leg );
		float ground = testGroundUnder( take, animated ).point_w.y - take->result.walk.roots[last].translation.y;
		float moved = testAnkleOf( take, poses, last, leg ).y - animated.y;
		worst = soleMaxF( worst, fabsf( moved - ground ) );
	}
	return worst;
}

static void testEffectorServesStanding( void** state )
{
	(void)state;
	testBake bake = standing;
	bake.heading = 90.0; // across the ramp: one foot is higher than the other
	testTake take;
	testBakeAncestor( &bake, &take, "effector" );
	float before = testHeightLeft( &take, take.result.input );
	float after = testHeightLeft( &take, take.result.output );
	print_message( "effector: %.1f mm off before, %.1f mm after\n", 1e3 * (double)before, 1e3 * (double)after );
	assert_true( before > 0.03f );
	assert_true( after < 0.012f ); // nearly there is enough for it
	testCloseTake( &take );
}

static void testEffectorLeavesWalkingAlone( void** state )
{
	(void)state;
	testBake bake = { .character = "mannequin", .clip = "walk", .ground = RAMP, .z = 4.0, .distance = 2.0 };
	testTake take;
	testBakeAncestor( &bake, &take, "effector" );
	for ( int32_t i = 0; i < take.result.walk.frameCount; ++i )
	{
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 placed = testAnkleOf( &take, take.result.output, i, leg );
			testNear3( placed, testAnkleOf( &take, take.result.input, i, leg ), 1e-4f );
		}
	}
	testCloseTake( &take );
}

/// It stands on level ground, where it is there at once; then it goes to the ramp and stands across it.
static void testEffectorIsWokenByWalking( void** state )
{
	(void)state;
	testBake bake = standing;
	testTake take;
	testBakeAncestor( &bake, &take, "none" );
	const toolMethod* method = toolFindMethod( "effector" );
	void* memory = method->init( &take.character );
	soleTransform* pose = toolAlloc( (size_t)take.result.jointCount, sizeof *pose );
	soleVec3 pelvis = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < 90; ++i )
	{
		uint32_t flags[2] = { 0 };
		float weights[2] = { 0 };
		soleFrame frame = { .pose = take.result.input, .up = { 0.0f, 1.0f, 0.0f }, .weight = 1.0f };
		frame.root = take.result.walk.roots[0];
		frame.root.rotation = ( soleQuat ){ 0.0f, sqrtf( 0.5f ), 0.0f, sqrtf( 0.5f ) };
		frame.root.translation.z = i < 10 ? 1.0f : 5.0f - 0.1f * (float)( i < 30 ? 30 - i : 0 );
		frame.root.translation.y = testGroundUnder( &take, frame.root.translation ).point_w.y;
		frame.timeStep = 1.0f / 60.0f;
		float shortfalls[2] = { 0 };
		toolMethodStep step = {
			.character = &take.character,
			.ground = take.ground.ground,
			.frame = &frame,
			.pose = pose,
			.flags = flags,
			.plantWeights = weights,
			.shortfalls = shortfalls,
			.pelvisOffset = &pelvis,
		};
		method->step( memory, &step );
		assert_true( i >= 30 || pelvis.y == 0.0f );
	}
	assert_true( pelvis.y < -0.02f );
	free( pose );
	free( memory );
	testCloseTake( &take );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testOzzPutsAnklesAsHighOffTheGroundAsTheyAreOverTheSole ),
		cmocka_unit_test( testEffectorServesStanding ),
		cmocka_unit_test( testEffectorLeavesWalkingAlone ),
		cmocka_unit_test( testEffectorIsWokenByWalking ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
