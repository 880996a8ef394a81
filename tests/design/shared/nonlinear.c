#include "design/expect.h"

/* Conditions at the ends of nonlinear splines, each by its own parameter or by that for both. */

static const char points[] =
    "  p: {points: [[0, 0, 2], [1, 0.5, 2], [2, 0.6, 2], [3, 0.3, 2], [4, 0, 2]]}\n"
    "  z: {points: [[0, 0], [4, 0], [1, 0.8], [5, 1.5]]}\n"
    "  round: {points: [[5, 0], [4, 3], [3, 4], [0, 5]]}\n";

TEST(ends_are_natural_circular_or_given)
{
    static const char *const names[] = {"euler-spiral", "elastica", "local-cubic"};
    static const expect_row rows[] = {
        {"{@: p}", BATTEN_OK, "passes;within 1e-8;bends 0 0;bends 1 0"},
        {"{@: p, start: curvature, start-curvature: -0.25, end-curvature: 7}", BATTEN_OK,
         "within 1e-8;bends 0 0.25;bends 1 0"},
        {"{@: p, end: curvature, end-curvature: -0.25, start-curvature: 7}", BATTEN_OK,
         "within 1e-8;bends 0 0;bends 1 0.25"},
        {"{@: p, ends: curvature, start: natural, end-curvature: -0.25}", BATTEN_OK,
         "within 1e-8;bends 0 0;bends 1 0.25"},
        {"{@: p, ends: tangent, start-angle: 30 deg, end-angle: -45 deg, end: tangent}",
         BATTEN_OK,
         "heads 0 0.8660254037844386 0.5 0;heads 1 0.7071067811865476 -0.7071067811865476 0"},
        {"{@: p, start: tangent, start-angle: 30 deg, start-curvature: 9}", BATTEN_OK,
         "heads 0 0.8660254037844386 0.5 0;within 1e-8;bends 1 0"},
    };
    expect_each(points, names, COUNT(names), rows, COUNT(rows));
    static const expect_row others[] = {
        {"{euler-spiral: round, ends: circular}", BATTEN_OK, "within 1e-8;distance 5 0 0 0"},
        {"{local-tension: p, tension: 1000, ends: natural}", BATTEN_OK,
         "passes;within 1e-2;length 4.2110828526"},
        {"{euler-spiral: z}", BATTEN_OK, "notes degrees at point 2: look at the curve there"},
        {"{euler-spiral: p}", BATTEN_OK, "silent"},
    };
    EXPECT(points, others);
}
