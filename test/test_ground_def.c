// SPDX-License-Identifier: MIT
// What a ground is made of: layers, sides, planes, definitions, memory; and probes that ask nothing.
#include "ground_support.h"

static const soleVec3 down = { 0.0f, -1.0f, 0.0f };

static void layersThatAreNotAskedForAreNotMet( void** state )
{
	(void)state;
	testMesh low = testMakeTerrain( 1, 2, 1.0f, 0.0f );
	testMesh high = testMakeTerrain( 1, 2, 1.0f, 0.0f );
	for ( int32_t v = 0; v < high.vertexCount; ++v )
	{
		high.vertices[3 * v + 1] = 1.0f;
	}
	uint32_t layers[8] = { 2, 2, 4, 4, 2, 2, 2, 2 };
	soleGroundMesh meshes[2] = { testGroundMesh( &low ), testGroundMesh( &high ) };
	meshes[0].layer = 8;
	meshes[0].surface = 5;
	meshes[1].triangleLayers = layers;
	soleGround* ground = testMakeGround( meshes, 2 );
	soleProbe probe = testProbe( soleVec( 0.3f, 2.0f, 0.6f ), down, 3.0f, 0.0f );
	for ( int32_t radius = 0; radius < 2; ++radius )
	{
		probe.radius = 0.1f * (float)radius;
		probe.start_w.x = 0.3f;
		probe.mask = 0xffffffffu;
		assert_int_equal( soleCastProbe( ground, &probe ).layer, 2 );
		assert_int_equal( soleCastProbe( ground, &probe ).surface, SOLE_NONE );
		probe.mask = 8;
		assert_int_equal( soleCastProbe( ground, &probe ).layer, 8 );
		assert_int_equal( soleCastProbe( ground, &probe ).surface, 5 );
		probe.mask = 4 | 8;
		assert_int_equal( soleCastProbe( ground, &probe ).layer, 8 );
		probe.start_w.x = 1.4f;
		assert_int_equal( soleCastProbe( ground, &probe ).layer, 4 );
		probe.mask = 16;
		assert_false( soleCastProbe( ground, &probe ).hit );
	}
	soleDestroyGround( ground );
	testFreeMesh( &low );
	testFreeMesh( &high );
}

static void backFacesAreMetOnlyWhereAskedFor( void** state )
{
	(void)state;
	soleVec3 up = { 0.0f, 1.0f, 0.0f };
	testMesh mesh = testMakeTerrain( 1, 2, 1.0f, 0.0f );
	soleGround* oneSided = testMakeMeshGround( &mesh, false );
	soleGround* twoSided = testMakeMeshGround( &mesh, true );
	for ( int32_t radius = 0; radius < 2; ++radius )
	{
		float r = 0.1f * (float)radius;
		assert_false( testCast( oneSided, soleVec( 0.5f, -1.0f, 0.6f ), up, 2.0f, r ).hit );
		soleHit hit = testCast( twoSided, soleVec( 0.5f, -1.0f, 0.6f ), up, 2.0f, r );
		assert_true( hit.hit );
		testNear3( hit.point_w, soleVec( 0.5f, 0.0f, 0.6f ), 1e-6f );
		testNear3( hit.normal_w, down, 1e-6f );
		hit = testCast( twoSided, soleVec( 0.5f, 1.0f, 0.6f ), down, 2.0f, r );
		testNear3( hit.normal_w, up, 1e-6f );
	}
	soleDestroyGround( oneSided );
	soleDestroyGround( twoSided );
	testFreeMesh( &mesh );
}

static void planesAreSolidBelow( void** state )
{
	(void)state;
	soleGroundPlane planes[2] = { soleDefaultGroundPlane(), soleDefaultGroundPlane() };
	planes[0].offset = 0.25f;
	planes[0].surface = 3;
	planes[1].normal = soleVec( 0.6f, 0.8f, 0.0f );
	planes[1].layer = 2;
	soleGroundDef def = soleDefaultGroundDef();
	def.planes = planes;
	def.planeCount = 2;
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &ground, NULL ), sole_success );
	soleProbe probe = testProbe( soleVec( -3.0f, 1.0f, 2.0f ), down, 2.0f, 0.0f );
	probe.mask = 1;
	soleHit hit = soleCastProbe( ground, &probe );
	assert_true( hit.hit && !hit.startedInside );
	assert_int_equal( hit.surface, 3 );
	testNear3( hit.point_w, soleVec( -3.0f, 0.25f, 2.0f ), 1e-6f );
	probe.radius = 0.5f;
	testNear3( soleCastProbe( ground, &probe ).point_w, soleVec( -3.0f, 0.25f, 2.0f ), 1e-6f );
	probe.start_w.y = 0.0f;
	hit = soleCastProbe( ground, &probe );
	assert_true( hit.hit && hit.startedInside );
	testNear3( hit.point_w, soleVec( -3.0f, 0.25f, 2.0f ), 1e-6f );
	testNear3( hit.normal_w, soleVec( 0.0f, 1.0f, 0.0f ), 1e-6f );
	probe = testProbe( soleVec( 1.0f, 2.0f, 0.0f ), down, 5.0f, 0.0f );
	probe.mask = 2;
	hit = soleCastProbe( ground, &probe );
	testNear3( hit.point_w, soleVec( 1.0f, -0.75f, 0.0f ), 1e-6f );
	testNear3( hit.normal_w, planes[1].normal, 1e-6f );
	probe.direction_w = soleVec( 0.0f, 1.0f, 0.0f );
	assert_false( soleCastProbe( ground, &probe ).hit );
	soleDestroyGround( ground );
}

