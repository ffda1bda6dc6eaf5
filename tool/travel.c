// SPDX-License-Identifier: MIT
// How a clip travels: finds root motion and takes it out of the pose, such that root * pose is the clip's own pose.
//
// The root moves along the floor and turns about up: a plane motion. With the floor as complex plane, forward real and
// up x forward imaginary, it takes a point p to place + exp( i turn ) p. The frame F(t) of the node that travels is its
// place on the floor and its heading against time 0; the root is F(t) F(0)^-1, identity at time 0.
//   own     F as sampled: a root bone that keeps its height moves the character by itself
//   steady  F(t) on the arc (a line where nothing turns) of constant speed from F(0) to F(end): pelvis of a loop
//   smooth  F averaged over half a second, less near the ends so that both stay where they are: pelvis of a capture
// After the end of a round the next begins where it led to.
#include "motion.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979
#define SMOOTH_HALF_WINDOW 0.25 // s
#define SMOOTH_SAMPLES 32
#define MOTION_TRANSFORMS 4000000 // most that are sampled to find stride and floor
#define LEAST_TURN ( 10.0 * PI / 180.0 )
#define LOOP_TOLERANCE 0.12   // of leg length: further than this from start to end is no loop
#define CLOSED_TOLERANCE 1e-5 // of leg length: what is nearer is rounding, even in a third difference

typedef struct toolComplex
{
	double re;
	double im;
} toolComplex;

typedef struct toolPlaneMotion
{
	toolComplex place;
	double turn;
} toolPlaneMotion;

// The plane and what is sampled on it.
typedef struct toolTracker
{
	const toolCharacter* character;
	const toolBoundClip* bound;
	int32_t source;
	bool turns;
	soleVec3 up;
	soleVec3 ahead;
	soleVec3 side;
	soleQuat startInverse; // of the source's rotation at time 0
} toolTracker;

static toolComplex toolMulComplex( toolComplex a, toolComplex b )
{
	return ( toolComplex ){ a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re };
}

static toolComplex toolDivComplex( toolComplex a, toolComplex b )
{
	double d = b.re * b.re + b.im * b.im;
	return ( toolComplex ){ ( a.re * b.re + a.im * b.im ) / d, ( a.im * b.re - a.re * b.im ) / d };
}

static toolComplex toolPhase( double angle )
{
	return ( toolComplex ){ cos( angle ), sin( angle ) };
}

static toolPlaneMotion toolMulPlane( toolPlaneMotion a, toolPlaneMotion b )
{
	toolComplex p = toolMulComplex( toolPhase( a.turn ), b.place );
	return ( toolPlaneMotion ){ { a.place.re + p.re, a.place.im + p.im }, a.turn + b.turn };
}

static toolPlaneMotion toolInvertPlane( toolPlaneMotion m )
{
	toolComplex p = toolMulComplex( toolPhase( -m.turn ), m.place );
	return ( toolPlaneMotion ){ { -p.re, -p.im }, -m.turn };
}

// ( exp( i a share ) - 1 ) / ( exp( i a ) - 1 ): the share of an arc's chord after a share of its angle, or, with whole
// shares, the sum of as many rounds.
static toolComplex toolArcShare( double angle, double share )
{
	if ( fabs( angle ) < 1e-6 )
	{
		return ( toolComplex ){ share, 0.0 };
	}
	toolComplex part = toolPhase( angle * share );
	toolComplex whole = toolPhase( angle );
	part.re -= 1.0;
	whole.re -= 1.0;
	return toolDivComplex( part, whole );
}

// The same motion a share of the way, or several times over.
static toolPlaneMotion toolPowerPlane( toolPlaneMotion m, double share )
{
	return ( toolPlaneMotion ){ toolMulComplex( toolArcShare( m.turn, share ), m.place ), m.turn * share };
}

static soleTransform toolPlaneTransform( const toolTracker* tracker, toolPlaneMotion m )
{
	soleTransform t = soleTransform_Identity();
	t.translation =
	    soleAdd( soleScale( (float)m.place.re, tracker->ahead ), soleScale( (float)m.place.im, tracker->side ) );
	soleVec3 axis = soleScale( (float)sin( 0.5 * m.turn ), tracker->up );
	t.rotation = ( soleQuat ){ axis.x, axis.y, axis.z, (float)cos( 0.5 * m.turn ) };
	return t;
}

