/* What the theory of cubic splines says in numbers: relations, energies, orders. */
#include <batten/interpolate.h>

#include "support/test.h"

static batten_curve_interpolate_options given(const double *parameters)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    return options;
}

static void derivatives(const batten_curve *curve, double u, batten_side side, double *out)
{
    CHECK_OK(batten_curve_evaluate_side(curve, u, side, 3, out));
}

/* ---- relations between slopes m and moments M ---- */

enum { N = 8 };
typedef struct nodes {
    double t[N], y[N], h[N], d[N]; /* steps and slopes of the chords */
    double m[N], M[N];             /* first and second derivative */
} nodes;

static batten_curve *random_spline(test_random *random, int kind, nodes *out)
{
    for (int i = 0; i < N; i++) {
        out->t[i] = i ? out->t[i - 1] + test_random_in(random, 0.2, 2) : 0;
        out->y[i] = test_random_in(random, -1, 1);
    }
    batten_curve_interpolate_options options = given(out->t);
    options.start = (batten_end){(batten_end_kind)kind, {0.7}};
    options.end = (batten_end){(batten_end_kind)kind, {-0.3}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, N, out->y}, &options, NULL, &curve));
    for (int i = 0; i < N; i++) {
        double at[4];
        derivatives(curve, out->t[i], i ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, at);
        out->m[i] = at[1];
        out->M[i] = at[2];
        if (i + 1 < N) {
            out->h[i] = out->t[i + 1] - out->t[i];
            out->d[i] = (out->y[i + 1] - out->y[i]) / out->h[i];
        }
    }
    return curve;
}

static void check_inner_relations(const batten_curve *curve, const nodes *s)
{
    const double *h = s->h, *d = s->d, *m = s->m, *M = s->M;
    for (int i = 1; i + 1 < N; i++) {
        const double L = h[i] / (h[i - 1] + h[i]), U = 1 - L;
        CHECK_NEAR(L * m[i - 1] + 2 * m[i] + U * m[i + 1], 3 * (L * d[i - 1] + U * d[i]),
                   1e-12);
        CHECK_NEAR((U * M[i - 1] + 2 * M[i] + L * M[i + 1]) * (h[i - 1] + h[i]),
                   6 * (d[i] - d[i - 1]), 1e-11);
        double left[4], right[4];
        derivatives(curve, s->t[i], BATTEN_FROM_LEFT, left);
        derivatives(curve, s->t[i], BATTEN_FROM_RIGHT, right);
        const double jump = 6 * (m[i] + m[i + 1] - 2 * d[i]) / (h[i] * h[i]) -
                            6 * (m[i - 1] + m[i] - 2 * d[i - 1]) / (h[i - 1] * h[i - 1]);
        CHECK_NEAR(right[3] - left[3], jump, 1e-9 * (1 + fabs(left[3]) + fabs(right[3])));
    }
    for (int i = 0; i + 1 < N; i++) {
        CHECK_NEAR(m[i], d[i] - h[i] * (2 * M[i] + M[i + 1]) / 6, 1e-12);
        CHECK_NEAR(m[i + 1], d[i] + h[i] * (M[i] + 2 * M[i + 1]) / 6, 1e-12);
    }
}

/* The rows at the start; those at the end are the same on the reversed data. */
static void check_start_row(int kind, double value, const nodes *s)
{
    const double *h = s->h, *d = s->d, *m = s->m, *M = s->M, both = h[0] + h[1];
    switch (kind) {
    case BATTEN_END_CLAMPED:
        CHECK_NEAR(m[0], value, 1e-13);
        CHECK_NEAR((2 * M[0] + M[1]) * h[0], 6 * (d[0] - value), 1e-11);
        break;
    case BATTEN_END_NATURAL:
    case BATTEN_END_SECOND:
        CHECK_NEAR(M[0], kind == BATTEN_END_SECOND ? value : 0, 1e-12);
        CHECK_NEAR(2 * m[0] + m[1], 3 * d[0] - h[0] * M[0] / 2, 1e-12);
        break;
    case BATTEN_END_PARABOLIC:
        CHECK_NEAR(m[0] + m[1], 2 * d[0], 1e-12);
        CHECK_NEAR(M[0], M[1], 1e-11);
        break;
    default: /* not-a-knot */
        CHECK_NEAR(h[1] * m[0] + both * m[1],
                   ((3 * h[0] + 2 * h[1]) * h[1] * d[0] + h[0] * h[0] * d[1]) / both, 1e-12);
    }
}

