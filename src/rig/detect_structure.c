// SPDX-License-Identifier: MIT
// Legs by structure, where names do not help: chains whose ends are on the floor, climbed up to the joint where they
// meet the others, taken in pairs that mirror each other. Character space, bind pose.
#include "detect_internal.h"

#include <math.h>
#include <string.h>

#define CANDIDATE_LIMIT 48
#define CHAIN_LIMIT 24
#define TIP_LIMIT 128

/// A chain that may be a leg: from the joint below the body to a joint at the floor.
typedef struct soleChain
{
	int32_t joints[CHAIN_LIMIT];
	int32_t count;
	float length;
	bool used;
} soleChain;

/// One attempt with one up axis.
typedef struct soleAttempt
{
	soleVec3 up;
	float floor;
	float height; // of the whole, over the floor
	int32_t tips[TIP_LIMIT];
	int32_t tipCount;
	soleChain chains[CANDIDATE_LIMIT];
	int32_t chainCount;
	soleFoundLeg legs[SOLE_MAX_LEGS];
	int32_t legCount;
	float score;
} soleAttempt;

static float soleHeight( const soleDetect* detect, const soleAttempt* attempt, int32_t joint )
{
	return soleDot( detect->position[joint], attempt->up ) - attempt->floor;
}

/// Joints that belong to a body: meshes, cameras and lights that hang about alone do not.
static bool soleIsBody( const soleDetect* detect, int32_t joint )
{
	int32_t parent = detect->parents[joint];
	if ( detect->dominant == NULL )
	{
		return parent != SOLE_NONE;
	}
	return detect->skinnedCount[joint] > 0 || ( parent != SOLE_NONE && detect->skinnedCount[parent] > 0 );
}

/// floats[joint]: the lowest of the joint and of the skin that it moves.
static void soleMeasureReach( soleDetect* detect, soleAttempt* attempt )
{
	float* reach = detect->floats;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		reach[i] = soleDot( detect->position[i], attempt->up );
	}
	for ( int32_t i = 0; i < detect->skeleton->skinCount && detect->dominant != NULL; ++i )
	{
		int32_t joint = detect->dominant[i];
		if ( joint != SOLE_NONE )
		{
			reach[joint] = soleMinF( reach[joint], soleDot( detect->skeleton->skin[i].position, attempt->up ) );
		}
	}
	float low = 1e30f;
	float high = -1e30f;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		if ( soleIsBody( detect, i ) )
		{
			low = soleMinF( low, reach[i] );
			high = soleMaxF( high, soleDot( detect->position[i], attempt->up ) );
		}
	}
	attempt->floor = low;
	attempt->height = soleMaxF( high - low, 1e-6f * detect->size );
}

/// Leaves near the floor.
static void soleFindTips( soleDetect* detect, soleAttempt* attempt )
{
	attempt->tipCount = 0;
	for ( int32_t i = 0; i < detect->jointCount && attempt->tipCount < TIP_LIMIT; ++i )
	{
		if ( detect->childCount[i] == 0 && soleIsBody( detect, i ) &&
		    detect->floats[i] - attempt->floor < 0.15f * attempt->height )
		{
			attempt->tips[attempt->tipCount++] = i;
		}
	}
}

/// Whether all tips below this joint belong to one foot: few, close together, and the joint itself is low.
static bool soleIsOneFoot( const soleDetect* detect, const soleAttempt* attempt, int32_t joint )
{
	float height = soleHeight( detect, attempt, joint );
	int32_t first = SOLE_NONE;
	float spread = 0.0f;
	for ( int32_t i = 0; i < attempt->tipCount; ++i )
	{
		int32_t tip = attempt->tips[i];
		int32_t walk = tip;
		for ( int32_t k = 0; k < SOLE_DETECT_WALK && walk != SOLE_NONE && walk != joint; ++k )
		{
			walk = detect->parents[walk];
		}
		if ( walk != joint )
		{
			continue;
		}
		if ( first == SOLE_NONE )
		{
			first = tip;
			continue;
		}
		soleVec3 apart = soleSub( detect->position[tip], detect->position[first] );
		spread = soleMaxF( spread, soleLength( soleReject( apart, attempt->up ) ) );
	}
	return spread <= 0.0f ||
	    ( height < 0.3f * attempt->height && spread < 2.0f * soleMaxF( height, 0.02f * attempt->height ) );
}

