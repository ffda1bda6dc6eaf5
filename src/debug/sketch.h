// SPDX-License-Identifier: MIT
// What the drawings of a frame share: the frame after all stages, the joints as placed, and a pen that hands out only
// what is finite and switched on.
//
// Space as in place/place.h: world axes, origin at the frame's root. The pen turns it to world.
#ifndef SOLE_DEBUG_SKETCH_H
#define SOLE_DEBUG_SKETCH_H

#include "place/place.h"
#include "sole/draw.h"

/// A frame that is being drawn.
typedef struct soleSketch
{
	const soleDebugDraw* draw;
	const soleDrawnFrame* drawn;
	const solePlaceWork* work;            // after all stages
	soleTransform placed[SOLE_MAX_SLOTS]; // the rig's evaluated joints with the output applied
	float dot;                            // radius of a small mark
	uint32_t category;                    // what is being drawn now
} soleSketch;

void soleSketchLine( const soleSketch* sketch, soleVec3 from, soleVec3 to, soleDrawColor color );
void soleSketchArrow( const soleSketch* sketch, soleVec3 from, soleVec3 to, soleDrawColor color );
void soleSketchCircle( const soleSketch* sketch, soleVec3 center, soleVec3 normal, float radius, soleDrawColor color );
void soleSketchSphere( const soleSketch* sketch, soleVec3 center, float radius, soleDrawColor color );
void soleSketchText( const soleSketch* sketch, soleVec3 place, const char* text, soleDrawColor color );

/// The drawings, in the order of soleDrawCategory.
void soleSketchAnimated( const soleSketch* sketch );
void soleSketchBones( const soleSketch* sketch );
void soleSketchProbes( const soleSketch* sketch );
void soleSketchHits( const soleSketch* sketch );
void soleSketchSweeps( const soleSketch* sketch );
void soleSketchSoles( const soleSketch* sketch );
void soleSketchPlanes( const soleSketch* sketch );
void soleSketchLocks( const soleSketch* sketch );
void soleSketchReach( const soleSketch* sketch );
void soleSketchPelvis( const soleSketch* sketch );
void soleSketchFootholds( const soleSketch* sketch );
void soleSketchTargets( const soleSketch* sketch );
void soleSketchFlags( const soleSketch* sketch );

#endif
