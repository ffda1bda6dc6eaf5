// SPDX-License-Identifier: MIT
// The program sole_bits: computes with everything that promises the same bits everywhere, over numbers that are made
// without the C library or come out of traces, and prints a digest of each part. test/checks/bits.sh builds it with
// every compiler, at every level of optimisation and for every processor that it can get, and compares.
//   usage: sole_bits TRACE...
// Legs are solved in each width that the machine has; a lane that differs from one leg alone ends the program with 1.
#include "../leg_batch.h"
#include "debug/trace_internal.h"
#include "place/leg_wide.h"

#include "sole/crowd.h"
#include "sole/ground.h"
#include "sole/limb.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DIGEST_START 14695981039346656037ull // FNV-1a, 64 bits
#define MOST_TRACE_BYTES 64000000

static uint64_t testDigestWord( uint64_t digest, uint32_t word )
{
	for ( int i = 0; i < 4; ++i )
	{
		digest = ( digest ^ ( word >> ( 8 * i ) & 255u ) ) * 1099511628211ull;
	}
	return digest;
}

/// One number that is none is as good as another: their bits are not defined.
static uint64_t testDigestFloats( uint64_t digest, const float* numbers, int32_t count )
{
	for ( int32_t i = 0; i < count; ++i )
	{
		uint32_t bits;
		memcpy( &bits, numbers + i, sizeof bits );
		digest = testDigestWord( digest, numbers[i] != numbers[i] ? 0x7fc00000u : bits );
	}
	return digest;
}

static uint64_t testDigestVec( uint64_t digest, soleVec3 v )
{
	const float numbers[3] = { v.x, v.y, v.z };
	return testDigestFloats( digest, numbers, 3 );
}

static uint64_t testDigestQuat( uint64_t digest, soleQuat q )
{
	const float numbers[4] = { q.x, q.y, q.z, q.w };
	return testDigestFloats( digest, numbers, 4 );
}

// ------------------------------------------------------------------------------------------------------------ legs

static uint64_t testDigestLegs( int32_t width )
{
	static testBatch batch;
	testFillBatchFcn* const fills[] = { testFillLegs, testFillAnything };
	uint64_t digest = DIGEST_START;
	for ( uint32_t seed = 1; seed <= 4; ++seed )
	{
		for ( int i = 0; i < 2; ++i )
		{
			testBeginBatch( &batch );
			fills[i]( &batch, seed );
			soleGetLegLanes( width )( &batch.batch, 0, BATCH_COUNT );
			digest = testDigestFloats( digest, batch.out[0], BATCH_OUT * BATCH_COUNT );
			for ( int32_t k = 0; k < BATCH_COUNT; ++k )
			{
				digest = testDigestWord( digest, batch.flags[k] );
			}
		}
	}
	return digest;
}

/// @return whether all widths give what one leg alone gets
static bool testPrintLegs( void )
{
	static const int32_t widths[] = { 4, 8, 16 };
	uint64_t alone = testDigestLegs( 1 );
	printf( "legs %016llx", (unsigned long long)alone );
	for ( int i = 0; i < 3 && widths[i] <= soleGetBatchWidth(); ++i )
	{
		if ( testDigestLegs( widths[i] ) != alone )
		{
			printf( "\nlegs %d wide are not what they are one by one\n", (int)widths[i] );
			return false;
		}
	}
	return true;
}

// ----------------------------------------------------------------------------------------------------------- limbs

#define JOINT_COUNT 7

