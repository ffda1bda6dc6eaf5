// SPDX-License-Identifier: MIT
// Joints of a pose that is given parent-local, in character space. Skeletons are not checked as those of rigs are:
// every walk up is bounded by the number of joints.
#ifndef SOLE_LIMB_CHAIN_H
#define SOLE_LIMB_CHAIN_H

#include "sole/math.h"

/// Is joint somewhere below ancestor? Both, and all parents between them, have to be joints.
static inline bool soleIsJointBelow( const int32_t* parents, int32_t jointCount, int32_t joint, int32_t ancestor )
{
	bool inside = joint >= 0 && joint < jointCount && ancestor >= 0 && ancestor < jointCount;
	int32_t j = inside ? parents[joint] : SOLE_NONE;
	for ( int32_t i = 0; i < jointCount && j >= 0 && j < jointCount; ++i )
	{
		if ( j == ancestor )
		{
			return true;
		}
		j = parents[j];
	}
	return false;
}

/// A joint, and its parent's rotation: identity where it has none.
typedef struct soleJointPlace
{
	soleTransform joint;
	soleQuat parent;
} soleJointPlace;

static inline soleJointPlace soleFindJoint(
    const int32_t* parents, int32_t jointCount, const soleTransform* localPose, int32_t joint )
{
	soleJointPlace place = { localPose[joint], soleQuat_Identity() };
	int32_t j = parents[joint];
	for ( int32_t i = 0; i < jointCount && j >= 0 && j < jointCount; ++i )
	{
		place.joint = soleMulTransform( localPose[j], place.joint );
		place.parent = soleMulQuat( localPose[j].rotation, place.parent );
		j = parents[j];
	}
	return place;
}

static inline bool soleIsPlaceFinite( const soleJointPlace* place )
{
	return soleVec3_IsFinite( place->joint.translation ) && soleQuat_IsFinite( place->joint.rotation );
}

/// A weight as it counts.
static inline float soleClampWeight( float weight )
{
	return weight > 0.0f ? soleMinF( weight, 1.0f ) : 0.0f;
}

/// The part of a rotation that a weight leaves; all of it, to the bit, where the weight is 1.
static inline soleQuat solePartOf( soleQuat rotation, float weight )
{
	return weight < 1.0f ? soleNlerp( soleQuat_Identity(), rotation, weight ) : rotation;
}

#endif
