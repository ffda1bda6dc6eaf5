// SPDX-License-Identifier: MIT
// Foot placement. Create a rig once; then every frame and character: gather probes, cast them at whatever the ground
// is, solve, apply. Nothing here allocates but soleCreateRig(); all of it may be called from any thread.
#ifndef SOLE_SOLE_H
#define SOLE_SOLE_H

#include "sole/types.h"

// ----------------------------------------------------------------------------------------------------------- rigs

SOLE_API soleLegDef soleDefaultLegDef( void );
SOLE_API soleRigDef soleDefaultRigDef( void );

/// Checks everything that soleCreateRig() would refuse.
/// @param message what is wrong and how to mend it. May be NULL.
SOLE_API soleResult soleRigDef_Validate( const soleRigDef* def, soleMessage* message );

/// @param allocator NULL: malloc and free.
/// @param rig set to NULL on failure.
/// @param message what is wrong and how to mend it. May be NULL.
SOLE_API soleResult soleCreateRig(
    const soleRigDef* def, const soleAllocator* allocator, soleRig** rig, soleMessage* message );

/// NULL is allowed.
SOLE_API void soleDestroyRig( soleRig* rig );

SOLE_API int32_t soleRig_GetJointCount( const soleRig* rig );
SOLE_API int32_t soleRig_GetParent( const soleRig* rig, int32_t joint );
SOLE_API int32_t soleRig_GetLegCount( const soleRig* rig );
/// The definition of a leg as it was given, its name and hinge filled in. The name lives as long as the rig.
SOLE_API soleLegDef soleRig_GetLeg( const soleRig* rig, int32_t leg );
SOLE_API int32_t soleRig_GetPelvis( const soleRig* rig );
/// The joint that carries the trunk: of the pelvis's children that lead to no leg the one that carries most joints.
/// SOLE_NONE where there is none.
SOLE_API int32_t soleRig_GetSpine( const soleRig* rig );
SOLE_API soleVec3 soleRig_GetUp( const soleRig* rig );
SOLE_API soleVec3 soleRig_GetForward( const soleRig* rig );
/// Hip to ankle along the bones in the bind pose, character space: the L of the settings.
SOLE_API float soleRig_GetLegLength( const soleRig* rig, int32_t leg );
/// A sole point in the local space of the joint that carries it, as a skinned vertex would be. forePart: carried by the
/// first toe joint where there is one.
SOLE_API soleVec3 soleRig_ToFootSpace( const soleRig* rig, int32_t leg, soleVec3 bindPoint, bool forePart );
/// The joint that carries that part of the foot.
SOLE_API int32_t soleRig_GetFootJoint( const soleRig* rig, int32_t leg, bool forePart );

// ------------------------------------------------------------------------------------------------------- settings

SOLE_API soleSettings soleDefaultSettings( void );
/// The table of all settings, in the order of the struct.
SOLE_API const soleSettingInfo* soleGetSettingInfos( int32_t* count );
SOLE_API double soleSettings_Get( const soleSettings* settings, const soleSettingInfo* info );
/// Clamps into the setting's range; a number that is not finite changes nothing.
SOLE_API void soleSettings_Set( soleSettings* settings, const soleSettingInfo* info, double value );

// --------------------------------------------------------------------------------------------------------- states

SOLE_API soleState soleDefaultState( const soleRig* rig );
/// How many bytes from the start of a state are in use for this rig: what has to be saved.
SOLE_API size_t soleState_GetByteCount( const soleRig* rig );

// ---------------------------------------------------------------------------------------------------- every frame

/// What to ask of the ground for this frame. Reads the state, does not change it.
/// @param probes filled leg by leg.
/// @return how many were written, at most capacity. 0 where the input is unusable.
SOLE_API int32_t soleGatherProbes( const soleRig* rig, const soleSettings* settings, const soleState* state,
    const soleFrame* frame, soleProbe* probes, int32_t capacity );

