#include <batten/scattered.h>

#include "support/faults.h"
#include "support/test.h"

#include <string.h>

/* A random triangulation with values and gradients. */
enum { MANY = 40 };
typedef struct {
    batten_plane_triangles t;
    batten_triangulation domain;
    double f[MANY], g[2 * MANY];
} example;

static double quadratic(double x, double y, double *g)
{
    if (g) {
        g[0] = 2 * x - 3 * y + 1;
        g[1] = -3 * x + 4 * y - 2;
    }
    return x * x - 3 * x * y + 2 * y * y + x - 2 * y + 5;
}

static double cubic(double x, double y, double *g)
{
    if (g) {
        g[0] = 3 * x * x - 4 * x * y + y * y + 1;
        g[1] = -2 * x * x + 2 * x * y - 6 * y * y;
    }
    return x * x * x - 2 * x * x * y + x * y * y - 2 * y * y * y + x;
}

static void begin(example *e, test_random *random)
{
    double points[2 * MANY];
    for (int i = 0; i < 2 * MANY; i++)
        points[i] = test_random_in(random, -1, 1);
    CHECK_OK(batten_triangulate((batten_points){2, MANY, points}, NULL, &e->t));
    e->domain = (batten_triangulation){e->t.vertex_count, e->t.vertices, e->t.corners};
}

static void set(example *e, double (*f)(double, double, double *))
{
    for (int v = 0; v < e->t.vertex_count; v++)
        e->f[v] = f(e->t.vertices[2 * v], e->t.vertices[2 * v + 1], e->g + 2 * v);
}

/* The set is f, with its derivatives, at random places of its pieces. */
static void check_is(const batten_triangles *triangles, double (*f)(double, double, double *),
                     test_random *random, double tolerance)
{
    batten_triangulation domain;
    CHECK(batten_triangles_domain(triangles, &domain));
    for (int t = 0; t < batten_triangles_count(triangles); t++) {
        double b[3], p[2] = {0, 0}, value[3], g[2];
        b[0] = test_random_unit(random);
        b[1] = (1 - b[0]) * test_random_unit(random);
        b[2] = 1 - b[0] - b[1];
        for (int k = 0; k < 6; k++)
            p[k % 2] += b[k / 2] * domain.vertices[2 * domain.corners[3 * t + k / 2] + k % 2];
        CHECK_OK(batten_triangles_evaluate(triangles, t, b, 0, value));
        CHECK_NEAR(value[0], f(p[0], p[1], g), tolerance);
        CHECK_OK(batten_triangles_over(triangles, (batten_batch){1, p}, 1,
                                       (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, NULL},
                                       NULL, value));
        CHECK_NEAR(value[0], f(p[0], p[1], g), tolerance);
        CHECK_NEAR(value[1], g[0], 1e3 * tolerance);
        CHECK_NEAR(value[2], g[1], 1e3 * tolerance);
    }
}

static void check_smooth(const batten_triangles *triangles, double tolerance)
{
    batten_triangle_joins joins = {0, NULL};
    CHECK_OK(batten_triangles_joins(triangles, 1e-9, &joins));
    CHECK(joins.count > 0);
    for (int i = 0; i < joins.count; i++) {
        CHECK_NEAR(joins.at[i].gap, 0, tolerance);
        CHECK_NEAR(joins.at[i].slope, 0, tolerance);
    }
    batten_triangle_joins_release(&joins);
}

TEST(quadratics_with_their_gradients_are_met_exactly)
{
    test_random random = test_random_begin(__func__);
    example e;
    batten_triangles *out = NULL;
    begin(&e, &random);
    set(&e, quadratic);
    CHECK_EACH_ALLOCATION(
        batten_triangles_clough_tocher(&e.domain, e.t.count, e.f, e.g, NULL, &out));
    check_is(out, quadratic, &random, 1e-13);
    batten_triangles_unref(out);
    double thinnest = -1;
    CHECK_EACH_ALLOCATION(
        batten_triangles_powell_sabin(&e.domain, e.t.count, e.f, e.g, &thinnest, &out));
    check_is(out, quadratic, &random, 1e-13);
    CHECK(thinnest > 0 && thinnest <= 0.5);
    batten_triangles_unref(out);
    batten_plane_triangles_release(&e.t);
}

