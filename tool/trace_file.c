// SPDX-License-Identifier: MIT
// Keeps a trace in memory until all of it is there: a file is written whole or not at all.
#include "trace_file.h"

#include <stdlib.h>
#include <string.h>

static bool toolKeepBytes( const void* bytes, size_t byteCount, void* user )
{
	toolTraceFile* trace = user;
	if ( byteCount > trace->capacity - trace->byteCount )
	{
		trace->capacity = 2 * ( trace->capacity + byteCount );
		trace->bytes = toolGrow( trace->bytes, trace->capacity, 1 );
	}
	memcpy( trace->bytes + trace->byteCount, bytes, byteCount );
	trace->byteCount += byteCount;
	return true;
}

bool toolStartTrace( const soleRigDef* def, toolTraceFile* trace, toolError* error )
{
	soleTraceSink sink = { toolKeepBytes, trace };
	soleMessage message = { { 0 } };
	if ( soleCreateTracer( def, &sink, NULL, &trace->tracer, &message ) != sole_success )
	{
		return toolFail( error, "%s", message.text );
	}
	return true;
}

bool toolWriteTrace( toolTraceFile* trace, const char* path, toolError* error )
{
	if ( soleTracer_Finish( trace->tracer ) == false )
	{
		return toolFail( error, "%s: could not be recorded to its end: free some memory", path );
	}
	return toolWriteFile( path, trace->bytes, trace->byteCount, error );
}

void toolFreeTrace( toolTraceFile* trace )
{
	soleDestroyTracer( trace->tracer );
	free( trace->bytes );
	*trace = ( toolTraceFile ){ 0 };
}
