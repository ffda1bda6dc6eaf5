// SPDX-License-Identifier: MIT
// What goes into Sole and what comes out: rig definition, settings, frame, probe, hit, state, output.
//
// Spaces. Character space: the space of the pose's parentless joints. World: where the ground is. A frame's root takes
// character space to world. Parent-local: the space of a joint's parent. Names carry _w for world and _l for
// parent-local; geometry of definitions is in character space, in the bind pose.
// Lengths in settings are shares of the leg length L (hip to ankle along the bones in the bind pose), so that one set
// of settings serves every size; lengths in frames, probes, hits and output are the world's. Angles are radians.
#ifndef SOLE_TYPES_H
#define SOLE_TYPES_H

#include "sole/math.h"

#define SOLE_MAX_LEGS 16
/// Joints of a leg from hip to ankle, both included.
#define SOLE_MAX_LEG_JOINTS 7
#define SOLE_MAX_TOE_JOINTS 3
#define SOLE_MAX_PROBES_PER_LEG 32
#define SOLE_MAX_PROBES ( SOLE_MAX_LEGS * SOLE_MAX_PROBES_PER_LEG )

// ------------------------------------------------------------------------------------------------ rig definition

/// Which side of the body a leg is on, seen from the character. Tells which edge of the sole is the inner one.
typedef enum soleSide
{
	sole_center = 0,
	sole_left = 1,
	sole_right = 2,
	sole_sideForce32 = 0x7fffffff
} soleSide;

/// Five points under a foot that stand on the ground when it stands flat. Character space, bind pose.
typedef struct soleSolePoints
{
	soleVec3 heel;  // rearmost, middle of the width
	soleVec3 ball;  // under the toe joint, middle of the width: where the foot bends and pivots
	soleVec3 toe;   // foremost, middle of the width
	soleVec3 inner; // edge on the ball line towards the other leg
	soleVec3 outer; // the opposite edge
} soleSolePoints;

/// How far the foot may turn against the shin beyond the bind pose. Radians. A limit never forbids what the animation
/// itself does.
typedef struct soleAnkleLimits
{
	float dorsiflexion;   // toes up [0, 1.5] default 0.8 (46 degrees, weight bearing, knee bent)
	float plantarflexion; // toes down [0, 1.5] default 0.87 (50 degrees)
	float inversion;      // sole inwards [0, 1.5] default 0.61 (35 degrees)
	float eversion;       // sole outwards [0, 1.5] default 0.35 (20 degrees)
	float twist;          // about the shin, either way [0, 1.5] default 0.52 (30 degrees)
} soleAnkleLimits;

/// One leg. Start from soleDefaultLegDef().
typedef struct soleLegDef
{
	/// For messages. Copied (up to 31 bytes). May be NULL.
	const char* name;
	soleSide side;

	/// Indices into the pose: hip, (middle joints), knee, ankle. Each is a descendant of the one before.
	int32_t joints[SOLE_MAX_LEG_JOINTS];
	/// [2, SOLE_MAX_LEG_JOINTS]; 2 with a virtual ankle means hip and knee.
	int32_t jointCount;

	/// Set where the last bone has no joint at its end: the chain then ends at virtualAnkle, fixed to the last joint.
	bool hasVirtualAnkle;
	soleVec3 virtualAnkle; // character space, bind pose

	/// A foot that is not a descendant of the ankle, or SOLE_NONE. Such a foot is moved as well as turned.
	int32_t detachedFoot;

	/// Joints of the toe part, first the one at the ball. Descendants of the foot. Only the first is bent.
	int32_t toes[SOLE_MAX_TOE_JOINTS];
	int32_t toeCount; // [0, SOLE_MAX_TOE_JOINTS]

	/// The axis about which the knee bends, such that a positive turn (right-hand rule on the axes as they are given)
	/// carries the shin from straight to bent. Character space, bind pose, any length. Zero: taken from the bend of the
	/// bind pose, refused where that is straight.
	soleVec3 hinge;

	soleSolePoints sole;
	soleAnkleLimits ankleLimits;
} soleLegDef;

