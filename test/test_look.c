// SPDX-License-Identifier: MIT
// Heads that look at things, against forward kinematics in double precision.
#include "limb_pose.h"

static const soleVec3 eyes_l = { 0.02f, 0.06f, 0.09f };

/// Spine, neck and head are the chain's base, twist and end: what lies between rides along.
static soleLookDef makeDef( void )
{
	soleLookDef def = soleDefaultLookDef();
	def.parents = testParents;
	def.jointCount = TEST_JOINTS;
	def.joints[0] = test_base;
	def.joints[1] = test_twist;
	def.joints[2] = test_end;
	def.lookCount = 3;
	def.shares[0] = 0.2f;
	def.shares[1] = 0.3f;
	def.shares[2] = 0.5f;
	def.forward_l = soleNormalizeOr( soleVec( 0.1f, 0.2f, 1.0f ), def.forward_l );
	def.eyes_l = eyes_l;
	return def;
}

/// The ray of sight of a pose, in double.
typedef struct testSight
{
	double eyes[3];
	double gaze[3];
} testSight;

static testSight sightOf( const soleLookDef* def, const soleTransform* pose )
{
	testSight sight;
	testPlace head = testFindPlace( pose, test_end );
	double e[3] = { head.scale * (double)def->eyes_l.x, head.scale * (double)def->eyes_l.y,
		head.scale * (double)def->eyes_l.z };
	double f[3] = { (double)def->forward_l.x, (double)def->forward_l.y, (double)def->forward_l.z };
	testTurn( head.rotation, e, sight.eyes );
	testTurn( head.rotation, f, sight.gaze );
	for ( int i = 0; i < 3; ++i )
	{
		sight.eyes[i] += head.position[i];
	}
	return sight;
}

static double angleBetween( const double* a, const double* b )
{
	double c[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
	return atan2( sqrt( c[0] * c[0] + c[1] * c[1] + c[2] * c[2] ), a[0] * b[0] + a[1] * b[1] + a[2] * b[2] );
}

/// The angle by which a sight misses a target, rad.
static double missOf( const testSight* sight, soleVec3 target )
{
	double way[3] = { (double)target.x - sight->eyes[0], (double)target.y - sight->eyes[1],
		(double)target.z - sight->eyes[2] };
	return angleBetween( sight->gaze, way );
}

static soleVec3 eyesOf( const testSight* sight )
{
	return soleVec( (float)sight->eyes[0], (float)sight->eyes[1], (float)sight->eyes[2] );
}

static soleVec3 gazeOf( const testSight* sight )
{
	return soleVec( (float)sight->gaze[0], (float)sight->gaze[1], (float)sight->gaze[2] );
}

/// A target at an angle from where the pose looks.
static soleVec3 targetAt( uint32_t* seed, const testSight* sight, float angle, float distance )
{
	soleVec3 axis =
	    soleNormalizeOr( soleCross( gazeOf( sight ), testRandomDirection( seed ) ), soleVec( 1.0f, 0.0f, 0.0f ) );
	return soleMulAdd( eyesOf( sight ), distance, soleRotate( testAbout( axis, angle ), gazeOf( sight ) ) );
}

static soleLookResult lookOn( const soleLookDef* def, soleTransform* pose, soleVec3 target, float weight )
{
	soleLookResult result = soleSolveLookAt( def, pose, target, weight );
	soleApplyLook( def, &result, pose );
	return result;
}

/// A pose as people hold their necks: each joint turned a little.
static void makePose( uint32_t* seed, soleTransform* pose )
{
	testMakePose( seed, 0.1f, pose );
	for ( int32_t i = test_base; i <= test_end; ++i )
	{
		pose[i].rotation = testAbout( testRandomDirection( seed ), testRandomFloat( seed, 0.0f, 0.4f ) );
		pose[i].translation = soleScale( 0.3f, pose[i].translation );
	}
}

// ---------------------------------------------------------------------------------------------------------- looks

static void theLineOfSightGoesThroughTheTarget( void** state )
{
	(void)state;
	uint32_t seed = 1;
	soleLookDef def = makeDef();
	double worst = 0.0;
	for ( int i = 0; i < 20000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		testSight before = sightOf( &def, pose );
		float distance = testRandomFloat( &seed, 0.35f, 8.0f );
		soleVec3 target = targetAt( &seed, &before, testRandomFloat( &seed, 0.0f, 0.8f ), distance );
		soleLookResult result = lookOn( &def, pose, target, 1.0f );
		testSight after = sightOf( &def, pose );
		worst = fmax( worst, ( result.flags & (uint32_t)sole_limbClamped ) == 0 ? missOf( &after, target ) : 0.0 );
		assert_int_equal( result.flags & ~(uint32_t)sole_limbClamped, 0 );
		assert_true( distance < 1.0f || result.flags == 0 );
		testNear3( result.eyes, eyesOf( &after ), 1e-5f );
		testNear3( result.gaze, gazeOf( &after ), 1e-5f );
	}
	print_message( "misses by %.1e rad at most\n", worst );
	assert_true( worst < 2e-5 );
}

static void theLimitHoldsHoweverFarTheTarget( void** state )
{
	(void)state;
	uint32_t seed = 2;
	soleLookDef def = makeDef();
	for ( int i = 0; i < 10000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		testSight before = sightOf( &def, pose );
		float angle = testRandomFloat( &seed, 0.0f, 3.14f );
		def.limit = testRandomFloat( &seed, 0.1f, 1.5f );
		float distance = testRandomFloat( &seed, 0.05f, 8.0f );
		soleVec3 target = targetAt( &seed, &before, angle, distance );
		soleLookResult result = lookOn( &def, pose, target, 1.0f );
		testSight after = sightOf( &def, pose );
		double turned = angleBetween( before.gaze, after.gaze );
		assert_true( turned <= (double)def.limit + 1e-4 );
		if ( angle > def.limit + 0.5f && angle < 2.6f && distance > 1.5f )
		{
			assert_true( ( result.flags & (uint32_t)sole_limbClamped ) != 0 );
			assert_true( turned > 0.7 * (double)def.limit );
		}
	}
	// The widest one lets heads look far over the shoulder.
	def.limit = 2.0f;
	for ( int i = 0; i < 2000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		testSight before = sightOf( &def, pose );
		soleVec3 target = targetAt( &seed, &before, testRandomFloat( &seed, 0.0f, 1.8f ), 4.0f );
		lookOn( &def, pose, target, 1.0f );
		testSight after = sightOf( &def, pose );
		assert_true( missOf( &after, target ) < 1e-4 );
	}
}

static void whatIsBehindIsLeftAlone( void** state )
{
	(void)state;
	uint32_t seed = 3;
	soleLookDef def = makeDef();
	for ( int i = 0; i < 500; ++i )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		makePose( &seed, pose );
		memcpy( before, pose, sizeof pose );
		testSight sight = sightOf( &def, pose );
		lookOn( &def, pose, soleMulAdd( eyesOf( &sight ), -3.0f, gazeOf( &sight ) ), 1.0f );
		for ( int32_t k = 0; k < TEST_JOINTS; ++k )
		{
			assert_true( testAngle( pose[k].rotation, before[k].rotation ) < 1e-3 );
		}
	}
}

