// SPDX-License-Identifier: MIT
// Opens a trace that may come from anyone: reads its head and makes its rig. A count is believed only as far as the
// bytes that are there bear it out.
#include "base/core.h"
#include "debug/trace_player.h"

#include <string.h>

#define MOST_SETTINGS 4096

static soleResult soleRefuseTrace( soleMessage* message, const char* what )
{
	soleSetMessage( message, "trace: %s", what );
	return sole_invalidDefinition;
}

// ----------------------------------------------------------------------------------------------------------- head

static soleResult soleReadHead( soleTracePlayer* player, soleMessage* message )
{
	if ( player->bytes == NULL || player->total < SOLE_TRACE_HEAD_BYTES ||
	    memcmp( player->bytes, SOLE_TRACE_MAGIC, 8 ) != 0 )
	{
		return soleRefuseTrace( message, "is none: give what soleTracer or 'sole bake --trace' has written" );
	}
	uint32_t form = soleTakeU32( player->bytes + 8 );
	uint32_t version = soleTakeU32( player->bytes + 12 );
	player->version =
	    ( soleVersion ){ (int32_t)( version >> 20 ), (int32_t)( version >> 10 & 1023 ), (int32_t)( version & 1023 ) };
	if ( form != SOLE_TRACE_FORM || soleTakeU32( player->bytes + 16 ) != soleGetFieldsChecksum() )
	{
		soleSetMessage( message,
		    "trace: was recorded by Sole %d.%d.%d, whose frames have other fields: replay it with that",
		    player->version.major, player->version.minor, player->version.patch );
		return sole_invalidDefinition;
	}
	player->checksum = soleChecksum( SOLE_CHECKSUM_START, player->bytes, SOLE_TRACE_HEAD_BYTES );
	player->at = SOLE_TRACE_HEAD_BYTES;
	return sole_success;
}

/// The rig's chunk, taken apart but not yet understood.
typedef struct soleTraceRig
{
	soleTraceWords words;
	size_t byteCount; // of the words' memory
	const uint8_t* texts;
	const uint8_t* end;
} soleTraceRig;

static soleResult soleReadRigWords( soleTracePlayer* player, soleTraceRig* rig, soleMessage* message )
{
	soleTraceChunk chunk;
	soleResult result = soleReadTraceChunk( player, &chunk, message );
	if ( result != sole_success )
	{
		return result;
	}
	uint32_t count = chunk.byteCount >= 4 ? soleTakeU32( chunk.bytes ) : 0;
	if ( chunk.kind != sole_chunkRig || count < 3 || count > ( chunk.byteCount - 4 ) / 4 )
	{
		return soleRefuseTrace( message, "has no rig at its start: record it anew" );
	}
	rig->byteCount = 4 * (size_t)count;
	rig->words.words = soleAlloc( player->allocatorOrNull, rig->byteCount );
	if ( rig->words.words == NULL )
	{
		soleSetMessage( message, "out of memory: %zu bytes were asked for", rig->byteCount );
		return sole_outOfMemory;
	}
	for ( uint32_t i = 0; i < count; ++i )
	{
		rig->words.words[i] = soleTakeU32( chunk.bytes + 4 + 4 * (size_t)i );
	}
	rig->words.count = (int32_t)count;
	rig->texts = chunk.bytes + 4 + 4 * (size_t)count;
	rig->end = chunk.bytes + chunk.byteCount;
	return sole_success;
}

/// @param text 256 bytes
static bool soleTakeText( soleTraceRig* rig, char* text )
{
	size_t length = rig->texts < rig->end ? rig->texts[0] : 0;
	if ( rig->texts >= rig->end || (size_t)( rig->end - rig->texts ) < length + 1 )
	{
		return false;
	}
	memcpy( text, rig->texts + 1, length );
	text[length] = 0;
	rig->texts += length + 1;
	return true;
}

/// Makes the rig. The definition points into the words for as long as that takes.
static soleResult soleTakeRig( soleTracePlayer* player, soleTraceRig* from, soleMessage* message )
{
	soleTraceWords* words = &from->words;
	soleRigDef def = soleDefaultRigDef();
	soleTakeWords( words, &player->jointCount, 1 );
	soleTakeWords( words, &player->legCount, 1 );
	soleTakeWords( words, &player->settingCount, 1 );
	// Each joint takes eleven words, each setting's name a byte.
	bool counted = player->jointCount >= 1 && player->jointCount <= words->count / 11 && player->legCount >= 1 &&
	    player->legCount <= SOLE_MAX_LEGS && player->settingCount >= 0 && player->settingCount <= MOST_SETTINGS &&
	    player->settingCount <= from->end - from->texts;
	if ( counted == false )
	{
		return soleRefuseTrace( message, "counts joints, legs or settings that it does not have: record it anew" );
	}
	def.jointCount = player->jointCount;
	def.legCount = player->legCount;
	def.parents = (const int32_t*)( words->words + words->at );
	words->at += def.jointCount;
	def.bindPose = (const soleTransform*)( words->words + words->at );
	words->at += 10 * def.jointCount;
	soleTakeWords( words, &def.pelvis, 1 );
	soleTakeWords( words, &def.up, 3 );
	soleTakeWords( words, &def.forward, 3 );
	char names[SOLE_MAX_LEGS][256];
	bool named = true;
	for ( int32_t i = 0; i < def.legCount; ++i )
	{
		soleTakeFields( words, &soleTraceLegDefTable, def.legs + i );
		named = named && soleTakeText( from, names[i] );
		def.legs[i].name = names[i];
	}
	if ( words->tooShort || named == false )
	{
		return soleRefuseTrace( message, "has less of a rig than it says: record it anew" );
	}
	return soleCreateRig( &def, player->allocatorOrNull, &player->rig, message );
}

