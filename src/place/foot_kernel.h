// SPDX-License-Identifier: MIT
// Legs and ankles of leg.c and ankle.c for many lanes at once, for legs of hip, knee and ankle with toes. Included once
// for each width, as place/leg_kernel.h is, through whose passes they go first. Lanes whose ankle may be at its limits
// are told, and left to ankle.c.
#include "place/leg_kernel.h"

/// The turn's part about a unit axis.
static inline soleLanes4 FN( soleTwistLanes )( soleLanes4 q, soleLanes3 axis )
{
	soleWide d = ADD( ADD( MUL( q.x, axis.x ), MUL( q.y, axis.y ) ), MUL( q.z, axis.z ) );
	return FN( soleNormalize4 )( ( soleLanes4 ){ MUL( d, axis.x ), MUL( d, axis.y ), MUL( d, axis.z ), q.w } );
}

static inline soleLanesHalf FN( soleTwistHalfLanes )( soleLanes4 twist, soleLanes3 axis )
{
	soleWide s = ADD( ADD( MUL( twist.x, axis.x ), MUL( twist.y, axis.y ) ), MUL( twist.z, axis.z ) );
	soleWide sign = PICK( LESS( twist.w, NUM( 0.0f ) ), NUM( -1.0f ), NUM( 1.0f ) );
	return ( soleLanesHalf ){ MUL( sign, twist.w ), MUL( sign, s ) };
}

static inline soleLanes4 FN( soleConjugate4 )( soleLanes4 q )
{
	return ( soleLanes4 ){ FN( soleNegWide )( q.x ), FN( soleNegWide )( q.y ), FN( soleNegWide )( q.z ), q.w };
}

static inline soleLanes4 FN( soleNlerp4 )( soleLanes4 a, soleLanes4 b, soleWide fraction )
{
	soleWide dot = ADD( ADD( MUL( a.x, b.x ), MUL( a.y, b.y ) ), ADD( MUL( a.z, b.z ), MUL( a.w, b.w ) ) );
	soleWide t = PICK( LESS( dot, NUM( 0.0f ) ), FN( soleNegWide )( fraction ), fraction );
	soleWide s = SUB( NUM( 1.0f ), fraction );
	soleLanes4 q = { ADD( MUL( s, a.x ), MUL( t, b.x ) ), ADD( MUL( s, a.y ), MUL( t, b.y ) ),
		ADD( MUL( s, a.z ), MUL( t, b.z ) ), ADD( MUL( s, a.w ), MUL( t, b.w ) ) };
	return FN( soleNormalize4 )( q );
}

static inline soleLanes3 FN( soleRow3 )( soleFootRow* rows, int32_t i )
{
	return ( soleLanes3 ){ soleWide_Load( rows[0] + i ), soleWide_Load( rows[1] + i ), soleWide_Load( rows[2] + i ) };
}

static inline soleLanes4 FN( soleRow4 )( soleFootRow* rows, int32_t i )
{
	return ( soleLanes4 ){ soleWide_Load( rows[0] + i ), soleWide_Load( rows[1] + i ), soleWide_Load( rows[2] + i ),
		soleWide_Load( rows[3] + i ) };
}

static inline void FN( soleKeep4 )( soleFootRow* rows, int32_t i, soleLanes4 q )
{
	FN( soleStore4 )( ( soleArray4 ){ rows[0], rows[1], rows[2], rows[3] }, i, q );
}

// ------------------------------------------------------------------------------------------------------------ passes

/// Strictly within limits: what is at one of them is left to the plain code, whichever side it is on.
static inline soleWideMask FN( soleIsBetween )( soleWide x, soleFootRow low, soleFootRow high, int32_t i )
{
	return soleWide_And( LESS( soleWide_Load( low + i ), x ), LESS( x, soleWide_Load( high + i ) ) );
}

