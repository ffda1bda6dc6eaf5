// SPDX-License-Identifier: MIT
// What a frame shows of itself, through the public calls: a walk and a stand whose drawings are recorded and compared
// with the poses and outputs of the same frames.
#include "draw_recorder.h"

/// On a slope, far from the origin of the world, turned.
static void standOnSlope( void )
{
	testStartRun( &take.run, 0.5f );
	take.run.ground.slopeZ = 0.2f;
	take.run.ground.slopeX = 0.1f;
	take.run.pose[biped_toeL].rotation = testTurn( soleVec( 1.0f, 0.0f, 0.0f ), -0.4f );
	take.run.frame.root.translation = soleVec( 3.0f, 0.9f, 3.0f );
	take.run.frame.root.rotation = testTurn( soleVec( 0.0f, 1.0f, 0.0f ), 0.7f );
	for ( int32_t i = 0; i < 30; ++i )
	{
		stepTake();
	}
}

static const testWalk stairsWalk = { 0.6f, 1.0f, 0.06f };

static void startStairs( void )
{
	testStartRun( &take.run, 0.5f );
	take.run.ground.stairs = 0.25f;
	take.run.ground.tread = 0.3f;
	take.run.ground.rise = 0.15f;
}

/// A frame of a walk up the stairs, its steps told.
static void walkStairs( int32_t frame )
{
	static soleContactInput contacts[2];
	static soleStepInput inputs[2];
	testRun* run = &take.run;
	float time = (float)frame * run->frame.timeStep;
	float z = stairsWalk.speed * time;
	run->frame.root.translation = soleVec( 0.0f, fmaxf( 0.5f * ( z - 0.1f ), 0.0f ), z );
	testPoseWalk( run->pose, &stairsWalk, time );
	testTellWalk( &stairsWalk, time, contacts, inputs );
	run->frame.contact = contacts;
	run->frame.steps = inputs;
	stepTake();
}

// ----------------------------------------------------------------------------------------------------------- tests

static void bonesAreWhereThePoseIs( void** state )
{
	(void)state;
	standOnSlope();
	drawTake( sole_drawBones );
	assert_int_equal(
	    countNear( shape_line, sole_colorBone, testPlacedJoint( &take.run, biped_hipL ).translation ), 1 );
	for ( int32_t joint = biped_hipL; joint <= biped_toeR; ++joint )
	{
		soleVec3 place = testPlacedJoint( &take.run, joint ).translation;
		assert_int_equal( countNear( shape_sphere, sole_colorJoint, place ), 1 );
	}
	drawTake( sole_drawAnimated );
	soleVec3 hip = testAnimatedJoint( &take.run, biped_hipL ).translation;
	soleVec3 knee = testAnimatedJoint( &take.run, biped_kneeL ).translation;
	assert_int_equal( countNear( shape_line, sole_colorAnimated, hip ), 1 );
	assert_int_equal( countNear( shape_line, sole_colorAnimated, knee ), 1 );
	testEndRun( &take.run );
}

static void stretchedBonesAreWhereThePoseIs( void** state )
{
	(void)state;
	testStartRun( &take.run, 0.02f );
	take.run.settings.leg.stretch = 0.05f;
	take.run.settings.leg.heelLift = 0.0f;
	take.run.settings.pelvis.down = 0.0f;
	take.run.ground.stepX = -0.1f;
	for ( int32_t i = 0; i < 30; ++i )
	{
		stepTake();
	}
	assert_true( take.run.out.legs[0].stretch > 1.01f );
	drawTake( sole_drawBones );
	soleVec3 ankle = testPlacedJoint( &take.run, biped_ankleL ).translation;
	assert_int_equal( countNear( shape_sphere, sole_colorJoint, ankle ), 1 );
	testEndRun( &take.run );
}

