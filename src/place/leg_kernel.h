// SPDX-License-Identifier: MIT
// The two-bone leg of leg.c for many lanes at once, and the new local turns of its joints. Included after
// base/simd.h and base/wide_math.h, once for each width. The formulas and their names are those of leg.c; where that
// branches, lanes choose.

static inline soleLanes3 FN( soleLoad3 )( soleArray3 a, int32_t i )
{
	return ( soleLanes3 ){ soleWide_Load( a.x + i ), soleWide_Load( a.y + i ), soleWide_Load( a.z + i ) };
}

static inline soleLanes4 FN( soleLoad4 )( soleArray4 a, int32_t i )
{
	return ( soleLanes4 ){ soleWide_Load( a.x + i ), soleWide_Load( a.y + i ), soleWide_Load( a.z + i ),
		soleWide_Load( a.w + i ) };
}

static inline void FN( soleStore4 )( soleArray4 a, int32_t i, soleLanes4 q )
{
	soleWide_Store( a.x + i, q.x );
	soleWide_Store( a.y + i, q.y );
	soleWide_Store( a.z + i, q.z );
	soleWide_Store( a.w + i, q.w );
}

static inline soleLanes3 FN( soleFindWideAxis )(
    soleLanes3 k, soleLanes3 s, soleWide a, soleWide b, soleLanes3 u0, soleLanes3 rigHinge )
{
	soleLanes3 level = FN( soleReject3 )( rigHinge, u0 );
	soleLanes3 reference = level;
	if ( FN( soleTryNormalize3 )( &reference ) == false )
	{
		reference = FN( soleNormalize3 )( level, FN( soleAnyOrthogonal3 )( u0 ) );
	}
	soleLanes3 n = FN( soleScale3 )( DIV( NUM( 1.0f ), MUL( a, b ) ), FN( soleCross3 )( k, s ) );
	soleWide f = FN( soleLength3 )( n );
	soleWideMask other = LESS( FN( soleDot3 )( n, reference ), NUM( 0.0f ) );
	soleLanes3 axis = FN( solePick3 )( other, FN( soleScale3 )( NUM( -1.0f ), n ), n );
	soleWideMask straight = LESS( f, NUM( SOLE_NEARLY_STRAIGHT ) );
	soleLanes3 leaned = FN( soleMulAdd3 )( axis, SUB( NUM( SOLE_NEARLY_STRAIGHT ), f ), reference );
	axis = FN( solePick3 )( straight, leaned, axis );
	return FN( soleNormalize3 )( FN( soleReject3 )( axis, u0 ), reference );
}

static inline void FN( soleBendWide )(
    soleWide a, soleWide b, soleWide length, soleLanesHalf* flexion, soleLanesHalf* thigh )
{
	soleWide zero = NUM( 0.0f ), least = NUM( 1e-30f );
	soleWide most = ADD( a, b );
	soleWide e = soleWide_Max( SUB( most, length ), zero );
	soleWide p = MUL( ADD( most, length ), e );
	soleWide q = soleWide_Max( MUL( SUB( ADD( length, a ), b ), ADD( SUB( length, a ), b ) ), zero );
	soleWide p2 = soleWide_Max( MUL( SUB( ADD( b, length ), a ), e ), zero );
	soleWide q2 = soleWide_Max( MUL( ADD( most, length ), SUB( ADD( a, length ), b ) ), zero );
	soleWide r = soleWide_Sqrt( soleWide_Max( ADD( p, q ), least ) );
	soleWide r2 = soleWide_Sqrt( soleWide_Max( ADD( p2, q2 ), least ) );
	*flexion = ( soleLanesHalf ){ DIV( soleWide_Sqrt( q ), r ), DIV( soleWide_Sqrt( p ), r ) };
	*thigh = ( soleLanesHalf ){ DIV( soleWide_Sqrt( q2 ), r2 ), DIV( FN( soleNegWide )( soleWide_Sqrt( p2 ) ), r2 ) };
}

