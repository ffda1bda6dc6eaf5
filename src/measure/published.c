// SPDX-License-Identifier: MIT
// Figures as others have published them, sources in the header. World space, metres, double precision. Feet and pelvis
// are gathered once, frame by frame; figures of a fixed rate are taken from their places in between, on straight lines.
#include "base/core.h"
#include "measure/figures.h"
#include "measure/terrain.h"

#include <math.h>

#define MANN_HEIGHT 0.025
#define MVAE_HEIGHT 0.033
#define NEAR_GROUND 0.05 // m: lower than this a toe counts as on the ground
#define SKATING_RATE 20.0
#define SKATING_SPEED 0.5
#define SKATING_WINDOW 2 // steps before and after
#define KIMODO_SPEED 0.2
#define PHYS_TOLERANCE 0.005
#define SCORE_RATE 30.0
#define SCORE_FACTOR 1e4

/// A foot in a frame.
typedef struct solePublishedFoot
{
	soleVec3d ankle;
	soleVec3d heel;
	soleVec3d ball;
	double height; // of the ball over the ground; HUGE_VAL where there is none
} solePublishedFoot;

/// The lowest sole point of a frame, of all legs.
typedef struct solePublishedLow
{
	int32_t point;
	double gap;     // HUGE_VAL where there is no ground
	double nextGap; // of the same point a frame later
	double step;    // its horizontal way until then
} solePublishedLow;

typedef struct solePublished
{
	const soleMeasureDef* def;
	const soleRig* rig;
	int32_t frameCount;
	int32_t legCount;
	double rate;
	soleVec3d up;
	double reach[SOLE_MAX_LEGS];
	soleMeasurePose pose;
	solePublishedFoot* feet; // frame, leg
	solePublishedLow* lows;  // a frame each
	soleVec3d* pelvis;       // likewise
	solePublishedFigures* figures;
} solePublished;

// --------------------------------------------------------------------------------------------------------- gather

static double soleHeightOver( const solePublished* m, soleVec3d p, int32_t leg )
{
	double gap = soleSampleTerrain( m->def->terrain, p, m->reach[leg] ).gap;
	return isnan( gap ) ? HUGE_VAL : gap;
}

static double soleWayAcross( const solePublished* m, soleVec3d from, soleVec3d to )
{
	return soleLengthD( soleRejectD( soleSubD( to, from ), m->up ) );
}

static soleVec3d soleGetSolePoint( const solePublished* m, int32_t point )
{
	const soleMeasurePoint* p = m->def->points + point;
	return soleGetCarried( &m->pose, ( soleCarriedPoint ){ p->joint, p->position } );
}

static void soleGatherFeet( solePublished* m, int32_t frame )
{
	for ( int32_t leg = 0; leg < m->legCount; ++leg )
	{
		solePublishedFoot* foot = m->feet + (size_t)frame * (size_t)m->legCount + (size_t)leg;
		soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1];
		int32_t count = soleGetLegChain( &m->pose, leg, chain );
		foot->ankle = chain[count - 1];
		foot->heel = soleGetCarried( &m->pose, soleGetHeelPoint( m->rig, leg ) );
		foot->ball = soleGetCarried( &m->pose, soleGetBallPoint( m->rig, leg ) );
		foot->height = soleHeightOver( m, foot->ball, leg );
	}
}

static solePublishedLow soleFindLow( const solePublished* m )
{
	solePublishedLow low = { 0, HUGE_VAL, HUGE_VAL, 0.0 };
	for ( int32_t i = 0; i < m->def->pointCount; ++i )
	{
		double gap = soleHeightOver( m, soleGetSolePoint( m, i ), m->def->points[i].leg );
		if ( gap < low.gap )
		{
			low.gap = gap;
			low.point = i;
		}
	}
	return low;
}

