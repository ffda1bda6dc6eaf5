// SPDX-License-Identifier: MIT
// What the stages of a frame hand on to one another. Only place.c calls the stages, in the order in which they stand
// here; none of them calls another.
//
// Space of all positions here: world axes, origin at the frame's root ("near space"), so that nothing is lost far from
// the world's origin. Heights are along the frame's up.
#ifndef SOLE_PLACE_PLACE_H
#define SOLE_PLACE_PLACE_H

#include "base/math_internal.h"
#include "base/spring.h"
#include "rig/rig.h"

/// soleLegState.flags
enum
{
	sole_stateLocked = 1 << 0, // the foot is held at lockPoint_w
	sole_stateByHeel = 1 << 1, // lockPoint_w is the heel's place, else the ball's
	sole_stateHeelOn = 1 << 2, // contact of heel and toe, with hysteresis
	sole_stateToeOn = 1 << 3,
	sole_stateBarred = 1 << 4,   // a lock was given up: no new one before the foot has been free
	sole_statePlanned = 1 << 5,  // in flight to stepPlace_w
	sole_stateChosen = 1 << 7,   // it stands on the plane of stepPlace_w
	sole_stateCompared = 1 << 8, // how far that is over what is met is known
	sole_stateLeft = 1 << 11,    // it was seen to leave the ground
	sole_stateRides = 1 << 10,   // its body is one that the host lists
	sole_stateForeseen = 1 << 9, // it has come down where it was planned to, a frame ago
	sole_stateGround = 1 << 6,   // there was ground
	sole_stateTooLow = 1 << 12,  // which was out of reach
	sole_stateTooHigh = 1 << 13,
	sole_stateTooSteep = 1 << 14,
	sole_stateAsleep = 1 << 15,  // one probe was asked for
	sole_stateRunning = 1 << 16, // what the character does, the same in all legs
	sole_stateAirborne = 1 << 17,
	sole_stateAloft = 1 << 18, // it jumps or falls
};

/// What the ground is like at one place that was asked for.
typedef struct soleGroundSample
{
	soleVec3 place;    // as asked; its height means nothing
	bool found;        // else nothing is there
	bool steep;        // the face cannot be walked on
	float height;      // along up
	soleVec3 gradient; // of the face, horizontal
	int32_t surface;
	soleVec3 velocity; // of the surface, world
} soleGroundSample;

/// A plane with its normal's height taken apart: height over a place x is height + dot( gradient, x - point ), with the
/// gradient horizontal.
typedef struct solePlane
{
	soleVec3 point;
	soleVec3 normal;   // unit
	soleVec3 gradient; // rise per length, horizontal
} solePlane;

/// What a leg stands on: where it stood last and where it will stand next, on the ground, and how much of the change
/// is over. A foot that is down, or of which no more is known, stands on one place.
typedef struct soleStand
{
	soleVec3 from;
	soleVec3 to;
	float time;  // share of it that is over
	float share; // 0 from .. 1 to
} soleStand;

/// A sole seen from above. A tilted one is shorter and narrower.
typedef struct soleFootprint
{
	soleVec3 ball;    // middle of the ball line
	soleVec3 forward; // horizontal, unit
	soleVec3 side;    // to the outer side of a right foot, horizontal, unit
	float along;      // world's lengths of one of the rig's, along the foot
	float across;     // and across it
} soleFootprint;

