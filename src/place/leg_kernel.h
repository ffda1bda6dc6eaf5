// SPDX-License-Identifier: MIT
// The two-bone leg of leg.c for many lanes at once, and the new local turns of its joints. Included after
// base/simd.h and base/wide_math.h, once for each width. The formulas and their names are those of leg.c; where that
// branches, lanes choose.
//
// One leg is a long chain of roots and divisions that wait for each other, longer than what a machine looks ahead. So a
// few vectors of legs go through it side by side, in short passes whose steps do not depend on those of the next
// vector: a fifth to a quarter faster than one vector from end to end.

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
	soleLanes3 reference = FN( soleReject3 )( rigHinge, u0 );
	if ( FN( soleTryNormalize3 )( &reference ) == false )
	{
		reference = FN( soleNormalize3 )( reference, FN( soleAnyOrthogonal3 )( u0 ) );
	}
	soleLanes3 n = FN( soleScale3 )( DIV( NUM( 1.0f ), MUL( a, b ) ), FN( soleCross3 )( k, s ) );
	soleWide f = FN( soleLength3 )( n );
	soleWideMask other = LESS( FN( soleDot3 )( n, reference ), NUM( 0.0f ) );
	soleLanes3 axis = FN( soleScale3 )( PICK( other, NUM( -1.0f ), NUM( 1.0f ) ), n );
	soleWideMask straight = LESS( f, NUM( SOLE_NEARLY_STRAIGHT ) );
	if ( soleWide_GetBits( straight ) != 0 )
	{
		soleLanes3 leaned = FN( soleMulAdd3 )( axis, SUB( NUM( SOLE_NEARLY_STRAIGHT ), f ), reference );
		axis = FN( solePick3 )( straight, leaned, axis );
	}
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

// ------------------------------------------------------------------------------------------------------------ passes

#undef soleLegLanes
#define soleLegLanes SOLE_WIDE_NAME( soleLegLanes_ )

/// What passes over a block leave for those that follow, a vector of legs each.
typedef struct soleLegLanes
{
	soleLanes3 k, s;              // knee from hip, ankle from knee
	soleLanes3 u0, u1;            // to where the ankle is, and to where it should be
	soleWide a, b;                // lengths of k and s
	soleWide length1;             // of the way to the target
	soleLanes3 n;                 // axis that the knee bends about
	soleWide ap, bp;              // lengths seen along n
	soleLanesHalf flexion, thigh; // as animated, then what they change by
	soleWide flags;               // as numbers: they are small
	soleWideMask solvable, two;   // two: with two bones that can be bent
	soleLanes4 hipTurn, kneeTurn;
} soleLegLanes;

static inline void FN( soleMeasureLanes )( const soleLegBatch* batch, int32_t i, soleLegLanes* leg )
{
	soleLanes3 hip = FN( soleLoad3 )( batch->hip, i ), hinge = FN( soleLoad3 )( batch->hinge, i );
	soleLanes3 knee = FN( soleLoad3 )( batch->knee, i ), ankle = FN( soleLoad3 )( batch->ankle, i );
	leg->k = FN( soleSub3 )( knee, hip );
	leg->s = FN( soleSub3 )( ankle, knee );
	soleLanes3 d0 = FN( soleSub3 )( ankle, hip );
	soleLanes3 d1 = FN( soleSub3 )( FN( soleLoad3 )( batch->target, i ), hip );
	soleWide a = FN( soleLength3 )( leg->k ), b = FN( soleLength3 )( leg->s );
	soleWide length0 = FN( soleLength3 )( d0 ), length1 = FN( soleLength3 )( d1 );
	soleWide bones = ADD( a, b ), one = NUM( 1.0f );

	// A sum that is finite is its own difference from zero; one that is not is none.
	soleWide sum = ADD( ADD( length0, length1 ), bones );
	soleWide nothing =
	    ADD( SUB( sum, sum ), ADD( ADD( SUB( hinge.x, hinge.x ), SUB( hinge.y, hinge.y ) ), SUB( hinge.z, hinge.z ) ) );
	soleWide least = MUL( NUM( 1e-4f ), bones );
	soleWideMask solvable = soleWide_And( LESS( least, length0 ), LESS( least, length1 ) );
	leg->solvable = soleWide_And( solvable, LESS( nothing, one ) );
	soleWide shortest = MUL( NUM( 1e-6f ), bones );
	leg->two = soleWide_And( soleWide_And( LESS( shortest, a ), LESS( shortest, b ) ), leg->solvable );
	leg->u0 = FN( soleScale3 )( DIV( one, length0 ), d0 );
	leg->u1 = FN( soleScale3 )( DIV( one, length1 ), d1 );
	leg->a = a;
	leg->b = b;
	leg->length1 = length1;
}

