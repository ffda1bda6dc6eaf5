// SPDX-License-Identifier: MIT
// The whole pipeline from outside: what comes out, by forward kinematics, for grounds that are known exactly.
#include "placing.h"

/// The same local pose: translations within a tolerance, rotations within 1e-6 of the cosine of half their angle.
static void nearPose( const soleTransform* a, const soleTransform* b, float tolerance )
{
	for ( int j = 0; j < biped_count; ++j )
	{
		testNear3( a[j].translation, b[j].translation, tolerance );
		assert_true( fabsf( soleDotQuat( a[j].rotation, b[j].rotation ) ) > 1.0f - 1e-6f );
	}
}

/// Stands for a second and gives the pose.
static soleOutput stand( const testBiped* biped, const soleTransform* pose, soleTransform root,
    const testGround* ground, soleTransform* placed )
{
	soleSettings settings = soleDefaultSettings();
	soleState state = soleDefaultState( biped->rig );
	soleFrame frame = testFrame( pose );
	frame.root = root;
	frame.up = soleRotate( ground->turn, soleVec( 0.0f, 1.0f, 0.0f ) );
	static soleOutput out;
	for ( int i = 0; i < 60; ++i )
	{
		testStep( biped, &settings, &state, &frame, ground, &out );
	}
	memcpy( placed, pose, sizeof( soleTransform ) * biped_count );
	soleApply( biped->rig, &out, placed );
	return out;
}

static float solePointHeight( const testBiped* biped, const soleTransform* pose, soleTransform root, int leg,
    soleVec3 bindPoint, const testGround* ground )
{
	int32_t joint = soleRig_GetFootJoint( biped->rig, leg, false );
	soleVec3 local = soleRig_ToFootSpace( biped->rig, leg, bindPoint, false );
	soleVec3 p = soleTransformPoint( testJoint( biped, pose, root, joint ), local );
	soleVec3 up = soleScale( 1.0f / ground->scale, soleInvRotate( ground->turn, p ) );
	return ( up.y - testGroundHeight( ground, up.x, up.z ) ) /
	    sqrtf( 1.0f + ground->slopeX * ground->slopeX + ground->slopeZ * ground->slopeZ );
}

static void flatGroundChangesNothing( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	for ( int k = 0; k < 10; ++k )
	{
		testBendKnees( pose, 0.05f + 0.15f * (float)k );
		soleOutput out = stand( &biped, pose, soleTransform_Identity(), &testFlatGround, placed );
		nearPose( placed, pose, 1e-5f );
		assert_true( ( out.legs[0].flags & sole_legPlanted ) != 0 );
	}
	soleDestroyRig( biped.rig );
}

static void bothSolesLieOnEverySlope( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testBendKnees( pose, 0.5f );
	const float slopes[][2] = { { 0.0f, 0.18f }, { 0.0f, 0.36f }, { 0.0f, -0.36f }, { 0.2f, 0.0f }, { -0.2f, 0.1f } };
	for ( int k = 0; k < 5; ++k )
	{
		testGround ground = testFlatGround;
		ground.slopeX = slopes[k][0];
		ground.slopeZ = slopes[k][1];
		stand( &biped, pose, soleTransform_Identity(), &ground, placed );
		for ( int leg = 0; leg < 2; ++leg )
		{
			soleSolePoints sole = soleRig_GetLeg( biped.rig, leg ).sole;
			const soleVec3 points[] = { sole.heel, sole.ball, sole.toe, sole.inner, sole.outer };
			for ( int p = 0; p < 5; ++p )
			{
				float height = solePointHeight( &biped, placed, soleTransform_Identity(), leg, points[p], &ground );
				assert_float_equal( height, 0.0f, 5e-4f );
			}
		}
	}
	soleDestroyRig( biped.rig );
}

static void oneFootOnAStepLowersThePelvisAndReachesBoth( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testGround ground = testFlatGround;
	ground.stepX = 0.15f;
	soleTransform root = soleTransform_Identity();
	root.translation.y = 0.15f; // a capsule rests on the higher level
	soleOutput out = stand( &biped, pose, root, &ground, placed );
	assert_true( out.pelvisOffset_w.y < -0.09f && out.pelvisOffset_w.y > -0.16f );
	for ( int leg = 0; leg < 2; ++leg )
	{
		soleVec3 ball = soleRig_GetLeg( biped.rig, leg ).sole.ball;
		assert_float_equal( solePointHeight( &biped, placed, root, leg, ball, &ground ), 0.0f, 1e-3f );
		assert_true( out.legs[leg].extension <= 0.9951f );
	}
	soleDestroyRig( biped.rig );
}

