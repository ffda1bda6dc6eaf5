// SPDX-License-Identifier: MIT
// Tilt: how far a sole tilts with the ground, and is turned outwards. It follows a share of the slope, up to a furthest
// angle; where it stands under its ankle, and how long it is seen from above, go by that tilt and not by the ground's.
#include "place/place.h"

float soleFindAlign( const solePlaceWork* work, soleVec3 gradient )
{
	float align = work->settings->target.align;
	float steep = soleLength( gradient );
	return steep * align > work->angles.steepestTilt ? work->angles.steepestTilt / steep : align;
}

/// The normal of a sole on ground of some normal.
static soleVec3 soleTilt( const solePlaceWork* work, soleVec3 normal )
{
	float up = soleDot( normal, work->up );
	if ( !( up > 1e-3f ) )
	{
		return normal;
	}
	soleVec3 gradient = soleScale( -1.0f / up, soleHorizontal( work, normal ) );
	float align = soleFindAlign( work, gradient );
	return align < 1.0f ? soleNormalizeOr( soleMulAdd( work->up, -align, gradient ), work->up ) : normal;
}

soleVec3 soleTiltShift( const solePlaceWork* work, const soleLegWork* leg, soleVec3 normal )
{
	soleVec3 tilted = soleTilt( work, normal );
	return soleScale( -leg->rig->ankleHeight * work->rootScale, soleHorizontal( work, tilted ) );
}

/// With R the turn from up U to a plane's normal N, f . R f = 1 - ( f . N )^2 / ( 1 + U . N ) for horizontal f.
soleFootprint soleMakeFootprint( const solePlaceWork* work, soleVec3 ball, soleVec3 forward, soleVec3 normal )
{
	soleVec3 tilted = soleTilt( work, normal );
	soleVec3 side = soleCross( forward, work->up );
	float perLean = 1.0f / ( 1.0f + soleMaxF( soleDot( work->up, tilted ), 0.0f ) );
	float pitch = soleDot( forward, tilted );
	float roll = soleDot( side, tilted );
	float along = work->rootScale * ( 1.0f - pitch * pitch * perLean );
	float across = work->rootScale * ( 1.0f - roll * roll * perLean );
	return ( soleFootprint ){ ball, forward, side, along, across };
}

soleQuat soleGetToeOut( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleRigLeg* rig = leg->rig;
	float left = rig->def.side == sole_left ? work->settings->target.toeOutLeft : 0.0f;
	float angle = rig->def.side == sole_right ? work->settings->target.toeOutRight : left;
	// A positive turn about up takes the heading away from the foot's side vector.
	float sign = rig->outerSide >= rig->innerSide ? -1.0f : 1.0f;
	return soleHalfRotation( work->up, soleHalfFromAngle( sign * angle ) );
}
