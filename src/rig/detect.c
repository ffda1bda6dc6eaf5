// SPDX-License-Identifier: MIT
// Finds legs and soles: makes the skeleton ready for looking at, then asks roles, names and structure in this order,
// then works out axes, toes, hinges and soles of whatever legs there are. Character space, bind pose.
#include "base/core.h"
#include "detect_internal.h"
#include "sole/sole.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

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

// ----------------------------------------------------------------------------------------------------------- shared

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

void soleDetect_MarkBelow( soleDetect* detect, int32_t top )
{
	for ( int32_t k = 0; k < detect->jointCount; ++k )
	{
		int32_t joint = detect->order[k];
		int32_t parent = detect->parents[joint];
		detect->ints[joint] = joint == top || ( parent != SOLE_NONE && detect->ints[parent] != 0 ) ? 1 : 0;
	}
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

int32_t soleFoundLeg_GetEnd( const soleFoundLeg* leg )
{
	return leg->toeCount > 0 ? leg->toes[0] : leg->tip;
}

float soleFoundLeg_GetUnit( const soleFoundLeg* leg )
{
	return leg->length / SOLE_HUMAN_LEG;
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
	if ( soleFindPelvis( detect ) == false )
	{
		return sole_invalidDefinition;
	}
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
