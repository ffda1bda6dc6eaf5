// SPDX-License-Identifier: MIT
// Contact labels, clip floors and stride speeds of a gait whose contacts are known.
#include "measure_rig.h"

/// How many frames a label's change is away from when it really happens, at worst. Frames near the ends are left out.
static double worstEventError( const rigMotion* m, int32_t leg, uint8_t bit, double onPhase, double offPhase )
{
	double worst = 0.0;
	double rate = (double)m->motion.frameRate;
	for ( int32_t t = 2; t < m->motion.frameCount - 1; ++t )
	{
		bool before = ( m->labels[2 * ( t - 1 ) + leg] & bit ) != 0;
		bool now = ( m->labels[2 * t + leg] & bit ) != 0;
		if ( before == now )
		{
			continue;
		}
		// The change lies between the two frames.
		double away = gaitPhase( leg, ( t - 0.5 ) / rate ) - ( now ? onPhase : offPhase );
		away = away > 0.5 * GAIT_PERIOD ? away - GAIT_PERIOD : away;
		away = away < -0.5 * GAIT_PERIOD ? away + GAIT_PERIOD : away;
		worst = fmax( worst, fabs( away ) * rate );
	}
	return worst;
}

static int32_t countChanges( const rigMotion* m, int32_t leg, uint8_t bit )
{
	int32_t changes = 0;
	for ( int32_t t = 1; t < m->motion.frameCount; ++t )
	{
		changes += ( ( m->labels[2 * t + leg] ^ m->labels[2 * ( t - 1 ) + leg] ) & bit ) != 0;
	}
	return changes;
}

static void label( rigMotion* m )
{
	soleLabelDef def = soleDefaultLabelDef();
	assert_int_equal( soleLabelContacts( &m->motion, &def, NULL, m->labels ), sole_success );
}

