// SPDX-License-Identifier: MIT
// Feet on bodies that move: lifts, turntables, vehicles. The bodies are pieces of ground, level squares of 4 m; the
// character's root rides on the first one. What a foot does is measured in the frame of the body that it stands on.
#include "placing.h"

#include "ground_support.h"

typedef struct Rider
{
	testRun run;
	soleGround* square;
	soleGroundPiece pieces[2];
	soleSupport supports[2];
	int32_t pieceCount;
	bool listed;
	soleTransform place; // of the root, in the first body's frame
} Rider;

static void start( Rider* r )
{
	memset( r, 0, sizeof *r );
	testStartRun( &r->run, 0.5f );
	testMesh mesh = testAllocMesh( 4, 2 );
	const float corners[] = { -2.0f, 0.0f, -2.0f, -2.0f, 0.0f, 2.0f, 2.0f, 0.0f, 2.0f, 2.0f, 0.0f, -2.0f };
	const uint32_t indices[] = { 0, 1, 2, 0, 2, 3 };
	memcpy( mesh.vertices, corners, sizeof corners );
	memcpy( mesh.indices, indices, sizeof indices );
	r->square = testMakeMeshGround( &mesh, false );
	testFreeMesh( &mesh );
	for ( int32_t i = 0; i < 2; ++i )
	{
		r->pieces[i] = ( soleGroundPiece ){ .ground = r->square, .transform = soleTransform_Identity(), .surface = i };
	}
	r->pieceCount = 1;
	r->listed = true;
	r->place = soleTransform_Identity();
}

static void finish( Rider* r )
{
	soleDestroyGround( r->square );
	testEndRun( &r->run );
}

/// A frame, the bodies where they are now.
static void stepOn( Rider* r )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	testRun* run = &r->run;
	for ( int32_t i = 0; i < r->pieceCount; ++i )
	{
		r->supports[i] = ( soleSupport ){ r->pieces[i].surface, r->pieces[i].transform };
	}
	run->frame.supports = r->listed ? r->supports : NULL;
	run->frame.supportCount = r->listed ? r->pieceCount : 0;
	int32_t n = soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < n; ++i )
	{
		hits[i] = soleCastPieces( r->pieces, r->pieceCount, probes + i );
	}
	soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, hits, n, &run->out );
	testPlace( run );
}

/// The root goes with the first body.
static void ride( Rider* r )
{
	r->run.frame.root = soleMulTransform( r->pieces[0].transform, r->place );
	r->run.frame.root.rotation = soleNormalizeQuat( r->run.frame.root.rotation );
	stepOn( r );
}

static soleTransform yawed( float angle, soleVec3 place )
{
	soleTransform t = soleTransform_Identity();
	t.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), angle );
	t.translation = place;
	return t;
}

/// Heel and ball of a foot in the frame of a body.
static void findInBody( const Rider* r, int32_t leg, int32_t piece, soleVec3 points[2] )
{
	soleSolePoints sole = soleRig_GetLeg( r->run.biped.rig, leg ).sole;
	points[0] = soleInvTransformPoint( r->pieces[piece].transform, testPlacedPoint( &r->run, leg, sole.heel, false ) );
	points[1] = soleInvTransformPoint( r->pieces[piece].transform, testPlacedPoint( &r->run, leg, sole.ball, false ) );
}

/// How far a foot is from where it was in the frame of its body.
static float findDrift( const Rider* r, int32_t leg, int32_t piece, const soleVec3 before[2] )
{
	soleVec3 now[2];
	findInBody( r, leg, piece, now );
	return fmaxf( soleDistance( now[0], before[0] ), soleDistance( now[1], before[1] ) );
}

static bool isPlanted( const Rider* r, int32_t leg )
{
	return ( r->run.out.legs[leg].flags & sole_legPlanted ) != 0;
}

/// Somewhere on a way that turns, climbs and goes about.
static soleTransform onItsWay( float t )
{
	return yawed( 0.8f * t, soleVec( 0.5f * sinf( t ), 0.3f * sinf( 0.7f * t ), 0.4f * t ) );
}

