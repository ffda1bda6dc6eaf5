// SPDX-License-Identifier: MIT
// What the ancestors' frames show of themselves: marks lie where joints, probes, hits and targets are, and only what is
// switched on is drawn.
#include "ancestor_run.h"
#include "draw_recorder.h"

#include "baselines/ancestor.h"
#include "baselines/ancestor_draw.h"

static ancestorRun run;
static soleAncestor ancestor;
static soleProbe probes[SOLE_ANCESTOR_MAX_PROBES];
static soleHit hits[SOLE_ANCESTOR_MAX_PROBES];

/// Some frames of one system on a level ground, or over none.
static void stand( soleAncestorKind kind, soleGround* ground )
{
	ancestorStart( &run, ground );
	soleStartAncestor( &ancestor, kind, run.biped.rig, run.biped.bindPose );
	for ( int32_t i = 0; i < 20; ++i )
	{
		run.probeCount = soleGatherAncestor( &ancestor, run.biped.rig, &run.frame, probes );
		memset( hits, 0, sizeof hits );
		for ( int32_t k = 0; k < run.probeCount && ground != NULL; ++k )
		{
			hits[k] = soleCastProbe( ground, probes + k );
		}
		soleSolveAncestor( &ancestor, run.biped.rig, &run.frame, hits, run.probeCount, &run.out );
	}
	ancestorApply( &run );
}

static void drawWith( uint32_t mask )
{
	soleDebugDraw draw = makeDraw( mask );
	recorder.count = 0;
	soleDrawnAncestor drawn = { run.biped.rig, &run.frame, run.placed, probes, hits, run.probeCount, &run.out };
	soleDrawAncestor( &draw, &drawn );
}

static bool isThere( ShapeKind kind, uint32_t color, soleVec3 place )
{
	for ( int32_t i = 0; i < recorder.count; ++i )
	{
		const Shape* shape = recorder.shapes + i;
		if ( shape->kind == kind && shape->color == color && soleDistance( shape->a, place ) < 1e-4f )
		{
			return true;
		}
	}
	return false;
}

static void marksLieWhereThingsAre( void** state )
{
	(void)state;
	for ( int32_t kind = 0; kind < 4; ++kind )
	{
		stand( (soleAncestorKind)kind, ancestorStep( 0.0f, 0.1f ) );
		drawWith( SOLE_DRAW_ALL );
		for ( int32_t leg = 0; leg < 2; ++leg )
		{
			soleVec3 ankle = ancestorPlaced( &run, ancestorAnkle( leg ) ).translation;
			assert_true( isThere( shape_sphere, sole_colorJoint, ankle ) );
			assert_true( isThere( shape_sphere, sole_colorTarget, run.out.legs[leg].ankleTarget_w ) );
		}
		for ( int32_t k = 0; k < run.probeCount; ++k )
		{
			assert_true( isThere( shape_line, hits[k].hit ? sole_colorProbe : sole_colorMiss, probes[k].start_w ) );
			assert_true( !hits[k].hit || isThere( shape_arrow, sole_colorHit, hits[k].point_w ) );
		}
		soleVec3 pelvis = ancestorAnimated( &run, biped_pelvis ).translation;
		assert_true( isThere( shape_sphere, sole_colorPelvis, soleAdd( pelvis, run.out.pelvisOffset_w ) ) );
		ancestorEnd( &run );
	}
}

static void onlyWhatIsSwitchedOnIsDrawn( void** state )
{
	(void)state;
	stand( sole_ancestorHomebrew, ancestorStep( 0.0f, 0.1f ) );
	const uint32_t without = (uint32_t)sole_drawSole | (uint32_t)sole_drawLock | (uint32_t)sole_drawFoothold;
	for ( int32_t bit = 0; bit < 13; ++bit )
	{
		drawWith( 1u << bit );
		assert_true( ( recorder.count == 0 ) == ( ( without >> bit & 1u ) != 0 ) );
		for ( int32_t i = 0; i < recorder.count; ++i )
		{
			assert_int_equal( recorder.shapes[i].category, 1 << bit );
		}
	}
	ancestorEnd( &run );
}

static void aFootOverNothingSaysSo( void** state )
{
	(void)state;
	stand( sole_ancestorHomebrew, NULL );
	drawWith( (uint32_t)sole_drawFlags | (uint32_t)sole_drawProbes | (uint32_t)sole_drawHits );
	int32_t said = 0;
	for ( int32_t i = 0; i < recorder.count; ++i )
	{
		const Shape* shape = recorder.shapes + i;
		said += shape->kind == shape_text && strcmp( shape->text, "no ground" ) == 0 ? 1 : 0;
		assert_int_not_equal( shape->category, sole_drawHits );
		assert_true( shape->kind != shape_line || shape->color == sole_colorMiss );
	}
	assert_int_equal( said, 2 );
	ancestorEnd( &run );
}

static void callbacksThatAreNotThereAreLeftOut( void** state )
{
	(void)state;
	stand( sole_ancestorOzz, ancestorStep( 0.0f, 0.1f ) );
	soleDebugDraw draw = soleDefaultDebugDraw();
	soleDrawnAncestor drawn = { run.biped.rig, &run.frame, run.placed, probes, hits, run.probeCount, &run.out };
	soleDrawAncestor( &draw, &drawn );
	ancestorEnd( &run );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( marksLieWhereThingsAre ),
		cmocka_unit_test( onlyWhatIsSwitchedOnIsDrawn ),
		cmocka_unit_test( aFootOverNothingSaysSo ),
		cmocka_unit_test( callbacksThatAreNotThereAreLeftOut ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
