// SPDX-License-Identifier: MIT
// The mannequin's mesh: lofts of rings along the bones, in root space of the rest pose.
//
// A loft is a row of rings, each a superellipse about a point of an axis; it is closed at both ends by a fan to a
// point. Weights and materials go with the rings. Only the left side is laid out, the right one is its mirror image.
#include "mannequin_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// One ring: where along the axis, off it, how large, which joint carries it.
typedef struct toolRing
{
	float along; // m from the loft's start
	float offU;  // centre off the axis
	float offV;
	float radiusU;
	float radiusV;
	float square; // exponent of the superellipse: 2 is an ellipse, more is fuller
	int32_t joint;
	int32_t other; // takes `share` of the weight
	float share;
	int32_t material; // of the band up to the next ring
} toolRing;

typedef struct toolLoft
{
	soleVec3 start;
	soleVec3 along; // unit vectors, u x v = along
	soleVec3 u;
	soleVec3 v;
	int32_t sides;
	int32_t ringCount;
	const toolRing* rings;
} toolLoft;

enum
{
	S_HIPS = tool_jointHips,
	S_SPINE = tool_jointSpine,
	S_CHEST = tool_jointChest,
	S_NECK = tool_jointNeck,
	S_HEAD = tool_jointHead,
	S_SHOULDER = tool_jointShoulder,
	S_UPPERARM = tool_jointUpperarm,
	S_FOREARM = tool_jointForearm,
	S_HAND = tool_jointHand,
	S_THIGH = tool_jointThigh,
	S_SHIN = tool_jointShin,
	S_FOOT = tool_jointFoot,
	BODY = tool_materialBody,
	DARK = tool_materialJoints
};

// Downwards from y = 1.525.
static const toolRing s_torso[] = {
	{ 0.000f, 0, -0.018f, 0.0460f, 0.0500f, 2.0f, S_CHEST, S_NECK, 0.45f, BODY },
	{ 0.022f, 0, -0.020f, 0.0620f, 0.0560f, 2.0f, S_CHEST, S_NECK, 0.25f, BODY },
	{ 0.046f, 0, -0.021f, 0.0940f, 0.0680f, 2.0f, S_CHEST, S_NECK, 0.08f, BODY },
	{ 0.078f, 0, -0.018f, 0.1380f, 0.0840f, 2.1f, S_CHEST, S_CHEST, 0.00f, BODY },
	{ 0.118f, 0, -0.010f, 0.1640f, 0.1020f, 2.2f, S_CHEST, S_CHEST, 0.00f, BODY },
	{ 0.172f, 0, -0.001f, 0.1730f, 0.1170f, 2.2f, S_CHEST, S_CHEST, 0.00f, BODY },
	{ 0.230f, 0, 0.001f, 0.1630f, 0.1160f, 2.2f, S_CHEST, S_CHEST, 0.00f, BODY },
	{ 0.288f, 0, -0.003f, 0.1470f, 0.1070f, 2.1f, S_CHEST, S_SPINE, 0.25f, BODY },
	{ 0.340f, 0, -0.006f, 0.1340f, 0.0980f, 2.1f, S_SPINE, S_CHEST, 0.40f, BODY },
	{ 0.372f, 0, -0.007f, 0.1260f, 0.0920f, 2.0f, S_SPINE, S_CHEST, 0.12f, DARK },
	{ 0.396f, 0, -0.007f, 0.1250f, 0.0910f, 2.0f, S_SPINE, S_HIPS, 0.10f, DARK },
	{ 0.420f, 0, -0.008f, 0.1300f, 0.0940f, 2.0f, S_SPINE, S_HIPS, 0.35f, BODY },
	{ 0.456f, 0, -0.010f, 0.1440f, 0.1020f, 2.1f, S_HIPS, S_SPINE, 0.35f, BODY },
	{ 0.505f, 0, -0.014f, 0.1610f, 0.1130f, 2.2f, S_HIPS, S_SPINE, 0.10f, BODY },
	{ 0.556f, 0, -0.018f, 0.1740f, 0.1220f, 2.3f, S_HIPS, S_HIPS, 0.00f, BODY },
	{ 0.606f, 0, -0.020f, 0.1760f, 0.1250f, 2.3f, S_HIPS, S_HIPS, 0.00f, BODY },
	{ 0.645f, 0, -0.018f, 0.1600f, 0.1170f, 2.2f, S_HIPS, S_HIPS, 0.00f, BODY },
	{ 0.670f, 0, -0.013f, 0.1180f, 0.0980f, 2.1f, S_HIPS, S_HIPS, 0.00f, BODY },
	{ 0.690f, 0, -0.006f, 0.0600f, 0.0640f, 2.0f, S_HIPS, S_HIPS, 0.00f, BODY },
};

