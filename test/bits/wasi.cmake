# WebAssembly by Debian's clang and wasi-libc. With --sysroot alone the headers of this machine's own C library come
# first.
set( CMAKE_SYSTEM_NAME Generic )
set( CMAKE_SYSTEM_PROCESSOR wasm32 )
set( CMAKE_C_COMPILER clang-14 )
set( CMAKE_C_COMPILER_TARGET wasm32-wasi )
set( CMAKE_C_FLAGS_INIT "--sysroot=/usr -nostdlibinc -idirafter /usr/include/wasm32-wasi" )
set( CMAKE_AR llvm-ar-14 )
set( CMAKE_RANLIB llvm-ranlib-14 )
set( CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY )
set( CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,-z,stack-size=1048576" )
