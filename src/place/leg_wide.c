// SPDX-License-Identifier: MIT
// Many legs at once: the kernels of leg_kernel.h and foot_kernel.h in each width, the choice between them, and one by
// one what is left over at the end of a range. That last way says what all of them give.
//
// Least and most numbers in math.h are met with "at least", lanes only know "less": they get the floats next to those.
#include "place/leg_wide.h"

#include "base/core.h"
#include "place/foot_wide.h"

#define SOLE_BELOW_LEAST 0x1.197996p-40f  // the largest float below 1e-12
#define SOLE_ABOVE_MOST 0x1.c363cep+127f  // the smallest above 3e38
#define SOLE_BELOW_LENGTH 0x1.79ca0ep-67f // the largest below 1e-20

#define SOLE_WIDTH 4
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/foot_kernel.h"
static soleLegLanesFcn* const soleLegLanesOf4 = FN( soleSolveLegLanes );
static soleFootLanesFcn* const soleFootLanesOf4 = FN( soleFinishFootLanes );
#undef SOLE_WIDTH

// Elsewhere no machine has more.
#if SOLE_X86
#define SOLE_WIDTH 8
SOLE_BEGIN_AVX2
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/foot_kernel.h"
SOLE_END_TARGET
static soleLegLanesFcn* const soleLegLanesOf8 = FN( soleSolveLegLanes );
static soleFootLanesFcn* const soleFootLanesOf8 = FN( soleFinishFootLanes );
#undef SOLE_WIDTH

#define SOLE_WIDTH 16
SOLE_BEGIN_AVX512
#include "base/simd.h"
#include "base/wide_math.h"
#include "place/foot_kernel.h"
SOLE_END_TARGET
static soleLegLanesFcn* const soleLegLanesOf16 = FN( soleSolveLegLanes );
static soleFootLanesFcn* const soleFootLanesOf16 = FN( soleFinishFootLanes );
#undef SOLE_WIDTH
#endif

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
#if SOLE_X86
	if ( width == 16 || width == 8 )
	{
		return width == 16 ? soleLegLanesOf16 : soleLegLanesOf8;
	}
#endif
	return width == 4 ? soleLegLanesOf4 : soleSolveOneByOne;
}

soleFootLanesFcn* soleGetFootLanes( int32_t width )
{
#if SOLE_X86
	if ( width == 16 || width == 8 )
	{
		return width == 16 ? soleFootLanesOf16 : soleFootLanesOf8;
	}
#endif
	(void)width;
	return soleFootLanesOf4;
}

int32_t soleGetBatchWidth( void )
{
	return (int32_t)soleGetSimdWidth();
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