// Downwards from y = 1.590: the neck inside head and chest.
static const toolRing s_neck[] = {
	{ 0.000f, 0, 0.000f, 0.046f, 0.050f, 2.0f, S_HEAD, S_NECK, 0.2f, DARK },
	{ 0.030f, 0, -0.004f, 0.050f, 0.054f, 2.0f, S_NECK, S_HEAD, 0.4f, DARK },
	{ 0.062f, 0, -0.010f, 0.051f, 0.055f, 2.0f, S_NECK, S_CHEST, 0.1f, DARK },
	{ 0.092f, 0, -0.016f, 0.054f, 0.057f, 2.0f, S_CHEST, S_NECK, 0.45f, DARK },
};

// Downwards from the crown at y = 1.750.
static const toolRing s_head[] = {
	{ 0.0035f, 0, -0.010f, 0.020f, 0.026f, 2.0f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.014f, 0, -0.009f, 0.042f, 0.054f, 2.0f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.034f, 0, -0.007f, 0.061f, 0.077f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.062f, 0, -0.003f, 0.073f, 0.092f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.095f, 0, 0.001f, 0.0765f, 0.097f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.125f, 0, 0.005f, 0.074f, 0.094f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.155f, 0, 0.012f, 0.068f, 0.084f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.182f, 0, 0.022f, 0.058f, 0.069f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.205f, 0, 0.034f, 0.044f, 0.050f, 2.1f, S_HEAD, S_HEAD, 0, BODY },
	{ 0.219f, 0, 0.044f, 0.025f, 0.029f, 2.0f, S_HEAD, S_HEAD, 0, BODY },
};

