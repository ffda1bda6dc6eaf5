// SPDX-License-Identifier: MIT
// A frame from pose to pose: takes in what the host gives, calls the stages in turn, and hands out the result. The only
// file that calls stages.
#include "place/place.h"

#include "base/core.h"
#include "place/foot_wide.h"
#include "place/sense_wide.h"
#include "place/target_wide.h"

#include <string.h>

// An own build may define both to measure how long stages take; everywhere else they are nothing.
#ifndef SOLE_STAGE_END
#define SOLE_STAGES_BEGIN() ( (void)0 )
#define SOLE_STAGE_END( name ) ( (void)0 )
#endif

// ----------------------------------------------------------------------------------------------------- handing out

/// The output that changes nothing: the pose as it came in. Legs that the rig does not have are left as they are.
static void solePassThrough( const soleRig* rig, const soleFrame* frame, float second, soleOutput* out )
{
	memset( out, 0, offsetof( soleOutput, legs ) + (size_t)rig->legCount * sizeof out->legs[0] );
	out->legCount = rig->legCount;
	out->lean_l = soleQuat_Identity();
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

void soleScrubOutput( const soleRig* rig, soleOutput* out )
{
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		soleLegOutput* o = out->legs + i;
		// All from there on are floats.
		if ( soleAreFinite( o->rotations_l, sizeof *o - offsetof( soleLegOutput, rotations_l ) ) )
		{
			continue;
		}
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
	soleScrubQuat( &out->lean_l );
	if ( !soleVec3_IsFinite( out->pelvisTranslation_l ) || !soleVec3_IsFinite( out->pelvisOffset_w ) )
	{
		out->pelvisTranslation_l = soleVec( 0.0f, 0.0f, 0.0f );
		out->pelvisOffset_w = soleVec( 0.0f, 0.0f, 0.0f );
	}
}

static void soleWritePelvis( solePlaceWork* work )
{
	soleOutput* out = work->out;
	out->pelvisOffset_w = work->pelvisWanted;
	out->groundOffset = soleFiniteOr( work->bodyGround - work->reference, 0.0f );
	// A capsule that has lost half of what the pelvis has gone down, at both ends, still stands on the ground.
	out->capsuleShorter = 0.5f * soleMaxF( -soleDot( work->pelvisWanted, work->up ), 0.0f );
	out->capsuleOffset = -out->capsuleShorter;
	out->secondWeight = work->second;
	out->bodyGradient_w = work->state->bodyGradient;
	if ( work->settings->pelvis.mode != sole_pelvisJoint )
	{
		return;
	}
	int32_t parent = work->rig->slotParents[work->rig->pelvisSlot];
	soleTransform space = parent == SOLE_NONE ? soleGetNearRoot( work ) : work->slots[parent];
	// Added to what the animation has, so that no shift leaves it as it is, to the bit.
	space.translation = soleVec( 0.0f, 0.0f, 0.0f );
	out->pelvisTranslation_l = soleAdd( out->pelvisTranslation_l, soleInvTransformPoint( space, out->pelvisOffset_w ) );
}

// ------------------------------------------------------------------------------------------------------- the frame

void soleOpenFrame( solePlaceWork* work, const soleRig* rig, const soleSettings* settings, soleState* state,
    const soleFrame* frame, soleOutput* out )
{
	memset( &work->rig, 0, sizeof *work - offsetof( solePlaceWork, rig ) );
	work->rig = rig;
	work->settings = settings;
	work->state = state;
	work->frame = frame;
	work->out = out;
	soleTakeState( rig, frame, state );
	soleSetUpFrame( work );
}

static void soleAimFrame( solePlaceWork* work )
{
	if ( soleGoesByTicks( work ) )
	{
		soleCountTick( work );
		return;
	}
	soleForesee( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleAimSole( work, work->legs + i );
	}
}

void soleBeginFrame( solePlaceWork* work, const soleRig* rig, const soleSettings* settings, soleState* state,
    const soleFrame* frame, soleOutput* out )
{
	soleOpenFrame( work, rig, settings, state, frame, out );
	soleSense( work );
	soleAimFrame( work );
}

void soleBeginFrames( solePlaceWork* const* works, int32_t count, int32_t width )
{
	soleSenseAll( works, count, width );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleAimFrame( works[i] );
	}
}

/// From what is on the ground to where feet are held.
static void soleHoldFeet( solePlaceWork* work )
{
	soleLearnSteps( work );
	SOLE_STAGE_END( "contact" );
	soleTakeResteps( work );
	soleTakeOff( work );
	soleChooseFootholds( work );
	SOLE_STAGE_END( "foothold" );
	soleUpdateLocks( work );
	SOLE_STAGE_END( "lock" );
}

/// From the answers of the ground to where feet are held.
static void soleStandFrame( solePlaceWork* work, const soleLegHits* hits )
{
	solePassThrough( work->rig, work->frame, work->second, work->out );
	soleFindSupport( work, hits );
	soleGoesByTicks( work ) ? soleKeepTick( work ) : (void)0;
	SOLE_STAGE_END( "support" );
	soleUpdateContact( work );
	soleFindActivity( work );
	soleGoesByTicks( work ) ? (void)0 : soleHoldFeet( work );
}

/// From the targets to where the pelvis goes.
static void soleMoveBody( solePlaceWork* work )
{
	soleClassReach( work );
	soleDemandSecondPose( work );
	SOLE_STAGE_END( "target" );
	soleFindBodyGround( work );
	soleAddLayer( work );
	soleMovePelvis( work );
	SOLE_STAGE_END( "pelvis" );
}

