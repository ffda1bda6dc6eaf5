// SPDX-License-Identifier: MIT
// The filter by ticks beside the script that it is taken from: the same character, ground and curves in the same run,
// frame by frame; and what flags do where the script's zeros mean "none".
#include "biped_walk.h"

#include "baselines/iksetting.h"
#include "settings_file.h"

#include <math.h>

#define TURN 6.2831853f

/// Both, over one ground.
typedef struct Pair
{
	testRun sole;
	soleTransform placed[biped_count]; // by the script
	soleIkSettingSettings settings;
	soleIkSettingState state;
	soleIkSettingCurve drawn[2];
	float curves[2];
	soleOutput out;
	int32_t asked[2]; // probes with a length, by both
} Pair;

static Pair s_pair;

static void readPreset( testRun* run )
{
	toolError error = { { 0 } };
	if ( !toolReadSettings( SOLE_SOURCE_DIR "/settings/iksetting.json", &run->settings, &error ) )
	{
		fail_msg( "%s", error.text );
	}
}

/// The script knows no range of motion, and a rig always has one.
static void loosenAnkles( testBiped* biped )
{
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		biped->def.legs[leg].ankleLimits = ( soleAnkleLimits ){ 1.5f, 1.5f, 1.5f, 1.5f, 1.5f };
	}
	soleDestroyRig( biped->rig );
	assert_int_equal( soleCreateRig( &biped->def, NULL, &biped->rig, NULL ), sole_success );
}

static void start( Pair* pair, float flexion )
{
	static const soleContactInput down[2] = { { 1.0f, 1.0f }, { 1.0f, 1.0f } };
	memset( pair, 0, sizeof *pair );
	testStartRun( &pair->sole, flexion );
	readPreset( &pair->sole );
	loosenAnkles( &pair->sole.biped );
	pair->settings = soleDefaultIkSettingSettings();
	pair->state = soleDefaultIkSettingState( pair->sole.biped.rig );
	pair->curves[0] = 1.0f;
	pair->curves[1] = 1.0f;
	// Weights are the curves' business alone.
	pair->sole.frame.contact = down;
	pair->sole.frame.positionWeight = pair->curves;
}

static void castAll( const Pair* pair, const soleProbe* probes, int32_t count, soleHit* hits, int32_t* asked )
{
	*asked = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		testCastAt( &pair->sole.ground, probes + i, hits + i );
		*asked += probes[i].length > 0.0f ? 1 : 0;
	}
}

static void step( Pair* pair )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	testRun* run = &pair->sole;
	const soleRig* rig = run->biped.rig;
	int32_t n = soleGatherProbes( rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
	castAll( pair, probes, n, hits, pair->asked + 0 );
	soleSolve( rig, &run->settings, &run->state, &run->frame, hits, n, &run->out );
	testPlace( run );

	pair->drawn[0] = ( soleIkSettingCurve ){ "LeftFoot", pair->curves[0] };
	pair->drawn[1] = ( soleIkSettingCurve ){ "RightFoot", pair->curves[1] };
	const soleIkSettingCurves curves = { pair->drawn, 2 };
	soleFrame frame = run->frame;
	frame.positionWeight = NULL;
	n = soleGatherIkSetting( rig, &pair->settings, &pair->state, &frame, probes, SOLE_MAX_PROBES );
	castAll( pair, probes, n, hits, pair->asked + 1 );
	soleSolveIkSetting( rig, &pair->settings, &pair->state, &frame, &curves, hits, n, &pair->out );
	memcpy( pair->placed, run->pose, sizeof pair->placed );
	soleApply( rig, &pair->out, pair->placed );
}

/// Furthest that a joint is from where the script has it, m.
static float findApart( const Pair* pair )
{
	const testRun* run = &pair->sole;
	float most = 0.0f;
	for ( int32_t j = 0; j < biped_count; ++j )
	{
		soleVec3 script = testJoint( &run->biped, pair->placed, run->frame.root, j ).translation;
		most = fmaxf( most, soleDistance( testPlacedJoint( run, j ).translation, script ) );
	}
	return most;
}

