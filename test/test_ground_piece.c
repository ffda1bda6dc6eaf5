// SPDX-License-Identifier: MIT
// Probes against moving pieces of ground: compared with the same triangles put where the piece is.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

static soleQuat randomTurn( uint32_t* seed )
{
	return soleNormalizeQuat( ( soleQuat ){ testRandomFloat( seed, -1.0f, 1.0f ), testRandomFloat( seed, -1.0f, 1.0f ),
	    testRandomFloat( seed, -1.0f, 1.0f ), testRandomFloat( seed, 0.1f, 1.0f ) } );
}

static soleTransform randomPlace( uint32_t* seed )
{
	soleTransform place = { testRandomPoint( seed, 3.0f ), randomTurn( seed ), { 1.0f, 1.0f, 1.0f } };
	return place;
}

static soleGroundPiece makePiece( const soleGround* ground, soleTransform transform, int32_t surface )
{
	return ( soleGroundPiece ){ .ground = ground, .transform = transform, .surface = surface };
}

/// The same triangles, carried to where a piece is.
static soleGround* makeCarried( const testMesh* mesh, soleTransform place )
{
	testMesh carried = testAllocMesh( mesh->vertexCount, mesh->triangleCount );
	memcpy( carried.indices, mesh->indices, (size_t)mesh->triangleCount * 3 * sizeof( uint32_t ) );
	for ( int32_t i = 0; i < mesh->vertexCount; ++i )
	{
		const float* p = mesh->vertices + 3 * i;
		soleVec3 moved = soleTransformPoint( place, soleVec( p[0], p[1], p[2] ) );
		memcpy( carried.vertices + 3 * i, &moved, sizeof moved );
	}
	soleGroundMesh groundMesh = testGroundMesh( &carried );
	soleGround* ground = testMakeGround( &groundMesh, 1 );
	testFreeMesh( &carried );
	return ground;
}

static void aMovedPieceAnswersAsTheGroundThatIsThere( void** state )
{
	(void)state;
	uint32_t seed = 5;
	int32_t met = 0;
	int32_t different = 0;
	for ( int32_t round = 0; round < 20; ++round )
	{
		testMesh mesh = testMakeSoup( seed + 77u, 200, 2.0f, 1.0f );
		soleGroundMesh groundMesh = testGroundMesh( &mesh );
		soleGround* own = testMakeGround( &groundMesh, 1 );
		soleTransform place = randomPlace( &seed );
		soleGround* there = makeCarried( &mesh, place );
		soleGroundPiece piece = makePiece( own, place, 7 );
		for ( int32_t i = 0; i < 200; ++i )
		{
			soleVec3 start = soleAdd( place.translation, testRandomPoint( &seed, 2.0f ) );
			float radius = i % 2 == 0 ? 0.0f : 0.05f;
			soleProbe probe = testProbe( start, testRandomDirection( &seed ), 6.0f, radius );
			soleHit a = soleCastPieces( &piece, 1, &probe );
			soleHit b = soleCastProbe( there, &probe );
			// Rounding may decide otherwise at a triangle's very edge.
			bool same = a.hit == b.hit && soleDistance( a.point_w, b.point_w ) < 1e-4f &&
			    soleDistance( a.normal_w, b.normal_w ) < 1e-4f && a.startedInside == b.startedInside;
			different += same ? 0 : 1;
			met += a.hit ? 1 : 0;
			assert_int_equal( a.surface, a.hit ? 7 : SOLE_NONE );
			testNear3( a.asked_w, start, 0.0f );
		}
		soleDestroyGround( own );
		soleDestroyGround( there );
		testFreeMesh( &mesh );
	}
	assert_true( met > 1000 );
	assert_true( different <= 4 );
}

static soleGround* makePlane( uint32_t layer, int32_t surface )
{
	soleGroundPlane plane = soleDefaultGroundPlane();
	plane.normal = soleVec( 0.0f, 1.0f, 0.0f );
	plane.layer = layer;
	plane.surface = surface;
	soleGroundDef def = soleDefaultGroundDef();
	def.planes = &plane;
	def.planeCount = 1;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	return ground;
}

static soleTransform raisedBy( float height )
{
	soleTransform place = soleTransform_Identity();
	place.translation.y = height;
	return place;
}