/// A skeleton and its legs. Start from soleDefaultRigDef(), fill in by hand or with soleDetectRig(). The arrays it
/// points to are read by soleCreateRig() and not kept.
typedef struct soleRigDef
{
	int32_t jointCount; // [1, 65535]
	/// Per joint its parent or SOLE_NONE. Any order; cycles are refused.
	const int32_t* parents;
	/// Parent-local transforms, the pose in which all geometry of this definition is given.
	const soleTransform* bindPose;
	/// For messages. May be NULL, as may each.
	const char* const* names;

	/// The joint that carries the body and all hips. It is moved by the pelvis offset.
	int32_t pelvis;

	soleVec3 up;      // out of the floor; character space, unit default (0, 1, 0)
	soleVec3 forward; // the way the character faces; character space, unit default (0, 0, 1)

	soleLegDef legs[SOLE_MAX_LEGS];
	int32_t legCount; // [1, SOLE_MAX_LEGS]

	/// Tells a filled definition from a forgotten one. Do not set.
	int32_t internalValue;
} soleRigDef;

/// Made by soleCreateRig(): immutable, shared by any number of characters and threads.
typedef struct soleRig soleRig;

// ------------------------------------------------------------------------------------------------------ settings

/// What is cast at the ground.
typedef enum soleProbeShape
{
	sole_probeRay = 0,
	sole_probeSphere = 1,
	sole_probeShapeForce32 = 0x7fffffff
} soleProbeShape;

/// How many probes a foot asks for.
typedef enum soleProbeLayout
{
	sole_probeEconomy = 0, // 5: heel, arch, ball inner, ball outer, toe tip
	sole_probeQuality = 1, // 18: nine rows of two
	sole_probeSingle = 2,  // 1: under the ball, for distant characters
	sole_probeLayoutForce32 = 0x7fffffff
} soleProbeLayout;

/// How heights are smoothed.
typedef enum soleFilter
{
	sole_filterTime = 0, // by time alone: the same at every frame rate
	sole_filterTick = 1, // the ground asked every 0.02 s, a share of the way with every call, as an ancestor does
	sole_filterForce32 = 0x7fffffff
} soleFilter;

/// What a held foot turns about when the animation turns it.
typedef enum soleLockPivot
{
	sole_pivotNone = 0,  // its heading is held
	sole_pivotBall = 1,  // the ball is held, the heel follows
	sole_pivotAnkle = 2, // the place under the ankle is held
	sole_pivotForce32 = 0x7fffffff
} soleLockPivot;

/// Which feet the pelvis goes with.
typedef enum solePelvisFollow
{
	sole_followSteps = 0,   // the line through all footholds, those to come included: even on stairs
	sole_followPlanted = 1, // the same through the feet that are planted
	sole_followLowest = 2,  // the foot with the lowest ground
	sole_followForce32 = 0x7fffffff
} solePelvisFollow;

/// Who moves the pelvis.
typedef enum solePelvisMode
{
	sole_pelvisJoint = 0,  // soleOutput.pelvisTranslation_l
	sole_pelvisRoot = 1,   // the host: it draws the whole character moved by soleOutput.pelvisOffset_w
	sole_pelvisReport = 2, // nobody: legs do what they can with the pelvis as animated, and the offset is only told
	sole_pelvisForce32 = 0x7fffffff
} solePelvisMode;

