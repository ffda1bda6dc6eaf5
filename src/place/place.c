// SPDX-License-Identifier: MIT
// A frame from pose to pose: takes in what the host gives, calls the stages in turn, and hands out the result. The only
// file that calls stages.
#include "place/place.h"

#include "base/core.h"

#include <string.h>

// ----------------------------------------------------------------------------------------------------- handing out

/// The output that changes nothing: the pose as it came in.
static void solePassThrough( const soleRig* rig, const soleFrame* frame, float second, soleOutput* out )
{
	memset( out, 0, sizeof *out );
	out->legCount = rig->legCount;
	bool readable = frame != NULL && frame->pose != NULL;
	if ( readable )
	{
		out->pelvisTranslation_l = soleReadPose( frame, second, rig->pelvis ).translation;
	}
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		const soleRigLeg* leg = rig->legs + i;
		soleLegOutput* o = out->legs + i;
		for ( int32_t j = 0; j < SOLE_MAX_LEG_JOINTS; ++j )
		{
			bool there = readable && j < leg->def.jointCount;
			o->rotations_l[j] =
			    there ? soleReadPose( frame, second, leg->def.joints[j] ).rotation : soleQuat_Identity();
		}
		o->toeRotation_l = readable && leg->def.toeCount > 0 ? soleReadPose( frame, second, leg->def.toes[0] ).rotation
		                                                     : soleQuat_Identity();
		o->stretch = 1.0f;
		o->footRotation_l = soleQuat_Identity();
		if ( readable && leg->def.detachedFoot != SOLE_NONE )
		{
			soleTransform foot = soleReadPose( frame, second, leg->def.detachedFoot );
			o->footTranslation_l = foot.translation;
			o->footRotation_l = foot.rotation;
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
		o->stretch = soleFiniteOr( o->stretch, 1.0f );
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
	out->pelvisOffset_w = soleMulAdd( work->balance, work->pelvisShift, work->up );
	// A capsule that has lost half of what the pelvis has gone down, at both ends, still stands on the ground.
	out->capsuleShorter = 0.5f * soleMaxF( -work->pelvisShift, 0.0f );
	out->capsuleOffset = -out->capsuleShorter;
	out->secondWeight = work->second;
	out->bodyGradient_w = work->state->bodyGradient;
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
	soleForesee( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleAimSole( work, work->legs + i );
	}
	soleFindSupport( work, hits, hitCount );
	soleUpdateContact( work );
	soleLearnSteps( work );
	soleTakeResteps( work );
	soleChooseFootholds( work );
	soleUpdateLocks( work );
	soleSetTargets( work );
	soleDemandSecondPose( work );
	soleFindBodyGround( work );
	soleMovePelvis( work );
	soleSolveLegs( work );
	soleLimitAnkles( work );
	soleSolveLegs( work );
	soleAlignAnkles( work );
	soleRememberBodies( work );
	soleWritePelvis( work );
}

void soleRunFrame( solePlaceWork* work, const soleHit* hits, int32_t hitCount )
{
	soleSetUpFrame( work );
	solePassThrough( work->rig, work->frame, work->second, work->out );
	soleRunStages( work, hits, hitCount > 0 ? hitCount : 0 );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		work->out->legs[i].flags |= work->legs[i].usable ? 0u : (uint32_t)sole_legBadInput;
	}
	soleScrubOutput( work->rig, work->out );
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
	soleTakeState( rig, frame, &copy );
	solePlaceWork work = { .rig = rig, .settings = &clean, .frame = frame, .state = &copy, .out = &out };
	soleSetUpFrame( &work );
	soleSense( &work );
	soleForesee( &work );
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
	solePassThrough( rig, given ? frame : NULL, 0.0f, output );
	if ( given == false || !soleIsFrameUsable( frame ) )
	{
		for ( int32_t i = 0; i < rig->legCount; ++i )
		{
			output->legs[i].flags = (uint32_t)sole_legBadInput;
		}
		soleScrubOutput( rig, output );
		return;
	}
	soleTakeState( rig, frame, state );
	soleSettings clean = soleCleanSettings( settings );
	solePlaceWork work = { .rig = rig, .settings = &clean, .frame = frame, .state = state, .out = output };
	soleRunFrame( &work, hits, hitCount );
	state->root_w = work.root_w;
	state->frameCount = work.first ? 1 : ( state->frameCount < UINT32_MAX ? state->frameCount + 1 : 1 );
}

void soleBlendSecondPose(
    const soleRig* rig, const soleOutput* output, const soleTransform* secondPose, soleTransform* localPose )
{
	SOLE_ASSERT( rig != NULL && output != NULL && secondPose != NULL && localPose != NULL );
	if ( rig == NULL || output == NULL || secondPose == NULL || localPose == NULL )
	{
		return;
	}
	soleFrame frame = { .pose = localPose, .secondPose = secondPose };
	for ( int32_t i = 0; i < rig->jointCount; ++i )
	{
		localPose[i] = soleReadPose( &frame, output->secondWeight, i );
	}
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
			// Joints between those of the leg are part of its bones.
			for ( int32_t k = leg->joints[j]; j > 0 && k != leg->joints[j - 1]; k = rig->parents[k] )
			{
				localPose[k].translation = soleScale( o->stretch, localPose[k].translation );
			}
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
