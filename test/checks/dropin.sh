#!/usr/bin/env bash
# include/ and src/ build with any C compiler and two include paths: no configure step, no generated file.
set -euo pipefail
cd "$(dirname "$0")/../.."

output=$( mktemp -d )
trap 'rm -rf "$output"' EXIT
mapfile -t sources < <( find src -name '*.c' | sort )
cc -std=c11 -Iinclude -Isrc "${sources[@]}" -shared -fPIC -o "$output/libsole.so" -lm
