// SPDX-License-Identifier: MIT
// The ancestors as methods of a bake: fair renditions, that is better than nothing where they claim to be, and true to
// the clip on level ground; the curves that are drawn for them; a new start where the walk jumps.
#include "take.h"

#include "method_ancestors.h"

static const char* const names[] = { "homebrew", "iksetting" };

static void measure( const char* method, const char* ground, testTake* take )
{
	testBake bake = { .character = "mannequin", .clip = "walk", .ground = ground, .method = method };
	testOpenTake( &bake, take );
	testBakeTake( &bake, take );
}

static void feetAreBetterOnARampThanWithoutAMethod( void** state )
{
	(void)state;
	testTake none;
	testTake take;
	measure( "none", "T11-20", &none );
	const double penetration[] = { 0.3, 0.8 }; // shares of what none leaves
	for ( int32_t i = 0; i < 2; ++i )
	{
		measure( names[i], "T11-20", &take );
		const soleLegFigures* feet = &take.figures.all;
		const soleLegFigures* before = &none.figures.all;
		print_message( "%s: penetration %.1f mm (%.1f), hover %.1f mm (%.1f), in contact %.0f %% (%.0f)\n", names[i],
		    1e3 * feet->penetration.mean, 1e3 * before->penetration.mean, 1e3 * feet->hover.mean,
		    1e3 * before->hover.mean, 100.0 * feet->contactShare, 100.0 * before->contactShare );
		assert_true( feet->penetration.mean < penetration[i] * before->penetration.mean );
		assert_true( feet->penetration.max < 0.5 * before->penetration.max );
		assert_true( feet->hover.mean < 0.4 * before->hover.mean );
		assert_true( feet->contactShare > before->contactShare );
		testCloseTake( &take );
	}
	testCloseTake( &none );
}

static void aWalkOnLevelGroundStaysAsItIs( void** state )
{
	(void)state;
	const double penetration[] = { 0.008, 0.0002 }; // what lag leaves of the correction for pitched feet
	for ( int32_t i = 0; i < 2; ++i )
	{
		testTake take;
		measure( names[i], "flat", &take );
		assert_true( take.figures.all.penetration.max < penetration[i] );
		assert_true( take.figures.all.hover.max < 0.002 );
		assert_true( take.figures.all.slide < take.flat.all.slide + 1e-3 );
		testCloseTake( &take );
	}
}

static void allMethodsGoTheSameWay( void** state )
{
	(void)state;
	testTake none;
	measure( "none", "T02", &none );
	for ( int32_t i = 0; i < 2; ++i )
	{
		testTake take;
		measure( names[i], "T02", &take );
		size_t frames = (size_t)none.result.walk.frameCount;
		size_t joints = frames * (size_t)none.result.jointCount;
		assert_memory_equal( take.result.input, none.result.input, joints * sizeof *none.result.input );
		assert_memory_equal( take.result.walk.roots, none.result.walk.roots, frames * sizeof *none.result.walk.roots );
		assert_true( memcmp( take.result.output, none.result.output, joints * sizeof *none.result.output ) != 0 );
		testCloseTake( &take );
	}
	testCloseTake( &none );
}

// --------------------------------------------------------------------------------------------------- single frames

typedef struct frameRun
{
	testTake take;
	soleFrame frame;
	soleContactInput contacts[2];
	soleStepInput steps[2];
	soleTransform* pose;
	uint32_t flags[2];
	float plantWeights[2];
	soleVec3 pelvisOffset;
	toolMethodStep step;
} frameRun;

static frameRun run;

