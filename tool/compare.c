// SPDX-License-Identifier: MIT
// Bakes, measures and judges methods side by side. See compare.h for the rules.
#include "compare.h"

#include <math.h>
#include <stdlib.h>

#define STANDS_WITHIN 0.05 // m: below that height published figures count a foot as on the ground
#define TIMES_LEAST 2.0    // or so many times what the best manages
#define SHARE_OF_MOST 0.5  // of the largest contact share
#define EQUAL 0.05         // of the best figure

// ---------------------------------------------------------------------------------------------------------- judge

static double toolFindOff( const toolTableCell* cell )
{
	return fmax( cell->figures.all.penetration.p95, cell->figures.all.hover.p95 );
}

static void toolFindPlanting( const toolTableCell* cells, int32_t cellCount, toolVerdict* verdicts )
{
	double least = (double)INFINITY;
	double most = 0.0;
	for ( int32_t i = 0; i < cellCount; ++i )
	{
		least = fmin( least, toolFindOff( cells + i ) );
		most = fmax( most, cells[i].figures.all.contactShare );
	}
	for ( int32_t i = 0; i < cellCount; ++i )
	{
		const soleLegFigures* all = &cells[i].figures.all;
		verdicts[i] = ( toolVerdict ){ 0 };
		verdicts[i].judged = cells[i].method->step != NULL && all->labelledFrames > 0 &&
		    toolFindOff( cells + i ) <= fmax( STANDS_WITHIN, TIMES_LEAST * least ) &&
		    all->contactShare >= SHARE_OF_MOST * most;
	}
}

/// One column of all methods that plant.
static void toolJudgeColumn(
    const toolColumn* column, int32_t index, const toolTableCell* cells, int32_t cellCount, toolVerdict* verdicts )
{
	double best = (double)NAN;
	for ( int32_t i = 0; i < cellCount; ++i )
	{
		double value = verdicts[i].judged ? toolGetColumn( column, cells + i ) : (double)NAN;
		best = column->most ? fmax( best, value ) : fmin( best, value ); // of a number and none the number
	}
	if ( isnan( best ) )
	{
		return;
	}
	double step = pow( 10.0, -(double)column->decimals );
	for ( int32_t i = 0; i < cellCount; ++i )
	{
		double value = toolGetColumn( column, cells + i );
		double off = fabs( value - best );
		bool equal = off < 0.999 * step || off <= EQUAL * fabs( best );
		verdicts[i].best[index] = verdicts[i].judged && equal;
		verdicts[i].behind[index] = verdicts[i].judged && equal == false && isfinite( value );
	}
}

void toolJudgeCells( const toolTableCell* cells, int32_t cellCount, toolVerdict* verdicts )
{
	toolFindPlanting( cells, cellCount, verdicts );
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( ( columns[i].tables & tool_inComparison ) != 0 )
		{
			toolJudgeColumn( columns + i, i, cells, cellCount, verdicts );
		}
	}
}

// ----------------------------------------------------------------------------------------------------------- make

bool toolCompareOn( const toolTableDef* def, int32_t ground, toolComparison* comparison, toolError* error )
{
	*comparison = ( toolComparison ){ 0 };
	toolTableDef one = *def;
	one.grounds = def->grounds + ground;
	one.groundCount = 1;
	if ( toolMakeTable( &one, &comparison->table, error ) == false )
	{
		return false;
	}
	int32_t count = comparison->table.cellCount;
	comparison->verdicts = toolAlloc( (size_t)count, sizeof *comparison->verdicts );
	toolJudgeCells( comparison->table.cells, count, comparison->verdicts );
	return true;
}

void toolFreeComparison( toolComparison* comparison )
{
	toolFreeTable( &comparison->table );
	free( comparison->verdicts );
	*comparison = ( toolComparison ){ 0 };
}

void toolFreeComparisons( toolComparisons* comparisons )
{
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		toolFreeComparison( comparisons->items + i );
	}
	for ( int32_t i = 0; i < comparisons->leftOutCount; ++i )
	{
		free( comparisons->leftOut[i] );
	}
	free( comparisons->items );
	free( comparisons->leftOut );
	*comparisons = ( toolComparisons ){ 0 };
}
