// SPDX-License-Identifier: MIT
// Every scene is a closed solid that can be walked, with the measures that it is named for.
#include "ground_support.h"
#include "scenario.h"
#include "source.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

#define TAN_12 0.21255656f
#define TAN_15 0.26794919f
#define TAN_30 0.57735027f

static soleGround* makeSceneGround( const soleScene* scene )
{
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = scene->positions;
	mesh.vertexCount = scene->vertexCount;
	mesh.indices = scene->indices;
	mesh.triangleCount = scene->triangleCount;
	return testMakeGround( &mesh, 1 );
}

static void makeScene( const char* id, soleScene* scene )
{
	if ( !soleMakeScene( id, scene ) )
	{
		fail_msg( "%s is not made", id );
	}
}

/// Calls check with every scene.
static void withEveryScene( void ( *check )( const soleScene* scene ) )
{
	int32_t count;
	const char* const* ids = soleGetSceneIds( &count );
	assert_true( count >= 46 );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleScene scene;
		makeScene( ids[i], &scene );
		assert_string_equal( scene.id, ids[i] );
		assert_true( strlen( scene.name ) > 0 );
		check( &scene );
		soleFreeScene( &scene );
	}
}

static void checkNumbers( const soleScene* scene )
{
	assert_true( scene->vertexCount > 0 && scene->triangleCount > 0 );
	for ( int32_t i = 0; i < 3 * scene->vertexCount; ++i )
	{
		assert_true( soleIsFinite( scene->positions[i] ) );
	}
	for ( int32_t i = 0; i < 3 * scene->triangleCount; ++i )
	{
		assert_true( scene->indices[i] < (uint32_t)scene->vertexCount );
	}
	soleGround* ground = makeSceneGround( scene );
	assert_int_equal( soleGround_GetTriangleCount( ground ), scene->triangleCount );
	soleDestroyGround( ground );
}

static void everySceneIsFiniteAndHasNoTriangleWithoutArea( void** state )
{
	(void)state;
	withEveryScene( checkNumbers );
}

static int compareKeys( const void* a, const void* b )
{
	uint64_t left;
	uint64_t right;
	memcpy( &left, a, sizeof left );
	memcpy( &right, b, sizeof right );
	return left < right ? -1 : ( left > right ? 1 : 0 );
}

static void checkClosed( const soleScene* scene )
{
	int32_t count = 3 * scene->triangleCount;
	uint64_t* edges = malloc( (size_t)count * sizeof *edges );
	uint64_t* reversed = malloc( (size_t)count * sizeof *reversed );
	assert_true( edges != NULL && reversed != NULL );
	double volume = 0.0;
	for ( int32_t i = 0; i < count; ++i )
	{
		uint64_t a = scene->indices[i];
		uint64_t b = scene->indices[i % 3 == 2 ? i - 2 : i + 1];
		edges[i] = a << 32 | b;
		reversed[i] = b << 32 | a;
		if ( i % 3 == 0 )
		{
			testMesh mesh = { scene->positions, scene->vertexCount, scene->indices, scene->triangleCount };
			testPoint n =
			    testCross( testWide( testCorner( &mesh, i / 3, 1 ) ), testWide( testCorner( &mesh, i / 3, 2 ) ) );
			volume += testDot( testWide( testCorner( &mesh, i / 3, 0 ) ), n ) / 6.0;
		}
	}
	qsort( edges, (size_t)count, sizeof *edges, compareKeys );
	qsort( reversed, (size_t)count, sizeof *reversed, compareKeys );
	for ( int32_t i = 0; i < count; ++i )
	{
		assert_true( i == 0 || edges[i] != edges[i - 1] );
		assert_true( edges[i] == reversed[i] );
	}
	assert_true( volume > 1.0 );
	free( edges );
	free( reversed );
}

static void everyEdgeOfASceneIsSharedByTwoFacesThatLookOut( void** state )
{
	(void)state;
	withEveryScene( checkClosed );
}