static uint64_t testDigestLimbs( void )
{
	static const int32_t parents[JOINT_COUNT] = { SOLE_NONE, 0, 1, 2, 3, 4, 5 };
	soleLimbDef limb = soleDefaultLimbDef();
	limb.parents = parents;
	limb.jointCount = JOINT_COUNT;
	limb.upper = 2;
	limb.lower = 4;
	limb.end = 5;
	limb.hinge_l = soleVec( 1.0f, 0.0f, 0.0f );
	soleLookDef look = soleDefaultLookDef();
	look.parents = parents;
	look.jointCount = JOINT_COUNT;
	look.lookCount = 3;
	for ( int32_t i = 0; i < 3; ++i )
	{
		look.joints[i] = 4 + i;
	}
	uint64_t digest = DIGEST_START;
	uint32_t seed = 7;
	for ( int32_t i = 0; i < 2000; ++i )
	{
		soleTransform pose[JOINT_COUNT];
		for ( int32_t k = 0; k < JOINT_COUNT; ++k )
		{
			pose[k] = soleTransform_Identity();
			pose[k].translation = testRandomPoint( &seed, 0.4f );
			pose[k].rotation = testRandomTurn( &seed );
		}
		soleLimbGoal goal = { testRandomPoint( &seed, 1.0f ), testRandomTurn( &seed ), 1.0f, 0.75f };
		soleLimbHint hint = { testRandomPoint( &seed, 1.0f ), 0.5f };
		soleLimbResult reached = soleSolveLimb( &limb, pose, &goal, &hint );
		digest = testDigestQuat( testDigestQuat( digest, reached.upper_l ), reached.lower_l );
		digest = testDigestVec( testDigestQuat( digest, reached.end_l ), reached.end );
		digest = testDigestWord( testDigestFloats( digest, &reached.error, 1 ), reached.flags );
		soleLookResult seen = soleSolveLookAt( &look, pose, testRandomPoint( &seed, 3.0f ), 1.0f );
		for ( int32_t k = 0; k < look.lookCount; ++k )
		{
			digest = testDigestQuat( digest, seen.rotations_l[k] );
		}
		digest = testDigestWord( testDigestVec( testDigestVec( digest, seen.eyes ), seen.gaze ), seen.flags );
	}
	return digest;
}

// ---------------------------------------------------------------------------------------------------------- ground

#define CELLS 48
#define CORNERS ( CELLS + 1 )

/// A rough square of triangles from both sides, a field of heights beside it, and a plane under both.
static soleGround* testMakeRoughGround( void )
{
	static float vertices[CORNERS * CORNERS][3];
	static uint32_t indices[2 * CELLS * CELLS][3];
	static float heights[CORNERS * CORNERS];
	uint32_t seed = 11;
	for ( int32_t i = 0; i < CORNERS * CORNERS; ++i )
	{
		vertices[i][0] = 0.25f * (float)( i % CORNERS ) + testRandomFloat( &seed, -0.1f, 0.1f );
		vertices[i][1] = testRandomFloat( &seed, 0.0f, 0.5f );
		vertices[i][2] = 0.25f * (float)( i / CORNERS );
		heights[i] = testRandomFloat( &seed, 0.0f, 0.5f );
	}
	for ( uint32_t i = 0; i < CELLS * CELLS; ++i )
	{
		uint32_t a = i / CELLS * CORNERS + i % CELLS;
		uint32_t b = a + CORNERS;
		const uint32_t quad[6] = { a, b + 1, a + 1, a, b, b + 1 };
		memcpy( indices[2 * i], quad, sizeof quad );
	}
	soleGroundMesh mesh = soleDefaultGroundMesh();
	mesh.vertices = vertices[0];
	mesh.vertexCount = CORNERS * CORNERS;
	mesh.indices = indices[0];
	mesh.triangleCount = 2 * CELLS * CELLS;
	mesh.twoSided = true;
	soleHeightField field = soleDefaultHeightField();
	field.origin = soleVec( -12.0f, 0.0f, 0.0f );
	field.cellX = field.cellZ = 0.25f;
	field.countX = field.countZ = CORNERS;
	field.heights = heights;
	soleGroundPlane plane = soleDefaultGroundPlane();
	plane.offset = -0.5f;
	soleGroundDef def = soleDefaultGroundDef();
	def.meshes = &mesh;
	def.heightFields = &field;
	def.planes = &plane;
	def.meshCount = def.heightFieldCount = def.planeCount = 1;
	soleGround* ground = NULL;
	soleCreateGround( &def, NULL, &ground, NULL );
	return ground;
}

static uint64_t testDigestHit( uint64_t digest, const soleHit* hit )
{
	digest = testDigestWord( digest, ( hit->hit ? 1u : 0u ) | ( hit->startedInside ? 2u : 0u ) );
	return testDigestVec( testDigestVec( testDigestVec( digest, hit->point_w ), hit->normal_w ), hit->velocity_w );
}

