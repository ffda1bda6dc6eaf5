// SPDX-License-Identifier: MIT
// The mannequin: its measures, its mesh, and that its feet stand still where they stand. Everything is sampled from the
// keys of the clips, between the keys as well, the way a player would.
#include "test.h"

#include "mannequin.h"
#include "skin.h"

#include <math.h>

#define DEGREES 57.29578f
#define MAX_NODES 64
#define STEPS_A_KEY 4

static toolModel s_model;

static int setup( void** state )
{
	(void)state;
	toolMakeMannequin( &s_model );
	return 0;
}

static int teardown( void** state )
{
	(void)state;
	toolFreeModel( &s_model );
	return 0;
}

static const toolClip* findClip( const char* name )
{
	int32_t clip = toolFindClip( &s_model, name );
	assert_true( clip != SOLE_NONE );
	return s_model.clips + clip;
}

static int32_t findNode( const char* name )
{
	int32_t node = toolFindNode( &s_model, name );
	assert_true( node != SOLE_NONE );
	return node;
}

static void samplePose( const toolClip* clip, float time, soleTransform* pose )
{
	for ( int32_t i = 0; i < s_model.nodeCount; ++i )
	{
		pose[i] = s_model.nodes[i].local;
	}
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		const toolChannel* channel = clip->channels + i;
		int32_t key = 0;
		while ( key + 2 < channel->keyCount && channel->times[key + 1] <= time )
		{
			++key;
		}
		float share = ( time - channel->times[key] ) / ( channel->times[key + 1] - channel->times[key] );
		if ( channel->path == tool_pathRotation )
		{
			const soleQuat* values = (const soleQuat*)channel->values;
			pose[channel->node].rotation = soleNlerp( values[key], values[key + 1], share );
		}
		else
		{
			const soleVec3* values = (const soleVec3*)channel->values;
			pose[channel->node].translation = soleLerp( values[key], values[key + 1], share );
		}
	}
}

static soleTransform posedWorld( const soleTransform* pose, int32_t node )
{
	soleTransform world = pose[node];
	for ( int32_t parent = s_model.nodes[node].parent; parent != SOLE_NONE; parent = s_model.nodes[parent].parent )
	{
		world = soleMulTransform( pose[parent], world );
	}
	return world;
}

/// A clip sampled densely: the sole's lowest places and the joints of the legs, in the frame that moves on with the
/// stride.
typedef struct Sample
{
	soleVec3 heel[2];
	soleVec3 ball[2];
	soleVec3 tip[2];
	float lowest; // of all vertices
	float knee[2];
	float reach[2];
	float forward[2]; // knee before the line from hip to ankle, m
} Sample;

static int32_t s_sampleCount;
static Sample s_samples[2048];
static float s_step;

static float footLowest( const Sample* sample, int side )
{
	return soleMinF( sample->heel[side].y, soleMinF( sample->ball[side].y, sample->tip[side].y ) );
}

static void measureLeg( const soleTransform* pose, int side, soleVec3 travel, Sample* sample )
{
	static const char* const s_names[2][4] = { { "thigh_l", "shin_l", "foot_l", "toe_l" },
		{ "thigh_r", "shin_r", "foot_r", "toe_r" } };
	soleVec3 hip = posedWorld( pose, findNode( s_names[side][0] ) ).translation;
	soleVec3 knee = posedWorld( pose, findNode( s_names[side][1] ) ).translation;
	soleTransform foot = posedWorld( pose, findNode( s_names[side][2] ) );
	soleTransform toe = posedWorld( pose, findNode( s_names[side][3] ) );
	soleVec3 a = soleSub( knee, hip );
	soleVec3 b = soleSub( foot.translation, knee );
	float cosine = soleDot( a, b ) / ( soleLength( a ) * soleLength( b ) );
	sample->knee[side] = DEGREES * acosf( soleClampF( cosine, -1.0f, 1.0f ) );
	sample->reach[side] = soleDistance( hip, foot.translation ) / ( soleLength( a ) + soleLength( b ) );
	// The knee's hinge is the thigh's own side axis: bending turns the shin back about it.
	soleVec3 hinge = soleRotate( posedWorld( pose, findNode( s_names[side][0] ) ).rotation, soleVec( 1, 0, 0 ) );
	sample->forward[side] = soleDot( soleCross( a, b ), hinge );
	sample->heel[side] = soleAdd( soleTransformPoint( foot, soleVec( 0, -0.085f, -0.055f ) ), travel );
	sample->ball[side] = soleAdd( soleTransformPoint( toe, soleVec( 0, -0.028f, 0 ) ), travel );
	sample->tip[side] = soleAdd( soleTransformPoint( toe, soleVec( 0, -0.028f, 0.07f ) ), travel );
}

