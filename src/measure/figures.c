// SPDX-License-Identifier: MIT
// Quality figures of a motion over a terrain: checks what it is given, gathers the motion's points in the world, has
// the parts measured, and turns samples into statistics. Percentiles are by nearest rank, per leg and pooled over the
// legs.
#include "measure/figures.h"

#include "base/core.h"
#include "measure/stat.h"

#include <math.h>
#include <string.h>

// How far over a point its ground is looked for, as a share of leg length. Further than a foot can be inside a step,
// less than the height of a storey.
#define REACH 0.5

soleMeasureDef soleDefaultMeasureDef( void )
{
	return ( soleMeasureDef ){ .internalValue = SOLE_COOKIE };
}

// --------------------------------------------------------------------------------------------------------- checks

static soleResult soleRefuse( soleMessage* message, const char* text )
{
	soleSetMessage( message, "%s", text );
	return sole_invalidDefinition;
}

static soleResult soleCheckPoints( const soleMeasureDef* def, soleMessage* message )
{
	if ( def->points == NULL || def->pointCount < 1 )
	{
		return soleRefuse( message, "points: there are none: make them with soleMakeMeasurePoints()" );
	}
	int32_t legCount = soleRig_GetLegCount( def->motion->rig );
	int32_t jointCount = soleRig_GetJointCount( def->motion->rig );
	for ( int32_t i = 0; i < def->pointCount; ++i )
	{
		const soleMeasurePoint* p = def->points + i;
		bool good = p->leg >= 0 && p->leg < legCount && p->joint >= 0 && p->joint < jointCount;
		if ( good == false || soleVec3_IsFinite( p->position ) == false )
		{
			soleSetMessage( message, "points[%d] has leg %d of %d and joint %d of %d: use those of the motion's rig", i,
			    p->leg, legCount, p->joint, jointCount );
			return sole_invalidDefinition;
		}
	}
	return sole_success;
}

soleResult soleCheckMeasureDef( const soleMeasureDef* def, soleMessage* message )
{
	if ( def == NULL || def->internalValue != SOLE_COOKIE )
	{
		return soleRefuse( message, "the definition is not filled in: start from soleDefaultMeasureDef()" );
	}
	soleResult result = soleCheckMotion( def->motion, "motion", message );
	if ( result == sole_success && def->reference != NULL )
	{
		result = soleCheckMotion( def->reference, "reference", message );
	}
	if ( result != sole_success )
	{
		return result;
	}
	if ( def->reference != NULL &&
	    ( def->reference->frameCount != def->motion->frameCount || def->reference->rig != def->motion->rig ) )
	{
		return soleRefuse( message, "reference has other frames or another rig than motion: sample both alike" );
	}
	if ( def->labels == NULL )
	{
		return soleRefuse(
		    message, "labels are missing: make them with soleLabelContacts() from the clip on flat ground" );
	}
	if ( def->terrain == NULL )
	{
		return soleRefuse( message, "terrain is missing: make one with soleCreateTerrain()" );
	}
	if ( def->skip < 0 || def->skip >= def->motion->frameCount )
	{
		return soleRefuse( message, "skip leaves no frame of motion: give less than motion.frameCount, at least 0" );
	}
	return soleCheckPoints( def, message );
}

double soleFindReach( const soleMotion* motion, int32_t leg )
{
	double scale = fabs( (double)motion->roots[0].scale.x );
	return REACH * scale * (double)soleRig_GetLegLength( motion->rig, leg );
}

// --------------------------------------------------------------------------------------------------------- memory

static size_t soleLegFrameCount( const soleMeasurement* m )
{
	return (size_t)m->frameCount * (size_t)m->legCount;
}

static void soleFreeMeasurement( soleMeasurement* m )
{
	size_t legFrames = soleLegFrameCount( m );
	soleFreeMeasurePose( m->allocator, &m->pose );
	soleFree( m->allocator, m->frames, legFrames * sizeof *m->frames );
	soleFree( m->allocator, m->pelvis, (size_t)m->frameCount * sizeof *m->pelvis );
	soleFree( m->allocator, m->offsets, (size_t)m->frameCount * sizeof *m->offsets );
	soleFree( m->allocator, m->stretched, legFrames * sizeof *m->stretched );
	soleFree( m->allocator, m->samples, sole_sampleKindCount * legFrames * sizeof *m->samples );
	soleFree( m->allocator, m->pooled, legFrames * sizeof *m->pooled );
}

