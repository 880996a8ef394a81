#include "support/process.h"

/* A tetrahedron without its last face, and a triangle without area, as a file. */
static const char *write_mesh(const char *name)
{
    const char *path = test_scratch(name);
    test_write(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\n"
                     "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 1 2 2\n");
    return path;
}

static const char face[] = "210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n"
                           "0 0 1\n4 0 1\n0 4 1\n4 4 1\n1\n3 1e-6\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n1 1\n3 1\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n3 1\n2 3\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n2 3\n1 1\n"
                           "100 1 0 0\n3 0\n4 2\n0 0 1e-9 1 2 2\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n";

TEST(info_tells_of_meshes_and_what_is_odd_with_them)
{
    const char *path = write_mesh("open.obj");
    test_process run = RUN("batten", "info", path);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "4 triangles, 4 vertices");
    CHECK_CONTAINS(run.out, "not watertight");
    CHECK_CONTAINS(run.errors, "1 triangles without area");
    CHECK_CONTAINS(run.errors, "3 edges of one triangle");
    run = RUN("batten", "info", path, "--no-lint");
    CHECK(strstr(run.errors, "without area") == NULL);
    run = RUN("batten", "info", path, "--json");
    CHECK_CONTAINS(run.out, "\"triangles\": 4");
    CHECK_CONTAINS(run.out, "\"watertight\": false");
}

TEST(info_tells_of_faces_and_near_knots)
{
    const char *path = test_scratch("face.g2");
    test_write(path, face);
    test_process run = RUN("batten", "info", path);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "2 objects (1 curve, 1 body), unit not stated");
    CHECK_CONTAINS(run.out, "bounded surface 1: sheet, 1 face, 3 edges, 3 vertices, 1 shell");
    CHECK_CONTAINS(run.errors, "spline curve 2: two knots are only 5e-10 of the domain apart");
    run = RUN("batten", "info", path, "--json");
    CHECK_CONTAINS(run.out, "\"type\": \"sheet\", \"kind\": \"body\"");
    CHECK_CONTAINS(run.out, "\"faces\": 1, \"edges\": 3, \"vertices\": 3, \"shells\": 1");
    CHECK_CONTAINS(run.out, "\"hidden\": false");
    CHECK_CONTAINS(run.out, "\"coloured_faces\": 0");
}