static float lowestVertex( const soleTransform* pose )
{
	toolTriangles triangles = { 0 };
	toolSkinModel( &s_model, pose, soleTransform_Identity(), &triangles );
	float lowest = 1.0f;
	for ( int32_t i = 0; i < triangles.vertexCount; ++i )
	{
		lowest = soleMinF( lowest, triangles.positions[3 * i + 1] );
	}
	toolFreeTriangles( &triangles );
	return lowest;
}

static void measureClip( const char* name, soleVec3 velocity )
{
	const toolClip* clip = findClip( name );
	s_sampleCount = STEPS_A_KEY * ( clip->channels[0].keyCount - 1 ) + 1;
	assert_true( s_sampleCount <= 2048 );
	s_step = clip->end / (float)( s_sampleCount - 1 );
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		soleTransform pose[MAX_NODES];
		float time = s_step * (float)i;
		samplePose( clip, time, pose );
		Sample* sample = s_samples + i;
		measureLeg( pose, 0, soleScale( time, velocity ), sample );
		measureLeg( pose, 1, soleScale( time, velocity ), sample );
		sample->lowest = lowestVertex( pose );
	}
}

static float horizontal( soleVec3 a, soleVec3 b )
{
	return soleLength( soleVec( a.x - b.x, 0.0f, a.z - b.z ) );
}

/// The farthest that a point moves along the floor while it is on it, which is to say less than 0.5 mm over it.
static float largestDrift( size_t offset )
{
	float largest = 0.0f;
	for ( int side = 0; side < 2; ++side )
	{
		int32_t start = -1;
		for ( int32_t i = 0; i < s_sampleCount; ++i )
		{
			const soleVec3* point = (const soleVec3*)( (const char*)( s_samples + i ) + offset ) + side;
			if ( point->y > 0.0005f )
			{
				start = -1;
				continue;
			}
			start = start < 0 ? i : start;
			const soleVec3* from = (const soleVec3*)( (const char*)( s_samples + start ) + offset ) + side;
			largest = soleMaxF( largest, horizontal( *point, *from ) );
		}
	}
	return largest;
}

static void checkFeet( const char* name, soleVec3 velocity, float drift )
{
	measureClip( name, velocity );
	float heel = largestDrift( offsetof( Sample, heel ) );
	float ball = largestDrift( offsetof( Sample, ball ) );
	float tip = largestDrift( offsetof( Sample, tip ) );
	float lowest = 1.0f;
	float reach = 0.0f;
	float knee[2] = { 180.0f, 0.0f };
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		lowest = soleMinF( lowest, s_samples[i].lowest );
		for ( int side = 0; side < 2; ++side )
		{
			reach = soleMaxF( reach, s_samples[i].reach[side] );
			knee[0] = soleMinF( knee[0], s_samples[i].knee[side] );
			knee[1] = soleMaxF( knee[1], s_samples[i].knee[side] );
			assert_true( s_samples[i].forward[side] > 0.0f );
		}
	}
	print_message( "%-10s drift of heel %.2f, ball %.2f, tip %.2f mm; lowest %.2f mm; reach %.4f; knee %.1f to %.1f\n",
	    name, 1e3 * (double)heel, 1e3 * (double)ball, 1e3 * (double)tip, 1e3 * (double)lowest, (double)reach,
	    (double)knee[0], (double)knee[1] );
	assert_true( heel < drift && ball < drift && tip < drift );
	assert_true( lowest > -0.0015f );
	assert_true( reach <= 0.99f );
}

