// SPDX-License-Identifier: MIT
// Way: from the plane on which the foot stood to the one on which it will, the height of the ground under it goes
// along the chord between both places, by the share s of the way that it has come (by the share of the time where both
// are close together), lifted over what lies between by a smoothed upper hull; the slope goes over smoothly with time.
// On an even slope that is the slope itself. A foot whose heel strikes goes on a little with its ball: its way is over
// when it strikes, or the heel would still be high over a step down.
//
// Where a foot comes down right behind an edge, as on the way down stairs, no lift would spare its heel that: it would
// have to drop from there. So it goes ahead of the animation in the second half of its flight, by a share of what is
// left of its way, and comes down more steeply; the animation catches up by the end. A foot that leaves right before a
// riser waits in the same way while it sets out, until it is lifted over that: with c what the animation has come and
// m = WAIT_MOST it waits by  m c / ( c + m / WAIT ),  a share of the first steps and no more than m.
#include "place/way.h"

#include <float.h>

#define BY_TIME 0.25f     // L: a step shorter than this goes by time
#define LATE 0.85f        // share of the time from which on the way comes to its end
#define NEAR_END 0.06f    // share of the way near its ends in which nothing can be cleared any more
#define STANDS_OUT 0.033f // L over both ends: a narrow thing, no stair
#define MOST_MORE 1.6f    // by this much the smoothed hull may be raised
#define BESIDE 0.06f      // L: what is further beside the way is not in it
#define LEAD 0.6f         // share of what is left of its way that a foot is ahead by
#define LEAD_LOW 0.03f    // L: an edge so much over the landing asks for none of it
#define LEAD_HIGH 0.12f   // L: for all of it
#define LEAD_TIME 0.33f   // share of the time in which it comes
#define LEAD_END 0.88f    // from which on it goes
#define WAIT 0.8f         // share of what it has come that a foot waits by at first
#define WAIT_MOST 0.08f   // L: and at last
#define WAIT_TIME 0.35f   // in which it catches up
#define WAIT_NEAR 0.15f   // share of the way in which it meets a riser
#define STEEP 0.7f        // rise per length: slopes are no risers

soleVec3 soleGradientOf( const solePlaceWork* work, soleVec3 normal )
{
	float up = soleMaxF( soleDot( normal, work->up ), 0.05f );
	return soleScale( -1.0f / up, soleHorizontal( work, normal ) );
}

soleWay soleRememberWay( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	return ( soleWay ){
		soleSub( state->planePoint_w, work->root_w ),
		soleSub( state->stepPlace_w, work->root_w ),
		soleGradientOf( work, state->planeNormal_w ),
		soleGradientOf( work, state->stepNormal_w ),
		state->stepLift,
	};
}

float soleShareOfTime( const soleLegWork* leg )
{
	float whole = leg->stepInput.since + leg->stepInput.until;
	if ( leg->foreseen )
	{
		return whole > 0.0f ? leg->stepInput.since / whole : 1.0f;
	}
	// A foot that has come down has gone the whole way; one that has lost it is where it was.
	return leg->touches ? 1.0f : leg->state->stepTime;
}

static float soleShareOfWay( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, soleVec3 place )
{
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length2 = soleDot( d, d );
	float least = BY_TIME * leg->length;
	float byTime = soleShareOfTime( leg );
	float byWay =
	    soleSaturate( soleDot( soleSub( place, way->from ), d ) / soleMaxF( length2, 1e-4f * least * least ) );
	byWay += ( 1.0f - byWay ) * soleSmoothly( soleSaturate( ( byTime - LATE ) / ( 1.0f - LATE ) ) );
	return byTime + soleSaturate( soleSqrtF( length2 ) / least ) * ( byWay - byTime );
}

/// A quadratic B-spline over the share of the way, 0 at both ends, its control points at 0, 1/4, 1/2, 3/4 and 1.
static float soleLiftAt( const float lift[3], float s )
{
	const float controls[7] = { -lift[0], 0.0f, lift[0], lift[1], lift[2], 0.0f, -lift[2] };
	float x = soleClampF( 4.0f * s + 0.5f, 0.0f, 4.999f );
	int32_t i = x > 0.0f ? (int32_t)x : 0; // what is no number has no whole part
	float t = x - (float)i;
	float a = 0.5f * ( 1.0f - t ) * ( 1.0f - t );
	float c = 0.5f * t * t;
	return a * controls[i] + ( 1.0f - a - c ) * controls[i + 1] + c * controls[i + 2];
}

