// SPDX-License-Identifier: MIT
// The kernels of many legs or characters at once, made for each width, and the choice between them.
#include "place/kernels.h"

#include "base/wide_limits.h"

#define SOLE_WIDTH 4
#include "place/every_kernel.h"
#undef SOLE_WIDTH

// Elsewhere no machine has more.
#if SOLE_X86
#define SOLE_WIDTH 8
SOLE_BEGIN_AVX2
#include "place/every_kernel.h"
SOLE_END_TARGET
#undef SOLE_WIDTH

#define SOLE_WIDTH 16
SOLE_BEGIN_AVX512
#include "place/every_kernel.h"
SOLE_END_TARGET
#undef SOLE_WIDTH

#define PICK_WIDTH( width, kernel ) ( ( width ) == 16 ? kernel##Of16 : ( ( width ) == 8 ? kernel##Of8 : kernel##Of4 ) )
#else
#define PICK_WIDTH( width, kernel ) ( (void)( width ), kernel##Of4 )
#endif

int32_t soleGetKernelWidth( void )
{
	return (int32_t)soleGetSimdWidth();
}

soleLegLanesFcn* soleGetWideLegLanes( int32_t width )
{
	return PICK_WIDTH( width, soleLegLanes );
}

soleFootLanesFcn* soleGetFootLanes( int32_t width )
{
	return PICK_WIDTH( width, soleFootLanes );
}

soleSenseLanesFcn* soleGetSenseLanes( int32_t width )
{
	return PICK_WIDTH( width, soleSenseLanes );
}

soleTargetLanesFcn* soleGetTargetLanes( int32_t width )
{
	return PICK_WIDTH( width, soleTargetLanes );
}