/// @return false where a joint is not finite.
static bool soleGatherPublished( solePublished* m )
{
	soleVec3d lowest = { 0.0, 0.0, 0.0 };
	for ( int32_t frame = 0; frame < m->frameCount; ++frame )
	{
		soleEvaluateWorld( &m->pose, m->def->motion, frame );
		m->pelvis[frame] = m->pose.joints[soleRig_GetPelvis( m->rig )].translation;
		bool finite = soleVec3d_IsFinite( m->pelvis[frame] );
		soleGatherFeet( m, frame );
		for ( int32_t leg = 0; leg < m->legCount; ++leg )
		{
			const solePublishedFoot* foot = m->feet + (size_t)frame * (size_t)m->legCount + (size_t)leg;
			finite = finite && soleVec3d_IsFinite( soleAddD( foot->ankle, soleAddD( foot->heel, foot->ball ) ) );
		}
		if ( finite == false )
		{
			return false;
		}
		if ( frame > 0 )
		{
			solePublishedLow* before = m->lows + frame - 1;
			soleVec3d now = soleGetSolePoint( m, before->point );
			before->nextGap = soleHeightOver( m, now, m->def->points[before->point].leg );
			before->step = soleWayAcross( m, lowest, now );
		}
		m->lows[frame] = soleFindLow( m );
		lowest = soleGetSolePoint( m, m->lows[frame].point );
	}
	return true;
}

// ----------------------------------------------------------------------------------------------- at the own rate

static const solePublishedFoot* soleGetFoot( const solePublished* m, int32_t frame, int32_t leg )
{
	return m->feet + (size_t)frame * (size_t)m->legCount + (size_t)leg;
}

/// Mean step of the toes, weighted by their height.
static double soleFindWeightedStep( const solePublished* m, double height )
{
	double sum = 0.0;
	int32_t count = 0;
	for ( int32_t frame = m->def->skip; frame + 1 < m->frameCount; ++frame )
	{
		for ( int32_t leg = 0; leg < m->legCount && soleIsSmooth( m->def, frame, 1 ); ++leg )
		{
			const solePublishedFoot* now = soleGetFoot( m, frame, leg );
			const solePublishedFoot* next = soleGetFoot( m, frame + 1, leg );
			double share = fmin( fmax( fmax( now->height, next->height ) / height, 0.0 ), 1.0 );
			sum += soleWayAcross( m, now->ball, next->ball ) * ( 2.0 - exp2( share ) );
			count += 1;
		}
	}
	return count > 0 ? sum / (double)count : 0.0;
}

/// A mean in the making.
typedef struct soleMean
{
	double sum;
	double max;
	int32_t count;
} soleMean;

static void soleAddToMean( soleMean* mean, double value )
{
	mean->sum += value;
	mean->max = fmax( mean->max, value );
	mean->count += 1;
}

static double soleGetMean( const soleMean* mean )
{
	return mean->count > 0 ? mean->sum / (double)mean->count : 0.0;
}

static void soleMeasureKimodo( solePublished* m )
{
	soleMean fast = { 0 };
	soleMean low = { 0 };
	soleMean contact = { 0 };
	for ( int32_t frame = m->def->skip; frame + 1 < m->frameCount; ++frame )
	{
		for ( int32_t leg = 0; leg < m->legCount && soleIsSmooth( m->def, frame, 1 ); ++leg )
		{
			const solePublishedFoot* now = soleGetFoot( m, frame, leg );
			const solePublishedFoot* next = soleGetFoot( m, frame + 1, leg );
			double ball = soleLengthD( soleSubD( next->ball, now->ball ) ) * m->rate;
			double heel = soleLengthD( soleSubD( next->heel, now->heel ) ) * m->rate;
			uint32_t label = m->def->labels[(size_t)frame * (size_t)m->legCount + (size_t)leg];
			if ( now->height < NEAR_GROUND )
			{
				soleAddToMean( &low, ball );
			}
			if ( now->height < NEAR_GROUND && next->height < NEAR_GROUND )
			{
				soleAddToMean( &fast, ball > KIMODO_SPEED ? 1.0 : 0.0 );
			}
			if ( ( label & sole_labelToe ) != 0 )
			{
				soleAddToMean( &contact, ball );
			}
			if ( ( label & sole_labelHeel ) != 0 )
			{
				soleAddToMean( &contact, heel );
			}
		}
	}
	m->figures->kimodoRatio = soleGetMean( &fast );
	m->figures->kimodoHeightSpeed = soleGetMean( &low );
	m->figures->kimodoContactSpeed = soleGetMean( &contact );
	m->figures->kimodoContactMax = contact.max;
}

