#include <batten/bent.h>

#include "support/faults.h"
#include "support/test.h"

static const double pi = 3.14159265358979323846;

static batten_chain *through(int count, const double *points,
                             const batten_chain_spiro_options *options, double *parameters,
                             batten_chain_spiro_report *report)
{
    batten_chain *chain = NULL;
    CHECK_OK(batten_chain_spiro((batten_points){2, count, points}, options, parameters, report,
                                &chain));
    return chain;
}

/* The curvature of span j and its first two derivatives, at s of its length from the start. */
static void curvature_of(const batten_chain *chain, int j, double part, double out[3])
{
    const batten_span *span = batten_chain_span(chain, j);
    const double *k = span->curvature, s = part * span->length;
    out[0] = k[0] + s * (k[1] + s * (k[2] / 2 + s * k[3] / 6));
    out[1] = k[1] + s * (k[2] + s * k[3] / 2);
    out[2] = k[2] + s * k[3];
}

static double direction_at(const batten_chain *chain, double u, batten_side side)
{
    double at[4];
    CHECK_OK(batten_chain_evaluate_side(chain, u, side, 1, at));
    return atan2(at[3], at[2]);
}

static void wave(int count, double *points)
{
    for (int i = 0; i < count; i++) {
        const double t = (double)i + 0.2 * sin(3.0 * i);
        points[2 * i] = t;
        points[2 * i + 1] = 0.5 * sin(0.9 * t) + 0.02 * t * t;
    }
}

static void check_passes(const batten_chain *chain, int count, const double *points,
                         const double *at, double tolerance)
{
    for (int i = 0; i < count; i++) {
        double p[2];
        CHECK_OK(batten_chain_evaluate(chain, at[i], 0, p));
        CHECK_NEAR(hypot(p[0] - points[2 * i], p[1] - points[2 * i + 1]), 0, tolerance);
    }
}

/* ---- oracles ---- */

/* The plane curve from (0, 0) along the x axis with curvature 0.3 + 0.8 s - 0.5 s^2 + 0.08 s^3.
 */
static void cubic_curvature(double s, double point[2], double *angle, double *curvature)
{
    const batten_span span = {
        .kind = BATTEN_SPAN_SPIRAL, .length = 5, .curvature = {0.3, 0.8, -1, 0.48}};
    batten_chain *whole = NULL;
    CHECK_OK(batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 0, &whole));
    CHECK_OK(batten_chain_evaluate(whole, s, 0, point));
    *angle = s * (0.3 + s * (0.4 + s * (-0.5 / 3 + s * 0.02)));
    *curvature = 0.3 + s * (0.8 + s * (-0.5 + s * 0.08));
    batten_chain_unref(whole);
}

TEST(points_of_a_curve_with_cubic_curvature_give_that_curve)
{
    static const double at[] = {0, 0.4, 1.1, 1.5, 2.6, 3.7, 4.3, 5};
    enum { N = COUNT(at) };
    double points[2 * N], angles[N], curvatures[N], found[N];
    for (int i = 0; i < N; i++)
        cubic_curvature(at[i], points + 2 * i, &angles[i], &curvatures[i]);
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.start = (batten_spiro_end){true, true, angles[0], curvatures[0]};
    options.end = (batten_spiro_end){true, true, angles[N - 1], curvatures[N - 1]};
    batten_chain *chain = through(N, points, &options, found, NULL);
    for (int i = 0; i < N; i++) {
        double k[3];
        CHECK_NEAR(found[i], at[i], 1e-11);
        curvature_of(chain, i < N - 1 ? i : i - 1, i == N - 1, k);
        CHECK_NEAR(k[0], curvatures[i], 1e-10);
        CHECK_NEAR(k[1], 0.8 + at[i] * (-1 + at[i] * 0.24), 1e-9);
        CHECK_NEAR(
            remainder(direction_at(chain, found[i], BATTEN_FROM_RIGHT) - angles[i], 2 * pi), 0,
            1e-11);
    }
    batten_chain_unref(chain);
}

