// SPDX-License-Identifier: MIT
// Homebrew foot IK 1.5, after its author's description. World space, Y the frame's up, whichever way the ground faces.
//
// A frame has two halves. The first runs before the animation is evaluated, so the bones it finds are those shown in
// the last frame, and the animated height is that of the last frame too. It casts, and sets and filters what the feet
// are to do:
//   f     the root's forward at the start, turned as the ankle has turned since
//   theta pitch of f, toes down positive;  p = f without its part along Y: sin theta = -f.Y, cos theta = |p|
//   phi   slope along the foot: angle to Y of the normal without its part along f x p, never negative
//   rise  l sin( theta - phi ) where that is positive, else 0. The toes of a foot that the animation pitches down would
//         sink; the slope is taken off, else a foot that lies flat downhill would be raised. Formed from sines and
//         cosines: both angles are known as such, and theta - phi is between -180 and 90 degrees, where it is positive
//         exactly when its sine is.
//   y*    ground + r + a + rise + offset: the ankle stands for the middle of the resting sphere. Where the animated
//         height is over that by the floor range or more, the animated height is wanted instead. That is the height
//         as carried by the body, else a foot that stands lower than the root would count as lifted, and a weight would
//         change something of a lifted foot, both of which the description denies.
// Spring, with time constant T ("smooth damp"), w = 2 / T, x = w dt, E = 1 / ( 1 + x + 0.48 x^2 + 0.235 x^3 ), an
// approximation of exp( -x ):  c = h - y*,  t = ( v + w c ) dt,  v <- ( v - w t ) E,  h <- y* + ( c + t ) E.
// It depends on the frame rate a little, and goes on running while its target jumps.
//
// The second half runs on the animated pose: the goal is the animated ankle with the filtered height; the foot is
// turned by the shortest rotation from the root's up to the filtered normal; the body goes by
//   clamp( e, -crouch, stretch ) - e,  e = root height - lowest ground under a foot
// at once, without a filter.
//
// Known faults are kept: casts and angles feed back by a frame, phi has no sign, nothing limits reach, slope, step or
// speed, no foot is locked. What the description leaves open: the springs start at their first target; a normal beyond
// the largest angle is brought onto the cone; a weight between 0 and 1 blends with the animation that has moved with
// the body.
#include "baselines/homebrew.h"

#include <string.h>

#define LOWEST_LAYER 1u
#define LEAST_SMOOTH_TIME 1e-4f

// What the first half of a frame finds out about a foot.
typedef struct soleHomebrewGround
{
	float height;
	soleVec3 normal;
} soleHomebrewGround;

// What all legs share in a frame.
typedef struct soleHomebrewWork
{
	const soleRig* rig;
	const soleHomebrewSettings* settings;
	const soleFrame* frame;
	soleVec3 up;
	float timeStep;
	float rootHeight;
} soleHomebrewWork;

soleHomebrewSettings soleDefaultHomebrewSettings( void )
{
	return ( soleHomebrewSettings ){
		.globalWeight = 1.0f,
		.leftFootWeight = 1.0f,
		.rightFootWeight = 1.0f,
		.smoothTime = 0.08f,
		.raySphereRadius = 0.05f,
		.ankleHeightOffset = 0.03f,
		.lengthFromHeelToToes = 0.19f,
		.maxRotationAngle = 45.0f,
		.rayCastRange = 1.2f,
		.leftFootRaycastStartHeight = 0.5f,
		.rightFootRaycastStartHeight = 0.5f,
		.floorRange = 0.1f,
		.crouchRange = 0.25f,
		.enableFootRotation = true,
		.enableFootLifting = true,
		.enableBodyPositioning = true,
	};
}

