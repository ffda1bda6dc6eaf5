// SPDX-License-Identifier: MIT
// Moves a character over ground, knowing no more than a game would: the path, and the ground it has come to so far.
#ifndef TOOL_WALKER_H
#define TOOL_WALKER_H

#include "motion.h"
#include "sole/ground.h"

/// Most frames of a walk.
#define TOOL_MAX_FRAMES 500000
/// How high and how deep a step the root takes at once, of leg length.
#define TOOL_STEP_HEIGHT 0.45f

/// A place in the world of the ground. y not a number: the highest surface there, else the nearest surface below y.
typedef struct toolPlace
{
	double x;
	double y;
	double z;
} toolPlace;

/// Start from toolDefaultWalkDef().
typedef struct toolWalkDef
{
	const toolCharacter* character;
	const toolBoundClip* bound;
	const toolTravel* travel;
	const soleGround* ground;
	const char* groundName; // for messages

	/// Where it goes; of all heights only the first counts. One place: straight on from there.
	const toolPlace* path;
	int32_t pathCount;
	double heading;  // about +Y, 0 along +Z, 90 along +X, degrees; of a path of one place
	double distance; // m, of a path of one place. 0: as far as the duration lasts
	double speed;    // m/s; the clip is played as much faster or slower. 0: the clip's own speed
	double duration; // s. 0: to the end of the path, or one round of a clip that stands
	double fps;
} toolWalkDef;

/// The walk, frame by frame.
typedef struct toolWalk
{
	int32_t frameCount;
	double fps;
	double speed;         // m/s along the path; 0: stands
	double rate;          // of the clip's play
	soleTransform* roots; // character space to world
	double* clipTimes;    // s since the clip's start, growing over its rounds
	bool* jumps;          // a clip that does not loop starts again here
	bool* seams;          // so does one that loops, and its last pose is not quite its first
} toolWalk;

toolWalkDef toolDefaultWalkDef( void );

/// Does a clip start again between two of its times, from another pose than it ends with?
bool toolCrossesSeam( const toolBoundClip* bound, const toolTravel* travel, double before, double after );

/// Does a clip stand, or do something on the spot? One that does not loop is no gait unless its feet clearly say so.
bool toolIsStanding( const toolTravel* travel );

/// The place on the ground that a place means; its y is always a number then.
bool toolFindGround( const soleGround* ground, const char* groundName, toolPlace* place, toolError* error );

/// In-place clips go along the path at their stride speed and face so that the stride follows it; those that stand stay
/// at its start. Root motion goes by its own root, from the start along the first heading, and on a path that bends as
/// far along it as its root has come forwards. The root's height steps up and down at once as far as a step may be
/// high, and falls where there is nothing below. The root at a time is the same at any frame rate.
bool toolMakeWalk( const toolWalkDef* def, toolWalk* walk, toolError* error );
void toolFreeWalk( toolWalk* walk );

#endif
