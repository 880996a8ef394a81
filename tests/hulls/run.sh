#!/usr/bin/env bash
# From the tables of five real hulls to fair surfaces: every output is there, no point moved
# farther than 5 mm, no inflection was added, and the surface keeps to the faired table.
# Arguments: the command, the source folder, the folder for the outputs.
set -euo pipefail
batten=$1 source=$2 out=$3
data=$source/../shared/data/hull_offsets
[ -d "$data" ] || { echo "hulls: the tables are not here"; exit 77; }
rm -rf "$out" && mkdir -p "$out"
failures=0 count=0

fail() { echo "hulls: $1"; failures=$((failures + 1)); }

# at_most VALUE BOUND WHAT
at_most() {
    count=$((count + 1))
    awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && a + 0 <= b + 0) }' || fail "$3: $1 is above $2"
}

# What the reports REPORT... say must hold for each: BOUND is that of the distance from the faired table.
check_report() {
    local report=$1 name=$2 bound=$3 numbers
    numbers=$(grep -oE '"moved": \{"max": [-+.0-9e]+' "$report" | grep -oE '[-+.0-9e]+$')
    [ -n "$numbers" ] || fail "$name: no move is reported"
    for move in $numbers; do at_most "$move" 0.005 "$name: largest move"; done
    while read -r before after; do
        at_most "$after" "$before" "$name: inflections in excess"
    done < <(sed -nE 's/.*"excess_inflections": \{"before": ([0-9]+), "after": ([0-9]+).*/\1 \2/p' "$report")
    numbers=$(grep -oE '"faired": true, "points": [0-9]+, "max": [-+.0-9e]+' "$report" | sed 's/.* //')
    [ -n "$numbers" ] || fail "$name: no distance from the faired table is reported"
    for distance in $numbers; do at_most "$distance" "$bound" "$name: distance from the faired table"; done
}

hull() {
    local name=$1 bound=$2 file
    if ! "$batten" build "$source/tests/hulls/$name.yaml" --allow-outside -o "$out/$name" -q; then
        fail "$name cannot be built"
        return
    fi
    for file in "$name.step" "$name.igs" lines.pdf shaded.png zebra.png gaussian.png report.txt report.json; do
        count=$((count + 1))
        [ -s "$out/$name/$file" ] || fail "$name leaves no $file"
    done
    for file in "$out/$name"/*.json; do check_report "$file" "$name" "$bound"; done
}

hull s60 0.0005
hull px121 0.0005
hull gunnerus 0.0005
hull sharpie 0.000001
hull dory 0.000001
echo "hulls: $((count - failures)) of $count hold"
[ "$failures" = 0 ]
