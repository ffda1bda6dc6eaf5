// SPDX-License-Identifier: MIT
// What the files gltf_*.c share. Nobody else includes this but the reader of grounds, which needs full matrices.
#ifndef TOOL_GLTF_INTERNAL_H
#define TOOL_GLTF_INTERNAL_H

#include "gltf.h"
#include "json_splice.h"

struct json_object;

struct toolGltf
{
	char* path;
	uint8_t* original; // the file as it was read, or NULL where there was none
	size_t originalCount;
	bool originalIsText;   // a .gltf
	bool originalHasFiles; // and it names other files
	bool changed;          // something was appended
	// The same in the form of a .glb: whatever was read is brought into it.
	char* json; // without padding
	size_t jsonCount;
	uint8_t* bin;
	size_t binCount;
	uint8_t* rest; // chunks behind BIN, as they were
	size_t restCount;
	// What a toolModel does not tell.
	float* matrices; // local, 16 a node, column by column
	bool* inScene;   // per node: the default scene shows it
	int32_t scene;   // or SOLE_NONE
	// What the model was before it was renewed: pointers into it stay good until the file is freed.
	void** retired;
	int32_t retiredCount;
	toolModel* oldModels;
	int32_t oldModelCount;
	toolModel model;
};

typedef struct toolGltfReader
{
	toolGltf* gltf;
	const char* path;
	struct json_object* root;
	size_t bufferLength; // bytes of BIN that buffers[0] speaks of
	size_t budget;       // bytes that may still be decoded: shared accessors must not multiply without bound
	toolError* error;
} toolGltfReader;

/// "PATH: ..." on one line: what a file puts into it and is not clean text becomes '?'. Returns false.
bool toolFailFile( toolError* error, const char* path, const char* format, ... )
#if defined( __GNUC__ )
    __attribute__( ( format( printf, 3, 4 ) ) )
#endif
    ;

// gltf_json.c: values of untrusted JSON. `owner` says for messages whose value it is ("nodes[3]").

/// A piece of text for messages.
typedef struct toolOwner
{
	char text[96];
} toolOwner;

toolOwner toolNameOwner( const char* list, size_t index, const char* name );
/// The text of json, with an object's duplicate keys refused. NULL where that fails.
struct json_object* toolParseGltfJson( const char* path, const char* text, size_t byteCount, toolError* error );
struct json_object* toolGetMember( struct json_object* object, const char* key );
/// The list of that name and its length; NULL and 0 where there is none. False where it is no list.
bool toolGetList( const toolGltfReader* reader, struct json_object* object, const char* owner, const char* key,
    struct json_object** list, int32_t* count );
/// A whole number from 0 to limit. Keeps value where there is none.
bool toolGetSize( const toolGltfReader* reader, struct json_object* object, const char* owner, const char* key,
    size_t limit, size_t* value );
/// An index below count, or SOLE_NONE where there is none.
bool toolGetIndex( const toolGltfReader* reader, struct json_object* object, const char* owner, const char* key,
    int32_t count, int32_t* index );
/// So many finite numbers. Keeps values where there are none; *found may be NULL.
bool toolGetFloats( const toolGltfReader* reader, struct json_object* object, const char* owner, const char* key,
    int32_t count, float* values, bool* found );
/// Never NULL: empty where there is none. Lives as long as the object.
const char* toolGetText( struct json_object* object, const char* key );
bool toolGetFlag( struct json_object* object, const char* key );
/// The name of an unsupported compression that the file must have undone, or NULL.
const char* toolFindCompression( struct json_object* root, const char* list );

// gltf_accessor.c

typedef enum toolAccessorUse
{
	tool_useScalar = 1,
	tool_useVec3 = 3,
	tool_useVec4 = 4,
	tool_useMat4 = 16
} toolAccessorUse;