static void turnedWorldsGiveTheTurnedPose( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count], turned[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testBendKnees( pose, 0.5f );
	testGround ground = testFlatGround;
	ground.slopeZ = 0.3f;
	ground.slopeX = 0.1f;
	stand( &biped, pose, soleTransform_Identity(), &ground, placed );
	uint32_t seed = 11;
	for ( int k = 0; k < 30; ++k )
	{
		// The first 24 are all turns of the axes onto themselves, the rest are any.
		static const soleQuat axes[24] = { { 0, 0, 0, 1 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 },
			{ .5f, .5f, .5f, .5f }, { -.5f, .5f, .5f, .5f }, { .5f, -.5f, .5f, .5f }, { .5f, .5f, -.5f, .5f },
			{ .5f, .5f, .5f, -.5f }, { -.5f, -.5f, .5f, .5f }, { -.5f, .5f, -.5f, .5f }, { .5f, -.5f, -.5f, .5f },
			{ .7071068f, 0, 0, .7071068f }, { -.7071068f, 0, 0, .7071068f }, { 0, .7071068f, 0, .7071068f },
			{ 0, -.7071068f, 0, .7071068f }, { 0, 0, .7071068f, .7071068f }, { 0, 0, -.7071068f, .7071068f },
			{ .7071068f, .7071068f, 0, 0 }, { .7071068f, -.7071068f, 0, 0 }, { .7071068f, 0, .7071068f, 0 },
			{ .7071068f, 0, -.7071068f, 0 }, { 0, .7071068f, .7071068f, 0 }, { 0, .7071068f, -.7071068f, 0 } };
		soleQuat q = k < 24
		    ? soleNormalizeQuat( axes[k] )
		    : soleNormalizeQuat( ( soleQuat ){ testRandomFloat( &seed, -1.0f, 1.0f ),
		          testRandomFloat( &seed, -1.0f, 1.0f ), testRandomFloat( &seed, -1.0f, 1.0f ), 0.2f } );
		ground.turn = q;
		soleTransform root = soleTransform_Identity();
		root.rotation = q;
		stand( &biped, pose, root, &ground, turned );
		nearPose( turned, placed, 2e-5f );
	}
	soleDestroyRig( biped.rig );
}

static void scaledWorldsGiveTheSamePose( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count], scaled[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testGround ground = testFlatGround;
	ground.slopeZ = 0.3f;
	ground.stepX = 0.1f;
	stand( &biped, pose, soleTransform_Identity(), &ground, placed );
	const float scales[] = { 0.01f, 0.5f, 2.0f, 100.0f };
	for ( int k = 0; k < 4; ++k )
	{
		ground.scale = scales[k];
		soleTransform root = soleTransform_Identity();
		root.scale = soleVec( scales[k], scales[k], scales[k] );
		stand( &biped, pose, root, &ground, scaled );
		nearPose( scaled, placed, 2e-4f );
	}
	soleDestroyRig( biped.rig );
}

static void mirroredGroundGivesTheMirroredPose( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count], mirrored[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testGround ground = testFlatGround;
	ground.slopeX = 0.25f;
	ground.slopeZ = 0.1f;
	stand( &biped, pose, soleTransform_Identity(), &ground, placed );
	ground.slopeX = -0.25f;
	stand( &biped, pose, soleTransform_Identity(), &ground, mirrored );
	const int twins[][2] = { { biped_hipL, biped_hipR }, { biped_kneeL, biped_kneeR }, { biped_ankleL, biped_ankleR },
		{ biped_toeL, biped_toeR } };
	for ( int k = 0; k < 4; ++k )
	{
		soleQuat a = placed[twins[k][0]].rotation;
		soleQuat b = mirrored[twins[k][1]].rotation;
		soleQuat reflected = { b.x, -b.y, -b.z, b.w };
		assert_true( fabsf( soleDotQuat( a, reflected ) ) > 1.0f - 1e-6f );
	}
	soleDestroyRig( biped.rig );
}

