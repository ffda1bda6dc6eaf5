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
// An offset that is smaller is over. Decaying on it would come to rest among the smallest floats, never at zero, and
// machines take a hundred times as long for those, and for what they make of squares below them: a character that
// stood still would cost more than one that walks.
#define NOTHING 1e-18f

/// What a step's length does to any spring of a half-life.
typedef struct soleSpringStep
{
	float time;
	bool rests; // nothing is left
	float y;
	float decay;
} soleSpringStep;

static soleSpringStep soleMakeSpringStep( float halfLife, float timeStep )
{
	float t = timeStep > 0.0f ? soleFiniteOr( timeStep, 0.0f ) : 0.0f;
	soleSpringStep step = { .time = t, .rests = !( halfLife > 0.0f ) || HALF_PHASE * t >= SETTLED * halfLife };
	if ( t > 0.0f && step.rests == false )
	{
		step.y = HALF_PHASE / halfLife;
		step.decay = soleExpNegative( HALF_PHASE * t / halfLife );
	}
	return step;
}

static soleOffset1 soleStepBy( soleSpringStep step, soleOffset1 spring, float goal, float goalVelocity )
{
	goal = soleFiniteOr( goal, soleFiniteOr( spring.value, 0.0f ) );
	goalVelocity = soleFiniteOr( goalVelocity, 0.0f );
	float value = soleFiniteOr( spring.value, goal );
	float velocity = soleFiniteOr( spring.velocity, 0.0f );
	float t = step.time;
	if ( t == 0.0f )
	{
		return ( soleOffset1 ){ value, velocity };
	}
	float movedGoal = soleFiniteOr( goal + goalVelocity * t, goal );
	if ( step.rests )
	{
		return ( soleOffset1 ){ movedGoal, goalVelocity };
	}
	float error = value - goal;
	float relative = velocity - goalVelocity;
	float a = relative + step.y * error;
	error = ( error + a * t ) * step.decay;
	relative = ( relative - step.y * a * t ) * step.decay;
	if ( soleMaxF( error, -error ) < NOTHING && soleMaxF( relative, -relative ) < NOTHING )
	{
		return ( soleOffset1 ){ movedGoal, goalVelocity };
	}
	return ( soleOffset1 ){
		soleFiniteOr( error + movedGoal, movedGoal ),
		soleFiniteOr( relative + goalVelocity, goalVelocity ),
	};
}

soleOffset1 soleStepSpring( soleOffset1 spring, float goal, float goalVelocity, float halfLife, float timeStep )
{
	return soleStepBy( soleMakeSpringStep( halfLife, timeStep ), spring, goal, goalVelocity );
}

static bool soleIsGone( soleOffset1 offset )
{
	return soleMaxF( offset.value, -offset.value ) < NOTHING && soleMaxF( offset.velocity, -offset.velocity ) < NOTHING;
}

soleOffset1 soleDecayOffset1( soleOffset1 offset, float halfLife, float timeStep )
{
	return soleIsGone( offset ) ? ( soleOffset1 ){ 0.0f, 0.0f }
	                            : soleStepSpring( offset, 0.0f, 0.0f, halfLife, timeStep );
}

soleOffset3 soleDecayOffset3( soleOffset3 offset, float halfLife, float timeStep )
{
	soleVec3 v = offset.value, w = offset.velocity;
	soleOffset1 parts[3] = { { v.x, w.x }, { v.y, w.y }, { v.z, w.z } };
	if ( soleIsGone( parts[0] ) && soleIsGone( parts[1] ) && soleIsGone( parts[2] ) )
	{
		return ( soleOffset3 ){ .value = { 0.0f, 0.0f, 0.0f } };
	}
	soleSpringStep step = soleMakeSpringStep( halfLife, timeStep );
	for ( int32_t i = 0; i < 3; ++i )
	{
		soleOffset1 rest = { 0.0f, 0.0f };
		parts[i] = soleIsGone( parts[i] ) ? rest : soleStepBy( step, parts[i], 0.0f, 0.0f );
	}
	return ( soleOffset3 ){ soleVec( parts[0].value, parts[1].value, parts[2].value ),
		soleVec( parts[0].velocity, parts[1].velocity, parts[2].velocity ) };
}