static void emptyGroundAndUselessProbesMiss( void** state )
{
	(void)state;
	soleGroundDef def = soleDefaultGroundDef();
	soleGround* empty = NULL;
	assert_int_equal( soleCreateGround( &def, NULL, &empty, NULL ), sole_success );
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( empty, &lower, &upper );
	assert_true( lower.x > upper.x && lower.y > upper.y && lower.z > upper.z );
	assert_int_equal( soleGround_GetTriangleCount( empty ), 0 );
	assert_false( testCast( empty, soleVec( 0.0f, 1.0f, 0.0f ), down, 2.0f, 0.0f ).hit );
	assert_false( testCast( NULL, soleVec( 0.0f, 1.0f, 0.0f ), down, 2.0f, 0.0f ).hit );
	soleDestroyGround( empty );
	soleDestroyGround( NULL );

	testMesh mesh = testMakeTerrain( 1, 2, 1.0f, 0.0f );
	soleGround* ground = testMakeMeshGround( &mesh, true );
	soleProbe good = testProbe( soleVec( 0.5f, 1.0f, 0.6f ), down, 2.0f, 0.0f );
	assert_true( soleCastProbe( ground, &good ).hit );
	float bad[3] = { NAN, INFINITY, -INFINITY };
	for ( int k = 0; k < 3; ++k )
	{
		for ( int field = 0; field < 8; ++field )
		{
			soleProbe probe = good;
			float* fields[8] = { &probe.start_w.x, &probe.start_w.y, &probe.start_w.z, &probe.direction_w.x,
				&probe.direction_w.y, &probe.direction_w.z, &probe.length, &probe.radius };
			*fields[field] = bad[k];
			assert_false( soleCastProbe( ground, &probe ).hit );
		}
	}
	soleProbe probe = good;
	probe.length = 0.0f;
	assert_false( soleCastProbe( ground, &probe ).hit );
	probe.length = -1.0f;
	assert_false( soleCastProbe( ground, &probe ).hit );
	probe = good;
	probe.direction_w = soleVec( 0.0f, 0.0f, 0.0f );
	assert_false( soleCastProbe( ground, &probe ).hit );
	probe = good;
	probe.start_w = soleVec( 3e38f, 3e38f, -3e38f );
	probe.length = 3e38f;
	assert_false( soleCastProbe( ground, &probe ).hit );
	probe.radius = 1.0f;
	assert_false( soleCastProbe( ground, &probe ).hit );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void answersSayWhatWasAsked( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 1, 2, 1.0f, 0.0f );
	soleGround* ground = testMakeMeshGround( &mesh, false );
	soleProbe probes[3] = { testProbe( soleVec( 0.5f, 1.0f, 0.6f ), down, 2.0f, 0.0f ),
		testProbe( soleVec( 9.0f, 1.0f, 0.6f ), down, 2.0f, 0.0f ),
		testProbe( soleVec( 1.5f, 1.0f, 0.6f ), down, 0.9f, 0.0f ) };
	soleHit hits[3];
	soleCastProbes( ground, probes, 3, hits );
	assert_true( hits[0].hit && !hits[1].hit && !hits[2].hit );
	for ( int32_t i = 0; i < 3; ++i )
	{
		testNear3( hits[i].asked_w, probes[i].start_w, 0.0f );
		testNear3( hits[i].velocity_w, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	}
	soleVec3 lower;
	soleVec3 upper;
	soleGround_GetBounds( ground, &lower, &upper );
	testNear3( lower, soleVec( 0.0f, 0.0f, 0.0f ), 0.0f );
	testNear3( upper, soleVec( 2.0f, 0.0f, 2.0f ), 0.0f );
	assert_int_equal( soleGround_GetTriangleCount( ground ), 8 );
	soleDestroyGround( ground );
	testFreeMesh( &mesh );
}

static void trianglesWithoutAreaAreDropped( void** state )
{
	(void)state;
	float vertices[] = { 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 1, 0.1f, 0.1f, 0.1f, 0.3f, 0.3f, 0.3f, 0.7f, 0.7f, 0.7f };
	uint32_t indices[] = { 0, 1, 2, 0, 3, 1, 0, 0, 3, 4, 5, 6, 3, 3, 3 };
	testMesh mesh = { vertices, 7, indices, 5 };
	soleGround* ground = testMakeMeshGround( &mesh, true );
	assert_int_equal( soleGround_GetTriangleCount( ground ), 1 );
	assert_true( testCast( ground, soleVec( 0.2f, 1.0f, 0.2f ), down, 2.0f, 0.0f ).hit );
	soleDestroyGround( ground );
	indices[3] = 0;
	indices[4] = 1;
	ground = testMakeMeshGround( &mesh, true );
	assert_int_equal( soleGround_GetTriangleCount( ground ), 0 );
	assert_false( testCast( ground, soleVec( 0.2f, 1.0f, 0.2f ), down, 2.0f, 0.0f ).hit );
	soleDestroyGround( ground );
}

static void expectRefusal( const soleGroundDef* def, const char* field )
{
	soleGround* ground = (soleGround*)1;
	soleMessage message = { "" };
	assert_int_equal( soleCreateGround( def, NULL, &ground, &message ), sole_invalidDefinition );
	assert_null( ground );
	if ( strncmp( message.text, field, strlen( field ) ) != 0 || strchr( message.text + strlen( field ), ':' ) == NULL )
	{
		fail_msg( "'%s' does not begin with '%s'", message.text, field );
	}
	assert_int_equal( soleCreateGround( def, NULL, &ground, NULL ), sole_invalidDefinition );
}

static void badMeshesAreRefusedByName( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 1, 1, 1.0f, 0.0f );
	soleGroundMesh meshes[2] = { testGroundMesh( &mesh ), testGroundMesh( &mesh ) };
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = meshes;
	def.meshCount = 2;
	meshes[1].vertices = NULL;
	expectRefusal( &def, "meshes[1].vertices" );
	meshes[1] = meshes[0];
	meshes[1].vertexCount = -1;
	expectRefusal( &def, "meshes[1].vertices" );
	meshes[1] = meshes[0];
	meshes[1].indices = NULL;
	expectRefusal( &def, "meshes[1].indices" );
	meshes[1] = meshes[0];
	meshes[1].triangleCount = -2;
	expectRefusal( &def, "meshes[1].indices" );
	meshes[1] = meshes[0];
	meshes[1].vertexStride = 0;
	expectRefusal( &def, "meshes[1].vertexStride" );
	meshes[1] = meshes[0];
	mesh.indices[4] = 4;
	expectRefusal( &def, "meshes[0].indices" );
	mesh.indices[4] = 0xffffffffu;
	expectRefusal( &def, "meshes[0].indices" );
	mesh.indices[4] = 2;
	mesh.vertices[7] = NAN;
	expectRefusal( &def, "meshes[0].vertices" );
	mesh.vertices[7] = INFINITY;
	expectRefusal( &def, "meshes[0].vertices" );
	mesh.vertices[7] = 0.0f;
	def.meshes = NULL;
	expectRefusal( &def, "meshes" );
	def.meshes = meshes;
	def.meshCount = -1;
	expectRefusal( &def, "meshes" );
	def.meshCount = 2;
	def.internalValue = 0;
	expectRefusal( &def, "def" );
	expectRefusal( NULL, "def" );
	testFreeMesh( &mesh );
}

