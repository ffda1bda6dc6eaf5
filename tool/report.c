// SPDX-License-Identifier: MIT
// Makes the JSON of a report. Numbers along time are shortened to what a plot can show; figures stay as measured.
#include "report.h"

#include "columns.h"
#include "curves.h"
#include "figures_text.h"

#include <json-c/json.h>
#include <math.h>
#include <stdlib.h>

// Digits behind the point, of what is drawn along time.
#define LENGTH_DIGITS 5
#define ANGLE_DIGITS 5
#define ACCELERATION_DIGITS 2

static void toolAddText( struct json_object* to, const char* name, const char* text )
{
	json_object_object_add( to, name, json_object_new_string( text ) );
}

/// Null where there is none: JSON knows no other.
static struct json_object* toolFiniteToJson( double value )
{
	return isfinite( value ) ? json_object_new_double( value ) : NULL;
}

static struct json_object* toolShortToJson( double value, int digits )
{
	char text[64];
	snprintf( text, sizeof text, "%.*f", digits, value );
	return isfinite( value ) ? json_object_new_double_s( value, text ) : NULL;
}

// ---------------------------------------------------------------------------------------------------- who and where

static struct json_object* toolLegsToJson( const toolCharacter* character )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( character->rig ); ++leg )
	{
		soleLegDef def = soleRig_GetLeg( character->rig, leg );
		struct json_object* joints = json_object_new_array();
		for ( int32_t k = 0; k < def.jointCount; ++k )
		{
			json_object_array_add( joints, json_object_new_string( character->names[def.joints[k]] ) );
		}
		struct json_object* entry = json_object_new_object();
		toolAddText( entry, "name", def.name != NULL ? def.name : "" );
		json_object_object_add( entry, "joints", joints );
		json_object_array_add( list, entry );
	}
	return list;
}

static struct json_object* toolChangesToJson( const soleSettings* settings )
{
	struct json_object* list = json_object_new_array();
	soleSettings defaults = soleDefaultSettings();
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		double value = soleSettings_Get( settings, infos + i );
		double usual = soleSettings_Get( &defaults, infos + i );
		if ( value == usual )
		{
			continue;
		}
		struct json_object* entry = json_object_new_object();
		toolAddText( entry, "name", infos[i].name );
		toolAddText( entry, "unit", infos[i].unit );
		json_object_object_add( entry, "value", json_object_new_double( value ) );
		json_object_object_add( entry, "default", json_object_new_double( usual ) );
		toolAddText( entry, "text", infos[i].text );
		json_object_array_add( list, entry );
	}
	return list;
}

struct json_object* toolBeginReport( const toolBakeJob* job )
{
	struct json_object* report = json_object_new_object();
	soleVersion version = soleGetVersion();
	char* number = toolFormat( "%d.%d.%d", version.major, version.minor, version.patch );
	toolAddText( report, "version", number );
	free( number );
	toolAddText( report, "character", job->options->character );
	toolAddText( report, "ground", job->options->ground );
	json_object_object_add( report, "legLength", json_object_new_double( toolLegLength( &job->character ) ) );
	json_object_object_add( report, "legs", toolLegsToJson( &job->character ) );
	json_object_object_add( report, "walks", json_object_new_array() );
	json_object_object_add( report, "settings", toolChangesToJson( &job->settings ) );
	return report;
}

// ------------------------------------------------------------------------------------------------------- along time

static struct json_object* toolCurveToJson( const double* values, int32_t count, int digits )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object_array_add( list, toolShortToJson( values[i], digits ) );
	}
	return list;
}

