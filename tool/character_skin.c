// SPDX-License-Identifier: MIT
// The bind pose of a model's skins and their vertices in it, character space.
//
// An inverse bind matrix I takes a vertex from the space of the mesh to that of its joint. The joint's place in the
// bind pose is then P I^-1, where P, the same for all joints of a skin, takes the mesh's space to the scene. glTF has
// no P. Where the rest pose is the bind pose, rest * I is P for each joint. Else it is the place of the mesh's node, as
// most exporters have it, where that has the size of rest * I of the topmost joint; else it is the latter.
#include "character_internal.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SAME_POSE 1e-3 // of the character's size: rest poses closer than this to the bind pose are it

/// Column by column, as in glTF.
typedef struct toolMatrix
{
	double m[16];
} toolMatrix;

static toolMatrix toolMatrixOf( soleTransform t )
{
	double x = (double)t.rotation.x;
	double y = (double)t.rotation.y;
	double z = (double)t.rotation.z;
	double w = (double)t.rotation.w;
	double sx = (double)t.scale.x;
	double sy = (double)t.scale.y;
	double sz = (double)t.scale.z;
	toolMatrix r = { {
		sx * ( 1 - 2 * ( y * y + z * z ) ),
		sx * 2 * ( x * y + w * z ),
		sx * 2 * ( x * z - w * y ),
		0,
		sy * 2 * ( x * y - w * z ),
		sy * ( 1 - 2 * ( x * x + z * z ) ),
		sy * 2 * ( y * z + w * x ),
		0,
		sz * 2 * ( x * z + w * y ),
		sz * 2 * ( y * z - w * x ),
		sz * ( 1 - 2 * ( x * x + y * y ) ),
		0,
		(double)t.translation.x,
		(double)t.translation.y,
		(double)t.translation.z,
		1,
	} };
	return r;
}

static toolMatrix toolMulMatrix( const toolMatrix* a, const toolMatrix* b )
{
	toolMatrix r = { { 0 } };
	for ( int32_t c = 0; c < 4; ++c )
	{
		for ( int32_t i = 0; i < 4; ++i )
		{
			for ( int32_t k = 0; k < 4; ++k )
			{
				r.m[4 * c + i] += a->m[4 * k + i] * b->m[4 * c + k];
			}
		}
	}
	return r;
}

static soleVec3 toolMatrixPoint( const toolMatrix* a, soleVec3 p )
{
	double v[3];
	for ( int32_t i = 0; i < 3; ++i )
	{
		v[i] = a->m[i] * (double)p.x + a->m[4 + i] * (double)p.y + a->m[8 + i] * (double)p.z + a->m[12 + i];
	}
	return soleVec( (float)v[0], (float)v[1], (float)v[2] );
}

static double toolDeterminant( const toolMatrix* a )
{
	const double* m = a->m;
	return m[0] * ( m[5] * m[10] - m[6] * m[9] ) - m[4] * ( m[1] * m[10] - m[2] * m[9] ) +
	    m[8] * ( m[1] * m[6] - m[2] * m[5] );
}

/// Inverse of an affine matrix. False where it has none.
static bool toolInvertMatrix( const toolMatrix* a, toolMatrix* inverse )
{
	const double* m = a->m;
	double d = toolDeterminant( a );
	if ( isfinite( d ) == 0 || fabs( d ) < 1e-30 )
	{
		return false;
	}
	toolMatrix r = { { 0 } };
	for ( int32_t c = 0; c < 3; ++c )
	{
		for ( int32_t i = 0; i < 3; ++i )
		{
			int32_t p = ( c + 1 ) % 3;
			int32_t q = ( c + 2 ) % 3;
			int32_t u = ( i + 1 ) % 3;
			int32_t v = ( i + 2 ) % 3;
			r.m[4 * c + i] = ( m[4 * u + p] * m[4 * v + q] - m[4 * v + p] * m[4 * u + q] ) / d;
		}
	}
	for ( int32_t i = 0; i < 3; ++i )
	{
		r.m[12 + i] = -( r.m[i] * m[12] + r.m[4 + i] * m[13] + r.m[8 + i] * m[14] );
	}
	r.m[15] = 1;
	*inverse = r;
	return true;
}

