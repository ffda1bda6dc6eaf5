// SPDX-License-Identifier: MIT
// Everything that a rig definition can have wrong, each with a sentence that names the field and the mend.
#include "base/core.h"
#include "rig/rig.h"

#define SOLE_MAX_DEPTH 1024 // of a skeleton: deeper counts as a cycle

static const char* soleLegName( const soleRigDef* def, int32_t leg )
{
	const char* name = def->legs[leg].name;
	return name != NULL ? name : "";
}

static bool soleIsBelow( const soleRigDef* def, int32_t joint, int32_t ancestor )
{
	// Called after the parents were checked for cycles.
	for ( int32_t j = def->parents[joint]; j != SOLE_NONE; j = def->parents[j] )
	{
		if ( j == ancestor )
		{
			return true;
		}
	}
	return false;
}

static soleResult soleRefuse( void )
{
	return sole_invalidDefinition;
}

static soleResult soleValidateSkeleton( const soleRigDef* def, soleMessage* message )
{
	if ( def->jointCount < 1 || def->jointCount > 65535 )
	{
		soleSetMessage( message, "jointCount: is %d: give 1 to 65535 joints", def->jointCount );
		return soleRefuse();
	}
	if ( def->parents == NULL || def->bindPose == NULL )
	{
		soleSetMessage(
		    message, "%s: is NULL: point it to jointCount entries", def->parents == NULL ? "parents" : "bindPose" );
		return soleRefuse();
	}
	for ( int32_t i = 0; i < def->jointCount; ++i )
	{
		int32_t parent = def->parents[i];
		if ( parent < SOLE_NONE || parent >= def->jointCount || parent == i )
		{
			soleSetMessage( message, "parents[%d]: is %d: give a joint's index or SOLE_NONE", i, parent );
			return soleRefuse();
		}
		soleTransform t = def->bindPose[i];
		if ( !soleVec3_IsFinite( t.translation ) || !soleQuat_IsFinite( t.rotation ) || !soleVec3_IsFinite( t.scale ) )
		{
			soleSetMessage( message, "bindPose[%d]: is not finite: give numbers", i );
			return soleRefuse();
		}
	}
	for ( int32_t i = 0; i < def->jointCount; ++i )
	{
		int32_t steps = 0;
		for ( int32_t j = i; j != SOLE_NONE; j = def->parents[j] )
		{
			if ( ++steps > SOLE_MAX_DEPTH )
			{
				soleSetMessage( message,
				    "parents[%d]: is its own ancestor or more than %d joints deep: break the cycle", i,
				    SOLE_MAX_DEPTH );
				return soleRefuse();
			}
		}
	}
	return sole_success;
}

static soleResult soleValidateChain( const soleRigDef* def, int32_t leg, soleMessage* message )
{
	const soleLegDef* l = def->legs + leg;
	int32_t least = l->hasVirtualAnkle ? 1 : 2;
	if ( l->jointCount < least || l->jointCount > SOLE_MAX_LEG_JOINTS )
	{
		soleSetMessage( message, "legs[%d].jointCount: is %d: leg '%s' needs %d to %d joints, hip to ankle", leg,
		    l->jointCount, soleLegName( def, leg ), least, SOLE_MAX_LEG_JOINTS );
		return soleRefuse();
	}
	for ( int32_t i = 0; i < l->jointCount; ++i )
	{
		if ( l->joints[i] < 0 || l->joints[i] >= def->jointCount )
		{
			soleSetMessage( message, "legs[%d].joints[%d]: is %d: give an index below jointCount (%d)", leg, i,
			    l->joints[i], def->jointCount );
			return soleRefuse();
		}
		if ( i > 0 && !soleIsBelow( def, l->joints[i], l->joints[i - 1] ) )
		{
			soleSetMessage( message,
			    "legs[%d].joints[%d]: joint %d is not below joint %d: list the leg from hip to ankle", leg, i,
			    l->joints[i], l->joints[i - 1] );
			return soleRefuse();
		}
	}
	if ( !soleIsBelow( def, l->joints[0], def->pelvis ) && l->joints[0] != def->pelvis )
	{
		soleSetMessage( message,
		    "legs[%d].joints[0]: joint %d is not below the pelvis (joint %d): choose a pelvis that "
		    "carries all hips",
		    leg, l->joints[0], def->pelvis );
		return soleRefuse();
	}
	return sole_success;
}