/// Places the feet.
/// @param hits the answers to soleGatherProbes' questions, in the same order.
/// @param hitCount what soleGatherProbes returned for this or an earlier frame; fewer are allowed.
/// @param output always finite and usable.
SOLE_API void soleSolve( const soleRig* rig, const soleSettings* settings, soleState* state, const soleFrame* frame,
    const soleHit* hits, int32_t hitCount, soleOutput* output );

/// Writes the output into a pose: rotations of the leg joints and toes, translation of the pelvis, place of detached
/// feet, lean of the trunk. All else is left as it is.
/// @param localPose parent-local, jointCount of the rig: a copy of the frame's pose, or that pose itself.
SOLE_API void soleApply( const soleRig* rig, const soleOutput* output, soleTransform* localPose );

/// Blends the frame's second pose into a copy of its first, all joints, as far as the ground demands. Before
/// soleApply().
SOLE_API void soleBlendSecondPose(
    const soleRig* rig, const soleOutput* output, const soleTransform* secondPose, soleTransform* localPose );

/// Tells Sole that a state's character was moved by a jump that is no motion. The same as soleFrame.teleport.
SOLE_API void soleState_Reset( soleState* state );

// ---------------------------------------------------------------------------------------------------------- steps

/// What a list of steps says about one leg at a time of the clip: for soleFrame.contact and soleFrame.steps.
/// @param duration of the clip, s. The list goes on from its start after its end where it loops.
/// @param step its place and heading are as seen from where the root will be at the strike: bring them to where it is
/// now with soleStepInput_Travel()
SOLE_API void soleGetStepInput( const soleStep* steps, int32_t stepCount, float duration, bool loops, float time,
    int32_t leg, soleContactInput* contact, soleStepInput* step );

/// Place and heading of a step as seen from where the root is now.
/// @param travel what the root does between now and the strike, character space: from the clip, or from
/// soleExtrapolate()
SOLE_API void soleStepInput_Travel( soleStepInput* step, soleTransform travel );

/// What a root does that goes on as it goes now: on an arc about up, for a turn of at most a quarter of a circle;
/// what turns further is taken to turn by that.
/// @param velocity along the floor, units/s
/// @param turnRate about up, rad/s
SOLE_API soleTransform soleExtrapolate( soleVec3 velocity, float turnRate, soleVec3 up, float time );

// -------------------------------------------------------------------------------------------------------- kernels

/// Two bones and where their end should be, in any one space.
typedef struct soleTwoBoneDef
{
	soleVec3 hip;
	soleVec3 knee;
	soleVec3 ankle;
	soleVec3 target;
	/// The axis about which the knee bends, unit; decides the side where the leg is straight.
	soleVec3 hinge;
	/// Furthest and least extension as shares of the bones' length, and the zone of the soft approach, a length.
	float reach;
	float fold;
	float softZone;
} soleTwoBoneDef;

/// Rotations to put before the animated ones: hip turns the whole leg, knee the shin, both about their own joints, both
/// given in the same space as the definition. The shin gets hip * knee.
typedef struct soleTwoBoneResult
{
	soleQuat hip;
	soleQuat knee;
	/// Where the ankle ends up.
	soleVec3 ankle;
	/// soleLegFlags: softened, out of reach, folded, degenerate.
	uint32_t flags;
} soleTwoBoneResult;

/// Bends a leg about its own animated hinge so that its end comes to the target. No pole vector, no trigonometry.
SOLE_API soleTwoBoneResult soleSolveTwoBone( const soleTwoBoneDef* def );

/// One step of a critically damped spring, exact for any time step, towards a goal that moves at goalVelocity.
/// @param halfLife time in which half of a resting error disappears, s. 0 snaps.
SOLE_API soleOffset1 soleStepSpring(
    soleOffset1 spring, float goal, float goalVelocity, float halfLife, float timeStep );

#endif
