#!/usr/bin/env bash
# Builds the library for WebAssembly and lays the npm package out in build/wasm: sole.wasm and, for engines with SIMD,
# sole-simd.wasm; sole-debug.wasm and sole-debug-simd.wasm draw and replay traces besides. Nothing is imported: a module
# runs wherever WebAssembly does. build/wasm/page has what the viewer alone uses: page/sole-methods.wasm, the systems
# that Sole is compared with, and page/sole-stages.wasm, which tells its caller when a stage of the solver has ended.
# usage: scripts/build_wasm.sh
set -euo pipefail
cd "$(dirname "$0")/.."

output=build/wasm
binding=bindings/wasm
mkdir -p $output/page

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

methodNames=( malloc free soleGetSettingInfos soleDefaultSettings soleSettings_Get soleSettings_Set
	soleDefaultRigDef soleDefaultLegDef soleCreateRig soleDestroyRig soleRig_GetLegLength soleState_GetByteCount soleApply
	soleDefaultGroundDef soleDefaultGroundMesh soleDefaultHeightField soleDefaultGroundPlane soleCreateGround
	soleDestroyGround soleGround_GetTriangleCount soleCastProbe soleCastPieces
	soleWasm_CreateCharacter soleWasm_CastGround soleWasm_CastPieces
	soleAncestor_GetByteCount soleStartAncestor soleGatherAncestor soleSolveAncestor
	soleGetAncestorSettingInfos soleAncestor_GetSetting soleAncestor_SetSetting soleDrawAncestor soleWasm_MakePen )
stageNames=( malloc free soleReplayTrace )

target=( --target=wasm32-wasi --sysroot=/usr )
# Small before fast: a solve takes microseconds either way. No contraction, for the same bits as everywhere.
features=( -Oz -mnontrapping-fptoint -msign-ext -mbulk-memory )
flags=( "${target[@]}" "${features[@]}" -nostdlibinc -idirafter /usr/include/wasm32-wasi -std=c11 -DNDEBUG
	-DSOLE_SETTING_TEXTS=0 -ffp-contract=off -fno-math-errno -fno-builtin-malloc -fno-builtin-calloc
	-Wall -Wextra -pedantic -Wshadow -Wconversion -Wundef -Wdouble-promotion -Werror -Iinclude -Isrc -I$binding )
# All of it is made small at once, as one program: what headers have put into every file is merged while it is still the
# same everywhere, before it is inlined and specialised, and what looks alike afterwards becomes a function of its own.
passes='internalize,globaldce,mergefunc,lto<Oz>'
passes+=',function(simplifycfg<sink-common-insts;hoist-common-insts>,gvn-hoist,dse,adce)'
passes+=',iroutliner,function(sroa,instcombine,simplifycfg),globaldce'
# What code generation calls by itself, besides what is exported.
runtime=( malloc calloc free memcpy memmove memset strlen )
optimize=( --low-memory-unused --flatten --rereloop -Oz -Oz --strip-producers --const-hoisting
	--enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext )

# compile FOLDER SOURCE FLAG...: all sources below a folder, or one, as bitcode that is not optimised yet. The table of
# fields has to be named.
compile()
{
	local folder=$output/$1 source=$2
	shift 2
	mkdir -p "$folder"
	find "$source" -name '*.c' \( -not -name fields.c -o -path "$source" \) -print0 | sort -z |
		xargs -0 -P 2 -I FILE bash -c '
			folder=$1 file=$2
			shift 2
			clang-14 "$@" -emit-llvm -Xclang -disable-llvm-passes -c "$file" -o "$folder/$( tr / _ <<< "${file%.c}" ).bc"' _ "$folder" FILE "${flags[@]}" "$@"
}

# link OBJECTS OUT EXPORT...: the stack lies below everything else, so that running out of it stops the call instead of
# overwriting what is there.
link()
{
	local objects=$output/$1 out=$2 whole=$output/whole
	shift 2
	local kept=( "${runtime[@]}" "$@" )
	llvm-link-14 "$objects"/*.bc -o $whole.bc
	opt-14 -passes="$passes" -internalize-public-api-list="$( IFS=,; echo "${kept[*]}" )" $whole.bc -o $whole.small.bc
	clang-14 "${target[@]}" "${features[@]}" -mllvm -disable-lsr -c $whole.small.bc -o $whole.o
	clang-14 "${target[@]}" -nostartfiles -mexec-model=reactor $whole.o -o "$out" \
		-Wl,--entry=__wasm_call_ctors,--strip-all,--gc-sections,--stack-first,-z,stack-size=524288 "${@/#/-Wl,--export=}"
	rm $whole.bc $whole.small.bc $whole.o
}

# build SUFFIX FLAG WASM-OPT-FLAG
build()
{
	local folder=objects$1
	rm -rf "${output:?}/$folder"
	compile "$folder" src $2
	compile "$folder" $binding $2
	link "$folder" $output/sole.raw.wasm "${names[@]}"
	wasm-opt "${optimize[@]}" $3 $output/sole.raw.wasm -o "$output/sole$1.wasm"
	link "$folder" $output/sole.raw.wasm "${names[@]}" "${debugNames[@]}"
	wasm-opt "${optimize[@]}" $3 $output/sole.raw.wasm -o "$output/sole-debug$1.wasm"
}

# page NAME EXPORT...: a module of the objects without SIMD that only the viewer uses.
page()
{
	local name=$1
	shift
	link objects $output/sole.raw.wasm "$@"
	wasm-opt "${optimize[@]}" $output/sole.raw.wasm -o "$output/page/$name.wasm"
}

build '' '' ''
build -simd -msimd128 --enable-simd
compile objects baselines -I.
page sole-methods "${methodNames[@]}"
compile objects src/place/place.c -include $binding/page/stage_hook.h
page sole-stages "${stageNames[@]}"
rm -rf $output/sole.raw.wasm $output/objects $output/objects-simd

compile fields $binding/fields.c
compile fields $binding/memory.c
compile fields src/rig/settings.c -USOLE_SETTING_TEXTS
link fields $output/fields.wasm malloc soleWasm_GetFields soleWasm_CountFields soleGetSettingInfos
cp $binding/page/*.js $binding/page/*.d.ts $output/page/
cp $binding/*.js $binding/*.d.ts $binding/package.json $binding/README.md LICENSE $output/
node $output/make_layout.js $output/fields.wasm > $output/layout.js
rm -rf $output/fields $output/fields.wasm $output/make_layout.js
ls -l $output/*.wasm $output/page/*.wasm