// Along the arm, from 0.055 m before the shoulder joint. The shoulder's ball, elbow and wrist are dark.
static const toolRing s_arm[] = {
	{ 0.000f, -0.010f, 0, 0.030f, 0.034f, 2.0f, S_SHOULDER, S_UPPERARM, 0.3f, DARK },
	{ 0.016f, -0.006f, 0, 0.047f, 0.050f, 2.0f, S_UPPERARM, S_SHOULDER, 0.5f, DARK },
	{ 0.042f, -0.002f, 0, 0.0565f, 0.059f, 2.0f, S_UPPERARM, S_SHOULDER, 0.2f, DARK },
	{ 0.072f, 0.000f, 0, 0.0560f, 0.058f, 2.0f, S_UPPERARM, S_UPPERARM, 0, BODY },
	{ 0.110f, 0.000f, 0, 0.053f, 0.055f, 2.0f, S_UPPERARM, S_UPPERARM, 0, BODY },
	{ 0.170f, 0.000f, 0.004f, 0.047f, 0.051f, 2.0f, S_UPPERARM, S_UPPERARM, 0, BODY },
	{ 0.230f, 0.000f, 0.003f, 0.043f, 0.047f, 2.0f, S_UPPERARM, S_UPPERARM, 0, BODY },
	{ 0.290f, 0.000f, 0.000f, 0.039f, 0.042f, 2.0f, S_UPPERARM, S_UPPERARM, 0, BODY },
	{ 0.316f, 0.000f, -0.001f, 0.0365f, 0.039f, 2.0f, S_UPPERARM, S_FOREARM, 0.20f, DARK },
	{ 0.340f, 0.000f, -0.002f, 0.0375f, 0.040f, 2.0f, S_UPPERARM, S_FOREARM, 0.50f, DARK },
	{ 0.364f, 0.000f, 0.000f, 0.0375f, 0.040f, 2.0f, S_FOREARM, S_UPPERARM, 0.20f, DARK },
	{ 0.386f, 0.000f, 0.002f, 0.040f, 0.043f, 2.0f, S_FOREARM, S_FOREARM, 0, BODY },
	{ 0.420f, 0.000f, 0.003f, 0.041f, 0.044f, 2.0f, S_FOREARM, S_FOREARM, 0, BODY },
	{ 0.480f, 0.000f, 0.002f, 0.036f, 0.039f, 2.0f, S_FOREARM, S_FOREARM, 0, BODY },
	{ 0.540f, 0.000f, 0.000f, 0.029f, 0.032f, 2.0f, S_FOREARM, S_FOREARM, 0, BODY },
	{ 0.568f, 0.000f, 0.000f, 0.024f, 0.028f, 2.0f, S_FOREARM, S_HAND, 0.10f, DARK },
	{ 0.590f, 0.000f, 0.000f, 0.022f, 0.027f, 2.0f, S_HAND, S_FOREARM, 0.50f, DARK },
	{ 0.606f, 0.000f, 0.000f, 0.020f, 0.029f, 2.2f, S_HAND, S_FOREARM, 0.10f, BODY },
	{ 0.632f, -0.001f, 0.001f, 0.0185f, 0.038f, 2.4f, S_HAND, S_HAND, 0, BODY },
	{ 0.668f, -0.003f, 0.001f, 0.0165f, 0.042f, 2.5f, S_HAND, S_HAND, 0, BODY },
	{ 0.698f, -0.006f, -0.001f, 0.0145f, 0.040f, 2.5f, S_HAND, S_HAND, 0, BODY },
	{ 0.730f, -0.014f, -0.003f, 0.0125f, 0.036f, 2.4f, S_HAND, S_HAND, 0, BODY },
	{ 0.756f, -0.025f, -0.004f, 0.0110f, 0.030f, 2.3f, S_HAND, S_HAND, 0, BODY },
	{ 0.772f, -0.034f, -0.004f, 0.0080f, 0.021f, 2.0f, S_HAND, S_HAND, 0, BODY },
};

// Along the thumb, from the wrist's front.
static const toolRing s_thumb[] = {
	{ 0.000f, 0, 0, 0.012f, 0.014f, 2.0f, S_HAND, S_HAND, 0, BODY },
	{ 0.022f, 0, 0, 0.0135f, 0.0155f, 2.0f, S_HAND, S_HAND, 0, BODY },
	{ 0.050f, 0, 0, 0.0115f, 0.0125f, 2.0f, S_HAND, S_HAND, 0, BODY },
	{ 0.070f, 0, 0, 0.0085f, 0.0090f, 2.0f, S_HAND, S_HAND, 0, BODY },
};