/// From a tip up to the last joint that carries no other foot.
static bool soleClimbChain( const soleDetect* detect, const soleAttempt* attempt, int32_t tip, soleChain* chain )
{
	int32_t walk[CHAIN_LIMIT];
	int32_t count = 0;
	int32_t joint = tip;
	while ( joint != SOLE_NONE && soleIsOneFoot( detect, attempt, joint ) )
	{
		if ( count == CHAIN_LIMIT )
		{
			return false;
		}
		walk[count++] = joint;
		joint = detect->parents[joint];
	}
	if ( joint == SOLE_NONE || count == 0 )
	{
		return false; // a whole skeleton on one foot, or a tip of its own
	}
	*chain = ( soleChain ){ 0 };
	for ( int32_t i = count - 1; i >= 0; --i )
	{
		int32_t last = chain->count > 0 ? chain->joints[chain->count - 1] : SOLE_NONE;
		float bone = last == SOLE_NONE ? 0.0f : soleDistance( detect->position[last], detect->position[walk[i]] );
		if ( last == SOLE_NONE || bone > 1e-4f * detect->size )
		{
			chain->joints[chain->count++] = walk[i];
			chain->length += bone;
		}
	}
	return true;
}

static void soleFindChains( soleDetect* detect, soleAttempt* attempt )
{
	attempt->chainCount = 0;
	for ( int32_t i = 0; i < attempt->tipCount; ++i )
	{
		soleChain chain;
		if ( soleClimbChain( detect, attempt, attempt->tips[i], &chain ) == false )
		{
			continue;
		}
		int32_t same = 0;
		while ( same < attempt->chainCount && attempt->chains[same].joints[0] != chain.joints[0] )
		{
			same += 1;
		}
		if ( same == attempt->chainCount && same < CANDIDATE_LIMIT )
		{
			attempt->chains[attempt->chainCount++] = chain;
		}
		else if ( same < attempt->chainCount && chain.length > attempt->chains[same].length )
		{
			attempt->chains[same] = chain;
		}
	}
}

// ------------------------------------------------------------------------------------------------- chain into leg

static float soleBone( const soleDetect* detect, const int32_t* joints, int32_t end )
{
	return soleDistance( detect->position[joints[end - 1]], detect->position[joints[end]] );
}

/// Whether the way from one joint to another runs along the floor: by more than that share of how far it goes down.
static bool soleRunsAlong( const soleDetect* detect, const soleAttempt* attempt, int32_t from, int32_t to, float share )
{
	soleVec3 way = soleSub( detect->position[to], detect->position[from] );
	return soleLength( soleReject( way, attempt->up ) ) > -share * soleDot( way, attempt->up );
}

/// Index of the joint where the leg ends and the foot begins: the first low one from which the way to the tip runs
/// along the floor rather than down to it, the next bone included, or else a hock would count.
static int32_t soleFindAnkleIndex(
    const soleDetect* detect, const soleAttempt* attempt, const int32_t* joints, int32_t count )
{
	float hip = soleHeight( detect, attempt, joints[0] );
	for ( int32_t i = 2; i < count - 1; ++i )
	{
		if ( soleHeight( detect, attempt, joints[i] ) < 0.35f * hip &&
		    soleRunsAlong( detect, attempt, joints[i], joints[count - 1], 0.7f ) &&
		    soleRunsAlong( detect, attempt, joints[i], joints[i + 1], 0.5f ) )
		{
			return i;
		}
	}
	return count - 1;
}

