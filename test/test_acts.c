// SPDX-License-Identifier: MIT
// Acts: each can be played on its scene, and does what its name says, at any time that it is asked for.
#include "test.h"

#include "act.h"

#include <math.h>

#define PI 3.14159265358979

static soleScene s_scene;

static void nearly( double a, double b, double tolerance )
{
	if ( !( fabs( a - b ) <= tolerance ) )
	{
		fail_msg( "%.9g is not %.9g", a, b );
	}
}

/// A floor of height 0, and one of height 1 beyond x = 100.
static bool findFloor( void* user, double x, double z, double ceiling, double time, double* height )
{
	(void)user;
	(void)z;
	(void)time;
	*height = x > 100.0 && ceiling > 1.0 ? 1.0 : 0.0;
	return true;
}

static soleSceneMoment getMoment( const soleAct* act, int32_t take, double time )
{
	soleFreeScene( &s_scene );
	assert_true( soleMakeScene( act->scene, &s_scene ) );
	const soleStage stage = { &s_scene, findFloor, NULL };
	soleSceneMoment moment;
	soleGetSceneMoment( act, &stage, take, time, &moment );
	return moment;
}

static const soleAct* findAct( const char* scene, const char* name )
{
	const soleAct* act = soleFindAct( scene, name );
	if ( act == NULL )
	{
		fail_msg( "%s %s is not there", scene, name );
	}
	return act;
}

static soleSceneMoment at( const char* scene, const char* name, int32_t take, double time )
{
	return getMoment( findAct( scene, name ), take, time );
}

static void checkMoment( const soleAct* act, const soleSceneMoment* m )
{
	bool good = soleVec3_IsFinite( m->root.translation ) && soleQuat_IsFinite( m->root.rotation ) &&
	    m->root.scale.x == (float)m->scale && soleVec3_IsFinite( m->hips ) && m->scale > 0.0 && m->weight >= 0.0 &&
	    m->weight <= 1.0 && m->blend >= 0.0 && m->blend <= 1.0 && m->gait < sole_gaitCount &&
	    m->other < sole_gaitCount && fabsf( soleDotQuat( m->root.rotation, m->root.rotation ) - 1.0f ) < 1e-5f &&
	    fabs( m->way ) < 100.0 && soleLength( m->root.translation ) < 30.0f;
	if ( good == false )
	{
		fail_msg( "%s %s: a moment that can't be", act->scene, act->name );
	}
}

static void everyActHasMomentsAllTheTime( void** state )
{
	(void)state;
	int32_t count;
	const soleAct* acts = soleGetActs( &count );
	assert_true( count >= 150 );
	for ( int32_t i = 0; i < count; ++i )
	{
		const soleAct* act = acts + i;
		assert_ptr_equal( soleFindAct( act->scene, act->name ), act );
		assert_true( act->duration > 0.5 && act->duration <= 60.0 );
		soleScene scene;
		assert_true( soleMakeScene( act->scene, &scene ) );
		const soleStage stage = { &scene, findFloor, NULL };
		for ( int32_t take = 0; take == 0 || take < act->special.takeCount; ++take )
		{
			for ( int k = 0; k <= 40; ++k )
			{
				soleSceneMoment moment;
				soleGetSceneMoment( act, &stage, take, act->duration * k / 40.0, &moment );
				checkMoment( act, &moment );
			}
		}
		soleFreeScene( &scene );
	}
}

static void walkersGoAlongTheirHeading( void** state )
{
	(void)state;
	soleSceneMoment m = at( "T04", "walk 30", 0, 4.0 );
	nearly( m.way, 4.16, 1e-9 );
	nearly( m.x, -2.7 + 4.16 * 0.5, 1e-6 );
	nearly( m.z, 0.9 + 4.16 * sqrt( 0.75 ), 1e-6 );
	nearly( m.heading, PI / 6.0, 1e-6 );
	soleVec3 ahead = soleRotate( m.root.rotation, soleVec( 0.0f, 0.0f, 1.0f ) );
	testNear3( ahead, soleVec( 0.5f, 0.0f, 0.8660254f ), 1e-6f );
	// Who sidesteps faces across.
	m = at( "T01", "T40 strafe 0.30", 0, 2.0 );
	nearly( m.x, -1.4, 1e-6 );
	nearly( m.heading, 0.0, 1e-9 );
	assert_true( m.gait == sole_gaitStrafe );
	// Eight headings through the same middle.
	for ( int32_t take = 0; take < 8; ++take )
	{
		m = at( "T16-1", "walk", take, 3.75 );
		nearly( hypot( m.x, m.z ), 0.0, 1e-6 );
		m = at( "T16-1", "walk", take, 7.5 );
		nearly( atan2( m.x, m.z ), take <= 4 ? take * PI / 4.0 : ( take - 8 ) * PI / 4.0, 1e-6 );
	}
}