static void weightZeroAndNoGroundLeaveThePose( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	for ( int k = 0; k < 2; ++k )
	{
		soleState memory = soleDefaultState( biped.rig );
		soleFrame frame = testFrame( biped.bindPose );
		testGround ground = testFlatGround;
		ground.slopeZ = 0.3f;
		ground.hole = k == 0 ? 1e9f : -1e9f;
		frame.weight = k == 0 ? 0.0f : 1.0f;
		soleOutput out;
		for ( int i = 0; i < 60; ++i )
		{
			testStep( &biped, &settings, &memory, &frame, &ground, &out );
		}
		soleTransform placed[biped_count];
		memcpy( placed, biped.bindPose, sizeof placed );
		soleApply( biped.rig, &out, placed );
		nearPose( placed, biped.bindPose, 1e-5f );
		assert_int_equal( ( out.legs[0].flags & sole_legNoGround ) != 0, k == 1 );
	}
	soleDestroyRig( biped.rig );
}

static void whateverComesInFiniteGoesOut( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	uint32_t seed = 21;
	soleState memory = soleDefaultState( biped.rig );
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	for ( int k = 0; k < 100000; ++k )
	{
		soleTransform pose[biped_count];
		memcpy( pose, biped.bindPose, sizeof pose );
		const float wild[] = { NAN, INFINITY, -INFINITY, 0.0f, 1e30f, -1e30f, 1e-30f, 3.0f };
		soleFrame frame = testFrame( pose );
		float* numbers[] = { &pose[testRandom( &seed ) % biped_count].translation.x,
			&pose[testRandom( &seed ) % biped_count].rotation.w, &pose[testRandom( &seed ) % biped_count].scale.y,
			&frame.root.translation.y, &frame.root.rotation.x, &frame.up.y, &frame.timeStep, &frame.weight,
			&frame.clipFloor, &frame.root.scale.x };
		*numbers[testRandom( &seed ) % 10] = wild[testRandom( &seed ) % 8];
		int32_t n = soleGatherProbes( biped.rig, &settings, &memory, &frame, probes, SOLE_MAX_PROBES );
		for ( int32_t i = 0; i < n; ++i )
		{
			testCastAt( &testFlatGround, probes + i, hits + i );
			if ( testRandom( &seed ) % 4 == 0 )
			{
				float* place[] = { &hits[i].point_w.y, &hits[i].normal_w.y, &hits[i].normal_w.x, &hits[i].asked_w.z };
				*place[testRandom( &seed ) % 4] = wild[testRandom( &seed ) % 8];
			}
		}
		soleOutput out;
		soleSolve( biped.rig, &settings, &memory, &frame, hits, n, &out );
		assert_true(
		    soleVec3_IsFinite( out.pelvisTranslation_l ) || !soleVec3_IsFinite( pose[biped_pelvis].translation ) );
		for ( int leg = 0; leg < 2; ++leg )
		{
			for ( int j = 0; j < 3; ++j )
			{
				assert_true( soleQuat_IsFinite( out.legs[leg].rotations_l[j] ) );
			}
			assert_true( soleQuat_IsFinite( out.legs[leg].toeRotation_l ) );
			assert_true( soleIsFinite( out.legs[leg].error ) && soleVec3_IsFinite( out.legs[leg].ankle_w ) );
		}
	}
	// And it recovers: the next good frames are as good as ever.
	soleTransform placed[biped_count];
	stand( &biped, biped.bindPose, soleTransform_Identity(), &testFlatGround, placed );
	testNear3( placed[biped_pelvis].translation, biped.bindPose[biped_pelvis].translation, 1e-5f );
	soleDestroyRig( biped.rig );
}

static void standingIsStillToTheBit( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	soleState memory = soleDefaultState( biped.rig );
	testGround ground = testFlatGround;
	ground.slopeZ = 0.3f;
	ground.stepX = 0.12f;
	soleFrame frame = testFrame( biped.bindPose );
	soleOutput out, last;
	for ( int i = 0; i < 240; ++i )
	{
		testStep( &biped, &settings, &memory, &frame, &ground, &out );
		if ( i > 120 )
		{
			for ( int leg = 0; leg < 2; ++leg )
			{
				assert_memory_equal( out.legs[leg].rotations_l, last.legs[leg].rotations_l, sizeof( soleQuat ) * 3 );
			}
			assert_memory_equal( &out.pelvisTranslation_l, &last.pelvisTranslation_l, sizeof( soleVec3 ) );
		}
		last = out;
	}
	soleDestroyRig( biped.rig );
}

