#!/usr/bin/env bash
# Builds the library for WebAssembly and lays the npm package out in build/wasm: sole.wasm and, for engines with SIMD,
# sole-simd.wasm; sole-debug.wasm and sole-debug-simd.wasm draw and replay traces besides. Nothing is imported: a module
# runs wherever WebAssembly does.
# usage: scripts/build_wasm.sh
set -euo pipefail
cd "$(dirname "$0")/.."

output=build/wasm
binding=bindings/wasm
mkdir -p $output

# What JavaScript calls. All else that is not needed for it is left out.
names=( malloc free
	soleGetVersion soleDefaultSettings soleGetSettingInfos soleSettings_Get soleSettings_Set
	soleDefaultRigDef soleDefaultLegDef soleCreateRig soleDestroyRig soleRig_GetLeg soleRig_GetLegLength soleDetectRig
	soleState_GetByteCount soleState_Reset
	soleDefaultGroundDef soleDefaultGroundMesh soleDefaultHeightField soleDefaultGroundPlane soleCreateGround
	soleDestroyGround soleCastProbe soleCastPieces soleGround_GetBounds soleGround_GetTriangleCount
	soleCreateTerrain soleDestroyTerrain soleMakeMeasurePoints soleDefaultLabelDef soleLabelContacts soleFindSteps
	soleFindClipFloor soleFindStrideVelocity soleGetStepInput soleStepInput_Travel soleExtrapolate soleDefaultMeasureDef soleMeasureMotion
	soleWasm_CreateCharacter soleWasm_Gather soleWasm_CastGround soleWasm_CastPieces soleWasm_Solve )
debugNames=( soleMakeBufferSink soleCreateTracer soleDestroyTracer soleTracer_BeginFrame soleTracer_EndFrame
	soleTracer_Finish soleReplayTrace soleGetDrawInfos soleWasm_Draw )

target=( --target=wasm32-wasi --sysroot=/usr )
# Small before fast: a solve takes microseconds either way. No contraction, for the same bits as everywhere.
flags=( "${target[@]}" -nostdlibinc -idirafter /usr/include/wasm32-wasi -std=c11 -Oz -flto -DNDEBUG
	-ffp-contract=off -fno-math-errno -fno-builtin-malloc -fno-builtin-calloc
	-mnontrapping-fptoint -msign-ext -mbulk-memory
	-Wall -Wextra -pedantic -Wshadow -Wconversion -Wundef -Wdouble-promotion -Werror -Iinclude -Isrc -I$binding )
optimize=( -Oz --low-memory-unused --converge --strip-producers --const-hoisting
	--enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext )

# compile FOLDER FLAG...
compile()
{
	local folder=$output/$1
	shift
	rm -rf "$folder"
	mkdir -p "$folder"
	find src $binding -name '*.c' -not -name fields.c -print0 | sort -z |
		xargs -0 -P 2 -I FILE bash -c '
			folder=$1 file=$2
			shift 2
			clang-14 "$@" -c "$file" -o "$folder/$( tr / _ <<< "${file%.c}" ).o"' _ "$folder" FILE "${flags[@]}" "$@"
}

# link OBJECTS OUT EXPORT...: the stack lies below everything else, so that running out of it stops the call instead of
# overwriting what is there.
link()
{
	local objects=$output/$1 out=$2
	shift 2
	clang-14 "${target[@]}" -nostartfiles -mexec-model=reactor -flto "$objects"/*.o -o "$out" \
		-Wl,--no-entry,--strip-all,--gc-sections,--lto-O2,--stack-first,-z,stack-size=524288 "${@/#/-Wl,--export=}"
}

# build SUFFIX FLAG WASM-OPT-FLAG
build()
{
	local folder=objects$1
	compile "$folder" $2
	link "$folder" $output/sole.raw.wasm "${names[@]}"
	wasm-opt "${optimize[@]}" $3 $output/sole.raw.wasm -o "$output/sole$1.wasm"
	link "$folder" $output/sole.raw.wasm "${names[@]}" "${debugNames[@]}"
	wasm-opt "${optimize[@]}" $3 $output/sole.raw.wasm -o "$output/sole-debug$1.wasm"
	rm -rf $output/sole.raw.wasm "${output:?}/$folder"
}

build '' '' ''
build -simd -msimd128 --enable-simd

mkdir -p $output/fields
clang-14 "${flags[@]}" -c $binding/fields.c -o $output/fields/fields.o
link fields $output/fields.wasm soleWasm_GetFields soleWasm_CountFields
cp $binding/*.js $binding/*.d.ts $binding/package.json $binding/README.md LICENSE $output/
node $output/make_layout.js $output/fields.wasm > $output/layout.js
rm -rf $output/fields $output/fields.wasm $output/make_layout.js
ls -l $output/*.wasm
