// SPDX-License-Identifier: MIT
// Vectors of lanes out of rows and back. Included after base/simd.h and base/wide_math.h, once for each width.

SOLE_INLINE soleLanes3 FN( soleRow3 )( soleRow* rows, int32_t i )
{
	return ( soleLanes3 ){ soleWide_Load( rows[0] + i ), soleWide_Load( rows[1] + i ), soleWide_Load( rows[2] + i ) };
}

SOLE_INLINE soleLanes4 FN( soleRow4 )( soleRow* rows, int32_t i )
{
	return ( soleLanes4 ){ soleWide_Load( rows[0] + i ), soleWide_Load( rows[1] + i ), soleWide_Load( rows[2] + i ),
		soleWide_Load( rows[3] + i ) };
}

SOLE_INLINE void FN( soleKeep3 )( soleRow* rows, int32_t i, soleLanes3 v )
{
	soleWide_Store( rows[0] + i, v.x );
	soleWide_Store( rows[1] + i, v.y );
	soleWide_Store( rows[2] + i, v.z );
}

SOLE_INLINE void FN( soleKeep4 )( soleRow* rows, int32_t i, soleLanes4 q )
{
	soleWide_Store( rows[0] + i, q.x );
	soleWide_Store( rows[1] + i, q.y );
	soleWide_Store( rows[2] + i, q.z );
	soleWide_Store( rows[3] + i, q.w );
}
