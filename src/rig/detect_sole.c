// SPDX-License-Identifier: MIT
// Where the soles are: the lowest plane of the skin that the feet carry, or, without a skin, what a human foot would be
// at these joints. All in character space, in the bind pose. A foot's own frame: forward, lateral, normal of the sole.
#include "detect_internal.h"

#include "base/math_internal.h"

#include <math.h>
#include <stdlib.h>

#define BALL_SHARE 0.73f // where the ball is on a sole, from heel 0 to toe 1

typedef struct soleFootFrame
{
	soleVec3 forward;
	soleVec3 lateral;
	soleVec3 normal;
	float unit; // what a metre of a human is here
} soleFootFrame;

// ------------------------------------------------------------------------------------------------------------ skin

static int32_t soleCountFoot( const soleDetect* detect )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < detect->jointCount; ++i )
	{
		count += detect->ints[i] != 0 ? detect->skinnedCount[i] : 0;
	}
	return count;
}

/// Vertices of the foot as forward, lateral and height, three floats each. @return how many
static int32_t soleGatherFoot( soleDetect* detect, const soleFootFrame* frame )
{
	int32_t count = 0;
	for ( int32_t i = 0; i < detect->skeleton->skinCount; ++i )
	{
		int32_t joint = detect->dominant[i];
		if ( joint != SOLE_NONE && detect->ints[joint] != 0 )
		{
			soleVec3 p = detect->skeleton->skin[i].position;
			float* out = detect->vertexFloats + 3 * (size_t)count;
			out[0] = soleDot( p, frame->forward );
			out[1] = soleDot( p, frame->lateral );
			out[2] = soleDot( p, frame->normal );
			count += 1;
		}
	}
	return count;
}

static int soleCompareHeights( const void* a, const void* b )
{
	const float* p = (const float*)a;
	const float* q = (const float*)b;
	for ( int32_t k = 2; k >= 0; --k )
	{
		if ( p[k] != q[k] )
		{
			return p[k] < q[k] ? -1 : 1;
		}
	}
	return 0;
}

/// Height of the lowest plane: a few stray vertices below it do not count. Vertices must be sorted by height.
static float solePlaneHeight( const float* vertices, int32_t count )
{
	int32_t rank = count / 50;
	rank = rank < 2 ? ( count > 8 ? 2 : 0 ) : rank;
	return vertices[3 * rank + 2];
}

static int32_t soleCountBand( const float* vertices, int32_t count, float top )
{
	int32_t inside = 0;
	while ( inside < count && vertices[3 * inside + 2] <= top )
	{
		inside += 1;
	}
	return inside;
}

/// Least, greatest and mean lateral of the sole's vertices between two lines across the foot.
typedef struct soleStripe
{
	float low;
	float high;
	int32_t count;
} soleStripe;

static soleStripe soleMeasureStripe( const float* vertices, int32_t count, float from, float to )
{
	soleStripe stripe = { 1e30f, -1e30f, 0 };
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( vertices[3 * i] >= from && vertices[3 * i] <= to )
		{
			stripe.low = soleMinF( stripe.low, vertices[3 * i + 1] );
			stripe.high = soleMaxF( stripe.high, vertices[3 * i + 1] );
			stripe.count += 1;
		}
	}
	return stripe;
}

/// The stripe at that place, as wide as it takes to meet both edges.
static soleStripe soleFindStripe( const float* vertices, int32_t count, float at, float length )
{
	soleStripe stripe = { 0.0f, 0.0f, 0 };
	for ( float half = 0.08f; half < 2.0f; half *= 1.5f )
	{
		stripe = soleMeasureStripe( vertices, count, at - half * length, at + half * length );
		if ( stripe.count >= 4 || ( stripe.count >= 2 && stripe.high - stripe.low > 0.2f * length ) )
		{
			break;
		}
	}
	return stripe;
}

static soleVec3 solePlacePoint( const soleFootFrame* frame, float forward, float lateral, float height )
{
	soleVec3 p = soleScale( forward, frame->forward );
	p = soleMulAdd( p, lateral, frame->lateral );
	return soleMulAdd( p, height, frame->normal );
}