static bool soleMakeMeasurement( soleMeasurement* m )
{
	size_t legFrames = soleLegFrameCount( m );
	bool made = soleMakeMeasurePose( m->rig, m->allocator, &m->pose );
	m->frames = soleAlloc( m->allocator, legFrames * sizeof *m->frames );
	m->pelvis = soleAlloc( m->allocator, (size_t)m->frameCount * sizeof *m->pelvis );
	m->offsets = soleAlloc( m->allocator, (size_t)m->frameCount * sizeof *m->offsets );
	m->stretched = soleAlloc( m->allocator, legFrames * sizeof *m->stretched );
	m->samples = soleAlloc( m->allocator, sole_sampleKindCount * legFrames * sizeof *m->samples );
	m->pooled = soleAlloc( m->allocator, legFrames * sizeof *m->pooled );
	return made && m->frames != NULL && m->pelvis != NULL && m->offsets != NULL && m->stretched != NULL &&
	    m->samples != NULL && m->pooled != NULL;
}

// --------------------------------------------------------------------------------------------------------- gather

static soleResult soleCheckFrame( const soleMeasurement* m, const char* name, int32_t frame, soleMessage* message )
{
	for ( int32_t j = 0; j < m->jointCount; ++j )
	{
		soleQuatd q = m->pose.joints[j].rotation;
		double turn = q.x + q.y + q.z + q.w;
		if ( soleVec3d_IsFinite( m->pose.joints[j].translation ) == false || turn - turn != 0.0 )
		{
			soleSetMessage( message, "%s: joint %d is not finite in frame %d: mend poses and roots", name, j, frame );
			return sole_invalidDefinition;
		}
	}
	return sole_success;
}

/// Notes where the points of a frame are and how its soles stand.
static void soleGatherFrame( soleMeasurement* m, int32_t frame )
{
	m->pelvis[frame] = soleDotD( m->pose.joints[soleRig_GetPelvis( m->rig )].translation, m->up );
	for ( int32_t leg = 0; leg < m->legCount; ++leg )
	{
		soleLegFrame* f = soleGetLegFrame( m, frame, leg );
		f->heel = soleGetCarried( &m->pose, soleGetHeelPoint( m->rig, leg ) );
		f->ball = soleGetCarried( &m->pose, soleGetBallPoint( m->rig, leg ) );
		m->chainCounts[leg] = soleGetLegChain( &m->pose, leg, f->chain );
		soleMeasureSole( m, frame, leg );
	}
}

/// Where the evaluated pose has its pelvis, along the axes of its own root but in metres of the world.
static soleVec3d soleGetPelvisFromRoot( const soleMeasurement* m, soleTransform root )
{
	soleVec3d pelvis = m->pose.joints[soleRig_GetPelvis( m->rig )].translation;
	soleQuatd q = soleWidenQuat( root.rotation );
	q = ( soleQuatd ){ -q.x, -q.y, -q.z, q.w };
	return soleRotateD( q, soleSubD( pelvis, soleWiden( root.translation ) ) );
}

/// Notes which legs of the reference are over-extended in a frame. @return where its pelvis is
static soleVec3d soleGatherReference( soleMeasurement* m, int32_t frame )
{
	for ( int32_t leg = 0; leg < m->legCount; ++leg )
	{
		soleVec3d chain[SOLE_MAX_LEG_JOINTS + 1];
		int32_t count = soleGetLegChain( &m->pose, leg, chain );
		m->stretched[(size_t)frame * (size_t)m->legCount + (size_t)leg] = soleIsStretched( chain, count );
	}
	return soleGetPelvisFromRoot( m, m->def->reference->roots[frame] );
}

static soleResult soleGather( soleMeasurement* m, soleMessage* message )
{
	const soleMeasureDef* def = m->def;
	for ( int32_t frame = 0; frame < m->frameCount; ++frame )
	{
		soleVec3d pelvis = { 0.0, 0.0, 0.0 };
		soleResult result = sole_success;
		if ( def->reference != NULL )
		{
			soleEvaluateWorld( &m->pose, def->reference, frame );
			result = soleCheckFrame( m, "reference", frame, message );
			pelvis = soleGatherReference( m, frame );
		}
		soleEvaluateWorld( &m->pose, def->motion, frame );
		result = result == sole_success ? soleCheckFrame( m, "motion", frame, message ) : result;
		if ( result != sole_success )
		{
			return result;
		}
		soleGatherFrame( m, frame );
		if ( def->reference != NULL )
		{
			m->offsets[frame] =
			    soleLengthD( soleSubD( soleGetPelvisFromRoot( m, def->motion->roots[frame] ), pelvis ) );
		}
	}
	return sole_success;
}

// ----------------------------------------------------------------------------------------------------- statistics

