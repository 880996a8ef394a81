#include <batten/grid.h>
#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

#include <string.h>

static const double us[] = {0, 0.3, 0.8, 1.1, 1.9, 2.4, 3},
                    vs[] = {-1, -0.6, 0.2, 0.5, 1.3, 1.6};

/* A bicubic with all its mixed terms, and a smooth function that is none. */
static double bicubic(double u, double v, int k, int l)
{
    const double U = k == 0 ? u * u * u - u + 2 : k == 1 ? 3 * u * u - 1 : 6 * u;
    const double V = l == 0 ? v * v * v + v * v - 3 : l == 1 ? 3 * v * v + 2 * v : 6 * v + 2;
    return U * V;
}

static double smooth(double u, double v)
{
    return sin(u) * cos(v);
}

static batten_surface_interpolate_options given(const double *u, const double *v)
{
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = u;
    options.given_v = v;
    return options;
}

static double derivative(const batten_surface *s, double u, double v, int k, int l)
{
    double out[6];
    CHECK_OK(batten_surface_evaluate(s, u, v, k + l, out));
    return out[BATTEN_SURFACE_DERIVATIVE(k, l)];
}

static void check_bicubic(const batten_surface *s)
{
    for (int i = 0; i <= 12; i++)
        for (int j = 0; j <= 13; j++) {
            const double u = i * 0.25, v = -1 + j * 0.2;
            CHECK_NEAR(derivative(s, u, v, 0, 0), bicubic(u, v, 0, 0), 1e-12 * 150);
            CHECK_NEAR(derivative(s, u, v, 1, 1), bicubic(u, v, 1, 1), 1e-10 * 150);
        }
}

static void fill_bicubic(double *points)
{
    for (int i = 0; i < 7; i++)
        for (int j = 0; j < 6; j++)
            points[i * 6 + j] = bicubic(us[i], vs[j], 0, 0);
}

TEST(bicubics_are_reproduced_by_both_families)
{
    const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_FAIR};
    double points[42];
    fill_bicubic(points);
    for (int c = 0; c < 3; c++) {
        batten_surface_interpolate_options options = given(us, vs);
        options.knots_at_data = c < 2;
        options.ends = kinds[c % 2];
        batten_surface *surface = NULL;
        batten_surface_interpolate_report report;
        CHECK_EACH_ALLOCATION(
            batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options, NULL,
                                       (batten_uv_out){NULL, NULL}, &report, &surface));
        CHECK(report.error < 1e-13 * 150 && report.spread_u == 0);
        check_bicubic(surface);
        batten_surface_unref(surface);
    }
}

TEST(true_derivatives_on_the_rim_are_met_twists_included)
{
    double points[42], du[12], dv[14], twists[4];
    fill_bicubic(points);
    for (int i = 0; i < 2; i++) {
        const double u = i ? us[6] : us[0];
        for (int j = 0; j < 6; j++)
            du[i * 6 + j] = bicubic(u, vs[j], 1, 0);
        for (int j = 0; j < 7; j++)
            dv[i * 7 + j] = bicubic(us[j], i ? vs[5] : vs[0], 0, 1);
        for (int j = 0; j < 2; j++)
            twists[i * 2 + j] = bicubic(u, j ? vs[5] : vs[0], 1, 1);
    }
    batten_surface_interpolate_options options = given(us, vs);
    options.knots_at_data = true;
    options.du = du;
    options.dv = dv;
    options.twists = twists;
    batten_surface *surface = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options,
                                                     NULL, (batten_uv_out){NULL, NULL}, NULL,
                                                     &surface));
    CHECK_INT(batten_surface_point_count(surface, BATTEN_U), 9);
    CHECK_INT(batten_surface_point_count(surface, BATTEN_V), 8);
    check_bicubic(surface);
    batten_surface_unref(surface);
    /* Other twists are met too, and change nothing but the inside. */
    twists[1] += 7;
    CHECK_OK(batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &surface));
    CHECK_NEAR(derivative(surface, us[0], vs[5], 1, 1), twists[1], 1e-9);
    CHECK_NEAR(derivative(surface, us[3], vs[5], 0, 1), dv[7 + 3], 1e-11);
    CHECK_NEAR(derivative(surface, us[6], vs[2], 1, 0), du[6 + 2], 1e-10);
    batten_surface_unref(surface);
    /* Without twists they are estimated; with one family of derivatives the other is a kind of
     * end. */
    for (int c = 0; c < 3; c++) {
        options.twists = NULL;
        options.du = c == 1 ? NULL : du;
        options.dv = c == 2 ? NULL : dv;
        CHECK_OK(batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface));
        if (options.du)
            CHECK_NEAR(derivative(surface, us[6], vs[2], 1, 0), du[6 + 2], 1e-10);
        if (options.dv)
            CHECK_NEAR(derivative(surface, us[3], vs[5], 0, 1), dv[7 + 3], 1e-11);
        if (c > 0)
            check_bicubic(surface);
        batten_surface_unref(surface);
    }
}

