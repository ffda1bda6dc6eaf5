// SPDX-License-Identifier: MIT
// Acts: from what a plain walk or stand would be, over what is special, to the root. World space, metres, seconds.
#include "act_play.h"

#include <string.h>

#define DEGREE 0.017453292519943295
#define NO_CEILING 1000.0

const soleAct* soleFindAct( const char* scene, const char* name )
{
	int32_t count;
	const soleAct* acts = soleGetActs( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( strcmp( acts[i].scene, scene ) == 0 && strcmp( acts[i].name, name ) == 0 )
		{
			return acts + i;
		}
	}
	return NULL;
}

double soleGetActStep( const soleAct* act, int32_t frame )
{
	if ( frame == 0 )
	{
		return 0.0;
	}
	return act->host.step != NULL ? act->host.step( frame ) : 1.0 / ( act->host.rate > 0.0 ? act->host.rate : 60.0 );
}

void soleSetPlace( const soleAct* act, double x, double z, double course, double way, soleSceneMoment* moment )
{
	moment->way = way;
	moment->x = x + way * sin( DEGREE * course );
	moment->z = z + way * cos( DEGREE * course );
	moment->heading = DEGREE * ( course + act->course.facing );
}

bool soleFindStageFloor( const soleAct* act, const soleStage* stage, double x, double z, double time, double* height )
{
	*height = 0.0;
	double ceiling = act->host.ceiling > 0.0 ? act->host.ceiling : NO_CEILING;
	return stage->findFloor( stage->user, x, z, ceiling, time, height );
}

static bool soleIsStill( const soleScene* scene )
{
	for ( int32_t i = 0; i < scene->pieceCount; ++i )
	{
		const soleSceneMotion* m = &scene->pieces[i].motion;
		bool still = m->waveRate == 0.0 && m->spin == 0.0 && m->tilt == 0.0 && m->from == 0.0 && m->until == 0.0 &&
		    soleDot( m->velocity, m->velocity ) == 0.0f;
		if ( still == false && scene->pieces[i].layer != sole_sceneLoose )
		{
			return false;
		}
	}
	return true;
}

/// All but the root.
static void soleDraft( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	*moment = ( soleSceneMoment ){
		.scale = 1.0, .legs = 1.0, .gait = act->gait, .other = act->gait, .stride = act->host.stride, .weight = 1.0
	};
	moment->resting = act->course.speed == 0.0 && soleIsStill( stage->scene );
	soleSetPlace( act, act->course.x, act->course.z, act->course.heading, act->course.speed * time, moment );
	if ( act->special.play != NULL )
	{
		act->special.play( act, stage, take, time, moment );
	}
}

/// Straight between the floors at the corners of the way, level before the first and after the last.
static double soleGetRampHeight( const soleAct* act, const soleStage* stage, const soleSceneMoment* moment )
{
	double height = 0.0;
	double before = 0.0;
	for ( int i = 0; i < SOLE_ACT_CORNERS; ++i )
	{
		double corner = act->host.corners[i];
		double x = act->course.x + corner * sin( DEGREE * act->course.heading );
		double z = act->course.z + corner * cos( DEGREE * act->course.heading );
		double floor;
		soleFindStageFloor( act, stage, x, z, 0.0, &floor );
		if ( moment->way < corner )
		{
			return i == 0 ? floor : height + ( floor - height ) * ( moment->way - before ) / ( corner - before );
		}
		height = floor;
		before = corner;
	}
	return height;
}

static double soleGetRootHeight(
    const soleAct* act, const soleStage* stage, double time, const soleSceneMoment* moment )
{
	double height;
	if ( act->root == sole_rootStepped )
	{
		soleFindStageFloor( act, stage, moment->x, moment->z, time, &height );
		return height + moment->lift;
	}
	if ( act->root == sole_rootRamped )
	{
		return soleGetRampHeight( act, stage, moment ) + moment->lift;
	}
	soleFindStageFloor( act, stage, act->course.x, act->course.z, 0.0, &height );
	return height + moment->lift;
}

static void soleGetWholeMoment(
    const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	soleDraft( act, stage, take, time, moment );
	if ( act->root == sole_rootAround )
	{
		soleGetSceneWay( stage->scene, moment->way, &moment->root );
		moment->up = soleRotate( moment->root.rotation, soleVec( 0.0f, 1.0f, 0.0f ) );
		return;
	}
	moment->up = soleVec( 0.0f, 1.0f, 0.0f );
	double y = soleGetRootHeight( act, stage, time, moment );
	float scale = (float)moment->scale;
	moment->root.translation = soleVec( (float)moment->x, (float)y, (float)moment->z );
	moment->root.rotation =
	    ( soleQuat ){ 0.0f, (float)sin( 0.5 * moment->heading ), 0.0f, (float)cos( 0.5 * moment->heading ) };
	moment->root.scale = soleVec( scale, scale, scale );
}

void soleGetSceneMoment(
    const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	soleGetWholeMoment( act, stage, take, time, moment );
	if ( act->host.rootRate <= 0.0 )
	{
		return;
	}
	double ticks = time * act->host.rootRate + 1e-6;
	double tick = floor( ticks );
	soleSceneMoment known;
	soleGetWholeMoment( act, stage, take, tick / act->host.rootRate, &known );
	if ( act->host.rootHeld )
	{
		moment->root = known.root;
		return;
	}
	soleSceneMoment before;
	soleGetWholeMoment( act, stage, take, ( tick > 1.0 ? tick - 1.0 : 0.0 ) / act->host.rootRate, &before );
	double share = ticks - tick;
	moment->way = before.way + share * ( known.way - before.way );
	moment->root.translation = soleLerp( before.root.translation, known.root.translation, (float)share );
	moment->root.rotation = soleNlerp( before.root.rotation, known.root.rotation, (float)share );
}
