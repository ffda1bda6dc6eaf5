// SPDX-License-Identifier: MIT
// Limbs with goals and hints, against forward kinematics in double precision.
#include "limb_pose.h"

static soleLimbDef makeDef( void )
{
	soleLimbDef def = soleDefaultLimbDef();
	def.parents = testParents;
	def.jointCount = TEST_JOINTS;
	def.upper = test_upper;
	def.lower = test_lower;
	def.end = test_end;
	def.hinge_l = soleVec( 1.0f, 0.0f, 0.0f );
	return def;
}

static double bonesOf( const soleTransform* pose )
{
	testPlace a = testFindPlace( pose, test_upper ), b = testFindPlace( pose, test_lower );
	testPlace c = testFindPlace( pose, test_end );
	return testFar( a.position, b.position ) + testFar( b.position, c.position );
}

/// A goal at a share of the limb's length from its first joint.
static soleLimbGoal randomGoal( uint32_t* seed, const soleTransform* pose, float low, float high )
{
	testPlace upper = testFindPlace( pose, test_upper );
	float length = testRandomFloat( seed, low, high ) * (float)bonesOf( pose );
	return ( soleLimbGoal ){ soleMulAdd( testAt( &upper ), length, testRandomDirection( seed ) ),
		testRandomTurn( seed ), 1.0f, 1.0f };
}

static soleLimbResult solveOn(
    const soleLimbDef* def, soleTransform* pose, soleLimbGoal goal, const soleLimbHint* hint )
{
	soleLimbResult result = soleSolveLimb( def, pose, &goal, hint );
	soleApplyLimb( def, &result, pose );
	return result;
}

/// How far the middle joint is turned from where the hint would have it, rad.
static double hintError( const soleTransform* pose, soleVec3 hint )
{
	testPlace upper = testFindPlace( pose, test_upper ), lower = testFindPlace( pose, test_lower );
	testPlace end = testFindPlace( pose, test_end );
	soleVec3 first = testAt( &upper );
	soleVec3 axis = soleNormalizeOr( soleSub( testAt( &end ), first ), soleVec( 0.0f, 1.0f, 0.0f ) );
	soleVec3 a = soleReject( soleSub( testAt( &lower ), first ), axis );
	soleVec3 b = soleReject( soleSub( hint, first ), axis );
	soleVec3 c = soleCross( a, b );
	return atan2( (double)soleLength( c ), (double)soleDot( a, b ) );
}

// ---------------------------------------------------------------------------------------------------------- goals

static void goalsAreMetInPlaceTurnAndHint( void** state )
{
	(void)state;
	uint32_t seed = 1;
	soleLimbDef def = makeDef();
	double worst[3] = { 0.0, 0.0, 0.0 };
	for ( int i = 0; i < 20000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.0f, 2.2f ), pose );
		double bones = bonesOf( pose );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.4f, 0.97f );
		soleLimbHint hint = { soleMulAdd( goal.position, 1.0f, testRandomPoint( &seed, 2.0f ) ), 1.0f };
		soleLimbResult result = solveOn( &def, pose, goal, &hint );
		testPlace end = testFindPlace( pose, test_end );
		double off = testFarFrom( &end, goal.position ) / bones;
		worst[0] = fmax( worst[0], off );
		worst[1] = fmax( worst[1], testAngle( testRotationOf( &end ), goal.rotation ) );
		testPlace upper = testFindPlace( pose, test_upper );
		soleVec3 way = soleNormalizeOr( soleSub( goal.position, testAt( &upper ) ), soleVec( 0.0f, 1.0f, 0.0f ) );
		if ( (double)soleLength( soleReject( soleSub( hint.position, testAt( &upper ) ), way ) ) > 0.05 * bones )
		{
			worst[2] = fmax( worst[2], hintError( pose, hint.position ) );
		}
		assert_true( testFarFrom( &end, result.end ) < 1e-5 && (double)result.error < 1e-5 );
		assert_int_equal( result.flags & ~(uint32_t)sole_limbSoftened, 0 );
	}
	print_message( "worst place %.1e bones, turn %.1e rad, hint %.1e rad\n", worst[0], worst[1], worst[2] );
	assert_true( worst[0] < 1e-5 );
	assert_true( worst[1] < 1e-5 );
	assert_true( worst[2] < 1e-4 );
}

