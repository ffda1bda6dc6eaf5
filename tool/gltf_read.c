// SPDX-License-Identifier: MIT
// Opens a glTF file and reads it into a model; itself its skins, materials and named bones.
#include "gltf_internal.h"

#include <json.h>
#include <stdlib.h>
#include <string.h>

static bool toolReadJoints(
    toolGltfReader* reader, json_object* object, const char* owner, int32_t nodeCount, toolSkin* skin )
{
	json_object* joints = NULL;
	int32_t count = 0;
	char prefix[128];
	snprintf( prefix, sizeof prefix, "%s.", owner );
	if ( toolGetList( reader, object, prefix, "joints", &joints, &count ) == false )
	{
		return false;
	}
	if ( count == 0 )
	{
		return toolFailFile( reader->error, reader->path, "%s has no joints: export it again", owner );
	}
	skin->joints = toolAlloc( (size_t)count, sizeof( int32_t ) );
	skin->jointCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* item = json_object_array_get_idx( joints, (size_t)i );
		int64_t joint = json_object_is_type( item, json_type_int ) ? json_object_get_int64( item ) : -1;
		if ( joint < 0 || joint >= nodeCount )
		{
			return toolFailFile(
			    reader->error, reader->path, "%s has a joint that is no node: export it again", owner );
		}
		skin->joints[i] = (int32_t)joint;
	}
	return true;
}

static bool toolReadInverseBind(
    toolGltfReader* reader, json_object* object, const char* owner, int32_t accessorCount, toolSkin* skin )
{
	int32_t accessor = SOLE_NONE;
	int32_t count = 0;
	if ( toolGetIndex( reader, object, owner, "inverseBindMatrices", accessorCount, &accessor ) == false )
	{
		return false;
	}
	if ( accessor == SOLE_NONE )
	{
		if ( toolSpend( reader, owner, (size_t)skin->jointCount * 16, sizeof( float ) ) == false )
		{
			return false;
		}
		skin->inverseBind = toolAlloc( (size_t)skin->jointCount * 16, sizeof( float ) );
		for ( int32_t i = 0; i < skin->jointCount; ++i )
		{
			for ( int j = 0; j < 4; ++j )
			{
				skin->inverseBind[16 * (size_t)i + 5 * (size_t)j] = 1.0f;
			}
		}
		return true;
	}
	if ( toolReadFloats( reader, accessor, owner, tool_useMat4, false, &skin->inverseBind, &count ) == false )
	{
		return false;
	}
	if ( count < skin->jointCount )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has fewer inverse bind matrices than joints: export it again", owner );
	}
	if ( toolFindNotFinite( skin->inverseBind, (size_t)skin->jointCount * 16 ) >= 0 )
	{
		return toolFailFile(
		    reader->error, reader->path, "%s has an inverse bind matrix that is not finite: export it again", owner );
	}
	return true;
}

static bool toolReadSkins( toolGltfReader* reader )
{
	toolModel* model = &reader->gltf->model;
	json_object* list = NULL;
	json_object* other = NULL;
	int32_t count = 0;
	int32_t nodeCount = 0;
	int32_t accessorCount = 0;
	if ( toolGetList( reader, reader->root, "", "skins", &list, &count ) == false ||
	    toolGetList( reader, reader->root, "", "nodes", &other, &nodeCount ) == false ||
	    toolGetList( reader, reader->root, "", "accessors", &other, &accessorCount ) == false )
	{
		return false;
	}
	model->skins = toolAlloc( (size_t)count, sizeof( toolSkin ) );
	model->skinCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		toolSkin* skin = model->skins + i;
		json_object* object = json_object_array_get_idx( list, (size_t)i );
		skin->name = toolCopyString( toolGetText( object, "name" ) );
		toolOwner owner = toolNameOwner( "skins", (size_t)i, skin->name );
		if ( toolReadJoints( reader, object, owner.text, nodeCount, skin ) == false ||
		    toolReadInverseBind( reader, object, owner.text, accessorCount, skin ) == false )
		{
			return false;
		}
	}
	return true;
}