static toolTracker toolMakeTracker(
    const toolCharacter* character, const toolBoundClip* bound, int32_t source, bool turns )
{
	toolTracker tracker = { .character = character, .bound = bound, .source = source, .turns = turns };
	tracker.up = soleNormalizeOr( character->rigDef.up, soleVec( 0.0f, 1.0f, 0.0f ) );
	soleVec3 flat = soleReject( character->rigDef.forward, tracker.up );
	tracker.ahead = soleNormalizeOr( flat, soleAnyOrthogonal( tracker.up ) );
	tracker.side = soleCross( tracker.up, tracker.ahead );
	tracker.startInverse = soleConjugate( toolSampleNode( character, bound, 0.0f, source ).rotation );
	return tracker;
}

// Angle about up of the turn since time 0, in ( -pi, pi ].
static double toolHeadingOf( const toolTracker* tracker, soleQuat rotation )
{
	soleQuat turn = soleMulQuat( rotation, tracker->startInverse );
	double sine = (double)soleDot( soleVec( turn.x, turn.y, turn.z ), tracker->up );
	double angle = 2.0 * atan2( sine, (double)turn.w );
	return angle > PI ? angle - 2.0 * PI : ( angle <= -PI ? angle + 2.0 * PI : angle );
}

static toolPlaneMotion toolFrameAt( const toolTracker* tracker, double time )
{
	soleTransform world = toolSampleNode( tracker->character, tracker->bound, (float)time, tracker->source );
	toolPlaneMotion frame = { { (double)soleDot( world.translation, tracker->ahead ),
		                          (double)soleDot( world.translation, tracker->side ) },
		0.0 };
	frame.turn = tracker->turns ? toolHeadingOf( tracker, world.rotation ) : 0.0;
	return frame;
}

static toolPlaneMotion toolSmoothFrameAt( const toolTracker* tracker, double time )
{
	double room = fmin( time, (double)tracker->bound->duration - time );
	double half = fmin( SMOOTH_HALF_WINDOW, fmax( room, 0.0 ) );
	toolPlaneMotion sum = { { 0.0, 0.0 }, 0.0 };
	toolComplex heading = { 0.0, 0.0 };
	for ( int i = 0; i < SMOOTH_SAMPLES; ++i )
	{
		double share = 2.0 * ( (double)i + 0.5 ) / SMOOTH_SAMPLES - 1.0;
		toolPlaneMotion frame = toolFrameAt( tracker, time + share * half );
		toolComplex phase = toolPhase( frame.turn );
		sum.place.re += frame.place.re / SMOOTH_SAMPLES;
		sum.place.im += frame.place.im / SMOOTH_SAMPLES;
		heading.re += phase.re;
		heading.im += phase.im;
	}
	sum.turn = tracker->turns ? atan2( heading.im, heading.re ) : 0.0;
	return sum;
}

// What the root has done since the start of the round.
static toolPlaneMotion toolRootAt( const toolTracker* tracker, toolTravelKind kind, double time )
{
	double duration = (double)tracker->bound->duration;
	toolPlaneMotion start = toolInvertPlane( toolFrameAt( tracker, 0.0 ) );
	switch ( kind )
	{
	case tool_travelOwn:
		return toolMulPlane( toolFrameAt( tracker, time ), start );
	case tool_travelSteady:
	{
		toolPlaneMotion round = toolMulPlane( toolFrameAt( tracker, duration ), start );
		return duration > 0.0 ? toolPowerPlane( round, time / duration ) : ( toolPlaneMotion ){ 0 };
	}
	case tool_travelSmooth:
		return toolMulPlane( toolSmoothFrameAt( tracker, time ), start );
	case tool_travelNone:
		break;
	}
	return ( toolPlaneMotion ){ 0 };
}

// ------------------------------------------------------------------------------------------------------- finding

// What a node does in the course of a clip. Lengths in character space.
typedef struct toolExcursion
{
	double net;      // along the floor, from start to end
	double furthest; // from the start
	double heights;  // highest less lowest
	double drop;     // start or end less lowest, whichever is more
	double netTurn;
	double mostTurn;
} toolExcursion;

