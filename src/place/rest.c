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
//    others. It is found by the simplex method: from any such triangle, the sample that is highest over its plane takes
//    the place of a corner until none is. Where no triangle holds p the best pair that brackets it along the foot gives
//    the pitch; else the highest sample gives a flat plane. A foot that knows a single sample has the slope of the face
//    that was met. Samples on faces too steep to walk on never tilt it: they only hold it up.
// 4. The slope is clamped to what is walkable, and the height set anew so that the plane touches the level and no
//    sample is above it.
// 5. Ahead of the ball the samples also say how far the ground there stands over or under that plane: the toes' slope.
#include "place/rest.h"

#include "place/rest_plane.h"

#define MARGIN 0.012f      // L, around the sole
#define BEARS_UNDER 0.011f // L: a place this far under the sole bears it: 1 cm of a leg of 0.9 m

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

/// Copies of the first point up to a whole number of vectors.
static void soleFillUp( soleRestPoints* points )
{
	for ( int32_t p = points->count; p % SOLE_WIDTH != 0; ++p )
	{
		points->u[p] = points->u[0];
		points->v[p] = points->v[0];
		points->h[p] = points->h[0];
		points->fore[p] = points->fore[0];
	}
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
	float narrow = line ? 0.25f : 1.0f;
	float beside = line ? 0.0f : margin;
	float left = narrow * soleMinF( inner, outer ) - beside;
	float right = narrow * soleMaxF( inner, outer ) + beside;
	float asked[SOLE_MAX_REST_POINTS];
	int32_t askedCount = 0, count = 0;
	uint32_t ahead = 0, under = 0, steep = 0, nearHeel = 0, nearToe = 0;
	int32_t askedUnder = 0, askedAhead = 0;
	for ( int32_t i = 0; i < leg->sampleCount; ++i )
	{
		const soleGroundSample* sample = leg->samples + i;
		soleVec3 from = soleSub( sample->place, print.ball );
		float u = soleDot( from, print.forward );
		float v = soleDot( from, print.side );
		// An end of the sole is known where something was asked near it, or beyond.
		uint32_t isBeside = ( v > left ) & ( v < right );
		nearHeel |= isBeside & ( u < heel + margin );
		nearToe |= isBeside & ( u > toe - margin );
		// Where places lie cannot be foretold: one branch for all four limits.
		if ( ( isBeside & ( u > heel - margin ) & ( u < toe + margin ) ) == 0 )
		{
			continue;
		}
		asked[askedCount++] = u;
		uint32_t isUnder = ( u > heel - 0.1f * margin ) & ( u < toe + 0.1f * margin );
		uint32_t isAhead = u > 0.1f * toe;
		askedUnder += (int32_t)isUnder;
		askedAhead += (int32_t)( isUnder & isAhead );
		if ( sample->found )
		{
			found->u[count] = u - loadAhead;
			found->v[count] = v;
			found->h[count] = sample->height;
			found->fore[count] = (float)(int32_t)isAhead;
			found->samples[count] = sample;
			ahead |= isAhead << count;
			under |= isUnder << count;
			steep |= (uint32_t)sample->steep << count;
			count += 1;
		}
	}
	found->count = count;
	found->ahead = ahead;
	found->under = under;
	found->steep = steep;
	found->asked = askedUnder;
	found->askedAhead = askedAhead;
	found->atHeel = nearHeel != 0;
	found->atToe = nearToe != 0;
	found->gap = line ? soleFindGap( asked, askedCount ) : 0.0f;
	soleFillUp( found );
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
	for ( uint32_t rest = level & p->ahead; rest != 0; rest &= rest - 1u )
	{
		int32_t i = (int32_t)soleGetLowestBit( rest );
		float ahead = p->u[i] - ballU;
		if ( ahead < shortest )
		{
			continue;
		}
		float over = p->h[i] - ( fit->c + fit->gu * p->u[i] + fit->gv * p->v[i] );
		slope = found && slope > over / ahead ? slope : over / ahead;
		found = true;
	}
	return slope;
}

static float soleShareOf( int32_t part, int32_t whole )
{
	return whole > 0 ? (float)part / (float)whole : 1.0f;
}

/// Which share of the places under the sole bears it, before and behind its ball, and how deep it is inside the ground.
static void soleJudge(
    const soleLegWork* leg, const soleRestPoints* all, const soleFit* fit, float ballU, soleRest* rest )
{
	soleWide zero = soleWide_Set( 0.0f );
	soleWide deepest = zero;
	uint32_t bearing = 0;
	for ( int32_t i = 0; i < all->count; i += SOLE_WIDTH )
	{
		soleWide ahead = soleWide_Sub( soleWide_Load( all->u + i ), soleWide_Set( ballU ) );
		soleWideMask bends = soleWide_Less( zero, soleWide_Load( all->fore + i ) );
		soleWide bend = soleWide_Select( bends, soleWide_Mul( soleWide_Set( rest->toeSlope ), ahead ), zero );
		soleWide sole = soleWide_Add( soleGetFitHeights( all, i, fit ), bend );
		soleWide gap = soleWide_Sub( sole, soleWide_Load( all->h + i ) );
		deepest = soleWide_Min( deepest, gap );
		bearing |= soleWide_GetBits( soleWide_Less( gap, soleWide_Set( BEARS_UNDER * leg->length ) ) ) << i;
	}
	float gaps[SOLE_WIDTH];
	soleWide_Store( gaps, deepest );
	rest->sunk = -soleMinF( soleMinF( gaps[0], gaps[1] ), soleMinF( gaps[2], gaps[3] ) );
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
	if ( points->asked == 1 && points->count == 1 && tilting != 0 )
	{
		soleVec3 gradient = points->samples[0]->gradient;
		fit.gu = soleDot( gradient, print.forward );
		fit.gv = soleDot( gradient, print.side );
	}
	soleHalf limit = work->angles.walkable;
	float steepest = 2.0f * limit.s * limit.c / soleMaxF( limit.c * limit.c - limit.s * limit.s, 0.05f );
	*steep = 2 * soleCount( tilting ) < soleCount( rigid );
	fit.gu = *steep ? 0.0f : soleClampF( fit.gu, -steepest, steepest );
	fit.gv = *steep ? 0.0f : soleClampF( fit.gv, -steepest, steepest );
	soleTouch( points, rigid, &fit );
	return fit;
}

static const soleGroundSample* soleFindHighest( const soleRestPoints* p, uint32_t level )
{
	int32_t highest = (int32_t)soleGetLowestBit( level );
	for ( uint32_t rest = level; rest != 0; rest &= rest - 1u )
	{
		int32_t i = (int32_t)soleGetLowestBit( rest );
		highest = p->h[i] > p->h[highest] ? i : highest;
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
		rest.toeSlope = soleClampF( slope, work->angles.toesLeast, work->angles.toesMost );
	}
	soleJudge( leg, &points, &fit, -loadAhead, &rest );
	soleVec3 gradient = soleMulAdd( soleScale( fit.gu, print.forward ), fit.gv, print.side );
	rest.plane = soleMakePlane( work, soleAtHeight( work, load, fit.c ), gradient );
	const soleGroundSample* highest = soleFindHighest( &points, level );
	rest.surface = highest->surface;
	rest.velocity = highest->velocity;
	return rest;
}
