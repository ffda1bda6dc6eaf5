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

/// Samples in the foot's own frame, around the load point. Subsets are bits, one a point.
typedef struct soleRestPoints
{
	float u[MAX_POINTS]; // ahead
	float v[MAX_POINTS]; // to the side
	float h[MAX_POINTS]; // up
	const soleGroundSample* samples[MAX_POINTS];
	int32_t count;
	uint32_t ahead; // of the ball line
	uint32_t under; // within the sole, without the margin
	uint32_t steep;
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

static bool soleHas( uint32_t set, int32_t i )
{
	return ( set >> i & 1u ) != 0;
}

static uint32_t soleBit( int32_t i )
{
	return 1u << i;
}

/// The points of a set, in order. @return how many
static int32_t soleList( uint32_t set, int32_t list[MAX_POINTS] )
{
	int32_t count = 0;
	for ( int32_t i = 0; set != 0; ++i, set >>= 1 )
	{
		list[count] = i;
		count += (int32_t)( set & 1u );
	}
	return count;
}

static int32_t soleCount( uint32_t set )
{
	int32_t count = 0;
	for ( ; set != 0; set &= set - 1u )
	{
		++count;
	}
	return count;
}

// ------------------------------------------------------------------------------------------------------- footprint

/// Largest distance from one place to the next one ahead of it. Puts them in order.
static float soleFindGap( float* places, int32_t count )
{
	float largest = 0.0f;
	for ( int32_t i = 1; i < count; ++i )
	{
		float place = places[i];
		int32_t k = i;
		for ( ; k > 0 && places[k - 1] > place; --k )
		{
			places[k] = places[k - 1];
		}
		places[k] = place;
	}
	for ( int32_t i = 1; i < count; ++i )
	{
		largest = soleMaxF( largest, places[i] - places[i - 1] );
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
	float narrow = line ? 0.25f : 1.0f;
	float beside = line ? 0.0f : margin;
	float asked[MAX_POINTS];
	int32_t askedCount = 0;
	found->count = 0;
	found->ahead = 0;
	found->under = 0;
	found->steep = 0;
	found->asked = 0;
	found->askedAhead = 0;
	found->atHeel = false;
	found->atToe = false;
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 from = soleSub( sample->place, print.ball );
		float u = soleDot( from, print.forward );
		if ( !( u > heel - margin && u < toe + margin ) )
		{
			continue;
		}
		float v = soleDot( from, print.side );
		if ( !( v > narrow * left - beside && v < narrow * right + beside ) )
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
			int32_t p = found->count++;
			found->u[p] = u - loadAhead;
			found->v[p] = v;
			found->h[p] = sample->height;
			found->samples[p] = sample;
			found->ahead |= ahead ? soleBit( p ) : 0u;
			found->under |= under ? soleBit( p ) : 0u;
			found->steep |= sample->steep ? soleBit( p ) : 0u;
		}
	}
	found->gap = soleFindGap( asked, askedCount );
}

// ---------------------------------------------------------------------------------------------------------- levels

/// Points are neighbours when no other point is nearer to both: the relative neighbourhood graph. That is rows and
/// columns in the layouts here, and stays right when probes are missing or late.
static bool soleAreNeighbours( const soleRestPoints* p, int32_t i, int32_t j, float d2 )
{
	for ( int32_t k = 0; k < p->count; ++k )
	{
		float iu = p->u[i] - p->u[k], iv = p->v[i] - p->v[k];
		float ju = p->u[j] - p->u[k], jv = p->v[j] - p->v[k];
		if ( iu * iu + iv * iv < d2 && ju * ju + jv * jv < d2 && k != i && k != j )
		{
			return false;
		}
	}
	return true;
}

/// May these two be on one level? If all may, all are: neighbours join the whole.
static bool soleAreLevel( const soleRestPoints* p, int32_t i, int32_t j, float d2, float gap )
{
	float step = p->h[i] > p->h[j] ? p->h[i] - p->h[j] : p->h[j] - p->h[i];
	float more = step - gap;
	return !( more > 0.0f ) || more * more <= d2;
}

