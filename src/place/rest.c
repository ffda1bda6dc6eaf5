// SPDX-License-Identifier: MIT
// Rest: the plane that carries a rigid sole which stands on sampled ground.
//
// 1. Footprint. Of the samples only those under the sole count, with a margin: an edge that is nearly under it must be
//    known.
// 2. Levels. Neighbouring samples whose heights differ by more than their distance (45 degrees) plus a gap stand on
//    different levels; the level with the highest sample carries, the others hang over the edge. Without this a plane
//    would span from tread to tread.
// 3. The plane of a rigid sole that rests on the level: minimise its height c at the load point p subject to lying on
//    or above every sample,  min c + g.p  s.t.  c + g.x_i >= h_i.  By duality of this linear program its optimum is the
//    highest, at p, of all planes through three samples whose triangle holds p; that plane then lies on or above all
//    others. Where no triangle holds p the best pair that brackets it along the foot gives the pitch; else the highest
//    sample gives a flat plane. A foot that knows a single sample has the slope of the face that was met.
//    Samples on faces too steep to walk on never tilt it: they only hold it up.
// 4. The slope is clamped to what is walkable, and the height set anew so that the plane touches the level and no
//    sample is above it.
// 5. Ahead of the ball the samples also say how far the ground there stands over or under that plane: the toes' slope.
#include "place/rest.h"

#define MARGIN 0.012f      // L, around the sole
#define BEARS_UNDER 0.011f // L: a place this far under the sole bears it: 1 cm of a leg of 0.9 m
#define TOES_UP 0.65f      // rise per length: 33 degrees, toes that flip up further on a stone look broken
#define MAX_POINTS SOLE_MAX_PROBES_PER_LEG

/// A sample in the foot's own frame, around the load point: u ahead, v to the side, h up.
typedef struct soleRestPoint
{
	float u, v, h;
	bool ahead; // of the ball line
	bool under; // within the sole, without the margin
	int32_t level;
	const soleGroundSample* sample;
} soleRestPoint;

typedef struct soleRestPoints
{
	soleRestPoint points[MAX_POINTS];
	int32_t count;
	int32_t asked;      // places under the sole, with those where nothing was met
	int32_t askedAhead; // those ahead of the ball line
	bool atHeel, atToe; // places near both ends of the sole were asked for
	float gap;          // largest distance between those asked for in between
} soleRestPoints;

/// c + gu u + gv v
typedef struct soleFit
{
	float c, gu, gv;
} soleFit;

// ------------------------------------------------------------------------------------------------------- footprint

/// Largest distance from one place to the next one ahead of it.
static float soleFindGap( const float* places, int32_t count )
{
	float largest = 0.0f;
	for ( int32_t i = 0; i < count; ++i )
	{
		float next = 1e9f;
		for ( int32_t k = 0; k < count; ++k )
		{
			next = places[k] > places[i] ? soleMinF( next, places[k] - places[i] ) : next;
		}
		largest = next < 1e9f ? soleMaxF( largest, next ) : largest;
	}
	return largest;
}

static void soleFindPoints(
    const soleLegWork* leg, soleFootprint print, bool line, float loadAhead, soleRestPoints* found )
{
	const soleRigLeg* rig = leg->rig;
	float margin = MARGIN * leg->length;
	float heel = -rig->heelBehind * print.along;
	float toe = rig->toeAhead * print.along;
	float inner = rig->innerSide * print.across;
	float outer = rig->outerSide * print.across;
	float right = soleMaxF( inner, outer );
	float left = soleMinF( inner, outer );
	float asked[MAX_POINTS];
	int32_t askedCount = 0;
	found->count = 0;
	found->asked = 0;
	found->askedAhead = 0;
	found->atHeel = false;
	found->atToe = false;
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 from = soleSub( sample->place, print.ball );
		float u = soleDot( from, print.forward );
		float v = soleDot( from, print.side );
		bool near = u > heel - margin && u < toe + margin && v > left - margin && v < right + margin;
		bool middle = v > 0.25f * left && v < 0.25f * right;
		if ( near == false || ( line && middle == false ) )
		{
			continue;
		}
		asked[askedCount++] = u;
		bool under = u > heel - 0.1f * margin && u < toe + 0.1f * margin;
		bool ahead = u > 0.1f * toe;
		found->asked += under ? 1 : 0;
		found->askedAhead += under && ahead ? 1 : 0;
		found->atHeel = found->atHeel || u < heel + 2.0f * margin;
		found->atToe = found->atToe || u > toe - 2.0f * margin;
		if ( sample->found )
		{
			soleRestPoint* p = found->points + found->count++;
			*p = ( soleRestPoint ){ u - loadAhead, v, sample->height, ahead, under, found->count - 1, sample };
		}
	}
	found->gap = soleFindGap( asked, askedCount );
}