/// Walks uphill, over stairs and on where there is nothing, turned a little, with curves drawn for each foot.
static void walkBeside( float rate, float heldStep )
{
	Pair* pair = &s_pair;
	const testWalk walk = { .speed = 1.2f, .period = 1.0f, .lift = 0.1f };
	start( pair, 0.0f );
	testRun* run = &pair->sole;
	run->ground.slopeZ = 0.15f;
	run->ground.slopeX = 0.05f;
	run->ground.stairs = 1.0f;
	run->ground.tread = 0.4f;
	run->ground.rise = 0.1f;
	run->ground.hole = 4.0f;
	run->frame.timeStep = heldStep > 0.0f ? heldStep : 1.0f / rate;
	run->frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.3f );
	float moved = 0.0f;
	int32_t ticks = 0;
	for ( int32_t i = 0; i < (int32_t)( 4.0f * rate ); ++i )
	{
		float time = (float)i / rate;
		float z = 1.2f * time;
		run->frame.root.translation = soleVec( 0.3f * z, testGroundHeight( &run->ground, 0.3f * z, z ), z );
		testPoseWalk( run->pose, &walk, time );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			pair->curves[leg] = 0.5f + 0.5f * cosf( TURN * ( time + 0.5f * (float)leg ) );
		}
		step( pair );
		ticks += pair->asked[0] > 0 ? 1 : 0;
		assert_int_equal( pair->asked[0], pair->asked[1] );
		// 0.16 mm where a leg is out of reach: no leg of Sole is quite straight. Else a hundredth of that.
		bool reached = pair->sole.out.legs[0].error + pair->sole.out.legs[1].error < 1e-4f;
		assert_true( findApart( pair ) < ( reached ? 5e-6f : 2e-4f ) );
		moved = fmaxf( moved, testLargestTurn( run->placed, run->pose ) );
	}
	float seconds = (float)(int32_t)( 4.0f * rate ) * run->frame.timeStep;
	assert_float_equal( (float)ticks, fminf( seconds / 0.02f, 4.0f * rate ), 2.0f );
	assert_true( moved > 0.3f );
	testEndRun( run );
}

static void itDoesWhatTheScriptDoesAtEveryFrameRate( void** state )
{
	(void)state;
	walkBeside( 30.0f, 0.0f );
	walkBeside( 60.0f, 0.0f );
	walkBeside( 144.0f, 0.0f );
}

static void itDoesWhatTheScriptDoesWhereEveryFrameIsATick( void** state )
{
	(void)state;
	walkBeside( 30.0f, 0.02f );
	walkBeside( 60.0f, 0.02f );
	walkBeside( 144.0f, 0.02f );
}

static void everyCallGoesAShareOfTheWay( void** state )
{
	(void)state;
	// Half of what is left a foot, 0.28 of it the body, however long frames are.
	const float times[] = { 1.0f / 30.0f, 0.02f, 1.0f / 144.0f };
	for ( int32_t k = 0; k < 3; ++k )
	{
		Pair* pair = &s_pair;
		start( pair, 0.8f );
		testRun* run = &pair->sole;
		step( pair );
		run->frame.timeStep = 1.0f / 30.0f; // is asked in the next frame
		run->ground.stepX = 0.1f;
		step( pair );
		run->frame.timeStep = times[k];
		float left = 0.5f;
		for ( int32_t i = 0; i < 6; ++i )
		{
			float y = testPlacedJoint( run, biped_ankleL ).translation.y;
			assert_float_equal( y, 0.08f + 0.1f * ( 1.0f - left ), 1e-5f );
			left *= 0.5f;
			step( pair );
		}
		run->ground.stepX = 0.0f;
		run->ground.slopeZ = 0.0f;
		testEndRun( run );
	}
}

static void groundAtTheOriginIsGround( void** state )
{
	(void)state;
	Pair* pair = &s_pair;
	start( pair, 0.8f );
	testRun* run = &pair->sole;
	run->frame.root.translation.y = -0.1f;
	run->frame.timeStep = 0.02f;
	static soleProbe probes[SOLE_MAX_PROBES];
	for ( int32_t i = 0; i < 60; ++i )
	{
		static soleHit hits[SOLE_MAX_PROBES];
		int32_t n =
		    soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
		for ( int32_t k = 0; k < n; ++k )
		{
			bool cast = probes[k].length > 0.0f;
			hits[k] = ( soleHit ){ .hit = cast, .surface = SOLE_NONE, .asked_w = probes[k].start_w };
			hits[k].normal_w = soleVec( 0.0f, cast ? 1.0f : 0.0f, 0.0f );
		}
		soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, hits, n, &run->out );
	}
	assert_float_equal( run->out.pelvisOffset_w.y, 0.1f, 1e-4f );
	assert_float_equal( run->out.legs[0].ankle_w.y, 0.08f, 1e-4f );
	assert_int_equal( run->out.legs[0].flags & (uint32_t)sole_legNoGround, 0 );
	testEndRun( run );
}

