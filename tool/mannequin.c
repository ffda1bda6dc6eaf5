// SPDX-License-Identifier: MIT
// The mannequin's skeleton, and the model put together from skeleton, mesh and clips. Root space: metres, y up,
// forward +z, left +x.
//
// Segment lengths follow the shares of body height in D. A. Winter, "Biomechanics and Motor Control of Human Movement",
// 4th ed. 2009, chapter 4 (after Drillis and Contini), rounded. The knee lies a little ahead of the line from hip to
// ankle, so that the rest pose tells which way it bends.
#include "mannequin.h"

#include "mannequin_parts.h"

#include <string.h>

typedef struct toolJointDef
{
	const char* name;
	int32_t parent;
	soleVec3 rest;
} toolJointDef;

// The arms are laid out by TOOL_ARM_DROP: see toolRestJoint.
static const toolJointDef s_joints[tool_jointShoulder + tool_jointsOfSide] = {
	{ "root", SOLE_NONE, { 0.0f, 0.0f, 0.0f } },
	{ "hips", tool_jointRoot, { 0.0f, 0.985f, -0.005f } },
	{ "spine", tool_jointHips, { 0.0f, 1.075f, -0.012f } },
	{ "chest", tool_jointSpine, { 0.0f, 1.215f, -0.014f } },
	{ "neck", tool_jointChest, { 0.0f, 1.480f, -0.020f } },
	{ "head", tool_jointNeck, { 0.0f, 1.570f, -0.006f } },
	{ "shoulder", tool_jointChest, { 0.030f, 1.425f, -0.012f } },
	{ "upperarm", tool_jointShoulder, { 0.185f, 1.415f, -0.016f } },
	{ "forearm", tool_jointUpperarm, { 0.0f, 0.0f, 0.0f } },
	{ "hand", tool_jointForearm, { 0.0f, 0.0f, 0.0f } },
	{ "thigh", tool_jointHips, { 0.090f, 0.933f, 0.000f } },
	{ "shin", tool_jointThigh, { 0.090f, 0.504f, 0.014f } },
	{ "foot", tool_jointShin, { 0.090f, TOOL_ANKLE_HEIGHT, -0.012f } },
	{ "toe", tool_jointFoot, { 0.090f, TOOL_TOE_HEIGHT, TOOL_BALL_AHEAD - 0.012f } },
	{ "toe_tip", tool_jointToe, { 0.090f, 0.012f, TOOL_TIP_AHEAD - 0.012f } },
};

static int32_t toolLeftOf( int32_t joint )
{
	return joint >= tool_jointShoulder + tool_jointsOfSide ? joint - tool_jointsOfSide : joint;
}

static int32_t toolParentOf( int32_t joint )
{
	int32_t left = toolLeftOf( joint );
	int32_t parent = s_joints[left].parent;
	return left != joint && parent >= tool_jointShoulder ? parent + tool_jointsOfSide : parent;
}

soleVec3 toolRestJoint( int32_t joint )
{
	int32_t left = toolLeftOf( joint );
	soleVec3 rest = s_joints[left].rest;
	if ( left == tool_jointForearm || left == tool_jointHand )
	{
		soleVec3 bone = { cosf( TOOL_ARM_DROP ), -sinf( TOOL_ARM_DROP ), 0.0f };
		rest = soleMulAdd( s_joints[tool_jointUpperarm].rest, left == tool_jointForearm ? 0.285f : 0.535f, bone );
	}
	if ( left != joint )
	{
		rest.x = -rest.x;
	}
	return rest;
}

void toolRestPose( soleTransform* local )
{
	for ( int32_t i = 0; i < tool_jointCount; ++i )
	{
		local[i] = soleTransform_Identity();
		local[i].translation = toolRestJoint( i );
		if ( toolParentOf( i ) != SOLE_NONE )
		{
			local[i].translation = soleSub( local[i].translation, toolRestJoint( toolParentOf( i ) ) );
		}
	}
}

