// SPDX-License-Identifier: MIT
// The pose of one moment. Character space unless a name says otherwise: metres, y up, forward +z, left +x.
//
// What a host does to its clips before Sole sees them: blends them, warps their strides to another length, lowers the
// hips while the feet stay. Feet keep their rotation, legs are bent again about their own hinges.
#include "test.h"

#include "scene_pose.h"

#define STANCE 0.615 // share of a stride of the walk in which a foot is down

static const soleTransform* testGetBone( const soleTransform* joints, const soleLegDef* leg, int32_t index )
{
	return joints + leg->joints[index];
}

static void testFindModel( const toolCharacter* character, const soleTransform* pose, soleTransform* joints )
{
	for ( int32_t i = 0; i < character->jointCount; ++i )
	{
		int32_t parent = character->parents[i];
		assert_true( parent < i );
		joints[i] = parent == SOLE_NONE ? pose[i] : soleMulTransform( joints[parent], pose[i] );
	}
}

/// Length of two steps of a gait's clip.
static double testGetOwnStride( const testActor* actor, soleGait gait )
{
	double speed = (double)soleLength( actor->travels[gait].strideVelocity );
	return speed < 0.05 ? 0.0 : speed * (double)actor->clips[gait].duration;
}

double testGetStride( const testActor* actor, const soleSceneMoment* moment )
{
	double own = testGetOwnStride( actor, moment->gait );
	return moment->scale * ( own > 0.0 && moment->stride > 0.0 ? moment->stride : own );
}

double testGetClipTime( const testActor* actor, soleGait gait, const soleSceneMoment* moment, double time )
{
	soleSceneMoment other = *moment;
	other.gait = gait;
	double stride = testGetStride( actor, &other );
	double rounds = stride > 0.0 ? moment->way / stride : 0.0;
	return stride > 0.0 ? ( rounds - floor( rounds ) ) * (double)actor->clips[gait].duration : time;
}

/// How far a foot of the walk is ahead of the middle of its stance, as it would be if strides were of length 1; goes
/// back evenly in stance and swings ahead without a break in its speed.
static double testGetStridePart( double phase )
{
	double t = phase - floor( phase );
	if ( t < STANCE )
	{
		return 0.5 * STANCE - t;
	}
	double swing = 1.0 - STANCE;
	double s = ( t - STANCE ) / swing;
	double rise = s * s * ( 3.0 - 2.0 * s );
	double bow = s * ( 1.0 - s ) * ( 1.0 - 2.0 * s );
	return STANCE * ( rise - 0.5 ) - swing * bow;
}

double testGetStrideShift( const testActor* actor, const soleSceneMoment* moment, double clipTime, int32_t side )
{
	double phase = clipTime / (double)actor->clips[moment->gait].duration + 0.5 * side;
	double longer = moment->stride > 0.0 ? moment->stride - testGetOwnStride( actor, moment->gait ) : 0.0;
	return longer * testGetStridePart( phase );
}

/// Bends one leg so that its foot comes to a place; the toes keep their rotation.
static void testReach( const toolCharacter* character, const soleLegDef* leg, soleTransform foot, soleTransform* pose )
{
	soleTransform joints[128];
	testFindModel( character, pose, joints );
	soleTransform hip = *testGetBone( joints, leg, 0 );
	soleTransform knee = *testGetBone( joints, leg, 1 );
	soleTransform bind = toolPoseWorld( character, character->bindPose, leg->joints[0] );
	soleTwoBoneDef def = {
		.hip = hip.translation,
		.knee = knee.translation,
		.ankle = testGetBone( joints, leg, 2 )->translation,
		.target = foot.translation,
		.hinge = soleRotate(
		    hip.rotation, soleInvRotate( bind.rotation, soleNormalizeOr( leg->hinge, soleVec( 1.0f, 0.0f, 0.0f ) ) ) ),
		.reach = 0.999f,
		.fold = 0.1f,
	};
	soleTwoBoneResult bent = soleSolveTwoBone( &def );
	soleQuat thigh = soleMulQuat( bent.hip, hip.rotation );
	soleQuat shin = soleMulQuat( soleMulQuat( bent.hip, bent.knee ), knee.rotation );
	int32_t parent = character->parents[leg->joints[0]];
	pose[leg->joints[0]].rotation = soleMulQuat( soleConjugate( joints[parent].rotation ), thigh );
	pose[leg->joints[1]].rotation = soleMulQuat( soleConjugate( thigh ), shin );
	pose[leg->joints[2]].rotation = soleMulQuat( soleConjugate( shin ), foot.rotation );
	pose[leg->toes[0]].rotation = soleMulQuat( soleConjugate( foot.rotation ), joints[leg->toes[0]].rotation );
}