void soleFitHomebrewSettings( const soleRig* rig, soleHomebrewSettings* settings )
{
	soleHomebrewSettings human = soleDefaultHomebrewSettings();
	float size = soleGetBaselineSize( rig );
	settings->raySphereRadius = size * human.raySphereRadius;
	settings->ankleHeightOffset = soleGetBaselineAnkleHeight( rig, 0 ) - settings->raySphereRadius;
	settings->lengthFromHeelToToes = soleGetBaselineSoleLength( rig, 0 );
	settings->rayCastRange = size * human.rayCastRange;
	settings->leftFootRaycastStartHeight = size * human.leftFootRaycastStartHeight;
	settings->rightFootRaycastStartHeight = size * human.rightFootRaycastStartHeight;
	settings->floorRange = size * human.floorRange;
	settings->crouchRange = size * human.crouchRange;
	settings->stretchRange = size * human.stretchRange;
}

soleHomebrewState soleDefaultHomebrewState( const soleRig* rig )
{
	soleHomebrewState state;
	memset( &state, 0, sizeof state );
	for ( int32_t i = 0; i < soleRig_GetLegCount( rig ); ++i )
	{
		state.feet[i].startForward = soleGetBaselineFootAxis( rig, i, soleRig_GetForward( rig ) );
	}
	return state;
}

int32_t soleGatherHomebrew( const soleRig* rig, const soleHomebrewSettings* settings, const soleHomebrewState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	soleVec3 up = soleGetBaselineUp( rig, frame );
	int32_t legCount = soleRig_GetLegCount( rig );
	int32_t count = legCount < capacity ? legCount : capacity;
	for ( int32_t i = 0; i < count; ++i )
	{
		soleVec3 ankle = soleGetShownFoot( rig, frame, &state->shown, i ).ankle_w;
		float over = soleIsRightBaselineLeg( rig, i ) ? settings->rightFootRaycastStartHeight
		                                              : settings->leftFootRaycastStartHeight;
		probes[i] = ( soleProbe ){
			.start_w = soleMulAdd( ankle, over, up ),
			.direction_w = soleNeg( up ),
			.length = settings->rayCastRange,
			.radius = settings->raySphereRadius,
			.mask = settings->groundLayers != 0 ? settings->groundLayers : LOWEST_LAYER,
			.leg = (int16_t)i,
		};
	}
	return count;
}

// ------------------------------------------------------------------------------------------------------ first half

/// The normal of a sphere cast is that of the sphere where it touches, which turns smoothly over an edge; a hit tells
/// that of the face. The sphere's middle is over the point by what is left of its radius beside the way down.
static soleVec3 soleFindSphereNormal( const soleHomebrewWork* work, const soleHit* hit )
{
	float radius = work->settings->raySphereRadius;
	soleVec3 beside = soleReject( soleSub( hit->asked_w, hit->point_w ), work->up );
	float squared = radius * radius - soleDot( beside, beside );
	if ( hit->startedInside || !( squared > 0.0f ) )
	{
		return hit->normal_w;
	}
	return soleNormalizeOr( soleMulAdd( beside, soleSqrtF( squared ), work->up ), hit->normal_w );
}

static soleHomebrewGround soleReadGround( const soleHomebrewWork* work, const soleHit* hitOrNull )
{
	if ( hitOrNull == NULL || hitOrNull->hit == false )
	{
		return ( soleHomebrewGround ){ work->rootHeight, work->up };
	}
	return ( soleHomebrewGround ){ soleDot( hitOrNull->point_w, work->up ), soleFindSphereNormal( work, hitOrNull ) };
}

/// How far the ankle has to be raised for the pitch that the animation gives the foot.
static float soleFindRise( const soleHomebrewWork* work, soleVec3 forward, soleVec3 normal )
{
	float sinTheta = -soleDot( forward, work->up );
	soleVec3 level = soleMulAdd( forward, sinTheta, work->up );
	float cosTheta = soleLength( level );
	// A foot that is level to the last digit has no such axis: phi is then the whole slope, which only lowers alpha.
	soleVec3 across = soleNormalizeOr( soleCross( forward, level ), soleVec( 0.0f, 0.0f, 0.0f ) );
	soleVec3 along = soleNormalizeOr( soleReject( normal, across ), work->up );
	float cosPhi = soleDot( along, work->up );
	float sinPhi = soleLength( soleCross( along, work->up ) );
	float sinAlpha = sinTheta * cosPhi - cosTheta * sinPhi;
	return sinAlpha > 0.0f ? work->settings->lengthFromHeelToToes * sinAlpha : 0.0f;
}

