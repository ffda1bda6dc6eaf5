// SPDX-License-Identifier: MIT
// Steps of a clip, from the labels of its motion over flat ground: when each foot comes down and leaves, and where it
// stands then as seen from where the root is.
#include "base/core.h"
#include "measure/pose.h"

#include <math.h>

#define REST_TIME 0.045 // s after the first contact, until when a foot has come to rest

/// A run of frames with a label, both ends included; first > last: none.
typedef struct soleLabelRun
{
	int32_t first;
	int32_t last;
} soleLabelRun;

typedef struct soleStepFinder
{
	const soleMotion* motion;
	const uint8_t* labels;
	soleMeasurePose pose;
	int32_t legCount;
	int32_t frameCount;
	double rate;
} soleStepFinder;

static uint8_t soleLabelAt( const soleStepFinder* finder, int32_t frame, int32_t leg )
{
	return finder->labels[(size_t)frame * (size_t)finder->legCount + (size_t)leg];
}

/// First and last frame of a run whose labels have all of some bits.
static soleLabelRun soleFindRun( const soleStepFinder* finder, soleLabelRun run, int32_t leg, uint8_t bits )
{
	soleLabelRun found = { run.last + 1, run.first - 1 };
	for ( int32_t frame = run.first; frame <= run.last; ++frame )
	{
		if ( ( soleLabelAt( finder, frame, leg ) & bits ) == bits )
		{
			found.first = frame < found.first ? frame : found.first;
			found.last = frame;
		}
	}
	return found;
}

/// Labels change half way between frames; what the motion's ends cut off has no end.
static float soleBeginOf( const soleStepFinder* finder, int32_t frame )
{
	return frame <= 0 ? -SOLE_STEP_ENDLESS : (float)( ( (double)frame - 0.5 ) / finder->rate );
}

static float soleEndOf( const soleStepFinder* finder, int32_t frame )
{
	return frame + 1 >= finder->frameCount ? SOLE_STEP_ENDLESS : (float)( ( (double)frame + 0.5 ) / finder->rate );
}

static void soleSetInterval( const soleStepFinder* finder, soleLabelRun run, float* down, float* up )
{
	bool any = run.first <= run.last;
	*down = any ? soleBeginOf( finder, run.first ) : 0.0f;
	*up = any ? soleEndOf( finder, run.last ) : 0.0f;
}

/// Labels change half way between frames, and so is the root then.
static soleTransform soleRootAtStrike( const soleMotion* motion, int32_t strike )
{
	soleTransform root = motion->roots[strike];
	if ( strike > 0 )
	{
		soleTransform before = motion->roots[strike - 1];
		root.translation = soleLerp( before.translation, root.translation, 0.5f );
		root.rotation = soleNlerp( before.rotation, root.rotation, 0.5f );
	}
	return root;
}

/// Where the foot stands if what touches first stays where it is, as seen from the root then: the ball of the flat
/// foot. Its heading and how far the ball is from the heel are taken from a frame in which it stands.
static void solePlaceStep( soleStepFinder* finder, int32_t standing, int32_t strike, bool heelFirst, soleStep* step )
{
	const soleMotion* motion = finder->motion;
	const soleRig* rig = motion->rig;
	soleVec3d up = soleUnitD( soleWiden( motion->up ), ( soleVec3d ){ 0.0, 1.0, 0.0 } );
	soleEvaluateWorld( &finder->pose, motion, standing );
	soleVec3d heel = soleGetCarried( &finder->pose, soleGetHeelPoint( rig, step->leg ) );
	soleVec3d ball = soleGetCarried( &finder->pose, soleGetBallPoint( rig, step->leg ) );
	soleVec3d along = soleRejectD( soleSubD( ball, heel ), up );
	int32_t resting = strike + (int32_t)( REST_TIME * finder->rate + 0.5 );
	soleEvaluateWorld( &finder->pose, motion, resting < standing ? resting : standing );
	soleVec3d place = soleGetCarried( &finder->pose, soleGetBallPoint( rig, step->leg ) );
	if ( heelFirst )
	{
		place = soleAddD( soleGetCarried( &finder->pose, soleGetHeelPoint( rig, step->leg ) ), along );
	}
	soleTransform root = soleRootAtStrike( motion, strike );
	soleVec3 rigUp = soleRig_GetUp( rig );
	soleVec3 at = soleInvTransformPoint( root, soleVec( (float)place.x, (float)place.y, (float)place.z ) );
	soleVec3 heading = soleInvRotate( root.rotation, soleVec( (float)along.x, (float)along.y, (float)along.z ) );
	step->place = soleMulAdd( soleReject( at, rigUp ), motion->clipFloor, rigUp );
	step->forward = soleNormalizeOr( soleReject( heading, rigUp ), soleRig_GetForward( rig ) );
}

