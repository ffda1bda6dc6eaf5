// SPDX-License-Identifier: MIT
// Real characters over real grounds, and the figures that are promised for them. Left out, and said so, where the data
// is not there.
#include "take.h"

#define QUATERNIUS "human-quaternius-ual/human-base-animations.glb"
#define PAB "human-pab-rootmotion/pab_arnaud.glb"
#define OZZ_FLOOR "ground-ozz-footik-floor/floor.obj"
#define TEST_MAP "ground-ecctrl-testmap/testMap_decoded.glb"
#define NAV_TEST "ground-recast/nav_test.obj"
#define KAYKIT_STAIRS "ground-kaykit-prototype/Primitive_Stairs.gltf"

/// Ramps up to 20 degrees and the ozz floor.
static const testBake gentleGrounds[] = {
	{ .ground = "T11-10" }, { .ground = "T11-20" }, { .ground = "ramp" },
	{ .ground = OZZ_FLOOR, .x = -5.0, .z = -1.0, .heading = 90.0, .distance = 8.0 },
	{ .ground = OZZ_FLOOR, .x = 4.4, .z = -1.0, .heading = 270.0, .distance = 8.0 },
	{ .ground = TEST_MAP, .x = 49.0, .z = -73.0, .heading = 270.0, .distance = 8.0 }, // Ramp10 up
	{ .ground = TEST_MAP, .x = 37.0, .z = -73.0, .heading = 90.0, .distance = 8.0 },  // and down
	{ .ground = TEST_MAP, .x = 49.0, .z = -85.0, .heading = 270.0, .distance = 8.0 }, // Ramp20 up
	{ .ground = TEST_MAP, .x = 37.0, .z = -85.0, .heading = 90.0, .distance = 8.0 },  // and down
};

/// Bakes with both methods. The take is left with what Sole made of it, the figures of none are returned.
static soleFigures bakeNoneAndSole( testBake* bake, testTake* take )
{
	testOpenTake( bake, take );
	bake->method = "none";
	testBakeTake( bake, take );
	soleFigures none = take->figures;
	bake->method = "sole";
	testBakeTake( bake, take );
	return none;
}

static void walkOverGentleGround( const char* character, const char* clip )
{
	for ( size_t i = 0; i < sizeof gentleGrounds / sizeof gentleGrounds[0]; ++i )
	{
		testBake bake = gentleGrounds[i];
		bake.character = character;
		bake.clip = clip;
		testTake take;
		soleFigures none = bakeNoneAndSole( &bake, &take );
		const soleLegFigures* all = &take.figures.all;
		print_message( "%s %s %s: penetration %.1f mm (none %.1f), hover %.1f mm, knee %.2f, over-extended %d\n", clip,
		    bake.ground, bake.heading > 180.0 ? "westwards" : "", 1e3 * all->penetration.p95,
		    1e3 * none.all.penetration.p95, 1e3 * all->hover.p95,
		    all->kneeAccelerationRms / take.flat.all.kneeAccelerationRms, all->overExtended );
		assert_true( all->labelledFrames > 100 );
		assert_true( all->penetration.p95 <= 0.015 );
		assert_true( 5.0 * all->penetration.p95 <= none.all.penetration.p95 );
		assert_true( all->hover.p95 <= 0.020 );
		assert_int_equal( all->overExtended, 0 );
		assert_true( all->kneeAccelerationRms <= 1.6 * take.flat.all.kneeAccelerationRms );
		testCloseTake( &take );
	}
}

static void quaterniusWalksOverRampsAndTheOzzFloor( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( QUATERNIUS );
	walkOverGentleGround( QUATERNIUS, "Walk_Loop" );
}

static void pabWalksOverRampsAndTheOzzFloor( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( PAB );
	walkOverGentleGround( PAB, "walk" );
}

static void climbStairs( const char* character, const char* clip, const char* stairs )
{
	testBake bake = { .character = character, .clip = clip, .ground = stairs };
	testTake take;
	testOpenTake( &bake, &take );
	testBakeTake( &bake, &take );
	print_message( "%s on %s: pelvis at most %.1f mm a frame, over-extended %d, penetration %.1f mm\n", clip, stairs,
	    1e3 * take.figures.pelvisLargestStep, take.figures.all.overExtended, 1e3 * take.figures.all.penetration.p95 );
	assert_int_equal( take.figures.all.overExtended, 0 );
	assert_true( take.figures.pelvisLargestStep <= 0.02 );
	assert_true( take.figures.all.penetration.p95 <= 0.015 );
	testCloseTake( &take );
}

