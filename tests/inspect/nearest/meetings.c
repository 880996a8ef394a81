#include "inspect/nearest/meetings.h"

#include "support/test.h"

#include <batten/interpolate.h>
#include <batten/standard.h>

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

/* The segment from (0, 0, 0) to (4, 0, 0) and another, and where they are nearest, 0 to 1 on each. */
static const struct {
    double from[3], to[3];
    double distance, at[2];
} segments[] = {
    {{1, -1, 1}, {1, 3, 1}, 1, {0.25, 0.25}}, /* inside both */
    {{3, 2, -2}, {3, -6, -2}, 2, {0.75, 0.25}},
    {{5, -1, 0}, {5, 3, 0}, 1, {1, 0.25}}, /* an end of the first */
    {{-3, 3, 4}, {-3, -1, 4}, 5, {0, 0.75}},
    {{1, 2, 0}, {1, 5, 0}, 2, {0.25, 0}}, /* an end of the second */
    {{3, -7, 0}, {3, -3, 0}, 3, {0.75, 1}},
    {{7, 4, 0}, {7, 9, 0}, 5, {1, 0}},       /* ends of both */
    {{-9, 4, 0}, {-3, 4, 0}, 5, {0, 1}},     /* parallel, one after the other */
    {{2, -3, 0}, {2, 1, 0}, 0, {0.5, 0.75}}, /* that meet */
    {{4, 0, 0}, {4, 5, 0}, 0, {1, 0}},
};

TEST(segments_are_nearest_at_their_feet_or_ends)
{
    static const double origin[3] = {0, 0, 0}, end[3] = {4, 0, 0};
    for (int i = 0; i < COUNT(segments); i++)
        for (int swapped = 0; swapped < 2; swapped++) {
            batten_curve *pair[2] = {NULL, NULL};
            CHECK_OK(batten_curve_line(3, origin, end, &pair[swapped]));
            CHECK_OK(
                batten_curve_line(3, segments[i].from, segments[i].to, &pair[1 - swapped]));
            const bat_meetings m = meet(pair[0], pair[1], 1e-9);
            CHECK_INT(m.count, segments[i].distance == 0);
            CHECK(!m.more);
            CHECK_NEAR(m.nearest.distance, segments[i].distance, 1e-9);
            for (int k = 0; k < 2; k++) {
                const int own = swapped ? 1 - k : k;
                double p[3];
                CHECK_NEAR(m.nearest.at[own], segments[i].at[k], 1e-7);
                CHECK_OK(batten_curve_evaluate(pair[own], m.nearest.at[own], 0, p));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(m.nearest.point[own][c], p[c], 1e-15);
            }
            batten_curve_unref(pair[0]);
            batten_curve_unref(pair[1]);
        }
}

/* Up and down between -1 and 1 at x = 0, 1, 2 ... */
static batten_curve *zigzag(int count)
{
    double points[3 * 12] = {0};
    batten_curve *curve = NULL;
    for (int i = 0; i < count; i++) {
        points[3 * i] = i;
        points[3 * i + 1] = i % 2 ? 1 : -1;
    }
    CHECK_OK(batten_curve_polyline((batten_points){3, count, points}, &curve));
    return curve;
}

TEST(crossings_of_a_zigzag_come_in_order_until_there_are_too_many)
{
    static const double left[3] = {-1, 0, 0}, right[3] = {20, 0, 0};
    for (int count = 2; count <= 8; count++)
        for (int back = 0; back < 2; back++) {
            batten_curve *a = NULL, *b = zigzag(count);
            CHECK_OK(batten_curve_line(3, back ? right : left, back ? left : right, &a));
            const bat_meetings m = meet(a, b, 1e-9);
            const int crossings = count - 1;
            CHECK_INT(m.more, crossings > BAT_MEETINGS);
            if (!m.more)
                CHECK_INT(m.count, crossings);
            for (int i = 0; i < m.count; i++) {
                const double x = m.found[i].point[0][0];
                CHECK_NEAR(x - floor(x), 0.5, 1e-12);
                CHECK_NEAR(m.found[i].point[1][0], x, 1e-12);
                CHECK_NEAR(m.found[i].at[0], back ? (20 - x) / 21 : (x + 1) / 21, 1e-12);
                CHECK(i == 0 || m.found[i].at[0] > m.found[i - 1].at[0]);
            }
            batten_curve_unref(a);
            batten_curve_unref(b);
        }
}

