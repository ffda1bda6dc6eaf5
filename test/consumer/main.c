// SPDX-License-Identifier: MIT
// Links calls of the library and an inline function of its headers, and compares their versions.
#include "sole/detect.h"
#include "sole/ground.h"
#include "sole/measure.h"
#include "sole/sole.h"

#include <stdio.h>

int main( void )
{
	soleVersion version = soleGetVersion();
	bool sameVersion = version.major == SOLE_VERSION_MAJOR && version.minor == SOLE_VERSION_MINOR &&
	    version.patch == SOLE_VERSION_PATCH;
	bool length = soleLength( soleVec( 3.0f, 4.0f, 0.0f ) ) == 5.0f;
	soleSettings settings = soleDefaultSettings();
	bool filled = settings.internalValue == SOLE_COOKIE;
	printf( "consumer: sole %d.%d.%d\n", version.major, version.minor, version.patch );
	return sameVersion && length && filled ? 0 : 1;
}
