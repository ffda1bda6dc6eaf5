#!/usr/bin/env bash
# The viewer in a real browser: builds it with the samples of build/release, and drives all of it.
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH=$PWD/node_modules/.bin:$PATH

scripts/build_viewer.sh build/release/tool/sole
node --test --test-concurrency=1 --test-reporter=spec viewer/test/*.test.mjs
