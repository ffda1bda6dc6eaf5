// SPDX-License-Identifier: MIT
// Body: the ground that the body is over.
//
// The body is carried over the line through what its legs stand on: each leg that is down gives its foothold, each that
// is on its way to a known one both the old and the new, the weight going over from one to the other smoothly with
// time. The line is that of least squares, along the axis on which those places lie furthest apart, taken at the
// pelvis. On even slopes and stairs the footholds lie on one line, so the body climbs steadily, whatever the root does:
// a root that pops up a step, or lags, has no part in it.
// The same line through what the last frame knew tells what has changed unforeseen.
//
// Settings may have the pelvis go with planted feet alone, each in full once it has its full say, or with the lowest
// foot as others do: then it is the springs of the pelvis that keep it from jumping.
//
// The slope of that line is not the ground's: two feet stand askew. What a host is told (bodyGradient) is the gradient
// g of the plane through the same places that differs least from the last frame's, g0: with their covariances S and b,
//   g = g0 + ( S + r I )^-1 ( b - S g0 )
// so a direction in which they say nothing now keeps what was known. r grows with the frame rate, so that what is
// known little is learnt as fast at every rate.
#include "place/place.h"

#include <float.h>

#define LEARN_TIME 0.0167f // s
#define BEYOND 0.3f        // L: the body is over no ground that is so much higher or lower than what it stands on
#define LEAST_SPREAD 0.03f // L: of what the body stands on, for it to have a slope

/// Means and covariances of the places that the body stands on, seen from the pelvis.
typedef struct soleBodyFit
{
	soleVec3 pelvis;
	soleVec3 ahead, aside; // the axes of u and v
	float weight;
	float u, v, h;
	float uu, uv, vv, uh, vh;
	float low, high; // of the places, over the pelvis
} soleBodyFit;

static soleBodyFit soleBeginFit( const solePlaceWork* work, soleVec3 pelvis )
{
	soleVec3 aside = soleCross( work->up, work->level );
	return ( soleBodyFit ){ .pelvis = pelvis, .ahead = work->level, .aside = aside, .low = FLT_MAX, .high = -FLT_MAX };
}

static void soleAddPlace( const solePlaceWork* work, soleVec3 place, float weight, soleBodyFit* f )
{
	soleVec3 from = soleSub( place, f->pelvis );
	float du = soleDot( from, f->ahead ), dv = soleDot( from, f->aside ), dh = soleDot( from, work->up );
	f->weight += weight;
	f->u += weight * du;
	f->v += weight * dv;
	f->h += weight * dh;
	f->uu += weight * du * du;
	f->uv += weight * du * dv;
	f->vv += weight * dv * dv;
	f->uh += weight * du * dh;
	f->vh += weight * dv * dh;
	f->low = weight > 0.0f ? soleMinF( f->low, dh ) : f->low;
	f->high = weight > 0.0f ? soleMaxF( f->high, dh ) : f->high;
}

/// The place that a leg came from and the one that it goes to, by how far it is on its way.
static void soleAddStand( const solePlaceWork* work, const soleStand* stand, float share, float weight, soleBodyFit* f )
{
	soleAddPlace( work, stand->from, weight * ( 1.0f - share ), f );
	soleAddPlace( work, stand->to, weight * share, f );
}

static void soleEndFit( soleBodyFit* f )
{
	float perWeight = f->weight > 0.0f ? 1.0f / f->weight : 0.0f;
	f->u *= perWeight;
	f->v *= perWeight;
	f->h *= perWeight;
	f->uu = f->uu * perWeight - f->u * f->u;
	f->uv = f->uv * perWeight - f->u * f->v;
	f->vv = f->vv * perWeight - f->v * f->v;
	f->uh = f->uh * perWeight - f->u * f->h;
	f->vh = f->vh * perWeight - f->v * f->h;
}

static float soleGetSay( const solePlaceWork* work, const soleLegWork* leg, bool counts, float weight )
{
	float planted = work->settings->pelvis.follow == sole_followPlanted ? leg->state->plantWeight : 1.0f;
	return leg->usable && counts ? weight * planted : 0.0f;
}

static soleVec3 soleGetPelvis( const solePlaceWork* work )
{
	return work->slots[work->rig->pelvisSlot].translation;
}

/// By what the last frame knew.
static soleBodyFit soleFitBefore( const solePlaceWork* work )
{
	soleBodyFit f = soleBeginFit( work, soleGetPelvis( work ) );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		float say = soleGetSay( work, leg, leg->hadGround, leg->weightBefore );
		soleAddStand( work, &leg->standBefore, leg->standBefore.share, say, &f );
	}
	soleEndFit( &f );
	return f;
}

/// How much of its next foothold a leg will stand on some time later.
static float soleFindShare( const soleLegWork* leg, float time )
{
	float whole = leg->stepInput.since + leg->stepInput.until;
	bool flies = leg->planned && whole > 0.0f;
	return flies ? soleGently( soleSaturate( ( leg->stepInput.since + time ) / whole ) ) : leg->stand.share;
}

