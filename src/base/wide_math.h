// SPDX-License-Identifier: MIT
// Vectors, quaternions and half angles of many lanes at once: each lane what sole/math.h and math_internal.h give for
// one, to the bit. Included after base/simd.h, once for each width; where those branch, lanes choose.
#undef soleLanes3
#undef soleLanes4
#undef soleLanesHalf
#define soleLanes3 SOLE_WIDE_NAME( soleLanes3_ )
#define soleLanes4 SOLE_WIDE_NAME( soleLanes4_ )
#define soleLanesHalf SOLE_WIDE_NAME( soleLanesHalf_ )
#undef FN
#undef SOLE_ALL_LANES
#define FN( name ) SOLE_WIDE_NAME( name )
#define SOLE_ALL_LANES ( UINT32_MAX >> ( 32 - SOLE_WIDTH ) )

typedef struct soleLanes3
{
	soleWide x, y, z;
} soleLanes3;

typedef struct soleLanes4
{
	soleWide x, y, z, w;
} soleLanes4;

typedef struct soleLanesHalf
{
	soleWide c, s;
} soleLanesHalf;

// Short names of the operations for the formulas below and those of kernels.
#undef ADD
#undef SUB
#undef MUL
#undef DIV
#undef NUM
#undef LESS
#undef PICK
#define ADD( a, b ) soleWide_Add( a, b )
#define SUB( a, b ) soleWide_Sub( a, b )
#define MUL( a, b ) soleWide_Mul( a, b )
#define DIV( a, b ) soleWide_Div( a, b )
#define NUM( a ) soleWide_Set( a )
#define LESS( a, b ) soleWide_Less( a, b )
#define PICK( mask, a, b ) soleWide_Select( mask, a, b )

SOLE_INLINE soleWide FN( soleNegWide )( soleWide a )
{
	return MUL( NUM( -1.0f ), a );
}

/// x < low ? low : ( x > high ? high : x )
SOLE_INLINE soleWide FN( soleClampWide )( soleWide x, soleWide low, soleWide high )
{
	return PICK( LESS( x, low ), low, soleWide_Min( high, x ) );
}

/// The same where low is known not to be above high.
SOLE_INLINE soleWide FN( soleLimitWide )( soleWide x, soleWide low, soleWide high )
{
	return soleWide_Max( low, soleWide_Min( high, x ) );
}

// ----------------------------------------------------------------------------------------------------------- vectors

SOLE_INLINE soleLanes3 FN( soleAdd3 )( soleLanes3 a, soleLanes3 b )
{
	return ( soleLanes3 ){ ADD( a.x, b.x ), ADD( a.y, b.y ), ADD( a.z, b.z ) };
}

SOLE_INLINE soleLanes3 FN( soleSub3 )( soleLanes3 a, soleLanes3 b )
{
	return ( soleLanes3 ){ SUB( a.x, b.x ), SUB( a.y, b.y ), SUB( a.z, b.z ) };
}

SOLE_INLINE soleLanes3 FN( soleScale3 )( soleWide s, soleLanes3 v )
{
	return ( soleLanes3 ){ MUL( s, v.x ), MUL( s, v.y ), MUL( s, v.z ) };
}

SOLE_INLINE soleLanes3 FN( soleMulAdd3 )( soleLanes3 a, soleWide s, soleLanes3 b )
{
	return ( soleLanes3 ){ ADD( a.x, MUL( s, b.x ) ), ADD( a.y, MUL( s, b.y ) ), ADD( a.z, MUL( s, b.z ) ) };
}

SOLE_INLINE soleWide FN( soleDot3 )( soleLanes3 a, soleLanes3 b )
{
	return ADD( ADD( MUL( a.x, b.x ), MUL( a.y, b.y ) ), MUL( a.z, b.z ) );
}

SOLE_INLINE soleLanes3 FN( soleCross3 )( soleLanes3 a, soleLanes3 b )
{
	return ( soleLanes3 ){ SUB( MUL( a.y, b.z ), MUL( a.z, b.y ) ), SUB( MUL( a.z, b.x ), MUL( a.x, b.z ) ),
		SUB( MUL( a.x, b.y ), MUL( a.y, b.x ) ) };
}

SOLE_INLINE soleLanes3 FN( solePick3 )( soleWideMask mask, soleLanes3 a, soleLanes3 b )
{
	return ( soleLanes3 ){ PICK( mask, a.x, b.x ), PICK( mask, a.y, b.y ), PICK( mask, a.z, b.z ) };
}

