#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

static batten_curve *through(int d, int n, const double *points,
                             const batten_curve_quadratic_options *o)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_quadratic((batten_points){d, n, points}, o, NULL, &curve));
    return curve;
}

/* Data abscissae that every kind takes: the ends and the mid-points of an uneven mesh. */
static void mesh(test_random *random, int n, double *t)
{
    double knot = 0;
    t[0] = 0;
    for (int i = 1; i < n - 1; i++) {
        const double h = random ? test_random_in(random, 0.5, 1.5) : 1;
        t[i] = knot + h / 2;
        knot += h;
    }
    t[n - 1] = knot;
}

static batten_curve_quadratic_options kind(int i, const double *t)
{
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    o.kind = (batten_quadratic_kind)i;
    o.parameters = BATTEN_GIVEN;
    o.given = t;
    return o;
}

TEST(quadratic_splines_pass_their_points_with_one_tangent)
{
    test_random random = test_random_begin("quadratic_splines_pass_their_points");
    for (int c = 0; c < test_cases(30); c++) {
        enum { N = 9 };
        const int d = 1 + c / 3 % 3;
        double t[N], points[3 * N], parameters[N], knots[N + 2];
        mesh(&random, N, t);
        for (int i = 0; i < d * N; i++)
            points[i] = test_random_in(&random, -2, 2);
        const batten_curve_quadratic_options o = kind(c % 3, t);
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_quadratic((batten_points){d, N, points}, &o, parameters, &curve));
        CHECK_INT(batten_curve_degree(curve), 2);
        CHECK(memcmp(parameters, t, sizeof t) == 0);
        for (int i = 0; i < N; i++) {
            double p[3];
            CHECK_OK(batten_curve_evaluate(curve, t[i], 0, p));
            for (int k = 0; k < d; k++)
                CHECK_NEAR(p[k], points[i * d + k], 1e-13);
        }
        const int spans = batten_curve_spans(curve, knots);
        for (int i = 1; i + 1 < spans; i++) {
            double p[6], q[6];
            CHECK_OK(batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_LEFT, 1, p));
            CHECK_OK(batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_RIGHT, 1, q));
            for (int k = 0; k < 2 * d; k++)
                CHECK_NEAR(p[k], q[k], 1e-11);
        }
        batten_curve_unref(curve);
    }
}

TEST(quadratic_splines_reproduce_parabolas)
{
    test_random random = test_random_begin("quadratic_splines_reproduce_parabolas");
    enum { N = 8 };
    double t[N], y[N];
    mesh(&random, N, t);
    for (int i = 0; i < N; i++)
        y[i] = 3 - t[i] + 2 * t[i] * t[i];
    for (int c = 0; c < 5; c++) {
        batten_curve_quadratic_options o = kind(c < 3 ? c : BATTEN_QUADRATIC_SEQUENTIAL, t);
        o.slope = (batten_quadratic_slope)(c < 3 ? 0 : c - 2);
        o.vector[0] = c == 3 ? -1 : -1 + 4 * t[N - 1];
        batten_curve *curve = through(1, N, y, &o);
        for (int i = 0; i <= 50; i++) {
            const double u = t[N - 1] * i / 50;
            double p;
            CHECK_OK(batten_curve_evaluate(curve, u, 0, &p));
            CHECK_NEAR(p, 3 - u + 2 * u * u, 2e-12);
        }
        batten_curve_unref(curve);
    }
}

/* The largest error for sin 3 x on [0, 2] with n points. */
static double error_of(int which, int n)
{
    double *t = test_array((size_t)n, sizeof *t), *y = test_array((size_t)n, sizeof *y);
    mesh(NULL, n, t);
    const double scale = 2 / t[n - 1];
    for (int i = 0; i < n; i++) {
        t[i] *= scale;
        y[i] = sin(3 * t[i]);
    }
    const batten_curve_quadratic_options o = kind(which, t);
    batten_curve *curve = through(1, n, y, &o);
    double largest = 0;
    for (int i = 0; i <= 5000; i++) {
        double p;
        CHECK_OK(batten_curve_evaluate(curve, 2.0 * i / 5000, 0, &p));
        largest = fmax(largest, fabs(p - sin(6.0 * i / 5000)));
    }
    batten_curve_unref(curve);
    return largest;
}

TEST(the_error_of_a_quadratic_spline_falls_with_the_third_power)
{
    for (int which = 0; which < 2; which++) /* 128 and 256 spans */
        CHECK_NEAR(log2(error_of(which, 130) / error_of(which, 258)), 3, 0.15);
}

/* Inside an even mesh the error is K h^3 / 6 s (1/4 - s^2), s from -1/2 to 1/2 over a span, for
 * a third derivative K: largest at s^2 = 1/12, K h^3 sqrt(3) / 216. */