TEST(with_small_angles_curvature_is_that_of_the_natural_quintic_spline)
{
    /* Four points at unit steps with the third difference D: y'''' of the spline of least y'''
     * is 20 / 11 D at the second, its negative at the third, and 0 at the ends. */
    const double e = 1e-5, points[] = {0, 0, 1, 0, 2, 0, 3, 6 * e};
    batten_chain *chain = through(4, points, NULL, NULL, NULL);
    for (int j = 0; j < 3; j++) {
        double k[3];
        curvature_of(chain, j, 0, k);
        CHECK_NEAR(k[2] / e, j == 0 ? 0 : (j == 1 ? 120 : -120) / 11.0, 1e-7);
    }
    batten_chain_unref(chain);
}

TEST(g2_points_of_a_circle_give_the_circle_of_spiro)
{
    const double at[] = {0, 0.3, 0.9, 1.1, 1.9, 2.4, 3.6, 5};
    enum { N = COUNT(at) };
    double points[2 * N], found[N];
    for (int i = 0; i < N; i++) {
        points[2 * i] = 5 + 2 * cos(at[i]);
        points[2 * i + 1] = 2 * sin(at[i]);
    }
    for (int closed = 0; closed < 2; closed++)
        for (int n = 3; n <= N; n++) {
            batten_chain_spiro_options options = batten_chain_spiro_defaults();
            options.closed = closed;
            batten_chain_spiro_report report;
            batten_chain *chain = through(n, points, &options, found, &report);
            for (int i = 0; i < n; i++)
                CHECK_NEAR(found[i], 2 * at[i], 1e-11);
            CHECK_NEAR(report.bending, batten_chain_domain(chain).b / 4, 1e-11);
            CHECK_NEAR(report.variation, 0, 1e-20);
            CHECK_NEAR(report.curvature, 0.5, 1e-12);
            CHECK(report.steps <= 1); /* the first angles are those of the circle */
            batten_chain_unref(chain);
        }
}

TEST(a_point_of_the_curve_added_as_a_smooth_point_changes_nothing)
{
    enum { N = 9 };
    double points[2 * N], more[2 * N + 2], at[N];
    wave(N, points);
    batten_chain_spiro_report report, again;
    batten_chain *chain = through(N, points, NULL, at, &report);
    for (int j = 0; j < N - 1; j++) {
        memcpy(more, points, (size_t)(2 * j + 2) * sizeof *more);
        memcpy(more + 2 * j + 4, points + 2 * j + 2, (size_t)(2 * (N - j - 1)) * sizeof *more);
        CHECK_OK(
            batten_chain_evaluate(chain, 0.3 * at[j] + 0.7 * at[j + 1], 0, more + 2 * j + 2));
        double found[N + 1];
        batten_chain_unref(through(N + 1, more, NULL, found, &again));
        CHECK_NEAR(found[N], at[N - 1], 1e-10);
        CHECK_NEAR(found[j + 1], 0.3 * at[j] + 0.7 * at[j + 1], 1e-10);
        CHECK_NEAR(again.variation / report.variation, 1, 1e-10);
    }
    batten_chain_unref(chain);
}

TEST(points_of_curvature_alone_give_euler_spirals)
{
    enum { N = 9 };
    double points[2 * N], angles[N], at[N];
    batten_spiro_kind kinds[N];
    for (int i = 0; i < N; i++)
        kinds[i] = BATTEN_SPIRO_CURVATURE;
    wave(N, points);
    for (int closed = 0; closed < 2; closed++) {
        batten_chain_nonlinear_options spirals = batten_chain_nonlinear_defaults();
        spirals.start = spirals.end = BATTEN_NONLINEAR_CIRCULAR;
        spirals.closed = closed;
        batten_chain *expected = NULL;
        CHECK_OK(batten_chain_nonlinear((batten_points){2, N, points}, &spirals, angles, NULL,
                                        NULL, &expected));
        batten_chain_unref(expected);
        batten_chain_spiro_options options = batten_chain_spiro_defaults();
        options.kinds = kinds;
        options.closed = closed;
        batten_chain *chain = through(N, points, &options, at, NULL);
        for (int i = 0; i < N; i++)
            CHECK_NEAR(
                remainder(direction_at(chain, at[i], BATTEN_FROM_LEFT) - angles[i], 2 * pi), 0,
                1e-11);
        for (int j = 0; j < N - 1; j++) {
            double k[3];
            curvature_of(chain, j, 0.6, k);
            CHECK_NEAR(k[2], 0, 1e-10);
        }
        batten_chain_unref(chain);
    }
}

