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
$sole bake mannequin --ground course --with-ground -o $written/bake.glb > /dev/null || status=1

# A file with faults of its own may keep them, but gets no new ones. Left out where the real characters are not there.
data=../shared/data
if [ -d $data ]; then
	mkdir -p $written/real
	while read -r character clip; do
		out=$written/real/$( basename "$character" | sed 's/\..*//' ).glb
		$sole bake "$data/$character" --clip "$clip" --ground stairs --method none --method sole --with-ground -o "$out" \
			> /dev/null || status=1
		node test/validate_glb.mjs --baseline "$data/$character" "$out" || status=1
	done <<- LIST
		human-quaternius-ual/human-base-animations.glb Walk_Loop
		human-pab-rootmotion/pab_arnaud.glb walk
		human-mesh2motion-ue-names/human-addon-animations.glb Tired Hunched
		human-dcl-emotes/walk.glb Walk_Male
		mocap-bvh/cmu_02_01_walk.glb 02_01
	LIST
else
	echo "left out: $data is not there"
fi

mapfile -t files < <( find build out -name '*.glb' \( -path '*/written/*' -not -path '*/real/*' -o -path 'out/*' \) 2> /dev/null | sort )
echo "${#files[@]} files"
[ ${#files[@]} -gt 0 ]
node test/validate_glb.mjs "${files[@]}" || status=1
exit $status
