// SPDX-License-Identifier: MIT
// The columns of tables of quality: which figures of a cell are shown, in which unit, and which way is better.
#ifndef TOOL_COLUMNS_H
#define TOOL_COLUMNS_H

#include "table.h"

typedef enum toolColumnKind
{
	tool_columnFigure,
	tool_columnInput, // the input's own figure
	tool_columnRatio  // figure over the input's own
} toolColumnKind;

/// The tables that a column is part of.
enum
{
	tool_inTable = 1,      // sole measure --table
	tool_inComparison = 2, // sole compare
};

typedef struct toolColumn
{
	const char* name;     // in JSON
	const char* title;    // in a sentence
	const char* heads[3]; // over each other; the last is the unit
	double factor;        // from SI to the unit
	toolRowFigure figure;
	toolColumnKind kind;
	int32_t tables;
	int decimals;
	int width;
	bool most; // better is more, not less
} toolColumn;

const toolColumn* toolGetColumns( int32_t* count );
/// At least as many as there are.
#define TOOL_MOST_COLUMNS 24

/// In the column's unit. Not a number where the cell has none.
double toolGetColumn( const toolColumn* column, const toolTableCell* cell );

/// How wide what stands before the columns is.
typedef struct toolRowWidths
{
	int ground;
	int method;
} toolRowWidths;

toolRowWidths toolFindRowWidths( const toolTable* table );
void toolPrintHeads( FILE* stream, int32_t tables, toolRowWidths widths );
/// @param marks a character for each of all columns, put behind the figure
void toolPrintRow( FILE* stream, int32_t tables, toolRowWidths widths, const toolTableCell* cell, const char* marks );

#endif