static toolExcursion toolFindExcursion( const toolTracker* tracker )
{
	toolExcursion e = { 0 };
	double duration = (double)tracker->bound->duration;
	int count = duration < 204.0 ? 32 + (int)( duration * 10.0 ) : 2072;
	toolPlaneMotion start = toolFrameAt( tracker, 0.0 );
	double startHeight = 0.0;
	double endHeight = 0.0;
	double low = HUGE_VAL;
	double high = -HUGE_VAL;
	for ( int i = 0; i <= count; ++i )
	{
		float time = (float)( duration * (double)i / (double)count );
		soleTransform world = toolSampleNode( tracker->character, tracker->bound, time, tracker->source );
		double height = (double)soleDot( world.translation, tracker->up );
		double dx = (double)soleDot( world.translation, tracker->ahead ) - start.place.re;
		double dz = (double)soleDot( world.translation, tracker->side ) - start.place.im;
		startHeight = i == 0 ? height : startHeight;
		endHeight = height;
		low = fmin( low, height );
		high = fmax( high, height );
		e.net = sqrt( dx * dx + dz * dz );
		e.furthest = fmax( e.furthest, e.net );
		e.netTurn = fabs( toolHeadingOf( tracker, world.rotation ) );
		e.mostTurn = fmax( e.mostTurn, e.netTurn );
	}
	e.heights = high - low;
	e.drop = fmax( startHeight, endHeight ) - low;
	return e;
}

double toolLegLength( const toolCharacter* character )
{
	double longest = 0.0;
	for ( int32_t i = 0; i < character->rigDef.legCount; ++i )
	{
		const soleLegDef* leg = character->rigDef.legs + i;
		double length = 0.0;
		soleVec3 last = toolPoseWorld( character, character->bindPose, leg->joints[0] ).translation;
		for ( int32_t j = 1; j < leg->jointCount; ++j )
		{
			soleVec3 next = toolPoseWorld( character, character->bindPose, leg->joints[j] ).translation;
			length += (double)soleDistance( last, next );
			last = next;
		}
		length += leg->hasVirtualAnkle ? (double)soleDistance( last, leg->virtualAnkle ) : 0.0;
		longest = fmax( longest, length );
	}
	return longest > 0.0 ? longest : 1.0;
}

// The furthest that a leg joint is from one pose to another, the first moved along the floor.
static double toolComparePoses(
    const toolCharacter* character, const soleTransform* from, soleTransform motion, const soleTransform* to )
{
	double worst = 0.0;
	for ( int32_t i = 0; i < character->rigDef.legCount; ++i )
	{
		const soleLegDef* leg = character->rigDef.legs + i;
		for ( int32_t j = 0; j < leg->jointCount; ++j )
		{
			soleVec3 a = toolPoseWorld( character, from, leg->joints[j] ).translation;
			soleVec3 b = toolPoseWorld( character, to, leg->joints[j] ).translation;
			worst = fmax( worst, (double)soleDistance( soleTransformPoint( motion, a ), b ) );
		}
	}
	return worst;
}

// Is the pose at the end that of the start, moved along the floor? It may be one frame before it, for many loops are
// written without the frame that repeats the first.
static void toolFindLoop(
    const toolCharacter* character, const toolBoundClip* bound, double legLength, toolTravel* travel )
{
	toolTracker tracker = toolMakeTracker( character, bound, character->rigDef.pelvis, true );
	double duration = (double)bound->duration;
	double frame = fmin( 1.0 / (double)travel->frameRate, duration );
	size_t joints = (size_t)character->jointCount;
	soleTransform* poses = toolAlloc( 3 * joints, sizeof *poses );
	toolSampleClip( character, bound, 0.0f, poses );
	toolSampleClip( character, bound, (float)( duration - frame ), poses + joints );
	toolSampleClip( character, bound, bound->duration, poses + 2 * joints );
	toolPlaneMotion start = toolInvertPlane( toolFrameAt( &tracker, 0.0 ) );
	toolPlaneMotion round = toolMulPlane( toolFrameAt( &tracker, duration ), start );
	soleTransform motion = toolPlaneTransform( &tracker, round );
	double apart = toolComparePoses( character, poses, motion, poses + 2 * joints );
	double step = toolComparePoses( character, poses + joints, soleTransform_Identity(), poses + 2 * joints );
	free( poses );
	travel->loops = apart <= fmax( LOOP_TOLERANCE * legLength, 1.5 * step );
	travel->closed = apart <= CLOSED_TOLERANCE * legLength;
}

static bool toolIsAncestor( const toolCharacter* character, int32_t ancestor, int32_t node )
{
	while ( node != SOLE_NONE && node != ancestor )
	{
		node = character->parents[node];
	}
	return node == ancestor;
}

