// SPDX-License-Identifier: MIT
// Moves a character's root over ground: along a path by arc length, heading after the path, height as a character
// controller's. All in the world of the ground, metres, Y up.
//
// What the walker knows grows in ticks of fixed length; a frame between two ticks is one shorter step from the last of
// them. So the root at a time depends on that time alone, not on the frames that were asked for before it.
#include "walker.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979
#define TICK ( 1.0 / 480.0 )
#define GRAVITY 9.81
#define TURN_RATE PI              // rad/s
#define STANDING_SPEED 0.1f       // m/s; slower strides are none
#define ONCE_SPEED 0.5f           // m/s; nor are these in a clip that does not loop
#define BOTTOMLESS_TIME 0.2       // s of fall without any ground below until the path is said to leave the ground
#define DEEP 1000.0               // m; looked for ground further than the box around it, for planes have none
#define LONGEST_WALK 3600.0       // s
#define FIRST_BEND ( PI / 180.0 ) // rad; less is a straight path

typedef struct toolWalkState
{
	double time;
	double facing; // rad about +Y
	double height;
	double fallSpeed; // m/s downwards
	bool falling;
	toolPlace fallStart;
	double bottomless; // s that it has been falling over no ground at all
} toolWalkState;

// The path with its lengths, and what else stays the same during a walk.
typedef struct toolWalker
{
	const toolWalkDef* def;
	int32_t count;
	toolPlace* places;
	double* lengths; // from the start to each place
	bool bends;
	double side; // angle from the character's forward to its stride, rad
	double speed;
	double rate;
	double step;      // m
	double lift;      // of the character's origin over the ground, m
	soleQuat upright; // character space to Y up, forward along +Z
} toolWalker;

bool toolCrossesSeam( const toolBoundClip* bound, const toolTravel* travel, double before, double after )
{
	return travel->closed == false &&
	    toolFindRound( bound, travel, after ).rounds > toolFindRound( bound, travel, before ).rounds;
}

toolWalkDef toolDefaultWalkDef( void )
{
	return ( toolWalkDef ){ .groundName = "ground", .fps = 60.0 };
}

// --------------------------------------------------------------------------------------------------------- ground

// Height of the first surface below a point, at most so far down.
static bool toolLookDown( const soleGround* ground, double x, double y, double z, double depth, double* height )
{
	soleProbe probe = {
		.start_w = soleVec( (float)x, (float)y, (float)z ),
		.direction_w = soleVec( 0.0f, -1.0f, 0.0f ),
		.length = (float)depth,
		.mask = UINT32_MAX,
	};
	soleHit hit = soleCastProbe( ground, &probe );
	*height = (double)hit.point_w.y;
	return hit.hit;
}

// How far down from a height ground can be at all.
static double toolGetDepth( const soleGround* ground, double height )
{
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	double bottom = lower.y <= upper.y ? (double)lower.y : 0.0;
	return fmax( height - bottom, 0.0 ) + DEEP;
}

bool toolFindGround( const soleGround* ground, const char* groundName, toolPlace* place, toolError* error )
{
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	double top = lower.y <= upper.y ? (double)upper.y + 1.0 : DEEP;
	// A hair above, so that a surface at y itself is found.
	double from = isnan( place->y ) ? top : place->y + 1e-3;
	double height;
	if ( toolLookDown( ground, place->x, from, place->z, toolGetDepth( ground, from ), &height ) == false )
	{
		return toolFail( error, "%s: no ground at x=%.3f, z=%.3f: the ground spans x %.3f to %.3f, z %.3f to %.3f",
		    groundName, place->x, place->z, (double)lower.x, (double)upper.x, (double)lower.z, (double)upper.z );
	}
	place->y = height;
	return true;
}

// ----------------------------------------------------------------------------------------------------------- path

static double toolSegmentHeading( toolPlace a, toolPlace b )
{
	return atan2( b.x - a.x, b.z - a.z );
}

static double toolWrapAngle( double angle )
{
	return angle - 2.0 * PI * floor( ( angle + PI ) / ( 2.0 * PI ) );
}

