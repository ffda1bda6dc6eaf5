// SPDX-License-Identifier: MIT
// Up is the frame's, and may be another one in every frame: a walk around a small planet and around the inside of a
// hollow one, over its walls and upside down.
#include "biped_walk.h"

/// A ground of which the nearest surface is known everywhere. Its distance grows away from the solid.
typedef struct Planet
{
	float radius;
	bool hollow;
} Planet;

static const testWalk s_walk = { .speed = 1.0f, .period = 1.0f, .lift = 0.1f };

/// Over the ground; below zero inside of it.
static float distanceTo( const Planet* planet, soleVec3 p )
{
	float d = soleLength( p ) - planet->radius;
	return planet->hollow ? -d : d;
}

static soleVec3 upAt( const Planet* planet, soleVec3 p )
{
	return soleScale( ( planet->hollow ? -1.0f : 1.0f ) / soleLength( p ), p );
}

/// Sphere tracing: a distance can be gone without meeting anything.
static soleHit castAt( const Planet* planet, const soleProbe* probe )
{
	soleHit hit = { .surface = SOLE_NONE, .asked_w = probe->start_w };
	float way = 0.0f;
	for ( int32_t i = 0; i < 64 && way < probe->length; ++i )
	{
		soleVec3 p = soleMulAdd( probe->start_w, way, probe->direction_w );
		float left = distanceTo( planet, p );
		if ( left < 1e-5f )
		{
			hit.hit = true;
			hit.point_w = p;
			hit.normal_w = upAt( planet, p );
			break;
		}
		way += left;
	}
	return hit;
}

static void stepOn( testRun* run, const Planet* planet )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	int32_t n = soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < n; ++i )
	{
		hits[i] = castAt( planet, probes + i );
	}
	soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, hits, n, &run->out );
	testPlace( run );
}

/// The root on the ground after some way round the x axis, facing on.
static soleTransform placeRoot( const Planet* planet, float way )
{
	float angle = way / planet->radius;
	soleTransform root = soleTransform_Identity();
	float side = planet->hollow ? -1.0f : 1.0f;
	root.translation = soleVec( 0.0f, side * planet->radius * cosf( angle ), planet->radius * sinf( angle ) );
	root.rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), side * angle );
	return root;
}

typedef struct Worst
{
	float deep;  // of any point of a sole in the ground
	float high;  // of the lowest of a standing one over it
	float slide; // of a standing ball in a frame
	float jump;  // of the pelvis against the root in a frame
} Worst;

static Worst walkRound( const Planet* planet )
{
	static testRun run;
	testStartRun( &run, 0.0f );
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	Worst worst = { 0.0f, 0.0f, 0.0f, 0.0f };
	soleVec3 balls[2] = { { 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 0.0f } };
	float pelvis = 0.0f;
	int32_t frames = (int32_t)( 60.0f * 6.2831853f * planet->radius / s_walk.speed ) + 60;
	for ( int32_t i = 0; i < frames; ++i )
	{
		float time = (float)i / 60.0f;
		run.frame.root = placeRoot( planet, s_walk.speed * time );
		run.frame.up = upAt( planet, run.frame.root.translation );
		testPoseWalk( run.pose, &s_walk, time );
		testTellWalk( &s_walk, time, contacts, inputs );
		run.frame.contact = contacts;
		run.frame.steps = inputs;
		stepOn( &run, planet );
		float offset = soleDot( run.out.pelvisOffset_w, run.frame.up );
		worst.jump = i > 60 ? fmaxf( worst.jump, fabsf( offset - pelvis ) ) : 0.0f;
		pelvis = offset;
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 points[TEST_SOLE_POINTS];
			testPlacedSole( &run, leg, points );
			float least = 1e9f;
			for ( int32_t k = 0; k < TEST_SOLE_POINTS; ++k )
			{
				least = fminf( least, distanceTo( planet, points[k] ) );
			}
			soleVec3 ball = testPlacedPoint( &run, leg, soleRig_GetLeg( run.biped.rig, leg ).sole.ball, true );
			float phase = testWalkPhase( &s_walk, time, leg );
			if ( i > 60 && phase > 0.2f && phase < 0.55f )
			{
				worst.deep = fmaxf( worst.deep, -least );
				worst.high = fmaxf( worst.high, least );
				worst.slide = fmaxf( worst.slide, soleDistance( ball, balls[leg] ) );
			}
			balls[leg] = ball;
		}
	}
	testEndRun( &run );
	return worst;
}

static void feetStandAllTheWayRoundAPlanet( void** state )
{
	(void)state;
	const Planet planet = { 6.0f, false };
	Worst worst = walkRound( &planet );
	// A sole of 0.26 m is a chord 1.4 mm over the middle of its arc.
	assert_true( worst.deep < 3e-3f && worst.high < 3e-3f );
	assert_true( worst.slide < 1e-3f && worst.jump < 6e-3f );
}

static void feetStandOnTheWallsAndTheCeilingOfAHollowOne( void** state )
{
	(void)state;
	const Planet planet = { 6.0f, true };
	Worst worst = walkRound( &planet );
	assert_true( worst.deep < 3e-3f && worst.high < 3e-3f );
	assert_true( worst.slide < 1e-3f && worst.jump < 6e-3f );
}

static void upsideDownIsAsGoodAsUpright( void** state )
{
	(void)state;
	static testRun run[2];
	const soleVec3 axis = { 0.0f, 0.0f, 1.0f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( run + k, 0.5f );
		soleQuat turn = testTurn( axis, k == 0 ? 0.0f : 3.1415927f );
		run[k].ground.slopeX = 0.2f;
		run[k].ground.slopeZ = -0.1f;
		run[k].ground.turn = turn;
		run[k].frame.root.rotation = turn;
		run[k].frame.up = soleRotate( turn, soleVec( 0.0f, 1.0f, 0.0f ) );
		testStepSeconds( run + k, 1.0f );
	}
	assert_true( run[1].frame.up.y < -0.999f );
	assert_true( soleLength( run[0].out.pelvisOffset_w ) > 1e-3f );
	assert_true( testLargestMove( &run[0].biped, run[0].placed, run[1].placed ) < 1e-4f );
	assert_true( testLargestTurn( run[0].placed, run[0].pose ) > 0.05f );
	testEndRun( run + 0 );
	testEndRun( run + 1 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( feetStandAllTheWayRoundAPlanet ),
		cmocka_unit_test( feetStandOnTheWallsAndTheCeilingOfAHollowOne ),
		cmocka_unit_test( upsideDownIsAsGoodAsUpright ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
