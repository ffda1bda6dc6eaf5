// SPDX-License-Identifier: MIT
// However triangles are found, what is answered is what asking every one of them answers, to the bit: seams, edges,
// corners, ties and all. The number of questions may be given: test_ground_exact 10000000.
#include "ground_support.h"

#include "ground/ground_internal.h"

static int32_t queryCount = 60000;
static uint32_t alongAxes = 8; // of ten probes
static int64_t askedCount;     // in the whole run
static int64_t metCount;

/// Asks every triangle, and keeps the one that goes before all others. A triangle's layers are its name.
static soleHit askAll( const testMesh* mesh, const uint32_t* layers, bool twoSided, const soleProbe* probe )
{
	soleHit hit = { .surface = SOLE_NONE, .asked_w = probe->start_w };
	soleGroundQuery query;
	if ( !soleMakeGroundQuery( probe->start_w, probe->direction_w, probe->length, probe->radius, probe->mask, &query ) )
	{
		return hit;
	}
	soleGroundTouch best = { .t = (double)INFINITY };
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		soleGroundBlock block;
		for ( int corner = 0; corner < 3; ++corner )
		{
			soleVec3 p = testCorner( mesh, i, corner );
			block.corners[corner][0][0] = p.x;
			block.corners[corner][1][0] = p.y;
			block.corners[corner][2][0] = p.z;
		}
		soleGroundTouch touch;
		if ( ( layers[i] & probe->mask ) == 0 || !soleMeetTriangle( &query, &block, 0, twoSided, &touch ) )
		{
			continue;
		}
		touch.index = i;
		touch.layer = layers[i];
		best = soleGroundTouch_IsBefore( &touch, &best ) ? touch : best;
	}
	hit.hit = best.hit;
	if ( best.hit )
	{
		hit.startedInside = best.inside;
		hit.layer = best.layer;
		hit.point_w = best.point;
		hit.normal_w = best.normal;
	}
	return hit;
}

static void assertSameHit( const soleHit* a, const soleHit* b, const soleProbe* probe )
{
	bool same = a->hit == b->hit && a->startedInside == b->startedInside && a->layer == b->layer &&
	    memcmp( &a->point_w, &b->point_w, sizeof a->point_w ) == 0 &&
	    memcmp( &a->normal_w, &b->normal_w, sizeof a->normal_w ) == 0;
	if ( same == false )
	{
		fail_msg( "from %a %a %a along %a %a %a by %a, radius %a: %d layer %x and %d layer %x",
		    (double)probe->start_w.x, (double)probe->start_w.y, (double)probe->start_w.z, (double)probe->direction_w.x,
		    (double)probe->direction_w.y, (double)probe->direction_w.z, (double)probe->length, (double)probe->radius,
		    a->hit, a->layer, b->hit, b->layer );
	}
}

/// A place on a corner, on an edge or in a face.
static soleVec3 placeOn( const testMesh* mesh, uint32_t* seed )
{
	int32_t triangle = (int32_t)( testRandom( seed ) % (uint32_t)mesh->triangleCount );
	static const float shares[] = { 0.0f, 0.5f, 0.25f, 0.37f, 1.0f };
	float a = shares[testRandom( seed ) % 5];
	float b = testRandom( seed ) % 2 == 0 ? 0.0f : testRandomFloat( seed, 0.0f, 1.0f );
	return soleLerp( soleLerp( testCorner( mesh, triangle, 0 ), testCorner( mesh, triangle, 1 ), a ),
	    testCorner( mesh, triangle, 2 ), b );
}

/// Mostly along an axis, as ground is asked for; from near a triangle or from anywhere.
static soleProbe makeProbe( const testMesh* mesh, float size, uint32_t* seed )
{
	static const float radii[] = { 0.0f, 0.0f, 0.0f, 0.001f, 0.1f, 0.8f };
	soleVec3 direction = testRandomDirection( seed );
	uint32_t kind = testRandom( seed ) % 10;
	if ( kind < alongAxes )
	{
		float sign = testRandom( seed ) % 4 == 0 ? 1.0f : -1.0f;
		direction = kind < 6 ? soleVec( 0.0f, sign, 0.0f )
		                     : ( kind == 6 ? soleVec( sign, 0.0f, 0.0f ) : soleVec( -0.0f, 0.0f, sign ) );
	}
	soleVec3 start = testRandom( seed ) % 4 == 0 ? testRandomPoint( seed, size ) : placeOn( mesh, seed );
	start = soleMulAdd( start, testRandomFloat( seed, -1.5f, 0.2f ), direction );
	float length = testRandom( seed ) % 8 == 0 ? 1000.0f : testRandomFloat( seed, 0.1f, 3.0f );
	soleProbe probe = testProbe( start, direction, length, radii[testRandom( seed ) % 6] );
	probe.mask = testRandom( seed ) % 8 == 0 ? 0x55555555u : 0xffffffffu;
	return probe;
}

