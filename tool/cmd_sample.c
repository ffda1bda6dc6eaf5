// SPDX-License-Identifier: MIT
// sole sample: writes an embedded sample, a character or a ground, as a file.
#include "command.h"
#include "scenario.h"
#include "source.h"

#include <getopt.h>
#include <json-c/json.h>

static const char toolHelp[] = "usage: sole sample NAME -o FILE.glb\n"
                               "       sole sample --list [--json]\n"
                               "\n"
                               "Writes an embedded sample: a character to place, or a ground to walk on.\n"
                               "\n"
                               "  -o, --output FILE   where to write, .glb or .gltf\n"
                               "  --list              print the names of all samples\n"
                               "  --json              as JSON, with the way that each ground is meant to be walked,\n"
                               "                      and how its pieces move\n";

#define MOTION_TIME 12 // s, of the motion of pieces: then the scene may begin anew
#define KEY_RATE 30    // a second: between keys 0.2 mm are lost at most

#define CHARACTER "mannequin"
#define CHARACTER_TEXT "a skinned figure with clips: idle, walk, run, turn, strafe, crouch"

static void toolListSamples( void )
{
	printf( "%-12s %s\n", CHARACTER, CHARACTER_TEXT );
	int32_t count;
	const char* const* ids = soleGetSceneIds( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleScene scene;
		if ( soleMakeScene( ids[i], &scene ) )
		{
			printf( "%-12s %s, %d triangles\n", ids[i], scene.name, scene.triangleCount );
			soleFreeScene( &scene );
		}
	}
}

static struct json_object* toolDescribeSample( const char* name, const char* kind, const char* text )
{
	struct json_object* sample = json_object_new_object();
	json_object_object_add( sample, "name", json_object_new_string( name ) );
	json_object_object_add( sample, "kind", json_object_new_string( kind ) );
	json_object_object_add( sample, "text", json_object_new_string( text ) );
	return sample;
}

static bool toolMoves( const soleSceneMotion* motion )
{
	soleVec3 v = motion->velocity;
	return motion->waveRate != 0.0 || soleDot( v, v ) != 0.0f || motion->spin != 0.0 || motion->tilt != 0.0;
}

// Numbers of floats: six digits say all that they hold.
static void toolAddFloat( struct json_object* list, float value )
{
	struct json_object* number = json_object_new_double( (double)value );
	json_object_set_serializer( number, json_object_double_to_json_string, "%.6g", NULL );
	json_object_array_add( list, number );
}

// Where a piece is, as keys. A piece that never turns has no turns.
static struct json_object* toolDescribeMotion( const soleSceneMotion* motion )
{
	bool turns = motion->spin != 0.0 || motion->tilt != 0.0;
	struct json_object* places = json_object_new_array();
	struct json_object* rotations = turns ? json_object_new_array() : NULL;
	for ( int32_t i = 0; i <= MOTION_TIME * KEY_RATE; ++i )
	{
		soleTransform where;
		soleGetSceneMotion( motion, (double)i / KEY_RATE, &where );
		const float place[] = { where.translation.x, where.translation.y, where.translation.z };
		const float turn[] = { where.rotation.x, where.rotation.y, where.rotation.z, where.rotation.w };
		for ( int32_t k = 0; k < 3; ++k )
		{
			toolAddFloat( places, place[k] );
		}
		for ( int32_t k = 0; turns && k < 4; ++k )
		{
			toolAddFloat( rotations, turn[k] );
		}
	}
	struct json_object* keys = json_object_new_object();
	json_object_object_add( keys, "rate", json_object_new_int( KEY_RATE ) );
	json_object_object_add( keys, "places", places );
	if ( turns )
	{
		json_object_object_add( keys, "turns", rotations );
	}
	return keys;
}

// Where the triangles of a piece are: in the scene's file from a triangle on, or, what is not seen at time 0, here.
static void toolDescribeTriangles( const soleScene* scene, int32_t index, int32_t* inFile, struct json_object* part )
{
	const soleScenePiece* piece = scene->pieces + index;
	if ( toolIsPieceInFile( scene, index ) )
	{
		json_object_object_add( part, "firstTriangle", json_object_new_int( *inFile ) );
		json_object_object_add( part, "triangles", json_object_new_int( piece->triangleCount ) );
		*inFile += piece->triangleCount;
		return;
	}
	struct json_object* indices = json_object_new_array();
	for ( int32_t i = 0; i < 3 * piece->triangleCount; ++i )
	{
		json_object_array_add(
		    indices, json_object_new_int64( scene->indices[3 * (size_t)piece->firstTriangle + (size_t)i] ) );
	}
	json_object_object_add( part, "indices", indices );
}

