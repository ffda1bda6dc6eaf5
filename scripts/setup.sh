#!/usr/bin/env bash
# Installs what Sole's scripts need on Debian 12 and does nothing where all of it is there.
# usage: scripts/setup.sh PURPOSE...    purposes: build, test, bench, report, viewer, wasm
set -euo pipefail
cd "$(dirname "$0")/.."

missing=()

# need PACKAGE [TOOL]: missing unless the tool is in the path or the package is installed.
need()
{
	if [ $# -gt 1 ] && command -v "$2" > /dev/null; then
		return
	fi
	if dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2> /dev/null | grep -q '^ii'; then
		return
	fi
	missing+=( "$1" )
}

needBuild()
{
	need gcc gcc
	need libc6-dev
	need cmake cmake
	need ninja-build ninja
	need pkg-config pkg-config
	need libjson-c-dev
}

needWasm()
{
	need clang-14 clang-14
	need llvm-14
	need lld-14
	need wasi-libc
	need libclang-rt-14-dev-wasm32
	need binaryen wasm-opt
	need nodejs node
	need npm npm
}

needViewer()
{
	needBuild
	needWasm
}

needReport()
{
	needBuild
	need nodejs node
	need npm npm
}

needTest()
{
	needViewer
	need chromium chromium
	need fonts-dejavu-core
	need g++ g++
	need libclang-rt-14-dev
	need clang-format-14 clang-format-14
	need clang-tidy-14 clang-tidy-14
	need libcmocka-dev
	need valgrind valgrind
	need gcc-aarch64-linux-gnu aarch64-linux-gnu-gcc
	need libc6-dev-arm64-cross
	need qemu-user qemu-aarch64
}

# What Sole is compared with is installed for the comparison alone.
needBench()
{
	need g++ g++
	need valgrind valgrind
	need gnuplot-nox gnuplot
	need libembree-dev
	need libode-dev
	need libbullet-dev
}

installMissing()
{
	if [ ${#missing[@]} -eq 0 ]; then
		return
	fi
	echo "setup: installing ${missing[*]}"
	if ! command -v apt-get > /dev/null; then
		echo "setup: there is no apt-get here: install these by hand" >&2
		return 1
	fi
	local asRoot=()
	if [ "$(id -u)" -ne 0 ]; then
		asRoot=( sudo )
	fi
	local apt=( "${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q )
	mkdir -p build
	if ! { "${apt[@]}" update && "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; } > build/setup.log 2>&1; then
		tail -n 20 build/setup.log >&2
		echo "setup: apt-get failed: the whole of what it said is in build/setup.log" >&2
		return 1
	fi
}

# The packages of package-lock.json, unless they are there and no older than it.
installNodePackages()
{
	local stamp=node_modules/.package-lock.json
	if [ -f $stamp ] && [ ! package-lock.json -nt $stamp ]; then
		return
	fi
	echo "setup: installing the packages of package-lock.json with npm"
	npm ci --no-audit --no-fund --loglevel=error
	touch $stamp
}

if [ $# -eq 0 ]; then
	echo "usage: scripts/setup.sh PURPOSE...    purposes: build, test, bench, report, viewer, wasm" >&2
	exit 2
fi
for purpose in "$@"; do
	case $purpose in
		build) needBuild ;;
		test) needTest ;;
		bench) needBench ;;
		report) needReport ;;
		viewer) needViewer ;;
		wasm) needWasm ;;
		*) echo "setup: there is no purpose '$purpose': use build, test, bench, report, viewer or wasm" >&2; exit 2 ;;
	esac
done
installMissing
for purpose in "$@"; do
	if [ "$purpose" != build ]; then
		installNodePackages
	fi
done