TEST(slopes_and_moments_obey_their_systems_and_end_rows)
{
    static const int kinds[] = {BATTEN_END_CLAMPED, BATTEN_END_NATURAL, BATTEN_END_SECOND,
                                BATTEN_END_PARABOLIC, BATTEN_END_NOT_A_KNOT};
    test_random random = test_random_begin("relations");
    for (int c = 0; c < test_cases(100); c++) {
        nodes s, back;
        const int kind = kinds[c % COUNT(kinds)];
        batten_curve *curve = random_spline(&random, kind, &s);
        check_inner_relations(curve, &s);
        check_start_row(kind, 0.7, &s);
        for (int i = 0; i < N; i++) { /* slopes change their sign, moments do not */
            back.m[i] = -s.m[N - 1 - i];
            back.M[i] = s.M[N - 1 - i];
            back.h[i] = i + 1 < N ? s.h[N - 2 - i] : 0;
            back.d[i] = i + 1 < N ? -s.d[N - 2 - i] : 0;
        }
        check_start_row(kind, kind == BATTEN_END_CLAMPED ? 0.3 : -0.3, &back);
        batten_curve_unref(curve);
    }
}

/* ---- energy ---- */

/* The integral of (f'' - g'')^2, by Simpson's rule on the spans of g: exact, as both second
 * derivatives are linear there. Without f that of g''^2. */
static double energy(const batten_curve *f, const batten_curve *g)
{
    double spans[64], sum = 0;
    const int count = batten_curve_spans(g, spans);
    for (int i = 0; i + 1 < count; i++)
        for (int k = 0; k < 3; k++) {
            const double h = spans[i + 1] - spans[i], u = spans[i] + k * h / 2;
            const batten_side side = k == 2 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
            double a[4] = {0}, b[4];
            derivatives(g, u, side, b);
            if (f)
                derivatives(f, u, side, a);
            sum += h / 6 * (k == 1 ? 4 : 1) * (a[2] - b[2]) * (a[2] - b[2]);
        }
    return sum;
}

TEST(the_energy_of_moments_is_the_integral)
{
    test_random random = test_random_begin("energy of moments");
    for (int c = 0; c < test_cases(50); c++) {
        nodes s;
        batten_curve *curve = random_spline(&random, BATTEN_END_SECOND, &s);
        double sum = 0;
        for (int i = 0; i + 1 < N; i++)
            sum +=
                s.h[i] / 3 * (s.M[i] * s.M[i] + s.M[i] * s.M[i + 1] + s.M[i + 1] * s.M[i + 1]);
        CHECK_NEAR(energy(NULL, curve) / sum, 1, 1e-12);
        batten_curve_unref(curve);
    }
}

/* A hundred C2 curves through the same points with bumps between them, and with any ends or the
 * same end slopes: each has the energy of the natural or clamped spline and that of the
 * difference (the first integral identity). */
TEST(bumps_between_the_points_add_their_energy_to_that_of_natural_and_clamped_splines)
{
    test_random random = test_random_begin("bumps");
    for (int c = 0; c < test_cases(200); c++) {
        nodes s;
        const bool clamped = c % 2;
        batten_curve *best =
            random_spline(&random, clamped ? BATTEN_END_CLAMPED : BATTEN_END_NATURAL, &s);
        batten_curve *other = NULL;
        double t[2 * N - 1], y[2 * N - 1];
        for (int i = 0; i < 2 * N - 1; i++) {
            const int k = i / 2;
            double at[4];
            t[i] = i % 2 ? (s.t[k] + s.t[k + 1]) / 2 : s.t[k];
            derivatives(best, t[i], BATTEN_FROM_LEFT, at);
            y[i] = i % 2 ? at[0] + test_random_in(&random, -0.2, 0.2) : s.y[k];
        }
        batten_curve_interpolate_options options = given(t);
        options.start.kind = c % 4 ? BATTEN_END_PARABOLIC : BATTEN_END_NATURAL;
        if (clamped) {
            options.start = (batten_end){BATTEN_END_CLAMPED, {s.m[0]}};
            options.end = (batten_end){BATTEN_END_CLAMPED, {s.m[N - 1]}};
        }
        CHECK_OK(
            batten_curve_interpolate((batten_points){1, 2 * N - 1, y}, &options, NULL, &other));
        const double least = energy(NULL, best), more = energy(NULL, other);
        CHECK(least <= more);
        CHECK_NEAR((least + energy(best, other)) / more, 1, 1e-11);
        batten_curve_unref(best);
        batten_curve_unref(other);
    }
}