static void jointsDoTheirShares( void** state )
{
	(void)state;
	uint32_t seed = 4;
	soleLookDef def = makeDef();
	def.eyes_l = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int i = 0; i < 2000; ++i )
	{
		// From far away the joints stand in one place, so that the parts are those of one turn.
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		makePose( &seed, pose );
		memcpy( before, pose, sizeof pose );
		testSight sight = sightOf( &def, pose );
		float angle = testRandomFloat( &seed, 0.2f, 1.1f );
		lookOn( &def, pose, targetAt( &seed, &sight, angle, 5000.0f ), 1.0f );
		static const double shares[3] = { 0.2, 0.3, 0.5 };
		for ( int32_t k = 0; k < 3; ++k )
		{
			double turned = testAngle( pose[def.joints[k]].rotation, before[def.joints[k]].rotation );
			assert_true( fabs( turned - shares[k] * (double)angle ) < 0.02 );
		}
	}
	// A joint without a share keeps its bits, wherever it is.
	for ( int32_t k = 0; k < 3; ++k )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		makePose( &seed, pose );
		memcpy( before, pose, sizeof pose );
		def = makeDef();
		def.shares[k] = 0.0f;
		testSight sight = sightOf( &def, pose );
		soleVec3 target = targetAt( &seed, &sight, 0.5f, 4.0f );
		lookOn( &def, pose, target, 1.0f );
		assert_memory_equal( pose + def.joints[k], before + def.joints[k], sizeof *pose );
		testSight after = sightOf( &def, pose );
		assert_true( missOf( &after, target ) < 2e-5 );
	}
}

