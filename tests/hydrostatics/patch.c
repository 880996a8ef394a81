/* Rows of a Bezier patch with weights, against the formula that it has. */
#include "hydrostatics/patch.h"
#include "support/test.h"

/* (u^2, v, u v) / (1 + u), of degree 2 in u and 1 in v: homogeneous points. */
static double formula_points[3 * 2 * 4] = {0, 0, 0,   1,   0, 1, 0, 1, 0, 0, 0, 1.5,
                                           0, 1, 0.5, 1.5, 1, 0, 0, 2, 1, 1, 1, 2};

static bat_patch formula(void)
{
    return (bat_patch){.lid = BAT_SKIN, .degree = {2, 1}, .sign = 1, .points = formula_points};
}

TEST(a_point_of_a_row_and_its_derivatives_are_those_of_the_formula)
{
    static const double places[][2] = {{0, 0}, {1, 1}, {0.25, 0.5}, {0.75, 0.125}, {1, 0}};
    const bat_patch patch = formula();
    for (int i = 0; i < COUNT(places); i++)
        for (int constant = 0; constant < 2; constant++) {
            const double u = places[i][0], v = places[i][1], w = 1 + u;
            const double at[3] = {u * u / w, v / w, u * v / w};
            const double along_u[3] = {(2 * u * w - u * u) / (w * w), -v / (w * w),
                                       v / (w * w)};
            const double along_v[3] = {0, 1 / w, u / w};
            bat_row row;
            bat_row_point p;
            bat_patch_row(&patch, constant ? BATTEN_V : BATTEN_U, constant ? v : u, &row);
            CHECK_INT(row.degree, constant ? 2 : 1);
            bat_row_at(&row, constant ? u : v, &p);
            for (int c = 0; c < 3; c++) {
                CHECK_NEAR(p.at[c], at[c], 1e-15);
                CHECK_NEAR(p.derivative[constant][c], along_u[c], 1e-15);
                CHECK_NEAR(p.derivative[!constant][c], along_v[c], 1e-15);
            }
        }
}

/* n.P - d times the weight: over the row u = 1/2 it is -1/4 at v = 0 and 3/2 at v = 1. */
TEST(heights_of_a_row_are_those_above_the_plane_times_the_weight)
{
    const bat_patch patch = formula();
    const double n[3] = {2, 1, 1.5};
    bat_row row;
    double heights[BATTEN_MAX_DEGREE + 1];
    bat_patch_row(&patch, BATTEN_U, 0.5, &row);
    bat_row_heights(&row, n, 0.5, heights);
    CHECK_NEAR(heights[0], -0.25, 1e-15);
    CHECK_NEAR(heights[1], 1.5, 1e-15);
}

TEST(the_roots_of_heights_come_rising_and_none_where_all_is_0)
{
    static const struct {
        int degree, count;
        double heights[4], roots[3];
    } cases[] = {{1, 1, {-1, 3}, {0.25}},
                 {2, 2, {3, -5, 3}, {0.25, 0.75}},
                 {3, 3, {-9, 13, -13, 9}, {0.25, 0.5, 0.75}},
                 {2, 0, {1, 2, 1}, {0}},
                 {2, 0, {0, 0, 0}, {0}},
                 {0, 0, {0}, {0}},
                 {3, 1, {-1, -1, -1, 7}, {0.5}}};
    for (int i = 0; i < COUNT(cases); i++) {
        double roots[BATTEN_MAX_DEGREE];
        int count = -1;
        CHECK_OK(bat_row_roots(cases[i].degree, cases[i].heights, roots, &count));
        CHECK_INT(count, cases[i].count);
        for (int k = 0; k < count; k++)
            CHECK_NEAR(roots[k], cases[i].roots[k], 1e-14);
    }
}