/// Rays and spheres, straight down and in any direction, some at once and through a piece that is turned and moves.
static uint64_t testDigestGround( void )
{
	soleGround* ground = testMakeRoughGround();
	soleGroundPiece piece = { .ground = ground, .transform = soleTransform_Identity(), .surface = 5 };
	piece.transform.rotation = ( soleQuat ){ 0.0f, 0.28f, 0.0f, 0.96f };
	piece.spin_w = soleVec( 0.0f, 0.5f, 0.0f );
	uint64_t digest = DIGEST_START;
	uint32_t seed = 13;
	for ( int32_t i = 0; i < 4000; ++i )
	{
		soleProbe probes[5];
		soleHit hits[5];
		for ( int32_t k = 0; k < 5; ++k )
		{
			soleVec3 start = testRandomPoint( &seed, 12.0f );
			start.y = testRandomFloat( &seed, 0.6f, 1.5f );
			start.z = fabsf( start.z );
			soleVec3 direction = testRandomDirection( &seed );
			direction = i % 2 == 0 ? soleVec( 0.0f, -1.0f, 0.0f ) : direction;
			probes[k] = ( soleProbe ){ .start_w = start,
				.direction_w = direction,
				.length = 2.0f,
				.radius = i % 4 < 2 ? 0.0f : testRandomFloat( &seed, 0.01f, 0.3f ),
				.mask = 0xffffffffu };
		}
		soleCastProbes( ground, probes, 5, hits );
		for ( int32_t k = 0; k < 5; ++k )
		{
			digest = testDigestHit( digest, hits + k );
		}
		soleHit hit = soleCastPieces( &piece, 1, probes );
		digest = testDigestHit( digest, &hit );
	}
	soleDestroyGround( ground );
	return digest;
}

// ---------------------------------------------------------------------------------------------------------- solves

/// All words of a struct that a trace keeps.
static uint64_t testDigestFields( uint64_t digest, const soleTraceTable* table, const void* from )
{
	for ( int32_t i = 0; i < table->count; ++i )
	{
		for ( int32_t k = 0; k < table->fields[i].count; ++k )
		{
			uint32_t word;
			memcpy( &word, (const char*)from + table->fields[i].offset + 4 * k, sizeof word );
			digest = testDigestWord( digest, word );
		}
	}
	return digest;
}

static uint64_t testDigestOutput( uint64_t digest, const soleOutput* output )
{
	digest = testDigestFields( digest, &soleTraceOutputTable, output );
	for ( int32_t i = 0; i < output->legCount; ++i )
	{
		digest = testDigestFields( digest, &soleTraceLegOutputTable, output->legs + i );
	}
	return digest;
}

/// Plays a trace: what is asked of the ground and what comes out in each frame. @return false where it is none
static bool testDigestTrace( const void* bytes, size_t byteCount, uint64_t* digest, int32_t* frameCount )
{
	static soleState memory;
	static soleOutput output;
	static soleProbe probes[SOLE_MAX_PROBES];
	soleTracePlayer* player;
	soleResult result = soleOpenTrace( bytes, byteCount, NULL, &player, NULL );
	const soleRig* rig = result == sole_success ? soleTracePlayer_GetRig( player ) : NULL;
	const soleTraceStep* step = NULL;
	while ( result == sole_success )
	{
		result = soleTracePlayer_Next( player, &step, NULL );
		if ( step == NULL )
		{
			break;
		}
		memory = step->state != NULL ? *step->state : memory;
		int32_t count = soleGatherProbes( rig, step->settings, &memory, step->frame, probes, SOLE_MAX_PROBES );
		*digest = testDigestWord( *digest, soleGetProbeChecksum( probes, count ) );
		soleSolve( rig, step->settings, &memory, step->frame, step->hits, step->hitCount, &output );
		*digest = testDigestOutput( *digest, &output );
		*frameCount += 1;
	}
	soleCloseTrace( player );
	return result == sole_success;
}

// ----------------------------------------------------------------------------------------------------------- crowds

#define MEMBERS 17 // one more than the widest lanes
#define CROWD_FRAMES 40
#define CROWD_PROBES ( MEMBERS * SOLE_MAX_PROBES )

/// Characters that set out one frame after another through the same trace.
typedef struct testCrowd
{
	soleTracePlayer* players[MEMBERS];
	const soleTraceStep* steps[MEMBERS];
	soleCrowd* crowd;
	void* work;
	soleFrame frames[MEMBERS];
	soleCrowdAsk asks[MEMBERS];
	soleProbe probes[CROWD_PROBES];
	soleHit hits[CROWD_PROBES];
} testCrowd;