/* (1 + u^p)(2 - v^q) and its derivatives. */
static double powers(int p, int q, double u, double v, int k, int l)
{
    const double a = k == 0 ? 1 + pow(u, p) : p * pow(u, p - 1);
    const double b = l == 0 ? 2 - pow(v, q) : -q * pow(v, q - 1);
    return a * b;
}

/* Bessel's slopes are those of parabolas, and of the line where there are two points. */
TEST(twists_that_are_estimated_are_true_for_parabolas)
{
    static const int counts[][2] = {{7, 6}, {3, 4}, {2, 6}, {7, 2}, {2, 2}};
    for (int c = 0; c < COUNT(counts); c++) {
        const int n = counts[c][0], m = counts[c][1], p = n > 2 ? 2 : 1, q = m > 2 ? 2 : 1;
        double points[42], du[12], dv[14];
        for (int i = 0; i < n; i++)
            for (int j = 0; j < m; j++)
                points[i * m + j] = powers(p, q, us[i], vs[j], 0, 0);
        for (int end = 0; end < 2; end++) {
            for (int j = 0; j < m; j++)
                du[end * m + j] = powers(p, q, us[end * (n - 1)], vs[j], 1, 0);
            for (int i = 0; i < n; i++)
                dv[end * n + i] = powers(p, q, us[i], vs[end * (m - 1)], 0, 1);
        }
        batten_surface_interpolate_options options = given(us, vs);
        options.knots_at_data = true;
        options.du = du;
        options.dv = dv;
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_interpolate((batten_grid){1, n, m, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface));
        for (int i = 0; i <= 8; i++)
            for (int j = 0; j <= 8; j++) {
                const double u = us[0] + (us[n - 1] - us[0]) * i / 8,
                             v = vs[0] + (vs[m - 1] - vs[0]) * j / 8;
                CHECK_NEAR(derivative(surface, u, v, 0, 0), powers(p, q, u, v, 0, 0), 1e-10);
                CHECK_NEAR(derivative(surface, u, v, 1, 1), powers(p, q, u, v, 1, 1), 1e-8);
            }
        batten_surface_unref(surface);
    }
}

static void fill(test_random *random, int count_u, int count_v, double *points)
{
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++) {
            double *p = points + (i * count_v + j) * 3;
            p[0] = i + test_random_in(random, -0.2, 0.2);
            p[1] = j + test_random_in(random, -0.2, 0.2);
            p[2] = test_random_in(random, -1, 1);
        }
}

static void check_passes(const batten_surface *s, int count_u, int count_v,
                         const double *points, const double *u, const double *v)
{
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++) {
            double out[3];
            CHECK_OK(batten_surface_evaluate(s, u[i], v[j], 0, out));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(out[k], points[(i * count_v + j) * 3 + k], 1e-12 * 20);
        }
}

TEST(every_degree_family_and_period_passes_its_points)
{
    test_random random = test_random_begin("grid");
    const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_NATURAL,
                                     BATTEN_END_PARABOLIC, BATTEN_END_BESSEL, BATTEN_END_FAIR};
    for (int c = 0; c < test_cases(120); c++) {
        const int count_u = 2 + c % 7, count_v = 2 + c / 7 % 6;
        double points[8 * 7 * 3], u[8], v[7];
        fill(&random, count_u, count_v, points);
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        options.parameters = (batten_parametrization)(c % 5);
        options.closed_u = c % 3 == 1;
        options.closed_v = c % 4 == 1;
        options.knots_at_data = c % 2;
        options.ends = kinds[c % 5];
        if (!options.knots_at_data) {
            options.degree_u = 1 + c % 5;
            options.degree_v = 1 + c / 5 % 5;
        }
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_interpolate((batten_grid){3, count_u, count_v, points},
                                            &options, NULL, (batten_uv_out){u, v}, NULL,
                                            &surface));
        check_passes(surface, count_u, count_v, points, u, v);
        CHECK(batten_surface_is_periodic(surface, BATTEN_U) == options.closed_u);
        batten_surface_unref(surface);
    }
}