/// The plane at a place on the way.
solePlane soleFollowWay( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, soleVec3 place )
{
	float s = soleShareOfWay( work, leg, way, place );
	float t = soleShareOfTime( leg );
	float smooth = soleGently( t );
	soleVec3 gradient = soleLerp( way->fromGradient, way->toGradient, smooth );
	soleVec3 chord = soleLerp( way->from, way->to, s );
	float height = soleDot( chord, work->up ) + soleLiftAt( way->lift, s );
	height += soleDot( gradient, soleSub( place, chord ) );
	return soleMakePlane( work, soleAtHeight( work, place, height ), gradient );
}

/// What a foot on its way must not be lower than: a lift over the chord at a share of the way.
typedef struct soleClearance
{
	float share;
	float lift;
} soleClearance;

#define MAX_CLEARANCES ( 3 * SOLE_MAX_PROBES_PER_LEG + 2 )

/// Where the ball is, seen from where the way begins, while a part of the foot passes over a place.
/// @param ahead how far that part is ahead of the ball
static soleVec3 soleFindBall( const soleLegWork* leg, const soleWay* way, soleVec3 place, float ahead )
{
	return soleMulAdd( soleSub( place, way->from ), -ahead, leg->landingForward );
}

/// Is it on the way, from one end of which to the other is d, when it has come a share s of that?
static bool soleIsOnWay( const solePlaceWork* work, const soleLegWork* leg, soleVec3 ball, soleVec3 d, float s )
{
	return soleLength( soleHorizontal( work, soleMulAdd( ball, -s, d ) ) ) < BESIDE * leg->length;
}

/// How far the way has to be lifted so that neither heel, ball nor toes meet what lies between its ends.
/// @param least height from which on what lies there counts
static int32_t soleFindClearances(
    const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float least, soleClearance* list )
{
	int32_t count = 0;
	list[count++] = ( soleClearance ){ 0.0f, 0.0f };
	list[count++] = ( soleClearance ){ 1.0f, 0.0f };
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length = soleLength( d );
	if ( length < BY_TIME * leg->length )
	{
		return count;
	}
	const float parts[3] = { -leg->rig->heelBehind * work->rootScale, 0.0f, leg->rig->toeAhead * work->rootScale };
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		for ( int32_t k = 0; k < 3 && sample->found && sample->height > least; ++k )
		{
			soleVec3 ball = soleFindBall( leg, way, sample->place, parts[k] );
			float s = soleDot( ball, d ) / ( length * length );
			if ( !( s > NEAR_END && s < 1.0f - NEAR_END ) )
			{
				continue;
			}
			soleVec3 gradient = soleLerp( way->fromGradient, way->toGradient, s );
			// A foot that flies in parallel to the slope under it.
			float height = soleDot( soleLerp( way->from, way->to, s ), work->up ) +
			    parts[k] * soleDot( gradient, leg->landingForward );
			if ( sample->height > height && soleIsOnWay( work, leg, ball, d, s ) )
			{
				list[count++] = ( soleClearance ){ s, sample->height - height };
			}
		}
	}
	return count;
}

/// What the heel would meet at the end of the way, where nothing is lifted any more: the edge that it comes down
/// behind. Over the chord and the plane that it comes down on, highest.
static float soleFindHindrance( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way )
{
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length2 = soleDot( d, d );
	float heel = -leg->rig->heelBehind * work->rootScale;
	float under = heel * soleDot( way->toGradient, leg->landingForward );
	float highest = 0.0f;
	for ( int32_t i = 0; i < leg->sampleCount && length2 > BY_TIME * BY_TIME * leg->length * leg->length; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 ball = soleFindBall( leg, way, sample->place, heel );
		float s = soleDot( ball, d ) / length2;
		bool meets = sample->found && s > 1.0f - 2.0f * NEAR_END && s < 1.0f && soleIsOnWay( work, leg, ball, d, s );
		float chord = soleDot( soleLerp( way->from, way->to, s ), work->up ) + under;
		float plane = soleDot( way->to, work->up ) + soleDot( way->toGradient, soleSub( sample->place, way->to ) );
		highest = soleMaxF( highest, meets ? sample->height - soleMaxF( chord, plane ) : 0.0f );
	}
	return highest;
}

/// How much an edge so far over the foot's way asks for going ahead or waiting, 0 to 1.
static float soleAskFor( const soleLegWork* leg, float over )
{
	return soleSmoothly( soleSaturate( ( over / leg->length - LEAD_LOW ) / ( LEAD_HIGH - LEAD_LOW ) ) );
}

