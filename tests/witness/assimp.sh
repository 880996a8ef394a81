# Open Asset Import Library reads the meshes of this folder and writes them as STL, all parts where they stand: the
# triangles must be as many, and in the same box.
status=0
for file in *.stl *.ply *.obj *.glb *.3mf; do
    mkdir -p read
    assimp export "$file" read/out.stl > log 2>&1 || status=1
    assimp info read/out.stl > log 2>&1 || status=1
    awk -v file="$file" '
        NR == FNR {triangles = $1; for (k = 1; k <= 6; k++) box[k] = $(3 + k); next}
        /^Faces:/ {faces = $2}
        /^(Minimum|Maximum) point/ {
            first = /^Max/ ? 3 : 0
            gsub(/[(),]/, " ")
            for (k = 1; k <= 3; k++) found[first + k] = $(2 + k)
        }
        END {
            if (file ~ /glb$/) { # metres, with y up
                z = found[3]
                found[3] = found[2]; found[2] = -found[6]; found[6] = found[5]; found[5] = -z
                for (k = 1; k <= 6; k++) found[k] *= 1000
            }
            failed = faces != triangles
            for (k = 1; k <= 6; k++) failed = failed || (found[k] - box[k]) ^ 2 > 1e-6
            printf "assimp: %s %d triangles of %d, box %g %g %g to %g %g %g%s\n", file, faces, triangles,
                found[1], found[2], found[3], found[4], found[5], found[6], failed ? "  FAILED" : ""
            exit failed
        }' "${file%.*}.meshes" log || status=1
    rm -r read
done
exit $status