static void badPlanesAndFieldsAreRefusedByName( void** state )
{
	(void)state;
	soleGroundPlane plane = soleDefaultGroundPlane();
	soleGroundDef def = soleDefaultGroundDef();
	def.planes = &plane;
	def.planeCount = 1;
	plane.normal.y = 2.0f;
	expectRefusal( &def, "planes[0].normal" );
	plane.normal.y = NAN;
	expectRefusal( &def, "planes[0].normal" );
	plane = soleDefaultGroundPlane();
	plane.offset = INFINITY;
	expectRefusal( &def, "planes[0].offset" );

	float heights[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
	soleHeightField good = soleDefaultHeightField();
	good.countX = 2;
	good.countZ = 2;
	good.heights = heights;
	soleHeightField field = good;
	def = soleDefaultGroundDef();
	def.heightFields = &field;
	def.heightFieldCount = 1;
	field.origin.y = NAN;
	expectRefusal( &def, "heightFields[0].origin" );
	field = good;
	field.axisX.y = 0.5f;
	expectRefusal( &def, "heightFields[0].axisX" );
	field = good;
	field.cellZ = 0.0f;
	expectRefusal( &def, "heightFields[0].cellX" );
	field = good;
	field.countZ = 1;
	expectRefusal( &def, "heightFields[0].countX" );
	field.countZ = INT32_MAX;
	field.countX = INT32_MAX;
	expectRefusal( &def, "heightFields[0].countX" );
	field = good;
	field.heights = NULL;
	expectRefusal( &def, "heightFields[0].heights" );
	field = good;
	heights[2] = -INFINITY;
	expectRefusal( &def, "heightFields[0].heights" );
}

typedef struct countingHeap
{
	int32_t failAt; // this allocation fails, counted from zero; below zero: none
	int32_t calls;
	size_t held;
	size_t most;
} countingHeap;

static void* countedAlloc( size_t byteCount, void* user )
{
	countingHeap* heap = user;
	heap->calls += 1;
	if ( heap->calls - 1 == heap->failAt )
	{
		return NULL;
	}
	heap->held += byteCount;
	heap->most = heap->held > heap->most ? heap->held : heap->most;
	return malloc( byteCount );
}

static void countedFree( void* memory, size_t byteCount, void* user )
{
	countingHeap* heap = user;
	assert_true( byteCount <= heap->held );
	heap->held -= byteCount;
	free( memory );
}

static void everyFailedAllocationIsReportedAndLeavesNothing( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 1, 12, 1.0f, 0.5f );
	uint32_t layers[288] = { 1 };
	float heights[6] = { 0 };
	soleGroundMesh meshes[2] = { testGroundMesh( &mesh ), testGroundMesh( &mesh ) };
	meshes[1].triangleLayers = layers;
	soleHeightField fields[2] = { soleDefaultHeightField(), soleDefaultHeightField() };
	fields[0].heights = fields[1].heights = heights;
	fields[0].countX = fields[1].countX = 2;
	fields[0].countZ = fields[1].countZ = 3;
	soleGroundPlane plane = soleDefaultGroundPlane();
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = meshes;
	def.meshCount = 2;
	def.heightFields = fields;
	def.heightFieldCount = 2;
	def.planes = &plane;
	def.planeCount = 1;
	countingHeap heap = { .failAt = 0 };
	soleAllocator allocator = { countedAlloc, countedFree, &heap };
	soleResult result = sole_outOfMemory;
	while ( result != sole_success )
	{
		soleGround* ground = NULL;
		soleMessage message = { "" };
		heap.calls = 0;
		result = soleCreateGround( &def, &allocator, &ground, &message );
		if ( result == sole_success )
		{
			assert_true( heap.calls <= heap.failAt );
			soleDestroyGround( ground );
		}
		else
		{
			assert_int_equal( result, sole_outOfMemory );
			assert_null( ground );
			assert_true( strlen( message.text ) > 0 );
		}
		assert_int_equal( heap.held, 0 );
		heap.failAt += 1;
	}
	assert_true( heap.failAt > 10 );
	testFreeMesh( &mesh );
}