static void bothWalksClimbStairsWithASteadyPelvis( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( QUATERNIUS );
	TEST_NEEDS_DATA( PAB );
	climbStairs( QUATERNIUS, "Walk_Loop", "stairs" );
	climbStairs( PAB, "walk", "stairs" );
	climbStairs( QUATERNIUS, "Walk_Loop", "T02" );
	climbStairs( PAB, "walk", "T02" );
}

/// Every listed character and clip on every kind of ground: no leg over-extended, nothing sinks deeper than without.
static void bakeOverAll( const char* character, const char* const* clips, int32_t clipCount )
{
	static const testBake grounds[] = {
		{ .ground = OZZ_FLOOR, .x = -5.0, .z = -1.0, .heading = 90.0, .distance = 6.0 },
		{ .ground = TEST_MAP, .x = 24.0, .z = -95.0, .heading = 90.0, .distance = 6.0 }, // Ramp30
		{ .ground = TEST_MAP, .x = 3.0, .z = -22.0, .heading = 0.0, .distance = 5.0 },
		{ .ground = NAV_TEST, .x = 10.0, .z = -10.0, .heading = 0.0, .distance = 4.0 },
		{ .ground = KAYKIT_STAIRS, .groundScale = 0.34f, .x = 0.66, .z = 0.0, .heading = 270.0, .distance = 1.3 },
	};
	for ( size_t g = 0; g < sizeof grounds / sizeof grounds[0]; ++g )
	{
		for ( int32_t i = 0; i < clipCount; ++i )
		{
			testBake bake = grounds[g];
			bake.character = character;
			bake.clip = clips[i];
			testTake take;
			soleFigures none = bakeNoneAndSole( &bake, &take );
			print_message( "%s on %s: penetration %.1f mm (none %.1f), over-extended %d\n", clips[i], bake.ground,
			    1e3 * take.figures.all.penetration.p95, 1e3 * none.all.penetration.p95, take.figures.all.overExtended );
			assert_int_equal( take.figures.all.overExtended, 0 );
			assert_true( take.figures.all.penetration.p95 <= none.all.penetration.p95 + 0.005 );
			testCloseTake( &take );
		}
	}
}

static void quaterniusClipsOverAllGrounds( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( QUATERNIUS );
	static const char* const clips[] = { "Walk_Loop", "Jog_Fwd_Loop", "Sprint_Loop", "Idle_Loop", "Crouch_Fwd_Loop" };
	bakeOverAll( QUATERNIUS, clips, 5 );
}

static void pabClipsOverAllGrounds( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( PAB );
	static const char* const clips[] = { "walk", "jog", "run", "crossarms" };
	bakeOverAll( PAB, clips, 4 );
}

static void pabStandsOnASlopeAndAcrossAStep( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( PAB );
	static const testBake places[] = {
		{ .ground = OZZ_FLOOR, .x = 0.0, .z = -1.0, .heading = 0.0 },    // across an 18 degree slope
		{ .ground = OZZ_FLOOR, .x = 0.0, .z = -1.0, .heading = 90.0 },   // up it
		{ .ground = OZZ_FLOOR, .x = -3.5, .z = -5.0, .heading = 0.0 },   // on a box
		{ .ground = OZZ_FLOOR, .x = -3.01, .z = -5.75, .heading = 0.0 }, // one foot on a step of 0.2
	};
	for ( size_t i = 0; i < sizeof places / sizeof places[0]; ++i )
	{
		testBake bake = places[i];
		bake.character = PAB;
		bake.clip = "crossarms";
		testTake take;
		testOpenTake( &bake, &take );
		testBakeTake( &bake, &take );
		const soleLegFigures* all = &take.figures.all;
		print_message( "crossarms at (%.2f, %.2f): penetration %.1f mm, hover %.1f mm, in contact %.0f %%\n", bake.x,
		    bake.z, 1e3 * all->penetration.p95, 1e3 * all->hover.p95, 1e2 * all->contactShare );
		assert_true( all->penetration.p95 <= 0.015 && all->hover.p95 <= 0.020 );
		assert_int_equal( all->overExtended, 0 );
		testCloseTake( &take );
	}
}