// Drops places that repeat the one before and sums up lengths.
static void toolLayPath( toolWalker* walker, double distance )
{
	const toolWalkDef* def = walker->def;
	walker->places = toolAlloc( (size_t)def->pathCount + 1, sizeof *walker->places );
	walker->lengths = toolAlloc( (size_t)def->pathCount + 1, sizeof *walker->lengths );
	for ( int32_t i = 0; i < def->pathCount; ++i )
	{
		toolPlace place = def->path[i];
		int32_t n = walker->count;
		double length = n > 0 ? hypot( place.x - walker->places[n - 1].x, place.z - walker->places[n - 1].z ) : 0.0;
		if ( n == 0 || length > 1e-6 )
		{
			walker->places[n] = place;
			walker->lengths[n] = n > 0 ? walker->lengths[n - 1] + length : 0.0;
			walker->count = n + 1;
		}
	}
	if ( walker->count == 1 )
	{
		// Straight on; at least something to take a heading from.
		double heading = def->heading * PI / 180.0;
		double length = distance > 0.0 ? distance : 1.0;
		toolPlace start = walker->places[0];
		walker->places[1] =
		    ( toolPlace ){ start.x + length * sin( heading ), (double)NAN, start.z + length * cos( heading ) };
		walker->lengths[1] = distance > 0.0 ? distance : 0.0;
		walker->count = 2;
	}
	double first = toolSegmentHeading( walker->places[0], walker->places[1] );
	for ( int32_t i = 1; i + 1 < walker->count; ++i )
	{
		double next = toolSegmentHeading( walker->places[i], walker->places[i + 1] );
		walker->bends = walker->bends || fabs( toolWrapAngle( next - first ) ) > FIRST_BEND;
	}
}

// The place at an arc length, straight on before the start and after the end, and the heading there.
static toolPlace toolFollowPath( const toolWalker* walker, double s, double* heading )
{
	int32_t i = 0;
	while ( i + 2 < walker->count && s >= walker->lengths[i + 1] )
	{
		++i;
	}
	*heading = toolSegmentHeading( walker->places[i], walker->places[i + 1] );
	double along = s - walker->lengths[i];
	toolPlace from = walker->places[i];
	return ( toolPlace ){ from.x + along * sin( *heading ), (double)NAN, from.z + along * cos( *heading ) };
}

// Where the root is over the floor plan at a time, and where it wants to face.
static toolPlace toolPlaceAt( const toolWalker* walker, double time, double* facing )
{
	const toolWalkDef* def = walker->def;
	double heading;
	if ( def->travel->rootMotion == false )
	{
		toolPlace place = toolFollowPath( walker, walker->speed * time, &heading );
		*facing = heading - walker->side;
		return place;
	}
	soleTransform root = toolSampleRoot( def->character, def->bound, def->travel, time * walker->rate );
	soleVec3 moved = soleRotate( walker->upright, root.translation );
	bool follow = walker->bends && def->travel->turns == false;
	toolPlace place = toolFollowPath( walker, follow ? (double)moved.z : 0.0, &heading );
	double ahead = follow ? 0.0 : (double)moved.z;
	double aside = (double)moved.x;
	*facing = heading;
	place.x += ahead * sin( heading ) + aside * cos( heading );
	place.z += ahead * cos( heading ) - aside * sin( heading );
	return place;
}

// --------------------------------------------------------------------------------------------------------- height

static void toolFall( const toolWalker* walker, toolWalkState* state, toolPlace place, double dt )
{
	const soleGround* ground = walker->def->ground;
	double drop = state->fallSpeed * dt + 0.5 * GRAVITY * dt * dt;
	state->fallSpeed += GRAVITY * dt;
	double height;
	double from = state->height + walker->step;
	if ( toolLookDown( ground, place.x, from, place.z, walker->step + drop, &height ) )
	{
		state->falling = false;
		state->height = height;
		state->fallSpeed = 0.0;
		state->bottomless = 0.0;
		return;
	}
	bool below = toolLookDown( ground, place.x, from, place.z, toolGetDepth( ground, from ), &height );
	state->bottomless = below ? 0.0 : state->bottomless + dt;
	state->height -= drop;
}

static void toolAdvance( const toolWalker* walker, toolWalkState* state, double dt )
{
	state->time += dt;
	double wanted;
	toolPlace place = toolPlaceAt( walker, state->time, &wanted );
	double turn = toolWrapAngle( wanted - state->facing );
	double most = TURN_RATE * dt;
	state->facing += fmin( fmax( turn, -most ), most );
	double height;
	double from = state->height + walker->step;
	if ( state->falling )
	{
		toolFall( walker, state, place, dt );
	}
	else if ( toolLookDown( walker->def->ground, place.x, from, place.z, 2.0 * walker->step, &height ) )
	{
		state->height = height;
	}
	else
	{
		state->falling = true;
		state->fallSpeed = 0.0;
		state->fallStart = place;
		toolFall( walker, state, place, dt );
	}
}

