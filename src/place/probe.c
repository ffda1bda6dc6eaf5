// SPDX-License-Identifier: MIT
// Probe: what to ask of the ground.
//
// The probes of a foot stand on its sole as it would lie flat: measured from the ball along the foot's heading, so that
// a raised heel asks for the ground it will come to rest on. A held foot asks where it is held. A foot in flight whose
// next foothold is foreseen asks there: a strip along its heading, as long as the step may be shifted and shorter the
// nearer the foot has come, both sides of the ball, and some places on the way there. One in flight that is not
// foreseen asks under itself and a little ahead of its toes. (The strip is asked for a few times on the way only; in
// between, and right after the foot has left, what lies between those places: a bar that is narrower.) One that has
// just been planted reads its ground closely. Each probe is a vertical segment around the reference height (the clip's
// floor as the root carries it), never around the foot: a foot that is inside a step still finds the step's top. One
// that has stood still for long asks for one place alone, by setting, until what it hears there changes.
#include "place/way.h"

#define FLYING 0.8f           // L/s
#define CHOICE_TIME 0.12f     // s
#define LEFT_TIME 0.02f       // s
#define MEANT_ELSEWHERE 0.02f // L
#define STRIP_TIME 0.24f      // s in which the strip becomes short, until the last choice
#define CLIMB 0.7f            // rise per length: as much further up and down is asked for places ahead of the root
#define KNOWN 0.15f           // L around the ground that a foot stands on
#define STRIP_END 0.05f       // L: at last a third of it is as long as this about each end of the sole

/// How many probes of each kind.
typedef struct soleProbeCounts
{
	int32_t sole;  // under a foot that stands, or flies unforeseen
	int32_t ahead; // of the latter's toes
	int32_t strip; // where a foreseen foot will land
	int32_t sides;
	int32_t way; // there
} soleProbeCounts;

static soleProbeCounts soleGetProbeCounts( soleProbeLayout layout )
{
	switch ( layout )
	{
	case sole_probeQuality:
		return ( soleProbeCounts ){ 18, 2, 25, 2, 5 };
	case sole_probeSingle:
		return ( soleProbeCounts ){ 1, 2, 1, 0, 2 };
	case sole_probeEconomy:
	case sole_probeLayoutForce32:
		break;
	}
	return ( soleProbeCounts ){ 5, 2, 25, 2, 5 };
}

int32_t soleProbesPerLeg( const soleSettings* settings )
{
	soleProbeCounts counts = soleGetProbeCounts( settings->probe.layout );
	int32_t under = soleGetProbeCounts( sole_probeQuality ).sole;
	under = settings->probe.layout == sole_probeSingle ? counts.sole + counts.ahead : under + counts.ahead;
	int32_t there = counts.strip + counts.sides + counts.way;
	return under > there ? under : there;
}

// ------------------------------------------------------------------------------------------------------------- aim

int32_t soleGetLookCount( const soleSettings* settings )
{
	return soleGetProbeCounts( settings->probe.layout ).way;
}

/// Every CHOICE_TIME, counted from a share of it before the foot comes down.
static bool soleIsDue( const solePlaceWork* work, const soleLegWork* leg, float share )
{
	float now = leg->stepInput.until / CHOICE_TIME + share;
	float before = ( leg->stepInput.until + work->timeStep ) / CHOICE_TIME + share;
	return (int32_t)soleMinF( now, 1e6f ) != (int32_t)soleMinF( before, 1e6f );
}

static bool soleHasJustLeft( const solePlaceWork* work, const soleLegWork* leg )
{
	// The first frame asks for the foothold: where frames are long the second one looks.
	float before = leg->stepInput.since - work->timeStep;
	return leg->stepInput.since >= LEFT_TIME && before < soleMaxF( LEFT_TIME, 1.01f * work->timeStep );
}

