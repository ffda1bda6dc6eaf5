// SPDX-License-Identifier: MIT
// Ray against triangle without cracks, in the space of the query.
//
// The triangle is moved so that the ray starts at the origin, and sheared so that the ray runs along one axis. What is
// left is flat: three edge functions, each twice the area of the ray with one edge. Same signs: inside.
//   U = Cx By - Cy Bx,  V = Ax Cy - Ay Cx,  W = Bx Ay - By Ax
// Two triangles that share an edge compute the same products and get exactly opposite differences, hence no crack. A
// float difference of rounded products never has the wrong sign, at most it is zero: so floats may refuse, as block.c
// does, and what they let pass is decided here in double, where the products are exact. Needs contraction off. Where on
// the ray it is met says the triangle's plane, in double and not sheared: exact for needles too. Source of the idea:
// Woop, Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013.
#include "ground/ground_internal.h"

bool soleMakeGroundQuery(
    soleVec3 start, soleVec3 direction, float length, float radius, uint32_t mask, soleGroundQuery* query )
{
	*query = ( soleGroundQuery ){
		.start = { start.x, start.y, start.z },
		.direction = { direction.x, direction.y, direction.z },
		.length = length,
		.radius = radius > 0.0f ? radius : 0.0f,
		.mask = mask,
	};
	// A number that is not finite minus itself is no number, and stays so in a sum.
	float zero = ( ( start.x - start.x ) + ( start.y - start.y ) ) + ( ( start.z - start.z ) + ( length - length ) ) +
	    ( ( radius - radius ) + ( direction.x - direction.x ) ) +
	    ( ( direction.y - direction.y ) + ( direction.z - direction.z ) );
	float size[3] = { fabsf( direction.x ), fabsf( direction.y ), fabsf( direction.z ) };
	int z = size[0] > size[1] ? ( size[0] > size[2] ? 0 : 2 ) : ( size[1] > size[2] ? 1 : 2 );
	if ( !( zero == 0.0f ) || !( length > 0.0f ) || !( size[z] > 1e-18f ) )
	{
		return false;
	}
	int x = z == 2 ? 0 : z + 1;
	int y = x == 2 ? 0 : x + 1;
	bool backwards = query->direction[z] < 0.0f; // looking along a negative axis mirrors: swap to keep the winding
	query->axes[0] = backwards ? y : x;
	query->axes[1] = backwards ? x : y;
	query->axes[2] = z;
	query->aligned = query->direction[x] == 0.0f && query->direction[y] == 0.0f;
	if ( query->aligned == false )
	{
		query->shear[0] = query->direction[query->axes[0]] / query->direction[z];
		query->shear[1] = query->direction[query->axes[1]] / query->direction[z];
	}
	return true;
}

/// Where the ray goes through the plane of a triangle that it meets. @return false beyond the probe's ends.
static bool soleFillRayTouch(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, soleGroundTouch* touch )
{
	double d[3];
	double from[3];
	double u[3];
	double v[3];
	for ( int k = 0; k < 3; ++k )
	{
		d[k] = (double)query->direction[k];
		from[k] = (double)block->corners[0][k][lane] - (double)query->start[k];
		u[k] = (double)block->corners[1][k][lane] - (double)block->corners[0][k][lane];
		v[k] = (double)block->corners[2][k][lane] - (double)block->corners[0][k][lane];
	}
	double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
	double length = sqrt( ( n[0] * n[0] + n[1] * n[1] ) + n[2] * n[2] );
	double along = ( n[0] * d[0] + n[1] * d[1] ) + n[2] * d[2];
	double t = ( ( n[0] * from[0] + n[1] * from[1] ) + n[2] * from[2] ) / along;

	// Nearly edge on the plane says little; the travels to the corners say between what it must be.
	int z = query->axes[2];
	double ends[3] = { from[z], from[z] + u[z], from[z] + v[z] };
	double low = ends[0] < ends[1] ? ends[0] : ends[1];
	double high = ends[0] < ends[1] ? ends[1] : ends[0];
	low = ( low < ends[2] ? low : ends[2] ) / d[z];
	high = ( high > ends[2] ? high : ends[2] ) / d[z];
	if ( d[z] < 0.0 )
	{
		double swapped = low;
		low = high;
		high = swapped;
	}
	t = t > low ? ( t < high ? t : high ) : low; // a t that is no number compares false: low
	if ( !( t >= 0.0 ) || !( t <= (double)query->length ) )
	{
		return false;
	}

	// Only a face met from its back gets here with the normal along the ray: one that may be met from there.
	double scale = ( along > 0.0 ? -1.0 : 1.0 ) / ( length > 0.0 ? length : 1.0 );
	*touch = ( soleGroundTouch ){
		.hit = true,
		.t = t,
		.point = soleVec( (float)( (double)query->start[0] + t * d[0] ), (float)( (double)query->start[1] + t * d[1] ),
		    (float)( (double)query->start[2] + t * d[2] ) ),
		.normal = soleVec( (float)( scale * n[0] ), (float)( scale * n[1] ), (float)( scale * n[2] ) ),
	};
	return true;
}

bool soleRayMeetsTriangle(
    const soleGroundQuery* query, const soleGroundBlock* block, uint32_t lane, bool twoSided, soleGroundTouch* touch )
{
	int kx = query->axes[0];
	int ky = query->axes[1];
	int kz = query->axes[2];
	double x[3];
	double y[3];
	for ( int i = 0; i < 3; ++i )
	{
		float z = block->corners[i][kz][lane] - query->start[kz];
		x[i] = (double)( ( block->corners[i][kx][lane] - query->start[kx] ) - query->shear[0] * z );
		y[i] = (double)( ( block->corners[i][ky][lane] - query->start[ky] ) - query->shear[1] * z );
	}
	double u = x[2] * y[1] - y[2] * x[1];
	double v = x[0] * y[2] - y[0] * x[2];
	double w = x[1] * y[0] - y[1] * x[0];
	bool anyBehind = u < 0.0 || v < 0.0 || w < 0.0;
	bool anyFront = u > 0.0 || v > 0.0 || w > 0.0;
	if ( ( anyBehind && ( anyFront || twoSided == false ) ) || anyBehind == anyFront )
	{
		return false; // outside, from the back, or seen edge on: then all three are zero
	}
	return soleFillRayTouch( query, block, lane, touch );
}