static void weightsAreSharesOfTheWay( void** state )
{
	(void)state;
	uint32_t seed = 5;
	soleLookDef def = makeDef();
	for ( int i = 0; i < 2000; ++i )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		makePose( &seed, pose );
		memcpy( before, pose, sizeof pose );
		testSight sight = sightOf( &def, pose );
		soleVec3 target = targetAt( &seed, &sight, testRandomFloat( &seed, 0.3f, 1.0f ), 4.0f );
		double whole = missOf( &sight, target );
		lookOn( &def, pose, target, 0.5f );
		testSight after = sightOf( &def, pose );
		assert_true( fabs( angleBetween( sight.gaze, after.gaze ) - 0.5 * whole ) < 0.05 );
		memcpy( pose, before, sizeof pose );
		assert_int_equal( lookOn( &def, pose, target, 0.0f ).flags, 0 );
		assert_int_equal( lookOn( &def, pose, soleVec( NAN, 0.0f, 0.0f ), NAN ).flags, 0 );
		assert_memory_equal( pose, before, sizeof pose );
	}
}

// ---------------------------------------------------------------------------------------- invariance, continuity

static void placeTurnAndSizeDoNotMatter( void** state )
{
	(void)state;
	uint32_t seed = 6;
	soleLookDef def = makeDef();
	for ( int i = 0; i < 3000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		testSight sight = sightOf( &def, pose );
		float angle = testRandomFloat( &seed, 0.0f, 2.5f );
		soleVec3 target = targetAt( &seed, &sight, angle, testRandomFloat( &seed, 0.1f, 4.0f ) );
		soleLookResult here = soleSolveLookAt( &def, pose, target, 0.8f );
		float size = i % 2 == 0 ? 100.0f : 0.01f;
		soleTransform move = { soleScale( size, testRandomPoint( &seed, 1.0f ) ), testRandomTurn( &seed ),
			soleVec( size, size, size ) };
		pose[test_root] = soleMulTransform( move, pose[test_root] );
		soleLookResult there = soleSolveLookAt( &def, pose, soleTransformPoint( move, target ), 0.8f );
		for ( int32_t k = 0; k < 3; ++k )
		{
			assert_true( testAngle( here.rotations_l[k], there.rotations_l[k] ) < 1e-3 );
		}
		testNear3( soleRotate( move.rotation, here.gaze ), there.gaze, 1e-4f );
	}
}

static void leftAndRightAreAlike( void** state )
{
	(void)state;
	uint32_t seed = 10;
	soleLookDef def = makeDef();
	soleLookDef other = makeDef();
	other.forward_l = testMirrorVec( def.forward_l );
	other.eyes_l = testMirrorVec( def.eyes_l );
	for ( int i = 0; i < 3000; ++i )
	{
		soleTransform pose[TEST_JOINTS], mirrored[TEST_JOINTS];
		makePose( &seed, pose );
		testMirrorPose( pose, mirrored );
		testSight sight = sightOf( &def, pose );
		soleVec3 target = targetAt( &seed, &sight, testRandomFloat( &seed, 0.0f, 2.5f ), 2.0f );
		soleLookResult right = soleSolveLookAt( &def, pose, target, 0.8f );
		soleLookResult left = soleSolveLookAt( &other, mirrored, testMirrorVec( target ), 0.8f );
		for ( int32_t k = 0; k < 3; ++k )
		{
			assert_true( testAngle( testMirrorQuat( right.rotations_l[k] ), left.rotations_l[k] ) < 1e-3 );
		}
	}
}

static void smallStepsMakeSmallTurns( void** state )
{
	(void)state;
	uint32_t seed = 7;
	soleLookDef def = makeDef();
	double worst = 0.0;
	for ( int i = 0; i < 100; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		testSight sight = sightOf( &def, pose );
		// All the way round the head, past what is exactly behind or nearly so, near and far, with any limit.
		soleVec3 up =
		    soleNormalizeOr( soleCross( gazeOf( &sight ), testRandomDirection( &seed ) ), soleVec( 1.0f, 0.0f, 0.0f ) );
		float distance = testRandomFloat( &seed, 0.05f, 3.0f );
		float rise = i % 2 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 0.3f );
		def.limit = testRandomFloat( &seed, 0.2f, 2.0f );
		soleLookResult last = { 0 };
		for ( int k = 0; k <= 4000; ++k )
		{
			soleVec3 way = soleRotate( testAbout( up, 6.2831853f * (float)k / 4000.0f ), gazeOf( &sight ) );
			soleVec3 target = soleMulAdd( eyesOf( &sight ), distance, soleMulAdd( way, rise, up ) );
			soleLookResult result = soleSolveLookAt( &def, pose, target, 1.0f );
			for ( int32_t j = 0; j < 3 && k > 0; ++j )
			{
				worst = fmax( worst, testAngle( last.rotations_l[j], result.rotations_l[j] ) );
			}
			last = result;
		}
	}
	print_message( "largest turn in 4000 steps: %.4f rad\n", worst );
	assert_true( worst < 0.05 );
}