static void solesAndTargetsAreThoseOfTheOutput( void** state )
{
	(void)state;
	standOnSlope();
	drawTake( sole_drawSole | sole_drawTarget | sole_drawPlane | sole_drawPelvis );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleSolePoints sole = soleRig_GetLeg( take.run.biped.rig, leg ).sole;
		soleVec3 heel = testPlacedPoint( &take.run, leg, sole.heel, false );
		soleVec3 ball = testPlacedPoint( &take.run, leg, sole.ball, true );
		soleVec3 outer = testPlacedPoint( &take.run, leg, sole.outer, true );
		assert_int_equal( countNear( shape_sphere, sole_colorSole, heel ), 1 );
		assert_int_equal( countNear( shape_sphere, sole_colorSole, ball ), 1 );
		assert_int_equal( countNear( shape_sphere, sole_colorSole, outer ), 1 );
		const soleLegOutput* out = take.run.out.legs + leg;
		assert_int_equal( countNear( shape_sphere, sole_colorTarget, out->ankleTarget_w ), 1 );
		// The outer ring and the inner one of a foot that is sure of its ground coincide.
		assert_float_equal( out->confidence, 1.0f, 1e-3f );
		assert_int_equal( countNear( shape_circle, sole_colorPlane, out->planePoint_w ), 2 );
	}
	soleVec3 pelvis = testPlacedJoint( &take.run, biped_pelvis ).translation;
	assert_int_equal( countNear( shape_sphere, sole_colorPelvis, pelvis ), 1 );
	const Shape* interval = findShape( shape_line, sole_colorLimit );
	assert_non_null( interval );
	assert_true( interval->a.y - 1e-5f < pelvis.y && pelvis.y < interval->b.y + 1e-5f );
	testEndRun( &take.run );
}

static void probesEndAtTheirHits( void** state )
{
	(void)state;
	testStartRun( &take.run, 0.5f );
	take.run.settings.probe.shape = sole_probeSphere;
	stepTake();
	drawTake( sole_drawProbes | sole_drawHits | sole_drawSweeps );
	int32_t cast = 0, met = 0;
	for ( int32_t i = 0; i < take.count; ++i )
	{
		const soleProbe* probe = take.probes + i;
		const soleHit* hit = take.hits + i;
		cast += probe->length > 0.0f ? 1 : 0;
		if ( hit->hit )
		{
			++met;
			soleVec3 middle = soleVec( probe->start_w.x, probe->radius, probe->start_w.z );
			assert_int_equal( countNear( shape_line, sole_colorProbe, probe->start_w ), 1 );
			assert_int_equal( countNear( shape_arrow, sole_colorHit, hit->point_w ), 1 );
			assert_int_equal( countNear( shape_circle, sole_colorSweep, probe->start_w ), 1 );
			assert_int_equal( countNear( shape_sphere, sole_colorSweep, middle ), 1 );
		}
	}
	assert_true( met > 0 );
	take.count = 0;
	drawTake( sole_drawProbes | sole_drawHits | sole_drawSweeps );
	assert_int_equal( recorder.count, 0 );
	assert_true( cast >= met );
	testEndRun( &take.run );
}

static void missesAreToldApart( void** state )
{
	(void)state;
	testStartRun( &take.run, 0.5f );
	take.run.ground.hole = -5.0f;
	stepTake();
	drawTake( sole_drawProbes );
	assert_non_null( findShape( shape_line, sole_colorMiss ) );
	assert_null( findShape( shape_line, sole_colorProbe ) );
	testEndRun( &take.run );
}

static void probesThatStartInsideGoNowhere( void** state )
{
	(void)state;
	testStartRun( &take.run, 0.5f );
	stepTake();
	take.hits[0].startedInside = true;
	drawTake( sole_drawProbes | sole_drawHits );
	assert_int_equal( countNear( shape_sphere, sole_colorInside, take.hits[0].point_w ), 1 );
	const Shape* line = findShape( shape_line, sole_colorProbe );
	assert_non_null( line );
	assert_true( soleDistance( line->a, line->b ) == 0.0f );
	testEndRun( &take.run );
}

static void theInnerRingIsAsWideAsThePlaneIsSure( void** state )
{
	(void)state;
	testStartRun( &take.run, 0.5f );
	take.run.ground.hole = 0.05f;
	stepTake();
	float confidence = take.run.out.legs[0].confidence;
	assert_true( confidence > 0.2f && confidence < 0.9f );
	drawTake( sole_drawPlane );
	const Shape* outer = findShape( shape_circle, sole_colorPlane );
	assert_non_null( outer );
	assert_float_equal( outer->radius, 0.13f, 1e-5f );
	assert_float_equal( outer[1].radius, 0.13f * confidence, 1e-5f );
	testEndRun( &take.run );
}

