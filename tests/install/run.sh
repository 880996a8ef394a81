#!/usr/bin/env bash
# Install into a scratch folder, then build a C and a C++ program against what is there: through the CMake
# package and through pkg-config. Arguments: the build folder, the source folder, the CMake generator, and
# `shared`, or `static`: then the libraries are built anew, static and without optimisation, in BUILD/static.
set -euo pipefail
build=$1 source=$2 generator=$3 kind=${4:-shared}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
prefix=$scratch/prefix

# A library under a sanitizer wants programs under the same one.
sanitizer=$(sed -nE 's/^CMAKE_C_FLAGS_DEBUG:.*(-fsanitize=[^ ]+).*/\1/p' "$build/CMakeCache.txt")
compiler=$(sed -n 's/^CMAKE_C_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")

# quiet COMMAND...: its output is of interest when it fails.
quiet()
{
    "$@" > "$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
}

if [ "$kind" = static ]; then
    quiet cmake -G "$generator" -S "$source" -B "$build/static" -DBUILD_SHARED_LIBS=OFF -DBATTEN_TESTS=OFF \
        -DBATTEN_EXAMPLES=OFF -DCMAKE_C_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Debug \
        -DCMAKE_C_FLAGS_DEBUG="-O0 $sanitizer"
    quiet cmake --build "$build/static"
    build=$build/static
fi
quiet cmake --install "$build" --prefix "$prefix"
pc=$(dirname "$(find "$prefix" -name batten.pc)")
export PKG_CONFIG_PATH=$pc
libdir=$(pkg-config --variable=libdir batten)

# CMake: the consumer asks for a version, and a program for another version is turned away.
package()
{
    cmake -G "$generator" -S "$source/tests/install" -B "$scratch/cmake-$1" -DCMAKE_PREFIX_PATH="$prefix" -DWANTED="$1" \
        -DCMAKE_C_COMPILER="$compiler" -DCMAKE_C_FLAGS="$sanitizer" -DCMAKE_CXX_FLAGS="$sanitizer"
}
version=$("$prefix/bin/batten" --version | sed -nE '1s/^batten ([0-9.]+).*/\1/p')
minor=$(echo "$version" | cut -d. -f2)
quiet package "0.$minor"
quiet cmake --build "$scratch/cmake-0.$minor"
"$scratch/cmake-0.$minor/consumer-c"
"$scratch/cmake-0.$minor/consumer-cpp"
package "0.$((minor + 1))" > /dev/null 2>&1 && { echo "find_package took $version for a later version"; exit 1; }
if [ "$minor" -gt 0 ] && package "0.$((minor - 1))" > /dev/null 2>&1; then
    echo "find_package took $version for an older minor version, which may differ before 1.0"
    exit 1
fi

# pkg-config
flags=$(pkg-config --cflags --libs batten batten-picture batten-design)
"$compiler" -std=c17 $sanitizer "$source/tests/install/consumer.c" -o "$scratch/consumer" $flags -lm
LD_LIBRARY_PATH=$libdir "$scratch/consumer"

# The command, its manual, its completion. The sanitizers' runtime may object to a foreign process: no matter here.
for file in share/man/man1/batten.1 share/man/man5/batten-design.5 share/bash-completion/completions/batten \
    share/batten/design.schema.json; do
    [ -s "$prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
if [ -d "$build/man3" ]; then
    [ -s "$prefix/share/man/man3/batten_curve_interpolate.3" ] || { echo "not installed: the manual pages of calls"; exit 1; }
fi
bash -n "$prefix/share/bash-completion/completions/batten"
if [ "$kind" = static ]; then
    [ -e "$libdir/libbatten.a" ] || { echo "there is no static library"; exit 1; }
    sh "$source/tests/symbols.sh" "$libdir"/*.a
    for program in "$scratch/consumer" "$scratch/cmake-0.$minor/consumer-c" "$prefix/bin/batten"; do
        ! ldd "$program" | grep -q libbatten || { echo "$program wants a shared library"; exit 1; }
    done
elif [ "$(uname)" = Linux ]; then
    [ -e "$libdir/libbatten.so.0.$minor" ] || { echo "the library has no soname 0.$minor"; exit 1; }
fi
echo "install-$kind: 1 passed, 0 failed, 0 skipped"
