// SPDX-License-Identifier: MIT
// The table of settings is complete, in order, and the source of the defaults.
#include "test.h"

#include "sole/sole.h"

static void tableCoversTheWholeStructInOrder( void** state )
{
	(void)state;
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	// Every field is four bytes: the table must have one row for each, without a gap, up to the cookie.
	for ( int32_t i = 0; i < count; ++i )
	{
		assert_int_equal( infos[i].offset, 4 * i );
	}
	assert_int_equal( offsetof( soleSettings, internalValue ), 4 * (size_t)count );
}

static void defaultsAreThoseOfTheTableAndInRange( void** state )
{
	(void)state;
	soleSettings settings = soleDefaultSettings();
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		assert_true( infos[i].minimum <= infos[i].defaultValue && infos[i].defaultValue <= infos[i].maximum );
		assert_float_equal( soleSettings_Get( &settings, infos + i ), infos[i].defaultValue, 1e-6 );
		assert_true( strchr( infos[i].name, '.' ) != NULL );
		assert_true( infos[i].text[strlen( infos[i].text ) - 1] == '.' );
	}
}

static void settingClampsAndIgnoresWhatIsNoNumber( void** state )
{
	(void)state;
	soleSettings settings = soleDefaultSettings();
	int32_t count;
	const soleSettingInfo* infos = soleGetSettingInfos( &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		soleSettings_Set( &settings, infos + i, (double)NAN );
		assert_float_equal( soleSettings_Get( &settings, infos + i ), infos[i].defaultValue, 1e-6 );
		soleSettings_Set( &settings, infos + i, -1e9 );
		assert_float_equal( soleSettings_Get( &settings, infos + i ), infos[i].minimum, 1e-6 );
		soleSettings_Set( &settings, infos + i, 1e12 );
		assert_float_equal( soleSettings_Get( &settings, infos + i ), infos[i].maximum, 1e-6 );
	}
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( tableCoversTheWholeStructInOrder ),
		cmocka_unit_test( defaultsAreThoseOfTheTableAndInRange ),
		cmocka_unit_test( settingClampsAndIgnoresWhatIsNoNumber ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
