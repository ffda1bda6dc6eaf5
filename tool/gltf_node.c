// SPDX-License-Identifier: MIT
// Nodes of a glTF file: where they are, that they form a tree, and which of them the default scene shows.
#include "gltf_internal.h"

#include <json.h>
#include <math.h>
#include <stdlib.h>

/// Takes a matrix apart into translation, rotation and scale. Shear, which these cannot hold, is lost.
static soleTransform toolTakeApart( const float* m )
{
	double axis[3][3];
	float scale[3];
	for ( int i = 0; i < 3; ++i )
	{
		double x = (double)m[4 * i];
		double y = (double)m[4 * i + 1];
		double z = (double)m[4 * i + 2];
		double length = sqrt( x * x + y * y + z * z );
		scale[i] = (float)length;
		for ( int j = 0; j < 3; ++j )
		{
			axis[i][j] = length > 0.0 ? (double)m[4 * i + j] / length : ( i == j ? 1.0 : 0.0 );
		}
	}
	double determinant = axis[0][0] * ( axis[1][1] * axis[2][2] - axis[1][2] * axis[2][1] ) -
	    axis[0][1] * ( axis[1][0] * axis[2][2] - axis[1][2] * axis[2][0] ) +
	    axis[0][2] * ( axis[1][0] * axis[2][1] - axis[1][1] * axis[2][0] );
	if ( determinant < 0.0 )
	{
		scale[0] = -scale[0];
		for ( int j = 0; j < 3; ++j )
		{
			axis[0][j] = -axis[0][j];
		}
	}
	// the largest of the four squares, so that the division is safe
	double trace = axis[0][0] + axis[1][1] + axis[2][2];
	double q[4] = { 0.0, 0.0, 0.0, 1.0 };
	int largest = axis[0][0] > axis[1][1] ? ( axis[0][0] > axis[2][2] ? 0 : 2 ) : ( axis[1][1] > axis[2][2] ? 1 : 2 );
	if ( trace > axis[largest][largest] )
	{
		double s = 2.0 * sqrt( 1.0 + trace );
		q[3] = 0.25 * s;
		q[0] = ( axis[1][2] - axis[2][1] ) / s;
		q[1] = ( axis[2][0] - axis[0][2] ) / s;
		q[2] = ( axis[0][1] - axis[1][0] ) / s;
	}
	else
	{
		int i = largest;
		int j = ( i + 1 ) % 3;
		int k = ( i + 2 ) % 3;
		double square = 1.0 + axis[i][i] - axis[j][j] - axis[k][k];
		double s = 2.0 * sqrt( square > 1e-12 ? square : 1e-12 );
		q[i] = 0.25 * s;
		q[j] = ( axis[i][j] + axis[j][i] ) / s;
		q[k] = ( axis[i][k] + axis[k][i] ) / s;
		q[3] = ( axis[j][k] - axis[k][j] ) / s;
	}
	soleTransform t = { { m[12], m[13], m[14] }, { (float)q[0], (float)q[1], (float)q[2], (float)q[3] },
		{ scale[0], scale[1], scale[2] } };
	t.rotation = soleNormalizeQuat( t.rotation );
	return t;
}

/// Column by column.
static void toolMakeMatrix( soleTransform t, float* m )
{
	soleVec3 columns[3] = { soleRotate( t.rotation, soleVec( t.scale.x, 0.0f, 0.0f ) ),
		soleRotate( t.rotation, soleVec( 0.0f, t.scale.y, 0.0f ) ),
		soleRotate( t.rotation, soleVec( 0.0f, 0.0f, t.scale.z ) ) };
	for ( int i = 0; i < 3; ++i )
	{
		m[4 * i] = columns[i].x;
		m[4 * i + 1] = columns[i].y;
		m[4 * i + 2] = columns[i].z;
		m[4 * i + 3] = 0.0f;
	}
	m[12] = t.translation.x;
	m[13] = t.translation.y;
	m[14] = t.translation.z;
	m[15] = 1.0f;
}

static bool toolReadPlacement(
    toolGltfReader* reader, json_object* object, const char* owner, toolNode* node, float* matrix )
{
	float translation[3] = { 0.0f, 0.0f, 0.0f };
	float rotation[4] = { 0.0f, 0.0f, 0.0f, 1.0f };
	float scale[3] = { 1.0f, 1.0f, 1.0f };
	if ( toolGetFloats( reader, object, owner, "matrix", 16, matrix, &node->hasMatrix ) == false ||
	    toolGetFloats( reader, object, owner, "translation", 3, translation, NULL ) == false ||
	    toolGetFloats( reader, object, owner, "rotation", 4, rotation, NULL ) == false ||
	    toolGetFloats( reader, object, owner, "scale", 3, scale, NULL ) == false )
	{
		return false;
	}
	if ( node->hasMatrix )
	{
		node->local = toolTakeApart( matrix );
		return soleVec3_IsFinite( node->local.scale ) ||
		    toolFailFile( reader->error, reader->path, "%s has a matrix too large: export it again", owner );
	}
	node->local.translation = soleVec( translation[0], translation[1], translation[2] );
	node->local.scale = soleVec( scale[0], scale[1], scale[2] );
	soleQuat q = { rotation[0], rotation[1], rotation[2], rotation[3] };
	float off = soleDotQuat( q, q ) - 1.0f;
	// what is a rotation but for rounding stays bit by bit
	node->local.rotation = off > -1e-4f && off < 1e-4f ? q : soleNormalizeQuat( q );
	toolMakeMatrix( node->local, matrix );
	return true;
}

