// SPDX-License-Identifier: MIT
// What of each struct is in a trace, and how it becomes words. A struct gets a new field: it belongs into its table
// here, where the compiler finds the gap in structs without pointers.
#include "debug/trace_internal.h"

#include <string.h>

#define FLOATS( type, field )                                                                                          \
	{                                                                                                                  \
#field, offsetof( type, field ), sole_fieldFloats, sizeof( ( (type*)0 )->field ) / 4                           \
	}
#define INTEGERS( type, field )                                                                                        \
	{                                                                                                                  \
#field, offsetof( type, field ), sole_fieldIntegers, sizeof( ( (type*)0 )->field ) / 4                         \
	}
#define FLAG( type, field )                                                                                            \
	{                                                                                                                  \
#field, offsetof( type, field ), sole_fieldFlag, 1                                                             \
	}
#define DOUBLES( type, field )                                                                                         \
	{                                                                                                                  \
#field, offsetof( type, field ), sole_fieldDoubles, sizeof( ( (type*)0 )->field ) / 8                          \
	}
#define TABLE( fields )                                                                                                \
	{                                                                                                                  \
		fields, (int32_t)( sizeof( fields ) / sizeof( ( fields )[0] ) )                                                \
	}

static const soleTraceField soleLegDefFields[] = {
	INTEGERS( soleLegDef, side ),
	INTEGERS( soleLegDef, joints ),
	INTEGERS( soleLegDef, jointCount ),
	FLAG( soleLegDef, hasVirtualAnkle ),
	FLOATS( soleLegDef, virtualAnkle ),
	INTEGERS( soleLegDef, detachedFoot ),
	INTEGERS( soleLegDef, toes ),
	INTEGERS( soleLegDef, toeCount ),
	FLOATS( soleLegDef, hinge ),
	FLOATS( soleLegDef, sole ),
	FLOATS( soleLegDef, ankleLimits ),
};
const soleTraceTable soleTraceLegDefTable = TABLE( soleLegDefFields );

static const soleTraceField soleFrameFields[] = {
	FLOATS( soleFrame, root ),
	FLOATS( soleFrame, up ),
	FLOATS( soleFrame, timeStep ),
	FLOATS( soleFrame, weight ),
	FLOATS( soleFrame, clipFloor ),
	FLAG( soleFrame, teleport ),
	DOUBLES( soleFrame, worldOrigin ),
};
const soleTraceTable soleTraceFrameTable = TABLE( soleFrameFields );

static const soleTraceField soleContactFields[] = {
	FLOATS( soleContactInput, heel ),
	FLOATS( soleContactInput, toe ),
};
const soleTraceTable soleTraceContactTable = TABLE( soleContactFields );
_Static_assert( sizeof( soleContactInput ) == 4 * 2, "all fields are in the table" );

static const soleTraceField soleStepFields[] = {
	FLOATS( soleStepInput, since ),
	FLOATS( soleStepInput, until ),
	FLOATS( soleStepInput, place ),
	FLOATS( soleStepInput, forward ),
	FLOATS( soleStepInput, travel ),
};
const soleTraceTable soleTraceStepTable = TABLE( soleStepFields );
_Static_assert( sizeof( soleStepInput ) == 4 * 11, "all fields are in the table" );

static const soleTraceField soleSupportFields[] = {
	INTEGERS( soleSupport, surface ),
	FLOATS( soleSupport, transform ),
};
const soleTraceTable soleTraceSupportTable = TABLE( soleSupportFields );
_Static_assert( sizeof( soleSupport ) == 4 * 11, "all fields are in the table" );

static const soleTraceField soleHitFields[] = {
	FLAG( soleHit, hit ),
	FLAG( soleHit, startedInside ),
	INTEGERS( soleHit, layer ),
	INTEGERS( soleHit, surface ),
	FLOATS( soleHit, point_w ),
	FLOATS( soleHit, normal_w ),
	FLOATS( soleHit, velocity_w ),
	FLOATS( soleHit, size ),
	FLOATS( soleHit, asked_w ),
};
const soleTraceTable soleTraceHitTable = TABLE( soleHitFields );
_Static_assert( sizeof( soleHit ) == 4 * 16, "all fields are in the table, two of them in one word" );

static const soleTraceField soleProbeFields[] = {
	FLOATS( soleProbe, start_w ),
	FLOATS( soleProbe, direction_w ),
	FLOATS( soleProbe, length ),
	FLOATS( soleProbe, radius ),
	INTEGERS( soleProbe, mask ),
};
const soleTraceTable soleTraceProbeTable = TABLE( soleProbeFields );
_Static_assert( sizeof( soleProbe ) == 4 * 10, "all fields are in the table but leg and index" );

