// SPDX-License-Identifier: MIT
// Foot IK of the side-scroller "And I Must Scream", an Unreal character: its numbers in centimetres, heights along up.
// Source: the description of its C++ walk-through.
//
// The capsule stands on the root, its middle, the actor, half its height H over that; the mesh hangs at the actor,
// lower by the rest half height H0. So a capsule that is made shorter takes traces and mesh down with it:
//   actor = root + H        mesh = actor - H0 = root - ( H0 - H )
// A trace goes from the actor's height down over H0 + T. Ground is as high as o = distance( hit, end ) - T + a, which
// is its height over the capsule's lower end at rest, actor - H0; in [-T, H0] + a. No ground counts as o = 0.
//   h = min( 0, min o ),   hip -> h,   H -> H0 - |h| / 2,   effectors -> o - h
// With a drop d under one foot the shorter capsule raises o by |h| / 2: at rest |h| = 2d/3 and the capsule has d/3.
//
// Each goes there by x += ( target - x ) clamp( k dt, 0, 1 ). All is left as it is once the effectors are nearly there,
// the hip too, whether it is there or not: it is slower, and stays short by some of its way.
#include "baselines/effector.h"

#include "baselines/baseline.h"

#include <string.h>

#define USUAL_HALF_HEIGHT 88.0f // cm, of the capsule for which the trace distance was chosen

soleEffectorSettings soleDefaultEffectorSettings( void )
{
	soleEffectorSettings settings = {
		.enableAnimationIk = true,
		.meshScale = 1.0f,
		.transformScale = 1.0f,
		.capsuleHalfHeight = USUAL_HALF_HEIGHT,
		.traceDistance = 55.0f,
		.feetInterpSpeed = 15.0f,
		.hipInterpSpeed = 10.0f,
		.nearlyEqual = 1.0f,
		.unitsPerCentimetre = 0.01f,
	};
	for ( int32_t i = 0; i < SOLE_MAX_LEGS; ++i )
	{
		settings.sockets[i] = SOLE_NONE;
	}
	return settings;
}

void soleFitEffectorSettings( const soleRig* rig, soleEffectorSettings* settings )
{
	float hips = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( rig ); ++i )
	{
		hips = soleMaxF( hips, soleRig_GetLegLength( rig, i ) + soleGetBaselineAnkleHeight( rig, i ) );
	}
	settings->capsuleHalfHeight = hips / settings->unitsPerCentimetre;
	settings->traceDistance = 55.0f * settings->capsuleHalfHeight / USUAL_HALF_HEIGHT;
}

soleEffectorState soleDefaultEffectorState( const soleRig* rig )
{
	(void)rig;
	soleEffectorState state;
	memset( &state, 0, sizeof state );
	state.usingFootIk = true;
	return state;
}

// ---------------------------------------------------------------------------------------------------------- traces

/// Exactly: the least creep of the root is motion.
static bool soleMovesEffector( const soleEffectorState* state, const soleFrame* frame )
{
	bool known = state->hasRoot && frame->teleport == false;
	return known && soleDistance( frame->root.translation, state->root_w ) > 0.0f;
}

static bool soleRunsEffector( const soleEffectorSettings* settings, const soleEffectorState* state )
{
	return settings->enableAnimationIk && state->usingFootIk;
}

/// Height of the actor over the root, world.
static float soleGetActorHeight( const soleEffectorSettings* settings, const soleEffectorState* state )
{
	return ( settings->capsuleHalfHeight - state->capsuleShorter ) * settings->unitsPerCentimetre;
}

int32_t soleGatherEffector( const soleRig* rig, const soleEffectorSettings* settings, const soleEffectorState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity )
{
	soleVec3 up = soleGetBaselineUp( rig, frame );
	soleVec3 root = soleGetBaselineRoot( rig, frame ).translation;
	soleVec3 actor = soleMulAdd( root, soleGetActorHeight( settings, state ), up );
	bool traces = soleRunsEffector( settings, state ) && soleMovesEffector( state, frame ) == false;
	float length = ( settings->capsuleHalfHeight + settings->traceDistance ) * settings->unitsPerCentimetre;
	int32_t count = soleRig_GetLegCount( rig );
	for ( int32_t i = 0; i < count && i < capacity; ++i )
	{
		int32_t joint = settings->sockets[i];
		soleVec3 socket = joint != SOLE_NONE ? soleGetBaselineJoint( rig, frame, joint ).translation
		                                     : soleReadBaselineLeg( rig, frame, i ).ankle_w;
		probes[i] = ( soleProbe ){
			.start_w = soleAdd( actor, soleReject( soleSub( socket, actor ), up ) ),
			.direction_w = soleNeg( up ),
			.length = traces ? length : 0.0f,
			.mask = 0xffffffffu,
			.leg = (int16_t)i,
		};
	}
	return count < capacity ? count : capacity;
}

// --------------------------------------------------------------------------------------------------- interpolation

static float soleInterpTo( float value, float target, float timeStep, float speed )
{
	return speed > 0.0f ? value + ( target - value ) * soleClampF( speed * timeStep, 0.0f, 1.0f ) : target;
}

static void soleMoveHip(
    const soleEffectorSettings* settings, soleEffectorState* state, float timeStep, float hip, float shorter )
{
	state->hipOffset = soleInterpTo( state->hipOffset, hip, timeStep, settings->hipInterpSpeed );
	state->capsuleShorter = soleInterpTo( state->capsuleShorter, shorter, timeStep, settings->hipInterpSpeed );
}