static void aFootRidesOnABodyThatMovesAndTurns( void** state )
{
	(void)state;
	static Rider r;
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		start( &r );
		r.place.translation = soleVec( 0.7f, 0.0f, -0.4f );
		r.run.frame.timeStep = 1.0f / rates[k];
		soleVec3 before[2][2] = { 0 };
		for ( int32_t i = 0; i < (int32_t)( 11.0f * rates[k] ); ++i )
		{
			r.pieces[0].transform = onItsWay( (float)i / rates[k] );
			ride( &r );
			for ( int32_t leg = 0; leg < 2 && i >= (int32_t)rates[k]; ++leg )
			{
				assert_true( isPlanted( &r, leg ) );
				if ( i == (int32_t)rates[k] )
				{
					findInBody( &r, leg, 0, before[leg] );
				}
				assert_true( findDrift( &r, leg, 0, before[leg] ) < 1e-4f );
				// And the body goes with it: no lag of the pelvis.
				assert_float_equal( soleLength( r.run.out.pelvisOffset_w ), 0.0f, 1e-4f );
			}
		}
		finish( &r );
	}
}

static void aFootRidesOnABodyThatTilts( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	r.place.translation = soleVec( 0.3f, 0.0f, -0.2f );
	soleVec3 before[2][2] = { 0 };
	for ( int32_t i = 0; i < 660; ++i )
	{
		float t = (float)i / 60.0f;
		soleTransform body = onItsWay( t );
		body.rotation = soleMulQuat( body.rotation, testTurn( soleVec( 0.0f, 0.0f, 1.0f ), 0.1f * sinf( 2.0f * t ) ) );
		r.pieces[0].transform = body;
		// The root stays upright.
		r.run.frame.root = yawed( 0.8f * t, soleTransformPoint( body, r.place.translation ) );
		stepOn( &r );
		for ( int32_t leg = 0; leg < 2 && i >= 60; ++leg )
		{
			i == 60 ? findInBody( &r, leg, 0, before[leg] ) : (void)0;
			assert_true( isPlanted( &r, leg ) );
			// Its plane is read anew as it tilts.
			assert_true( findDrift( &r, leg, 0, before[leg] ) < 1e-3f );
		}
	}
	finish( &r );
}

static void eachFootRidesOnItsOwnBody( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	testBendKnees( r.run.pose, 0.9f );
	r.pieceCount = 2;
	soleVec3 before[2][2] = { 0 };
	for ( int32_t i = 0; i < 660; ++i )
	{
		// Left on a square that goes up and down and to and fro, right on one that turns.
		float t = (float)i / 60.0f;
		r.pieces[0].transform = yawed( 0.0f, soleVec( 2.0f, 0.03f * sinf( t ), 0.05f * sinf( 0.8f * t ) ) );
		r.pieces[1].transform = yawed( 0.02f * sinf( t ), soleVec( -2.0f, 0.03f * sinf( 1.3f * t ), 0.0f ) );
		stepOn( &r );
		for ( int32_t leg = 0; leg < 2 && i >= 60; ++leg )
		{
			i == 60 ? findInBody( &r, leg, leg, before[leg] ) : (void)0;
			assert_true( isPlanted( &r, leg ) );
			assert_true( findDrift( &r, leg, leg, before[leg] ) < 1e-4f );
		}
	}
	finish( &r );
}

static void aFastLiftTakesTheBodyAlong( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	for ( int32_t i = 0; i < 120; ++i )
	{
		// Faster than the pelvis may move by itself.
		r.pieces[0].transform.translation.y = 3.0f * (float)i / 60.0f;
		ride( &r );
		assert_true( i < 10 || ( isPlanted( &r, 0 ) && isPlanted( &r, 1 ) ) );
		assert_float_equal( r.run.out.pelvisOffset_w.y, 0.0f, 1e-3f );
		assert_true( testLargestTurn( r.run.placed, r.run.pose ) < 2e-3f );
	}
	finish( &r );
}