/// Every tunable. Plain data, may change every frame. Start from soleDefaultSettings(); a value out of its range is
/// clamped into it. Names, units, ranges, defaults and one sentence each: soleGetSettingInfos().
typedef struct soleSettings
{
	struct
	{
		soleProbeShape shape;   // [0, 1] default 0, ray
		soleProbeLayout layout; // [0, 2] default 0, economy
		float radius;           // of spheres. L [0.001, 0.3] default 0.05
		float stepUp;           // start of a probe above the reference height. L [0.05, 2] default 0.45
		float stepDown;         // end of a probe below the reference height. L [0.05, 4] default 0.55
		float looseSize;        // loose things smaller than this are no ground. L [0, 2] default 0.1
		float sleep;   // a foot that has stood still for so long asks one probe alone, until something changes. 0: none
		               // does. s [0, 60] default 0
		uint32_t mask; // layers that are asked for. default all
	} probe;

	struct
	{
		soleFilter filter; // how heights are smoothed: set where a state begins. [0, 1] default 0, by time
		float maxSlope;    // steeper faces give height but no tilt. rad [0, 1.5] default 0.87 (50 degrees)
		float levelGap;    // neighbouring probes further apart than 45 degrees plus this are on different levels. L
		                   // [0, 0.5] default 0.022
		float loadPoint;   // where the sole bears, from heel 0 to toe tip 1. [0, 1] default 0.5
		float lookAhead; // a foot in flight rises for what its toes will pass over within this time. s [0, 0.5] default
		                 // 0.08
		float heightHalfLife;   // decay of ground steps under a foot in flight. s [0, 1] default 0.045
		float gradientHalfLife; // decay of changes of slope under a foot in flight. s [0, 1] default 0.05
		float plantedHalfLife;  // decay of what is left of both once it is planted. s [0, 1] default 0.02
		float toeHalfLife;      // decay of changes of the ground before the toes. s [0, 1] default 0.04
	} support;

	struct
	{
		float speedOn;         // slower than this may plant. L/s [0, 20] default 0.25
		float speedOff;        // faster than this releases. L/s [0, 40] default 0.6
		float heightOn;        // a sole point lower than this over the clip's floor may plant. L [0, 1] default 0.025
		float heightOff;       // higher than this releases. L [0, 1] default 0.05
		float settle;          // a foot that looks planted for this long is. s [0, 1] default 0.033
		soleLockPivot pivot;   // what a held foot turns about. [0, 2] default 0, none
		float lockDistance;    // a lock is given up further than this from where it began, seen from the animation. 0:
		                       // no foot is locked. L [0, 2] default 0.25
		float lockAngle;       // or turned further than this. rad [0, 3] default 0.79 (45 degrees)
		float relock;          // share of both within which a lock that was given up may begin anew. [0, 1] default 0.4
		float replantDistance; // a foot at rest that is further off than this steps over. L [0, 2] default 0.1
		float replantAngle;    // or turned further than this. rad [0, 3] default 0.35 (20 degrees)
		float replantAfter;    // if it has been for so long. s [0, 60] default 0.8
		float replantTime;     // how long that step takes. s [0.02, 2] default 0.25
		float captureHalfLife; // decay of what is left of the motion when a foot is locked. s [0, 1] default 0.05
		float releaseHalfLife; // decay of the offset when it is let go. s [0, 1] default 0.08
		float fadeIn;          // time in which a planted leg gets its full say in the pelvis. s [0, 1] default 0.12
		float fadeOut;         // time in which a released leg loses it. s [0, 1] default 0.2
	} contact;

	struct
	{
		float shift;  // furthest that a step is shifted along the foot to stand better. L [0, 0.5] default 0.2
		float share;  // a sole that bears with this share of its length stands well. [0, 1] default 0.9
		float freeze; // the place of a step is settled this long before the foot comes down. s [0, 1] default 0.085
	} foothold;

	struct
	{
		float align;   // share of the ground's slope that a planted foot follows. [0, 1] default 1
		float maxTilt; // furthest that the ground tilts a foot. rad [0, 1.5] default 1.5
		float flatten; // a heel that is down, and that its clip leaves off the floor, is put down by turning the foot
		               // by at most this. rad [0, 0.5] default 0.1
		float height;  // soles are kept this far over the ground. L [-0.5, 0.5] default 0
		float flight;  // share of the placement that a foot in flight keeps. [0, 1] default 1
		float moving;  // share that is left while the root moves. [0, 1] default 1
		float
		    unreachable;  // share that is left to a foot whose ground is too low, too high or too steep. [0, 1] default
		                  // 1
		float toeOutLeft; // a left foot is turned outwards by this. rad [-1.5, 1.5] default 0
		float toeOutRight; // a right foot. rad [-1.5, 1.5] default 0
		float blendIn;     // time in which a weight rises from 0 to 1. s [0, 10] default 0.2
		float blendOut;    // time in which it falls. s [0, 10] default 0.15
		float secondFrom;  // the second pose begins at this difference of heights. L [0, 2] default 0.25
		float secondFull;  // and is full at this. L [0, 2] default 0.55
		float secondTime;  // half-life of its weight. s [0, 2] default 0.12
	} target;

	struct
	{
		float slow;     // up to this speed of the root the placement is whole. L/s [0, 40] default 2.5
		float fast;     // from this one on the character runs. L/s [0, 40] default 4.5
		float running;  // share of the placement that is left then. [0, 1] default 1
		float low;      // up to this height of all soles over their ground it is whole. L [0, 2] default 0.2
		float high;     // from this one on the character is in the air. L [0, 2] default 0.4
		float airborne; // share that is left then. [0, 1] default 1
	} activity;

	/// What the same difference of heights that blends in a second pose does without one. 0: nothing.
	struct
	{
		float knee; // a foot on its way up is lifted further by this share of its rise. [0, 1] default 0
		float hips; // the hips go away from the higher foot, by this on a slope of 45 degrees. L [0, 0.3] default 0
		float lean; // the trunk leans to the higher foot by this share of the slope. [0, 1] default 0
	} layer;

	struct
	{
		solePelvisFollow follow; // which feet it goes with. [0, 2] default 0, the steps
		solePelvisMode mode;     // who moves it. [0, 2] default 0, its joint
		float down;              // furthest down. L [0, 1] default 0.45
		float up;                // furthest up. L [0, 1] default 0.1
		float halfLife;          // s [0, 2] default 0.08
		float hold; // it stays down for so long after it had to, to be there for the next step; at most 0.3 where the
		            // step under way needs much less. s [0, 4] default 1.2
		float release;  // half-life of its way up from there. s [0, 4] default 0.2
		float speed;    // fastest that it moves up or down, beyond the animation. L/s [0, 100] default 0.9
		float balance;  // share of the feet's mean shift that the pelvis follows sideways. [0, 1] default 0
		float sideways; // furthest that it does. L [0, 1] default 0.1
		float
		    heelFirst; // share of the heel lift that is used up before the pelvis goes down for it. [0, 1] default 0.5
	} pelvis;

	struct
	{
		float reach;    // furthest extension of a leg as a share of its bones. [0.5, 1] default 0.995
		float softZone; // reach is approached softly over this much. L [0, 0.3] default 0.02
		float fold;     // least extension as a share of its bones. [0, 0.9] default 0.26
		float stretch;  // most that the bones are made longer to reach. share [0, 0.05] default 0
		float twist;    // share of a foot's turn about the leg that the thigh takes. [0, 1] default 0
		float heelLift; // most that a heel is raised to reach. rad [0, 1.4] default 0.87 (50 degrees)
	} leg;

	struct
	{
		float toeUp;   // furthest bend of the toes up. rad [0, 1.5] default 1.13 (65 degrees)
		float toeDown; // and down. rad [0, 1.5] default 0.26 (15 degrees)
	} ankle;

	/// Tells filled settings from forgotten ones. Do not set.
	int32_t internalValue;
} soleSettings;