/// One by one and many at once, against all triangles.
static void compareWithAll( const testMesh* mesh, bool twoSided, float size, uint32_t seed )
{
	uint32_t* layers = calloc( (size_t)mesh->triangleCount, sizeof *layers );
	for ( int32_t i = 0; i < mesh->triangleCount; ++i )
	{
		layers[i] = (uint32_t)i * 2654435761u | 1u << i % 32;
	}
	soleGroundMesh groundMesh = testGroundMesh( mesh );
	groundMesh.triangleLayers = layers;
	groundMesh.twoSided = twoSided;
	soleGround* ground = testMakeGround( &groundMesh, 1 );
	int32_t met = 0;
	for ( int32_t i = 0; i < queryCount / 15; i += 11 )
	{
		soleProbe probes[11];
		soleHit hits[11];
		for ( int32_t k = 0; k < 11; ++k )
		{
			probes[k] = makeProbe( mesh, size, &seed );
		}
		probes[3].length = 0.0f; // asks nothing
		soleCastProbes( ground, probes, 11, hits );
		for ( int32_t k = 0; k < 11; ++k )
		{
			soleHit slow = askAll( mesh, layers, twoSided, probes + k );
			soleHit one = soleCastProbe( ground, probes + k );
			assertSameHit( &one, &slow, probes + k );
			assertSameHit( hits + k, &slow, probes + k );
			met += slow.hit ? 1 : 0;
			askedCount += 1;
		}
	}
	assert_true( met > queryCount / 15 / 10 );
	metCount += met;
	soleDestroyGround( ground );
	free( layers );
}

static void turnMesh( testMesh* mesh, int32_t axis )
{
	for ( int32_t i = 0; i < mesh->vertexCount; ++i )
	{
		float* p = mesh->vertices + 3 * i;
		float turned[3] = { p[axis], p[( axis + 1 ) % 3], p[( axis + 2 ) % 3] };
		memcpy( p, turned, sizeof turned );
	}
}

static void terrainsOfEveryAxis( void** state )
{
	(void)state;
	for ( int32_t axis = 0; axis < 3; ++axis )
	{
		testMesh mesh = testMakeTerrain( 3u + (uint32_t)axis, 18, 0.3f, 0.4f );
		turnMesh( &mesh, axis );
		compareWithAll( &mesh, axis == 1, 6.0f, 11u + (uint32_t)axis );
		testFreeMesh( &mesh );
	}
}

static void flatGridsFullOfSeams( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 5, 20, 0.25f, 0.0f );
	compareWithAll( &mesh, false, 6.0f, 5 );
	compareWithAll( &mesh, true, 6.0f, 6 );
	testFreeMesh( &mesh );
	mesh = testMakeTerrain( 6, 20, 0.1f, 0.02f );
	for ( int32_t i = 0; i < mesh.vertexCount; ++i )
	{
		mesh.vertices[3 * i] += 5000.0f; // far away: rounding is of the size of a millimetre
	}
	compareWithAll( &mesh, false, 6.0f, 7 );
	testFreeMesh( &mesh );
}

static void slantedProbesFarFromTheOrigin( void** state )
{
	(void)state;
	alongAxes = 0;
	testMesh mesh = testMakeTerrain( 8, 20, 0.05f, 0.02f );
	for ( int32_t i = 0; i < mesh.vertexCount; ++i )
	{
		mesh.vertices[3 * i] += 30000.0f;
		mesh.vertices[3 * i + 2] -= 30000.0f;
	}
	compareWithAll( &mesh, true, 2.0f, 41 );
	testFreeMesh( &mesh );
	alongAxes = 8;
}

static void soups( void** state )
{
	(void)state;
	for ( uint32_t seed = 1; seed <= 4; ++seed )
	{
		testMesh mesh = testMakeSoup( seed, 300, 3.0f, seed == 1 ? 0.05f : 0.8f * (float)seed );
		compareWithAll( &mesh, seed % 2 == 0, 4.0f, seed );
		testFreeMesh( &mesh );
	}
}

