// SPDX-License-Identifier: MIT
// A sole over samples that a test chooses, for soleRestSole(). It is the left sole of the plain biped: 0.19 behind the
// ball, 0.07 ahead, 0.045 to either side; it bears 0.06 behind the ball. Near space, any up.
#ifndef TEST_RESTING_H
#define TEST_RESTING_H

#include "placing.h"

#include "place/rest.h"

#define REST_MAX_SAMPLES SOLE_MAX_PROBES_PER_LEG
#define REST_HEEL ( -0.19f )
#define REST_TOE 0.07f
#define REST_LOAD ( -0.06f )

/// A foot somewhere, headed somewhere, over some samples. Not to be copied: it points into itself.
typedef struct testSole
{
	testBiped biped;
	soleSettings settings;
	solePlaceWork work;
	soleLegWork leg;
	soleRigLeg rigLeg;
	soleGroundSample samples[REST_MAX_SAMPLES];
	float ahead[REST_MAX_SAMPLES]; // of the samples, in the foot's own frame
	float aside[REST_MAX_SAMPLES];
	soleVec3 center, forward, side;
} testSole;

/// @param toes whether the foot has a toe joint
static inline void testStartSole( testSole* s, bool toes )
{
	memset( s, 0, sizeof *s );
	testMakeBiped( &s->biped );
	s->settings = soleDefaultSettings();
	s->rigLeg = s->biped.rig->legs[0];
	s->rigLeg.toeSlot = toes ? s->rigLeg.toeSlot : SOLE_NONE;
	s->work.rig = s->biped.rig;
	s->work.settings = &s->settings;
	s->work.rootScale = 1.0f;
	s->work.up = soleVec( 0.0f, 1.0f, 0.0f );
	s->work.reference = -0.3f;
	s->leg.rig = &s->rigLeg;
	s->leg.samples = s->samples;
	s->leg.length = 0.9f;
	s->forward = soleVec( 0.0f, 0.0f, 1.0f );
	s->side = soleCross( s->forward, s->work.up );
}

static inline void testEndSole( testSole* s )
{
	soleDestroyRig( s->biped.rig );
}

/// Another up, heading and size.
static inline void testTurnSole( testSole* s, soleQuat q, float scale )
{
	s->work.up = soleRotate( q, soleVec( 0.0f, 1.0f, 0.0f ) );
	s->forward = soleRotate( q, soleVec( 0.0f, 0.0f, 1.0f ) );
	s->side = soleCross( s->forward, s->work.up );
	s->center = soleRotate( q, soleVec( 3.0f, 7.0f, -2.0f ) );
	s->work.rootScale = scale;
	s->leg.length = 0.9f * scale;
}

/// A sample in the foot's own frame, unit lengths; its height is that over 1 m up.
static inline soleGroundSample* testAddSample( testSole* s, float ahead, float aside, float height )
{
	int32_t i = s->leg.sampleCount++;
	float scale = s->work.rootScale;
	s->ahead[i] = ahead;
	s->aside[i] = aside;
	soleVec3 place = soleMulAdd( s->center, scale * ahead, s->forward );
	place = soleMulAdd( place, scale * aside, s->side );
	s->samples[i] = ( soleGroundSample ){
		.place = place, .found = true, .height = scale * ( 1.0f + height ), .surface = SOLE_NONE
	};
	return s->samples + i;
}

static inline soleRest testRestOn( testSole* s, bool line )
{
	s->work.angles = soleTakeAngles( &s->settings );
	return soleRestSole( &s->work, &s->leg, soleMakeFootprint( &s->work, s->center, s->forward, s->work.up ), line );
}

static inline soleRest testRest( testSole* s )
{
	return testRestOn( s, false );
}

/// Only places along the middle count.
static inline soleRest testRestOnLine( testSole* s )
{
	return testRestOn( s, true );
}

/// Height of a plane over a place in the foot's own frame, as the samples' heights are given.
static inline float testRestHeight( const testSole* s, const soleRest* r, float ahead, float aside )
{
	soleVec3 place = soleMulAdd( s->center, s->work.rootScale * ahead, s->forward );
	place = soleMulAdd( place, s->work.rootScale * aside, s->side );
	return solePlaneHeight( &s->work, r->plane, place ) / s->work.rootScale - 1.0f;
}

static inline void testNearPlane(
    const testSole* s, const soleRest* r, float height, float slopeAhead, float slopeAside )
{
	assert_true( r->found );
	assert_float_equal( testRestHeight( s, r, REST_LOAD, 0.0f ), height, 1e-5f );
	assert_float_equal( soleDot( r->plane.gradient, s->forward ), slopeAhead, 1e-4f );
	assert_float_equal( soleDot( r->plane.gradient, s->side ), slopeAside, 1e-4f );
}

/// Rows of two samples from heel to toe, as a careful host asks: some of them moved a little, on one level.
static inline void testAddRows( testSole* s, uint32_t* seed, float roughness )
{
	for ( int32_t row = 0; row < 9; ++row )
	{
		for ( int32_t k = 0; k < 2; ++k )
		{
			float ahead = REST_HEEL + 0.004f + ( REST_TOE - REST_HEEL - 0.008f ) * (float)row / 8.0f +
			    testRandomFloat( seed, -0.004f, 0.004f );
			float aside = ( k == 0 ? -1.0f : 1.0f ) * testRandomFloat( seed, 0.03f, 0.04f );
			testAddSample( s, ahead, aside, testRandomFloat( seed, -roughness, roughness ) );
		}
	}
}

/// Nine places along the middle of the sole: a height for all behind an edge and for all ahead of it.
static inline void testAddLine( testSole* s, float behind, float ahead, float edge )
{
	for ( int32_t i = 0; i < 9; ++i )
	{
		float u = REST_HEEL + ( REST_TOE - REST_HEEL ) * (float)i / 8.0f;
		testAddSample( s, u, 0.0f, u < edge ? behind : ahead );
	}
}

#endif
