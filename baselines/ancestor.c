// SPDX-License-Identifier: MIT
// How a host feeds the four systems. Curves are those of the frame's contact and steps; where the character jumps a
// system starts anew, for none of them knows jumps. World, units of the frame's root.
#include "baselines/ancestor.h"

#define CURVE_RAMP 0.15f // s, of drawn curves

size_t soleAncestor_GetByteCount( void )
{
	return sizeof( soleAncestor );
}

static void soleForget( soleAncestor* ancestor, const soleRig* rig )
{
	switch ( ancestor->kind )
	{
	case sole_ancestorHomebrew:
		ancestor->state.homebrew = soleDefaultHomebrewState( rig );
		break;
	case sole_ancestorIkSetting:
		ancestor->state.ikSetting = soleDefaultIkSettingState( rig );
		break;
	case sole_ancestorEffector:
		ancestor->state.effector = soleDefaultEffectorState( rig );
		break;
	default:
		ancestor->state.ozz = soleDefaultOzzState( rig );
	}
}

void soleStartAncestor(
    soleAncestor* ancestor, soleAncestorKind kind, const soleRig* rig, const soleTransform* bindPose )
{
	ancestor->kind = kind;
	switch ( kind )
	{
	case sole_ancestorHomebrew:
		ancestor->settings.homebrew = soleDefaultHomebrewSettings();
		soleFitHomebrewSettings( rig, &ancestor->settings.homebrew );
		break;
	case sole_ancestorIkSetting:
		ancestor->settings.ikSetting = soleDefaultIkSettingSettings();
		soleFitIkSettingSettings( rig, &ancestor->settings.ikSetting );
		break;
	case sole_ancestorEffector:
		ancestor->settings.effector = soleDefaultEffectorSettings();
		soleFitEffectorSettings( rig, &ancestor->settings.effector );
		break;
	default:
		ancestor->settings.ozz = soleDefaultOzzSettings();
		soleFitOzzSettings( rig, bindPose, &ancestor->settings.ozz );
	}
	soleForget( ancestor, rig );
}

// --------------------------------------------------------------------------------------------------------- feeding

/// What an animator would draw into the clip for one foot: 1 while any of it stands, with a ramp before and after. A
/// foot of which nothing is known stands.
static float soleDrawFootCurve( const soleFrame* frame, int32_t leg )
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
static float soleDrawCurve( const soleRig* rig, const soleFrame* frame, bool right )
{
	float curve = 0.0f;
	for ( int32_t i = 0; i < soleRig_GetLegCount( rig ); ++i )
	{
		bool ofSide = ( soleRig_GetLeg( rig, i ).side == sole_right ) == right;
		curve = ofSide ? soleMaxF( curve, soleDrawFootCurve( frame, i ) ) : curve;
	}
	return curve;
}

/// The effector switches itself off when it is there, and the game has to switch it on again: here, whenever the root
/// moves, so that it goes back while moving and looks anew when the character stands.
static void soleWakeEffector( soleEffectorState* state, const soleFrame* frame )
{
	soleVec3 moved = soleSub( frame->root.translation, state->root_w );
	bool moves = state->hasRoot && soleDot( moved, moved ) > 0.0f;
	state->usingFootIk = state->usingFootIk || moves;
}

int32_t soleGatherAncestor( soleAncestor* ancestor, const soleRig* rig, const soleFrame* frame, soleProbe* probes )
{
	const int32_t most = SOLE_ANCESTOR_MAX_PROBES;
	if ( frame->teleport )
	{
		soleForget( ancestor, rig );
	}
	switch ( ancestor->kind )
	{
	case sole_ancestorHomebrew:
		return soleGatherHomebrew( rig, &ancestor->settings.homebrew, &ancestor->state.homebrew, frame, probes, most );
	case sole_ancestorIkSetting:
		return soleGatherIkSetting(
		    rig, &ancestor->settings.ikSetting, &ancestor->state.ikSetting, frame, probes, most );
	case sole_ancestorEffector:
		soleWakeEffector( &ancestor->state.effector, frame );
		return soleGatherEffector( rig, &ancestor->settings.effector, &ancestor->state.effector, frame, probes, most );
	default:
		return soleGatherOzz( rig, &ancestor->settings.ozz, &ancestor->state.ozz, frame, probes, most );
	}
}

static void soleSolveWithCurves( soleAncestor* ancestor, const soleRig* rig, const soleFrame* frame,
    const soleHit* hits, int32_t hitCount, soleOutput* output )
{
	const soleIkSettingSettings* settings = &ancestor->settings.ikSetting;
	const soleIkSettingCurve drawn[] = {
		{ settings->leftFootAnimVariableName, soleDrawCurve( rig, frame, false ) },
		{ settings->rightFootAnimVariableName, soleDrawCurve( rig, frame, true ) },
	};
	soleIkSettingCurves curves = { drawn, 2 };
	soleSolveIkSetting( rig, settings, &ancestor->state.ikSetting, frame, &curves, hits, hitCount, output );
}

void soleSolveAncestor( soleAncestor* ancestor, const soleRig* rig, const soleFrame* frame, const soleHit* hits,
    int32_t hitCount, soleOutput* output )
{
	switch ( ancestor->kind )
	{
	case sole_ancestorHomebrew:
		soleSolveHomebrew(
		    rig, &ancestor->settings.homebrew, &ancestor->state.homebrew, frame, hits, hitCount, output );
		break;
	case sole_ancestorIkSetting:
		soleSolveWithCurves( ancestor, rig, frame, hits, hitCount, output );
		break;
	case sole_ancestorEffector:
		soleSolveEffector(
		    rig, &ancestor->settings.effector, &ancestor->state.effector, frame, hits, hitCount, NULL, output );
		break;
	default:
		soleSolveOzz( rig, &ancestor->settings.ozz, &ancestor->state.ozz, frame, hits, hitCount, output );
	}
}
