# Run by FreeCAD: read every file of this folder that has a table of points beside it, and compare it with them.
# A face or edge is asked at the same share of its own parameters.
import glob, os, Part


def free_edges(shape):
    """The edges that are of no face."""
    bound = {}
    for face in shape.Faces:
        for edge in face.Edges:
            bound.setdefault(edge.hashCode(), []).append(edge)
    return [e for e in shape.Edges if not any(e.isSame(f) for f in bound.get(e.hashCode(), []))]


failures = count = 0
for name in sorted(glob.glob("*.step") + glob.glob("*.igs")):
    base = name.rsplit(".", 1)[0]
    if not os.path.exists(base + ".csv"):
        continue
    shape = Part.Shape()
    shape.read(name)
    faces, edges, free = shape.Faces, shape.Edges, free_edges(shape)
    worst = size = 0.0
    last = None
    for row in open(base + ".csv"):
        index, u, v, x, y, z = row.split(",")
        if index != last:
            last, i = index, int(index)
            part = faces[i] if i < len(faces) else free[i - len(faces)]
            value, domain = part.valueAt, part.ParameterRange
        x, y, z = float(x), float(y), float(z)
        a, b = domain[:2]
        if v:
            c, d = domain[2:]
            p = value(a + (b - a) * float(u), c + (d - c) * float(v))
        else:
            p = value(a + (b - a) * float(u))
        worst = max(worst, abs(p.x - x), abs(p.y - y), abs(p.z - z))
        size = max(size, abs(x), abs(y), abs(z))
        count += 1
    good = shape.isValid() and worst <= 1e-9 * size
    solids, many, area, volume = map(float, open(base + ".expect").read().split())
    good = good and (len(shape.Solids), len(faces)) == (solids, many)
    if area:
        # Its measures of NURBS faces are rough.
        good = good and abs(shape.Area - area) <= 5e-3 * area \
            and (abs(shape.Volume - volume) <= 5e-3 * volume or not solids)
        print("%-18s %d solids, area %.6g (%.6g), volume %.6g (%.6g)"
              % (name, len(shape.Solids), shape.Area, area, shape.Volume, volume))
    failures += not good
    print("%-18s %d faces, %d edges, valid %s, off by %.2g of %g%s"
          % (name, len(faces), len(edges), shape.isValid(), worst, size, "" if good else "  FAILED"))
print("WITNESS %d points, %d files failed" % (count, failures))
