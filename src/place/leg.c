// SPDX-License-Identifier: MIT
// Leg: heel lift, soft reach, and the two-bone solve about the animated hinge.
//
// Two bones. k = K - H, s = A - K, d0 = A - H, d1 = T - H, u = their directions. The leg bends about n, the normal of
// its animated plane on the side of the rig's hinge, or that hinge itself where the leg is nearly straight. Seen along
// n the bones have the lengths a', b'. For a distance L between hip and target, with Lm = a' + b' and e = Lm - L, the
// halves of the knee's flexion and of the thigh's angle to d are, without an angle ever being formed,
//   (c1, s1) = ( sqrt q, sqrt p ) / sqrt( p + q )      p  = ( Lm + L ) e         q  = ( L + a' - b' )( L - a' + b' )
//   (c2, s2) = ( sqrt q2, -sqrt p2 ) / sqrt( p2 + q2 ) p2 = ( b' + L - a' ) e    q2 = ( Lm + L )( a' + L - b' )
// (half-angle forms of the law of cosines; p + q = 4 a'b', p2 + q2 = 4 a'L). The animated halves come from vectors, and
// what is applied is the difference: nothing changes where target = animation. The leg swings from d0 to d1 by the
// shortest rotation: there is no pole vector and no pole singularity. e is formed once: forming it again in another
// order costs three digits near full extension.
//
// Soft reach. Beyond `soft` the distance approaches `hard` as hard - z exp( -( L - soft ) / z ), z = hard - soft, which
// leaves the line L = L with slope 1. A foot in flight may be further from its way than its leg is long, until the
// pelvis has come down with it. Its leg approaches its end from where the animation's own ends, or its knee would snap
// straight and wait.
//
// Hanging. Drawn towards its hip, a foot that stands would slide: so it goes straight up from its place, until the leg
// is as long as it may be. With h the level part of d1 its ankle is  sqrt( L^2 - h^2 )  under the hip.
//
// Folding. A foot that passes close by its hip on its way up high steps would turn the leg as fast as the line from hip
// to foot turns. It goes below, on a parabola  f - h^2 / f  under the hip, f a little more than the leg's shortest
// length and h its level distance, as far as its own plane lets it. The sphere that the leg folds to is as steep as a
// wall at its rim.
//
// Stretch, where it is allowed, makes all bones of the leg longer before the soft reach falls short; twist, where it is
// wanted, turns the whole leg about the line from hip to ankle, which moves neither.
//
// What is out of reach is asked for in this order: the heel is raised, the pelvis lowered (pelvis.c), the foothold has
// been shifted already (foothold.c), the bones are stretched; what is left then is told as an error, and a planted foot
// that stays short of its place gives it up (lock.c).
//
// Heel lift. A planted foot that would overstretch its leg is rolled about its ball B before anything else gives. With
// a0 = ankle - B, w = hip - B, side axis e, the ankle's path is a circle; |w - a|^2 = l^2 gives the cosine c of its
// angle to w's part in that plane:  c = ( ( |a0|^2 + |w|^2 - l^2 ) / 2 - a_e w_e ) / ( r |w_p| ). Where c comes near 1
// the ankle is nearly on the line from ball to hip, and a little more distance takes ever more angle, endlessly fast:
// the end is approached softly, as the leg's own is, and what is left then is the leg's. Once the foot has left, its
// knee bends for the swing and the need is over at once; the heel is lowered smoothly then (contact.c has what is
// left).
#include "place/parts.h"
#include "place/stance.h"

#define EASE 0.15f  // of the cosine of the heel lift
#define STANDS 0.6f // cosine of a leg's lean up to which a foot is not drawn in
#define LEANS 0.3f
#define HIGH 0.3f         // L over the hip: a foot animated so high has no business below it
#define ROOM 1.15f        // times the shortest leg
#define FLIGHT_ZONE 0.15f // L over which a leg in flight approaches its end
#define ARRIVES 0.7f      // share of its time from which on that is ever less
#define ON_HEEL 0.05f     // L: a ball that is animated this much higher than the heel is not on the ground

// ------------------------------------------------------------------------------------------------------- two bones

