#!/bin/sh
# Meshes of one solid in every format, read by a program that knows nothing of Batten. Exit status 77, which is a
# skipped test, without Python. Usage: meshes.sh BATTEN FOLDER-OF-THIS
batten=$1
here=$2
command -v python3 > /dev/null && python3 -c 'import zipfile' 2> /dev/null || {
    echo "skipped: Python (python3) is not installed"
    exit 77
}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
for ending in stl ply obj glb 3mf; do
    "$batten" convert -q --from-unit mm "$here/solid.off" "$folder/solid.$ending" || exit 1
done
python3 "$here/meshes.py" "$folder"
