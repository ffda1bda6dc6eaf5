// SPDX-License-Identifier: MIT
// Figures as a table of text and as JSON.
#include "figures_text.h"

#include <json-c/json.h>
#include <math.h>
#include <string.h>

#define PI 3.14159265358979

typedef enum toolFigureType
{
	tool_figureDouble,
	tool_figureCount // int32
} toolFigureType;

/// Where a figure is, what it is called, and how people like to read it.
typedef struct toolFigure
{
	const char* group; // JSON object that it is in, or NULL
	const char* name;  // in JSON
	const char* text;
	const char* unit;
	double factor; // from SI to that unit
	int decimals;
	toolFigureType type;
	size_t offset;
} toolFigure;

#define LEG( group, name, text, unit, factor, decimals, member )                                                       \
	{                                                                                                                  \
		group, name, text, unit, factor, decimals, tool_figureDouble, offsetof( soleLegFigures, member )               \
	}
#define LEG_COUNT( name, text, unit, member )                                                                          \
	{                                                                                                                  \
		NULL, name, text, unit, 1.0, 0, tool_figureCount, offsetof( soleLegFigures, member )                           \
	}
#define BODY( name, text, unit, factor, decimals, member )                                                             \
	{                                                                                                                  \
		NULL, name, text, unit, factor, decimals, tool_figureDouble, offsetof( soleFigures, member )                   \
	}

static const toolFigure toolLegFigures[] = {
	LEG_COUNT( "labelledFrames", "contact", "frames", labelledFrames ),
	LEG( "penetration", "mean", "sole penetration, mean", "mm", 1e3, 2, penetration.mean ),
	LEG( "penetration", "p95", "sole penetration, p95", "mm", 1e3, 2, penetration.p95 ),
	LEG( "penetration", "max", "sole penetration, max", "mm", 1e3, 2, penetration.max ),
	LEG( "verticalPenetration", "mean", NULL, "mm", 1e3, 2, verticalPenetration.mean ),
	LEG( "verticalPenetration", "p95", "along up, p95", "mm", 1e3, 2, verticalPenetration.p95 ),
	LEG( "verticalPenetration", "max", "along up, max", "mm", 1e3, 2, verticalPenetration.max ),
	LEG( "hover", "mean", "hover, mean", "mm", 1e3, 2, hover.mean ),
	LEG( "hover", "p95", "hover, p95", "mm", 1e3, 2, hover.p95 ),
	LEG( "hover", "max", "hover, max", "mm", 1e3, 2, hover.max ),
	LEG( NULL, "contactShare", "sole in contact", "%", 1e2, 1, contactShare ),
	LEG( NULL, "slide", "slide", "cm/s", 1e2, 2, slide ),
	LEG( "drift", "mean", "drift per stance, mean", "mm", 1e3, 2, drift.mean ),
	LEG( "drift", "p95", NULL, "mm", 1e3, 2, drift.p95 ),
	LEG( "drift", "max", "drift per stance, max", "mm", 1e3, 2, drift.max ),
	LEG_COUNT( "stances", "stances", "", stances ),
	LEG_COUNT( "overExtended", "over-extended", "frames", overExtended ),
	LEG_COUNT( "swings", "swings", "", swings ),
	LEG_COUNT( "scuffs", "under the ground in swing", "", scuffs ),
	LEG( NULL, "clearance", "clearance in swing, p5", "mm", 1e3, 1, clearance ),
	LEG( NULL, "kneeAccelerationRms", "knee acceleration, RMS", "deg/s2", 180.0 / PI, 0, kneeAccelerationRms ),
	LEG( NULL, "kneeAccelerationMax", "knee acceleration, max", "deg/s2", 180.0 / PI, 0, kneeAccelerationMax ),
	LEG( NULL, "largestJump", "largest joint step", "deg", 180.0 / PI, 2, largestJump ),
};

static const toolFigure toolBodyFigures[] = {
	BODY( "pelvisJerk", "pelvis jerk, RMS", "m/s3", 1.0, 1, pelvisJerk ),
	BODY( "pelvisLargestStep", "pelvis, largest step", "mm", 1e3, 2, pelvisLargestStep ),
	BODY( "deviation", "deviation from reference", "deg", 180.0 / PI, 2, deviation ),
	BODY( "pelvisOffsetRms", "pelvis offset, RMS", "mm", 1e3, 2, pelvisOffsetRms ),
	BODY( "pelvisOffsetMax", "pelvis offset, max", "mm", 1e3, 2, pelvisOffsetMax ),
};

/// Offsets in soleFigures.
static const toolFigure toolRatios[] = {
	BODY( "slide", "slide", "x", 1.0, 2, all.slide ),
	BODY( "drift", "drift per stance, mean", "x", 1.0, 2, all.drift.mean ),
	BODY( "kneeAccelerationRms", "knee acceleration, RMS", "x", 1.0, 2, all.kneeAccelerationRms ),
	BODY( "pelvisJerk", "pelvis jerk, RMS", "x", 1.0, 2, pelvisJerk ),
	BODY( "largestJump", "largest joint step", "x", 1.0, 2, all.largestJump ),
};

