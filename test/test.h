// SPDX-License-Identifier: MIT
// What every test file needs: cmocka in its order of inclusion, real data where it is there, small comparisons.
#ifndef TEST_TEST_H
#define TEST_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "random.h"

#include "sole/math.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/// Path of a file of the real data, or NULL where the data is not there: the test then says so and is skipped.
static inline const char* testData( const char* name )
{
	static char path[1024];
	snprintf( path, sizeof path, "%s/%s", SOLE_DATA_DIR, name );
	FILE* file = fopen( path, "rb" );
	if ( file == NULL )
	{
		return NULL;
	}
	fclose( file );
	return path;
}

/// For tests over real data: skips the test, saying what was left out, where the file is not there.
#define TEST_NEEDS_DATA( name )                                                                                        \
	do                                                                                                                 \
	{                                                                                                                  \
		if ( testData( name ) == NULL )                                                                                \
		{                                                                                                              \
			print_message( "left out: %s is not there\n", name );                                                      \
			skip();                                                                                                    \
		}                                                                                                              \
	} while ( 0 )

/// For tests of misuse: an assert says nothing and the call goes on.
static inline bool testQuietHandler( const char* condition, const char* file, int line )
{
	(void)condition;
	(void)file;
	(void)line;
	return false;
}

static inline void testNear3( soleVec3 a, soleVec3 b, float tolerance )
{
	assert_float_equal( a.x, b.x, tolerance );
	assert_float_equal( a.y, b.y, tolerance );
	assert_float_equal( a.z, b.z, tolerance );
}

#endif