static void testMeasures( void** state )
{
	(void)state;
	float top = 0.0f;
	for ( int32_t i = 0; i < s_model.meshes[0].primitiveCount; ++i )
	{
		const toolPrimitive* primitive = s_model.meshes[0].primitives + i;
		for ( int32_t v = 0; v < primitive->vertexCount; ++v )
		{
			top = soleMaxF( top, primitive->positions[3 * v + 1] );
		}
	}
	assert_float_equal( top, 1.75f, 0.001f );
	assert_int_equal( s_model.nodeCount, 25 );
	assert_int_equal( s_model.skins[0].jointCount, 23 );
	assert_int_equal( s_model.nodes[s_model.nodeCount - 1].parent, SOLE_NONE );
	assert_int_equal( s_model.nodes[findNode( "hips" )].parent, findNode( "root" ) );
	assert_true( toolNodeWorld( &s_model, findNode( "foot_l" ) ).translation.x > 0.05f );
	soleVec3 left = toolNodeWorld( &s_model, findNode( "hand_l" ) ).translation;
	soleVec3 right = toolNodeWorld( &s_model, findNode( "hand_r" ) ).translation;
	testNear3( left, soleVec( -right.x, right.y, right.z ), 1e-6f );
}

static void testMesh( void** state )
{
	(void)state;
	int32_t triangles = 0;
	for ( int32_t i = 0; i < s_model.meshes[0].primitiveCount; ++i )
	{
		const toolPrimitive* primitive = s_model.meshes[0].primitives + i;
		triangles += primitive->indexCount / 3;
		for ( int32_t v = 0; v < primitive->vertexCount; ++v )
		{
			const float* weights = primitive->weights + 4 * v;
			const float* n = primitive->normals + 3 * v;
			const float* p = primitive->positions + 3 * v;
			assert_float_equal( weights[0] + weights[1] + weights[2] + weights[3], 1.0f, 1e-6f );
			assert_float_equal( soleLength( soleVec( n[0], n[1], n[2] ) ), 1.0f, 1e-5f );
			assert_true( soleVec3_IsFinite( soleVec( p[0], p[1], p[2] ) ) );
			assert_true( primitive->joints[4 * v] < s_model.skins[0].jointCount );
		}
	}
	assert_in_range( triangles, 1500, 4000 );
}

/// Six times the volume within the triangles, and the sum of their areas as vectors: closed surfaces have none.
static void testClosedAndOutward( void** state )
{
	(void)state;
	float volume = 0.0f;
	soleVec3 area = { 0 };
	for ( int32_t i = 0; i < s_model.meshes[0].primitiveCount; ++i )
	{
		const toolPrimitive* primitive = s_model.meshes[0].primitives + i;
		for ( int32_t t = 0; t < primitive->indexCount; t += 3 )
		{
			soleVec3 p[3];
			for ( int k = 0; k < 3; ++k )
			{
				const float* q = primitive->positions + 3 * primitive->indices[t + k];
				p[k] = soleVec( q[0], q[1], q[2] );
			}
			soleVec3 n = soleCross( soleSub( p[1], p[0] ), soleSub( p[2], p[0] ) );
			assert_true( soleLength( n ) > 1e-9f );
			area = soleAdd( area, n );
			volume += soleDot( p[0], n );
			const float* vertexNormal = primitive->normals + 3 * primitive->indices[t];
			assert_true( soleDot( soleVec( vertexNormal[0], vertexNormal[1], vertexNormal[2] ), n ) > 0.0f );
		}
	}
	// A person is about as dense as water; joints that overlap count twice.
	assert_true( volume / 6.0f > 0.05f && volume / 6.0f < 0.09f );
	assert_true( soleLength( area ) < 0.01f );
}