/// A foothold is chosen anew when the animation means another, and a few times on the way there.
static bool soleIsTimeToChoose( const solePlaceWork* work, const soleLegWork* leg )
{
	soleVec3 moved = soleSub( soleAdd( leg->landing, work->root_w ), leg->state->stepLanding_w );
	return soleIsDue( work, leg, 0.0f ) || soleLength( soleHorizontal( work, moved ) ) > MEANT_ELSEWHERE * leg->length;
}

/// A held foot is where it is held.
static void soleAimHeld( const solePlaceWork* work, soleLegWork* leg, soleVec3 normal )
{
	const soleLegState* state = leg->state;
	soleVec3 held = soleSub( state->lockPoint_w, work->root_w );
	leg->soleForward = soleNormalizeOr( soleHorizontal( work, state->lockForward_w ), work->level );
	float ahead = ( state->flags & sole_stateByHeel ) != 0 ? leg->rig->heelBehind : 0.0f;
	ahead = work->settings->contact.pivot == sole_pivotAnkle ? leg->rig->ankleBehind : ahead;
	float along = soleMakeFootprint( work, held, leg->soleForward, normal ).along;
	leg->soleCenter = soleMulAdd( held, ahead * along, leg->soleForward );
}

static void soleAimFree( const solePlaceWork* work, soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	soleHalf half = soleHalfFromQuarterTan( state->turn.value );
	soleVec3 ball = leg->ball;
	soleVec3 gradient = soleGradientOf( work, state->planeNormal_w );
	bool landing = leg->foreseen == false && leg->contactInput.heel + leg->contactInput.toe > 0.0f;
	if ( leg->foreseen )
	{
		// It leaves with its toes and comes down with its heel, on another plane perhaps.
		soleVec3 byHeel = soleMulAdd( leg->heel, leg->rig->heelBehind * work->rootScale, leg->forward );
		float whole = leg->stepInput.since + leg->stepInput.until;
		float share = whole > 0.0f ? leg->stepInput.since / whole : 1.0f;
		bool planned = ( state->flags & sole_statePlanned ) != 0;
		ball = soleLerp( ball, byHeel, share );
		gradient = planned ? soleLerp( gradient, soleGradientOf( work, state->stepNormal_w ), share ) : gradient;
	}
	// Where a tilted foot stands, by the plane as it was last used; on the first frame none is known, and a foot that
	// is just coming down is on its heel.
	gradient = soleAdd( gradient, state->gradient.value );
	bool tilts = work->first == false && landing == false;
	soleVec3 normal = soleMakePlane( work, ball, gradient ).normal;
	soleVec3 tilt = tilts ? soleTiltShift( work, leg, normal ) : soleVec( 0.0f, 0.0f, 0.0f );
	leg->soleCenter = soleAdd( soleAdd( ball, tilt ), state->slide.value );
	leg->soleForward = soleRotate( soleHalfRotation( work->up, half ), leg->forward );
	leg->tip = soleMulAdd( leg->soleCenter, leg->rig->toeAhead * work->rootScale, leg->soleForward );
}

/// The normal of the plane on which a foot stands, as far as that is known.
static soleVec3 soleKnownNormal( const solePlaceWork* work, const soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	bool coming = ( state->flags & ( sole_statePlanned | sole_stateForeseen ) ) != 0;
	soleVec3 normal = coming ? state->stepNormal_w : state->planeNormal_w;
	return work->first ? work->up : normal;
}

