// SPDSOLE_LANES-License-Identifier: MIT
// Targets of target.c for many lanes at once. Included after base/simd.h and base/wide_math.h, once for each width. The
// formulas and their names are those of target.c.

/// The place on the plane, along up.
SOLE_INLINE soleLanes3 FN( soleDropOnPlane )( soleTargetLanes* f, int32_t i, soleLanes3 place )
{
	soleLanes3 up = FN( soleRow3 )( f->up, i ), point = FN( soleRow3 )( f->planePoint, i );
	soleLanes3 level = FN( soleReject3 )( FN( soleSub3 )( place, point ), up );
	soleWide height =
	    ADD( FN( soleDot3 )( point, up ), FN( soleDot3 )( FN( soleRow3 )( f->planeGradient, i ), level ) );
	return FN( soleMulAdd3 )( FN( soleReject3 )( place, up ), height, up );
}

/// What carries the foot from the clip's floor to the plane.
typedef struct FN( soleCarry )
{
	soleLanes4 image;  // without toes turned out
	soleLanes4 turned; // with them
	soleLanes4 flat;   // before
} FN( soleCarry );

SOLE_INLINE FN( soleCarry ) FN( soleFindCarry )( soleTargetLanes* f, int32_t i )
{
	soleLanes3 up = FN( soleRow3 )( f->up, i ), forward = FN( soleRow3 )( f->forward, i );
	soleLanes4 turn = FN( soleRow4 )( f->turn, i );
	soleLanes4 tilt = FN( soleFromTo4 )( up, FN( soleRow3 )( f->planeNormal, i ), forward );
	soleLanes4 upright = FN( soleFromTo4 )( FN( soleRow3 )( f->rootUp, i ), up, forward );
	soleLanes4 toeOut = FN( soleRow4 )( f->toeOut, i );
	soleLanes4 turned = FN( soleMul4 )( turn, FN( soleMul4 )( toeOut, upright ) );
	soleLanes3 side = FN( soleRotate3 )( FN( soleRow4 )( f->foot, i ), FN( soleRow3 )( f->footSide, i ) );
	soleLanesHalf flat = FN( soleWideHalfFromAngle )( soleWide_Load( f->flat + i ) );
	return ( FN( soleCarry ) ){ FN( soleMul4 )( tilt, FN( soleMul4 )( turn, upright ) ), FN( soleMul4 )( tilt, turned ),
		FN( soleWideHalfRotation )( side, flat ) };
}

SOLE_INLINE void FN( soleSetLaneTargets )( soleTargetLanes* f, int32_t i )
{
	FN( soleCarry ) carry = FN( soleFindCarry )( f, i );
	soleLanes3 q = FN( soleRow3 )( f->anchor, i ), normal = FN( soleRow3 )( f->planeNormal, i );
	soleLanes3 goal = FN( soleDropOnPlane )( f, i, FN( soleRow3 )( f->anchorGoal, i ) );
	goal = FN( soleMulAdd3 )( goal, soleWide_Load( f->raise + i ), normal );
	soleLanes3 animated = FN( soleRow3 )( f->ankle, i ), about = FN( soleRow3 )( f->pivot, i );
	soleLanes4 foot = FN( soleRow4 )( f->foot, i );
	soleLanes3 arm = FN( soleAdd3 )(
	    FN( soleSub3 )( about, q ), FN( soleRotate3 )( carry.flat, FN( soleSub3 )( animated, about ) ) );
	soleLanes3 ankle = FN( soleAdd3 )( goal, FN( soleRotate3 )( carry.image, arm ) );
	soleLanes3 fore = FN( soleRotate3 )( carry.flat, FN( soleSub3 )( about, animated ) );
	soleLanes3 pivot = FN( soleAdd3 )( ankle, FN( soleRotate3 )( carry.turned, fore ) );
	soleLanes4 wanted = FN( soleMul4 )( carry.turned, FN( soleMul4 )( carry.flat, foot ) );

	soleWide weight = soleWide_Load( f->weight + i );
	FN( soleKeep4 )( f->image, i, carry.turned );
	FN( soleKeep3 )( f->ankleWanted, i, ankle );
	FN( soleKeep3 )
	( f->ankleTarget, i, FN( soleMulAdd3 )( animated, weight, FN( soleSub3 )( ankle, animated ) ) );
	FN( soleKeep3 )( f->pivotTarget, i, FN( soleMulAdd3 )( about, weight, FN( soleSub3 )( pivot, about ) ) );
	FN( soleKeep4 )( f->footTarget, i, FN( soleNlerp4 )( foot, wanted, soleWide_Load( f->turnWeight + i ) ) );
	soleLanes3 under = FN( soleAdd3 )( FN( soleDropOnPlane )( f, i, ankle ), FN( soleRow3 )( f->root_w, i ) );
	FN( soleKeep3 )( f->planePoint_w, i, under );
}

static void FN( soleSetTargetLanes )( soleTargetLanes* f, int32_t end )
{
	for ( int32_t i = 0; i < end; i += SOLE_WIDTH )
	{
		FN( soleSetLaneTargets )( f, i );
	}
}