/// The axis that the knee bends about now, unit, at right angles to u0.
static soleVec3 soleFindBendAxis( soleVec3 k, soleVec3 s, float a, float b, soleVec3 u0, soleVec3 rigHinge )
{
	soleVec3 reference = soleNormalizeOr( soleReject( rigHinge, u0 ), soleVec( 0.0f, 0.0f, 0.0f ) );
	reference = soleDot( reference, reference ) > 0.0f ? reference : soleAnyOrthogonal( u0 );
	soleVec3 n = soleScale( 1.0f / ( a * b ), soleCross( k, s ) );
	float f = soleLength( n );
	soleVec3 axis = soleDot( n, reference ) < 0.0f ? soleNeg( n ) : n;
	if ( f < SOLE_NEARLY_STRAIGHT )
	{
		axis = soleMulAdd( axis, SOLE_NEARLY_STRAIGHT - f, reference );
	}
	return soleNormalizeOr( soleReject( axis, u0 ), reference );
}

/// Flexion and thigh angle that make the leg as long as L, as halves, in the hinge plane.
static void soleBend( float a, float b, float length, soleHalf* flexion, soleHalf* thigh )
{
	float most = a + b;
	float e = soleMaxF( most - length, 0.0f );
	float p = ( most + length ) * e;
	float q = soleMaxF( ( length + a - b ) * ( length - a + b ), 0.0f );
	float p2 = soleMaxF( ( b + length - a ) * e, 0.0f );
	float q2 = soleMaxF( ( most + length ) * ( a + length - b ), 0.0f );
	float r = sqrtf( soleMaxF( p + q, 1e-30f ) );
	float r2 = sqrtf( soleMaxF( p2 + q2, 1e-30f ) );
	*flexion = ( soleHalf ){ sqrtf( q ) / r, sqrtf( p ) / r };
	*thigh = ( soleHalf ){ sqrtf( q2 ) / r2, -sqrtf( p2 ) / r2 };
}

static float soleSoften( float length, float soft, float hard )
{
	float zone = hard - soft;
	if ( !( length > soft ) )
	{
		return length;
	}
	return zone > 1e-6f * hard ? hard - zone * soleExpNegative( ( length - soft ) / zone ) : hard;
}

soleTwoBoneResult soleSolveTwoBone( const soleTwoBoneDef* def )
{
	soleTwoBoneResult result = { soleQuat_Identity(), soleQuat_Identity(), def->ankle, 0 };
	soleVec3 k = soleSub( def->knee, def->hip );
	soleVec3 s = soleSub( def->ankle, def->knee );
	soleVec3 d0 = soleSub( def->ankle, def->hip );
	soleVec3 d1 = soleSub( def->target, def->hip );
	float a = soleLength( k ), b = soleLength( s ), length0 = soleLength( d0 ), length1 = soleLength( d1 );
	float bones = a + b;
	if ( !( length0 > 1e-4f * bones ) || !( length1 > 1e-4f * bones ) || !soleIsFinite( length0 + length1 + bones ) ||
	    !soleVec3_IsFinite( def->hinge ) )
	{
		result.flags = (uint32_t)sole_legDegenerate;
		return result;
	}
	soleVec3 u0 = soleScale( 1.0f / length0, d0 );
	soleVec3 u1 = soleScale( 1.0f / length1, d1 );
	if ( !( a > 1e-6f * bones ) || !( b > 1e-6f * bones ) )
	{
		// One bone: it can only point.
		result.hip = soleFromTo( u0, u1, def->hinge );
		result.ankle = soleAdd( def->hip, soleRotate( result.hip, d0 ) );
		result.flags = (uint32_t)sole_legDegenerate;
		return result;
	}
	float hard = soleClampF( def->reach, 0.0f, 1.0f ) * bones;
	float soft = soleClampF( hard - def->softZone, 0.0f, hard );
	float fold = soleClampF( def->fold, 0.0f, 1.0f ) * bones;
	result.flags |= length1 > soft ? (uint32_t)sole_legSoftened : 0u;
	result.flags |= length1 > hard ? (uint32_t)sole_legOutOfReach : 0u;

	soleVec3 n = soleFindBendAxis( k, s, a, b, u0, def->hinge );
	soleVec3 kp = soleReject( k, n );
	soleVec3 sp = soleReject( s, n );
	float ap = soleLength( kp ), bp = soleLength( sp );
	float difference = ap > bp ? ap - bp : bp - ap;
	float least = difference * ( 1.0f + 1e-4f ) + 1e-6f * bones;
	float length = soleMaxF( soleSoften( length1, soft, hard ), fold );
	length = soleClampF( length, least, ap + bp );
	result.flags |= length1 < fold || length1 < least ? (uint32_t)sole_legFolded : 0u;

	soleHalf flexion0 = soleMakeHalf( soleDot( kp, sp ), soleDot( n, soleCross( kp, sp ) ) );
	soleHalf thigh0 = soleMakeHalf( soleDot( kp, u0 ), soleDot( n, soleCross( u0, kp ) ) );
	soleHalf flexion, thigh;
	soleBend( ap, bp, length, &flexion, &thigh );
	result.knee = soleHalfRotation( n, soleSubHalf( flexion, flexion0 ) );
	soleQuat swing = soleFromTo( u0, u1, n );
	result.hip = soleNormalizeQuat( soleMulQuat( swing, soleHalfRotation( n, soleSubHalf( thigh, thigh0 ) ) ) );
	soleVec3 shin = soleRotate( result.knee, s );
	result.ankle = soleAdd( def->hip, soleRotate( result.hip, soleAdd( k, shin ) ) );
	return result;
}