static void checkPath( const soleScene* scene )
{
	soleGround* ground = makeSceneGround( scene );
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	assert_true( scene->pathCount >= 2 && scene->pathCount <= SOLE_SCENE_MAX_PATH );
	for ( int32_t i = 0; i < scene->pathCount; ++i )
	{
		const float* p = scene->path[i];
		assert_true( p[0] >= lower.x + 0.7f && p[0] <= upper.x - 0.7f );
		assert_true( p[1] >= lower.z + 0.7f && p[1] <= upper.z - 0.7f );
	}
	for ( int32_t i = 0; i + 1 < scene->pathCount; ++i )
	{
		assert_true( scene->path[i + 1][1] > scene->path[i][1] + 1.0f );
		for ( int32_t k = 0; k <= 3000; ++k )
		{
			float t = (float)k / 3000.0f;
			soleVec3 start = { scene->path[i][0] + t * ( scene->path[i + 1][0] - scene->path[i][0] ), upper.y + 1.0f,
				scene->path[i][1] + t * ( scene->path[i + 1][1] - scene->path[i][1] ) };
			start.x += k % 3 == 0 ? 0.0f : ( k % 3 == 1 ? -0.11f : 0.13f );
			soleHit hit = testCast( ground, start, down, upper.y - lower.y + 1.0f, 0.0f );
			assert_true( hit.hit && hit.normal_w.y > 0.0f );
			assert_true( hit.point_w.y > lower.y + 0.5f );
			// It is solid below: the way out, through the bottom, is met from inside by no face.
			assert_false( testCast( ground, soleVec( start.x, lower.y + 0.1f, start.z ), down, 1.0f, 0.0f ).hit );
		}
	}
	soleDestroyGround( ground );
}

static void thereIsGroundAllAlongThePath( void** state )
{
	(void)state;
	withEveryScene( checkPath );
}

typedef struct heightAt
{
	float x;
	float z;
	float y;
} heightAt;

static void expectHeights( const char* id, const heightAt* heights, int32_t count )
{
	soleScene scene;
	makeScene( id, &scene );
	soleGround* ground = makeSceneGround( &scene );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleHit hit = testCast( ground, soleVec( heights[i].x, 30.0f, heights[i].z ), down, 60.0f, 0.0f );
		assert_true( hit.hit );
		if ( fabsf( hit.point_w.y - heights[i].y ) > 1e-5f )
		{
			fail_msg( "%s at x %g z %g: %g, not %g", id, (double)heights[i].x, (double)heights[i].z,
			    (double)hit.point_w.y, (double)heights[i].y );
		}
	}
	soleDestroyGround( ground );
	soleFreeScene( &scene );
}

#define EXPECT_HEIGHTS( id, ... )                                                                                      \
	do                                                                                                                 \
	{                                                                                                                  \
		const heightAt heights[] = { __VA_ARGS__ };                                                                    \
		expectHeights( id, heights, (int32_t)( sizeof heights / sizeof heights[0] ) );                                 \
	} while ( 0 )

static void rampsHaveTheirHeights( void** state )
{
	(void)state;
	EXPECT_HEIGHTS( "flat", { 0, 0, 0 }, { -9.9f, 9.9f, 0 } );
	EXPECT_HEIGHTS( "T01", { 0, 0, 0 }, { -9.9f, 9.9f, 0 } );
	EXPECT_HEIGHTS( "ramp", { 0, 1, 0 }, { 1.2f, 3, TAN_15 }, { 0, 7, 4 * TAN_15 }, { -1, 11, TAN_15 }, { 0, 13, 0 } );
	EXPECT_HEIGHTS( "T11-10", { 3, 6, 4 * 0.17632698f } );
	EXPECT_HEIGHTS( "T11-20", { 3, 6, 4 * 0.36397023f } );
	EXPECT_HEIGHTS( "T11-30", { 3, 6, 4 * TAN_30 }, { 0, 11, 8 * TAN_30 }, { 0, 16, 4 * TAN_30 }, { 0, 21, 0 } );
	EXPECT_HEIGHTS( "T11-45", { 3, 6, 4 }, { -3, 16, 4 } );
	EXPECT_HEIGHTS(
	    "T12", { 0, 2, 0 }, { 1, 6, 2 * TAN_30 }, { 0, 10, 4 * TAN_30 }, { 0, 14, 2 * TAN_30 }, { 0, 18, 0 } );
	EXPECT_HEIGHTS( "T14-20", { 1, 6, 0.36397023f }, { -2, 1, -2 * 0.36397023f } );
	EXPECT_HEIGHTS( "T14-30", { 1, 6, TAN_30 }, { 0, 3, 0 } );
}

