#include "inspect/nearest/meetings.h"

#include "support/test.h"

#include <batten/interpolate.h>

/* A helix of the unit cylinder, or the line that goes through it. */
static batten_curve *through(int count, void (*at)(double s, double *p))
{
    double points[3 * 100];
    batten_curve *curve = NULL;
    for (int i = 0; i < count; i++)
        at(i / (count - 1.0), points + 3 * i);
    CHECK_OK(batten_curve_interpolate((batten_points){3, count, points}, NULL, NULL, &curve));
    return curve;
}

static void helix(double s, double *p)
{
    p[0] = cos(12 * s);
    p[1] = sin(12 * s);
    p[2] = s;
}

static void wave(double s, double *p)
{
    p[0] = 4 * s - 2;
    p[1] = sin(6 * s);
    p[2] = 0.3;
}

static void wave_below(double s, double *p)
{
    wave(s, p);
    p[2] -= 0.05;
}

static void line(double s, double *p)
{
    p[0] = 4 * s - 2;
    p[1] = 0;
    p[2] = 0.3;
}

static bat_meetings meet(batten_curve *a, batten_curve *b, double tolerance)
{
    bat_trace traces[2];
    bat_work work = {NULL, 0};
    bat_meetings m;
    CHECK_OK(bat_trace_make(a, &traces[0]));
    CHECK_OK(bat_trace_make(b, &traces[1]));
    CHECK_OK(bat_meetings_find(&traces[0], &traces[1], tolerance, &work, &m));
    bat_trace_free(&traces[1]);
    bat_trace_free(&traces[0]);
    return m;
}

/* Meetings with the plane y = 0 are those with the line: sin(6 s) = 0. */
TEST(all_crossings_of_a_wave_and_a_line_are_found)
{
    batten_curve *a = through(60, wave), *b = through(2, line);
    const bat_meetings m = meet(a, b, 1e-6);
    CHECK_INT(m.count, 2);
    CHECK(!m.more);
    for (int i = 0; i < m.count; i++) {
        CHECK(m.found[i].distance < 1e-15);
        CHECK_NEAR(m.found[i].point[0][0], -2 + 4 * (i * 2 * acos(0) / 6), 1e-4);
    }
    batten_curve_unref(b);
    batten_curve_unref(a);
}

/* Against all pairs of 2000 samples of either. */
TEST(the_nearest_places_of_curves_that_do_not_meet_are_found)
{
    batten_curve *a = through(80, helix), *b = through(60, wave_below);
    const bat_meetings m = meet(a, b, 1e-6);
    CHECK_INT(m.count, 0);
    double least = HUGE_VAL;
    double *points = test_array(2000 * 3, sizeof *points);
    const batten_interval da = batten_curve_domain(a), db = batten_curve_domain(b);
    for (int i = 0; i < 2000; i++)
        CHECK_OK(
            batten_curve_evaluate(b, db.a + (db.b - db.a) * (i / 2000.0), 0, points + 3 * i));
    for (int i = 0; i < 500; i++) {
        double p[3];
        CHECK_OK(batten_curve_evaluate(a, da.a + (da.b - da.a) * (i / 500.0), 0, p));
        for (int k = 0; k < 2000; k++)
            least = fmin(least, hypot(hypot(p[0] - points[3 * k], p[1] - points[3 * k + 1]),
                                      p[2] - points[3 * k + 2]));
    }
    CHECK(m.nearest.distance <= least && m.nearest.distance > least - 1e-3);
    batten_curve_unref(b);
    batten_curve_unref(a);
}

TEST(curves_that_run_along_each_other_are_said_to_meet_often_or_nowhere_apart)
{
    batten_curve *a = through(60, wave);
    const bat_meetings m = meet(a, a, 1e-3);
    CHECK(m.count > 0);
    CHECK(m.nearest.distance < 1e-15);
    batten_curve_unref(a);
}

TEST(curves_that_touch_end_to_end_meet_once)
{
    batten_curve *a = through(40, helix), *low = NULL, *high = NULL;
    const batten_interval d = batten_curve_domain(a);
    CHECK_OK(batten_curve_split(a, (d.a + d.b) / 2, &low, &high));
    const bat_meetings m = meet(low, high, 1e-6);
    CHECK_INT(m.count, 1);
    CHECK_NEAR(m.found[0].at[0], (d.a + d.b) / 2, 1e-12);
    batten_curve_unref(high);
    batten_curve_unref(low);
    batten_curve_unref(a);
}
