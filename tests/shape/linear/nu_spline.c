#include <batten/interpolate.h>

#include "support/test.h"

static batten_curve *through(int d, int n, const double *points,
                             const batten_curve_weighted_options *o)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_weighted((batten_points){d, n, points}, o, NULL, &curve));
    return curve;
}

static void side(const batten_curve *curve, double u, batten_side from, double *out)
{
    CHECK_OK(batten_curve_evaluate_side(curve, u, from, 2, out));
}

static batten_end_kind kind(int i)
{
    const batten_end_kind kinds[] = {BATTEN_END_NATURAL, BATTEN_END_CLAMPED, BATTEN_END_SECOND,
                                     BATTEN_END_PARABOLIC, BATTEN_END_BESSEL};
    return kinds[i % COUNT(kinds)];
}

TEST(a_weighted_spline_obeys_its_law_at_every_point)
{
    test_random random = test_random_begin("a_weighted_spline_obeys_its_law");
    for (int c = 0; c < test_cases(50); c++) {
        const int d = 1 + c % 3, n = test_random_int(&random, 3, 12);
        double x[13], points[36], nus[12], weights[12], parameters[12];
        for (int i = 0; i <= n; i++)
            x[i] = (i ? x[i - 1] : -1) + test_random_in(&random, 0.3, 2);
        for (int i = 0; i < 12; i++) {
            nus[i] = pow(10, test_random_in(&random, -2, 2));
            weights[i] = pow(10, test_random_in(&random, -2, 2));
        }
        for (int i = 0; i < n * d; i++)
            points[i] = test_random_in(&random, -2, 2);
        batten_curve_weighted_options o = batten_curve_weighted_defaults();
        o.parameters = BATTEN_GIVEN;
        o.given = x;
        o.closed = c % 4 == 3;
        o.nus = nus;
        o.weights = weights;
        o.start = (batten_end){kind(c), {1, 2, 3}};
        o.end = (batten_end){kind(c / 5), {-1, 2, 0}};
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_weighted((batten_points){d, n, points}, &o, parameters, &curve));
        const int spans = n - !o.closed;
        const double mean = (x[spans] - x[0]) / spans;
        for (int i = 0; i < n; i++) {
            double left[9], right[9];
            side(curve, x[i], BATTEN_FROM_RIGHT, right);
            side(curve, o.closed && i == 0 ? x[n] : x[i], BATTEN_FROM_LEFT, left);
            CHECK_NEAR(parameters[i], x[i], 0);
            for (int k = 0; k < d; k++) {
                CHECK_NEAR(right[k], points[i * d + k], 1e-14);
                if (!o.closed && (i == 0 || i == n - 1))
                    continue;
                const double before = weights[i ? i - 1 : n - 1], after = weights[i];
                CHECK_NEAR(left[k], right[k], 1e-13);
                CHECK_NEAR(left[d + k], right[d + k], 1e-11);
                CHECK_NEAR(after * right[2 * d + k] - before * left[2 * d + k],
                           nus[i] / mean * right[d + k],
                           1e-11 * (1 + after + before) *
                               (1 + fabs(right[2 * d + k]) + fabs(left[2 * d + k])));
            }
        }
        batten_curve_unref(curve);
    }
}

TEST(the_ends_of_a_weighted_spline_are_as_asked)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4};
    for (int c = 0; c < 16; c++) {
        const int a = c % 4, b = c / 4;
        batten_curve_weighted_options o = batten_curve_weighted_defaults();
        o.nu = 3;
        o.start = (batten_end){kind(a), {1, 2}};
        o.end = (batten_end){kind(b), {-1, 0.5}};
        batten_curve *curve = through(2, 4, points, &o);
        const batten_interval domain = batten_curve_domain(curve);
        double p[8], q[8];
        CHECK_OK(batten_curve_evaluate(curve, domain.a, 3, p));
        CHECK_OK(batten_curve_evaluate(curve, domain.b, 3, q));
        for (int k = 0; k < 2; k++) {
            const double start[] = {p[4 + k], p[2 + k] - o.start.vector[k],
                                    p[4 + k] - o.start.vector[k], p[6 + k]};
            const double end[] = {q[4 + k], q[2 + k] - o.end.vector[k],
                                  q[4 + k] - o.end.vector[k], q[6 + k]};
            CHECK_NEAR(start[a], 0, 1e-13);
            CHECK_NEAR(end[b], 0, 1e-13);
        }
        batten_curve_unref(curve);
    }
}

