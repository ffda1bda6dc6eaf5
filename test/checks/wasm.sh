#!/usr/bin/env bash
# The WebAssembly modules and their JavaScript: builds the package and runs its tests. Needs build/release and the
# packages of package-lock.json.
set -euo pipefail
cd "$(dirname "$0")/../.."

scripts/build_wasm.sh
# What a user gets with `npm install`.
ln -sfn ../build/wasm node_modules/sole
rm -rf build/wasm/test-files
node --test bindings/wasm/test/*.test.mjs