static void expectStairs( const char* id, int32_t count, float rise, float tread )
{
	float top = 2.0f + (float)( count - 1 ) * tread;
	for ( int32_t i = 0; i + 1 < count; ++i )
	{
		float y = rise * (float)( i + 1 );
		float z = tread * (float)i;
		EXPECT_HEIGHTS( id, { 0, 2 + z + 0.01f, y }, { 0.9f, 2 + z + tread - 0.01f, y } );
		float back = top + 1.2f + (float)( count - 1 ) * tread - z;
		EXPECT_HEIGHTS( id, { 0, back - 0.01f, y }, { -0.9f, back - tread + 0.01f, y } );
	}
	EXPECT_HEIGHTS( id, { 0, 1.99f, 0 }, { 0, top + 0.01f, rise * (float)count },
	    { 0, top + 1.19f, rise * (float)count }, { 0, 2 * top - 2 + 1.21f, 0 } );
}

static void stairsHaveTheirStepsUpAndDown( void** state )
{
	(void)state;
	expectStairs( "stairs", 8, 0.17f, 0.29f );
	expectStairs( "T02", 12, 0.17f, 0.29f );
	expectStairs( "T03", 12, 0.20f, 0.25f );
	EXPECT_HEIGHTS( "T08", { 0, -0.01f, 0 }, { 0, 0.01f, 0.15f }, { 2, 1.99f, 0.15f }, { 0, 2.01f, 0 } );
}

static void obstaclesHaveTheirSizes( void** state )
{
	(void)state;
	EXPECT_HEIGHTS( "T04", { 5.9f, 2.01f, 0.17f }, { -5.9f, 5.2f, 12 * 0.17f }, { 0, 9.88f, 0 } );
	EXPECT_HEIGHTS( "T07", { 0, 1.9f, 0 }, { 0.9f, 2.01f, 0.17f }, { 0, 2.23f, 0.17f }, { 0, 2.25f, 0 },
	    { 0, 2.28f, 0 }, { 0, 2.30f, 0.34f }, { 1.1f, 2.30f, 0 }, { 0, 5.2f, 12 * 0.17f } );
	EXPECT_HEIGHTS( "T09", { 0, 1.99f, 0 }, { 0, 2.05f, 0.10f }, { 1, 2.11f, 0 }, { -1, 8.35f, 0.10f } );
	EXPECT_HEIGHTS( "T10", { 0, 2.49f, 0 }, { 0, 2.55f, -2 }, { 0, 2.61f, 0 }, { 1, 5.2f, -2 }, { 0, 5.31f, 0 },
	    { 0, 7.9f, -2 }, { 0, 8.14f, -2 }, { 0, 8.16f, 0 } );
	EXPECT_HEIGHTS( "T13", { 0.49f, 1, 0 }, { 0.51f, 1, -1.5f }, { -0.4f, 4, 2 * 0.36397023f },
	    { 0, 8, 5 * 0.36397023f }, { -0.51f, 8, -1.5f } );
	EXPECT_HEIGHTS(
	    "T15-60", { 0, 5, 0.05f * 1.7320508f }, { 0.025f, 5, 0.025f * 1.7320508f }, { 0.051f, 5, 0 }, { 0, 1.9f, 0 } );
	EXPECT_HEIGHTS( "T15-75", { -0.025f, 5, 0.025f * 3.7320508f } );
	EXPECT_HEIGHTS( "T18", { 0.105f, 0, 0 }, { 1.105f, 1, -0.06992681f }, { -0.895f, -1, -0.06992681f } );
	EXPECT_HEIGHTS( "T24", { 0, 1.99f, 0 }, { 0, 2.01f, -3 } );
	EXPECT_HEIGHTS( "T25-12", { 0.059f, 3, 1 }, { 0.061f, 3, 0 }, { 0, 0.9f, 0 }, { 0, 6.99f, 1 } );
	EXPECT_HEIGHTS( "T25-20", { -0.099f, 3, 1 }, { -0.101f, 3, 0 } );
	EXPECT_HEIGHTS( "T26-17", { 0, 0.01f, 0.17f }, { 0, -0.01f, 0 } );
	EXPECT_HEIGHTS( "T26-50", { 0, 0.01f, 0.5f }, { 0, -0.01f, 0 } );
	EXPECT_HEIGHTS( "T34", { 3, 6, 4 * TAN_12 } );
}

