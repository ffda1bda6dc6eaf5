// SPDX-License-Identifier: MIT
// What a host tells of its clips, by steps that were found in them beforehand: which parts of the feet are down, when
// they come down or leave, and where that will be if the root goes on as it went lately. Character space.
//
// How it went is taken over a fixed time, not from frame to frame, so that every frame rate foresees the same; roots
// and ways between two frames are interpolated.
#include "test.h"

#include "scene_pose.h"
#include "scene_steps.h"

#define LATELY 0.1 // s: a few frames of a slow host, and some ticks of a root that is known less often

/// How a run went a short time before a frame.
typedef struct testPast
{
	soleTransform root; // without the base
	double way;
	double time; // since then, s
} testPast;

/// Since the last jump, or the start, where that is less long ago.
static testPast testFindPast( const testRun* run, int32_t frame )
{
	const soleSceneMoment* moments = run->moments;
	double then = run->times[frame] - LATELY;
	int32_t k = frame;
	while ( k > 0 && run->times[k] > then && moments[k - 1].jumps == moments[frame].jumps )
	{
		--k;
	}
	if ( k == frame || run->times[k] >= then )
	{
		return ( testPast ){ moments[k].root, moments[k].way, run->times[frame] - run->times[k] };
	}
	double share = ( then - run->times[k] ) / ( run->times[k + 1] - run->times[k] );
	const soleSceneMoment* before = moments + k;
	const soleSceneMoment* after = before + 1;
	testPast past = { .root = before->root, .time = LATELY };
	past.root.translation = soleLerp( before->root.translation, after->root.translation, (float)share );
	past.root.rotation = soleNlerp( before->root.rotation, after->root.rotation, (float)share );
	past.way = before->way + share * ( after->way - before->way );
	return past;
}

/// Seconds of the clip a second.
static double testFindClipRate( const testRun* run, int32_t frame, const testPast* past )
{
	const soleSceneMoment* moment = run->moments + frame;
	double stride = testGetStride( run->actor, moment );
	if ( stride <= 0.0 )
	{
		return 1.0; // plays by the clock
	}
	double rounds = ( moment->way - past->way ) / stride;
	return past->time > 0.0 ? rounds * (double)run->actor->clips[moment->gait].duration / past->time : 0.0;
}

/// What the host itself has changed in the clip: strides of another length, and root and pose moved against each other.
static void testAdaptStep( const testRun* run, int32_t frame, double strike, int32_t leg, soleStepInput* input )
{
	const soleSceneMoment* moment = run->moments + frame;
	input->place.z += (float)testGetStrideShift( run->actor, moment, strike, leg );
	input->place = soleSub( input->place, moment->base );
}

bool testReadSteps( const testRun* run, int32_t frame, soleContactInput* contacts, soleStepInput* inputs )
{
	if ( run->act->host.unlabelled )
	{
		return false;
	}
	const testActor* actor = run->actor;
	const soleSceneMoment* moment = run->moments + frame;
	testPast past = testFindPast( run, frame );
	toolPace pace = toolFindPace( &actor->character, past.root, moment->root, past.time );
	double rate = testFindClipRate( run, frame, &past );
	double clipTime = testGetClipTime( actor, moment->gait, moment, run->times[frame] );
	for ( int32_t leg = 0; leg < run->legCount; ++leg )
	{
		soleStepInput* input = inputs + leg;
		if ( toolReadStep( actor->clips + moment->gait, actor->travels + moment->gait, actor->steps + moment->gait,
		         clipTime, rate, leg, contacts + leg, input ) )
		{
			double until = (double)input->until;
			testAdaptStep( run, frame, clipTime + rate * until, leg, input );
			soleVec3 up = soleRig_GetUp( actor->character.rig );
			soleTransform travel = soleExtrapolate( pace.velocity, pace.turnRate, up, input->until );
			// Seen from a root that was moved aside.
			soleVec3 turned = soleRotate( travel.rotation, moment->base );
			travel.translation = soleAdd( travel.translation, soleSub( turned, moment->base ) );
			soleStepInput_Travel( input, travel );
		}
	}
	return true;
}
