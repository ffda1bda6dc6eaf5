// SPDX-License-Identifier: MIT
// Settings as JSON, over the library's own table of settings: names, types and ranges have no second place here.
#include "settings_file.h"

#include <json-c/json.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const soleSettingInfo* toolFindSetting( const char* stage, const char* field )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	size_t length = strlen( stage );
	for ( int32_t i = 0; i < count; ++i )
	{
		const char* name = infos[i].name;
		if ( strncmp( name, stage, length ) == 0 && name[length] == '.' && strcmp( name + length + 1, field ) == 0 )
		{
			return infos + i;
		}
	}
	return NULL;
}

static bool toolIsStage( const char* stage )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	size_t length = strlen( stage );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( strncmp( infos[i].name, stage, length ) == 0 && infos[i].name[length] == '.' )
		{
			return true;
		}
	}
	return false;
}

static bool toolReadField( const char* path, const char* stage, const char* field, struct json_object* value,
    soleSettings* settings, toolError* error )
{
	const soleSettingInfo* info = toolFindSetting( stage, field );
	if ( info == NULL )
	{
		return toolFail(
		    error, "%s: %.40s.%.40s is no setting: 'sole bake --print-settings' lists them all", path, stage, field );
	}
	bool whole = info->type != sole_settingFloat;
	bool integer = json_object_is_type( value, json_type_int );
	if ( integer == false && ( whole || json_object_is_type( value, json_type_double ) == false ) )
	{
		return toolFail( error, "%s: %s is not a %snumber: give one from %g to %g%s%s", path, info->name,
		    whole ? "whole " : "", info->minimum, info->maximum, info->unit[0] != 0 ? " " : "", info->unit );
	}
	double number = json_object_get_double( value );
	// A range's end such as 0.87 is read as it is written, but kept as a float.
	if ( !( number >= info->minimum - 1e-6 && number <= info->maximum + 1e-6 ) )
	{
		return toolFail( error, "%s: %s is %g, out of range: give a value from %g to %g%s%s", path, info->name, number,
		    info->minimum, info->maximum, info->unit[0] != 0 ? " " : "", info->unit );
	}
	soleSettings_Set( settings, info, number );
	return true;
}

static bool toolReadStages( const char* path, struct json_object* root, soleSettings* settings, toolError* error )
{
	if ( json_object_is_type( root, json_type_object ) == false )
	{
		return toolFail( error, "%s: is not a JSON object: write { \"probe\": { \"radius\": 0.05 } }", path );
	}
	json_object_object_foreach( root, stage, fields )
	{
		if ( toolIsStage( stage ) == false )
		{
			return toolFail(
			    error, "%s: %.40s is no group of settings: they are probe, support, contact and so on", path, stage );
		}
		if ( json_object_is_type( fields, json_type_object ) == false )
		{
			return toolFail( error, "%s: %.40s is not an object: write { \"%.40s\": { ... } }", path, stage, stage );
		}
		json_object_object_foreach( fields, field, value )
		{
			if ( toolReadField( path, stage, field, value, settings, error ) == false )
			{
				return false;
			}
		}
	}
	return true;
}

static int toolLineAt( const char* text, size_t offset )
{
	int line = 1;
	for ( size_t i = 0; i < offset; ++i )
	{
		line += text[i] == '\n' ? 1 : 0;
	}
	return line;
}

bool toolParseSettings( const char* text, size_t byteCount, const char* path, soleSettings* settings, toolError* error )
{
	if ( byteCount > INT_MAX )
	{
		return toolFail( error, "%s: is too large for settings: give a small JSON file", path );
	}
	struct json_tokener* tokener = json_tokener_new();
	json_tokener_set_flags( tokener, JSON_TOKENER_STRICT );
	struct json_object* root = json_tokener_parse_ex( tokener, text, (int)byteCount );
	enum json_tokener_error fault = json_tokener_get_error( tokener );
	size_t end = json_tokener_get_parse_end( tokener );
	bool rest = false;
	for ( size_t i = end; i < byteCount; ++i )
	{
		rest = rest || strchr( " \t\r\n", text[i] ) == NULL;
	}
	bool good = fault == json_tokener_success && rest == false;
	if ( good == false )
	{
		const char* what = fault == json_tokener_continue
		    ? "it ends early"
		    : ( rest && fault == json_tokener_success ? "something follows it" : json_tokener_error_desc( fault ) );
		toolFail( error, "%s: is no JSON, line %d (%s): correct it", path, toolLineAt( text, end ), what );
	}
	json_tokener_free( tokener );
	soleSettings changed = *settings;
	good = good && toolReadStages( path, root, &changed, error );
	json_object_put( root );
	if ( good )
	{
		*settings = changed;
	}
	return good;
}

bool toolReadSettings( const char* path, soleSettings* settings, toolError* error )
{
	uint8_t* bytes;
	size_t byteCount;
	if ( toolReadFile( path, &bytes, &byteCount, error ) == false )
	{
		return false;
	}
	bool good = toolParseSettings( (const char*)bytes, byteCount, path, settings, error );
	free( bytes );
	return good;
}

// The shortest text that is read as the same value.
static void toolFormatNumber( const soleSettingInfo* info, double value, char text[32] )
{
	for ( int digits = 1; digits <= 17; ++digits )
	{
		snprintf( text, 32, "%.*g", digits, value );
		double read = strtod( text, NULL );
		bool same = info->type == sole_settingFloat ? (float)read == (float)value : read == value;
		// A mask in powers of ten would be read as no whole number.
		if ( same && ( info->type == sole_settingFloat || strchr( text, 'e' ) == NULL ) )
		{
			return;
		}
	}
}

char* toolFormatSettings( const soleSettings* settings )
{
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	char* text = toolCopyString( "{" );
	size_t stageLength = 0;
	const char* stage = "";
	for ( int32_t i = 0; i < count; ++i )
	{
		const char* dot = strchr( infos[i].name, '.' );
		size_t length = dot != NULL ? (size_t)( dot - infos[i].name ) : 0;
		bool same = i > 0 && length == stageLength && strncmp( stage, infos[i].name, length ) == 0;
		char number[32];
		toolFormatNumber( infos + i, soleSettings_Get( settings, infos + i ), number );
		char* next = same ? toolFormat( "%s,\n\t\t\"%s\": %s", text, infos[i].name + length + 1, number )
		                  : toolFormat( "%s%s\n\t\"%.*s\": {\n\t\t\"%s\": %s", text, i > 0 ? "\n\t}," : "", (int)length,
		                        infos[i].name, infos[i].name + length + 1, number );
		free( text );
		text = next;
		stage = infos[i].name;
		stageLength = length;
	}
	char* whole = toolFormat( "%s%s\n}\n", text, count > 0 ? "\n\t}" : "" );
	free( text );
	return whole;
}
