// SPDX-License-Identifier: MIT
// Legs by the file's own bone map, else by what joints are called. Where several joints are called alike, those that
// move the skin are meant.
#include "detect_internal.h"

#include <string.h>

#define CANDIDATE_LIMIT 64 // feet of one side that are looked at

// ----------------------------------------------------------------------------------------------------------- roles

void soleFindLegsByRoles( soleDetect* detect )
{
	if ( detect->skeleton->roles == NULL )
	{
		return;
	}
	int32_t found[sole_roleHead + 1];
	for ( int32_t i = 0; i <= (int32_t)sole_roleHead; ++i )
	{
		found[i] = SOLE_NONE;
	}
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		soleJointRole role = detect->skeleton->roles[i];
		if ( role > sole_roleNone && role <= sole_roleHead && found[role] == SOLE_NONE )
		{
			found[role] = i;
		}
	}
	for ( int32_t right = 0; right < 2; ++right )
	{
		const int32_t* joints = found + ( right == 0 ? sole_roleLeftHip : sole_roleRightHip );
		if ( joints[0] == SOLE_NONE || joints[1] == SOLE_NONE || joints[2] == SOLE_NONE ||
		    soleDetect_IsBelow( detect, joints[1], joints[0] ) == false ||
		    soleDetect_IsBelow( detect, joints[2], joints[1] ) == false )
		{
			continue;
		}
		soleFoundLeg leg = soleEmptyLeg();
		memcpy( leg.joints, joints, 3 * sizeof( int32_t ) );
		leg.jointCount = 3;
		leg.side = right == 0 ? sole_left : sole_right;
		leg.sideFromName = true;
		if ( joints[3] != SOLE_NONE && soleDetect_IsBelow( detect, joints[3], joints[2] ) )
		{
			leg.toes[0] = joints[3];
			leg.toeCount = 1;
		}
		soleFoundLeg_Measure( detect, &leg );
		if ( leg.length > 1e-4f * detect->size )
		{
			detect->legs[detect->legCount++] = leg;
		}
	}
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		soleAddFinding( detect, sole_info, i, SOLE_NONE, "", "the file's own bone map says which joints they are" );
	}
}

// ----------------------------------------------------------------------------------------------------------- names

/// The nearest joint above with that part and side, or SOLE_NONE.
static int32_t soleFindAbove( const soleDetect* detect, int32_t joint, soleNamePart part, soleSide side )
{
	int32_t above = detect->parents[joint];
	for ( int32_t i = 0; i < SOLE_DETECT_WALK && above != SOLE_NONE; ++i, above = detect->parents[above] )
	{
		const soleJointName* name = detect->names + above;
		if ( name->part == part && name->side == side && name->end == false )
		{
			return above;
		}
	}
	return SOLE_NONE;
}

/// The top of a run of joints named alike: a thigh cut into twist segments begins at the first.
static int32_t soleClimbRun( const soleDetect* detect, int32_t joint )
{
	const soleJointName* name = detect->names + joint;
	int32_t top = joint;
	for ( int32_t i = 0; i < SOLE_DETECT_WALK; ++i )
	{
		int32_t above = detect->parents[top];
		if ( above == SOLE_NONE || detect->names[above].part != name->part || detect->names[above].side != name->side ||
		    detect->names[above].word != name->word )
		{
			break;
		}
		top = above;
	}
	return top;
}

/// Hip and knee of a leg whose end is given: what the ambiguous "leg" means is told by what else is there.
static bool soleFindThighAndShin( const soleDetect* detect, int32_t end, soleSide side, int32_t* hip, int32_t* knee )
{
	int32_t shin = soleFindAbove( detect, end, sole_partKnee, side );
	int32_t leg = soleFindAbove( detect, end, sole_partLeg, side );
	int32_t thigh = soleFindAbove( detect, end, sole_partHip, side );
	if ( shin == SOLE_NONE && leg != SOLE_NONE )
	{
		shin = leg;
	}
	if ( thigh == SOLE_NONE && leg != SOLE_NONE && leg != shin )
	{
		thigh = leg;
	}
	if ( shin == SOLE_NONE || thigh == SOLE_NONE )
	{
		return false;
	}
	*knee = soleClimbRun( detect, shin );
	*hip = soleClimbRun( detect, thigh );
	return soleDetect_IsBelow( detect, *knee, *hip ) && *knee != *hip;
}

/// Of "ankle" above "foot" the upper one is where the leg ends.
static int32_t soleClimbAnkle( const soleDetect* detect, int32_t ankle, int32_t knee )
{
	int32_t top = ankle;
	int32_t above = detect->parents[ankle];
	for ( int32_t i = 0; i < SOLE_DETECT_WALK && above != SOLE_NONE && above != knee; ++i )
	{
		if ( detect->names[above].part == sole_partAnkle && detect->names[above].side == detect->names[ankle].side )
		{
			top = above;
		}
		above = detect->parents[above];
	}
	return top;
}

/// Joints that move the skin are meant, where there are others of the same name.
static float soleRankLeg( const soleDetect* detect, const soleFoundLeg* leg )
{
	float rank = leg->length / detect->size;
	for ( int32_t i = 0; i < leg->jointCount; ++i )
	{
		rank += detect->skinnedCount[leg->joints[i]] > 0 ? 10.0f : 0.0f;
	}
	return rank;
}

