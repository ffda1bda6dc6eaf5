// SPDX-License-Identifier: MIT
// sole settings: every tunable with its unit, range, default and one sentence, from the library's own table.
#define _POSIX_C_SOURCE 200809L
#include "command.h"
#include "settings_file.h"

#include <getopt.h>
#include <stdlib.h>
#include <string.h>

static const char* const toolSettingsHelp =
    "usage: sole settings [--json | --markdown]\n"
    "\n"
    "Lists every setting with its unit, range, default and what it does. L is the leg length, hip to ankle.\n"
    "\n"
    "  --json      the defaults as a settings file, to be changed and given to 'sole bake --settings'\n"
    "  --markdown  the table of docs/settings.md\n";

static void toolPrintRow( const soleSettingInfo* info, bool markdown )
{
	if ( info->type == sole_settingMask )
	{
		printf( markdown ? "| `%s` | %s | bits | all | %s |\n" : "%-26s %-5s bits            all        %s\n",
		    info->name, info->unit, info->text );
		return;
	}
	printf( markdown ? "| `%s` | %s | %g to %g | %.4g | %s |\n" : "%-26s %-5s %-5g to %-6g %-10.4g %s\n", info->name,
	    info->unit, info->minimum, info->maximum, info->defaultValue, info->text );
}

int toolRunSettings( int argc, char** argv )
{
	static const struct option options[] = { { "json", no_argument, NULL, 'j' }, { "markdown", no_argument, NULL, 'm' },
		{ "help", no_argument, NULL, 'h' }, { NULL, 0, NULL, 0 } };
	int form = 't';
	optind = 1;
	opterr = 0;
	for ( int option; ( option = getopt_long( argc, argv, "", options, NULL ) ) != -1; )
	{
		if ( option == 'h' )
		{
			fputs( toolSettingsHelp, stdout );
			return tool_done;
		}
		if ( option == '?' )
		{
			return toolReportUsage( "settings", "there is no such option" );
		}
		form = option;
	}
	if ( optind < argc )
	{
		return toolReportUsage( "settings", "it takes no file" );
	}
	if ( form == 'j' )
	{
		soleSettings settings = soleDefaultSettings();
		char* text = toolFormatSettings( &settings );
		fputs( text, stdout );
		free( text );
		return tool_done;
	}
	if ( form == 'm' )
	{
		fputs(
		    "# Settings\n\nWritten by `sole settings --markdown` from the table in src/rig/settings.c: change it there.\n"
		    "L is the leg length, hip to ankle along the bones. Angles are radians.\n\n"
		    "| setting | unit | range | default | what it does |\n|---|---|---|---|---|\n",
		    stdout );
	}
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		toolPrintRow( infos + i, form == 'm' );
	}
	return tool_done;
}
