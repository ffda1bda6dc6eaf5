// SPDX-License-Identifier: MIT
// Figures of soles on the ground: how deep, how far above, how much of them, how fast they slide, how far they drift.
// World space, metres. A foot that is lifted has no penetration and one that never plants no slide: these figures mean
// something only side by side.
#include "measure/figures.h"
#include "measure/terrain.h"

#include <math.h>

#define CONTACT_BELOW ( -0.005 ) // m: gaps from here
#define CONTACT_ABOVE 0.010      // to here count as contact
#define LEAST_STANCE 0.1         // s: a stance has to last longer to have a drift
#define SWING_MARGIN 0.05        // s after lift and before strike that are not mid swing

/// Does a labelled frame speak of this point?
static bool solePointCounts( uint32_t label, bool fore )
{
	return label == sole_labelFlat || ( label == sole_labelToe && fore ) || ( label == sole_labelHeel && !fore );
}

void soleMeasureSole( soleMeasurement* m, int32_t frame, int32_t leg )
{
	const soleMeasureDef* def = m->def;
	uint32_t label = soleGetLabel( m, frame, leg );
	double deepest = 0.0;
	double least = HUGE_VAL;
	double leastLabelled = HUGE_VAL;
	int32_t labelled = 0;
	int32_t touching = 0;
	for ( int32_t i = 0; i < def->pointCount; ++i )
	{
		const soleMeasurePoint* point = def->points + i;
		if ( point->leg != leg )
		{
			continue;
		}
		soleVec3d p = soleGetCarried( &m->pose, ( soleCarriedPoint ){ point->joint, point->position } );
		double gap = soleSampleTerrain( def->terrain, p, m->reach[leg] ).gap;
		bool counts = solePointCounts( label, point->fore );
		// Over no ground at all a point touches nothing; NaN fails the comparisons and fmin passes it over.
		labelled += counts;
		touching += counts && gap >= CONTACT_BELOW && gap <= CONTACT_ABOVE;
		least = fmin( least, gap );
		leastLabelled = counts ? fmin( leastLabelled, gap ) : leastLabelled;
		// A point is no deeper than its vertical depth, so most need no search.
		if ( label != sole_labelNone && -gap > deepest )
		{
			deepest = fmax( deepest, soleFindTerrainDistance( def->terrain, p, -gap ) );
		}
	}
	soleGetLegFrame( m, frame, leg )->leastGap = least;
	if ( label == sole_labelNone || frame < def->skip )
	{
		return;
	}
	double vertical = least < 0.0 ? -least : 0.0;
	soleAddSample( m, sole_samplePenetration, leg, deepest );
	soleAddSample( m, sole_sampleVertical, leg, vertical );
	if ( leastLabelled < HUGE_VAL )
	{
		soleAddSample( m, sole_sampleHover, leg, leastLabelled > 0.0 ? leastLabelled : 0.0 );
	}
	m->sums[leg].share += labelled > 0 ? (double)touching / (double)labelled : 0.0;
	m->figures->legs[leg].labelledFrames += 1;
}

// ---------------------------------------------------------------------------------------------------------- slide

/// Speed along the ground of the lowest point that is labelled in a frame and the next.
static void soleMeasureSlide( soleMeasurement* m, int32_t leg )
{
	for ( int32_t frame = m->def->skip; frame + 1 < m->frameCount; ++frame )
	{
		uint32_t label = soleGetLabel( m, frame, leg ) & soleGetLabel( m, frame + 1, leg );
		if ( label == sole_labelNone || soleIsSmooth( m->def, frame, 1 ) == false )
		{
			continue;
		}
		const soleLegFrame* now = soleGetLegFrame( m, frame, leg );
		const soleLegFrame* next = soleGetLegFrame( m, frame + 1, leg );
		soleGroundSample heel = soleSampleTerrain( m->def->terrain, now->heel, m->reach[leg] );
		soleGroundSample ball = soleSampleTerrain( m->def->terrain, now->ball, m->reach[leg] );
		bool ballIsLower = !( heel.gap <= ball.gap );
		bool onBall = label == sole_labelToe || ( label == sole_labelFlat && ballIsLower );
		soleVec3d step = onBall ? soleSubD( next->ball, now->ball ) : soleSubD( next->heel, now->heel );
		soleVec3d along = soleRejectD( step, onBall ? ball.normal_w : heel.normal_w );
		m->sums[leg].slide += soleLengthD( along ) * m->rate;
		m->sums[leg].slidePairs += 1;
	}
}

