# Run by FreeCAD: read every file of the folder that NAMES lists, and compare it with the points of its table.
# A face or edge is asked at the same share of its own parameters.
import csv, os, Part

folder = os.environ["FOLDER"]
failures = count = 0
for name in os.environ["NAMES"].split():
    rows = list(csv.reader(open(os.path.join(folder, name.rsplit(".", 1)[0] + ".csv"))))
    shape = Part.Shape()
    shape.read(os.path.join(folder, name))
    worst = size = 0.0
    faces, edges = len(shape.Faces), len(shape.Edges)
    free = [e for e in shape.Edges if not any(e.isSame(f) for face in shape.Faces for f in face.Edges)]
    for index, u, v, x, y, z in rows:
        i, u, point = int(index), float(u), (float(x), float(y), float(z))
        if v:
            face = shape.Faces[i]
            a, b, c, d = face.ParameterRange
            p = face.valueAt(a + (b - a) * u, c + (d - c) * float(v))
        else:
            edge = free[i - faces]
            a, b = edge.ParameterRange
            p = edge.valueAt(a + (b - a) * u)
        worst = max(worst, abs(p.x - point[0]), abs(p.y - point[1]), abs(p.z - point[2]))
        size = max(size, *(abs(c) for c in point))
        count += 1
    good = shape.isValid() and worst <= 1e-9 * size
    expected = os.path.join(folder, name.rsplit(".", 1)[0] + ".expect")
    if os.path.exists(expected):
        solids, many, area, volume = map(float, open(expected).read().split())
        found = len(shape.Solids), faces, shape.Area, shape.Volume
        # Its measures of NURBS faces are rough.
        good = good and found[:2] == (solids, many) and abs(found[2] - area) <= 5e-3 * area \
            and (abs(found[3] - volume) <= 5e-3 * volume or not solids)
        print("%-18s %d solids, area %.6g (%.6g), volume %.6g (%.6g)"
              % (name, found[0], found[2], area, found[3], volume))
    failures += not good
    print("%-18s %d faces, %d edges, valid %s, off by %.2g of %g%s"
          % (name, faces, edges, shape.isValid(), worst, size, "" if good else "  FAILED"))
print("WITNESS %d points, %d files failed" % (count, failures))