/// Which way along the lateral axis the other leg is.
static float soleInnerSign( const soleDetect* detect, int32_t index, soleVec3 lateral )
{
	const soleFoundLeg* leg = detect->legs + index;
	soleVec3 middle = soleVec( 0.0f, 0.0f, 0.0f );
	for ( int32_t i = 0; i < detect->legCount; ++i )
	{
		middle = soleMulAdd( middle, 1.0f / (float)detect->legCount, detect->position[detect->legs[i].joints[0]] );
	}
	if ( detect->legCount == 1 && detect->pelvis != SOLE_NONE )
	{
		middle = detect->position[detect->pelvis];
	}
	return soleDot( soleSub( middle, detect->position[leg->joints[0]] ), lateral ) > 0.0f ? 1.0f : -1.0f;
}

static soleSolePoints soleMakeSole( const soleDetect* detect, int32_t index, const soleFootFrame* frame,
    const float along[3], const float lateral[3], float halfWidth, float height )
{
	float inner = soleInnerSign( detect, index, frame->lateral ) * halfWidth;
	soleSolePoints sole = {
		solePlacePoint( frame, along[0], lateral[0], height ),
		solePlacePoint( frame, along[1], lateral[1], height ),
		solePlacePoint( frame, along[2], lateral[2], height ),
		solePlacePoint( frame, along[1], lateral[1] + inner, height ),
		solePlacePoint( frame, along[1], lateral[1] - inner, height ),
	};
	return sole;
}

/// How far the skin of the toes reaches from their joint: the same however they are bent.
static float soleFindToeReach( const soleDetect* detect, int32_t toe )
{
	float reach = 0.0f;
	for ( int32_t i = 0; i < detect->skeleton->skinCount; ++i )
	{
		int32_t joint = detect->dominant[i];
		if ( joint != SOLE_NONE && soleDetect_IsBelow( detect, joint, toe ) )
		{
			reach = soleMaxF( reach, soleDistance( detect->skeleton->skin[i].position, detect->position[toe] ) );
		}
	}
	return reach;
}

static soleSolePoints soleFindSkinSole( soleDetect* detect, int32_t index, const soleFootFrame* frame, int32_t count )
{
	const soleFoundLeg* leg = detect->legs + index;
	float* vertices = detect->vertexFloats;
	qsort( vertices, (size_t)count, 3 * sizeof( float ), soleCompareHeights );
	float height = solePlaneHeight( vertices, count );
	int32_t inside = soleCountBand( vertices, count, height + SOLE_HUMAN_BAND * frame->unit );
	float heel = 1e30f;
	float toe = -1e30f;
	for ( int32_t i = 0; i < inside; ++i )
	{
		heel = soleMinF( heel, vertices[3 * i] );
		toe = soleMaxF( toe, vertices[3 * i] );
	}
	// A foot that ends in a point still gets a sole that can carry.
	float least = 0.02f * leg->length;
	if ( toe - heel < least )
	{
		float middle = 0.5f * ( heel + toe );
		heel = middle - 0.5f * least;
		toe = middle + 0.5f * least;
	}
	float length = toe - heel;
	float ball = heel + BALL_SHARE * length;
	if ( leg->toeCount > 0 )
	{
		ball = soleDot( detect->position[leg->toes[0]], frame->forward );
		if ( detect->standing == false )
		{
			toe = soleMaxF( toe, ball + soleFindToeReach( detect, leg->toes[0] ) );
			length = toe - heel;
		}
		ball = soleClampF( ball, heel + 0.4f * length, heel + 0.95f * length );
	}
	soleStripe atBall = soleFindStripe( vertices, inside, ball, length );
	soleStripe atHeel = soleMeasureStripe( vertices, inside, heel - 1e-3f * length, heel + 0.15f * length );
	soleStripe atToe = soleMeasureStripe( vertices, inside, toe - 0.15f * length, toe + 1e-3f * length );
	float middle = 0.5f * ( atBall.low + atBall.high );
	const float along[3] = { heel, ball, toe };
	const float lateral[3] = { atHeel.count > 1 ? 0.5f * ( atHeel.low + atHeel.high ) : middle, middle,
		atToe.count > 1 ? 0.5f * ( atToe.low + atToe.high ) : middle };
	float half = soleMaxF( 0.5f * ( atBall.high - atBall.low ), 0.25f * least );
	soleAddFinding( detect, sole_info, index, SOLE_NONE, "",
	    "sole from %d of %d vertices of the foot: %.3g long, %.3g wide, %.3g below the ankle", (int)inside, (int)count,
	    (double)length, (double)( 2.0f * half ), (double)( soleDot( leg->ankle, frame->normal ) - height ) );
	return soleMakeSole( detect, index, frame, along, lateral, half, height );
}

