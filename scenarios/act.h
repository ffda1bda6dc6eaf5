// SPDX-License-Identifier: MIT
// What a host does to a character on a scene: where its root is, which clips it plays, what it has changed in the pose,
// how it steps through time and answers probes. Data and functions of time alone, so that any frame rate sees the same.
// World space, metres, seconds, +Y up but on ways around; the character stands upright, faces +Z at heading 0 and +X at
// 90 degrees.
#ifndef SCENARIOS_ACT_H
#define SCENARIOS_ACT_H

#include "scenario.h"

/// A clip. Which one that is, and how far a stride of it goes, is the player's business.
typedef enum soleGait
{
	sole_gaitIdle,
	sole_gaitWalk,
	sole_gaitRun,
	sole_gaitStrafe, // to the left; backwards in time it goes to the right
	sole_gaitCrouch,
	sole_gaitCrouchWalk,
	sole_gaitCount
} soleGait;

/// Where the root's height comes from.
typedef enum soleRootKind
{
	sole_rootStepped, // the floor below, now
	sole_rootRamped,  // straight between corners of its way, as over an invisible ramp
	sole_rootFixed,   // the floor at the beginning of its course, at time 0
	sole_rootAround   // place and up by the scene's way
} soleRootKind;

/// A scene, and how to ask it for the floor that carries a root.
typedef struct soleStage
{
	const soleScene* scene;
	/// The highest floor at a place that is not above the ceiling. @return false where there is none
	bool ( *findFloor )( void* user, double x, double z, double ceiling, double time, double* height );
	void* user;
} soleStage;

/// What the host does at one time.
typedef struct soleSceneMoment
{
	double x;
	double z;
	double heading; // rad
	double lift;    // of the root over its floor
	double scale;
	int32_t jumps; // how often it was moved by a jump so far that the host tells about
	soleGait gait;
	soleGait other; // blended in
	double blend;   // share of the other
	double way;     // how far it has gone, m: what clips that go are driven by
	double stride;  // of two steps, m. 0: the clip's own
	soleVec3 hips;  // the pose's pelvis is moved by this, feet stay; character space, as the next two
	soleVec3 feet[2];
	soleVec3 base;    // root and pose are moved against each other by this: the world pose stays
	double weight;    // soleFrame.weight
	double heel;      // of the shoe, m over that of the rig
	double legs;      // length of their bones as a share of the clip's
	double origin[3]; // of the world's coordinates
	bool resting;     // the host does nothing that should be seen in a foot
	/// Character space to world, with the scale, before base and origin, and what is up there: follows from the above.
	soleTransform root;
	soleVec3 up;
} soleSceneMoment;

typedef struct soleAct soleAct;

/// What is special about an act: changes the moment that a plain walk or stand would have.
typedef void soleActPlay(
    const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment );

/// Where it begins and where it goes.
typedef struct soleActCourse
{
	double x;
	double z;
	double heading; // the way it goes and faces, degrees
	double facing;  // turned from that, degrees
	double speed;   // m/s
} soleActCourse;

typedef struct soleActSpecial
{
	soleActPlay* play; // may be NULL
	double value;      // what acts of one kind differ in
	int32_t takeCount; // variants: headings, places. 0 counts as 1
} soleActSpecial;

#define SOLE_ACT_CORNERS 4

/// What the host does in its own way. Zeroed: nothing of all this.
typedef struct soleActHost
{
	int32_t late;                      // frames by which answers to probes are late
	double stride;                     // of two steps, m. 0: the clip's own
	double ceiling;                    // what is higher is no floor for the root. 0: nothing is
	double corners[SOLE_ACT_CORNERS];  // ramped roots: distances along the way, rising
	double rate;                       // of frames, Hz. 0: 60
	double rootRate;                   // the root is known this often only, Hz. 0: always
	bool rootHeld;                     // and held in between; else interpolated, one interval late
	double ( *step )( int32_t frame ); // length of a frame, for what is not steady. May be NULL
	double dropped;                    // share of answers that get lost
	double blindFrom;                  // no answers between these times, s
	double blindUntil;
	bool unlabelled; // it knows of no contacts and steps: clips are blended, or disturbed on purpose
} soleActHost;

struct soleAct
{
	const char* scene; // id
	const char* name;  // together with the scene's unique
	soleGait gait;
	soleRootKind root;
	soleActCourse course;
	double duration;
	soleActSpecial special;
	soleActHost host;
};

/// All acts, in the order of their scenes' ids.
const soleAct* soleGetActs( int32_t* count );
const soleAct* soleFindAct( const char* scene, const char* name );

/// Time since the frame before; 0 for frame 0.
double soleGetActStep( const soleAct* act, int32_t frame );

/// @param take [0, takeCount)
void soleGetSceneMoment(
    const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment );

#endif