/// Numbers of an accessor: normalised integers become what they stand for; asFractions takes all integers for such.
bool toolReadFloats( toolGltfReader* reader, int32_t accessor, const char* owner, toolAccessorUse use, bool asFractions,
    float** values, int32_t* count );
/// Unsigned integers of an accessor.
bool toolReadUints( toolGltfReader* reader, int32_t accessor, const char* owner, toolAccessorUse use, uint32_t** values,
    int32_t* count );
/// Takes bytes from the budget.
bool toolSpend( toolGltfReader* reader, const char* owner, size_t count, size_t size );
/// Index of the first number that is not finite, or -1.
int64_t toolFindNotFinite( const float* values, size_t count );

// gltf_container.c, gltf_normalize.c

uint32_t toolReadU32( const uint8_t* bytes );
bool toolIsGlb( const uint8_t* bytes, size_t byteCount );
bool toolSplitGlb( toolGltf* gltf, toolError* error );
bool toolSplitText( toolGltf* gltf, toolError* error );
/// Brings other than one buffer in BIN into that form. Nothing happens where the file is in it.
bool toolNormalizeGltf( toolGltf* gltf, struct json_object** root, toolError* error );
/// The folder of a path with its slash, or "".
char* toolGetFolder( const char* path );

// gltf_read.c, gltf_node.c, gltf_mesh.c, gltf_clip.c: parts of the model

bool toolReadModel( toolGltf* gltf, toolError* error );
bool toolReadNodes( toolGltfReader* reader );
/// Marks what the default scene shows: its nodes and all below them; all nodes where there is no scene.
bool toolReadScene( toolGltfReader* reader );
bool toolReadMeshes( toolGltfReader* reader );
bool toolReadClips( toolGltfReader* reader );

// gltf_build.c, gltf_items.c, gltf_items_mesh.c

/// New items of a file's lists and their bytes. They count from what the file has.
typedef struct toolBuilder
{
	size_t binBase;
	size_t viewCount;
	size_t accessorCount;
	size_t meshCount;
	size_t nodeCount;
	size_t materialCount;
	size_t skinCount;
	toolJsonText views;
	toolJsonText accessors;
	toolJsonText meshes;
	toolJsonText nodes;
	toolJsonText materials;
	toolJsonText skins;
	toolJsonText clips;
	toolJsonText sceneNodes;
	uint8_t* bin;
	size_t binCount;
	size_t binCapacity;
} toolBuilder;

void toolStartBuilder( const toolGltf* gltf, toolBuilder* builder );
/// Puts all into the file's JSON and BIN. Frees the builder.
bool toolCommitBuilder( toolGltf* gltf, toolBuilder* builder, toolError* error );
/// target 0: none. @return the view's index
size_t toolAddView( toolBuilder* builder, const void* bytes, size_t byteCount, int target );
/// type "VEC3", componentType as in glTF; withBounds: min and max of the floats. @return the accessor's index
size_t toolAddAccessor( toolBuilder* builder, size_t view, size_t offset, int componentType, const char* type,
    size_t count, const float* bounds, int32_t boundSize );
/// Starts an item of a list: the comma and bracket.
void toolOpenItem( toolJsonText* list );
void toolAddKey( toolJsonText* out, const char* key );
/// Nothing where the name is empty.
void toolAddName( toolJsonText* out, const char* name );
void toolBuildClip( toolBuilder* builder, const toolClip* clip );
/// Whether a skin moves every part of a mesh.
bool toolIsSkinned( const toolModel* model, int32_t mesh );
void toolBuildMaterial( toolBuilder* builder, const toolMaterial* material );
/// meshMap takes a mesh of the model to one of the file, or SOLE_NONE where it has no triangles.
void toolBuildMeshes( toolBuilder* builder, const toolModel* model, bool withSkins, int32_t* meshMap );
void toolBuildSkins( toolBuilder* builder, const toolModel* model );
void toolBuildNodes( toolBuilder* builder, const toolModel* model, bool withSkins, const int32_t* meshMap );

#endif
