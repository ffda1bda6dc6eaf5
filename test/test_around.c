// SPDX-License-Identifier: MIT
// T49: a spider walks from the floor up the wall, back along the ceiling, up its edge and on over its top. Up is the
// way's in every frame. What is asked: all feet are planted in turn on every face, they lie on it, the body follows.
// World space, metres.
#include "spider.h"

#include "act.h"
#include "ground_support.h"

#define RATE 60.0
#define PERIOD 0.6f
#define FACES 5

typedef struct Climb
{
	testSpider spider;
	soleScene scene;
	soleGround* ground;
	const soleAct* act;
	soleState state;
	soleSettings settings;
	soleTransform pose[SPIDER_JOINTS];
	soleTransform placed[SPIDER_JOINTS];
	soleSceneMoment moment;
	soleOutput out;
} Climb;

static bool findNoFloor( void* user, double x, double z, double ceiling, double time, double* height )
{
	(void)user;
	(void)x;
	(void)z;
	(void)ceiling;
	(void)time;
	*height = 0.0;
	return true;
}

static void start( Climb* climb )
{
	memset( climb, 0, sizeof *climb );
	testMakeSpider( &climb->spider );
	assert_true( soleMakeScene( "T49", &climb->scene ) );
	climb->act = soleFindAct( "T49", "floor to ceiling" );
	assert_non_null( climb->act );
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = climb->scene.positions;
	mesh.vertexCount = climb->scene.vertexCount;
	mesh.indices = climb->scene.indices;
	mesh.triangleCount = climb->scene.triangleCount;
	climb->ground = testMakeGround( &mesh, 1 );
	climb->state = soleDefaultState( climb->spider.rig );
	climb->settings = soleDefaultSettings();
	// In a corner the faces to both sides are a leg's length off, and lean by 60 degrees. The way carries the body.
	climb->settings.probe.stepUp = 1.0f;
	climb->settings.probe.stepDown = 1.2f;
	climb->settings.support.maxSlope = 1.2f;
	climb->settings.pelvis.mode = sole_pelvisReport;
}

static void end( Climb* climb )
{
	soleDestroyGround( climb->ground );
	soleFreeScene( &climb->scene );
	soleDestroyRig( climb->spider.rig );
}

static void step( Climb* climb, int32_t frameIndex )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	soleContactInput contacts[SPIDER_LEGS];
	soleStepInput inputs[SPIDER_LEGS];
	const soleStage stage = { &climb->scene, findNoFloor, NULL };
	double time = frameIndex / RATE;
	soleGetSceneMoment( climb->act, &stage, 0, time, &climb->moment );
	float speed = (float)climb->act->course.speed;
	testPoseSpider( &climb->spider, speed, PERIOD, (float)time, climb->pose, contacts, inputs );
	soleFrame frame = {
		.pose = climb->pose,
		.root = climb->moment.root,
		.up = climb->moment.up,
		.timeStep = (float)( 1.0 / RATE ),
		.weight = 1.0f,
		.contact = contacts,
		.steps = inputs,
	};
	int32_t n = soleGatherProbes( climb->spider.rig, &climb->settings, &climb->state, &frame, probes, SOLE_MAX_PROBES );
	soleCastProbes( climb->ground, probes, n, hits );
	soleSolve( climb->spider.rig, &climb->settings, &climb->state, &frame, hits, n, &climb->out );
	memcpy( climb->placed, climb->pose, sizeof climb->placed );
	soleApply( climb->spider.rig, &climb->out, climb->placed );
}

static soleTransform findJoint( const Climb* climb, int32_t joint )
{
	soleTransform t = climb->placed[joint];
	for ( int32_t j = climb->spider.parents[joint]; j != SOLE_NONE; j = climb->spider.parents[j] )
	{
		t = soleMulTransform( climb->placed[j], t );
	}
	return soleMulTransform( climb->moment.root, t );
}

/// The faces that are walked: from, to as z, y, the open side to the left of the way from one to the other.
static const float s_faces[FACES][2][2] = { { { -2.0f, 0.0f }, { 5.0f, 0.0f } }, { { 5.0f, 0.0f }, { 5.0f, 3.0f } },
	{ { 5.0f, 3.0f }, { 1.0f, 3.0f } }, { { 1.0f, 3.0f }, { 1.0f, 6.0f } }, { { 1.0f, 6.0f }, { 6.0f, 6.0f } } };

/// Distance to the nearest of the faces, below zero within the solid. @param face which that is
static float findDistance( soleVec3 p, int32_t* face )
{
	float best = 1e9f;
	float side = 1.0f;
	for ( int32_t i = 0; i < FACES; ++i )
	{
		float dz = s_faces[i][1][0] - s_faces[i][0][0], dy = s_faces[i][1][1] - s_faces[i][0][1];
		float pz = p.z - s_faces[i][0][0], py = p.y - s_faces[i][0][1];
		float length2 = dz * dz + dy * dy;
		float t = soleClampF( ( pz * dz + py * dy ) / length2, 0.0f, 1.0f );
		float away = hypotf( pz - t * dz, py - t * dy );
		if ( away < best )
		{
			best = away;
			*face = i;
			side = dz * py - dy * pz < 0.0f ? -1.0f : 1.0f;
		}
	}
	return side * best;
}