static struct json_object* toolLegCurvesToJson( const toolBakeJob* job, const toolBakeResult* result, int32_t leg )
{
	int32_t frames = result->walk.frameCount;
	float* heights = toolAlloc( (size_t)frames, sizeof *heights );
	double* values = toolAlloc( (size_t)frames, sizeof *values );
	double* accelerations = toolAlloc( (size_t)frames, sizeof *accelerations );
	struct json_object* planted = json_object_new_array();
	toolMakeHeightCurve( &job->character, result, job->terrain, leg, heights );
	for ( int32_t f = 0; f < frames; ++f )
	{
		values[f] = (double)heights[f];
		json_object_array_add( planted, json_object_new_int( toolIsPlanted( result, leg, f ) ? 1 : 0 ) );
	}
	struct json_object* entry = json_object_new_object();
	json_object_object_add( entry, "height", toolCurveToJson( values, frames, LENGTH_DIGITS ) );
	toolMakeBendCurve( &job->character, result, leg, values );
	json_object_object_add( entry, "bend", toolCurveToJson( values, frames, ANGLE_DIGITS ) );
	toolMakeAccelerationCurve( &result->walk, values, accelerations );
	json_object_object_add( entry, "acceleration", toolCurveToJson( accelerations, frames, ACCELERATION_DIGITS ) );
	json_object_object_add( entry, "planted", planted );
	free( accelerations );
	free( values );
	free( heights );
	return entry;
}

static struct json_object* toolPelvisToJson( const toolBakeJob* job, const toolBakeResult* result )
{
	int32_t frames = result->walk.frameCount;
	soleVec3* places = toolAlloc( (size_t)frames, sizeof *places );
	struct json_object* list = json_object_new_array();
	toolMakePelvisCurve( &job->character, result, places );
	for ( int32_t f = 0; f < frames; ++f )
	{
		json_object_array_add( list, toolShortToJson( (double)places[f].x, LENGTH_DIGITS ) );
		json_object_array_add( list, toolShortToJson( (double)places[f].y, LENGTH_DIGITS ) );
		json_object_array_add( list, toolShortToJson( (double)places[f].z, LENGTH_DIGITS ) );
	}
	free( places );
	return list;
}

static struct json_object* toolReportTakeToJson( const toolBakeJob* job, const toolBakedTake* taken )
{
	struct json_object* entry = json_object_new_object();
	struct json_object* legs = json_object_new_array();
	toolAddText( entry, "method", taken->method->name );
	toolAddText( entry, "summary", taken->method->summary );
	toolAddText( entry, "clip", taken->name );
	json_object_object_add( entry, "figures", toolFiguresToJson( job->character.rig, &taken->figures ) );
	for ( int32_t leg = 0; leg < taken->result.legCount; ++leg )
	{
		json_object_array_add( legs, toolLegCurvesToJson( job, &taken->result, leg ) );
	}
	json_object_object_add( entry, "legs", legs );
	json_object_object_add( entry, "pelvis", toolPelvisToJson( job, &taken->result ) );
	return entry;
}

static struct json_object* toolLabelsToJson( const toolTake* take, int32_t legCount )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t leg = 0; leg < legCount; ++leg )
	{
		struct json_object* labels = json_object_new_array();
		for ( int32_t f = 0; f < take->frameCount; ++f )
		{
			json_object_array_add( labels, json_object_new_int( take->labels[f * legCount + leg] ) );
		}
		json_object_array_add( list, labels );
	}
	return list;
}

// ---------------------------------------------------------------------------------------------------------- figures

static const toolTarget* toolFindTarget( toolRowFigure figure )
{
	int32_t count;
	const toolTarget* targets = toolGetTargets( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( targets[i].figure == figure )
		{
			return targets + i;
		}
	}
	return NULL;
}

/// In the unit of the column; null where the target says nothing of the cell.
static struct json_object* toolLimitToJson(
    const toolColumn* column, const toolTarget* target, const toolTableCell* cell )
{
	double limit = toolGetLimit( target, cell );
	double own = toolGetRowReference( cell, column->figure );
	bool ratio = column->kind == tool_columnRatio;
	return ratio && own <= 0.0 ? NULL : toolFiniteToJson( ratio ? limit / own : column->factor * limit );
}

