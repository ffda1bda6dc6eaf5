// SPDX-License-Identifier: MIT
// A second pose that is blended in where one foot stands much higher than the other: how much of it, how smoothly, and
// whether the blended pose is the one that was placed. Ground: a step between the feet,
// the root half way up, so that probes find both levels.
#include "placing.h"

typedef struct Climber
{
	testRun run;
	soleTransform second[biped_count];
} Climber;

static void setStep( Climber* c, float step )
{
	c->run.ground.stepX = step;
	c->run.frame.root.translation.y = 0.5f * step;
}

/// A crouch that leans forward: pelvis and spine are turned too, which no output of a leg knows of.
static void start( Climber* c, float step )
{
	testRun* run = &c->run;
	testStartRun( run, 0.4f );
	memcpy( c->second, run->pose, sizeof c->second );
	testBendKnees( c->second, 1.4f );
	soleVec3 x = soleVec( 1.0f, 0.0f, 0.0f );
	c->second[biped_pelvis].rotation = testTurn( x, 0.25f );
	c->second[biped_spine].rotation = testTurn( x, 0.5f );
	c->second[biped_hipL].translation.y += 0.02f;
	run->frame.secondPose = c->second;
	setStep( c, step );
}

static float settleWeight( float step )
{
	static Climber c;
	start( &c, step );
	testStepSeconds( &c.run, 3.0f );
	testEndRun( &c.run );
	return c.run.out.secondWeight;
}

static void theWeightGoesWithTheDifferenceOfHeights( void** state )
{
	(void)state;
	float length = 0.9f;
	soleSettings settings = soleDefaultSettings();
	float from = settings.target.secondFrom * length;
	float full = settings.target.secondFull * length;
	assert_float_equal( settleWeight( 0.0f ), 0.0f, 0.0f );
	assert_float_equal( settleWeight( 0.98f * from ), 0.0f, 0.0f );
	assert_float_equal( settleWeight( 1.02f * full ), 1.0f, 1e-4f );
	for ( int32_t i = 1; i < 4; ++i )
	{
		float share = 0.25f * (float)i;
		assert_float_equal( settleWeight( from + share * ( full - from ) ), share, 0.01f );
	}
}

static void itIsKnownAtOnceInTheFirstFrame( void** state )
{
	(void)state;
	static Climber c;
	start( &c, 0.6f );
	testStepRun( &c.run );
	testStepRun( &c.run );
	assert_float_equal( c.run.out.secondWeight, 1.0f, 1e-4f );
	testEndRun( &c.run );
}

static void itComesAndGoesSmoothly( void** state )
{
	(void)state;
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		static Climber c;
		start( &c, 0.1f );
		c.run.settings.target.secondTime = 0.2f;
		c.run.frame.timeStep = 1.0f / rates[k];
		testStepSeconds( &c.run, 1.0f );
		for ( int32_t way = 0; way < 2; ++way )
		{
			// The lower foot's ground drops away, and comes back.
			setStep( &c, way == 0 ? 0.6f : 0.1f );
			float last = c.run.out.secondWeight;
			float lastStep = 0.0f;
			for ( int32_t i = 1; i <= (int32_t)( 2.0f * rates[k] ); ++i )
			{
				testStepRun( &c.run );
				float stepNow = ( c.run.out.secondWeight - last ) * rates[k];
				// Of a critically damped spring: with y = 1.678 / secondTime, no faster than y / e, no harder than y^2.
				assert_true( fabsf( stepNow ) < 3.1f );
				assert_true( fabsf( stepNow - lastStep ) * rates[k] < 71.0f );
				last = c.run.out.secondWeight;
				lastStep = stepNow;
				if ( i == (int32_t)( 0.2f * rates[k] + 0.5f ) )
				{
					assert_float_equal( last, 0.5f, 0.01f + 3.1f / rates[k] );
				}
			}
			assert_float_equal( last, way == 0 ? 1.0f : 0.0f, 0.01f );
		}
		testEndRun( &c.run );
	}
}

/// Blends and applies, as a host does.
static void blend( Climber* c )
{
	testRun* run = &c->run;
	memcpy( run->placed, run->pose, sizeof run->placed );
	soleBlendSecondPose( run->biped.rig, &run->out, c->second, run->placed );
	soleApply( run->biped.rig, &run->out, run->placed );
}

static void theBlendedPoseHasTheLegsOfTheOutput( void** state )
{
	(void)state;
	static Climber c;
	start( &c, 0.34f );
	testStepSeconds( &c.run, 3.0f );
	blend( &c );
	float w = c.run.out.secondWeight;
	assert_true( w > 0.3f && w < 0.7f );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		const soleLegOutput* out = c.run.out.legs + leg;
		int32_t hip = leg == 0 ? biped_hipL : biped_hipR;
		for ( int32_t j = 0; j < 3; ++j )
		{
			assert_memory_equal( &c.run.placed[hip + j].rotation, out->rotations_l + j, sizeof( soleQuat ) );
		}
		testNear3( testPlacedJoint( &c.run, testAnkle( leg ) ).translation, out->ankle_w, 1e-4f );
	}
	// All else is between the two poses.
	soleQuat spine = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), 0.5f * w );
	assert_true( testAngle( c.run.placed[biped_spine].rotation, spine ) < 2e-3f );
	float hip = c.run.pose[biped_hipL].translation.y + 0.02f * w;
	assert_float_equal( c.run.placed[biped_hipL].translation.y, hip, 1e-6f );
	testEndRun( &c.run );
}