/// The samples of legs [first, end) put side by side in the scratch.
static int32_t solePoolSamples( soleMeasurement* m, soleSampleKind kind, int32_t first, int32_t end )
{
	int32_t count = 0;
	for ( int32_t leg = first; leg < end; ++leg )
	{
		size_t row = (size_t)kind * (size_t)m->legCount + (size_t)leg;
		size_t legCount = (size_t)m->counts[kind][leg];
		memcpy( m->pooled + count, m->samples + row * (size_t)m->frameCount, legCount * sizeof *m->pooled );
		count += m->counts[kind][leg];
	}
	return count;
}

/// Everything that follows from samples and sums of the legs [first, end).
static void soleSummarize( soleMeasurement* m, int32_t first, int32_t end, soleLegFigures* out )
{
	out->penetration = soleFindStat( m->pooled, solePoolSamples( m, sole_samplePenetration, first, end ) );
	out->verticalPenetration = soleFindStat( m->pooled, solePoolSamples( m, sole_sampleVertical, first, end ) );
	out->hover = soleFindStat( m->pooled, solePoolSamples( m, sole_sampleHover, first, end ) );
	out->drift = soleFindStat( m->pooled, solePoolSamples( m, sole_sampleDrift, first, end ) );
	int32_t swings = solePoolSamples( m, sole_sampleClearance, first, end );
	soleFindStat( m->pooled, swings );
	out->clearance = solePercentile( m->pooled, swings, 0.05 );
	soleSums sums = { 0 };
	for ( int32_t leg = first; leg < end; ++leg )
	{
		sums.share += m->sums[leg].share;
		sums.slide += m->sums[leg].slide;
		sums.slidePairs += m->sums[leg].slidePairs;
		sums.kneeSquares += m->sums[leg].kneeSquares;
		sums.kneeCount += m->sums[leg].kneeCount;
	}
	out->contactShare = out->labelledFrames > 0 ? sums.share / (double)out->labelledFrames : 0.0;
	out->slide = sums.slidePairs > 0 ? sums.slide / (double)sums.slidePairs : 0.0;
	out->kneeAccelerationRms = sums.kneeCount > 0 ? sqrt( sums.kneeSquares / (double)sums.kneeCount ) : 0.0;
}

static void soleFinish( soleMeasurement* m )
{
	soleLegFigures* all = &m->figures->all;
	for ( int32_t leg = 0; leg < m->legCount; ++leg )
	{
		soleLegFigures* figures = &m->figures->legs[leg];
		soleSummarize( m, leg, leg + 1, figures );
		all->labelledFrames += figures->labelledFrames;
		all->stances += figures->stances;
		all->overExtended += figures->overExtended;
		all->swings += figures->swings;
		all->scuffs += figures->scuffs;
		all->kneeAccelerationMax = fmax( all->kneeAccelerationMax, figures->kneeAccelerationMax );
		all->largestJump = fmax( all->largestJump, figures->largestJump );
	}
	soleSummarize( m, 0, m->legCount, all );
}

soleResult soleMeasureMotion(
    const soleMeasureDef* def, const soleAllocator* allocator, soleFigures* figures, soleMessage* message )
{
	SOLE_ASSERT( figures != NULL && "figures: give the address of a struct" );
	if ( figures == NULL )
	{
		return sole_invalidDefinition;
	}
	*figures = ( soleFigures ){ 0 };
	soleResult result = soleCheckMeasureDef( def, message );
	if ( result != sole_success )
	{
		return result;
	}
	soleMeasurement m = {
		.def = def,
		.allocator = allocator,
		.rig = def->motion->rig,
		.frameCount = def->motion->frameCount,
		.legCount = soleRig_GetLegCount( def->motion->rig ),
		.jointCount = soleRig_GetJointCount( def->motion->rig ),
		.rate = (double)def->motion->frameRate,
		.up = soleUnitD( soleWiden( def->motion->up ), ( soleVec3d ){ 0.0, 1.0, 0.0 } ),
		.figures = figures,
	};
	figures->legCount = m.legCount;
	for ( int32_t leg = 0; leg < m.legCount; ++leg )
	{
		m.reach[leg] = soleFindReach( def->motion, leg );
	}
	if ( soleMakeMeasurement( &m ) == false )
	{
		soleSetMessage( message, "out of memory for %d frames", m.frameCount );
		result = sole_outOfMemory;
	}
	result = result == sole_success ? soleGather( &m, message ) : result;
	for ( int32_t leg = 0; leg < m.legCount && result == sole_success; ++leg )
	{
		soleMeasureSteps( &m, leg );
		soleMeasureLeg( &m, leg );
	}
	if ( result == sole_success )
	{
		soleMeasureBody( &m );
		soleFinish( &m );
	}
	else
	{
		*figures = ( soleFigures ){ 0 };
	}
	soleFreeMeasurement( &m );
	return result;
}
