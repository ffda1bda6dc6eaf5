#!/usr/bin/env bash
# Every GLB that the program wrote in the tests or the demo passes the glTF validator.
set -euo pipefail
cd "$(dirname "$0")/../.."

mapfile -t files < <( find build out -name '*.glb' \( -path '*/written/*' -o -path 'out/*' \) 2> /dev/null | sort )
echo "${#files[@]} files"
[ ${#files[@]} -gt 0 ]
node test/validate_glb.mjs "${files[@]}"
