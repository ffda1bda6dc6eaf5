// SPDX-License-Identifier: MIT
// Drawings of what was asked of the ground and what it answered. Near space; probes and hits come in world.
#include "debug/sketch.h"

/// A probe and, where it was answered, its hit.
typedef struct soleQuestion
{
	soleVec3 start;
	soleVec3 end; // of the ray, or of the middle of the sphere: where it stopped
	const soleProbe* probe;
	const soleHit* hit; // or NULL
} soleQuestion;

/// @return false: not asked, or not usable
static bool soleReadQuestion( const soleSketch* sketch, int32_t index, soleQuestion* question )
{
	const soleDrawnFrame* drawn = sketch->drawn;
	const soleProbe* probe = drawn->probes + index;
	bool cast = probe->length > 0.0f && soleIsFinite( probe->length ) && soleIsFinite( probe->radius );
	if ( cast == false || !soleVec3_IsFinite( probe->start_w ) || !soleVec3_IsFinite( probe->direction_w ) )
	{
		return false;
	}
	const soleHit* hit = drawn->hits != NULL && index < drawn->hitCount ? drawn->hits + index : NULL;
	hit = hit != NULL && hit->hit && soleVec3_IsFinite( hit->point_w ) ? hit : NULL;
	float way = probe->length;
	if ( hit != NULL )
	{
		// The middle of a sphere stops its radius from the surface, along the normal.
		soleVec3 middle = soleMulAdd( hit->point_w, probe->radius, hit->normal_w );
		way = soleClampF( soleDot( soleSub( middle, probe->start_w ), probe->direction_w ), 0.0f, probe->length );
		way = hit->startedInside ? 0.0f : way;
	}
	question->start = soleSub( probe->start_w, sketch->work->root_w );
	question->end = soleMulAdd( question->start, way, probe->direction_w );
	question->probe = probe;
	question->hit = hit;
	return true;
}

static int32_t soleCountQuestions( const soleSketch* sketch )
{
	return sketch->drawn->probes != NULL ? sketch->drawn->probeCount : 0;
}

void soleSketchProbes( const soleSketch* sketch )
{
	soleQuestion q;
	for ( int32_t i = 0; i < soleCountQuestions( sketch ); ++i )
	{
		if ( soleReadQuestion( sketch, i, &q ) )
		{
			soleSketchLine( sketch, q.start, q.end, q.hit != NULL ? sole_colorProbe : sole_colorMiss );
		}
	}
}

void soleSketchHits( const soleSketch* sketch )
{
	soleQuestion q;
	for ( int32_t i = 0; i < soleCountQuestions( sketch ); ++i )
	{
		if ( soleReadQuestion( sketch, i, &q ) && q.hit != NULL )
		{
			soleDrawColor color = q.hit->startedInside ? sole_colorInside : sole_colorHit;
			soleVec3 point = soleSub( q.hit->point_w, sketch->work->root_w );
			soleSketchSphere( sketch, point, 0.5f * sketch->dot, color );
			soleSketchArrow( sketch, point, soleMulAdd( point, 5.0f * sketch->dot, q.hit->normal_w ), color );
		}
	}
}

void soleSketchSweeps( const soleSketch* sketch )
{
	soleQuestion q;
	for ( int32_t i = 0; i < soleCountQuestions( sketch ); ++i )
	{
		if ( soleReadQuestion( sketch, i, &q ) )
		{
			// A ray is as wide as a mark.
			bool wide = q.probe->radius > 0.0f;
			float radius = wide ? q.probe->radius : sketch->dot;
			soleSketchCircle( sketch, q.start, q.probe->direction_w, radius, sole_colorSweep );
			if ( wide )
			{
				soleSketchSphere( sketch, q.end, radius, sole_colorSweep );
			}
		}
	}
}