static void rootsStandOnTheirFloor( void** state )
{
	(void)state;
	soleAct act = *findAct( "T01", "walk" );
	act.course = ( soleActCourse ){ 98.0, 0.0, 90.0, 0.0, 1.0 };
	assert_float_equal( getMoment( &act, 0, 1.0 ).root.translation.y, 0.0f, 1e-6f );
	assert_float_equal( getMoment( &act, 0, 2.5 ).root.translation.y, 1.0f, 1e-6f );
	act.host.ceiling = 0.5;
	assert_float_equal( getMoment( &act, 0, 2.5 ).root.translation.y, 0.0f, 1e-6f );
	act.host.ceiling = 0.0;
	act.root = sole_rootFixed;
	assert_float_equal( getMoment( &act, 0, 2.5 ).root.translation.y, 0.0f, 1e-6f );
	act.root = sole_rootRamped;
	const double corners[SOLE_ACT_CORNERS] = { 1.0, 3.0, 3.5, 4.0 };
	memcpy( act.host.corners, corners, sizeof corners );
	assert_float_equal( getMoment( &act, 0, 0.5 ).root.translation.y, 0.0f, 1e-6f );
	assert_float_equal( getMoment( &act, 0, 1.5 ).root.translation.y, 0.25f, 1e-6f );
	assert_float_equal( getMoment( &act, 0, 3.2 ).root.translation.y, 1.0f, 1e-6f );
	assert_float_equal( getMoment( &act, 0, 9.0 ).root.translation.y, 1.0f, 1e-6f );
	// Known ten times a second: held, or interpolated an interval late.
	act.root = sole_rootStepped;
	act.host.rootRate = 10.0;
	assert_float_equal( getMoment( &act, 0, 1.0 ).root.translation.x, 98.9f, 1e-4f );
	assert_float_equal( getMoment( &act, 0, 1.05 ).root.translation.x, 98.95f, 1e-4f );
	assert_float_equal( getMoment( &act, 0, 2.15 ).root.translation.y, 0.5f, 1e-3f );
	act.host.rootHeld = true;
	assert_float_equal( getMoment( &act, 0, 1.07 ).root.translation.x, 99.0f, 1e-4f );
}

static void stopsAndTurnsComeToTheirEnd( void** state )
{
	(void)state;
	soleSceneMoment m = at( "T01", "T41 walk, idle", 0, 2.4 );
	assert_true( m.blend == 0.0 && m.resting == false );
	m = at( "T01", "T41 walk, idle", 0, 2.7 );
	nearly( m.blend, 1.0, 1e-9 );
	nearly( m.way, 1.3 * 2.6, 1e-6 );
	assert_true( m.resting && m.other == sole_gaitIdle );
	nearly( at( "T01", "T41 walk, idle", 0, 3.9 ).way, m.way, 1e-9 );
	nearly( at( "T01", "T39 round in 2.0", 0, 0.5 ).heading, PI / 2.0, 1e-6 );
	nearly( at( "T01", "T39 round in 2.0", 0, 3.0 ).heading, 2.0 * PI, 1e-6 );
	nearly( at( "T01", "T39 to and fro", 0, 0.25 ).heading, PI / 2.0, 1e-6 );
	nearly( at( "T01", "T39 to and fro", 0, 0.75 ).heading, -PI / 2.0, 1e-6 );
	// The bend keeps its speed.
	soleSceneMoment before = at( "T01", "T42 bend", 0, 1.39 );
	soleSceneMoment after = at( "T01", "T42 bend", 0, 1.40 );
	nearly( hypot( after.x - before.x, after.z - before.z ), 0.06, 1e-4 );
	nearly( at( "T01", "T42 bend", 0, 2.0 ).heading, PI / 2.0, 1e-6 );
	// A quarter of a second each way.
	nearly( at( "T01", "T40 swapped", 0, 0.125 ).x, 0.075, 1e-6 );
	nearly( at( "T01", "T40 swapped", 0, 0.25 ).x, 0.0, 1e-6 );
	nearly( at( "T13", "step out", 0, 5.0 ).x, 0.448, 1e-6 );
	nearly( at( "T13", "climb beside", 0, 6.0 ).z, 4.5, 1e-6 );
}

static void whatLiftsARootLetsItDownAgain( void** state )
{
	(void)state;
	assert_float_equal( at( "T11-20", "T33 jump", 0, 0.89 ).root.translation.y, 0.0f, 1e-6f );
	assert_float_equal( at( "T11-20", "T33 jump", 0, 1.15 ).root.translation.y, 0.5f * 9.81f * 0.0625f, 1e-5f );
	assert_float_equal( at( "T11-20", "T33 jump", 0, 1.41 ).root.translation.y, 0.0f, 1e-6f );
	assert_true( at( "T11-20", "T33 jump", 0, 1.2 ).weight == 0.0 );
	assert_true( at( "T11-20", "T33 jump", 0, 0.9 ).weight == 1.0 && at( "T11-20", "T33 jump", 0, 1.6 ).weight == 1.0 );
	assert_float_equal( at( "T01", "T43 lifted", 0, 3.0 ).root.translation.y, 0.3f, 1e-6f );
	assert_float_equal( at( "T01", "T43 lifted", 0, 9.0 ).root.translation.y, -0.3f, 1e-6f );
	assert_float_equal( at( "T01", "T43 lifted", 0, 12.0 ).root.translation.y, 0.0f, 1e-6f );
	assert_float_equal( at( "T30", "stand", 0, 3.0 ).root.translation.y, 0.8f, 1e-6f );
	assert_float_equal( at( "T30", "stand", 0, 3.2 ).root.translation.y, 0.8f - 0.5f * 9.81f * 0.04f, 1e-5f );
	assert_float_equal( at( "T30", "stand", 0, 4.0 ).root.translation.y, 0.0f, 1e-6f );
	// The plate takes its rider along and stops dead.
	assert_float_equal( at( "T27-slide", "ride", 0, 1.0 ).root.translation.z, 2.0f, 1e-5f );
	assert_float_equal( at( "T27-slide", "ride", 0, 3.0 ).root.translation.z, 4.0f, 1e-5f );
}

