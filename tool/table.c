// SPDX-License-Identifier: MIT
// Bakes and measures the cells of a table, and judges them. The targets are those of the project's benchmark: stairs,
// ramps up to 30 degrees and rubble.
#include "table.h"

#include <math.h>
#include <stdlib.h>

// -------------------------------------------------------------------------------------------------------- targets

static const toolTarget toolTargets[] = {
	{ "penetrationP95", 0.002, 0.0, tool_rowPenetrationP95, false },
	{ "penetrationMax", 0.010, 0.0, tool_rowPenetrationMax, false },
	{ "hoverP95", 0.005, 0.0, tool_rowHoverP95, false },
	{ "contactShare", 0.85, 0.0, tool_rowShare, true },
	{ "slide", 0.001, 1.1, tool_rowSlide, false }, // of a clip that stands anything would be too much
	{ "driftMax", 0.005, 1.1, tool_rowDriftMax, false },
	{ "kneeAccelerationRms", 0.0, 1.3, tool_rowKnee, false },
	{ "pelvisJerk", 0.0, 1.5, tool_rowPelvisJerk, false },
	{ "overExtended", 0.0, 0.0, tool_rowOverExtended, false },
	{ "largestJump", 0.0, 1.5, tool_rowJump, false },
	{ "rateMax", 0.003, 0.0, tool_rowRateMax, false },
};

const toolTarget* toolGetTargets( int32_t* count )
{
	*count = (int32_t)( sizeof toolTargets / sizeof toolTargets[0] );
	return toolTargets;
}

static double toolPickFigure( const soleFigures* figures, toolRowFigure figure )
{
	const soleLegFigures* all = &figures->all;
	switch ( figure )
	{
	case tool_rowFrames:
		return (double)all->labelledFrames;
	case tool_rowPenetrationP95:
		return all->penetration.p95;
	case tool_rowPenetrationMax:
		return all->penetration.max;
	case tool_rowHoverP95:
		return all->hover.p95;
	case tool_rowShare:
		return all->contactShare;
	case tool_rowSlide:
		return all->slide;
	case tool_rowDriftMean:
		return all->drift.mean;
	case tool_rowDriftMax:
		return all->drift.max;
	case tool_rowKnee:
		return all->kneeAccelerationRms;
	case tool_rowPelvisJerk:
		return figures->pelvisJerk;
	case tool_rowPelvisStep:
		return figures->pelvisLargestStep;
	case tool_rowOverExtended:
		return (double)all->overExtended;
	case tool_rowJump:
		return all->largestJump;
	case tool_rowClearance:
		return all->swings > 0 ? all->clearance : (double)NAN;
	case tool_rowScuffs:
		return all->swings > 0 ? (double)all->scuffs : (double)NAN;
	case tool_rowDeviation:
		return figures->deviation;
	default:
		return (double)NAN;
	}
}

double toolGetRowFigure( const toolTableCell* cell, toolRowFigure figure )
{
	if ( figure == tool_rowRateP95 || figure == tool_rowRateMax )
	{
		double distance = figure == tool_rowRateMax ? cell->rate.max : cell->rate.p95;
		return cell->isBase ? (double)NAN : distance;
	}
	return figure == tool_rowShortfall ? cell->shortfall : toolPickFigure( &cell->figures, figure );
}

double toolGetRowReference( const toolTableCell* cell, toolRowFigure figure )
{
	return toolPickFigure( &cell->reference, figure );
}

double toolGetLimit( const toolTarget* target, const toolTableCell* cell )
{
	double ofInput =
	    target->ofInput > 0.0 ? target->ofInput * toolGetRowReference( cell, target->figure ) : target->limit;
	return fmax( target->limit, ofInput );
}

double toolGetExcess( const toolTarget* target, const toolTableCell* cell )
{
	// Without contacts figures over contacts are empty, not good.
	if ( cell->figures.all.labelledFrames == 0 )
	{
		return (double)NAN;
	}
	double figure = toolGetRowFigure( cell, target->figure );
	double limit = toolGetLimit( target, cell );
	if ( limit <= 0.0 )
	{
		return 1.0 + figure;
	}
	return target->atLeast ? limit / figure : figure / limit;
}

// ----------------------------------------------------------------------------------------------------------- make

/// A ground as it is baked on, and the way over it.
typedef struct toolTableGround
{
	toolGroundSource source;
	soleTerrain* terrain;
	toolPlace start;
	toolBakeDef bake;
} toolTableGround;

static void toolCloseTableGround( toolTableGround* ground )
{
	soleDestroyTerrain( ground->terrain );
	toolCloseGround( &ground->source );
}