/// How a setting is stored.
typedef enum soleSettingType
{
	sole_settingFloat = 0,
	sole_settingEnum = 1, // int32
	sole_settingMask = 2, // uint32
	sole_settingTypeForce32 = 0x7fffffff
} soleSettingType;

/// One row of the table of settings: the one place of their names, units, ranges and defaults.
typedef struct soleSettingInfo
{
	const char* name; // "stage.field", the same as in the struct and in JSON
	const char* unit; // "L", "s", "rad", "L/s", "" for shares
	soleSettingType type;
	uint32_t offset; // in bytes, in soleSettings
	double minimum;
	double maximum;
	double defaultValue;
	const char* text; // one sentence
} soleSettingInfo;

// --------------------------------------------------------------------------------------------------------- frame

/// What the host knows about a foot's contact this frame, from curves, events or labels.
typedef struct soleContactInput
{
	/// 0 free .. 1 planted; below zero: not known, Sole decides by speed and height.
	float heel;
	float toe;
} soleContactInput;

/// What the host knows of the steps of a leg, from the clip: soleGetStepInput() reads it from a list of steps.
typedef struct soleStepInput
{
	/// Time since the foot came down or left, s. Below zero: not known.
	float since;
	/// Time until the foot leaves or comes down, s. Below zero: not known, Sole then goes by what is under the foot.
	float until;
	/// In flight: where its ball will stand on the clip's floor, and how it will be headed, as seen from where the
	/// root is now. Character space.
	soleVec3 place;
	soleVec3 forward;
	/// In flight: how far the root will go until then. Character space.
	soleVec3 travel;
} soleStepInput;

