// SPDX-License-Identifier: MIT
// Methods side by side: which of them plant their feet on a ground, and which is best in which figure.
//
// A method that places nothing is shown and never judged: what it is best in it is by doing nothing. Nor is one that
// does not plant. A method plants on a ground where
//   u = max( penetration p95, hover p95 ) is at most 50 mm, the height below which published
//   figures count a foot as on the ground, or twice the least u of all methods, if that is more, and
//   its contact share is at least half of the largest of all methods.
// Of those that plant the best of each column is sought. Equal is what differs by at most 5 % of the best, or by less
// than one step of the last digit that is shown.
#ifndef TOOL_COMPARE_H
#define TOOL_COMPARE_H

#include "columns.h"

/// How one method did on one ground.
typedef struct toolVerdict
{
	bool judged; // the method plants, so that it may be best
	/// By column; false where it is not judged or the column is not compared.
	bool best[TOOL_MOST_COLUMNS];   // or equal to it
	bool behind[TOOL_MOST_COLUMNS]; // another is better; false as well where the method has no such figure
} toolVerdict;

typedef struct toolComparison
{
	toolTable table;       // one cell a method
	toolVerdict* verdicts; // likewise
} toolComparison;

/// @param def of one rate, and of one ground at a time: others are passed over
/// @param ground index
bool toolCompareOn( const toolTableDef* def, int32_t ground, toolComparison* comparison, toolError* error );
void toolFreeComparison( toolComparison* comparison );

/// Judges cells of one ground. For toolCompareOn(), and to be tried on figures from elsewhere.
void toolJudgeCells( const toolTableCell* cells, int32_t cellCount, toolVerdict* verdicts );

// ----------------------------------------------------------------------------------------------------------- tell

/// A clip over all grounds.
typedef struct toolComparisons
{
	const char* character;
	const char* clip;
	toolComparison* items;
	int32_t count;
	/// Grounds that could not be walked, and why.
	char** leftOut;
	int32_t leftOutCount;
	/// Whose verdicts are told in words. NULL: nobody's.
	const toolMethod* own;
} toolComparisons;

void toolFreeComparisons( toolComparisons* comparisons );

void toolPrintComparisons( FILE* stream, const toolComparisons* comparisons );
void toolPrintComparisonsMarkdown( FILE* stream, const toolComparisons* comparisons );
/// A list of cells as toolCellToJson() has them, with "scene", "plants", "best" and "behind" added: the last two list
/// names of columns.
struct json_object* toolComparisonsToJson( const soleRig* rig, const toolComparisons* comparisons );

#endif
