#!/usr/bin/env bash
# What the program writes passes the glTF validator: every sample, a bake, and whatever the tests left in a folder
# `written` or the demo in out. Needs build/release.
set -euo pipefail
cd "$(dirname "$0")/../.."

sole=build/release/tool/sole
written=build/release/written
mkdir -p $written
status=0
for name in $( $sole sample --list | sed 's/ .*//' ); do
	$sole sample "$name" -o "$written/sample_$name.glb" || status=1
done
$sole bake mannequin --ground course --with-ground -o $written/bake.glb || status=1

mapfile -t files < <( find build out -name '*.glb' \( -path '*/written/*' -o -path 'out/*' \) 2> /dev/null | sort )
echo "${#files[@]} files"
[ ${#files[@]} -gt 0 ]
node test/validate_glb.mjs "${files[@]}" || status=1
exit $status