// Does everything that stands on the ground hang from this node?
static bool toolCarriesAllFeet( const toolCharacter* character, int32_t node )
{
	for ( int32_t i = 0; i < character->rigDef.legCount; ++i )
	{
		const soleLegDef* leg = character->rigDef.legs + i;
		if ( toolIsAncestor( character, node, leg->joints[0] ) == false ||
		    ( leg->detachedFoot != SOLE_NONE && toolIsAncestor( character, node, leg->detachedFoot ) == false ) )
		{
			return false;
		}
	}
	return true;
}

// The node itself, or the first above it that all feet hang from.
static int32_t toolFindCarrier( const toolCharacter* character, int32_t node )
{
	for ( int32_t i = node; i != SOLE_NONE; i = character->parents[i] )
	{
		if ( toolCarriesAllFeet( character, i ) )
		{
			return i;
		}
	}
	return node;
}

// Decides whether and how the tracker's node travels.
static bool toolDoesTravel( const toolTracker* tracker, double legLength, toolTravel* travel )
{
	toolExcursion e = toolFindExcursion( tracker );
	bool pelvis = tracker->source == tracker->character->rigDef.pelvis;
	if ( e.heights < 0.01 * legLength && pelvis == false )
	{
		travel->kind = tool_travelOwn;
		travel->turns = e.mostTurn > 0.03;
		return e.net > 0.05 * legLength || e.furthest > 0.25 * legLength || e.netTurn > LEAST_TURN;
	}
	// A body that falls, sits down or rises comes to be elsewhere without having travelled.
	bool far = e.net - 2.0 * e.drop > 0.25 * legLength;
	bool around = travel->loops == false && e.furthest - 2.0 * e.drop > 0.75 * legLength;
	travel->kind = far && travel->loops ? tool_travelSteady : tool_travelSmooth;
	travel->turns = e.netTurn > LEAST_TURN || e.mostTurn > 4.0 * LEAST_TURN;
	return far || around;
}

// The topmost node from the pelvis up that travels is the one that the clip moves the character by.
static void toolFindRootMotion(
    const toolCharacter* character, const toolBoundClip* bound, double legLength, toolTravel* travel )
{
	toolTravel found = *travel;
	for ( int32_t i = character->rigDef.pelvis; i != SOLE_NONE; i = character->parents[i] )
	{
		toolTravel attempt = *travel;
		toolTracker tracker = toolMakeTracker( character, bound, i, false );
		if ( toolDoesTravel( &tracker, legLength, &attempt ) )
		{
			attempt.rootMotion = true;
			attempt.source = i;
			attempt.node = i;
			found = attempt;
		}
	}
	if ( found.rootMotion == false )
	{
		return;
	}
	found.node = toolFindCarrier( character, found.source );
	toolTracker tracker = toolMakeTracker( character, bound, found.source, found.turns );
	toolPlaneMotion round = toolRootAt( &tracker, found.kind, (double)bound->duration );
	found.loop = toolPlaneTransform( &tracker, round );
	found.strideVelocity = soleScale( 1.0f / bound->duration, found.loop.translation );
	*travel = found;
}

// Keys per second: of the channel that has most.
static float toolFindFrameRate( const toolBoundClip* bound )
{
	double best = 0.0;
	for ( int32_t i = 0; i < bound->clip->channelCount; ++i )
	{
		const toolChannel* channel = bound->clip->channels + i;
		if ( bound->nodes[i] != SOLE_NONE && channel->keyCount > 1 )
		{
			double span = (double)channel->times[channel->keyCount - 1] - (double)channel->times[0];
			best = fmax( best, span > 0.0 ? (double)( channel->keyCount - 1 ) / span : 0.0 );
		}
	}
	double whole = floor( best + 0.5 );
	best = fabs( best - whole ) < 0.01 * whole ? whole : best;
	return (float)( best < 10.0 ? 30.0 : fmin( best, 240.0 ) );
}

