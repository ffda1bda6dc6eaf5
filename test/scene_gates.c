// SPDX-License-Identifier: MIT
// The gates, measured from input and output poses alone. World space, metres; angles in degrees.
#include "test.h"

#include "scene_meter.h"

#define DEGREES 57.29577951308232
#define POINT_STEP 3     // of the dense rows of sole points every third is looked at
#define REST 1.0         // s
#define HALF_WIDTH 0.045 // of a foot

static double testGetAngle( soleQuat a, soleQuat b )
{
	soleQuat q = soleMulQuat( soleConjugate( a ), b );
	double sine = sqrt( (double)( q.x * q.x + q.y * q.y + q.z * q.z ) );
	return 2.0 * DEGREES * atan2( sine, fabs( (double)q.w ) );
}

static double testGetVectorAngle( soleVec3 a, soleVec3 b )
{
	return DEGREES * atan2( (double)soleLength( soleCross( a, b ) ), (double)soleDot( a, b ) );
}

// -------------------------------------------------------------------------------------------------------------- poses

static void testFindLeg(
    const testRun* run, int32_t frame, int32_t side, const soleTransform* joints, testLegPose* leg )
{
	const toolCharacter* character = &run->actor->character;
	const soleRig* rig = run->rigs[frame];
	soleLegDef def = soleRig_GetLeg( rig, side );
	soleVec3 bindPoints[test_solePoints] = { def.sole.heel, def.sole.ball, def.sole.toe };
	leg->hip = joints[def.joints[0]].translation;
	leg->knee = joints[def.joints[1]].translation;
	leg->foot = joints[def.joints[2]];
	for ( int i = 0; i < test_solePoints; ++i )
	{
		bool fore = i != test_heel;
		soleVec3 local = soleRig_ToFootSpace( rig, side, bindPoints[i], fore );
		leg->sole[i] = soleTransformPoint( joints[soleRig_GetFootJoint( rig, side, fore )], local );
	}
	soleQuat bind = toolPoseWorld( character, character->bindPose, def.joints[0] ).rotation;
	leg->hinge = soleRotate( joints[def.joints[0]].rotation, soleInvRotate( bind, def.hinge ) );
}

void testFindBody( const testRun* run, int32_t frame, const soleTransform* poses, testBodyPose* body )
{
	testFindJoints( run, frame, poses + (size_t)frame * (size_t)run->jointCount, body->joints );
	body->pelvis = body->joints[run->actor->character.rigDef.pelvis];
	for ( int32_t side = 0; side < 2; ++side )
	{
		testFindLeg( run, frame, side, body->joints, body->legs + side );
	}
}

/// Feet, or the pelvis where there is no leg.
static soleTransform testGetPart( const testBodyPose* body, int32_t leg )
{
	return leg == SOLE_NONE ? body->pelvis : body->legs[leg].foot;
}

// ------------------------------------------------------------------------------------------------------------ changes

static double testGetClimb( const testRun* run, int32_t frame )
{
	bool within = frame > 0 && frame < run->frameCount;
	return within ? (double)( run->roots[frame].translation.y - run->roots[frame - 1].translation.y ) : 0.0;
}

/// How far the root goes up at once in a frame: beyond the middle one of what it climbs in five frames around. A body
/// that shakes on stairs with its root does not change as the input does.
static float testGetRootStep( const testRun* run, int32_t frame )
{
	double climbs[5];
	for ( int32_t i = 0; i < 5; ++i )
	{
		double climb = testGetClimb( run, frame + i - 2 );
		int32_t k = i;
		for ( ; k > 0 && climbs[k - 1] > climb; --k )
		{
			climbs[k] = climbs[k - 1];
		}
		climbs[k] = climb;
	}
	return (float)( testGetClimb( run, frame ) - climbs[2] );
}