static struct json_object* toolDescribePiece( const soleScenePiece* piece )
{
	struct json_object* part = json_object_new_object();
	json_object_object_add( part, "layer", json_object_new_int64( piece->layer ) );
	json_object_object_add( part, "surface", json_object_new_int( piece->surface ) );
	if ( piece->motion.from > 0.0 )
	{
		json_object_object_add( part, "from", json_object_new_double( piece->motion.from ) );
	}
	if ( piece->motion.until > 0.0 )
	{
		json_object_object_add( part, "until", json_object_new_double( piece->motion.until ) );
	}
	if ( toolMoves( &piece->motion ) )
	{
		json_object_object_add( part, "keys", toolDescribeMotion( &piece->motion ) );
	}
	return part;
}

// A scene of pieces: what each is there for and how it moves. Files hold where they are at time 0.
static void toolDescribePieces( const soleScene* scene, struct json_object* sample )
{
	struct json_object* pieces = json_object_new_array();
	bool changes = false;
	int32_t inFile = 0;
	for ( int32_t i = 0; i < scene->pieceCount; ++i )
	{
		const soleSceneMotion* motion = &scene->pieces[i].motion;
		changes = changes || toolMoves( motion ) || motion->from > 0.0 || motion->until > 0.0;
		struct json_object* part = toolDescribePiece( scene->pieces + i );
		toolDescribeTriangles( scene, i, &inFile, part );
		json_object_array_add( pieces, part );
	}
	json_object_object_add( sample, "pieces", pieces );
	if ( changes )
	{
		json_object_object_add( sample, "duration", json_object_new_int( MOTION_TIME ) );
	}
}

static struct json_object* toolDescribeScene( const soleScene* scene )
{
	struct json_object* sample = toolDescribeSample( scene->id, "ground", scene->name );
	json_object_object_add( sample, "triangles", json_object_new_int( scene->triangleCount ) );
	toolDescribePieces( scene, sample );
	struct json_object* path = json_object_new_array();
	for ( int32_t i = 0; i < scene->pathCount; ++i )
	{
		struct json_object* corner = json_object_new_array();
		json_object_array_add( corner, json_object_new_double( (double)scene->path[i][0] ) );
		json_object_array_add( corner, json_object_new_double( (double)scene->path[i][1] ) );
		json_object_array_add( path, corner );
	}
	json_object_object_add( sample, "path", path );
	return sample;
}

static void toolPrintSamples( void )
{
	struct json_object* list = json_object_new_array();
	json_object_array_add( list, toolDescribeSample( CHARACTER, "character", CHARACTER_TEXT ) );
	int32_t count;
	const char* const* ids = soleGetSceneIds( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleScene scene;
		if ( soleMakeScene( ids[i], &scene ) )
		{
			json_object_array_add( list, toolDescribeScene( &scene ) );
			soleFreeScene( &scene );
		}
	}
	puts( json_object_to_json_string_ext( list, JSON_C_TO_STRING_SPACED ) );
	json_object_put( list );
}

// A file of the sample, or NULL.
static toolGltf* toolMakeSample( const char* name, toolError* error )
{
	toolGltf* gltf = NULL;
	if ( toolOpenEmbeddedCharacter( name, &gltf ) )
	{
		return gltf;
	}
	toolGroundSource ground;
	if ( toolOpenEmbeddedGround( name, &ground ) == false )
	{
		toolFail( error, "%s: there is no such sample: 'sole sample --list' names them", name );
		return NULL;
	}
	toolModel model;
	toolMakeGroundModel( &ground, &model );
	toolCloseGround( &ground );
	gltf = toolMakeGltf( &model );
	toolFreeModel( &model );
	return gltf;
}

int toolRunSample( int argc, char** argv )
{
	static const struct option options[] = {
		{ "output", required_argument, NULL, 'o' },
		{ "list", no_argument, NULL, 'l' },
		{ "json", no_argument, NULL, 'j' },
		{ "help", no_argument, NULL, 'h' },
		{ NULL, 0, NULL, 0 },
	};
	const char* output = NULL;
	bool list = false;
	bool json = false;
	optind = 1;
	opterr = 0;
	int option;
	while ( ( option = getopt_long( argc, argv, "o:h", options, NULL ) ) != -1 )
	{
		switch ( option )
		{
		case 'o':
			output = optarg;
			break;
		case 'l':
			list = true;
			break;
		case 'j':
			json = true;
			break;
		case 'h':
			fputs( toolHelp, stdout );
			return tool_done;
		default:
			return toolReportUsage( "sample", "an option is unknown or lacks its value" );
		}
	}
	if ( list )
	{
		json ? toolPrintSamples() : toolListSamples();
		return tool_done;
	}
	if ( argc - optind != 1 || output == NULL )
	{
		return toolReportUsage( "sample", output == NULL ? "-o is missing: where to write" : "give one name" );
	}
	toolError error = { { 0 } };
	toolGltf* gltf = toolMakeSample( argv[optind], &error );
	bool good = gltf != NULL && toolWriteGltf( gltf, output, &error );
	toolFreeGltf( gltf );
	return good ? tool_done : toolReportFailure( &error );
}