static void aJumpIsTakenAtOnce( void** state )
{
	(void)state;
	Pair* pair = &s_pair;
	start( pair, 0.8f );
	testRun* run = &pair->sole;
	for ( int32_t i = 0; i < 60; ++i )
	{
		step( pair );
	}
	run->ground.stepX = 0.1f;
	run->frame.teleport = true;
	run->frame.root.translation.y = 5.0f;
	step( pair );
	// Nothing of the last place is left: the body as it is animated, as in the script's first frame.
	assert_float_equal( run->out.pelvisOffset_w.y, 0.0f, 0.0f );
	testEndRun( run );
}

static void feetTurnWithTheGroundWhereThatIsWanted( void** state )
{
	(void)state;
	Pair* pair = &s_pair;
	start( pair, 0.8f );
	testRun* run = &pair->sole;
	run->settings.target.align = 1.0f;
	run->ground.slopeX = 0.2f;
	run->frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.7f );
	run->frame.timeStep = 0.02f;
	pair->settings.useIkFeature = true;
	for ( int32_t i = 0; i < 60; ++i )
	{
		step( pair );
	}
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleTransform script = testJoint( &run->biped, pair->placed, run->frame.root, testAnkle( leg ) );
		assert_true( testAngle( testPlacedJoint( run, testAnkle( leg ) ).rotation, script.rotation ) < 1e-3f );
		soleVec3 up = soleVec( 0.0f, 1.0f, 0.0f );
		soleQuat was = testAnimatedJoint( run, testAnkle( leg ) ).rotation;
		soleQuat turn = soleMulQuat( testPlacedJoint( run, testAnkle( leg ) ).rotation, soleConjugate( was ) );
		testNear3( soleRotate( turn, up ), run->out.legs[leg].planeNormal_w, 1e-3f );
	}
	testEndRun( run );
}

static void aLongWorldMovesNothing( void** state )
{
	(void)state;
	// The origin of the world's coordinates goes by 10 km while it walks.
	static testRun runs[2];
	const testWalk walk = { .speed = 1.2f, .period = 1.0f, .lift = 0.1f };
	for ( int32_t k = 0; k < 2; ++k )
	{
		testStartRun( runs + k, 0.0f );
		readPreset( runs + k );
		runs[k].ground.stepX = 0.06f;
	}
	for ( int32_t i = 0; i < 120; ++i )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			testPoseWalk( runs[k].pose, &walk, (float)i / 60.0f );
			bool shifted = k == 1 && i >= 60;
			runs[k].frame.worldOrigin[1] = shifted ? 1024.0 : 0.0;
			runs[k].frame.root.translation = soleVec( 0.0f, shifted ? -1024.0f : 0.0f, 0.02f * (float)i );
			static soleProbe probes[SOLE_MAX_PROBES];
			static soleHit hits[SOLE_MAX_PROBES];
			soleVec3 shift = soleVec( 0.0f, shifted ? 1024.0f : 0.0f, 0.0f );
			int32_t n = soleGatherProbes(
			    runs[k].biped.rig, &runs[k].settings, &runs[k].state, &runs[k].frame, probes, SOLE_MAX_PROBES );
			for ( int32_t j = 0; j < n; ++j )
			{
				soleProbe moved = probes[j];
				moved.start_w = soleAdd( moved.start_w, shift );
				testCastAt( &runs[k].ground, &moved, hits + j );
				hits[j].point_w = soleSub( hits[j].point_w, hits[j].hit ? shift : soleVec( 0.0f, 0.0f, 0.0f ) );
				hits[j].asked_w = probes[j].start_w;
			}
			soleSolve( runs[k].biped.rig, &runs[k].settings, &runs[k].state, &runs[k].frame, hits, n, &runs[k].out );
			testPlace( runs + k );
		}
		assert_true( testLargestTurn( runs[0].placed, runs[1].placed ) < 2e-3f );
	}
	testEndRun( runs + 0 );
	testEndRun( runs + 1 );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( itDoesWhatTheScriptDoesAtEveryFrameRate ),
		cmocka_unit_test( itDoesWhatTheScriptDoesWhereEveryFrameIsATick ),
		cmocka_unit_test( everyCallGoesAShareOfTheWay ),
		cmocka_unit_test( groundAtTheOriginIsGround ),
		cmocka_unit_test( aJumpIsTakenAtOnce ),
		cmocka_unit_test( feetTurnWithTheGroundWhereThatIsWanted ),
		cmocka_unit_test( aLongWorldMovesNothing ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