/// One step of a leg in a clip, from when the foot comes down to when it has left: soleFindSteps() finds them. Times
/// are seconds since the clip's start. A step that the clip's end cuts through goes on beyond it in a clip that loops;
/// one that has no beginning or end in the clip begins at -SOLE_STEP_ENDLESS or ends at SOLE_STEP_ENDLESS.
typedef struct soleStep
{
	int32_t leg;
	float strike;           // the first part of the foot comes down
	float lift;             // the last part leaves
	float heelDown, heelUp; // of the heel alone; equal where it never touches
	float toeDown, toeUp;   // of the toes
	/// Where the flat foot's ball stands, as seen from where the root is at the strike, and its heading, unit.
	/// Character space.
	soleVec3 place;
	soleVec3 forward;
} soleStep;

#define SOLE_STEP_ENDLESS 1e9f

/// A body that feet may stand on and that moves by itself: a lift, a turntable, a vehicle.
typedef struct soleSupport
{
	/// As hits name it in soleHit.surface.
	int32_t surface;
	/// From the body's own frame, whichever the host likes, to this frame's world: rotation and place; the scale is
	/// not read.
	soleTransform transform;
} soleSupport;

/// One frame of one character. Only pose, root, up and timeStep have to be given; zero is a safe value for the rest
/// but weight (0 switches Sole off).
typedef struct soleFrame
{
	/// The animated pose: parent-local transforms, jointCount of the rig. Never the corrected pose of the last frame.
	const soleTransform* pose;
	/// Character space to world, rotation and uniform scale included.
	soleTransform root;
	/// Out of the ground, world, unit. A zero vector counts as the rig's up carried by the root.
	soleVec3 up;
	/// Seconds since the last frame. Zero changes nothing in the state; anything not finite or negative counts as zero.
	float timeStep;
	/// 0 leaves the pose as it is, 1 places the feet. [0, 1]
	float weight;
	/// Per leg, multiplied with weight. NULL: all 1. [0, 1] All weights may jump: Sole blends in and out by itself.
	const float* legWeight;
	/// Per leg, for the place and for the turn of the foot alone, multiplied with the others. NULL: all 1. [0, 1]
	const float* positionWeight;
	const float* rotationWeight;
	/// A second pose for ground that is much higher or lower under one foot than under another (a high step, a
	/// crouch), parent-local like the first. Sole blends it in as far as the ground demands: soleOutput.secondWeight.
	/// NULL: none.
	const soleTransform* secondPose;
	/// Per leg. NULL: nothing known.
	const soleContactInput* contact;
	/// Per leg. NULL: nothing known. Counts only beside contact.
	const soleStepInput* steps;
	/// Where the bodies are now that feet may stand on, each surface once. A foot that is planted on one of them is
	/// held in its frame. Bodies that are not listed but whose hits have a velocity carry a foot by that velocity.
	/// NULL: none.
	const soleSupport* supports;
	int32_t supportCount;
	/// Height of the clip's own floor over the character's origin, along the rig's up, character space.
	float clipFloor;
	/// Set when the character was moved by a jump that is no motion: all memory of the last frame is dropped.
	bool teleport;
	/// Where the origin of this frame's world coordinates is, in the host's own large world. A host without one leaves
	/// it at zero. May change from frame to frame, to the root itself even: what Sole remembers is moved along. Root,
	/// hits and supports are told from it: to be subtracted in double, before they become floats.
	double worldOrigin[3];
} soleFrame;

