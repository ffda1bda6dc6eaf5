// SPDX-License-Identifier: MIT
// A dense grid of points under a foot, from its five sole points. Character space of the bind pose, then carried into
// the joint that moves each point. Rows run from heel over ball to toe tip; the outer two follow the foot's outline,
// full width on the ball line and narrower at heel and toe tip, as feet are.
#include "base/core.h"
#include "sole/measure.h"
#include "sole/sole.h"

#define SPACING 0.00555f  // furthest apart along the foot, as a share of leg length: 5 mm of 0.9 m
#define HEEL_WIDTH 0.7f   // of the width on the ball line
#define TOE_WIDTH 0.5f    // of the same
#define MOST_SEGMENTS 400 // along either part, for soles that have nothing to do with their leg

typedef struct solePointWriter
{
	const soleRig* rig;
	int32_t leg;
	soleMeasurePoint* points;
	int32_t capacity;
	int32_t count;
} solePointWriter;

/// One row across: middle, inner edge, outer edge.
static void soleWriteRow( solePointWriter* writer, soleVec3 middle, float width, bool fore )
{
	soleSolePoints sole = soleRig_GetLeg( writer->rig, writer->leg ).sole;
	soleVec3 edges[3] = { soleVec( 0.0f, 0.0f, 0.0f ), soleSub( sole.inner, sole.ball ),
		soleSub( sole.outer, sole.ball ) };
	for ( int32_t k = 0; k < 3; ++k )
	{
		if ( writer->count < writer->capacity )
		{
			soleVec3 p = soleMulAdd( middle, width, edges[k] );
			soleMeasurePoint* point = writer->points + writer->count;
			point->leg = writer->leg;
			point->joint = soleRig_GetFootJoint( writer->rig, writer->leg, fore );
			point->position = soleRig_ToFootSpace( writer->rig, writer->leg, p, fore );
			point->fore = fore;
		}
		writer->count += 1;
	}
}

static int32_t soleCountSegments( soleVec3 a, soleVec3 b, float spacing )
{
	float segments = spacing > 0.0f ? soleDistance( a, b ) / spacing : 0.0f;
	int32_t count = segments < (float)MOST_SEGMENTS ? (int32_t)segments : MOST_SEGMENTS - 1;
	return count + 1;
}

int32_t soleMakeMeasurePoints( const soleRig* rig, soleMeasurePoint* points, int32_t capacity )
{
	SOLE_ASSERT( rig != NULL && "rig: make one with soleCreateRig()" );
	if ( rig == NULL )
	{
		return 0;
	}
	solePointWriter writer = { .rig = rig, .points = points, .capacity = points != NULL ? capacity : 0 };
	for ( writer.leg = 0; writer.leg < soleRig_GetLegCount( rig ); ++writer.leg )
	{
		soleSolePoints sole = soleRig_GetLeg( rig, writer.leg ).sole;
		float spacing = SPACING * soleRig_GetLegLength( rig, writer.leg );
		int32_t hind = soleCountSegments( sole.heel, sole.ball, spacing );
		for ( int32_t i = 0; i < hind; ++i )
		{
			float t = (float)i / (float)hind;
			soleWriteRow( &writer, soleLerp( sole.heel, sole.ball, t ), HEEL_WIDTH + t * ( 1.0f - HEEL_WIDTH ), false );
		}
		// The ball line itself bends with the toes: it is what stays down while the heel is raised.
		int32_t front = soleCountSegments( sole.ball, sole.toe, spacing );
		for ( int32_t i = 0; i <= front; ++i )
		{
			float t = (float)i / (float)front;
			soleWriteRow( &writer, soleLerp( sole.ball, sole.toe, t ), 1.0f + t * ( TOE_WIDTH - 1.0f ), true );
		}
	}
	return writer.count;
}
