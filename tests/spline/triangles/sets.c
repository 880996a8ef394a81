/* Parts of sets of triangles, sets put together, graphs: what they keep, what they refuse. */
#include <batten/triangles.h>

#include "support/test.h"

/* One linear triangle of dimension d; weights and domain may be NULL. */
static batten_triangles *triangle(int d, const double *points, const double *weights,
                                  const batten_triangulation *domain)
{
    batten_triangles *out = NULL;
    CHECK_OK(batten_triangles_create(
        &(batten_triangles_parts){d, 1, 1, points, weights, domain}, &out));
    return out;
}

/* Two linear triangles over the unit square, values x + 2 y. */
static batten_triangles *square(void)
{
    const double vertices[8] = {0, 0, 1, 0, 0, 1, 1, 1}, values[6] = {0, 1, 2, 3, 2, 1};
    const int corners[6] = {0, 1, 2, 3, 2, 1};
    const batten_triangulation domain = {4, vertices, corners};
    batten_triangles *out = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){1, 1, 2, values, NULL, &domain},
                                     &out));
    return out;
}

TEST(selected_triangles_keep_their_domain_and_values)
{
    batten_triangles *all = square(), *one = NULL, *graph = NULL;
    const int which[1] = {1}, none[1] = {2}, low[1] = {-1};
    double at[3];
    CHECK_OK(batten_triangles_select(all, 1, which, &one));
    CHECK_INT(batten_triangles_count(one), 1);
    CHECK_OK(batten_triangles_from_function(one, &graph));
    CHECK_OK(batten_triangles_evaluate(graph, 0, (const double[3]){1, 0, 0}, 0, at));
    CHECK_NEAR(at[0], 1, 0);
    CHECK_NEAR(at[1], 1, 0);
    CHECK_NEAR(at[2], 3, 0);
    CHECK_STATUS(batten_triangles_select(all, 0, which, &one), BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_triangles_select(all, 1, none, &one), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("there are 2");
    CHECK_STATUS(batten_triangles_select(all, 1, low, &one), BATTEN_OUT_OF_DOMAIN);
    batten_triangles_unref(all);
    batten_triangles_unref(one);
    batten_triangles_unref(graph);
}

TEST(sets_of_different_dimensions_are_not_put_together)
{
    const double flat[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    const double weights[3] = {1, 2, 1};
    batten_triangles *values = square(), *space = triangle(3, flat, NULL, NULL),
                     *rational = triangle(3, flat, weights, NULL), *both = NULL;
    double at[3];
    CHECK_STATUS(batten_triangles_together(values, space, &both), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("1 and 3");
    CHECK_OK(batten_triangles_together(rational, space, &both));
    CHECK_OK(batten_triangles_evaluate(both, 0, (const double[3]){0.5, 0.5, 0}, 0, at));
    CHECK_NEAR(at[0], 2.0 / 3, 1e-15);
    CHECK_OK(batten_triangles_evaluate(both, 1, (const double[3]){0.5, 0.5, 0}, 0, at));
    CHECK_NEAR(at[0], 0.5, 1e-15);
    batten_triangles *graph = NULL;
    CHECK_STATUS(batten_triangles_from_function(space, &graph), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangles_from_function(rational, &graph), BATTEN_BAD_ARGUMENT);
    batten_triangles_unref(values);
    batten_triangles_unref(space);
    batten_triangles_unref(rational);
    batten_triangles_unref(both);
}

TEST(graphs_are_of_functions)
{
    const double knots[4] = {0, 0, 1, 1}, plane[4] = {0, 0, 1, 2}, line[2] = {3, 4},
                 weights[2] = {1, 2};
    batten_curve *curve = NULL, *rational = NULL, *function = NULL, *graph = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 2, plane}, 1, NULL, knots, &curve));
    CHECK_OK(batten_curve_create((batten_points){1, 2, line}, 1, weights, knots, &rational));
    CHECK_OK(batten_curve_create((batten_points){1, 2, line}, 1, NULL, knots, &function));
    CHECK_STATUS(batten_curve_from_function(curve, &graph), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_curve_from_function(rational, &graph));
    CHECK_INT(batten_curve_degree(graph), 2);
    for (int i = 0; i <= 8; i++) {
        double f, at[2];
        CHECK_OK(batten_curve_evaluate(rational, i / 8.0, 0, &f));
        CHECK_OK(batten_curve_evaluate(graph, i / 8.0, 0, at));
        CHECK_NEAR(at[0], i / 8.0, 1e-15);
        CHECK_NEAR(at[1], f, 1e-15);
    }
    batten_curve_unref(graph);
    graph = NULL;
    CHECK_OK(batten_curve_from_function(function, &graph));
    CHECK_NEAR(batten_curve_points(graph)[2], 1, 0);
    CHECK_NEAR(batten_curve_points(graph)[3], 4, 0);
    batten_curve_unref(curve);
    batten_curve_unref(rational);
    batten_curve_unref(function);
    batten_curve_unref(graph);
}

