// SPDX-License-Identifier: MIT
// Two-bone IK and aim IK after ozz-animation (its public documentation, github.com/guillaumeblanc/ozz-animation), in
// one space of the caller's.
//
// Two bones. k = mid - start, s = end - mid, lengths a and b; L the distance from start to target.
//   Softening. From da = soften (a + b) on the distance is brought closer, ds = a + b - da being what is left:
//     L' = da + ds ( 1 - 81 / ( 3 + ( L - da ) / ds )^4 )
//   which leaves L' = L with slope 4/3 and never passes a + b.
//   Mid. The angle C between the bones, inside, follows from the law of cosines. Its half needs no arc cosine and loses
//   nothing near the straight chain:
//     cos( C/2 )^2 = ( a + b - L' )( a + b + L' ) / 4ab      sin( C/2 )^2 = ( L' - a + b )( L' + a - b ) / 4ab
//   The angle now, C0, is that between -k and s, negative where the chain is bent to the wrong side of midAxis. The
//   turn about midAxis is C - C0.
//   Start. The shortest turn that brings the bent chain's end onto the line to the target, then one about that line
//   that brings the chain's plane, whose normal is midAxis, to the one with normal (target x pole), then the twist.
//
// Aim. The line that starts at the offset and runs along forward has to meet the target. It does at the point of the
// line that is as far from the joint as the target is; without an offset that is along forward itself. The shortest
// turn brings that point to the target, then one about the line to the target brings up as near to the pole as it gets.
//
// Weight: each correction is the normalised mean of none and itself.
#include "baselines/ozz_jobs.h"

static const soleVec3 nowhere = { 0.0f, 0.0f, 0.0f };

/// By the angle between two unit vectors, right-handed about a unit axis unless side is negative. Cosine and sine of
/// half of that angle are half of the vectors' sum and difference.
static soleQuat soleTurnBetween( soleVec3 from, soleVec3 to, soleVec3 axis, float side )
{
	float c = 0.5f * soleLength( soleAdd( from, to ) );
	float s = 0.5f * soleLength( soleSub( to, from ) );
	soleVec3 v = soleScale( side < 0.0f ? -s : s, axis );
	return soleNormalizeQuat( ( soleQuat ){ v.x, v.y, v.z, c } );
}

static soleQuat soleTurnByAngle( soleVec3 axis, float angle )
{
	soleVec3 v = soleScale( sinf( 0.5f * angle ), axis );
	return ( soleQuat ){ v.x, v.y, v.z, cosf( 0.5f * angle ) };
}

/// The shortest turn between two vectors of any length; none where one has no length.
static soleQuat soleTurnOnto( soleVec3 from, soleVec3 to, soleVec3 halfTurnAxis )
{
	soleVec3 a = soleNormalizeOr( from, nowhere );
	soleVec3 b = soleNormalizeOr( to, nowhere );
	bool known = soleDot( a, a ) > 0.0f && soleDot( b, b ) > 0.0f;
	return known ? soleFromTo( a, b, halfTurnAxis ) : soleQuat_Identity();
}

// ------------------------------------------------------------------------------------------------------- two bones

static float soleSoftenOzz( float length, float chain, float soften )
{
	float from = chain * soleClampF( soften, 0.0f, 1.0f );
	float zone = chain - from;
	if ( length <= from || zone <= 0.0f )
	{
		return length;
	}
	float x = 3.0f + ( length - from ) / zone;
	return from + zone * ( 1.0f - 81.0f / ( x * x * x * x ) );
}

/// The turn about midAxis that makes the chain as long as that.
static soleQuat soleBendOzz( const soleOzzTwoBoneJob* job, soleVec3 k, soleVec3 s, float length )
{
	float a = soleLength( k );
	float b = soleLength( s );
	if ( !( a * b > 0.0f ) )
	{
		return soleQuat_Identity();
	}
	float wide = soleMaxF( ( length - a + b ) * ( length + a - b ), 0.0f );
	float narrow = soleMaxF( ( a + b - length ) * ( a + b + length ), 0.0f );
	float scale = 1.0f / sqrtf( soleMaxF( wide + narrow, 1e-30f ) );
	float c = scale * sqrtf( narrow );
	float sine = scale * sqrtf( wide );

	soleVec3 back = soleScale( -1.0f / a, k );
	soleVec3 on = soleScale( 1.0f / b, s );
	float c0 = 0.5f * soleLength( soleAdd( back, on ) );
	float sine0 = 0.5f * soleLength( soleSub( back, on ) );
	sine0 = soleDot( soleCross( k, job->midAxis ), s ) < 0.0f ? -sine0 : sine0;

	soleVec3 v = soleScale( sine * c0 - c * sine0, job->midAxis );
	return soleNormalizeQuat( ( soleQuat ){ v.x, v.y, v.z, c * c0 + sine * sine0 } );
}