/// soleTakeApart() and soleIsWithin() of ankle.c.
static inline void FN( soleCheckAnkles )( soleFootLanes* f, int32_t i )
{
	soleLanes4 turn = FN( soleMul4 )( FN( soleRow4 )( f->hipTurn, i ), FN( soleRow4 )( f->kneeTurn, i ) );
	soleLanes4 shin = FN( soleMul4 )( turn, FN( soleRow4 )( f->shin, i ) );
	soleLanes4 neutral = FN( soleMul4 )( shin, FN( soleRow4 )( f->neutral, i ) );
	soleLanes4 q = FN( soleMulConjugate4 )( neutral, FN( soleRow4 )( f->reachedFoot, i ) );
	soleLanes3 up = FN( soleRow3 )( f->up, i ), side = FN( soleRow3 )( f->side, i );
	soleLanes3 ahead = FN( soleRow3 )( f->ahead, i );
	soleLanes4 twist = FN( soleTwistLanes )( q, up );
	soleLanes4 q1 = FN( soleMul4 )( q, FN( soleConjugate4 )( twist ) );
	soleLanes4 pitch = FN( soleTwistLanes )( q1, side );
	soleLanes4 roll = FN( soleTwistLanes )( FN( soleMulConjugate4 )( pitch, q1 ), ahead );
	soleWideMask within = FN( soleIsBetween )( FN( soleTwistHalfLanes )( pitch, side ).s, f->low[0], f->high[0], i );
	soleWide rolled = FN( soleTwistHalfLanes )( roll, ahead ).s, twisted = FN( soleTwistHalfLanes )( twist, up ).s;
	within = soleWide_And( within, FN( soleIsBetween )( rolled, f->low[1], f->high[1], i ) );
	within = soleWide_And( within, FN( soleIsBetween )( twisted, f->low[2], f->high[2], i ) );
	uint32_t bits = soleWide_GetBits( within );
	for ( int32_t k = 0; k < SOLE_WIDTH; ++k )
	{
		f->within[i + k] = bits >> k & 1u;
	}
}

static inline void FN( soleAlignLanes )( soleFootLanes* f, int32_t i )
{
	soleLanes4 hipTurn = FN( soleRow4 )( f->hipTurn, i ), kneeTurn = FN( soleRow4 )( f->kneeTurn, i );
	soleLanes4 thigh = FN( soleMul4 )( hipTurn, FN( soleRow4 )( f->thigh, i ) );
	thigh = FN( soleMulConjugate4 )( FN( soleRow4 )( f->thighParent, i ), thigh );
	FN( soleKeep4 )( f->thigh_l, i, FN( soleNormalize4 )( thigh ) );
	soleLanes4 shin = FN( soleMul4 )( kneeTurn, FN( soleRow4 )( f->shin, i ) );
	shin = FN( soleMulConjugate4 )( FN( soleRow4 )( f->shinParent, i ), shin );
	FN( soleKeep4 )( f->shin_l, i, FN( soleNormalize4 )( shin ) );
	soleLanes4 parent = FN( soleMul4 )( FN( soleMul4 )( hipTurn, kneeTurn ), FN( soleRow4 )( f->footParent, i ) );
	soleLanes4 foot = FN( soleMulConjugate4 )( parent, FN( soleRow4 )( f->reachedFoot, i ) );
	FN( soleKeep4 )( f->foot_l, i, FN( soleNormalize4 )( foot ) );
}