static void storeysAndWallsAndOneGreatFloor( void** state )
{
	(void)state;
	testMesh mesh = testAllocMesh( 5 * 81 + 4, 5 * 128 + 2 );
	mesh.vertexCount = 0;
	mesh.triangleCount = 0;
	for ( uint32_t storey = 0; storey < 5; ++storey )
	{
		testMesh part = testMakeTerrain( storey, 8, 0.5f, storey == 2 ? 0.0f : 0.3f );
		turnMesh( &part, storey == 4 ? 1 : 0 );
		for ( int32_t i = 0; i < part.vertexCount; ++i )
		{
			part.vertices[3 * i + 1] += 0.7f * (float)storey;
		}
		for ( int32_t i = 0; i < 3 * part.triangleCount; ++i )
		{
			mesh.indices[3 * mesh.triangleCount + i] = part.indices[i] + (uint32_t)mesh.vertexCount;
		}
		memcpy( mesh.vertices + 3 * mesh.vertexCount, part.vertices, (size_t)part.vertexCount * 12 );
		mesh.vertexCount += part.vertexCount;
		mesh.triangleCount += part.triangleCount;
		testFreeMesh( &part );
	}
	static const float floorCorners[12] = { -900, -0.2f, -900, -900, -0.2f, 900, 900, -0.2f, 900, 900, -0.2f, -900 };
	uint32_t first = (uint32_t)mesh.vertexCount;
	uint32_t quad[6] = { first, first + 1, first + 2, first, first + 2, first + 3 };
	memcpy( mesh.vertices + 3 * first, floorCorners, sizeof floorCorners );
	memcpy( mesh.indices + 3 * mesh.triangleCount, quad, sizeof quad );
	mesh.vertexCount += 4;
	mesh.triangleCount += 2;
	compareWithAll( &mesh, false, 5.0f, 21 );
	compareWithAll( &mesh, true, 5.0f, 22 );
	testFreeMesh( &mesh );
}

static void needlesFansAndCopies( void** state )
{
	(void)state;
	uint32_t seed = 31;
	testMesh mesh = testMakeSoup( 9, 240, 2.0f, 0.4f );
	for ( int32_t i = 0; i < 120; ++i )
	{
		float* p = mesh.vertices + 9 * i;
		for ( int k = 0; k < 3; ++k )
		{
			// Needles, then a fan about one corner, then the same triangle over and over.
			p[6 + k] = i < 40 ? p[k] + ( p[3 + k] - p[k] ) * 1.5f + testRandomFloat( &seed, -1e-4f, 1e-4f ) : p[6 + k];
			p[k] = i >= 40 && i < 80 ? 0.25f : p[k];
		}
		if ( i >= 80 )
		{
			memcpy( p, mesh.vertices + 9 * 200, 9 * sizeof *p );
		}
	}
	compareWithAll( &mesh, true, 2.5f, 33 );
	compareWithAll( &mesh, false, 2.5f, 34 );
	testFreeMesh( &mesh );
}

static void groundsOfAFewTriangles( void** state )
{
	(void)state;
	int32_t kept = queryCount;
	queryCount = kept / 8;
	for ( int32_t count = 1; count <= 9; ++count )
	{
		testMesh mesh = testMakeSoup( (uint32_t)count, count, 0.5f, 1.0f );
		compareWithAll( &mesh, true, 1.0f, (uint32_t)count );
		testFreeMesh( &mesh );
	}
	queryCount = kept;
}

static void numbersThatOverflowFindNothingThatIsNotThere( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 3, 6, 0.5f, 0.4f );
	soleGround* ground = testMakeMeshGround( &mesh, true );
	static const float huge[] = { 3e38f, -3e38f, 1e20f, 0.0f };
	for ( int32_t i = 0; i < 4 * 4 * 4 * 4; ++i )
	{
		soleVec3 start = { huge[i % 4], huge[i / 4 % 4], 1.0f };
		soleVec3 direction = i % 2 == 0 ? soleVec( 0.0f, -1.0f, 0.0f ) : soleVec( 0.3f, -0.9f, -0.3f );
		soleProbe probe = testProbe( start, direction, fabsf( huge[i / 16 % 4] ) + 1.0f, fabsf( huge[i / 64] ) );
		soleHit one = soleCastProbe( ground, &probe );
		soleHit many;
		soleCastProbes( ground, &probe, 1, &many );
		assertSameHit( &one, &many, &probe );
		assert_true( one.hit == false || soleVec3_IsFinite( one.point_w ) );
	}
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

int main( int argc, char** argv )
{
	queryCount = argc > 1 ? (int32_t)strtol( argv[1], NULL, 10 ) : queryCount;
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( terrainsOfEveryAxis ),
		cmocka_unit_test( flatGridsFullOfSeams ),
		cmocka_unit_test( slantedProbesFarFromTheOrigin ),
		cmocka_unit_test( soups ),
		cmocka_unit_test( storeysAndWallsAndOneGreatFloor ),
		cmocka_unit_test( needlesFansAndCopies ),
		cmocka_unit_test( groundsOfAFewTriangles ),
		cmocka_unit_test( numbersThatOverflowFindNothingThatIsNotThere ),
	};
	int failed = cmocka_run_group_tests( tests, NULL, NULL );
	print_message( "%lld questions, %lld of them met something, the same to the bit but for failed tests\n",
	    (long long)askedCount, (long long)metCount );
	return failed;
}
