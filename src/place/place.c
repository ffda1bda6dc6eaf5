// SPDX-License-Identifier: MIT
// A frame from pose to pose: takes in what the host gives, calls the stages in turn, and hands out the result. The only
// file that calls stages.
#include "place/place.h"

#include "base/core.h"

#include <string.h>

#define TELEPORT 1.5f // leg lengths that a root can't move in a frame beyond 20 of them a second

// ------------------------------------------------------------------------------------------------------ taking in

/// Settings in their ranges; the defaults where they were not made by soleDefaultSettings().
static soleSettings soleCleanSettings( const soleSettings* settings )
{
	SOLE_ASSERT( settings != NULL && settings->internalValue == SOLE_COOKIE );
	if ( settings == NULL || settings->internalValue != SOLE_COOKIE )
	{
		return soleDefaultSettings();
	}
	soleSettings clean = *settings;
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		double value = soleSettings_Get( settings, infos + i );
		soleSettings_Set( &clean, infos + i, value - value == 0.0 ? value : infos[i].defaultValue );
	}
	return clean;
}

static bool soleIsFrameUsable( const soleFrame* frame )
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
	}
}

static bool soleIsStateUsable( const soleState* state, int32_t legCount )
{
	bool finite = soleVec3_IsFinite( state->root_w ) && soleIsFinite( state->rootSpeed ) &&
	    soleIsFinite( state->rootSuspect ) && soleIsFinite( state->pelvis.value ) &&
	    soleIsFinite( state->pelvis.velocity );
	for ( int32_t i = 0; i < legCount; ++i )
	{
		const soleLegState* leg = state->legs + i;
		finite = finite && soleVec3_IsFinite( leg->animHeel_w ) && soleVec3_IsFinite( leg->animBall_w ) &&
		    soleVec3_IsFinite( leg->lockPoint_w ) && soleVec3_IsFinite( leg->lockForward_w ) &&
		    soleVec3_IsFinite( leg->planePoint_w ) && soleVec3_IsFinite( leg->planeNormal_w ) &&
		    soleVec3_IsFinite( leg->slide.value ) && soleVec3_IsFinite( leg->slide.velocity ) &&
		    soleVec3_IsFinite( leg->gradient.value ) && soleVec3_IsFinite( leg->gradient.velocity ) &&
		    soleIsFinite( leg->turn.value ) && soleIsFinite( leg->turn.velocity ) &&
		    soleIsFinite( leg->height.value ) && soleIsFinite( leg->height.velocity ) &&
		    soleIsFinite( leg->plantWeight ) && soleIsFinite( leg->say ) && soleIsFinite( leg->contactTime ) &&
		    soleIsFinite( leg->heelRise ) && soleIsFinite( leg->ballRise ) && soleIsFinite( leg->heelSpeed ) &&
		    soleIsFinite( leg->ballSpeed );
	}
	return finite;
}

static float soleLongestLeg( const soleRig* rig )
{
	float longest = 0.0f;
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		longest = soleMaxF( longest, rig->legs[i].length );
	}
	return longest;
}

static void soleSetUpFrame( solePlaceWork* work )
{
	const soleFrame* frame = work->frame;
	soleQuat rotation = soleNormalizeQuat( frame->root.rotation );
	work->rootUp = soleRotate( rotation, work->rig->up );
	work->up = soleNormalizeOr( frame->up, work->rootUp );
	work->rootScale = frame->root.scale.x;
	work->root_w = frame->root.translation;
	work->floor = soleRotate( rotation, soleMul( frame->root.scale, soleScale( frame->clipFloor, work->rig->up ) ) );
	work->reference = soleDot( work->floor, work->up );
	float step = frame->timeStep;
	work->timeStep = soleIsFinite( step ) && step > 0.0f ? step : 0.0f;
	work->legCount = work->rig->legCount;

	work->first = work->state->frameCount == 0 || frame->teleport;
	if ( work->first == false )
	{
		float scaled = soleLongestLeg( work->rig ) * work->rootScale;
		float moved = soleDistance( work->root_w, work->state->root_w );
		work->first = moved > TELEPORT * scaled && moved > 20.0f * scaled * work->timeStep;
		soleVec3 travel = soleHorizontal( work, soleSub( work->root_w, work->state->root_w ) );
		work->rootSpeed = work->timeStep > 0.0f ? soleLength( travel ) / work->timeStep : 0.0f;
	}
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		*leg = ( soleLegWork ){ .rig = work->rig->legs + i, .state = work->state->legs + i, .index = i };
		leg->out = work->out->legs + i;
		float legWeight = frame->legWeight != NULL ? frame->legWeight[i] : 1.0f;
		leg->weight = soleSaturate( frame->weight ) * soleSaturate( soleFiniteOr( legWeight, 0.0f ) );
		leg->contactInput = ( soleContactInput ){ -1.0f, -1.0f };
		if ( frame->contact != NULL && soleIsFinite( frame->contact[i].heel + frame->contact[i].toe ) )
		{
			leg->contactInput = frame->contact[i];
		}
	}
}

