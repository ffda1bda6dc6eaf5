// SPDX-License-Identifier: MIT
// What the gates are measured with: poses of this frame and the last, and what goes on from frame to frame. World
// space, metres.
#ifndef TEST_SCENE_METER_H
#define TEST_SCENE_METER_H

#include "scene_gates.h"

#define MOST_JOINTS 128
#define MOST_POINTS 256

/// Points of a sole that may be held.
enum
{
	test_heel,
	test_ball,
	test_toe,
	test_solePoints
};

/// One leg in one frame.
typedef struct testLegPose
{
	soleVec3 hip;
	soleVec3 knee;
	soleTransform foot;
	soleVec3 sole[test_solePoints];
	soleVec3 hinge; // of the knee
} testLegPose;

typedef struct testBodyPose
{
	soleTransform joints[MOST_JOINTS];
	soleTransform pelvis;
	testLegPose legs[2];
} testBodyPose;

typedef struct testKnee
{
	double bend; // degrees, below zero: the wrong way
	soleVec3 normal;
	double reach; // share of the bones
} testKnee;

testKnee testFindKnee( const testLegPose* leg );

/// @param poses input or output of the run
void testFindBody( const testRun* run, int32_t frame, const soleTransform* poses, testBodyPose* body );

typedef struct testStance
{
	bool running;
	int32_t piece; // whose frame the foot is held in
	soleVec3 drift;
} testStance;

typedef struct testRest
{
	bool running;
	double since;
	soleVec3 low;
	soleVec3 high;
	soleQuat first;
} testRest;

typedef struct testMeter
{
	const testRun* run;
	testGates* gates;
	const soleRig* rig; // that points are of
	soleMeasurePoint points[MOST_POINTS];
	int32_t pointCount;
	testBodyPose in[2]; // of the last frame and this one
	testBodyPose out[2];
	testStance stances[2];
	testRest rests[2];
	double kneeRates[2]; // fastest of input and output
} testMeter;

static inline void testRaise( const testMeter* meter, int32_t frame, int32_t leg, double value, testWorst* worst )
{
	if ( value > worst->value )
	{
		*worst = ( testWorst ){ value, meter->run->times[frame], meter->run->take, leg };
	}
}

static inline uint32_t testGetFlags( const testMeter* meter, int32_t frame, int32_t leg )
{
	return meter->run->flags[frame * meter->run->legCount + leg];
}

/// How the sole of a leg lies on the ground, and whether it stays there: G1 to G3, overhang, what is not reported.
void testMeasureSole( testMeter* meter, int32_t frame, int32_t leg );

#endif