/// G4: how much more a foot or the pelvis changes than in the input.
static void testMeasureChange( testMeter* meter, int32_t frame, int32_t leg )
{
	// The gate is for 60 Hz; a longer frame may change more.
	double frames = fmax( 60.0 * meter->run->steps[frame], 1.0 );
	soleTransform in[2] = { testGetPart( meter->in, leg ), testGetPart( meter->in + 1, leg ) };
	soleTransform out[2] = { testGetPart( meter->out, leg ), testGetPart( meter->out + 1, leg ) };
	in[1].translation.y -= testGetRootStep( meter->run, frame );
	double move = (double)( soleDistance( out[1].translation, out[0].translation ) -
	    soleDistance( in[1].translation, in[0].translation ) );
	double turn = testGetAngle( out[0].rotation, out[1].rotation ) - testGetAngle( in[0].rotation, in[1].rotation );
	testRaise( meter, frame, leg, move / frames, &meter->gates->move );
	testRaise( meter, frame, leg, turn / frames, &meter->gates->turn );
}

static void testMeasureAway( testMeter* meter, int32_t frame, int32_t leg )
{
	soleTransform in = testGetPart( meter->in + 1, leg );
	soleTransform out = testGetPart( meter->out + 1, leg );
	double away = (double)soleDistance( in.translation, out.translation );
	testRaise( meter, frame, leg, away, &meter->gates->away );
	testRaise( meter, frame, leg, testGetAngle( in.rotation, out.rotation ), &meter->gates->awayTurn );
}

/// G5
static void testMeasureRest( testMeter* meter, int32_t frame, int32_t leg )
{
	const testRun* run = meter->run;
	testRest* rest = meter->rests + leg;
	soleTransform foot = meter->out[1].legs[leg].foot;
	if ( run->moments[frame].resting == false )
	{
		rest->running = false;
		return;
	}
	if ( rest->running == false )
	{
		*rest = ( testRest ){ .running = true, .since = run->times[frame] };
	}
	soleVec3 p = foot.translation;
	if ( run->times[frame] < rest->since + REST )
	{
		rest->low = rest->high = p;
		rest->first = foot.rotation;
		return;
	}
	rest->low = soleVec( soleMinF( rest->low.x, p.x ), soleMinF( rest->low.y, p.y ), soleMinF( rest->low.z, p.z ) );
	rest->high = soleVec( soleMaxF( rest->high.x, p.x ), soleMaxF( rest->high.y, p.y ), soleMaxF( rest->high.z, p.z ) );
	soleVec3 size = soleSub( rest->high, rest->low );
	double widest = (double)soleMaxF( size.x, soleMaxF( size.y, size.z ) );
	testRaise( meter, frame, leg, widest, &meter->gates->rest );
	testRaise( meter, frame, leg, testGetAngle( rest->first, foot.rotation ), &meter->gates->restTurn );
}

// --------------------------------------------------------------------------------------------------------------- legs

testKnee testFindKnee( const testLegPose* leg )
{
	soleVec3 thigh = soleSub( leg->knee, leg->hip );
	soleVec3 shin = soleSub( leg->foot.translation, leg->knee );
	testKnee knee = { .normal = soleCross( thigh, shin ) };
	double side = soleDot( knee.normal, leg->hinge ) < 0.0f ? -1.0 : 1.0;
	knee.bend = side * testGetVectorAngle( thigh, shin );
	double bones = (double)( soleLength( thigh ) + soleLength( shin ) );
	knee.reach = (double)soleDistance( leg->hip, leg->foot.translation ) / bones;
	return knee;
}

/// G6 and the reach of G7.
static void testMeasureLeg( testMeter* meter, int32_t frame, int32_t leg )
{
	testKnee in = testFindKnee( meter->in[1].legs + leg );
	testKnee out = testFindKnee( meter->out[1].legs + leg );
	testGates* gates = meter->gates;
	testRaise( meter, frame, leg, fmin( in.bend, 2.0 ) - out.bend, &gates->straight );
	testRaise( meter, frame, leg, out.bend, &gates->folded );
	testRaise( meter, frame, leg, testGetVectorAngle( in.normal, out.normal ), &gates->plane );
	testRaise( meter, frame, leg, out.reach - fmax( in.reach, 0.995 ), &gates->reach );
	double step = meter->run->steps[frame];
	if ( frame > 0 && step > 0.0 )
	{
		double inRate = fabs( in.bend - testFindKnee( meter->in[0].legs + leg ).bend ) / step;
		double outRate = fabs( out.bend - testFindKnee( meter->out[0].legs + leg ).bend ) / step;
		meter->kneeRates[0] = fmax( meter->kneeRates[0], inRate );
		meter->kneeRates[1] = fmax( meter->kneeRates[1], outRate );
	}
}