void soleAimSole( solePlaceWork* work, soleLegWork* leg )
{
	const soleLegState* state = leg->state;
	leg->choosing = leg->foreseen && ( ( state->flags & sole_statePlanned ) == 0 || soleIsTimeToChoose( work, leg ) );
	float freeze = work->settings->foothold.freeze;
	leg->looking = leg->foreseen && leg->choosing == false && leg->stepInput.until > freeze &&
	    ( soleIsDue( work, leg, 0.5f ) || soleHasJustLeft( work, leg ) );
	bool closely = work->settings->probe.layout != sole_probeSingle;
	leg->reading = closely && leg->foreseen && ( state->flags & sole_statePlanned ) != 0 &&
	    leg->stepInput.until < freeze && leg->stepInput.until + work->timeStep >= freeze;
	const uint32_t settled = (uint32_t)( sole_stateLocked | sole_stateChosen );
	float sleep = work->settings->probe.sleep;
	leg->asleep = sleep > 0.0f && ( state->flags & settled ) == settled && state->time > sleep;
	leg->flying = ( state->flags & ( sole_stateLocked | sole_stateHeelOn | sole_stateToeOn ) ) == 0 &&
	    leg->ballSpeed > FLYING * leg->length;
	soleVec3 normal = soleKnownNormal( work, leg );
	if ( ( state->flags & sole_stateLocked ) != 0 )
	{
		soleAimHeld( work, leg, normal );
	}
	else
	{
		soleAimFree( work, leg );
	}
	leg->print = soleMakeFootprint( work, leg->soleCenter, leg->soleForward, normal );
}

// ---------------------------------------------------------------------------------------------------------- layouts

typedef struct soleProbePlace
{
	float ahead;    // -1 heel, 0 ball, 1 toe tip
	float sideways; // -1 inner edge, 0 middle, 1 outer edge
} soleProbePlace;

static const soleProbePlace soleEconomyPlaces[] = { { -1.0f, 0.0f }, { -0.5f, 0.0f }, { 0.0f, -0.8f }, { 0.0f, 0.8f },
	{ 1.0f, 0.0f } };
static const soleProbePlace soleSinglePlaces[] = { { 0.0f, 0.0f } };
static const soleProbePlace soleQualityPlaces[] = { { -1.0f, -0.6f }, { -1.0f, 0.6f }, { -0.8f, -0.7f },
	{ -0.8f, 0.7f }, { -0.6f, -0.7f }, { -0.6f, 0.7f }, { -0.4f, -0.75f }, { -0.4f, 0.75f }, { -0.2f, -0.8f },
	{ -0.2f, 0.8f }, { 0.0f, -0.85f }, { 0.0f, 0.85f }, { 0.35f, -0.8f }, { 0.35f, 0.8f }, { 0.7f, -0.7f },
	{ 0.7f, 0.7f }, { 1.0f, -0.5f }, { 1.0f, 0.5f } };

#define QUALITY ( (int32_t)( sizeof soleQualityPlaces / sizeof soleQualityPlaces[0] ) )

static const soleProbePlace* soleChoosePlaces( soleProbeLayout layout )
{
	if ( layout == sole_probeQuality )
	{
		return soleQualityPlaces;
	}
	return layout == sole_probeSingle ? soleSinglePlaces : soleEconomyPlaces;
}

/// A place under a sole.
static soleVec3 soleProbePoint( const soleLegWork* leg, soleFootprint print, soleProbePlace place )
{
	const soleRigLeg* rig = leg->rig;
	float ahead = place.ahead < 0.0f ? place.ahead * rig->heelBehind : place.ahead * rig->toeAhead;
	float sideways = place.sideways < 0.0f ? -place.sideways * rig->innerSide : place.sideways * rig->outerSide;
	soleVec3 p = soleMulAdd( print.ball, ahead * print.along, print.forward );
	return soleMulAdd( p, sideways * print.across, print.side );
}

/// 1: the foot has just set out, 0: its foothold is chosen for the last time. By the number of the choice, not by the
/// time at which a frame happens to make it: the same places are asked at every frame rate.
static float soleIsFar( const soleLegWork* leg )
{
	float number = (float)(int32_t)soleMinF( leg->stepInput.until / CHOICE_TIME, 100.0f );
	return soleSaturate( number * CHOICE_TIME / STRIP_TIME );
}