static void whatIsNotAskedForKeepsItsBits( void** state )
{
	(void)state;
	uint32_t seed = 2;
	soleLimbDef def = makeDef();
	for ( int i = 0; i < 2000; ++i )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.0f, 2.2f ), pose );
		memcpy( before, pose, sizeof pose );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.4f, 0.9f );
		soleLimbHint hint = { testRandomPoint( &seed, 1.0f ), 0.0f };
		goal.positionWeight = goal.rotationWeight = 0.0f;
		assert_int_equal( solveOn( &def, pose, goal, i % 2 == 0 ? &hint : NULL ).flags, 0 );
		assert_memory_equal( pose, before, sizeof pose );
		// What has no weight may be anything, and a weight that is none is none.
		goal.position.x = goal.rotation.y = hint.position.z = NAN;
		goal.positionWeight = NAN;
		goal.rotationWeight = -1.0f;
		assert_int_equal( solveOn( &def, pose, goal, &hint ).flags, 0 );
		assert_memory_equal( pose, before, sizeof pose );
		// A place alone leaves the end's own rotation, a turn alone leaves the limb.
		goal = randomGoal( &seed, pose, 0.4f, 0.9f );
		goal.rotationWeight = 0.0f;
		soleLimbResult placed = soleSolveLimb( &def, pose, &goal, NULL );
		assert_memory_equal( &placed.end_l, &before[test_end].rotation, sizeof placed.end_l );
		goal.positionWeight = 0.0f;
		goal.rotationWeight = 0.7f;
		soleLimbResult turned = soleSolveLimb( &def, pose, &goal, NULL );
		assert_memory_equal( &turned.upper_l, &before[test_upper].rotation, sizeof turned.upper_l );
		assert_memory_equal( &turned.lower_l, &before[test_lower].rotation, sizeof turned.lower_l );
	}
}

static void partsOfWeightsArePartsOfTheWay( void** state )
{
	(void)state;
	uint32_t seed = 3;
	soleLimbDef def = makeDef();
	def.softZone = 0.0f;
	for ( int i = 0; i < 2000; ++i )
	{
		soleTransform pose[TEST_JOINTS], placed[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.2f, 1.2f ), pose );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.8f, 0.95f );
		float w = testRandomFloat( &seed, 0.0f, 1.0f );
		testPlace before = testFindPlace( pose, test_end );
		soleVec3 wanted = soleLerp( testAt( &before ), goal.position, w );
		testPlace upper = testFindPlace( pose, test_upper );
		goal.positionWeight = w;
		goal.rotationWeight = 0.0f;
		memcpy( placed, pose, sizeof pose );
		solveOn( &def, placed, goal, NULL );
		testPlace end = testFindPlace( placed, test_end );
		if ( testFarFrom( &upper, wanted ) > 0.2 * bonesOf( pose ) )
		{
			assert_true( testFarFrom( &end, wanted ) < 1e-5 );
		}
		// The turn goes on from where the limb carries the end.
		soleQuat carried = testRotationOf( &end );
		double whole = testAngle( carried, goal.rotation );
		goal.rotationWeight = w;
		memcpy( placed, pose, sizeof pose );
		solveOn( &def, placed, goal, NULL );
		end = testFindPlace( placed, test_end );
		double done = testAngle( carried, testRotationOf( &end ) );
		double left = testAngle( testRotationOf( &end ), goal.rotation );
		assert_true( fabs( done + left - whole ) < 1e-4 );
		assert_true( ( w < 0.5f ) == ( done < left ) || fabs( done - left ) < 1e-3 );
	}
}

static void aGoalAtTheAnimationChangesNothing( void** state )
{
	(void)state;
	uint32_t seed = 4;
	soleLimbDef def = makeDef();
	def.fold = 0.4f;
	for ( int i = 0; i < 5000; ++i )
	{
		// From straight to folded: limits give way to what is animated.
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		testMakePose( &seed, i % 10 == 0 ? 0.0f : testRandomFloat( &seed, 0.05f, 2.8f ), pose );
		memcpy( before, pose, sizeof pose );
		testPlace end = testFindPlace( pose, test_end ), middle = testFindPlace( pose, test_lower );
		soleLimbGoal goal = { testAt( &end ), testRotationOf( &end ), 1.0f, 1.0f };
		soleLimbHint hint = { testAt( &middle ), 1.0f };
		solveOn( &def, pose, goal, &hint );
		for ( int32_t k = test_upper; k <= test_end; ++k )
		{
			// A straight limb may bend by what rounding makes of its length: the square root of an epsilon.
			assert_true( testAngle( pose[k].rotation, before[k].rotation ) < ( i % 10 == 0 ? 4e-3 : 1e-4 ) );
		}
	}
}