// Downwards from y = 0.975 at x = 0.09: the top is hidden in the pelvis.
static const toolRing s_leg[] = {
	{ 0.020f, -0.012f, -0.006f, 0.044f, 0.060f, 2.0f, S_HIPS, S_THIGH, 0.30f, BODY },
	{ 0.045f, -0.008f, -0.006f, 0.062f, 0.079f, 2.0f, S_HIPS, S_THIGH, 0.50f, BODY },
	{ 0.080f, -0.005f, -0.006f, 0.075f, 0.091f, 2.1f, S_THIGH, S_HIPS, 0.30f, BODY },
	{ 0.120f, -0.003f, -0.004f, 0.080f, 0.094f, 2.1f, S_THIGH, S_HIPS, 0.10f, BODY },
	{ 0.175f, 0.000f, 0.000f, 0.079f, 0.089f, 2.0f, S_THIGH, S_THIGH, 0, BODY },
	{ 0.250f, 0.001f, 0.005f, 0.072f, 0.080f, 2.0f, S_THIGH, S_THIGH, 0, BODY },
	{ 0.325f, 0.001f, 0.008f, 0.064f, 0.070f, 2.0f, S_THIGH, S_THIGH, 0, BODY },
	{ 0.390f, 0.000f, 0.009f, 0.056f, 0.060f, 2.0f, S_THIGH, S_THIGH, 0, BODY },
	{ 0.428f, 0.000f, 0.009f, 0.0515f, 0.0555f, 2.1f, S_THIGH, S_SHIN, 0.12f, DARK },
	{ 0.452f, 0.000f, 0.009f, 0.0505f, 0.0550f, 2.1f, S_THIGH, S_SHIN, 0.32f, DARK },
	{ 0.474f, 0.000f, 0.008f, 0.0500f, 0.0535f, 2.1f, S_SHIN, S_THIGH, 0.45f, DARK },
	{ 0.498f, 0.000f, 0.004f, 0.0490f, 0.0525f, 2.1f, S_SHIN, S_THIGH, 0.20f, DARK },
	{ 0.524f, 0.000f, -0.001f, 0.0510f, 0.0555f, 2.0f, S_SHIN, S_THIGH, 0.04f, BODY },
	{ 0.570f, 0.001f, -0.009f, 0.0550f, 0.0620f, 2.0f, S_SHIN, S_SHIN, 0, BODY },
	{ 0.625f, 0.001f, -0.014f, 0.0555f, 0.0640f, 2.0f, S_SHIN, S_SHIN, 0, BODY },
	{ 0.685f, 0.000f, -0.014f, 0.0500f, 0.0575f, 2.0f, S_SHIN, S_SHIN, 0, BODY },
	{ 0.745f, 0.000f, -0.011f, 0.0415f, 0.0470f, 2.0f, S_SHIN, S_SHIN, 0, BODY },
	{ 0.800f, 0.000f, -0.009f, 0.0350f, 0.0400f, 2.0f, S_SHIN, S_SHIN, 0, BODY },
	{ 0.838f, 0.000f, -0.010f, 0.0325f, 0.0380f, 2.0f, S_SHIN, S_FOOT, 0.05f, DARK },
	{ 0.866f, 0.000f, -0.012f, 0.0330f, 0.0390f, 2.0f, S_SHIN, S_FOOT, 0.25f, DARK },
	{ 0.890f, 0.000f, -0.012f, 0.0345f, 0.0400f, 2.0f, S_FOOT, S_SHIN, 0.45f, DARK },
	{ 0.912f, 0.000f, -0.010f, 0.0320f, 0.0370f, 2.0f, S_FOOT, S_SHIN, 0.10f, DARK },
};

#define RINGS( table ) ( int32_t )( sizeof( table ) / sizeof( ( table )[0] ) ), table

static toolVertex toolMakeVertex( soleVec3 position, int32_t joint, int32_t other, float share )
{
	return ( toolVertex ){ .position = position, .joint = joint, .other = other, .share = share };
}

static int32_t toolAddVertex( toolShape* shape, toolVertex vertex )
{
	if ( shape->vertexCount == shape->vertexRoom )
	{
		shape->vertexRoom = 2 * shape->vertexRoom + 256;
		shape->vertices = toolGrow( shape->vertices, (size_t)shape->vertexRoom, sizeof( toolVertex ) );
	}
	shape->vertices[shape->vertexCount] = vertex;
	return shape->vertexCount++;
}

int32_t toolAddShapeVertex( toolShape* shape, soleVec3 position, int32_t joint, int32_t other, float share )
{
	return toolAddVertex( shape, toolMakeVertex( position, joint, other, share ) );
}

