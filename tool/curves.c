// SPDX-License-Identifier: MIT
// Curves of a bake along time, in the world of the ground. Angles and differences in double precision, as those who
// measure have them:
//   angle of a joint   th = atan2( |a x b|, a . b ) of the bones above and below it
//   its acceleration   ( th(i+1) - 2 th(i) + th(i-1) ) rate^2
#include "curves.h"

#include <math.h>

#define CHAIN_LENGTH ( SOLE_MAX_LEG_JOINTS + 1 )

static const soleTransform* toolGetOutput( const toolBakeResult* result, int32_t frame )
{
	return result->output + (size_t)frame * (size_t)result->jointCount;
}

static soleTransform toolFindJoint(
    const toolCharacter* character, const toolBakeResult* result, int32_t frame, int32_t joint )
{
	const soleTransform* pose = toolGetOutput( result, frame );
	soleTransform world = pose[joint];
	for ( int32_t j = character->parents[joint]; j != SOLE_NONE; j = character->parents[j] )
	{
		world = soleMulTransform( pose[j], world );
	}
	return soleMulTransform( result->walk.roots[frame], world );
}

// ---------------------------------------------------------------------------------------------------------- heights

static float toolFindSoleHeight( const toolCharacter* character, const toolBakeResult* result,
    const soleTerrain* terrain, int32_t leg, int32_t frame )
{
	float reach = 0.5f * soleRig_GetLegLength( character->rig, leg );
	double lowest = (double)NAN;
	int32_t joint = SOLE_NONE;
	soleTransform world = soleTransform_Identity();
	for ( int32_t i = 0; i < character->pointCount; ++i )
	{
		const soleMeasurePoint* point = character->points + i;
		if ( point->leg != leg )
		{
			continue;
		}
		if ( point->joint != joint )
		{
			joint = point->joint;
			world = toolFindJoint( character, result, frame, joint );
		}
		double gap = soleTerrain_GetGap( terrain, soleTransformPoint( world, point->position ), (double)reach );
		lowest = gap < lowest || isnan( lowest ) ? gap : lowest;
	}
	return (float)lowest;
}

void toolMakeHeightCurve( const toolCharacter* character, const toolBakeResult* result, const soleTerrain* terrain,
    int32_t leg, float* heights )
{
	for ( int32_t f = 0; f < result->walk.frameCount; ++f )
	{
		heights[f] = toolFindSoleHeight( character, result, terrain, leg, f );
	}
}

// ----------------------------------------------------------------------------------------------------------- angles

/// Hip to ankle in the world. @return how many places there are
static int32_t toolFindChain( const toolCharacter* character, const toolBakeResult* result, int32_t leg, int32_t frame,
    soleVec3 chain[CHAIN_LENGTH] )
{
	soleLegDef def = soleRig_GetLeg( character->rig, leg );
	int32_t count = def.jointCount;
	soleTransform last = soleTransform_Identity();
	for ( int32_t k = 0; k < count; ++k )
	{
		last = toolFindJoint( character, result, frame, def.joints[k] );
		chain[k] = last.translation;
	}
	if ( def.hasVirtualAnkle )
	{
		soleTransform bind = toolPoseWorld( character, character->bindPose, def.joints[count - 1] );
		chain[count++] = soleTransformPoint( last, soleInvTransformPoint( bind, def.virtualAnkle ) );
	}
	return count;
}

static double toolFindBend( const soleVec3* joint )
{
	double a[3] = { (double)joint[0].x - (double)joint[-1].x, (double)joint[0].y - (double)joint[-1].y,
		(double)joint[0].z - (double)joint[-1].z };
	double b[3] = { (double)joint[1].x - (double)joint[0].x, (double)joint[1].y - (double)joint[0].y,
		(double)joint[1].z - (double)joint[0].z };
	double cross[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
	double across = sqrt( cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2] );
	return atan2( across, a[0] * b[0] + a[1] * b[1] + a[2] * b[2] );
}

void toolMakeBendCurve( const toolCharacter* character, const toolBakeResult* result, int32_t leg, double* angles )
{
	soleVec3 chain[CHAIN_LENGTH];
	for ( int32_t f = 0; f < result->walk.frameCount; ++f )
	{
		int32_t count = toolFindChain( character, result, leg, f, chain );
		angles[f] = 0.0;
		for ( int32_t k = 1; k + 1 < count; ++k )
		{
			angles[f] += toolFindBend( chain + k );
		}
	}
}

void toolMakeAccelerationCurve( const toolWalk* walk, const double* values, double* accelerations )
{
	for ( int32_t f = 0; f < walk->frameCount; ++f )
	{
		bool smooth = f > 0 && f + 1 < walk->frameCount && walk->seams[f] == false && walk->seams[f + 1] == false;
		accelerations[f] =
		    smooth ? ( values[f + 1] - 2.0 * values[f] + values[f - 1] ) * walk->fps * walk->fps : (double)NAN;
	}
}

// ------------------------------------------------------------------------------------------------------------- body

void toolMakePelvisCurve( const toolCharacter* character, const toolBakeResult* result, soleVec3* places )
{
	int32_t pelvis = soleRig_GetPelvis( character->rig );
	for ( int32_t f = 0; f < result->walk.frameCount; ++f )
	{
		places[f] = toolFindJoint( character, result, f, pelvis ).translation;
	}
}

bool toolIsPlanted( const toolBakeResult* result, int32_t leg, int32_t frame )
{
	return ( result->flags[frame * result->legCount + leg] & (uint32_t)sole_legPlanted ) != 0;
}
