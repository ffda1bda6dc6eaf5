// SPDX-License-Identifier: MIT
// Foot IK of the script "IKSetting", after the walk-through's description. World space, Y the frame's up.
//
// Two clocks. Every 0.02 s, before the frame's animation, so with the bones as they were shown in the last frame:
//   s   place of the foot bone, at the height of the root plus H;  ray down over D + H
//   hit:   g = hit height plus the pelvis offset, under s;  q = R( Y, offset ) FromTo( Y, n ) root rotation
//   miss:  g = 0, q stays
// Several of these steps in one slow frame would ask and find the same, so they are one. Every frame, on the animated
// pose b:
//   body   y = lerp( last y, b + min( g ) - root height, s_p ), unless a g or the last y is zero: then b itself
//   foot   v = lerp( last v, height of g over the root, s_f );  goal = animated ankle + v along the root's up
//   weight of the place: the clip's curve;  of the turn: the same, or 0
// The goal adds to the animation, so a foot keeps the height over the floor that it is animated with.
//
// Zero marks "none" here as in the original, with its fault: ground that is really met at the world's origin and a body
// that is really at height 0 count as none. A flag would behave differently there. The other known faults are kept too:
// lerps per frame depend on the frame rate and slow down what the animation itself does with the body; a fully turned
// foot has the root's heading instead of its own; nothing limits reach, slope, step or pelvis; no foot is locked.
//
// The root is where this frame has it for both clocks. A goal rotation of the original turns the foot of a character
// that stands; here that is the bind pose.
#include "baselines/iksetting.h"

#include <string.h>

// What all legs share in a frame.
typedef struct soleIkSettingWork
{
	const soleRig* rig;
	const soleIkSettingSettings* settings;
	const soleFrame* frame;
	const soleIkSettingCurves* curves;
	soleVec3 up;
	soleTransform root;
} soleIkSettingWork;

soleIkSettingSettings soleDefaultIkSettingSettings( void )
{
	return ( soleIkSettingSettings ){
		.enableFeetIk = true,
		.heightFromGroundRaycast = 1.2f,
		.raycastDownDistance = 1.5f,
		.environmentLayer = UINT32_MAX,
		.pelvisUpAndDownSpeed = 0.28f,
		.feetToIkPositionSpeed = 0.5f,
		.leftFootAnimVariableName = "LeftFoot",
		.rightFootAnimVariableName = "RightFoot",
	};
}

void soleFitIkSettingSettings( const soleRig* rig, soleIkSettingSettings* settings )
{
	soleIkSettingSettings human = soleDefaultIkSettingSettings();
	float size = soleGetBaselineSize( rig );
	settings->heightFromGroundRaycast = size * human.heightFromGroundRaycast;
	settings->raycastDownDistance = size * human.raycastDownDistance;
}

/// The rotation of the foot's joint in the bind pose, from what its two axes are there: the first is brought into place
/// by the shortest rotation, the second by a turn about the first.
static soleQuat soleFindFootBind( const soleRig* rig, int32_t leg )
{
	soleVec3 up = soleRig_GetUp( rig );
	soleVec3 forward = soleRig_GetForward( rig );
	soleQuat swing = soleFromTo( soleGetBaselineFootAxis( rig, leg, up ), up, forward );
	soleVec3 swung = soleReject( soleRotate( swing, soleGetBaselineFootAxis( rig, leg, forward ) ), up );
	soleQuat turn = soleFromTo( soleNormalizeOr( swung, forward ), forward, up );
	return soleMulQuat( turn, swing );
}

soleIkSettingState soleDefaultIkSettingState( const soleRig* rig )
{
	soleIkSettingState state;
	memset( &state, 0, sizeof state );
	state.sinceFixedStep = SOLE_IKSETTING_FIXED_STEP; // the first frame has one
	for ( int32_t i = 0; i < soleRig_GetLegCount( rig ); ++i )
	{
		state.feet[i].bind = soleFindFootBind( rig, i );
		state.feet[i].goalRotation = soleQuat_Identity();
	}
	return state;
}

