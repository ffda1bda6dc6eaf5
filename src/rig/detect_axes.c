// SPDX-License-Identifier: MIT
// Which way is up, which way the character faces, what its pelvis is, and whether its legs look like legs.
// Character space, bind pose.
#include "detect_internal.h"

#include <math.h>

#define SNAP_UP 0.82f     // cosine of 35 degrees: a body may lean
#define SNAP_FACING 0.97f // cosine of 15 degrees

static const soleVec3 soleAxes[6] = { { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { 1.0f, 0.0f, 0.0f },
	{ 0.0f, -1.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, { -1.0f, 0.0f, 0.0f } };
static const char* const soleAxisNames[6] = { "+Y", "+Z", "+X", "-Y", "-Z", "-X" };

static int32_t soleFindAxis( soleVec3 direction )
{
	int32_t best = 0;
	for ( int32_t i = 1; i < 6; ++i )
	{
		if ( soleDot( soleAxes[i], direction ) > soleDot( soleAxes[best], direction ) )
		{
			best = i;
		}
	}
	return best;
}

static bool soleIsGiven( soleVec3 v )
{
	return soleVec3_IsFinite( v ) && soleLength( v ) > 1e-6f;
}

static soleVec3 soleFootToHip( const soleDetect* detect )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		sum = soleMulAdd( sum, 1.0f / detect->size, soleSub( detect->position[leg->joints[0]], leg->ankle ) );
	}
	return soleNormalizeOr( sum, soleVec( 0.0f, 0.0f, 0.0f ) );
}

void soleFindUp( soleDetect* detect )
{
	soleVec3 legs = soleFootToHip( detect );
	if ( soleIsGiven( detect->skeleton->up ) )
	{
		detect->up = soleNormalizeOr( detect->skeleton->up, soleAxes[0] );
		if ( detect->legCount <= 2 && soleDot( legs, detect->up ) < 0.5f )
		{
			soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "check the up axis of the export",
			    "the hips are not above the feet along the given up axis: in the bind pose they lie towards %s",
			    soleAxisNames[soleFindAxis( legs )] );
		}
		return;
	}
	if ( soleIsGiven( detect->up ) )
	{
		return; // the structure told
	}
	int32_t axis = soleFindAxis( legs );
	float along = soleDot( legs, soleAxes[axis] );
	detect->up = along >= SNAP_UP ? soleAxes[axis] : soleNormalizeOr( legs, soleAxes[axis] );
	if ( along >= SNAP_UP )
	{
		soleAddFinding( detect, sole_info, SOLE_NONE, SOLE_NONE, "",
		    "up is %s: in the bind pose the hips are above the feet along it", soleAxisNames[axis] );
		return;
	}
	soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "tell the up axis",
	    "up is (%.2f, %.2f, %.2f), from feet to hips: no axis is within 35 degrees of that", (double)detect->up.x,
	    (double)detect->up.y, (double)detect->up.z );
}

// ---------------------------------------------------------------------------------------------------------- facing

/// Where the toes point, summed over the legs, along the floor, in leg lengths.
static soleVec3 soleSumToes( const soleDetect* detect )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		int32_t toe =
		    leg->tip != SOLE_NONE ? leg->tip : ( leg->toeCount > 0 ? leg->toes[leg->toeCount - 1] : SOLE_NONE );
		soleVec3 from = detect->position[soleFoundLeg_GetFoot( leg )];
		if ( toe != SOLE_NONE )
		{
			sum = soleMulAdd( sum, 1.0f / leg->length, soleSub( detect->position[toe], from ) );
		}
	}
	return soleReject( sum, detect->up );
}

/// The same from the skin: a foot is longer in front of the ankle than behind it.
static soleVec3 soleSumFeet( const soleDetect* detect )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount && detect->dominant != NULL; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		if ( leg->hasVirtualAnkle && leg->detachedFoot == SOLE_NONE )
		{
			continue; // the end of a shin points nowhere
		}
		int32_t foot = soleFoundLeg_GetFoot( leg );
		soleVec3 low = soleVec( 1e30f, 1e30f, 1e30f );
		soleVec3 high = soleNeg( low );
		for ( int32_t v = 0; v < detect->skeleton->skinCount; ++v )
		{
			soleVec3 p = soleSub( detect->skeleton->skin[v].position, leg->ankle );
			if ( detect->dominant[v] == foot && soleDot( p, detect->up ) <= 0.0f )
			{
				low = soleVec( soleMinF( low.x, p.x ), soleMinF( low.y, p.y ), soleMinF( low.z, p.z ) );
				high = soleVec( soleMaxF( high.x, p.x ), soleMaxF( high.y, p.y ), soleMaxF( high.z, p.z ) );
			}
		}
		if ( low.x <= high.x )
		{
			sum = soleMulAdd( sum, 1.0f / leg->length, soleAdd( low, high ) );
		}
	}
	return soleReject( sum, detect->up );
}