/// One step of the spring for one number.
static float soleSmoothDamp( const soleHomebrewWork* work, float current, float target, float* velocity )
{
	float w = 2.0f / soleMaxF( work->settings->smoothTime, LEAST_SMOOTH_TIME );
	float x = w * work->timeStep;
	float decay = 1.0f / ( 1.0f + x + 0.48f * x * x + 0.235f * x * x * x );
	float change = current - target;
	float step = ( *velocity + w * change ) * work->timeStep;
	*velocity = ( *velocity - w * step ) * decay;
	return target + ( change + step ) * decay;
}

static void soleFilterFoot(
    const soleHomebrewWork* work, bool started, float height, soleVec3 normal, soleHomebrewFoot* foot )
{
	if ( started == false )
	{
		foot->height = height;
		foot->normal = normal;
		return;
	}
	foot->height = soleSmoothDamp( work, foot->height, height, &foot->heightVelocity );
	foot->normal.x = soleSmoothDamp( work, foot->normal.x, normal.x, &foot->normalVelocity.x );
	foot->normal.y = soleSmoothDamp( work, foot->normal.y, normal.y, &foot->normalVelocity.y );
	foot->normal.z = soleSmoothDamp( work, foot->normal.z, normal.z, &foot->normalVelocity.z );
}

/// Where a foot is to go, filtered. @return whether the animation has lifted it
static bool soleUpdateFoot( const soleHomebrewWork* work, const soleHomebrewState* state, int32_t leg,
    soleHomebrewGround ground, soleHomebrewFoot* foot )
{
	const soleHomebrewSettings* settings = work->settings;
	soleQuat shown = soleGetShownFoot( work->rig, work->frame, &state->shown, leg ).foot_w;
	float rise = soleFindRise( work, soleRotate( shown, foot->startForward ), ground.normal );
	float height = ground.height + settings->raySphereRadius + settings->ankleHeightOffset + rise;
	height += settings->enableWorldHeightOffset ? settings->worldHeightOffset : 0.0f;
	bool lifted = settings->enableFootLifting && foot->carriedHeight - height >= settings->floorRange;
	soleFilterFoot( work, state->started, lifted ? foot->carriedHeight : height, ground.normal, foot );
	return lifted;
}

// ----------------------------------------------------------------------------------------------------- second half

/// The filtered normal, no further from the root's up than may be.
static soleVec3 soleLimitNormal( const soleHomebrewWork* work, soleVec3 rootUp, soleVec3 normal )
{
	float angle = SOLE_BASELINE_DEGREE * work->settings->maxRotationAngle;
	soleVec3 n = soleNormalizeOr( normal, rootUp );
	if ( soleDot( n, rootUp ) >= cosf( angle ) )
	{
		return n;
	}
	soleVec3 side = soleNormalizeOr( soleReject( n, rootUp ), soleAnyOrthogonal( rootUp ) );
	return soleMulAdd( soleScale( cosf( angle ), rootUp ), sinf( angle ), side );
}

static soleQuat soleTurnFoot( const soleHomebrewWork* work, const soleHomebrewFoot* foot, soleQuat animated )
{
	if ( work->settings->enableFootRotation == false )
	{
		return animated;
	}
	soleQuat root = soleNormalizeQuat( work->frame->root.rotation );
	soleVec3 rootUp = soleRotate( root, soleRig_GetUp( work->rig ) );
	soleVec3 normal = soleLimitNormal( work, rootUp, foot->normal );
	soleVec3 forward = soleRotate( root, soleRig_GetForward( work->rig ) );
	return soleMulQuat( soleFromTo( rootUp, normal, forward ), animated );
}