SOLE_INLINE soleWide FN( soleLength3 )( soleLanes3 v )
{
	return soleWide_Sqrt( FN( soleDot3 )( v, v ) );
}

/// squared >= 1e-12 and squared <= 3e38
SOLE_INLINE soleWideMask FN( soleIsUsable )( soleWide squared )
{
	// Below a number that is as near to 1e-12 as none is in between: "at least" by "less than".
	soleWideMask large = soleWide_Less( NUM( SOLE_BELOW_LEAST ), squared );
	return soleWide_And( large, soleWide_Less( squared, NUM( SOLE_ABOVE_MOST ) ) );
}

SOLE_INLINE soleLanes3 FN( soleNormalize3 )( soleLanes3 v, soleLanes3 fallback )
{
	soleWide squared = FN( soleDot3 )( v, v );
	soleWideMask usable = FN( soleIsUsable )( squared );
	soleLanes3 unit = FN( soleScale3 )( DIV( NUM( 1.0f ), soleWide_Sqrt( squared ) ), v );
	return soleWide_GetBits( usable ) == SOLE_ALL_LANES ? unit : FN( solePick3 )( usable, unit, fallback );
}

/// @return false: some lanes are not usable, and all are left as they are
SOLE_INLINE bool FN( soleTryNormalize3 )( soleLanes3* v )
{
	soleWide squared = FN( soleDot3 )( *v, *v );
	soleWideMask usable = FN( soleIsUsable )( squared );
	if ( soleWide_GetBits( usable ) != SOLE_ALL_LANES )
	{
		return false;
	}
	*v = FN( soleScale3 )( DIV( NUM( 1.0f ), soleWide_Sqrt( squared ) ), *v );
	return true;
}

SOLE_INLINE soleLanes3 FN( soleReject3 )( soleLanes3 v, soleLanes3 n )
{
	// As adding the negative: signs are exact.
	soleLanes3 along = FN( soleScale3 )( FN( soleDot3 )( v, n ), n );
	return FN( soleSub3 )( v, along );
}

SOLE_INLINE soleLanes3 FN( soleAnyOrthogonal3 )( soleLanes3 n )
{
	soleWideMask flat = LESS( MUL( n.x, n.x ), NUM( 0.5f ) );
	soleWide zero = NUM( 0.0f ), one = NUM( 1.0f );
	soleLanes3 axis = { PICK( flat, one, zero ), PICK( flat, zero, one ), zero };
	return FN( soleNormalize3 )( FN( soleReject3 )( axis, n ), ( soleLanes3 ){ zero, zero, one } );
}

// ------------------------------------------------------------------------------------------------------- quaternions

SOLE_INLINE soleLanes4 FN( solePick4 )( soleWideMask mask, soleLanes4 a, soleLanes4 b )
{
	return (
	    soleLanes4 ){ PICK( mask, a.x, b.x ), PICK( mask, a.y, b.y ), PICK( mask, a.z, b.z ), PICK( mask, a.w, b.w ) };
}

SOLE_INLINE soleLanes4 FN( soleIdentity4 )( void )
{
	return ( soleLanes4 ){ NUM( 0.0f ), NUM( 0.0f ), NUM( 0.0f ), NUM( 1.0f ) };
}

SOLE_INLINE soleLanes4 FN( soleMul4 )( soleLanes4 a, soleLanes4 b )
{
	return ( soleLanes4 ){
		ADD( ADD( MUL( a.w, b.x ), MUL( a.x, b.w ) ), SUB( MUL( a.y, b.z ), MUL( a.z, b.y ) ) ),
		ADD( ADD( MUL( a.w, b.y ), MUL( a.y, b.w ) ), SUB( MUL( a.z, b.x ), MUL( a.x, b.z ) ) ),
		ADD( ADD( MUL( a.w, b.z ), MUL( a.z, b.w ) ), SUB( MUL( a.x, b.y ), MUL( a.y, b.x ) ) ),
		SUB( SUB( MUL( a.w, b.w ), MUL( a.x, b.x ) ), ADD( MUL( a.y, b.y ), MUL( a.z, b.z ) ) ),
	};
}