static void testSoleIsFlat( void** state )
{
	(void)state;
	const toolPrimitive* soles = s_model.meshes[0].primitives + 2;
	float low[3] = { 1.0f, 1.0f, 1.0f };
	float high[3] = { -1.0f, -1.0f, -1.0f };
	for ( int32_t v = 0; v < soles->vertexCount; ++v )
	{
		const float* p = soles->positions + 3 * v;
		if ( soles->normals[3 * v + 1] < -0.99f && p[0] > 0.0f )
		{
			for ( int k = 0; k < 3; ++k )
			{
				low[k] = soleMinF( low[k], p[k] );
				high[k] = soleMaxF( high[k], p[k] );
			}
		}
	}
	assert_true( high[1] - low[1] < 0.0005f );
	assert_float_equal( low[1], 0.0f, 0.0005f );
	assert_float_equal( high[0] - low[0], 0.09f, 0.003f );
	assert_float_equal( high[2] - low[2], 0.255f, 0.001f );
}

static void testClips( void** state )
{
	(void)state;
	assert_int_equal( s_model.clipCount, 8 );
	for ( int32_t i = 0; i < s_model.clipCount; ++i )
	{
		const toolClip* clip = s_model.clips + i;
		for ( int32_t k = 0; k < clip->channelCount; ++k )
		{
			const toolChannel* channel = clip->channels + k;
			int32_t width = channel->path == tool_pathRotation ? 4 : 3;
			for ( int32_t v = 0; v < width * channel->keyCount; ++v )
			{
				assert_true( soleIsFinite( channel->values[v] ) );
			}
			for ( int32_t v = 0; v < width && channel->node != findNode( "root" ); ++v )
			{
				float last = channel->values[width * ( channel->keyCount - 1 ) + v];
				assert_true( channel->values[v] == last );
			}
			assert_true( channel->times[0] == 0.0f && channel->times[channel->keyCount - 1] == clip->end );
		}
	}
	assert_float_equal( findClip( "idle" )->end, 4.0f, 1e-5f );
}

/// The last key was made equal to the first: if the motion had not come back by itself, it would jump there.
static void testLoopsWithoutAJump( void** state )
{
	(void)state;
	for ( int32_t i = 0; i < s_model.clipCount; ++i )
	{
		const toolClip* clip = s_model.clips + i;
		for ( int32_t k = 0; k < clip->channelCount; ++k )
		{
			const toolChannel* channel = clip->channels + k;
			const float* v = channel->values;
			int32_t n = channel->keyCount;
			if ( channel->path != tool_pathRotation || channel->node == findNode( "root" ) )
			{
				continue;
			}
			for ( int32_t c = 0; c < 4; ++c )
			{
				float before = v[4 * ( n - 1 ) + c] - v[4 * ( n - 2 ) + c];
				float after = v[4 + c] - v[c];
				assert_float_equal( before, after, 0.02f );
			}
		}
	}
}

static void testWalk( void** state )
{
	(void)state;
	checkFeet( "walk", soleVec( 0.0f, 0.0f, 1.3f ), 0.0025f );
	float peak = 0.0f;
	float loading = 0.0f;
	float clearance = 1.0f;
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		float phase = (float)i / (float)( s_sampleCount - 1 );
		float knee = s_samples[i].knee[0];
		peak = phase > 0.62f ? soleMaxF( peak, knee ) : peak;
		loading = phase < 0.3f ? soleMaxF( loading, knee ) : loading;
		bool middle = phase > 0.72f && phase < 0.85f;
		clearance = middle ? soleMinF( clearance, footLowest( s_samples + i, 0 ) ) : clearance;
	}
	print_message( "walk: knee %.1f in the swing, %.1f in loading; clearance %.1f mm\n", (double)peak, (double)loading,
	    1e3 * (double)clearance );
	assert_true( peak > 55.0f && peak < 68.0f );
	// Published 15 to 20 degrees; all of the stance is bent some 12 degrees more here, as no leg may be nearly
	// straight.
	assert_true( loading > 20.0f && loading < 34.0f );
	assert_true( clearance > 0.010f && clearance < 0.025f );
}