TEST(exchanging_u_and_v_exchanges_the_surface)
{
    test_random random = test_random_begin("swap");
    for (int c = 0; c < test_cases(20); c++) {
        double points[6 * 5 * 3], swapped[90], du[30], dv[36];
        fill(&random, 6, 5, points);
        for (int i = 0; i < 36; i++)
            (i < 30 ? du[i] = test_random_unit(&random) : 0), dv[i] = test_random_unit(&random);
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 5; j++)
                memcpy(swapped + (j * 6 + i) * 3, points + (i * 5 + j) * 3, 24);
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        options.knots_at_data = c % 3 > 0;
        if (c % 3 == 2)
            options.du = du, options.dv = dv;
        batten_surface *a = NULL, *b = NULL;
        CHECK_OK(batten_surface_interpolate((batten_grid){3, 6, 5, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &a));
        if (c % 3 == 2)
            options.du = dv, options.dv = du;
        CHECK_OK(batten_surface_interpolate((batten_grid){3, 5, 6, swapped}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &b));
        for (int i = 0; i <= 10; i++)
            for (int j = 0; j <= 10; j++) {
                double p[3], q[3];
                CHECK_OK(batten_surface_evaluate(a, i / 10.0, j / 10.0, 0, p));
                CHECK_OK(batten_surface_evaluate(b, j / 10.0, i / 10.0, 0, q));
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(p[k], q[k], 1e-12 * 20);
            }
        batten_surface_unref(b);
        batten_surface_unref(a);
    }
}

TEST(clamped_surfaces_converge_with_the_fourth_power_natural_ones_with_the_second)
{
    double error[2][3];
    for (int natural = 0; natural < 2; natural++)
        for (int s = 0; s < 3; s++) {
            const int n = (8 << s) + 1;
            double t[33], points[33 * 33], du[66], dv[66], twists[4];
            for (int i = 0; i < n; i++)
                t[i] = 0.5 + 1.0 * i / (n - 1);
            for (int i = 0; i < n; i++)
                for (int j = 0; j < n; j++)
                    points[i * n + j] = smooth(t[i], t[j]);
            for (int e = 0; e < 2; e++) {
                const double at = e ? t[n - 1] : t[0];
                for (int j = 0; j < n; j++) {
                    du[e * n + j] = cos(at) * cos(t[j]);
                    dv[e * n + j] = -sin(t[j]) * sin(at);
                }
                twists[2 * e] = -cos(at) * sin(t[0]);
                twists[2 * e + 1] = -cos(at) * sin(t[n - 1]);
            }
            batten_surface_interpolate_options options = given(t, t);
            options.knots_at_data = true;
            options.ends = BATTEN_END_NATURAL;
            if (!natural)
                options.du = du, options.dv = dv, options.twists = twists;
            batten_surface *surface = NULL;
            CHECK_OK(batten_surface_interpolate((batten_grid){1, n, n, points}, &options, NULL,
                                                (batten_uv_out){NULL, NULL}, NULL, &surface));
            error[natural][s] = 0;
            for (int i = 0; i <= 64; i++)
                for (int j = 0; j <= 64; j++) {
                    const double u = 0.5 + i / 64.0, v = 0.5 + j / 64.0;
                    error[natural][s] =
                        fmax(error[natural][s],
                             fabs(derivative(surface, u, v, 0, 0) - smooth(u, v)));
                }
            batten_surface_unref(surface);
        }
    CHECK_NEAR(log2(error[0][0] / error[0][1]), 4, 0.3);
    CHECK_NEAR(log2(error[0][1] / error[0][2]), 4, 0.3);
    CHECK_NEAR(log2(error[1][1] / error[1][2]), 2, 0.3);
}

TEST(a_torus_from_a_closed_grid_has_no_seam)
{
    double points[16 * 16 * 3];
    for (int i = 0; i < 16; i++)
        for (int j = 0; j < 16; j++) {
            const double a = i * acos(0) / 4, b = j * acos(0) / 4, r = 3 + cos(b);
            const double p[3] = {r * cos(a), r * sin(a), sin(b)};
            memcpy(points + (i * 16 + j) * 3, p, sizeof p);
        }
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.closed_u = options.closed_v = true;
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 16, 16, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &torus));
    for (int i = 0; i < 8; i++) {
        double low[18], high[18];
        CHECK_OK(batten_surface_evaluate_side(
            torus, 0, i / 8.0, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, 2, low));
        CHECK_OK(batten_surface_evaluate_side(
            torus, 1, i / 8.0, (batten_sides){BATTEN_FROM_LEFT, BATTEN_FROM_RIGHT}, 2, high));
        for (int k = 0; k < 18; k++)
            CHECK_NEAR(low[k], high[k], 1e-9);
        double out[3];
        CHECK_OK(batten_surface_evaluate(torus, i / 8.0 + 0.03, 0.4, 0, out));
        const double ring = hypot(out[0], out[1]) - 3;
        CHECK_NEAR(hypot(ring, out[2]), 1, 5e-4);
    }
    batten_surface_unref(torus);
}

