// SPDX-License-Identifier: MIT
// Drawings of legs, feet and pelvis, from what the stages left behind. Near space.
#include "debug/sketch.h"
#include "place/way.h"

#define WAY_PIECES 12

/// The leg's bones hip to ankle. joints: jointCount of them and, where it is virtual, the ankle.
static void soleSketchChain( const soleSketch* sketch, const soleVec3* joints, int32_t last, soleDrawColor color )
{
	for ( int32_t i = 0; i < last; ++i )
	{
		soleSketchLine( sketch, joints[i], joints[i + 1], color );
	}
}

void soleSketchAnimated( const soleSketch* sketch )
{
	for ( int32_t i = 0; i < sketch->work->legCount; ++i )
	{
		const soleLegWork* leg = sketch->work->legs + i;
		if ( leg->usable )
		{
			soleSketchChain( sketch, leg->joints, leg->ankleIndex, sole_colorAnimated );
			soleSketchLine( sketch, leg->ankle, leg->pivot, sole_colorAnimated );
		}
	}
}

/// The joint that carries the fore part of the foot, as placed.
static soleTransform soleGetFore( const soleSketch* sketch, const soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	return sketch->placed[rig->toeSlot == SOLE_NONE ? rig->footSlot : rig->toeSlot];
}

void soleSketchBones( const soleSketch* sketch )
{
	for ( int32_t i = 0; i < sketch->work->legCount; ++i )
	{
		const soleLegWork* leg = sketch->work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		const soleRigLeg* rig = leg->rig;
		soleVec3 joints[SOLE_MAX_LEG_JOINTS + 1] = { 0 };
		for ( int32_t j = 0; j < rig->def.jointCount; ++j )
		{
			joints[j] = sketch->placed[rig->slots[j]].translation;
		}
		if ( rig->def.hasVirtualAnkle )
		{
			soleTransform last = sketch->placed[rig->slots[rig->def.jointCount - 1]];
			joints[leg->ankleIndex] = soleTransformPoint( last, rig->virtualAnkle );
		}
		soleSketchChain( sketch, joints, leg->ankleIndex, sole_colorBone );
		soleTransform fore = soleGetFore( sketch, leg );
		soleVec3 toe = rig->toeSlot == SOLE_NONE ? soleTransformPoint( fore, rig->foreBall ) : fore.translation;
		soleSketchLine( sketch, joints[leg->ankleIndex], toe, sole_colorBone );
		soleSketchLine( sketch, toe, soleTransformPoint( fore, rig->foreToe ), sole_colorBone );
		for ( int32_t j = 0; j <= leg->ankleIndex; ++j )
		{
			soleSketchSphere( sketch, joints[j], sketch->dot, sole_colorJoint );
		}
		soleSketchSphere( sketch, toe, sketch->dot, sole_colorJoint );
	}
}

void soleSketchSoles( const soleSketch* sketch )
{
	for ( int32_t i = 0; i < sketch->work->legCount; ++i )
	{
		const soleLegWork* leg = sketch->work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		const soleRigLeg* rig = leg->rig;
		soleTransform fore = soleGetFore( sketch, leg );
		// Around the sole, the ball in its middle.
		const soleVec3 points[] = {
			soleTransformPoint( sketch->placed[rig->footSlot], rig->heel ),
			soleTransformPoint( fore, rig->foreInner ),
			soleTransformPoint( fore, rig->foreToe ),
			soleTransformPoint( fore, rig->foreOuter ),
			soleTransformPoint( fore, rig->foreBall ),
		};
		for ( int32_t k = 0; k < 5; ++k )
		{
			soleSketchSphere( sketch, points[k], 0.5f * sketch->dot, sole_colorSole );
		}
		for ( int32_t k = 0; k < 4; ++k )
		{
			soleSketchLine( sketch, points[k], points[( k + 1 ) % 4], sole_colorSole );
		}
	}
}

void soleSketchPlanes( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->hasGround == false )
		{
			continue;
		}
		soleVec3 point = soleSub( leg->out->planePoint_w, work->root_w );
		soleVec3 normal = leg->out->planeNormal_w;
		float radius = 0.5f * work->rootScale * ( leg->rig->heelBehind + leg->rig->toeAhead );
		soleSketchCircle( sketch, point, normal, radius, sole_colorPlane );
		soleSketchCircle( sketch, point, normal, radius * leg->out->confidence, sole_colorPlane );
		soleSketchArrow( sketch, point, soleMulAdd( point, radius, normal ), sole_colorPlane );
	}
}

/// The ring stands about where the animation would hold the foot by now: the anchor that leaves it is let go.
void soleSketchLocks( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->planted == false )
		{
			continue;
		}
		soleVec3 held = soleSub( leg->state->lockPoint_w, work->root_w );
		held = soleAtHeight( work, held, solePlaneHeight( work, leg->plane, held ) );
		soleVec3 meant = soleAdd( soleAdd( leg->anchor, leg->anchorShift ), leg->state->heldShift );
		meant = soleAtHeight( work, meant, solePlaneHeight( work, leg->plane, meant ) );
		float radius = work->settings->contact.lockDistance * leg->length;
		soleSketchSphere( sketch, held, sketch->dot, sole_colorLock );
		soleSketchCircle( sketch, meant, leg->plane.normal, radius, sole_colorRelease );
		soleSketchLine( sketch, held, meant, sole_colorRelease );
	}
}