// --------------------------------------------------------------------------------------------------------- limits

static void limitsHoldAndAreTold( void** state )
{
	(void)state;
	uint32_t seed = 5;
	soleLimbDef def = makeDef();
	def.reach = 0.98f;
	def.fold = 0.35f;
	for ( int i = 0; i < 5000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.6f, 1.8f ), pose );
		double bones = bonesOf( pose );
		bool away = i % 2 == 0;
		soleLimbGoal goal = away ? randomGoal( &seed, pose, 0.985f, 3.0f ) : randomGoal( &seed, pose, 0.0f, 0.28f );
		soleLimbResult result = solveOn( &def, pose, goal, NULL );
		testPlace upper = testFindPlace( pose, test_upper ), end = testFindPlace( pose, test_end );
		double length = testFar( upper.position, end.position ) / bones;
		assert_true( away ? length < 0.98 + 1e-5 && length > 0.959 : fabs( length - 0.35 ) < 1e-4 );
		assert_true( ( result.flags & (uint32_t)( away ? sole_limbOutOfReach : sole_limbFolded ) ) != 0 );
		assert_true( fabs( (double)result.error - testFarFrom( &end, goal.position ) ) < 1e-5 );
	}
}

static void aStraightLimbBendsByItsHinge( void** state )
{
	(void)state;
	uint32_t seed = 6;
	soleLimbDef given = makeDef();
	for ( int i = 0; i < 2000; ++i )
	{
		soleTransform bind[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.03f, 2.0f ), bind );
		soleLimbDef def = makeDef();
		def.hinge_l = soleVec( 0.0f, 0.0f, 0.0f );
		assert_true( soleLimbDef_FindHinge( &def, bind ) );
		testNear3( def.hinge_l, given.hinge_l, 1e-4f );
		soleTransform pose[TEST_JOINTS];
		memcpy( pose, bind, sizeof bind );
		pose[test_lower].rotation = soleConjugate( pose[test_twist].rotation ); // straight
		def.hinge_l = soleVec( 0.0f, 0.0f, 1.0f );
		assert_false( soleLimbDef_FindHinge( &def, pose ) );
		testNear3( def.hinge_l, soleVec( 0.0f, 0.0f, 1.0f ), 0.0f );
		def.hinge_l = given.hinge_l;
		solveOn( &def, pose, randomGoal( &seed, pose, 0.5f, 0.9f ), NULL );
		testPlace a = testFindPlace( pose, test_upper ), b = testFindPlace( pose, test_lower );
		testPlace c = testFindPlace( pose, test_end );
		soleVec3 bend = soleCross( soleSub( testAt( &b ), testAt( &a ) ), soleSub( testAt( &c ), testAt( &b ) ) );
		assert_true( soleDot( bend, soleRotate( testRotationOf( &a ), given.hinge_l ) ) > 0.0f );
	}
}

// ---------------------------------------------------------------------------------------------------- invariances

/// The same limb elsewhere, turned and of another size, gets the same rotations.
static void placeTurnAndSizeDoNotMatter( void** state )
{
	(void)state;
	uint32_t seed = 7;
	soleLimbDef def = makeDef();
	for ( int i = 0; i < 3000; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.1f, 2.0f ), pose );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.4f, 0.96f );
		soleLimbHint hint = { testRandomPoint( &seed, 2.0f ), testRandomFloat( &seed, 0.0f, 1.0f ) };
		goal.positionWeight = testRandomFloat( &seed, 0.5f, 1.0f );
		goal.rotationWeight = testRandomFloat( &seed, 0.0f, 1.0f );
		soleLimbResult here = soleSolveLimb( &def, pose, &goal, &hint );
		float size = i % 2 == 0 ? 100.0f : 0.01f;
		soleTransform move = { soleScale( size, testRandomPoint( &seed, 1.0f ) ), testRandomTurn( &seed ),
			soleVec( size, size, size ) };
		pose[test_root] = soleMulTransform( move, pose[test_root] );
		goal.position = soleTransformPoint( move, goal.position );
		goal.rotation = soleMulQuat( move.rotation, goal.rotation );
		hint.position = soleTransformPoint( move, hint.position );
		soleLimbResult there = soleSolveLimb( &def, pose, &goal, &hint );
		assert_true( testAngle( here.lower_l, there.lower_l ) < 1e-3 );
		assert_true( testAngle( here.upper_l, there.upper_l ) < 1e-3 );
		assert_true( testAngle( here.end_l, there.end_l ) < 1e-3 );
		assert_int_equal( here.flags, there.flags );
		testNear3( soleTransformPoint( move, here.end ), there.end, 2e-5f * size );
	}
}