#define PUBLISHED( group, name, text, unit, factor, decimals, member )                                                 \
	{                                                                                                                  \
		group, name, text, unit, factor, decimals, tool_figureDouble, offsetof( solePublishedFigures, member )         \
	}

static const toolFigure toolPublishedFigures[] = {
	PUBLISHED( "mann", "step", "MANN s", "cm", 1e2, 3, mannStep ),
	PUBLISHED( "mann", "speed", "MANN s a second", "cm/s", 1e2, 2, mannSpeed ),
	PUBLISHED( "mvae", "step", "MVAE s", "cm", 1e2, 3, mvaeStep ),
	PUBLISHED( "mvae", "speed", "MVAE s a second", "cm/s", 1e2, 2, mvaeSpeed ),
	PUBLISHED( NULL, "skatingRatio", "GMD skating ratio", "", 1.0, 4, skatingRatio ),
	PUBLISHED( "kimodo", "ratio", "kimodo skate ratio", "", 1.0, 4, kimodoRatio ),
	PUBLISHED( "kimodo", "fromHeight", "kimodo, from height", "cm/s", 1e2, 2, kimodoHeightSpeed ),
	PUBLISHED( "kimodo", "fromContacts", "kimodo, from contacts", "cm/s", 1e2, 2, kimodoContactSpeed ),
	PUBLISHED( "kimodo", "maxSpeed", "kimodo, largest speed", "cm/s", 1e2, 2, kimodoContactMax ),
	PUBLISHED( "physDiff", "penetrate", "PhysDiff penetrate", "mm", 1e3, 3, physPenetration ),
	PUBLISHED( "physDiff", "float", "PhysDiff float", "mm", 1e3, 3, physFloat ),
	PUBLISHED( "physDiff", "skate", "PhysDiff skate", "mm", 1e3, 3, physSkate ),
	PUBLISHED( "physDiff", "error", "Phys-Err", "mm", 1e3, 3, physError ),
	PUBLISHED( NULL, "footContactScore", "EDGE PFC", "cm2", 1.0, 4, footContactScore ),
};

#undef LEG
#undef LEG_COUNT
#undef BODY
#undef PUBLISHED

#define COUNT_OF( table ) ( (int32_t)( sizeof( table ) / sizeof( table )[0] ) )

static double toolGetFigure( const toolFigure* figure, const void* figures )
{
	const char* at = (const char*)figures + figure->offset;
	if ( figure->type == tool_figureCount )
	{
		int32_t count;
		memcpy( &count, at, sizeof count );
		return (double)count;
	}
	double value;
	memcpy( &value, at, sizeof value );
	return value;
}

/// Not a number where the reference has nothing to compare with.
static double toolGetRatio( const toolFigure* figure, const soleFigures* figures, const soleFigures* reference )
{
	double below = reference != NULL ? toolGetFigure( figure, reference ) : 0.0;
	return below > 0.0 ? toolGetFigure( figure, figures ) / below : (double)NAN;
}

// ----------------------------------------------------------------------------------------------------------- text

static void toolPrintCell( FILE* stream, const toolFigureColumn* column, double value, int decimals )
{
	int width = (int)strlen( column->name ) + 2;
	width = width > 12 ? width : 12;
	if ( isfinite( value ) )
	{
		fprintf( stream, "%*.*f", width, decimals, value );
	}
	else
	{
		fprintf( stream, "%*s", width, "-" );
	}
}

static void toolPrintHead( FILE* stream, const char* what, const toolFigureColumn* columns, int32_t columnCount )
{
	fprintf( stream, "%-33s", what );
	for ( int32_t i = 0; i < columnCount; ++i )
	{
		fprintf( stream, "%*s%s", strlen( columns[i].name ) < 10 ? 12 - (int)strlen( columns[i].name ) : 2, "",
		    columns[i].name );
	}
	fputc( '\n', stream );
}

static const char* toolLegName( const soleRig* rig, int32_t leg )
{
	const char* name = soleRig_GetLeg( rig, leg ).name;
	return name != NULL && name[0] != 0 ? name : "leg";
}

/// What the rows of a table are taken from.
typedef enum toolRowSource
{
	tool_rowsOfLegs,
	tool_rowsOfBody,
	tool_rowsOfRatios,
	tool_rowsOfPublished
} toolRowSource;

/// In the unit that is printed; not a number where a column has none.
static double toolGetCell( const toolFigureColumn* column, toolRowSource source, int32_t leg, const toolFigure* figure )
{
	const soleFigures* figures = column->figures;
	switch ( source )
	{
	case tool_rowsOfLegs:
		return figure->factor * toolGetFigure( figure, leg == SOLE_NONE ? &figures->all : figures->legs + leg );
	case tool_rowsOfBody:
		return figure->factor * toolGetFigure( figure, figures );
	case tool_rowsOfRatios:
		return toolGetRatio( figure, figures, column->reference );
	default:
		return column->published != NULL ? figure->factor * toolGetFigure( figure, column->published ) : (double)NAN;
	}
}