TEST(the_constant_of_a_quadratic_spline_is_stable_over_three_halvings)
{
    for (int which = 0; which < 2; which++)
        for (int spans = 32; spans <= 256; spans *= 2) {
            const double h = 2.0 / spans, K = 27;
            CHECK_NEAR(error_of(which, spans + 2) / (K * h * h * h), sqrt(3) / 216,
                       spans == 32 ? 1e-4 : 2e-5);
        }
}

TEST(the_uniform_quadratic_spline_is_the_system_1_6_1)
{
    const double points[] = {1, 3, -2, 0.5, 4, 2}; /* knots 0 .. 4 */
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    o.kind = BATTEN_QUADRATIC_MIDPOINTS;
    double parameters[6], s[5];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_quadratic((batten_points){1, 6, points}, &o, parameters, &curve));
    CHECK_NEAR(parameters[1], 0.5, 0);
    CHECK_NEAR(parameters[5], 4, 0);
    for (int i = 0; i < 5; i++)
        CHECK_OK(batten_curve_evaluate(curve, i, 0, &s[i]));
    for (int i = 1; i < 4; i++)
        CHECK_NEAR(s[i - 1] + 6 * s[i] + s[i + 1], 4 * (points[i] + points[i + 1]), 1e-13);
    batten_curve_unref(curve);
}

static double jumps(const batten_curve *curve, const double *t, int n)
{
    double sum = 0;
    for (int i = 1; i + 1 < n; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate_side(curve, t[i], BATTEN_FROM_LEFT, 2, p));
        CHECK_OK(batten_curve_evaluate_side(curve, t[i], BATTEN_FROM_RIGHT, 2, q));
        sum += (p[2] - q[2]) * (p[2] - q[2]);
    }
    return sum;
}

TEST(the_best_slope_makes_the_jumps_least)
{
    const double t[] = {0, 1, 1.5, 3, 4, 4.2, 6}, y[] = {0, 2, -1, 0, 3, 1, 1};
    batten_curve_quadratic_options o = kind(BATTEN_QUADRATIC_SEQUENTIAL, t);
    batten_curve *best = through(1, 7, y, &o);
    const double least = jumps(best, t, 7);
    double start[2], end[2];
    CHECK_OK(batten_curve_evaluate(best, 0, 1, start));
    CHECK_OK(batten_curve_evaluate(best, 6, 1, end));
    for (int side = -1; side <= 1; side += 2)
        for (int at_end = 0; at_end < 2; at_end++) {
            o.slope = at_end ? BATTEN_QUADRATIC_AT_END : BATTEN_QUADRATIC_AT_START;
            o.vector[0] = (at_end ? end[1] : start[1]) + side * 0.01;
            batten_curve *other = through(1, 7, y, &o);
            CHECK(jumps(other, t, 7) > least);
            batten_curve_unref(other);
        }
    batten_curve_unref(best);
}

TEST(an_error_of_the_first_slope_runs_through_a_sequential_spline_undamped)
{
    const double t[] = {0, 1, 2, 3, 4, 5, 6, 7}, y[8] = {0};
    batten_curve_quadratic_options o = kind(BATTEN_QUADRATIC_SEQUENTIAL, t);
    o.slope = BATTEN_QUADRATIC_AT_START;
    o.vector[0] = 1;
    batten_curve *curve = through(1, 8, y, &o);
    for (int i = 0; i < 8; i++) {
        double p[2];
        CHECK_OK(batten_curve_evaluate(curve, i, 1, p));
        CHECK_NEAR(p[1], i % 2 ? -1 : 1, 0);
    }
    batten_curve_unref(curve);
}

TEST(g10_reversed_points_give_the_reversed_quadratic_spline)
{
    enum { N = 7 };
    test_random random = test_random_begin("g10_reversed_quadratic");
    double t[N], back_t[N], points[2 * N], back[2 * N];
    mesh(&random, N, t);
    for (int i = 0; i < N; i++) {
        back_t[i] = t[N - 1] - t[N - 1 - i];
        for (int k = 0; k < 2; k++)
            back[2 * (N - 1 - i) + k] = points[2 * i + k] = test_random_in(&random, -1, 1);
    }
    for (int which = 0; which < 3; which++) {
        const batten_curve_quadratic_options o = kind(which, t), r = kind(which, back_t);
        batten_curve *a = through(2, N, points, &o), *b = through(2, N, back, &r);
        for (int i = 0; i <= 40; i++) {
            double p[2], q[2];
            CHECK_OK(batten_curve_evaluate(a, t[N - 1] * i / 40, 0, p));
            CHECK_OK(batten_curve_evaluate(b, t[N - 1] * (40 - i) / 40, 0, q));
            CHECK_NEAR(p[0], q[0], 1e-12);
            CHECK_NEAR(p[1], q[1], 1e-12);
        }
        batten_curve_unref(a);
        batten_curve_unref(b);
    }
}

