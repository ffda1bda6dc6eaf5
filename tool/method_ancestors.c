// SPDX-License-Identifier: MIT
// The systems that Sole is compared with, as methods of a bake.
#include "method_ancestors.h"

#include "baselines/ancestor.h"

typedef struct toolAncestorMemory
{
	soleAncestor ancestor;
	soleProbe probes[SOLE_ANCESTOR_MAX_PROBES];
	soleHit hits[SOLE_ANCESTOR_MAX_PROBES];
	soleOutput output;
} toolAncestorMemory;

static void* toolStartAncestor( const toolCharacter* character, soleAncestorKind kind )
{
	toolAncestorMemory* memory = toolAlloc( 1, sizeof *memory );
	soleStartAncestor( &memory->ancestor, kind, character->rig, character->bindPose );
	return memory;
}

void* toolStartHomebrew( const toolCharacter* character )
{
	return toolStartAncestor( character, sole_ancestorHomebrew );
}

void* toolStartIkSetting( const toolCharacter* character )
{
	return toolStartAncestor( character, sole_ancestorIkSetting );
}

void* toolStartOzz( const toolCharacter* character )
{
	return toolStartAncestor( character, sole_ancestorOzz );
}

void* toolStartEffector( const toolCharacter* character )
{
	return toolStartAncestor( character, sole_ancestorEffector );
}

void toolStepAncestor( void* user, const toolMethodStep* step )
{
	toolAncestorMemory* memory = user;
	const soleRig* rig = step->character->rig;
	int32_t count = soleGatherAncestor( &memory->ancestor, rig, step->frame, memory->probes );
	soleCastProbes( step->ground, memory->probes, count, memory->hits );
	soleSolveAncestor( &memory->ancestor, rig, step->frame, memory->hits, count, &memory->output );
	soleApply( rig, &memory->output, step->pose );
	for ( int32_t i = 0; i < memory->output.legCount; ++i )
	{
		step->flags[i] = memory->output.legs[i].flags;
		step->plantWeights[i] = memory->output.legs[i].plantWeight;
	}
	*step->pelvisOffset = memory->output.pelvisOffset_w;
}
