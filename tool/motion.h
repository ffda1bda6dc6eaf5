// SPDX-License-Identifier: MIT
// A character that can be moved and measured: skeleton, rig and sole vertices of a model, and clips sampled on it.
#ifndef TOOL_MOTION_H
#define TOOL_MOTION_H

#include "model.h"
#include "sole/detect.h"
#include "sole/measure.h"
#include "sole/sole.h"

/// A model with its legs found. Joint indices of the rig are node indices of the model.
typedef struct toolCharacter
{
	const toolModel* model;
	/// What positions of parentless nodes, and thereby all of the character, are multiplied with. 0 counts as 1.
	float scale;
	int32_t jointCount;
	int32_t* parents;
	soleTransform* bindPose; // from the inverse bind matrices where a skin moves the node, else the rest pose
	const char** names;
	soleJointRole* roles; // NULL where the file names no bones
	soleSkinVertex* skin; // NULL without a mesh
	int32_t skinCount;
	soleRigDef rigDef;
	soleRig* rig;
	soleDetectReport report;
	/// The node that carries the travel of a bake: the root motion node, else the topmost above the pelvis.
	int32_t travel;
	/// Sole points for measuring: the mesh's own foot vertices where there is a skin, else a grid.
	soleMeasurePoint* points;
	int32_t pointCount;
} toolCharacter;

/// Finds the legs. samplePoses for detection are taken from clips of the same model.
bool toolMakeCharacter(
    const toolModel* model, const char* path, float scale, toolCharacter* character, toolError* error );
void toolFreeCharacter( toolCharacter* character );

/// A clip of this or another file, bound to a character's nodes by name where it comes from another.
typedef struct toolBoundClip
{
	const toolClip* clip;
	int32_t* nodes; // per channel the character's node, or SOLE_NONE
	int32_t boundCount;
	float duration; // end - start, s
} toolBoundClip;

/// Names are taken as they are, else without regard to case, else without the prefix that most names of a file share
/// ("mixamorig:", "Avatar_"). Refused: a clip that moves no leg joint, and one of more than an hour.
bool toolBindClip(
    const toolCharacter* character, const toolModel* clipModel, int32_t clip, toolBoundClip* bound, toolError* error );
/// What a character without clips does: it stands in its rest pose for a second. Stands for a clip of the name
/// TOOL_REST_CLIP.
void toolBindRest( toolBoundClip* bound );
#define TOOL_REST_CLIP "rest"
void toolFreeBoundClip( toolBoundClip* bound );

/// The pose in which no clip moves anything: the file's rest pose at the character's scale.
void toolGetRestPose( const toolCharacter* character, soleTransform* pose );

/// The pose at a time after the clip's start: parent-local transforms, jointCount. Before and after the keys their ends
/// hold. Nodes that the clip does not move have their rest pose.
void toolSampleClip( const toolCharacter* character, const toolBoundClip* bound, float time, soleTransform* pose );

/// The value of a channel at a time of its file: 3 floats, or 4 of a unit quaternion. It has at least one key.
void toolSampleChannel( const toolChannel* channel, float fileTime, float value[4] );

/// A node in character space, without sampling the rest of the pose.
soleTransform toolSampleNode( const toolCharacter* character, const toolBoundClip* bound, float time, int32_t node );

/// A node in character space.
soleTransform toolPoseWorld( const toolCharacter* character, const soleTransform* pose, int32_t node );
/// Moves a node, and all that hangs from it, by a motion given in character space. The motion's scale is uniform.
void toolMovePose( const toolCharacter* character, soleTransform* pose, int32_t node, soleTransform motion );

/// How the root of a clip with root motion moves in the course of one round.
typedef enum toolTravelKind
{
	tool_travelNone,   // in place
	tool_travelOwn,    // as its root bone does, which stays on the floor and has no sway
	tool_travelSteady, // at the constant velocity that brings it to where the round ends; the sway stays in the pose
	tool_travelSmooth  // along the path of the pelvis, averaged over half a second: motion capture that does not loop
} toolTravelKind;

/// How a clip travels: what one loop of it does to the character's root, and the in-place stride speed.
typedef struct toolTravel
{
	bool rootMotion; // the character moves by itself
	bool loops;      // the last pose goes over into the first
	bool closed;     // exactly so
	bool turns;      // root motion turns as well as travels
	toolTravelKind kind;
	int32_t node;   // the one that carries the travel: all feet hang from it
	int32_t source; // root motion: the one whose motion it is; node or below it
	/// In place: what the stance feet pretend. Root motion: the mean velocity. Character space, m/s.
	soleVec3 strideVelocity;
	soleTransform loop; // root motion: what one loop adds, about the up axis and along the floor
	float clipFloor;    // height of the clip's own floor over the origin
	float frameRate;    // of the clip's keys
} toolTravel;

/// Hip to ankle along the bones in the bind pose, the longest leg; character space.
double toolLegLength( const toolCharacter* character );

toolTravel toolFindTravel( const toolCharacter* character, const toolBoundClip* bound );

/// The looped in-place pose and the root's own travel since time 0 (identity for in-place clips) at a time that may be
/// longer than the clip. The root's travel times the pose is the clip's own pose.
void toolSampleLooped( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    double time, soleTransform* pose, soleTransform* root );

/// A time of the looped clip: how many rounds are over, and the time in this one.
typedef struct toolRoundTime
{
	double rounds;
	double rest;
} toolRoundTime;

toolRoundTime toolFindRound( const toolBoundClip* bound, const toolTravel* travel, double time );

/// The root's travel alone.
soleTransform toolSampleRoot(
    const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, double time );

#endif