/// What is seen on the way.
typedef struct Seen
{
	int32_t planted[SPIDER_LEGS][FACES]; // frames in which a foot is held there, and is where it is wanted
	int32_t held, reaching;
	float off;   // of such a foot from the face
	float slide; // of it in a frame
	float low;   // of the body over the nearest face
	float high;
} Seen;

static void lookAtLeg( const Climb* climb, int32_t leg, soleVec3* last, bool* wasThere, Seen* seen )
{
	const soleLegOutput* out = climb->out.legs + leg;
	soleVec3 under = soleMulAdd( out->ankle_w, -SPIDER_SOLE, out->planeNormal_w );
	int32_t face;
	float off = fabsf( findDistance( under, &face ) );
	bool held = ( out->flags & (uint32_t)sole_legPlanted ) != 0;
	bool there = held && out->error < 2e-3f;
	seen->held += held ? 1 : 0;
	seen->reaching += there ? 1 : 0;
	seen->planted[leg][face] += there ? 1 : 0;
	seen->off = there ? fmaxf( seen->off, off ) : seen->off;
	seen->slide = there && *wasThere ? fmaxf( seen->slide, soleDistance( under, *last ) ) : seen->slide;
	*last = under;
	*wasThere = there;
}

static void allFeetArePlantedInTurnAndTheBodyFollows( void** state )
{
	(void)state;
	static Climb climb;
	static Seen seen;
	soleVec3 last[SPIDER_LEGS];
	bool there[SPIDER_LEGS] = { false };
	start( &climb );
	seen = ( Seen ){ .low = 1e9f };
	for ( int32_t i = 0; i < (int32_t)( climb.act->duration * RATE ); ++i )
	{
		step( &climb, i );
		for ( int32_t leg = 0; leg < SPIDER_LEGS; ++leg )
		{
			lookAtLeg( &climb, leg, last + leg, there + leg, &seen );
		}
		int32_t face;
		float height = findDistance( findJoint( &climb, SPIDER_BODY ).translation, &face );
		seen.low = fminf( seen.low, height );
		seen.high = fmaxf( seen.high, height );
	}
	printf( "T49: feet off their faces by at most %.1f mm, slide %.1f mm a frame, %d of %d are where they are wanted, "
	        "body %.2f to %.2f over the faces\n",
	    1e3 * (double)seen.off, 1e3 * (double)seen.slide, seen.reaching, seen.held, (double)seen.low,
	    (double)seen.high );
	for ( int32_t leg = 0; leg < SPIDER_LEGS; ++leg )
	{
		for ( int32_t face = 0; face < FACES; ++face )
		{
			assert_true( seen.planted[leg][face] >= 120 );
		}
	}
	assert_true( seen.reaching > seen.held * 96 / 100 );
	assert_true( seen.off < 0.012f );
	// A held place is remembered across up: where up turns fast, a foot far over or under the root goes along with it.
	assert_true( seen.slide < 0.012f );
	assert_true( seen.low > 0.12f && seen.high < 0.21f );
	end( &climb );
}

static void theWayGoesRoundItsCornersUnbroken( void** state )
{
	(void)state;
	static const char* const ids[] = { "T48", "T49" };
	for ( int32_t k = 0; k < 2; ++k )
	{
		soleScene scene;
		assert_true( soleMakeScene( ids[k], &scene ) );
		soleTransform before;
		soleGetSceneWay( &scene, 0.0, &before );
		testNear3( soleRotate( before.rotation, soleVec( 0.0f, 1.0f, 0.0f ) ), soleVec( 0.0f, 1.0f, 0.0f ), 1e-6f );
		for ( int32_t i = 1; i <= 2000; ++i )
		{
			soleTransform place;
			soleGetSceneWay( &scene, 0.01 * i, &place );
			soleVec3 p = place.translation;
			int32_t face;
			float off = k == 0 ? soleLength( p ) - 6.0f : findDistance( p, &face );
			assert_float_equal( off, 0.0f, 1e-4f );
			assert_true( soleDistance( p, before.translation ) < 0.0101f );
			assert_true( soleDotQuat( place.rotation, before.rotation ) > 0.9999f );
			before = place;
		}
		soleFreeScene( &scene );
	}
}

static void upIsOutOfTheFaceAwayFromItsCorners( void** state )
{
	(void)state;
	soleScene scene;
	assert_true( soleMakeScene( "T49", &scene ) );
	// In the middle of floor, wall, ceiling, end and top.
	const double ways[] = { 2.0, 7.5, 11.0, 14.5, 19.0 };
	const float ups[][2] = { { 1.0f, 0.0f }, { 0.0f, -1.0f }, { -1.0f, 0.0f }, { 0.0f, -1.0f }, { 1.0f, 0.0f } };
	for ( int32_t i = 0; i < 5; ++i )
	{
		soleTransform place;
		soleGetSceneWay( &scene, ways[i], &place );
		soleVec3 up = soleRotate( place.rotation, soleVec( 0.0f, 1.0f, 0.0f ) );
		testNear3( up, soleVec( 0.0f, ups[i][0], ups[i][1] ), 1e-5f );
	}
	soleFreeScene( &scene );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( allFeetArePlantedInTurnAndTheBodyFollows ),
		cmocka_unit_test( theWayGoesRoundItsCornersUnbroken ),
		cmocka_unit_test( upIsOutOfTheFaceAwayFromItsCorners ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