static bool soleMakeLeg(
    const soleDetect* detect, const soleAttempt* attempt, const soleChain* chain, soleFoundLeg* leg )
{
	const int32_t* joints = chain->joints;
	int32_t count = chain->count;
	*leg = soleEmptyLeg();
	int32_t ankle = count >= 3 ? soleFindAnkleIndex( detect, attempt, joints, count ) : count - 1;
	float longest = 0.0f;
	for ( int32_t i = 1; i <= ankle; ++i )
	{
		longest = soleMaxF( longest, soleBone( detect, joints, i ) );
	}
	// A short bone that only leads from the spine out to the hip is no part of the leg.
	while ( ankle >= 3 && ( detect->names[joints[0]].girdle || soleBone( detect, joints, 1 ) < 0.45f * longest ) )
	{
		joints += 1;
		count -= 1;
		ankle -= 1;
	}
	int32_t last = joints[ankle];
	float below = soleDot( detect->position[last], attempt->up ) - detect->floats[last];
	float hip = soleHeight( detect, attempt, joints[0] );
	// A shin without a joint at its end: its skin goes on far below the last joint.
	leg->hasVirtualAnkle = ankle == count - 1 && below > 0.35f * hip;
	if ( ankle + ( leg->hasVirtualAnkle ? 1 : 0 ) < 2 )
	{
		return false;
	}
	// Longer chains than a leg may have: the shortest bones in the middle are taken as stiff.
	int32_t skip = ankle + 1 - SOLE_MAX_LEG_JOINTS;
	for ( int32_t i = 0; i <= ankle; ++i )
	{
		bool middle = i > 0 && i < ankle - 1;
		if ( middle && skip > 0 )
		{
			skip -= 1;
			continue;
		}
		leg->joints[leg->jointCount++] = joints[i];
	}
	if ( leg->hasVirtualAnkle )
	{
		leg->ankle = soleMulAdd( detect->position[last], -below, attempt->up );
	}
	soleFoundLeg_Measure( detect, leg );
	leg->side = detect->names[leg->joints[0]].side;
	leg->side = leg->side != sole_center ? leg->side : detect->names[leg->joints[1]].side;
	float highest = hip; // a spider's body is low between its knees
	for ( int32_t i = 1; i < leg->jointCount; ++i )
	{
		highest = soleMaxF( highest, soleHeight( detect, attempt, leg->joints[i] ) );
	}
	return highest > 0.1f * leg->length && leg->length > 1e-3f * detect->size;
}

/// A low short chain that begins where another leg ends is that leg's foot, hung elsewhere.
static void soleMergeFeet( const soleDetect* detect, soleAttempt* attempt )
{
	for ( int32_t i = 0; i < attempt->legCount; ++i )
	{
		soleFoundLeg* leg = attempt->legs + i;
		int32_t best = SOLE_NONE;
		float bestDistance = 0.15f * attempt->height;
		for ( int32_t j = 0; j < attempt->legCount; ++j )
		{
			const soleFoundLeg* foot = attempt->legs + j;
			float distance = soleDistance( detect->position[foot->joints[0]], leg->ankle );
			if ( j != i && leg->detachedFoot == SOLE_NONE && foot->length < 0.5f * leg->length &&
			    distance < bestDistance && soleDetect_IsBelow( detect, leg->joints[0], foot->joints[0] ) == false )
			{
				best = j;
				bestDistance = distance;
			}
		}
		if ( best != SOLE_NONE )
		{
			leg->detachedFoot = attempt->legs[best].joints[0];
			attempt->legCount -= 1;
			memmove( attempt->legs + best, attempt->legs + best + 1,
			    (size_t)( attempt->legCount - best ) * sizeof( soleFoundLeg ) );
			i -= best <= i ? 1 : 0;
		}
	}
}

/// A paw that hangs from elsewhere, and the leg that ends where it is.
static void soleFindDetachedLegs( soleDetect* detect, soleAttempt* attempt )
{
	for ( int32_t i = 0; i < attempt->chainCount && attempt->legCount < SOLE_MAX_LEGS; ++i )
	{
		soleChain* chain = attempt->chains + i;
		int32_t paw = chain->joints[0];
		if ( chain->used || chain->count > 3 )
		{
			continue;
		}
		int32_t best = SOLE_NONE;
		float bestDistance = 0.12f * attempt->height;
		soleDetect_MarkBelow( detect, paw );
		for ( int32_t j = 0; j < detect->jointCount; ++j )
		{
			float distance = soleDistance( detect->position[j], detect->position[paw] );
			if ( detect->childCount[j] == 0 && distance < bestDistance && detect->ints[j] == 0 )
			{
				best = j;
				bestDistance = distance;
			}
		}
		soleChain whole = { 0 };
		int32_t walk[CHAIN_LIMIT];
		int32_t count = 0;
		for ( int32_t j = best; j != SOLE_NONE && count < CHAIN_LIMIT; j = detect->parents[j] )
		{
			if ( count > 0 && detect->childCount[j] > 1 )
			{
				break;
			}
			walk[count++] = j;
		}
		for ( int32_t j = count - 1; j >= 0; --j )
		{
			whole.joints[whole.count++] = walk[j];
		}
		soleFoundLeg* leg = attempt->legs + attempt->legCount;
		if ( count >= 3 && soleMakeLeg( detect, attempt, &whole, leg ) )
		{
			leg->detachedFoot = paw;
			attempt->legCount += 1;
			chain->used = true;
		}
	}
}

