#include "spline/surface/surface.h"

#include "support/surfaces.h"
#include "support/test.h"

/* A Bezier patch z = f(x, y) = x^a y^b over [x0, x0 + 1] x [0, 1]: degrees a and b. */
static const double line[] = {0, 0, 1, 1}, square[] = {0, 0, 0, 1, 1, 1};

static batten_status strip(double x, double height, bool rational, batten_surface **out)
{
    const double weights[] = {2, 2, 2, 2},
                 points[] = {x, 0, height, x, 1, height, x + 1, 0, 0, x + 1, 1, 0};
    const batten_axis axis = {1, 2, line, false};
    return batten_surface_create(3, &axis, &axis, points, rational ? weights : NULL, out);
}

static batten_status curved(double x, batten_surface **out)
{
    const double points[] = {x,     0, 0, x,     0.25, 0, x,     1, 0,
                             x + 1, 0, 1, x + 1, 0.25, 1, x + 1, 1, 1};
    const batten_axis u = {1, 2, line, false}, v = {2, 3, square, false};
    return batten_surface_create(3, &u, &v, points, NULL, out);
}

TEST(different_degrees_knots_and_weights_are_made_alike)
{
    batten_surface *left = NULL, *right = NULL, *cut = NULL, *both = NULL;
    CHECK_OK(strip(0, 0, true, &left));
    CHECK_OK(strip(1, 0, false, &right));
    CHECK_OK(batten_surface_insert_knot(right, BATTEN_V, 0.3, 1, &cut));
    CHECK_OK(batten_surface_join(left, cut, BATTEN_U, 1e-12, &both));
    CHECK(batten_surface_is_rational(both));
    CHECK(batten_surface_domain(both, BATTEN_U).b == 2);
    CHECK_INT(batten_surface_point_count(both, BATTEN_U), 3);
    CHECK_INT(batten_surface_point_count(both, BATTEN_V), 3);
    for (int i = 0; i <= 16; i++) {
        double at[3];
        CHECK_OK(batten_surface_evaluate(both, i / 8.0, 0.6, 0, at));
        CHECK_NEAR(at[0], i / 8.0, 1e-15);
        CHECK_NEAR(at[1], 0.6, 1e-15);
    }
    batten_surface_unref(both);
    batten_surface_unref(cut);
    batten_surface_unref(right);
    batten_surface_unref(left);
}

TEST(edges_that_miss_each_other_are_refused_with_their_distance)
{
    batten_surface *left = NULL, *high = NULL, *bent = NULL, *made = NULL, *plane = NULL;
    CHECK_OK(strip(0, 0, false, &left));
    CHECK_OK(strip(1, 0.5, false, &high));
    CHECK_OK(curved(1, &bent));
    CHECK_STATUS(batten_surface_join(left, high, BATTEN_U, 0.4, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("0.5 apart");
    /* Both edges are the same segment, but differently parametrised: up to 1/4 apart. */
    CHECK_STATUS(batten_surface_join(left, bent, BATTEN_U, 0.1, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_STATUS(batten_surface_join(left, high, BATTEN_U, -1, &made), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_join(left, high, BATTEN_U, NAN, &made), BATTEN_NOT_FINITE);
    const double points[] = {0, 1, 2, 3};
    const batten_axis axis = {1, 2, line, false};
    CHECK_OK(batten_surface_create(1, &axis, &axis, points, NULL, &plane));
    CHECK_STATUS(batten_surface_join(left, plane, BATTEN_U, 1, &made), BATTEN_NOT_COMPATIBLE);
    CHECK(made == NULL);
    CHECK_OK(batten_surface_join(left, high, BATTEN_U, 0.5, &made));
    double at[3];
    CHECK_OK(batten_surface_evaluate(made, 1, 0, 0, at));
    CHECK_BITS(at[2], 0.25);
    batten_surface_unref(made);
    batten_surface_unref(left);
    batten_surface_unref(high);
    batten_surface_unref(bent);
    batten_surface_unref(plane);
}

TEST(edges_of_other_weights_are_no_common_edge)
{
    const double weights[] = {1, 3, 1, 3}, points[] = {1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0};
    const batten_axis axis = {1, 2, line, false};
    batten_surface *left = NULL, *right = NULL, *made = NULL;
    CHECK_OK(strip(0, 0, true, &left));
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, weights, &right));
    CHECK_STATUS(batten_surface_join(left, right, BATTEN_U, 1e-6, &made),
                 BATTEN_NOT_COMPATIBLE);
    batten_surface_unref(left);
    batten_surface_unref(right);
}
