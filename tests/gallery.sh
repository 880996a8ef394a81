#!/usr/bin/env bash
# Build every design of the gallery, and see that every operation has a picture there.
# Arguments: the command, the source folder, the folder for the pictures.
set -euo pipefail
batten=$1 source=$2 out=$3
rm -rf "$out" && mkdir -p "$out"
failures=0 count=0

for design in "$source"/docs/gallery/*.yaml; do
    name=$(basename "$design" .yaml)
    count=$((count + 1))
    if ! "$batten" build "$design" -o "$out" -q; then
        echo "gallery: $name cannot be built"
        failures=$((failures + 1))
    elif ! [ -s "$out/$name.png" ]; then
        echo "gallery: $name leaves no picture $name.png"
        failures=$((failures + 1))
    fi
    grep -q "gallery/$name.png" "$source/docs/gallery.md" || { echo "gallery: docs/gallery.md does not show $name; run ./dev docs"; failures=$((failures + 1)); }
    [ -s "$source/docs/gallery/$name.png" ] || { echo "gallery: docs/gallery/$name.png is missing; run ./dev docs"; failures=$((failures + 1)); }
done

for operation in $("$batten" help features | sed -nE 's/^  ([a-z-]+) .*/\1/p'); do
    count=$((count + 1))
    grep -qE "[{ ]$operation:" "$source"/docs/gallery/*.yaml ||
        { echo "gallery: the operation '$operation' has no picture"; failures=$((failures + 1)); }
done
echo "gallery: $((count - failures)) passed, $failures failed, 0 skipped"
[ "$failures" = 0 ]
