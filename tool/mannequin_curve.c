// SPDX-License-Identifier: MIT
// Smooth curves through knots, of one number over time.
//
// The slopes at the knots are those of the cubic spline with the given end slopes (its continuity equations are a
// tridiagonal system: C. de Boor, "A Practical Guide to Splines", 1978, chapter IV). The pieces are quintic, so that
// the accelerations of the ends can be given as well and nothing jumps where a foot leaves the floor or meets it.
#include "mannequin_parts.h"

double toolEase( double t )
{
	double s = t < 0.0 ? 0.0 : ( t > 1.0 ? 1.0 : t );
	return s * s * s * ( s * ( 6.0 * s - 15.0 ) + 10.0 );
}

static void toolSolveSlopes( toolCurve* curve )
{
	double upper[TOOL_CURVE_KNOTS] = { 0 };
	int32_t n = curve->count;
	toolCurvePoint* k = curve->knots;
	for ( int32_t i = 1; i + 1 < n; ++i )
	{
		double before = 1.0 / ( curve->t[i] - curve->t[i - 1] );
		double after = 1.0 / ( curve->t[i + 1] - curve->t[i] );
		double right = 3.0 * ( ( k[i].x - k[i - 1].x ) * before * before + ( k[i + 1].x - k[i].x ) * after * after );
		double pivot = 2.0 * ( before + after ) - before * upper[i - 1];
		upper[i] = after / pivot;
		k[i].v = ( right - before * k[i - 1].v ) / pivot;
	}
	for ( int32_t i = n - 2; i > 0; --i )
	{
		k[i].v -= upper[i] * k[i + 1].v;
	}
}

toolCurve toolFitCurve( const double* points, int32_t count, toolCurvePoint first, toolCurvePoint last )
{
	toolCurve curve = { .count = count };
	for ( int32_t i = 0; i < count; ++i )
	{
		curve.t[i] = points[2 * i];
		curve.knots[i].x = points[2 * i + 1];
	}
	curve.knots[0].v = first.v;
	curve.knots[count - 1].v = last.v;
	toolSolveSlopes( &curve );
	for ( int32_t i = 1; i + 1 < count; ++i )
	{
		double step = curve.t[i + 1] - curve.t[i];
		const toolCurvePoint* p = curve.knots + i;
		curve.knots[i].a = ( 6.0 * ( p[1].x - p[0].x ) / step - 4.0 * p[0].v - 2.0 * p[1].v ) / step;
	}
	curve.knots[0].a = first.a;
	curve.knots[count - 1].a = last.a;
	return curve;
}

toolCurvePoint toolEvalCurve( const toolCurve* curve, double t )
{
	int32_t i = 0;
	while ( i + 2 < curve->count && t >= curve->t[i + 1] )
	{
		++i;
	}
	double h = curve->t[i + 1] - curve->t[i];
	double s = ( t - curve->t[i] ) / h;
	toolCurvePoint p = curve->knots[i];
	toolCurvePoint q = curve->knots[i + 1];
	// Taylor at the left knot, then the three coefficients that meet the right one.
	double c1 = p.v * h;
	double c2 = 0.5 * p.a * h * h;
	double dx = q.x - p.x - c1 - c2;
	double dv = q.v * h - c1 - 2.0 * c2;
	double da = q.a * h * h - 2.0 * c2;
	double c3 = 10.0 * dx - 4.0 * dv + 0.5 * da;
	double c4 = -15.0 * dx + 7.0 * dv - da;
	double c5 = 6.0 * dx - 3.0 * dv + 0.5 * da;
	return ( toolCurvePoint ){
		.x = p.x + s * ( c1 + s * ( c2 + s * ( c3 + s * ( c4 + s * c5 ) ) ) ),
		.v = ( c1 + s * ( 2.0 * c2 + s * ( 3.0 * c3 + s * ( 4.0 * c4 + s * 5.0 * c5 ) ) ) ) / h,
		.a = ( 2.0 * c2 + s * ( 6.0 * c3 + s * ( 12.0 * c4 + s * 20.0 * c5 ) ) ) / ( h * h ),
	};
}
