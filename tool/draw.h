// SPDX-License-Identifier: MIT
// Pictures as SVG text: line plots and shaded views of triangles. Readable on white and on dark pages.
#ifndef TOOL_DRAW_H
#define TOOL_DRAW_H

#include "skin.h"

/// A picture that grows. Numbers that are not finite are written as 0: the file is always well-formed.
typedef struct toolSvg toolSvg;

/// width and height in pixels.
toolSvg* toolSvgBegin( double width, double height );
/// Closes the picture and frees it. @return the text, which the caller frees
char* toolSvgEnd( toolSvg* svg );

typedef enum toolAnchor
{
	tool_anchorStart,
	tool_anchorMiddle,
	tool_anchorEnd
} toolAnchor;

/// Text at its baseline; size in pixels; any text, it is escaped.
void toolSvgText( toolSvg* svg, double x, double y, double size, toolAnchor anchor, const char* text );

/// Where in the picture, pixels.
typedef struct toolBox
{
	double x;
	double y;
	double width;
	double height;
} toolBox;

typedef struct toolSeries
{
	const char* name;  // in the legend, or NULL
	const char* color; // CSS; NULL takes one by its index
	bool dashed;
	int32_t count;
	const float* x;
	const float* y; // not finite: a gap in the line
} toolSeries;

/// A shaded interval along x, like the time in which a foot is planted.
typedef struct toolInterval
{
	float start;
	float end;
} toolInterval;

typedef struct toolPlot
{
	toolBox box;
	const char* title;
	const char* xLabel; // with the unit
	const char* yLabel;
	int32_t seriesCount;
	const toolSeries* series;
	int32_t intervalCount;
	const toolInterval* intervals;
	const char* intervalName; // in the legend, or NULL
	/// Ranges of the axes; where low == high they fit the series.
	float xLow;
	float xHigh;
	float yLow;
	float yHigh;
} toolPlot;

void toolSvgPlot( toolSvg* svg, const toolPlot* plot );

/// Triangles to be seen together.
typedef struct toolSceneItem
{
	const toolTriangles* triangles;
	float opacity; // 1 is solid
	/// A ground: cut into small pieces, finer near the other items, so that sorting by depth holds.
	bool ground;
} toolSceneItem;

typedef struct toolSceneView
{
	toolBox box;
	soleVec3 eye;
	soleVec3 target;
	soleVec3 up;
	/// Vertical opening angle in radians; 0 for a parallel view of this height.
	float fieldOfView;
	float viewHeight; // m, parallel views
	int32_t itemCount;
	const toolSceneItem* items;
} toolSceneView;

/// Flat shading, back faces left out, far triangles first.
void toolSvgScene( toolSvg* svg, const toolSceneView* view );

/// For the files that draw: printf at the picture's end.
void toolSvgPrint( toolSvg* svg, const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 2, 3 ) ) )
#endif
    ;
/// For text between tags and in attributes.
void toolSvgEscape( toolSvg* svg, const char* text );
/// The number, or 0 where it is not finite; at most 1e7 either way.
double toolSvgNumber( double x );
/// A new id for a clip path.
int32_t toolSvgNewId( toolSvg* svg );

#endif