static void theLeftIsTheMirroredRight( void** state )
{
	(void)state;
	uint32_t seed = 8;
	soleLimbDef def = makeDef();
	def.hinge_l = soleNormalizeOr( soleVec( 1.0f, 0.1f, 0.2f ), def.hinge_l );
	soleLimbDef other = def;
	other.hinge_l = soleNeg( testMirrorVec( def.hinge_l ) ); // an axis goes with the sense of its turn
	for ( int i = 0; i < 3000; ++i )
	{
		soleTransform pose[TEST_JOINTS], mirrored[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.0f, 2.0f ), pose );
		testMirrorPose( pose, mirrored );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.4f, 0.95f );
		soleLimbHint hint = { testRandomPoint( &seed, 2.0f ), testRandomFloat( &seed, 0.0f, 1.0f ) };
		soleLimbResult right = soleSolveLimb( &def, pose, &goal, &hint );
		goal.position = testMirrorVec( goal.position );
		goal.rotation = testMirrorQuat( goal.rotation );
		hint.position = testMirrorVec( hint.position );
		soleLimbResult left = soleSolveLimb( &other, mirrored, &goal, &hint );
		assert_true( testAngle( testMirrorQuat( right.upper_l ), left.upper_l ) < 1e-3 );
		assert_true( testAngle( testMirrorQuat( right.lower_l ), left.lower_l ) < 1e-3 );
		assert_true( testAngle( testMirrorQuat( right.end_l ), left.end_l ) < 1e-3 );
	}
}

// ----------------------------------------------------------------------------------------------------- continuity

#define SWEEP 4000

/// The largest turn of a joint from one of the steps of a sweep to the next.
static double sweepOf(
    const soleLimbDef* def, const soleTransform* pose, soleLimbGoal a, soleLimbGoal b, soleLimbHint c, soleLimbHint d )
{
	double worst = 0.0;
	soleLimbResult last = { 0 };
	for ( int i = 0; i <= SWEEP; ++i )
	{
		float t = (float)i / (float)SWEEP;
		soleLimbGoal goal = { soleLerp( a.position, b.position, t ), soleNlerp( a.rotation, b.rotation, t ),
			a.positionWeight + t * ( b.positionWeight - a.positionWeight ),
			a.rotationWeight + t * ( b.rotationWeight - a.rotationWeight ) };
		soleLimbHint hint = { soleLerp( c.position, d.position, t ), c.weight + t * ( d.weight - c.weight ) };
		soleLimbResult result = soleSolveLimb( def, pose, &goal, &hint );
		if ( i > 0 )
		{
			worst = fmax( worst, testAngle( last.upper_l, result.upper_l ) );
			worst = fmax( worst, testAngle( last.lower_l, result.lower_l ) );
			worst = fmax( worst, testAngle( last.end_l, result.end_l ) );
		}
		last = result;
	}
	return worst;
}