void toolAddShapeTriangle( toolShape* shape, int32_t a, int32_t b, int32_t c, int32_t material )
{
	if ( shape->triangleCount == shape->triangleRoom )
	{
		shape->triangleRoom = 2 * shape->triangleRoom + 256;
		shape->triangles = toolGrow( shape->triangles, (size_t)shape->triangleRoom, sizeof( toolTriangle ) );
	}
	shape->triangles[shape->triangleCount++] = ( toolTriangle ){ { a, b, c }, material };
}

void toolAddShapeQuad( toolShape* shape, const int32_t corners[4], int32_t material )
{
	toolAddShapeTriangle( shape, corners[0], corners[1], corners[2], material );
	toolAddShapeTriangle( shape, corners[0], corners[2], corners[3], material );
}

static float toolSignedPower( float x, float exponent )
{
	return x < 0.0f ? -powf( -x, exponent ) : powf( x, exponent );
}

static soleVec3 toolRingCentre( const toolLoft* loft, const toolRing* ring )
{
	soleVec3 centre = soleMulAdd( loft->start, ring->along, loft->along );
	return soleMulAdd( soleMulAdd( centre, ring->offU, loft->u ), ring->offV, loft->v );
}

static void toolAddRing( toolShape* shape, const toolLoft* loft, const toolRing* ring )
{
	soleVec3 centre = toolRingCentre( loft, ring );
	for ( int32_t i = 0; i < loft->sides; ++i )
	{
		float angle = (float)( 2.0 * TOOL_PI * ( (double)i + 0.5 ) / (double)loft->sides );
		float u = ring->radiusU * toolSignedPower( cosf( angle ), 2.0f / ring->square );
		float v = ring->radiusV * toolSignedPower( sinf( angle ), 2.0f / ring->square );
		soleVec3 position = soleMulAdd( soleMulAdd( centre, u, loft->u ), v, loft->v );
		toolAddShapeVertex( shape, position, ring->joint, ring->other, ring->share );
	}
}

/// A fan from a point a little beyond the ring, so that the end is round.
static void toolCloseEnd(
    toolShape* shape, const toolLoft* loft, const toolRing* ring, int32_t firstVertex, float bulge )
{
	soleVec3 tip = soleMulAdd( toolRingCentre( loft, ring ), bulge, loft->along );
	int32_t centre = toolAddShapeVertex( shape, tip, ring->joint, ring->other, ring->share );
	for ( int32_t i = 0; i < loft->sides; ++i )
	{
		int32_t a = firstVertex + i;
		int32_t b = firstVertex + ( i + 1 ) % loft->sides;
		toolAddShapeTriangle( shape, centre, bulge < 0.0f ? b : a, bulge < 0.0f ? a : b, ring->material );
	}
}

static void toolAddLoft( toolShape* shape, const toolLoft* loft, float startBulge, float endBulge )
{
	int32_t first = shape->vertexCount;
	int32_t sides = loft->sides;
	for ( int32_t ring = 0; ring < loft->ringCount; ++ring )
	{
		toolAddRing( shape, loft, loft->rings + ring );
	}
	for ( int32_t ring = 0; ring + 1 < loft->ringCount; ++ring )
	{
		for ( int32_t i = 0; i < sides; ++i )
		{
			int32_t low = first + ring * sides;
			int32_t next = ( i + 1 ) % sides;
			const int32_t corners[4] = { low + i, low + next, low + sides + next, low + sides + i };
			toolAddShapeQuad( shape, corners, loft->rings[ring].material );
		}
	}
	toolCloseEnd( shape, loft, loft->rings, first, -startBulge );
	const toolRing* last = loft->rings + loft->ringCount - 1;
	toolCloseEnd( shape, loft, last, first + ( loft->ringCount - 1 ) * sides, endBulge );
}

