/* Splines within a tolerance of points: where their corners are, and what is refused. */
#include "support/test.h"
#include <batten/approximate.h>

/* One arm of `before` steps along x, then one of `after` steps that turns by `angle`. */
static int elbow(int before, int after, double angle, double step, double q[2 * 64])
{
    const int n = before + after + 1;
    for (int i = 0; i < n; i++) {
        const double along = fmin(i, before) * step, rest = fmax(0, i - before) * step;
        q[2 * i] = along + rest * cos(angle);
        q[2 * i + 1] = rest * sin(angle);
    }
    return n;
}

static int corners_of(int n, const double *q, double corner, double tolerance, bool closed)
{
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report = {.corners = -1};
    batten_curve *curve = NULL;
    double u[64];
    options.tolerance = tolerance;
    options.corner = corner;
    options.closed = closed;
    CHECK_OK(batten_curve_within((batten_points){2, n, q}, &options, u, &report, &curve));
    batten_curve_unref(curve);
    return report.corners;
}

TEST(a_corner_is_found_wherever_it_stands_in_an_open_row)
{
    for (int before = 1; before < 10; before++)
        for (int after = 1; after < 10; after++)
            for (int k = 0; k < 2;
                 k++) { /* steps longer, and much shorter, than 4 tolerances */
                double q[2 * 64];
                const int n = elbow(before, after, 0.9, k ? 1 : 0.003, q);
                CHECK_INT(corners_of(n, q, 0.8, 1e-3, false), 1);
                CHECK_INT(corners_of(n, q, 1, 1e-3, false), 0);
            }
}

TEST(turns_are_looked_at_over_four_times_the_tolerance)
{
    /* A staircase of steps of 1e-3 is straight within 1e-2, and has corners within 1e-5. */
    double q[2 * 64];
    for (int i = 0; i < 60; i++) {
        q[2 * i] = (i + 1) / 2 * 1e-3;
        q[2 * i + 1] = i / 2 * 1e-3;
    }
    CHECK_INT(corners_of(60, q, 1, 1e-2, false), 0);
    CHECK_INT(corners_of(60, q, 1, 1e-5, false), 58);
}

TEST(of_a_rounded_corner_the_sharpest_point_alone_is_one)
{
    /* Two turns of 0.5 and one of 0.6 between them, near together: all three count over four
     * tolerances, one is kept; a closed row has them at its seam, too. */
    double q[2 * 64], turned[2 * 64];
    double x = 0, y = 0, angle = 0;
    int n = 0;
    for (int i = 0; i < 40; i++) {
        q[2 * n] = x;
        q[2 * n + 1] = y;
        n++;
        angle += i == 19 || i == 21 ? 0.5 : i == 20 ? 0.6 : 0;
        x += 0.01 * cos(angle);
        y += 0.01 * sin(angle);
    }
    CHECK_INT(corners_of(n, q, 0.9, 0.005, false), 1);
    CHECK_INT(corners_of(n, q, 0.45, 0.0005, false), 3);
    /* A square whose row begins anywhere has four. */
    static const double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    for (int start = 0; start < 12; start++) {
        for (int i = 0; i < 40; i++) {
            const int at = (i + start) % 40;
            for (int k = 0; k < 2; k++)
                turned[2 * i + k] =
                    corners[at / 10][k] +
                    at % 10 / 10.0 * (corners[at / 10 + 1][k] - corners[at / 10][k]);
        }
        CHECK_INT(corners_of(40, turned, 0.7, 1e-3, true), 4);
        CHECK_INT(corners_of(40, turned, 0.7, 0.06, true), 4);
    }
}