static inline void FN( soleFindLaneAxes )( const soleLegBatch* batch, int32_t i, soleLegLanes* leg )
{
	leg->n = FN( soleFindWideAxis )( leg->k, leg->s, leg->a, leg->b, leg->u0, FN( soleLoad3 )( batch->hinge, i ) );
}

static inline void FN( soleFindLaneHalves )( soleLegLanes* leg )
{
	soleLanes3 n = leg->n;
	soleLanes3 kp = FN( soleReject3 )( leg->k, n );
	soleLanes3 sp = FN( soleReject3 )( leg->s, n );
	leg->ap = FN( soleLength3 )( kp );
	leg->bp = FN( soleLength3 )( sp );
	leg->flexion = FN( soleMakeWideHalf )( FN( soleDot3 )( kp, sp ), FN( soleDot3 )( n, FN( soleCross3 )( kp, sp ) ) );
	leg->thigh =
	    FN( soleMakeWideHalf )( FN( soleDot3 )( kp, leg->u0 ), FN( soleDot3 )( n, FN( soleCross3 )( leg->u0, kp ) ) );
}

/// A flag as a number where a mask is set, else zero.
static inline soleWide FN( soleFlagWide )( soleWideMask mask, soleLegFlags flag )
{
	return PICK( mask, NUM( (float)flag ), NUM( 0.0f ) );
}

static inline void FN( soleBendLanes )( const soleLegBatch* batch, int32_t i, soleLegLanes* leg )
{
	soleWide zero = NUM( 0.0f ), one = NUM( 1.0f ), bones = ADD( leg->a, leg->b );
	soleWide hard = MUL( FN( soleLimitWide )( soleWide_Load( batch->reach + i ), zero, one ), bones );
	soleWide soft = FN( soleLimitWide )( SUB( hard, soleWide_Load( batch->softZone + i ) ), zero, hard );
	soleWide fold = MUL( FN( soleLimitWide )( soleWide_Load( batch->fold + i ), zero, one ), bones );
	soleWide ap = leg->ap, bp = leg->bp, length1 = leg->length1;
	soleWide difference = PICK( LESS( bp, ap ), SUB( ap, bp ), SUB( bp, ap ) );
	soleWide length = soleWide_Max( FN( soleSoftenWide )( length1, soft, hard ), fold );
	soleWide shortest = ADD( MUL( difference, NUM( 1.0f + 1e-4f ) ), MUL( NUM( 1e-6f ), bones ) );
	length = FN( soleClampWide )( length, shortest, ADD( ap, bp ) );
	soleLanesHalf flexion, thigh;
	FN( soleBendWide )( ap, bp, length, &flexion, &thigh );
	leg->flexion = FN( soleSubWideHalf )( flexion, leg->flexion );
	leg->thigh = FN( soleSubWideHalf )( thigh, leg->thigh );

	soleWideMask folded = soleWide_Or( LESS( length1, fold ), LESS( length1, shortest ) );
	soleWide flags = FN( soleFlagWide )( LESS( soft, length1 ), sole_legSoftened );
	flags = ADD( flags, FN( soleFlagWide )( LESS( hard, length1 ), sole_legOutOfReach ) );
	flags = ADD( flags, FN( soleFlagWide )( folded, sole_legFolded ) );
	leg->flags = PICK( leg->two, flags, NUM( (float)sole_legDegenerate ) );
}

static inline void FN( soleStoreFlags )( uint32_t* flags, soleWide numbers )
{
	float lanes[SOLE_WIDTH];
	soleWide_Store( lanes, numbers );
	for ( int i = 0; i < SOLE_WIDTH; ++i )
	{
		flags[i] = (uint32_t)(int32_t)lanes[i];
	}
}

