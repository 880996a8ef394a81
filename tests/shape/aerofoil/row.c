/* The orders in which points of a section come. */
#include "shape/aerofoil/sections.h"

#include <string.h>

enum { ROOM = COUNT_OF_POINTS + 8 };
typedef struct {
    int count;
    double points[ROOM][2];
    batten_curve_aerofoil_report report;
    batten_curve *curve;
} trial;

static void begin_trial(trial *t)
{
    memset(t, 0, sizeof *t);
    t->count = COUNT_OF_POINTS;
    make_points(0.12, 0.02, t->points);
}

/* Closed by a linear wedge, as files with a sharp tail are. */
static void sharpen(trial *t)
{
    for (int i = 0; i < t->count; i++)
        t->points[i][1] -= (i < HALF   ? 1
                            : i > HALF ? -1
                                       : 0) *
                           0.12 * naca_half(1) * t->points[i][0];
}

static void reverse_points(trial *t, int count)
{
    for (int i = 0, k = count - 1; i < k; i++, k--)
        for (int c = 0; c < 2; c++) {
            const double kept = t->points[i][c];
            t->points[i][c] = t->points[k][c];
            t->points[k][c] = kept;
        }
}

/* The section must come out as that of the plain points. */
static void check_same(trial *t, bool is_sharp)
{
    trial plain;
    begin_trial(&plain);
    if (is_sharp)
        sharpen(&plain);
    CHECK_OK(
        batten_curve_aerofoil(points_of(plain.points, plain.count), NULL, NULL, &plain.curve));
    CHECK_OK(
        batten_curve_aerofoil(points_of(t->points, t->count), NULL, &t->report, &t->curve));
    for (int i = 0; i <= 100; i++) {
        double p[2], q[2];
        CHECK_OK(batten_curve_evaluate(plain.curve, i / 100.0, 0, p));
        CHECK_OK(batten_curve_evaluate(t->curve, i / 100.0, 0, q));
        CHECK_NEAR(p[0], q[0], 1e-9);
        CHECK_NEAR(p[1], q[1], 1e-9);
    }
    batten_curve_unref(plain.curve);
    batten_curve_unref(t->curve);
}

TEST(points_from_the_lower_side_on_are_reversed)
{
    trial t;
    begin_trial(&t);
    reverse_points(&t, t.count);
    check_same(&t, false);
    CHECK(t.report.reversed);
}

TEST(halves_from_the_nose_as_lednicer_has_them_are_joined)
{
    trial t;
    begin_trial(&t);
    reverse_points(&t, HALF + 1);
    /* The nose stands in both halves. */
    memmove(t.points + HALF + 2, t.points + HALF + 1, HALF * sizeof *t.points);
    memcpy(t.points[HALF + 1], t.points[0], sizeof *t.points);
    t.count++;
    check_same(&t, false);
    CHECK(t.report.halves);
    CHECK_INT(t.report.repeated, 1);
}

TEST(repeated_points_are_left_out_and_counted)
{
    trial t;
    begin_trial(&t);
    memmove(t.points + 13, t.points + 10, (size_t)(t.count - 10) * sizeof *t.points);
    for (int i = 0; i < 3; i++)
        memcpy(t.points[10 + i], t.points[9], sizeof *t.points);
    t.count += 3;
    check_same(&t, false);
    CHECK_INT(t.report.repeated, 3);
}

TEST(points_on_the_base_of_a_blunt_tail_are_left_out)
{
    trial t;
    begin_trial(&t);
    memmove(t.points + 1, t.points, (size_t)t.count * sizeof *t.points);
    t.count += 2;
    for (int c = 0; c < 2; c++)
        t.points[0][c] = t.points[t.count - 1][c] =
            (t.points[1][c] + t.points[t.count - 2][c]) / 2;
    check_same(&t, false);
    CHECK_INT(t.report.base, 2);
    begin_trial(&t);
    memcpy(t.points[t.count++], t.points[0], sizeof *t.points);
    check_same(&t, false);
    CHECK_INT(t.report.base, 1);
}

TEST(the_point_of_a_sharp_tail_may_stand_at_one_end_alone)
{
    trial t;
    begin_trial(&t);
    sharpen(&t);
    t.count--;
    check_same(&t, true);
    CHECK(t.report.closed);
    begin_trial(&t);
    sharpen(&t);
    t.count--;
    memmove(t.points, t.points + 1, (size_t)t.count * sizeof *t.points);
    t.points[t.count - 1][0] = 1;
    t.points[t.count - 1][1] = 0;
    check_same(&t, true);
    CHECK(t.report.closed);
}

TEST(points_that_do_not_begin_and_end_at_the_tail_are_refused_or_told)
{
    trial t;
    begin_trial(&t);
    CHECK_STATUS(
        batten_curve_aerofoil(points_of(t.points, HALF + 1), NULL, &t.report, &t.curve),
        BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("not both at the trailing edge");
    sharpen(&t);
    /* A ring that begins at its nose. */
    double ring[COUNT_OF_POINTS][2];
    for (int i = 0; i < COUNT_OF_POINTS; i++)
        memcpy(ring[i], t.points[(i + HALF) % (COUNT_OF_POINTS - 1)], sizeof ring[i]);
    CHECK_OK(
        batten_curve_aerofoil(points_of(ring, COUNT_OF_POINTS), NULL, &t.report, &t.curve));
    CHECK(t.report.round_tail);
    batten_curve_unref(t.curve);
}

TEST(too_few_points_and_points_of_another_dimension_are_refused)
{
    static const double few[][2] = {{1, 0}, {0.5, 0.1}, {0, 0}, {0, 0}, {1, 0}};
    static const double space[15];
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_aerofoil((batten_points){2, 5, few[0]}, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("5 different points, not 4");
    CHECK_STATUS(batten_curve_aerofoil((batten_points){2, 0, few[0]}, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(batten_curve_aerofoil((batten_points){3, 5, space}, NULL, NULL, &curve) != BATTEN_OK);
    CHECK_STATUS(batten_curve_aerofoil((batten_points){2, 5, space}, NULL, NULL, &curve),
                 BATTEN_TOO_FEW_POINTS);
}
