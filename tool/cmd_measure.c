// SPDX-License-Identifier: MIT
// sole measure: the quality figures of a clip over a ground, per foot and for the whole.
#define _POSIX_C_SOURCE 200809L
#include "command.h"
#include "evaluate.h"
#include "figures_text.h"
#include "source.h"

#include <getopt.h>
#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_FPS 60.0
#define PLAIN_ROUNDS 4.0 // of a clip that was not baked

static const char* const toolMeasureHelp =
    "usage: sole measure F.glb --ground G --clip NAME [--reference NAME] [--json]\n"
    "       sole measure CHARACTER --table ...: grounds, rates and methods side by side, see --table --help\n"
    "\n"
    "Prints how well the feet of a clip stand on a ground: how deep and how far above they are, how much of the sole\n"
    "touches, how fast it slides, how far it drifts, how smooth knees and pelvis are. A clip made by 'sole bake' is\n"
    "measured as it is, against the clip it was made from on flat ground: contacts are those of that clip. Any other\n"
    "clip is moved along flat ground at height 0 at its own speed.\n"
    "\n"
    "  --ground G        file with the ground's triangles (.glb, .gltf, .obj), or the name of a sample\n"
    "  --clip NAME       what to measure, e.g. 'Walk|sole'\n"
    "  --reference NAME  another bake of the same run that ratios are taken to, e.g. 'Walk|none';\n"
    "                    default: the clip on flat ground\n"
    "  --clips FILE      where the clip that was baked is, if in another file\n"
    "  --scale S         what the character's file units are multiplied with; default: that of the bake, else 1\n"
    "  --published       figures as others have published them as well, to be put beside theirs\n"
    "  --json            SI units: m, s, rad; see 'legs', 'whole' and 'ratios'\n";

typedef struct toolMeasureOptions
{
	const char* file;
	const char* ground;
	const char* clip;
	const char* reference;
	const char* clips;
	double scale; // 0: not given
	bool published;
	bool json;
} toolMeasureOptions;

/// Everything that has to be freed.
typedef struct toolMeasureRun
{
	toolGltf* gltf;
	toolGltf* clipsGltf; // NULL: clips are in gltf
	toolCharacter character;
	toolBoundClip bound;
	toolTake take;
	toolGroundSource ground;
	soleTerrain* terrain;
	char method[64];
	// Of the clip and of its reference.
	soleFigures figures[2];
	solePublishedFigures published[2];
} toolMeasureRun;

static void toolFreeMeasureRun( toolMeasureRun* run )
{
	soleDestroyTerrain( run->terrain );
	toolCloseGround( &run->ground );
	toolFreeTake( &run->take );
	toolFreeBoundClip( &run->bound );
	toolFreeCharacter( &run->character );
	toolFreeGltf( run->clipsGltf );
	toolFreeGltf( run->gltf );
}

static bool toolFindNamedClip(
    const toolModel* model, const char* file, const char* name, int32_t* clip, toolError* error )
{
	*clip = toolFindClip( model, name );
	if ( *clip != SOLE_NONE )
	{
		return true;
	}
	char names[300] = "";
	size_t length = 0;
	for ( int32_t i = 0; i < model->clipCount && length < sizeof names - 1; ++i )
	{
		int n = snprintf( names + length, sizeof names - length, "%s'%s'", i > 0 ? ", " : "", model->clips[i].name );
		length += n > 0 ? (size_t)n : 0;
	}
	return toolFail( error, "%s: has no clip '%s': it has %s", file, name, model->clipCount > 0 ? names : "none" );
}

/// The file that a baked clip was made from, if it isn't this one.
static bool toolOpenClips(
    const toolMeasureOptions* options, const toolBakeInfo* info, toolMeasureRun* run, toolError* error )
{
	const char* path = options->clips != NULL ? options->clips : info->clips;
	if ( path[0] == 0 )
	{
		return true;
	}
	// A path in a file is taken from where that file is.
	const char* slash = options->file != NULL ? strrchr( options->file, '/' ) : NULL;
	bool beside = options->clips == NULL && path[0] != '/' && slash != NULL;
	char* full =
	    beside ? toolFormat( "%.*s/%s", (int)( slash - options->file ), options->file, path ) : toolCopyString( path );
	bool good = toolOpenCharacter( full, &run->clipsGltf, error );
	free( full );
	return good;
}