/* ---- what points ask for ---- */

TEST(spiro_passes_the_points_and_continues_what_each_of_them_asks_for)
{
    enum { N = 14 };
    double points[2 * N], at[N], before[3], after[3];
    batten_spiro_kind kinds[N];
    for (int i = 0; i < N; i++) {
        const double a = 2 * pi * i / N + 0.1 * sin(2.0 * i), r = 3 + 0.3 * sin(3.0 * i);
        points[2 * i] = r * cos(a);
        points[2 * i + 1] = r * sin(a);
    }
    for (int i = 0; i < N; i++)
        kinds[i] = i % 4 == 2 ? BATTEN_SPIRO_CURVATURE : BATTEN_SPIRO_SMOOTH;
    kinds[5] = BATTEN_SPIRO_CORNER;
    for (int closed = 0; closed < 2; closed++) {
        const int n = closed ? N : N - 1;
        batten_chain_spiro_options options = batten_chain_spiro_defaults();
        options.kinds = kinds;
        options.closed = closed;
        batten_chain_spiro_report report;
        batten_chain *chain = through(n, points, &options, at, &report);
        CHECK(batten_chain_is_closed(chain) == closed);
        CHECK(report.error < 1e-11 && report.straight == 0);
        check_passes(chain, n, points, at, 1e-11);
        for (int i = !closed; i < n - !closed; i++) {
            const double u = closed && i == 0 ? batten_chain_domain(chain).b : at[i];
            const double turn = direction_at(chain, u, BATTEN_FROM_LEFT) -
                                direction_at(chain, at[i], BATTEN_FROM_RIGHT);
            curvature_of(chain, i ? i - 1 : n - 1, 1, before);
            curvature_of(chain, i, 0, after);
            if (kinds[i] == BATTEN_SPIRO_CORNER) {
                CHECK(fabs(turn) > 0.01);
                for (int k = 1; k < 3; k++) {
                    CHECK_NEAR(before[k], 0, 1e-10);
                    CHECK_NEAR(after[k], 0, 1e-10);
                }
                continue;
            }
            CHECK_NEAR(remainder(turn, 2 * pi), 0, 1e-11);
            CHECK_NEAR(before[0], after[0], 1e-10);
            const bool smooth = kinds[i] == BATTEN_SPIRO_SMOOTH;
            CHECK((fabs(before[1] - after[1]) < 1e-9) == smooth);
            CHECK_NEAR(before[2], smooth ? after[2] : 0, 1e-9);
        }
        batten_chain_unref(chain);
    }
}

TEST(a_corner_parts_two_splines)
{
    enum { N = 9 };
    double points[2 * N], at[N], left[N], right[N];
    batten_spiro_kind kinds[N] = {0};
    wave(N, points);
    kinds[4] = BATTEN_SPIRO_CORNER;
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.kinds = kinds;
    batten_chain_unref(through(N, points, &options, at, NULL));
    batten_chain_unref(through(5, points, NULL, left, NULL));
    batten_chain_unref(through(5, points + 8, NULL, right, NULL));
    for (int i = 0; i < 5; i++) {
        CHECK_NEAR(at[i], left[i], 1e-11);
        CHECK_NEAR(at[4 + i] - at[4], right[i], 1e-11);
    }
}

