// SPDX-License-Identifier: MIT
// Takes of a rig whose gait is known, and what is read of the extras of baked clips.
#include "measure_rig.h"

#include "evaluate.h"

#define MAX_POINTS 1000

static soleMeasurePoint points[MAX_POINTS];

static toolCharacter characterOf( soleRig* rig )
{
	toolCharacter character = { .jointCount = RIG_JOINTS, .rig = rig, .points = points };
	character.pointCount = soleMakeMeasurePoints( rig, points, MAX_POINTS );
	assert_true( character.pointCount <= MAX_POINTS );
	return character;
}

/// A walk with its floor 3 cm over the origin, along a heading, over ground 1.5 m up that rises now and then.
static toolTake makeWalk( const toolCharacter* character, rigMotion* m, toolError* error )
{
	gaitFill( m, 1.3, 0.03f, false );
	soleQuat heading = { 0.0f, 0.6f, 0.0f, 0.8f };
	for ( int32_t t = 0; t < m->motion.frameCount; ++t )
	{
		m->roots[t].translation = soleRotate( heading, m->roots[t].translation );
		m->roots[t].rotation = heading;
		m->roots[t].translation.y = 1.47f + ( t / 40 % 2 == 1 ? 0.1f : 0.0f );
	}
	toolTakeDef def = {
		.frameCount = m->motion.frameCount,
		.frameRate = (double)m->motion.frameRate,
		.clipFloor = 0.03f,
		.poses = m->poses,
		.roots = m->roots,
		.inputPoses = m->poses,
		.inputRoots = m->roots,
	};
	toolTake take;
	assert_true( toolMakeTake( character, &def, &take, error ) );
	return take;
}

static void aTakesReferenceWalksTheSameWayOnFlatGround( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	toolCharacter character = characterOf( rig );
	rigMotion m = rigMakeMotion( rig, 240, 60.0f );
	toolError error = { { 0 } };
	toolTake take = makeWalk( &character, &m, &error );
	assert_int_equal( take.skip, 30 );
	for ( int32_t t = 0; t < take.frameCount; ++t )
	{
		assert_float_equal( take.referenceRoots[t].translation.x, m.roots[t].translation.x, 1e-6f );
		assert_float_equal( take.referenceRoots[t].translation.y, -0.03f, 1e-6f );
		assert_float_equal( take.referenceRoots[t].translation.z, m.roots[t].translation.z, 1e-6f );
		assert_float_equal( take.referenceRoots[t].rotation.y, 0.6f, 1e-6f );
	}
	soleTerrain* terrain = rigMakePlane( 1.5f, 0.0f );
	soleFigures* figures = calloc( 2, sizeof *figures );
	assert_true( toolMeasureTake( &character, &take, terrain, figures, figures + 1, &error ) );
	// The reference stands on its floor; the take is 10 cm up for every other 40 frames, and does not bend for it.
	testNearD( figures[1].all.hover.max, 0.0, 1e-4 );
	testNearD( figures[1].all.penetration.max, 0.0, 1e-4 );
	assert_true( figures[1].all.slide < 0.02 );
	testNearD( figures[0].all.hover.max, 0.1, 1e-4 );
	testNearD( figures[0].pelvisLargestStep, 0.1, 1e-4 );
	testNearD( figures[0].deviation, 0.0, 1e-6 );
	assert_int_equal( figures[0].all.labelledFrames, figures[1].all.labelledFrames );
	free( figures );
	soleDestroyTerrain( terrain );
	toolFreeTake( &take );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void aTakeThatIsNotFiniteIsRefusedInWords( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	toolCharacter character = characterOf( rig );
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	toolError error = { { 0 } };
	toolTake take = makeWalk( &character, &m, &error );
	take.poses[17 * RIG_JOINTS].translation.y = nanf( "" );
	soleTerrain* terrain = rigMakePlane( 1.5f, 0.0f );
	soleFigures* figures = calloc( 1, sizeof *figures );
	assert_false( toolMeasureTake( &character, &take, terrain, figures, NULL, &error ) );
	assert_non_null( strstr( error.text, "frame 17" ) );
	free( figures );
	soleDestroyTerrain( terrain );
	toolFreeTake( &take );
	toolTakeDef none = { .frameCount = 0, .frameRate = 60.0 };
	assert_false( toolMakeTake( &character, &none, &take, &error ) );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static bool readExtras( const char* text, toolBakeInfo* info )
{
	char extras[512];
	snprintf( extras, sizeof extras, "%s", text );
	toolClip clip = { .extras = text[0] != 0 ? extras : NULL };
	return toolReadBakeInfo( &clip, info );
}

static void extrasOfABakedClipAreRead( void** state )
{
	(void)state;
	toolBakeInfo info;
	assert_true( readExtras( "{\"sole\":{\"clip\":\"Walk\",\"method\":\"none\",\"fps\":30,\"frames\":61,\"speed\":1.2,"
	                         "\"rate\":1.25,\"scale\":0.01,\"travel\":4}}",
	    &info ) );
	assert_string_equal( info.clip, "Walk" );
	assert_string_equal( info.method, "none" );
	assert_string_equal( info.clips, "" );
	assert_int_equal( info.frameCount, 61 );
	assert_int_equal( info.travel, 4 );
	testNearD( info.fps, 30.0, 0.0 );
	testNearD( info.rate, 1.25, 0.0 );
	testNearD( info.scale, 0.01, 0.0 );
}

static void extrasOfOthersAndHostileOnesAreNoBake( void** state )
{
	(void)state;
	toolBakeInfo info;
	const char* const texts[] = { "", "{", "[]", "7", "null", "{\"sole\":7}", "{\"other\":{}}", "{\"sole\":{}}",
		"{\"sole\":{\"clip\":7,\"fps\":30,\"frames\":61,\"travel\":4}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":0,\"frames\":61,\"travel\":4}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":30,\"frames\":1e30,\"travel\":4}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":30,\"frames\":-1,\"travel\":4}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":30,\"frames\":61,\"travel\":-4}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":30,\"frames\":61,\"travel\":4,\"scale\":0}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":30,\"frames\":61,\"travel\":4,\"rate\":-1}}",
		"{\"sole\":{\"clip\":\"W\",\"fps\":NaN,\"frames\":61,\"travel\":4}}" };
	for ( size_t i = 0; i < sizeof texts / sizeof texts[0]; ++i )
	{
		assert_false( readExtras( texts[i], &info ) );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aTakesReferenceWalksTheSameWayOnFlatGround ),
		cmocka_unit_test( aTakeThatIsNotFiniteIsRefusedInWords ),
		cmocka_unit_test( extrasOfABakedClipAreRead ),
		cmocka_unit_test( extrasOfOthersAndHostileOnesAreNoBake ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