static void openFrame( const char* ground )
{
	memset( &run, 0, sizeof run );
	measure( "none", ground, &run.take );
	run.frame = ( soleFrame ){ .pose = run.take.result.input,
		.root = run.take.result.walk.roots[0],
		.up = { 0.0f, 1.0f, 0.0f },
		.timeStep = 1.0f / 60.0f,
		.weight = 1.0f };
	run.frame.root.translation.y -= 0.1f; // the ground comes up to the shins
	run.pose = calloc( (size_t)run.take.result.jointCount, sizeof *run.pose );
	run.step = ( toolMethodStep ){ .character = &run.take.character,
		.ground = run.take.ground.ground,
		.frame = &run.frame,
		.pose = run.pose,
		.flags = run.flags,
		.plantWeights = run.plantWeights,
		.pelvisOffset = &run.pelvisOffset };
}

static void stepFrame( const char* method, void* memory )
{
	memcpy( run.pose, run.frame.pose, (size_t)run.take.result.jointCount * sizeof *run.pose );
	toolFindMethod( method )->step( memory, &run.step );
}

static void closeFrame( void )
{
	free( run.pose );
	testCloseTake( &run.take );
}

static float leftCurve( void* memory, soleContactInput contact, float since, float until )
{
	run.frame.contact = run.contacts;
	run.frame.steps = run.steps;
	run.contacts[0] = run.contacts[1] = contact;
	run.steps[0] = run.steps[1] = ( soleStepInput ){ .since = since, .until = until };
	stepFrame( "iksetting", memory );
	return run.plantWeights[0];
}

static void curvesAreOnWhileAFootStandsAndRampBeforeAndAfter( void** state )
{
	(void)state;
	openFrame( "flat" );
	void* memory = toolStartIkSetting( &run.take.character );
	stepFrame( "iksetting", memory );
	assert_true( run.plantWeights[0] == 1.0f ); // nothing is known
	soleContactInput heel = { 1.0f, 0.0f };
	soleContactInput toe = { 0.0f, 1.0f };
	soleContactInput half = { 0.2f, 0.5f };
	soleContactInput none = { 0.0f, 0.0f };
	soleContactInput unknown = { -1.0f, 0.0f };
	assert_true( leftCurve( memory, heel, 0.3f, 0.1f ) == 1.0f );
	assert_true( leftCurve( memory, toe, 0.3f, 0.1f ) == 1.0f );
	assert_true( leftCurve( memory, unknown, 1.0f, 1.0f ) == 1.0f );
	assert_true( leftCurve( memory, half, 1.0f, 1.0f ) == 0.5f );
	assert_true( leftCurve( memory, none, 1.0f, 1.0f ) == 0.0f );
	assert_true( leftCurve( memory, none, -1.0f, -1.0f ) == 0.0f );
	assert_float_equal( leftCurve( memory, none, 0.05f, 0.4f ), 2.0f / 3.0f, 1e-5f );
	assert_float_equal( leftCurve( memory, none, 0.4f, 0.1f ), 1.0f / 3.0f, 1e-5f );
	free( memory );
	closeFrame();
}

static void theyStartAnewWhereTheWalkJumps( void** state )
{
	(void)state;
	openFrame( "T11-20" );
	size_t bytes = (size_t)run.take.result.jointCount * sizeof *run.pose;
	soleTransform* first = malloc( bytes );
	for ( int32_t i = 0; i < 2; ++i )
	{
		void* memory = toolFindMethod( names[i] )->init( &run.take.character );
		stepFrame( names[i], memory );
		memcpy( first, run.pose, bytes );
		soleTransform root = run.frame.root;
		run.frame.root = run.take.result.walk.roots[300]; // on the slope
		stepFrame( names[i], memory );
		run.frame.root = root;
		run.frame.teleport = true;
		stepFrame( names[i], memory );
		assert_memory_equal( run.pose, first, bytes );
		run.frame.teleport = false;
		free( memory );
	}
	free( first );
	closeFrame();
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( feetAreBetterOnARampThanWithoutAMethod ),
		cmocka_unit_test( aWalkOnLevelGroundStaysAsItIs ),
		cmocka_unit_test( allMethodsGoTheSameWay ),
		cmocka_unit_test( curvesAreOnWhileAFootStandsAndRampBeforeAndAfter ),
		cmocka_unit_test( theyStartAnewWhereTheWalkJumps ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