/// On a heel: turned about the toe joint, by how much steeper the line from ball to heel is.
static soleTransform testRaiseHeel( const soleLegDef* leg, const soleTransform* joints, double heel )
{
	soleTransform foot = *testGetBone( joints, leg, 2 );
	soleVec3 toe = joints[leg->toes[0]].translation;
	double length = (double)soleDistance( leg->sole.heel, leg->sole.ball );
	double half = 0.5 * atan2( heel, length );
	soleQuat turn = { (float)sin( half ), 0.0f, 0.0f, (float)cos( half ) };
	foot.translation = soleAdd( toe, soleRotate( turn, soleSub( foot.translation, toe ) ) );
	foot.rotation = soleMulQuat( turn, foot.rotation );
	return foot;
}

static void testMoveBody(
    const toolCharacter* character, const soleSceneMoment* moment, const soleVec3 feet[2], soleTransform* pose )
{
	soleTransform joints[128];
	assert_true( character->jointCount <= 128 && character->rigDef.legCount == 2 );
	testFindModel( character, pose, joints );
	int32_t pelvis = character->rigDef.pelvis;
	int32_t parent = character->parents[pelvis];
	soleVec3 hips = moment->hips;
	soleTransform goals[2];
	float longer = (float)( moment->legs - 1.0 );
	for ( int side = 0; side < 2; ++side )
	{
		const soleLegDef* leg = character->rigDef.legs + side;
		goals[side] = testRaiseHeel( leg, joints, moment->heel );
		// Who is on heels or has longer legs is taller.
		hips.y += 0.5f * longer * ( joints[leg->joints[0]].translation.y - joints[leg->joints[2]].translation.y );
		hips.y += 0.5f * ( goals[side].translation.y - testGetBone( joints, leg, 2 )->translation.y );
		goals[side].translation = soleAdd( goals[side].translation, feet[side] );
		for ( int bone = 1; bone <= 2; ++bone )
		{
			soleTransform* local = pose + leg->joints[bone];
			local->translation = soleScale( (float)moment->legs, local->translation );
		}
	}
	pose[pelvis].translation = soleAdd( pose[pelvis].translation, soleInvRotate( joints[parent].rotation, hips ) );
	for ( int side = 0; side < 2; ++side )
	{
		testReach( character, character->rigDef.legs + side, goals[side], pose );
	}
}

static bool testIsZero( soleVec3 v )
{
	return soleDot( v, v ) == 0.0f;
}

void testMakePose( const testActor* actor, const soleSceneMoment* moment, double time, soleTransform* pose )
{
	const toolCharacter* character = &actor->character;
	soleTransform own;
	soleTransform other[128];
	double clipTime = testGetClipTime( actor, moment->gait, moment, time );
	toolSampleLooped( character, actor->clips + moment->gait, actor->travels + moment->gait, clipTime, pose, &own );
	soleVec3 feet[2] = { moment->feet[0], moment->feet[1] };
	for ( int side = 0; side < 2; ++side )
	{
		feet[side].z += (float)testGetStrideShift( actor, moment, clipTime, side );
	}
	bool sized = moment->heel != 0.0 || moment->legs != 1.0;
	if ( sized || !testIsZero( moment->hips ) || !testIsZero( feet[0] ) || !testIsZero( feet[1] ) )
	{
		testMoveBody( character, moment, feet, pose );
	}
	if ( moment->blend > 0.0 )
	{
		double otherTime = testGetClipTime( actor, moment->other, moment, time );
		toolSampleLooped(
		    character, actor->clips + moment->other, actor->travels + moment->other, otherTime, other, &own );
		for ( int32_t i = 0; i < character->jointCount; ++i )
		{
			float share = (float)moment->blend;
			pose[i].translation = soleLerp( pose[i].translation, other[i].translation, share );
			pose[i].rotation = soleNlerp( pose[i].rotation, other[i].rotation, share );
		}
	}
	for ( int32_t i = 0; i < character->jointCount; ++i )
	{
		if ( character->parents[i] == SOLE_NONE )
		{
			pose[i].translation = soleSub( pose[i].translation, moment->base );
		}
	}
}
