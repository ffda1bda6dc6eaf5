// SPDX-License-Identifier: MIT
// The systems that Sole is compared with, set as a careful user would set them for the character; Sole's own settings
// do not reach them. Where the walk jumps they start anew, as a host would make them.
#include "method_ancestors.h"

#include "baselines/effector.h"
#include "baselines/homebrew.h"
#include "baselines/iksetting.h"
#include "baselines/ozz.h"

#define CURVE_RAMP 0.15f                  // s, of drawn curves
#define MOST_PROBES ( 1 + SOLE_MAX_LEGS ) // one at the root

// What every method has of a frame.
typedef struct toolAncestorCasts
{
	soleProbe probes[MOST_PROBES];
	soleHit hits[MOST_PROBES];
	soleOutput output;
} toolAncestorCasts;

static void toolApplyAncestor( const toolAncestorCasts* casts, const toolMethodStep* step )
{
	soleApply( step->character->rig, &casts->output, step->pose );
	for ( int32_t i = 0; i < casts->output.legCount; ++i )
	{
		step->flags[i] = casts->output.legs[i].flags;
		step->plantWeights[i] = casts->output.legs[i].plantWeight;
	}
	*step->pelvisOffset = casts->output.pelvisOffset_w;
}

// -------------------------------------------------------------------------------------------------------- homebrew

typedef struct toolHomebrewMemory
{
	soleHomebrewSettings settings;
	soleHomebrewState state;
	toolAncestorCasts casts;
} toolHomebrewMemory;

void* toolStartHomebrew( const toolCharacter* character )
{
	toolHomebrewMemory* memory = toolAlloc( 1, sizeof *memory );
	memory->settings = soleDefaultHomebrewSettings();
	soleFitHomebrewSettings( character->rig, &memory->settings );
	memory->state = soleDefaultHomebrewState( character->rig );
	return memory;
}

void toolStepHomebrew( void* user, const toolMethodStep* step )
{
	toolHomebrewMemory* memory = user;
	toolAncestorCasts* casts = &memory->casts;
	const soleRig* rig = step->character->rig;
	if ( step->frame->teleport )
	{
		memory->state = soleDefaultHomebrewState( rig );
	}
	int32_t count =
	    soleGatherHomebrew( rig, &memory->settings, &memory->state, step->frame, casts->probes, MOST_PROBES );
	soleCastProbes( step->ground, casts->probes, count, casts->hits );
	soleSolveHomebrew( rig, &memory->settings, &memory->state, step->frame, casts->hits, count, &casts->output );
	toolApplyAncestor( casts, step );
}

// ------------------------------------------------------------------------------------------------------- iksetting

typedef struct toolIkSettingMemory
{
	soleIkSettingSettings settings;
	soleIkSettingState state;
	toolAncestorCasts casts;
} toolIkSettingMemory;

void* toolStartIkSetting( const toolCharacter* character )
{
	toolIkSettingMemory* memory = toolAlloc( 1, sizeof *memory );
	memory->settings = soleDefaultIkSettingSettings();
	soleFitIkSettingSettings( character->rig, &memory->settings );
	memory->state = soleDefaultIkSettingState( character->rig );
	return memory;
}

/// What an animator would draw into the clip for one foot: 1 while any of it stands, with a ramp before and after. A
/// foot of which nothing is known stands.
static float toolDrawFootCurve( const soleFrame* frame, int32_t leg )
{
	if ( frame->contact == NULL || frame->contact[leg].heel < 0.0f || frame->contact[leg].toe < 0.0f )
	{
		return 1.0f;
	}
	float stands = soleMaxF( frame->contact[leg].heel, frame->contact[leg].toe );
	if ( frame->steps == NULL )
	{
		return stands;
	}
	const soleStepInput* step = frame->steps + leg;
	float lifted = step->since >= 0.0f ? 1.0f - step->since / CURVE_RAMP : 0.0f;
	float landing = step->until >= 0.0f ? 1.0f - step->until / CURVE_RAMP : 0.0f;
	return soleMaxF( stands, soleMaxF( lifted, landing ) );
}

/// Legs of one side share a curve: it is on while any of them stands.
static float toolDrawCurve( const toolMethodStep* step, bool right )
{
	float curve = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( step->character->rig ); ++i )
	{
		bool ofSide = ( soleRig_GetLeg( step->character->rig, i ).side == sole_right ) == right;
		curve = ofSide ? soleMaxF( curve, toolDrawFootCurve( step->frame, i ) ) : curve;
	}
	return curve;
}