/// Probe k of count along the strip: evenly over all of it while the foot is far; when it is near, over the sole, most
/// of them about its ends, where an edge matters most.
static soleVec3 soleStripPoint(
    const solePlaceWork* work, const soleLegWork* leg, soleVec3 center, int32_t k, int32_t count )
{
	float far = soleIsFar( leg );
	float heel = -leg->rig->heelBehind * work->rootScale;
	float toe = leg->rig->toeAhead * work->rootScale;
	if ( count < 2 )
	{
		return center;
	}
	float share = (float)k / (float)( count - 1 );
	float beyond = work->settings->foothold.shift * leg->length;
	float even = heel - beyond + share * ( toe - heel + 2.0f * beyond );
	float end = STRIP_END * leg->length;
	float spread = 3.0f * share * end; // of the first third, and of the last
	float near = heel - 0.5f * end + spread;
	if ( 3 * k > 2 * ( count - 1 ) )
	{
		near = toe + 0.5f * end - 3.0f * ( 1.0f - share ) * end;
	}
	else if ( 3 * k > count - 1 )
	{
		near = heel + 0.5f * end + ( 3.0f * share - 1.0f ) * ( toe - heel - end );
	}
	return soleMulAdd( center, near + far * ( even - near ), leg->landingForward );
}

/// Places between where the foot set out and where it goes.
/// @param first the first, in steps between them
static int32_t soleListWay(
    const solePlaceWork* work, const soleLegWork* leg, soleVec3 to, float first, soleVec3* points )
{
	int32_t count = soleGetLookCount( work->settings );
	soleVec3 from = soleSub( leg->state->planePoint_w, work->root_w );
	for ( int32_t k = 0; k < count; ++k )
	{
		points[k] = soleLerp( from, to, ( (float)k + first ) / (float)( count + 1 ) );
	}
	return count;
}

/// Where the probes of a foot ask that will land somewhere: a strip there, both sides of the ball, the way.
static int32_t soleListLanding( const solePlaceWork* work, const soleLegWork* leg, soleVec3* points )
{
	soleProbeCounts counts = soleGetProbeCounts( work->settings->probe.layout );
	bool planned = ( leg->state->flags & sole_statePlanned ) != 0;
	soleVec3 chosen = planned ? soleLevelPlace( work, leg ) : leg->landing;
	// As long as it is far off, what the animation means counts; then what was chosen.
	float far = soleIsFar( leg );
	// As far beside what was chosen as the animation means another place since then.
	soleVec3 meant = soleSub( leg->state->stepLanding_w, work->root_w );
	soleVec3 near = planned ? soleAdd( chosen, soleHorizontal( work, soleSub( leg->landing, meant ) ) ) : chosen;
	soleVec3 center = soleLerp( near, leg->landing, far );
	int32_t count = 0;
	for ( int32_t k = 0; k < counts.strip; ++k )
	{
		points[count++] = soleStripPoint( work, leg, center, k, counts.strip );
	}
	soleFootprint print = soleMakeFootprint( work, chosen, leg->landingForward, work->up );
	for ( int32_t k = 0; k < counts.sides; ++k )
	{
		points[count++] = soleProbePoint( leg, print, ( soleProbePlace ){ 0.0f, k == 0 ? -0.8f : 0.8f } );
	}
	return count + soleListWay( work, leg, chosen, 1.0f, points + count );
}

/// Half-way between the places on the way that are asked for with the foothold: a bar may lie there.
static int32_t soleListNarrow( const solePlaceWork* work, const soleLegWork* leg, soleVec3* points )
{
	return soleListWay( work, leg, soleLevelPlace( work, leg ), 0.5f, points );
}

/// Places under a sole.
static int32_t soleListPlaces(
    const soleLegWork* leg, soleFootprint print, const soleProbePlace* places, int32_t count, soleVec3* points )
{
	for ( int32_t k = 0; k < count; ++k )
	{
		points[k] = soleProbePoint( leg, print, places[k] );
	}
	return count;
}

