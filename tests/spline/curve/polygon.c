#include "spline/curve/curve.h"

#include <batten/curvature.h>
#include <batten/polygon.h>

#include "support/test.h"

TEST(unisurf_edges_are_the_polygon_and_its_functions_are_sums_of_bernstein_polynomials)
{
    const double start[2] = {1, 2}, edges[4][2] = {{1, 0}, {0, 2}, {-1, 1}, {3, -1}};
    batten_curve *curve = NULL;
    double at[2], back_start[2], back[4][2];
    CHECK_OK(batten_curve_from_edges(2, 4, start, &edges[0][0], &curve));
    for (int i = 0; i <= 16; i++) {
        const double t = i / 16.0;
        double wanted[2] = {start[0], start[1]};
        CHECK_OK(batten_curve_evaluate(curve, t, 0, at));
        for (int k = 1; k <= 4; k++) {
            double f = 0;
            for (int j = k; j <= 4; j++)
                f += (j == 1 || j == 3 ? 4 : j == 2 ? 6 : 1) * pow(t, j) * pow(1 - t, 4 - j);
            wanted[0] += edges[k - 1][0] * f;
            wanted[1] += edges[k - 1][1] * f;
        }
        CHECK_NEAR(at[0], wanted[0], 1e-14);
        CHECK_NEAR(at[1], wanted[1], 1e-14);
    }
    CHECK_OK(batten_curve_to_edges(curve, back_start, &back[0][0]));
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            CHECK_NEAR(back[i][k], edges[i][k], 0);
    batten_curve_unref(curve);
}

/* Bezier's own definition: f_i = (-t)^i / (i - 1)! times the (i - 1)-th derivative of
 * ((1 - t)^n - 1) / t; for n = 3: f_1 = 3 t - 3 t^2 + t^3, f_2 = 3 t^2 - 2 t^3, f_3 = t^3. */
TEST(the_functions_of_unisurf_for_cubics_are_those_of_bezier)
{
    const double start[3] = {0, 0, 0}, edges[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_edges(3, 3, start, &edges[0][0], &curve));
    for (int i = 0; i <= 10; i++) {
        const double t = i / 10.0;
        double f[3];
        CHECK_OK(batten_curve_evaluate(curve, t, 0, f));
        CHECK_NEAR(f[0], 3 * t - 3 * t * t + t * t * t, 1e-15);
        CHECK_NEAR(f[1], 3 * t * t - 2 * t * t * t, 1e-15);
        CHECK_NEAR(f[2], t * t * t, 1e-15);
    }
    batten_curve_unref(curve);
}

/* A sample of a function at i / n as polygon is Bernstein's approximation of it. */
TEST(bernstein_of_a_square_is_off_by_x_times_1_minus_x_by_n)
{
    for (int n = 1; n <= 20; n++) {
        double values[21], at;
        batten_curve *curve = NULL;
        for (int i = 0; i <= n; i++)
            values[i] = (double)i * i / ((double)n * n);
        CHECK_OK(batten_curve_bezier(1, n, values, NULL, &curve));
        for (int i = 0; i <= 10; i++) {
            const double x = i / 10.0;
            CHECK_OK(batten_curve_evaluate(curve, x, 0, &at));
            CHECK_NEAR(at, x * x + x * (1 - x) / n, 1e-14);
        }
        batten_curve_unref(curve);
    }
}

static batten_curve *uniform(int count, const double (*points)[2], batten_polygon_end ends)
{
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_uniform((batten_points){2, count, &points[0][0]}, 3, NULL, ends, &curve));
    return curve;
}