// ----------------------------------------------------------------------------------------------------- handing out

/// The output that changes nothing: the pose as it came in.
static void solePassThrough( const soleRig* rig, const soleFrame* frame, soleOutput* out )
{
	memset( out, 0, sizeof *out );
	out->legCount = rig->legCount;
	bool readable = frame != NULL && frame->pose != NULL;
	if ( readable )
	{
		out->pelvisTranslation_l = frame->pose[rig->pelvis].translation;
	}
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		const soleRigLeg* leg = rig->legs + i;
		soleLegOutput* o = out->legs + i;
		for ( int32_t j = 0; j < SOLE_MAX_LEG_JOINTS; ++j )
		{
			bool there = readable && j < leg->def.jointCount;
			o->rotations_l[j] = there ? frame->pose[leg->def.joints[j]].rotation : soleQuat_Identity();
		}
		o->toeRotation_l =
		    readable && leg->def.toeCount > 0 ? frame->pose[leg->def.toes[0]].rotation : soleQuat_Identity();
		o->footRotation_l = soleQuat_Identity();
		if ( readable && leg->def.detachedFoot != SOLE_NONE )
		{
			o->footTranslation_l = frame->pose[leg->def.detachedFoot].translation;
			o->footRotation_l = frame->pose[leg->def.detachedFoot].rotation;
		}
	}
}

static void soleScrubQuat( soleQuat* q )
{
	*q = soleQuat_IsFinite( *q ) ? *q : soleQuat_Identity();
}

/// Nothing that is not finite leaves, whatever came in.
static void soleScrubOutput( const soleRig* rig, soleOutput* out )
{
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		soleLegOutput* o = out->legs + i;
		for ( int32_t j = 0; j < SOLE_MAX_LEG_JOINTS; ++j )
		{
			soleScrubQuat( o->rotations_l + j );
		}
		soleScrubQuat( &o->toeRotation_l );
		soleScrubQuat( &o->footRotation_l );
		soleVec3* vectors[] = { &o->footTranslation_l, &o->ankleTarget_w, &o->ankle_w, &o->planePoint_w,
			&o->planeNormal_w };
		for ( int32_t k = 0; k < 5; ++k )
		{
			*vectors[k] = soleVec3_IsFinite( *vectors[k] ) ? *vectors[k] : soleVec( 0.0f, 0.0f, 0.0f );
		}
		o->error = soleFiniteOr( o->error, 0.0f );
		o->extension = soleFiniteOr( o->extension, 0.0f );
		o->heightDemand = soleFiniteOr( o->heightDemand, 0.0f );
	}
	if ( !soleVec3_IsFinite( out->pelvisTranslation_l ) || !soleVec3_IsFinite( out->pelvisOffset_w ) )
	{
		out->pelvisTranslation_l = soleVec( 0.0f, 0.0f, 0.0f );
		out->pelvisOffset_w = soleVec( 0.0f, 0.0f, 0.0f );
	}
}

static void soleWritePelvis( solePlaceWork* work )
{
	soleOutput* out = work->out;
	out->pelvisOffset_w = soleScale( work->pelvisShift, work->up );
	int32_t parent = work->rig->slotParents[work->rig->pelvisSlot];
	soleTransform space = parent == SOLE_NONE ? ( soleTransform ){ { 0.0f, 0.0f, 0.0f },
		soleNormalizeQuat( work->frame->root.rotation ), work->frame->root.scale }
	                                          : work->slots[parent];
	// Added to what the animation has, so that no shift leaves it as it is, to the bit.
	space.translation = soleVec( 0.0f, 0.0f, 0.0f );
	out->pelvisTranslation_l = soleAdd( out->pelvisTranslation_l, soleInvTransformPoint( space, out->pelvisOffset_w ) );
}