// -------------------------------------------------------------------------------------------------------- heel lift

/// 1 is approached as by an exponential, from EASE below it on.
static float soleEaseEnd( float cosine )
{
	float left = 1.0f - cosine;
	return left < EASE ? 1.0f - EASE * soleExpNegative( soleMinF( ( EASE - left ) / EASE, 20.0f ) ) : cosine;
}

/// How far the foot has to be rolled about its ball, heel up, for the leg to be no longer than `permitted`: sine of
/// half the angle, at least 0.
static float soleFindHeelLift( const solePlaceWork* work, const soleLegWork* leg, float permitted )
{
	soleVec3 a0 = soleSub( leg->ankleTarget, leg->pivotTarget );
	soleVec3 w = soleSub( leg->hip, leg->pivotTarget );
	soleVec3 side = soleRotate( leg->footReached, leg->rig->footSide );
	float ae = soleDot( a0, side );
	float we = soleDot( w, side );
	soleVec3 ap = soleMulAdd( a0, -ae, side );
	soleVec3 wp = soleMulAdd( w, -we, side );
	float r = soleLength( ap );
	float wl = soleLength( wp );
	float least = 1e-4f * leg->length;
	if ( r < least || wl < least )
	{
		return 0.0f;
	}
	float c = ( 0.5f * ( soleDot( a0, a0 ) + soleDot( w, w ) - permitted * permitted ) - ae * we ) / ( r * wl );
	c = soleClampF( soleEaseEnd( c ), -1.0f, 1.0f );
	float sine = soleSqrtF( 1.0f - c * c );
	soleVec3 u = soleScale( 1.0f / wl, wp );
	soleVec3 v = soleCross( side, u );
	soleHalf roots[2];
	for ( int32_t i = 0; i < 2; ++i )
	{
		soleVec3 a = soleScale( r, soleMulAdd( soleScale( c, u ), i == 0 ? sine : -sine, v ) );
		roots[i] = soleMakeHalf( soleDot( ap, a ), soleDot( side, soleCross( ap, a ) ) );
	}
	// The nearer root is the one that the foot meets on its way. Positive turns about side raise the toes: where that
	// is the way to the hip, lifting the heel is of no help.
	soleHalf best = roots[0].s * roots[0].s <= roots[1].s * roots[1].s ? roots[0] : roots[1];
	// A foot in flight needs no heel lift: it hangs short of its target instead. The limit comes and goes with contact.
	// So does one that comes down on its heel: it has no ball on the ground to go round.
	float onBall = 1.0f - soleIsOnHeel( leg, ON_HEEL );
	soleHalf most = soleHalfFromAngle( work->settings->leg.heelLift * leg->state->plantWeight * onBall );
	return soleClampF( -best.s, 0.0f, most.s );
}

