// SPDX-License-Identifier: MIT
// Support: hits to the plane that carries the sole.
//
// 1. Levels. Neighbouring probes whose heights differ by more than their distance (45 degrees) plus a gap stand on
//    different levels; the level with the highest probe carries, the others hang over the edge. Without this a plane
//    would span from tread to tread.
// 2. The plane of a rigid sole that rests on the level: minimise its height c at the load point p subject to lying on
// or
//    above every probe,  min c + g.p  s.t.  c + g.x_i >= h_i.  By duality of this linear program its optimum is the
//    highest, at p, of all planes through three probes whose triangle holds p; that plane then lies on or above all
//    others. Where no triangle holds p the best pair that brackets it along the foot gives the pitch; else the highest
//    probe gives a flat plane.
//    A foot that asks with a single probe has the slope of the face that it met.
// 3. The slope is clamped to what is walkable, and the height set anew so that the plane touches the level and no probe
//    is above it.
// 4. What the ground was one frame ago is inertialised: the difference of old and new plane over the sole is kept as an
//    offset that decays. Slopes pass without lag, since the old plane already foretold them; steps are taken up softly
//    by a foot in flight, quickly by a planted one.
// 5. A foot in flight has to pass over what comes: where the ground that its toes will be over soon is higher than the
//    plane, the plane is raised by as much.
// 6. Ahead of the ball the probes also say how far the ground there stands over or under that plane: the toes' slope.
#include "place/place.h"

#define GENTLE 0.5f // rise per length
#define MAX_POINTS SOLE_MAX_PROBES_PER_LEG

/// A probe's answer in the foot's own frame: u ahead, v to the side, h up from the reference height, around the load
/// point.
typedef struct soleGroundPoint
{
	float u, v, h;
	float su, sv; // slope of the face that was met
	bool ahead;   // of the ball line
	bool steep;   // the face cannot be walked on
	int32_t level;
} soleGroundPoint;

typedef struct soleGroundPoints
{
	soleGroundPoint points[MAX_POINTS];
	int32_t count;
} soleGroundPoints;

/// c + gu u + gv v
typedef struct soleFit
{
	float c, gu, gv;
} soleFit;

static int32_t soleMinI( int32_t a, int32_t b )
{
	return a < b ? a : b;
}

// ------------------------------------------------------------------------------------------------ reading the hits

static void soleReadHits( const solePlaceWork* work, const soleLegWork* leg, const soleHit* hits, int32_t hitCount,
    soleVec3 load, float minimumUp, soleGroundPoints* read )
{
	soleVec3 side = soleCross( leg->soleForward, work->up );
	float reach = ( work->settings->probe.stepUp + work->settings->probe.stepDown ) * leg->length;
	read->count = 0;
	for ( int32_t i = 0; i < hitCount && read->count < MAX_POINTS; ++i )
	{
		const soleHit* hit = hits + i;
		if ( hit->hit == false || !soleVec3_IsFinite( hit->point_w ) || !soleVec3_IsFinite( hit->normal_w ) )
		{
			continue;
		}
		soleVec3 normal = soleNormalizeOr( hit->normal_w, work->up );
		float normalUp = soleDot( normal, work->up );
		if ( !( normalUp > 1e-3f ) )
		{
			continue; // a ceiling or a wall
		}
		// The height of the touched face over the place that was asked for, not over the place that was touched: a
		// sphere touches off its axis.
		soleVec3 point = soleSub( hit->point_w, work->root_w );
		soleVec3 asked = soleVec3_IsFinite( hit->asked_w ) ? soleSub( hit->asked_w, work->root_w ) : point;
		soleVec3 across = soleHorizontal( work, soleSub( asked, point ) );
		float h = soleDot( point, work->up );
		float slope = soleDot( across, normal ) / normalUp;
		if ( normalUp > minimumUp )
		{
			h -= slope;
		}
		if ( !( h - work->reference < 2.0f * reach && work->reference - h < 2.0f * reach ) )
		{
			continue;
		}
		soleVec3 from = soleSub( asked, load );
		soleGroundPoint* p = read->points + read->count++;
		p->u = soleDot( from, leg->soleForward );
		p->v = soleDot( from, side );
		p->h = h - work->reference;
		p->su = -soleDot( normal, leg->soleForward ) / normalUp;
		p->sv = -soleDot( normal, side ) / normalUp;
		p->ahead = soleDot( soleSub( asked, leg->soleCenter ), leg->soleForward ) > 0.1f * leg->rig->toeAhead;
		p->steep = !( normalUp >= minimumUp );
		p->level = read->count - 1;
	}
}

