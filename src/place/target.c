// SPDX-License-Identifier: MIT
// Target: where ankle and foot should be.
//
// The animated foot, as it stands over the clip's floor, is carried as one rigid body from that floor to the plane
// under it. With Q the anchor's place on the plane, q its place on the floor, R the heading offset and T the turn from
// up to the plane's normal, every point p of the foot goes to
//   p' = Q + T R ( p - q )
// so its distance from the plane, along the normal, is its animated height over the floor: a flat foot lies flat, and
// heel strike, heel-off and flight survive on any slope. The anchor neither slides nor leaves the plane while Q is
// held. A foot that its clip leaves tilted while it stands is laid flat before, by a turn F about its pivot b:
//   p' = Q + T R ( ( b - q ) + F ( p - b ) )
// A weight of the place leads back to where the animation has the ankle, one of the turn to how it turns the
// foot.
#include "place/place.h"

#define FLATTEN_TIME 0.04f // s, half-life
#define HEEL_RESTS 0.15f   // L/s: a heel that is slower neither comes down nor leaves

/// Follows less of the slope, and stays above the ground for it: the flatter plane is raised until it touches the old
/// one at an end of the sole.
static solePlane soleFlatten( const solePlaceWork* work, const soleLegWork* leg )
{
	solePlane plane = leg->plane;
	float align = soleFindAlign( work, plane.gradient );
	if ( align >= 1.0f )
	{
		return plane;
	}
	const soleRigLeg* rig = leg->rig;
	soleVec3 lost = soleScale( 1.0f - align, plane.gradient );
	soleVec3 side = soleCross( leg->soleForward, work->up );
	float raise = 0.0f;
	const float ahead[] = { -rig->heelBehind, rig->toeAhead, 0.0f, 0.0f };
	const float aside[] = { 0.0f, 0.0f, rig->innerSide, rig->outerSide };
	for ( int32_t i = 0; i < 4; ++i )
	{
		soleVec3 p = soleMulAdd( leg->soleCenter, ahead[i] * work->rootScale, leg->soleForward );
		p = soleMulAdd( p, aside[i] * work->rootScale, side );
		float over = soleDot( lost, soleHorizontal( work, soleSub( p, plane.point ) ) );
		raise = soleMaxF( raise, over );
	}
	return soleMakePlane( work, soleMulAdd( plane.point, raise, work->up ), soleScale( align, plane.gradient ) );
}

/// The turn that lays a foot flat whose heel its clip leaves off the floor while heel and toes are down and at rest:
/// about what a heel is raised about, at right angles to the foot. It comes and goes with that.
static soleQuat soleLayFlat( const solePlaceWork* work, soleLegWork* leg )
{
	const soleSettings* s = work->settings;
	soleLegState* state = leg->state;
	const uint32_t both = (uint32_t)( sole_stateHeelOn | sole_stateToeOn );
	bool rests = ( state->flags & both ) == both && leg->heelSpeed < HEEL_RESTS * leg->length;
	float length = soleMaxF( soleDistance( leg->heel, leg->pivot ), 0.01f * leg->length );
	float sine = soleClampF( ( leg->heelRise - leg->ballRise ) / length, 0.0f, 1.0f );
	// Of a sine so small that the angle is nearly as large; what is beyond the limit stays.
	float goal = rests ? soleMinF( sine, s->target.flatten ) : 0.0f;
	soleOffset1 still = { goal, 0.0f };
	state->flat = work->first ? still : soleStepSpring( state->flat, goal, 0.0f, FLATTEN_TIME, work->timeStep );
	soleVec3 side = soleRotate( leg->foot.rotation, leg->rig->footSide );
	return soleHalfRotation( side, soleHalfFromAngle( state->flat.value ) );
}

void soleSetTargets( solePlaceWork* work )
{
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		soleLegWork* leg = work->legs + i;
		if ( leg->usable == false )
		{
			continue;
		}
		solePlane plane = soleFlatten( work, leg );
		soleVec3 q = leg->anchor;
		soleVec3 goal = soleAtHeight( work, leg->anchorGoal, solePlaneHeight( work, plane, leg->anchorGoal ) );
		goal = soleMulAdd( goal, leg->sunk + work->settings->target.height * leg->length, plane.normal );
		soleQuat tilt = soleFromTo( work->up, plane.normal, leg->forward );
		// Heights were measured along the root's up: a leaning root is put upright first.
		soleQuat upright = soleFromTo( work->rootUp, work->up, leg->forward );
		soleQuat image = soleMulQuat( tilt, soleMulQuat( leg->turn, upright ) );
		soleQuat turned = soleMulQuat( leg->turn, soleMulQuat( soleGetToeOut( work, leg ), upright ) );
		leg->image = soleMulQuat( tilt, turned );
		// A foot that is turned outwards turns under its ankle.
		soleQuat flat = soleLayFlat( work, leg );
		soleVec3 arm = soleAdd( soleSub( leg->pivot, q ), soleRotate( flat, soleSub( leg->ankle, leg->pivot ) ) );
		soleVec3 ankle = soleAdd( goal, soleRotate( image, arm ) );
		soleVec3 fore = soleRotate( flat, soleSub( leg->pivot, leg->ankle ) );
		soleVec3 pivot = soleAdd( ankle, soleRotate( leg->image, fore ) );
		soleQuat foot = soleMulQuat( leg->image, soleMulQuat( flat, leg->foot.rotation ) );

		leg->ankleWanted = ankle;
		leg->ankleTarget = soleLerp( leg->ankle, ankle, leg->weight );
		leg->pivotTarget = soleLerp( leg->pivot, pivot, leg->weight );
		leg->footTarget = soleNlerp( leg->foot.rotation, foot, leg->turnWeight );
		leg->out->planePoint_w =
		    soleAdd( soleAtHeight( work, ankle, solePlaneHeight( work, plane, ankle ) ), work->root_w );
		leg->out->planeNormal_w = plane.normal;
	}
}