/// soleBendToe() of ankle.c.
static inline soleLanes4 FN( soleBendLaneToes )( soleFootLanes* f, int32_t i, soleLanes4 foot )
{
	soleLanes4 toe = FN( soleRow4 )( f->toe, i );
	soleLanes4 local = FN( soleMulConjugate4 )( FN( soleRow4 )( f->foot, i ), toe );
	soleLanes4 carried = FN( soleMul4 )( foot, local );
	soleLanes3 side = FN( soleRotate3 )( foot, FN( soleRow3 )( f->side, i ) );
	soleLanesHalf slope = FN( soleMakeWideHalf )( NUM( 1.0f ), soleWide_Load( f->toeSlope + i ) );
	soleLanes4 wanted = FN( soleMul4 )( FN( soleRow4 )( f->image, i ), toe );
	wanted = FN( soleMul4 )( FN( soleWideHalfRotation )( side, slope ), wanted );
	soleLanes4 turn = FN( soleMul4 )( wanted, FN( soleConjugate4 )( carried ) );
	soleLanesHalf bend = FN( soleTwistHalfLanes )( FN( soleTwistLanes )( turn, side ), side );
	soleWide upC = soleWide_Load( f->toesUp[0] + i ), upS = soleWide_Load( f->toesUp[1] + i );
	soleWide downC = soleWide_Load( f->toesDown[0] + i ), downS = soleWide_Load( f->toesDown[1] + i );
	soleWideMask above = LESS( upS, bend.s ), below = LESS( bend.s, downS );
	bend.c = PICK( above, upC, PICK( below, downC, bend.c ) );
	bend.s = PICK( above, upS, PICK( below, downS, bend.s ) );
	soleWideMask rises = LESS( NUM( 0.0f ), bend.s );
	soleWide share = PICK( rises, soleWide_Load( f->riseShare + i ), soleWide_Load( f->fallShare + i ) );
	soleLanes4 bent = FN( soleMul4 )( FN( soleWideHalfRotation )( side, bend ), carried );
	return FN( soleNlerp4 )( carried, bent, share );
}

static inline void FN( soleTurnLaneToes )( soleFootLanes* f, int32_t i )
{
	soleLanes4 foot = FN( soleRow4 )( f->reachedFoot, i );
	soleLanes4 toe = FN( soleMulConjugate4 )( foot, FN( soleBendLaneToes )( f, i, foot ) );
	soleLanes4 parent = FN( soleMulConjugate4 )( FN( soleRow4 )( f->foot, i ), FN( soleRow4 )( f->toeParent, i ) );
	FN( soleKeep4 )( f->toe_l, i, FN( soleNormalize4 )( FN( soleMulConjugate4 )( parent, toe ) ) );
}

static inline void FN( soleKeepTurns )( soleFootLanes* f, int32_t i, const soleLegLanes* leg )
{
	// No share of a twist, as a product that may change the sign of a zero.
	FN( soleKeep4 )( f->hipTurn, i, FN( soleMul4 )( FN( soleIdentity4 )(), leg->hipTurn ) );
	FN( soleKeep4 )( f->kneeTurn, i, leg->kneeTurn );
}

static void FN( soleFinishFootLanes )( soleFootLanes* f, int32_t end )
{
	soleLegBatch batch = { .count = end,
		.hip = { f->hip[0], f->hip[1], f->hip[2] },
		.knee = { f->knee[0], f->knee[1], f->knee[2] },
		.ankle = { f->ankle[0], f->ankle[1], f->ankle[2] },
		.target = { f->target[0], f->target[1], f->target[2] },
		.hinge = { f->hinge[0], f->hinge[1], f->hinge[2] },
		.reach = f->reach,
		.fold = f->fold,
		.softZone = f->softZone,
		.reached = { f->reached[0], f->reached[1], f->reached[2] },
		.flags = f->flags };
	soleLegLanes legs[SOLE_BLOCK];
	for ( int32_t start = 0; start < end; start += SOLE_BLOCK * SOLE_WIDTH )
	{
		int32_t left = ( end - start ) / SOLE_WIDTH;
		int32_t count = left < SOLE_BLOCK ? left : SOLE_BLOCK;
		FN( soleTurnBlock )( &batch, start, count, legs );
		for ( int32_t k = 0; k < count; ++k )
		{
			FN( soleKeepTurns )( f, start + k * SOLE_WIDTH, legs + k );
		}
		for ( int32_t k = 0; k < count; ++k )
		{
			FN( soleCheckAnkles )( f, start + k * SOLE_WIDTH );
		}
		for ( int32_t k = 0; k < count; ++k )
		{
			FN( soleAlignLanes )( f, start + k * SOLE_WIDTH );
		}
		for ( int32_t k = 0; k < count; ++k )
		{
			FN( soleTurnLaneToes )( f, start + k * SOLE_WIDTH );
		}
	}
}
