// SPDX-License-Identifier: MIT
// The tables of the ancestors' settings: each row reaches the field of its name, and no other.
#include "ancestor_run.h"
#include "baselines/ancestor_table.h"

#define KINDS 4

static soleAncestor start( soleAncestorKind kind )
{
	soleAncestor ancestor;
	memset( &ancestor, 0, sizeof ancestor );
	ancestor.kind = kind;
	switch ( kind )
	{
	case sole_ancestorHomebrew:
		ancestor.settings.homebrew = soleDefaultHomebrewSettings();
		break;
	case sole_ancestorIkSetting:
		ancestor.settings.ikSetting = soleDefaultIkSettingSettings();
		break;
	case sole_ancestorEffector:
		ancestor.settings.effector = soleDefaultEffectorSettings();
		break;
	default:
		ancestor.settings.ozz = soleDefaultOzzSettings();
	}
	return ancestor;
}

static const soleSettingInfo* findInfo( soleAncestorKind kind, const char* name )
{
	int32_t count = 0;
	const soleSettingInfo* infos = soleGetAncestorSettingInfos( kind, &count );
	for ( int32_t i = 0; i < count; ++i )
	{
		if ( strcmp( infos[i].name, name ) == 0 )
		{
			return infos + i;
		}
	}
	fail_msg( "there is no %s", name );
	return NULL;
}

static void tablesHaveTheDefaultsOfTheSystems( void** state )
{
	(void)state;
	const int32_t counts[KINDS] = { 20, 10, 10, 11 };
	for ( int32_t k = 0; k < KINDS; ++k )
	{
		soleAncestor ancestor = start( (soleAncestorKind)k );
		int32_t count = 0;
		const soleSettingInfo* infos = soleGetAncestorSettingInfos( (soleAncestorKind)k, &count );
		assert_int_equal( count, counts[k] );
		for ( int32_t i = 0; i < count; ++i )
		{
			double is = soleAncestor_GetSetting( &ancestor, infos + i );
			assert_true( fabs( is - infos[i].defaultValue ) < 1e-6 );
			assert_true( infos[i].minimum <= is && is <= infos[i].maximum );
			assert_int_equal( infos[i].text[strlen( infos[i].text ) - 1], '.' );
		}
	}
}

static void aRowChangesItsFieldAndNoOther( void** state )
{
	(void)state;
	for ( int32_t k = 0; k < KINDS; ++k )
	{
		int32_t count = 0;
		const soleSettingInfo* infos = soleGetAncestorSettingInfos( (soleAncestorKind)k, &count );
		for ( int32_t i = 0; i < count; ++i )
		{
			soleAncestor ancestor = start( (soleAncestorKind)k );
			double wanted = infos[i].type == sole_settingEnum ? 1.0 - infos[i].defaultValue : 7.0;
			soleAncestor_SetSetting( &ancestor, infos + i, (double)NAN );
			assert_true( fabs( soleAncestor_GetSetting( &ancestor, infos + i ) - infos[i].defaultValue ) < 1e-6 );
			soleAncestor_SetSetting( &ancestor, infos + i, wanted );
			for ( int32_t j = 0; j < count; ++j )
			{
				double other = j == i ? wanted : infos[j].defaultValue;
				assert_true( fabs( soleAncestor_GetSetting( &ancestor, infos + j ) - other ) < 1e-6 );
			}
		}
	}
}

static void namesAreThoseOfTheFields( void** state )
{
	(void)state;
	soleAncestor homebrew = start( sole_ancestorHomebrew );
	soleAncestor_SetSetting( &homebrew, findInfo( sole_ancestorHomebrew, "homebrew.crouchRange" ), 0.4 );
	soleAncestor_SetSetting( &homebrew, findInfo( sole_ancestorHomebrew, "homebrew.enableFootLifting" ), 0.0 );
	soleAncestor_SetSetting( &homebrew, findInfo( sole_ancestorHomebrew, "homebrew.groundLayers" ), 4294967295.0 );
	assert_float_equal( homebrew.settings.homebrew.crouchRange, 0.4f, 0.0f );
	assert_false( homebrew.settings.homebrew.enableFootLifting );
	assert_true( homebrew.settings.homebrew.groundLayers == UINT32_MAX );
	soleAncestor ik = start( sole_ancestorIkSetting );
	soleAncestor_SetSetting( &ik, findInfo( sole_ancestorIkSetting, "iksetting.pelvisUpAndDownSpeed" ), 0.5 );
	assert_float_equal( ik.settings.ikSetting.pelvisUpAndDownSpeed, 0.5f, 0.0f );
	soleAncestor effector = start( sole_ancestorEffector );
	soleAncestor_SetSetting( &effector, findInfo( sole_ancestorEffector, "effector.traceDistance" ), 80.0 );
	assert_float_equal( effector.settings.effector.traceDistance, 80.0f, 0.0f );
	soleAncestor ozz = start( sole_ancestorOzz );
	soleAncestor_SetSetting( &ozz, findInfo( sole_ancestorOzz, "ozz.footHeight" ), 0.2 );
	assert_float_equal( ozz.settings.ozz.footHeight, 0.2f, 0.0f );
}

int main( void )
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test( tablesHaveTheDefaultsOfTheSystems ),
		cmocka_unit_test( aRowChangesItsFieldAndNoOther ),
		cmocka_unit_test( namesAreThoseOfTheFields ),
	};
	return cmocka_run_group_tests( tests, NULL, NULL );
}
