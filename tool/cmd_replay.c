// SPDX-License-Identifier: MIT
// sole replay: plays a recorded trace and says where it first differs from what was recorded.
#define _POSIX_C_SOURCE 200809L
#include "command.h"

#include "sole/trace.h"

#include <getopt.h>
#include <json-c/json.h>
#include <stdlib.h>
#include <string.h>

static const char* const toolReplayHelp =
    "usage: sole replay TRACE [--json]\n"
    "\n"
    "Plays what a tracer ('sole bake --trace FILE', or soleTracer in a game) has recorded, and compares everything that\n"
    "comes out with what came out then, bit by bit. The exit status is 1 where a bit differs.\n"
    "\n"
    "  --json  print the verdict as JSON\n";

/// A word of the output as a person reads it.
static double toolReadBits( const soleTraceDifference* first, uint32_t bits )
{
	float number;
	memcpy( &number, &bits, sizeof number );
	return first->isFloat ? (double)number : (double)bits;
}

static const char* toolNameLeg( const soleTraceReport* report )
{
	return report->first.leg >= 0 ? report->legNames[report->first.leg] : "none";
}

static struct json_object* toolDifferenceToJson( const soleTraceReport* report )
{
	const soleTraceDifference* first = &report->first;
	if ( first->frame == SOLE_NONE )
	{
		return NULL;
	}
	struct json_object* object = json_object_new_object();
	struct json_object* leg = first->leg >= 0 ? json_object_new_string( toolNameLeg( report ) ) : NULL;
	json_object_object_add( object, "frame", json_object_new_int( first->frame ) );
	json_object_object_add( object, "leg", leg );
	json_object_object_add( object, "field", json_object_new_string( first->field ) );
	json_object_object_add( object, "component", json_object_new_int( first->component ) );
	json_object_object_add( object, "recorded", json_object_new_double( toolReadBits( first, first->recorded ) ) );
	json_object_object_add( object, "replayed", json_object_new_double( toolReadBits( first, first->replayed ) ) );
	json_object_object_add( object, "recordedBits", json_object_new_int64( first->recorded ) );
	json_object_object_add( object, "replayedBits", json_object_new_int64( first->replayed ) );
	return object;
}

static void toolPrintReplay( const char* path, const soleTraceReport* report )
{
	struct json_object* object = json_object_new_object();
	char version[64];
	snprintf(
	    version, sizeof version, "%d.%d.%d", report->version.major, report->version.minor, report->version.patch );
	json_object_object_add( object, "file", json_object_new_string( path ) );
	json_object_object_add( object, "version", json_object_new_string( version ) );
	json_object_object_add( object, "legs", json_object_new_int( report->legCount ) );
	json_object_object_add( object, "frames", json_object_new_int( report->frameCount ) );
	json_object_object_add( object, "differentFrames", json_object_new_int( report->differentFrames ) );
	json_object_object_add( object, "first", toolDifferenceToJson( report ) );
	puts( json_object_to_json_string_ext( object, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_NOSLASHESCAPE ) );
	json_object_put( object );
}

static bool toolFailDifferent( const char* path, const soleTraceReport* report, toolError* error )
{
	const soleTraceDifference* first = &report->first;
	return toolFail( error,
	    "%s: frame %d, leg %s, %s[%d]: was %.9g (%08x), is %.9g (%08x); %d of %d frames differ: build without "
	    "contraction, or look for what has changed since Sole %d.%d.%d",
	    path, first->frame, toolNameLeg( report ), first->field, first->component,
	    toolReadBits( first, first->recorded ), first->recorded, toolReadBits( first, first->replayed ),
	    first->replayed, report->differentFrames, report->frameCount, report->version.major, report->version.minor,
	    report->version.patch );
}

static bool toolReplayFile( const char* path, bool json, toolError* error )
{
	uint8_t* bytes;
	size_t byteCount;
	if ( toolReadFile( path, &bytes, &byteCount, error ) == false )
	{
		return false;
	}
	soleTraceReport report;
	soleMessage message = { { 0 } };
	soleResult result = soleReplayTrace( bytes, byteCount, NULL, &report, &message );
	free( bytes );
	if ( result != sole_success )
	{
		return toolFail( error, "%s: %s", path, message.text );
	}
	if ( json )
	{
		toolPrintReplay( path, &report );
	}
	if ( report.differentFrames > 0 )
	{
		return toolFailDifferent( path, &report, error );
	}
	if ( json == false )
	{
		printf( "%s: %d frames of %d legs, recorded by Sole %d.%d.%d: the same to the bit\n", path, report.frameCount,
		    report.legCount, report.version.major, report.version.minor, report.version.patch );
	}
	return true;
}

int toolRunReplay( int argc, char** argv )
{
	static const struct option options[] = { { "json", no_argument, NULL, 'j' }, { "help", no_argument, NULL, 'h' },
		{ NULL, 0, NULL, 0 } };
	bool json = false;
	optind = 1;
	opterr = 0;
	for ( int option; ( option = getopt_long( argc, argv, "h", options, NULL ) ) != -1; )
	{
		if ( option == 'h' )
		{
			fputs( toolReplayHelp, stdout );
			return tool_done;
		}
		if ( option == '?' )
		{
			return toolReportUsage( "replay", "there is no such option" );
		}
		json = true;
	}
	if ( optind + 1 != argc )
	{
		return toolReportUsage( "replay", "give one trace" );
	}
	toolError error = { { 0 } };
	return toolReplayFile( argv[optind], json, &error ) ? tool_done : toolReportFailure( &error );
}
