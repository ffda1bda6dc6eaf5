#!/usr/bin/env bash
# Builds as a user would, installs, moves the installed tree, and builds a small project against it: with CMake and with
# pkg-config, static and shared.
set -euo pipefail
cd "$(dirname "$0")/../.."

work=$( mktemp -d )
trap 'rm -rf "$work"' EXIT

# check KIND ON|OFF
check()
{
	local build=build/install-$1 prefix=$work/$1/moved
	cmake -S . -B "$build" -G Ninja -DBUILD_SHARED_LIBS="$2"
	cmake --build "$build"
	cmake --install "$build" --prefix "$work/$1/first"
	mv "$work/$1/first" "$prefix"

	( cd include && find sole -type f | sort ) > "$work/headers"
	( cd "$prefix/include" && find . -type f -printf '%P\n' | sort ) | diff "$work/headers" -
	"$prefix/bin/sole" --version
	if [ -e build/report/template.html ]; then
		"$prefix/bin/sole" report mannequin --ground T01 --distance 1 -o "$work/report.html"
	fi
	if grep -rn 'sole_flags\|-W\|-ffp' "$prefix/lib/cmake" "$prefix/lib/pkgconfig"; then
		echo "Sole's own compile options leak into its packages" >&2
		return 1
	fi

	cmake -S test/consumer -B "$work/$1/consumer" -G Ninja -DCMAKE_PREFIX_PATH="$prefix"
	cmake --build "$work/$1/consumer"
	"$work/$1/consumer/consumer"

	local flags
	flags=$( PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs "sole >= 0.1" )
	# shellcheck disable=SC2086
	cc test/consumer/main.c $flags -o "$work/$1/consumer-pc"
	LD_LIBRARY_PATH=$prefix/lib "$work/$1/consumer-pc"
}

check static OFF
check shared ON