/* ---- orders and constants ---- */

/* The largest errors of value, first and second derivative for sin 3 x on [0, 2]. */
static void errors_of_sine(int spans, const batten_curve_interpolate_options *how, double *out)
{
    double *t = test_array((size_t)spans + 1, sizeof *t),
           *y = test_array((size_t)spans + 1, sizeof *y);
    for (int i = 0; i <= spans; i++) {
        t[i] = 2.0 * i / spans;
        y[i] = sin(3 * t[i]);
    }
    batten_curve_interpolate_options options = *how;
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_interpolate((batten_points){1, spans + 1, y}, &options, NULL, &curve));
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i <= 24 * spans; i++) {
        const double x = 2.0 * i / (24 * spans);
        const double exact[3] = {sin(3 * x), 3 * cos(3 * x), -9 * sin(3 * x)};
        double at[4];
        derivatives(curve, x, i ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, at);
        for (int k = 0; k < 3; k++)
            out[k] = fmax(out[k], fabs(at[k] - exact[k]));
    }
    batten_curve_unref(curve);
}

/* Hall and Meyer's bounds are 5 / 384, 1 / 24 and 3 / 8; inside an even mesh the constants are
 * 1 / 384, sqrt(3) / 216 and 1 / 12: in the notes 0.0026, 0.0080, 0.083. */
TEST(clamped_splines_of_a_sine_have_the_observed_constants)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.start = (batten_end){BATTEN_END_CLAMPED, {3}};
    options.end = (batten_end){BATTEN_END_CLAMPED, {3 * cos(6)}};
    for (int spans = 64; spans <= 128; spans *= 2) {
        const double h = 2.0 / spans, K = 81;
        double e[3];
        errors_of_sine(spans, &options, e);
        CHECK_NEAR(e[0] / (h * h * h * h * K), 0.0026, 1e-5);
        CHECK_NEAR(e[1] / (h * h * h * K), 0.0080, 5e-5);
        CHECK_NEAR(e[2] / (h * h * K), 0.083, 5e-4);
        CHECK_NEAR(e[1] / (h * h * h * K), sqrt(3) / 216, 2e-5);
    }
}

TEST(natural_ends_cost_two_orders_and_not_a_knot_ends_none)
{
    static const struct {
        batten_end_kind kind;
        double order;
    } rows[] = {{BATTEN_END_NATURAL, 2}, {BATTEN_END_NOT_A_KNOT, 4}};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.end.kind = rows[i].kind; /* at x = 2 the second derivative does not vanish */
        double coarse[3], fine[3];
        errors_of_sine(128, &options, coarse);
        errors_of_sine(256, &options, fine);
        CHECK_NEAR(log2(coarse[0] / fine[0]), rows[i].order, 0.15);
    }
}

/* Distance from the logarithmic spiral exp(0.4 t) (cos t, sin t), sampled with steps 1.3 and
 * 0.7 in turn. */
static double spiral_error(batten_parametrization kind, int spans)
{
    double *points = test_array(2 * (size_t)spans + 2, sizeof *points), worst = 0;
    for (int i = 0; i <= spans; i++) {
        const double t = 2 * (i + (i % 2 ? 0.3 : 0)) / spans, r = exp(0.4 * t);
        points[2 * i] = r * cos(t);
        points[2 * i + 1] = r * sin(t);
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = kind;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, spans + 1, points}, &options, NULL,
                                      &curve));
    const batten_interval domain = batten_curve_domain(curve);
    for (int i = 0; i <= 4000; i++) {
        double at[2];
        CHECK_OK(
            batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 4000, 0, at));
        const double t = atan2(at[1], at[0]);
        worst = fmax(worst, fabs(hypot(at[0], at[1]) / exp(0.4 * t) - 1));
    }
    batten_curve_unref(curve);
    return worst;
}