static bool toolMakeBakedRun(
    const toolMeasureOptions* options, int32_t clip, const toolBakeInfo* info, toolMeasureRun* run, toolError* error )
{
	if ( toolOpenClips( options, info, run, error ) == false )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( run->clipsGltf != NULL ? run->clipsGltf : run->gltf );
	int32_t base = toolFindClip( model, info->clip );
	bool rest = base == SOLE_NONE && strcmp( info->clip, TOOL_REST_CLIP ) == 0;
	if ( base == SOLE_NONE && rest == false )
	{
		return toolFail( error, "%s: clip '%s', which '%s' was made from, is not in it: name its file with --clips",
		    options->file, info->clip, options->clip );
	}
	snprintf( run->method, sizeof run->method, "%s", info->method );
	if ( rest )
	{
		toolBindRest( &run->bound );
	}
	bool good = ( rest || toolBindClip( &run->character, model, base, &run->bound, error ) ) &&
	    toolRebuildTake( &run->character, clip, info, &run->bound, &run->take, error );
	return good || toolFailIn( error, options->file );
}

static bool toolMakePlainRun( const toolMeasureOptions* options, int32_t clip, toolMeasureRun* run, toolError* error )
{
	const toolModel* model = toolGltf_GetModel( run->gltf );
	if ( toolBindClip( &run->character, model, clip, &run->bound, error ) == false )
	{
		return toolFailIn( error, options->file );
	}
	toolTravel travel = toolFindTravel( &run->character, &run->bound );
	double rounds = travel.loops ? PLAIN_ROUNDS : 1.0;
	return toolMakeClipTake( &run->character, &run->bound, &travel, DEFAULT_FPS, rounds, &run->take, error ) ||
	    toolFailIn( error, options->file );
}

static bool toolTakeReference( const toolMeasureOptions* options, toolMeasureRun* run, toolError* error )
{
	int32_t reference = SOLE_NONE;
	const toolModel* model = toolGltf_GetModel( run->gltf );
	if ( options->reference == NULL )
	{
		return true;
	}
	return toolFindNamedClip( model, options->file, options->reference, &reference, error ) &&
	    ( toolReplaceReference( &run->character, reference, &run->take, error ) || toolFailIn( error, options->file ) );
}

static bool toolPrepareMeasure( const toolMeasureOptions* options, toolMeasureRun* run, toolError* error )
{
	int32_t clip = SOLE_NONE;
	if ( toolOpenCharacter( options->file, &run->gltf, error ) == false )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( run->gltf );
	if ( toolFindNamedClip( model, options->file, options->clip, &clip, error ) == false )
	{
		return false;
	}
	toolBakeInfo info;
	bool baked = toolReadBakeInfo( model->clips + clip, &info );
	double scale = options->scale > 0.0 ? options->scale : ( baked ? info.scale : 1.0 );
	if ( toolMakeCharacter( model, options->file, (float)scale, &run->character, error ) == false )
	{
		return false;
	}
	bool made =
	    baked ? toolMakeBakedRun( options, clip, &info, run, error ) : toolMakePlainRun( options, clip, run, error );
	return made && toolTakeReference( options, run, error ) && toolOpenGround( options->ground, &run->ground, error ) &&
	    toolMakeTerrain( &run->ground, &run->terrain, error );
}

static bool toolMeasureRunTake( const toolMeasureOptions* options, toolMeasureRun* run, toolError* error )
{
	bool good = toolMeasureTake( &run->character, &run->take, run->terrain, run->figures, run->figures + 1, error ) &&
	    ( options->published == false ||
	        toolMeasureTakePublished(
	            &run->character, &run->take, run->terrain, run->published, run->published + 1, error ) );
	return good || toolFailIn( error, options->file );
}

static void toolPrintMeasure( const toolMeasureOptions* options, const toolMeasureRun* run )
{
	const toolTake* take = &run->take;
	bool other = options->reference != NULL;
	printf( "%s over %s: %d frames at %g fps, %d at the start left out\nreference: %s%s\n\n", options->clip,
	    options->ground, take->frameCount, (double)take->frameRate, take->skip,
	    other ? options->reference : run->bound.clip->name, other ? "" : " on flat ground" );
	toolFigureColumn columns[2] = {
		{ run->method[0] != 0 ? run->method : "clip", run->figures, run->figures + 1, NULL },
		{ "reference", run->figures + 1, NULL, NULL },
	};
	for ( int32_t i = 0; i < 2 && options->published; ++i )
	{
		columns[i].published = run->published + i;
	}
	toolPrintFigures( stdout, run->character.rig, columns, 2 );
}