// ---------------------------------------------------------------------------------------------------------- levels

static void soleJoinLevels( soleRestPoints* read, float gap )
{
	// Points are neighbours when no other point is nearer to both: the relative neighbourhood graph. That is rows and
	// columns in the layouts here, and stays right when probes are missing or late.
	for ( int32_t i = 0; i < read->count; ++i )
	{
		for ( int32_t j = i + 1; j < read->count; ++j )
		{
			soleRestPoint a = read->points[i];
			soleRestPoint b = read->points[j];
			float d2 = ( a.u - b.u ) * ( a.u - b.u ) + ( a.v - b.v ) * ( a.v - b.v );
			bool neighbours = a.level != b.level;
			for ( int32_t k = 0; k < read->count && neighbours; ++k )
			{
				soleRestPoint c = read->points[k];
				float ac = ( a.u - c.u ) * ( a.u - c.u ) + ( a.v - c.v ) * ( a.v - c.v );
				float bc = ( b.u - c.u ) * ( b.u - c.u ) + ( b.v - c.v ) * ( b.v - c.v );
				neighbours = k == i || k == j || ac >= d2 || bc >= d2;
			}
			float step = a.h > b.h ? a.h - b.h : b.h - a.h;
			if ( neighbours == false || step > sqrtf( d2 ) + gap )
			{
				continue;
			}
			for ( int32_t k = 0; k < read->count; ++k )
			{
				read->points[k].level = read->points[k].level == b.level ? a.level : read->points[k].level;
			}
		}
	}
}