static float soleDistance2( const soleRestPoints* p, int32_t i, int32_t j )
{
	float du = p->u[i] - p->u[j], dv = p->v[i] - p->v[j];
	return du * du + dv * dv;
}

static bool soleAreAllLevel( const soleRestPoints* p, float gap )
{
	for ( int32_t i = 0; i < p->count; ++i )
	{
		for ( int32_t j = i + 1; j < p->count; ++j )
		{
			if ( soleAreLevel( p, i, j, soleDistance2( p, i, j ), gap ) == false )
			{
				return false;
			}
		}
	}
	return true;
}

/// @param levels per point the set that it belongs to
static void soleJoinLevels( const soleRestPoints* p, float gap, uint32_t levels[MAX_POINTS] )
{
	for ( int32_t i = 0; i < p->count; ++i )
	{
		levels[i] = soleBit( i );
	}
	for ( int32_t i = 0; i < p->count; ++i )
	{
		for ( int32_t j = i + 1; j < p->count; ++j )
		{
			if ( soleHas( levels[i], j ) )
			{
				continue;
			}
			float d2 = soleDistance2( p, i, j );
			if ( soleAreLevel( p, i, j, d2, gap ) && soleAreNeighbours( p, i, j, d2 ) )
			{
				uint32_t both = levels[i] | levels[j];
				for ( int32_t k = 0; k < p->count; ++k )
				{
					levels[k] = soleHas( both, k ) ? both : levels[k];
				}
			}
		}
	}
}

/// The level that has the highest point under the sole. The others are left out: what hangs, and what stands beside it.
static uint32_t soleFindHighestLevel( const soleRestPoints* p, float gap )
{
	uint32_t levels[MAX_POINTS];
	if ( soleAreAllLevel( p, gap ) )
	{
		return p->count < MAX_POINTS ? soleBit( p->count ) - 1u : ~0u;
	}
	soleJoinLevels( p, gap, levels );
	int32_t highest = 0;
	for ( int32_t i = 1; i < p->count; ++i )
	{
		bool under = soleHas( p->under, i );
		bool higher = under == soleHas( p->under, highest ) ? p->h[i] > p->h[highest] : under;
		highest = higher ? i : highest;
	}
	return levels[highest];
}

// ----------------------------------------------------------------------------------------------------- resting plane

/// The plane through three points if their triangle holds the load point (the origin).
static bool soleFitTriangle( const soleRestPoints* p, int32_t i, int32_t j, int32_t k, float area, soleFit* fit )
{
	float u = p->u[i], v = p->v[i], h = p->h[i];
	float bu = p->u[j] - u, bv = p->v[j] - v, cu = p->u[k] - u, cv = p->v[k] - v;
	float d = bu * cv - cu * bv;
	if ( d < area && d > -area )
	{
		return false;
	}
	float s = 1.0f / d;
	float wb = s * ( -u * cv + v * cu );
	float wc = s * ( -bu * v + bv * u );
	float wa = 1.0f - wb - wc;
	if ( wa < -1e-5f || wb < -1e-5f || wc < -1e-5f )
	{
		return false;
	}
	float bh = p->h[j] - h, ch = p->h[k] - h;
	fit->gu = s * ( bh * cv - ch * bv );
	fit->gv = s * ( bu * ch - cu * bh );
	fit->c = h - fit->gu * u - fit->gv * v;
	return true;
}

/// The slope along the foot through the best pair that brackets the load point.
static bool soleFitPair( const soleRestPoints* p, int32_t i, int32_t j, float shortest, soleFit* fit )
{
	float du = p->u[j] - p->u[i];
	if ( ( du < shortest && du > -shortest ) || p->u[i] * p->u[j] > 0.0f )
	{
		return false;
	}
	fit->gu = ( p->h[j] - p->h[i] ) / du;
	fit->gv = 0.0f;
	fit->c = p->h[i] - fit->gu * p->u[i];
	return true;
}