/// Vertices that the foot carries; of the shin as well where the foot itself has hardly any.
static bool soleMarkFootSkin( soleDetect* detect, const soleFoundLeg* leg )
{
	if ( detect->dominant == NULL )
	{
		return false;
	}
	soleDetect_MarkBelow( detect, soleFoundLeg_GetFoot( leg ) );
	int32_t last = leg->jointCount - 1;
	for ( int32_t i = last; i >= 1 && soleCountFoot( detect ) < 3; --i )
	{
		soleDetect_MarkBelow( detect, leg->joints[i] );
	}
	return soleCountFoot( detect ) >= 3;
}

void soleFindVirtualAnkle( soleDetect* detect, int32_t index )
{
	soleFoundLeg* leg = detect->legs + index;
	if ( leg->hasVirtualAnkle == false || leg->detachedFoot != SOLE_NONE )
	{
		return;
	}
	soleVec3 from = detect->position[leg->joints[leg->jointCount - 1]];
	soleFootFrame frame = { 0 };
	frame.normal = detect->up;
	frame.forward = soleAnyOrthogonal( detect->up );
	frame.lateral = soleCross( detect->up, frame.forward );
	if ( soleMarkFootSkin( detect, leg ) == false )
	{
		return;
	}
	int32_t count = soleGatherFoot( detect, &frame );
	qsort( detect->vertexFloats, (size_t)count, 3 * sizeof( float ), soleCompareHeights );
	float height = solePlaneHeight( detect->vertexFloats, count );
	int32_t inside =
	    soleCountBand( detect->vertexFloats, count, height + SOLE_HUMAN_BAND * soleFoundLeg_GetUnit( leg ) );
	float middle[2] = { 0.0f, 0.0f };
	for ( int32_t i = 0; i < inside; ++i )
	{
		middle[0] += detect->vertexFloats[3 * i] / (float)inside;
		middle[1] += detect->vertexFloats[3 * i + 1] / (float)inside;
	}
	float below = soleDot( from, detect->up ) - height;
	if ( below < 0.05f * leg->length )
	{
		return;
	}
	leg->ankle = solePlacePoint( &frame, middle[0], middle[1], height );
	soleFoundLeg_Measure( detect, leg );
	leg->ankleFromSkin = true;
}

// ---------------------------------------------------------------------------------------------------------- frames

static soleFootFrame soleStandingFrame( const soleDetect* detect, const soleFoundLeg* leg )
{
	soleFootFrame frame = { detect->forward, detect->lateral, detect->up, soleFoundLeg_GetUnit( leg ) };
	int32_t toe = leg->tip != SOLE_NONE ? leg->tip : ( leg->toeCount > 0 ? leg->toes[leg->toeCount - 1] : SOLE_NONE );
	if ( toe != SOLE_NONE )
	{
		soleVec3 d = soleReject( soleSub( detect->position[toe], leg->ankle ), detect->up );
		soleVec3 heading = soleNormalizeOr( soleScale( 1.0f / leg->length, d ), detect->forward );
		// Feet are turned out a little; more than 60 degrees is no foot's heading.
		if ( soleDot( heading, detect->forward ) > 0.5f && soleLength( d ) > 0.03f * leg->length )
		{
			frame.forward = heading;
		}
	}
	frame.lateral = soleNormalizeOr( soleCross( frame.normal, frame.forward ), detect->lateral );
	return frame;
}

