// SPDX-License-Identifier: MIT
// Methods side by side: who is judged, who is best or as good as the best, and that text and JSON say the same.
#define _POSIX_C_SOURCE 200809L
#include "test.h"

#include "compare.h"
#include "table_input.h"

#include <json-c/json.h>

#define MOST_CELLS 4

static void placeNothing( void* memory, const toolMethodStep* step )
{
	(void)memory;
	(void)step;
}

// "still" tries, but leaves every pose as it is.
static const toolMethod still = { "still", "", NULL, placeNothing };

// -------------------------------------------------------------------------------------------------------- judging

/// Cells that plant well and are all alike.
static void makeCells( toolTableCell* cells, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		cells[i] = ( toolTableCell ){ .ground = "here", .fps = 60, .method = &still, .isBase = true };
		soleLegFigures* all = &cells[i].figures.all;
		all->labelledFrames = 100;
		all->contactShare = 0.8;
		all->penetration.p95 = 0.001;
		all->hover.p95 = 0.001;
		all->slide = 0.02;
		all->swings = 10;
		all->clearance = 0.02;
		all->kneeAccelerationRms = 10.0;
		cells[i].reference.all.kneeAccelerationRms = 10.0;
		cells[i].shortfall = 0.002;
	}
}

static int32_t findColumn( const char* name )
{
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( strcmp( columns[i].name, name ) == 0 )
		{
			return i;
		}
	}
	fail_msg( "there is no column %s", name );
	return 0;
}

static void checkVerdicts( const toolTableCell* cells, int32_t count, const char* column, const char* expected )
{
	toolVerdict verdicts[MOST_CELLS];
	toolJudgeCells( cells, count, verdicts );
	int32_t k = findColumn( column );
	for ( int32_t i = 0; i < count; ++i )
	{
		// b: best or equal, -: behind, blank: neither
		char found = ' ';
		found = verdicts[i].behind[k] ? '-' : found;
		found = verdicts[i].best[k] ? 'b' : found;
		assert_false( verdicts[i].best[k] && verdicts[i].behind[k] );
		if ( found != expected[i] )
		{
			fail_msg( "%s, method %d: '%c' where it should be '%c'", column, i, found, expected[i] );
		}
	}
}

static void theBestAndItsEqualsAreFound( void** state )
{
	(void)state;
	toolTableCell cells[4];
	makeCells( cells, 4 );
	cells[0].figures.all.slide = 0.0200;
	cells[1].figures.all.slide = 0.0209; // 4.5 % more
	cells[2].figures.all.slide = 0.0220; // 10 % more
	cells[3].figures.all.slide = 0.0500;
	checkVerdicts( cells, 4, "slide", "bb--" );
	// What is not seen makes no difference, however large its share: 0.1 mm are shown.
	makeCells( cells, 4 );
	cells[0].figures.all.penetration.max = 0.0;
	cells[1].figures.all.penetration.max = 0.00009;
	cells[2].figures.all.penetration.max = 0.00011;
	cells[3].figures.all.penetration.max = 0.01;
	checkVerdicts( cells, 4, "penetrationMax", "bb--" );
	// A frame more is a frame more.
	cells[1].figures.all.overExtended = 1;
	checkVerdicts( cells, 4, "overExtended", "b-bb" );
	// Ratios are judged as ratios.
	cells[0].reference.all.kneeAccelerationRms = 20.0;
	checkVerdicts( cells, 4, "kneeAccelerationRms", "b---" );
}

static void moreIsBetterWhereItIs( void** state )
{
	(void)state;
	toolTableCell cells[3];
	makeCells( cells, 3 );
	cells[0].figures.all.contactShare = 0.9;
	cells[1].figures.all.contactShare = 0.86;
	cells[2].figures.all.contactShare = 0.7;
	checkVerdicts( cells, 3, "contactShare", "bb-" );
	cells[0].figures.all.clearance = -0.050;
	cells[1].figures.all.clearance = -0.051;
	cells[2].figures.all.clearance = -0.080;
	checkVerdicts( cells, 3, "clearance", "bb-" );
}

static void whatHasNoFigureIsNeitherBestNorBehind( void** state )
{
	(void)state;
	toolTableCell cells[3];
	makeCells( cells, 3 );
	cells[0].shortfall = (double)NAN;
	cells[2].shortfall = 0.010;
	checkVerdicts( cells, 3, "reachShortfall", " b-" );
	cells[1].shortfall = cells[2].shortfall = (double)NAN;
	checkVerdicts( cells, 3, "reachShortfall", "   " );
	cells[1].figures.all.swings = 0;
	checkVerdicts( cells, 3, "clearance", "b b" );
}

static void whatIsNotComparedIsNotJudged( void** state )
{
	(void)state;
	toolTableCell cells[2];
	makeCells( cells, 2 );
	checkVerdicts( cells, 2, "slideInput", "  " );
	checkVerdicts( cells, 2, "frames", "  " );
}