static float soleGetFootWeight( const soleHomebrewWork* work, int32_t leg )
{
	const soleHomebrewSettings* settings = work->settings;
	float side = soleIsRightBaselineLeg( work->rig, leg ) ? settings->rightFootWeight : settings->leftFootWeight;
	float weight = soleClampF( settings->globalWeight * side, 0.0f, 1.0f );
	return weight * soleGetBaselineWeight( work->frame, leg );
}

static soleVec3 soleFindBodyOffset( const soleHomebrewWork* work, float lowestGround )
{
	const soleHomebrewSettings* settings = work->settings;
	float over = work->rootHeight - lowestGround;
	float offset = soleClampF( over, -settings->crouchRange, settings->stretchRange ) - over;
	offset = settings->enableBodyPositioning ? offset : 0.0f;
	return soleScale( soleGetBaselineWeight( work->frame, SOLE_NONE ) * offset, work->up );
}

static void soleApplyFoot( const soleHomebrewWork* work, soleHomebrewFoot* foot, int32_t leg, soleVec3 bodyOffset,
    soleShownFeet* shown, soleLegOutput* output )
{
	soleBaselineLeg animated = soleReadBaselineLeg( work->rig, work->frame, leg );
	float animatedHeight = soleDot( animated.ankle_w, work->up );
	foot->carriedHeight = animatedHeight + soleDot( bodyOffset, work->up );
	float weight = soleGetFootWeight( work, leg );
	soleVec3 goal = soleMulAdd( animated.ankle_w, foot->height - animatedHeight, work->up );
	soleQuat turned = soleTurnFoot( work, foot, animated.foot_w.rotation );
	soleBaselineGoal wanted = {
		.pelvisOffset_w = bodyOffset,
		.ankle_w = soleLerp( soleAdd( animated.ankle_w, bodyOffset ), goal, weight ),
		.foot_w = soleNlerp( animated.foot_w.rotation, turned, weight ),
	};
	soleBaselineGoal placed = solePlaceBaselineLeg( work->rig, work->frame, &animated, &wanted, output );
	soleKeepShownFoot( work->frame, &placed, leg, shown );
}

void soleSolveHomebrew( const soleRig* rig, const soleHomebrewSettings* settings, soleHomebrewState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, soleOutput* output )
{
	soleHomebrewWork work = { .rig = rig, .settings = settings, .frame = frame };
	work.up = soleGetBaselineUp( rig, frame );
	work.timeStep = soleGetBaselineTimeStep( frame );
	work.rootHeight = soleDot( soleGetBaselineRoot( rig, frame ).translation, work.up );
	soleStartBaselineOutput( rig, frame, output );
	float lowestGround = work.rootHeight;
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		const soleHit* hit = i < hitCount ? hits + i : NULL;
		soleHomebrewFoot* foot = state->feet + i;
		if ( state->started == false )
		{
			foot->carriedHeight = soleDot( soleReadBaselineLeg( rig, frame, i ).ankle_w, work.up );
		}
		soleHomebrewGround ground = soleReadGround( &work, hit );
		bool lifted = soleUpdateFoot( &work, state, i, ground, foot );
		lowestGround = i == 0 ? ground.height : soleMinF( lowestGround, ground.height );
		soleWriteBaselineGround( rig, frame, hit, output->legs + i );
		output->legs[i].plantWeight = lifted ? 0.0f : soleGetFootWeight( &work, i );
	}
	soleVec3 bodyOffset = soleFindBodyOffset( &work, lowestGround );
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		soleApplyFoot( &work, state->feet + i, i, bodyOffset, &state->shown, output->legs + i );
	}
	state->started = true;
	soleWriteBaselinePelvis( rig, frame, bodyOffset, output );
}