static soleFootFrame soleTurnFrame( const soleFootFrame* frame, float pitch )
{
	soleFootFrame turned = *frame;
	soleHalf half = soleHalfFromAngle( pitch );
	float c = half.c * half.c - half.s * half.s;
	float s = 2.0f * half.c * half.s;
	turned.forward = soleMulAdd( soleScale( c, frame->forward ), -s, frame->normal );
	turned.normal = soleMulAdd( soleScale( c, frame->normal ), s, frame->forward );
	return turned;
}

/// A foot in the air: the pitch at which its skin is flattest below, that is with the longest sole.
static soleFootFrame soleFlattestFrame( soleDetect* detect, const soleFootFrame* level )
{
	float best = -1.0f;
	soleFootFrame bestFrame = *level;
	for ( int32_t i = -25; i <= 25; ++i )
	{
		soleFootFrame frame = soleTurnFrame( level, (float)i * 0.05f );
		int32_t count = soleGatherFoot( detect, &frame );
		qsort( detect->vertexFloats, (size_t)count, 3 * sizeof( float ), soleCompareHeights );
		float height = solePlaneHeight( detect->vertexFloats, count );
		int32_t inside = soleCountBand( detect->vertexFloats, count, height + 0.5f * SOLE_HUMAN_BAND * frame.unit );
		float mean = 0.0f;
		float spread = 0.0f;
		for ( int32_t v = 0; v < inside; ++v )
		{
			mean += detect->vertexFloats[3 * v] / (float)inside;
		}
		for ( int32_t v = 0; v < inside; ++v )
		{
			float d = detect->vertexFloats[3 * v] - mean;
			spread += d * d;
		}
		if ( spread > best )
		{
			best = spread;
			bestFrame = frame;
		}
	}
	return bestFrame;
}

/// A foot in the air without a skin: turned so that ankle and toe joint are as high over the sole as a human's are.
static soleFootFrame soleHumanFrame( const soleDetect* detect, const soleFoundLeg* leg, const soleFootFrame* level )
{
	int32_t toe = soleFoundLeg_GetEnd( leg );
	if ( toe == SOLE_NONE )
	{
		return *level;
	}
	soleVec3 d = soleReject( soleSub( detect->position[toe], leg->ankle ), level->lateral );
	float reach = soleLength( d );
	if ( reach < 0.02f * leg->length )
	{
		return *level;
	}
	float wanted = ( SOLE_HUMAN_ANKLE - ( leg->toeCount > 0 ? SOLE_HUMAN_TOE_JOINT : 0.0f ) ) * level->unit;
	float sine = soleClampF( wanted / reach, 0.0f, 0.9f );
	soleVec3 along = soleScale( 1.0f / reach, d );
	soleVec3 square = soleCross( along, level->lateral );
	soleFootFrame frame = *level;
	frame.normal = soleMulAdd( soleScale( -sine, along ), soleSqrtF( 1.0f - sine * sine ), square );
	frame.forward = soleNormalizeOr( soleCross( frame.lateral, frame.normal ), level->forward );
	return frame;
}

// ----------------------------------------------------------------------------------------------------------- joints

