#!/bin/sh
# A folder of src/ includes only itself and the folders before it in this list; the sister libraries and the
# programs see the public headers alone; the sisters also the inline helpers of base, and the vectors and boxes of numeric.
# Usage: layers.sh SOURCE
cd "$1" || exit 2
allowed="."
bad=""

includes() { # the quoted includes of a folder: FILE:LINE:#include "folder/file.h"
    find "$1" -name '*.[ch]' -exec grep -nH '^ *# *include *"' {} + 2> /dev/null
}

for folder in base numeric spline inspect shape body mesh model fair loft hydrostatics exchange; do
    allowed="$allowed|$folder"
    bad="$bad$(includes "src/$folder" | grep -vE "\"($allowed)/")"
done
# The rooms of shape: each includes only itself and the rooms before it.
rooms="formula|equation|points|local|linear|arcs|near|aerofoil|grid|boundary|bent|cloud|skin|sweep|network|fill|curve_change|surface_change|deform|plate"
before=""
for room in $(echo "$rooms" | tr '|' ' '); do
    before="$before|$room"
    bad="$bad$(includes "src/shape/$room" | grep '"shape/' | grep -vE "\"shape/(${before#|})/")"
done
for folder in src/shape/*; do
    echo "$folder" | grep -qE "^src/shape/($rooms)$" || bad="$bad$folder is not in the list of rooms of shape
"
done
for folder in picture design; do
    bad="$bad$(includes "src/$folder" | grep -vE "\"($folder/|base/(base|elementary|plural|list|sort|arena|system)\.h\"|numeric/(vector|box)\.h\")")"
done
for folder in cli studio examples; do
    [ -d "$folder" ] || continue
    bad="$bad$(includes "$folder" | grep -E "\"(base|numeric|spline|inspect|shape|fair|loft|hydrostatics|body|mesh|model|exchange|picture|design)/|\.\./")"
done
# The operating system has one door: src/base/system behind base/system.h, and system.c of the command.
system='^ *# *include *<(unistd|pthread|threads|fcntl|locale|xlocale|dirent|signal|poll|time|windows|io|process|sys/[a-z]+)\.h>'
bad="$bad$(grep -rnE "$system" src include cli --include='*.[ch]' | grep -vE '^(src/base/system/|cli/system\.c:)')"
bad="$bad$(find include -name '*.h' -exec grep -nH '^ *# *include *"' {} +)"

if [ -n "$bad" ]; then
    printf 'includes against the order of the folders:\n%s\n' "$bad"
    exit 1
fi