static void whoDoesNotPlantIsNotJudged( void** state )
{
	(void)state;
	toolTableCell cells[4];
	makeCells( cells, 4 );
	// In the air nothing slides, and nothing of it counts.
	cells[1].figures.all.hover.p95 = 0.2;
	cells[1].figures.all.slide = 0.0;
	cells[2].figures.all.penetration.p95 = 0.06;
	cells[2].figures.all.slide = 0.0;
	cells[3].figures.all.contactShare = 0.3;
	cells[3].figures.all.slide = 0.0;
	checkVerdicts( cells, 4, "slide", "b   " );
	makeCells( cells, 4 );
	cells[1].figures.all.labelledFrames = 0;
	cells[2].method = toolFindMethod( "none" );
	cells[3].figures.all.hover.p95 = 0.049;
	checkVerdicts( cells, 4, "slide", "b  b" );
}

static void onAGroundThatIsHardForAllTheLeastBadAreJudged( void** state )
{
	(void)state;
	toolTableCell cells[3];
	makeCells( cells, 3 );
	cells[0].figures.all.penetration.p95 = 0.08;
	cells[1].figures.all.hover.p95 = 0.15;
	cells[2].figures.all.penetration.p95 = 0.17;
	checkVerdicts( cells, 3, "slide", "bb " );
}

// --------------------------------------------------------------------------------------------------------- baking

typedef struct testFiles
{
	toolTableInput input;
	toolTableFiles files;
	toolComparisons comparisons;
} testFiles;

/// The mannequin's walk with sole, none and still, on the flat and on stairs.
static int openFiles( void** state )
{
	testFiles* test = toolAlloc( 1, sizeof *test );
	toolError error = { { 0 } };
	test->input = toolDefaultTableInput();
	test->input.character = "mannequin";
	test->input.clip = "walk";
	toolAddGround( "flat", &test->input );
	toolAddGround( "T02", &test->input );
	assert_true( toolOpenTableFiles( &test->input, &test->files, &error ) );
	const toolMethod* methods[3] = { toolFindMethod( "sole" ), toolFindMethod( "none" ), &still };
	int32_t rate = 30;
	toolTableDef def = toolMakeTableDef( &test->input, &test->files );
	def.methods = methods;
	def.methodCount = 3;
	def.rates = &rate;
	def.rateCount = 1;
	test->comparisons = ( toolComparisons ){ "someone", "walk", toolAlloc( 2, sizeof( toolComparison ) ), 2,
		toolAlloc( 1, sizeof( char* ) ), 1, methods[0] };
	test->comparisons.leftOut[0] = toolCopyString( "wall: too high" );
	for ( int32_t i = 0; i < 2; ++i )
	{
		assert_true( toolCompareOn( &def, i, test->comparisons.items + i, &error ) );
	}
	*state = test;
	return 0;
}

static int closeFiles( void** state )
{
	testFiles* test = *state;
	toolFreeComparisons( &test->comparisons );
	toolCloseTableFiles( &test->files );
	toolFreeTableInput( &test->input );
	free( test );
	return 0;
}

static void methodsAreMeasuredSideBySide( void** state )
{
	const testFiles* test = *state;
	const toolComparison* flat = test->comparisons.items;
	const toolComparison* stairs = test->comparisons.items + 1;
	assert_int_equal( flat->table.cellCount, 3 );
	assert_string_equal( stairs->table.cells[2].ground, "T02" );
	assert_int_equal( stairs->table.cells[2].fps, 30 );
	// Who does nothing does not plant on stairs, and does on the flat; who has no step is never judged.
	assert_true( flat->verdicts[0].judged && stairs->verdicts[0].judged );
	assert_false( flat->verdicts[1].judged || stairs->verdicts[1].judged );
	assert_true( flat->verdicts[2].judged );
	assert_false( stairs->verdicts[2].judged );
	assert_true(
	    memcmp( &stairs->table.cells[1].figures, &stairs->table.cells[2].figures, sizeof( soleFigures ) ) == 0 );
	// Only Sole tells what it did not reach.
	assert_true( stairs->table.cells[0].shortfall >= 0.0 && stairs->table.cells[0].shortfall < 0.1 );
	assert_true( isnan( stairs->table.cells[1].shortfall ) && isnan( stairs->table.cells[2].shortfall ) );
	// Untouched poses deviate by nothing.
	assert_true( flat->table.cells[2].figures.deviation < 1e-6 );
	assert_true( stairs->table.cells[0].figures.deviation > 0.01 );
}

static char* tell( const toolComparisons* comparisons, void ( *print )( FILE* stream, const toolComparisons* ) )
{
	char* text = NULL;
	size_t length = 0;
	FILE* stream = open_memstream( &text, &length );
	assert_non_null( stream );
	print( stream, comparisons );
	fclose( stream );
	char* copy = toolCopyString( text );
	free( text );
	return copy;
}

static int32_t countOf( const char* text, const char* part )
{
	int32_t count = 0;
	for ( const char* at = strstr( text, part ); at != NULL; at = strstr( at + 1, part ) )
	{
		++count;
	}
	return count;
}

