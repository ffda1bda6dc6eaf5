// SPDX-License-Identifier: MIT
// Motions of scene pieces in closed form: place = pivot + shift + R ( start - pivot ). World space.
#include "scene_motion.h"

#define TURN 6.283185307179586

/// Of the pivot.
static soleVec3 soleGetShift( const soleSceneMotion* motion, double time )
{
	double goes = motion->stopTime > 0.0 && time > motion->stopTime ? motion->stopTime : time;
	soleVec3 wave = soleScale( (float)sin( TURN * motion->waveRate * time ), motion->wave );
	return soleMulAdd( wave, (float)goes, motion->velocity );
}

static soleVec3 soleGetShiftSpeed( const soleSceneMotion* motion, double time )
{
	double rate = TURN * motion->waveRate;
	soleVec3 wave = soleScale( (float)( rate * cos( rate * time ) ), motion->wave );
	bool goes = motion->stopTime <= 0.0 || time < motion->stopTime;
	return goes ? soleAdd( wave, motion->velocity ) : wave;
}

static soleQuat soleGetTurn( const soleSceneMotion* motion, double time )
{
	double half = 0.5 * ( motion->spin * time + motion->tilt * sin( TURN * motion->tiltRate * time ) );
	soleVec3 sine = soleScale( (float)sin( half ), motion->axis );
	return soleNormalizeQuat( ( soleQuat ){ sine.x, sine.y, sine.z, (float)cos( half ) } );
}

bool soleGetSceneMotion( const soleSceneMotion* motion, double time, soleTransform* fromStart )
{
	*fromStart = soleTransform_Identity();
	fromStart->rotation = soleGetTurn( motion, time );
	soleVec3 middle = soleAdd( motion->pivot, soleGetShift( motion, time ) );
	fromStart->translation = soleSub( middle, soleRotate( fromStart->rotation, motion->pivot ) );
	return time >= motion->from && ( motion->until <= 0.0 || time < motion->until );
}

void soleGetSceneMotionSpeed( const soleSceneMotion* motion, double time, soleVec3* velocity, soleVec3* spin )
{
	double rate = TURN * motion->tiltRate;
	*spin = soleScale( (float)( motion->spin + rate * motion->tilt * cos( rate * time ) ), motion->axis );
	soleVec3 arm = soleRotate( soleGetTurn( motion, time ), motion->pivot );
	*velocity = soleSub( soleGetShiftSpeed( motion, time ), soleCross( *spin, arm ) );
}
