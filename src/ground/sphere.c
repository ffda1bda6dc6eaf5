// SPDX-License-Identifier: MIT
// Moving sphere against triangle, in the space of the query, in double: the quadratics cancel too much in float.
//
// All is relative to the sphere's start. Unit normal N towards the start's side, height h of the start over the plane,
// travel t along the direction D, radius r.
//   0. A one-sided face counts only for a sphere that starts on its front and does not move away from it.
//   1. Nearest point of the triangle within r: touches at once, t = 0.
//   2. Face: t = ( h - r ) / -( N . D ), met where the foot of the perpendicular is inside the three edges. Nothing of
//      the triangle can be met before, as all of it is in the plane.
//   3. Edges, from p along e: the sphere's centre meets a cylinder. With m = -p
//        A = |e|^2 |D|^2 - ( e . D )^2,  B = |e|^2 ( m . D ) - ( e . D )( m . e ),  C = |e|^2 ( |m|^2 - r^2 ) - ( m . e
//        )^2 t = -( B + sqrt( B^2 - A C ) ) / A,  with 0 <= m . e + t e . D <= |e|^2
//   4. Corners: the centre meets a sphere, A = |D|^2, B = m . D, C = |m|^2 - r^2.
// Edges run from their lower to their higher end (compared coordinate by coordinate), so that two triangles that share
// one find the same t to the last bit, and which face is reported is decided by how squarely the way meets it, not by
// rounding: of a stair's nosing a falling sphere gets the tread, not the riser.
// As the answer carries the face's normal, never the one from the edge to the centre, inner edges need no marks.
#include "ground/ground_internal.h"

typedef struct solePoint
{
	double x, y, z;
} solePoint;

/// The edge that follows a corner, from its lower end.
typedef struct soleEdge
{
	solePoint from;
	solePoint along;
	bool forwards; // as the triangle winds
} soleEdge;

/// The triangle and the sphere's way, relative to the start.
typedef struct soleSweep
{
	solePoint corners[3];
	soleEdge edges[3]; // found once it is clear that they are needed
	solePoint way;     // direction
	solePoint normal;
	double length;
	double radius;
	double height; // of the start over the plane, >= 0
} soleSweep;

static solePoint soleSubPoint( solePoint a, solePoint b )
{
	return ( solePoint ){ a.x - b.x, a.y - b.y, a.z - b.z };
}

