// SPDX-License-Identifier: MIT
// Probes against a whole ground: the tree of triangles, then height fields, then planes. World space.
//
// A box is met where the travels between its three pairs of sides overlap. Boxes are widened by the sphere's radius and
// by what rounding may shift a triangle in ray.c, so that no triangle is missed because its box was; a direction
// without a part along an axis gets a large finite inverse, which leaves no NaN: inside the sides all travel is within,
// outside none is. Children are visited nearest first.
#include "ground/ground_internal.h"

#include "base/core.h"

/// The probe as boxes want it.
typedef struct soleBoxQuery
{
	float inverse[3];
	float startLow[3];  // start moved up by the reach: compared with lower sides
	float startHigh[3]; // start moved down: compared with upper sides
} soleBoxQuery;

typedef struct soleStackEntry
{
	uint32_t child;
	float enter;
} soleStackEntry;

static soleBoxQuery soleMakeBoxQuery( const soleGround* ground, const soleGroundQuery* query )
{
	soleBoxQuery box;
	float furthest = ground->extent;
	for ( int k = 0; k < 3; ++k )
	{
		furthest = soleMaxF( furthest, fabsf( query->start[k] ) );
	}
	float reach = query->radius + 2e-6f * furthest + 1e-20f;
	for ( int k = 0; k < 3; ++k )
	{
		float d = query->direction[k];
		box.inverse[k] = fabsf( d ) > 1e-30f ? 1.0f / d : 1e30f;
		box.startLow[k] = query->start[k] + reach;
		box.startHigh[k] = query->start[k] - reach;
	}
	return box;
}

/// Where the probe enters the child's box, or INFINITY.
static float soleEnterBox( const soleBoxQuery* box, const soleGroundNode* node, int child, float limit )
{
	float enter = 0.0f;
	float leave = limit;
	for ( int k = 0; k < 3; ++k )
	{
		float a = ( node->lower[k][child] - box->startLow[k] ) * box->inverse[k];
		float b = ( node->upper[k][child] - box->startHigh[k] ) * box->inverse[k];
		float nearSide = a < b ? a : b;
		float farSide = a < b ? b : a;
		enter = soleMaxF( enter, nearSide );
		leave = soleMinF( leave, farSide );
	}
	// Each travel is off by at most two roundings.
	return enter <= leave * 1.000001f ? enter : INFINITY;
}

static void soleCastLeaf( const soleGround* ground, const soleGroundQuery* query, uint32_t leaf, soleGroundTouch* best )
{
	uint32_t first = leaf >> 3;
	uint32_t end = first + ( leaf & 7u );
	for ( uint32_t i = first; i < end; ++i )
	{
		const soleGroundTriangle* triangle = ground->triangles + i;
		const soleGroundPart* part = ground->parts + triangle->mesh;
		uint32_t layer = ground->layers != NULL ? ground->layers[i] : part->layer;
		const float* const corners[3] = {
			ground->vertices + 3 * (size_t)triangle->corners[0],
			ground->vertices + 3 * (size_t)triangle->corners[1],
			ground->vertices + 3 * (size_t)triangle->corners[2],
		};
		soleGroundTouch touch;
		if ( ( layer & query->mask ) == 0 || !soleMeetTriangle( query, corners, part->twoSided, &touch ) )
		{
			continue;
		}
		touch.index = triangle->index;
		touch.layer = layer;
		touch.surface = part->surface;
		if ( soleGroundTouch_IsBefore( &touch, best ) )
		{
			*best = touch;
		}
	}
}

/// Puts the children that the probe enters onto the stack, the nearest on top. @return the new height of the stack.
static int soleOpenNode(
    const soleGroundNode* node, const soleBoxQuery* box, float limit, soleStackEntry* stack, int stackCount )
{
	int bottom = stackCount;
	for ( int child = 0; child < 4 && node->children[child] != SOLE_GROUND_NO_CHILD; ++child )
	{
		float enter = soleEnterBox( box, node, child, limit );
		if ( !( enter < INFINITY ) )
		{
			continue;
		}
		int place = stackCount;
		while ( place > bottom && stack[place - 1].enter < enter )
		{
			stack[place] = stack[place - 1];
			place -= 1;
		}
		stack[place] = ( soleStackEntry ){ node->children[child], enter };
		stackCount += 1;
	}
	return stackCount;
}

static void soleCastTree( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best )
{
	if ( ground->nodeCount == 0 )
	{
		return;
	}
	soleBoxQuery box = soleMakeBoxQuery( ground, query );
	soleStackEntry stack[SOLE_GROUND_STACK_SIZE];
	int stackCount = 1;
	stack[0] = ( soleStackEntry ){ 0, 0.0f };
	while ( stackCount > 0 )
	{
		stackCount -= 1;
		soleStackEntry entry = stack[stackCount];
		float limit = soleMinF( query->length, (float)best->t );
		if ( entry.enter > limit * 1.000001f )
		{
			continue;
		}
		if ( ( entry.child & 7u ) != 0 )
		{
			soleCastLeaf( ground, query, entry.child, best );
			continue;
		}
		SOLE_ASSERT( stackCount + 4 <= SOLE_GROUND_STACK_SIZE );
		stackCount = soleOpenNode( ground->nodes + ( entry.child >> 3 ), &box, limit, stack, stackCount );
	}
}

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

bool soleCastQuery( const soleGround* ground, const soleGroundQuery* query, soleGroundTouch* best )
{
	*best = ( soleGroundTouch ){ .t = (double)INFINITY };
	soleCastTree( ground, query, best );
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

soleHit soleCastProbe( const soleGround* ground, const soleProbe* probe )
{
	SOLE_ASSERT( probe != NULL );
	if ( probe == NULL )
	{
		return ( soleHit ){ .surface = SOLE_NONE };
	}
	soleHit hit = { .surface = SOLE_NONE, .asked_w = probe->start_w };
	soleGroundQuery query;
	soleGroundTouch touch;
	if ( ground == NULL ||
	    !soleMakeGroundQuery( probe->start_w, probe->direction_w, probe->length, probe->radius, probe->mask, &query ) ||
	    !soleCastQuery( ground, &query, &touch ) )
	{
		return hit;
	}
	hit.hit = true;
	hit.startedInside = touch.inside;
	hit.layer = touch.layer;
	hit.surface = touch.surface;
	hit.point_w = touch.point;
	hit.normal_w = touch.normal;
	return hit;
}

void soleCastProbes( const soleGround* ground, const soleProbe* probes, int32_t count, soleHit* hits )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		hits[i] = soleCastProbe( ground, probes + i );
	}
}
