// SPDX-License-Identifier: MIT
// A head that looks at something. Character space; results parent-local.
//
// The line of sight is the ray e + t f, e the place between the eyes, f unit. Where it has to point is settled first:
// from the animated f0 by the shortest turn towards the target T, no further than the limit, of that the weighted part;
// the target is then taken to be there, at its own distance r = |T - e0|. Each joint, at J, in turn aims at it: with
// o = e - J the ray meets the sphere about J on which T lies where
//   |o + t f| = |T - J| = R,   t = -o.f + sqrt( (o.f)^2 - |o|^2 + R^2 )
// and the joint turns from o + t f to T - J, by its share of the shares that are left. The last takes all of it, so the
// ray goes through T although the eyes move. R has no root where T is too near: T is moved away along its direction, to
// at least 2.5 |o|, where the root is real however the head is held: from r >= 2 |o| on it is
// (o.f)^2 + 2 r (o.d) + r^2 >= r^2 - 2 r |o|, d the direction from e to T. As the eyes move the direction of the gaze
// may end up beyond the limit after all: the last joint takes that back.
#include "sole/limb.h"

#include "base/core.h"
#include "base/math_internal.h"
#include "limb/chain.h"

#define MOST_TURN 2.0f      // rad: beyond it coming back from one side to the other would be too quick
#define LEAST_DISTANCE 2.5f // of a target, in ways from a joint to the eyes
#define BEHIND_FADE 0.05f   // square of the cosine of half of the angle below which the weight fades

soleLookDef soleDefaultLookDef( void )
{
	soleLookDef def = { .forward_l = { 0.0f, 0.0f, 1.0f }, .limit = 1.2f, .internalValue = SOLE_COOKIE };
	for ( int32_t i = 0; i < SOLE_MAX_LOOK_JOINTS; ++i )
	{
		def.joints[i] = SOLE_NONE;
		def.shares[i] = 1.0f;
	}
	return def;
}

/// Of a joint and those above it.
static float soleSumShares( const soleLookDef* def, int32_t first )
{
	float sum = 0.0f;
	for ( int32_t i = first; i < def->lookCount; ++i )
	{
		sum += def->shares[i];
	}
	return sum;
}

bool soleLookDef_IsValid( const soleLookDef* def )
{
	if ( def == NULL || def->internalValue != SOLE_COOKIE || def->parents == NULL || def->lookCount < 1 ||
	    def->lookCount > SOLE_MAX_LOOK_JOINTS )
	{
		return false;
	}
	for ( int32_t i = 0; i < def->lookCount; ++i )
	{
		bool below = i > 0 ? soleIsJointBelow( def->parents, def->jointCount, def->joints[i], def->joints[i - 1] )
		                   : def->joints[0] >= 0 && def->joints[0] < def->jointCount;
		if ( below == false || !( def->shares[i] >= 0.0f ) || soleIsFinite( def->shares[i] ) == false )
		{
			return false;
		}
	}
	float sum = soleSumShares( def, 0 );
	float forward = soleLength( def->forward_l );
	return sum > 0.0f && soleIsFinite( sum ) && forward > 0.99f && forward < 1.01f &&
	    soleVec3_IsFinite( def->eyes_l ) && def->limit >= 0.0f && def->limit <= MOST_TURN;
}

/// A head on its way from the animated pose to that which looks at the target.
typedef struct soleLookWork
{
	soleJointPlace joints[SOLE_MAX_LOOK_JOINTS]; // animated
	soleVec3 places[SOLE_MAX_LOOK_JOINTS];       // now
	soleVec3 eyes;
	soleVec3 gaze;
	soleQuat turn; // of all joints so far
} soleLookWork;

/// @return false where the pose is not finite
static bool soleReadLook( const soleLookDef* def, const soleTransform* localPose, soleLookWork* work )
{
	bool finite = true;
	for ( int32_t i = 0; i < def->lookCount; ++i )
	{
		work->joints[i] = soleFindJoint( def->parents, def->jointCount, localPose, def->joints[i] );
		work->places[i] = work->joints[i].joint.translation;
		finite = finite && soleIsPlaceFinite( work->joints + i );
	}
	soleTransform head = work->joints[def->lookCount - 1].joint;
	work->eyes = soleTransformPoint( head, def->eyes_l );
	work->gaze = soleRotate( head.rotation, def->forward_l );
	work->turn = soleQuat_Identity();
	return finite && soleVec3_IsFinite( work->eyes );
}

/// A rotation by at most the limit.
static soleQuat soleLimitTurn( soleQuat turn, soleHalf limit, uint32_t* flags )
{
	soleVec3 v = soleVec( turn.x, turn.y, turn.z );
	float sine = soleLength( v );
	if ( turn.w >= limit.c || !( sine > 0.0f ) )
	{
		return turn;
	}
	*flags |= (uint32_t)sole_limbClamped;
	return soleHalfRotation( soleScale( 1.0f / sine, v ), limit );
}

/// The turn from one direction to another, about an axis of no meaning where they are opposite.
static soleQuat soleSwing( soleVec3 from, soleVec3 to )
{
	return soleFromTo( from, to, soleAnyOrthogonal( from ) );
}