void toolStepIkSetting( void* user, const toolMethodStep* step )
{
	toolIkSettingMemory* memory = user;
	toolAncestorCasts* casts = &memory->casts;
	const soleRig* rig = step->character->rig;
	if ( step->frame->teleport )
	{
		memory->state = soleDefaultIkSettingState( rig );
	}
	const soleIkSettingCurve drawn[] = {
		{ memory->settings.leftFootAnimVariableName, toolDrawCurve( step, false ) },
		{ memory->settings.rightFootAnimVariableName, toolDrawCurve( step, true ) },
	};
	soleIkSettingCurves curves = { drawn, 2 };
	int32_t count =
	    soleGatherIkSetting( rig, &memory->settings, &memory->state, step->frame, casts->probes, MOST_PROBES );
	soleCastProbes( step->ground, casts->probes, count, casts->hits );
	soleSolveIkSetting(
	    rig, &memory->settings, &memory->state, step->frame, &curves, casts->hits, count, &casts->output );
	toolApplyAncestor( casts, step );
}

// ------------------------------------------------------------------------------------------------------------- ozz

typedef struct toolOzzMemory
{
	soleOzzSettings settings;
	soleOzzState state;
	toolAncestorCasts casts;
} toolOzzMemory;

void* toolStartOzz( const toolCharacter* character )
{
	toolOzzMemory* memory = toolAlloc( 1, sizeof *memory );
	memory->settings = soleDefaultOzzSettings();
	soleFitOzzSettings( character->rig, character->bindPose, &memory->settings );
	memory->state = soleDefaultOzzState( character->rig );
	return memory;
}

void toolStepOzz( void* user, const toolMethodStep* step )
{
	toolOzzMemory* memory = user;
	toolAncestorCasts* casts = &memory->casts;
	const soleRig* rig = step->character->rig;
	if ( step->frame->teleport )
	{
		memory->state = soleDefaultOzzState( rig );
	}
	int32_t count = soleGatherOzz( rig, &memory->settings, &memory->state, step->frame, casts->probes, MOST_PROBES );
	soleCastProbes( step->ground, casts->probes, count, casts->hits );
	soleSolveOzz( rig, &memory->settings, &memory->state, step->frame, casts->hits, count, &casts->output );
	toolApplyAncestor( casts, step );
}

// -------------------------------------------------------------------------------------------------------- effector

typedef struct toolEffectorMemory
{
	soleEffectorSettings settings;
	soleEffectorState state;
	toolAncestorCasts casts;
} toolEffectorMemory;

void* toolStartEffector( const toolCharacter* character )
{
	toolEffectorMemory* memory = toolAlloc( 1, sizeof *memory );
	memory->settings = soleDefaultEffectorSettings();
	soleFitEffectorSettings( character->rig, &memory->settings );
	memory->state = soleDefaultEffectorState( character->rig );
	return memory;
}

/// It switches itself off when it is there, and the game has to switch it on again: here, whenever the root moves, so
/// that it goes back while moving and looks anew when the character stands.
static void toolWakeEffector( soleEffectorState* state, const soleFrame* frame )
{
	soleVec3 moved = soleSub( frame->root.translation, state->root_w );
	bool moves = state->hasRoot && soleDot( moved, moved ) > 0.0f;
	state->usingFootIk = state->usingFootIk || moves;
}

void toolStepEffector( void* user, const toolMethodStep* step )
{
	toolEffectorMemory* memory = user;
	toolAncestorCasts* casts = &memory->casts;
	const soleRig* rig = step->character->rig;
	if ( step->frame->teleport )
	{
		memory->state = soleDefaultEffectorState( rig );
	}
	toolWakeEffector( &memory->state, step->frame );
	int32_t count =
	    soleGatherEffector( rig, &memory->settings, &memory->state, step->frame, casts->probes, MOST_PROBES );
	soleCastProbes( step->ground, casts->probes, count, casts->hits );
	soleSolveEffector( rig, &memory->settings, &memory->state, step->frame, casts->hits, count, NULL, &casts->output );
	toolApplyAncestor( casts, step );
}
