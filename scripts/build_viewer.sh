#!/usr/bin/env bash
# Builds the viewer into build/viewer: a folder of files that any web server can hand out from any path. The samples in
# it are written by the program.
# usage: scripts/build_viewer.sh [SOLE]    SOLE: the program; built into build/release where it is not given
set -euo pipefail
cd "$(dirname "$0")/.."

sole=${1:-}
if [ -z "$sole" ]; then
	cmake -S . -B build/program -G Ninja -DCMAKE_BUILD_TYPE=Release > /dev/null
	cmake --build build/program --target sole_program > /dev/null
	sole=build/program/tool/sole
fi
PATH=$PWD/node_modules/.bin:$PATH

# The package for JavaScript is the last thing that its script writes.
if [ ! -e build/wasm/layout.js ] || [ -n "$( find src include bindings baselines scripts/build_wasm.sh -newer build/wasm/layout.js -print -quit )" ]; then
	scripts/build_wasm.sh > /dev/null
fi

public=build/viewer-public/samples
rm -rf build/viewer-public
mkdir -p $public
"$sole" sample --list --json > $public/samples.json
for name in $( "$sole" sample --list | sed 's/ .*//' ); do
	"$sole" sample "$name" -o "$public/$name.glb" > /dev/null
done

tsc -p viewer
vite build viewer --logLevel warn