/// From the right hips to the left ones, along the floor.
static soleVec3 soleSumSides( const soleDetect* detect )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		float sign = leg->side == sole_left ? 1.0f : ( leg->side == sole_right ? -1.0f : 0.0f );
		if ( detect->legCount > 1 )
		{
			sum = soleMulAdd( sum, sign / detect->size, detect->position[leg->joints[0]] );
		}
	}
	return soleReject( sum, detect->up );
}

/// The nearest axis that is level, where it is near.
static soleVec3 soleSnapFacing( const soleDetect* detect, soleVec3 facing )
{
	int32_t axis = soleFindAxis( facing );
	soleVec3 level = soleReject( soleAxes[axis], detect->up );
	return soleDot( facing, soleAxes[axis] ) >= SNAP_FACING && soleLength( level ) > 0.99f
	    ? soleNormalizeOr( level, facing )
	    : facing;
}

static soleVec3 soleChooseForward( soleDetect* detect, const char** reason )
{
	const float least = 0.03f;
	soleVec3 zero = soleVec( 0.0f, 0.0f, 0.0f );
	soleVec3 toes = soleSumToes( detect );
	soleVec3 pointing = soleLength( toes ) > least ? toes : soleSumFeet( detect );
	pointing = soleLength( pointing ) > least ? soleNormalizeOr( pointing, zero ) : zero;
	soleVec3 sides = soleNormalizeOr( soleSumSides( detect ), zero );
	soleVec3 across = soleNormalizeOr( soleCross( sides, detect->up ), zero );
	bool named = detect->legs[0].sideFromName;
	if ( soleIsGiven( pointing ) && soleIsGiven( across ) )
	{
		float agree = soleDot( pointing, across );
		if ( agree < -0.5f && named )
		{
			soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE,
			    "fine for left-handed axes; else check the sides in the names or mirror the export",
			    "the toes point one way, left and right in the names say the other: the toes are believed" );
		}
		if ( agree > 0.5f || agree < -0.5f )
		{
			*reason = named ? "where the toes point, square to the line from right to left hip"
			                : "where the toes point, square to the line between the hips";
			return agree > 0.0f ? across : soleNeg( across );
		}
		if ( detect->legCount <= 2 )
		{
			soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "tell the facing",
			    "the toes do not point square to the line between the hips" );
		}
	}
	if ( soleIsGiven( pointing ) )
	{
		*reason = "where the toes point";
		return pointing;
	}
	if ( soleIsGiven( across ) && named )
	{
		*reason = "square to the line from right to left hip; no toes tell more";
		return across;
	}
	soleVec3 guess = soleIsGiven( across ) ? across : soleReject( soleAxes[1], detect->up );
	soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "tell the facing",
	    "neither toes nor names tell which way the character faces: this is a guess" );
	*reason = "a guess";
	return soleNormalizeOr( guess, soleAnyOrthogonal( detect->up ) );
}

/// Sides of legs that no name tells: left is where up x forward points.
static void soleAssignSides( soleDetect* detect )
{
	soleVec3 middle = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		middle = soleMulAdd( middle, 1.0f / (float)detect->legCount, detect->position[detect->legs[i].joints[0]] );
	}
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		soleFoundLeg* leg = detect->legs + i;
		if ( leg->sideFromName == false && detect->legCount > 1 )
		{
			float along = soleDot( soleSub( detect->position[leg->joints[0]], middle ), detect->lateral );
			leg->side = along > 0.0f ? sole_left : sole_right;
		}
	}
}

