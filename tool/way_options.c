// SPDX-License-Identifier: MIT
// Reads where a character goes, and finds a way where the user does not say. World of the ground, metres, Y up.
#include "way_options.h"

#include "command.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_DISTANCE 4.0 // m

// -------------------------------------------------------------------------------------------------------- reading

static toolPlace toolMakePlace( const double point[3], int count )
{
	return ( toolPlace ){ point[0], count == 3 ? point[1] : (double)NAN, point[count - 1] };
}

static bool toolReadPath( const char* text, toolWayOptions* way )
{
	char* copy = toolCopyString( text );
	bool good = true;
	bool leads = false;
	way->pathCount = 0;
	for ( char* word = strtok( copy, " \t\n;" ); word != NULL && good; word = strtok( NULL, " \t\n;" ) )
	{
		double point[3];
		int count = toolParsePoint( word, point );
		good = count > 0;
		if ( good )
		{
			way->path = toolGrow( way->path, (size_t)way->pathCount + 1, sizeof *way->path );
			toolPlace* place = way->path + way->pathCount++;
			*place = toolMakePlace( point, count );
			leads = leads || place->x != way->path[0].x || place->z != way->path[0].z;
		}
	}
	free( copy );
	return good && leads;
}

static bool toolReadStart( const char* text, toolWayOptions* way )
{
	double point[3];
	int count = toolParsePoint( text, point );
	way->hasStart = count > 0;
	if ( way->hasStart )
	{
		way->start = toolMakePlace( point, count );
	}
	return way->hasStart;
}

const char* toolReadWayOption( int option, const char* text, toolWayOptions* way )
{
	switch ( option )
	{
	case tool_optionPath:
		return toolReadPath( text, way ) ? NULL : "--path is no list of two places or more, such as \"0,0 0,4\"";
	case tool_optionStart:
		return toolReadStart( text, way ) ? NULL : "--start is no place such as \"1.5,-2\" or \"1.5,0.3,-2\"";
	case tool_optionHeading:
		way->hasHeading = true;
		return toolParseRange( text, -1e6, 1e6, &way->heading ) ? NULL : "--heading is no number of degrees";
	case tool_optionDistance:
		way->hasDistance = true;
		return toolParseRange( text, 1e-3, 1e5, &way->distance ) ? NULL : "--distance is no length in metres";
	default:
		return "there is no such option";
	}
}

const char* toolCheckWayOptions( const toolWayOptions* way )
{
	bool straight = way->hasStart || way->hasHeading || way->hasDistance;
	return way->pathCount > 0 && straight ? "--path and --start, --heading or --distance exclude each other" : NULL;
}

void toolFreeWayOptions( toolWayOptions* way )
{
	free( way->path );
	*way = ( toolWayOptions ){ 0 };
}

// --------------------------------------------------------------------------------------------------------- laying

/// How far a clip goes where the user does not say.
static double toolGetDistance( const toolWayOptions* way, const toolTravel* travel, const toolBakeDef* def )
{
	double own = (double)soleLength( travel->strideVelocity );
	if ( way->hasDistance )
	{
		return way->distance;
	}
	if ( toolIsStanding( travel ) && travel->rootMotion == false && def->speed <= 0.0 )
	{
		return 0.0;
	}
	if ( def->duration > 0.0 )
	{
		return def->duration * ( def->speed > 0.0 ? def->speed : own );
	}
	bool once = travel->rootMotion && travel->loops == false;
	return once ? (double)soleLength( travel->loop.translation ) : DEFAULT_DISTANCE;
}

bool toolLayWay( const toolWayOptions* way, const toolCharacter* character, const toolTravel* travel,
    const toolGroundSource* ground, toolPlace* start, toolBakeDef* def, toolError* error )
{
	def->heading = way->heading;
	def->distance = toolGetDistance( way, travel, def );
	def->path = start;
	def->pathCount = 1;
	if ( way->pathCount > 0 )
	{
		def->path = way->path;
		def->pathCount = way->pathCount;
		return true;
	}
	if ( way->hasStart )
	{
		*start = way->start;
		return true;
	}
	// A capture goes its own way, from about the middle; what loops can be led.
	bool led = travel->rootMotion == false || travel->loops;
	if ( ground->path != NULL && led && way->hasHeading == false && way->hasDistance == false )
	{
		def->path = ground->path;
		def->pathCount = ground->pathCount;
		return true;
	}
	double step = (double)TOOL_STEP_HEIGHT * toolLegLength( character );
	return toolChooseStart( ground->ground, ground->name, def->heading, def->distance, step, start, error );
}
