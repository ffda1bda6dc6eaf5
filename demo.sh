#!/usr/bin/env bash
# Shows what Sole does: a walking character over a course of stairs, ramps and rubble, with and without foot placement.
set -euo pipefail
cd "$(dirname "$0")"
trap 'echo "demo: stopped at line $LINENO: what went wrong is said above" >&2' ERR

if [ $# -gt 0 ]; then
	echo "usage: ./demo.sh" >&2
	exit 2
fi

echo "Builds the program sole, lets the built-in mannequin walk over the built-in course, once as animated and once"
echo "with its feet placed, and prints the figures of both side by side. Writes to build/demo and out."
echo

scripts/setup.sh build
mkdir -p build/demo out
if ! { cmake -S . -B build/demo -G Ninja -DCMAKE_BUILD_TYPE=Release && cmake --build build/demo; } > build/demo/build.log 2>&1; then
	cat build/demo/build.log >&2
	echo "demo: the build failed" >&2
	exit 1
fi

sole=build/demo/tool/sole
command=( bake mannequin --ground course --method none --method sole --with-ground -o out/demo.glb --plots out )
echo "\$ sole ${command[*]}"
$sole "${command[@]}"
echo

echo "Written:"
find out -maxdepth 1 -type f \( -name demo.glb -o -name '*.svg' \) -newer build/demo/build.log -printf '  %p  %k KiB\n' | sort
echo
echo "out/demo.glb holds the character, the ground and both clips (NAME|none and NAME|sole): open it in any glTF viewer"
echo "and switch between them. The SVG files plot the height of each foot over the ground: open them in a browser."
echo "More: $sole --help; and in the browser, to tune it: npm run viewer (docs/viewer.md)"
