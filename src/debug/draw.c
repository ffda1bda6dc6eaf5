// SPDX-License-Identifier: MIT
// Debug drawing: solves a copy of a frame to see what its stages had in hand, poses the rig with the outcome, and has
// each category that is switched on draw itself.
#include "sole/draw.h"

#include "base/core.h"
#include "debug/sketch.h"

#define DOT 0.012f // radius of a small mark, of the longest leg

static const soleDrawInfo soleDrawInfos[] = {
	{ sole_drawAnimated, "animated legs", "The legs as the animation has them." },
	{ sole_drawBones, "placed legs", "Bones and joints of the legs as they were placed." },
	{ sole_drawProbes, "probes", "What was asked of the ground, as far as it was met." },
	{ sole_drawHits, "hits", "Where the ground was met, with its normal." },
	{ sole_drawSweeps, "sweeps", "The heights at which probes start, and the spheres that are swept." },
	{ sole_drawSole, "sole points", "Heel, ball, toe tip, inner and outer edge of each placed foot." },
	{ sole_drawPlane, "support plane", "The plane that carries each sole; the inner ring is as wide as it is sure." },
	{ sole_drawLock, "locks", "Where feet are held; the ring is how far the animation may leave before they let go." },
	{ sole_drawReach, "reach", "How far each leg reaches before and after it is softened, and how short it may be." },
	{ sole_drawPelvis, "pelvis", "What the legs allow the pelvis, and where it went from where it was animated." },
	{ sole_drawFoothold, "footholds", "Where feet in flight will land, and the height of their way there." },
	{ sole_drawTarget, "targets", "Where ankles were wanted, where they are, and which way the feet are headed." },
	{ sole_drawFlags, "flags", "Why each leg is as it is, in words at the foot." },
};

typedef void soleSketchFcn( const soleSketch* sketch );

static soleSketchFcn* const soleSketches[] = {
	soleSketchAnimated,
	soleSketchBones,
	soleSketchProbes,
	soleSketchHits,
	soleSketchSweeps,
	soleSketchSoles,
	soleSketchPlanes,
	soleSketchLocks,
	soleSketchReach,
	soleSketchPelvis,
	soleSketchFootholds,
	soleSketchTargets,
	soleSketchFlags,
};

#define COUNT ( (int32_t)( sizeof soleDrawInfos / sizeof soleDrawInfos[0] ) )

_Static_assert( sizeof soleSketches / sizeof soleSketches[0] == sizeof soleDrawInfos / sizeof soleDrawInfos[0],
    "each category has its drawing" );

soleDebugDraw soleDefaultDebugDraw( void )
{
	return ( soleDebugDraw ){ .mask = SOLE_DRAW_ALL, .internalValue = SOLE_COOKIE };
}

const soleDrawInfo* soleGetDrawInfos( int32_t* count )
{
	SOLE_ASSERT( count != NULL );
	if ( count != NULL )
	{
		*count = COUNT;
	}
	return soleDrawInfos;
}

// ------------------------------------------------------------------------------------------------------------- pen

static soleVec3 soleToWorld( const soleSketch* sketch, soleVec3 near )
{
	return soleAdd( near, sketch->work->root_w );
}

void soleSketchLine( const soleSketch* sketch, soleVec3 from, soleVec3 to, soleDrawColor color )
{
	const soleDebugDraw* draw = sketch->draw;
	if ( draw->line != NULL && soleVec3_IsFinite( from ) && soleVec3_IsFinite( to ) )
	{
		draw->line(
		    soleToWorld( sketch, from ), soleToWorld( sketch, to ), (uint32_t)color, sketch->category, draw->user );
	}
}

void soleSketchArrow( const soleSketch* sketch, soleVec3 from, soleVec3 to, soleDrawColor color )
{
	const soleDebugDraw* draw = sketch->draw;
	if ( draw->arrow != NULL && soleVec3_IsFinite( from ) && soleVec3_IsFinite( to ) )
	{
		draw->arrow(
		    soleToWorld( sketch, from ), soleToWorld( sketch, to ), (uint32_t)color, sketch->category, draw->user );
	}
}

void soleSketchCircle( const soleSketch* sketch, soleVec3 center, soleVec3 normal, float radius, soleDrawColor color )
{
	const soleDebugDraw* draw = sketch->draw;
	if ( draw->circle != NULL && soleVec3_IsFinite( center ) && soleVec3_IsFinite( normal ) && soleIsFinite( radius ) )
	{
		draw->circle( soleToWorld( sketch, center ), normal, radius, (uint32_t)color, sketch->category, draw->user );
	}
}

