#!/usr/bin/env bash
# Writes the page that compares all methods of the program: walks of the mannequin and, where their files are there, of
# real characters, over stairs, ramps and rubble. The page is all generated.
# usage: scripts/make_comparison.sh SOLE PAGE [GROUND...]    SOLE: the program; SOLE_DATA: folder of real characters
set -euo pipefail

if [ $# -lt 2 ]; then
	echo "usage: scripts/make_comparison.sh SOLE PAGE [GROUND...]" >&2
	exit 2
fi
sole=$( realpath "$1" )
page=$2
shift 2
grounds=( "$@" )
if [ ${#grounds[@]} -eq 0 ]; then
	grounds=( T02 T03 T11-10 T11-20 T11-30 T17 rubble )
fi
data=${SOLE_DATA:-$( dirname "$0" )/../../shared/data}
floor=ground-ozz-footik-floor/floor.obj
floorWay=( --start "-5,-1" --heading 90 --distance 8 ) # up a slope, over its crest and down

work=$( mktemp -d )
trap 'rm -rf "$work"' EXIT
walks=()

# compare NAME CHARACTER CLIP OPTION...: the tables of one walk. Files are named without their folders in the page.
compare()
{
	local name=$1 character=$2 clip=$3
	shift 3
	echo "$name" >&2
	( cd "$work" && "$sole" compare "$character" --clip "$clip" --markdown "$@" ) > "$work/tables.$name"
	walks+=( "$name" )
}

# walk NAME CHARACTER CLIP: over all grounds, and over the floor of the ozz sample where it is there.
walk()
{
	local scenes=() ground
	for ground in "${grounds[@]}"; do
		scenes+=( --ground "$ground" )
	done
	compare "$@" "${scenes[@]}"
	if [ -e "$data/$floor" ]; then
		cp "$data/$floor" "$work"
		compare "$1 on the ozz floor" "$2" "$3" --ground "$( basename "$floor" )" "${floorWay[@]}"
	fi
}

walk "mannequin" mannequin walk
for entry in "quaternius human-quaternius-ual/human-base-animations.glb Walk_Loop" "pab human-pab-rootmotion/pab_arnaud.glb walk"; do
	read -r name file clip <<< "$entry"
	if [ -e "$data/$file" ]; then
		walk "$name" "$( realpath "$data/$file" )" "$clip"
	fi
done

# sums: what is said of a walk over all its grounds.
sums()
{
	local name
	for name in "${walks[@]}"; do
		echo "- **$name**: $( tail -n 1 "$work/tables.$name" )"
	done
}

# lost: the grounds on which the first method is not best in everything, or does not plant.
lost()
{
	local name
	for name in "${walks[@]}"; do
		sed -n -e '/^Grounds: /d' -e "/ is best or equal in .*; not in /s/^/- $name, /p" -e "/Does not plant: .*\\bsole\\b/s/^/- $name, /p" \
			"$work/tables.$name"
	done
}

# Everything of the page, on stdout.
writePage()
{
	echo "<!-- Made by scripts/make_comparison.sh build/release/tool/sole docs/comparison.md: change that, not this. -->"
	cat <<- 'TEXT'
		# Methods side by side

		Walks baked by every method that the program has, over the same grounds, along the same ways, at 60 frames a
		second, measured by the same ruler. [measuring.md](measuring.md) says what each figure means, when a method
		counts as planting, and what "best or equal" is. Bold is the best of a column, and what equals it, among the
		methods that plant; `none` is the clip moved over the ground with its feet untouched, and is never judged: what
		it is good at, it is by doing nothing.

		| method | is |
		|---|---|
	TEXT
	"$sole" compare --help | sed -n '/^Methods:/,$p' | sed -e 1d -e 's/^ *\([^ ]*\) */| \1 | /' -e 's/$/ |/'
	printf '\n## In short\n\n'
	sums
	printf '\n## Where Sole is not the best\n\n'
	if [ -z "$( lost )" ]; then
		echo "On none of these grounds is another method that plants better in any figure."
	else
		lost
	fi
	cat <<- 'TEXT'

		To be best is not to be good: which targets Sole misses today, and by how much, stands in `test/test_table.c`,
		and `sole measure CHARACTER --table` marks them. Knee, pelvis and jump are ratios to the clip untouched on flat
		ground: what is over 1.00 is the price of standing on this one. Where `none` drifts less or deviates less, it
		does so in the air or under the ground.

		## The grounds

		| ground | is |
		|---|---|
	TEXT
	local ground
	for ground in "${grounds[@]}"; do
		"$sole" sample --list | sed -n "s/^$ground  *\\(.*\\), [0-9]* triangles\$/| $ground | \\1 |/p"
	done
	if [ -e "$work/$( basename "$floor" )" ]; then
		echo "| floor.obj | the floor of ozz-animation's foot IK sample: 8 m over a slope and down again |"
	fi
	local name
	for name in "${walks[@]}"; do
		printf '\n## %s\n\n' "${name^}"
		cat "$work/tables.$name"
	done
}

writePage > "$work/page"
# Beside the page first: it is written whole or not at all.
cp "$work/page" "$page.tmp"
mv "$page.tmp" "$page"
