// SPDX-License-Identifier: MIT
// Where the joints and sole points of a sampled motion are, in double precision.
#ifndef SOLE_MEASURE_POSE_H
#define SOLE_MEASURE_POSE_H

#include "measure/double.h"
#include "sole/measure.h"
#include "sole/sole.h"

/// Room to evaluate one pose of a rig.
typedef struct soleMeasurePose
{
	const soleRig* rig;
	int32_t jointCount;
	int32_t* order; // joints, each after its parent
	soleTransformd* joints;
} soleMeasurePose;

/// False where there is no memory; soleFreeMeasurePose() is then allowed, not needed.
bool soleMakeMeasurePose( const soleRig* rig, const soleAllocator* allocator, soleMeasurePose* pose );
void soleFreeMeasurePose( const soleAllocator* allocator, soleMeasurePose* pose );

/// Fills in all joints of a frame of a motion, in character space.
void soleEvaluateCharacter( soleMeasurePose* pose, const soleMotion* motion, int32_t frame );
/// The same in the world.
void soleEvaluateWorld( soleMeasurePose* pose, const soleMotion* motion, int32_t frame );

/// A point that a joint carries.
typedef struct soleCarriedPoint
{
	int32_t joint;
	soleVec3 position; // local space of the joint
} soleCarriedPoint;

soleCarriedPoint soleGetHeelPoint( const soleRig* rig, int32_t leg );
/// Carried by the fore part, as what stays on the ground while the heel is raised.
soleCarriedPoint soleGetBallPoint( const soleRig* rig, int32_t leg );
soleCarriedPoint soleGetTipPoint( const soleRig* rig, int32_t leg );
soleVec3d soleGetCarried( const soleMeasurePose* pose, soleCarriedPoint point );

/// Hip to ankle of a leg, a virtual ankle included, in the space that was evaluated.
/// @return how many there are.
int32_t soleGetLegChain( const soleMeasurePose* pose, int32_t leg, soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1] );

/// What a motion lacks to be usable, NULL where it is complete. name is that of the field.
soleResult soleCheckMotion( const soleMotion* motion, const char* name, soleMessage* message );

#endif
