// SPDSOLE_LANES-License-Identifier: MIT
// Sensing of sense.c for many lanes at once. Included after base/simd.h and base/wide_math.h, once for each width. The
// formulas and their names are those of sense.c; where that branches on what is animated, lanes choose.
#undef soleLanesSpace
#define soleLanesSpace SOLE_WIDE_NAME( soleLanesSpace_ )

typedef struct soleLanesSpace
{
	soleLanes3 place;
	soleLanes4 turn;
	soleLanes3 scale;
} soleLanesSpace;

SOLE_INLINE soleLanesSpace FN( soleReadSpace )( soleSenseSpace* space, int32_t i )
{
	soleRow* turn = space->turn;
	return ( soleLanesSpace ){ FN( soleRow3 )( space->place, i ),
		{ soleWide_Load( turn[0] + i ), soleWide_Load( turn[1] + i ), soleWide_Load( turn[2] + i ),
		    soleWide_Load( turn[3] + i ) },
		FN( soleRow3 )( space->scale, i ) };
}

SOLE_INLINE soleLanes3 FN( soleSet3 )( soleVec3 v )
{
	return ( soleLanes3 ){ NUM( v.x ), NUM( v.y ), NUM( v.z ) };
}

SOLE_INLINE soleLanes3 FN( soleMul3 )( soleLanes3 a, soleLanes3 b )
{
	return ( soleLanes3 ){ MUL( a.x, b.x ), MUL( a.y, b.y ), MUL( a.z, b.z ) };
}

SOLE_INLINE soleLanes3 FN( soleLanesPoint )( const soleLanesSpace* t, soleLanes3 p )
{
	return FN( soleAdd3 )( FN( soleRotate3 )( t->turn, FN( soleMul3 )( t->scale, p ) ), t->place );
}

/// Not zero in lanes that hold what is no number.
SOLE_INLINE soleWide FN( soleFindNothing )( const soleLanesSpace* t )
{
	soleLanes3 p = t->place, s = t->scale;
	soleLanes4 q = t->turn;
	soleWide nothing = ADD( ADD( SUB( p.x, p.x ), SUB( p.y, p.y ) ), SUB( p.z, p.z ) );
	nothing = ADD( nothing, ADD( ADD( SUB( s.x, s.x ), SUB( s.y, s.y ) ), SUB( s.z, s.z ) ) );
	return ADD( nothing, ADD( ADD( SUB( q.x, q.x ), SUB( q.y, q.y ) ), ADD( SUB( q.z, q.z ), SUB( q.w, q.w ) ) ) );
}

static inline void FN( soleEvaluateLanes )( soleSenseLanes* f, int32_t i )
{
	for ( int32_t k = 0; k < f->rig->slotCount; ++k )
	{
		soleSenseSpace* slot = f->slots + k;
		int32_t parent = f->rig->slotParents[k];
		soleLanesSpace above = FN( soleReadSpace )( parent == SOLE_NONE ? &f->root : f->slots + parent, i );
		soleLanesSpace local = FN( soleReadSpace )( slot, i );
		FN( soleKeep3 )( slot->place, i, FN( soleLanesPoint )( &above, local.place ) );
		soleLanes4 turn = FN( soleMul4 )( above.turn, FN( soleNormalize4 )( local.turn ) );
		soleWide_Store( slot->turn[0] + i, turn.x );
		soleWide_Store( slot->turn[1] + i, turn.y );
		soleWide_Store( slot->turn[2] + i, turn.z );
		soleWide_Store( slot->turn[3] + i, turn.w );
		FN( soleKeep3 )( slot->scale, i, FN( soleMul3 )( above.scale, local.scale ) );
	}
}

/// @return not zero in lanes whose chain holds what is no number
SOLE_INLINE soleWide FN( soleSenseLaneChain )( soleSenseLanes* f, int32_t leg, int32_t i )
{
	const soleRigLeg* rig = f->rig->legs + leg;
	soleSenseFoot* foot = f->feet + leg;
	soleLanesSpace joint = FN( soleReadSpace )( f->slots + rig->slots[0], i );
	soleWide nothing = FN( soleFindNothing )( &joint ), length = NUM( 0.0f );
	soleLanes3 place = joint.place;
	int32_t count = rig->def.jointCount;
	for ( int32_t k = 1; k < count + ( rig->def.hasVirtualAnkle ? 1 : 0 ); ++k )
	{
		soleLanes3 next = FN( soleLanesPoint )( &joint, FN( soleSet3 )( rig->virtualAnkle ) );
		if ( k < count )
		{
			joint = FN( soleReadSpace )( f->slots + rig->slots[k], i );
			nothing = ADD( nothing, FN( soleFindNothing )( &joint ) );
			next = joint.place;
		}
		length = ADD( length, FN( soleLength3 )( FN( soleSub3 )( place, next ) ) );
		place = next;
	}
	FN( soleKeep3 )( foot->ankle, i, place );
	soleWide_Store( foot->length + i, length );
	nothing = ADD( nothing, ADD( SUB( place.x, place.x ), ADD( SUB( place.y, place.y ), SUB( place.z, place.z ) ) ) );
	return ADD( nothing, SUB( length, length ) );
}