static soleStep soleMakeStep( soleStepFinder* finder, soleLabelRun run, int32_t leg )
{
	soleStep step = { .leg = leg };
	soleLabelRun heel = soleFindRun( finder, run, leg, sole_labelHeel );
	soleLabelRun toe = soleFindRun( finder, run, leg, sole_labelToe );
	soleLabelRun flat = soleFindRun( finder, run, leg, sole_labelFlat );
	soleSetInterval( finder, run, &step.strike, &step.lift );
	soleSetInterval( finder, heel, &step.heelDown, &step.heelUp );
	soleSetInterval( finder, toe, &step.toeDown, &step.toeUp );
	soleLabelRun standing = flat.first <= flat.last ? flat : ( toe.first <= toe.last ? toe : run );
	bool heelFirst = heel.first <= heel.last && ( toe.first > toe.last || heel.first < toe.first );
	solePlaceStep( finder, ( standing.first + standing.last ) / 2, run.first, heelFirst, &step );
	return step;
}

static void soleMoveTime( float* time, double by )
{
	*time = *time > -SOLE_STEP_ENDLESS && *time < SOLE_STEP_ENDLESS ? (float)( (double)*time + by ) : *time;
}

/// Of a motion of three rounds: does the step belong to the middle one? Its times are counted from there.
static bool soleBringIntoRound( const soleStepFinder* finder, soleStep* step )
{
	bool standing = step->strike <= -SOLE_STEP_ENDLESS && step->lift >= SOLE_STEP_ENDLESS;
	double round = (double)( finder->frameCount - 1 ) / finder->rate / 3.0;
	double strike = (double)step->strike;
	bool within = strike >= round && strike < 2.0 * round;
	float* times[] = { &step->strike, &step->lift, &step->heelDown, &step->heelUp, &step->toeDown, &step->toeUp };
	for ( int32_t i = 0; i < 6; ++i )
	{
		soleMoveTime( times[i], -round );
	}
	return standing || within;
}

static int32_t soleFindLegSteps(
    soleStepFinder* finder, int32_t leg, bool loops, soleStep* steps, int32_t count, int32_t capacity )
{
	int32_t first = 0;
	for ( int32_t frame = 1; frame <= finder->frameCount; ++frame )
	{
		bool before = soleLabelAt( finder, frame - 1, leg ) != sole_labelNone;
		bool now = frame < finder->frameCount && soleLabelAt( finder, frame, leg ) != sole_labelNone;
		first = now && before == false ? frame : first;
		if ( before && ( now == false ) )
		{
			soleStep step = soleMakeStep( finder, ( soleLabelRun ){ first, frame - 1 }, leg );
			if ( loops == false || soleBringIntoRound( finder, &step ) )
			{
				if ( count < capacity )
				{
					steps[count] = step;
				}
				++count;
			}
		}
	}
	return count;
}

int32_t soleFindSteps( const soleMotion* motion, const uint8_t* labels, bool loops, const soleAllocator* allocator,
    soleStep* steps, int32_t capacity )
{
	bool usable = soleCheckMotion( motion, "motion", NULL ) == sole_success && labels != NULL &&
	    ( steps != NULL || capacity <= 0 );
	SOLE_ASSERT( usable && "motion needs rig, frames, frame rate and up; labels one byte a frame and leg" );
	if ( usable == false )
	{
		return 0;
	}
	soleStepFinder finder = { .motion = motion,
		.labels = labels,
		.legCount = soleRig_GetLegCount( motion->rig ),
		.frameCount = motion->frameCount,
		.rate = (double)motion->frameRate };
	if ( soleMakeMeasurePose( motion->rig, allocator, &finder.pose ) == false )
	{
		return 0;
	}
	int32_t count = 0;
	for ( int32_t leg = 0; leg < finder.legCount; ++leg )
	{
		count = soleFindLegSteps( &finder, leg, loops, steps, count, capacity );
	}
	soleFreeMeasurePose( allocator, &finder.pose );
	return count;
}