/// Scale, rotation and place of a matrix without shear; shear is dropped.
static soleTransform toolTakeApart( const toolMatrix* a )
{
	double column[3][3];
	double scale[3];
	for ( int32_t c = 0; c < 3; ++c )
	{
		const double* m = a->m + 4 * c;
		scale[c] = sqrt( m[0] * m[0] + m[1] * m[1] + m[2] * m[2] );
		for ( int32_t i = 0; i < 3; ++i )
		{
			column[c][i] = scale[c] > 0 ? m[i] / scale[c] : ( i == c ? 1.0 : 0.0 );
		}
	}
	if ( toolDeterminant( a ) < 0 )
	{
		scale[0] = -scale[0];
		for ( int32_t i = 0; i < 3; ++i )
		{
			column[0][i] = -column[0][i];
		}
	}
	// The largest of the four squares first: no division by something small.
	double trace[4] = { column[0][0] - column[1][1] - column[2][2], column[1][1] - column[0][0] - column[2][2],
		column[2][2] - column[0][0] - column[1][1], column[0][0] + column[1][1] + column[2][2] };
	int32_t best = 3;
	for ( int32_t i = 0; i < 3; ++i )
	{
		best = trace[i] > trace[best] ? i : best;
	}
	double q[4];
	double root = sqrt( fmax( 1.0 + trace[best], 1e-12 ) );
	q[best] = 0.5 * root;
	double s = 0.5 / root;
	if ( best == 3 )
	{
		q[0] = s * ( column[1][2] - column[2][1] );
		q[1] = s * ( column[2][0] - column[0][2] );
		q[2] = s * ( column[0][1] - column[1][0] );
	}
	else
	{
		int32_t j = ( best + 1 ) % 3;
		int32_t k = ( best + 2 ) % 3;
		q[j] = s * ( column[best][j] + column[j][best] );
		q[k] = s * ( column[best][k] + column[k][best] );
		q[3] = s * ( column[j][k] - column[k][j] );
	}
	soleTransform t = {
		{ (float)a->m[12], (float)a->m[13], (float)a->m[14] },
		{ (float)q[0], (float)q[1], (float)q[2], (float)q[3] },
		{ (float)scale[0], (float)scale[1], (float)scale[2] },
	};
	t.rotation = soleNormalizeQuat( t.rotation );
	return t;
}

static toolMatrix toolInverseBind( const toolSkin* skin, int32_t index )
{
	toolMatrix r;
	for ( int32_t i = 0; i < 16; ++i )
	{
		r.m[i] = (double)skin->inverseBind[16 * (size_t)index + (size_t)i];
	}
	return r;
}

// -------------------------------------------------------------------------------------------------------- bind pose

/// Parents before children. Parents form no cycle: the reader saw to that.
static int32_t* toolOrderNodes( const toolCharacter* character )
{
	int32_t count = character->jointCount;
	int32_t* order = toolAlloc( (size_t)count, sizeof( int32_t ) );
	int32_t* stack = toolAlloc( (size_t)count, sizeof( int32_t ) );
	bool* done = toolAlloc( (size_t)count, sizeof( bool ) );
	int32_t used = 0;
	for ( int32_t i = 0; i < count; ++i )
	{
		int32_t depth = 0;
		for ( int32_t j = i; j != SOLE_NONE && done[j] == false; j = character->parents[j] )
		{
			stack[depth++] = j;
			done[j] = true;
		}
		while ( depth > 0 )
		{
			order[used++] = stack[--depth];
		}
	}
	free( stack );
	free( done );
	return order;
}