static soleVec3 toolDown( void )
{
	return soleVec( 0.0f, -1.0f, 0.0f );
}

static void toolAddTrunk( toolShape* shape )
{
	soleVec3 x = { 1.0f, 0.0f, 0.0f };
	soleVec3 z = { 0.0f, 0.0f, 1.0f };
	toolLoft torso = { { 0.0f, 1.525f, 0.0f }, toolDown(), x, z, 16, RINGS( s_torso ) };
	toolLoft neck = { { 0.0f, 1.590f, 0.0f }, toolDown(), x, z, 10, RINGS( s_neck ) };
	toolLoft head = { { 0.0f, 1.750f, 0.006f }, toolDown(), x, z, 14, RINGS( s_head ) };
	toolAddLoft( shape, &torso, 0.004f, 0.006f );
	toolAddLoft( shape, &neck, 0.004f, 0.004f );
	toolAddLoft( shape, &head, 0.0035f, 0.004f );
}

static void toolAddLimbs( toolShape* shape )
{
	float c = cosf( TOOL_ARM_DROP );
	float s = sinf( TOOL_ARM_DROP );
	soleVec3 x = { 1.0f, 0.0f, 0.0f };
	soleVec3 z = { 0.0f, 0.0f, 1.0f };
	soleVec3 along = { c, -s, 0.0f };
	soleVec3 outward = { s, c, 0.0f };
	soleVec3 shoulder = toolRestJoint( tool_jointUpperarm );
	toolLoft leg = { { 0.090f, 0.975f, 0.0f }, toolDown(), x, z, 12, RINGS( s_leg ) };
	toolLoft arm = { soleMulAdd( shoulder, -0.055f, along ), along, outward, z, 10, RINGS( s_arm ) };
	toolAddLoft( shape, &leg, 0.004f, 0.004f );
	toolAddLoft( shape, &arm, 0.010f, 0.006f );

	soleVec3 root = soleMulAdd( toolRestJoint( tool_jointHand ), 0.030f, along );
	root = soleMulAdd( soleMulAdd( root, 0.026f, z ), -0.006f, outward );
	soleVec3 thumbAlong = soleNormalizeOr( soleMulAdd( soleMulAdd( along, 0.62f, z ), -0.30f, outward ), along );
	soleVec3 thumbU = soleNormalizeOr( soleReject( outward, thumbAlong ), x );
	toolLoft thumb = { root, thumbAlong, thumbU, soleCross( thumbAlong, thumbU ), 6, RINGS( s_thumb ) };
	toolAddLoft( shape, &thumb, 0.004f, 0.006f );
}

/// Mirrors all triangles so far to the right side.
static void toolMirrorShape( toolShape* shape, int32_t firstVertex, int32_t firstTriangle )
{
	int32_t shift = shape->vertexCount - firstVertex;
	int32_t triangleCount = shape->triangleCount;
	for ( int32_t i = 0; i < shift; ++i )
	{
		toolVertex vertex = shape->vertices[firstVertex + i];
		vertex.position.x = -vertex.position.x;
		vertex.joint += vertex.joint >= tool_jointShoulder ? tool_jointsOfSide : 0;
		vertex.other += vertex.other >= tool_jointShoulder ? tool_jointsOfSide : 0;
		toolAddVertex( shape, vertex );
	}
	for ( int32_t i = firstTriangle; i < triangleCount; ++i )
	{
		toolTriangle t = shape->triangles[i];
		toolAddShapeTriangle( shape, t.corners[0] + shift, t.corners[2] + shift, t.corners[1] + shift, t.material );
	}
}

