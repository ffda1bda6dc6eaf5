// SPDX-License-Identifier: MIT
// Steps of a clip: its motion over flat ground, labelled at a fine rate, one round of it (three where it loops, for
// what goes over its end). Character space.
#include "steps.h"

#include "evaluate.h"

#include <stdlib.h>

#define FINE_RATE 240.0 // Hz
#define MOST_SAMPLES 20000.0

void toolFindSteps(
    const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, toolSteps* steps )
{
	*steps = ( toolSteps ){ 0 };
	double rounds = travel->loops ? 3.0 : 1.0;
	double rate = fmin( FINE_RATE, fmax( MOST_SAMPLES / ( rounds * (double)bound->duration + 1e-6 ), 30.0 ) );
	toolTake take;
	toolError error;
	if ( !( bound->duration > 0.0f ) ||
	    toolMakeClipTake( character, bound, travel, rate, rounds, &take, &error ) == false )
	{
		return;
	}
	soleMotion motion = {
		.rig = character->rig,
		.frameCount = take.frameCount,
		.frameRate = take.frameRate,
		.poses = take.referencePoses,
		.roots = take.referenceRoots,
		.up = soleVec( 0.0f, 1.0f, 0.0f ),
		.clipFloor = travel->clipFloor,
	};
	int32_t count = soleFindSteps( &motion, take.labels, travel->loops, NULL, NULL, 0 );
	steps->steps = toolAlloc( (size_t)count + 1, sizeof *steps->steps );
	steps->count = soleFindSteps( &motion, take.labels, travel->loops, NULL, steps->steps, count );
	toolFreeTake( &take );
}

void toolFreeSteps( toolSteps* steps )
{
	free( steps->steps );
	*steps = ( toolSteps ){ 0 };
}

/// What the root of a walk will do between two times of the clip, as seen from where it is: by its own motion where it
/// has one, else going on as it goes.
static soleTransform toolForeseeRoot( const toolCharacter* character, const toolBoundClip* bound,
    const toolTravel* travel, const toolWalk* walk, int32_t frame, double wait )
{
	if ( travel->rootMotion )
	{
		double now = walk->clipTimes[frame];
		soleTransform from = toolSampleRoot( character, bound, travel, now );
		soleTransform to = toolSampleRoot( character, bound, travel, now + wait );
		soleTransform travelled = soleTransform_Identity();
		travelled.rotation = soleNormalizeQuat( soleMulQuat( soleConjugate( from.rotation ), to.rotation ) );
		travelled.translation = soleInvRotate( from.rotation, soleSub( to.translation, from.translation ) );
		return travelled;
	}
	if ( frame < 1 )
	{
		return soleExtrapolate( travel->strideVelocity, 0.0f, soleRig_GetUp( character->rig ), (float)wait );
	}
	soleTransform root = walk->roots[frame];
	soleTransform before = walk->roots[frame - 1];
	float perSecond = (float)walk->fps;
	soleVec3 up = soleRig_GetUp( character->rig );
	soleVec3 step = soleInvRotate( root.rotation, soleSub( root.translation, before.translation ) );
	soleQuat turn = soleMulQuat( soleConjugate( before.rotation ), root.rotation );
	float sine = soleDot( soleVec( turn.x, turn.y, turn.z ), up );
	soleVec3 velocity = soleScale( perSecond / root.scale.x, soleReject( step, up ) );
	float turnRate = 2.0f * perSecond * ( turn.w < 0.0f ? -sine : sine );
	return soleExtrapolate( velocity, turnRate, up, (float)( wait / walk->rate ) );
}

void toolReadSteps( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const toolSteps* steps, const toolWalk* walk, int32_t frame, soleContactInput* contacts, soleStepInput* inputs )
{
	toolRoundTime time = toolFindRound( bound, travel, walk->clipTimes[frame] );
	float rate = (float)walk->rate;
	for ( int32_t leg = 0; leg < character->rigDef.legCount; ++leg )
	{
		contacts[leg] = ( soleContactInput ){ -1.0f, -1.0f };
		inputs[leg] = ( soleStepInput ){ .since = -1.0f, .until = -1.0f };
		if ( steps->count > 0 )
		{
			soleGetStepInput( steps->steps, steps->count, bound->duration, travel->loops, (float)time.rest, leg,
			    contacts + leg, inputs + leg );
			float wait = inputs[leg].until;
			if ( wait >= 0.0f && wait < SOLE_STEP_ENDLESS )
			{
				soleStepInput_Travel(
				    inputs + leg, toolForeseeRoot( character, bound, travel, walk, frame, (double)wait ) );
			}
			// From the clip's time to that of the walk.
			inputs[leg].since = inputs[leg].since > 0.0f ? inputs[leg].since / rate : inputs[leg].since;
			inputs[leg].until = inputs[leg].until > 0.0f ? inputs[leg].until / rate : inputs[leg].until;
		}
	}
}