static void copiedStatesGiveTheSameBits( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	soleState memory = soleDefaultState( biped.rig );
	testGround ground = testFlatGround;
	ground.slopeZ = 0.2f;
	soleTransform pose[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	soleFrame frame = testFrame( pose );
	soleOutput first[40], second[40];
	soleState saved;
	memset( first, 0, sizeof first );
	memset( second, 0, sizeof second );
	for ( int run = 0; run < 2; ++run )
	{
		for ( int i = run == 0 ? 0 : 20; i < 40; ++i )
		{
			if ( i == 20 )
			{
				size_t used = soleState_GetByteCount( biped.rig );
				run == 0 ? memcpy( &saved, &memory, used ) : memcpy( &memory, &saved, used );
			}
			testBendKnees( pose, 0.3f + 0.02f * (float)i );
			frame.root.translation.z = 0.02f * (float)i;
			testStep( &biped, &settings, &memory, &frame, &ground, run == 0 ? first + i : second + i );
		}
	}
	for ( int i = 20; i < 40; ++i )
	{
		assert_memory_equal( first[i].legs[0].rotations_l, second[i].legs[0].rotations_l, sizeof( soleQuat ) * 3 );
		assert_memory_equal( first[i].legs[1].rotations_l, second[i].legs[1].rotations_l, sizeof( soleQuat ) * 3 );
		assert_memory_equal( &first[i].pelvisOffset_w, &second[i].pelvisOffset_w, sizeof( soleVec3 ) );
	}
	soleDestroyRig( biped.rig );
}

static void noTimeChangesNothing( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	soleState memory = soleDefaultState( biped.rig );
	soleFrame frame = testFrame( biped.bindPose );
	soleOutput out, still;
	testStep( &biped, &settings, &memory, &frame, &testFlatGround, &out );
	frame.timeStep = 0.0f;
	for ( int i = 0; i < 10; ++i )
	{
		testStep( &biped, &settings, &memory, &frame, &testFlatGround, &still );
		assert_memory_equal( out.legs[0].rotations_l, still.legs[0].rotations_l, sizeof( soleQuat ) * 3 );
	}
	frame.timeStep = 1.0f;
	testStep( &biped, &settings, &memory, &frame, &testFlatGround, &still );
	assert_memory_equal( out.legs[0].rotations_l, still.legs[0].rotations_l, sizeof( soleQuat ) * 3 );
	soleDestroyRig( biped.rig );
}

static void movingTheWorldsOriginMovesNothing( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	soleOutput plain, shifted;
	soleState memory[2] = { soleDefaultState( biped.rig ), soleDefaultState( biped.rig ) };
	for ( int i = 0; i < 60; ++i )
	{
		soleFrame frame = testFrame( biped.bindPose );
		frame.root.translation.x = 0.002f * (float)i;
		testStep( &biped, &settings, memory, &frame, &testFlatGround, &plain );
		// The same place, told from an origin that jumps by a kilometre halfway.
		double origin = i < 30 ? 0.0 : 1024.0;
		frame.worldOrigin[0] = origin;
		frame.root.translation.x = (float)( 0.002 * i - origin );
		testStep( &biped, &settings, memory + 1, &frame, &testFlatGround, &shifted );
		for ( int leg = 0; leg < 2; ++leg )
		{
			assert_true( fabsf( soleDotQuat( plain.legs[leg].rotations_l[0], shifted.legs[leg].rotations_l[0] ) ) >
			    1.0f - 1e-6f );
			assert_int_equal( plain.legs[leg].flags & sole_legPlanted, shifted.legs[leg].flags & sole_legPlanted );
		}
	}
	soleDestroyRig( biped.rig );
}

static void aTeleportForgetsEverything( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSettings settings = soleDefaultSettings();
	testGround ground = testFlatGround;
	ground.slopeZ = 0.25f;
	ground.stepX = 0.1f;
	for ( int way = 0; way < 3; ++way )
	{
		soleState memory = soleDefaultState( biped.rig );
		soleState fresh = soleDefaultState( biped.rig );
		soleFrame frame = testFrame( biped.bindPose );
		soleOutput out, first;
		memset( &out, 0, sizeof out );
		memset( &first, 0, sizeof first );
		for ( int i = 0; i < 60; ++i )
		{
			frame.root.translation.z = 0.003f * (float)i;
			testStep( &biped, &settings, &memory, &frame, &ground, &out );
		}
		frame.root.translation = soleVec( 0.3f, 0.1f, way == 2 ? 12.0f : 0.4f );
		frame.teleport = way == 0;
		way == 1 ? soleState_Reset( &memory ) : (void)0;
		testStep( &biped, &settings, &memory, &frame, &ground, &out );
		testStep( &biped, &settings, &fresh, &frame, &ground, &first );
		for ( int leg = 0; leg < 2; ++leg )
		{
			assert_memory_equal( out.legs[leg].rotations_l, first.legs[leg].rotations_l, sizeof( soleQuat ) * 3 );
		}
		assert_memory_equal( &out.pelvisOffset_w, &first.pelvisOffset_w, sizeof( soleVec3 ) );
		assert_memory_equal( memory.legs, fresh.legs, sizeof( soleLegState ) * 2 );
	}
	soleDestroyRig( biped.rig );
}

static void aFootIsHeldWhereItWasWhileTheHostSaysSo( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testBendKnees( pose, 0.6f );
	soleSettings settings = soleDefaultSettings();
	soleState memory = soleDefaultState( biped.rig );
	soleFrame frame = testFrame( pose );
	// The root moves on at 0.5 m/s; the left foot is said to be down, the right one to be free.
	const soleContactInput contact[2] = { { 1.0f, 1.0f }, { 0.0f, 0.0f } };
	frame.contact = contact;
	soleOutput out;
	soleVec3 held = { 0.0f, 0.0f, 0.0f };
	soleVec3 local = soleRig_ToFootSpace( biped.rig, 0, soleRig_GetLeg( biped.rig, 0 ).sole.ball, false );
	for ( int i = 0; i < 20; ++i )
	{
		frame.root.translation.z = 0.5f * (float)i / 60.0f;
		testStep( &biped, &settings, &memory, &frame, &testFlatGround, &out );
		memcpy( placed, pose, sizeof placed );
		soleApply( biped.rig, &out, placed );
		soleVec3 ball = soleTransformPoint( testJoint( &biped, placed, frame.root, biped_ankleL ), local );
		held = i == 0 ? ball : held;
		assert_true( soleDistance( ball, held ) < 1e-4f );
		assert_true( ( out.legs[0].flags & sole_legPlanted ) != 0 && ( out.legs[1].flags & sole_legPlanted ) == 0 );
		soleVec3 other = testJoint( &biped, placed, frame.root, biped_ankleR ).translation;
		soleVec3 animated = testJoint( &biped, pose, frame.root, biped_ankleR ).translation;
		assert_true( soleDistance( other, animated ) < 2e-3f );
	}
	soleDestroyRig( biped.rig );
}

static void aFootInFlightRisesBeforeTheStepThatIsAhead( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	testBendKnees( pose, 0.6f );
	soleVec3 tip = soleRig_ToFootSpace( biped.rig, 0, soleRig_GetLeg( biped.rig, 0 ).sole.toe, false );
	float clearances[2];
	for ( int way = 0; way < 2; ++way )
	{
		soleSettings settings = soleDefaultSettings();
		settings.support.lookAhead = way == 0 ? 0.0f : 0.08f;
		soleState memory = soleDefaultState( biped.rig );
		testGround ground = testFlatGround;
		ground.stepX = 0.15f; // the character goes sideways here: its step is across its way
		soleFrame frame = testFrame( pose );
		frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 1.5707963f ); // faces +X
		const soleContactInput contact[2] = { { 0.0f, 0.0f }, { 1.0f, 1.0f } };
		frame.contact = contact;
		soleOutput out;
		clearances[way] = 1.0f;
		for ( int i = 0; i < 30; ++i )
		{
			// The left foot flies at 2 m/s, 3 cm over the floor.
			frame.clipFloor = -0.03f;
			frame.root.translation = soleVec( -0.8f + 2.0f * (float)i / 60.0f, 0.03f, 0.0f );
			testStep( &biped, &settings, &memory, &frame, &ground, &out );
			memcpy( placed, pose, sizeof placed );
			soleApply( biped.rig, &out, placed );
			soleVec3 p = soleTransformPoint( testJoint( &biped, placed, frame.root, biped_ankleL ), tip );
			clearances[way] = p.x > 0.0f ? fminf( clearances[way], p.y - 0.15f ) : clearances[way];
		}
	}
	// Without a look ahead the toes are well inside the step when they meet it.
	assert_true( clearances[0] < -0.05f );
	assert_true( clearances[1] > 0.3f * clearances[0] );
	soleDestroyRig( biped.rig );
}