static inline void FN( soleTurnLanes )( const soleLegBatch* batch, int32_t i, soleLegLanes* leg )
{
	soleLanes3 hip = FN( soleLoad3 )( batch->hip, i );
	soleLanes4 kneeTurn = FN( soleWideHalfRotation )( leg->n, leg->flexion );
	soleLanes4 bend = FN( soleWideHalfRotation )( leg->n, leg->thigh );
	soleLanes4 hipTurn = FN( soleNormalize4 )( FN( soleMul4 )( FN( soleFromTo4 )( leg->u0, leg->u1, leg->n ), bend ) );
	soleLanes3 shin = FN( soleRotate3 )( kneeTurn, leg->s );
	soleLanes3 reached = FN( soleAdd3 )( hip, FN( soleRotate3 )( hipTurn, FN( soleAdd3 )( leg->k, shin ) ) );
	if ( soleWide_GetBits( leg->two ) != SOLE_ALL_LANES )
	{
		// One bone can only point; what is none stays as it is.
		soleLanes4 identity = FN( soleIdentity4 )();
		soleLanes3 hinge = FN( soleLoad3 )( batch->hinge, i ), ankle = FN( soleLoad3 )( batch->ankle, i );
		soleLanes4 point = FN( soleFromTo4 )( leg->u0, leg->u1, hinge );
		point = FN( solePick4 )( leg->solvable, point, identity );
		soleLanes3 pointed = FN( soleAdd3 )( hip, FN( soleRotate3 )( point, FN( soleSub3 )( ankle, hip ) ) );
		hipTurn = FN( solePick4 )( leg->two, hipTurn, point );
		kneeTurn = FN( solePick4 )( leg->two, kneeTurn, identity );
		reached = FN( solePick3 )( leg->two, reached, FN( solePick3 )( leg->solvable, pointed, ankle ) );
	}
	leg->hipTurn = hipTurn;
	leg->kneeTurn = kneeTurn;
	FN( soleStoreFlags )( batch->flags + i, leg->flags );
	soleWide_Store( batch->reached.x + i, reached.x );
	soleWide_Store( batch->reached.y + i, reached.y );
	soleWide_Store( batch->reached.z + i, reached.z );
}

static inline void FN( soleWriteLanes )( const soleLegBatch* batch, int32_t i, const soleLegLanes* leg )
{
	soleLanes4 parent = FN( soleLoad4 )( batch->parent, i );
	soleLanes4 thigh = FN( soleLoad4 )( batch->thigh, i ), shin = FN( soleLoad4 )( batch->shin, i );
	soleLanes4 newThigh = FN( soleMul4 )( leg->hipTurn, thigh );
	newThigh = FN( soleNormalize4 )( FN( soleMulConjugate4 )( parent, newThigh ) );
	FN( soleStore4 )( batch->thigh_l, i, newThigh );
	soleLanes4 bent = FN( soleMul4 )( leg->kneeTurn, shin );
	soleLanes4 newShin = FN( soleNormalize4 )( FN( soleMulConjugate4 )( thigh, bent ) );
	FN( soleStore4 )( batch->shin_l, i, newShin );
	soleLanes4 carried = FN( soleMul4 )( leg->hipTurn, bent );
	soleLanes4 foot = FN( soleMulConjugate4 )( carried, FN( soleLoad4 )( batch->foot, i ) );
	FN( soleStore4 )( batch->foot_l, i, FN( soleNormalize4 )( foot ) );
}

/// Vectors that go side by side: enough to overlap, few enough that what passes leave stays in the nearest cache.
#define SOLE_BLOCK 4

/// All passes but the last over some vectors of legs.
static inline void FN( soleTurnBlock )( const soleLegBatch* batch, int32_t start, int32_t count, soleLegLanes* legs )
{
	for ( int32_t k = 0; k < count; ++k )
	{
		FN( soleMeasureLanes )( batch, start + k * SOLE_WIDTH, legs + k );
	}
	for ( int32_t k = 0; k < count; ++k )
	{
		FN( soleFindLaneAxes )( batch, start + k * SOLE_WIDTH, legs + k );
	}
	for ( int32_t k = 0; k < count; ++k )
	{
		FN( soleFindLaneHalves )( legs + k );
	}
	for ( int32_t k = 0; k < count; ++k )
	{
		FN( soleBendLanes )( batch, start + k * SOLE_WIDTH, legs + k );
	}
	for ( int32_t k = 0; k < count; ++k )
	{
		FN( soleTurnLanes )( batch, start + k * SOLE_WIDTH, legs + k );
	}
}

static void FN( soleSolveLegLanes )( const soleLegBatch* batch, int32_t first, int32_t end )
{
	soleLegLanes legs[SOLE_BLOCK];
	for ( int32_t start = first; start < end; start += SOLE_BLOCK * SOLE_WIDTH )
	{
		int32_t left = ( end - start ) / SOLE_WIDTH;
		int32_t count = left < SOLE_BLOCK ? left : SOLE_BLOCK;
		FN( soleTurnBlock )( batch, start, count, legs );
		for ( int32_t k = 0; k < count; ++k )
		{
			FN( soleWriteLanes )( batch, start + k * SOLE_WIDTH, legs + k );
		}
	}
}
