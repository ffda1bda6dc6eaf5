// SPDX-License-Identifier: MIT
// A player of traces as its two files see it: one opens it and makes the rig, one reads frames.
#ifndef SOLE_DEBUG_TRACE_PLAYER_H
#define SOLE_DEBUG_TRACE_PLAYER_H

#include "debug/trace_internal.h"

struct soleTracePlayer
{
	const soleAllocator* allocatorOrNull;
	soleAllocator allocator;
	size_t byteCount;

	const uint8_t* bytes;
	size_t total;
	size_t at;
	uint32_t checksum;
	soleVersion version;
	bool ended;

	soleRig* rig;
	int32_t jointCount;
	int32_t legCount;
	int32_t settingCount;
	soleTraceSizes sizes;

	soleTraceStep step;
	soleSettings settings;
	soleState state;
	soleFrame frame;
	soleOutput output;
	float weights[3][SOLE_MAX_LEGS];
	soleContactInput contact[SOLE_MAX_LEGS];
	soleStepInput steps[SOLE_MAX_LEGS];

	// All of four-byte alignment, in one piece of memory behind this.
	uint32_t* offsets; // settingCount, in soleSettings
	soleTraceWords words;
	soleTransform* pose;
	soleTransform* secondPose;
	soleHit* hits;
	soleSupport* supports;
};

/// Of the bytes.
typedef struct soleTraceChunk
{
	uint32_t kind;
	const uint8_t* bytes;
	size_t byteCount;
} soleTraceChunk;

/// The next chunk, once its checksum has held.
soleResult soleReadTraceChunk( soleTracePlayer* player, soleTraceChunk* chunk, soleMessage* message );

#endif
