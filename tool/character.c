// SPDX-License-Identifier: MIT
// Makes a character of a model: skeleton in its bind pose, roles of joints, legs found, rig, sole points for measuring,
// and the node that carries it about. Character space is the file's scene space times the scale.
#include "character_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define JOINT_LIMIT 65535
#define SAMPLED_CLIPS 8
#define SAMPLES_A_CLIP 6
#define SAMPLED_TRANSFORMS 2000000

typedef struct toolRoleName
{
	const char* name;
	soleJointRole role;
} toolRoleName;

/// VRM's names, which are Unity's with a small first letter.
static const toolRoleName toolRoleNames[] = {
	{ "hips", sole_rolePelvis },
	{ "leftUpperLeg", sole_roleLeftHip },
	{ "leftLowerLeg", sole_roleLeftKnee },
	{ "leftFoot", sole_roleLeftAnkle },
	{ "leftToes", sole_roleLeftToe },
	{ "rightUpperLeg", sole_roleRightHip },
	{ "rightLowerLeg", sole_roleRightKnee },
	{ "rightFoot", sole_roleRightAnkle },
	{ "rightToes", sole_roleRightToe },
	{ "head", sole_roleHead },
};

static void toolFindRoles( toolCharacter* character )
{
	const toolModel* model = character->model;
	if ( model->boneCount == 0 )
	{
		return;
	}
	character->roles = toolAlloc( (size_t)character->jointCount, sizeof( soleJointRole ) );
	for ( int32_t i = 0; i < model->boneCount; ++i )
	{
		const toolBone* bone = model->bones + i;
		for ( size_t k = 0; k < sizeof toolRoleNames / sizeof toolRoleNames[0]; ++k )
		{
			if ( bone->node >= 0 && bone->node < character->jointCount &&
			    strcmp( bone->name, toolRoleNames[k].name ) == 0 )
			{
				character->roles[bone->node] = toolRoleNames[k].role;
			}
		}
	}
}

/// Poses here and there in the model's own clips. @return how many; the caller frees them.
static int32_t toolSamplePoses( const toolCharacter* character, soleTransform** poses )
{
	const toolModel* model = character->model;
	*poses = NULL;
	int32_t clips = model->clipCount < SAMPLED_CLIPS ? model->clipCount : SAMPLED_CLIPS;
	if ( clips == 0 || character->jointCount > SAMPLED_TRANSFORMS / ( SAMPLED_CLIPS * SAMPLES_A_CLIP ) )
	{
		return 0;
	}
	size_t joints = (size_t)character->jointCount;
	*poses = toolAlloc( (size_t)( clips * SAMPLES_A_CLIP ) * joints, sizeof( soleTransform ) );
	int32_t count = 0;
	for ( int32_t i = 0; i < clips; ++i )
	{
		const toolClip* clip = model->clips + (size_t)i * (size_t)model->clipCount / (size_t)clips;
		toolBoundClip bound = { .clip = clip, .duration = clip->end - clip->start };
		bound.nodes = toolAlloc( (size_t)clip->channelCount, sizeof( int32_t ) );
		for ( int32_t k = 0; k < clip->channelCount; ++k )
		{
			bound.nodes[k] = clip->channels[k].node;
		}
		for ( int32_t k = 0; k < SAMPLES_A_CLIP; ++k )
		{
			float time = bound.duration * ( (float)k + 0.5f ) / (float)SAMPLES_A_CLIP;
			toolSampleClip( character, &bound, time, *poses + (size_t)count * joints );
			count += 1;
		}
		free( bound.nodes );
	}
	return count;
}

static bool toolIsAbove( const toolCharacter* character, int32_t ancestor, int32_t joint )
{
	for ( int32_t i = joint; i != SOLE_NONE; i = character->parents[i] )
	{
		if ( i == ancestor )
		{
			return true;
		}
	}
	return false;
}