SOLE_INLINE soleLanes3 FN( soleSenseLaneHeading )(
    soleSenseLanes* f, const soleRigLeg* rig, const soleLanesSpace* foot, int32_t i )
{
	soleLanes3 up = FN( soleRow3 )( f->up, i );
	soleLanes3 ahead = FN( soleRotate3 )( foot->turn, FN( soleSet3 )( rig->footForward ) );
	soleLanes3 level = FN( soleReject3 )( ahead, up );
	soleWideMask upright = LESS( FN( soleDot3 )( level, level ), NUM( 1e-4f ) );
	if ( soleWide_GetBits( upright ) != 0 )
	{
		soleLanes3 over = FN( soleRotate3 )( foot->turn, FN( soleSet3 )( rig->footUp ) );
		soleWideMask rises = LESS( NUM( 0.0f ), FN( soleDot3 )( ahead, up ) );
		over = FN( soleScale3 )( PICK( rises, NUM( -1.0f ), NUM( 1.0f ) ), over );
		level = FN( solePick3 )( upright, FN( soleReject3 )( over, up ), level );
	}
	return FN( soleNormalize3 )( level, FN( soleRow3 )( f->level, i ) );
}

/// Heights of the sole over the clip's floor.
SOLE_INLINE void FN( soleSenseLaneHeights )( soleSenseLanes* f, int32_t leg, int32_t i, const soleLanesSpace* fore )
{
	const soleRigLeg* rig = f->rig->legs + leg;
	soleSenseFoot* foot = f->feet + leg;
	soleLanes3 floor = FN( soleRow3 )( f->floor, i ), rootUp = FN( soleRow3 )( f->rootUp, i );
	soleLanes3 heel = FN( soleRow3 )( foot->heel, i ), ball = FN( soleRow3 )( foot->ball, i );
	soleWide heelRise = FN( soleDot3 )( FN( soleSub3 )( heel, floor ), rootUp );
	soleWide ballRise = FN( soleDot3 )( FN( soleSub3 )( ball, floor ), rootUp );
	soleLanes3 inner = FN( soleLanesPoint )( fore, FN( soleSet3 )( rig->foreInner ) );
	soleLanes3 outer = FN( soleLanesPoint )( fore, FN( soleSet3 )( rig->foreOuter ) );
	soleLanes3 toe = FN( soleLanesPoint )( fore, FN( soleSet3 )( rig->foreToe ) );
	soleWide edges = soleWide_Min( FN( soleDot3 )( inner, rootUp ), FN( soleDot3 )( outer, rootUp ) );
	edges = SUB( edges, FN( soleDot3 )( floor, rootUp ) );
	soleWide lowest = soleWide_Min( edges, soleWide_Min( heelRise, ballRise ) );
	soleWide tip = FN( soleDot3 )( FN( soleSub3 )( toe, floor ), rootUp );
	bool bends = rig->toeSlot != SOLE_NONE;
	lowest = bends ? lowest : soleWide_Min( lowest, tip );
	soleWide zero = NUM( 0.0f );
	soleWide sunk = soleWide_Max( FN( soleNegWide )( lowest ), zero );
	soleWide under = soleWide_Max( SUB( FN( soleNegWide )( tip ), sunk ), zero );
	soleWide toeLength = MUL( NUM( rig->toeAhead ), soleWide_Load( f->rootScale + i ) );
	soleWide least = MUL( NUM( 0.01f ), soleWide_Load( foot->length + i ) );
	soleWide_Store( foot->heelRise + i, heelRise );
	soleWide_Store( foot->ballRise + i, ballRise );
	soleWide_Store( foot->tipRise + i, tip );
	soleWide_Store( foot->sunk + i, sunk );
	soleWide_Store( foot->toeSunk + i, bends ? DIV( under, soleWide_Max( toeLength, least ) ) : zero );
}

static inline void FN( soleSenseLaneLeg )( soleSenseLanes* f, int32_t leg, int32_t i )
{
	const soleRigLeg* rig = f->rig->legs + leg;
	soleSenseFoot* sensed = f->feet + leg;
	soleWide nothing = FN( soleSenseLaneChain )( f, leg, i );
	soleLanesSpace foot = FN( soleReadSpace )( f->slots + rig->footSlot, i );
	soleLanesSpace fore =
	    FN( soleReadSpace )( f->slots + ( rig->toeSlot == SOLE_NONE ? rig->footSlot : rig->toeSlot ), i );
	nothing = ADD( nothing, ADD( FN( soleFindNothing )( &foot ), FN( soleFindNothing )( &fore ) ) );
	FN( soleKeep3 )( sensed->heel, i, FN( soleLanesPoint )( &foot, FN( soleSet3 )( rig->heel ) ) );
	FN( soleKeep3 )( sensed->ball, i, FN( soleLanesPoint )( &fore, FN( soleSet3 )( rig->foreBall ) ) );
	FN( soleKeep3 )( sensed->forward, i, FN( soleSenseLaneHeading )( f, rig, &foot, i ) );
	FN( soleSenseLaneHeights )( f, leg, i, &fore );
	soleWideMask usable = LESS( NUM( 1e-6f ), soleWide_Load( sensed->length + i ) );
	uint32_t bits = soleWide_GetBits( soleWide_And( usable, LESS( nothing, NUM( 1.0f ) ) ) );
	for ( int32_t k = 0; k < SOLE_WIDTH; ++k )
	{
		sensed->usable[i + k] = bits >> k & 1u;
	}
}

static void FN( soleSenseInLanes )( soleSenseLanes* f, int32_t end )
{
	for ( int32_t i = 0; i < end; i += SOLE_WIDTH )
	{
		FN( soleEvaluateLanes )( f, i );
		for ( int32_t leg = 0; leg < f->rig->legCount; ++leg )
		{
			FN( soleSenseLaneLeg )( f, leg, i );
		}
	}
}
