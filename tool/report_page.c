// SPDX-License-Identifier: MIT
// Puts data into the template of a report, at the one place that is marked there: JSON and files as base64, each the
// text of a script element that a browser does not run. Such an element ends at the first "</script", and a "<!--" in
// it changes what comes after; both begin with '<', which in JSON stands in strings only and may be written \u003c.
#define _POSIX_C_SOURCE 200809L // readlink
#include "report_page.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// viewer/report/index.html has it.
#define MARK "<!--sole-report-data-->"
// From the folder of the program, as cmake/install.cmake lays them out.
#define INSTALLED "../share/sole/report.html"

// -------------------------------------------------------------------------------------------------------- template

/// The template that was installed with the program. NULL where its own place is not known.
static char* toolFindInstalledTemplate( void )
{
	char self[4096];
	ssize_t length = readlink( "/proc/self/exe", self, sizeof self - 1 );
	self[length > 0 ? length : 0] = 0;
	char* slash = strrchr( self, '/' );
	return slash != NULL ? toolFormat( "%.*s/%s", (int)( slash - self ), self, INSTALLED ) : NULL;
}

static bool toolReadInstalledTemplate( char** page, toolError* error )
{
	char* path = toolFindInstalledTemplate();
	bool there = path != NULL && access( path, R_OK ) == 0;
	bool good = there ? toolReadReportTemplate( path, page, error )
	                  : toolFail( error,
	                        "%s: the template of reports is not there: run scripts/build_report.sh in Sole's sources "
	                        "and give --template build/report/template.html",
	                        path != NULL ? path : INSTALLED );
	free( path );
	return good;
}

bool toolReadReportTemplate( const char* path, char** page, toolError* error )
{
	if ( path == NULL )
	{
		return toolReadInstalledTemplate( page, error );
	}
	uint8_t* bytes;
	size_t byteCount;
	if ( toolReadFile( path, &bytes, &byteCount, error ) == false )
	{
		return false;
	}
	const char* mark = strstr( (const char*)bytes, MARK );
	if ( mark == NULL || strstr( mark + 1, MARK ) != NULL || strlen( (const char*)bytes ) != byteCount )
	{
		free( bytes );
		return toolFail( error, "%s: is no template of a report: build one with scripts/build_report.sh", path );
	}
	*page = (char*)bytes;
	return true;
}

// ------------------------------------------------------------------------------------------------------------ fill

/// Text that grows at its end.
typedef struct toolPageText
{
	char* text;
	size_t count;
	size_t capacity;
} toolPageText;

static void toolAddBytes( toolPageText* page, const char* bytes, size_t count )
{
	if ( page->count + count >= page->capacity )
	{
		page->capacity = 2 * ( page->count + count ) + 1;
		page->text = toolGrow( page->text, page->capacity, 1 );
	}
	memcpy( page->text + page->count, bytes, count );
	page->count += count;
}

static void toolAddString( toolPageText* page, const char* text )
{
	toolAddBytes( page, text, strlen( text ) );
}

static void toolAddHarmlessJson( toolPageText* page, const char* json )
{
	while ( *json != 0 )
	{
		size_t plain = strcspn( json, "<" );
		toolAddBytes( page, json, plain );
		json += plain;
		if ( *json == '<' )
		{
			toolAddString( page, "\\u003c" );
			++json;
		}
	}
}

static void toolAddBase64( toolPageText* page, const uint8_t* bytes, size_t count )
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	for ( size_t i = 0; i < count; i += 3 )
	{
		size_t left = count - i;
		uint32_t second = left > 1 ? bytes[i + 1] : 0u;
		uint32_t third = left > 2 ? bytes[i + 2] : 0u;
		uint32_t all = (uint32_t)bytes[i] << 16 | second << 8 | third;
		const char group[4] = { digits[all >> 18], digits[all >> 12 & 63], left > 1 ? digits[all >> 6 & 63] : '=',
			left > 2 ? digits[all & 63] : '=' };
		toolAddBytes( page, group, sizeof group );
	}
}

static void toolAddFile( toolPageText* page, const char* id, const uint8_t* bytes, size_t count )
{
	toolAddString( page, "<script type=\"text/plain\" id=\"" );
	toolAddString( page, id );
	toolAddString( page, "\">" );
	toolAddBase64( page, bytes, count );
	toolAddString( page, "</script>\n" );
}

char* toolFillReport( const char* page, const toolReportData* data, size_t* byteCount )
{
	const char* mark = strstr( page, MARK );
	toolPageText text = { 0 };
	toolAddBytes( &text, page, (size_t)( mark - page ) );
	toolAddString( &text, "<script type=\"application/json\" id=\"report\">" );
	toolAddHarmlessJson( &text, data->json );
	toolAddString( &text, "</script>\n" );
	toolAddFile( &text, "character", data->character, data->characterCount );
	toolAddFile( &text, "ground", data->ground, data->groundCount );
	toolAddString( &text, mark + strlen( MARK ) );
	*byteCount = text.count;
	return text.text;
}
