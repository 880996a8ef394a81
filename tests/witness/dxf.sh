#!/bin/sh
# An independent reader audits a DXF file that Batten wrote. Exit status 77, which is a skipped test, when
# python3-ezdxf is not installed. Arguments: the command, the folder of this script.
batten=$1 here=$2
python=$(for p in /usr/bin/python3 python3; do "$p" -c 'import ezdxf' 2> /dev/null && echo "$p" && break; done)
[ -n "$python" ] || {
    echo "skipped: python3-ezdxf is not installed"
    exit 77
}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
"$batten" build "$here/dxf.yaml" -o "$folder" -q || exit 1
# A circle of radius 10, a triangle of sides 3, 4, 5 times ten, a third of a circle of radius 20, an ellipse of 20 and 10.
"$python" "$here/dxf.py" "$folder/shapes.dxf" 321.60423732513607
