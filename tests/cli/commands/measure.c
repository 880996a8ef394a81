#include "support/process.h"

/* A right triangle of legs 3 and 4, closed: perimeter 12, area 6. */
TEST(a_triangle_of_3_4_5_is_measured)
{
    const char *design = test_scratch("triangle.yaml"), *folder = test_scratch("triangles");
    test_write(design, "batten: 1\nfeatures:\n"
                       "  t: {polyline: [[0, 0], [3, 0], [3, 4], [0, 0]]}\n"
                       "outputs:\n  t.g2: t\n");
    CHECK_INT(RUN("batten", "build", design, "-o", folder, "-q").exit, 0);
    const test_process run = RUN("batten", "measure", test_scratch("triangles/t.g2"));
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "12");
    CHECK_CONTAINS(run.out, "area 6");
}

TEST(points_are_counted_and_have_a_box)
{
    const char *points = test_scratch("measured.xyz");
    test_write(points, "0 0 0\n1 2 3\n");
    const test_process run = RUN("batten", "measure", points, "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"unit\"");
    CHECK_CONTAINS(run.out, "[1, 2, 3]");
}