static bool toolReadChildren( toolGltfReader* reader, json_object* object, const char* owner, int32_t parent )
{
	toolModel* model = &reader->gltf->model;
	json_object* children = NULL;
	int32_t childCount = 0;
	char prefix[128];
	snprintf( prefix, sizeof prefix, "%s.", owner );
	if ( toolGetList( reader, object, prefix, "children", &children, &childCount ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < childCount; ++i )
	{
		json_object* item = json_object_array_get_idx( children, (size_t)i );
		int64_t child = json_object_is_type( item, json_type_int ) ? json_object_get_int64( item ) : -1;
		if ( child < 0 || child >= model->nodeCount )
		{
			return toolFailFile(
			    reader->error, reader->path, "%s has a child that is no node: export it again", owner );
		}
		if ( model->nodes[child].parent != SOLE_NONE || child == parent )
		{
			return toolFailFile( reader->error, reader->path,
			    "nodes[%d] has two parents or is its own: nodes must form a tree, export it again", (int)child );
		}
		model->nodes[child].parent = parent;
	}
	return true;
}

/// With one parent at most for each, what is no tree is a ring.
static bool toolCheckTree( toolGltfReader* reader )
{
	const toolModel* model = &reader->gltf->model;
	int32_t* visit = toolAlloc( (size_t)model->nodeCount, sizeof( int32_t ) ); // 1 + the node that came by first
	int32_t ring = SOLE_NONE;
	for ( int32_t i = 0; i < model->nodeCount && ring == SOLE_NONE; ++i )
	{
		int32_t node = i;
		while ( node != SOLE_NONE && visit[node] == 0 )
		{
			visit[node] = i + 1;
			node = model->nodes[node].parent;
		}
		ring = node != SOLE_NONE && visit[node] == i + 1 ? node : SOLE_NONE;
	}
	free( visit );
	return ring == SOLE_NONE ||
	    toolFailFile( reader->error, reader->path,
	        "nodes[%d] is among its own parents: nodes must form a tree, export it again", ring );
}

bool toolReadNodes( toolGltfReader* reader )
{
	toolGltf* gltf = reader->gltf;
	toolModel* model = &gltf->model;
	json_object* list = NULL;
	int32_t count = 0;
	if ( toolGetList( reader, reader->root, "", "nodes", &list, &count ) == false )
	{
		return false;
	}
	model->nodes = toolAlloc( (size_t)count, sizeof( toolNode ) );
	gltf->matrices = toolAlloc( (size_t)count * 16, sizeof( float ) );
	gltf->inScene = toolAlloc( (size_t)count, sizeof( bool ) );
	for ( int32_t i = 0; i < count; ++i )
	{
		model->nodes[i].parent = SOLE_NONE;
	}
	model->nodeCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* object = json_object_array_get_idx( list, (size_t)i );
		toolNode* node = model->nodes + i;
		node->name = toolCopyString( toolGetText( object, "name" ) );
		toolOwner owner = toolNameOwner( "nodes", (size_t)i, node->name );
		if ( toolReadPlacement( reader, object, owner.text, node, gltf->matrices + 16 * (size_t)i ) == false ||
		    toolGetIndex( reader, object, owner.text, "mesh", model->meshCount, &node->mesh ) == false ||
		    toolGetIndex( reader, object, owner.text, "skin", model->skinCount, &node->skin ) == false ||
		    toolReadChildren( reader, object, owner.text, i ) == false )
		{
			return false;
		}
	}
	return toolCheckTree( reader );
}

bool toolReadScene( toolGltfReader* reader )
{
	toolGltf* gltf = reader->gltf;
	json_object* scenes = NULL;
	int32_t sceneCount = 0;
	if ( toolGetList( reader, reader->root, "", "scenes", &scenes, &sceneCount ) == false ||
	    toolGetIndex( reader, reader->root, "the file", "scene", sceneCount, &gltf->scene ) == false )
	{
		return false;
	}
	gltf->scene = gltf->scene == SOLE_NONE && sceneCount > 0 ? 0 : gltf->scene;
	bool all = gltf->scene == SOLE_NONE;
	json_object* nodes = NULL;
	int32_t count = 0;
	if ( all == false &&
	    toolGetList( reader, json_object_array_get_idx( scenes, (size_t)gltf->scene ), "scenes.", "nodes", &nodes,
	        &count ) == false )
	{
		return false;
	}
	// 1: not shown, 2: shown
	uint8_t* state = toolAlloc( (size_t)gltf->model.nodeCount, 1 );
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* item = json_object_array_get_idx( nodes, (size_t)i );
		int64_t node = json_object_is_type( item, json_type_int ) ? json_object_get_int64( item ) : -1;
		if ( node < 0 || node >= gltf->model.nodeCount )
		{
			free( state );
			return toolFailFile(
			    reader->error, reader->path, "scenes[%d] shows a node that is none: export it again", gltf->scene );
		}
		state[node] = 2;
	}
	for ( int32_t i = 0; i < gltf->model.nodeCount; ++i )
	{
		int32_t top = i;
		while ( state[top] == 0 && gltf->model.nodes[top].parent != SOLE_NONE )
		{
			top = gltf->model.nodes[top].parent;
		}
		uint8_t found = state[top] == 2 ? 2 : 1;
		for ( int32_t node = i; node != SOLE_NONE && state[node] == 0; node = gltf->model.nodes[node].parent )
		{
			state[node] = found;
		}
		gltf->inScene[i] = all || state[i] == 2;
	}
	free( state );
	return true;
}
