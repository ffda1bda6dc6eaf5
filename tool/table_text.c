// SPDX-License-Identifier: MIT
// A table of quality as text for people and as JSON. One list names the columns.
#include "figures_text.h"
#include "table.h"

#include <json-c/json.h>
#include <math.h>
#include <string.h>

typedef enum toolColumnKind
{
	tool_columnFigure,
	tool_columnInput, // the input's own figure
	tool_columnRatio  // figure over the input's own
} toolColumnKind;

typedef struct toolColumn
{
	const char* heads[3];
	toolRowFigure figure;
	toolColumnKind kind;
	double factor; // from SI to the unit of the head
	int decimals;
	int width;
} toolColumn;

static const toolColumn toolColumns[] = {
	{ { "", "frames", "" }, tool_rowFrames, tool_columnFigure, 1.0, 0, 6 },
	{ { "penetr.", "p95", "mm" }, tool_rowPenetrationP95, tool_columnFigure, 1e3, 1, 7 },
	{ { "", "max", "mm" }, tool_rowPenetrationMax, tool_columnFigure, 1e3, 1, 6 },
	{ { "hover", "p95", "mm" }, tool_rowHoverP95, tool_columnFigure, 1e3, 1, 6 },
	{ { "contact", "share", "%" }, tool_rowShare, tool_columnFigure, 1e2, 1, 7 },
	{ { "slide", "", "cm/s" }, tool_rowSlide, tool_columnFigure, 1e2, 2, 6 },
	{ { "", "input", "cm/s" }, tool_rowSlide, tool_columnInput, 1e2, 2, 6 },
	{ { "drift", "mean", "mm" }, tool_rowDriftMean, tool_columnFigure, 1e3, 1, 6 },
	{ { "", "max", "mm" }, tool_rowDriftMax, tool_columnFigure, 1e3, 1, 6 },
	{ { "", "input", "mm" }, tool_rowDriftMax, tool_columnInput, 1e3, 1, 6 },
	{ { "knee", "acc.", "ratio" }, tool_rowKnee, tool_columnRatio, 1.0, 2, 6 },
	{ { "pelvis", "jerk", "ratio" }, tool_rowPelvisJerk, tool_columnRatio, 1.0, 2, 6 },
	{ { "", "step", "mm" }, tool_rowPelvisStep, tool_columnFigure, 1e3, 1, 5 },
	{ { "over-", "ext.", "" }, tool_rowOverExtended, tool_columnFigure, 1.0, 0, 6 },
	{ { "pop", "", "ratio" }, tool_rowJump, tool_columnRatio, 1.0, 2, 6 },
	{ { "to 60", "p95", "mm" }, tool_rowRateP95, tool_columnFigure, 1e3, 1, 6 },
	{ { "", "max", "mm" }, tool_rowRateMax, tool_columnFigure, 1e3, 1, 6 },
};

#define COLUMN_COUNT ( (int32_t)( sizeof toolColumns / sizeof toolColumns[0] ) )

static double toolGetColumn( const toolColumn* column, const toolTableCell* cell )
{
	double own = toolGetRowReference( cell, column->figure );
	double figure = toolGetRowFigure( cell, column->figure );
	switch ( column->kind )
	{
	case tool_columnInput:
		return own;
	case tool_columnRatio:
		return own > 0.0 ? figure / own : (double)NAN;
	default:
		return figure;
	}
}

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

static int toolWidest( int least, const char* text )
{
	int length = (int)strlen( text );
	return length > least ? length : least;
}

static void toolPrintHeads( FILE* stream, int groundWidth, int methodWidth )
{
	static const char* const first[3][3] = { { "", "", "" }, { "ground", "fps", "method" }, { "", "", "" } };
	for ( int32_t line = 0; line < 3; ++line )
	{
		const char* const* names = first[line];
		fprintf( stream, "%-*s  %4s  %-*s", groundWidth, names[0], names[1], methodWidth, names[2] );
		for ( int32_t i = 0; i < COLUMN_COUNT; ++i )
		{
			fprintf( stream, " %*s ", toolColumns[i].width, toolColumns[i].heads[line] );
		}
		fputc( '\n', stream );
	}
}

static void toolPrintRow( FILE* stream, const toolTableCell* cell, int groundWidth, int methodWidth )
{
	fprintf( stream, "%-*s  %4d  %-*s", groundWidth, cell->ground, cell->fps, methodWidth, cell->method->name );
	for ( int32_t i = 0; i < COLUMN_COUNT; ++i )
	{
		const toolColumn* column = toolColumns + i;
		double value = toolGetColumn( column, cell );
		if ( isfinite( value ) )
		{
			fprintf( stream, " %*.*f%c", column->width, column->decimals, column->factor * value,
			    toolMisses( column, cell ) ? '!' : ' ' );
		}
		else
		{
			fprintf( stream, " %*s ", column->width, "-" );
		}
	}
	fputc( '\n', stream );
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
	int groundWidth = 6;
	int methodWidth = 6;
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		groundWidth = toolWidest( groundWidth, table->cells[i].ground );
		methodWidth = toolWidest( methodWidth, table->cells[i].method->name );
	}
	toolPrintHeads( stream, groundWidth, methodWidth );
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		toolPrintRow( stream, table->cells + i, groundWidth, methodWidth );
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

struct json_object* toolTableToJson( const soleRig* rig, const toolTable* table )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		const toolTableCell* cell = table->cells + i;
		struct json_object* row = toolFiguresToJson( rig, &cell->figures );
		json_object_object_add( row, "clip", json_object_new_string( table->clip ) );
		json_object_object_add( row, "ground", json_object_new_string( cell->ground ) );
		json_object_object_add( row, "fps", json_object_new_int( cell->fps ) );
		json_object_object_add( row, "method", json_object_new_string( cell->method->name ) );
		json_object_object_add( row, "referenceFigures", toolFiguresToJson( rig, &cell->reference ) );
		json_object_object_add( row, "ratios", toolRatiosToJson( &cell->figures, &cell->reference ) );
		json_object_object_add( row, "rate", cell->isBase ? NULL : toolRateToJson( &cell->rate ) );
		json_object_object_add( row, "targets", toolTargetsToJson( cell ) );
		json_object_array_add( list, row );
	}
	return list;
}
