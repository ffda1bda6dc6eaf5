// SPDX-License-Identifier: MIT
// Values of untrusted JSON with their limits checked, and messages that stay on one line whatever a file puts in.
#include "gltf_internal.h"

#include <json.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

static void toolCleanLine( char* text )
{
	while ( *text != 0 )
	{
		size_t length = toolUtf8Length( text );
		unsigned char c = (unsigned char)*text;
		// C1 controls are two bytes in UTF-8 and steer terminals as well
		bool control = c < 0x20 || c == 0x7f || ( c == 0xc2 && (unsigned char)text[1] < 0xa0 );
		if ( length == 0 || control )
		{
			for ( size_t i = 0; i < ( length > 1 ? length : 1 ); ++i )
			{
				text[i] = '?';
			}
		}
		text += length > 0 ? length : 1;
	}
}

bool toolFailFile( toolError* error, const char* path, const char* format, ... )
{
	if ( error == NULL )
	{
		return false;
	}
	va_list arguments;
	va_start( arguments, format );
	int count = snprintf( error->text, sizeof error->text, "%s: ", path );
	size_t used = count < 0 ? 0 : (size_t)count;
	if ( used < sizeof error->text )
	{
		vsnprintf( error->text + used, sizeof error->text - used, format, arguments );
	}
	va_end( arguments );
	toolCleanLine( error->text );
	return false;
}

toolOwner toolNameOwner( const char* list, size_t index, const char* name )
{
	toolOwner owner = { { 0 } };
	if ( name != NULL && *name != 0 )
	{
		snprintf( owner.text, sizeof owner.text, "%s[%zu] '%.48s'", list, index, name );
	}
	else
	{
		snprintf( owner.text, sizeof owner.text, "%s[%zu]", list, index );
	}
	return owner;
}

/// Members of all objects. Nests at most TOOL_JSON_DEPTH deep, as was checked before.
static size_t toolCountMembers( json_object* value )
{
	size_t count = 0;
	if ( json_object_is_type( value, json_type_object ) )
	{
		json_object_object_foreach( value, key, member )
		{
			(void)key;
			count += 1 + toolCountMembers( member );
		}
	}
	else if ( json_object_is_type( value, json_type_array ) )
	{
		for ( size_t i = 0; i < json_object_array_length( value ); ++i )
		{
			count += toolCountMembers( json_object_array_get_idx( value, i ) );
		}
	}
	return count;
}

json_object* toolParseGltfJson( const char* path, const char* text, size_t byteCount, toolError* error )
{
	toolJsonSummary summary;
	if ( toolCheckJson( text, byteCount, &summary ) == false )
	{
		toolFailFile(
		    error, path, "its JSON is broken at byte %zu (%s): export it again", summary.badAt, summary.problem );
		return NULL;
	}
	size_t length = summary.root.end - summary.root.begin;
	if ( text[summary.root.begin] != '{' || length > (size_t)INT32_MAX )
	{
		toolFailFile( error, path, "its JSON is no object: export it again" );
		return NULL;
	}
	json_tokener* tokener = json_tokener_new_ex( TOOL_JSON_DEPTH + 2 );
	json_object* root =
	    tokener == NULL ? NULL : json_tokener_parse_ex( tokener, text + summary.root.begin, (int)length );
	if ( tokener != NULL )
	{
		json_tokener_free( tokener );
	}
	if ( root == NULL )
	{
		toolFailFile( error, path, "its JSON cannot be read: export it again" );
		return NULL;
	}
	if ( toolCountMembers( root ) != summary.memberCount )
	{
		toolFailFile( error, path, "its JSON gives a key twice in one object: export it again" );
		json_object_put( root );
		return NULL;
	}
	return root;
}

json_object* toolGetMember( json_object* object, const char* key )
{
	json_object* member = NULL;
	if ( json_object_is_type( object, json_type_object ) )
	{
		json_object_object_get_ex( object, key, &member );
	}
	return member;
}

