// SPDX-License-Identifier: MIT
// The way of a foot in flight, through the public calls: down stairs it goes ahead of its animation to come down behind
// an edge, and stays where it is when nobody tells it where it goes any more. And it does not jump when it sets out.
#include "biped_walk.h"
#include "take.h"

#define FIRST 1.0f
#define TREAD 0.3f
#define RISE ( -0.15f )

typedef struct Walker
{
	testRun run;
	testWalk walk;
	soleContactInput contacts[2];
	soleStepInput inputs[2];
} Walker;

static void startDown( Walker* w )
{
	memset( w, 0, sizeof *w );
	testStartRun( &w->run, 0.5f );
	w->walk = ( testWalk ){ 2.0f * TREAD, 1.0f, 0.06f };
	w->run.ground.stairs = FIRST;
	w->run.ground.tread = TREAD;
	w->run.ground.rise = RISE;
}

/// A frame down the stairs, each step a tread, the feet as far behind its edge as asked for.
/// @param nudge so much further on are they told to land
static void stepDown( Walker* w, float time, float behind, float nudge, bool told )
{
	testRun* run = &w->run;
	float z = w->walk.speed * time + behind;
	float drop = RISE / TREAD * ( z - FIRST + 0.5f * TREAD );
	run->frame.root.translation = soleVec( 0.0f, fminf( drop, 0.0f ), z );
	testPoseWalk( run->pose, &w->walk, time );
	testTellWalk( &w->walk, time, w->contacts, w->inputs );
	w->inputs[0].place.z += nudge;
	w->inputs[1].place.z += nudge;
	run->frame.contact = told ? w->contacts : NULL;
	run->frame.steps = told ? w->inputs : NULL;
	testStepRun( run );
}

static soleVec3 getHeel( const Walker* w, int32_t leg )
{
	return testPlacedPoint( &w->run, leg, soleRig_GetLeg( w->run.biped.rig, leg ).sole.heel, false );
}

/// How deep a foot's heel is inside the tread over the one that it comes down on: over it, or behind its edge.
static float findHeelDepth( const Walker* w, int32_t leg )
{
	soleVec3 heel = getHeel( w, leg );
	float under = testGroundHeight( &w->run.ground, heel.x, heel.z ) - heel.y;
	float edge = FIRST + TREAD * ceilf( ( heel.z - FIRST ) / TREAD );
	return fmaxf( fminf( under, edge - heel.z ), 0.0f );
}

static void downStairsHeelsPassTheEdgesThatTheyComeDownBehind( void** state )
{
	(void)state;
	static Walker w;
	float deepest = 0.0f;
	for ( int32_t k = 0; k < 10; ++k )
	{
		startDown( &w );
		for ( int32_t i = 0; i < 420; ++i )
		{
			float time = (float)i / 60.0f;
			stepDown( &w, time, 0.03f * (float)k, 0.0f, true );
			for ( int32_t leg = 0; leg < 2 && time > 3.0f; ++leg )
			{
				bool late = testWalkPhase( &w.walk, time, leg ) > 0.8f;
				float depth = late ? findHeelDepth( &w, leg ) : 0.0f;
				deepest = fmaxf( deepest, depth );
			}
		}
		testEndRun( &w.run );
	}
	// 30 mm without going ahead.
	assert_true( deepest < 0.022f );
}

/// A host may stop telling of steps at any time, as where a clip ends: in that frame feet are nearly where they would
/// have been. They fell by up to 27 cm.
static void aFootThatLosesItsWayStaysWhereItIs( void** state )
{
	(void)state;
	static Walker w;
	static soleVec3 heels[360][2];
	startDown( &w );
	for ( int32_t i = 0; i < 360; ++i )
	{
		stepDown( &w, (float)i / 60.0f, 0.05f, 0.0f, true );
		heels[i][0] = getHeel( &w, 0 );
		heels[i][1] = getHeel( &w, 1 );
	}
	testEndRun( &w.run );
	float furthest = 0.0f;
	for ( int32_t cut = 300; cut < 360; ++cut )
	{
		startDown( &w );
		for ( int32_t i = 0; i <= cut; ++i )
		{
			stepDown( &w, (float)i / 60.0f, 0.05f, 0.0f, i < cut );
		}
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			furthest = fmaxf( furthest, soleDistance( getHeel( &w, leg ), heels[cut][leg] ) );
		}
		testEndRun( &w.run );
	}
	assert_true( furthest < 0.018f );
}

/// Nor does it jump where it is told of another way.
static void aFootThatIsToldOfAnotherWayDoesNotJump( void** state )
{
	(void)state;
	static Walker w;
	float furthest = 0.0f;
	for ( int32_t change = 300; change < 360; ++change )
	{
		startDown( &w );
		for ( int32_t i = 0; i < change; ++i )
		{
			stepDown( &w, (float)i / 60.0f, 0.05f, 0.0f, true );
		}
		soleVec3 last[2] = { getHeel( &w, 0 ), getHeel( &w, 1 ) };
		stepDown( &w, (float)change / 60.0f, 0.05f, 0.3f, true );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			furthest = fmaxf( furthest, soleDistance( getHeel( &w, leg ), last[leg] ) );
		}
		testEndRun( &w.run );
	}
	// 67 mm is its own way in a frame; it was 160.
	assert_true( furthest < 0.115f );
}

/// Uphill the heel of the leg behind is lifted further than it is animated, for the leg to reach. When the foot leaves
/// that is needed no more from one frame to the next: it dropped by 13 degrees in each, 2.5 times what the clip does.
static void aLiftedHeelIsLoweredSmoothlyWhenItsFootHasLeft( void** state )
{
	(void)state;
	const testBake bake = { .character = "mannequin", .clip = "walk", .ground = "T11-20" };
	static testTake take;
	testOpenTake( &bake, &take );
	testBakeTake( &bake, &take );
	int32_t lifted = 0;
	for ( int32_t i = 0; i < 2 * take.result.walk.frameCount; ++i )
	{
		lifted += ( take.result.flags[i] & (uint32_t)sole_legHeelLifted ) != 0 ? 1 : 0;
	}
	assert_true( lifted > 100 );
	assert_true( take.figures.legs[0].largestJump < 2.0 * take.flat.legs[0].largestJump );
	testCloseTake( &take );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( downStairsHeelsPassTheEdgesThatTheyComeDownBehind ),
		cmocka_unit_test( aFootThatLosesItsWayStaysWhereItIs ),
		cmocka_unit_test( aFootThatIsToldOfAnotherWayDoesNotJump ),
		cmocka_unit_test( aLiftedHeelIsLoweredSmoothlyWhenItsFootHasLeft ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