static void smallStepsMakeSmallTurns( void** state )
{
	(void)state;
	uint32_t seed = 9;
	soleLimbDef def = makeDef();
	double worst = 0.0;
	for ( int i = 0; i < 60; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		testMakePose( &seed, testRandomFloat( &seed, 0.2f, 1.5f ), pose );
		testPlace upper = testFindPlace( pose, test_upper ), end = testFindPlace( pose, test_end );
		testPlace lower = testFindPlace( pose, test_lower );
		soleVec3 first = testAt( &upper );
		soleVec3 ahead = soleSub( testAt( &end ), first );
		soleVec3 line = soleNormalizeOr( ahead, ahead );
		soleVec3 bend = soleNormalizeOr( soleReject( soleSub( testAt( &lower ), first ), line ), line );
		soleVec3 side = soleCross( line, bend );
		// Across ahead of the limb and out of its reach; by weight alone. Half a turn of the end has two ways: not
		// here.
		soleQuat turned = soleMulQuat( testAbout( testRandomDirection( &seed ), 0.8f ), testRotationOf( &end ) );
		soleLimbGoal a = { soleMulAdd( soleMulAdd( first, 0.9f, ahead ), 0.8f, side ), turned, 1.0f, 1.0f };
		soleLimbGoal b = a;
		b.position = soleMulAdd( soleMulAdd( first, 0.9f, ahead ), -0.3f, side );
		soleLimbHint none = { first, 0.0f };
		worst = fmax( worst, sweepOf( &def, pose, a, b, none, none ) );
		soleLimbGoal weak = b;
		weak.positionWeight = weak.rotationWeight = 0.0f;
		worst = fmax( worst, sweepOf( &def, pose, weak, b, none, none ) );
		// The hint past the limb on the side where it is bent, gaining weight; and through the limb's line.
		soleLimbGoal stay = { soleMulAdd( first, 0.9f, ahead ), turned, 1.0f, 0.0f };
		soleVec3 middle = soleMulAdd( first, 0.5f, ahead );
		soleLimbHint c = { soleMulAdd( soleMulAdd( middle, 0.5f, side ), 0.3f, bend ), 0.4f };
		soleLimbHint d = { soleMulAdd( soleMulAdd( middle, -0.5f, side ), 0.3f, bend ), 1.0f };
		worst = fmax( worst, sweepOf( &def, pose, stay, stay, c, d ) );
		soleLimbHint left = { soleMulAdd( middle, 0.3f, side ), 1.0f };
		soleLimbHint right = { soleMulAdd( middle, -0.3f, side ), 1.0f };
		worst = fmax( worst, sweepOf( &def, pose, stay, stay, left, right ) );
		// Straight out from bent to beyond reach, with a hint: the limb passes through its nearly straight range.
		soleLimbGoal from = { soleMulAdd( first, 0.8f, ahead ), turned, 1.0f, 0.0f };
		soleLimbGoal to = { soleMulAdd( first, 1.8f, ahead ), turned, 1.0f, 0.0f };
		worst = fmax( worst, sweepOf( &def, pose, from, to, left, left ) );
	}
	print_message( "largest turn in %d steps: %.4f rad\n", SWEEP, worst );
	assert_true( worst < 0.05 );
}

// ----------------------------------------------------------------------------------------------------- degenerate

static bool isUsable( soleQuat q )
{
	return soleQuat_IsFinite( q ) && fabsf( soleDotQuat( q, q ) - 1.0f ) < 1e-4f;
}

static void degenerateLimbsGetUsableRotations( void** state )
{
	(void)state;
	uint32_t seed = 10;
	soleLimbDef def = makeDef();
	for ( int i = 0; i < 7; ++i )
	{
		soleTransform pose[TEST_JOINTS];
		testMakePose( &seed, i == 1 ? 0.0f : 0.8f, pose );
		testPlace upper = testFindPlace( pose, test_upper );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.5f, 0.9f );
		soleLimbHint hint = { testRandomPoint( &seed, 1.0f ), 1.0f };
		soleVec3 zero = soleVec( 0.0f, 0.0f, 0.0f );
		goal.position = i <= 1 ? testAt( &upper ) : goal.position;                   // at the shoulder
		pose[test_twist].translation = i == 2 ? zero : pose[test_twist].translation; // no upper bone
		pose[test_lower].translation = i == 2 ? zero : pose[test_lower].translation;
		pose[test_end].translation = i == 3 ? zero : pose[test_end].translation; // no lower bone
		pose[test_upper].scale = i == 4 ? zero : pose[test_upper].scale;         // nothing at all
		goal.position = i == 5 ? soleVec( 1e30f, 0.0f, 0.0f ) : goal.position;
		hint.position = i == 6 ? goal.position : hint.position; // on the line
		soleLimbResult result = soleSolveLimb( &def, pose, &goal, &hint );
		assert_true( isUsable( result.upper_l ) && isUsable( result.lower_l ) && isUsable( result.end_l ) );
		assert_true( soleVec3_IsFinite( result.end ) && soleIsFinite( result.error ) );
		assert_int_equal( ( result.flags & (uint32_t)sole_limbDegenerate ) != 0, i != 6 );
	}
	// At the shoulder the limb folds where it points, rather than going back to its animation.
	soleTransform pose[TEST_JOINTS];
	testMakePose( &seed, 0.8f, pose );
	testPlace upper = testFindPlace( pose, test_upper );
	soleLimbGoal goal = { testAt( &upper ), soleQuat_Identity(), 1.0f, 0.0f };
	double bones = bonesOf( pose );
	solveOn( &def, pose, goal, NULL );
	testPlace end = testFindPlace( pose, test_end );
	assert_true( testFar( end.position, upper.position ) < 0.4 * bones );
}

