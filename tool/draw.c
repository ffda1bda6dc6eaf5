// SPDX-License-Identifier: MIT
// The SVG text itself, and line plots. Picture space: pixels, y down.
#include "draw.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define INK "#7a828c" // in between: seen on white and on dark pages
#define GRID "#8a929c"

struct toolSvg
{
	char* text;
	size_t length;
	size_t room;
	int32_t ids;
};

static void toolSvgRoom( toolSvg* svg, size_t more )
{
	if ( svg->length + more + 1 > svg->room )
	{
		svg->room = 2 * ( svg->length + more ) + 4096;
		svg->text = toolGrow( svg->text, svg->room, 1 );
	}
}

void toolSvgPrint( toolSvg* svg, const char* format, ... )
{
	va_list arguments;
	va_list again;
	va_start( arguments, format );
	va_copy( again, arguments );
	int count = vsnprintf( NULL, 0, format, again );
	va_end( again );
	if ( count > 0 )
	{
		toolSvgRoom( svg, (size_t)count );
		vsnprintf( svg->text + svg->length, (size_t)count + 1, format, arguments );
		svg->length += (size_t)count;
	}
	va_end( arguments );
}

void toolSvgEscape( toolSvg* svg, const char* text )
{
	for ( const char* c = text; *c != '\0'; ++c )
	{
		switch ( *c )
		{
		case '&':
			toolSvgPrint( svg, "&amp;" );
			break;
		case '<':
			toolSvgPrint( svg, "&lt;" );
			break;
		case '>':
			toolSvgPrint( svg, "&gt;" );
			break;
		case '"':
			toolSvgPrint( svg, "&quot;" );
			break;
		default:
			// Control characters are not allowed in XML at all.
			toolSvgPrint( svg, "%c", (unsigned char)*c < 0x20 ? ' ' : *c );
			break;
		}
	}
}

double toolSvgNumber( double x )
{
	return x >= -1e7 && x <= 1e7 ? x : 0.0;
}

int32_t toolSvgNewId( toolSvg* svg )
{
	return svg->ids++;
}

toolSvg* toolSvgBegin( double width, double height )
{
	toolSvg* svg = toolAlloc( 1, sizeof( toolSvg ) );
	toolSvgPrint( svg,
	    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
	    "font-family=\"system-ui, 'Segoe UI', Helvetica, Arial, sans-serif\">\n",
	    toolSvgNumber( width ), toolSvgNumber( height ), toolSvgNumber( width ), toolSvgNumber( height ) );
	return svg;
}

char* toolSvgEnd( toolSvg* svg )
{
	toolSvgPrint( svg, "</svg>\n" );
	char* text = svg->text;
	free( svg );
	return text;
}

void toolSvgText( toolSvg* svg, double x, double y, double size, toolAnchor anchor, const char* text )
{
	static const char* const s_anchors[] = { "start", "middle", "end" };
	toolSvgPrint( svg, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\" text-anchor=\"%s\" fill=\"" INK "\">",
	    toolSvgNumber( x ), toolSvgNumber( y ), toolSvgNumber( size ), s_anchors[anchor] );
	toolSvgEscape( svg, text );
	toolSvgPrint( svg, "</text>\n" );
}

/// An axis: what it shows, where in the picture, its ticks.
typedef struct toolAxis
{
	double low;
	double high;
	double from; // pixels of low and high
	double to;
	double tick;
	int decimals;
} toolAxis;

static double toolAxisPixel( const toolAxis* axis, double value )
{
	double share = ( value - axis->low ) / ( axis->high - axis->low );
	return toolSvgNumber( axis->from + share * ( axis->to - axis->from ) );
}

/// 1, 2 or 5 times a power of ten, so that about one tick comes every 60 pixels.
static void toolChooseTicks( toolAxis* axis )
{
	double count = fmax( 2.0, fabs( axis->to - axis->from ) / 60.0 );
	double raw = ( axis->high - axis->low ) / count;
	double power = pow( 10.0, floor( log10( raw ) ) );
	double share = raw / power;
	axis->tick = power * ( share < 1.5 ? 1.0 : ( share < 3.5 ? 2.0 : ( share < 7.5 ? 5.0 : 10.0 ) ) );
	double decimals = ceil( -log10( axis->tick ) - 1e-9 );
	axis->decimals = decimals > 0.0 ? (int)fmin( decimals, 6.0 ) : 0;
}

