// SPDX-License-Identifier: MIT
// Limbs with a goal and a hint. Character space; results parent-local.
//
// The end is brought to its weighted goal by the two-bone kernel (place/leg.c), which gives rotations C of the whole
// limb and B of the lower bone, both to be put before the animated ones. Then the limb is turned by S about the line a
// from first joint to end: the bend axis n = k x s, k and s the new bones, has the middle joint in the direction a x n;
// the half of the angle from there to the hint comes from sum and difference of the two directions. Where the limb is
// nearly straight n is leaned on the hinge, as in the kernel. With P the rotation of a joint's parent, J that of the
// joint, both animated,
//   upper' = P^-1 ( S C ) J      lower' = P^-1 B J      end' = P'^-1 G,  P' = S C B P,  G the goal
// where the turns above a joint cancel out.
#include "sole/limb.h"

#include "base/core.h"
#include "base/math_internal.h"
#include "limb/chain.h"
#include "sole/sole.h"

#define NEARLY_STRAIGHT 0.05f // sine of the flexion below which the hinge is leaned on
#define HINT_ZONE 0.05f       // share of the bones' length within which a hint fades
#define LEAST_DISTANCE 2e-4f  // likewise, of a goal from the first joint: the kernel takes no less than half of it
#define LEAST_BEND 0.0175f    // sine of the flexion from which a hinge can be taken

soleLimbDef soleDefaultLimbDef( void )
{
	return ( soleLimbDef ){
		.upper = SOLE_NONE,
		.lower = SOLE_NONE,
		.end = SOLE_NONE,
		.reach = 1.0f,
		.softZone = 0.02f,
		.internalValue = SOLE_COOKIE,
	};
}

bool soleLimbDef_IsValid( const soleLimbDef* def )
{
	return def != NULL && def->internalValue == SOLE_COOKIE && def->parents != NULL &&
	    soleIsJointBelow( def->parents, def->jointCount, def->lower, def->upper ) &&
	    soleIsJointBelow( def->parents, def->jointCount, def->end, def->lower ) && soleVec3_IsFinite( def->hinge_l ) &&
	    def->reach >= 0.0f && def->reach <= 1.0f && def->fold >= 0.0f && def->fold <= 1.0f && def->softZone >= 0.0f &&
	    def->softZone <= 1.0f;
}

/// The animated limb.
typedef struct soleLimbPose
{
	soleJointPlace upper;
	soleJointPlace lower;
	soleJointPlace end;
	soleVec3 hinge;
} soleLimbPose;

/// @return false where it is not finite
static bool soleReadLimb( const soleLimbDef* def, const soleTransform* localPose, soleLimbPose* pose )
{
	pose->upper = soleFindJoint( def->parents, def->jointCount, localPose, def->upper );
	pose->lower = soleFindJoint( def->parents, def->jointCount, localPose, def->lower );
	pose->end = soleFindJoint( def->parents, def->jointCount, localPose, def->end );
	pose->hinge = soleRotate( pose->upper.joint.rotation, def->hinge_l );
	return soleIsPlaceFinite( &pose->upper ) && soleIsPlaceFinite( &pose->lower ) && soleIsPlaceFinite( &pose->end );
}

bool soleLimbDef_FindHinge( soleLimbDef* def, const soleTransform* localPose )
{
	bool usable = soleLimbDef_IsValid( def ) && localPose != NULL;
	SOLE_ASSERT( usable );
	soleLimbPose pose;
	if ( usable == false || soleReadLimb( def, localPose, &pose ) == false )
	{
		return false;
	}
	soleVec3 k = soleSub( pose.lower.joint.translation, pose.upper.joint.translation );
	soleVec3 s = soleSub( pose.end.joint.translation, pose.lower.joint.translation );
	soleVec3 n = soleCross( k, s );
	float bones = soleLength( k ) * soleLength( s );
	float length = soleLength( n );
	if ( !( length > LEAST_BEND * bones ) || !( length > 0.0f ) )
	{
		return false;
	}
	def->hinge_l = soleInvRotate( pose.upper.joint.rotation, soleScale( 1.0f / length, n ) );
	return true;
}

// ---------------------------------------------------------------------------------------------------------- solve

/// Rotations to be put before the animated ones, and where the end comes to.
typedef struct soleLimbTurn
{
	soleQuat limb;
	soleQuat lower;
	soleVec3 end;
} soleLimbTurn;