// ---------------------------------------------------------------------------------------------------------- levels

static void soleJoinLevels( soleGroundPoints* read, float gap )
{
	// Points are neighbours when no other point is nearer to both: the relative neighbourhood graph. That is rows and
	// columns in the layouts here, and stays right when probes are missing or late.
	for ( int32_t i = 0; i < read->count; ++i )
	{
		for ( int32_t j = i + 1; j < read->count; ++j )
		{
			soleGroundPoint a = read->points[i];
			soleGroundPoint b = read->points[j];
			float d2 = ( a.u - b.u ) * ( a.u - b.u ) + ( a.v - b.v ) * ( a.v - b.v );
			bool neighbours = true;
			for ( int32_t k = 0; k < read->count && neighbours; ++k )
			{
				soleGroundPoint c = read->points[k];
				float ac = ( a.u - c.u ) * ( a.u - c.u ) + ( a.v - c.v ) * ( a.v - c.v );
				float bc = ( b.u - c.u ) * ( b.u - c.u ) + ( b.v - c.v ) * ( b.v - c.v );
				neighbours = k == i || k == j || ac >= d2 || bc >= d2;
			}
			float step = a.h > b.h ? a.h - b.h : b.h - a.h;
			if ( neighbours == false || step > sqrtf( d2 ) + gap || a.level == b.level )
			{
				continue;
			}
			for ( int32_t k = 0; k < read->count; ++k )
			{
				if ( read->points[k].level == b.level && k != i )
				{
					read->points[k].level = a.level;
				}
			}
		}
	}
}

/// Keeps the points of the level that has the highest one; the others are dropped. @return how many were dropped
static int32_t soleKeepHighestLevel( soleGroundPoints* read )
{
	int32_t highest = 0;
	for ( int32_t i = 1; i < read->count; ++i )
	{
		highest = read->points[i].h > read->points[highest].h ? i : highest;
	}
	int32_t level = read->points[highest].level;
	int32_t kept = 0;
	for ( int32_t i = 0; i < read->count; ++i )
	{
		if ( read->points[i].level == level )
		{
			read->points[kept++] = read->points[i];
		}
	}
	int32_t dropped = read->count - kept;
	read->count = kept;
	return dropped;
}

// ----------------------------------------------------------------------------------------------------- resting plane

/// The plane through three points if their triangle holds the load point (the origin).
static bool soleFitTriangle( soleGroundPoint a, soleGroundPoint b, soleGroundPoint c, float area, soleFit* fit )
{
	float bu = b.u - a.u, bv = b.v - a.v, cu = c.u - a.u, cv = c.v - a.v;
	float d = bu * cv - cu * bv;
	if ( d < area && d > -area )
	{
		return false;
	}
	float s = 1.0f / d;
	float wb = s * ( -a.u * cv + a.v * cu );
	float wc = s * ( -bu * a.v + bv * a.u );
	float wa = 1.0f - wb - wc;
	if ( wa < -1e-5f || wb < -1e-5f || wc < -1e-5f )
	{
		return false;
	}
	float bh = b.h - a.h, ch = c.h - a.h;
	fit->gu = s * ( bh * cv - ch * bv );
	fit->gv = s * ( bu * ch - cu * bh );
	fit->c = a.h - fit->gu * a.u - fit->gv * a.v;
	return true;
}

/// The slope along the foot through the best pair that brackets the load point.
static bool soleFitPair( soleGroundPoint a, soleGroundPoint b, float shortest, soleFit* fit )
{
	float du = b.u - a.u;
	if ( ( du < shortest && du > -shortest ) || a.u * b.u > 0.0f )
	{
		return false;
	}
	fit->gu = ( b.h - a.h ) / du;
	fit->gv = 0.0f;
	fit->c = a.h - fit->gu * a.u;
	return true;
}