/// Worlds of the pose that character->bindPose holds at the moment.
static soleTransform* toolBindWorlds( const toolCharacter* character, const int32_t* order )
{
	soleTransform* world = toolAlloc( (size_t)character->jointCount, sizeof( soleTransform ) );
	for ( int32_t k = 0; k < character->jointCount; ++k )
	{
		int32_t i = order[k];
		int32_t parent = character->parents[i];
		world[i] =
		    parent == SOLE_NONE ? character->bindPose[i] : soleMulTransform( world[parent], character->bindPose[i] );
	}
	return world;
}

/// rest * I of the skin's topmost joint, and whether it is that of all joints.
static bool toolFindPlacement(
    const soleTransform* rest, const int32_t* depth, const toolSkin* skin, toolMatrix* placement )
{
	int32_t top = 0;
	for ( int32_t i = 1; i < skin->jointCount; ++i )
	{
		top = depth[skin->joints[i]] < depth[skin->joints[top]] ? i : top;
	}
	double size = 0;
	for ( int32_t i = 0; i < skin->jointCount; ++i )
	{
		soleVec3 root = rest[skin->joints[top]].translation;
		size = fmax( size, (double)soleDistance( rest[skin->joints[i]].translation, root ) );
	}
	toolMatrix world = toolMatrixOf( rest[skin->joints[top]] );
	toolMatrix inverseBind = toolInverseBind( skin, top );
	*placement = toolMulMatrix( &world, &inverseBind );
	double worst = 0;
	for ( int32_t i = 0; i < skin->jointCount; ++i )
	{
		soleTransform joint = rest[skin->joints[i]];
		inverseBind = toolInverseBind( skin, i );
		toolMatrix inverse;
		if ( toolInvertMatrix( &inverseBind, &inverse ) == false )
		{
			continue;
		}
		toolMatrix bind = toolMulMatrix( placement, &inverse );
		soleTransform t = toolTakeApart( &bind );
		worst = fmax( worst, (double)soleDistance( t.translation, joint.translation ) );
		// A turn counts as what it does to something a tenth of the size away: sine of half the angle, doubled.
		double cosine = fabs( (double)soleDotQuat( t.rotation, soleNormalizeQuat( joint.rotation ) ) );
		worst = fmax( worst, 0.2 * size * sqrt( fmax( 0.0, 1.0 - cosine * cosine ) ) );
	}
	return worst <= SAME_POSE * size;
}

/// The place of a node that shows the skin's mesh, where it is believable as the space of that mesh.
static void toolPreferMeshNode( const toolModel* model, const soleTransform* rest, int32_t skin, toolMatrix* placement )
{
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		if ( model->nodes[i].skin != skin || model->nodes[i].mesh == SOLE_NONE )
		{
			continue;
		}
		toolMatrix mesh = toolMatrixOf( rest[i] );
		double ratio = toolDeterminant( &mesh ) / toolDeterminant( placement );
		if ( ratio > 0.8 && ratio < 1.25 )
		{
			*placement = mesh;
		}
		return;
	}
}

