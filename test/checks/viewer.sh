#!/usr/bin/env bash
# The viewer and the page of a report in a real browser: builds them with the program of build/release, and drives all
# of both.
set -euo pipefail
cd "$(dirname "$0")/../.."
PATH=$PWD/node_modules/.bin:$PATH

scripts/build_viewer.sh build/release/tool/sole
scripts/build_report.sh
node --test --test-concurrency=1 --test-reporter=spec viewer/test/*.test.mjs
