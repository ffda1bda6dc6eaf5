// SPDX-License-Identifier: MIT
// Probes against grounds that move: each is asked in its own space, the nearest answer is carried into the world. Keeps
// nothing from one probe to the next.
#include "ground/ground_internal.h"

#include "base/core.h"

/// Asks one piece in its own space.
static bool soleCastPiece( const soleGroundPiece* piece, const soleProbe* probe, soleGroundTouch* touch )
{
	soleQuat rotation = soleNormalizeQuat( piece->transform.rotation );
	soleVec3 start = soleInvRotate( rotation, soleSub( probe->start_w, piece->transform.translation ) );
	soleVec3 direction = soleInvRotate( rotation, probe->direction_w );
	soleGroundQuery query;
	return piece->ground != NULL &&
	    soleMakeGroundQuery( start, direction, probe->length, probe->radius, probe->mask, &query ) &&
	    soleCastQuery( piece->ground, &query, touch );
}

static bool soleIsNearer( const soleGroundTouch* a, const soleGroundTouch* b )
{
	return a->t < b->t || ( a->t == b->t && a->gap < b->gap );
}

soleHit soleCastPieces( const soleGroundPiece* pieces, int32_t count, const soleProbe* probe )
{
	bool given = probe != NULL && ( pieces != NULL || count <= 0 );
	SOLE_ASSERT( given );
	if ( given == false )
	{
		return ( soleHit ){ .surface = SOLE_NONE };
	}
	soleHit hit = { .surface = SOLE_NONE, .asked_w = probe->start_w };
	soleGroundTouch best = { .t = (double)INFINITY };
	const soleGroundPiece* met = NULL;
	for ( int32_t i = 0; i < count; ++i )
	{
		soleGroundTouch touch;
		if ( soleCastPiece( pieces + i, probe, &touch ) && soleIsNearer( &touch, &best ) )
		{
			best = touch;
			met = pieces + i;
		}
	}
	if ( met == NULL )
	{
		return hit;
	}
	soleQuat rotation = soleNormalizeQuat( met->transform.rotation );
	soleVec3 arm = soleRotate( rotation, best.point );
	hit.hit = true;
	hit.startedInside = best.inside;
	hit.layer = best.layer;
	hit.surface = met->surface != SOLE_NONE ? met->surface : best.surface;
	hit.point_w = soleAdd( arm, met->transform.translation );
	hit.normal_w = soleRotate( rotation, best.normal );
	hit.velocity_w = soleAdd( met->velocity_w, soleCross( met->spin_w, arm ) );
	return hit;
}