static bool soleIsZero( soleVec3 v )
{
	return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

/// Seconds since the last fixed step at the end of this frame, were none due in it.
static float soleFindElapsed( const soleIkSettingState* state, const soleFrame* frame )
{
	return state->sinceFixedStep + soleGetBaselineTimeStep( frame );
}

int32_t soleGatherIkSetting( const soleRig* rig, const soleIkSettingSettings* settings, const soleIkSettingState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	if ( settings->enableFeetIk == false || soleFindElapsed( state, frame ) < SOLE_IKSETTING_FIXED_STEP )
	{
		return 0;
	}
	soleVec3 up = soleGetBaselineUp( rig, frame );
	soleVec3 root = soleGetBaselineRoot( rig, frame ).translation;
	int32_t legCount = soleRig_GetLegCount( rig );
	int32_t count = legCount < capacity ? legCount : capacity;
	for ( int32_t i = 0; i < count; ++i )
	{
		soleVec3 foot = soleGetShownFoot( rig, frame, &state->shown, i ).ankle_w;
		float raise = soleDot( soleSub( root, foot ), up ) + settings->heightFromGroundRaycast;
		probes[i] = ( soleProbe ){
			.start_w = soleMulAdd( foot, raise, up ),
			.direction_w = soleNeg( up ),
			.length = settings->raycastDownDistance + settings->heightFromGroundRaycast,
			.mask = settings->environmentLayer,
			.leg = (int16_t)i,
		};
	}
	return count;
}

// ------------------------------------------------------------------------------------------------------ fixed step

static void soleTakeGround(
    const soleIkSettingWork* work, const soleHit* hitOrNull, int32_t leg, soleIkSettingFoot* foot )
{
	const soleIkSettingSettings* settings = work->settings;
	if ( hitOrNull == NULL || hitOrNull->hit == false )
	{
		foot->goalPosition = soleVec( 0.0f, 0.0f, 0.0f );
		return;
	}
	foot->goalPosition = soleMulAdd( hitOrNull->point_w, settings->pelvisOffset, work->up );
	bool right = soleIsRightBaselineLeg( work->rig, leg );
	float half =
	    0.5f * SOLE_BASELINE_DEGREE * ( right ? settings->rightFootAngleOffset : settings->leftFootAngleOffset );
	soleVec3 axis = soleScale( sinf( half ), work->up );
	soleQuat offset = { axis.x, axis.y, axis.z, cosf( half ) };
	soleVec3 forward = soleRotate( work->root.rotation, soleRig_GetForward( work->rig ) );
	soleQuat slope = soleFromTo( work->up, hitOrNull->normal_w, forward );
	foot->goalRotation = soleMulQuat( offset, soleMulQuat( slope, work->root.rotation ) );
}

static void soleRunFixedStep(
    const soleIkSettingWork* work, soleIkSettingState* state, const soleHit* hits, int32_t hitCount )
{
	float elapsed = soleFindElapsed( state, work->frame );
	state->sinceFixedStep = fmodf( elapsed, SOLE_IKSETTING_FIXED_STEP );
	if ( elapsed < SOLE_IKSETTING_FIXED_STEP || work->settings->enableFeetIk == false )
	{
		return;
	}
	for ( int32_t i = 0; i < soleRig_GetLegCount( work->rig ); ++i )
	{
		soleTakeGround( work, i < hitCount ? hits + i : NULL, i, state->feet + i );
	}
}

// ------------------------------------------------------------------------------------------------------ every frame

/// Where the body goes, world, and the height that is remembered of it.
static soleVec3 soleMoveBody( const soleIkSettingWork* work, soleIkSettingState* state )
{
	soleVec3 body_w = soleGetBaselineJoint( work->rig, work->frame, soleRig_GetPelvis( work->rig ) ).translation;
	float body = soleDot( body_w, work->up );
	float rootHeight = soleDot( work->root.translation, work->up );
	bool known = state->lastPelvisHeight != 0.0f;
	float lowest = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( work->rig ); ++i )
	{
		soleVec3 goal = state->feet[i].goalPosition;
		float over = soleDot( goal, work->up ) - rootHeight;
		known = known && soleIsZero( goal ) == false;
		lowest = i == 0 ? over : soleMinF( lowest, over );
	}
	if ( known == false )
	{
		state->lastPelvisHeight = body;
		return soleVec( 0.0f, 0.0f, 0.0f );
	}
	float share = work->settings->pelvisUpAndDownSpeed;
	state->lastPelvisHeight += share * ( body + lowest - state->lastPelvisHeight );
	float offset = state->lastPelvisHeight - body;
	return soleScale( soleGetBaselineWeight( work->frame, SOLE_NONE ) * offset, work->up );
}

