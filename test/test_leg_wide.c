// SPDX-License-Identifier: MIT
// Legs many at once: in every width that this machine has, to the bit, what one leg alone gets; whatever numbers come
// in; and nothing beyond the range is touched.
#include "test.h"

#include "base/math_internal.h"
#include "place/leg_wide.h"

#define COUNT 4096
#define IN 34
#define OUT 15

typedef struct Batch
{
	float in[IN][COUNT];
	float out[OUT][COUNT];
	uint32_t flags[COUNT];
	soleLegBatch batch;
} Batch;

static soleArray3 array3( float ( *rows )[COUNT] )
{
	return ( soleArray3 ){ rows[0], rows[1], rows[2] };
}

static soleArray4 array4( float ( *rows )[COUNT] )
{
	return ( soleArray4 ){ rows[0], rows[1], rows[2], rows[3] };
}

static void begin( Batch* b )
{
	memset( b, 0, sizeof *b );
	b->batch = ( soleLegBatch ){
		.count = COUNT,
		.hip = array3( b->in + 0 ),
		.knee = array3( b->in + 3 ),
		.ankle = array3( b->in + 6 ),
		.target = array3( b->in + 9 ),
		.hinge = array3( b->in + 12 ),
		.reach = b->in[15],
		.fold = b->in[16],
		.softZone = b->in[17],
		.parent = array4( b->in + 18 ),
		.thigh = array4( b->in + 22 ),
		.shin = array4( b->in + 26 ),
		.foot = array4( b->in + 30 ),
		.thigh_l = array4( b->out + 0 ),
		.shin_l = array4( b->out + 4 ),
		.foot_l = array4( b->out + 8 ),
		.reached = array3( b->out + 12 ),
		.flags = b->flags,
	};
}

static void put3( soleArray3 a, int32_t i, soleVec3 v )
{
	a.x[i] = v.x;
	a.y[i] = v.y;
	a.z[i] = v.z;
}

static void putTurn( soleArray4 a, int32_t i, uint32_t* seed )
{
	soleQuat q = { testRandomFloat( seed, -1.0f, 1.0f ), testRandomFloat( seed, -1.0f, 1.0f ),
		testRandomFloat( seed, -1.0f, 1.0f ), testRandomFloat( seed, -1.0f, 1.0f ) };
	q = soleNormalizeQuat( q );
	a.x[i] = q.x;
	a.y[i] = q.y;
	a.z[i] = q.z;
	a.w[i] = q.w;
}

static soleVec3 any3( uint32_t* seed, float size )
{
	return soleVec( testRandomFloat( seed, -size, size ), testRandomFloat( seed, -size, size ),
	    testRandomFloat( seed, -size, size ) );
}

/// Legs as they are, straight and folded ones, targets in and out of reach, at the hip and behind.
static void fillLegs( Batch* b, uint32_t seed )
{
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		soleVec3 hip = any3( &seed, 3.0f );
		soleVec3 way = soleNormalizeOr( any3( &seed, 1.0f ), soleVec( 0.0f, -1.0f, 0.0f ) );
		float bend = i % 5 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 0.3f );
		soleVec3 side = soleAnyOrthogonal( way );
		soleVec3 knee = soleMulAdd( soleMulAdd( hip, 0.45f, way ), bend, side );
		soleVec3 ankle = soleMulAdd( hip, i % 7 == 0 ? 0.1f : 0.9f, way );
		soleVec3 target = soleAdd( ankle, any3( &seed, 0.4f ) );
		target = i % 11 == 0 ? hip : ( i % 13 == 0 ? soleMulAdd( hip, -0.8f, way ) : target );
		target = i % 17 == 0 ? ankle : target;
		knee = i % 19 == 0 ? hip : knee;
		put3( b->batch.hip, i, hip );
		put3( b->batch.knee, i, knee );
		put3( b->batch.ankle, i, ankle );
		put3( b->batch.target, i, target );
		put3( b->batch.hinge, i, i % 23 == 0 ? soleVec( 0.0f, 0.0f, 0.0f ) : soleCross( side, way ) );
		b->batch.reach[i] = testRandomFloat( &seed, 0.9f, 1.0f );
		b->batch.fold[i] = testRandomFloat( &seed, 0.0f, 0.4f );
		b->batch.softZone[i] = i % 3 == 0 ? 0.0f : testRandomFloat( &seed, 0.0f, 0.1f );
		putTurn( b->batch.parent, i, &seed );
		putTurn( b->batch.thigh, i, &seed );
		putTurn( b->batch.shin, i, &seed );
		putTurn( b->batch.foot, i, &seed );
	}
}

/// Numbers of every kind in any place.
static void fillAnything( Batch* b, uint32_t seed )
{
	static const float odd[] = { 0.0f, -0.0f, INFINITY, -INFINITY, NAN, 1e-40f, 3e38f, -3e38f, 1e-13f, 1.0f };
	fillLegs( b, seed );
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		for ( int32_t k = 0; k < 3; ++k )
		{
			uint32_t row = testRandom( &seed ) % IN;
			b->in[row][i] = odd[testRandom( &seed ) % ( sizeof odd / sizeof *odd )];
		}
	}
}

static void assertSame( const Batch* a, const Batch* b, int32_t width )
{
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		for ( int32_t k = 0; k < OUT; ++k )
		{
			float x = a->out[k][i], y = b->out[k][i];
			bool none = x != x && y != y;
			if ( none == false && memcmp( &x, &y, sizeof x ) != 0 )
			{
				fail_msg( "width %d, leg %d, number %d: %a and %a", width, i, k, (double)x, (double)y );
			}
		}
		assert_int_equal( a->flags[i], b->flags[i] );
	}
}