TEST(closed_weighted_splines_are_periodic_however_tight)
{
    const double points[] = {0, 0, 3, 0.2, 4, 3, 1, 4}, nus[] = {0, 50, 1e9};
    for (int c = 0; c < 3; c++) {
        batten_curve_weighted_options o = batten_curve_weighted_defaults();
        o.closed = true;
        o.nu = nus[c];
        double u[4], p[2], q[2];
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_weighted((batten_points){2, 4, points}, &o, u, &curve));
        CHECK(batten_curve_is_periodic(curve));
        const batten_interval domain = batten_curve_domain(curve);
        for (int i = 0; i < 4; i++) {
            CHECK_OK(batten_curve_evaluate(curve, u[i], 0, p));
            CHECK_OK(batten_curve_evaluate(curve, u[i] + domain.b - domain.a, 0, q));
            for (int k = 0; k < 2; k++) {
                CHECK_NEAR(p[k], points[2 * i + k], 1e-14);
                CHECK_NEAR(q[k], p[k], 1e-13);
            }
        }
        batten_curve_unref(curve);
    }
}

TEST(without_nu_and_weights_it_is_the_cubic_spline)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4, 5, 3, 7, 7};
    for (int c = 0; c < 10; c++) {
        batten_curve_weighted_options o = batten_curve_weighted_defaults();
        batten_curve_interpolate_options cubic = batten_curve_interpolate_defaults();
        cubic.parameters = BATTEN_CHORD;
        cubic.closed = o.closed = c == 9;
        cubic.start = o.start = (batten_end){kind(c), {1, 2}};
        cubic.end = o.end = (batten_end){kind(c / 2), {0, 1}};
        batten_curve *a = through(2, 6, points, &o), *b = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){2, 6, points}, &cubic, NULL, &b));
        const double end = batten_curve_domain(a).b;
        for (int i = 0; i <= 60; i++) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(a, end * i / 60, 0, p));
            CHECK_OK(batten_curve_evaluate(b, end * i / 60, 0, q));
            CHECK_NEAR(p[0], q[0], 1e-13);
            CHECK_NEAR(p[1], q[1], 1e-13);
        }
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
}

/* Sum of w integral P''^2 and nu P'^2 of the cubics with these slopes: on a span with slopes m,
 * n, chord slope d and length h it is 4 w / h (m^2 + m n + n^2 - 3 d (m + n) + 3 d^2). */
static double energy(int n, const double *x, const double *y, const double *slopes,
                     const double *weights, const double *nus)
{
    double sum = 0;
    for (int i = 0; i + 1 < n; i++) {
        const double h = x[i + 1] - x[i], d = (y[i + 1] - y[i]) / h;
        const double a = slopes[i], b = slopes[i + 1];
        sum += 4 * weights[i] / h * (a * a + a * b + b * b - 3 * d * (a + b) + 3 * d * d);
    }
    for (int i = 1; i + 1 < n; i++)
        sum += nus[i] * slopes[i] * slopes[i];
    return sum;
}

TEST(a_weighted_spline_has_the_least_energy)
{
    enum { N = 8 };
    const double x[N] = {0, 1, 1.5, 3, 4, 4.2, 6, 7}, y[N] = {0, 2, -1, 0, 3, 1, 1, 5};
    const double weights[N] = {1, 3, 0.2, 5, 1, 1, 0.7}, nus[N] = {0, 1, 4, 0, 2, 0.3, 9, 0};
    test_random random = test_random_begin("a_weighted_spline_has_the_least_energy");
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = x;
    o.weights = weights;
    o.nus = nus; /* the mean step is 1 */
    batten_curve *curve = through(1, N, y, &o);
    double slopes[N], moved[N];
    for (int i = 0; i < N; i++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, x[i], 1, p));
        slopes[i] = p[1];
    }
    const double least = energy(N, x, y, slopes, weights, nus);
    for (int c = 0; c < 100; c++) {
        for (int i = 0; i < N; i++)
            moved[i] = slopes[i] + test_random_in(&random, -1, 1);
        CHECK(energy(N, x, y, moved, weights, nus) > least);
    }
    for (int i = 0; i < N; i++) { /* the gradient vanishes */
        memcpy(moved, slopes, sizeof moved);
        moved[i] += 1e-4;
        const double up = energy(N, x, y, moved, weights, nus);
        moved[i] -= 2e-4;
        CHECK_NEAR((up - energy(N, x, y, moved, weights, nus)) / 2e-4, 0, 1e-8);
    }
    batten_curve_unref(curve);
}