static uint32_t soleTellFlags( uint32_t legFlags )
{
	uint32_t flags = 0;
	flags |= ( legFlags & (uint32_t)sole_legSoftened ) != 0 ? (uint32_t)sole_limbSoftened : 0u;
	flags |= ( legFlags & (uint32_t)sole_legOutOfReach ) != 0 ? (uint32_t)sole_limbOutOfReach : 0u;
	flags |= ( legFlags & (uint32_t)sole_legFolded ) != 0 ? (uint32_t)sole_limbFolded : 0u;
	flags |= ( legFlags & (uint32_t)sole_legDegenerate ) != 0 ? (uint32_t)sole_limbDegenerate : 0u;
	return flags;
}

/// Limits give way to the animation: a goal at the animated place changes nothing.
static soleLimbTurn soleReachGoal( const soleLimbDef* def, const soleLimbPose* pose, soleVec3 target, uint32_t* flags )
{
	soleTwoBoneDef two = {
		.hip = pose->upper.joint.translation,
		.knee = pose->lower.joint.translation,
		.ankle = pose->end.joint.translation,
		.target = target,
		.hinge = pose->hinge,
	};
	float bones = soleDistance( two.hip, two.knee ) + soleDistance( two.knee, two.ankle );
	float animated = soleDistance( two.hip, two.ankle );
	float least = LEAST_DISTANCE * bones;
	if ( !( soleDistance( target, two.hip ) >= least ) )
	{
		soleVec3 along = soleSub( two.ankle, two.hip );
		soleVec3 way = animated > least ? soleScale( 1.0f / animated, along ) : soleVec( 0.0f, 0.0f, 0.0f );
		two.target = soleMulAdd( two.hip, least, way );
		*flags |= (uint32_t)sole_limbDegenerate;
	}
	float share = bones > 0.0f ? soleMinF( animated / bones, 1.0f ) : 0.0f;
	two.reach = soleMaxF( def->reach, share );
	two.fold = soleMinF( def->fold, share );
	two.softZone = soleMinF( def->softZone, two.reach - share ) * bones;
	soleTwoBoneResult result = soleSolveTwoBone( &two );
	*flags |= soleTellFlags( result.flags );
	return ( soleLimbTurn ){ result.hip, result.knee, result.ankle };
}

/// The half of the angle from one unit vector to another about an axis at right angles to both: |a + b| is twice its
/// cosine, |a - b| twice its sine. Unlike the form from cosine and sine of the whole it loses nothing near half a turn.
static soleHalf soleHalfBetween( soleVec3 a, soleVec3 b, soleVec3 axis )
{
	float c = soleLength( soleAdd( a, b ) );
	float s = soleLength( soleSub( a, b ) );
	float scale = 1.0f / sqrtf( c * c + s * s );
	return ( soleHalf ){ scale * c, soleDot( axis, soleCross( a, b ) ) < 0.0f ? -scale * s : scale * s };
}

/// Turns the limb about the line from its first joint to its end.
static soleQuat soleFollowHint(
    const soleLimbPose* pose, const soleLimbTurn* turn, const soleLimbHint* hint, float weight )
{
	soleVec3 first = pose->upper.joint.translation;
	soleVec3 middle = soleSub( pose->lower.joint.translation, first );
	soleVec3 k = soleRotate( turn->limb, middle );
	soleVec3 s = soleSub( soleSub( turn->end, first ), k );
	soleVec3 line = soleSub( turn->end, first );
	float a = soleLength( k ), b = soleLength( s ), length = soleLength( line );
	float bones = a + b;
	if ( !( length > LEAST_DISTANCE * bones ) || !( a > 1e-6f * bones ) || !( b > 1e-6f * bones ) )
	{
		return soleQuat_Identity();
	}
	soleVec3 axis = soleScale( 1.0f / length, line );
	soleVec3 hinge = soleRotate( turn->limb, pose->hinge );
	soleVec3 reference = soleNormalizeOr( soleReject( hinge, axis ), soleAnyOrthogonal( axis ) );
	soleVec3 n = soleScale( 1.0f / ( a * b ), soleCross( k, s ) );
	float bend = soleLength( n );
	n = bend < NEARLY_STRAIGHT ? soleMulAdd( n, NEARLY_STRAIGHT - bend, reference ) : n;
	soleVec3 from = soleNormalizeOr( soleCross( axis, n ), reference );
	soleVec3 across = soleScale( 1.0f / bones, soleReject( soleSub( hint->position, first ), axis ) );
	float off = soleLength( across );
	if ( !( off > 0.0f ) )
	{
		return soleQuat_Identity();
	}
	soleHalf half = soleHalfBetween( from, soleScale( 1.0f / off, across ), axis );
	return solePartOf( soleHalfRotation( axis, half ), weight * soleMinF( off / HINT_ZONE, 1.0f ) );
}

