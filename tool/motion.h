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

bool toolBindClip(
    const toolCharacter* character, const toolModel* clipModel, int32_t clip, toolBoundClip* bound, toolError* error );
void toolFreeBoundClip( toolBoundClip* bound );

/// The pose at a time after the clip's start: parent-local transforms, jointCount. Before and after the keys their ends
/// hold.
void toolSampleClip( const toolCharacter* character, const toolBoundClip* bound, float time, soleTransform* pose );

/// How a clip travels: what one loop of it does to the character's root, and the in-place stride speed.
typedef struct toolTravel
{
	bool rootMotion;         // the travel node moves by itself
	int32_t node;            // which one
	soleVec3 strideVelocity; // in place: what the stance feet pretend, character space, m/s
	soleTransform loop;      // root motion: what one loop adds, about the up axis and along the floor
	float clipFloor;         // height of the clip's own floor over the origin
	float frameRate;         // of the clip's keys
} toolTravel;

toolTravel toolFindTravel( const toolCharacter* character, const toolBoundClip* bound );

/// The looped in-place pose and the root's own travel since time 0 (identity for in-place clips) at a time that may be
/// longer than the clip.
void toolSampleLooped( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    double time, soleTransform* pose, soleTransform* root );

#endif