/// a + s b
static solePoint soleMulAddPoint( solePoint a, double s, solePoint b )
{
	return ( solePoint ){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}

static double soleDotPoint( solePoint a, solePoint b )
{
	return ( a.x * b.x + a.y * b.y ) + a.z * b.z;
}

static solePoint soleCrossPoint( solePoint a, solePoint b )
{
	return ( solePoint ){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

static bool solePoint_IsBefore( solePoint a, solePoint b )
{
	return a.x != b.x ? a.x < b.x : ( a.y != b.y ? a.y < b.y : a.z < b.z );
}

static void soleFindEdges( soleSweep* sweep )
{
	for ( int i = 0; i < 3; ++i )
	{
		solePoint a = sweep->corners[i];
		solePoint b = sweep->corners[i == 2 ? 0 : i + 1];
		bool forwards = solePoint_IsBefore( a, b );
		sweep->edges[i] = ( soleEdge ){
			.from = forwards ? a : b,
			.along = forwards ? soleSubPoint( b, a ) : soleSubPoint( a, b ),
			.forwards = forwards,
		};
	}
}

/// Whether a point of the plane is inside the three edges, borders included. The normal may have been turned round:
/// then all signs are.
static bool soleIsOverFace( const soleSweep* sweep, solePoint p )
{
	bool anyFront = false;
	bool anyBehind = false;
	for ( int i = 0; i < 3; ++i )
	{
		const soleEdge* edge = sweep->edges + i;
		double side = soleDotPoint( soleCrossPoint( sweep->normal, edge->along ), soleSubPoint( p, edge->from ) );
		side = edge->forwards ? side : -side;
		anyFront = anyFront || side > 0.0;
		anyBehind = anyBehind || side < 0.0;
	}
	return ( anyFront && anyBehind ) == false;
}

/// The point of the triangle that is nearest to the start.
static solePoint soleGetNearestPoint( const soleSweep* sweep )
{
	solePoint zero = { 0.0, 0.0, 0.0 };
	solePoint foot = soleMulAddPoint( zero, -sweep->height, sweep->normal );
	if ( soleIsOverFace( sweep, foot ) )
	{
		return foot;
	}
	solePoint nearest = sweep->corners[0];
	double least = soleDotPoint( nearest, nearest );
	for ( int i = 0; i < 3; ++i )
	{
		solePoint from = sweep->edges[i].from;
		solePoint edge = sweep->edges[i].along;
		double square = soleDotPoint( edge, edge );
		double along = -soleDotPoint( from, edge );
		double share = along <= 0.0 || !( square > 0.0 ) ? 0.0 : ( along >= square ? 1.0 : along / square );
		solePoint p = soleMulAddPoint( from, share, edge );
		double distance = soleDotPoint( p, p );
		if ( distance < least )
		{
			least = distance;
			nearest = p;
		}
	}
	return nearest;
}

/// First root of A t^2 + 2 B t + C = 0 that is reached from outside (C > 0, B < 0), else false.
static bool soleGetEntry( double a, double b, double c, double* t )
{
	double discriminant = b * b - a * c;
	if ( !( a > 0.0 ) || !( b < 0.0 ) || !( discriminant >= 0.0 ) )
	{
		return false;
	}
	double root = sqrt( discriminant );
	// c / ( root - b ) is -( b + root ) / a without the cancellation; root - b > 0 as b < 0.
	double entry = c / ( root - b );
	*t = entry > 0.0 ? entry : 0.0;
	return true;
}

/// First touch of the three edges. Lowers t and sets the point where an edge is met before t.
static bool soleMeetEdges( const soleSweep* sweep, double* t, solePoint* point )
{
	bool any = false;
	double wayWay = soleDotPoint( sweep->way, sweep->way );
	for ( int i = 0; i < 3; ++i )
	{
		solePoint p = sweep->edges[i].from;
		solePoint e = sweep->edges[i].along;
		double ee = soleDotPoint( e, e );
		double ed = soleDotPoint( e, sweep->way );
		double me = -soleDotPoint( p, e );
		double md = -soleDotPoint( p, sweep->way );
		double mm = soleDotPoint( p, p );
		double a = ee * wayWay - ed * ed;
		double entry;
		if ( a < 1e-12 * ee * wayWay || // along the edge: its corners are met first
		    !soleGetEntry( a, ee * md - ed * me, ee * ( mm - sweep->radius * sweep->radius ) - me * me, &entry ) )
		{
			continue;
		}
		double along = me + entry * ed;
		if ( entry <= *t && along >= 0.0 && along <= ee )
		{
			*t = entry;
			*point = soleMulAddPoint( p, along / ee, e );
			any = true;
		}
	}
	return any;
}

/// First touch of the three corners, as soleMeetEdges.
static bool soleMeetCorners( const soleSweep* sweep, double* t, solePoint* point )
{
	bool any = false;
	double wayWay = soleDotPoint( sweep->way, sweep->way );
	for ( int i = 0; i < 3; ++i )
	{
		solePoint p = sweep->corners[i];
		double entry;
		double c = soleDotPoint( p, p ) - sweep->radius * sweep->radius;
		if ( soleGetEntry( wayWay, -soleDotPoint( p, sweep->way ), c, &entry ) && entry <= *t )
		{
			*t = entry;
			*point = p;
			any = true;
		}
	}
	return any;
}

static void soleFillSphereTouch( const soleGroundQuery* query, const soleSweep* sweep, double t, solePoint point,
    bool inside, bool twoSided, soleGroundTouch* touch )
{
	double along = soleDotPoint( sweep->normal, sweep->way );
	// At the start the side of the start is the side to be pushed to, wherever the sphere wanted to go.
	double sign = inside == false && twoSided && along > 0.0 ? -1.0 : 1.0;
	*touch = ( soleGroundTouch ){
		.hit = true,
		.inside = inside,
		.t = t,
		.gap = inside ? sqrt( soleDotPoint( point, point ) ) : 0.0,
		.facing = inside ? sweep->height : -along,
		.point = soleVec( (float)( (double)query->start[0] + point.x ), (float)( (double)query->start[1] + point.y ),
		    (float)( (double)query->start[2] + point.z ) ),
		.normal = soleVec(
		    (float)( sign * sweep->normal.x ), (float)( sign * sweep->normal.y ), (float)( sign * sweep->normal.z ) ),
	};
}

/// @return false for a triangle that cannot be met: without area, or one-sided and seen from behind.
static bool soleMakeSweep(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleSweep* sweep )
{
	for ( int i = 0; i < 3; ++i )
	{
		sweep->corners[i] = ( solePoint ){
			(double)block->corners[i][0][lane] - (double)query->start[0],
			(double)block->corners[i][1][lane] - (double)query->start[1],
			(double)block->corners[i][2][lane] - (double)query->start[2],
		};
	}
	sweep->way = ( solePoint ){
		(double)query->direction[0],
		(double)query->direction[1],
		(double)query->direction[2],
	};
	sweep->length = (double)query->length;
	sweep->radius = (double)query->radius;
	solePoint n = soleCrossPoint(
	    soleSubPoint( sweep->corners[1], sweep->corners[0] ), soleSubPoint( sweep->corners[2], sweep->corners[0] ) );
	double size = sqrt( soleDotPoint( n, n ) );
	if ( !( size > 0.0 ) )
	{
		return false;
	}
	double height = -soleDotPoint( sweep->corners[0], n ) / size;
	if ( height < 0.0 && twoSided == false )
	{
		return false;
	}
	double scale = ( height < 0.0 ? -1.0 : 1.0 ) / size;
	sweep->normal = ( solePoint ){ scale * n.x, scale * n.y, scale * n.z };
	sweep->height = fabs( height );
	return true;
}

bool soleSphereMeetsTriangle(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleGroundTouch* touch )
{
	soleSweep sweep;
	if ( !soleMakeSweep( query, block, lane, twoSided, &sweep ) )
	{
		return false;
	}
	double r = sweep.radius;
	double along = soleDotPoint( sweep.normal, sweep.way );
	bool away = sweep.height > r;
	// All of the triangle lies further than the plane is away.
	if ( away && ( !( along < 0.0 ) || ( sweep.height - r ) > -along * sweep.length ) )
	{
		return false;
	}
	soleFindEdges( &sweep );
	if ( away )
	{
		double t = ( sweep.height - r ) / -along;
		solePoint centre = soleMulAddPoint( ( solePoint ){ 0.0, 0.0, 0.0 }, t, sweep.way );
		solePoint foot = soleMulAddPoint( centre, -r, sweep.normal );
		if ( soleIsOverFace( &sweep, foot ) )
		{
			soleFillSphereTouch( query, &sweep, t, foot, false, twoSided, touch );
			return true;
		}
	}
	else
	{
		solePoint nearest = soleGetNearestPoint( &sweep );
		if ( soleDotPoint( nearest, nearest ) <= r * r )
		{
			soleFillSphereTouch( query, &sweep, 0.0, nearest, true, twoSided, touch );
			return true;
		}
		// Sliding past a face that stands along the way is no moving away, whatever rounding says.
		if ( twoSided == false && along > 1e-6 )
		{
			return false;
		}
	}

	double t = sweep.length;
	solePoint point = { 0.0, 0.0, 0.0 };
	bool edge = soleMeetEdges( &sweep, &t, &point );
	bool corner = soleMeetCorners( &sweep, &t, &point );
	if ( edge == false && corner == false )
	{
		return false;
	}
	// The sphere may have come round to the back by then.
	if ( twoSided == false && sweep.height + t * along < -1e-6 * r )
	{
		return false;
	}
	soleFillSphereTouch( query, &sweep, t, point, false, twoSided, touch );
	return true;
}