static void memoryIsAtMost40BytesATriangleOverTheMesh( void** state )
{
	(void)state;
	testMesh mesh = testMakeTerrain( 7, 150, 0.25f, 0.3f );
	soleGroundMesh groundMesh = testGroundMesh( &mesh );
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &groundMesh;
	def.meshCount = 1;
	countingHeap heap = { .failAt = -1 };
	soleAllocator allocator = { countedAlloc, countedFree, &heap };
	soleGround* ground = NULL;
	assert_int_equal( soleCreateGround( &def, &allocator, &ground, NULL ), sole_success );
	double own = 12.0 * mesh.vertexCount + 12.0 * mesh.triangleCount;
	double over = ( (double)heap.held - own ) / mesh.triangleCount;
	print_message( "%.1f bytes a triangle over the mesh, %.1f at most while building\n", over,
	    ( (double)heap.most - own ) / mesh.triangleCount );
	assert_true( over <= 40.0 );
	soleDestroyGround( ground );
	assert_int_equal( heap.held, 0 );
	testFreeMesh( &mesh );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( layersThatAreNotAskedForAreNotMet ),
		cmocka_unit_test( backFacesAreMetOnlyWhereAskedFor ),
		cmocka_unit_test( planesAreSolidBelow ),
		cmocka_unit_test( emptyGroundAndUselessProbesMiss ),
		cmocka_unit_test( answersSayWhatWasAsked ),
		cmocka_unit_test( trianglesWithoutAreaAreDropped ),
		cmocka_unit_test( badMeshesAreRefusedByName ),
		cmocka_unit_test( badPlanesAndFieldsAreRefusedByName ),
		cmocka_unit_test( everyFailedAllocationIsReportedAndLeavesNothing ),
		cmocka_unit_test( memoryIsAtMost40BytesATriangleOverTheMesh ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
