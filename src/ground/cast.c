// SPDX-License-Identifier: MIT
// Probes against a whole ground: the tree of triangles, then height fields, then planes. World space.
#include "ground/walk.h"

#include "base/core.h"

#define BATCH 8 // walks at once

/// A plane is the face of a solid half space: a start below it is inside, and the nearest surface is straight up.
static bool soleMeetPlane( const soleGroundPlane* plane, const soleGroundQuery* query, soleGroundTouch* touch )
{
	soleVec3 start = { query->start[0], query->start[1], query->start[2] };
	soleVec3 way = { query->direction[0], query->direction[1], query->direction[2] };
	double height = (double)soleDot( start, plane->normal ) - (double)plane->offset;
	double along = (double)soleDot( way, plane->normal );
	double r = (double)query->radius;
	*touch = ( soleGroundTouch ){ .hit = true, .normal = plane->normal, .layer = plane->layer };
	touch->surface = plane->surface;
	soleVec3 centre = start;
	double distance = height;
	if ( height < 0.0 || height < r )
	{
		touch->inside = true;
		touch->gap = fabs( height );
		touch->facing = height;
	}
	else
	{
		if ( !( along < 0.0 ) || height - r > -along * (double)query->length )
		{
			return false;
		}
		touch->t = ( height - r ) / -along;
		touch->facing = -along;
		centre = soleMulAdd( start, (float)touch->t, way );
		distance = r;
	}
	touch->point = soleMulAdd( centre, -(float)distance, plane->normal );
	return true;
}

static void soleCastPlanes(
    const soleGround* ground, const soleGroundQuery* query, int64_t firstIndex, soleGroundTouch* best )
{
	for ( int32_t i = 0; i < ground->planeCount; ++i )
	{
		soleGroundTouch touch;
		if ( ( ground->planes[i].layer & query->mask ) == 0 || !soleMeetPlane( ground->planes + i, query, &touch ) )
		{
			continue;
		}
		touch.index = firstIndex + i;
		if ( soleGroundTouch_IsBefore( &touch, best ) )
		{
			*best = touch;
		}
	}
}

/// What is not in the tree. @return false where nothing was met, in the tree or here
static bool soleCastRest( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best )
{
	int64_t firstIndex = SOLE_GROUND_MAX_TRIANGLES;
	for ( int32_t i = 0; i < ground->fieldCount; ++i )
	{
		const soleGroundField* field = ground->fields + i;
		if ( ( field->field.layer & query->mask ) != 0 )
		{
			soleCastHeightField( field, query, firstIndex, best );
		}
		firstIndex += soleGroundField_GetTriangleCount( field );
	}
	soleCastPlanes( ground, query, firstIndex, best );
	// Coordinates near the end of what floats hold overflow on the way.
	return best->hit && soleVec3_IsFinite( best->point ) && soleVec3_IsFinite( best->normal );
}

bool soleCastQuery( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best )
{
	*best = ( soleGroundTouch ){ .t = (double)INFINITY };
	if ( ground->nodeCount > 0 )
	{
		soleWalk walk;
		soleStartWalk( ground, query, best, &walk );
		soleFetchNodes( &walk );
		soleGatherBlocks( &walk );
		soleFinishWalk( &walk );
	}
	return soleCastRest( ground, query, best );
}

static bool soleMakeProbeQuery( const soleProbe* probe, soleGroundQuery* query )
{
	return soleMakeGroundQuery( probe->start_w, probe->direction_w, probe->length, probe->radius, probe->mask, query );
}

static soleHit soleMakeMiss( const soleProbe* probe )
{
	return ( soleHit ){ .surface = SOLE_NONE, .asked_w = probe->start_w };
}

static void soleFillHit( const soleGroundTouch* touch, soleHit* hit )
{
	hit->hit = true;
	hit->startedInside = touch->inside;
	hit->layer = touch->layer;
	hit->surface = touch->surface;
	hit->point_w = touch->point;
	hit->normal_w = touch->normal;
}

soleHit soleCastProbe( const soleGround* ground, const soleProbe* probe )
{
	SOLE_ASSERT( probe != NULL );
	if ( probe == NULL )
	{
		return ( soleHit ){ .surface = SOLE_NONE };
	}
	soleHit hit = soleMakeMiss( probe );
	soleGroundQuery query;
	soleGroundTouch touch;
	if ( ground != NULL && soleMakeProbeQuery( probe, &query ) && soleCastQuery( ground, &query, &touch ) )
	{
		soleFillHit( &touch, &hit );
	}
	return hit;
}

/// Some probes, a step of each in turn.
static void soleCastBatch( const soleGround* ground, const soleProbe* probes, int32_t count, soleHit* hits )
{
	soleGroundQuery queries[BATCH];
	soleGroundTouch touches[BATCH];
	soleWalk walks[BATCH];
	int32_t asked[BATCH]; // those that ask something
	int32_t askedCount = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		hits[i] = soleMakeMiss( probes + i );
		if ( soleMakeProbeQuery( probes + i, queries + i ) )
		{
			touches[i] = ( soleGroundTouch ){ .t = (double)INFINITY };
			asked[askedCount] = i;
			askedCount += 1;
		}
	}
	bool hasTree = ground->nodeCount > 0;
	for ( int32_t k = 0; k < askedCount && hasTree; ++k )
	{
		soleStartWalk( ground, queries + asked[k], touches + asked[k], walks + k );
	}
	for ( int32_t k = 0; k < askedCount && hasTree; ++k )
	{
		soleFetchNodes( walks + k );
	}
	for ( int32_t k = 0; k < askedCount && hasTree; ++k )
	{
		soleGatherBlocks( walks + k );
	}
	for ( int32_t k = 0; k < askedCount; ++k )
	{
		int32_t i = asked[k];
		if ( hasTree )
		{
			soleFinishWalk( walks + k );
		}
		if ( soleCastRest( ground, queries + i, touches + i ) )
		{
			soleFillHit( touches + i, hits + i );
		}
	}
}

void soleCastProbes( const soleGround* ground, const soleProbe* probes, int32_t count, soleHit* hits )
{
	SOLE_ASSERT( count <= 0 || ( probes != NULL && hits != NULL ) );
	for ( int32_t i = 0; i < count && ground == NULL; ++i )
	{
		hits[i] = soleMakeMiss( probes + i );
	}
	for ( int32_t i = 0; i < count && ground != NULL; i += BATCH )
	{
		soleCastBatch( ground, probes + i, count - i < BATCH ? count - i : BATCH, hits + i );
	}
}