// ------------------------------------------------------------------------------------------------------- the frame

static void soleRunStages( solePlaceWork* work, const soleHit* hits, int32_t hitCount )
{
	soleSense( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleAimSole( work, work->legs + i );
	}
	soleFindSupport( work, hits, hitCount );
	soleUpdateContact( work );
	soleChooseFoothold( work );
	soleSetTargets( work );
	soleMovePelvis( work );
	soleSolveLegs( work );
	soleLimitAnkles( work );
	soleSolveLegs( work );
	soleAlignAnkles( work );
	soleWritePelvis( work );
}

int32_t soleGatherProbes( const soleRig* rig, const soleSettings* settings, const soleState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	bool usable = rig != NULL && state != NULL && frame != NULL && ( probes != NULL || capacity <= 0 );
	SOLE_ASSERT( usable );
	if ( usable == false || !soleIsFrameUsable( frame ) )
	{
		return 0;
	}
	soleSettings clean = soleCleanSettings( settings );
	soleOutput out;
	soleState copy = *state;
	if ( copy.internalValue != SOLE_COOKIE || !soleIsStateUsable( &copy, rig->legCount ) )
	{
		copy = soleDefaultState( rig );
	}
	soleShiftState( &copy, frame, rig->legCount );
	solePlaceWork work = { .rig = rig, .settings = &clean, .frame = frame, .state = &copy, .out = &out };
	soleSetUpFrame( &work );
	soleSense( &work );
	for ( int32_t i = 0; i < work.legCount; ++i )
	{
		soleAimSole( &work, work.legs + i );
	}
	return soleProbeGround( &work, probes, capacity );
}

void soleSolve( const soleRig* rig, const soleSettings* settings, soleState* state, const soleFrame* frame,
    const soleHit* hits, int32_t hitCount, soleOutput* output )
{
	bool given = rig != NULL && state != NULL && output != NULL && frame != NULL && ( hits != NULL || hitCount <= 0 );
	SOLE_ASSERT( given );
	if ( rig == NULL || output == NULL )
	{
		return;
	}
	solePassThrough( rig, given ? frame : NULL, output );
	if ( given == false || !soleIsFrameUsable( frame ) )
	{
		for ( int32_t i = 0; i < rig->legCount; ++i )
		{
			output->legs[i].flags = (uint32_t)sole_legBadInput;
		}
		soleScrubOutput( rig, output );
		return;
	}
	if ( state->internalValue != SOLE_COOKIE || !soleIsStateUsable( state, rig->legCount ) )
	{
		*state = soleDefaultState( rig );
	}
	soleSettings clean = soleCleanSettings( settings );
	soleShiftState( state, frame, rig->legCount );
	solePlaceWork work = { .rig = rig, .settings = &clean, .frame = frame, .state = state, .out = output };
	soleSetUpFrame( &work );
	soleRunStages( &work, hits, hitCount > 0 ? hitCount : 0 );
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		output->legs[i].flags |= work.legs[i].usable ? 0u : (uint32_t)sole_legBadInput;
	}
	state->root_w = work.root_w;
	state->frameCount = work.first ? 1 : ( state->frameCount < UINT32_MAX ? state->frameCount + 1 : 1 );
	soleScrubOutput( rig, output );
}

void soleApply( const soleRig* rig, const soleOutput* output, soleTransform* localPose )
{
	SOLE_ASSERT( rig != NULL && output != NULL && localPose != NULL );
	if ( rig == NULL || output == NULL || localPose == NULL || output->legCount != rig->legCount )
	{
		return;
	}
	localPose[rig->pelvis].translation = output->pelvisTranslation_l;
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		const soleLegDef* leg = &rig->legs[i].def;
		const soleLegOutput* o = output->legs + i;
		for ( int32_t j = 0; j < leg->jointCount; ++j )
		{
			localPose[leg->joints[j]].rotation = o->rotations_l[j];
		}
		if ( leg->toeCount > 0 )
		{
			localPose[leg->toes[0]].rotation = o->toeRotation_l;
		}
		if ( leg->detachedFoot != SOLE_NONE )
		{
			localPose[leg->detachedFoot].translation = o->footTranslation_l;
			localPose[leg->detachedFoot].rotation = o->footRotation_l;
		}
	}
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
