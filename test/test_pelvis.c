// SPDX-License-Identifier: MIT
// The pelvis and the ground that the body is over, from outside: how far it goes aside with its feet, how far and fast
// up and down, what it tells the host's capsule, and that a climb is the body's own whatever the root does.
#include "biped_walk.h"

#define LEG 0.9f
#define TREAD 0.3f
#define RISE 0.15f

// ---------------------------------------------------------------------------------------------------------- sideways

/// Feet are held while the root goes away from them slowly. @return how far the pelvis lags behind it, horizontally
static soleVec3 leanAfter( testRun* run, float balance, float sideways, soleVec3 by )
{
	testStartRun( run, 0.9f );
	run->settings.pelvis.balance = balance;
	run->settings.pelvis.sideways = sideways;
	run->settings.contact.replantAfter = 60.0f;
	testStepSeconds( run, 0.5f );
	soleVec3 foot = testPlacedJoint( run, biped_ankleL ).translation;
	soleVec3 last = run->out.pelvisOffset_w;
	for ( int32_t i = 0; i < 120; ++i )
	{
		run->frame.root.translation = soleScale( fminf( (float)i / 60.0f, 1.0f ), by );
		testStepRun( run );
		assert_true( soleDistance( run->out.pelvisOffset_w, last ) < 6e-3f );
		last = run->out.pelvisOffset_w;
	}
	testNear3( testPlacedJoint( run, biped_ankleL ).translation, foot, 2e-4f );
	testEndRun( run );
	return soleVec( last.x, 0.0f, last.z );
}

static void thePelvisGoesAlongWithFeetThatAreHeldAside( void** state )
{
	(void)state;
	static testRun run;
	const soleVec3 ways[] = { { 0.08f, 0.0f, 0.0f }, { 0.0f, 0.0f, -0.08f }, { 0.05f, 0.0f, 0.05f } };
	for ( int32_t k = 0; k < 3; ++k )
	{
		soleVec3 none = leanAfter( &run, 0.0f, 0.1f, ways[k] );
		testNear3( none, soleVec( 0.0f, 0.0f, 0.0f ), 1e-6f );
		testNear3( leanAfter( &run, 1.0f, 0.1f, ways[k] ), soleNeg( ways[k] ), 2e-3f );
		testNear3( leanAfter( &run, 0.5f, 0.1f, ways[k] ), soleScale( -0.5f, ways[k] ), 2e-3f );
	}
}

static void itGoesAsideNoFurtherThanTheSetting( void** state )
{
	(void)state;
	static testRun run;
	const float limits[] = { 0.1f, 0.05f, 0.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		soleVec3 lean = leanAfter( &run, 1.0f, limits[k], soleVec( 0.12f, 0.0f, 0.16f ) );
		assert_float_equal( soleLength( lean ), limits[k] * LEG, 1e-3f );
		assert_true( limits[k] <= 0.0f || lean.x * 0.16f - lean.z * 0.12f < 1e-3f );
	}
}

// ------------------------------------------------------------------------------------------------------- up and down

static void theCapsuleIsAsMuchShorterAsThePelvisIsLower( void** state )
{
	(void)state;
	static testRun run;
	const float steps[] = { 0.0f, 0.05f, 0.1f, 0.2f };
	float last = -1.0f;
	for ( int32_t k = 0; k < 4; ++k )
	{
		testStartRun( &run, 0.3f );
		run.ground.stepX = -steps[k]; // the root stands on the upper side
		testStepSeconds( &run, 2.0f );
		float down = -run.out.pelvisOffset_w.y;
		assert_true( down > last && down < steps[k] + 0.01f );
		// It loses half of that at both ends: its foot stays on the ground.
		assert_float_equal( run.out.capsuleShorter, 0.5f * down, 1e-6f );
		assert_float_equal( run.out.capsuleOffset, -0.5f * down, 1e-6f );
		last = down;
		testEndRun( &run );
	}
	// A pelvis that goes up leaves the capsule as it is.
	testStartRun( &run, 0.3f );
	run.ground.stepX = 0.1f;
	run.frame.root.translation.y = -0.05f;
	testStepSeconds( &run, 2.0f );
	assert_true( run.out.pelvisOffset_w.y > 0.02f );
	assert_float_equal( run.out.capsuleShorter, 0.0f, 0.0f );
	assert_float_equal( run.out.capsuleOffset, 0.0f, 0.0f );
	testEndRun( &run );
}