static soleResult soleValidateFoot( const soleRigDef* def, int32_t leg, soleMessage* message )
{
	const soleLegDef* l = def->legs + leg;
	int32_t foot = l->joints[l->jointCount - 1];
	if ( l->detachedFoot != SOLE_NONE )
	{
		foot = l->detachedFoot;
		if ( foot < 0 || foot >= def->jointCount || soleIsBelow( def, foot, l->joints[0] ) )
		{
			soleSetMessage( message,
			    "legs[%d].detachedFoot: is %d: give a joint that is not below the hip, or SOLE_NONE", leg, foot );
			return soleRefuse();
		}
	}
	if ( l->toeCount < 0 || l->toeCount > SOLE_MAX_TOE_JOINTS )
	{
		soleSetMessage( message, "legs[%d].toeCount: is %d: give 0 to %d", leg, l->toeCount, SOLE_MAX_TOE_JOINTS );
		return soleRefuse();
	}
	for ( int32_t i = 0; i < l->toeCount; ++i )
	{
		if ( l->toes[i] < 0 || l->toes[i] >= def->jointCount || !soleIsBelow( def, l->toes[i], foot ) )
		{
			soleSetMessage( message, "legs[%d].toes[%d]: is %d: give a joint below the foot", leg, i, l->toes[i] );
			return soleRefuse();
		}
	}
	const soleVec3 points[] = { l->sole.heel, l->sole.ball, l->sole.toe, l->sole.inner, l->sole.outer, l->hinge,
		l->virtualAnkle };
	static const char* const names[] = { "sole.heel", "sole.ball", "sole.toe", "sole.inner", "sole.outer", "hinge",
		"virtualAnkle" };
	for ( int32_t i = 0; i < 7; ++i )
	{
		if ( !soleVec3_IsFinite( points[i] ) )
		{
			soleSetMessage( message, "legs[%d].%s: is not finite: give numbers", leg, names[i] );
			return soleRefuse();
		}
	}
	const float limits[] = { l->ankleLimits.dorsiflexion, l->ankleLimits.plantarflexion, l->ankleLimits.inversion,
		l->ankleLimits.eversion, l->ankleLimits.twist };
	for ( int32_t i = 0; i < 5; ++i )
	{
		if ( !( limits[i] >= 0.0f && limits[i] <= 1.5f ) )
		{
			soleSetMessage(
			    message, "legs[%d].ankleLimits: one is %g: give radians from 0 to 1.5", leg, (double)limits[i] );
			return soleRefuse();
		}
	}
	return sole_success;
}

soleResult soleRigDef_Validate( const soleRigDef* def, soleMessage* message )
{
	soleSetMessage( message, "%s", "" );
	if ( def == NULL || def->internalValue != SOLE_COOKIE )
	{
		soleSetMessage( message, "definition: was not made by soleDefaultRigDef(): start from that" );
		return soleRefuse();
	}
	soleResult result = soleValidateSkeleton( def, message );
	if ( result != sole_success )
	{
		return result;
	}
	if ( def->pelvis < 0 || def->pelvis >= def->jointCount )
	{
		soleSetMessage( message, "pelvis: is %d: give an index below jointCount (%d)", def->pelvis, def->jointCount );
		return soleRefuse();
	}
	if ( def->legCount < 1 || def->legCount > SOLE_MAX_LEGS )
	{
		soleSetMessage( message, "legCount: is %d: give 1 to %d legs", def->legCount, SOLE_MAX_LEGS );
		return soleRefuse();
	}
	if ( !soleVec3_IsFinite( def->up ) || !soleVec3_IsFinite( def->forward ) ||
	    soleLength( soleCross( def->up, def->forward ) ) < 1e-3f )
	{
		soleSetMessage( message, "up, forward: are not two directions: give unit vectors at right angles" );
		return soleRefuse();
	}
	for ( int32_t leg = 0; leg < def->legCount && result == sole_success; ++leg )
	{
		result = soleValidateChain( def, leg, message );
		if ( result == sole_success )
		{
			result = soleValidateFoot( def, leg, message );
		}
	}
	return result;
}