/// @param line they lie on one: there are no triangles
static soleFit soleFitResting( const soleRestPoints* p, uint32_t set, bool line, float footLength )
{
	int32_t list[MAX_POINTS];
	int32_t n = soleList( set, list );
	float area = 1e-3f * footLength * footLength;
	soleFit best = { 0.0f, 0.0f, 0.0f };
	bool found = false;
	soleFit fit;
	for ( int32_t i = 0; i < n && line == false; ++i )
	{
		for ( int32_t j = i + 1; j < n; ++j )
		{
			for ( int32_t k = j + 1; k < n; ++k )
			{
				bool holds = soleFitTriangle( p, list[i], list[j], list[k], area, &fit );
				if ( holds && ( found == false || fit.c > best.c ) )
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
			bool brackets = soleFitPair( p, list[i], list[j], 0.05f * footLength, &fit );
			if ( brackets && ( found == false || fit.c > best.c ) )
			{
				best = fit;
				found = true;
			}
		}
	}
	return best; // flat, where nothing was found; raised by soleTouch
}

/// Sets the height so that the plane touches the level and no point is above it.
static void soleTouch( const soleRestPoints* p, uint32_t set, soleFit* fit )
{
	bool first = true;
	for ( int32_t i = 0; i < p->count; ++i )
	{
		if ( soleHas( set, i ) )
		{
			float c = p->h[i] - fit->gu * p->u[i] - fit->gv * p->v[i];
			fit->c = first || c > fit->c ? c : fit->c;
			first = false;
		}
	}
}

/// The points that may tilt the sole: toes bend, so they are left out where enough is left to carry it, and steep faces
/// only hold it up.
static uint32_t soleTakeTilting( const soleRestPoints* p, uint32_t level, bool bends )
{
	bool toes = bends && soleCount( level & ~p->ahead ) >= 3;
	return level & ~p->steep & ~( toes ? p->ahead : 0u );
}

/// All that holds the rigid part up.
static uint32_t soleTakeRigid( const soleRestPoints* p, uint32_t level, bool bends )
{
	uint32_t rigid = bends ? level & ~p->ahead : level;
	return rigid != 0 ? rigid : level;
}

static float soleFindToeSlope(
    const soleRestPoints* p, uint32_t level, const soleFit* fit, float ballU, float shortest )
{
	bool found = false;
	float slope = 0.0f;
	for ( int32_t i = 0; i < p->count; ++i )
	{
		float ahead = p->u[i] - ballU;
		if ( soleHas( level & p->ahead, i ) == false || ahead < shortest )
		{
			continue;
		}
		float over = p->h[i] - ( fit->c + fit->gu * p->u[i] + fit->gv * p->v[i] );
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
	uint32_t bearing = 0;
	for ( int32_t i = 0; i < all->count; ++i )
	{
		float bend = soleHas( all->ahead, i ) ? toes * ( all->u[i] - ballU ) : 0.0f;
		float gap = fit->c + fit->gu * all->u[i] + fit->gv * all->v[i] + bend - all->h[i];
		rest->sunk = soleMaxF( rest->sunk, -gap );
		bearing |= gap < BEARS_UNDER * leg->length ? soleBit( i ) : 0u;
	}
	int32_t fore = soleCount( bearing & all->under & all->ahead );
	int32_t rear = soleCount( bearing & all->under & ~all->ahead );
	rest->known = all->atHeel && all->atToe && all->gap < 4.0f * MARGIN * leg->length;
	rest->share = soleShareOf( fore + rear, all->asked );
	rest->foreShare = soleShareOf( fore, all->askedAhead );
	rest->rearShare = soleShareOf( rear, all->asked - all->askedAhead );
}

// ------------------------------------------------------------------------------------------------------------- rest

/// The plane of one level, its slope within what can be walked on.
static soleFit soleFitSole( const solePlaceWork* work, const soleLegWork* leg, const soleRestPoints* points,
    uint32_t level, bool line, soleFootprint print, bool* steep )
{
	bool bends = leg->rig->toeSlot != SOLE_NONE;
	float foot = ( leg->rig->heelBehind + leg->rig->toeAhead ) * print.along;
	uint32_t tilting = soleTakeTilting( points, level, bends );
	uint32_t rigid = soleTakeRigid( points, level, bends );
	soleFit fit = soleFitResting( points, tilting, line, soleMaxF( foot, 1e-3f * leg->length ) );
	int32_t list[MAX_POINTS];
	if ( points->asked == 1 && soleList( tilting, list ) == 1 )
	{
		soleVec3 gradient = points->samples[list[0]]->gradient;
		fit.gu = soleDot( gradient, print.forward );
		fit.gv = soleDot( gradient, print.side );
	}
	soleHalf limit = soleHalfFromAngle( work->settings->support.maxSlope );
	float steepest = 2.0f * limit.s * limit.c / soleMaxF( limit.c * limit.c - limit.s * limit.s, 0.05f );
	*steep = 2 * soleCount( tilting ) < soleCount( rigid );
	fit.gu = *steep ? 0.0f : soleClampF( fit.gu, -steepest, steepest );
	fit.gv = *steep ? 0.0f : soleClampF( fit.gv, -steepest, steepest );
	soleTouch( points, rigid, &fit );
	return fit;
}

static const soleGroundSample* soleFindHighest( const soleRestPoints* p, uint32_t level )
{
	int32_t highest = -1;
	for ( int32_t i = 0; i < p->count; ++i )
	{
		bool higher = soleHas( level, i ) && ( highest < 0 || p->h[i] > p->h[highest] );
		highest = higher ? i : highest;
	}
	return p->samples[highest];
}

soleRest soleRestSole( const solePlaceWork* work, const soleLegWork* leg, soleFootprint print, bool line )
{
	const soleRigLeg* rig = leg->rig;
	float loadAhead =
	    print.along * ( work->settings->support.loadPoint * ( rig->heelBehind + rig->toeAhead ) - rig->heelBehind );
	soleVec3 load = soleMulAdd( print.ball, loadAhead, print.forward );
	soleRest rest = { .surface = SOLE_NONE };
	soleRestPoints points;
	soleFindPoints( leg, print, line, loadAhead, &points );
	rest.found = points.count > 0;
	if ( rest.found == false )
	{
		soleVec3 level = soleVec( 0.0f, 0.0f, 0.0f );
		rest.plane = soleMakePlane( work, soleAtHeight( work, load, work->reference ), level );
		return rest;
	}
	uint32_t level = soleFindHighestLevel( &points, work->settings->support.levelGap * leg->length );
	int32_t hanging = points.count - soleCount( level );
	rest.onEdge = hanging > 0;
	float met = (float)points.count / (float)( points.asked > points.count ? points.asked : points.count );
	rest.confidence = met * ( 1.0f - 0.5f * (float)hanging / (float)points.count );
	soleFit fit = soleFitSole( work, leg, &points, level, line, print, &rest.steep );
	if ( rig->toeSlot != SOLE_NONE )
	{
		float slope = soleFindToeSlope( &points, level, &fit, -loadAhead, 0.2f * rig->toeAhead * print.along );
		rest.toeSlope = soleClampToeSlope( work, slope );
	}
	soleJudge( leg, &points, &fit, -loadAhead, &rest );
	soleVec3 gradient = soleMulAdd( soleScale( fit.gu, print.forward ), fit.gv, print.side );
	rest.plane = soleMakePlane( work, soleAtHeight( work, load, fit.c ), gradient );
	const soleGroundSample* highest = soleFindHighest( &points, level );
	rest.surface = highest->surface;
	rest.velocity = highest->velocity;
	return rest;
}
