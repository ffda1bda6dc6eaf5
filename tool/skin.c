// SPDX-License-Identifier: MIT
// Linear blend skinning, the glTF way: a vertex goes where the weighted sum of jointWorld * inverseBind takes it, the
// mesh's own node does not count. World space. Not for speed: pictures and tests need a few poses.
#include "skin.h"

#include <stdlib.h>
#include <string.h>

/// Three rows of a matrix, the translation in the last column.
typedef struct toolAffine
{
	float m[3][4];
} toolAffine;

static toolAffine toolToAffine( soleTransform t )
{
	soleVec3 columns[4] = {
		soleRotate( t.rotation, soleVec( t.scale.x, 0.0f, 0.0f ) ),
		soleRotate( t.rotation, soleVec( 0.0f, t.scale.y, 0.0f ) ),
		soleRotate( t.rotation, soleVec( 0.0f, 0.0f, t.scale.z ) ),
		t.translation,
	};
	toolAffine affine;
	for ( int32_t i = 0; i < 4; ++i )
	{
		affine.m[0][i] = columns[i].x;
		affine.m[1][i] = columns[i].y;
		affine.m[2][i] = columns[i].z;
	}
	return affine;
}

/// parent * child, where the child is 16 floats column by column whose last row is 0, 0, 0, 1.
static toolAffine toolMulColumns( const toolAffine* parent, const float* child )
{
	toolAffine product;
	for ( int32_t row = 0; row < 3; ++row )
	{
		const float* p = parent->m[row];
		for ( int32_t column = 0; column < 4; ++column )
		{
			const float* c = child + 4 * column;
			product.m[row][column] = p[0] * c[0] + p[1] * c[1] + p[2] * c[2] + ( column == 3 ? p[3] : 0.0f );
		}
	}
	return product;
}

static soleVec3 toolAffinePoint( const toolAffine* affine, const float* p )
{
	float out[3];
	for ( int32_t row = 0; row < 3; ++row )
	{
		const float* m = affine->m[row];
		out[row] = ( m[0] * p[0] + m[1] * p[1] ) + ( m[2] * p[2] + m[3] );
	}
	return soleVec( out[0], out[1], out[2] );
}

void toolFreeTriangles( toolTriangles* triangles )
{
	free( triangles->positions );
	free( triangles->indices );
	free( triangles->colors );
	*triangles = ( toolTriangles ){ 0 };
}

void toolAddTriangles( toolTriangles* triangles, const float* positions, int32_t vertexCount, const uint32_t* indices,
    int32_t triangleCount, const float color[3] )
{
	size_t vertices = (size_t)triangles->vertexCount + (size_t)vertexCount;
	size_t faces = (size_t)triangles->triangleCount + (size_t)triangleCount;
	if ( vertexCount <= 0 || triangleCount <= 0 )
	{
		return;
	}
	triangles->positions = toolGrow( triangles->positions, vertices * 3, sizeof( float ) );
	triangles->indices = toolGrow( triangles->indices, faces * 3, sizeof( uint32_t ) );
	triangles->colors = toolGrow( triangles->colors, faces * 3, sizeof( float ) );
	memcpy( triangles->positions + 3 * (size_t)triangles->vertexCount, positions,
	    3 * (size_t)vertexCount * sizeof( float ) );
	for ( int32_t i = 0; i < 3 * triangleCount; ++i )
	{
		size_t at = 3 * (size_t)triangles->triangleCount + (size_t)i;
		triangles->indices[at] = (uint32_t)triangles->vertexCount + indices[i];
		triangles->colors[at] = color[i % 3];
	}
	triangles->vertexCount += vertexCount;
	triangles->triangleCount += triangleCount;
}

static soleTransform toolPosedWorld(
    const toolModel* model, const soleTransform* localPose, soleTransform root, int32_t node )
{
	soleTransform world = localPose[node];
	for ( int32_t parent = model->nodes[node].parent; parent != SOLE_NONE; parent = model->nodes[parent].parent )
	{
		world = soleMulTransform( localPose[parent], world );
	}
	return soleMulTransform( root, world );
}

/// Where the joints of a skin take the vertices of its meshes.
static toolAffine* toolMakePalette(
    const toolModel* model, const toolSkin* skin, const soleTransform* localPose, soleTransform root )
{
	toolAffine* palette = toolAlloc( (size_t)skin->jointCount, sizeof( toolAffine ) );
	for ( int32_t i = 0; i < skin->jointCount; ++i )
	{
		toolAffine world = toolToAffine( toolPosedWorld( model, localPose, root, skin->joints[i] ) );
		palette[i] = toolMulColumns( &world, skin->inverseBind + 16 * i );
	}
	return palette;
}

static soleVec3 toolSkinVertex( const toolPrimitive* primitive, int32_t vertex, const toolAffine* palette )
{
	soleVec3 sum = { 0.0f, 0.0f, 0.0f };
	for ( int32_t k = 0; k < primitive->influences; ++k )
	{
		int32_t at = vertex * primitive->influences + k;
		if ( primitive->weights[at] > 0.0f )
		{
			soleVec3 moved = toolAffinePoint( palette + primitive->joints[at], primitive->positions + 3 * vertex );
			sum = soleMulAdd( sum, primitive->weights[at], moved );
		}
	}
	return sum;
}

static void toolAddPrimitive( const toolModel* model, const toolPrimitive* primitive, const toolAffine* palette,
    const toolAffine* rigid, toolTriangles* triangles )
{
	static const float s_grey[3] = { 0.5f, 0.5f, 0.5f };
	float* positions = toolAlloc( 3 * (size_t)primitive->vertexCount, sizeof( float ) );
	for ( int32_t i = 0; i < primitive->vertexCount; ++i )
	{
		bool skinned = palette != NULL && primitive->influences > 0;
		soleVec3 p =
		    skinned ? toolSkinVertex( primitive, i, palette ) : toolAffinePoint( rigid, primitive->positions + 3 * i );
		memcpy( positions + 3 * i, &p, 3 * sizeof( float ) );
	}
	const float* color = primitive->material == SOLE_NONE ? s_grey : model->materials[primitive->material].color;
	toolAddTriangles(
	    triangles, positions, primitive->vertexCount, primitive->indices, primitive->indexCount / 3, color );
	free( positions );
}

void toolSkinModel(
    const toolModel* model, const soleTransform* localPose, soleTransform root, toolTriangles* triangles )
{
	for ( int32_t node = 0; node < model->nodeCount; ++node )
	{
		if ( model->nodes[node].mesh == SOLE_NONE )
		{
			continue;
		}
		const toolMesh* mesh = model->meshes + model->nodes[node].mesh;
		int32_t skin = model->nodes[node].skin;
		toolAffine rigid = toolToAffine( toolPosedWorld( model, localPose, root, node ) );
		toolAffine* palette = skin == SOLE_NONE ? NULL : toolMakePalette( model, model->skins + skin, localPose, root );
		for ( int32_t i = 0; i < mesh->primitiveCount; ++i )
		{
			toolAddPrimitive( model, mesh->primitives + i, palette, &rigid, triangles );
		}
		free( palette );
	}
}
