// SPDX-License-Identifier: MIT
// Baseline ozz with the sample's own character, clip and floor, against the sample's formulas in double.
#include "test.h"

#include "biped.h"
#include "ozz_oracle.h"
#include "take.h"

#define PAB "human-pab-rootmotion/pab_arnaud.glb"
#define OZZ_FLOOR "ground-ozz-footik-floor/floor.obj"

typedef struct testWorst
{
	int32_t compared;
	double off;    // from the formulas in double
	double missed; // from the ankle's target, of legs that reach
} testWorst;

/// One frame of a real character, twice, so that the rays start where the root was moved to.
static void testRealFrame( const testTake* take, const soleOzzSettings* settings, const soleTransform* pose,
    soleTransform root, testWorst* worst )
{
	soleRig* rig = take->character.rig;
	soleFrame frame = { .pose = pose, .root = root, .up = { 0.0f, 1.0f, 0.0f }, .weight = 1.0f };
	soleOzzState state = soleDefaultOzzState( rig );
	soleOutput out;
	soleProbe probes[3];
	soleHit hits[3];
	for ( int32_t i = 0; i < 2; ++i )
	{
		int32_t count = soleGatherOzz( rig, settings, &state, &frame, probes, 3 );
		soleCastProbes( take->ground.ground, probes, count, hits );
		soleSolveOzz( rig, settings, &state, &frame, hits, count, &out );
	}
	if ( hits[0].hit == false || hits[1].hit == false || hits[2].hit == false )
	{
		return;
	}
	size_t bytes = (size_t)take->character.jointCount * sizeof *pose;
	soleTransform* placed = malloc( bytes );
	memcpy( placed, pose, bytes );
	soleApply( rig, &out, placed );
	testSampleD sample = { .parents = take->character.parents,
		.def = &take->character.rigDef,
		.pose = pose,
		.root = root,
		.settings = settings,
		.hits = hits };
	testSampleInDouble( &sample );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		int32_t joint = take->character.rigDef.legs[leg].joints[2];
		testPoint ankle = testJointInDouble( take->character.parents, placed, root, joint ).point;
		worst->off = fmax( worst->off, testLengthD( testMinus( ankle, sample.ankles[leg] ) ) );
		bool reached = ( out.legs[leg].flags & sole_legOutOfReach ) == 0;
		double missed = testLengthD( testMinus( ankle, sample.targets[leg] ) );
		worst->missed = reached ? fmax( worst->missed, missed ) : worst->missed;
		++worst->compared;
	}
	free( placed );
}

static void testTheSamplesOwnCharacterIsWithinATenthOfAMillimetre( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( PAB );
	TEST_NEEDS_DATA( OZZ_FLOOR );
	testBake bake = { .character = PAB, .clip = "crossarms", .ground = OZZ_FLOOR };
	testTake take;
	testOpenTake( &bake, &take );
	soleOzzSettings settings = soleDefaultOzzSettings();
	soleFitOzzSettings( take.character.rig, take.character.bindPose, &settings );
	soleTransform* pose = calloc( (size_t)take.character.jointCount, sizeof *pose );
	testWorst worst = { 0, 0.0, 0.0 };
	uint32_t seed = 41;
	for ( int32_t i = 0; i < 3000; ++i )
	{
		toolSampleClip( &take.character, &take.bound, testRandomFloat( &seed, 0.0f, take.bound.duration ), pose );
		soleTransform root = soleTransform_Identity();
		root.translation = soleVec( testRandomFloat( &seed, -6.0f, 6.0f ), testRandomFloat( &seed, 0.0f, 5.0f ), 0.0f );
		root.translation.z = testRandomFloat( &seed, -5.0f, 5.0f );
		root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), testRandomFloat( &seed, -3.14f, 3.14f ) );
		testRealFrame( &take, &settings, pose, root, &worst );
	}
	print_message( "%d ankles: %.4f mm from the formulas, %.4f mm from their targets, foot height %.4f m\n",
	    worst.compared, 1e3 * worst.off, 1e3 * worst.missed, (double)settings.footHeight );
	assert_true( worst.compared > 4000 );
	assert_true( worst.off <= 1e-4 );
	free( pose );
	testCloseTake( &take );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testTheSamplesOwnCharacterIsWithinATenthOfAMillimetre ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