static soleSolePoints soleFindJointSole( soleDetect* detect, int32_t index, const soleFootFrame* frame )
{
	const soleFoundLeg* leg = detect->legs + index;
	float unit = frame->unit;
	soleVec3 foot = leg->detachedFoot != SOLE_NONE ? detect->position[leg->detachedFoot] : leg->ankle;
	float ankle = soleDot( foot, frame->forward );
	float heel = ankle - SOLE_HUMAN_HEEL * unit;
	float ball = 0.0f;
	float toe = ankle + SOLE_HUMAN_FOOT * unit;
	bool point = ( detect->legCount > 2 || leg->hasVirtualAnkle ) && leg->toeCount == 0 && leg->tip == SOLE_NONE;
	if ( point )
	{
		heel = ankle - 0.02f * leg->length;
		toe = ankle + 0.02f * leg->length;
	}
	float end = leg->tip != SOLE_NONE ? soleDot( detect->position[leg->tip], frame->forward ) : ankle;
	bool endsAtBall = leg->toeCount == 0 && end - ankle < SOLE_HUMAN_BALL * unit;
	if ( leg->tip != SOLE_NONE )
	{
		toe = end + ( endsAtBall ? SOLE_HUMAN_TOE * unit : 0.0f );
	}
	else if ( leg->toeCount > 0 )
	{
		toe = soleDot( detect->position[leg->toes[leg->toeCount - 1]], frame->forward ) +
		    ( leg->toeCount == 1 ? SOLE_HUMAN_TOE * unit : 0.02f * unit );
	}
	toe = soleMaxF( toe, heel + 0.04f * leg->length );
	ball = heel + BALL_SHARE * ( toe - heel );
	float middle = soleDot( foot, frame->lateral );
	float fore = middle;
	if ( leg->tip != SOLE_NONE && endsAtBall )
	{
		ball = soleClampF( end, heel, toe );
	}
	if ( leg->toeCount > 0 )
	{
		ball = soleClampF( soleDot( detect->position[leg->toes[0]], frame->forward ), heel, toe );
		fore = soleDot( detect->position[leg->toes[0]], frame->lateral );
	}
	float height = detect->floor;
	if ( detect->standing == false )
	{
		height = soleDot( foot, frame->normal ) - SOLE_HUMAN_ANKLE * unit;
		if ( leg->toeCount > 0 )
		{
			float below = soleDot( detect->position[leg->toes[0]], frame->normal ) - SOLE_HUMAN_TOE_JOINT * unit;
			height = soleMinF( height, below );
		}
	}
	const float along[3] = { heel, ball, toe };
	const float lateral[3] = { middle, fore, fore };
	soleAddFinding( detect, sole_warning, index, SOLE_NONE, "give the mesh, or the sole points by hand",
	    "no skin tells where the sole is: taken from the joints as a human's, %.3g below the ankle",
	    (double)( soleDot( foot, frame->normal ) - height ) );
	float half = ( point ? 0.02f * leg->length : SOLE_HUMAN_HALF_WIDTH * unit );
	return soleMakeSole( detect, index, frame, along, lateral, half, height );
}

/// Toes may be bent in a stride: the part behind them tells the sole plane, where it has enough skin for that.
static void soleUnmarkToes( soleDetect* detect, const soleFoundLeg* leg )
{
	int32_t left = soleCountFoot( detect );
	for ( int32_t pass = 0; pass < 2 && leg->toeCount > 0; ++pass )
	{
		for ( int32_t i = 0; i < detect->jointCount; ++i )
		{
			bool toe = detect->ints[i] != 0 && soleDetect_IsBelow( detect, i, leg->toes[0] );
			if ( toe && pass == 0 )
			{
				left -= detect->skinnedCount[i];
			}
			else if ( toe && left >= 8 )
			{
				detect->ints[i] = 0;
			}
		}
	}
}

soleSolePoints soleFindSole( soleDetect* detect, int32_t index )
{
	const soleFoundLeg* leg = detect->legs + index;
	soleFootFrame frame = soleStandingFrame( detect, leg );
	if ( soleMarkFootSkin( detect, leg ) == false )
	{
		if ( detect->standing == false )
		{
			frame = soleHumanFrame( detect, leg, &frame );
		}
		return soleFindJointSole( detect, index, &frame );
	}
	if ( detect->standing == false )
	{
		soleUnmarkToes( detect, leg );
		frame = soleFlattestFrame( detect, &frame );
	}
	int32_t count = soleGatherFoot( detect, &frame );
	return soleFindSkinSole( detect, index, &frame, count );
}