TEST(a_joint_of_uniform_cubics_is_at_a_third_of_the_median)
{
    const double V[5][2] = {{0, 0}, {1, 3}, {4, 2}, {5, -1}, {7, 0}};
    batten_curve *curve = uniform(5, V, BATTEN_POLYGON_FREE);
    double at[3][2];
    CHECK_INT(batten_curve_spans(curve, NULL), 3);
    CHECK_OK(batten_curve_evaluate(curve, batten_curve_domain(curve).a, 2, &at[0][0]));
    for (int k = 0; k < 2; k++) {
        CHECK_NEAR(at[0][k], (V[0][k] + 4 * V[1][k] + V[2][k]) / 6, 1e-15);
        CHECK_NEAR(at[1][k], (V[2][k] - V[0][k]) / 2, 1e-15);
        CHECK_NEAR(at[2][k], V[0][k] - 2 * V[1][k] + V[2][k], 1e-14);
    }
    batten_curve_unref(curve);
}

TEST(three_vertices_in_line_make_a_point_without_curvature_on_the_line)
{
    const double V[5][2] = {{0, 0}, {1, 1}, {3, 3}, {4, 1}, {5, 0}};
    batten_curve *curve = uniform(5, V, BATTEN_POLYGON_FREE);
    batten_curve_local at;
    CHECK_OK(
        batten_curve_local_at(curve, batten_curve_domain(curve).a, BATTEN_FROM_RIGHT, &at));
    CHECK_NEAR(at.point.x, at.point.y, 1e-15);
    CHECK_NEAR(at.tangent.x, at.tangent.y, 1e-15);
    CHECK_NEAR(at.curvature, 0, 1e-15);
    batten_curve_unref(curve);
}

TEST(a_double_vertex_draws_the_joint_to_a_sixth_of_the_edge)
{
    const double V[5][2] = {{0, 0}, {6, 0}, {6, 0}, {6, 6}, {0, 6}};
    batten_curve *curve = uniform(5, V, BATTEN_POLYGON_FREE);
    batten_curve_local at;
    CHECK_OK(
        batten_curve_local_at(curve, batten_curve_domain(curve).a, BATTEN_FROM_RIGHT, &at));
    CHECK_NEAR(hypot(at.point.x - 6, at.point.y), 1, 1e-14);
    CHECK_NEAR(at.curvature, 0, 1e-14);
    batten_curve_unref(curve);
}

TEST(a_triple_vertex_is_a_corner_where_the_derivatives_vanish)
{
    const double V[7][2] = {{0, 0}, {3, 0}, {6, 0}, {6, 0}, {6, 0}, {6, 3}, {6, 6}};
    batten_curve *curve = uniform(7, V, BATTEN_POLYGON_FREE);
    double at[3][2];
    CHECK_OK(batten_curve_evaluate(curve, batten_curve_domain(curve).a + 2, 2, &at[0][0]));
    CHECK_NEAR(at[0][0], 6, 1e-15);
    CHECK_NEAR(at[0][1], 0, 1e-15);
    for (int k = 0; k < 4; k++)
        CHECK_NEAR((&at[1][0])[k], 0, 1e-14);
    batten_curve_local left, right;
    const double u = batten_curve_domain(curve).a + 2;
    CHECK_STATUS(batten_curve_local_at(curve, u, BATTEN_FROM_LEFT, &left),
                 BATTEN_SINGULAR_HERE);
    CHECK_STATUS(batten_curve_local_at(curve, u, BATTEN_FROM_RIGHT, &right),
                 BATTEN_SINGULAR_HERE);
    CHECK_NEAR(left.tangent.x, 1, 1e-14);
    CHECK_NEAR(right.tangent.y, 1, 1e-14);
    batten_curve_unref(curve);
}