static float lookDown( const soleGround* ground, float x, float y, float z )
{
	soleHit hit = testCast( ground, soleVec( x, y, z ), down, 10.0f, 0.0f );
	assert_true( hit.hit );
	return hit.point_w.y;
}

static void roofsHaveSpaceBelow( void** state )
{
	(void)state;
	soleScene scene;
	makeScene( "T21", &scene );
	soleGround* ground = makeSceneGround( &scene );
	assert_float_equal( lookDown( ground, 0.0f, 2.0f, 4.0f ), 0.80f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.0f, 0.7f, 4.0f ), 0.05f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.0f, 0.7f, 1.9f ), 0.0f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.2f, 0.4f, 5.9f ), 0.40f - sqrtf( 0.35f * 0.35f - 0.04f ), 1e-3f );
	// The roof is met from below, on its way up.
	soleHit hit = testCast( ground, soleVec( 0.0f, 0.4f, 4.0f ), soleVec( 0.0f, 1.0f, 0.0f ), 5.0f, 0.0f );
	assert_true( hit.hit );
	assert_float_equal( hit.point_w.y, 0.75f, 1e-5f );
	soleDestroyGround( ground );
	soleFreeScene( &scene );
	makeScene( "T22", &scene );
	ground = makeSceneGround( &scene );
	assert_float_equal( lookDown( ground, 0.5f, 2.0f, 3.2f ), 0.45f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.5f, 0.39f, 3.2f ), 0.0f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.5f, 2.0f, 6.0f ), 1.0f, 1e-5f );
	assert_float_equal( lookDown( ground, 0.5f, 0.89f, 6.0f ), 0.0f, 1e-5f );
	soleDestroyGround( ground );
	soleFreeScene( &scene );
}