bool toolGetList( const toolGltfReader* reader, json_object* object, const char* owner, const char* key,
    json_object** list, int32_t* count )
{
	*list = toolGetMember( object, key );
	*count = 0;
	if ( *list == NULL )
	{
		return true;
	}
	if ( json_object_is_type( *list, json_type_array ) == 0 || json_object_array_length( *list ) > INT32_MAX )
	{
		*list = NULL;
		return toolFailFile( reader->error, reader->path, "%s%s is no list: export it again", owner, key );
	}
	*count = (int32_t)json_object_array_length( *list );
	return true;
}

bool toolGetSize(
    const toolGltfReader* reader, json_object* object, const char* owner, const char* key, size_t limit, size_t* value )
{
	json_object* member = toolGetMember( object, key );
	if ( member == NULL )
	{
		return true;
	}
	bool number = json_object_is_type( member, json_type_int ) || json_object_is_type( member, json_type_double );
	double wanted = number ? json_object_get_double( member ) : -1.0;
	// also false for NaN; up to 2^53 a double is exact
	if ( !( wanted >= 0.0 && wanted <= 9007199254740992.0 ) || floor( wanted ) != wanted || wanted > (double)limit )
	{
		return toolFailFile( reader->error, reader->path, "%s has a %s that cannot be: export it again", owner, key );
	}
	*value = (size_t)wanted;
	return true;
}

bool toolGetIndex( const toolGltfReader* reader, json_object* object, const char* owner, const char* key, int32_t count,
    int32_t* index )
{
	*index = SOLE_NONE;
	size_t value = SIZE_MAX;
	if ( toolGetSize( reader, object, owner, key, SIZE_MAX >> 12, &value ) == false )
	{
		return false;
	}
	if ( value == SIZE_MAX )
	{
		return true;
	}
	if ( value >= (size_t)count )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s names %s %zu of %d: export it again", owner, key, value, count );
	}
	*index = (int32_t)value;
	return true;
}

bool toolGetFloats( const toolGltfReader* reader, json_object* object, const char* owner, const char* key,
    int32_t count, float* values, bool* found )
{
	json_object* member = toolGetMember( object, key );
	if ( found != NULL )
	{
		*found = member != NULL;
	}
	if ( member == NULL )
	{
		return true;
	}
	bool list = json_object_is_type( member, json_type_array ) != 0;
	bool good = list ? json_object_array_length( member ) == (size_t)count : count == 1;
	for ( int32_t i = 0; good && i < count; ++i )
	{
		json_object* item = list ? json_object_array_get_idx( member, (size_t)i ) : member;
		good = json_object_is_type( item, json_type_int ) || json_object_is_type( item, json_type_double );
		double value = good ? json_object_get_double( item ) : 0.0;
		good = good && fabs( value ) <= (double)3.4028234e38f;
		values[i] = good ? (float)value : 0.0f;
	}
	if ( good == false )
	{
		return toolFailFile( reader->error, reader->path, "%s has a %s that is not %d finite numbers: export it again",
		    owner, key, count );
	}
	return true;
}

const char* toolGetText( json_object* object, const char* key )
{
	json_object* member = toolGetMember( object, key );
	return json_object_is_type( member, json_type_string ) ? json_object_get_string( member ) : "";
}

bool toolGetFlag( json_object* object, const char* key )
{
	json_object* member = toolGetMember( object, key );
	return json_object_is_type( member, json_type_boolean ) && json_object_get_boolean( member );
}

const char* toolFindCompression( json_object* root, const char* list )
{
	static const char* const names[] = { "KHR_draco_mesh_compression", "EXT_meshopt_compression",
		"KHR_meshopt_compression" };
	json_object* extensions = toolGetMember( root, list );
	if ( json_object_is_type( extensions, json_type_array ) == 0 )
	{
		return NULL;
	}
	for ( size_t i = 0; i < json_object_array_length( extensions ); ++i )
	{
		json_object* item = json_object_array_get_idx( extensions, i );
		const char* text = json_object_is_type( item, json_type_string ) ? json_object_get_string( item ) : "";
		for ( size_t j = 0; j < sizeof names / sizeof names[0]; ++j )
		{
			if ( strcmp( text, names[j] ) == 0 )
			{
				return names[j];
			}
		}
	}
	return NULL;
}