TEST(one_way_points_join_straight_lines_to_curves_which_do_not_bend_them)
{
    /* A line, a curve, and a line again. */
    const double points[] = {0, 0, 3, 0, 4.5, 0.5, 5, 2, 4, 3.2, 1, 4};
    const batten_spiro_kind kinds[] = {BATTEN_SPIRO_SMOOTH, BATTEN_SPIRO_LEFT,
                                       BATTEN_SPIRO_SMOOTH, BATTEN_SPIRO_SMOOTH,
                                       BATTEN_SPIRO_RIGHT,  BATTEN_SPIRO_SMOOTH};
    double at[6], k[3];
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.kinds = kinds;
    batten_chain_spiro_report report;
    batten_chain *chain = through(6, points, &options, at, &report);
    CHECK_INT(report.straight, 2);
    check_passes(chain, 6, points, at, 1e-11);
    for (int j = 0; j < 5; j += 4) {
        const batten_span *line = batten_chain_span(chain, j);
        CHECK(line->kind == BATTEN_SPAN_ARC && line->curvature[0] == 0);
    }
    CHECK_NEAR(direction_at(chain, at[1], BATTEN_FROM_RIGHT), 0, 1e-12);
    CHECK_NEAR(direction_at(chain, at[4], BATTEN_FROM_LEFT), atan2(0.8, -3), 1e-12);
    curvature_of(chain, 1, 0, k);
    CHECK_NEAR(k[0], 0, 1e-11);
    CHECK(fabs(k[1]) > 0.01);
    curvature_of(chain, 3, 1, k);
    CHECK_NEAR(k[0], 0, 1e-11);
    batten_chain_unref(chain);
}

TEST(one_way_points_join_what_is_no_line_as_well)
{
    /* Three points before a one-way point are an arc; the rest takes over its curvature. */
    const double points[] = {1, 0, 0.8, 0.6, 0, 1, -2, 1.5, -3, 1};
    const batten_spiro_kind kinds[] = {BATTEN_SPIRO_SMOOTH, BATTEN_SPIRO_SMOOTH,
                                       BATTEN_SPIRO_LEFT, BATTEN_SPIRO_SMOOTH,
                                       BATTEN_SPIRO_SMOOTH};
    double at[5], k[3];
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.kinds = kinds;
    batten_chain *chain = through(5, points, &options, at, NULL);
    CHECK_NEAR(at[2], pi / 2, 1e-11);
    CHECK_NEAR(fabs(direction_at(chain, at[2], BATTEN_FROM_RIGHT)), pi, 1e-11);
    curvature_of(chain, 2, 0, k);
    CHECK_NEAR(k[0], 1, 1e-11);
    batten_chain_unref(chain);
}

TEST(directions_and_curvatures_at_the_ends_of_spiro_are_those_given)
{
    enum { N = 7 };
    double points[2 * N], at[N], k[3];
    wave(N, points);
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.start = (batten_spiro_end){.has_tangent = true, .tangent = 1.1 + 4 * pi};
    options.end = (batten_spiro_end){.has_curvature = true, .curvature = -0.7};
    batten_chain *chain = through(N, points, &options, at, NULL);
    CHECK_NEAR(direction_at(chain, 0, BATTEN_FROM_RIGHT), 1.1, 1e-12);
    curvature_of(chain, 0, 0, k);
    CHECK_NEAR(k[1], 0, 1e-11);
    curvature_of(chain, N - 2, 1, k);
    CHECK_NEAR(k[0], -0.7, 1e-11);
    CHECK_NEAR(k[2], 0, 1e-11);
    batten_chain_unref(chain);
    /* Two points: curvature may then be the same all along, or linear. */
    options = batten_chain_spiro_defaults();
    options.start = (batten_spiro_end){.has_tangent = true, .tangent = 1};
    batten_chain_spiro_report report;
    const double pair[] = {0, 0, 2, 0};
    batten_chain_unref(through(2, pair, &options, at, &report));
    CHECK_NEAR(report.curvature, sin(1.0), 1e-12);
    CHECK_NEAR(at[1], 2 / sin(1.0), 1e-12);
    options.start = options.end = (batten_spiro_end){.has_curvature = true, .curvature = 0.4};
    options.end.curvature = 0.1;
    chain = through(2, pair, &options, at, &report);
    curvature_of(chain, 0, 0.5, k);
    CHECK_NEAR(k[0], 0.25, 1e-11);
    batten_chain_unref(chain);
}