static void locksAreWhereFeetAreHeld( void** state )
{
	(void)state;
	standOnSlope();
	drawTake( sole_drawLock | sole_drawReach | sole_drawFlags );
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		assert_true( take.run.out.legs[leg].flags & (uint32_t)sole_legPlanted );
		soleVec3 held = take.run.state.legs[leg].lockPoint_w;
		soleVec3 onPlane = held;
		onPlane.y = testGroundHeight( &take.run.ground, held.x, held.z );
		assert_int_equal( countNear( shape_sphere, sole_colorLock, onPlane ), 1 );
		soleVec3 hip = testPlacedJoint( &take.run, leg == 0 ? biped_hipL : biped_hipR ).translation;
		assert_int_equal( countNear( shape_circle, sole_colorReach, hip ), 2 );
	}
	const Shape* ring = findShape( shape_circle, sole_colorRelease );
	assert_non_null( ring );
	assert_float_equal( ring->radius, 0.25f * 0.9f, 1e-5f );
	const Shape* words = findShape( shape_text, sole_colorText );
	assert_non_null( words );
	assert_string_equal( words->text, "left, planted" );
	testEndRun( &take.run );
}

static void ringsGoAlongWithTheAnimation( void** state )
{
	(void)state;
	standOnSlope();
	drawTake( sole_drawLock );
	soleVec3 before = findShape( shape_circle, sole_colorRelease )->a;
	soleVec3 anchor = findShape( shape_sphere, sole_colorLock )->a;
	for ( int32_t i = 0; i < 30; ++i )
	{
		take.run.frame.root.translation.x += 0.1f * take.run.frame.timeStep;
		stepTake();
	}
	drawTake( sole_drawLock );
	assert_true( soleDistance( findShape( shape_sphere, sole_colorLock )->a, anchor ) < 1e-5f );
	assert_float_equal( findShape( shape_circle, sole_colorRelease )->a.x - before.x, 0.05f, 1e-3f );
	testEndRun( &take.run );
}

/// A step that was shifted is not strained by that.
static void ringsBeginWhereFeetAreHeld( void** state )
{
	(void)state;
	startStairs();
	float shifted = 0.0f;
	for ( int32_t frame = 0; frame < 240; ++frame )
	{
		walkStairs( frame );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			if ( ( take.run.out.legs[leg].flags & (uint32_t)sole_legCaptured ) != 0 )
			{
				drawTake( sole_drawLock );
				soleVec3 held = take.run.state.legs[leg].lockPoint_w;
				float nearest = 1.0f;
				for ( int32_t i = 0; i < recorder.count; ++i )
				{
					bool ring = recorder.shapes[i].kind == shape_circle;
					soleVec3 apart = soleSub( recorder.shapes[i].a, held );
					apart.y = 0.0f;
					nearest = ring ? fminf( nearest, soleLength( apart ) ) : nearest;
				}
				assert_true( nearest < 0.005f );
				shifted = fmaxf( shifted, soleLength( take.run.state.legs[leg].heldShift ) );
			}
		}
	}
	assert_true( shifted > 0.02f );
	testEndRun( &take.run );
}

static void footholdsAreWhereFeetLand( void** state )
{
	(void)state;
	startStairs();
	int32_t flown = 0;
	soleVec3 promised = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t frame = 0; frame < 150; ++frame )
	{
		walkStairs( frame );
		drawTake( sole_drawFoothold );
		const Shape* ring = findShape( shape_circle, sole_colorFoothold );
		uint32_t planned = ( take.run.out.legs[0].flags | take.run.out.legs[1].flags ) & (uint32_t)sole_legPlanned;
		assert_int_equal( ring != NULL, planned != 0 );
		if ( ring != NULL )
		{
			++flown;
			promised = ring->a;
			assert_float_equal( ring->a.y, testGroundHeight( &take.run.ground, ring->a.x, ring->a.z ), 2e-3f );
			const Shape* way = findShape( shape_line, sole_colorWay );
			assert_non_null( way );
		}
		else if ( flown > 0 )
		{
			break;
		}
	}
	assert_true( flown > 10 );
	float nearest = 1.0f;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		soleVec3 ball = soleRig_GetLeg( take.run.biped.rig, leg ).sole.ball;
		nearest = fminf( nearest, soleDistance( testPlacedPoint( &take.run, leg, ball, true ), promised ) );
	}
	assert_true( nearest < 0.01f );
	testEndRun( &take.run );
}

