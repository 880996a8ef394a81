# The meshes of this folder, read here by their formats' rules alone: each must be closed, turned outside throughout,
# and have the triangles, the volume and the box that are in the file NAME.meshes.
import glob, json, os, re, struct, sys, zipfile
import xml.etree.ElementTree as xml


def stl(data):
    if data[:5] == b"solid":
        points = [tuple(map(float, m)) for m in re.findall(rb"vertex (\S+) (\S+) (\S+)", data)]
    else:
        count = struct.unpack_from("<I", data, 80)[0]
        assert len(data) == 84 + 50 * count
        points = []
        for i in range(count):
            row = struct.unpack_from("<12f", data, 84 + 50 * i)
            points += [row[3:6], row[6:9], row[9:12]]
    return points, [tuple(range(i, i + 3)) for i in range(0, len(points), 3)]


def ply(data):
    head, body = data.split(b"end_header\n", 1)
    count = {m[0]: int(m[1]) for m in re.findall(rb"element (\w+) (\d+)", head)}
    of_vertex, of_face = head.split(b"element vertex")[1].split(b"element face")
    names = re.findall(rb"property double (\w+)", of_vertex)
    if b"ascii" in head:
        lines = body.split(b"\n")
        points = [tuple(map(float, l.split()[:3])) for l in lines[:count[b"vertex"]]]
        faces = [tuple(map(int, l.split()[1:4])) for l in lines[count[b"vertex"]:] if l]
    else:
        size = 8 * len(names) + 3 * (b"uchar red" in of_vertex)
        step = 13 + 3 * (b"uchar red" in of_face)
        points = [struct.unpack_from("<3d", body, size * i) for i in range(count[b"vertex"])]
        at = size * count[b"vertex"]
        faces = [struct.unpack_from("<3i", body, at + step * i + 1) for i in range(count[b"face"])]
        assert len(body) == at + step * len(faces)
    return points, faces


def obj(data):
    points, faces = [], []
    for line in data.decode().split("\n"):
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return points, faces


def moved(matrix, points):
    """Points by a matrix of four columns of three."""
    return [tuple(matrix[9 + r] + sum(matrix[3 * c + r] * p[c] for c in range(3)) for r in range(3)) for p in points]


STILL = [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]


def glb(data):
    magic, version, length, size, kind = struct.unpack_from("<4sIII4s", data)
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON") and size % 4 == 0
    tree, start = json.loads(data[20:20 + size]), 28 + size
    points, faces = [], []

    def rows(index, form):
        accessor = tree["accessors"][index]
        view = tree["bufferViews"][accessor["bufferView"]]
        step = struct.calcsize(form)
        assert view["byteLength"] == step * accessor["count"]
        found = [struct.unpack_from(form, data, start + view["byteOffset"] + step * i) for i in range(accessor["count"])]
        if "min" in accessor:
            for k in range(3):
                column = [row[k] for row in found]
                assert min(column) == accessor["min"][k] and max(column) == accessor["max"][k]
        return found

    def walk(index):
        """The points and faces of a node with those below it."""
        node = tree["nodes"][index]
        near, corners = [], []
        for part in tree["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            indices = [len(near) + row[0] for row in rows(part["indices"], "<I")]
            near += rows(part["attributes"]["POSITION"], "<3f")
            corners += [tuple(indices[i:i + 3]) for i in range(0, len(indices), 3)]
        for child in node.get("children", []):
            p, f = walk(child)
            corners += [tuple(len(near) + i for i in t) for t in f]
            near += p
        m = node.get("matrix")
        return (moved([m[4 * c + r] for c in range(4) for r in range(3)], near) if m else near), corners

    for root in tree["scenes"][tree["scene"]]["nodes"]:
        p, f = walk(root)
        faces += [tuple(len(points) + i for i in t) for t in f]
        points += [(1000 * x, -1000 * z, 1000 * y) for x, y, z in p]
    return points, faces


def threemf(path):
    archive = zipfile.ZipFile(path)
    assert archive.testzip() is None
    space = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    tree = xml.fromstring(archive.read("3D/3dmodel.model"))
    assert tree.get("unit") == "millimeter"
    objects = {}

    def gather(items):
        """Those that build items or components name, where they stand."""
        points, faces = [], []
        for item in items:
            p, f = objects[item.get("objectid")]
            matrix = list(map(float, item.get("transform").split())) if item.get("transform") else STILL
            faces += [tuple(len(points) + i for i in t) for t in f]
            points += moved(matrix, p)
        return points, faces

    for item in tree.find(space + "resources").iter(space + "object"):  # each after those that it names
        mesh, components = item.find(space + "mesh"), item.find(space + "components")
        if components is not None:
            objects[item.get("id")] = gather(components)
        else:
            objects[item.get("id")] = ([tuple(float(v.get(k)) for k in "xyz") for v in mesh.iter(space + "vertex")],
                                       [tuple(int(t.get(k)) for k in ("v1", "v2", "v3"))
                                        for t in mesh.iter(space + "triangle")])
    return gather(tree.find(space + "build"))


def check(points, faces):
    """Edges without a partner the other way, and the volume. Corners at one point are one."""
    place = {}
    number = [place.setdefault(tuple(0.0 + float(f"{c:.9g}") for c in p), len(place)) for p in points]
    edges, volume = {}, 0.0
    for a, b, c in faces:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = points[a], points[b], points[c]
        volume += (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6
        for i, k in ((a, b), (b, c), (c, a)):
            if number[i] != number[k]:
                edges[number[i], number[k]] = edges.get((number[i], number[k]), 0) + 1
    return sum(n != edges.get((k, i), 0) for (i, k), n in edges.items()), volume


failures = count = 0
for name in sorted(sum((glob.glob("*." + ending) for ending in ("stl", "ply", "obj", "glb", "3mf")), [])):
    base, ending = os.path.splitext(name)
    expected = list(map(float, open(base + ".meshes").read().split()))
    read = {".stl": stl, ".ply": ply, ".obj": obj, ".glb": glb}.get(ending)
    points, faces = read(open(name, "rb").read()) if read else threemf(name)
    loose, volume = check(points, faces)
    box = [f(p[k] for p in points) for f in (min, max) for k in range(3)]
    size = max(map(abs, box))
    # The curved walls of the hole are chords.
    good = (loose, len(faces)) == (0, expected[0]) and abs(volume - expected[2]) < 1e-3 * expected[2] \
        and all(abs(a - b) < 1e-6 * size for a, b in zip(box, expected[3:]))
    failures += not good
    count += 1
    print("%-16s %d triangles, %d open edges, volume %.9g%s" % (name, len(faces), loose, volume, "" if good else "  FAILED"))
print("WITNESS %d files, %d failed" % (count, failures))
sys.exit(failures > 0 or count == 0)