/// The turn of the whole chain, once it is bent.
static soleQuat soleSwingOzz( const soleOzzTwoBoneJob* job, soleVec3 bentEnd, soleVec3 toTarget )
{
	soleQuat swing = soleTurnOnto( bentEnd, toTarget, job->midAxis );
	soleVec3 axis = soleNormalizeOr( toTarget, nowhere );
	soleVec3 wanted = soleNormalizeOr( soleCross( axis, job->poleVector ), nowhere );
	soleVec3 normal = soleRotate( swing, job->midAxis );
	if ( soleDot( wanted, wanted ) > 0.0f )
	{
		soleQuat plane = soleTurnBetween( normal, wanted, axis, soleDot( normal, job->poleVector ) );
		swing = soleMulQuat( plane, swing );
	}
	return soleMulQuat( soleTurnByAngle( axis, job->twistAngle ), swing );
}

soleOzzTwoBoneJob soleDefaultOzzTwoBoneJob( void )
{
	return ( soleOzzTwoBoneJob ){
		.midAxis = { 0.0f, 0.0f, 1.0f }, .poleVector = { 0.0f, 1.0f, 0.0f }, .soften = 1.0f, .weight = 1.0f
	};
}

soleOzzTwoBoneResult soleRunOzzTwoBone( const soleOzzTwoBoneJob* job )
{
	soleVec3 k = soleSub( job->mid, job->start );
	soleVec3 s = soleSub( job->end, job->mid );
	soleVec3 toTarget = soleSub( job->target, job->start );
	float a = soleLength( k );
	float b = soleLength( s );
	float distance = soleLength( toTarget );
	float shortest = a > b ? a - b : b - a;
	float soften = soleClampF( job->soften, 0.0f, 1.0f );
	float weight = soleClampF( job->weight, 0.0f, 1.0f );

	soleQuat mid = soleBendOzz( job, k, s, soleSoftenOzz( distance, a + b, soften ) );
	soleQuat start = soleSwingOzz( job, soleAdd( k, soleRotate( mid, s ) ), toTarget );
	return ( soleOzzTwoBoneResult ){
		.start = soleNlerp( soleQuat_Identity(), start, weight ),
		.mid = soleNlerp( soleQuat_Identity(), mid, weight ),
		.reached = distance <= soften * ( a + b ) && distance > shortest && weight >= 1.0f,
	};
}

// ------------------------------------------------------------------------------------------------------------- aim

soleOzzAimJob soleDefaultOzzAimJob( void )
{
	return ( soleOzzAimJob ){
		.forward = { 1.0f, 0.0f, 0.0f }, .up = { 0.0f, 1.0f, 0.0f }, .poleVector = { 0.0f, 1.0f, 0.0f }, .weight = 1.0f
	};
}

soleOzzAimResult soleRunOzzAim( const soleOzzAimJob* job )
{
	soleVec3 toTarget = soleSub( job->target, job->joint );
	float squared = soleDot( toTarget, toTarget );
	float along = soleDot( job->offset, job->forward );
	float aside = soleMaxF( soleDot( job->offset, job->offset ) - along * along, 0.0f );
	soleOzzAimResult result = { soleQuat_Identity(), aside <= squared };
	soleVec3 axis = soleNormalizeOr( toTarget, nowhere );
	if ( result.reached == false || !( soleDot( axis, axis ) > 0.0f ) )
	{
		return result;
	}
	soleVec3 meets = soleMulAdd( job->offset, sqrtf( squared - aside ) - along, job->forward );
	soleQuat turn = soleTurnOnto( meets, toTarget, job->up );
	soleVec3 up = soleRotate( turn, job->up );
	soleVec3 normal = soleNormalizeOr( soleCross( up, axis ), nowhere );
	soleVec3 wanted = soleNormalizeOr( soleCross( job->poleVector, axis ), nowhere );
	if ( soleDot( normal, normal ) > 0.0f && soleDot( wanted, wanted ) > 0.0f )
	{
		turn = soleMulQuat( soleTurnBetween( normal, wanted, axis, soleDot( wanted, up ) ), turn );
	}
	turn = soleMulQuat( soleTurnByAngle( axis, job->twistAngle ), turn );
	result.turn = soleNlerp( soleQuat_Identity(), turn, soleClampF( job->weight, 0.0f, 1.0f ) );
	return result;
}
