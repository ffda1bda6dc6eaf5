// SPDX-License-Identifier: MIT
// Vectors and transforms in double precision, for measuring only. The same conventions as sole/math.h; set in double
// because second and third differences of float positions at 144 Hz are mostly rounding.
#ifndef SOLE_MEASURE_DOUBLE_H
#define SOLE_MEASURE_DOUBLE_H

#include "sole/math.h"

typedef struct soleVec3d
{
	double x, y, z;
} soleVec3d;

typedef struct soleQuatd
{
	double x, y, z, w;
} soleQuatd;

typedef struct soleTransformd
{
	soleVec3d translation;
	soleQuatd rotation;
	soleVec3d scale;
} soleTransformd;

static inline soleVec3d soleWiden( soleVec3 v )
{
	return ( soleVec3d ){ (double)v.x, (double)v.y, (double)v.z };
}

static inline soleVec3d soleAddD( soleVec3d a, soleVec3d b )
{
	return ( soleVec3d ){ a.x + b.x, a.y + b.y, a.z + b.z };
}

static inline soleVec3d soleSubD( soleVec3d a, soleVec3d b )
{
	return ( soleVec3d ){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static inline soleVec3d soleScaleD( double s, soleVec3d v )
{
	return ( soleVec3d ){ s * v.x, s * v.y, s * v.z };
}

static inline double soleDotD( soleVec3d a, soleVec3d b )
{
	return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline soleVec3d soleCrossD( soleVec3d a, soleVec3d b )
{
	return ( soleVec3d ){ a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

static inline double soleLengthD( soleVec3d v )
{
	return sqrt( soleDotD( v, v ) );
}

/// v without its part along the unit vector n.
static inline soleVec3d soleRejectD( soleVec3d v, soleVec3d n )
{
	return soleSubD( v, soleScaleD( soleDotD( v, n ), n ) );
}

/// The unit vector along v, or fallback where v has no length or is not finite.
static inline soleVec3d soleUnitD( soleVec3d v, soleVec3d fallback )
{
	double length = soleLengthD( v );
	return length > 1e-12 && length < 1e300 ? soleScaleD( 1.0 / length, v ) : fallback;
}

static inline bool soleVec3d_IsFinite( soleVec3d v )
{
	double sum = v.x + v.y + v.z;
	return sum - sum == 0.0;
}

/// Unit length: measuring must not see the rounding of a float quaternion as a change of bone length.
static inline soleQuatd soleWidenQuat( soleQuat q )
{
	soleQuatd d = { (double)q.x, (double)q.y, (double)q.z, (double)q.w };
	double length = sqrt( d.x * d.x + d.y * d.y + d.z * d.z + d.w * d.w );
	if ( length < 1e-6 )
	{
		return ( soleQuatd ){ 0.0, 0.0, 0.0, 1.0 };
	}
	// What is not finite stays so, to be found.
	double s = 1.0 / length;
	return ( soleQuatd ){ s * d.x, s * d.y, s * d.z, s * d.w };
}

static inline soleQuatd soleMulQuatD( soleQuatd a, soleQuatd b )
{
	return ( soleQuatd ){
		a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
		a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
		a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x,
		a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
	};
}

static inline soleVec3d soleRotateD( soleQuatd q, soleVec3d v )
{
	soleVec3d u = { q.x, q.y, q.z };
	soleVec3d t = soleScaleD( 2.0, soleCrossD( u, v ) );
	return soleAddD( soleAddD( v, soleScaleD( q.w, t ) ), soleCrossD( u, t ) );
}

static inline soleTransformd soleWidenTransform( soleTransform t )
{
	return ( soleTransformd ){ soleWiden( t.translation ), soleWidenQuat( t.rotation ), soleWiden( t.scale ) };
}

static inline soleVec3d soleTransformPointD( soleTransformd t, soleVec3d p )
{
	soleVec3d scaled = { t.scale.x * p.x, t.scale.y * p.y, t.scale.z * p.z };
	return soleAddD( soleRotateD( t.rotation, scaled ), t.translation );
}

static inline soleTransformd soleMulTransformD( soleTransformd a, soleTransformd b )
{
	return ( soleTransformd ){
		soleTransformPointD( a, b.translation ),
		soleMulQuatD( a.rotation, b.rotation ),
		{ a.scale.x * b.scale.x, a.scale.y * b.scale.y, a.scale.z * b.scale.z },
	};
}

/// Angle of the rotation between two local rotations, radians.
static inline double soleAngleBetween( soleQuat a, soleQuat b )
{
	soleQuatd p = soleWidenQuat( a );
	p = ( soleQuatd ){ -p.x, -p.y, -p.z, p.w };
	soleQuatd d = soleMulQuatD( p, soleWidenQuat( b ) );
	return 2.0 * atan2( sqrt( d.x * d.x + d.y * d.y + d.z * d.z ), fabs( d.w ) );
}

#endif