/* Measured in the notes: 3.98, 2.00 and 1.99. */
TEST(chord_parameters_are_of_order_four_centripetal_and_uniform_ones_of_order_two)
{
    static const struct {
        batten_parametrization kind;
        double order;
    } rows[] = {{BATTEN_CHORD, 4}, {BATTEN_CENTRIPETAL, 2}, {BATTEN_UNIFORM, 2}};
    for (int i = 0; i < COUNT(rows); i++)
        for (int spans = 64; spans <= 128; spans *= 2)
            CHECK_NEAR(
                log2(spiral_error(rows[i].kind, spans) / spiral_error(rows[i].kind, 2 * spans)),
                rows[i].order, 0.1);
}

TEST(a_periodic_sine_through_16_points_has_no_seam)
{
    const double pi = 3.14159265358979323846;
    double t[17], y[16], left[4], right[4];
    for (int i = 0; i <= 16; i++) {
        t[i] = 2 * pi * i / 16;
        if (i < 16)
            y[i] = sin(t[i]);
    }
    batten_curve_interpolate_options options = given(t);
    options.closed = true;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 16, y}, &options, NULL, &curve));
    const batten_interval domain = batten_curve_domain(curve);
    derivatives(curve, domain.b, BATTEN_FROM_LEFT, left);
    derivatives(curve, domain.a, BATTEN_FROM_RIGHT, right);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(left[k], right[k], 1e-13);
    CHECK_NEAR(right[1], 1, 2e-4); /* slopes are right to the fourth order */
    batten_curve_unref(curve);
}

/* ---- maps ---- */

/* How far the spline through images is from the image of the spline. */
static double map_error(batten_parametrization kind, const double *a, const double *points)
{
    double image[2 * N], t[N], u[N], worst = 0;
    for (int i = 0; i < N; i++) {
        t[i] = i + 0.2 * (i % 3);
        for (int k = 0; k < 2; k++)
            image[2 * i + k] =
                a[2 * k] * points[2 * i] + a[2 * k + 1] * points[2 * i + 1] + 3 * k - 1;
    }
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = kind;
    options.given = t;
    batten_curve *before = NULL, *after = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, N, points}, &options, u, &before));
    CHECK_OK(batten_curve_interpolate((batten_points){2, N, image}, &options, NULL, &after));
    const batten_interval from = batten_curve_domain(before), to = batten_curve_domain(after);
    for (int i = 0; i <= 200; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(before, from.a + (from.b - from.a) * i / 200, 0, p));
        CHECK_OK(batten_curve_evaluate(after, to.a + (to.b - to.a) * i / 200, 0, q));
        for (int k = 0; k < 2; k++)
            worst = fmax(worst, fabs(a[2 * k] * p[0] + a[2 * k + 1] * p[1] + 3 * k - 1 - q[k]));
    }
    batten_curve_unref(before);
    batten_curve_unref(after);
    return worst;
}

TEST(splines_go_along_with_affine_maps_or_only_with_similarities)
{
    static const struct {
        batten_parametrization kind;
        bool affine;
    } rows[] = {{BATTEN_UNIFORM, true},     {BATTEN_GIVEN, true},
                {BATTEN_FOLEY, true}, /* the metric of Nielson */
                {BATTEN_CHORD, false},      {BATTEN_CENTRIPETAL, false},
                {BATTEN_FOLEY_CHORD, false}};
    const double affine[] = {2, 1.5, -0.4, 0.7}, similar[] = {1.2, -1.6, 1.6, 1.2};
    test_random random = test_random_begin("maps");
    for (int c = 0; c < test_cases(20); c++) {
        double points[2 * N];
        for (int i = 0; i < 2 * N; i++)
            points[i] = test_random_in(&random, -1, 1) + (i % 2 ? 0 : i / 2);
        for (int i = 0; i < COUNT(rows); i++) {
            CHECK_NEAR(map_error(rows[i].kind, similar, points), 0, 1e-11);
            if (rows[i].affine)
                CHECK_NEAR(map_error(rows[i].kind, affine, points), 0, 1e-10);
            else
                CHECK(map_error(rows[i].kind, affine, points) > 1e-4);
        }
    }
}
