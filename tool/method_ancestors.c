// SPDX-License-Identifier: MIT
// The systems that Sole is compared with, set as a careful user would set them for the character; Sole's own settings
// do not reach them. Where the walk jumps they start anew, as a host would make them.
#include "method_ancestors.h"

#include "baselines/homebrew.h"
#include "baselines/iksetting.h"

// What every method has of a frame.
typedef struct toolAncestorCasts
{
	soleProbe probes[SOLE_MAX_LEGS];
	soleHit hits[SOLE_MAX_LEGS];
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
	    soleGatherHomebrew( rig, &memory->settings, &memory->state, step->frame, casts->probes, SOLE_MAX_LEGS );
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

/// What an animator would put into the clip for the feet of one side: on while any of them stands. A foot of which
/// nothing is known counts as standing.
static float toolDrawCurve( const toolMethodStep* step, bool right )
{
	float curve = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( step->character->rig ); ++i )
	{
		soleContactInput contact = { -1.0f, -1.0f };
		contact = step->frame->contact != NULL ? step->frame->contact[i] : contact;
		float stands = contact.heel < 0.0f || contact.toe < 0.0f ? 1.0f : soleMaxF( contact.heel, contact.toe );
		bool ofSide = ( soleRig_GetLeg( step->character->rig, i ).side == sole_right ) == right;
		curve = ofSide ? soleMaxF( curve, stands ) : curve;
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
	    soleGatherIkSetting( rig, &memory->settings, &memory->state, step->frame, casts->probes, SOLE_MAX_LEGS );
	soleCastProbes( step->ground, casts->probes, count, casts->hits );
	soleSolveIkSetting(
	    rig, &memory->settings, &memory->state, step->frame, &curves, casts->hits, count, &casts->output );
	toolApplyAncestor( casts, step );
}
