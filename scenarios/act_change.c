// SPDX-License-Identifier: MIT
// What a host changes beside the root: pose, weights, scale, shoes, origin of the world, lengths of frames. As
// functions of time or of the frame's number.
#include "act_play.h"
#include "scene_builder.h"

#define TURN 6.283185307179586
#define FRAME ( 1.0 / 60.0 )

/// Smooth, 0 before and 1 after.
static double soleGetEase( double time, double start, double duration )
{
	return soleSceneFade( ( time - start ) / duration );
}

void solePlayHipsAside( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	(void)time;
	moment->hips = soleVec( (float)act->special.value, 0.0f, 0.0f );
}

void solePlayCrouch( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	solePlayHeadings( act, stage, take, time, moment );
	double up = act->duration - 2.5;
	double depth = soleGetEase( time, 0.5, 1.0 ) - soleGetEase( time, up, 1.0 );
	moment->hips = soleVec( 0.0f, (float)( -act->special.value * depth ), 0.0f );
	moment->resting = ( time >= 1.5 && time < up ) || time >= up + 1.0;
}

void solePlayOrigin( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	moment->origin[0] = time >= act->special.value ? 10000.0 : 0.0;
}

void solePlayRebase( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	moment->base.z = time >= act->special.value ? 1.0f : 0.0f;
}

void solePlayWeight( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	double off = ( time - 2.0 ) / ( act->special.value > 0.0 ? 0.15 : 1e-6 );
	double on = ( time - 4.0 ) / ( act->special.value > 0.0 ? 0.20 : 1e-6 );
	double weight = on > 0.0 ? on : 1.0 - off;
	moment->weight = weight < 0.0 ? 0.0 : ( weight > 1.0 ? 1.0 : weight );
	moment->x += 0.5 * soleGetEase( time, 2.5, 1.0 );
	moment->resting = time < 2.0 || time > 4.2;
}

void solePlayFootJump( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	if ( time > act->special.value - 0.5 * FRAME && time < act->special.value + 0.5 * FRAME )
	{
		moment->feet[0] = soleVec( 0.0f, 0.24f, 0.18f );
	}
	moment->resting = false;
}

void solePlayTap( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	const double lasts = 0.2;
	for ( int i = 0; i < 2; ++i )
	{
		double start = act->special.value + 1.5 * lasts * i;
		double rise = sin( 0.5 * TURN * ( time - start ) / lasts );
		bool up = time > start && time < start + lasts;
		moment->feet[0].y += up ? (float)( 0.1 * rise * rise ) : 0.0f;
		moment->feet[0].z += (float)( ( i == 0 ? 0.12 : -0.12 ) * soleGetEase( time, start, lasts ) );
	}
	moment->resting = time < act->special.value || time > act->special.value + 3.0 * lasts;
}

void solePlayNudge( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	float aside = (float)( act->special.value * sin( 2.0 * TURN * time ) );
	moment->feet[0].x = aside;
	moment->feet[1].x = aside;
}

void solePlayFeetIn( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	(void)time;
	moment->feet[0].x = (float)-act->special.value;
	moment->feet[1].x = (float)act->special.value;
}

void solePlayScale( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	static const double sizes[3] = { 0.5, 1.0, 2.0 };
	double share =
	    act->special.value > 0.0 ? soleGetEase( time, 1.0, act->special.value ) : ( time >= 1.0 ? 1.0 : 0.0 );
	moment->scale = 1.0 + share * ( sizes[take] - 1.0 );
	moment->resting = time < 1.0 || time > 1.0 + act->special.value;
}

void solePlayLegs( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	double most = take == 0 ? act->special.value : -act->special.value;
	moment->legs = 1.0 + most * soleGetEase( time, 1.0, 1.0 );
	moment->resting = time < 1.0 || time > 2.0;
}

void solePlayShoes( const soleAct* act, const soleStage* stage, int32_t take, double time, soleSceneMoment* moment )
{
	(void)stage;
	(void)take;
	// Flat, high, bare, flat.
	const double lasts = 0.3;
	moment->heel = act->special.value * ( soleGetEase( time, 2.0, lasts ) - soleGetEase( time, 4.0, lasts ) );
	moment->resting = time < 2.0 || ( time > 2.0 + lasts && time < 4.0 ) || time > 4.0 + lasts;
}

double soleGetWildStep( int32_t frame )
{
	uint32_t series = 6007u * (uint32_t)frame;
	return soleSceneRandom( &series, 0.005, 0.250 );
}

double soleGetHitchStep( int32_t frame )
{
	return frame == 120 ? 1.0 : FRAME;
}

double soleGetPausedStep( int32_t frame )
{
	return frame >= 120 && frame < 240 ? 0.0 : FRAME;
}