TEST(named_corners_rise_and_are_points_of_the_row)
{
    double q[2 * 64];
    const int n = elbow(5, 5, 0.1, 1, q);
    static const int bad[][2] = {{-1, 3}, {3, 11}, {3, 3}, {4, 2}}, good[] = {0, 10};
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report;
    batten_curve *curve = NULL;
    double u[64];
    options.tolerance = 0.01;
    options.corner_count = 2;
    for (int i = 0; i < COUNT(bad); i++) {
        options.corners = bad[i];
        CHECK_STATUS(batten_curve_within((batten_points){2, n, q}, &options, u, NULL, &curve),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(i == 0 ? "corner 1 is point 0" : "corner 2 is point");
    }
    CHECK(!curve);
    options.corners = good; /* the ends of an open row, which are none */
    CHECK_OK(batten_curve_within((batten_points){2, n, q}, &options, u, &report, &curve));
    CHECK_INT(report.corners, 0);
    batten_curve_unref(curve);
}

TEST(a_closed_row_with_one_corner_begins_and_ends_at_it)
{
    /* A drop: a circle whose first point, or another, is pulled out. */
    for (int at = 0; at < 30; at += 7)
        for (int method = 0; method < 4; method++) {
            double q[60], u[31];
            for (int i = 0; i < 30; i++) {
                const double r = i == at ? 2 : 1;
                q[2 * i] = r * cos(i * 0.20943951023931953);
                q[2 * i + 1] = r * sin(i * 0.20943951023931953);
            }
            batten_curve_within_options options = batten_curve_within_defaults();
            batten_curve_within_report report;
            batten_curve *curve = NULL;
            options.tolerance = 0.01;
            options.method = (batten_within_method)method;
            options.closed = true;
            options.corner_count = 1;
            options.corners = &at;
            CHECK_OK(
                batten_curve_within((batten_points){2, 30, q}, &options, u, &report, &curve));
            CHECK_INT(report.corners, 1);
            CHECK(batten_curve_is_closed(curve, 1e-12) && !batten_curve_is_periodic(curve));
            double p[2];
            CHECK_OK(batten_curve_evaluate(curve, batten_curve_domain(curve).a, 0, p));
            CHECK_NEAR(hypot(p[0] - q[2 * at], p[1] - q[2 * at + 1]), 0, 1e-13);
            double worst = 0, squares = 0;
            for (int i = 0; i < 30; i++) {
                CHECK_OK(batten_curve_evaluate(curve, u[i], 0, p));
                const double off = hypot(p[0] - q[2 * i], p[1] - q[2 * i + 1]);
                worst = fmax(worst, off);
                squares += off * off;
                if (i == report.worst)
                    CHECK_NEAR(off, report.error, 1e-12);
            }
            CHECK_NEAR(worst, report.error, 1e-12);
            CHECK_NEAR(sqrt(squares / 30), report.rms, 1e-9);
            batten_curve_unref(curve);
        }
}

/* ---- jobs ---- */

typedef struct {
    int asked, stop_at, said;
    double last;
} watcher;

static bool stops(void *user)
{
    watcher *w = user;
    return ++w->asked == w->stop_at;
}

static void hears(void *user, double fraction, const char *what)
{
    watcher *w = user;
    CHECK(fraction >= w->last && fraction < 1);
    CHECK(*what);
    w->last = fraction;
    w->said++;
}

enum { WAVES = 6001 };

/* Waves with a corner where they begin to be twice as high. */
static batten_status fit_waves(batten_within_method method, watcher *watching, uint64_t limit)
{
    double(*q)[2] = test_array(WAVES, sizeof *q);
    batten_curve_within_options options = batten_curve_within_defaults();
    const batten_job job = {.size = sizeof job,
                            .thread_count = 1,
                            .work_limit = limit,
                            .is_cancelled = stops,
                            .progress = hears,
                            .user = watching};
    const int corner = WAVES / 2;
    batten_curve *curve = NULL;
    for (int i = 0; i < WAVES; i++) {
        q[i][0] = 1e-3 * i;
        q[i][1] = (i > corner ? 2 : 1) * sin(2e-3 * (i - corner));
    }
    options.tolerance = 1e-2;
    options.method = method;
    options.corners = &corner;
    options.corner_count = 1;
    options.job = &job;
    const batten_status status =
        batten_curve_within((batten_points){2, WAVES, q[0]}, &options, NULL, NULL, &curve);
    CHECK_INT(curve != NULL, status == BATTEN_OK);
    batten_curve_unref(curve);
    return status;
}

TEST(a_fit_says_how_far_it_is_and_ends_when_it_is_cancelled_or_too_long)
{
    static const batten_within_method methods[] = {BATTEN_WITHIN_FEWEST, BATTEN_WITHIN_INSERT,
                                                   BATTEN_WITHIN_REMOVE, BATTEN_WITHIN_BEZIER};
    for (int i = 0; i < (test_cases(10) < 10 ? 1 : COUNT(methods)); i++) {
        watcher whole = {0}, first = {.stop_at = 1}, last;
        CHECK_OK(fit_waves(methods[i], &whole, 0));
        CHECK(whole.said > 0 && whole.asked > 0);
        if (methods[i] != BATTEN_WITHIN_BEZIER) /* the second of two equal pieces */
            CHECK(whole.last > 0.5);
        CHECK_STATUS(fit_waves(methods[i], &first, 0), BATTEN_CANCELLED);
        CHECK_INT(first.asked, 1);
        last = (watcher){.stop_at = whole.asked};
        CHECK_STATUS(fit_waves(methods[i], &last, 0), BATTEN_CANCELLED);
        CHECK_STATUS(fit_waves(methods[i], &(watcher){0}, 1), BATTEN_INCOMPLETE);
    }
}
