// SPDX-License-Identifier: MIT
// Taking in a frame: settings brought into their ranges, input and memory checked to be finite, memory moved along with
// the world's origin or forgotten after a jump. From here on the stages need not ask again.
#include "base/core.h"
#include "place/place.h"

#include <string.h>

#define FORGET_TIME 0.3f // s: after a frame as long as this what is remembered says nothing: no half-life is as long
#define TOES_UP 0.65f    // rise per length: 33 degrees, toes that flip up further on a stone look broken
#define TELEPORT 1.5f    // leg lengths that a root can't move in a frame beyond 20 of them a second

/// Settings in their ranges; the defaults where they were not made by soleDefaultSettings().
const soleSettings* soleCleanSettings( const soleRig* rig, const soleSettings* settings, soleSettings* scratch )
{
	SOLE_ASSERT( settings != NULL && settings->internalValue == SOLE_COOKIE );
	if ( settings == NULL || settings->internalValue != SOLE_COOKIE )
	{
		*scratch = soleDefaultSettings();
		return scratch;
	}
	if ( soleSettings_AreInRange( settings, &rig->settingRanges ) )
	{
		return settings;
	}
	*scratch = *settings;
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		double value = soleSettings_Get( settings, infos + i );
		soleSettings_Set( scratch, infos + i, value - value == 0.0 ? value : infos[i].defaultValue );
	}
	return scratch;
}

/// tan of an angle, the cosine no smaller than a least one.
static float soleTangent( float angle, float least )
{
	soleHalf half = soleHalfFromAngle( angle );
	return 2.0f * half.s * half.c / soleMaxF( half.c * half.c - half.s * half.s, least );
}

soleAngles soleTakeAngles( const soleSettings* settings )
{
	return ( soleAngles ){
		.steepestTilt = soleTangent( settings->target.maxTilt, 1e-3f ),
		.walkable = soleHalfFromAngle( settings->support.maxSlope ),
		.toesUp = soleHalfFromAngle( settings->ankle.toeUp ),
		.toesDown = soleHalfFromAngle( -settings->ankle.toeDown ),
		.toesLeast = -soleTangent( settings->ankle.toeDown, 0.05f ),
		.toesMost = soleMinF( soleTangent( soleMinF( settings->ankle.toeUp, 1.4f ), 0.05f ), TOES_UP ),
		.lockTurn = soleQuarterTan( soleHalfFromAngle( settings->contact.lockAngle ) ),
	};
}

bool soleIsFrameUsable( const soleFrame* frame )
{
	const soleTransform* root = &frame->root;
	return frame->pose != NULL && soleVec3_IsFinite( root->translation ) && soleQuat_IsFinite( root->rotation ) &&
	    soleVec3_IsFinite( root->scale ) && soleVec3_IsFinite( frame->up ) && soleIsFinite( frame->weight ) &&
	    soleIsFinite( frame->clipFloor ) && root->scale.x * root->scale.y * root->scale.z != 0.0f;
}

/// Moves all remembered places along with a world whose origin was moved.
static void soleShiftState( soleState* state, const soleFrame* frame, int32_t legCount )
{
	soleVec3 shift = soleVec( (float)( state->worldOrigin[0] - frame->worldOrigin[0] ),
	    (float)( state->worldOrigin[1] - frame->worldOrigin[1] ),
	    (float)( state->worldOrigin[2] - frame->worldOrigin[2] ) );
	memcpy( state->worldOrigin, frame->worldOrigin, sizeof state->worldOrigin );
	if ( shift.x == 0.0f && shift.y == 0.0f && shift.z == 0.0f )
	{
		return;
	}
	state->root_w = soleAdd( state->root_w, shift );
	for ( int32_t i = 0; i < legCount; ++i )
	{
		soleLegState* leg = state->legs + i;
		leg->animHeel_w = soleAdd( leg->animHeel_w, shift );
		leg->animBall_w = soleAdd( leg->animBall_w, shift );
		leg->lockPoint_w = soleAdd( leg->lockPoint_w, shift );
		leg->planePoint_w = soleAdd( leg->planePoint_w, shift );
		leg->stepPlace_w = soleAdd( leg->stepPlace_w, shift );
		leg->stepLanding_w = soleAdd( leg->stepLanding_w, shift );
		bool rides = ( leg->flags & sole_stateRides ) != 0;
		leg->body.place = rides ? soleAdd( leg->body.place, shift ) : leg->body.place;
	}
}

static bool soleIsStateUsable( const soleState* state, int32_t legCount )
{
	bool finite = soleAreFinite(
	    &state->root_w, offsetof( soleState, unmetTime ) + sizeof( float ) - offsetof( soleState, root_w ) );
	for ( int32_t i = 0; i < legCount; ++i )
	{
		const soleLegState* leg = state->legs + i;
		finite = finite && soleAreFinite( &leg->body.rotation, sizeof *leg - offsetof( soleLegState, body.rotation ) );
	}
	return finite;
}

