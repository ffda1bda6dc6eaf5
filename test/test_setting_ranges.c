// SPDX-License-Identifier: MIT
// What counts as settings in their ranges, and what counts as finite floats: each end, what lies next to it, and what
// is no number.
#include "test.h"

#include "base/math_internal.h"
#include "rig/settings.h"

#include <math.h>

static soleSettingRanges s_ranges;

/// All defaults but one setting's bits.
static bool areInRangeWith( const soleSettingInfo* info, uint32_t bits )
{
	soleSettings settings = soleDefaultSettings();
	memcpy( (char*)&settings + info->offset, &bits, sizeof bits );
	return soleSettings_AreInRange( &settings, &s_ranges );
}

static bool areInRangeWithFloat( const soleSettingInfo* info, float value )
{
	uint32_t bits;
	memcpy( &bits, &value, sizeof bits );
	return areInRangeWith( info, bits );
}

static int fillRanges( void** state )
{
	(void)state;
	soleFillSettingRanges( &s_ranges );
	return 0;
}

static void floatsAreInRangeFromEndToEnd( void** state )
{
	(void)state;
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( infos[i].type != sole_settingFloat )
		{
			continue;
		}
		float low = (float)infos[i].minimum;
		float high = (float)infos[i].maximum;
		assert_true( areInRangeWithFloat( infos + i, low ) );
		assert_true( areInRangeWithFloat( infos + i, 0.5f * low + 0.5f * high ) );
		assert_true( areInRangeWithFloat( infos + i, high ) );
		assert_false( areInRangeWithFloat( infos + i, nextafterf( low, -1e9f ) ) );
		assert_false( areInRangeWithFloat( infos + i, nextafterf( high, 1e9f ) ) );
		assert_int_equal( areInRangeWithFloat( infos + i, -0.0f ), low <= 0.0f );
		assert_false( areInRangeWithFloat( infos + i, INFINITY ) );
		assert_false( areInRangeWithFloat( infos + i, -INFINITY ) );
		assert_false( areInRangeWith( infos + i, 0x7fc00000u ) ); // no number, of either sign
		assert_false( areInRangeWith( infos + i, 0xffc00000u ) );
	}
}

static void integersAreInRangeFromEndToEnd( void** state )
{
	(void)state;
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		bool any = infos[i].type == sole_settingMask;
		if ( infos[i].type != sole_settingFloat )
		{
			assert_true( areInRangeWith( infos + i, 0 ) );
			assert_true( areInRangeWith( infos + i, (uint32_t)infos[i].maximum ) );
			assert_int_equal( areInRangeWith( infos + i, (uint32_t)infos[i].maximum + 1u ), any );
			assert_int_equal( areInRangeWith( infos + i, 0xffffffffu ), any ); // minus one
			assert_int_equal( areInRangeWith( infos + i, 0x80000000u ), any ); // the least of all
		}
	}
}

static void oneThatIsNotFiniteIsFoundAnywhere( void** state )
{
	(void)state;
	float floats[37];
	for ( size_t i = 0; i < 37; ++i )
	{
		floats[i] = i % 2 == 0 ? 3.4e38f : -1e-45f;
	}
	assert_true( soleAreFinite( floats, sizeof floats ) );
	const float bad[3] = { INFINITY, -INFINITY, NAN };
	for ( size_t i = 0; i < 37; ++i )
	{
		float kept = floats[i];
		for ( size_t k = 0; k < 3; ++k )
		{
			floats[i] = bad[k];
			assert_false( soleAreFinite( floats, sizeof floats ) );
		}
		floats[i] = kept;
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( floatsAreInRangeFromEndToEnd ),
		cmocka_unit_test( integersAreInRangeFromEndToEnd ),
		cmocka_unit_test( oneThatIsNotFiniteIsFoundAnywhere ),
	};
	return cmocka_run_group_tests( tests, fillRanges, NULL );
}
