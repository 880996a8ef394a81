# An independent reader of DXF audits what Batten wrote and measures it. Arguments: a DXF file, and the total length of
# its curves in drawing units. Each other DXF file of this folder is compared with the table of points of its curves.
import glob, math, os, sys
import ezdxf
from ezdxf import recover
from ezdxf.math import Vec2, bulge_to_arc

MILLIMETRES = {4: 1.0, 6: 1000.0}


def read(name):
    """The document, and how many errors the reader finds in it."""
    document, auditor = recover.readfile(name)
    strict = ezdxf.readfile(name).audit()
    found = auditor.errors + auditor.fixes + strict.errors + strict.fixes
    for error in found:
        print("dxf: error", error.code, error.message)
    return document, len(found)


def length(document):
    total = 0.0
    for entity in document.modelspace().query("LWPOLYLINE"):
        points = list(entity.get_points("xyb"))
        ends = points[1:] + ([points[0]] if entity.closed else [])
        for (x, y, bulge), (u, v, _) in zip(points, ends):
            if bulge == 0:
                total += math.hypot(u - x, v - y)
            else:
                _, start, end, radius = bulge_to_arc(Vec2(x, y), Vec2(u, v), bulge)
                total += radius * ((end - start) % (2 * math.pi))
    for line in document.modelspace().query("LINE"):
        total += line.dxf.start.distance(line.dxf.end)
    for arc in document.modelspace().query("ARC CIRCLE"):
        whole = arc.dxftype() == "CIRCLE"
        total += arc.dxf.radius * math.radians(360 if whole else (arc.dxf.end_angle - arc.dxf.start_angle) % 360)
    return total


def largest_distance(document, table):
    """Of the points of its splines and lines from those of the table, in millimetres; and the largest coordinate there."""
    unit = MILLIMETRES[document.header["$INSUNITS"]]
    curves = list(document.modelspace().query("SPLINE LINE"))
    worst = size = 0.0
    for row in open(table):
        index, u, _, *place = row.split(",")
        curve, place = curves[int(index)], list(map(float, place))
        if curve.dxftype() == "LINE":
            point = curve.dxf.start.lerp(curve.dxf.end, float(u))
        else:
            spline = curve.construction_tool()
            a, b = spline.knots()[0], spline.knots()[-1]
            point = spline.point(a + (b - a) * float(u))
        worst = max(worst, *(abs(unit * p - q) for p, q in zip(point, place)))
        size = max(size, *map(abs, place))
    return worst, size


document, errors = read(sys.argv[1])
found, wanted = length(document), float(sys.argv[2])
good = errors == 0 and abs(found - wanted) <= 1e-6 * wanted
print("dxf:", len(document.modelspace()), "entities, length", found, "of", wanted, "" if good else "FAILED")
for name in sorted(glob.glob("curves-*.dxf")):
    document, errors = read(name)
    worst, size = largest_distance(document, os.path.splitext(name)[0] + ".csv")
    right = errors == 0 and worst <= 1e-9 * size
    good = good and right
    print("dxf: %s off by %.2g of %g%s" % (name, worst, size, "" if right else "  FAILED"))
sys.exit(0 if good else 1)
