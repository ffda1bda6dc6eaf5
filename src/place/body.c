// SPDX-License-Identifier: MIT
// Body: the ground that the body is over.
//
// The body is carried over the line through what its legs stand on: each leg that is down gives its foothold, each that
// is on its way to a known one both the old and the new, the weight going over from one to the other smoothly with
// time. The line is that of least squares, along the axis on which those places lie furthest apart, taken at the
// pelvis. On even slopes and stairs the footholds lie on one line, so the body climbs steadily, whatever the root does:
// a root that pops up a step, or lags, has no part in it.
// The same line through what the last frame knew tells what has changed unforeseen.
#include "place/place.h"

#define LEAST_SPREAD 0.03f // L: of what the body stands on, for it to have a slope

/// Height of the ground that the body is over: of the line through what its legs stand on, by least squares, at the
/// pelvis. The reference height where it stands on nothing.
static float soleFitBodyGround( const solePlaceWork* work, bool before, soleVec3* gradient )
{
	soleVec3 pelvis = work->slots[work->rig->pelvisSlot].translation;
	soleVec3 ahead = soleAnyOrthogonal( work->up );
	soleVec3 aside = soleCross( work->up, ahead );
	*gradient = soleVec( 0.0f, 0.0f, 0.0f );
	float least = LEAST_SPREAD * soleLongestLeg( work );
	float w = 0.0f, u = 0.0f, v = 0.0f, h = 0.0f;
	float uu = 0.0f, uv = 0.0f, vv = 0.0f, uh = 0.0f, vh = 0.0f;
	for ( int32_t i = 0; i < 2 * work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i / 2;
		const soleStand* stand = before ? &leg->standBefore : &leg->stand;
		bool counts = leg->usable && ( before ? leg->hadGround : leg->hasGround );
		float legWeight = before ? leg->weightBefore : leg->weight;
		float weight = counts ? legWeight * ( i % 2 == 0 ? 1.0f - stand->share : stand->share ) : 0.0f;
		soleVec3 from = soleSub( i % 2 == 0 ? stand->from : stand->to, pelvis );
		float du = soleDot( from, ahead ), dv = soleDot( from, aside ), dh = soleDot( from, work->up );
		w += weight;
		u += weight * du;
		v += weight * dv;
		h += weight * dh;
		uu += weight * du * du;
		uv += weight * du * dv;
		vv += weight * dv * dv;
		uh += weight * du * dh;
		vh += weight * dv * dh;
	}
	if ( !( w > 0.0f ) )
	{
		return work->reference;
	}
	float perWeight = 1.0f / w;
	u *= perWeight;
	v *= perWeight;
	h *= perWeight;
	uu = uu * perWeight - u * u;
	uv = uv * perWeight - u * v;
	vv = vv * perWeight - v * v;
	uh = uh * perWeight - u * h;
	vh = vh * perWeight - v * h;
	// Along the axis on which they lie furthest apart only: across it they say nothing.
	soleHalf axis = soleMakeHalf( uu - vv, 2.0f * uv );
	float spread = axis.c * axis.c * uu + 2.0f * axis.c * axis.s * uv + axis.s * axis.s * vv;
	float slope = ( axis.c * uh + axis.s * vh ) / ( spread + least * least );
	*gradient = soleScale( slope, soleMulAdd( soleScale( axis.c, ahead ), axis.s, aside ) );
	return soleDot( pelvis, work->up ) + h - slope * ( axis.c * u + axis.s * v );
}

void soleFindBodyGround( solePlaceWork* work )
{
	soleVec3 ignored;
	work->bodyBefore = soleFitBodyGround( work, true, &ignored );
	work->bodyGround = soleFitBodyGround( work, false, &work->bodyGradient );
}