static void toolMakeNodes( toolModel* model )
{
	soleTransform rest[tool_jointCount];
	toolRestPose( rest );
	model->nodeCount = tool_jointCount + 1;
	model->nodes = toolAlloc( (size_t)model->nodeCount, sizeof( toolNode ) );
	for ( int32_t i = 0; i < tool_jointCount; ++i )
	{
		toolNode* node = model->nodes + i;
		const char* side = i < tool_jointShoulder ? "" : ( toolLeftOf( i ) == i ? "_l" : "_r" );
		node->name = toolFormat( "%s%s", s_joints[toolLeftOf( i )].name, side );
		node->parent = toolParentOf( i );
		node->local = rest[i];
		node->mesh = SOLE_NONE;
		node->skin = SOLE_NONE;
	}
	toolNode* body = model->nodes + tool_jointCount;
	body->name = toolCopyString( "mannequin" );
	body->parent = SOLE_NONE;
	body->local = soleTransform_Identity();
}

/// Every joint but the root, which nothing of the skin hangs on. @param skinJoints joint to index in the skin
static void toolMakeSkin( toolModel* model, int32_t* skinJoints )
{
	model->skinCount = 1;
	model->skins = toolAlloc( 1, sizeof( toolSkin ) );
	toolSkin* skin = model->skins;
	skin->name = toolCopyString( "mannequin" );
	skin->jointCount = tool_jointCount - 1;
	skin->joints = toolAlloc( (size_t)skin->jointCount, sizeof( int32_t ) );
	skin->inverseBind = toolAlloc( (size_t)skin->jointCount * 16, sizeof( float ) );
	skinJoints[tool_jointRoot] = 0;
	for ( int32_t i = 0; i < skin->jointCount; ++i )
	{
		skin->joints[i] = i + 1;
		skinJoints[i + 1] = i;
		soleVec3 rest = toolNodeWorld( model, i + 1 ).translation;
		float* m = skin->inverseBind + 16 * i;
		m[0] = m[5] = m[10] = m[15] = 1.0f;
		m[12] = -rest.x;
		m[13] = -rest.y;
		m[14] = -rest.z;
	}
}

static void toolMakeMaterials( toolModel* model )
{
	static const toolMaterial s_materials[] = {
		{ "body", { 0.745f, 0.665f, 0.545f, 1.0f }, 0.55f, false },
		{ "joints", { 0.055f, 0.085f, 0.105f, 1.0f }, 0.45f, false },
		{ "soles", { 0.680f, 0.150f, 0.060f, 1.0f }, 0.75f, false },
	};
	model->materialCount = 3;
	model->materials = toolAlloc( 3, sizeof( toolMaterial ) );
	for ( int32_t i = 0; i < 3; ++i )
	{
		model->materials[i] = s_materials[i];
		model->materials[i].name = toolCopyString( s_materials[i].name );
	}
}

typedef struct toolClipDef
{
	const char* name;
	void ( *pose )( double phase, toolBodyPose* body );
	int32_t frames; // one key more
	int32_t rate;   // 1/s
	bool movesRoot;
	bool turnsRoot;
} toolClipDef;

static void toolAddChannel( toolClip* clip, int32_t node, toolPath path, const toolClipDef* def )
{
	toolChannel* channel = clip->channels + clip->channelCount++;
	size_t keys = (size_t)def->frames + 1;
	channel->node = node;
	channel->path = path;
	channel->interpolation = tool_linear;
	channel->keyCount = def->frames + 1;
	channel->times = toolAlloc( keys, sizeof( float ) );
	channel->values = toolAlloc( keys * ( path == tool_pathRotation ? 4 : 3 ), sizeof( float ) );
	for ( int32_t key = 0; key <= def->frames; ++key )
	{
		channel->times[key] = (float)( (double)key / (double)def->rate );
	}
}

