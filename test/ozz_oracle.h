// SPDX-License-Identifier: MIT
// The two jobs of ozz-animation and its foot IK sample in double, as one would write them down: angles by arc cosine,
// turns about axes, poses joint by joint. For comparing with; any one space. World: y up.
#ifndef TEST_OZZ_ORACLE_H
#define TEST_OZZ_ORACLE_H

#include "ground_support.h"

#include "baselines/ozz.h"
#include "baselines/ozz_jobs.h"

typedef struct testTurnD
{
	testPoint v;
	double w;
} testTurnD;

static inline double testLengthD( testPoint a )
{
	return sqrt( testDot( a, a ) );
}

static inline testPoint testScaled( double s, testPoint a )
{
	return ( testPoint ){ s * a.x, s * a.y, s * a.z };
}

static inline testPoint testUnit( testPoint a )
{
	return testScaled( 1.0 / testLengthD( a ), a );
}

static inline testTurnD testAbout( testPoint axis, double angle )
{
	return ( testTurnD ){ testScaled( sin( 0.5 * angle ) / testLengthD( axis ), axis ), cos( 0.5 * angle ) };
}

/// First b, then a.
static inline testTurnD testAfter( testTurnD a, testTurnD b )
{
	testPoint v = testAlong( testScaled( a.w, b.v ), b.w, a.v );
	return ( testTurnD ){ testAlong( v, 1.0, testCross( a.v, b.v ) ), a.w * b.w - testDot( a.v, b.v ) };
}

static inline testTurnD testWideTurn( soleQuat q )
{
	double size = sqrt(
	    (double)q.x * (double)q.x + (double)q.y * (double)q.y + (double)q.z * (double)q.z + (double)q.w * (double)q.w );
	testPoint v = { (double)q.x, (double)q.y, (double)q.z };
	return ( testTurnD ){ testScaled( 1.0 / size, v ), (double)q.w / size };
}

static inline testPoint testTurned( testTurnD q, testPoint p )
{
	testTurnD point = { p, 0.0 };
	testTurnD back = { testScaled( -1.0, q.v ), q.w };
	return testAfter( testAfter( q, point ), back ).v;
}

/// The mean of no turn and this one.
static inline testTurnD testWeighed( testTurnD q, double weight )
{
	double sign = q.w < 0.0 ? -1.0 : 1.0;
	testTurnD r = { testScaled( sign * weight, q.v ), 1.0 - weight + sign * weight * q.w };
	double size = sqrt( testDot( r.v, r.v ) + r.w * r.w );
	return ( testTurnD ){ testScaled( 1.0 / size, r.v ), r.w / size };
}

static inline double testArc( double cosine )
{
	return acos( fmin( fmax( cosine, -1.0 ), 1.0 ) );
}

/// The shortest turn from a to b.
static inline testTurnD testShortest( testPoint a, testPoint b )
{
	testPoint axis = testCross( a, b );
	double sine = testLengthD( axis );
	return sine > 1e-14 ? testAbout( axis, atan2( sine, testDot( a, b ) ) ) : ( testTurnD ){ { 0, 0, 0 }, 1.0 };
}

typedef struct testTwoBoneD
{
	testPoint start, mid, end, target, midAxis, pole;
	double twist, soften, weight;
} testTwoBoneD;

typedef struct testBentD
{
	testTurnD start, mid;
	testPoint end;
} testBentD;

static inline double testSoftenedD( double length, double from, double chain )
{
	double zone = chain - from;
	return length > from && zone > 0.0 ? from + zone * ( 1.0 - pow( 3.0 / ( 3.0 + ( length - from ) / zone ), 4.0 ) )
	                                   : length;
}

static inline testBentD testTwoBoneInDouble( const testTwoBoneD* job )
{
	testPoint k = testMinus( job->mid, job->start );
	testPoint s = testMinus( job->end, job->mid );
	testPoint t = testMinus( job->target, job->start );
	double a = testLengthD( k ), b = testLengthD( s );
	double length = testSoftenedD( testLengthD( t ), job->soften * ( a + b ), a + b );
	double wanted = testArc( ( a * a + b * b - length * length ) / ( 2.0 * a * b ) );
	double now = testArc( -testDot( k, s ) / ( a * b ) );
	now = testDot( testCross( k, job->midAxis ), s ) < 0.0 ? -now : now;
	testTurnD mid = testAbout( job->midAxis, wanted - now );

	testTurnD start = testShortest( testAlong( k, 1.0, testTurned( mid, s ) ), t );
	testPoint normal = testTurned( start, testUnit( job->midAxis ) );
	testPoint reference = testUnit( testCross( t, job->pole ) );
	double plane = testArc( testDot( normal, reference ) );
	plane = testDot( normal, job->pole ) < 0.0 ? -plane : plane;
	start = testAfter( testAbout( t, plane + job->twist ), start );
	testBentD bent = { testWeighed( start, job->weight ), testWeighed( mid, job->weight ), { 0, 0, 0 } };
	testPoint chain = testAlong( k, 1.0, testTurned( bent.mid, s ) );
	bent.end = testAlong( job->start, 1.0, testTurned( bent.start, chain ) );
	return bent;
}

typedef struct testAimD
{
	testPoint joint, target, forward, up, offset, pole;
	double twist, weight;
} testAimD;

