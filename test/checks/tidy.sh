#!/usr/bin/env bash
# clang-tidy over the library, the baselines and the program, with the checks of .clang-tidy. Needs build/release for the flags.
set -euo pipefail
cd "$(dirname "$0")/../.."

find src baselines tool -name '*.c' -print0 | sort -z |
	xargs -0 -n 1 -P 2 clang-tidy-14 -p build/release --quiet 2> >( grep -v 'warnings generated\|warning generated' >&2 )
