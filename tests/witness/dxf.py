# An independent reader of DXF audits what Batten wrote and measures it.
# Arguments: a DXF file, and the total length of its curves in drawing units.
import math, sys
import ezdxf
from ezdxf import recover
from ezdxf.math import bulge_to_arc, Vec2

document, auditor = recover.readfile(sys.argv[1])
strict = ezdxf.readfile(sys.argv[1]).audit()
for error in auditor.errors + strict.errors:
    print("dxf: error", error.code, error.message)
length = 0.0
for entity in document.modelspace():
    if entity.dxftype() == "LWPOLYLINE":
        points = list(entity.get_points("xyb"))
        ends = points[1:] + ([points[0]] if entity.closed else [])
        for (x, y, bulge), (u, v, _) in zip(points, ends):
            chord = math.hypot(u - x, v - y)
            angle = 4 * math.atan(abs(bulge))
            length += chord if bulge == 0 else chord / 2 / math.sin(angle / 2) * angle
    elif entity.dxftype() == "SPLINE":
        tool = entity.construction_tool()
        points = list(tool.approximate(4000))
        length += sum(p.distance(q) for p, q in zip(points, points[1:]))
wanted = float(sys.argv[2])
good = not auditor.errors and not strict.errors and abs(length - wanted) <= 1e-6 * wanted
print("dxf:", len(document.modelspace()), "entities, length", length, "of", wanted, "" if good else "FAILED")
sys.exit(0 if good else 1)