TEST(G5_a_collapsed_rim_stays_one_point_and_its_row_is_left_out_of_the_average)
{
    double points[5 * 6 * 3], u[5], v[6];
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 6; j++) {
            const double p[3] = {0.1 * i * cos(0.3 * j), 0.1 * i * sin(0.3 * j),
                                 0.7 - 0.01 * i * i};
            memcpy(points + (i * 6 + j) * 3, p, sizeof p);
        }
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 5, 6, points}, NULL, NULL,
                                        (batten_uv_out){u, v}, NULL, &surface));
    for (int j = 1; j < 6; j++)
        CHECK_NEAR(v[j] - v[j - 1], 0.2, 1e-14);
    const double *P = batten_surface_points(surface);
    for (int j = 0; j < 6; j++)
        for (int k = 0; k < 3; k++)
            CHECK_BITS(P[j * 3 + k], points[k]);
    batten_surface_unref(surface);
}

TEST(rows_with_other_spacings_are_reported)
{
    double points[4 * 5 * 3];
    const double spacing[2][5] = {{0, 1, 2, 3, 4}, {0, 0.1, 0.3, 0.8, 4}};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 5; j++) {
            const double p[3] = {i, spacing[i % 2][j], 0};
            memcpy(points + (i * 5 + j) * 3, p, sizeof p);
        }
    batten_surface *surface = NULL;
    batten_surface_interpolate_report report;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 4, 5, points}, NULL, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &surface));
    CHECK(report.spread_v > 0.5);
    batten_surface_unref(surface);
    /* Both spacings of the average are (0 + 0) / 2 for a grid of squares. */
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 5; j++)
            points[(i * 5 + j) * 3 + 1] = j;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 4, 5, points}, NULL, NULL,
                                        (batten_uv_out){NULL, NULL}, &report, &surface));
    CHECK_NEAR(report.spread_u, 0, 1e-14);
    CHECK_NEAR(report.spread_v, 0, 1e-14);
    batten_surface_unref(surface);
}

TEST(affine_maps_commute_and_planes_stay_planes)
{
    test_random random = test_random_begin("affine");
    double points[6 * 5 * 3], image[90];
    fill(&random, 6, 5, points);
    for (int i = 0; i < 30; i++) {
        double *p = points + 3 * i, *q = image + 3 * i;
        p[2] = 2 * p[0] - p[1];
        q[0] = p[0] + 2 * p[1] - 5;
        q[1] = 3 * p[1] - p[2];
        q[2] = p[0];
    }
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.parameters = BATTEN_FOLEY;
    batten_surface *a = NULL, *b = NULL;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 6, 5, points}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &a));
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 6, 5, image}, &options, NULL,
                                        (batten_uv_out){NULL, NULL}, NULL, &b));
    const double *P = batten_surface_points(a), *Q = batten_surface_points(b);
    for (int i = 0; i < 30; i++) {
        CHECK_NEAR(P[3 * i + 2], 2 * P[3 * i] - P[3 * i + 1], 1e-12 * 20);
        CHECK_NEAR(Q[3 * i], P[3 * i] + 2 * P[3 * i + 1] - 5, 1e-11 * 20);
    }
    batten_surface_unref(b);
    batten_surface_unref(a);
}

TEST(G1_grid_lines_that_coincide_are_named)
{
    test_random random = test_random_begin("coincident");
    double points[6 * 5 * 3], once[90] = {0};
    fill(&random, 6, 5, points);
    memcpy(points + 3 * 15, points + 2 * 15, 15 * sizeof *points);
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 6, 5, points}, NULL, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("u grid lines 3 and 4 coincide");
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 6, 5, once}, NULL, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("all u grid lines coincide");
    points[0] = -1.7e308, points[15] = 1.7e308;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 6, 5, points}, NULL, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_OVERFLOW);
    CHECK(surface == NULL);
}

