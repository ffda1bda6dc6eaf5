// SPDX-License-Identifier: MIT
// Legs many at once: in every width that this machine has, to the bit, what one leg alone gets; whatever numbers come
// in; and nothing beyond the range is touched.
#include "test.h"

#include "base/math_internal.h"
#include "leg_batch.h"
#include "place/leg_wide.h"

static void assertSame( const testBatch* a, const testBatch* b, int32_t width )
{
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
	{
		for ( int32_t k = 0; k < BATCH_OUT; ++k )
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

static testBatch s_one, s_wide;

static void compare( testFillBatchFcn* fill )
{
	const int32_t widths[] = { 4, 8, 16 };
	for ( uint32_t seed = 1; seed < 9; ++seed )
	{
		testBeginBatch( &s_one );
		fill( &s_one, seed );
		soleGetLegLanes( 1 )( &s_one.batch, 0, BATCH_COUNT );
		for ( int32_t k = 0; k < 3 && widths[k] <= soleGetBatchWidth(); ++k )
		{
			testBeginBatch( &s_wide );
			fill( &s_wide, seed );
			soleGetLegLanes( widths[k] )( &s_wide.batch, 0, BATCH_COUNT );
			assertSame( &s_one, &s_wide, widths[k] );
		}
	}
}

static void everyLaneIsOneLeg( void** state )
{
	(void)state;
	print_message( "width %d\n", soleGetBatchWidth() );
	compare( testFillLegs );
	uint32_t all = 0;
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
	{
		all |= s_one.flags[i];
	}
	assert_int_equal( all, (uint32_t)( sole_legSoftened | sole_legOutOfReach | sole_legFolded | sole_legDegenerate ) );
}

static void whateverComesInEveryLaneIsOneLeg( void** state )
{
	(void)state;
	compare( testFillAnything );
}

static void aRangeIsAllThatIsWritten( void** state )
{
	(void)state;
	testBeginBatch( &s_one );
	testFillLegs( &s_one, 3 );
	soleGetLegLanes( 1 )( &s_one.batch, 0, BATCH_COUNT );
	const int32_t ranges[][2] = { { 0, 0 }, { 5, 1 }, { 17, 3 }, { 33, 61 }, { 1000, 37 } };
	for ( int32_t k = 0; k < 5; ++k )
	{
		int32_t first = ranges[k][0], end = ranges[k][0] + ranges[k][1];
		testBeginBatch( &s_wide );
		testFillLegs( &s_wide, 3 );
		memset( s_wide.flags, 0x55, sizeof s_wide.flags );
		soleSolveLegBatch( &s_wide.batch, first, end - first );
		for ( int32_t i = 0; i < BATCH_COUNT; ++i )
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
	testBeginBatch( &s_one );
	testFillLegs( &s_one, 5 );
	soleSolveLegBatch( &s_one.batch, 0, BATCH_COUNT );
	const soleLegBatch* b = &s_one.batch;
	int32_t met = 0;
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
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
	assert_true( met > BATCH_COUNT / 8 );
}

static void misuseIsRefused( void** state )
{
	(void)state;
	soleSetAssertHandler( testQuietHandler );
	testBeginBatch( &s_one );
	memset( s_one.flags, 0x55, sizeof s_one.flags );
	soleSolveLegBatch( NULL, 0, 4 );
	soleSolveLegBatch( &s_one.batch, -1, 4 );
	soleSolveLegBatch( &s_one.batch, 0, BATCH_COUNT + 1 );
	soleSolveLegBatch( &s_one.batch, BATCH_COUNT, 1 );
	soleSolveLegBatch( &s_one.batch, 4, -4 );
	for ( int32_t i = 0; i < BATCH_COUNT; ++i )
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