static void hostsChangeWhatTheySay( void** state )
{
	(void)state;
	assert_int_equal( at( "T04", "T32 teleport", 0, 1.29 ).jumps, 0 );
	assert_int_equal( at( "T04", "T32 teleport", 0, 1.31 ).jumps, 1 );
	assert_true( at( "T16", "T32 origin", 0, 2.5 ).origin[0] == 10000.0 );
	assert_true( at( "T16", "T32 rebase", 0, 2.5 ).base.z == 1.0f && at( "T16", "T32 rebase", 0, 1.5 ).base.z == 0.0f );
	assert_float_equal( at( "T01", "T34 crouch 0.40", 3, 2.0 ).hips.y, -0.4f, 1e-6f );
	assert_float_equal( at( "T01", "T34 crouch 0.40", 3, 0.0 ).hips.y, 0.0f, 1e-6f );
	nearly( at( "T01", "T34 crouch 0.40", 3, 0.0 ).heading, 0.75 * PI, 1e-6 );
	assert_true(
	    at( "T11-20", "T35 by ramps", 0, 2.075 ).weight > 0.4 && at( "T11-20", "T35 by ramps", 0, 3.0 ).weight == 0.0 );
	assert_true( at( "T11-20", "T35 at once", 0, 2.001 ).weight == 0.0 &&
	    at( "T11-20", "T35 at once", 0, 4.001 ).weight == 1.0 );
	assert_float_equal( soleLength( at( "T11-20", "T36 foot jump", 0, 2.0 ).feet[0] ), 0.3f, 1e-3f );
	assert_true( at( "T11-20", "T36 foot jump", 0, 2.0 + 1.0 / 60.0 ).feet[0].y == 0.0f );
	nearly( at( "T11-20", "T37 scale at once", 2, 1.0 ).scale, 2.0, 1e-9 );
	nearly( at( "T11-20", "T37 scale in 1 s", 0, 1.5 ).scale, 0.75, 1e-9 );
	nearly( at( "T11-20", "T37 legs", 1, 3.0 ).legs, 0.8, 1e-9 );
	nearly( at( "T01", "T38 heels", 0, 3.0 ).heel, 0.08, 1e-9 );
	assert_true( at( "T01", "T38 heels", 0, 5.0 ).heel == 0.0 );
	nearly( at( "T16", "T47 corrected, 10 Hz", 0, 3.5 ).x, 0.1, 1e-9 );
}

static void framesAreAsLongAsTheActSays( void** state )
{
	(void)state;
	assert_true( soleGetActStep( findAct( "T01", "walk" ), 0 ) == 0.0 );
	nearly( soleGetActStep( findAct( "T01", "walk" ), 7 ), 1.0 / 60.0, 1e-12 );
	nearly( soleGetActStep( findAct( "T02", "T44 root at 50 Hz" ), 7 ), 1.0 / 165.0, 1e-12 );
	assert_true( soleGetActStep( findAct( "T02", "T45 hitch" ), 120 ) == 1.0 );
	assert_true( soleGetActStep( findAct( "T02", "T45 pause" ), 130 ) == 0.0 );
	double shortest = 1.0;
	double longest = 0.0;
	for ( int32_t i = 1; i < 200; ++i )
	{
		double step = soleGetActStep( findAct( "T02", "T45 wild steps" ), i );
		shortest = fmin( shortest, step );
		longest = fmax( longest, step );
	}
	assert_true( shortest >= 0.005 && shortest < 0.015 && longest <= 0.250 && longest > 0.240 );
}

static int teardown( void** state )
{
	(void)state;
	soleFreeScene( &s_scene );
	return 0;
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyActHasMomentsAllTheTime ),
		cmocka_unit_test( walkersGoAlongTheirHeading ),
		cmocka_unit_test( rootsStandOnTheirFloor ),
		cmocka_unit_test( stopsAndTurnsComeToTheirEnd ),
		cmocka_unit_test( whatLiftsARootLetsItDownAgain ),
		cmocka_unit_test( hostsChangeWhatTheySay ),
		cmocka_unit_test( framesAreAsLongAsTheActSays ),
	};
	return cmocka_run_group_tests( tests, NULL, teardown );
}