void soleTakeState( const soleRig* rig, const soleFrame* frame, soleState* state )
{
	if ( state->internalValue != SOLE_COOKIE || !soleIsStateUsable( state, rig->legCount ) )
	{
		*state = soleDefaultState( rig );
	}
	soleShiftState( state, frame, rig->legCount );
}

/// A new start: nothing of an earlier place is left.
static void soleForget( soleState* state, int32_t legCount )
{
	soleOffset1 still = { 0.0f, 0.0f };
	state->pelvis = still;
	state->pelvisLead = still;
	state->second = still;
	state->pelvisHeld = 0.0f;
	state->pelvisHeldTime = 0.0f;
	state->strength = 1.0f;
	memset( &state->balance, 0, sizeof state->balance );
	memset( state->legs, 0, (size_t)legCount * sizeof state->legs[0] );
	for ( int32_t i = 0; i < legCount; ++i )
	{
		state->legs[i].body.surface = SOLE_NONE;
	}
}

/// What the host knows of a leg's steps, where that is usable.
static soleStepInput soleTakeStepInput( const soleFrame* frame, int32_t leg )
{
	soleStepInput unknown = { .since = -1.0f, .until = -1.0f };
	if ( frame->steps == NULL )
	{
		return unknown;
	}
	const soleStepInput* step = frame->steps + leg;
	bool finite = soleIsFinite( step->since + step->until ) && soleVec3_IsFinite( step->place ) &&
	    soleVec3_IsFinite( step->forward ) && soleVec3_IsFinite( step->travel );
	return finite ? *step : unknown;
}

void soleSetUpFrame( solePlaceWork* work )
{
	const soleFrame* frame = work->frame;
	soleQuat rotation = soleNormalizeQuat( frame->root.rotation );
	work->rootUp = soleRotate( rotation, work->rig->up );
	work->up = soleNormalizeOr( frame->up, work->rootUp );
	work->level = soleAnyOrthogonal( work->up );
	work->rootScale = frame->root.scale.x;
	work->root_w = frame->root.translation;
	work->floor = soleRotate( rotation, soleMul( frame->root.scale, soleScale( frame->clipFloor, work->rig->up ) ) );
	work->reference = soleDot( work->floor, work->up );
	float step = frame->timeStep;
	work->timeStep = soleIsFinite( step ) && step > 0.0f ? step : 0.0f;
	work->legCount = work->rig->legCount;

	work->first = work->state->frameCount == 0 || frame->teleport || work->timeStep > FORGET_TIME;
	if ( work->first == false )
	{
		float scaled = soleLongestRigLeg( work );
		float moved = soleDistance( work->root_w, work->state->root_w );
		work->first = moved > TELEPORT * scaled && moved > 20.0f * scaled * work->timeStep;
		soleVec3 travel = soleHorizontal( work, soleSub( work->root_w, work->state->root_w ) );
		float perSecond = work->timeStep > 0.0f ? 1.0f / work->timeStep : 0.0f;
		work->rootVelocity = soleScale( perSecond, travel );
		work->rootSpeed = soleLength( work->rootVelocity );
	}
	if ( work->first )
	{
		// A jump is no motion.
		work->rootVelocity = soleVec( 0.0f, 0.0f, 0.0f );
		work->rootSpeed = 0.0f;
		soleForget( work->state, work->legCount );
	}
	work->angles = soleTakeAngles( work->settings );
	work->second = frame->secondPose != NULL ? work->state->second.value : 0.0f;
	memset( work->legs, 0, (size_t)work->legCount * sizeof work->legs[0] );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		leg->rig = work->rig->legs + i;
		leg->state = work->state->legs + i;
		leg->out = work->out->legs + i;
		leg->index = i;
		leg->contactInput = ( soleContactInput ){ -1.0f, -1.0f };
		if ( frame->contact != NULL && soleIsFinite( frame->contact[i].heel + frame->contact[i].toe ) )
		{
			leg->contactInput = frame->contact[i];
		}
		leg->stepInput = soleTakeStepInput( frame, i );
		soleBlendWeights( work, leg );
	}
	soleCarryLegs( work );
}

// ----------------------------------------------------------------------------------------------------------- states

soleState soleDefaultState( const soleRig* rig )
{
	(void)rig;
	soleState state;
	memset( &state, 0, sizeof state );
	state.internalValue = SOLE_COOKIE;
	return state;
}

size_t soleState_GetByteCount( const soleRig* rig )
{
	SOLE_ASSERT( rig != NULL );
	int32_t legCount = rig != NULL ? rig->legCount : SOLE_MAX_LEGS;
	return offsetof( soleState, legs ) + (size_t)legCount * sizeof( soleLegState );
}

void soleState_Reset( soleState* state )
{
	SOLE_ASSERT( state != NULL );
	if ( state != NULL )
	{
		state->frameCount = 0;
	}
}