static void contactsAreFoundWithinAFrameAtEveryRate( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	float rates[3] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t i = 0; i < 3; ++i )
	{
		rigMotion m = rigMakeMotion( rig, (int32_t)( 4.0f * rates[i] ), rates[i] );
		gaitFill( &m, 1.3, 0.0f, false );
		label( &m );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			assert_int_equal( countChanges( &m, leg, sole_labelHeel ), 8 );
			assert_int_equal( countChanges( &m, leg, sole_labelToe ), 8 );
			assert_true( worstEventError( &m, leg, sole_labelHeel, 0.0, GAIT_HEEL_OFF ) <= 1.5 );
			assert_true( worstEventError( &m, leg, sole_labelToe, 0.0, GAIT_TOE_OFF ) <= 1.5 );
		}
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void aFloorThatIsNotAtTheOriginIsFound( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	float floors[3] = { 0.0f, 0.031f, -0.12f };
	for ( int32_t i = 0; i < 6; ++i )
	{
		rigMotion m = rigMakeMotion( rig, 120, 60.0f );
		gaitFill( &m, 1.3, floors[i % 3], i >= 3 );
		assert_float_equal( soleFindClipFloor( &m.motion ), floors[i % 3], 1e-5f );
		if ( i < 3 )
		{
			m.motion.clipFloor = soleFindClipFloor( &m.motion );
			label( &m );
			assert_true( worstEventError( &m, 0, sole_labelToe, 0.0, GAIT_TOE_OFF ) <= 1.5 );
			assert_int_equal( countChanges( &m, 0, sole_labelToe ), 4 );
		}
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void strideSpeedOfInPlaceClipsIsFound( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	double speeds[4] = { 0.6, 1.4, 3.0, -1.0 };
	for ( int32_t i = 0; i < 4; ++i )
	{
		rigMotion m = rigMakeMotion( rig, 60, 60.0f );
		gaitFill( &m, speeds[i], 0.02f, true );
		soleVec3 v = soleFindStrideVelocity( &m.motion );
		testNear3( v, soleVec( 0.0f, 0.0f, (float)speeds[i] ), 0.01f );
		// With that speed in the roots the clip has the same contacts as one that travels by itself.
		for ( int32_t t = 0; t < 60; ++t )
		{
			m.roots[t].translation = soleScale( (float)t / 60.0f, v );
		}
		m.motion.clipFloor = 0.02f;
		label( &m );
		assert_true( worstEventError( &m, 1, sole_labelToe, 0.0, GAIT_TOE_OFF ) <= 1.5 );
		rigFreeMotion( &m );
	}
	soleDestroyRig( rig );
}

static void legsOfDifferentPaceShareTheStride( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion left = rigMakeMotion( rig, 60, 60.0f );
	rigMotion right = rigMakeMotion( rig, 60, 60.0f );
	gaitFill( &left, 1.0, 0.0f, true );
	gaitFill( &right, 1.1, 0.0f, true );
	for ( int32_t t = 0; t < 60; ++t )
	{
		memcpy( rigPose( &left, t ) + 5, rigPose( &right, t ) + 5, 4 * sizeof( soleTransform ) );
	}
	testNear3( soleFindStrideVelocity( &left.motion ), soleVec( 0.0f, 0.0f, 1.05f ), 0.005f );
	rigFreeMotion( &left );
	rigFreeMotion( &right );
	soleDestroyRig( rig );
}

static void aClipThatStandsHasNoStrideAndIsAllContact( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 90, 30.0f );
	for ( int32_t t = 0; t < 90; ++t )
	{
		rigPose( &m, t )[0].translation.x = 0.01f * sinf( 0.1f * (float)t );
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, 0 ), 0.0 );
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, 0, 0 ), 0.0 );
	}
	testNear3( soleFindStrideVelocity( &m.motion ), soleVec( 0, 0, 0 ), 0.0f );
	label( &m );
	for ( int32_t i = 0; i < 180; ++i )
	{
		assert_int_equal( m.labels[i], sole_labelFlat );
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void shortRunsAreDroppedAndShortGapsBridged( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 100, 100.0f );
	for ( int32_t t = 0; t < 100; ++t )
	{
		// Off the ground from frame 40 on, but for three frames; a hop of two frames before.
		float y = t >= 40 && ( t < 70 || t >= 73 ) ? 0.5f : ( t == 20 || t == 21 ? 0.06f : 0.0f );
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, y, 0 ), 0.0 );
	}
	label( &m );
	for ( int32_t t = 0; t < 100; ++t )
	{
		if ( t < 38 )
		{
			assert_int_equal( m.labels[2 * t], sole_labelFlat );
		}
		else if ( t > 40 )
		{
			assert_int_equal( m.labels[2 * t], sole_labelNone );
		}
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void fastCharactersMaySlideMoreInContact( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	for ( int32_t t = 0; t < 60; ++t )
	{
		// The root runs at 5 m/s, the left foot creeps at 0.4 m/s, below a tenth of that.
		float time = (float)t / 60.0f;
		m.roots[t].translation.z = 5.0f * time;
		rigPutFoot( rigPose( &m, t ), 0, soleVec( 0, 0, ( 0.4f - 5.0f ) * time ), 0.0 );
		rigPutFoot( rigPose( &m, t ), 1, soleVec( 0, 0, ( 1.2f - 5.0f ) * time ), 0.0 );
	}
	label( &m );
	assert_int_equal( m.labels[2 * 30], sole_labelFlat );
	assert_int_equal( m.labels[2 * 30 + 1], sole_labelNone );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void notANumberIsNoContact( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 60, 60.0f );
	gaitFill( &m, 1.0, 0.0f, false );
	for ( int32_t t = 20; t < 30; ++t )
	{
		rigPose( &m, t )[3].translation.x = nanf( "" );
	}
	label( &m );
	assert_int_equal( m.labels[2 * 25], sole_labelNone );
	assert_true( soleIsFinite( soleFindClipFloor( &m.motion ) ) );
	assert_true( soleVec3_IsFinite( soleFindStrideVelocity( &m.motion ) ) );
	for ( size_t i = 0; i < 60 * RIG_JOINTS; ++i )
	{
		m.poses[i].translation.y = nanf( "" );
	}
	label( &m );
	assert_float_equal( soleFindClipFloor( &m.motion ), 0.0f, 0.0f );
	testNear3( soleFindStrideVelocity( &m.motion ), soleVec( 0, 0, 0 ), 0.0f );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static int32_t assertsSeen;

static bool countAssert( const char* condition, const char* file, int line )
{
	(void)condition;
	(void)file;
	(void)line;
	++assertsSeen;
	return false;
}

static void badLabelDefinitionsAreRefused( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 4, 60.0f );
	soleSetAssertHandler( countAssert );
	soleLabelDef zeroed = { 0 };
	assert_int_equal( soleLabelContacts( &m.motion, &zeroed, NULL, m.labels ), sole_invalidDefinition );
	soleLabelDef inverted = soleDefaultLabelDef();
	inverted.speedOff = 0.1f;
	assert_int_equal( soleLabelContacts( &m.motion, &inverted, NULL, m.labels ), sole_invalidDefinition );
	soleLabelDef def = soleDefaultLabelDef();
	m.motion.frameRate = 0.0f;
	assert_int_equal( soleLabelContacts( &m.motion, &def, NULL, m.labels ), sole_invalidDefinition );
	assert_float_equal( soleFindClipFloor( &m.motion ), 0.0f, 0.0f );
	assert_float_equal( soleFindStrideVelocity( NULL ).x, 0.0f, 0.0f );
	assert_int_equal( assertsSeen, 5 );
	soleSetAssertHandler( NULL );
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

static void failingMemoryLeavesNothingBehind( void** state )
{
	(void)state;
	soleRig* rig = rigMake();
	rigMotion m = rigMakeMotion( rig, 4, 60.0f );
	soleLabelDef def = soleDefaultLabelDef();
	for ( int32_t n = 0;; ++n )
	{
		rigMemory memory = { .left = n };
		soleAllocator allocator = { rigAlloc, rigFree, &memory };
		soleResult result = soleLabelContacts( &m.motion, &def, &allocator, m.labels );
		assert_int_equal( memory.held, 0 );
		if ( result == sole_success )
		{
			assert_true( n > 1 );
			break;
		}
		assert_int_equal( result, sole_outOfMemory );
	}
	rigFreeMotion( &m );
	soleDestroyRig( rig );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( contactsAreFoundWithinAFrameAtEveryRate ),
		cmocka_unit_test( aFloorThatIsNotAtTheOriginIsFound ),
		cmocka_unit_test( strideSpeedOfInPlaceClipsIsFound ),
		cmocka_unit_test( legsOfDifferentPaceShareTheStride ),
		cmocka_unit_test( aClipThatStandsHasNoStrideAndIsAllContact ),
		cmocka_unit_test( shortRunsAreDroppedAndShortGapsBridged ),
		cmocka_unit_test( fastCharactersMaySlideMoreInContact ),
		cmocka_unit_test( notANumberIsNoContact ),
		cmocka_unit_test( badLabelDefinitionsAreRefused ),
		cmocka_unit_test( failingMemoryLeavesNothingBehind ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