float soleFindLead( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way )
{
	return LEAD * soleAskFor( leg, soleFindHindrance( work, leg, way ) );
}

float soleFindWait( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way )
{
	soleVec3 d = soleHorizontal( work, soleSub( way->to, way->from ) );
	float length2 = soleDot( d, d );
	float toe = leg->rig->toeAhead * work->rootScale;
	float highest = 0.0f;
	for ( int32_t i = 0; i < leg->sampleCount && length2 > BY_TIME * BY_TIME * leg->length * leg->length; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 ball = soleFindBall( leg, way, sample->place, toe );
		float s = soleDot( ball, d ) / length2;
		bool meets = sample->found && s > -NEAR_END && s < WAIT_NEAR && soleIsOnWay( work, leg, ball, d, s );
		float plane =
		    soleDot( way->from, work->up ) + soleDot( way->fromGradient, soleSub( sample->place, way->from ) );
		float away = soleLength( soleHorizontal( work, soleSub( sample->place, way->from ) ) ) - toe;
		highest = soleMaxF( highest, meets ? sample->height - plane - STEEP * soleMaxF( away, 0.0f ) : 0.0f );
	}
	return soleAskFor( leg, highest );
}

soleVec3 soleLeadWay( const solePlaceWork* work, const soleLegWork* leg )
{
	float time = soleShareOfTime( leg );
	float lead = soleSmoothly( soleSaturate( ( time - SOLE_LEAD_FROM ) / LEAD_TIME ) );
	lead *= leg->state->stepLead * ( 1.0f - soleSmoothly( soleSaturate( ( time - LEAD_END ) / ( 1.0f - LEAD_END ) ) ) );
	soleVec3 ahead = soleScale( lead, soleHorizontal( work, soleSub( leg->landing, leg->ball ) ) );
	soleVec3 from = soleSub( leg->state->planePoint_w, work->root_w );
	soleVec3 come = soleHorizontal( work, soleSub( leg->soleCenter, from ) );
	float most = WAIT_MOST * leg->length;
	float wait = leg->state->stepWait * most / ( soleLength( come ) + most / WAIT );
	wait *= soleSmoothly( soleSaturate( time / SOLE_WAIT_UNTIL ) );
	wait *= 1.0f - soleSmoothly( soleSaturate( ( time - SOLE_WAIT_UNTIL ) / WAIT_TIME ) );
	return soleMulAdd( ahead, -wait, come );
}

/// Height of the upper hull of all clearances at a share.
static float soleHullAt( const soleClearance* list, int32_t count, float s )
{
	float highest = 0.0f;
	for ( int32_t i = 0; i < count; ++i )
	{
		for ( int32_t k = 0; k < count; ++k )
		{
			if ( list[i].share <= s && list[k].share > s )
			{
				float t = ( s - list[i].share ) / ( list[k].share - list[i].share );
				highest = soleMaxF( highest, list[i].lift + t * ( list[k].lift - list[i].lift ) );
			}
		}
	}
	return highest;
}

/// The least lift that clears all: the hull, smoothed, and as much higher as smoothing has lowered it somewhere.
static void soleLiftOver(
    const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float least, float lift[3] )
{
	soleClearance list[MAX_CLEARANCES];
	int32_t count = soleFindClearances( work, leg, way, least, list );
	for ( int32_t i = 0; i < 3; ++i )
	{
		lift[i] = soleHullAt( list, count, 0.25f * (float)( i + 1 ) );
	}
	float more = 1.0f;
	for ( int32_t i = 2; i < count; ++i )
	{
		float has = soleLiftAt( lift, list[i].share );
		more = has > 0.0f ? soleMaxF( more, list[i].lift / has ) : more;
	}
	more = soleMinF( more, MOST_MORE );
	for ( int32_t i = 0; i < 3; ++i )
	{
		lift[i] = soleMinF( more * lift[i], work->settings->probe.stepUp * leg->length );
	}
}

void soleFindLift( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float lift[3] )
{
	soleLiftOver( work, leg, way, -FLT_MAX, lift );
}

void soleFindNarrowLift( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float lift[3] )
{
	float ends = soleMaxF( soleDot( way->from, work->up ), soleDot( way->to, work->up ) );
	soleLiftOver( work, leg, way, ends + STANDS_OUT * leg->length, lift );
}