TEST(cubics_with_their_slopes_across_edges_are_met_exactly)
{
    test_random random = test_random_begin(__func__);
    example e;
    batten_triangles *out = NULL;
    begin(&e, &random);
    set(&e, cubic);
    double *middles = test_array(6 * (size_t)e.t.count, sizeof *middles);
    for (int i = 0; i < 3 * e.t.count; i++) {
        const int a = e.t.corners[3 * (i / 3) + (i + 1) % 3],
                  b = e.t.corners[3 * (i / 3) + (i + 2) % 3];
        cubic((e.t.vertices[2 * a] + e.t.vertices[2 * b]) / 2,
              (e.t.vertices[2 * a + 1] + e.t.vertices[2 * b + 1]) / 2, middles + 2 * i);
    }
    CHECK_OK(batten_triangles_clough_tocher(&e.domain, e.t.count, e.f, e.g, middles, &out));
    check_is(out, cubic, &random, 1e-12);
    check_smooth(out, 1e-13);
    batten_triangles_unref(out);
    batten_plane_triangles_release(&e.t);
}

TEST(random_values_and_gradients_give_smooth_functions_with_them)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(6); c++) {
        example e;
        batten_triangles *out[2] = {NULL, NULL};
        begin(&e, &random);
        for (int i = 0; i < 2 * MANY; i++) {
            e.f[i / 2] = test_random_in(&random, -1, 1);
            e.g[i] = test_random_in(&random, -3, 3);
        }
        CHECK_OK(batten_triangles_clough_tocher(&e.domain, e.t.count, e.f, e.g, NULL, &out[0]));
        CHECK_OK(batten_triangles_powell_sabin(&e.domain, e.t.count, e.f, e.g, NULL, &out[1]));
        for (int k = 0; k < 2; k++) {
            double found[3 * MANY];
            check_smooth(out[k], 1e-9);
            CHECK_OK(batten_triangles_over(
                out[k], (batten_batch){MANY, e.t.vertices}, 1,
                (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, NULL}, NULL, found));
            for (int v = 0; v < MANY; v++) {
                CHECK_NEAR(found[3 * v], e.f[v], 1e-13);
                CHECK_NEAR(found[3 * v + 1], e.g[2 * v], 1e-7);
                CHECK_NEAR(found[3 * v + 2], e.g[2 * v + 1], 1e-7);
            }
            batten_triangles_unref(out[k]);
        }
        batten_plane_triangles_release(&e.t);
    }
}

static const double corners[6] = {0, 0, 2, 0.3, 0.7, 1.8}, places[4] = {0.8, 0.5, 1.2, 0.9};

/* Two sets have equal values at the places; both are given back. */
static void check_same(batten_triangles *one, batten_triangles *other, double tolerance)
{
    double value[2][2];
    CHECK_OK(batten_triangles_over(one, (batten_batch){2, places}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   value[0]));
    CHECK_OK(batten_triangles_over(other, (batten_batch){2, places}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   value[1]));
    for (int i = 0; i < 2; i++)
        CHECK_NEAR(value[0][i], value[1][i], tolerance);
    batten_triangles_unref(one);
    batten_triangles_unref(other);
}

/* The slopes across edges are given with the edges: edge e of the turned triangle is edge e
 * + 2. */
TEST(elements_commute_with_the_order_of_corners)
{
    test_random random = test_random_begin(__func__);
    const int plain[3] = {0, 1, 2}, turned[3] = {2, 0, 1};
    const batten_triangulation one = {3, corners, plain}, two = {3, corners, turned};
    double f[3], g[6], middles[6], changed[6];
    for (int i = 0; i < 6; i++) {
        f[i / 2] = test_random_in(&random, -1, 1);
        g[i] = test_random_in(&random, -1, 1);
        middles[i] = 0.2 * i;
    }
    for (int e = 0; e < 3; e++)
        memcpy(changed + 2 * e, middles + 2 * ((e + 2) % 3), 2 * sizeof *changed);
    batten_triangles *made = NULL, *other = NULL;
    CHECK_OK(batten_triangles_clough_tocher(&one, 1, f, g, middles, &made));
    CHECK_OK(batten_triangles_clough_tocher(&two, 1, f, g, changed, &other));
    check_same(made, other, 1e-14);
    made = other = NULL;
    CHECK_OK(batten_triangles_powell_sabin(&one, 1, f, g, NULL, &made));
    CHECK_OK(batten_triangles_powell_sabin(&two, 1, f, g, NULL, &other));
    check_same(made, other, 1e-14);
}