/// One leg during a frame.
typedef struct soleLegWork
{
	const soleRigLeg* rig;
	soleLegState* state;
	soleLegOutput* out;
	int32_t index;
	float weight;       // of its place: as far as the host's weights are blended in
	float turnWeight;   // of its turn
	float weightBefore; // the first, a frame ago
	float length;       // of the bones now, world
	bool usable;        // finite and of some length
	soleContactInput contactInput;
	soleStepInput stepInput;

	// sense: the animated leg
	soleVec3 joints[SOLE_MAX_LEG_JOINTS + 1]; // hip first, (virtual) ankle last
	soleQuat rotations[SOLE_MAX_LEG_JOINTS];
	int32_t ankleIndex; // of the last entry of joints
	soleTransform foot; // the joint that carries the sole
	soleQuat toeRotation;
	soleVec3 ankle, heel, ball;          // sole points, the ball carried by the toes
	soleVec3 pivot;                      // what the heel is raised about: the toe joint, else the ball
	soleVec3 forward;                    // horizontal heading of the foot, unit
	float heelRise, ballRise, tipRise;   // over the clip's floor
	float sunk;                          // how far the clip itself has the sole under its floor
	float toeSunk;                       // and its toes alone, as a slope from the ball
	float heelSpeed, ballSpeed;          // over the ground, with the root's motion
	soleVec3 ballVelocity, heelVelocity; // horizontal

	// probe: what the probes are aimed at
	soleVec3 soleCenter;  // ball of the flat sole, horizontal place
	soleVec3 soleForward; // its heading
	soleFootprint print;  // of the sole as it is tilted
	bool flying;          // fast enough to run into something
	soleVec3 tip;         // of the toes of a foot in flight
	bool foreseen;        // in flight, and where and when it will come down is known
	bool choosing;        // the foothold is to be chosen, or once more
	bool looking;         // for narrow things on its way, and nothing else
	bool reading;         // it is settled, and its ground is to be read closely
	bool asleep;          // it has stood still for long: one probe will do
	soleVec3 landing;     // ball of the flat sole then, as the animation has it
	soleVec3 landingForward;
	soleVec3 travel; // of the root until then

	// support
	soleGroundSample* samples;
	int32_t sampleCount;
	bool hasGround;
	bool hadGround; // a frame ago
	bool missed;    // no answer, and taken to be where it was
	solePlane raw;  // the plane that carries the sole, as the ground is now
	float toeSlope; // rise per length of the ground in front of the ball, over the plane
	float share;    // of the places under the sole that bear
	int32_t surface;
	soleVec3 surfaceVelocity; // world

	// contact
	bool touches;     // is in contact, held or not
	bool touched;     // was so a frame ago
	bool told;        // by the host
	float flight;     // how long it was in the air before it came down, s
	float letGoSpeed; // at which a foot is let go
	float since;      // the change of contact happened so long before the end of this frame, s

	// foothold
	bool planned;       // in flight to stepPlace
	soleVec3 stepPlace; // of the ball
	soleVec3 stepNormal;
	solePlane plane; // raw with what is left of earlier ground
	soleStand stand;
	soleStand standBefore; // as the last frame knew it, for the time of this one

	// lock
	bool waits;           // to step over, for another foot
	bool planted;         // is held
	soleVec3 anchor;      // animated point that is held or led: ball or heel, dropped on the clip's floor
	soleVec3 anchorGoal;  // where it goes, horizontal place
	soleQuat turn;        // heading offset about up
	float rolled;         // how far ahead its ball has gone with the toes' roll
	soleVec3 anchorShift; // puts the ankle of a tilted foot over its animated place, horizontal

	// target
	soleQuat image;       // rotation from the clip's floor to the plane
	soleVec3 ankleWanted; // at full weight
	soleVec3 ankleTarget;
	soleQuat footTarget;
	soleVec3 pivotTarget; // about which the heel is raised
	float liftLeft;       // of the heel lift of a foot in flight, sine of half the angle

	// leg
	soleVec3 hip; // with the pelvis moved
	soleQuat hipTurn, kneeTurn;
	soleVec3 ankleReached;
	bool limited;         // the ankle met its range of motion, and has new targets
	soleVec3 ankleGoal;   // ankleTarget and
	soleQuat footReached; // footTarget with the heel raised
} soleLegWork;

/// What the legs allow the pelvis, over the body's ground.
typedef struct soleBounds
{
	float ceiling; // no leg is longer than is good, no heel raised that was not
	float landing; // no leg that comes down will be, as far as it is on its way
	float most;    // no leg is longer than it can be with its heel raised as far as its animation has begun to
	float floor;
	float step; // where the steps under way need it, when they are over. 0: no lower than it is animated
	bool any, stepping;
} soleBounds;

/// What angles among the settings come to.
typedef struct soleAngles
{
	float steepestTilt; // rise per length that a sole is tilted by at most
	soleHalf walkable;  // of the steepest slope that can be walked on
	soleHalf toesUp;
	soleHalf toesDown;
	float toesLeast, toesMost; // slopes that toes can follow
	float lockTurn;            // tan of a quarter of the angle at which a lock is given up
} soleAngles;