static soleTransform toolMakeRoot( const toolWalker* walker, const toolWalkState* state )
{
	const toolWalkDef* def = walker->def;
	double ignored;
	toolPlace place = toolPlaceAt( walker, state->time, &ignored );
	soleTransform root = soleTransform_Identity();
	soleQuat heading = { 0.0f, (float)sin( 0.5 * state->facing ), 0.0f, (float)cos( 0.5 * state->facing ) };
	root.rotation = soleMulQuat( heading, walker->upright );
	if ( def->travel->rootMotion )
	{
		soleTransform own = toolSampleRoot( def->character, def->bound, def->travel, state->time * walker->rate );
		root.rotation = soleMulQuat( root.rotation, own.rotation );
	}
	root.rotation = soleNormalizeQuat( root.rotation );
	root.translation = soleVec( (float)place.x, (float)( state->height + walker->lift ), (float)place.z );
	return root;
}

// ----------------------------------------------------------------------------------------------------------- walk

// Turns the character's axes to Y up and +Z ahead.
static soleQuat toolFindUpright( const toolCharacter* character )
{
	soleVec3 worldUp = soleVec( 0.0f, 1.0f, 0.0f );
	soleVec3 up = soleNormalizeOr( character->rigDef.up, worldUp );
	soleVec3 forward = soleNormalizeOr( soleReject( character->rigDef.forward, up ), soleAnyOrthogonal( up ) );
	soleQuat erect = soleFromTo( up, worldUp, forward );
	soleVec3 flat = soleRotate( erect, forward );
	double turn = -atan2( (double)flat.x, (double)flat.z );
	soleQuat ahead = { 0.0f, (float)sin( 0.5 * turn ), 0.0f, (float)cos( 0.5 * turn ) };
	return soleNormalizeQuat( soleMulQuat( ahead, erect ) );
}

// Which way the stride goes, seen from the character: strides measured a little off an eighth of the circle are on it.
static double toolFindStrideSide( const toolWalker* walker )
{
	soleVec3 stride = soleRotate( walker->upright, walker->def->travel->strideVelocity );
	double angle = atan2( (double)stride.x, (double)stride.z );
	double near = floor( angle / ( PI / 4.0 ) + 0.5 ) * ( PI / 4.0 );
	return fabs( angle - near ) < 10.0 * PI / 180.0 ? near : angle;
}

// How long a root motion takes to come so far forwards, or so far at all where it does not go forwards.
static double toolFindRootTime( const toolWalker* walker, double length )
{
	const toolWalkDef* def = walker->def;
	double round = (double)def->bound->duration / walker->rate;
	soleVec3 net = soleRotate( walker->upright, def->travel->loop.translation );
	bool forwards = (double)net.z > 0.5 * (double)soleLength( net );
	double pace = ( forwards ? (double)net.z : (double)soleLength( net ) ) / round;
	if ( def->travel->turns || def->travel->loops == false || !( pace > 0.01 ) )
	{
		return round;
	}
	return length / pace;
}

static double toolFindDuration( const toolWalker* walker, double length )
{
	const toolWalkDef* def = walker->def;
	double round = (double)def->bound->duration / walker->rate;
	if ( def->travel->rootMotion )
	{
		return def->duration > 0.0 ? def->duration : toolFindRootTime( walker, length );
	}
	if ( walker->speed <= 0.0 )
	{
		return def->duration > 0.0 ? def->duration : round;
	}
	double whole = length > 0.0 ? length / walker->speed : round;
	bool endless = length <= 0.0;
	return def->duration > 0.0 && ( endless || def->duration < whole ) ? def->duration : whole;
}

bool toolIsStanding( const toolTravel* travel )
{
	float least = travel->loops || travel->rootMotion ? STANDING_SPEED : ONCE_SPEED;
	return soleLength( travel->strideVelocity ) < least;
}

static void toolFindSpeed( toolWalker* walker )
{
	const toolWalkDef* def = walker->def;
	double own = (double)soleLength( def->travel->strideVelocity );
	walker->rate = 1.0;
	if ( toolIsStanding( def->travel ) )
	{
		walker->speed = def->travel->rootMotion ? own : fmax( def->speed, 0.0 );
		return;
	}
	walker->speed = def->speed > 0.0 ? def->speed : own;
	walker->rate = fmin( fmax( walker->speed / own, 0.05 ), 20.0 );
	walker->side = def->travel->rootMotion ? 0.0 : toolFindStrideSide( walker );
}

static bool toolSayWhereGroundEnds( const toolWalkDef* def, toolPlace place, toolError* error )
{
	return toolFail( error,
	    "%s: no ground at x=%.3f, z=%.3f: the path leaves the ground there, end it earlier or lead it elsewhere "
	    "(up is +Y in a bake: no path goes up a wall or around a planet)",
	    def->groundName, place.x, place.z );
}