static void otherCharactersPlaceTheirFeetOnTheOzzFloor( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( "human-dcl-emotes/walk.glb" );
	static const testBake bakes[] = {
		{ .character = "human-mesh2motion-ue-names/human-addon-animations.glb", .clip = "Idle Listening", .x = 0.0 },
		{ .character = "human-mesh2motion-ue-names/human-addon-animations.glb", .clip = "Tired Hunched" },
		{ .character = "human-kaykit-mannequin/manny_med_mod.gltf",
		    .clip = "Rig_Medium|Walking_A",
		    .clips = "human-kaykit-mannequin/Med_MovementBasic.glb" },
		{ .character = "human-kaykit-mannequin/manny_med_mod.gltf",
		    .clip = "Rig_Medium|Idle_A",
		    .clips = "human-kaykit-mannequin/Med_General.glb" },
		{ .character = "human-dcl-emotes/walk.glb", .clip = "Walk_Male" },
		{ .character = "human-dcl-emotes/idle.glb", .clip = "Idle_Male" },
		{ .character = "vrm-godette/Godette_vrm_v4.vrm" },
	};
	for ( size_t i = 0; i < sizeof bakes / sizeof bakes[0]; ++i )
	{
		testBake bake = bakes[i];
		bake.ground = OZZ_FLOOR;
		bake.x = -3.0;
		bake.z = -1.0;
		bake.heading = 90.0;
		bake.distance = 5.0;
		testTake take;
		soleFigures none = bakeNoneAndSole( &bake, &take );
		print_message( "%s: mean penetration %.1f mm (none %.1f, flat %.1f), over-extended %d\n", bake.character,
		    1e3 * take.figures.all.penetration.mean, 1e3 * none.all.penetration.mean,
		    1e3 * take.flat.all.penetration.mean, take.figures.all.overExtended );
		assert_int_equal( take.figures.all.overExtended, 0 );
		assert_true( take.figures.all.penetration.mean <= 0.02 );
		double own = take.flat.all.penetration.mean; // what the clip itself has under its floor
		assert_true( take.figures.all.penetration.mean <= fmax( none.all.penetration.mean, own ) + 0.001 );
		testCloseTake( &take );
	}
}

static void motionCaptureStaysAsItIsOnItsOwnFloor( void** state )
{
	(void)state;
	static const char* const files[] = { "mocap-bvh/cmu_02_01_walk.glb", "mocap-bvh/cmu_01_01_hops_and_turns.glb",
		"mocap-bvh/fair_zombie_walk.glb", "mocap-bvh/cmu_03_01_uneven_terrain.glb" };
	TEST_NEEDS_DATA( files[0] );
	for ( size_t i = 0; i < sizeof files / sizeof files[0]; ++i )
	{
		testBake bake = { .character = files[i], .ground = "flat", .x = 0.01, .z = -2.0 };
		testTake take;
		testOpenTake( &bake, &take );
		testBakeTake( &bake, &take );
		print_message( "%s: penetration %.1f mm (flat %.1f), deviation %.1f degrees, over-extended %d\n", files[i],
		    1e3 * take.figures.all.penetration.p95, 1e3 * take.flat.all.penetration.p95,
		    57.29578 * take.figures.deviation, take.figures.all.overExtended );
		assert_int_equal( take.figures.all.overExtended, 0 );
		assert_true( take.figures.all.penetration.p95 <= take.flat.all.penetration.p95 + 0.002 );
		testCloseTake( &take );
	}
}

static int compareDoubles( const void* a, const void* b )
{
	double x = *(const double*)a, y = *(const double*)b;
	return x < y ? -1 : ( x > y ? 1 : 0 );
}

/// Distances between the same points of two takes at common times: 95th percentile and largest.
static void compareTakes(
    const testTake* a, const testTake* b, int32_t stepA, int32_t stepB, double* p95, double* most )
{
	static double distances[20000];
	int32_t count = 0;
	for ( int32_t i = 0; i * stepA < a->result.walk.frameCount && i * stepB < b->result.walk.frameCount; ++i )
	{
		for ( int32_t leg = 0; leg < soleRig_GetLegCount( a->character.rig ); ++leg )
		{
			soleLegDef def = soleRig_GetLeg( a->character.rig, leg );
			int32_t foot = soleRig_GetFootJoint( a->character.rig, leg, false );
			const soleVec3 points[] = { { 0.0f, 0.0f, 0.0f },
				soleRig_ToFootSpace( a->character.rig, leg, def.sole.ball, false ) };
			for ( int32_t p = 0; p < 2 && count < 20000; ++p )
			{
				soleVec3 x = testTakePoint( a, i * stepA, foot, points[p] );
				soleVec3 y = testTakePoint( b, i * stepB, foot, points[p] );
				distances[count++] = (double)soleDistance( x, y );
			}
		}
	}
	assert_true( count > 100 );
	qsort( distances, (size_t)count, sizeof distances[0], compareDoubles );
	*p95 = distances[count * 95 / 100];
	*most = distances[count - 1];
}