static bool toolReadMaterials( toolGltfReader* reader )
{
	toolModel* model = &reader->gltf->model;
	json_object* list = NULL;
	int32_t count = 0;
	if ( toolGetList( reader, reader->root, "", "materials", &list, &count ) == false )
	{
		return false;
	}
	model->materials = toolAlloc( (size_t)count, sizeof( toolMaterial ) );
	model->materialCount = count;
	for ( int32_t i = 0; i < count; ++i )
	{
		toolMaterial* material = model->materials + i;
		json_object* object = json_object_array_get_idx( list, (size_t)i );
		*material = ( toolMaterial ){ .color = { 1.0f, 1.0f, 1.0f, 1.0f }, .roughness = 1.0f };
		material->name = toolCopyString( toolGetText( object, "name" ) );
		material->doubleSided = toolGetFlag( object, "doubleSided" );
		toolOwner owner = toolNameOwner( "materials", (size_t)i, material->name );
		json_object* metal = toolGetMember( object, "pbrMetallicRoughness" );
		if ( toolGetFloats( reader, metal, owner.text, "baseColorFactor", 4, material->color, NULL ) == false ||
		    toolGetFloats( reader, metal, owner.text, "roughnessFactor", 1, &material->roughness, NULL ) == false )
		{
			return false;
		}
	}
	return true;
}

static void toolAddBone( toolModel* model, const char* name, json_object* object )
{
	json_object* item = toolGetMember( object, "node" );
	int64_t node = json_object_is_type( item, json_type_int ) ? json_object_get_int64( item ) : -1;
	// writers of VRM 0 leave bones that a character has not at -1
	if ( *name == 0 || node < 0 || node >= model->nodeCount )
	{
		return;
	}
	model->bones = toolGrow( model->bones, (size_t)model->boneCount + 1, sizeof( toolBone ) );
	model->bones[model->boneCount] = ( toolBone ){ .name = toolCopyString( name ), .node = (int32_t)node };
	++model->boneCount;
}

static bool toolReadBones( toolGltfReader* reader )
{
	toolModel* model = &reader->gltf->model;
	json_object* extensions = toolGetMember( reader->root, "extensions" );
	json_object* vrm1 = toolGetMember( extensions, "VRMC_vrm" );
	json_object* vrm0 = toolGetMember( extensions, "VRM" );
	if ( vrm1 != NULL )
	{
		json_object* bones = toolGetMember( toolGetMember( vrm1, "humanoid" ), "humanBones" );
		if ( json_object_is_type( bones, json_type_object ) )
		{
			json_object_object_foreach( bones, name, bone )
			{
				toolAddBone( model, name, bone );
			}
		}
		return true;
	}
	model->vrm0 = vrm0 != NULL;
	json_object* list = NULL;
	int32_t count = 0;
	if ( toolGetList( reader, toolGetMember( vrm0, "humanoid" ), "VRM.", "humanBones", &list, &count ) == false )
	{
		return false;
	}
	for ( int32_t i = 0; i < count; ++i )
	{
		json_object* bone = json_object_array_get_idx( list, (size_t)i );
		toolAddBone( model, toolGetText( bone, "bone" ), bone );
	}
	return true;
}

/// Every joint that a vertex follows must be in the skin of each node that shows the mesh.
static bool toolCheckInfluences( toolGltfReader* reader )
{
	const toolModel* model = &reader->gltf->model;
	int32_t* highest = toolAlloc( (size_t)model->meshCount, sizeof( int32_t ) );
	for ( int32_t i = 0; i < model->meshCount; ++i )
	{
		for ( int32_t j = 0; j < model->meshes[i].primitiveCount; ++j )
		{
			const toolPrimitive* primitive = model->meshes[i].primitives + j;
			size_t count = (size_t)primitive->vertexCount * (size_t)primitive->influences;
			for ( size_t k = 0; k < count; ++k )
			{
				highest[i] = primitive->joints[k] > highest[i] ? primitive->joints[k] : highest[i];
			}
		}
	}
	bool good = true;
	for ( int32_t i = 0; good && i < model->nodeCount; ++i )
	{
		const toolNode* node = model->nodes + i;
		if ( node->mesh != SOLE_NONE && node->skin != SOLE_NONE &&
		    highest[node->mesh] >= model->skins[node->skin].jointCount )
		{
			toolOwner owner = toolNameOwner( "nodes", (size_t)i, node->name );
			good =
			    toolFailFile( reader->error, reader->path, "%s has a mesh that follows joint %d of %d: export it again",
			        owner.text, highest[node->mesh], model->skins[node->skin].jointCount );
		}
	}
	free( highest );
	return good;
}

static bool toolCheckAsset( toolGltfReader* reader )
{
	const char* version = toolGetText( toolGetMember( reader->root, "asset" ), "version" );
	if ( strncmp( version, "2.", 2 ) != 0 )
	{
		return *version == 0
		    ? toolFailFile(
		          reader->error, reader->path, "is no glTF file, it has no asset.version: give a .glb, .vrm or .gltf" )
		    : toolFailFile( reader->error, reader->path, "is glTF version %.16s: export it as version 2.0", version );
	}
	const char* packed = toolFindCompression( reader->root, "extensionsRequired" );
	return packed == NULL ||
	    toolFailFile( reader->error, reader->path, "uses %s: decode it first, e.g. with gltf-transform", packed );
}