static void eachCategoryIsDrawnAlone( void** state )
{
	(void)state;
	int32_t count;
	const soleDrawInfo* infos = soleGetDrawInfos( &count );
	assert_int_equal( count, 13 );
	uint32_t all = 0;
	startStairs();
	for ( int32_t frame = 0; frame < 60; ++frame )
	{
		walkStairs( frame );
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		uint32_t category = (uint32_t)infos[i].category;
		assert_true( strlen( infos[i].name ) > 0 && infos[i].text[strlen( infos[i].text ) - 1] == '.' );
		assert_int_equal( all & category, 0 );
		all |= category;
		drawTake( category );
		assert_true( recorder.count > 0 );
		for ( int32_t k = 0; k < recorder.count; ++k )
		{
			assert_int_equal( recorder.shapes[k].category, category );
		}
	}
	assert_int_equal( all, SOLE_DRAW_ALL );
	drawTake( 0 );
	assert_int_equal( recorder.count, 0 );
	testEndRun( &take.run );
}

static void callbacksThatAreNotThereAreNotCalled( void** state )
{
	(void)state;
	standOnSlope();
	soleDebugDraw draw = soleDefaultDebugDraw();
	assert_int_equal( draw.mask, SOLE_DRAW_ALL );
	soleDrawnFrame drawn = {
		.rig = take.run.biped.rig, .settings = &take.run.settings, .state = &take.before, .frame = &take.run.frame
	};
	soleDrawFrame( &draw, &drawn );
	draw.text = onText;
	draw.user = &recorder;
	recorder.count = 0;
	soleDrawFrame( &draw, &drawn );
	assert_int_equal( recorder.count, 2 );
	testEndRun( &take.run );
}

/// The recorder refuses all that is not finite.
static void badFramesDrawNothing( void** state )
{
	(void)state;
	standOnSlope();
	soleTransform root = take.run.frame.root;
	take.run.frame.root.translation.x = NAN;
	drawTake( SOLE_DRAW_ALL );
	assert_int_equal( recorder.count, 0 );
	take.run.frame.root = root;
	take.run.pose[biped_kneeL].rotation.x = NAN;
	take.run.pose[biped_kneeL].translation.y = INFINITY;
	take.probes[0].start_w.x = NAN;
	take.hits[1].point_w.y = NAN;
	take.hits[2].normal_w.y = NAN;
	drawTake( SOLE_DRAW_ALL & ~(uint32_t)sole_drawFlags );
	for ( int32_t i = 0; i < recorder.count; ++i )
	{
		bool joint = recorder.shapes[i].color == (uint32_t)sole_colorJoint;
		assert_true( joint == false || recorder.shapes[i].a.x < root.translation.x + 0.5f );
	}
	soleVec3 hip = testAnimatedJoint( &take.run, biped_hipR ).translation;
	assert_int_equal( countNear( shape_line, sole_colorAnimated, hip ), 1 );
	hip = testAnimatedJoint( &take.run, biped_hipL ).translation;
	assert_int_equal( countNear( shape_line, sole_colorAnimated, hip ), 0 );
	testEndRun( &take.run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( bonesAreWhereThePoseIs ),
		cmocka_unit_test( stretchedBonesAreWhereThePoseIs ),
		cmocka_unit_test( solesAndTargetsAreThoseOfTheOutput ),
		cmocka_unit_test( probesEndAtTheirHits ),
		cmocka_unit_test( missesAreToldApart ),
		cmocka_unit_test( probesThatStartInsideGoNowhere ),
		cmocka_unit_test( theInnerRingIsAsWideAsThePlaneIsSure ),
		cmocka_unit_test( locksAreWhereFeetAreHeld ),
		cmocka_unit_test( ringsGoAlongWithTheAnimation ),
		cmocka_unit_test( ringsBeginWhereFeetAreHeld ),
		cmocka_unit_test( footholdsAreWhereFeetLand ),
		cmocka_unit_test( eachCategoryIsDrawnAlone ),
		cmocka_unit_test( callbacksThatAreNotThereAreNotCalled ),
		cmocka_unit_test( badFramesDrawNothing ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