// ---------------------------------------------------------------------------------------------------------- drift

static soleVec3d soleGetStancePoint( const soleMeasurement* m, int32_t frame, int32_t leg, uint32_t bit )
{
	const soleLegFrame* f = soleGetLegFrame( m, frame, leg );
	return bit == sole_labelHeel ? f->heel : f->ball;
}

/// Furthest horizontal way of one point from where it is in the middle of its own part of the stance [first, end).
static double soleFindDrift( const soleMeasurement* m, int32_t leg, uint32_t bit, int32_t first, int32_t end )
{
	while ( first < end && ( soleGetLabel( m, first, leg ) & bit ) == 0 )
	{
		++first;
	}
	while ( end > first && ( soleGetLabel( m, end - 1, leg ) & bit ) == 0 )
	{
		--end;
	}
	double drift = 0.0;
	for ( int32_t frame = first; frame < end; ++frame )
	{
		if ( ( soleGetLabel( m, frame, leg ) & bit ) != 0 )
		{
			soleVec3d middle = soleGetStancePoint( m, first + ( end - 1 - first ) / 2, leg, bit );
			soleVec3d way = soleSubD( soleGetStancePoint( m, frame, leg, bit ), middle );
			drift = fmax( drift, soleLengthD( soleRejectD( way, m->up ) ) );
		}
	}
	return drift;
}

static void soleMeasureStance( soleMeasurement* m, int32_t leg, int32_t first, int32_t end )
{
	if ( (double)( end - first ) > LEAST_STANCE * m->rate + 1e-3 )
	{
		double heel = soleFindDrift( m, leg, sole_labelHeel, first, end );
		double ball = soleFindDrift( m, leg, sole_labelToe, first, end );
		soleAddSample( m, sole_sampleDrift, leg, fmax( heel, ball ) );
		m->figures->legs[leg].stances += 1;
	}
}

/// The middle of a swing between two stances. Its foot lifts half a frame before first and strikes half a frame before
/// end: labels do not say it better.
static void soleMeasureSwing( soleMeasurement* m, int32_t leg, int32_t first, int32_t end )
{
	int32_t margin = (int32_t)ceil( SWING_MARGIN * m->rate - 0.5 - 1e-3 );
	double least = HUGE_VAL;
	for ( int32_t frame = first + margin; frame < end - margin; ++frame )
	{
		least = fmin( least, soleGetLegFrame( m, frame, leg )->leastGap );
	}
	if ( least < HUGE_VAL )
	{
		soleAddSample( m, sole_sampleClearance, leg, least );
		m->figures->legs[leg].swings += 1;
		m->figures->legs[leg].scuffs += least < 0.0;
	}
}

void soleMeasureSteps( soleMeasurement* m, int32_t leg )
{
	soleMeasureSlide( m, leg );
	int32_t first = m->def->skip;
	for ( int32_t frame = first + 1; frame <= m->frameCount; ++frame )
	{
		bool planted = soleGetLabel( m, frame - 1, leg ) != sole_labelNone;
		if ( frame < m->frameCount && ( soleGetLabel( m, frame, leg ) != sole_labelNone ) == planted )
		{
			continue;
		}
		if ( planted )
		{
			soleMeasureStance( m, leg, first, frame );
		}
		else if ( first > m->def->skip && frame < m->frameCount )
		{
			soleMeasureSwing( m, leg, first, frame );
		}
		first = frame;
	}
}
