// SPDX-License-Identifier: MIT
// sole label: when which part of which foot is down in each clip of a file.
#define _POSIX_C_SOURCE 200809L
#include "command.h"
#include "evaluate.h"
#include "source.h"

#include <getopt.h>
#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ROUNDS 3.0     // of a clip that loops: the middle one is printed, so that its ends are like its middle
#define LEAST_FPS 60.0 // below, differences of positions smear the short contacts of a run
#define MOST_FPS 240.0

static const char* const toolLabelHelp =
    "usage: sole label F.glb [--clip NAME] [--scale S] [--json]\n"
    "\n"
    "Prints when heel and toe of each foot are in contact, per clip, in seconds of the clip. Contact: slower than\n"
    "0.15 m/s and lower than 2 cm over the clip's own floor, until faster than 0.30 m/s or higher than 4 cm; in-place\n"
    "clips are moved at their own stride speed. Clips made by 'sole bake' are left out unless they are named.\n"
    "\n"
    "  --clip NAME  only this clip\n"
    "  --scale S    what the file's units are multiplied with; default 1\n"
    "  --json       [ { \"name\", \"duration\", \"contacts\": [ { \"leg\", \"heel\", \"toe\" } ] } ], s\n";

/// One clip's labels and the frames of them that are printed.
typedef struct toolLabelled
{
	const toolCharacter* character;
	const char* clip;
	const toolTake* take;
	int32_t first; // frame of the clip's start
	int32_t end;   // and behind its end
} toolLabelled;

/// The next run of a bit from a frame on. @return false where there is none.
static bool toolNextRun( const toolLabelled* l, int32_t leg, uint8_t bit, int32_t from, int32_t* first, int32_t* end )
{
	int32_t legCount = soleRig_GetLegCount( l->character->rig );
	int32_t frame = from;
	while ( frame < l->end && ( l->take->labels[(size_t)frame * (size_t)legCount + (size_t)leg] & bit ) == 0 )
	{
		++frame;
	}
	*first = frame;
	while ( frame < l->end && ( l->take->labels[(size_t)frame * (size_t)legCount + (size_t)leg] & bit ) != 0 )
	{
		++frame;
	}
	*end = frame;
	return *end > *first;
}

/// A frame speaks for half a frame to either side, within the clip.
static double toolEdgeTime( const toolLabelled* l, int32_t frame )
{
	double last = (double)( l->end - 1 - l->first );
	double at = (double)( frame - l->first ) - 0.5;
	return fmin( fmax( at, 0.0 ), last ) / (double)l->take->frameRate;
}

static double toolLabelledDuration( const toolLabelled* l )
{
	return (double)( l->end - 1 - l->first ) / (double)l->take->frameRate;
}

static void toolPrintLabels( const toolLabelled* l )
{
	printf( "%s: %.3f s\n", l->clip, toolLabelledDuration( l ) );
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( l->character->rig ); ++leg )
	{
		for ( int32_t part = 0; part < 2; ++part )
		{
			uint8_t bit = part == 0 ? sole_labelHeel : sole_labelToe;
			const char* name = part == 0 ? soleRig_GetLeg( l->character->rig, leg ).name : "";
			printf( "  %-12s %-5s", name != NULL ? name : "", part == 0 ? "heel" : "toe" );
			int32_t first = l->first;
			int32_t end = l->first;
			bool any = false;
			while ( toolNextRun( l, leg, bit, end, &first, &end ) )
			{
				printf( "  %.3f-%.3f", toolEdgeTime( l, first ), toolEdgeTime( l, end ) );
				any = true;
			}
			puts( any ? "" : "  never" );
		}
	}
}

static struct json_object* toolIntervalsToJson( const toolLabelled* l, int32_t leg, uint8_t bit )
{
	struct json_object* intervals = json_object_new_array();
	int32_t first = l->first;
	int32_t end = l->first;
	while ( toolNextRun( l, leg, bit, end, &first, &end ) )
	{
		struct json_object* pair = json_object_new_array();
		json_object_array_add( pair, json_object_new_double( toolEdgeTime( l, first ) ) );
		json_object_array_add( pair, json_object_new_double( toolEdgeTime( l, end ) ) );
		json_object_array_add( intervals, pair );
	}
	return intervals;
}

static struct json_object* toolLabelsToJson( const toolLabelled* l )
{
	struct json_object* contacts = json_object_new_array();
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( l->character->rig ); ++leg )
	{
		const char* name = soleRig_GetLeg( l->character->rig, leg ).name;
		struct json_object* item = json_object_new_object();
		json_object_object_add( item, "leg", json_object_new_string( name != NULL ? name : "" ) );
		json_object_object_add( item, "heel", toolIntervalsToJson( l, leg, sole_labelHeel ) );
		json_object_object_add( item, "toe", toolIntervalsToJson( l, leg, sole_labelToe ) );
		json_object_array_add( contacts, item );
	}
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "name", json_object_new_string( l->clip ) );
	json_object_object_add( object, "duration", json_object_new_double( toolLabelledDuration( l ) ) );
	json_object_object_add( object, "contacts", contacts );
	return object;
}