static void testRun( void** state )
{
	(void)state;
	checkFeet( "run", soleVec( 0.0f, 0.0f, 3.3f ), 0.0015f );
	float peak = 0.0f;
	float stance = 0.0f;
	int32_t flight = 0;
	for ( int32_t i = 0; i + 1 < s_sampleCount; ++i )
	{
		float phase = (float)i / (float)( s_sampleCount - 1 );
		peak = soleMaxF( peak, s_samples[i].knee[0] );
		stance = phase < 0.36f ? soleMaxF( stance, s_samples[i].knee[0] ) : stance;
		flight += footLowest( s_samples + i, 0 ) > 0.002f && footLowest( s_samples + i, 1 ) > 0.002f ? 1 : 0;
	}
	float share = (float)flight / (float)( s_sampleCount - 1 );
	print_message( "run: knee %.1f in the swing, %.1f in stance; flight %.0f %% of the time\n", (double)peak,
	    (double)stance, 100.0 * (double)share );
	assert_true( peak > 85.0f && peak < 115.0f );
	assert_true( stance > 38.0f && stance < 55.0f );
	assert_true( share > 0.12f && share < 0.40f );
}

/// The speed that the flat foot pretends, in the frame of the body.
static void testStanceSpeed( void** state )
{
	(void)state;
	static const struct
	{
		const char* name;
		float speed;
	} s_cases[] = { { "walk", 1.3f }, { "run", 3.3f }, { "walk_root", 0.0f }, { "crouch_walk", 0.8f } };
	for ( size_t i = 0; i < sizeof s_cases / sizeof s_cases[0]; ++i )
	{
		measureClip( s_cases[i].name, soleVec( 0.0f, 0.0f, 0.0f ) );
		// The toe is on the floor from 12 to 24 % of either stride at least.
		int32_t from = ( s_sampleCount - 1 ) * 12 / 100;
		int32_t to = ( s_sampleCount - 1 ) * 24 / 100;
		float way = s_samples[from].ball[0].z - s_samples[to].ball[0].z;
		assert_float_equal( way / ( s_step * (float)( to - from ) ), s_cases[i].speed, 0.01f );
	}
	const toolClip* walk = findClip( "walk_root" );
	const toolChannel* root = walk->channels;
	assert_int_equal( root->node, findNode( "root" ) );
	assert_float_equal( root->values[3 * ( root->keyCount - 1 ) + 2] / walk->end, 1.3f, 1e-4f );
}

static void testIdleStandsStill( void** state )
{
	(void)state;
	checkFeet( "idle", soleVec( 0.0f, 0.0f, 0.0f ), 0.0003f );
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		for ( int side = 0; side < 2; ++side )
		{
			testNear3( s_samples[i].heel[side], s_samples[0].heel[side], 0.0003f );
			testNear3( s_samples[i].tip[side], s_samples[0].tip[side], 0.0003f );
		}
	}
}

static void testCrouch( void** state )
{
	(void)state;
	checkFeet( "crouch", soleVec( 0.0f, 0.0f, 0.0f ), 0.0003f );
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		for ( int side = 0; side < 2; ++side )
		{
			assert_true( s_samples[i].knee[side] > 90.0f && s_samples[i].knee[side] < 125.0f );
			assert_true( s_samples[i].heel[side].y < 0.0005f && s_samples[i].tip[side].y < 0.0005f );
		}
	}
	checkFeet( "crouch_walk", soleVec( 0.0f, 0.0f, 0.8f ), 0.0025f );
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		assert_true( s_samples[i].knee[0] > 45.0f && s_samples[i].knee[0] < 125.0f );
	}
}