static bool toolOpenTableGround( const toolTableDef* def, const char* name, toolTableGround* ground, toolError* error )
{
	*ground = ( toolTableGround ){ .bake = toolDefaultBakeDef() };
	if ( toolOpenGround( name, &ground->source, error ) == false )
	{
		return false;
	}
	static const toolWayOptions own = { 0 };
	const toolWayOptions* way = ground->source.path == NULL && def->way != NULL ? def->way : &own;
	ground->bake.settings = def->settings;
	ground->bake.groundName = name;
	bool good = toolMakeTerrain( &ground->source, &ground->terrain, error ) &&
	    toolLayWay( way, def->character, def->travel, &ground->source, &ground->start, &ground->bake, error );
	if ( good == false )
	{
		toolCloseTableGround( ground );
	}
	return good;
}

static bool toolBakeAt( const toolTableDef* def, const toolTableGround* ground, const toolMethod* method, int32_t fps,
    toolBakeResult* result, toolError* error )
{
	toolBakeDef bake = ground->bake;
	bake.method = method;
	bake.fps = (double)fps;
	return toolBake( def->character, def->bound, def->travel, ground->source.ground, &bake, result, error );
}

static soleMotion toolOutputMotion( const toolCharacter* character, const toolBakeResult* result )
{
	return ( soleMotion ){
		.rig = character->rig,
		.frameCount = result->walk.frameCount,
		.frameRate = (float)result->walk.fps,
		.poses = result->output,
		.roots = result->walk.roots,
		.up = soleVec( 0.0f, 1.0f, 0.0f ),
	};
}

static bool toolMeasureCell( const toolTableDef* def, const toolTableGround* ground, const toolBakeResult* result,
    const toolBakeResult* base, toolTableCell* cell, toolError* error )
{
	toolTake take;
	if ( toolMakeBakeTake( def->character, result, &take, error ) == false )
	{
		return false;
	}
	cell->isBase = result == base;
	cell->shortfall = toolFindShortfall( result, &take );
	bool good = toolMeasureTake( def->character, &take, ground->terrain, &cell->figures, &cell->reference, error );
	toolFreeTake( &take );
	if ( good == false || cell->isBase )
	{
		return good;
	}
	soleMotion motion = toolOutputMotion( def->character, result );
	soleMotion other = toolOutputMotion( def->character, base );
	double start = (double)toolGetSettleFrames( other.frameCount, base->walk.fps ) / base->walk.fps;
	soleMessage message = { { 0 } };
	soleResult compared = soleCompareMotions( &motion, &other, (float)start, NULL, &cell->rate, &message );
	return compared == sole_success || toolFail( error, "%d fps: %s", cell->fps, message.text );
}

/// Cells of one ground and method, all rates.
static bool toolMakeCells( const toolTableDef* def, const toolTableGround* ground, const toolMethod* method,
    toolTable* table, toolError* error )
{
	toolBakeResult base;
	if ( toolBakeAt( def, ground, method, TOOL_BASE_RATE, &base, error ) == false )
	{
		return false;
	}
	bool good = true;
	int32_t total = def->groundCount * def->methodCount * def->rateCount;
	for ( int32_t i = 0; i < def->rateCount && good; ++i )
	{
		toolTableCell* cell = table->cells + table->cellCount++;
		*cell = ( toolTableCell ){ .ground = ground->bake.groundName, .fps = def->rates[i], .method = method };
		if ( cell->fps == TOOL_BASE_RATE )
		{
			good = toolMeasureCell( def, ground, &base, &base, cell, error );
		}
		else
		{
			toolBakeResult result;
			good = toolBakeAt( def, ground, method, cell->fps, &result, error );
			good = good && toolMeasureCell( def, ground, &result, &base, cell, error );
			toolFreeBakeResult( &result );
		}
		if ( def->progress != NULL )
		{
			def->progress( def->user, (double)table->cellCount / (double)total );
		}
	}
	toolFreeBakeResult( &base );
	return good;
}

bool toolMakeTable( const toolTableDef* def, toolTable* table, toolError* error )
{
	int32_t total = def->groundCount * def->methodCount * def->rateCount;
	*table = ( toolTable ){ .clip = def->bound->clip->name, .cells = toolAlloc( (size_t)total, sizeof *table->cells ) };
	bool good = true;
	for ( int32_t g = 0; g < def->groundCount && good; ++g )
	{
		toolTableGround ground;
		if ( toolOpenTableGround( def, def->grounds[g], &ground, error ) == false )
		{
			good = false;
			break;
		}
		for ( int32_t k = 0; k < def->methodCount && good; ++k )
		{
			good = toolMakeCells( def, &ground, def->methods[k], table, error );
		}
		toolCloseTableGround( &ground );
	}
	if ( good == false )
	{
		toolFreeTable( table );
	}
	return good;
}

void toolFreeTable( toolTable* table )
{
	free( table->cells );
	*table = ( toolTable ){ 0 };
}