static soleFit soleFitResting( const soleGroundPoints* read, int32_t asked, float footLength )
{
	const soleGroundPoint* p = read->points;
	int32_t n = read->count;
	float area = 1e-3f * footLength * footLength;
	soleFit best = { 0.0f, 0.0f, 0.0f };
	bool found = false;
	soleFit fit;
	if ( asked == 1 && n == 1 )
	{
		return ( soleFit ){ p[0].h, p[0].su, p[0].sv };
	}
	for ( int32_t i = 0; i < n; ++i )
	{
		for ( int32_t j = i + 1; j < n; ++j )
		{
			for ( int32_t k = j + 1; k < n; ++k )
			{
				if ( soleFitTriangle( p[i], p[j], p[k], area, &fit ) && ( found == false || fit.c > best.c ) )
				{
					best = fit;
					found = true;
				}
			}
		}
	}
	if ( found )
	{
		return best;
	}
	for ( int32_t i = 0; i < n; ++i )
	{
		for ( int32_t j = i + 1; j < n; ++j )
		{
			if ( soleFitPair( p[i], p[j], 0.05f * footLength, &fit ) && ( found == false || fit.c > best.c ) )
			{
				best = fit;
				found = true;
			}
		}
	}
	return best; // flat, where nothing was found; raised by soleTouch
}

/// Sets the height so that the plane touches the level and no point is above it.
static void soleTouch( const soleGroundPoints* read, soleFit* fit )
{
	for ( int32_t i = 0; i < read->count; ++i )
	{
		const soleGroundPoint* p = read->points + i;
		float c = p->h - fit->gu * p->u - fit->gv * p->v;
		fit->c = i == 0 || c > fit->c ? c : fit->c;
	}
}

/// Toes bend: they are left out of the rigid plane where enough is left to carry it.
static soleGroundPoints soleWithoutToes( const soleGroundPoints* read )
{
	soleGroundPoints rest = { .count = 0 };
	for ( int32_t i = 0; i < read->count; ++i )
	{
		if ( read->points[i].ahead == false )
		{
			rest.points[rest.count++] = read->points[i];
		}
	}
	return rest.count >= 3 ? rest : *read;
}

static float soleFindToeSlope( const soleGroundPoints* read, const soleFit* fit, float ballU, float shortest )
{
	bool found = false;
	float slope = 0.0f;
	for ( int32_t i = 0; i < read->count; ++i )
	{
		const soleGroundPoint* p = read->points + i;
		float ahead = p->u - ballU;
		if ( p->ahead == false || ahead < shortest )
		{
			continue;
		}
		float over = p->h - ( fit->c + fit->gu * p->u + fit->gv * p->v );
		slope = found && slope > over / ahead ? slope : over / ahead;
		found = true;
	}
	return slope;
}

// --------------------------------------------------------------------------------------------------------- the stage

/// The plane as the ground is now.
static void soleFindRawPlane( solePlaceWork* work, soleLegWork* leg, const soleHit* hits, int32_t hitCount )
{
	const soleRigLeg* rig = leg->rig;
	float scale = work->rootScale;
	float footLength = soleMaxF( ( rig->heelBehind + rig->toeAhead ) * scale, 1e-3f * leg->length );
	float loadAhead = work->settings->support.loadPoint * ( rig->heelBehind + rig->toeAhead ) - rig->heelBehind;
	soleVec3 load = soleMulAdd( leg->soleCenter, loadAhead * scale, leg->soleForward );
	soleHalf limit = soleHalfFromAngle( work->settings->support.maxSlope );
	float minimumUp = limit.c * limit.c - limit.s * limit.s;

	soleGroundPoints read;
	soleReadHits( work, leg, hits, hitCount, load, minimumUp, &read );
	leg->hasGround = read.count > 0;
	leg->toeSlope = 0.0f;
	leg->out->confidence = 0.0f;
	if ( leg->hasGround == false )
	{
		leg->raw = soleMakePlane( work, soleAtHeight( work, load, work->reference ), soleVec( 0.0f, 0.0f, 0.0f ) );
		return;
	}
	int32_t asked = read.count;
	soleJoinLevels( &read, work->settings->support.levelGap * leg->length );
	int32_t hanging = soleKeepHighestLevel( &read );
	leg->out->flags |= hanging > 0 ? (uint32_t)sole_legOnEdge : 0u;
	leg->out->confidence =
	    ( (float)asked / (float)( hitCount > 0 ? hitCount : 1 ) ) * ( 1.0f - 0.5f * (float)hanging / (float)asked );

	bool bends = rig->toeSlot != SOLE_NONE;
	soleGroundPoints rigid = bends ? soleWithoutToes( &read ) : read;
	soleFit fit = soleFitResting( &rigid, hitCount, footLength );
	float steepest = 2.0f * limit.s * limit.c / soleMaxF( minimumUp, 0.05f );
	int32_t steep = 0;
	for ( int32_t i = 0; i < rigid.count; ++i )
	{
		steep += rigid.points[i].steep ? 1 : 0;
	}
	if ( 2 * steep > rigid.count )
	{
		leg->out->flags |= (uint32_t)sole_legTooSteep;
		fit.gu = 0.0f;
		fit.gv = 0.0f;
	}
	fit.gu = soleClampF( fit.gu, -steepest, steepest );
	fit.gv = soleClampF( fit.gv, -steepest, steepest );
	soleTouch( &rigid, &fit );
	if ( bends )
	{
		leg->toeSlope = soleFindToeSlope( &read, &fit, -loadAhead * scale, 0.2f * rig->toeAhead * scale );
	}
	soleVec3 side = soleCross( leg->soleForward, work->up );
	soleVec3 gradient = soleMulAdd( soleScale( fit.gu, leg->soleForward ), fit.gv, side );
	leg->raw = soleMakePlane( work, soleAtHeight( work, load, work->reference + fit.c ), gradient );
}

