// SPDX-License-Identifier: MIT
// Reads what the commands that make tables are told alike, and opens it.
#include "table_input.h"

#include "bake_options.h"
#include "command.h"

#include <stdlib.h>

toolTableInput toolDefaultTableInput( void )
{
	return ( toolTableInput ){ .scale = 1.0 };
}

const char* toolReadTableInput( int option, const char* text, toolTableInput* input )
{
	switch ( option )
	{
	case tool_optionTableClip:
		input->clip = text;
		return NULL;
	case tool_optionTableClips:
		input->clips = text;
		return NULL;
	case tool_optionTableSettings:
		input->settings = text;
		return NULL;
	case tool_optionTableScale:
		return toolParseRange( text, 1e-6, 1e6, &input->scale ) ? NULL : "--scale needs a number above zero";
	case '?':
		return "an option is unknown or lacks its value";
	default:
		return toolReadWayOption( option, text, &input->way );
	}
}

void toolAddGround( const char* name, toolTableInput* input )
{
	input->grounds = toolGrow( input->grounds, (size_t)input->groundCount + 1, sizeof *input->grounds );
	input->grounds[input->groundCount++] = toolCopyString( name );
}

const char* toolAddMethod( const char* name, toolTableInput* input )
{
	return toolReadMethod( name, &input->methods, &input->methodCount );
}

void toolFreeTableInput( toolTableInput* input )
{
	for ( int32_t i = 0; i < input->groundCount; ++i )
	{
		free( input->grounds[i] );
	}
	free( input->grounds );
	free( input->methods );
	toolFreeWayOptions( &input->way );
	*input = ( toolTableInput ){ 0 };
}

bool toolOpenTableFiles( const toolTableInput* input, toolTableFiles* files, toolError* error )
{
	files->settings = soleDefaultSettings();
	if ( ( input->settings != NULL && toolReadSettings( input->settings, &files->settings, error ) == false ) ||
	    toolOpenCharacter( input->character, &files->gltf, error ) == false ||
	    ( input->clips != NULL && toolOpenCharacter( input->clips, &files->clipsGltf, error ) == false ) )
	{
		return false;
	}
	const toolModel* model = toolGltf_GetModel( files->gltf );
	const toolModel* clipModel = files->clipsGltf != NULL ? toolGltf_GetModel( files->clipsGltf ) : model;
	const char* clipFile = input->clips != NULL ? input->clips : input->character;
	if ( toolMakeCharacter( model, input->character, (float)input->scale, &files->character, error ) == false ||
	    toolBindNamedClip( &files->character, clipModel, clipFile, input->clip, &files->bound, error ) == false )
	{
		return false;
	}
	files->travel = toolFindTravel( &files->character, &files->bound );
	return true;
}

void toolCloseTableFiles( toolTableFiles* files )
{
	toolFreeBoundClip( &files->bound );
	toolFreeCharacter( &files->character );
	toolFreeGltf( files->clipsGltf );
	toolFreeGltf( files->gltf );
	*files = ( toolTableFiles ){ 0 };
}

toolTableDef toolMakeTableDef( const toolTableInput* input, const toolTableFiles* files )
{
	return ( toolTableDef ){
		.character = &files->character,
		.bound = &files->bound,
		.travel = &files->travel,
		.settings = &files->settings,
		.grounds = (const char* const*)input->grounds,
		.groundCount = input->groundCount,
		.methods = input->methods,
		.methodCount = input->methodCount,
		.way = &input->way,
	};
}