/// Lifts the heel as far as the leg needs it, in flight as far as is left of what it needed before: knees that bend for
/// a swing would let it drop at once, and foot and toes with it.
static void soleLiftHeel( const solePlaceWork* work, soleLegWork* leg, float permitted )
{
	bool needs = leg->state->plantWeight > 0.0f && soleDistance( leg->hip, leg->ankleTarget ) > permitted;
	// A foot that the ankle's limits have turned is lifted already, and solved again.
	float lifted = leg->limited ? leg->state->heelLift : 0.0f;
	float left = leg->limited ? 0.0f : leg->liftLeft;
	float sine = soleMaxF( needs ? soleFindHeelLift( work, leg, permitted ) : 0.0f, left );
	leg->state->heelLift = soleMinF( lifted + sine, 1.0f );
	if ( !( sine > 0.0f ) )
	{
		return;
	}
	soleVec3 side = soleRotate( leg->footReached, leg->rig->footSide );
	soleQuat roll = soleHalfRotation( side, ( soleHalf ){ soleSqrtF( soleMaxF( 1.0f - sine * sine, 0.0f ) ), -sine } );
	soleVec3 arm = soleSub( leg->ankleTarget, leg->pivotTarget );
	leg->footReached = soleNormalizeQuat( soleMulQuat( roll, leg->footReached ) );
	leg->ankleGoal = soleAdd( leg->pivotTarget, soleRotate( roll, arm ) );
	leg->out->flags |= (uint32_t)sole_legHeelLifted;
}

// --------------------------------------------------------------------------------------------------------- the stage

/// By how much the bones have to be longer for the leg to reach without being softened, as far as that is allowed.
static float soleFindStretch( const solePlaceWork* work, const soleLegWork* leg, soleReach reach )
{
	float most = work->settings->leg.stretch;
	float wanted = soleDistance( leg->hip, leg->ankleGoal ) / soleMaxF( reach.soft, 1e-6f * leg->length );
	bool plain = leg->rig->def.hasVirtualAnkle || leg->rig->def.detachedFoot != SOLE_NONE;
	return plain ? 1.0f : soleClampF( wanted, 1.0f, 1.0f + most * leg->weight );
}

/// The thigh's share of the turn that the foot has made about the line from hip to ankle.
static soleQuat soleShareTwist( const solePlaceWork* work, const soleLegWork* leg, soleVec3 target )
{
	float share = work->settings->leg.twist;
	if ( !( share > 0.0f ) )
	{
		return soleQuat_Identity();
	}
	soleVec3 axis = soleNormalizeOr( soleSub( target, leg->hip ), soleNeg( work->up ) );
	soleQuat turn = soleMulQuat( leg->footReached, soleConjugate( leg->foot.rotation ) );
	soleQuat twist = soleTwist( turn, axis );
	twist = twist.w < 0.0f ? ( soleQuat ){ -twist.x, -twist.y, -twist.z, -twist.w } : twist;
	return soleNlerp( soleQuat_Identity(), twist, share );
}

/// Over what length a foot on its way to a foothold approaches its leg's end: from where the animation's own leg ends
/// on, and less and less as it arrives.
static float soleFindFlightZone( const soleLegWork* leg, float hard )
{
	float left = 1.0f - soleSmoothly( soleSaturate( ( leg->state->stepTime - ARRIVES ) / ( 1.0f - ARRIVES ) ) );
	float share = left * ( 1.0f - leg->state->plantWeight );
	return soleMinF( share * FLIGHT_ZONE * leg->length, hard - soleAnimatedReach( leg ) );
}

/// Where a foot goes that stands on what its leg does not quite reach: over its place, not towards the hip, or it would
/// slide. Legs that lean so far that this takes it high up draw it in all the same.
static soleVec3 soleHangOver( const solePlaceWork* work, const soleLegWork* leg, float reached )
{
	soleVec3 d = soleSub( leg->ankleGoal, leg->hip );
	float length = soleLength( d );
	float down = -soleDot( d, work->up );
	soleVec3 level = soleHorizontal( work, d );
	float upright = soleSqrtF( soleMaxF( reached * reached - soleDot( level, level ), 0.0f ) );
	float share = soleSmoothly( soleSaturate( ( upright / reached - LEANS ) / ( STANDS - LEANS ) ) );
	share *= down > 0.0f ? leg->state->plantWeight : 0.0f;
	soleVec3 drawn = soleMulAdd( leg->hip, reached / length, d );
	return soleLerp( drawn, soleMulAdd( soleAdd( leg->hip, level ), -upright, work->up ), share );
}