/// Front legs first, left before right: so that names and order do not hang on the order of joints.
static void soleSortLegs( soleDetect* detect )
{
	for ( int32_t i = 1; i < detect->legCount; ++i )
	{
		soleFoundLeg leg = detect->legs[i];
		float front = soleDot( detect->position[leg.joints[0]], detect->forward );
		int32_t j = i;
		while ( j > 0 )
		{
			const soleFoundLeg* other = detect->legs + j - 1;
			float otherFront = soleDot( detect->position[other->joints[0]], detect->forward );
			bool level = fabsf( front - otherFront ) < 0.01f * leg.length || detect->legCount <= 2;
			if ( level ? other->side <= leg.side : otherFront > front )
			{
				break;
			}
			detect->legs[j] = detect->legs[j - 1];
			j -= 1;
		}
		detect->legs[j] = leg;
	}
}

void soleFindForward( soleDetect* detect )
{
	const char* reason = "as given";
	if ( soleIsGiven( detect->skeleton->forward ) &&
	    soleLength( soleReject( soleNormalizeOr( detect->skeleton->forward, soleAxes[1] ), detect->up ) ) > 0.1f )
	{
		detect->forward = soleNormalizeOr( soleReject( detect->skeleton->forward, detect->up ), soleAxes[1] );
		soleVec3 toes = soleNormalizeOr( soleSumToes( detect ), detect->forward );
		if ( soleDot( toes, detect->forward ) < 0.0f )
		{
			soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "check the facing that was given",
			    "the toes point the other way than the given facing" );
		}
	}
	else
	{
		detect->forward = soleSnapFacing( detect, soleChooseForward( detect, &reason ) );
	}
	detect->lateral = soleNormalizeOr( soleCross( detect->up, detect->forward ), soleAnyOrthogonal( detect->up ) );
	soleAssignSides( detect );
	soleSortLegs( detect );
	soleAddFinding( detect, sole_info, SOLE_NONE, SOLE_NONE, "", "faces (%.2f, %.2f, %.2f), nearest to %s: %s",
	    (double)detect->forward.x, (double)detect->forward.y, (double)detect->forward.z,
	    soleAxisNames[soleFindAxis( detect->forward )], reason );
}

// ---------------------------------------------------------------------------------------------------------- pelvis

/// How much of the body above the hips hangs below this joint, and how much in all.
static void soleWeighBody( soleDetect* detect, int32_t pelvis, float hipHeight, float* inside, float* whole )
{
	*inside = 0.0f;
	*whole = 0.0f;
	for ( int32_t k = 0; k < detect->jointCount; ++k )
	{
		int32_t joint = detect->order[k];
		int32_t parent = detect->parents[joint];
		detect->ints[joint] = joint == pelvis || ( parent != SOLE_NONE && detect->ints[parent] != 0 ) ? 1 : 0;
		if ( soleDot( detect->position[joint], detect->up ) <= hipHeight )
		{
			continue;
		}
		float weight = detect->dominant != NULL ? (float)detect->skinnedCount[joint] : 1.0f;
		*whole += weight;
		*inside += detect->ints[joint] != 0 ? weight : 0.0f;
	}
}

bool soleFindPelvis( soleDetect* detect )
{
	int32_t pelvis = detect->parents[detect->legs[0].joints[0]];
	float hipHeight = -1e30f;
	float length = 0.0f;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		int32_t hip = detect->legs[i].joints[0];
		while ( pelvis != SOLE_NONE && ( hip == pelvis || soleDetect_IsBelow( detect, hip, pelvis ) == false ) )
		{
			pelvis = detect->parents[pelvis];
		}
		hipHeight = soleMaxF( hipHeight, soleDot( detect->position[hip], detect->up ) );
		length = soleMaxF( length, detect->legs[i].length );
	}
	if ( pelvis == SOLE_NONE )
	{
		soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE, "put all legs below one joint",
		    "no joint carries all hips: the pelvis can't be moved" );
		return false;
	}
	int32_t lowest = pelvis;
	float inside = 0.0f;
	float whole = 0.0f;
	// The spine may hang beside the joint that carries the hips: then both hang from one further up.
	soleWeighBody( detect, pelvis, hipHeight + 0.2f * length, &inside, &whole );
	for ( int32_t i = 0; i < SOLE_DETECT_WALK && inside < 0.5f * whole && detect->parents[pelvis] != SOLE_NONE; ++i )
	{
		pelvis = detect->parents[pelvis];
		soleWeighBody( detect, pelvis, hipHeight + 0.2f * length, &inside, &whole );
	}
	detect->pelvis = pelvis;
	soleAddFinding( detect, sole_info, SOLE_NONE, pelvis, "", "is the pelvis: %s",
	    pelvis == lowest ? "the lowest joint that carries all hips, and the body above them"
	                     : "the lowest joint that carries all hips and the body above them too" );
	return true;
}

