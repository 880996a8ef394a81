#!/bin/sh
# Another program reads what Batten wrote: batten-witness-models makes the files, FreeCAD without a window
# checks them. Exit status 77, which is a skipped test, when it is not installed.
models=$1
here=$(cd "$(dirname "$0")" && pwd)
program=$(command -v freecadcmd || command -v FreeCADCmd) || {
    echo "skipped: FreeCAD (freecadcmd) is not installed"
    exit 77
}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
"$models" "$folder" || exit 1
names=$(cd "$folder" && ls | grep -Ev 'csv|expect' | tr '\n' ' ')
FOLDER=$folder NAMES=$names HOME=$folder "$program" "$here/check.py" > "$folder/log" 2>&1
grep -E "faces|solids|WITNESS|Error|Traceback" "$folder/log"
grep -q "WITNESS .* 0 files failed" "$folder/log"