static bool toolCheckBuffer( toolGltfReader* reader )
{
	json_object* buffers = NULL;
	int32_t count = 0;
	size_t length = 0;
	if ( toolGetList( reader, reader->root, "", "buffers", &buffers, &count ) == false )
	{
		return false;
	}
	if ( count > 0 &&
	    toolGetSize( reader, json_object_array_get_idx( buffers, 0 ), "buffers[0]", "byteLength", SIZE_MAX >> 12,
	        &length ) == false )
	{
		return false;
	}
	if ( length > reader->gltf->binCount )
	{
		return toolFailFile( reader->error, reader->path,
		    "buffers[0] has %zu bytes where its byteLength says %zu: copy or export it again", reader->gltf->binCount,
		    length );
	}
	reader->bufferLength = length;
	return true;
}

bool toolReadModel( toolGltf* gltf, toolError* error )
{
	json_object* root = toolParseGltfJson( gltf->path, gltf->json, gltf->jsonCount, error );
	if ( root == NULL )
	{
		return false;
	}
	toolGltfReader reader = { .gltf = gltf, .path = gltf->path, .root = root, .error = error };
	bool good = toolCheckAsset( &reader ) && toolNormalizeGltf( gltf, &root, error ) && toolCheckBuffer( &reader );
	reader.budget = ( (size_t)256 << 20 ) + 64 * ( gltf->jsonCount + gltf->binCount );
	good = good && toolReadMaterials( &reader ) && toolReadMeshes( &reader ) && toolReadSkins( &reader ) &&
	    toolReadNodes( &reader ) && toolReadScene( &reader ) && toolCheckInfluences( &reader ) &&
	    toolReadClips( &reader ) && toolReadBones( &reader );
	json_object_put( root );
	return good;
}

/// Takes bytes over.
static bool toolOpenBytes(
    uint8_t* bytes, size_t byteCount, const char* path, bool glb, toolGltf** gltf, toolError* error )
{
	toolGltf* opened = toolAlloc( 1, sizeof( toolGltf ) );
	opened->path = toolCopyString( path );
	opened->original = bytes;
	opened->originalCount = byteCount;
	bool good =
	    ( glb ? toolSplitGlb( opened, error ) : toolSplitText( opened, error ) ) && toolReadModel( opened, error );
	if ( good == false )
	{
		toolFreeGltf( opened );
		opened = NULL;
	}
	*gltf = opened;
	return good;
}

bool toolReadGlbBytes( const uint8_t* bytes, size_t byteCount, const char* path, toolGltf** gltf, toolError* error )
{
	uint8_t* copy = toolAlloc( byteCount, 1 );
	if ( byteCount > 0 )
	{
		memcpy( copy, bytes, byteCount );
	}
	return toolOpenBytes( copy, byteCount, path, true, gltf, error );
}

bool toolReadGltf( const char* path, toolGltf** gltf, toolError* error )
{
	uint8_t* bytes = NULL;
	size_t byteCount = 0;
	*gltf = NULL;
	if ( toolReadFile( path, &bytes, &byteCount, error ) == false )
	{
		return false;
	}
	size_t first = 0;
	while ( first < byteCount && strchr( " \t\r\n\xef\xbb\xbf", bytes[first] ) != NULL && bytes[first] != 0 )
	{
		++first;
	}
	bool text = first < byteCount && bytes[first] == '{';
	return toolOpenBytes( bytes, byteCount, path, text == false, gltf, error );
}

void toolFreeGltf( toolGltf* gltf )
{
	if ( gltf == NULL )
	{
		return;
	}
	toolFreeModel( &gltf->model );
	for ( int32_t i = 0; i < gltf->retiredCount; ++i )
	{
		free( gltf->retired[i] );
	}
	free( gltf->retired );
	for ( int32_t i = 0; i < gltf->oldModelCount; ++i )
	{
		toolFreeModel( gltf->oldModels + i );
	}
	free( gltf->oldModels );
	free( gltf->path );
	free( gltf->original );
	free( gltf->json );
	free( gltf->bin );
	free( gltf->rest );
	free( gltf->matrices );
	free( gltf->inScene );
	free( gltf );
}

const toolModel* toolGltf_GetModel( const toolGltf* gltf )
{
	return &gltf->model;
}
