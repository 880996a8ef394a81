# Gmsh reads the files of this folder: it must find the surfaces and volumes that were written, and the triangles of
# meshes. It reads no OBJ; binary PLY it takes for numbers of single precision, and ours are double.
for file in *.step *.igs; do
    [ -f "${file%.*}.expect" ] || continue
    read -r volumes surfaces rest < "${file%.*}.expect"
    echo "SetFactory(\"OpenCASCADE\"); Merge \"$file\"; s() = Surface{:}; v() = Volume{:};"
    echo "Printf(\"READ $file volumes %g of $volumes, surfaces %g of $surfaces\", #v(), #s()); Delete Model;"
done > read.geo
for file in *.stl *-text.ply; do
    read -r triangles rest < "${file%.*}.meshes"
    echo "Merge \"$file\"; Printf(\"READ $file triangles %g of $triangles\", Mesh.NbTriangles); Delete Model;"
done >> read.geo
gmsh read.geo -parse_and_exit -nopopup > log 2>&1 || exit 1
grep -E "Error|Warning" log && exit 1
# NUMBER of NUMBER, the same.
awk -v wanted="$(grep -c READ read.geo)" '/^READ/ {
    bad = 0
    for (i = 3; i <= NF; i++) if ($i == "of" && $(i - 1) + 0 != $(i + 1) + 0) bad = 1
    print "gmsh:", substr($0, 6), bad ? "FAILED" : ""
    files++; failed += bad
} END { print "WITNESS", files, "files,", failed + 0, "failed"; exit failed > 0 || files != wanted }' log
