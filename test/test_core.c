// SPDX-License-Identifier: MIT
#include "test.h"

#include "sole/base.h"

static void versionOfLibraryIsThatOfHeaders( void** state )
{
	(void)state;
	soleVersion version = soleGetVersion();
	assert_int_equal( version.major, SOLE_VERSION_MAJOR );
	assert_int_equal( version.minor, SOLE_VERSION_MINOR );
	assert_int_equal( version.patch, SOLE_VERSION_PATCH );
}

int main( void )
{
	const struct CMUnitTest tests[] = { cmocka_unit_test( versionOfLibraryIsThatOfHeaders ) };
	return cmocka_run_group_tests( tests, NULL, NULL );
}