// ------------------------------------------------------------------------------------------------ probes and hits

/// A question about the ground: what is first met on the way from start along direction?
typedef struct soleProbe
{
	soleVec3 start_w;
	soleVec3 direction_w; // unit
	float length;         // furthest travel of the ray, or of the centre of the sphere. 0: need not be cast, misses
	float radius;         // 0: a ray
	uint32_t mask;        // layers that count
	int16_t leg;
	int16_t index; // which of the leg's probes
} soleProbe;

/// An answer. Zeroed memory is a valid miss.
typedef struct soleHit
{
	/// Something was met.
	bool hit;
	/// The start lay inside something (sphere casts: it touched at once). point and normal are then those of the
	/// nearest surface.
	bool startedInside;
	/// The layers of what was met.
	uint32_t layer;
	/// Whatever the host calls the body that was met; SOLE_NONE for the still world.
	int32_t surface;
	/// Where the surface was touched, world.
	soleVec3 point_w;
	/// Normal of the touched face, world, unit, against the probe's direction.
	soleVec3 normal_w;
	/// Velocity of the surface at the point, world.
	soleVec3 velocity_w;
	/// Largest extent of a loose thing that was met, world: feet do not climb those that are smaller than
	/// settings.probe.looseSize. 0: not loose, or not known.
	float size;
	/// start_w of the probe that this answers; lets answers be late by a frame or more.
	soleVec3 asked_w;
} soleHit;

// --------------------------------------------------------------------------------------------------------- state

/// A spring that decays to zero: offset and its velocity.
typedef struct soleOffset3
{
	soleVec3 value;
	soleVec3 velocity;
} soleOffset3;

typedef struct soleOffset1
{
	float value;
	float velocity;
} soleOffset1;

/// The body that a leg stands on, as it was in the last frame.
typedef struct soleBodyState
{
	int32_t surface;
	soleQuat rotation;
	soleVec3 place; // world; the velocity of one that is not listed
} soleBodyState;

