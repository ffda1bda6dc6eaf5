// SPDX-License-Identifier: MIT
// The mannequin's left foot, in root space of the rest pose.
//
// Cross-sections from heel to tip: an arched upper on a sole of even thickness, flat below at y = 0. The sole has
// edges, so walls and underside have vertices of their own. The section at the toe joint bends half with the toes.
#include "mannequin_mesh.h"

#include <math.h>

#define SOLE_THICKNESS 0.014f
#define SECTIONS 16
#define ARCH 9 // points over the upper, from the outer to the inner edge

typedef struct toolSection
{
	float ahead; // of the ankle
	float outer; // edge of the sole from the middle, away from the other foot
	float inner;
	float top;
	float toeShare; // weight of the toe joint
} toolSection;

static const toolSection s_sections[SECTIONS] = {
	{ -0.0550f, 0.012f, 0.012f, 0.034f, 0 },
	{ -0.0520f, 0.021f, 0.021f, 0.048f, 0 },
	{ -0.0430f, 0.029f, 0.029f, 0.066f, 0 },
	{ -0.0280f, 0.034f, 0.034f, 0.085f, 0 },
	{ -0.0050f, 0.036f, 0.035f, 0.098f, 0 },
	{ 0.0220f, 0.036f, 0.033f, 0.098f, 0 },
	{ 0.0500f, 0.038f, 0.032f, 0.086f, 0 },
	{ 0.0800f, 0.042f, 0.036f, 0.071f, 0 },
	{ 0.1080f, 0.046f, 0.041f, 0.058f, 0 },
	{ 0.1230f, 0.047f, 0.043f, 0.053f, 0.12f },
	{ 0.1300f, 0.047f, 0.043f, 0.051f, 0.5f },
	{ 0.1370f, 0.047f, 0.043f, 0.049f, 0.88f },
	{ 0.1540f, 0.044f, 0.043f, 0.045f, 1 },
	{ 0.1740f, 0.036f, 0.040f, 0.041f, 1 },
	{ 0.1910f, 0.023f, 0.031f, 0.035f, 1 },
	{ 0.2000f, 0.008f, 0.018f, 0.028f, 1 },
};

static int32_t toolAddFootVertex( toolShape* shape, const toolSection* section, float aside, float up )
{
	soleVec3 ankle = toolRestJoint( tool_jointFoot );
	soleVec3 position = { ankle.x + aside, up, ankle.z + section->ahead };
	return toolAddShapeVertex( shape, position, tool_jointFoot, tool_jointToe, section->toeShare );
}

/// The upper's arch over one section. @return its first vertex
static int32_t toolAddArch( toolShape* shape, const toolSection* section )
{
	int32_t first = shape->vertexCount;
	for ( int32_t i = 0; i < ARCH; ++i )
	{
		float angle = (float)( TOOL_PI * (double)i / (double)( ARCH - 1 ) );
		// The widest place is a little over the sole, the instep nearer to the inner side.
		float c = cosf( angle );
		float s = soleMaxF( sinf( angle ), 0.0f ); // at half a turn rounding goes below
		float side = c > 0.0f ? section->outer : section->inner;
		float aside = side * ( c > 0.0f ? powf( c, 0.80f ) : -powf( -c, 0.80f ) ) * 0.985f - 0.10f * s * section->outer;
		float up = SOLE_THICKNESS + ( section->top - SOLE_THICKNESS ) * powf( s, 0.85f );
		toolAddFootVertex( shape, section, aside, up );
	}
	return first;
}

static void toolAddUpper( toolShape* shape )
{
	int32_t first = toolAddArch( shape, s_sections );
	int32_t last = first;
	for ( int32_t k = 1; k < SECTIONS; ++k )
	{
		int32_t next = toolAddArch( shape, s_sections + k );
		for ( int32_t i = 0; i + 1 < ARCH; ++i )
		{
			const int32_t corners[4] = { last + i, last + i + 1, next + i + 1, next + i };
			toolAddShapeQuad( shape, corners, tool_materialBody );
		}
		last = next;
	}
	for ( int32_t i = 1; i + 1 < ARCH; ++i )
	{
		toolAddShapeTriangle( shape, first, first + i + 1, first + i, tool_materialBody );
		toolAddShapeTriangle( shape, last, last + i, last + i + 1, tool_materialBody );
	}
}

/// A vertical quad of the sole's wall from one edge point to the next, seen from outside from left to right.
static void toolAddWall( toolShape* shape, const int32_t low[2], const int32_t high[2] )
{
	const int32_t corners[4] = { low[0], low[1], high[1], high[0] };
	toolAddShapeQuad( shape, corners, tool_materialSoles );
}

static void toolAddSoleWalls( toolShape* shape )
{
	int32_t low[2 * SECTIONS];
	int32_t high[2 * SECTIONS];
	// Around the plan: back along the inner side, ahead along the outer side.
	for ( int32_t i = 0; i < 2 * SECTIONS; ++i )
	{
		const toolSection* section = s_sections + ( i < SECTIONS ? SECTIONS - 1 - i : i - SECTIONS );
		float aside = i < SECTIONS ? -section->inner : section->outer;
		low[i] = toolAddFootVertex( shape, section, aside, 0.0f );
		high[i] = toolAddFootVertex( shape, section, aside, SOLE_THICKNESS );
	}
	for ( int32_t i = 0; i < 2 * SECTIONS; ++i )
	{
		int32_t next = ( i + 1 ) % ( 2 * SECTIONS );
		const int32_t lowEdge[2] = { low[next], low[i] };
		const int32_t highEdge[2] = { high[next], high[i] };
		toolAddWall( shape, lowEdge, highEdge );
	}
}

static void toolAddUnderside( toolShape* shape )
{
	int32_t last[2] = { 0 };
	for ( int32_t k = 0; k < SECTIONS; ++k )
	{
		const toolSection* section = s_sections + k;
		int32_t inner = toolAddFootVertex( shape, section, -section->inner, 0.0f );
		int32_t outer = toolAddFootVertex( shape, section, section->outer, 0.0f );
		if ( k > 0 )
		{
			const int32_t corners[4] = { last[0], last[1], outer, inner };
			toolAddShapeQuad( shape, corners, tool_materialSoles );
		}
		last[0] = inner;
		last[1] = outer;
	}
}

void toolAddFoot( toolShape* shape )
{
	toolAddUpper( shape );
	toolAddSoleWalls( shape );
	toolAddUnderside( shape );
}
