// SPDX-License-Identifier: MIT
// A table of quality as text for people and as JSON.
#include "columns.h"
#include "figures_text.h"

#include <json-c/json.h>
#include <math.h>
#include <string.h>

/// Misses the column's figure its target?
static bool toolMisses( const toolColumn* column, const toolTableCell* cell )
{
	int32_t count;
	const toolTarget* targets = toolGetTargets( &count );
	for ( int32_t i = 0; i < count && column->kind != tool_columnInput; ++i )
	{
		if ( targets[i].figure == column->figure && toolGetExcess( targets + i, cell ) > 1.0 )
		{
			return true;
		}
	}
	return false;
}

static void toolPrintTableRow( FILE* stream, toolRowWidths widths, const toolTableCell* cell )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	char marks[TOOL_MOST_COLUMNS];
	for ( int32_t i = 0; i < count; ++i )
	{
		marks[i] = toolMisses( columns + i, cell ) ? '!' : ' ';
	}
	toolPrintRow( stream, tool_inTable, widths, cell, marks );
}

/// How many targets hold and are missed with a method.
static void toolPrintCounts( FILE* stream, const toolTable* table, const toolMethod* method )
{
	int32_t count;
	const toolTarget* targets = toolGetTargets( &count );
	int32_t counts[2] = { 0, 0 };
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		for ( int32_t k = 0; k < count && table->cells[i].method == method; ++k )
		{
			double excess = toolGetExcess( targets + k, table->cells + i );
			counts[0] += excess <= 1.0;
			counts[1] += excess > 1.0;
		}
	}
	fprintf( stream, "%s: %d targets hold, %d are missed\n", method->name, counts[0], counts[1] );
}

void toolPrintTable( FILE* stream, const toolTable* table )
{
	toolRowWidths widths = toolFindRowWidths( table );
	toolPrintHeads( stream, tool_inTable, widths );
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		toolPrintTableRow( stream, widths, table->cells + i );
	}
	fputc( '\n', stream );
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		bool again = false;
		for ( int32_t k = 0; k < i; ++k )
		{
			again = again || table->cells[k].method == table->cells[i].method;
		}
		if ( again == false )
		{
			toolPrintCounts( stream, table, table->cells[i].method );
		}
	}
}

// ----------------------------------------------------------------------------------------------------------- json

static struct json_object* toolTargetsToJson( const toolTableCell* cell )
{
	struct json_object* object = json_object_new_object();
	int32_t count;
	const toolTarget* targets = toolGetTargets( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		double excess = toolGetExcess( targets + i, cell );
		if ( isnan( excess ) == 0 )
		{
			json_object_object_add( object, targets[i].name, json_object_new_boolean( excess <= 1.0 ) );
		}
	}
	return object;
}

static struct json_object* toolRateToJson( const soleStat* rate )
{
	struct json_object* object = json_object_new_object();
	json_object_object_add( object, "mean", json_object_new_double( rate->mean ) );
	json_object_object_add( object, "p95", json_object_new_double( rate->p95 ) );
	json_object_object_add( object, "max", json_object_new_double( rate->max ) );
	return object;
}

struct json_object* toolCellToJson( const soleRig* rig, const toolTable* table, const toolTableCell* cell )
{
	struct json_object* row = toolFiguresToJson( rig, &cell->figures );
	struct json_object* shortfall = isfinite( cell->shortfall ) ? json_object_new_double( cell->shortfall ) : NULL;
	json_object_object_add( row, "clip", json_object_new_string( table->clip ) );
	json_object_object_add( row, "ground", json_object_new_string( cell->ground ) );
	json_object_object_add( row, "fps", json_object_new_int( cell->fps ) );
	json_object_object_add( row, "method", json_object_new_string( cell->method->name ) );
	json_object_object_add( row, "reachShortfall", shortfall );
	json_object_object_add( row, "referenceFigures", toolFiguresToJson( rig, &cell->reference ) );
	json_object_object_add( row, "ratios", toolRatiosToJson( &cell->figures, &cell->reference ) );
	json_object_object_add( row, "rate", cell->isBase ? NULL : toolRateToJson( &cell->rate ) );
	json_object_object_add( row, "targets", toolTargetsToJson( cell ) );
	return row;
}

struct json_object* toolTableToJson( const soleRig* rig, const toolTable* table )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		json_object_array_add( list, toolCellToJson( rig, table, table->cells + i ) );
	}
	return list;
}