static void toolPrintMeasureJson( const toolMeasureOptions* options, const toolMeasureRun* run )
{
	const toolTake* take = &run->take;
	const char* against = options->reference != NULL ? options->reference : run->bound.clip->name;
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "clip", json_object_new_string( options->clip ) );
	json_object_object_add( object, "method", json_object_new_string( run->method ) );
	json_object_object_add( object, "reference", json_object_new_string( against ) );
	json_object_object_add( object, "referenceFlat", json_object_new_boolean( options->reference == NULL ) );
	json_object_object_add( object, "ground", json_object_new_string( options->ground ) );
	json_object_object_add( object, "fps", json_object_new_double( (double)take->frameRate ) );
	json_object_object_add( object, "frames", json_object_new_int( take->frameCount ) );
	json_object_object_add( object, "skip", json_object_new_int( take->skip ) );
	// What comes first in a file should say what it is about.
	struct json_object* measured = toolFiguresToJson( run->character.rig, run->figures );
	json_object_object_foreach( measured, key, value )
	{
		json_object_object_add( object, key, json_object_get( value ) );
	}
	json_object_put( measured );
	json_object_object_add( object, "referenceFigures", toolFiguresToJson( run->character.rig, run->figures + 1 ) );
	json_object_object_add( object, "ratios", toolRatiosToJson( run->figures, run->figures + 1 ) );
	if ( options->published )
	{
		json_object_object_add( object, "published", toolPublishedToJson( run->published ) );
		json_object_object_add( object, "referencePublished", toolPublishedToJson( run->published + 1 ) );
	}
	puts( json_object_to_json_string_ext( object, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED ) );
	json_object_put( object );
}

/// @return tool_done, or the status to leave with; *help where the help was asked for.
static int toolReadMeasureOptions( int argc, char** argv, toolMeasureOptions* options, bool* help )
{
	static const struct option names[] = { { "ground", required_argument, NULL, 'g' },
		{ "clip", required_argument, NULL, 'c' }, { "reference", required_argument, NULL, 'r' },
		{ "clips", required_argument, NULL, 'C' }, { "scale", required_argument, NULL, 's' },
		{ "published", no_argument, NULL, 'p' }, { "json", no_argument, NULL, 'j' }, { "help", no_argument, NULL, 'h' },
		{ NULL, 0, NULL, 0 } };
	opterr = 0;
	for ( int c = getopt_long( argc, argv, "h", names, NULL ); c != -1;
	      c = getopt_long( argc, argv, "h", names, NULL ) )
	{
		switch ( c )
		{
		case 'g':
			options->ground = optarg;
			break;
		case 'c':
			options->clip = optarg;
			break;
		case 'r':
			options->reference = optarg;
			break;
		case 'C':
			options->clips = optarg;
			break;
		case 's':
			if ( toolParseNumber( optarg, &options->scale ) == false || options->scale <= 0.0 )
			{
				return toolReportUsage( "measure", "--scale needs a number above zero" );
			}
			break;
		case 'p':
			options->published = true;
			break;
		case 'j':
			options->json = true;
			break;
		case 'h':
			*help = true;
			return tool_done;
		default:
			return toolReportUsage( "measure", "unknown option, or one without its value" );
		}
	}
	if ( optind + 1 != argc )
	{
		return toolReportUsage( "measure", "give one file" );
	}
	options->file = argv[optind];
	if ( options->ground == NULL || options->clip == NULL )
	{
		return toolReportUsage( "measure", options->ground == NULL ? "--ground is missing" : "--clip is missing" );
	}
	return tool_done;
}

/// Is one of the arguments --table?
static bool toolWantsTable( int argc, char** argv )
{
	for ( int i = 1; i < argc; ++i )
	{
		if ( strcmp( argv[i], "--table" ) == 0 )
		{
			return true;
		}
	}
	return false;
}

int toolRunMeasure( int argc, char** argv )
{
	if ( toolWantsTable( argc, argv ) )
	{
		return toolRunMeasureTable( argc, argv );
	}
	toolMeasureOptions options = { 0 };
	bool help = false;
	int status = toolReadMeasureOptions( argc, argv, &options, &help );
	if ( help )
	{
		fputs( toolMeasureHelp, stdout );
	}
	if ( help || status != tool_done )
	{
		return status;
	}
	toolMeasureRun* run = toolAlloc( 1, sizeof *run );
	toolError error = { { 0 } };
	bool good = toolPrepareMeasure( &options, run, &error ) && toolMeasureRunTake( &options, run, &error );
	if ( good && options.json )
	{
		toolPrintMeasureJson( &options, run );
	}
	else if ( good )
	{
		toolPrintMeasure( &options, run );
	}
	toolFreeMeasureRun( run );
	free( run );
	return good ? tool_done : toolReportFailure( &error );
}