/// Where a foot in flight goes that would come nearer to its hip than the leg folds: lower, below the hip, or the leg
/// would whirl round when the foot goes past it.
static soleVec3 soleTakeUnder( const solePlaceWork* work, const soleLegWork* leg, soleVec3 target )
{
	float fold = ROOM * work->settings->leg.fold * leg->length;
	soleVec3 d = soleSub( target, leg->hip );
	float down = -soleDot( d, work->up );
	soleVec3 level = soleHorizontal( work, d );
	float least = soleMaxF( fold - soleDot( level, level ) / soleMaxF( fold, 1e-4f * leg->length ), 0.0f );
	float share = leg->touches ? 0.0f : 1.0f - leg->state->plantWeight;
	share *= soleSaturate( 1.0f + down / ( HIGH * leg->length ) );
	soleVec3 plane = soleSub( leg->out->planePoint_w, work->root_w );
	float over = soleDot( soleSub( target, plane ), work->up ) - leg->rig->ankleHeight * work->rootScale;
	return soleMulAdd( target, -share * soleClampF( least - down, 0.0f, soleMaxF( over, 0.0f ) ), work->up );
}

/// Where a foot goes that is out of its leg's reach, at either end.
static void soleGuideFoot( const solePlaceWork* work, soleLegWork* leg, float hard, soleTwoBoneDef* def )
{
	leg->ankleGoal = soleTakeUnder( work, leg, leg->ankleGoal );
	def->target = leg->ankleGoal;
	float wanted = soleDistance( leg->hip, leg->ankleGoal );
	float soft = hard - def->softZone;
	if ( wanted > soft && leg->state->plantWeight > 0.0f )
	{
		// As short as the two bones would make it.
		def->target = soleHangOver( work, leg, soleSoften( wanted, soft, hard ) );
		def->softZone = 0.0f;
		leg->out->flags |= (uint32_t)sole_legSoftened;
		leg->out->flags |= wanted > hard ? (uint32_t)sole_legOutOfReach : 0u;
	}
}

void soleReadyLeg( const solePlaceWork* work, soleLegWork* leg, soleTwoBoneDef* def )
{
	int32_t knee = leg->rig->kneeIndex;
	soleVec3 shift = soleMulAdd( work->balance, work->pelvisShift, work->up );
	leg->hip = soleAdd( leg->joints[0], shift );
	leg->ankleGoal = leg->ankleTarget;
	leg->footReached = leg->footTarget;
	soleReach reach = soleGetReach( work, leg );
	if ( leg->weight > 0.0f )
	{
		soleLiftHeel( work, leg, reach.soft );
	}
	// The chain is as the animation bends it: two stiff parts around the knee, hip and ankle fixed in them.
	float stretch = soleFindStretch( work, leg, reach );
	def->hip = leg->hip;
	def->knee = soleLerp( leg->hip, soleAdd( leg->joints[knee], shift ), stretch );
	def->ankle = soleLerp( leg->hip, soleAdd( leg->ankle, shift ), stretch );
	def->target = leg->ankleGoal;
	def->hinge = soleRotate( leg->rotations[0], leg->rig->hinge );
	float bones = soleDistance( def->hip, def->knee ) + soleDistance( def->knee, def->ankle );
	float perBone = bones > 0.0f ? stretch / bones : 0.0f;
	def->reach = soleMinF( reach.hard * perBone, 1.0f );
	def->softZone = soleMaxF( reach.hard - reach.soft, soleFindFlightZone( leg, reach.hard ) );
	if ( soleHoldsFeet( work ) )
	{
		soleGuideFoot( work, leg, stretch * reach.hard, def );
	}
	def->fold = soleMinF( work->settings->leg.fold * leg->length, soleDistance( def->hip, def->ankle ) ) * perBone;
	leg->out->stretch = stretch;
}

void soleTakeLeg( const solePlaceWork* work, soleLegWork* leg, soleVec3 reached, uint32_t flags )
{
	leg->ankleReached = reached;
	leg->out->flags |= flags;
	leg->out->ankleTarget_w = soleAdd( leg->ankleGoal, work->root_w );
	leg->out->ankle_w = soleAdd( reached, work->root_w );
	leg->out->error = soleDistance( reached, leg->ankleGoal );
	leg->state->shortfall = leg->out->error / leg->length;
	leg->out->extension = soleDistance( leg->hip, reached ) / leg->length;
}

void soleSolveLeg( const solePlaceWork* work, soleLegWork* leg )
{
	soleTwoBoneDef def;
	soleReadyLeg( work, leg, &def );
	soleTwoBoneResult result = soleSolveTwoBone( &def );
	leg->hipTurn = soleMulQuat( soleShareTwist( work, leg, def.target ), result.hip );
	leg->kneeTurn = result.knee;
	soleTakeLeg( work, leg, result.ankle, result.flags );
}