static void aBodyThatIsNotListedCarriesByItsVelocity( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	r.listed = false;
	r.pieces[0].velocity_w = soleVec( 0.3f, 0.1f, 0.9f );
	soleVec3 before[2][2] = { 0 };
	for ( int32_t i = 0; i < 660; ++i )
	{
		r.pieces[0].transform.translation = soleScale( (float)i / 60.0f, r.pieces[0].velocity_w );
		// Near the origin, where numbers are fine enough for a sum of so many steps.
		r.pieces[0].transform.translation =
		    soleAdd( r.pieces[0].transform.translation, soleVec( -1.5f, -0.5f, -4.5f ) );
		ride( &r );
		for ( int32_t leg = 0; leg < 2 && i >= 60; ++leg )
		{
			i == 60 ? findInBody( &r, leg, 0, before[leg] ) : (void)0;
			assert_true( isPlanted( &r, leg ) );
			assert_true( findDrift( &r, leg, 0, before[leg] ) < 1e-3f );
			assert_float_equal( soleLength( r.run.out.pelvisOffset_w ), 0.0f, 1e-3f );
		}
	}
	finish( &r );
}

static void aFootIsCarriedAwayFromARootThatStays( void** state )
{
	(void)state;
	static Rider r;
	for ( int32_t listed = 0; listed < 2; ++listed )
	{
		start( &r );
		r.listed = listed == 1;
		r.run.settings.contact.replantAfter = 60.0f;
		r.pieces[0].velocity_w = soleVec( 0.0f, 0.0f, 0.1f );
		float furthest = 0.0f;
		int32_t released = 0;
		for ( int32_t i = 0; i < 240; ++i )
		{
			r.pieces[0].transform.translation = soleScale( (float)i / 60.0f, r.pieces[0].velocity_w );
			stepOn( &r );
			float off = testPlacedJoint( &r.run, biped_ankleL ).translation.z -
			    testAnimatedJoint( &r.run, biped_ankleL ).translation.z;
			furthest = fmaxf( furthest, off );
			released += ( r.run.out.legs[0].flags & sole_legReleased ) != 0;
			// Held since it has been still for 33 ms.
			assert_true( i < 10 || i > 100 || fabsf( off - 0.1f * ( (float)i / 60.0f - 0.033f ) ) < 5e-3f );
		}
		// Until its lock is strained: then it comes back.
		assert_true( released > 0 );
		assert_float_equal( furthest, r.run.settings.contact.lockDistance * 0.9f, 0.02f );
		finish( &r );
	}
}

static void aBodyThatVanishesLetsGo( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	int32_t i = 0;
	for ( ; i < 60; ++i )
	{
		r.pieces[0].transform = onItsWay( (float)i / 60.0f );
		ride( &r );
	}
	assert_true( isPlanted( &r, 0 ) && isPlanted( &r, 1 ) );
	r.pieceCount = 0;
	for ( ; i < 120; ++i )
	{
		// The root goes on as if the body were there.
		r.pieces[0].transform = onItsWay( (float)i / 60.0f );
		ride( &r );
		assert_true( soleVec3_IsFinite( r.run.out.pelvisTranslation_l ) );
	}
	assert_true( isPlanted( &r, 0 ) == false && isPlanted( &r, 1 ) == false );
	assert_true( ( r.run.out.legs[0].flags & sole_legNoGround ) != 0 );
	assert_true( testLargestTurn( r.run.placed, r.run.pose ) < 1e-3f );
	finish( &r );
}