/* A radius that ends on a circle where it closes: there it has two parameters. */
TEST(a_meeting_at_the_seam_of_a_closed_curve_is_found_at_both_of_its_ends)
{
    static const double middle[3] = {0, 0, 0}, seam[3] = {1, 0, 0};
    batten_curve *flat = NULL, *circle = NULL, *radius = NULL;
    CHECK_OK(batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &circle));
    CHECK_OK(batten_curve_line(3, middle, seam, &radius));
    const batten_interval around = batten_curve_domain(circle);
    CHECK_NEAR(around.b - around.a, 1, 0);
    const bat_meetings m = meet(circle, radius, 1e-9);
    CHECK_INT(m.count, 2);
    CHECK_NEAR(m.found[0].at[0], around.a, 1e-12);
    CHECK_NEAR(m.found[1].at[0], around.b, 1e-12);
    CHECK_NEAR(m.found[0].at[1], 1, 1e-12);
    batten_curve_unref(radius);
    batten_curve_unref(circle);
    batten_curve_unref(flat);
}

/* A line through two rungs of a ladder. */
TEST(places_are_one_only_when_the_points_of_both_curves_are_near)
{
    static const double up[] = {0, 0, -1, 0, 0, 1};
    static const double ladder[] = {-1, 0, 0, 1, 0, 0, 1, 0, 0.5, -1, 0, 0.5};
    batten_curve *spindle = NULL, *legs = NULL;
    CHECK_OK(batten_curve_line(3, up, up + 3, &spindle));
    CHECK_OK(batten_curve_polyline((batten_points){3, 4, ladder}, &legs));
    for (int swap = 0; swap < 2; swap++) {
        const bat_meetings m = swap ? meet(legs, spindle, 0.01) : meet(spindle, legs, 0.01);
        CHECK_INT(m.count, 2);
        for (int i = 0; i < 2; i++) {
            CHECK_NEAR(m.found[i].point[0][2], 0.5 * i, 1e-12);
            CHECK_NEAR(m.found[i].point[1][2], 0.5 * i, 1e-12);
        }
    }
    batten_curve_unref(legs);
    batten_curve_unref(spindle);
}

/* A hairpin around the z-axis whose ends are one place of it: two parameters of the hairpin, points a hair apart. */
TEST(two_places_of_one_curve_at_one_point_of_the_other_are_told_apart_by_their_parameters)
{
    static const double up[] = {0, 0, -1, 0, 0, 1};
    /* (0, 0, 0) at the parameters 0 and 3 of four. */
    static const double loop[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0};
    static const double knots[] = {0, 0, 1, 2, 3, 4, 4};
    batten_curve *line = NULL, *round = NULL;
    CHECK_OK(batten_curve_line(3, up, up + 3, &line));
    CHECK_OK(batten_curve_create((batten_points){3, 5, loop}, 1, NULL, knots, &round));
    const bat_meetings m = meet(round, line, 1e-6);
    CHECK_INT(m.count, 2);
    CHECK_NEAR(m.found[0].at[0], 0, 1e-12);
    CHECK_NEAR(m.found[1].at[0], 3, 1e-12);
    CHECK_NEAR(m.found[0].at[1], 0.5, 1e-12);
    CHECK_NEAR(m.found[1].at[1], 0.5, 1e-12);
    batten_curve_unref(round);
    batten_curve_unref(line);
}

/* The parabola y = a x^2 and the line y = -2: nearest at the apex, where the curve bends away from the line. */
TEST(a_curve_that_bends_away_is_nearest_at_its_apex)
{
    static const double bends[] = {0.25, 1, 4};
    for (int i = 0; i < 2 * COUNT(bends); i++) {
        const double a = bends[i / 2], from = -1, to = 1.5;
        /* Bernstein points of x and a x^2 over x = -1 .. 1.5 */
        const double parabola[9] = {
            from, a * from * from, 0.1, (from + to) / 2, a * from * to, 0.1,
            to,   a * to * to,     0.1};
        const double knots[] = {0, 0, 0, 1, 1, 1}, low[3] = {-3, -2, 0.1},
                     high[3] = {2, -2, 0.1};
        batten_curve *pair[2] = {NULL, NULL};
        CHECK_OK(
            batten_curve_create((batten_points){3, 3, parabola}, 2, NULL, knots, &pair[i % 2]));
        CHECK_OK(batten_curve_line(3, low, high, &pair[1 - i % 2]));
        const bat_meetings m = meet(pair[0], pair[1], 1e-9);
        CHECK_INT(m.count, 0);
        CHECK_NEAR(m.nearest.distance, 2, 1e-14);
        CHECK_NEAR(m.nearest.at[i % 2], 0.4, 2e-8);
        CHECK_NEAR(m.nearest.at[1 - i % 2], 0.6, 2e-8);
        CHECK_NEAR(m.nearest.point[i % 2][1], 0, 1e-14);
        batten_curve_unref(pair[0]);
        batten_curve_unref(pair[1]);
    }
}