static bool toolRunWalk( const toolWalker* walker, toolWalkState state, toolWalk* walk, toolError* error )
{
	const toolWalkDef* def = walker->def;
	double round = (double)def->bound->duration;
	double lastRounds = 0.0;
	int64_t ticks = 0;
	for ( int32_t i = 0; i < walk->frameCount; ++i )
	{
		double time = (double)i / def->fps;
		for ( ; (double)( ticks + 1 ) * TICK <= time + 1e-9; ++ticks )
		{
			toolAdvance( walker, &state, TICK );
			state.time = (double)( ticks + 1 ) * TICK;
		}
		toolWalkState now = state;
		if ( time - state.time > 1e-9 )
		{
			toolAdvance( walker, &now, time - state.time );
		}
		double ignored;
		toolPlace place = toolPlaceAt( walker, now.time, &ignored );
		bool last = i + 1 == walk->frameCount;
		double from = now.height + walker->step;
		if ( now.bottomless > BOTTOMLESS_TIME || ( last && now.bottomless > 0.0 ) ||
		    soleIsFinite( (float)( place.x + place.z + from ) ) == false )
		{
			return toolSayWhereGroundEnds( def, now.fallStart, error );
		}
		walk->roots[i] = toolMakeRoot( walker, &now );
		walk->clipTimes[i] = time * walker->rate;
		double rounds = round > 0.0 ? ceil( walk->clipTimes[i] / round - 1e-6 ) : 0.0;
		walk->jumps[i] = i > 0 && def->travel->loops == false && rounds > fmax( lastRounds, 1.0 );
		lastRounds = rounds;
		walk->seams[i] =
		    i > 0 && toolCrossesSeam( def->bound, def->travel, walk->clipTimes[i - 1], walk->clipTimes[i] );
	}
	return true;
}

bool toolMakeWalk( const toolWalkDef* def, toolWalk* walk, toolError* error )
{
	*walk = ( toolWalk ){ 0 };
	if ( def->pathCount < 1 || !( def->fps >= 1.0 && def->fps <= 1000.0 ) )
	{
		return toolFail( error, "%s",
		    def->pathCount < 1 ? "the path is empty: give at least one place"
		                       : "the frame rate is out of range: give one from 1 to 1000 Hz" );
	}
	toolPlace start = def->path[0];
	if ( toolFindGround( def->ground, def->groundName, &start, error ) == false )
	{
		return false;
	}
	toolWalker walker = { .def = def, .rate = 1.0 };
	walker.upright = toolFindUpright( def->character );
	walker.step = (double)TOOL_STEP_HEIGHT * toolLegLength( def->character );
	// Where the origin is at the hips, say, the clip's floor stands on the ground; small differences are the clip's
	// own.
	double floorHeight = (double)def->travel->clipFloor;
	walker.lift = fabs( floorHeight ) > 0.1 * toolLegLength( def->character ) ? -floorHeight : 0.0;
	toolFindSpeed( &walker );
	toolLayPath( &walker, def->distance );
	double duration = toolFindDuration( &walker, walker.lengths[walker.count - 1] );
	bool good = duration <= LONGEST_WALK && duration * def->fps < (double)TOOL_MAX_FRAMES;
	if ( good )
	{
		walk->frameCount = (int32_t)floor( duration * def->fps + 1e-6 ) + 1;
		walk->fps = def->fps;
		walk->speed = walker.speed;
		walk->rate = walker.rate;
		walk->roots = toolAlloc( (size_t)walk->frameCount, sizeof *walk->roots );
		walk->clipTimes = toolAlloc( (size_t)walk->frameCount, sizeof *walk->clipTimes );
		walk->jumps = toolAlloc( (size_t)walk->frameCount, sizeof *walk->jumps );
		walk->seams = toolAlloc( (size_t)walk->frameCount, sizeof *walk->seams );
		toolWalkState state = { .height = start.y };
		toolPlaceAt( &walker, 0.0, &state.facing );
		good = toolRunWalk( &walker, state, walk, error );
	}
	else
	{
		toolFail( error, "%s: a walk of %.0f s over it at %g Hz is too long: keep it below an hour and %d frames",
		    def->groundName, duration, def->fps, TOOL_MAX_FRAMES );
	}
	free( walker.places );
	free( walker.lengths );
	if ( good == false )
	{
		toolFreeWalk( walk );
	}
	return good;
}

void toolFreeWalk( toolWalk* walk )
{
	free( walk->roots );
	free( walk->clipTimes );
	free( walk->jumps );
	free( walk->seams );
	*walk = ( toolWalk ){ 0 };
}