/* ---- properties ---- */

TEST(g10_spiro_follows_every_change_that_keeps_shapes)
{
    enum { N = 9 };
    double points[2 * N], changed[2 * N], at[N], other[N];
    batten_spiro_kind kinds[N] = {0}, reversed[N] = {0};
    wave(N, points);
    kinds[3] = BATTEN_SPIRO_LEFT;
    kinds[6] = BATTEN_SPIRO_CURVATURE;
    reversed[N - 1 - 3] = BATTEN_SPIRO_RIGHT;
    reversed[N - 1 - 6] = BATTEN_SPIRO_CURVATURE;
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.kinds = kinds;
    batten_chain_unref(through(N, points, &options, at, NULL));
    for (int i = 0; i < 2 * N; i++)
        changed[i] = points[2 * (N - 1 - i / 2) + i % 2];
    options.kinds = reversed;
    batten_chain_unref(through(N, changed, &options, other, NULL));
    for (int i = 0; i < N; i++)
        CHECK_NEAR(other[i], at[N - 1] - at[N - 1 - i], 1e-10);
    for (int i = 0; i < N; i++) {
        changed[2 * i] = -1e3 * (cos(2.0) * points[2 * i] - sin(2.0) * points[2 * i + 1]) + 50;
        changed[2 * i + 1] =
            1e3 * (sin(2.0) * points[2 * i] + cos(2.0) * points[2 * i + 1]) - 7;
    }
    options.kinds = kinds;
    batten_chain_unref(through(N, changed, &options, other, NULL));
    for (int i = 0; i < N; i++)
        CHECK_NEAR(other[i] / 1e3, at[i], 1e-10);
}

TEST(n2_tiny_and_huge_points_have_their_spiro)
{
    for (double size = 1e-50; size < 1e60; size *= 1e50) {
        double points[10], at[5], first[5];
        wave(5, points);
        batten_chain_unref(through(5, points, NULL, first, NULL));
        for (int i = 0; i < 10; i++)
            points[i] *= size;
        batten_chain_unref(through(5, points, NULL, at, NULL));
        CHECK_NEAR(at[4] / size / first[4], 1, 1e-12);
    }
}

TEST(a_long_spiro_takes_no_more_steps_than_a_short_one)
{
    enum { N = 2000 };
    double points[2 * N];
    for (int i = 0; i < N; i++) {
        points[2 * i] = i + 0.2 * sin(3.0 * i);
        points[2 * i + 1] = 0.5 * sin(0.9 * i);
    }
    for (int closed = 0; closed < 2; closed++) {
        batten_chain_spiro_options options = batten_chain_spiro_defaults();
        batten_chain_spiro_report report;
        if (closed) {
            /* The same wave around a ring. */
            for (int i = 0; i < N; i++) {
                const double a = 2 * pi * i / N, r = 320 + 0.5 * sin(0.9 * i);
                points[2 * i] = r * cos(a);
                points[2 * i + 1] = r * sin(a);
            }
            options.closed = true;
        }
        batten_chain_unref(through(N, points, &options, NULL, &report));
        CHECK(report.steps < 20);
    }
}

/* ---- bad input ---- */

