#!/usr/bin/env bash
# Compile the kernel for other systems with the cross compilers that are installed; nothing is run. What is absent is
# skipped and named. Arguments: the systems (all without any): mingw wasm musl i686.
set -uo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
jobs=$(getconf _NPROCESSORS_ONLN 2> /dev/null || echo 2)
failures=0

# cross NAME COMPILER [OPTION OF cmake...]: the static libbatten, without optimisation, which is all that is asked.
cross()
{
    local name=$1 compiler=$2 build=$source/build/cross/$1
    shift 2
    if ! command -v "$compiler" > /dev/null; then
        echo "skipped: $name: there is no $compiler"
        return
    fi
    mkdir -p "$build"
    if cmake -S "$source" -B "$build" -G Ninja -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
        -DCMAKE_C_FLAGS_DEBUG=-O0 -DBUILD_SHARED_LIBS=OFF -DBATTEN_PICTURE=OFF -DBATTEN_DESIGN=OFF -DBATTEN_TESTS=OFF \
        -DBATTEN_EXAMPLES=OFF "$@" > "$build/log" 2>&1 && cmake --build "$build" -j "$jobs" -- -k 0 >> "$build/log" 2>&1; then
        echo "$name: libbatten builds, $(grep -c 'warning:' "$build/log") warnings"
    else
        echo "$name: FAILED: $(grep -c '^FAILED' "$build/log") files"
        grep -E 'error|Error' "$build/log" | grep -vE '^(ninja|FAILED)' | sort -u | head -20
        failures=$((failures + 1))
    fi
}

[ $# -gt 0 ] || set -- mingw wasm musl i686
for name in "$@"; do
    case $name in
    mingw) cross mingw x86_64-w64-mingw32-gcc -DCMAKE_SYSTEM_NAME=Windows ;;
    wasm)
        if [ -d /usr/include/wasm32-wasi ]; then
            cross wasm clang -DCMAKE_SYSTEM_NAME=Generic -DCMAKE_C_COMPILER_TARGET=wasm32-wasi \
                -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY
        else
            echo "skipped: wasm: there is no wasi-libc"
        fi
        ;;
    musl) cross musl musl-gcc ;;
    i686) cross i686 i686-linux-gnu-gcc -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=i686 ;;
    *) echo "unknown system $name: mingw wasm musl i686" && exit 2 ;;
    esac
done
exit $((failures > 0))
