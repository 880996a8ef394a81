#!/bin/sh
# The promise of the same bits, tried.
#   run.sh here COMPILER BATTEN-BITS FOLDER    the elementary functions, and what the features make, with the variants that glibc
#                                              picks for processors without FMA and AVX2 against those of this one
#   run.sh systems FOLDER                      the elementary functions with every compiler and system that is installed
#   run.sh compare FOLDER BATTEN-BITS...       what the features make, of several builds
# What is not installed is named and skipped.
top=$(cd "$(dirname "$0")/../.." && pwd)
status=0
plain='GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2,-AVX2_Usable,-FMA_Usable'

# same NAME FIRST SECOND: the lists are equal, or the first lines that differ.
same()
{
    if [ -s "$2" ] && cmp -s "$2" "$3"; then
        echo "same bits: $1, $(wc -l < "$2") lines"
    else
        echo "OTHER BITS: $1"
        diff "$2" "$3" | head -6
        status=1
    fi
}

# functions NAME RUNNER COMPILER OPTION...: build the elementary functions alone and compare with the recorded list.
functions()
{
    name=$1 runner=$2 compiler=$3
    shift 3
    if ! command -v "$compiler" > /dev/null; then
        echo "skipped: $name: there is no $compiler"
        return
    fi
    built=$folder/functions-$name
    # shellcheck disable=SC2086
    if ! "$compiler" "$@" -std=c17 -ffp-contract=off -I"$top/src" -I"$top/include" "$top/tests/bits/functions.c" \
        "$top"/src/base/elementary/*.c -o "$built" -lm 2> "$built.log"; then
        echo "skipped: $name: $compiler $* cannot build it: $(head -1 "$built.log")"
        return
    fi
    # shellcheck disable=SC2086
    if ! $runner "$built" > "$built.txt" 2> "$built.log"; then
        echo "skipped: $name: it cannot be run here: $(head -1 "$built.log")"
        return
    fi
    tr -d '\r' < "$built.txt" > "$built.unix.txt"
    same "elementary functions, $name" "$top/tests/bits/functions.txt" "$built.unix.txt"
}

kind=$1
shift
case $kind in
here)
    compiler=$1 program=$2 folder=$3
    mkdir -p "$folder"
    functions "$(basename "$compiler")" "" "$compiler" -O2
    "$program" "$folder" > "$folder/all.txt" || status=1
    env "$plain" "$program" "$folder" > "$folder/plain.txt" || status=1
    same "features, FMA and AVX2 off" "$folder/all.txt" "$folder/plain.txt"
    ;;
systems)
    folder=$1
    mkdir -p "$folder"
    for level in 0 1 2 3; do
        functions gcc-O$level "" gcc -O$level
        functions clang-O$level "" clang -O$level
    done
    functions gcc-native "" gcc -O3 -march=native
    functions clang-native "" clang -O3 -march=native
    functions musl "" musl-gcc -O2 -static
    functions i686 "" i686-linux-gnu-gcc -O2 -msse2 -mfpmath=sse -static
    functions wasm "node --no-warnings $top/tests/bits/wasi.mjs" clang --target=wasm32-wasi -O2
    functions mingw.exe wine x86_64-w64-mingw32-gcc -O2 -D__USE_MINGW_ANSI_STDIO=1
    functions s390x qemu-s390x-static s390x-linux-gnu-gcc -O2 -static
    functions arm64 qemu-aarch64-static aarch64-linux-gnu-gcc -O2 -static
    ;;
compare)
    folder=$1
    shift
    mkdir -p "$folder"
    number=0
    for program in "$@"; do
        number=$((number + 1))
        "$program" "$folder" > "$folder/build-$number.txt" || status=1
        [ $number = 1 ] || same "features, $program" "$folder/build-1.txt" "$folder/build-$number.txt"
    done
    ;;
*)
    echo "run.sh: here, systems or compare"
    status=2
    ;;
esac
exit $status