/// Heading of a foot against the pelvis, outwards.
static void testMeasureYaw( testMeter* meter, int32_t frame, int32_t leg )
{
	const testBodyPose* out = meter->out + 1;
	soleVec3 ahead = soleRotate( out->pelvis.rotation, soleVec( 0.0f, 0.0f, 1.0f ) );
	soleVec3 foot = soleSub( out->legs[leg].sole[test_ball], out->legs[leg].sole[test_heel] );
	double across = (double)( ahead.z * foot.x - ahead.x * foot.z );
	double along = (double)( ahead.x * foot.x + ahead.z * foot.z );
	if ( foot.y * foot.y > 0.5f * soleDot( foot, foot ) )
	{
		return; // points up or down rather than anywhere
	}
	double yaw = DEGREES * atan2( leg == 0 ? across : -across, along );
	testRaise( meter, frame, leg, fmax( yaw - 60.0, -30.0 - yaw ), &meter->gates->yaw );
}

static double testGetPointDistance( soleVec3 p, soleVec3 a, soleVec3 b )
{
	double dx = (double)( b.x - a.x );
	double dz = (double)( b.z - a.z );
	double px = (double)( p.x - a.x );
	double pz = (double)( p.z - a.z );
	double t = ( px * dx + pz * dz ) / fmax( dx * dx + dz * dz, 1e-12 );
	t = t < 0.0 ? 0.0 : ( t > 1.0 ? 1.0 : t );
	return hypot( px - t * dx, pz - t * dz );
}

/// Outlines: all that is half a foot's width around the line from heel to toe tip, seen from above.
static void testMeasureApart( testMeter* meter, int32_t frame )
{
	const soleVec3* left = meter->out[1].legs[0].sole;
	const soleVec3* right = meter->out[1].legs[1].sole;
	double a = fmin( testGetPointDistance( left[test_heel], right[test_heel], right[test_toe] ),
	    testGetPointDistance( left[test_toe], right[test_heel], right[test_toe] ) );
	double b = fmin( testGetPointDistance( right[test_heel], left[test_heel], left[test_toe] ),
	    testGetPointDistance( right[test_toe], left[test_heel], left[test_toe] ) );
	double width = HALF_WIDTH * meter->run->moments[frame].scale;
	testRaise( meter, frame, SOLE_NONE, 2.0 * width - fmin( a, b ), &meter->gates->overlap );
}

// --------------------------------------------------------------------------------------------------------------- whole

testGates testStartGates( void )
{
	testGates gates = { .finite = true, .same = true };
	gates.straight.value = -180.0;
	gates.reach.value = -1.0;
	gates.yaw.value = -180.0;
	gates.overlap.value = -1.0;
	return gates;
}

static void testTakePoints( testMeter* meter, const soleRig* rig )
{
	if ( meter->rig == rig )
	{
		return;
	}
	soleMeasurePoint all[8 * MOST_POINTS];
	int32_t count = soleMakeMeasurePoints( rig, all, 8 * MOST_POINTS );
	assert_true( count <= 8 * MOST_POINTS );
	meter->rig = rig;
	meter->pointCount = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		// Rows of three; the first and the last of each leg always.
		bool end = i < 3 || i + 3 >= count || all[i].leg != all[i - 3].leg || all[i].leg != all[i + 3].leg;
		if ( end || i / 3 % POINT_STEP == 0 )
		{
			assert_true( meter->pointCount < MOST_POINTS );
			meter->points[meter->pointCount] = all[i];
			meter->pointCount += 1;
		}
	}
}