static void theNearestPieceWinsAndTiesGoToTheLowerIndex( void** state )
{
	(void)state;
	soleGround* ground = makePlane( 1, SOLE_NONE );
	soleProbe probe = testProbe( soleVec( 0.3f, 2.0f, 0.4f ), down, 5.0f, 0.0f );
	soleGroundPiece pieces[4] = { makePiece( ground, raisedBy( 0.0f ), 1 ), makePiece( ground, raisedBy( 0.5f ), 2 ),
		makePiece( ground, raisedBy( 0.5f ), 3 ), makePiece( NULL, raisedBy( 1.0f ), 4 ) };
	soleHit hit = soleCastPieces( pieces, 4, &probe );
	assert_true( hit.hit );
	assert_int_equal( hit.surface, 2 );
	testNear3( hit.point_w, soleVec( 0.3f, 0.5f, 0.4f ), 1e-6f );
	// A sphere's travel, not its touched point, says what is nearer; one that starts inside two is in the nearer.
	probe.radius = 0.1f;
	assert_int_equal( soleCastPieces( pieces, 4, &probe ).surface, 2 );
	probe.start_w.y = 0.05f;
	hit = soleCastPieces( pieces, 4, &probe );
	assert_true( hit.startedInside );
	assert_int_equal( hit.surface, 1 );
	assert_false( soleCastPieces( pieces, 0, &probe ).hit );
	assert_false( soleCastPieces( pieces + 3, 1, &probe ).hit );
	soleDestroyGround( ground );
}

static void layersAndSurfacesAreThoseOfThePiece( void** state )
{
	(void)state;
	soleGround* low = makePlane( 1, 11 );
	soleGround* high = makePlane( 2, SOLE_NONE );
	soleGroundPiece pieces[2] = { makePiece( low, raisedBy( 0.0f ), SOLE_NONE ),
		makePiece( high, raisedBy( 1.0f ), 5 ) };
	soleProbe probe = testProbe( soleVec( 0.0f, 3.0f, 0.0f ), down, 5.0f, 0.0f );
	soleHit hit = soleCastPieces( pieces, 2, &probe );
	assert_int_equal( hit.surface, 5 );
	assert_int_equal( hit.layer, 2 );
	probe.mask = 1;
	hit = soleCastPieces( pieces, 2, &probe );
	assert_int_equal( hit.surface, 11 );
	assert_int_equal( hit.layer, 1 );
	soleDestroyGround( low );
	soleDestroyGround( high );
}

static void theVelocityIsThatOfThePoint( void** state )
{
	(void)state;
	soleGround* ground = makePlane( 1, SOLE_NONE );
	soleGroundPiece piece = makePiece( ground, raisedBy( 0.2f ), 1 );
	piece.transform.translation.x = 1.0f;
	piece.velocity_w = soleVec( 0.0f, 0.5f, 2.0f );
	piece.spin_w = soleVec( 0.0f, 3.0f, 0.0f );
	soleProbe probe = testProbe( soleVec( 1.4f, 2.0f, -0.3f ), down, 5.0f, 0.0f );
	// Turning to the left carries what is ahead (+z) to +x, and what is at +x to -z.
	testNear3(
	    soleCastPieces( &piece, 1, &probe ).velocity_w, soleVec( 3.0f * -0.3f, 0.5f, 2.0f - 3.0f * 0.4f ), 1e-5f );
	soleDestroyGround( ground );
}

static void whatIsNotFiniteMisses( void** state )
{
	(void)state;
	soleGround* ground = makePlane( 1, SOLE_NONE );
	soleGroundPiece piece = makePiece( ground, raisedBy( 0.0f ), 1 );
	soleProbe probe = testProbe( soleVec( 0.0f, 1.0f, 0.0f ), down, 5.0f, 0.0f );
	assert_true( soleCastPieces( &piece, 1, &probe ).hit );
	piece.transform.translation.z = NAN;
	assert_false( soleCastPieces( &piece, 1, &probe ).hit );
	piece.transform.translation.z = 0.0f;
	// A rotation that says nothing counts as none; one that is too long as one of unit length.
	piece.transform.rotation = ( soleQuat ){ 0.0f, 0.0f, 0.0f, 0.0f };
	assert_true( soleCastPieces( &piece, 1, &probe ).hit );
	piece.transform.rotation = ( soleQuat ){ 0.0f, 0.0f, 0.0f, 3.0f };
	testNear3( soleCastPieces( &piece, 1, &probe ).normal_w, soleVec( 0.0f, 1.0f, 0.0f ), 1e-6f );
	probe.length = 0.0f;
	assert_false( soleCastPieces( &piece, 1, &probe ).hit );
	soleDestroyGround( ground );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aMovedPieceAnswersAsTheGroundThatIsThere ),
		cmocka_unit_test( theNearestPieceWinsAndTiesGoToTheLowerIndex ),
		cmocka_unit_test( layersAndSurfacesAreThoseOfThePiece ),
		cmocka_unit_test( theVelocityIsThatOfThePoint ),
		cmocka_unit_test( whatIsNotFiniteMisses ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
