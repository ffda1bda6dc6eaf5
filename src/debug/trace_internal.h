// SPDX-License-Identifier: MIT
// The form of a trace.
//
// Head: eight bytes of magic, version of the form, version of the library, checksum of the tables of fields; then
// chunks. All numbers are 32-bit words, low byte first. A chunk is its kind, the count of its bytes, a checksum, and
// the bytes. The checksum (FNV-1a) goes on from that of the chunk before, over kind, count and bytes: a chunk that was
// changed, left out or moved is found.
//   rig    count of words, the words of soleRigDef, then as texts with their lengths before them the names of legs and
//          of settings: settings are known by name, so that a new one makes no trace unreadable
//   state  words of soleState
//   frame  count of words; a bit per word that says whether it is another one than in the frame before; those words
//   end    count of frames
// Structs go into words field by field by the tables below, never as memory; only soleState, which is words and three
// doubles, is taken as it lies.
#ifndef SOLE_DEBUG_TRACE_INTERNAL_H
#define SOLE_DEBUG_TRACE_INTERNAL_H

#include "sole/trace.h"

#define SOLE_TRACE_MAGIC "SoleTrc\n"
#define SOLE_TRACE_FORM 1
#define SOLE_TRACE_HEAD_BYTES 20
#define SOLE_TRACE_CHUNK_BYTES 12 // before the chunk's own

enum
{
	sole_chunkRig = 1,
	sole_chunkState = 2,
	sole_chunkFrame = 3,
	sole_chunkEnd = 4
};

/// First word of a frame: which of the things that a frame may point to are there.
enum
{
	sole_tracePose = 1 << 0,
	sole_traceSecondPose = 1 << 1,
	sole_traceLegWeight = 1 << 2,
	sole_tracePositionWeight = 1 << 3,
	sole_traceRotationWeight = 1 << 4,
	sole_traceContact = 1 << 5,
	sole_traceSteps = 1 << 6,
	sole_traceSupports = 1 << 7
};

// ---------------------------------------------------------------------------------------------------------- fields

typedef enum soleFieldKind
{
	sole_fieldFloats,
	sole_fieldIntegers, // of 32 bits
	sole_fieldFlag,     // bool
	sole_fieldDoubles
} soleFieldKind;

typedef struct soleTraceField
{
	const char* name;
	uint32_t offset;
	soleFieldKind kind;
	int32_t count;
} soleTraceField;

typedef struct soleTraceTable
{
	const soleTraceField* fields;
	int32_t count;
} soleTraceTable;

extern const soleTraceTable soleTraceLegDefTable; // without the name
extern const soleTraceTable soleTraceFrameTable;  // without what it points to
extern const soleTraceTable soleTraceContactTable;
extern const soleTraceTable soleTraceStepTable;
extern const soleTraceTable soleTraceSupportTable;
extern const soleTraceTable soleTraceHitTable;
extern const soleTraceTable soleTraceProbeTable;
extern const soleTraceTable soleTraceOutputTable; // without the legs
extern const soleTraceTable soleTraceLegOutputTable;

/// A list of words that is written or read from its start.
typedef struct soleTraceWords
{
	uint32_t* words;
	int32_t at;
	int32_t count; // when read: how many there are
	bool tooShort; // more were asked for than there are; those were zero
} soleTraceWords;

void solePutWord( soleTraceWords* list, uint32_t word );
uint32_t soleTakeWord( soleTraceWords* list );
void solePutWords( soleTraceWords* list, const void* from, int32_t count );
void soleTakeWords( soleTraceWords* list, void* to, int32_t count );

int32_t soleCountFieldWords( const soleTraceTable* table );
void solePutFields( soleTraceWords* list, const soleTraceTable* table, const void* from );
void soleTakeFields( soleTraceWords* list, const soleTraceTable* table, void* to );

void solePutStateWords( soleTraceWords* list, const soleState* state, int32_t legCount );
void soleTakeStateWords( soleTraceWords* list, soleState* state, int32_t legCount );
int32_t soleCountStateWords( int32_t legCount );

/// Most of each that one frame can have.
typedef struct soleTraceSizes
{
	int32_t hits;
	int32_t supports;
	int32_t words;
} soleTraceSizes;

soleTraceSizes soleFindTraceSizes( int32_t jointCount, int32_t legCount, int32_t settingCount );

// ----------------------------------------------------------------------------------------------------------- bytes

void solePutU32( uint8_t* bytes, uint32_t word );
uint32_t soleTakeU32( const uint8_t* bytes );

#define SOLE_CHECKSUM_START 2166136261u
uint32_t soleChecksum( uint32_t checksum, const uint8_t* bytes, size_t count );
uint32_t soleChecksumWords( uint32_t checksum, const uint32_t* words, int32_t count );

/// Of all tables: two libraries with the same can read each other's frames.
uint32_t soleGetFieldsChecksum( void );

#endif
