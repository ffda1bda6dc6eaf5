// SPDX-License-Identifier: MIT
// Finds legs and soles: makes the skeleton ready for looking at, then asks roles, names and structure in this order,
// then works out axes, toes, hinges and soles of whatever legs there are. Character space, bind pose.
#include "base/core.h"
#include "detect_internal.h"
#include "sole/sole.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define JOINT_LIMIT 65535
#define VERTEX_LIMIT 100000000
#define DEPTH_LIMIT 1000 // joints one above the other; a rig takes no more

// ---------------------------------------------------------------------------------------------------------- report

soleJointLabel soleLabelJoint( const soleDetect* detect, int32_t joint )
{
	soleJointLabel label = { { 0 } };
	if ( joint < 0 || joint >= detect->jointCount )
	{
		snprintf( label.text, sizeof label.text, "no joint" );
		return label;
	}
	const char* const* names = detect->skeleton->names;
	if ( names == NULL || names[joint] == NULL || names[joint][0] == 0 )
	{
		snprintf( label.text, sizeof label.text, "joint %d", (int)joint );
		return label;
	}
	snprintf( label.text, sizeof label.text, "%.47s", names[joint] );
	return label;
}

const char* soleNameLeg( const soleDetect* detect, int32_t leg )
{
	static const char* const plain[] = { "center", "left", "right" };
	static const char* const numbered[][8] = {
		{ "center 1", "center 2", "center 3", "center 4", "center 5", "center 6", "center 7", "center 8" },
		{ "left 1", "left 2", "left 3", "left 4", "left 5", "left 6", "left 7", "left 8" },
		{ "right 1", "right 2", "right 3", "right 4", "right 5", "right 6", "right 7", "right 8" },
	};
	static const char* const quad[][2] = { { "front", "hind" }, { "front left", "hind left" },
		{ "front right", "hind right" } };
	int32_t side = (int32_t)detect->legs[leg].side;
	int32_t count = 0;
	int32_t before = 0;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		if ( (int32_t)detect->legs[i].side == side )
		{
			before += i < leg ? 1 : 0;
			count += 1;
		}
	}
	if ( count <= 1 )
	{
		return plain[side];
	}
	return count == 2 ? quad[side][before] : numbered[side][before < 8 ? before : 7];
}

void soleAddFinding(
    soleDetect* detect, soleSeverity severity, int32_t leg, int32_t joint, const char* mend, const char* format, ... )
{
	soleDetectReport* report = detect->report;
	if ( report == NULL )
	{
		return;
	}
	if ( report->findingCount >= SOLE_MAX_FINDINGS )
	{
		report->truncated = true;
		return;
	}
	soleFinding* finding = report->findings + report->findingCount;
	*finding = ( soleFinding ){ 0 };
	report->findingCount += 1;
	finding->severity = severity;
	finding->leg = leg;
	finding->joint = joint;
	if ( leg != SOLE_NONE )
	{
		snprintf( finding->where, sizeof finding->where, "leg %s", soleNameLeg( detect, leg ) );
	}
	else if ( joint != SOLE_NONE )
	{
		snprintf( finding->where, sizeof finding->where, "joint %s", soleLabelJoint( detect, joint ).text );
	}
	else
	{
		snprintf( finding->where, sizeof finding->where, "skeleton" );
	}
	va_list arguments;
	va_start( arguments, format );
	vsnprintf( finding->what, sizeof finding->what, format, arguments );
	va_end( arguments );
	snprintf( finding->mend, sizeof finding->mend, "%s", mend );
}

// ----------------------------------------------------------------------------------------------------------- ready

bool soleDetect_IsBelow( const soleDetect* detect, int32_t joint, int32_t ancestor )
{
	for ( int32_t i = 0; joint != SOLE_NONE && i <= detect->jointCount; ++i )
	{
		if ( joint == ancestor )
		{
			return true;
		}
		joint = detect->parents[joint];
	}
	return false;
}

soleFoundLeg soleEmptyLeg( void )
{
	soleFoundLeg leg = { 0 };
	leg.tip = SOLE_NONE;
	leg.detachedFoot = SOLE_NONE;
	leg.partner = SOLE_NONE;
	return leg;
}

int32_t soleFoundLeg_GetFoot( const soleFoundLeg* leg )
{
	return leg->detachedFoot != SOLE_NONE ? leg->detachedFoot : leg->joints[leg->jointCount - 1];
}

void soleFoundLeg_Measure( const soleDetect* detect, soleFoundLeg* leg )
{
	leg->length = 0.0f;
	if ( leg->hasVirtualAnkle == false )
	{
		leg->ankle = detect->position[leg->joints[leg->jointCount - 1]];
	}
	for ( int32_t i = 1; i < leg->jointCount; ++i )
	{
		leg->length += soleDistance( detect->position[leg->joints[i - 1]], detect->position[leg->joints[i]] );
	}
	if ( leg->hasVirtualAnkle )
	{
		leg->length += soleDistance( detect->position[leg->joints[leg->jointCount - 1]], leg->ankle );
	}
}

/// Parents before children, each joint once. False where parents run in a circle.
static bool soleOrderJoints( soleDetect* detect )
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