/// Sums of the faces' normals, each as large as its face.
static void toolMakeNormals( toolShape* shape )
{
	for ( int32_t i = 0; i < shape->triangleCount; ++i )
	{
		const int32_t* c = shape->triangles[i].corners;
		soleVec3 a = shape->vertices[c[0]].position;
		soleVec3 b = shape->vertices[c[1]].position;
		soleVec3 d = shape->vertices[c[2]].position;
		// Scaled up: faces of square millimetres are far from the smallest vector that can be normalised.
		soleVec3 n = soleScale( 1e4f, soleCross( soleSub( b, a ), soleSub( d, a ) ) );
		for ( int32_t k = 0; k < 3; ++k )
		{
			shape->vertices[c[k]].normal = soleAdd( shape->vertices[c[k]].normal, n );
		}
	}
	for ( int32_t i = 0; i < shape->vertexCount; ++i )
	{
		soleVec3 up = { 0.0f, 1.0f, 0.0f };
		shape->vertices[i].normal = soleNormalizeOr( shape->vertices[i].normal, up );
	}
}

static void toolWriteVertex( toolPrimitive* primitive, int32_t at, const toolVertex* vertex, const int32_t* skinJoints )
{
	memcpy( primitive->positions + 3 * at, &vertex->position, 3 * sizeof( float ) );
	memcpy( primitive->normals + 3 * at, &vertex->normal, 3 * sizeof( float ) );
	bool two = vertex->other != vertex->joint && vertex->share > 0.0f;
	primitive->joints[4 * at] = (uint16_t)skinJoints[vertex->joint];
	primitive->joints[4 * at + 1] = (uint16_t)( two ? skinJoints[vertex->other] : 0 );
	primitive->weights[4 * at] = two ? 1.0f - vertex->share : 1.0f;
	primitive->weights[4 * at + 1] = two ? vertex->share : 0.0f;
}

/// The triangles of one material with the vertices they use.
static toolPrimitive toolTakeMaterial( const toolShape* shape, int32_t material, const int32_t* skinJoints )
{
	toolPrimitive primitive = { .influences = 4, .material = material };
	size_t room = (size_t)shape->vertexCount;
	int32_t* renamed = toolAlloc( room, sizeof( int32_t ) );
	primitive.positions = toolAlloc( room * 3, sizeof( float ) );
	primitive.normals = toolAlloc( room * 3, sizeof( float ) );
	primitive.joints = toolAlloc( room * 4, sizeof( uint16_t ) );
	primitive.weights = toolAlloc( room * 4, sizeof( float ) );
	primitive.indices = toolAlloc( (size_t)shape->triangleCount * 3, sizeof( uint32_t ) );
	for ( int32_t i = 0; i < shape->triangleCount; ++i )
	{
		const toolTriangle* triangle = shape->triangles + i;
		for ( int32_t k = 0; k < 3 && triangle->material == material; ++k )
		{
			int32_t vertex = triangle->corners[k];
			if ( renamed[vertex] == 0 )
			{
				toolWriteVertex( &primitive, primitive.vertexCount, shape->vertices + vertex, skinJoints );
				renamed[vertex] = ++primitive.vertexCount;
			}
			primitive.indices[primitive.indexCount++] = (uint32_t)( renamed[vertex] - 1 );
		}
	}
	free( renamed );
	return primitive;
}

toolMesh toolMakeMannequinMesh( const int32_t* skinJoints )
{
	toolShape shape = { 0 };
	toolAddTrunk( &shape );
	int32_t firstVertex = shape.vertexCount;
	int32_t firstTriangle = shape.triangleCount;
	toolAddLimbs( &shape );
	toolAddFoot( &shape );
	toolMirrorShape( &shape, firstVertex, firstTriangle );
	toolMakeNormals( &shape );

	toolMesh mesh = { .name = toolCopyString( "mannequin" ), .primitiveCount = tool_materialCount };
	mesh.primitives = toolAlloc( tool_materialCount, sizeof( toolPrimitive ) );
	for ( int32_t i = 0; i < tool_materialCount; ++i )
	{
		mesh.primitives[i] = toolTakeMaterial( &shape, i, skinJoints );
	}
	free( shape.vertices );
	free( shape.triangles );
	return mesh;
}