static soleResult soleTakeSettingNames( soleTracePlayer* player, soleTraceRig* from, soleMessage* message )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < player->settingCount; ++i )
	{
		char name[256];
		if ( soleTakeText( from, name ) == false )
		{
			return soleRefuseTrace( message, "names less settings than it says: record it anew" );
		}
		int32_t found = 0;
		while ( found < count && strcmp( infos[found].name, name ) != 0 )
		{
			++found;
		}
		if ( found == count )
		{
			soleSetMessage( message,
			    "trace: has the setting '%.60s', which this version has not: replay it with Sole %d.%d.%d", name,
			    player->version.major, player->version.minor, player->version.patch );
			return sole_invalidDefinition;
		}
		player->offsets[i] = infos[found].offset;
	}
	return sole_success;
}

// ----------------------------------------------------------------------------------------------------------- open

/// The player with room for frames, in place of the one that has read the rig's counts.
static soleTracePlayer* soleAllocPlayer( const soleTracePlayer* small )
{
	soleTraceSizes sizes = soleFindTraceSizes( small->jointCount, small->legCount, small->settingCount );
	size_t joints = (size_t)small->jointCount;
	size_t byteCount = sizeof *small + 4 * (size_t)small->settingCount + 4 * (size_t)sizes.words +
	    2 * joints * sizeof( soleTransform ) + (size_t)sizes.hits * sizeof( soleHit ) +
	    (size_t)sizes.supports * sizeof( soleSupport );
	soleTracePlayer* player = soleAlloc( small->allocatorOrNull, byteCount );
	if ( player == NULL )
	{
		return NULL;
	}
	*player = *small;
	player->byteCount = byteCount;
	player->sizes = sizes;
	player->allocatorOrNull = small->allocatorOrNull != NULL ? &player->allocator : NULL;
	player->offsets = (uint32_t*)( player + 1 );
	player->words.words = player->offsets + player->settingCount;
	player->pose = (soleTransform*)( player->words.words + sizes.words );
	player->secondPose = player->pose + joints;
	player->hits = (soleHit*)( player->secondPose + joints );
	player->supports = (soleSupport*)( player->hits + sizes.hits );
	return player;
}

static soleResult soleOpenPlayer(
    soleTracePlayer* small, soleTraceRig* rig, soleTracePlayer** playerOut, soleMessage* message )
{
	soleResult result = soleReadHead( small, message );
	result = result == sole_success ? soleReadRigWords( small, rig, message ) : result;
	result = result == sole_success ? soleTakeRig( small, rig, message ) : result;
	if ( result != sole_success )
	{
		return result;
	}
	soleTracePlayer* player = soleAllocPlayer( small );
	if ( player == NULL )
	{
		soleSetMessage( message, "out of memory: a trace of %d joints was given", small->jointCount );
		soleDestroyRig( small->rig );
		return sole_outOfMemory;
	}
	result = soleTakeSettingNames( player, rig, message );
	if ( result != sole_success )
	{
		soleCloseTrace( player );
		return result;
	}
	*playerOut = player;
	return sole_success;
}

soleResult soleOpenTrace( const void* bytes, size_t byteCount, const soleAllocator* allocator, soleTracePlayer** player,
    soleMessage* message )
{
	*player = NULL;
	soleTracePlayer small = { .bytes = bytes, .total = byteCount };
	small.step.index = SOLE_NONE;
	if ( allocator != NULL )
	{
		small.allocator = *allocator;
		small.allocatorOrNull = allocator;
	}
	soleTraceRig rig = { 0 };
	soleResult result = soleOpenPlayer( &small, &rig, player, message );
	soleFree( small.allocatorOrNull, rig.words.words, rig.byteCount );
	return result;
}

void soleCloseTrace( soleTracePlayer* player )
{
	if ( player == NULL )
	{
		return;
	}
	soleDestroyRig( player->rig );
	soleAllocator allocator = player->allocator;
	soleFree( player->allocatorOrNull != NULL ? &allocator : NULL, player, player->byteCount );
}

const soleRig* soleTracePlayer_GetRig( const soleTracePlayer* player )
{
	SOLE_ASSERT( player != NULL );
	return player != NULL ? player->rig : NULL;
}

soleVersion soleTracePlayer_GetVersion( const soleTracePlayer* player )
{
	SOLE_ASSERT( player != NULL );
	return player != NULL ? player->version : ( soleVersion ){ 0, 0, 0 };
}
