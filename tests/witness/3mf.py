# lib3mf, the reader of the 3MF Consortium, reads the files of this folder in its strict mode.
import ctypes, glob, sys

library = ctypes.CDLL("lib3MF.so.1")


def get(name, *arguments, kind=ctypes.c_void_p):
    """What the function gives back through its last argument."""
    out = kind()
    result = getattr(library, "lib3mf_" + name)(*arguments, ctypes.byref(out))
    assert result == 0, (name, hex(result))
    return out if kind is ctypes.c_void_p else out.value


failures = 0
for name in sorted(glob.glob("*.3mf")):
    model = get("createmodel")
    reader = get("model_queryreader", model, b"3mf")
    library.lib3mf_reader_setstrictmodeactive(reader, True)
    faults = int(library.lib3mf_reader_readfromfileutf8(reader, name.encode()) != 0)
    faults += get("reader_getwarningcount", reader, kind=ctypes.c_uint32)
    meshes = get("model_getmeshobjects", model)
    triangles = 0
    while get("resourceiterator_movenext", meshes, kind=ctypes.c_bool):
        mesh = get("resourceiterator_getcurrent", meshes)
        triangles += get("meshobject_gettrianglecount", mesh, kind=ctypes.c_uint32)
        faults += not get("object_isvalidobject", mesh, kind=ctypes.c_bool)
        faults += not get("meshobject_ismanifoldandoriented", mesh, kind=ctypes.c_bool)
    wanted = int(open(name.rsplit(".", 1)[0] + ".meshes").read().split()[1])
    good = faults == 0 and triangles == wanted
    failures += not good
    print("3mf: %s %d triangles of %d, %d faults%s" % (name, triangles, wanted, faults, "" if good else "  FAILED"))
sys.exit(failures > 0)
