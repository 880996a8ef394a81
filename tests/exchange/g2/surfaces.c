/* Elementary surfaces of the format: the points that their formulas give, and what is wrong. */
#include "exchange/reading.h"

#define R 0.70710678118654752
#define QUARTER "0 1.5707963267948966\n"

/* Points at the corners (0, 0), (1, 0), (0, 1) of the domain and in its middle. */
static const struct {
    const char *text;
    double at[4][3];
} surfaces[] = {
    /* plane: x and y = z cross x, each over its range; swapped the first is y */
    {"250 1 0 0\n3\n1 2 3\n0 0 2\n5 0 0\n1\n1 3\n-1 5\n0\n",
     {{2, 1, 3}, {4, 1, 3}, {2, 7, 3}, {3, 4, 3}}},
    {"250 1 0 0\n3\n1 2 3\n0 0 2\n5 0 0\n1\n1 3\n-1 5\n1\n",
     {{2, 1, 3}, {2, 7, 3}, {4, 1, 3}, {3, 4, 3}}},
    {"250 1 0 0\n3\n1 2 3\n1 0 0\n0 1 0\n1\n1 3\n-1 5\n",
     {{1, 3, 2}, {1, 5, 2}, {1, 3, 8}, {1, 4, 5}}},
    /* cylinder: around from the x-axis, then along the axis */
    {"260 1 0 0\n3\n2\n1 2 3\n0 0 1\n1 0 0\n1\n" QUARTER "-1 4\n0\n",
     {{3, 2, 2}, {1, 4, 2}, {3, 2, 7}, {1 + 2 * R, 2 + 2 * R, 4.5}}},
    {"260 1 0 0\n3\n2\n1 2 3\n0 0 1\n1 0 0\n1\n" QUARTER "-1 4\n1\n",
     {{3, 2, 2}, {3, 2, 7}, {1, 4, 2}, {1 + 2 * R, 2 + 2 * R, 4.5}}},
    /* from a quarter to a half */
    {"260 1 0 0\n3\n2\n0 0 0\n0 0 1\n1 0 0\n1\n1.5707963267948966 3.141592653589793\n-1 4\n",
     {{0, 2, -1}, {-2, 0, -1}, {0, 2, 4}, {-2 * R, 2 * R, 1.5}}},
    /* cone: the radius grows by the tangent of its angle */
    {"280 1 0 0\n3\n1\n0 0 0\n0 0 1\n1 0 0\n0.7853981633974483\n1\n" QUARTER "1 3\n0\n",
     {{2, 0, 1}, {0, 2, 1}, {4, 0, 3}, {3 * R, 3 * R, 2}}},
    /* sphere: longitude, then latitude */
    {"270 1 0 0\n3\n2\n1 2 3\n0 0 1\n1 0 0\n" QUARTER "0 1.5707963267948966\n0\n",
     {{3, 2, 3}, {1, 4, 3}, {1, 2, 5}, {2, 3, 3 + 2 * R}}},
    {"270 1 0 0\n3\n2\n1 2 3\n0 0 1\n1 0 0\n", {{1, 2, 1}, {1, 2, 1}, {1, 2, 5}, {-1, 2, 3}}},
    /* torus: around the axis, then around the tube from its outside */
    {"290 1 0 0\n3\n3\n1\n0 0 0\n0 0 1\n1 0 0\n1\n1\n" QUARTER QUARTER "0\n",
     {{4, 0, 0}, {0, 4, 0}, {3, 0, 1}, {(3 + R) * R, (3 + R) * R, R}}},
    {"290 1 0 0\n3\n3\n1\n0 0 0\n0 0 1\n1 0 0\n1\n",
     {{4, 0, 0}, {4, 0, 0}, {4, 0, 0}, {-2, 0, 0}}},
    /* revolution of a line from (2, 0, 0) to (3, 0, 1), all around (1, 0, z) */
    {"291 1 0 0\n3\n1 0 0\n0 0 1\n3 0\n2 2\n0 0 1 1\n2 0 0\n3 0 1\n",
     {{2, 0, 0}, {2, 0, 0}, {3, 0, 1}, {-0.5, 0, 0.5}}},
};