/// Frames over no ground at all count for nothing.
static void soleMeasurePhys( solePublished* m )
{
	soleMean under = { 0 };
	soleMean above = { 0 };
	soleMean skate = { 0 };
	for ( int32_t frame = m->def->skip; frame < m->frameCount; ++frame )
	{
		const solePublishedLow* low = m->lows + frame;
		if ( low->gap < HUGE_VAL )
		{
			soleAddToMean( &under, fmax( 0.0, -( low->gap + PHYS_TOLERANCE ) ) );
			soleAddToMean( &above, fmax( 0.0, low->gap - PHYS_TOLERANCE ) );
		}
		if ( frame + 1 < m->frameCount && soleIsSmooth( m->def, frame, 1 ) )
		{
			bool stays = low->gap <= PHYS_TOLERANCE && low->nextGap <= PHYS_TOLERANCE;
			soleAddToMean( &skate, stays ? low->step : 0.0 );
		}
	}
	m->figures->physPenetration = soleGetMean( &under );
	m->figures->physFloat = soleGetMean( &above );
	m->figures->physSkate = soleGetMean( &skate );
	m->figures->physError = m->figures->physPenetration + m->figures->physFloat + m->figures->physSkate;
}

// ---------------------------------------------------------------------------------------------- at a fixed rate

/// Samples of a motion at another rate.
typedef struct soleResampling
{
	double step;   // frames of the motion a sample
	int32_t first; // sample that is not before skip
	int32_t end;
} soleResampling;

static soleResampling soleResample( const solePublished* m, double rate )
{
	double step = m->rate / rate;
	return ( soleResampling ){ .step = step,
		.first = (int32_t)ceil( (double)m->def->skip / step - 1e-6 ),
		.end = (int32_t)floor( (double)( m->frameCount - 1 ) / step + 1e-6 ) + 1 };
}

/// A sample between two frames.
typedef struct soleBetween
{
	int32_t frame;
	int32_t next;
	double share; // of the way from frame to next
} soleBetween;

static soleBetween soleFindBetween( const solePublished* m, const soleResampling* r, int32_t sample )
{
	double place = (double)sample * r->step;
	int32_t last = m->frameCount - 1;
	int32_t frame = (int32_t)floor( place + 1e-6 );
	frame = frame < last ? frame : last;
	return ( soleBetween ){ frame, frame < last ? frame + 1 : last, fmax( place - (double)frame, 0.0 ) };
}

static soleVec3d soleMix( soleVec3d a, soleVec3d b, double share )
{
	return soleAddD( a, soleScaleD( share, soleSubD( b, a ) ) );
}

static soleVec3d soleSampleBall( const solePublished* m, const soleResampling* r, int32_t sample, int32_t leg )
{
	soleBetween at = soleFindBetween( m, r, sample );
	return soleMix( soleGetFoot( m, at.frame, leg )->ball, soleGetFoot( m, at.next, leg )->ball, at.share );
}

static soleVec3d soleSampleAnkle( const solePublished* m, const soleResampling* r, int32_t sample, int32_t leg )
{
	soleBetween at = soleFindBetween( m, r, sample );
	return soleMix( soleGetFoot( m, at.frame, leg )->ankle, soleGetFoot( m, at.next, leg )->ankle, at.share );
}

static soleVec3d soleSamplePelvis( const solePublished* m, const soleResampling* r, int32_t sample )
{
	soleBetween at = soleFindBetween( m, r, sample );
	return soleMix( m->pelvis[at.frame], m->pelvis[at.next], at.share );
}