/// What Sole remembers of one leg. World positions are in the last frame's world coordinates.
typedef struct soleLegState
{
	uint32_t flags; // soleLegStateFlags, internal
	// The body's surface comes next: all that follows are floats, and checked to be finite as such.
	soleBodyState body;
	float plantWeight;   // 0 free .. 1 has its full say in the pelvis
	soleVec3 animHeel_w; // last animated sole points, for velocities
	soleVec3 animBall_w;
	soleVec3 lockPoint_w;   // where the locked sole point is held
	soleVec3 lockForward_w; // the heading at which the foot was locked
	soleVec3 planePoint_w;  // the support plane of the last frame, or from which the foot has set out
	soleVec3 planeNormal_w;
	soleVec3 stepPlace_w; // where it is going to, or stands: ball
	soleVec3 stepNormal_w;
	soleVec3 stepLanding_w; // where the animation meant it to land when that was chosen
	soleVec3 heldShift;     // how far from the animation the foot was when it came to be held
	float strayTime;        // for how long it has been further off than that, s
	float missTime;         // for how long nothing was met under it while it stands, s
	float shortfall;        // how far the foot was from where it was wanted, of the leg's length
	float restep;           // what is left of a step by which it follows, s
	float restepTime;       // how long that takes, s
	soleVec3 learntPlace;   // where it came down the last time, as seen from the root, character space
	float learntFlight;     // how long it was in the air, s
	float learntSpeed;      // how fast the root was
	float toeSlope;         // of the ground in front of the ball over the plane, as last known
	soleOffset1 toe;        // what is left of its changes
	float chosenOver;       // how far its plane is over what is met under it
	float stepLift[3];      // by how much its way is lifted over what lies between, at 1/4, 1/2 and 3/4
	float stepOver[3];      // the same over narrow things alone, as far as they were met
	float heelLift;         // how far the heel is lifted for the leg to reach, sine of half the angle
	float stepTime;         // share of its flight's time that is over
	float stepLead;         // share of what is left of its way that a foot comes to be ahead of the animation by
	float stepWait;         // share of what it has come that it waits behind it by while it sets out
	soleVec3 lead;          // by how much it is
	soleOffset3 slide;      // horizontal offset of the foot from the animation
	soleOffset1 turn;       // heading offset, tan( angle / 4 )
	soleOffset1 height;     // what is left of ground steps
	soleOffset3 gradient;   // what is left of slope changes
	float heelRise;         // their heights over the clip's floor
	float ballRise;
	float rolled;         // how far the ball has gone with a foot that stands on its toe tip alone
	soleVec3 limitTurn;   // what the ankle's range of motion turns the foot by, in its own axes: sines of half angles
	soleOffset1 flat;     // by how much a heel that its clip leaves off the floor is turned down, rad
	float positionWeight; // as far as blended in
	float rotationWeight;
	float heelSpeed; // their speeds over the ground
	float ballSpeed;
	float time;        // since the last change of contact, s
	float contactTime; // for how long the foot has been in contact by its motion, s
} soleLegState;

/// All memory of one character: plain data, copy to save, assign to roll back. soleState_GetByteCount() tells how
/// many bytes from its start are in use for a rig.
typedef struct soleState
{
	uint32_t frameCount;    // frames since the last reset; 0: nothing is remembered
	soleVec3 root_w;        // last position of the root
	soleOffset1 pelvis;     // offset of the pelvis along up over the ground that the body is over
	soleOffset1 pelvisLead; // which that follows
	soleOffset3 balance;    // of the pelvis sideways
	soleOffset1 second;     // weight of the second pose
	float pelvisHeld;       // where that has to go, as low as it had to lately
	float bodyGround;       // height of that ground over the root
	soleVec3 bodyGradient;  // its slope, horizontal
	float pelvisHeldTime;   // for how long it had not to, s
	soleVec3 leanSlope;     // as far as the layer has taken it up, horizontal
	float strength;         // of the placement, by what the character is doing
	float standing;         // 1 all feet have been down for a while .. 0 not
	float unmetTime;        // for how long nothing was met, s
	double worldOrigin[3];
	int32_t internalValue;
	soleLegState legs[SOLE_MAX_LEGS];
} soleState;

// -------------------------------------------------------------------------------------------------------- output

/// Why a leg is as it is.
typedef enum soleLegFlags
{
	sole_legPlanted = 1 << 0,      // the foot is locked to the ground
	sole_legNoGround = 1 << 1,     // no probe of this foot met anything, or the character jumps or falls
	sole_legTooSteep = 1 << 2,     // the ground is steeper than maxSlope
	sole_legOnEdge = 1 << 3,       // part of the sole hangs over a lower level
	sole_legSoftened = 1 << 4,     // the soft reach limit was touched
	sole_legOutOfReach = 1 << 5,   // the target could not be reached: see error
	sole_legHeelLifted = 1 << 6,   // the heel was raised to reach
	sole_legAnkleClamped = 1 << 7, // the ankle's range of motion was met
	sole_legFolded = 1 << 8,       // the leg was as short as it may be
	sole_legReleased = 1 << 9,     // a lock was given up this frame
	sole_legCaptured = 1 << 10,    // a lock began this frame
	sole_legDegenerate = 1 << 11,  // bones of no length or a target at the hip: the leg is passed through untouched
	sole_legBadInput = 1 << 12,    // something not finite came in: the leg is passed through untouched
	sole_legInside = 1 << 13,      // a cast began inside something and was left out
	sole_legPlanned = 1 << 14,     // the foot is on its way to a foothold that was chosen
	sole_legTooLow = 1 << 15,      // the ground is lower than the leg can reach with the pelvis as low as it may go
	sole_legTooHigh = 1 << 16,     // the ground is higher than the leg can fold with the pelvis as high as it may go
	sole_legAsleep = 1 << 17,      // the foot asks one probe alone
	sole_legFlagsForce32 = 0x7fffffff
} soleLegFlags;

