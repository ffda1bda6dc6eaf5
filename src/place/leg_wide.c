// SPDX-License-Identifier: MIT
// Many legs at once: by the kernel of leg_kernel.h, and one by one what is left over at the end of a range. That last
// way says what both of them give.
#include "place/leg_wide.h"

#include "base/core.h"
#include "place/kernels.h"
#include "place/place.h"

static soleVec3 soleGet3( soleArray3 a, int32_t i )
{
	return soleVec( a.x[i], a.y[i], a.z[i] );
}

static soleQuat soleGet4( soleArray4 a, int32_t i )
{
	return ( soleQuat ){ a.x[i], a.y[i], a.z[i], a.w[i] };
}

static void solePut4( soleArray4 a, int32_t i, soleQuat q )
{
	a.x[i] = q.x;
	a.y[i] = q.y;
	a.z[i] = q.z;
	a.w[i] = q.w;
}

static void soleSolveOneByOne( const soleLegBatch* batch, int32_t first, int32_t end )
{
	for ( int32_t i = first; i < end; ++i )
	{
		soleTwoBoneDef def = {
			.hip = soleGet3( batch->hip, i ),
			.knee = soleGet3( batch->knee, i ),
			.ankle = soleGet3( batch->ankle, i ),
			.target = soleGet3( batch->target, i ),
			.hinge = soleGet3( batch->hinge, i ),
			.reach = batch->reach[i],
			.fold = batch->fold[i],
			.softZone = batch->softZone[i],
		};
		soleTwoBoneResult result = soleSolveTwoBone( &def );
		soleQuat thigh = soleGet4( batch->thigh, i ), shin = soleGet4( batch->shin, i );
		soleQuat parent = soleConjugate( soleGet4( batch->parent, i ) );
		soleQuat bent = soleMulQuat( result.knee, shin );
		soleQuat carried = soleMulQuat( result.hip, bent );
		soleQuat foot = soleMulQuat( soleConjugate( carried ), soleGet4( batch->foot, i ) );
		solePut4( batch->thigh_l, i, soleNormalizeQuat( soleMulQuat( parent, soleMulQuat( result.hip, thigh ) ) ) );
		soleQuat newShin = soleMulQuat( soleConjugate( thigh ), bent );
		solePut4( batch->shin_l, i, soleNormalizeQuat( newShin ) );
		solePut4( batch->foot_l, i, soleNormalizeQuat( foot ) );
		batch->reached.x[i] = result.ankle.x;
		batch->reached.y[i] = result.ankle.y;
		batch->reached.z[i] = result.ankle.z;
		batch->flags[i] = result.flags;
	}
}

soleLegLanesFcn* soleGetLegLanes( int32_t width )
{
	return width == 1 ? soleSolveOneByOne : soleGetWideLegLanes( width );
}

int32_t soleGetBatchWidth( void )
{
	return soleGetKernelWidth();
}

void soleSolveLegBatch( const soleLegBatch* batch, int32_t first, int32_t count )
{
	bool given = batch != NULL && first >= 0 && count >= 0 && count <= batch->count && first <= batch->count - count;
	SOLE_ASSERT( given );
	if ( given )
	{
		int32_t width = soleGetBatchWidth();
		int32_t whole = count - count % width;
		soleGetLegLanes( width )( batch, first, first + whole );
		soleSolveOneByOne( batch, first + whole, first + count );
	}
}
