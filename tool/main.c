// SPDX-License-Identifier: MIT
// The program: finds the command and runs it.
#include "command.h"

#include <string.h>

typedef struct toolCommand
{
	const char* name;
	const char* summary;
	int ( *run )( int argc, char** argv );
} toolCommand;

static const toolCommand toolCommands[] = {
	{ "sample", "writes an embedded sample: a character or a ground", toolRunSample },
	{ "inspect", "legs, soles, clips and problems of a character", toolRunInspect },
	{ "bake", "plays a clip over a ground with its feet placed, into a new clip of the file", toolRunBake },
	{ "measure", "prints how well the feet of a clip stand on a ground", toolRunMeasure },
	{ "compare", "prints the figures of all methods side by side", toolRunCompare },
	{ "report", "writes one page that shows a clip before and after, in 3D, with plots and figures", toolRunReport },
	{ "label", "prints when which foot is in contact, per clip", toolRunLabel },
	{ "replay", "plays a recorded trace and compares it bit by bit", toolRunReplay },
	{ "settings", "lists every tunable with its unit, range and default", toolRunSettings },
	{ NULL, NULL, NULL },
};

static void toolPrintHelp( FILE* stream )
{
	fputs( "usage: sole COMMAND ...\n\nSole places the feet of animated characters on the ground.\n\n", stream );
	for ( const toolCommand* command = toolCommands; command->name != NULL; ++command )
	{
		fprintf( stream, "  %-9s %s\n", command->name, command->summary );
	}
	fputs( "\n'sole COMMAND --help' explains each; 'sole --version' tells the version.\n", stream );
}

int main( int argc, char** argv )
{
	if ( argc < 2 )
	{
		toolPrintHelp( stderr );
		return tool_wrongUsage;
	}
	if ( strcmp( argv[1], "--help" ) == 0 || strcmp( argv[1], "-h" ) == 0 || strcmp( argv[1], "help" ) == 0 )
	{
		toolPrintHelp( stdout );
		return tool_done;
	}
	if ( strcmp( argv[1], "--version" ) == 0 )
	{
		soleVersion version = soleGetVersion();
		printf( "sole %d.%d.%d\n", version.major, version.minor, version.patch );
		return tool_done;
	}
	for ( const toolCommand* command = toolCommands; command->name != NULL; ++command )
	{
		if ( strcmp( argv[1], command->name ) == 0 )
		{
			return command->run( argc - 1, argv + 1 );
		}
	}
	fprintf( stderr, "sole: %s: there is no such command: see 'sole --help'\n", argv[1] );
	return tool_wrongUsage;
}