static bool soleFindLegOfSide( const soleDetect* detect, soleSide side, soleFoundLeg* best )
{
	float bestRank = -1.0f;
	int32_t candidates = 0;
	for ( int32_t i = 0; i < detect->jointCount && candidates < CANDIDATE_LIMIT; ++i )
	{
		const soleJointName* name = detect->names + i;
		soleFoundLeg leg = soleEmptyLeg();
		if ( name->part != sole_partAnkle || name->side != side || name->end ||
		    soleFindThighAndShin( detect, i, side, leg.joints, leg.joints + 1 ) == false )
		{
			continue;
		}
		candidates += 1;
		leg.joints[2] = soleClimbAnkle( detect, i, leg.joints[1] );
		leg.jointCount = 3;
		leg.side = side;
		leg.sideFromName = true;
		soleFoundLeg_Measure( detect, &leg );
		float rank = soleRankLeg( detect, &leg );
		if ( rank > bestRank && leg.length > 1e-4f * detect->size )
		{
			bestRank = rank;
			*best = leg;
		}
	}
	return bestRank >= 0.0f;
}

/// The joint of the skeleton's own feet that ends a shin without an ankle: named alike but hung elsewhere.
static int32_t soleFindDetached( const soleDetect* detect, soleSide side, int32_t hip, soleVec3 near )
{
	int32_t best = SOLE_NONE;
	float bestDistance = 0.0f;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		const soleJointName* name = detect->names + i;
		if ( name->part != sole_partAnkle || name->side != side || name->end || soleDetect_IsBelow( detect, i, hip ) ||
		    soleDetect_IsBelow( detect, hip, i ) )
		{
			continue;
		}
		float distance = soleDistance( detect->position[i], near );
		distance *= detect->skinnedCount[i] > 0 ? 0.1f : 1.0f;
		if ( best == SOLE_NONE || distance < bestDistance )
		{
			best = i;
			bestDistance = distance;
		}
	}
	return best;
}

/// A child that only marks where the bone ends, or the only child there is.
static int32_t soleFindBoneEnd( const soleDetect* detect, int32_t joint )
{
	int32_t best = SOLE_NONE;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		if ( detect->parents[i] == joint && detect->names[i].control == false &&
		    soleDistance( detect->position[i], detect->position[joint] ) > 1e-3f * detect->size &&
		    ( best == SOLE_NONE || detect->names[i].end ) )
		{
			best = i;
		}
	}
	return best;
}

/// Thigh and shin without an ankle joint below them.
static bool soleFindLegWithoutAnkle( const soleDetect* detect, soleSide side, soleFoundLeg* best )
{
	float bestRank = -1.0f;
	int32_t candidates = 0;
	for ( int32_t i = 0; i < detect->jointCount && candidates < CANDIDATE_LIMIT; ++i )
	{
		const soleJointName* name = detect->names + i;
		int32_t hip = soleFindAbove( detect, i, sole_partHip, side );
		if ( ( name->part != sole_partKnee && name->part != sole_partLeg ) || name->side != side || name->end ||
		    hip == SOLE_NONE )
		{
			continue;
		}
		candidates += 1;
		soleFoundLeg leg = soleEmptyLeg();
		leg.joints[0] = soleClimbRun( detect, hip );
		leg.joints[1] = soleClimbRun( detect, i );
		leg.jointCount = 2;
		leg.side = side;
		leg.sideFromName = true;
		leg.hasVirtualAnkle = true;
		leg.ankle = detect->position[leg.joints[1]];
		soleFoundLeg_Measure( detect, &leg );
		float rank = soleRankLeg( detect, &leg );
		if ( rank > bestRank && leg.length > 1e-4f * detect->size )
		{
			bestRank = rank;
			*best = leg;
		}
	}
	if ( bestRank < 0.0f )
	{
		return false;
	}
	int32_t knee = best->joints[1];
	int32_t end = soleFindBoneEnd( detect, knee );
	soleVec3 thigh = soleSub( detect->position[knee], detect->position[best->joints[0]] );
	// Without anything at its end a shin is taken to be as long as the thigh; the skin corrects that later.
	soleVec3 near = end != SOLE_NONE ? detect->position[end] : soleAdd( detect->position[knee], thigh );
	best->detachedFoot = soleFindDetached( detect, side, best->joints[0], near );
	if ( end != SOLE_NONE )
	{
		best->joints[2] = end;
		best->jointCount = 3;
		best->hasVirtualAnkle = false;
	}
	else
	{
		best->ankle = best->detachedFoot != SOLE_NONE ? detect->position[best->detachedFoot] : near;
	}
	soleFoundLeg_Measure( detect, best );
	return true;
}

void soleFindLegsByNames( soleDetect* detect )
{
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleSide side = i == 0 ? sole_left : sole_right;
		soleFoundLeg leg = soleEmptyLeg();
		if ( soleFindLegOfSide( detect, side, &leg ) || soleFindLegWithoutAnkle( detect, side, &leg ) )
		{
			detect->legs[detect->legCount++] = leg;
		}
	}
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		soleJointLabel hip = soleLabelJoint( detect, leg->joints[0] );
		soleJointLabel knee = soleLabelJoint( detect, leg->joints[1] );
		soleJointLabel foot = soleLabelJoint( detect, soleFoundLeg_GetFoot( leg ) );
		soleAddFinding( detect, sole_info, i, SOLE_NONE, "", "by names: %s, %s, %s", hip.text, knee.text, foot.text );
	}
}