static inline soleWide FN( soleSoftenWide )( soleWide length, soleWide soft, soleWide hard )
{
	soleWide zone = SUB( hard, soft );
	soleWideMask wide = LESS( MUL( NUM( 1e-6f ), hard ), zone );
	soleWideMask beyond = LESS( soft, length );
	if ( soleWide_GetBits( beyond ) == 0 )
	{
		return length;
	}
	soleWide eased = SUB( hard, MUL( zone, FN( soleExpNegativeWide )( DIV( SUB( length, soft ), zone ) ) ) );
	return PICK( beyond, PICK( wide, eased, hard ), length );
}

/// Flags of lanes that a mask has.
static inline void FN( soleMarkLanes )( uint32_t* flags, soleWideMask mask, soleLegFlags flag )
{
	for ( uint32_t bits = soleWide_GetBits( mask ); bits != 0; bits &= bits - 1 )
	{
		flags[soleGetLowestBit( bits )] |= (uint32_t)flag;
	}
}

static inline soleWideMask FN( soleNone )( soleWideMask mask )
{
	soleWide one = PICK( mask, NUM( 0.0f ), NUM( 1.0f ) );
	return LESS( NUM( 0.5f ), one );
}

static inline void FN( soleSolveLanes )( const soleLegBatch* batch, int32_t i )
{
	soleLanes3 hip = FN( soleLoad3 )( batch->hip, i ), hinge = FN( soleLoad3 )( batch->hinge, i );
	soleLanes3 knee = FN( soleLoad3 )( batch->knee, i ), ankle = FN( soleLoad3 )( batch->ankle, i );
	soleLanes3 k = FN( soleSub3 )( knee, hip );
	soleLanes3 s = FN( soleSub3 )( ankle, knee );
	soleLanes3 d0 = FN( soleSub3 )( ankle, hip );
	soleLanes3 d1 = FN( soleSub3 )( FN( soleLoad3 )( batch->target, i ), hip );
	soleWide a = FN( soleLength3 )( k ), b = FN( soleLength3 )( s );
	soleWide length0 = FN( soleLength3 )( d0 ), length1 = FN( soleLength3 )( d1 );
	soleWide bones = ADD( a, b ), zero = NUM( 0.0f ), one = NUM( 1.0f );

	// A sum that is finite is its own difference from zero; one that is not is none.
	soleWide sum = ADD( ADD( length0, length1 ), bones );
	soleWide nothing =
	    ADD( SUB( sum, sum ), ADD( ADD( SUB( hinge.x, hinge.x ), SUB( hinge.y, hinge.y ) ), SUB( hinge.z, hinge.z ) ) );
	soleWide least = MUL( NUM( 1e-4f ), bones );
	soleWideMask solvable = soleWide_And( LESS( least, length0 ), LESS( least, length1 ) );
	solvable = soleWide_And( solvable, LESS( nothing, one ) );
	soleWideMask two = soleWide_And( LESS( MUL( NUM( 1e-6f ), bones ), a ), LESS( MUL( NUM( 1e-6f ), bones ), b ) );
	two = soleWide_And( two, solvable );

	soleLanes3 u0 = FN( soleScale3 )( DIV( one, length0 ), d0 );
	soleLanes3 u1 = FN( soleScale3 )( DIV( one, length1 ), d1 );
	soleWide hard = MUL( FN( soleClampWide )( soleWide_Load( batch->reach + i ), zero, one ), bones );
	soleWide soft = FN( soleClampWide )( SUB( hard, soleWide_Load( batch->softZone + i ) ), zero, hard );
	soleWide fold = MUL( FN( soleClampWide )( soleWide_Load( batch->fold + i ), zero, one ), bones );

	soleLanes3 n = FN( soleFindWideAxis )( k, s, a, b, u0, hinge );
	soleLanes3 kp = FN( soleReject3 )( k, n );
	soleLanes3 sp = FN( soleReject3 )( s, n );
	soleWide ap = FN( soleLength3 )( kp ), bp = FN( soleLength3 )( sp );
	soleWide difference = PICK( LESS( bp, ap ), SUB( ap, bp ), SUB( bp, ap ) );
	soleWide length = soleWide_Max( FN( soleSoftenWide )( length1, soft, hard ), fold );
	soleWide shortest = ADD( MUL( difference, NUM( 1.0f + 1e-4f ) ), MUL( NUM( 1e-6f ), bones ) );
	length = FN( soleClampWide )( length, shortest, ADD( ap, bp ) );

	soleLanesHalf flexion, thigh;
	soleLanesHalf flexion0 =
	    FN( soleMakeWideHalf )( FN( soleDot3 )( kp, sp ), FN( soleDot3 )( n, FN( soleCross3 )( kp, sp ) ) );
	soleLanesHalf thigh0 =
	    FN( soleMakeWideHalf )( FN( soleDot3 )( kp, u0 ), FN( soleDot3 )( n, FN( soleCross3 )( u0, kp ) ) );
	FN( soleBendWide )( ap, bp, length, &flexion, &thigh );
	soleLanes4 kneeTurn = FN( soleWideHalfRotation )( n, FN( soleSubWideHalf )( flexion, flexion0 ) );
	soleLanes4 bend = FN( soleWideHalfRotation )( n, FN( soleSubWideHalf )( thigh, thigh0 ) );
	soleLanes4 hipTurn = FN( soleNormalize4 )( FN( soleMul4 )( FN( soleFromTo4 )( u0, u1, n ), bend ) );
	soleLanes3 shin = FN( soleRotate3 )( kneeTurn, s );
	soleLanes3 reached = FN( soleAdd3 )( hip, FN( soleRotate3 )( hipTurn, FN( soleAdd3 )( k, shin ) ) );

	uint32_t flags[SOLE_WIDTH] = { 0 };
	FN( soleMarkLanes )( flags, soleWide_And( two, LESS( soft, length1 ) ), sole_legSoftened );
	FN( soleMarkLanes )( flags, soleWide_And( two, LESS( hard, length1 ) ), sole_legOutOfReach );
	soleWideMask folded = soleWide_Or( LESS( length1, fold ), LESS( length1, shortest ) );
	FN( soleMarkLanes )( flags, soleWide_And( two, folded ), sole_legFolded );
	soleWideMask degenerate = FN( soleNone )( two );
	if ( soleWide_GetBits( degenerate ) != 0 )
	{
		// One bone can only point; what is none stays as it is.
		FN( soleMarkLanes )( flags, degenerate, sole_legDegenerate );
		soleLanes4 identity = FN( soleIdentity4 )();
		soleLanes4 point = FN( solePick4 )( solvable, FN( soleFromTo4 )( u0, u1, hinge ), identity );
		soleLanes3 pointed = FN( soleAdd3 )( hip, FN( soleRotate3 )( point, d0 ) );
		hipTurn = FN( solePick4 )( two, hipTurn, point );
		kneeTurn = FN( solePick4 )( two, kneeTurn, identity );
		reached = FN( solePick3 )( two, reached, FN( solePick3 )( solvable, pointed, ankle ) );
	}
	memcpy( batch->flags + i, flags, sizeof flags );
	soleWide_Store( batch->reached.x + i, reached.x );
	soleWide_Store( batch->reached.y + i, reached.y );
	soleWide_Store( batch->reached.z + i, reached.z );

	soleLanes4 parent = FN( soleLoad4 )( batch->parent, i );
	soleLanes4 thighTurn = FN( soleLoad4 )( batch->thigh, i ), shinTurn = FN( soleLoad4 )( batch->shin, i );
	soleLanes4 newThigh = FN( soleMul4 )( hipTurn, thighTurn );
	FN( soleStore4 )
	( batch->thigh_l, i, FN( soleNormalize4 )( FN( soleMul4 )( FN( soleConjugate4 )( parent ), newThigh ) ) );
	soleLanes4 newShin = FN( soleMul4 )( kneeTurn, shinTurn );
	FN( soleStore4 )
	( batch->shin_l, i, FN( soleNormalize4 )( FN( soleMul4 )( FN( soleConjugate4 )( thighTurn ), newShin ) ) );
	soleLanes4 carried = FN( soleMul4 )( FN( soleMul4 )( hipTurn, kneeTurn ), shinTurn );
	FN( soleStore4 )
	( batch->foot_l, i,
	    FN( soleNormalize4 )( FN( soleMul4 )( FN( soleConjugate4 )( carried ), FN( soleLoad4 )( batch->foot, i ) ) ) );
}

static void FN( soleSolveLegLanes )( const soleLegBatch* batch, int32_t first, int32_t end )
{
	for ( int32_t i = first; i < end; i += SOLE_WIDTH )
	{
		FN( soleSolveLanes )( batch, i );
	}
}