static void aBodyThatIsTakenFromTheListCarriesNoMore( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	r.place.translation = soleVec( 0.0f, 0.0f, 0.5f );
	for ( int32_t i = 0; i < 60; ++i )
	{
		ride( &r );
	}
	soleVec3 before = testPlacedJoint( &r.run, biped_ankleL ).translation;
	r.listed = false;
	for ( int32_t i = 0; i < 30; ++i )
	{
		// It moves by 5 cm, but tells neither its place nor its velocity.
		r.pieces[0].transform.translation.x += 0.05f / 30.0f;
		stepOn( &r );
	}
	testNear3( testPlacedJoint( &r.run, biped_ankleL ).translation, before, 1e-4f );
	// Listed again it carries from where it is now.
	r.listed = true;
	stepOn( &r );
	testNear3( testPlacedJoint( &r.run, biped_ankleL ).translation, before, 1e-4f );
	for ( int32_t i = 0; i < 30; ++i )
	{
		r.pieces[0].transform.translation.x -= 0.05f / 30.0f;
		stepOn( &r );
	}
	before.x -= 0.05f;
	testNear3( testPlacedJoint( &r.run, biped_ankleL ).translation, before, 1e-4f );
	finish( &r );
}

static void aBodyAtRestChangesNoBit( void** state )
{
	(void)state;
	static Rider r, plain;
	for ( int32_t walk = 0; walk < 2; ++walk )
	{
		start( &r );
		start( &plain );
		plain.listed = false;
		soleTransform place = yawed( 0.7f, soleVec( 0.3f, 0.11f, -0.2f ) );
		r.pieces[0].transform = place;
		plain.pieces[0].transform = place;
		for ( int32_t i = 0; i < 120; ++i )
		{
			soleVec3 root = soleVec( 0.02f, 0.1f, walk == 1 ? 0.004f * (float)i : 0.0f );
			r.run.frame.root.translation = root;
			plain.run.frame.root.translation = root;
			stepOn( &r );
			stepOn( &plain );
			assert_memory_equal( r.run.placed, plain.run.placed, sizeof plain.run.placed );
		}
		finish( &r );
		finish( &plain );
	}
}

static void whatIsNotFiniteIsNoBody( void** state )
{
	(void)state;
	static Rider r;
	start( &r );
	for ( int32_t i = 0; i < 60; ++i )
	{
		ride( &r );
	}
	const float wild[] = { NAN, INFINITY, -INFINITY, 1e30f };
	for ( int32_t i = 0; i < 40; ++i )
	{
		// The casts still find it, the list is broken.
		r.pieces[0].transform.translation = soleVec( 0.0f, 0.0f, 0.0f );
		static soleSupport broken;
		broken = ( soleSupport ){ 0, r.pieces[0].transform };
		float* numbers[] = { &broken.transform.translation.x, &broken.transform.rotation.w };
		*numbers[i % 2] = wild[i / 2 % 4];
		r.listed = false;
		stepOn( &r );
		r.run.frame.supports = &broken;
		r.run.frame.supportCount = 1;
		soleHit none = { 0 };
		soleSolve( r.run.biped.rig, &r.run.settings, &r.run.state, &r.run.frame, &none, 0, &r.run.out );
		assert_true( soleVec3_IsFinite( r.run.out.pelvisTranslation_l ) );
		assert_true( soleQuat_IsFinite( r.run.out.legs[0].rotations_l[0] ) );
	}
	r.listed = true;
	for ( int32_t i = 0; i < 120; ++i )
	{
		ride( &r );
	}
	assert_true( testLargestTurn( r.run.placed, r.run.pose ) < 1e-3f );
	finish( &r );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aFootRidesOnABodyThatMovesAndTurns ),
		cmocka_unit_test( aFootRidesOnABodyThatTilts ),
		cmocka_unit_test( eachFootRidesOnItsOwnBody ),
		cmocka_unit_test( aFastLiftTakesTheBodyAlong ),
		cmocka_unit_test( aBodyThatIsNotListedCarriesByItsVelocity ),
		cmocka_unit_test( aFootIsCarriedAwayFromARootThatStays ),
		cmocka_unit_test( aBodyThatVanishesLetsGo ),
		cmocka_unit_test( aBodyThatIsTakenFromTheListCarriesNoMore ),
		cmocka_unit_test( aBodyAtRestChangesNoBit ),
		cmocka_unit_test( whatIsNotFiniteIsNoBody ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