/// How much higher than the plane the ground is that a foot in flight will pass over. What rises gently on the way
/// there is no obstacle: the foot's own plane follows it.
static float soleFindObstacle(
    const solePlaceWork* work, const soleLegWork* leg, const soleHit* hits, int32_t hitCount )
{
	float obstacle = 0.0f;
	for ( int32_t i = 0; i < hitCount && leg->flying; ++i )
	{
		const soleHit* hit = hits + i;
		if ( hit->hit && soleVec3_IsFinite( hit->point_w ) && soleDot( hit->normal_w, work->up ) > 1e-3f )
		{
			soleVec3 point = soleSub( hit->point_w, work->root_w );
			float over = soleDot( point, work->up ) - solePlaneHeight( work, leg->raw, point );
			float gentle = GENTLE * soleDistance( soleHorizontal( work, point ), soleHorizontal( work, leg->tip ) );
			over = soleMinF( over, 3.0f * soleMaxF( over - gentle, 0.0f ) );
			obstacle = soleMaxF( obstacle, soleMinF( over, work->settings->probe.stepUp * leg->length ) );
		}
	}
	return obstacle;
}

/// Keeps what differs between the last frame's plane and this one's, and lets it decay.
static void soleInertialise( solePlaceWork* work, soleLegWork* leg )
{
	soleLegState* state = leg->state;
	if ( work->first == false )
	{
		float oldUp = soleMaxF( soleDot( state->planeNormal_w, work->up ), 0.05f );
		soleVec3 oldGradient = soleScale( -1.0f / oldUp, soleHorizontal( work, state->planeNormal_w ) );
		solePlane old = soleMakePlane( work, soleSub( state->planePoint_w, work->root_w ), oldGradient );
		state->height.value += solePlaneHeight( work, old, leg->raw.point ) - soleDot( leg->raw.point, work->up );
		state->gradient.value = soleAdd( state->gradient.value, soleSub( old.gradient, leg->raw.gradient ) );
		bool locked = ( state->flags & sole_stateLocked ) != 0;
		float planted = work->settings->support.plantedHalfLife;
		state->height = soleDecayOffset1(
		    state->height, locked ? planted : work->settings->support.heightHalfLife, work->timeStep );
		state->gradient = soleDecayOffset3(
		    state->gradient, locked ? planted : work->settings->support.gradientHalfLife, work->timeStep );
	}
	state->planePoint_w = soleAdd( leg->raw.point, work->root_w );
	state->planeNormal_w = leg->raw.normal;
	soleVec3 gradient = soleHorizontal( work, soleAdd( leg->raw.gradient, state->gradient.value ) );
	leg->plane = soleMakePlane( work, soleMulAdd( leg->raw.point, state->height.value, work->up ), gradient );
}

void soleFindSupport( solePlaceWork* work, const soleHit* hits, int32_t hitCount )
{
	int32_t perLeg = soleProbesPerLeg( work->settings );
	int32_t perSole = soleProbesPerSole( work->settings );
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		int32_t first = soleMinI( i * perLeg, hitCount );
		soleFindRawPlane( work, leg, hits + first, soleMinI( perSole, hitCount - first ) );
		int32_t ahead = soleMinI( first + perSole, hitCount );
		float obstacle = soleFindObstacle( work, leg, hits + ahead, soleMinI( SOLE_AHEAD, hitCount - ahead ) );
		leg->raw.point = soleMulAdd( leg->raw.point, obstacle, work->up );
		soleInertialise( work, leg );
		if ( leg->hasGround == false )
		{
			leg->out->flags |= (uint32_t)sole_legNoGround;
		}
		leg->out->heightDemand = soleDot( leg->plane.point, work->up ) - work->reference;
	}
}