static void thePelvisMovesNoFasterThanTheSetting( void** state )
{
	(void)state;
	static testRun run;
	const float speeds[] = { 0.2f, 0.9f, 3.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		testStartRun( &run, 0.3f );
		run.settings.pelvis.speed = speeds[k];
		testStepSeconds( &run, 1.0f );
		float fastest = 0.0f;
		for ( int32_t i = 0; i < 240; ++i )
		{
			// The left foot's ground drops away and comes back.
			run.ground.stepX = i < 120 ? -0.25f : 0.0f;
			float before = run.out.pelvisOffset_w.y;
			testStepRun( &run );
			fastest = fmaxf( fastest, fabsf( run.out.pelvisOffset_w.y - before ) * 60.0f );
		}
		assert_true( fastest <= speeds[k] * LEG * 1.001f );
		assert_true( fastest > 0.2f * LEG * 0.99f );
		testEndRun( &run );
	}
}

static void thePelvisGoesNoFurtherDownThanTheSetting( void** state )
{
	(void)state;
	static testRun run;
	const float limits[] = { 0.45f, 0.2f, 0.05f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		testStartRun( &run, 0.3f );
		run.settings.pelvis.down = limits[k];
		testStepSeconds( &run, 0.5f );
		run.ground.stepX = -0.3f;
		testStepSeconds( &run, 2.0f );
		// Counted from the ground that the body is over, half way down.
		float down = -run.out.pelvisOffset_w.y - 0.15f;
		assert_true( down <= limits[k] * LEG + 1e-3f );
		assert_true( k == 0 ? down > 0.08f : down > -0.001f );
		testEndRun( &run );
	}
}

// ---------------------------------------------------------------------------------------------------------- climbing

typedef enum RootWay
{
	rootRamps,   // along the line through the stairs
	rootPops,    // on what is under it
	rootHurries, // up each riser within 6 cm
	rootLags,    // half a tread late
	rootWays
} RootWay;

static float rootHeight( const testGround* ground, RootWay way, float z )
{
	float along = z - ground->stairs;
	float treads = along / ground->tread;
	switch ( way )
	{
	case rootRamps:
		return fmaxf( ground->rise * ( treads + 0.5f ), 0.0f );
	case rootPops:
		return testGroundHeight( ground, 0.0f, z );
	case rootHurries:
		return along < 0.0f ? 0.0f
		                    : ground->rise * ( floorf( treads ) + fminf( ( treads - floorf( treads ) ) * 5.0f, 1.0f ) );
	case rootLags:
	case rootWays:
		break;
	}
	return fmaxf( ground->rise * treads, 0.0f );
}

static void theBodyClimbsStairsTheSameWhateverTheRootDoes( void** state )
{
	(void)state;
	static testRun runs[rootWays];
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	const testWalk walk = { 2.0f * TREAD, 1.0f, 0.06f };
	const float rates[] = { 30.0f, 60.0f, 144.0f };
	for ( int32_t k = 0; k < 12; ++k )
	{
		float rate = rates[k % 3];
		for ( int32_t way = 0; way < rootWays; ++way )
		{
			testStartRun( runs + way, 0.5f );
			runs[way].ground.stairs = 1.0f + 0.25f * TREAD * (float)( k / 3 );
			runs[way].ground.tread = TREAD;
			runs[way].ground.rise = RISE;
			runs[way].frame.timeStep = 1.0f / rate;
		}
		float last = 0.0f;
		for ( int32_t i = 0; i < (int32_t)( 5.0f * rate ); ++i )
		{
			float time = (float)i / rate;
			float z = walk.speed * time;
			float heights[rootWays];
			for ( int32_t way = 0; way < rootWays; ++way )
			{
				testRun* run = runs + way;
				float y = rootHeight( &run->ground, (RootWay)way, z );
				run->frame.root.translation = soleVec( 0.0f, y, z );
				testWalkOn( run, &walk, time, contacts, inputs );
				heights[way] = testPlacedJoint( run, biped_pelvis ).translation.y;
				assert_float_equal( heights[way], heights[0], 1e-3f );
			}
			// And steadily: never down, and never by much more than on the mean.
			float climb = ( heights[0] - last ) * rate / ( RISE / TREAD * walk.speed );
			assert_true( time < 3.0f || ( climb > -0.01f && climb < 2.5f ) );
			last = heights[0];
		}
		for ( int32_t way = 0; way < rootWays; ++way )
		{
			testEndRun( runs + way );
		}
	}
}

// ---------------------------------------------------------------------------------------------------------- gradient

