// SPDX-License-Identifier: MIT
// Makes a skeleton ready for looking at: checked, ordered, placed in character space, its skin sorted by the joint that
// moves each vertex most. Refuses what can't be worked with.
#include "base/core.h"
#include "detect_internal.h"

#include <string.h>

#define JOINT_LIMIT 65535
#define VERTEX_LIMIT 100000000
#define DEPTH_LIMIT 1000 // joints one above the other; a rig takes no more

/// Parents before children, each joint once. False where parents run in a circle.
bool soleOrderJoints( soleDetect* detect )
{
	int32_t count = detect->jointCount;
	int32_t* depth = detect->ints;
	int32_t deepest = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		depth[i] = -1;
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		int32_t steps = 0;
		int32_t top = i;
		while ( top != SOLE_NONE && depth[top] < 0 )
		{
			top = detect->parents[top];
			steps += 1;
			if ( steps > count )
			{
				soleAddFinding( detect, sole_error, SOLE_NONE, i,
				    "mend the hierarchy: each joint has one parent above it", "is its own ancestor" );
				return false;
			}
		}
		int32_t level = ( top == SOLE_NONE ? -1 : depth[top] ) + steps;
		deepest = level > deepest ? level : deepest;
		for ( int32_t j = i; j != top; j = detect->parents[j] )
		{
			depth[j] = level;
			level -= 1;
		}
	}
	if ( deepest >= DEPTH_LIMIT )
	{
		soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE, "leave out joints that are no part of the body",
		    "joints hang %d deep from each other; no more than %d can be used", (int)deepest + 1, DEPTH_LIMIT );
		return false;
	}
	// A counting sort by depth: order[] holds the levels' starts for a moment.
	int32_t* starts = detect->childCount;
	for ( int32_t i = 0; i < count; ++i )
	{
		starts[i] = 0;
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( depth[i] < deepest )
		{
			starts[depth[i] + 1] += 1;
		}
	}
	for ( int32_t i = 1; i <= deepest; ++i )
	{
		starts[i] += starts[i - 1];
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		detect->order[starts[depth[i]]++] = i;
	}
	return true;
}

bool solePlaceJoints( soleDetect* detect )
{
	soleVec3 low = soleVec( 1e30f, 1e30f, 1e30f );
	soleVec3 high = soleNeg( low );
	soleVec3* scales = (soleVec3*)(void*)detect->floats;
	for ( int32_t k = 0; k < detect->jointCount; ++k )
	{
		int32_t joint = detect->order[k];
		soleTransform world = detect->skeleton->bindPose[joint];
		bool finite = soleVec3_IsFinite( world.translation ) && soleQuat_IsFinite( world.rotation ) &&
		    soleVec3_IsFinite( world.scale );
		world.rotation = soleNormalizeQuat( world.rotation );
		int32_t parent = detect->parents[joint];
		if ( parent != SOLE_NONE )
		{
			soleTransform above = { detect->position[parent], detect->rotation[parent], scales[parent] };
			world = soleMulTransform( above, world );
		}
		finite = finite && soleLength( world.translation ) < 1e15f && soleLength( world.scale ) < 1e15f;
		if ( finite == false )
		{
			soleAddFinding( detect, sole_error, SOLE_NONE, joint, "export the character again with a sound bind pose",
			    "has a bind transform that is not finite or absurdly large" );
			return false;
		}
		detect->position[joint] = world.translation;
		detect->rotation[joint] = soleNormalizeQuat( world.rotation );
		scales[joint] = world.scale;
		soleVec3 p = world.translation;
		low = soleVec( soleMinF( low.x, p.x ), soleMinF( low.y, p.y ), soleMinF( low.z, p.z ) );
		high = soleVec( soleMaxF( high.x, p.x ), soleMaxF( high.y, p.y ), soleMaxF( high.z, p.z ) );
	}
	soleVec3 extent = soleSub( high, low );
	detect->size = soleMaxF( extent.x, soleMaxF( extent.y, extent.z ) );
	if ( !( detect->size > 1e-12f ) )
	{
		soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE,
		    "export the character with its bones, not only with their names", "all %d joints are at one place",
		    (int)detect->jointCount );
		return false;
	}
	return true;
}