static bool soleIsGoalFinite( const soleLimbGoal* goal, const soleLimbHint* hint, soleLimbGoal weights, float hinted )
{
	return ( weights.positionWeight <= 0.0f || soleVec3_IsFinite( goal->position ) ) &&
	    ( weights.rotationWeight <= 0.0f || soleQuat_IsFinite( goal->rotation ) ) &&
	    ( hinted <= 0.0f || soleVec3_IsFinite( hint->position ) );
}

/// A joint's rotation with one put before it in character space, as its parent sees it.
static soleQuat soleTurnLocal( const soleJointPlace* place, soleQuat turn )
{
	soleQuat turned = soleMulQuat( turn, place->joint.rotation );
	return soleNormalizeQuat( soleMulQuat( soleConjugate( place->parent ), turned ) );
}

soleLimbResult soleSolveLimb(
    const soleLimbDef* def, const soleTransform* localPose, const soleLimbGoal* goal, const soleLimbHint* hint )
{
	soleQuat none = soleQuat_Identity();
	soleLimbResult result = { .upper_l = none, .lower_l = none, .end_l = none, .flags = (uint32_t)sole_limbBadInput };
	bool usable = soleLimbDef_IsValid( def ) && localPose != NULL && goal != NULL;
	SOLE_ASSERT( usable );
	if ( usable == false )
	{
		return result;
	}
	result.upper_l = localPose[def->upper].rotation;
	result.lower_l = localPose[def->lower].rotation;
	result.end_l = localPose[def->end].rotation;
	soleLimbPose pose;
	soleLimbGoal weights = { .positionWeight = soleClampWeight( goal->positionWeight ),
		.rotationWeight = soleClampWeight( goal->rotationWeight ) };
	float hinted = hint != NULL ? soleClampWeight( hint->weight ) : 0.0f;
	bool finite = soleReadLimb( def, localPose, &pose );
	result.end = pose.end.joint.translation;
	if ( finite == false || soleIsGoalFinite( goal, hint, weights, hinted ) == false )
	{
		return result;
	}
	result.flags = 0;
	soleLimbTurn turn = { none, none, result.end };
	if ( weights.positionWeight > 0.0f )
	{
		soleVec3 target = weights.positionWeight < 1.0f ? soleLerp( result.end, goal->position, weights.positionWeight )
		                                                : goal->position;
		turn = soleReachGoal( def, &pose, target, &result.flags );
		result.end = turn.end;
		result.error = soleFiniteOr( soleDistance( turn.end, target ), 3e38f );
		result.lower_l = soleTurnLocal( &pose.lower, turn.lower );
	}
	if ( hinted > 0.0f )
	{
		turn.limb = soleNormalizeQuat( soleMulQuat( soleFollowHint( &pose, &turn, hint, hinted ), turn.limb ) );
	}
	if ( weights.positionWeight > 0.0f || hinted > 0.0f )
	{
		result.upper_l = soleTurnLocal( &pose.upper, turn.limb );
	}
	if ( weights.rotationWeight > 0.0f )
	{
		soleQuat carried = soleMulQuat( soleMulQuat( turn.limb, turn.lower ), pose.end.parent );
		soleQuat wanted = soleNormalizeQuat( soleMulQuat( soleConjugate( carried ), goal->rotation ) );
		result.end_l =
		    weights.rotationWeight < 1.0f ? soleNlerp( result.end_l, wanted, weights.rotationWeight ) : wanted;
	}
	return result;
}

void soleApplyLimb( const soleLimbDef* def, const soleLimbResult* result, soleTransform* localPose )
{
	bool usable = soleLimbDef_IsValid( def ) && result != NULL && localPose != NULL;
	SOLE_ASSERT( usable );
	if ( usable )
	{
		localPose[def->upper].rotation = result->upper_l;
		localPose[def->lower].rotation = result->lower_l;
		localPose[def->end].rotation = result->end_l;
	}
}