static void whatIsNoNumberIsPassedThrough( void** state )
{
	(void)state;
	uint32_t seed = 11;
	soleLimbDef def = makeDef();
	for ( int i = 0; i < 5; ++i )
	{
		soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
		testMakePose( &seed, 0.8f, pose );
		soleLimbGoal goal = randomGoal( &seed, pose, 0.5f, 0.9f );
		soleLimbHint hint = { testRandomPoint( &seed, 1.0f ), 1.0f };
		float bad = i % 2 == 0 ? NAN : INFINITY;
		goal.position.y = i == 0 ? bad : goal.position.y;
		goal.rotation.w = i == 1 ? bad : goal.rotation.w;
		hint.position.z = i == 2 ? bad : hint.position.z;
		pose[test_root].translation.x = i == 3 ? bad : pose[test_root].translation.x;
		pose[test_end].rotation.x = i == 4 ? bad : pose[test_end].rotation.x;
		memcpy( before, pose, sizeof pose );
		assert_int_equal( solveOn( &def, pose, goal, &hint ).flags, sole_limbBadInput );
		assert_memory_equal( pose, before, sizeof pose );
	}
}

static void misuseIsRefused( void** state )
{
	(void)state;
	soleSetAssertHandler( testQuietHandler );
	uint32_t seed = 12;
	soleTransform pose[TEST_JOINTS], before[TEST_JOINTS];
	testMakePose( &seed, 0.8f, pose );
	memcpy( before, pose, sizeof pose );
	soleLimbGoal goal = randomGoal( &seed, pose, 0.5f, 0.9f );
	soleLimbDef defs[8];
	for ( int i = 0; i < 8; ++i )
	{
		defs[i] = makeDef();
	}
	static const int32_t ring[TEST_JOINTS] = { 1, 2, 3, 4, 5, 6, 0 };
	defs[0] = ( soleLimbDef ){ 0 };
	defs[1].parents = NULL;
	defs[2].lower = test_upper;
	defs[3].end = TEST_JOINTS;
	defs[4].reach = 1.1f;
	defs[5].hinge_l.x = NAN;
	defs[6].upper = SOLE_NONE;
	defs[7].softZone = NAN;
	for ( int i = 0; i < 8; ++i )
	{
		assert_false( soleLimbDef_IsValid( defs + i ) );
		assert_int_equal( solveOn( defs + i, pose, goal, NULL ).flags, sole_limbBadInput );
		assert_false( soleLimbDef_FindHinge( defs + i, pose ) );
		assert_memory_equal( pose, before, sizeof pose );
	}
	soleLimbDef def = makeDef();
	assert_true( soleLimbDef_IsValid( &def ) );
	assert_false( soleLimbDef_IsValid( NULL ) );
	assert_int_equal( soleSolveLimb( &def, NULL, &goal, NULL ).flags, sole_limbBadInput );
	assert_int_equal( soleSolveLimb( &def, pose, NULL, NULL ).flags, sole_limbBadInput );
	def.parents = ring; // comes to an end
	soleLimbDef_IsValid( &def );
	soleSetAssertHandler( NULL );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( goalsAreMetInPlaceTurnAndHint ),
		cmocka_unit_test( whatIsNotAskedForKeepsItsBits ),
		cmocka_unit_test( partsOfWeightsArePartsOfTheWay ),
		cmocka_unit_test( aGoalAtTheAnimationChangesNothing ),
		cmocka_unit_test( limitsHoldAndAreTold ),
		cmocka_unit_test( aStraightLimbBendsByItsHinge ),
		cmocka_unit_test( placeTurnAndSizeDoNotMatter ),
		cmocka_unit_test( theLeftIsTheMirroredRight ),
		cmocka_unit_test( smallStepsMakeSmallTurns ),
		cmocka_unit_test( degenerateLimbsGetUsableRotations ),
		cmocka_unit_test( whatIsNoNumberIsPassedThrough ),
		cmocka_unit_test( misuseIsRefused ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