/// What the character is doing as a whole.
typedef enum soleActivity
{
	sole_standing = 0, // its root does not move
	sole_moving = 1,   // slowly
	sole_running = 2,  // or faster than settings.activity.fast
	sole_airborne = 3, // no sole is near its ground
	sole_activityForce32 = 0x7fffffff
} soleActivity;

/// The new pose of one leg and what is worth knowing about it.
typedef struct soleLegOutput
{
	uint32_t flags; // soleLegFlags
	/// New parent-local rotations of the leg's joints, hip first, ankle last.
	soleQuat rotations_l[SOLE_MAX_LEG_JOINTS];
	/// New parent-local rotation of the first toe joint. Identity where there is none.
	soleQuat toeRotation_l;
	/// New parent-local place of a detached foot.
	soleVec3 footTranslation_l;
	soleQuat footRotation_l;
	/// Where the ankle was wanted and where it is, world.
	soleVec3 ankleTarget_w;
	soleVec3 ankle_w;
	/// The plane that carries the sole: a point under the ankle and the unit normal, world.
	soleVec3 planePoint_w;
	soleVec3 planeNormal_w;
	/// By how much the bones were made longer: what the translations of all joints from below the hip to the ankle are
	/// multiplied with.
	float stretch;
	/// How far the ankle is from where it was wanted, when heel, pelvis, stretch and reach have given what they can.
	float error;
	/// Hip to ankle as a share of the bones' length.
	float extension;
	/// Height of the support under the ankle over the reference height: what a pose layer for high steps needs.
	float heightDemand;
	/// 0 free .. 1 planted, continuous.
	float plantWeight;
	/// How sure Sole is of the ground under this foot. [0, 1]
	float confidence;
} soleLegOutput;

/// The new pose. Finite and usable whatever went in.
typedef struct soleOutput
{
	/// Movement of the pelvis, world. Where settings.pelvis.mode leaves it to the host, what the host is to move.
	soleVec3 pelvisOffset_w;
	/// New parent-local translation of the pelvis joint.
	soleVec3 pelvisTranslation_l;
	/// For the host's capsule, so that it fits the lowered body: how much shorter half its height is, and how far its
	/// middle moves along up. World.
	float capsuleShorter;
	float capsuleOffset;
	/// How far the ground that the body is over lies over the root's floor, along up, world: by this a host without a
	/// character controller moves its root to keep it on the ground.
	float groundOffset;
	/// How much of the second pose is in this one. [0, 1]
	float secondWeight;
	/// Slope of the ground that the body is over, horizontal, rise per length: for a host that leans the trunk.
	soleVec3 bodyGradient_w;
	/// For how long no probe of any leg has met anything, s. What grows from the first frame on is no gap in the
	/// ground: a mask, a layer or a cast is wrong.
	float unmetTime;
	/// What the character is doing, and how much of the placement settings.activity leaves for that. [0, 1]
	soleActivity activity;
	float strength;
	/// The turn that leans the trunk, to be put before the animated rotation of soleRig_GetSpine(): parent-local.
	soleQuat lean_l;
	/// Legs that are filled in.
	int32_t legCount;
	soleLegOutput legs[SOLE_MAX_LEGS];
} soleOutput;

#endif