void soleCountChildren( soleDetect* detect )
{
	memset( detect->childCount, 0, (size_t)detect->jointCount * sizeof( int32_t ) );
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		if ( detect->parents[i] != SOLE_NONE )
		{
			detect->childCount[detect->parents[i]] += 1;
		}
	}
}

/// The joint that moves a vertex most, or SOLE_NONE where the vertex can't be used.
static int32_t soleFindDominant( const soleDetect* detect, const soleSkinVertex* vertex )
{
	int32_t best = SOLE_NONE;
	float bestWeight = 0.0f;
	for ( int32_t i = 0; i < 4; ++i )
	{
		int32_t joint = vertex->joints[i];
		if ( joint >= 0 && joint < detect->jointCount && vertex->weights[i] > bestWeight )
		{
			best = joint;
			bestWeight = vertex->weights[i];
		}
	}
	return soleLength( vertex->position ) < 1e15f ? best : SOLE_NONE;
}

void soleSortSkin( soleDetect* detect )
{
	int32_t unusable = 0;
	for ( int32_t i = 0; i < detect->skeleton->skinCount; ++i )
	{
		int32_t joint = soleFindDominant( detect, detect->skeleton->skin + i );
		detect->dominant[i] = joint;
		if ( joint == SOLE_NONE )
		{
			unusable += 1;
		}
		else
		{
			detect->skinnedCount[joint] += 1;
		}
	}
	if ( unusable > 0 )
	{
		soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "check the mesh's weights",
		    "%d of %d vertices have no usable weight or place; they are left out", (int)unusable,
		    (int)detect->skeleton->skinCount );
	}
}

bool soleCheckSkeleton( soleDetect* detect )
{
	const soleSkeleton* skeleton = detect->skeleton;
	if ( skeleton->jointCount < 1 || skeleton->jointCount > JOINT_LIMIT || skeleton->parents == NULL ||
	    skeleton->bindPose == NULL )
	{
		soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE, "give 1 to 65535 joints with parents and a bind pose",
		    "there are %d joints", (int)skeleton->jointCount );
		return false;
	}
	for ( int32_t i = 0; i < skeleton->jointCount; ++i )
	{
		int32_t parent = skeleton->parents[i];
		if ( parent < SOLE_NONE || parent >= skeleton->jointCount )
		{
			detect->jointCount = 0; // no name may be looked up yet
			soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE, "use SOLE_NONE for a joint without parent",
			    "joint %d has parent %d, which does not exist", (int)i, (int)parent );
			return false;
		}
	}
	return true;
}

bool soleAllocateDetect( soleDetect* detect )
{
	size_t n = (size_t)detect->jointCount;
	size_t perJoint =
	    4 * sizeof( int32_t ) + sizeof( soleVec3 ) + sizeof( soleQuat ) + sizeof( soleJointName ) + 3 * sizeof( float );
	detect->memoryBytes = n * perJoint;
	detect->memory = soleAlloc( NULL, detect->memoryBytes );
	if ( detect->memory == NULL )
	{
		return false;
	}
	detect->rotation = (soleQuat*)detect->memory;
	detect->position = (soleVec3*)(void*)( detect->rotation + n );
	detect->floats = (float*)(void*)( detect->position + n );
	detect->names = (soleJointName*)(void*)( detect->floats + 3 * n );
	detect->order = (int32_t*)(void*)( detect->names + n );
	detect->childCount = detect->order + n;
	detect->skinnedCount = detect->childCount + n;
	detect->ints = detect->skinnedCount + n;
	if ( detect->skeleton->skin != NULL && detect->skeleton->skinCount > 0 &&
	    detect->skeleton->skinCount <= VERTEX_LIMIT )
	{
		size_t vertices = (size_t)detect->skeleton->skinCount;
		detect->skinMemoryBytes = vertices * ( sizeof( int32_t ) + 3 * sizeof( float ) );
		detect->skinMemory = soleAlloc( NULL, detect->skinMemoryBytes );
		if ( detect->skinMemory == NULL )
		{
			soleFree( NULL, detect->memory, detect->memoryBytes );
			return false;
		}
		detect->vertexFloats = (float*)detect->skinMemory;
		detect->dominant = (int32_t*)(void*)( detect->vertexFloats + 3 * vertices );
	}
	return true;
}