static void testMeasureFrame( testMeter* meter, int32_t frame )
{
	const testRun* run = meter->run;
	bool jumps = frame > 0 && run->moments[frame].jumps != run->moments[frame - 1].jumps;
	for ( int32_t leg = SOLE_NONE; leg < run->legCount; ++leg )
	{
		testMeasureAway( meter, frame, leg );
		if ( frame > 0 && jumps == false )
		{
			testMeasureChange( meter, frame, leg );
		}
	}
	for ( int32_t leg = 0; leg < run->legCount; ++leg )
	{
		testMeasureSole( meter, frame, leg );
		testMeasureRest( meter, frame, leg );
		testMeasureLeg( meter, frame, leg );
		testMeasureYaw( meter, frame, leg );
	}
	testMeasureApart( meter, frame );
}

/// Steps that a run's clips make: two a stride.
static double testCountClipPlants( const testRun* run )
{
	double count = 0.0;
	for ( int32_t i = 1; i < run->frameCount; ++i )
	{
		const soleSceneMoment* moment = run->moments + i;
		double stride = testGetStride( run->actor, moment );
		count += stride > 0.0 ? 2.0 * fabs( moment->way - moment[-1].way ) / stride : 0.0;
	}
	return count > 0.0 ? count : (double)run->legCount;
}

void testMeasureRun( const testRun* run, testGates* gates )
{
	testMeter* meter = calloc( 1, sizeof *meter );
	assert_non_null( meter );
	assert_true( run->jointCount <= MOST_JOINTS && run->legCount == 2 );
	meter->run = run;
	meter->gates = gates;
	for ( int32_t i = 0; i < run->frameCount; ++i )
	{
		meter->in[0] = meter->in[1];
		meter->out[0] = meter->out[1];
		testTakePoints( meter, run->rigs[i] );
		testFindBody( run, i, run->input, meter->in + 1 );
		testFindBody( run, i, run->output, meter->out + 1 );
		testMeasureFrame( meter, i );
	}
	testRaise( meter, 0, SOLE_NONE, meter->kneeRates[1] / fmax( meter->kneeRates[0], 60.0 ), &gates->kneeRate );
	gates->clipPlants += testCountClipPlants( run );
	gates->finite = gates->finite && run->finite;
	gates->same = gates->same && testPlaysTheSame( run );
	free( meter );
}

testGates testMeasureAct( const testActor* actor, const testWorld* world, const soleAct* act )
{
	testGates gates = testStartGates();
	for ( int32_t take = 0; take == 0 || take < act->special.takeCount; ++take )
	{
		testRun run;
		testPlay( actor, world, act, take, 0.0, &run );
		testMeasureRun( &run, &gates );
		testFreeRun( &run );
	}
	return gates;
}

uint32_t testFindFailed( const testGates* g )
{
	const struct
	{
		uint32_t gate;
		bool good;
	} gates[] = {
		{ test_g1, g->slide.value <= 1e-3 },
		{ test_g2, g->depth.value <= 5e-3 && g->swingDepth.value <= 10e-3 },
		{ test_g3, g->gap.value <= 5e-3 },
		{ test_g4, g->move.value <= 15e-3 && g->turn.value <= 6.0 },
		{ test_g5, g->rest.value <= 0.2e-3 && g->restTurn.value <= 0.05 },
		{ test_g6, g->straight.value <= 1e-3 && g->folded.value <= 150.0 && g->plane.value <= 60.0 },
		{ test_g7, g->finite && g->reach.value <= 1e-4 },
		{ test_g8, g->same },
		{ test_gFlat, g->flatGap.value <= 5e-3 },
		{ test_gInput, g->away.value <= 1e-3 && g->awayTurn.value <= 0.1 },
		{ test_gLevel, g->awayTurn.value <= 5.0 },
		{ test_gOver, g->overhang.value <= 0.35 },
		{ test_gSilent, g->silent.value <= 5e-3 },
		{ test_gYaw, g->yaw.value <= 0.0 },
		{ test_gApart, g->overlap.value <= 0.0 },
		{ test_gKnee, g->kneeRate.value <= 1.5 },
		{ test_gTrue, g->reported.value <= 5e-3 },
		{ test_gPlants, g->plants >= 0.5 * g->clipPlants },
	};
	uint32_t failed = 0;
	for ( size_t i = 0; i < sizeof gates / sizeof gates[0]; ++i )
	{
		failed |= gates[i].good ? 0u : gates[i].gate;
	}
	return failed;
}
