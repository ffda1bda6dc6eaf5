// SPDX-License-Identifier: MIT
// Sole points for measuring: the mesh's own vertices near the sole plane, each in the space of the joint that moves it
// most; a grid over the sole for legs without any.
#include "character_internal.h"

#include <stdlib.h>

#define BAND 0.008 // m over the sole plane at a leg of 0.9 m: what is higher is the side of a shoe
#define POINTS_A_LEG 400
#define FEWEST 4

typedef struct toolSoleFrame
{
	soleVec3 ball;
	soleVec3 forward;
	soleVec3 normal;
	float band;
	int32_t foot;
} toolSoleFrame;

static toolSoleFrame toolMakeSoleFrame( const toolCharacter* character, int32_t leg )
{
	const soleLegDef* def = character->rigDef.legs + leg;
	toolSoleFrame frame = { .ball = def->sole.ball };
	frame.forward = soleNormalizeOr( soleSub( def->sole.toe, def->sole.heel ), character->rigDef.forward );
	soleVec3 across = soleSub( def->sole.outer, def->sole.inner );
	frame.normal = soleNormalizeOr( soleCross( frame.forward, across ), character->rigDef.up );
	if ( soleDot( frame.normal, character->rigDef.up ) < 0.0f )
	{
		frame.normal = soleNeg( frame.normal );
	}
	frame.band = (float)( BAND / 0.9 ) * soleRig_GetLegLength( character->rig, leg );
	frame.foot = def->detachedFoot != SOLE_NONE ? def->detachedFoot : def->joints[def->jointCount - 1];
	return frame;
}

static bool toolHangsFrom( const toolCharacter* character, int32_t joint, int32_t ancestor )
{
	for ( int32_t i = joint; i != SOLE_NONE; i = character->parents[i] )
	{
		if ( i == ancestor )
		{
			return true;
		}
	}
	return false;
}

static bool toolIsSolePoint( const toolCharacter* character, const toolSoleFrame* frame, const soleSkinVertex* vertex )
{
	float height = soleDot( soleSub( vertex->position, frame->ball ), frame->normal );
	return vertex->joints[0] != SOLE_NONE && height <= frame->band && height >= -2.0f * frame->band &&
	    toolHangsFrom( character, vertex->joints[0], frame->foot );
}

static int32_t toolAddPoint( toolCharacter* character, int32_t capacity, soleMeasurePoint point )
{
	if ( character->pointCount == capacity )
	{
		capacity = capacity * 2 + 64;
		character->points = toolGrow( character->points, (size_t)capacity, sizeof( soleMeasurePoint ) );
	}
	character->points[character->pointCount++] = point;
	return capacity;
}

static int32_t toolAddMeshPoints( toolCharacter* character, int32_t leg, int32_t capacity, int32_t* added )
{
	toolSoleFrame frame = toolMakeSoleFrame( character, leg );
	int32_t count = 0;
	for ( int32_t i = 0; i < character->skinCount; ++i )
	{
		count += toolIsSolePoint( character, &frame, character->skin + i ) ? 1 : 0;
	}
	*added = 0;
	int32_t step = count / POINTS_A_LEG + 1;
	int32_t seen = 0;
	for ( int32_t i = 0; i < character->skinCount && count >= FEWEST; ++i )
	{
		const soleSkinVertex* vertex = character->skin + i;
		if ( toolIsSolePoint( character, &frame, vertex ) == false || seen++ % step != 0 )
		{
			continue;
		}
		soleMeasurePoint point = { .leg = leg, .joint = vertex->joints[0] };
		soleTransform world = toolPoseWorld( character, character->bindPose, point.joint );
		point.position = soleInvTransformPoint( world, vertex->position );
		point.fore = soleDot( soleSub( vertex->position, frame.ball ), frame.forward ) > 0.0f;
		capacity = toolAddPoint( character, capacity, point );
		*added += 1;
	}
	return capacity;
}

static int32_t toolAddGridPoints( toolCharacter* character, int32_t leg, int32_t capacity )
{
	int32_t count = soleMakeMeasurePoints( character->rig, NULL, 0 );
	soleMeasurePoint* grid = toolAlloc( (size_t)count, sizeof( soleMeasurePoint ) );
	count = soleMakeMeasurePoints( character->rig, grid, count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( grid[i].leg == leg )
		{
			capacity = toolAddPoint( character, capacity, grid[i] );
		}
	}
	free( grid );
	return capacity;
}

void toolCollectPoints( toolCharacter* character )
{
	int32_t capacity = 0;
	for ( int32_t leg = 0; leg < character->rigDef.legCount; ++leg )
	{
		int32_t added = 0;
		capacity = toolAddMeshPoints( character, leg, capacity, &added );
		if ( added == 0 )
		{
			capacity = toolAddGridPoints( character, leg, capacity );
		}
	}
}
