# ADMesh checks the STL files of this folder: each is closed, turned outside throughout, and its normals are right. It
# reads one solid of a text, so that the text of several is left to the others.
status=0
for file in part.stl part-text.stl placed.stl; do
    admesh "$file" > log 2>&1 || status=1
    read -r triangles rest < "${file%.*}.meshes"
    awk -v file="$file" -v triangles="$triangles" '
        {value = $0; sub(/.*: */, "", value); value += 0}
        /^Number of facets/ {found = value}
        /Total disconnected|Degenerate facets|Facets removed|Facets added|Facets reversed|Backwards edges|Normals fixed/ {
            line = $0
            while (match(line, /(Total disconnected facets|Degenerate facets|Facets removed|Facets added|Facets reversed|Backwards edges|Normals fixed) *: *[0-9]+/)) {
                n = substr(line, RSTART, RLENGTH); sub(/.*: */, "", n); bad += n; line = substr(line, RSTART + RLENGTH)
            }
        }
        END {
            failed = found != triangles || bad > 0
            print "admesh:", file, found, "facets of", triangles ",", bad + 0, "faults", failed ? "FAILED" : ""
            exit failed
        }' log || status=1
done
exit $status
