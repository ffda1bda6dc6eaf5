// SPDX-License-Identifier: MIT
// Where a host's character goes and which way it faces, as functions of time. World space, metres, seconds.
#include "act_play.h"
#include "scene_builder.h"

#define TURN 6.283185307179586
#define GRAVITY 9.81
#define FLIGHT 0.5 // of a jump, s

/// 0 before, 1 after.
static double soleGetShare( double time, double start, double duration )
{
	double share = ( time - start ) / duration;
	return share < 0.0 ? 0.0 : ( share > 1.0 ? 1.0 : share );
}

// ----------------------------------------------------------------------------------------------- places and headings

void solePlayHeadings( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)time;
	soleSetPlace( act, act->course.x, act->course.z, act->course.heading + 45.0 * take, moment->way, moment );
}

void solePlayCrossing( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)time;
	soleSceneMoment start;
	double course = act->course.heading + 45.0 * take;
	soleSetPlace( act, act->course.x, act->course.z, course, -0.5 * act->course.speed * act->duration, &start );
	soleSetPlace( act, start.x, start.z, course, moment->way, moment );
}

void solePlayOnTreads( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)time;
	soleSetPlace( act, act->course.x, act->course.z + 0.06 * ( take / 8 ), 45.0 * ( take % 8 ), 0.0, moment );
}

void solePlaySpots( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)time;
	uint32_t series = 977u * (uint32_t)( take + 1 );
	double x = soleSceneRandom( &series, -act->special.value, act->special.value );
	double z = soleSceneRandom( &series, -act->special.value, act->special.value );
	soleSetPlace( act, x, z, soleSceneRandom( &series, 0.0, 360.0 ), 0.0, moment );
}

void solePlayLanes( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)time;
	moment->x += act->special.value * ( take - 0.5 * ( act->special.takeCount - 1 ) );
}

void solePlayOverSlit( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)act;
	(void)stage;
	(void)time;
	static const double middles[3] = { 2.55, 5.20, 7.975 };
	moment->z = middles[take] - 0.07; // that far ahead is the middle of a foot
}

// -------------------------------------------------------------------------------------------- moved by something else

void solePlayRide( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)act;
	(void)take;
	soleTransform place;
	soleGetScenePiece( stage->scene, 1, time, &place );
	soleVec3 now = soleTransformPoint( place, soleVec( (float)moment->x, 0.0f, (float)moment->z ) );
	moment->x = (double)now.x;
	moment->z = (double)now.z;
}

void solePlayFall( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	double fell = time - act->special.value;
	double height = 0.8 - 0.5 * GRAVITY * fell * fell;
	moment->lift = fell >= 0.0 && height > 0.0 ? height : 0.0;
}

void solePlayLift( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	// Up, down through 0, up again.
	double round = 0.1 * time / act->special.value;
	round -= 4.0 * floor( round / 4.0 );
	moment->lift = act->special.value * ( round < 1.0 ? round : ( round < 3.0 ? 2.0 - round : round - 4.0 ) );
	moment->resting = false;
}

void solePlayTeleport( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	if ( time >= act->special.value )
	{
		moment->x += 9.4;
		moment->z += 3.4;
		moment->jumps = 1;
	}
}

void solePlayCorrected( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	double rounds = 0.5 * time;
	moment->x += act->special.value * ( rounds - 2.0 * floor( 0.5 * rounds ) >= 1.0 ? 1.0 : 0.0 );
}

// -------------------------------------------------------------------------------------------------- turns and courses

void solePlaySpin( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	moment->heading += TURN * soleGetShare( time, 0.0, act->special.value );
	moment->resting = time >= act->special.value;
}

void solePlaySway( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	moment->heading += 0.25 * TURN * sin( TURN * act->special.value * time );
	moment->resting = false;
}

void solePlayBend( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	const double lasts = 0.4;
	double radius = act->course.speed * lasts / ( 0.25 * TURN );
	double angle = 0.25 * TURN * soleGetShare( time, act->special.value, lasts );
	double straight = act->course.speed * ( time < act->special.value ? time : act->special.value );
	double after = time > act->special.value + lasts ? act->course.speed * ( time - act->special.value - lasts ) : 0.0;
	moment->x = act->course.x + radius * ( 1.0 - cos( angle ) ) + after;
	moment->z = act->course.z + straight + radius * sin( angle );
	moment->heading = angle;
}

/// How far it has gone that slows down evenly to a stop.
static double soleGetStoppingWay( const soleAct* act, double time, double lasts )
{
	double slowing = time > act->special.value ? time - act->special.value : 0.0;
	slowing = slowing < lasts ? slowing : lasts;
	double even = time < act->special.value ? time : act->special.value;
	return act->course.speed * ( even + slowing - 0.5 * slowing * slowing / lasts );
}

void solePlayStop( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	const double lasts = 0.4;
	soleSetPlace(
	    act, act->course.x, act->course.z, act->course.heading, soleGetStoppingWay( act, time, lasts ), moment );
	moment->resting = time >= act->special.value + lasts;
}

void solePlayToIdle( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	const double lasts = act->gait == sole_gaitRun ? 0.3 : 0.2;
	soleSetPlace(
	    act, act->course.x, act->course.z, act->course.heading, soleGetStoppingWay( act, time, lasts ), moment );
	moment->other = sole_gaitIdle;
	moment->blend = soleGetShare( time, act->special.value, lasts );
	moment->resting = time >= act->special.value + lasts;
}

void solePlaySwap( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	double round = 2.0 * act->special.value * time;
	round -= 2.0 * floor( 0.5 * round );
	double way = act->course.speed / ( 2.0 * act->special.value ) * ( round < 1.0 ? round : 2.0 - round );
	soleSetPlace( act, act->course.x, act->course.z, act->course.heading, way, moment );
}

void solePlaySidestep( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	const double lasts = 0.2;
	double arrives = act->special.value / act->course.speed;
	double way = time < arrives ? act->course.speed * time : act->special.value;
	soleSetPlace( act, act->course.x, act->course.z, act->course.heading, way, moment );
	moment->other = sole_gaitIdle;
	moment->blend = soleGetShare( time, arrives - lasts, lasts );
	moment->resting = time >= arrives;
}

/// A parabola from the floor where it leaves to the floor where it lands. It walks up to it, and on after it; the host
/// takes Sole out in the air.
void solePlayJump( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)take;
	double into = soleGetShare( time, act->special.value - 0.1, 0.2 );
	double out = soleGetShare( time, act->special.value + FLIGHT, 0.2 );
	moment->other = sole_gaitIdle;
	moment->blend = into - out;
	double off = 1.0 - soleGetShare( time, act->special.value, 0.1 );
	double on = soleGetShare( time, act->special.value + FLIGHT - 0.1, 0.2 );
	moment->weight = off > on ? off : on;
	double flown = time - act->special.value;
	if ( flown <= 0.0 || flown >= FLIGHT )
	{
		return;
	}
	double heights[3];
	const double times[3] = { act->special.value, act->special.value + FLIGHT, time };
	for ( int i = 0; i < 3; ++i )
	{
		soleSceneMoment place;
		soleSetPlace( act, act->course.x, act->course.z, act->course.heading, act->course.speed * times[i], &place );
		soleFindStageFloor( act, stage, place.x, place.z, time, heights + i );
	}
	double height =
	    heights[0] + ( heights[1] - heights[0] ) * flown / FLIGHT + 0.5 * GRAVITY * flown * ( FLIGHT - flown );
	moment->lift = height - heights[2];
}
