// SPDX-License-Identifier: MIT
// Drawing of the ancestors' frames. World space; marks are as large as Sole's own.
#include "baselines/ancestor_draw.h"

#include "baselines/baseline.h"

#define DOT 0.012f // radius of a small mark, of the longest leg

/// A frame that is being drawn.
typedef struct soleAncestorSketch
{
	const soleDebugDraw* draw;
	const soleDrawnAncestor* drawn;
	soleFrame placed; // the frame, with the placed pose for its own
	float dot;        // world
	uint32_t category;
} soleAncestorSketch;

// ------------------------------------------------------------------------------------------------------------- pen

static void soleInkLine( const soleAncestorSketch* s, soleVec3 from_w, soleVec3 to_w, soleDrawColor color )
{
	if ( s->draw->line != NULL && soleVec3_IsFinite( from_w ) && soleVec3_IsFinite( to_w ) )
	{
		s->draw->line( from_w, to_w, (uint32_t)color, s->category, s->draw->user );
	}
}

static void soleInkArrow( const soleAncestorSketch* s, soleVec3 from_w, soleVec3 to_w, soleDrawColor color )
{
	if ( s->draw->arrow != NULL && soleVec3_IsFinite( from_w ) && soleVec3_IsFinite( to_w ) )
	{
		s->draw->arrow( from_w, to_w, (uint32_t)color, s->category, s->draw->user );
	}
}

static void soleInkCircle(
    const soleAncestorSketch* s, soleVec3 center_w, soleVec3 normal_w, float radius, soleDrawColor color )
{
	if ( s->draw->circle != NULL && soleVec3_IsFinite( center_w ) && soleVec3_IsFinite( normal_w ) )
	{
		s->draw->circle( center_w, normal_w, radius, (uint32_t)color, s->category, s->draw->user );
	}
}

static void soleInkSphere( const soleAncestorSketch* s, soleVec3 center_w, float radius, soleDrawColor color )
{
	if ( s->draw->sphere != NULL && soleVec3_IsFinite( center_w ) )
	{
		s->draw->sphere( center_w, radius, (uint32_t)color, s->category, s->draw->user );
	}
}

// ------------------------------------------------------------------------------------------------------------ legs

static void soleInkAnimated( const soleAncestorSketch* s, int32_t leg )
{
	soleBaselineLeg animated = soleReadBaselineLeg( s->drawn->rig, s->drawn->frame, leg );
	soleInkLine( s, animated.hip_w, animated.knee_w, sole_colorAnimated );
	soleInkLine( s, animated.knee_w, animated.ankle_w, sole_colorAnimated );
}

static void soleInkBones( const soleAncestorSketch* s, int32_t leg )
{
	soleBaselineLeg placed = soleReadBaselineLeg( s->drawn->rig, &s->placed, leg );
	soleInkLine( s, placed.hip_w, placed.knee_w, sole_colorBone );
	soleInkLine( s, placed.knee_w, placed.ankle_w, sole_colorBone );
	soleInkSphere( s, placed.hip_w, s->dot, sole_colorJoint );
	soleInkSphere( s, placed.knee_w, s->dot, sole_colorJoint );
	soleInkSphere( s, placed.ankle_w, s->dot, sole_colorJoint );
}

static void soleInkPlane( const soleAncestorSketch* s, int32_t leg )
{
	const soleLegOutput* out = s->drawn->output->legs + leg;
	if ( out->confidence > 0.0f )
	{
		float scale = s->drawn->frame->root.scale.x;
		float radius = 0.5f * scale * soleGetBaselineSoleLength( s->drawn->rig, leg );
		soleInkCircle( s, out->planePoint_w, out->planeNormal_w, radius, sole_colorPlane );
		soleInkArrow(
		    s, out->planePoint_w, soleMulAdd( out->planePoint_w, radius, out->planeNormal_w ), sole_colorPlane );
	}
}

static void soleInkReach( const soleAncestorSketch* s, int32_t leg )
{
	soleBaselineLeg placed = soleReadBaselineLeg( s->drawn->rig, &s->placed, leg );
	soleInkCircle( s, placed.hip_w, placed.hinge_w, placed.length, sole_colorReach );
}

static void soleInkTarget( const soleAncestorSketch* s, int32_t leg )
{
	const soleLegOutput* out = s->drawn->output->legs + leg;
	soleInkSphere( s, out->ankleTarget_w, s->dot, sole_colorTarget );
	soleInkLine( s, out->ankleTarget_w, out->ankle_w, sole_colorTarget );
}

