// SPDX-License-Identifier: MIT
// Steps of a clip: its motion over flat ground, labelled at a fine rate, one round of it (three where it loops, for
// what goes over its end). Character space.
#include "steps.h"

#include "evaluate.h"

#include <stdlib.h>

#define FINE_RATE 240.0 // Hz
#define MOST_SAMPLES 20000.0
#define MOST_FORESEEN 1e6f // s

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

bool toolReadStep( const toolBoundClip* bound, const toolTravel* travel, const toolSteps* steps, double clipTime,
    double rate, int32_t leg, soleContactInput* contact, soleStepInput* input )
{
	*contact = ( soleContactInput ){ -1.0f, -1.0f };
	*input = ( soleStepInput ){ .since = -1.0f, .until = -1.0f };
	if ( steps->count == 0 )
	{
		return false;
	}
	toolRoundTime time = toolFindRound( bound, travel, clipTime );
	soleGetStepInput(
	    steps->steps, steps->count, bound->duration, travel->loops, (float)time.rest, leg, contact, input );
	// From the clip's time to that of the world. A clip that stands still foretells nothing.
	float perRate = rate > 0.0 ? (float)( 1.0 / rate ) : SOLE_STEP_ENDLESS;
	input->since = input->since > 0.0f ? input->since * perRate : input->since;
	float until = input->until * perRate;
	input->until = until >= 0.0f && until < MOST_FORESEEN ? until : -1.0f;
	return input->until >= 0.0f;
}

toolPace toolFindPace( const toolCharacter* character, soleTransform before, soleTransform now, double time )
{
	if ( !( time > 0.0 ) )
	{
		return ( toolPace ){ .turnRate = 0.0f };
	}
	soleVec3 up = soleRig_GetUp( character->rig );
	float perSecond = (float)( 1.0 / time );
	// A root that turns has gone this way as it was headed half way.
	soleQuat halfWay = soleNlerp( before.rotation, now.rotation, 0.5f );
	soleVec3 step = soleInvRotate( halfWay, soleSub( now.translation, before.translation ) );
	soleQuat turn = soleMulQuat( soleConjugate( before.rotation ), now.rotation );
	float sine = soleDot( soleVec( turn.x, turn.y, turn.z ), up );
	return ( toolPace ){
		.velocity = soleScale( perSecond / now.scale.x, soleReject( step, up ) ),
		.turnRate = 2.0f * perSecond * ( turn.w < 0.0f ? -sine : sine ),
	};
}

/// What the root of a walk will do in the next time, as seen from where it is: by its own motion where it has one, else
/// going on as it goes.
static soleTransform toolForeseeRoot( const toolCharacter* character, const toolBoundClip* bound,
    const toolTravel* travel, const toolWalk* walk, int32_t frame, double wait )
{
	if ( travel->rootMotion )
	{
		double now = walk->clipTimes[frame];
		soleTransform from = toolSampleRoot( character, bound, travel, now );
		soleTransform to = toolSampleRoot( character, bound, travel, now + walk->rate * wait );
		soleTransform travelled = soleTransform_Identity();
		travelled.rotation = soleNormalizeQuat( soleMulQuat( soleConjugate( from.rotation ), to.rotation ) );
		travelled.translation = soleInvRotate( from.rotation, soleSub( to.translation, from.translation ) );
		return travelled;
	}
	toolPace pace = { .velocity = soleScale( (float)walk->rate, travel->strideVelocity ) };
	if ( frame > 0 )
	{
		pace = toolFindPace( character, walk->roots[frame - 1], walk->roots[frame], 1.0 / walk->fps );
	}
	return soleExtrapolate( pace.velocity, pace.turnRate, soleRig_GetUp( character->rig ), (float)wait );
}

void toolReadSteps( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    const toolSteps* steps, const toolWalk* walk, int32_t frame, soleContactInput* contacts, soleStepInput* inputs )
{
	for ( int32_t leg = 0; leg < character->rigDef.legCount; ++leg )
	{
		soleStepInput* input = inputs + leg;
		if ( toolReadStep( bound, travel, steps, walk->clipTimes[frame], walk->rate, leg, contacts + leg, input ) )
		{
			soleStepInput_Travel(
			    input, toolForeseeRoot( character, bound, travel, walk, frame, (double)input->until ) );
		}
	}
}