TEST(a_nu_spline_has_continuous_curvature)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4, 5, 3, 7, 7}, nus[] = {0, 5, 0.5, 40, 0, 0};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.nus = nus;
    double parameters[6];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_weighted((batten_points){2, 6, points}, &o, parameters, &curve));
    for (int i = 1; i < 5; i++) {
        double p[6], q[6];
        side(curve, parameters[i], BATTEN_FROM_LEFT, p);
        side(curve, parameters[i], BATTEN_FROM_RIGHT, q);
        CHECK_NEAR((p[2] * p[5] - p[3] * p[4]) / pow(hypot(p[2], p[3]), 3),
                   (q[2] * q[5] - q[3] * q[4]) / pow(hypot(q[2], q[3]), 3), 1e-10);
    }
    batten_curve_unref(curve);
}

TEST(a_large_nu_makes_a_corner_and_large_ones_the_polygon)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4}, one[] = {0, 1e9, 0, 0};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    double parameters[4], p[4];
    o.nus = one;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_weighted((batten_points){2, 4, points}, &o, parameters, &curve));
    CHECK_OK(batten_curve_evaluate(curve, parameters[1], 1, p));
    CHECK_NEAR(hypot(p[2], p[3]), 0, 1e-8);
    batten_curve_unref(curve);
    o.nus = NULL;
    o.nu = 1e9;
    o.start.kind = o.end.kind = BATTEN_END_CLAMPED; /* with no speed */
    curve = through(2, 4, points, &o);
    for (int i = 0; i <= 30; i++) { /* in line with two points */
        CHECK_OK(batten_curve_evaluate(
            curve, parameters[1] + (parameters[2] - parameters[1]) * i / 30, 0, p));
        CHECK_NEAR((p[0] - 1) * -1 - (p[1] - 2) * 2, 0, 1e-8);
    }
    batten_curve_unref(curve);
}

TEST(negative_nu_are_taken_while_there_is_a_least)
{
    /* Uniform, three points, natural: c = 1, the middle row leaves 4 + nu / 2 - 1 / 2 - 1 / 2.
     */
    const double y[] = {0, 1, 0}, x[] = {0, 1, 2, 3};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = x;
    o.nu = -5.99;
    batten_curve *curve = through(1, 3, y, &o), *none = NULL;
    batten_curve_unref(curve);
    o.nu = -6.01;
    CHECK_STATUS(batten_curve_weighted((batten_points){1, 3, y}, &o, NULL, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("negative nu");
    /* Closed: the eigenvalues are 6 and 3 twice, with nu / 2 more. */
    o.closed = true;
    o.nu = -5.99;
    batten_curve_unref(through(1, 3, y, &o));
    o.nu = -6.01;
    CHECK_STATUS(batten_curve_weighted((batten_points){1, 3, y}, &o, NULL, &none),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK(none == NULL);
}

TEST(weights_by_slope_hold_steep_data_down)
{
    const double x[] = {0, 1, 2, 3, 4, 5, 6}, y[] = {0, 0, 0, 10, 10, 10, 10};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = x;
    batten_curve *plain = through(1, 7, y, &o);
    o.rule = BATTEN_WEIGHTS_SLOPE;
    batten_curve *weighted = through(1, 7, y, &o);
    double above_plain = 0, above = 0;
    for (int i = 0; i <= 600; i++) {
        double p, q;
        CHECK_OK(batten_curve_evaluate(plain, i / 100.0, 0, &p));
        CHECK_OK(batten_curve_evaluate(weighted, i / 100.0, 0, &q));
        above_plain = fmax(above_plain, p - 10);
        above = fmax(above, q - 10);
    }
    CHECK(above_plain > 0.7);
    CHECK(above < 1e-4);
    batten_curve_unref(plain);
    batten_curve_unref(weighted);
}

TEST(g10_reversed_points_give_the_reversed_weighted_spline)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4}, back[] = {4, 4, 3, 1, 1, 2, 0, 0};
    const double nus[] = {0, 2, 7, 0}, nus_back[] = {0, 7, 2, 0}, w[] = {1, 4, 2},
                 w_back[] = {2, 4, 1};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.nus = nus;
    o.weights = w;
    o.start.kind = BATTEN_END_BESSEL;
    batten_curve *a = through(2, 4, points, &o);
    o.nus = nus_back;
    o.weights = w_back;
    o.start.kind = BATTEN_END_NATURAL;
    o.end.kind = BATTEN_END_BESSEL;
    batten_curve *b = through(2, 4, back, &o);
    const double end = batten_curve_domain(a).b;
    for (int i = 0; i <= 50; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(a, end * i / 50, 0, p));
        CHECK_OK(batten_curve_evaluate(b, end - end * i / 50, 0, q));
        CHECK_NEAR(p[0], q[0], 1e-13);
        CHECK_NEAR(p[1], q[1], 1e-13);
    }
    batten_curve_unref(a);
    batten_curve_unref(b);
}