/// Turns one joint, and all that hangs from it, by q in character space.
static void soleTurnFrom( soleLookWork* work, int32_t first, int32_t count, soleQuat q )
{
	soleVec3 pivot = work->places[first];
	for ( int32_t i = first + 1; i < count; ++i )
	{
		work->places[i] = soleAdd( pivot, soleRotate( q, soleSub( work->places[i], pivot ) ) );
	}
	work->eyes = soleAdd( pivot, soleRotate( q, soleSub( work->eyes, pivot ) ) );
	work->gaze = soleNormalizeOr( soleRotate( q, work->gaze ), work->gaze );
	work->turn = soleNormalizeQuat( soleMulQuat( q, work->turn ) );
}

/// What a joint has to turn by so that the line of sight goes through the target.
static soleQuat soleAim( const soleLookWork* work, int32_t joint, soleVec3 from, soleVec3 direction, float distance )
{
	soleVec3 pivot = work->places[joint];
	soleVec3 o = soleSub( work->eyes, pivot );
	float apart = soleMaxF( distance, LEAST_DISTANCE * soleLength( o ) );
	soleVec3 to = soleSub( soleMulAdd( from, apart, direction ), pivot );
	float along = soleDot( o, work->gaze );
	float root = along * along - soleDot( o, o ) + soleDot( to, to );
	soleVec3 ray = soleMulAdd( o, soleSqrtF( root ) - along, work->gaze );
	float a = soleLength( ray ), b = soleLength( to );
	if ( !( a > 0.0f ) || !( b > 0.0f ) )
	{
		return soleQuat_Identity();
	}
	return soleSwing( soleScale( 1.0f / a, ray ), soleScale( 1.0f / b, to ) );
}

/// The last joint that does a share.
static int32_t soleLastLooking( const soleLookDef* def )
{
	int32_t last = def->lookCount - 1;
	while ( last > 0 && !( def->shares[last] > 0.0f ) )
	{
		--last;
	}
	return last;
}

/// All joints in turn. direction: where to look; distance: how far away that is.
static void soleTurnHead( const soleLookDef* def, soleVec3 direction, float distance, soleHalf limit,
    soleLookWork* work, soleLookResult* result )
{
	soleVec3 from = work->eyes;
	soleVec3 gaze = work->gaze;
	int32_t last = soleLastLooking( def );
	for ( int32_t i = 0; i <= last; ++i )
	{
		soleQuat before = work->turn;
		float share = i < last ? def->shares[i] / soleSumShares( def, i ) : 1.0f;
		if ( !( share > 0.0f ) )
		{
			continue; // rides along
		}
		soleTurnFrom( work, i, def->lookCount, solePartOf( soleAim( work, i, from, direction, distance ), share ) );
		if ( i == last )
		{
			soleQuat allowed = soleLimitTurn( soleSwing( gaze, work->gaze ), limit, &result->flags );
			soleTurnFrom( work, i, def->lookCount, soleSwing( work->gaze, soleRotate( allowed, gaze ) ) );
		}
		// before J is how the joint stands by what is below it alone; its parent stands likewise.
		soleQuat parent = soleMulQuat( before, work->joints[i].parent );
		soleQuat joint = soleMulQuat( work->turn, work->joints[i].joint.rotation );
		result->rotations_l[i] = soleNormalizeQuat( soleMulQuat( soleConjugate( parent ), joint ) );
	}
}

soleLookResult soleSolveLookAt( const soleLookDef* def, const soleTransform* localPose, soleVec3 target, float weight )
{
	soleLookResult result = { .gaze = { 0.0f, 0.0f, 1.0f }, .flags = (uint32_t)sole_limbBadInput };
	for ( int32_t i = 0; i < SOLE_MAX_LOOK_JOINTS; ++i )
	{
		result.rotations_l[i] = soleQuat_Identity();
	}
	bool usable = soleLookDef_IsValid( def ) && localPose != NULL;
	SOLE_ASSERT( usable );
	if ( usable == false )
	{
		return result;
	}
	for ( int32_t i = 0; i < def->lookCount; ++i )
	{
		result.rotations_l[i] = localPose[def->joints[i]].rotation;
	}
	soleLookWork work;
	weight = soleClampWeight( weight );
	if ( soleReadLook( def, localPose, &work ) == false || ( weight > 0.0f && soleVec3_IsFinite( target ) == false ) )
	{
		return result;
	}
	soleVec3 way = soleSub( target, work.eyes );
	float distance = soleLength( way );
	result.flags = 0;
	result.eyes = work.eyes;
	result.gaze = work.gaze;
	if ( weight > 0.0f && distance > 0.0f && soleIsFinite( distance ) )
	{
		soleHalf limit = soleHalfFromAngle( def->limit );
		soleQuat swing = soleSwing( work.gaze, soleScale( 1.0f / distance, way ) );
		float fade = soleMinF( swing.w * swing.w / BEHIND_FADE, 1.0f );
		soleQuat turn = solePartOf( soleLimitTurn( swing, limit, &result.flags ), weight * fade );
		soleTurnHead( def, soleRotate( turn, work.gaze ), distance, limit, &work, &result );
		result.eyes = work.eyes;
		result.gaze = work.gaze;
	}
	else if ( weight > 0.0f )
	{
		result.flags = (uint32_t)sole_limbDegenerate;
	}
	return result;
}

void soleApplyLook( const soleLookDef* def, const soleLookResult* result, soleTransform* localPose )
{
	bool usable = soleLookDef_IsValid( def ) && result != NULL && localPose != NULL;
	SOLE_ASSERT( usable );
	for ( int32_t i = 0; usable && i < def->lookCount; ++i )
	{
		localPose[def->joints[i]].rotation = result->rotations_l[i];
	}
}
