// SPDX-License-Identifier: MIT
// Shows a frame of one of the four systems through the callbacks, categories and colours of sole/draw.h: what it asked
// of the ground, what it was told, and what it made of that. Planes, locks and footholds that a system does not have
// are not drawn.
#ifndef SOLE_BASELINES_ANCESTOR_DRAW_H
#define SOLE_BASELINES_ANCESTOR_DRAW_H

#include "sole/draw.h"
#include "sole/sole.h"

/// A frame as it went through soleGatherAncestor() and soleSolveAncestor().
typedef struct soleDrawnAncestor
{
	const soleRig* rig;
	const soleFrame* frame;
	const soleTransform* placed; // the frame's pose with the output applied
	const soleProbe* probes;
	const soleHit* hits;
	int32_t probeCount;
	const soleOutput* output;
} soleDrawnAncestor;

void soleDrawAncestor( const soleDebugDraw* draw, const soleDrawnAncestor* drawn );

#endif
