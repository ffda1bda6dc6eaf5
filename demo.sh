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
echo "with its feet placed, and prints the figures of both side by side. Ends with a page that shows both. Writes to"
echo "build/demo and out."
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

# The page needs npm to be built, and is left out where that cannot be had.
page=build/report/template.html
if { scripts/setup.sh report && scripts/build_report.sh; } > build/demo/page.log 2>&1; then
	$sole report mannequin --ground course --template $page -o out/demo.html > /dev/null
else
	echo "The page out/demo.html is left out: its parts could not be had with npm (build/demo/page.log says why)."
	echo
	rm -f out/demo.html
fi

echo "Written:"
find out -maxdepth 1 -type f \( -name demo.glb -o -name demo.html -o -name '*.svg' \) -newer build/demo/build.log -printf '  %p  %k KiB\n' | sort
echo
echo "out/demo.glb holds the character, the ground and both clips (NAME|none and NAME|sole): open it in any glTF viewer"
echo "and switch between them. The SVG files plot the height of each foot over the ground: open them in a browser."
echo "More: $sole --help; and in the browser, to tune it: npm run viewer (docs/viewer.md)"
if [ -e out/demo.html ]; then
	echo
	echo "out/demo.html shows both side by side in 3D, with plots and figures: open it in a browser, by double click."
fi