void soleSketchSphere( const soleSketch* sketch, soleVec3 center, float radius, soleDrawColor color )
{
	const soleDebugDraw* draw = sketch->draw;
	if ( draw->sphere != NULL && soleVec3_IsFinite( center ) && soleIsFinite( radius ) )
	{
		draw->sphere( soleToWorld( sketch, center ), radius, (uint32_t)color, sketch->category, draw->user );
	}
}

void soleSketchText( const soleSketch* sketch, soleVec3 place, const char* text, soleDrawColor color )
{
	const soleDebugDraw* draw = sketch->draw;
	if ( draw->text != NULL && soleVec3_IsFinite( place ) )
	{
		draw->text( soleToWorld( sketch, place ), text, (uint32_t)color, sketch->category, draw->user );
	}
}

// --------------------------------------------------------------------------------------------------------- the pose

/// What the output has for the joints of one leg, in the local spaces of their parents: soleApply() for evaluated
/// joints alone.
static void soleApplyLeg( const solePlaceWork* work, const soleLegWork* leg, soleTransform* slots )
{
	const soleRigLeg* rig = leg->rig;
	const soleLegOutput* out = leg->out;
	for ( int32_t j = 0; j < rig->def.jointCount; ++j )
	{
		slots[rig->slots[j]].rotation = out->rotations_l[j];
		for ( int32_t k = rig->slots[j]; j > 0 && k != rig->slots[j - 1]; k = work->rig->slotParents[k] )
		{
			slots[k].translation = soleScale( out->stretch, slots[k].translation );
		}
	}
	if ( rig->toeSlot != SOLE_NONE )
	{
		slots[rig->toeSlot].rotation = out->toeRotation_l;
	}
	if ( rig->def.detachedFoot != SOLE_NONE )
	{
		slots[rig->footSlot].translation = out->footTranslation_l;
		slots[rig->footSlot].rotation = out->footRotation_l;
	}
}

static void solePoseSketch( const solePlaceWork* work, soleTransform* slots )
{
	const soleRig* rig = work->rig;
	for ( int32_t i = 0; i < rig->slotCount; ++i )
	{
		slots[i] = soleReadPose( work->frame, work->out->secondWeight, rig->slotJoints[i] );
		slots[i].rotation = soleNormalizeQuat( slots[i].rotation );
	}
	slots[rig->pelvisSlot].translation = work->out->pelvisTranslation_l;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleApplyLeg( work, work->legs + i, slots );
	}
	soleTransform root = { { 0.0f, 0.0f, 0.0f }, soleNormalizeQuat( work->frame->root.rotation ),
		work->frame->root.scale };
	for ( int32_t i = 0; i < rig->slotCount; ++i )
	{
		int32_t parent = rig->slotParents[i];
		slots[i] = soleMulTransform( parent == SOLE_NONE ? root : slots[parent], slots[i] );
	}
}

// -------------------------------------------------------------------------------------------------------- the frame

static void soleDrawCategories( soleSketch* sketch )
{
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		sketch->category = (uint32_t)soleDrawInfos[i].category;
		if ( ( sketch->draw->mask & sketch->category ) != 0 )
		{
			soleSketches[i]( sketch );
		}
	}
}

void soleDrawFrame( const soleDebugDraw* draw, const soleDrawnFrame* drawn )
{
	bool given = draw != NULL && draw->internalValue == SOLE_COOKIE && drawn != NULL && drawn->rig != NULL &&
	    drawn->state != NULL && drawn->frame != NULL;
	SOLE_ASSERT( given && "start from soleDefaultDebugDraw()" );
	if ( given == false || ( draw->mask & SOLE_DRAW_ALL ) == 0 || !soleIsFrameUsable( drawn->frame ) )
	{
		return;
	}
	soleState state = *drawn->state;
	soleSettings scratch;
	const soleSettings* settings = soleCleanSettings( drawn->rig, drawn->settings, &scratch );
	soleLegHits hits = soleSplitHits( drawn->rig, settings, drawn->hits, drawn->hitCount );
	soleOutput out;
	solePlaceRoom room;
	solePlaceWork work = soleWorkIn( &room );
	soleBeginFrame( &work, drawn->rig, settings, &state, drawn->frame, &out );
	soleEndFrame( &work, &hits );
	soleSketch sketch = { .draw = draw, .drawn = drawn, .work = &work, .dot = DOT * soleLongestLeg( &work ) };
	solePoseSketch( &work, sketch.placed );
	soleDrawCategories( &sketch );
}
