#!/usr/bin/env bash
# Header, library, program and change file name the same version. Needs build/release.
set -euo pipefail
cd "$(dirname "$0")/../.."

number()
{
	sed -n "s/^#define SOLE_VERSION_$1 \([0-9]*\)$/\1/p" include/sole/base.h
}

header="$( number MAJOR ).$( number MINOR ).$( number PATCH )"
program=$( build/release/tool/sole --version )
changes=$( sed -n 's/^## \[\([0-9.]*\)\].*/\1/p' CHANGELOG.md | head -n 1 )
cmake=$( sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt )
echo "header $header, program '$program', CMake $cmake, CHANGELOG.md $changes"
[ "$program" = "sole $header" ] && [ "$cmake" = "$header" ] && [ "$changes" = "$header" ]
