#!/bin/sh
# Another program reads what Batten wrote: run.sh WITNESS MODELS [BATTEN]. MODELS is batten-witness-models, which
# makes the files. Exit status 77, which is a skipped test, when the witness is not installed: ./dev witnesses does it.
witness=$1 models=$2 batten=$3
here=$(cd "$(dirname "$0")" && pwd)

need()
{
    command -v "$1" > /dev/null || skip "$1"
}

skip()
{
    echo "skipped: $1 is not installed"
    exit 77
}

need_python()
{
    python=$(for p in /usr/bin/python3 python3; do "$p" -c "$1" 2> /dev/null && echo "$p" && break; done)
    [ -n "$python" ] || skip "$2"
}

case $witness in
freecad) freecad=$(command -v freecadcmd || command -v FreeCADCmd) || skip "FreeCAD (freecadcmd)" ;;
gltf)
    need node
    need npm
    NODE_PATH=$(npm root -g 2> /dev/null)
    export NODE_PATH
    node -e 'require("gltf-validator")' 2> /dev/null || skip "gltf-validator (npm)"
    ;;
3mf) need_python 'import ctypes; ctypes.CDLL("lib3MF.so.1")' "lib3mf 1" ;;
dxf) need_python 'import ezdxf' "python3-ezdxf" ;;
meshes | step | iges) need_python 'import zipfile' "Python (python3)" ;;
gmsh | admesh | assimp) need "$witness" ;;
*)
    echo "$witness: no such witness"
    exit 2
    ;;
esac

folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
"$models" "$folder" || exit 1

case $witness in
freecad)
    HOME=$folder "$freecad" "$here/read_shapes.py" > log 2>&1
    grep -E "faces|solids|WITNESS|Error|Traceback" log
    grep -q "WITNESS .* 0 files failed" log
    ;;
gltf) node "$here/gltf.js" ./*.glb ;;
# A circle of radius 10, a triangle of sides 3, 4, 5 times ten, a third of a circle of radius 20, an ellipse of 20 and 10.
dxf)
    "$batten" build "$here/dxf.yaml" -o "$folder" -q || exit 1
    "$python" "$here/dxf.py" shapes.dxf 321.60423732513607
    ;;
gmsh | admesh | assimp) sh "$here/$witness.sh" ;;
*) "$python" "$here/$witness.py" ;;
esac