static int32_t countMarked( const bool* marked )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < TOOL_MOST_COLUMNS; ++i )
	{
		count += marked[i];
	}
	return count;
}

static int32_t countBest( const toolComparisons* comparisons )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < comparisons->count; ++i )
	{
		for ( int32_t k = 0; k < comparisons->items[i].table.cellCount; ++k )
		{
			count += countMarked( comparisons->items[i].verdicts[k].best );
		}
	}
	return count;
}

static void textMarksTheBestAndSaysWhereSoleIsNot( void** state )
{
	const testFiles* test = *state;
	char* text = tell( &test->comparisons, toolPrintComparisons );
	assert_int_equal( countOf( text, "\nT02   " ), 3 );
	assert_int_equal( countOf( text, "\nflat  " ), 3 );
	assert_int_equal( countOf( text, "*" ), countBest( &test->comparisons ) + 1 ); // and the one that is explained
	assert_non_null( strstr( text, "\nT02: sole alone plants. Does not plant: still.\n" ) );
	assert_non_null( strstr( text, "\nflat: of 2 methods that plant, sole is best or equal in " ) );
	assert_non_null( strstr( text, "\nLeft out: wall: too high\n" ) );
	// Where it is alone it is no merit to be best.
	const toolVerdict* flat = test->comparisons.items[0].verdicts;
	char sum[160];
	snprintf( sum, sizeof sum,
	    "\nGrounds: 2. sole plants on 2, alone on 1; beside others it is best or equal in %d figures of %d",
	    countMarked( flat->best ), countMarked( flat->best ) + countMarked( flat->behind ) );
	assert_non_null( strstr( text, sum ) );
	// Whether Sole is behind on the flat, and in what, is told as the verdicts have it.
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		char part[64];
		snprintf( part, sizeof part, "%s (1)", columns[i].title );
		assert_int_equal( countOf( text, part ), flat->behind[i] );
	}
	free( text );
}

static void markdownHasAColumnForEachFigure( void** state )
{
	const testFiles* test = *state;
	char* text = tell( &test->comparisons, toolPrintComparisonsMarkdown );
	int32_t count;
	const toolColumn* columns = toolGetColumns( &count );
	int32_t compared = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		compared += ( columns[i].tables & tool_inComparison ) != 0;
	}
	assert_int_equal( countOf( text, "### walk over " ), 2 );
	assert_int_equal( countOf( text, "**" ), 2 * countBest( &test->comparisons ) );
	int32_t rows = 0;
	for ( const char* line = text; *line != 0; line = strchr( line, '\n' ) + 1 )
	{
		int32_t bars = 0;
		for ( const char* c = line; *c != '\n'; ++c )
		{
			bars += *c == '|';
		}
		assert_true( bars == 0 || bars == compared + 2 );
		rows += bars > 0;
	}
	assert_int_equal( rows, 2 * ( 2 + 3 ) );
	free( text );
}

static void jsonListsWhatVerdictsHave( void** state )
{
	const testFiles* test = *state;
	struct json_object* list = toolComparisonsToJson( test->files.character.rig, &test->comparisons );
	assert_int_equal( json_object_array_length( list ), 6 );
	size_t best = 0;
	for ( size_t i = 0; i < 6; ++i )
	{
		struct json_object* item = json_object_array_get_idx( list, i );
		const toolComparison* comparison = test->comparisons.items + i / 3;
		assert_string_equal(
		    json_object_get_string( json_object_object_get( item, "scene" ) ), i < 3 ? "flat" : "T02" );
		assert_int_equal(
		    json_object_get_boolean( json_object_object_get( item, "plants" ) ), comparison->verdicts[i % 3].judged );
		struct json_object* names = json_object_object_get( item, "best" );
		best += json_object_array_length( names );
		for ( size_t k = 0; k < json_object_array_length( names ); ++k )
		{
			const char* name = json_object_get_string( json_object_array_get_idx( names, k ) );
			assert_true( comparison->verdicts[i % 3].best[findColumn( name )] );
		}
	}
	assert_int_equal( best, countBest( &test->comparisons ) );
	json_object_put( list );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( theBestAndItsEqualsAreFound ),
		cmocka_unit_test( moreIsBetterWhereItIs ),
		cmocka_unit_test( whatHasNoFigureIsNeitherBestNorBehind ),
		cmocka_unit_test( whatIsNotComparedIsNotJudged ),
		cmocka_unit_test( whoDoesNotPlantIsNotJudged ),
		cmocka_unit_test( onAGroundThatIsHardForAllTheLeastBadAreJudged ),
		cmocka_unit_test( methodsAreMeasuredSideBySide ),
		cmocka_unit_test( textMarksTheBestAndSaysWhereSoleIsNot ),
		cmocka_unit_test( markdownHasAColumnForEachFigure ),
		cmocka_unit_test( jsonListsWhatVerdictsHave ),
	};
	return cmocka_run_group_tests( tests, openFiles, closeFiles );
}