/// Under a foot that stands, or flies unforeseen; then also ahead of its toes.
static int32_t soleListSole( const solePlaceWork* work, const soleLegWork* leg, soleVec3* points )
{
	soleProbeLayout layout = work->settings->probe.layout;
	// A foot that has just been planted reads its ground closely, once; as do all in the first frame.
	bool closely = work->first || ( leg->state->flags & ( sole_stateLocked | sole_stateChosen ) ) == sole_stateLocked;
	layout = closely && layout == sole_probeEconomy ? sole_probeQuality : layout;
	soleProbeCounts counts = soleGetProbeCounts( layout );
	int32_t count = soleListPlaces( leg, leg->print, soleChoosePlaces( layout ), counts.sole, points );
	for ( int32_t k = 0; k < counts.ahead && leg->flying; ++k )
	{
		float time = work->settings->support.lookAhead * (float)( k + 1 ) / (float)counts.ahead;
		points[count++] = soleMulAdd( leg->tip, time, leg->ballVelocity );
	}
	return count;
}

/// Where the probes of a leg ask. @return how many there are
static int32_t soleListPoints( const solePlaceWork* work, const soleLegWork* leg, soleVec3* points )
{
	if ( leg->usable == false )
	{
		return 0;
	}
	if ( soleGoesByTicks( work ) )
	{
		points[0] = leg->soleCenter;
		return work->ticks ? 1 : 0;
	}
	if ( leg->reading )
	{
		return soleListPlaces( leg, soleChosenFootprint( work, leg ), soleQualityPlaces, QUALITY, points );
	}
	if ( leg->foreseen )
	{
		return leg->choosing ? soleListLanding( work, leg, points )
		                     : ( leg->looking ? soleListNarrow( work, leg, points ) : 0 );
	}
	return leg->asleep ? soleListPlaces( leg, leg->print, soleSinglePlaces, 1, points )
	                   : soleListSole( work, leg, points );
}

/// How much higher a place is, if the slope goes on on which the foot stood last.
static float soleFindRise( const solePlaceWork* work, const soleLegWork* leg, soleVec3 point )
{
	soleVec3 normal = leg->state->planeNormal_w;
	float up = soleDot( normal, work->up );
	bool foreseen = leg->foreseen && up > 0.1f;
	return foreseen ? -soleDot( soleHorizontal( work, normal ), point ) / up : 0.0f;
}

/// How far over the reference height a foot stands, or has come down: a step of two treads may be further than
/// stepUp from a root that has not followed yet, and is asked for nevertheless.
static float soleFindKnownHeight( const solePlaceWork* work, const soleLegWork* leg )
{
	bool stands = work->first == false && leg->foreseen == false && leg->flying == false;
	return stands ? soleDot( soleSub( leg->state->planePoint_w, work->root_w ), work->up ) - work->reference : 0.0f;
}

soleProbe soleMakeProbe( const solePlaceWork* work, const soleLegWork* leg )
{
	return ( soleProbe ){
		.direction_w = soleNeg( work->up ), .mask = work->settings->probe.mask, .leg = (int16_t)leg->index
	};
}

int32_t soleAskGround( const solePlaceWork* work, const soleLegWork* leg, soleProbe* probes, int32_t capacity )
{
	const soleSettings* settings = work->settings;
	soleVec3 points[SOLE_MAX_PROBES_PER_LEG];
	int32_t count = soleListPoints( work, leg, points );
	float known = soleFindKnownHeight( work, leg );
	float upwards = soleMaxF( settings->probe.stepUp * leg->length, known + KNOWN * leg->length );
	float downwards = soleMaxF( settings->probe.stepDown * leg->length, KNOWN * leg->length - known );
	soleProbe asked = soleMakeProbe( work, leg );
	asked.radius = settings->probe.shape == sole_probeSphere ? settings->probe.radius * leg->length : 0.0f;
	for ( int32_t k = 0; k < soleMinI( count, capacity ); ++k )
	{
		soleProbe* probe = probes + k;
		*probe = asked;
		probe->index = (int16_t)k;
		float away = soleLength( soleHorizontal( work, points[k] ) );
		float further = CLIMB * soleMaxF( away - 0.5f * leg->length, 0.0f );
		float up = upwards + further;
		float height = work->reference + soleFindRise( work, leg, points[k] ) + up;
		probe->start_w = soleAdd( soleAtHeight( work, points[k], height ), work->root_w );
		probe->length = up + ( downwards + further );
	}
	return count;
}
