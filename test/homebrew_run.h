// SPDX-License-Identifier: MIT
// The plain biped placed by the ancestor "Homebrew", frame by frame.
#ifndef TEST_HOMEBREW_RUN_H
#define TEST_HOMEBREW_RUN_H

#include "ancestor_run.h"
#include "baselines/homebrew.h"

#define ANKLE 0.08 // r + a, as set here

typedef struct homebrewRun
{
	ancestorRun base;
	soleHomebrewSettings settings;
	soleHomebrewState state;
} homebrewRun;

static homebrewRun run;

static inline void start( soleGround* ground )
{
	ancestorStart( &run.base, ground );
	run.settings = soleDefaultHomebrewSettings();
	run.state = soleDefaultHomebrewState( run.base.biped.rig );
}

static inline void step( void )
{
	ancestorRun* b = &run.base;
	b->probeCount = soleGatherHomebrew( b->biped.rig, &run.settings, &run.state, &b->frame, b->probes, SOLE_MAX_LEGS );
	soleCastProbes( b->ground, b->probes, b->probeCount, b->hits );
	soleSolveHomebrew( b->biped.rig, &run.settings, &run.state, &b->frame, b->hits, b->probeCount, &b->out );
	ancestorApply( b );
}

static inline void steps( int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		step();
	}
}

static inline void restart( void )
{
	run.state = soleDefaultHomebrewState( run.base.biped.rig );
}

static inline soleGround* level( float height )
{
	return ancestorPlane( soleVec( 0.0f, height, 0.0f ), soleVec( 0.0f, 1.0f, 0.0f ) );
}

static inline float placedHeight( int32_t leg )
{
	return ancestorPlaced( &run.base, ancestorAnkle( leg ) ).translation.y;
}

static inline float animatedHeight( int32_t leg )
{
	return ancestorAnimated( &run.base, ancestorAnkle( leg ) ).translation.y;
}

/// How far a foot was turned beyond its animation.
static inline soleVec3 footTurn( int32_t leg )
{
	int32_t ankle = ancestorAnkle( leg );
	return ancestorTurn( ancestorAnimated( &run.base, ankle ).rotation, ancestorPlaced( &run.base, ankle ).rotation );
}

#endif