static const soleTraceField soleOutputFields[] = {
	FLOATS( soleOutput, pelvisOffset_w ),
	FLOATS( soleOutput, pelvisTranslation_l ),
	FLOATS( soleOutput, capsuleShorter ),
	FLOATS( soleOutput, capsuleOffset ),
	FLOATS( soleOutput, groundOffset ),
	FLOATS( soleOutput, secondWeight ),
	FLOATS( soleOutput, bodyGradient_w ),
	FLOATS( soleOutput, unmetTime ),
	INTEGERS( soleOutput, activity ),
	FLOATS( soleOutput, strength ),
	FLOATS( soleOutput, lean_l ),
	INTEGERS( soleOutput, legCount ),
};
const soleTraceTable soleTraceOutputTable = TABLE( soleOutputFields );
_Static_assert( offsetof( soleOutput, legs ) == 4 * 21, "all fields are in the table" );

static const soleTraceField soleLegOutputFields[] = {
	INTEGERS( soleLegOutput, flags ),
	FLOATS( soleLegOutput, rotations_l ),
	FLOATS( soleLegOutput, toeRotation_l ),
	FLOATS( soleLegOutput, footTranslation_l ),
	FLOATS( soleLegOutput, footRotation_l ),
	FLOATS( soleLegOutput, ankleTarget_w ),
	FLOATS( soleLegOutput, ankle_w ),
	FLOATS( soleLegOutput, planePoint_w ),
	FLOATS( soleLegOutput, planeNormal_w ),
	FLOATS( soleLegOutput, stretch ),
	FLOATS( soleLegOutput, error ),
	FLOATS( soleLegOutput, extension ),
	FLOATS( soleLegOutput, heightDemand ),
	FLOATS( soleLegOutput, plantWeight ),
	FLOATS( soleLegOutput, confidence ),
};
const soleTraceTable soleTraceLegOutputTable = TABLE( soleLegOutputFields );
_Static_assert( sizeof( soleLegOutput ) == 4 * ( 1 + 28 + 4 + 3 + 4 + 12 + 6 ), "all fields are in the table" );

// ----------------------------------------------------------------------------------------------------------- words

void solePutWord( soleTraceWords* list, uint32_t word )
{
	list->words[list->at++] = word;
}

uint32_t soleTakeWord( soleTraceWords* list )
{
	if ( list->at >= list->count )
	{
		list->tooShort = true;
		return 0;
	}
	return list->words[list->at++];
}

void solePutWords( soleTraceWords* list, const void* from, int32_t count )
{
	memcpy( list->words + list->at, from, (size_t)count * sizeof( uint32_t ) );
	list->at += count;
}

void soleTakeWords( soleTraceWords* list, void* to, int32_t count )
{
	if ( count > list->count - list->at )
	{
		list->tooShort = true;
		memset( to, 0, (size_t)count * sizeof( uint32_t ) );
		return;
	}
	memcpy( to, list->words + list->at, (size_t)count * sizeof( uint32_t ) );
	list->at += count;
}

static void solePutDoubles( soleTraceWords* list, const void* from, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		uint64_t bits;
		memcpy( &bits, (const char*)from + 8 * i, sizeof bits );
		solePutWord( list, (uint32_t)bits );
		solePutWord( list, (uint32_t)( bits >> 32 ) );
	}
}

static void soleTakeDoubles( soleTraceWords* list, void* to, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		uint64_t low = soleTakeWord( list );
		uint64_t bits = low | (uint64_t)soleTakeWord( list ) << 32;
		memcpy( (char*)to + 8 * i, &bits, sizeof bits );
	}
}

// ---------------------------------------------------------------------------------------------------------- structs

int32_t soleCountFieldWords( const soleTraceTable* table )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < table->count; ++i )
	{
		const soleTraceField* field = table->fields + i;
		count += field->kind == sole_fieldDoubles ? 2 * field->count : field->count;
	}
	return count;
}

void solePutFields( soleTraceWords* list, const soleTraceTable* table, const void* from )
{
	for ( int32_t i = 0; i < table->count; ++i )
	{
		const soleTraceField* field = table->fields + i;
		const char* at = (const char*)from + field->offset;
		if ( field->kind == sole_fieldFlag )
		{
			solePutWord( list, *(const bool*)at ? 1u : 0u );
		}
		else if ( field->kind == sole_fieldDoubles )
		{
			solePutDoubles( list, at, field->count );
		}
		else
		{
			solePutWords( list, at, field->count );
		}
	}
}

void soleTakeFields( soleTraceWords* list, const soleTraceTable* table, void* to )
{
	for ( int32_t i = 0; i < table->count; ++i )
	{
		const soleTraceField* field = table->fields + i;
		char* at = (char*)to + field->offset;
		if ( field->kind == sole_fieldFlag )
		{
			*(bool*)at = soleTakeWord( list ) != 0;
		}
		else if ( field->kind == sole_fieldDoubles )
		{
			soleTakeDoubles( list, at, field->count );
		}
		else
		{
			soleTakeWords( list, at, field->count );
		}
	}
}

