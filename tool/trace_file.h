// SPDX-License-Identifier: MIT
// A trace on its way to a file.
#ifndef TOOL_TRACE_FILE_H
#define TOOL_TRACE_FILE_H

#include "tool.h"

#include "sole/trace.h"

/// Zeroed memory is an empty one.
typedef struct toolTraceFile
{
	soleTracer* tracer;
	uint8_t* bytes;
	size_t byteCount;
	size_t capacity;
} toolTraceFile;

/// @param trace stays where it is for as long as its tracer is used
bool toolStartTrace( const soleRigDef* def, toolTraceFile* trace, toolError* error );
/// Ends the trace and writes it.
bool toolWriteTrace( toolTraceFile* trace, const char* path, toolError* error );
void toolFreeTrace( toolTraceFile* trace );

#endif