/// Does the motion go on over some samples, with the frames that they are made from?
static bool soleIsSmoothOver( const solePublished* m, const soleResampling* r, int32_t sample, int32_t steps )
{
	int32_t first = soleFindBetween( m, r, sample ).frame;
	return soleIsSmooth( m->def, first, soleFindBetween( m, r, sample + steps ).next - first );
}

/// Horizontal speed of a toe from a sample to the next; 0 beyond the ends and across seams.
static double soleToeSpeed( const solePublished* m, const soleResampling* r, int32_t sample, int32_t leg )
{
	if ( sample < r->first || sample + 1 >= r->end || soleIsSmoothOver( m, r, sample, 1 ) == false )
	{
		return 0.0;
	}
	soleVec3d now = soleSampleBall( m, r, sample, leg );
	return soleWayAcross( m, now, soleSampleBall( m, r, sample + 1, leg ) ) * SKATING_RATE;
}

static bool soleSkates( const solePublished* m, const soleResampling* r, int32_t sample, int32_t leg )
{
	double sum = 0.0;
	for ( int32_t k = -SKATING_WINDOW; k <= SKATING_WINDOW; ++k )
	{
		sum += soleToeSpeed( m, r, sample + k, leg );
	}
	double now = soleHeightOver( m, soleSampleBall( m, r, sample, leg ), leg );
	double next = soleHeightOver( m, soleSampleBall( m, r, sample + 1, leg ), leg );
	return soleToeSpeed( m, r, sample, leg ) > SKATING_SPEED &&
	    sum > (double)( 2 * SKATING_WINDOW + 1 ) * SKATING_SPEED && now < NEAR_GROUND && next < NEAR_GROUND;
}

static double soleFindSkatingRatio( const solePublished* m )
{
	soleResampling r = soleResample( m, SKATING_RATE );
	soleMean skating = { 0 };
	for ( int32_t sample = r.first; sample + 1 < r.end; ++sample )
	{
		bool any = false;
		for ( int32_t leg = 0; leg < m->legCount && any == false; ++leg )
		{
			any = soleSkates( m, &r, sample, leg );
		}
		soleAddToMean( &skating, any ? 1.0 : 0.0 );
	}
	return soleGetMean( &skating );
}

/// Length of the pelvis's acceleration around the sample after this one, without its part downwards.
static double soleFindAcceleration( const solePublished* m, const soleResampling* r, int32_t sample )
{
	soleVec3d ends = soleAddD( soleSamplePelvis( m, r, sample ), soleSamplePelvis( m, r, sample + 2 ) );
	soleVec3d a = soleSubD( ends, soleScaleD( 2.0, soleSamplePelvis( m, r, sample + 1 ) ) );
	double rise = soleDotD( a, m->up );
	return soleLengthD( rise < 0.0 ? soleRejectD( a, m->up ) : a ) * SCORE_RATE * SCORE_RATE;
}

/// Least step of the ankles and toes of a side; HUGE_VAL where it has no leg.
static double soleFindLeastStep( const solePublished* m, const soleResampling* r, int32_t sample, soleSide side )
{
	double least = HUGE_VAL;
	for ( int32_t leg = 0; leg < m->legCount; ++leg )
	{
		if ( soleRig_GetLeg( m->rig, leg ).side == side )
		{
			soleVec3d ankle = soleSampleAnkle( m, r, sample, leg );
			soleVec3d ball = soleSampleBall( m, r, sample, leg );
			least = fmin( least, soleWayAcross( m, ankle, soleSampleAnkle( m, r, sample + 1, leg ) ) );
			least = fmin( least, soleWayAcross( m, ball, soleSampleBall( m, r, sample + 1, leg ) ) );
		}
	}
	return least;
}

