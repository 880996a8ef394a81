#!/usr/bin/env bash
# Install into a scratch folder, then build a C and a C++ program against what is there: through the CMake
# package and through pkg-config. Arguments: the build folder, the source folder, the CMake generator.
set -euo pipefail
build=$1 source=$2 generator=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix

cmake --install "$build" --prefix "$prefix" > "$scratch/install.log"

# A library under a sanitizer wants programs under the same one.
sanitizer=$(sed -nE 's/^CMAKE_C_FLAGS_DEBUG:.*(-fsanitize=[^ ]+).*/\1/p' "$build/CMakeCache.txt")
compiler=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")

# CMake
cmake -G "$generator" -S "$source/tests/install" -B "$scratch/cmake" -DCMAKE_PREFIX_PATH="$prefix" \
    -DCMAKE_C_COMPILER="$compiler" -DCMAKE_C_FLAGS="$sanitizer" -DCMAKE_CXX_FLAGS="$sanitizer" > "$scratch/cmake.log" ||
    { cat "$scratch/cmake.log"; exit 1; }
cmake --build "$scratch/cmake" > "$scratch/cmake.log" || { cat "$scratch/cmake.log"; exit 1; }
"$scratch/cmake/consumer-c"
"$scratch/cmake/consumer-cpp"

# pkg-config
pc=$(dirname "$(find "$prefix" -name batten.pc)")
flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs batten batten-picture batten-design)
libdir=$(PKG_CONFIG_PATH=$pc pkg-config --variable=libdir batten)
"$compiler" -std=c17 $sanitizer "$source/tests/install/consumer.c" -o "$scratch/consumer" $flags -lm
LD_LIBRARY_PATH=$libdir "$scratch/consumer"

# The command, its manual, its completion. The sanitizers' runtime may object to a foreign process: no matter here.
"$prefix/bin/batten" --version | grep -q '^batten 0'
for file in share/man/man1/batten.1 share/man/man5/batten-design.5 share/bash-completion/completions/batten \
    share/batten/design.schema.json; do
    [ -s "$prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
bash -n "$prefix/share/bash-completion/completions/batten"
[ -e "$libdir/libbatten.so.0" ] || { echo "the library has no soname"; exit 1; }
echo "install: 1 passed, 0 failed, 0 skipped"