// ---------------------------------------------------------------------------------------------------------- checks

static void soleCheckFoot( soleDetect* detect, int32_t index )
{
	const soleFoundLeg* leg = detect->legs + index;
	soleJointLabel last = soleLabelJoint( detect, leg->joints[leg->jointCount - 1] );
	if ( leg->ankleFromSkin )
	{
		soleAddFinding( detect, sole_warning, index, SOLE_NONE, "add an ankle joint if the foot should tilt",
		    "has no ankle joint: the leg ends at the middle of the skin's lowest vertices below %s", last.text );
	}
	else if ( leg->hasVirtualAnkle && leg->detachedFoot != SOLE_NONE )
	{
		soleAddFinding( detect, sole_info, index, SOLE_NONE, "",
		    "has no ankle joint below %s: the leg ends where the detached foot %s is", last.text,
		    soleLabelJoint( detect, leg->detachedFoot ).text );
	}
	else if ( leg->hasVirtualAnkle )
	{
		soleAddFinding( detect, sole_warning, index, SOLE_NONE, "add an ankle joint or give virtualAnkle by hand",
		    "no joint and no skin tells where the shin below %s ends: taken as long as the thigh", last.text );
	}
	else if ( leg->toeCount == 0 && leg->jointCount <= 3 )
	{
		soleAddFinding( detect, sole_info, index, SOLE_NONE, "", "no toe joint below %s: the foot is one stiff piece",
		    soleLabelJoint( detect, soleFoundLeg_GetFoot( leg ) ).text );
	}
}

static void soleCheckLeg( soleDetect* detect, int32_t index )
{
	const soleFoundLeg* leg = detect->legs + index;
	soleCheckFoot( detect, index );
	for ( int32_t i = 1; i < leg->jointCount; ++i )
	{
		float bone = soleDistance( detect->position[leg->joints[i - 1]], detect->position[leg->joints[i]] );
		if ( bone < 0.01f * leg->length )
		{
			soleAddFinding( detect, sole_warning, index, leg->joints[i], "move the joint or leave it out",
			    "the bone that ends at %s has next to no length", soleLabelJoint( detect, leg->joints[i] ).text );
		}
	}
	soleVec3 hip = detect->position[leg->joints[0]];
	float straight = soleDistance( hip, leg->ankle );
	if ( straight < 0.3f * leg->length && detect->legCount <= 2 )
	{
		soleAddFinding( detect, sole_warning, index, SOLE_NONE, "check the joints that were chosen",
		    "hip and ankle are close together in the bind pose: is this a leg?" );
	}
	if ( leg->jointCount == 3 && leg->hasVirtualAnkle == false )
	{
		float thigh = soleDistance( hip, detect->position[leg->joints[1]] );
		float shin = leg->length - thigh;
		if ( thigh > 2.5f * shin || shin > 2.5f * thigh )
		{
			soleAddFinding( detect, sole_warning, index, SOLE_NONE, "check the joints that were chosen",
			    "thigh %.3g and shin %.3g differ much in length", (double)thigh, (double)shin );
		}
	}
}

void soleCheckLegs( soleDetect* detect )
{
	int32_t left = SOLE_NONE;
	int32_t right = SOLE_NONE;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		soleCheckLeg( detect, i );
		left = detect->legs[i].side == sole_left ? i : left;
		right = detect->legs[i].side == sole_right ? i : right;
	}
	if ( detect->legCount == 1 )
	{
		soleAddFinding(
		    detect, sole_warning, 0, SOLE_NONE, "check the names of the other leg's joints", "only one leg was found" );
	}
	if ( detect->legCount == 2 && left != SOLE_NONE && right != SOLE_NONE )
	{
		float a = detect->legs[left].length;
		float b = detect->legs[right].length;
		if ( fabsf( a - b ) > 0.03f * ( a + b ) )
		{
			soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "check the joints that were chosen",
			    "the left leg is %.3g long, the right one %.3g", (double)a, (double)b );
		}
	}
}
