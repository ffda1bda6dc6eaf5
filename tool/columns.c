// SPDX-License-Identifier: MIT
// The columns of tables of quality, and a row of them as text. One list names them all.
#include "columns.h"

#include <math.h>
#include <string.h>

#define BOTH ( tool_inTable | tool_inComparison )

static const toolColumn toolColumns[] = {
	// clang-format off
	{ "frames", "labelled frames", { "", "frames", "" }, 1.0, tool_rowFrames, tool_columnFigure, tool_inTable, 0, 6, true },
	{ "penetrationP95", "penetration p95", { "penetr.", "p95", "mm" }, 1e3, tool_rowPenetrationP95, tool_columnFigure, BOTH, 1, 7, false },
	{ "penetrationMax", "penetration max", { "", "max", "mm" }, 1e3, tool_rowPenetrationMax, tool_columnFigure, BOTH, 1, 6, false },
	{ "hoverP95", "hover p95", { "hover", "p95", "mm" }, 1e3, tool_rowHoverP95, tool_columnFigure, BOTH, 1, 6, false },
	{ "contactShare", "contact share", { "contact", "share", "%" }, 1e2, tool_rowShare, tool_columnFigure, BOTH, 1, 7, true },
	{ "slide", "slide", { "slide", "", "cm/s" }, 1e2, tool_rowSlide, tool_columnFigure, BOTH, 2, 6, false },
	{ "slideInput", "slide of the input", { "", "input", "cm/s" }, 1e2, tool_rowSlide, tool_columnInput, tool_inTable, 2, 6, false },
	{ "driftMean", "drift mean", { "drift", "mean", "mm" }, 1e3, tool_rowDriftMean, tool_columnFigure, BOTH, 1, 6, false },
	{ "driftMax", "drift max", { "", "max", "mm" }, 1e3, tool_rowDriftMax, tool_columnFigure, BOTH, 1, 6, false },
	{ "driftInput", "drift max of the input", { "", "input", "mm" }, 1e3, tool_rowDriftMax, tool_columnInput, tool_inTable, 1, 6, false },
	{ "kneeAccelerationRms", "knee acceleration", { "knee", "acc.", "ratio" }, 1.0, tool_rowKnee, tool_columnRatio, BOTH, 2, 6, false },
	{ "pelvisJerk", "pelvis jerk", { "pelvis", "jerk", "ratio" }, 1.0, tool_rowPelvisJerk, tool_columnRatio, BOTH, 2, 7, false },
	{ "pelvisStep", "largest step of the pelvis", { "", "step", "mm" }, 1e3, tool_rowPelvisStep, tool_columnFigure, tool_inTable, 1, 5, false },
	{ "overExtended", "over-extended", { "over-", "ext.", "frames" }, 1.0, tool_rowOverExtended, tool_columnFigure, BOTH, 0, 6, false },
	{ "reachShortfall", "reach shortfall", { "short-", "fall", "mm" }, 1e3, tool_rowShortfall, tool_columnFigure, tool_inComparison, 1, 6, false },
	{ "largestJump", "largest jump", { "pop", "", "ratio" }, 1.0, tool_rowJump, tool_columnRatio, BOTH, 2, 6, false },
	{ "clearance", "clearance p5", { "clear-", "ance", "mm" }, 1e3, tool_rowClearance, tool_columnFigure, tool_inComparison, 1, 6, true },
	{ "scuffs", "swings below zero", { "swings", "below", "" }, 1.0, tool_rowScuffs, tool_columnFigure, tool_inComparison, 0, 6, false },
	{ "deviation", "deviation", { "devi-", "ation", "deg" }, 180.0 / 3.14159265358979, tool_rowDeviation, tool_columnFigure, tool_inComparison, 2, 6, false },
	{ "rateP95", "distance to 60 Hz p95", { "to 60", "p95", "mm" }, 1e3, tool_rowRateP95, tool_columnFigure, tool_inTable, 1, 6, false },
	{ "rateMax", "distance to 60 Hz max", { "", "max", "mm" }, 1e3, tool_rowRateMax, tool_columnFigure, tool_inTable, 1, 6, false },
	// clang-format on
};

#define COLUMN_COUNT ( (int32_t)( sizeof toolColumns / sizeof toolColumns[0] ) )

_Static_assert( sizeof toolColumns / sizeof toolColumns[0] <= TOOL_MOST_COLUMNS, "arrays of marks are too short" );

const toolColumn* toolGetColumns( int32_t* count )
{
	*count = COLUMN_COUNT;
	return toolColumns;
}

double toolGetColumn( const toolColumn* column, const toolTableCell* cell )
{
	double own = toolGetRowReference( cell, column->figure );
	double figure = toolGetRowFigure( cell, column->figure );
	switch ( column->kind )
	{
	case tool_columnInput:
		return column->factor * own;
	case tool_columnRatio:
		return own > 0.0 ? figure / own : (double)NAN;
	default:
		return column->factor * figure;
	}
}

static int toolWidest( int least, const char* text )
{
	int length = (int)strlen( text );
	return length > least ? length : least;
}

toolRowWidths toolFindRowWidths( const toolTable* table )
{
	toolRowWidths widths = { 6, 6 };
	for ( int32_t i = 0; i < table->cellCount; ++i )
	{
		widths.ground = toolWidest( widths.ground, table->cells[i].ground );
		widths.method = toolWidest( widths.method, table->cells[i].method->name );
	}
	return widths;
}

void toolPrintHeads( FILE* stream, int32_t tables, toolRowWidths widths )
{
	static const char* const first[3][3] = { { "", "", "" }, { "ground", "fps", "method" }, { "", "", "" } };
	for ( int32_t line = 0; line < 3; ++line )
	{
		const char* const* names = first[line];
		fprintf( stream, "%-*s  %4s  %-*s", widths.ground, names[0], names[1], widths.method, names[2] );
		for ( int32_t i = 0; i < COLUMN_COUNT; ++i )
		{
			if ( ( toolColumns[i].tables & tables ) != 0 )
			{
				fprintf( stream, " %*s ", toolColumns[i].width, toolColumns[i].heads[line] );
			}
		}
		fputc( '\n', stream );
	}
}

void toolPrintRow( FILE* stream, int32_t tables, toolRowWidths widths, const toolTableCell* cell, const char* marks )
{
	fprintf( stream, "%-*s  %4d  %-*s", widths.ground, cell->ground, cell->fps, widths.method, cell->method->name );
	for ( int32_t i = 0; i < COLUMN_COUNT; ++i )
	{
		const toolColumn* column = toolColumns + i;
		double value = toolGetColumn( column, cell );
		if ( ( column->tables & tables ) == 0 )
		{
			continue;
		}
		if ( isfinite( value ) )
		{
			fprintf( stream, " %*.*f%c", column->width, column->decimals, value, marks[i] );
		}
		else
		{
			fprintf( stream, " %*s ", column->width, "-" );
		}
	}
	fputc( '\n', stream );
}
