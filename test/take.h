// SPDX-License-Identifier: MIT
// A character's clip baked over a ground in memory and measured: what the tests over real files share.
#ifndef TEST_TAKE_H
#define TEST_TAKE_H

#include "test.h"

#include "bake.h"
#include "evaluate.h"
#include "source.h"

/// What to bake. Files are names below the data folder, or embedded samples.
typedef struct testBake
{
	const char* character;
	const char* clip;  // NULL: the best walk; where there is no clip: standing at rest
	const char* clips; // a second file with the clips, or NULL
	const char* ground;
	float groundScale; // 0: 1
	double x, z;       // start; both 0 and distance 0: the scene's own path
	double heading;
	double distance;
	double fps;         // 0: 60
	const char* method; // NULL: sole
} testBake;

typedef struct testTake
{
	toolGltf* gltf;
	toolGltf* clips;
	toolCharacter character;
	toolBoundClip bound;
	toolTravel travel;
	toolGroundSource ground;
	soleTerrain* terrain;
	toolBakeResult result;
	soleFigures figures;
	soleFigures flat; // of the clip on flat ground
} testTake;

static inline const char* testPath( const char* name, char path[1024] )
{
	if ( strchr( name, '.' ) == NULL )
	{
		return name; // embedded
	}
	snprintf( path, 1024, "%s/%s", SOLE_DATA_DIR, name );
	return path;
}

#define TEST_GOOD( call, error )                                                                                       \
	do                                                                                                                 \
	{                                                                                                                  \
		if ( ( call ) == false )                                                                                       \
		{                                                                                                              \
			print_error( "%s\n", ( error ).text );                                                                     \
			fail();                                                                                                    \
		}                                                                                                              \
	} while ( 0 )

static inline void testStretchGround( toolGroundSource* ground, float x, float y, float z )
{
	const float factors[] = { x, y, z };
	for ( int32_t i = 0; i < 3 * ground->mesh.vertexCount; ++i )
	{
		ground->mesh.positions[i] *= factors[i % 3];
	}
	soleDestroyGround( ground->ground );
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = ground->mesh.positions;
	mesh.vertexCount = ground->mesh.vertexCount;
	mesh.indices = ground->mesh.indices;
	mesh.triangleCount = ground->mesh.triangleCount;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.meshCount = 1;
	assert_int_equal( soleCreateGround( &def, NULL, &ground->ground, NULL ), sole_success );
}

static inline void testOpenTake( const testBake* bake, testTake* take )
{
	toolError error = { { 0 } };
	char path[1024];
	memset( take, 0, sizeof *take );
	TEST_GOOD( toolOpenCharacter( testPath( bake->character, path ), &take->gltf, &error ), error );
	const toolModel* model = toolGltf_GetModel( take->gltf );
	TEST_GOOD( toolMakeCharacter( model, path, 1.0f, &take->character, &error ), error );
	if ( bake->clips != NULL )
	{
		TEST_GOOD( toolOpenCharacter( testPath( bake->clips, path ), &take->clips, &error ), error );
		model = toolGltf_GetModel( take->clips );
	}
	int32_t clip = bake->clip != NULL ? toolFindClip( model, bake->clip ) : toolChooseClip( model );
	if ( clip == SOLE_NONE && bake->clip == NULL )
	{
		toolBindRest( &take->bound );
	}
	else
	{
		assert_true( clip >= 0 );
		TEST_GOOD( toolBindClip( &take->character, model, clip, &take->bound, &error ), error );
	}
	take->travel = toolFindTravel( &take->character, &take->bound );
	TEST_GOOD( toolOpenGround( testPath( bake->ground, path ), &take->ground, &error ), error );
	if ( bake->groundScale > 0.0f )
	{
		testStretchGround( &take->ground, bake->groundScale, bake->groundScale, bake->groundScale );
	}
	TEST_GOOD( toolMakeTerrain( &take->ground, &take->terrain, &error ), error );
}

static inline void testBakeTake( const testBake* bake, testTake* take )
{
	toolError error = { { 0 } };
	soleSettings settings = soleDefaultSettings();
	toolPlace start = { bake->x, (double)NAN, bake->z };
	toolBakeDef def = toolDefaultBakeDef();
	def.method = toolFindMethod( bake->method != NULL ? bake->method : "sole" );
	def.settings = &settings;
	def.groundName = bake->ground;
	bool ownPath = take->ground.path != NULL && bake->distance == 0.0 && bake->x == 0.0 && bake->z == 0.0;
	def.path = ownPath ? take->ground.path : &start;
	def.pathCount = ownPath ? take->ground.pathCount : 1;
	def.heading = bake->heading;
	def.distance = bake->distance;
	def.fps = bake->fps > 0.0 ? bake->fps : 60.0;
	toolFreeBakeResult( &take->result );
	TEST_GOOD(
	    toolBake( &take->character, &take->bound, &take->travel, take->ground.ground, &def, &take->result, &error ),
	    error );
	TEST_GOOD(
	    toolMeasureBake( &take->character, &take->result, take->terrain, &take->figures, &take->flat, &error ), error );
}

static inline void testCloseTake( testTake* take )
{
	toolFreeBakeResult( &take->result );
	soleDestroyTerrain( take->terrain );
	toolCloseGround( &take->ground );
	toolFreeBoundClip( &take->bound );
	toolFreeCharacter( &take->character );
	toolFreeGltf( take->clips );
	toolFreeGltf( take->gltf );
}

/// Where a point of a joint is in a frame of the output, world.
static inline soleVec3 testTakePoint( const testTake* take, int32_t frame, int32_t joint, soleVec3 local )
{
	const toolCharacter* c = &take->character;
	const soleTransform* pose = take->result.output + (size_t)frame * (size_t)c->jointCount;
	soleTransform t = pose[joint];
	for ( int32_t j = c->parents[joint]; j != SOLE_NONE; j = c->parents[j] )
	{
		t = soleMulTransform( pose[j], t );
	}
	return soleTransformPoint( soleMulTransform( take->result.walk.roots[frame], t ), local );
}

#endif