/// Places of joints in their bind pose; those without a skin keep their place against their parent.
static void toolBindSkins( toolCharacter* character, const int32_t* order )
{
	const toolModel* model = character->model;
	size_t count = (size_t)character->jointCount;
	soleTransform* rest = toolBindWorlds( character, order );
	soleTransform* world = toolAlloc( count, sizeof( soleTransform ) );
	bool* bound = toolAlloc( count, sizeof( bool ) );
	int32_t* depth = toolAlloc( count, sizeof( int32_t ) );
	for ( size_t k = 0; k < count; ++k )
	{
		int32_t parent = character->parents[order[k]];
		depth[order[k]] = parent == SOLE_NONE ? 0 : depth[parent] + 1;
	}
	for ( int32_t s = 0; s < model->skinCount; ++s )
	{
		const toolSkin* skin = model->skins + s;
		toolMatrix placement;
		if ( skin->jointCount < 1 || toolFindPlacement( rest, depth, skin, &placement ) )
		{
			continue; // the rest pose is the bind pose and more exact
		}
		toolPreferMeshNode( model, rest, s, &placement );
		for ( int32_t i = 0; i < skin->jointCount; ++i )
		{
			int32_t joint = skin->joints[i];
			toolMatrix inverseBind = toolInverseBind( skin, i );
			toolMatrix inverse;
			if ( bound[joint] == false && toolInvertMatrix( &inverseBind, &inverse ) )
			{
				toolMatrix bind = toolMulMatrix( &placement, &inverse );
				world[joint] = toolTakeApart( &bind );
				bound[joint] = true;
			}
		}
	}
	for ( size_t k = 0; k < count; ++k )
	{
		int32_t i = order[k];
		int32_t parent = character->parents[i];
		soleTransform above = parent == SOLE_NONE ? soleTransform_Identity() : world[parent];
		if ( bound[i] )
		{
			soleTransform local = soleTransform_Identity();
			local.translation = soleInvTransformPoint( above, world[i].translation );
			local.rotation = soleNormalizeQuat( soleMulQuat( soleConjugate( above.rotation ), world[i].rotation ) );
			local.scale.x = above.scale.x != 0.0f ? world[i].scale.x / above.scale.x : 1.0f;
			local.scale.y = above.scale.y != 0.0f ? world[i].scale.y / above.scale.y : 1.0f;
			local.scale.z = above.scale.z != 0.0f ? world[i].scale.z / above.scale.z : 1.0f;
			character->bindPose[i] = local;
		}
		world[i] = soleMulTransform( above, character->bindPose[i] );
	}
	free( rest );
	free( world );
	free( bound );
	free( depth );
}

void toolFindBindPose( toolCharacter* character )
{
	character->bindPose = toolAlloc( (size_t)character->jointCount, sizeof( soleTransform ) );
	toolGetRestPose( character, character->bindPose );
	int32_t* order = toolOrderNodes( character );
	toolBindSkins( character, order );
	free( order );
}

// --------------------------------------------------------------------------------------------------------- vertices

/// The four heaviest of a vertex's influences, and where it is in the bind pose.
static soleSkinVertex toolSkinVertexOf(
    const toolPrimitive* primitive, int32_t vertex, const toolSkin* skin, const toolMatrix* matrices )
{
	soleSkinVertex out = { .joints = { SOLE_NONE, SOLE_NONE, SOLE_NONE, SOLE_NONE } };
	const float* p = primitive->positions + 3 * (size_t)vertex;
	soleVec3 at = soleVec( p[0], p[1], p[2] );
	size_t first = (size_t)primitive->influences * (size_t)vertex;
	float sum = 0.0f;
	for ( int32_t i = 0; i < primitive->influences; ++i )
	{
		float weight = primitive->weights[first + (size_t)i];
		int32_t joint = (int32_t)primitive->joints[first + (size_t)i];
		if ( !( weight > 0.0f ) || joint >= skin->jointCount )
		{
			continue;
		}
		out.position = soleMulAdd( out.position, weight, toolMatrixPoint( matrices + joint, at ) );
		sum += weight;
		int32_t slot = 3;
		if ( weight <= out.weights[slot] )
		{
			continue;
		}
		while ( slot > 0 && out.weights[slot - 1] < weight )
		{
			out.weights[slot] = out.weights[slot - 1];
			out.joints[slot] = out.joints[slot - 1];
			slot -= 1;
		}
		out.weights[slot] = weight;
		out.joints[slot] = skin->joints[joint];
	}
	if ( sum > 0.0f )
	{
		out.position = soleScale( 1.0f / sum, out.position );
	}
	return out;
}