TEST(g2_two_points_and_points_of_a_line_give_the_line_of_spiro)
{
    const double pair[] = {1, 2, 4, 6}, row[] = {0, 0, 1, 2, 3, 6, 3.5, 7};
    double at[4], p[2];
    batten_chain_spiro_report report;
    batten_chain *chain = through(2, pair, NULL, at, &report);
    CHECK_NEAR(at[1], 5, 1e-15);
    CHECK_INT(report.straight, 1);
    batten_chain_unref(chain);
    chain = through(4, row, NULL, at, &report);
    CHECK_NEAR(report.bending, 0, 1e-28);
    for (int i = 0; i <= 20; i++) {
        CHECK_OK(batten_chain_evaluate(chain, at[3] * i / 20, 0, p));
        CHECK_NEAR(p[1], 2 * p[0], 1e-13);
    }
    batten_chain_unref(chain);
}

TEST(a_polygon_that_turns_back_has_a_spiro_only_with_a_corner_there)
{
    const double points[] = {0, 0, 2, 0, 1, 0, 1, 3};
    batten_spiro_kind kinds[4] = {0};
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 4, points}, NULL, NULL, NULL, &chain),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("turns back on itself at point 2");
    kinds[1] = BATTEN_SPIRO_CORNER;
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    options.kinds = kinds;
    batten_chain_spiro_report report;
    batten_chain_unref(through(4, points, &options, NULL, &report));
    CHECK_INT(report.straight, 1);
}

TEST(g1_g9_n1_points_without_a_spiro_are_named)
{
    const double same[] = {0, 0, 1, 1, 1, 1, 2, 0}, bad[] = {0, 0, 1, NAN, 2, 0};
    const double knot[] = {0, 0, 1, 0, 0.2, 0.3, 1.2, 0.3, 0.3, 0.6, 1, 2, -3, 0.5};
    batten_chain *chain = NULL;
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 4, same}, NULL, NULL, NULL, &chain),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3");
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 3, bad}, NULL, NULL, NULL, &chain),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 1, same}, NULL, NULL, NULL, &chain),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 7, knot}, NULL, NULL, NULL, &chain),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("span ");
    CHECK_MESSAGE("put a point between");
    batten_chain_spiro_options options = batten_chain_spiro_defaults();
    const batten_spiro_kind kinds[] = {0, 7, 0, 0};
    options.kinds = kinds;
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 4, knot}, &options, NULL, NULL, &chain),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("point 2 is of the unknown kind 7");
    options = batten_chain_spiro_defaults();
    options.end = (batten_spiro_end){.has_tangent = true, .tangent = INFINITY};
    CHECK_STATUS(batten_chain_spiro((batten_points){2, 2, knot}, &options, NULL, NULL, &chain),
                 BATTEN_NOT_FINITE);
    options = batten_chain_spiro_defaults();
    options.max_steps = 2;
    double points[18];
    wave(9, points);
    CHECK_STATUS(
        batten_chain_spiro((batten_points){2, 9, points}, &options, NULL, NULL, &chain),
        BATTEN_INCOMPLETE);
    CHECK_MESSAGE("after 2 steps");
    CHECK(!chain);
}

TEST(spiro_reports_every_lack_of_memory)
{
    enum { N = 5 };
    double points[2 * N], parameters[N + 1];
    static const batten_spiro_kind kinds[N] = {BATTEN_SPIRO_SMOOTH, BATTEN_SPIRO_CURVATURE,
                                               BATTEN_SPIRO_CORNER, BATTEN_SPIRO_CURVATURE,
                                               BATTEN_SPIRO_SMOOTH};
    wave(N, points);
    static const double ring[] = {0, 0, 2, -0.5, 3, 1, 1.5, 2.2, -0.5, 1.3};
    for (int k = 0; k < 3; k++) {
        batten_chain_spiro_options options = batten_chain_spiro_defaults();
        options.closed = k & 1;
        options.kinds = k & 2 ? kinds : NULL;
        batten_chain *chain = NULL;
        CHECK_EACH_ALLOCATION(
            batten_chain_spiro((batten_points){2, N, options.closed ? ring : points}, &options,
                               parameters, NULL, &chain));
        batten_chain_unref(chain);
    }
}