static void theBodysGradientIsThatOfTheSlopeUnderItsFeet( void** state )
{
	(void)state;
	static testRun run;
	const float slopes[] = { 0.3f, -0.2f, 0.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		// A foot forward and one back, as far aside as ever: not the slope of the line between them.
		testStartRun( &run, 0.5f );
		run.ground.slopeZ = slopes[k];
		run.pose[biped_pelvis].translation.y = WALK_HIP + WALK_ANKLE;
		testPutAnkle( run.pose, biped_hipL, WALK_HIP, 0.35f );
		testPutAnkle( run.pose, biped_hipR, WALK_HIP, -0.35f );
		testStepSeconds( &run, 1.0f );
		testNear3( run.out.bodyGradient_w, soleVec( 0.0f, 0.0f, slopes[k] ), 0.01f );
		testEndRun( &run );
	}
}

static void aBodyThatWalksOverASlopeKnowsItOnAverage( void** state )
{
	(void)state;
	static testRun run;
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	const testWalk walk = { 0.8f, 1.0f, 0.06f };
	const float slopes[] = { 0.25f, -0.25f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( &run, 0.5f );
		run.ground.slopeZ = slopes[k];
		soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
		float aside = 0.0f;
		for ( int32_t i = 0; i < 240; ++i )
		{
			float time = (float)i / 60.0f;
			run.frame.root.translation = soleVec( 0.0f, slopes[k] * walk.speed * time, walk.speed * time );
			testWalkOn( &run, &walk, time, contacts, inputs );
			if ( i >= 120 )
			{
				sum = soleMulAdd( sum, 1.0f / 120.0f, run.out.bodyGradient_w );
				aside = fmaxf( aside, fabsf( run.out.bodyGradient_w.x ) );
			}
			assert_float_equal( run.out.bodyGradient_w.y, 0.0f, 1e-6f );
		}
		assert_float_equal( sum.x, 0.0f, 1e-3f );
		assert_float_equal( sum.z, slopes[k], 0.03f * fabsf( slopes[k] ) );
		assert_true( aside < 0.03f );
		testEndRun( &run );
	}
}

/// @return how far the pelvis is below the animated one, on the mean, in a walk along a slope
static float findMeanCrouch( testRun* run, const testWalk* walk, float slope )
{
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	testStartRun( run, 0.9f );
	run->ground.slopeZ = slope;
	float sum = 0.0f;
	for ( int32_t i = 0; i < 360; ++i )
	{
		float time = (float)i / 60.0f;
		run->frame.root.translation = soleVec( 0.0f, slope * walk->speed * time, walk->speed * time );
		testWalkOn( run, walk, time, contacts, inputs );
		sum += i >= 120 ? -run->out.pelvisOffset_w.y / 240.0f : 0.0f;
	}
	testEndRun( run );
	return sum;
}

/// The ground that the body is over sinks with it: what a landing needs is to be counted from where that will be, not
/// from where it is while the foot is in the air. Counted from there this walk crouched 9 and 15 cm more than it had
/// to.
static void downhillThePelvisIsNoLowerThanTheLandingsNeed( void** state )
{
	(void)state;
	static testRun run;
	const testWalk walk = { 1.2f, 1.0f, 0.06f };
	const float slopes[] = { -0.2f, -0.4f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		// A straight leg that comes down as far ahead as the walk has it.
		float ahead = 0.5f * WALK_STANCE * walk.period * walk.speed;
		float need = WALK_HIP - slopes[k] * ahead - sqrtf( 0.9f * 0.9f - ahead * ahead );
		float crouch = findMeanCrouch( &run, &walk, slopes[k] );
		assert_true( crouch > need - 1e-3f );
		assert_true( crouch < need + 0.07f );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( thePelvisGoesAlongWithFeetThatAreHeldAside ),
		cmocka_unit_test( itGoesAsideNoFurtherThanTheSetting ),
		cmocka_unit_test( theCapsuleIsAsMuchShorterAsThePelvisIsLower ),
		cmocka_unit_test( thePelvisMovesNoFasterThanTheSetting ),
		cmocka_unit_test( thePelvisGoesNoFurtherDownThanTheSetting ),
		cmocka_unit_test( theBodyClimbsStairsTheSameWhateverTheRootDoes ),
		cmocka_unit_test( theBodysGradientIsThatOfTheSlopeUnderItsFeet ),
		cmocka_unit_test( aBodyThatWalksOverASlopeKnowsItOnAverage ),
		cmocka_unit_test( downhillThePelvisIsNoLowerThanTheLandingsNeed ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
