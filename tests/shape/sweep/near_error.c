/* How far interpolated sections are from a sweep, where it is known. */
#include "shape/sweep/near_error.h"

#include "support/test.h"

#include <batten/standard.h>
#include <float.h>

/* The section is lifted by v^3. */
static batten_status cubic_pose(const bat_motion *motion, double v, batten_side side,
                                bat_pose *out)
{
    (void)motion, (void)side;
    *out = (bat_pose){.share = {v, 1}};
    for (int c = 0; c < 3; c++)
        out->d[0][c][c] = 1;
    out->d[0][BAT_POSE_ORIGIN][2] = v * v * v;
    out->d[1][BAT_POSE_ORIGIN][2] = 3 * v * v;
    return BATTEN_OK;
}

enum { SPANS = 3, POINTS = 2, ROW = 3 * POINTS };
static double mesh[SPANS + 1] = {0, 0.25, 0.5, 1}, knots[SPANS + 3] = {0, 0, 0.25, 0.5, 1, 1};

/* What is off at the share t of a span, when its ends are met: the chord of a cubic. */
static double off_at(int span, double t)
{
    const double a = mesh[span], b = mesh[span + 1], v = (1 - t) * a + t * b;
    return fabs((1 - t) * a * a * a + t * b * b * b - v * v * v);
}

static double worst_of(int span, int places)
{
    double worst = 0;
    for (int i = 0; i < places; i++)
        worst = fmax(worst, off_at(span, (i + 0.5) / places));
    return worst;
}

TEST(spans_are_measured_evenly_and_the_worst_once_more)
{
    static const double a[3] = {0, 0, 0}, b[3] = {4, 1, 0};
    double rows[SPANS + 1][ROW], error[SPANS], true_row[ROW], made_row[ROW];
    bat_motion motion = {.pose = cubic_pose};
    bat_sweep sweep = {.motion = &motion, .part = {0, 1}};
    CHECK_OK(batten_curve_line(3, a, b, &sweep.section));
    for (int k = 0; k <= SPANS; k++) {
        const double z = mesh[k] * mesh[k] * mesh[k];
        memcpy(rows[k], (double[]){0, 0, z, 4, 1, z}, sizeof rows[k]);
    }
    bat_sweep_fitting f = {.sweep = &sweep,
                           .degree = 1,
                           .points = POINTS,
                           .width = 3,
                           .row = ROW,
                           .mesh_count = SPANS + 1,
                           .mesh = mesh,
                           .error = error,
                           .count = SPANS + 1,
                           .knots = knots,
                           .rows = rows[0],
                           .true_row = true_row,
                           .made_row = made_row,
                           .size = 4};
    for (int places = 1; places <= 5; places += 2) {
        CHECK_OK(bat_sweep_measure_spans(&f, places));
        for (int s = 0; s < SPANS; s++)
            CHECK_NEAR(error[s], worst_of(s, places), 1e-15);
        CHECK_NEAR(f.worst, worst_of(2, places), 1e-15);
    }
    CHECK_NEAR(bat_sweep_rounding(&f), 16 * DBL_EPSILON, 0);
    /* Of the last span more is found at 63 places than at 11; the others are not half as bad. */
    CHECK_OK(bat_sweep_measure_last(&f));
    const double coarse = worst_of(2, 11), fine = worst_of(2, 63);
    CHECK(fine > coarse && worst_of(1, 11) < 0.5 * coarse);
    for (int s = 0; s < 2; s++)
        CHECK_NEAR(error[s], worst_of(s, 11), 1e-15);
    CHECK_NEAR(error[2], 2 * fine - coarse, 1e-15);
    CHECK_NEAR(f.worst, 2 * fine - coarse + bat_sweep_rounding(&f), 1e-15);
    CHECK(f.worst > error[2]);
    /* One point that is off by 3 and 4 counts with all of its 5. */
    rows[1][3] += 3;
    rows[1][4] += 4;
    CHECK_OK(bat_sweep_measure_spans(&f, 1));
    CHECK_NEAR(error[0], hypot(2.5, off_at(0, 0.5)), 1e-14);
    CHECK_NEAR(error[2], off_at(2, 0.5), 1e-15);
    batten_curve_unref(sweep.section);
}