void soleSketchReach( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable )
		{
			soleReach reach = soleGetReach( work, leg );
			soleVec3 side = soleCross( leg->forward, work->up );
			soleSketchCircle( sketch, leg->hip, side, reach.hard, sole_colorReach );
			soleSketchCircle( sketch, leg->hip, side, reach.soft, sole_colorReach );
			soleSketchCircle( sketch, leg->hip, side, work->settings->leg.fold * leg->length, sole_colorFold );
		}
	}
}

/// Where the pelvis would be at an offset over the body's ground that is no further than the settings allow.
static soleVec3 solePelvisAt( const soleSketch* sketch, float offset )
{
	const solePlaceWork* work = sketch->work;
	float length = soleLongestLeg( work );
	const soleSettings* s = work->settings;
	float over = work->bodyGround - work->reference;
	float limited = soleClampF( offset, -s->pelvis.down * length, s->pelvis.up * length );
	return soleMulAdd( work->slots[work->rig->pelvisSlot].translation, over + limited, work->up );
}

void soleSketchPelvis( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	soleVec3 animated = work->slots[work->rig->pelvisSlot].translation;
	soleVec3 placed = sketch->placed[work->rig->pelvisSlot].translation;
	if ( work->bounds.any )
	{
		soleVec3 low = solePelvisAt( sketch, work->bounds.floor );
		soleVec3 high = solePelvisAt( sketch, work->bounds.most );
		soleSketchLine( sketch, low, high, sole_colorLimit );
		soleSketchCircle( sketch, low, work->up, 4.0f * sketch->dot, sole_colorLimit );
		soleSketchCircle( sketch, high, work->up, 4.0f * sketch->dot, sole_colorLimit );
		soleVec3 good = solePelvisAt( sketch, soleMinF( work->bounds.ceiling, work->bounds.landing ) );
		soleSketchCircle( sketch, good, work->up, 3.0f * sketch->dot, sole_colorPelvis );
	}
	soleSketchArrow( sketch, animated, placed, sole_colorPelvis );
	soleSketchSphere( sketch, placed, 1.5f * sketch->dot, sole_colorPelvis );
}

void soleSketchFootholds( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false || leg->planned == false )
		{
			continue;
		}
		soleWay way = soleRememberWay( work, leg );
		soleVec3 before = way.from;
		for ( int32_t k = 1; k <= WAY_PIECES; ++k )
		{
			soleVec3 place = soleLerp( way.from, way.to, (float)k / (float)WAY_PIECES );
			soleVec3 next = soleFollowWay( work, leg, &way, place ).point;
			soleSketchLine( sketch, before, next, sole_colorWay );
			before = next;
		}
		soleSketchCircle( sketch, way.to, leg->stepNormal, 4.0f * sketch->dot, sole_colorFoothold );
		soleVec3 ahead = soleScale( leg->rig->toeAhead * work->rootScale, leg->landingForward );
		soleSketchArrow( sketch, way.to, soleAdd( way.to, soleReject( ahead, leg->stepNormal ) ), sole_colorFoothold );
	}
}

void soleSketchTargets( const soleSketch* sketch )
{
	const solePlaceWork* work = sketch->work;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		soleVec3 wanted = soleSub( leg->out->ankleTarget_w, work->root_w );
		soleVec3 is = soleSub( leg->out->ankle_w, work->root_w );
		soleVec3 ahead = soleRotate( leg->footTarget, leg->rig->footForward );
		soleSketchSphere( sketch, wanted, 1.5f * sketch->dot, sole_colorTarget );
		soleSketchLine( sketch, wanted, is, sole_colorTarget );
		soleSketchArrow( sketch, wanted, soleMulAdd( wanted, 8.0f * sketch->dot, ahead ), sole_colorTarget );
	}
}

// ------------------------------------------------------------------------------------------------------------ flags

static const char* const soleFlagNames[] = { "planted", "no ground", "too steep", "on edge", "softened", "out of reach",
	"heel lifted", "ankle clamped", "folded", "released", "captured", "degenerate", "bad input", "inside", "planned",
	"too low", "too high", "asleep" };

#define FLAG_COUNT ( (int32_t)( sizeof soleFlagNames / sizeof soleFlagNames[0] ) )
#define TEXT_SIZE 256 // all names and commas fit

/// Writes as much of a word as fits. @return where the next one goes
static int32_t soleWrite( char* text, int32_t at, const char* word )
{
	for ( int32_t i = 0; word[i] != '\0' && at < TEXT_SIZE - 1; ++i )
	{
		text[at++] = word[i];
	}
	text[at] = '\0';
	return at;
}

void soleSketchFlags( const soleSketch* sketch )
{
	for ( int32_t i = 0; i < sketch->work->legCount; ++i )
	{
		const soleLegWork* leg = sketch->work->legs + i;
		char text[TEXT_SIZE];
		int32_t at = soleWrite( text, 0, leg->rig->name );
		for ( int32_t k = 0; k < FLAG_COUNT; ++k )
		{
			if ( ( leg->out->flags >> k & 1u ) != 0 )
			{
				at = soleWrite( text, at, at > 0 ? ", " : "" );
				at = soleWrite( text, at, soleFlagNames[k] );
			}
		}
		soleSketchText( sketch, sketch->placed[leg->rig->footSlot].translation, text, sole_colorText );
	}
}
