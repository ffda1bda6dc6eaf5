// SPDX-License-Identifier: MIT
// sole sample: writes an embedded sample, a character or a ground, as a file.
#include "command.h"
#include "scenario.h"
#include "source.h"

#include <getopt.h>

static const char toolHelp[] = "usage: sole sample NAME -o FILE.glb\n"
                               "       sole sample --list\n"
                               "\n"
                               "Writes an embedded sample: a character to place, or a ground to walk on.\n"
                               "\n"
                               "  -o, --output FILE   where to write, .glb or .gltf\n"
                               "  --list              print the names of all samples\n";

static void toolListSamples( void )
{
	puts( "mannequin    a skinned figure with clips: idle, walk, run, turn, strafe, crouch" );
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
		{ "help", no_argument, NULL, 'h' },
		{ NULL, 0, NULL, 0 },
	};
	const char* output = NULL;
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
			toolListSamples();
			return tool_done;
		case 'h':
			fputs( toolHelp, stdout );
			return tool_done;
		default:
			return toolReportUsage( "sample", "an option is unknown or lacks its value" );
		}
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