TEST(phantom_vertices_end_the_curve_at_the_polygon_without_curvature)
{
    const double V[5][2] = {{0, 0}, {1, 3}, {4, 2}, {5, -1}, {7, 0}};
    const batten_polygon_end kinds[] = {BATTEN_POLYGON_PHANTOM, BATTEN_POLYGON_REPEATED,
                                        BATTEN_POLYGON_CLAMPED};
    for (int i = 0; i < COUNT(kinds); i++) {
        batten_curve *curve = uniform(5, V, kinds[i]);
        const batten_interval domain = batten_curve_domain(curve);
        double at[2];
        batten_curve_local local;
        CHECK_OK(batten_curve_evaluate(curve, domain.a, 0, at));
        CHECK_NEAR(at[0], 0, 1e-15);
        CHECK_NEAR(at[1], 0, 1e-15);
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 0, at));
        CHECK_NEAR(at[0], 7, 1e-14);
        if (kinds[i] == BATTEN_POLYGON_PHANTOM) {
            CHECK_OK(batten_curve_local_at(curve, domain.a, BATTEN_FROM_RIGHT, &local));
            CHECK_NEAR(local.curvature, 0, 1e-14);
        }
        batten_curve_unref(curve);
    }
}

TEST(a_closed_polygon_gives_a_closed_curve)
{
    const double V[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    batten_curve *curve = uniform(4, V, BATTEN_POLYGON_CLOSED);
    CHECK(batten_curve_is_periodic(curve));
    CHECK(batten_curve_is_closed(curve, 1e-15));
    batten_curve_unref(curve);
}

TEST(K9_degrees_and_counts_of_polygons_are_checked)
{
    const double V[2][2] = {{0, 0}, {1, 0}};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_uniform((batten_points){2, 2, &V[0][0]}, 0, NULL,
                                      BATTEN_POLYGON_FREE, &curve),
                 BATTEN_BAD_DEGREE);
    CHECK_STATUS(batten_curve_uniform((batten_points){2, 2, &V[0][0]}, 3, NULL,
                                      BATTEN_POLYGON_FREE, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_curve_uniform((batten_points){2, 2, &V[0][0]}, 2, NULL,
                                      BATTEN_POLYGON_PHANTOM, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_from_edges(2, 26, V[0], &V[0][0], &curve), BATTEN_BAD_DEGREE);
    CHECK_OK(batten_curve_uniform((batten_points){2, 2, &V[0][0]}, 3, NULL,
                                  BATTEN_POLYGON_REPEATED, &curve));
    batten_curve_unref(curve);
}

TEST(uniform_cubics_blend_as_in_the_notes)
{
    static const struct {
        double V[6], rows[3][4], share; /* rows: s^3 .. 1, times share */
    } blends[] = {
        {{1, 1, 1, 0, 0, 0}, {{-1, 0, 0, 6}, {2, -3, -3, 5}, {-1, 3, -3, 1}}, 1 / 6.0},
        {{-1 / 3.0, 0, 1 / 3.0, 0, 0, 0},
         {{-2, 0, 6, 0}, {3, -6, 0, 4}, {-1, 3, -3, 1}},
         1 / 18.0},
    };
    for (int which = 0; which < 4; which++) {
        const int mirrored = which % 2; /* F1(u) = F0(1 - u), G1(u) = -G0(1 - u) */
        const double sign = which == 3 ? -1 : 1;
        double V[6], at[3];
        for (int i = 0; i < 6; i++)
            V[i] = sign * blends[which / 2].V[mirrored ? 5 - i : i];
        batten_curve *uniform = NULL, *curve = NULL;
        CHECK_OK(batten_curve_uniform((batten_points){1, 6, V}, 3, NULL, BATTEN_POLYGON_FREE,
                                      &uniform));
        CHECK_OK(batten_curve_set_domain(uniform, 0, 1, &curve));
        for (int i = 0; i <= 30; i++) {
            const double u = mirrored ? 1 - i / 30.0 : i / 30.0;
            const int span = u >= 1 ? 2 : (int)(3 * u);
            const double s = 3 * u - span, *r = blends[which / 2].rows[span];
            CHECK_OK(batten_curve_evaluate(curve, i / 30.0, 0, at));
            CHECK_NEAR(at[0],
                       sign * blends[which / 2].share *
                           (((r[0] * s + r[1]) * s + r[2]) * s + r[3]),
                       1e-15);
        }
        for (int end = 0; end < 2; end++) {
            CHECK_OK(batten_curve_evaluate(curve, end, 2, at));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(at[k], k == which / 2 && end == mirrored, 1e-14);
        }
        batten_curve_unref(uniform);
        batten_curve_unref(curve);
    }
}

TEST(polygons_of_other_dimensions_and_degrees_are_refused)
{
    const double V[8] = {0, 0, 1, 2, 3, 1, 4, 4};
    batten_curve *curve = NULL;
    for (int i = 0; i < 2; i++) {
        const int dimension = i ? 4 : 0, degree = i ? BATTEN_MAX_DEGREE + 1 : 0;
        CHECK_STATUS(batten_curve_from_edges(dimension, 1, V, V + 2, &curve),
                     BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curve_from_edges(2, degree, V, V + 2, &curve), BATTEN_BAD_DEGREE);
        CHECK_STATUS(batten_curve_uniform((batten_points){dimension, 2, V}, 1, NULL,
                                          BATTEN_POLYGON_FREE, &curve),
                     BATTEN_BAD_ARGUMENT);
        CHECK_STATUS(batten_curve_uniform((batten_points){2, 4, V}, degree, NULL,
                                          BATTEN_POLYGON_CLOSED, &curve),
                     BATTEN_BAD_DEGREE);
    }
    CHECK_STATUS(
        batten_curve_uniform((batten_points){2, 1, V}, 3, NULL, BATTEN_POLYGON_CLOSED, &curve),
        BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("1 vertex; 2 are needed");
    CHECK_STATUS(batten_curve_uniform((batten_points){2, BAT_MAX_POINTS, V}, 3, NULL,
                                      BATTEN_POLYGON_CLOSED, &curve),
                 BATTEN_TOO_LARGE);
    CHECK(!curve);
}

TEST(edges_are_those_of_one_polynomial_span)
{
    const double V[8] = {0, 0, 1, 2, 3, 1, 4, 4}, weights[4] = {1, 2, 2, 1};
    double start[2] = {9, 9}, edges[6];
    batten_curve *rational = NULL, *spans = NULL, *loose = NULL;
    CHECK_OK(batten_curve_bezier(2, 3, V, weights, &rational));
    CHECK_STATUS(batten_curve_to_edges(rational, start, edges), BATTEN_BAD_ARGUMENT);
    CHECK_OK(batten_curve_uniform((batten_points){2, 4, V}, 2, NULL, BATTEN_POLYGON_CLAMPED,
                                  &spans));
    CHECK_STATUS(batten_curve_to_edges(spans, start, edges), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("this curve has 4 control points of degree 2");
    CHECK_OK(
        batten_curve_uniform((batten_points){2, 4, V}, 3, NULL, BATTEN_POLYGON_FREE, &loose));
    CHECK_STATUS(batten_curve_to_edges(loose, start, edges), BATTEN_BAD_ARGUMENT);
    CHECK_BITS(start[0], 9);
    batten_curve_unref(rational);
    batten_curve_unref(spans);
    batten_curve_unref(loose);
}

TEST(weights_of_added_vertices_are_those_of_the_ends)
{
    /* Repeated ends: so are their weights, and the curve begins at the first vertex. */
    const double V[6] = {0, 0, 1, 2, 3, 1}, weights[3] = {2, 1, 4};
    batten_curve *curve = NULL;
    double at[2];
    CHECK_OK(batten_curve_uniform((batten_points){2, 3, V}, 3, weights, BATTEN_POLYGON_REPEATED,
                                  &curve));
    CHECK_INT(batten_curve_point_count(curve), 7);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(batten_curve_weights(curve)[i], 2, 0);
        CHECK_NEAR(batten_curve_weights(curve)[4 + i], 4, 0);
    }
    CHECK_OK(batten_curve_evaluate(curve, batten_curve_domain(curve).b, 0, at));
    CHECK_NEAR(at[0], 3, 1e-15);
    CHECK_NEAR(at[1], 1, 1e-15);
    batten_curve_unref(curve);
}