// Stride and floor, from one round of the clip.
static void toolFindStrideAndFloor( const toolCharacter* character, const toolBoundClip* bound, toolTravel* travel )
{
	if ( character->rig == NULL )
	{
		return;
	}
	double wanted = ceil( (double)bound->duration * (double)travel->frameRate ) + 1.0;
	int32_t count = (int32_t)fmin( wanted, (double)( MOTION_TRANSFORMS / character->jointCount ) );
	size_t joints = (size_t)character->jointCount;
	soleTransform* poses = toolAlloc( (size_t)count * joints, sizeof *poses );
	soleTransform* roots = toolAlloc( (size_t)count, sizeof *roots );
	for ( int32_t i = 0; i < count; ++i )
	{
		// The end belongs to this round.
		double time = fmin( (double)i / (double)travel->frameRate, (double)bound->duration * ( 1.0 - 1e-6 ) );
		toolSampleLooped( character, bound, travel, time, poses + (size_t)i * joints, roots + i );
	}
	soleMotion motion = {
		.rig = character->rig,
		.frameCount = count,
		.frameRate = travel->frameRate,
		.poses = poses,
		.roots = roots,
		.up = soleNormalizeOr( character->rigDef.up, soleVec( 0.0f, 1.0f, 0.0f ) ),
	};
	if ( travel->rootMotion == false )
	{
		travel->strideVelocity = soleFindStrideVelocity( &motion );
	}
	travel->clipFloor = soleFindClipFloor( &motion );
	free( poses );
	free( roots );
}

toolTravel toolFindTravel( const toolCharacter* character, const toolBoundClip* bound )
{
	toolTravel travel = { .node = character->travel, .source = SOLE_NONE, .loop = soleTransform_Identity() };
	double legLength = toolLegLength( character );
	travel.frameRate = toolFindFrameRate( bound );
	if ( bound->duration > 0.0f )
	{
		toolFindLoop( character, bound, legLength, &travel );
		toolFindRootMotion( character, bound, legLength, &travel );
	}
	if ( travel.rootMotion == false )
	{
		bool none = character->travel == SOLE_NONE;
		travel.node = toolFindCarrier( character, none ? character->rigDef.pelvis : character->travel );
	}
	toolFindStrideAndFloor( character, bound, &travel );
	return travel;
}

// ------------------------------------------------------------------------------------------------------ sampling

toolRoundTime toolFindRound( const toolBoundClip* bound, const toolTravel* travel, double time )
{
	double duration = (double)bound->duration;
	toolRoundTime t = { 0.0, 0.0 };
	t.rounds = duration > 0.0 && time > 0.0 ? floor( time / duration + 1e-9 ) : 0.0;
	t.rest = time - t.rounds * duration;
	if ( travel->loops == false && t.rounds >= 1.0 && t.rest < 1e-6 )
	{
		// The end of a clip that does not loop is its last pose, not its first.
		t.rounds -= 1.0;
		t.rest = duration;
	}
	t.rest = fmin( fmax( t.rest, 0.0 ), duration );
	return t;
}

static toolPlaneMotion toolRootAfter(
    const toolTracker* tracker, toolTravelKind kind, toolRoundTime time, toolPlaneMotion inRound )
{
	if ( time.rounds < 1.0 )
	{
		return inRound;
	}
	toolPlaneMotion round = toolRootAt( tracker, kind, (double)tracker->bound->duration );
	return toolMulPlane( toolPowerPlane( round, time.rounds ), inRound );
}

soleTransform toolSampleRoot(
    const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel, double time )
{
	if ( travel->rootMotion == false )
	{
		return soleTransform_Identity();
	}
	toolTracker tracker = toolMakeTracker( character, bound, travel->source, travel->turns );
	toolRoundTime t = toolFindRound( bound, travel, time );
	toolPlaneMotion inRound = toolRootAt( &tracker, travel->kind, t.rest );
	return toolPlaneTransform( &tracker, toolRootAfter( &tracker, travel->kind, t, inRound ) );
}

void toolSampleLooped( const toolCharacter* character, const toolBoundClip* bound, const toolTravel* travel,
    double time, soleTransform* pose, soleTransform* root )
{
	toolRoundTime t = toolFindRound( bound, travel, time );
	toolSampleClip( character, bound, (float)t.rest, pose );
	*root = soleTransform_Identity();
	if ( travel->rootMotion == false )
	{
		return;
	}
	toolTracker tracker = toolMakeTracker( character, bound, travel->source, travel->turns );
	toolPlaneMotion inRound = toolRootAt( &tracker, travel->kind, t.rest );
	toolMovePose( character, pose, travel->node, toolPlaneTransform( &tracker, toolInvertPlane( inRound ) ) );
	*root = toolPlaneTransform( &tracker, toolRootAfter( &tracker, travel->kind, t, inRound ) );
}