/// Keeps the points of the level that has the highest one under the sole; the others are dropped: what hangs, and what
/// stands beside it. @return how many were dropped
static int32_t soleKeepHighestLevel( soleRestPoints* read )
{
	int32_t highest = 0;
	for ( int32_t i = 1; i < read->count; ++i )
	{
		const soleRestPoint* p = read->points + i;
		const soleRestPoint* best = read->points + highest;
		bool higher = p->under == best->under ? p->h > best->h : p->under;
		highest = higher ? i : highest;
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
static bool soleFitTriangle(
    const soleRestPoint* a, const soleRestPoint* b, const soleRestPoint* c, float area, soleFit* fit )
{
	float bu = b->u - a->u, bv = b->v - a->v, cu = c->u - a->u, cv = c->v - a->v;
	float d = bu * cv - cu * bv;
	if ( d < area && d > -area )
	{
		return false;
	}
	float s = 1.0f / d;
	float wb = s * ( -a->u * cv + a->v * cu );
	float wc = s * ( -bu * a->v + bv * a->u );
	float wa = 1.0f - wb - wc;
	if ( wa < -1e-5f || wb < -1e-5f || wc < -1e-5f )
	{
		return false;
	}
	float bh = b->h - a->h, ch = c->h - a->h;
	fit->gu = s * ( bh * cv - ch * bv );
	fit->gv = s * ( bu * ch - cu * bh );
	fit->c = a->h - fit->gu * a->u - fit->gv * a->v;
	return true;
}

/// The slope along the foot through the best pair that brackets the load point.
static bool soleFitPair( const soleRestPoint* a, const soleRestPoint* b, float shortest, soleFit* fit )
{
	float du = b->u - a->u;
	if ( ( du < shortest && du > -shortest ) || a->u * b->u > 0.0f )
	{
		return false;
	}
	fit->gu = ( b->h - a->h ) / du;
	fit->gv = 0.0f;
	fit->c = a->h - fit->gu * a->u;
	return true;
}

static soleFit soleFitResting( const soleRestPoints* read, bool single, float footLength )
{
	const soleRestPoint* p = read->points;
	int32_t n = read->count;
	float area = 1e-3f * footLength * footLength;
	soleFit best = { 0.0f, 0.0f, 0.0f };
	bool found = false;
	soleFit fit;
	if ( single && n == 1 )
	{
		return ( soleFit ){ p[0].h, 0.0f, 0.0f };
	}
	for ( int32_t i = 0; i < n; ++i )
	{
		for ( int32_t j = i + 1; j < n; ++j )
		{
			for ( int32_t k = j + 1; k < n; ++k )
			{
				if ( soleFitTriangle( p + i, p + j, p + k, area, &fit ) && ( found == false || fit.c > best.c ) )
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
			if ( soleFitPair( p + i, p + j, 0.05f * footLength, &fit ) && ( found == false || fit.c > best.c ) )
			{
				best = fit;
				found = true;
			}
		}
	}
	return best; // flat, where nothing was found; raised by soleTouch
}

/// Sets the height so that the plane touches the level and no point is above it.
static void soleTouch( const soleRestPoints* read, soleFit* fit )
{
	for ( int32_t i = 0; i < read->count; ++i )
	{
		const soleRestPoint* p = read->points + i;
		float c = p->h - fit->gu * p->u - fit->gv * p->v;
		fit->c = i == 0 || c > fit->c ? c : fit->c;
	}
}

/// The points that may tilt the sole: toes bend, so they are left out where enough is left to carry it, and steep faces
/// only hold it up.
static soleRestPoints soleTakeTilting( const soleRestPoints* read, bool bends )
{
	soleRestPoints rest = { .count = 0 };
	int32_t behind = 0;
	for ( int32_t i = 0; i < read->count; ++i )
	{
		behind += read->points[i].ahead ? 0 : 1;
	}
	for ( int32_t i = 0; i < read->count; ++i )
	{
		bool toes = bends && behind >= 3 && read->points[i].ahead;
		if ( toes == false && read->points[i].sample->steep == false )
		{
			rest.points[rest.count++] = read->points[i];
		}
	}
	return rest;
}

/// All that holds the rigid part up.
static soleRestPoints soleTakeRigid( const soleRestPoints* read, bool bends )
{
	soleRestPoints rest = { .count = 0 };
	for ( int32_t i = 0; i < read->count; ++i )
	{
		if ( bends == false || read->points[i].ahead == false )
		{
			rest.points[rest.count++] = read->points[i];
		}
	}
	return rest.count > 0 ? rest : *read;
}

static float soleFindToeSlope( const soleRestPoints* read, const soleFit* fit, float ballU, float shortest )
{
	bool found = false;
	float slope = 0.0f;
	for ( int32_t i = 0; i < read->count; ++i )
	{
		const soleRestPoint* p = read->points + i;
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

/// The slope that toes can follow.
static float soleClampToeSlope( const solePlaceWork* work, float slope )
{
	soleHalf up = soleHalfFromAngle( soleMinF( work->settings->ankle.toeUp, 1.4f ) );
	soleHalf down = soleHalfFromAngle( work->settings->ankle.toeDown );
	float most = 2.0f * up.s * up.c / soleMaxF( up.c * up.c - up.s * up.s, 0.05f );
	float least = -2.0f * down.s * down.c / soleMaxF( down.c * down.c - down.s * down.s, 0.05f );
	return soleClampF( slope, least, soleMinF( most, TOES_UP ) );
}

static float soleShareOf( int32_t part, int32_t whole )
{
	return whole > 0 ? (float)part / (float)whole : 1.0f;
}

/// Which share of the places under the sole bears it, before and behind its ball, and how deep it is inside the ground.
static void soleJudge(
    const soleLegWork* leg, const soleRestPoints* all, const soleFit* fit, float ballU, soleRest* rest )
{
	float toes = rest->toeSlope;
	int32_t fore = 0;
	int32_t rear = 0;
	for ( int32_t i = 0; i < all->count; ++i )
	{
		const soleRestPoint* p = all->points + i;
		float bend = p->ahead ? toes * ( p->u - ballU ) : 0.0f;
		float gap = fit->c + fit->gu * p->u + fit->gv * p->v + bend - p->h;
		rest->sunk = soleMaxF( rest->sunk, -gap );
		bool bears = p->under && gap < BEARS_UNDER * leg->length;
		fore += bears && p->ahead ? 1 : 0;
		rear += bears && p->ahead == false ? 1 : 0;
	}
	rest->known = all->atHeel && all->atToe && all->gap < 4.0f * MARGIN * leg->length;
	rest->share = soleShareOf( fore + rear, all->asked );
	rest->foreShare = soleShareOf( fore, all->askedAhead );
	rest->rearShare = soleShareOf( rear, all->asked - all->askedAhead );
}

// ------------------------------------------------------------------------------------------------------------- rest

static soleFit soleFitSole( const solePlaceWork* work, const soleLegWork* leg, const soleRestPoints* level, bool single,
    float footLength, soleVec3 forward, soleVec3 side, bool* steep )
{
	bool bends = leg->rig->toeSlot != SOLE_NONE;
	soleRestPoints tilting = soleTakeTilting( level, bends );
	soleRestPoints rigid = soleTakeRigid( level, bends );
	soleFit fit = soleFitResting( &tilting, single, footLength );
	if ( single && tilting.count == 1 )
	{
		fit.gu = soleDot( tilting.points[0].sample->gradient, forward );
		fit.gv = soleDot( tilting.points[0].sample->gradient, side );
	}
	soleHalf limit = soleHalfFromAngle( work->settings->support.maxSlope );
	float steepest = 2.0f * limit.s * limit.c / soleMaxF( limit.c * limit.c - limit.s * limit.s, 0.05f );
	*steep = 2 * tilting.count < rigid.count;
	fit.gu = *steep ? 0.0f : soleClampF( fit.gu, -steepest, steepest );
	fit.gv = *steep ? 0.0f : soleClampF( fit.gv, -steepest, steepest );
	soleTouch( &rigid, &fit );
	return fit;
}

soleRest soleRestSole( const solePlaceWork* work, const soleLegWork* leg, soleFootprint print, bool line )
{
	const soleRigLeg* rig = leg->rig;
	soleVec3 forward = print.forward, side = print.side;
	float footLength = soleMaxF( ( rig->heelBehind + rig->toeAhead ) * print.along, 1e-3f * leg->length );
	float loadAhead =
	    print.along * ( work->settings->support.loadPoint * ( rig->heelBehind + rig->toeAhead ) - rig->heelBehind );
	soleVec3 load = soleMulAdd( print.ball, loadAhead, forward );
	soleVec3 level = soleVec( 0.0f, 0.0f, 0.0f );
	soleRest rest = { .surface = SOLE_NONE };
	soleRestPoints all, high;
	soleFindPoints( leg, print, line, loadAhead, &all );
	rest.found = all.count > 0;
	if ( rest.found == false )
	{
		rest.plane = soleMakePlane( work, soleAtHeight( work, load, work->reference ), level );
		return rest;
	}
	high = all;
	soleJoinLevels( &high, work->settings->support.levelGap * leg->length );
	int32_t hanging = soleKeepHighestLevel( &high );
	rest.onEdge = hanging > 0;
	float met = (float)all.count / (float)( all.asked > all.count ? all.asked : all.count );
	rest.confidence = met * ( 1.0f - 0.5f * (float)hanging / (float)all.count );
	soleFit fit = soleFitSole( work, leg, &high, all.asked == 1, footLength, forward, side, &rest.steep );
	if ( rig->toeSlot != SOLE_NONE )
	{
		float slope = soleFindToeSlope( &high, &fit, -loadAhead, 0.2f * rig->toeAhead * print.along );
		rest.toeSlope = soleClampToeSlope( work, slope );
	}
	soleJudge( leg, &all, &fit, -loadAhead, &rest );
	soleVec3 gradient = soleMulAdd( soleScale( fit.gu, forward ), fit.gv, side );
	rest.plane = soleMakePlane( work, soleAtHeight( work, load, fit.c ), gradient );
	const soleRestPoint* highest = high.points;
	for ( int32_t i = 1; i < high.count; ++i )
	{
		highest = high.points[i].h > highest->h ? high.points + i : highest;
	}
	rest.surface = highest->sample->surface;
	rest.velocity = highest->sample->velocity;
	return rest;
}