TEST(N1_grids_that_are_not_finite_are_refused)
{
    double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, NAN}, du[12] = {0},
           v[2] = {0, INFINITY};
    const double u[2] = {0, 1};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 2, 2, points}, NULL, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 3 of point 4 is nan");
    points[11] = 0;
    batten_surface_interpolate_options options = given(u, v);
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 2, 2, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_NOT_FINITE);
    options = batten_surface_interpolate_defaults();
    options.knots_at_data = true;
    options.du = du;
    du[4] = NAN;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){3, 2, 2, points}, &options, NULL,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("number 5 of `du`");
    CHECK(surface == NULL);
}

TEST(grids_that_make_no_sense_are_refused)
{
    const double points[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0}, some[24] = {0};
    batten_surface *surface = NULL;
    for (int c = 0; c < 12; c++) {
        batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
        options.knots_at_data = true;
        if (c == 0 || c == 1 || c == 2)
            options.du = some;
        if (c == 2) /* two orders, and no twists */
            options.dv = some, options.orders_v = 2, options.degree_v = 5;
        options.closed_u = c == 0;
        if (c == 1)
            options.twists = some;
        if (c == 3)
            options.dv = some, options.closed_v = true;
        if (c == 4)
            options.parameters = BATTEN_GIVEN;
        if (c == 5)
            options.parameters = (batten_parametrization)77;
        if (c == 6)
            options.ends = BATTEN_END_CLAMPED;
        if (c == 7)
            options.degree_u = 2;
        if (c == 8)
            options.degree_v = 0;
        if (c == 9)
            options.degree_v = 26;
        const int count_u = c == 10 ? 1 : c == 11 ? 100000 : 2, count_v = c == 11 ? 100000 : 2;
        const batten_status expected = c >= 7 && c <= 9 ? BATTEN_BAD_DEGREE
                                       : c == 10        ? BATTEN_TOO_FEW_POINTS
                                       : c == 11        ? BATTEN_TOO_LARGE
                                                        : BATTEN_BAD_ARGUMENT;
        CHECK_STATUS(batten_surface_interpolate((batten_grid){3, count_u, count_v, points},
                                                &options, NULL, (batten_uv_out){NULL, NULL},
                                                NULL, &surface),
                     expected);
    }
    CHECK(surface == NULL);
}

TEST(a_grid_has_the_same_bits_on_any_number_of_threads)
{
    enum { U = 90, V = 80 };
    static const int threads[] = {1, 2, 7};
    double points[U][V][3];
    batten_surface *surfaces[3];
    batten_surface_interpolate_report reports[3];
    for (int i = 0; i < U; i++)
        for (int j = 0; j < V; j++) {
            points[i][j][0] = i + 0.1 * sin(j);
            points[i][j][1] = j + 0.1 * cos(2 * i);
            points[i][j][2] = smooth(0.3 * i, 0.2 * j);
        }
    for (int k = 0; k < COUNT(threads); k++) {
        batten_job job = BATTEN_JOB;
        job.thread_count = threads[k];
        CHECK_OK(batten_surface_interpolate((batten_grid){3, U, V, points[0][0]}, NULL, &job,
                                            (batten_uv_out){NULL, NULL}, &reports[k],
                                            &surfaces[k]));
        CHECK_INT(memcmp(batten_surface_points(surfaces[k]), batten_surface_points(surfaces[0]),
                         sizeof points),
                  0);
        CHECK_BITS(reports[k].error, reports[0].error);
    }
    CHECK(reports[0].error > 0 && reports[0].error < 1e-11);
    for (int k = 0; k < COUNT(threads); k++)
        batten_surface_unref(surfaces[k]);
}

static bool stop_at(void *user)
{
    int *questions = user;
    return (*questions)-- == 0;
}

TEST(I8_a_grid_can_be_cancelled_and_has_a_budget)
{
    double points[42];
    fill_bicubic(points);
    batten_surface_interpolate_options options = given(us, vs);
    batten_surface *surface = NULL;
    for (int at = 0; at < 3; at++) {
        int questions = at;
        batten_job job = BATTEN_JOB;
        job.is_cancelled = stop_at;
        job.user = &questions;
        CHECK_STATUS((questions = at,
                      batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options, &job,
                                                 (batten_uv_out){NULL, NULL}, NULL, &surface)),
                     BATTEN_CANCELLED);
    }
    batten_job job = BATTEN_JOB;
    job.work_limit = 100;
    CHECK_STATUS(batten_surface_interpolate((batten_grid){1, 7, 6, points}, &options, &job,
                                            (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_INCOMPLETE);
    CHECK_MESSAGE("grid: stopped at 70 %");
    CHECK(surface == NULL);
}