/// conj( a ) b, the signs moved to where they cost nothing, zeros' signs kept.
SOLE_INLINE soleLanes4 FN( soleMulConjugate4 )( soleLanes4 a, soleLanes4 b )
{
	return ( soleLanes4 ){
		ADD( SUB( MUL( a.w, b.x ), MUL( a.x, b.w ) ), SUB( MUL( a.z, b.y ), MUL( a.y, b.z ) ) ),
		ADD( SUB( MUL( a.w, b.y ), MUL( a.y, b.w ) ), SUB( MUL( a.x, b.z ), MUL( a.z, b.x ) ) ),
		ADD( SUB( MUL( a.w, b.z ), MUL( a.z, b.w ) ), SUB( MUL( a.y, b.x ), MUL( a.x, b.y ) ) ),
		SUB( ADD( MUL( a.w, b.w ), MUL( a.x, b.x ) ), SUB( FN( soleNegWide )( MUL( a.y, b.y ) ), MUL( a.z, b.z ) ) ),
	};
}

SOLE_INLINE soleLanes4 FN( soleNormalize4 )( soleLanes4 q )
{
	soleWide squared = ADD( ADD( MUL( q.x, q.x ), MUL( q.y, q.y ) ), ADD( MUL( q.z, q.z ), MUL( q.w, q.w ) ) );
	soleWide s = DIV( NUM( 1.0f ), soleWide_Sqrt( squared ) );
	soleLanes4 unit = { MUL( s, q.x ), MUL( s, q.y ), MUL( s, q.z ), MUL( s, q.w ) };
	soleWideMask usable = FN( soleIsUsable )( squared );
	return soleWide_GetBits( usable ) == SOLE_ALL_LANES ? unit : FN( solePick4 )( usable, unit, FN( soleIdentity4 )() );
}

SOLE_INLINE soleLanes3 FN( soleRotate3 )( soleLanes4 q, soleLanes3 v )
{
	soleLanes3 u = { q.x, q.y, q.z };
	soleLanes3 t = FN( soleScale3 )( NUM( 2.0f ), FN( soleCross3 )( u, v ) );
	return FN( soleAdd3 )( FN( soleMulAdd3 )( v, q.w, t ), FN( soleCross3 )( u, t ) );
}

SOLE_INLINE soleLanes4 FN( soleFromTo4 )( soleLanes3 from, soleLanes3 to, soleLanes3 halfTurnAxis )
{
	soleLanes3 sum = FN( soleAdd3 )( from, to );
	soleWide w = MUL( NUM( 0.5f ), FN( soleDot3 )( sum, sum ) );
	soleLanes3 c = FN( soleCross3 )( from, to );
	soleLanes4 turn = FN( soleNormalize4 )( ( soleLanes4 ){ c.x, c.y, c.z, w } );
	soleWideMask opposite = LESS( w, NUM( 1e-6f ) );
	if ( soleWide_GetBits( opposite ) == 0 )
	{
		return turn;
	}
	soleLanes3 any = FN( soleAnyOrthogonal3 )( from );
	soleLanes3 n = FN( soleNormalize3 )( FN( soleReject3 )( halfTurnAxis, from ), any );
	return FN( solePick4 )( opposite, ( soleLanes4 ){ n.x, n.y, n.z, NUM( 0.0f ) }, turn );
}

SOLE_INLINE soleLanes4 FN( soleConjugate4 )( soleLanes4 q )
{
	return ( soleLanes4 ){ FN( soleNegWide )( q.x ), FN( soleNegWide )( q.y ), FN( soleNegWide )( q.z ), q.w };
}

SOLE_INLINE soleLanes4 FN( soleNlerp4 )( soleLanes4 a, soleLanes4 b, soleWide fraction )
{
	soleWide dot = ADD( ADD( MUL( a.x, b.x ), MUL( a.y, b.y ) ), ADD( MUL( a.z, b.z ), MUL( a.w, b.w ) ) );
	soleWide t = PICK( LESS( dot, NUM( 0.0f ) ), FN( soleNegWide )( fraction ), fraction );
	soleWide s = SUB( NUM( 1.0f ), fraction );
	soleLanes4 q = { ADD( MUL( s, a.x ), MUL( t, b.x ) ), ADD( MUL( s, a.y ), MUL( t, b.y ) ),
		ADD( MUL( s, a.z ), MUL( t, b.z ) ), ADD( MUL( s, a.w ), MUL( t, b.w ) ) };
	return FN( soleNormalize4 )( q );
}

// -------------------------------------------------------------------------------------------------------- half angles