TEST(g2_few_points_give_the_least_quadratic_spline)
{
    const double points[] = {0, 0, 1, 2, 2, 0};
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    batten_curve *none = NULL;
    for (int which = 0; which < 3; which++) {
        o.kind = (batten_quadratic_kind)which;
        double p[4];
        CHECK_STATUS(batten_curve_quadratic((batten_points){2, 1, points}, &o, NULL, &none),
                     BATTEN_TOO_FEW_POINTS);
        if (which == BATTEN_QUADRATIC_MIDPOINTS) {
            CHECK_STATUS(batten_curve_quadratic((batten_points){2, 2, points}, &o, NULL, &none),
                         BATTEN_TOO_FEW_POINTS);
        } else {
            batten_curve *line = through(2, 2, points, &o);
            const double end = batten_curve_domain(line).b;
            CHECK_OK(batten_curve_evaluate(line, end / 2, 0, p));
            CHECK_NEAR(p[0], 0.5, 1e-14);
            CHECK_NEAR(p[1], 1, 1e-14);
            batten_curve_unref(line);
        }
        batten_curve *parabola = through(2, 3, points, &o);
        const double end = batten_curve_domain(parabola).b;
        CHECK_OK(batten_curve_evaluate(parabola, end / 4, 0, p));
        CHECK_NEAR(p[0], 0.5, 1e-14); /* y = 2 - 2 (x - 1)^2 */
        CHECK_NEAR(p[1], 1.5, 1e-13);
        batten_curve_unref(parabola);
    }
    CHECK(none == NULL);
}

TEST(g1_coincident_points_are_named_by_quadratic_splines)
{
    const double points[] = {0, 0, 1, 2, 1, 2, 3, 3};
    batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_quadratic((batten_points){2, 4, points}, &o, NULL, &none),
                 BATTEN_COINCIDENT);
    o.kind = BATTEN_QUADRATIC_SEQUENTIAL;
    CHECK_STATUS(batten_curve_quadratic((batten_points){2, 4, points}, &o, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3 coincide");
    CHECK(none == NULL);
}

TEST(n1_quadratic_splines_refuse_what_is_not_finite)
{
    const double points[] = {0, 1, 2, 3}, bad[] = {0, NAN, 2, 3}, t[] = {0, 1, 2, NAN};
    batten_curve *none = NULL;
    for (int which = 0; which < 3; which++) {
        batten_curve_quadratic_options o = kind(which, t);
        CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, points}, &o, NULL, &none),
                     BATTEN_NOT_FINITE);
        o.parameters = BATTEN_UNIFORM;
        CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, bad}, &o, NULL, &none),
                     BATTEN_NOT_FINITE);
    }
    batten_curve_quadratic_options o = kind(BATTEN_QUADRATIC_SEQUENTIAL, t);
    o.parameters = BATTEN_UNIFORM;
    o.slope = BATTEN_QUADRATIC_AT_END;
    o.vector[0] = INFINITY;
    CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, points}, &o, NULL, &none),
                 BATTEN_NOT_FINITE);
    o.kind = (batten_quadratic_kind)7;
    CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, points}, &o, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
}

TEST(g9_parameters_that_are_no_mid_points_are_refused)
{
    const double y[] = {0, 1, 2, 3}, early[] = {0, 1, 1.5, 3}, late[] = {0, 1, 3, 5};
    batten_curve_quadratic_options o = kind(BATTEN_QUADRATIC_MIDPOINTS, early);
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, y}, &o, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("knot 3 would be 1");
    o.given = late;
    CHECK_STATUS(batten_curve_quadratic((batten_points){1, 4, y}, &o, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the knots end at 4, not 5");
    CHECK(none == NULL);
}

TEST(quadratic_splines_report_every_lack_of_memory)
{
    static const double points[] = {0, 0, 1, 2, 3, 1, 4, -1, 6, 0, 7, 2};
    for (int kind = BATTEN_QUADRATIC_BETWEEN; kind <= BATTEN_QUADRATIC_BETWEEN + 1; kind++) {
        batten_curve_quadratic_options o = batten_curve_quadratic_defaults();
        double parameters[6];
        batten_curve *curve = NULL;
        o.kind = (batten_quadratic_kind)kind;
        CHECK_EACH_ALLOCATION(
            batten_curve_quadratic((batten_points){2, 6, points}, &o, parameters, &curve));
        batten_curve_unref(curve);
    }
}
