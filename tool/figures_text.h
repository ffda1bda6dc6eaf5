// SPDX-License-Identifier: MIT
// Quality figures for people, side by side, and for programs, as JSON. One table names them all.
#ifndef TOOL_FIGURES_TEXT_H
#define TOOL_FIGURES_TEXT_H

#include "sole/measure.h"
#include "sole/sole.h"
#include "tool.h"

struct json_object;

/// One motion's figures.
typedef struct toolFigureColumn
{
	const char* name; // "sole", "none"
	const soleFigures* figures;
	/// What ratios are taken to, or NULL: none are printed.
	const soleFigures* reference;
	/// NULL in all columns: none are printed.
	const solePublishedFigures* published;
} toolFigureColumn;

/// A table: a row a figure with its unit, a column a motion; the whole first, then every leg, then the ratios, then
/// published figures.
void toolPrintFigures( FILE* stream, const soleRig* rig, const toolFigureColumn* columns, int32_t columnCount );

/// { "legs": [ ... ], "whole": { ... } }, SI units.
struct json_object* toolFiguresToJson( const soleRig* rig, const soleFigures* figures );
/// { "slide", "drift", "kneeAccelerationRms", "pelvisJerk", "largestJump" }: a figure over the reference's, null where
/// that has none.
struct json_object* toolRatiosToJson( const soleFigures* figures, const soleFigures* reference );

/// { "mann": { "step", "speed" }, "mvae", "skatingRatio", "kimodo", "physDiff", "footContactScore" }, SI units.
struct json_object* toolPublishedToJson( const solePublishedFigures* figures );

#endif