SOLE_INLINE soleLanesHalf FN( soleWideHalfFromAngle )( soleWide angle )
{
	soleWide one = NUM( 1.0f );
	soleWide x = MUL( NUM( 0.25f ), FN( soleLimitWide )( angle, NUM( -3.14159265f ), NUM( 3.14159265f ) ) );
	soleWide z = MUL( x, x );
	soleWide s = SUB( NUM( 1.0f / 120.0f ), MUL( z, NUM( 1.0f / 5040.0f ) ) );
	s = MUL( x, SUB( one, MUL( z, SUB( NUM( 1.0f / 6.0f ), MUL( z, s ) ) ) ) );
	soleWide c = SUB( NUM( 1.0f / 720.0f ), MUL( z, NUM( 1.0f / 40320.0f ) ) );
	c = SUB( one, MUL( z, SUB( NUM( 0.5f ), MUL( z, SUB( NUM( 1.0f / 24.0f ), MUL( z, c ) ) ) ) ) );
	return ( soleLanesHalf ){ SUB( MUL( c, c ), MUL( s, s ) ), MUL( MUL( NUM( 2.0f ), s ), c ) };
}

SOLE_INLINE soleLanesHalf FN( soleMakeWideHalf )( soleWide cosine, soleWide sine )
{
	soleWide zero = NUM( 0.0f ), one = NUM( 1.0f );
	// Of squares: not below zero, and what is no number is not usable either way.
	soleWide length = soleWide_Sqrt( ADD( MUL( cosine, cosine ), MUL( sine, sine ) ) );
	soleWide c = ADD( one, DIV( cosine, length ) );
	soleWide s = DIV( sine, length );
	soleWide scale = DIV( one, soleWide_Sqrt( ADD( MUL( c, c ), MUL( s, s ) ) ) );
	soleLanesHalf half = { MUL( scale, c ), MUL( scale, s ) };
	// length >= 1e-20
	soleWideMask usable = LESS( NUM( SOLE_BELOW_LENGTH ), length );
	soleWideMask back = LESS( c, NUM( 1e-6f ) );
	if ( soleWide_GetBits( usable ) == SOLE_ALL_LANES && soleWide_GetBits( back ) == 0 )
	{
		return half;
	}
	soleWide side = PICK( LESS( s, zero ), NUM( -1.0f ), one );
	half = ( soleLanesHalf ){ PICK( back, zero, half.c ), PICK( back, side, half.s ) };
	return ( soleLanesHalf ){ PICK( usable, half.c, one ), PICK( usable, half.s, zero ) };
}

SOLE_INLINE soleLanesHalf FN( soleSubWideHalf )( soleLanesHalf a, soleLanesHalf b )
{
	return ( soleLanesHalf ){ ADD( MUL( a.c, b.c ), MUL( a.s, b.s ) ), SUB( MUL( a.s, b.c ), MUL( a.c, b.s ) ) };
}

SOLE_INLINE soleLanes4 FN( soleWideHalfRotation )( soleLanes3 axis, soleLanesHalf half )
{
	return ( soleLanes4 ){ MUL( half.s, axis.x ), MUL( half.s, axis.y ), MUL( half.s, axis.z ), half.c };
}

/// Halvings bring what is below 20 to 0.5 or less.
#define SOLE_WIDE_HALVINGS 6

SOLE_INLINE soleWide FN( soleExpNegativeWide )( soleWide x )
{
	soleWide half = NUM( 0.5f ), one = NUM( 1.0f );
	soleWide y = x;
	soleWideMask halved[SOLE_WIDE_HALVINGS];
	for ( int i = 0; i < SOLE_WIDE_HALVINGS; ++i )
	{
		halved[i] = LESS( half, y );
		y = PICK( halved[i], MUL( half, y ), y );
	}
	soleWide z = MUL( y, y );
	soleWide even = ADD( one, MUL( z, NUM( 0.1f ) ) );
	soleWide odd = MUL( y, ADD( half, MUL( z, NUM( 1.0f / 120.0f ) ) ) );
	soleWide r = DIV( SUB( even, odd ), ADD( even, odd ) );
	for ( int i = 0; i < SOLE_WIDE_HALVINGS; ++i )
	{
		r = PICK( halved[i], MUL( r, r ), r );
	}
	r = PICK( LESS( x, NUM( 20.0f ) ), r, NUM( 0.0f ) );
	return PICK( LESS( NUM( 0.0f ), x ), r, one );
}
