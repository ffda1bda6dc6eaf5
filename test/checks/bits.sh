#!/usr/bin/env bash
# The same bits everywhere: test/bits/bits.c built by gcc and clang, with and without optimisation, for machines with
# and without fused operations, lanes one by one, for AArch64 (NEON) and WebAssembly, prints the same digests as the
# first build. A line a build. Needs build/release, whose program records the walks that are solved again.
set -euo pipefail
cd "$(dirname "$0")/../.."

output=$PWD/build/bits
sole=$PWD/build/release/tool/sole
data=../shared/data
traces=()
expected=
status=0
mkdir -p "$output/traces"

# record CHARACTER CLIP GROUND
record()
{
	local trace=$output/traces/$( basename "$1" .glb )-$2-$3.trace
	"$sole" bake "$1" --clip "$2" --ground "$3" -o "$output/traces/baked.glb" --trace "$trace" > /dev/null
	traces+=( "$trace" )
}

for walk in "mannequin walk flat" "mannequin run stairs" "mannequin walk ramp" "mannequin walk rubble" \
	"mannequin walk course" "mannequin walk T16-2" \
	"$data/human-quaternius-ual/human-base-animations.glb Walk_Loop rubble" "$data/human-pab-rootmotion/pab_arnaud.glb walk stairs"; do
	read -r character clip ground <<< "$walk"
	if [ "$character" = mannequin ] || [ -e "$character" ]; then
		record "$character" "$clip" "$ground"
	else
		echo "left out: walks of $character, which is not there"
	fi
done

# run NAME COMMAND...: the digests of one build, compared with those of the first.
run()
{
	local name=$1 said digests
	shift
	if ! said=$( "$@" "${traces[@]}" 2>&1 ); then
		echo "$name: FAILED: $said"
		status=1
		return
	fi
	digests=${said%% (*}
	expected=${expected:-$digests}
	if [ "$digests" = "$expected" ]; then
		printf '%-37s %s\n' "$name" "$said"
	else
		printf '%-37s %s DIFFERENT\n' "$name" "$said"
		status=1
	fi
}

# build FOLDER FLAGS OPTION...: into build/bits/FOLDER.
build()
{
	local folder=$output/$1 flags=$2
	shift 2
	if ! { cmake -S test/bits -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release "-DCMAKE_C_FLAGS_RELEASE=$flags" "$@" &&
		cmake --build "$folder"; } > "$output/build.log" 2>&1; then
		cat "$output/build.log"
		return 1
	fi
}

# native FOLDER COMPILER FLAGS
native()
{
	build "$1" "$3" -DCMAKE_C_COMPILER="$2"
	run "$2 $3" "$output/$1/sole_bits"
}

# has NAME TOOL...: or says what is left out.
has()
{
	local name=$1 tool
	shift
	for tool in "$@"; do
		if ! command -v "$tool" > /dev/null; then
			echo "$name: left out: $tool is not there"
			return 1
		fi
	done
}

native gcc-O0 gcc -O0
native gcc-O3 gcc -O3
native gcc-plain gcc "-O3 -DSOLE_SIMD_SCALAR=1"
if has clang clang-14; then
	native clang-O0 clang-14 -O0
	native clang-O3 clang-14 -O3
fi
if [ "$( uname -m )" = x86_64 ]; then
	for lanes in "8 avx2" "16 avx512f"; do
		grep -qw "${lanes#* }" /proc/cpuinfo || echo "${lanes% *} wide: left out: this machine has no ${lanes#* }"
	done
	# Fused operations are at hand, and must not be taken.
	if grep -qw fma /proc/cpuinfo; then
		native gcc-fma gcc "-O3 -march=x86-64-v3"
		native clang-fma clang-14 "-O3 -march=x86-64-v3"
	else
		echo "-march=x86-64-v3: left out: this machine has no fma"
	fi
	if has "processors without AVX-512, and without AVX" qemu-x86_64; then
		run "gcc -O3, a processor without AVX-512" qemu-x86_64 -cpu max "$output/gcc-O3/sole_bits"
		run "gcc -O3, a processor of 2008" qemu-x86_64 -cpu Nehalem "$output/gcc-O3/sole_bits"
	fi
fi
if has AArch64 aarch64-linux-gnu-gcc qemu-aarch64; then
	for level in -O0 -O3; do
		build "aarch64$level" "$level" -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64 \
			-DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc
		run "AArch64 gcc $level" qemu-aarch64 -L /usr/aarch64-linux-gnu "$output/aarch64$level/sole_bits"
	done
fi
# Some versions of node crash where WASI is called by V8's fast path.
wasi=( node --no-warnings --no-turbo-fast-api-calls test/bits/run_wasi.mjs )
if has WebAssembly clang-14 wasm-ld-14 llvm-ar-14 node; then
	for flags in -O0 -O3 "-O3 -msimd128"; do
		build "wasm${flags// /}" "$flags" -DCMAKE_TOOLCHAIN_FILE="$PWD/test/bits/wasi.cmake"
		run "WebAssembly clang-14 $flags" "${wasi[@]}" "$output/wasm${flags// /}/sole_bits"
	done
fi
exit $status
