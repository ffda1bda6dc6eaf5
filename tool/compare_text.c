// SPDX-License-Identifier: MIT
// Comparisons as text for people, as Markdown for a page, and as JSON.
#include "compare.h"

#include <json-c/json.h>
#include <math.h>
#include <string.h>

// -------------------------------------------------------------------------------------------------------- in words

/// Titles of the columns that are marked, apart by commas.
static void toolPrintTitles( FILE* stream, const bool* marked )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	const char* before = "";
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( marked[i] )
		{
			fprintf( stream, "%s%s", before, columns[i].title );
			before = ", ";
		}
	}
}

static int32_t toolCountMarked( const bool* marked )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < TOOL_MOST_COLUMNS; ++i )
	{
		count += marked[i];
	}
	return count;
}

/// NULL where the method was not compared.
static const toolVerdict* toolFindVerdict( const toolComparison* comparison, const toolMethod* method )
{
	for ( int32_t i = 0; i < comparison->table.cellCount && method != NULL; ++i )
	{
		if ( comparison->table.cells[i].method == method )
		{
			return comparison->verdicts + i;
		}
	}
	return NULL;
}

static int32_t toolCountPlanting( const toolComparison* comparison )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < comparison->table.cellCount; ++i )
	{
		count += comparison->verdicts[i].judged;
	}
	return count;
}

/// The methods that try to plant, and do not.
static void toolPrintIdle( FILE* stream, const toolComparison* comparison )
{
	const char* before = " Does not plant: ";
	for ( int32_t i = 0; i < comparison->table.cellCount; ++i )
	{
		const toolMethod* method = comparison->table.cells[i].method;
		if ( method->step != NULL && comparison->verdicts[i].judged == false )
		{
			fprintf( stream, "%s%s", before, method->name );
			before = ", ";
		}
	}
	fputs( before[0] == ',' ? "." : "", stream );
}

/// What one method is best in, and what not.
static void toolPrintVerdict( FILE* stream, const toolComparison* comparison, const toolMethod* own )
{
	const toolVerdict* verdict = toolFindVerdict( comparison, own );
	if ( verdict == NULL )
	{
		return;
	}
	int32_t planting = toolCountPlanting( comparison );
	fprintf( stream, "%s:", comparison->table.cells[0].ground );
	if ( verdict->judged && planting == 1 )
	{
		fprintf( stream, " %s alone plants.", own->name );
	}
	else if ( verdict->judged )
	{
		int32_t best = toolCountMarked( verdict->best );
		int32_t behind = toolCountMarked( verdict->behind );
		fprintf( stream, " of %d methods that plant, %s is best or equal in %d figures of %d%s", planting, own->name,
		    best, best + behind, behind > 0 ? "; not in " : "" );
		toolPrintTitles( stream, verdict->behind );
		fputc( '.', stream );
	}
	toolPrintIdle( stream, comparison );
	fputc( '\n', stream );
}

/// One method over all grounds.
typedef struct toolSum
{
	int32_t planted; // grounds
	int32_t alone;   // of these: no other method plants
	int32_t best;    // figures, on the others
	int32_t behind[TOOL_MOST_COLUMNS];
} toolSum;

static toolSum toolSumUp( const toolComparisons* comparisons )
{
	toolSum sum = { 0 };
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		const toolVerdict* verdict = toolFindVerdict( comparisons->items + i, comparisons->own );
		bool judged = verdict != NULL && verdict->judged;
		bool alone = judged && toolCountPlanting( comparisons->items + i ) == 1;
		sum.planted += judged;
		sum.alone += alone;
		for ( int32_t k = 0; k < TOOL_MOST_COLUMNS && judged && alone == false; ++k )
		{
			sum.best += verdict->best[k];
			sum.behind[k] += verdict->behind[k];
		}
	}
	return sum;
}

/// How often a method is best over all grounds, and in which columns how often it is not.
static void toolPrintSum( FILE* stream, const toolComparisons* comparisons )
{
	toolSum sum = toolSumUp( comparisons );
	int32_t all = sum.best;
	for ( int32_t k = 0; k < TOOL_MOST_COLUMNS; ++k )
	{
		all += sum.behind[k];
	}
	fprintf( stream, "Grounds: %d. %s plants on %d, alone on %d; beside others it is best or equal in %d figures of %d",
	    comparisons->count, comparisons->own->name, sum.planted, sum.alone, sum.best, all );
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	const char* before = "; not in ";
	for ( int32_t k = 0; k < count; ++k )
	{
		if ( sum.behind[k] > 0 )
		{
			fprintf( stream, "%s%s (%d)", before, columns[k].title, sum.behind[k] );
			before = ", ";
		}
	}
	fputs( ".\n", stream );
}

static void toolPrintLeftOut( FILE* stream, const toolComparisons* comparisons )
{
	for ( int32_t i = 0; i < comparisons->leftOutCount; ++i )
	{
		fprintf( stream, "Left out: %s\n", comparisons->leftOut[i] );
	}
}