static void toolFitRange( const toolSeries* series, bool alongY, toolAxis* axis )
{
	const float* values = alongY ? series->y : series->x;
	for ( int32_t i = 0; i < series->count; ++i )
	{
		if ( soleIsFinite( values[i] ) )
		{
			axis->low = fmin( axis->low, (double)values[i] );
			axis->high = fmax( axis->high, (double)values[i] );
		}
	}
}

static toolAxis toolMakeAxis( const toolPlot* plot, bool alongY )
{
	toolAxis axis = { .low = (double)( alongY ? plot->yLow : plot->xLow ),
		.high = (double)( alongY ? plot->yHigh : plot->xHigh ) };
	toolBox box = plot->box;
	axis.from = alongY ? box.y + box.height - 44.0 : box.x + 58.0;
	axis.to = alongY ? box.y + 34.0 : box.x + box.width - 14.0;
	if ( !( axis.low < axis.high ) )
	{
		axis.low = (double)INFINITY;
		axis.high = -(double)INFINITY;
		for ( int32_t i = 0; i < plot->seriesCount; ++i )
		{
			toolFitRange( plot->series + i, alongY, &axis );
		}
		double margin = alongY ? 0.06 * ( axis.high - axis.low ) : 0.0;
		axis.low -= margin;
		axis.high += margin;
	}
	if ( !( axis.low < axis.high ) )
	{
		// One value only, or none.
		axis.low = isfinite( axis.low ) ? axis.low - 0.5 : 0.0;
		axis.high = axis.low + 1.0;
	}
	toolChooseTicks( &axis );
	return axis;
}

static void toolDrawLine( toolSvg* svg, double x0, double y0, double x1, double y1, double opacity )
{
	toolSvgPrint( svg,
	    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"" GRID "\" stroke-opacity=\"%.2f\"/>\n", x0, y0,
	    x1, y1, opacity );
}

static void toolDrawAxes( toolSvg* svg, const toolPlot* plot, const toolAxis* x, const toolAxis* y )
{
	char label[64];
	for ( double v = ceil( x->low / x->tick - 1e-6 ) * x->tick; v <= x->high + 1e-6 * x->tick; v += x->tick )
	{
		double at = toolAxisPixel( x, v );
		toolDrawLine( svg, at, y->from, at, y->to, 0.18 );
		snprintf( label, sizeof label, "%.*f", x->decimals, v + 0.0 );
		toolSvgText( svg, at, y->from + 16.0, 11.0, tool_anchorMiddle, label );
	}
	for ( double v = ceil( y->low / y->tick - 1e-6 ) * y->tick; v <= y->high + 1e-6 * y->tick; v += y->tick )
	{
		double at = toolAxisPixel( y, v );
		// The line of zero tells what is above the ground from what is in it.
		toolDrawLine( svg, x->from, at, x->to, at, fabs( v ) < 1e-6 * y->tick ? 0.75 : 0.18 );
		snprintf( label, sizeof label, "%.*f", y->decimals, fabs( v ) < 1e-6 * y->tick ? 0.0 : v );
		toolSvgText( svg, x->from - 7.0, at + 4.0, 11.0, tool_anchorEnd, label );
	}
	toolDrawLine( svg, x->from, y->from, x->to, y->from, 0.75 );
	toolDrawLine( svg, x->from, y->from, x->from, y->to, 0.75 );
	if ( plot->title != NULL )
	{
		toolSvgText( svg, x->from, plot->box.y + 20.0, 14.0, tool_anchorStart, plot->title );
	}
	if ( plot->xLabel != NULL )
	{
		toolSvgText( svg, 0.5 * ( x->from + x->to ), y->from + 34.0, 12.0, tool_anchorMiddle, plot->xLabel );
	}
	if ( plot->yLabel != NULL )
	{
		toolSvgPrint( svg, "<g transform=\"translate(%.1f %.1f) rotate(-90)\">\n", plot->box.x + 14.0,
		    0.5 * ( y->from + y->to ) );
		toolSvgText( svg, 0.0, 0.0, 12.0, tool_anchorMiddle, plot->yLabel );
		toolSvgPrint( svg, "</g>\n" );
	}
}