static void theBlendedPoseIsTheOneThatWasPlacedInEveryFrame( void** state )
{
	(void)state;
	static Climber c;
	start( &c, 0.1f );
	for ( int32_t i = 0; i < 180; ++i )
	{
		setStep( &c, i < 30 || i > 120 ? 0.1f : 0.6f );
		c.run.frame.teleport = i == 150;
		testStepRun( &c.run );
		blend( &c );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 ankle = testPlacedJoint( &c.run, testAnkle( leg ) ).translation;
			testNear3( ankle, c.run.out.legs[leg].ankle_w, 1e-4f );
		}
	}
	testEndRun( &c.run );
}

static void withoutASecondPoseAllIsAsEver( void** state )
{
	(void)state;
	static Climber c;
	testRun plain;
	start( &c, 0.6f );
	testStartRun( &plain, 0.4f );
	plain.ground = c.run.ground;
	plain.frame.root = c.run.frame.root;
	c.run.frame.secondPose = NULL;
	testStepSeconds( &c.run, 1.0f );
	testStepSeconds( &plain, 1.0f );
	assert_float_equal( c.run.out.secondWeight, 0.0f, 0.0f );
	assert_memory_equal( c.run.placed, plain.placed, sizeof plain.placed );
	// Nothing to blend: nothing is touched.
	memcpy( c.run.placed, c.run.pose, sizeof c.run.placed );
	soleBlendSecondPose( c.run.biped.rig, &c.run.out, c.second, c.run.placed );
	assert_memory_equal( c.run.placed, c.run.pose, sizeof c.run.placed );
	testEndRun( &plain );
	testEndRun( &c.run );
}

static void aSecondPoseThatIsNotWantedChangesNothing( void** state )
{
	(void)state;
	static Climber c;
	testRun plain;
	start( &c, 0.1f );
	testStartRun( &plain, 0.4f );
	plain.ground = c.run.ground;
	plain.frame.root = c.run.frame.root;
	testStepSeconds( &c.run, 1.0f );
	testStepSeconds( &plain, 1.0f );
	assert_memory_equal( c.run.placed, plain.placed, sizeof plain.placed );
	testEndRun( &plain );
	testEndRun( &c.run );
}

static void aSecondPoseThatIsGivenLaterBlendsInFromZero( void** state )
{
	(void)state;
	static Climber c;
	start( &c, 0.6f );
	c.run.frame.secondPose = NULL;
	testStepSeconds( &c.run, 1.0f );
	c.run.frame.secondPose = c.second;
	testStepRun( &c.run );
	assert_true( c.run.out.secondWeight < 0.05f );
	testStepSeconds( &c.run, 1.0f );
	assert_float_equal( c.run.out.secondWeight, 1.0f, 1e-3f );
	testEndRun( &c.run );
}

static void misuseIsRefusedSafely( void** state )
{
	(void)state;
	static Climber c;
	start( &c, 0.6f );
	testStepSeconds( &c.run, 1.0f );
	soleSetAssertHandler( testQuietHandler );
	soleTransform pose[biped_count];
	memcpy( pose, c.run.pose, sizeof pose );
	soleBlendSecondPose( NULL, &c.run.out, c.second, pose );
	soleBlendSecondPose( c.run.biped.rig, NULL, c.second, pose );
	soleBlendSecondPose( c.run.biped.rig, &c.run.out, NULL, pose );
	soleBlendSecondPose( c.run.biped.rig, &c.run.out, c.second, NULL );
	assert_memory_equal( pose, c.run.pose, sizeof pose );
	soleSetAssertHandler( NULL );
	testEndRun( &c.run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theWeightGoesWithTheDifferenceOfHeights ),
		cmocka_unit_test( itIsKnownAtOnceInTheFirstFrame ),
		cmocka_unit_test( itComesAndGoesSmoothly ),
		cmocka_unit_test( theBlendedPoseHasTheLegsOfTheOutput ),
		cmocka_unit_test( theBlendedPoseIsTheOneThatWasPlacedInEveryFrame ),
		cmocka_unit_test( withoutASecondPoseAllIsAsEver ),
		cmocka_unit_test( aSecondPoseThatIsNotWantedChangesNothing ),
		cmocka_unit_test( aSecondPoseThatIsGivenLaterBlendsInFromZero ),
		cmocka_unit_test( misuseIsRefusedSafely ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
