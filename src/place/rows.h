// SPDX-License-Identifier: MIT
// Rows of numbers, a lane a leg or a character: how the wide kernels are given what they work on.
#ifndef SOLE_PLACE_ROWS_H
#define SOLE_PLACE_ROWS_H

#include "place/parts.h"

/// Lanes that go side by side: the legs of eight bipeds, or sixteen characters.
#define SOLE_LANES 16

typedef float soleRow[SOLE_LANES];

static inline void solePutRow3( soleRow* rows, int32_t lane, soleVec3 v )
{
	rows[0][lane] = v.x;
	rows[1][lane] = v.y;
	rows[2][lane] = v.z;
}

static inline void solePutRow4( soleRow* rows, int32_t lane, soleQuat q )
{
	rows[0][lane] = q.x;
	rows[1][lane] = q.y;
	rows[2][lane] = q.z;
	rows[3][lane] = q.w;
}

static inline soleVec3 soleGetRow3( soleRow* rows, int32_t lane )
{
	return soleVec( rows[0][lane], rows[1][lane], rows[2][lane] );
}

static inline soleQuat soleGetRow4( soleRow* rows, int32_t lane )
{
	return ( soleQuat ){ rows[0][lane], rows[1][lane], rows[2][lane], rows[3][lane] };
}

/// Lanes up to a whole number of vectors.
static inline int32_t soleWholeLanes( int32_t used, int32_t width )
{
	return ( used + width - 1 ) / width * width;
}

/// Lanes that are not used go along with the first.
static inline void soleFillRows( soleRow* rows, size_t byteCount, int32_t used, int32_t end )
{
	for ( size_t i = 0; i < byteCount / sizeof *rows; ++i )
	{
		for ( int32_t lane = used; lane < end; ++lane )
		{
			rows[i][lane] = rows[i][0];
		}
	}
}

#endif