/// @param leg of rows of legs; SOLE_NONE: all of them
static void toolPrintRows( FILE* stream, toolRowSource source, int32_t leg, const toolFigure* table, int32_t count,
    const toolFigureColumn* columns, int32_t columnCount )
{
	for ( int32_t row = 0; row < count; ++row )
	{
		const toolFigure* figure = table + row;
		if ( figure->text == NULL )
		{
			continue;
		}
		fprintf( stream, "  %-25s%-6s", figure->text, figure->unit );
		for ( int32_t i = 0; i < columnCount; ++i )
		{
			toolPrintCell( stream, columns + i, toolGetCell( columns + i, source, leg, figure ), figure->decimals );
		}
		fputc( '\n', stream );
	}
}

void toolPrintFigures( FILE* stream, const soleRig* rig, const toolFigureColumn* columns, int32_t columnCount )
{
	const int32_t legRows = COUNT_OF( toolLegFigures );
	bool ratios = false;
	bool published = false;
	for ( int32_t i = 0; i < columnCount; ++i )
	{
		ratios = ratios || columns[i].reference != NULL;
		published = published || columns[i].published != NULL;
	}
	toolPrintHead( stream, "whole", columns, columnCount );
	toolPrintRows( stream, tool_rowsOfLegs, SOLE_NONE, toolLegFigures, legRows, columns, columnCount );
	toolPrintRows(
	    stream, tool_rowsOfBody, SOLE_NONE, toolBodyFigures, COUNT_OF( toolBodyFigures ), columns, columnCount );
	for ( int32_t leg = 0; leg < soleRig_GetLegCount( rig ); ++leg )
	{
		fputc( '\n', stream );
		toolPrintHead( stream, toolLegName( rig, leg ), columns, columnCount );
		toolPrintRows( stream, tool_rowsOfLegs, leg, toolLegFigures, legRows, columns, columnCount );
	}
	if ( ratios )
	{
		fputc( '\n', stream );
		toolPrintHead( stream, "ratios to the reference", columns, columnCount );
		toolPrintRows( stream, tool_rowsOfRatios, SOLE_NONE, toolRatios, COUNT_OF( toolRatios ), columns, columnCount );
	}
	if ( published )
	{
		fputc( '\n', stream );
		toolPrintHead( stream, "as published", columns, columnCount );
		toolPrintRows( stream, tool_rowsOfPublished, SOLE_NONE, toolPublishedFigures, COUNT_OF( toolPublishedFigures ),
		    columns, columnCount );
	}
}

// ----------------------------------------------------------------------------------------------------------- json

static struct json_object* toolNumberToJson( double value, toolFigureType type )
{
	if ( isfinite( value ) == 0 )
	{
		return NULL; // null
	}
	return type == tool_figureCount ? json_object_new_int( (int32_t)value ) : json_object_new_double( value );
}

static void toolAddFigures( struct json_object* to, const toolFigure* table, int32_t count, const void* figures )
{
	for ( int32_t row = 0; row < count; ++row )
	{
		const toolFigure* figure = table + row;
		struct json_object* group = to;
		if ( figure->group != NULL && json_object_object_get_ex( to, figure->group, &group ) == 0 )
		{
			group = json_object_new_object();
			json_object_object_add( to, figure->group, group );
		}
		struct json_object* number = toolNumberToJson( toolGetFigure( figure, figures ), figure->type );
		json_object_object_add( group, figure->name, number );
	}
}

struct json_object* toolFiguresToJson( const soleRig* rig, const soleFigures* figures )
{
	struct json_object* object = json_object_new_object();
	struct json_object* legs = json_object_new_array();
	for ( int32_t leg = 0; leg < figures->legCount; ++leg )
	{
		struct json_object* item = json_object_new_object();
		json_object_object_add( item, "name", json_object_new_string( toolLegName( rig, leg ) ) );
		toolAddFigures( item, toolLegFigures, COUNT_OF( toolLegFigures ), figures->legs + leg );
		json_object_array_add( legs, item );
	}
	struct json_object* whole = json_object_new_object();
	toolAddFigures( whole, toolLegFigures, COUNT_OF( toolLegFigures ), &figures->all );
	toolAddFigures( whole, toolBodyFigures, COUNT_OF( toolBodyFigures ), figures );
	json_object_object_add( object, "legs", legs );
	json_object_object_add( object, "whole", whole );
	return object;
}

struct json_object* toolRatiosToJson( const soleFigures* figures, const soleFigures* reference )
{
	struct json_object* object = json_object_new_object();
	for ( int32_t row = 0; row < COUNT_OF( toolRatios ); ++row )
	{
		double ratio = toolGetRatio( toolRatios + row, figures, reference );
		json_object_object_add( object, toolRatios[row].name, toolNumberToJson( ratio, tool_figureDouble ) );
	}
	return object;
}

struct json_object* toolPublishedToJson( const solePublishedFigures* figures )
{
	struct json_object* object = json_object_new_object();
	toolAddFigures( object, toolPublishedFigures, COUNT_OF( toolPublishedFigures ), figures );
	return object;
}