/// One character during a frame.
typedef struct solePlaceWork
{
	// Given by who begins the frame: room for as many as the rig has.
	soleTransform* slots;
	soleLegWork* legs;
	soleGroundSample ( *samples )[SOLE_MAX_PROBES_PER_LEG];

	const soleRig* rig;
	const soleSettings* settings;
	const soleFrame* frame;
	soleState* state;
	soleOutput* out;

	soleVec3 up;     // world
	soleVec3 level;  // any direction across it
	soleVec3 rootUp; // the rig's up carried by the root
	soleVec3 floor;  // a point of the clip's floor
	float reference; // its height
	soleVec3 root_w; // near space + root_w = world
	float rootScale;
	float timeStep;
	bool first;            // nothing is remembered
	bool ticks;            // the ground is asked in this frame (tick.c)
	soleVec3 rootVelocity; // horizontal
	float rootSpeed;
	soleBounds bounds;     // of the pelvis
	soleVec3 pelvisWanted; // by how much it should move
	float pelvisShift;     // how far it does along up
	float second;          // weight of the second pose in this frame
	float weight;          // of the whole: the largest of the legs'
	soleVec3 balance;      // and sideways, horizontal
	soleVec3 hipShift;     // of that, what steep steps want
	soleAngles angles;
	float carriedUp;  // how far along up the bodies that legs stand on have moved since the last frame
	float bodyGround; // height of the ground that the body is over
	float bodyBefore; // the same by what the last frame knew
	int32_t legCount;
} solePlaceWork;

/// Room for one of any rig. What is read has been written before: it is not cleared.
typedef struct solePlaceRoom
{
	soleTransform slots[SOLE_MAX_SLOTS];
	soleLegWork legs[SOLE_MAX_LEGS];
	soleGroundSample samples[SOLE_MAX_LEGS][SOLE_MAX_PROBES_PER_LEG];
} solePlaceRoom;

static inline solePlaceWork soleWorkIn( solePlaceRoom* room )
{
	return ( solePlaceWork ){ .slots = room->slots, .legs = room->legs, .samples = room->samples };
}

static inline soleVec3 soleHorizontal( const solePlaceWork* work, soleVec3 v )
{
	return soleReject( v, work->up );
}

/// Height of a plane over a horizontal place.
static inline float solePlaneHeight( const solePlaceWork* work, solePlane plane, soleVec3 place )
{
	return soleDot( plane.point, work->up ) +
	    soleDot( plane.gradient, soleHorizontal( work, soleSub( place, plane.point ) ) );
}

/// The same place, moved along up to a height.
static inline soleVec3 soleAtHeight( const solePlaceWork* work, soleVec3 place, float height )
{
	return soleMulAdd( soleHorizontal( work, place ), height, work->up );
}

static inline solePlane soleMakePlane( const solePlaceWork* work, soleVec3 point, soleVec3 gradient )
{
	return ( solePlane ){ point, soleNormalizeOr( soleSub( work->up, gradient ), work->up ), gradient };
}

/// The frame's root in near space: rotation of unit length.
static inline soleTransform soleGetNearRoot( const solePlaceWork* work )
{
	return ( soleTransform ){ { 0.0f, 0.0f, 0.0f }, soleNormalizeQuat( work->frame->root.rotation ),
		work->frame->root.scale };
}

/// The turn about up that points the toes outwards, away from the other side of the body.
soleQuat soleGetToeOut( const solePlaceWork* work, const soleLegWork* leg );
/// Its ground is filtered by tick.c, in place of several stages.
static inline bool soleGoesByTicks( const solePlaceWork* work )
{
	return work->settings->support.filter == sole_filterTick;
}

/// Its feet are held where they stand, if they can be.
static inline bool soleHoldsFeet( const solePlaceWork* work )
{
	return work->settings->contact.lockDistance > 0.0f && soleGoesByTicks( work ) == false;
}

/// Share of a slope that a sole follows.
float soleFindAlign( const solePlaceWork* work, soleVec3 gradient );
/// The part of a foot's place that ground of some normal adds: the ankle stands over its animated place, so the sole
/// moves uphill by what the ankle would else move downhill. Horizontal.
soleVec3 soleTiltShift( const solePlaceWork* work, const soleLegWork* leg, soleVec3 normal );
/// A sole on such ground.
soleFootprint soleMakeFootprint( const solePlaceWork* work, soleVec3 ball, soleVec3 forward, soleVec3 normal );

/// The foothold that was chosen, without that part.
static inline soleVec3 soleLevelPlace( const solePlaceWork* work, const soleLegWork* leg )
{
	soleVec3 place = soleSub( leg->state->stepPlace_w, work->root_w );
	return soleSub( place, soleTiltShift( work, leg, leg->state->stepNormal_w ) );
}

/// The footprint there.
static inline soleFootprint soleChosenFootprint( const solePlaceWork* work, const soleLegWork* leg )
{
	return soleMakeFootprint( work, soleLevelPlace( work, leg ), leg->landingForward, leg->state->stepNormal_w );
}

static inline int32_t soleMinI( int32_t a, int32_t b )
{
	return a < b ? a : b;
}

/// How many probes a leg asks for: depends on settings alone.
int32_t soleProbesPerLeg( const soleSettings* settings );

