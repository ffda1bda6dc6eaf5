// SPDX-License-Identifier: MIT
// Reads what to bake from a command line and says what is wrong with it.
#include "bake_options.h"

#include "command.h"

#include <stdlib.h>
#include <string.h>

toolBakeOptions toolDefaultBakeOptions( void )
{
	return ( toolBakeOptions ){ .fps = toolDefaultBakeDef().fps, .scale = 1.0f };
}

void toolPrintMethods( void )
{
	for ( const toolMethod* method = toolGetMethods(); method->name != NULL; ++method )
	{
		printf( "  %-18s  %s\n", method->name, method->summary );
	}
}

const char* toolReadMethod( const char* name, const toolMethod*** methods, int32_t* count )
{
	const toolMethod* method = toolFindMethod( name );
	if ( method == NULL )
	{
		return "--method names no method";
	}
	for ( int32_t i = 0; i < *count; ++i )
	{
		if ( ( *methods )[i] == method )
		{
			return "--method names one method twice";
		}
	}
	*methods = toolGrow( *methods, (size_t)*count + 1, sizeof **methods );
	( *methods )[( *count )++] = method;
	return NULL;
}

static const char* toolReadClipName( const char* name, toolBakeOptions* options )
{
	for ( int32_t i = 0; i < options->clipCount; ++i )
	{
		if ( strcmp( options->clips[i], name ) == 0 )
		{
			return "--clip names one clip twice";
		}
	}
	options->clips = toolGrow( options->clips, (size_t)options->clipCount + 1, sizeof *options->clips );
	options->clips[options->clipCount++] = name;
	return NULL;
}

static const char* toolReadScale( const char* text, toolBakeOptions* options )
{
	double scale = 1.0;
	options->autoScale = strcmp( text, "auto" ) == 0;
	bool good = options->autoScale || toolParseRange( text, 1e-6, 1e6, &scale );
	options->scale = (float)scale;
	return good ? NULL : "--scale is no number above zero, nor 'auto'";
}

// @return what is wrong, or NULL.
static const char* toolReadNumberOption( int option, const char* text, toolBakeOptions* options )
{
	switch ( option )
	{
	case tool_optionSpeed:
		return toolParseRange( text, 1e-3, 100.0, &options->speed ) ? NULL : "--speed is no speed in m/s up to 100";
	case tool_optionDuration:
		return toolParseRange( text, 1e-3, 3600.0, &options->duration ) ? NULL
		                                                                : "--duration is no time in seconds up to 3600";
	case tool_optionFps:
		return toolParseRange( text, 1.0, 1000.0, &options->fps ) ? NULL : "--fps is no rate from 1 to 1000";
	default:
		return toolReadWayOption( option, text, &options->way );
	}
}

const char* toolReadBakeOption( int option, const char* text, toolBakeOptions* options )
{
	switch ( option )
	{
	case '?':
		return "an option is unknown or lacks its value";
	case tool_optionGround:
		options->ground = text;
		return NULL;
	case 'o':
		options->output = text;
		return NULL;
	case tool_optionClip:
		return toolReadClipName( text, options );
	case tool_optionClips:
		options->clipsFile = text;
		return NULL;
	case tool_optionMethod:
		return toolReadMethod( text, &options->methods, &options->methodCount );
	case tool_optionSettings:
		options->settingsFile = text;
		return NULL;
	case tool_optionScale:
		return toolReadScale( text, options );
	default:
		return toolReadNumberOption( option, text, options );
	}
}

const char* toolCheckBakeOptions( int rest, const toolBakeOptions* options )
{
	if ( rest != 1 )
	{
		return rest == 0 ? "the character is missing" : "one character at a time";
	}
	if ( options->ground == NULL )
	{
		return "--ground is missing";
	}
	if ( options->output == NULL )
	{
		return "-o is missing: where to write";
	}
	return toolCheckWayOptions( &options->way );
}

void toolFreeBakeOptions( toolBakeOptions* options )
{
	free( options->clips );
	free( options->methods );
	toolFreeWayOptions( &options->way );
	*options = ( toolBakeOptions ){ 0 };
}