static void frameRatesAgree( const char* character, const char* clip, const char* ground, double bound )
{
	testBake bake = { .character = character, .clip = clip, .ground = ground };
	testTake takes[3];
	static const double rates[] = { 60.0, 30.0, 144.0 };
	for ( int32_t i = 0; i < 3; ++i )
	{
		bake.fps = rates[i];
		testOpenTake( &bake, takes + i );
		testBakeTake( &bake, takes + i );
	}
	double slow, fast, slowest, fastest;
	compareTakes( takes, takes + 1, 2, 1, &slow, &slowest );
	compareTakes( takes, takes + 2, 5, 12, &fast, &fastest );
	print_message( "%s on %s, against 60 Hz: 30 Hz p95 %.1f max %.1f mm, 144 Hz p95 %.1f max %.1f mm\n", clip, ground,
	    1e3 * slow, 1e3 * slowest, 1e3 * fast, 1e3 * fastest );
	assert_true( slow <= bound && fast <= bound );
	assert_true( slowest <= 0.015 && fastest <= 0.015 ); // a frame of a foot in flight over an edge
	for ( int32_t i = 0; i < 3; ++i )
	{
		testCloseTake( takes + i );
	}
}

static void framesPerSecondMakeLittleDifference( void** state )
{
	(void)state;
	TEST_NEEDS_DATA( PAB );
	TEST_NEEDS_DATA( QUATERNIUS );
	frameRatesAgree( PAB, "walk", "T01", 0.003 );
	frameRatesAgree( PAB, "walk", "T11-20", 0.003 );
	frameRatesAgree( QUATERNIUS, "Walk_Loop", "T01", 0.003 );
	frameRatesAgree( QUATERNIUS, "Walk_Loop", "T11-20", 0.003 );
}

/// How far the pelvis is moved at most when nobody tells of steps, in leg lengths.
static double findFurthestPelvis( const testTake* take )
{
	const toolCharacter* character = &take->character;
	const soleSettings settings = soleDefaultSettings();
	soleState state = soleDefaultState( character->rig );
	double furthest = 0.0;
	for ( int32_t i = 0; i < take->result.walk.frameCount; ++i )
	{
		static soleProbe probes[SOLE_MAX_PROBES];
		static soleHit hits[SOLE_MAX_PROBES];
		static soleOutput output;
		soleFrame frame = { .up = { 0.0f, 1.0f, 0.0f }, .weight = 1.0f };
		frame.pose = take->result.input + (size_t)i * (size_t)character->jointCount;
		frame.root = take->result.walk.roots[i];
		frame.timeStep = i > 0 ? 1.0f / 60.0f : 0.0f;
		frame.clipFloor = take->result.clipFloor;
		int32_t count = soleGatherProbes( character->rig, &settings, &state, &frame, probes, SOLE_MAX_PROBES );
		soleCastProbes( take->ground.ground, probes, count, hits );
		soleSolve( character->rig, &settings, &state, &frame, hits, count, &output );
		furthest = fmax( furthest, fabs( (double)output.pelvisOffset_w.y ) );
	}
	return furthest / (double)soleRig_GetLegLength( character->rig, 0 );
}

/// Runners come down metres ahead of where they leave, on stairs beyond what probes reach. The ground that a foot came
/// from went on there, a storey above the root, and the body was taken to be on the line through that: 20 m off.
static void runnersStayWithTheirRootsWhateverTheySee( void** state )
{
	(void)state;
	static const char* const clips[] = { "Jog_Fwd_Loop", "Sprint_Loop" };
	for ( size_t i = 0; i < 2; ++i )
	{
		testBake bake = { .character = QUATERNIUS, .clip = clips[i], .ground = "T02" };
		testTake take;
		testOpenTake( &bake, &take );
		testBakeTake( &bake, &take );
		double length = (double)soleRig_GetLegLength( take.character.rig, 0 );
		double told = take.figures.pelvisOffsetMax / length;
		double untold = findFurthestPelvis( &take );
		print_message(
		    "%s on T02: pelvis at most %.2f legs from the animation, %.2f untold\n", clips[i], told, untold );
		assert_true( told < 1.1 );
		assert_true( untold < 1.01 );
		testCloseTake( &take );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( quaterniusWalksOverRampsAndTheOzzFloor ),
		cmocka_unit_test( pabWalksOverRampsAndTheOzzFloor ),
		cmocka_unit_test( bothWalksClimbStairsWithASteadyPelvis ),
		cmocka_unit_test( quaterniusClipsOverAllGrounds ),
		cmocka_unit_test( pabClipsOverAllGrounds ),
		cmocka_unit_test( pabStandsOnASlopeAndAcrossAStep ),
		cmocka_unit_test( otherCharactersPlaceTheirFeetOnTheOzzFloor ),
		cmocka_unit_test( motionCaptureStaysAsItIsOnItsOwnFloor ),
		cmocka_unit_test( framesPerSecondMakeLittleDifference ),
		cmocka_unit_test( runnersStayWithTheirRootsWhateverTheySee ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
