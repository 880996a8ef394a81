#!/bin/sh
# Every public header compiles alone, as C17 and as C++17.
# Usage: headers.sh SOURCE C-COMPILER C++-COMPILER
cd "$1" || exit 2
strict="-fsyntax-only -Wall -Wextra -Wpedantic -Werror -Iinclude"
failures=0

command -v "$3" > /dev/null || echo "skipped as C++: there is no $3"
for header in include/batten/*.h; do
    echo "#include <batten/${header##*/}>" | "$2" -x c -std=c17 -Wstrict-prototypes $strict - || failures=$((failures + 1))
    command -v "$3" > /dev/null || continue
    echo "#include <batten/${header##*/}>" | "$3" -x c++ -std=c++17 $strict - || failures=$((failures + 1))
done
[ "$failures" -eq 0 ] || echo "$failures headers do not compile alone"
[ "$failures" -eq 0 ]