TEST(elementary_surfaces_have_their_corners_and_middle_where_their_formula_has_them)
{
    static const double share[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}};
    for (int i = 0; i < COUNT(surfaces); i++) {
        batten_model *model = NULL;
        CHECK_OK(read_text(surfaces[i].text, BATTEN_FORMAT_G2, NULL, &model));
        const batten_surface *surface = batten_model_object(model, 0)->surface;
        const batten_interval u = batten_surface_domain(surface, BATTEN_U);
        const batten_interval v = batten_surface_domain(surface, BATTEN_V);
        for (int s = 0; s < 4; s++) {
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, u.a + share[s][0] * (u.b - u.a),
                                             v.a + share[s][1] * (v.b - v.a), 0, p));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(p[k], surfaces[i].at[s][k], 2e-14);
        }
        batten_model_unref(model);
    }
}

/* The index of u runs first in the file, that of v in Batten. */
TEST(a_spline_surface_has_the_orders_points_and_weights_of_the_file)
{
    static const double points[] = {1,  2,  3,  4,  5,  6,  7,  8,  9,
                                    10, 11, 12, 13, 14, 15, 16, 17, 18};
    static const double weights[] = {1, 4, 2, 8, 0.5, 1};
    static const int order[] = {0, 2, 4, 1, 3, 5};
    char text[600];
    batten_model *model = NULL;
    int at = snprintf(text, sizeof text, "200 1 0 0\n3 1\n2 2\n0 0 1 1\n3 2\n0 0 1 3 3\n");
    for (int i = 0; i < 6; i++)
        at += snprintf(text + at, sizeof text - (size_t)at, "%g %g %g %g\n",
                       points[3 * i] * weights[i], points[3 * i + 1] * weights[i],
                       points[3 * i + 2] * weights[i], weights[i]);
    CHECK_OK(read_text(text, BATTEN_FORMAT_G2, NULL, &model));
    const batten_surface *surface = batten_model_object(model, 0)->surface;
    CHECK_INT(batten_surface_point_count(surface, BATTEN_U), 2);
    CHECK_INT(batten_surface_point_count(surface, BATTEN_V), 3);
    CHECK_INT(batten_surface_degree(surface, BATTEN_V), 1);
    for (int i = 0; i < 6; i++) {
        CHECK_BITS(batten_surface_weights(surface)[i], weights[order[i]]);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(batten_surface_points(surface)[3 * i + k], points[3 * order[i] + k]);
    }
    batten_model_unref(model);
}

TEST(what_is_wrong_in_a_surface_is_named)
{
    static const struct {
        const char *text, *words;
    } cases[] = {
        {"250 1 0 0\n2\n", "the dimension is 2"},
        {"200 1 0 0\n2 0\n", "the dimension is 2"},
        {"200 1 0 0\n3 2\n", "the sign of a rational surface is 2"},
        {"291 1 0 0\n2\n", "the dimension is 2"},
        {"240 1 0 0\n3\n", "not read"},
        {"250 1 0 0\n3\n0 0 0\n0 0 1\n1 0 0\n0\n0\n", "the surface has no bounds"},
        {"250 1 0 0\n3\n0 0 0\n0 0 1\n1 0 0\n2\n", "the mark of a bounded surface is 2"},
        {"250 1 0 0\n3\n0 0 0\n0 0 1\n1 0 0\n1\n0 1\n0 1\n2\n",
         "the mark of swapped parameters is 2"},
        {"290 1 0 0\n3\n3\n1\n0 0 0\n0 0 1\n1 0 0\n2\n", "the side of the torus is 2"},
        {"260 1 0 0\n3\n2\n0 0 0\n0 0 1\n0 0 1\n", "0 or parallel"},
    };
    for (int i = 0; i < COUNT(cases); i++)
        check_refused(cases[i].text, BATTEN_FORMAT_G2, BATTEN_UNSUPPORTED, cases[i].words);
}

TEST(a_torus_of_positive_radius_needs_no_note)
{
    batten_model_unref(
        read_noting("290 1 0 0\n3\n3\n1\n0 0 0\n0 0 1\n1 0 0\n1\n", BATTEN_FORMAT_G2, ""));
}