static bool testOpenCrowd( const void* bytes, size_t byteCount, testCrowd* c )
{
	memset( c, 0, sizeof *c );
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		bool good = soleOpenTrace( bytes, byteCount, NULL, c->players + k, NULL ) == sole_success;
		for ( int32_t i = 0; i <= k && good; ++i )
		{
			good = soleTracePlayer_Next( c->players[k], c->steps + k, NULL ) == sole_success && c->steps[k] != NULL;
		}
		if ( good == false )
		{
			return false;
		}
	}
	soleCrowdDef def = soleDefaultCrowdDef();
	def.rig = soleTracePlayer_GetRig( c->players[0] );
	def.capacity = MEMBERS;
	def.settings = *c->steps[0]->settings;
	if ( soleCreateCrowd( &def, NULL, &c->crowd, NULL ) != sole_success )
	{
		return false;
	}
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		soleAddToCrowd( c->crowd );
	}
	c->work = malloc( soleCrowd_GetWorkSize( c->crowd, MEMBERS ) );
	return c->work != NULL;
}

static void testCloseCrowd( testCrowd* c )
{
	free( c->work );
	soleDestroyCrowd( c->crowd );
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		soleCloseTrace( c->players[k] );
	}
}

/// A frame of the crowd. Who sets out later asks for other places than were asked for in the trace: any answer will do.
static uint64_t testStepCrowd( testCrowd* c, uint64_t digest )
{
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		c->frames[k] = *c->steps[k]->frame;
	}
	soleGatherCrowd( c->crowd, 0, MEMBERS, c->frames, c->probes, CROWD_PROBES, c->asks, c->work );
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		const soleTraceStep* step = c->steps[k];
		for ( int32_t i = 0; i < c->asks[k].count; ++i )
		{
			soleHit miss = { .surface = SOLE_NONE };
			c->hits[c->asks[k].first + i] = step->hitCount > 0 ? step->hits[i % step->hitCount] : miss;
		}
	}
	soleSolveCrowd( c->crowd, 0, MEMBERS, c->frames, c->probes, c->hits, c->asks, c->work );
	for ( int32_t k = 0; k < MEMBERS; ++k )
	{
		digest = testDigestOutput( digest, soleCrowd_GetOutput( c->crowd, k ) );
	}
	return digest;
}

static bool testDigestCrowd( const void* bytes, size_t byteCount, uint64_t* digest )
{
	static testCrowd crowd;
	bool good = testOpenCrowd( bytes, byteCount, &crowd );
	for ( int32_t i = 0; i < CROWD_FRAMES && good; ++i )
	{
		*digest = testStepCrowd( &crowd, *digest );
		for ( int32_t k = 0; k < MEMBERS && good; ++k )
		{
			good = soleTracePlayer_Next( crowd.players[k], crowd.steps + k, NULL ) == sole_success &&
			    crowd.steps[k] != NULL;
		}
	}
	testCloseCrowd( &crowd );
	return good;
}

// ----------------------------------------------------------------------------------------------------------- output

static bool testPrintSolves( char** names, int count )
{
	char* bytes = malloc( MOST_TRACE_BYTES );
	uint64_t digest = DIGEST_START;
	uint64_t crowds = DIGEST_START;
	int32_t frameCount = 0;
	bool good = bytes != NULL;
	for ( int i = 0; i < count && good; ++i )
	{
		FILE* file = fopen( names[i], "rb" );
		size_t byteCount = file != NULL ? fread( bytes, 1, MOST_TRACE_BYTES, file ) : 0;
		if ( file != NULL )
		{
			fclose( file );
		}
		good =
		    testDigestTrace( bytes, byteCount, &digest, &frameCount ) && testDigestCrowd( bytes, byteCount, &crowds );
		if ( good == false )
		{
			printf( "\n%s cannot be played\n", names[i] );
		}
	}
	free( bytes );
	printf( " solves %016llx crowds %016llx (%d frames, up to %d wide)\n", (unsigned long long)digest,
	    (unsigned long long)crowds, (int)frameCount, (int)soleGetBatchWidth() );
	return good;
}

int main( int argc, char** argv )
{
	if ( !testPrintLegs() )
	{
		return 1;
	}
	printf( " limbs %016llx", (unsigned long long)testDigestLimbs() );
	printf( " ground %016llx", (unsigned long long)testDigestGround() );
	return testPrintSolves( argv + 1, argc - 1 ) ? 0 : 1;
}
