// SPDX-License-Identifier: MIT
// Clips of a character looked at: does it travel by itself, how fast do its feet pretend to walk, when are they on the
// floor. The labels are those of soleLabelContacts on the flat floor of the clip.
#include "inspect.h"

#include <stdlib.h>

#define FRAME_RATE 60.0f
#define TRANSFORM_LIMIT 4000000 // of a sampled clip

/// The clip as it moves over flat ground: an in-place clip is carried along at its own stride speed.
static void toolSampleMotion( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const soleMotion* motion, soleTransform* poses, soleTransform* roots )
{
	for ( int32_t i = 0; i < motion->frameCount; ++i )
	{
		double time = (double)i / (double)motion->frameRate;
		toolSampleLooped(
		    character, bound, travel, time, poses + (size_t)i * (size_t)character->jointCount, roots + i );
		if ( travel->rootMotion == false )
		{
			roots[i] = soleTransform_Identity();
			roots[i].translation = soleScale( (float)time, travel->strideVelocity );
		}
	}
}

static void toolAddInterval( toolLegContacts* contacts, float start, float end )
{
	size_t count = (size_t)contacts->count + 1;
	contacts->intervals = toolGrow( contacts->intervals, count, sizeof( toolInterval ) );
	contacts->intervals[contacts->count++] = ( toolInterval ){ start, end };
}

/// Runs of frames with any contact.
static void toolFindIntervals( const soleMotion* motion, const uint8_t* labels, int32_t legCount, toolClipFacts* facts )
{
	for ( int32_t leg = 0; leg < legCount; ++leg )
	{
		int32_t start = SOLE_NONE;
		for ( int32_t i = 0; i <= motion->frameCount; ++i )
		{
			bool on = i < motion->frameCount && labels[(size_t)i * (size_t)legCount + (size_t)leg] != sole_labelNone;
			if ( on && start == SOLE_NONE )
			{
				start = i;
			}
			if ( on == false && start != SOLE_NONE )
			{
				float last = (float)( i - 1 ) / motion->frameRate;
				toolAddInterval( facts->legs + leg, (float)start / motion->frameRate, last );
				start = SOLE_NONE;
			}
		}
	}
}

static void toolLabelClip( const toolCharacter* character, const toolBoundClip* bound, toolClipFacts* facts )
{
	soleMotion motion = { .rig = character->rig, .frameRate = FRAME_RATE, .up = character->rigDef.up };
	double most = (double)TRANSFORM_LIMIT / (double)character->jointCount;
	if ( (double)bound->duration * (double)FRAME_RATE > most )
	{
		motion.frameRate = (float)( most / (double)bound->duration );
	}
	motion.frameCount = (int32_t)( bound->duration * motion.frameRate + 0.5f ) + 1;
	motion.clipFloor = facts->travel.clipFloor;
	size_t frames = (size_t)motion.frameCount;
	soleTransform* poses = toolAlloc( frames * (size_t)character->jointCount, sizeof( soleTransform ) );
	soleTransform* roots = toolAlloc( frames, sizeof( soleTransform ) );
	uint8_t* labels = toolAlloc( frames * (size_t)character->rigDef.legCount, 1 );
	toolSampleMotion( character, bound, &facts->travel, &motion, poses, roots );
	motion.poses = poses;
	motion.roots = roots;
	soleLabelDef def = soleDefaultLabelDef();
	if ( soleLabelContacts( &motion, &def, NULL, labels ) == sole_success )
	{
		toolFindIntervals( &motion, labels, character->rigDef.legCount, facts );
	}
	free( poses );
	free( roots );
	free( labels );
}

toolClipFacts* toolInspectClips( const toolCharacter* character )
{
	const toolModel* model = character->model;
	toolClipFacts* all = toolAlloc( (size_t)model->clipCount, sizeof( toolClipFacts ) );
	for ( int32_t i = 0; i < model->clipCount; ++i )
	{
		toolClipFacts* facts = all + i;
		toolBoundClip bound = { 0 };
		facts->clip = model->clips + i;
		if ( toolBindClip( character, model, i, &bound, &facts->error ) == false )
		{
			facts->refused = true;
			continue;
		}
		facts->duration = bound.duration;
		facts->travel = toolFindTravel( character, &bound );
		soleVec3 stride = soleReject( facts->travel.strideVelocity, character->rigDef.up );
		facts->strideSpeed = soleLength( stride );
		toolLabelClip( character, &bound, facts );
		toolFreeBoundClip( &bound );
		toolProgress( "clips", (double)( i + 1 ) / (double)model->clipCount );
	}
	return all;
}

void toolFreeClipFacts( toolClipFacts* facts, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t leg = 0; leg < SOLE_MAX_LEGS; ++leg )
		{
			free( facts[i].legs[leg].intervals );
		}
	}
	free( facts );
}