static void toolAddSkinned( toolCharacter* character, const soleTransform* world, int32_t node )
{
	const toolSkin* skin = character->model->skins + character->model->nodes[node].skin;
	const toolMesh* mesh = character->model->meshes + character->model->nodes[node].mesh;
	toolMatrix* matrices = toolAlloc( (size_t)skin->jointCount, sizeof( toolMatrix ) );
	for ( int32_t i = 0; i < skin->jointCount; ++i )
	{
		toolMatrix joint = toolMatrixOf( world[skin->joints[i]] );
		toolMatrix inverseBind = toolInverseBind( skin, i );
		matrices[i] = toolMulMatrix( &joint, &inverseBind );
	}
	for ( int32_t k = 0; k < mesh->primitiveCount; ++k )
	{
		const toolPrimitive* primitive = mesh->primitives + k;
		for ( int32_t v = 0; v < primitive->vertexCount && primitive->influences > 0; ++v )
		{
			character->skin[character->skinCount++] = toolSkinVertexOf( primitive, v, skin, matrices );
		}
	}
	free( matrices );
}

/// A mesh that hangs from a joint without being skinned: a part of a robot.
static void toolAddRigid( toolCharacter* character, const soleTransform* world, int32_t node )
{
	const toolMesh* mesh = character->model->meshes + character->model->nodes[node].mesh;
	for ( int32_t k = 0; k < mesh->primitiveCount; ++k )
	{
		const toolPrimitive* primitive = mesh->primitives + k;
		for ( int32_t v = 0; v < primitive->vertexCount; ++v )
		{
			const float* p = primitive->positions + 3 * (size_t)v;
			soleSkinVertex* out = character->skin + character->skinCount++;
			*out = ( soleSkinVertex ){ .joints = { node, SOLE_NONE, SOLE_NONE, SOLE_NONE }, .weights = { 1.0f } };
			out->position = soleTransformPoint( world[node], soleVec( p[0], p[1], p[2] ) );
		}
	}
}

/// Rigid meshes belong to the character where they hang below a joint of a skin, or where there are no skins.
static bool toolIsCarried( const toolCharacter* character, const bool* isJoint, int32_t node )
{
	if ( character->model->skinCount == 0 )
	{
		return character->parents[node] != SOLE_NONE;
	}
	for ( int32_t i = node; i != SOLE_NONE; i = character->parents[i] )
	{
		if ( isJoint[i] )
		{
			return true;
		}
	}
	return false;
}

void toolCollectSkin( toolCharacter* character )
{
	const toolModel* model = character->model;
	size_t total = 0;
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		const toolMesh* mesh = model->nodes[i].mesh != SOLE_NONE ? model->meshes + model->nodes[i].mesh : NULL;
		for ( int32_t k = 0; mesh != NULL && k < mesh->primitiveCount; ++k )
		{
			total += (size_t)mesh->primitives[k].vertexCount;
		}
	}
	// One mesh may be shown by many nodes: a small file must not ask for memory without end.
	if ( total == 0 || total > 50000000 )
	{
		return;
	}
	bool* isJoint = toolAlloc( (size_t)model->nodeCount, sizeof( bool ) );
	for ( int32_t s = 0; s < model->skinCount; ++s )
	{
		for ( int32_t i = 0; i < model->skins[s].jointCount; ++i )
		{
			isJoint[model->skins[s].joints[i]] = true;
		}
	}
	character->skin = toolAlloc( total, sizeof( soleSkinVertex ) );
	int32_t* order = toolOrderNodes( character );
	soleTransform* world = toolBindWorlds( character, order );
	for ( int32_t i = 0; i < model->nodeCount; ++i )
	{
		if ( model->nodes[i].mesh != SOLE_NONE && model->nodes[i].skin != SOLE_NONE )
		{
			toolAddSkinned( character, world, i );
		}
		else if ( model->nodes[i].mesh != SOLE_NONE && toolIsCarried( character, isJoint, i ) )
		{
			toolAddRigid( character, world, i );
		}
	}
	free( world );
	free( order );
	free( isJoint );
	if ( character->skinCount == 0 )
	{
		free( character->skin );
		character->skin = NULL;
	}
}