/// A baked clip has the contacts of what it was made from, at the speed and for as long as it was played.
static bool toolLabelBaked( const toolCharacter* character, int32_t clip, const toolBakeInfo* info, toolTake* take,
    toolLabelled* labelled, toolError* error )
{
	toolBoundClip bound;
	int32_t base = toolFindClip( character->model, info->clip );
	if ( base == SOLE_NONE )
	{
		return toolFail( error, "clip '%s' was made from '%s', which is not in this file: label that one",
		    character->model->clips[clip].name, info->clip );
	}
	if ( toolBindClip( character, character->model, base, &bound, error ) == false )
	{
		return false;
	}
	bool good = toolRebuildTake( character, clip, info, &bound, take, error );
	toolFreeBoundClip( &bound );
	labelled->end = take->frameCount;
	return good;
}

static bool toolLabelPlain(
    const toolCharacter* character, int32_t clip, toolTake* take, toolLabelled* labelled, toolError* error )
{
	toolBoundClip bound;
	if ( toolBindClip( character, character->model, clip, &bound, error ) == false )
	{
		return false;
	}
	toolTravel travel = toolFindTravel( character, &bound );
	double fps = fmin( fmax( (double)travel.frameRate, LEAST_FPS ), MOST_FPS );
	double frames = floor( (double)bound.duration * fps + 0.5 );
	bool loops = travel.loops && frames >= 1.0;
	// A round is a whole number of frames.
	fps = frames >= 1.0 ? frames / (double)bound.duration : fps;
	bool good = toolMakeClipTake( character, &bound, &travel, fps, loops ? ROUNDS : 1.0, take, error );
	toolFreeBoundClip( &bound );
	if ( good )
	{
		labelled->first = loops ? (int32_t)frames : 0;
		labelled->end = loops ? 2 * (int32_t)frames + 1 : take->frameCount;
	}
	return good;
}

/// Labels one clip and prints it, or adds it to a list.
static bool toolLabelClip( const toolCharacter* character, int32_t clip, struct json_object* list, toolError* error )
{
	toolTake take = { 0 };
	toolBakeInfo info;
	toolLabelled labelled = { .character = character, .clip = character->model->clips[clip].name, .take = &take };
	bool good = toolReadBakeInfo( character->model->clips + clip, &info )
	    ? toolLabelBaked( character, clip, &info, &take, &labelled, error )
	    : toolLabelPlain( character, clip, &take, &labelled, error );
	if ( good && list != NULL )
	{
		json_object_array_add( list, toolLabelsToJson( &labelled ) );
	}
	else if ( good )
	{
		toolPrintLabels( &labelled );
	}
	toolFreeTake( &take );
	return good;
}

/// All clips but baked ones; a clip that can't be labelled is told of and passed over.
static bool toolLabelAll( const toolCharacter* character, const char* file, struct json_object* list )
{
	bool any = false;
	for ( int32_t i = 0; i < character->model->clipCount; ++i )
	{
		toolBakeInfo info;
		toolError error = { { 0 } };
		if ( toolReadBakeInfo( character->model->clips + i, &info ) )
		{
			continue;
		}
		if ( toolLabelClip( character, i, list, &error ) )
		{
			any = true;
		}
		else
		{
			fprintf( stderr, "sole: %s: left out: %s\n", file, error.text );
		}
		toolProgress( "label", (double)( i + 1 ) / (double)character->model->clipCount );
	}
	return any;
}

static bool toolLabelFile( const char* file, const char* clipName, double scale, bool json, toolError* error )
{
	toolGltf* gltf = NULL;
	if ( toolOpenCharacter( file, &gltf, error ) == false )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( gltf );
	toolCharacter character = { 0 };
	struct json_object* list = json ? json_object_new_array() : NULL;
	bool good = toolMakeCharacter( model, file, (float)scale, &character, error );
	if ( good && clipName == NULL )
	{
		good = toolLabelAll( &character, file, list ) ||
		    toolFail( error, "%s: no clip can be labelled: give one with clips", file );
	}
	else if ( good )
	{
		int32_t clip = toolFindClip( model, clipName );
		good = clip != SOLE_NONE ? toolLabelClip( &character, clip, list, error ) || toolFailIn( error, file )
		                         : toolFail( error, "%s: has no clip '%s': see 'sole inspect'", file, clipName );
	}
	if ( good && json )
	{
		puts( json_object_to_json_string_ext( list, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED ) );
	}
	json_object_put( list );
	toolFreeCharacter( &character );
	toolFreeGltf( gltf );
	return good;
}

int toolRunLabel( int argc, char** argv )
{
	static const struct option names[] = { { "clip", required_argument, NULL, 'c' },
		{ "scale", required_argument, NULL, 's' }, { "json", no_argument, NULL, 'j' },
		{ "help", no_argument, NULL, 'h' }, { NULL, 0, NULL, 0 } };
	const char* clip = NULL;
	double scale = 1.0;
	bool json = false;
	opterr = 0;
	for ( int c = getopt_long( argc, argv, "h", names, NULL ); c != -1;
	      c = getopt_long( argc, argv, "h", names, NULL ) )
	{
		switch ( c )
		{
		case 'c':
			clip = optarg;
			break;
		case 's':
			if ( toolParseNumber( optarg, &scale ) == false || scale <= 0.0 )
			{
				return toolReportUsage( "label", "--scale needs a number above zero" );
			}
			break;
		case 'j':
			json = true;
			break;
		case 'h':
			fputs( toolLabelHelp, stdout );
			return tool_done;
		default:
			return toolReportUsage( "label", "unknown option, or one without its value" );
		}
	}
	if ( optind + 1 != argc )
	{
		return toolReportUsage( "label", "give one file" );
	}
	toolError error = { { 0 } };
	return toolLabelFile( argv[optind], clip, scale, json, &error ) ? tool_done : toolReportFailure( &error );
}