static void toolSetKey( toolChannel* channel, int32_t key, soleTransform local )
{
	if ( channel->path == tool_pathTranslation )
	{
		memcpy( channel->values + 3 * key, &local.translation, 3 * sizeof( float ) );
		return;
	}
	// Neighbouring keys on the same half of the sphere: some players do not look for the near side themselves.
	soleQuat q = soleNormalizeQuat( local.rotation );
	float* value = channel->values + 4 * key;
	if ( key > 0 )
	{
		soleQuat last = { value[-4], value[-3], value[-2], value[-1] };
		q = soleDotQuat( q, last ) < 0.0f ? soleNegQuat( q ) : q;
	}
	memcpy( value, &q, 4 * sizeof( float ) );
}

static void toolMakeClip( toolClip* clip, const toolClipDef* def )
{
	clip->name = toolCopyString( def->name );
	clip->end = (float)( (double)def->frames / (double)def->rate );
	clip->channels = toolAlloc( tool_jointCount + 2, sizeof( toolChannel ) );
	if ( def->movesRoot )
	{
		toolAddChannel( clip, tool_jointRoot, tool_pathTranslation, def );
	}
	if ( def->turnsRoot )
	{
		toolAddChannel( clip, tool_jointRoot, tool_pathRotation, def );
	}
	toolAddChannel( clip, tool_jointHips, tool_pathTranslation, def );
	for ( int32_t joint = tool_jointHips; joint < tool_jointCount; ++joint )
	{
		if ( toolLeftOf( joint ) != tool_jointToeTip )
		{
			toolAddChannel( clip, joint, tool_pathRotation, def );
		}
	}
	for ( int32_t key = 0; key <= def->frames; ++key )
	{
		toolBodyPose body = { .root = soleTransform_Identity() };
		soleTransform local[tool_jointCount];
		def->pose( (double)key / (double)def->frames, &body );
		toolSolveBody( &body, local );
		for ( int32_t i = 0; i < clip->channelCount; ++i )
		{
			toolSetKey( clip->channels + i, key, local[clip->channels[i].node] );
		}
	}
}

/// Makes the last key the same bits as the first: the formulas meet within rounding only.
static void toolCloseLoop( toolClip* clip )
{
	for ( int32_t i = 0; i < clip->channelCount; ++i )
	{
		toolChannel* channel = clip->channels + i;
		size_t width = channel->path == tool_pathRotation ? 4 : 3;
		if ( channel->node != tool_jointRoot )
		{
			memcpy(
			    channel->values + width * (size_t)( channel->keyCount - 1 ), channel->values, width * sizeof( float ) );
		}
	}
}

static void toolMakeClips( toolModel* model )
{
	static const toolClipDef s_clips[] = {
		{ "idle", toolPoseIdle, tool_idleFrames, 60, false, false },
		{ "walk", toolPoseWalk, tool_walkFrames, 60, false, false },
		{ "run", toolPoseRun, tool_runFrames, 120, false, false },
		{ "turn", toolPoseTurn, tool_turnFrames, 60, false, true },
		{ "walk_root", toolPoseWalkRoot, tool_walkFrames, 60, true, false },
		{ "strafe", toolPoseStrafe, tool_strafeFrames, 60, false, false },
		{ "crouch", toolPoseCrouch, tool_idleFrames, 60, false, false },
		{ "crouch_walk", toolPoseCrouchWalk, tool_walkFrames, 60, false, false },
	};
	model->clipCount = (int32_t)( sizeof s_clips / sizeof s_clips[0] );
	model->clips = toolAlloc( (size_t)model->clipCount, sizeof( toolClip ) );
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		toolMakeClip( model->clips + i, s_clips + i );
		toolCloseLoop( model->clips + i );
	}
}

void toolMakeMannequin( toolModel* model )
{
	int32_t skinJoints[tool_jointCount];
	*model = ( toolModel ){ 0 };
	toolMakeNodes( model );
	toolMakeSkin( model, skinJoints );
	toolMakeMaterials( model );
	model->meshCount = 1;
	model->meshes = toolAlloc( 1, sizeof( toolMesh ) );
	model->meshes[0] = toolMakeMannequinMesh( skinJoints );
	toolMakeClips( model );
}