// A state is words but for its doubles: those before them, those behind them.
#define STATE_BEFORE ( (int32_t)( offsetof( soleState, worldOrigin ) / 4 ) )
#define STATE_AFTER offsetof( soleState, internalValue )

static int32_t soleCountWordsAfter( int32_t legCount )
{
	size_t end = offsetof( soleState, legs ) + (size_t)legCount * sizeof( soleLegState );
	return (int32_t)( ( end - STATE_AFTER ) / 4 );
}

int32_t soleCountStateWords( int32_t legCount )
{
	return STATE_BEFORE + 6 + soleCountWordsAfter( legCount );
}

void solePutStateWords( soleTraceWords* list, const soleState* state, int32_t legCount )
{
	solePutWords( list, state, STATE_BEFORE );
	solePutDoubles( list, state->worldOrigin, 3 );
	solePutWords( list, (const char*)state + STATE_AFTER, soleCountWordsAfter( legCount ) );
}

void soleTakeStateWords( soleTraceWords* list, soleState* state, int32_t legCount )
{
	memset( state, 0, sizeof *state );
	soleTakeWords( list, state, STATE_BEFORE );
	soleTakeDoubles( list, state->worldOrigin, 3 );
	soleTakeWords( list, (char*)state + STATE_AFTER, soleCountWordsAfter( legCount ) );
}

soleTraceSizes soleFindTraceSizes( int32_t jointCount, int32_t legCount, int32_t settingCount )
{
	soleTraceSizes sizes = { .hits = legCount * SOLE_MAX_PROBES_PER_LEG };
	// A body counts where a hit or a leg's memory names it.
	sizes.supports = sizes.hits + legCount;
	int32_t perLeg = 3 + soleCountFieldWords( &soleTraceContactTable ) + soleCountFieldWords( &soleTraceStepTable ) +
	    soleCountFieldWords( &soleTraceLegOutputTable );
	sizes.words = 5 + settingCount + soleCountFieldWords( &soleTraceFrameTable ) + 20 * jointCount + legCount * perLeg +
	    sizes.hits * soleCountFieldWords( &soleTraceHitTable ) +
	    sizes.supports * soleCountFieldWords( &soleTraceSupportTable ) + soleCountFieldWords( &soleTraceOutputTable );
	return sizes;
}

// ----------------------------------------------------------------------------------------------------------- bytes

void solePutU32( uint8_t* bytes, uint32_t word )
{
	for ( int32_t i = 0; i < 4; ++i )
	{
		bytes[i] = (uint8_t)( word >> ( 8 * i ) );
	}
}

uint32_t soleTakeU32( const uint8_t* bytes )
{
	uint32_t word = 0;
	for ( int32_t i = 0; i < 4; ++i )
	{
		word |= (uint32_t)bytes[i] << ( 8 * i );
	}
	return word;
}

uint32_t soleChecksum( uint32_t checksum, const uint8_t* bytes, size_t count )
{
	for ( size_t i = 0; i < count; ++i )
	{
		checksum = ( checksum ^ bytes[i] ) * 16777619u;
	}
	return checksum;
}

uint32_t soleChecksumWords( uint32_t checksum, const uint32_t* words, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		uint8_t bytes[4];
		solePutU32( bytes, words[i] );
		checksum = soleChecksum( checksum, bytes, 4 );
	}
	return checksum;
}

uint32_t soleGetProbeChecksum( const soleProbe* probes, int32_t count )
{
	uint32_t checksum = SOLE_CHECKSUM_START;
	for ( int32_t i = 0; i < count; ++i )
	{
		uint32_t words[16];
		soleTraceWords list = { .words = words };
		solePutFields( &list, &soleTraceProbeTable, probes + i );
		checksum = soleChecksumWords( checksum, words, list.at );
	}
	return checksum;
}

uint32_t soleGetFieldsChecksum( void )
{
	const soleTraceTable* tables[] = { &soleTraceLegDefTable, &soleTraceFrameTable, &soleTraceContactTable,
		&soleTraceStepTable, &soleTraceSupportTable, &soleTraceHitTable, &soleTraceProbeTable, &soleTraceOutputTable,
		&soleTraceLegOutputTable };
	const uint32_t state[] = { (uint32_t)STATE_BEFORE, (uint32_t)soleCountWordsAfter( 0 ),
		(uint32_t)soleCountWordsAfter( 1 ) };
	uint32_t checksum = soleChecksumWords( SOLE_CHECKSUM_START, state, 3 );
	for ( size_t i = 0; i < sizeof tables / sizeof tables[0]; ++i )
	{
		for ( int32_t j = 0; j < tables[i]->count; ++j )
		{
			const soleTraceField* field = tables[i]->fields + j;
			const uint32_t form[] = { (uint32_t)field->kind, (uint32_t)field->count };
			checksum = soleChecksum( checksum, (const uint8_t*)field->name, strlen( field->name ) );
			checksum = soleChecksumWords( checksum, form, 2 );
		}
	}
	return checksum;
}
