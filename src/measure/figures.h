// SPDX-License-Identifier: MIT
// What the parts of measuring share: the motion's points over time, and samples of every figure.
#ifndef SOLE_MEASURE_FIGURES_H
#define SOLE_MEASURE_FIGURES_H

#include "measure/pose.h"

/// Figures of which all samples are kept, for percentiles. At most one sample a leg and frame.
typedef enum soleSampleKind
{
	sole_samplePenetration,
	sole_sampleVertical,
	sole_sampleHover,
	sole_sampleDrift,
	sole_sampleClearance,
	sole_sampleKindCount
} soleSampleKind;

/// Figures of which a sum is enough.
typedef struct soleSums
{
	double share;
	double slide;
	int32_t slidePairs;
	double kneeSquares;
	int32_t kneeCount;
} soleSums;

/// What is known of one leg in one frame. World.
typedef struct soleLegFrame
{
	soleVec3d heel;
	soleVec3d ball;
	soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1]; // hip to ankle
	double leastGap;                          // over all points of the sole; HUGE_VAL where there is no ground
} soleLegFrame;

typedef struct soleMeasurement
{
	const soleMeasureDef* def;
	const soleAllocator* allocator;
	const soleRig* rig;
	int32_t frameCount;
	int32_t legCount;
	int32_t jointCount;
	double rate;
	soleVec3d up;
	double reach[SOLE_MAX_LEGS];        // how far over a point its ground is looked for
	int32_t chainCounts[SOLE_MAX_LEGS]; // joints of soleLegFrame.chain
	soleMeasurePose pose;
	soleLegFrame* frames; // frame, leg
	double* pelvis;       // heights, a frame each
	double* offsets;      // of the pelvis from the reference's, a frame each; 0 without one
	uint8_t* stretched;   // frame, leg: the reference's leg is over-extended
	double* samples;      // kind, leg, frame
	double* pooled;       // scratch, leg and frame
	int32_t counts[sole_sampleKindCount][SOLE_MAX_LEGS];
	soleSums sums[SOLE_MAX_LEGS];
	soleFigures* figures;
} soleMeasurement;

static inline soleLegFrame* soleGetLegFrame( const soleMeasurement* m, int32_t frame, int32_t leg )
{
	return m->frames + (size_t)frame * (size_t)m->legCount + (size_t)leg;
}

static inline uint32_t soleGetLabel( const soleMeasurement* m, int32_t frame, int32_t leg )
{
	return m->def->labels[(size_t)frame * (size_t)m->legCount + (size_t)leg];
}

static inline void soleAddSample( soleMeasurement* m, soleSampleKind kind, int32_t leg, double value )
{
	int32_t slot = m->counts[kind][leg]++;
	size_t row = (size_t)kind * (size_t)m->legCount + (size_t)leg;
	m->samples[row * (size_t)m->frameCount + (size_t)slot] = value;
}

/// Is everything there that measuring needs?
soleResult soleCheckMeasureDef( const soleMeasureDef* def, soleMessage* message );
/// How far over a point of a leg's sole its ground is looked for, m.
double soleFindReach( const soleMotion* motion, int32_t leg );

/// Does the motion go on from a frame to one that is some steps later?
static inline bool soleIsSmooth( const soleMeasureDef* def, int32_t frame, int32_t steps )
{
	for ( int32_t k = 1; k <= steps && def->seams != NULL; ++k )
	{
		if ( def->seams[frame + k] )
		{
			return false;
		}
	}
	return true;
}

/// Bones measured in the pose itself: is the leg straighter than it may be?
bool soleIsStretched( const soleVec3d* chain, int32_t count );

/// Penetration, hover and contact share of one leg in one frame, whose pose is evaluated.
void soleMeasureSole( soleMeasurement* m, int32_t frame, int32_t leg );
/// Slide, drift and clearance of one leg over all frames.
void soleMeasureSteps( soleMeasurement* m, int32_t leg );
/// Knee acceleration, over-extension and jumps of one leg over all frames.
void soleMeasureLeg( soleMeasurement* m, int32_t leg );
/// Pelvis and deviation from the reference.
void soleMeasureBody( soleMeasurement* m );

#endif