static double soleFindScore( const solePublished* m )
{
	soleResampling r = soleResample( m, SCORE_RATE );
	soleMean product = { 0 };
	double most = 0.0;
	for ( int32_t sample = r.first; sample + 2 < r.end; ++sample )
	{
		if ( soleIsSmoothOver( m, &r, sample, 2 ) )
		{
			double acceleration = soleFindAcceleration( m, &r, sample );
			double left = soleFindLeastStep( m, &r, sample + 1, sole_left );
			double right = soleFindLeastStep( m, &r, sample + 1, sole_right );
			most = fmax( most, acceleration );
			soleAddToMean( &product, acceleration * left * right );
		}
	}
	double score = most > 0.0 ? SCORE_FACTOR * soleGetMean( &product ) / most : 0.0;
	return score < HUGE_VAL ? score : (double)NAN;
}

// -------------------------------------------------------------------------------------------------------- measure

static bool soleMakePublished( solePublished* m, const soleAllocator* allocator )
{
	size_t frames = (size_t)m->frameCount;
	bool made = soleMakeMeasurePose( m->rig, allocator, &m->pose );
	m->feet = soleAlloc( allocator, frames * (size_t)m->legCount * sizeof *m->feet );
	m->lows = soleAlloc( allocator, frames * sizeof *m->lows );
	m->pelvis = soleAlloc( allocator, frames * sizeof *m->pelvis );
	return made && m->feet != NULL && m->lows != NULL && m->pelvis != NULL;
}

static void soleFreePublished( solePublished* m, const soleAllocator* allocator )
{
	size_t frames = (size_t)m->frameCount;
	soleFreeMeasurePose( allocator, &m->pose );
	soleFree( allocator, m->feet, frames * (size_t)m->legCount * sizeof *m->feet );
	soleFree( allocator, m->lows, frames * sizeof *m->lows );
	soleFree( allocator, m->pelvis, frames * sizeof *m->pelvis );
}

static void soleMeasureAllPublished( solePublished* m )
{
	solePublishedFigures* figures = m->figures;
	figures->mannStep = soleFindWeightedStep( m, MANN_HEIGHT );
	figures->mannSpeed = figures->mannStep * m->rate;
	figures->mvaeStep = soleFindWeightedStep( m, MVAE_HEIGHT );
	figures->mvaeSpeed = figures->mvaeStep * m->rate;
	figures->skatingRatio = soleFindSkatingRatio( m );
	soleMeasureKimodo( m );
	soleMeasurePhys( m );
	figures->footContactScore = soleFindScore( m );
}

soleResult soleMeasurePublished(
    const soleMeasureDef* def, const soleAllocator* allocator, solePublishedFigures* figures, soleMessage* message )
{
	SOLE_ASSERT( figures != NULL && "figures: give the address of a struct" );
	if ( figures == NULL )
	{
		return sole_invalidDefinition;
	}
	*figures = ( solePublishedFigures ){ 0 };
	soleResult result = soleCheckMeasureDef( def, message );
	if ( result != sole_success )
	{
		return result;
	}
	solePublished m = {
		.def = def,
		.rig = def->motion->rig,
		.frameCount = def->motion->frameCount,
		.legCount = soleRig_GetLegCount( def->motion->rig ),
		.rate = (double)def->motion->frameRate,
		.up = soleUnitD( soleWiden( def->motion->up ), ( soleVec3d ){ 0.0, 1.0, 0.0 } ),
		.figures = figures,
	};
	for ( int32_t leg = 0; leg < m.legCount; ++leg )
	{
		m.reach[leg] = soleFindReach( def->motion, leg );
	}
	if ( soleMakePublished( &m, allocator ) == false )
	{
		soleSetMessage( message, "out of memory for %d frames", m.frameCount );
		result = sole_outOfMemory;
	}
	else if ( soleGatherPublished( &m ) == false )
	{
		soleSetMessage( message, "motion is not finite: mend poses and roots" );
		result = sole_invalidDefinition;
	}
	else
	{
		soleMeasureAllPublished( &m );
	}
	soleFreePublished( &m, allocator );
	return result;
}