/* Condensed slopes are across edges, so that the element does not commute with maps; but it
 * meets planes over the image of a triangle. */
TEST(planes_are_met_over_the_affine_image_of_a_triangle)
{
    const double m[4] = {1.5, 0.4, -0.3, 2};
    const int turned[3] = {2, 0, 1};
    double q[6], h[6], plane[3], mapped[4], value[2];
    for (int v = 0; v < 3; v++) {
        q[2 * v] = m[0] * corners[2 * v] + m[1] * corners[2 * v + 1] + 3;
        q[2 * v + 1] = m[2] * corners[2 * v] + m[3] * corners[2 * v + 1] + 1;
        plane[v] = 2 * q[2 * v] - q[2 * v + 1];
        h[2 * v] = 2;
        h[2 * v + 1] = -1;
    }
    for (int i = 0; i < 2; i++) {
        mapped[2 * i] = m[0] * places[2 * i] + m[1] * places[2 * i + 1] + 3;
        mapped[2 * i + 1] = m[2] * places[2 * i] + m[3] * places[2 * i + 1] + 1;
    }
    const batten_triangulation domain = {3, q, turned};
    batten_triangles *made = NULL;
    CHECK_OK(batten_triangles_clough_tocher(&domain, 1, plane, h, NULL, &made));
    CHECK_OK(batten_triangles_over(made, (batten_batch){2, mapped}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   value));
    for (int i = 0; i < 2; i++)
        CHECK_NEAR(value[i], 2 * mapped[2 * i] - mapped[2 * i + 1], 1e-13);
    batten_triangles_unref(made);
}

TEST(bad_domains_and_numbers_are_refused_by_name)
{
    const double p[8] = {0, 0, 1, 0, 0, 1, 1, 1}, f[4] = {0, 0, 0, 0}, bad[4] = {0, 0, NAN, 0};
    double g[8] = {0};
    const int clockwise[3] = {0, 2, 1}, nowhere[3] = {0, 1, 7}, flat[3] = {0, 1, 1};
    const int good[3] = {0, 1, 2};
    batten_triangulation domain = {4, p, clockwise};
    batten_triangles *out = NULL;
    CHECK_STATUS(batten_triangles_clough_tocher(&domain, 1, f, g, NULL, &out),
                 BATTEN_BAD_ARGUMENT);
    domain.corners = nowhere;
    CHECK_STATUS(batten_triangles_powell_sabin(&domain, 1, f, g, NULL, &out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("vertex 8");
    domain.corners = flat;
    CHECK_STATUS(batten_triangles_clough_tocher(&domain, 1, f, g, NULL, &out),
                 BATTEN_SINGULAR_HERE);
    domain.corners = good;
    CHECK_STATUS(batten_triangles_linear(&domain, 1, bad, &out), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("vertex 3");
    g[5] = INFINITY;
    CHECK_STATUS(batten_triangles_powell_sabin(&domain, 1, f, g, NULL, &out),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("component 2 of the gradient at vertex 3");
    g[5] = 0;
    CHECK_STATUS(batten_triangles_clough_tocher(&domain, 1000000, f, g, NULL, &out),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("30000000 control points");
    double value[1];
    const double outside[2] = {3, 0.5};
    size_t count = 0;
    CHECK_EACH_ALLOCATION(batten_triangles_linear(&domain, 1, p + 2, &out));
    CHECK_STATUS(batten_triangles_over(out, (batten_batch){1, outside}, 0,
                                       (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL},
                                       NULL, value),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("(3, 0.5)");
    CHECK_OK(batten_triangles_over(out, (batten_batch){1, outside}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_CLAMPED, &count},
                                   NULL, value));
    CHECK_INT((int)count, 1);
    CHECK_NEAR(value[0], p[3], 0); /* the value at vertex 1, which is nearest */
    batten_triangles_unref(out);
}
