// SPDX-License-Identifier: MIT
// The way of a foot in flight from one foothold to the next, and the plane that it follows there. A kernel of the
// stages that choose footholds and hold feet.
#ifndef SOLE_PLACE_WAY_H
#define SOLE_PLACE_WAY_H

#include "place/place.h"

#define SOLE_WAIT_UNTIL 0.25f // share of the time up to which a foot may wait
#define SOLE_LEAD_FROM 0.55f  // from which on it may go ahead

/// From where to where, and how far along.
typedef struct soleWay
{
	soleVec3 from;
	soleVec3 to;
	soleVec3 fromGradient;
	soleVec3 toGradient;
	const float* lift;
} soleWay;

/// Rise per length of a plane, horizontal.
soleVec3 soleGradientOf( const solePlaceWork* work, soleVec3 normal );
/// The way as the state has it.
soleWay soleRememberWay( const solePlaceWork* work, const soleLegWork* leg );
/// Share of the flight's time that is over; that of the last frame where it is foreseen no more.
float soleShareOfTime( const soleLegWork* leg );
/// The plane at a place on the way.
solePlane soleFollowWay( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, soleVec3 place );
/// The least lift that clears what the samples say lies between.
void soleFindLift( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float lift[3] );
/// The same where all that the samples have met between those asked for with the foothold is narrow things: what stands
/// out over both ends.
void soleFindNarrowLift( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way, float lift[3] );
/// How far a foot has to be ahead of the animation near its way's end, as a share of what is left of that: where it
/// comes down behind an edge, its heel would go through that.
float soleFindLead( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way );
/// How far it has to wait behind that when it sets out right before a riser, through which its toes would go.
float soleFindWait( const solePlaceWork* work, const soleLegWork* leg, const soleWay* way );
/// By how much it is ahead, horizontal.
soleVec3 soleLeadWay( const solePlaceWork* work, const soleLegWork* leg );

#endif