/// By what is known now of a later time: the pelvis has gone on, and feet on their way.
static soleBodyFit soleFitAfter( const solePlaceWork* work, soleVec3 travel, float time )
{
	soleBodyFit f = soleBeginFit( work, soleAdd( soleGetPelvis( work ), travel ) );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		float say = soleGetSay( work, leg, leg->hasGround, leg->weight );
		soleAddStand( work, &leg->stand, soleFindShare( leg, time ), say, &f );
	}
	soleEndFit( &f );
	return f;
}

/// Height of the ground that the body is over: of the line through what its legs stand on, by least squares, at the
/// pelvis. The reference height where it stands on nothing.
static float soleFindLineHeight( const solePlaceWork* work, const soleBodyFit* f )
{
	if ( !( f->weight > 0.0f ) )
	{
		return work->reference;
	}
	// Along the axis on which they lie furthest apart only: across it they say nothing.
	float least = LEAST_SPREAD * soleLongestLeg( work );
	soleHalf axis = soleMakeHalf( f->uu - f->vv, 2.0f * f->uv );
	float spread = axis.c * axis.c * f->uu + 2.0f * axis.c * axis.s * f->uv + axis.s * axis.s * f->vv;
	float slope = ( axis.c * f->uh + axis.s * f->vh ) / ( spread + least * least );
	// Two that are above each other say nothing of the slope, whatever their line does.
	float beyond = BEYOND * soleLongestLeg( work );
	float height = f->h - slope * ( axis.c * f->u + axis.s * f->v );
	return soleDot( f->pelvis, work->up ) + soleClampF( height, f->low - beyond, f->high + beyond );
}

/// The lowest ground under a foot; the reference height where there is none. What it does is not foreseen: the pelvis
/// goes after it.
static void soleFollowLowest( solePlaceWork* work )
{
	const soleState* state = work->state;
	bool any = false;
	float lowest = work->reference;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable && leg->hasGround && leg->weight > 0.0f )
		{
			float height = solePlaneHeight( work, leg->raw, leg->ankle );
			lowest = any ? soleMinF( lowest, height ) : height;
			any = true;
		}
	}
	float moved = soleDot( soleSub( work->root_w, state->root_w ), work->up );
	work->bodyGround = lowest;
	work->bodyBefore = work->first ? lowest : state->bodyGround - moved + work->carriedUp;
}

/// The gradient of the planes that the legs stand on.
static soleVec3 soleMeanGradient( const solePlaceWork* work )
{
	soleVec3 sum = soleVec( 0.0f, 0.0f, 0.0f );
	float weights = 0.0f;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		float weight = leg->usable && leg->hasGround ? leg->weight : 0.0f;
		sum = soleMulAdd( sum, weight, leg->raw.gradient );
		weights += weight;
	}
	return soleScale( weights > 0.0f ? 1.0f / weights : 0.0f, sum );
}

/// Learns what the places say about the slope of the ground.
static void soleLearnGradient( solePlaceWork* work, const soleBodyFit* f )
{
	soleState* state = work->state;
	soleVec3 known = work->first ? soleMeanGradient( work ) : soleHorizontal( work, state->bodyGradient );
	state->bodyGradient = known;
	if ( !( f->weight > 0.0f ) || !( work->timeStep > 0.0f ) )
	{
		return;
	}
	float least = LEAST_SPREAD * soleLongestLeg( work );
	float r = least * least * soleMaxF( LEARN_TIME / work->timeStep, 1.0f );
	float gu = soleDot( known, f->ahead ), gv = soleDot( known, f->aside );
	float bu = f->uh - f->uu * gu - f->uv * gv;
	float bv = f->vh - f->uv * gu - f->vv * gv;
	float a = soleMaxF( f->uu, 0.0f ) + r, c = soleMaxF( f->vv, 0.0f ) + r;
	float perArea = 1.0f / soleMaxF( a * c - f->uv * f->uv, r * r );
	known = soleMulAdd( known, perArea * ( c * bu - f->uv * bv ), f->ahead );
	state->bodyGradient = soleMulAdd( known, perArea * ( a * bv - f->uv * bu ), f->aside );
}

void soleFindBodyGround( solePlaceWork* work )
{
	soleBodyFit before = soleFitBefore( work );
	soleBodyFit now = soleFitAfter( work, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	work->bodyBefore = soleFindLineHeight( work, &before );
	work->bodyGround = soleFindLineHeight( work, &now );
	soleLearnGradient( work, &now );
	if ( work->settings->pelvis.follow == sole_followLowest )
	{
		soleFollowLowest( work );
	}
}

float soleForeseeBodyGround( const solePlaceWork* work, soleVec3 travel, float time )
{
	soleBodyFit then = soleFitAfter( work, travel, time );
	return soleFindLineHeight( work, &then );
}