// -------------------------------------------------------------------------------------------------------- attempts

static void soleTryUp( soleDetect* detect, soleAttempt* attempt, soleVec3 up )
{
	memset( attempt, 0, sizeof *attempt );
	attempt->up = up;
	soleMeasureReach( detect, attempt );
	soleFindTips( detect, attempt );
	soleFindChains( detect, attempt );
	for ( int32_t i = 0; i < attempt->chainCount && attempt->legCount < SOLE_MAX_LEGS; ++i )
	{
		attempt->chains[i].used =
		    soleMakeLeg( detect, attempt, attempt->chains + i, attempt->legs + attempt->legCount );
		attempt->legCount += attempt->chains[i].used ? 1 : 0;
	}
	soleFindDetachedLegs( detect, attempt );
	soleMergeFeet( detect, attempt );
	attempt->legCount = soleKeepMirroredLegs( detect, up, attempt->legs, attempt->legCount );
	for ( int32_t i = 0; i < attempt->legCount; ++i )
	{
		const soleFoundLeg* leg = attempt->legs + i;
		float drop = soleDot( soleSub( detect->position[leg->joints[0]], leg->ankle ), up );
		attempt->score += soleMaxF( drop, 0.0f ) / detect->size;
	}
}

/// Sides that names tell are believed where they tell all of them, as many left ones as right ones.
static void soleTrustSides( soleDetect* detect )
{
	int32_t balance = 0;
	bool all = true;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		balance += detect->legs[i].side == sole_left ? 1 : -1;
		all = all && detect->legs[i].side != sole_center;
	}
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		detect->legs[i].sideFromName = all && balance == 0;
	}
}

void soleFindLegsByStructure( soleDetect* detect )
{
	static const soleVec3 axes[6] = { { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { 1.0f, 0.0f, 0.0f },
		{ 0.0f, -1.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, { -1.0f, 0.0f, 0.0f } };
	soleAttempt attempts[2];
	soleVec3 given = detect->skeleton->up;
	bool isGiven = soleVec3_IsFinite( given ) && soleLength( given ) > 1e-6f;
	int32_t best = SOLE_NONE;
	for ( int32_t i = 0; i < ( isGiven ? 1 : 6 ); ++i )
	{
		int32_t at = best == 0 ? 1 : 0;
		soleTryUp( detect, attempts + at, isGiven ? soleNormalizeOr( given, axes[0] ) : axes[i] );
		// Y and Z are up by most conventions: another axis must show clearly longer legs.
		attempts[at].score *= i == 0 ? 1.5f : ( i == 1 ? 1.2f : 1.0f );
		if ( attempts[at].legCount > 0 && ( best == SOLE_NONE || attempts[at].score > attempts[best].score ) )
		{
			best = at;
		}
	}
	if ( best == SOLE_NONE || attempts[best].legCount <= detect->legCount )
	{
		return;
	}
	detect->legCount = attempts[best].legCount;
	detect->byNames = false;
	memcpy( detect->legs, attempts[best].legs, sizeof detect->legs );
	detect->up = attempts[best].up;
	soleTrustSides( detect );
	soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "check the joints that were chosen",
	    "names do not tell the legs: %d chains that reach the floor in mirrored pairs are taken",
	    (int)detect->legCount );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		const soleFoundLeg* leg = detect->legs + i;
		soleJointLabel hip = soleLabelJoint( detect, leg->joints[0] );
		soleJointLabel foot = soleLabelJoint( detect, soleFoundLeg_GetFoot( leg ) );
		soleAddFinding( detect, sole_info, SOLE_NONE, leg->joints[0], "", "by structure: %d joints from %s to %s",
		    (int)leg->jointCount, hip.text, foot.text );
	}
}