/// A share of time, set out and arriving at rest: 10 t^3 - 15 t^4 + 6 t^5.
static inline float soleSmoothly( float t )
{
	return t * t * t * ( 10.0f - t * ( 15.0f - 6.0f * t ) );
}

/// The same, less slow at its ends: 3 t^2 - 2 t^3.
static inline float soleGently( float t )
{
	return t * t * ( 3.0f - 2.0f * t );
}

static inline float soleLongestLeg( const solePlaceWork* work )
{
	float longest = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		longest = soleMaxF( longest, work->legs[i].usable ? work->legs[i].length : 0.0f );
	}
	return longest;
}

/// As the rig has it, of the root's scale: known before the legs are.
static inline float soleLongestRigLeg( const solePlaceWork* work )
{
	float longest = 0.0f;
	for ( int32_t i = 0; i < work->rig->legCount; ++i )
	{
		longest = soleMaxF( longest, work->rig->legs[i].length );
	}
	return longest * work->rootScale;
}

/// Any part of the layer for high steps is on.
static inline bool soleHasLayer( const soleSettings* settings )
{
	return settings->layer.knee > 0.0f || settings->layer.hips > 0.0f || settings->layer.lean > 0.0f;
}

/// Its root goes on: not exactly zero, which no measured speed is.
static inline bool soleIsMoving( const solePlaceWork* work )
{
	return work->rootSpeed > 0.01f * soleLongestRigLeg( work ); // per second
}

/// Sine of the flexion below which the rig's hinge is leaned on.
#define SOLE_NEARLY_STRAIGHT 0.05f

/// How long a leg may be: nothing is softened up to soft, nothing is longer than hard. An animation that stretches
/// further keeps its own length.
typedef struct soleReach
{
	float soft;
	float hard;
} soleReach;

/// How long the animation has the leg.
static inline float soleAnimatedReach( const soleLegWork* leg )
{
	return soleMinF( soleDistance( leg->joints[0], leg->ankle ), leg->length );
}

static inline soleReach soleGetReach( const solePlaceWork* work, const soleLegWork* leg )
{
	float animated = soleAnimatedReach( leg );
	float hard = soleMaxF( work->settings->leg.reach * leg->length, animated );
	float soft = soleMaxF( hard - work->settings->leg.softZone * leg->length, animated );
	return ( soleReach ){ soft, hard };
}

/// A joint of the animated pose, the second pose blended in.
static inline soleTransform soleReadPose( const soleFrame* frame, float second, int32_t joint )
{
	soleTransform a = frame->pose[joint];
	if ( frame->secondPose == NULL || !( second > 0.0f ) )
	{
		return a;
	}
	soleTransform b = frame->secondPose[joint];
	return ( soleTransform ){ soleLerp( a.translation, b.translation, second ),
		soleNlerp( soleNormalizeQuat( a.rotation ), soleNormalizeQuat( b.rotation ), second ),
		soleLerp( a.scale, b.scale, second ) };
}

/// The answers of a frame, leg by leg: those of leg i begin at starts[i] and end at starts[i + 1].
typedef struct soleLegHits
{
	const soleHit* hits;
	int32_t starts[SOLE_MAX_LEGS + 1];
} soleLegHits;

/// What gathering and solving have in common: everything up to where the soles are. The state is taken in, and may be
/// changed; the output is left to soleEndFrame(). Settings in their ranges, a frame that is usable.
/// @param work with its room
void soleBeginFrame( solePlaceWork* work, const soleRig* rig, const soleSettings* settings, soleState* state,
    const soleFrame* frame, soleOutput* out );
/// The same of several of one rig, to the bit: each opened before, then all of them sensed.
void soleOpenFrame( solePlaceWork* work, const soleRig* rig, const soleSettings* settings, soleState* state,
    const soleFrame* frame, soleOutput* out );
void soleBeginFrames( solePlaceWork* const* works, int32_t count, int32_t width );
/// The rest of a frame that was begun, all that its stages found left in the work.
void soleEndFrame( solePlaceWork* work, const soleLegHits* hits );
/// The same of several, to the bit.
/// @param width of the kernel that their legs go through
void soleEndFrames( solePlaceWork* const* works, const soleLegHits* hits, int32_t count, int32_t width );
/// The answers to soleGatherProbes(), by leg.
soleLegHits soleSplitHits( const soleRig* rig, const soleSettings* settings, const soleHit* hits, int32_t hitCount );
/// Nothing that is not finite leaves, whatever came in.
void soleScrubOutput( const soleRig* rig, soleOutput* output );
/// The output of a frame that is not usable.
void soleRefuseFrame( const soleRig* rig, const soleFrame* frame, soleOutput* output );