static struct json_object* toolReportCellToJson( const toolColumn* column, const toolTableCell* cell )
{
	const toolTarget* target = toolFindTarget( column->figure );
	double excess = target != NULL ? toolGetExcess( target, cell ) : (double)NAN;
	bool judged = isnan( excess ) == 0;
	struct json_object* entry = json_object_new_object();
	json_object_object_add( entry, "value", toolFiniteToJson( toolGetColumn( column, cell ) ) );
	json_object_object_add( entry, "limit", judged ? toolLimitToJson( column, target, cell ) : NULL );
	json_object_object_add( entry, "holds", judged ? json_object_new_boolean( excess <= 1.0 ) : NULL );
	return entry;
}

static struct json_object* toolRowToJson( const toolColumn* column, const toolTableCell* cells, int32_t count )
{
	struct json_object* row = json_object_new_object();
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object_array_add( list, toolReportCellToJson( column, cells + i ) );
	}
	toolAddText( row, "name", column->name );
	toolAddText( row, "title", column->title );
	toolAddText( row, "unit", column->heads[2] );
	json_object_object_add( row, "decimals", json_object_new_int( column->decimals ) );
	json_object_object_add( row, "atLeast", json_object_new_boolean( column->most ) );
	json_object_object_add( row, "cells", list );
	return row;
}

/// All columns that are about the cells themselves: neither the input's own nor another rate.
static struct json_object* toolRowsToJson( const toolTableCell* cells, int32_t count )
{
	struct json_object* rows = json_object_new_array();
	int32_t columnCount;
	const toolColumn* columns = toolGetColumns( &columnCount );
	for ( int32_t i = 0; i < columnCount; ++i )
	{
		bool other = columns[i].figure == tool_rowRateP95 || columns[i].figure == tool_rowRateMax;
		if ( columns[i].kind != tool_columnInput && other == false )
		{
			json_object_array_add( rows, toolRowToJson( columns + i, cells, count ) );
		}
	}
	return rows;
}

// ------------------------------------------------------------------------------------------------------------- walk

bool toolAddWalk( const toolBakeJob* job, const toolBakedClip* baked, struct json_object* report, toolError* error )
{
	const toolWalk* walk = &baked->takes[0].result.walk;
	struct json_object* entry = json_object_new_object();
	struct json_object* takes = json_object_new_array();
	toolTableCell* cells = toolAlloc( (size_t)baked->takeCount, sizeof *cells );
	bool good = true;
	for ( int32_t i = 0; i < baked->takeCount && good; ++i )
	{
		const toolBakedTake* taken = baked->takes + i;
		toolTake take;
		good = toolMakeBakeTake( &job->character, &taken->result, &take, error ) ||
		    toolFailIn( error, job->options->character );
		if ( good == false )
		{
			break;
		}
		cells[i] = ( toolTableCell ){
			.method = taken->method,
			.figures = taken->figures,
			.reference = taken->reference,
			.shortfall = toolFindShortfall( &taken->result, &take ),
			.isBase = true,
		};
		if ( i == 0 )
		{
			// Of the clip, whatever the method.
			json_object_object_add( entry, "labels", toolLabelsToJson( &take, taken->result.legCount ) );
			json_object_object_add( entry, "skip", json_object_new_int( take.skip ) );
		}
		toolFreeTake( &take );
		json_object_array_add( takes, toolReportTakeToJson( job, taken ) );
	}
	toolAddText( entry, "clip", baked->name );
	json_object_object_add( entry, "fps", json_object_new_double( walk->fps ) );
	json_object_object_add( entry, "frames", json_object_new_int( walk->frameCount ) );
	json_object_object_add( entry, "speed", json_object_new_double( walk->speed ) );
	json_object_object_add( entry, "takes", takes );
	json_object_object_add( entry, "rows", toolRowsToJson( cells, baked->takeCount ) );
	json_object_array_add( json_object_object_get( report, "walks" ), entry );
	free( cells );
	return good;
}