/// Largest turn of any leg joint between two placed poses, as 1 - |cos| of its half.
static float largestTurn( const soleTransform* a, const soleTransform* b )
{
	float largest = 0.0f;
	for ( int j = biped_hipL; j < biped_count; ++j )
	{
		largest = fmaxf( largest, 1.0f - fabsf( soleDotQuat( a[j].rotation, b[j].rotation ) ) );
	}
	return largest;
}

static void settledPoseIsContinuousInTheGround( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleTransform pose[biped_count], placed[biped_count], last[biped_count];
	memcpy( pose, biped.bindPose, sizeof pose );
	for ( int bend = 0; bend < 3; ++bend )
	{
		testBendKnees( pose, 0.3f + 0.3f * (float)bend ); // nearly straight legs bend fast by geometry
		for ( int sweep = 0; sweep < 3; ++sweep )
		{
			for ( int i = 0; i <= 200; ++i )
			{
				float x = -1.0f + 0.01f * (float)i;
				testGround ground = testFlatGround;
				ground.stepX = sweep == 0 ? 0.3f * x : 0.0f;
				ground.slopeZ = sweep == 1 ? 0.6f * x : 0.0f;
				ground.slopeX = sweep == 2 ? 0.5f * x : 0.1f;
				stand( &biped, pose, soleTransform_Identity(), &ground, placed );
				// 3 mm of step, 0.35 and 0.3 degrees of slope a time: no joint may turn by more than 2.8 degrees.
				assert_true( i == 0 || largestTurn( placed, last ) < 3e-4f );
				memcpy( last, placed, sizeof last );
			}
		}
	}
	soleDestroyRig( biped.rig );
}