// ----------------------------------------------------------------------------------------------------- degenerate

static void degenerateTargetsPassThePoseThrough( void** state )
{
	(void)state;
	uint32_t seed = 8;
	soleLookDef def = makeDef();
	for ( int i = 0; i < 4; ++i )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		makePose( &seed, pose );
		soleVec3 target = soleVec( 1.0f, 2.0f, 3.0f );
		soleLookResult now = soleSolveLookAt( &def, pose, target, 0.0f );
		target = i == 0 ? now.eyes : target;
		target.x = i == 1 ? NAN : target.x;
		target.y = i == 2 ? 1e30f : target.y;
		pose[test_root].rotation.w = i == 3 ? INFINITY : pose[test_root].rotation.w;
		memcpy( before, pose, sizeof pose );
		uint32_t flags = lookOn( &def, pose, target, 1.0f ).flags;
		assert_memory_equal( pose, before, sizeof pose );
		assert_int_equal( flags, i == 1 || i == 3 ? sole_limbBadInput : sole_limbDegenerate );
	}
	// Targets in the head, eyes at the joint: no number that is none, whatever comes.
	for ( int i = 0; i < 5000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		makePose( &seed, pose );
		def.eyes_l = i % 2 == 0 ? soleVec( 0.0f, 0.0f, 0.0f ) : eyes_l;
		testPlace head = testFindPlace( pose, test_end );
		soleVec3 target =
		    soleMulAdd( testAt( &head ), testRandomFloat( &seed, 0.0f, 0.1f ), testRandomDirection( &seed ) );
		soleLookResult result = soleSolveLookAt( &def, pose, i < 10 ? testAt( &head ) : target, 1.0f );
		for ( int32_t k = 0; k < 3; ++k )
		{
			soleQuat q = result.rotations_l[k];
			assert_true( soleQuat_IsFinite( q ) && fabsf( soleDotQuat( q, q ) - 1.0f ) < 1e-4f );
		}
	}
}

static void misuseIsRefused( void** state )
{
	(void)state;
	soleSetAssertHandler( testQuietHandler );
	uint32_t seed = 9;
	soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
	makePose( &seed, pose );
	memcpy( before, pose, sizeof pose );
	soleLookDef defs[9];
	for ( int i = 0; i < 9; ++i )
	{
		defs[i] = makeDef();
	}
	defs[0] = ( soleLookDef ){ 0 };
	defs[1].parents = NULL;
	defs[2].lookCount = 0;
	defs[3].lookCount = SOLE_MAX_LOOK_JOINTS + 1;
	defs[4].joints[2] = test_root;
	defs[5].shares[1] = -0.1f;
	defs[6].shares[0] = defs[6].shares[1] = defs[6].shares[2] = 0.0f;
	defs[7].forward_l = soleVec( 0.0f, 0.0f, 0.0f );
	defs[8].limit = 2.1f;
	for ( int i = 0; i < 9; ++i )
	{
		assert_false( soleLookDef_IsValid( defs + i ) );
		assert_int_equal( lookOn( defs + i, pose, soleVec( 1.0f, 1.0f, 1.0f ), 1.0f ).flags, sole_limbBadInput );
		assert_memory_equal( pose, before, sizeof pose );
	}
	soleLookDef def = makeDef();
	assert_true( soleLookDef_IsValid( &def ) );
	assert_false( soleLookDef_IsValid( NULL ) );
	assert_int_equal( soleSolveLookAt( &def, NULL, def.eyes_l, 1.0f ).flags, sole_limbBadInput );
	soleSetAssertHandler( NULL );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theLineOfSightGoesThroughTheTarget ),
		cmocka_unit_test( theLimitHoldsHoweverFarTheTarget ),
		cmocka_unit_test( whatIsBehindIsLeftAlone ),
		cmocka_unit_test( jointsDoTheirShares ),
		cmocka_unit_test( weightsAreSharesOfTheWay ),
		cmocka_unit_test( placeTurnAndSizeDoNotMatter ),
		cmocka_unit_test( leftAndRightAreAlike ),
		cmocka_unit_test( smallStepsMakeSmallTurns ),
		cmocka_unit_test( degenerateTargetsPassThePoseThrough ),
		cmocka_unit_test( misuseIsRefused ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
