// SPDX-License-Identifier: MIT
// Figures of legs and body: how the knees turn, whether legs are over-extended, how far joints jump in a frame, how
// smoothly the pelvis rides, how far the motion is from its reference. Angles from positions in double precision:
// th = atan2( |a x b|, a . b ) of the bones above and below a joint.
#include "measure/figures.h"

#include <math.h>

#define STRETCHED 0.999 // of the bones' length: about 5 degrees of flexion

bool soleIsStretched( const soleVec3d* chain, int32_t count )
{
	double bones = 0.0;
	for ( int32_t k = 1; k < count; ++k )
	{
		bones += soleLengthD( soleSubD( chain[k], chain[k - 1] ) );
	}
	// A leg of one bone is always straight.
	return count > 2 && soleLengthD( soleSubD( chain[count - 1], chain[0] ) ) > STRETCHED * bones;
}

static double soleBendAngle( const soleVec3d* joint )
{
	soleVec3d above = soleSubD( joint[0], joint[-1] );
	soleVec3d below = soleSubD( joint[1], joint[0] );
	return atan2( soleLengthD( soleCrossD( above, below ) ), soleDotD( above, below ) );
}

/// Second differences of the angles of all joints between hip and ankle: of the knee, where a leg has but one.
static void soleMeasureKnees( soleMeasurement* m, int32_t leg )
{
	for ( int32_t k = 1; k + 1 < m->chainCounts[leg]; ++k )
	{
		for ( int32_t frame = m->def->skip + 1; frame + 1 < m->frameCount; ++frame )
		{
			if ( soleIsSmooth( m->def, frame - 1, 2 ) == false )
			{
				continue;
			}
			double before = soleBendAngle( soleGetLegFrame( m, frame - 1, leg )->chain + k );
			double now = soleBendAngle( soleGetLegFrame( m, frame, leg )->chain + k );
			double after = soleBendAngle( soleGetLegFrame( m, frame + 1, leg )->chain + k );
			double acceleration = ( after - 2.0 * now + before ) * m->rate * m->rate;
			m->sums[leg].kneeSquares += acceleration * acceleration;
			m->sums[leg].kneeCount += 1;
			soleLegFigures* figures = &m->figures->legs[leg];
			figures->kneeAccelerationMax = fmax( figures->kneeAccelerationMax, fabs( acceleration ) );
		}
	}
}

/// Joints that placing a foot may turn: the leg's, a detached foot, the toes.
static int32_t soleListLegJoints(
    const soleRig* rig, int32_t leg, int32_t joints[SOLE_MAX_LEG_JOINTS + SOLE_MAX_TOE_JOINTS + 1] )
{
	soleLegDef def = soleRig_GetLeg( rig, leg );
	int32_t count = 0;
	for ( int32_t k = 0; k < def.jointCount; ++k )
	{
		joints[count++] = def.joints[k];
	}
	if ( def.detachedFoot != SOLE_NONE )
	{
		joints[count++] = def.detachedFoot;
	}
	for ( int32_t k = 0; k < def.toeCount; ++k )
	{
		joints[count++] = def.toes[k];
	}
	return count;
}

static soleQuat soleLocalRotation( const soleMotion* motion, int32_t jointCount, int32_t frame, int32_t joint )
{
	return motion->poses[(size_t)frame * (size_t)jointCount + (size_t)joint].rotation;
}

void soleMeasureLeg( soleMeasurement* m, int32_t leg )
{
	const soleMeasureDef* def = m->def;
	soleLegFigures* figures = &m->figures->legs[leg];
	soleMeasureKnees( m, leg );
	int32_t joints[SOLE_MAX_LEG_JOINTS + SOLE_MAX_TOE_JOINTS + 1];
	int32_t count = soleListLegJoints( m->rig, leg, joints );
	for ( int32_t frame = def->skip; frame < m->frameCount; ++frame )
	{
		bool stretched = soleIsStretched( soleGetLegFrame( m, frame, leg )->chain, m->chainCounts[leg] );
		bool allowed = m->stretched[(size_t)frame * (size_t)m->legCount + (size_t)leg] != 0;
		figures->overExtended += stretched && allowed == false;
		bool follows = frame > def->skip && soleIsSmooth( m->def, frame - 1, 1 );
		for ( int32_t k = 0; k < count && follows; ++k )
		{
			soleQuat before = soleLocalRotation( def->motion, m->jointCount, frame - 1, joints[k] );
			soleQuat now = soleLocalRotation( def->motion, m->jointCount, frame, joints[k] );
			figures->largestJump = fmax( figures->largestJump, soleAngleBetween( before, now ) );
		}
	}
}

static void soleMeasurePelvis( soleMeasurement* m )
{
	double squares = 0.0;
	int32_t count = 0;
	for ( int32_t frame = m->def->skip; frame + 1 < m->frameCount; ++frame )
	{
		const double* h = m->pelvis + frame;
		if ( soleIsSmooth( m->def, frame, 1 ) )
		{
			m->figures->pelvisLargestStep = fmax( m->figures->pelvisLargestStep, fabs( h[1] - h[0] ) );
		}
		if ( frame + 3 < m->frameCount && soleIsSmooth( m->def, frame, 3 ) )
		{
			double jerk = ( h[3] - 3.0 * h[2] + 3.0 * h[1] - h[0] ) * m->rate * m->rate * m->rate;
			squares += jerk * jerk;
			count += 1;
		}
	}
	m->figures->pelvisJerk = count > 0 ? sqrt( squares / (double)count ) : 0.0;
}

static void soleMeasureOffset( soleMeasurement* m )
{
	double squares = 0.0;
	for ( int32_t frame = m->def->skip; frame < m->frameCount; ++frame )
	{
		double offset = m->offsets[frame];
		squares += offset * offset;
		m->figures->pelvisOffsetMax = fmax( m->figures->pelvisOffsetMax, offset );
	}
	m->figures->pelvisOffsetRms = sqrt( squares / (double)( m->frameCount - m->def->skip ) );
}

static void soleMeasureDeviation( soleMeasurement* m )
{
	const soleMeasureDef* def = m->def;
	double squares = 0.0;
	int32_t count = 0;
	for ( int32_t leg = 0; leg < m->legCount && def->reference != NULL; ++leg )
	{
		int32_t joints[SOLE_MAX_LEG_JOINTS + SOLE_MAX_TOE_JOINTS + 1];
		int32_t jointCount = soleListLegJoints( m->rig, leg, joints );
		for ( int32_t frame = def->skip; frame < m->frameCount; ++frame )
		{
			for ( int32_t k = 0; k < jointCount; ++k )
			{
				soleQuat is = soleLocalRotation( def->motion, m->jointCount, frame, joints[k] );
				soleQuat was = soleLocalRotation( def->reference, m->jointCount, frame, joints[k] );
				double angle = soleAngleBetween( was, is );
				squares += angle * angle;
				count += 1;
			}
		}
	}
	m->figures->deviation = count > 0 ? sqrt( squares / (double)count ) : 0.0;
}

void soleMeasureBody( soleMeasurement* m )
{
	soleMeasurePelvis( m );
	soleMeasureOffset( m );
	soleMeasureDeviation( m );
}
