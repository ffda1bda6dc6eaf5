// SPDX-License-Identifier: MIT
// Second: how much of the host's second pose the ground demands.
//
// Where one foot stands much higher than another, no offset of the pelvis makes a good pose of one that was made for
// level ground: a high step or a crouch is a pose of its own, which the host may give. It is blended in by how far
// apart in height the grounds of the legs are, smoothly, for the next frame: this frame's pose has been read already.
// A host that has none may have Sole's own layer (layer.c) go by the same.
#include "place/place.h"

void soleDemandSecondPose( solePlaceWork* work )
{
	const soleSettings* s = work->settings;
	float low = 0.0f;
	float high = 0.0f;
	bool any = false;
	for ( int32_t i = 0; i < work->legCount; ++i )
	{
		const soleLegWork* leg = work->legs + i;
		if ( leg->usable && leg->hasGround )
		{
			float height = soleDot( leg->stand.to, work->up );
			low = any ? soleMinF( low, height ) : height;
			high = any ? soleMaxF( high, height ) : height;
			any = true;
		}
	}
	float apart = ( high - low ) / soleMaxF( soleLongestLeg( work ), 1e-6f );
	float width = soleMaxF( s->target.secondFull - s->target.secondFrom, 1e-3f );
	bool wanted = work->frame->secondPose != NULL || soleHasLayer( s );
	float goal = wanted ? soleSaturate( ( apart - s->target.secondFrom ) / width ) : 0.0f;
	soleOffset1* second = &work->state->second;
	*second = soleStepSpring( *second, goal, 0.0f, s->target.secondTime, work->timeStep );
	*second = work->first ? ( soleOffset1 ){ goal, 0.0f } : *second;
	second->value = soleSaturate( second->value );
}