static void soleInkFlags( const soleAncestorSketch* s, int32_t leg )
{
	if ( s->draw->text == NULL )
	{
		return;
	}
	// The systems tell no more of a leg than this.
	uint32_t flags = s->drawn->output->legs[leg].flags;
	const char* text = ( flags & (uint32_t)sole_legNoGround ) != 0
	    ? "no ground"
	    : ( ( flags & (uint32_t)sole_legOutOfReach ) != 0 ? "out of reach" : "placed" );
	soleBaselineLeg placed = soleReadBaselineLeg( s->drawn->rig, &s->placed, leg );
	s->draw->text( placed.foot_w.translation, text, (uint32_t)sole_colorText, s->category, s->draw->user );
}

// ----------------------------------------------------------------------------------------------------------- ground

static soleVec3 soleGetProbeEnd( const soleProbe* probe, float share )
{
	return soleMulAdd( probe->start_w, share * probe->length, probe->direction_w );
}

static void soleInkProbe( const soleAncestorSketch* s, int32_t index )
{
	const soleProbe* probe = s->drawn->probes + index;
	const soleHit* hit = s->drawn->hits + index;
	float gone = soleDot( soleSub( hit->point_w, probe->start_w ), probe->direction_w );
	soleVec3 end = hit->hit ? soleMulAdd( probe->start_w, gone, probe->direction_w ) : soleGetProbeEnd( probe, 1.0f );
	soleInkLine( s, probe->start_w, end, hit->hit ? sole_colorProbe : sole_colorMiss );
}

static void soleInkHit( const soleAncestorSketch* s, int32_t index )
{
	const soleHit* hit = s->drawn->hits + index;
	if ( hit->hit )
	{
		soleDrawColor color = hit->startedInside ? sole_colorInside : sole_colorHit;
		soleInkSphere( s, hit->point_w, s->dot, color );
		soleInkArrow( s, hit->point_w, soleMulAdd( hit->point_w, 6.0f * s->dot, hit->normal_w ), color );
	}
}

static void soleInkSweep( const soleAncestorSketch* s, int32_t index )
{
	const soleProbe* probe = s->drawn->probes + index;
	const soleHit* hit = s->drawn->hits + index;
	soleInkCircle( s, probe->start_w, probe->direction_w, probe->radius + s->dot, sole_colorSweep );
	if ( probe->radius > 0.0f && hit->hit )
	{
		// The sphere as it lies on what it met.
		soleInkSphere( s, soleMulAdd( hit->point_w, probe->radius, hit->normal_w ), probe->radius, sole_colorSweep );
	}
}

// ------------------------------------------------------------------------------------------------------------ frame

static void soleInkPelvis( const soleAncestorSketch* s )
{
	soleVec3 from =
	    soleGetBaselineJoint( s->drawn->rig, s->drawn->frame, soleRig_GetPelvis( s->drawn->rig ) ).translation;
	soleVec3 to = soleAdd( from, s->drawn->output->pelvisOffset_w );
	soleInkArrow( s, from, to, sole_colorPelvis );
	soleInkSphere( s, to, 1.5f * s->dot, sole_colorPelvis );
}

typedef void soleInkFcn( const soleAncestorSketch* sketch, int32_t index );

/// Draws one thing for each leg or probe where its category is switched on.
static void soleInkEach( soleAncestorSketch* s, soleDrawCategory category, int32_t count, soleInkFcn* ink )
{
	s->category = (uint32_t)category;
	for ( int32_t i = 0; i < count && ( s->draw->mask & s->category ) != 0; ++i )
	{
		ink( s, i );
	}
}

void soleDrawAncestor( const soleDebugDraw* draw, const soleDrawnAncestor* drawn )
{
	int32_t legCount = drawn->output->legCount;
	int32_t probeCount = drawn->probeCount;
	soleAncestorSketch sketch = { .draw = draw, .drawn = drawn, .placed = *drawn->frame };
	sketch.placed.pose = drawn->placed;
	for ( int32_t i = 0; i < legCount; ++i )
	{
		float length = drawn->frame->root.scale.x * soleRig_GetLegLength( drawn->rig, i );
		sketch.dot = soleMaxF( sketch.dot, DOT * length );
	}
	soleInkEach( &sketch, sole_drawAnimated, legCount, soleInkAnimated );
	soleInkEach( &sketch, sole_drawBones, legCount, soleInkBones );
	soleInkEach( &sketch, sole_drawProbes, probeCount, soleInkProbe );
	soleInkEach( &sketch, sole_drawHits, probeCount, soleInkHit );
	soleInkEach( &sketch, sole_drawSweeps, probeCount, soleInkSweep );
	soleInkEach( &sketch, sole_drawPlane, legCount, soleInkPlane );
	soleInkEach( &sketch, sole_drawReach, legCount, soleInkReach );
	soleInkEach( &sketch, sole_drawTarget, legCount, soleInkTarget );
	soleInkEach( &sketch, sole_drawFlags, legCount, soleInkFlags );
	sketch.category = (uint32_t)sole_drawPelvis;
	if ( ( draw->mask & sketch.category ) != 0 )
	{
		soleInkPelvis( &sketch );
	}
}