static void soleReachFrame( solePlaceWork* work )
{
	soleGoesByTicks( work ) ? soleFollowTick( work ) : soleMoveBody( work );
}

void soleFinishAnkle( const solePlaceWork* work, soleLegWork* leg )
{
	soleLimitAnkle( work, leg );
	if ( leg->limited )
	{
		soleSolveLeg( work, leg );
	}
	soleAlignAnkle( work, leg );
}

void soleFinishLeg( const solePlaceWork* work, soleLegWork* leg )
{
	if ( leg->usable )
	{
		soleSolveLeg( work, leg );
		soleFinishAnkle( work, leg );
	}
}

/// What is handed out and remembered of the whole.
static void soleCloseFrame( solePlaceWork* work )
{
	soleState* state = work->state;
	soleGoesByTicks( work ) ? soleRememberShown( work ) : (void)0;
	soleRememberBodies( work );
	soleWritePelvis( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		work->out->legs[i].flags |= work->legs[i].usable ? 0u : (uint32_t)sole_legBadInput;
	}
	soleScrubOutput( work->rig, work->out );
	state->root_w = work->root_w;
	state->frameCount = work->first ? 1 : ( state->frameCount < UINT32_MAX ? state->frameCount + 1 : 1 );
	SOLE_STAGE_END( "output" );
}

void soleEndFrame( solePlaceWork* work, const soleLegHits* hits )
{
	soleStandFrame( work, hits );
	soleGoesByTicks( work ) ? (void)0 : soleSetTargets( work );
	soleReachFrame( work );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleFinishLeg( work, work->legs + i );
	}
	SOLE_STAGE_END( "leg and ankle" );
	soleCloseFrame( work );
}

void soleEndFrames( solePlaceWork* const* works, const soleLegHits* hits, int32_t count, int32_t width )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		soleStandFrame( works[i], hits + i );
	}
	soleSetAllTargets( works, count, width );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleReachFrame( works[i] );
	}
	soleFinishLegs( works, count, width );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleCloseFrame( works[i] );
	}
}

void soleRefuseFrame( const soleRig* rig, const soleFrame* frame, soleOutput* output )
{
	solePassThrough( rig, frame, 0.0f, output );
	for ( int32_t i = 0; i < rig->legCount; ++i )
	{
		output->legs[i].flags = (uint32_t)sole_legBadInput;
	}
	soleScrubOutput( rig, output );
}

soleLegHits soleSplitHits( const soleRig* rig, const soleSettings* settings, const soleHit* hits, int32_t hitCount )
{
	soleLegHits byLeg = { .hits = hits };
	int32_t perLeg = soleProbesPerLeg( settings );
	for ( int32_t i = 0; i <= rig->legCount; ++i )
	{
		byLeg.starts[i] = soleMinI( i * perLeg, hits != NULL && hitCount > 0 ? hitCount : 0 );
	}
	return byLeg;
}

// -------------------------------------------------------------------------------------------------- one character

int32_t soleGatherProbes( const soleRig* rig, const soleSettings* settings, const soleState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	bool usable = rig != NULL && state != NULL && frame != NULL && ( probes != NULL || capacity <= 0 );
	SOLE_ASSERT( usable );
	if ( usable == false || capacity <= 0 || !soleIsFrameUsable( frame ) )
	{
		return 0;
	}
	soleSettings scratch;
	soleOutput out;
	soleState copy;
	memcpy( &copy, state, soleState_GetByteCount( rig ) );
	solePlaceRoom room;
	solePlaceWork work = soleWorkIn( &room );
	soleBeginFrame( &work, rig, soleCleanSettings( rig, settings, &scratch ), &copy, frame, &out );
	// Probes that are not needed are handed out all the same: how many there are depends on rig and settings alone.
	int32_t perLeg = soleProbesPerLeg( work.settings );
	int32_t count = soleMinI( capacity, work.legCount * perLeg );
	for ( int32_t i = 0; i * perLeg < count; ++i )
	{
		soleProbe* first = probes + i * perLeg;
		int32_t most = soleMinI( perLeg, count - i * perLeg );
		soleProbe none = soleMakeProbe( &work, work.legs + i );
		for ( int32_t k = soleAskGround( &work, work.legs + i, first, most ); k < most; ++k )
		{
			first[k] = none;
			first[k].index = (int16_t)k;
		}
	}
	return count;
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
	if ( given == false || !soleIsFrameUsable( frame ) )
	{
		soleRefuseFrame( rig, given ? frame : NULL, output );
		return;
	}
	soleSettings scratch;
	const soleSettings* clean = soleCleanSettings( rig, settings, &scratch );
	soleLegHits byLeg = soleSplitHits( rig, clean, hits, hitCount );
	solePlaceRoom room;
	solePlaceWork work = soleWorkIn( &room );
	SOLE_STAGES_BEGIN();
	soleBeginFrame( &work, rig, clean, state, frame, output );
	SOLE_STAGE_END( "sense" );
	soleEndFrame( &work, &byLeg );
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
	soleVec3 lean = soleVec( output->lean_l.x, output->lean_l.y, output->lean_l.z );
	if ( rig->spine != SOLE_NONE && soleDot( lean, lean ) > 0.0f )
	{
		localPose[rig->spine].rotation =
		    soleNormalizeQuat( soleMulQuat( output->lean_l, soleNormalizeQuat( localPose[rig->spine].rotation ) ) );
	}
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
