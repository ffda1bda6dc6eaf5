// SPDX-License-Identifier: MIT
// Critically damped springs in closed form: one number or vector, in the space and unit of the caller.
//   y = 1.678347 / halfLife,  e = value - goal,  a = ( velocity - goalVelocity ) + y e
//   e(t) = ( e + a t ) exp( -y t ),  v(t) = ( v - goalVelocity - y a t ) exp( -y t ) + goalVelocity
// From rest e(t) = e ( 1 + y t ) exp( -y t ), which is e / 2 at y t = 1.678347: half-life means what it says.
// The goal moves by goalVelocity t meanwhile. Two half steps make one whole step. See D. Holden, "Spring-It-On: The
// Game Developer's Spring-Roll-Call" (theorangeduck.com) for the family; the closed form is that of any textbook.
#include "base/spring.h"

#include "base/math_internal.h"
#include "sole/sole.h"

#define HALF_PHASE 1.678347f // y t at which half of a resting error is left
#define SETTLED 20.0f        // y t beyond which nothing is left
// What is less than this, in any unit, is nothing. Left to themselves springs would end in numbers so small that they
// decay no more, as half of the least rounds to itself, and that a processor takes many times as long for.
#define NOTHING 1e-30f

soleOffset1 soleStepSpring( soleOffset1 spring, float goal, float goalVelocity, float halfLife, float timeStep )
{
	goal = soleFiniteOr( goal, soleFiniteOr( spring.value, 0.0f ) );
	goalVelocity = soleFiniteOr( goalVelocity, 0.0f );
	float value = soleFiniteOr( spring.value, goal );
	float velocity = soleFiniteOr( spring.velocity, 0.0f );
	float t = timeStep > 0.0f ? soleFiniteOr( timeStep, 0.0f ) : 0.0f;
	if ( t == 0.0f )
	{
		return ( soleOffset1 ){ value, velocity };
	}
	float movedGoal = soleFiniteOr( goal + goalVelocity * t, goal );
	if ( !( halfLife > 0.0f ) || HALF_PHASE * t >= SETTLED * halfLife )
	{
		return ( soleOffset1 ){ movedGoal, goalVelocity };
	}
	float y = HALF_PHASE / halfLife;
	float decay = soleExpNegative( HALF_PHASE * t / halfLife );
	float error = value - goal;
	float relative = velocity - goalVelocity;
	float a = relative + y * error;
	error = ( error + a * t ) * decay;
	relative = ( relative - y * a * t ) * decay;
	if ( fabsf( error ) < NOTHING && fabsf( relative ) < NOTHING )
	{
		return ( soleOffset1 ){ movedGoal, goalVelocity };
	}
	return ( soleOffset1 ){ soleFiniteOr( error + movedGoal, movedGoal ),
		soleFiniteOr( relative + goalVelocity, goalVelocity ) };
}

soleOffset1 soleDecayOffset1( soleOffset1 offset, float halfLife, float timeStep )
{
	bool gone = offset.value == 0.0f && offset.velocity == 0.0f;
	return gone ? ( soleOffset1 ){ 0.0f, 0.0f } : soleStepSpring( offset, 0.0f, 0.0f, halfLife, timeStep );
}

soleOffset3 soleDecayOffset3( soleOffset3 offset, float halfLife, float timeStep )
{
	soleOffset1 x = soleDecayOffset1( ( soleOffset1 ){ offset.value.x, offset.velocity.x }, halfLife, timeStep );
	soleOffset1 y = soleDecayOffset1( ( soleOffset1 ){ offset.value.y, offset.velocity.y }, halfLife, timeStep );
	soleOffset1 z = soleDecayOffset1( ( soleOffset1 ){ offset.value.z, offset.velocity.z }, halfLife, timeStep );
	return ( soleOffset3 ){ soleVec( x.value, y.value, z.value ), soleVec( x.velocity, y.velocity, z.velocity ) };
}