/// To the left, one foot always down, feet never nearer than a shoe is wide.
static void testStrafe( void** state )
{
	(void)state;
	checkFeet( "strafe", soleVec( 0.3f, 0.0f, 0.0f ), 0.0010f );
	float nearest = 1.0f;
	float highest = 0.0f;
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		const Sample* sample = s_samples + i;
		assert_true( soleMinF( footLowest( sample, 0 ), footLowest( sample, 1 ) ) < 0.001f );
		nearest = soleMinF( nearest, sample->heel[0].x - sample->heel[1].x );
		highest = soleMaxF( highest, footLowest( sample, 0 ) );
	}
	print_message( "strafe: heels %.0f mm apart at least, feet up to %.0f mm high\n", 1e3 * (double)nearest,
	    1e3 * (double)highest );
	assert_true( nearest > 0.11f );
	assert_true( highest > 0.015f );
	assert_float_equal( s_samples[s_sampleCount - 1].ball[0].x - s_samples[0].ball[0].x, 0.3f, 1e-4f );
}

static void testTurn( void** state )
{
	(void)state;
	checkFeet( "turn", soleVec( 0.0f, 0.0f, 0.0f ), 0.0015f );
	const toolChannel* root = findClip( "turn" )->channels;
	const float* last = root->values + 4 * ( root->keyCount - 1 );
	assert_int_equal( root->node, findNode( "root" ) );
	assert_float_equal( last[1], sqrtf( 0.5f ), 1e-5f );
	assert_float_equal( last[3], sqrtf( 0.5f ), 1e-5f );
	// At every moment one foot at least stands.
	for ( int32_t i = 0; i < s_sampleCount; ++i )
	{
		assert_true( soleMinF( footLowest( s_samples + i, 0 ), footLowest( s_samples + i, 1 ) ) < 0.001f );
	}
}

/// Knees without knocks: no angular acceleration far beyond the published peaks (walk about 60, run about 300 rad/s^2
/// in smooth curves), measured between the keys' second differences.
static void testKneesAreSmooth( void** state )
{
	(void)state;
	static const struct
	{
		const char* name;
		float limit;
	} s_cases[] = { { "idle", 5.0f }, { "walk", 260.0f }, { "run", 800.0f }, { "turn", 120.0f }, { "strafe", 120.0f },
		{ "crouch", 5.0f }, { "crouch_walk", 260.0f } };
	for ( size_t i = 0; i < sizeof s_cases / sizeof s_cases[0]; ++i )
	{
		measureClip( s_cases[i].name, soleVec( 0.0f, 0.0f, 0.0f ) );
		float key = s_step * STEPS_A_KEY;
		float largest = 0.0f;
		for ( int32_t k = STEPS_A_KEY; k + STEPS_A_KEY < s_sampleCount; k += STEPS_A_KEY )
		{
			float second =
			    s_samples[k + STEPS_A_KEY].knee[0] - 2.0f * s_samples[k].knee[0] + s_samples[k - STEPS_A_KEY].knee[0];
			largest = soleMaxF( largest, fabsf( second ) / ( DEGREES * key * key ) );
		}
		print_message( "%-10s largest knee acceleration %.0f rad/s^2\n", s_cases[i].name, (double)largest );
		assert_true( largest < s_cases[i].limit );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( testMeasures ),
		cmocka_unit_test( testMesh ),
		cmocka_unit_test( testClosedAndOutward ),
		cmocka_unit_test( testSoleIsFlat ),
		cmocka_unit_test( testClips ),
		cmocka_unit_test( testLoopsWithoutAJump ),
		cmocka_unit_test( testWalk ),
		cmocka_unit_test( testRun ),
		cmocka_unit_test( testStanceSpeed ),
		cmocka_unit_test( testIdleStandsStill ),
		cmocka_unit_test( testCrouch ),
		cmocka_unit_test( testStrafe ),
		cmocka_unit_test( testTurn ),
		cmocka_unit_test( testKneesAreSmooth ),
	};
	return cmocka_run_group_tests( tests, setup, teardown );
}
