// SPDX-License-Identifier: MIT
// Keeps what a frame draws of itself, and with what it was solved. Refuses what is not finite.
#ifndef TEST_DRAW_RECORDER_H
#define TEST_DRAW_RECORDER_H

#include "biped_walk.h"

#include "sole/draw.h"

typedef enum ShapeKind
{
	shape_line,
	shape_arrow,
	shape_circle,
	shape_sphere,
	shape_text
} ShapeKind;

typedef struct Shape
{
	ShapeKind kind;
	soleVec3 a;
	soleVec3 b; // of circles the normal
	float radius;
	uint32_t color;
	uint32_t category;
	char text[256];
} Shape;

#define MOST_SHAPES 4096

typedef struct Recorder
{
	int32_t count;
	Shape shapes[MOST_SHAPES];
} Recorder;

static Recorder recorder;

static inline void record( Recorder* to, Shape shape )
{
	assert_in_range( to->count, 0, MOST_SHAPES - 1 );
	assert_true( soleVec3_IsFinite( shape.a ) && soleVec3_IsFinite( shape.b ) && soleIsFinite( shape.radius ) );
	to->shapes[to->count++] = shape;
}

static inline void onLine( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user )
{
	record( user, ( Shape ){ .kind = shape_line, .a = from_w, .b = to_w, .color = color, .category = category } );
}

static inline void onArrow( soleVec3 from_w, soleVec3 to_w, uint32_t color, uint32_t category, void* user )
{
	record( user, ( Shape ){ .kind = shape_arrow, .a = from_w, .b = to_w, .color = color, .category = category } );
}

static inline void onCircle(
    soleVec3 center_w, soleVec3 normal_w, float radius, uint32_t color, uint32_t category, void* user )
{
	record( user, ( Shape ){ shape_circle, center_w, normal_w, radius, color, category, "" } );
}

static inline void onSphere( soleVec3 center_w, float radius, uint32_t color, uint32_t category, void* user )
{
	record( user,
	    ( Shape ){ .kind = shape_sphere, .a = center_w, .radius = radius, .color = color, .category = category } );
}

static inline void onText( soleVec3 place_w, const char* text, uint32_t color, uint32_t category, void* user )
{
	Shape shape = { .kind = shape_text, .a = place_w, .color = color, .category = category };
	assert_true( strlen( text ) < sizeof shape.text );
	memcpy( shape.text, text, strlen( text ) );
	record( user, shape );
}

static inline soleDebugDraw makeDraw( uint32_t mask )
{
	soleDebugDraw draw = soleDefaultDebugDraw();
	draw.line = onLine;
	draw.arrow = onArrow;
	draw.circle = onCircle;
	draw.sphere = onSphere;
	draw.text = onText;
	draw.user = &recorder;
	draw.mask = mask;
	return draw;
}

/// A frame with all that went into it.
typedef struct Take
{
	testRun run;
	soleState before;
	soleProbe probes[SOLE_MAX_PROBES];
	soleHit hits[SOLE_MAX_PROBES];
	int32_t count;
} Take;

static Take take;

static inline void stepTake( void )
{
	testRun* run = &take.run;
	take.before = run->state;
	take.count =
	    soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, take.probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < take.count; ++i )
	{
		testCastAt( &run->ground, take.probes + i, take.hits + i );
	}
	soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, take.hits, take.count, &run->out );
	testPlace( run );
}

static inline void drawTake( uint32_t mask )
{
	recorder.count = 0;
	soleDebugDraw draw = makeDraw( mask );
	soleDrawnFrame drawn = { take.run.biped.rig, &take.run.settings, &take.before, &take.run.frame, take.probes,
		take.hits, take.count, take.count };
	soleDrawFrame( &draw, &drawn );
}

static inline int32_t countNear( ShapeKind kind, uint32_t color, soleVec3 place )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < recorder.count; ++i )
	{
		const Shape* s = recorder.shapes + i;
		count += s->kind == kind && s->color == color && soleDistance( s->a, place ) < 2e-5f ? 1 : 0;
	}
	return count;
}

static inline const Shape* findShape( ShapeKind kind, uint32_t color )
{
	for ( int32_t i = 0; i < recorder.count; ++i )
	{
		if ( recorder.shapes[i].kind == kind && recorder.shapes[i].color == color )
		{
			return recorder.shapes + i;
		}
	}
	return NULL;
}

#endif