static bool solePlaceJoints( soleDetect* detect )
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

static void soleCountChildren( soleDetect* detect )
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

static void soleSortSkin( soleDetect* detect )
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

static bool soleCheckSkeleton( soleDetect* detect )
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

static bool soleAllocateDetect( soleDetect* detect )
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

// ------------------------------------------------------------------------------------------------------ the result

static void soleFillLeg( soleDetect* detect, int32_t index, soleLegDef* def )
{
	soleFoundLeg* leg = detect->legs + index;
	def->name = soleNameLeg( detect, index );
	def->side = leg->side;
	memcpy( def->joints, leg->joints, sizeof def->joints );
	def->jointCount = leg->jointCount;
	def->hasVirtualAnkle = leg->hasVirtualAnkle;
	def->virtualAnkle = leg->hasVirtualAnkle ? leg->ankle : soleVec( 0.0f, 0.0f, 0.0f );
	def->detachedFoot = leg->detachedFoot;
	memcpy( def->toes, leg->toes, sizeof def->toes );
	def->toeCount = leg->toeCount;
	def->hinge = soleFindHinge( detect, index );
	def->sole = soleFindSole( detect, index );
}

static void soleFillScale( soleDetect* detect )
{
	float longest = 0.0f;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		longest = soleMaxF( longest, detect->legs[i].length );
	}
	if ( detect->report == NULL )
	{
		return;
	}
	detect->report->legLength = longest;
	bool believable = longest >= 0.1f && longest <= 5.0f;
	detect->report->suggestedScale = believable ? 1.0f : SOLE_HUMAN_LEG / longest;
	if ( believable == false )
	{
		soleAddFinding( detect, sole_warning, SOLE_NONE, SOLE_NONE, "scale the character by the suggested factor",
		    "legs are %.4g units long: the file is hardly in metres; %.4g would make them %.1f m", (double)longest,
		    (double)detect->report->suggestedScale, (double)SOLE_HUMAN_LEG );
	}
}

static void soleFillRig( soleDetect* detect, soleRigDef* def )
{
	const soleSkeleton* skeleton = detect->skeleton;
	def->jointCount = skeleton->jointCount;
	def->parents = skeleton->parents;
	def->bindPose = skeleton->bindPose;
	def->names = skeleton->names;
	def->pelvis = detect->pelvis;
	def->up = detect->up;
	def->forward = detect->forward;
	def->legCount = detect->legCount;
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		def->legs[i] = soleDefaultLegDef();
		soleFillLeg( detect, i, def->legs + i );
	}
	soleFillScale( detect );
}

static soleResult soleRunDetect( soleDetect* detect, soleRigDef* def )
{
	if ( soleOrderJoints( detect ) == false || solePlaceJoints( detect ) == false )
	{
		return sole_invalidDefinition;
	}
	soleCountChildren( detect );
	if ( detect->dominant != NULL )
	{
		soleSortSkin( detect );
	}
	soleParseNames( detect );
	soleFindLegsByRoles( detect );
	if ( detect->legCount < 2 )
	{
		detect->legCount = 0;
		soleFindLegsByNames( detect );
	}
	detect->byNames = detect->legCount > 0;
	if ( detect->legCount < 2 )
	{
		soleFindLegsByStructure( detect );
	}
	if ( detect->legCount == 0 )
	{
		soleAddFinding( detect, sole_error, SOLE_NONE, SOLE_NONE, "name the legs in a rig definition by hand",
		    "no legs found: looked for joints named as thigh, shin and foot (Mixamo, Unreal, Rigify, VRM, Biped, BVH) and "
		    "for pairs of chains that reach the floor" );
		return sole_notFound;
	}
	soleFindUp( detect );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		soleFindVirtualAnkle( detect, i );
		soleFindToes( detect, i );
	}
	soleFindForward( detect );
	soleFindPelvis( detect );
	soleFindStanding( detect );
	soleCheckLegs( detect );
	soleFillRig( detect, def );
	return sole_success;
}

soleResult soleDetectRig( const soleSkeleton* skeleton, soleRigDef* def, soleDetectReport* report )
{
	SOLE_ASSERT( skeleton != NULL && def != NULL );
	if ( report != NULL )
	{
		*report = ( soleDetectReport ){ 0 };
		report->suggestedScale = 1.0f;
	}
	if ( skeleton == NULL || def == NULL )
	{
		return sole_invalidDefinition;
	}
	soleDetect detect = { 0 };
	detect.skeleton = skeleton;
	detect.report = report;
	detect.jointCount = skeleton->jointCount;
	detect.parents = skeleton->parents;
	detect.pelvis = SOLE_NONE;
	if ( soleCheckSkeleton( &detect ) == false )
	{
		return sole_invalidDefinition;
	}
	if ( soleAllocateDetect( &detect ) == false )
	{
		return sole_outOfMemory;
	}
	soleResult result = soleRunDetect( &detect, def );
	soleFree( NULL, detect.skinMemory, detect.skinMemoryBytes );
	soleFree( NULL, detect.memory, detect.memoryBytes );
	return result;
}