TEST(g2_few_points_give_the_least_weighted_spline)
{
    const double points[] = {1, 2, 4, 6, 9, 1};
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.nu = 3;
    for (int i = 0; i < 4; i++) {
        o.start.kind = i % 2 ? BATTEN_END_PARABOLIC : BATTEN_END_NATURAL;
        o.end.kind = i / 2 ? BATTEN_END_PARABOLIC : BATTEN_END_BESSEL;
        batten_curve *line = through(2, 2, points, &o);
        double p[4];
        CHECK_OK(batten_curve_evaluate(line, 2, 1, p));
        CHECK_NEAR(p[0], 2.2, 1e-14);
        CHECK_NEAR(p[3], 0.8, 1e-14);
        batten_curve_unref(line);
    }
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 1, points}, &o, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    o.closed = true;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 2, points}, &o, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    batten_curve_unref(through(2, 3, points, &o));
}

TEST(g1_coincident_points_are_named_by_weighted_splines)
{
    const double points[] = {0, 0, 1, 2, 1, 2};
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 3, points}, NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
}

TEST(n1_weighted_splines_refuse_what_is_not_finite)
{
    const double points[] = {0, 0, 1, 2, 4, 4}, bad[] = {0, 0, NAN, 2, 4, 4},
                 nus[] = {0, NAN, 1}, weights[] = {1, 0};
    batten_curve *none = NULL;
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 3, bad}, &o, NULL, &none),
                 BATTEN_NOT_FINITE);
    o.nus = nus;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 3, points}, &o, NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
    o.nus = NULL;
    o.weights = weights;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 3, points}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("span 2");
    o.weights = NULL;
    o.end.kind = BATTEN_END_FAIR;
    CHECK_STATUS(batten_curve_weighted((batten_points){2, 3, points}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("end");
    CHECK(none == NULL);
}

TEST(a_nu_spline_meets_a_hundred_thousand_points)
{
    enum { N = 100000 };
    if (test_cases(10) < 10)
        SKIP("a run with failing allocations");
    double *points = test_array(2 * N, sizeof *points);
    for (int i = 0; i < N; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = sin(i * 0.7);
    }
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.nu = 1;
    o.parameters = BATTEN_UNIFORM;
    batten_curve *curve = through(2, N, points, &o);
    for (int i = 0; i < N; i += 37) {
        double at[2];
        CHECK_OK(batten_curve_evaluate(curve, i, 0, at));
        CHECK_NEAR(at[0], points[2 * i], 1e-9);
        CHECK_NEAR(at[1], points[2 * i + 1], 1e-9);
    }
    batten_curve_unref(curve);
}
