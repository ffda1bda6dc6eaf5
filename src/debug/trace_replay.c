// SPDX-License-Identifier: MIT
// Plays a trace through gather and solve and compares what comes out with what came out then, bit by bit. The states of
// the replay are its own but where the trace brings one.
#include "base/core.h"
#include "debug/trace_internal.h"

#include <string.h>

typedef struct soleReplay
{
	soleState state;
	soleOutput output;
	soleProbe probes[SOLE_MAX_PROBES];
} soleReplay;

/// The first word of two structs that differs.
static bool soleFindDifferentField( const soleTraceTable* table, const void* recorded, const void* replayed,
    int32_t leg, soleTraceDifference* difference )
{
	for ( int32_t i = 0; i < table->count; ++i )
	{
		const soleTraceField* field = table->fields + i;
		for ( int32_t k = 0; k < field->count; ++k )
		{
			uint32_t a;
			uint32_t b;
			memcpy( &a, (const char*)recorded + field->offset + 4 * k, 4 );
			memcpy( &b, (const char*)replayed + field->offset + 4 * k, 4 );
			if ( a != b )
			{
				*difference = ( soleTraceDifference ){ .leg = leg,
					.field = field->name,
					.component = k,
					.isFloat = field->kind == sole_fieldFloats,
					.recorded = a,
					.replayed = b };
				return true;
			}
		}
	}
	return false;
}

static bool soleFindDifference(
    const soleTraceStep* step, const soleReplay* replay, int32_t probeCount, soleTraceDifference* difference )
{
	uint32_t checksum = soleGetProbeChecksum( replay->probes, probeCount );
	if ( probeCount != step->probeCount || checksum != step->probeChecksum )
	{
		bool fewer = probeCount != step->probeCount;
		*difference = ( soleTraceDifference ){ .leg = SOLE_NONE,
			.field = "probes",
			.recorded = fewer ? (uint32_t)step->probeCount : step->probeChecksum,
			.replayed = fewer ? (uint32_t)probeCount : checksum };
		return true;
	}
	if ( soleFindDifferentField( &soleTraceOutputTable, step->output, &replay->output, SOLE_NONE, difference ) )
	{
		return true;
	}
	for ( int32_t i = 0; i < replay->output.legCount; ++i )
	{
		if ( soleFindDifferentField(
		         &soleTraceLegOutputTable, step->output->legs + i, replay->output.legs + i, i, difference ) )
		{
			return true;
		}
	}
	return false;
}

static void soleReplayStep( const soleRig* rig, const soleTraceStep* step, soleReplay* replay, soleTraceReport* report )
{
	if ( step->state != NULL )
	{
		replay->state = *step->state;
	}
	int32_t probeCount =
	    soleGatherProbes( rig, step->settings, &replay->state, step->frame, replay->probes, SOLE_MAX_PROBES );
	soleSolve( rig, step->settings, &replay->state, step->frame, step->hits, step->hitCount, &replay->output );
	report->frameCount = step->index + 1;
	soleTraceDifference difference;
	if ( soleFindDifference( step, replay, probeCount, &difference ) )
	{
		difference.frame = step->index;
		report->first = report->differentFrames == 0 ? difference : report->first;
		report->differentFrames += 1;
	}
}

static void soleDescribeRig( const soleTracePlayer* player, soleTraceReport* report )
{
	const soleRig* rig = soleTracePlayer_GetRig( player );
	report->version = soleTracePlayer_GetVersion( player );
	report->legCount = soleRig_GetLegCount( rig );
	for ( int32_t i = 0; i < report->legCount; ++i )
	{
		strncpy( report->legNames[i], soleRig_GetLeg( rig, i ).name, sizeof report->legNames[i] - 1 );
	}
}

soleResult soleReplayTrace(
    const void* bytes, size_t byteCount, const soleAllocator* allocator, soleTraceReport* report, soleMessage* message )
{
	memset( report, 0, sizeof *report );
	report->first = ( soleTraceDifference ){ .frame = SOLE_NONE, .leg = SOLE_NONE, .field = "" };
	soleTracePlayer* player;
	soleResult result = soleOpenTrace( bytes, byteCount, allocator, &player, message );
	if ( result != sole_success )
	{
		return result;
	}
	soleReplay* replay = soleAlloc( allocator, sizeof *replay );
	if ( replay == NULL )
	{
		soleCloseTrace( player );
		soleSetMessage( message, "out of memory: %zu bytes were asked for", sizeof *replay );
		return sole_outOfMemory;
	}
	soleDescribeRig( player, report );
	const soleTraceStep* step;
	result = soleTracePlayer_Next( player, &step, message );
	while ( result == sole_success && step != NULL )
	{
		soleReplayStep( soleTracePlayer_GetRig( player ), step, replay, report );
		result = soleTracePlayer_Next( player, &step, message );
	}
	soleFree( allocator, replay, sizeof *replay );
	soleCloseTrace( player );
	return result;
}
