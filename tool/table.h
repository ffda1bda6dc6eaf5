// SPDX-License-Identifier: MIT
// Tables of quality: one clip baked over grounds, at frame rates, with methods, and measured; and the targets that Sole
// is held to. A cell is one bake. SI units.
#ifndef TOOL_TABLE_H
#define TOOL_TABLE_H

#include "evaluate.h"
#include "way_options.h"

struct json_object;

/// The rate that others are compared with, Hz.
#define TOOL_BASE_RATE 60

/// Figures that make a row. Over all legs.
typedef enum toolRowFigure
{
	tool_rowFrames, // that are labelled, leg by leg
	tool_rowPenetrationP95,
	tool_rowPenetrationMax,
	tool_rowHoverP95,
	tool_rowShare,
	tool_rowSlide,
	tool_rowDriftMean,
	tool_rowDriftMax,
	tool_rowKnee,
	tool_rowPelvisJerk,
	tool_rowPelvisStep,
	tool_rowOverExtended,
	tool_rowShortfall, // not a number where the method does not tell
	tool_rowJump,
	tool_rowClearance, // not a number without a swing, as is the next
	tool_rowScuffs,
	tool_rowDeviation,
	tool_rowRateP95, // distance to the same run at the base rate; not a number at the base rate itself
	tool_rowRateMax,
	tool_rowFigureCount
} toolRowFigure;

typedef struct toolTableCell
{
	const char* ground;
	int32_t fps;
	const toolMethod* method;
	soleFigures figures;
	soleFigures reference; // of the clip on flat ground at the same rate, feet untouched
	double shortfall;      // as toolFindShortfall() has it
	soleStat rate;         // distances to the cell at the base rate
	bool isBase;           // is that cell
} toolTableCell;

double toolGetRowFigure( const toolTableCell* cell, toolRowFigure figure );
/// The input's own. Not a number where it has none.
double toolGetRowReference( const toolTableCell* cell, toolRowFigure figure );

// -------------------------------------------------------------------------------------------------------- targets

/// What a figure must not exceed, or not fall below: the larger of a limit and a multiple of the input's own figure.
typedef struct toolTarget
{
	const char* name; // in JSON
	double limit;
	double ofInput;
	toolRowFigure figure;
	bool atLeast;
} toolTarget;

const toolTarget* toolGetTargets( int32_t* count );

/// What the figure of a cell is held to, SI.
double toolGetLimit( const toolTarget* target, const toolTableCell* cell );
/// How many times its limit a figure is, or how many times below it where it must be at least that: up to 1 the target
/// holds. Against a limit of 0 one more than the figure. Not a number where the target says nothing of the cell.
double toolGetExcess( const toolTarget* target, const toolTableCell* cell );

// ----------------------------------------------------------------------------------------------------------- make

/// What to bake. All arrays stay the caller's.
typedef struct toolTableDef
{
	const toolCharacter* character;
	const toolBoundClip* bound;
	const toolTravel* travel;
	const soleSettings* settings;
	const char* const* grounds;
	int32_t groundCount;
	const int32_t* rates;
	int32_t rateCount;
	const toolMethod* const* methods;
	int32_t methodCount;
	/// The way over grounds that have none of their own.
	const toolWayOptions* way;
	/// Called with the share that is done. May be NULL.
	void ( *progress )( void* user, double done );
	void* user;
} toolTableDef;

typedef struct toolTable
{
	const char* clip;
	toolTableCell* cells; // ground, method, rate
	int32_t cellCount;
} toolTable;

bool toolMakeTable( const toolTableDef* def, toolTable* table, toolError* error );
void toolFreeTable( toolTable* table );

// ----------------------------------------------------------------------------------------------------------- tell

/// A row a cell. Figures that miss their target have a '!' behind them; the last line counts.
void toolPrintTable( FILE* stream, const toolTable* table );
/// { "clip", "ground", "fps", "method", "reachShortfall", "legs", "whole", "referenceFigures", "ratios", "rate",
/// "targets" }
struct json_object* toolCellToJson( const soleRig* rig, const toolTable* table, const toolTableCell* cell );
/// A list of all of them.
struct json_object* toolTableToJson( const soleRig* rig, const toolTable* table );

#endif
