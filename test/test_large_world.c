// SPDX-License-Identifier: MIT
// A walk up stairs far from the origin of a large world is the walk at the origin: where the host keeps floats near the
// character (soleFrame.worldOrigin) at a hundred kilometres, where it does not, as far as floats go.
#include "biped_walk.h"

#include <math.h>

#define FRAMES 420
#define SPEED 1.1f

static const testWalk walk = { .speed = SPEED, .period = 1.1f, .lift = 0.12f };

/// How the host has its world.
typedef struct Place
{
	double at[3];       // where the walk sets out
	double rebaseAfter; // m; the origin of floats is moved to the character when it is further away. 0: in every frame
	bool near;          // false: floats count from the world's own origin
} Place;

typedef struct Host
{
	Place place;
	testRun run;
	soleContactInput contacts[2];
	soleStepInput inputs[2];
	double origin[3]; // of floats
	double root[3];
} Host;

/// Stairs up along z, from where the walk sets out.
static double heightAt( const Place* place, double z )
{
	double along = z - place->at[2] - 2.0;
	return place->at[1] + ( along > 0.0 ? 0.16 * fmin( ceil( along / 0.31 ), 10.0 ) : 0.0 );
}

/// The host's physics: in doubles, told in floats about its present origin.
static void castInDoubles( const Host* host, const soleProbe* probe, soleHit* hit )
{
	memset( hit, 0, sizeof *hit );
	hit->surface = SOLE_NONE;
	hit->asked_w = probe->start_w;
	double height = heightAt( &host->place, host->origin[2] + (double)probe->start_w.z ) - host->origin[1];
	double way = (double)probe->start_w.y - height;
	hit->hit = probe->length > 0.0f && way >= 0.0 && way <= (double)probe->length;
	hit->point_w = soleVec( probe->start_w.x, (float)height, probe->start_w.z );
	hit->normal_w = soleVec( 0.0f, 1.0f, 0.0f );
}

static void moveOrigin( Host* host )
{
	double far = 0.0;
	for ( int k = 0; k < 3; ++k )
	{
		far = fmax( far, fabs( host->root[k] - host->origin[k] ) );
	}
	if ( host->place.near && far > host->place.rebaseAfter )
	{
		memcpy( host->origin, host->root, sizeof host->origin );
	}
}

static void stepHost( Host* host, int32_t index )
{
	static soleProbe probes[SOLE_MAX_PROBES];
	static soleHit hits[SOLE_MAX_PROBES];
	testRun* run = &host->run;
	float time = (float)index / 60.0f;
	host->root[0] = host->place.at[0];
	host->root[2] = host->place.at[2] + (double)SPEED * index / 60.0;
	host->root[1] = heightAt( &host->place, host->root[2] );
	moveOrigin( host );
	memcpy( run->frame.worldOrigin, host->origin, sizeof host->origin );
	run->frame.root.translation = soleVec( (float)( host->root[0] - host->origin[0] ),
	    (float)( host->root[1] - host->origin[1] ), (float)( host->root[2] - host->origin[2] ) );
	testPoseWalk( run->pose, &walk, time );
	testTellWalk( &walk, time, host->contacts, host->inputs );
	run->frame.contact = host->contacts;
	run->frame.steps = host->inputs;
	int32_t count =
	    soleGatherProbes( run->biped.rig, &run->settings, &run->state, &run->frame, probes, SOLE_MAX_PROBES );
	for ( int32_t i = 0; i < count; ++i )
	{
		castInDoubles( host, probes + i, hits + i );
	}
	soleSolve( run->biped.rig, &run->settings, &run->state, &run->frame, hits, count, &run->out );
	testPlace( run );
}

static void startHost( Host* host, Place place )
{
	memset( host, 0, sizeof *host );
	host->place = place;
	testStartRun( &host->run, 0.3f );
}

/// Furthest that a joint of the one is from where it is of the other, as seen from their roots, m.
static float compareWalks( Place place )
{
	static Host home, away;
	startHost( &home, ( Place ){ .at = { 0.0, 0.0, 0.0 }, .near = false } );
	startHost( &away, place );
	float largest = 0.0f;
	int32_t planted = 0;
	for ( int32_t i = 0; i < FRAMES; ++i )
	{
		stepHost( &home, i );
		stepHost( &away, i );
		largest = fmaxf( largest, testLargestMove( &home.run.biped, home.run.placed, away.run.placed ) );
		planted += ( away.run.out.legs[0].flags & sole_legPlanted ) != 0 ? 1 : 0;
	}
	assert_in_range( planted, FRAMES / 4, FRAMES * 3 / 4 );
	testEndRun( &home.run );
	testEndRun( &away.run );
	return largest;
}

#define TENTH_MM 1e-4f

static void aHundredKilometresAwayAWalkIsTheSame( void** state )
{
	(void)state;
	// Floats count from the character itself, from where it was up to 2.5 m ago, and from where it set out.
	static const double rebases[] = { 0.0, 2.5, 100.0 };
	for ( int32_t i = 0; i < 3; ++i )
	{
		Place place = { .at = { 100000.3, 300.1, -70000.7 }, .rebaseAfter = rebases[i], .near = true };
		float apart = compareWalks( place );
		if ( apart > TENTH_MM )
		{
			fail_msg( "the origin moves after %g m: %g mm apart", rebases[i], 1e3 * (double)apart );
		}
	}
}

static void floatsOfAWholeWorldCarryAKilometre( void** state )
{
	(void)state;
	float apart = compareWalks( ( Place ){ .at = { 1000.3, 30.1, 1000.7 }, .near = false } );
	assert_true( apart < 1e-3f );
	assert_true( apart > 0.0f ); // or nothing was compared
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( aHundredKilometresAwayAWalkIsTheSame ),
		cmocka_unit_test( floatsOfAWholeWorldCarryAKilometre ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
