// SPDX-License-Identifier: MIT
// What a clip's list of steps says at a time, for the host to hand on in a frame. No stage: the host calls it.
//
// Extrapolation. A root that goes on at velocity v and turns at rate w about up has moved after the time T, with the
// angle a = w T, by  T ( S v + C ( up x v ) ),  S = sin( a ) / a,  C = ( 1 - cos( a ) ) / a, the arc's integrals. Both
// are taken by their Taylor series, up to a quarter of a turn.
#include "base/core.h"
#include "base/math_internal.h"
#include "sole/sole.h"

/// The same step later.
static soleStep soleShiftStep( soleStep step, float by )
{
	step.strike += by;
	step.lift += by;
	step.heelDown += by;
	step.heelUp += by;
	step.toeDown += by;
	step.toeUp += by;
	return step;
}

static void soleReadStep( soleStep step, float time, soleContactInput* contact, soleStepInput* input )
{
	if ( time >= step.strike && time < step.lift )
	{
		contact->heel = time >= step.heelDown && time < step.heelUp ? 1.0f : 0.0f;
		contact->toe = time >= step.toeDown && time < step.toeUp ? 1.0f : 0.0f;
		// Between the parts, if ever, the foot stands on what is nearer to its middle.
		contact->toe = contact->heel > 0.0f ? contact->toe : 1.0f;
		input->since = time - step.strike;
		input->until = step.lift - time;
		input->place = step.place;
		input->forward = step.forward;
		return;
	}
	bool standing = contact->heel > 0.0f || contact->toe > 0.0f;
	float since = time - step.lift;
	if ( standing == false && since >= 0.0f && ( input->since < 0.0f || since < input->since ) )
	{
		input->since = since;
	}
	float until = step.strike - time;
	if ( standing == false && until >= 0.0f && ( input->until < 0.0f || until < input->until ) )
	{
		input->until = until;
		input->place = step.place;
		input->forward = step.forward;
	}
}

void soleGetStepInput( const soleStep* steps, int32_t stepCount, float duration, bool loops, float time, int32_t leg,
    soleContactInput* contact, soleStepInput* step )
{
	SOLE_ASSERT( contact != NULL && step != NULL && ( steps != NULL || stepCount <= 0 ) );
	if ( contact == NULL || step == NULL || ( steps == NULL && stepCount > 0 ) )
	{
		return;
	}
	*contact = ( soleContactInput ){ 0.0f, 0.0f };
	*step = ( soleStepInput ){ .since = -1.0f, .until = -1.0f };
	int32_t rounds = loops && duration > 0.0f ? 2 : 0;
	for ( int32_t i = 0; i < stepCount; ++i )
	{
		// A step may have begun a round or two ago, or be due in the next.
		for ( int32_t round = -rounds; round <= ( rounds > 0 ? 1 : 0 ) && steps[i].leg == leg; ++round )
		{
			soleReadStep( soleShiftStep( steps[i], (float)round * duration ), time, contact, step );
		}
	}
}

void soleStepInput_Travel( soleStepInput* step, soleTransform travel )
{
	SOLE_ASSERT( step != NULL );
	if ( step != NULL )
	{
		step->travel = travel.translation;
		step->place = soleTransformPoint( travel, step->place );
		step->forward = soleRotate( travel.rotation, step->forward );
	}
}

soleTransform soleExtrapolate( soleVec3 velocity, float turnRate, soleVec3 up, float time )
{
	float a = soleClampF( turnRate * time, -1.5707963f, 1.5707963f );
	float z = a * a;
	float s = 1.0f - z * ( 1.0f / 6.0f - z * ( 1.0f / 120.0f - z * ( 1.0f / 5040.0f ) ) );
	float c = a * ( 0.5f - z * ( 1.0f / 24.0f - z * ( 1.0f / 720.0f - z * ( 1.0f / 40320.0f ) ) ) );
	soleTransform travel = soleTransform_Identity();
	soleVec3 way = soleMulAdd( soleScale( s, velocity ), c, soleCross( up, velocity ) );
	travel.translation = soleScale( time, way );
	travel.rotation = soleHalfRotation( up, soleHalfFromAngle( a ) );
	return travel;
}