static Batch s_one, s_wide;

static void compare( void ( *fill )( Batch*, uint32_t ) )
{
	const int32_t widths[] = { 4, 8, 16 };
	for ( uint32_t seed = 1; seed < 9; ++seed )
	{
		begin( &s_one );
		fill( &s_one, seed );
		soleGetLegLanes( 1 )( &s_one.batch, 0, COUNT );
		for ( int32_t k = 0; k < 3 && widths[k] <= soleGetBatchWidth(); ++k )
		{
			begin( &s_wide );
			fill( &s_wide, seed );
			soleGetLegLanes( widths[k] )( &s_wide.batch, 0, COUNT );
			assertSame( &s_one, &s_wide, widths[k] );
		}
	}
}

static void everyLaneIsOneLeg( void** state )
{
	(void)state;
	print_message( "width %d\n", soleGetBatchWidth() );
	compare( fillLegs );
	uint32_t all = 0;
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		all |= s_one.flags[i];
	}
	assert_int_equal( all, (uint32_t)( sole_legSoftened | sole_legOutOfReach | sole_legFolded | sole_legDegenerate ) );
}

static void whateverComesInEveryLaneIsOneLeg( void** state )
{
	(void)state;
	compare( fillAnything );
}

static void aRangeIsAllThatIsWritten( void** state )
{
	(void)state;
	begin( &s_one );
	fillLegs( &s_one, 3 );
	soleGetLegLanes( 1 )( &s_one.batch, 0, COUNT );
	const int32_t ranges[][2] = { { 0, 0 }, { 5, 1 }, { 17, 3 }, { 33, 61 }, { 1000, 37 } };
	for ( int32_t k = 0; k < 5; ++k )
	{
		int32_t first = ranges[k][0], end = ranges[k][0] + ranges[k][1];
		begin( &s_wide );
		fillLegs( &s_wide, 3 );
		memset( s_wide.flags, 0x55, sizeof s_wide.flags );
		soleSolveLegBatch( &s_wide.batch, first, end - first );
		for ( int32_t i = 0; i < COUNT; ++i )
		{
			bool in = i >= first && i < end;
			assert_int_equal( s_wide.flags[i], in ? s_one.flags[i] : 0x55555555u );
			assert_true( in ? s_wide.out[14][i] == s_one.out[14][i] : s_wide.out[14][i] == 0.0f );
		}
	}
}

static void theFootIsWhereItIsWanted( void** state )
{
	(void)state;
	begin( &s_one );
	fillLegs( &s_one, 5 );
	soleSolveLegBatch( &s_one.batch, 0, COUNT );
	const soleLegBatch* b = &s_one.batch;
	int32_t met = 0;
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		soleVec3 hip = soleVec( b->hip.x[i], b->hip.y[i], b->hip.z[i] );
		soleVec3 knee = soleSub( soleVec( b->knee.x[i], b->knee.y[i], b->knee.z[i] ), hip );
		soleVec3 ankle = soleSub( soleVec( b->ankle.x[i], b->ankle.y[i], b->ankle.z[i] ), hip );
		float sine = soleLength( soleCross( knee, ankle ) ) / ( soleLength( knee ) * soleLength( ankle ) );
		if ( b->flags[i] != 0 || !( sine > 0.2f ) )
		{
			continue;
		}
		met += 1;
		assert_true( fabsf( b->reached.x[i] - b->target.x[i] ) < 1e-4f );
		assert_true( fabsf( b->reached.y[i] - b->target.y[i] ) < 1e-4f );
		// By the chain: the parent's turn, then the three new ones.
		soleQuat turn = { b->parent.x[i], b->parent.y[i], b->parent.z[i], b->parent.w[i] };
		const soleArray4 chain[] = { b->thigh_l, b->shin_l, b->foot_l };
		for ( int32_t k = 0; k < 3; ++k )
		{
			soleQuat q = { chain[k].x[i], chain[k].y[i], chain[k].z[i], chain[k].w[i] };
			turn = soleMulQuat( turn, q );
		}
		soleQuat foot = { b->foot.x[i], b->foot.y[i], b->foot.z[i], b->foot.w[i] };
		assert_true( fabsf( soleDotQuat( turn, foot ) ) > 1.0f - 1e-5f );
	}
	assert_true( met > COUNT / 8 );
}

static void misuseIsRefused( void** state )
{
	(void)state;
	soleSetAssertHandler( testQuietHandler );
	begin( &s_one );
	memset( s_one.flags, 0x55, sizeof s_one.flags );
	soleSolveLegBatch( NULL, 0, 4 );
	soleSolveLegBatch( &s_one.batch, -1, 4 );
	soleSolveLegBatch( &s_one.batch, 0, COUNT + 1 );
	soleSolveLegBatch( &s_one.batch, COUNT, 1 );
	soleSolveLegBatch( &s_one.batch, 4, -4 );
	for ( int32_t i = 0; i < COUNT; ++i )
	{
		assert_int_equal( s_one.flags[i], 0x55555555u );
	}
	soleSetAssertHandler( NULL );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( everyLaneIsOneLeg ),
		cmocka_unit_test( whateverComesInEveryLaneIsOneLeg ),
		cmocka_unit_test( aRangeIsAllThatIsWritten ),
		cmocka_unit_test( theFootIsWhereItIsWanted ),
		cmocka_unit_test( misuseIsRefused ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