TEST(weights_of_one_set_alone_make_both_rational)
{
    const double points[3] = {0, 1, 2}, weights[3] = {1, 2, 3};
    batten_triangles *plain = triangle(1, points, NULL, NULL),
                     *rational = triangle(1, points, weights, NULL), *both = NULL;
    CHECK_OK(batten_triangles_together(plain, rational, &both));
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(batten_triangles_weights(both)[i], 1, 0);
        CHECK_NEAR(batten_triangles_weights(both)[3 + i], weights[i], 0);
    }
    batten_triangles_unref(both);
    CHECK_OK(batten_triangles_together(plain, plain, &both));
    CHECK(!batten_triangles_is_rational(both));
    CHECK_INT(batten_triangles_count(both), 2);
    batten_triangles_unref(both);
    batten_triangles_unref(plain);
    batten_triangles_unref(rational);
}

TEST(graphs_of_triangles_take_polynomial_values_over_a_domain)
{
    const double vertices[6] = {0, 0, 1, 0, 0, 1}, values[3] = {1, 2, 3},
                 weights[3] = {1, 2, 1};
    const int corners[3] = {0, 1, 2};
    const batten_triangulation domain = {3, vertices, corners};
    batten_triangles *bare = triangle(1, values, NULL, NULL),
                     *rational = triangle(1, values, weights, &domain), *graph = NULL;
    CHECK_STATUS(batten_triangles_from_function(bare, &graph), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_triangles_from_function(rational, &graph), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("polynomial triangles of dimension 1 over a domain");
    CHECK_STATUS(batten_triangles_select(bare, 1, (const int[1]){1}, &graph),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_triangles_select(bare, -1, (const int[1]){0}, &graph),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(!graph);
    batten_triangles_unref(bare);
    batten_triangles_unref(rational);
}

TEST(the_box_of_triangles_holds_their_control_points_in_each_coordinate)
{
    const double points[18] = {1, -2, 3, 4, 5, -6, 2, 7, 0, -3, 1, 1, 0, 0, 9, 2, -8, 2};
    for (int d = 1; d <= 3; d++) {
        batten_triangles *made = NULL;
        CHECK_OK(batten_triangles_create(
            &(batten_triangles_parts){d, 1, 6 / d, points, NULL, NULL}, &made));
        const batten_box box = batten_triangles_box(made);
        const double low[3] = {box.low.x, box.low.y, box.low.z},
                     high[3] = {box.high.x, box.high.y, box.high.z};
        for (int k = 0; k < 3; k++) {
            double least = k < d ? points[k] : 0, most = least;
            for (int i = k; k < d && i < 18 / d / 3 * 3 * d; i += d) {
                least = fmin(least, points[i]);
                most = fmax(most, points[i]);
            }
            CHECK(low[k] == least && high[k] == most);
        }
        batten_triangles_unref(made);
    }
}

/* Vertices and corners of two triangles over a square that are wrong in some way. */
static const struct {
    double vertices[8];
    int corners[6];
    batten_status status;
    const char *words;
} domains[] = {
    {{0, 0, 1, 0, 0, NAN, 1, 1},
     {0, 1, 2, 3, 2, 1},
     BATTEN_NOT_FINITE,
     "coordinate 2 of vertex 3 is nan"},
    {{0, 0, 1, 0, 0, 1, INFINITY, 1},
     {0, 1, 2, 3, 2, 1},
     BATTEN_NOT_FINITE,
     "coordinate 1 of vertex 4 is inf"},
    {{0, 0, 1, 0, 0, 1, 1, 1},
     {0, 1, 2, 3, 1, 2},
     BATTEN_BAD_ARGUMENT,
     "triangle 2 of the domain, at vertices 4, 2 and 3, goes round clockwise"},
    {{0, 0, 1, 0, 0, 1, 1, 1},
     {0, 2, 1, 3, 2, 1},
     BATTEN_BAD_ARGUMENT,
     "triangle 1 of the domain, at vertices 1, 3 and 2, goes round clockwise"},
    {{0, 0, 1, 0, 2, 0, 1, 1},
     {0, 1, 2, 3, 2, 1},
     BATTEN_SINGULAR_HERE,
     "triangle 1 of the domain, at vertices 1, 2 and 3, has no area"},
    {{0, 0, 1, 0, 0, 1, 1, 1},
     {0, 1, 4, 3, 2, 1},
     BATTEN_BAD_ARGUMENT,
     "corner 3 of triangle 1 is vertex 5; there are 4"},
    {{0, 0, 1, 0, 0, 1, 1, 1},
     {0, 1, 2, 3, -1, 1},
     BATTEN_BAD_ARGUMENT,
     "corner 2 of triangle 2 is vertex 0; there are 4"},
};

TEST(a_domain_that_cannot_be_is_refused_with_its_triangle)
{
    const double values[6] = {0, 1, 2, 3, 2, 1};
    batten_triangles *none = NULL;
    for (int i = 0; i < COUNT(domains); i++) {
        const batten_triangulation domain = {4, domains[i].vertices, domains[i].corners};
        CHECK_STATUS(batten_triangles_create(
                         &(batten_triangles_parts){1, 1, 2, values, NULL, &domain}, &none),
                     domains[i].status);
        CHECK_MESSAGE(domains[i].words);
        CHECK(!none);
    }
}