/// The topmost node above the pelvis that carries all legs and may be animated: moving it moves the whole skin.
static int32_t toolFindTravelNode( const toolCharacter* character )
{
	const soleRigDef* def = &character->rigDef;
	int32_t travel = SOLE_NONE;
	for ( int32_t i = def->pelvis; i != SOLE_NONE; i = character->parents[i] )
	{
		bool carries = character->model->nodes[i].hasMatrix == false;
		for ( int32_t leg = 0; leg < def->legCount; ++leg )
		{
			carries = carries && toolIsAbove( character, i, def->legs[leg].joints[0] ) &&
			    ( def->legs[leg].detachedFoot == SOLE_NONE ||
			        toolIsAbove( character, i, def->legs[leg].detachedFoot ) );
		}
		travel = carries ? i : travel;
	}
	return travel != SOLE_NONE ? travel : def->pelvis;
}

/// The sentence for a file in which no legs were found.
static bool toolFailDetection( const toolCharacter* character, const char* path, toolError* error )
{
	const soleDetectReport* report = &character->report;
	for ( int32_t i = 0; i < report->findingCount; ++i )
	{
		const soleFinding* finding = report->findings + i;
		if ( finding->severity == sole_error )
		{
			return toolFail( error, "%s: %s: %s: %s", path, finding->where, finding->what, finding->mend );
		}
	}
	return toolFail( error, "%s: no legs were found: name the joints as common rigs do", path );
}

static bool toolDetect( toolCharacter* character, const char* path, toolError* error )
{
	soleTransform* poses = NULL;
	soleSkeleton skeleton = { 0 };
	skeleton.poseCount = toolSamplePoses( character, &poses );
	skeleton.samplePoses = poses;
	skeleton.jointCount = character->jointCount;
	skeleton.parents = character->parents;
	skeleton.bindPose = character->bindPose;
	skeleton.names = character->names;
	skeleton.roles = character->roles;
	skeleton.skin = character->skin;
	skeleton.skinCount = character->skinCount;
	skeleton.up = soleVec( 0.0f, 1.0f, 0.0f ); // glTF says so
	character->rigDef = soleDefaultRigDef();
	soleResult result = soleDetectRig( &skeleton, &character->rigDef, &character->report );
	free( poses );
	if ( result != sole_success )
	{
		return toolFailDetection( character, path, error );
	}
	soleMessage message = { { 0 } };
	if ( soleCreateRig( &character->rigDef, NULL, &character->rig, &message ) != sole_success )
	{
		return toolFail( error, "%s: %s", path, message.text );
	}
	return true;
}

bool toolMakeCharacter(
    const toolModel* model, const char* path, float scale, toolCharacter* character, toolError* error )
{
	*character = ( toolCharacter ){ 0 };
	if ( model->nodeCount < 1 || model->nodeCount > JOINT_LIMIT )
	{
		return toolFail(
		    error, "%s: has %d nodes: give a character of 1 to %d", path, (int)model->nodeCount, JOINT_LIMIT );
	}
	if ( isfinite( scale ) == 0 || scale < 0.0f )
	{
		return toolFail( error, "%s: a scale of %g: give one above zero", path, (double)scale );
	}
	character->model = model;
	character->scale = scale > 0.0f ? scale : 1.0f;
	character->jointCount = model->nodeCount;
	character->travel = SOLE_NONE;
	character->parents = toolAlloc( (size_t)model->nodeCount, sizeof( int32_t ) );
	character->names = toolAlloc( (size_t)model->nodeCount, sizeof( char* ) );
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		character->parents[i] = model->nodes[i].parent;
		character->names[i] = model->nodes[i].name;
	}
	toolFindRoles( character );
	toolFindBindPose( character );
	toolCollectSkin( character );
	if ( toolDetect( character, path, error ) == false )
	{
		toolFreeCharacter( character );
		return false;
	}
	character->travel = toolFindTravelNode( character );
	toolCollectPoints( character );
	return true;
}

void toolFreeCharacter( toolCharacter* character )
{
	soleDestroyRig( character->rig );
	free( character->parents );
	free( character->bindPose );
	free( (void*)character->names );
	free( character->roles );
	free( character->skin );
	free( character->points );
	*character = ( toolCharacter ){ 0 };
}
