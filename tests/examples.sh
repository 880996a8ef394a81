#!/usr/bin/env bash
# Build the examples' designs and compare their reports, to the letter, with those that stand beside them.
# Arguments: the command, the source folder, the folder for the results.
set -euo pipefail
batten=$1 source=$2 out=$3
failures=0 count=0
for design in hull/hull sharpie/sharpie wing/wing; do
    count=$((count + 1))
    folder=$out/${design%/*}
    rm -rf "$folder" && mkdir -p "$folder"
    if ! "$batten" build "$source/examples/$design.yaml" -o "$folder" -q; then
        echo "examples: $design.yaml cannot be built"
        failures=$((failures + 1))
    elif ! diff "$source/examples/${design%/*}/report.txt" "$folder/report.txt"; then
        echo "examples: the report of $design.yaml is not the expected one; look at it, then copy it there"
        failures=$((failures + 1))
    fi
done
echo "examples: $((count - failures)) passed, $failures failed, 0 skipped"
[ "$failures" = 0 ]