static float soleReadCurve( const soleIkSettingWork* work, int32_t leg )
{
	const soleIkSettingSettings* settings = work->settings;
	bool right = soleIsRightBaselineLeg( work->rig, leg );
	const char* name = right ? settings->rightFootAnimVariableName : settings->leftFootAnimVariableName;
	for ( int32_t i = 0; i < work->curves->count; ++i )
	{
		if ( strcmp( work->curves->curves[i].name, name ) == 0 )
		{
			return soleClampF( work->curves->curves[i].value, 0.0f, 1.0f );
		}
	}
	return 0.0f;
}

/// The ankle's goal: the animated one, raised by the filtered height of the ground over the root.
static soleVec3 soleFindGoal( const soleIkSettingWork* work, soleVec3 animated, soleIkSettingFoot* foot )
{
	if ( soleIsZero( foot->goalPosition ) )
	{
		return animated;
	}
	soleVec3 rootUp = soleRig_GetUp( work->rig );
	soleVec3 ground = soleInvTransformPoint( work->root, foot->goalPosition );
	soleVec3 goal = soleInvTransformPoint( work->root, animated );
	float share = work->settings->feetToIkPositionSpeed;
	foot->lastHeight += share * ( soleDot( ground, rootUp ) - foot->lastHeight );
	return soleTransformPoint( work->root, soleMulAdd( goal, foot->lastHeight, rootUp ) );
}

static void soleApplyFoot(
    const soleIkSettingWork* work, int32_t leg, soleVec3 bodyOffset, soleIkSettingState* state, soleLegOutput* output )
{
	soleIkSettingFoot* foot = state->feet + leg;
	soleBaselineLeg animated = soleReadBaselineLeg( work->rig, work->frame, leg );
	float curve = soleReadCurve( work, leg );
	float weight = curve * soleGetBaselineWeight( work->frame, leg );
	float turnWeight = work->settings->useIkFeature ? weight : 0.0f;
	soleVec3 goal = soleFindGoal( work, animated.ankle_w, foot );
	soleQuat turned = soleMulQuat( foot->goalRotation, foot->bind );
	soleBaselineGoal wanted = {
		.pelvisOffset_w = bodyOffset,
		.ankle_w = soleLerp( soleAdd( animated.ankle_w, bodyOffset ), goal, weight ),
		.foot_w = soleNlerp( animated.foot_w.rotation, turned, turnWeight ),
	};
	soleBaselineGoal placed = solePlaceBaselineLeg( work->rig, work->frame, &animated, &wanted, output );
	soleKeepShownFoot( work->frame, &placed, leg, &state->shown );
	output->plantWeight = weight;
}

void soleSolveIkSetting( const soleRig* rig, const soleIkSettingSettings* settings, soleIkSettingState* state,
    const soleFrame* frame, const soleIkSettingCurves* curves, const soleHit* hits, int32_t hitCount,
    soleOutput* output )
{
	soleIkSettingWork work = { .rig = rig, .settings = settings, .frame = frame, .curves = curves };
	work.up = soleGetBaselineUp( rig, frame );
	work.root = soleGetBaselineRoot( rig, frame );
	soleStartBaselineOutput( rig, frame, output );
	soleRunFixedStep( &work, state, hits, hitCount );
	if ( settings->enableFeetIk == false )
	{
		state->shown.known = false; // what is shown is the animation
		return;
	}
	soleVec3 bodyOffset = soleMoveBody( &work, state );
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		// As last met: most frames do not ask.
		soleIkSettingFoot* foot = state->feet + i;
		soleHit ground = { .hit = soleIsZero( foot->goalPosition ) == false, .point_w = foot->goalPosition };
		ground.normal_w = soleRotate( foot->goalRotation, soleRig_GetUp( rig ) );
		soleWriteBaselineGround( rig, frame, &ground, output->legs + i );
		soleApplyFoot( &work, i, bodyOffset, state, output->legs + i );
	}
	soleWriteBaselinePelvis( rig, frame, bodyOffset, output );
}