static void misuseIsRefusedSafely( void** state )
{
	(void)state;
	testBiped biped;
	testMakeBiped( &biped );
	soleSetAssertHandler( testQuietHandler );
	soleSettings settings = { 0 }; // zeroed: not made by the default function
	soleState memory = { 0 };
	soleFrame frame = testFrame( biped.bindPose );
	soleOutput out, plain;
	testStep( &biped, &settings, &memory, &frame, &testFlatGround, &out );
	soleSettings good = soleDefaultSettings();
	memory = soleDefaultState( biped.rig );
	testStep( &biped, &good, &memory, &frame, &testFlatGround, &plain );
	assert_memory_equal( out.legs[0].rotations_l, plain.legs[0].rotations_l, sizeof( soleQuat ) * 3 );
	assert_int_equal( soleGatherProbes( NULL, &good, &memory, &frame, NULL, 0 ), 0 );
	soleSolve( biped.rig, &good, &memory, NULL, NULL, 0, &out );
	assert_true( ( out.legs[0].flags & sole_legBadInput ) != 0 );
	soleSolve( NULL, &good, &memory, &frame, NULL, 0, &out );
	soleApply( NULL, &out, NULL );
	soleDestroyRig( NULL );
	soleSetAssertHandler( NULL );
	soleDestroyRig( biped.rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( flatGroundChangesNothing ),
		cmocka_unit_test( bothSolesLieOnEverySlope ),
		cmocka_unit_test( oneFootOnAStepLowersThePelvisAndReachesBoth ),
		cmocka_unit_test( turnedWorldsGiveTheTurnedPose ),
		cmocka_unit_test( scaledWorldsGiveTheSamePose ),
		cmocka_unit_test( mirroredGroundGivesTheMirroredPose ),
		cmocka_unit_test( weightZeroAndNoGroundLeaveThePose ),
		cmocka_unit_test( whateverComesInFiniteGoesOut ),
		cmocka_unit_test( standingIsStillToTheBit ),
		cmocka_unit_test( copiedStatesGiveTheSameBits ),
		cmocka_unit_test( noTimeChangesNothing ),
		cmocka_unit_test( movingTheWorldsOriginMovesNothing ),
		cmocka_unit_test( aTeleportForgetsEverything ),
		cmocka_unit_test( aFootIsHeldWhereItWasWhileTheHostSaysSo ),
		cmocka_unit_test( aFootInFlightRisesBeforeTheStepThatIsAhead ),
		cmocka_unit_test( settledPoseIsContinuousInTheGround ),
		cmocka_unit_test( misuseIsRefusedSafely ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