static bool toolHasOwn( const toolComparisons* comparisons )
{
	return comparisons->count > 0 && toolFindVerdict( comparisons->items, comparisons->own ) != NULL;
}

// ------------------------------------------------------------------------------------------------------------ text

static toolRowWidths toolFindAllWidths( const toolComparisons* comparisons )
{
	toolRowWidths widest = { 0, 0 };
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		toolRowWidths widths = toolFindRowWidths( &comparisons->items[i].table );
		widest.ground = widths.ground > widest.ground ? widths.ground : widest.ground;
		widest.method = widths.method > widest.method ? widths.method : widest.method;
	}
	return widest;
}

void toolPrintComparisons( FILE* stream, const toolComparisons* comparisons )
{
	toolRowWidths widths = toolFindAllWidths( comparisons );
	fprintf( stream, "%s: %s, half a second at the start left out; * best or equal of the methods that plant\n\n",
	    comparisons->character, comparisons->clip );
	toolPrintHeads( stream, tool_inComparison, widths );
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		const toolComparison* comparison = comparisons->items + i;
		for ( int32_t k = 0; k < comparison->table.cellCount; ++k )
		{
			char marks[TOOL_MOST_COLUMNS];
			for ( int32_t m = 0; m < TOOL_MOST_COLUMNS; ++m )
			{
				marks[m] = comparison->verdicts[k].best[m] ? '*' : ' ';
			}
			toolPrintRow( stream, tool_inComparison, widths, comparison->table.cells + k, marks );
		}
		fputc( '\n', stream );
	}
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		toolPrintVerdict( stream, comparisons->items + i, comparisons->own );
	}
	toolPrintLeftOut( stream, comparisons );
	if ( toolHasOwn( comparisons ) )
	{
		toolPrintSum( stream, comparisons );
	}
}

// -------------------------------------------------------------------------------------------------------- markdown

static void toolPrintMarkdownHeads( FILE* stream )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	fputs( "| method |", stream );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( ( columns[i].tables & tool_inComparison ) != 0 )
		{
			const char* unit = columns[i].heads[2];
			fprintf( stream, " %s%s%s |", columns[i].title, unit[0] != 0 ? ", " : "", unit );
		}
	}
	fputs( "\n|---|", stream );
	for ( int32_t i = 0; i < count; ++i )
	{
		fputs( ( columns[i].tables & tool_inComparison ) != 0 ? "---:|" : "", stream );
	}
	fputc( '\n', stream );
}

static void toolPrintMarkdownRow( FILE* stream, const toolTableCell* cell, const toolVerdict* verdict )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	fprintf( stream, "| %s |", cell->method->name );
	for ( int32_t i = 0; i < count; ++i )
	{
		double value = toolGetColumn( columns + i, cell );
		if ( ( columns[i].tables & tool_inComparison ) == 0 )
		{
			continue;
		}
		const char* bold = verdict->best[i] ? "**" : "";
		if ( isfinite( value ) )
		{
			fprintf( stream, " %s%.*f%s |", bold, columns[i].decimals, value, bold );
		}
		else
		{
			fputs( " - |", stream );
		}
	}
	fputc( '\n', stream );
}

void toolPrintComparisonsMarkdown( FILE* stream, const toolComparisons* comparisons )
{
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		const toolComparison* comparison = comparisons->items + i;
		fprintf( stream, "### %s over %s\n\n", comparisons->clip, comparison->table.cells[0].ground );
		toolPrintMarkdownHeads( stream );
		for ( int32_t k = 0; k < comparison->table.cellCount; ++k )
		{
			toolPrintMarkdownRow( stream, comparison->table.cells + k, comparison->verdicts + k );
		}
		fputc( '\n', stream );
		toolPrintVerdict( stream, comparison, comparisons->own );
		fputc( '\n', stream );
	}
	toolPrintLeftOut( stream, comparisons );
	if ( toolHasOwn( comparisons ) )
	{
		toolPrintSum( stream, comparisons );
	}
}

// ------------------------------------------------------------------------------------------------------------ json

static struct json_object* toolNamesToJson( const bool* marked )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( marked[i] )
		{
			json_object_array_add( list, json_object_new_string( columns[i].name ) );
		}
	}
	return list;
}

struct json_object* toolComparisonsToJson( const soleRig* rig, const toolComparisons* comparisons )
{
	struct json_object* list = json_object_new_array();
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		const toolTable* table = &comparisons->items[i].table;
		for ( int32_t k = 0; k < table->cellCount; ++k )
		{
			const toolTableCell* cell = table->cells + k;
			const toolVerdict* verdict = comparisons->items[i].verdicts + k;
			struct json_object* entry = toolCellToJson( rig, table, cell );
			json_object_object_add( entry, "scene", json_object_new_string( cell->ground ) );
			json_object_object_add( entry, "plants", json_object_new_boolean( verdict->judged ) );
			json_object_object_add( entry, "best", toolNamesToJson( verdict->best ) );
			json_object_object_add( entry, "behind", toolNamesToJson( verdict->behind ) );
			json_object_array_add( list, entry );
		}
	}
	return list;
}
