/* Rows of points as callers give them: what is refused before any work. */
#include "spline/data_check.h"

#include "spline/curve/curve.h"
#include "support/test.h"

#include <batten/arcs.h>
#include <batten/nearest.h>
#include <batten/standard.h>

static const double row[15] = {0, 0, 0, 1, 0, 1, 2, 1, 0, 3, 3, 1, 4, 0, 5};

TEST(methods_of_the_plane_refuse_points_of_space)
{
    batten_chain *chain = NULL;
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_chain_biarcs((batten_points){3, 5, row}, NULL, NULL, NULL, &chain),
                 BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the points have 3 coordinates, 2 are expected");
    CHECK_STATUS(batten_curve_conic_five((batten_points){3, 5, row}, &curve),
                 BATTEN_UNSUPPORTED);
    CHECK_STATUS(batten_curve_conic_five((batten_points){2, 4, row}, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("a conic takes 5 points, not 4");
    CHECK(!chain && !curve);
}

TEST(distances_are_measured_from_points_of_the_curves_own_dimension)
{
    batten_curve *line = NULL;
    batten_deviation found = {.max = -1};
    CHECK_OK(batten_curve_line(2, row, row + 6, &line));
    CHECK_STATUS(
        batten_curve_deviation(line, (batten_points){3, 5, row}, NULL, NULL, NULL, &found),
        BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the points have 3 coordinates, 2 are expected");
    CHECK_NEAR(found.max, -1, 0);
    CHECK_OK(
        batten_curve_deviation(line, (batten_points){2, 1, row}, NULL, NULL, NULL, &found));
    CHECK_NEAR(found.max, 0, 1e-15);
    batten_curve_unref(line);
}

TEST(the_first_bad_coordinate_is_named_and_limits_are_said)
{
    double points[6] = {0, 1, 2, 3, 4, 5};
    CHECK_OK(bat_points_check(2, 3, points, 3));
    CHECK_OK(bat_points_check(1, 6, points, 1));
    CHECK_OK(bat_points_check(3, 2, points, 2));
    CHECK_STATUS(bat_points_check(0, 3, points, 1), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_points_check(4, 3, points, 1), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("points have 4 coordinates, not 1 to 3");
    CHECK_STATUS(bat_points_check(2, 2, points, 3), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there are 2 points, and at least 3 are needed");
    CHECK_STATUS(bat_points_check(2, 1, points, 2), BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there is 1 point, and at least 2 are needed");
    CHECK_STATUS(bat_points_check(1, BAT_MAX_POINTS + 1, points, 2), BATTEN_TOO_LARGE);
    points[3] = -INFINITY;
    CHECK_STATUS(bat_points_check(2, 3, points, 2), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 2 is -inf");
    CHECK_STATUS(bat_points_check(3, 2, points, 2), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 1 of point 2 is -inf");
}

TEST(parameters_rise_and_are_finite)
{
    CHECK_OK(bat_parameters_check(3, (const double[]){-1, 0, 0x1p-1074}));
    CHECK_OK(bat_parameters_check(0, NULL));
    CHECK_STATUS(bat_parameters_check(3, (const double[]){0, 1, 1}), BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3 is 1, not above the one before, 1");
    CHECK_STATUS(bat_parameters_check(3, (const double[]){0, 1, NAN}), BATTEN_NOT_FINITE);
    CHECK_STATUS(bat_parameters_check(1, (const double[]){INFINITY}), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("parameter 1 is inf");
}