static inline testTurnD testAimInDouble( const testAimD* job )
{
	testPoint t = testMinus( job->target, job->joint );
	// The point offset + x forward that is as far as the target: x^2 + 2 x (offset.forward) + offset^2 = t^2.
	double p = testDot( job->offset, job->forward );
	double x = -p + sqrt( p * p - testDot( job->offset, job->offset ) + testDot( t, t ) );
	testTurnD turn = testShortest( testAlong( job->offset, x, job->forward ), t );
	testPoint up = testTurned( turn, job->up );
	testPoint now = testUnit( testAlong( up, -testDot( up, t ) / testDot( t, t ), t ) );
	testPoint wanted = testUnit( testAlong( job->pole, -testDot( job->pole, t ) / testDot( t, t ), t ) );
	double angle = atan2( testDot( testUnit( t ), testCross( now, wanted ) ), testDot( now, wanted ) );
	return testWeighed( testAfter( testAbout( t, angle + job->twist ), turn ), job->weight );
}

// ------------------------------------------------------------------------------------------------------ the sample

/// Where a joint is; its scale is uniform.
typedef struct testPlaceD
{
	testPoint point;
	testTurnD turn;
	double scale;
} testPlaceD;

static inline testPlaceD testPlaceInDouble( soleTransform t )
{
	return ( testPlaceD ){ testWide( t.translation ), testWideTurn( t.rotation ), (double)t.scale.x };
}

static inline testPlaceD testJointInDouble(
    const int32_t* parents, const soleTransform* pose, soleTransform root, int32_t joint )
{
	testPlaceD place = testPlaceInDouble( pose[joint] );
	for ( int32_t j = joint; j != SOLE_NONE; j = parents[j] )
	{
		int32_t above = parents[j];
		testPlaceD parent = testPlaceInDouble( above != SOLE_NONE ? pose[above] : root );
		place.point = testAlong( parent.point, parent.scale, testTurned( parent.turn, place.point ) );
		place.turn = testAfter( parent.turn, place.turn );
		place.scale *= parent.scale;
	}
	return place;
}

/// A frame of a rig whose two legs have three joints each, and what was met: at the root, then under each leg. All hit.
typedef struct testSampleD
{
	const int32_t* parents;
	const soleRigDef* def;
	const soleTransform* pose;
	soleTransform root;
	const soleOzzSettings* settings;
	const soleHit* hits;
	// What comes of it.
	testPoint shift;
	testPoint targets[2];
	testPoint ankles[2];
	testTurnD feet[2];
} testSampleD;

static inline testPlaceD testLegJointD( const testSampleD* sample, int32_t leg, int32_t index )
{
	testPlaceD place =
	    testJointInDouble( sample->parents, sample->pose, sample->root, sample->def->legs[leg].joints[index] );
	place.point = testAlong( place.point, 1.0, sample->shift );
	return place;
}

static inline void testSampleLegD( testSampleD* sample, int32_t leg )
{
	const soleOzzLegAxes* axes = sample->settings->axes + leg;
	testPlaceD knee = testLegJointD( sample, leg, 1 );
	testPlaceD ankle = testLegJointD( sample, leg, 2 );
	testTwoBoneD bend = { testLegJointD( sample, leg, 0 ).point, knee.point, ankle.point, sample->targets[leg],
		testTurned( knee.turn, testWide( axes->kneeMidAxis ) ), testTurned( knee.turn, testWide( axes->kneePole ) ),
		0.0, (double)sample->settings->soften, (double)sample->settings->weight };
	testBentD bent = testTwoBoneInDouble( &bend );
	testTurnD foot = testAfter( testAfter( bent.start, bent.mid ), ankle.turn );
	testPoint up = testTurned( foot, testWide( axes->ankleUp ) );
	testPoint forward = testTurned( foot, testWide( axes->ankleForward ) );
	double height = (double)( sample->settings->aimHeight * sample->root.scale.x );
	testAimD aim = { bent.end, testAlong( sample->targets[leg], height, testWide( sample->hits[1 + leg].normal_w ) ),
		up, forward, { 0.0, 0.0, 0.0 }, forward, 0.0, (double)sample->settings->weight };
	sample->ankles[leg] = bent.end;
	sample->feet[leg] = testAfter( testAimInDouble( &aim ), foot );
}

static inline void testSampleInDouble( testSampleD* sample )
{
	sample->shift = ( testPoint ){ 0.0, (double)sample->hits[0].point_w.y - (double)sample->root.translation.y, 0.0 };
	double height = (double)( sample->settings->footHeight * sample->root.scale.x );
	double down = -1e9;
	for ( int32_t leg = 0; leg < 2; ++leg )
	{
		testPoint ankle = testLegJointD( sample, leg, 2 ).point;
		testPoint normal = testWide( sample->hits[1 + leg].normal_w );
		double off = testDot( testMinus( ankle, testWide( sample->hits[1 + leg].point_w ) ), normal );
		// Of what was met only the plane counts: where the ray meets it is found anew, since a place that is rounded is
		// not on the ray, and near the ankle it then tells nothing of the ray's direction.
		testPoint met = { ankle.x, ankle.y - off / normal.y, ankle.z };
		// On the plane under the ankle, then back along the plane as far as the foot is high, then up.
		testPoint foot = testAlong( ankle, -off, normal );
		testPoint back = testAlong( met, height / off, testMinus( foot, met ) );
		sample->targets[leg] = testAlong( back, height, normal );
		down = fmax( down, ankle.y - sample->targets[leg].y );
	}
	sample->shift.y -= down;
	testSampleLegD( sample, 0 );
	testSampleLegD( sample, 1 );
}

#endif