static void checkPieces( const soleScene* scene )
{
	int32_t next = 0;
	assert_true( scene->pieceCount >= 1 && scene->pieceCount <= SOLE_SCENE_MAX_PIECES );
	for ( int32_t i = 0; i < scene->pieceCount; ++i )
	{
		const soleScenePiece* piece = scene->pieces + i;
		assert_int_equal( piece->firstTriangle, next );
		assert_true( piece->triangleCount > 0 );
		assert_int_equal( piece->surface, i == 0 ? SOLE_NONE : i );
		assert_int_not_equal( piece->layer, 0 );
		next += piece->triangleCount;
		soleTransform place;
		soleGetScenePiece( scene, i, 0.0, &place );
		testNear3( place.translation, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
		assert_true( place.rotation.w == 1.0f );
		for ( int k = 0; k < 200; ++k )
		{
			// Speeds are those of the motion, but where it stops dead.
			double time = 0.0505 + 0.05 * k;
			double step = 1.0 / 256.0;
			soleTransform before;
			soleTransform after;
			soleVec3 velocity;
			soleVec3 spin;
			assert_int_equal( soleGetScenePiece( scene, i, time, &place ),
			    time >= piece->motion.from && ( piece->motion.until <= 0.0 || time < piece->motion.until ) );
			soleGetScenePiece( scene, i, time - step, &before );
			soleGetScenePiece( scene, i, time + step, &after );
			soleGetScenePieceSpeed( scene, i, time, &velocity, &spin );
			float perSecond = (float)( 0.5 / step );
			bool stops = fabs( time - piece->motion.stopTime ) <= step;
			soleVec3 moved = soleScale( perSecond, soleSub( after.translation, before.translation ) );
			soleQuat turned = soleMulQuat( after.rotation, soleConjugate( before.rotation ) );
			soleVec3 turn = soleScale( 2.0f * perSecond, soleVec( turned.x, turned.y, turned.z ) );
			testNear3( moved, stops ? moved : velocity, 2e-3f );
			testNear3( turn, spin, 2e-3f );
		}
	}
	assert_int_equal( next, scene->triangleCount );
}

static void piecesAreAllOfASceneAndMoveAtTheirSpeeds( void** state )
{
	(void)state;
	withEveryScene( checkPieces );
}

/// Where a point of a piece is at a time.
static soleVec3 carry( const char* id, int32_t piece, double time, soleVec3 point )
{
	soleScene scene;
	makeScene( id, &scene );
	soleTransform place;
	soleGetScenePiece( &scene, piece, time, &place );
	soleFreeScene( &scene );
	return soleTransformPoint( place, point );
}

static void piecesMoveAsTheyShould( void** state )
{
	(void)state;
	const soleVec3 origin = { 0.0f, 0.0f, 0.0f };
	testNear3( carry( "T27-lift", 1, 1.0, origin ), soleVec( 0.0f, 0.5f, 0.0f ), 1e-5f );
	testNear3( carry( "T27-lift", 1, 3.0, origin ), soleVec( 0.0f, -0.5f, 0.0f ), 1e-5f );
	testNear3( carry( "T27-slide", 1, 1.5, origin ), soleVec( 0.0f, 0.0f, 3.0f ), 1e-5f );
	testNear3( carry( "T27-slide", 1, 7.0, origin ), soleVec( 0.0f, 0.0f, 4.0f ), 1e-5f );
	testNear3( carry( "T27-both", 1, 5.0, origin ), soleVec( 0.0f, 0.5f, 4.0f ), 1e-5f );
	// A quarter to the left, about its own middle, after 2 s.
	testNear3( carry( "T28", 1, 2.0, soleVec( 0.13f, 0.0f, 0.16f ) ), soleVec( 0.23f, 0.0f, 0.06f ), 1e-5f );
	testNear3( carry( "T29", 1, 0.5, origin ), soleVec( 0.0f, 0.15f, 0.0f ), 1e-5f );
	testNear3( carry( "T29", 2, 0.5, origin ), soleVec( 0.0f, -0.15f, 0.0f ), 1e-5f );
	testNear3( carry( "T30", 1, 0.5, soleVec( 0.0f, 0.0f, 1.0f ) ), soleVec( 0.0f, -0.25881905f, 0.96592583f ), 1e-5f );
	testNear3( carry( "T19", 2, 3.0, origin ), soleVec( 0.0f, 0.0f, 0.3f ), 1e-5f );
	soleScene scene;
	soleTransform place;
	makeScene( "T23-15", &scene );
	assert_false( soleGetScenePiece( &scene, 1, 1.99, &place ) );
	assert_true( soleGetScenePiece( &scene, 1, 2.0, &place ) );
	soleFreeScene( &scene );
	makeScene( "T30", &scene );
	assert_true( soleGetScenePiece( &scene, 1, 2.99, &place ) );
	assert_false( soleGetScenePiece( &scene, 1, 3.0, &place ) );
	soleFreeScene( &scene );
}

static void theCourseHasAllItsPieces( void** state )
{
	(void)state;
	const float ramp = 2.5f * TAN_15;
	EXPECT_HEIGHTS( "course", { 0, 1, 0 }, { 1.9f, 4, TAN_15 }, { 0, 6, ramp }, { 0, 7.01f, ramp + 0.17f }, // stairs up
	    { 0, 7.30f, ramp + 0.34f }, { 1, 8.20f, ramp + 0.85f }, { 0, 9.65f, ramp + 0.85f },                 // landing
	    { 0, 9.67f, ramp + 0.68f }, { 0, 10.81f, ramp + 0.17f }, { 0, 10.83f, ramp }, // stairs down
	    { 0, 12.31f, ramp }, { 0, 12.33f, ramp + 0.12f }, { 0, 14.31f, ramp + 0.12f }, { 0, 14.33f, ramp }, // curb
	    { 0, 15.3f, ramp }, { 0, 19.33f, ramp },                                                            // rubble
	    { 0, 20.82f, ramp }, { 1, 20.82f, ramp + TAN_12 }, { -1.5f, 20.82f, ramp - 1.5f * TAN_12 }, // side slope
	    { 1.5f, 22.35f, ramp }, { 0, 24, ramp } );
}

static void getRubble( const char* id, float* lowest, float* highest )
{
	soleScene scene;
	makeScene( id, &scene );
	*lowest = 1.0f;
	*highest = -1.0f;
	for ( int32_t i = 0; i < scene.vertexCount; ++i )
	{
		const float* p = scene.positions + 3 * i;
		if ( p[1] > -0.5f && p[2] > 2.5f && p[2] < 7.5f )
		{
			*lowest = soleMinF( *lowest, p[1] );
			*highest = soleMaxF( *highest, p[1] );
		}
	}
	soleFreeScene( &scene );
}

static void rubbleIsRoughWithinItsAmplitudesAndFadesOut( void** state )
{
	(void)state;
	EXPECT_HEIGHTS( "rubble", { 0, 1, 0 }, { 1, 1.99f, 0 }, { 0, 9, 0 }, { -1, 8.01f, 0 } );
	float first[2];
	getRubble( "rubble", &first[0], &first[1] );
	float other[2];
	for ( int seed = 1; seed <= 40; ++seed )
	{
		char id[24];
		snprintf( id, sizeof id, "rubble-%d", seed );
		getRubble( id, &other[0], &other[1] );
		assert_true( other[1] > 0.02f && other[1] <= 0.1f );
		assert_true( other[0] < -0.02f && other[0] >= -0.1f );
		// Seed 1 is what comes without one; all others are different.
		assert_int_equal( seed == 1, other[0] == first[0] && other[1] == first[1] );
	}
}

static void aSceneIsTheSameEveryTime( void** state )
{
	(void)state;
	int32_t count;
	const char* const* ids = soleGetSceneIds( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleScene a;
		soleScene b;
		makeScene( ids[i], &a );
		makeScene( ids[i], &b );
		assert_int_equal( a.vertexCount, b.vertexCount );
		assert_memory_equal( a.positions, b.positions, (size_t)a.vertexCount * 12 );
		assert_memory_equal( a.indices, b.indices, (size_t)a.triangleCount * 12 );
		soleFreeScene( &a );
		soleFreeScene( &b );
	}
}

static void samplesShowWhatIsThereAtTimeZero( void** state )
{
	(void)state;
	const struct
	{
		const char* id;
		int32_t triangles;
	} cases[] = { { "T23-15", 12 }, { "T20-low", 12 }, { "T30", 24 }, { "T25-12", 24 } };
	for ( size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i )
	{
		toolGroundSource source;
		assert_true( toolOpenEmbeddedGround( cases[i].id, &source ) );
		assert_int_equal( source.mesh.triangleCount, cases[i].triangles );
		toolCloseGround( &source );
	}
}

static void unknownScenesAreRefused( void** state )
{
	(void)state;
	const char* ids[] = { "", "flats", "fla", "T99", "stairs-2", "rubble-", "rubble-x", "rubble-12345", "rubble-1x",
		"t02" };
	for ( size_t i = 0; i < sizeof ids / sizeof ids[0]; ++i )
	{
		soleScene scene;
		assert_false( soleMakeScene( ids[i], &scene ) );
		assert_null( scene.positions );
		assert_int_equal( scene.triangleCount, 0 );
		soleFreeScene( &scene );
	}
	soleScene scene;
	assert_false( soleMakeScene( NULL, &scene ) );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everySceneIsFiniteAndHasNoTriangleWithoutArea ),
		cmocka_unit_test( everyEdgeOfASceneIsSharedByTwoFacesThatLookOut ),
		cmocka_unit_test( thereIsGroundAllAlongThePath ),
		cmocka_unit_test( rampsHaveTheirHeights ),
		cmocka_unit_test( stairsHaveTheirStepsUpAndDown ),
		cmocka_unit_test( obstaclesHaveTheirSizes ),
		cmocka_unit_test( roofsHaveSpaceBelow ),
		cmocka_unit_test( piecesAreAllOfASceneAndMoveAtTheirSpeeds ),
		cmocka_unit_test( piecesMoveAsTheyShould ),
		cmocka_unit_test( theCourseHasAllItsPieces ),
		cmocka_unit_test( rubbleIsRoughWithinItsAmplitudesAndFadesOut ),
		cmocka_unit_test( aSceneIsTheSameEveryTime ),
		cmocka_unit_test( samplesShowWhatIsThereAtTimeZero ),
		cmocka_unit_test( unknownScenesAreRefused ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