/// Settings in their ranges; the defaults where they were not made by soleDefaultSettings().
/// @param scratch what is returned, where they had to be changed
const soleSettings* soleCleanSettings( const soleRig* rig, const soleSettings* settings, soleSettings* scratch );
soleAngles soleTakeAngles( const soleSettings* settings );
bool soleIsFrameUsable( const soleFrame* frame );
/// A state that is usable in this frame's world: the default one where it was not.
void soleTakeState( const soleRig* rig, const soleFrame* frame, soleState* state );
/// Fills in what all stages share. Forgets everything after a jump.
void soleSetUpFrame( solePlaceWork* work );

/// How much of the placement a leg gets: as far as all weights are blended in.
void soleBlendWeights( solePlaceWork* work, soleLegWork* leg );

/// Moves what legs remember with the bodies that they stand on; keeps those bodies for the next frame.
void soleCarryLegs( solePlaceWork* work );
void soleRememberBodies( solePlaceWork* work );

/// In place of the stages from the learning of steps to the pelvis, where settings ask for the filter by ticks: the
/// clock and where the ground is asked, the answers, body and legs, and what is shown of them in the end.
void soleCountTick( solePlaceWork* work );
void soleKeepTick( solePlaceWork* work );
void soleFollowTick( solePlaceWork* work );
void soleRememberShown( solePlaceWork* work );

/// The stages. Each reads what those before it wrote.

/// Where are hips, knees, ankles, soles; how high over the clip's own floor; how fast.
void soleSense( solePlaceWork* work );
/// When and where feet in flight will come down.
void soleForesee( solePlaceWork* work );
/// What a leg asks, as far as there is room. @return how many probes that takes, at most soleProbesPerLeg()
int32_t soleAskGround( const solePlaceWork* work, const soleLegWork* leg, soleProbe* probes, int32_t capacity );
/// A probe of a leg that is not asked: of no length, at no place.
soleProbe soleMakeProbe( const solePlaceWork* work, const soleLegWork* leg );
/// Where the flat sole of a leg is, or will be: for asking and for reading the answers.
void soleAimSole( solePlaceWork* work, soleLegWork* leg );
/// Hits to the plane that carries the sole.
void soleFindSupport( solePlaceWork* work, const soleLegHits* hits );
/// Which part of the foot is on the ground, and since when.
void soleUpdateContact( solePlaceWork* work );
/// What the character is doing, and how strongly its feet are placed for that.
void soleFindActivity( solePlaceWork* work );
/// How long a step took and where it went, for the next.
void soleLearnSteps( solePlaceWork* work );
/// Feet that stand but have been left behind step over.
void soleTakeResteps( solePlaceWork* work );
/// A body that jumps or falls has no ground.
void soleTakeOff( solePlaceWork* work );
/// How many probes look for narrow things on the way of a foot.
int32_t soleGetLookCount( const soleSettings* settings );
/// Where the next step lands, and the plane that the foot follows on its way.
void soleChooseFootholds( solePlaceWork* work );
/// Held where.
void soleUpdateLocks( solePlaceWork* work );
/// Ankle and foot goals.
void soleSetTargets( solePlaceWork* work );
/// Whose ground is out of reach.
void soleClassReach( solePlaceWork* work );
/// How much of a second pose the ground demands.
void soleDemandSecondPose( solePlaceWork* work );
/// The ground that the body is over.
void soleFindBodyGround( solePlaceWork* work );
/// The same some time later, when the pelvis has gone on and who is to be down by then is down.
float soleForeseeBodyGround( const solePlaceWork* work, soleVec3 travel, float time );
/// What the same demand does without one: lean, hips, knees.
void soleAddLayer( solePlaceWork* work );
/// One height that all legs can live with.
void soleMovePelvis( solePlaceWork* work );

/// The last stages go leg by leg.

/// Heel lift, reach, two-bone.
void soleSolveLeg( const solePlaceWork* work, soleLegWork* leg );
/// Range of motion: turns what the solved leg's ankle cannot do into new targets for a second solve.
void soleLimitAnkle( const solePlaceWork* work, soleLegWork* leg );
/// Alignment and toes; writes the output.
void soleAlignAnkle( const solePlaceWork* work, soleLegWork* leg );
/// All of them, and those after the first.
void soleFinishLeg( const solePlaceWork* work, soleLegWork* leg );
void soleFinishAnkle( const solePlaceWork* work, soleLegWork* leg );

#endif