/// While moving all goes back to where the animation has it.
static void soleResetEffectors(
    const soleEffectorSettings* settings, soleEffectorState* state, float timeStep, int32_t legCount )
{
	for ( int32_t i = 0; i < legCount; ++i )
	{
		state->effectors[i] = soleInterpTo( state->effectors[i], 0.0f, timeStep, settings->feetInterpSpeed );
	}
	soleMoveHip( settings, state, timeStep, 0.0f, 0.0f );
}

/// Heights of the grounds over the capsule's lower end at rest, cm. @return the lowest, or zero
static float soleReadOffsets( const soleRig* rig, const soleEffectorSettings* settings, const soleEffectorState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, float offsets[SOLE_MAX_LEGS] )
{
	soleVec3 up = soleGetBaselineUp( rig, frame );
	float root = soleDot( soleGetBaselineRoot( rig, frame ).translation, up );
	float actor = root + soleGetActorHeight( settings, state );
	float lowest = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( rig ); ++i )
	{
		bool hit = i < hitCount && hits[i].hit;
		float below = hit ? ( actor - soleDot( hits[i].point_w, up ) ) / settings->unitsPerCentimetre : 0.0f;
		offsets[i] = hit ? settings->capsuleHalfHeight - below + settings->footAdjustment : 0.0f;
		lowest = soleMinF( lowest, offsets[i] );
	}
	return lowest;
}

static void soleUpdateEffectors( const soleEffectorSettings* settings, soleEffectorState* state, float timeStep,
    int32_t legCount, const float* offsets, float lowest )
{
	soleMoveHip( settings, state, timeStep, lowest, -0.5f * lowest );
	float scale = settings->meshScale * settings->transformScale;
	bool there = true;
	for ( int32_t i = 0; i < legCount; ++i )
	{
		float target = ( offsets[i] - lowest ) / scale;
		state->effectors[i] = soleInterpTo( state->effectors[i], target, timeStep, settings->feetInterpSpeed );
		there = there && fabsf( state->effectors[i] - target ) <= settings->nearlyEqual;
	}
	state->usingFootIk = there == false;
}

// ------------------------------------------------------------------------------------------------- animation graph

static void soleRunEffectorGraph( const soleRig* rig, const soleEffectorSettings* settings,
    const soleEffectorState* state, const soleFrame* frame, soleOutput* output )
{
	soleVec3 up = soleGetBaselineUp( rig, frame );
	float unit = settings->unitsPerCentimetre;
	float weight = soleGetBaselineWeight( frame, SOLE_NONE );
	float lowered = ( state->hipOffset - state->capsuleShorter ) * unit * weight;
	float scale = settings->meshScale * settings->transformScale;
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		soleBaselineLeg leg = soleReadBaselineLeg( rig, frame, i );
		float raised = state->effectors[i] * scale * unit * soleGetBaselineWeight( frame, i );
		soleBaselineGoal goal = {
			.pelvisOffset_w = soleScale( lowered, up ),
			.ankle_w = soleMulAdd( leg.ankle_w, lowered + raised, up ),
			.foot_w = leg.foot_w.rotation,
		};
		soleTwoBoneDef def = soleMakeBaselineTwoBone( &leg, &goal );
		soleTwoBoneResult bent = soleSolveTwoBone( &def );
		soleWriteBaselineLeg( rig, frame, &leg, &goal, &bent, output->legs + i );
	}
	soleWriteBaselinePelvis( rig, frame, soleScale( lowered, up ), output );
	output->capsuleShorter = state->capsuleShorter * unit;
	output->capsuleOffset = -output->capsuleShorter;
}

// ----------------------------------------------------------------------------------------------------------- solve

/// What the character does in its tick.
static void soleTickEffector( const soleRig* rig, const soleEffectorSettings* settings, soleEffectorState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, soleOutput* output )
{
	float timeStep = soleGetBaselineTimeStep( frame );
	if ( soleMovesEffector( state, frame ) )
	{
		soleResetEffectors( settings, state, timeStep, output->legCount );
		return;
	}
	float offsets[SOLE_MAX_LEGS] = { 0.0f };
	float lowest = soleReadOffsets( rig, settings, state, frame, hits, hitCount, offsets );
	soleUpdateEffectors( settings, state, timeStep, output->legCount, offsets, lowest );
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		soleWriteBaselineGround( rig, frame, i < hitCount ? hits + i : NULL, output->legs + i );
	}
}

void soleSolveEffector( const soleRig* rig, const soleEffectorSettings* settings, soleEffectorState* state,
    const soleFrame* frame, const soleHit* hits, int32_t hitCount, soleEffectorOutput* effectors, soleOutput* output )
{
	soleStartBaselineOutput( rig, frame, output );
	bool moves = soleMovesEffector( state, frame );
	if ( soleRunsEffector( settings, state ) )
	{
		soleTickEffector( rig, settings, state, frame, hits, hitCount, output );
	}
	state->hasRoot = true;
	state->root_w = frame->root.translation;
	if ( settings->enableAnimationIk )
	{
		soleRunEffectorGraph( rig, settings, state, frame, output );
	}
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		output->legs[i].plantWeight = moves ? 0.0f : soleGetBaselineWeight( frame, i );
	}
	if ( effectors != NULL )
	{
		effectors->hipOffset = state->hipOffset;
		effectors->capsuleHalfHeight = settings->capsuleHalfHeight - state->capsuleShorter;
		memcpy( effectors->effectors, state->effectors, sizeof effectors->effectors );
	}
}