static const char* toolSeriesColor( const toolPlot* plot, int32_t index )
{
	// Told apart by those who see no red or green as well (after M. Okabe and K. Ito's advice: blue and orange first).
	static const char* const s_colors[] = { "#2f86d6", "#e07b1a", "#2aa17a", "#b565a7", "#c9a227", "#5a6b7b" };
	const char* color = plot->series[index].color;
	return color != NULL ? color : s_colors[(size_t)index % ( sizeof s_colors / sizeof s_colors[0] )];
}

static void toolDrawSeries( toolSvg* svg, const toolPlot* plot, int32_t index, const toolAxis* x, const toolAxis* y )
{
	const toolSeries* series = plot->series + index;
	toolSvgPrint( svg, "<path fill=\"none\" stroke-width=\"1.8\" stroke-linejoin=\"round\"%s stroke=\"",
	    series->dashed ? " stroke-dasharray=\"5 4\"" : "" );
	toolSvgEscape( svg, toolSeriesColor( plot, index ) );
	toolSvgPrint( svg, "\" d=\"" );
	bool drawing = false;
	for ( int32_t i = 0; i < series->count; ++i )
	{
		bool finite = soleIsFinite( series->x[i] ) && soleIsFinite( series->y[i] );
		if ( finite )
		{
			toolSvgPrint( svg, "%s%.1f %.1f", drawing ? "L" : "M", toolAxisPixel( x, (double)series->x[i] ),
			    toolAxisPixel( y, (double)series->y[i] ) );
		}
		drawing = finite;
	}
	toolSvgPrint( svg, "\"/>\n" );
}

static void toolDrawIntervals( toolSvg* svg, const toolPlot* plot, const toolAxis* x, const toolAxis* y )
{
	for ( int32_t i = 0; i < plot->intervalCount; ++i )
	{
		double start = fmax( toolAxisPixel( x, (double)plot->intervals[i].start ), x->from );
		double end = fmin( toolAxisPixel( x, (double)plot->intervals[i].end ), x->to );
		if ( end > start )
		{
			toolSvgPrint( svg,
			    "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"" INK "\" fill-opacity=\"0.14\"/>\n",
			    start, y->to, end - start, y->from - y->to );
		}
	}
}

/// From the right end to the left, on the title's line.
static void toolDrawLegend( toolSvg* svg, const toolPlot* plot, double right )
{
	double y = plot->box.y + 20.0;
	if ( plot->intervalName != NULL )
	{
		toolSvgText( svg, right, y, 12.0, tool_anchorEnd, plot->intervalName );
		right -= 7.0 * (double)strlen( plot->intervalName ) + 20.0;
		toolSvgPrint( svg,
		    "<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"11\" fill=\"" INK "\" fill-opacity=\"0.25\"/>\n", right,
		    y - 10.0 );
		right -= 16.0;
	}
	for ( int32_t i = plot->seriesCount - 1; i >= 0; --i )
	{
		if ( plot->series[i].name == NULL )
		{
			continue;
		}
		toolSvgText( svg, right, y, 12.0, tool_anchorEnd, plot->series[i].name );
		right -= 7.0 * (double)strlen( plot->series[i].name ) + 26.0;
		toolSvgPrint( svg, "<path fill=\"none\" stroke-width=\"2.4\"%s stroke=\"",
		    plot->series[i].dashed ? " stroke-dasharray=\"5 4\"" : "" );
		toolSvgEscape( svg, toolSeriesColor( plot, i ) );
		toolSvgPrint( svg, "\" d=\"M%.1f %.1fh20\"/>\n", right, y - 4.0 );
		right -= 16.0;
	}
}

void toolSvgPlot( toolSvg* svg, const toolPlot* plot )
{
	toolAxis x = toolMakeAxis( plot, false );
	toolAxis y = toolMakeAxis( plot, true );
	toolDrawIntervals( svg, plot, &x, &y );
	toolDrawAxes( svg, plot, &x, &y );
	int32_t id = toolSvgNewId( svg );
	toolSvgPrint( svg,
	    "<clipPath id=\"plot%d\"><rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/></clipPath>\n"
	    "<g clip-path=\"url(#plot%d)\">\n",
	    (int)id, x.from, y.to, x.to - x.from, y.from - y.to, (int)id );
	for ( int32_t i = 0; i < plot->seriesCount; ++i )
	{
		toolDrawSeries( svg, plot, i, &x, &y );
	}
	toolSvgPrint( svg, "</g>\n" );
	toolDrawLegend( svg, plot, x.to );
}
